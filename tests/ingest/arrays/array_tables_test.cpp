#include "ingest/arrays/array_tables.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "wording/words.h"

namespace tribolog::array_tables_test {
namespace {

using Names = std::vector<std::string>;
using Values = std::vector<double>;

ingest::arrays::NamedArray counted(const std::string& name, std::size_t rows,
                                   std::size_t columns = 1) {
  ingest::arrays::NamedArray array;
  array.name = name;
  array.rows = rows;
  array.columns = columns;
  for (std::size_t i = 0; i < rows * columns; ++i) array.values.push_back(static_cast<double>(i));
  return array;
}

std::vector<ingest::log::LogTable> tables(std::vector<ingest::arrays::NamedArray> arrays) {
  ingest::arrays::FileArrays found;
  found.arrays = std::move(arrays);
  return ingest::arrays::tables_of(std::move(found), "log");
}

TEST(TablesOf, SimulinksStructuresWithTimeShareTheirClock) {
  ingest::arrays::FileArrays found;
  found.arrays = {counted("q_rad.time", 3), counted("q_rad.signals.values", 3),
                  counted("sim2.time", 3), counted("sim2.signals.values", 3)};
  found.texts = {{"sim2.signals.label", "torque_Nm"}, {"q_rad.signals.label", ""}};
  const auto result = ingest::arrays::tables_of(std::move(found), "log");
  ASSERT_EQ(result.size(), 1U);
  EXPECT_EQ(result[0].header, (Names{"time", "q_rad", "torque_Nm"}));
  // Of another clock, which none of the first's is: it stays what it is.
  auto late = counted("b.time", 3);
  late.values[2] = 7;
  const auto two = tables(
      {counted("a.time", 3), counted("a.signals.values", 3), late, counted("b.signals.values", 3)});
  EXPECT_EQ(two[0].header, (Names{"time", "a", "b.time", "b.signals.values"}));
  // Without values beside it, a time is a column like others.
  EXPECT_EQ(tables({counted("run.time", 3), counted("run.q", 3)})[0].header,
            (Names{"run.time", "run.q"}));
}

TEST(TablesOf, VectorsOfOneLengthAreOneTable) {
  const auto result = tables({counted("t", 3), counted("q", 3)});
  ASSERT_EQ(result.size(), 1U);
  EXPECT_EQ(result[0].group, "");
  EXPECT_EQ(result[0].rows, 3U);
  EXPECT_EQ(result[0].header, (Names{"t", "q"}));
  EXPECT_EQ(result[0].columns[1].values, (Values{0, 1, 2}));
}

TEST(TablesOf, OtherLengthsAreOtherTablesLongestFirst) {
  const auto result =
      tables({counted("limits", 2), counted("t", 5), counted("slow.t", 4), counted("slow.T", 4)});
  ASSERT_EQ(result.size(), 3U);
  EXPECT_EQ(result[0].group, "t");
  EXPECT_EQ(result[1].group, "slow");
  EXPECT_EQ(result[2].group, "limits");
  EXPECT_EQ(result[1].header, (Names{"slow.t", "slow.T"}));
}

TEST(TablesOf, GroupsNeverShareTheirName) {
  const auto result = tables({counted("run/a", 2), counted("run/b", 3)});
  ASSERT_EQ(result.size(), 2U);
  EXPECT_EQ(result[0].group, "run/b");
  EXPECT_EQ(result[1].group, "run/a");
}

TEST(TablesOf, MatricesTurnTheirSamplesIntoRows) {
  for (const bool samples_first : {true, false}) {
    const auto result =
        tables({counted("t", 5), samples_first ? counted("q", 5, 2) : counted("q", 2, 5)});
    ASSERT_EQ(result.size(), 1U);
    EXPECT_EQ(result[0].header, (Names{"t", "q_0", "q_1"}));
    EXPECT_EQ(result[0].columns[1].values,
              samples_first ? (Values{0, 2, 4, 6, 8}) : (Values{0, 1, 2, 3, 4}));
    EXPECT_EQ(result[0].columns[2].values,
              samples_first ? (Values{1, 3, 5, 7, 9}) : (Values{5, 6, 7, 8, 9}));
  }
}

TEST(TablesOf, StorageByColumnsIsTheSameMatrix) {
  ingest::arrays::NamedArray array = counted("q", 4, 2);
  array.by_columns = true;
  const auto result = tables({array});
  EXPECT_EQ(result[0].columns[0].values, (Values{0, 1, 2, 3}));
  EXPECT_EQ(result[0].columns[1].values, (Values{4, 5, 6, 7}));
}

TEST(TablesOf, FewSamplesOfManyJointsFollowTheTimes) {
  EXPECT_EQ(tables({counted("t", 3), counted("q", 3, 7)})[0].columns.size(), 8U);
  EXPECT_EQ(tables({counted("t", 3), counted("q", 7, 3)})[0].columns.size(), 8U);
}

TEST(TablesOf, ConstantsOfTheJointsDoNotTurnALongLog) {
  const auto result = tables({counted("ratio", 7), counted("q", 7, 1000)});
  ASSERT_EQ(result.size(), 2U);
  EXPECT_EQ(result[0].rows, 1000U);
  EXPECT_EQ(result[0].columns.size(), 7U);
}

TEST(TablesOf, SquareMatricesAreANotedGuess) {
  const auto result = tables({counted("q", 2, 2)});
  EXPECT_EQ(result[0].columns[0].values, (Values{0, 2}));
  ASSERT_EQ(result[0].notes.size(), 1U);
  EXPECT_EQ(wording::words(result[0].notes[0]),
            "'q' is 2 x 2: its first dimension is taken for the samples");
}

TEST(TablesOf, EqualNamesGetNumbers) {
  const auto result = tables({counted("q", 5, 2), counted("q_0", 5), counted("q_0", 5)});
  EXPECT_EQ(result[0].header, (Names{"q_0", "q_0_2", "q_0_3", "q_1"}));
  EXPECT_EQ(wording::words(result[0].notes),
            (Names{"column name 'q_0' occurs twice; that of array 'q_0' is now 'q_0_2'",
                   "column name 'q_0' occurs twice; that of array 'q' is now 'q_0_3'"}));
}

TEST(TablesOf, WhatIsNotFiniteIsACountedGap) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  ingest::arrays::NamedArray array = counted("q", 4);
  array.values = {1, std::nan(""), inf, -inf};
  const ingest::log::LogColumn column = tables({array})[0].columns[0];
  EXPECT_EQ(column.gaps, 3U);
  EXPECT_EQ(column.values[0], 1);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_TRUE(std::isnan(column.values[i]));
}

TEST(TablesOf, NotesSayWhatIsNoColumn) {
  ingest::arrays::FileArrays found;
  found.arrays = {counted("t", 2), counted("mass", 1)};
  found.arrays[1].values = {0.49};
  found.texts = {{"motor", "mx106"}};
  found.leave_out("z", "it holds complex numbers");
  EXPECT_EQ(wording::words(ingest::arrays::tables_of(found, "log")[0].notes),
            (Names{"mass = 0.49", "motor = 'mx106'", "'z' is not read: it holds complex numbers"}));
  for (int i = 0; i < 30; ++i) found.leave_out("x", "why");
  const auto notes = wording::words(ingest::arrays::tables_of(found, "log")[0].notes);
  ASSERT_EQ(notes.size(), 15U);
  EXPECT_EQ(notes.back(), "and 19 more that are not read");
}

TEST(TablesOf, UnitsComeFromTheNameOrTheFile) {
  ingest::arrays::NamedArray array = counted("q", 2);
  array.unit = "rad";
  const auto result = tables({counted("tau [Nm]", 2), array});
  EXPECT_EQ(result[0].columns[0].header.name, "tau");
  EXPECT_EQ(result[0].columns[0].header.unit, "Nm");
  EXPECT_EQ(result[0].columns[1].header.unit, "rad");
}

TEST(TablesOf, RefusesAFileWithoutRows) {
  ingest::arrays::FileArrays found;
  found.arrays = {counted("mass", 1)};
  found.texts = {{"motor", "mx"}};
  EXPECT_EQ(test::refusal_of<InputError>([&] { return ingest::arrays::tables_of(found, "f.mat"); }),
            "f.mat: no rows of numbers, found mass = 0; motor = 'mx', expected arrays of two or "
            "more numbers");
}

TEST(ShapeArray, DimensionsOfOneDoNotCount) {
  ingest::arrays::FileArrays found;
  ingest::arrays::NamedArray array;
  EXPECT_TRUE(ingest::arrays::shape_array({1, 1, 9}, array, found));
  EXPECT_EQ(array.rows, 9U);
  EXPECT_EQ(array.columns, 1U);
  EXPECT_TRUE(ingest::arrays::shape_array({3, 1, 4}, array, found));
  EXPECT_EQ(array.rows, 3U);
  EXPECT_EQ(array.columns, 4U);
  EXPECT_TRUE(ingest::arrays::shape_array({}, array, found));
  EXPECT_EQ(found.values, 22U);
}

TEST(ShapeArray, LeavesOutWhatIsNoTable) {
  ingest::arrays::FileArrays found;
  ingest::arrays::NamedArray array;
  array.name = "a";
  EXPECT_FALSE(ingest::arrays::shape_array({2, 3, 4}, array, found));
  EXPECT_FALSE(ingest::arrays::shape_array({5, 0}, array, found));
  EXPECT_FALSE(ingest::arrays::shape_array({1U << 31, 2}, array, found));
  EXPECT_FALSE(ingest::arrays::shape_array({~std::uint64_t{0}, ~std::uint64_t{0}}, array, found));
  EXPECT_FALSE(ingest::arrays::shape_array({5000, 5000}, array, found));
  EXPECT_EQ(found.left_out.size(), 5U);
  EXPECT_EQ(found.values, 0U);
  found.values = ingest::arrays::most_values - 1;
  EXPECT_FALSE(ingest::arrays::shape_array({2}, array, found)) << "all arrays together";
}

}  // namespace
}  // namespace tribolog::array_tables_test
