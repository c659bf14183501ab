/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "basicSpinningParcel.H"
#include "Cloud.H"

namespace Foam
{
    defineTemplateTypeNameAndDebug(basicSpinningParcel, 0);
    defineTemplateTypeNameAndDebug(Cloud<basicSpinningParcel>, 0);
}
