#include "render/legibility/text_collisions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <variant>

#include "render/layout/polyline.h"
#include "render/legibility/texts_of_list.h"

namespace tribolog::render::legibility {
namespace {

constexpr double touch_px2 = 1.0;   // of two texts; boxes are rounded to pixels
constexpr double graze_px = 1.0;    // what data may reach into a text's box: its letters are inside
constexpr std::size_t cloud = 150;  // markers from which on single ones do not matter
constexpr double visible_share = 0.75;  // of a marker's size, that must stay free of a text

bool is_data(figure::Role role) {
  static const std::set<figure::Role> data{
      figure::Role::series,          figure::Role::series_marker, figure::Role::error_bar,
      figure::Role::direction_arrow, figure::Role::label_marker,  figure::Role::label_leader,
      figure::Role::reference_line,  figure::Role::wire,          figure::Role::wire_head,
      figure::Role::branch_dot,      figure::Role::shape,         figure::Role::scene_line};
  return data.count(role) > 0;
}

const char* words_for(figure::Role role) {
  switch (role) {
    case figure::Role::series:
      return "a curve";
    case figure::Role::series_marker:
      return "a marker";
    case figure::Role::error_bar:
      return "an interval";
    case figure::Role::direction_arrow:
      return "an arrow of direction";
    case figure::Role::label_marker:
      return "a point with a name";
    case figure::Role::label_leader:
      return "a leader";
    case figure::Role::reference_line:
      return "a reference line";
    default:
      return "a line of the drawing";
  }
}

/// "a marker of series 3 in panel 1"
std::string named(const figure::Owner& owner) {
  return std::string(words_for(owner.role)) + " (" + std::to_string(owner.index + 1) +
         " of panel " + std::to_string(owner.panel + 1) + ")";
}

figure::PixelBox around(const std::vector<figure::PixelPoint>& outline) {
  figure::PixelBox box{1e9, 1e9, -1e9, -1e9};
  for (const figure::PixelPoint& p : outline) {
    box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x),
           std::max(box.bottom, p.y)};
  }
  return box;
}

figure::PixelBox around(figure::PixelPoint centre, double size) {
  return figure::PixelBox{centre.x, centre.y, centre.x, centre.y}.grown(size / 2);
}

bool enters(const figure::Primitive& primitive, const figure::PixelBox& box) {
  if (const auto* line = std::get_if<figure::Polyline>(&primitive)) {
    return layout::enters(line->points, box.grown(line->width / 2));
  }
  if (const auto* polygon = std::get_if<figure::Polygon>(&primitive)) {
    return figure::overlap_area(around(polygon->outline), box) > 0;
  }
  if (const auto* markers = std::get_if<figure::Markers>(&primitive)) {
    return std::any_of(markers->centres.begin(), markers->centres.end(), [&](figure::PixelPoint c) {
      return figure::overlap_area(around(c, markers->size), box) > 0;
    });
  }
  return false;
}

/// The grounds that are painted below texts, each with its place in the list.
struct Ground {
  figure::PixelBox box;
  std::size_t painted{};
};

std::vector<Ground> grounds_of(const figure::DrawList& list) {
  std::vector<Ground> out;
  for (std::size_t i = 0; i < list.primitives.size(); ++i) {
    const figure::Role role = figure::owner_of(list.primitives[i]).role;
    if (role != figure::Role::text_backing && role != figure::Role::legend_box &&
        role != figure::Role::block_fill)
      continue;
    // In scenes the backing is the text itself, in white and moved a little each way.
    if (const auto* polygon = std::get_if<figure::Polygon>(&list.primitives[i])) {
      out.push_back({around(polygon->outline), i});
    } else if (const auto* run = std::get_if<figure::TextRun>(&list.primitives[i])) {
      out.push_back({run->box.grown(run->size * 0.25), i});
    }
  }
  return out;
}

bool is_backed(const ShownText& text, std::size_t data_painted,
               const std::vector<Ground>& grounds) {
  return std::any_of(grounds.begin(), grounds.end(), [&](const Ground& one) {
    return one.painted > data_painted && one.painted < text.painted &&
           figure::overlap_area(one.box, text.box) > 0;
  });
}

Finding found(const ShownText& text, const std::string& what) {
  return {"the text '" + text.words + "' " + what, text.box};
}

}  // namespace

Findings overlapping_texts(const figure::DrawList& list) {
  Findings out;
  const auto all = texts_of(list);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      if (figure::overlap_area(all[i].box, all[j].box) <= touch_px2) continue;
      out.push_back(found(all[j], "lies over '" + all[i].words + "'"));
    }
  }
  return out;
}

Findings texts_off_the_picture(const figure::DrawList& list) {
  Findings out;
  const figure::PixelBox picture{0, 0, static_cast<double>(list.width),
                                 static_cast<double>(list.height)};
  for (const ShownText& one : texts_of(list)) {
    if (!picture.contains(one.box)) out.push_back(found(one, "leaves the picture"));
  }
  return out;
}

Findings texts_on_data(const figure::DrawList& list) {
  Findings out;
  const std::vector<Ground> grounds = grounds_of(list);
  for (const ShownText& text : texts_of(list)) {
    const figure::PixelBox letters = text.box.grown(-graze_px);
    for (std::size_t i = 0; i < list.primitives.size(); ++i) {
      const figure::Owner& owner = figure::owner_of(list.primitives[i]);
      if (!is_data(owner.role) || !enters(list.primitives[i], letters)) continue;
      if (i > text.painted) {
        out.push_back(found(text, "has " + named(owner) + " painted over it"));
      } else if (!is_backed(text, i, grounds)) {
        out.push_back(found(text, "lies on " + named(owner) + " without a backing"));
      }
    }
  }
  return out;
}

Findings markers_under_texts(const figure::DrawList& list) {
  Findings out;
  const std::vector<ShownText> texts = texts_of(list);
  for (std::size_t i = 0; i < list.primitives.size(); ++i) {
    const figure::Owner& owner = figure::owner_of(list.primitives[i]);
    const auto* markers = std::get_if<figure::Markers>(&list.primitives[i]);
    const auto* line = std::get_if<figure::Polyline>(&list.primitives[i]);
    const bool counts =
        (markers != nullptr && markers->centres.size() < cloud &&
         (owner.role == figure::Role::series_marker || owner.role == figure::Role::label_marker)) ||
        (line != nullptr && owner.role == figure::Role::error_bar);
    if (!counts) continue;
    for (const ShownText& text : texts) {
      if (text.owner.role == figure::Role::legend_text || text.painted < i) continue;
      bool hidden = false;
      if (line != nullptr) hidden = layout::enters(line->points, text.box);
      for (std::size_t k = 0; markers != nullptr && k < markers->centres.size(); ++k) {
        const figure::PixelBox core = around(markers->centres[k], visible_share * markers->size);
        hidden = hidden || figure::overlap_area(core, text.box) > touch_px2;
      }
      if (hidden) out.push_back(found(text, "hides " + named(owner)));
    }
  }
  return out;
}

Findings curves_under_labels(const figure::DrawList& list) {
  Findings out;
  for (const ShownText& text : texts_of(list)) {
    const figure::Role role = text.owner.role;
    if (role != figure::Role::label_text && role != figure::Role::reference_text) continue;
    const figure::PixelBox letters = text.box.grown(-graze_px);
    for (std::size_t i = 0; i < text.painted; ++i) {
      const auto* line = std::get_if<figure::Polyline>(&list.primitives[i]);
      if (line == nullptr || line->owner.role != figure::Role::series) continue;
      if (line->owner.panel != text.owner.panel) continue;
      if (layout::enters(line->points, letters)) {
        out.push_back(found(text, "hides " + named(line->owner)));
      }
    }
  }
  return out;
}

Findings data_under_legends(const figure::DrawList& list) {
  Findings out;
  for (std::size_t i = 0; i < list.primitives.size(); ++i) {
    const auto* legend = std::get_if<figure::Polygon>(&list.primitives[i]);
    if (legend == nullptr || legend->owner.role != figure::Role::legend_box) continue;
    const figure::PixelBox box = around(legend->outline);
    for (const figure::Primitive& other : list.primitives) {
      const figure::Owner& owner = figure::owner_of(other);
      if (!is_data(owner.role) || !enters(other, box)) continue;
      out.push_back({"the legend of panel " + std::to_string(legend->owner.panel + 1) + " hides " +
                         named(owner),
                     box});
    }
  }
  return out;
}

}  // namespace tribolog::render::legibility
