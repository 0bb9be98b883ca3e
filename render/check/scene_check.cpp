#include "render/check/scene_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/figure/part_names.h"
#include "render/layout/occupancy.h"
#include "render/scene/part_map.h"

namespace tribolog::render::check {
namespace {

constexpr std::size_t least_visible_px = 30;  // for a picture of any size: a dot
constexpr double least_part_share = 0.5;      // of the pixels that must show a part
constexpr double darkest_shade = 0.2;         // of a part's colour
constexpr double most_part_hue_error = 40;    // of 255
constexpr int edge_px = 4;                    // outlines and antialiasing reach that far

/// Whether a pixel is the colour in some light.
bool shows_shaded(figure::Colour pixel, figure::Colour colour) {
  const double wanted[] = {colour.red + 1.0, colour.green + 1.0, colour.blue + 1.0};
  const double found[] = {pixel.red + 1.0, pixel.green + 1.0, pixel.blue + 1.0};
  double across = 0;
  double along = 0;
  for (int i = 0; i < 3; ++i) {
    across += wanted[i] * found[i];
    along += wanted[i] * wanted[i];
  }
  const double light = across / along;
  if (light < darkest_shade) return false;
  double error = 0;
  for (int i = 0; i < 3; ++i) error = std::max(error, std::abs(found[i] - light * wanted[i]));
  return error <= most_part_hue_error;
}

struct Count {
  std::size_t visible{};  ///< Pixels of the part that no other part hides.
  std::size_t expected{};
  std::size_t found{};
};

}  // namespace

void check_parts(const figure::DrawList& list, const figure::Picture& picture,
                 PictureFindings& findings) {
  if (!list.scene) return;
  const auto& meshes = list.scene->meshes;
  const scene::PartMap parts(*list.scene, list.width, list.height);
  const figure::PixelBox whole{0, 0, static_cast<double>(list.width),
                               static_cast<double>(list.height)};
  layout::Occupancy drawn_over(whole);
  for (const figure::Primitive& primitive : list.primitives) drawn_over.mark(primitive);
  std::vector<Count> counts(meshes.size());
  for (int y = 0; y < list.height; ++y) {
    for (int x = 0; x < list.width; ++x) {
      const std::uint16_t number = parts.at(x, y);
      if (number == 0 || meshes[number - 1U].label.empty()) continue;
      Count& count = counts[number - 1U];
      ++count.visible;
      if (!parts.inside(x, y, edge_px)) continue;
      if (drawn_over.taken({x + 0.0, y + 0.0, x + 1.0, y + 1.0}) > 0) continue;
      ++count.expected;
      if (shows_shaded(picture.at(x, y), meshes[number - 1U].colour)) ++count.found;
    }
  }
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (meshes[i].label.empty()) continue;
    const Statement name = figure::name_of_part(meshes[i].label);
    if (counts[i].visible < least_visible_px) {
      findings.warnings.push_back({"drawing.part_hidden", {{"part", name}}});
    } else if (static_cast<double>(counts[i].found) <
               least_part_share * static_cast<double>(counts[i].expected)) {
      findings.error = {
          "drawing.not_visible",
          {{"what", name}, {"found", counts[i].found}, {"expected", counts[i].expected}}};
      return;
    }
  }
}

}  // namespace tribolog::render::check
