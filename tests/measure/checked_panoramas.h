#pragma once

#include <lobelia/host/image.h>

namespace lobelia::test {

// Environments by which promises are checked: nothing was made of them. `width` texels wide.

/// A sky over a dark ground, with three suns of one texel, a decade of light apart.
host::Image sky_with_suns(int width);

/// A dark room with a barred window, its light on the floor, and a candle of 3 x 3 texels.
host::Image room_with_window(int width);

} // namespace lobelia::test
