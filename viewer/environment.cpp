#include "environment.h"

#include "messages.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

void say_replaced(const std::string& path, std::uint64_t count, const char* what,
                  const char* replacement) {
    if (count > 0)
        say(path + ": " + std::to_string(count) + (count == 1 ? " texel was " : " texels were ") +
            what + ", replaced by " + replacement);
}

} // namespace

Outcome<std::optional<host::Environment>> read_source(const std::string& path,
                                                      ProgressLine& progress) {
    if (path.empty()) return std::optional<host::Environment>();
    progress.begin("reading " + path);
    Outcome<host::Environment> environment = host::read_environment(path);
    if (!environment) return environment.error();
    for (const std::string& notice : environment->notices) say(notice);
    const host::Sanitised& sanitised = environment->sanitised;
    say_replaced(path, sanitised.not_a_number, "not a number", "0");
    say_replaced(path, sanitised.infinite, "infinite",
                 "the largest finite value, or 0 where negative");
    say_replaced(path, sanitised.negative, "negative", "0");
    return std::optional(std::move(*environment));
}

Outcome<Done> check_face(const std::optional<host::Environment>& source, std::uint32_t face) {
    if (face != 0 && source && source->image.layout == host::Layout::cube)
        return host::Failure{"--face is for panoramas; this environment is a cube map of " +
                             std::to_string(source->image.width) + " texels, leave it out"};
    return Done{};
}

Outcome<host::GpuEnvironment> upload_source(host::Gpu& gpu,
                                            const std::optional<host::Environment>& source,
                                            std::uint32_t face, Quality quality,
                                            ProgressLine& progress) {
    progress.begin("making the environment's cube map");
    if (const auto fits = check_face(source, face); !fits) return fits.error();
    return source ? host::upload_environment(gpu, source->image, face, quality)
                  : host::make_builtin_environment(gpu, face, quality);
}

} // namespace lobelia::cli
