#pragma once
// The paper from its first section to its last, as a list to tick off: every figure, table and
// equation in the order of print, each with its checks.

#include <string>
#include <vector>

#include "figures/report_figure.h"
#include "paper/checks/check.h"
#include "paper/checks/papers_joint.h"

namespace tribolog::paper::checks {

enum class ItemKind { figure, table, equation, statement };
/// "figure", of anchors and for machines.
const char* key_of(ItemKind kind);

struct PaperItem {
  ItemKind kind{};
  int number{};        ///< As printed; 0 for a statement.
  std::string title;   ///< What it is.
  std::string remark;  ///< What is misprinted or left open in it; may be empty.
  Checks checks;       ///< At least one.
};

struct PaperSection {
  std::string number;  ///< "3.2"
  std::string title;
  std::vector<PaperItem> items;
};

/// @param figures those that are drawn; figure 3's checks are read off its drawing.
std::vector<PaperSection> paper_items(const PapersJoint& joint,
                                      const std::vector<figures::ReportFigure>& figures);

/// How many there are, and how many hold.
struct Tally {
  int there{};
  int hold{};
};
Tally tally_checks(const Checks& checks);
/// All checks of all items.
Tally tally_checks(const std::vector<PaperSection>& sections);
/// Has the item a check, and does each hold?
bool every_check_holds(const PaperItem& item);

// The paper's figures, regenerated.

/// In the order of their numbers: charts, drawings and scenes, and those of the identification.
std::vector<figures::ReportFigure> paper_figures(const PapersJoint& joint);

}  // namespace tribolog::paper::checks
