#pragma once

#include <functional>
#include <string>
#include <vector>

#include <lobelia/host/work.h>

#include "host/colour_target.h"
#include "host/sphere_inputs.h"
#include "vk/full_screen_pass.h"

namespace lobelia::test {

struct SphereTiming {
    std::string name;
    double milliseconds; // median CPU time of the pass
    double ratio;        // to the first one's, the mirror's
};

/// Times the sphere pass at 512 x 512, background included: a mirror with one trilinear fetch,
/// kurt2019 with its colours known, and what is added. All are drawn in turn, so that the machine's
/// load falls on each alike.
class SphereTimer {
public:
    SphereTimer(host::Gpu& gpu, const host::GpuEnvironment& environment, const Material& material,
                Quality quality);

    void add(const std::string& name, SphereMethod method, std::uint32_t samples);
    /// The same compiled without suns, whether there are some or not.
    void add_without_suns(const std::string& name, SphereMethod method);
    std::vector<SphereTiming> run();
    std::uint32_t suns() const { return suns_; } // found in the environment

private:
    struct Drawing {
        std::string name;
        std::function<void(VkCommandBuffer)> record;
    };
    void add(const std::string& name, SphereMethod method, std::uint32_t samples, bool suns);
    void add_shader(const std::string& name, std::span<const std::uint32_t> spirv,
                    VkDescriptorType type, const vk::Resource& resource);

    host::Gpu& gpu_;
    const host::GpuEnvironment& environment_;
    SphereView view_;
    Quality quality_;
    host::ColourTarget target_;
    vk::Context context_;
    vk::Sampler sampler_;
    host::GpuBuffer colours_;
    std::vector<host::GpuImage> images_;
    std::vector<Drawing> drawings_;
    std::uint32_t suns_ = 0;
};

} // namespace lobelia::test
