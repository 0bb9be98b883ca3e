#pragma once
// Messages in CDR, written for tests: numbers at multiples of their own size, as DDS writes them.

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog::test {

class CdrWriter {
 public:
  explicit CdrWriter(std::endian order = std::endian::little) : order_(order) {
    message_ = order == std::endian::little ? std::string("\0\1\0\0", 4) : std::string(4, '\0');
  }

  template <class Number>
  CdrWriter& add(Number value) {
    while ((message_.size() - 4) % sizeof(Number) != 0) message_ += '\0';
    std::string bytes(sizeof(Number), '\0');
    __builtin_memcpy(bytes.data(), &value, sizeof(Number));
    if (order_ != std::endian::native) bytes.assign(bytes.rbegin(), bytes.rend());
    message_ += bytes;
    return *this;
  }
  CdrWriter& add_text(std::string_view text) {
    add(static_cast<std::uint32_t>(text.size() + 1));
    message_ += text;
    message_ += '\0';
    return *this;
  }
  CdrWriter& add_texts(const std::vector<std::string>& texts) {
    add(static_cast<std::uint32_t>(texts.size()));
    for (const std::string& text : texts) add_text(text);
    return *this;
  }
  template <class Number>
  CdrWriter& add_sequence(const std::vector<Number>& numbers) {
    add(static_cast<std::uint32_t>(numbers.size()));
    for (const Number number : numbers) add(number);
    return *this;
  }
  CdrWriter& add_header(std::int64_t stamp_ns, std::string_view frame = "") {
    add(static_cast<std::int32_t>(stamp_ns / 1'000'000'000));
    add(static_cast<std::uint32_t>(stamp_ns % 1'000'000'000));
    return add_text(frame);
  }
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  std::endian order_;
  std::string message_;
};

/// sensor_msgs/JointState.
struct JointStateMessage {
  std::int64_t stamp_ns{};
  std::vector<std::string> names;
  std::vector<double> position{};
  std::vector<double> velocity{};
  std::vector<double> effort{};

  [[nodiscard]] std::string cdr(std::endian order = std::endian::little) const {
    CdrWriter writer(order);
    writer.add_header(stamp_ns, "base").add_texts(names).add_sequence(position);
    return writer.add_sequence(velocity).add_sequence(effort).message();
  }
};

/// Its definition, as recorders put it into a log.
inline constexpr std::string_view joint_state_definition =
    "# The state of joints; effort = \"Nm or N\"\n"
    "std_msgs/Header header\n\nstring[] name\nfloat64[] position # rad\nfloat64[] velocity\n"
    "float64[] effort\n\n"
    "================================================================================\n"
    "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n"
    "================================================================================\n"
    "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";

}  // namespace tribolog::test
