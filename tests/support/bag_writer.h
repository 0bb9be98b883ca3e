#pragma once
// Bags of ROS 1, written for tests.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tribolog::test {

inline std::string little_endian(std::uint64_t value, std::size_t bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes; ++i, value >>= 8U) text += static_cast<char>(value & 0xffU);
  return text;
}

/// A message of ROS 1: little-endian, one field behind the other.
class Ros1Message {
 public:
  template <class Number>
  Ros1Message& add(Number value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  Ros1Message& add_text(std::string_view text) {
    add(static_cast<std::uint32_t>(text.size()));
    bytes_ += text;
    return *this;
  }
  Ros1Message& add_header(std::int64_t stamp_ns) {
    add(std::uint32_t{0}).add(static_cast<std::uint32_t>(stamp_ns / 1'000'000'000));
    return add(static_cast<std::uint32_t>(stamp_ns % 1'000'000'000)).add_text("base");
  }
  Ros1Message& add_texts(const std::vector<std::string>& texts) {
    add(static_cast<std::uint32_t>(texts.size()));
    for (const std::string& text : texts) add_text(text);
    return *this;
  }
  Ros1Message& add_sequence(const std::vector<double>& numbers) {
    add(static_cast<std::uint32_t>(numbers.size()));
    for (const double number : numbers) add(number);
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

using BagHeader = std::vector<std::pair<std::string, std::string>>;

inline std::string bag_fields(const BagHeader& header) {
  std::string text;
  for (const auto& [name, value] : header) {
    text += little_endian(name.size() + 1 + value.size(), 4) + name + "=" + value;
  }
  return text;
}

inline std::string bag_record(const BagHeader& header, std::string_view data) {
  const std::string fields = bag_fields(header);
  return little_endian(fields.size(), 4) + fields + little_endian(data.size(), 4) +
         std::string(data);
}

inline std::string bag_start(std::uint64_t index_at, const std::string& encryptor = "") {
  BagHeader header = {{"op", "\x03"},
                      {"index_pos", little_endian(index_at, 8)},
                      {"conn_count", little_endian(1, 4)},
                      {"chunk_count", little_endian(1, 4)}};
  if (!encryptor.empty()) header.emplace_back("encryptor", encryptor);
  return "#ROSBAG V2.0\n" + bag_record(header, std::string(64, ' '));
}

inline std::string bag_connection(std::uint32_t number, const std::string& topic,
                                  const std::string& type, const std::string& definition) {
  return bag_record(
      {{"op", "\x07"}, {"conn", little_endian(number, 4)}, {"topic", topic}},
      bag_fields(
          {{"topic", topic}, {"type", type}, {"md5sum", "*"}, {"message_definition", definition}}));
}

inline std::string bag_message(std::uint32_t connection, std::uint64_t time_ns,
                               std::string_view data) {
  return bag_record({{"op", "\x02"},
                     {"conn", little_endian(connection, 4)},
                     {"time", little_endian(time_ns / 1'000'000'000, 4) +
                                  little_endian(time_ns % 1'000'000'000, 4)}},
                    data);
}

/// @param stored as it stands in the file. @param bytes unpacked.
inline std::string bag_chunk(const std::string& compression, std::string_view stored,
                             std::size_t bytes) {
  return bag_record(
      {{"op", "\x05"}, {"compression", compression}, {"size", little_endian(bytes, 4)}}, stored);
}

inline constexpr std::string_view ros1_joint_state =
    "Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n"
    "================================================================================\n"
    "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";

}  // namespace tribolog::test
