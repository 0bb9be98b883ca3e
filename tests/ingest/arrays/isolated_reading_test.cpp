#include "ingest/arrays/isolated_reading.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"

namespace tribolog::isolated_reading_test {
namespace {

class IsolatedReading : public testing::Test {
 protected:
  std::string refusal(const std::function<ingest::arrays::FileArrays()>& read) {
    return test::refusal_of<InputError>([&] { return ingest::arrays::read_isolated(path_, read); });
  }
  test::TemporaryDirectory directory_;
  std::string path_ = directory_.file("log", "bytes");
};

TEST_F(IsolatedReading, ArraysComeBackAsTheyWere) {
  ingest::arrays::NamedArray array{"q", 2, 3, true, {1, 2, 3, 4, 5, 6}, "rad", true};
  const ingest::arrays::FileArrays found = ingest::arrays::read_isolated(path_, [&] {
    ingest::arrays::FileArrays result;
    for (int i = 0; i < 1000; ++i) result.arrays.push_back(array);
    result.texts = {{"robot", "arm"}};
    result.leave_out("z", "why");
    return result;
  });
  ASSERT_EQ(found.arrays.size(), 1000U);
  const ingest::arrays::NamedArray& last = found.arrays.back();
  EXPECT_EQ(last.name, "q");
  EXPECT_EQ(last.unit, "rad");
  EXPECT_EQ(last.rows, 2U);
  EXPECT_EQ(last.columns, 3U);
  EXPECT_TRUE(last.by_columns);
  EXPECT_TRUE(last.was_rounded);
  EXPECT_EQ(last.values, array.values);
  EXPECT_EQ(found.texts[0].second, "arm");
  EXPECT_EQ(found.left_out[0].second, "why");
}

TEST_F(IsolatedReading, RefusalsKeepTheirReason) {
  EXPECT_EQ(refusal([]() -> ingest::arrays::FileArrays {
              throw ingest::arrays::UnreadableFile("no good");
            }),
            path_ + ": no good");
}

TEST_F(IsolatedReading, CrashesAreRefusals) {
  const std::string expected =
      path_ + ": damaged file: the library that reads it failed; hint: copy or record it again";
  EXPECT_EQ(refusal([]() -> ingest::arrays::FileArrays {
              std::raise(SIGSEGV);
              return {};
            }),
            expected);
  EXPECT_EQ(refusal([]() -> ingest::arrays::FileArrays { std::abort(); }), expected);
  EXPECT_EQ(refusal([]() -> ingest::arrays::FileArrays { std::_Exit(0); }), expected);
  EXPECT_EQ(refusal([]() -> ingest::arrays::FileArrays { throw 1; }), expected);
}

TEST_F(IsolatedReading, EndlessReadingIsARefusal) {
  EXPECT_EQ(refusal([]() -> ingest::arrays::FileArrays {
              std::raise(SIGXCPU);
              return {};
            }),
            path_ + ": damaged file: reading it does not end; hint: copy or record it again");
}

TEST_F(IsolatedReading, MemoryIsBoundedByTheFile) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer maps more than any bound";
#endif
  EXPECT_EQ(refusal([] {
              ingest::arrays::FileArrays found;
              found.arrays.resize(1);
              found.arrays[0].values.resize(std::size_t{1} << 29);
              return found;
            }),
            path_ + ": damaged file: it claims more memory than it can fill");
}

TEST_F(IsolatedReading, WhatTheLibraryPrintsIsNotSeen) {
  testing::internal::CaptureStderr();
  (void)ingest::arrays::read_isolated(path_, [] {
    std::fputs("library message\n", stderr);
    return ingest::arrays::FileArrays{};
  });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace tribolog::isolated_reading_test
