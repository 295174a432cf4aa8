#pragma once

#include <lobelia/host/work.h>

namespace lobelia::host {

/// The diffuse light's coefficients (lobelia/irradiance.h), in a uniform buffer.
struct IrradianceCoefficients {
    GpuBuffer buffer;
    WorkReport report;
};
Outcome<IrradianceCoefficients> make_irradiance(Gpu& gpu, const GpuEnvironment& environment);

} // namespace lobelia::host
