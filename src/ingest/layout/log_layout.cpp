#include "ingest/layout/log_layout.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/enum_text.h"

namespace tribolog::ingest::layout {
namespace {

/// As the start of a column's name.
constexpr std::array words = {QuantityWord{"time", log::Quantity::time},
                              QuantityWord{"timestamp", log::Quantity::time},
                              QuantityWord{"stamp", log::Quantity::time},
                              QuantityWord{"t", log::Quantity::time},
                              QuantityWord{"q", log::Quantity::angle},
                              QuantityWord{"angle", log::Quantity::angle},
                              QuantityWord{"pos", log::Quantity::angle},
                              QuantityWord{"position", log::Quantity::angle},
                              QuantityWord{"theta", log::Quantity::angle},
                              QuantityWord{"dq", log::Quantity::angular_speed},
                              QuantityWord{"qd", log::Quantity::angular_speed},
                              QuantityWord{"vel", log::Quantity::angular_speed},
                              QuantityWord{"velocity", log::Quantity::angular_speed},
                              QuantityWord{"speed", log::Quantity::angular_speed},
                              QuantityWord{"omega", log::Quantity::angular_speed},
                              QuantityWord{"tau", log::Quantity::torque},
                              QuantityWord{"torque", log::Quantity::torque},
                              QuantityWord{"effort", log::Quantity::torque},
                              QuantityWord{"moment", log::Quantity::torque},
                              QuantityWord{"i", log::Quantity::current},
                              QuantityWord{"current", log::Quantity::current},
                              QuantityWord{"curr", log::Quantity::current},
                              QuantityWord{"temp", log::Quantity::temperature},
                              QuantityWord{"temperature", log::Quantity::temperature}};

std::string_view si_unit(log::Quantity quantity) {
  return EnumTexts<log::Quantity>("s", "rad", "rad/s", "Nm", "A", "degC").of(quantity);
}

std::string lower(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

/// A unit at the end of a name, and how many letters of the name it takes with its sign.
struct UnitAtEnd {
  std::string unit;  ///< "rad/s"
  std::size_t letters{};
};

/// Behind the last '_': "deg" of "q_deg"; or the last two, "rad/s" of "dq_rad_s".
/// @param is_unit of what stands there.
template <class IsUnit>
std::optional<UnitAtEnd> unit_behind_name(std::string_view name, const IsUnit& is_unit) {
  const std::size_t last = name.rfind('_');
  if (last == std::string_view::npos || last == 0) return std::nullopt;
  const std::size_t before = name.rfind('_', last - 1);
  if (before != std::string_view::npos && before > 0) {
    const std::string of_two = std::string(name.substr(before + 1, last - before - 1)) + "/" +
                               std::string(name.substr(last + 1));
    if (is_unit(of_two)) return UnitAtEnd{of_two, name.size() - before};
  }
  const std::string of_one(name.substr(last + 1));
  if (!is_unit(of_one)) return std::nullopt;
  return UnitAtEnd{of_one == "C" ? "degC" : of_one, name.size() - last};
}

/// Letters that are units by themselves, and as usual as that at a name's end.
bool is_unit_letter(std::string_view text) { return text == "s" || text == "A" || text == "C"; }

/// "_rad_s" taken off the end of "q_dot_rad_s": the unit, or nothing.
std::optional<std::string> take_unit(std::string& name, log::Quantity quantity) {
  const auto unit = unit_behind_name(name, [&](const std::string& text) {
    const bool may_be =
        text.size() > 1 ? text.front() > '9' || text == "100ns" : is_unit_letter(text);
    return may_be && log::find_si_factor(quantity, text);
  });
  if (!unit) return std::nullopt;
  name.resize(name.size() - unit->letters);
  return unit->unit;
}

bool is_number(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The joint's number behind a word: "q1", "q_1", "q[1]"; empty behind the word alone.
std::optional<std::string> number_behind(std::string_view rest) {
  if (rest.empty()) return "";
  if (rest.front() == '_' || rest.front() == '.') rest.remove_prefix(1);
  if (rest.size() > 2 && rest.front() == '[' && rest.back() == ']') {
    rest = rest.substr(1, rest.size() - 2);
  }
  if (!is_number(rest)) return std::nullopt;
  return std::string(rest);
}

/// "[0]" is no unit, and belongs to the name.
const std::string& name_of(const log::ColumnHeader& header) {
  return log::is_known_unit(header.unit) ? header.name : header.full;
}

/// "qc", "inc", "%": a unit stands there, and none that is known.
bool has_foreign_unit(const log::ColumnHeader& header) {
  return !header.unit.empty() && !log::is_known_unit(header.unit) && !is_number(header.unit);
}

/// Of "/robot/joint_states/elbow/position" what is said last: whose signal it is, and which.
std::string end_of_path(const std::string& name) {
  const std::size_t last = name.rfind('/');
  if (last == std::string::npos || last == 0) return name;
  const std::size_t before = name.rfind('/', last - 1);
  return before == std::string::npos ? name : name.substr(before + 1);
}

/// "_rad" at the end of "q_motor_rad", of whatever quantity; empty: none. "q_min" is the smallest
/// angle.
std::string unit_at_end(std::string& name) {
  const auto unit = unit_behind_name(name, [](const std::string& text) {
    const bool may_be = text.size() > 1 ? text.front() > '9' && text != "min" && text != "tr"
                                        : is_unit_letter(text);
    return may_be && log::is_known_unit(text);
  });
  if (!unit) return "";
  name.resize(name.size() - unit->letters);
  return unit->unit;
}

ColumnMeaning meaning_of(const KnownColumn& known, std::string joint) {
  ColumnMeaning meaning;
  meaning.quantity = known.quantity;
  meaning.joint = std::move(joint);
  meaning.unit = known.unit.empty() ? si_unit(known.quantity) : known.unit;
  meaning.unit_is_stated = !known.unit.empty() && !known.is_usual;
  meaning.unit_is_usual = known.is_usual;
  meaning.is_at_motor = known.side == joint::Side::motor;
  meaning.is_target = known.is_target;
  const bool may_be_current = known.quantity == log::Quantity::torque && !known.kind;
  meaning.effort = {known.kind, known.side, std::string(known.remark), may_be_current,
                    known.is_without_gravity};
  return meaning;
}

/// Of the first of these that has its name.
std::optional<ColumnMeaning> by_name(const log::ColumnHeader& header,
                                     std::span<const KnownColumn> columns) {
  for (const KnownColumn& known : columns) {
    if (const auto joint = joint_in_name(name_of(header), known.pattern)) {
      return meaning_of(known, *joint);
    }
  }
  return std::nullopt;
}

/// A word, a joint's number and a unit; or else words in any order.
std::optional<ColumnMeaning> by_words(const log::ColumnHeader& header) {
  if (auto known = by_name(header, known_names())) return known;
  for (const QuantityWord& w : words) {
    std::string name = end_of_path(name_of(header));
    const auto ending = take_unit(name, w.quantity);
    name = lower(name);
    if (!name.starts_with(w.word)) continue;
    const auto joint = number_behind(std::string_view(name).substr(w.word.size()));
    if (!joint || (w.quantity == log::Quantity::time && !joint->empty())) continue;
    ColumnMeaning meaning;
    meaning.quantity = w.quantity;
    meaning.joint = *joint;
    meaning.unit = ending.value_or(std::string(si_unit(w.quantity)));
    meaning.unit_is_stated = ending.has_value();
    if (log::find_si_factor(w.quantity, header.unit) || !log::is_known_unit(header.unit))
      return meaning;
  }
  std::string name = end_of_path(name_of(header));
  const bool has_unit = log::is_known_unit(header.unit);
  const std::string unit = has_unit ? header.unit : unit_at_end(name);
  auto meaning = meaning_by_words(name, unit);
  if (meaning && unit.empty()) meaning->unit = si_unit(meaning->quantity);
  return meaning;
}

const KnownLogger* logger_of(const std::vector<log::ColumnHeader>& header) {
  for (const KnownLogger& logger : known_loggers()) {
    const bool is_it = std::any_of(header.begin(), header.end(), [&](const log::ColumnHeader& h) {
      return joint_in_name(name_of(h), logger.named_by).has_value();
    });
    if (is_it) return &logger;
  }
  return nullptr;
}

/// "1" of "J1", "Joint 1" and "axis_1".
std::optional<std::string> joint_alone(const log::ColumnHeader& header) {
  const std::vector<std::string> name = words_of_name(header.full);
  const bool is_one = name.size() == 2 && is_number(name[1]) &&
                      (name[0] == "j" || name[0] == "joint" || name[0] == "axis");
  return is_one ? std::optional(name[1]) : std::nullopt;
}

void take_joints_for_angles(const std::vector<log::ColumnHeader>& header, LogLayout& layout) {
  for (std::size_t k = 0; k < header.size(); ++k) {
    const auto joint = joint_alone(header[k]);
    if (!joint) continue;
    ColumnMeaning meaning;
    meaning.column = k;
    meaning.quantity = log::Quantity::angle;
    meaning.joint = *joint;
    meaning.unit = si_unit(meaning.quantity);
    layout.columns.push_back(std::move(meaning));
  }
  std::stable_sort(
      layout.columns.begin(), layout.columns.end(),
      [](const ColumnMeaning& a, const ColumnMeaning& b) { return a.column < b.column; });
}

}  // namespace

const ColumnMeaning* LogLayout::find(log::Quantity quantity, const std::string& joint) const {
  const auto it = std::find_if(columns.begin(), columns.end(), [&](const ColumnMeaning& c) {
    return c.quantity == quantity && c.joint == joint && !c.is_target;
  });
  return it == columns.end() ? nullptr : &*it;
}

std::vector<std::string> LogLayout::joints() const {
  std::vector<std::string> names;
  for (const ColumnMeaning& c : columns) {
    if (c.quantity != log::Quantity::angle || c.is_target) continue;
    if (std::find(names.begin(), names.end(), c.joint) == names.end()) names.push_back(c.joint);
  }
  return names;
}

void doubt_ambiguous_unit(ColumnMeaning& meaning) {
  constexpr std::string_view either = "grad";
  constexpr std::string_view degrees = "deg";
  const bool turns =
      meaning.quantity == log::Quantity::angle || meaning.quantity == log::Quantity::angular_speed;
  const std::string unit = lower(meaning.unit);
  if (!turns || !meaning.unit_is_stated || !unit.starts_with(either)) return;
  meaning.unit = std::string(degrees) + unit.substr(either.size());
  meaning.unit_is_stated = false;
  meaning.unit_is_ambiguous = true;
}

LogLayout guess_layout(const std::vector<log::ColumnHeader>& header) {
  LogLayout layout;
  const KnownLogger* const logger = logger_of(header);
  if (logger != nullptr) layout.logger = logger->name;
  for (std::size_t k = 0; k < header.size(); ++k) {
    auto meaning = logger != nullptr ? by_name(header[k], logger->columns) : by_words(header[k]);
    const bool says_foreign =
        (header[k].unit.empty() && says_foreign_unit(header[k].name)) ||
        (!log::is_known_unit(header[k].unit) && is_share_by_name(header[k].full));
    if (logger == nullptr && (says_foreign || has_foreign_unit(header[k]))) {
      // In that unit it cannot be read: the name without its brackets may still tell what it is.
      meaning = by_words({header[k].name, header[k].name, ""});
      if (meaning) layout.foreign.push_back({k, meaning->quantity, meaning->joint});
      continue;
    }
    if (!meaning) continue;
    meaning->column = k;
    const bool agrees =
        meaning->unit_is_stated && log::find_si_factor(meaning->quantity, meaning->unit) ==
                                       log::find_si_factor(meaning->quantity, header[k].unit);
    if (log::find_si_factor(meaning->quantity, header[k].unit)) {
      meaning->unit = header[k].unit;
      meaning->unit_is_stated = true;
    }
    if (!agrees) doubt_ambiguous_unit(*meaning);
    layout.columns.push_back(std::move(*meaning));
  }
  const bool has_angle =
      std::any_of(layout.columns.begin(), layout.columns.end(),
                  [](const ColumnMeaning& of) { return of.quantity == log::Quantity::angle; });
  if (logger == nullptr && !has_angle) take_joints_for_angles(header, layout);
  return layout;
}

std::vector<std::string> possible_efforts(const std::vector<log::ColumnHeader>& header) {
  constexpr std::array parts = {"load", "torq", "curr", "amp", "effort", "moment"};
  const auto is_effort = [](log::Quantity quantity) {
    return quantity == log::Quantity::torque || quantity == log::Quantity::current;
  };
  const LogLayout layout = guess_layout(header);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < header.size(); ++k) {
    const auto of_column = [&](const auto& one) { return one.column == k; };
    const auto known = std::find_if(layout.columns.begin(), layout.columns.end(), of_column);
    const auto foreign = std::find_if(layout.foreign.begin(), layout.foreign.end(), of_column);
    const bool is_known = known != layout.columns.end() || foreign != layout.foreign.end();
    const std::vector<std::string> words = words_of_name(header[k].full);
    const bool is_called_so = std::any_of(words.begin(), words.end(), [&](const auto& word) {
      return std::any_of(parts.begin(), parts.end(),
                         [&](const char* part) { return word.starts_with(part); });
    });
    const bool may_be = (known != layout.columns.end() && is_effort(known->quantity)) ||
                        (foreign != layout.foreign.end() && is_effort(foreign->quantity)) ||
                        (!is_known && is_called_so && !says_other_signal(header[k].full));
    if (may_be) names.push_back(header[k].full);
  }
  return names;
}

}  // namespace tribolog::ingest::layout
