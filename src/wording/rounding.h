#pragma once
// The program's rounding rules: an interval decides how many digits of an estimate mean anything.
//
// The half width is printed to two significant digits and the estimate to the same decimal place:
// 3.88318571 with a half width of 0.00431 reads "3.8832 ± 0.0043". No estimate gets more than
// seven significant digits; where the interval is narrower than the last of them, the half width
// reads "< 0.000001". Minus signs are U+2212. Nothing here depends on the locale.

#include <cstddef>
#include <string>

#include "statistics/estimate.h"

namespace tribolog::wording {

/// How an SI number is shown: `number * factor` in `unit`.
struct Scale {
  double factor{1.0};
  std::string unit;
};

/// An estimate as text, all parts rounded to the same decimal place and without the unit.
struct RoundedEstimate {
  std::string estimate;    ///< "3.8832"; "not identified" if the value is not finite.
  std::string half_width;  ///< "0.0043"; empty if there is no interval or it is lopsided.
  std::string low;         ///< Empty if there is no interval, or one too narrow to print.
  std::string high;
  [[nodiscard]] std::string plus_minus() const;  ///< "3.8832 ± 0.0043", or the estimate alone.
  [[nodiscard]] std::string range() const;       ///< "3.8789 … 3.8875"; empty without interval.
};

/// Whether a number in this unit is the computer's rounding and no result: below a thousandth of a
/// unit with the prefix µ or n, or a millionth of a per cent. It reads "0".
bool is_below_resolution(double number, const std::string& unit);

/// An interval counts as lopsided if its sides differ by more than a tenth of the half width.
RoundedEstimate round_by_interval(const statistics::Estimate& estimate, const Scale& scale);

/// "3.8832 ± 0.0043 N·m"; lopsided: "3.8832 N·m (3.8789 … 3.8899)".
std::string in_words(const statistics::Estimate& estimate, const Scale& scale);

/// A hyphen in front becomes U+2212; in front of a zero it goes.
std::string with_minus_sign(std::string digits);

/// A plus in front of a number above zero, of a change or a deviation; in front of a zero none.
std::string with_plus_sign(const std::string& number);

/// Decimal places that show `half_width` to two significant digits; negative: tens, hundreds.
int decimals_for(double half_width);

/// Fixed notation with that many decimals; negative decimals round to tens, hundreds...
/// "unknown" if the value is not finite; minus zero loses its sign.
std::string fixed(double value, int decimals);

/// So many significant digits, in fixed notation between 1e-6 and 1e9, else "1.2×10⁻⁹".
std::string significant(double value, int digits);

/// A number that was printed with an exponent, without one: "6e+02" is "600", a small one or one of
/// 1e9 and more "3.8×10⁻⁵". Others stay as they are.
std::string without_exponent(std::string printed);

/// Up to six significant digits and no zeros behind, for tables of the console: "−22.2263".
std::string six_digits(double value);

/// A number as somebody stated it, with up to ten significant digits and no zeros behind:
/// "100", "9.81".
std::string as_stated(double value);

/// Value and unit: "3.883 N·m", "22.2°" (no space before the degree sign).
std::string with_unit(const std::string& number, const std::string& unit);

/// Whole number, digits in groups of three: "120 000" (narrow no-break space).
std::string count(std::size_t value);

// Which unit a size is read in: engineering prefixes, so that numbers lie between 0.1 and 1000.

/// N·m, mN·m or µN·m for torques of about this size.
Scale torque_scale(double size_Nm);

/// rad, mrad or µrad for angles of about this size.
Scale radian_scale(double size_rad);

/// N·m·s/rad, mN·m·s/rad or µN·m·s/rad.
Scale viscous_scale(double size_Nms_rad);

/// N·m/rad, kN·m/rad or MN·m/rad for stiffnesses.
Scale stiffness_scale(double size_Nm_rad);

/// kg·m², g·m² or mg·m² for inertias.
Scale inertia_scale(double size_kgm2);

Scale degree_scale();                 ///< rad -> °
Scale plain_scale(std::string unit);  ///< SI as it is.

/// By the unit of a quantity of the verdict, for a value of about this size; torques of N·m may be
/// shown in amperes (torques_in.h), as by the scales above.
Scale quantity_scale(const std::string& unit, double size);

}  // namespace tribolog::wording
