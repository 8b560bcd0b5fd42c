#include <compact_svg.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/output/svg.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using report::compact_svg;
using test::contains;
using test::near;

namespace {

/// The corners of a path of straight pieces, one list for every beginning.
std::vector<std::vector<Vec2>> corners(const std::string& path) {
  std::vector<std::vector<Vec2>> all;
  std::size_t at = 0;
  const auto number = [&] {
    std::size_t used = 0;
    const double v = std::stod(path.substr(at), &used);
    at += used;
    return v;
  };
  while (at < path.size()) {
    if (path[at] == 'M') {
      ++at;
      const double x = number();
      all.push_back({{x, number()}});
    } else if (path[at] == 'l' || path[at] == 'z') {
      ++at;
    } else {
      const double x = number();
      all.back().push_back(all.back().back() + Vec2{x, number()});
    }
  }
  return all;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("shapes of one style become one path with the same corners to a tenth of a pixel") {
  Random random(3);
  Svg svg(400, 400);
  std::vector<std::vector<Vec2>> drawn;
  for (int i = 0; i < 40; ++i) {
    std::vector<Vec2> ring;
    for (int k = 0; k < 5; ++k) ring.push_back({random.uniform(-9, 400), random.uniform(-1, 400)});
    svg.polygon(ring, "fill=\"#eee\" stroke=\"#333\"");
    drawn.push_back(ring);
  }
  const auto elements = test::svg_elements(compact_svg(svg.document()));
  const auto paths = test::named(elements, "path");
  REQUIRE(paths.size() == 1);
  CHECK(paths[0].attribute("fill") == "#eee");
  CHECK(paths[0].attribute("stroke") == "#333");
  const auto read = corners(paths[0].attribute("d"));
  REQUIRE(read.size() == drawn.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    REQUIRE(read[i].size() == drawn[i].size());
    // Rounded to 0.005 by the writer and to 0.05 here.
    for (std::size_t k = 0; k < drawn[i].size(); ++k)
      CHECK((read[i][k] - drawn[i][k]).cwiseAbs().maxCoeff() == near(0, 0.0551));
  }
}

TEST_CASE("a shape does not pass one of another colour, but does pass its own") {
  const std::string red = "fill=\"#f00\"";
  const std::string line = "stroke=\"#f00\"";
  const auto triangle = [](double x) { return std::vector<Vec2>{{x, 0}, {x + 5, 0}, {x, 5}}; };
  const auto picture = [&](const std::string& between) {
    Svg svg(100, 100);
    svg.polygon(triangle(0), red);
    svg.line({0, 0}, {9, 9}, between);
    svg.polygon(triangle(10), red);
    return compact_svg(svg.document());
  };
  CHECK(count(picture(line), "<path") == 2);
  CHECK(count(picture("stroke=\"#00f\""), "<path") == 3);
  // Fill and stroke of two colours are no colour of one's own.
  CHECK(count(picture("fill=\"#0f0\" stroke=\"#f00\""), "<path") == 3);
}

TEST_CASE("lines stay lines, and do not fill what they enclose") {
  Svg svg(100, 100);
  svg.line({0, 0}, {9, 0}, "stroke=\"#000\"");
  svg.line({9, 0}, {9, 9.5}, "stroke=\"#000\"");
  svg.polyline(std::vector<Vec2>{{1, 1}, {2, 2}, {3, 1}}, "fill=\"none\" stroke=\"#111\"");
  const std::string text = compact_svg(svg.document());
  CHECK(contains(text, "<path d=\"M0 0l9 0M9 0l0 9.5\" fill=\"none\" stroke=\"#000\"/>"));
  CHECK(contains(text, "<path d=\"M1 1l1 1 1-1\" fill=\"none\" stroke=\"#111\"/>"));
  CHECK_FALSE(contains(text, "z"));
}

TEST_CASE("circles of one style share it; texts, rectangles and shapes without style are kept") {
  Svg svg(100, 100);
  svg.circle({1, 2}, 3, "fill=\"#123\"");
  svg.circle({4, 5}, 0.06, "fill=\"#123\"");
  svg.rectangle({0, 0}, {5, 5}, "fill=\"none\"");
  svg.text({1, 1}, "a < b");
  svg.polygon(std::vector<Vec2>{{1, 1}, {2, 2}, {3, 1}}, "");
  const std::string text = compact_svg(svg.document());
  CHECK(contains(text, "<g fill=\"#123\">\n<circle cx=\"1\" cy=\"2\" r=\"3\"/>\n"
                       "<circle cx=\"4\" cy=\"5\" r=\".1\"/>\n</g>\n"));
  CHECK(contains(text, ">a &lt; b</text>"));
  CHECK(count(text, "<rect") == 2);
  CHECK(count(text, "<polygon") == 1);
  CHECK(text.ends_with("</svg>\n"));
}
