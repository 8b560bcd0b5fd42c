// SPDX-License-Identifier: BSL-1.0
#include "loaded_particle.hpp"

#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace convergence {

std::string to_lines(const Sample& sample) {
  std::string text;
  const auto add = [&](const char* what, std::initializer_list<double> numbers) {
    text += what;
    for (const double number : numbers) {
      char buffer[40];
      std::snprintf(buffer, sizeof buffer, " %.17g", number);
      text += buffer;
    }
    text += "\n";
  };
  add("sample", {sample.thickness, sample.mean_area});
  for (const LoadedParticle& particle : sample.particles) {
    add("particle", {});
    for (const auto& x : particle.ring) add("corner", {x.x(), x.y()});
    for (const auto& [arm, force] : particle.forces)
      add("force", {arm.x(), arm.y(), force.x(), force.y()});
  }
  return text;
}

Sample sample_from(const std::string& lines) {
  Sample sample;
  std::istringstream text(lines);
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string what;
    words >> what;
    double a = 0;
    double b = 0;
    if (what != "particle") words >> a >> b;
    if (what == "sample") {
      sample.thickness = a;
      sample.mean_area = b;
    } else if (what == "particle") {
      sample.particles.emplace_back();
    } else if (what == "corner") {
      sample.particles.back().ring.emplace_back(a, b);
    } else {
      PointForce force{.arm = {a, b}};
      words >> force.force.x() >> force.force.y();
      sample.particles.back().forces.push_back(force);
    }
    if (!words) throw std::runtime_error("not a line of a sample: " + line);
  }
  return sample;
}

}  // namespace convergence
