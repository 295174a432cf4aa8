#include <thread>

#include "bench.h"
#include "catalogue.h"

// G: the device and the host.
namespace lobelia::hard {
namespace {

void bounded_dispatches(Bench& bench, Findings& found) {
    // What a step may visit is settled by its setting, and no step is larger.
    const host::GpuImage image =
        test::on_device(bench.gpu(), image_of(oracle::random_panorama(Scene::noise, 64, 32, 91)));
    const std::vector<ExactQuery> queries = test::unclipped(axes(64, 92));
    std::vector<Average> whole;
    std::uint32_t steps_before = 0;
    for (std::uint64_t nodes : {std::uint64_t(1) << 40, std::uint64_t(1) << 20,
                                std::uint64_t(1) << 17, std::uint64_t(1) << 14}) {
        found.at(std::to_string(nodes) + " nodes a step");
        const test::Asked asked = test::ask(bench.gpu(), bench.exact(), image,
                                            {.exponent = 1, .nodes_per_step = nodes}, queries);
        // A query of a broad lobe visits every texel at least once.
        const double least = 64.0 * 64 * 32 / double(nodes);
        found.holds(asked.steps >= least, "as many steps as the work asks for");
        found.holds(asked.steps >= steps_before, "less a step are more steps");
        steps_before = asked.steps;
        if (whole.empty()) whole = asked.averages;
        found.holds(asked.averages == whole, "the same bytes however it is split");
    }
}

void two_devices(Bench& bench, Findings& found) {
    const host::Image source = image_of(oracle::random_cube(Scene::suns, 16, 93));
    const Directions asked = axes(8, 94);
    const std::vector<Average> before = bench.exact(source, 16, asked);
    found.at("another device beside");
    {
        Bench other;
        found.holds(other.exact(source, 16, asked) == before, "gives the same bytes");
        found.holds(bench.exact(source, 16, asked) == before, "and does not disturb");
        found.holds(other.gpu().take_messages().empty(), "no validation message");
    }
    found.at("and gone again");
    found.holds(bench.exact(source, 16, asked) == before, "the first goes on");
}

void many_threads(Bench& bench, Findings& found) {
    const host::Image source = image_of(oracle::random_cube(Scene::noise, 16, 95));
    const host::Image expected = bench.cube(even_panorama(8, 4, 1, 2, 3), 8);
    found.at("3 threads, a device each");
    std::array<bool, 3> same{};
    std::vector<std::thread> threads;
    for (bool& ok : same)
        threads.emplace_back([&expected, &ok] {
            Bench own;
            ok = own.cube(even_panorama(8, 4, 1, 2, 3), 8).texels == expected.texels &&
                 own.gpu().take_messages().empty();
        });
    for (std::thread& thread : threads) thread.join();
    for (bool ok : same) found.holds(ok, "the bytes of one thread");
}

void orders_of_destruction(Bench& bench, Findings& found) {
    // Jobs go on when what made them is gone.
    host::Gpu& gpu = bench.gpu();
    const host::Image light = even_cube(16, 1, 2, 3);
    const host::GpuImage source = test::on_device(gpu, light);
    found.at("a job outlives its pass");
    const PrefilterPlan plan = test::plan_for({{4.8f}}, 16);
    const std::vector<host::GpuImage> images = test::images_for(gpu, plan);
    const std::vector<CubeMap> targets{test::cube_of(images[0])};
    const host::GpuBuffer scratch =
        test::storage(gpu, plan.scratch_size(), VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
    const host::GpuBuffer state =
        test::storage(gpu, plan.state_size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    auto pass = std::make_unique<Prefilter>(value_of(Prefilter::create(gpu.device())));
    auto plan_copy = std::make_unique<PrefilterPlan>(plan);
    const PrefilterJob job = value_of(
        pass->bind(*plan_copy, test::cube_of(source), targets, scratch.handle(), state.handle()));
    pass.reset();
    plan_copy.reset();
    value_of(
        gpu.submit([&](VkCommandBuffer commands) { job.record(commands, 0, plan.pass_count()); }));
    found.sound(value_of(gpu.download(images[0], VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL)).texels);
    found.at("a job that is never recorded");
    {
        const Prefilter other = value_of(Prefilter::create(gpu.device()));
        const PrefilterJob unused = value_of(
            other.bind(plan, test::cube_of(source), targets, scratch.handle(), state.handle()));
        found.holds(plan.pass_count() > 0, "goes away without a message");
    }
    found.at("a moved job");
    {
        const Prefilter other = value_of(Prefilter::create(gpu.device()));
        PrefilterJob first = value_of(
            other.bind(plan, test::cube_of(source), targets, scratch.handle(), state.handle()));
        PrefilterJob second = std::move(first);
        first = std::move(second);
        value_of(gpu.submit(
            [&](VkCommandBuffer commands) { first.record(commands, 0, plan.pass_count()); }));
        found.holds(gpu.take_messages().empty(), "is the job that it was");
    }
}

} // namespace

Kind devices() {
    return {
        "The device and the host",
        {
            {"G04", "no R32G32B32A32 storage images", "Vulkan has them everywhere", nullptr,
             nullptr, "the format's storage support is required of every Vulkan device"},
            {"G07", "work that would trip a device's watchdog",
             "steps of bounded work, the same bytes however split", bounded_dispatches},
            {"G09", "a queue that threads share", "the caller's queue is never used", nullptr,
             nullptr, "the core records and never submits; lobelia::host has a queue of its own"},
            {"G10", "two devices in one process", "the same bytes, neither disturbs the other",
             two_devices},
            {"G11", "threads with a device each", "the bytes of one thread", many_threads},
            {"G12", "passes, plans and jobs destroyed in any order, unused, moved",
             "jobs go on; no message", orders_of_destruction},
            {"G15", "pipeline caches from other drivers, truncated, flipped",
             "no cache is read from a file", nullptr, nullptr,
             "the library keeps none; a caller's VkPipelineCache is passed on as it is"},
            {"G17", "a device with no optional feature", "all passes work", nullptr,
             "EmbeddingTest.LightsASceneFromTheEnginesOwnObjects"},
        }};
}

} // namespace lobelia::hard
