#include "render/vtk/vtk_messages.h"

#include <algorithm>
#include <utility>

#include <vtkObjectFactory.h>

namespace tribolog::render {

vtkStandardNewMacro(VtkMessages);

void VtkMessages::DisplayErrorText(const char* text) {
  if (!first_error_.empty() || text == nullptr) return;
  first_error_ = text;
  std::replace_if(
      first_error_.begin(), first_error_.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  first_error_ = first_error_.substr(0, 300);
}

// Nothing below an error changes a picture.
void VtkMessages::DisplayText(const char*) {}
void VtkMessages::DisplayWarningText(const char*) {}
void VtkMessages::DisplayGenericWarningText(const char*) {}

std::string VtkMessages::take_error() { return std::exchange(first_error_, {}); }

}  // namespace tribolog::render
