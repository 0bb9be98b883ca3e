#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/requirements.h"
#include "calibration/archived_calibration.h"
#include "calibration/provenance.h"
#include "calibration/read_calibration.h"
#include "exports/results/archived_joint.h"
#include "exports/results/calibration_exports.h"
#include "exports/results/certified_curve.h"
#include "exports/results/xml_text.h"
#include "wording/language.h"
#include "wording/number_text.h"
#include "wording/words.h"

namespace tribolog::exports::results {
namespace {

using Attributes = XmlWriter::Attributes;

constexpr const char* schema_version = "3.1.2";
const std::string not_stated = "not stated";
/// Where the schema wants a code or a day, and takes no words. ISO 3166-1 leaves ZZ to its users.
const std::string no_country = "ZZ";
const std::string no_day = "0001-01-01";

constexpr const char* paper_title =
    "Viscous friction measurement technique in robot joint with the use of surrogate mass";

std::string or_not_stated(const std::string& text) { return text.empty() ? not_stated : text; }

/// The unit in the syntax of D-SI; empty for one that no quantity has.
std::string si_unit(const std::string& unit) {
  struct Spelling {
    std::string_view unit;
    const char* si;
  };
  static constexpr std::array units{
      Spelling{"rad", R"(\radian)"}, Spelling{"rad/s", R"(\radian\per\second)"},
      Spelling{"N·m", R"(\newton\metre)"}, Spelling{"N·m/rad", R"(\newton\metre\per\radian)"},
      Spelling{"N·m·s/rad", R"(\newton\metre\second\per\radian)"}, Spelling{"kg", R"(\kilogram)"},
      Spelling{"kg·m²", R"(\kilogram\metre\tothe{2})"},
      // Where the torque constant is not known:
      Spelling{"A", R"(\ampere)"}, Spelling{"A/rad", R"(\ampere\per\radian)"},
      Spelling{"A·s/rad", R"(\ampere\second\per\radian)"},
      Spelling{"A·s²/rad", R"(\ampere\second\tothe{2}\per\radian)"}};
  const auto* const found = std::find_if(units.begin(), units.end(),
                                         [&](const Spelling& one) { return one.unit == unit; });
  return found == units.end() ? "" : found->si;
}

/// The day of an ISO date, with a time or without, as it is written; nothing for other words.
std::optional<std::string> day_of(const std::string& date) {
  constexpr std::size_t length = std::string_view("2026-01-31").size();
  if (calibration::utc_of_iso_text(date).empty()) return std::nullopt;
  std::string day = date.substr(0, length);
  const bool is_whole = day.size() == length && day[4] == '-' && day[7] == '-' &&
                        day.find_first_not_of("0123456789-") == std::string::npos;
  if (!is_whole || day.starts_with("0000")) return std::nullopt;
  return day;
}

/// Two capital letters; the file may be somebody else's.
bool is_country(const std::string& code) {
  return code.size() == 2 &&
         std::all_of(code.begin(), code.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

std::string verdict_words(calibration::Verdict verdict) {
  return verdict == calibration::Verdict::not_identifiable ? "not identifiable"
                                                           : calibration::to_string(verdict);
}

// A number with its uncertainty.

/// Value, uncertainty and interval of a quantity on one side, in its unit.
struct Measurement {
  statistics::Estimate estimate;  ///< Expanded: with all that is stated.
  double standard_uncertainty{};  ///< Half width over `normal`, where there is no budget.
  std::optional<double> factor;   ///< Where a budget states one.
  bool is_normal{};               ///< Degrees of freedom are infinite.
  std::optional<double> freedom;  ///< Of a budget, where finite.
  std::vector<calibration::Influence> left_out{};  ///< That are not stated.
};

Measurement measured(const calibration::Quantity& motor, int gear_power, double gear_ratio,
                     const calibration::RecordedEvidence& evidence) {
  const double factor = std::pow(gear_ratio, gear_power);
  const statistics::Estimate& own = present(motor.estimate);
  Measurement m;
  if (!evidence.budget) {
    m.estimate = statistics::scaled(own, factor);
    m.standard_uncertainty = m.estimate.half_width() /
                             calibration::coverage_factor(std::numeric_limits<double>::infinity());
    return m;
  }
  const calibration::UncertaintyBudget budget =
      gear_power == 0 ? *evidence.budget
                      : calibration::budget_at(*evidence.budget, own, gear_power);
  m.estimate = statistics::scaled(budget.expanded, factor);
  m.standard_uncertainty = budget.standard_uncertainty * std::abs(factor);
  m.factor = budget.coverage_factor;
  m.is_normal = std::isinf(budget.freedom);
  if (!m.is_normal) m.freedom = budget.freedom;
  m.left_out = left_out_of(budget, gear_power);
  return m;
}

/// Symmetric, and as wide as factor times standard uncertainty: it can be stated as one number.
bool has_expanded_uncertainty(const Measurement& m) {
  if (!m.factor || !(*m.factor >= 1) || !std::isfinite(*m.factor)) return false;
  constexpr double of_rounding = 1e-6;
  const double half_width = m.estimate.half_width();
  const double room = of_rounding * half_width;
  const double up = m.estimate.high - m.estimate.value;
  const double down = m.estimate.value - m.estimate.low;
  return std::abs(up - down) <= room &&
         std::abs(*m.factor * m.standard_uncertainty - half_width) <= room;
}

/// An interval of no width that no budget is behind was not found: it was not known, or was
/// infinite.
bool has_no_uncertainty(const Measurement& m) {
  return !m.factor && !(m.estimate.half_width() > 0);
}

// Parts of the certificate.

class Certificate {
 public:
  explicit Certificate(const ArchivedJoint& joint)
      : joint_(joint),
        facts_(joint.entry.facts),
        stated_(calibration::read_certificate(joint.calibration)),
        evidence_(calibration::read_evidence(joint.calibration)) {}

  std::string document() {
    xml_.element("dcc:digitalCalibrationCertificate",
                 {{"schemaVersion", schema_version},
                  {"xmlns:dcc", "https://ptb.de/dcc"},
                  {"xmlns:si", "https://ptb.de/si"},
                  {"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"},
                  {"xsi:schemaLocation", "https://ptb.de/dcc https://ptb.de/dcc/v3.1.2/dcc.xsd"}},
                 [&] {
                   administrative_data();
                   xml_.element("dcc:measurementResults", [&] {
                     xml_.element("dcc:measurementResult", [&] { measurement_result(); });
                   });
                 });
    return xml_.document();
  }

 private:
  // Texts: the program's own have their language; those of a manifest are in any.

  void own_content(const std::string& text) { xml_.leaf("dcc:content", text, {{"lang", "en"}}); }
  void own_text(const char* element, const std::string& text, const Attributes& attributes = {}) {
    xml_.element(element, attributes, [&] { own_content(text); });
  }
  void content(const std::string& stated) {
    if (stated.empty()) {
      own_content(not_stated);
    } else {
      xml_.leaf("dcc:content", stated);
    }
  }
  void stated_text(const char* element, const std::string& stated) {
    xml_.element(element, [&] { content(stated); });
  }

  // Who, for whom, what and when.

  void administrative_data() {
    xml_.element("dcc:administrativeData", [&] {
      xml_.element("dcc:dccSoftware", [&] {
        software(calibration::make_provenance({}).tool_version, "Wrote this certificate.");
      });
      xml_.element("dcc:coreData", [&] { core_data(); });
      xml_.element("dcc:items", [&] { xml_.element("dcc:item", [&] { item(); }); });
      xml_.element("dcc:calibrationLaboratory", [&] {
        xml_.element("dcc:contact", [&] {
          contact(stated_.laboratory, stated_.laboratory_address, stated_.country);
        });
      });
      xml_.element("dcc:respPersons", [&] {
        person(stated_.responsible, "authorises the certificate", true);
        if (!facts_.operator_name.empty()) person(facts_.operator_name, "operator", false);
      });
      xml_.element("dcc:customer",
                   [&] { contact(stated_.customer, stated_.customer_address, ""); });
      xml_.element("dcc:statements", [&] { statements(); });
    });
  }

  void software(const std::string& version, const std::string& description) {
    xml_.element("dcc:software", [&] {
      own_text("dcc:name", "tribolog");
      xml_.leaf("dcc:release", or_not_stated(version));
      xml_.leaf("dcc:type", "application");
      own_text("dcc:description", description);
    });
  }

  void core_data() {
    xml_.leaf("dcc:countryCodeISO3166_1",
              is_country(stated_.country) ? stated_.country : no_country);
    xml_.leaf("dcc:usedLangCodeISO639_1", "en");
    xml_.leaf("dcc:mandatoryLangCodeISO639_1", "en");
    constexpr std::size_t digits = 12;
    xml_.leaf("dcc:uniqueIdentifier", stated_.number.empty()
                                          ? "tribolog-" + joint_.entry.id.substr(0, digits)
                                          : stated_.number);
    xml_.element("dcc:identifications", [&] {
      identification("other", joint_.entry.id, "Calibration, by its input files");
    });
    if (const auto day = day_of(stated_.received_on)) xml_.leaf("dcc:receiptDate", *day);
    const std::string day = day_of(facts_.measured_on).value_or(no_day);
    xml_.leaf("dcc:beginPerformanceDate", day);
    xml_.leaf("dcc:endPerformanceDate", day);
    xml_.leaf("dcc:performanceLocation", kind_of_place(), {{"refId", "place"}});
    if (!stated_.replaces.empty()) {
      xml_.element("dcc:previousReport",
                   [&] { referral("Replaced by this certificate", stated_.replaces); });
    }
  }

  /// One of the schema's words where the manifest uses it; the statement has the place itself.
  [[nodiscard]] std::string kind_of_place() const {
    for (const char* const kind :
         {"laboratory", "customer", "laboratoryBranch", "customerBranch"}) {
      if (stated_.place == kind) return kind;
    }
    return "other";
  }

  /// A certificate elsewhere, of which no copy is here to make a hash of.
  void referral(const std::string& what, const std::string& number) {
    own_text("dcc:referral", what);
    xml_.leaf("dcc:referralID", number);
    xml_.leaf("dcc:procedure", not_stated);
    xml_.leaf("dcc:value", not_stated);
  }

  void identification(const char* issuer, const std::string& value, const std::string& name) {
    xml_.element("dcc:identification", [&] {
      xml_.leaf("dcc:issuer", issuer);
      xml_.leaf("dcc:value", or_not_stated(value));
      own_text("dcc:name", name);
    });
  }

  void item() {
    const calibration::JointName& of = facts_.of;
    own_text("dcc:name",
             "Joint " + or_not_stated(of.joint) + " of the robot " + or_not_stated(of.robot));
    own_text("dcc:description",
             "Gear ratio n = motor angle / joint angle = " + shortest(facts_.gear_ratio));
    xml_.element("dcc:manufacturer", [&] { own_text("dcc:name", not_stated); });
    xml_.element("dcc:identifications", [&] {
      identification("manufacturer", of.serial, "Serial number");
      identification("customer", of.robot, "Robot");
      identification("customer", of.joint, "Joint");
    });
  }

  void contact(const std::string& name, const std::string& address, const std::string& country) {
    stated_text("dcc:name", name);
    xml_.leaf("dcc:eMail", not_stated);
    xml_.element("dcc:location", [&] {
      if (is_country(country)) xml_.leaf("dcc:countryCode", country);
      stated_text("dcc:further", address);
    });
  }

  void person(const std::string& name, const char* role, bool signs) {
    xml_.element("dcc:respPerson", [&] {
      xml_.element("dcc:person", [&] { stated_text("dcc:name", name); });
      xml_.leaf("dcc:role", role);
      xml_.leaf("dcc:mainSigner", signs ? "true" : "false");
    });
  }

  // What holds for the whole.

  /// What the program says.
  void statement(const char* id, const std::string& own,
                 const std::optional<std::string>& day = {}) {
    xml_.element("dcc:statement", {{"id", id}}, [&] {
      own_text("dcc:declaration", own);
      if (day) xml_.leaf("dcc:date", *day);
    });
  }

  /// What the manifest says, under a title: several contents would be one text in several
  /// languages.
  void stated(const char* id, const std::string& title, const std::string& text) {
    xml_.element("dcc:statement", {{"id", id}}, [&] { titled("dcc:declaration", title, text); });
  }
  void titled(const char* element, const std::string& title, const std::string& text) {
    xml_.element(element, [&] {
      own_text("dcc:name", title);
      content(text);
    });
  }

  void statements() {
    statement("scope",
              "The results relate only to the item described here, as it was when measured.");
    statement("verdict", "Verdict on the identification as a whole: " +
                             verdict_words(facts_.verdict) + ". " + facts_.sentence);
    statement(
        "uncertainty",
        "Uncertainties are expanded, for a coverage probability of 95 %, after JCGM 100 "
        "(GUM). Where an interval is not symmetric, both its ends are stated. Influences that "
        "are not stated are not included; each result names them.");
    if (joint_.is_in_amperes()) {
      statement("torqueConstant",
                "The torque constant is not stated: torques, and all results made of them, are "
                "stated as the current, in amperes.");
    }
    stated("decisionRule", "Decision rule", stated_.decision_rule);
    if (has_limits()) {
      statement("limits",
                "A limit is passed where a usable estimate and its 95 % interval keep it, failed "
                "where both break it, and not shown to be passed in all other cases.");
    }
    stated("measuredOn",
           day_of(facts_.measured_on) ? "Measured on"
                                      : "Measured on (" + no_day + " stands in place of the day)",
           facts_.measured_on);
    stated("receivedOn", "Item received on", stated_.received_on);
    statement("computedOn",
              "Day on which the results were computed. The day of issue is not stated.",
              day_of(facts_.created_utc));
    if (!is_country(stated_.country)) {
      statement("country", "Country of the laboratory: not stated (" + no_country +
                               " stands in place of its code)");
    }
    stated("place", "Place of the measurement", stated_.place);
    stated("adjustment", "Results before and after an adjustment", stated_.adjustment);
    statement("traceability",
              stated_.instruments.empty()
                  ? "Measuring equipment and metrological traceability: not stated"
                  : "Metrological traceability: as stated for each measuring equipment.");
    if (!facts_.note.empty()) stated("note", "Note on the measurement", facts_.note);
  }

  [[nodiscard]] bool has_limits() const {
    return std::any_of(evidence_.begin(), evidence_.end(),
                       [](const auto& one) { return !one.second.limits.empty(); });
  }

  // How it was measured.

  void measurement_result() {
    own_text("dcc:name", "Friction and gravity of a robot joint, identified from its logs");
    xml_.element("dcc:usedMethods", [&] { methods(); });
    xml_.element("dcc:usedSoftware", [&] {
      software(facts_.tool_version,
               "Identified the results; revision " + or_not_stated(facts_.git_revision) + ".");
    });
    if (!stated_.instruments.empty()) {
      xml_.element("dcc:measuringEquipments", [&] {
        for (const joint::Instrument& one : stated_.instruments) {
          xml_.element("dcc:measuringEquipment", [&] { equipment(one); });
        }
      });
    }
    xml_.element("dcc:influenceConditions", [&] { conditions(); });
    xml_.element("dcc:results", [&] { results(); });
  }

  void methods() {
    xml_.element("dcc:usedMethod", [&] {
      own_text("dcc:name", paper_title);
      own_text("dcc:description",
               "Identification after this paper, as tribolog " +
                   or_not_stated(facts_.tool_version) +
                   " computes it, with estimates of its own beside the paper's.");
      xml_.leaf("dcc:reference", paper_title);
    });
    xml_.element("dcc:usedMethod", [&] {
      own_text("dcc:name", "Evaluation of the measurement uncertainty");
      xml_.leaf("dcc:norm", "JCGM 100:2008");
    });
    if (stated_.procedure.empty()) return;
    xml_.element("dcc:usedMethod", [&] {
      own_text("dcc:name", "Procedure of the laboratory");
      stated_text("dcc:description", stated_.procedure);
    });
  }

  void equipment(const joint::Instrument& one) {
    stated_text("dcc:name", one.name);
    titled("dcc:description", "Used for", one.used_for);
    xml_.element("dcc:certificate",
                 [&] { referral("Traceability", or_not_stated(one.traceability)); });
    xml_.element("dcc:identifications", [&] {
      identification("other", one.identification, "Serial or inventory number");
    });
  }

  void condition(const std::string& name, const std::optional<double>& number, const char* unit) {
    xml_.element("dcc:influenceCondition", [&] {
      own_text("dcc:name", name);
      xml_.element("dcc:data", [&] {
        xml_.element("dcc:quantity", [&] {
          if (!number) {
            own_text("dcc:noQuantity", not_stated);
            return;
          }
          xml_.element("si:real", [&] {
            xml_.leaf("si:value", shortest(*number));
            xml_.leaf("si:unit", unit);
          });
        });
      });
    });
  }

  void condition(const std::string& name, const std::string& words) {
    if (words.empty()) return;
    xml_.element("dcc:influenceCondition", [&] {
      own_text("dcc:name", name);
      xml_.element("dcc:data", [&] { stated_text("dcc:text", words); });
    });
  }

  void conditions() {
    condition("Temperature", facts_.temperature_C, R"(\degreecelsius)");
    condition("Relative humidity of the air", stated_.humidity_percent, R"(\percent)");
    condition("Mass of the payload", facts_.payload_kg, R"(\kilogram)");
    if (facts_.payload_distance_m) {
      condition("Distance of the payload from the joint's axis", facts_.payload_distance_m,
                R"(\metre)");
    }
    condition("Payload", facts_.payload);
    condition("Further conditions", stated_.conditions);
  }

  // The results.

  const calibration::RecordedEvidence& evidence_of(const std::string& quantity) const {
    static const calibration::RecordedEvidence none;
    const auto found = evidence_.find(quantity);
    return found == evidence_.end() ? none : found->second;
  }

  void results() {
    for (const calibration::Quantity& quantity : joint_.quantities) {
      result(quantity, evidence_of(quantity.name));
    }
    if (!joint_.quantities.empty()) return;
    xml_.element("dcc:result", [&] {
      own_text("dcc:name", "None");
      xml_.element("dcc:data", [&] { own_text("dcc:text", "Nothing was identified."); });
    });
  }

  /// Known names alone: a type may hold no blank.
  static Attributes type_of(const calibration::Quantity& quantity) {
    if (!joint::quantity_of(quantity.name)) return {};
    return {{"refType", "tribolog_" + quantity.name}};
  }

  void result(const calibration::Quantity& quantity,
              const calibration::RecordedEvidence& evidence) {
    xml_.element("dcc:result", type_of(quantity), [&] {
      own_text("dcc:name", wording::capitalised(calibration::without_side(quantity.words)));
      xml_.element("dcc:description", [&] {
        std::string words = verdict_words(quantity.verdict);
        if (!evidence.reasons.empty()) words += ": " + evidence.reasons.front();
        own_content(words);
      });
      xml_.element("dcc:data", [&] {
        if (quantity.unit.empty()) {
          friction_curve(quantity);
          return;
        }
        const int power = calibration::gear_power(quantity.name).value_or(0);
        const bool is_of_joint_alone = calibration::gear_power(quantity.name) == 0;
        const bool has_two_sides = power != 0 && facts_.gear_ratio != 1;
        using joint::Side;
        sided(quantity, evidence, is_of_joint_alone ? Side::joint : Side::motor, 0, !has_two_sides);
        if (has_two_sides) sided(quantity, evidence, Side::joint, power, false);
      });
    });
  }

  void friction_curve(const calibration::Quantity& quantity) {
    const bool is_identified = quantity.verdict != calibration::Verdict::not_identifiable;
    const calibration::RecordedEvidence& coulomb = evidence_of("coulomb_torque");
    const CertifiedCurve at_motor = certified_curve(joint_, coulomb, 0);
    if (!is_identified || at_motor.speed_rad_s.empty()) {
      own_text("dcc:text", is_identified ? "No friction curve is recorded." : "not identifiable");
      return;
    }
    curve_of_side(quantity, at_motor, joint::Side::motor);
    if (facts_.gear_ratio == 1) return;
    curve_of_side(quantity, certified_curve(joint_, coulomb, 1), joint::Side::joint);
  }

  void curve_of_side(const calibration::Quantity& quantity, const CertifiedCurve& curve,
                     joint::Side side) {
    const std::string where = joint::to_string(side);
    const std::string verdict = calibration::to_string(quantity.verdict);
    xml_.element("dcc:list", {{"refType", "tribolog_" + where + "Side tribolog_" + verdict}}, [&] {
      own_text("dcc:name", "Friction torque over speed at the " + where);
      own_text("dcc:description", description(curve));
      xml_.element("dcc:quantity", {{"refType", "tribolog_speed"}}, [&] {
        own_text("dcc:name", "Speed of the " + where + ", with its sign");
        xml_.element("si:realListXMLList", [&] {
          numbers("si:valueXMLList", curve.speed_rad_s);
          xml_.leaf("si:unitXMLList", si_unit("rad/s"));
        });
      });
      xml_.element("dcc:quantity", {{"refType", "tribolog_frictionTorque"}}, [&] {
        own_text("dcc:name", "Friction torque at the " + where + ", with the speed's sign");
        xml_.element("si:realListXMLList", [&] { torques(curve); });
      });
    });
  }

  static std::string description(const CertifiedCurve& curve) {
    std::string words = curve.from_sweep
                            ? "Each point is the mean of a part of a slow sweep, less gravity."
                            : "Each point is the mean of a run at constant speed, less gravity.";
    if (curve.expanded_Nm.empty()) return words + " Its uncertainty is not stated.";
    words += curve.holds_gravity
                 ? " The error of the gravity torque is included; all points have it in common."
                 : " The error of the gravity torque is not included.";
    return words + left_out_words(curve.left_out);
  }

  void torques(const CertifiedCurve& curve) {
    numbers("si:valueXMLList", curve.friction_Nm);
    xml_.leaf("si:unitXMLList", si_unit(joint_.is_in_amperes() ? "A" : "N·m"));
    if (curve.expanded_Nm.empty()) return;
    constexpr double normal = std::numeric_limits<double>::infinity();
    xml_.element("si:expandedUncXMLList", [&] {
      numbers("si:uncertaintyXMLList", curve.expanded_Nm);
      xml_.leaf("si:coverageFactorXMLList", shortest(calibration::coverage_factor(normal)));
      xml_.leaf("si:coverageProbabilityXMLList", "0.95");
      xml_.leaf("si:distributionXMLList", "normal");
    });
  }

  void numbers(const char* element, const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : " ") + shortest(value);
    xml_.leaf(element, text);
  }

  static std::string left_out_words(const std::vector<calibration::Influence>& influences) {
    std::vector<std::string> names;
    for (const calibration::Influence influence : influences) {
      names.push_back(wording::words_for("influence", to_string(influence)));
    }
    return names.empty() ? "" : " Not stated and not included: " + wording::listed(names) + ".";
  }

  /// @param is_only_one: all limits of the quantity are of it.
  void sided(const calibration::Quantity& quantity, const calibration::RecordedEvidence& evidence,
             joint::Side side, int gear_power, bool is_only_one) {
    const std::string unit = si_unit(quantity.unit);
    const bool has_number = quantity.estimate && !unit.empty() &&
                            quantity.verdict != calibration::Verdict::not_identifiable;
    std::string verdict = calibration::to_string(quantity.verdict);
    xml_.element(
        "dcc:quantity",
        {{"refType", "tribolog_" + joint::to_string(side) + "Side tribolog_" + verdict}}, [&] {
          own_text("dcc:name", wording::capitalised(calibration::without_side(quantity.words)) +
                                   " at the " + joint::to_string(side));
          if (!has_number) {
            own_text("dcc:noQuantity", why_no_number(quantity, evidence));
            return;
          }
          const Measurement m = measured(quantity, gear_power, facts_.gear_ratio, evidence);
          own_text("dcc:description", description(quantity, evidence, gear_power, m));
          xml_.element("si:real", [&] { real(m, unit); });
          limits(quantity, evidence, side, is_only_one);
        });
  }

  static std::string why_no_number(const calibration::Quantity& quantity,
                                   const calibration::RecordedEvidence& evidence) {
    std::string words = quantity.verdict == calibration::Verdict::not_identifiable
                            ? "not identifiable"
                            : "no number in a unit of the SI";
    if (!evidence.reasons.empty()) words += ": " + evidence.reasons.front();
    return words;
  }

  static std::string description(const calibration::Quantity& quantity,
                                 const calibration::RecordedEvidence& evidence, int gear_power,
                                 const Measurement& m) {
    std::string words = wording::capitalised(verdict_words(quantity.verdict));
    if (quantity.verdict != calibration::Verdict::usable && !evidence.reasons.empty()) {
      words += ": " + evidence.reasons.front();
    }
    words += ". Number: " + calibration::conversion_words(gear_power) + ".";
    if (m.freedom) words += fmt::format(" Effective degrees of freedom: {:.1f}.", *m.freedom);
    if (has_no_uncertainty(m)) {
      words += " Its uncertainty is not stated.";
    } else if (!m.factor) {
      words +=
          " No budget is recorded: the standard uncertainty is the half width of the interval "
          "over 1.96.";
    }
    return words + left_out_words(m.left_out);
  }

  void real(const Measurement& m, const std::string& unit) {
    xml_.leaf("si:value", shortest(m.estimate.value));
    xml_.leaf("si:unit", unit);
    if (has_no_uncertainty(m)) return;
    if (has_expanded_uncertainty(m)) {
      xml_.element("si:expandedUnc", [&] {
        xml_.leaf("si:uncertainty", shortest(m.estimate.half_width()));
        xml_.leaf("si:coverageFactor", shortest(present(m.factor)));
        xml_.leaf("si:coverageProbability", "0.95");
        xml_.leaf("si:distribution", m.is_normal ? "normal" : "t");
      });
      return;
    }
    xml_.element("si:coverageInterval", [&] {
      xml_.leaf("si:standardUnc", shortest(m.standard_uncertainty));
      xml_.leaf("si:intervalMin", shortest(m.estimate.low));
      xml_.leaf("si:intervalMax", shortest(m.estimate.high));
      xml_.leaf("si:coverageProbability", "0.95");
    });
  }

  /// A limit is passed by a usable number alone.
  static const char* conformity(calibration::LimitState state, calibration::Verdict verdict) {
    if (state == calibration::LimitState::outside) return "fail";
    const bool is_passed =
        state == calibration::LimitState::inside && verdict == calibration::Verdict::usable;
    return is_passed ? "pass" : "noPass";
  }

  void limits(const calibration::Quantity& quantity, const calibration::RecordedEvidence& evidence,
              joint::Side side, bool is_only_one) {
    std::vector<const calibration::RecordedLimit*> of_side;
    for (const calibration::RecordedLimit& limit : evidence.limits) {
      if (is_only_one || limit.at_joint == (side == joint::Side::joint)) of_side.push_back(&limit);
    }
    if (of_side.empty()) return;
    xml_.element("dcc:measurementMetaData", [&] {
      for (const calibration::RecordedLimit* limit : of_side) {
        xml_.element("dcc:metaData", [&] {
          own_text("dcc:declaration", limit->words);
          xml_.leaf("dcc:conformity", conformity(limit->state, quantity.verdict));
        });
      }
    });
  }

  const ArchivedJoint& joint_;
  const calibration::Facts& facts_;
  joint::Certificate stated_;
  std::map<std::string, calibration::RecordedEvidence> evidence_;
  XmlWriter xml_;
};

}  // namespace

std::string digital_certificate(const ArchivedJoint& joint) {
  if (joint.calibration.empty()) {
    throw UsageError(joint.entry.id.substr(0, calibration::shown_digits) +
                     ": not exported: its calibration's file is not archived");
  }
  const wording::WordsIn english({});
  return Certificate(joint).document();
}

}  // namespace tribolog::exports::results
