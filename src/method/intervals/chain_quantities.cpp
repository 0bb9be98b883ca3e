#include "method/intervals/chain_quantities.h"

#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "joint/gravity_load.h"
#include "statistics/levenberg_marquardt.h"

namespace tribolog::method::intervals {
namespace {

using Of = std::function<double(const ChainDraw&)>;

class Quantities {
 public:
  void add(std::string name, const statistics::Estimate& closed_form, bool bootstrap_is_stated,
           Of of) {
    all_.push_back({std::move(name), closed_form.value, closed_form, bootstrap_is_stated, false,
                    std::move(of)});
  }
  void add_resampled(std::string name, double value, bool is_root_mean_square, Of of) {
    all_.push_back(
        {std::move(name), value, std::nullopt, true, is_root_mean_square, std::move(of)});
  }
  std::vector<ChainQuantity> take() { return std::move(all_); }

 private:
  std::vector<ChainQuantity> all_;
};

void add_sweeps(const ChainResults& r, Quantities& out) {
  if (r.rough.found) {
    out.add("q_peak_rough_rad", r.rough.q_peak_rad, false,
            [](const ChainDraw& d) { return d.q_rough_rad; });
    if (r.rough.coulomb_Nm) {
      out.add("coulomb_of_sweep_Nm", *r.rough.coulomb_Nm, false,
              [](const ChainDraw& d) { return d.coulomb_Nm; });
    }
  }
  if (r.precise.found) {
    out.add("q_peak_precise_rad", r.precise.q_peak_rad, false,
            [](const ChainDraw& d) { return d.q_precise_rad; });
  }
  if (r.q_peak_rad) {
    out.add("q_peak_rad", *r.q_peak_rad, false, [](const ChainDraw& d) { return d.q_peak_rad; });
  }
}

void add_masses(const ChainResults& r, Quantities& out) {
  for (std::size_t k = 0; k < r.masses.masses.size(); ++k) {
    const hysteresis::SurrogateMass& mass = r.masses.masses[k];
    const double kg_per_Nm = joint::surrogate_mass_kg(1.0, r.gear_ratio, r.masses.distance_m,
                                                      r.masses.gravity_m_s2, 1.0);
    out.add("gravity_Nm." + to_string(mass.estimator), mass.gravity_Nm, false,
            [k](const ChainDraw& d) { return d.gravity_Nm[k]; });
    out.add("mass_kg." + to_string(mass.estimator), mass.mass_kg, false,
            [k, kg_per_Nm](const ChainDraw& d) { return kg_per_Nm * d.gravity_Nm[k]; });
  }
}

void add_loop_fit(const ChainResults& r, Quantities& out) {
  if (!r.lugre || !r.lugre->converged || !r.loop.lugre || !r.loop.lugre->linearised) return;
  const std::vector<statistics::LinearisedReading>& readings = r.loop.lugre->linearised->readings;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    // Ramps may have contradicted since what the fit read from the loops.
    const hysteresis::LuGreParameterName name = r.loop.lugre->readings[k];
    const std::optional<statistics::Estimate> shown = r.lugre->shown(name);
    if (!shown) continue;
    const double value = readings[k].value;
    const bool logarithmic = readings[k].logarithmic;
    out.add("lugre." + to_string(name), *shown, false, [value, logarithmic, k](const ChainDraw& d) {
      return logarithmic ? value * std::exp(d.lugre[k]) : value + d.lugre[k];
    });
  }
}

void add_curve(const ChainResults& r, Quantities& out) {
  if (r.friction.waiboer) {
    const viscous::WaiboerFit& w = *r.friction.waiboer;
    const std::pair<const char*, const statistics::Estimate*> named[] = {
        {"waiboer.asperity_torque_Nm", &w.asperity_torque_Nm},
        {"waiboer.stribeck_speed_rad_s", &w.stribeck_speed_rad_s},
        {"waiboer.stribeck_power", &w.stribeck_power},
        {"waiboer.viscous_coefficient", &w.viscous_coefficient},
        {"waiboer.viscous_power", &w.viscous_power}};
    for (std::size_t k = 0; k < std::size(named); ++k) {
      out.add(named[k].first, *named[k].second, true,
              [k](const ChainDraw& d) { return d.parameters.waiboer[k]; });
    }
  }
  if (r.friction.coulomb_viscous) {
    out.add("line.coulomb_Nm", r.friction.coulomb_viscous->coulomb_Nm, true,
            [](const ChainDraw& d) { return d.parameters.line[0]; });
    out.add("line.viscous_Nms_rad", r.friction.coulomb_viscous->viscous_Nms_rad, true,
            [](const ChainDraw& d) { return d.parameters.line[1]; });
  }
}

void add_choice(const ChainResults& r, Quantities& out) {
  for (std::size_t k = 0; k < r.quality.errors.size(); ++k) {
    if (!std::isfinite(r.quality.errors[k].rms_percent)) continue;
    out.add_resampled("quality_error_percent." + to_string(r.quality.errors[k].estimator),
                      r.quality.errors[k].rms_percent, true,
                      [k](const ChainDraw& d) { return d.rms_percent[k]; });
  }
  if (r.selection.q_c_corrected_rad &&
      r.hysteresis.points.size() == hysteresis::loop_points.size()) {
    const std::vector<hysteresis::LoopPoint>& points = r.hysteresis.points;
    out.add_resampled("q_c_corrected_rad", *r.selection.q_c_corrected_rad, false,
                      [&points](const ChainDraw& d) {
                        return d.choice ? -(points[*d.choice].q_rad + d.point_angle_shift_rad)
                                        : std::numeric_limits<double>::quiet_NaN();
                      });
  }
}

}  // namespace

std::vector<ChainQuantity> chain_quantities(const ChainResults& results) {
  Quantities out;
  add_sweeps(results, out);
  add_masses(results, out);
  add_loop_fit(results, out);
  add_curve(results, out);
  add_choice(results, out);
  return out.take();
}

}  // namespace tribolog::method::intervals
