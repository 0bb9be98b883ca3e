#pragma once
// A message of an encoding that says itself what its fields are called, JSON or protobuf: as a
// tree, and from that tree to columns.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/messages/message_columns.h"

namespace tribolog::ingest::messages {

/// Values in the order in which they stand in the message, each with all within it behind it.
/// Filled anew for each message, without new memory once it has what the largest one takes.
class MessageTree {
 public:
  /// Deepest nesting.
  static constexpr std::size_t deepest = 32;
  /// Most values of one message.
  static constexpr std::size_t most_values = std::size_t{1} << 20;
  /// Of a longer text the start alone is kept: neither a joint's name nor a time is as long.
  static constexpr std::size_t longest_text = 256;

  enum class Kind : std::uint8_t { gap, number, text, array, object };

  void clear();
  /// The name of the value that comes next. @throw MessageError: none may be as long.
  void add_key(std::string_view key);
  /// @throw MessageError, as all of these: there are too many values, or they are nested too
  /// deeply.
  void add_gap() { (void)add(Kind::gap); }
  void add_number(double value);
  void add_integer(std::int64_t value);
  void add_text(std::string_view text);
  /// @param kind array or object. What is added until its close() stands within it.
  void open(Kind kind);
  void close();

  // Values by their numbers; 0 is the message.

  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] Kind kind(std::size_t value) const { return values_[value].kind; }
  [[nodiscard]] double number(std::size_t value) const { return values_[value].number; }
  /// Of a whole number also where no double holds it; 0 of others.
  [[nodiscard]] std::int64_t integer(std::size_t value) const { return values_[value].integer; }
  [[nodiscard]] std::string_view text(std::size_t value) const { return at(values_[value].text); }
  /// Of an object's member; empty of others.
  [[nodiscard]] std::string_view key(std::size_t value) const { return at(values_[value].key); }
  /// The number of the value that stands behind it and all within it.
  [[nodiscard]] std::size_t after(std::size_t value) const { return values_[value].after; }
  /// The member of an object with this key.
  [[nodiscard]] std::optional<std::size_t> member(std::size_t object, std::string_view key) const;

 private:
  struct Text {
    std::size_t begin{};
    std::size_t length{};
  };
  struct Value {
    Kind kind{};
    double number{};
    std::int64_t integer{};
    Text key{};
    Text text{};
    std::size_t after{};
  };
  std::size_t add(Kind kind);
  Text keep(std::string_view text);
  [[nodiscard]] std::string_view at(Text text) const {
    return std::string_view(texts_).substr(text.begin, text.length);
  }

  std::vector<Value> values_;
  std::string texts_;
  Text key_{};
  std::vector<std::size_t> open_;
};

/// Adds a message to the columns as the next row.
///
/// Booleans are 0 and 1; texts give no column, and neither does what a message lacks. An object's
/// list of different texts under `name`, `names` or `joint_names` names the elements of its arrays
/// that are as long: `elbow.position`. In an array of objects that each have a `name` (`joint`,
/// `joint_name`) of their own these names stand instead of the number. What `interface_names` names
/// has no field's name behind it, as in control_msgs/DynamicJointState.
/// @return the time of the message in ns, of the first of `header.stamp`, `timestamp`, `stamp`,
///         `header.timestamp` and `time` that is one: whole seconds and nanoseconds (`sec` and
///         `nanosec`, `seconds` and `nanos` ...), ISO 8601, or nanoseconds since 1970 in one whole
///         number. It gives no column, and neither does
///         a header that holds it.
std::optional<std::int64_t> take_row(const MessageTree& message, MessageColumns& columns);

/// Makes a tree of each message of a topic.
class TreeDecoder {
 public:
  TreeDecoder() = default;
  TreeDecoder(const TreeDecoder&) = delete;
  TreeDecoder& operator=(const TreeDecoder&) = delete;
  virtual ~TreeDecoder() = default;

  /// @param tree empty. @throw MessageError.
  virtual void decode(std::string_view message, MessageTree& tree) = 0;
};

/// Reads messages by way of their trees.
std::unique_ptr<MessageReader> reader_of_trees(std::unique_ptr<TreeDecoder> decoder);

}  // namespace tribolog::ingest::messages
