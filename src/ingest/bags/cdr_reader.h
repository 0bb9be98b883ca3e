#pragma once
// Numbers and strings from a message of ROS.
//
// ROS 2 writes CDR, the Common Data Representation (OMG, version 1): four bytes that state the byte
// order, then the body, in which each number stands at a multiple of its own size, counted from the
// start of the body. ROS 1 writes the body alone, little-endian, without any padding.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "ingest/messages/message_columns.h"

namespace tribolog::ingest::bags {

enum class Primitive : std::uint8_t {
  boolean,
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

std::size_t size_of(Primitive kind);

using messages::MessageError;

enum class Serialization : std::uint8_t { cdr, ros1 };

/// Every length is held against the bytes that are left before it is used. Errors name the byte of
/// the message.
class CdrReader {
 public:
  /// @throw MessageError: shorter than four bytes, or another representation than plain CDR.
  explicit CdrReader(std::string_view message, Serialization how = Serialization::cdr);

  /// One number. @throw MessageError, as all of these: the message ends first.
  double number(Primitive kind);
  std::int32_t int32();
  std::uint32_t uint32();
  /// Without the closing NUL that CDR has; valid as long as the message is.
  std::string_view string();
  /// The number of elements of a sequence, each of which takes at least a byte.
  std::size_t sequence_length();
  /// Passes over numbers.
  void skip(Primitive kind, std::size_t count);

  [[nodiscard]] std::size_t bytes_left() const { return body_.size() - at_; }
  /// Of the whole message, with the four bytes in front of the body.
  [[nodiscard]] std::size_t byte() const;

 private:
  template <class T>
  T raw();
  void align(std::size_t size);
  std::string_view take(std::size_t bytes);

  std::size_t before_body_;  ///< Bytes.
  std::string_view body_;
  std::size_t at_{0};
  bool aligns_;
  bool swaps_{false};
};

}  // namespace tribolog::ingest::bags
