// Points and lines that the user set on a face. Inside this folder only.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

namespace alltact {

class MarkActors {
 public:
  /// The renderer outlives them.
  explicit MarkActors(vtkRenderer* renderer);
  ~MarkActors();
  MarkActors(const MarkActors&) = delete;
  MarkActors& operator=(const MarkActors&) = delete;

  struct Point {
    std::size_t letter;  ///< 0: A, 1: B
    Eigen::Vector3d at;
  };
  void draw(const std::vector<Point>& points,
            const std::vector<std::vector<Eigen::Vector3d>>& lines);
  void apply_style(double pixels_per_unit);

 private:
  vtkNew<vtkPolyData> line_data_, point_data_;
  vtkSmartPointer<vtkActor> lines_, points_;
  std::array<vtkNew<vtkTextActor>, 2> names_;
};

}  // namespace alltact
