#include <cmath>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/enum_text.h"
#include "calibration/json_values.h"
#include "calibration/read_calibration.h"
#include "joint/dataset.h"

namespace tribolog::calibration {
namespace {

using ReadJson = nlohmann::json;

std::string text(const ReadJson& object, const char* key) {
  const ReadJson& value = member(object, key);
  return value.is_string() ? value.get<std::string>() : "";
}

std::optional<double> finite(const ReadJson& object, const char* key) {
  const ReadJson& value = member(object, key);
  if (!value.is_number() || !std::isfinite(value.get<double>())) return std::nullopt;
  return value.get<double>();
}

/// Degrees of freedom: null is infinite.
std::optional<double> freedom_in(const ReadJson& object) {
  if (!object.contains("degrees_of_freedom")) return std::nullopt;
  if (object["degrees_of_freedom"].is_null()) return std::numeric_limits<double>::infinity();
  return finite(object, "degrees_of_freedom");
}

std::optional<BudgetPart> part_of(const ReadJson& listed) {
  const std::optional<Influence> influence = influence_of(text(listed, "influence"));
  const auto uncertainty = finite(listed, "standard_uncertainty");
  const auto degrees = listed.is_object() ? freedom_in(listed) : std::nullopt;
  if (!influence || !uncertainty || *uncertainty < 0 || !degrees) return std::nullopt;
  BudgetPart part;
  part.influence = *influence;
  part.is_type_b = text(listed, "type") == "B";
  part.stated = finite(listed, "stated");
  part.sensitivity = finite(listed, "sensitivity").value_or(1);
  part.standard_uncertainty = *uncertainty;
  part.freedom = *degrees;
  part.share = finite(listed, "share").value_or(0);
  part.id = text(listed, "id");
  return part;
}

std::optional<statistics::Estimate> estimate_of(const ReadJson& object) {
  const auto value = finite(object, "estimate");
  const auto low = finite(object, "low");
  const auto high = finite(object, "high");
  if (!value || !low || !high || *low > *value || *high < *value) return std::nullopt;
  return statistics::Estimate{*value, *low, *high, Statement::verbatim(text(object, "method"))};
}

std::optional<UncertaintyBudget> budget_of(const ReadJson& listed) {
  const ReadJson& parts = member(listed, "parts");
  const auto uncertainty = finite(listed, "standard_uncertainty");
  const auto factor = finite(listed, "coverage_factor");
  const auto degrees = listed.is_object() ? freedom_in(listed) : std::nullopt;
  auto expanded = estimate_of(member(listed, "expanded"));
  if (!parts.is_array() || !uncertainty || !factor || !degrees || !expanded) return std::nullopt;
  UncertaintyBudget budget;
  for (const ReadJson& one : parts) {
    const auto part = part_of(one);
    if (!part) return std::nullopt;
    budget.parts.push_back(*part);
  }
  const ReadJson& effects = member(listed, "effects");
  if (effects.is_array()) {
    for (const ReadJson& one : effects) {
      budget.effects.push_back({text(one, "effect"), finite(one, "share").value_or(0),
                                finite(one, "size").value_or(0), text(one, "unit"),
                                member(one, "is_stated") == true});
    }
  }
  const ReadJson& left_out = member(listed, "not_included");
  if (left_out.is_array()) {
    for (const ReadJson& one : left_out) {
      const auto influence = influence_of(one.is_string() ? one.get<std::string>() : "");
      if (influence) budget.not_stated.push_back(*influence);
    }
  }
  budget.standard_uncertainty = *uncertainty;
  budget.freedom = *degrees;
  budget.coverage_factor = *factor;
  budget.expanded = *std::move(expanded);
  return budget;
}

std::vector<RecordedLimit> limits_of(const ReadJson& listed) {
  std::vector<RecordedLimit> limits;
  if (!listed.is_array()) return limits;
  for (const ReadJson& one : listed) {
    RecordedLimit limit;
    const joint::LimitedQuantity* known = joint::find_limited_quantity(text(one, "quantity"));
    limit.at_joint = known != nullptr && known->at_joint;
    limit.state = own_names<LimitState>.find(text(one, "state")).value_or(limit.state);
    limit.words = text(one, "words");
    limits.push_back(std::move(limit));
  }
  return limits;
}

}  // namespace

joint::Certificate read_certificate(const std::string& json) {
  const ReadJson whole = ReadJson::parse(json, nullptr, false);
  if (whole.is_discarded()) return {};
  const ReadJson& stated = member(whole, "certificate");
  joint::Certificate c;
  c.number = text(stated, "number");
  c.replaces = text(stated, "replaces");
  c.laboratory = text(stated, "laboratory");
  c.laboratory_address = text(stated, "laboratory_address");
  c.country = text(stated, "country");
  c.customer = text(stated, "customer");
  c.customer_address = text(stated, "customer_address");
  c.place = text(stated, "place");
  c.received_on = text(stated, "received_on");
  c.procedure = text(stated, "procedure");
  c.conditions = text(stated, "conditions");
  c.humidity_percent = finite(stated, "humidity_percent");
  c.adjustment = text(stated, "adjustment");
  c.decision_rule = text(stated, "decision_rule");
  c.responsible = text(stated, "responsible");
  const ReadJson& instruments = member(stated, "instruments");
  if (!instruments.is_array()) return c;
  for (const ReadJson& one : instruments) {
    c.instruments.push_back({text(one, "name"), text(one, "identification"),
                             text(one, "traceability"), text(one, "used_for")});
  }
  return c;
}

std::map<std::string, RecordedEvidence> read_evidence(const std::string& json) {
  std::map<std::string, RecordedEvidence> all;
  const ReadJson whole = ReadJson::parse(json, nullptr, false);
  if (whole.is_discarded()) return all;
  const ReadJson& quantities = member(member(whole, "verdict"), "quantities");
  if (!quantities.is_array()) return all;
  for (const ReadJson& quantity : quantities) {
    RecordedEvidence evidence;
    const ReadJson& reasons = member(quantity, "reasons");
    if (reasons.is_array()) {
      for (const ReadJson& reason : reasons) {
        if (reason.is_string()) evidence.reasons.push_back(reason.get<std::string>());
      }
    }
    evidence.budget = budget_of(member(quantity, "budget"));
    evidence.limits = limits_of(member(quantity, "limits"));
    all[text(quantity, "key")] = std::move(evidence);
  }
  return all;
}

}  // namespace tribolog::calibration
