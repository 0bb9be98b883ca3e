// Rows that tables of estimates are made of.

#include <algorithm>
#include <cmath>

#include "report/view_parts.h"
#include "wording/units.h"
#include "wording/words.h"

namespace tribolog::report {

std::string or_dash(const std::string& text) { return text.empty() ? "–" : text; }

std::string as_sentence(const std::string& text) {
  if (text.empty()) return text;
  const std::string first_word = text.substr(0, text.find(' '));
  const bool is_symbol =
      (first_word.size() == 1 && first_word != "a") || first_word.find('_') != std::string::npos;
  std::string sentence = text;
  if (!is_symbol && sentence.front() >= 'a' && sentence.front() <= 'z') {
    sentence.front() = static_cast<char>(sentence.front() - 'a' + 'A');
  }
  const char last = sentence.back();
  return last == '.' || last == '!' || last == '?' || last == ':' ? sentence : sentence + ".";
}

std::string as_sentence(const Statement& statement) {
  return as_sentence(wording::words(statement));
}

std::vector<Column> estimate_columns() {
  return {{"Quantity", "", false, true},
          {"Estimate", "", true},
          {"Unit", "", false},
          {"95 % interval", "", true},
          {"From", "", false}};
}

Row estimate_row(const std::string& quantity, const statistics::Estimate& estimate,
                 const wording::Scale& scale) {
  if (!std::isfinite(estimate.value)) {
    return not_identified_row(quantity, wording::words(estimate.method));
  }
  const wording::RoundedEstimate text = wording::round_by_interval(estimate, scale);
  return {{quantity, text.plus_minus(), or_dash(scale.unit), or_dash(text.range()),
           or_dash(wording::words(estimate.method))},
          false};
}

Row number_row(const std::string& quantity, double value, const wording::Scale& scale,
               const std::string& from) {
  if (!std::isfinite(value)) return not_identified_row(quantity, from);
  constexpr int digits = 4;
  return {{quantity, wording::significant(value * scale.factor, digits), or_dash(scale.unit), "–",
           or_dash(from)},
          false};
}

Row not_identified_row(const std::string& quantity, const std::string& why) {
  return {{quantity, "not identified", "–", "–", or_dash(why)}, false};
}

std::string estimator_name(const std::string& estimator) {
  if (estimator.size() == 1) return "Point " + estimator;
  if (estimator.size() == 2) {
    return std::string("Mean of ") + estimator.front() + " and " + estimator.back();
  }
  if (estimator == "midline") return "Mid-line";
  if (estimator == "fit") return "LuGre fit";
  if (estimator == "sweep") return "Sweep";
  if (estimator == "runs") return "Runs at constant speed";
  if (estimator == "stated") return "Stated";
  return estimator;
}

const method::hysteresis::SurrogateMass* recommended_mass(const calibration::Calibration& c) {
  return c.selection.recommended.empty() ? nullptr : c.masses.find(c.selection.recommended);
}

// The first table of the report: what the reader came for.

namespace {

class KeyNumbers {
 public:
  explicit KeyNumbers(const calibration::Calibration& calibration)
      : c_(calibration), n_(calibration.manifest.drive.gear_ratio()) {
    table_.id = "table-key-numbers";
    table_.caption = "Key numbers with 95 % intervals";
    table_.columns = estimate_columns();
    table_.note =
        n_ == 1.0 ? "Gear ratio 1: motor side and joint side are the same."
                  : "At the joint, torques are n times and viscous coefficients and stiffnesses "
                    "n² times those at the motor; n = " +
                        wording::as_stated(n_) + ".";
  }

  Table make() {
    angles();
    gravity();
    masses();
    friction();
    return table_;
  }

 private:
  void angle(const std::string& quantity, statistics::Estimate e, const std::string& from) {
    e.method = Statement::verbatim(from);
    table_.rows.push_back(estimate_row(quantity, e, wording::degree_scale()));
    table_.rows.push_back(estimate_row(quantity, e, wording::radian_scale(e.value)));
  }

  /// One row per side; `to_joint` is the factor from motor to joint.
  void sides(const std::string& quantity, statistics::Estimate motor, double to_joint,
             wording::Scale (*scale_for)(double), const std::string& from) {
    motor.method = Statement::verbatim(from);
    const std::string at_motor = n_ == 1.0 ? "" : ", at the motor";
    table_.rows.push_back(estimate_row(quantity + at_motor, motor, scale_for(motor.value)));
    if (n_ == 1.0) return;
    const statistics::Estimate joint = statistics::scaled(motor, to_joint);
    table_.rows.push_back(estimate_row(quantity + ", at the joint", joint, scale_for(joint.value)));
  }

  void missing(const std::string& quantity, StageId stage) {
    const statistics::StageReport& report = stage_report(c_, stage);
    table_.rows.push_back(not_identified_row(
        quantity, stage_reference(stage) + ": " + status_in_words(report.state)));
  }

  void angles() {
    const char* const peak = "Joint angle of largest gravity torque, q_peak";
    if (c_.q_peak_rad && refused("cog_angle")) {
      see_the_verdict(peak);
      return;
    }
    if (c_.q_peak_rad) {
      if (c_.q_peak_source == "runs") {
        angle(peak, *c_.q_peak_rad,
              stage_reference(StageId::viscous_curves) + ", fit of the runs at constant speed");
        link_angle();
        return;
      }
      const bool precise = c_.q_peak_source == "cog_precise";
      const StageId stage = precise ? StageId::cog_precise : StageId::cog_rough;
      angle(peak, *c_.q_peak_rad,
            stage_reference(stage) + ", fit of the " + (precise ? "precise" : "rough") + " sweep");
    } else {
      missing(peak, StageId::cog_rough);
    }
    link_angle();
  }

  void link_angle() {
    const char* const link = "Link angle of the centre of gravity, q_c = −q_peak";
    if (c_.selection.q_c_rad) {
      angle(link, *c_.selection.q_c_rad, stage_reference(StageId::selection));
    } else if (c_.q_peak_rad) {
      angle(link, statistics::scaled(*c_.q_peak_rad, -1.0), "−q_peak");
    }
  }

  void gravity() {
    const char* const name = "Gravity torque";
    if (refused("gravity_torque") && recommended_mass(c_) != nullptr) {
      see_the_verdict(name);
    } else if (const method::hysteresis::SurrogateMass* mass = recommended_mass(c_)) {
      sides(name, mass->gravity_Nm, n_, wording::torque_scale,
            stage_reference(StageId::surrogate_masses) + ", " + estimator_name(mass->estimator));
    } else if (c_.rough.found) {
      sides(name, c_.rough.gravity_Nm, n_, wording::torque_scale,
            stage_reference(StageId::cog_rough));
    } else {
      missing(name, StageId::surrogate_masses);
    }
  }

  void masses() {
    const std::string at =
        " at r = " + wording::as_stated(c_.manifest.surrogate_distance_m) + "\u00a0m";
    if (refused("surrogate_mass") && recommended_mass(c_) != nullptr) {
      see_the_verdict("Surrogate mass" + at);
      return;
    }
    if (const method::hysteresis::SurrogateMass* mass = recommended_mass(c_)) {
      mass_row("Surrogate mass" + at + ", recommended", *mass, true);
    } else {
      missing("Surrogate mass" + at, StageId::surrogate_masses);
    }
    const method::hysteresis::SurrogateMass* papers =
        c_.selection.paper_rule.empty() ? nullptr : c_.masses.find(c_.selection.paper_rule);
    if (papers != nullptr)
      mass_row("Surrogate mass" + at + ", by the paper's rule", *papers, false);
  }

  void mass_row(const std::string& quantity, const method::hysteresis::SurrogateMass& mass,
                bool is_chosen) {
    statistics::Estimate e = mass.mass_kg;
    e.method = Statement::verbatim(stage_reference(StageId::surrogate_masses) + ", " +
                                   estimator_name(mass.estimator));
    table_.rows.push_back(estimate_row(quantity, e, wording::plain_scale("kg")));
    table_.rows.back().is_chosen = is_chosen;
  }

  void friction() {
    const method::hysteresis::HysteresisResult& loop = c_.hysteresis;
    const auto shown = [&](const char* name) {
      return loop.lugre ? loop.lugre->shown(name) : std::nullopt;
    };
    const std::string from_loop = stage_reference(StageId::parameters) + ", LuGre fit of the loops";
    const auto level = shown("static_Nm");
    if (refused("break_away_torque") && (level || c_.break_away.mean_Nm)) {
      see_the_verdict("Break-away torque");
    } else if (c_.break_away.mean_Nm) {
      sides("Break-away torque", *c_.break_away.mean_Nm, n_, wording::torque_scale,
            stage_reference(StageId::break_away) + ", ramps of the torque");
    } else if (level) {
      sides("Break-away torque", *level, n_, wording::torque_scale, from_loop);
    } else if (!c_.break_away.ramps.empty()) {
      see_the_verdict("Break-away torque");
    } else {
      missing("Break-away torque", StageId::hysteresis);
    }
    coulomb_and_viscous();
    if (loop.found && std::isfinite(loop.loop_height_Nm)) {
      const double height = loop.loop_height_Nm;
      const std::string from = stage_reference(StageId::hysteresis);
      const std::string name = "Height of the hysteresis loop";
      table_.rows.push_back(number_row(n_ == 1.0 ? name : name + ", at the motor", height,
                                       wording::torque_scale(height), from));
      if (n_ != 1.0) {
        table_.rows.push_back(number_row(name + ", at the joint", n_ * height,
                                         wording::torque_scale(n_ * height), from));
      }
    }
    const auto stiffness = shown("bristle_stiffness_Nm_rad");
    if (refused("bristle_stiffness") && stiffness) {
      see_the_verdict("Bristle stiffness σ₀");
    } else if (stiffness) {
      sides("Bristle stiffness σ₀", *stiffness, n_ * n_, wording::stiffness_scale, from_loop);
    }
  }

  /// A number that its verdict refuses is none to file.
  [[nodiscard]] bool refused(const std::string& key) const {
    const auto& all = c_.judgement.quantities;
    return std::any_of(all.begin(), all.end(), [&](const calibration::QuantityVerdict& q) {
      return q.key == key && q.verdict == calibration::Verdict::not_identifiable;
    });
  }

  void see_the_verdict(const std::string& quantity) {
    table_.rows.push_back(not_identified_row(quantity, "see the verdict on it"));
  }

  void coulomb_and_viscous() {
    const auto& line = c_.friction.coulomb_viscous;
    const std::string from_line = stage_reference(StageId::parameters) + ", straight line";
    const std::string from_sweep = stage_reference(StageId::cog_rough) + ", sweep";
    const char* const coulomb = "Coulomb torque";
    if (refused("coulomb_torque") && (line || c_.rough.coulomb_Nm)) {
      see_the_verdict(coulomb);
    } else if (line) {
      sides(coulomb, line->coulomb_Nm, n_, wording::torque_scale, from_line);
    } else if (c_.rough.coulomb_Nm) {
      sides(coulomb, *c_.rough.coulomb_Nm, n_, wording::torque_scale, from_sweep);
    } else {
      missing(coulomb, StageId::parameters);
    }
    const char* const viscous = "Viscous coefficient";
    if (refused("viscous_coefficient") && (line || c_.rough.viscous_Nms_rad)) {
      see_the_verdict(viscous);
    } else if (line) {
      sides(viscous, line->viscous_Nms_rad, n_ * n_, wording::viscous_scale, from_line);
    } else if (c_.rough.viscous_Nms_rad) {
      sides(viscous, *c_.rough.viscous_Nms_rad, n_ * n_, wording::viscous_scale, from_sweep);
    } else {
      missing(viscous, StageId::parameters);
    }
  }

  const calibration::Calibration& c_;
  double n_;
  Table table_;
};

}  // namespace

Table key_numbers_table(const calibration::Calibration& calibration) {
  return KeyNumbers(calibration).make();
}

}  // namespace tribolog::report
