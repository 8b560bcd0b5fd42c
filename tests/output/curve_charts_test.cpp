// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <riprap/output/curve_charts.hpp>
#include <support/extreme_numbers.hpp>
#include <support/near.hpp>
#include <support/still_sample.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using riprap::test::near_relative;

namespace {

/// Records of samples that are squeezed more and more along axis 2, with one contact missing, so
/// that no two of the measured numbers agree.
Curve squeezed(int records) {
  Curve curve;
  for (int k = 0; k < records; ++k) {
    test::StillSample sample{test::Cross{.depths = {1e-5, 2e-5 + 1e-6 * k, -1e-5, 2.2e-5}}};
    sample.slide(4e-6 + 1e-7 * k);
    auto view = test::view_of(sample);
    if (k == 0) curve.begin_stage(view);
    view.stretch = {1 + 0.01 * k, 1 - 0.025 * k};
    sample.breaks().resize(static_cast<std::size_t>(k * k));
    curve.record(view);
  }
  return curve;
}

const Chart& chart_titled(const std::vector<Chart>& charts, const std::string& title) {
  for (const Chart& chart : charts)
    if (chart.title == title) return chart;
  throw std::runtime_error("no chart " + title);
}

template <class Value>
void check_series(const Curve& curve, const Chart& chart, std::size_t index, Value value) {
  CAPTURE(chart.title);
  CAPTURE(index);
  REQUIRE(index < chart.series.size());
  const std::vector<Vec2>& points = chart.series[index].points;
  REQUIRE(points.size() == curve.points().size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const CurvePoint& p = curve.points()[k];
    // One multiplication by a factor of units.
    CHECK(points[k].x() == near_relative(100 * p.axial_strain, 1e-15));
    CHECK(points[k].y() == near_relative(value(p), 1e-15));
  }
}

}  // namespace

TEST_CASE("six charts show the whole test against axial strain in per cent") {
  const Curve curve = squeezed(5);
  const auto charts = curve_charts(curve);
  CHECK(charts.size() == 6);
  for (const Chart& chart : charts) CHECK(chart.x_label == "axial strain [%]");
  const Chart& friction = chart_titled(charts, "Mobilised friction");
  check_series(curve, friction, 0, [](const CurvePoint& p) { return p.sin_phi(); });
  check_series(curve, friction, 1, [](const CurvePoint& p) { return p.sin_phi_fabric(); });
  check_series(curve, friction, 2,
               [](const CurvePoint& p) { return p.sin_phi_fabric_simplified(); });
  check_series(curve, chart_titled(charts, "Volumetric strain"), 0,
               [](const CurvePoint& p) { return 100 * p.volumetric_strain; });
  const Chart& coordination = chart_titled(charts, "Coordination");
  check_series(curve, coordination, 0,
               [](const CurvePoint& p) { return p.coordination.coordination_number; });
  check_series(curve, coordination, 1,
               [](const CurvePoint& p) { return p.coordination.contacts_per_particle; });
  const Chart& anisotropy = chart_titled(charts, "Anisotropy");
  check_series(curve, anisotropy, 0,
               [](const CurvePoint& p) { return p.fabric.normal_forces.coefficient; });
  check_series(curve, anisotropy, 1,
               [](const CurvePoint& p) { return p.fabric.normals.coefficient; });
  check_series(curve, anisotropy, 2,
               [](const CurvePoint& p) { return p.fabric.tangential_forces.coefficient; });
  check_series(curve, chart_titled(charts, "Breakages since the start of shear"), 0,
               [](const CurvePoint& p) { return static_cast<double>(p.breakages); });
  const Chart& stresses = chart_titled(charts, "Stresses");
  check_series(curve, stresses, 0, [](const CurvePoint& p) { return p.stress.s22 / 1e6; });
  check_series(curve, stresses, 1, [](const CurvePoint& p) { return p.stress.s11 / 1e6; });
}

TEST_CASE("no two curves of one chart could be exchanged unnoticed") {
  const Curve curve = squeezed(5);
  for (const Chart& chart : curve_charts(curve))
    for (std::size_t i = 0; i < chart.series.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        CAPTURE(chart.title);
        CHECK(chart.series[i].points.back().y() != chart.series[k].points.back().y());
        CHECK(chart.series[i].colour != chart.series[k].colour);
        CHECK(chart.series[i].name != chart.series[k].name);
      }
}

TEST_CASE("series are named after what they are, units stand at the axes") {
  const auto charts = curve_charts(squeezed(2));
  const Chart& stresses = chart_titled(charts, "Stresses");
  CHECK(stresses.series.at(0).name == "sigma 22");
  CHECK(stresses.series.at(1).name == "sigma 11");
  CHECK(stresses.y_label.find("[MPa]") != std::string::npos);
  CHECK(chart_titled(charts, "Volumetric strain").y_label.find("[%]") != std::string::npos);
  CHECK(chart_titled(charts, "Coordination").series.at(0).name == "coordination 2M/N");
  CHECK(chart_titled(charts, "Mobilised friction").series.at(1).name == "eq. 14");
  CHECK(chart_titled(charts, "Anisotropy").series.at(1).name == "a contact normal");
}

TEST_CASE("the sheet of charts holds every label, for a long curve and for a single record") {
  for (const int records : {1, 2, 9}) {
    const auto all = test::svg_elements(chart_sheet(curve_charts(squeezed(records))).document());
    CHECK(test::outside_canvas(all) == "");
    for (const Chart& chart : curve_charts(squeezed(records)))
      CHECK_NOTHROW(static_cast<void>(test::text_element(all, chart.title)));
    // Names in the legends of the left column end before the right column begins.
    for (const auto& e : test::named(all, "text"))
      if (e.number("x") < 600) CHECK(box_of(e).high.x() <= 600);
  }
}

TEST_CASE("a curve of any numbers, or without records, has charts") {
  CHECK(test::left_out_of(chart_sheet(curve_charts(Curve{})).document()) == 0);
  for (const double bad : test::extreme_numbers) {
    CAPTURE(bad);
    Curve curve = squeezed(2);
    test::StillSample sample;
    auto view = test::view_of(sample);
    view.stretch = {bad, 1 - bad};
    view.rate = {bad, bad};
    curve.record(view);
    CHECK_NOTHROW(
        static_cast<void>(test::left_out_of(chart_sheet(curve_charts(curve)).document())));
  }
}
