#include "exports/simulation/simulation_files.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/shown_text.h"
#include "ingest/manifest/toml_document.h"

namespace tribolog::exports::simulation {

namespace {

std::string toml_value(double value) { return ingest::manifest::toml_number(value); }

std::string toml_value(std::uint64_t value) { return fmt::format("{}", value); }

std::string toml_value(const std::vector<friction::MaxwellElement>& elements) {
  std::string text = "[";
  for (const friction::MaxwellElement& one : elements) {
    text += fmt::format("\n  {{stiffness_Nm_rad = {}, share = {}}},",
                        ingest::manifest::toml_number(one.stiffness_Nm_rad),
                        ingest::manifest::toml_number(one.share));
  }
  return text += "\n]";
}

std::string reference(const friction::StaticFriction* friction) {
  if (friction == nullptr) {
    return "\n# No known curve: the simulated friction depends on the rest before the motion "
           "too.\n";
  }
  std::string text = "\n# The friction that was simulated: sweeps and runs at constant speed.\n";
  text += fmt::format("[reference.{}]\n", friction->name());
  for (const friction::NamedParameter& one : friction->named_parameters()) {
    const auto value = [](const auto& known) { return toml_value(known); };
    text += fmt::format("{} = {}\n", one.key, std::visit(value, one.value));
  }
  return text;
}

bool is_current(const simulate::Scenario& scenario) {
  return scenario.log.torque_constant_Nm_A > 0;
}

/// Of the table [effort].
std::string effort_lines(const simulate::Scenario& scenario) {
  std::string text = fmt::format("kind = \"{}\"\nside = \"motor\"\n",
                                 is_current(scenario) ? "motor_current" : "motor_torque");
  if (is_current(scenario)) {
    text += fmt::format("torque_constant_Nm_A = {}\n",
                        ingest::manifest::toml_number(scenario.log.torque_constant_Nm_A));
  }
  return text;
}

/// Table of the effects that were not simulated. @param table its name.
std::string effect_lines(const simulate::Scenario& scenario, const char* table) {
  const joint::EffectSizes absent = simulate::absent_effects(scenario);
  std::string text;
  for (const joint::Effect& effect : joint::statable_effects()) {
    if (absent.is_stated(effect))
      text += fmt::format("{} = {}\n", effect.stated_key(), toml_value(absent.of(effect)));
  }
  return text.empty() ? text : fmt::format("{}\n{}", table, text);
}

constexpr const char* speed_column = R"(speed = {name = "dq_rad_s", unit = "rad/s"})";

/// Columns that not every recording has.
std::string own_columns(const joint::Recording& recording, bool speed_is_common) {
  std::string columns;
  const auto add = [&](bool is_there, const char* column) {
    if (!is_there) return;
    if (!columns.empty()) columns += ", ";
    columns += column;
  };
  add(!recording.dq_rad_s.empty() && !speed_is_common, speed_column);
  add(!recording.z_rad.empty(), R"(bristle = {name = "z_rad", unit = "rad"})");
  add(!recording.dz_rad_s.empty(), R"(bristle_rate = {name = "dz_rad_s", unit = "rad/s"})");
  return columns;
}

}  // namespace

std::string description_beside(const simulate::Scenario& scenario) {
  return std::filesystem::path(scenario.robot_description).filename().string();
}

std::string dataset_toml(const simulate::Scenario& scenario,
                         const std::vector<joint::Recording>& recordings) {
  std::string text = "schema = \"tribolog-dataset-1\"\n\n[robot]\n";
  text += fmt::format("name = {}\n", ingest::manifest::toml_text(scenario.robot));
  if (!scenario.serial.empty())
    text += fmt::format("serial = {}\n", ingest::manifest::toml_text(scenario.serial));
  if (!scenario.robot_description.empty()) {
    text += fmt::format("description = {}\n",
                        ingest::manifest::toml_text(description_beside(scenario)));
  }
  text += fmt::format("note = {}\n", ingest::manifest::toml_text("simulated: " + scenario.name));
  text += fmt::format("\n[joint]\nname = {}\ngear_ratio = {}\n",
                      ingest::manifest::toml_text(scenario.joint),
                      ingest::manifest::toml_number(scenario.gear_ratio));
  text += "\n[effort]\n" + effort_lines(scenario);
  text += fmt::format("\n[surrogate]\ndistance_m = {}\ngravity_m_s2 = {}\n",
                      ingest::manifest::toml_number(scenario.surrogate_distance_m),
                      ingest::manifest::toml_number(scenario.load.gravity_m_s2()));
  text +=
      "\n[columns]\n"
      "time = {name = \"t_s\", unit = \"s\"}\n"
      "angle = {name = \"q_rad\", unit = \"rad\", side = \"joint\"}\n"
      "effort = ";
  text += is_current(scenario) ? "{name = \"i_A\", unit = \"A\"}\n"
                               : "{name = \"torque_Nm\", unit = \"Nm\"}\n";
  const bool speed_is_common =
      std::all_of(recordings.begin(), recordings.end(),
                  [](const joint::Recording& recording) { return !recording.dq_rad_s.empty(); });
  if (speed_is_common) text += fmt::format("{}\n", speed_column);
  text += reference(scenario.known_curve().get());
  text += effect_lines(scenario, "\n[effects]");
  for (const joint::Recording& recording : recordings) {
    text +=
        fmt::format("\n[[recording]]\nrole = \"{}\"\nfile = {}\n", joint::to_string(recording.role),
                    ingest::manifest::toml_text(recording.name));
    const std::string columns = own_columns(recording, speed_is_common);
    if (!columns.empty()) text += fmt::format("columns = {{{}}}\n", columns);
  }
  return text;
}

namespace {

void append(std::string& text, double value, const simulate::LogForm& form) {
  if (form.decimals) {
    fmt::format_to(std::back_inserter(text), "{:.{}f}", value, *form.decimals);
  } else {
    append_number(text, value);
  }
}

std::vector<double> currents_A(const std::vector<double>& torque_Nm, double constant_Nm_A) {
  std::vector<double> currents(torque_Nm.size());
  std::transform(torque_Nm.begin(), torque_Nm.end(), currents.begin(),
                 [&](double torque) { return torque / constant_Nm_A; });
  return currents;
}

}  // namespace

std::string recording_csv(const joint::Recording& recording, const simulate::LogForm& form) {
  std::vector<const double*> signals;
  std::string csv;
  const auto add = [&](const char* name, const std::vector<double>& signal, bool is_optional) {
    if (signal.empty() && is_optional) return;
    if (signal.size() != recording.size()) {
      throw std::invalid_argument(std::string(name) + " is not as long as t_s");
    }
    if (!signals.empty()) csv += ',';
    csv += name;
    signals.push_back(signal.data());
  };
  add("t_s", recording.t_s, false);
  add("q_rad", recording.q_rad, false);
  add("dq_rad_s", recording.dq_rad_s, true);
  const bool is_current = form.torque_constant_Nm_A > 0;
  const std::vector<double> currents =
      is_current ? currents_A(recording.torque_Nm, form.torque_constant_Nm_A)
                 : std::vector<double>();
  add(is_current ? "i_A" : "torque_Nm", is_current ? currents : recording.torque_Nm, false);
  add("z_rad", recording.z_rad, true);
  add("dz_rad_s", recording.dz_rad_s, true);
  csv += '\n';
  constexpr std::size_t usual_field_bytes = 20;
  csv.reserve(csv.size() + recording.size() * signals.size() * usual_field_bytes);
  for (std::size_t i = 0; i < recording.size(); ++i) {
    for (std::size_t k = 0; k < signals.size(); ++k) {
      if (k > 0) csv += ',';
      append(csv, signals[k][i], form);
    }
    csv += '\n';
  }
  return csv;
}

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::vector<friction::MaxwellElement>& elements) {
  Json list = Json::array();
  for (const friction::MaxwellElement& one : elements) {
    list.push_back(Json{{"stiffness_Nm_rad", one.stiffness_Nm_rad}, {"share", one.share}});
  }
  return list;
}

template <class Number>
Json json_of(Number number) {
  return number;
}

Json friction(const friction::FrictionModel& model) {
  Json json;
  json["model"] = model.name();
  for (const friction::NamedParameter& one : model.named_parameters()) {
    json[one.key] = std::visit([](const auto& value) { return json_of(value); }, one.value);
  }
  return json;
}

Json noise(const simulate::Noise& n) {
  Json ripple = Json::array();
  for (const simulate::Noise::Ripple& r : n.ripple) {
    ripple.push_back(Json{{"amplitude_Nm", r.amplitude_Nm},
                          {"periods_per_turn", r.periods_per_turn},
                          {"phase_rad", r.phase_rad}});
  }
  return {{"torque_white_Nm", n.torque_white_Nm},
          {"torque_step_Nm", n.torque_step_Nm},
          {"encoder_counts_per_turn", n.encoder_counts_per_turn},
          {"speed_filter_Hz", n.speed_filter_Hz},
          {"ripple", ripple},
          {"clock_jitter_s", n.clock_jitter_s},
          {"lost_percent", n.lost_percent},
          {"seed", n.seed}};
}

Json truth_of(const simulate::Scenario& scenario) {
  const joint::GravityLoad& load = scenario.load;
  const double motor_torque_Nm = load.amplitude_Nm() / scenario.gear_ratio;
  return {{"schema", "tribolog-truth-1"},
          {"scenario", scenario.name},
          {"robot", scenario.robot},
          {"serial", scenario.serial},
          {"joint", scenario.joint},
          {"gear_ratio", scenario.gear_ratio},
          {"q_peak_rad", load.q_peak_rad()},
          {"q_c_rad", -load.q_peak_rad()},
          {"mass_kg", load.mass_kg()},
          {"distance_m", load.distance_m()},
          {"gravity_m_s2", load.gravity_m_s2()},
          {"gravity_torque_joint_Nm", load.amplitude_Nm()},
          {"gravity_torque_motor_Nm", motor_torque_Nm},
          {"surrogate_distance_m", scenario.surrogate_distance_m},
          {"surrogate_mass_kg",
           joint::surrogate_mass_kg(motor_torque_Nm, scenario.gear_ratio,
                                    scenario.surrogate_distance_m, load.gravity_m_s2(), 1.0)},
          {"motor_inertia_kgm2", scenario.motor_inertia_kgm2},
          {"arm_inertia_kgm2", scenario.arm_inertia_kgm2},
          {"presliding", friction(*scenario.presliding)},
          {"sliding", friction(scenario.sliding_model())},
          {"noise", noise(scenario.noise)}};
}

std::string document_of(const Json& json) {
  return json_without_hidden(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace

std::string truth_json(const simulate::Scenario& scenario) {
  return document_of(truth_of(scenario));
}

void write_simulation(const simulate::Scenario& scenario,
                      const std::vector<joint::Recording>& recordings, const std::string& directory,
                      const std::vector<std::string>& inputs) {
  const std::filesystem::path folder(directory);
  for (const joint::Recording& recording : recordings) {
    if (recording.name.empty() || recording.name.find('/') != std::string::npos) {
      throw std::invalid_argument("'" + recording.name + "' is not a plain file name");
    }
  }
  AtomicFiles files;
  files.make_directory(directory);
  const auto add = [&](const std::string& name, const std::string& content) {
    const std::string path = (folder / name).string();
    check_output_can_be_written(path, inputs);
    files.add(path, content);
  };
  for (const joint::Recording& recording : recordings) {
    add(recording.name, recording_csv(recording, scenario.log));
  }
  if (!scenario.robot_description.empty()) {
    add(description_beside(scenario), scenario.robot_description_text);
  }
  add("truth.json", truth_json(scenario));
  add("dataset.toml", dataset_toml(scenario, recordings));
  files.commit();
}

namespace {

constexpr const char* robot_log_name = "robot.csv";

/// Of the joint's effort in a robot's log, the joints being counted from 1.
std::string effort_column(const simulate::Scenario& scenario, std::size_t joint) {
  return is_current(scenario) ? fmt::format("i{}_A", joint) : fmt::format("torque{}_Nm", joint);
}

std::string robot_csv(const std::vector<simulate::Scenario>& scenarios,
                      const simulate::RobotLog& log) {
  std::string csv = "t_s";
  for (std::size_t k = 0; k < scenarios.size(); ++k) {
    csv += fmt::format(",q{}_rad,{}", k + 1, effort_column(scenarios[k], k + 1));
  }
  csv += '\n';
  for (std::size_t i = 0; i < log.t_s.size(); ++i) {
    append(csv, log.t_s[i], scenarios.front().log);
    for (std::size_t k = 0; k < scenarios.size(); ++k) {
      const simulate::LogForm& form = scenarios[k].log;
      const double torque_Nm = log.joints[k].torque_Nm[i];
      csv += ',';
      append(csv, log.joints[k].q_rad[i], form);
      csv += ',';
      append(csv, is_current(scenarios[k]) ? torque_Nm / form.torque_constant_Nm_A : torque_Nm,
             form);
    }
    csv += '\n';
  }
  return csv;
}

std::string robot_toml(const std::vector<simulate::Scenario>& scenarios,
                       const simulate::RobotLog& log) {
  const simulate::Scenario& first = scenarios.front();
  std::string text = "schema = \"tribolog-dataset-1\"\n\n[robot]\n";
  text += fmt::format("name = {}\n", ingest::manifest::toml_text(first.robot));
  if (!first.serial.empty()) {
    text += fmt::format("serial = {}\n", ingest::manifest::toml_text(first.serial));
  }
  text += fmt::format("note = {}\n", ingest::manifest::toml_text("simulated: " + first.name));
  text += "\n[columns]\ntime = {name = \"t_s\", unit = \"s\"}\n";
  for (std::size_t k = 0; k < scenarios.size(); ++k) {
    const simulate::Scenario& s = scenarios[k];
    text += fmt::format("\n[[joints]]\nname = {}\ngear_ratio = {}\n",
                        ingest::manifest::toml_text(s.joint),
                        ingest::manifest::toml_number(s.gear_ratio));
    text += "[joints.effort]\n" + effort_lines(s);
    text += fmt::format("[joints.surrogate]\ndistance_m = {}\ngravity_m_s2 = {}\n",
                        ingest::manifest::toml_number(s.surrogate_distance_m),
                        ingest::manifest::toml_number(s.load.gravity_m_s2()));
    text += effect_lines(s, "[joints.effects]");
    text += fmt::format(
        "[joints.columns]\n"
        "angle = {{name = \"q{}_rad\", unit = \"rad\", side = \"joint\"}}\n"
        "effort = {{name = \"{}\", unit = \"{}\"}}\n",
        k + 1, effort_column(s, k + 1), is_current(s) ? "A" : "Nm");
    for (const simulate::RobotLog::Part& part : log.joints[k].parts) {
      text += fmt::format(
          "[[joints.recording]]\nrole = \"{}\"\nfile = \"{}\"\nfrom_s = {}\nto_s = {}\n",
          joint::to_string(part.role), robot_log_name, ingest::manifest::toml_number(part.from_s),
          ingest::manifest::toml_number(part.to_s));
    }
  }
  return text;
}

}  // namespace

void write_robot_simulation(const std::vector<simulate::Scenario>& joints,
                            const simulate::RobotLog& log, const std::string& directory,
                            const std::vector<std::string>& inputs) {
  AtomicFiles files;
  files.make_directory(directory);
  const auto add = [&](const std::string& name, const std::string& content) {
    const std::string path = (std::filesystem::path(directory) / name).string();
    check_output_can_be_written(path, inputs);
    files.add(path, content);
  };
  Json truth{{"schema", "tribolog-robot-truth-1"}, {"joints", Json::array()}};
  for (const simulate::Scenario& one : joints) truth["joints"].push_back(truth_of(one));
  add(robot_log_name, robot_csv(joints, log));
  add("truth.json", document_of(truth));
  add("robot.toml", robot_toml(joints, log));
  files.commit();
}

}  // namespace tribolog::exports::simulation
