#include "paper/scenes/scene_words.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "joint/degrees.h"
#include "wording/tr.h"

namespace tribolog::paper::scenes {

std::string degrees_text(double rad, int places) {
  const double degrees = rad * joint::degrees_per_rad;
  const std::string size = fmt::format("{:.{}f}°", std::abs(degrees), places);
  const bool zero = size.find_first_of("123456789") == std::string::npos;
  return (degrees < 0 && !zero ? "−" : "") + size;
}

int places_for(const robot::AngleRange& range) {
  const double span_deg = (range.highest_rad - range.lowest_rad) * joint::degrees_per_rad;
  return span_deg >= 10 ? 0 : span_deg >= 1 ? 1 : 3;
}

std::string millimetres_text(double metres) { return fmt::format("{:.0f} mm", 1000 * metres); }

std::string kilogram_text(double kg) { return fmt::format("{:.4g} kg", kg); }

std::string drawn_text(const std::string& text, std::size_t limit) {
  std::string drawn = printable(text, limit);
  std::replace(drawn.begin(), drawn.end(), '{', '(');
  std::replace(drawn.begin(), drawn.end(), '}', ')');
  return drawn;
}

std::string index_text(const std::string& joint_name) {
  constexpr std::size_t longest_plain = 3;
  constexpr std::size_t longest = 16;
  const bool plain =
      joint_name.size() <= longest_plain &&
      std::all_of(joint_name.begin(), joint_name.end(), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
      });
  return plain ? joint_name : fmt::format("({})", drawn_text(joint_name, longest));
}

std::string dimensions_note(const robot::RobotDescription& robot) {
  return robot.approximate ? wording::tr("Dimensions are approximate.") : "";
}

std::string sentences(std::initializer_list<std::string> all) {
  std::string text;
  for (const std::string& one : all) {
    if (!text.empty() && !one.empty()) text += ' ';
    text += one;
  }
  return text;
}

}  // namespace tribolog::paper::scenes
