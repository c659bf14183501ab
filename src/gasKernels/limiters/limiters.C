/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorKernel.H"
#include "limiters.H"
#include <map>

namespace Foam
{
namespace
{

//- Keeps quotients of squares of differences finite where all of them vanish
constexpr double tiny = 1e-200;

// Each limiter sees a and b of equal sign, as magnitudes, and is zero where
// the signs differ

struct upwind
{
    static VECTOR_INLINE double psi(double, double)
    {
        return 0;
    }
};

struct Minmod
{
    static VECTOR_INLINE double psi(const double a, const double b)
    {
        return min(a, b);
    }
};

struct vanLeer
{
    static VECTOR_INLINE double psi(const double a, const double b)
    {
        return 2*a*b/(a + b + tiny);
    }
};

struct vanAlbada
{
    static VECTOR_INLINE double psi(const double a, const double b)
    {
        return a*b*(a + b)/(a*a + b*b + tiny);
    }
};

struct OSPRE
{
    static VECTOR_INLINE double psi(const double a, const double b)
    {
        return 1.5*a*b*(a + b)/(a*a + a*b + b*b + tiny);
    }
};

struct MUSCL
{
    static VECTOR_INLINE double psi(const double a, const double b)
    {
        return min(min(2*b, 0.5*(a + b)), 2*a);
    }
};

struct UMIST
{
    static VECTOR_INLINE double psi(const double a, const double b)
    {
        return min
        (
            min(2*b, 0.25*a + 0.75*b),
            min(0.75*a + 0.25*b, 2*a)
        );
    }
};

struct SuperBee
{
    static VECTOR_INLINE double psi(const double a, const double b)
    {
        return max(min(2*b, a), min(b, 2*a));
    }
};

struct limitedLinear
{
    static VECTOR_INLINE double psi(const double a, const double b)
    {
        return min(2*b, a);
    }
};

struct limitedCubic
{
    static VECTOR_INLINE double psi(const double a, const double b)
    {
        return min(min(2*b, (2*a + b)*(1.0/3)), 2*a);
    }
};


template<class Limiter>
VECTOR_INLINE double limited(const double a, const double b)
{
    const double magnitude = Limiter::psi(abs(a), abs(b));
    return a*b > 0 ? (a < 0 ? -magnitude : magnitude) : 0;
}


//- Goes over to the mean of a and b where both are small beside the square
//  root of e: a difference of no weight then neither switches the limiter on
//  and off nor, the limiters being kinked where a = b = 0, keeps a steady
//  state from being approached to round-off
template<class Limiter>
VECTOR_INLINE double smoothlyLimited
(
    const double a,
    const double b,
    const double e
)
{
    const double s = a*a + b*b;
    return (s*limited<Limiter>(a, b) + e*(a + b))/(s + 2*e);
}


template<>
VECTOR_INLINE double smoothlyLimited<upwind>(double, double, double)
{
    return 0;
}


template<class Limiter, bool Smooth>
VECTOR_INLINE double slope(const double a, const double b, const double e)
{
    return Smooth ? smoothlyLimited<Limiter>(a, b, e) : limited<Limiter>(a, b);
}


//- Pressure of the face, at share w of the way from a cell of pressure p, from
//  the differences a across the face and b on the other side of the cell; e is
//  in parts of it. Where the gas expands
//  the differences are those of the logarithm, which is nearer to a straight
//  line through a fan, but for their third powers: in parts of the mean of
//  their two values.
template<class Limiter, bool Smooth>
VECTOR_INLINE double pressureAtFace
(
    const double p,
    const double w,
    const double a,
    const double b,
    const double e,
    const double expands
)
{
    const double s = slope<Limiter, Smooth>
    (
        a/(p + 0.5*expands*a),
        b/(p - 0.5*expands*min(b, p)),
        e
    );
    const double h = 0.5*w*s;
    const double k = expands*min(h, 0.9);
    return p*(1 + 2*h - k)/(1 - k);
}


template<class Limiter, bool Smooth>
VECTOR_INLINE void reconstructPressure(faceBlock& block, const int n)
{
    for (int i = 0; i < n; i++)
    {
        const double a = block.far[0][i] - block.owner[0][i];
        const double w = block.weight[i];
        const double e = Smooth ? block.passed[0][i] : 0;
        const double x = block.expands[i];
        block.L[0][i] = pressureAtFace<Limiter, Smooth>
        (
            block.owner[0][i], w, a, block.slopeOwner[0][i] - a, e, x
        );
        block.R[0][i] = pressureAtFace<Limiter, Smooth>
        (
            block.far[0][i], 1 - w, -a, a - block.slopeFar[0][i], e, x
        );
    }
}


template<class Limiter, bool Smooth>
VECTOR_INLINE void reconstruct(faceBlock& block, const int n, const int k)
{
    for (int i = 0; i < n; i++)
    {
        const double a = block.far[k][i] - block.owner[k][i];
        const double w = block.weight[i];
        const double e = Smooth ? block.passed[k][i] : 0;
        block.L[k][i] =
            block.owner[k][i]
          + w*slope<Limiter, Smooth>(a, block.slopeOwner[k][i] - a, e);
        block.R[k][i] =
            block.far[k][i]
          - (1 - w)*slope<Limiter, Smooth>(a, block.slopeFar[k][i] - a, e);
    }
}


template<class Limiter>
VECTOR_INLINE void reconstruct
(
    faceBlock& block,
    const int n,
    const int first,
    const int end
)
{
    for (int k = first; k < end; k++)
    {
        if (k == 0)
        {
            block.smooth
          ? reconstructPressure<Limiter, true>(block, n)
          : reconstructPressure<Limiter, false>(block, n);
        }
        else
        {
            block.smooth
          ? reconstruct<Limiter, true>(block, n, k)
          : reconstruct<Limiter, false>(block, n, k);
        }
    }

    // Pressure and temperature of a face that would lose their sign take the
    // value of the cell
    for (int k = first; k < end && k < 2; k++)
    {
        for (int i = 0; i < n; i++)
        {
            block.L[k][i] =
                block.L[k][i] > 0 ? block.L[k][i] : block.owner[k][i];
            block.R[k][i] =
                block.R[k][i] > 0 ? block.R[k][i] : block.far[k][i];
        }
    }
}

} // End anonymous namespace

#define makeReconstruction(Limiter)                                            \
    VECTOR_KERNEL                                                              \
    void reconstruct##Limiter                                                  \
    (                                                                          \
        faceBlock& block,                                                      \
        const int n,                                                           \
        const int first,                                                       \
        const int end                                                          \
    )                                                                          \
    {                                                                          \
        reconstruct<Limiter>(block, n, first, end);                            \
    }

makeReconstruction(upwind)
makeReconstruction(Minmod)
makeReconstruction(vanLeer)
makeReconstruction(vanAlbada)
makeReconstruction(OSPRE)
makeReconstruction(MUSCL)
makeReconstruction(UMIST)
makeReconstruction(SuperBee)
makeReconstruction(limitedLinear)
makeReconstruction(limitedCubic)

#undef makeReconstruction

namespace
{

const std::map<std::string, reconstructionKernel>& table()
{
    static const std::map<std::string, reconstructionKernel> kernels
    {
        {"upwind", reconstructupwind},
        {"Minmod", reconstructMinmod},
        {"vanLeer", reconstructvanLeer},
        {"vanAlbada", reconstructvanAlbada},
        {"OSPRE", reconstructOSPRE},
        {"MUSCL", reconstructMUSCL},
        {"UMIST", reconstructUMIST},
        {"SuperBee", reconstructSuperBee},
        {"limitedLinear", reconstructlimitedLinear},
        {"limitedCubic", reconstructlimitedCubic}
    };
    return kernels;
}

} // End anonymous namespace
} // End namespace Foam


Foam::reconstructionKernel Foam::selectReconstruction
(
    const std::string& limiter
)
{
    const auto found = table().find(limiter);
    return found == table().end() ? nullptr : found->second;
}


std::vector<std::string> Foam::reconstructionNames()
{
    std::vector<std::string> names;
    for (const auto& kernel : table())
    {
        names.push_back(kernel.first);
    }
    return names;
}
