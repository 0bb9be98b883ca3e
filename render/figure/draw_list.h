#pragma once
// Points and boxes in pixels of the picture: origin top left, y downwards.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/statement.h"
#include "render/figure/figure.h"
#include "render/figure/scene.h"

namespace tribolog::render::figure {

struct PixelPoint {
  double x{};
  double y{};
  friend bool operator==(const PixelPoint&, const PixelPoint&) = default;
};

/// `left <= right` and `top <= bottom`; a box without area is empty.
struct PixelBox {
  double left{};
  double top{};
  double right{};
  double bottom{};

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
  [[nodiscard]] double area() const { return width() * height(); }
  [[nodiscard]] PixelPoint centre() const { return {(left + right) / 2, (top + bottom) / 2}; }
  [[nodiscard]] bool contains(PixelPoint p) const {
    return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom;
  }
  [[nodiscard]] bool contains(const PixelBox& other) const {
    return other.left >= left && other.right <= right && other.top >= top && other.bottom <= bottom;
  }
  [[nodiscard]] PixelBox grown(double by) const {
    return {left - by, top - by, right + by, bottom + by};
  }
  [[nodiscard]] PixelBox moved(double dx, double dy) const {
    return {left + dx, top + dy, right + dx, bottom + dy};
  }
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// Area that both cover; 0 if they only touch.
inline double overlap_area(const PixelBox& a, const PixelBox& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return width > 0 && height > 0 ? width * height : 0.0;
}

// A laid-out scene: how space maps to the picture, and the surfaces of the solid parts.

/// A camera whose picture is fitted into the figure.
struct SceneView {
  Point3 eye;
  Point3 right;  ///< Unit vectors of the picture: right, up and away from the eye.
  Point3 up;
  Point3 forward;
  bool parallel{true};
  double scale{1.0};   ///< Pixels per metre, or, in perspective, at a distance of one metre.
  PixelPoint origin;   ///< Where the point straight ahead of the eye appears.
  double nearest_m{};  ///< Distances along `forward` between which everything lies.
  double farthest_m{};

  [[nodiscard]] double distance(Point3 p) const;
  [[nodiscard]] PixelPoint pixel(Point3 p) const;
  [[nodiscard]] double metres_per_pixel(Point3 p) const;
  /// Moves a point along its line of sight to a distance: it stays at the same pixel.
  [[nodiscard]] Point3 moved_to(Point3 p, double distance_m) const;
  /// Distances before and behind everything in the scene, for what must hide it or be hidden by it.
  [[nodiscard]] double front_m() const { return 0.5 * nearest_m; }
  [[nodiscard]] double back_m() const { return 1.02 * farthest_m; }

  /// The matrix, by rows, from the camera's coordinates (right, up, backwards) to the clip space of
  /// a window that shows `rows` rows of a picture `width` pixels wide from row `top` on.
  [[nodiscard]] std::array<double, 16> clip_matrix(int width, int top, int rows) const;
};

/// A part's surface as triangles.
struct SceneMesh {
  enum class Finish { lit, flat };  ///< Flat: the colour itself, seen from both sides, no outline.
  std::string label;                ///< Of the part; empty: nobody asks for it.
  Colour colour;                    ///< Opaque.
  Finish finish{Finish::lit};
  std::vector<Point3> points;
  std::vector<Point3> normals;  ///< For the light.
  std::vector<Point3> spread;   ///< Where the outline goes: outwards, also at sharp edges.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Counter-clockwise from outside.
};

struct SceneGeometry {
  SceneView view;
  std::vector<SceneMesh> meshes;
};

// A laid-out figure: plain primitives in pixels, in the order in which they are painted.
//
// Every writer (PNG by way of VTK, a vector format) draws the same list, and the layout is tested
// on it without drawing anything. Each primitive says what it stands for, so that a test or the
// check of the finished picture can ask for "series 2 of panel 0".

enum class Role {
  grid,
  axis,
  tick_label,
  scale_note,
  axis_title,
  panel_title,
  figure_title,
  band,
  series,
  series_marker,
  direction_arrow,
  error_bar,
  reference_line,
  reference_text,
  label_marker,
  label_leader,
  label_text,
  text_backing,
  legend_box,
  legend_sample,
  legend_text,
  notice,
  block_fill,
  block,
  block_text,
  wire,
  wire_head,
  branch_dot,
  shape,
  shape_fill,
  shape_text,
  scene_line,
};

/// `index` counts the series, band, label ... of the panel, in the order of the description; in a
/// diagram (panel 0) the blocks, wires, shapes and texts.
struct Owner {
  Role role{};
  int panel{};
  int index{};
  friend bool operator==(const Owner&, const Owner&) = default;
};

/// A stroke with round joins and butt ends. `dashes`: lengths in pixels of ink and gap in turn;
/// empty: solid.
struct Polyline {
  Owner owner;
  std::vector<PixelPoint> points;
  double width{1.0};
  Colour colour;
  std::vector<double> dashes;
};

/// Filled area between two edges with equally many points.
struct Ribbon {
  Owner owner;
  std::vector<PixelPoint> edge_a;
  std::vector<PixelPoint> edge_b;
  Colour colour;
};

/// Filled convex outline.
struct Polygon {
  Owner owner;
  std::vector<PixelPoint> outline;
  Colour colour;
};

/// Markers of one kind. Those with an area get a thin white rim, so that neighbours stay apart.
struct Markers {
  Owner owner;
  Marker shape{Marker::circle};
  std::vector<PixelPoint> centres;
  double size{10.0};
  Colour colour;
};

/// One run of text in one size on one baseline; a line of text with a subscript is several runs.
struct TextRun {
  Owner owner;
  std::string text;  ///< Valid UTF-8; the font has every glyph.
  bool bold{false};
  int size{26};         ///< Pixels per em.
  PixelPoint baseline;  ///< Where the first glyph starts.
  bool upright{true};   ///< Otherwise it reads from bottom to top.
  Colour colour;
  PixelBox box;  ///< Advance times ink.
};

using Primitive = std::variant<Polyline, Ribbon, Polygon, Markers, TextRun>;

struct DrawList {
  int width{};
  int height{};
  double width_mm{160.0};              ///< In print.
  std::vector<PixelBox> plots;         ///< The axes box of each panel.
  std::optional<SceneGeometry> scene;  ///< Solid parts, painted before everything else.
  std::vector<Primitive> primitives;
  std::vector<Statement> warnings;  ///< What a reader would stumble over.
};

inline const Owner& owner_of(const Primitive& primitive) {
  return std::visit([](const auto& one) -> const Owner& { return one.owner; }, primitive);
}

// What each style of line and each marker looks like, for every writer.

/// Ink and gap in turn, in pixels; empty for a solid line. Scaled with the width, so that every
/// style looks alike in thin and thick.
std::vector<double> dash_lengths(LineStyle style, double width);

/// The inked parts of a line. @pre an even number of positive lengths, or none (the whole line).
std::vector<std::vector<PixelPoint>> cut_into_dashes(const std::vector<PixelPoint>& line,
                                                     const std::vector<double>& lengths);

// What each marker looks like, for every writer.

inline constexpr double marker_rim_px = 1.5;
inline constexpr Colour marker_rim_colour{255, 255, 255};

/// Dots are too small for one: in a cloud of them it would only eat their neighbours.
bool has_rim(const Markers& markers);

/// A cross or a plus, which is stroked; the others are filled.
bool is_stroked(Marker shape);

/// The two strokes of a cross or a plus. @param grow widens it by so many pixels on each side
struct MarkerStrokes {
  std::array<std::array<PixelPoint, 2>, 2> lines;
  double thickness{};
};
MarkerStrokes marker_strokes(const Markers& markers, PixelPoint centre, double grow);

/// The corners of a filled marker; none for a circle, whose radius is `marker_radius`.
std::vector<PixelPoint> marker_corners(Marker shape, PixelPoint centre, double radius);
double marker_radius(const Markers& markers, double grow);

std::vector<PixelPoint> regular_polygon(PixelPoint centre, double radius, int corners, double turn);

}  // namespace tribolog::render::figure
