#pragma once
// Which pixels must show which series (or block, or wire, or line of a scene), worked out from the
// draw list alone.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render::check {

/// Paints the list in order with the number of each series instead of its colour. A pixel counts
/// for a series only where the series covers it wholly and nothing painted later touches it, so
/// that antialiasing does not matter.
class VisibilityMap {
 public:
  struct Subject {
    figure::Owner
        owner;  ///< Role::series, Role::band, Role::block, Role::wire or Role::scene_line.
    figure::Colour colour;
    std::size_t painted{};  ///< Pixels that it covered when it was painted.
  };

  explicit VisibilityMap(const figure::DrawList& list);

  [[nodiscard]] const std::vector<Subject>& subjects() const { return subjects_; }
  /// Index into subjects() plus one, or 0.
  [[nodiscard]] std::uint16_t at(std::size_t pixel) const { return pixels_[pixel]; }
  [[nodiscard]] std::size_t size() const { return pixels_.size(); }

 private:
  void paint(const figure::Primitive& primitive);
  std::uint16_t number_of(const figure::Primitive& primitive);
  void stroke(const std::vector<figure::PixelPoint>& line, double width, std::uint16_t number);
  void bar(figure::PixelPoint a, figure::PixelPoint b, double half, double extra,
           std::uint16_t number);
  void box(const figure::PixelBox& area, std::uint16_t number);
  void disc(figure::PixelPoint centre, double radius, std::uint16_t number);
  void markers(const figure::Markers& all, std::uint16_t number);
  void ribbon(const figure::Ribbon& one, std::uint16_t number);
  void row(int y, double from, double to, std::uint16_t number);

  int width_;
  int height_;
  std::vector<std::uint16_t> pixels_;
  std::vector<Subject> subjects_;
};

}  // namespace tribolog::render::check
