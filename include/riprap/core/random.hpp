// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Random numbers with the same values on every platform: the distributions of the standard
/// library are free to differ, those of Boost.Random are not.

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cstdint>

#include <riprap/core/compiler.hpp>

namespace riprap {

/// A seeded source of random numbers.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [low, high); low where the two are equal.
  [[nodiscard]] double uniform(double low, double high) {
    if (!(low < high)) return low;
    return boost::random::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// Uniform over the integers low..high, both included.
  [[nodiscard]] unsigned uniform_integer(unsigned low, unsigned high) {
    return boost::random::uniform_int_distribution<unsigned>(low, high)(engine_);
  }

 private:
  boost::random::mt19937_64 engine_;
};

}  // namespace riprap
