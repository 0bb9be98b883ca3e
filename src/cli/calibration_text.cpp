#include "cli/calibration_text.h"

#include <fmt/format.h>

#include "base/error.h"
#include "inspect/survey/text_table.h"

namespace tribolog::cli {

std::string facts_text(const calibration::Facts& f, const std::string& id, int revision) {
  inspect::survey::TextTable table(0);
  const auto add = [&](const char* name, const std::string& text) {
    if (!text.empty()) table.add({name, printable(text, 400)});
  };
  const auto number = [](const std::optional<double>& value, const char* unit) {
    return value ? fmt::format("{:.6g} {}", *value, unit) : "";
  };
  add("id", id);
  add("robot", f.of.robot);
  add("serial", f.of.serial);
  add("joint", f.of.joint);
  add("measured", f.time_is_stated ? f.measured_at : "");
  add("measured on", f.time_is_stated ? "" : f.measured_on);
  add("identified", f.created_utc);
  add("operator", f.operator_name);
  add("temperature", number(f.temperature_C, "°C"));
  add("payload", f.payload);
  add("payload mass", number(f.payload_kg, "kg"));
  add("gear ratio", fmt::format("{:.6g}", f.gear_ratio));
  add("sampling rate", number(f.sampling_Hz, "Hz"));
  add("note", f.note);
  add("verdict", calibration::to_string(f.verdict) + ": " + f.sentence);
  add("revision", revision > 1 ? std::to_string(revision) : "");
  add("tribolog", f.tool_version + " (" + f.git_revision + ")");
  return table.text();
}

std::string quantities_text(const std::vector<calibration::Quantity>& quantities) {
  inspect::survey::TextTable table(0);
  table.add({"quantity", "value", "95 %", "unit", "verdict"});
  for (const calibration::Quantity& q : quantities) {
    const auto& e = q.estimate;
    table.add({printable(q.words), e ? fmt::format("{:.6g}", e->value) : "",
               e ? fmt::format("{:.6g} to {:.6g}", e->low, e->high) : "", printable(q.unit),
               calibration::to_string(q.verdict)});
  }
  return table.text();
}

}  // namespace tribolog::cli
