/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    What README.md says can be selected in which cloud is what the tables of
    run-time selection hold, no less and no more.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCloud.H"
#include "basicKinematicCollidingCloud.H"
#include "basicKinematicMPPICCloud.H"
#include "basicReactingCloud.H"
#include "basicReactingMultiphaseCloud.H"
#include "basicSpinningCloud.H"
#include "basicSprayCloud.H"
#include "basicThermoCloud.H"

#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

template<class Model>
bool has(const word& name)
{
    const auto* table = Model::dictionaryConstructorTablePtr_;
    return table && table->found(name);
}


//- Can a model of any kind be selected in a cloud?
template<class CloudType>
bool selectable(const word& name)
{
    typedef typename CloudType::kinematicCloudType cloud;
    return
        has<ParticleForce<cloud>>(name)
     || has<InjectionModel<cloud>>(name)
     || has<PatchInteractionModel<cloud>>(name)
     || has<CloudFunctionObject<cloud>>(name);
}


const std::map<std::string, std::function<bool(const word&)>> clouds
{
    {"basicKinematic", selectable<basicKinematicCloud>},
    {"Colliding", selectable<basicKinematicCollidingCloud>},
    {"Thermo", selectable<basicThermoCloud>},
    {"Reacting", selectable<basicReactingCloud>},
    {"ReactingMultiphase", selectable<basicReactingMultiphaseCloud>},
    {"Spray", selectable<basicSprayCloud>},
    {"MPPIC", selectable<basicKinematicMPPICCloud>},
    {"spinning", selectable<basicSpinningCloud>}
};


//- The cells of a row of a table
std::vector<std::string> cells(const std::string& line)
{
    std::vector<std::string> result;
    std::istringstream row(line);
    std::string cell;
    std::getline(row, cell, '|');
    while (std::getline(row, cell, '|'))
    {
        cell = std::regex_replace(cell, std::regex("^ +| +$"), "");
        result.push_back(cell);
    }
    return result;
}

} // End anonymous namespace


TEST(registration, isWhatTheReadmeSays)
{
    const char* folder = std::getenv("PARCEL_IMPACT_DIR");
    ASSERT_NE(folder, nullptr);
    std::ifstream file(std::string(folder) + "/README.md");
    std::string line;
    while (std::getline(file, line) && line.rfind("| model |", 0) != 0)
    {}
    const std::vector<std::string> head = cells(line);
    ASSERT_EQ(head.size(), clouds.size() + 1);

    std::getline(file, line);
    int models = 0;
    const std::regex name("`([A-Za-z0-9]+)`");
    while (std::getline(file, line) && line.rfind("|", 0) == 0)
    {
        const std::vector<std::string> row = cells(line);
        ASSERT_EQ(row.size(), head.size()) << line;
        for
        (
            std::sregex_iterator m(row[0].begin(), row[0].end(), name), end;
            m != end;
            ++m
        )
        {
            ++models;
            for (std::size_t i = 1; i < row.size(); ++i)
            {
                ASSERT_EQ(clouds.count(head[i]), 1u) << head[i];
                EXPECT_EQ
                (
                    clouds.at(head[i])(word((*m)[1].str())),
                    row[i] == "yes"
                ) << (*m)[1].str() << " in " << head[i];
            }
        }
    }
    EXPECT_GE(models, 10);
}


TEST(registration, leavesTheStockModels)
{
    for (const auto& cloud : clouds)
    {
        EXPECT_TRUE(cloud.second("particleErosion")) << cloud.first;
        EXPECT_TRUE(cloud.second("rebound")) << cloud.first;
    }
}
