#pragma once
// The records of a bag of ROS 1, version 2.0 (http://wiki.ros.org/Bags/Format/2.0): each has a
// header of fields "name=value" and its data, both with their length in front. Integers are
// little-endian.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tribolog::ingest::bags {

inline constexpr std::string_view bag_magic = "#ROSBAG V2.0\n";

enum class BagOp : std::uint8_t {
  message = 0x02,
  bag_header = 0x03,
  chunk = 0x05,
  connection = 0x07,
};

inline constexpr std::size_t bag_length_bytes = 4;
/// A length. @param bytes at least as many.
std::uint32_t bag_length(std::string_view bytes);

/// The fields of a header; they stay valid as long as its bytes.
class BagFields {
 public:
  /// Nothing where the bytes are no such fields.
  static std::optional<BagFields> parse(std::string_view header);

  /// Empty where there is none of the name.
  [[nodiscard]] std::string_view value(std::string_view name) const;
  /// Nothing where there is none of the name, or it is no integer of this size.
  [[nodiscard]] std::optional<std::uint8_t> uint8(std::string_view name) const;
  [[nodiscard]] std::optional<std::uint32_t> uint32(std::string_view name) const;
  [[nodiscard]] std::optional<std::uint64_t> uint64(std::string_view name) const;
  /// Two integers, of seconds and nanoseconds.
  [[nodiscard]] std::optional<std::uint64_t> time_ns(std::string_view name) const;

 private:
  std::vector<std::pair<std::string_view, std::string_view>> fields_;
};

/// "chunk", "connection"; "record 0x04" where it is not read.
std::string bag_record_name(std::uint8_t op);

}  // namespace tribolog::ingest::bags
