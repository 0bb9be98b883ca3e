#include "wording/shaft.h"

namespace tribolog::wording {

std::string shaft(const joint::Manifest& manifest) {
  return manifest.drive.gear_ratio() == 1.0 ? "joint" : "motor";
}

std::string speed_symbol(const joint::Manifest& manifest) {
  return manifest.drive.gear_ratio() == 1.0 ? "q\u0307" : "φ\u0307";
}

std::string speed_quantity(const joint::Manifest& manifest) {
  return shaft(manifest) + " speed " + speed_symbol(manifest);
}

}  // namespace tribolog::wording
