#include <algorithm>
#include <filesystem>
#include <sstream>

#include <nlohmann/json.hpp>

#include "cli_fixture.h"

namespace lobelia::test {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* COLUMNS =
    "task,method,samples,quality,environment,exponent,face_size,rms,p999,max,image_rms,mean_ratio,"
    "cpu_ms,gpu_ms,spread,fetches,bytes,dispatches,yardstick_ms";

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

class MeasureVerb : public CliTest {
protected:
    std::string out() const { return folder / "out"; }
    Json report() const { return Json::parse(read_bytes(out() + "/measure.json")); }

    /// Measures without a program to draw with, wherever there is one.
    ProgramResult measure(const Arguments& arguments) const {
        ProgramCall without = call({"measure", "-o", "out", "--quick"});
        without.command.insert(without.command.end(), arguments.begin(), arguments.end());
        without.environment = {{"PATH", folder.path()}};
        return run_program(without);
    }
};

} // namespace

TEST_F(MeasureVerb, KeepsARowForEveryMeasurementMakesNoneTwiceAndDraws) {
    const std::string sky = write_panorama("sky.exr");
    const ProgramResult first = measure({sky, "--tasks", "prefilter"});
    EXPECT_EQ(first.status, 0) << first.err;
    EXPECT_NE(first.err.find("prefilter-error-time"), std::string::npos) << first.err;
    EXPECT_NE(first.err.find("install it (Debian: gnuplot-nox)"), std::string::npos) << first.err;
    EXPECT_FALSE(std::filesystem::exists(out() + "/prefilter-error-time.svg"));
    const std::string page = read_bytes(out() + "/index.html");
    EXPECT_NE(page.find("<td>chain normal</td>"), std::string::npos);
    const std::string table = read_bytes(out() + "/measure.csv");
    const std::vector<std::string> lines = split(table, '\n');
    EXPECT_EQ(lines.front(), COLUMNS);
    const std::vector<std::string> names = split(COLUMNS, ',');
    const Json whole = report();
    const Json& rows = whole["rows"];
    ASSERT_EQ(lines.size(), rows.size() + 1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::vector<std::string> fields = split(lines[i + 1], ',');
        ASSERT_EQ(fields.size(), names.size()) << lines[i + 1];
        for (std::size_t k = 0; k < names.size(); ++k) {
            SCOPED_TRACE(names[k] + " of " + lines[i + 1]);
            const Json& value = rows[i].at(names[k]);
            const std::string text = value.is_null()     ? ""
                                     : value.is_string() ? value.get<std::string>()
                                                         : value.dump();
            EXPECT_EQ(fields[k], text);
        }
        // The light is the same from everywhere: all that errs is storage, in 16 bits.
        EXPECT_LE(rows[i]["max"].get<double>(), 1.0 / 2048.0);
        const bool samples = rows[i]["method"].get<std::string>().ends_with("importance");
        EXPECT_EQ(rows[i]["samples"].is_number(), samples);
        EXPECT_EQ(rows[i]["fetches"].is_number(), samples);
        EXPECT_EQ(rows[i]["quality"].is_string(), rows[i]["method"] == "chain");
        EXPECT_EQ(rows[i]["spread"].is_null(), rows[i]["method"] == "exact");
    }

    // Any new measurement would have other times.
    run_well({"measure", "-o", "out", "--quick", sky, "--tasks", "prefilter"});
    EXPECT_EQ(read_bytes(out() + "/measure.csv"), table);
    for (const std::string name : {"error-time", "error-exponent", "cost-face"}) {
        const std::string file = out() + "/prefilter-" + name;
        EXPECT_NE(read_bytes(file + ".svg").find("<svg"), std::string::npos) << name;
        EXPECT_TRUE(read_bytes(file + ".png").starts_with("\x89PNG")) << name;
    }
    const std::string drawn = read_bytes(out() + "/index.html");
    EXPECT_NE(drawn.find("<svg"), std::string::npos);
    EXPECT_EQ(drawn.find("src="), std::string::npos); // nothing lies beside it

    // As if it had been stopped before the last one.
    Json stopped = whole;
    stopped["rows"].erase(rows.size() - 1);
    write_bytes(out() + "/measure.json", stopped.dump());
    EXPECT_EQ(measure({sky, "--tasks", "prefilter"}).status, 0);
    const Json resumed = report();
    ASSERT_EQ(resumed["rows"].size(), rows.size());
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) EXPECT_EQ(resumed["rows"][i], rows[i]);
    for (const char* const error : {"rms", "p999", "max", "image_rms", "mean_ratio"})
        EXPECT_EQ(resumed["rows"].back()[error], rows.back()[error]) << error;
}

TEST_F(MeasureVerb, RefusesToMixMeasurements) {
    const std::string sky = write_panorama("sky.exr");
    std::filesystem::create_directory(out());
    write_bytes(out() + "/measure.json", "{\"device\": \"another\"}");
    expect_refused(run({"measure", sky, "-o", "out"}), 1, "another device");
    write_bytes(out() + "/measure.json", "{");
    expect_refused(run({"measure", sky, "-o", "out"}), 1, "measure.json");
    expect_refused(run({"measure", sky, "-o", "sky.exr"}), 1, "folder");
}

TEST_F(MeasureVerb, RefusesWhatItCannotMeasure) {
    const std::string sky = write_panorama("sky.exr");
    expect_refused(run({"measure", sky}), 2, "-o");
    expect_refused(run({"measure", sky, "-o", "out", "--tasks", "gallery"}), 2, "--tasks");
    expect_refused(run({"measure", sky, "-o", "out", "--tasks", "shade,"}), 2, "--tasks");
    std::filesystem::create_directory(folder / "b");
    expect_refused(run({"measure", sky, write_panorama("b/sky.exr"), "-o", "out"}), 2, "sky");
    expect_refused(run({"measure", "none.exr", "-o", "out"}), 1, "none.exr");
    EXPECT_FALSE(std::filesystem::exists(out()));
}

} // namespace lobelia::test
