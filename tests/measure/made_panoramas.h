#pragma once

#include <string>
#include <vector>

#include <lobelia/host/image.h>

namespace lobelia::test {

/// Environments of 1024 x 512 texels that no constant of the prefilter was chosen by.
struct MadePanorama {
    std::string name;
    host::Image image;
};
std::vector<MadePanorama> made_panoramas();

} // namespace lobelia::test
