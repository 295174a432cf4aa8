#include "tolerance.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <vector>

#include "messages.h"
#include "numbers.h"
#include "parsed_option.h"
#include "prefilter_method.h"
#include "quality.h"
#include "sphere_options.h"

namespace lobelia::cli {

namespace {

/// A method at a quality.
struct Rung {
    std::string name;
    double expected = 0;
};

// From the cheapest on, maps and a picture of 512 x 512 together (docs/accuracy.md). One method is
// cheaper than another by a map or a fetch, one quality than another by all its levels.
struct SphereRung {
    SphereMethod method;
    Quality quality;
};
constexpr SphereRung SPHERE_RUNGS[] = {
    {SphereMethod::split_sum, Quality::fast},   {SphereMethod::one_tap, Quality::fast},
    {SphereMethod::two_tap, Quality::fast},     {SphereMethod::hybrid, Quality::fast},
    {SphereMethod::one_tap, Quality::normal},   {SphereMethod::two_tap, Quality::normal},
    {SphereMethod::hybrid, Quality::normal},    {SphereMethod::one_tap, Quality::high},
    {SphereMethod::two_tap, Quality::high},     {SphereMethod::hybrid, Quality::high},
    {SphereMethod::reference, Quality::normal},
};

struct MapRung {
    host::PrefilterMethod method;
    Quality quality;
};
constexpr MapRung MAP_RUNGS[] = {
    {host::PrefilterMethod::chain, Quality::fast},
    {host::PrefilterMethod::chain, Quality::normal},
    {host::PrefilterMethod::chain, Quality::high},
    {host::PrefilterMethod::exact, Quality::normal},
};

Outcome<double> parse_tolerance(std::string_view text) {
    const auto number = parse_number(text);
    if (!number) return number.error();
    if (*number > 0.0f) return double(*number);
    return host::Failure{"\"" + std::string(text) + "\" is no error; give a number above 0"};
}

/// Tries rung after rung by `expect`, which gives its name and expected error, until one is good
/// enough; none where nothing is wanted.
Outcome<Done> climb(std::optional<double> wanted, std::size_t count,
                    const std::function<Outcome<Rung>(std::size_t)>& expect) {
    if (!wanted) return Done{};
    const double tolerance = *wanted;
    std::optional<Rung> best;
    for (std::size_t i = 0; i < count; ++i) {
        const auto rung = expect(i);
        if (!rung) return rung.error();
        if (rung->expected <= tolerance) {
            say("--tolerance " + error_text(tolerance) + ": " + rung->name + ", expected error " +
                error_text(rung->expected) +
                (best ? "; the best that is cheaper is " + best->name + ", expected error " +
                            error_text(best->expected)
                      : ", is the cheapest"));
            return Done{};
        }
        if (!best || rung->expected < best->expected) best = *rung;
    }
    return host::Failure{"--tolerance " + error_text(tolerance) +
                         " is less than any method promises here; the least is " +
                         error_text(best->expected) + ", by " + best->name};
}

} // namespace

void add_tolerance(CLI::App& verb, std::optional<double>& tolerance) {
    add_parsed(verb, "--tolerance", parse_tolerance, &tolerance, "E",
               "instead of a method and a quality: the cheapest whose expected error is at most E, "
               "pointwise relative RMS");
}

std::string error_text(double error) {
    if (!std::isfinite(error)) return "not promised";
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, error, std::chars_format::general, 2);
    return std::string(text, end.ptr);
}

host::EnvironmentShape shape_of(const std::optional<host::Environment>& source) {
    return source ? host::shape_of(source->image) : host::builtin_shape();
}

Outcome<Done> meet(std::optional<double> tolerance, const host::Gpu& gpu,
                   const host::EnvironmentShape& environment, host::RenderSettings& settings) {
    return climb(tolerance, std::size(SPHERE_RUNGS), [&](std::size_t i) -> Outcome<Rung> {
        settings.method = SPHERE_RUNGS[i].method;
        settings.quality = SPHERE_RUNGS[i].quality;
        const auto plan = host::plan_render(gpu, environment, 0, settings);
        if (!plan) return plan.error();
        std::string name = method_name(settings.method);
        if (settings.method != SphereMethod::reference)
            name += std::string(" at quality ") + quality_name(settings.quality);
        return Rung{name, plan->report.expected_error};
    });
}

Outcome<Done> meet(std::optional<double> tolerance, const host::Gpu& gpu,
                   const host::EnvironmentShape& environment, host::PrefilterSettings& settings) {
    return climb(tolerance, std::size(MAP_RUNGS), [&](std::size_t i) -> Outcome<Rung> {
        settings.method = MAP_RUNGS[i].method;
        settings.quality = MAP_RUNGS[i].quality;
        const auto plan = host::plan_prefilter(gpu, environment, settings);
        if (!plan) return plan.error();
        std::string name = prefilter_method_name(settings.method);
        if (settings.method == host::PrefilterMethod::chain)
            name += std::string(" at quality ") + quality_name(settings.quality);
        return Rung{name, plan->report.expected_error};
    });
}

} // namespace lobelia::cli
