// Rows that tables of estimates are made of.

#include <algorithm>
#include <cmath>

#include "calibration/headline.h"
#include "report/document/view_parts.h"
#include "report/elements/result_words.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

namespace {

using joint::Quantity;
using method::gravity::PeakSource;
using method::hysteresis::Estimator;
using method::hysteresis::LuGreParameterName;
using wording::tr;

}  // namespace

Table estimates_table(const std::string& id, const std::string& caption) {
  Table table;
  table.id = id;
  table.caption = caption;
  table.columns = {{tr("Quantity"), "", false, true},
                   {tr("Estimate"), "", true},
                   {tr("Unit"), "", false},
                   {tr("95 % interval"), "", true},
                   {tr("From"), "", false}};
  table.is_of_estimates = true;
  return table;
}

Row estimate_row(const std::string& quantity, const statistics::Estimate& estimate,
                 const wording::Scale& scale) {
  if (!std::isfinite(estimate.value)) {
    return not_identified_row(quantity, wording::words(estimate.method));
  }
  const wording::RoundedEstimate text = wording::round_by_interval(estimate, scale);
  return {{quantity, text.plus_minus(), wording::or_dash(scale.unit),
           wording::or_dash(text.range()), wording::or_dash(wording::words(estimate.method))},
          false};
}

Row number_row(const std::string& quantity, double value, const wording::Scale& scale,
               const std::string& from) {
  if (!std::isfinite(value)) return not_identified_row(quantity, from);
  constexpr int digits = 4;
  return {{quantity, wording::significant(value * scale.factor, digits),
           wording::or_dash(scale.unit), "–", wording::or_dash(from)},
          false};
}

Row not_identified_row(const std::string& quantity, const std::string& why) {
  return {{quantity, tr("not identified"), "–", "–", wording::or_dash(why)}, false};
}

std::string at_motor(const std::string& quantity, double gear_ratio) {
  if (gear_ratio == 1.0) return quantity;
  return tr("{quantity}, at the motor", {{"quantity", quantity}});
}

std::string at_joint(const std::string& quantity, double gear_ratio) {
  if (gear_ratio == 1.0) return quantity;
  return tr("{quantity}, at the joint", {{"quantity", quantity}});
}

void add_both_sides(const std::string& quantity, const statistics::Estimate& motor,
                    const Gear& gear, wording::Scale (*scale_for)(double), Table& table) {
  add_both_sides(quantity, motor, statistics::scaled(motor, gear.to_joint), gear.ratio, scale_for,
                 table);
}

void add_both_sides(const std::string& quantity, const statistics::Estimate& motor,
                    const statistics::Estimate& joint, double gear_ratio,
                    wording::Scale (*scale_for)(double), Table& table) {
  table.rows.push_back(estimate_row(at_motor(quantity, gear_ratio), motor, scale_for(motor.value)));
  if (gear_ratio == 1.0) return;
  table.rows.push_back(estimate_row(at_joint(quantity, gear_ratio), joint, scale_for(joint.value)));
}

const method::hysteresis::SurrogateMass* recommended_mass(const calibration::Calibration& c) {
  return c.masses.find(c.selection.recommended);
}

// The first table of the report: what the reader came for.

namespace {

class KeyNumbers {
 public:
  explicit KeyNumbers(const calibration::Calibration& calibration)
      : c_(calibration), n_(calibration.manifest.drive.gear_ratio()) {
    table_ = estimates_table("table-key-numbers", tr("Key numbers with 95 % intervals"));
    table_.note =
        n_ == 1.0 ? tr("Gear ratio 1: motor side and joint side are the same.")
                  : tr("At the joint, torques are n times and viscous coefficients and stiffnesses "
                       "n² times those at the motor; n = {gear_ratio}.",
                       {{"gear_ratio", wording::as_stated(n_)}});
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
    e = expanded(Quantity::cog_angle, e);
    e.method = Statement::verbatim(from);
    table_.rows.push_back(estimate_row(quantity, e, wording::degree_scale()));
    table_.rows.push_back(estimate_row(quantity, e, wording::radian_scale(e.value)));
  }

  /// With what the manifest states of other errors. @param gear_power of the ratio by which the
  /// side shown is multiplied.
  [[nodiscard]] statistics::Estimate expanded(Quantity quantity, const statistics::Estimate& e,
                                              int gear_power = 0) const {
    const calibration::QuantityVerdict* verdict = c_.judgement.find(quantity);
    const bool is_its_own = verdict != nullptr && verdict->budget && verdict->estimate &&
                            verdict->estimate->value == e.value;
    return is_its_own ? calibration::expanded_at(*verdict->budget, *verdict->estimate, gear_power)
                      : e;
  }

  /// One row per side: at the joint it is larger by the gear ratio to `gear_power`.
  void sides(const std::string& name, Quantity quantity, const statistics::Estimate& motor,
             int gear_power, wording::Scale (*scale_for)(double), const std::string& from) {
    const auto stated = [&](int power) {
      statistics::Estimate e =
          statistics::scaled(expanded(quantity, motor, power), std::pow(n_, power));
      e.method = Statement::verbatim(from);
      return e;
    };
    add_both_sides(name, stated(0), stated(gear_power), n_, scale_for, table_);
  }

  void missing(const std::string& quantity, StageId stage) {
    const statistics::StageReport& report = stage_report(c_, stage);
    table_.rows.push_back(not_identified_row(
        quantity, tr("stage {stage}: {status}",
                     {{"stage", stage_number(stage)}, {"status", status_in_words(report.state)}})));
  }

  void angles() {
    const std::string peak = tr("Joint angle of largest gravity torque, q_peak");
    if (c_.q_peak_rad && refused(Quantity::cog_angle)) {
      see_the_verdict(peak);
      return;
    }
    if (c_.q_peak_rad) {
      if (c_.q_peak_source == PeakSource::model) {
        angle(peak, *c_.q_peak_rad, tr("model of sweeps and runs"));
        link_angle();
        return;
      }
      angle(peak, *c_.q_peak_rad,
            c_.q_peak_source == PeakSource::precise_sweep
                ? tr("stage {stage}, fit of the precise sweep",
                     {{"stage", stage_number(StageId::cog_precise)}})
                : tr("stage {stage}, fit of the rough sweep",
                     {{"stage", stage_number(StageId::cog_rough)}}));
    } else {
      missing(peak, StageId::cog_rough);
    }
    link_angle();
  }

  void link_angle() {
    const std::string link = tr("Link angle of the centre of gravity, q_c = −q_peak");
    const bool is_corrected = c_.selection.q_c_rad && c_.q_peak_rad &&
                              c_.selection.q_c_rad->value != -c_.q_peak_rad->value;
    if (is_corrected) {
      angle(link, *c_.selection.q_c_rad, stage_reference(StageId::selection));
    } else if (c_.q_peak_rad) {
      angle(link, statistics::scaled(expanded(Quantity::cog_angle, *c_.q_peak_rad), -1.0),
            "−q_peak");
    }
  }

  void gravity() {
    const std::string name = tr("Gravity torque");
    if (refused(Quantity::gravity_torque) && recommended_mass(c_) != nullptr) {
      see_the_verdict(name);
    } else if (const method::hysteresis::SurrogateMass* mass = recommended_mass(c_)) {
      sides(name, Quantity::gravity_torque, mass->gravity_Nm, 1, wording::torque_scale,
            from_mass(*mass));
    } else if (c_.rough.found) {
      sides(name, Quantity::gravity_torque, c_.rough.gravity_Nm, 1, wording::torque_scale,
            stage_reference(StageId::cog_rough));
    } else {
      missing(name, StageId::surrogate_masses);
    }
  }

  void masses() {
    const std::string r =
        wording::with_unit(wording::as_stated(c_.manifest.surrogate_distance_m), "m");
    const std::string name = tr("Surrogate mass at r = {distance}", {{"distance", r}});
    if (refused(Quantity::surrogate_mass) && recommended_mass(c_) != nullptr) {
      see_the_verdict(name);
      return;
    }
    if (const method::hysteresis::SurrogateMass* mass = recommended_mass(c_)) {
      mass_row(tr("Surrogate mass at r = {distance}, recommended", {{"distance", r}}), *mass, true);
    } else {
      missing(name, StageId::surrogate_masses);
    }
    const method::hysteresis::SurrogateMass* papers = c_.masses.find(c_.selection.paper_rule);
    if (papers != nullptr) {
      mass_row(tr("Surrogate mass at r = {distance}, by the paper's rule", {{"distance", r}}),
               *papers, false);
    }
  }

  static std::string from_mass(const method::hysteresis::SurrogateMass& mass) {
    return tr("stage {stage}, {estimator}",
              {{"stage", stage_number(StageId::surrogate_masses)},
               {"estimator", elements::estimator_name(mass.estimator)}});
  }

  void mass_row(const std::string& quantity, const method::hysteresis::SurrogateMass& mass,
                bool is_chosen) {
    statistics::Estimate e = expanded(Quantity::surrogate_mass, mass.mass_kg);
    e.method = Statement::verbatim(from_mass(mass));
    table_.rows.push_back(estimate_row(quantity, e, wording::plain_scale("kg")));
    table_.rows.back().is_chosen = is_chosen;
  }

  void friction() {
    const method::hysteresis::HysteresisResult& loop = c_.hysteresis;
    const auto shown = [&](LuGreParameterName name) {
      return c_.lugre ? c_.lugre->shown(name) : std::nullopt;
    };
    const std::string from_loop =
        tr("stage {stage}, LuGre fit of the loops", {{"stage", stage_number(StageId::parameters)}});
    const std::string break_away = tr("Break-away torque");
    const auto level = shown(LuGreParameterName::static_torque);
    if (refused(Quantity::break_away_torque) && (level || c_.break_away.mean_Nm)) {
      see_the_verdict(break_away);
    } else if (c_.break_away.mean_Nm) {
      sides(break_away, Quantity::break_away_torque, *c_.break_away.mean_Nm, 1,
            wording::torque_scale,
            tr("stage {stage}, torque ramps", {{"stage", stage_number(StageId::break_away)}}));
    } else if (level) {
      sides(break_away, Quantity::break_away_torque, *level, 1, wording::torque_scale, from_loop);
    } else if (!c_.break_away.ramps.empty()) {
      see_the_verdict(break_away);
    } else {
      missing(break_away, StageId::hysteresis);
    }
    coulomb_and_viscous();
    if (loop.found && std::isfinite(loop.loop_height_Nm)) loop_height(loop.loop_height_Nm);
    const auto stiffness = shown(LuGreParameterName::bristle_stiffness);
    const std::string name = tr("Bristle stiffness σ₀");
    if (refused(Quantity::bristle_stiffness) && stiffness) {
      see_the_verdict(name);
    } else if (stiffness) {
      sides(name, Quantity::bristle_stiffness, *stiffness, 2, wording::stiffness_scale, from_loop);
    }
  }

  void loop_height(double height_Nm) {
    const std::string from = stage_reference(StageId::hysteresis);
    const std::string name = tr("Height of the hysteresis loop");
    table_.rows.push_back(
        number_row(at_motor(name, n_), height_Nm, wording::torque_scale(height_Nm), from));
    if (n_ == 1.0) return;
    table_.rows.push_back(number_row(at_joint(name, n_), n_ * height_Nm,
                                     wording::torque_scale(n_ * height_Nm), from));
  }

  /// A number that its verdict refuses is not to be filed.
  [[nodiscard]] bool refused(Quantity quantity) const {
    const calibration::QuantityVerdict* verdict = c_.judgement.find(quantity);
    return verdict != nullptr && verdict->verdict == calibration::Verdict::not_identifiable;
  }

  void see_the_verdict(const std::string& quantity) {
    table_.rows.push_back(not_identified_row(quantity, tr("see the verdict on it")));
  }

  [[nodiscard]] static std::string source_of(const calibration::CurveHeadline& headline) {
    using calibration::HeadlineSource;
    if (headline.source == HeadlineSource::sweep) {
      return tr("stage {stage}, sweep", {{"stage", stage_number(StageId::cog_rough)}});
    }
    if (headline.source == HeadlineSource::loops) {
      return tr("stage {stage}, loops", {{"stage", stage_number(StageId::parameters)}});
    }
    if (headline.source == HeadlineSource::model) return tr("one model of all recordings");
    const int stage = stage_number(StageId::parameters);
    return tr("stage {stage}, straight line", {{"stage", stage}});
  }

  void coulomb_and_viscous() {
    const calibration::CurveHeadline headline = calibration::curve_headline(c_);
    const auto& coulomb_Nm = headline.coulomb_Nm.estimate;
    const auto& viscous_Nms_rad = headline.viscous_Nms_rad.estimate;
    const std::string from = source_of(headline);
    const std::string coulomb = tr("Coulomb torque");
    const bool has_law = headline.source == calibration::HeadlineSource::model;
    if (refused(Quantity::coulomb_torque) && (coulomb_Nm || has_law)) {
      see_the_verdict(coulomb);
    } else if (coulomb_Nm) {
      sides(coulomb, Quantity::coulomb_torque, *coulomb_Nm, 1, wording::torque_scale, from);
    } else {
      missing(coulomb, StageId::parameters);
    }
    const std::string viscous = tr("Viscous coefficient");
    if (refused(Quantity::viscous_coefficient) && viscous_Nms_rad) {
      see_the_verdict(viscous);
    } else if (viscous_Nms_rad) {
      sides(viscous, Quantity::viscous_coefficient, *viscous_Nms_rad, 2, wording::viscous_scale,
            from);
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

}  // namespace tribolog::report::document
