#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "ingest/dataset/recording_rows.h"

namespace tribolog::ingest::dataset {
namespace {

constexpr std::size_t fewest_points = 3;
constexpr std::size_t most_points = 2000;

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

/// Means of as many neighbours in speed, of those of one speed as they follow each other in the
/// table; no mean is over both directions.
joint::FrictionPoints averaged(const joint::FrictionPoints& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points.speed_rad_s[a] < points.speed_rad_s[b];
  });
  const auto first_forward = std::partition_point(
      order.begin(), order.end(), [&](std::size_t i) { return points.speed_rad_s[i] < 0; });
  joint::FrictionPoints means;
  means.name = points.name;
  const auto add_means = [&](std::span<const std::size_t> of_direction) {
    const std::size_t wanted = 1 + of_direction.size() * (most_points - 2) / points.size();
    for (std::size_t k = 0; k < wanted; ++k) {
      const std::size_t from = of_direction.size() * k / wanted;
      const std::size_t to = of_direction.size() * (k + 1) / wanted;
      const auto mean = [&](const std::vector<double>& of, std::vector<double>& to_add) {
        if (of.empty()) return;
        double sum = 0;
        for (const std::size_t i : of_direction.subspan(from, to - from)) sum += of[i];
        to_add.push_back(sum / static_cast<double>(to - from));
      };
      mean(points.speed_rad_s, means.speed_rad_s);
      mean(points.torque_Nm, means.torque_Nm);
      mean(points.temperature_C, means.temperature_C);
      mean(points.load_Nm, means.load_Nm);
    }
  };
  if (first_forward != order.begin()) add_means({order.begin(), first_forward});
  if (first_forward != order.end()) add_means({first_forward, order.end()});
  return means;
}

}  // namespace

joint::FrictionPoints make_friction_points(const manifest::RecordingEntry& entry,
                                           const log::LogTable& table, const joint::Drive& drive,
                                           double effort_sign,
                                           std::vector<Statement>& notes_of_all) {
  RecordingNotes notes(entry.name, notes_of_all);
  note_reading(table, notes);
  const std::vector<LoggedColumn> columns = logged_columns(entry.columns);
  joint::FrictionPoints points;
  points.name = entry.name;
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
  if (points.size() <= most_points) return points;
  joint::FrictionPoints means = averaged(points);
  notes.add({"reading.points_averaged", {{"points", points.size()}, {"means", means.size()}}});
  means.rows_read = points.rows_read;
  means.skipped = std::move(points.skipped);
  return means;
}

}  // namespace tribolog::ingest::dataset
