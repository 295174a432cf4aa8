#include <algorithm>
#include <cmath>

#include "prefilter_fixture.h"

// What must not make a difference: the run, how it is split, the scale, the order of the list, and
// which way is up.
namespace lobelia::test {
namespace {

using oracle::Direction;
using oracle::Scene;

const std::vector<float> SEVERAL{0.5f, 0, 4.8f, 45, 64, 700, 1e4f};

void expect_same_state(const PrefilterState& a, const PrefilterState& b) {
    EXPECT_EQ(a.threshold, b.threshold);
    EXPECT_EQ(a.scale, b.scale);
    ASSERT_EQ(a.sun_count, b.sun_count);
    for (std::uint32_t i = 0; i < a.sun_count; ++i) {
        EXPECT_EQ(a.suns[i].direction, b.suns[i].direction);
        EXPECT_EQ(a.suns[i].energy, b.suns[i].energy);
    }
}

class PrefilterSymmetryTest : public PrefilterTest {
protected:
    std::vector<std::vector<float>> stored_maps(const Prefiltered& made) {
        std::vector<std::vector<float>> maps;
        for (std::size_t i = 0; i < made.maps.size(); ++i) maps.push_back(stored(made, i).texels);
        return maps;
    }
};

TEST_F(PrefilterSymmetryTest, GivesTheSameBitsOnEveryRunAndForEverySplit) {
    const host::GpuImage source = on_device(gpu, image_of(oracle::random_cube(Scene::suns, 64, 5)));
    const Wanted wanted{SEVERAL, true};
    const Prefiltered first = make(source, wanted);
    EXPECT_GT(first.found().sun_count, 0u);
    const std::vector<std::vector<float>> maps = stored_maps(first);
    const std::uint32_t passes = first.plan.pass_count();
    std::vector<std::vector<std::uint32_t>> splits{
        {}, std::vector<std::uint32_t>(passes, 1), {0, 3, 0, 2}, {passes / 2}, {passes}};
    for (const std::vector<std::uint32_t>& split : splits) {
        const Prefiltered again = make(source, wanted, split);
        expect_same_state(again.found(), first.found());
        EXPECT_TRUE(stored_maps(again) == maps) << "split in " << split.size();
    }
}

TEST_F(PrefilterSymmetryTest, ScalesByPowersOfTwoExactly) {
    for (Scene scene : {Scene::noise, Scene::suns}) {
        const host::Image image = image_of(oracle::random_cube(scene, 64, 6));
        const Prefiltered made = make(image, {SEVERAL, true});
        const std::vector<std::vector<float>> maps = stored_maps(made);
        for (int k : {-20, 1, 40}) {
            host::Image scaled = image;
            for (float& value : scaled.texels) value = std::ldexp(value, k);
            const Prefiltered other = make(scaled, {SEVERAL, true});
            EXPECT_TRUE(stored_maps(other) == maps) << name(scene) << " times 2^" << k;
            EXPECT_EQ(other.found().scale, std::ldexp(made.found().scale, -k));
            ASSERT_EQ(other.found().sun_count, made.found().sun_count);
            for (std::uint32_t i = 0; i < made.found().sun_count; ++i) {
                EXPECT_EQ(other.found().suns[i].direction, made.found().suns[i].direction);
                EXPECT_EQ(other.found().suns[i].energy,
                          std::ldexp(1.0f, k) * made.found().suns[i].energy);
            }
        }
    }
}

TEST_F(PrefilterSymmetryTest, MakesEachMapAsIfAlone) {
    // Unsorted, duplicates, and more than one group of direct sums.
    const std::vector<float> odd{64,     0.25f, 700, 64,    1,     0.5f, 0,     4.8f,
                                 0.125f, 1e6f,  45,  44.9f, 0.25f, 2048, 0.75f, 1e4f};
    const host::GpuImage source = on_device(gpu, image_of(oracle::random_cube(Scene::suns, 64, 7)));
    const Prefiltered all = make(source, {odd, true});
    std::vector<float> sorted = odd;
    std::sort(sorted.begin(), sorted.end());
    const Prefiltered in_order = make(source, {sorted});
    expect_same_state(in_order.found(), all.found());
    for (std::size_t i = 0; i < odd.size(); ++i) {
        const std::size_t other =
            std::size_t(std::find(sorted.begin(), sorted.end(), odd[i]) - sorted.begin());
        EXPECT_TRUE(stored(all, i).texels == stored(in_order, other).texels) << "n " << odd[i];
    }
    EXPECT_TRUE(stored(all, 0).texels == stored(all, 3).texels);
}

TEST_F(PrefilterSymmetryTest, TakesLongLists) {
    std::vector<float> many;
    for (int i = 0; i < 40; ++i) many.push_back(std::pow(2.0f, float(i) / 2 - 3));
    const Prefiltered made = make(even_cube(32, 1, 2, 3), {many, true});
    ASSERT_EQ(made.maps.size(), 41u);
    for (std::size_t map = 0; map < made.maps.size(); ++map)
        for (const Average& average : read(made, map, oracle::test_directions(20, 8)))
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(average[c], float(c + 1), 1e-3f * float(c + 1)) << many[map % 40];
}

// A rotation that takes the cube to itself: axis i of the result is `sign[i]` times axis `from[i]`.
struct CubeRotation {
    std::array<int, 3> from;
    std::array<int, 3> sign;

    Direction operator()(Direction d) const {
        const double axes[] = {d.x, d.y, d.z};
        return {sign[0] * axes[from[0]], sign[1] * axes[from[1]], sign[2] * axes[from[2]]};
    }
};

std::vector<CubeRotation> cube_rotations() {
    std::vector<CubeRotation> rotations;
    std::array<int, 3> from{0, 1, 2};
    do {
        const bool even = (from[1] - from[0] + 3) % 3 == 1;
        for (int signs = 0; signs < 8; ++signs) {
            const std::array<int, 3> sign{signs & 1 ? -1 : 1, signs & 2 ? -1 : 1,
                                          signs & 4 ? -1 : 1};
            if ((sign[0] * sign[1] * sign[2] == 1) == even) rotations.push_back({from, sign});
        }
    } while (std::next_permutation(from.begin(), from.end()));
    return rotations;
}

host::Image rotated(const host::Image& cube, const CubeRotation& rotation) {
    host::Image result = cube;
    const int size = int(cube.width);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const oracle::FacePoint from = oracle::cube_point(
                    rotation(oracle::cube_direction(face, x + 0.5, y + 0.5, size)), size);
                std::copy_n(cube.texel(std::uint32_t(from.face), std::uint32_t(from.x),
                                       std::uint32_t(from.y)),
                            4,
                            result.texel(std::uint32_t(face), std::uint32_t(x), std::uint32_t(y)));
            }
    return result;
}

constexpr double SUN_ROUNDING = 1e-6; // of a few sums and a unit vector in 32 bits

// The distance to the next half.
double half_step(double value) {
    return std::ldexp(1.0, std::max(std::ilogb(std::max(value, 0x1p-14)), -14) - 10);
}

class PrefilterRotationTest : public PrefilterTest {
protected:
    const Wanted halves{{0.5f, 4.8f, 45, 64, 700, 1e4f}, true};

    // Sums in another order may round a texel to the half beside it.
    void expect_stored_next_to_it(const Prefiltered& straight, const Prefiltered& turned,
                                  const CubeRotation& rotation) {
        for (std::size_t map = 0; map < straight.maps.size(); ++map) {
            const host::Image expected = rotated(stored(straight, map), rotation);
            const host::Image found = stored(turned, map);
            for (std::size_t i = 0; i < expected.texels.size(); ++i) {
                const double value = double(expected.texels[i]);
                const double difference = std::abs(double(found.texels[i]) - value);
                ASSERT_LE(difference, half_step(value)) << "map " << map << " at " << i;
            }
        }
    }

    // The largest relative difference between the maps of the rotated environment and the rotated
    // maps, as they are read.
    double difference(const Prefiltered& straight, const Prefiltered& turned,
                      const CubeRotation& rotation) {
        const Directions axes = oracle::test_directions(400, 9);
        Directions there;
        for (const Direction& axis : axes) there.push_back(rotation(axis));
        double worst = 0;
        for (std::size_t map = 0; map < straight.maps.size(); ++map) {
            const std::vector<Average> a = read(turned, map, axes);
            const std::vector<Average> b = read(straight, map, there);
            for (std::size_t i = 0; i < a.size(); ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    worst = std::max(worst, std::abs(double(a[i][c]) / double(b[i][c]) - 1));
        }
        return worst;
    }

    void expect_same_suns(const Prefiltered& straight, const Prefiltered& turned,
                          const CubeRotation& rotation) {
        const PrefilterState& suns = straight.found();
        ASSERT_EQ(turned.found().sun_count, suns.sun_count);
        for (std::uint32_t i = 0; i < suns.sun_count; ++i) {
            const vec4& to = turned.found().suns[i].direction;
            const vec4& from = suns.suns[i].direction;
            const Direction back = rotation({to.x, to.y, to.z});
            EXPECT_LE(length(back - Direction{from.x, from.y, from.z}), SUN_ROUNDING);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(turned.found().suns[i].energy[c] / suns.suns[i].energy[c], 1,
                            SUN_ROUNDING);
        }
    }
};

TEST_F(PrefilterRotationTest, TurnsWithTheEnvironment) {
    const host::Image image = image_of(oracle::random_cube(Scene::noise, 64, 10));
    const Prefiltered straight = make(image, halves);
    EXPECT_EQ(straight.found().sun_count, 0u);
    for (const CubeRotation& rotation : cube_rotations())
        expect_stored_next_to_it(straight, make(rotated(image, rotation), halves), rotation);
}

// What is asked of an environment with suns. Rounding to halves, 4.9e-4, would hide it in maps of
// halves; the chain's levels are halves in either case, but kernels average them.
constexpr double WITH_SUNS = 2e-4;

TEST_F(PrefilterRotationTest, TurnsWithItsSuns) {
    Wanted floats = halves;
    floats.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    const host::Image image = image_of(oracle::random_cube(Scene::suns, 64, 11));
    const Prefiltered straight = make(image, floats);
    const Prefiltered straight_halves = make(image, halves);
    EXPECT_GT(straight.found().sun_count, 0u);
    double worst = 0;
    for (const CubeRotation& rotation : cube_rotations()) {
        const host::Image turned_image = rotated(image, rotation);
        const Prefiltered turned = make(turned_image, floats);
        expect_same_suns(straight, turned, rotation);
        worst = std::max(worst, difference(straight, turned, rotation));
        expect_stored_next_to_it(straight_halves, make(turned_image, halves), rotation);
    }
    EXPECT_LE(worst, WITH_SUNS);
    RecordProperty("worst", std::to_string(worst));
}

} // namespace
} // namespace lobelia::test
