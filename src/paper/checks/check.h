#pragma once
// One line that a reader can tick off: what is expected, what the program gets, and how far apart
// the two may be.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "wording/tr.h"

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
  /// Where what is found is no number: as words, and whether it is what is expected.
  std::string expected_words;
  std::string ours_words;
  bool is_as_expected{};

  [[nodiscard]] bool is_words() const { return !expected_words.empty(); }
  [[nodiscard]] double difference() const { return ours - expected; }
  /// False also where `ours` is not a number.
  [[nodiscard]] bool holds() const {
    if (is_words()) return is_as_expected;
    return std::abs(difference()) <= bound;
  }
};

using Checks = std::vector<Check>;

/// Torques of some newton metres whose parts are each rounded; angles are logged to 1e-16 rad.
inline constexpr double log_rounding_Nm = 1e-9;
inline constexpr const char* rounding_of_log = wording::to_translate("rounding of the log");

/// A check whose expected value the paper prints with so many decimals.
inline Check printed_value(std::string what, double expected, int places, double ours, double bound,
                           std::string unit, std::string reason) {
  return {std::move(what),   Origin::printed, expected, ours, bound, std::move(unit),
          std::move(reason), places,          "",       "",   false};
}

/// A difference that the law says is zero.
inline Check vanishing(std::string what, double ours, double bound, std::string unit,
                       std::string reason) {
  return {std::move(what),   Origin::law, 0.0, ours, bound, std::move(unit),
          std::move(reason), -1,          "",  "",   false};
}

inline Check law_value(std::string what, double expected, double ours, double bound,
                       std::string unit, std::string reason) {
  return {std::move(what),   Origin::law, expected, ours, bound, std::move(unit),
          std::move(reason), -1,          "",       "",   false};
}

inline Check reconstructed_value(std::string what, double expected, int places, double ours,
                                 double bound, std::string unit, std::string reason) {
  return {std::move(what),
          Origin::reconstructed,
          expected,
          ours,
          bound,
          std::move(unit),
          std::move(reason),
          places,
          "",
          "",
          false};
}

/// Names and signs, the same in every language: they must be equal.
inline Check by_name(std::string what, Origin origin, std::string expected, std::string ours) {
  const bool is_same = expected == ours;
  return {std::move(what),     origin,          0,      0, 0, "", "", -1,
          std::move(expected), std::move(ours), is_same};
}

/// What is so, or is not: in words for either.
inline Check in_words(std::string what, Origin origin, bool is_so, std::string expected,
                      std::string otherwise) {
  std::string ours = is_so ? expected : std::move(otherwise);
  return {std::move(what),     origin,          0,    0, 0, "", "", -1,
          std::move(expected), std::move(ours), is_so};
}

}  // namespace tribolog::paper::checks
