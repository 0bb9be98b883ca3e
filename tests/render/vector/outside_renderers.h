#pragma once
// Programs of others that read our documents.

#include <string>
#include <vector>

#include "render/figure/picture.h"

namespace tribolog::render {

bool has_program(const std::string& name);

/// Drawn at so many pixels. @throw std::runtime_error with what the program said.
figure::Picture pdf_by_cairo(const std::string& pdf, int width, int height);
/// Poppler's own renderer, which widens thin lines to whole pixels.
figure::Picture pdf_by_splash(const std::string& pdf, int width, int height);
figure::Picture svg_by_librsvg(const std::string& svg, int width, int height);
/// The only one that reads the font inside of the document.
figure::Picture svg_by_chromium(const std::string& svg, int width, int height);

/// Empty if the file is sound; else what qpdf complains of.
std::string complaints_of_qpdf(const std::string& pdf);
/// The lines of `pdffonts` behind its head, one for each font.
std::vector<std::string> fonts_by_poppler(const std::string& pdf);
std::string text_by_poppler(const std::string& pdf);

/// What a parser of XML finds in an SVG, one text each: `title`, `desc`, then every `text`.
/// @throw std::runtime_error if it is not well-formed.
std::vector<std::string> texts_of_svg(const std::string& svg);

}  // namespace tribolog::render
