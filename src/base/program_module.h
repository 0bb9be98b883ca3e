#pragma once
// Parts of the program that lie in libraries of their own and are loaded where they are first
// needed. What they stand on (a graphics stack, a database's client) is then needed there alone.

#include <stdexcept>
#include <string>

namespace tribolog {

struct ProgramModule {
  std::string name;      ///< "tribolog_vtk", of libtribolog_vtk.so
  std::string packages;  ///< Of the distribution, with the libraries that it stands on.
};

/// What a module cannot be loaded for, in one sentence: the library that is missing, and the
/// packages to install.
class MissingModule : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The address of a module's function, as dlsym() gives it. The module is looked for along the
/// program's RUNPATH, which names where the build, or the installation, has put it; once loaded it
/// stays. @throw MissingModule: also one of another version.
void* function_of(const ProgramModule& module, const char* function);

}  // namespace tribolog

// Program and modules of one build belong together: what they hand each other has no other check.

#define TRIBOLOG_MODULE_VERSION "tribolog module " TRIBOLOG_VERSION

/// Each module has one.
extern "C" __attribute__((visibility("default"))) const char* tribolog_module_version();
