#include "paper/checks/check.h"

namespace tribolog::paper::checks {

namespace {

Check number(Kind kind, std::string what, double expected, int places, double ours, double bound,
             std::string unit, std::string reason) {
  return {
      std::move(what), kind, expected, ours, as_shown(bound), std::move(unit), std::move(reason),
      places,          "",   "",       false};
}

}  // namespace

std::optional<double> Check::in_last_places() const {
  if (is_words() || printed_places < 0) return std::nullopt;
  return difference() * std::pow(10.0, printed_places);
}

double as_shown(double bound) {
  constexpr int digits = 3;
  if (!(bound > 0) || !std::isfinite(bound)) return bound;
  const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(bound)));
  const double unit = std::pow(10.0, std::abs(decimals));
  return decimals >= 0 ? std::round(bound * unit) / unit : std::round(bound / unit) * unit;
}

Check printed_value(std::string what, double expected, int places, double ours, double bound,
                    std::string unit, std::string reason) {
  return number(Kind::print, std::move(what), expected, places, ours, bound, std::move(unit),
                std::move(reason));
}

Check vanishing(std::string what, double ours, double bound, std::string unit, std::string reason) {
  return number(Kind::independent, std::move(what), 0, -1, ours, bound, std::move(unit),
                std::move(reason));
}

Check other_way(std::string what, double expected, double ours, double bound, std::string unit,
                std::string reason) {
  return number(Kind::independent, std::move(what), expected, -1, ours, bound, std::move(unit),
                std::move(reason));
}

Check known_value(std::string what, double expected, int places, double ours, double bound,
                  std::string unit, std::string reason) {
  return number(Kind::independent, std::move(what), expected, places, ours, bound, std::move(unit),
                std::move(reason));
}

Check by_name(std::string what, Kind kind, std::string expected, std::string ours) {
  const bool is_same = expected == ours;
  return {std::move(what), kind,   0, 0, 0, "", "", -1, std::move(expected),
          std::move(ours), is_same};
}

Check in_words(std::string what, Kind kind, bool is_so, std::string expected,
               std::string otherwise) {
  std::string ours = is_so ? expected : std::move(otherwise);
  return {std::move(what), kind, 0, 0, 0, "", "", -1, std::move(expected), std::move(ours), is_so};
}

}  // namespace tribolog::paper::checks
