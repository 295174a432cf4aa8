#include <lobelia/host/progressive_reference.h>

#include <algorithm>
#include <chrono>
#include <cstring>

#include "host/averages.h"
#include "host/camera.h"
#include "host/checks.h"
#include "host/sizes.h"

namespace lobelia::host {

namespace {

constexpr std::size_t FEWEST = 16, MOST = 16384;         // pixels that are integrated together
constexpr std::uint64_t NODES_PER_STEP = 1 << 23;        // a quarter of Exact's: nobody waits long
constexpr std::chrono::milliseconds QUICK(10), SLOW(40); // for those pixels

using Clock = std::chrono::steady_clock;

/// 0 for pixels COARSEST apart, 1 for those half as far, and so on.
int level_of(const SpherePixel& pixel, std::uint32_t width) {
    const std::uint32_t place = pixel.index % width | pixel.index / width;
    int level = 0;
    for (std::uint32_t step = ProgressiveReference::COARSEST; place % step; step /= 2) ++level;
    return level;
}

} // namespace

/// The averages over one lobe: what is asked of Exact and where its answers go.
struct ReferenceLobe {
    ExactSettings settings;
    std::optional<GpuBuffer> averages; // of all pixels; none: this lobe is left out
    std::optional<ExactJob> job;       // of the pixels in work

    float* average(std::uint32_t index) const {
        return reinterpret_cast<float*>(averages->data()) + std::size_t(4) * index;
    }
};

struct ProgressiveReference::State {
    Gpu& gpu;
    ExactSource source;
    Exact exact;
    std::uint32_t width;
    std::vector<SpherePixel> pixels; // in the order of work
    std::size_t first = 0;           // pixel in work
    std::size_t count = 0;           // of them
    std::size_t together = FEWEST;
    Clock::time_point began;
    ReferenceLobe lobes[2]; // diffuse, specular
    std::size_t lobe = 0;   // in work
    std::uint32_t step = 0; // of its job
    std::optional<GpuBuffer> queries, results, tables, known;
    double light = 0.0; // sum of averages over channels, pixels and lobes
    std::size_t lights = 0;

    Outcome<Done> make_buffers(std::size_t size);
    Outcome<Done> begin();
    Outcome<Done> bind(ReferenceLobe& lobe);
    Outcome<Done> go_on();
    void take_results(const ReferenceLobe& lobe);
    void end();
    std::uint32_t* known_words() const { return reinterpret_cast<std::uint32_t*>(known->data()); }
};

Outcome<Done> ProgressiveReference::State::make_buffers(std::size_t size) {
    const VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const auto make = [&](std::optional<GpuBuffer>& buffer, VkDeviceSize bytes) -> Outcome<Done> {
        if (bytes > gpu.limits().maxStorageBufferRange)
            return Failure{"a reference takes " + std::to_string(bytes) +
                           " bytes in one buffer and the device allows " +
                           std::to_string(gpu.limits().maxStorageBufferRange) +
                           ", make the picture smaller"};
        auto made = gpu.create_buffer(bytes, storage, Memory::host);
        if (!made) return made.error();
        std::memset(made->data(), 0, bytes);
        buffer = std::move(*made);
        return Done{};
    };
    if (const auto made = make(known, sizeof(std::uint32_t) * size); !made) return made;
    for (ReferenceLobe& each : lobes)
        if (each.settings.query_count)
            if (const auto made = make(each.averages, TEXEL_BYTES * size); !made) return made;
    return Done{};
}

Outcome<Done> ProgressiveReference::State::bind(ReferenceLobe& each) {
    each.settings.query_count = std::uint32_t(count);
    const auto sizes = source.is_panorama ? Exact::sizes(source.panorama, each.settings)
                                          : Exact::sizes(source.cube, each.settings);
    if (!sizes) return core_failure(sizes.error());
    const auto fit = [&](std::optional<GpuBuffer>& buffer, VkDeviceSize bytes,
                         Memory memory) -> Outcome<Done> {
        if (buffer && buffer->size() >= bytes) return Done{};
        auto made = gpu.create_buffer(
            bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT, memory);
        if (!made) return made.error();
        buffer = std::move(*made);
        return Done{};
    };
    if (const auto made = fit(queries, sizes->queries, Memory::host); !made) return made;
    if (const auto made = fit(results, sizes->results, Memory::host); !made) return made;
    if (const auto made = fit(tables, sizes->tables, Memory::device); !made) return made;
    for (std::size_t i = 0; i < count; ++i) {
        const SpherePixel& pixel = pixels[first + i];
        ExactQuery query{};
        std::memcpy(query.axis, each.settings.clipped ? pixel.mirror : pixel.normal,
                    sizeof query.axis);
        std::memcpy(query.normal, pixel.normal, sizeof query.normal);
        std::memcpy(queries->data() + i * sizeof query, &query, sizeof query);
    }
    auto job = source.is_panorama ? exact.bind(source.panorama, each.settings, queries->handle(),
                                               results->handle(), tables->handle())
                                  : exact.bind(source.cube, each.settings, queries->handle(),
                                               results->handle(), tables->handle());
    if (!job) return core_failure(job.error());
    each.job = std::move(*job);
    step = 0;
    return Done{};
}

Outcome<Done> ProgressiveReference::State::begin() {
    while (first < pixels.size() && known_words()[pixels[first].index]) ++first;
    count = std::min(together, pixels.size() - first);
    began = Clock::now();
    lobe = lobes[0].averages ? 0 : 1;
    return count ? bind(lobes[lobe]) : Done{};
}

void ProgressiveReference::State::take_results(const ReferenceLobe& each) {
    for (std::size_t i = 0; i < count; ++i) {
        float rgb[3];
        std::memcpy(rgb, results->data() + i * TEXEL_BYTES, sizeof rgb);
        float* const average = each.average(pixels[first + i].index);
        std::copy(rgb, rgb + 3, average);
        average[3] = 1.0f;
        light += double(rgb[0]) + rgb[1] + rgb[2];
        lights += 3;
    }
}

void ProgressiveReference::State::end() {
    for (std::size_t i = 0; i < count; ++i) known_words()[pixels[first + i].index] = 1;
    first += count;
    count = 0;
    const auto took = Clock::now() - began;
    if (took < QUICK) together = std::min(2 * together, MOST);
    if (took > SLOW) together = std::max(together / 2, FEWEST);
}

Outcome<Done> ProgressiveReference::State::go_on() {
    ReferenceLobe& each = lobes[lobe];
    const auto done =
        gpu.submit([&](VkCommandBuffer commands) { each.job->record(commands, step, 1); });
    if (!done) return done;
    if (++step < each.job->steps()) return Done{};
    take_results(each);
    each.job.reset();
    if (lobe == 0 && lobes[1].averages) return bind(lobes[++lobe]);
    end();
    return Done{};
}

ProgressiveReference::ProgressiveReference(std::unique_ptr<State> state)
    : state_(std::move(state)) {}
ProgressiveReference::ProgressiveReference(ProgressiveReference&&) noexcept = default;
ProgressiveReference& ProgressiveReference::operator=(ProgressiveReference&&) noexcept = default;
ProgressiveReference::~ProgressiveReference() = default;

Outcome<ProgressiveReference>
ProgressiveReference::create(Gpu& gpu, const GpuEnvironment& environment, const SphereView& view) {
    if (const auto refused = check_view(view, gpu.limits())) return *refused;
    if (const auto refused = check_material(view.material, true)) return *refused;
    auto exact = Exact::create(gpu.device());
    if (!exact) return core_failure(exact.error());
    std::unique_ptr<State> state(new State{.gpu = gpu,
                                           .source = exact_source(environment),
                                           .exact = std::move(*exact),
                                           .width = view.width});
    // A black material has neither lobe and no pixels to integrate.
    const Material& material = view.material;
    const bool lit[] = {!is_black(material.diffuse), !is_black(material.specular)};
    for (std::size_t i = 0; i < std::size(lit); ++i)
        state->lobes[i].settings = {.exponent = i == 0 ? 1.0f : material.exponent,
                                    .clipped = i == 1,
                                    .query_count = lit[i],
                                    .nodes_per_step = NODES_PER_STEP};
    if (lit[0] || lit[1]) state->pixels = sphere_pixels(view);
    std::stable_sort(state->pixels.begin(), state->pixels.end(),
                     [&](const SpherePixel& a, const SpherePixel& b) {
                         return level_of(a, view.width) < level_of(b, view.width);
                     });
    const auto made = state->make_buffers(std::size_t(view.width) * view.height);
    if (!made) return made.error();
    return ProgressiveReference(std::move(state));
}

Outcome<Done> ProgressiveReference::advance(double milliseconds) {
    const auto end = Clock::now() + std::chrono::duration<double, std::milli>(milliseconds);
    do {
        if (state_->count == 0)
            if (const auto begun = state_->begin(); !begun) return begun;
        if (state_->count == 0) return Done{}; // nothing is left
        if (const auto done = state_->go_on(); !done) return done;
    } while (Clock::now() < end);
    return Done{};
}

double ProgressiveReference::done() const {
    return state_->pixels.empty() ? 1.0 : double(state_->first) / double(state_->pixels.size());
}

Outcome<Done> ProgressiveReference::integrate(std::uint32_t x, std::uint32_t y) {
    while (state_->count > 0) // what is in work comes first
        if (const auto done = state_->go_on(); !done) return done;
    const std::uint32_t index = y * state_->width + x;
    const auto rest = state_->pixels.begin() + std::ptrdiff_t(state_->first);
    const auto found = std::find_if(rest, state_->pixels.end(), [index](const SpherePixel& pixel) {
        return pixel.index == index;
    });
    if (found == state_->pixels.end() || is_known(x, y)) return Done{};
    std::rotate(rest, found, found + 1);
    const std::size_t together = std::exchange(state_->together, 1);
    Outcome<Done> done = state_->begin();
    while (done && state_->count > 0) done = state_->go_on();
    state_->together = together;
    return done;
}

VkBuffer ProgressiveReference::diffuse() const {
    const auto& averages = state_->lobes[0].averages;
    return averages ? averages->handle() : VK_NULL_HANDLE;
}
VkBuffer ProgressiveReference::specular() const {
    const auto& averages = state_->lobes[1].averages;
    return averages ? averages->handle() : VK_NULL_HANDLE;
}
VkBuffer ProgressiveReference::known() const {
    return state_->known->handle();
}
bool ProgressiveReference::is_known(std::uint32_t x, std::uint32_t y) const {
    return state_->known_words()[std::size_t(y) * state_->width + x];
}
double ProgressiveReference::mean_light() const {
    return state_->lights ? state_->light / double(state_->lights) : 0.0;
}

} // namespace lobelia::host
