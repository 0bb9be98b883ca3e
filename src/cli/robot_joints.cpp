#include "cli/robot_joints.h"

#include <algorithm>
#include <chrono>
#include <set>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/parallel_for.h"
#include "base/shown_text.h"
#include "tribolog/failure.h"

namespace tribolog::cli {
namespace {

void identify_one(const std::string& manifest, IdentifyOptions options, IdentifiedJoint& joint) {
  try {
    options.progress("reading", 0, 1);
    joint.dataset = Dataset::read(manifest, joint.name);
    joint.calibration = identify_joint(*joint.dataset, options);
    options.progress("identified", 1, 1);
  } catch (const Failure& failure) {
    joint.refusal = failure.what();
    joint.status = static_cast<ExitStatus>(failure.exit_status());
    options.progress("refused", 1, 1);
  }
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_';
}

}  // namespace

JointProgress::JointProgress(const std::vector<std::string>& names, Console& console)
    : console_(console) {
  for (const std::string& name : names) steps_.push_back({name, "", 0, 1});
}

Progress JointProgress::of(std::size_t joint) {
  return [this, joint](const std::string& what, std::size_t done, std::size_t all) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Console::Step& step = steps_[joint];
    const bool is_new = step.what != what;
    step.what = what;
    step.done = done;
    step.all = all;
    using std::chrono::steady_clock;
    constexpr std::chrono::milliseconds between_drawings(100);
    if (!is_new && steady_clock::now() - drawn_ < between_drawings) return;
    console_.progress(steps_);
    drawn_ = steady_clock::now();
  };
}

std::vector<std::string> joints_to_do(const DatasetChoice& choice) {
  if (!choice.joint.empty()) return {};
  return Dataset::joints_in(choice.manifest);
}

std::string as_file_name(const std::string& name) {
  constexpr std::size_t longest = 60;
  std::string plain;
  for (const char c : name.substr(0, longest)) plain += is_plain(c) ? c : '_';
  return plain;
}

std::vector<std::string> file_names_of(const std::vector<std::string>& joints) {
  std::set<std::string> taken{"index"};
  std::vector<std::string> names;
  for (const std::string& joint : joints) {
    const std::string name = as_file_name(joint);
    std::string free = name;
    for (int k = 2; !taken.insert(free).second; ++k) free = fmt::format("{}_{}", name, k);
    names.push_back(free);
  }
  return names;
}

std::vector<IdentifiedJoint> identify_joints(const std::string& manifest,
                                             const std::vector<std::string>& names,
                                             const IdentificationSettings& settings,
                                             Console& console) {
  IdentifyOptions options = options_of(settings);
  const std::vector<std::string> file_names = file_names_of(names);
  std::vector<IdentifiedJoint> joints(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    joints[k].name = names[k];
    joints[k].file_name = file_names[k];
  }
  JointProgress progress(names, console);
  parallel_for(joints.size(), [&](std::size_t k) {
    IdentifyOptions own = options;
    own.progress = progress.of(k);
    identify_one(manifest, std::move(own), joints[k]);
  });
  console.finish();
  for (const IdentifiedJoint& joint : joints) {
    const std::string name = printable(joint.name);
    if (joint.dataset) tell_notes(*joint.dataset, name + ": ", console);
    if (!joint.refusal.empty()) console.warn(name + ": error: " + joint.refusal);
  }
  return joints;
}

void protect_inputs(const std::vector<IdentifiedJoint>& joints, const std::string& directory) {
  for (const IdentifiedJoint& joint : joints) {
    if (!joint.dataset) continue;
    for (const IdentifiedJoint& other : joints) {
      check_output_can_be_written(directory + "/" + calibration_name(other),
                                  joint.dataset->files());
    }
  }
}

void keep_numbers(std::vector<IdentifiedJoint>& joints, const std::string& manifest,
                  Archiving& archiving, Console& console) {
  std::vector<NumbersToKeep> numbers;
  std::vector<IdentifiedJoint*> kept;
  for (IdentifiedJoint& joint : joints) {
    if (!joint.calibration) continue;
    numbers.push_back({joint.calibration->to_json(), calibration_name(joint)});
    kept.push_back(&joint);
  }
  const std::vector<std::string> ids = archiving.keep_numbers(numbers, manifest, console);
  for (std::size_t k = 0; k < ids.size(); ++k) kept[k]->archived_as = ids[k];
}

ExitStatus status_of(const std::vector<IdentifiedJoint>& joints,
                     const std::optional<Verdict>& fail_on) {
  ExitStatus status = ExitStatus::done;
  for (const IdentifiedJoint& joint : joints) {
    if (!joint.calibration) return joint.status;
    if (const ExitStatus one = status_of(*joint.calibration, fail_on); one != ExitStatus::done) {
      status = one;
    }
  }
  return status;
}

void tell_outcome(const std::vector<IdentifiedJoint>& joints, Console& console) {
  std::size_t usable = 0;
  for (const IdentifiedJoint& joint : joints) {
    const std::string name = printable(joint.name);
    if (!joint.calibration) {
      console.say(fmt::format("{}: refused", name));
      continue;
    }
    usable += joint.calibration->verdict() == Verdict::usable ? 1 : 0;
    console.say(fmt::format("{}: {} - {}", name, code_of(joint.calibration->verdict()),
                            joint.calibration->sentence().words));
  }
  console.say(fmt::format("{} of {} joints usable", usable, joints.size()));
}

std::string calibration_name(const IdentifiedJoint& joint) {
  return joint.file_name + ".calibration.json";
}

}  // namespace tribolog::cli
