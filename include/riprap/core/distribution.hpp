// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Distributions of one number: a value, uniform, or normal between two limits.

#include <cmath>
#include <numbers>
#include <string_view>

#include <riprap/core/errors.hpp>
#include <riprap/core/random.hpp>

namespace riprap {

/// How a number is drawn. Same seed, same values on every platform.
class Distribution {
 public:
  /// Always this value.
  [[nodiscard]] static Distribution fixed(double value) { return {Kind::uniform, value, value}; }
  /// Any value in between, the limits included, is as likely as any other.
  [[nodiscard]] static Distribution uniform(double low, double high) {
    return {Kind::uniform, low, high};
  }
  /// Normal, without what lies below `low` or above `high`: `mean` and `deviation` are those of the
  /// whole normal distribution.
  [[nodiscard]] static Distribution normal(double mean, double deviation, double low, double high) {
    Distribution d{Kind::normal, low, high};
    d.centre_ = mean;
    d.width_ = deviation;
    return d;
  }

  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }

  /// Throws InvalidInput that names the value and the rule.
  void validate(std::string_view name) const {
    require_finite(name, low_);
    require_finite(name, high_);
    require(low_ <= high_, name, low_, "low must not be above high");
    if (kind_ != Kind::normal) return;
    require_positive(name, width_);
    require(low_ < high_, name, low_, "low must be below high");
    require(centre_ >= low_ && centre_ <= high_, name, centre_, "mean must lie in [low, high]");
  }

  [[nodiscard]] double operator()(Random& random) const {
    if (kind_ == Kind::uniform) return random.uniform(low_, high_);
    // Box and Muller (1958), until a value lies in between.
    for (;;) {
      const double radius = std::sqrt(-2 * std::log(1 - random.uniform(0, 1)));
      const double angle = random.uniform(0, 2 * std::numbers::pi);
      const double value = centre_ + width_ * radius * std::cos(angle);
      if (value >= low_ && value <= high_) return value;
    }
  }

  /// Mean of what is drawn.
  [[nodiscard]] double mean() const {
    if (kind_ == Kind::uniform) return 0.5 * (low_ + high_);
    return centre_ + width_ * (density(low_) - density(high_)) / share();
  }
  /// Standard deviation of what is drawn.
  [[nodiscard]] double standard_deviation() const {
    if (kind_ == Kind::uniform) return (high_ - low_) / std::sqrt(12.0);
    const double shift = (density(low_) - density(high_)) / share();
    const double variance =
        1 + (reduced(low_) * density(low_) - reduced(high_) * density(high_)) / share() -
        shift * shift;
    return width_ * std::sqrt(variance);
  }

 private:
  enum class Kind { uniform, normal };

  Distribution(Kind kind, double low, double high) : kind_(kind), low_(low), high_(high) {}

  [[nodiscard]] double reduced(double x) const { return (x - centre_) / width_; }
  [[nodiscard]] double density(double x) const {
    return std::exp(-0.5 * reduced(x) * reduced(x)) / std::sqrt(2 * std::numbers::pi);
  }
  /// Of the normal distribution that lies between the limits [-].
  [[nodiscard]] double share() const {
    const auto below = [this](double x) { return 0.5 * std::erfc(-reduced(x) / std::sqrt(2.0)); };
    return below(high_) - below(low_);
  }

  Kind kind_;
  double low_;
  double high_;
  double centre_ = 0;
  double width_ = 0;
};

}  // namespace riprap
