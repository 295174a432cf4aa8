#include "report.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "quality.h"

namespace lobelia::cli {

using Json = nlohmann::ordered_json;

namespace {

Json number_or_null(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json as_json(const host::PassReport& pass) {
    return {{"name", pass.name},
            {"invocations", pass.invocations},
            {"bytes_read", pass.bytes_read},
            {"bytes_written", pass.bytes_written},
            {"cpu_ms", number_or_null(pass.cpu_ms)},
            {"gpu_ms", number_or_null(pass.gpu_ms)}};
}

Json as_json(const host::ImageReport& image) {
    return {{"name", image.name},     {"width", image.width},      {"height", image.height},
            {"layers", image.layers}, {"levels", image.levels},    {"format", image.format},
            {"bytes", image.bytes},   {"lifetime", image.lifetime}};
}

Json as_json(const host::PlanReason& reason) {
    return {{"effect", reason.effect},
            {"in", reason.in},
            {"why", reason.why},
            {"ms", reason.milliseconds},
            {"bytes", reason.bytes}};
}

Json as_json(const std::optional<host::Sanitised>& sanitised) {
    if (!sanitised) return nullptr;
    return {{"not_a_number", sanitised->not_a_number},
            {"infinite", sanitised->infinite},
            {"negative", sanitised->negative}};
}

template <class T>
Json as_array(const std::vector<T>& values) {
    Json array = Json::array();
    for (const T& value : values) array.push_back(as_json(value));
    return array;
}

} // namespace

void Report::append(const host::WorkReport& more) {
    work.passes.insert(work.passes.end(), more.passes.begin(), more.passes.end());
    work.images.insert(work.images.end(), more.images.begin(), more.images.end());
    if (more.suns) work.suns = more.suns;
    work.expected_error = std::max(work.expected_error, more.expected_error);
}

std::string as_json(const Report& report, const std::vector<host::PlanReason>& reasons) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - report.start;
    Json object{{"device", report.gpu.name},
                {"driver", report.gpu.driver},
                {"method", report.method},
                {"quality", report.quality ? Json(quality_name(*report.quality)) : Json()},
                {"passes", as_array(report.work.passes)},
                {"images", as_array(report.work.images)},
                {"suns", report.work.suns ? Json(*report.work.suns) : Json()},
                {"sanitised", as_json(report.sanitised)},
                {"expected_error", number_or_null(report.work.expected_error)},
                {"seconds", passed.count()}};
    if (!reasons.empty()) object["why"] = as_array(reasons);
    return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace lobelia::cli
