/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The interface file: what is written comes back to the last bit, columns
    are known by name, and what is wrong is refused with file and line.
\*---------------------------------------------------------------------------*/

#include "particleInterface.H"
#include "counterRandom.H"

#include <gtest/gtest.h>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

using namespace impact;

namespace
{

typedef particleInterface::record record;

//- A file of its own for each test, removed afterwards
class temporaryFile
{
    std::string name_;

public:

    temporaryFile()
    {
        name_ = ::testing::TempDir() + "particleInterfaceXXXXXX";
        close(mkstemp(&name_[0]));
    }

    ~temporaryFile()
    {
        std::remove(name_.c_str());
    }

    const std::string& name() const
    {
        return name_;
    }

    const std::string& with(const std::string& text) const
    {
        std::ofstream(name_) << text;
        return name_;
    }
};


std::string complaint(const std::string& text)
{
    const temporaryFile file;
    try
    {
        particleInterface::read(file.with(text));
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_EQ(std::string(error.what()).find(file.name()), 0u);
        return error.what();
    }
    return "accepted";
}

const std::string head = "# particleInterface version 1\n";
const std::string names = "x,y,z,ux,uy,uz,T,diameter,weight\n";

} // End anonymous namespace


TEST(particleInterface, givesBackWhatWasWrittenToTheLastBit)
{
    counterRandom rnd(5);
    std::vector<record> records;
    for (int i = 0; i < 1000; ++i)
    {
        const double scale = std::exp(20*rnd.normal());
        records.push_back
        ({
            {rnd.normal()*scale, rnd.normal(), -0.1},
            {rnd.normal()*scale, 0, 1./3},
            rnd.uniform()*1e4, rnd.uniform()*scale, i ? rnd.uniform() : 0
        });
    }
    const temporaryFile file;
    std::ofstream(file.name())
        << particleInterface::text(records, "one line\nand another");
    const std::vector<record> back(particleInterface::read(file.name()));
    ASSERT_EQ(back.size(), records.size());
    for (std::size_t i = 0; i < back.size(); ++i)
    {
        for (int c = 0; c < 3; ++c)
        {
            ASSERT_EQ(back[i].position[c], records[i].position[c]);
            ASSERT_EQ(back[i].velocity[c], records[i].velocity[c]);
        }
        ASSERT_EQ(back[i].temperature, records[i].temperature);
        ASSERT_EQ(back[i].diameter, records[i].diameter);
        ASSERT_EQ(back[i].weight, records[i].weight);
    }
}


TEST(particleInterface, knowsColumnsByNameAndPassesOverOthers)
{
    const temporaryFile file;
    const std::vector<record> r
    (
        particleInterface::read
        (
            file.with
            (
                head + "# made by hand\n\n"
                "weight, diameter ,T,remark,uz,uy,ux,z,y,x\r\n"
                "# between\n"
                "9,8,7,none,6,5,4,3,2, 1\r\n"
            )
        )
    );
    ASSERT_EQ(r.size(), 1u);
    EXPECT_EQ(r[0].position.x, 1);
    EXPECT_EQ(r[0].position.z, 3);
    EXPECT_EQ(r[0].velocity.x, 4);
    EXPECT_EQ(r[0].velocity.z, 6);
    EXPECT_EQ(r[0].temperature, 7);
    EXPECT_EQ(r[0].diameter, 8);
    EXPECT_EQ(r[0].weight, 9);
    EXPECT_TRUE(particleInterface::read(file.with(head + names)).empty());
}


TEST(particleInterface, refusesWhatIsWrongWithFileAndLine)
{
    auto has = [](const std::string& text, const char* words)
    {
        return complaint(text).find(words) != std::string::npos;
    };
    EXPECT_TRUE(has("x,y,z\n", "does not begin with"));
    EXPECT_TRUE(has("# particleInterface version 2\n", "reads version 1"));
    EXPECT_TRUE(has(head, "no line of column names"));
    EXPECT_TRUE(has(head + "x,y,z,ux,uy,uz,T,diameter\n", "'weight'"));
    EXPECT_TRUE(has(head + "x,x,y,z,ux,uy,uz,T,diameter,weight\n", "'x'"));
    EXPECT_TRUE(has(head + names + "0,0,0,1,0,0,300,1e-5\n", "line 3"));
    EXPECT_TRUE(has(head + names + "0,0,0,1,0,0,300,1e-5,1,4\n", "more"));
    EXPECT_TRUE(has(head + names + "0,0,0,1,0,0,hot,1e-5,1\n", "column T"));
    EXPECT_TRUE(has(head + names + "0,0,0,1,0,,300,1e-5,1\n", "column uz"));
    EXPECT_TRUE(has(head + names + "0,0,0,1,0,0,0,1e-5,1\n", "T 0: valid"));
    EXPECT_TRUE(has(head + names + "0,0,0,1,0,0,9,-1,1\n", "diameter -1"));
    EXPECT_TRUE(has(head + names + "0,0,0,1,0,0,9,1,-2\n", "weight -2"));
    EXPECT_TRUE(has(head + names + "nan,0,0,1,0,0,9,1,2\n", "x nan"));
    EXPECT_THROW
    (
        particleInterface::read("/nowhere/at/all.csv"), std::invalid_argument
    );
    EXPECT_THROW
    (
        particleInterface::text({{{0, 0, 0}, {1, 0, 0}, -5, 1e-5, 1}}),
        std::invalid_argument
    );
}
