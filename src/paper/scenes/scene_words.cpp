#include "paper/scenes/scene_words.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace tribolog::scenes {

std::string degrees_text(double rad, int places) {
  const double degrees = rad * 180 / std::numbers::pi;
  const std::string size = fmt::format("{:.{}f}°", std::abs(degrees), places);
  const bool zero = size.find_first_of("123456789") == std::string::npos;
  return (degrees < 0 && !zero ? "−" : "") + size;
}

std::string millimetres_text(double metres) { return fmt::format("{:.0f} mm", 1000 * metres); }

std::string kilogram_text(double kg) { return fmt::format("{:.4g} kg", kg); }

std::string index_text(const std::string& joint_name) {
  return joint_name.size() == 1 ? joint_name : "(" + joint_name + ")";
}

std::string dimensions_note(const RobotDescription& robot) {
  return robot.approximate ? " Dimensions are approximate." : "";
}

}  // namespace tribolog::scenes
