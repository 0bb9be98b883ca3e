#include "tribolog/calibration.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "api/contents.h"
#include "api/guard.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "base/input_file.h"
#include "calibration/calibration_json.h"
#include "identify/identify.h"
#include "wording/language.h"
#include "wording/torques_in.h"
#include "wording/words.h"

namespace tribolog::api {

const Identified& Inside::of(const Calibration& calibration) {
  const auto& identified = calibration.contents_->identified;
  if (!identified) {
    throw UsageError(
        "a calibration that was read from JSON has no recordings to show; identify its dataset");
  }
  return *identified;
}

Calibration Inside::made(Calibration::Contents contents) {
  return Calibration(std::make_shared<const Calibration::Contents>(std::move(contents)));
}

namespace {

/// While it lives, this thread's words are an outcome's.
class WordsOf {
 public:
  WordsOf(const Outcome& outcome, const std::string& language)
      : language_(language_of(language)), torques_(torque_unit_of(outcome.joint)) {}

 private:
  wording::WordsIn language_;
  wording::TorquesIn torques_;
};

/// Each of them with its texts in that language.
template <class Value, class Kept>
std::vector<Value> all_worded(const Outcome& outcome, const std::vector<Kept>& all,
                              const std::string& language) {
  return guarded([&] {
    const WordsOf words(outcome, language);
    std::vector<Value> values;
    values.reserve(all.size());
    for (const Kept& one : all) values.push_back(worded(one));
    return values;
  });
}

identify::IdentifyOptions inside_options(const IdentifyOptions& given,
                                         const std::optional<std::uint64_t>& stated_seed) {
  identify::IdentifyOptions options;
  options.truth_runs = given.truth_runs;
  options.threads = given.threads;
  options.seed = given.seed.value_or(stated_seed.value_or(options.seed));
  return options;
}

/// What the provenance says about the simulations of the known-truth check.
std::vector<calibration::Setting> configuration_of(const identify::IdentifyOptions& options) {
  if (options.truth_runs == 0) return {};
  return {{{"setting.seed"}, Statement::verbatim(std::to_string(options.seed))}};
}

}  // namespace
}  // namespace tribolog::api

namespace tribolog {

Calibration::Calibration(std::shared_ptr<const Contents> contents)
    : contents_(std::move(contents)) {}

Calibration Calibration::from_json(const std::string& json, const std::string& name) {
  return api::guarded(
      [&] { return api::Inside::made({api::read_outcome(json, name), json, nullptr}); });
}

Calibration Calibration::read(const std::string& path) {
  return api::guarded([&] { return from_json(read_file(path), path); });
}

const std::string& Calibration::to_json() const { return contents_->json; }

void Calibration::write(const std::string& path) const {
  api::guarded([&] { write_file_atomically(path, contents_->json); });
}

Joint Calibration::joint() const {
  return api::guarded([&] { return contents_->outcome.joint; });
}

Verdict Calibration::verdict() const { return contents_->outcome.verdict; }

Message Calibration::sentence(const std::string& language) const {
  return api::guarded([&] {
    const api::WordsOf words(contents_->outcome, language);
    return api::message_of(contents_->outcome.sentence);
  });
}

std::vector<Message> Calibration::findings(const std::string& language) const {
  return api::guarded([&] {
    const api::WordsOf words(contents_->outcome, language);
    return api::messages_of(contents_->outcome.findings);
  });
}

std::vector<Quantity> Calibration::quantities(const std::string& language) const {
  return api::all_worded<Quantity>(contents_->outcome, contents_->outcome.quantities, language);
}

std::optional<Quantity> Calibration::quantity(const std::string& name,
                                              const std::string& language) const {
  return api::guarded([&]() -> std::optional<Quantity> {
    const api::WordsOf words(contents_->outcome, language);
    const auto& all = contents_->outcome.quantities;
    const auto found = std::find_if(all.begin(), all.end(), [&](const api::JudgedQuantity& one) {
      return one.quantity.name == name;
    });
    if (found == all.end()) return std::nullopt;
    return api::worded(*found);
  });
}

std::vector<FrictionAtSpeed> Calibration::friction_at_speeds(const std::string& language) const {
  return api::all_worded<FrictionAtSpeed>(contents_->outcome, contents_->outcome.friction_at_speeds,
                                          language);
}

std::string Calibration::estimator() const {
  return api::guarded([&] { return contents_->outcome.estimator; });
}

std::vector<Check> Calibration::checks(const std::string& language) const {
  return api::all_worded<Check>(contents_->outcome, contents_->outcome.checks, language);
}

std::vector<Stage> Calibration::stages(const std::string& language) const {
  return api::all_worded<Stage>(contents_->outcome, contents_->outcome.stages, language);
}

std::vector<InputFile> Calibration::inputs(const std::string& language) const {
  return api::all_worded<InputFile>(contents_->outcome, contents_->outcome.inputs, language);
}

bool Calibration::has_recordings() const { return contents_->identified != nullptr; }

Calibration identify_joint(const Dataset& dataset, const IdentifyOptions& options) {
  return api::guarded([&] {
    const joint::Dataset& recorded = api::Inside::of(dataset);
    const identify::IdentifyOptions inside = api::inside_options(options, recorded.manifest.seed);
    calibration::Provenance provenance = calibration::make_provenance(options.command_line);
    const auto progress = [&](const std::string& stage, int done, int all) {
      if (!options.progress) return;
      options.progress(stage, static_cast<std::size_t>(done), static_cast<std::size_t>(all));
    };
    calibration::Calibration found = identify::identify(recorded, inside, progress);
    provenance.configuration = api::configuration_of(inside);
    std::string json = calibration::calibration_json(found, provenance);
    api::Outcome outcome = api::outcome_of(found);
    return api::Inside::made({std::move(outcome), std::move(json),
                              std::make_shared<const api::Identified>(api::Identified{
                                  dataset, std::move(found), std::move(provenance)})});
  });
}

}  // namespace tribolog
