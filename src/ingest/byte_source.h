#pragma once
// The bytes of a log from its start to its end, from a file or from memory.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "files/input_file.h"

namespace tribolog {

class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  /// The next bytes, at most `most`. They stay valid until the next call.
  /// @return none only at the end, or where `most` is 0.
  std::string_view next(std::uint64_t most);
  /// Adds the next `bytes` to a text, which grows as they come. @return false: the end came first.
  bool append(std::string& to, std::uint64_t bytes);
  /// Passes over the next `bytes`. @return how many there were.
  std::uint64_t skip(std::uint64_t bytes);
  /// How many bytes were handed out.
  [[nodiscard]] std::uint64_t position() const { return position_; }

 protected:
  /// More bytes, as many as are at hand; none at the end.
  virtual std::string_view fetch() = 0;

 private:
  std::string_view fetched_;
  std::uint64_t position_{0};
};

class FileSource : public ByteSource {
 public:
  /// @throw InputError as InputFile.
  explicit FileSource(const std::string& path);

 protected:
  std::string_view fetch() override;

 private:
  InputFile file_;
  std::string buffer_;
};

class MemorySource : public ByteSource {
 public:
  explicit MemorySource(std::string_view bytes) : bytes_(bytes) {}

 protected:
  std::string_view fetch() override;

 private:
  std::string_view bytes_;
};

}  // namespace tribolog
