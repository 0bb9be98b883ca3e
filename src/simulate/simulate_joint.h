#pragma once
// A scenario to recordings: inverse dynamics of the joint under an ideal source of motion, eq. (8)
//
//   T = J phi'' + Tf + (I q'' + m g r cos(q - q_peak)) / n,      phi = n q
//
// with the noise of a real drive laid on top. A shaft at rest may hold back any torque up to static
// friction, and what is applied is the answer here, not the question: a static law gives 0 then, a
// model with memory what its state holds.

#include <vector>

#include "joint/dataset.h"
#include "joint/recording.h"
#include "simulate/motion.h"
#include "simulate/scenario.h"

namespace tribolog::simulate {

/// The motion of one run at constant speed.
TravelMotion::Plan run_at(double motor_speed_rad_s, const ConstantSpeedExperiment& experiment,
                          double gear_ratio);

/// A recording of true signals, as an ideal drive would log it.
struct IdealRecording {
  joint::Recording recording;
  double sample_rate_Hz{};
};

/// The scenario's recordings without its noise, in the order of simulate_joint().
/// @throw Refusal as simulate_joint().
std::vector<IdealRecording> simulate_ideal_joint(const Scenario& scenario);

/// The same with noise laid on: simulate_joint() in two steps, so that many runs of the same
/// motions can share the first.
/// @throw Refusal if a noise quantity is negative or not finite.
std::vector<joint::Recording> with_noise(std::vector<IdealRecording> ideal, const Noise& noise,
                                         double gear_ratio);

/// The recordings in the order rough, precise, sine sweep, oscillations, constant speeds, ramps (as
/// asked for by the scenario). Names are file names such as "rough_sweep.csv" and
/// "constant_speed_07.csv". The same scenario, seed included, gives the same numbers on every
/// machine.
/// @throw Refusal for an experiment that cannot be carried out, naming the key, or
/// where there is no friction model.
std::vector<joint::Recording> simulate_joint(const Scenario& scenario);

// A scenario to a dataset, without files in between.

/// The recordings of simulate_joint() with the facts that a manifest would state: motor torque at
/// the motor, and the friction that was simulated as the known curve. Inputs are empty.
/// @throw Refusal as simulate_joint().
joint::Dataset simulated_dataset(const Scenario& scenario);

/// The same for recordings of it that were made already.
joint::Dataset simulated_dataset(const Scenario& scenario,
                                 std::vector<joint::Recording> recordings);

}  // namespace tribolog::simulate
