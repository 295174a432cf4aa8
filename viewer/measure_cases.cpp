#include "measure_cases.h"

#include "prefilter_method.h"
#include "quality.h"

namespace lobelia::cli {

namespace {

constexpr Quality QUALITIES[] = {Quality::fast, Quality::normal, Quality::high};
constexpr float SWEEP_EXPONENT = 64.0f; // of the measurements over face sizes

std::vector<float> exponents(bool quick) {
    if (quick) return {4.8f, 64.0f, 1024.0f};
    return {1.0f, 4.8f, 16.0f, 64.0f, 256.0f, 1024.0f, 4096.0f};
}

// Of a pixel, which are drawn in every frame.
std::vector<std::uint32_t> pixel_sample_counts(bool quick) {
    if (quick) return {8, 64};
    return {8, 16, 64, 256};
}

// Of a map's texel.
std::vector<std::uint32_t> sample_counts(bool quick) {
    if (quick) return {16, 256};
    return {16, 64, 256, 1024, 4096};
}

std::vector<std::uint32_t> sweep_faces(bool quick) {
    if (quick) return {64, 512};
    return {64, 128, 512, 1024};
}

// A source of twice the size is part of quality high, as far as there is a choice.
std::uint32_t face_for(const MeasureSource& source, Quality quality) {
    return quality == Quality::high && source.is_panorama() ? 2 * source.face : source.face;
}

MeasureCase chain_case(const MeasureSource& source, Quality quality, float exponent,
                       std::uint32_t face) {
    return {.task = "prefilter",
            .method = prefilter_method_name(host::PrefilterMethod::chain),
            .quality = quality_name(quality),
            .environment = source.name,
            .exponent = exponent,
            .face_size = face};
}

void add_prefilter(std::vector<MeasureCase>& cases, const MeasureSource& source, float exponent,
                   bool quick) {
    MeasureCase one{.task = "prefilter",
                    .environment = source.name,
                    .exponent = exponent,
                    .face_size = source.face};
    for (const host::PrefilterMethod method : PREFILTER_METHODS) {
        one.method = prefilter_method_name(method);
        if (method == host::PrefilterMethod::chain) {
            for (const Quality quality : QUALITIES)
                cases.push_back(chain_case(source, quality, exponent, face_for(source, quality)));
        } else if (takes_samples(method)) {
            for (const std::uint32_t samples : sample_counts(quick)) {
                one.samples = samples;
                cases.push_back(one);
            }
            one.samples.reset();
        } else {
            cases.push_back(one);
        }
    }
}

/// The qualities of maps that a method of shading is measured with; none where it reads none.
std::vector<Quality> shading_qualities(SphereMethod method, bool quick) {
    switch (method) {
    case SphereMethod::sh2:
    case SphereMethod::sh4:
    case SphereMethod::split_sum: return {Quality::normal};
    case SphereMethod::one_tap:
    case SphereMethod::two_tap:
    case SphereMethod::hybrid: break;
    default: return {};
    }
    std::vector<Quality> qualities;
    for (const Quality quality : QUALITIES)
        if (!quick || host::method_for(quality) == method) qualities.push_back(quality);
    return qualities;
}

void add_shading(std::vector<MeasureCase>& cases, const MeasureSource& source, float exponent,
                 bool quick) {
    for (const host::RenderMethod& method : host::render_methods()) {
        MeasureCase one{.task = "shade",
                        .method = method.name,
                        .environment = source.name,
                        .exponent = exponent,
                        .face_size = source.face};
        if (method.method == SphereMethod::importance) {
            for (const std::uint32_t samples : pixel_sample_counts(quick)) {
                one.samples = samples;
                cases.push_back(one);
            }
            continue;
        }
        const std::vector<Quality> qualities = shading_qualities(method.method, quick);
        if (qualities.empty()) cases.push_back(one);
        for (const Quality quality : qualities) {
            one.quality = quality_name(quality);
            one.face_size = face_for(source, quality);
            cases.push_back(one);
        }
    }
}

void add_sweep(std::vector<MeasureCase>& cases, const MeasureSource& source, bool quick) {
    for (const std::uint32_t face : sweep_faces(quick))
        for (const Quality quality : QUALITIES)
            if (face != face_for(source, quality))
                cases.push_back(chain_case(source, quality, SWEEP_EXPONENT, face));
}

} // namespace

bool MeasureSource::is_panorama() const {
    return !file || file->image.layout == host::Layout::latlong;
}

std::vector<MeasureCase> measure_cases(const std::vector<MeasureSource>& sources,
                                       const MeasurePlan& plan) {
    std::vector<MeasureCase> cases;
    for (const MeasureSource& source : sources) {
        for (const float exponent : exponents(plan.quick)) {
            if (plan.prefilter) add_prefilter(cases, source, exponent, plan.quick);
            if (plan.shade) add_shading(cases, source, exponent, plan.quick);
        }
        // One environment tells how cost grows with size; a cube map has its size.
        if (plan.prefilter && &source == &sources.front() && source.is_panorama())
            add_sweep(cases, source, plan.quick);
    }
    return cases;
}

} // namespace lobelia::cli
