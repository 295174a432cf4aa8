#include <memory>

#include <nlohmann/json.hpp>

#include "gpu_choice.h"
#include "messages.h"
#include "numbers.h"
#include "verbs.h"

namespace lobelia::cli {

namespace {

struct DevicesOptions {
    GpuChoice gpu;
    bool json = false;
};

using Gpus = std::vector<host::GpuDescription>;

struct Picked {
    std::size_t index = 0;
    std::string why;
};

std::string version_text(std::uint32_t version) {
    return std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
           std::to_string(VK_API_VERSION_MINOR(version)) + "." +
           std::to_string(VK_API_VERSION_PATCH(version));
}

bool is_same(const host::GpuDescription& a, const host::GpuDescription& b) {
    return a.name == b.name && a.driver == b.driver && a.type == b.type;
}

// Of devices that are described alike the first is picked, unless the index says otherwise.
std::size_t find_index(const Gpus& gpus, const host::Gpu& picked, const std::string& wanted) {
    const Outcome<std::uint32_t> index = parse_count(wanted);
    if (index && *index < gpus.size()) return *index;
    std::size_t first = 0;
    while (first + 1 < gpus.size() && !is_same(gpus[first], picked.description())) ++first;
    return first;
}

std::string as_json(const Gpus& gpus, const Picked* picked) {
    nlohmann::ordered_json devices = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < gpus.size(); ++i)
        devices.push_back({{"index", i},
                           {"name", gpus[i].name},
                           {"driver", gpus[i].driver},
                           {"type", gpus[i].type},
                           {"vulkan", version_text(gpus[i].api_version)}});
    nlohmann::ordered_json all{{"devices", devices}, {"picked", nullptr}, {"why", nullptr}};
    if (picked) {
        all["picked"] = picked->index;
        all["why"] = picked->why;
    }
    return all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string as_text(const Gpus& gpus, const Picked* picked) {
    std::string text;
    for (std::size_t i = 0; i < gpus.size(); ++i)
        text += std::to_string(i) + "  " + gpus[i].name + "  (" + gpus[i].type + ", " +
                gpus[i].driver + ", Vulkan " + version_text(gpus[i].api_version) + ")\n";
    if (picked) text += "picked: " + std::to_string(picked->index) + ", " + picked->why + "\n";
    return text;
}

int show_devices(const DevicesOptions& options) {
    const auto gpus = host::list_gpus();
    if (!gpus) return fail(gpus.error().message);
    const auto gpu = start_gpu(options.gpu);
    Picked picked;
    if (gpu) picked = {find_index(*gpus, *gpu, options.gpu.device), gpu->why_picked()};
    // The list helps most where none of it could be started.
    const Picked* const shown = gpu ? &picked : nullptr;
    const int printed = print(options.json ? as_json(*gpus, shown) : as_text(*gpus, shown));
    return gpu ? printed : fail(gpu.error().message);
}

} // namespace

void add_devices(CLI::App& program, int& status) {
    const auto options = std::make_shared<DevicesOptions>();
    CLI::App* const verb = program.add_subcommand(
        "devices", "lists the Vulkan devices, and which one is picked and why");
    add_gpu_options(*verb, options->gpu);
    verb->add_flag("--json", options->json, "print one JSON object");
    verb->callback([options, &status] { status = show_devices(*options); });
}

} // namespace lobelia::cli
