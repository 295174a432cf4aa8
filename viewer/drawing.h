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

/// The sphere's pipelines, compiled when first asked for.
class SpherePipelines {
public:
    /// `pass` is what pictures are drawn in.
    SpherePipelines(host::Gpu& gpu, VkRenderPass pass) : gpu_(&gpu), pass_(pass) {}
    host::Outcome<const Sphere*> get(const SphereShading& shading);

private:
    using Key = std::tuple<SphereMethod, bool, bool, bool, MapFilter, bool, std::uint32_t>;
    host::Gpu* gpu_;
    VkRenderPass pass_;
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
    host::Outcome<Done> draw(host::Gpu& gpu, SpherePipelines& pipelines, VkRenderPass pass,
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
