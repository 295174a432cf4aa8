#pragma once

#include <functional>
#include <string>

#include "bench.h"
#include "catalogue.h"
#include "support/run_program.h"
#include "unit/file_fixtures.h"

// What the rows about files share.
namespace lobelia::hard {

/// What it costs to refuse a file, asked in a process of its own.
struct RefusalCost {
    bool refused = false;
    double cpu_ms = 0;
    double megabytes = 0; // more than the process held before
};
RefusalCost cost_of_refusing(const std::string& path);

/// The file is refused within 50 ms and 16 MB, with a message that begins with its path and has
/// `words` in it.
void cheaply_refused(Findings& found, const std::string& path, const std::string& words = "");

/// The environment in a file that is good.
host::Environment read(const std::string& path);

/// The mean of an image's colour, all texels alike.
double plain_mean(const host::Image& image);

/// An OpenEXR file of WIDTH x HEIGHT texels with what `change` makes of its header.
constexpr int WIDTH = 20, HEIGHT = 10;
std::string make_file(const test::TemporaryFolder& folder,
                      const std::vector<test::Channel>& channels,
                      const std::function<void(Imf::Header&)>& change = {});

} // namespace lobelia::hard
