// `tribolog figures` in each format and style.

#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "cli/small_dataset.h"

namespace tribolog::test::figure_formats_test {
namespace {

std::set<std::string> names_in(const std::string& directory) {
  std::set<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    out.insert(entry.path().filename().string());
  }
  return out;
}

TEST(FigureFormats, AreFilesBesideEachOther) {
  const SmallDataset dataset;
  const ProgramRun run = dataset.run("figures --format pdf,png,svg", "figures");
  ASSERT_EQ(run.status, 0) << run.err;
  const std::set<std::string> names = names_in(dataset.file("figures"));
  for (const char* ending : {".png", ".svg", ".pdf"}) {
    EXPECT_EQ(names.count(std::string("fig-13-rough-torque") + ending), 1U) << ending;
  }
  EXPECT_EQ(names.size() % 3, 0U) << "each figure in each format";
  EXPECT_NE(run.out.find(std::to_string(names.size() / 3) + " figures as pdf, png, svg"),
            std::string::npos)
      << run.out;
  EXPECT_EQ(read_text(dataset.file("figures/fig-13-rough-torque.pdf")).rfind("%PDF-1.", 0), 0U);
  EXPECT_EQ(read_text(dataset.file("figures/fig-13-rough-torque.svg")).rfind("<svg ", 0), 0U);
}

TEST(FigureFormats, ArePngUnlessAskedFor) {
  const SmallDataset dataset;
  ASSERT_EQ(dataset.run("figures", "figures").status, 0);
  for (const std::string& name : names_in(dataset.file("figures"))) {
    EXPECT_NE(name.find(".png"), std::string::npos) << name;
  }
}

TEST(FigureFormats, KnownTruthIsAmongThemWhereItIsAskedFor) {
  const SmallDataset dataset;
  ASSERT_EQ(dataset.run("figures --format svg", "plain").status, 0);
  ASSERT_EQ(dataset.run("figures --format svg --truth-runs 2", "checked").status, 0);
  std::set<std::string> plain = names_in(dataset.file("plain"));
  EXPECT_EQ(plain.count("fig-known-truth.svg"), 0U) << "no picture pays for the check";
  plain.insert("fig-known-truth.svg");
  EXPECT_EQ(names_in(dataset.file("checked")), plain);
}

TEST(FigureFormats, ChartsAsVectorsNeedNoGraphicsStack) {
  const SmallDataset dataset;
  const std::string without = "TRIBOLOG_TEST_CRASH_FIGURE=warm-up " + program + "figures '" +
                              dataset.file("dataset.toml") + "' -o '" + dataset.file("figures") +
                              "' --format ";
  EXPECT_EQ(run_shell(without + "svg,pdf").status, 0);
  EXPECT_FALSE(names_in(dataset.file("figures")).empty());
  const ProgramRun run = run_shell(without + "svg,png");
  EXPECT_EQ(run.status, 5) << "a picture needs one";
  EXPECT_NE(run.err.find("could not be drawn; the numbers are kept"), std::string::npos) << run.err;
}

TEST(FigureFormats, OfThePaperAreAColumnWide) {
  const SmallDataset dataset;
  ASSERT_EQ(dataset.run("figures --format svg --style paper", "paper").status, 0);
  ASSERT_EQ(dataset.run("figures --format svg --style report", "report").status, 0);
  const std::string title = ">Rough sweep: driving torque against angle</text>";
  const std::string paper = read_text(dataset.file("paper/fig-13-rough-torque.svg"));
  const bool one_column = paper.find("width=\"84mm\"") != std::string::npos;
  const bool two_columns = paper.find("width=\"174mm\"") != std::string::npos;
  EXPECT_TRUE(one_column || two_columns) << paper.substr(0, 300);
  EXPECT_EQ(paper.find(title), std::string::npos) << "the caption has it";
  const std::string report = read_text(dataset.file("report/fig-13-rough-torque.svg"));
  EXPECT_NE(report.find("width=\"160mm\""), std::string::npos) << report.substr(0, 300);
  EXPECT_NE(report.find(title), std::string::npos);
}

TEST(FigureFormats, ThatDoNotExistAreUsageErrors) {
  const SmallDataset dataset;
  for (const char* wrong : {"--format tiff", "--format ''", "--style poster"}) {
    const ProgramRun run = dataset.run(std::string("figures ") + wrong, "figures");
    EXPECT_EQ(run.status, 2) << wrong << ": " << run.err;
    EXPECT_FALSE(std::filesystem::exists(dataset.file("figures"))) << wrong;
  }
}

}  // namespace
}  // namespace tribolog::test::figure_formats_test
