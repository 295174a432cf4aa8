#include "clipped_lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lobelia {
namespace {

constexpr double HALF_PI = std::numbers::pi / 2;
constexpr double LARGEST_EXPONENT = 1e6;

// Where cos^exponent has fallen below e^-40.
double reach_of(double exponent) {
    return exponent < 33 ? HALF_PI : std::min(HALF_PI, 9 / std::sqrt(exponent));
}

struct TanhSinhNode {
    double near; // distance from the start of [0, 1]
    double far;  // and from its end
    double weight;
};

// It takes the weak singularities at the ends of the range in its stride: Takahasi and Mori 1974,
// "Double Exponential Formulas for Numerical Integration". Its nodes lie within 0.7 standard
// deviations of the sharpest lobe, where a Gaussian is exact to rounding.
std::vector<TanhSinhNode> make_tanh_sinh_rule() {
    constexpr double STEP = 1.0 / 20;
    constexpr int STEPS = 92; // beyond these the weights are below rounding
    std::vector<TanhSinhNode> rule;
    for (int i = -STEPS; i <= STEPS; ++i) {
        const double stretch = std::numbers::pi * std::sinh(i * STEP);
        const double near = 1 / (1 + std::exp(-stretch));
        const double far = 1 / (1 + std::exp(stretch));
        rule.push_back({near, far, near * far * std::cosh(i * STEP)});
    }
    return rule;
}

/// A density over an angle, of any mass, as weighted angles.
class AngularDensity {
public:
    template <class Density>
    AngularDensity(double from, double to, Density density) {
        static const std::vector<TanhSinhNode> rule = make_tanh_sinh_rule();
        for (const auto& [near, far, share] : rule) {
            const double angle = near < far ? from + (to - from) * near : to - (to - from) * far;
            const double weight = share * density(angle);
            nodes_.push_back({angle, weight});
            total_ += weight;
        }
    }

    template <class Function>
    double mean(Function function) const {
        double sum = 0;
        for (const Node& node : nodes_) sum += node.weight * function(node.angle);
        return sum / total_;
    }

    /// 1 - mean cosine of the angle to `axis`, without cancellation.
    double mean_chord(double axis) const {
        return mean([axis](double angle) {
            const double half = std::sin((angle - axis) / 2);
            return 2 * half * half;
        });
    }

private:
    struct Node {
        double angle;
        double weight;
    };
    std::vector<Node> nodes_;
    double total_ = 0;
};

} // namespace

ClippedMoments clipped_moments(double cosine, double exponent) {
    // In the plane of N and R the horizon stands at -asin(cosine) from R.
    const double n = exponent;
    const double horizon = -std::asin(cosine);
    const double reach = reach_of(n);
    const AngularDensity in_plane(std::max(horizon, -reach), reach, [&](double angle) {
        return std::pow(std::cos(angle), n) * std::sin(angle - horizon);
    });
    const double elevated = reach_of(n + 2); // with the cosine of the solid angle
    const AngularDensity elevation(-elevated, elevated,
                                   [n](double angle) { return std::pow(std::cos(angle), n + 2); });

    const double along = 1 - in_plane.mean_chord(0);
    const double sideways = in_plane.mean([](double angle) { return std::sin(angle); });
    const double shift = cosine >= 1 ? 0 : std::atan2(sideways, along);

    const double plane_deficit = in_plane.mean_chord(shift);
    const double elevation_deficit = elevation.mean_chord(0);
    const double square_to_mean = in_plane.mean([shift](double angle) {
        const double sine = std::sin(angle - shift);
        return sine * sine;
    });
    return {
        .shift = shift,
        .deficit = plane_deficit + elevation_deficit - plane_deficit * elevation_deficit,
        .in_plane = (n + 3) / (n + 4) * square_to_mean,
        .across = 1 / (n + 4),
    };
}

MatchedTaps matched_taps(double cosine, double exponent) {
    const ClippedMoments moments = clipped_moments(cosine, exponent);
    // The mean of one lobe has length (m + 1) / (m + 2).
    const double one_tap = 1 / moments.deficit - 2;

    // Two lobes at the angle d from the axis have a mean of length cos d (m + 1) / (m + 2), and
    // mean squares that differ by m / (m + 3) sin^2 d. What is left of that difference towards
    // cosine = 1 is rounding.
    const double difference = moments.across - moments.in_plane;
    if (difference <= 1e-9 * moments.across) return {moments.shift, one_tap, one_tap, 0};
    const auto square_sine = [&](double m) { return std::min(difference * (m + 3) / m, 1.0); };
    double low = one_tap, high = 16 * (one_tap + 1); // the deficit falls as m rises
    for (int i = 0; i < 64; ++i) {
        const double m = (low + high) / 2;
        const double chord = square_sine(m) / (1 + std::sqrt(1 - square_sine(m)));
        const double deficit = 1 / (m + 2) + (m + 1) / (m + 2) * chord;
        (deficit > moments.deficit ? low : high) = m;
    }
    return {moments.shift, one_tap, low, std::asin(std::sqrt(square_sine(low)))};
}

namespace {

std::array<float, 4> make_texel(double column, double width) {
    // At the pole two taps are one, and the offset is that of a lobe nearby: with an exponent next
    // to 0 it tends so slowly to its limit that the limit would mislead.
    if (column == 1) return {0, 1, 1, make_texel(1 - 1.0 / (4 * CLIPPED_TABLE_WIDTH), width)[3]};

    // The inverse of clipped_table_point(); the row of width 0 holds the sharpest lobe.
    const double exponent = width > 0 ? 1 / (width * width) - 1 : LARGEST_EXPONENT;
    width = 1 / std::sqrt(exponent + 1);
    const double height = 2 * width * column / (1 + 2 * width - column);
    const double cosine = 1 - (1 - height) * (1 - height);
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    const MatchedTaps taps = matched_taps(cosine, exponent);
    const double along_mirror = sine / std::tan(taps.shift) - cosine;
    return {
        float((along_mirror - exponent * cosine) * width),
        float((exponent + 1) / taps.one_tap_exponent),
        float((exponent + 1) / taps.two_tap_exponent),
        float(std::tan(taps.two_tap_angle) / (width * sine)),
    };
}

} // namespace

std::vector<std::array<float, 4>> make_clipped_table() {
    std::vector<std::array<float, 4>> table;
    for (uint row = 0; row < CLIPPED_TABLE_HEIGHT; ++row)
        for (uint column = 0; column < CLIPPED_TABLE_WIDTH; ++column)
            table.push_back(make_texel(double(column) / (CLIPPED_TABLE_WIDTH - 1),
                                       double(row) / (CLIPPED_TABLE_HEIGHT - 1)));
    return table;
}

} // namespace lobelia
