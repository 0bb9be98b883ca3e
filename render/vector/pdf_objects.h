#pragma once
// The objects of a PDF file: its skeleton, fonts and pictures.

#include <cstddef>
#include <string>
#include <vector>

#include "render/vector/vector_canvas.h"

namespace tribolog::render::vector {

class PdfFile {
 public:
  /// A number for an object that is written later.
  int reserve();
  /// Writes a reserved object. @param body "<< /Type /Page ... >>"
  void write(int number, const std::string& body);
  /// Writes a new one; its number.
  int add(const std::string& body);
  /// A compressed stream; its number. @param entries of its dictionary besides length and filter
  int add_stream(const std::string& data, const std::string& entries = {});
  /// A stream that is compressed already.
  int add_compressed(const std::string& data, const std::string& entries);

  /// The whole file. Nothing may be written after it.
  std::string finish(int catalogue, int information);

 private:
  std::vector<std::string> objects_;
};

/// A reference to an object: "12 0 R".
std::string pdf_reference(int number);

/// A text for readers, from UTF-8 that may be broken: "<FEFF0041>".
std::string pdf_text(const std::string& utf8);

// A subset of the font as objects of a PDF file.

/// The number of the font's object. Codes in texts are two bytes, the glyph's number in the subset;
/// a map to Unicode lets texts be searched and copied.
int add_font(PdfFile& file, const DocumentFace& face);

// A PNG of ours as an image of a PDF file: its pixels stay compressed as they are.

/// The number of the image's object. @param png as png_encoder.h writes it: no interlace, no alpha
/// @throw tribolog::FigureError if it is not such a picture.
int add_picture(PdfFile& file, const std::vector<std::byte>& png);

}  // namespace tribolog::render::vector
