#pragma once
// One line that a reader can tick off: what is expected, what the program gets, and how far apart
// the two may be.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace tribolog::paper::checks {

/// Where the expected value comes from.
enum class Origin {
  printed,        ///< It stands in the paper.
  reconstructed,  ///< Not printed; of the LuGre joint that reproduces the paper's table 2.
  law,            ///< It follows from the equation, or from mechanics.
};

struct Check {
  std::string what;
  Origin origin{Origin::law};
  double expected{};
  double ours{};
  double bound{};          ///< Largest |ours - expected| that counts as agreement.
  std::string unit;        ///< Of all three.
  std::string reason;      ///< Why the bound is what it is; empty where it is 0.
  int printed_places{-1};  ///< Decimals that the paper prints `expected` with; -1: it does not.
  /// Where words are compared and not numbers: they must be equal.
  std::string expected_words;
  std::string ours_words;

  [[nodiscard]] bool is_words() const { return !expected_words.empty(); }
  [[nodiscard]] double difference() const { return ours - expected; }
  /// False also where `ours` is not a number.
  [[nodiscard]] bool holds() const {
    if (is_words()) return expected_words == ours_words;
    return std::abs(difference()) <= bound;
  }
};

using Checks = std::vector<Check>;

/// Torques of some newton metres whose parts are each rounded; angles are logged to 1e-16 rad.
inline constexpr double log_rounding_Nm = 1e-9;
inline constexpr const char* rounding_of_log = "rounding of the log";

/// A check whose expected value the paper prints with so many decimals.
inline Check printed_value(std::string what, double expected, int places, double ours, double bound,
                           std::string unit, std::string reason) {
  return {std::move(what), Origin::printed,   expected, ours, bound,
          std::move(unit), std::move(reason), places,   "",   ""};
}

/// A difference that the law says is zero.
inline Check vanishing(std::string what, double ours, double bound, std::string unit,
                       std::string reason) {
  return {std::move(what), Origin::law,       0.0, ours, bound,
          std::move(unit), std::move(reason), -1,  "",   ""};
}

inline Check law_value(std::string what, double expected, double ours, double bound,
                       std::string unit, std::string reason) {
  return {std::move(what), Origin::law,       expected, ours, bound,
          std::move(unit), std::move(reason), -1,       "",   ""};
}

inline Check reconstructed_value(std::string what, double expected, int places, double ours,
                                 double bound, std::string unit, std::string reason) {
  return {std::move(what), Origin::reconstructed, expected, ours, bound,
          std::move(unit), std::move(reason),     places,   "",   ""};
}

inline Check in_words(std::string what, Origin origin, std::string expected, std::string ours) {
  return {std::move(what), origin, 0, 0, 0, "", "", -1, std::move(expected), std::move(ours)};
}

}  // namespace tribolog::paper::checks
