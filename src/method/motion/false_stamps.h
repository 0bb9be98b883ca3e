#pragma once
// Time stamps of writing in place of sampling: a drive that samples evenly, and a logger that
// stamps each row when it gets round to it. Speeds from such stamps scatter, and so does where a
// reversal lies. The angle shows it: while the joint moves, it is smooth over the time of its
// sampling, and rough over any other.
//
// Such stamps are replaced by the even clock that runs through them; samples that were lost stay
// lost. A clock that scatters as its samples did is left as it is.

#include <cstddef>
#include <string>
#include <vector>

#include "joint/recording.h"

namespace tribolog::method::motion {

struct FalseStamps {
  std::size_t replaced{};  ///< Stamps, in all recordings.
  double worst_percent{};  ///< Their scatter about the even clock, of its interval [%].
  std::string recording;   ///< The recording with that scatter.
  double interval_s{};     ///< Of the even clock there.
};

/// @param recordings modified where their stamps are false.
bool has_false_stamps(const joint::Recording& recording);

FalseStamps replace_false_stamps(std::vector<joint::Recording>& recordings);

}  // namespace tribolog::method::motion
