#pragma once
// Columns from a JSON log: of what stands under one name in many rows.

#include <algorithm>
#include <string>
#include <vector>

#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/json_text.h"

namespace tribolog::ingest::arrays {

inline bool is_number_or_gap(const JsonValue& value) {
  return value.kind == JsonKind::number || value.kind == JsonKind::null;
}
inline bool is_object(const JsonValue& value) { return value.kind == JsonKind::object; }
inline bool is_text(const JsonValue& value) { return value.kind == JsonKind::text; }

/// @param array or object.
inline bool all_are(const JsonValue& array, bool (*wanted)(const JsonValue&)) {
  return std::all_of(array.content->elements.begin(), array.content->elements.end(), wanted);
}

inline bool is_number_list(const JsonValue& value) {
  return value.kind == JsonKind::array && all_are(value, is_number_or_gap);
}

/// Whether it is a text that is a time.
bool is_iso_time(const JsonValue& value);

/// A number or a time; anything else is a gap.
void append_number(const JsonValue& value, NamedArray& array);

/// Numbers, times or words, a row each, as one array; what is several of these, or holds lists or
/// objects, is left out with the reason.
void add_column(const std::string& name, const std::vector<const JsonValue*>& values,
                FileArrays& found);

/// A column for each key of an array of objects, or of the objects in an object; a path leads to
/// those in objects within them, "stamp.sec". The numbers of a list are "elbow.position" where the
/// object names as many joints, else "position_0" and so on. A key in less than a sixteenth of the
/// rows is left out.
/// @param prefix in front of the names.
void add_records(const std::string& prefix, const JsonValue& records, FileArrays& found);

}  // namespace tribolog::ingest::arrays
