#pragma once
// Which contact the loops have, where LuGre leaves something that repeats: LuGre, elasto-plastic or
// Maxwell-slip, each fitted to the same rows.
//
//   elasto-plastic  T = s0 z + s1 dz/dt + rest,  dz/dt = w (1 - a(z, w) sgn(w) z / g(w))
//                   (friction/elasto_plastic.cpp)
//   Maxwell-slip    T = k x + sum of k_i P_i(x) + rest,  k, k_i >= 0: springs with sliders (stop
//                   operators) that slip at deflections spread evenly, on a logarithm, about the
//                   one at which LuGre slides; k is what never slips
//   rest            s2 w + J dw/dt, and G cos(q - q_peak) of each recording
//
// What happens before a loop has run through its travel twice depends on where its contact started
// and is not compared. A law is named only where its residuals are smaller than both others',
// beyond doubt (statistics/fit_comparison.h).

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "method/hysteresis/lugre_problem.h"

namespace tribolog::method::hysteresis {

enum class ContactLaw { lugre, elasto_plastic, maxwell_slip };

/// Stable: "maxwell_slip".
std::string to_string(ContactLaw law);

struct ContactCandidate {
  ContactLaw law{};
  double stiffness_Nm_rad{};  ///< Just after a reversal.
  /// Torque at which it slides; of Maxwell-slip without what never slips in the loops.
  double static_Nm{};
  double residual_Nm{};  ///< Rms over the rows compared.
};

struct ContactComparison {
  std::vector<ContactCandidate> candidates;  ///< LuGre first; empty: none were compared.
  std::optional<ContactLaw> winner;

  /// @return nullptr: it was not compared
  [[nodiscard]] const ContactCandidate* find(ContactLaw law) const;
};

/// @param problem of the same loops, a row of it a sample.
/// @param block_of_row of its rows: half loops.
/// @param lugre the solution for LuGre. @param systematic_Nm what it leaves beside noise, rms.
ContactComparison compare_contacts(const std::vector<LuGreInput>& loops,
                                   const LuGreProblem& problem,
                                   const std::vector<std::size_t>& block_of_row,
                                   const LuGrePoint& lugre, double systematic_Nm, double gear_ratio,
                                   double q_peak_rad);

}  // namespace tribolog::method::hysteresis
