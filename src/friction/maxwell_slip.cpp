#include "friction/maxwell_slip.h"

#include <cmath>

#include "base/requirements.h"
#include "base/statement.h"

namespace tribolog::friction {

// Element j slips at the deflection x_j = j/count xs. The curve's slope between two slips is the
// sum of the stiffnesses of those that still stick.
std::vector<MaxwellElement> maxwell_elements(double stiffness_Nm_rad, double static_Nm, int count) {
  require_positive(stiffness_Nm_rad, "stiffness", "N·m/rad");
  require_positive(static_Nm, "static torque", "N·m");
  if (count < 1) {
    throw Refusal({"maxwell_slip.number_below_one", {{"elements", count}}});
  }
  const double last = (2 - 1.0 / count) * static_Nm / stiffness_Nm_rad;
  const auto virgin = [&](int j) {
    const double left = 1 - static_cast<double>(j) / count;
    return static_Nm * (1 - left * left);
  };
  const double piece = last / count;
  std::vector<MaxwellElement> elements;
  for (int j = 1; j <= count; ++j) {
    const double slope = (virgin(j) - virgin(j - 1)) / piece;
    const double next = j == count ? 0.0 : (virgin(j + 1) - virgin(j)) / piece;
    const double stiffness = slope - next;
    elements.push_back({stiffness, stiffness * piece * j / static_Nm});
  }
  return elements;
}

void require_maxwell_elements(const std::vector<MaxwellElement>& elements) {
  if (elements.empty()) throw Refusal({"maxwell_slip.no_element"});
  double sum = 0;
  for (const MaxwellElement& one : elements) {
    require_positive(one.stiffness_Nm_rad, Code{"parameter.element_stiffness"}, "N·m/rad");
    require_positive(one.share, Code{"parameter.element_share"}, "");
    sum += one.share;
  }
  constexpr double rounding = 1e-9;
  if (!(std::abs(sum - 1) < rounding)) {
    throw Refusal({"maxwell_slip.shares_not_one", {{"sum", sum}}});
  }
}

}  // namespace tribolog::friction
