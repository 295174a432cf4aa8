#include "measure_folder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <lobelia/host/write.h>

#include "interrupts.h"
#include "measure_work.h"

namespace lobelia::cli {

namespace fs = std::filesystem;
using host::Failure;
using host::Outcome;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* TABLE = "measure.csv";
constexpr const char* REPORT = "measure.json";
constexpr const char* MEMORY = "exact"; // folder of what takes long and stays the same

Json environment_json(const MeasureSource& source) {
    return {{"name", source.name},
            {"fingerprint", source.fingerprint},
            {"panorama", source.is_panorama()},
            {"face_size", source.face}};
}

Json head_of(const host::Gpu& gpu, const std::vector<MeasureSource>& sources) {
    const std::uint32_t api = gpu.description().api_version;
    Json head{{"device", gpu.description().name},
              {"device_type", gpu.description().type},
              {"driver", gpu.description().driver},
              {"versions",
               {{"lobelia", LOBELIA_VERSION},
                {"vulkan", std::to_string(VK_API_VERSION_MAJOR(api)) + "." +
                               std::to_string(VK_API_VERSION_MINOR(api)) + "." +
                               std::to_string(VK_API_VERSION_PATCH(api))}}},
              {"settings", measure_settings()},
              {"environments", Json::array()}};
    for (const MeasureSource& source : sources)
        head["environments"].push_back(environment_json(source));
    return head;
}

std::optional<std::string> read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

Failure mismatch(const std::string& path, const std::string& what) {
    return Failure{path + ": was measured " + what +
                   ", give another folder to -o or remove this one"};
}

} // namespace

Outcome<MeasureFolder> MeasureFolder::open(const std::string& path, const host::Gpu& gpu,
                                           const std::vector<MeasureSource>& sources) {
    MeasureFolder folder;
    folder.path_ = path;
    folder.head_ = head_of(gpu, sources);
    std::error_code error;
    fs::create_directories(path + "/" + MEMORY, error);
    if (error)
        return Failure{path + ": cannot be made a folder (" + error.message() +
                       "), give another to -o"};
    if (const auto loaded = folder.load(); !loaded) return loaded.error();
    return folder;
}

Outcome<Done> MeasureFolder::load() {
    const std::string path = path_ + "/" + REPORT;
    const auto text = read_text(path);
    if (!text) return Done{};
    try {
        const Json before = Json::parse(*text);
        for (const char* const key : {"device", "driver", "versions", "settings"})
            if (before.at(key) != head_.at(key))
                return mismatch(path, "with another " + std::string(key) + " (" +
                                          before.at(key).dump() + ")");
        Json& environments = head_["environments"];
        for (const Json& known : before.at("environments")) {
            const auto same_name =
                std::find_if(environments.begin(), environments.end(),
                             [&](const Json& now) { return now["name"] == known.at("name"); });
            if (same_name == environments.end())
                environments.push_back(known);
            else if (*same_name != known)
                return mismatch(path, "on another environment called " + known.at("name").dump());
        }
        for (const Json& row : before.at("rows")) rows_.push_back(row_from_json(row));
    } catch (const Json::exception&) {
        return Failure{path + ": is not what lobelia measure writes, give another folder to -o or "
                              "remove it"};
    }
    return Done{};
}

bool MeasureFolder::has(const MeasureCase& what) const {
    return std::any_of(rows_.begin(), rows_.end(),
                       [&](const MeasureRow& row) { return row.what == what; });
}

Outcome<Done> MeasureFolder::add(const std::vector<MeasureRow>& rows) {
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    const DeferredInterrupts both_files;
    if (const auto written = write(TABLE, as_csv(rows_)); !written) return written.error();
    Json report = head_;
    report["rows"] = Json::array();
    for (const MeasureRow& one : rows_) report["rows"].push_back(as_json(one));
    return write(REPORT, report.dump(1) + "\n");
}

Outcome<Done> MeasureFolder::write(const std::string& name, const std::string& text) const {
    return host::replace_file(path_ + "/" + name, std::as_bytes(std::span(text)));
}

Outcome<host::Measured>
MeasureFolder::remembered(const std::string& key,
                          const std::function<Outcome<host::Measured>()>& measure) const {
    const std::string name = std::string(MEMORY) + "/" + key + ".json";
    const Json made_by{head_["device"], head_["driver"], head_["versions"], head_["settings"]};
    if (const auto text = read_text(path_ + "/" + name)) {
        const Json known = Json::parse(*text, nullptr, false);
        if (known.value("made_by", Json()) == made_by)
            return host::Measured{known.at("colours").get<std::vector<float>>(),
                                  cost_from_json(known.at("cost"))};
    }
    auto measured = measure();
    if (!measured) return measured.error();
    const Json memory{
        {"made_by", made_by}, {"colours", measured->colours}, {"cost", as_json(measured->cost)}};
    const DeferredInterrupts whole_file;
    if (const auto written = write(name, memory.dump() + "\n"); !written) return written.error();
    return measured;
}

} // namespace lobelia::cli
