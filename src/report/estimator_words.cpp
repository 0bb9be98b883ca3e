#include "report/estimator_words.h"

#include "wording/tr.h"

namespace tribolog::report {

namespace {
using method::hysteresis::Estimator;
using wording::tr;
}  // namespace

std::string meaning_of(Estimator estimator) {
  switch (estimator) {
    case Estimator::A:
      return tr("z = 0 while the arm rises");
    case Estimator::B:
      return tr("z = 0 while the arm drops");
    case Estimator::C:
      return tr("z at its maximum");
    case Estimator::D:
      return tr("z at its minimum");
    case Estimator::E:
      return tr("dz/dt at its maximum (arm rising)");
    case Estimator::F:
      return tr("dz/dt at its minimum (arm dropping)");
    case Estimator::AB:
      return tr("mean of A and B, steady loop");
    case Estimator::CD:
      return tr("mean of C and D, steady loop");
    case Estimator::EF:
      return tr("mean of E and F, steady loop");
    case Estimator::midline:
      return tr("mid-line of the steady loop");
    case Estimator::fit:
      return tr("gravity torque of LuGre fitted to all loops");
    case Estimator::sweep:
      return tr("gravity amplitude of the rough sweep");
    case Estimator::model:
      return tr("gravity of the model of sweeps and runs");
    case Estimator::stated:
      return tr("gravity stated in the manifest");
  }
  return "–";
}

}  // namespace tribolog::report
