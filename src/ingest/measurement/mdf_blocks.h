#pragma once
// The blocks of an MDF 4 file: each has a mark ("##CN"), its length, links to other blocks and
// data. All numbers are little-endian.

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/error.h"

namespace tribolog::ingest::measurement {

/// Of a file, in bytes from its start; 0: none.
using MdfLink = std::uint64_t;

/// A block as it stands in the file. What a field beyond its end would hold is 0: blocks of older
/// versions are shorter.
class MdfBlock {
 public:
  MdfBlock() = default;
  MdfBlock(MdfLink at, std::string_view bytes, std::size_t links)
      : at_(at), bytes_(bytes), links_(links) {}

  [[nodiscard]] MdfLink at() const { return at_; }
  /// "##CN"
  [[nodiscard]] std::string_view mark() const { return bytes_.substr(0, 4); }
  [[nodiscard]] std::size_t links() const { return links_; }
  [[nodiscard]] MdfLink link(std::size_t index) const;
  /// Behind the links.
  [[nodiscard]] std::string_view data() const;
  /// Of the data, at an offset. A boolean is none of these.
  [[nodiscard]] std::uint8_t uint8(std::size_t at) const;
  [[nodiscard]] std::uint16_t uint16(std::size_t at) const;
  [[nodiscard]] std::uint32_t uint32(std::size_t at) const;
  [[nodiscard]] std::uint64_t uint64(std::size_t at) const;
  [[nodiscard]] double float64(std::size_t at) const;

 private:
  MdfLink at_{};
  std::string_view bytes_;
  std::size_t links_{};
};

class MdfBlocks {
 public:
  /// @param bytes of the whole file, which have to live on.
  MdfBlocks(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

  /// The block that a link leads to.
  /// @throw InputError: there is none of one of these marks, it reaches beyond the file's end, or
  /// it overlaps others: all blocks together are longer than the file.
  MdfBlock block(MdfLink link, const std::vector<std::string_view>& marks);
  /// The mark that a link leads to; empty where it leads nowhere.
  [[nodiscard]] std::string_view mark_at(MdfLink link) const;
  /// The same as block() for one that may be met only once, as those of a list.
  /// @throw InputError as block(), and where it was met before: a list that never ends.
  MdfBlock once(MdfLink link, const std::vector<std::string_view>& marks);
  /// Of a ##TX, or the text in the XML of an ##MD; at most 1024 bytes of it. Empty for link 0.
  /// @throw InputError as block().
  const std::string& text(MdfLink link);

  /// Of a block whose length was never written, all that follows its header.
  /// @throw InputError: it overlaps others.
  void count_rest(MdfLink begin) { count(begin, bytes_.size() - begin); }

  [[nodiscard]] std::string_view bytes() const { return bytes_; }
  [[nodiscard]] const std::string& file() const { return file_; }
  [[noreturn]] void refuse(const std::string& what, const std::string& found = {},
                           const std::string& expected = {}) const;

 private:
  void count(MdfLink link, std::uint64_t length);

  std::string_view bytes_;
  std::string file_;
  std::unordered_set<MdfLink> met_;   ///< Those that are counted in `read_bytes_`.
  std::unordered_set<MdfLink> once_;  ///< Those that once() gave.
  std::uint64_t read_bytes_{};
  std::map<MdfLink, std::string> texts_{{0, ""}};
};

}  // namespace tribolog::ingest::measurement
