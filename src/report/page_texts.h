#pragma once
// Style and script as they stand in a page.

#include <string>

namespace tribolog::report {

/// What a page has beyond tables and figures.
enum class PageKind { plain, with_viewer, fleet };

/// The style sheet, with the page's own behind it.
const std::string& own_style(PageKind kind);

/// The script of the loop viewer without its indentation and its lines of comment.
const std::string& own_script();

}  // namespace tribolog::report
