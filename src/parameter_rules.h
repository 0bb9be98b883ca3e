#pragma once
// Rules that physical parameters obey, with one wording for what breaks them.

namespace tribolog {

/// @throw std::invalid_argument "<what> <value> <unit> is not allowed; it must be > 0"
void require_positive(double value, const char* what, const char* unit);

/// @throw std::invalid_argument "<what> <value> <unit> is not allowed; it must be >= 0"
void require_not_negative(double value, const char* what, const char* unit);

}  // namespace tribolog
