// Stages 1 and 2.

#include <limits>
#include <utility>

#include "calibration/parts.h"
#include "wording/words.h"

namespace tribolog::calibration {

void state_cog(Fields& f, const method::gravity::CogSweepResult& r, double gear_ratio) {
  const auto if_found = [&r](double value) {
    return r.found ? value : std::numeric_limits<double>::quiet_NaN();
  };
  const auto known = [&r](const statistics::Estimate& e) {
    return r.found ? std::optional(e) : std::nullopt;
  };
  f.flag("found", r.found);
  f.words_or_null("method", r.method, "What was fitted.");
  f.number("argmax_rad", if_found(r.argmax_rad),
           "Joint angle of the largest torque: the paper's way.");
  f.number("argmax_low_rad", if_found(r.argmax_low_rad),
           "Lowest angle that noise cannot tell from it.");
  f.number("argmax_high_rad", if_found(r.argmax_high_rad));
  f.number("argmax_torque_Nm", if_found(r.argmax_torque_Nm), "Torque there, motor side.");
  f.flag("argmax_at_end", r.argmax_at_end,
         "The largest torque lies at the sweep's end: no peak was crossed.");
  f.interval("q_peak_rad", known(r.q_peak_rad),
             "Joint angle at which gravity torque is largest, fitted.");
  f.interval("gravity_Nm", known(r.gravity_Nm), "Gravity amplitude G/n, motor side.");
  f.interval("gravity_joint_Nm", known(statistics::scaled(r.gravity_Nm, gear_ratio)),
             "Gravity amplitude G, joint side.");
  f.interval("coulomb_Nm", r.coulomb_Nm, "Half the distance of the two directions, motor side.");
  f.interval("viscous_Nms_rad", r.viscous_Nms_rad, "Per motor speed, motor side.");
  f.interval("inertia_kgm2", r.inertia_kgm2, "Reflected to the motor.");
  f.number("offset_Nm", if_found(r.offset_Nm),
           "Mean of both directions that is not gravity, motor side.");
  f.interval("torque_offset_Nm", r.torque_offset_Nm,
             "The same with its interval, where both directions were recorded: an offset of the "
             "torque, or half the difference of the directions' friction.");
  f.number("residual_Nm", if_found(r.residual_Nm), "Standard deviation of what the fit leaves.");
  f.object("residual_causes",
           "What the residual comes from, as standard deviations: white noise; ripple, which "
           "repeats with the motor's angle; noise that hangs together in time; friction that "
           "changes with the angle; and what is periodic in time.",
           [&](Fields& of) {
             of.number("white_Nm", r.white_Nm);
             of.number("ripple_Nm", r.ripple_Nm);
             of.number("coloured_Nm", r.coloured_Nm);
             of.number("friction_by_angle_Nm", r.friction_by_angle_Nm);
             of.list("vibration", r.vibration, "",
                     [](Fields& one, const method::gravity::VibrationLine& line) {
                       one.number("frequency_Hz", line.frequency_Hz);
                       one.number("amplitude_Nm", line.amplitude_Nm);
                     });
           });
  f.number("lowest_rad", if_found(r.lowest_rad));
  f.number("highest_rad", if_found(r.highest_rad));
  f.flag("both_directions", r.both_directions);
  f.flag("constant_speed", r.constant_speed);
  f.count("samples_used", r.samples_used);
  f.count("samples_left_out", r.samples_left_out);
}

// Stages 5 to 7.

void state_viscous(Fields& f, const method::viscous::ViscousCurvesResult& v) {
  f.flag("from_sweep", v.from_sweep, "Runs are angle bins of a sweep of varying speed.");
  f.object("angles",
           "Joint angles of the runs that travel far; null where no run has the direction.",
           [&](Fields& of) {
             const method::viscous::DirectionAngles& a = v.angles;
             const auto angle = [](bool has, double rad) {
               return has ? rad : std::numeric_limits<double>::quiet_NaN();
             };
             of.number("rising_low_rad", angle(a.has_rising, a.rising_low_rad));
             of.number("rising_high_rad", angle(a.has_rising, a.rising_high_rad));
             of.number("falling_low_rad", angle(a.has_falling, a.falling_low_rad));
             of.number("falling_high_rad", angle(a.has_falling, a.falling_high_rad));
             of.flag("share_angles", a.share_angles());
           });
  f.count("samples_used", v.samples_used);
  f.count("samples_left_out", v.samples_left_out);
  f.count("recordings_without_plateau", v.recordings_without_plateau);
  f.list(
      "runs", v.runs, "Sorted by speed.",
      [](Fields& one, const method::viscous::ConstantSpeedRun& r) {
        one.text("recording", r.recording);
        one.number("speed_rad_s", r.speed_rad_s, "Motor side, signed.");
        one.number("torque_Nm", r.torque_Nm, "Mean driving torque, motor side.");
        one.number("torque_half_width_Nm", r.torque_half_width_Nm, "95 % of the mean.");
        one.number("q_rad", r.q_rad);
        one.number("mean_cos", r.mean_cos);
        one.number("mean_load", r.mean_load,
                   "Mean of |cos(q - q_peak)|; of a friction point, its load as a share of the "
                   "gravity torque, or else of the largest load.");
        one.number("lowest_rad", r.lowest_rad);
        one.number("highest_rad", r.highest_rad);
        one.count("samples", r.samples);
        one.put("partner", r.partner < 0 ? Json(nullptr) : Json(r.partner),
                R"({"type": ["integer", "null"], "minimum": 0})",
                "Index of the run of opposite direction.");
        one.number("direction_difference_Nm", r.direction_difference_Nm,
                   "(T(+v) - T(-v))/2 at equal angle, with this run's sign.");
        one.number("direction_difference_half_width_Nm", r.direction_difference_half_width_Nm,
                   "95 %.");
        one.number("direction_mean_Nm", r.direction_mean_Nm,
                   "(T(+v) + T(-v))/2 over the same angles.");
      },
      "One plateau, or one angle bin in one direction.");
  Json curves = Json::object();
  for (const method::viscous::ViscousCurve& c : v.curves)
    curves[to_string(c.estimator)] = numbers(c.friction_Nm);
  f.numbers_by_name<method::hysteresis::Estimator>("curves", std::move(curves),
                                                   "One curve per estimator.",
                                                   "Friction torque per run [N·m], motor side.");
}

void state_quality(Fields& f, const method::selection::QualityErrorsResult& q) {
  Json percent = Json::object();
  Json rms = Json::object();
  for (const method::selection::QualityError& e : q.errors) {
    percent[to_string(e.estimator)] = numbers(e.percent);
    rms[to_string(e.estimator)] = number(e.rms_percent);
  }
  const bool has_reference = q.reference != method::selection::CurveReference::none;
  f.choice("reference", has_reference ? std::optional(q.reference) : std::nullopt);
  f.numbers("reference_Nm", q.reference_Nm, "Per run.");
  f.numbers("reference_half_width_Nm", q.reference_half_width_Nm,
            "95 %, per run; 0 where the reference is known exactly.");
  f.number("reference_rms_percent",
           q.errors.empty() ? std::nullopt : std::optional(q.reference_rms_percent),
           "Root mean square of the reference's own 95 % half width in % of the driving torque: an "
           "error below it is no evidence.");
  f.words_or_null("evidence", q.evidence);
  f.numbers_by_name<method::hysteresis::Estimator>("percent", std::move(percent),
                                                   "One list per estimator.",
                                                   "Per run [% of the driving torque].");
  f.put("rms_percent", std::move(rms),
        R"({"type": "object", "additionalProperties": {"type": ["number", "null"]}})",
        "Root mean square per estimator.");
  f.count("runs_left_out", q.runs_left_out);
}

void state_selection(Fields& f, const method::selection::SelectionResult& s) {
  f.put("paper_rule", text_or_null(to_string(s.paper_rule)),
        R"({"enum": ["A", "B", "C", "D", "E", "F", null]})",
        "Of A to F the one of smallest error.");
  std::vector<std::string> rivals;
  for (const method::hysteresis::Estimator rival : s.paper_rule_rivals) {
    rivals.emplace_back(to_string(rival));
  }
  f.put("paper_rule_rivals", Json(rivals),
        R"({"type": "array", "items": {"enum": ["A", "B", "C", "D", "E", "F"]}})",
        "Those of A to F that the paper's rule could have chosen instead, within the intervals "
        "of their masses.");
  f.choice("recommended", s.recommended);
  f.words_or_null("why", s.why);
  f.number("q_c_corrected_rad", s.q_c_corrected_rad, "Eq. (14) for the paper's choice.");
  f.interval("q_c_rad", s.q_c_rad, "Link angle of the centre of gravity, -q_peak.");
}

// What was stated about loads.

void state_other_joints(Fields& f, const std::vector<joint::OtherJoint>& others) {
  f.list(
      "other_joints", others, "The robot's other joints whose angles were looked for in the logs.",
      [](Fields& one, const joint::OtherJoint& other) {
        const auto if_logged = [&](double value) {
          return other.samples > 0 ? std::optional(value) : std::nullopt;
        };
        one.text("name", other.name);
        one.text("column", other.angle);
        one.count("samples", other.samples);
        one.number("lowest_rad", if_logged(other.lowest_rad));
        one.number("highest_rad", if_logged(other.highest_rad));
      },
      "Range of the angle over all recordings of the tested joint; null where it was not logged.");
}

namespace {

void state_gravity(Fields& f, const joint::StatedGravity& g) {
  f.number("amplitude_joint_Nm", g.amplitude_Nm());
  f.number("q_peak_rad", g.q_peak_rad());
  f.number("percent", g.percent(), "Of the amplitude, half width at 95 %.");
}

}  // namespace

void state_arm_gravity(Fields& f, const std::optional<joint::ArmGravity>& arm) {
  f.object_or_null(
      "arm_gravity", arm,
      "Gravity by the masses of a description of the arm: what the other joints' motion changes of "
      "it was subtracted from the torque.",
      [](Fields& of, const joint::ArmGravity& a) {
        of.text("description", a.description, "The file.");
        of.known_number("description_percent", a.description_percent,
                        "Half width at 95 % of its masses.");
        of.put("gravity_m_s2", Json(a.gravity_m_s2),
               R"({"type": "array", "items": {"type": "number"}})", "In the base's frame.");
        of.text("tested", a.tested, "The tested joint's name in the description.");
        of.put("matched_by", a.is_by_order ? "order" : "name", R"({"enum": ["name", "order"]})");
        of.list("held", a.held,
                "The posture against which motion counts: the means over the first sweep.",
                [](Fields& one, const joint::HeldJoint& held) {
                  one.text("joint", held.name);
                  one.number("position_rad", held.position_rad, "Of a sliding joint in m.");
                  one.flag("logged", held.is_logged, "false: no column has it, and 0 is assumed.");
                });
        of.object_or_null("own", a.own,
                          "Of the tested joint in the posture in which the others are held.",
                          state_gravity, joint::StatedGravity(0, 0));
        of.count("samples", a.samples, "From which it was subtracted.");
        of.number("largest_joint_Nm", a.largest_Nm, "Largest size subtracted.");
      });
}

void state_known_loads(Fields& f, const std::vector<joint::KnownLoad>& loads) {
  f.list(
      "known_loads", loads,
      "Loads that the manifest states; subtracted from the torque when reading.",
      [](Fields& one, const joint::KnownLoad& load) {
        one.number("amplitude_joint_Nm", load.amplitude_Nm);
        one.texts("angles", load.angles, "Columns of the log.");
        one.number("phase_rad", load.phase_rad);
        std::vector<std::string> roles;
        for (const joint::Role role : load.roles) roles.emplace_back(to_string(role));
        one.texts("roles", roles, "Of the recordings that it loads; empty: all.");
        one.text_or_null("note", load.note);
        one.count("samples", load.samples, "From which it was subtracted.");
        one.number("largest_joint_Nm", load.largest_Nm, "Largest size subtracted.");
      },
      "amplitude cos(sum of the angles + phase), joint side.");
}

void state_known_gravity(Fields& f, const std::optional<joint::StatedGravity>& g) {
  f.object_or_null("known_gravity", g, "Gravity of the joint that the manifest states.",
                   state_gravity, joint::StatedGravity(0, 0));
}

}  // namespace tribolog::calibration
