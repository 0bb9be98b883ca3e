#include "ingest/bags/json_messages.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "ingest/text/plain_json.h"

namespace tribolog::ingest::bags {
namespace {

using messages::MessageError;
using messages::MessageTree;

class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit TreeBuilder(MessageTree& tree) : tree_(tree) {}

  bool null() override { return tree_.add_gap(), true; }
  bool boolean(bool value) override { return add(value ? 1 : 0); }
  bool number_integer(number_integer_t value) override { return tree_.add_integer(value), true; }
  bool number_unsigned(number_unsigned_t value) override {
    return value <= std::numeric_limits<std::int64_t>::max()
               ? number_integer(static_cast<std::int64_t>(value))
               : add(static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return tree_.add_text(value), true; }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(MessageTree::Kind::object); }
  bool start_array(std::size_t) override { return open(MessageTree::Kind::array); }
  bool key(string_t& name) override { return tree_.add_key(name), true; }
  bool end_object() override { return tree_.close(), true; }
  bool end_array() override { return tree_.close(), true; }
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception&) override {
    throw MessageError(
        fmt::format("is no JSON: '{}' stands at its byte {}", printable(token, 60), position));
  }

 private:
  bool add(double value) { return tree_.add_number(value), true; }
  bool open(MessageTree::Kind kind) { return tree_.open(kind), true; }

  MessageTree& tree_;
};

bool may_have_foreign_numbers(std::string_view text) {
  return text.find("NaN") != std::string_view::npos ||
         text.find("Infinity") != std::string_view::npos;
}

}  // namespace

void JsonDecoder::decode(std::string_view message, MessageTree& tree) {
  TreeBuilder builder(tree);
  if (may_have_foreign_numbers(message)) {
    nlohmann::json::sax_parse(text::without_foreign_numbers(message).text, &builder);
  } else {
    nlohmann::json::sax_parse(message, &builder);
  }
}

}  // namespace tribolog::ingest::bags
