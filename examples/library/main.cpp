// Identifies a joint from its logs, prints the results with units and verdicts, and writes the
// numbers, a report and the figures: joint_check DATASET.toml DIRECTORY

#include <cstddef>
#include <cstdio>
#include <string>

#include <tribolog/tribolog.h>

namespace {

void print(const tribolog::Quantity& quantity) {
  std::printf("%-32s", quantity.words.c_str());
  if (quantity.estimate) {
    const tribolog::Estimate& e = *quantity.estimate;
    std::printf(" %.6g %s (%g %%: %.6g to %.6g)", e.value, quantity.unit.c_str(), 100 * e.coverage,
                e.low, e.high);
  }
  std::printf(" %s\n", code_of(quantity.verdict).c_str());
  for (const tribolog::Message& reason : quantity.reasons) {
    std::printf("    %s [%s]\n", reason.words.c_str(), reason.code.c_str());
  }
}

int check(const std::string& manifest, const std::string& directory) {
  tribolog::Renderer renderer({2, manifest});  // starts drawing processes: before other threads
  const tribolog::Dataset dataset = tribolog::Dataset::read(manifest);
  for (const tribolog::Message& note : dataset.notes()) {
    std::printf("note: %s\n", note.words.c_str());
  }

  tribolog::IdentifyOptions options;
  options.progress = [](const std::string& what, std::size_t done, std::size_t all) {
    std::fprintf(stderr, "%zu/%zu %s\n", done, all, what.c_str());
  };
  const tribolog::Calibration found = tribolog::identify_joint(dataset, options);
  for (const tribolog::Quantity& quantity : found.quantities()) print(quantity);

  const tribolog::Report report = tribolog::make_report(found, {}, &renderer);
  const tribolog::Figures figures = tribolog::draw_figures(found, {}, &renderer);
  tribolog::write_files(figures.files, directory + "/figures");
  tribolog::write_files({{"report.html", report.html}, {"calibration.json", found.to_json()}},
                        directory);

  // Another day, from the file only.
  const tribolog::Calibration kept = tribolog::Calibration::read(directory + "/calibration.json");
  if (const auto torque = kept.quantity("coulomb_torque"); torque && torque->at_joint) {
    std::printf("Coulomb torque at the joint: %.6g N·m\n", torque->at_joint->value);
  }
  std::printf("%s: %s\n", code_of(kept.verdict()).c_str(), kept.sentence().words.c_str());
  return kept.verdict() == tribolog::Verdict::usable ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s DATASET.toml DIRECTORY\n", argv[0]);
    return 2;
  }
  try {
    return check(argv[1], argv[2]);
  } catch (const tribolog::Failure& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return failure.exit_status();
  }
}
