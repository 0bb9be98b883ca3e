#include "ingest/messages/message_tree.h"

#include <fmt/format.h>

namespace tribolog::ingest::messages {

void MessageTree::clear() {
  values_.clear();
  texts_.clear();
  key_ = {};
  open_.clear();
}

void MessageTree::add_key(std::string_view key) {
  if (key.size() > longest_text) {
    throw MessageError(fmt::format("has a field whose name takes {} bytes", key.size()));
  }
  key_ = keep(key);
}

void MessageTree::add_number(double value) { values_[add(Kind::number)].number = value; }

void MessageTree::add_integer(std::int64_t value) {
  Value& added = values_[add(Kind::number)];
  added.number = static_cast<double>(value);
  added.integer = value;
}

void MessageTree::add_text(std::string_view text) {
  const Text kept = keep(text.substr(0, longest_text));
  values_[add(Kind::text)].text = kept;
}

void MessageTree::open(Kind kind) {
  if (open_.size() == deepest) {
    throw MessageError(fmt::format("is nested more than {} deep", deepest));
  }
  open_.push_back(add(kind));
}

void MessageTree::close() {
  values_[open_.back()].after = values_.size();
  open_.pop_back();
}

std::optional<std::size_t> MessageTree::member(std::size_t object, std::string_view name) const {
  if (kind(object) != Kind::object) return std::nullopt;
  for (std::size_t i = object + 1; i < after(object); i = after(i)) {
    if (key(i) == name) return i;
  }
  return std::nullopt;
}

std::size_t MessageTree::add(Kind kind) {
  if (values_.size() == most_values) {
    throw MessageError(fmt::format("has more than {} values", most_values));
  }
  const std::size_t place = values_.size();
  values_.push_back({kind, 0, 0, key_, {}, place + 1});
  key_ = {};
  return place;
}

MessageTree::Text MessageTree::keep(std::string_view text) {
  const Text kept{texts_.size(), text.size()};
  texts_ += text;
  return kept;
}

}  // namespace tribolog::ingest::messages
