#include "ingest/bags/bag_records.h"

#include <fmt/format.h>

namespace tribolog::ingest::bags {
namespace {

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) {
    value = (value << 8U) | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

template <class Integer>
std::optional<Integer> integer(std::string_view bytes) {
  if (bytes.size() != sizeof(Integer)) return std::nullopt;
  return static_cast<Integer>(little_endian(bytes));
}

}  // namespace

std::uint32_t bag_length(std::string_view bytes) {
  return static_cast<std::uint32_t>(little_endian(bytes.substr(0, bag_length_bytes)));
}

std::optional<BagFields> BagFields::parse(std::string_view header) {
  BagFields fields;
  while (!header.empty()) {
    if (header.size() < bag_length_bytes) return std::nullopt;
    const std::uint32_t length = bag_length(header);
    header.remove_prefix(bag_length_bytes);
    if (length > header.size()) return std::nullopt;
    const std::string_view field = header.substr(0, length);
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    fields.fields_.emplace_back(field.substr(0, equals), field.substr(equals + 1));
    header.remove_prefix(length);
  }
  return fields;
}

std::string_view BagFields::value(std::string_view name) const {
  for (const auto& [field, value] : fields_) {
    if (field == name) return value;
  }
  return {};
}

std::optional<std::uint8_t> BagFields::uint8(std::string_view name) const {
  return integer<std::uint8_t>(value(name));
}

std::optional<std::uint32_t> BagFields::uint32(std::string_view name) const {
  return integer<std::uint32_t>(value(name));
}

std::optional<std::uint64_t> BagFields::uint64(std::string_view name) const {
  return integer<std::uint64_t>(value(name));
}

std::optional<std::uint64_t> BagFields::time_ns(std::string_view name) const {
  constexpr std::uint64_t ns_per_s = 1'000'000'000;
  const std::string_view bytes = value(name);
  if (bytes.size() != 2 * bag_length_bytes) return std::nullopt;
  return bag_length(bytes) * ns_per_s + bag_length(bytes.substr(bag_length_bytes));
}

std::string bag_record_name(std::uint8_t op) {
  switch (static_cast<BagOp>(op)) {
    case BagOp::message:
      return "message";
    case BagOp::bag_header:
      return "bag header";
    case BagOp::chunk:
      return "chunk";
    case BagOp::connection:
      return "connection";
  }
  return fmt::format("record 0x{:02x}", op);
}

}  // namespace tribolog::ingest::bags
