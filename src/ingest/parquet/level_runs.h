#pragma once
// Small integers as Parquet packs them: levels, places in a dictionary, and differences
// (https://github.com/apache/parquet-format/blob/master/Encodings.md).

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tribolog::ingest::parquet {

inline constexpr unsigned bits_per_byte = 8;

/// @throw UnreadableParquet: damaged, a page ends before its values do.
[[noreturn]] void refuse_short_page();

/// Runs of equal numbers, and numbers packed bit by bit.
class RunReader {
 public:
  /// @param width of a number in bits, 0 to 32. @throw UnreadableParquet: another one.
  RunReader(std::string_view bytes, unsigned width);

  /// The next `count` numbers. @throw UnreadableParquet: there are fewer.
  void read(std::uint32_t* to, std::size_t count);
  /// Whether the next `count` numbers are one run of this one; then it is passed over.
  bool skip_run_of(std::uint32_t number, std::size_t count);

 private:
  void start_run();
  void unpack(std::uint32_t* to, std::size_t count);

  std::string_view bytes_;
  unsigned width_;
  std::size_t left_{};       ///< Of the run.
  bool is_packed_{};         ///< The run's numbers differ,
  std::size_t bit_{};        ///< and the next one stands at this bit of
  std::string_view packed_;  ///< these bytes.
  std::uint32_t number_{};   ///< Of a run of equal ones.
};

/// Numbers in bits from the highest on, as older writers pack levels.
/// @throw UnreadableParquet: there are fewer.
void read_bit_packed(std::string_view bytes, unsigned width, std::uint32_t* to, std::size_t count);

/// Integers as differences in blocks (DELTA_BINARY_PACKED). They wrap round, as the writer's do.
/// @param count so many have to be there.
/// @param used receives how many bytes it took.
/// @throw UnreadableParquet: damaged, or of another number.
std::vector<std::int64_t> read_deltas(std::string_view bytes, std::size_t count, std::size_t& used);

/// Bits that a number up to this one takes.
unsigned bits_of(std::uint32_t most);

}  // namespace tribolog::ingest::parquet
