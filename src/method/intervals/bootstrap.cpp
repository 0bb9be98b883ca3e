#include "method/intervals/bootstrap.h"

#include <algorithm>
#include <cmath>

#include "base/parallel_for.h"
#include "base/statement.h"
#include "method/intervals/chain_draw.h"
#include "method/intervals/chain_quantities.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::intervals {

namespace {

std::vector<ChainDraw> draw_all(const ChainResults& results, const ResamplingOptions& options,
                                const std::function<void(std::size_t)>& progress) {
  const ChainResampler chain(results);
  std::vector<ChainDraw> draws(options.resamples);
  constexpr std::size_t parts = 10;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t first = options.resamples * part / parts;
    const std::size_t last = options.resamples * (part + 1) / parts;
    if (progress) progress(first);
    parallel_for(
        last - first,
        [&](std::size_t k) {
          statistics::RandomStream random(options.seed, first + k);
          draws[first + k] = chain.draw(random);
        },
        options.threads);
  }
  return draws;
}

template <class Value>
std::vector<double> values_of(const std::vector<ChainDraw>& draws, Value value) {
  std::vector<double> values;
  values.reserve(draws.size());
  for (const ChainDraw& draw : draws) values.push_back(value(draw));
  return values;
}

std::vector<CurveBand> bands_of(const viscous::ViscousCurvesResult& curves,
                                const std::vector<ChainDraw>& draws, std::size_t threads) {
  std::vector<CurveBand> bands;
  const std::size_t runs = curves.runs.size();
  for (const viscous::ViscousCurve& curve : curves.curves) {
    bands.push_back({curve.estimator, std::vector<double>(runs), std::vector<double>(runs)});
  }
  parallel_for(
      runs * bands.size(),
      [&](std::size_t k) {
        const statistics::Estimate e = statistics::percentile_interval(
            curves.curves[k / runs].friction_Nm[k % runs],
            values_of(draws, [&](const ChainDraw& d) { return d.friction_Nm[k]; }));
        bands[k / runs].low_Nm[k % runs] = e.low;
        bands[k / runs].high_Nm[k % runs] = e.high;
      },
      threads);
  return bands;
}

std::vector<ChoiceShare> choices_of(const std::vector<ChainDraw>& draws) {
  std::vector<ChoiceShare> shares;
  for (const hysteresis::Estimator point : hysteresis::loop_points) shares.push_back({point, 0.0});
  for (const ChainDraw& draw : draws) {
    if (!draw.choice) return {};
    shares[*draw.choice].share += 1 / static_cast<double>(draws.size());
  }
  return shares;
}

/// Every gravity torque against the recommended one.
std::vector<GravityDifference> differences_of(const ChainResults& results,
                                              const std::vector<ChainDraw>& draws) {
  const auto& masses = results.masses.masses;
  const auto at =
      std::find_if(masses.begin(), masses.end(), [&](const hysteresis::SurrogateMass& m) {
        return m.estimator == results.selection.recommended;
      });
  if (at == masses.end()) return {};
  const auto recommended = static_cast<std::size_t>(at - masses.begin());
  std::vector<GravityDifference> all;
  const auto add = [&](GravityMethod method, double value, auto gravity_of) {
    all.push_back({method, statistics::percentile_interval(value, values_of(draws, gravity_of)),
                   statistics::percentile_interval(
                       value - at->gravity_Nm.value, values_of(draws, [&](const ChainDraw& d) {
                         return gravity_of(d) - d.gravity_Nm[recommended];
                       }))});
  };
  for (std::size_t k = 0; k < masses.size(); ++k) {
    add(masses[k].estimator, masses[k].gravity_Nm.value,
        [k](const ChainDraw& d) { return d.gravity_Nm[k]; });
  }
  for (std::size_t k = 0; k < results.independent.gravity.size(); ++k) {
    add(results.independent.gravity[k].method, results.independent.gravity[k].gravity_Nm.value,
        [k](const ChainDraw& d) { return d.other_Nm[k]; });
  }
  return all;
}

}  // namespace

std::string to_string(const GravityMethod& method) {
  return std::visit([](auto one) { return to_string(one); }, method);
}

const statistics::Estimate* TwoIntervals::stated() const {
  if (bootstrap && (bootstrap_is_stated || !closed_form)) return &*bootstrap;
  return closed_form ? &*closed_form : nullptr;
}

double TwoIntervals::ratio() const {
  if (!closed_form || !bootstrap) return 0;
  const double closed = closed_form->half_width();
  const double resampled = bootstrap->half_width();
  return closed > 0 && std::isfinite(closed) && std::isfinite(resampled) ? resampled / closed : 0;
}

const TwoIntervals* IntervalsResult::find(const std::string& name) const {
  const auto it = std::find_if(quantities.begin(), quantities.end(),
                               [&](const TwoIntervals& q) { return q.name == name; });
  return it == quantities.end() ? nullptr : &*it;
}

const CurveBand* IntervalsResult::band(hysteresis::Estimator estimator) const {
  const auto it = std::find_if(bands.begin(), bands.end(),
                               [&](const CurveBand& b) { return b.estimator == estimator; });
  return it == bands.end() ? nullptr : &*it;
}

IntervalsResult resample_chain(const ChainResults& results, const ResamplingOptions& options,
                               const std::function<void(std::size_t)>& progress) {
  if (!joint::resamples_are_allowed(options.resamples)) {
    throw Refusal({"resamples.not_allowed",
                   {{"resamples", options.resamples}, {"allowed", joint::allowed_resamples()}}});
  }
  IntervalsResult out;
  out.resamples = options.resamples;
  out.seed = options.seed;
  std::vector<ChainQuantity> quantities = chain_quantities(results);
  for (const ChainQuantity& q : quantities) {
    out.quantities.push_back({q.name, q.closed_form, std::nullopt, q.bootstrap_is_stated});
  }
  if (options.resamples == 0) return out;
  const std::vector<ChainDraw> draws = draw_all(results, options, progress);
  parallel_for(
      quantities.size(),
      [&](std::size_t k) {
        const ChainQuantity& q = quantities[k];
        std::vector<double> values = values_of(draws, q.of);
        out.quantities[k].bootstrap =
            q.is_root_mean_square
                ? statistics::root_mean_square_interval(q.value, std::move(values))
                : statistics::percentile_interval(q.value, std::move(values));
      },
      options.threads);
  out.bands = bands_of(results.viscous, draws, options.threads);
  out.choices = choices_of(draws);
  out.differences = differences_of(results, draws);
  return out;
}

selection::FrictionParametersResult with_stated_intervals(
    selection::FrictionParametersResult friction, const IntervalsResult& intervals) {
  const auto state = [&](const char* name, statistics::Estimate& estimate) {
    const TwoIntervals* both = intervals.find(name);
    if (both == nullptr || !both->bootstrap || !both->bootstrap_is_stated) return;
    estimate.low = both->bootstrap->low;
    estimate.high = both->bootstrap->high;
    estimate.method = {"interval.curve_fit_bootstrap"};
  };
  if (friction.waiboer) {
    state("waiboer.asperity_torque_Nm", friction.waiboer->asperity_torque_Nm);
    state("waiboer.stribeck_speed_rad_s", friction.waiboer->stribeck_speed_rad_s);
    state("waiboer.stribeck_power", friction.waiboer->stribeck_power);
    state("waiboer.viscous_coefficient", friction.waiboer->viscous_coefficient);
    state("waiboer.viscous_power", friction.waiboer->viscous_power);
  }
  if (friction.coulomb_viscous) {
    state("line.coulomb_Nm", friction.coulomb_viscous->coulomb_Nm);
    state("line.viscous_Nms_rad", friction.coulomb_viscous->viscous_Nms_rad);
  }
  return friction;
}

}  // namespace tribolog::method::intervals
