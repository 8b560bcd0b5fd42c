// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Sizes of particles that follow a sieve curve class by class. Optional: not part of riprap.hpp.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/measurement/grading.hpp>
#include <riprap/measurement/read_grading.hpp>

namespace riprap {

namespace internal {

/// What lies between two sieves: a number of particles whose areas have a given sum.
struct SieveClass {
  GradedInterval sizes;
  double share;  // of the area of all [-]
  double below;  // the next finer sieve, which no particle of the class passes [m]
  std::size_t count = 0;

  SieveClass(const GradingPoint& from, const GradingPoint& to, double finer)
      : sizes(from, to), share(to.passing - from.passing), below(finer) {}

  [[nodiscard]] bool is_step() const { return sizes.smallest == sizes.largest; }
  /// Squared diameters of all particles of the class [m^2], if those of the sample have `total`.
  [[nodiscard]] double squares(double total) const { return share * total; }
  /// The number nearest to the one wanted whose sizes can lie in the class; rises with the total.
  void set_count(double total) {
    const double largest = sizes.largest * sizes.largest;
    const double smallest = sizes.smallest * sizes.smallest;
    // A number a round-off above or below a whole one is that one.
    const double fewest = std::ceil(squares(total) / largest * (1 - 1e-12));
    const double most = std::floor(squares(total) / smallest * (1 + 1e-12));
    const double wanted = std::round(sizes.count * total);
    count = static_cast<std::size_t>(std::max({1.0, fewest, std::min(wanted, most)}));
  }
  [[nodiscard]] bool fits(double total) const {
    const double mean = squares(total) / static_cast<double>(count);
    return mean <= sizes.largest * sizes.largest * (1 + 1e-9) && mean > below * below;
  }
  /// Diameters [m], ascending: the middles of equal shares of the number, with these shares raised
  /// to the power for which the areas have the sum of the class.
  void append_diameters(double total, std::vector<double>& out) const {
    const auto size_of = [&](std::size_t i, double power) {
      const double middle = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      return sizes.size_at(std::pow(middle, power));
    };
    double low = -60;  // of the logarithm of the power
    double high = 60;
    for (int step = 0; step < 100 && !is_step(); ++step) {
      const double power = std::exp(0.5 * (low + high));
      double sum = 0;
      for (std::size_t i = 0; i < count; ++i) sum += size_of(i, power) * size_of(i, power);
      (sum > squares(total) ? low : high) = 0.5 * (low + high);
    }
    const double same = std::sqrt(squares(total) / static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i)
      out.push_back(is_step() ? same : size_of(i, std::exp(high)));
  }
};

/// Classes whose numbers add up to a count, and the squared diameters of all [m^2].
struct SieveClasses {
  std::vector<SieveClass> classes;
  double total = 0;

  SieveClasses(const Grading& grading, std::size_t count) {
    GradingPoint before{grading.points().front().size, 0};
    double finer = 0;
    for (const GradingPoint& p : grading.points()) {
      if (p.size > before.size) finer = before.size;
      if (p.passing > before.passing) classes.emplace_back(before, p, finer);
      before = p;
    }
    // The greatest area whose classes have no more particles than that.
    double high = static_cast<double>(count) * grading.largest() * grading.largest() * 2;
    for (int step = 0; step < 100; ++step) {
      const double middle = 0.5 * (total + high);
      (set_counts(middle) <= count ? total : high) = middle;
    }
    const std::size_t made = set_counts(total);
    auto most = std::max_element(classes.begin(), classes.end(),
                                 [](const auto& a, const auto& b) { return a.count < b.count; });
    if (made < count) most->count += count - made;
  }

 private:
  std::size_t set_counts(double of_total) {
    std::size_t made = 0;
    for (SieveClass& c : classes) {
      c.set_count(of_total);
      made += c.count;
    }
    return made;
  }
};

}  // namespace internal

/// Equivalent diameters [m], ascending, of `count` particles of one thickness and density. They are
/// drawn class by class, a class being what lies between two neighbouring points of the curve: each
/// has its share of the area, so that at all points the curve of the sample is that of the grading
/// to round-off. Within a class numbers follow the area as in graded_diameters, and the curve
/// departs by less than the largest particle of the class. What passes the first point has its
/// size, or a little less. Compare graded_diameters, which draws by number: its sample departs at
/// the points, too, but needs no least count.
/// Throws InvalidInput, with the class, for a count so small that a class would have to be a part
/// of a particle.
[[nodiscard]] inline std::vector<double> sieve_class_diameters(const Grading& grading,
                                                               std::size_t count) {
  const internal::SieveClasses sieves(grading, count);
  std::vector<double> diameters;
  for (const internal::SieveClass& c : sieves.classes) {
    if (!c.fits(sieves.total))
      throw InvalidInput("sieve_class_diameters: count = " + std::to_string(count) +
                         ": must be larger, for the class from " + to_text(c.sizes.smallest) +
                         " to " + to_text(c.sizes.largest) + " m is a part of a particle");
    c.append_diameters(sieves.total, diameters);
  }
  return diameters;
}

}  // namespace riprap
