#include "method/viscous/curve_model.h"

namespace tribolog {

int CurveModel::shape_parameters() const {
  switch (law) {
    case CurveLaw::coulomb:
    case CurveLaw::coulomb_viscous:
      return 0;
    case CurveLaw::power_viscous:
    case CurveLaw::stribeck:
      return 1;
    case CurveLaw::waiboer:
      break;
  }
  return 3;
}

int CurveModel::linear_parameters() const {
  const int of_law = law == CurveLaw::coulomb ? 1 : law == CurveLaw::stribeck ? 3 : 2;
  const int of_direction = asymmetry == Asymmetry::none      ? 0
                           : asymmetry == Asymmetry::coulomb ? 1
                                                             : 2;
  return of_law + of_direction + (load ? 1 : 0);
}

std::string to_string(CurveLaw law) {
  switch (law) {
    case CurveLaw::coulomb:
      return "coulomb";
    case CurveLaw::coulomb_viscous:
      return "coulomb_viscous";
    case CurveLaw::power_viscous:
      return "power_viscous";
    case CurveLaw::stribeck:
      return "stribeck";
    case CurveLaw::waiboer:
      break;
  }
  return "waiboer";
}

std::string to_string(Asymmetry asymmetry) {
  switch (asymmetry) {
    case Asymmetry::none:
      return "none";
    case Asymmetry::coulomb:
      return "coulomb";
    case Asymmetry::coulomb_viscous:
      break;
  }
  return "coulomb_viscous";
}

std::string in_words(CurveLaw law) {
  switch (law) {
    case CurveLaw::coulomb:
      return "Coulomb";
    case CurveLaw::coulomb_viscous:
      return "Coulomb and viscous";
    case CurveLaw::power_viscous:
      return "Coulomb and power-law viscous";
    case CurveLaw::stribeck:
      return "Stribeck and viscous";
    case CurveLaw::waiboer:
      break;
  }
  return "Waiboer, eq. (6)";
}

std::string in_words(const CurveModel& model) {
  std::string words = in_words(model.law);
  if (model.asymmetry == Asymmetry::coulomb) words += ", Coulomb friction of each direction";
  if (model.asymmetry == Asymmetry::coulomb_viscous) {
    words += ", Coulomb and viscous friction of each direction";
  }
  if (model.load) words += ", growing with the load";
  return words;
}

}  // namespace tribolog
