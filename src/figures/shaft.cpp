#include "figures/shaft.h"

namespace tribolog::figures {

std::string shaft(const Manifest& manifest) {
  return manifest.drive.gear_ratio() == 1.0 ? "joint" : "motor";
}

std::string speed_quantity(const Manifest& manifest) {
  return manifest.drive.gear_ratio() == 1.0 ? "joint speed q\u0307" : "motor speed φ\u0307";
}

}  // namespace tribolog::figures
