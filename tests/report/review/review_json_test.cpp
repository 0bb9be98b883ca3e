// The viewer's data against the calibration that they come from and the report around them.

#include "report/viewer/review_json.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "identify/identify.h"
#include "report/document/html_report.h"
#include "report/document_checks.h"
#include "report/engine/page_style.h"
#include "report/sample_calibration.h"
#include "support/paper_joint.h"

namespace tribolog::test::review_json_test {
namespace {

using Json = nlohmann::json;

constexpr double six_digits = 5e-6;  // rounding to six significant digits, relative

const calibration::Calibration& noisy_joint() {
  static const calibration::Calibration calibration =
      identify::identify(simulate::simulated_dataset(noisy_paper_joint(3)));
  return calibration;
}

Json data_of(const calibration::Calibration& calibration) {
  return Json::parse(report::viewer::review_json(calibration, {"tribolog-1"}));
}

void expect_digits(const Json& shown, double si, double factor) {
  ASSERT_TRUE(shown.is_number());
  EXPECT_NEAR(shown.get<double>(), si * factor, six_digits * std::abs(si * factor) + 1e-300);
}

double factor_of(const Json& data, const std::string& name) {
  const std::string unit = data["quantities"][name]["unit"];
  if (unit.rfind("µ", 0) == 0) return 1e6;
  return unit.front() == 'm' ? 1e3 : 1.0;
}

/// As it stands in a table.
std::string cell_of(const std::string& text) {
  return std::string(1, '>').append(text).append(1, '<');
}

TEST(ReviewJson, ALoopsColumnsAreSamplesOfTheTrace) {
  const method::hysteresis::LoopTrace& trace = noisy_joint().curves.loops.front();
  const Json data = data_of(noisy_joint());
  ASSERT_EQ(data["loops"].size(), 1U);
  const Json& loop = data["loops"][0];
  const std::size_t kept = loop["t"].size();
  EXPECT_LE(kept, report::viewer::most_loop_samples);
  EXPECT_GT(kept, report::viewer::most_loop_samples / 2);
  EXPECT_EQ(loop["samples"], trace.t_s.size());
  const double centre = noisy_joint().hysteresis.oscillations.front().centre_rad;
  for (const char* name : {"q", "T", "z", "dz", "fit"}) ASSERT_EQ(loop[name].size(), kept) << name;
  std::size_t at = 0;
  for (std::size_t i = 0; i < kept; ++i) {
    const double t = loop["t"][i].get<double>() + trace.t_s.front();
    while (trace.t_s[at] < t - 1e-6) ++at;
    ASSERT_NEAR(trace.t_s[at], t, 1e-4) << i;
    expect_digits(loop["T"][i], trace.torque_Nm[at], factor_of(data, "T"));
    expect_digits(loop["q"][i], trace.q_rad[at] - centre, factor_of(data, "q"));
    expect_digits(loop["z"][i], trace.z_rad[at], factor_of(data, "z"));
    expect_digits(loop["dz"][i], trace.dz_rad_s[at], factor_of(data, "dz"));
    expect_digits(loop["fit"][i], trace.model_torque_Nm[at], factor_of(data, "T"));
  }
}

TEST(ReviewJson, ExtremesStay) {
  const method::hysteresis::LoopTrace& trace = noisy_joint().curves.loops.front();
  const Json data = data_of(noisy_joint());
  const auto extremes = [&](const std::vector<double>& signal, const char* name) {
    const auto shown = data["loops"][0][name].get<std::vector<double>>();
    const auto [low, high] = std::minmax_element(signal.begin(), signal.end());
    expect_digits(*std::min_element(shown.begin(), shown.end()), *low, factor_of(data, name));
    expect_digits(*std::max_element(shown.begin(), shown.end()), *high, factor_of(data, name));
  };
  extremes(trace.torque_Nm, "T");
  extremes(trace.z_rad, "z");
  extremes(trace.dz_rad_s, "dz");
}

TEST(ReviewJson, PointsAndMidlineAreThoseOfTheTables) {
  const method::hysteresis::HysteresisResult& h = noisy_joint().hysteresis;
  const Json data = data_of(noisy_joint());
  const std::string page = report_of(noisy_joint());
  const std::string tables = page.substr(0, page.find("<script type"));
  for (const auto& [name, points] : {std::pair{"first", &h.points}, {"steady", &h.steady_points}}) {
    ASSERT_EQ(data["points"][name].size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
      const Json& point = data["points"][name][i];
      EXPECT_EQ(point["name"], to_string((*points)[i].name));
      expect_digits(point["T"], (*points)[i].torque_Nm, factor_of(data, "T"));
      for (const Json& text : point["texts"]) {
        const std::string shown = text[1];
        const std::string number = shown.substr(0, shown.find("\u00a0"));
        EXPECT_NE(tables.find(number.substr(0, number.find("°"))), std::string::npos) << shown;
      }
    }
  }
  expect_digits(data["midline"]["T"], h.midline_Nm->value, factor_of(data, "T"));
  EXPECT_NE(tables.find(data["midline"]["text"].get<std::string>().substr(0, 7)),
            std::string::npos);
}

TEST(ReviewJson, CandidatesHaveTheirCurvesErrorsAndTheTablesTexts) {
  const calibration::Calibration& c = noisy_joint();
  const Json data = data_of(c);
  const std::string page = report_of(c);
  const std::string tables = page.substr(0, page.find("<script type"));
  ASSERT_EQ(data["candidates"].size(), c.masses.masses.size());
  std::size_t recommended = 0;
  for (const Json& one : data["candidates"]) {
    const std::string name = one["name"];
    const auto estimator = method::hysteresis::estimator_of(name);
    const method::viscous::ViscousCurve* curve = c.viscous.find(estimator);
    const method::selection::QualityError* error = c.quality.find(estimator);
    ASSERT_TRUE(curve && error) << name;
    for (std::size_t i = 0; i < c.viscous.runs.size(); ++i) {
      expect_digits(one["f"][i], curve->friction_Nm[i], factor_of(data, "f"));
      expect_digits(one["e"][i], error->percent[i], 1.0);
    }
    const std::string mass = one["mass"];
    EXPECT_NE(tables.find(cell_of(mass.substr(0, mass.find("\u00a0")))), std::string::npos) << mass;
    EXPECT_NE(tables.find(cell_of(one["rms"])), std::string::npos) << name;
    recommended += one["recommended"].get<bool>() ? 1 : 0;
  }
  EXPECT_EQ(recommended, 1U);
  EXPECT_EQ(data["runs"]["w"].size(), c.viscous.runs.size());
}

TEST(ReviewJson, ManyLoopsShareTheRoom) {
  calibration::Calibration c = noisy_joint();
  method::hysteresis::HysteresisResult& h = c.hysteresis;
  for (int k = 0; k < 19; ++k) {
    c.curves.loops.push_back(c.curves.loops.front());
    c.curves.loops.back().model_torque_Nm.clear();
    h.oscillations.push_back(h.oscillations.front());
  }
  const Json data = data_of(c);
  ASSERT_EQ(data["loops"].size(), 20U);
  std::set<std::pair<std::string, std::string>> looks;
  for (const Json& loop : data["loops"]) {
    EXPECT_LE(loop["t"].size(), 5 * report::viewer::most_loop_samples / 20);
    looks.emplace(loop["style"]["colour"].get<std::string>(),
                  loop["style"]["line"].get<std::string>());
  }
  EXPECT_EQ(looks.size(), 20U);  // colour and dash together tell all of them apart
  EXPECT_FALSE(data["loops"][5].contains("fit"));  // fitted loops are those of the fit alone
}

TEST(ReviewJson, WithoutBristleThereIsNoneAndWithoutDataNoViewer) {
  calibration::Calibration c = noisy_joint();
  c.curves.loops.front().model_torque_Nm.clear();
  c.hysteresis.points.clear();
  c.hysteresis.steady_points.clear();
  c.curves.loops.front().z_rad.clear();
  c.curves.loops.front().dz_rad_s.clear();
  const Json loop = data_of(c)["loops"][0];
  for (const char* name : {"z", "dz", "fit"}) EXPECT_FALSE(loop.contains(name)) << name;
  EXPECT_TRUE(data_of(c)["points"]["first"].empty());

  EXPECT_EQ(report::viewer::review_json(calibration::Calibration{}), "");
  const std::string page = report_of(calibration::Calibration{});
  EXPECT_EQ(page.find("script-src"), std::string::npos);
  EXPECT_EQ(page.find("id=\"review\""), std::string::npos);
}

TEST(ReviewJson, TheCalibrationBeforeLiesOverLoopsAndRuns) {
  EXPECT_FALSE(data_of(noisy_joint()).contains("earlier"));
  calibration::RecordedCurves before;
  before.loops.push_back({0.1, {0, 1e-4, 0, -1e-4}, {4.0, 4.5, 3.5, 3.0}});
  before.friction.speed_rad_s = {2, -1, 1};
  before.friction.friction_Nm = {0.5, -0.7, 0.6};
  const auto shown = [&] {
    return Json::parse(
        report::viewer::review_json(noisy_joint(), {"tribolog-1", &before, "2025-12-01"}));
  };
  const Json data = shown();
  const Json& earlier = data["earlier"];
  EXPECT_EQ(earlier["words"], "calibration of 2025-12-01");
  // From the largest angle, and closed.
  const double angle = factor_of(data, "q");
  ASSERT_EQ(earlier["loops"].size(), 1U);
  EXPECT_EQ(earlier["loops"][0]["q"], Json({angle * 1e-4, 0, -angle * 1e-4, 0, angle * 1e-4}));
  EXPECT_EQ(earlier["loops"][0]["T"], Json({4.5, 3.5, 3.0, 4.0, 4.5}));
  EXPECT_EQ(earlier["w"], Json({-1, 1, 2}));
  EXPECT_EQ(earlier["f"], Json({-0.7, 0.6, 0.5}));
  before.torque_unit = joint::TorqueUnit::ampere;
  EXPECT_FALSE(shown().contains("earlier"));
}

TEST(ReviewJson, NumbersThatAreNotFiniteAreNull) {
  calibration::Calibration c = noisy_joint();
  c.curves.loops.front().torque_Nm[0] = std::nan("");
  c.quality.errors.front().percent[0] = INFINITY;
  const Json data = data_of(c);
  EXPECT_TRUE(data["loops"][0]["T"][0].is_null());
  EXPECT_TRUE(data["candidates"][0]["e"][0].is_null());
}

TEST(ReviewJson, TextsOfStrangersAreMadeVisible) {
  calibration::Calibration c = noisy_joint();
  c.curves.loops.front().recording = hostile;
  c.viscous.runs.front().recording = hostile;
  const std::string json = report::viewer::review_json(c);
  EXPECT_EQ(json.find("\u202E"), std::string::npos);
  const std::string name = Json::parse(json)["loops"][0]["name"];
  EXPECT_NE(name.find("[U+202E]"), std::string::npos);
  EXPECT_EQ(occurrences(report_of(c), "<script"), 3U);
}

TEST(ReviewScript, ReachesForNothingAndStaysSmall) {
  const std::string& script = report::engine::own_script();
  for (const char* word : {"eval", "Function(", "innerHTML", "outerHTML", "insertAdjacent", "fetch",
                           "XMLHttp", "import", "http:", "https:", "localStorage", "\"style\"",
                           "document.write", "</script", "<!--", "setTimeout(\""}) {
    std::string text = script;
    const std::string name_space = "\"http://www.w3.org/2000/svg\"";
    text.erase(text.find(name_space), name_space.size());
    EXPECT_EQ(text.find(word), std::string::npos) << word;
  }
  EXPECT_LT(script.size() + report::engine::own_style(report::engine::PageKind::with_viewer).size(),
            92000U);
}

}  // namespace
}  // namespace tribolog::test::review_json_test
