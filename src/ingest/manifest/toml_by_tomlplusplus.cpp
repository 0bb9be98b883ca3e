// A TOML document parsed by toml++.

#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "base/error.h"
#include "ingest/manifest/toml_document.h"

// Bounds the recursion of parser and destructor; the files read here need 3.
#define TOML_MAX_NESTED_VALUES 32
#include <toml++/toml.h>

namespace tribolog::ingest::manifest {
namespace {

std::string iso(const toml::date& date) {
  return fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day);
}

std::string iso(const toml::date_time& at) {
  const std::string text = fmt::format("{}T{:02}:{:02}:{:02}", iso(at.date), at.time.hour,
                                       at.time.minute, at.time.second);
  return at.offset ? text + iso_offset(at.offset->minutes) : text;
}

TomlNode node_of(const toml::node& from) {
  const toml::source_position begin = from.source().begin;
  TomlNode node{static_cast<long>(begin.line), static_cast<long>(begin.column), {}};
  if (const auto* table = from.as_table()) {
    TomlMembers members;
    for (auto&& [name, value] : *table) {
      members.emplace(std::string(std::string_view(name)), node_of(value));
    }
    node.value = std::move(members);
  } else if (const auto* array = from.as_array()) {
    TomlArray elements;
    for (const toml::node& element : *array) elements.push_back(node_of(element));
    node.value = std::move(elements);
  } else if (const auto* text = from.as_string()) {
    node.value = text->get();
  } else if (const auto* whole = from.as_integer()) {
    node.value = whole->get();
  } else if (const auto* number = from.as_floating_point()) {
    node.value = number->get();
  } else if (const auto* flag = from.as_boolean()) {
    node.value = flag->get();
  } else if (const auto* date = from.as_date()) {
    node.value = TomlDate{iso(date->get())};
  } else if (const auto* at = from.as_date_time()) {
    node.value = TomlDate{iso(at->get())};
  } else {
    node.value = TomlDate{};
  }
  return node;
}

}  // namespace

TomlNode parse_toml(std::string_view text, const std::string& file) {
  try {
    return node_of(toml::parse(text, std::string_view(file)));
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw InputError({file, static_cast<long>(at.line), static_cast<long>(at.column)},
                     {"not valid TOML: " + std::string(error.description()), "", "", ""});
  }
}

}  // namespace tribolog::ingest::manifest
