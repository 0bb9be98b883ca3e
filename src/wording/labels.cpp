#include "wording/labels.h"

#include <algorithm>

#include <fmt/format.h>

#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::wording {

std::string reading_label(const std::string& reading) {
  const std::string words = words_for("reading", reading);
  const std::size_t mark = words.find('_');
  if (mark == std::string::npos) return words;
  const std::size_t end = std::min(words.find(' ', mark), words.size());
  return fmt::format("{}{{{}}}{}", words.substr(0, mark + 1),
                     words.substr(mark + 1, end - mark - 1), words.substr(end));
}

bool has_motor_side(const joint::Manifest& manifest) { return manifest.drive.gear_ratio() != 1.0; }

std::string shaft(const joint::Manifest& manifest) {
  return has_motor_side(manifest) ? tr("motor") : tr("joint");
}

std::string speed_symbol(const joint::Manifest& manifest) {
  return has_motor_side(manifest) ? "φ\u0307" : "q\u0307";
}

std::string speed_quantity(const joint::Manifest& manifest) {
  const std::string symbol = speed_symbol(manifest);
  return has_motor_side(manifest) ? tr("motor speed {symbol}", {{"symbol", symbol}})
                                  : tr("joint speed {symbol}", {{"symbol", symbol}});
}

std::string speed_size(const joint::Manifest& manifest) {
  const std::string symbol = speed_symbol(manifest);
  return has_motor_side(manifest) ? tr("magnitude of motor speed {symbol}", {{"symbol", symbol}})
                                  : tr("magnitude of joint speed {symbol}", {{"symbol", symbol}});
}

}  // namespace tribolog::wording
