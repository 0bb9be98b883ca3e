#pragma once
// Python's standard tools judge our files: independent readers of HTML and JSON.

#include <optional>
#include <string>

namespace tribolog::test {

/// Is there a python3 with this module?
bool has_python_module(const std::string& module);

/// Runs a program text with `input` as its file argument; what it prints, or nullopt if it fails.
std::optional<std::string> run_python(const std::string& program, const std::string& input);

}  // namespace tribolog::test
