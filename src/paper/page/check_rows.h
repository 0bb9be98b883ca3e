#pragma once
// Internal to the report: checks as the rows of a table.

#include <string>

#include "paper/checks/check.h"
#include "report/template_engine.h"

namespace tribolog::paper::page {

/// A check's numbers, rounded so that the difference against what is allowed can be seen.
struct CheckTexts {
  std::string expected;
  std::string origin;  ///< "print", "method" or "law"
  std::string ours;
  std::string difference;
  std::string allowed;
};

CheckTexts check_texts(const checks::Check& check);

/// check_table.tpl at the marker.
/// @param id of the table in the page, without the "table-" in front.
void fill_checks(const checks::Checks& checks, const std::string& id, const std::string& caption,
                 const std::string& marker, report::TemplateValues& values);

/// ✓ or ✗
std::string tick(bool is_well);

}  // namespace tribolog::paper::page
