#include "shown_environment.h"

namespace lobelia::cli {

using host::Outcome;
using namespace std::chrono_literals;

namespace {

constexpr auto WORK_PER_UPDATE = 12ms; // on an upload: the rest of a frame is for drawing

std::string message_about(const host::Sanitised& replaced) {
    const std::uint64_t count = replaced.not_a_number + replaced.infinite + replaced.negative;
    return count ? std::to_string(count) + " texels were no radiance and are replaced" : "";
}

} // namespace

void ShownEnvironment::open(const std::string& path) {
    coming_ = path;
    upload_.reset();
    read_.reset();
    if (!path.empty()) loader_.begin(path);
}

Outcome<Done> ShownEnvironment::show(Renderer& renderer, const ViewState& state) {
    host::Gpu& gpu = renderer.gpu();
    const Quality quality = state.settings.quality;
    auto environment = source_ ? host::upload_environment(gpu, source_->image, state.face, quality)
                               : host::make_builtin_environment(gpu, state.face, quality);
    if (!environment) return environment.error();
    set(renderer, std::move(*environment), quality);
    return Done{};
}

void ShownEnvironment::set(Renderer& renderer, host::GpuEnvironment environment, Quality quality) {
    renderer.stage().set_environment(std::move(environment));
    for_high_ = quality == Quality::high;
    ++count_;
}

Outcome<bool> ShownEnvironment::bring(Renderer& renderer, const ViewState& state) {
    if (!read_) { // the built-in one
        auto before = std::exchange(source_, std::nullopt);
        const auto shown = show(renderer, state);
        if (shown) return true;
        source_ = std::move(before);
        return shown.error();
    }
    if (!upload_) {
        upload_quality_ = state.settings.quality;
        auto begun = host::EnvironmentUpload::begin(renderer.gpu(), read_->image, state.face,
                                                    upload_quality_);
        if (!begun) return begun.error();
        upload_ = std::move(*begun);
    }
    const auto end = std::chrono::steady_clock::now() + WORK_PER_UPDATE;
    while (upload_->done() < 1.0) {
        if (const auto done = upload_->go_on(); !done) return done.error();
        if (upload_->done() < 1.0 && std::chrono::steady_clock::now() >= end) return false;
    }
    set(renderer, upload_->take(), upload_quality_);
    upload_.reset();
    source_ = std::move(*read_);
    return true;
}

Outcome<std::optional<ShownEnvironment::News>> ShownEnvironment::update(Renderer& renderer,
                                                                        ViewState& state) {
    if (!coming_) return std::optional<News>{};
    if (!coming_->empty() && !read_) {
        auto read = loader_.take();
        if (!read) return std::optional<News>{};
        if (!*read) {
            coming_.reset();
            if (!renderer.stage().environment()) return read->error();
            return std::optional(News{read->error().message, true});
        }
        read_ = std::make_unique<host::Environment>(std::move(**read));
    }
    const auto brought = bring(renderer, state);
    if (!brought) {
        upload_.reset();
        if (renderer.is_lost()) return brought.error(); // and goes on with the next device
        read_.reset();
        const std::string path = *std::exchange(coming_, std::nullopt);
        if (!renderer.stage().environment()) return brought.error();
        return std::optional(News{path + ": " + brought.error().message, true});
    }
    if (!*brought) return std::optional<News>{};
    read_.reset();
    state.environment = *std::exchange(coming_, std::nullopt);
    return std::optional(News{source_ ? message_about(source_->sanitised) : ""});
}

} // namespace lobelia::cli
