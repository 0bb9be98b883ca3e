#pragma once
// The legend of a panel: what it says, and where it covers no data.

#include <optional>
#include <string>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/layout/figure_style.h"
#include "render/layout/occupancy.h"
#include "render/layout/panel_drawing.h"

namespace tribolog::render::layout {

class Legend {
 public:
  /// Texts wider than `most_width` are cut with an ellipsis and reported.
  Legend(const figure::Panel& panel, int panel_index, const text::Font& font,
         const FigureStyle& style, double most_width, std::vector<Statement>& warnings,
         text::TextFaults& faults);

  /// That a text of this width takes, with its sample.
  static double width_of(double text, const FigureStyle& style);

  [[nodiscard]] bool empty() const { return entries_.empty(); }

  /// Draws it inside the plot where no cell is taken, nearest to a corner. False if there is no
  /// such place.
  bool draw_inside(figure::DrawList& list, const figure::PixelBox& plot,
                   const Occupancy& taken) const;

  /// Right of the plot, each name at the height where its series ends, or as near as the others let
  /// it. Series that end nowhere in sight are named last.
  void draw_beside(figure::DrawList& list, const PanelFrame& frame) const;

  /// Height of the strip that it needs below the plot, and drawing it there.
  [[nodiscard]] double strip_height(double width) const;
  void draw_strip(figure::DrawList& list, const figure::PixelBox& plot, double top) const;

 private:
  struct Entry {
    const figure::Series* series{};
    const figure::Series* series_end{};  ///< Those without a label that follow continue it.
    const figure::Band* band{};
    figure::Owner sample;
    figure::Owner text;
    text::TextLine label;
  };
  struct Block {
    std::size_t columns{1};
    std::size_t rows{};
    std::vector<double> column_widths;
    double width{};
    double height{};
  };
  [[nodiscard]] Block arranged(std::size_t columns) const;
  [[nodiscard]] Block widest_block(double width) const;
  [[nodiscard]] std::optional<figure::PixelPoint> free_place(const Block& block,
                                                             const figure::PixelBox& plot,
                                                             const Occupancy& taken) const;
  void draw_block(figure::DrawList& list, const Block& block, figure::PixelPoint top_left,
                  bool framed) const;
  void draw_sample(figure::DrawList& list, const Entry& entry,
                   figure::PixelPoint left_middle) const;

  const FigureStyle& style_;
  int panel_;
  std::vector<Entry> entries_;
  double row_height_{};
  double sample_width_{};
  double padding_{};
};

}  // namespace tribolog::render::layout
