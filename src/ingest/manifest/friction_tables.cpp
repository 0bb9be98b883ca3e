#include "ingest/manifest/friction_tables.h"

#include <optional>

#include "base/closest_match.h"
#include "friction/catalogue.h"
#include "friction/lugre.h"
#include "ingest/manifest/key_guard.h"
#include "ingest/manifest/parameter_table.h"

namespace tribolog {
namespace {

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

const FrictionModelEntry& read_choice(const TomlTable& friction) {
  if (!friction.has("model")) return dynamic_friction_model("lugre");
  return dynamic_friction_models()[friction.choice("model", names_of(dynamic_friction_models()))];
}

void refuse_other_models(const TomlTable& friction, const FrictionModelEntry& chosen) {
  for (const FrictionModelEntry& one : dynamic_friction_models()) {
    if (one.name == chosen.name || !friction.has(one.name)) continue;
    friction.refuse(one.name,
                    {"is of a model that is not chosen", "", "[friction." + chosen.name + "]",
                     "model = \"" + one.name + "\" in [friction] would choose it"});
  }
}

/// What one contact looks like, by LuGre's six parameters.
ContactParameters read_contact(const TomlTable& table) {
  if (table.has("model")) {
    table.refuse("model", {"is stated one table up", "",
                           "model = \"" + table.text("model") + "\" in [friction]", ""});
  }
  const FrictionModelEntry& six = dynamic_friction_model("lugre");
  const auto lugre = made_of(table, read_parameters(table, six.parameters, true), six);
  const auto& p = dynamic_cast<const LuGreFriction&>(*lugre).parameters();
  return {p.bristle_stiffness_Nm_rad,
          p.bristle_damping_Nms_rad,
          p.viscous_Nms_rad,
          p.coulomb_Nm,
          p.static_Nm,
          p.stribeck_speed_rad_s};
}

std::shared_ptr<const DynamicFriction> read_dynamic(const TomlTable& friction) {
  const FrictionModelEntry& chosen = read_choice(friction);
  refuse_other_models(friction, chosen);
  const auto own = friction.find_table(chosen.name);
  std::optional<ContactParameters> contact;
  if (friction.has("presliding") || !own) {
    contact = read_contact(friction.table("presliding", "the contact's six numbers, or [friction." +
                                                            chosen.name + "] with all of its own"));
  }
  const NamedParameters matched = contact ? chosen.matched_parameters(*contact) : chosen.parameters;
  if (!own) return guarded(friction, "presliding", [&] { return chosen.make(matched); });
  const NamedParameters values = read_parameters(
      *own, matched, !contact, contact ? "" : "[friction.presliding] would give a value to match");
  return made_of(*own, values, chosen);
}

std::shared_ptr<const StaticFriction> read_sliding(const TomlTable& sliding) {
  std::vector<std::string> names = names_of(static_friction_laws());
  names.emplace_back(by_dynamic_model);
  const std::size_t choice = sliding.choice("model", names);
  if (names[choice] == by_dynamic_model) {
    sliding.refuse_unknown_keys();
    return nullptr;
  }
  const StaticLawEntry& law = static_friction_laws()[choice];
  return made_of(sliding, read_parameters(sliding, law.parameters, true), law);
}

}  // namespace

JointFriction read_friction(const TomlTable& friction) {
  (void)friction.has("sliding");  // so that it is not taken for another key, misspelt
  JointFriction read{read_dynamic(friction), read_sliding(friction.table("sliding", sliding_hint))};
  friction.refuse_unknown_keys();
  return read;
}

std::shared_ptr<const StaticFriction> read_known_curve(const TomlTable& reference) {
  std::shared_ptr<const StaticFriction> known;
  const auto only_one = [&](const std::string& name) {
    if (!known) return;
    reference.refuse(name, {"is a second known curve", "", "one, " + in_quotes(known->name()), ""});
  };
  const auto read = [&](const auto& recipe) {
    const auto table = reference.find_table(recipe.name);
    if (table) only_one(recipe.name);
    return table ? made_of(*table, read_parameters(*table, recipe.parameters, true), recipe)
                 : nullptr;
  };
  for (const StaticLawEntry& law : static_friction_laws()) {
    if (const auto curve = read(law)) known = curve;
  }
  for (const FrictionModelEntry& model : dynamic_friction_models()) {
    if (const auto dynamic = read(model)) known = std::make_shared<SteadyFriction>(dynamic);
  }
  reference.refuse_unknown_keys();
  return known;
}

}  // namespace tribolog
