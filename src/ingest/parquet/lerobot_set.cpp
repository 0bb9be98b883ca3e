#include "ingest/parquet/lerobot_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/input_file.h"

namespace tribolog::ingest::parquet {
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t largest_info_bytes = std::uint64_t{1} << 24;
constexpr std::size_t most_names = 4096;
constexpr int folders_above = 3;

/// What stands last in the name of a state's element, and what a command of it is called.
struct Quantity {
  std::string_view ending;
  std::string_view command;
};
constexpr std::array quantities = {
    Quantity{".pos", ".position_command"},     Quantity{".position", ".position_command"},
    Quantity{".vel", ".velocity_command"},     Quantity{".velocity", ".velocity_command"},
    Quantity{".torque", ".effort_command"},    Quantity{".effort", ".effort_command"},
    Quantity{".current", ".current_command"},  Quantity{".temperature", ".temperature_command"},
    Quantity{".temp", ".temperature_command"}, Quantity{".acc", ".acceleration_command"},
};

const Quantity* quantity_of(const std::string& element) {
  const auto it = std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& one) {
    return element.size() > one.ending.size() && element.ends_with(one.ending);
  });
  return it == quantities.end() ? nullptr : &*it;
}

/// "elbow" of "elbow.pos".
std::string joint_of(const std::string& element) {
  const Quantity* const quantity = quantity_of(element);
  return quantity == nullptr ? element
                             : element.substr(0, element.size() - quantity->ending.size());
}

std::vector<std::string> texts_in(const Json& list) {
  std::vector<std::string> texts;
  for (const Json& one : list) {
    if (!one.is_string() || texts.size() >= most_names) return {};
    texts.push_back(one.get<std::string>());
  }
  return texts;
}

/// {"x": 0, "y": 1}, as older sets have it.
std::vector<std::string> texts_by_place(const Json& places) {
  std::vector<std::string> texts(std::min(places.size(), most_names));
  for (const auto& [name, place] : places.items()) {
    if (!place.is_number_unsigned() || place.get<std::uint64_t>() >= texts.size()) return {};
    texts[place.get<std::size_t>()] = name;
  }
  return texts;
}

/// A list; {"motors": [...]} or another key; or names with their places.
std::vector<std::string> names_in(const Json& names) {
  if (names.is_array()) return texts_in(names);
  if (!names.is_object() || names.empty()) return {};
  const Json& first = names.begin().value();
  if (names.size() == 1 && first.is_array()) return texts_in(first);
  return texts_by_place(names);
}

LeRobotSet parse_info(const std::string& path) {
  const Json info = Json::parse(read_file(path, largest_info_bytes), nullptr, false);
  if (!info.is_object() || !info.contains("features") || !info["features"].is_object()) {
    throw InputError({path, 0, 0}, {"is not what describes a data set of LeRobot", "",
                                    "a JSON object with \"features\"",
                                    "download the data set again, or move the log elsewhere"});
  }
  LeRobotSet set;
  if (info.contains("fps") && info["fps"].is_number()) set.rate_Hz = info["fps"].get<double>();
  for (const auto& [feature, description] : info["features"].items()) {
    if (!description.is_object() || !description.contains("names")) continue;
    set.elements[feature] = names_in(description["names"]);
  }
  return set;
}

constexpr std::array efforts = {"effort", "torque", "current"};

}  // namespace

bool is_of_lerobot(const std::vector<std::string>& columns) {
  const auto has = [&](const char* name) {
    return std::find(columns.begin(), columns.end(), name) != columns.end();
  };
  return has("episode_index") && has("frame_index");
}

std::optional<LeRobotSet> lerobot_set_around(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path folder = fs::absolute(path, error).lexically_normal().parent_path();
  for (int above = 0; above < folders_above; ++above, folder = folder.parent_path()) {
    const fs::path info = folder / "meta" / "info.json";
    if (fs::is_regular_file(info, error)) return parse_info(info.string());
  }
  return std::nullopt;
}

std::string lerobot_column(const std::optional<LeRobotSet>& set, const std::string& feature,
                           std::size_t element, std::size_t elements) {
  const std::string unnamed = fmt::format("{}_{}", feature, element);
  if (!set) return unnamed;
  const auto named = set->elements.find(feature);
  if (named == set->elements.end() || named->second.size() != elements) return unnamed;
  const std::string& name = named->second[element];
  const Quantity* const quantity = quantity_of(name);
  if (feature == "observation.state") return quantity != nullptr ? name : name + ".position";
  if (feature == "action") {
    return joint_of(name) +
           std::string(quantity != nullptr ? quantity->command : ".position_command");
  }
  for (const std::string_view observed : {"velocity", "effort", "torque", "current"}) {
    if (feature == "observation." + std::string(observed)) {
      return joint_of(name) + "." + std::string(observed);
    }
  }
  return feature + "." + name;
}

namespace {

const log::LogColumn* column_called(const log::LogTable& table, const char* name) {
  const auto it =
      std::find_if(table.columns.begin(), table.columns.end(),
                   [&](const log::LogColumn& column) { return column.header.full == name; });
  return it == table.columns.end() ? nullptr : &*it;
}

bool is_effort(const log::LogColumn& column) {
  return std::any_of(efforts.begin(), efforts.end(), [&](const std::string effort) {
    return column.header.full.ends_with("." + effort) ||
           column.header.full.starts_with("observation." + effort);
  });
}

}  // namespace

void complete_lerobot_table(const std::optional<LeRobotSet>& set, log::LogTable& table) {
  const log::LogColumn* const frames = column_called(table, "frame_index");
  const bool has_rate = set && std::isfinite(set->rate_Hz) && set->rate_Hz > 0;
  if (frames != nullptr && has_rate && column_called(table, "timestamp") == nullptr) {
    log::LogColumn clock = *frames;
    clock.header = {"timestamp", "timestamp", ""};
    for (double& value : clock.values) value /= set->rate_Hz;
    table.header.insert(table.header.begin(), "timestamp");
    table.columns.insert(table.columns.begin(), std::move(clock));
    table.notes.push_back({"reading.lerobot_clock", {{"rate_Hz", set->rate_Hz}}});
  }
  if (std::none_of(table.columns.begin(), table.columns.end(), is_effort)) {
    table.notes.push_back({"reading.lerobot_without_effort"});
  }
}

}  // namespace tribolog::ingest::parquet
