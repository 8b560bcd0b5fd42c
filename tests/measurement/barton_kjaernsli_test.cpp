// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/barton_kjaernsli.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include <riprap/core/units.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::message_of;
using test::near_relative;

namespace {

// A logarithm and a product.
constexpr double round_off = 2e-15;

const BartonKjaernsli rock{7, 50e6, 27.0_deg};

std::string refusal(const BartonKjaernsli& law, double normal_stress) {
  return message_of([&] { (void)law.friction_angle(normal_stress); });
}

}  // namespace

TEST_CASE("every decade below the equivalent strength adds the roughness") {
  CHECK(rock.friction_angle(5e6) == near_relative(34.0_deg, round_off));
  CHECK(rock.friction_angle(0.5e6) == near_relative(41.0_deg, round_off));
  CHECK(rock.friction_angle(0.05e6) == near_relative(48.0_deg, round_off));
  // By hand: log10(50/2) = 1.39794; 7 of these and 27 are 36.78558 degrees.
  CHECK(rock.friction_angle(2e6) == near_relative(36.78558_deg, 1e-7));
  CHECK(rock.shear_stress(5e6) == near_relative(5e6 * std::tan(34.0_deg), round_off));
}

TEST_CASE("near the equivalent strength only the friction of the faces is left") {
  // log10(1 / (1 - e)) = e / ln 10.
  CHECK(rock.friction_angle(50e6 * (1 - 1e-9)) == near_relative(27.0_deg, 1e-9));
  const BartonKjaernsli smooth{0, 50e6, 27.0_deg};
  CHECK(smooth.friction_angle(1e3) == near_relative(27.0_deg, round_off));
}

TEST_CASE("only the ratio of the stresses counts") {
  const BartonKjaernsli in_megapascal{7, 50, 27.0_deg};
  CHECK(in_megapascal.friction_angle(2) == near_relative(rock.friction_angle(2e6), round_off));
}

TEST_CASE("where the law does not hold it is refused") {
  const std::string range = ": must lie above 0 and below the equivalent strength";
  CHECK(refusal(rock, 50e6) == "normal stress = 5e+07" + range);
  CHECK(refusal(rock, 0) == "normal stress = 0" + range);
  CHECK(refusal(rock, std::nan("")) == "normal stress = nan" + range);
  // 27 + 15 log10(S / sigma_n) is 90 degrees at a ratio of 10^4.2.
  const BartonKjaernsli rough{15, 1e9, 27.0_deg};
  CHECK(refusal(rough, 1e9 / std::pow(10, 4.19)).empty());
  CHECK(test::contains(refusal(rough, 1e9 / std::pow(10, 4.21)), "90 degrees or more"));
}

TEST_CASE("parameters that cannot be are refused") {
  CHECK(refusal({-1, 50e6, 0.5}, 1e6) ==
        "BartonKjaernsli.equivalent_roughness = -1: must be a finite number, 0 or above");
  CHECK(refusal({7, 0, 0.5}, 1e6) ==
        "BartonKjaernsli.equivalent_strength = 0: must be a finite number above 0");
  CHECK(refusal({7, 50e6, 27}, 1e6) ==
        "BartonKjaernsli.basic_friction_angle = 27: must lie in (0, pi/2) radians");
}
