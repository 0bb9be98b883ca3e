#pragma once
// Objects of MATLAB's classes (table, timetable, timeseries ...) in MAT files, which MATLAB alone
// can read: what to type there.

#include <string>
#include <string_view>

namespace tribolog::ingest::arrays {

/// Said of an object whose class is not known.
inline constexpr std::string_view is_matlab_object = "it is an object of a MATLAB class";

/// Said of a variable without a name, and its name in messages.
inline constexpr std::string_view is_stored_of_objects =
    "it has no name, as what MATLAB stores of its objects";
inline constexpr std::string_view unnamed = "(no name)";

/// Why an object is not read, with the line that makes plain vectors of it in MATLAB.
/// @param name as the user has it there, "run.tt"; "x" stands for any. @param class_name empty: not
/// known.
std::string why_object_is_not_read(const std::string& name, const std::string& class_name);

}  // namespace tribolog::ingest::arrays
