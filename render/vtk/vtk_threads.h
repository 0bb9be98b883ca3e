#pragma once
// VTK's own threads.

namespace tribolog::render::vtk {

/// VTK computes in the caller's thread from now on. A process with more threads than one cannot be
/// forked safely, and here processes share the work.
void keep_vtk_to_one_thread();

}  // namespace tribolog::render::vtk
