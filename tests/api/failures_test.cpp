// What a call cannot do is a Failure of the kind that says what to do, at file, line and column.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "api/dataset_example.h"
#include "support/run_program.h"
#include "tribolog/failure.h"
#include "tribolog/figures.h"
#include "tribolog/files.h"
#include "tribolog/report.h"

namespace tribolog::test::failures_test {
namespace {

/// The failure that the call ends with; one of kind internal where it ends without.
Failure failure_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Failure& failure) {
    return failure;
  }
  ADD_FAILURE() << "no failure";
  return {Failure::Kind::internal, ""};
}

TEST(AFailure, NamesTheMissingFile) {
  const Failure failure = failure_of([] { Dataset::read("/no/such/dataset.toml"); });
  EXPECT_EQ(failure.kind(), Failure::Kind::input_refused);
  EXPECT_EQ(failure.exit_status(), 3);
  EXPECT_STREQ(failure.file(), "/no/such/dataset.toml");
  EXPECT_EQ(failure.line(), 0);
  EXPECT_NE(std::string(failure.what()).find("/no/such/dataset.toml: cannot open"),
            std::string::npos)
      << failure.what();
}

TEST(AFailure, NamesLineAndColumnOfAManifest) {
  const ScratchDirectory scratch;
  std::string text = read_text(example_manifest);
  const std::string value = "gear_ratio = 101";
  const std::size_t at = text.find(value);
  ASSERT_NE(at, std::string::npos);
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
  const long line = 1 + std::count(text.begin(), end, '\n');
  const std::string manifest =
      scratch.write("dataset.toml", text.replace(at, value.size(), "gear_ratio = \"hundred\""));
  const Failure failure = failure_of([&] { Dataset::read(manifest); });
  EXPECT_EQ(failure.kind(), Failure::Kind::input_refused);
  EXPECT_EQ(failure.file(), manifest);
  EXPECT_EQ(failure.line(), line);
  EXPECT_EQ(failure.column(), 14);
  EXPECT_EQ(std::string(failure.what()).find(fmt::format("{}:{}:14: ", manifest, line)), 0U)
      << failure.what();
}

TEST(AFailure, IsOfTheKindThatTheProgramEndsWith) {
  const Dataset dataset = Dataset::read(example_manifest);
  const auto status = [](const std::function<void()>& call) {
    return failure_of(call).exit_status();
  };
  const Calibration found = identified_example();
  EXPECT_EQ(status([&] { static_cast<void>(found.sentence("tlh")); }), 2);
  EXPECT_EQ(status([&] { static_cast<void>(dataset.notes("tlh")); }), 2);
  EXPECT_EQ(status([&] { make_report(found, {"tlh", {}, "", {}}); }), 2);
  EXPECT_EQ(status([&] { draw_figures(found); }), 2) << "pictures without a renderer";
  EXPECT_EQ(status([&] { found.write("/no/such/folder/calibration.json"); }), 4);
  EXPECT_EQ(status([&] { write_files({{"a", "1"}}, "/dev/null/folder"); }), 4);
  const Calibration read = Calibration::from_json(found.to_json());
  EXPECT_EQ(status([&] { make_report(read); }), 2) << "there are no recordings to show";
}

TEST(AFailure, IsWhatBecomesOfDamagedJson) {
  const std::string json = identified_example().to_json();
  for (const std::string& damaged :
       {std::string(), std::string("{}"), json.substr(0, json.size() / 2), "[" + json + "]",
        std::string(100'000, '[')}) {
    const Failure failure = failure_of([&] { Calibration::from_json(damaged, "kept.json"); });
    EXPECT_EQ(failure.kind(), Failure::Kind::input_refused);
    EXPECT_STREQ(failure.file(), "kept.json");
  }
}

TEST(AFailure, LeavesNoFileOfSeveral) {
  const ScratchDirectory scratch;
  scratch.write("kept.txt", "old");
  const Failure failure = failure_of(
      [&] { write_files({{"kept.txt", "new"}, {"no/such/folder.txt", "new"}}, scratch.path()); });
  EXPECT_EQ(failure.kind(), Failure::Kind::output_failed);
  EXPECT_EQ(read_text(scratch.file("kept.txt")), "old");
}

}  // namespace
}  // namespace tribolog::test::failures_test
