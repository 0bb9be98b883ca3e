#include "study/small_scenario.h"

#include "support/paper_joint.h"

namespace tribolog::test {

simulate::Scenario small_scenario() {
  simulate::Scenario s = noisy_paper_joint(1);
  s.rough_sweep->speed_rad_s *= 20;
  s.precise_sweep.reset();
  s.constant_speed.reset();
  s.oscillation->cycles = 5;
  return s;
}

}  // namespace tribolog::test
