#pragma once

#include "host/colour_target.h"
#include "host/sphere_inputs.h"

namespace lobelia::host {

/// A picture of the sphere, ready to be drawn any number of times. The inputs outlive it.
struct Drawing {
    ColourTarget target;
    SphereJob job;
    SphereView view;

    /// `view` may differ from that of the inputs in what they do not depend on.
    static Outcome<Drawing> create(Gpu& gpu, const SphereInputs& inputs, const SphereView& view);

    /// Draws once, and adds its times to the report.
    Outcome<Done> run(Gpu& gpu, PassReport& report) const;
    Outcome<Image> picture(Gpu& gpu) const;
};

} // namespace lobelia::host
