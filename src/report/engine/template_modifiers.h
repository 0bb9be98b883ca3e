#pragma once
// What the templates print without the engine's escaping, each checked here instead.
//
// `{{PNG:x-png}}` base64 text -> a data URI of an image; anything else -> an empty picture.
// `{{CSV:x-csv}}`   any text -> a data URI to save.
// `{{JSON:x-json}}` JSON for a `<script type="application/json">`: `<`, `>`, `&`, U+2028 and U+2029
//                   become \uXXXX, which JSON reads back as the same text.
// `{{CSS:x-css}}`   the embedded style sheet, with or without that of the loop viewer, and no other
//                   text.
// `{{SCRIPT:x-script}}` the script of the loop viewer, and no other text.
// `{{TEXT:x-dates}}` escaped text in which no line breaks within a date.
// `{{TEXT:x-symbols}}` the same, and symbols of one letter get their index: `q_peak`, `T_c`, `δ_a`.
//                   Words (`constant_speed`) and file names (`a_b.csv`) stay as they are.

#include <string>
#include <string_view>

namespace tribolog::report::engine {

/// Makes the modifiers known to the engine; may be called more than once.
void register_template_modifiers();

/// JSON as it may stand inside a script element.
std::string json_for_script(const std::string& json);

/// Escaped for HTML; each date, as "2026-01-31", is an element that no line breaks.
std::string html_with_dates(std::string_view text);

/// The same, with symbols of one letter and an index set as such. Directly behind “ or „
/// stands a name, which stays as it is.
std::string html_with_symbols(std::string_view text);

}  // namespace tribolog::report::engine
