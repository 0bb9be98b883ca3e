#include "ingest/arrays/matlab_objects.h"

#include <array>

#include <fmt/format.h>

namespace tribolog::ingest::arrays {
namespace {

struct ObjectLine {
  std::string_view class_name;
  std::string_view line;  ///< "{0}" is the object.
};

constexpr std::array object_lines = {
    ObjectLine{
        "timetable",
        "s = table2struct(timetable2table({0}, 'ConvertRowTimes', false), 'ToScalar', true); "
        "s.t_s = seconds({0}.Properties.RowTimes - {0}.Properties.RowTimes(1)); "
        "save('plain.mat', '-struct', 's')"},
    ObjectLine{"table",
               "s = table2struct({0}, 'ToScalar', true); save('plain.mat', '-struct', 's')"},
    ObjectLine{"timeseries",
               "s.t_s = {0}.Time; s.value = squeeze({0}.Data); save('plain.mat', '-struct', 's'), "
               "with a field for each further one"},
    ObjectLine{"Simulink.SimulationData.Dataset",
               "for k = 1:{0}.numElements, v = {0}{{k}}.Values; s.t_s = v.Time; "
               "s.(matlab.lang.makeValidName({0}{{k}}.Name)) = squeeze(v.Data); end; "
               "save('plain.mat', '-struct', 's')"},
    ObjectLine{"Simulink.SimulationOutput",
               "d = {0}.logsout; for k = 1:d.numElements, v = d{{k}}.Values; s.t_s = v.Time; "
               "s.(matlab.lang.makeValidName(d{{k}}.Name)) = squeeze(v.Data); end; "
               "save('plain.mat', '-struct', 's')"},
    ObjectLine{"datetime",
               "s.t_s = seconds({0} - {0}(1)); save('plain.mat', '-append', '-struct', 's')"},
    ObjectLine{"duration", "s.t_s = seconds({0}); save('plain.mat', '-append', '-struct', 's')"}};

}  // namespace

std::string why_object_is_not_read(const std::string& name, const std::string& class_name) {
  for (const ObjectLine& of : object_lines) {
    if (of.class_name != class_name) continue;
    return fmt::format("it is a {}, which MATLAB alone reads; there: {}", class_name,
                       fmt::format(fmt::runtime(of.line), name));
  }
  std::string why(is_matlab_object);
  if (!class_name.empty()) why += ", " + class_name + ",";
  return why +
         " which MATLAB alone reads; save its numbers there as vectors: s.t_s = ...; s.q = "
         "...; save('plain.mat', '-struct', 's')";
}

}  // namespace tribolog::ingest::arrays
