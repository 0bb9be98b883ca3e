#pragma once
// The files of templates/, compiled into the program: nothing is looked for at run time.

#include "base/embedded_file.h"

namespace tribolog::report::engine {

/// All of them, sorted by name.
const std::vector<EmbeddedFile>& embedded_files();

/// @throw std::logic_error if there is no such file.
inline std::string_view embedded_file(std::string_view name) {
  return text_of(embedded_files(), name);
}

}  // namespace tribolog::report::engine
