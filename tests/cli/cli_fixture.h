#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/run_program.h"

namespace lobelia::test {

/// Runs lobelia in a folder of its own.
class CliTest : public testing::Test {
protected:
    using Arguments = std::vector<std::string>;

    TemporaryFolder folder;

    ProgramCall call(const Arguments& arguments) const;
    ProgramResult run(const Arguments& arguments) const { return run_program(call(arguments)); }

    /// Runs it and expects success with nothing on stderr; gives stdout.
    std::string run_well(const Arguments& arguments) const;

    /// Writes a small panorama of one colour and gives its path.
    std::string write_panorama(const std::string& name) const;
};

/// Expects that it ended with `status`, printed nothing and said one line that begins "lobelia: "
/// and has `words` in it.
void expect_refused(const ProgramResult& result, int status, const std::string& words);

} // namespace lobelia::test
