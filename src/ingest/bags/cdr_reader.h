#pragma once
// Numbers and strings from a message in CDR, the Common Data Representation (OMG, version 1), as
// ROS 2 writes it: four bytes that state the byte order, then the body, in which each number stands
// at a multiple of its own size, counted from the start of the body.

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

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

/// A message says something that cannot be; the text names the byte of the message.
class CdrError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Every length is held against the bytes that are left before it is used.
class CdrReader {
 public:
  /// @throw CdrError: shorter than four bytes, or another representation than plain CDR.
  explicit CdrReader(std::string_view message);

  /// One number. @throw CdrError: the message ends first.
  double number(Primitive kind);
  std::int32_t int32();
  std::uint32_t uint32();
  /// Without the closing NUL; valid as long as the message is.
  std::string_view string();
  /// The number of elements of a sequence, each of which takes at least a byte.
  std::size_t sequence_length();
  /// Passes over numbers.
  void skip(Primitive kind, std::size_t count);

  [[nodiscard]] std::size_t bytes_left() const { return body_.size() - at_; }
  /// Of the whole message, with the first four bytes.
  [[nodiscard]] std::size_t byte() const;

 private:
  template <class T>
  T raw();
  void align(std::size_t size);
  std::string_view take(std::size_t bytes);

  std::string_view body_;
  std::size_t at_{0};
  bool swaps_{false};
};

}  // namespace tribolog::ingest::bags
