#include <nlohmann/json.hpp>

#include "cli_fixture.h"

// `lobelia plan` says what `render` and `prefilter` then do.
namespace lobelia::test {
namespace {

using Json = nlohmann::ordered_json;

class PlanVerb : public CliTest {
protected:
    Json json(const Arguments& arguments) const { return Json::parse(run_well(arguments)); }

    /// Expects the passes and images of the plan to be those of the work.
    static void expect_same(const Json& plan, const Json& work) {
        EXPECT_EQ(plan["method"], work["method"]);
        EXPECT_EQ(plan["quality"], work["quality"]);
        EXPECT_EQ(plan["images"], work["images"]);
        ASSERT_EQ(plan["passes"].size(), work["passes"].size());
        for (std::size_t i = 0; i < plan["passes"].size(); ++i)
            for (const char* key : {"name", "invocations", "bytes_read", "bytes_written"})
                EXPECT_EQ(plan["passes"][i][key], work["passes"][i][key]) << i << " " << key;
    }
};

TEST_F(PlanVerb, SaysWhatRenderDoes) {
    for (const Arguments& options : {Arguments{"--size", "24x16"},
                                     {"--size", "16x16", "--kd", "1", "--no-background"},
                                     {"--size", "16x16", "--method", "sh4", "--face", "64"},
                                     {"--size", "16x16", "--method", "kurt2019", "--blur", "8"},
                                     {"--size", "8x8", "--method", "reference", "--face", "16"}}) {
        Arguments plan{"plan", "--json"}, render{"render", "-o", "a.exr", "--json"};
        plan.insert(plan.end(), options.begin(), options.end());
        render.insert(render.end(), options.begin(), options.end());
        expect_same(json(plan), json(render));
    }
}

TEST_F(PlanVerb, SaysWhatPrefilterDoes) {
    const std::string panorama = write_panorama("sky.exr");
    expect_same(json({"plan", panorama, "--lambert", "--exponents", "16,64", "--json"}),
                json({"prefilter", panorama, "--lambert", "--exponents", "16,64", "-o", "a.exr",
                      "--json"}));
}

TEST_F(PlanVerb, PredictsTimes) {
    const Json plan = json({"plan", "--size", "32x32", "--json"});
    for (const Json& pass : plan["passes"])
        EXPECT_GE(pass[pass["cpu_ms"].is_null() ? "gpu_ms" : "cpu_ms"].get<double>(), 0.0);
    EXPECT_GT(plan["passes"].back()["cpu_ms"].get<double>() +
                  plan["passes"].front()["cpu_ms"].get<double>(),
              0.0);
}

TEST_F(PlanVerb, PredictsWhatAMethodMakesBesideTheBackgroundsMaps) {
    const Json plan =
        json({"plan", "--method", "kurt2019", "--blur", "8", "--size", "32x32", "--json"});
    for (const Json& pass : plan["passes"])
        if (pass["name"] == "mips") {
            EXPECT_GT(pass[pass["cpu_ms"].is_null() ? "gpu_ms" : "cpu_ms"].get<double>(), 0.0);
            return;
        }
    FAIL() << "no mips";
}

TEST_F(PlanVerb, SaysWhy) {
    const std::string text = run_well({"plan", "--kd", "0.5", "--size", "32x32", "--why"});
    for (const char* words : {"diffuse light: kd is above 0", "specular light: ks is 0",
                              "background: it is shown", "sphere", "panorama to cube"})
        EXPECT_NE(text.find(words), std::string::npos) << words << " in\n" << text;
    const Json plan = json({"plan", "--kd", "0.5", "--size", "32x32", "--why", "--json"});
    ASSERT_TRUE(plan["why"].is_array());
    EXPECT_EQ(plan["why"][1]["effect"], "specular light");
    EXPECT_EQ(plan["why"][1]["in"], false);
    EXPECT_GT(plan["why"][1]["bytes"], 0);
}

TEST_F(PlanVerb, RefusesWhatRenderRefuses) {
    expect_refused(run({"plan", "--kd", "0.8", "--ks", "0.8"}), 1, "ks");
    expect_refused(run({"plan", "--exponents", "16", "--method", "split-sum"}), 2, "--method");
}

} // namespace
} // namespace lobelia::test
