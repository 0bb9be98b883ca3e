#pragma once
// The skeleton of a PDF file: numbered objects, streams and the table of where they are.

#include <string>
#include <vector>

namespace tribolog::render {

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

}  // namespace tribolog::render
