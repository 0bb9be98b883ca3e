#pragma once
// The texts of a draw list as a reader sees them: runs of one owner joined.

#include <cstddef>
#include <string>
#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render::legibility {

struct ShownText {
  figure::Owner owner;
  std::string words;
  figure::PixelBox box;   ///< Around all runs.
  int letter_px{};        ///< Of the largest run: indices are smaller, and may be.
  figure::Colour colour;  ///< Of the first run.
  std::size_t painted{};  ///< Place of the first run in the list.
};

/// In the order in which they are painted. White outlines below a text are no texts.
std::vector<ShownText> texts_of(const figure::DrawList& list);

}  // namespace tribolog::render::legibility
