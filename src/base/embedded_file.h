#pragma once
// A file that was compiled into the program; see embed_files.cmake.

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog {

struct EmbeddedFile {
  std::string_view name;  ///< Without directories: "report.tpl".
  std::string_view text;
};

/// The text of one of them. @throw std::logic_error if there is no such file.
inline std::string_view text_of(const std::vector<EmbeddedFile>& files, std::string_view name) {
  for (const EmbeddedFile& file : files) {
    if (file.name == name) return file.text;
  }
  throw std::logic_error("no embedded file " + std::string(name));
}

}  // namespace tribolog
