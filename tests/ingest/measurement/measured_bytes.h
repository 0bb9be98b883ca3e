#pragma once
// MDF 4 and TDMS files made by hand, byte by byte, for what no writer would write.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "ingest/log/log_table.h"

namespace tribolog::test::measured {

inline const ingest::log::LogColumn& column(const ingest::log::LogTable& table,
                                            std::string_view name) {
  for (const ingest::log::LogColumn& candidate : table.columns) {
    if (candidate.header.name == name) return candidate;
  }
  throw std::runtime_error("no column " + std::string(name));
}

/// A number's bytes, the lowest first.
template <class Number>
std::string little(Number number) {
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(Number));
  if constexpr (std::endian::native == std::endian::big) return {bytes.rbegin(), bytes.rend()};
  return bytes;
}
template <class Number>
std::string big(Number number) {
  const std::string bytes = little(number);
  return {bytes.rbegin(), bytes.rend()};
}

// MDF 4.

struct CnFields {
  std::string name{};
  std::uint8_t type{0};  ///< 2: master.
  std::uint8_t data_type{0};
  std::uint32_t byte{0};
  std::uint8_t bit{0};
  std::uint32_t bits{8};
  std::uint32_t flags{0};
  std::uint32_t invalid_bit{0};
  std::uint64_t conversion{0};
  std::uint64_t composition{0};
};

struct CgFields {
  std::string name{};
  std::uint64_t record_id{0};
  std::uint64_t records{0};
  std::uint32_t data_bytes{0};
  std::uint32_t invalid_bytes{0};
  std::uint16_t flags{0};
  std::vector<CnFields> channels{};
};

/// Blocks are written from the last to the first, so that links are known; the header is the first
/// of all and is filled in at the end.
class MdfBytes {
 public:
  explicit MdfBytes(const std::string& mark = "MDF     ", const std::string& version = "4.10    ")
      : bytes_(mark + version + "tribolog") {
    bytes_.resize(64, '\0');
    hd_at_ = add("##HD", {0, 0, 0, 0, 0, 0}, std::string(32, '\0'));
  }

  std::uint64_t add(const std::string& mark, const std::vector<std::uint64_t>& links,
                    const std::string& data) {
    while (bytes_.size() % 8 != 0) bytes_ += '\0';
    const std::uint64_t at = bytes_.size();
    bytes_ += mark + std::string(4, '\0') +
              little(std::uint64_t{24 + 8 * links.size() + data.size()}) +
              little(std::uint64_t{links.size()});
    for (const std::uint64_t link : links) bytes_ += little(link);
    bytes_ += data;
    return at;
  }
  std::uint64_t text(const std::string& text) {
    return text.empty() ? 0 : add("##TX", {}, text + '\0');
  }
  std::uint64_t conversion(std::uint8_t type, const std::vector<double>& values,
                           std::vector<std::uint64_t> references = {}) {
    std::string data{static_cast<char>(type), '\0', '\0', '\0'};
    data += little(static_cast<std::uint16_t>(references.size())) +
            little(static_cast<std::uint16_t>(values.size())) + std::string(16, '\0');
    for (const double value : values) data += little(value);
    std::vector<std::uint64_t> links(4, 0);
    links.insert(links.end(), references.begin(), references.end());
    return add("##CC", links, data);
  }
  std::uint64_t channel(const CnFields& f, std::uint64_t next) {
    std::string data{static_cast<char>(f.type), f.type == 2 ? '\1' : '\0',
                     static_cast<char>(f.data_type), static_cast<char>(f.bit)};
    data += little(f.byte) + little(f.bits) + little(f.flags) + little(f.invalid_bit) +
            std::string(52, '\0');
    const std::uint64_t name = text(f.name);
    return add("##CN", {next, f.composition, name, 0, f.conversion, 0, 0, 0}, data);
  }
  std::uint64_t group(const CgFields& f, std::uint64_t next) {
    std::uint64_t first = 0;
    for (auto it = f.channels.rbegin(); it != f.channels.rend(); ++it) first = channel(*it, first);
    const std::uint64_t name = text(f.name);
    return add("##CG", {next, first, name, 0, 0, 0},
               little(f.record_id) + little(f.records) + little(f.flags) + std::string(6, '\0') +
                   little(f.data_bytes) + little(f.invalid_bytes));
  }
  /// Puts a data group in front of those that are there.
  void data_group(std::uint64_t first_group, std::uint64_t data, std::uint8_t id_bytes = 0) {
    first_ = add("##DG", {first_, first_group, data, 0},
                 std::string(1, static_cast<char>(id_bytes)) + std::string(7, '\0'));
    bytes_.replace(hd_at_ + 24, 8, little(first_));
  }
  void set(std::uint64_t at, const std::string& bytes) { bytes_.replace(at, bytes.size(), bytes); }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::uint64_t hd_at_{};
  std::uint64_t first_{};
};

// TDMS.

inline std::string tdms_text(const std::string& text) {
  return little(static_cast<std::uint32_t>(text.size())) + text;
}

/// An object's entry in the metadata. @param index what stands behind its path; see tdms_index().
inline std::string tdms_object(const std::string& path, const std::string& index,
                               const std::vector<std::pair<std::string, double>>& properties = {}) {
  std::string bytes =
      tdms_text(path) + index + little(static_cast<std::uint32_t>(properties.size()));
  for (const auto& [name, value] : properties) {
    bytes += tdms_text(name) + little(std::uint32_t{10}) + little(value);
  }
  return bytes;
}
inline std::string tdms_index(std::uint32_t type, std::uint64_t values) {
  return little(std::uint32_t{20}) + little(type) + little(std::uint32_t{1}) + little(values);
}
inline const std::string tdms_as_before(4, '\0');
inline const std::string tdms_no_data(4, '\xff');

/// @param contents bits of the table of contents: 2 metadata, 4 new list, 8 raw data, 32
/// interleaved, 64 big endian.
inline std::string tdms_segment(std::uint32_t contents, const std::vector<std::string>& objects,
                                const std::string& raw_data) {
  std::string metadata;
  if ((contents & 2U) != 0) metadata = little(static_cast<std::uint32_t>(objects.size()));
  for (const std::string& object : objects) metadata += object;
  return "TDSm" + little(contents) + little(std::uint32_t{4713}) +
         little(std::uint64_t{metadata.size() + raw_data.size()}) +
         little(std::uint64_t{metadata.size()}) + metadata + raw_data;
}

}  // namespace tribolog::test::measured
