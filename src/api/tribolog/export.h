#pragma once
// What the shared library exports; everything else in it is hidden.

#if defined(__GNUC__)
#define TRIBOLOG_EXPORT __attribute__((visibility("default")))
#define TRIBOLOG_HIDDEN __attribute__((visibility("hidden")))
#else
#define TRIBOLOG_EXPORT
#define TRIBOLOG_HIDDEN
#endif
