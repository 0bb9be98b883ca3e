#pragma once
// UTF-8 that may be broken, to code points and back.

#include <cstddef>
#include <string>
#include <string_view>

namespace tribolog::render::text {

struct DecodedText {
  std::u32string text;
  std::size_t replaced{};  ///< Malformed sequences and control characters, each shown as '?'.
};

/// Never fails: what is not a Unicode scalar value (overlong, surrogate, cut off) becomes '?', so
/// do control characters; tab and line break become a space.
DecodedText decode_utf8(std::string_view bytes);

std::string encode_utf8(std::u32string_view text);

}  // namespace tribolog::render::text
