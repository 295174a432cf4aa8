#include "host/irradiance.h"

#include <lobelia/irradiance.h>

#include "host/averages.h"

namespace lobelia::host {

Outcome<IrradianceCoefficients> make_irradiance(Gpu& gpu, const GpuEnvironment& environment) {
    const CubeMap source = lend_cube(environment.cube);
    const auto scratch = gpu.create_buffer(Irradiance::scratch_size(source),
                                           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Memory::device);
    if (!scratch) return scratch.error();
    auto buffer = gpu.create_buffer(
        Irradiance::COEFFICIENTS_SIZE,
        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, Memory::device);
    if (!buffer) return buffer.error();
    const auto irradiance = Irradiance::create(gpu.device());
    if (!irradiance) return core_failure(irradiance.error());
    const auto job = irradiance->bind(source, scratch->handle(), buffer->handle());
    if (!job) return core_failure(job.error());

    PassReport run{.name = "irradiance",
                   .invocations = std::uint64_t(6) * source.size,
                   .bytes_read = image_bytes(environment.cube) + scratch->size(),
                   .bytes_written = scratch->size() + buffer->size()};
    const auto done = run_pass(gpu, run, [&](VkCommandBuffer commands) { job->record(commands); });
    if (!done) return done.error();
    IrradianceCoefficients made{std::move(*buffer), {}};
    made.report.passes.push_back(run);
    return made;
}

} // namespace lobelia::host
