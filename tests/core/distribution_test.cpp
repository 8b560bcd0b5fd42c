// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/distribution.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

struct Sample {
  double mean = 0;
  double deviation = 0;
};

Sample sample(const Distribution& distribution, int count) {
  Random random(1);
  double sum = 0;
  double squares = 0;
  for (int k = 0; k < count; ++k) {
    const double x = distribution(random);
    CHECK(x >= distribution.low());
    CHECK(x <= distribution.high());
    sum += x;
    squares += x * x;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean)};
}

}  // namespace

TEST_CASE("mean and standard deviation of samples are those that are stated") {
  constexpr int count = 40000;
  for (const Distribution& d :
       {Distribution::uniform(1, 3), Distribution::normal(2, 0.3, 1, 3),
        Distribution::normal(1.5, 0.5, 1.2, 4), Distribution::normal(1, 2, 1, 1.5)}) {
    const Sample s = sample(d, count);
    // Four standard errors: of the mean, and of a deviation with the kurtosis of a normal
    // distribution, which those with limits stay below.
    CHECK(s.mean == near(d.mean(), 4 * d.standard_deviation() / std::sqrt(count)));
    CHECK(s.deviation ==
          near(d.standard_deviation(), 4 * d.standard_deviation() / std::sqrt(2.0 * count)));
  }
  const Sample one = sample(Distribution::fixed(1.7), 10);
  CHECK(one.mean == near(1.7, 1e-15));
  CHECK(one.deviation == near(0, 1e-7));
}

TEST_CASE("closed forms") {
  CHECK(Distribution::fixed(2).mean() == 2);
  CHECK(Distribution::fixed(2).standard_deviation() == 0);
  CHECK(Distribution::uniform(0, 1).standard_deviation() == near(std::sqrt(1.0 / 12), 1e-15));
  // Wide limits leave the normal distribution as it is; half of it has a mean of sqrt(2 / pi).
  CHECK(Distribution::normal(5, 0.1, 0, 10).mean() == near(5, 1e-14));
  CHECK(Distribution::normal(5, 0.1, 0, 10).standard_deviation() == near(0.1, 1e-14));
  CHECK(Distribution::normal(0, 1, 0, 50).mean() == near(std::sqrt(2 / std::acos(-1.0)), 1e-14));
}

TEST_CASE("rules") {
  const auto error = [](const Distribution& d) { return message_of([&] { d.validate("x"); }); };
  CHECK(error(Distribution::uniform(1, 2)).empty());
  CHECK(contains(error(Distribution::uniform(2, 1)), "x = 2: low must not be above high"));
  CHECK(
      contains(error(Distribution::normal(1, 0, 0, 2)), "x = 0: must be a finite number above 0"));
  CHECK(contains(error(Distribution::normal(3, 1, 0, 2)), "x = 3: mean must lie in [low, high]"));
  CHECK(contains(error(Distribution::fixed(std::numeric_limits<double>::infinity())),
                 "must be a finite number"));
}
