#pragma once
// Remarks that a reader pinned to points of the loops in the viewer of a report.

#include <string>
#include <vector>

namespace tribolog::cli {

struct Remark {
  std::string place;  ///< "cw_loop.csv, t = 3.2 s, q = 26.4102°, T = 3.41 N·m"
  std::string text;
};

/// The number of the report that this page is, to which its viewer's remarks belong; empty: it has
/// no viewer. @param file for messages. @throw InputError: the page was changed.
std::string report_number(const std::string& page, const std::string& file);

/// As the viewer saved them; at least one.
/// @param report number of the report under review.
/// @throw InputError: no such file, no JSON of remarks, or those on another report.
std::vector<Remark> read_remarks(const std::string& path, const std::string& report);

}  // namespace tribolog::cli
