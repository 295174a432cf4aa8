#pragma once

#include "panel.h"
#include "view_state.h"

namespace lobelia::cli {

/// Mouse and keyboard on the picture.
class Controls {
public:
    /// Between Gui::begin_frame() and end_frame(), after the panel.
    void apply(ViewState& state, Requests& requests);

private:
    enum class Drag { none, orbit, light, divider };
    void drag(ViewState& state, Requests& requests);
    void keys(ViewState& state, Requests& requests) const;

    Drag drag_ = Drag::none;
};

} // namespace lobelia::cli
