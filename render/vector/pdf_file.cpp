#include "render/vector/pdf_file.h"

#include <cstdint>

#include <fmt/format.h>

#include "render/png/zlib_compression.h"
#include "render/text/utf8.h"

namespace tribolog::render {

int PdfFile::reserve() {
  objects_.emplace_back();
  return static_cast<int>(objects_.size());
}

void PdfFile::write(int number, const std::string& body) {
  objects_.at(static_cast<std::size_t>(number) - 1) = body;
}

int PdfFile::add(const std::string& body) {
  objects_.push_back(body);
  return static_cast<int>(objects_.size());
}

int PdfFile::add_stream(const std::string& data, const std::string& entries) {
  const std::vector<std::uint8_t> packed = zlib_compressed({data.begin(), data.end()});
  return add_compressed(std::string(packed.begin(), packed.end()), entries);
}

int PdfFile::add_compressed(const std::string& data, const std::string& entries) {
  return add(fmt::format("<< {} /Filter /FlateDecode /Length {} >>\nstream\n{}\nendstream", entries,
                         data.size(), data));
}

std::string PdfFile::finish(int catalogue, int information) {
  // Bytes above 127 in the second line tell programs that the file is not text.
  std::string out = "%PDF-1.7\n%\xE2\xE3\xCF\xD3\n";
  std::string table = fmt::format("xref\n0 {}\n0000000000 65535 f \n", objects_.size() + 1);
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    table += fmt::format("{:010} 00000 n \n", out.size());
    out += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects_[i]);
  }
  const std::size_t table_at = out.size();
  return out + table +
         fmt::format("trailer\n<< /Size {} /Root {} /Info {} >>\nstartxref\n{}\n%%EOF\n",
                     objects_.size() + 1, pdf_reference(catalogue), pdf_reference(information),
                     table_at);
}

std::string pdf_reference(int number) { return fmt::format("{} 0 R", number); }

std::string pdf_text(const std::string& utf8) {
  constexpr char32_t first_of_pairs = 0x10000;
  std::string out = "<FEFF";
  for (char32_t c : decode_utf8(utf8).text) {
    if (c < first_of_pairs) {
      out += fmt::format("{:04X}", static_cast<std::uint32_t>(c));
      continue;
    }
    c -= first_of_pairs;
    out += fmt::format("{:04X}{:04X}", 0xD800U + (static_cast<std::uint32_t>(c) >> 10U),
                       0xDC00U + (static_cast<std::uint32_t>(c) & 0x3FFU));
  }
  return out + ">";
}

}  // namespace tribolog::render
