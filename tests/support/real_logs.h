#pragma once
// Real logs live beside the checkout, in ../shared/data; they are never part of the project. A test
// that wants one skips, saying so, where it is absent.

#include <optional>
#include <string>

namespace tribolog::test {

/// Path of a real log, e.g. "ur10e_jointwise/joint_2.csv", or nullopt where it is absent.
std::optional<std::string> real_log(const std::string& name);

}  // namespace tribolog::test

/// At the start of a test that needs a real log.
#define TRIBOLOG_NEEDS_REAL_LOG(name)                                       \
  if (!::tribolog::test::real_log(name)) {                                  \
    GTEST_SKIP() << "real log " << (name) << " is not beside the checkout"; \
  }
