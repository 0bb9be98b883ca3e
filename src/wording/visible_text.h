#pragma once
// Text that somebody else wrote, made safe to show: what cannot be seen becomes visible.

#include <string>
#include <string_view>

namespace tribolog::wording {

/// Valid UTF-8 in which nothing hides:
/// - bytes that are not UTF-8 become `\xNN`,
/// - control characters become `\xNN`, except tab and line feed,
/// - characters that turn the direction of text, and other invisible ones, as
///   is_hidden_character() says, become `[U+202E]`.
/// Markup is left as it is: the template engine escapes it for the place where it stands.
std::string visible_text(std::string_view text);

}  // namespace tribolog::wording
