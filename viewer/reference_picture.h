#pragma once

#include <chrono>

#include <lobelia/host/progressive_reference.h>

#include "method_picture.h"
#include "view_state.h"

namespace lobelia::cli {

/// The truth about a view, which sharpens while nothing moves.
class ReferencePicture {
public:
    /// Goes on with it, and draws what is known so far.
    host::Outcome<Done> update(host::Gpu& gpu, const host::GpuEnvironment& environment,
                               SpherePipelines& pipelines, const PictureRequest& request,
                               FrameWork& work);
    void forget(); // the environment is another one, or it is not asked for any more
    /// Another update of the same view would change it.
    bool is_busy() const { return view_ && done() < 1.0; }
    bool is_asked_for() const { return view_.has_value(); }
    /// The fraction of its pixels that is known.
    double done() const { return reference_ ? reference_->done() : 0.0; }

    /// Null until there is something to show.
    const host::ProgressiveReference* values() const {
        return reference_ && drawing_.picture() ? &*reference_ : nullptr;
    }
    const Picture* picture() const { return drawing_.picture(); }

private:
    std::optional<host::ProgressiveReference> reference_;
    std::optional<SphereView> view_; // that it is of, or will be once that stays
    std::chrono::steady_clock::time_point asked_;
    std::uint64_t version_ = 0;
    Drawing drawing_;
};

/// Draws the view from the reference's averages.
DrawingRequest reference_drawing(const host::ProgressiveReference& reference,
                                 const PictureRequest& request);

} // namespace lobelia::cli
