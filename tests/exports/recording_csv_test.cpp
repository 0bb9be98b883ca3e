#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "exports/simulation/simulation_files.h"
#include "ingest/text/csv_reader.h"

#if __has_include(<rapidcheck/gtest.h>)
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#endif

namespace tribolog::recording_csv_test {
namespace {

joint::Recording two_samples() {
  joint::Recording r;
  r.t_s = {0, 0.001};
  r.q_rad = {-0.1, 1e-17};
  r.torque_Nm = {3.88318571, -2};
  return r;
}

TEST(RecordingCsv, LeavesOutSignalsThatAreNotThere) {
  EXPECT_EQ(exports::simulation::recording_csv(two_samples()),
            "t_s,q_rad,torque_Nm\n0,-0.1,3.88318571\n0.001,1e-17,-2\n");
}

TEST(RecordingCsv, WritesEverySignalInTheDocumentedOrder) {
  joint::Recording r = two_samples();
  r.dq_rad_s = {1, 2};
  r.z_rad = {3, 4};
  r.dz_rad_s = {5, 6};
  EXPECT_EQ(exports::simulation::recording_csv(r),
            "t_s,q_rad,dq_rad_s,torque_Nm,z_rad,dz_rad_s\n"
            "0,-0.1,1,3.88318571,3,5\n0.001,1e-17,2,-2,4,6\n");
}

TEST(RecordingCsv, IsAsAControllerWritesIt) {
  simulate::LogForm form;
  form.torque_constant_Nm_A = 0.5;
  form.decimals = 3;
  EXPECT_EQ(exports::simulation::recording_csv(two_samples(), form),
            "t_s,q_rad,i_A\n0.000,-0.100,7.766\n0.001,0.000,-4.000\n");
}

TEST(RecordingCsv, RefusesSignalsOfOtherLength) {
  joint::Recording r = two_samples();
  r.z_rad = {1};
  EXPECT_THROW(exports::simulation::recording_csv(r), std::invalid_argument);
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool comes_back(const std::vector<double>& values) {
  joint::Recording r;
  r.t_s = r.q_rad = r.torque_Nm = values;
  const ingest::log::LogTable table =
      ingest::text::read_csv(exports::simulation::recording_csv(r), "f", {{"torque_Nm"}});
  return std::equal(values.begin(), values.end(), table.columns.at(0).values.begin(),
                    table.columns.at(0).values.end(), same_bits);
}

TEST(RecordingCsv, ComesBackBitForBitAtTheLimits) {
  using Limits = std::numeric_limits<double>;
  EXPECT_TRUE(comes_back({0.0, -0.0, Limits::max(), Limits::lowest(), Limits::min(),
                          Limits::denorm_min(), Limits::epsilon(), 0.1, 1.0 / 3.0, 1e22, 1e23}));
}

#if __has_include(<rapidcheck/gtest.h>)
RC_GTEST_PROP(RecordingCsvProperty, ComesBackBitForBit, (std::vector<double> values)) {
  RC_PRE(!values.empty());
  for (const double value : values) RC_PRE(std::isfinite(value));
  RC_ASSERT(comes_back(values));
}
#endif

}  // namespace
}  // namespace tribolog::recording_csv_test
