// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/output/svg.hpp>
#include <support/extreme_numbers.hpp>
#include <support/near.hpp>
#include <support/svg_document.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::SvgElement;

namespace {

/// One of each shape.
Svg sampler() {
  Svg svg(640, 480.5);
  const std::vector<Vec2> points{{1, 2}, {30.25, -4}, {5.004, 60.006}};
  svg.polygon(points, "fill=\"#eee\" stroke=\"none\"");
  svg.polyline(points, "fill=\"none\"");
  svg.line({10, 20}, {30, 40}, "stroke=\"#222\"");
  svg.circle({50, 60}, 7.5, "fill=\"red\"");
  svg.rectangle({1, 2}, {3, 4}, "fill=\"blue\"");
  svg.text({11, 12}, "plain");
  svg.text({21, 22}, "turned", "middle", 17, -90);
  return svg;
}

/// Numbers written with a decimal comma and grouped in threes.
struct CommaPunctuation : std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
  [[nodiscard]] char do_thousands_sep() const override { return '.'; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST_CASE("a picture is well-formed XML with its size and its shapes in order") {
  const std::string document = sampler().document();
  std::istringstream in(document);
  boost::property_tree::ptree tree;
  REQUIRE_NOTHROW(boost::property_tree::read_xml(in, tree));
  const auto& root = tree.get_child("svg");
  CHECK(root.get<std::string>("<xmlattr>.xmlns") == "http://www.w3.org/2000/svg");
  CHECK(root.get<std::string>("<xmlattr>.viewBox") == "0 0 640.00 480.50");
  CHECK(root.get<double>("<xmlattr>.width") == 640);
  CHECK(root.get<double>("<xmlattr>.height") == 480.5);
  std::vector<std::string> names;
  for (const auto& [name, child] : root)
    if (name != "<xmlattr>") names.push_back(name);
  // The white background comes first.
  CHECK(names ==
        std::vector<std::string>{"rect", "path", "path", "path", "g", "rect", "text", "text"});
  // A second, stricter parser, which refuses bare ampersands and wrong closing tags.
  CHECK(test::svg_elements(document).size() == 9);
}

TEST_CASE("the picture's size is what it was made with") {
  const Svg svg(640, 480.5);
  CHECK(svg.width() == 640);
  CHECK(svg.height() == 480.5);
  CHECK(test::svg_elements(svg.document()).size() == 2);
}

TEST_CASE("shapes keep their coordinates, sizes and styles") {
  const auto all = test::svg_elements(sampler().document());
  const auto& polygon = all.at(2);
  const auto points = polygon.points();
  REQUIRE(points.size() == 3);
  CHECK(points[1] == Vec2{30.25, -4});
  // To a hundredth of a pixel.
  CHECK(points[2] == Vec2{5, 60.01});
  CHECK(polygon.attribute("fill") == "#eee");
  CHECK(polygon.attribute("stroke") == "none");
  CHECK(all.at(3).points() == points);
  CHECK(all.at(4).at("x1", "y1") == Vec2{10, 20});
  CHECK(all.at(4).at("x2", "y2") == Vec2{30, 40});
  CHECK(all.at(4).attribute("stroke") == "#222");
  CHECK(all.at(5).at("cx", "cy") == Vec2{50, 60});
  CHECK(all.at(5).number("r") == 7.5);
  CHECK(all.at(6).at("x", "y") == Vec2{1, 2});
  CHECK(all.at(6).at("width", "height") == Vec2{3, 4});
}

TEST_CASE("shapes of one style that follow each other are one element") {
  const std::vector<Vec2> corners{{1, 2}, {30.25, -4}, {5.004, 60.006}};
  Svg svg(100, 100);
  svg.polygon(corners, "fill=\"red\"");
  svg.polygon(corners, "fill=\"red\"");
  svg.line({0.5, -0.25}, {30.05, 40}, "stroke=\"#222\"");
  svg.circle({1, 2}, 0.3, "fill=\"blue\"");
  svg.circle({1.5, -0.004}, 3, "fill=\"blue\"");
  svg.polygon(corners, "fill=\"red\"");
  // By hand, from the grammar of paths (SVG 1.1, 8.3): M and L are absolute, l is relative, z
  // closes.
  const std::string path = "<path fill=\"red\" d=\"M1 2l29.25-6-25.25 64.01z";
  const std::string document = svg.document();
  CHECK(document.find(path +
                      "M1 2l29.25-6-25.25 64.01z\"/>\n"
                      "<path stroke=\"#222\" d=\"M.5-.25L30.05 40\"/>\n"
                      "<g fill=\"blue\"><circle cx=\"1\" cy=\"2\" r=\"0.30\"/>"
                      "<circle cx=\"1.5\" cy=\"0\" r=\"3.00\"/></g>\n" +
                      path + "\"/>\n</svg>") != std::string::npos);
  CHECK(svg.document() == document);
}

TEST_CASE("shapes drawn in turns keep their order, and one without corners leaves nothing") {
  Svg svg(100, 100);
  const std::vector<Vec2> corners{{1, 2}, {3, 4}, {1, 4}};
  svg.polygon(corners, "fill=\"red\"");
  svg.polygon(corners, "fill=\"blue\"");
  svg.polygon(std::vector<Vec2>{}, "fill=\"blue\"");
  svg.text({1, 1}, "between");
  svg.polygon(corners, "fill=\"blue\"");
  const auto all = test::svg_elements(svg.document());
  REQUIRE(all.size() == 6);
  CHECK(all[2].attribute("fill") == "red");
  CHECK(all[3].attribute("fill") == "blue");
  CHECK(all[4].name == "text");
  CHECK(all[5].points() == all[3].points());
}

TEST_CASE("roundings do not add up along a path") {
  for (const int decimals : {0, 1, 2}) {
    Random random(3);
    std::vector<Vec2> points;
    for (int i = 0; i < 1000; ++i)
      points.push_back({random.uniform(-900, 900), random.uniform(-900, 900)});
    Svg svg(900, 900, decimals);
    svg.polyline(points, "fill=\"none\"");
    const auto drawn = test::svg_elements(svg.document()).at(2).points();
    REQUIRE(drawn.size() == points.size());
    double worst = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      worst = std::max(worst, (drawn[i] - points[i]).cwiseAbs().maxCoeff());
    // Half of the last decimal, and the round-off of reading it.
    CHECK(worst <= 0.5 * std::pow(10, -decimals) + 1e-9);
  }
}

TEST_CASE("text has an anchor, a size and, only if asked for, a turn about its anchor") {
  const auto all = test::svg_elements(sampler().document());
  const SvgElement plain = test::text_element(all, "plain");
  CHECK(plain.at("x", "y") == Vec2{11, 12});
  CHECK(plain.attribute("text-anchor") == "start");
  CHECK(plain.number("font-size") == 13);
  CHECK(plain.attributes.count("transform") == 0);
  const SvgElement turned = test::text_element(all, "turned");
  CHECK(turned.attribute("text-anchor") == "middle");
  CHECK(turned.number("font-size") == 17);
  CHECK(turned.attribute("transform") == "rotate(-90.00 21.00 22.00)");
}

TEST_CASE("any text reads back as it was written") {
  // The third would read back as the first if the ampersand were not escaped.
  for (const std::string content : {"a < b & c > d", "</text><script>", "a &lt; b &amp; c",
                                    "\"quoted\" 'twice'", "sigma 22", "100 %"}) {
    CAPTURE(content);
    Svg svg(100, 100);
    svg.text({1, 1}, content);
    CHECK_NOTHROW(
        static_cast<void>(test::text_element(test::svg_elements(svg.document()), content)));
    std::istringstream in(svg.document());
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(in, tree);
    CHECK(tree.get<std::string>("svg.text") == content);
  }
}

TEST_CASE("numbers have two decimals and no exponent") {
  CHECK(Svg::number(0) == "0.00");
  CHECK(Svg::number(1.0 / 3) == "0.33");
  CHECK(Svg::number(-2.0 / 3) == "-0.67");
  CHECK(Svg::number(1e-9) == "0.00");
  CHECK(Svg::number(123456789) == "123456789.00");
  CHECK(Svg::number(1234.5678) == "1234.57");
}

TEST_CASE("a number in a picture is off by half of a hundredth of a pixel at most") {
  Random random(11);
  for (int i = 0; i < 1000; ++i) {
    const double value = random.uniform(-2000, 2000);
    // Half of the last decimal, and the round-off of reading it.
    CHECK(SvgElement::parsed(Svg::number(value)) == near(value, 0.005 + 1e-12));
  }
}

TEST_CASE("numbers are written the same wherever commas are in use") {
  const std::string expected = sampler().document();
  const std::locale before =
      std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation));
  const std::string written = sampler().document();
  std::locale::global(before);
  CHECK(written == expected);
}

TEST_CASE("a saved picture is the document") {
  const test::TemporaryFile file;
  sampler().save(file.path());
  CHECK(file.text() == sampler().document());
}

TEST_CASE("a picture that cannot be saved is an error that names the path") {
  const test::TemporaryFile missing_folder;
  const std::string path = missing_folder.path() + "/picture.svg";
  CHECK_THROWS_WITH_AS(sampler().save(path),
                       ("cannot write " + path + ": No such file or directory").c_str(),
                       SimulationError);
}

TEST_CASE("parts with numbers that cannot be drawn are left out, and the picture says how many") {
  const std::vector<Vec2> good{{1, 2}, {3, 4}, {1, 4}};
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300, -1e300, 1.01e9}) {
    CAPTURE(bad);
    Svg svg(100, 100);
    svg.polygon(good, "fill=\"red\"");
    svg.polygon(std::vector<Vec2>{{1, 2}, {bad, 4}, {1, 4}}, "fill=\"red\"");
    svg.line({bad, 2}, {3, 4}, "stroke=\"#222\"");
    svg.line({1, 2}, {3, bad}, "stroke=\"#222\"");
    svg.circle({1, bad}, 1, "fill=\"red\"");
    svg.circle({1, 1}, bad, "fill=\"red\"");
    svg.rectangle({bad, 1}, {2, 2}, "fill=\"red\"");
    svg.rectangle({1, 1}, {2, bad}, "fill=\"red\"");
    svg.text({bad, 1}, "somewhere");
    svg.text({1, 1}, "some size", "start", bad);
    svg.text({1, 1}, "some turn", "start", 13, bad);
    CHECK(svg.left_out() == 10);
    CHECK(test::left_out_of(svg.document()) == 10);
    // The document, its background, one polygon and the note.
    CHECK(test::svg_elements(svg.document()).size() == 4);
  }
}

TEST_CASE("a negative size is left out: XML readers refuse the whole picture for it") {
  Svg svg(100, 100);
  svg.circle({1, 1}, -1, "fill=\"red\"");
  svg.rectangle({1, 1}, {-2, 2}, "fill=\"red\"");
  CHECK(test::left_out_of(svg.document()) == 2);
}

TEST_CASE("a line has a gap where a point cannot be drawn") {
  Svg svg(100, 100);
  const double nan = std::nan("");
  svg.polyline(std::vector<Vec2>{{1, 2}, {3, 4}, {nan, 5}, {6, nan}, {7, 8}, {9, 10}},
               "fill=\"none\"");
  const auto lines = test::named(test::svg_elements(svg.document()), "polyline");
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].points() == std::vector<Vec2>{{1, 2}, {3, 4}});
  CHECK(lines[1].points() == std::vector<Vec2>{{7, 8}, {9, 10}});
  CHECK(svg.left_out() == 2);
}

TEST_CASE("any finite number has a text of plain decimals, and a picture a size") {
  for (const double value : test::extreme_numbers)
    if (std::isfinite(value))
      CHECK(Svg::number(value).find_first_not_of("-.0123456789") == std::string::npos);
  CHECK_THROWS_AS(Svg(std::nan(""), 100), InvalidInput);
  CHECK_THROWS_AS(Svg(100, -1), InvalidInput);
}
