#pragma once
// What became of the rows of the logs, in lines to be said.

#include <string>
#include <vector>

#include "joint/dataset.h"

namespace tribolog {

/// One line for each reason why rows were skipped, and one with all rows read and used. A log that
/// several recordings are cut from is counted once; of it, it is said how many of its rows are in
/// no recording, if any.
std::vector<std::string> row_accounts(const std::vector<InputFile>& inputs);

}  // namespace tribolog
