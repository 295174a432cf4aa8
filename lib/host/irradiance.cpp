#include "host/irradiance.h"

#include "host/averages.h"

namespace lobelia::host {

Outcome<CoefficientsToMake> bind_coefficients(Gpu& gpu, const Irradiance& irradiance,
                                              const CubeMap& source) {
    auto scratch = gpu.create_buffer(Irradiance::scratch_size(source),
                                     VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Memory::device);
    if (!scratch) return scratch.error();
    auto buffer = gpu.create_buffer(
        Irradiance::COEFFICIENTS_SIZE,
        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, Memory::device);
    if (!buffer) return buffer.error();
    auto job = irradiance.bind(source, scratch->handle(), buffer->handle());
    if (!job) return core_failure(job.error());
    return CoefficientsToMake{std::move(*scratch), std::move(*buffer), std::move(*job)};
}

} // namespace lobelia::host
