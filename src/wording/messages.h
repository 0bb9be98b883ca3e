#pragma once
// Internal to wording: what the tables of messages consist of.
//
// A message is English and names its values, each with the format of a number behind a colon:
// "the directions share {share:.0f} % of their angles". A list of statements has the text between
// two of them instead: "{reasons:; }". text() and by_count() are where xgettext finds messages.

#include <string_view>
#include <vector>

namespace tribolog::wording {

struct Message {
  std::string_view one;
  std::string_view many;   ///< Empty unless a count decides.
  std::string_view count;  ///< The value that decides.
  bool is_the_same_everywhere{};
};

constexpr Message text(std::string_view message) { return {message, {}, {}}; }

/// Punctuation alone, which no translator needs to see.
constexpr Message values_alone(std::string_view message) { return {message, {}, {}, true}; }

/// Of one, or of another number of what `count` names.
constexpr Message by_count(std::string_view count, std::string_view one, std::string_view many) {
  return {one, many, count};
}

struct CodedMessage {
  std::string_view code;
  Message message;
};
using Messages = std::vector<CodedMessage>;

// The tables, by what is spoken of.
const Messages& general_messages();
const Messages& check_messages();
const Messages& gravity_messages();
const Messages& hysteresis_messages();
const Messages& viscous_messages();
const Messages& selection_messages();
const Messages& model_messages();
const Messages& friction_messages();
const Messages& verdict_messages();
const Messages& history_messages();
const Messages& plan_messages();
const Messages& study_messages();
const Messages& reading_messages();
const Messages& drawing_messages();

}  // namespace tribolog::wording
