// Bad fits never pass: the paper's joint, broken in one way after another. Each breach is found by
// name, and the verdict over all is never "usable". Where nothing in the logs can show a breach,
// the test says so and what would show it.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "method/checks/data_checks.h"
#include "statistics/random_stream.h"
#include "support/breadth.h"
#include "support/paper_joint.h"
#include "wording/words.h"

namespace tribolog::broken_datasets_test {
namespace {

using method::checks::CheckName;
using method::hysteresis::Estimator;

using std::numbers::pi;

/// The joint that is broken below: noise of a real drive, eight positions, so that it is usable.
simulate::Scenario good_joint() {
  simulate::Scenario s = test::noisy_paper_joint(1);
  auto places = simulate::spread_over_motor_turn(*s.oscillation, 8, s.gear_ratio);
  s.oscillation = places.front();
  s.further_oscillations.assign(places.begin() + 1, places.end());
  return s;
}

joint::Dataset good_dataset() {
  static const joint::Dataset good = simulate::simulated_dataset(good_joint());
  return good;
}

calibration::Calibration identified(const joint::Dataset& d) { return identify::identify(d); }

void each(joint::Dataset& d, const std::function<void(joint::Recording&)>& change) {
  for (joint::Recording& r : d.recordings) change(r);
}

void scale(std::vector<double>& values, double factor) {
  for (double& value : values) value *= factor;
}

void keep_role(joint::Dataset& d, joint::Role role, std::size_t most) {
  std::size_t kept = 0;
  std::erase_if(d.recordings,
                [&](const joint::Recording& r) { return r.role == role && ++kept > most; });
}

/// Keeps the samples for which `wanted(i)` holds.
void keep_samples(joint::Recording& r, const std::function<bool(std::size_t)>& wanted) {
  for (std::vector<double>* v : {&r.t_s, &r.q_rad, &r.dq_rad_s, &r.torque_Nm}) {
    std::size_t to = 0;
    for (std::size_t i = 0; i < v->size(); ++i) {
      if (wanted(i)) (*v)[to++] = (*v)[i];
    }
    v->resize(to);
  }
}

/// The first half: there, but not back.
void only_there(joint::Recording& r) {
  const std::size_t half = r.size() / 2;
  keep_samples(r, [&](std::size_t i) { return i < half; });
}

/// `times` the recording in a row, with a torque that `change` alters over the whole of it.
void repeat(joint::Recording& r, int times, const std::function<void(joint::Recording&)>& change) {
  const joint::Recording once = r;
  const double duration = once.t_s.back() + (once.t_s[1] - once.t_s[0]);
  for (int k = 1; k < times; ++k) {
    for (const double t : once.t_s) r.t_s.push_back(t + k * duration);
    const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(r.q_rad, once.q_rad);
    append(r.dq_rad_s, once.dq_rad_s);
    append(r.torque_Nm, once.torque_Nm);
  }
  change(r);
}

/// Friction of the sweep alone: what is not gravity.
double friction_of(const joint::Recording& r, std::size_t i) {
  return r.torque_Nm[i] - test::true_gravity_Nm * std::cos(r.q_rad[i] - test::true_q_peak_rad());
}

/// As if its logs came from a logger that is known, with this effort column.
void written_by(joint::Dataset& d, const joint::LoggedEffort& effort) {
  joint::InputFile input;
  input.name = "log.csv";
  input.logged_effort = effort;
  d.inputs.push_back(input);
}

struct Breach {
  std::string name;
  CheckName check;  ///< The data check that fails.
  std::function<void(joint::Dataset&)> make;
  std::string word;  ///< In what it found; may be empty.
};

std::ostream& operator<<(std::ostream& out, const Breach& breach) { return out << breach.name; }

class BrokenDataset : public testing::TestWithParam<Breach> {};

TEST_P(BrokenDataset, IsFoundByNameAndNeverUsable) {
  joint::Dataset d = good_dataset();
  GetParam().make(d);
  const calibration::Calibration c = identified(d);
  const method::checks::DataCheck* check = c.data_checks.find(GetParam().check);
  ASSERT_NE(check, nullptr);
  EXPECT_EQ(check->state, method::checks::CheckState::fails) << wording::words(check->found);
  EXPECT_NE(wording::words(check->found).find(GetParam().word), std::string::npos)
      << wording::words(check->found);
  EXPECT_FALSE(check->consequence.empty());
  EXPECT_FALSE(check->experiment.empty());
  if (c.selection.recommended == method::hysteresis::Estimator::model &&
      (check->name == CheckName::torque_ripple || check->name == CheckName::oscillation_at_peak)) {
    // Sweeps and runs average over the ripple that the loop's position holds, and pass through the
    // peak: their mass can be used.
    const auto* gravity = c.judgement.find(joint::Quantity::gravity_torque);
    EXPECT_LE(gravity->estimate->low, test::true_gravity_Nm);
    EXPECT_GE(gravity->estimate->high, test::true_gravity_Nm);
  } else if (check->name == CheckName::angle_interpolated) {
    // Gravity asks for no acceleration.
    for (const joint::Quantity bent :
         {joint::Quantity::inertia, joint::Quantity::bristle_damping}) {
      EXPECT_NE(c.judgement.find(bent)->verdict, calibration::Verdict::usable);
    }
  } else {
    EXPECT_NE(c.judgement.verdict, calibration::Verdict::usable)
        << wording::words(c.judgement.sentence);
  }
  const auto& findings = c.judgement.findings;
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [&](const Statement& finding) {
    return wording::words(finding).find(wording::words(check->found)) != std::string::npos;
  }));
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    EXPECT_EQ(q.verdict == calibration::Verdict::usable, q.reasons.empty())
        << to_string(q.quantity);
    EXPECT_EQ(q.verdict == calibration::Verdict::usable, q.experiment.empty())
        << to_string(q.quantity);
  }
}

const std::vector<Breach>& breaches() {
  static const std::vector<Breach> all{
      {"constant_joint", CheckName::joint_moves,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           std::fill(r.q_rad.begin(), r.q_rad.end(), r.q_rad.front());
         });
       },
       "does not change"},
      {"one_recording_without_motion", CheckName::joint_moves,
       [](joint::Dataset& d) {
         auto& q = d.recordings.back().q_rad;
         std::fill(q.begin(), q.end(), q.front());
       },
       "1 of"},
      {"target_torque", CheckName::effort_provenance,
       [](joint::Dataset& d) {
         d.manifest.drive = joint::Drive(100, joint::EffortKind::target_torque, joint::Side::motor);
       },
       "not a measurement"},
      {"target_column_as_measurement", CheckName::effort_column,
       [](joint::Dataset& d) {
         written_by(d, {"UR RTDE", "target_moment_2", joint::EffortKind::target_torque,
                        joint::Side::joint, true, false});
       },
       "a controller target"},
      {"current_column_as_torque", CheckName::effort_column,
       [](joint::Dataset& d) {
         written_by(d, {"UR RTDE", "actual_current_2", joint::EffortKind::motor_current,
                        joint::Side::motor, false, false});
       },
       "a 'motor_current'"},
      {"motor_torque_as_joint_torque", CheckName::static_torque,
       [](joint::Dataset& d) {
         d.manifest.known_gravity.emplace(100 * test::true_gravity_Nm, test::true_q_peak_rad());
         each(d, [](joint::Recording& r) { scale(r.torque_Nm, 0.01); });
       },
       "one over the gear ratio"},
      {"torque_sign_against_the_weight", CheckName::static_torque,
       [](joint::Dataset& d) {
         d.manifest.known_gravity.emplace(100 * test::true_gravity_Nm, test::true_q_peak_rad());
         each(d, [](joint::Recording& r) { scale(r.torque_Nm, -1); });
       },
       "sign of the effort"},
      {"dead_torque", CheckName::torque_alive,
       [](joint::Dataset& d) {
         each(d,
              [](joint::Recording& r) { std::fill(r.torque_Nm.begin(), r.torque_Nm.end(), 1.25); });
       },
       "dead"},
      {"held_torque", CheckName::torque_held,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           for (std::size_t i = 300; i + 60 < r.size(); i += 300) {
             std::fill_n(r.torque_Nm.begin() + static_cast<std::ptrdiff_t>(i), 60,
                         r.torque_Nm[i - 1]);
           }
         });
       },
       "repeat the previous torque"},
      {"degrees_as_radians", CheckName::angle_unit,
       [](joint::Dataset& d) { each(d, [](joint::Recording& r) { scale(r.q_rad, 180 / pi); }); },
       "degrees"},
      {"radians_as_degrees", CheckName::gravity_within_torque,
       [](joint::Dataset& d) { each(d, [](joint::Recording& r) { scale(r.q_rad, pi / 180); }); },
       "offset"},
      {"motor_angle_as_joint_angle", CheckName::angle_unit,
       [](joint::Dataset& d) { each(d, [](joint::Recording& r) { scale(r.q_rad, 100); }); },
       "motor's angle"},
      {"millinewtonmetre_as_newtonmetre", CheckName::power,
       [](joint::Dataset& d) { each(d, [](joint::Recording& r) { scale(r.torque_Nm, 1000); }); },
       "mN"},
      {"joint_torque_as_motor_torque", CheckName::power,
       [](joint::Dataset& d) { each(d, [](joint::Recording& r) { scale(r.torque_Nm, 100); }); },
       "joint"},
      {"speed_off_by_2", CheckName::speed_scale,
       [](joint::Dataset& d) { each(d, [](joint::Recording& r) { scale(r.dq_rad_s, 2); }); },
       "two samples"},
      {"speed_off_by_5_3", CheckName::speed_scale,
       [](joint::Dataset& d) { each(d, [](joint::Recording& r) { scale(r.dq_rad_s, 5.0 / 3); }); },
       "10 ms"},
      {"speed_in_degrees", CheckName::speed_scale,
       [](joint::Dataset& d) { each(d, [](joint::Recording& r) { scale(r.dq_rad_s, 180 / pi); }); },
       "degrees"},
      {"speed_of_the_motor", CheckName::speed_scale,
       [](joint::Dataset& d) { each(d, [](joint::Recording& r) { scale(r.dq_rad_s, 100); }); },
       "gear ratio"},
      {"speed_in_rpm", CheckName::speed_scale,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) { scale(r.dq_rad_s, 60 / (2 * pi)); });
       },
       "revolutions"},
      {"speed_sign", CheckName::speed_scale,
       [](joint::Dataset& d) { each(d, [](joint::Recording& r) { scale(r.dq_rad_s, -1); }); },
       "sign"},
      {"wrong_gear_ratio_with_motor_speed", CheckName::speed_scale,
       // The motor's speed was divided by the stated 80, the joint's angle needs no ratio.
       [](joint::Dataset& d) {
         d.manifest.drive = joint::Drive(80, joint::EffortKind::motor_torque, joint::Side::motor);
         each(d, [](joint::Recording& r) { scale(r.dq_rad_s, 100.0 / 80); });
       },
       "1.25"},
      {"torque_sign", CheckName::friction_dissipates,
       [](joint::Dataset& d) { each(d, [](joint::Recording& r) { scale(r.torque_Nm, -1); }); },
       "sign"},
      {"angle_sign", CheckName::friction_dissipates,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           scale(r.q_rad, -1);
           scale(r.dq_rad_s, -1);
         });
       },
       "sign"},
      {"clipped_torque", CheckName::torque_saturation,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           for (double& t : r.torque_Nm) t = std::min(t, 4.0);
         });
       },
       "stuck at 4 "},
      {"coarse_torque", CheckName::torque_step,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           for (double& t : r.torque_Nm) t = 0.5 * std::round(t / 0.5);
         });
       },
       "0.5 N"},
      {"coarse_encoder", CheckName::encoder_step,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           for (double& q : r.q_rad) q = 2e-5 * std::round(q / 2e-5);
         });
       },
       "10 steps"},
      {"jittering_clock", CheckName::clock_jitter,
       // Rows are written when the network delivers them, at any time.
       [](joint::Dataset& d) {
         std::uint64_t stream = 0;
         each(d, [&](joint::Recording& r) {
           statistics::RandomStream random(1, ++stream);
           double t = 0;
           for (double& stamp : r.t_s) stamp = t += 1e-3 * std::abs(random.normal()) + 1e-9;
         });
       },
       "scatters"},
      {"interpolated_angle", CheckName::angle_interpolated,
       // One angle in ten came over the bus; between them lie straight lines.
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           constexpr std::size_t step = 10;
           for (std::size_t i = 0; i + step < r.size(); i += step) {
             const double slope = (r.q_rad[i + step] - r.q_rad[i]) / (r.t_s[i + step] - r.t_s[i]);
             for (std::size_t k = i + 1; k < i + step; ++k) {
               r.q_rad[k] = r.q_rad[i] + slope * (r.t_s[k] - r.t_s[i]);
             }
           }
         });
       },
       "once in 10 samples"},
      {"gaps", CheckName::clock_gaps,
       // A fifth of the time is missing, 50 ms at a time.
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           keep_samples(r, [](std::size_t i) { return i % 250 >= 50; });
         });
       },
       "gaps"},
      {"sweep_in_one_direction", CheckName::sweep_directions,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           if (r.role != joint::Role::oscillation) only_there(r);
         });
       },
       "only ever rises"},
      {"runs_in_one_direction", CheckName::run_directions,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           if (r.role == joint::Role::constant_speed) only_there(r);
         });
       },
       "only ever rises"},
      {"directions_without_common_angles", CheckName::run_common_angles,
       // The way back was driven somewhere else.
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           if (r.role != joint::Role::constant_speed) return;
           for (std::size_t i = r.size() / 2; i < r.size(); ++i) r.q_rad[i] -= 1.2;
         });
       },
       "share no angle"},
      {"one_speed_only", CheckName::run_speeds,
       [](joint::Dataset& d) { keep_role(d, joint::Role::constant_speed, 1); },
       "1 different speed"},
      {"oscillation_50_deg_off_the_peak", CheckName::oscillation_at_peak,
       [](joint::Dataset& d) {
         simulate::Scenario s = good_joint();
         s.oscillation->centre_rad += 50 * pi / 180;
         for (auto& o : s.further_oscillations) o.centre_rad += 50 * pi / 180;
         d = simulate::simulated_dataset(s);
       },
       "peak at"},
      {"oscillation_stays_elastic", CheckName::oscillation_slides,
       [](joint::Dataset& d) {
         simulate::Scenario s = good_joint();
         s.oscillation->amplitude_rad /= 25;
         for (auto& o : s.further_oscillations) o.amplitude_rad /= 25;
         s.noise.encoder_counts_per_turn *= 64;  // or the encoder would be the finding
         d = simulate::simulated_dataset(s);
       },
       "stiffness remains"},
      {"too_few_cycles", CheckName::oscillation_cycles,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           if (r.role != joint::Role::oscillation) return;
           keep_samples(r, [](std::size_t i) { return i <= 1500; });
         });
       },
       "1.5 cycles"},
      {"stick_slip", CheckName::stick_slip,
       // Half a second of rest, then the way of a second in the half that is left.
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           if (r.role != joint::Role::rough_sweep) return;
           const std::vector<double> q = r.q_rad;
           for (std::size_t i = 0; i < q.size(); ++i) {
             const std::size_t second = i / 1000 * 1000;
             const std::size_t source = second + (i % 1000 < 500 ? 0 : 2 * (i % 1000 - 500));
             r.q_rad[i] = q[std::min(source, q.size() - 1)];
           }
         });
       },
       "jumps ahead"},
      {"friction_falls_while_warming_up", CheckName::friction_drift,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) {
           if (r.role != joint::Role::rough_sweep) return;
           repeat(r, 5, [](joint::Recording& warming) {
             for (std::size_t i = 0; i < warming.size(); ++i) {
               const double warm = warming.t_s[i] / warming.t_s.back();
               warming.torque_Nm[i] -= 0.4 * warm * friction_of(warming, i);
             }
           });
         });
       },
       "pairs of strokes"},
      {"temperature_rises", CheckName::temperature,
       [](joint::Dataset& d) {
         double temperature_C = 24;
         each(d,
              [&](joint::Recording& r) { r.temperature_C.assign(r.size(), temperature_C += 0.6); });
       },
       "°C"},
      {"ripple_at_one_position", CheckName::torque_ripple,
       [](joint::Dataset& d) {
         simulate::Scenario s = test::noisy_paper_joint(1);
         s.noise.ripple = {{0.02, 1, 0.6}, {0.02, 6, -1.2}};
         d = simulate::simulated_dataset(s);
       },
       "6.00 periods"},
      {"torque_is_noise", CheckName::torque_noise,
       [](joint::Dataset& d) {
         statistics::RandomStream random(7, 1);
         each(d, [&](joint::Recording& r) {
           for (double& t : r.torque_Nm) t = random.normal();
         });
       },
       "white noise"},
      {"speed_and_torque_exchanged", CheckName::speed_scale,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) { std::swap(r.dq_rad_s, r.torque_Nm); });
       },
       ""},
      {"angle_and_torque_exchanged", CheckName::speed_scale,
       [](joint::Dataset& d) {
         each(d, [](joint::Recording& r) { std::swap(r.q_rad, r.torque_Nm); });
       },
       ""},
  };
  return all;
}

INSTANTIATE_TEST_SUITE_P(AllBreaches, BrokenDataset,
                         testing::ValuesIn(test::some_of(breaches(), 4)),
                         [](const auto& tested) { return tested.param.name; });

TEST(BrokenDatasets, AreTwentyAndMore) { EXPECT_GE(breaches().size(), 20U); }

TEST(BrokenDatasets, TheUnbrokenOneFailsNoCheckAndIsUsable) {
  const joint::Dataset d = good_dataset();
  const calibration::Calibration c = identified(d);
  EXPECT_EQ(c.judgement.verdict, calibration::Verdict::usable)
      << wording::words(c.judgement.sentence);
  for (const method::checks::DataCheck& check : c.data_checks.checks) {
    EXPECT_TRUE(check.state == method::checks::CheckState::passed ||
                check.state == method::checks::CheckState::not_applicable)
        << to_string(check.name) << ": " << wording::words(check.found);
  }
}

TEST(BrokenDatasets, NothingOfATargetTorqueIsUsable) {
  joint::Dataset d = good_dataset();
  d.manifest.drive = joint::Drive(100, joint::EffortKind::target_torque, joint::Side::motor);
  for (const calibration::QuantityVerdict& q : identified(d).judgement.quantities) {
    EXPECT_NE(q.verdict, calibration::Verdict::usable) << to_string(q.quantity);
  }
}

TEST(BrokenDatasets, AnEffortThatIsOnlyProposedMakesEveryTorqueDoubtfulAndIsToldFirst) {
  joint::Dataset d = good_dataset();
  d.manifest.effort_is_confirmed = false;
  const calibration::Calibration c = identified(d);
  EXPECT_EQ(c.data_checks.find(CheckName::effort_provenance)->state,
            method::checks::CheckState::fails);
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    const bool is_angle = q.quantity == joint::Quantity::cog_angle;
    EXPECT_EQ(q.verdict == calibration::Verdict::usable, is_angle) << to_string(q.quantity);
  }
  ASSERT_FALSE(c.judgement.findings.empty());
  EXPECT_NE(wording::words(c.judgement.findings.front()).find("not confirmed"), std::string::npos)
      << wording::words(c.judgement.findings.front());
}

/// A log whose unit of one column is proposed only.
joint::Dataset with_proposed_unit(joint::Dataset d, joint::LoggedSignal signal, const char* unit) {
  joint::ColumnConversion conversion;
  conversion.signal = signal;
  conversion.column = "a";
  conversion.unit = unit;
  conversion.is_proposed = true;
  joint::InputFile input;
  input.name = d.recordings.front().name;
  input.conversions = {conversion};
  d.inputs.push_back(input);
  return d;
}

/// What is usable of the first is doubtful in the second where it is among `touched`, and usable
/// else.
void expect_doubtful(const std::vector<joint::Quantity>& touched, const calibration::Calibration& c,
                     const calibration::Calibration& proposed) {
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    if (q.verdict != calibration::Verdict::usable) continue;
    const bool is_touched = std::find(touched.begin(), touched.end(), q.quantity) != touched.end();
    EXPECT_EQ(proposed.judgement.find(q.quantity)->verdict,
              is_touched ? calibration::Verdict::doubtful : calibration::Verdict::usable)
        << to_string(q.quantity);
  }
}

const std::vector<joint::Quantity> per_speed{
    joint::Quantity::stribeck_speed, joint::Quantity::viscous_coefficient,
    joint::Quantity::viscous_curve, joint::Quantity::bristle_damping, joint::Quantity::inertia};

TEST(BrokenDatasets, AClockThatIsOnlyProposedMakesWhatIsPerSpeedDoubtful) {
  const joint::Dataset d = good_dataset();
  const calibration::Calibration c =
      identified(with_proposed_unit(d, joint::LoggedSignal::time, "ms"));
  EXPECT_TRUE(c.data_checks.fails(CheckName::speed_provenance));
  EXPECT_FALSE(c.data_checks.fails(CheckName::angle_provenance));
  expect_doubtful(per_speed, identified(d), c);
}

TEST(BrokenDatasets, AnAngleThatIsOnlyProposedMakesAllDoubtfulWhereGravityIsLookedFor) {
  const joint::Dataset d = good_dataset();
  const calibration::Calibration c =
      identified(with_proposed_unit(d, joint::LoggedSignal::angle, "rad"));
  EXPECT_TRUE(c.data_checks.fails(CheckName::angle_provenance));
  EXPECT_FALSE(c.data_checks.fails(CheckName::speed_provenance));
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    EXPECT_NE(q.verdict, calibration::Verdict::usable) << to_string(q.quantity);
  }
}

TEST(BrokenDatasets, AnAngleThatIsOnlyProposedLeavesTorquesWhereThereIsNoGravity) {
  simulate::Scenario s = good_joint();
  s.load = joint::GravityLoad(1e-9, 0.5, 0);
  joint::Dataset d = simulate::simulated_dataset(s);
  d.manifest.known_gravity = joint::StatedGravity(0, 0);
  const calibration::Calibration stated = identified(d);
  ASSERT_EQ(stated.judgement.find(joint::Quantity::break_away_torque)->verdict,
            calibration::Verdict::usable);
  std::vector<joint::Quantity> touched = per_speed;
  touched.push_back(joint::Quantity::bristle_stiffness);
  expect_doubtful(touched, stated,
                  identified(with_proposed_unit(d, joint::LoggedSignal::angle, "rad")));
}

TEST(BrokenDatasets, GravityThatTheControllerTookOffIsNotLookedForAndThatIsSaid) {
  simulate::Scenario s = good_joint();
  s.load = joint::GravityLoad(1e-9, 0.5, 0);
  joint::Dataset d = simulate::simulated_dataset(s);
  d.manifest.known_gravity = joint::StatedGravity(0, 0);
  d.manifest.gravity_is_removed = true;
  const calibration::Calibration c = identified(d);
  for (const joint::Quantity quantity :
       {joint::Quantity::cog_angle, joint::Quantity::gravity_torque,
        joint::Quantity::surrogate_mass}) {
    const calibration::QuantityVerdict& q = *c.judgement.find(quantity);
    EXPECT_FALSE(q.estimate) << to_string(quantity);
    EXPECT_FALSE(q.decides) << to_string(quantity);
    ASSERT_FALSE(q.reasons.empty());
    EXPECT_TRUE(q.reasons.front().is("cause.gravity_removed")) << as_code(q.reasons.front());
  }
  EXPECT_EQ(c.judgement.find(joint::Quantity::break_away_torque)->verdict,
            calibration::Verdict::usable);
}

TEST(BrokenDatasets, ATorqueBehindTheGearIsToldAndTheMassStands) {
  // What a sensor at the joint feels: the load, and a hundredth of the drive's friction.
  joint::Dataset d = good_dataset();
  d.manifest.drive = joint::Drive(100, joint::EffortKind::joint_torque, joint::Side::joint);
  each(d, [](joint::Recording& r) {
    for (std::size_t i = 0; i < r.size(); ++i) r.torque_Nm[i] -= 0.99 * friction_of(r, i);
  });
  const calibration::Calibration c = identified(d);
  const method::checks::DataCheck* check = c.data_checks.find(CheckName::link_side_torque);
  EXPECT_EQ(check->state, method::checks::CheckState::warns) << wording::words(check->found);
  EXPECT_NE(wording::words(check->found).find("little gear friction"), std::string::npos)
      << wording::words(check->found);
  EXPECT_NEAR(c.rough.gravity_Nm.value / test::true_gravity_Nm, 1, 0.01);
}

TEST(BrokenDatasets, RippleAtEightPositionsIsToldButFailsNothing) {
  simulate::Scenario s = good_joint();
  s.noise.ripple = {{0.02, 1, 0.6}, {0.02, 6, -1.2}};
  const joint::Dataset d = simulate::simulated_dataset(s);
  const calibration::Calibration c = identified(d);
  const method::checks::DataCheck* check = c.data_checks.find(CheckName::torque_ripple);
  EXPECT_EQ(check->state, method::checks::CheckState::passed) << wording::words(check->found);
  EXPECT_NE(wording::words(check->found).find("6.00 periods"), std::string::npos)
      << wording::words(check->found);
  EXPECT_EQ(c.data_checks.find(CheckName::ripple_period)->state,
            method::checks::CheckState::passed);
}

// Torque stated on the motor's side and angle on the joint's: the gear ratio then scales masses and
// joint torques, and nothing in such logs contradicts it. All that can show it is the motor's
// ripple, whose periods a turn are whole numbers, or a speed logged on the motor's side (above).
TEST(BrokenDatasets, AWrongGearRatioShowsInTheRipplesPeriodOnly) {
  simulate::Scenario s = test::noisy_paper_joint(1);
  s.noise.ripple = {{0.02, 1, 0.6}, {0.02, 6, -1.2}};
  joint::Dataset rippled = simulate::simulated_dataset(s);
  rippled.manifest.drive = joint::Drive(80, joint::EffortKind::motor_torque, joint::Side::motor);
  const method::checks::DataChecksResult seen = identified(rippled).data_checks;
  const method::checks::DataCheck* period = seen.find(CheckName::ripple_period);
  EXPECT_EQ(period->state, method::checks::CheckState::warns);
  // 6 periods in 1/100 of a joint's turn are 7.5 in 1/80.
  EXPECT_NE(wording::words(period->found).find("7.50 periods"), std::string::npos)
      << wording::words(period->found);

  joint::Dataset smooth = good_dataset();
  const calibration::Calibration right = identified(smooth);
  smooth.manifest.drive = joint::Drive(80, joint::EffortKind::motor_torque, joint::Side::motor);
  const calibration::Calibration wrong = identified(smooth);
  EXPECT_EQ(wrong.data_checks.find(CheckName::ripple_period)->state,
            method::checks::CheckState::not_applicable);
  EXPECT_NE(wording::words(wrong.data_checks.find(CheckName::ripple_period)->found)
                .find("nothing in these logs checks"),
            std::string::npos);
  const double mass = right.masses.find(Estimator::midline)->mass_kg.value;
  EXPECT_NEAR(wrong.masses.find(Estimator::midline)->mass_kg.value / mass, 0.8, 1e-6);
}

}  // namespace
}  // namespace tribolog::broken_datasets_test
