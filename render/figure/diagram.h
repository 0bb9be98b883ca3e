#pragma once
// A drawing as plain data: blocks, wires and free shapes on a canvas. No VTK type.
//
// Lengths and points are millimetres of a page on which a picture 1600 px wide is 160 mm wide; the
// origin is the canvas's top left corner and y points downwards. Line widths are pixels of that
// picture. Text, lines and canvas grow and shrink together. Texts use the markup of figure.h.

#include <optional>
#include <string>
#include <vector>

#include "render/figure/drawing_style.h"

namespace tribolog::render::figure {

struct DiagramPoint {
  double x{};
  double y{};
  friend bool operator==(const DiagramPoint&, const DiagramPoint&) = default;
};

enum class BlockSide { left, right, top, bottom };

enum class BlockKind {
  plain,             ///< Rectangle.
  gain,              ///< Triangle that points to `faces`.
  integrator,        ///< Rectangle with an integral sign; `lines` are not shown.
  summing_junction,  ///< Circle of diameter `width`.
  selector,          ///< Rectangle with a switch: two inputs opposite of `faces`, one is connected.
  terminal,          ///< Rounded: where a signal enters or leaves.
  fixed_support,     ///< A surface along the side `faces`, hatched behind.
  frame,             ///< Dashed rectangle around other blocks; `lines` stand in its upper corner.
};

/// "+" or "÷" inside a block, at the place where a wire enters.
struct PortSign {
  BlockSide side{BlockSide::left};
  double offset{};  ///< From the middle of the side, rightwards or downwards.
  std::string text;
};

struct Block {
  BlockKind kind{BlockKind::plain};
  std::vector<std::string> lines;  ///< Text, one above the other; may be empty.
  DiagramPoint centre;
  double width{};
  double height{};
  BlockSide faces{BlockSide::right};
  std::vector<PortSign> signs;
  Colour colour{palette::black};  ///< Of the outline.
  Colour fill{255, 255, 255};
};

enum class TextPlace { centre, left, right, above, below };

/// A text that stands centred on a point or beside it.
struct DiagramText {
  std::string text;
  DiagramPoint at;
  TextPlace place{TextPlace::above};
  bool bold{false};
  Colour colour{palette::black};
};

/// A signal. It starts and ends at a block's outline, or starts at a branch dot of its own that
/// lies on another wire.
struct Wire {
  std::vector<DiagramPoint> points;  ///< At least 2.
  bool arrow{true};                  ///< A head at the last point.
  std::vector<DiagramPoint> branch_dots;
  std::optional<DiagramText> label;
  Colour colour{palette::black};
};

/// A line of a sketch.
struct Stroke {
  std::vector<DiagramPoint> points;
  Colour colour{palette::black};
  double width_px{2.5};
  LineStyle style{LineStyle::solid};
  bool arrow_at_start{false};
  bool arrow_at_end{false};
};

/// A filled convex outline, below every line.
struct Area {
  std::vector<DiagramPoint> outline;
  Colour colour{palette::grey};
};

/// Part of a circle, from one angle to the other; 0° points right, positive is clockwise as seen.
struct Arc {
  DiagramPoint centre;
  double radius{};
  double from_deg{0.0};
  double to_deg{360.0};
  Colour colour{palette::black};
  double width_px{2.5};
  bool arrow_at_end{false};
  std::optional<Colour> fill;  ///< Of the whole disc.
};

/// A double arrow between two points, with a text at its middle.
struct Dimension {
  DiagramPoint from;
  DiagramPoint to;
  std::string text;
  TextPlace place{TextPlace::above};
  Colour colour{palette::black};
};

struct Diagram {
  double width{160.0};
  double height{90.0};
  std::vector<Area> areas;
  std::vector<Block> blocks;
  std::vector<Wire> wires;
  std::vector<Stroke> strokes;
  std::vector<Arc> arcs;
  std::vector<Dimension> dimensions;
  std::vector<DiagramText> texts;
};

}  // namespace tribolog::render::figure
