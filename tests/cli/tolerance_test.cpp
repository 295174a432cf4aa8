#include <nlohmann/json.hpp>

#include "cli_fixture.h"

// `--tolerance` picks what keeps it, and says so.
namespace lobelia::test {
namespace {

using Json = nlohmann::ordered_json;

class ToleranceOption : public CliTest {
protected:
    /// Runs it well; what it said on stderr is in `said`.
    Json json(const Arguments& arguments, std::string& said) const {
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        said = result.err;
        return Json::parse(result.out);
    }
};

TEST_F(ToleranceOption, OfRenderPicksFinerMethodsForSmallerErrors) {
    double before = 1e9;
    std::string methods, said;
    for (const char* tolerance : {"0.5", "0.07", "0.03"}) {
        const Json report = json({"render", "--size", "16x16", "--ks", "0.8", "-n", "64", "-o",
                                  "a.exr", "--tolerance", tolerance, "--json"},
                                 said);
        const double expected = report["expected_error"].get<double>();
        EXPECT_LE(expected, std::stod(tolerance));
        EXPECT_LE(expected, before);
        before = expected;
        const std::string method = report["method"].get<std::string>();
        EXPECT_NE(said.find(std::string(tolerance) + ": " + method), std::string::npos) << said;
        methods += method + " " + report["quality"].get<std::string>() + "\n";
    }
    EXPECT_NE(said.find("the best that is cheaper"), std::string::npos) << said;
    EXPECT_TRUE(methods.starts_with("one-tap fast")) << methods;
}

TEST_F(ToleranceOption, OfPrefilterPicksByAllExponents) {
    const std::string panorama = write_panorama("sky.exr");
    std::string said;
    const auto report = [&](const char* exponents, const char* tolerance) {
        return json({"prefilter", panorama, "--exponents", exponents, "--face", "4", "-o", "a.exr",
                     "--tolerance", tolerance, "--json"},
                    said);
    };
    const Json loose = report("1", "4"); // of faces of 16 texels little is promised
    EXPECT_EQ(loose["method"], "chain");
    EXPECT_EQ(loose["quality"], "fast");
    const Json tight = report("1,2", "0.0001");
    EXPECT_EQ(tight["method"], "exact");
    EXPECT_LE(tight["expected_error"].get<double>(), 1e-4);
}

TEST_F(ToleranceOption, IsRefusedWhereNothingPromisesIt) {
    const std::string panorama = write_panorama("sky.exr");
    expect_refused(run({"render", "--ks", "1", "-o", "a.exr", "--tolerance", "1e-7"}), 1,
                   "the least is 0.0001, by reference");
    expect_refused(
        run({"prefilter", panorama, "--exponents", "1", "-o", "a.exr", "--tolerance", "1e-7"}), 1,
        "the least is 1e-05, by exact");
}

TEST_F(ToleranceOption, ExcludesWhatItChooses) {
    const std::string panorama = write_panorama("sky.exr");
    for (const Arguments& more : {Arguments{"--method", "two-tap"}, {"--quality", "high"}}) {
        Arguments arguments{"render", "-o", "a.exr", "--tolerance", "0.1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expect_refused(run(arguments), 2, "--tolerance");
    }
    expect_refused(run({"prefilter", panorama, "--exponents", "1", "-o", "a.exr", "--tolerance",
                        "0.1", "--method", "chain"}),
                   2, "--tolerance");
    for (const char* wrong : {"0", "-1", "nan", "little"})
        expect_refused(run({"render", "-o", "a.exr", "--tolerance", wrong}), 2, "--tolerance");
}

TEST_F(ToleranceOption, OfAPlanIsThatOfTheWork) {
    std::string said;
    const Json plan = json({"plan", "--size", "16x16", "--tolerance", "0.05", "--json"}, said);
    const Json work =
        json({"render", "--size", "16x16", "-o", "a.exr", "--tolerance", "0.05", "--json"}, said);
    for (const char* key : {"method", "quality", "expected_error"}) EXPECT_EQ(plan[key], work[key]);
    const std::string table = run_well({"plan", "--size", "16x16"});
    EXPECT_NE(table.find("expected error: "), std::string::npos) << table;
}

TEST_F(ToleranceOption, HasNoErrorForMethodsThatPromiseNone) {
    std::string said;
    EXPECT_TRUE(json({"render", "--size", "16x16", "-o", "a.exr", "--method", "kurt2019", "--json"},
                     said)["expected_error"]
                    .is_null());
}

} // namespace
} // namespace lobelia::test
