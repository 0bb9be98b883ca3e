#pragma once
// Figures for the columns of a journal.

#include "render/figure/figure.h"
#include "render/text/font.h"

namespace tribolog::render::composition {

namespace publication {
inline constexpr double single_column_mm = 84.0;
inline constexpr double double_column_mm = 174.0;
inline constexpr double highest_mm = 220.0;  ///< What a page leaves above its caption.
inline constexpr double px_per_mm = 20.0;    ///< 508 dots to the inch.
}  // namespace publication

/// The same figure for print: without its title, which stands in the caption; letters of 7 to 8 pt,
/// thin lines; as wide as one column, or as two where it does not fit into one: a text would be
/// cut, a label stand on a curve, or the legend leave too little room for the curves.
///
/// Heights: a chart of one panel is 84 x 60 mm, or 174 x 74 mm, and higher where many names stand
/// on its vertical axis; of several, each has a plot of 36 mm in one column and of 52 mm in two,
/// less what its legend takes. Drawings keep their proportions, and their letters the size of a
/// chart's; scenes keep their proportions.
/// @throw tribolog::FigureError as lay_out().
figure::Figure for_publication(const figure::Figure& figure, const text::Font& font);

}  // namespace tribolog::render::composition
