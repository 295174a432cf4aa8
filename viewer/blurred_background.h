#pragma once

#include "drawing.h"
#include "view_state.h"

namespace lobelia::cli {

/// The environment as the background shows it where it is blurred by a lobe.
class BlurredBackground {
public:
    /// Makes the map that `state` asks for where it is not there, adding what was run to `work`.
    host::Outcome<Done> update(host::Gpu& gpu, const host::GpuEnvironment& environment,
                               const ViewState& state, FrameWork& work);
    void forget() { *this = BlurredBackground{version_ + 1}; }

    /// Null where the background is not blurred.
    VkImageView view() const { return map_ ? map_->view() : VK_NULL_HANDLE; }
    std::uint64_t version() const { return version_; } // of what it shows

    BlurredBackground() = default;

private:
    explicit BlurredBackground(std::uint64_t version) : version_(version) {}
    std::optional<host::GpuImage> map_;
    float blurred_by_ = -1.0f; // exponent
    std::uint64_t version_ = 0;
};

} // namespace lobelia::cli
