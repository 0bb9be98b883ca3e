#pragma once
// What pages are made of, as ready text: tables, facts, figures with their captions.

#include <cstddef>
#include <string>
#include <vector>

namespace tribolog::report::elements {

/// How far a stage came, what a verdict says; decides icon, word and colour.
enum class Outcome { good, partial, bad, absent };

struct Column {
  std::string heading;
  std::string unit;      ///< Shown in brackets below the heading; empty: none.
  bool is_number{true};  ///< Right-aligned, tabular digits.
  bool is_wide{false};   ///< Words that should not be squeezed into one per line.
};

struct Row {
  std::vector<std::string> cells;  ///< One per column; the first is the row's heading.
  bool is_chosen{false};           ///< Emphasised: the value to use.
};

/// A table without rows is not printed.
struct Table {
  std::string id;  ///< Anchor, "table-..."
  std::string caption;
  std::vector<Column> columns;
  std::vector<Row> rows;
  std::string note;   ///< Below the table; empty: none.
  bool is_stacked{};  ///< Of words rather than numbers: its columns are wide.
  bool is_of_estimates{};
};

struct Fact {
  std::string name;
  std::string text;
};

struct FigureCard {
  std::string id;
  std::string title;    ///< "Friction hysteresis"
  int paper_number{};   ///< 0: not a figure of the paper.
  std::string heading;  ///< "Figure 15: Friction hysteresis"
  std::string caption;
  std::string how_to_read;
  std::string alt;
  const std::vector<std::byte>* png{nullptr};  ///< Null if the figure is missing.
  int width_px{};
  int height_px{};
  bool is_lazy{false};
  bool is_primary{true};  ///< In sight; the others are folded.
  std::string error;      ///< Why the figure is missing.
  std::vector<std::string> warnings;
  std::string csv;  ///< The data behind it; empty: it shows none.
};

}  // namespace tribolog::report::elements
