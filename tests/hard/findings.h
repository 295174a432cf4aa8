#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include <lobelia/host/outcome.h>

namespace lobelia::hard {

/// What was found of one row. Whatever breaks a promise fails the test at once, with the row's
/// point.
class Findings {
public:
    explicit Findings(std::string id) : id_(std::move(id)) {}

    /// Begins a point: one input with one set of parameters, which `where` names.
    void at(const std::string& where);

    /// Of the point: `error` is at most `allowed`.
    void within(double error, double allowed);
    /// `found` is `truth` to `allowed` of itself.
    void near(double found, double truth, double allowed);
    /// `fact` holds, which `what` names.
    void holds(bool fact, const std::string& what);
    /// It was refused with a message that has `words` in it.
    void refused(const std::string& message, const std::string& words);
    template <class T>
    void refused(const host::Outcome<T>& outcome, const std::string& words) {
        refused(outcome ? std::string() : outcome.error().message, words);
    }
    template <class T>
    void refused(const Result<T>& result, const std::string& words) {
        refused(result ? std::string() : std::string(result.error().step), words);
    }
    /// Every value is finite and not negative.
    void sound(std::span<const float> values);
    /// An average of the exact path against double precision: the error relative to `truth` or, if
    /// that is more, to a millionth of the brightest texel, at most 1e-4 for n up to 1e4 and 1e-3
    /// beyond, or `allowed` where that is less.
    void exact(double found, double truth, double brightest, double exponent, double allowed = 1.0);

    int points() const { return points_; }
    /// The value that came nearest to what is allowed of it, and that; 0 and 0 where all is exact.
    double worst() const { return worst_; }
    double allowed() const { return allowed_; }
    bool only_refusals() const { return refusals_ > 0 && others_ == 0; }

    std::uint64_t texels = 0;     // looked at by sound()
    std::uint64_t non_finite = 0; // of them
    double worst_exact = 0;       // relative error for n <= 1e4
    double worst_sharp = 0;       // the same for n <= 1e6

private:
    std::string place() const { return id_ + ", " + where_ + ": "; }

    std::string id_;
    std::string where_;
    int points_ = 0;
    double worst_ = 0;
    double allowed_ = 0;
    int refusals_ = 0;
    int others_ = 0;
};

} // namespace lobelia::hard
