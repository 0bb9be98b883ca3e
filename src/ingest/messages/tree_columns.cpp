#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ingest/messages/message_tree.h"
#include "ingest/text/fields.h"

namespace tribolog::ingest::messages {
namespace {

using Kind = MessageTree::Kind;
using Names = std::vector<std::string_view>;

constexpr std::int64_t ns_per_s = 1'000'000'000;

// The time of a message.

template <std::size_t Count>
bool is_one_of(std::string_view key, const std::array<std::string_view, Count>& keys) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

constexpr std::array<std::string_view, 4> second_keys = {"sec", "secs", "seconds", "s"};
constexpr std::array<std::string_view, 7> nanosecond_keys = {
    "nanosec", "nsec", "nsecs", "nanosecs", "nanos", "nanoseconds", "ns"};

bool is_whole(double value, double bound) {
  return std::abs(value) < bound && std::floor(value) == value;
}

/// {"sec": 1, "nanosec": 500}: both of them, and nothing else.
std::optional<std::int64_t> stamp_of_parts(const MessageTree& message, std::size_t object) {
  std::optional<double> seconds;
  std::optional<double> nanoseconds;
  for (std::size_t i = object + 1; i < message.after(object); i = message.after(i)) {
    if (message.kind(i) != Kind::number) return std::nullopt;
    if (is_one_of(message.key(i), second_keys)) {
      seconds = message.number(i);
    } else if (is_one_of(message.key(i), nanosecond_keys)) {
      nanoseconds = message.number(i);
    } else {
      return std::nullopt;
    }
  }
  constexpr double most_seconds = 9e9;  // what nanoseconds in 64 bits hold
  if (!seconds || !nanoseconds || !is_whole(*seconds, most_seconds) ||
      !is_whole(*nanoseconds, 1e10)) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(*seconds) * ns_per_s + static_cast<std::int64_t>(*nanoseconds);
}

std::optional<std::int64_t> stamp_of_text(std::string_view text) {
  const auto time = text::read_iso_time(text);
  if (!time || std::abs(time->whole) > 9'000'000'000) return std::nullopt;
  return time->whole * ns_per_s + std::llround(time->rest * static_cast<double>(ns_per_s));
}

std::optional<std::int64_t> stamp_at(const MessageTree& message, std::size_t value) {
  if (message.kind(value) == Kind::object) return stamp_of_parts(message, value);
  if (message.kind(value) == Kind::text) return stamp_of_text(message.text(value));
  constexpr std::int64_t year_1973_ns = 100'000'000 * ns_per_s;  // a clock since boot shows less
  const std::int64_t time_ns = message.integer(value);
  if (time_ns >= year_1973_ns) return time_ns;
  return std::nullopt;
}

struct Stamp {
  std::int64_t time_ns{};
  std::size_t place{};  ///< Of the top-level field that says it.
};

std::optional<Stamp> stamp_of(const MessageTree& message) {
  const auto in = [&](std::size_t object, std::string_view key) -> std::optional<Stamp> {
    const auto value = message.member(object, key);
    if (!value) return std::nullopt;
    const auto time_ns = stamp_at(message, *value);
    return time_ns ? std::optional<Stamp>({*time_ns, object == 0 ? *value : object}) : std::nullopt;
  };
  const auto header = message.member(0, "header");
  std::optional<Stamp> stamp = header ? in(*header, "stamp") : std::nullopt;
  if (!stamp) stamp = in(0, "timestamp");
  if (!stamp) stamp = in(0, "stamp");
  if (!stamp && header) stamp = in(*header, "timestamp");
  return stamp ? stamp : in(0, "time");
}

// Names of elements.

bool are_different(Names names) {
  std::sort(names.begin(), names.end());
  return std::adjacent_find(names.begin(), names.end()) == names.end();
}

/// The texts of a list that has nothing but different ones.
std::optional<Names> different_texts(const MessageTree& message, std::size_t list) {
  if (message.kind(list) != Kind::array) return std::nullopt;
  Names names;
  for (std::size_t i = list + 1; i < message.after(list); i = message.after(i)) {
    if (message.kind(i) != Kind::text || message.text(i).empty()) return std::nullopt;
    names.push_back(message.text(i));
  }
  return are_different(names) ? std::optional(std::move(names)) : std::nullopt;
}

struct Naming {
  Names names;
  bool are_interfaces{};
};

std::optional<Naming> naming_of(const MessageTree& message, std::size_t object) {
  for (const char* const key : {"name", "names", "joint_names", "interface_names"}) {
    const auto list = message.member(object, key);
    if (!list) continue;
    if (auto names = different_texts(message, *list)) {
      return Naming{*std::move(names), key == std::string_view("interface_names")};
    }
  }
  return std::nullopt;
}

/// What the objects of an array are called, if each says so and no two say the same.
std::optional<Names> names_of_objects(const MessageTree& message, std::size_t array) {
  Names names;
  for (std::size_t i = array + 1; i < message.after(array); i = message.after(i)) {
    std::optional<std::size_t> name;
    for (const char* const key : {"name", "joint_name", "joint"}) {
      if (!name) name = message.member(i, key);
    }
    if (!name || message.kind(*name) != Kind::text || message.text(*name).empty()) {
      return std::nullopt;
    }
    names.push_back(message.text(*name));
  }
  return are_different(names) ? std::optional(std::move(names)) : std::nullopt;
}

std::size_t elements_of(const MessageTree& message, std::size_t array) {
  std::size_t count = 0;
  for (std::size_t i = array + 1; i < message.after(array); i = message.after(i)) ++count;
  return count;
}

/// Nested as deeply as the tree is, which is bounded.
class TreeWalk {
 public:
  TreeWalk(const MessageTree& message, MessageColumns& columns)
      : message_(message), columns_(columns) {}

  void take_value(std::size_t value, MessageColumns::Place* place) {
    switch (message_.kind(value)) {
      case Kind::number:
        return columns_.put(place, message_.number(value));
      case Kind::object:
        return take_members(value, std::nullopt, place);
      case Kind::array:
        return take_elements(value, place);
      case Kind::gap:
      case Kind::text:
        return;
    }
  }

  /// @param left_out one of them.
  void take_members(std::size_t object, std::optional<std::size_t> left_out,
                    MessageColumns::Place* place) {
    const std::optional<Naming> naming = naming_of(message_, object);
    for (std::size_t i = object + 1; i < message_.after(object); i = message_.after(i)) {
      if (i == left_out || message_.kind(i) == Kind::gap || message_.kind(i) == Kind::text)
        continue;
      MessageColumns::Place* const at = columns_.field(place, message_.key(i));
      if (message_.kind(i) == Kind::array) {
        take_array(i, naming, place, at);
      } else {
        take_value(i, at);
      }
    }
  }

 private:
  void take_array(std::size_t array, const std::optional<Naming>& naming,
                  MessageColumns::Place* parent, MessageColumns::Place* place) {
    const std::string_view key = message_.key(array);
    if (naming && naming->names.size() == elements_of(message_, array)) {
      const bool without_field = naming->are_interfaces || key == "interface_values";
      return take_named(array, naming->names, without_field ? "" : key, parent, place);
    }
    if (const auto names = names_of_objects(message_, array)) {
      return take_named(array, *names, "", parent, place);
    }
    take_elements(array, place);
  }

  void take_named(std::size_t array, const Names& names, std::string_view field,
                  MessageColumns::Place* parent, MessageColumns::Place* place) {
    std::size_t number = 0;
    for (std::size_t i = array + 1; i < message_.after(array); i = message_.after(i), ++number) {
      if (message_.kind(i) == Kind::gap || message_.kind(i) == Kind::text) continue;
      take_value(i, columns_.named_element(parent, place, names[number], field));
    }
  }

  void take_elements(std::size_t array, MessageColumns::Place* place) {
    if (elements_of(message_, array) > longest_unnamed_array) {
      const bool has_numbers = message_.kind(array + 1) != Kind::text;
      if (has_numbers) columns_.leave_out(place);
      return;
    }
    std::size_t number = 0;
    for (std::size_t i = array + 1; i < message_.after(array); i = message_.after(i), ++number) {
      if (message_.kind(i) == Kind::gap || message_.kind(i) == Kind::text) continue;
      take_value(i, columns_.element(place, number));
    }
  }

  const MessageTree& message_;
  MessageColumns& columns_;
};

class TreeReader : public MessageReader {
 public:
  explicit TreeReader(std::unique_ptr<TreeDecoder> decoder) : decoder_(std::move(decoder)) {}

  std::optional<std::int64_t> take_row(std::string_view message, MessageColumns& columns) override {
    tree_.clear();
    decoder_->decode(message, tree_);
    const std::optional<std::int64_t> stamp_ns = messages::take_row(tree_, columns);
    if (tree_.size() > most_kept_values) tree_ = MessageTree();
    return stamp_ns;
  }

 private:
  /// The room for more of them is given back: a log may have many topics.
  static constexpr std::size_t most_kept_values = 4096;

  std::unique_ptr<TreeDecoder> decoder_;
  MessageTree tree_;
};

}  // namespace

std::optional<std::int64_t> take_row(const MessageTree& message, MessageColumns& columns) {
  TreeWalk walk(message, columns);
  std::optional<Stamp> stamp;
  if (message.size() > 0 && message.kind(0) == Kind::object) {
    stamp = stamp_of(message);
    walk.take_members(0, stamp ? std::optional(stamp->place) : std::nullopt, columns.root());
  } else if (message.size() > 0) {
    walk.take_value(0, columns.field(columns.root(), "value"));
  }
  columns.end_row();
  return stamp ? std::optional(stamp->time_ns) : std::nullopt;
}

std::unique_ptr<MessageReader> reader_of_trees(std::unique_ptr<TreeDecoder> decoder) {
  return std::make_unique<TreeReader>(std::move(decoder));
}

}  // namespace tribolog::ingest::messages
