#pragma once
// Internal to the report: what lowers the verdict, each said once and referred to by its number.

#include <vector>

#include "calibration/calibration.h"
#include "report/document/report_view.h"

namespace tribolog::report::document {

/// First what lowers numbers that count, then notes; within these the verdict's findings in their
/// order, then those reasons of quantities that no finding states.
class NumberedFindings {
 public:
  explicit NumberedFindings(const calibration::Judgement& judgement);

  /// The number of the finding that states this, itself or as what it rests on; 0: none does.
  [[nodiscard]] int number_of(const Statement& statement) const;
  /// On which a quantity's verdict rests, ascending, each once.
  [[nodiscard]] std::vector<int> numbers_of(const calibration::QuantityVerdict& quantity) const;
  [[nodiscard]] const std::vector<Finding>& all() const { return findings_; }

 private:
  /// A reason that is no finding of its own, of one quantity, is a sentence on that quantity.
  void put_nouns_first(const calibration::Judgement& judgement);

  std::vector<Statement> statements_;
  std::vector<Finding> findings_;
};

/// What to do next: what failing checks on the data ask for, then what to record, that for most
/// quantities first.
std::vector<NextStep> next_steps(const calibration::Calibration& calibration);

}  // namespace tribolog::report::document
