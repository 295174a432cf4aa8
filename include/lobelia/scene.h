#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include <lobelia/prefilter.h>
#include <lobelia/result.h>
#include <lobelia/sphere.h>

namespace lobelia {

/// Materials that a scene shows: one, or all that lie between two exponents and up to these
/// reflectances, for values that vary from pixel to pixel or will be edited.
struct SceneMaterial {
    std::array<float, 3> diffuse{};  // the most that kd comes to; black: never seen
    std::array<float, 3> specular{}; // likewise ks
    float least_exponent = 1.0f;     // of n, in [0, 1e6]
    float most_exponent = 1.0f;
};

/// Whether an environment has suns beside its maps: light far above its mean, see Prefilter.
enum class Suns : std::uint32_t { unknown, none, some };

/// What is drawn in the light of one environment, as far as it decides what has to be computed.
struct Scene {
    std::span<const SceneMaterial> materials; // of surfaces in view; none: nothing is lit
    bool background = true;                   // the environment is seen itself
    /// As a mirror of this exponent would show it, in [0, 1e6]. Infinite: sharp.
    float background_exponent = std::numeric_limits<float>::infinity();
    SphereMethod method = SphereMethod::two_tap;
    Quality quality = Quality::normal;
    std::uint32_t samples = 64; // by SphereMethod::importance
    /// What the caller knows of the environment's texels. Unknown suns are found on the device.
    bool constant = false;
    Suns suns = Suns::unknown;
    std::uint32_t source_size = 0;     // edge of the cube map that maps are made from, as in
                                       // PrefilterRequest
    std::uint32_t background_size = 0; // of the one that is seen itself; 0: the same
    VkFormat mips_format = VK_FORMAT_R16G16B16A16_SFLOAT; // see Mips
    std::uint32_t width = 0, height = 0;                  // of the picture, pixels
    /// As in PrefilterRequest: for edits of exponents up to this one. 0: no edit will come.
    float levels_up_to = 0;
};

/// One pass of a plan. Bytes count each texel once a pass (its footprint).
struct ScenePass {
    const char* name = "";
    std::uint32_t dispatches = 1; // or draws
    std::uint64_t invocations = 0;
    std::uint64_t bytes_read = 0;
    std::uint64_t bytes_written = 0;
    double work = 0; // what its time is in proportion to, among passes of its name
};

/// An image to create, or a buffer, of which `format` is undefined and `bytes` the size.
struct SceneResource {
    const char* name = "";
    VkFormat format = VK_FORMAT_UNDEFINED;
    std::uint32_t width = 0, height = 0, layers = 0, levels = 0;
    std::uint64_t bytes = 0;
    VkFlags usage = 0; // VkImageUsageFlags or VkBufferUsageFlags
    bool kept = true;  // else scratch: free again when the commands have run
};

/// What a scene calls for, and nothing else. Depends on the scene alone.
class LOBELIA_API ScenePlan {
public:
    /// Refuses what PrefilterPlan refuses, exponents in the wrong order, several of them where the
    /// method reads no ladder, and methods that make no maps of their own.
    static Result<ScenePlan> make(const Scene& scene);

    /// Whether anything is drawn: else the picture is transparent black and there is no pass.
    bool draws() const noexcept;
    /// What the sphere pass is compiled for.
    const SphereShading& shading() const noexcept;
    /// The maps to make; null where no pixel sees one.
    const PrefilterPlan* prefilter() const noexcept;
    /// Whether the environment itself, being constant, is each of the maps.
    bool environment_is_its_maps() const noexcept;
    /// Whether ClippedTables' image is read.
    bool clipped_tables() const noexcept;
    /// Which of prefilter()'s maps PlainMap turns into the image "blurred background", with which
    /// any method draws as its background. Null where that is the environment.
    const PrefilteredMap* background_map() const noexcept;

    /// As expected_error.h says, the largest among what the materials show; infinite where nothing
    /// is promised.
    double expected_error() const noexcept;

    /// Edge of the last level that SphereMethod::kurt2019 reads of its mips, texels.
    static constexpr std::uint32_t KURT2019_FACE = 64;

    std::span<const ScenePass> passes() const noexcept; // in their order, the draw last
    std::span<const SceneResource> resources() const noexcept;

private:
    struct State;
    explicit ScenePlan(std::shared_ptr<const State> state) noexcept;
    std::shared_ptr<const State> state_;
};

/// What an edit of a scene asks for, beside the draw. Edits of kd, ks, camera, rotation and
/// exposure are the draw's alone as long as what is black stays black.
struct SceneEdit {
    enum class Maps {
        kept,        // those that are there serve
        from_levels, // PrefilterPlan::first_map_pass() and on
        anew,        // all passes
    };
    Maps maps = Maps::kept;
    bool shading = false; // another pipeline and other descriptors
};
/// From what was made for `before`, in the light of the same texels.
LOBELIA_API SceneEdit edit_between(const ScenePlan& before, const ScenePlan& after) noexcept;

} // namespace lobelia
