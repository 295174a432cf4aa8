#pragma once

#include <gtest/gtest.h>

#include "session.h"
#include "support/png_file.h"
#include "support/run_program.h"

namespace lobelia::test {

using Json = ViewerSession::Json;

inline const std::vector<std::pair<std::string, std::string>> VALIDATED{
    {"VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation"},
    {"VK_LAYER_ENABLES", "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT"}};

/// A person at a desktop of their own. Fails where the program says anything on stderr, validation
/// says anything on stdout, or the exit status is not 0.
class ViewerTest : public testing::Test {
protected:
    Desktop desktop;
    TemporaryFolder folder;

    void expect_good_end(ViewerSession& session);
    /// What the desktop shows of the window.
    PngFile seen(ViewerSession& session);
};

/// The largest difference of a colour channel within columns [first, last).
int largest_difference(const PngFile& a, const PngFile& b, std::uint32_t first, std::uint32_t last);

} // namespace lobelia::test
