#include "render/legibility/texts_of_list.h"

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

namespace tribolog::render::legibility {
namespace {

figure::PixelBox around(const figure::PixelBox& a, const figure::PixelBox& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

/// Lines of one drawing's block share their owner and stand apart from each other; a run with an
/// index or an accent touches the one before it.
bool continues(const ShownText& text, const figure::TextRun& run) {
  if (!(text.owner == run.owner)) return false;
  return figure::overlap_area(text.box.grown(0.4 * text.letter_px), run.box) > 0;
}

}  // namespace

std::vector<ShownText> texts_of(const figure::DrawList& list) {
  std::vector<ShownText> out;
  for (std::size_t i = 0; i < list.primitives.size(); ++i) {
    const auto* run = std::get_if<figure::TextRun>(&list.primitives[i]);
    if (run == nullptr || run->owner.role == figure::Role::text_backing) continue;
    // An accent follows the line of its letter, and other lines of the owner may stand between.
    auto before = out.rbegin();
    while (before != out.rend() && before->owner == run->owner && !continues(*before, *run)) {
      ++before;
    }
    if (before != out.rend() && continues(*before, *run)) {
      ShownText& text = *before;
      text.words += run->text;
      text.box = around(text.box, run->box);
      text.letter_px = std::max(text.letter_px, run->size);
      continue;
    }
    out.push_back({run->owner, run->text, run->box, run->size, run->colour, i});
  }
  return out;
}

}  // namespace tribolog::render::legibility
