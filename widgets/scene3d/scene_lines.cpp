#include "widgets/scene3d/scene_lines.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace alltact {

void set_lines(vtkPolyData* data, const std::vector<Polyline>& lines) {
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> cells;
  for (const Polyline& line : lines) {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Eigen::Vector3d& at : line)
      cells->InsertCellPoint(points->InsertNextPoint(at.x(), at.y(), at.z()));
  }
  data->SetPoints(points);
  data->SetLines(cells);
}

void set_points(vtkPolyData* data, const std::vector<Eigen::Vector3d>& positions) {
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> cells;
  for (const Eigen::Vector3d& at : positions) {
    const vtkIdType id = points->InsertNextPoint(at.x(), at.y(), at.z());
    cells->InsertNextCell(1, &id);
  }
  data->SetPoints(points);
  data->SetVerts(cells);
}

vtkSmartPointer<vtkActor> line_actor(vtkPolyData* data, double nearer) {
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  if (nearer > 0) {
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -nearer);
    mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-10 * nearer);
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

std::vector<Polyline> camera_lines(double half_x_mm, double half_y_mm, double far_mm) {
  const Eigen::Vector3d eye(0, 0, 0);
  const Eigen::Vector3d a(-half_x_mm, -half_y_mm, far_mm), b(half_x_mm, -half_y_mm, far_mm);
  const Eigen::Vector3d c(half_x_mm, half_y_mm, far_mm), d(-half_x_mm, half_y_mm, far_mm);
  return {{a, b, c, d, a}, {eye, a}, {eye, b}, {eye, c}, {eye, d}};
}

}  // namespace alltact
