#pragma once
// Input files: whole in memory, or one piece after the other.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/encodings.h"
#include "base/file_descriptor.h"

namespace tribolog {

/// Largest input file that is read unless the caller says otherwise: 8 GiB.
inline constexpr std::uint64_t largest_input_bytes = std::uint64_t{8} << 30;

/// The bytes of a regular file, as far as it reaches when it is opened. It is read, not mapped: a
/// file that becomes shorter meanwhile is refused and never a signal.
/// @throw InputError naming the file: it cannot be opened or read (with the system's reason), is a
///        directory, is not a regular file (device, pipe, socket, "-"), or is larger than the
///        bound; or it becomes shorter while it is read.
std::string read_file(const std::string& path, std::uint64_t largest_bytes = largest_input_bytes);

/// The first bytes of a file; all of a shorter one.
/// @throw InputError as read_file() does.
std::string read_start(const std::string& path, std::size_t most_bytes);

/// Size of a regular file in bytes, for a library that opens it by its name.
/// @throw InputError as read_file().
std::uint64_t size_of_file(const std::string& path,
                           std::uint64_t largest_bytes = largest_input_bytes);

// Bytes one piece after the other, of any length.

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
  /// Fills all of `to` from a place in the file, wherever read() has come to.
  /// @throw InputError as read() does: there are fewer bytes by now.
  void read_at(std::uint64_t at, char* to, std::size_t bytes) const;
  [[nodiscard]] std::uint64_t likely_bytes() const override { return likely_bytes_; }
  [[nodiscard]] std::uint64_t bytes_read() const { return bytes_read_; }
  /// Whether the file is longer by now than what is read of it.
  [[nodiscard]] bool has_grown() const;

 private:
  void refuse_if_shortened() const;

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
