// SPDX-License-Identifier: BSL-1.0
#include <riprap/output/chart_axis.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <support/extreme_numbers.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near;

namespace {

// A quotient of logarithms.
constexpr double round_off = 1e-14;

std::vector<std::string> labels(const ChartAxis& axis) {
  std::vector<std::string> out;
  for (const AxisTick& tick : axis.ticks()) out.push_back(tick.label);
  return out;
}

using Labels = std::vector<std::string>;

}  // namespace

TEST_CASE("a linear axis ends on the ticks next to the data") {
  const ChartAxis axis = ChartAxis::linear(-0.31, 0.62);
  CHECK(labels(axis) == Labels{"-0.4", "-0.2", "0.0", "0.2", "0.4", "0.6", "0.8"});
  CHECK(axis.share(axis.low()) == 0);
  CHECK(axis.share(axis.high()) == 1);
  CHECK(axis.share(0.2) == near(0.5, round_off));
  for (const AxisTick& tick : axis.ticks()) CHECK(axis.is_zero(tick) == (tick.label == "0.0"));
}

TEST_CASE("round-off does not make the ticks of a linear axis coarser") {
  const Labels twenties{"0", "20", "40", "60", "80", "100"};
  CHECK(labels(ChartAxis::linear(0, 100)) == twenties);
  CHECK(labels(ChartAxis::linear(0, 100 + 1e-13)) == twenties);
  CHECK(labels(ChartAxis::linear(0, 104)) == Labels{"0", "50", "100", "150"});
}

TEST_CASE("a logarithmic axis ends on 1, 2 or 5 times a power of ten next to the data") {
  CHECK(labels(ChartAxis::logarithmic(0.5, 14)) == Labels{"0.5", "1", "2", "5", "10", "20"});
  CHECK(labels(ChartAxis::logarithmic(1, 10)) == Labels{"1", "2", "5", "10"});
  CHECK(labels(ChartAxis::logarithmic(0.021, 0.19)) == Labels{"0.02", "0.05", "0.1", "0.2"});
  CHECK(labels(ChartAxis::logarithmic(6e4, 7e4)) == Labels{"50000", "100000"});
  // Round-off beyond a tick does not lengthen it.
  CHECK(labels(ChartAxis::logarithmic(2 - 1e-15, 5 + 1e-14)) == Labels{"2", "5"});
}

TEST_CASE("over more than four decades a logarithmic axis shows powers of ten") {
  CHECK(labels(ChartAxis::logarithmic(0.03, 1234)) ==
        Labels{"0.01", "0.1", "1", "10", "100", "1000", "10000"});
}

TEST_CASE("a logarithmic axis gives equal factors equal lengths") {
  const ChartAxis axis = ChartAxis::logarithmic(0.01, 100);
  CHECK(axis.share(0.01) == 0);
  CHECK(axis.share(100) == 1);
  CHECK(axis.share(1) == near(0.5, round_off));
  CHECK(axis.share(0.2) - axis.share(0.02) == near(0.25, round_off));
  for (const AxisTick& tick : axis.ticks()) CHECK(!axis.is_zero(tick));
}

TEST_CASE("a logarithmic axis of one value lies about it, one of none is a decade") {
  CHECK(labels(ChartAxis::logarithmic(4, 4)) == Labels{"2", "5", "10"});
  const double none = std::nan("");
  CHECK(labels(ChartAxis::logarithmic(none, none)) == Labels{"1", "2", "5", "10"});
}

TEST_CASE("a logarithmic axis has no place for zero") {
  CHECK(test::message_of([] { (void)ChartAxis::logarithmic(0, 3); }) ==
        "value on a logarithmic axis = 0: must lie above 0");
  CHECK(test::message_of([] { (void)ChartAxis::logarithmic(-2, -2); }) ==
        "value on a logarithmic axis = -2: must lie above 0");
  CHECK(test::message_of([] { (void)ChartAxis::logarithmic(1, HUGE_VAL); }) ==
        "value on a logarithmic axis = inf: must lie between 1e-300 and 1e300");
  CHECK(test::message_of([] {
          (void)ChartAxis::logarithmic(1e-320, 1);
        }).ends_with("must lie between 1e-300 and 1e300"));
}

TEST_CASE("an axis of any two numbers has a few ticks with short labels, and ends that differ") {
  std::vector<double> ends(test::extreme_numbers.begin(), test::extreme_numbers.end());
  ends.insert(ends.end(), {1, std::nextafter(1, 2), 1e16, 1e16 + 2, -3e8, 1e-300, 2e-300});
  for (const double low : ends)
    for (const double high : ends) {
      CAPTURE(low);
      CAPTURE(high);
      const ChartAxis axis = ChartAxis::linear(low, high);
      CHECK(axis.low() < axis.high());
      CHECK(std::isfinite(axis.share(0.5 * axis.low() + 0.5 * axis.high())));
      CHECK(axis.ticks().size() >= 2);
      CHECK(axis.ticks().size() <= 12);
      for (const AxisTick& tick : axis.ticks()) CHECK(tick.label.size() <= 16);
    }
}

TEST_CASE("a single value too large for a unit axis has an axis as long as itself") {
  const ChartAxis axis = ChartAxis::linear(1e300, 1e300);
  CHECK(axis.low() <= 0.5e300);
  CHECK(axis.high() >= 1.5e300);
  CHECK(labels(axis).front() == "4e+299");
}

TEST_CASE("a logarithmic axis of any size has ticks with short labels") {
  const ChartAxis axis = ChartAxis::logarithmic(1e-300, 1e300);
  CHECK(axis.low() > 0);
  CHECK(std::isfinite(axis.share(1)));
  for (const AxisTick& tick : axis.ticks()) CHECK(tick.label.size() <= 16);
}
