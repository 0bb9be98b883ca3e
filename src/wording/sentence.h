#pragma once
// What is said in the middle of a sentence, as one of its own.

#include <string>

#include "base/statement.h"

namespace tribolog::wording {

/// With a capital letter, as a label has it. A leading symbol ("q_peak", "n", "σ₀") keeps its
/// letter.
std::string capitalised(const std::string& text);
std::string capitalised(const Statement& statement);

/// The same with a full stop.
std::string as_sentence(const std::string& text);
std::string as_sentence(const Statement& statement);

}  // namespace tribolog::wording
