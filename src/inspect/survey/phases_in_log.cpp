#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/requirements.h"
#include "ingest/layout/log_layout.h"
#include "inspect/survey/survey_parts.h"

namespace tribolog::inspect::survey {
namespace {

constexpr std::array names_of_phases = {"phase",  "segment",   "section", "stage",
                                        "state",  "step",      "test",    "experiment",
                                        "motion", "abschnitt", "etap",    "faza"};
/// Parts of one motion, which belongs together; one alone may be said of anything: "warm up".
constexpr std::array parts_of_motion = {
    "forward",      "backward", "forwards", "backwards", "up",    "down",  "pos",   "neg",
    "positive",     "negative", "cw",       "ccw",       "plus",  "minus", "accel", "decel",
    "acceleration", "braking",  "hin",      "left",      "right", "const", "there", "back"};

template <typename List>
bool has_word_of(const List& list, const std::string& text) {
  const std::vector<std::string> words = ingest::layout::words_of_name(text);
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
  });
}

const ingest::log::LogColumn* column_of_phases(const ingest::log::LogTable& data) {
  for (const ingest::log::LogColumn& column : data.columns) {
    const auto directions =
        std::count_if(column.words.begin(), column.words.end(),
                      [](const std::string& word) { return has_word_of(parts_of_motion, word); });
    const bool may_be = column.words.size() > 1 && directions < 2 &&
                        has_word_of(names_of_phases, column.header.name);
    if (may_be) return &column;
  }
  return nullptr;
}

}  // namespace

std::vector<Phase> phases_in(const ingest::log::LogTable& data, const TableSurvey& table) {
  constexpr std::size_t most_phases = 100;
  constexpr double shortest_s = 2;  // on average
  const ingest::log::LogColumn* const column = table.clock ? column_of_phases(data) : nullptr;
  if (column == nullptr) return {};
  const std::vector<double>& t = data.columns[present(table.time)].values;
  std::vector<Phase> phases;
  double known = -1;  // no word's place
  for (std::size_t row = 0; row < t.size(); ++row) {
    const double word = column->values[row];
    if (std::isnan(t[row])) continue;
    const double time_s = t[row] * table.clock->seconds_per_unit;
    const bool is_same = word == known || (std::isnan(word) && std::isnan(known));
    if (!is_same || phases.empty()) {
      phases.push_back(
          {std::isnan(word) ? "" : column->words[static_cast<std::size_t>(word)], time_s, time_s});
    }
    known = word;
    phases.back().to_s = time_s;
    if (phases.size() > most_phases) return {};
  }
  // States that come again and again are no experiments.
  constexpr std::size_t most_returns = 2;
  if (phases.size() > most_returns * column->words.size()) return {};
  const double all_s = phases.empty() ? 0 : phases.back().to_s - phases.front().from_s;
  const bool are_short = all_s < shortest_s * static_cast<double>(phases.size());
  return are_short ? std::vector<Phase>() : phases;
}

}  // namespace tribolog::inspect::survey
