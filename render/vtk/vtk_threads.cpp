// Compiled as C++17: a header of VTK 9.1 names constructors in a way that C++20 has done away with.
#include <vtkSMPTools.h>

#include "render/vtk/headless_window.h"

namespace tribolog::render::vtk {

void keep_vtk_to_one_thread() { vtkSMPTools::SetBackend("Sequential"); }

}  // namespace tribolog::render::vtk
