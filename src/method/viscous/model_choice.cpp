#include "method/viscous/model_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

#include "method/viscous/curve_fit.h"
#include "method/viscous/curve_parameters.h"
#include "statistics/held_out.h"

namespace tribolog::method::viscous {
namespace {

constexpr double one_standard_error = 1.0;
constexpr double term_standard_errors = 2.0;
constexpr double least_load_range = 0.1;  // share of the gravity torque
constexpr std::size_t fewest_speeds = 3;

/// A trial with the errors of each group held out.
struct Tried {
  CurveModelTrial trial;
  CurveFit fit;  // of all speeds
  std::vector<double> errors;
  [[nodiscard]] bool took_part() const { return trial.excluded_because.empty(); }
};

class Chooser {
 public:
  Chooser(const std::vector<CurveSample>& samples, bool sweep)
      : samples_(samples), sweep_(sweep), groups_(groups_to_hold_out(samples)) {
    double low = 1;
    double high = 0;
    for (const CurveSample& s : samples) {
      low = std::min(low, s.load);
      high = std::max(high, s.load);
      mean_load_ += s.load / static_cast<double>(samples.size());
      rising_ = rising_ || s.direction > 0;
      falling_ = falling_ || s.direction < 0;
    }
    double slowest = std::numeric_limits<double>::infinity();
    double fastest = 0;
    for (const CurveSample& s : samples) {
      slowest = std::min(slowest, s.speed_rad_s);
      fastest = std::max(fastest, s.speed_rad_s);
    }
    constexpr int points = 120;
    for (int i = 0; i <= points; ++i) {
      // Dense at low speed, where the Stribeck effect bends the curve.
      const double share = static_cast<double>(i) / points;
      curve_speeds_.push_back(slowest + (fastest - slowest) * share * share);
    }
    load_varies_ = high - low >= least_load_range;
  }

  [[nodiscard]] CurveModelChoice choose();

 private:
  const Tried& tried(const CurveModel& model) {
    const auto key =
        std::tuple(static_cast<int>(model.law), static_cast<int>(model.asymmetry), model.load);
    const auto at = memory_.find(key);
    if (at != memory_.end()) return at->second;
    return memory_.emplace(key, attempt(model)).first->second;
  }

  [[nodiscard]] Tried attempt(const CurveModel& model) const {
    Tried t;
    t.trial.model = model;
    Statement& why = t.trial.excluded_because;
    const bool has_stribeck = model.law == CurveLaw::stribeck || model.law == CurveLaw::waiboer;
    // Terms of direction and load are common to the speeds; the law itself has to be determined by
    // them.
    const CurveModel law{model.law, Asymmetry::none, false};
    const std::size_t speeds = group_count(samples_);
    if (sweep_ && has_stribeck) {
      why = {"curve_fit.sweep_hides_stribeck"};
      return t;
    }
    if (speeds < static_cast<std::size_t>(law.parameters()) + 2) {
      why = {
          "curve_fit.too_few_speeds",
          {{"speeds", speeds}, {"parameters", law.parameters()}, {"needed", law.parameters() + 2}}};
      return t;
    }
    const auto fit = fit_curve(model, samples_);
    if (!fit) {
      why = {"curve_fit.parameters_not_distinct"};
      return t;
    }
    t.fit = *fit;
    why = fit->impossible_because();
    if (!why.empty()) return t;
    t.errors = held_out_errors(*fit, samples_, groups_);
    if (t.errors.empty()) {
      why = {"curve_fit.needs_every_speed"};
      return t;
    }
    t.trial.training_rms_Nm = statistics::root_mean(training_errors(*fit));
    t.trial.held_out_rms_Nm = statistics::root_mean(t.errors);
    for (const double w : curve_speeds_) {
      t.trial.curve_Nm.push_back(fit->friction_Nm({w, 0, 0, mean_load_, 0}));
    }
    return t;
  }

  /// Errors of a fit to all speeds, at those that are held out in turn: for comparison with the
  /// held-out errors.
  [[nodiscard]] std::vector<double> training_errors(const CurveFit& fit) const {
    std::vector<double> errors;
    for (const std::size_t group : groups_) {
      std::vector<CurveSample> members;
      for (const CurveSample& s : samples_) {
        if (s.group == group) members.push_back(s);
      }
      errors.push_back(std::pow(fit.rms_Nm(members), 2));
    }
    return errors;
  }

  /// The simplest law no worse than the best by more than a standard error; nothing if none fits.
  [[nodiscard]] std::optional<CurveLaw> simplest_law(const CurveModel& terms) {
    const Tried* best = nullptr;
    for (const CurveLaw law : curve_laws) {
      const Tried& t = tried({law, terms_for(law, terms.asymmetry), terms.load});
      if (!t.took_part()) continue;
      if (best == nullptr || t.trial.held_out_rms_Nm < best->trial.held_out_rms_Nm) best = &t;
    }
    if (best == nullptr) return std::nullopt;
    for (const CurveLaw law : curve_laws) {
      const Tried& t = tried({law, terms_for(law, terms.asymmetry), terms.load});
      if (!t.took_part()) continue;
      const statistics::ErrorDifference d = statistics::difference(t.errors, best->errors);
      if (d.mean <= one_standard_error * d.standard_error || is_rounding(t)) return law;
    }
    return best->trial.model.law;
  }

  /// Coulomb friction alone has no viscous term that could differ between the directions.
  static Asymmetry terms_for(CurveLaw law, Asymmetry asymmetry) {
    return law == CurveLaw::coulomb && asymmetry == Asymmetry::coulomb_viscous ? Asymmetry::coulomb
                                                                               : asymmetry;
  }

  /// An error that no drive resolves, or that is rounding: nothing is left to explain.
  static bool is_rounding(const Tried& t) {
    constexpr double resolved = 1e-6;  // of the friction's size
    return t.trial.held_out_rms_Nm < resolved * t.fit.torque_scale_Nm;
  }

  /// Adds terms one by one while the best of the remaining ones pays.
  CurveModel with_terms_that_pay(CurveLaw law, CurveModelChoice& out);

  const std::vector<CurveSample>& samples_;
  bool sweep_;
  std::vector<std::size_t> groups_;
  bool load_varies_{false};
  bool rising_{false};
  bool falling_{false};
  double mean_load_{0};
  std::vector<double> curve_speeds_;
  std::map<std::tuple<int, int, bool>, Tried> memory_;
};

CurveModel Chooser::with_terms_that_pay(CurveLaw law, CurveModelChoice& out) {
  CurveModel now{law, Asymmetry::none, false};
  out.options.push_back(tried(now).trial);
  while (true) {
    std::vector<CurveModel> next;
    if (rising_ && falling_ && now.asymmetry == Asymmetry::none) {
      next.push_back({law, Asymmetry::coulomb, now.load});
    }
    if (now.asymmetry == Asymmetry::coulomb && law != CurveLaw::coulomb) {
      next.push_back({law, Asymmetry::coulomb_viscous, now.load});
    }
    if (load_varies_ && !now.load) next.push_back({law, now.asymmetry, true});
    const Tried& base = tried(now);
    const CurveModel* best = nullptr;
    double best_gain = 0;
    for (const CurveModel& candidate : next) {
      const Tried& t = tried(candidate);
      out.options.push_back(t.trial);
      if (!t.took_part() || !base.took_part() || is_rounding(base)) continue;
      const statistics::ErrorDifference gain = statistics::difference(base.errors, t.errors);
      if (gain.mean > term_standard_errors * gain.standard_error && gain.mean > best_gain) {
        best = &candidate;
        best_gain = gain.mean;
      }
    }
    if (best == nullptr) return now;
    now = *best;
  }
}

Statement choice_stated(const CurveModelChoice& c) {
  const CurveModelTrial& chosen = *c.find(c.chosen.law);
  const CurveModelTrial* best = &chosen;
  for (const CurveModelTrial& t : c.ladder) {
    if (t.excluded_because.empty() && t.held_out_rms_Nm < best->held_out_rms_Nm) best = &t;
  }
  Statement stated{"curve_model.chosen",
                   {{"model", described(c.chosen)},
                    {"parameters", c.chosen.parameters()},
                    {"error_Nm", chosen.held_out_rms_Nm}}};
  if (best != &chosen) {
    stated.add({"curve_model.best_gains_too_little",
                {{"law", described(best->model.law)},
                 {"parameters", best->model.parameters()},
                 {"error_Nm", best->held_out_rms_Nm}}});
  }
  const CurveModelTrial* simpler = nullptr;
  for (const CurveModelTrial& t : c.ladder) {
    if (t.model.law == c.chosen.law) break;
    if (t.excluded_because.empty()) simpler = &t;
  }
  if (simpler != nullptr) {
    stated.add({"curve_model.next_simpler",
                {{"law", described(simpler->model.law)}, {"error_Nm", simpler->held_out_rms_Nm}}});
  }
  return stated;
}

void judge_five(CurveModelChoice& c) {
  const CurveModelTrial& five = *c.find(CurveLaw::waiboer);
  c.carries_five = c.chosen.law == CurveLaw::waiboer;
  if (c.carries_five) {
    c.five_sentence = {"waiboer_five.carried"};
  } else if (!five.excluded_because.empty()) {
    c.five_sentence = {"waiboer_five.not_carried", {{"why", five.excluded_because}}};
  } else {
    const CurveModelTrial& chosen = *c.find(c.chosen.law);
    const bool is_worse = five.held_out_rms_Nm >= chosen.held_out_rms_Nm;
    c.five_sentence = {
        is_worse ? Code{"waiboer_five.no_gain"} : Code{"waiboer_five.gain_too_little"},
        {{"error_Nm", five.held_out_rms_Nm},
         {"error_of_chosen_Nm", chosen.held_out_rms_Nm},
         {"parameters_of_chosen", c.chosen.parameters()}}};
  }
}

CurveModelChoice Chooser::choose() {
  CurveModelChoice out;
  out.speeds = group_count(samples_);
  out.curve_speed_rad_s = curve_speeds_;
  if (out.speeds < fewest_speeds) {
    out.sentence = {"curve_model.too_few_speeds",
                    {{"speeds", out.speeds}, {"needed", fewest_speeds}}};
    return out;
  }
  // Terms first, with the law that fits best where all of them are in, so that a missing term is
  // not taken for a bend of the curve; then the law with the terms that paid.
  const Asymmetry full = rising_ && falling_ ? Asymmetry::coulomb_viscous : Asymmetry::none;
  auto law = simplest_law({CurveLaw::coulomb, full, load_varies_});
  if (!law) law = simplest_law({});
  if (!law) {
    out.sentence = {"curve_model.none_possible_because",
                    {{"why", tried({}).trial.excluded_because}}};
    return out;
  }
  const CurveModel terms = with_terms_that_pay(*law, out);
  law = simplest_law(terms);
  if (!law) {
    out.sentence = {"curve_model.none_possible"};
    return out;
  }
  out.chosen = {*law, terms_for(*law, terms.asymmetry), terms.load};
  for (const CurveLaw each : curve_laws) {
    out.ladder.push_back(tried({each, terms_for(each, terms.asymmetry), terms.load}).trial);
  }
  out.chosen_any = true;
  out.parameters = curve_parameters(tried(out.chosen).fit, samples_);
  out.sentence = choice_stated(out);
  judge_five(out);
  return out;
}

}  // namespace

const CurveModelTrial* CurveModelChoice::find(CurveLaw law) const {
  const auto it = std::find_if(ladder.begin(), ladder.end(),
                               [&](const CurveModelTrial& t) { return t.model.law == law; });
  return it == ladder.end() ? nullptr : &*it;
}

CurveModelChoice choose_curve_model(const std::vector<CurveSample>& samples, bool sweep) {
  return Chooser(samples, sweep).choose();
}

namespace {

/// Root mean square over the speeds that the sliding law used of what eq. (6) leaves of the mean
/// over both directions; nothing if it fits none.
std::optional<double> residual_of_five(const CurveModel& five,
                                       const std::vector<CurveSample>& samples,
                                       const SlidingLaw& law) {
  const std::optional<CurveFit> fit = fit_curve(five, samples);
  if (!fit) return std::nullopt;
  struct Sum {
    double error{}, count{};
  };
  std::map<std::pair<std::size_t, bool>, Sum> directions;
  for (const CurveSample& s : samples) {
    const bool is_used =
        std::none_of(law.left_out.begin(), law.left_out.end(), [&](const StrayFriction& stray) {
          return std::find(stray.runs.begin(), stray.runs.end(), s.run) != stray.runs.end();
        });
    if (!is_used) continue;
    Sum& sum = directions[{s.group, s.direction < 0}];
    sum.error += s.friction_Nm - fit->friction_Nm(s);
    sum.count += 1;
  }
  std::map<std::size_t, Sum> speeds;
  for (const auto& [key, sum] : directions) {
    speeds[key.first].error += sum.error / sum.count;
    speeds[key.first].count += 1;
  }
  double squares = 0;
  for (const auto& [group, sum] : speeds) squares += std::pow(sum.error / sum.count, 2);
  return std::sqrt(squares / static_cast<double>(speeds.size()));
}

/// Whether the sliding law, with the exponents of its own, describes the speeds clearly better than
/// eq. (6) does, which has as many parameters: by the difference of Akaike's criterion.
bool is_clearly_better(const SlidingLaw& law, const CurveModel& five,
                       const std::vector<CurveSample>& samples) {
  constexpr double clear = 6;
  const std::optional<double> of_five = residual_of_five(five, samples, law);
  if (!of_five) return true;
  return 2 * static_cast<double>(law.speeds) * std::log(*of_five / law.residual_Nm) > clear;
}

/// Where only eq. (6) describes the curve, there is no Coulomb torque to state: without its
/// Stribeck term it tends to zero with the speed. The Stribeck velocity is that of eq. (6).
void follow_waiboer(const CurveModelChoice& choice, const std::vector<CurveSample>& samples,
                    SlidingLaw& law) {
  constexpr double clearly_better = 0.5;  // of the error at held-out speeds
  if (!choice.carries_five || !law.fitted || is_clearly_better(law, choice.chosen, samples)) return;
  const CurveModelTrial& five = *choice.find(CurveLaw::waiboer);
  const CurveModelTrial* rival = nullptr;
  for (const CurveModelTrial& t : choice.ladder) {
    if (t.model.law == CurveLaw::waiboer || !t.excluded_because.empty()) continue;
    if (rival == nullptr || t.held_out_rms_Nm < rival->held_out_rms_Nm) rival = &t;
  }
  const bool is_alone =
      rival == nullptr || five.held_out_rms_Nm < clearly_better * rival->held_out_rms_Nm;
  if (!is_alone) {
    // Speeds chose it, if not clearly: what the two split differently is not known.
    law.doubt({"cause.five_describe_better",
               {{"five_Nm", five.held_out_rms_Nm}, {"rival_Nm", rival->held_out_rms_Nm}}});
    return;
  }
  law.coulomb_Nm = {{}, {"curve_model.no_coulomb_torque"}};
  law.viscous_Nms_rad.why_not = {"curve_model.viscous_not_linear",
                                 {{"exponent", law.viscous_exponent}}};
  for (const CurveParameter& p : choice.parameters) {
    if (p.name == "viscous_exponent") {
      law.viscous_Nms_rad.why_not = {"curve_model.viscous_not_linear",
                                     {{"exponent", p.estimate.value}}};
    }
    if (p.name == "stribeck_speed_rad_s") law.stribeck_speed_rad_s = {p.estimate, {}};
  }
  // Its own exponent and dip are told in place of the other law's.
  std::erase_if(law.findings, [](const Statement& one) {
    return one.is("curve_model.viscous_not_linear") || one.is("cause.stribeck_not_shown");
  });
  law.findings.push_back(law.coulomb_Nm.why_not);
  law.findings.push_back(law.viscous_Nms_rad.why_not);
}

}  // namespace

CurveModelChoice choose_curve_model(const ViscousCurvesResult& curves,
                                    std::optional<hysteresis::Estimator> estimator) {
  const ViscousCurve* curve = curves.find(estimator);
  if (curve == nullptr || curves.runs.empty()) {
    CurveModelChoice none;
    none.sentence = {"curve_model.no_curve"};
    return none;
  }
  const std::vector<CurveSample> samples = curve_samples(curves, *curve);
  CurveModelChoice out = choose_curve_model(samples, curves.from_sweep);
  out.curve = estimator;
  if (out.chosen_any && !curves.from_sweep) {
    out.sliding = fit_sliding_law(samples, out.chosen);
    follow_waiboer(out, samples, out.sliding);
  }
  return out;
}

}  // namespace tribolog::method::viscous
