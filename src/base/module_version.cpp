#include "base/program_module.h"

const char* tribolog_module_version() { return TRIBOLOG_MODULE_VERSION; }
