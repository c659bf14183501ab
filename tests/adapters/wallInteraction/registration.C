/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The cloud functions can be selected in every stock cloud that README.md
    names.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCloud.H"
#include "basicKinematicCollidingCloud.H"
#include "basicKinematicMPPICCloud.H"
#include "basicReactingCloud.H"
#include "basicReactingMultiphaseCloud.H"
#include "basicThermoCloud.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

template<class CloudType>
class wallInteractionRegistration
:
    public ::testing::Test
{};

typedef ::testing::Types
<
    basicKinematicCloud,
    basicKinematicCollidingCloud,
    basicKinematicMPPICCloud,
    basicThermoCloud,
    basicReactingCloud,
    basicReactingMultiphaseCloud
> stockClouds;

TYPED_TEST_SUITE(wallInteractionRegistration, stockClouds);

} // End anonymous namespace


TYPED_TEST(wallInteractionRegistration, hasTheCloudFunctions)
{
    typedef typename TypeParam::kinematicCloudType kinematicCloudType;
    const auto* table =
        CloudFunctionObject<kinematicCloudType>::dictionaryConstructorTablePtr_;
    ASSERT_NE(table, nullptr);
    for
    (
        const char* name
      : {"dispersedPhase", "impactRecords", "surfaceImpact"}
    )
    {
        EXPECT_TRUE(table->found(name)) << name;
    }
    // Beside, not in place of the stock ones
    EXPECT_TRUE(table->found("particleErosion"));
}
