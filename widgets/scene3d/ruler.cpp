#include "widgets/scene3d/ruler.h"

#include "widgets/scene3d/scene_lines.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCoordinate.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace alltact {
namespace {

constexpr double kTick_mm = 1.5, kLongTick_mm = 2.8, kText_mm = 5.0, kTickEvery_mm = 10;

Eigen::Vector3d grid_vertex(const cv::Mat& grid, int row, int column) {
  const auto& p = grid.at<cv::Vec3f>(row, column);
  return {p[0], p[1], p[2]};
}

}  // namespace

double stick_height_mm(double exaggeration, double longest_mm) {
  double height_mm = 0.01;
  for (double unit = 0.01; unit < 1000; unit *= 10)
    for (const double step : {1.0, 2.0, 5.0})
      if (step * unit * exaggeration <= longest_mm) height_mm = step * unit;
  return height_mm;
}

Ruler::Ruler(vtkRenderer* renderer) : lines_(line_actor(data_, 15)) {
  renderer->AddActor(lines_);
  for (const auto& text : texts_) {
    text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    text->GetTextProperty()->SetJustificationToCentered();
    text->GetTextProperty()->SetVerticalJustificationToCentered();
    renderer->AddActor2D(text);
  }
  hide();
}

Ruler::~Ruler() = default;

void Ruler::hide() {
  lines_->VisibilityOff();
  for (const auto& text : texts_) text->VisibilityOff();
  written_ = 0;
  corners_.clear();
}

void Ruler::write(const Eigen::Vector3d& at, const std::string& text) {
  if (written_ >= texts_.size()) return;
  vtkTextActor* actor = texts_[written_++];
  actor->SetInput(text.c_str());
  actor->GetPositionCoordinate()->SetValue(at.x(), at.y(), at.z());
  actor->VisibilityOn();
  corners_.push_back(at);
}

void Ruler::draw(const FaceSurface& surface,
                 double exaggeration,
                 const RigidTransform& scene_from_camera) {
  hide();
  const cv::Mat& face = surface.untouched_mm;
  const auto& along = surface.along_mm;
  if (along.size() != static_cast<std::size_t>(face.cols)) return;
  const int last_row = face.rows - 1;
  const auto [least, most] = std::minmax_element(along.begin(), along.end());
  const double every_mm = *most - *least > 150 ? 50 : 20;
  std::vector<Polyline> lines;
  for (int i = 1; i < face.cols; ++i) {
    const double low = std::min(along[i - 1], along[i]), top = std::max(along[i - 1], along[i]);
    const double mark = kTickEvery_mm * std::ceil(low / kTickEvery_mm - 1e-9);
    const bool is_first = i == 1 && std::abs(along[0] - mark) < 1e-9;
    if (!(mark > low || is_first) || mark > top || top <= low) continue;
    const double part = std::abs(mark - along[i - 1]) / (top - low);
    const auto between = [&](int row) -> Eigen::Vector3d {
      return (1 - part) * grid_vertex(face, row, i - 1) + part * grid_vertex(face, row, i);
    };
    const Eigen::Vector3d edge = between(0);
    const Eigen::Vector3d out = (edge - between(last_row)).normalized();
    const bool is_long = std::abs(std::remainder(mark, every_mm)) < 1e-6;
    const auto to_scene = [&](double out_mm) {
      return scene_from_camera.point(edge + out_mm * out);
    };
    lines.push_back({to_scene(0.3), to_scene(is_long ? kLongTick_mm : kTick_mm)});
    if (is_long) write(to_scene(kText_mm), fmt::format("{:.0f}", mark + 0.0));
  }
  if (exaggeration > 0) draw_stick(surface, exaggeration, scene_from_camera, lines);
  set_lines(data_, lines);
  lines_->VisibilityOn();
}

/// At the tip's end of the ticked edge.
void Ruler::draw_stick(const FaceSurface& surface,
                       double exaggeration,
                       const RigidTransform& scene_from_camera,
                       std::vector<std::vector<Eigen::Vector3d>>& lines) {
  const cv::Mat& face = surface.untouched_mm;
  const auto& along = surface.along_mm;
  const int last_row = face.rows - 1;
  const int tip = along.front() <= along.back() ? face.cols - 1 : 0;
  const Eigen::Vector3d corner = grid_vertex(face, 0, tip),
                        other = grid_vertex(face, last_row, tip);
  const Eigen::Vector3d out = (corner - other).normalized();
  const double height_mm = stick_height_mm(exaggeration, 0.3 * (corner - other).norm());
  const int inner = tip == 0 ? face.cols / 8 : face.cols - 1 - face.cols / 8;
  // A little inside, so that its text ends where the finger ends.
  const Eigen::Vector3d back = (grid_vertex(face, 0, inner) - corner).normalized();
  const Eigen::Vector3d foot = corner + 2.0 * kText_mm * out + 2.5 * kText_mm * back;
  const Eigen::Vector3d head = foot - Eigen::Vector3d(0, 0, exaggeration * height_mm);
  const Eigen::Vector3d serif = 0.6 * out;
  const auto to_scene = [&](const Eigen::Vector3d& p) { return scene_from_camera.point(p); };
  lines.push_back({to_scene(foot), to_scene(head)});
  for (const Eigen::Vector3d& end : {foot, head})
    lines.push_back({to_scene(end - serif), to_scene(end + serif)});
  write(to_scene(foot + 0.8 * kText_mm * out),
        exaggeration == 1 ? fmt::format("{:g} mm", height_mm)
                          : fmt::format("{:g} mm \u00d7{:g}", height_mm, exaggeration));
}

void Ruler::apply_style(const SceneColours& colours, double pixels_per_unit) {
  constexpr double kTextPart = 0.75;
  double mixed[3];
  for (int i = 0; i < 3; ++i)
    mixed[i] = ((1 - kTextPart) * colours.ground[i] + kTextPart * colours.text[i]) / 255.0;
  lines_->GetProperty()->SetColor(mixed);
  lines_->GetProperty()->SetLineWidth(static_cast<float>(1.2 * pixels_per_unit));
  for (const auto& text : texts_) {
    text->GetTextProperty()->SetColor(mixed);
    text->GetTextProperty()->SetFontSize(kLetterPoints - 1);
  }
}

}  // namespace alltact
