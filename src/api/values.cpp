#include "tribolog/values.h"

#include "base/enum_text.h"
#include "wording/language.h"

namespace tribolog {

std::string code_of(Verdict verdict) { return own_name(verdict); }

std::vector<std::string> languages() {
  std::vector<std::string> codes;
  for (const wording::Language& one : wording::languages()) codes.push_back(one.code);
  return codes;
}

std::string version() { return TRIBOLOG_VERSION; }

}  // namespace tribolog
