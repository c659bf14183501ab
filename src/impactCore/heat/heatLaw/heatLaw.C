/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "heatLaw.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>

namespace
{

//- Beyond it squares would overflow, and nothing changes any more
constexpr double highestMach = 1e20;


//- What the laws share
template<class Law>
class lawOf
:
    public impact::heatLaw
{
public:

    void set(const coefficients& c) override
    {
        static_cast<Law&>(*this) = Law(c);
    }

    result operator()(double Re, double K) const override
    {
        const double M = std::min(K*Re, highestMach);
        return static_cast<const Law&>(*this).of(Re, K, M);
    }

    void operator()
    (
        int n,
        const double* Re,
        const double* K,
        result* results
    ) const override
    {
        for (int i = 0; i < n; ++i)
        {
            results[i] = (*this)(Re[i], K[i]);
        }
    }
};


//- Driven by the recovery temperature
class recovery
{
    double factor_;

public:

    explicit recovery(const impact::heatLaw::coefficients& c)
    :
        factor_
        (
            0.5*(c.gamma - 1)
           *(c.recoveryFactor < 0 ? std::sqrt(c.Pr) : c.recoveryFactor)
        )
    {}

    double operator()(double M) const
    {
        return 1 + factor_*M*M;
    }
};


class ranzMarshall
:
    public lawOf<ranzMarshall>
{
    recovery taw_;
    double forced_;

public:

    explicit ranzMarshall(const coefficients& c)
    :
        taw_(c),
        forced_(0.6*std::cbrt(c.Pr))
    {}

    result of(double Re, double, double M) const
    {
        return {2 + forced_*std::sqrt(Re), taw_(M)};
    }
};


class kavanau
:
    public lawOf<kavanau>
{
    recovery taw_;
    double forced_;
    double jump_;
    bool original_;

public:

    explicit kavanau(const coefficients& c)
    :
        taw_(c),
        forced_
        (
            c.form == "original"
          ? 0.459*std::pow(c.Pr, 0.33)
          : 0.6*std::cbrt(c.Pr)
        ),
        jump_(3.42/c.Pr),
        original_(c.form == "original")
    {}

    result of(double Re, double K, double M) const
    {
        const double Nu0 =
            2 + forced_*(original_ ? std::pow(Re, 0.55) : std::sqrt(Re));

        // Not 1 + jump Nu0 K, whose product may overflow
        return {1/(1/Nu0 + jump_*K), taw_(M)};
    }
};


class fox
:
    public lawOf<fox>
{
    recovery taw_;
    double forced_;

public:

    explicit fox(const coefficients& c)
    :
        taw_(c),
        forced_(0.459*std::pow(c.Pr, 0.33)/1.5)
    {}

    result of(double Re, double K, double M) const
    {
        return
        {
            2*std::exp(-M)/(1 + 17*K)
          + forced_*std::pow(Re, 0.55)*(1 + 0.5*std::exp(-17*K)),
            taw_(M)
        };
    }
};


class freeMolecular
:
    public lawOf<freeMolecular>
{
    double sqrtHalfGamma_;
    double factor_;
    double halfInternal_;

    //- Coefficients of (-s^2)^n in (2/sqrt(pi)) 1F1(-1/2; 3/2; -s^2) and
    //  (4/sqrt(pi)) 1F1(-3/2; 3/2; -s^2): the closed forms of c and c3 lose
    //  digits where s is small
    static constexpr int n = 18;
    double c_[n];
    double c3_[n];

public:

    explicit freeMolecular(const coefficients& c)
    :
        sqrtHalfGamma_(std::sqrt(0.5*c.gamma)),
        factor_
        (
            c.accommodation*c.Pr*(c.gamma + 1)/(8*c.gamma)/sqrtHalfGamma_
        ),
        halfInternal_(0.5*(5 - 3*c.gamma)/(c.gamma - 1))
    {
        c_[0] = 2/std::sqrt(M_PI);
        c3_[0] = 2*c_[0];
        for (int i = 1; i < n; ++i)
        {
            c_[i] = c_[i - 1]*(i - 1.5)/((i + 0.5)*i);
            c3_[i] = c3_[i - 1]*(i - 2.5)/((i + 0.5)*i);
        }
    }

    result of(double, double K, double M) const
    {
        const double s = sqrtHalfGamma_*M;
        const double s2 = s*s;
        double c, c3;
        if (s < 1)
        {
            c = c_[n - 1];
            c3 = c3_[n - 1];
            for (int i = n - 2; i >= 0; --i)
            {
                c = c_[i] - s2*c;
                c3 = c3_[i] - s2*c3;
            }
        }
        else
        {
            const double gauss = std::exp(-s2)/std::sqrt(M_PI);
            const double erf = std::erf(s);
            c = gauss + (s + 0.5/s)*erf;
            c3 = (s2 + 2.5)*gauss + (s2*s + 3*s + 0.75/s)*erf;
        }
        return
        {
            factor_*c/std::max(K, 1e-200),
            (c3/c + halfInternal_)/(2 + halfInternal_)
        };
    }
};


template<class Law>
std::unique_ptr<impact::heatLaw> make(const impact::heatLaw::coefficients& c)
{
    return std::make_unique<Law>(c);
}


struct kind
{
    const char* name;
    std::unique_ptr<impact::heatLaw> (*make)
    (
        const impact::heatLaw::coefficients&
    );
};

const kind kinds[] =
{
    {"ranzMarshall", make<ranzMarshall>},
    {"kavanau", make<kavanau>},
    {"fox", make<fox>},
    {"freeMolecular", make<freeMolecular>}
};


void check(const impact::heatLaw::coefficients& c)
{
    // 5/3 is not a double
    impact::checkRange("gamma", c.gamma, "(1, 1.6666666666666668]");
    impact::checkRange("Pr", c.Pr, "(0, 100]");
    impact::checkRange("accommodation", c.accommodation, "[0, 1]");
    if (!(c.recoveryFactor == -1))
    {
        impact::checkRange("recoveryFactor", c.recoveryFactor, "[0, 2]");
    }
    if (!c.form.empty())
    {
        const char* const forms[] = {"ranzMarshall", "original"};
        impact::named(forms, c.form, "form", c.form);
    }
}

} // End anonymous namespace


const std::vector<std::string>& impact::heatLaw::names()
{
    static const std::vector<std::string> all = []
    {
        std::vector<std::string> result;
        for (const kind& k : kinds)
        {
            result.push_back(k.name);
        }
        return result;
    }();
    return all;
}


std::unique_ptr<impact::heatLaw> impact::heatLaw::New
(
    const std::string& name,
    const coefficients& c
)
{
    check(c);
    return named(kinds, name, "heat law", name).make(c);
}
