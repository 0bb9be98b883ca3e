#include "base/base64.h"

#include <stdexcept>
#include <vector>

namespace tribolog {
namespace {

constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

unsigned nibble(char digit) {
  if (digit >= '0' && digit <= '9') return static_cast<unsigned>(digit - '0');
  if (digit >= 'a' && digit <= 'f') return static_cast<unsigned>(digit - 'a') + 10U;
  if (digit >= 'A' && digit <= 'F') return static_cast<unsigned>(digit - 'A') + 10U;
  throw std::invalid_argument("not a hex digit");
}

}  // namespace

std::string base64(std::span<const std::byte> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t given = bytes.size() - i;
    const unsigned first = std::to_integer<unsigned>(bytes[i]);
    const unsigned second = given > 1 ? std::to_integer<unsigned>(bytes[i + 1]) : 0U;
    const unsigned third = given > 2 ? std::to_integer<unsigned>(bytes[i + 2]) : 0U;
    const unsigned group = (first << 16U) | (second << 8U) | third;
    text += alphabet[(group >> 18U) & 63U];
    text += alphabet[(group >> 12U) & 63U];
    text += given > 1 ? alphabet[(group >> 6U) & 63U] : '=';
    text += given > 2 ? alphabet[group & 63U] : '=';
  }
  return text;
}

std::string base64_of_hex(const std::string& hex) {
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::byte>((nibble(hex[i]) << 4U) | nibble(hex[i + 1])));
  }
  return base64(bytes);
}

}  // namespace tribolog
