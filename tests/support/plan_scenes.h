#pragma once

#include <string>
#include <vector>

#include <lobelia/scene.h>

namespace lobelia::test {

/// A scene of docs/plan.md, which measure_plan times.
struct PlanScene {
    std::string name;
    std::vector<SceneMaterial> materials;
    bool background = true;
    bool constant = false;

    Scene scene() const {
        return {.materials = materials,
                .background = background,
                .constant = constant,
                .source_size = 256,
                .width = 512,
                .height = 512};
    }
};

inline SceneMaterial varying(float kd, float ks, float least, float most) {
    return {{kd, kd, kd}, {ks, ks, ks}, least, most};
}
inline SceneMaterial uniform(float kd, float ks, float n) {
    return varying(kd, ks, n, n);
}

/// The first has everything; the others are to cost less.
inline std::vector<PlanScene> plan_scenes() {
    std::vector<SceneMaterial> eight;
    for (int i = 0; i < 8; ++i) eight.push_back(uniform(0.3f, 0.6f, float(8 << i)));
    return {{"everything: kd, ks, n per pixel from 1 to 2048", {varying(0.3f, 0.6f, 1, 2048)}},
            {"mixed, n = 64", {uniform(0.3f, 0.6f, 64)}},
            {"diffuse only", {uniform(0.8f, 0, 1)}},
            {"diffuse only, no background", {uniform(0.8f, 0, 1)}, false},
            {"ks only, n = 4.8", {uniform(0, 0.6f, 4.8f)}},
            {"ks only, n = 16", {uniform(0, 0.6f, 16)}},
            {"mirror-like only, n = 2048", {uniform(0, 0.6f, 2048)}},
            {"mixed, n = 64, no background", {uniform(0.3f, 0.6f, 64)}, false},
            {"eight materials, n = 8 to 1024", eight},
            {"n per pixel from 8 to 256", {varying(0.3f, 0.6f, 8, 256)}},
            {"constant environment", {uniform(0.3f, 0.6f, 64)}, true, true},
            {"background alone", {}}};
}

} // namespace lobelia::test
