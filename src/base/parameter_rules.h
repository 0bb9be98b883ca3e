#pragma once
// Rules that physical parameters obey, with one wording for what breaks them.

namespace tribolog {

/// @throw std::invalid_argument "<what> <value> <unit> is not allowed; it must be > 0"
void require_positive(double value, const char* what, const char* unit);

/// @throw std::invalid_argument "<what> <value> <unit> is not allowed; it must be >= 0"
void require_not_negative(double value, const char* what, const char* unit);

/// @throw std::invalid_argument "<lower> <value> <unit> exceeds <upper> <value> <unit>; it must not
/// be larger"
void require_not_above(double value, const char* lower, double bound, const char* upper,
                       const char* unit);

}  // namespace tribolog
