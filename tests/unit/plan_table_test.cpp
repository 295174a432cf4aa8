#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "support/gpu_sources.h"
#include "support/plan_scenes.h"

// The table of docs/plan.md, as measure_plan prints it: its passes and bytes are those of today's
// plans. Its times are of the machine that it was made on.
namespace lobelia::test {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line.substr(2));
    for (std::string cell; std::getline(stream, cell, '|');) {
        while (cell.ends_with(' ')) cell.pop_back();
        cells.push_back(cell.substr(std::min(cell.find_first_not_of(' '), cell.size())));
    }
    return cells;
}

struct Work {
    std::size_t passes = 0;
    double megabytes = 0;
};

Work work_of(const PlanScene& scene) {
    const ScenePlan plan = value_of(ScenePlan::make(scene.scene()));
    Work work{plan.passes().size()};
    for (const ScenePass& pass : plan.passes())
        work.megabytes += 1e-6 * double(pass.bytes_read + pass.bytes_written);
    return work;
}

TEST(PlanTableTest, IsThatOfTodaysPlans) {
    std::ifstream file(LOBELIA_SOURCE_FOLDER "/docs/plan.md");
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("| ")) rows.push_back(cells_of(line));
    for (const PlanScene& scene : plan_scenes()) {
        const Work work = work_of(scene);
        char megabytes[32];
        std::snprintf(megabytes, sizeof megabytes, "%.2f", work.megabytes);
        const auto row = std::find_if(rows.begin(), rows.end(),
                                      [&](const auto& cells) { return cells[0] == scene.name; });
        ASSERT_NE(row, rows.end()) << scene.name;
        ASSERT_GE(row->size(), 3u);
        EXPECT_EQ((*row)[1], std::to_string(work.passes)) << scene.name;
        EXPECT_EQ((*row)[2], megabytes) << scene.name;
    }
}

TEST(PlanTableTest, HasNoSceneThatTouchesMoreThanEverything) {
    const std::vector<PlanScene> scenes = plan_scenes();
    EXPECT_EQ(scenes.size(), 12u);
    const double everything = work_of(scenes.front()).megabytes;
    for (const PlanScene& scene : scenes)
        EXPECT_LE(work_of(scene).megabytes, everything) << scene.name;
}

} // namespace
} // namespace lobelia::test
