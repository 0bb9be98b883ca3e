#pragma once
// Whether a variable of a MAT 5 file holds what its header claims.

#include <string>

#include "ingest/arrays/mat_stream.h"

namespace tribolog {

/// Walks a variable and all within it, from its own tag on. The library makes room for what the
/// headers claim, and gives zeros for what is not there.
/// @return "", or what is wrong with it: fewer values than its sides claim, a part longer than what
///         holds it, no array, nested too deeply.
std::string check_mat_matrix(MatStream& stream, bool big_endian);

}  // namespace tribolog
