#pragma once
// A draw list as the content of a PDF page.

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "render/vector/document_face.h"
#include "render/vector/vector_canvas.h"

namespace tribolog::render {

/// Writes operators in pixels of the list, y downwards: the page turns them over.
class PdfCanvas : public VectorCanvas {
 public:
  explicit PdfCanvas(const std::vector<DocumentFace>& faces) : faces_(faces) {}

  void fill(const std::vector<Points>& outlines, Colour colour) override;
  void fill_discs(const Points& centres, double radius, Colour colour) override;
  void stroke(const std::vector<Points>& lines, const StrokeLook& look) override;
  void text(const TextRun& run) override;

  [[nodiscard]] const std::string& content() const { return out_; }
  /// What the page needs as graphics state "/A50" for each.
  [[nodiscard]] const std::set<int>& alphas() const { return alphas_; }

 private:
  void use_alpha(int alpha);

  const std::vector<DocumentFace>& faces_;
  std::string out_;
  std::set<int> alphas_;
  int alpha_{255};
};

/// "/F0" for the regular weight, "/F1" for the bold one.
const char* pdf_font_name(Weight weight);

}  // namespace tribolog::render
