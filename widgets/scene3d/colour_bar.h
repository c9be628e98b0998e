// The colour scale at the right of the scene. Inside this folder only.
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
  void apply_style(const cv::Vec3b& text);
  /// At the right, as wide as its letters need.
  void set_position(const int* window_px, double pixels_per_unit);
  /// Fraction of the window's width that stays free of it.
  [[nodiscard]] static double free_fraction(const int* window_px, double pixels_per_unit);

 private:
  vtkNew<vtkScalarBarActor> bar_;
  vtkNew<vtkLookupTable> colours_;
};

}  // namespace alltact
