#pragma once
// Bytes one piece after the other, of any length.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/file_contents.h"
#include "base/file_descriptor.h"
#include "base/sha256.h"

namespace tribolog {

class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// @return how many bytes were written to `to`; 0 only at the end.
  virtual std::size_t read(char* to, std::size_t most) = 0;
  /// As far as it is known before the end: a file may grow or shrink.
  [[nodiscard]] virtual std::uint64_t likely_bytes() const = 0;
};

/// Bytes in memory, which have to live on.
class MemorySource final : public ByteSource {
 public:
  explicit MemorySource(std::string_view bytes) : rest_(bytes), all_(bytes.size()) {}
  std::size_t read(char* to, std::size_t most) override;
  [[nodiscard]] std::uint64_t likely_bytes() const override { return all_; }

 private:
  std::string_view rest_;
  std::uint64_t all_;
};

/// A regular file, as far as it reaches when it is opened: what a logger adds meanwhile is left,
/// so that reading ends. It is read, not mapped: a file that becomes shorter is no signal. A file
/// without a size, as those of /proc, is read to its end.
class InputFileSource final : public ByteSource {
 public:
  /// @throw InputError as read_file() does.
  explicit InputFileSource(const std::string& path,
                           std::uint64_t largest_bytes = largest_input_bytes);

  /// @throw InputError with the system's reason, if the file has become shorter than it was, or if
  ///        one without a size goes beyond the bound.
  std::size_t read(char* to, std::size_t most) override;
  [[nodiscard]] std::uint64_t likely_bytes() const override { return likely_bytes_; }
  [[nodiscard]] std::uint64_t bytes_read() const { return bytes_read_; }
  /// Whether the file is longer by now than what is read of it.
  [[nodiscard]] bool has_grown() const;

 private:
  std::string path_;
  FileDescriptor file_;
  std::uint64_t largest_bytes_;
  std::uint64_t likely_bytes_;
  std::uint64_t bytes_read_{0};
};

/// Another source, fingerprinted while it is read.
class FingerprintedSource final : public ByteSource {
 public:
  /// @param source has to live on.
  explicit FingerprintedSource(ByteSource& source) : source_(source) {}
  std::size_t read(char* to, std::size_t most) override;
  [[nodiscard]] std::uint64_t likely_bytes() const override { return source_.likely_bytes(); }
  /// SHA-256 of what was read, in hexadecimal digits; once, at the end.
  [[nodiscard]] std::string sha256() { return sha_.hex(); }

 private:
  ByteSource& source_;
  Sha256 sha_;
};

}  // namespace tribolog
