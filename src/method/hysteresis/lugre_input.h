#pragma once
// One recording as the LuGre fit takes it: what was measured, and the motion that the model is
// driven along. A joint moved along a sine has its harmonics; one that a torque drives has the
// spline through its angle.

#include <cstddef>
#include <memory>
#include <vector>

#include "joint/recording.h"
#include "method/motion/oscillation_motion.h"
#include "method/motion/traced_motion.h"
#include "simulate/motion.h"

namespace tribolog {

struct LuGreInput {
  const Recording* recording{};
  const OscillationMotion* motion{};  ///< Fitted to it; unless `traced` is given.
  const TracedMotion* traced{};       ///< Taken instead where it is given.

  /// By the time since the recording's first sample.
  [[nodiscard]] std::shared_ptr<const Motion> motor_motion(double gear_ratio) const;
  [[nodiscard]] double frequency_Hz() const;
  [[nodiscard]] double centre_rad() const;
  /// Half loop of each sample, counted from 0: half cycles of the frequency, or the strokes between
  /// the turns of the angle. Residuals of a misfitted loop hang together within one.
  [[nodiscard]] std::vector<std::size_t> half_loops() const;
};

}  // namespace tribolog
