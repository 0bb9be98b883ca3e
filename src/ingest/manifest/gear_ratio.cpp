#include "ingest/manifest/gear_ratio.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "base/closest_match.h"

namespace tribolog::ingest::manifest {
namespace {

std::optional<double> positive_number(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return std::nullopt;
  text = text.substr(first, text.find_last_not_of(' ') + 1 - first);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  const bool is_number = read.ec == std::errc() && read.ptr == end && std::isfinite(value);
  return is_number && value > 0 ? std::optional(value) : std::nullopt;
}

[[noreturn]] void refuse(std::string_view text) {
  throw std::invalid_argument(fmt::format(
      "{} is no gear ratio, expected motor angle / joint angle: 101 or 101:1", in_quotes(text)));
}

}  // namespace

double parse_gear_ratio(std::string_view text) {
  const std::size_t colon = text.find(':');
  const auto motor = positive_number(text.substr(0, colon));
  if (!motor) refuse(text);
  if (colon == std::string_view::npos) return *motor;
  const auto joint = positive_number(text.substr(colon + 1));
  if (!joint) refuse(text);
  if (*motor < *joint) {
    throw std::invalid_argument(fmt::format(
        "{} would make the joint turn faster than the motor, expected turns of the motor first: "
        "did you mean '{:g}:{:g}'? A gear that speeds up is stated as one number, {:.6g}",
        in_quotes(text), *joint, *motor, *motor / *joint));
  }
  return *motor / *joint;
}

}  // namespace tribolog::ingest::manifest
