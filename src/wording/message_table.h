#pragma once
// Internal to wording: the messages of templates/messages, by what they belong to.
//
//   # A comment. One that begins with "TRANSLATORS:" is for them, on the message in the next line.
//   fit.few_runs = {runs} run is too few           a code, and its English
//   fit.few_runs [runs] = {runs} runs are too few  below it: where {runs} is not one
//   fit.mass == {mass_kg:.6g} kg                   the same in every language
//
// A message names its values, each with the format of a number behind a colon. A list of statements
// has the text between two of them instead: "{reasons:; }".

#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/embedded_file.h"

namespace tribolog::wording {

struct Message {
  std::string_view one;
  std::string_view many;   ///< Empty unless a count decides.
  std::string_view count;  ///< The value that decides.
  bool is_the_same_everywhere{};
};
using MessageTable = std::unordered_map<std::string_view, Message>;  // by their codes

/// Texts are those of the files. @throw std::logic_error with file and line: a line is no message,
/// or a code has one already.
MessageTable read_messages(const std::vector<EmbeddedFile>& files);

/// Of this program.
const MessageTable& all_messages();

/// templates/messages, compiled into the program.
const std::vector<EmbeddedFile>& message_files();

}  // namespace tribolog::wording
