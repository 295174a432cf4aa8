#include "clipped_lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lobelia {
namespace {

constexpr double HALF_PI = std::numbers::pi / 2;

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
    const double tilt = in_plane.mean(
        [shift](double angle) { return std::sin(angle - shift) * std::cos(angle - shift); });
    return {
        .shift = shift,
        .deficit = plane_deficit + elevation_deficit - plane_deficit * elevation_deficit,
        .in_plane = (n + 3) / (n + 4) * square_to_mean,
        .across = 1 / (n + 4),
        .tilt = (n + 3) / (n + 4) * tilt,
    };
}

namespace {

// The mean of cos^m has length (m + 1) / (m + 2): what is missing, seen from an axis at `chord`.
double deficit_of(double m, double chord) {
    return 1 / (m + 2) + (m + 1) / (m + 2) * chord;
}

double single_exponent(double deficit) {
    return 1 / deficit - 2;
}

struct Pair {
    double exponent;
    double angle;
};

// Two lobes at the angle d from their axis have a mean of length cos d (m + 1) / (m + 2), and mean
// squares across and in the plane that differ by m / (m + 3) sin^2 d.
Pair match_pair(double deficit, double difference) {
    const auto square_sine = [&](double m) { return std::min(difference * (m + 3) / m, 1.0); };
    double low = single_exponent(deficit), high = 16 * (low + 1); // the deficit falls as m rises
    for (int i = 0; i < 64; ++i) {
        const double m = (low + high) / 2;
        const double chord = square_sine(m) / (1 + std::sqrt(1 - square_sine(m)));
        (deficit_of(m, chord) > deficit ? low : high) = m;
    }
    return {low, std::asin(std::sqrt(square_sine(low)))};
}

} // namespace

MatchedTaps matched_taps(double cosine, double exponent) {
    const ClippedMoments moments = clipped_moments(cosine, exponent);
    const double one_tap = single_exponent(moments.deficit);
    // What is left of this towards cosine = 1 is rounding.
    const double difference = moments.across - moments.in_plane;
    if (difference <= 1e-9 * moments.across) return {moments.shift, one_tap, one_tap, 0};
    const Pair pair = match_pair(moments.deficit, difference);
    return {moments.shift, one_tap, pair.exponent, pair.angle};
}

namespace {

// The weight of least error at x lobe widths above the horizon, fitted like horizon_taps(). It ends
// where it matters no more.
double horizon_weight(double x, double exponent) {
    const double inverse = 2.2633 + x * (1.2589 + x * (4.4757 + x * (-2.8395 + x * 1.5814)));
    return std::pow(horizon_sharpness(float(exponent)), 1.5) * std::max(0.0, 1 / inverse - 1e-3);
}

struct Lobe {
    double share;
    double exponent;
    double angle; // in the plane of N and R, from the mean of the clipped lobe towards N
    double elevation;

    double chord() const {
        const double in_plane = std::sin(angle / 2), above = std::sin(elevation / 2);
        return 2 * (above * above + std::cos(elevation) * in_plane * in_plane);
    }
    // Its mean square across less that along the plane, square to an axis at `axis`.
    double difference(double axis) const {
        const double across = std::sin(elevation);
        const double along = std::cos(elevation) * std::sin(angle - axis);
        return exponent / (exponent + 3) * (across * across - along * along);
    }
};

} // namespace

HorizonPair horizon_pair(double cosine, double exponent) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    const double height = cosine * std::sqrt(exponent + 1) / std::max(sine, 1e-9);
    const double weight = horizon_weight(height, exponent);
    if (weight == 0) {
        const MatchedTaps taps = matched_taps(cosine, exponent);
        return {0, taps.shift, taps.two_tap_exponent, taps.two_tap_angle};
    }

    const ClippedMoments moments = clipped_moments(cosine, exponent);
    const HorizonTaps taps = horizon_taps(float(cosine), float(exponent));
    const double towards = double(taps.along_normal) * sine; // along the tangent from R towards N
    const double onwards = double(taps.along_mirror) + double(taps.along_normal) * cosine;
    const double angle = std::atan2(towards, onwards) - moments.shift;
    const double elevation = std::atan(double(taps.side) * sine / std::hypot(towards, onwards));
    const double middle_share = weight * double(HORIZON_MIDDLE_SHARE);
    const Lobe lobes[] = {
        {middle_share, 1 / double(taps.middle_variance), angle, 0},
        {weight - middle_share, 1 / double(taps.side_variance), angle, elevation},
    };

    // The pair's mean, as what is missing along the clipped lobe's and what lies beside it.
    double missing = moments.deficit, beside = 0;
    for (const Lobe& lobe : lobes) {
        missing += lobe.share * deficit_of(lobe.exponent, lobe.chord());
        beside += lobe.share * (lobe.exponent + 1) / (lobe.exponent + 2) *
                  std::cos(lobe.elevation) * std::sin(lobe.angle);
    }
    missing /= 1 + weight;
    beside /= 1 + weight;
    const double turn = std::atan2(beside, 1 - missing);
    const double length = std::hypot(beside, 1 - missing);
    const double deficit = (missing * (2 - missing) - beside * beside) / (1 + length);

    const double cos_turn = std::cos(turn), sin_turn = std::sin(turn);
    double difference = moments.across - cos_turn * cos_turn * moments.in_plane +
                        2 * sin_turn * cos_turn * moments.tilt -
                        sin_turn * sin_turn * (1 - moments.in_plane - moments.across);
    for (const Lobe& lobe : lobes) difference += lobe.share * lobe.difference(turn);
    const Pair pair = match_pair(deficit, difference / (1 + weight));
    return {weight, moments.shift + turn, pair.exponent, pair.angle};
}

} // namespace lobelia
