#include "inspect/survey/stated_columns.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "base/closest_match.h"
#include "base/error.h"
#include "ingest/log/units.h"

namespace tribolog::inspect::survey {

namespace {

using ingest::layout::ColumnMeaning;
using ingest::log::Quantity;

struct Key {
  const char* word;
  Quantity quantity;
  const char* unit;  ///< Where the header states none.
};

constexpr std::array keys{Key{"time", Quantity::time, "s"}, Key{"angle", Quantity::angle, "rad"},
                          Key{"speed", Quantity::angular_speed, "rad/s"},
                          Key{"effort", Quantity::torque, "Nm"},
                          Key{"temperature", Quantity::temperature, "degC"}};

const Key& key_of(const std::string& word) {
  return *std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.word == word; });
}

std::optional<std::size_t> column_named(const std::string& name,
                                        const std::vector<ingest::log::ColumnHeader>& header) {
  for (std::size_t k = 0; k < header.size(); ++k) {
    if (header[k].full == name || header[k].name == name) return k;
  }
  std::size_t place = 0;
  if (name.size() < 2 || name.front() != '#') return std::nullopt;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), place);
  const bool is_place = error == std::errc{} && end == name.data() + name.size() && place >= 1;
  if (!is_place) return std::nullopt;
  // Columns of text are none of these, and count in the file.
  for (std::size_t k = 0; k < header.size(); ++k) {
    if (header[k].place == place) return k;
  }
  const bool are_placed = !header.empty() && header.front().place > 0;
  return !are_placed && place <= header.size() ? std::optional(place - 1) : std::nullopt;
}

bool is_effort(Quantity quantity) {
  return quantity == Quantity::torque || quantity == Quantity::current;
}

/// As the log has it; of an effort in ampere, a current.
ColumnMeaning meaning_of(std::size_t column, const Key& key,
                         const ingest::log::ColumnHeader& header,
                         const ingest::layout::LogLayout& layout) {
  ColumnMeaning meaning;
  for (const ColumnMeaning& known : layout.columns) {
    if (known.column == column) meaning.joint = known.joint;
  }
  meaning.column = column;
  meaning.quantity = key.quantity;
  // "motor_current_mA" says its unit in its name.
  std::string unit = header.unit;
  for (const ColumnMeaning& by_name : ingest::layout::guess_layout({header}).columns) {
    if (unit.empty() && by_name.unit_is_stated) unit = by_name.unit;
  }
  if (is_effort(key.quantity) && ingest::log::find_si_factor(Quantity::current, unit)) {
    meaning.quantity = Quantity::current;
  }
  meaning.unit_is_stated = ingest::log::find_si_factor(meaning.quantity, unit).has_value();
  meaning.unit = meaning.unit_is_stated ? unit : key.unit;
  ingest::layout::doubt_ambiguous_unit(meaning);
  return meaning;
}

void put(ColumnMeaning meaning, ingest::layout::LogLayout& layout) {
  std::erase_if(layout.columns, [&](const ColumnMeaning& known) {
    const bool is_same = known.quantity == meaning.quantity ||
                         (is_effort(known.quantity) && is_effort(meaning.quantity));
    const bool is_other = is_same && !known.is_target &&
                          (meaning.quantity == Quantity::angle || known.joint == meaning.joint);
    return known.column == meaning.column || is_other;
  });
  std::erase_if(layout.foreign, [&](const ingest::layout::ForeignUnit& foreign) {
    return foreign.column == meaning.column;
  });
  layout.columns.push_back(std::move(meaning));
}

}  // namespace

bool states(const StatedColumns& stated, const std::string& key) {
  return std::any_of(stated.names.begin(), stated.names.end(),
                     [&](const auto& one) { return one.first == key; });
}

std::pair<std::string, std::string> parse_stated_column(const std::string& text) {
  const std::size_t sign = text.find('=');
  const std::string word = text.substr(0, sign);
  const bool is_known =
      std::any_of(keys.begin(), keys.end(), [&](const Key& key) { return key.word == word; });
  if (sign == std::string::npos || sign + 1 == text.size() || !is_known) {
    throw UsageError("--column '" + printable(text) +
                     "': KEY=NAME with KEY one of time, angle, speed, effort, temperature");
  }
  return {word, text.substr(sign + 1)};
}

std::string parse_unit(const std::string& option, const std::string& text,
                       const std::vector<Quantity>& quantities) {
  std::string known;
  std::vector<std::string> names;
  for (const Quantity quantity : quantities) {
    if (ingest::log::find_si_factor(quantity, text)) return text;
    known += ingest::log::known_units(quantity) + ", ";
    for (std::string& name : ingest::log::listed_units(quantity)) names.push_back(std::move(name));
  }
  const std::string meant = did_you_mean(text, names);
  throw UsageError(option + " '" + printable(text) + "': one of " + known +
                   "or a multiple such as '" +
                   std::string(ingest::log::example_of_multiple(quantities.front())) + "'" +
                   (meant.empty() ? "" : "; " + meant));
}

namespace {

/// Of all columns of a quantity that are measured, also of those that were not known for their unit
/// alone.
template <class IsOne>
void put_unit(const std::string& unit, const IsOne& is_one, ingest::layout::LogLayout& layout) {
  for (const ingest::layout::ForeignUnit& foreign : layout.foreign) {
    if (!is_one(foreign.quantity)) continue;
    ColumnMeaning meaning;
    meaning.column = foreign.column;
    meaning.quantity = foreign.quantity;
    meaning.joint = foreign.joint;
    layout.columns.push_back(std::move(meaning));
  }
  std::erase_if(layout.foreign, [&](const ingest::layout::ForeignUnit& foreign) {
    return is_one(foreign.quantity);
  });
  for (ColumnMeaning& meaning : layout.columns) {
    if (!is_one(meaning.quantity) || (is_effort(meaning.quantity) && meaning.is_target)) continue;
    meaning.unit = unit;
    meaning.unit_is_stated = true;
    meaning.unit_is_ambiguous = false;
  }
}

void put_effort_unit(const std::string& unit, ingest::layout::LogLayout& layout) {
  put_unit(unit, is_effort, layout);
  const bool is_current = ingest::log::find_si_factor(Quantity::current, unit).has_value();
  for (ColumnMeaning& meaning : layout.columns) {
    if (!is_effort(meaning.quantity) || meaning.is_target) continue;
    meaning.quantity = is_current ? Quantity::current : Quantity::torque;
  }
}

/// The only joint whose name is a number in the column's name: "2" of "A2".
std::optional<std::string> joint_by_number(const std::string& name,
                                           const ingest::layout::LogLayout& layout) {
  std::optional<std::string> found;
  const std::vector<std::string> words = ingest::layout::words_of_name(name);
  for (const ColumnMeaning& meaning : layout.columns) {
    const bool is_its = std::find(words.begin(), words.end(), meaning.joint) != words.end();
    if (!is_its || found == meaning.joint) continue;
    if (found) return std::nullopt;
    found = meaning.joint;
  }
  return found;
}

}  // namespace

std::vector<std::string> put_stated(const StatedColumns& stated,
                                    const std::vector<ingest::log::ColumnHeader>& header,
                                    ingest::layout::LogLayout& layout) {
  std::vector<std::string> missing;
  std::vector<ColumnMeaning> meanings;
  std::optional<std::string> joint;
  for (const auto& [word, name] : stated.names) {
    const auto column = column_named(name, header);
    if (!column) {
      missing.push_back(name);
      continue;
    }
    meanings.push_back(meaning_of(*column, key_of(word), header[*column], layout));
    if (meanings.back().joint.empty()) {
      meanings.back().joint = joint_by_number(header[*column].name, layout).value_or("");
    }
    if (meanings.back().quantity == Quantity::angle) joint = meanings.back().joint;
  }
  // Of the only joint, whatever else its name holds.
  const std::vector<std::string> joints = layout.joints();
  if (!joint && joints.size() == 1) joint = joints.front();
  for (ColumnMeaning& meaning : meanings) {
    if (joint && meaning.quantity != Quantity::time) meaning.joint = *joint;
    meaning.is_of_any_joint = meaning.joint.empty() && joints.size() > 1;
    put(std::move(meaning), layout);
  }
  if (stated.rate_Hz) {  // the clock is made, as the last column
    ColumnMeaning clock;
    clock.column = header.size() - 1;
    clock.quantity = Quantity::time;
    clock.unit = "s";
    clock.unit_is_stated = true;
    std::erase_if(layout.columns,
                  [](const ColumnMeaning& known) { return known.quantity == Quantity::time; });
    layout.columns.push_back(std::move(clock));
  }
  if (stated.effort_unit) put_effort_unit(*stated.effort_unit, layout);
  const auto put_unit_of = [&](const std::optional<std::string>& unit, Quantity quantity) {
    if (unit) put_unit(*unit, [&](Quantity one) { return one == quantity; }, layout);
  };
  if (!stated.rate_Hz) put_unit_of(stated.time_unit, Quantity::time);
  put_unit_of(stated.angle_unit, Quantity::angle);
  put_unit_of(stated.speed_unit, Quantity::angular_speed);
  return missing;
}

}  // namespace tribolog::inspect::survey
