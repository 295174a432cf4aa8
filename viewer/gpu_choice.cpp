#include "gpu_choice.h"

#include "messages.h"

namespace lobelia::cli {

void add_gpu_options(CLI::App& verb, GpuChoice& choice) {
    verb.add_option(
            "--device", choice.device,
            "Vulkan device: its index in `lobelia devices` or part of its name; default: the "
            "first discrete, then integrated, virtual, CPU one")
        ->type_name("INDEX|NAME");
    verb.add_flag("--verbose", choice.verbose, "tell on stderr what is used, and why");
}

host::Outcome<host::Gpu> start_gpu(const GpuChoice& choice,
                                   const std::optional<host::Presentation>& presentation) {
    host::Outcome<host::Gpu> gpu =
        host::Gpu::create({.device = choice.device, .presentation = presentation});
    if (gpu && choice.verbose)
        say("device: " + gpu->description().name + " (" + gpu->description().driver +
            "): " + gpu->why_picked());
    return gpu;
}

} // namespace lobelia::cli
