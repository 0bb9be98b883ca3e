#pragma once
// Style and script as they stand in a page.

#include <string>

namespace tribolog::report {

/// The style sheet, with that of the loop viewer behind it or without.
const std::string& own_style(bool with_viewer);

/// The script of the loop viewer without its indentation and its lines of comment.
const std::string& own_script();

}  // namespace tribolog::report
