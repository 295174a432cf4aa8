#include <lobelia/host/scene_maps.h>
#include <lobelia/plain_map.h>

#include "host/averages.h"
#include "host/guard.h"
#include "host/irradiance.h"
#include "host/maps.h"
#include "host/mips.h"
#include "host/scene_plan.h"

namespace lobelia::host {

struct MapPasses::State {
    Gpu& gpu;
    std::optional<Prefilter> prefilter{};
    std::optional<Irradiance> irradiance{};
    std::optional<Mips> mips{};
    std::optional<PlainMap> plain_map{};
    std::optional<ClippedTablesUpload> tables{};
    bool tables_are_there = false;
};

MapPasses::MapPasses(Gpu& gpu) : state_(new State{gpu}) {}
MapPasses::MapPasses(MapPasses&&) noexcept = default;
MapPasses& MapPasses::operator=(MapPasses&&) noexcept = default;
MapPasses::~MapPasses() = default;

struct SceneMaps::State {
    MapPasses::State& passes;
    ScenePlan plan;
    SphereSources sources{};
    std::optional<MapsJob> job{};          // until its levels are of no more use
    std::optional<PrefilteredMaps> maps{}; // from then on
    std::vector<GpuImage> images{};
    std::vector<GpuBuffer> buffers{};
    std::vector<PassReport> reports{}; // of the passes to run, each with what it records
    std::vector<std::function<void(VkCommandBuffer)>> records{};
    std::size_t next = 0;
    std::size_t level_passes = 0;             // once that many have run there are levels to share
    std::optional<std::size_t> tables_pass{}; // the one that makes the tables that all share

    Outcome<Done> bind(const GpuEnvironment& environment, const State* before);
    Outcome<PassReport> run_next();
    const PrefilteredMaps* prefiltered() const {
        return maps ? &*maps : job ? &job->maps : nullptr;
    }

private:
    Outcome<Done> bind_prefilter(const GpuImage& source, const State* before);
    Outcome<Done> bind_tables();
    Outcome<Done> bind_background();
    Outcome<Done> bind_irradiance(const GpuImage& cube);
    Outcome<Done> bind_mips(const GpuImage& source);
    void add(const PassReport& report, std::function<void(VkCommandBuffer)> record) {
        reports.push_back(report);
        records.push_back(std::move(record));
    }
};

namespace {

template <class Pass>
Outcome<const Pass*> compiled(Gpu& gpu, std::optional<Pass>& pass) {
    if (!pass) {
        auto made = Pass::create(gpu.device());
        if (!made) return core_failure(made.error());
        pass = std::move(*made);
    }
    return &*pass;
}

} // namespace

Outcome<Done> SceneMaps::State::bind(const GpuEnvironment& environment, const State* before) {
    sources.background = environment.cube.view();
    if (environment.constant) sources.diffuse = sources.specular = sources.background;
    if (find_pass(plan, "irradiance"))
        if (const auto bound = bind_irradiance(environment.cube); !bound) return bound;
    if (find_pass(plan, "mips"))
        if (const auto bound = bind_mips(environment.source()); !bound) return bound;
    if (plan.prefilter())
        if (const auto bound = bind_prefilter(environment.source(), before); !bound) return bound;
    if (plan.clipped_tables())
        if (const auto bound = bind_tables(); !bound) return bound;
    return plan.background_map() ? bind_background() : Done{};
}

Outcome<Done> SceneMaps::State::bind_prefilter(const GpuImage& source, const State* before) {
    const PrefilterPlan& wanted = *plan.prefilter();
    const auto prefilter = compiled(passes.gpu, passes.prefilter);
    if (!prefilter) return prefilter.error();
    const bool from_levels = before && before->job && before->next >= before->level_passes &&
                             wanted.shares_levels(before->job->plan);
    auto bound =
        bind_maps(passes.gpu, **prefilter, source, wanted, from_levels ? &*before->job : nullptr);
    if (!bound) return bound.error();
    job = std::move(*bound);

    const std::vector<GpuImage>& made = job->maps.images;
    sources.prefilter_state = job->maps.state.handle();
    if (!made.empty()) {
        sources.specular = made.front().view(); // as maps are ordered,
        sources.diffuse = made.back().view();   // where the method reads those
    }
    if (job->maps.ladder) sources.ladder = job->maps.ladder->view();
    const std::uint32_t first = from_levels ? wanted.first_map_pass() : 0;
    level_passes = records.size() + wanted.first_map_pass() - first;
    for (std::uint32_t i = first; i < wanted.pass_count(); ++i) {
        const PrefilterPass pass = wanted.pass(i);
        add({.name = pass.name,
             .invocations = pass.invocations,
             .bytes_read = pass.bytes_read,
             .bytes_written = pass.bytes_written},
            [this, i](VkCommandBuffer commands) { job->job.record(commands, i, 1); });
    }
    return Done{};
}

Outcome<Done> SceneMaps::State::bind_tables() {
    if (!passes.tables) {
        auto upload = ClippedTablesUpload::create(passes.gpu);
        if (!upload) return upload.error();
        passes.tables = std::move(*upload);
    }
    sources.clipped_tables = passes.tables->image.view();
    if (passes.tables_are_there) return Done{};
    tables_pass = records.size();
    add(report_of(*find_pass(plan, "clipped tables")),
        [this](VkCommandBuffer commands) { passes.tables->record(commands); });
    return Done{};
}

Outcome<Done> SceneMaps::State::bind_background() {
    const auto plain = compiled(passes.gpu, passes.plain_map);
    if (!plain) return plain.error();
    const ScenePass& pass = *find_pass(plan, "blurred background");
    const std::uint32_t size = find_resource(plan, pass.name)->width;
    auto image = passes.gpu.create_image({.width = size,
                                          .height = size,
                                          .layers = 6,
                                          .usage = find_resource(plan, pass.name)->usage,
                                          .cube = true});
    if (!image) return image.error();
    const PrefilteredMap* const map = plan.background_map();
    const std::size_t index = std::size_t(map - plan.prefilter()->maps().data());
    const auto bound = (*plain)->bind({.map = *map,
                                       .view = job->maps.images[index].view(),
                                       .state = job->maps.state.handle(),
                                       .target = lend_cube(*image)});
    if (!bound) return core_failure(bound.error());
    sources.background = image->view();
    images.push_back(std::move(*image));
    add(report_of(pass), [made = *bound](VkCommandBuffer commands) { made.record(commands); });
    return Done{};
}

Outcome<Done> SceneMaps::State::bind_irradiance(const GpuImage& cube) {
    const auto irradiance = compiled(passes.gpu, passes.irradiance);
    if (!irradiance) return irradiance.error();
    auto bound = bind_coefficients(passes.gpu, **irradiance, lend_cube(cube));
    if (!bound) return bound.error();
    sources.irradiance = bound->buffer.handle();
    add(report_of(*find_pass(plan, "irradiance")),
        [made = bound->job](VkCommandBuffer commands) { made.record(commands); });
    buffers.push_back(std::move(bound->scratch));
    buffers.push_back(std::move(bound->buffer));
    return Done{};
}

Outcome<Done> SceneMaps::State::bind_mips(const GpuImage& source) {
    const auto mips = compiled(passes.gpu, passes.mips);
    if (!mips) return mips.error();
    const bool kurt2019 = plan.shading().method == SphereMethod::kurt2019;
    auto bound =
        host::bind_mips(passes.gpu, **mips, source, kurt2019 ? ScenePlan::KURT2019_FACE : 1,
                        kurt2019 ? MipWeights::equal : MipWeights::solid_angle);
    if (!bound) return bound.error();
    (kurt2019 ? sources.blurred : sources.mips) = bound->image.view();
    add(report_of(*find_pass(plan, "mips")),
        [made = bound->job](VkCommandBuffer commands) { made.record(commands); });
    images.push_back(std::move(bound->image));
    return Done{};
}

Outcome<PassReport> SceneMaps::State::run_next() {
    PassReport report = reports[next];
    if (const auto done = host::run_pass(passes.gpu, report, records[next]); !done)
        return done.error();
    if (next == tables_pass) passes.tables_are_there = true;
    ++next;
    if (next == records.size() && job && !job->plan.shares_levels(job->plan)) {
        maps = std::move(job->maps); // without the levels
        job.reset();
    }
    return report;
}

Outcome<SceneMaps> SceneMaps::create(MapPasses& passes, const GpuEnvironment& environment,
                                     const ScenePlan& plan, const SceneMaps* before) {
    return guarded([&]() -> Outcome<SceneMaps> {
        auto state = std::make_unique<State>(State{passes.state(), plan});
        const auto bound = state->bind(environment, before ? before->state_.get() : nullptr);
        if (!bound) return bound.error();
        return SceneMaps(std::move(state));
    });
}

SceneMaps::SceneMaps(std::unique_ptr<State> state) : state_(std::move(state)) {}
SceneMaps::SceneMaps(SceneMaps&&) noexcept = default;
SceneMaps& SceneMaps::operator=(SceneMaps&&) noexcept = default;
SceneMaps::~SceneMaps() = default;

const ScenePlan& SceneMaps::plan() const {
    return state_->plan;
}
std::size_t SceneMaps::pass_count() const {
    return state_->records.size();
}
std::size_t SceneMaps::passes_left() const {
    return state_->records.size() - state_->next;
}
Outcome<PassReport> SceneMaps::run_pass() {
    return guarded([&] { return state_->run_next(); });
}
const SphereSources& SceneMaps::sources() const {
    return state_->sources;
}
SphereShading SceneMaps::shading(const ScenePlan& plan) const {
    SphereShading shading = plan.shading();
    if (plan.clipped_tables()) shading.suns = suns() > 0u;
    return shading;
}
std::optional<std::uint32_t> SceneMaps::suns() const {
    const PrefilteredMaps* const maps = state_->prefiltered();
    return maps ? std::optional(sun_count(*maps)) : std::nullopt;
}

} // namespace lobelia::host
