#include "measure_work.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <random>

#include "numbers.h"
#include "prefilter_method.h"
#include "quality.h"

namespace lobelia::cli {

using host::Measured;

namespace {

constexpr std::size_t DIRECTIONS = 400;          // at which maps are compared
constexpr std::uint32_t COMPARED_SIZE = 20;      // of the pictures whose pixels are compared
constexpr std::uint32_t TIMED_SIZE = 512;        // of the pictures that are timed
constexpr float DIFFUSE = 0.3f, SPECULAR = 0.6f; // of the material, as render's defaults

using Directions = std::vector<std::array<float, 3>>;

/// Uniform over the sphere, the same on every machine.
const Directions& directions() {
    static const Directions all = [] {
        std::mt19937_64 engine(1);
        const auto unit = [&] { return double(engine() >> 11) * 0x1p-53; }; // in [0, 1)
        Directions made;
        for (std::size_t i = 0; i < DIRECTIONS; ++i) {
            const double z = 2.0 * unit() - 1.0, angle = 2.0 * std::numbers::pi * unit();
            const double radius = std::sqrt(1.0 - z * z);
            made.push_back(
                {float(radius * std::cos(angle)), float(radius * std::sin(angle)), float(z)});
        }
        return made;
    }();
    return all;
}

host::PrefilterSettings prefilter_settings(const MeasureCase& what) {
    host::PrefilterSettings settings{.method = *parse_prefilter_method(what.method),
                                     .exponents = {what.exponent}};
    if (what.quality) settings.quality = *parse_quality(*what.quality);
    if (what.samples) settings.samples = *what.samples;
    return settings;
}

host::RenderSettings render_settings(SphereMethod method, float diffuse, float specular,
                                     float exponent) {
    return {.view = {.material = {.diffuse = {diffuse, diffuse, diffuse},
                                  .specular = {specular, specular, specular},
                                  .exponent = exponent},
                     .background = false,
                     .width = COMPARED_SIZE,
                     .height = COMPARED_SIZE},
            .method = method};
}

SphereMethod render_method(const std::string& name) {
    for (const host::RenderMethod& known : host::render_methods())
        if (name == known.name) return known.method;
    return SphereMethod::reference;
}

bool is_exact(const MeasureCase& what) {
    return what.task == "prefilter"
               ? *parse_prefilter_method(what.method) == host::PrefilterMethod::exact
               : render_method(what.method) == SphereMethod::reference;
}

Outcome<Measured> only(const Outcome<std::vector<Measured>>& all) {
    if (!all) return all.error();
    return all->front();
}

/// Light adds up, and so does the work.
Measured sum(Measured one, const Measured& other) {
    for (std::size_t i = 0; i < one.colours.size(); ++i) one.colours[i] += other.colours[i];
    host::Cost& cost = one.cost;
    cost.cpu_ms += other.cost.cpu_ms;
    if (cost.gpu_ms && other.cost.gpu_ms) *cost.gpu_ms += *other.cost.gpu_ms;
    cost.bytes += other.cost.bytes;
    cost.dispatches += other.cost.dispatches;
    return one;
}

} // namespace

nlohmann::ordered_json measure_settings() {
    return {{"directions", DIRECTIONS},
            {"compared_picture", COMPARED_SIZE},
            {"timed_picture", TIMED_SIZE},
            {"kd", nlohmann::ordered_json::parse(number_text(DIFFUSE))},
            {"ks", nlohmann::ordered_json::parse(number_text(SPECULAR))}};
}

Outcome<const host::GpuEnvironment*> Measurer::upload(const MeasureSource& source,
                                                      std::uint32_t face) {
    auto known = uploads_.find(face);
    if (known == uploads_.end()) {
        auto made = source.file ? host::upload_environment(gpu_, source.file->image, face)
                                : host::make_builtin_environment(gpu_, face);
        if (!made) return made.error();
        known = uploads_.emplace(face, std::move(*made)).first;
    }
    return &known->second;
}

Outcome<Measured> Measurer::exact_prefilter(float exponent, const MeasureSource& source) {
    return folder_.remembered(
        source.fingerprint + "-n" + number_text(exponent), [&]() -> Outcome<Measured> {
            const auto environment = upload(source, source.face);
            if (!environment) return environment.error();
            const host::PrefilterCase exact{
                *environment, {.method = host::PrefilterMethod::exact, .exponents = {exponent}}};
            return only(host::measure_prefilter(gpu_, {&exact, 1}, directions()));
        });
}

Outcome<Measured> Measurer::reference(float exponent, const MeasureSource& source) {
    // The diffuse part is the same for every exponent.
    const auto part = [&](const std::string& name, float diffuse, float specular) {
        return folder_.remembered(
            source.fingerprint + "-sphere-" + name, [&]() -> Outcome<Measured> {
                const auto environment = upload(source, source.face);
                if (!environment) return environment.error();
                const host::ShadingCase reference{
                    *environment,
                    render_settings(SphereMethod::reference, diffuse, specular, exponent)};
                return only(host::measure_shading(gpu_, {&reference, 1}, TIMED_SIZE));
            });
    };
    auto diffuse = part("diffuse", DIFFUSE, 0.0f);
    if (!diffuse) return diffuse.error();
    const auto specular = part("n" + number_text(exponent), 0.0f, SPECULAR);
    if (!specular) return specular.error();
    return sum(std::move(*diffuse), *specular);
}

Outcome<std::vector<Measured>> Measurer::prefilter(std::span<const MeasureCase> cases,
                                                   const MeasureSource& source) {
    std::vector<host::PrefilterCase> methods;
    for (const MeasureCase& what : cases) {
        const auto environment = upload(source, what.face_size);
        if (!environment) return environment.error();
        methods.push_back({*environment, prefilter_settings(what)});
    }
    return host::measure_prefilter(gpu_, methods, directions());
}

Outcome<std::vector<Measured>> Measurer::shade(std::span<const MeasureCase> cases,
                                               const MeasureSource& source) {
    std::vector<host::ShadingCase> methods;
    for (const MeasureCase& what : cases) {
        const auto environment = upload(source, what.face_size);
        if (!environment) return environment.error();
        methods.push_back({*environment, render_settings(render_method(what.method), DIFFUSE,
                                                         SPECULAR, what.exponent)});
        host::RenderSettings& settings = methods.back().settings;
        if (what.samples) settings.samples = *what.samples;
        if (what.quality) settings.quality = *parse_quality(*what.quality);
    }
    return host::measure_shading(gpu_, methods, TIMED_SIZE);
}

Outcome<std::vector<MeasureRow>> Measurer::measure(std::span<const MeasureCase> cases,
                                                   const MeasureSource& source) {
    if (environment_ != source.name) uploads_.clear();
    environment_ = source.name;
    const bool prefilters = cases.front().task == "prefilter";
    const float exponent = cases.front().exponent;

    const auto exact = prefilters ? exact_prefilter(exponent, source) : reference(exponent, source);
    if (!exact) return exact.error();
    std::vector<MeasureCase> methods; // all others
    std::copy_if(cases.begin(), cases.end(), std::back_inserter(methods),
                 [](const MeasureCase& what) { return !is_exact(what); });
    const auto measured = prefilters ? prefilter(methods, source) : shade(methods, source);
    if (!measured) return measured.error();

    // The machine drifts: the yardsticks are measured beside what is held against them.
    std::map<std::uint32_t, double> yardsticks; // by face size
    std::vector<MeasureRow> rows;
    auto next = measured->begin();
    for (const MeasureCase& what : cases) {
        if (!yardsticks.contains(what.face_size)) {
            const auto cost = host::measure_mip_chain(gpu_, what.face_size);
            if (!cost) return cost.error();
            yardsticks[what.face_size] = cost->cpu_ms;
        }
        const Measured& found = is_exact(what) ? *exact : *next++;
        rows.push_back({what, host::measure_error(found.colours, exact->colours), found.cost,
                        yardsticks[what.face_size]});
    }
    return rows;
}

} // namespace lobelia::cli
