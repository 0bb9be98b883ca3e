#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "ingest/manifest/manifest_tables.h"
#include "ingest/manifest/toml_table.h"
#include "joint/certificate.h"

namespace tribolog::ingest::manifest {
namespace {

joint::Instrument read_instrument(const TomlTable& table) {
  joint::Instrument instrument;
  instrument.name = required_name(table, "what was measured with, as its certificate calls it");
  instrument.identification = table.text_or("identification", "");
  instrument.traceability = table.text_or("traceability", "");
  instrument.used_for = table.text_or("used_for", "");
  table.refuse_unknown_keys();
  return instrument;
}

std::string read_country(const TomlTable& table) {
  std::string country = table.text_or("country", "");
  const bool is_code =
      country.size() == 2 &&
      std::all_of(country.begin(), country.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
  if (!is_code && !country.empty()) {
    table.refuse("country", {"is no country's code", in_quotes(country),
                             "two capital letters after ISO 3166-1, as \"DE\"", ""});
  }
  return country;
}

std::optional<double> read_humidity(const TomlTable& table) {
  const auto percent = table.find_number("humidity_percent", Sign::not_negative);
  constexpr double saturated = 100;
  if (percent && *percent > saturated) {
    table.refuse("humidity_percent", {"is more than saturated air has", fmt::format("{}", *percent),
                                      fmt::format("percent, from 0 to {}", saturated), ""});
  }
  return percent;
}

}  // namespace

joint::Certificate read_certificate(const TomlTable& top) {
  const auto table = top.find_table("certificate");
  if (!table) return {};
  joint::Certificate c;
  c.number = table->text_or("number", "");
  c.replaces = table->text_or("replaces", "");
  c.laboratory = table->text_or("laboratory", "");
  c.laboratory_address = table->text_or("laboratory_address", "");
  c.country = read_country(*table);
  c.customer = table->text_or("customer", "");
  c.customer_address = table->text_or("customer_address", "");
  c.place = table->text_or("place", "");
  c.received_on = read_date(*table, "received_on");
  c.procedure = table->text_or("procedure", "");
  c.conditions = table->text_or("conditions", "");
  c.humidity_percent = read_humidity(*table);
  c.adjustment = table->text_or("adjustment", "");
  c.decision_rule = table->text_or("decision_rule", "");
  c.responsible = table->text_or("responsible", "");
  for (const TomlTable& instrument : table->tables("instrument")) {
    c.instruments.push_back(read_instrument(instrument));
  }
  table->refuse_unknown_keys();
  return c;
}

}  // namespace tribolog::ingest::manifest
