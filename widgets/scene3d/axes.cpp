#include "widgets/scene3d/axes.h"

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

constexpr std::array<std::array<double, 3>, 3> kColours{
    {{0.84, 0.37, 0.0}, {0.0, 0.62, 0.45}, {0.0, 0.45, 0.70}}};
constexpr double kBeyond = 1.15;  // position of the letters, in axis lengths

}  // namespace

Axes::Axes(vtkRenderer* renderer, double length_mm) : length_mm_(length_mm) {
  for (std::size_t i = 0; i < 3; ++i) {
    actors_[i] = line_actor(lines_[i], 0);
    actors_[i]->GetProperty()->SetColor(kColours[i][0], kColours[i][1], kColours[i][2]);
    vtkTextProperty* text = names_[i]->GetTextProperty();
    text->SetColor(kColours[i][0], kColours[i][1], kColours[i][2]);
    text->SetBold(true);
    text->SetJustificationToCentered();
    text->SetVerticalJustificationToCentered();
    names_[i]->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    renderer->AddActor(actors_[i]);
    renderer->AddActor2D(names_[i]);
  }
  set_names({"x", "y", "z"});
  set_pose({});
}

Axes::~Axes() = default;

void Axes::set_names(const std::array<std::string, 3>& names) {
  for (std::size_t i = 0; i < 3; ++i) names_[i]->SetInput(names[i].c_str());
}

void Axes::set_pose(const RigidTransform& scene_from_frame) {
  pose_ = scene_from_frame;
  const auto points = corners();
  for (std::size_t i = 0; i < 3; ++i) {
    set_lines(lines_[i], {{points[0], points[i + 1]}});
    const Eigen::Vector3d letter = points[0] + kBeyond * (points[i + 1] - points[0]);
    names_[i]->GetPositionCoordinate()->SetValue(letter.x(), letter.y(), letter.z());
  }
}

void Axes::show(bool is_shown) {
  for (std::size_t i = 0; i < 3; ++i) {
    actors_[i]->SetVisibility(is_shown);
    names_[i]->SetVisibility(is_shown);
  }
}

void Axes::apply_style(double pixels_per_unit) {
  for (std::size_t i = 0; i < 3; ++i) {
    actors_[i]->GetProperty()->SetLineWidth(static_cast<float>(3 * pixels_per_unit));
    names_[i]->GetTextProperty()->SetFontSize(kLetterPoints + 2);
  }
}

std::vector<Eigen::Vector3d> Axes::corners() const {
  std::vector<Eigen::Vector3d> points{pose_.translation_mm};
  for (int i = 0; i < 3; ++i) points.push_back(pose_.point(length_mm_ * Eigen::Vector3d::Unit(i)));
  return points;
}

}  // namespace alltact
