#pragma once
// Calls with typing errors, misuses and words in any order, and the answer to each.

#include <vector>

namespace tribolog::test::misuse_test {

struct Call {
  const char* arguments;
  int status;
  /// Of a refusal all of it; else a part of what is printed.
  const char* answer;
};

/// To be run one after the other in a folder with dataset.toml and log.csv and what the program
/// makes of them and of the examples.
const std::vector<Call>& calls();

}  // namespace tribolog::test::misuse_test
