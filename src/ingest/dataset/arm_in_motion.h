#pragma once
// What the robot's other joints do to the one that is read: their motion in its logs, and the
// gravity that this changes, by the masses of a description of the arm.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/dataset/log_reader.h"
#include "joint/dataset.h"
#include "robot/weighted_arm.h"

namespace tribolog::ingest::dataset {

/// Gravity torque of a turning joint less the same with the other joints at `held`, at the joint
/// [N·m]: what their motion changes of it. 0 where they stand there.
/// @param positions of all joints [rad, m]; held[joint] is not used.
double gravity_of_others_Nm(const robot::WeightedArm& arm, std::size_t joint,
                            const std::vector<double>& positions, std::vector<double> held,
                            const Eigen::Vector3d& gravity_m_s2);

/// The angles of the other joints, as the logs of one joint are read one after the other.
class ArmInMotion {
 public:
  /// Without a description.
  explicit ArmInMotion(const joint::Manifest& manifest);

  /// Takes the masses of a description. Joints are matched by their names; where none of the
  /// manifest's names is one of the description's, by their order, if they are as many. Joints of
  /// the description that the manifest does not name are looked for in the logs as
  /// "<name>.position" [rad].
  /// @param path of the description, for messages. @param joints of the robot's manifest, in its
  ///        order; empty: it is a single joint's.
  /// @throw InputError as parse_urdf(), where the joints cannot be matched, and where the tested
  /// one
  ///        slides.
  void describe(std::string_view urdf, const std::string& path,
                const std::vector<std::string>& joints);

  /// Columns to look for in the logs.
  [[nodiscard]] std::vector<std::string> columns() const;

  /// Keeps the angles of one recording. @param rows of the log, one for each of its samples.
  void keep(const ReadLog& log, const std::vector<std::size_t>& rows);

  /// Once all are kept: counts the motions, gives the recordings the angles of joints that move, or
  /// with a description subtracts what they change of gravity from the torques, as
  /// Recording::others_gravity_Nm says. Held are the others at their means over the first rough
  /// sweep; without one over the first recording that has them.
  /// @param dataset with the recordings in the order in which they were kept.
  void take_gravity_off(joint::Dataset& dataset) const;

 private:
  struct Other {
    joint::OtherJoint joint;
    std::optional<std::size_t> in_arm{};
    bool is_looked_for{};  ///< The manifest does not name it.
    /// Of each recording, one for each sample [rad]; empty: not logged.
    std::vector<std::vector<double>> angles_rad{};
  };
  /// Those that the log's own names tell, where no description names the joints.
  void add_found(const ReadLog& log);
  [[nodiscard]] std::size_t first_with_angles(const joint::Dataset& dataset) const;
  [[nodiscard]] std::vector<double> held(const joint::Dataset& dataset) const;
  void count_motions(joint::Dataset& dataset) const;
  void note_assumptions(joint::Dataset& dataset) const;

  std::string tested_name_;
  std::vector<Other> others_;
  std::optional<robot::WeightedArm> arm_;
  std::size_t tested_{};  ///< In the arm.
  bool is_by_order_{};
  std::size_t recordings_{};  ///< Kept so far.
};

}  // namespace tribolog::ingest::dataset
