#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <lobelia/host/work.h>

#include "prefilter_maps.h"
#include "support/qualities.h"

namespace lobelia::test {

/// An environment by which methods are judged: the pointwise relative RMS of what they show against
/// what Exact finds in the panorama's own texels.
class Judged {
public:
    /// `references`: folder that keeps the sphere's references under `name`; empty: none.
    Judged(host::Gpu& gpu, std::string name, host::Image panorama, std::string references = {});

    const std::string& name() const { return name_; }
    std::uint32_t face(Quality quality) const;

    /// Of Prefilter's maps of `exponents`, and of Lambert's after them.
    std::vector<double> map_errors(Quality quality, std::span<const float> exponents);

    /// Of a sphere's pixels; without an exponent of a white diffuse one, else of a specular one.
    double sphere_error(SphereMethod method, Quality quality, std::optional<float> exponent);

private:
    host::Gpu& gpu_;
    std::string name_;
    host::Image panorama_;
    std::string references_;
    Exact exact_; // a CPU device compiles what it runs for each pipeline anew
    Prefilter prefilter_;
    MapReader reader_;
    std::vector<std::pair<Quality, host::GpuEnvironment>> uploads_;
    std::vector<std::pair<float, std::vector<double>>> map_truths_;
    std::vector<std::pair<float, std::vector<double>>> sphere_truths_;

    const host::GpuEnvironment& upload(Quality quality);
    const std::vector<double>& sphere_truth(std::optional<float> exponent);
    std::vector<double> sphere_colours(SphereMethod method, Quality quality,
                                       std::optional<float> exponent);
};

} // namespace lobelia::test
