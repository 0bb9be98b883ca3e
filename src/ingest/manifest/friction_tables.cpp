#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>

#include "base/closest_match.h"
#include "friction/catalogue.h"
#include "friction/lugre.h"
#include "ingest/manifest/scenario_tables.h"
#include "ingest/manifest/toml_table.h"
#include "wording/words.h"

namespace tribolog::ingest::manifest {

// Friction models from tables of a TOML file: one key a parameter, named as the catalogue says.

namespace {

/// Values of a table, and of `otherwise` where it has no such key.
/// @param model as files say it: what its keys mean is the hint, where none is given.
/// @param needed keys must be there, unless they have a usual value. The hint says what else helps.
/// @throw InputError for a key that is missing, of another type, or unknown.
friction::NamedParameters read_parameters(const TomlTable& table, const std::string& model,
                                          const friction::NamedParameters& otherwise, bool needed,
                                          const std::string& hint = {});

/// Refuses values that no model can be made of, at the key whose value the refusal quotes.
/// @param make what refused them with `words`; throws std::invalid_argument.
/// @throw InputError at the key; at the table if none of its keys is to blame.
[[noreturn]] void refuse_values(const TomlTable& table, const friction::NamedParameters& values,
                                const std::string& words,
                                const std::function<void(const friction::NamedParameters&)>& make);

/// A model of the values. @throw InputError as refuse_values().
template <class Model>
std::shared_ptr<const Model> made_of(const TomlTable& table,
                                     const friction::NamedParameters& values,
                                     const friction::ModelRecipe<Model>& recipe) {
  try {
    return recipe.make(values);
  } catch (const std::invalid_argument& error) {
    refuse_values(table, values, wording::words(error), recipe.make);
  }
}

std::vector<friction::MaxwellElement> read_elements(const TomlTable& table, const std::string& key,
                                                    const std::string& hint) {
  std::vector<friction::MaxwellElement> elements;
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
                friction::ParameterValue& value) {
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

friction::ParameterValue shifted(const friction::ParameterValue& value, double direction) {
  friction::ParameterValue out = value;
  if (auto* number = std::get_if<double>(&out)) {
    *number = shifted(*number, direction);
  } else if (auto* count = std::get_if<std::uint64_t>(&out)) {
    *count = direction > 0 || *count == 0 ? *count + 1 : *count - 1;
  } else if (auto* elements = std::get_if<std::vector<friction::MaxwellElement>>(&out)) {
    for (friction::MaxwellElement& one : *elements) {
      one = {shifted(one.stiffness_Nm_rad, direction), shifted(one.share, direction)};
    }
  }
  return out;
}

std::size_t common_start(const std::string& a, const std::string& b) {
  const auto apart = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(apart.first - a.begin());
}

friction::NamedParameters read_parameters(const TomlTable& table, const std::string& model,
                                          const friction::NamedParameters& otherwise, bool needed,
                                          const std::string& hint) {
  friction::NamedParameters values = otherwise;
  std::vector<bool> is_read;  // asks for every key first: no other one is then a misspelling
  for (const friction::NamedParameter& one : values) {
    is_read.push_back(table.has(one.key) || (needed && !one.has_usual));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    friction::NamedParameter& one = values[i];
    const std::string help =
        hint.empty() ? wording::words_for("parameter." + model, one.key) : hint;
    if (is_read[i]) read_value(table, one.key, help, one.value);
  }
  table.refuse_unknown_keys();
  return values;
}

// A refusal quotes the value at fault first. That is the one whose least change, up and down,
// changes its words earliest.
void refuse_values(const TomlTable& table, const friction::NamedParameters& values,
                   const std::string& words,
                   const std::function<void(const friction::NamedParameters&)>& make) {
  const auto unchanged_words = [&](std::size_t which, double direction) {
    friction::NamedParameters other = values;
    other[which].value = shifted(other[which].value, direction);
    try {
      make(other);
    } catch (const std::invalid_argument& error) {
      return common_start(words, wording::words(error));
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

constexpr const char* by_dynamic_model = "dynamic";
constexpr const char* sliding_hint =
    "[friction.sliding] with model = \"dynamic\" for sweeps and runs by the dynamic model, or a "
    "static law";

template <class Entry>
std::vector<std::string> names_of(const std::vector<Entry>& entries) {
  std::vector<std::string> names;
  for (const Entry& one : entries) names.push_back(one.name);
  return names;
}

const friction::FrictionModelEntry& read_choice(const TomlTable& friction) {
  if (!friction.has("model")) return friction::dynamic_friction_model("lugre");
  return friction::dynamic_friction_models()[friction.choice(
      "model", names_of(friction::dynamic_friction_models()))];
}

void refuse_other_models(const TomlTable& friction, const friction::FrictionModelEntry& chosen) {
  for (const friction::FrictionModelEntry& one : friction::dynamic_friction_models()) {
    if (one.name == chosen.name || !friction.has(one.name)) continue;
    friction.refuse(one.name,
                    {"is of a model that is not chosen", "", "[friction." + chosen.name + "]",
                     "model = \"" + one.name + "\" in [friction] would choose it"});
  }
}

/// What one contact looks like, by LuGre's six parameters.
friction::ContactParameters read_contact(const TomlTable& table) {
  if (table.has("model")) {
    table.refuse("model", {"is stated one table up", "",
                           "model = \"" + table.text("model") + "\" in [friction]", ""});
  }
  const friction::FrictionModelEntry& six = friction::dynamic_friction_model("lugre");
  friction::NamedParameters needed = six.parameters;
  std::erase_if(needed, [](const friction::NamedParameter& one) { return one.has_usual; });
  const auto lugre = made_of(table, read_parameters(table, six.name, needed, true), six);
  const auto& p = dynamic_cast<const friction::LuGreFriction&>(*lugre).parameters();
  return {p.bristle_stiffness_Nm_rad,
          p.bristle_damping_Nms_rad,
          p.viscous_Nms_rad,
          p.coulomb_Nm,
          p.static_Nm,
          p.stribeck_speed_rad_s};
}

std::shared_ptr<const friction::DynamicFriction> read_dynamic(const TomlTable& friction) {
  const friction::FrictionModelEntry& chosen = read_choice(friction);
  refuse_other_models(friction, chosen);
  const auto own = friction.find_table(chosen.name);
  std::optional<friction::ContactParameters> contact;
  if (friction.has("presliding") || !own) {
    contact = read_contact(friction.table("presliding", "the contact's six numbers, or [friction." +
                                                            chosen.name + "] with all of its own"));
  }
  const friction::NamedParameters matched =
      contact ? chosen.matched_parameters(*contact) : chosen.parameters;
  if (!own) return guarded(friction, "presliding", [&] { return chosen.make(matched); });
  const friction::NamedParameters values =
      read_parameters(*own, chosen.name, matched, !contact,
                      contact ? "" : "[friction.presliding] would give a value to match");
  return made_of(*own, values, chosen);
}

std::shared_ptr<const friction::StaticFriction> read_sliding(const TomlTable& sliding) {
  std::vector<std::string> names = names_of(friction::static_friction_laws());
  names.emplace_back(by_dynamic_model);
  const std::size_t choice = sliding.choice("model", names);
  if (names[choice] == by_dynamic_model) {
    sliding.refuse_unknown_keys();
    return nullptr;
  }
  const friction::StaticLawEntry& law = friction::static_friction_laws()[choice];
  return made_of(sliding, read_parameters(sliding, law.name, law.parameters, true), law);
}

}  // namespace

JointFriction read_friction(const TomlTable& friction) {
  (void)friction.has("sliding");  // so that it is not taken for another key, misspelt
  JointFriction read{read_dynamic(friction), read_sliding(friction.table("sliding", sliding_hint))};
  friction.refuse_unknown_keys();
  return read;
}

std::shared_ptr<const friction::StaticFriction> read_known_curve(const TomlTable& reference) {
  std::shared_ptr<const friction::StaticFriction> known;
  const auto only_one = [&](const std::string& name) {
    if (!known) return;
    reference.refuse(name, {"is a second known curve", "", "one, " + in_quotes(known->name()), ""});
  };
  const auto read = [&](const auto& recipe) {
    const auto table = reference.find_table(recipe.name);
    if (table) only_one(recipe.name);
    return table ? made_of(*table, read_parameters(*table, recipe.name, recipe.parameters, true),
                           recipe)
                 : nullptr;
  };
  for (const friction::StaticLawEntry& law : friction::static_friction_laws()) {
    if (const auto curve = read(law)) known = curve;
  }
  for (const friction::FrictionModelEntry& model : friction::dynamic_friction_models()) {
    if (const auto dynamic = read(model))
      known = std::make_shared<friction::SteadyFriction>(dynamic);
  }
  reference.refuse_unknown_keys();
  return known;
}

}  // namespace tribolog::ingest::manifest
