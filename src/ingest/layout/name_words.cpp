#include <algorithm>
#include <array>
#include <cstddef>

#include "ingest/layout/log_layout.h"

namespace tribolog::ingest::layout {

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

std::optional<std::string> joint_in_name(std::string_view name, std::string_view pattern) {
  constexpr std::string_view place = "{}";
  const std::size_t at = pattern.find(place);
  if (at == std::string_view::npos) {
    return same(name, pattern) ? std::optional<std::string>("") : std::nullopt;
  }
  const std::string_view before = pattern.substr(0, at);
  const std::string_view behind = pattern.substr(at + place.size());
  if (name.size() <= before.size() + behind.size()) return std::nullopt;
  const std::size_t length = name.size() - before.size() - behind.size();
  if (!same(name.substr(0, before.size()), before)) return std::nullopt;
  if (!same(name.substr(name.size() - behind.size()), behind)) return std::nullopt;
  return std::string(name.substr(before.size(), length));
}

namespace {

using enum log::Quantity;

constexpr std::array quantity_words = {QuantityWord{"time", time},
                                       QuantityWord{"timestamp", time},
                                       QuantityWord{"stamp", time},
                                       QuantityWord{"t", time},
                                       QuantityWord{"zeit", time},
                                       QuantityWord{"czas", time},
                                       QuantityWord{"temps", time},
                                       QuantityWord{"elapsed", time},
                                       QuantityWord{"qd", angular_speed},
                                       QuantityWord{"dq", angular_speed},
                                       QuantityWord{"vel", angular_speed},
                                       QuantityWord{"velocity", angular_speed},
                                       QuantityWord{"velocities", angular_speed},
                                       QuantityWord{"speed", angular_speed},
                                       QuantityWord{"velo", angular_speed},
                                       QuantityWord{"rpm", angular_speed},
                                       QuantityWord{"omega", angular_speed},
                                       QuantityWord{"dtheta", angular_speed},
                                       QuantityWord{"qdot", angular_speed},
                                       QuantityWord{"geschwindigkeit", angular_speed},
                                       QuantityWord{"drehzahl", angular_speed},
                                       QuantityWord{"prędkość", angular_speed},
                                       QuantityWord{"predkosc", angular_speed},
                                       QuantityWord{"vitesse", angular_speed},
                                       QuantityWord{"q", angle},
                                       QuantityWord{"angle", angle},
                                       QuantityWord{"pos", angle},
                                       QuantityWord{"position", angle},
                                       QuantityWord{"positions", angle},
                                       QuantityWord{"theta", angle},
                                       QuantityWord{"phi", angle},
                                       QuantityWord{"winkel", angle},
                                       QuantityWord{"kąt", angle},
                                       QuantityWord{"kat", angle},
                                       QuantityWord{"tau", torque},
                                       QuantityWord{"torque", torque},
                                       QuantityWord{"torques", torque},
                                       QuantityWord{"effort", torque},
                                       QuantityWord{"moment", torque},
                                       QuantityWord{"trq", torque},
                                       QuantityWord{"torq", torque},
                                       QuantityWord{"jts", torque},
                                       QuantityWord{"drehmoment", torque},
                                       QuantityWord{"couple", torque},
                                       QuantityWord{"i", current},
                                       QuantityWord{"iq", current},
                                       QuantityWord{"current", current},
                                       QuantityWord{"cur", current},
                                       QuantityWord{"curr", current},
                                       QuantityWord{"amps", current},
                                       QuantityWord{"ampere", current},
                                       QuantityWord{"strom", current},
                                       QuantityWord{"prąd", current},
                                       QuantityWord{"prad", current},
                                       QuantityWord{"courant", current},
                                       QuantityWord{"temp", temperature},
                                       QuantityWord{"temperature", temperature}};

constexpr std::array target_words = {"target", "goal", "cmd", "command", "commanded", "des",
                                     "desired", "ref", "reference", "setpoint", "set", "d", "plan",
                                     "planned", "demand", "demanded", "req", "requested", "request",
                                     "nominal", "nom", "sim", "simulated", "model", "soll",
                                     "sollwert", "zadany", "zadana", "zadane", "zad", "consigne",
                                     // No measurement of the drive.
                                     "external", "ext"};
// Of no joint, and of no signal that is looked for.
constexpr std::array other_words = {
    "error",        "err",    "enable", "enabled", "flag",    "status", "state",   "mode",
    "limit",        "max",    "min",    "id",      "index",   "count",  "counter", "gain",
    "kp",           "kd",     "ki",     "offset",  "diff",    "delta",  "dt",      "acc",
    "acceleration", "ddq",    "qdd",    "x",       "y",       "z",      "std",     "var",
    "rate",         "period", "bus",    "cov",     "residual"};
// Said of any joint.
constexpr std::array empty_words = {
    "actual", "act",         "measured",    "meas",        "mes",      "motor",     "joint",
    "axis",   "j",           "m",           "raw",         "est",      "estimated", "filtered",
    "filt",   "encoder",     "enc",         "drive",       "actuator", "robot",     "data",
    "value",  "ist",         "angular",     "present",     "feedback", "fb",        "link",
    "sensor", "rzeczywisty", "rzeczywista", "rzeczywiste", "silnika",  "przegubu",  "istwert"};

template <typename List>
bool holds(const List& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_small(char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80; }

constexpr std::array quantities = {time, angle, angular_speed, torque, current, temperature};

std::optional<log::Quantity> quantity_of_unit(std::string_view unit) {
  for (const log::Quantity quantity : quantities) {
    if (log::find_si_factor(quantity, unit)) return quantity;
  }
  return std::nullopt;
}

std::optional<log::Quantity> quantity_of_word(const std::string& word) {
  const auto it = std::find_if(quantity_words.begin(), quantity_words.end(),
                               [&](const QuantityWord& w) { return w.word == word; });
  if (it == quantity_words.end()) return std::nullopt;
  return it->quantity;
}

/// "sollstrom" is "soll" and "strom"; "current" beside a position, a speed or a torque is what is
/// now, and no electric one.
std::vector<std::string> words_that_tell(std::string_view name) {
  std::vector<std::string> words;
  bool has_other = false;
  for (const std::string& word : words_of_name(name)) {
    bool is_cut = false;
    for (const std::string_view first : {"soll", "ist"}) {
      const bool begins = word.size() > first.size() && word.starts_with(first);
      const std::string rest = begins ? word.substr(first.size()) : "";
      if (!begins || !quantity_of_word(rest)) continue;
      words.emplace_back(first);
      words.push_back(rest);
      is_cut = true;
    }
    if (!is_cut) words.push_back(word);
    const auto quantity = quantity_of_word(words.back());
    has_other = has_other || quantity == angle || quantity == angular_speed || quantity == torque;
  }
  if (!has_other) return words;
  std::erase_if(words, [](const std::string& word) {
    return word == "current" || word == "cur" || word == "curr";
  });
  return words;
}

/// Names of what no unit of the list is: shares of a rated value, counts.
constexpr std::array foreign_words = {"percent",    "pct", "permille", "promille",
                                      "prozent",    "inc", "incs",     "increments",
                                      "inkremente", "lsb", "ticks"};

}  // namespace

bool says_foreign_unit(std::string_view name) {
  const std::vector<std::string> words = words_of_name(name);
  return std::any_of(words.begin(), words.end(),
                     [](const std::string& word) { return holds(foreign_words, word); });
}

bool says_other_signal(std::string_view name) {
  const std::vector<std::string> words = words_of_name(name);
  return std::any_of(words.begin(), words.end(),
                     [](const std::string& word) { return holds(other_words, word); });
}

std::vector<std::string> words_of_name(std::string_view name) {
  std::vector<std::string> words;
  char before = ' ';
  for (const char c : name) {
    const bool is_letter = is_capital(c) || is_small(c);
    const bool was_letter = is_capital(before) || is_small(before);
    if (!is_letter && !is_digit(c)) {
      before = ' ';
      continue;
    }
    const bool goes_on = (is_digit(c) && is_digit(before)) ||
                         (is_letter && was_letter && !(is_capital(c) && is_small(before)));
    if (!goes_on) words.emplace_back();
    words.back() += is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c;
    before = c;
  }
  return words;
}

std::optional<ColumnMeaning> meaning_by_words(std::string_view name, std::string_view unit) {
  const std::optional<log::Quantity> of_unit = quantity_of_unit(unit);
  ColumnMeaning meaning;
  bool is_told = false;
  std::string number;
  std::string others;
  for (const std::string& word : words_that_tell(name)) {
    if (holds(other_words, word)) return std::nullopt;
    const auto quantity = quantity_of_word(word);
    if (quantity && (!of_unit || quantity == of_unit) && !is_told) {
      meaning.quantity = *quantity;
      is_told = true;
    } else if (holds(target_words, word)) {
      meaning.is_target = true;
    } else if (is_digit(word.front())) {
      number = word;
    } else if (!quantity && !holds(empty_words, word) && !holds(foreign_words, word)) {
      others += (others.empty() ? "" : "_") + word;
    }
  }
  if (!is_told && !of_unit) return std::nullopt;
  if (!is_told) meaning.quantity = *of_unit;
  if (meaning.quantity == time) number.clear();
  // Words that name no quantity beside a unit that does may be any language's: "Strom", "Moment".
  const bool names_joint = is_told && meaning.quantity != time;
  meaning.joint = !number.empty() ? number : names_joint ? others : "";
  meaning.unit = unit;
  meaning.unit_is_stated = of_unit.has_value();
  return meaning;
}

}  // namespace tribolog::ingest::layout
