#include "ingest/manifest/parameter_table.h"

#include <algorithm>
#include <type_traits>

namespace tribolog {
namespace {

std::vector<MaxwellElement> read_elements(const TomlTable& table, const std::string& key,
                                          const std::string& hint) {
  std::vector<MaxwellElement> elements;
  for (const TomlTable& one : table.tables(key)) {
    elements.push_back({one.number("stiffness_Nm_rad"), one.number("share")});
    one.refuse_unknown_keys();
  }
  if (elements.empty()) {
    table.refuse(key, {table.has(key) ? " is empty" : " is missing", "",
                       "one or more {stiffness_Nm_rad = ..., share = ...}", hint});
  }
  return elements;
}

void read_value(const TomlTable& table, const std::string& key, const std::string& hint,
                ParameterValue& value) {
  std::visit(
      [&](auto& known) {
        using Value = std::decay_t<decltype(known)>;
        if constexpr (std::is_same_v<Value, double>) {
          known = table.number(key, Sign::any, hint);
        } else if constexpr (std::is_same_v<Value, std::uint64_t>) {
          known = table.count_or(key, known);
        } else {
          known = read_elements(table, key, hint);
        }
      },
      value);
}

/// Far below what any rule notices, and far above the last digit that a refusal quotes.
constexpr double trace = 1e-12;

double shifted(double value, double direction) {
  return value == 0.0 ? direction * trace : value * (1 + direction * trace);
}

ParameterValue shifted(const ParameterValue& value, double direction) {
  ParameterValue out = value;
  if (auto* number = std::get_if<double>(&out)) {
    *number = shifted(*number, direction);
  } else if (auto* count = std::get_if<std::uint64_t>(&out)) {
    *count = direction > 0 || *count == 0 ? *count + 1 : *count - 1;
  } else if (auto* elements = std::get_if<std::vector<MaxwellElement>>(&out)) {
    for (MaxwellElement& one : *elements) {
      one = {shifted(one.stiffness_Nm_rad, direction), shifted(one.share, direction)};
    }
  }
  return out;
}

std::size_t common_start(const std::string& a, const std::string& b) {
  const auto apart = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(apart.first - a.begin());
}

}  // namespace

NamedParameters read_parameters(const TomlTable& table, const NamedParameters& otherwise,
                                bool needed, const std::string& hint) {
  NamedParameters values = otherwise;
  std::vector<bool> is_read;  // asks for every key first: no other one is then a misspelling
  for (const NamedParameter& one : values) {
    is_read.push_back(table.has(one.key) || (needed && !one.has_usual));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    NamedParameter& one = values[i];
    const std::string help = hint.empty() ? one.meaning : hint;
    if (is_read[i]) read_value(table, one.key, help, one.value);
  }
  table.refuse_unknown_keys();
  return values;
}

// A refusal quotes the value at fault first. That is the one whose least change, up and down,
// changes its words earliest.
void refuse_values(const TomlTable& table, const NamedParameters& values, const std::string& words,
                   const std::function<void(const NamedParameters&)>& make) {
  const auto unchanged_words = [&](std::size_t which, double direction) {
    NamedParameters other = values;
    other[which].value = shifted(other[which].value, direction);
    try {
      make(other);
    } catch (const std::invalid_argument& error) {
      return common_start(words, error.what());
    }
    return std::size_t{0};
  };
  std::size_t earliest = words.size();
  std::string key;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!table.has(values[i].key)) continue;
    const std::size_t same = std::max(unchanged_words(i, 1.0), unchanged_words(i, -1.0));
    if (same >= earliest) continue;
    earliest = same;
    key = values[i].key;
  }
  if (key.empty()) throw InputError(table.where(), {words, "", "", ""});
  table.refuse(key, {words, "", "", ""});
}

}  // namespace tribolog
