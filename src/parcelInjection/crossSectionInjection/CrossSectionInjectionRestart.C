/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "exactText.H"
#include "StringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
Foam::string Foam::CrossSectionInjection<CloudType>::settings() const
{
    // Of six digits: rates and place of the patches may be rounded
    OStringStream text;
    text.precision(6);
    text<< this->U0() << this->SOI_ << ' ' << label(stream_.seed()) << ' '
        << quiet_ << ' ' << rate_ << ' ' << sequenceRate_;
    const point& origin = this->owner().mesh().bounds().min();
    const vector place((average(corners_) - origin)/meshLength());
    for (direction d = 0; d < 3; ++d)
    {
        text<< ' ' << label(std::round(1e4*place[d]));
    }
    if (plane_)
    {
        text<< " front " << front_;
    }
    if (prefill_)
    {
        text<< " box " << box_.min() << box_.max();
    }
    for (const auto& size : stream_.sizes())
    {
        text<< ' ' << size.d << ' ' << size.fraction << ' ' << size.weight;
    }
    return text.str();
}


template<class CloudType>
void Foam::CrossSectionInjection<CloudType>::resume()
{
    typedef typename IdentifiedInjection<CloudType>::sequence sequence;

    const auto stored = [this](const word& name, const scalar other)
    {
        string text;
        this->getModelProperty(name, text);
        return text.empty() ? other : exactNumber(text);
    };
    const scalar now = this->owner().db().time().value();
    auto past = this->resumed(settings(), filled_ || next_ > 0);
    if (past == sequence::changed && this->SOI_ >= now)
    {
        past = sequence::fresh;
    }

    until_ = past == sequence::fresh ? now : stored("until", now);
    if (past == sequence::fresh)
    {
        next_ = 0;
        filled_ = false;
        start_ = plane_ || prefill_ ? this->SOI_ : max(this->SOI_, now);
        begin_ = start_;
    }
    else
    {
        firstMember_ = this->template getModelProperty<label>("firstMember");
        start_ = stored("start", this->SOI_);
        begin_ = stored("begin", this->SOI_);
    }
    if (past == sequence::changed)
    {
        filled_ = true;
        firstMember_ = next_;
        begin_ = max(this->SOI_, until_);
        Info<< "    " << this->modelName() << ": entries are not those of the"
            << " run before, whose stream ends; this one begins at " << now
            << " s" << endl;
    }
    else if
    (
        past == sequence::continued
     && until_ > start_ + stored("duration", duration_)
    )
    {
        // It was over, and may last longer now
        firstMember_ = next_;
        begin_ = until_;
    }
    if (now > start_ + duration_)
    {
        Info<< "    " << this->modelName() << ": the stream is over since "
            << start_ + duration_ << " s" << endl;
    }
    this->setIdentities(past);
}


// * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * * //

template<class CloudType>
void Foam::CrossSectionInjection<CloudType>::store()
{
    // The last one placed has passed the check against the largest label
    this->template setModelProperty<label>("next", next_);
    this->template setModelProperty<label>("filled", filled_);
    this->template setModelProperty<label>("firstMember", firstMember_);
    for
    (
        const auto& time :
        {
            std::make_pair("start", start_), std::make_pair("begin", begin_),
            std::make_pair("until", until_),
            std::make_pair("duration", duration_)
        }
    )
    {
        this->template setModelProperty<string>
        (
            time.first, exactText(time.second)
        );
    }
}
