#pragma once
// A laid-out figure: plain primitives in pixels, in the order in which they are painted.
//
// Every writer (PNG by way of VTK, a vector format) draws the same list, and the layout is tested
// on it without drawing anything. Each primitive says what it stands for, so that a test or the
// check of the finished picture can ask for "series 2 of panel 0".

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "render/figure/figure.h"
#include "render/figure/pixel_geometry.h"
#include "render/figure/scene_geometry.h"

namespace tribolog::render {

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
  std::vector<std::string> warnings;
};

inline const Owner& owner_of(const Primitive& primitive) {
  return std::visit([](const auto& one) -> const Owner& { return one.owner; }, primitive);
}

}  // namespace tribolog::render
