#include "figures/chosen_point.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "wording/number_text.h"

namespace tribolog::figures {
namespace {

constexpr double worth_saying = 0.01;  // of the shift: a peak known better needs no word

const LoopPoint* find(const std::vector<LoopPoint>& points, const std::string& name) {
  for (const LoopPoint& point : points) {
    if (name.size() == 1 && point.name == name.front()) return &point;
  }
  return nullptr;
}

/// A and B, C and D, E and F lie opposite each other on the steady loop.
std::string opposite(const std::string& name) {
  static const std::string pairs = "ABCDEF";
  const std::size_t at = name.size() == 1 ? pairs.find(name) : std::string::npos;
  return at == std::string::npos ? std::string() : std::string(1, pairs[at ^ 1U]);
}

std::string mass_words(const Calibration& calibration, const std::string& estimator) {
  const SurrogateMass* mass = calibration.masses.find(estimator);
  if (mass == nullptr) return {};
  return " (" + with_interval(mass->mass_kg, AxisScale{1.0, "kg"}) + ")";
}

}  // namespace

Choice choice_of(const Calibration& calibration) {
  const HysteresisResult& loop = calibration.hysteresis;
  const std::string& name = calibration.selection.paper_rule;
  Choice choice;
  choice.chosen = find(loop.points, name);
  choice.other = find(loop.points, opposite(name));
  choice.chosen_steady = find(loop.steady_points, name);
  choice.other_steady = find(loop.steady_points, opposite(name));
  if (loop.midline_Nm) choice.midline = &*loop.midline_Nm;
  return choice;
}

std::string choice_words(const Calibration& calibration, const Choice& choice,
                         const AxisScale& torque) {
  std::string text;
  if (choice.chosen != nullptr) {
    const std::string name(1, choice.chosen->name);
    text += fmt::format("the paper's rule reads {} at {}{}",
                        with_unit(choice.chosen->torque_Nm, torque, 4), name,
                        mass_words(calibration, name));
  }
  if (choice.midline != nullptr) {
    if (!text.empty()) text += "; ";
    text += fmt::format("the mid-line of the steady loop averages {}{}",
                        with_interval(*choice.midline, torque), mass_words(calibration, "midline"));
  }
  return text;
}

std::string shift_words(const Calibration& calibration, const Choice& choice) {
  if (choice.chosen == nullptr || !calibration.q_peak_rad) return {};
  const Estimate& peak = *calibration.q_peak_rad;
  const double shift = choice.chosen->q_rad - peak.value;
  const double half = peak.half_width();
  if (!std::isfinite(shift)) return {};
  const AxisScale scale = prefixed("rad", shift);
  std::string text = fmt::format(" Eq. (14) shifts the angle by {}", with_unit(shift, scale, 3));
  if (half > worth_saying * std::abs(shift) && std::isfinite(half)) {
    text += fmt::format("{} to ± {}",
                        half > std::abs(shift) ? ", but the peak itself is only known"
                                               : "; the peak itself is known",

                        with_unit(half, scale, 2));
  }
  return text + ".";
}

}  // namespace tribolog::figures
