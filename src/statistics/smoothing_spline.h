#pragma once
// The natural cubic smoothing spline, which trades closeness to points against curvature:
//
//   sum ((y_i - s(t_i)) / error_i)^2 + weight * integral s''^2 dt  ->  least
//
// Reinsch's algorithm (C. H. Reinsch, Numer. Math. 10 (1967) 177-183): work proportional to the
// number of points. The weight is the one that predicts a point best from the others, by
// generalised cross-validation (P. Craven, G. Wahba, Numer. Math. 31 (1979) 377-403): it needs only
// the relative size of the errors, and that they are independent. With more than 20,000 points the
// weight is chosen on ten stretches spread over them; the curve is fitted to all points.

#include <cstddef>
#include <limits>
#include <vector>

namespace tribolog::statistics {

/// Points of a curve, in the order of time.
struct CurvePoints {
  std::vector<double> t;
  std::vector<double> y;
  std::vector<double> error;  ///< Standard error of y, > 0; known up to a common factor.
};

class SmoothingSpline {
 public:
  struct Point {
    double value{};
    double slope{};      ///< s'
    double curvature{};  ///< s''
  };

  /// @param weighed_from points before this time do not choose the weight: a blow at the beginning
  /// would have the whole curve follow its noise.
  /// @throw Refusal if there are fewer than four points, vectors of different sizes, times that do
  /// not increase or errors that are not > 0.
  explicit SmoothingSpline(const CurvePoints& points,
                           double weighed_from = std::numeric_limits<double>::lowest());
  /// For points of the same curve recorded once more: the weight is searched within half a power of
  /// ten of the one in `found`, which takes a third of the work.
  SmoothingSpline(const CurvePoints& points, const SmoothingSpline& found);

  /// Beyond the points: the tangent at the end.
  [[nodiscard]] Point at(double t) const;
  /// Effective number of parameters: 2 for a straight line, one per point if it passes through them
  /// all.
  [[nodiscard]] double degrees_of_freedom() const { return freedom_; }

 private:
  SmoothingSpline(const CurvePoints& points, double weighed_from, const SmoothingSpline* found);
  [[nodiscard]] std::size_t piece_of(double t) const;

  std::vector<double> t_;
  std::vector<double> value_;      // at the points
  std::vector<double> curvature_;  // at the points; linear between them
  double freedom_{};
  double weight_{};
  double weighed_from_{};
};

}  // namespace tribolog::statistics
