#pragma once
// A source's bytes as readers of records want them: so many now, so many passed over.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/input_file.h"

namespace tribolog::ingest::bags {

class ByteReader {
 public:
  /// @param source has to live on.
  explicit ByteReader(ByteSource& source);

  /// The next bytes, at most `most`. They stay valid until the next call.
  /// @return none only at the end, or where `most` is 0.
  std::string_view next(std::uint64_t most);
  /// Adds the next `bytes` to a text, which grows as they come. @return false: the end came first.
  bool append(std::string& to, std::uint64_t bytes);
  /// Passes over the next `bytes`. @return how many there were.
  std::uint64_t skip(std::uint64_t bytes);
  /// How many bytes were handed out.
  [[nodiscard]] std::uint64_t position() const { return position_; }

 private:
  ByteSource& source_;
  std::string buffer_;
  std::string_view fetched_;
  std::uint64_t position_{0};
};

}  // namespace tribolog::ingest::bags
