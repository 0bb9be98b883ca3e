// Columns without names that tell, by their numbers.

#include "inspect/survey/column_guess.h"

#include <cmath>

#include <gtest/gtest.h>

namespace tribolog::column_guess_test {
namespace {

ingest::log::LogTable table_of(
    const std::vector<std::pair<std::string, std::vector<double>>>& columns) {
  ingest::log::LogTable table;
  for (const auto& [name, values] : columns) {
    ingest::log::LogColumn column;
    column.header = {name, name, ""};
    column.values = values;
    table.columns.push_back(std::move(column));
    table.rows = values.size();
  }
  return table;
}

TEST(ColumnGuess, FindsClockAngleAndSpeed) {
  std::vector<double> t, q, v, i;
  for (int k = 0; k < 500; ++k) {
    t.push_back(0.01 * k);
    q.push_back(std::sin(t.back()));
    v.push_back(57.29578 * std::cos(t.back()));
    i.push_back(std::cos(t.back()) > 0 ? 1.5 : -1.5);
  }
  const ingest::log::LogTable table = table_of({{"#1", i}, {"#2", t}, {"#3", v}, {"#4", q}});
  const auto guesses = inspect::survey::guess_by_numbers(table, {}).meanings;
  ASSERT_EQ(guesses.size(), 3U);
  EXPECT_EQ(guesses[0].meaning.column, 1U);
  EXPECT_EQ(guesses[0].meaning.quantity, ingest::log::Quantity::time);
  EXPECT_EQ(guesses[1].meaning.column, 3U);
  EXPECT_EQ(guesses[1].meaning.quantity, ingest::log::Quantity::angle);
  EXPECT_EQ(guesses[2].meaning.column, 2U);
  EXPECT_EQ(guesses[2].meaning.quantity, ingest::log::Quantity::angular_speed);
  for (const auto& guess : guesses) EXPECT_FALSE(guess.reason.empty());
}

TEST(ColumnGuess, ConstantColumnsAreNoSlopeAndAccelerationsNoSpeed) {
  std::vector<double> t, q, v, a, constant;
  for (int k = 0; k < 3000; ++k) {
    t.push_back(12345 + 0.01 * k);
    q.push_back(std::sin(t.back()) + 0.1 * std::sin(2.3 * t.back()));
    v.push_back(std::cos(t.back()) + 0.23 * std::cos(2.3 * t.back()));
    a.push_back(-std::sin(t.back()) - 0.529 * std::sin(2.3 * t.back()));
    constant.push_back(31.1);
  }
  const ingest::log::LogTable table =
      table_of({{"#1", t}, {"#2", constant}, {"#3", v}, {"#4", a}, {"#5", q}, {"#6", constant}});
  const auto guesses = inspect::survey::guess_by_numbers(table, {}).meanings;
  ASSERT_EQ(guesses.size(), 3U);
  EXPECT_EQ(guesses[1].meaning.column, 4U);
  EXPECT_EQ(guesses[2].meaning.column, 2U);
}

/// A clock, three angles, three speeds and three others; the second joint moves.
ingest::log::LogTable three_joints(std::size_t left_out) {
  std::vector<std::vector<double>> columns(10);
  for (int k = 0; k < 1000; ++k) {
    const double t = 0.01 * k;
    const std::vector<double> row{
        t, 0.1, std::sin(t), 0.3, 0, std::cos(t), 0, 1, std::cos(t) > 0 ? 2.0 : -2.0, 3};
    for (std::size_t c = 0; c < row.size(); ++c) columns[c].push_back(row[c]);
  }
  std::vector<std::pair<std::string, std::vector<double>>> named;
  for (std::size_t c = 0; c + left_out < columns.size(); ++c) {
    named.emplace_back("#" + std::to_string(c + 1), columns[c]);
  }
  return table_of(named);
}

TEST(ColumnGuess, ColumnsInGroupsAreThoseOfSeveralJoints) {
  const auto guessed = inspect::survey::guess_by_numbers(three_joints(0), {});
  ASSERT_TRUE(guessed.groups);
  EXPECT_EQ(guessed.groups->first, 1U);
  EXPECT_EQ(guessed.groups->joints, 3U);
  EXPECT_EQ(guessed.groups->joint_of(8), "2");
  ASSERT_EQ(guessed.meanings.size(), 7U);
  for (const auto& guess : guessed.meanings) {
    const std::size_t column = guess.meaning.column;
    if (guess.meaning.quantity == ingest::log::Quantity::time) continue;
    EXPECT_EQ(guess.meaning.joint, std::to_string((column - 1) % 3 + 1)) << column;
    EXPECT_EQ(guess.meaning.quantity == ingest::log::Quantity::angle, column < 4) << column;
  }
}

/// A clock, then two columns of each signal; the second joint moves.
std::optional<std::size_t> first_effort(const std::vector<double (*)(double)>& signals) {
  std::vector<std::pair<std::string, std::vector<double>>> columns(1 + 2 * signals.size());
  for (std::size_t c = 0; c < columns.size(); ++c) columns[c].first = "#" + std::to_string(c + 1);
  for (int k = 0; k < 2000; ++k) {
    const double t = 0.01 * k;
    columns[0].second.push_back(t);
    for (std::size_t s = 0; s < signals.size(); ++s) {
      columns[1 + 2 * s].second.push_back(0.1);
      columns[2 + 2 * s].second.push_back(signals[s](t));
    }
  }
  return inspect::survey::first_effort_by_place(table_of(columns), 0, {1, 2});
}

TEST(ColumnGuess, TheFirstGroupThatIsNoSetPointAndNoAccelerationMayBeTheEfforts) {
  const auto angle = [](double t) { return std::sin(t) + 0.3 * std::sin(2.3 * t); };
  const auto speed = [](double t) { return std::cos(t) + 0.69 * std::cos(2.3 * t); };
  const auto acceleration = [](double t) { return -std::sin(t) - 1.587 * std::sin(2.3 * t); };
  const auto set_point = [](double t) { return 57.3 * (std::sin(t) + 0.301 * std::sin(2.3 * t)); };
  const auto effort = [](double t) {
    const double v = std::cos(t) + 0.69 * std::cos(2.3 * t);
    return 3 * std::cos(std::sin(t)) + (v > 0 ? 2 : -2);
  };
  const auto still = [](double) { return 7.0; };
  EXPECT_EQ(first_effort({angle, speed, effort, set_point}), 5U);
  EXPECT_EQ(first_effort({angle, speed, still, set_point, acceleration, effort}), 11U);
  EXPECT_EQ(first_effort({angle, speed, acceleration}), std::nullopt);
  EXPECT_EQ(first_effort({angle, speed}), std::nullopt);
}

TEST(ColumnGuess, ColumnsThatCannotBeCutIntoGroupsAreOneJoints) {
  const auto guessed = inspect::survey::guess_by_numbers(three_joints(1), {});
  EXPECT_FALSE(guessed.groups);
  EXPECT_EQ(guessed.meanings.size(), 3U);
}

TEST(ColumnGuess, WhatTheNamesTellIsNotGuessedAgain) {
  ingest::layout::LogLayout layout;
  ingest::layout::ColumnMeaning angle;
  angle.quantity = ingest::log::Quantity::angle;
  angle.column = 1;
  ingest::layout::ColumnMeaning time;
  time.quantity = ingest::log::Quantity::time;
  layout.columns = {time, angle};
  const ingest::log::LogTable table = table_of({{"t", {0, 1, 2, 3}}, {"q", {0, 1, 2, 3}}});
  EXPECT_TRUE(inspect::survey::guess_by_numbers(table, layout).meanings.empty());
}

TEST(ColumnGuess, NothingIsMadeOfNoise) {
  const ingest::log::LogTable table = table_of({{"a", {1, 1, 1}}, {"b", {NAN, NAN, NAN}}});
  EXPECT_TRUE(inspect::survey::guess_by_numbers(table, {}).meanings.empty());
}

TEST(ColumnGuess, ThirtyTurnsOfRadiansAreDegrees) {
  EXPECT_TRUE(inspect::survey::looks_like_degrees({-90, 90}));
  EXPECT_FALSE(inspect::survey::looks_like_degrees({-3.1, 3.1}));
  EXPECT_FALSE(inspect::survey::looks_like_degrees({}));
}

}  // namespace
}  // namespace tribolog::column_guess_test
