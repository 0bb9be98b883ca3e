#pragma once
// Friction models from tables of a TOML file: one key a parameter, named as the catalogue says.

#include <functional>
#include <memory>
#include <stdexcept>

#include "friction/catalogue.h"
#include "ingest/manifest/toml_table.h"

namespace tribolog {

/// Values of a table, and of `otherwise` where it has no such key.
/// @param needed keys must be there, unless they have a usual value. The hint says what else helps.
/// @throw InputError for a key that is missing, of another type, or unknown.
NamedParameters read_parameters(const TomlTable& table, const NamedParameters& otherwise,
                                bool needed, const std::string& hint = {});

/// Refuses values that no model can be made of, at the key whose value the refusal quotes.
/// @param make what refused them with `words`; throws std::invalid_argument.
/// @throw InputError at the key; at the table if none of its keys is to blame.
[[noreturn]] void refuse_values(const TomlTable& table, const NamedParameters& values,
                                const std::string& words,
                                const std::function<void(const NamedParameters&)>& make);

/// A model of the values. @throw InputError as refuse_values().
template <class Model>
std::shared_ptr<const Model> made_of(const TomlTable& table, const NamedParameters& values,
                                     const ModelRecipe<Model>& recipe) {
  try {
    return recipe.make(values);
  } catch (const std::invalid_argument& error) {
    refuse_values(table, values, error.what(), recipe.make);
  }
}

}  // namespace tribolog
