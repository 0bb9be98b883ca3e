#include "export/calibration/simulator_number.h"

#include <string_view>

#include <fmt/format.h>

#include "base/error.h"

namespace tribolog::archive {
namespace {

/// Empty: it can be used.
std::string objection(const ArchivedJoint& joint, std::string_view name, bool doubtful_too,
                      bool is_number) {
  for (const Quantity& q : joint.quantities) {
    if (q.name != name) continue;
    const std::string words = printable(q.words);
    if (is_number && !q.estimate) return words + " was not identified";
    const std::string shown =
        is_number ? fmt::format(" of {:.4g} {} (95 %: {:.4g} to {:.4g})", q.estimate->value,
                                printable(q.unit), q.estimate->low, q.estimate->high)
                  : "";
    if (is_number && q.estimate->value < 0) return words + shown + " is below zero";
    if (q.verdict == Verdict::usable || doubtful_too) return "";
    return fmt::format("{}{} is {}; --doubtful-too exports it all the same", words, shown,
                       tribolog::to_string(q.verdict));
  }
  return "the calibration has no " + printable(std::string(name));
}

std::string shown_id(const ArchivedJoint& joint) { return joint.entry.id.substr(0, shown_digits); }

}  // namespace

const Quantity& needed(const ArchivedJoint& joint, std::string_view name, bool doubtful_too) {
  const std::string why = objection(joint, name, doubtful_too, true);
  if (!why.empty()) throw UsageError(shown_id(joint) + ": not exported: " + why);
  return *joint.found(name);
}

const Quantity* if_usable(const ArchivedJoint& joint, std::string_view name, bool doubtful_too,
                          std::string& why_not) {
  why_not = objection(joint, name, doubtful_too, true);
  return why_not.empty() ? joint.found(name) : nullptr;
}

void refuse_doubtful(const ArchivedJoint& joint, std::string_view name, bool doubtful_too) {
  const std::string why = objection(joint, name, doubtful_too, false);
  if (!why.empty()) throw UsageError(shown_id(joint) + ": not exported: " + why);
}

}  // namespace tribolog::archive
