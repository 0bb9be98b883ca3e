#pragma once
// Which texts an archive keeps.

#include <string_view>

#include "base/utf8.h"

namespace tribolog::sql {

/// SQLite would keep any bytes, PostgreSQL refuses some: both take UTF-8 without the character NUL.
inline bool is_kept_text(std::string_view text) {
  return text.find('\0') == std::string_view::npos && !first_broken_utf8(text);
}

}  // namespace tribolog::sql
