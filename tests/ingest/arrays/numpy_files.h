#pragma once
// Files that NumPy writes, and NumPy files by hand.

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "base/temporary_directory.h"

namespace tribolog::test {

/// A .npy file. @param descr as it stands behind 'descr': "'<f8'" or a list of fields.
inline std::string npy(const std::string& descr, const std::string& shape,
                       const std::string& values, bool fortran = false, int version = 1) {
  const std::string text = "{'descr': " + descr +
                           ", 'fortran_order': " + (fortran ? "True" : "False") +
                           ", 'shape': " + shape + ", }\n";
  std::string bytes = std::string("\x93NUMPY") + static_cast<char>(version) + '\0';
  for (int k = 0; k < (version == 1 ? 2 : 4); ++k) {
    bytes += static_cast<char>((text.size() >> (8 * k)) & 0xff);
  }
  return bytes + text + values;
}

/// A Python with NumPy, or "" where there is none.
inline std::string python_with_numpy() {
  for (const std::string python : {"python3", "/usr/bin/python3"}) {
    if (std::system((python + " -c 'import numpy' 2>/dev/null").c_str()) == 0) return python;
  }
  return "";
}

class NumpyFiles : public testing::Test {
 protected:
  void SetUp() override {
    python_ = python_with_numpy();
    ASSERT_FALSE(python_.empty()) << "there is no Python with NumPy; ./setup.sh tests installs it";
  }
  /// Runs lines of Python in the directory, with numpy as np.
  void run(const std::string& lines) {
    const std::string script = directory_.file("make.py", "import numpy as np\n" + lines);
    ASSERT_EQ(std::system(("cd " + directory_.path() + " && " + python_ + " " + script).c_str()),
              0);
  }
  TemporaryDirectory directory_;
  std::string python_;
};

}  // namespace tribolog::test
