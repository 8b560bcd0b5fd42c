// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Controls that prescribe the strain of an axis.

#include <algorithm>
#include <string>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/loading_rate.hpp>

namespace riprap {

/// The axis keeps its length.
struct Fixed {
  static constexpr const char* name = "fixed";

  template <class View>
  [[nodiscard]] double rate(const View& /*view*/, int /*axis*/) const {
    return 0;
  }
  template <class View>
  [[nodiscard]] double constant_rate(const View& /*view*/) const {
    return 0;
  }
};

namespace internal {

/// A rate reached smoothly, in the time of a servo's response.
struct Ramp {
  double time = 0;  // [s]

  template <class View>
  [[nodiscard]] double share(const View& view) const {
    return time > 0 ? std::min(1.0, (view.stage_time() + view.sim.time_step()) / time) : 1;
  }
};

}  // namespace internal

/// A constant rate of engineering strain: of the length at zero strain.
struct EngineeringRate {
  static constexpr const char* name = "engineering rate";
  LoadingRate rate_of_strain{};
  bool smooth = true;  ///< reached in the time that a pressure wave takes to the centre
  internal::Ramp ramp{};

  template <class View>
  void begin(const View& view, int /*axis*/) {
    ramp.time = smooth ? view.servo_response() : 0;
  }
  template <class View>
  [[nodiscard]] double rate(const View& view, int axis) const {
    return ramp.share(view) * rate_of_strain.value(view) / view.stretch[axis - 1];
  }
  template <class View>
  [[nodiscard]] double constant_rate(const View& view) const {
    return rate_of_strain.value(view);
  }
  void validate(const std::string& owner) const { rate_of_strain.validate(owner); }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    LoadingRate::for_each_parameter(self.rate_of_strain, visit);
    visit("smooth", self.smooth);
  }
  static void for_each_field(auto& self, auto&& visit) { visit("ramp_time", self.ramp.time); }
};

/// A constant rate of logarithmic strain: of the present length.
struct LogarithmicRate {
  static constexpr const char* name = "logarithmic rate";
  LoadingRate rate_of_strain{};
  bool smooth = true;  ///< reached in the time that a pressure wave takes to the centre
  internal::Ramp ramp{};

  template <class View>
  void begin(const View& view, int /*axis*/) {
    ramp.time = smooth ? view.servo_response() : 0;
  }
  template <class View>
  [[nodiscard]] double rate(const View& view, int /*axis*/) const {
    return ramp.share(view) * rate_of_strain.value(view);
  }
  template <class View>
  [[nodiscard]] double constant_rate(const View& view) const {
    return rate_of_strain.value(view);
  }
  void validate(const std::string& owner) const { rate_of_strain.validate(owner); }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    LoadingRate::for_each_parameter(self.rate_of_strain, visit);
    visit("smooth", self.smooth);
  }
  static void for_each_field(auto& self, auto&& visit) { visit("ramp_time", self.ramp.time); }
};

/// The axis follows the other one so that the area stays as it is. A step multiplies lengths by
/// 1 - time_step x rate: the product of both factors is 1.
struct ConstantVolume {
  static constexpr const char* name = "constant volume";

  template <class View>
  [[nodiscard]] double rate(const View& view, int /*axis*/, double other) const {
    return -other / (1 - view.sim.time_step() * other);
  }
};

}  // namespace riprap
