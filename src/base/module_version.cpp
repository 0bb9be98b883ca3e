#include "base/module_version.h"

const char* tribolog_module_version() { return TRIBOLOG_MODULE_VERSION; }
