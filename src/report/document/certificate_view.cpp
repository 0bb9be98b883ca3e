// Page one's terms: what the numbers rest on, and what a calibration certificate states (ISO/IEC
// 17025:2017, 7.8). What the manifest does not state is said not to be.

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/document/view_parts.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

namespace {

using joint::Role;
using wording::tr;
using wording::tr_count;

constexpr Role roles[] = {Role::rough_sweep,    Role::precise_sweep, Role::oscillation,
                          Role::constant_speed, Role::break_away,    Role::friction_points};

std::string recordings_of(Role role, std::size_t count) {
  const std::initializer_list<StatedValue> n = {{"count", count}};
  switch (role) {
    case Role::rough_sweep:
      return tr_count(count, "{count} sweep", "{count} sweeps", n);
    case Role::precise_sweep:
      return tr_count(count, "{count} precise sweep", "{count} precise sweeps", n);
    case Role::oscillation:
      return tr_count(count, "{count} oscillation", "{count} oscillations", n);
    case Role::constant_speed:
      return tr_count(count, "{count} run at constant speed", "{count} runs at constant speed", n);
    case Role::break_away:
      return tr_count(count, "{count} torque ramp", "{count} torque ramps", n);
    case Role::friction_points:
      break;
  }
  return tr_count(count, "{count} table of friction points", "{count} tables of friction points",
                  n);
}

std::string what_went_in(const calibration::Calibration& c) {
  std::map<std::string, std::size_t> of_role;
  struct Rows {
    std::size_t read{};
    std::size_t used{};
  };
  // Of a log with several recordings each row counts once.
  std::map<std::string, Rows> of_log;
  for (const joint::InputFile& input : c.inputs) {
    ++of_role[input.role];
    Rows& rows = of_log[input.name];
    rows.read = std::max(rows.read, input.rows_read);
    rows.used += input.rows_used;
  }
  std::size_t read = 0;
  std::size_t used = 0;
  for (const auto& [name, rows] : of_log) {
    read += rows.read;
    used += std::min(rows.used, rows.read);
  }
  std::vector<std::string> kinds;
  for (const Role role : roles) {
    const auto found = of_role.find(to_string(role));
    if (found != of_role.end()) kinds.push_back(recordings_of(role, found->second));
  }
  if (kinds.empty()) return "–";
  const std::string recordings = fmt::format("{}", fmt::join(kinds, ", "));
  return tr(
      "{recordings}; {used} of {read} rows used",
      {{"recordings", recordings}, {"used", wording::count(used)}, {"read", wording::count(read)}});
}

std::string names_of(const std::vector<calibration::Influence>& influences) {
  std::vector<std::string> names;
  for (const calibration::Influence one : influences) {
    const std::string name = wording::words_for("influence", to_string(one));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string included(const calibration::Judgement& judgement) {
  std::vector<calibration::Influence> parts;
  for (const calibration::QuantityVerdict& q : judgement.quantities) {
    const calibration::UncertaintyBudget* budget = stated_budget(q);
    if (budget == nullptr) continue;
    for (const calibration::BudgetPart& part : budget->parts) parts.push_back(part.influence);
  }
  return wording::or_dash(names_of(parts));
}

std::string not_included(const calibration::Judgement& judgement) {
  std::vector<calibration::Influence> missing;
  for (const calibration::QuantityVerdict& q : judgement.quantities) {
    const calibration::UncertaintyBudget* budget = stated_budget(q);
    if (budget == nullptr) continue;
    missing.insert(missing.end(), budget->not_stated.begin(), budget->not_stated.end());
  }
  const std::string never = tr("wear, and temperatures and loads other than those recorded");
  return missing.empty() ? never
                         : tr("uncertainty of the {influences}: not stated; {never}",
                              {{"influences", names_of(missing)}, {"never", never}});
}

std::string range_in_words(double low, double high, const wording::Scale& scale) {
  constexpr int digits = 3;
  return tr("{low} to {high}",
            {{"low", wording::significant(low * scale.factor, digits)},
             {"high",
              wording::with_unit(wording::significant(high * scale.factor, digits), scale.unit)}});
}

/// Angles, speeds and strokes: the numbers hold there. Empty: none was recorded.
std::string what_was_seen(const calibration::Calibration& c) {
  std::vector<std::string> seen;
  const method::gravity::SweepCurves& sweep = c.curves.rough;
  if (sweep.highest_rad > sweep.lowest_rad) {
    seen.push_back(tr(
        "joint angles {range}",
        {{"range", range_in_words(sweep.lowest_rad, sweep.highest_rad, wording::degree_scale())}}));
  }
  wording::Extent speeds;
  for (const method::viscous::ConstantSpeedRun& run : c.viscous.runs) {
    if (run.speed_rad_s != 0) speeds.add(std::abs(run.speed_rad_s));
  }
  for (const calibration::FrictionAtSpeed& one : c.judgement.friction_at_speed) {
    speeds.add(one.speed_rad_s);
  }
  if (!speeds.empty) {
    const std::string range =
        range_in_words(speeds.low, speeds.high, wording::plain_scale("rad/s"));
    seen.push_back(c.manifest.drive.gear_ratio() != 1.0
                       ? tr("motor speeds {range}", {{"range", range}})
                       : tr("joint speeds {range}", {{"range", range}}));
  }
  wording::Extent strokes;
  for (const method::hysteresis::Oscillation& o : c.hysteresis.oscillations) {
    strokes.add(std::abs(o.amplitude_rad));
  }
  if (!strokes.empty) {
    const wording::Scale scale = wording::radian_scale(strokes.high);
    seen.push_back(tr(
        "oscillations of ±{amplitude}",
        {{"amplitude",
          wording::with_unit(wording::significant(strokes.high * scale.factor, 3), scale.unit)}}));
  }
  return fmt::format("{}", fmt::join(seen, ", "));
}

std::string or_not_stated(const std::string& text) {
  return text.empty() ? tr("not stated") : text;
}

/// Where the torque's scale comes from.
std::string torque_scale_in_words(const joint::Manifest& m) {
  std::vector<std::string> parts;
  const auto constant = m.drive.torque_constant_Nm_A();
  if (constant && !m.torque_is_in_amperes) {
    parts.push_back(tr("torque constant {constant}",
                       {{"constant", wording::with_unit(wording::as_stated(*constant), "N·m/A")}}));
  }
  const auto& percent = m.uncertainty.torque_constant_percent;
  parts.push_back(percent ? tr("torque scale ± {percent} (95 %)",
                               {{"percent", wording::with_unit(wording::as_stated(*percent), "%")}})
                          : tr("uncertainty of the torque scale not stated"));
  const auto source = m.uncertainty.id.find("torque_constant");
  if (source != m.uncertainty.id.end()) parts.push_back(source->second);
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::string conditions_in_words(const joint::Manifest& m) {
  std::vector<std::string> parts;
  parts.push_back(m.temperature_C ? wording::with_unit(wording::as_stated(*m.temperature_C), "°C")
                                  : tr("temperature not stated"));
  if (m.certificate.humidity_percent) {
    parts.push_back(
        tr("humidity {humidity}",
           {{"humidity",
             wording::with_unit(wording::as_stated(*m.certificate.humidity_percent), "%")}}));
  }
  const std::string payload = payload_in_words(m);
  parts.push_back(payload.empty() ? tr("payload not stated")
                                  : tr("payload {payload}", {{"payload", payload}}));
  if (!m.certificate.conditions.empty()) parts.push_back(m.certificate.conditions);
  return fmt::format("{}", fmt::join(parts, "; "));
}

/// "encoder 4711 (D-K-15195, 2026-03; for the angle)"
std::string instrument_in_words(const joint::Instrument& one) {
  std::string words = one.name;
  if (!one.identification.empty()) words += " " + one.identification;
  std::string about = or_not_stated(one.traceability);
  if (!one.used_for.empty()) about += "; " + one.used_for;
  return words + " (" + about + ")";
}

std::string traceability_in_words(const joint::Manifest& m) {
  std::vector<std::string> parts;
  for (const joint::Instrument& one : m.certificate.instruments) {
    parts.push_back(instrument_in_words(one));
  }
  if (parts.empty()) parts.push_back(tr("instruments not stated"));
  parts.push_back(torque_scale_in_words(m));
  return fmt::format("{}", fmt::join(parts, "; "));
}

/// A name with its address, as far as they are stated.
std::string with_address(const std::string& name, const std::string& address) {
  return name.empty() || address.empty() ? name + address : name + ", " + address;
}

/// What is stated has a line of its own; what is not is listed in one.
class StatedFacts {
 public:
  void add(const std::string& name, const std::string& text) {
    if (text.empty()) {
      missing_.push_back(wording::within_a_sentence(name));
    } else {
      facts_.push_back({name, text});
    }
  }
  [[nodiscard]] std::vector<Fact> all() const {
    std::vector<Fact> facts = facts_;
    if (!missing_.empty()) {
      facts.push_back({tr("Not stated"), fmt::format("{}", fmt::join(missing_, ", "))});
    }
    return facts;
  }

 private:
  std::vector<Fact> facts_;
  std::vector<std::string> missing_;
};

}  // namespace

std::string report_number(const joint::Manifest& manifest, const std::string& id) {
  constexpr std::size_t digits = 12;
  if (!manifest.certificate.number.empty()) return manifest.certificate.number;
  return id.empty() ? "–" : "tribolog-" + id.substr(0, digits);
}

std::vector<Fact> boundary_facts(const calibration::Calibration& c) {
  const std::string seen = what_was_seen(c);
  return {{tr("What went in"), what_went_in(c)},
          {tr("Included in U"), included(c.judgement)},
          {tr("Not included"), not_included(c.judgement)},
          {tr("Holds for"),
           seen.empty() ? tr("this item alone, as it was measured")
                        : tr("this item alone, as it was measured: {seen}", {{"seen", seen}})}};
}

std::vector<Fact> certificate_facts(const calibration::Calibration& c,
                                    const calibration::Provenance& provenance) {
  const joint::Manifest& m = c.manifest;
  const joint::Certificate& stated = m.certificate;
  StatedFacts facts;
  facts.add(tr("Laboratory"), with_address(stated.laboratory, stated.laboratory_address));
  facts.add(tr("Customer"), with_address(stated.customer, stated.customer_address));
  facts.add(
      tr("Item"),
      fmt::format("{}; {}; {}", or_not_stated(m.robot == joint::unnamed_robot ? "" : m.robot),
                  tr("serial number {serial}", {{"serial", or_not_stated(m.serial)}}),
                  tr("joint {joint}, gear ratio {gear_ratio}",
                     {{"joint", or_not_stated(m.joint == joint::unnamed_joint ? "" : m.joint)},
                      {"gear_ratio", wording::as_stated(m.drive.gear_ratio())}})));
  facts.add(tr("Received"), stated.received_on);
  facts.add(tr("Measured"), m.measured_on);
  facts.add(tr("Place"), stated.place);
  facts.add(tr("Issued"), wording::date_of(provenance.created_utc));
  facts.add(tr("Operator"), m.operator_name);
  facts.add(tr("Conditions"), conditions_in_words(m));
  facts.add(tr("Traceability"), traceability_in_words(m));
  facts.add(tr("Method"),
            tr("“Viscous friction measurement technique in robot joint with the use of surrogate "
               "mass”; tribolog {version}",
               {{"version", provenance.tool_version}}));
  facts.add(tr("Procedure"), stated.procedure);
  facts.add(tr("Adjustment"), stated.adjustment);
  facts.add(tr("Decision rule"),
            stated.decision_rule.empty()
                ? tr("a limit is met where the whole 95 % interval meets it; verdicts by the "
                     "rules in this report")
                : stated.decision_rule);
  facts.add(tr("Responsible"), stated.responsible);
  if (!stated.replaces.empty()) facts.add(tr("Replaces"), stated.replaces);
  if (m.reference) facts.add(tr("Data"), tr("simulated, the true curve is known"));
  return facts.all();
}

}  // namespace tribolog::report::document
