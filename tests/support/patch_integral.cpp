#include "support/patch_integral.h"

#include "support/kink_integral.h"
#include "support/quadrature.h"

namespace lobelia::oracle {
namespace {

constexpr int MAX_PLAIN_POINTS = 11;
constexpr double LARGEST_HALF = 0.126; // half the longer side of a box for one rule
constexpr double ERROR = 1e-9;         // of one patch, relative
constexpr double NEGLIGIBLE = 1e-16;   // of the weight of the whole sphere

// Largest q (half-width of a box times the relative slope of the weight) that a rule of m points
// integrates: exp(q x) on [-1, 1] has the relative error (q / 2)^(2m) / (2m)!.
const std::array<double, MAX_PLAIN_POINTS + 1>& largest_slopes() {
    static const auto slopes = [] {
        std::array<double, MAX_PLAIN_POINTS + 1> q{};
        for (int m = 1; m <= MAX_PLAIN_POINTS; ++m)
            q[std::size_t(m)] = 2 * std::pow(std::tgamma(2 * m + 1) * ERROR, 0.5 / m);
        return q;
    }();
    return slopes;
}

// The same for a root-like singularity at 1 / ratio half-widths from the middle of the box.
const std::array<double, MAX_PLAIN_POINTS + 1>& largest_ratios() {
    static const auto ratios = [] {
        std::array<double, MAX_PLAIN_POINTS + 1> all{};
        for (int m = 1; m <= MAX_PLAIN_POINTS; ++m)
            all[std::size_t(m)] = 2 * std::pow(ERROR, 0.5 / m);
        return all;
    }();
    return ratios;
}

} // namespace

template <class Chart>
PatchIntegral<Chart>::PatchIntegral(const Weight& weight, int extra_points)
    : weight_(weight), extra_points_(extra_points), reach_(PI / 2) {
    const double n = weight.power.n;
    if (n > 0) reach_ = std::acos(std::exp(std::log(NEGLIGIBLE / (2 * (n + 2))) / n));
}

template <class Chart>
double PatchIntegral<Chart>::least_cosine(double radius) const {
    return reach_ + radius >= PI ? -2 : std::cos(reach_ + radius);
}

template <class Chart>
bool PatchIntegral<Chart>::near_axis_horizon(double cosine, double radius) const {
    return cosine < radius;
}

template <class Chart>
bool PatchIntegral<Chart>::near_normal_horizon(double cosine, double radius) const {
    return weight_.clamped && cosine < radius;
}

template <class Chart>
int PatchIntegral<Chart>::plain_order(double axis_cosine, double normal_cosine, double radius,
                                      double half_extent) const {
    if (half_extent > LARGEST_HALF || near_axis_horizon(axis_cosine, radius) ||
        near_normal_horizon(normal_cosine, radius))
        return 0;
    return smooth_order(axis_cosine, radius, half_extent);
}

template <class Chart>
int PatchIntegral<Chart>::smooth_order(double c, double radius, double half_extent) const {
    const double n = weight_.power.n;
    const double slope = std::sqrt(std::max(0.0, 1 - c * c)) / c;
    const double q = radius * (n * slope + 3 * std::sqrt(n)) + 2 * half_extent;
    int points = 2;
    while (points <= MAX_PLAIN_POINTS && q > largest_slopes()[std::size_t(points)]) ++points;
    // c^n of few whole n is a polynomial in slowly varying sines.
    if (weight_.power.whole >= 0 && weight_.power.whole <= 8)
        points = std::min(points, weight_.power.whole / 2 + 4);
    if (weight_.power.root_like)
        while (points <= MAX_PLAIN_POINTS && radius / c > largest_ratios()[std::size_t(points)])
            ++points;
    return points <= MAX_PLAIN_POINTS ? points + extra_points_ : 0;
}

template <class Chart>
ProjectedColumn PatchIntegral<Chart>::project(Column column) const {
    const auto along = [&](Direction d) { return d.x * column.x + d.z * column.z; };
    return {column, along(weight_.axis), weight_.clamped ? along(weight_.normal) : 0.0};
}

template <class Chart>
double PatchIntegral<Chart>::plain(const Box& box, std::span<const ProjectedColumn> columns,
                                   std::span<const Row> rows) const {
    const GaussRule& rule = gauss(int(rows.size()));
    double sum = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row row = rows[i];
        for (std::size_t j = 0; j < columns.size(); ++j) {
            const ProjectedColumn& at = columns[j];
            const double scale = Chart::scale(at.column, row);
            double f = weight_.power((row.radius * at.axis + row.y * weight_.axis.y) * scale);
            if (weight_.clamped) f *= (row.radius * at.normal + row.y * weight_.normal.y) * scale;
            sum += rule.weight[i] * rule.weight[j] * f * Chart::measure(row, scale);
        }
    }
    return sum * 0.25 * box.width() * box.height();
}

template <class Chart>
double PatchIntegral<Chart>::over(const Box& box) const {
    const Direction middle = direction_at<Chart>(Chart::column(box.u()), Chart::row(box.v()));
    const double radius = angular_radius<Chart>(box);
    const double half_extent = 0.5 * std::max(box.width(), box.height());
    const double axis_cosine = dot(middle, weight_.axis);
    const double normal_cosine = weight_.clamped ? dot(middle, weight_.normal) : 1;
    if (axis_cosine < least_cosine(radius) || normal_cosine <= -radius) return 0;

    if (const int points = plain_order(axis_cosine, normal_cosine, radius, half_extent)) {
        const GaussRule& rule = gauss(points);
        std::array<ProjectedColumn, MAX_GAUSS_POINTS> columns;
        std::array<Row, MAX_GAUSS_POINTS> rows;
        for (std::size_t i = 0; i < std::size_t(points); ++i) {
            columns[i] = project(Chart::column(box.u() + 0.5 * box.width() * rule.at[i]));
            rows[i] = Chart::row(box.v() + 0.5 * box.height() * rule.at[i]);
        }
        return plain(box, {columns.data(), std::size_t(points)},
                     {rows.data(), std::size_t(points)});
    }

    const bool axis_kink = near_axis_horizon(axis_cosine, radius);
    const bool normal_kink = near_normal_horizon(normal_cosine, radius);
    const bool kink = axis_kink || normal_kink;
    if (kink && half_extent <= LARGEST_HALF) {
        const bool graded = axis_kink && (normal_kink || weight_.power.root_like);
        const int smooth = radius < 0.02 ? 4 : radius < 0.06 ? 7 : 10;
        const double degree = weight_.power.straightening * (weight_.power.n + 1);
        const int plain_points = smooth_order(axis_cosine, radius, half_extent);
        const int points = axis_kink ? smooth + int(std::min(degree, 100.0) / 2) + extra_points_
                                     : std::max(plain_points, smooth);
        if (axis_kink || plain_points)
            return integrate_across_horizon<Chart>(
                weight_, box,
                {std::min(points + (graded ? 4 : 0), MAX_GAUSS_POINTS), axis_kink, graded});
    }
    return split(box);
}

// Halves the box across its longer side: in coordinates while it is large, in angle after.
template <class Chart>
double PatchIntegral<Chart>::split(const Box& box) const {
    const bool large = std::max(box.width(), box.height()) > 2 * LARGEST_HALF;
    const double stretch = large ? 1.0 : Chart::row(box.v()).radius;
    Box first = box;
    Box second = box;
    if (box.width() * stretch > box.height())
        first.u1 = second.u0 = box.u();
    else
        first.v1 = second.v0 = box.v();
    return over(first) + over(second);
}

template class PatchIntegral<Panorama>;
template class PatchIntegral<CubeFace>;

} // namespace lobelia::oracle
