#include "render/example_figures.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace tribolog::render::examples {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// The same noise everywhere.
class Noise {
 public:
  double next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11U) / 4503599627370496.0 - 1.0;
  }

 private:
  unsigned long long state_{1};
};

figure::Figure with_panel(const char* id, figure::Panel panel) {
  figure::Figure figure;
  figure.id = id;
  figure.title = id;
  figure.panels.push_back(std::move(panel));
  return figure;
}

figure::Figure with_series(const char* id, std::vector<double> x, std::vector<double> y) {
  figure::Panel panel;
  panel.x.title = std::string("x");
  panel.y.title = std::string("y");
  panel.series.push_back(line(std::move(x), std::move(y)));
  return with_panel(id, panel);
}

}  // namespace

figure::Series line(std::vector<double> x, std::vector<double> y, const char* label) {
  figure::Series out;
  out.label = label;
  out.x = std::move(x);
  out.y = std::move(y);
  out.colour = figure::palette::blue;
  return out;
}

figure::Figure plain() { return with_series("plain", {0, 1, 2, 3}, {0, 1, 0.5, 2}); }

figure::Figure hysteresis() {
  figure::Panel panel;
  panel.x.title = "joint angle q [°]";
  panel.y.title = "driving torque T [N·m]";
  figure::Series loop = line({}, {}, "measured");
  for (int i = 0; i <= 4000; ++i) {
    const double phase = 2 * std::numbers::pi * i / 2000.0;
    loop.x.push_back(2 * std::cos(phase));
    loop.y.push_back(4 + 0.8 * std::tanh(2 * std::cos(phase - 0.5)));
  }
  loop.direction_arrows_at = {0.2, 0.45};
  figure::Series middle = line({-2, 2}, {3.9, 4.1}, "mid-line");
  middle.style = figure::LineStyle::dash;
  middle.colour = figure::palette::black;
  panel.series = {loop, middle};
  panel.point_labels = {{0, 4, "A"},       {0, 3.5, "B"},     {1.95, 4.60, "C"},
                        {1.93, 4.58, "D"}, {1.90, 4.62, "E"}, {-1.95, 3.3, "F"}};
  return with_panel("hysteresis", panel);
}

figure::Figure stacked() {
  figure::Figure figure;
  figure.id = "stacked";
  figure.title = "Motion and torque";
  figure.panels_share_x = true;
  for (const char* title : {"angle q [°]", "motor speed φ\u0307 [rad/s]", "torque T [N·m]"}) {
    figure::Panel panel;
    panel.x.title = "time t [s]";
    panel.y.title = title;
    figure::Series one = line({}, {});
    for (int i = 0; i < 2000; ++i) {
      one.x.push_back(i * 0.01);
      one.y.push_back(std::sin(i * 0.01));
    }
    panel.series.push_back(one);
    figure.panels.push_back(panel);
  }
  return figure;
}

figure::Figure many_curves(int count) {
  constexpr figure::Colour colours[] = {figure::palette::sky_blue, figure::palette::vermilion,
                                        figure::palette::green,    figure::palette::purple,
                                        figure::palette::orange,   figure::palette::blue};
  constexpr figure::LineStyle styles[] = {figure::LineStyle::solid, figure::LineStyle::dash,
                                          figure::LineStyle::dot, figure::LineStyle::dash_dot,
                                          figure::LineStyle::dash_dot_dot};
  constexpr figure::Marker markers[] = {figure::Marker::circle,   figure::Marker::square,
                                        figure::Marker::triangle, figure::Marker::diamond,
                                        figure::Marker::cross,    figure::Marker::plus};
  figure::Panel panel;
  panel.x.title = "motor speed φ\u0307 [rad/s]";
  panel.y.title = "error e_{Tf} [%]";
  for (int k = 0; k < count; ++k) {
    figure::Series one = line({}, {});
    one.label = "candidate mass " + std::to_string(k + 1);
    one.colour = colours[k % 6];
    one.style = styles[k % 5];
    one.marker = markers[k % 6];
    for (int i = -20; i <= 20; ++i) {
      one.x.push_back(15.0 * i);
      one.y.push_back((k - count / 2.0 + 0.5) * (i < 0 ? -1 : 1) + 0.2 * std::sin(i * k));
    }
    panel.series.push_back(one);
  }
  return with_panel("many-curves", panel);
}

figure::Figure noisy_sweep() {
  Noise noise;
  figure::Panel panel;
  panel.x.title = "joint angle q [°]";
  panel.y.title = "driving torque T [N·m]";
  figure::Series measured = line({}, {}, "measured");
  measured.colour = figure::palette::sky_blue;
  measured.width_px = 1.5;
  figure::Series fit = line({}, {}, "fit");
  fit.colour = figure::palette::black;
  for (int i = 0; i < 70'000; ++i) {
    const double q = -60 + 120.0 * i / 69'999;
    measured.x.push_back(q);
    measured.y.push_back(2 + 8 * std::cos((q - 7) / 57.3) + noise.next());
    if (i % 100 == 0) {
      fit.x.push_back(q);
      fit.y.push_back(2 + 8 * std::cos((q - 7) / 57.3));
    }
  }
  panel.series = {measured, fit};
  panel.bands = {{"95 % interval", {5, 9}, {4, 4}, {11, 11}}};
  panel.point_labels = {
      {9.1, 11, "largest T at 9.1°", figure::palette::black, figure::Marker::diamond}};
  panel.reference_lines = {
      {figure::ReferenceLine::Direction::vertical, 7, "q_{peak} = 7.00°", figure::palette::green},
      {figure::ReferenceLine::Direction::horizontal, 10, "T_{max}", figure::palette::vermilion}};
  panel.error_bars = {{-40, 7, 8.2}, {-20, 9, 9.9}};
  return with_panel("noisy-sweep", panel);
}

figure::Figure scene(double opening_deg) {
  figure::Scene scene;
  scene.camera.towards = {-0.5, 1, -0.4};
  scene.camera.opening_deg = opening_deg;
  scene.camera.margin = 0.1;
  scene.ground = figure::SceneGround{};
  scene.bodies.push_back(
      {"link", {0, 0, 0.2}, {0, 0, 1}, 0.15, 0.1, figure::palette::grey, 0.1, {0, 1, 0}});
  scene.bodies.push_back({"", {0, 0, 1}, {0.6, 0, 1.2}, 0.1, 0.05, figure::palette::orange, 0, {}});
  scene.drums.push_back({"joint", {0, 0, 1}, {0, 1, 0}, 0.13, 0.3, figure::palette::sky_blue});
  scene.arrows.push_back({"axis", {0, 0.2, 1}, {0, -0.6, 1}, 0.01, figure::palette::vermilion});
  scene.balls.push_back({"m_{3}", {0.4, 0, 1.13}, 0.04, figure::palette::purple, true});
  figure::SceneSector sector;
  sector.label = "q_{3}";
  sector.centre = {0, 0, 1};
  sector.normal = {0, -1, 0};
  sector.zero = {1, 0, 0};
  sector.radius_m = 0.8;
  sector.from_rad = -1;
  sector.to_rad = 0.7;
  sector.filled = true;
  scene.sectors.push_back(sector);
  scene.dimensions.push_back({"r_{3} = 600 mm", {0, 0, 1}, {0.6, 0, 1.2}, {0, 0, 0.4}});
  scene.lines.push_back(
      {"level", {{0, 0, 1}, {1, 0, 1}}, figure::palette::green, 2.5, figure::LineStyle::dash});
  scene.texts.push_back({"floor", {0.8, -0.8, 0}, figure::palette::black});
  figure::Figure figure;
  figure.id = opening_deg > 0 ? "scene-in-perspective" : "scene";
  figure.title = "A scene";
  figure.scene = std::move(scene);
  return figure;
}

std::vector<figure::Figure> nasty() {
  std::vector<figure::Figure> all;
  all.push_back(with_series("tiny-range", {0, 1, 2}, {1e-12, 2e-12, 1.5e-12}));
  all.push_back(with_series("huge-values", {0, 1, 2}, {1e250, -1e250, 3e249}));
  all.push_back(with_series("unix-time", {1.7e9, 1.7e9 + 5, 1.7e9 + 10}, {1, 2, 3}));
  all.push_back(with_series("fine-on-coarse", {0, 1, 2}, {1e9, 1e9 + 1e-6, 1e9 + 5e-7}));
  all.push_back(with_series("not-finite", {0, 1, nan, 3, 4, 5}, {0, inf, 2, nan, 1, 2}));
  all.push_back(with_series("one-point", {3}, {4}));
  all.push_back(with_series("constant", {0, 1, 2}, {5, 5, 5}));
  all.push_back(with_series("constant-zero", {0, 0, 0}, {0, 0, 0}));
  all.push_back(with_series("empty-series", {}, {}));
  all.push_back(with_panel("empty-panel", figure::Panel{}));
  all.push_back(figure::Figure{"no-panel", "Nothing at all", {}});

  figure::Figure long_texts = many_curves(12);
  long_texts.id = "long-texts";
  for (int i = 0; i < 12; ++i) long_texts.title += " a title that goes on and on";
  long_texts.panels[0].y.title = std::string(80, 'm') + " friction torque of the joint [N·m]";
  long_texts.panels[0].x.title = std::string(200, 'x');
  long_texts.panels[0].series[0].label = std::string(300, 'w');
  all.push_back(long_texts);

  figure::Figure logarithmic =
      with_series("logarithmic", {1, 10, 100, -5, 1000}, {1e-9, 1e-3, 0, 1, 1e4});
  logarithmic.panels[0].x.logarithmic = logarithmic.panels[0].y.logarithmic = true;
  all.push_back(logarithmic);

  figure::Figure both_ways = many_curves(9);
  both_ways.id = "both-ways";
  both_ways.panels[0].x.linear_within = 0.1;
  both_ways.panels[0].labels_at_ends = true;
  all.push_back(both_ways);

  figure::Figure hostile = plain();
  hostile.id = "hostile";
  hostile.title =
      "\xFF\xC0\xAF <b>&amp;\x1b[31m \xED\xA0\x80 \xF4\x90\x80\x80 _{} ^{ _{x \u4E2D\U0001F600";
  hostile.panels[0].series[0].label = "\u202Eright to left\u0000";
  hostile.panels[0].y.title = "σ_{0} θ\u0302^{2} q\u0307_{c} \u0307";
  hostile.panels[0].point_labels = {{1, 1, "\xC3"}, {2, 0.5, ""}};
  all.push_back(hostile);

  figure::Figure fixed = plain();
  fixed.id = "fixed-ends";
  fixed.panels[0].x.minimum = 5;
  fixed.panels[0].x.maximum = 1;
  fixed.panels[0].y.minimum = nan;
  all.push_back(fixed);

  figure::Figure small = stacked();
  small.id = "small";
  small.width_px = 400;
  small.height_px = 300;
  all.push_back(small);
  return all;
}

}  // namespace tribolog::render::examples
