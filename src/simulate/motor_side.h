#pragma once
// A motion of the joint as its motor sees it.

#include "simulate/motion.h"

namespace tribolog {

/// Refers to the joint's motion, which must outlive it.
class MotorSide final : public Motion {
 public:
  MotorSide(const Motion& joint, double gear_ratio) : joint_(joint), n_(gear_ratio) {}
  [[nodiscard]] double angle(double t_s) const override { return n_ * joint_.angle(t_s); }
  [[nodiscard]] double speed(double t_s) const override { return n_ * joint_.speed(t_s); }
  [[nodiscard]] double acceleration(double t_s) const override {
    return n_ * joint_.acceleration(t_s);
  }

 private:
  const Motion& joint_;
  double n_;
};

}  // namespace tribolog
