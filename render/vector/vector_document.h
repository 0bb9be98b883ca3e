#pragma once
// A laid-out figure as an SVG or PDF document. No graphics stack takes part.
//
// What is painted is what the painter of pictures paints: the same list, lines as lines and text as
// text, set in a small part of the font that the document carries with it. The same list gives the
// same bytes.

#include <cstddef>
#include <string>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/text/font.h"

namespace tribolog::render::vector {

/// Plain UTF-8 text, which may be broken; shown by readers of documents and read out by others.
struct DocumentTexts {
  std::string id;  ///< Letters, digits and hyphens: names the texts inside of the document.
  std::string title;
  std::string description;  ///< The picture in words.
};

/// @param solid_parts a PNG as png_encoder.h writes it: what lies below everything else, stretched
/// over the whole figure; empty: white paper.
/// @throw tribolog::FigureError if the font cannot be embedded, or if the list has solid parts and
/// there is no picture of them.
std::string svg_document(const figure::DrawList& list, const DocumentTexts& texts,
                         const text::Font& font, const std::vector<std::byte>& solid_parts = {});

/// One page as large as the figure is in print. As svg_document().
std::string pdf_document(const figure::DrawList& list, const DocumentTexts& texts,
                         const text::Font& font, const std::vector<std::byte>& solid_parts = {});

}  // namespace tribolog::render::vector
