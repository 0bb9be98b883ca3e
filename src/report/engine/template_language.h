#pragma once
// A template in another language: its texts are exchanged before the engine reads it.
//
// A message of a template is what stands between two tags that make a block of their own, with the
// marks inside it: `About <i>q</i><sub>peak</sub>, {{COUNT}} times`. So a translator sees whole
// sentences and can move their parts. Formulas (`<math>`) inside a sentence stand as `<math/>`.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog::report::engine {

/// Gives the translation of one message; "" to leave it as it is.
using TranslateMessage = std::function<std::string(const std::string& message)>;

/// The template with its messages and the attributes that are read (alt, aria-label, title)
/// exchanged. What is no text stays byte by byte.
/// @throw std::invalid_argument: a translation has other template markers, tags or formulas than
///        its message.
std::string template_in_language(std::string_view source, const TranslateMessage& translate);

/// The messages of a template, in the order in which they stand.
std::vector<std::string> messages_of_template(std::string_view source);

}  // namespace tribolog::report::engine
