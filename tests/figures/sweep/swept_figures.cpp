#include "figures/sweep/swept_figures.h"

#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/input_file.h"
#include "figures/experiments/model_figures.h"
#include "figures/experiments/plan_figure.h"
#include "figures/experiments/study_figures.h"
#include "figures/figure_set.h"
#include "figures/hand_made_calibration.h"
#include "friction/catalogue.h"
#include "identify/identify.h"
#include "ingest/manifest/joint_file.h"
#include "ingest/manifest/robot_file.h"
#include "ingest/manifest/scenario_file.h"
#include "paper/scenes/scene_figures.h"
#include "plan/experiment_plan.h"
#include "render/vector/drawn_set.h"
#include "simulate/simulate_joint.h"
#include "study/small_scenario.h"
#include "support/breadth.h"

namespace tribolog::test {
namespace {

std::string example_file(const std::string& name) {
  return std::string(TRIBOLOG_SOURCE_DIR) + "/examples/" + name;
}

struct Identified {
  joint::Dataset dataset;
  calibration::Calibration calibration;
};

Identified identified(const std::string& scenario) {
  joint::Dataset dataset = simulate::simulated_dataset(
      ingest::manifest::read_scenario(example_file("paper/" + scenario)));
  dataset.robot = std::make_shared<robot::RobotDescription>(
      ingest::manifest::read_robot(example_file("paper/am100ib.toml")));
  identify::IdentifyOptions options;
  options.truth_runs = every_case() ? 3 : 2;
  calibration::Calibration calibration = identify::identify(dataset, options);
  return {std::move(dataset), std::move(calibration)};
}

/// As `tribolog report` draws them, in the language of now.
std::vector<figures::ReportFigure> figures_of_scenario(const std::string& name) {
  static std::map<std::string, Identified> made;
  auto there = made.find(name);
  if (there == made.end()) there = made.emplace(name, identified(name)).first;
  const auto& [dataset, calibration] = there->second;
  return paper::scenes::with_scene_figures(figures::figure_set(dataset, calibration),
                                           dataset.robot.get(), calibration);
}

std::vector<figures::ReportFigure> figures_of_a_sweep_alone() {
  const joint::Dataset dataset = hand_made_dataset();
  return figures::figure_set(dataset, sweep_only_calibration(dataset));
}

std::vector<figures::ReportFigure> figures_of_the_plan() {
  const std::string file = example_file("plan/joint.toml");
  return figures::experiments::plan_figures(
      plan::plan_experiment(ingest::manifest::parse_joint(read_file(file), file)));
}

std::vector<figures::ReportFigure> figures_of_the_models() {
  std::vector<figures::ReportFigure> out;
  for (figures::experiments::ModelExperiment& one :
       figures::experiments::model_experiments(friction::ContactParameters{})) {
    std::move(one.figures.begin(), one.figures.end(), std::back_inserter(out));
  }
  return out;
}

std::vector<figures::ReportFigure> figures_of_a_small_study() {
  study::StudyOptions options;
  options.runs = every_case() ? 3 : 2;
  if (!every_case()) options.factors = {"cycles", "torque_noise"};
  return figures::experiments::study_figures(study::run_study(small_scenario(), options));
}

using Maker = std::function<std::vector<figures::ReportFigure>()>;

const std::map<std::string, Maker, std::less<>>& makers() {
  static const std::map<std::string, Maker, std::less<>> all{
      {"paper", render::paper_set},
      {"ideal", [] { return figures_of_scenario("scenario.toml"); }},
      {"noise", [] { return figures_of_scenario("scenario_noise.toml"); }},
      {"ripple", [] { return figures_of_scenario("scenario_ripple.toml"); }},
      {"sweep_alone", figures_of_a_sweep_alone},
      {"plan", figures_of_the_plan},
      {"models", figures_of_the_models},
      {"study", figures_of_a_small_study},
      {"history", [] { return render::history_set(render::every_trend); }}};
  return all;
}

}  // namespace

std::vector<std::string> swept_examples() {
  std::vector<std::string> names;
  for (const auto& [name, make] : makers()) names.push_back(name);
  return names;
}

const std::vector<figures::ReportFigure>& figures_of(std::string_view example,
                                                     const wording::Language& language) {
  static std::map<std::pair<std::string, wording::Language>, std::vector<figures::ReportFigure>>
      made;
  const std::pair key(std::string(example), language);
  const auto there = made.find(key);
  if (there != made.end()) return there->second;
  const auto maker = makers().find(example);
  if (maker == makers().end())
    throw std::invalid_argument("no example is called " + std::string(example));
  const wording::WordsIn words(language);
  return made.emplace(key, maker->second()).first->second;
}

}  // namespace tribolog::test
