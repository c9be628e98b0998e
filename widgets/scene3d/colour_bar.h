// The scale of the colours at the right of the scene. Inside this folder only.
#pragma once

#include "widgets/scene3d/face_mesh.h"

#include <vtkNew.h>

class vtkLookupTable;
class vtkRenderer;
class vtkScalarBarActor;

namespace alltact {

class ColourBar {
 public:
  /// The renderer outlives it.
  explicit ColourBar(vtkRenderer* renderer);
  ~ColourBar();
  ColourBar(const ColourBar&) = delete;
  ColourBar& operator=(const ColourBar&) = delete;

  void show(bool is_shown);
  void set_scale(const ColourScale& scale);
  void dress(const cv::Vec3b& text);
  /// At the right, as wide as its letters need.
  void place(const int* window_px, double pixels_per_unit);
  /// Which part of the window's width stays free of it.
  [[nodiscard]] static double left_of_it(const int* window_px, double pixels_per_unit);

 private:
  vtkNew<vtkScalarBarActor> bar_;
  vtkNew<vtkLookupTable> colours_;
};

}  // namespace alltact
