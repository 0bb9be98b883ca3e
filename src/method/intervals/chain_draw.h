#pragma once
// One resample of the whole chain: the stages' draws combined in the method's order.

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "method/intervals/bootstrap.h"
#include "method/intervals/loop_resample.h"
#include "method/intervals/parameter_resample.h"
#include "statistics/random_stream.h"

namespace tribolog::method::intervals {

/// The result of one resample. Vectors are in the order of the results that they belong to.
struct ChainDraw {
  double q_rough_rad{}, q_precise_rad{}, q_peak_rad{};
  double coulomb_Nm{};                ///< Of the rough sweep.
  std::vector<double> gravity_Nm;     ///< Per surrogate mass.
  std::vector<double> lugre;          ///< Shifts of the loop fit's readings or their logarithms.
  std::vector<double> other_Nm;       ///< Per independent gravity.
  std::vector<double> friction_Nm;    ///< Curve by curve, run by run.
  std::vector<double> rms_percent;    ///< Per curve; empty without a reference.
  double point_angle_shift_rad{};     ///< Of the point chosen.
  std::optional<std::size_t> choice;  ///< Of the paper's rule, among loop_points.
  ParameterDraw parameters;
};

class ChainResampler {
 public:
  /// @param results must outlive the resampler.
  explicit ChainResampler(const ChainResults& results);
  [[nodiscard]] ChainDraw draw(statistics::RandomStream& random) const;

 private:
  void draw_masses(statistics::RandomStream& random, const gravity::SweepShift& rough,
                   const LoopShift& loop, ChainDraw& draw) const;
  void draw_quality(const std::vector<double>& run_shifts, ChainDraw& draw) const;

  const ChainResults& results_;
  LoopResampler loop_;
  ParameterResampler parameters_;
};

}  // namespace tribolog::method::intervals
