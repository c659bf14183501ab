/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our wall models and the cloud functions of impacts for the solid
    particles of a rarefied gas.
\*---------------------------------------------------------------------------*/

#include "solidCloud.H"
#include "ImpactRecords.H"
#include "SurfaceImpact.H"
#include "parcelWallModels.H"

makePatchInteractionModel(solidCloud);
makeParcelWallModels(solidCloud);
makeCloudFunctionObject(solidCloud);
makeCloudFunctionObjectType(ImpactRecords, solidCloud);
makeCloudFunctionObjectType(SurfaceImpact, solidCloud);
