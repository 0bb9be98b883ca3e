#pragma once
// The joints of a robot side by side: quantities, and friction at common speeds, each with its
// interval and verdict.

#include <string>
#include <vector>

#include "report/document/robot_page.h"
#include "report/elements/elements.h"

namespace tribolog::report::document {

struct MatrixCell {
  std::string text;                                      ///< "3.8832 ± 0.0043", in the row's unit.
  elements::Outcome outcome{elements::Outcome::absent};  ///< Absent: not identified, not asked for.
  std::string verdict_word;                              ///< Empty of an absent one.
  std::string change;                                    ///< Since the last calibration.
  std::string change_word;
  bool is_changed{};
};

struct MatrixRow {
  std::string words;
  std::string unit;               ///< The same in all cells, with its prefix.
  std::vector<MatrixCell> cells;  ///< One for each joint.
};

/// Rows of which no joint has anything are left out.
/// @param joints in the page's order; of a refused one all cells are absent.
std::vector<MatrixRow> robot_matrix(const std::vector<RobotJoint>& joints);

}  // namespace tribolog::report::document
