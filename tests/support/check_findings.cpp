#include "support/check_findings.h"

namespace tribolog::test {

std::vector<std::string> findings_of(const DataChecksResult& checks) {
  std::vector<std::string> names;
  for (const DataCheck& check : checks.checks) {
    if (check.state == CheckState::warns || check.state == CheckState::fails) {
      names.push_back(check.name);
    }
  }
  return names;
}

}  // namespace tribolog::test
