#pragma once
// VTK's device for 2D, and triangles of which each corner has a colour of its own: VTK draws them
// itself, but offers them only by way of a vtkPolyData that it reads cell by cell.

#include <vector>

#include <vtkObjectFactory.h>
#include <vtkOpenGLContextDevice2D.h>

namespace tribolog::render::vtk {

class TriangleDevice : public vtkOpenGLContextDevice2D {
 public:
  static TriangleDevice* New() { VTK_STANDARD_NEW_BODY(TriangleDevice); }
  vtkTypeMacro(TriangleDevice, vtkOpenGLContextDevice2D)

      /// @param corners x and y of each, three to a triangle
      /// @param colours red, green, blue and alpha of each corner
      void draw_triangles(std::vector<float>& corners, std::vector<unsigned char>& colours) {
    CoreDrawTriangles(corners, colours.data(), 4);
  }

  TriangleDevice(const TriangleDevice&) = delete;
  TriangleDevice& operator=(const TriangleDevice&) = delete;

 protected:
  TriangleDevice() = default;
  ~TriangleDevice() override = default;
};

}  // namespace tribolog::render::vtk
