#include "shown_environment.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

std::string message_about(const host::Sanitised& replaced) {
    const std::uint64_t count = replaced.not_a_number + replaced.infinite + replaced.negative;
    return count ? std::to_string(count) + " texels were no radiance and are replaced" : "";
}

} // namespace

void ShownEnvironment::open(const std::string& path) {
    coming_ = path;
    if (!path.empty()) loader_.begin(path);
}

Outcome<Done> ShownEnvironment::show(Renderer& renderer, const ViewState& state) {
    host::Gpu& gpu = renderer.gpu();
    const Quality quality = state.settings.quality;
    auto environment = source_ ? host::upload_environment(gpu, source_->image, state.face, quality)
                               : host::make_builtin_environment(gpu, state.face, quality);
    if (!environment) return environment.error();
    if (const auto set = renderer.stage().set_environment(std::move(*environment)); !set)
        return set;
    for_high_ = quality == Quality::high;
    ++count_;
    return Done{};
}

Outcome<std::optional<ShownEnvironment::News>> ShownEnvironment::update(Renderer& renderer,
                                                                        ViewState& state) {
    if (!coming_) return std::optional<News>{};
    std::optional<host::Environment> coming;
    if (!coming_->empty()) {
        auto read = loader_.take();
        if (!read) return std::optional<News>{};
        if (!*read) {
            coming_.reset();
            if (!renderer.stage().environment()) return read->error();
            return std::optional(News{read->error().message, true});
        }
        coming = std::move(**read);
    }
    auto before = std::exchange(source_, std::move(coming));
    const std::string path = *std::exchange(coming_, std::nullopt);
    if (const auto shown = show(renderer, state); !shown) {
        if (!renderer.stage().environment() || renderer.is_lost()) return shown.error();
        source_ = std::move(before);
        return std::optional(News{path + ": " + shown.error().message, true});
    }
    state.environment = path;
    return std::optional(News{source_ ? message_about(source_->sanitised) : ""});
}

} // namespace lobelia::cli
