#include "report/estimator_words.h"

#include <cctype>

#include "paper/drawings/printed_paper.h"

namespace tribolog::report {

std::string point_meaning(const std::string& point) {
  if (point == "A") return "z = 0 while the arm rises";
  if (point == "B") return "z = 0 while the arm drops";
  if (point == "C") return "z at its maximum";
  if (point == "D") return "z at its minimum";
  if (point == "E") return "dz/dt at its maximum (arm rising)";
  if (point == "F") return "dz/dt at its minimum (arm dropping)";
  if (point == "AB") return "mean of A and B, steady loop";
  if (point == "CD") return "mean of C and D, steady loop";
  if (point == "EF") return "mean of E and F, steady loop";
  if (point == "midline") return "mid-line of the steady loop";
  if (point == "fit") return "gravity torque of LuGre fitted to all loops";
  if (point == "sweep") return "gravity amplitude of the rough sweep";
  if (point == "runs") return "gravity amplitude of the runs at constant speed";
  if (point == "stated") return "gravity that the manifest states; nothing is decided by it";
  return "–";
}

bool is_papers_joint(const std::string& robot, double gear_ratio) {
  std::string letters;
  for (const char c : robot) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return letters.find("am100ib") != std::string::npos && gear_ratio == paper::drawings::gear_ratio;
}

}  // namespace tribolog::report
