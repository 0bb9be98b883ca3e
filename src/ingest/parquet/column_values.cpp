#include "ingest/parquet/column_values.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <libdeflate.h>

#include "ingest/parquet/compact_protocol.h"
#include "ingest/parquet/level_runs.h"

namespace tribolog::ingest::parquet {
namespace {

constexpr double real_gap = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void refuse_count(std::uint64_t found, std::uint64_t stated, const char* what) {
  throw UnreadableParquet(
      fmt::format("damaged: a column has {} {} where {} are stated", found, what, stated));
}

}  // namespace

ValueBudget::ValueBudget(std::uint64_t file_bytes) {
  constexpr std::uint64_t of_any_file = std::uint64_t{1} << 25;
  constexpr std::uint64_t per_byte = 1024;
  constexpr std::uint64_t most = std::uint64_t{1} << 31;
  left_ = std::min(most, of_any_file + std::min(most, file_bytes) * per_byte);
}

void ValueBudget::take(std::uint64_t values) {
  if (values > left_) {
    throw UnreadableParquet("states more numbers than a file of its size is read for", "",
                            "split it, or leave out columns that are not needed");
  }
  left_ -= values;
}

void ColumnValues::expect(std::uint64_t rows) {
  if (column_.is_list) return;
  ValueBudget(budget_).take(rows);
  if (column_.storage == Storage::integer) {
    numbers_.integers.reserve(static_cast<std::size_t>(rows));
  } else {
    numbers_.reals.reserve(static_cast<std::size_t>(rows));
  }
}

namespace {

/// @throw UnreadableParquet: a level above the highest.
void check_levels(const std::vector<std::uint32_t>& levels, unsigned most) {
  std::uint32_t highest = 0;
  for (const std::uint32_t level : levels) highest = std::max(highest, level);
  if (highest > most) throw UnreadableParquet("damaged: a page has a level that cannot be");
}

/// @param levels stays empty where all are the highest one.
void read_runs(std::string_view bytes, unsigned most, std::size_t count,
               std::vector<std::uint32_t>& levels) {
  RunReader runs(bytes, bits_of(most));
  if (runs.skip_run_of(most, count)) return;
  levels.resize(count);
  runs.read(levels.data(), count);
  check_levels(levels, most);
}

/// Levels of version 1 stand in front of the values. @return the bytes behind them.
std::string_view take_v1(std::string_view bytes, Encoding encoding, unsigned most,
                         std::size_t count, std::vector<std::uint32_t>& levels) {
  if (encoding == Encoding::bit_packed) {
    const std::size_t length = (count * bits_of(most) + bits_per_byte - 1) / bits_per_byte;
    if (length > bytes.size()) refuse_short_page();
    levels.resize(count);
    read_bit_packed(bytes.substr(0, length), bits_of(most), levels.data(), count);
    check_levels(levels, most);
    return bytes.substr(length);
  }
  if (encoding != Encoding::runs) {
    throw UnreadableParquet("damaged: levels are in an encoding that they cannot have");
  }
  std::uint32_t length = 0;
  if (bytes.size() < sizeof length) refuse_short_page();
  std::memcpy(&length, bytes.data(), sizeof length);
  bytes.remove_prefix(sizeof length);
  if (length > bytes.size()) refuse_short_page();
  read_runs(bytes.substr(0, length), most, count, levels);
  return bytes.substr(length);
}

}  // namespace

std::string_view ColumnValues::take_levels_v1(const PageHeader& page, std::string_view bytes) {
  if (column_.is_list) {
    // Not left empty: the lowest level is what begins a row.
    bytes = take_v1(bytes, page.repetition_encoding, 1, page.values, levels_.repetition);
    if (levels_.repetition.empty()) levels_.repetition.assign(page.values, 1);
  }
  if (column_.most_definition > 0) {
    bytes = take_v1(bytes, page.definition_encoding, column_.most_definition, page.values,
                    levels_.definition);
  }
  return bytes;
}

std::string_view ColumnValues::take_levels_v2(const PageHeader& page, const ColumnChunk& chunk,
                                              std::string_view stored) {
  const std::size_t in_front = page.repetition_bytes + page.definition_bytes;
  if (in_front > stored.size() || in_front > page.unpacked_bytes) refuse_short_page();
  if (column_.is_list) {
    read_runs(stored.substr(0, page.repetition_bytes), 1, page.values, levels_.repetition);
    if (levels_.repetition.empty()) levels_.repetition.assign(page.values, 1);
  }
  if (column_.most_definition > 0) {
    read_runs(stored.substr(page.repetition_bytes, page.definition_bytes), column_.most_definition,
              page.values, levels_.definition);
  }
  const std::string_view values = stored.substr(in_front);
  if (!page.is_compressed) return values;
  return unpack_page(chunk.codec, values, page.unpacked_bytes - in_front, room_);
}

std::string_view ColumnValues::take_levels(const PageHeader& page, const ColumnChunk& chunk,
                                           std::string_view stored) {
  levels_.definition.clear();
  levels_.repetition.clear();
  if (static_cast<PageKind>(page.kind) == PageKind::data_v2) {
    return take_levels_v2(page, chunk, stored);
  }
  return take_levels_v1(page, unpack_page(chunk.codec, stored, page.unpacked_bytes, room_));
}

void ColumnValues::append_gaps(std::size_t count) {
  if (column_.storage == Storage::integer) {
    numbers_.integers.insert(numbers_.integers.end(), count, integer_gap);
  } else {
    numbers_.reals.insert(numbers_.reals.end(), count, real_gap);
  }
}

namespace {

/// Moves the last `present` numbers apart, so that those whose level is below the highest are gaps.
template <class Number>
void spread(const std::vector<std::uint32_t>& levels, unsigned most, std::size_t present,
            Number gap, std::vector<Number>& numbers) {
  std::size_t from = numbers.size();
  numbers.resize(numbers.size() + levels.size() - present);
  std::size_t to = numbers.size();
  for (std::size_t i = levels.size(); i-- > 0;) {
    numbers[--to] = levels[i] == most ? numbers[--from] : gap;
  }
}

}  // namespace

void ColumnValues::add_rows(Encoding encoding, std::string_view values, std::size_t count) {
  const std::vector<std::uint32_t>& levels = levels_.definition;
  const unsigned most = column_.most_definition;
  const std::size_t present =
      levels.empty() ? count
                     : static_cast<std::size_t>(std::count(levels.begin(), levels.end(), most));
  decoder_.decode(encoding, values, present, numbers_);
  rows_ += count;
  if (present == count) return;
  if (column_.storage == Storage::integer) {
    spread(levels, most, present, integer_gap, numbers_.integers);
  } else {
    spread(levels, most, present, real_gap, numbers_.reals);
  }
}

/// A row without elements took next to no bytes, and gets as many numbers as the others.
void ColumnValues::append_empty_lists(std::size_t rows) {
  budget_.take(rows * elements_);
  append_gaps(rows * elements_);
}

void ColumnValues::end_list() {
  if (!is_in_list_) return;
  const std::size_t found = std::exchange(in_list_, 0);
  if (elements_ == 0 && found > 0) {
    elements_ = found;
    // Rows before it were empty: their gaps go in front.
    Numbers first = std::move(numbers_);
    numbers_ = {};
    append_empty_lists(empty_before_);
    numbers_.reals.insert(numbers_.reals.end(), first.reals.begin(), first.reals.end());
    numbers_.integers.insert(numbers_.integers.end(), first.integers.begin(), first.integers.end());
  } else if (found == 0 && elements_ == 0) {
    ++empty_before_;
  } else if (found == 0) {
    append_empty_lists(1);
  } else if (found != elements_) {
    left_out_ = fmt::format("its rows hold lists of {} and of {} elements", elements_, found);
  }
}

void ColumnValues::add_element(bool is_there, const Numbers& present, std::size_t& next) {
  if (++in_list_ > most_elements) {
    left_out_ = fmt::format("its rows hold lists of more than {} elements", most_elements);
  } else if (!is_there) {
    append_gaps(1);
  } else if (column_.storage == Storage::integer) {
    numbers_.integers.push_back(present.integers[next]);
  } else {
    numbers_.reals.push_back(present.reals[next]);
  }
  next += is_there ? 1 : 0;
}

void ColumnValues::add_lists(Encoding encoding, std::string_view values, std::size_t count) {
  const unsigned most = column_.most_definition;
  const auto level_of = [&](std::size_t i) {
    return levels_.definition.empty() ? most : levels_.definition[i];
  };
  std::size_t present_count = 0;
  for (std::size_t i = 0; i < count; ++i) present_count += level_of(i) == most ? 1 : 0;
  Numbers present;
  decoder_.decode(encoding, values, present_count, present);
  std::size_t next = 0;
  for (std::size_t i = 0; i < count && left_out_.empty(); ++i) {
    if (levels_.repetition[i] == 0) {
      end_list();
      is_in_list_ = true;
      ++rows_;
    } else if (!is_in_list_) {
      throw UnreadableParquet("damaged: a column begins inside of a list");
    }
    const bool is_element = level_of(i) >= column_.list_definition;
    if (is_element && left_out_.empty()) add_element(level_of(i) == most, present, next);
  }
}

void ColumnValues::add_page(const PageHeader& page, const ColumnChunk& chunk,
                            std::string_view stored) {
  if (static_cast<PageKind>(page.kind) == PageKind::dictionary) {
    decoder_.set_dictionary(page, unpack_page(chunk.codec, stored, page.unpacked_bytes, room_));
    return;
  }
  const std::string_view values = take_levels(page, chunk, stored);
  if (column_.is_list) {
    add_lists(page.encoding, values, page.values);
  } else {
    add_rows(page.encoding, values, page.values);
  }
}

namespace {

/// @throw UnreadableParquet: the bytes are not those that were written.
void check_crc(const PageHeader& page, std::string_view stored) {
  if (!page.crc) return;
  const std::uint32_t crc = libdeflate_crc32(0, stored.data(), stored.size());
  if (crc == *page.crc) return;
  throw UnreadableParquet(
      fmt::format("damaged: a page's CRC is {:08x} instead of {:08x}", crc, *page.crc));
}

bool is_data(const PageHeader& page) {
  return page.kind == static_cast<int>(PageKind::data) ||
         page.kind == static_cast<int>(PageKind::data_v2);
}

}  // namespace

void ColumnValues::add_chunk(const ColumnChunk& chunk, std::string_view pages, std::uint64_t rows) {
  if (chunk.type != column_.type) {
    throw UnreadableParquet("damaged: a column is of another type than the schema says");
  }
  decoder_.forget_dictionary();
  rows_ = 0;
  std::uint64_t entries = 0;
  while (entries < chunk.values && left_out().empty()) {
    const PageHeader page = read_page_header(pages);
    pages.remove_prefix(page.header_bytes);
    if (page.stored_bytes > pages.size()) refuse_short_page();
    const std::string_view stored = pages.substr(0, page.stored_bytes);
    pages.remove_prefix(stored.size());
    check_crc(page, stored);
    if (!is_data(page) && page.kind != static_cast<int>(PageKind::dictionary)) continue;
    budget_.take(page.values);
    if (is_data(page)) entries += page.values;
    if (entries > chunk.values) refuse_count(entries, chunk.values, "values");
    add_page(page, chunk, stored);
  }
  if (!left_out().empty()) return;
  if (is_in_list_) end_list();
  is_in_list_ = false;
  if (left_out().empty() && rows_ != rows) refuse_count(rows_, rows, "rows");
}

const std::string& ColumnValues::left_out() const {
  return left_out_.empty() ? texts_.left_out() : left_out_;
}

}  // namespace tribolog::ingest::parquet
