// VTK up to 9.3 asks GLX for OpenGL functions, by way of GLEW. This shared library answers in
// its place, so that the functions of the off-screen back end are found and no X server is needed.

#include "render/paint/glx_forwarder.h"

#include <GL/osmesa.h>

#define EXPORTED __attribute__((visibility("default")))

extern "C" EXPORTED void (*glXGetProcAddressARB(const unsigned char* name))() {
  return reinterpret_cast<void (*)()>(OSMesaGetProcAddress(reinterpret_cast<const char*>(name)));
}

extern "C" EXPORTED void* tribolog_osmesa_function(const char* name) {
  return reinterpret_cast<void*>(OSMesaGetProcAddress(name));
}
