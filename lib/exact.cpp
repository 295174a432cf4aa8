#include <lobelia/exact.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact_grid.h"
#include "vk/compute_pass.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t SPIRV[] = {
#include "exact.comp.inc"
};

constexpr VkDescriptorType BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // source
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         // queries
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         // results
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         // nodes
};

struct Params { // as in exact.comp
    float exponent;
    float scale;
    float row_cull;
    float block_cull;
    std::uint32_t columns;
    std::uint32_t rows;
    std::uint32_t repeat_columns;
    std::uint32_t repeat_rows;
    std::uint32_t parts;
    std::uint32_t first_row;
    std::uint32_t row_count;
    std::uint32_t first_query;
    std::uint32_t end_query;
    std::uint32_t last;
    float cell_width;
    float cell_height;
};

constexpr std::uint32_t TEAM = 64;           // local_size_x in exact.comp
constexpr std::uint32_t QUERIES = 4;         // of a workgroup
constexpr std::uint32_t MOST_GROUPS = 65535; // that every device dispatches
constexpr std::uint32_t ORDERS = 3;
constexpr float LARGEST_EXPONENT = 1e6f;
constexpr std::uint32_t LARGEST_SIDE = 32768;
constexpr double PI = std::numbers::pi;

// lavapipe ends an invocation's loops after 65535 iterations without a word.
constexpr std::uint32_t ITERATIONS_PER_INVOCATION = 60000;

/// How the queries and rows are cut into steps.
struct Schedule {
    std::uint32_t rows_per_step;
    std::uint32_t row_steps;
    std::uint32_t queries_per_step;
    std::uint32_t query_steps;
};

Schedule schedule(const ExactGrid& grid, const ExactSettings& settings) {
    const std::uint32_t all_rows = grid.rows * grid.layers;
    const std::uint32_t blocks = (grid.columns + TEAM - 1) / TEAM;
    const std::uint32_t divided =
        grid.order == 1 || settings.clipped ? QUERIES * grid.parts * grid.parts : 0;
    const std::uint32_t per_row =
        2 + blocks * (2 + grid.order + grid.order * grid.order + 4 * QUERIES + divided);
    Schedule cut;
    cut.rows_per_step = std::clamp(ITERATIONS_PER_INVOCATION / per_row, 1u, all_rows);
    cut.row_steps = (all_rows + cut.rows_per_step - 1) / cut.rows_per_step;

    const double share = (1 - std::cos(grid.reach)) / 2; // of the sphere that the lobe covers
    const double rows_in_reach = std::min(1.0, 2 * grid.reach / PI * 1.5) * cut.rows_per_step;
    const double cell_cost = grid.order == 1 ? 8.0 : grid.order * grid.order; // in nodes
    const double nodes = share * cut.rows_per_step * grid.columns * cell_cost +
                         rows_in_reach * grid.columns + double(TEAM) * cut.rows_per_step;
    const double queries = double(settings.nodes_per_step) / nodes;
    cut.queries_per_step =
        std::uint32_t(std::clamp(queries, double(QUERIES), double(MOST_GROUPS * QUERIES)));
    cut.queries_per_step -= cut.queries_per_step % QUERIES;
    cut.query_steps = (settings.query_count + cut.queries_per_step - 1) / cut.queries_per_step;
    return cut;
}

Exact::Sizes sizes_for(const ExactGrid& grid, const ExactSettings& settings) {
    return {VkDeviceSize(settings.query_count) * sizeof(ExactQuery),
            VkDeviceSize(settings.query_count) * 4 * sizeof(float),
            node_count(grid) * sizeof(ExactNode)};
}

const char* broken_rule(const ExactSettings& settings, std::uint32_t width, std::uint32_t height) {
    if (width < 1 || height < 1 || std::max(width, height) > LARGEST_SIDE)
        return "an environment's sides are 1 to 32768 texels";
    if (!(settings.exponent >= 0 && settings.exponent <= LARGEST_EXPONENT))
        return "an exponent is a number from 0 to 1e6";
    if (settings.query_count == 0) return "the list of directions is empty";
    if (settings.nodes_per_step == 0) return "a step of the exact integration visits some nodes";
    return nullptr;
}

} // namespace

struct Exact::State {
    vk::Context context;
    vk::Sampler sampler;
    vk::ComputePass passes[2][2][ORDERS]; // panorama, cube; whole or clipped; order - 1
};

struct ExactJob::State {
    std::shared_ptr<const Exact::State> shared;
    const vk::ComputePass* pass;
    vk::ImageView source;
    vk::DescriptorSets sets;
    VkBuffer tables;
    std::vector<ExactNode> nodes;
    Schedule cut;
    std::uint32_t query_count;
    std::uint32_t row_count; // of all layers
    Params params;           // but for those of a step

    void record_nodes(VkCommandBuffer commands) const noexcept;
    void record_step(VkCommandBuffer commands, std::uint32_t step) const noexcept;
};

Result<Exact> Exact::create(const Device& device) {
    return vk::guarded<Exact>([&] {
        auto state = std::make_shared<State>();
        state->context = vk::load(device);
        state->sampler = vk::make_sampler(state->context, VK_FILTER_NEAREST);
        for (std::uint32_t i = 0; i < 4 * ORDERS; ++i) {
            const std::uint32_t cube = i / ORDERS % 2;
            const std::uint32_t clipped = i / ORDERS / 2;
            const std::uint32_t order = i % ORDERS + 1;
            const std::uint32_t constants[] = {cube, order, clipped};
            state->passes[cube][clipped][order - 1] =
                vk::make_compute_pass(state->context, {.name = "lobelia exact",
                                                       .spirv = SPIRV,
                                                       .bindings = BINDINGS,
                                                       .push_constant_size = sizeof(Params),
                                                       .constants = constants});
        }
        return Exact(std::move(state));
    });
}

Result<Exact::Sizes> Exact::sizes(const Panorama& source, const ExactSettings& settings) noexcept {
    if (const char* rule = broken_rule(settings, source.width, source.height))
        return Error{VK_ERROR_VALIDATION_FAILED_EXT, rule};
    return sizes_for(panorama_grid(source.width, source.height, settings.exponent), settings);
}

Result<Exact::Sizes> Exact::sizes(const CubeMap& source, const ExactSettings& settings) noexcept {
    if (const char* rule = broken_rule(settings, source.size, source.size))
        return Error{VK_ERROR_VALIDATION_FAILED_EXT, rule};
    return sizes_for(cube_grid(source.size, settings.exponent), settings);
}

namespace {

Params params_for(const ExactGrid& grid, const ExactSettings& settings) {
    const auto cosine_beyond = [&](double margin) {
        return float(std::cos(std::min(grid.reach + margin, PI)));
    };
    const double block = (TEAM / 2 + 1) * double(grid.cell_width) + double(grid.cell_height);
    return {.exponent = settings.exponent,
            .scale = float((double(settings.exponent) + 1) / (8 * PI)),
            .row_cull = cosine_beyond(double(grid.cell_height)),
            .block_cull = cosine_beyond(block),
            .columns = grid.columns,
            .rows = grid.rows,
            .repeat_columns = grid.repeat_columns,
            .repeat_rows = grid.repeat_rows,
            .parts = grid.parts,
            .cell_width = grid.cell_width,
            .cell_height = grid.cell_height};
}

/// The caller's buffers of one job.
struct Buffers {
    VkBuffer queries, results, tables;
};

ExactJob bind_source(const std::shared_ptr<const Exact::State>& shared, VkImage image,
                     VkFormat format, const ExactGrid& grid, const ExactSettings& settings,
                     const Buffers& buffers) {
    const vk::Context& context = shared->context;
    const vk::ComputePass& pass = shared->passes[grid.layers > 1][settings.clipped][grid.order - 1];
    auto view = vk::make_level_view(context, image, format, VK_IMAGE_VIEW_TYPE_2D_ARRAY);
    const vk::Resource resources[] = {
        vk::sampled_image(view.get(), shared->sampler.get()),
        vk::buffer_range(buffers.queries),
        vk::buffer_range(buffers.results),
        vk::buffer_range(buffers.tables),
    };
    auto sets = vk::make_descriptor_set(context, pass.interface, BINDINGS, resources);
    return ExactJob(std::make_shared<ExactJob::State>(
        ExactJob::State{shared, &pass, std::move(view), std::move(sets), buffers.tables,
                        make_nodes(grid), schedule(grid, settings), settings.query_count,
                        grid.rows * grid.layers, params_for(grid, settings)}));
}

} // namespace

Result<ExactJob> Exact::bind(const Panorama& source, const ExactSettings& settings,
                             VkBuffer queries, VkBuffer results, VkBuffer tables) const {
    return vk::guarded<ExactJob>([&] {
        vk::refuse(broken_rule(settings, source.width, source.height));
        return bind_source(state_, source.image, source.format,
                           panorama_grid(source.width, source.height, settings.exponent), settings,
                           {queries, results, tables});
    });
}

Result<ExactJob> Exact::bind(const CubeMap& source, const ExactSettings& settings, VkBuffer queries,
                             VkBuffer results, VkBuffer tables) const {
    return vk::guarded<ExactJob>([&] {
        vk::refuse(broken_rule(settings, source.size, source.size));
        return bind_source(state_, source.image, source.format,
                           cube_grid(source.size, settings.exponent), settings,
                           {queries, results, tables});
    });
}

std::uint32_t ExactJob::steps() const noexcept {
    return state_->cut.query_steps * state_->cut.row_steps;
}

void ExactJob::State::record_nodes(VkCommandBuffer commands) const noexcept {
    constexpr VkDeviceSize MOST_BYTES = 65536; // that vkCmdUpdateBuffer takes
    const vk::Context& context = shared->context;
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0,
                       VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT);
    const VkDeviceSize size = nodes.size() * sizeof(ExactNode);
    for (VkDeviceSize offset = 0; offset < size; offset += MOST_BYTES)
        context.call.vkCmdUpdateBuffer(commands, tables, offset,
                                       std::min(MOST_BYTES, size - offset),
                                       nodes.data() + offset / sizeof(ExactNode));
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                       VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_READ_BIT);
}

void ExactJob::State::record_step(VkCommandBuffer commands, std::uint32_t step) const noexcept {
    const std::uint32_t row_step = step % cut.row_steps;
    Params step_params = params;
    step_params.first_query = step / cut.row_steps * cut.queries_per_step;
    step_params.end_query = std::min(step_params.first_query + cut.queries_per_step, query_count);
    step_params.first_row = row_step * cut.rows_per_step;
    step_params.row_count = std::min(cut.rows_per_step, row_count - step_params.first_row);
    step_params.last = row_step + 1 == cut.row_steps;

    const vk::Context& context = shared->context;
    vk::begin_pass(context, commands, *pass, sets.sets[0], step_params);
    const std::uint32_t queries = step_params.end_query - step_params.first_query;
    context.call.vkCmdDispatch(commands, (queries + QUERIES - 1) / QUERIES, 1, 1);
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_WRITE_BIT, vk::ANY_STAGE | VK_PIPELINE_STAGE_HOST_BIT,
                       VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT |
                           VK_ACCESS_HOST_READ_BIT);
}

void ExactJob::record(VkCommandBuffer commands, std::uint32_t first,
                      std::uint32_t count) const noexcept {
    const vk::Label label(state_->shared->context, commands, "lobelia exact");
    if (first == 0 && count > 0) state_->record_nodes(commands);
    for (std::uint32_t step = first; step < first + count; ++step)
        state_->record_step(commands, step);
}

} // namespace lobelia
