#pragma once
// Internal to wording and the templates: messages as they stand in the language of this thread's
// words, their values not yet in them.

#include <cstdint>
#include <string>
#include <string_view>

namespace tribolog::wording {

/// The message itself where there is no translation.
std::string translated(std::string_view message);

/// The form for that count, by the language's own rule.
std::string translated(std::string_view one, std::string_view many, std::int64_t count);

}  // namespace tribolog::wording
