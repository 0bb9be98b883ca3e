// The manifest and its names: 46 to 48.

#include "cli/input_cases/case_log.h"
#include "cli/input_cases/input_case.h"
#include "cli/small_dataset.h"

namespace tribolog::test {
namespace {

InputCase manifest(const std::string& id, const std::string& name, const std::string& text,
                   const std::string& says) {
  return with_manifest(refused(id, name, case_log(), "dataset.toml" + says), text);
}

InputCase named(const std::string& id, const std::string& name, const std::string& robot) {
  return with_manifest(accepted(id, name, case_log()), case_manifest("test robot", robot));
}

std::string gear_ratio(const std::string& value) {
  return case_manifest("gear_ratio = 100", "gear_ratio = " + value);
}

std::string in_front_of_effort(const std::string& lines) {
  return case_manifest("[effort]", lines + "\n[effort]");
}

}  // namespace

std::vector<InputCase> manifest_cases() {
  const std::string gear = ":6:14: key 'joint.gear_ratio': not usable, found ";
  const std::string name_it =
      ", expected a dataset manifest (TOML); hint: a log is named in one: [[recording]] file = "
      "\"log.csv\"; tribolog report --help shows it";
  return {
      named("46a", "RobotNamedAsAPath", "../../etc/x"),
      named("46b", "RobotNamedAsADevice", "CON"),
      named("46c", "RobotWithASlash", "a/b"),
      named("46d", "RobotOf5000Characters", std::string(5000, 'x')),
      manifest(
          "46e", "RobotWithoutAName", case_manifest("test robot", " "),
          ":3:8: key 'robot.name': is empty, expected a name; hint: the report and the archive "
          "go by the robot's name"),
      named("47a", "RobotNamedAsAStatement", "'; DROP TABLE cal;--"),
      named("47b", "RobotWithANul", "a\\u0000b"),
      manifest("48a", "UnknownKey", case_manifest("side =", "colour = \"red\"\nside ="),
               ":9:10: unknown key 'effort.colour'; hint: known here: 'confirmed', "
               "'gravity_removed', 'kind', 'side', 'sign', 'torque_constant_Nm_A'"),
      manifest("48b", "MisspeltKey", case_manifest("gear_ratio", "gear_ration"),
               ":4:1: key 'joint.gear_ratio' is missing; hint: is 'gear_ration' meant to be it?"),
      manifest("48c", "WrongType", gear_ratio("\"100\""),
               gear + "the text '100', expected a number > 0"),
      manifest("48d", "KeyTwice", gear_ratio("100\ngear_ratio = 50"), ":7:14: not valid TOML: ..."),
      manifest("48e", "NotANumber", gear_ratio("nan"), gear + "nan, expected a number > 0"),
      manifest("48f", "NegativeNumber", gear_ratio("-100"), gear + "-100, expected a number > 0"),
      manifest("48g", "ZeroGearRatio", gear_ratio("0"), gear + "0, expected a number > 0"),
      manifest("48h", "LimitThatIsNoNumber",
               in_front_of_effort("[[limit]]\nquantity = \"coulomb_joint_Nm\"\nmax = nan"),
               ":9:7: key 'limit.max': not usable, found nan, expected a finite number"),
      manifest(
          "48i", "MinAboveMax",
          in_front_of_effort("[[limit]]\nquantity = \"coulomb_joint_Nm\"\nmin = 2\nmax = 1"),
          ":9:7: key 'limit.min': nothing is allowed between min and max, found 2..1, expected "
          "min <= max"),
      manifest(
          "48j", "Include", in_front_of_effort("[include]\nfile = \"dataset.toml\""),
          ":7:1: unknown key 'include'; hint: known here: 'certificate', 'columns', 'effects', "
          "'effort', 'intervals', 'joint', 'known_gravity', 'known_load', 'limit', 'log', "
          "'other_joint', "
          "'payload', 'recording', "
          "'reference', 'robot', 'schema', 'surrogate', 'temperature', 'uncertainty'"),
      manifest("48k", "DeepNesting", in_front_of_effort("x = " + std::string(10'000, '[')),
               ":7:37: brackets nested too deeply"),
      manifest("48l", "DeepKey", in_front_of_effort([] {
                 std::string key = "a";
                 for (int i = 0; i < 10'000; ++i) key += ".a";
                 return key + " = 1";
               }()),
               ":7:102: key with too many dots"),
      manifest("48m", "NoEffortKind", case_manifest("kind = \"motor_torque\"\n", ""),
               ":7:1: key 'effort.kind' is missing; hint: state kind = \"motor_current\", "
               "\"motor_torque\" or \"joint_torque\": the same column is ampere on one robot and "
               "newton metre on another, so it is never guessed; \"target_torque\" where "
               "it is a controller's value, \"none\" where nothing was recorded"),
      manifest("48n", "UnitOfAnotherQuantity", case_manifest("\"Nm\"", "\"A\""),
               ":13:33: key 'columns.effort.unit': contradicts effort.kind, found 'A', a current, "
               "expected a torque (Nm, mNm, kNm); hint: is the kind of the effort stated rightly?"),
      manifest(
          "48o", "UnknownUnit", case_manifest("\"rad\"", "\"radd\""),
          ":12:30: unknown unit of an angle, found 'radd', expected one of rad, mrad, deg, turn; "
          "hint: did you mean 'rad'?"),
      manifest("48p", "UnknownRole", case_manifest("rough_sweep", "ruff_sweep"),
               ":15:8: key 'recording.role': not known, found 'ruff_sweep', expected one of "
               "'rough_sweep', 'precise_sweep', 'oscillation', 'constant_speed', 'break_away', "
               "'friction_points'; "
               "hint: did you mean 'rough_sweep'?"),
      manifest(
          "48q", "EmptyWindow", small_manifest() + "from_s = 5\nto_s = 5\n",
          ":18:8: key 'recording.to_s': window is empty, found 5..5 s, expected from_s < to_s"),
      manifest("48r", "UnknownKeyOfTheLog", in_front_of_effort("[log]\nskip_bad_row = true"),
               ":8:16: unknown key 'log.skip_bad_row'; hint: did you mean 'skip_bad_rows'?"),
      manifest(
          "48s", "CommasForBoth",
          in_front_of_effort("[log]\ndelimiter = \"comma\"\ndecimal_comma = true"),
          ":8:13: key 'log.delimiter': contradicts decimal_comma, found commas for both; hint: "
          "commas within numbers and between columns cannot be told apart"),
      manifest("48t", "NotUtf8", case_manifest("test robot", "\xfc"),
               ":3:9: text is not UTF-8, found byte 0xFC; hint: save the file as UTF-8"),
      manifest("48u", "Empty", "",
               ":1:1: key 'schema' is missing; hint: one of 'tribolog-dataset-1'"),
      manifest("48v", "LogInsteadOfAManifest", case_log(),
               ":1: is no manifest, found 't,q,tau'" + name_it),
      manifest("48w", "BagInsteadOfAManifest", "\x89MCAP0\r\n", ": is a binary log" + name_it),
      manifest("48x", "OtherSchema", case_manifest("tribolog-dataset-1", "tribolog-dataset-2"),
               ":1:10: key 'schema': not known, found 'tribolog-dataset-2', expected one of "
               "'tribolog-dataset-1'; hint: did you mean 'tribolog-dataset-1'?"),
  };
}

}  // namespace tribolog::test
