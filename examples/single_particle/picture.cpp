// SPDX-License-Identifier: BSL-1.0
// Draws the four panels at one scale.

#include "picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

using namespace riprap;

namespace {

constexpr double panel_width = 640;
constexpr double panel_height = 600;
constexpr double header = 50;
constexpr double legend_height = 70;

const std::string mesh_edges = " stroke=\"#8a8a8a\" stroke-width=\"0.6\" stroke-linejoin=\"round\"";
constexpr auto outline =
    "fill=\"none\" stroke=\"#222\" stroke-width=\"1.6\" stroke-linejoin=\"round\"";
constexpr auto intact_colour = "#f1ede4";
constexpr auto tension_colour = "#f2a541";
constexpr auto shear_colour = "#a06cc0";
constexpr auto force_colour = "#c0392b";
constexpr auto reaction_colour = "#1d7a46";
constexpr auto x_colour = "#1f6fb4";
constexpr auto y_colour = "#15803d";
constexpr auto plane_colour = "#d11141";
constexpr std::array piece_colours{"#9cc3e4", "#f3c98b"};

std::string text_of(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

std::string stroke(const std::string& colour, double width, bool dashed = false) {
  return "stroke=\"" + colour + "\" stroke-width=\"" + Svg::number(width) + "\"" +
         (dashed ? " stroke-dasharray=\"7 5\"" : "");
}

// One quarter of the picture, through which the particle is seen.
class Panel {
 public:
  Panel(Svg& svg, const Analysis& a, int column, int row, const std::string& title)
      : svg_(svg), corner_(column * panel_width, header + row * panel_height) {
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;
    for (const Vec2& v : a.given.polygon) {
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    }
    // Room around the particle for arrows and their labels.
    scale_ = std::min(380 / (high - low).x(), 300 / (high - low).y());
    centre_ = 0.5 * (low + high);
    svg_.rectangle(corner_ + Vec2{6, 6}, {panel_width - 12, panel_height - 12},
                   "fill=\"none\" stroke=\"#ccc\"");
    svg_.text(corner_ + Vec2{20, 32}, title, "start", 16);
    cursor_ = corner_ + Vec2{20, panel_height - legend_height + 12};
  }

  [[nodiscard]] Svg& svg() const { return svg_; }
  [[nodiscard]] double scale() const { return scale_; }  // pixels per metre

  // Laboratory coordinates [m] to pixels.
  [[nodiscard]] Vec2 operator()(const Vec2& x) const {
    const Vec2 d = scale_ * (x - centre_);
    return corner_ +
           Vec2{0.5 * panel_width + d.x(), 0.5 * (panel_height - legend_height) + 18 - d.y()};
  }
  template <class Points>
  [[nodiscard]] std::vector<Vec2> all(const Points& points) const {
    std::vector<Vec2> out;
    for (const Vec2& v : points) out.push_back((*this)(v));
    return out;
  }
  [[nodiscard]] std::vector<Vec2> element(const Analysis& a, std::size_t e) const {
    std::vector<Vec2> out;
    for (const Vec2& v : a.mesh.triangle(e)) out.push_back((*this)(a.in_laboratory(v)));
    return out;
  }

  // Entries of the legend from left to right; a full row starts the next one.
  void patch(const std::string& colour, const std::string& name) {
    make_room(name);
    svg_.rectangle(cursor_ - Vec2{0, 11}, {14, 13}, "fill=\"" + colour + "\"" + mesh_edges);
    entry(20, name);
  }
  void sample(const std::string& style, const std::string& name) {
    make_room(name);
    svg_.line(cursor_ - Vec2{0, 4}, cursor_ + Vec2{24, -4}, style);
    entry(30, name);
  }
  void words(const std::string& text) {
    make_room(text);
    entry(0, text);
  }

 private:
  static constexpr double letter = 6.1;  // mean width at 12 pixels

  void make_room(const std::string& name) {
    const double end = cursor_.x() + 30 + letter * static_cast<double>(name.size());
    if (end <= corner_.x() + panel_width - 14 || cursor_.x() <= corner_.x() + 20) return;
    cursor_ = {corner_.x() + 20, cursor_.y() + 22};
  }
  void entry(double indent, const std::string& name) {
    svg_.text(cursor_ + Vec2{indent, 0}, name, "start", 12);
    cursor_.x() += indent + letter * static_cast<double>(name.size()) + 18;
  }

  Svg& svg_;
  Vec2 corner_;
  double scale_ = 1;
  Vec2 centre_{0, 0};
  Vec2 cursor_{0, 0};
};

// How an arrow looks; `gap` keeps it off the ring of a pin [pixels].
struct Arrow {
  std::string colour;
  double longest = 1;  // force [N] of the longest arrow
  double gap = 0;
};

// Pushing arrows end on the boundary, pulling ones start there: all lie outside.
void draw_force(const Panel& panel, const Analysis& a, const BoundaryLoad& load,
                const Arrow& arrow) {
  const double size = load.force_body.norm();
  if (!(size > 0)) return;
  const Vec2 edge = a.body.rotation * Vec2(a.mesh.nodes[load.at.next] - a.mesh.nodes[load.at.node]);
  const Vec2 force = a.body.rotation * load.force_body;
  const Vec2 away = Vec2{edge.y(), edge.x()}.normalized();  // off the edge, y downwards
  const Vec2 along{force.x() / size, -force.y() / size};
  const bool pushes = along.dot(away) <= 0;
  const Vec2 outward = pushes ? Vec2(-along) : along;
  const Vec2 near = panel(a.at(load)) + arrow.gap * outward;
  const Vec2 far = near + std::max(28.0, 74 * size / arrow.longest) * outward;
  const Vec2 tip = pushes ? near : far;
  const Vec2 across = 5 * perpendicular(along);
  panel.svg().line(near, far, stroke(arrow.colour, 2.2));
  panel.svg().polygon(std::array<Vec2, 3>{Vec2(tip + 2 * along), Vec2(tip - 11 * along + across),
                                          Vec2(tip - 11 * along - across)},
                      "fill=\"" + arrow.colour + "\"");
  // Beside an arrow that lies along the edge, the label goes off the edge.
  const Vec2 aside = 16 * (1 - outward.dot(away)) * away;
  const Vec2 place = far + 8 * outward + aside + Vec2{0, 4 + 5 * outward.y()};
  panel.svg().text(place, text_of("%.0f N", size),
                   outward.x() > 0.35    ? "start"
                   : outward.x() < -0.35 ? "end"
                                         : "middle");
}

void draw_mesh_and_forces(Svg& svg, const Analysis& a) {
  Panel panel(svg, a, 0, 0, "Mesh of " + std::to_string(a.mesh.size()) + " triangles and forces");
  for (std::size_t e = 0; e < a.mesh.size(); ++e)
    svg.polygon(panel.element(a, e), "fill=\"" + std::string(intact_colour) + "\"" + mesh_edges);
  svg.polygon(panel.all(a.given.polygon), outline);
  double longest = 0;
  for (const BoundaryLoad& load : a.balanced) longest = std::max(longest, load.force_body.norm());
  bool any_pin = false;
  for (std::size_t i = 0; i < a.balanced.size(); ++i) {
    const bool pin = a.is_pin(i);
    draw_force(panel, a, a.balanced[i],
               {pin ? reaction_colour : force_colour, longest, pin ? 9.0 : 0.0});
    if (!pin) continue;
    const Vec2 point = panel(a.at(a.balanced[i]));
    any_pin = true;
    svg.circle(point, 7, "fill=\"white\" " + stroke(reaction_colour, 2.5));
    svg.circle(point, 2.5, "fill=\"" + std::string(reaction_colour) + "\"");
  }
  panel.sample(stroke(force_colour, 2.2), "force as given");
  if (any_pin) panel.sample(stroke(reaction_colour, 2.2), "reaction of a pinned contact (ringed)");
  const Wrench rest = a.unbalanced();
  const double size = diameter(a.given.polygon.ring());
  if (rest.force.norm() < 1e-3 * longest && std::abs(rest.moment) < 1e-3 * longest * size)
    panel.words("the given forces are in balance");
  else if (!a.given.pinned)
    panel.words("inertia takes what is left over: " + text_of("%.0f N, ", rest.force.norm()) +
                text_of("%.2f N m", rest.moment));
}

// Upper ends of the classes of safety factors; up to 1 an element has failed.
constexpr std::array class_ends{0.25, 0.5, 1.0, 1.5, 2.0, 4.0};
constexpr std::array class_colours{"#7f0000", "#d7301f", "#fc8d59", "#fdf0c8",
                                   "#c6dbef", "#7fb2d8", "#3b7bb5"};

void draw_safety_factors(Svg& svg, const Analysis& a) {
  const double lowest = a.failures.lowest_safety_factor;
  Panel panel(svg, a, 1, 0,
              "Safety factors, failed up to 1" +
                  (std::isfinite(lowest) ? text_of("; lowest %.3f", lowest) : std::string()));
  for (std::size_t e = 0; e < a.mesh.size(); ++e) {
    const auto end =
        std::lower_bound(class_ends.begin(), class_ends.end(), a.elements[e].safety_factor);
    const auto k = static_cast<std::size_t>(end - class_ends.begin());
    svg.polygon(panel.element(a, e), "fill=\"" + std::string(class_colours[k]) + "\"" + mesh_edges);
  }
  svg.polygon(panel.all(a.given.polygon), outline);
  for (std::size_t k = 0; k < class_colours.size(); ++k) {
    const std::string low = k == 0 ? "" : to_text(class_ends[k - 1]);
    panel.patch(class_colours[k], k == 0                   ? "up to " + to_text(class_ends[0])
                                  : k == class_ends.size() ? "above " + low
                                                           : low + " to " + to_text(class_ends[k]));
  }
}

// The part of a line inside the particle and a little more.
void draw_line(const Panel& panel, const Analysis& a, const Line& line, const std::string& name,
               const std::string& style) {
  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  const Ring ring = a.given.polygon.ring();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& p = ring[i];
    const Vec2& q = ring[(i + 1) % ring.size()];
    const double dp = line.left_distance(p);
    const double dq = line.left_distance(q);
    if (dp * dq > 0 || dp == dq) continue;
    const double t = line.direction.dot(p + dp / (dp - dq) * (q - p) - line.point);
    first = std::min(first, t);
    last = std::max(last, t);
  }
  if (!(first <= last)) return;
  const double beyond = 22 / panel.scale();
  const Vec2 from = panel(line.point + (first - beyond) * line.direction);
  const Vec2 to = panel(line.point + (last + beyond) * line.direction);
  panel.svg().line(from, to, style);
  // At opposite ends, so that two lines close to each other can be told apart.
  const Vec2 outward = (name == "X" ? 1 : -1) * (to - from).normalized();
  panel.svg().text((name == "X" ? to : from) + 12 * outward + Vec2{0, 5}, name, "middle", 15);
}

void draw_failure(Svg& svg, const Analysis& a) {
  Panel panel(svg, a, 0, 1,
              "Failed elements: " + std::to_string(a.failures.failed) + " of " +
                  std::to_string(a.failures.elements) +
                  ", Rat = " + text_of("%.2f", a.failures.ratio()));
  for (std::size_t e = 0; e < a.mesh.size(); ++e) {
    const FailureMode mode = a.elements[e].mode;
    const std::string colour = mode == FailureMode::tension ? tension_colour
                               : mode == FailureMode::shear ? shear_colour
                                                            : intact_colour;
    svg.polygon(panel.element(a, e), "fill=\"" + colour + "\"" + mesh_edges);
  }
  svg.polygon(panel.all(a.given.polygon), outline);
  panel.patch(tension_colour, "tension");
  panel.patch(shear_colour, "shear");
  panel.patch(intact_colour, "intact");
  if (a.failures.failed == 0) return;

  const auto draw = [&](const std::optional<Line>& line, bool chosen, const std::string& name,
                        const std::string& colour) {
    if (!line) return;
    const std::string style = stroke(colour, chosen ? 3 : 2, !chosen);
    draw_line(panel, a, *line, name, style);
    panel.sample(style, name + " line" + (chosen ? " (chosen)" : ""));
  };
  draw(a.by_x, a.x_chosen, "X", x_colour);
  draw(a.by_y, !a.x_chosen, "Y", y_colour);

  const std::size_t first = a.failures.first_failed;
  svg.polygon(panel.element(a, first),
              "fill=\"none\" stroke-linejoin=\"round\" " + stroke("#000", 2.5));
  const Vec2 centre = panel(a.in_laboratory(a.mesh.centroid(first)));
  for (const Vec2& plane : a.planes.span()) {
    const Vec2 reach{46 * plane.x(), -46 * plane.y()};
    svg.line(centre - reach, centre + reach, stroke(plane_colour, 2.5));
  }
  panel.sample(stroke("#000", 2.5), "first failed element");
  panel.sample(stroke(plane_colour, 2.5),
               a.planes.count > 1 ? "its failure planes" : "its failure plane");
}

void draw_pieces(Svg& svg, const Analysis& a) {
  Panel panel(svg, a, 1, 1,
              a.crack ? std::string("The particle breaks along the ") +
                            (a.x_chosen ? "X line" : "Y line")
                      : a.refusal);
  if (!a.pieces) {
    svg.polygon(panel.all(a.given.polygon), "fill=\"" + std::string(intact_colour) + "\"");
    svg.polygon(panel.all(a.given.polygon), outline);
    if (a.line())
      draw_line(panel, a, *a.line(), a.x_chosen ? "X" : "Y",
                stroke(a.x_chosen ? x_colour : y_colour, 2, true));
    return;
  }
  // Apart by a share of the diameter, across the line; a refused cut is only shown in place.
  const Vec2 apart =
      a.crack ? Vec2(0.05 * diameter(a.given.polygon.ring()) * perpendicular(a.line()->direction))
              : Vec2{0, 0};
  std::size_t k = 0;
  for (const auto& [name, piece, shift] :
       {std::tuple{"A", &a.pieces->left, apart}, {"B", &a.pieces->right, Vec2(-apart)}}) {
    std::vector<Vec2> moved;
    for (const Vec2& v : *piece) moved.push_back(panel(v + shift));
    const std::string colour = a.crack ? piece_colours[k] : intact_colour;
    ++k;
    svg.polygon(moved, "fill=\"" + colour + "\" " + stroke("#222", 1.6, !a.crack));
    const AreaProperties properties = area_properties(*piece);
    svg.text(panel(properties.centroid + shift) + Vec2{0, 6}, name, "middle", 18);
    panel.patch(colour, std::string(name) + ": " + text_of("%.1f mm²", 1e6 * properties.area) +
                            text_of(", aspect %.2f", aspect(*piece)));
  }
}

// A bar of a round length, in the upper right corner.
void draw_scale_bar(Svg& svg, double scale) {
  const double room = 130 / scale;
  const double decade = std::pow(10, std::floor(std::log10(room)));
  const double metres = decade * (room >= 5 * decade ? 5 : room >= 2 * decade ? 2 : 1);
  const Vec2 end{2 * panel_width - 80, 30};
  svg.line(end - Vec2{metres * scale, 0}, end, stroke("#222", 3));
  svg.text(end + Vec2{8, 5}, to_text(std::round(1e6 * metres) / 1e3) + " mm");
}

}  // namespace

Svg picture(const Analysis& a) {
  Svg svg(2 * panel_width, header + 2 * panel_height);
  const bool hoek_brown = a.given.criterion.chosen.index() == 0;
  svg.text({20, 34},
           std::string("One particle: ") + (hoek_brown ? "Hoek-Brown" : "Mohr-Coulomb") +
               " criterion, " + (a.given.pinned ? "two contacts pinned" : "inertia relief"),
           "start", 19);
  draw_scale_bar(svg, Panel(svg, a, 0, 0, "").scale());
  draw_mesh_and_forces(svg, a);
  draw_safety_factors(svg, a);
  draw_failure(svg, a);
  draw_pieces(svg, a);
  return svg;
}
