#include "render/check/picture_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "render/check/visibility_map.h"
#include "render/figure/draw_list.h"
#include "render/figure/figure.h"
#include "render/figure/picture.h"
#include "render/layout/occupancy.h"
#include "render/scene/annotations.h"
#include "render/scene/scene_geometry.h"

namespace tribolog::render::check {
namespace {

// Whether a picture shows the solid parts of its scene.

constexpr std::size_t least_visible_px = 30;  // for a picture of any size: a dot
constexpr double least_part_share = 0.5;      // of the pixels that must show a part
constexpr double darkest_shade = 0.2;         // of a part's colour
constexpr double most_part_hue_error = 40;    // of 255
constexpr int edge_px = 4;                    // outlines and antialiasing reach that far

/// Whether a pixel is the colour in some light.
bool shows_shaded(figure::Colour pixel, figure::Colour colour) {
  const double wanted[] = {colour.red + 1.0, colour.green + 1.0, colour.blue + 1.0};
  const double found[] = {pixel.red + 1.0, pixel.green + 1.0, pixel.blue + 1.0};
  double across = 0;
  double along = 0;
  for (int i = 0; i < 3; ++i) {
    across += wanted[i] * found[i];
    along += wanted[i] * wanted[i];
  }
  const double light = across / along;
  if (light < darkest_shade) return false;
  double error = 0;
  for (int i = 0; i < 3; ++i) error = std::max(error, std::abs(found[i] - light * wanted[i]));
  return error <= most_part_hue_error;
}

struct Count {
  std::size_t visible{};  ///< Pixels of the part that no other part hides.
  std::size_t expected{};
  std::size_t found{};
};

/// Adds an error about the first part with a label that the picture does not show where it must,
/// and a warning about each that is hidden by others. Light and shade change how bright a part is,
/// not its hue.
/// @pre the list has a scene
void check_parts(const figure::DrawList& list, const figure::Picture& picture,
                 PictureFindings& findings) {
  if (!list.scene) return;
  const auto& meshes = list.scene->meshes;
  const scene::PartMap parts(*list.scene, list.width, list.height);
  const figure::PixelBox whole{0, 0, static_cast<double>(list.width),
                               static_cast<double>(list.height)};
  layout::Occupancy drawn_over(whole);
  for (const figure::Primitive& primitive : list.primitives) drawn_over.mark(primitive);
  std::vector<Count> counts(meshes.size());
  for (int y = 0; y < list.height; ++y) {
    for (int x = 0; x < list.width; ++x) {
      const std::uint16_t number = parts.at(x, y);
      if (number == 0 || meshes[number - 1U].label.empty()) continue;
      Count& count = counts[number - 1U];
      ++count.visible;
      if (!parts.inside(x, y, edge_px)) continue;
      if (drawn_over.taken({x + 0.0, y + 0.0, x + 1.0, y + 1.0}) > 0) continue;
      ++count.expected;
      if (shows_shaded(picture.at(x, y), meshes[number - 1U].colour)) ++count.found;
    }
  }
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (meshes[i].label.empty()) continue;
    const Statement name = figure::name_of_part(meshes[i].label);
    if (counts[i].visible < least_visible_px) {
      findings.warnings.push_back({"drawing.part_hidden", {{"part", name}}});
    } else if (static_cast<double>(counts[i].found) <
               least_part_share * static_cast<double>(counts[i].expected)) {
      findings.error = {
          "drawing.not_visible",
          {{"what", name}, {"found", counts[i].found}, {"expected", counts[i].expected}}};
      return;
    }
  }
}

// Whether it shows series and bands, blocks and wires, and texts.

constexpr int least_contrast = 16;            // of 255, in the strongest channel
constexpr double least_tint = 0.4;            // of the way from the background to the colour
constexpr double most_series_hue_error = 48;  // of 255
constexpr double least_series_share = 0.5;    // of the pixels that must show a series
constexpr std::size_t least_series_px = 8;    // of a series of which others leave less to see
constexpr double white = 255.0;

struct Ink {
  double red, green, blue;
  [[nodiscard]] double dot(const Ink& other) const {
    return red * other.red + green * other.green + blue * other.blue;
  }
};

/// How far a colour darkens white paper.
Ink ink_of(figure::Colour colour) {
  const double cover = colour.alpha / 255.0;
  return {(white - colour.red) * cover, (white - colour.green) * cover,
          (white - colour.blue) * cover};
}

bool shows(figure::Colour pixel, figure::Colour colour) {
  const Ink wanted = ink_of(colour);
  const Ink found = ink_of(pixel);
  const double tint = found.dot(wanted) / wanted.dot(wanted);
  if (tint < least_tint) return false;
  if (colour.alpha < 255) return true;  // what lies below shows through
  const double error = std::max({std::abs(found.red - tint * wanted.red),
                                 std::abs(found.green - tint * wanted.green),
                                 std::abs(found.blue - tint * wanted.blue)});
  return error <= most_series_hue_error;
}

bool contrasts(figure::Colour colour) {
  const Ink ink = ink_of(colour);
  return std::max({ink.red, ink.green, ink.blue}) >= least_contrast;
}

/// A series without a label continues the labelled one before it that looks the same: a curve that
/// is interrupted.
std::string label_of(const figure::Figure& figure, const figure::Owner& owner) {
  const figure::Panel& panel = figure.panels[static_cast<std::size_t>(owner.panel)];
  const auto index = static_cast<std::size_t>(owner.index);
  if (owner.role == figure::Role::band) return panel.bands[index].label;
  const figure::Series& own = panel.series[index];
  for (std::size_t i = index + 1; i-- > 0;) {
    const figure::Series& one = panel.series[i];
    const bool alike =
        one.colour == own.colour && one.style == own.style && one.marker == own.marker;
    if (alike && !one.label.empty()) return one.label;
  }
  return {};
}

Statement name_of_line(const figure::Scene& scene, std::size_t index) {
  const std::string text = scene::annotation_labels(scene)[index];
  if (text.empty()) return {"drawing.line_numbered", {{"number", index + 1}}};
  return {"drawing.line_labelled", {{"label", text}}};
}

Statement name_of(const figure::Figure& figure, const figure::Owner& owner) {
  const auto index = static_cast<std::size_t>(owner.index);
  if (figure.diagram && owner.role == figure::Role::wire) return figure::name_of_wire(index);
  if (figure.diagram && owner.role == figure::Role::block) {
    return figure::name_of_block(*figure.diagram, index);
  }
  if (figure.scene && owner.role == figure::Role::scene_line) {
    return name_of_line(*figure.scene, index);
  }
  const bool is_band = owner.role == figure::Role::band;
  const std::string label = label_of(figure, owner);
  if (!label.empty()) {
    if (is_band) return {"drawing.band_labelled", {{"label", label}}};
    return figure::name_of_series(label, index);
  }
  const bool is_only_panel = figure.panels.size() == 1;
  const StatedValue number{"number", index + 1};
  const StatedValue panel{"panel", owner.panel + 1};
  if (is_band && is_only_panel) return {"drawing.band_numbered", {number}};
  if (is_band) return {"drawing.band_of_panel", {number, panel}};
  if (is_only_panel) return figure::name_of_series({}, index);
  return {"drawing.series_of_panel", {number, panel}};
}

bool is_blank(const figure::Picture& picture) {
  const auto& rgb = picture.rgb;
  for (std::size_t i = 3; i < rgb.size(); i += 3) {
    if (rgb[i] != rgb[0] || rgb[i + 1] != rgb[1] || rgb[i + 2] != rgb[2]) return false;
  }
  return true;
}

bool has_ink(const figure::TextRun& run, const figure::Picture& picture) {
  if (run.text.find_first_not_of(' ') == std::string::npos) return true;
  const int left = std::max(0, static_cast<int>(run.box.left) - 1);
  const int right = std::min(picture.width - 1, static_cast<int>(run.box.right) + 1);
  const int top = std::max(0, static_cast<int>(run.box.top) - 1);
  const int bottom = std::min(picture.height - 1, static_cast<int>(run.box.bottom) + 1);
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      if (shows(picture.at(x, y), run.colour)) return true;
    }
  }
  return left > right || top > bottom;  // wholly outside: nothing to see, and reported elsewhere
}

void check_series(const figure::DrawList& list, const figure::Figure& figure,
                  const figure::Picture& picture, PictureFindings& findings) {
  const VisibilityMap map(list);
  const auto& subjects = map.subjects();
  std::vector<std::size_t> expected(subjects.size());
  std::vector<std::size_t> found(subjects.size());
  for (std::size_t i = 0; i < map.size(); ++i) {
    const std::uint16_t number = map.at(i);
    if (number == 0) continue;
    const figure::Colour pixel{picture.rgb[3 * i], picture.rgb[3 * i + 1], picture.rgb[3 * i + 2]};
    ++expected[number - 1U];
    if (shows(pixel, subjects[number - 1U].colour)) ++found[number - 1U];
  }
  // What is hidden in one panel may be seen in another, such as a close-up.
  std::vector<std::pair<Statement, figure::Colour>> seen;
  const auto curve = [&](const VisibilityMap::Subject& one) {
    const figure::Colour& c = one.colour;
    return std::pair(name_of(figure, one.owner), figure::Colour{c.red, c.green, c.blue});
  };
  const auto is_shown = [&](std::size_t i) {
    return static_cast<double>(found[i]) >= least_series_share * static_cast<double>(expected[i]);
  };
  const auto is_hidden = [&](std::size_t i) {
    return expected[i] == 0 || (expected[i] < least_series_px && !is_shown(i));
  };
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    if (!is_hidden(i)) seen.push_back(curve(subjects[i]));
  }
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const Statement name = name_of(figure, subjects[i].owner);
    if (!contrasts(subjects[i].colour)) {
      findings.error = {"drawing.no_contrast", {{"what", name}}};
    } else if (is_hidden(i) && subjects[i].painted > 0) {
      if (std::find(seen.begin(), seen.end(), curve(subjects[i])) != seen.end()) continue;
      seen.push_back(curve(subjects[i]));
      findings.warnings.push_back({"drawing.hidden", {{"what", name}}});
    } else if (!is_shown(i)) {
      findings.error = {"drawing.not_visible",
                        {{"what", name}, {"found", found[i]}, {"expected", expected[i]}}};
    }
    if (!findings.error.empty()) return;
  }
}

/// A series with samples of which none made it into the draw list.
void report_outside(const figure::DrawList& list, const figure::Figure& figure,
                    PictureFindings& findings) {
  const auto is_drawn = [&](const figure::Owner& wanted) {
    return std::any_of(list.primitives.begin(), list.primitives.end(),
                       [&](const figure::Primitive& one) {
                         figure::Owner owner = figure::owner_of(one);
                         if (owner.role == figure::Role::series_marker)
                           owner.role = figure::Role::series;
                         return owner == wanted;
                       });
  };
  if (figure.diagram) return;  // the layout itself reports what lies outside of the canvas
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    const figure::Panel& panel = figure.panels[p];
    for (std::size_t s = 0; s < panel.series.size(); ++s) {
      const figure::Series& series = panel.series[s];
      const bool asked =
          series.style != figure::LineStyle::none || series.marker != figure::Marker::none;
      const figure::Owner owner{figure::Role::series, static_cast<int>(p), static_cast<int>(s)};
      const bool has_samples =
          std::any_of(series.y.begin(), series.y.end(), [](double y) { return std::isfinite(y); });
      if (asked && has_samples && !series.is_marked_at_edge && !is_drawn(owner)) {
        findings.warnings.push_back({"drawing.outside_axes", {{"what", name_of(figure, owner)}}});
      }
    }
  }
}

}  // namespace

PictureFindings check_picture(const figure::DrawList& list, const figure::Figure& figure,
                              const figure::Picture& picture) {
  PictureFindings findings;
  if (!list.primitives.empty() && is_blank(picture)) {
    findings.error = {"drawing.blank"};
    return findings;
  }
  report_outside(list, figure, findings);
  check_series(list, figure, picture, findings);
  if (findings.error.empty() && list.scene) check_parts(list, picture, findings);
  if (!findings.error.empty()) return findings;
  for (const figure::Primitive& primitive : list.primitives) {
    const auto* run = std::get_if<figure::TextRun>(&primitive);
    if (run != nullptr && contrasts(run->colour) && !has_ink(*run, picture)) {
      findings.error = {"drawing.text_missing", {{"text", figure::name_of_text(run->text)}}};
      return findings;
    }
  }
  return findings;
}

}  // namespace tribolog::render::check
