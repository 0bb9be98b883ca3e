#include "method/intervals/chain_draw.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "method/intervals/sweep_resample.h"
#include "statistics/distributions.h"
#include "statistics/random_stream.h"

namespace tribolog::method::intervals {
namespace {

using hysteresis::Estimator;
using hysteresis::point_index;

/// Torque shift of an estimator that reads the loop; nothing for others.
std::optional<double> loop_shift(Estimator estimator, const LoopShift& loop) {
  if (estimator == Estimator::midline) return loop.midline_Nm;
  if (estimator == Estimator::fit) return loop.fit_gravity_Nm;
  if (const auto point = point_index(estimator)) return loop.points_Nm[*point];
  if (const auto pair = hysteresis::points_of_pair(estimator)) {
    return (loop.steady_points_Nm[*point_index(pair->first)] +
            loop.steady_points_Nm[*point_index(pair->second)]) /
           2;
  }
  return std::nullopt;
}

}  // namespace

ChainResampler::ChainResampler(const ChainResults& results)
    : results_(results),
      loop_(results.loop, results.rough.ripple),
      parameters_(results.viscous, results.friction) {}

void ChainResampler::draw_masses(statistics::RandomStream& random, const gravity::SweepShift& rough,
                                 const LoopShift& loop, ChainDraw& draw) const {
  const double q_peak = results_.q_peak_rad ? results_.q_peak_rad->value : 0.0;
  // Whether an offset is the torque's or the friction's is the same for all.
  const double ambiguity = random.normal() < 0 ? -1.0 : 1.0;
  for (const hysteresis::SurrogateMass& mass : results_.masses.masses) {
    if (mass.estimator == Estimator::sweep) {
      draw.gravity_Nm.push_back(mass.gravity_Nm.value + rough.gravity_Nm);
      continue;
    }
    const std::optional<double> shift = loop_shift(mass.estimator, loop);
    if (!shift) {
      draw.gravity_Nm.push_back(mass.gravity_Nm.value + mass.gravity_Nm.half_width() /
                                                            statistics::normal_975 *
                                                            random.normal());
      continue;
    }
    double cosine = mass.mean_cosine;
    if (results_.q_peak_rad) {
      cosine *= std::cos(mass.q_rad - draw.q_peak_rad) / std::cos(mass.q_rad - q_peak);
    }
    const double offset = mass.offset.value_Nm + mass.offset.share * rough.offset_Nm +
                          mass.offset.ambiguity_Nm * ambiguity;
    draw.gravity_Nm.push_back((mass.torque_Nm.value + *shift - offset) / cosine);
  }
}

void ChainResampler::draw_quality(const std::vector<double>& run_shifts, ChainDraw& draw) const {
  const selection::QualityErrorsResult& quality = results_.quality;
  const std::vector<viscous::ConstantSpeedRun>& runs = results_.viscous.runs;
  if (quality.errors.empty()) return;
  const bool by_directions = quality.reference == selection::CurveReference::direction_difference;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < quality.errors.size(); ++c) {
    double squares = 0;
    double count = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (!std::isfinite(quality.errors[c].percent[i])) continue;
      double reference = quality.reference_Nm[i];
      if (by_directions && runs[i].partner >= 0) {
        reference += (run_shifts[i] - run_shifts[static_cast<std::size_t>(runs[i].partner)]) / 2;
      }
      const double error = 100 * (draw.friction_Nm[c * runs.size() + i] - reference) /
                           (runs[i].torque_Nm + run_shifts[i]);
      squares += error * error;
      count += 1;
    }
    draw.rms_percent.push_back(count > 0 ? std::sqrt(squares / count)
                                         : std::numeric_limits<double>::quiet_NaN());
    const auto point = point_index(quality.errors[c].estimator);
    if (point && draw.rms_percent.back() < smallest) {
      smallest = draw.rms_percent.back();
      draw.choice = point;
    }
  }
}

ChainDraw ChainResampler::draw(statistics::RandomStream& random) const {
  ChainDraw draw;
  const gravity::SweepShift rough = resample_sweep(random, results_.rough_sweep);
  const gravity::SweepShift precise =
      resample_precise_sweep(random, results_.precise_sweep, results_.rough.ripple, rough);
  draw.q_rough_rad = results_.rough.q_peak_rad.value + rough.q_peak_rad;
  draw.q_precise_rad = results_.precise.q_peak_rad.value + precise.q_peak_rad;
  const double q_shift = results_.q_peak_source == gravity::PeakSource::precise_sweep
                             ? precise.q_peak_rad
                             : rough.q_peak_rad;
  draw.q_peak_rad = results_.q_peak_rad ? results_.q_peak_rad->value + q_shift : 0.0;
  if (results_.rough.coulomb_Nm) {
    draw.coulomb_Nm = results_.rough.coulomb_Nm->value + rough.coulomb_Nm;
  }
  const LoopShift loop = loop_.draw(random);
  draw.lugre = loop.lugre;
  draw_masses(random, rough, loop, draw);
  for (const selection::IndependentGravity& way : results_.independent.gravity) {
    const std::vector<double> counts = statistics::centred_counts(random, way.block_shifts.size());
    double shift = 0;
    for (std::size_t b = 0; b < counts.size(); ++b) shift += counts[b] * way.block_shifts[b];
    const double further = way.further_half_width_Nm / statistics::normal_975 * random.normal();
    draw.other_Nm.push_back(way.gravity_Nm.value + further +
                            statistics::few_blocks_scale(random, way.freedom) * shift);
  }

  const std::vector<double> run_shifts = resample_runs(random, results_.curves);
  const std::vector<viscous::ConstantSpeedRun>& runs = results_.viscous.runs;
  const auto& masses = results_.masses.masses;
  draw.friction_Nm.reserve(results_.viscous.curves.size() * runs.size());
  for (std::size_t c = 0; c < results_.viscous.curves.size(); ++c) {
    const double gravity = masses[c].gravity_Nm.value;
    const double change = draw.gravity_Nm[c] - gravity;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      draw.friction_Nm.push_back(results_.viscous.curves[c].friction_Nm[i] + run_shifts[i] -
                                 change * runs[i].mean_cos - gravity * runs[i].mean_sin * q_shift);
    }
    if (results_.viscous.curves[c].estimator == results_.friction.curve) {
      draw.parameters = parameters_.draw(random, change, q_shift, gravity);
    }
  }
  draw_quality(run_shifts, draw);
  if (draw.choice) draw.point_angle_shift_rad = loop.angle_rad[*draw.choice];
  return draw;
}

}  // namespace tribolog::method::intervals
