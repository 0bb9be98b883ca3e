#pragma once
// The numbers of a topic's messages as columns, whatever the messages are encoded in.
//
// A message is a tree of fields, and a column's name is the path of its number in it:
// `wrench.force.x`, `dtau_j[0]`. Where a message names the elements of its arrays, these names
// stand instead, so that the order may change from message to message: `<joint>.position`,
// `.velocity`,
// `.effort` of joint states.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::messages {

/// A message says something that cannot be; the text goes on after "message 5 of /topic".
class MessageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Longest array without names that becomes columns; images and point clouds are longer.
inline constexpr std::size_t longest_unnamed_array = 64;

/// Message by message: the places of its numbers are looked up and filled, then end_row() says that
/// this was one.
class MessageColumns {
 public:
  /// What is known of one place in the messages' tree. Places appear as messages need them.
  struct Place;

  MessageColumns();
  MessageColumns(const MessageColumns&) = delete;
  MessageColumns& operator=(const MessageColumns&) = delete;
  ~MessageColumns();

  /// The message itself.
  [[nodiscard]] Place* root() { return root_.get(); }

  // The places within one. Null where that is null, and where there are too many: what stands there
  // is not kept.

  /// A field of a type that is known: by its number in the type.
  Place* field(Place* parent, std::size_t number, std::string_view name);
  /// A field by its name.
  Place* field(Place* parent, std::string_view name);
  Place* element(Place* array, std::size_t number);
  /// An element by its name, "elbow.position" of field `position` in `parent`.
  /// @param field empty: "elbow". Where another array of the parent has that already, the array's
  ///        name comes in front.
  Place* named_element(Place* parent, Place* array, std::string_view name, std::string_view field);

  /// The row's number at this place; the last one counts. What is not finite is a gap.
  void put(Place* place, double value);
  /// An array is left out for its length.
  void leave_out(const Place* long_array);
  /// @param is_too_long the message is longer than its type says.
  void end_row(bool is_too_long = false);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t too_long() const { return too_long_; }
  /// Paths of arrays that were left out for their length, and whether there were too many columns.
  [[nodiscard]] const std::vector<std::string>& long_arrays() const { return long_arrays_; }
  [[nodiscard]] bool has_too_many_columns() const { return has_too_many_columns_; }

  /// Every column gets as many values as there are rows. Where there are very many gaps, columns
  /// that hold little else are left out: a small log must not ask for gigabytes.
  void fill_gaps();
  /// All columns, in the order in which they occurred.
  std::vector<log::LogColumn> finish() &&;

 private:
  Place* added(std::unique_ptr<Place>& where, std::string path);
  /// @return false: it has too many gaps, and is left out from now on.
  bool grow(std::size_t column, std::size_t rows);

  std::unique_ptr<Place> root_;
  std::size_t places_{0};
  std::set<std::string> named_paths_;
  std::vector<log::LogColumn> columns_;
  std::vector<std::size_t> numbers_;  ///< Put into each column.
  std::vector<bool> is_left_out_;     ///< By column.
  std::size_t cells_{0};              ///< Of all columns, gaps included.
  std::vector<std::string> long_arrays_;
  bool has_too_many_columns_{false};
  std::size_t rows_{0};
  std::size_t too_long_{0};
};

/// Reads the messages of one topic.
class MessageReader {
 public:
  MessageReader() = default;
  MessageReader(const MessageReader&) = delete;
  MessageReader& operator=(const MessageReader&) = delete;
  virtual ~MessageReader() = default;

  /// One message as the next row. @return its time stamp in ns, where it has one.
  /// @throw MessageError. What was read of this row is then undefined.
  virtual std::optional<std::int64_t> take_row(std::string_view message,
                                               MessageColumns& columns) = 0;
};

}  // namespace tribolog::ingest::messages
