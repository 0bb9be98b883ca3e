#pragma once
// What tests of an archive on a server have in common.

#include <string>

#include <gtest/gtest.h>

#include "archive/store/archive_location.h"
#include "base/error.h"
#include "support/postgres_server.h"

namespace tribolog::test {

class PostgresArchive : public testing::Test {
 protected:
  void SetUp() override {
    if (!server_.why_not().empty()) GTEST_SKIP() << server_.why_not();
  }
  /// What opening refuses with.
  struct Refusal {
    ExitStatus status{};
    std::string words;
  };
  template <class Action>
  Refusal refusal_of(const Action& action) const {
    try {
      action();
    } catch (const Error& error) {
      const std::string words = error.what();
      EXPECT_EQ(words.find(PostgresServer::password_in_uri()), std::string::npos) << words;
      EXPECT_EQ(words.find("p@ss"), std::string::npos) << words;
      EXPECT_EQ(words.find('\n'), std::string::npos) << words;
      return {error.status(), words};
    }
    return {};
  }
  Refusal refusal(const std::string& uri,
                  archive::sql::Access access = archive::sql::Access::write) const {
    return refusal_of([&] { (void)archive::store::open_archive(uri, access, 300); });
  }
  void expect(const Refusal& refused, ExitStatus status, const char* words) const {
    EXPECT_EQ(refused.status, status) << refused.words;
    EXPECT_NE(refused.words.find(words), std::string::npos) << refused.words;
  }
  static std::string replaced(std::string text, const std::string& from, const std::string& by) {
    return text.replace(text.find(from), from.size(), by);
  }

  PostgresServer& server_{PostgresServer::of_this_program()};
};

}  // namespace tribolog::test
