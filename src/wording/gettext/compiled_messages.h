#pragma once
// templates/languages/*.po as msgfmt compiled them, in this module.

#include <vector>

namespace tribolog::wording::gettext {

struct CompiledMessages {
  const char* code;  ///< "pl"
  const char* begin;
  const char* end;
};

const std::vector<CompiledMessages>& compiled_messages();

}  // namespace tribolog::wording::gettext
