// URDF, SDF, MJCF and MAT files as urdfdom, sdformat, MuJoCo and matio understand them.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <matio.h>

#include "base/temporary_directory.h"
#include "exports/export_sample.h"
#include "exports/results/calibration_exports.h"

#ifdef TRIBOLOG_URDFDOM
#include <urdf_parser/urdf_parser.h>
#endif
#ifdef TRIBOLOG_MUJOCO
#include <mujoco/mujoco.h>
#endif
#ifdef TRIBOLOG_SDFORMAT
#include <sdf/sdf.hh>
#endif

namespace tribolog::archive::export_parsers_test {
namespace {

using test::export_sample;
using test::hostile_export_sample;

TEST(ExportParsers, UrdfdomReadsTheDynamics) {
#ifdef TRIBOLOG_URDFDOM
  for (const exports::results::ArchivedJoint& sample :
       {test::export_sample(), test::hostile_export_sample()}) {
    const auto model = urdf::parseURDF(exports::results::urdf_joint(sample, {}));
    ASSERT_TRUE(model);
    ASSERT_EQ(model->joints_.size(), 1U);
    EXPECT_EQ(model->links_.size(), 2U);
    const auto& joint = model->joints_.begin()->second;
    ASSERT_TRUE(joint->dynamics);
    EXPECT_NEAR(joint->dynamics->damping, 0.002 * 50 * 50, 1e-12);
    EXPECT_NEAR(joint->dynamics->friction, 0.31 * 50, 1e-12);
  }
  const auto model = urdf::parseURDF(exports::results::urdf_joint(test::export_sample(), {}));
  EXPECT_EQ(model->getName(), "R1");
  EXPECT_EQ(model->joints_.begin()->first, "J2");
  exports::results::ArchivedJoint sample = test::export_sample();
  sample.entry.facts.of.joint = "<J & \"2'>";
  EXPECT_EQ(urdf::parseURDF(exports::results::urdf_joint(sample, {}))->joints_.begin()->first,
            "<J & \"2'>");
#else
  GTEST_SKIP() << "liburdfdom-dev is not installed";
#endif
}

TEST(ExportParsers, SdformatReadsTheDynamics) {
#ifdef TRIBOLOG_SDFORMAT
  for (const exports::results::ArchivedJoint& sample :
       {test::export_sample(), test::hostile_export_sample()}) {
    sdf::Root root;
    const sdf::Errors errors = root.LoadSdfString(exports::results::sdf_joint(sample, {}));
    EXPECT_TRUE(errors.empty()) << errors.front().Message();
    ASSERT_NE(root.Model(), nullptr);
    ASSERT_EQ(root.Model()->JointCount(), 1U);
    const sdf::JointAxis* axis = root.Model()->JointByIndex(0)->Axis(0);
    ASSERT_NE(axis, nullptr);
    EXPECT_NEAR(axis->Damping(), 0.002 * 50 * 50, 1e-12);
    EXPECT_NEAR(axis->Friction(), 0.31 * 50, 1e-12);
  }
#else
  GTEST_SKIP() << "libsdformat-dev is not installed";
#endif
}

/// Variables of a MAT file as matio reads them.
class MatFile {
 public:
  explicit MatFile(const exports::results::ArchivedJoint& joint) {
    const std::string path = directory_.file("joint.mat", exports::results::matlab_file(joint));
    file_.reset(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  }
  [[nodiscard]] bool is_open() const { return file_ != nullptr; }
  [[nodiscard]] std::vector<double> numbers(const char* name) const {
    const auto variable = read(name);
    if (!variable || variable->class_type != MAT_C_DOUBLE) return {};
    const auto* first = static_cast<const double*>(variable->data);
    return {first, first + variable->dims[0] * variable->dims[1]};
  }
  [[nodiscard]] std::string text(const char* name) const {
    const auto variable = read(name);
    if (!variable || variable->class_type != MAT_C_CHAR) return "?";
    return {static_cast<const char*>(variable->data), variable->dims[1]};
  }

 private:
  [[nodiscard]] std::unique_ptr<matvar_t, decltype(&Mat_VarFree)> read(const char* name) const {
    return {Mat_VarRead(file_.get(), name), Mat_VarFree};
  }
  test::TemporaryDirectory directory_;
  std::unique_ptr<mat_t, decltype(&Mat_Close)> file_{nullptr, Mat_Close};
};

TEST(ExportParsers, MatioReadsTheNumbers) {
  exports::results::ArchivedJoint sample = test::export_sample();
  test::quantity_of(sample, "inertia").estimate.reset();
  const MatFile file(sample);
  ASSERT_TRUE(file.is_open());
  const std::vector<double> coulomb = file.numbers("coulomb_torque_joint");
  ASSERT_EQ(coulomb.size(), 3U);
  EXPECT_DOUBLE_EQ(coulomb[0], 0.31 * 50);
  EXPECT_DOUBLE_EQ(coulomb[1], 0.30 * 50);
  EXPECT_DOUBLE_EQ(coulomb[2], 0.32 * 50);
  EXPECT_EQ(file.text("coulomb_torque_motor_unit"), "N\xb7m");
  EXPECT_EQ(file.text("coulomb_torque_motor_verdict"), "usable");
  for (const double number : file.numbers("inertia_motor")) EXPECT_TRUE(std::isnan(number));
  const std::vector<double> curve = file.numbers("friction_curve_motor");
  ASSERT_FALSE(curve.empty());
  ASSERT_EQ(curve.size() % 2, 0U);
  EXPECT_EQ(curve.front(), 0) << "speeds first, as MATLAB keeps columns";
  EXPECT_TRUE(std::is_sorted(curve.begin(), curve.begin() + static_cast<long>(curve.size() / 2)));
  EXPECT_EQ(file.text("joint"), "J2");
  EXPECT_EQ(file.numbers("gear_ratio"), std::vector<double>{50});
}

TEST(ExportParsers, MatioReadsWhateverTheNamesAre) {
  const MatFile file(test::hostile_export_sample());
  ASSERT_TRUE(file.is_open());
  EXPECT_EQ(file.numbers("coulomb_torque_joint").size(), 3U);
  EXPECT_NE(file.text("joint").find("\xe9 ??"), std::string::npos) << file.text("joint");
}

#ifdef TRIBOLOG_MUJOCO
/// MuJoCo's dry friction is a soft constraint: it creeps. Without friction it would be 3 rad/s.
constexpr double creep_rad_s = 0.03;

struct MujocoModel {
  explicit MujocoModel(const std::string& xml) {
    const test::TemporaryDirectory directory;
    char error[1000] = "";
    model = mj_loadXML(directory.file("a.xml", xml).c_str(), nullptr, error, sizeof error);
    if (model == nullptr) throw std::runtime_error(error);
    data = mj_makeData(model);
  }
  MujocoModel(const MujocoModel&) = delete;
  MujocoModel& operator=(const MujocoModel&) = delete;
  ~MujocoModel() {
    mj_deleteData(data);
    mj_deleteModel(model);
  }
  /// Speed after a while under a torque.
  [[nodiscard]] double speed_rad_s(double torque_Nm) const {
    mj_resetData(model, data);
    data->qfrc_applied[0] = torque_Nm;
    for (int k = 0; k < 2000; ++k) mj_step(model, data);
    return data->qvel[0];
  }
  mjModel* model{};
  mjData* data{};
};
#endif

TEST(ExportParsers, MujocoMovesAsTheJointWould) {
#ifdef TRIBOLOG_MUJOCO
  exports::results::SimulatorOptions options;
  options.arm_inertia_kgm2 = 4.5;
  for (const exports::results::ArchivedJoint& sample :
       {test::export_sample(), test::hostile_export_sample()}) {
    const MujocoModel loaded(exports::results::mjcf_joint(sample, options));
    const mjModel& model = *loaded.model;
    ASSERT_EQ(model.nv, 1);
    EXPECT_NEAR(model.dof_damping[0], 5, 1e-12);
    EXPECT_NEAR(model.dof_frictionloss[0], 15.5, 1e-12);
    EXPECT_NEAR(model.dof_armature[0], 0.5, 1e-12);
    // Coulomb torque holds it; beyond, the viscous one grows by 5 N·m for each rad/s.
    EXPECT_NEAR(loaded.speed_rad_s(15.0), 0, creep_rad_s);
    EXPECT_NEAR(loaded.speed_rad_s(15.5 + 5 * 2.0), 2.0, creep_rad_s);
  }
  const MujocoModel plain(exports::results::mjcf_joint(test::export_sample(), {}));
  EXPECT_EQ(plain.model->dof_armature[0], 0);
  EXPECT_STREQ(mj_id2name(plain.model, mjOBJ_JOINT, 0), "J2");
#else
  GTEST_SKIP() << "libmujoco-dev is not installed (Debian 12 has it, Ubuntu 22.04 has not)";
#endif
}

}  // namespace
}  // namespace tribolog::archive::export_parsers_test
