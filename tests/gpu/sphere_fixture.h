#pragma once

#include <cmath>
#include <numbers>

#include <lobelia/host/work.h>

#include "host/colour_target.h"
#include "support/camera.h"
#include "support/environments.h"
#include "support/gpu_sources.h"
#include "support/gpu_test.h"
#include "support/oracle.h"

namespace lobelia::test {

inline std::array<float, 3> floats(oracle::Direction d) {
    return {float(d.x), float(d.y), float(d.z)};
}
inline oracle::Direction doubles(const std::array<float, 3>& a) {
    return {a[0], a[1], a[2]};
}

/// The oracle's camera for a view; it knows of no rotation.
inline oracle::Camera oracle_camera(const SphereView& view) {
    const Camera& camera = view.camera;
    return {doubles(camera.eye), doubles(camera.target),
            doubles(camera.up),  double(camera.vertical_field_of_view),
            int(view.width),     int(view.height)};
}

/// A camera from which part of the sphere is seen, near or far.
inline Camera random_camera(oracle::Random& random) {
    const double distance = std::exp(random.between(std::log(1.02), std::log(30.0)));
    const oracle::Direction eye = distance * random.direction();
    const oracle::Direction target = 0.8 * random.unit() * random.direction();
    const double sphere = 2.0 * std::asin(1.0 / distance) * 180.0 / std::numbers::pi;
    return {floats(eye), floats(target), floats(random.direction()),
            float(std::min(sphere * random.between(0.5, 2.0), 150.0))};
}

inline std::string text(const Camera& camera) {
    const auto triple = [](const std::array<float, 3>& a) {
        return std::to_string(a[0]) + "," + std::to_string(a[1]) + "," + std::to_string(a[2]);
    };
    return "eye " + triple(camera.eye) + " target " + triple(camera.target) + " up " +
           triple(camera.up) + " fov " + std::to_string(camera.vertical_field_of_view);
}

inline Material grey(float diffuse, float specular, float exponent) {
    return {{diffuse, diffuse, diffuse}, {specular, specular, specular}, exponent};
}

/// The sphere pass alone, with whatever it is given to read.
class SpherePicture {
public:
    SpherePicture(host::Gpu& gpu, std::uint32_t width, std::uint32_t height,
                  const SphereShading& shading)
        : gpu_(gpu), target_(value_of(host::ColourTarget::create(gpu, width, height))),
          pass_(value_of(
              Sphere::create(gpu.device(), {.render_pass = target_.render_pass()}, shading))) {}

    host::Image draw(const SphereSources& sources, const SphereView& view) const {
        const SphereJob job = value_of(pass_.bind(sources));
        value_of(gpu_.submit([&](VkCommandBuffer commands) {
            target_.record(commands, [&](VkCommandBuffer inside) { job.record(inside, view); });
        }));
        return value_of(gpu_.download(target_.image(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL));
    }

private:
    host::Gpu& gpu_;
    host::ColourTarget target_;
    Sphere pass_;
};

/// A test that looks at pictures of the sphere.
class SphereTest : public GpuTest {
protected:
    /// Light of one colour goes through the maps like any other: that it need not is not told.
    host::GpuEnvironment upload(const host::Image& image, std::uint32_t face = 0) {
        host::GpuEnvironment environment = value_of(host::upload_environment(gpu, image, face));
        environment.constant = false;
        return environment;
    }
    host::Image draw(const host::GpuEnvironment& environment, const SphereView& view,
                     SphereMethod method = SphereMethod::split_sum) {
        return value_of(host::render(gpu, environment, {.view = view, .method = method})).picture;
    }
};

} // namespace lobelia::test
