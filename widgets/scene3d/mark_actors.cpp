#include "widgets/scene3d/mark_actors.h"

#include "widgets/scene3d/scene_lines.h"

#include <vtkActor.h>
#include <vtkCoordinate.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace alltact {
namespace {

constexpr double kMark[3] = {1.0, 0.72, 0.0};

}  // namespace

MarkActors::MarkActors(vtkRenderer* renderer)
    : lines_(line_actor(line_data_, 60)), points_(line_actor(point_data_, 60)) {
  points_->GetProperty()->SetRenderPointsAsSpheres(true);
  for (const auto& actor : {lines_, points_}) {
    actor->GetProperty()->SetColor(kMark[0], kMark[1], kMark[2]);
    renderer->AddActor(actor);
  }
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const char name[] = {' ', ' ', static_cast<char>('A' + i), '\0'};
    names_[i]->SetInput(name);
    names_[i]->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    names_[i]->GetTextProperty()->SetBold(true);
    names_[i]->GetTextProperty()->SetColor(kMark[0], kMark[1], kMark[2]);
    names_[i]->GetTextProperty()->SetShadow(true);
    names_[i]->VisibilityOff();
    renderer->AddActor2D(names_[i]);
  }
}

MarkActors::~MarkActors() = default;

void MarkActors::draw(const std::vector<Point>& points,
                      const std::vector<std::vector<Eigen::Vector3d>>& lines) {
  std::vector<Eigen::Vector3d> positions;
  for (const auto& name : names_) name->VisibilityOff();
  for (const Point& point : points) {
    positions.push_back(point.at);
    if (point.letter >= names_.size()) continue;
    names_[point.letter]->VisibilityOn();
    names_[point.letter]->GetPositionCoordinate()->SetValue(
        point.at.x(), point.at.y(), point.at.z());
  }
  set_points(point_data_, positions);
  set_lines(line_data_, lines);
}

void MarkActors::apply_style(double pixels_per_unit) {
  lines_->GetProperty()->SetLineWidth(static_cast<float>(3 * pixels_per_unit));
  points_->GetProperty()->SetPointSize(static_cast<float>(12 * pixels_per_unit));
  for (const auto& name : names_) name->GetTextProperty()->SetFontSize(kLetterPoints + 3);
}

}  // namespace alltact
