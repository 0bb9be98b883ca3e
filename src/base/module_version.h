#pragma once
// Program and modules of one build belong together: what they hand each other has no other check.

#define TRIBOLOG_MODULE_VERSION "tribolog module " TRIBOLOG_VERSION

/// Each module has one.
extern "C" __attribute__((visibility("default"))) const char* tribolog_module_version();
