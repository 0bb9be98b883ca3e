#pragma once
// The files of templates/, compiled into the program: nothing is looked for at run time.

#include <string_view>
#include <vector>

namespace tribolog::report {

struct EmbeddedFile {
  std::string_view name;  ///< "report.tpl"
  std::string_view text;
};

/// All of them, sorted by name. Written at build time by embed_templates.cmake.
const std::vector<EmbeddedFile>& embedded_files();

/// @throw std::logic_error if there is no such file.
std::string_view embedded_file(std::string_view name);

}  // namespace tribolog::report
