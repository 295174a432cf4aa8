#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <lobelia/host/work.h>
#include <lobelia/irradiance.h>
#include <lobelia/mips.h>
#include <lobelia/prefilter.h>

namespace lobelia::cli {

/// The core library's passes, compiled once for a device.
struct LightPasses {
    Prefilter prefilter;
    Irradiance irradiance;
    Mips mips;
    host::GpuImage clipped_tables;

    static host::Outcome<LightPasses> create(host::Gpu& gpu);
};

/// What a method reads depends on, beside the environment.
struct LightRequest {
    SphereMethod method = SphereMethod::two_tap;
    Quality quality = Quality::normal;
    float exponent = 0.0f; // 0 where the method makes nothing for an exponent

    bool operator==(const LightRequest&) const = default;
};
LightRequest light_request(SphereMethod method, Quality quality, float exponent);

/// Everything that one method reads of one environment, made pass by pass.
class Light {
public:
    /// Makes images, buffers and descriptors; nothing runs yet. All arguments outlive this.
    /// `source` is the environment's cube map in a size that prefilters read (host::resized_cube).
    static host::Outcome<Light> create(host::Gpu& gpu, const LightPasses& passes,
                                       const host::GpuImage& source, const LightRequest& request);

    const LightRequest& request() const { return request_; }
    std::size_t passes_left() const { return passes_.size() - next_; }
    std::size_t pass_count() const { return passes_.size(); }

    /// Runs the next pass and waits for it.
    host::Outcome<host::PassReport> run_pass(host::Gpu& gpu);

    /// For the sphere pass once no pass is left; without background.
    const SphereSources& sources() const { return sources_; }
    MapFilter specular_filter() const { return specular_filter_; }
    bool has_suns() const;
    std::uint64_t bytes() const;

private:
    struct Pass {
        host::PassReport report;
        std::function<void(VkCommandBuffer)> record;
    };
    explicit Light(const LightRequest& request) : request_(request) {}
    host::Outcome<Done> prefilter(host::Gpu& gpu, const LightPasses& passes,
                                  const host::GpuImage& source, PrefilterRequest request);
    host::Outcome<Done> add_mips(host::Gpu& gpu, const LightPasses& passes,
                                 const host::GpuImage& source, std::uint32_t last_face,
                                 MipWeights weights, VkImageView SphereSources::*view);
    host::Outcome<Done> add_irradiance(host::Gpu& gpu, const LightPasses& passes,
                                       const host::GpuImage& source);
    void add_pass(const PrefilterPass& pass, std::function<void(VkCommandBuffer)> record);
    host::Outcome<const host::GpuImage*> keep(host::Outcome<host::GpuImage> image);
    host::Outcome<const host::GpuBuffer*> keep(host::Outcome<host::GpuBuffer> buffer);

    LightRequest request_;
    std::vector<std::unique_ptr<host::GpuImage>> images_;
    std::vector<std::unique_ptr<host::GpuBuffer>> buffers_;
    const host::GpuBuffer* state_ = nullptr; // of the prefilter
    std::vector<Pass> passes_;
    std::size_t next_ = 0;
    SphereSources sources_;
    MapFilter specular_filter_ = MapFilter::bilinear;
};

} // namespace lobelia::cli
