#pragma once

#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include <lobelia/host/work.h>

#include "picture.h"

namespace lobelia::cli {

/// What was run for one frame.
using FrameWork = std::vector<host::PassReport>;
/// How many of the passes make maps.
std::size_t prefilter_passes(const FrameWork& work);

/// The sphere's pipelines, compiled when first asked for, and the passes that they draw in.
class SpherePipelines {
public:
    static host::Outcome<SpherePipelines> create(host::Gpu& gpu);
    host::Outcome<const Sphere*> get(const SphereShading& shading);
    VkRenderPass whole() const { return whole_.get(); }
    VkRenderPass part() const { return part_.get(); } // the rest of the picture stays

private:
    using Key = std::tuple<SphereMethod, bool, bool, bool, MapFilter, bool, std::uint32_t>;
    SpherePipelines(host::Gpu& gpu, OwnedRenderPass whole, OwnedRenderPass part)
        : gpu_(&gpu), whole_(std::move(whole)), part_(std::move(part)) {}
    host::Gpu* gpu_;
    OwnedRenderPass whole_, part_;
    std::map<Key, Sphere> spheres_;
};

/// What a picture shows.
struct DrawingRequest {
    SphereShading shading;
    SphereSources sources;
    SphereView view;
    std::uint64_t version = 0; // of what the sources hold
};

/// A picture of the sphere, drawn again only when it would change.
class Drawing {
public:
    /// Draws where needed, adding the pass to `work`.
    host::Outcome<Done> draw(host::Gpu& gpu, SpherePipelines& pipelines,
                             const DrawingRequest& request, FrameWork& work);
    /// Draws anew next time whatever the request.
    void forget() { drawn_.reset(); }
    const Picture* picture() const { return picture_ ? &*picture_ : nullptr; }

private:
    std::optional<Picture> picture_;
    std::optional<SphereJob> job_;
    std::optional<DrawingRequest> drawn_; // what `picture_` shows and `job_` is bound for
};

} // namespace lobelia::cli
