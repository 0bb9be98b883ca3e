#include "report/sample_calibration.h"

#include <cmath>
#include <limits>

#include "report/document/html_report.h"

namespace tribolog::test {
namespace {

using method::hysteresis::Estimator;
using method::hysteresis::LuGreParameterName;

constexpr double gear_ratio = 100.0;
constexpr double q_peak_rad = -0.388019;
constexpr double gravity_Nm = 3.88318571;
constexpr double kg_per_Nm = gear_ratio / (9.81 * 0.5);

method::gravity::CogSweepResult sweep(const std::string& name, double half_width_rad) {
  method::gravity::CogSweepResult r;
  r.stage = {name, statistics::StageState::done, {}};
  r.found = true;
  r.method = Statement::verbatim("T = offset of each direction + G cos(q - q_peak)");
  r.argmax_rad = -0.3885;
  r.argmax_low_rad = -0.41;
  r.argmax_high_rad = -0.37;
  r.argmax_torque_Nm = 4.77;
  r.q_peak_rad = statistics::symmetric_estimate(q_peak_rad, half_width_rad,
                                                Statement::verbatim("least squares"));
  r.gravity_Nm =
      statistics::symmetric_estimate(gravity_Nm, 0.0043, Statement::verbatim("least squares"));
  r.coulomb_Nm =
      statistics::symmetric_estimate(0.8829, 0.0031, Statement::verbatim("least squares"));
  r.offset_Nm = 0.0012;
  r.residual_Nm = 0.0204;
  r.lowest_rad = -1.39;
  r.highest_rad = 1.04;
  r.both_directions = true;
  r.constant_speed = true;
  r.samples_used = 135000;
  r.samples_left_out = 4210;
  return r;
}

method::hysteresis::LoopPoint point(Estimator name, double t_s, double torque_Nm, double z_rad) {
  return {name, t_s, q_peak_rad, torque_Nm, torque_Nm - 0.012, torque_Nm + 0.012, z_rad, 0.03};
}

method::hysteresis::HysteresisResult loop() {
  method::hysteresis::HysteresisResult h;
  h.stage = {"hysteresis", statistics::StageState::done, {}};
  h.found = true;
  h.bristle_source = {"loop.bristle_recorded"};
  h.oscillations = {{q_peak_rad, 1e-4, 1.0, 10.0, 9.0, 4.8e-7}};
  h.points = {point(Estimator::A, 0.0, 3.924, 0.0),      point(Estimator::B, 0.33, 3.866, 0.0),
              point(Estimator::C, 0.25, 4.759, 0.0019),  point(Estimator::D, 0.75, 2.993, -0.0019),
              point(Estimator::E, 0.82, 3.703, -0.0005), point(Estimator::F, 0.32, 4.061, 0.0005)};
  h.steady_points = h.points;
  h.midline_Nm = statistics::symmetric_estimate(gravity_Nm, 0.0043,
                                                Statement::verbatim("scatter of the cycles"));
  h.midline_q_rad = q_peak_rad;
  h.loop_height_Nm = 1.766;
  return h;
}

method::hysteresis::LuGreFit loop_fit() {
  method::hysteresis::LuGreFit fit;
  fit.converged = true;
  fit.rung = method::hysteresis::LuGreRung::level;
  const auto shown = [&](LuGreParameterName name, double value, double half_width) {
    method::hysteresis::LuGreParameter p;
    p.name = name;
    p.estimate = statistics::symmetric_estimate(value, half_width, Statement::verbatim("loop fit"));
    p.relative_error = half_width / value / 2;
    p.effect_Nm = 0.08;
    fit.parameters.push_back(p);
  };
  const auto not_shown = [&](LuGreParameterName name) {
    method::hysteresis::LuGreParameter p;
    p.name = name;
    p.why_not = Statement::verbatim("the motor stays below 0.0628 rad/s in the loops");
    p.experiment = Statement::verbatim("an oscillation of 0.016 rad at 1 Hz");
    fit.parameters.push_back(p);
  };
  shown(LuGreParameterName::bristle_stiffness, 465.4, 2.3);
  shown(LuGreParameterName::bristle_damping, 0.7708, 0.05);
  shown(LuGreParameterName::viscous, 0.001, 0.0009);
  shown(LuGreParameterName::static_torque, 0.88438, 0.0013);
  not_shown(LuGreParameterName::coulomb_torque);
  not_shown(LuGreParameterName::stribeck_speed);
  not_shown(LuGreParameterName::speed_weakening);
  not_shown(LuGreParameterName::inertia);
  fit.gravity_Nm =
      statistics::symmetric_estimate(gravity_Nm, 0.0005, Statement::verbatim("loop fit"));
  fit.identifiability = {
      {Statement::verbatim("bristle stiffness"), Statement::verbatim("static torque")},
      {0.9, 0.03},
      30.0,
      {0.6, -0.8},
      Statement::verbatim("static torque against bristle stiffness"),
      {{1.0, 0.4}, {0.4, 1.0}}};
  method::hysteresis::LuGreLoop only;
  only.recording = "oscillation";
  only.gravity_Nm = fit.gravity_Nm;
  only.residual_Nm = 0.02;
  only.motion = method::hysteresis::LoopMotion::spline;
  only.motion_residual_rad = 1.5e-6;
  const statistics::Estimate behind_turns{7e4, 6.9e4, 7.1e4, {"interval.scatter_of_strokes"}};
  only.traced = method::hysteresis::TracedLoop{
      1.6e-6,      Statement::verbatim("an encoder step of 5e-06 rad"), 11, 0.02, behind_turns,
      behind_turns};
  fit.loops = {only};
  fit.residual_Nm = 0.02;
  fit.iterations = 7;
  return fit;
}

method::hysteresis::SurrogateMass mass(Estimator estimator, double torque_Nm) {
  const statistics::Estimate torque =
      statistics::symmetric_estimate(torque_Nm, 0.0043, Statement::verbatim("reading"));
  return {estimator, torque, q_peak_rad, statistics::scaled(torque, kg_per_Nm), torque, 1.0, {}};
}

method::hysteresis::SurrogateMassesResult masses() {
  method::hysteresis::SurrogateMassesResult r;
  r.stage = {"surrogate_masses", statistics::StageState::done, {}};
  r.distance_m = 0.5;
  r.gravity_m_s2 = 9.81;
  r.masses = {mass(Estimator::A, 3.924),    mass(Estimator::B, 3.866),
              mass(Estimator::C, 4.759),    mass(Estimator::D, 2.993),
              mass(Estimator::E, 3.703),    mass(Estimator::F, 4.061),
              mass(Estimator::AB, 3.895),   mass(Estimator::CD, 3.876),
              mass(Estimator::EF, 3.882),   mass(Estimator::midline, gravity_Nm),
              mass(Estimator::sweep, 3.884)};
  return r;
}

method::viscous::ViscousCurvesResult curves(const method::hysteresis::SurrogateMassesResult& of) {
  method::viscous::ViscousCurvesResult v;
  v.stage = {"viscous_curves", statistics::StageState::done, {}};
  for (const double speed : {-300.0, -100.0, -10.0, 10.0, 100.0, 300.0}) {
    const double friction = std::copysign(0.45 + 0.0026 * std::abs(speed), speed);
    method::viscous::ConstantSpeedRun run;
    run.recording = "run.csv";
    run.speed_rad_s = speed;
    run.torque_Nm = gravity_Nm + friction;
    run.torque_half_width_Nm = run.direction_difference_half_width_Nm = 0.002;
    run.q_rad = q_peak_rad;
    run.mean_cos = 1;
    run.samples = 2000;
    run.direction_difference_Nm = friction;
    v.runs.push_back(run);
  }
  for (const method::hysteresis::SurrogateMass& m : of.masses) {
    method::viscous::ViscousCurve curve{m.estimator, {}};
    for (const method::viscous::ConstantSpeedRun& run : v.runs) {
      curve.friction_Nm.push_back(run.torque_Nm - m.gravity_Nm.value);
    }
    v.curves.push_back(curve);
  }
  v.samples_used = 12000;
  v.samples_left_out = 3400;
  return v;
}

method::selection::QualityErrorsResult errors(const method::viscous::ViscousCurvesResult& of) {
  method::selection::QualityErrorsResult q;
  q.stage = {"quality_errors", statistics::StageState::done, {}};
  q.reference = method::selection::CurveReference::direction_difference;
  for (const method::viscous::ConstantSpeedRun& run : of.runs) {
    q.reference_Nm.push_back(run.direction_difference_Nm);
  }
  for (const method::viscous::ViscousCurve& curve : of.curves) {
    method::selection::QualityError e{
        curve.estimator, {}, curve.estimator == Estimator::B ? 0.41 : 1.9};
    e.percent.assign(of.runs.size(), 0.4);
    q.errors.push_back(e);
  }
  return q;
}

method::checks::DataChecksResult sample_checks() {
  method::checks::DataCheck fails{method::checks::CheckName::speed_scale,
                                  "run_07.csv",
                                  Statement::verbatim("logged speed / derivative of the angle"),
                                  2.0,
                                  0.98,
                                  1.02,
                                  "1",
                                  method::checks::CheckState::fails,
                                  Statement::verbatim("factor 2 ± 0.01"),
                                  Statement::verbatim("speeds are wrong"),
                                  Statement::verbatim("correct the unit")};
  method::checks::DataCheck warns{method::checks::CheckName::clock_gaps,
                                  "sweep.csv",
                                  Statement::verbatim("time lost in gaps"),
                                  1.25,
                                  std::nullopt,
                                  5.0,
                                  "%",
                                  method::checks::CheckState::warns,
                                  Statement::verbatim("3 gaps"),
                                  Statement::verbatim("unknown in the gaps"),
                                  Statement::verbatim("log locally")};
  method::checks::DataCheck absent{method::checks::CheckName::temperature,
                                   "",
                                   {},
                                   std::nullopt,
                                   std::nullopt,
                                   std::nullopt,
                                   "",
                                   method::checks::CheckState::not_applicable,
                                   Statement::verbatim("no temperature is logged"),
                                   {},
                                   {}};
  return {{fails, warns, absent}};
}

std::vector<calibration::QuantityVerdict> sample_quantities(const statistics::Estimate& peak_rad) {
  calibration::QuantityVerdict angle;
  angle.quantity = joint::Quantity::cog_angle;
  angle.estimate = peak_rad;
  angle.unit = "rad";
  angle.limits = {{"q_peak_deg", false, calibration::LimitRule::max, -20, "°",
                   statistics::scaled(peak_rad, 57.29577951308232), calibration::LimitState::inside,
                   Statement::verbatim("angle keeps the limit")}};
  calibration::QuantityVerdict inertia;
  inertia.quantity = joint::Quantity::inertia;
  inertia.verdict = calibration::Verdict::not_identifiable;
  inertia.decides = false;
  inertia.reasons = {Statement::verbatim("the data do not show it")};
  inertia.experiment = Statement::verbatim("a fast sine");
  calibration::QuantityVerdict gravity;
  gravity.quantity = joint::Quantity::gravity_torque;
  gravity.unit = "N·m";
  gravity.estimate = statistics::symmetric_estimate(3.88318, 0.0043);
  calibration::BudgetPart recordings;
  recordings.standard_uncertainty = 0.0043 / 1.96;
  recordings.freedom = std::numeric_limits<double>::infinity();
  calibration::BudgetPart constant = recordings;
  constant.influence = calibration::Influence::torque_constant;
  constant.is_type_b = true;
  constant.stated = 0.5;
  constant.standard_uncertainty = 0.005 * 3.88318 / 1.96;
  gravity.budget = calibration::combined(*gravity.estimate, {recordings, constant},
                                         {calibration::Influence::gear_ratio});
  gravity.budget->effects = {{"hoses", 0.6, 0.1, "percent", false},
                             {"lag", 0.2, 0.5, "ms", true},
                             {"choice_of_law", 0.1, 0, {}, false}};
  gravity.verdict = calibration::Verdict::doubtful;
  gravity.reasons = {Statement::verbatim("its torque constant is not known well")};
  gravity.experiment = Statement::verbatim("measure the torque constant");
  return {angle, gravity, inertia};
}

/// Degrees at the motor, and a torque in mN·m of the other sign.
std::vector<joint::ColumnConversion> sample_conversions() {
  using Reason = joint::ConversionStep::Reason;
  constexpr double rad_per_deg = 0.017453292519943295;
  return {{joint::LoggedSignal::time, "t", "s", {}, "s", std::nullopt},
          {joint::LoggedSignal::angle,
           "q",
           "deg",
           {{Reason::unit, rad_per_deg}, {Reason::gear, gear_ratio, true}},
           "rad",
           joint::Side::joint},
          {joint::LoggedSignal::effort,
           "tau",
           "mNm",
           {{Reason::unit, 1e-3}, {Reason::sign, -1}},
           "N·m",
           joint::Side::motor}};
}

}  // namespace

calibration::Calibration complete_calibration() {
  calibration::Calibration c;
  c.manifest.robot = "FANUC AM100iB";
  c.manifest.joint = "J3";
  c.manifest.serial = "E-4711";
  c.manifest.drive = joint::Drive(gear_ratio, joint::EffortKind::motor_torque, joint::Side::motor);
  c.inputs = {{"manifest.toml", "manifest", 812, std::string(64, 'a'), 0, 0, {}, {}, {}},
              {"sweep.csv",
               "rough_sweep",
               8003370,
               std::string(64, 'b'),
               140410,
               139210,
               {{{"skipped.outside_window", {{"window", "5..62.3 s"}}}, 1200}},
               sample_conversions(),
               {}}};
  c.speed_sources = {{"sweep.csv", joint::Role::rough_sweep, true, 280, 0.28, 2.278}};
  c.notes = {Statement::verbatim("column 'tau' is read as motor torque")};
  c.rough = sweep("cog_rough", 0.0011);
  c.precise = sweep("cog_precise", 0.00021);
  c.q_peak_rad = c.precise.q_peak_rad;
  c.q_peak_source = method::gravity::PeakSource::precise_sweep;
  c.hysteresis = loop();
  c.lugre = loop_fit();
  c.masses = masses();
  c.viscous = curves(c.masses);
  c.quality = errors(c.viscous);
  c.selection = {{"selection", statistics::StageState::done, {}},
                 Estimator::B,
                 {Estimator::A},
                 Estimator::midline,
                 Statement::verbatim("the mid-line owes nothing to the start-up stroke"),
                 0.38794,
                 statistics::scaled(*c.q_peak_rad, -1.0)};
  c.friction.stage = {"friction_parameters", statistics::StageState::done, {}};
  c.friction.curve = Estimator::midline;
  method::model::ModelLaw& law = c.model.law;
  law.family = "line";
  law.level_Nm = 0.445;
  law.rise_Nm = 0.792;
  law.slowest_rad_s = 10.0;
  law.fastest_rad_s = 300.0;
  law.candidates = {{law, 0.9}};
  c.model.quantities = {{joint::Quantity::coulomb_torque, 0, 0.445, 0.435, 0.455, {}},
                        {joint::Quantity::viscous_coefficient, 0, 0.00264, 0.00247, 0.00281, {}}};
  c.friction.waiboer = method::viscous::WaiboerFit{
      true,
      statistics::symmetric_estimate(0.8844, 0.01, Statement::verbatim("fit")),
      statistics::symmetric_estimate(5.0, 0.2, Statement::verbatim("fit")),
      statistics::symmetric_estimate(0.7, 0.03, Statement::verbatim("fit")),
      statistics::symmetric_estimate(0.12, 0.004, Statement::verbatim("fit")),
      statistics::symmetric_estimate(0.6, 0.01, Statement::verbatim("fit")),
      0.004};
  c.data_checks = sample_checks();
  c.judgement = {calibration::Verdict::usable,
                 Statement::verbatim("all stages have their data"),
                 {Statement::verbatim("nothing was left out")},
                 sample_quantities(*c.q_peak_rad),
                 {},
                 {}};
  return c;
}

calibration::Calibration sweep_only() {
  calibration::Calibration c;
  c.manifest.robot = "UR10e";
  c.manifest.joint = "2";
  c.manifest.drive =
      joint::Drive(101.0, joint::EffortKind::motor_current, joint::Side::joint, 10.696);
  c.inputs = {{"joint_2.csv",
               "rough_sweep",
               306033,
               std::string(64, 'c'),
               6030,
               5369,
               {{{"skipped.outside_window", {{"window", "5..62.3 s"}}}, 661}},
               {},
               {}}};
  c.rough = sweep("cog_rough", 0.028);
  c.q_peak_rad = c.rough.q_peak_rad;
  c.q_peak_source = method::gravity::PeakSource::rough_sweep;
  c.precise.stage = {"cog_precise", statistics::StageState::skipped,
                     Statement::verbatim("no precise_sweep was recorded")};
  c.hysteresis.stage = {"hysteresis", statistics::StageState::not_identifiable,
                        Statement::verbatim("the encoder step of 0.0001 rad hides the loop")};
  c.masses.stage = {"surrogate_masses", statistics::StageState::partial,
                    Statement::verbatim("only the sweep gives a mass")};
  c.masses.masses = {mass(Estimator::sweep, 3.884)};
  c.viscous.stage = {"viscous_curves", statistics::StageState::skipped,
                     Statement::verbatim("no constant_speed was recorded")};
  c.quality.stage = {"quality_errors", statistics::StageState::skipped,
                     Statement::verbatim("there is no curve to judge")};
  c.selection.stage = {"selection", statistics::StageState::partial,
                       Statement::verbatim("the points A to F were not found")};
  c.selection.recommended = Estimator::sweep;
  c.friction.stage = {"friction_parameters", statistics::StageState::skipped,
                      Statement::verbatim("there is no curve to fit")};
  c.judgement = {calibration::Verdict::doubtful,
                 Statement::verbatim("angle and mass are known, friction is not"),
                 {},
                 {},
                 {},
                 {}};
  return c;
}

std::vector<figures::ReportFigure> sample_figures(const calibration::Calibration& calibration) {
  std::vector<figures::ReportFigure> figures;
  for (const statistics::StageReport& stage :
       {calibration.rough.stage, calibration.precise.stage, calibration.hysteresis.stage,
        calibration.masses.stage, calibration.viscous.stage, calibration.quality.stage,
        calibration.selection.stage, calibration.friction.stage}) {
    figures::ReportFigure figure;
    figure.paper_number = static_cast<int>(figures.size()) + 1;
    figure.id = "fig-" + std::to_string(figures.size() + 1);
    figure.title = "Figure of " + stage.name;
    figure.caption = "Caption of " + stage.name;
    figure.how_to_read = "Look at the slope.";
    figure.alt = "Torque 3.88 N·m";
    figure.stage = stage.name;
    figures.push_back(figure);
  }
  return figures;
}

std::vector<render::workers::DrawnFigure> sample_pictures(
    const std::vector<figures::ReportFigure>& figures) {
  std::vector<render::workers::DrawnFigure> drawn;
  for (const figures::ReportFigure& figure : figures) {
    const std::vector<std::byte> png{std::byte{0x89}, std::byte{'P'}, std::byte{'N'},
                                     std::byte{'G'}, std::byte{0xff}};
    drawn.push_back({figure.id, png, 1600, 1000, {}, {}, {}});
  }
  return drawn;
}

calibration::Provenance sample_provenance() {
  calibration::Provenance p;
  p.tool_version = "0.1.0";
  p.git_revision = "unknown";
  p.compiler = "GCC 12.2.0";
  p.eigen_version = "3.4.0";
  p.created_utc = "2026-01-01T00:00:00Z";
  p.command_line = "tribolog report manifest.toml -o report.html";
  return p;
}

std::string report_of(const calibration::Calibration& calibration) {
  const auto figures = sample_figures(calibration);
  return report::document::html_report(calibration, figures, sample_pictures(figures),
                                       sample_provenance());
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

}  // namespace tribolog::test
