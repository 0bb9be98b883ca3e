// Two threads identify and write reports in two languages at once: each gets the bytes that it gets
// alone.

#include <cstddef>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "api/dataset_example.h"
#include "support/run_program.h"
#include "tribolog/figures.h"
#include "tribolog/files.h"
#include "tribolog/report.h"

namespace tribolog::test::threads_test {
namespace {

struct Written {
  std::string json;
  std::string html;
};

Written write(const std::string& language, const std::string& directory, Renderer* renderer) {
  const Calibration found = identified_example();
  const Report report = make_report(found, {language, {}, "", {}}, renderer);
  for (const FigureOutcome& figure : report.figures) EXPECT_EQ(figure.error, "") << figure.id;
  write_files({{"report.html", report.html}, {"calibration.json", found.to_json()}}, directory);
  return {read_text(directory + "/calibration.json"), read_text(directory + "/report.html")};
}

TEST(Threads, GetWhatTheyGetOneAfterTheOther) {
  setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  const ScratchDirectory scratch;
  const std::vector<std::string> spoken{"en", "pl"};
  std::vector<Renderer> renderers(spoken.size());
  std::vector<Written> alone;
  for (std::size_t k = 0; k < spoken.size(); ++k) {
    alone.push_back(write(spoken[k], scratch.file(spoken[k]), &renderers[k]));
    EXPECT_NE(alone[k].html.find("<html lang=\"" + spoken[k] + "\""), std::string::npos);
  }
  for (int again = 0; again < 2; ++again) {
    std::vector<Written> together(spoken.size());
    {
      std::vector<std::jthread> threads;
      for (std::size_t k = 0; k < spoken.size(); ++k) {
        threads.emplace_back(
            [&, k] { together[k] = write(spoken[k], scratch.file(spoken[k]), &renderers[k]); });
      }
    }
    for (std::size_t k = 0; k < spoken.size(); ++k) {
      EXPECT_EQ(together[k].json, alone[k].json) << spoken[k];
      EXPECT_TRUE(together[k].html == alone[k].html) << spoken[k];
    }
  }
  unsetenv("SOURCE_DATE_EPOCH");
}

TEST(Threads, MayShareACalibration) {
  const Calibration found = identified_example();
  const std::vector<std::string> spoken{"en", "pl", "en", "pl"};
  std::vector<std::string> alone;
  for (const std::string& language : spoken)
    alone.push_back(make_report(found, {language, {}, "", {}}).html);
  for (int again = 0; again < 10; ++again) {
    std::vector<std::string> together(spoken.size());
    {
      std::vector<std::jthread> threads;
      for (std::size_t k = 0; k < spoken.size(); ++k) {
        threads.emplace_back(
            [&, k] { together[k] = make_report(found, {spoken[k], {}, "", {}}).html; });
      }
    }
    for (std::size_t k = 0; k < spoken.size(); ++k) {
      EXPECT_TRUE(together[k] == alone[k]) << spoken[k] << ", " << k;
    }
  }
}

}  // namespace
}  // namespace tribolog::test::threads_test
