#include "render/figure/figure.h"

namespace tribolog::render::figure {

Statement name_of_series(const std::string& label, std::size_t index) {
  if (label.empty()) return {"drawing.series_numbered", {{"number", index + 1}}};
  return {"drawing.series_labelled", {{"label", label}}};
}

Statement name_of_block(const Diagram& diagram, std::size_t index) {
  const Block& block = diagram.blocks[index];
  if (block.lines.empty()) return {"drawing.block_numbered", {{"number", index + 1}}};
  return {"drawing.block_labelled", {{"label", block.lines.front()}}};
}

Statement name_of_wire(std::size_t index) {
  return {"drawing.wire_numbered", {{"number", index + 1}}};
}

Statement name_of_text(const std::string& text) { return {"drawing.text", {{"text", text}}}; }

Statement name_of_part(const std::string& label) { return {"drawing.part", {{"label", label}}}; }

}  // namespace tribolog::render::figure
