#pragma once
// The shared library that stands in for GLX. Calling it by its own name keeps linkers from leaving
// it out as unneeded.

/// The address of an OpenGL function of OSMesa, or null.
extern "C" void* tribolog_osmesa_function(const char* name);
