// A mesh with a normal map, shaded by the engine's own pipeline with Lobelia's GLSL: `mesh knot
// FILE WIDTH HEIGHT [SAMPLES]` averages SAMPLES x SAMPLES of each pixel; `mesh sphere FILE` shows
// what `lobelia render` does.
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "lighting.h"
#include "pipeline.h"
#include "shapes.h"

namespace {

/// As in mesh.glsl; of a camera at `eye` that looks at the origin, +Y up.
struct Camera {
    std::array<float, 16> clip_from_world; // column by column
    std::array<float, 4> eye, right, down, ahead;

    static Camera create(const Vector& eye, float half_width, float half_height) {
        constexpr float NEAR = 0.1f;
        const Vector ahead = normalised(-1.0f * eye);
        const Vector right = normalised(cross(ahead, {0, 1, 0}));
        const Vector down = cross(ahead, right);
        const auto row = [&](const Vector& axis, float scale) {
            const Vector scaled = 1 / scale * axis;
            return std::array{scaled[0], scaled[1], scaled[2], -dot(scaled, eye)};
        };
        const std::array x = row(right, half_width), y = row(down, half_height), w = row(ahead, 1);
        Camera camera{};
        for (std::size_t i = 0; i < 4; ++i) { // depth 1 - NEAR / w
            const float z = w[i] - (i == 3 ? NEAR : 0);
            std::memcpy(&camera.clip_from_world[4 * i], std::array{x[i], y[i], z, w[i]}.data(), 16);
        }
        const auto four = [](const Vector& v) { return std::array{v[0], v[1], v[2], 0.0f}; };
        camera.eye = four(eye);
        camera.right = four(half_width * right);
        camera.down = four(half_height * down);
        camera.ahead = four(ahead);
        return camera;
    }
};

struct Uploaded {
    Buffer vertices, indices;
    std::uint32_t count;

    static Uploaded create(const Engine& engine, const Mesh& mesh) {
        const auto upload = [&](const auto& from, VkBufferUsageFlags usage) {
            const Buffer buffer = engine.make_buffer(from.size() * sizeof from[0], usage);
            std::memcpy(buffer.data, from.data(), from.size() * sizeof from[0]);
            return buffer;
        };
        return {upload(mesh.vertices, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT),
                upload(mesh.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT),
                std::uint32_t(mesh.indices.size())};
    }
};

struct Texture {
    Image image;
    Buffer texels;

    static Texture create(const Engine& engine, const Relief& relief) {
        const Texture texture{
            engine.make_image(
                {.format = VK_FORMAT_R8G8B8A8_UNORM,
                 .width = Relief::SIZE,
                 .height = Relief::SIZE,
                 .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT}),
            engine.make_buffer(relief.texels.size() * 4, VK_BUFFER_USAGE_TRANSFER_SRC_BIT)};
        std::memcpy(texture.texels.data, relief.texels.data(), relief.texels.size() * 4);
        return texture;
    }
    void record(VkCommandBuffer commands) const {
        transition(commands, image.handle, VK_IMAGE_LAYOUT_UNDEFINED,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        const VkBufferImageCopy region{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                       .imageExtent = {Relief::SIZE, Relief::SIZE, 1}};
        vkCmdCopyBufferToImage(commands, texels.handle, image.handle,
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
        transition(commands, image.handle, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                   VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    }
};

void draw(const Engine& engine, bool knot, const char* path, std::uint32_t width,
          std::uint32_t height, std::uint32_t samples) {
    const lobelia::Device device{engine.device, vkGetDeviceProcAddr};
    const Lighting lighting =
        knot ? Lighting::create(engine, device, 90, 700) : Lighting::create(engine, device, 64, 64);
    const Canvas canvas = Canvas::create(engine, samples * width, samples * height);
    const Image depth = engine.make_image({.format = VK_FORMAT_D32_SFLOAT,
                                           .width = canvas.width,
                                           .height = canvas.height,
                                           .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT});
    const Uploaded mesh = Uploaded::create(engine, knot ? make_knot(0.22f) : make_sphere());
    const Texture relief = Texture::create(engine, make_relief());
    const float half_height = knot ? 0.4f : 0.26794919f; // the tangent of 15 degrees
    const Camera camera = Camera::create(knot ? Vector{1.0f, 0.5f, 3.4f} : Vector{0, 0, 4},
                                         half_height * float(width) / float(height), half_height);

    // [resources]
    const Pipeline shading = Pipeline::create(
        engine, {.vertex = MESH_VERTEX,
                 .fragment = MESH_FRAGMENT,
                 .resources = {image(lighting.diffuse), image(lighting.ladder),
                               image(lighting.tables), uniform(lighting.state),
                               image(relief.image, VK_SAMPLER_ADDRESS_MODE_REPEAT)},
                 .push_constants = sizeof camera,
                 .vertices = true,
                 .constant = !knot});
    // [resources]
    const Pipeline background = Pipeline::create(engine, {.vertex = BACKGROUND_VERTEX,
                                                          .fragment = BACKGROUND_FRAGMENT,
                                                          .resources = {image(lighting.cube)},
                                                          .push_constants = sizeof camera});
    const VkCommandBuffer commands = engine.begin();
    lighting.record(commands);
    relief.record(commands);
    canvas.begin(commands, &depth);
    shading.bind(commands, &camera);
    const VkDeviceSize start = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &mesh.vertices.handle, &start);
    vkCmdBindIndexBuffer(commands, mesh.indices.handle, 0, VK_INDEX_TYPE_UINT32);
    vkCmdDrawIndexed(commands, mesh.count, 1, 0, 0, 0);
    background.bind(commands, &camera);
    vkCmdDraw(commands, 3, 1, 0, 0);
    canvas.end(commands);
    canvas.read_back(commands);
    engine.submit_and_wait(commands);
    canvas.write(path, samples);

    shading.destroy(engine);
    background.destroy(engine);
    engine.destroy(depth);
    engine.destroy(relief.image);
    for (const Buffer& buffer : {mesh.vertices, mesh.indices, relief.texels})
        engine.destroy(buffer);
    canvas.destroy(engine);
    lighting.destroy(engine);
}

} // namespace

int main(int count, char** arguments) {
    const bool knot = std::string_view(arguments[1]) == "knot";
    const auto number = [&](int i, int otherwise) {
        return std::uint32_t(count > i ? std::atoi(arguments[i]) : otherwise);
    };
    const VkPhysicalDeviceVulkan13Features features{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES, .dynamicRendering = true};
    Engine engine = Engine::create(VK_API_VERSION_1_3, &features);
    draw(engine, knot, arguments[2], number(3, 96), number(4, 96), number(5, 1));
    engine.destroy();
}
