// The study of many small effects at once.

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/parallel_for.h"
#include "study/misfit_runs.h"
#include "study/misfit_truths.h"
#include "study/mixed_joints.h"
#include "study/study.h"

namespace tribolog::study {
namespace {

constexpr const char* disturbance_key = "small_effects";

MisfitRun run_joint(std::size_t number, double size, const MixedOptions& options) {
  const MixedJoint joint = mixed_joint(options.seed, number, size);
  const auto ideal = simulate::simulate_ideal_joint(joint.laid);
  MisfitCase of;
  of.joint = fmt::format("mixed_{:03}", number + 1);
  of.disturbance = disturbance_key;
  of.size = size;
  of.runs = 1;
  const simulate::Noise noise = noise_of_run(joint.laid.noise, options.seed, number);
  return {identified(of, joint.laid, ideal, noise, options.keep_logs).quantities,
          truths_of(joint.undisturbed, joint.laid, ideal)};
}

MisfitCase run_mixed_case(double size, const MixedOptions& options) {
  MisfitCase out;
  out.joint = "mixed";
  out.disturbance = disturbance_key;
  out.size = size;
  out.runs = options.joints;
  std::vector<MisfitRun> runs(options.joints);
  parallel_for(
      options.joints, [&](std::size_t number) { runs[number] = run_joint(number, size, options); },
      options.threads);
  out.quantities = count_runs(runs);
  return out;
}

}  // namespace

std::vector<MisfitCase> run_mixed_study(const MixedOptions& options,
                                        const MisfitProgress& progress) {
  const std::vector<double> sizes{1, 2};
  std::vector<MisfitCase> out;
  for (const double size : sizes) {
    if (progress) progress(fmt::format("small effects, size {:g}", size), out.size(), sizes.size());
    out.push_back(run_mixed_case(size, options));
  }
  return out;
}

}  // namespace tribolog::study
