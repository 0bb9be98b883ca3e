#pragma once
// The quantities of a calibration that have intervals: their closed form, and their value in a
// resample.
//
// Which of the two is stated was decided by coverage over 200 seeds of the paper's joint with the
// noise of a real drive, without and with ripple (tests/identify/interval_coverage_test.cpp): the
// closed form wherever its coverage is sufficient, for it is cheaper and has no random error;
// resampling where it is not or where there is no closed form. With ripple at a single position the
// closed forms of the curve's parameters mistake the common error of gravity for scatter of the
// runs, and are up to fifty times too wide.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "method/intervals/chain_draw.h"

namespace tribolog::method::intervals {

struct ChainQuantity {
  std::string name;
  double value{};
  std::optional<statistics::Estimate> closed_form;
  bool bootstrap_is_stated{};
  bool is_root_mean_square{};  ///< See root_mean_square_interval().
  std::function<double(const ChainDraw&)> of;
};

std::vector<ChainQuantity> chain_quantities(const ChainResults& results);

}  // namespace tribolog::method::intervals
