#include "support/oracle.h"

#include <gtest/gtest.h>

#include "support/environments.h"

// One bright texel on black: its own integral, relative to itself, however the horizons cut it.
namespace lobelia::oracle {
namespace {

using Polygon = std::vector<Direction>;

// The part of a spherical polygon on the side of `axis`.
Polygon clipped(const Polygon& polygon, Direction axis) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Direction from = polygon[i];
        const Direction to = polygon[(i + 1) % polygon.size()];
        const double a = dot(from, axis);
        const double b = dot(to, axis);
        if (a > 0) kept.push_back(from);
        if ((a > 0) != (b > 0)) kept.push_back(normalised(std::abs(b) * from + std::abs(a) * to));
    }
    return kept;
}

// Van Oosterom & Strackee 1983, "The Solid Angle of a Plane Triangle".
double solid_angle(const Polygon& polygon) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const Direction a = polygon[0];
        const Direction b = polygon[i];
        const Direction c = polygon[i + 1];
        sum += 2 * std::atan2(std::abs(dot(a, cross(b, c))), 1 + dot(a, b) + dot(b, c) + dot(c, a));
    }
    return sum;
}

// The integral of w . axis over a polygon (Lambert 1760, "Photometria").
double cosine_integral(const Polygon& polygon, Direction axis) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Direction from = polygon[i];
        const Direction to = polygon[(i + 1) % polygon.size()];
        const Direction across = cross(from, to);
        if (length(across) == 0) continue;
        sum += 0.5 * angle(from, to) * dot(across, axis) / length(across);
    }
    return std::abs(sum);
}

struct LitTexel {
    Source source;
    int layer;
    int x;
    int y;
};

LitTexel light_one(Source source, Random& random) {
    for (std::size_t i = 0; i < source.texels().size(); ++i) {
        const int width = source.width();
        const int row = int(i) / width;
        source.texel(row / source.height(), int(i) % width, row % source.height()) = {};
    }
    const int layer = random.below(source.layers());
    const int x = random.below(source.width());
    const int y = random.below(source.height());
    source.texel(layer, x, y) = {1, 1, 1};
    return {std::move(source), layer, x, y};
}

// An axis whose horizon passes the texel's middle at about `gap` radians.
Direction grazing_axis(const LitTexel& lit, double gap, Random& random) {
    const Direction middle = lit.source.direction(lit.layer, lit.x, lit.y);
    const Direction across = normalised(cross(middle, random.direction()));
    return normalised(across + gap * middle);
}

double texel_size(const Source& source) {
    return PI / (source.is_cube() ? 2 * source.width() : source.height());
}

Polygon outline(const LitTexel& lit) {
    const int size = lit.source.width();
    return {cube_direction(lit.layer, lit.x, lit.y, size),
            cube_direction(lit.layer, lit.x + 1, lit.y, size),
            cube_direction(lit.layer, lit.x + 1, lit.y + 1, size),
            cube_direction(lit.layer, lit.x, lit.y + 1, size)};
}

TEST(OracleTexel, CutByTheHorizonIsASphericalPolygon) {
    Random random(1);
    for (int size : {1, 2, 7, 64, 256}) {
        const LitTexel lit = light_one(cube_of(size, [](Direction) { return Rgb{}; }), random);
        for (int i = 0; i < 20; ++i) {
            const double gap = random.between(-0.6, 1) * texel_size(lit.source);
            const Direction axis = grazing_axis(lit, gap, random);
            const Polygon seen = clipped(outline(lit), axis);
            if (seen.size() < 3) continue;
            const double area = solid_angle(seen);
            const double cosine = cosine_integral(seen, axis);
            const double whole = lit.source.solid_angle(lit.x, lit.y);
            SCOPED_TRACE("cube " + std::to_string(size) + " case " + std::to_string(i));
            // Shares below 1e-4 of the texel are differences of rounded numbers in the polygon.
            if (area < 1e-4 * whole) continue;
            EXPECT_NEAR(lobe_average(lit.source, axis, 0)[0] * 2 * PI / area, 1, 1e-7);
            EXPECT_NEAR(lobe_average(lit.source, axis, 1)[0] * PI / cosine, 1, 1e-7);
        }
    }
}

TEST(OracleTexel, CutByBothHorizonsIsASphericalPolygon) {
    Random random(2);
    for (int size : {1, 2, 7, 64}) {
        const LitTexel lit = light_one(cube_of(size, [](Direction) { return Rgb{}; }), random);
        for (int i = 0; i < 20; ++i) {
            const double scale = texel_size(lit.source);
            const Direction axis = grazing_axis(lit, random.between(-0.4, 0.6) * scale, random);
            const Direction normal = grazing_axis(lit, random.between(-0.4, 0.6) * scale, random);
            const Polygon seen = clipped(clipped(outline(lit), axis), normal);
            if (seen.size() < 3) continue;
            if (solid_angle(seen) < 1e-3 * lit.source.solid_angle(lit.x, lit.y)) continue;
            const double exact = cosine_integral(seen, normal) / PI;
            EXPECT_NEAR(specular_average(lit.source, normal, axis, 0)[0] / exact, 1, 1e-6)
                << "cube " << size << " case " << i;
        }
    }
}

// Midpoints of 500 x 500 parts of the texel.
double brute_force(const LitTexel& lit, Direction axis, double n) {
    const int parts = 500;
    const int width = lit.source.width();
    const int height = lit.source.height();
    double sum = 0;
    for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i) {
            const Direction w = panorama_direction(lit.x + (i + 0.5) / parts,
                                                   lit.y + (j + 0.5) / parts, width, height);
            const double cosine = dot(w, axis);
            if (cosine > 0) sum += std::pow(cosine, n) * std::hypot(w.x, w.z);
        }
    const double area = 2 * PI / width * PI / height / parts / parts;
    return (n + 1) / (2 * PI) * sum * area;
}

TEST(OracleTexel, OfAPanoramaAgreesWithBruteForce) {
    Random random(3);
    for (auto [width, height] : {std::pair{2, 1}, {3, 2}, {17, 9}, {64, 32}})
        for (double n : {0.0, 0.5, 1.0, 4.8, 40.0}) {
            const LitTexel lit =
                light_one(panorama_of(width, height, [](Direction) { return Rgb{}; }), random);
            const double gap = n < 2 ? random.between(-0.2, 0.5) * texel_size(lit.source) : 0.55;
            const Direction axis = grazing_axis(lit, gap, random);
            const double exact = lobe_average(lit.source, axis, n)[0];
            EXPECT_NEAR(brute_force(lit, axis, n) / exact, 1, n == 0 ? 1e-3 : 1e-4)
                << width << " x " << height << " n " << n;
        }
}

TEST(OracleTexel, HasConverged) {
    Random random(4);
    const auto black = [](Direction) { return Rgb{}; };
    const Options finer{Normalise::analytically, 2};
    for (int i = 0; i < 120; ++i) {
        const double n = i % 5 == 0 ? random.below(6) : std::exp(random.between(-3, 5));
        const int size = int(std::exp(random.between(0, 4)));
        const LitTexel lit =
            light_one(i % 2 ? cube_of(size, black) : panorama_of(2 * size, size, black), random);
        const double gap = random.between(-0.5, 2) * texel_size(lit.source);
        const Direction axis = grazing_axis(lit, n < 20 ? gap : random.between(0.6, 3), random);
        const Direction normal =
            grazing_axis(lit, random.between(-0.5, 1.5) * texel_size(lit.source), random);
        SCOPED_TRACE((i % 2 ? "cube " : "panorama ") + std::to_string(size) + " n " +
                     std::to_string(n) + " case " + std::to_string(i));
        const double rough = lobe_average(lit.source, axis, n)[0];
        const double fine = lobe_average(lit.source, axis, n, finer)[0];
        EXPECT_NEAR(rough, fine, 1e-7 * fine + 1e-16);
        const double shaded = specular_average(lit.source, normal, axis, n)[0];
        EXPECT_NEAR(shaded, specular_average(lit.source, normal, axis, n, finer)[0],
                    1e-6 * shaded + 1e-16);
    }
}

} // namespace
} // namespace lobelia::oracle
