#include "support/check_findings.h"

namespace tribolog::test {

std::vector<std::string> findings_of(const method::checks::DataChecksResult& checks) {
  std::vector<std::string> names;
  for (const method::checks::DataCheck& check : checks.checks) {
    if (check.state == method::checks::CheckState::warns ||
        check.state == method::checks::CheckState::fails) {
      names.push_back(to_string(check.name));
    }
  }
  return names;
}

}  // namespace tribolog::test
