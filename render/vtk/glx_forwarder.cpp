// VTK up to 9.3 asks GLX for OpenGL functions, by way of GLEW. The module answers in its place, as
// it stands first where the libraries below it look names up: so the functions of the off-screen
// back end are found and no X server is needed.

#include <GL/osmesa.h>

extern "C" __attribute__((visibility("default"))) void (
    *glXGetProcAddressARB(const unsigned char* name))() {
  return reinterpret_cast<void (*)()>(OSMesaGetProcAddress(reinterpret_cast<const char*>(name)));
}
