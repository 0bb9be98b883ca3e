#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "ingest/dataset/recording_rows.h"

namespace tribolog::ingest::dataset {
namespace {

constexpr std::size_t fewest_points = 3;

std::vector<double>& signal_of(joint::FrictionPoints& points, joint::LoggedSignal signal) {
  switch (signal) {
    case joint::LoggedSignal::effort:
      return points.torque_Nm;
    case joint::LoggedSignal::temperature:
      return points.temperature_C;
    case joint::LoggedSignal::load:
      return points.load_Nm;
    default:
      break;
  }
  return points.speed_rad_s;
}

/// A table of amounts for both directions, say, or a torque that the joint exerts on the drive.
void refuse_torque_against_speed(const joint::FrictionPoints& points, const log::LogTable& table) {
  for (const double sign : {1.0, -1.0}) {
    std::size_t all = 0;
    std::size_t against = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points.speed_rad_s[i] * sign <= 0) continue;
      ++all;
      against += points.torque_Nm[i] * sign < 0 ? 1 : 0;
    }
    if (2 * against <= all) continue;
    throw InputError({table.file, 0, 0},
                     {"friction acts along the speed",
                      fmt::format("at {} of {} points of {} speed the torque has the other sign",
                                  against, all, sign > 0 ? "positive" : "negative"),
                      "torque with the sign of the speed, as the motor has to give it",
                      "effort.sign = -1 where the table counts the other way round; amounts of "
                      "friction for both "
                      "directions need the sign of their speed"});
  }
}

}  // namespace

joint::FrictionPoints make_friction_points(const manifest::RecordingEntry& entry,
                                           const log::LogTable& table, const joint::Drive& drive,
                                           double effort_sign,
                                           std::vector<Statement>& notes_of_all) {
  RecordingNotes notes(entry.file, notes_of_all);
  note_reading(table, notes);
  const std::vector<LoggedColumn> columns = logged_columns(entry.columns);
  joint::FrictionPoints points;
  points.name = entry.file;
  points.rows_read = table.rows + table.cut_rows + table.bad_rows + table.unclear_rows;
  const auto skip = [&](const Statement& reason, std::size_t count) {
    if (count > 0) points.skipped.push_back({reason, count});
  };
  // Speed and torque at the motor; a recording's speed is the joint's.
  std::vector<double> factors;
  std::vector<double> bounds;
  for (const LoggedColumn& column : columns) {
    const bool is_speed = column.signal == joint::LoggedSignal::speed;
    factors.push_back(conversion_of(column, drive, effort_sign).factor() *
                      (is_speed ? drive.gear_ratio() : 1));
    bounds.push_back(largest_possible(*column.entry));
  }
  std::size_t at_rest = 0;
  std::vector<std::size_t> gaps(columns.size());
  std::vector<std::size_t> impossible(columns.size());
  std::vector<double> values(columns.size());
  for (std::size_t row = 0; row < table.rows; ++row) {
    std::size_t gap = columns.size();
    bool rests = false;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const double logged = table.columns[k].values[row];
      values[k] = logged * factors[k];
      if (std::isnan(logged)) {
        gap = std::min(gap, k);
      } else if (!(std::abs(logged) <= bounds[k])) {
        refuse_impossible_value(*columns[k].entry, logged, table, row);
      }
      rests |= columns[k].signal == joint::LoggedSignal::speed && logged == 0;
    }
    if (gap < columns.size()) {
      ++(table.columns[gap].is_impossible(row) ? impossible : gaps)[gap];
    } else if (rests) {
      ++at_rest;
    } else {
      for (std::size_t k = 0; k < columns.size(); ++k) {
        signal_of(points, columns[k].signal).push_back(values[k]);
      }
    }
  }
  skip(Code{"skipped.cut_off"}, table.cut_rows);
  skip(Code{"skipped.not_usable"}, table.bad_rows);
  skip(Code{"skipped.unclear_joint_state"}, table.unclear_rows);
  skip(Code{"skipped.point_at_rest"}, at_rest);
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    const std::string column = in_quotes(table.columns[k].header.full);
    skip({"skipped.gap", {{"column", column}}}, gaps[k]);
    skip({"skipped.impossible", {{"column", column}}}, impossible[k]);
  }
  if (points.size() < fewest_points) {
    throw InputError({table.file, 0, 0},
                     {"too few friction points", fmt::format("{} of {}", points.size(), table.rows),
                      fmt::format("at least {}", fewest_points),
                      "a point at rest, or without a number in each column, is left out"});
  }
  refuse_torque_against_speed(points, table);
  return points;
}

}  // namespace tribolog::ingest::dataset
