#pragma once
// What must not reach the TOML parser.
//
// Some released versions of toml++ answer certain malformed texts with undefined behaviour (its
// issues 190 and 295: characters beyond ASCII where no text is) or with a recursion as deep as a
// key has dots. Those texts are no valid or no sensible TOML; they are refused before the parser.

#include <string>
#include <string_view>

namespace tribolog::ingest::manifest {

/// @throw InputError for broken UTF-8, a character beyond ASCII outside of quotes and comments, a
///        backslash before such a character, a quote or a bracket in the middle of a key or value,
///        or a key with over 50 dots.
void precheck_toml(std::string_view text, const std::string& file);

}  // namespace tribolog::ingest::manifest
