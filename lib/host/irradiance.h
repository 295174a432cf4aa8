#pragma once

#include <lobelia/host/work.h>
#include <lobelia/irradiance.h>

namespace lobelia::host {

/// The diffuse light's coefficients (lobelia/irradiance.h) that are ready to be made, in a uniform
/// buffer.
struct CoefficientsToMake {
    GpuBuffer scratch, buffer;
    IrradianceJob job;
};
Outcome<CoefficientsToMake> bind_coefficients(Gpu& gpu, const Irradiance& irradiance,
                                              const CubeMap& source);

} // namespace lobelia::host
