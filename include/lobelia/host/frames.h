#pragma once

#include <functional>
#include <span>

#include <lobelia/host/measure.h>

namespace lobelia::host {

/// A frame of changing light: what the environment looks like in it.
struct FrameLight {
    Image cube;            // as upload_environment() takes cube maps, all frames of one size
    float rotation = 0.0f; // takes the place of the view's environment_rotation
};

/// The sphere in light that changes from frame to frame. `still` and `changing` are medians over
/// the frames, each one submission that is waited for.
struct Frames {
    struct Time {
        double cpu_ms = 0.0;  // process CPU time
        double wall_ms = 0.0; // from the submission to the end of the wait
    };
    Time still;    // the sphere alone, from maps that are there
    Time changing; // every pass of the prefilter, then the sphere
};

/// Draws a frame for each of `count` lights, prefiltered inside the frame for SphereMethod::two_tap
/// at `settings.quality`; nothing is kept from the frame before. `settings.method` is not read. The
/// light's way to the device is not timed. `show` gets each picture.
Outcome<Frames> draw_frames(Gpu& gpu, const RenderSettings& settings, std::size_t count,
                            const std::function<FrameLight(std::size_t)>& light,
                            const std::function<Outcome<Done>(std::size_t, Image)>& show);

} // namespace lobelia::host
