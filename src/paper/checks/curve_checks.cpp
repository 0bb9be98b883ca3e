// Figures 18 to 22: viscous curves of the candidates, their errors, and the choice.

#include <algorithm>

#include "base/requirements.h"
#include "paper/checks/check.h"
#include "paper/drawings/printed_paper.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {
namespace {

using method::hysteresis::Estimator;
using wording::tr;

constexpr double curve_rounding_Nm = 1e-12;

std::string nearest_to_the_truth(const PapersJoint& joint) {
  const double truth = joint.true_mass_kg();
  std::optional<Estimator> nearest;
  double least = INFINITY;
  for (const Estimator name : method::hysteresis::loop_points) {
    const method::hysteresis::SurrogateMass* mass = joint.calibration.masses.find(name);
    if (mass == nullptr || std::abs(mass->mass_kg.value - truth) >= least) continue;
    least = std::abs(mass->mass_kg.value - truth);
    nearest = name;
  }
  return to_string(nearest);
}

}  // namespace

Checks check_candidate_curves(const PapersJoint& joint) {
  const method::viscous::ViscousCurvesResult& viscous = joint.calibration.viscous;
  const auto& speeds = present(joint.scenario.constant_speed).motor_speeds_rad_s;
  double apart = 0;
  for (const Estimator name : method::hysteresis::loop_points) {
    const method::viscous::ViscousCurve* curve = viscous.find(name);
    const method::hysteresis::SurrogateMass* mass = joint.calibration.masses.find(name);
    const method::viscous::ViscousCurve* first = viscous.find(Estimator::A);
    const method::hysteresis::SurrogateMass* first_mass =
        joint.calibration.masses.find(Estimator::A);
    if (curve == nullptr || mass == nullptr || first == nullptr || first_mass == nullptr) {
      return {vanishing(tr("Candidate {point} has no curve", {{"point", to_string(name)}}), NAN, 0,
                        "", "")};
    }
    for (std::size_t i = 0; i < viscous.runs.size(); ++i) {
      const double gravity_apart = first_mass->gravity_Nm.value - mass->gravity_Nm.value;
      const double shifted = first->friction_Nm[i] + gravity_apart * viscous.runs[i].mean_cos;
      apart = larger_size(apart, curve->friction_Nm[i] - shifted);
    }
  }
  return {other_way(tr("Runs with a plateau: every speed in both directions"),
                    2.0 * static_cast<double>(speeds.size()),
                    static_cast<double>(viscous.runs.size()), 0, "", ""),
          vanishing(tr("A candidate's mass only shifts its curve: six curves minus curve A, minus "
                       "the difference in gravity: largest"),
                    apart, curve_rounding_Nm, "N·m", tr("rounding"))};
}

Checks check_reference_curve(const PapersJoint& joint) {
  const method::viscous::ViscousCurvesResult& viscous = joint.calibration.viscous;
  double apart = 0;
  double two_ways = 0;
  for (std::size_t i = 0; i < viscous.runs.size(); ++i) {
    const method::viscous::ConstantSpeedRun& run = viscous.runs[i];
    const double analytic = joint.scenario.sliding->torque_Nm(run.speed_rad_s);
    apart = larger_size(apart, joint.calibration.quality.reference_Nm.at(i) - analytic);
    two_ways = larger_size(two_ways, run.direction_difference_Nm - analytic);
  }
  return {vanishing(tr("The reference is eq. (6), (7) at the motor's speed: largest difference"),
                    apart, curve_rounding_Nm, "N·m", tr("rounding")),
          vanishing(tr("(T(+ω) − T(−ω))/2 at equal angle gives it without prior knowledge: largest "
                       "difference"),
                    two_ways, 1e-5, "N·m", tr("angles are compared in bins"))};
}

Checks check_quality_errors(const PapersJoint& joint) {
  const method::selection::QualityErrorsResult& quality = joint.calibration.quality;
  Checks out{by_name(tr("Selected: the point with the smallest error"), Kind::print, "B",
                     to_string(joint.calibration.selection.paper_rule))};
  // A curve's shift in % of the torque is known: gravity's error through the mean cosine.
  const double truth = joint.true_gravity_Nm();
  for (const Estimator name : method::hysteresis::loop_points) {
    const method::selection::QualityError* error = quality.find(name);
    const method::hysteresis::SurrogateMass* mass = joint.calibration.masses.find(name);
    if (error == nullptr || mass == nullptr) continue;
    double squares = 0;
    std::size_t counted = 0;
    for (const method::viscous::ConstantSpeedRun& run : joint.calibration.viscous.runs) {
      const double expected = 100 * (truth - mass->gravity_Nm.value) * run.mean_cos / run.torque_Nm;
      squares += expected * expected;
      ++counted;
    }
    out.push_back(other_way(
        tr("Error of {point}, root mean square over the runs", {{"point", to_string(name)}}),
        std::sqrt(squares / static_cast<double>(counted)), error->rms_percent, 1e-6, tr("% of T"),
        tr(rounding_of_log)));
  }
  return out;
}

Checks check_selected_curve(const PapersJoint& joint) {
  const method::viscous::ViscousCurve* best = joint.calibration.viscous.find(Estimator::midline);
  double apart = NAN;
  if (best != nullptr) {
    apart = 0;
    for (std::size_t i = 0; i < best->friction_Nm.size(); ++i) {
      apart =
          larger_size(apart, best->friction_Nm[i] - joint.calibration.quality.reference_Nm.at(i));
    }
  }
  return {vanishing(tr("Curve by the mid-line's mass against the analytic one: largest difference"),
                    apart, 1e-6, "N·m", tr("a millionth of friction"))};
}

Checks check_torque_choice(const PapersJoint& joint) {
  return {by_name(tr("The rule's choice against the nearest of the six to the true mass"),
                  Kind::independent, nearest_to_the_truth(joint),
                  to_string(joint.calibration.selection.paper_rule))};
}

}  // namespace tribolog::paper::checks
