#include "measure_row.h"

#include <cmath>

#include "numbers.h"

namespace lobelia::cli {

using Json = nlohmann::ordered_json;

namespace {

template <class T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

template <class T>
std::optional<T> read_optional(const Json& value) {
    return value.is_null() ? std::nullopt : std::optional(value.get<T>());
}

// An error is infinite where all that is exact is black: it does not apply.
Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

double read_finite(const Json& value) {
    return value.is_null() ? INFINITY : value.get<double>();
}

// The digits that were asked for, not those of the float next to them.
Json shortest(float value) {
    return Json::parse(number_text(value));
}

std::string csv_field(const Json& value) {
    if (value.is_null()) return "";
    if (!value.is_string()) return value.dump();
    const std::string& text = value.get_ref<const std::string&>();
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char character : text)
        quoted += character == '"' ? "\"\"" : std::string(1, character);
    return quoted + "\"";
}

} // namespace

Json as_json(const host::Cost& cost) {
    return {{"cpu_ms", cost.cpu_ms},
            {"gpu_ms", or_null(cost.gpu_ms)},
            {"spread", or_null(cost.spread)},
            {"fetches", or_null(cost.fetches)},
            {"bytes", cost.bytes},
            {"dispatches", cost.dispatches}};
}

host::Cost cost_from_json(const Json& object) {
    return {.cpu_ms = object.at("cpu_ms").get<double>(),
            .gpu_ms = read_optional<double>(object.at("gpu_ms")),
            .spread = read_optional<double>(object.at("spread")),
            .fetches = read_optional<std::uint64_t>(object.at("fetches")),
            .bytes = object.at("bytes").get<std::uint64_t>(),
            .dispatches = object.at("dispatches").get<std::uint64_t>()};
}

Json as_json(const MeasureRow& row) {
    const MeasureCase& what = row.what;
    Json object{{"task", what.task},
                {"method", what.method},
                {"samples", or_null(what.samples)},
                {"quality", or_null(what.quality)},
                {"environment", what.environment},
                {"exponent", shortest(what.exponent)},
                {"face_size", what.face_size},
                {"rms", finite(row.error.rms)},
                {"p999", finite(row.error.p999)},
                {"max", finite(row.error.max)},
                {"image_rms", finite(row.error.image_rms)},
                {"mean_ratio", finite(row.error.mean_ratio)}};
    object.update(as_json(row.cost));
    object["yardstick_ms"] = row.yardstick_ms;
    return object;
}

MeasureRow row_from_json(const Json& object) {
    const auto error = [&](const char* name) { return read_finite(object.at(name)); };
    return {.what = {.task = object.at("task").get<std::string>(),
                     .method = object.at("method").get<std::string>(),
                     .samples = read_optional<std::uint32_t>(object.at("samples")),
                     .quality = read_optional<std::string>(object.at("quality")),
                     .environment = object.at("environment").get<std::string>(),
                     .exponent = object.at("exponent").get<float>(),
                     .face_size = object.at("face_size").get<std::uint32_t>()},
            .error = {.rms = error("rms"),
                      .p999 = error("p999"),
                      .max = error("max"),
                      .image_rms = error("image_rms"),
                      .mean_ratio = error("mean_ratio")},
            .cost = cost_from_json(object),
            .yardstick_ms = object.at("yardstick_ms").get<double>()};
}

std::string as_csv(const std::vector<MeasureRow>& rows) {
    std::string names, lines;
    for (const MeasureRow& row : rows) {
        names.clear();
        std::string line;
        const Json object = as_json(row);
        for (const auto& [name, value] : object.items()) {
            names += (names.empty() ? "" : ",") + name;
            line += (line.empty() ? "" : ",") + csv_field(value);
        }
        lines += line + "\n";
    }
    return names + "\n" + lines;
}

} // namespace lobelia::cli
