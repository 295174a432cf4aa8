#pragma once

#include <lobelia/host/environment_upload.h>

#include "loader.h"
#include "renderer.h"
#include "view_state.h"

namespace lobelia::cli {

/// The environment that is shown, and the one that is to be: the old one stays until the new one is
/// ready, and where that is none.
class ShownEnvironment {
public:
    /// Shows the file, or where the path is empty the built-in one, as soon as it is ready.
    void open(const std::string& path);
    bool is_loading() const { return loader_.is_busy() || upload_; }
    bool is_on_its_way() const { return upload_.has_value(); } // to the device
    const Loader& loader() const { return loader_; }

    /// What there is to tell of a file that was read: of its texels, or why it cannot be shown.
    struct News {
        std::string message;
        bool is_bad = false;
    };
    /// Brings what was asked for to the device, for a part of a frame's time, and shows it when it
    /// is there, with its path in `state`; nothing before. Fails where there is nothing to show
    /// now, or the device is lost.
    host::Outcome<std::optional<News>> update(Renderer& renderer, ViewState& state);
    /// Brings it to the device again, which is another one or shows another quality.
    host::Outcome<Done> show(Renderer& renderer, const ViewState& state);
    /// Lets go of what is on a device that is lost: it will be brought to the next one.
    void leave_device() { upload_.reset(); }
    bool has_quality(Quality quality) const { return for_high_ == (quality == Quality::high); }
    std::uint64_t count() const { return count_; } // shown so far

private:
    /// Whether what was asked for, and read if it is a file, is shown now.
    host::Outcome<bool> bring(Renderer& renderer, const ViewState& state);
    void set(Renderer& renderer, host::GpuEnvironment environment, Quality quality);

    Loader loader_;
    std::optional<std::string> coming_;             // path of what is to be shown next
    std::unique_ptr<host::Environment> read_;       // what was read of it
    std::optional<host::EnvironmentUpload> upload_; // of that, which stays where it is
    Quality upload_quality_ = Quality::normal;
    std::optional<host::Environment> source_; // of what is shown; none: the built-in one
    bool for_high_ = false;                   // the cube map is for Quality::high
    std::uint64_t count_ = 0;
};

} // namespace lobelia::cli
