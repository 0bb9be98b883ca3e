#include "ingest/text/plain_json.h"

namespace tribolog::ingest::text {

PlainJson without_foreign_numbers(std::string_view text) {
  PlainJson plain;
  plain.text.reserve(text.size());
  bool in_string = false;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    if (in_string && text[i] == '\\' && rest.size() > 1) {
      plain.text += rest.substr(0, 2);
      i += 2;
    } else if (!in_string && rest.starts_with("NaN")) {
      plain.text += "null";
      plain.inserted.push_back(plain.text.size());
      i += 3;
    } else if (!in_string && (rest.starts_with("Infinity") || rest.starts_with("-Infinity"))) {
      const std::size_t length = text[i] == '-' ? 9 : 8;
      plain.text += "null" + std::string(length - 4, ' ');
      i += length;
    } else {
      in_string = in_string != (text[i] == '"');
      plain.text += text[i++];
    }
  }
  return plain;
}

}  // namespace tribolog::ingest::text
