#include "base/program_module.h"

#include <string_view>

#include <dlfcn.h>

namespace tribolog {
namespace {

/// "libOSMesa.so.8: cannot open shared object file: No such file or directory" and the like.
[[noreturn]] void refuse(const ProgramModule& module, const std::string& file,
                         const std::string& reason) {
  const std::string missing = reason.substr(0, reason.find(':'));
  if (reason.find("cannot open shared object file") == std::string::npos) {
    throw MissingModule(file + " cannot be loaded: " + reason);
  }
  if (missing == file) throw MissingModule(file + " is missing; install tribolog again");
  throw MissingModule(missing + " is missing; install the packages " + module.packages);
}

}  // namespace

void* function_of(const ProgramModule& module, const char* function) {
  const std::string file = "lib" + module.name + ".so";
  void* const library = dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) refuse(module, file, dlerror());
  const auto version = reinterpret_cast<decltype(&tribolog_module_version)>(
      dlsym(library, "tribolog_module_version"));
  void* const found = dlsym(library, function);
  if (version == nullptr || std::string_view(version()) != TRIBOLOG_MODULE_VERSION ||
      found == nullptr) {
    throw MissingModule(file + " is of another version; install tribolog again");
  }
  return found;
}

}  // namespace tribolog
