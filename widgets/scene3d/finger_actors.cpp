#include "widgets/scene3d/finger_actors.h"

#include "widgets/scene3d/face_surface.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace alltact {
namespace {

constexpr int kGhostLines = 6;  // along the shorter side of the grid
constexpr double kAxis_mm = 9;

Eigen::Vector3d to_eigen(const cv::Vec3f& p) { return {p[0], p[1], p[2]}; }

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
  face_->GetProperty()->LightingOff();  // the mesh's colours contain it
  for (vtkActor* actor : {face_.Get(), ghost_.Get(), camera_.Get()}) renderer->AddActor(actor);
  hide();
}

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
  camera_->GetProperty()->SetColor(colours.text[0] / 255.0, colours.text[1] / 255.0,
                                   colours.text[2] / 255.0);
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
  mesh_.update(surface_.untouched_mm, surface_.depth_mm, static_cast<float>(options_.exaggeration),
               value, colours());
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

namespace {

constexpr double kSeen[3] = {0.34, 0.71, 0.91}, kGuessed[3] = {0.60, 0.60, 0.60};

/// Draws without a depth of its own, so that what is drawn later is never behind it.
class GlassMapper : public vtkOpenGLPolyDataMapper {
 public:
  static GlassMapper* New() {
    auto* mapper = new GlassMapper;
    mapper->InitializeObjectBase();
    return mapper;
  }
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override {
    vtkOpenGLState* gl =
        static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
    gl->vtkglDepthMask(false);
    vtkOpenGLPolyDataMapper::RenderPiece(renderer, actor);
    gl->vtkglDepthMask(true);
  }
};

vtkSmartPointer<vtkActor> body_actor(vtkPolyData* data, vtkPolyDataMapper* mapper) {
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 2);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.45);
  actor->GetProperty()->SetDiffuse(0.55);
  actor->GetProperty()->SetSpecular(0);
  return actor;
}

vtkSmartPointer<vtkActor> wall_actor(vtkPolyData* data, double opacity) {
  auto actor = body_actor(data, vtkNew<GlassMapper>());
  actor->GetProperty()->SetAmbient(0.7);
  actor->GetProperty()->SetDiffuse(0.3);
  actor->GetProperty()->SetOpacity(opacity);
  // Blended in the order of drawing: the passes for sorted translucency cost a full window, which
  // are slow in software.
  actor->ForceOpaqueOn();
  return actor;
}

/// Between the corners a and b of neighbouring sections; counterclockwise from outside where
/// `is_outward` is the grid's own handedness.
class Quads {
 public:
  vtkIdType add(const Eigen::Vector3d& at) {
    return points_->InsertNextPoint(at.x(), at.y(), at.z());
  }
  void quad(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d) {
    polys_->InsertNextCell({a, b, c, d});
  }
  void put_into(vtkPolyData* data) {
    data->SetPoints(points_);
    data->SetPolys(polys_);
  }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> polys_;
};

/// True where the section's corners go round counterclockwise as seen from `next`.
bool goes_round_towards(const FingerBody::Section& section, const FingerBody::Section& next) {
  const Eigen::Vector3d round = (section[1] - section[0]).cross(section[2] - section[1]);
  return round.dot(next[0] - section[0]) > 0;
}

/// The walls between sections, outer sides counterclockwise; `with_face`: the face's side as well.
void add_walls(Quads& quads, const std::vector<FingerBody::Section>& sections, bool with_face,
               bool with_first_end) {
  if (sections.size() < 2) return;
  std::vector<std::array<vtkIdType, 4>> ids;
  for (const FingerBody::Section& section : sections)
    ids.push_back({quads.add(section[0]), quads.add(section[1]), quads.add(section[2]),
                   quads.add(section[3])});
  const bool is_round = goes_round_towards(sections[0], sections[1]);
  const auto quad = [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d) {
    is_round ? quads.quad(a, b, c, d) : quads.quad(d, c, b, a);
  };
  for (std::size_t k = 0; k + 1 < ids.size(); ++k)
    for (std::size_t side = with_face ? 0 : 1; side < 4; ++side) {
      const std::size_t next = (side + 1) % 4;
      quad(ids[k][side], ids[k][next], ids[k + 1][next], ids[k + 1][side]);
    }
  const auto& tip = ids.back();
  quad(tip[0], tip[1], tip[2], tip[3]);
  if (with_first_end) quad(ids[0][3], ids[0][2], ids[0][1], ids[0][0]);
}

void mix(vtkActor* actor, const SceneColours& colours, double text_part) {
  double mixed[3];
  for (int i = 0; i < 3; ++i)
    mixed[i] = ((1 - text_part) * colours.ground[i] + text_part * colours.text[i]) / 255.0;
  actor->GetProperty()->SetColor(mixed);
}

}  // namespace

BodyActors::BodyActors(vtkRenderer* renderer)
    : far_walls_(wall_actor(walls_data_, 0.45)),
      near_walls_(wall_actor(walls_data_, 0.2)),
      base_(body_actor(base_data_, vtkNew<vtkPolyDataMapper>())),
      edges_(line_actor(edges_data_, 15)),
      back_(line_actor(back_data_, 15)),
      seen_(line_actor(seen_data_, 15)),
      guessed_(line_actor(guessed_data_, 15)) {
  for (const auto& dots : {seen_, guessed_}) dots->GetProperty()->SetRenderPointsAsSpheres(true);
  seen_->GetProperty()->SetColor(kSeen[0], kSeen[1], kSeen[2]);
  guessed_->GetProperty()->SetColor(kGuessed[0], kGuessed[1], kGuessed[2]);
  far_walls_->GetProperty()->FrontfaceCullingOn();
  near_walls_->GetProperty()->BackfaceCullingOn();
  base_->GetProperty()->BackfaceCullingOn();
  for (vtkActor* actor : all()) renderer->AddActor(actor);
  set_viewpoint(false, false);
}

std::array<vtkActor*, 7> BodyActors::all() const {
  return {far_walls_, near_walls_, base_, edges_, back_, seen_, guessed_};
}

void BodyActors::draw(const FingerBody& body, const std::vector<SurfaceMarker>& markers) {
  Quads walls, base;
  add_walls(walls, body.sections, false, false);
  if (!body.sections.empty()) add_walls(base, {body.base[0], body.base[1]}, true, true);
  walls.put_into(walls_data_);
  base.put_into(base_data_);
  std::vector<Polyline> edges, back;
  if (!body.sections.empty()) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      Polyline& line = (corner < 2 ? edges : back).emplace_back();
      for (const auto& section : body.sections) line.push_back(section[corner]);
    }
    for (const auto* end : {&body.sections.front(), &body.sections.back()}) {
      edges.push_back({(*end)[0], (*end)[1]});
      back.push_back({(*end)[1], (*end)[2], (*end)[3], (*end)[0]});
    }
  }
  set_lines(edges_data_, edges);
  set_lines(back_data_, back);
  std::vector<Eigen::Vector3d> seen, guessed;
  for (const SurfaceMarker& marker : markers)
    (marker.is_seen ? seen : guessed).push_back(marker.at_mm);
  set_points(seen_data_, seen);
  set_points(guessed_data_, guessed);
}

void BodyActors::show(bool is_shown) {
  is_shown_ = is_shown;
  for (vtkActor* actor : all()) actor->SetVisibility(is_shown);
  show_parts();
}

void BodyActors::show_parts() {
  back_->SetVisibility(is_shown_ && is_outside_);
  base_->SetVisibility(is_shown_ && !is_behind_base_);
}

void BodyActors::set_pose(vtkMatrix4x4* scene_from_camera) {
  for (vtkActor* actor : all()) actor->SetUserMatrix(scene_from_camera);
}

void BodyActors::apply_style(const SceneColours& colours, double pixels_per_unit) {
  constexpr double kWalls = 0.4, kBase = 0.34, kEdges = 0.55;
  for (const auto& walls : {far_walls_, near_walls_}) {
    mix(walls, colours, kWalls);
    const Eigen::Vector3d silicone(0.44, 0.62, 0.74);
    const Eigen::Vector3d tinted =
        0.5 * (Eigen::Vector3d(walls->GetProperty()->GetColor()) + silicone);
    walls->GetProperty()->SetColor(tinted.x(), tinted.y(), tinted.z());
  }
  mix(base_, colours, kBase);
  for (const auto& lines : {edges_, back_}) {
    mix(lines, colours, kEdges);
    lines->GetProperty()->SetLineWidth(static_cast<float>(1.2 * pixels_per_unit));
  }
  for (const auto& dots : {seen_, guessed_})
    dots->GetProperty()->SetPointSize(static_cast<float>(9 * pixels_per_unit));
}

void BodyActors::set_viewpoint(bool is_outside, bool is_behind_base) {
  is_outside_ = is_outside;
  is_behind_base_ = is_behind_base;
  show_parts();
}

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

void Ruler::hide() {
  lines_->VisibilityOff();
  for (const auto& text : texts_) text->VisibilityOff();
  written_ = 0;
  corners_.clear();
}

void Ruler::write(const Eigen::Vector3d& at, const std::string& text) {
  if (written_ >= texts_.size()) return;
  vtkTextActor* actor = texts_[written_++];
  std::string written = text;
  std::replace(written.begin(), written.end(), '.', decimal_mark_);
  actor->SetInput(written.c_str());
  actor->GetPositionCoordinate()->SetValue(at.x(), at.y(), at.z());
  actor->VisibilityOn();
  corners_.push_back(at);
}

void Ruler::draw(const FaceSurface& surface, double exaggeration,
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
void Ruler::draw_stick(const FaceSurface& surface, double exaggeration,
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
    std::string written = text->GetInput() != nullptr ? text->GetInput() : "";
    std::replace(written.begin(), written.end(), decimal_mark_, colours.decimal_mark);
    text->SetInput(written.c_str());
  }
  decimal_mark_ = colours.decimal_mark;
}

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
