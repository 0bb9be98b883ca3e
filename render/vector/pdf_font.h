#pragma once
// A subset of the font as objects of a PDF file.

#include "render/vector/document_face.h"
#include "render/vector/pdf_file.h"

namespace tribolog::render {

/// The number of the font's object. Codes in texts are two bytes, the glyph's number in the subset;
/// a map to Unicode lets texts be searched and copied.
int add_font(PdfFile& file, const DocumentFace& face);

}  // namespace tribolog::render
