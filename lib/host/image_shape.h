#pragma once

#include <lobelia/host/image.h>
#include <lobelia/host/outcome.h>

namespace lobelia::host {

/// Why an image cannot be written: its texels do not fit its size.
Outcome<Done> check_texels(const Image& image);

/// Likewise, or its layers do not fit its layout.
Outcome<Done> check_environment(const Image& image);

} // namespace lobelia::host
