/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "identitySet.H"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace impact
{

std::uint64_t identitySet::key(std::int32_t processor, std::int64_t number)
{
    // Division that rounds down, also for negative numbers. 2^32 pages of
    // 4096 hold any number below 2^43.
    const std::int64_t pageNumber = number >> 12;
    return
        (std::uint64_t(std::uint32_t(processor)) << 32)
      ^ (std::uint64_t(pageNumber) & 0xffffffffULL);
}


identitySet::identitySet(const std::vector<std::uint64_t>& words)
{
    if (words.size() % (pageWords_ + 1) != 0)
    {
        throw std::invalid_argument
        (
            "identitySet: " + std::to_string(words.size())
          + " words are no set; valid are multiples of "
          + std::to_string(pageWords_ + 1)
        );
    }
    for (std::size_t i = 0; i < words.size(); i += pageWords_ + 1)
    {
        page& p = pages_[words[i]];
        std::copy_n(&words[i + 1], pageWords_, p.begin());
        for (const std::uint64_t word : p)
        {
            size_ += __builtin_popcountll(word);
        }
    }
}


bool identitySet::insert(std::int32_t processor, std::int64_t number)
{
    // A new page is zero
    page& p = pages_[key(processor, number)];
    const std::size_t bit = number & (pageBits_ - 1);
    const std::uint64_t mask = std::uint64_t(1) << (bit % 64);
    std::uint64_t& word = p[bit/64];
    if (word & mask)
    {
        return false;
    }
    word |= mask;
    ++size_;
    return true;
}


bool identitySet::contains(std::int32_t processor, std::int64_t number) const
{
    const auto p = pages_.find(key(processor, number));
    if (p == pages_.end())
    {
        return false;
    }
    const std::size_t bit = number & (pageBits_ - 1);
    return p->second[bit/64] >> (bit % 64) & 1;
}


std::vector<std::uint64_t> identitySet::words() const
{
    std::vector<std::uint64_t> keys;
    keys.reserve(pages_.size());
    for (const auto& p : pages_)
    {
        keys.push_back(p.first);
    }
    std::sort(keys.begin(), keys.end());

    std::vector<std::uint64_t> all;
    all.reserve(keys.size()*(pageWords_ + 1));
    for (const std::uint64_t k : keys)
    {
        const page& p = pages_.at(k);
        all.push_back(k);
        all.insert(all.end(), p.begin(), p.end());
    }
    return all;
}

} // End namespace impact
