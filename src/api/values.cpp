#include "tribolog/values.h"

#include "wording/language.h"

namespace tribolog {

std::string code_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::usable:
      return "usable";
    case Verdict::doubtful:
      return "doubtful";
    case Verdict::not_identifiable:
      break;
  }
  return "not_identifiable";
}

std::vector<std::string> languages() {
  std::vector<std::string> codes;
  for (const wording::Language& one : wording::languages()) codes.push_back(one.code);
  return codes;
}

std::string version() { return TRIBOLOG_VERSION; }

}  // namespace tribolog
