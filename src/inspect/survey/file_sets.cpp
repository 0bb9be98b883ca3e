// Recordings in several files, one for each quantity: the names of such files differ in the word
// that names it, and their rows are of the same moments.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ingest/layout/log_layout.h"
#include "ingest/log/row_clock.h"
#include "inspect/survey/column_guess.h"
#include "inspect/survey/survey_parts.h"

namespace tribolog::inspect::survey {
namespace {

using ingest::log::Quantity;

/// A path with one word open, and what stands there.
using OpenName = std::vector<std::string>;

std::optional<Quantity> quantity_of_file(const std::string& word) {
  constexpr std::array angles = {"ang", "angles", "pos", "position", "positions"};
  constexpr std::array motors = {"motor", "drive"};  // beside an angle: what drives it
  const auto is_in = [&](const auto& list) {
    return std::find(list.begin(), list.end(), word) != list.end();
  };
  if (is_in(angles)) return Quantity::angle;
  if (is_in(motors)) return Quantity::torque;
  const auto meaning = ingest::layout::meaning_by_words(word, "");
  if (!meaning || meaning->is_target) return std::nullopt;
  const bool is_of_motion = meaning->quantity != Quantity::time &&  //
                            meaning->quantity != Quantity::temperature;
  return is_of_motion ? std::optional(meaning->quantity) : std::nullopt;
}

/// "#1", "#2": whatever the file calls itself, its columns have no names.
bool has_no_names(const ingest::log::LogTable& table) {
  return std::all_of(table.columns.begin(), table.columns.end(),
                     [](const ingest::log::LogColumn& column) {
                       return column.header.full == "#" + std::to_string(column.header.place) &&
                              column.reading == ingest::log::ColumnReading::number;
                     });
}

/// Whether a file holds an angle and its speed by itself, and is no part of a set.
bool is_whole(const ingest::log::LogTable& table) {
  const GuessedLayout layout = guess_by_numbers(table, {});
  return std::any_of(
      layout.meanings.begin(), layout.meanings.end(),
      [](const GuessedMeaning& guess) { return guess.meaning.quantity == Quantity::angle; });
}

bool is_same_clock(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double largest_difference = 0.5;  // of a step: beyond, another row is nearer
  const double allowed = largest_difference * ingest::log::median_clock_step(a);
  if (!(allowed > 0)) return false;
  for (std::size_t row = 0; row < a.size(); ++row) {
    if (!(std::abs(a[row] - b[row]) <= allowed)) return false;
  }
  return true;
}

}  // namespace

std::vector<FileSet> sets_of_files(const std::vector<std::string>& paths) {
  struct NamedFile {
    std::size_t file{};
    Quantity quantity{};
  };
  // By what they are: an effort is one of either kind.
  std::map<OpenName, std::map<Quantity, std::vector<NamedFile>>> alike;
  for (std::size_t file = 0; file < paths.size(); ++file) {
    const OpenName words = ingest::layout::words_of_name(paths[file]);
    for (std::size_t k = 0; k < words.size(); ++k) {
      const auto quantity = quantity_of_file(words[k]);
      if (!quantity) continue;
      OpenName open = words;
      open[k].clear();
      alike[open][*quantity == Quantity::current ? Quantity::torque : *quantity].push_back(
          {file, *quantity});
    }
  }
  std::vector<FileSet> of_angle(paths.size());
  std::set<std::size_t> taken;
  for (const auto& [name, files] : alike) {
    const bool is_set = std::all_of(files.begin(), files.end(), [&](const auto& one) {
      return one.second.size() == 1 && !taken.contains(one.second.front().file);
    });
    const auto angle = files.find(Quantity::angle);
    if (!is_set || files.size() < 2 || angle == files.end()) continue;
    FileSet& set = of_angle[angle->second.front().file];
    for (const auto& [quantity, of_quantity] : files) {
      const NamedFile& one = of_quantity.front();
      taken.insert(one.file);
      if (quantity != Quantity::angle) set.beside.push_back({paths[one.file], one.quantity});
    }
  }
  std::vector<FileSet> sets;
  for (std::size_t file = 0; file < paths.size(); ++file) {
    const bool is_beside = taken.contains(file) && of_angle[file].beside.empty();
    if (!is_beside) sets.push_back({paths[file], of_angle[file].beside});
  }
  return sets;
}

std::optional<JoinedFiles> join_files(const FileSet& set, ingest::log::LogTable angles,
                                      std::vector<ingest::log::LogTable> beside,
                                      const StatedColumns& stated) {
  const std::size_t first = stated.rate_Hz ? 0 : 1;  // behind the clock
  const std::size_t columns = angles.columns.size();
  if (columns <= first || !has_no_names(angles) || is_whole(angles)) return std::nullopt;
  for (const ingest::log::LogTable& table : beside) {
    const bool is_alike = table.rows == angles.rows && table.columns.size() == columns &&
                          has_no_names(table) && !is_whole(table);
    if (!is_alike) return std::nullopt;
    const bool is_of_its_time =
        first == 0 || is_same_clock(angles.columns.front().values, table.columns.front().values);
    if (!is_of_its_time) return std::nullopt;
  }
  JoinedFiles joined;
  const auto add_meanings = [&](std::size_t at, Quantity quantity) {
    for (std::size_t k = first; k < columns; ++k) {
      ingest::layout::ColumnMeaning meaning;
      meaning.column = at + k - first;
      meaning.quantity = quantity;
      meaning.unit = quantity == Quantity::angle           ? "rad"
                     : quantity == Quantity::angular_speed ? "rad/s"
                     : quantity == Quantity::current       ? "A"
                                                           : "Nm";
      if (columns > first + 1) meaning.joint = std::to_string(k - first + 1);
      meaning.effort.may_be_current = quantity == Quantity::torque;
      joined.meanings.push_back(std::move(meaning));
    }
  };
  add_meanings(first, Quantity::angle);
  joined.table = std::move(angles);
  joined.files.resize(columns);
  for (std::size_t file = 0; file < beside.size(); ++file) {
    add_meanings(joined.table.columns.size(), set.beside[file].quantity);
    for (std::size_t k = first; k < columns; ++k) {
      ingest::log::LogColumn column = std::move(beside[file].columns[k]);
      const std::string& path = set.beside[file].path;
      joined.files.push_back({path, column.header.full});
      column.header.full += " of " + std::filesystem::path(path).filename().string();
      column.header.name = column.header.full;
      column.header.place = 0;  // of another file
      joined.table.header.push_back(column.header.full);
      joined.table.columns.push_back(std::move(column));
    }
  }
  return joined;
}

}  // namespace tribolog::inspect::survey
