// Stages 3 and 4.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "calibration/parts.h"
#include "method/hysteresis/steady_loop.h"

namespace tribolog::calibration {

namespace {

void state_points(Fields& f, const char* key,
                  const std::vector<method::hysteresis::LoopPoint>& points, const char* meaning) {
  using Points = std::vector<method::hysteresis::LoopPoint>;
  f.object_or_null(
      key, points.empty() ? nullptr : &points, meaning, [](Fields& of, const Points& all) {
        for (const method::hysteresis::Estimator name : method::hysteresis::loop_points) {
          const auto point =
              std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == name; });
          of.object_or_null(to_string(name).c_str(), point == all.end() ? nullptr : &*point,
                            "One point of the hysteresis loop.",
                            [](Fields& one, const method::hysteresis::LoopPoint& p) {
                              one.number("t_s", p.t_s);
                              one.number("q_rad", p.q_rad, "Joint angle.");
                              one.number("torque_Nm", p.torque_Nm, "Driving torque, motor side.");
                              one.number("torque_low_Nm", p.torque_low_Nm);
                              one.number("torque_high_Nm", p.torque_high_Nm);
                              one.number("z_rad", p.z_rad, "Mean bristle deflection, motor side.");
                              one.number("dz_dt_rad_s", p.dz_rad_s, "Its rate, motor side.");
                            });
        }
      });
}

/// Points of each loop: many positions share what three would have.
std::size_t points_of_each(std::size_t loops) {
  return std::clamp<std::size_t>(600 / std::max<std::size_t>(loops, 1), 40, 200);
}

std::optional<method::hysteresis::SteadyLoop> drawn_loop(
    const method::hysteresis::HysteresisResult& h, const Curves& curves, std::size_t k) {
  if (k >= curves.loops.size()) return std::nullopt;
  return method::hysteresis::steady_loop(curves.loops[k], h.oscillations[k],
                                         points_of_each(h.oscillations.size()));
}

void state_steady_loop(Fields& f, const method::hysteresis::SteadyLoop& loop) {
  constexpr const char* numbers = R"({"type": "array", "items": {"type": ["number", "null"]}})";
  f.number("centre_rad", loop.centre_rad);
  f.put("angle_from_centre_rad", short_numbers(loop.from_centre_rad), numbers,
        "Joint angle less the centre.");
  f.put("torque_Nm", short_numbers(loop.torque_Nm), numbers, "Motor side.");
}

}  // namespace

void state_hysteresis(Fields& f, const method::hysteresis::HysteresisResult& h,
                      const Curves& curves) {
  f.flag("found", h.found);
  f.words_or_null("bristle_source", h.bristle_source, "Where z comes from; null: there is none.");
  std::size_t k = 0;
  f.list(
      "oscillations", h.oscillations, "One per recording used.",
      [&](Fields& one, const method::hysteresis::Oscillation& o) {
        one.number("centre_rad", o.centre_rad);
        one.number("amplitude_rad", o.amplitude_rad);
        one.number("frequency_Hz", o.frequency_Hz);
        one.number("cycles", o.cycles);
        one.number("steady_cycles", o.steady_cycles);
        one.number("encoder_step_rad", o.encoder_step_rad, "0: continuous.");
        one.flag("step_is_of_print", o.step_is_of_print,
                 "The step is that of the decimals the angles were printed with: the log resolves "
                 "nothing finer, and the encoder's own step may be larger.");
        one.newer().object_or_null(
            "steady_loop", drawn_loop(h, curves, k++),
            "The loop in at most 200 points, in the order of time, for drawing: the mean of the "
            "steady cycles, or the last cycle where they are not periodic. Files of older versions "
            "have none.",
            state_steady_loop);
      },
      "One oscillation that was used.");
  state_points(f, "points", h.points, "Points A to F; null where no bristle state is to be had.");
  state_points(f, "steady_points", h.steady_points,
               "Points A to F; null where no bristle state is to be had.");
  f.interval("midline_Nm", h.midline_Nm,
             "Torque of the steady loop's mid-line at the gravity peak, motor side.");
  f.number("midline_q_rad", h.midline_Nm ? std::optional(h.midline_q_rad) : std::nullopt);
  f.number("loop_height_Nm", h.found ? std::optional(h.loop_height_Nm) : std::nullopt,
           "Largest less smallest torque, motor side.");
  f.number("presliding_travel_rad", h.presliding_travel_rad);
  f.number("encoder_step_rad", h.encoder_step_rad);
  f.flag("step_is_of_print", h.encoder_step_rad ? std::optional(h.step_is_of_print) : std::nullopt,
         "Of encoder_step_rad, as in the oscillations; null without it.");
}

void state_surrogate_masses(Fields& f, const method::hysteresis::SurrogateMassesResult& result) {
  f.list(
      "surrogate_masses", result.masses, "Stage 4; those that could be read.",
      [](Fields& one, const method::hysteresis::SurrogateMass& m) {
        one.choice("estimator", m.estimator);
        one.interval("torque_Nm", m.torque_Nm, "Motor side.");
        one.number("q_rad", m.q_rad);
        one.interval("mass_kg", m.mass_kg);
        one.interval("gravity_Nm", m.gravity_Nm, "Gravity amplitude it stands for, motor side.");
        one.number("offset_taken_Nm", m.offset.value_Nm,
                   "Taken off the torque for the offset that the rough sweep shows.");
        one.number("offset_ambiguity_Nm", m.offset.ambiguity_Nm,
                   "Half width of what is not known of it: an offset of the torque, or friction "
                   "that differs between the directions.");
      },
      "m = n T / (g r cos(q - q_peak)).");
}

// Stage 8, the LuGre fit of the loops.

namespace {

using method::hysteresis::LuGreParameterName;

/// Factor from the motor's side to the joint's, by the quantity's powers of torque and speed.
double to_joint(LuGreParameterName name, double n) {
  switch (name) {
    case LuGreParameterName::static_torque:
    case LuGreParameterName::coulomb_torque:
      return n;
    case LuGreParameterName::stribeck_speed:
      return 1 / n;
    case LuGreParameterName::speed_weakening:
      return n * n * n;
    default:
      return n * n;
  }
}

void state_parameter(Fields& f, const method::hysteresis::LuGreParameter& p) {
  f.choice("name", p.name);
  f.flag("shown", p.estimate.has_value());
  f.number("held_at", p.held_at, "Value at which the fit held it; null where it was varied.");
  f.number("relative_standard_error", p.relative_error);
  f.number("effect_Nm", p.effect_Nm,
           "Torque (rms) that it makes and no other parameter can imitate.");
  f.words_or_null("why_not", p.why_not);
  f.words_or_null("experiment", p.experiment);
}

void state_identifiability(Fields& f, const method::hysteresis::LuGreIdentifiability& i) {
  Json correlation = Json::array();
  for (const auto& row : i.correlation) correlation.push_back(numbers(row));
  f.words("names", i.names);
  f.numbers("singular_values_Nm", i.singular_values_Nm);
  f.number("condition", i.condition);
  f.numbers("weakest_direction", i.weakest);
  f.words_or_null("weakest_in_words", i.weakest_statement);
  f.put("correlation", std::move(correlation),
        R"({"type": "array", "items": {"type": "array", "items": {"type": ["number", "null"]}}})");
}

void state_traced(Fields& f, const method::hysteresis::TracedLoop& loop) {
  f.number("noise_rad", loop.noise_rad, "Standard deviation of the angle's noise, joint side.");
  f.words("noise_from", loop.noise_source, "What tells that noise.");
  f.count("strokes", loop.strokes, "Between reversals.");
  f.number("explained_Nm", loop.explained_Nm,
           "Scatter of the torque that the noise of angle and torque explains.");
  f.interval("turn_stiffness_Nm_rad", loop.turn_stiffness_Nm_rad,
             "Motor torque over joint angle behind the reversals, measured.");
  f.interval("model_turn_stiffness_Nm_rad", loop.model_turn_stiffness_Nm_rad,
             "The same of the model, over the same samples.");
}

void state_contacts(Fields& f, const method::hysteresis::ContactComparison& comparison) {
  f.choice("winner", comparison.winner,
           "The one that describes the loops better than both others, beyond doubt. null: none "
           "does, or there was no comparison.");
  f.list("rivals", comparison.candidates, "",
         [](Fields& one, const method::hysteresis::ContactCandidate& candidate) {
           one.choice("law", candidate.law);
           one.number("stiffness_Nm_rad", candidate.stiffness_Nm_rad, "Just after a reversal.");
           one.number(
               "static_Nm", candidate.static_Nm,
               "Torque at which it slides; of Maxwell-slip without what never slips in the loops.");
           one.number("residual_Nm", candidate.residual_Nm, "Rms over the rows compared.");
         });
}

void state_recording(Fields& f, const method::hysteresis::LuGreLoop& loop) {
  f.text("recording", loop.recording);
  f.interval("gravity_Nm", loop.gravity_Nm);
  f.number("start_deflection_rad", loop.start_deflection_rad);
  f.count("samples_left_out", loop.samples_left_out,
          "At the beginning, where the drive starts the motion.");
  f.known_number("left_out_s", loop.left_out_s, "Their duration.");
  f.number("residual_Nm", loop.residual_Nm);
  f.number("height_Nm", loop.height_Nm, "Largest less smallest torque of the loop.");
  f.number("systematic_Nm", loop.systematic_Nm,
           "What the model leaves and noise does not explain, root mean square.");
  f.choice("motion", loop.motion,
           "What drove the model: harmonics of a periodic angle, or a smoothing spline through the "
           "angle of a joint that a torque drove.");
  f.number("motion_residual_rad", loop.motion_residual_rad,
           "Standard deviation of the recorded angle less that motion, joint side.");
  f.object_or_null(
      "traced", loop.traced,
      "How well the motion is known and the model fits it. Of a spline; null of harmonics.",
      state_traced);
}

}  // namespace

void state_lugre(Fields& f, const method::hysteresis::LuGreFit& fit, double n) {
  f.flag("converged", fit.converged);
  f.choice("rung", fit.rung,
           "How much of the model the loops carry; null where nothing was fitted.");
  for (const LuGreParameterName name : method::hysteresis::lugre_parameters) {
    f.both_sides(std::string(to_string(name)).c_str(), fit.shown(name), to_joint(name, n));
  }
  f.both_sides("gravity_Nm", fit.gravity_Nm, n);
  f.number("residual_Nm", fit.residual_Nm);
  f.object("contacts",
           "Contacts that competed where LuGre leaves what repeats, each fitted to the same rows. "
           "Motor side.",
           [&](Fields& of) { state_contacts(of, fit.contacts); });
  f.object_or_null("damping_fall", fit.damping_fall,
                   "Bristle damping that falls with speed, exp(-(w/wd)²), where the loops show it: "
                   "the motor speed at which it has fallen to a half, and by how much the "
                   "stiffness would be larger with it.",
                   [](Fields& of, const auto& fall) {
                     of.known_number("half_at_rad_s", fall.half_at_rad_s);
                     of.known_number("stiffness_share", fall.stiffness_share);
                   });
  f.count("iterations", fit.iterations);
  f.words_or_null("reason", fit.reason);
  f.list("parameters", fit.parameters, "What is shown by the loops, and what is not and why.",
         state_parameter, "One parameter.");
  f.object_or_null("identifiability",
                   fit.identifiability.names.empty() ? nullptr : &fit.identifiability,
                   "Singular values of the scaled Jacobian. Null where nothing was fitted.",
                   state_identifiability);
  f.list("recordings", fit.loops, "The loops that were fitted together.", state_recording,
         "One loop.");
}

// Break-away ramps and the shape of the loops, which are not in the paper.

void state_break_away(Fields& f, const method::hysteresis::BreakAwayResult& result,
                      double gear_ratio) {
  const auto on_both_sides = [&](const char* key, const std::optional<statistics::Estimate>& e,
                                 const char* meaning) {
    f.put(key, e ? both_sides(*e, gear_ratio) : Json(nullptr),
          R"({"oneOf": [{"type": "null"}, {"$ref": "#/$defs/both_sides"}]})", meaning);
  };
  f.flag("gravity_taken_off", result.gravity.has_value());
  f.count("censored", result.censored, "Ramps that did not break away.");
  on_both_sides("rising_Nm", result.rising_Nm,
                "Break-away torque towards positive torque, from the scatter of the ramps.");
  on_both_sides("falling_Nm", result.falling_Nm, "The same towards negative torque, a magnitude.");
  on_both_sides("mean_Nm", result.mean_Nm, "Mean of both, in which gravity cancels.");
  f.list(
      "ramps", result.ramps, "",
      [](Fields& one, const method::hysteresis::BreakAwayRamp& r) {
        one.text("recording", r.recording);
        one.put("direction", r.is_rising ? "rising" : "falling",
                R"({"enum": ["rising", "falling"]})", "Of the torque.");
        one.flag("broke_away", r.broke_away, "False: censored, friction_Nm is a lower bound.");
        one.number("rate_Nm_s", r.rate_Nm_s, "Of the torque, motor side.");
        one.number("torque_Nm", r.torque_Nm,
                   "Driving torque at break-away, or the largest reached; motor side, signed.");
        one.number("friction_Nm", r.friction_Nm,
                   "Magnitude; gravity taken off where gravity_taken_off.");
        one.newer().number(
            "inertia_Nm", r.inertia_Nm,
            "What was taken off for the joint's inertia at the reading, in the ramp's direction.");
        one.newer().number("inertia_half_width_Nm", r.inertia_half_width_Nm,
                           "Within which inertia_Nm is known.");
        one.newer().number("level_Nm", r.level_Nm,
                           "What friction tends to in the part of the ramp that rests, a "
                           "magnitude; null: it does not bend over there.");
        one.number("q_start_rad", r.q_start_rad, "Joint angle at rest.");
        one.number("travel_rad", r.travel_rad, "Joint travel up to there.");
        one.number(
            "first_slip_rad", r.first_slip_rad,
            "Travel of the first slip if the joint stopped again; null: it slid on, or never did.");
        one.number("even_slide_rad_s", r.even_slide_rad_s,
                   "Mean joint speed if the joint slid on at an even speed instead of running "
                   "away; level_Nm is friction at that speed.");
        one.number("largest_yield", r.largest_yield,
                   "Largest ratio of speed to mean speed up to there; break-away is told at 30.");
        one.count("samples_used", r.samples_used, "Up to break-away.");
        one.count("samples_left_out", r.samples_left_out, "Behind it.");
      },
      "One break-away ramp.");
}

void state_loop_shapes(Fields& f, const std::vector<method::hysteresis::LoopShape>& shapes) {
  f.list(
      "loop_shapes", shapes, "One per oscillation that swings through three cycles.",
      [](Fields& one, const method::hysteresis::LoopShape& s) {
        one.text("recording", s.recording);
        one.number("width_rad", s.width_rad, "Joint angle, steady cycles.");
        one.number("height_Nm", s.height_Nm, "Motor torque, steady cycles.");
        one.number("cycles", s.cycles, "Steady ones.");
        one.number("closing_gap", s.closing_gap,
                   "Mean distance from the cycle before, as a share of the width.");
        one.flag("closes", s.closes);
        one.number("dissipated_J", s.dissipated_J, "Work per cycle at the joint.");
        one.interval("stiffness_Nm_rad", s.stiffness_Nm_rad,
                     "Motor torque per joint angle over the first third of the loop's height "
                     "behind a reversal.");
        one.count("strokes", s.strokes, "Behind which the stiffness was read.");
      },
      "One recorded loop, described without a model.");
}

}  // namespace tribolog::calibration
