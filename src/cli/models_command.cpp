#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.h"
#include "friction/catalogue.h"

namespace tribolog {
namespace {

std::string joined(const std::vector<std::string>& words) {
  return words.empty() ? "none of it" : fmt::format("{}", fmt::join(words, ", "));
}

std::string shown_by(const FrictionTraits& traits) {
  std::vector<std::string> words;
  const auto add = [&](bool shows, const char* word) {
    if (shows) words.emplace_back(word);
  };
  add(traits.presliding, "pre-sliding");
  add(traits.break_away, "break-away torque above Coulomb torque");
  add(traits.stribeck, "Stribeck effect");
  add(traits.lag, "frictional lag");
  add(traits.non_local_memory, "non-local memory");
  return joined(words);
}

std::string limits_of(const FrictionTraits& traits) {
  std::vector<std::string> words;
  if (traits.drifts) words.emplace_back("drifts under an oscillating torque below break-away");
  if (traits.rate_independent) words.emplace_back("rate independent");
  if (traits.is_random) words.emplace_back("random");
  return words.empty() ? "" : fmt::format("\n    {}", fmt::join(words, "; "));
}

}  // namespace

ExitStatus run_models(Console& console) {
  console.say("dynamic friction models, as a scenario names them (friction.presliding.model):\n");
  for (const FrictionModelEntry& one : dynamic_friction_models()) {
    console.say(fmt::format("  {:<18}{} ({})\n    shows {}{}\n", one.name, one.title, one.source,
                            shown_by(one.traits), limits_of(one.traits)));
  }
  console.say(
      "static laws: eq. (1) Coulomb, viscous and Stribeck; eq. (2) with a threshold speed; eq. "
      "(6),\n"
      "(7) Waiboer (friction.sliding.model = \"waiboer\")");
  return ExitStatus::done;
}

}  // namespace tribolog
