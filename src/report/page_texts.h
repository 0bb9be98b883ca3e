#pragma once
// Style and script as they stand in a page.

#include <string>
#include <vector>

namespace tribolog::report {

/// What a page has beyond tables and figures.
enum class PageKind { plain, with_viewer, fleet };

/// The style sheet, with the page's own behind it.
const std::string& own_style(PageKind kind);

/// The script of the loop viewer without its indentation and its lines of comment.
const std::string& own_script();

/// What the script says by itself: the texts of its calls t("...").
std::vector<std::string> script_messages();

}  // namespace tribolog::report
