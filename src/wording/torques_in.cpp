#include "wording/torques_in.h"

#include <utility>

namespace tribolog::wording {
namespace {

thread_local joint::TorqueUnit torques = joint::TorqueUnit::newton_metre;

}  // namespace

TorquesIn::TorquesIn(joint::TorqueUnit unit) : before_(std::exchange(torques, unit)) {}

TorquesIn::~TorquesIn() { torques = before_; }

std::string shown_units(std::string text) {
  return torques == joint::TorqueUnit::ampere ? joint::in_amperes(std::move(text)) : text;
}

}  // namespace tribolog::wording
