#include "ingest/measurement/tdms_scaling.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "ingest/measurement/measured_log.h"

namespace tribolog::ingest::measurement {
namespace {

constexpr double raw_data = 4294967295.0;  ///< As the input of a scale.
constexpr double most_scales = 16;         ///< And coefficients of one.

/// Properties of one scale: "NI_Scale[0]_Linear_Slope".
class Scale {
 public:
  Scale(const TdmsProperties& properties, std::size_t place)
      : properties_(properties), prefix_(fmt::format("NI_Scale[{}]_", place)) {}

  [[nodiscard]] std::string type() const { return text_of(properties_, prefix_ + "Scale_Type"); }
  [[nodiscard]] double number(const std::string& name) const {
    const auto found = number_of(properties_, prefix_ + name);
    if (!found) throw UnreadChannel("its scale lacks " + in_quotes(prefix_ + name));
    return *found;
  }
  [[nodiscard]] double number_or(const std::string& name, double otherwise) const {
    return number_of(properties_, prefix_ + name).value_or(otherwise);
  }

 private:
  const TdmsProperties& properties_;
  std::string prefix_;
};

std::vector<double> coefficients_of(const Scale& scale) {
  const std::string type = scale.type();
  if (type == "Linear") return {scale.number("Linear_Y_Intercept"), scale.number("Linear_Slope")};
  if (type == "AdvancedAPI") return {0, 1};
  if (type != "Polynomial") throw UnreadChannel("its scale is of type " + in_quotes(type));
  constexpr double usual = 4;
  const double count = scale.number_or("Polynomial_Coefficients_Size", usual);
  if (!(count >= 0 && count <= most_scales)) {
    throw UnreadChannel(fmt::format("its scale has {} coefficients", count));
  }
  std::vector<double> coefficients;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    coefficients.push_back(scale.number(fmt::format("Polynomial_Coefficients[{}]", i)));
  }
  return coefficients;
}

/// The number of scales where it is not stated: a file that was put together from others.
double counted_scales(const TdmsProperties& properties) {
  double count = 0;
  while (count <= most_scales &&
         !Scale(properties, static_cast<std::size_t>(count)).type().empty()) {
    ++count;
  }
  return count;
}

}  // namespace

std::optional<TdmsScaling> read_scaling(const TdmsProperties& properties) {
  const auto stated = number_of(properties, "NI_Number_Of_Scales");
  const double count = stated ? *stated : counted_scales(properties);
  if (count == 0) return std::nullopt;
  if (text_of(properties, "NI_Scaling_Status") == "scaled") return TdmsScaling{};
  if (!(count >= 1 && count <= most_scales && count == std::floor(count))) {
    throw UnreadChannel(fmt::format("it has {} scales", count));
  }
  TdmsScaling scaling;
  // From the last one back to the raw data: each names the one that it takes.
  for (double place = count - 1; place != raw_data;) {
    const Scale scale(properties, static_cast<std::size_t>(place));
    scaling.push_back(coefficients_of(scale));
    const double input = scale.number_or(scale.type() + "_Input_Source", raw_data);
    const bool is_before = input >= 0 && input < place && input == std::floor(input);
    if (input != raw_data && !is_before) {
      throw UnreadChannel("its scales take each other in no order");
    }
    place = input;
  }
  std::reverse(scaling.begin(), scaling.end());
  return scaling;
}

void scale(const TdmsScaling& scaling, std::vector<double>& values) {
  for (const std::vector<double>& coefficients : scaling) {
    for (double& value : values) {
      double sum = 0;
      for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * value + coefficients[i];
      value = sum;
    }
  }
}

}  // namespace tribolog::ingest::measurement
