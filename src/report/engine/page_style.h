#pragma once
// Style and script as they stand in a page, and what the head of every page has.

#include <string>
#include <string_view>
#include <vector>

#include "calibration/provenance.h"
#include "report/engine/template_engine.h"

namespace tribolog::report::engine {

/// What a page has beyond tables and figures.
enum class PageKind { plain, with_viewer, fleet, robot, comparison };

/// The style sheet, with the page's own behind it.
const std::string& own_style(PageKind kind);

/// Whether it is the style of such a page, alone or with the running head of printed pages.
bool is_own_style(std::string_view style);

/// The script of the loop viewer without its indentation and its lines of comment.
const std::string& own_script();

/// What the script says by itself: the texts of its calls t("...").
std::vector<std::string> script_messages();

/// Whether it is the script of one of the pages.
bool is_own_script(std::string_view script);

// Internal to the report: what the head of every page has.

/// fill_style(), and TOOL, CREATED and COMMAND_LINE from the provenance.
void fill_head(const calibration::Provenance& provenance, TemplateValues& values,
               PageKind kind = PageKind::plain);

/// CSS, the style of such a page, and CSP, the content security policy that allows it by its hash
/// and nothing else but pictures as data URIs. @param number of the document, on top of each
/// printed page; of it letters, digits and ". / _ -" are kept. Empty: pages have none.
void fill_style(TemplateValues& values, PageKind kind = PageKind::plain,
                const std::string& number = {});

/// On top of fill_head(): SCRIPT, that of the fleet's table or of the loop viewer, which the policy
/// allows by its hash.
void allow_script(TemplateValues& values, PageKind kind);

/// The same with the style of the loop viewer, and SCRIPT, its script, which the policy allows by
/// its hash too.
void fill_style_and_script(TemplateValues& values, const std::string& number = {});

}  // namespace tribolog::report::engine
