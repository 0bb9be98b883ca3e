#pragma once
// What reviewers decided, on top of a finished report.

#include <string>
#include <vector>

namespace tribolog::report::document {

struct SignOff {
  std::string at_utc;
  std::string reviewer;
  bool is_approved{};
  std::string note;  ///< May be empty, and have several lines.
};

/// The report with the decisions ahead of its verdict: the last one in full, earlier ones folded.
/// All else stays as it is, byte by byte.
/// @param id of the archived calibration. @param decisions at least one, in their order.
/// @throw InputError: the text is no report of tribolog. @param file for its message.
std::string with_sign_off(const std::string& report, const std::string& id,
                          const std::vector<SignOff>& decisions, const std::string& file);

/// The report as it was before with_sign_off(); one that has no decisions as it is.
std::string without_sign_off(const std::string& report);

}  // namespace tribolog::report::document
