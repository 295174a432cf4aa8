#include <lobelia/scene.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include <lobelia/clipped_tables.h>
#include <lobelia/expected_error.h>
#include <lobelia/irradiance.h>

#include "prefilter_tiers.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint64_t FLOAT_BYTES = 16, HALF_BYTES = 8; // of a texel
constexpr std::uint32_t FACES = 6;
constexpr const char* BLURRED_BACKGROUND = "blurred background"; // a pass, and its image
constexpr double BACKGROUND_TEXELS_PER_SIGMA =
    2.8; // as ladders of quality high, read bilinearly too
constexpr VkImageUsageFlags MAP_USAGE = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;

bool is_black(const std::array<float, 3>& colour) {
    return colour == std::array<float, 3>{};
}

std::optional<Taps> taps_of(SphereMethod method) {
    switch (method) {
    case SphereMethod::one_tap: return Taps::one;
    case SphereMethod::two_tap: return Taps::two;
    case SphereMethod::hybrid: return Taps::five;
    default: return std::nullopt;
    }
}

bool has_harmonics(SphereMethod method) {
    return method == SphereMethod::sh2 || method == SphereMethod::sh4;
}

/// Whether the method reads maps of the prefilter.
bool reads_maps(SphereMethod method) {
    return taps_of(method) || has_harmonics(method) || method == SphereMethod::split_sum;
}

std::string exponent_text(float exponent) {
    char text[32];
    return std::string(text, std::to_chars(text, text + sizeof text, exponent).ptr);
}

/// At each point the error of a sum of positive parts lies between those of the parts; their mean
/// squares may still add up, where one part errs on one half of the sphere and one on the other.
double expected_of(const SceneMaterial& material, const Scene& scene) {
    const double diffuse =
        is_black(material.diffuse)
            ? 0.0
            : expected_diffuse_error(scene.method, scene.quality, scene.source_size);
    const double specular =
        is_black(material.specular)
            ? 0.0
            : expected_specular_error(scene.method, scene.quality, material.least_exponent,
                                      material.most_exponent, scene.source_size);
    return std::hypot(diffuse, specular);
}

/// The exponents of materials that shine.
struct Exponents {
    std::vector<float> all; // different ones, of materials that do not vary
    bool vary = false;
    float least = 0, most = 0;
};

Exponents exponents_of(const Scene& scene) {
    Exponents found;
    for (const SceneMaterial& material : scene.materials) {
        if (is_black(material.specular)) continue;
        const bool first = found.all.empty();
        found.least =
            first ? material.least_exponent : std::min(found.least, material.least_exponent);
        found.most = first ? material.most_exponent : std::max(found.most, material.most_exponent);
        found.vary = found.vary || material.least_exponent < material.most_exponent;
        if (std::find(found.all.begin(), found.all.end(), material.least_exponent) ==
            found.all.end())
            found.all.push_back(material.least_exponent);
    }
    return found;
}

} // namespace

struct ScenePlan::State {
    Scene scene; // without its materials
    SphereShading shading;
    std::optional<PrefilterPlan> prefilter;
    bool environment_is_its_maps = false;
    double expected_error = 0;
    std::vector<ScenePass> passes;
    std::vector<SceneResource> resources;
    std::deque<std::string> names; // of resources
    std::uint64_t read = 0;        // bytes, by the draw
    std::optional<std::size_t> background_map;

    Result<Done> fill(const Scene& from);

private:
    /// Maps to ask the prefilter for.
    struct Wanted {
        std::vector<float> exponents;
        bool lambert = false;
        Ladder ladder{};

        bool any() const { return lambert || ladder.rungs || !exponents.empty(); }
        /// Of the map of that exponent, wanted from now on.
        std::size_t index_of(float exponent) {
            const auto found = std::find(exponents.begin(), exponents.end(), exponent);
            const std::size_t index = std::size_t(found - exponents.begin());
            if (found == exponents.end()) exponents.push_back(exponent);
            return index;
        }
    };
    Result<Done> plan_maps(const Exponents& shining, Wanted& wanted);
    void plan_other_maps();
    Result<Done> add_prefilter(const Wanted& wanted, std::size_t shown);
    void add_tables();
    void add_blurred_background();
    void add_mips(std::uint32_t last_face);
    void add_irradiance();
    void add_draw();
    /// A resource that stays, read by the draw.
    void keep(const SceneResource& resource) {
        resources.push_back(resource);
        read += resource.bytes;
    }
    std::uint64_t source_bytes(std::uint32_t size) const {
        return FACES * FLOAT_BYTES * size * size;
    }
};

Result<Done> ScenePlan::State::fill(const Scene& from) {
    scene = from;
    scene.materials = {};
    if (!scene.background_size) scene.background_size = scene.source_size;
    shading = {.method = scene.method,
               .diffuse = false,
               .specular = false,
               .background = scene.background,
               .samples = scene.samples};
    for (const SceneMaterial& material : from.materials) {
        if (!(material.least_exponent <= material.most_exponent))
            return Error{VK_ERROR_VALIDATION_FAILED_EXT,
                         "a material's least exponent is the least"};
        shading.diffuse = shading.diffuse || !is_black(material.diffuse);
        shading.specular = shading.specular || !is_black(material.specular);
        expected_error = std::max(expected_error, expected_of(material, scene));
    }
    const bool lit = shading.diffuse || shading.specular;
    environment_is_its_maps = lit && scene.constant && reads_maps(scene.method);
    if (environment_is_its_maps) expected_error = EXPECTED_EXACT_ERROR;
    Wanted wanted;
    if (!lit || environment_is_its_maps)
        shading.method = SphereMethod::plain_split_sum;
    else if (reads_maps(scene.method)) {
        if (const auto planned = plan_maps(exponents_of(from), wanted); !planned)
            return planned.error();
    } else
        plan_other_maps();
    const std::size_t shown_maps = wanted.exponents.size();
    const bool sharp = scene.background_exponent == std::numeric_limits<float>::infinity();
    if (scene.background && !scene.constant && !sharp)
        background_map = wanted.index_of(scene.background_exponent);
    if (wanted.any())
        if (const auto added = add_prefilter(wanted, shown_maps); !added) return added.error();
    if (wanted.ladder.rungs) add_tables();
    if (background_map)
        add_blurred_background();
    else if (scene.background || environment_is_its_maps)
        read += source_bytes(scene.background_size);
    if (lit || scene.background) add_draw();
    return Done{};
}

Result<Done> ScenePlan::State::plan_maps(const Exponents& shining, Wanted& wanted) {
    const auto taps = taps_of(scene.method);
    wanted.lambert = shading.diffuse && !has_harmonics(scene.method);
    if (shading.diffuse && has_harmonics(scene.method)) add_irradiance();
    if (taps && !shading.specular) shading.method = SphereMethod::split_sum; // no horizon to cut
    if (!shading.specular) return Done{};
    if (taps) {
        wanted.ladder = ladder_for(*taps, shining.least, shining.most);
        shading.suns = scene.suns != Suns::none;
        return Done{};
    }
    if (shining.vary)
        return Error{VK_ERROR_VALIDATION_FAILED_EXT,
                     "exponents that vary are for one_tap, two_tap and hybrid"};
    wanted.exponents = shining.all;
    return Done{};
}

/// Of the maps of exponents the draw reads the first `shown`.
Result<Done> ScenePlan::State::add_prefilter(const Wanted& wanted, std::size_t shown) {
    const PrefilterRequest request{.exponents = wanted.exponents,
                                   .lambert = wanted.lambert,
                                   .ladder = wanted.ladder,
                                   .quality = scene.quality,
                                   .levels_up_to = scene.levels_up_to,
                                   .source_size = scene.source_size};
    auto plan = PrefilterPlan::make(request);
    if (!plan) return plan.error();
    for (std::uint32_t i = 0; i < plan->pass_count(); ++i) {
        const PrefilterPass pass = plan->pass(i);
        passes.push_back(
            {pass.name, 1, pass.invocations, pass.bytes_read, pass.bytes_written, pass.work});
    }
    const auto texels = [](std::uint64_t size) { return FACES * size * size; };
    for (std::size_t i = 0; i < plan->maps().size(); ++i) {
        const PrefilteredMap& map = plan->maps()[i];
        names.push_back("map n=" + exponent_text(map.exponent));
        resources.push_back({names.back().c_str(), request.map_format, map.size, map.size, FACES, 1,
                             texels(map.size) * HALF_BYTES, MAP_USAGE});
        const bool is_background_alone = i == shown && background_map == i;
        if (!is_background_alone) read += resources.back().bytes;
    }
    if (shown > 0) shading.specular_filter = plan->maps().front().filter;
    if (const Ladder ladder = plan->ladder(); ladder.rungs) {
        names.push_back("ladder from n=" + exponent_text(ladder.lowest));
        keep({names.back().c_str(), request.map_format, plan->ladder_size(), plan->ladder_size(),
              FACES * ladder.rungs, 1, texels(plan->ladder_size()) * ladder.rungs * HALF_BYTES,
              MAP_USAGE});
    }
    VkBufferUsageFlags state_usage =
        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
    if (request.levels_up_to > 0) state_usage |= VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    keep({.name = "prefilter state", .bytes = plan->state_size(), .usage = state_usage});
    resources.push_back(
        {.name = "prefilter levels",
         .bytes = plan->scratch_size(),
         .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT,
         .kept = request.levels_up_to > 0});
    prefilter = std::move(*plan);
    return Done{};
}

void ScenePlan::State::add_tables() {
    constexpr std::uint64_t BYTES = ClippedTables::BUFFER_BYTES;
    passes.push_back({"clipped tables", 0, 0, BYTES, 2 * BYTES, double(BYTES)});
    keep({"clipped tables", ClippedTables::FORMAT, ClippedTables::WIDTH, ClippedTables::HEIGHT,
          ClippedTables::LAYERS, 1, BYTES,
          VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    resources.push_back(
        {.name = "clipped tables upload",
         .bytes = BYTES,
         .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
         .kept = false});
}

void ScenePlan::State::add_blurred_background() {
    const PrefilteredMap& map = prefilter->maps()[*background_map];
    const std::uint32_t size =
        in_steps(2 * BACKGROUND_TEXELS_PER_SIGMA * std::sqrt(double(map.exponent)), LEAST_MAP_SIZE,
                 scene.source_size);
    const std::uint64_t texels = std::uint64_t(FACES) * size * size;
    passes.push_back({BLURRED_BACKGROUND, 1, texels,
                      std::uint64_t(FACES) * map.size * map.size * HALF_BYTES, texels * FLOAT_BYTES,
                      double(texels)});
    keep({BLURRED_BACKGROUND, VK_FORMAT_R32G32B32A32_SFLOAT, size, size, FACES, 1,
          texels * FLOAT_BYTES, MAP_USAGE});
}

/// Of methods that read no map of the prefilter.
void ScenePlan::State::plan_other_maps() {
    const auto add_reference = [this](const char* name) {
        keep({.name = name,
              .bytes = FLOAT_BYTES * scene.width * scene.height,
              .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    };
    if (scene.method == SphereMethod::reference) {
        if (shading.diffuse) add_reference("diffuse reference");
        if (shading.specular) add_reference("specular reference");
    }
    if (scene.method == SphereMethod::kurt2019) add_mips(KURT2019_FACE);
    if (scene.method == SphereMethod::importance) add_mips(1);
}

void ScenePlan::State::add_mips(std::uint32_t last_face) {
    const std::uint32_t levels =
        std::uint32_t(std::bit_width(std::max(scene.source_size / last_face, 1u)));
    std::uint64_t texels = 0;
    for (std::uint32_t level = 0; level < levels; ++level) {
        const std::uint64_t size = scene.source_size >> level;
        texels += FACES * size * size;
    }
    const std::uint64_t bytes =
        texels * (scene.mips_format == VK_FORMAT_R32G32B32A32_SFLOAT ? FLOAT_BYTES : HALF_BYTES);
    passes.push_back(
        {"mips", levels, texels, source_bytes(scene.source_size) + bytes, bytes, double(texels)});
    keep({"mips", scene.mips_format, scene.source_size, scene.source_size, FACES, levels, bytes,
          MAP_USAGE});
}

void ScenePlan::State::add_irradiance() {
    const std::uint32_t size = scene.background_size;
    const CubeMap source{.size = size};
    const std::uint64_t scratch = Irradiance::scratch_size(source);
    const std::uint64_t kept = Irradiance::COEFFICIENTS_SIZE;
    passes.push_back({"irradiance", 3, std::uint64_t(FACES) * size, source_bytes(size) + scratch,
                      scratch + kept, double(size) * size});
    keep({.name = "irradiance",
          .bytes = kept,
          .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT});
    resources.push_back({.name = "irradiance sums",
                         .bytes = scratch,
                         .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                         .kept = false});
}

void ScenePlan::State::add_draw() {
    const std::uint64_t pixels = std::uint64_t(scene.width) * scene.height;
    passes.push_back({"sphere", 1, pixels, read, pixels * FLOAT_BYTES, double(pixels)});
    resources.push_back({"picture", VK_FORMAT_R32G32B32A32_SFLOAT, scene.width, scene.height, 1, 1,
                         pixels * FLOAT_BYTES, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT});
}

Result<ScenePlan> ScenePlan::make(const Scene& scene) {
    return vk::guarded<ScenePlan>([&]() -> Result<ScenePlan> {
        if (scene.method == SphereMethod::plain_split_sum)
            vk::refuse("plain_split_sum shows maps of its caller's");
        auto state = std::make_shared<State>();
        if (const auto filled = state->fill(scene); !filled) return filled.error();
        return ScenePlan(std::move(state));
    });
}

ScenePlan::ScenePlan(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}

bool ScenePlan::draws() const noexcept {
    return !state_->passes.empty();
}
const SphereShading& ScenePlan::shading() const noexcept {
    return state_->shading;
}
const PrefilterPlan* ScenePlan::prefilter() const noexcept {
    return state_->prefilter ? &*state_->prefilter : nullptr;
}
bool ScenePlan::environment_is_its_maps() const noexcept {
    return state_->environment_is_its_maps;
}
double ScenePlan::expected_error() const noexcept {
    return state_->expected_error;
}
bool ScenePlan::clipped_tables() const noexcept {
    return state_->prefilter && state_->prefilter->ladder().rungs > 0;
}
const PrefilteredMap* ScenePlan::background_map() const noexcept {
    return state_->background_map ? &state_->prefilter->maps()[*state_->background_map] : nullptr;
}
std::span<const ScenePass> ScenePlan::passes() const noexcept {
    return state_->passes;
}
std::span<const SceneResource> ScenePlan::resources() const noexcept {
    return state_->resources;
}

} // namespace lobelia
