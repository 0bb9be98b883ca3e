#include "ingest/manifest/text_log_table.h"

#include <array>
#include <cstdint>

namespace tribolog {

TextLogRules read_text_log_rules(const TomlTable& log) {
  constexpr std::array delimiters = {Delimiter::comma, Delimiter::semicolon, Delimiter::tab,
                                     Delimiter::spaces};
  TextLogRules rules;
  if (log.flag_or("decimal_comma", false)) rules.decimal_mark = DecimalMark::comma;
  if (log.has("delimiter")) {
    rules.delimiter =
        delimiters.at(log.choice("delimiter", {"comma", "semicolon", "tab", "spaces"}));
  }
  if (log.has("encoding")) {
    rules.encoding = static_cast<TextEncoding>(log.choice("encoding", {"utf8", "latin1"}));
  }
  if (log.has("header_line")) {
    const std::uint64_t line = log.count_or("header_line", 0);
    constexpr std::uint64_t last = 1'000'000'000;
    if (line < 1 || line > last) {
      log.refuse("header_line", {"not usable", std::to_string(line),
                                 "a line's number, from 1 to " + std::to_string(last), ""});
    }
    rules.header_line = static_cast<long>(line);
  }
  rules.skip_bad_rows = log.flag_or("skip_bad_rows", false);
  if (rules.decimal_mark == DecimalMark::comma && rules.delimiter == Delimiter::comma) {
    log.refuse("delimiter", {"contradicts decimal_comma", "commas for both", "",
                             "commas within numbers and between columns cannot be told apart"});
  }
  log.refuse_unknown_keys();
  return rules;
}

}  // namespace tribolog
