#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "support/direction.h"

namespace lobelia::oracle {

struct TexelTable;

/// Angles of a direction on a panorama, in radians: longitude 0 is +Z and grows towards +X;
/// latitude grows towards +Y.
struct Angles {
    double longitude;
    double latitude;
};

/// Direction of the point (x, y) of a width x height panorama, in texels from the top left corner:
/// the middle of texel (i, j) is (i + 0.5, j + 0.5).
Direction panorama_direction(double x, double y, int width, int height);
Angles panorama_angles(Direction direction);

/// Frame of a face of a Vulkan cube map (+X -X +Y -Y +Z -Z): a point of the face is
/// outwards + s right + t down with s and t from -1 to 1, s along a row and t down the rows.
struct FaceFrame {
    Direction right;
    Direction down;
    Direction outwards;
};
const FaceFrame& cube_face(int face);

/// Direction of the point (x, y) of a face of `size` texels a side, in texels as above.
Direction cube_direction(int face, double x, double y, int size);

/// The face that a direction meets and where, in texels as above.
struct FacePoint {
    int face;
    double x;
    double y;
};
FacePoint cube_point(Direction direction, int size);

/// Solid angles in steradians, exact. A panorama's depends on the row alone.
double panorama_texel_solid_angle(int y, int width, int height);
double cube_texel_solid_angle(int x, int y, int size);

/// An environment: each texel is constant radiance over its own solid angle, on a panorama (one
/// layer) or a cube map (six square layers). Rows from the top, layers one after the other. Tables
/// of directions are made with it (2 us a column or row) and shared between copies.
class Source {
public:
    /// `texels` holds width * height values, any sizes from 1 x 1.
    static Source panorama(int width, int height, std::vector<Rgb> texels);
    /// `texels` holds 6 * size * size values.
    static Source cube(int size, std::vector<Rgb> texels);
    /// The same from floats R G B A, as images are held in memory; A is dropped.
    static Source panorama(int width, int height, std::span<const float> rgba);
    static Source cube(int size, std::span<const float> rgba);

    bool is_cube() const { return layers_ == 6; }
    int width() const { return width_; }
    int height() const { return height_; }
    int layers() const { return layers_; }
    const std::vector<Rgb>& texels() const { return texels_; }
    std::size_t index(int layer, int x, int y) const;
    const Rgb& texel(int layer, int x, int y) const { return texels_[index(layer, x, y)]; }
    Rgb& texel(int layer, int x, int y) { return texels_[index(layer, x, y)]; }

    Direction direction(int layer, int x, int y) const; // of the texel's middle
    double solid_angle(int x, int y) const;
    Rgb mean() const; // over the sphere
    /// R G B 1 floats.
    std::vector<float> rgba() const;

    const TexelTable& table() const { return *table_; }

private:
    Source(int width, int height, int layers, std::vector<Rgb> texels);

    int width_;
    int height_;
    int layers_;
    std::vector<Rgb> texels_;
    std::shared_ptr<const TexelTable> table_;
};

} // namespace lobelia::oracle
