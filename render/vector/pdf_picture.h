#pragma once
// A PNG of ours as an image of a PDF file: its pixels stay compressed as they are.

#include <cstddef>
#include <vector>

#include "render/vector/pdf_file.h"

namespace tribolog::render {

/// The number of the image's object. @param png as png_encoder.h writes it: no interlace, no alpha
/// @throw tribolog::FigureError if it is not such a picture.
int add_picture(PdfFile& file, const std::vector<std::byte>& png);

}  // namespace tribolog::render
