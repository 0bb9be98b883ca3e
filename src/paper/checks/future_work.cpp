#include "paper/checks/future_work.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/requirements.h"
#include "identify/identify.h"
#include "method/hysteresis/lugre_fit.h"
#include "simulate/simulate_joint.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::paper::checks {

namespace {

using method::hysteresis::LuGreFit;
using method::hysteresis::LuGreParameterName;
using wording::tr;
using wording::with_unit;

struct Parameter {
  LuGreParameterName name;
  const char* symbol;
  const char* unit;
  double friction::LuGreFriction::Parameters::* put_in;
};

constexpr std::array parameters{
    Parameter{LuGreParameterName::bristle_stiffness, "σ₀", "N·m/rad",
              &friction::LuGreFriction::Parameters::bristle_stiffness_Nm_rad},
    Parameter{LuGreParameterName::bristle_damping, "σ₁", "N·m·s/rad",
              &friction::LuGreFriction::Parameters::bristle_damping_Nms_rad},
    Parameter{LuGreParameterName::viscous, "σ₂", "N·m·s/rad",
              &friction::LuGreFriction::Parameters::viscous_Nms_rad},
    Parameter{LuGreParameterName::static_torque, "T_s", "N·m",
              &friction::LuGreFriction::Parameters::static_Nm},
    Parameter{LuGreParameterName::coulomb_torque, "T_c", "N·m",
              &friction::LuGreFriction::Parameters::coulomb_Nm},
    Parameter{LuGreParameterName::stribeck_speed, "ω_s", "rad/s",
              &friction::LuGreFriction::Parameters::stribeck_speed_rad_s}};

/// What the oscillation alone shows, at this amplitude.
LuGreFit by_loop_alone(const simulate::Scenario& whole, double amplitude_rad) {
  simulate::Scenario alone = whole;
  alone.rough_sweep.reset();
  alone.precise_sweep.reset();
  alone.constant_speed.reset();
  simulate::OscillationExperiment& e = present(alone.oscillation);
  e.amplitude_rad = amplitude_rad;
  e.record_bristle = false;
  identify::IdentifyOptions options;
  return identify::identify(simulate::simulated_dataset(alone), options).lugre.value_or(LuGreFit{});
}

/// Adds a check for each parameter that the loop shows. @return those that it does not, with the
/// reason.
std::vector<std::string> compare(const PapersJoint& joint, const LuGreFit& fit,
                                 const std::string& loop, Checks& checks) {
  constexpr double share = 1e-3;
  const friction::LuGreFriction::Parameters& truth = bristles_of(joint.scenario).parameters();
  std::vector<std::string> missing;
  for (const Parameter& one : parameters) {
    const auto found = fit.shown(one.name);
    const double put_in = truth.*one.put_in;
    if (found) {
      checks.push_back(other_way(
          tr("{loop} alone: {symbol}", {{"loop", loop}, {"symbol", one.symbol}}), put_in,
          found->value, share * put_in, one.unit, tr("a thousandth: a log without noise")));
      continue;
    }
    const auto why = std::find_if(fit.parameters.begin(), fit.parameters.end(),
                                  [&](const auto& p) { return p.name == one.name; });
    missing.push_back(tr("{loop} alone does not show {symbol}: {reason}.",
                         {{"loop", loop},
                          {"symbol", one.symbol},
                          {"reason", why != fit.parameters.end() ? wording::words(why->why_not)
                                                                 : wording::words(fit.reason)}}));
  }
  return missing;
}

}  // namespace

PaperItem check_future_work(const PapersJoint& joint) {
  PaperItem item;
  item.kind = ItemKind::statement;
  item.number = 1;
  item.title = tr("Future work: all parameters from the hysteresis alone");
  item.remark = tr(
      "“For future experiments it is suggested to prepare a method for determining values of all "
      "parameters based only on friction hysteresis.” Here LuGre is fitted to the torque of the "
      "oscillation alone: no sweep, no runs, no z(t). What a loop does not show is not stated.");
  const double as_printed = present(joint.scenario.oscillation).amplitude_rad;
  constexpr double times_as_large = 100;
  const LuGreFit small = by_loop_alone(joint.scenario, as_printed);
  const LuGreFit large = by_loop_alone(joint.scenario, times_as_large * as_printed);
  item.unchecked = compare(joint, small, tr("The paper's oscillation"), item.checks);
  for (std::string& text :
       compare(joint, large, tr("An oscillation 100 times as large"), item.checks)) {
    item.unchecked.push_back(std::move(text));
  }
  item.unchecked.push_back(
      tr("Not met by a loop alone: q_peak and with it the surrogate mass, which need a sweep or "
         "runs at several angles. Real logs are in docs/real_logs.md of the program's source."));
  return item;
}

}  // namespace tribolog::paper::checks
