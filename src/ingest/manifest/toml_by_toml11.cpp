// A TOML document parsed by toml11, version 3.

#include <sstream>
#include <string>

#include <fmt/format.h>
#include <toml.hpp>

#include "base/error.h"
#include "ingest/manifest/toml_document.h"

namespace tribolog::ingest::manifest {
namespace {

std::string iso(const toml::local_date& date) {
  return fmt::format("{:04}-{:02}-{:02}", date.year, date.month + 1, date.day);
}

std::string iso(const toml::local_date& date, const toml::local_time& time) {
  return fmt::format("{}T{:02}:{:02}:{:02}", iso(date), time.hour, time.minute, time.second);
}

TomlNode node_of(const toml::value& from) {
  const toml::source_location at = from.location();
  TomlNode node{static_cast<long>(at.line()), static_cast<long>(at.column()), {}};
  switch (from.type()) {
    case toml::value_t::table: {
      TomlMembers members;
      for (const auto& [name, value] : from.as_table()) members.emplace(name, node_of(value));
      node.value = std::move(members);
      break;
    }
    case toml::value_t::array: {
      TomlArray elements;
      for (const toml::value& element : from.as_array()) elements.push_back(node_of(element));
      node.value = std::move(elements);
      break;
    }
    case toml::value_t::string:
      node.value = from.as_string().str;
      break;
    case toml::value_t::integer:
      node.value = from.as_integer();
      break;
    case toml::value_t::floating:
      node.value = from.as_floating();
      break;
    case toml::value_t::boolean:
      node.value = from.as_boolean();
      break;
    case toml::value_t::local_date:
      node.value = TomlDate{iso(from.as_local_date())};
      break;
    case toml::value_t::local_datetime: {
      const toml::local_datetime& when = from.as_local_datetime();
      node.value = TomlDate{iso(when.date, when.time)};
      break;
    }
    case toml::value_t::offset_datetime: {
      const toml::offset_datetime& when = from.as_offset_datetime();
      node.value = TomlDate{iso(when.date, when.time) +
                            iso_offset(60 * when.offset.hour + when.offset.minute)};
      break;
    }
    default:
      node.value = TomlDate{};
  }
  return node;
}

/// The first line of its message, without what it puts before it: "[error] toml::parse_key: ".
std::string description(const toml::exception& error) {
  std::string text = error.what();
  text = text.substr(0, text.find('\n'));
  const std::size_t name = text.find("toml::");
  const std::size_t end = name == std::string::npos ? name : text.find(": ", name);
  return end == std::string::npos ? text : text.substr(end + 2);
}

}  // namespace

TomlNode parse_toml(std::string_view text, const std::string& file) {
  std::istringstream in{std::string(text)};
  try {
    return node_of(toml::parse(in, file));
  } catch (const toml::exception& error) {
    const toml::source_location at = error.location();
    throw InputError({file, static_cast<long>(at.line()), static_cast<long>(at.column())},
                     {"not valid TOML: " + description(error), "", "", ""});
  }
}

}  // namespace tribolog::ingest::manifest
