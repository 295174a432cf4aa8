#pragma once

#include "lights.h"
#include "view_state.h"

namespace lobelia::cli {

/// The environment as the background shows it where it is blurred by a lobe.
class BlurredBackground {
public:
    /// Goes on until `end` with the map that `state` asks for, and adds what was run to `work`.
    /// Until it is there the one before is shown.
    host::Outcome<Done> update(Lights& lights, const ViewState& state, FrameWork& work,
                               std::chrono::steady_clock::time_point end);
    bool is_ready() const { return ready_; }
    void forget(); // the environment is another one, or none is asked for any more

    const Lights::Light* light() const { return light_; } // shown now; null where it is sharp
    std::uint64_t version() const { return version_; }    // of what it shows

private:
    const Lights::Light* light_ = nullptr;
    float blurred_by_ = -1.0f; // exponent
    bool ready_ = true;
    std::uint64_t version_ = 0;
};

} // namespace lobelia::cli
