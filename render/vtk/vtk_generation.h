#pragma once
// VTK up to 9.3 finds OpenGL functions with GLEW, later ones with a loader that may be set.

#include <vtkVersionMacros.h>

#if VTK_MAJOR_VERSION < 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 4)
#define TRIBOLOG_VTK_HAS_GLEW 1
#else
#define TRIBOLOG_VTK_HAS_GLEW 0
#endif
