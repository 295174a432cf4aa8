#pragma once

#include <span>
#include <vector>

#include <lobelia/exact.h>
#include <lobelia/host/work.h>

namespace lobelia::host {

/// What Exact integrates: the panorama's own texels where there is a panorama, else the cube's.
struct ExactSource {
    bool is_panorama = false;
    Panorama panorama;
    CubeMap cube;
    std::uint64_t bytes = 0;
};
ExactSource exact_source(const GpuEnvironment& environment);

struct Averages {
    std::vector<float> texels; // R G B 1 of each query
    PassReport report;
};

/// Averages `source` at `queries` with Exact, one submission a step, so that none is long. The
/// number of queries in `settings` is not read.
Outcome<Averages> average(Gpu& gpu, const Exact& exact, const ExactSource& source,
                          ExactSettings settings, std::span<const ExactQuery> queries,
                          const Progress& progress);

/// What a report says of `count` averages over a source of that many bytes, and what their time is
/// in proportion to: the texels that the lobe reaches.
PassReport exact_pass(const std::string& name, std::uint64_t source_bytes, std::uint64_t count);
double exact_work(const PassReport& pass, float exponent);

/// The part of `progress` from `from` to `to`.
Progress share(const Progress& progress, double from, double to);

/// Records and submits one pass, waits for it, and measures it.
Outcome<Done> run_pass(Gpu& gpu, PassReport& report,
                       const std::function<void(VkCommandBuffer)>& record);

/// CPU time that the process has used, on all its threads.
double process_milliseconds();

/// The failure of a call of the core library.
Failure core_failure(const Error& error);

ImageReport image_report(const std::string& name, const GpuImage& image, const char* lifetime);

const char* format_name(VkFormat format);

/// Texels and bytes of all levels and layers.
std::uint64_t image_texels(const GpuImage& image);
std::uint64_t image_bytes(const GpuImage& image);

/// An image as the core library takes cube maps.
CubeMap lend_cube(const GpuImage& image);

} // namespace lobelia::host
