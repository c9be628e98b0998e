#include "widgets/scene3d/finger_actors.h"

#include "widgets/scene3d/face_grid.h"
#include "widgets/scene3d/scene_lines.h"

#include <cmath>

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace alltact {
namespace {

constexpr int kGhostLines = 6;  // along the shorter side of the grid
constexpr double kAxis_mm = 9;

Eigen::Vector3d to_eigen(const cv::Vec3f& p) {
  return {p[0], p[1], p[2]};
}

vtkSmartPointer<vtkMatrix4x4> matrix_of(const RigidTransform& transform) {
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  const Eigen::Matrix3d turn = transform.rotation.normalized().toRotationMatrix();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, turn(row, column));
    matrix->SetElement(row, 3, transform.translation_mm[row]);
  }
  return matrix;
}

}  // namespace

FingerActors::FingerActors(vtkRenderer* renderer)
    : ghost_(line_actor(ghost_lines_, 25)),
      camera_(line_actor(camera_lines_, 0)),
      body_actors_(renderer),
      ruler_(renderer),
      axes_(renderer, kAxis_mm) {
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh_.data());
  mapper->SetColorModeToDirectScalars();
  mapper->StaticOn();  // there is no upstream filter
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 2);
  face_->SetMapper(mapper);
  face_->GetProperty()->SetAmbient(kFaceAmbient);
  face_->GetProperty()->SetDiffuse(1.0);
  face_->GetProperty()->SetSpecular(0.0);
  for (vtkActor* actor : {face_.Get(), ghost_.Get(), camera_.Get()}) renderer->AddActor(actor);
  hide();
}

FingerActors::~FingerActors() = default;

void FingerActors::show(const FaceSurface& surface, const cv::Mat& other_mm) {
  surface_ = surface;
  other_mm_ = other_mm;
  body_ = body_of(surface);
  has_depth_ = cv::countNonZero(surface.depth_mm == surface.depth_mm) > 0;
  draw_face();
  draw_body();
  draw_ghost();
}

void FingerActors::hide() {
  surface_ = {};
  body_ = {};
  other_mm_ = cv::Mat();
  face_->VisibilityOff();
  draw_body();
  draw_ghost();
}

void FingerActors::set_options(const SceneOptions& options) {
  options_ = options;
  draw_face();
  draw_body();
  draw_ghost();
  show_camera(options.camera);
}

void FingerActors::show_camera(bool is_shown) {
  is_camera_shown_ = is_shown;
  camera_->SetVisibility(is_shown);
  axes_.show(is_shown);
}

void FingerActors::set_pose(const RigidTransform& scene_from_camera) {
  if (pose_ == scene_from_camera) return;
  pose_ = scene_from_camera;
  const auto matrix = matrix_of(pose_);
  for (vtkActor* actor : {face_.Get(), ghost_.Get(), camera_.Get()}) actor->SetUserMatrix(matrix);
  body_actors_.set_pose(matrix);
  axes_.set_pose(pose_);
}

void FingerActors::draw_camera(const Camera& camera) {
  const cv::Size size = camera.size();
  constexpr double kFar_mm = 8;
  const auto corner = camera.unproject({0, 0}),
             other = camera.unproject({size.width - 1.0, size.height - 1.0});
  std::vector<Polyline> lines;
  if (camera.is_perspective() && corner && other) {
    const Eigen::Vector3d a = corner->point_at(kFar_mm), b = other->point_at(kFar_mm);
    lines = camera_lines(0.5 * (b.x() - a.x()), 0.5 * (b.y() - a.y()), kFar_mm);
  }
  set_lines(camera_lines_, lines);
}

void FingerActors::apply_style(const SceneColours& colours, double pixels_per_unit) {
  ghost_->GetProperty()->SetColor(0.55, 0.55, 0.55);
  camera_->GetProperty()->SetColor(
      colours.text[0] / 255.0, colours.text[1] / 255.0, colours.text[2] / 255.0);
  for (const auto& actor : {ghost_, camera_})
    actor->GetProperty()->SetLineWidth(static_cast<float>(pixels_per_unit));
  body_actors_.apply_style(colours, pixels_per_unit);
  ruler_.apply_style(colours, pixels_per_unit);
  axes_.apply_style(pixels_per_unit);
}

ColourScale FingerActors::colours() const {
  return is_difference() ? difference_scale(options_.difference_top_mm)
                         : depth_scale(options_.top_mm);
}

void FingerActors::draw_face() {
  if (!is_shown()) return;
  const cv::Mat value = is_difference() ? surface_.depth_mm - other_mm_ : surface_.depth_mm;
  mesh_.update(surface_.untouched_mm,
               surface_.depth_mm,
               static_cast<float>(options_.exaggeration),
               value,
               colours());
  boxes_.reset();
  face_->VisibilityOn();
}

bool FingerActors::set_moving(bool is_moving, int max_vertices) {
  int stride = 1;
  while (is_moving && surface_.columns() * surface_.rows() / (stride * stride) > max_vertices)
    ++stride;
  return mesh_.set_stride(stride);
}

void FingerActors::draw_body() {
  const bool is_drawn = is_shown() && options_.body && !body_.sections.empty();
  if (is_drawn) body_actors_.draw(body_, surface_.markers);
  body_actors_.show(is_drawn);
  if (is_shown() && options_.ruler)
    ruler_.draw(surface_, has_depth_ ? options_.exaggeration : 0, pose_);
  else
    ruler_.hide();
}

void FingerActors::set_eye(const Eigen::Vector3d& eye) {
  if (!is_shown()) return;
  const auto middle_of = [this](const FingerBody::Section& section) {
    return pose_.point(0.25 * (section[0] + section[1] + section[2] + section[3]));
  };
  const cv::Mat& face = surface_.untouched_mm;
  const Eigen::Vector3d middle =
      pose_.point(to_eigen(face.at<cv::Vec3f>(face.rows / 2, face.cols / 2)));
  const bool is_outside = pose_.direction(inward()).dot(eye - middle) < 0;
  axes_.show(is_camera_shown_ && !is_outside);
  if (body_.sections.empty()) return;
  const Eigen::Vector3d end = middle_of(body_.base[0]);
  body_actors_.set_viewpoint(is_outside, (end - middle_of(body_.base[1])).dot(eye - end) > 0);
}

void FingerActors::draw_ghost() {
  ghost_->SetVisibility(options_.untouched && is_shown());
  if (!options_.untouched || !is_shown()) return;
  const int columns = surface_.columns(), rows = surface_.rows();
  const double step = static_cast<double>(std::min(columns, rows) - 1) / kGhostLines;
  std::vector<Polyline> lines;
  const int across = std::max(1, static_cast<int>(std::lround((columns - 1) / step)));
  for (int k = 0; k <= across; ++k) {
    const int i = k * (columns - 1) / across;
    Polyline& line = lines.emplace_back();
    for (int j = 0; j < rows; ++j)
      line.push_back(to_eigen(surface_.untouched_mm.at<cv::Vec3f>(j, i)));
  }
  const int along = std::max(1, static_cast<int>(std::lround((rows - 1) / step)));
  for (int k = 0; k <= along; ++k) {
    const int j = k * (rows - 1) / along;
    Polyline& line = lines.emplace_back();
    for (int i = 0; i < columns; ++i)
      line.push_back(to_eigen(surface_.untouched_mm.at<cv::Vec3f>(j, i)));
  }
  set_lines(ghost_lines_, lines);
}

std::vector<Eigen::Vector3d> FingerActors::outline(bool with_body) const {
  std::vector<Eigen::Vector3d> points;
  if (!is_shown()) return points;
  const cv::Mat& drawn = mesh_.drawn_mm();
  constexpr int kOfMany = 7;
  for (int j = 0; j < drawn.rows; j += j + kOfMany < drawn.rows ? kOfMany : 1)
    for (int i = 0; i < drawn.cols; i += i + kOfMany < drawn.cols ? kOfMany : 1)
      points.push_back(pose_.point(to_eigen(drawn.at<cv::Vec3f>(j, i))));
  if (!with_body) return points;
  const auto add = [&](const Eigen::Vector3d& point) { points.push_back(pose_.point(point)); };
  if (options_.body)
    for (const Eigen::Vector3d& corner : body_.corners()) add(corner);
  points.insert(points.end(), ruler_.corners().begin(), ruler_.corners().end());
  if (options_.camera) add({0, 0, 0});
  return points;
}

Eigen::Vector3d FingerActors::inward() const {
  if (!is_shown()) return {0, 0, -1};
  return inward_normal(surface_.untouched_mm, surface_.columns() / 2, surface_.rows() / 2);
}

std::optional<FingerActors::Hit> FingerActors::hit(const Eigen::Vector3d& from,
                                                   const Eigen::Vector3d& direction) const {
  if (!is_shown()) return std::nullopt;
  const RigidTransform back = pose_.inverse();
  if (!boxes_) boxes_.emplace(mesh_.drawn_mm());
  const auto set_pose = boxes_->first_hit(back.point(from), back.direction(direction));
  if (!set_pose) return std::nullopt;
  const cv::Vec2f pixel = pixel_between(surface_.pixel, *set_pose);
  const Eigen::Vector3d at = pose_.point(to_eigen(point_between(mesh_.drawn_mm(), *set_pose)));
  return Hit{{pixel[0], pixel[1]}, (at - from).dot(direction) / direction.squaredNorm()};
}

std::optional<Eigen::Vector3d> FingerActors::point_of(cv::Point2d pixel) const {
  if (!is_shown()) return std::nullopt;
  const auto set_pose = grid_position_of(surface_, pixel);
  if (!set_pose) return std::nullopt;
  return pose_.point(to_eigen(point_between(mesh_.drawn_mm(), *set_pose)));
}

}  // namespace alltact
