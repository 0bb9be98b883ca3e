#pragma once
// The models that a viscous curve may follow, from the simplest on, and the terms that each may
// have besides.
//
//   Coulomb                 |Tf| = Tc
//   Coulomb and viscous     |Tf| = Tc + c w
//   Coulomb and power law   |Tf| = Tc + cv w^p
//   Stribeck (Gauss)        |Tf| = Tc + (Ts - Tc) exp(-(w/ws)^2) + c w
//   Waiboer, eq. (6)        |Tf| = Ta exp(-(w/ws)^da) + cv w^(1 - dv)
//
// Further terms, d = +1 for a rising joint angle and -1 for a falling one:
//   asymmetry               + A d, or + A d + B d w^p with the power of the law's viscous term
//   load                    + L |cos(q - q_peak)|
//
// All are linear in all but one to three shape parameters (p; ws; ws, da and p): fits separate the
// two kinds.

#include <string>

namespace tribolog {

enum class CurveLaw { coulomb, coulomb_viscous, power_viscous, stribeck, waiboer };
enum class Asymmetry { none, coulomb, coulomb_viscous };

inline constexpr CurveLaw curve_laws[] = {CurveLaw::coulomb, CurveLaw::coulomb_viscous,
                                          CurveLaw::power_viscous, CurveLaw::stribeck,
                                          CurveLaw::waiboer};

struct CurveModel {
  CurveLaw law{CurveLaw::coulomb};
  Asymmetry asymmetry{Asymmetry::none};
  bool load{false};

  [[nodiscard]] int shape_parameters() const;
  [[nodiscard]] int linear_parameters() const;
  [[nodiscard]] int parameters() const { return shape_parameters() + linear_parameters(); }
};

/// "coulomb_viscous", for results.
std::string to_string(CurveLaw law);
/// "none", "coulomb", "coulomb_viscous"
std::string to_string(Asymmetry asymmetry);
/// "Coulomb and viscous"
std::string in_words(CurveLaw law);
/// "Coulomb and viscous, with Coulomb friction of each direction and load"
std::string in_words(const CurveModel& model);

}  // namespace tribolog
