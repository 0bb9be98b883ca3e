#pragma once
// The unit of torques in the texts that are made just now.

#include <string>

#include "joint/quantity.h"

namespace tribolog::wording {

/// While it lives, words(), tr() and units on this thread are those of a joint whose torques are
/// numbers of this unit; newton metres otherwise.
class TorquesIn {
 public:
  explicit TorquesIn(joint::TorqueUnit unit);
  TorquesIn(const TorquesIn&) = delete;
  TorquesIn& operator=(const TorquesIn&) = delete;
  ~TorquesIn();

 private:
  joint::TorqueUnit before_;
};

/// A unit or a text with units of N·m, as this thread's texts have it: "N·m/rad", or "A/rad".
std::string shown_units(std::string text);

}  // namespace tribolog::wording
