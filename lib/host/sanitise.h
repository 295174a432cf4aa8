#pragma once

#include <lobelia/host/read.h>

namespace lobelia::host {

/// Makes every texel radiance by the rules that Sanitised states, and counts. Alpha becomes 1.
/// Fails when no texel has three finite channels, since then there is nothing to go by.
Outcome<Sanitised> sanitise(Image& image);

} // namespace lobelia::host
