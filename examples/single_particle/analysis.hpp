// SPDX-License-Identifier: BSL-1.0
#pragma once
// What riprap does with one particle at one check, with everything on the way kept for a picture.

#include <optional>
#include <string>
#include <vector>

#include <riprap/breakage/crack.hpp>
#include <riprap/breakage/criterion/criterion_choice.hpp>
#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/breakage/splitter/straight_cut.hpp>
#include <riprap/breakage/trigger/failed_element_ratio.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>

// A force [N] and the place [m] where it is to act.
struct PointForce {
  riprap::Vec2 at{0, 0};
  riprap::Vec2 force{0, 0};
  std::optional<double> normal{};  // its normal part [N]; of a bare force the share across the edge
};

struct Case {
  riprap::ConvexPolygon polygon;
  std::vector<PointForce> forces{};
  riprap::CriterionChoice<riprap::HoekBrown, riprap::MohrCoulomb> criterion{};
  riprap::UniformMesher mesher{};
  riprap::FailedElementRatio trigger{};
  riprap::StraightCut splitter{};
  riprap::Rock rock{};
  double thickness = 0.016;
  bool pinned = false;
  // Of a particle out of an assembly: from the frame that its mesh was made in to the laboratory's,
  // and the mean area of the intact particles [m^2]. One that is alone is its own mean.
  riprap::Rotation rotation{};
  std::optional<double> mean_area{};
};

struct Analysis {
  Case given;
  riprap::Body body{};                           // its position is the centroid of the polygon
  riprap::Mesh mesh{};                           // in the body's own frame, as loads and stress are
  std::vector<riprap::BoundaryLoad> loads{};     // as given, on the boundary
  std::vector<riprap::BoundaryLoad> balanced{};  // as they stress it: pinned ones are reactions
  riprap::ElementStress stress{};
  std::vector<riprap::ElementFailure> elements{};
  riprap::FailureCount failures{};
  riprap::FailurePlanes planes{};  // of the first failed element

  std::optional<riprap::Line> by_x{};
  std::optional<riprap::Line> by_y{};
  bool x_chosen = false;
  std::optional<riprap::Crack> crack{};      // it breaks
  std::optional<riprap::CutRings> pieces{};  // what the line cuts off, be it refused or not
  std::string refusal{};                     // why it does not break

  [[nodiscard]] riprap::Vec2 at(const riprap::BoundaryLoad& load) const {
    return in_laboratory(mesh.position(load.at));
  }
  [[nodiscard]] riprap::Vec2 in_laboratory(const riprap::Vec2& place) const {
    return body.position + body.rotation * place;
  }
  [[nodiscard]] bool is_pin(std::size_t i) const {
    return given.pinned && loads[i].force_body != balanced[i].force_body;
  }
  [[nodiscard]] const std::optional<riprap::Line>& line() const { return x_chosen ? by_x : by_y; }
  [[nodiscard]] const riprap::ElementFailure& first_failed() const {
    return elements[failures.first_failed];
  }
  [[nodiscard]] riprap::Wrench unbalanced() const;
};

// Throws InvalidInput for parameters that break a rule.
Analysis analyse(Case given);
