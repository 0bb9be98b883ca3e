#include "wording/catalogue.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

namespace tribolog::wording {
namespace {

/// Where sentences may end: behind each of these and its blank.
std::vector<std::size_t> sentence_ends(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t at = 0; at + 2 < text.size(); ++at) {
    const bool is_end = text[at] == '.' || text[at] == ';' || text[at] == ':';
    if (is_end && text[at + 1] == ' ') ends.push_back(at + 2);
  }
  ends.push_back(text.size());
  return ends;
}

/// Polish letters beyond ASCII, small and large.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> letters = {{{"ą", "Ą"},
                                                                                   {"ć", "Ć"},
                                                                                   {"ę", "Ę"},
                                                                                   {"ł", "Ł"},
                                                                                   {"ń", "Ń"},
                                                                                   {"ó", "Ó"},
                                                                                   {"ś", "Ś"},
                                                                                   {"ź", "Ź"},
                                                                                   {"ż", "Ż"}}};

std::string with_large_letter(std::string text) {
  for (const auto& [small, large] : letters) {
    if (text.starts_with(small)) return text.replace(0, small.size(), large);
  }
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// "The joint" and "A loop", but not "T at" or "LuGre": a sentence that begins large only because
/// it stands first.
std::string with_small_letter(std::string_view text) {
  const auto is_small = [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; };
  const bool is_large = !text.empty() && std::isupper(static_cast<unsigned char>(text[0])) != 0;
  const bool is_word = text.size() > 1 && (is_small(text[1]) || (text[0] == 'A' && text[1] == ' '));
  if (!is_large || !is_word) return {};
  std::string small(text);
  small[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(small[0])));
  return small;
}

void keep(std::map<std::string, std::string, std::less<>>& messages, const std::string& message,
          const std::string& translation, const std::string& file) {
  const auto [entry, is_new] = messages.emplace(message, translation);
  if (!is_new && entry->second != translation) {
    throw std::invalid_argument(file + ": \"" + message + "\" has two translations");
  }
}

}  // namespace

void Catalogue::add(std::string_view json, const std::string& file) {
  const nlohmann::json content = nlohmann::json::parse(json, nullptr, false);
  if (!content.is_object()) throw std::invalid_argument(file + ": no object of messages");
  for (const auto& [kind, messages] : content.items()) {
    if ((kind != "templates" && kind != "texts") || !messages.is_object()) {
      throw std::invalid_argument(file + ": \"" + kind + "\" is neither templates nor texts");
    }
    for (const auto& [message, translation] : messages.items()) {
      if (!translation.is_string() || translation.get<std::string>().empty()) {
        throw std::invalid_argument(file + ": \"" + message + "\" has no translation");
      }
      if (kind == "templates") {
        keep(templates_, message, translation.get<std::string>(), file);
      } else {
        add_text(message, translation.get<std::string>(), file);
      }
    }
  }
}

void Catalogue::add_text(const std::string& message, const std::string& translation,
                         const std::string& file) {
  MessagePattern pattern(message);
  if (!pattern.has_places()) return keep(exact_, message, translation, file);
  (void)fill_places(translation, std::vector<std::string>(pattern.places(), "1"));
  const auto says_less = [&pattern](const Message& other) {
    return other.pattern.own_length() < pattern.own_length();
  };
  const auto at = std::find_if(with_places_.begin(), with_places_.end(), says_less);
  with_places_.insert(at, {std::move(pattern), translation});
}

std::string Catalogue::find_whole(std::string_view text) const {
  const std::string small = with_small_letter(text);
  if (const auto found = exact_.find(text); found != exact_.end()) return found->second;
  if (const auto found = exact_.find(small); !small.empty() && found != exact_.end()) {
    return with_large_letter(found->second);
  }
  for (const Message& message : with_places_) {
    std::string found = fill(message, text);
    if (!found.empty()) return found;
    if (!small.empty()) found = fill(message, small);
    if (!found.empty()) return with_large_letter(std::move(found));
  }
  return {};
}

/// "" where the text is another message.
std::string Catalogue::fill(const Message& message, std::string_view text) const {
  const auto placed = message.pattern.match(text);
  if (!placed) return {};
  std::vector<std::string> texts;
  for (const PlacedText& one : *placed) {
    texts.push_back(one.is_translated ? translate(one.text) : std::string(one.text));
  }
  return fill_places(message.translation, texts);
}

/// With its end or without: the end stays.
std::string Catalogue::find_sentence(std::string_view text) const {
  std::string found = find_whole(text);
  const char end = text.empty() ? ' ' : text.back();
  if (found.empty() && text.size() > 1 && (end == '.' || end == ';' || end == ':')) {
    found = find_whole(text.substr(0, text.size() - 1));
    if (!found.empty()) found += end;
  }
  return found;
}

std::string Catalogue::find_by_sentences(std::string_view text) const {
  std::string all;
  while (!text.empty()) {
    // The longest run of sentences that is known: a message may hold an end of its own.
    std::vector<std::size_t> ends = sentence_ends(text);
    std::string found;
    for (; found.empty() && !ends.empty(); ends.pop_back()) {
      const bool is_last = ends.back() == text.size();
      found = find_sentence(text.substr(0, is_last ? text.size() : ends.back() - 1));
      if (found.empty()) continue;
      all += found;
      if (!is_last) all += ' ';
      text.remove_prefix(ends.back());
    }
    if (found.empty()) return {};
  }
  return all;
}

std::string Catalogue::find(std::string_view text) const {
  std::string found = find_whole(text);
  return found.empty() ? find_by_sentences(text) : found;
}

std::string Catalogue::translate(std::string_view text) const {
  std::string found = find(text);
  return found.empty() ? std::string(text) : found;
}

std::string Catalogue::find_in_templates(const std::string& message) const {
  const auto found = templates_.find(message);
  return found == templates_.end() ? std::string() : found->second;
}

std::vector<std::string> Catalogue::template_messages() const {
  std::vector<std::string> messages;
  for (const auto& [message, translation] : templates_) messages.push_back(message);
  return messages;
}

}  // namespace tribolog::wording
