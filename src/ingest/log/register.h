#pragma once
// Columns of a drive's registers that were logged without their sign: 65528 for -8, or 1032 for -8
// in ten bits and a bit for the sign.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog::ingest::log {

/// How a register's numbers stand for signed ones.
struct Register {
  double modulus{};  ///< 2^16, say.
  bool
      has_sign_bit{};  ///< Half the modulus is the sign of what is below it; else two's complement.

  /// The signed number. @param logged as it stands in the log; others than its numbers are
  /// returned.
  [[nodiscard]] double value_of(double logged) const;
  friend bool operator==(const Register&, const Register&) = default;
};

/// "unsigned 16", "sign bit 15": as a manifest states it.
std::string to_string(const Register& of);
/// The register of that name. Nothing for any other.
std::optional<Register> register_named(std::string_view name);
/// "unsigned 8", "unsigned 16" and so on, for messages.
std::string register_names();

/// By the column's ends: whole numbers that jump between both ends of a register's range, and go on
/// without jumps as signed ones. @return nothing for a column without such jumps.
std::optional<Register> find_register(const std::vector<double>& values);

}  // namespace tribolog::ingest::log
