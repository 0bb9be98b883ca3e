#include "render/scene/scene_geometry.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "base/error.h"
#include "render/composition/figure_layout.h"
#include "render/example_figures.h"
#include "render/figure/scene.h"
#include "wording/words.h"

namespace tribolog::render::scene_geometry_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr figure::PixelBox room{50, 100, 1550, 950};

figure::SceneCamera camera(double opening_deg) {
  figure::SceneCamera out;
  out.towards = {-0.4, 1, -0.3};
  out.opening_deg = opening_deg;
  return out;
}

std::vector<scene::Sphere> some_spheres() {
  return {{{0, 0, 0}, 0.3}, {{1, 0.5, 2}, 0.1}, {{-0.7, 1, 1}, 0.0}, {{0.2, -0.8, 0.4}, 0.2}};
}

/// From a point to the pixel, the way OpenGL goes.
figure::PixelPoint through_clip_space(const figure::SceneView& view, figure::Point3 p, int width,
                                      int top, int rows) {
  const figure::Point3 in_view = p - view.eye;
  const double eye[] = {figure::dot(in_view, view.right), figure::dot(in_view, view.up),
                        -figure::dot(in_view, view.forward), 1.0};
  const auto m = view.clip_matrix(width, top, rows);
  double clip[4] = {};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) clip[i] += m[4 * i + k] * eye[k];
  }
  EXPECT_LE(std::abs(clip[2] / clip[3]), 1.0) << "cut off in front or behind";
  return {(clip[0] / clip[3] + 1) / 2 * width, top + (1 - clip[1] / clip[3]) / 2 * rows};
}

TEST(SceneView, ShowsTheSamePlaceInEveryStrip) {
  for (const double opening : {0.0, 25.0, 80.0}) {
    const figure::SceneView view = scene::fit_view(camera(opening), some_spheres(), room);
    for (const scene::Sphere& one : some_spheres()) {
      const figure::PixelPoint pixel = view.pixel(one.centre);
      for (const auto& [top, rows] : {std::pair{0, 512}, {512, 512}, {300, 77}, {0, 1000}}) {
        const figure::PixelPoint found = through_clip_space(view, one.centre, 1600, top, rows);
        EXPECT_NEAR(found.x, pixel.x, 1e-8);
        EXPECT_NEAR(found.y, pixel.y, 1e-8);
      }
    }
  }
}

TEST(SceneView, FitsWhatItShowsIntoTheRoom) {
  for (const double opening : {0.0, 25.0, 80.0}) {
    const figure::SceneView view = scene::fit_view(camera(opening), some_spheres(), room);
    figure::PixelBox reached{1e9, 1e9, -1e9, -1e9};
    for (const scene::Sphere& one : some_spheres()) {
      const figure::PixelPoint p = view.pixel(one.centre);
      const double radius = one.radius_m / view.metres_per_pixel(one.centre);
      reached = {std::min(reached.left, p.x - radius), std::min(reached.top, p.y - radius),
                 std::max(reached.right, p.x + radius), std::max(reached.bottom, p.y + radius)};
    }
    EXPECT_TRUE(room.grown(1e-6).contains(reached));
    const double filled =
        std::max(reached.width() / room.width(), reached.height() / room.height());
    EXPECT_NEAR(filled, 1.0, 1e-9) << "as large as it can be";
  }
}

TEST(SceneView, KeepsRightHandedAxesRightHanded) {
  const figure::SceneView view = scene::fit_view(camera(0), some_spheres(), room);
  EXPECT_NEAR(figure::dot(figure::cross(view.right, view.up), view.forward), -1.0, 1e-12);
  const figure::PixelPoint o = view.pixel({0, 0, 0});
  EXPECT_GT(view.pixel({1, 0, 0}).x, o.x) << "seen along y, x points to the right";
  EXPECT_LT(view.pixel({0, 0, 1}).y, o.y) << "z points up";
  EXPECT_GT(view.distance({0, 1, 0}), view.distance({0, 0, 0})) << "y points away";
}

TEST(SceneView, RefusesACameraThatSeesNothing) {
  figure::SceneCamera bad = camera(0);
  bad.up = -2.0 * bad.towards;
  EXPECT_THROW(scene::fit_view(bad, some_spheres(), room), FigureError);
  EXPECT_THROW(scene::fit_view(camera(90), some_spheres(), room), FigureError);
  EXPECT_THROW(scene::fit_view(camera(0), {{{1, 1, 1}, 0.0}}, room), FigureError);
  EXPECT_THROW(scene::fit_view(camera(0), {{{std::nan(""), 1, 1}, 1.0}}, room), FigureError);
}

/// By the divergence theorem: right only if the surface is closed and every triangle faces
/// outwards.
double volume(const figure::SceneMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += figure::dot(mesh.points[a], figure::cross(mesh.points[b], mesh.points[c])) / 6;
  }
  return sum;
}

figure::SceneMesh only_mesh(const figure::Scene& scene) {
  const figure::SceneView view = scene::fit_view(camera(0), some_spheres(), room);
  return scene::part_meshes(scene, view, 1.0).at(0);
}

TEST(PartMeshes, EncloseTheVolumeOfTheirShapes) {
  constexpr double facets = 0.01;  // 64 sides of a circle lose 0.2 % of its area, round ends more
  const double r = 0.2;
  const double ball = 4.0 / 3.0 * pi * r * r * r;
  figure::Scene scene;
  scene.balls.push_back({"", {1, 2, 3}, r, figure::palette::grey, false});
  EXPECT_NEAR(volume(only_mesh(scene)) / ball, 1.0, facets);

  scene = {};
  scene.bodies.push_back({"", {0, 0, 0}, {1, 2, 2}, r, r, figure::palette::grey, 0, {}});
  EXPECT_NEAR(volume(only_mesh(scene)) / (ball + pi * r * r * 3), 1.0, facets);

  scene = {};
  scene.bodies.push_back({"", {0, 0, 0}, {0, 0, 2}, r, r, figure::palette::grey, 0.1, {0, 1, 0}});
  EXPECT_NEAR(volume(only_mesh(scene)) / (0.1 * (pi * r * r + 2 * r * 2)), 1.0, facets);

  scene = {};
  scene.drums.push_back({"", {1, 1, 1}, {0, 3, 4}, r, 0.5, figure::palette::grey});
  const double cylinder = pi * r * r * 0.5;
  EXPECT_LT(volume(only_mesh(scene)), cylinder);
  EXPECT_GT(volume(only_mesh(scene)), 0.96 * cylinder) << "a chamfer takes a few percent";
}

TEST(PartMap, ShowsWhatIsNearest) {
  figure::Scene scene;
  scene.balls.push_back({"", {0, 0, 0}, 0.5, figure::palette::grey, false});
  scene.balls.push_back({"", {0, -2, 0}, 0.2, figure::palette::grey, false});
  for (const double opening : {0.0, 30.0}) {
    figure::SceneCamera along_y;
    along_y.opening_deg = opening;
    figure::SceneGeometry geometry;
    geometry.view = scene::fit_view(along_y, scene::reach_of(scene), {0, 0, 200, 200});
    geometry.meshes = scene::part_meshes(scene, geometry.view, 1.0);
    const scene::PartMap map(geometry, 200, 200);
    EXPECT_EQ(map.at(100, 100), 2);
    EXPECT_EQ(map.at(100, 20), 1);
    EXPECT_EQ(map.at(2, 2), 0);
  }
}

std::vector<figure::PixelBox> label_boxes(const figure::DrawList& list) {
  std::vector<figure::PixelBox> boxes;
  for (const figure::Primitive& primitive : list.primitives) {
    const auto* run = std::get_if<figure::TextRun>(&primitive);
    if (run == nullptr || run->owner.role != figure::Role::label_text) continue;
    const auto index = static_cast<std::size_t>(run->owner.index);
    boxes.resize(std::max(boxes.size(), index + 1), {1e9, 1e9, -1e9, -1e9});
    figure::PixelBox& box = boxes[index];
    box = {std::min(box.left, run->box.left), std::min(box.top, run->box.top),
           std::max(box.right, run->box.right), std::max(box.bottom, run->box.bottom)};
  }
  return boxes;
}

TEST(SceneLayout, KeepsTextsApartAndInsideThePicture) {
  const text::Font font;
  for (const double opening : {0.0, 30.0}) {
    for (const int width : {1600, 800}) {
      figure::Figure figure = examples::scene(opening);
      figure.height_px = figure.height_px * width / figure.width_px;
      figure.width_px = width;
      const figure::DrawList list = composition::lay_out(figure, font);
      EXPECT_TRUE(list.warnings.empty()) << wording::words(list.warnings[0]);
      const auto boxes = label_boxes(list);
      EXPECT_EQ(boxes.size(), 8U);
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_TRUE(
            (figure::PixelBox{0, 0, list.width * 1.0, list.height * 1.0}).contains(boxes[i]));
        for (std::size_t k = 0; k < i; ++k)
          EXPECT_EQ(figure::overlap_area(boxes[i], boxes[k]), 0.0);
      }
    }
  }
}

TEST(SceneLayout, WarnsOfTextsWithoutRoom) {
  figure::Figure figure = examples::scene();
  figure.width_px = figure.height_px = 200;
  for (int i = 0; i < 30; ++i)
    figure.scene->texts.push_back({"a long text of many", {0, 0, 1}, {}});
  const figure::DrawList list = composition::lay_out(figure, text::Font());
  ASSERT_FALSE(list.warnings.empty());
  EXPECT_TRUE(list.warnings.back().is("drawing.no_room_between"))
      << wording::words(list.warnings.back());
}

TEST(SceneLayout, RefusesWhatItCannotShow) {
  const text::Font font;
  figure::Figure figure = examples::scene();
  figure.panels.resize(1);
  EXPECT_THROW(composition::lay_out(figure, font), FigureError);
  figure = examples::scene();
  figure.scene->drums[0].axis = {};
  EXPECT_THROW(composition::lay_out(figure, font), FigureError);
  figure.scene = figure::Scene{};
  EXPECT_THROW(composition::lay_out(figure, font), FigureError);
}

}  // namespace
}  // namespace tribolog::render::scene_geometry_test
