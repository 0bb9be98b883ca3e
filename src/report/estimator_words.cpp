#include "report/estimator_words.h"

#include "wording/tr.h"

namespace tribolog::report {

namespace {
using wording::tr;
}

std::string point_meaning(const std::string& point) {
  if (point == "A") return tr("z = 0 while the arm rises");
  if (point == "B") return tr("z = 0 while the arm drops");
  if (point == "C") return tr("z at its maximum");
  if (point == "D") return tr("z at its minimum");
  if (point == "E") return tr("dz/dt at its maximum (arm rising)");
  if (point == "F") return tr("dz/dt at its minimum (arm dropping)");
  if (point == "AB") return tr("mean of A and B, steady loop");
  if (point == "CD") return tr("mean of C and D, steady loop");
  if (point == "EF") return tr("mean of E and F, steady loop");
  if (point == "midline") return tr("mid-line of the steady loop");
  if (point == "fit") return tr("gravity torque of LuGre fitted to all loops");
  if (point == "sweep") return tr("gravity amplitude of the rough sweep");
  if (point == "runs") return tr("gravity amplitude of the runs at constant speed");
  if (point == "stated") return tr("gravity stated in the manifest; it decides nothing");
  return "–";
}

}  // namespace tribolog::report
