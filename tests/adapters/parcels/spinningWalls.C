/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Walls of the spin-carrying cloud: what is kept and released, what an
    adhesive wall does to spheres.
\*---------------------------------------------------------------------------*/

#include "spinningCloudTest.H"
#include "adhesiveRebound.H"
#include "wallCounters.H"
#include "wallImpacts.H"
#include "wallLayer.H"

TEST_F(spinningCloudTest, wallsKeepSpheresAndReleaseThem)
{
    open();
    for (const char* motion : {"", embedded})
    {
        // Fast, it rebounds and friction spins it up; slow, it stays
        for (const char* U0 : {"(10 3 0)", "(0.3 3 0)"})
        {
            SCOPED_TRACE(U0);
            const bool slow = U0[1] == '0';
            time_->setDeltaT(slow ? 4e-4 : 4e-5);
            const word name
            (
                word(*motion ? "embedded" : "stock")
              + (slow ? "Slow" : "Fast")
            );
            const auto cloud = make
            (
                motion + single("2e-5", U0, "(0.0999 0.02 0)")
              + "subModels{particleForces{} patchInteractionModel jkrAdhesion;"
                "jkrAdhesionCoeffs{patches (plate{contact{modulus 50e9;"
                "workOfAdhesion 0.1528;} alpha 1.1891; friction 0.3;"
                "layer{modulus 36.55648e9; workOfAdhesion 0.0607;}}"
                "sides{type escape;} inlet{type escape;});}}",
                name
            );
            const label plate = mesh_->boundaryMesh().findPatchID("plate");
            step(*cloud);
            const auto& c = wallCounters::New(*cloud).of(plate);
            ASSERT_EQ(c[wallCounters::hits], 1);
            EXPECT_EQ(c[wallCounters::capturedParcels], slow);
            EXPECT_EQ(cloud->size(), !slow);
            const wallLayer& layer =
                wallLayer::New(*cloud, mesh_(), {}, dictionary());
            scalar adhered = 0;
            for (std::size_t i = 0; i < layer.state().nFaces(); ++i)
            {
                adhered += layer.state().coverage(i);
            }
            EXPECT_EQ(adhered > 0, slow);
            if (!slow)
            {
                EXPECT_LT(cloud->first()->omega().z(), -1e4);
                EXPECT_EQ(cloud->first()->nImpacts(), 1);
            }
        }
    }
}

namespace
{

//- Keeps the impacts of a cloud while it lives
class impactTape
:
    public wallImpactListener
{
    wallImpacts& impacts_;

public:

    std::vector<wallImpact> heard;

    explicit impactTape(const cloud& c)
    :
        impacts_(wallImpacts::New(c))
    {
        impacts_.add(*this);
    }

    impactTape(const impactTape&) = delete;

    ~impactTape() override
    {
        impacts_.remove(*this);
    }

    void hear(const wallImpact& i) override
    {
        heard.push_back(i);
    }
};


//- Velocity and spin are those of the core; spin in terms of the rim's speed
void expectState
(
    const vector& U,
    const vector& omega,
    const impact::sphereState& s,
    const scalar radius,
    const scalar speed
)
{
    EXPECT_LT(impact::mag(toCore(U) - s.V), 1e-12*speed);
    EXPECT_LT(impact::mag(toCore(omega) - s.omega)*radius, 1e-12*speed);
}

} // End anonymous namespace


TEST_F(spinningCloudTest, theAdhesiveWallTurnsSpheresAsTheCoreSays)
{
    open();
    const scalar pi = constant::mathematical::pi;
    const scalar radius = 1e-5, rho = 2500;
    impact::adhesiveRebound law
    (
        {50e9, 0.1528},
        impact::lawCurve(impact::dissipationLaw::constant(1.1891)),
        0.3
    );
    law.setLayer({{36.55648e9, 0.0607}, 1.1891, 1.1891});
    const label plate = mesh_->boundaryMesh().findPatchID("plate");
    const scalar face =
        mag(mesh_->boundaryMesh()[plate].faceAreas()[0]);
    time_->setDeltaT(4e-5);

    label number = 0, sliding = 0, sticking = 0;
    for (const char* motion : {"", embedded})
    {
        for (const bool covered : {false, true})
        {
            for (const auto& start : {"(10 1 0)", "(10 25 0)", "(10 -3 0)"})
            {
                for (const char* spin : {"0", "2e6", "-5e5"})
                {
                    SCOPED_TRACE(word(start) + " spin " + spin);
                    const auto cloud = make
                    (
                        motion + single("2e-5", start, "(0.0999 0.021 0)")
                      + "constantProperties{omega0 (0 0 " + spin + ");}"
                      + "subModels{particleForces{} patchInteractionModel"
                        " jkrAdhesion; jkrAdhesionCoeffs{patches (plate"
                        "{contact{modulus 50e9; workOfAdhesion 0.1528;}"
                        " alpha 1.1891; friction 0.3; layer{modulus"
                        " 36.55648e9; workOfAdhesion 0.0607;}}"
                        "sides{type escape;} inlet{type escape;});}}",
                        "spheres" + Foam::name(number++)
                    );
                    wallLayer& layer =
                        wallLayer::New(*cloud, mesh_(), {}, dictionary());
                    if (covered)
                    {
                        const label n = mesh_->boundary()[plate].size();
                        for (label facei = 0; facei < n; ++facei)
                        {
                            layer.deposit
                            (
                                {
                                    plate, facei, 0, 0, facei, 0.5,
                                    2*face/(pi*sqr(radius))
                                },
                                2*radius,
                                pi/6*rho*pow3(2*radius)
                            );
                        }
                        ASSERT_TRUE(layer.settle().empty());
                    }
                    impactTape tape(*cloud);
                    step(*cloud);
                    ASSERT_EQ(tape.heard.size(), 1u);
                    const wallImpact& i = tape.heard[0];
                    ASSERT_EQ(i.n.z(), 0);

                    const impact::adhesiveRebound::sphere one =
                        {2*radius, rho};
                    impact::sphereState s =
                        {toCore(i.U0 - i.Uw), toCore(i.omega0)};
                    impact::sphereState s2;
                    const scalar speed = mag(i.U0) + mag(i.omega0)*radius;
                    const auto out =
                        covered
                      ? law.rebound(toCore(i.n), one, s, one, s2)
                      : law.rebound(toCore(i.n), one, s);
                    ASSERT_FALSE(out.captured);
                    ASSERT_EQ(out.detached, covered);
                    ++(out.slides ? sliding : sticking);
                    expectState(i.U1 - i.Uw, i.omega1, s, radius, speed);
                    EXPECT_GT(mag(i.omega1 - i.omega0)*radius, 1e-3*speed);

                    ASSERT_EQ(cloud->size(), 1 + covered);
                    for (const auto& p : *cloud)
                    {
                        // The other one has flown on through the gas
                        const bool freed =
                            p.origProc() == wallLayer::releasedProc;
                        EXPECT_EQ(p.nImpacts(), !freed);
                        if (freed)
                        {
                            expectState(p.U(), p.omega(), s2, radius, speed);
                        }
                    }
                    const auto& c = wallCounters::New(*cloud).of(plate);
                    EXPECT_EQ(c[wallCounters::hits], 1);
                }
            }
        }
    }
    EXPECT_GT(sliding, 4);
    EXPECT_GT(sticking, 4);
}
