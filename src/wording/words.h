#pragma once
// Sentences of what the method states: the one place where a code becomes words.

#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "base/statement.h"

namespace tribolog::wording {

/// The statement's sentence; empty for an empty one.
/// @throw std::logic_error naming the code: there is no message for it, or one of its values is
///        missing.
std::string words(const Statement& statement);

/// Of each, in order.
std::vector<std::string> words(const std::vector<Statement>& statements);

/// What an error says: the sentence of what a Refusal or a FigureError states, what() of every
/// other. Where there is no message for it, what() as well: the code.
std::string words(const std::exception& error);

/// The message without values that stands for a key: words_for("quantity", "coulomb_torque").
/// @throw std::logic_error where there is none.
std::string words_for(std::string_view topic, std::string_view key);

/// The text in the language of this thread's words where it is the message that stands for the key;
/// else as it is: what an archive calls a quantity.
std::string words_for(std::string_view topic, std::string_view key, const std::string& text);

/// Whether there is a message for this code.
bool has_words(std::string_view code);

// What is said in the middle of a sentence, as one of its own.

/// With a capital letter, as a label has it. A leading symbol ("q_peak", "n", "σ₀") keeps its
/// letter.
std::string capitalised(const std::string& text);
std::string capitalised(const Statement& statement);

/// As it stands within a sentence: a label's capital becomes small, that of a person's name stays.
std::string within_a_sentence(const std::string& label);

/// With a capital letter and a full stop.
std::string as_sentence(const std::string& text);
std::string as_sentence(const Statement& statement);
/// A dash for text that is not stated.
std::string or_dash(const std::string& text);

}  // namespace tribolog::wording
