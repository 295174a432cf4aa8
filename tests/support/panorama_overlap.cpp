#include "support/panorama_overlap.h"

#include <algorithm>
#include <cmath>

namespace lobelia::oracle {
namespace {

// A row of a cube face: the points start + u right, u from -1 to 1.
struct Line {
    Direction start;
    Direction right;
    Direction at(double u) const { return start + u * right; }
};

// Where the line crosses the plane of a meridian, whose normal is `across`.
void cut_at_meridian(const Line& line, Direction across, std::vector<double>& cuts) {
    const double slope = dot(line.right, across);
    if (slope != 0) cuts.push_back(-dot(line.start, across) / slope);
}

// Where it crosses the cone of a latitude and of the opposite one.
void cut_at_latitude(const Line& line, double sine, std::vector<double>& cuts) {
    // (start.y + u right.y)^2 = sine^2 |start + u right|^2; start and right are orthogonal
    const double a = line.right.y * line.right.y - sine * sine * dot(line.right, line.right);
    const double b = line.start.y * line.right.y;
    const double c = line.start.y * line.start.y - sine * sine * dot(line.start, line.start);
    const double discriminant = b * b - a * c;
    if (discriminant < 0 || a == 0) return;
    for (double sign : {-1.0, 1.0}) cuts.push_back((-b + sign * std::sqrt(discriminant)) / a);
}

std::vector<double> cut(const Source& panorama, const Line& line, double first, double last) {
    std::vector<double> cuts{first, last};
    for (int column = 0; column < panorama.width(); ++column) {
        const double longitude = 2 * PI * (0.5 - double(column) / panorama.width());
        cut_at_meridian(line, {std::cos(longitude), 0, -std::sin(longitude)}, cuts);
    }
    for (int row = 0; row <= panorama.height(); ++row)
        cut_at_latitude(line, std::sin(PI * (0.5 - double(row) / panorama.height())), cuts);
    std::erase_if(cuts, [=](double u) { return u < first || u > last; });
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

const Rgb& texel_at(const Source& panorama, Direction d) {
    const Angles angles = panorama_angles(d);
    const int x = int((0.5 - angles.longitude / (2 * PI)) * panorama.width());
    const int y = int((0.5 - angles.latitude / PI) * panorama.height());
    return panorama.texel(0, std::clamp(x, 0, panorama.width() - 1),
                          std::clamp(y, 0, panorama.height() - 1));
}

} // namespace

Rgb average_over_cube_texel(const Source& panorama, int face, int x, int y, int size, int lines) {
    const FaceFrame& frame = cube_face(face);
    const double first = 2.0 * x / size - 1;
    const double last = 2.0 * (x + 1) / size - 1;
    Rgb sum{};
    double solid_angle = 0;
    for (int i = 0; i < lines; ++i) {
        const double v = 2.0 * (y + (i + 0.5) / lines) / size - 1;
        const Line line{frame.outwards + v * frame.down, frame.right};
        // The primitive of the solid angle per du dv, (1 + u^2 + v^2)^(-3/2), along u.
        const auto primitive = [v](double u) {
            return u / ((1 + v * v) * std::sqrt(1 + u * u + v * v));
        };
        const std::vector<double> cuts = cut(panorama, line, first, last);
        for (std::size_t piece = 1; piece < cuts.size(); ++piece) {
            const double part = primitive(cuts[piece]) - primitive(cuts[piece - 1]);
            const Rgb& light = texel_at(panorama, line.at(0.5 * (cuts[piece - 1] + cuts[piece])));
            for (std::size_t c = 0; c < 3; ++c) sum[c] += part * light[c];
            solid_angle += part;
        }
    }
    for (double& channel : sum) channel /= solid_angle;
    return sum;
}

} // namespace lobelia::oracle
