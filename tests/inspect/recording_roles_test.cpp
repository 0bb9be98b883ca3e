// Which segment plays which role.

#include <gtest/gtest.h>

#include "inspect/long_recording.h"
#include "inspect/survey/manifest_proposal.h"

namespace tribolog::recording_roles_test {
namespace {

/// A log of one joint with these segments, on top of each other in time.
inspect::survey::LogSurvey log_of(std::vector<inspect::motion::MotionSegment> segments) {
  inspect::survey::LogSurvey log;
  log.file = "log.csv";
  inspect::survey::TableSurvey table;
  table.clock = inspect::survey::ClockSurvey{};
  inspect::survey::JointSurvey joint;
  joint.segments = std::move(segments);
  table.joints.push_back(joint);
  log.tables.push_back(table);
  return log;
}

inspect::motion::MotionSegment run(double from_s, double speed_rad_s, double travel_rad,
                                   std::size_t strokes = 2) {
  inspect::motion::MotionSegment s;
  s.kind = inspect::motion::MotionKind::constant_speed;
  s.from_s = from_s;
  s.to_s = from_s + static_cast<double>(strokes) * travel_rad / speed_rad_s;
  s.highest_rad = travel_rad;
  s.speed_rad_s = speed_rad_s;
  s.strokes = strokes;
  s.is_steady = true;
  return s;
}

std::vector<joint::Role> roles_of(const std::vector<inspect::motion::MotionSegment>& segments) {
  const std::vector<inspect::survey::LogSurvey> logs{log_of(segments)};
  std::vector<joint::Role> roles;
  for (const auto& r : inspect::survey::propose_roles(logs, {{0, 0, 0}}).recordings)
    roles.push_back(r.role);
  return roles;
}

TEST(RecordingRoles, StrokesOfOneSlowSpeedAreASweep) {
  EXPECT_EQ(roles_of({run(0, 0.1, 1.5)}), std::vector{joint::Role::rough_sweep});
  EXPECT_EQ(roles_of({run(0, 2.0, 1.5)}), std::vector{joint::Role::constant_speed}) << "not slow";
}

TEST(RecordingRoles, StrokesOfSeveralSpeedsOverTheSameWayAreRuns) {
  const auto roles = roles_of({run(0, 0.1, 1.5), run(100, 0.2, 1.5), run(200, 0.4, 1.5)});
  EXPECT_EQ(roles, std::vector(3, joint::Role::constant_speed));
}

TEST(RecordingRoles, TheWidestSlowOneBesideRunsIsTheSweep) {
  const auto roles =
      roles_of({run(0, 0.05, 2.5), run(200, 0.2, 1.0), run(300, 0.4, 1.0), run(400, 1.0, 1.0)});
  EXPECT_EQ(roles[0], joint::Role::rough_sweep);
  EXPECT_EQ(roles[1], joint::Role::constant_speed);
}

TEST(RecordingRoles, TheFastestRunBesideASlowSweepIsNoSecondSweep) {
  std::vector<inspect::motion::MotionSegment> segments{run(0, 0.05, 2.5), run(200, 0.2, 1.0),
                                                       run(300, 0.4, 1.0), run(400, 0.6, 1.2)};
  inspect::motion::MotionSegment fast = run(500, 1.5, 1.2, 3);
  fast.kind = inspect::motion::MotionKind::slow_sweep;  // it speeds up and slows down all along
  fast.is_steady = false;
  segments.push_back(fast);
  EXPECT_EQ(roles_of(segments).back(), joint::Role::constant_speed);
  inspect::motion::MotionSegment slow = fast;
  slow.speed_rad_s = 0.1;
  segments.back() = slow;
  EXPECT_EQ(roles_of(segments).back(), joint::Role::rough_sweep);
}

TEST(RecordingRoles, TheSlowestByFarNarrowOneIsThePreciseSweep) {
  const auto roles = roles_of({run(0, 0.035, 2.4), run(200, 0.002, 0.035), run(300, 0.01, 0.05),
                               run(400, 0.02, 0.1), run(500, 1.0, 1.0)});
  EXPECT_EQ(roles, (std::vector{joint::Role::rough_sweep, joint::Role::precise_sweep,
                                joint::Role::constant_speed, joint::Role::constant_speed,
                                joint::Role::constant_speed}));
}

TEST(RecordingRoles, WindowsAreStatedWhereTheSegmentIsNotTheLog) {
  inspect::motion::MotionSegment rest;
  rest.to_s = 10;
  const std::vector<inspect::survey::LogSurvey> logs{log_of({rest, run(10, 0.1, 1.0, 1)})};
  const auto proposal = inspect::survey::propose_roles(logs, {{0, 0, 0}});
  ASSERT_EQ(proposal.recordings.size(), 1U);
  EXPECT_DOUBLE_EQ(proposal.recordings[0].from_s.value_or(0), 10);
  EXPECT_FALSE(proposal.recordings[0].to_s);
}

TEST(RecordingRoles, WithoutAnyMotionTheLogIsNamedAsAStopgap) {
  const std::vector<inspect::survey::LogSurvey> logs{log_of({inspect::motion::MotionSegment{}})};
  const auto proposal = inspect::survey::propose_roles(logs, {{0, 0, 0}});
  EXPECT_TRUE(proposal.is_makeshift);
  EXPECT_EQ(proposal.recordings.size(), 1U);
}

TEST(RecordingRoles, WithoutGravityStrokesThereAndBackOfAnyCourseAreASweep) {
  const auto stroke = [](double from_s, double lowest_rad, double highest_rad, int direction) {
    inspect::motion::MotionSegment s;
    s.kind = inspect::motion::MotionKind::varying;
    s.from_s = from_s;
    s.to_s = from_s + 1.5;
    s.lowest_rad = lowest_rad;
    s.highest_rad = highest_rad;
    s.strokes = 1;
    s.direction = direction;
    return s;
  };
  const auto sweeps = [](const std::vector<inspect::motion::MotionSegment>& segments,
                         bool has_no_gravity) {
    const std::vector<inspect::survey::LogSurvey> logs{log_of(segments)};
    const auto proposal = inspect::survey::propose_roles(logs, {{0, 0, 0}}, has_no_gravity);
    return proposal.is_makeshift ? 0 : proposal.recordings.size();
  };
  const std::vector there_and_back{stroke(2, 0, 28, 1), stroke(4, 14, 28, -1)};
  EXPECT_EQ(sweeps(there_and_back, true), 1U);
  EXPECT_EQ(sweeps(there_and_back, false), 0U) << "gravity may be anything in them";
  EXPECT_EQ(sweeps({stroke(2, 0, 28, 1), stroke(4, 28, 40, 1)}, true), 0U) << "one direction";
  EXPECT_EQ(sweeps({stroke(2, 0, 28, 1), stroke(4, 28, 40, -1)}, true), 0U) << "no common angle";
}

/// The simulated joint's own roles come back from one recording of everything.
TEST(RecordingRoles, OfASimulatedProtocolAreThoseSimulated) {
  const test::LongRecording recording = test::long_recording(test::everything(21), 2, 2);
  const std::vector<inspect::survey::LogSurvey> logs{
      log_of(inspect::motion::cut_by_motion(recording.trace))};
  const auto proposed = inspect::survey::propose_roles(logs, {{0, 0, 0}}).recordings;
  ASSERT_EQ(proposed.size(), recording.truth.size());
  for (std::size_t k = 0; k < proposed.size(); ++k) {
    EXPECT_EQ(joint::to_string(proposed[k].role), joint::to_string(recording.truth[k].role))
        << recording.truth[k].name;
  }
}

}  // namespace
}  // namespace tribolog::recording_roles_test
