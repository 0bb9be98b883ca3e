#pragma once
// Whether two renderers drew the same.

#include <cstddef>

#include "render/figure/draw_list.h"
#include "render/figure/picture.h"

namespace tribolog::render {

/// Pixels of either picture of which the other has no like within 2 px, as a share of all. Both are
/// smoothed over 3 x 3 pixels: edges are softened by each renderer in its own way, and letters are
/// hinted in ours.
double unmatched_share(const figure::Picture& a, const figure::Picture& b);

/// Measured over the paper's figures: at most 0.0002 in the 10 pixels to the millimetre of a
/// report, all of it on letters, which are hinted in ours; at most 0.0006 in the 20 of a
/// publication, where hinting moves a stem by more pixels. A curve that is missing or in the wrong
/// place is ten times as much, an axis title three times.
inline double most_unmatched(const figure::DrawList& list) {
  constexpr double to_each_px_per_mm = 0.00005;
  return to_each_px_per_mm * list.width / list.width_mm;
}

struct SampledInk {
  std::size_t asked{};  ///< Points on curves and filled shapes that the first picture shows.
  std::size_t found{};  ///< Of these, points at which the second one has the colour within 2 px.
};

/// Looks at every fifth pixel along lines, at the middle of markers and polygons, and along the
/// middle of bands.
SampledInk sampled_ink(const figure::DrawList& list, const figure::Picture& first,
                       const figure::Picture& second);

}  // namespace tribolog::render
