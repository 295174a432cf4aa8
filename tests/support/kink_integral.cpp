#include "support/kink_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "support/quadrature.h"

namespace lobelia::oracle {
namespace {

double whole_power(double t, int p) {
    double result = 1;
    for (int i = 0; i < p; ++i) result *= t;
    return result;
}

// Boundaries inside an interval, in order, with its two ends.
class Breaks {
public:
    Breaks(double from, double to) : at_{from, to} {}
    void add(double x) {
        if (at_[0] < x && x < at_[1]) at_[count_++] = x;
    }
    void add(const Crossings& crossings) {
        for (int i = 0; i < crossings.count; ++i) add(crossings.at[std::size_t(i)]);
    }
    std::span<const double> sorted() {
        std::sort(at_.data(), at_.data() + count_);
        return {at_.data(), count_};
    }

private:
    // The ends, what two horizons cross of three lines, twice each, and where they meet.
    std::array<double, 2 + 2 * 3 * 2 + 2> at_;
    std::size_t count_ = 2;
};

template <class Chart>
double value(const Weight& weight, Column column, Row row) {
    const Direction w = direction_at<Chart>(column, row);
    const double axis_cosine = dot(w, weight.axis);
    if (axis_cosine <= 0) return 0;
    const double clamp = weight.clamped ? std::max(0.0, dot(w, weight.normal)) : 1;
    return weight.power(axis_cosine) * clamp * Chart::measure(row, Chart::scale(column, row));
}

// Integral along the box's row or column `at`, cut at the horizons.
template <class Chart>
double line(const Weight& weight, const Box& box, bool along_u, double at, const KinkRule& kink) {
    const Column column = Chart::column(at);
    const Row row = Chart::row(at);
    const auto horizon = [&](Direction axis) {
        return along_u ? Chart::along_row(axis, row, box.u()) : Chart::along_column(axis, column);
    };
    const Crossings zeros = horizon(weight.axis);
    Breaks breaks = along_u ? Breaks(box.u0, box.u1) : Breaks(box.v0, box.v1);
    breaks.add(zeros);
    if (weight.clamped) breaks.add(horizon(weight.normal));

    double sum = 0;
    const GaussRule& rule = gauss(kink.points);
    const std::span<const double> cuts = breaks.sorted();
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const double from = cuts[k];
        const double to = cuts[k + 1];
        // x = zero + sign t^p, from the nearest zero of w . axis, if one is near.
        double zero = from;
        int p = 1;
        for (int i = 0; i < zeros.count; ++i) {
            const double candidate = zeros.at[std::size_t(i)];
            const double gap = std::max(from - candidate, candidate - to);
            const double best = p == 1 ? 4 * (to - from) : std::max(from - zero, zero - to);
            if (!kink.axis_kink || gap >= best) continue;
            zero = candidate;
            p = weight.power.straightening;
        }
        const double sign = zero <= from ? 1 : -1;
        const double t0 = std::pow(std::max(0.0, sign * (from - zero)), 1.0 / p);
        const double t1 = std::pow(std::max(0.0, sign * (to - zero)), 1.0 / p);
        for (std::size_t i = 0; i < std::size_t(kink.points); ++i) {
            const double t = 0.5 * (t0 + t1) + 0.5 * (t1 - t0) * rule.at[i];
            const double x = zero + sign * whole_power(t, p);
            const double density = sign * p * whole_power(t, p - 1) * 0.5 * (t1 - t0);
            sum += rule.weight[i] * density *
                   (along_u ? value<Chart>(weight, Chart::column(x), row)
                            : value<Chart>(weight, column, Chart::row(x)));
        }
    }
    return sum;
}

} // namespace

// A small box that a horizon cuts or grazes: an integral of line integrals, the lines across the
// horizon. The outer interval is cut wherever the horizon passes a corner of what it covers.
template <class Chart>
double integrate_across_horizon(const Weight& weight, const Box& box, const KinkRule& kink) {
    const Direction across = kink.axis_kink ? weight.axis : weight.normal;
    const Column column = Chart::column(box.u());
    const Row row = Chart::row(box.v());
    const bool along_u = std::abs(Chart::slope_u(across, column, row)) * box.width() >
                         std::abs(Chart::slope_v(across, column, row)) * box.height();

    Breaks breaks = along_u ? Breaks(box.v0, box.v1) : Breaks(box.u0, box.u1);
    const auto add_edges = [&](Direction axis) {
        if (along_u) {
            breaks.add(Chart::along_column(axis, Chart::column(box.u0)));
            breaks.add(Chart::along_column(axis, Chart::column(box.u1)));
            breaks.add(Chart::tangent_rows(axis));
        } else {
            breaks.add(Chart::along_row(axis, Chart::row(box.v0), box.u()));
            breaks.add(Chart::along_row(axis, Chart::row(box.v1), box.u()));
        }
    };
    add_edges(weight.axis);
    if (weight.clamped) {
        add_edges(weight.normal);
        const Direction both = cross(weight.axis, weight.normal);
        for (double sign : {-1.0, 1.0}) {
            double u, v;
            if (length(both) > 0 && Chart::locate((sign / length(both)) * both, box.u(), u, v))
                breaks.add(along_u ? v : u);
        }
    }

    double sum = 0;
    const GaussRule& rule = gauss(kink.points);
    const std::span<const double> cuts = breaks.sorted();
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
        for (std::size_t i = 0; i < std::size_t(kink.points); ++i) {
            // Graded: t -> 3t^2 - 2t^3 takes the corners' roots out of the ends.
            const double t = 0.5 + 0.5 * rule.at[i];
            const double place = kink.graded ? t * t * (3 - 2 * t) : t;
            const double density = kink.graded ? 6 * t * (1 - t) : 1;
            const double at = cuts[k] + (cuts[k + 1] - cuts[k]) * place;
            sum += 0.5 * rule.weight[i] * density * (cuts[k + 1] - cuts[k]) *
                   line<Chart>(weight, box, along_u, at, kink);
        }
    return sum;
}

template double integrate_across_horizon<Panorama>(const Weight&, const Box&, const KinkRule&);
template double integrate_across_horizon<CubeFace>(const Weight&, const Box&, const KinkRule&);

} // namespace lobelia::oracle
