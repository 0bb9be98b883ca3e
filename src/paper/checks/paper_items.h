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
std::string key_of(ItemKind kind);

struct PaperItem {
  ItemKind kind{};
  int number{};        ///< As printed; 0 for a statement.
  std::string title;   ///< What it is.
  std::string remark;  ///< What is misprinted or left open in it; may be empty.
  Checks checks;
  /// What is so by definition, or was taken from print: no check of it could fail.
  std::vector<std::string> unchecked;
  std::string printed_caption{};  ///< Of a figure.
};

/// "Figure 15", "Table 2", "Equation 4", "The conclusions"
std::string item_name(const PaperItem& item);

struct PaperSection {
  std::string number;  ///< "3.2"
  std::string title;
  std::vector<PaperItem> items;
};

/// @param figures those that are drawn; figure 3's checks are read off its drawing.
std::vector<PaperSection> paper_items(const PapersJoint& joint,
                                      const std::vector<figures::ReportFigure>& figures);

/// The items of print alone that compare it with the joint, for it and for others.
std::vector<PaperItem> items_of_print(const PapersJoint& joint);

/// How many there are, and how many hold.
struct Tally {
  int there{};
  int hold{};
};
Tally tally_checks(const Checks& checks);
/// Of one kind, or of all items.
Tally tally_checks(const Checks& checks, Kind kind);
Tally tally_checks(const std::vector<PaperSection>& sections, Kind kind);
/// Does each check of the item hold?
bool every_check_holds(const PaperItem& item);
/// Checks of print, in the order of the paper.
std::vector<const Check*> print_checks(const std::vector<PaperSection>& sections);
/// Those of them that give a printed number to its last place.
int to_the_last_place(const std::vector<PaperSection>& sections);
/// How many items are stated without a check.
int count_unchecked(const std::vector<PaperSection>& sections);

// The paper's figures, regenerated.

/// In the order of their numbers: charts, drawings and scenes, and those of the identification.
std::vector<figures::ReportFigure> paper_figures(const PapersJoint& joint);

}  // namespace tribolog::paper::checks
