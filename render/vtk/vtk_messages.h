#pragma once
// Keeps what VTK has to say, instead of letting it print.

#include <string>

#include <vtkOutputWindow.h>

namespace tribolog::render {

class VtkMessages : public vtkOutputWindow {
 public:
  static VtkMessages* New();
  vtkTypeMacro(VtkMessages, vtkOutputWindow)

      void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayDebugText(const char*) override {}

  /// First error since the last call, on one line; empty if there was none.
  std::string take_error();

  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

 protected:
  VtkMessages() = default;
  ~VtkMessages() override = default;

 private:
  std::string first_error_;
};

}  // namespace tribolog::render
