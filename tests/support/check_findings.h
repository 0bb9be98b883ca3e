#pragma once
// What the checks on the data have to say of a dataset.

#include <string>
#include <vector>

#include "method/checks/data_check.h"

namespace tribolog::test {

/// The names of the checks that warn or fail, in order.
std::vector<std::string> findings_of(const method::checks::DataChecksResult& checks);

}  // namespace tribolog::test
