#pragma once
// Marks that a reader looks at one by one: no text may hide any of them, however few pixels they
// take of a panel.

#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render {

class DiscreteMarks {
 public:
  /// Takes up markers and intervals. Of a cloud of markers no single one matters; curves stay
  /// readable under a text.
  void add(const Primitive& primitive);
  void add(const PixelBox& box) { boxes_.push_back(box); }

  [[nodiscard]] bool touched_by(const PixelBox& box) const;

 private:
  std::vector<PixelBox> boxes_;
};

}  // namespace tribolog::render
