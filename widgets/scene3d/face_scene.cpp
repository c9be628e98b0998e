#include "widgets/scene3d/face_scene.h"

#include "widgets/scene3d/face_grid.h"
#include "widgets/scene3d/face_mesh.h"
#include "widgets/scene3d/scene_lines.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCoordinate.h>
#include <vtkLookupTable.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace alltact {
namespace {

constexpr int kGhostLines = 6;  // along the shorter side of the grid
constexpr double kAxis_mm = 12;
constexpr double kAngle_deg = 25;  // of the view, from top to bottom
constexpr double kBar = 78;        // width of the colours' scale in pixels at scale 1
constexpr int kLetters = 13;       // points; the window knows its dots per inch

/// After Okabe and Ito: x, y and z, each also named by a letter.
constexpr std::array<std::array<double, 3>, 3> kAxisColours{
    {{0.84, 0.37, 0.0}, {0.0, 0.62, 0.45}, {0.0, 0.45, 0.70}}};
constexpr std::array<const char*, 3> kAxisNames{"x", "y", "z"};
constexpr double kMark[3] = {1.0, 0.72, 0.0};

std::array<double, 3> part_of(const cv::Vec3b& colour) {
  return {colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0};
}

Eigen::Vector3d to_eigen(const cv::Vec3f& p) {
  return {p[0], p[1], p[2]};
}

struct View {
  Eigen::Vector3d from, up;  // from: direction from what is looked at to the eye
};

/// inward: across the face, towards the camera
View view_of(Standpoint standpoint, const Eigen::Vector3d& inward) {
  const Eigen::Vector3d tilt(0, -0.6, 0);
  switch (standpoint) {
    case Standpoint::kCamera:
      return {{0, 0, -1}, {0, -1, 0}};
    case Standpoint::kOutside:
      return {tilt - inward, {0, -1, 0}};
    case Standpoint::kSide:
      return {{0, 1, 0}, {0, 0, -1}};
    case Standpoint::kTilted:
      break;
  }
  return {tilt + inward, {0, -1, 0}};
}

}  // namespace

/// All of it is opaque: blending would cost passes over the whole window, dear in software.
struct FaceScene::State {
  vtkRenderWindow* window;
  vtkNew<vtkRenderer> renderer;
  FaceMesh mesh;
  vtkNew<vtkActor> face;
  vtkNew<vtkPolyData> ghost_lines, camera_frame, mark_lines, mark_points;
  std::array<vtkNew<vtkPolyData>, 3> axis_lines;
  vtkSmartPointer<vtkActor> ghost, frame, line_marks, point_marks;
  std::array<vtkSmartPointer<vtkActor>, 3> axes;
  std::array<vtkNew<vtkTextActor>, 3> axis_names;  // flat, before everything, so that they are read
  std::array<vtkNew<vtkTextActor>, 2> mark_names;
  vtkNew<vtkScalarBarActor> bar;
  vtkNew<vtkLookupTable> bar_colours;

  SceneOptions options;
  SceneColours colours;
  SceneMarks marks;
  double scale = 1;
  Standpoint standpoint = Standpoint::kTilted;
  FaceSurface surface;
  cv::Mat other_mm;  // empty: depth itself is shown
  Eigen::Vector3d inward{0, 0, -1};
  std::optional<Eigen::Vector3d> eye_set;  // where look() put it
  bool is_looked_at = false;               // somebody has chosen from where

  explicit State(vtkRenderWindow* of) : window(of) {}
  void make_face();
  void make_lines();
  void make_bar();
  void draw_face();
  void draw_ghost();
  void draw_marks();
  void draw_bar();
  void draw_camera(const Camera& camera);
  void dress();
  void place_bar();
  void look();
  [[nodiscard]] std::vector<Eigen::Vector3d> outline() const;
  void keep_in_sight() { renderer->ResetCameraClippingRange(); }
};

void FaceScene::State::make_face() {
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh.data());
  mapper->SetColorModeToDirectScalars();
  mapper->StaticOn();  // nothing upstream to ask
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 2);
  face->SetMapper(mapper);
  face->GetProperty()->SetAmbient(0.5);
  face->GetProperty()->SetDiffuse(0.5);
  face->GetProperty()->SetSpecular(0.0);
  face->VisibilityOff();
  renderer->AddActor(face);
}

void FaceScene::State::make_lines() {
  ghost = line_actor(ghost_lines, 25);
  frame = line_actor(camera_frame, 0);
  line_marks = line_actor(mark_lines, 60);
  point_marks = line_actor(mark_points, 60);
  point_marks->GetProperty()->SetRenderPointsAsSpheres(true);
  for (const auto& actor : {line_marks, point_marks})
    actor->GetProperty()->SetColor(kMark[0], kMark[1], kMark[2]);
  for (const auto& actor : {ghost, frame, line_marks, point_marks}) renderer->AddActor(actor);
  for (std::size_t i = 0; i < mark_names.size(); ++i) {
    const char name[] = {' ', ' ', static_cast<char>('A' + i), '\0'};
    mark_names[i]->SetInput(name);
    mark_names[i]->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    mark_names[i]->GetTextProperty()->SetBold(true);
    mark_names[i]->GetTextProperty()->SetColor(kMark[0], kMark[1], kMark[2]);
    mark_names[i]->GetTextProperty()->SetShadow(true);
    mark_names[i]->VisibilityOff();
    renderer->AddActor2D(mark_names[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    Eigen::Vector3d end = Eigen::Vector3d::Zero();
    end[static_cast<Eigen::Index>(i)] = kAxis_mm;
    set_lines(axis_lines[i], {{Eigen::Vector3d::Zero(), end}});
    axes[i] = line_actor(axis_lines[i], 0);
    axes[i]->GetProperty()->SetColor(kAxisColours[i][0], kAxisColours[i][1], kAxisColours[i][2]);
    axis_names[i]->SetInput(kAxisNames[i]);
    axis_names[i]->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    axis_names[i]->GetPositionCoordinate()->SetValue(
        1.15 * end.x(), 1.15 * end.y(), 1.15 * end.z());
    axis_names[i]->GetTextProperty()->SetColor(
        kAxisColours[i][0], kAxisColours[i][1], kAxisColours[i][2]);
    axis_names[i]->GetTextProperty()->SetBold(true);
    axis_names[i]->GetTextProperty()->SetJustificationToCentered();
    axis_names[i]->GetTextProperty()->SetVerticalJustificationToCentered();
    renderer->AddActor(axes[i]);
    renderer->AddActor2D(axis_names[i]);
  }
}

void FaceScene::State::make_bar() {
  bar->SetLookupTable(bar_colours);
  bar->SetTitle("mm");
  bar->SetNumberOfLabels(5);
  bar->SetLabelFormat("%.2f");
  bar->UnconstrainedFontSizeOn();
  bar->SetBarRatio(0.28);
  bar->SetTextPad(4);
  bar->SetVerticalTitleSeparation(10);
  bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  for (vtkTextProperty* text : {bar->GetLabelTextProperty(), bar->GetTitleTextProperty()}) {
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
  }
  bar->VisibilityOff();
  renderer->AddActor2D(bar);
}

void FaceScene::State::draw_face() {
  if (surface.untouched_mm.empty()) return;
  const auto times = static_cast<float>(options.times);
  if (other_mm.empty()) {
    mesh.update(surface.untouched_mm,
                surface.depth_mm,
                times,
                surface.depth_mm,
                {0, options.top_mm, &viridis});
  } else {
    const cv::Mat difference = surface.depth_mm - other_mm;
    mesh.update(surface.untouched_mm,
                surface.depth_mm,
                times,
                difference,
                difference_scale(options.top_mm));
  }
  face->VisibilityOn();
  bar->VisibilityOn();
}

void FaceScene::State::draw_ghost() {
  ghost->SetVisibility(options.untouched && !surface.untouched_mm.empty());
  if (!options.untouched || surface.untouched_mm.empty()) return;
  const int columns = surface.columns(), rows = surface.rows();
  const double step = static_cast<double>(std::min(columns, rows) - 1) / kGhostLines;
  std::vector<Polyline> lines;
  const int across = std::max(1, static_cast<int>(std::lround((columns - 1) / step)));
  for (int k = 0; k <= across; ++k) {
    const int i = k * (columns - 1) / across;
    Polyline& line = lines.emplace_back();
    for (int j = 0; j < rows; ++j)
      line.push_back(to_eigen(surface.untouched_mm.at<cv::Vec3f>(j, i)));
  }
  const int along = std::max(1, static_cast<int>(std::lround((rows - 1) / step)));
  for (int k = 0; k <= along; ++k) {
    const int j = k * (rows - 1) / along;
    Polyline& line = lines.emplace_back();
    for (int i = 0; i < columns; ++i)
      line.push_back(to_eigen(surface.untouched_mm.at<cv::Vec3f>(j, i)));
  }
  set_lines(ghost_lines, lines);
}

void FaceScene::State::draw_marks() {
  std::vector<Eigen::Vector3d> points;
  std::vector<Polyline> lines;
  const auto add = [&](std::vector<Eigen::Vector3d>& to, cv::Point2d pixel) {
    if (surface.untouched_mm.empty()) return;
    if (const auto place = grid_place_of(surface, pixel))
      to.push_back(to_eigen(point_between(mesh.drawn_mm(), *place)));
  };
  for (std::size_t i = 0; i < std::max(marks.points.size(), mark_names.size()); ++i) {
    const std::size_t before = points.size();
    if (i < marks.points.size()) add(points, marks.points[i]);
    if (i >= mark_names.size()) continue;
    mark_names[i]->SetVisibility(points.size() > before);
    if (points.size() > before)
      mark_names[i]->GetPositionCoordinate()->SetValue(points.back().data());
  }
  for (const auto& line : marks.lines) {
    Polyline drawn;
    for (const cv::Point2d& pixel : line) add(drawn, pixel);
    if (drawn.size() > 1) lines.push_back(std::move(drawn));
  }
  set_points(mark_points, points);
  set_lines(mark_lines, lines);
}

void FaceScene::State::draw_bar() {
  constexpr int kSteps = 256;
  const ColourScale scale =
      other_mm.empty() ? ColourScale{0, options.top_mm} : difference_scale(options.top_mm);
  bar_colours->SetNumberOfTableValues(kSteps);
  bar_colours->SetTableRange(scale.low, scale.high);
  for (int i = 0; i < kSteps; ++i) {
    const MapColour c = scale.colour(static_cast<double>(i) / (kSteps - 1));
    bar_colours->SetTableValue(i, c.red / 255.0, c.green / 255.0, c.blue / 255.0, 1);
  }
  bar_colours->Build();
}

void FaceScene::State::draw_camera(const Camera& camera) {
  const cv::Size size = camera.size();
  constexpr double kFar_mm = 8;
  const auto corner = camera.unproject({0, 0}),
             other = camera.unproject({size.width - 1.0, size.height - 1.0});
  std::vector<Polyline> lines;
  if (camera.is_perspective() && corner && other) {
    const Eigen::Vector3d a = corner->point_at(kFar_mm), b = other->point_at(kFar_mm);
    lines = camera_lines(0.5 * (b.x() - a.x()), 0.5 * (b.y() - a.y()), kFar_mm);
  }
  set_lines(camera_frame, lines);
}

void FaceScene::State::dress() {
  const auto ground = part_of(colours.ground), text = part_of(colours.text);
  renderer->SetBackground(ground[0], ground[1], ground[2]);
  ghost->GetProperty()->SetColor(0.55, 0.55, 0.55);
  frame->GetProperty()->SetColor(text[0], text[1], text[2]);
  for (const auto& actor : {ghost, frame})
    actor->GetProperty()->SetLineWidth(static_cast<float>(scale));
  line_marks->GetProperty()->SetLineWidth(static_cast<float>(3 * scale));
  point_marks->GetProperty()->SetPointSize(static_cast<float>(12 * scale));
  for (std::size_t i = 0; i < 3; ++i) {
    axes[i]->GetProperty()->SetLineWidth(static_cast<float>(3 * scale));
    axis_names[i]->GetTextProperty()->SetFontSize(kLetters + 2);
    axes[i]->SetVisibility(options.camera);
    axis_names[i]->SetVisibility(options.camera);
  }
  frame->SetVisibility(options.camera);
  for (const auto& name : mark_names) name->GetTextProperty()->SetFontSize(kLetters + 3);
  place_bar();
  for (vtkTextProperty* property : {bar->GetLabelTextProperty(), bar->GetTitleTextProperty()}) {
    property->SetColor(text[0], text[1], text[2]);
    property->SetFontSize(kLetters);
  }
}

/// At the right, as wide as its letters need.
void FaceScene::State::place_bar() {
  const int* size = window->GetSize();
  if (size[0] <= 0 || size[1] <= 0) return;
  const double width = std::min(0.4, kBar * scale / size[0]);
  const double height = std::min(0.7, 340 * scale / size[1]);
  bar->SetPosition(1 - width, 0.5 * (1 - height));
  bar->SetWidth(width);
  bar->SetHeight(height);
}

/// What must be in sight: the face's vertices, and the camera.
std::vector<Eigen::Vector3d> FaceScene::State::outline() const {
  std::vector<Eigen::Vector3d> points;
  const cv::Mat& drawn = mesh.drawn_mm();
  constexpr int kOfMany = 7;
  for (int j = 0; j < drawn.rows; j += j + kOfMany < drawn.rows ? kOfMany : 1)
    for (int i = 0; i < drawn.cols; i += i + kOfMany < drawn.cols ? kOfMany : 1)
      points.push_back(to_eigen(drawn.at<cv::Vec3f>(j, i)));
  if (!options.camera) return points;
  for (const Eigen::Vector3d& end : {Eigen::Vector3d(0, 0, 0),
                                     Eigen::Vector3d(kAxis_mm, 0, 0),
                                     Eigen::Vector3d(0, kAxis_mm, 0),
                                     Eigen::Vector3d(-kAxis_mm, -kAxis_mm, 0)})
    points.push_back(end);
  return points;
}

void FaceScene::State::look() {
  if (surface.untouched_mm.empty()) return;
  const View view = view_of(standpoint, inward);
  const Eigen::Vector3d back = view.from.normalized();
  const Eigen::Vector3d right = view.up.cross(back).normalized(), up = back.cross(right);
  const auto points = outline();
  Eigen::AlignedBox3d box;  // in the view's own axes
  for (const Eigen::Vector3d& p : points)
    box.extend(Eigen::Vector3d(p.dot(right), p.dot(up), p.dot(back)));
  const Eigen::Vector3d centre = box.center();
  const int* size = window->GetSize();
  const double aspect = size[0] > 0 && size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1.6;
  const double width_used = size[0] > 0 ? 1 - std::min(0.4, kBar * scale / size[0]) : 0.8;
  constexpr double kFilled = 0.92;
  const double slope = std::tan(0.5 * kAngle_deg * std::acos(-1.0) / 180);
  double away = 1;
  for (const Eigen::Vector3d& p : points) {
    const double x = std::abs(p.dot(right) - centre.x()) / (slope * aspect * width_used * kFilled);
    const double y = std::abs(p.dot(up) - centre.y()) / (slope * kFilled);
    away = std::max(away, std::max(x, y) + p.dot(back) - centre.z());
  }
  // The scale's part of the width stays free.
  const double aside = away * slope * aspect * (1 - width_used);
  const Eigen::Vector3d at = (centre.x() + aside) * right + centre.y() * up + centre.z() * back;
  const Eigen::Vector3d eye = at + away * back;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetViewAngle(kAngle_deg);
  camera->SetFocalPoint(at.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(up.data());
  eye_set = eye;
  keep_in_sight();
}

FaceScene::FaceScene(vtkRenderWindow* window) : state_(std::make_unique<State>(window)) {
  state_->make_face();
  state_->make_lines();
  state_->make_bar();
  state_->dress();
  state_->draw_bar();
  window->AddRenderer(state_->renderer);
}

FaceScene::~FaceScene() {
  state_->window->RemoveRenderer(state_->renderer);
}

void FaceScene::show(const FaceSurface& surface, const Camera& camera) {
  show_difference(surface, {}, camera);
}

void FaceScene::show_difference(const FaceSurface& surface,
                                const cv::Mat& other_mm,
                                const Camera& camera) {
  const bool is_first = state_->surface.untouched_mm.empty();
  const bool is_other_kind = state_->other_mm.empty() != other_mm.empty();
  state_->surface = surface;
  state_->other_mm = other_mm;
  state_->draw_face();
  state_->draw_ghost();
  state_->draw_marks();
  if (is_other_kind) state_->draw_bar();
  if (!is_first) return state_->keep_in_sight();
  state_->draw_camera(camera);
  const cv::Mat& whole = surface.untouched_mm;
  const auto corner = [&](int j, int i) { return to_eigen(whole.at<cv::Vec3f>(j, i)); };
  const int last_row = whole.rows - 1, last_column = whole.cols - 1;
  const Eigen::Vector3d along = corner(0, last_column) - corner(0, 0);
  const Eigen::Vector3d down = corner(last_row, 0) - corner(0, 0);
  state_->inward = down.cross(along).normalized();
  if (state_->is_looked_at) return state_->keep_in_sight();
  state_->look();
}

void FaceScene::forget() {
  state_->surface = {};
  state_->other_mm = cv::Mat();
  state_->face->VisibilityOff();
  state_->bar->VisibilityOff();
  state_->draw_ghost();
  state_->draw_marks();
}

void FaceScene::set_options(const SceneOptions& options) {
  state_->options = options;
  state_->draw_face();
  state_->draw_ghost();
  state_->draw_marks();
  state_->draw_bar();
  state_->dress();
  fit();
  state_->keep_in_sight();
}

void FaceScene::set_colours(const SceneColours& colours) {
  state_->colours = colours;
  state_->dress();
}

void FaceScene::set_marks(SceneMarks marks) {
  state_->marks = std::move(marks);
  state_->draw_marks();
}

void FaceScene::set_scale(double pixels_per_unit) {
  state_->scale = pixels_per_unit;
  state_->dress();
}

void FaceScene::look_from(Standpoint standpoint) {
  state_->is_looked_at = false;
  state_->standpoint = standpoint;
  state_->look();
}

void FaceScene::fit() {
  state_->place_bar();
  if (state_->eye_set && (look().eye - *state_->eye_set).norm() < 1e-6) state_->look();
}

Standpoint FaceScene::standpoint() const {
  return state_->standpoint;
}

void FaceScene::turn(double right_deg, double up_deg) {
  vtkCamera* camera = state_->renderer->GetActiveCamera();
  camera->Azimuth(right_deg);
  camera->Elevation(up_deg);
  camera->OrthogonalizeViewUp();
  state_->keep_in_sight();
}

void FaceScene::shift(double right_part, double up_part) {
  vtkCamera* camera = state_->renderer->GetActiveCamera();
  const Eigen::Vector3d eye(camera->GetPosition()), at(camera->GetFocalPoint());
  const Eigen::Vector3d up = Eigen::Vector3d(camera->GetViewUp()).normalized();
  const Eigen::Vector3d right = (at - eye).cross(up).normalized();
  const double height =
      2 * camera->GetDistance() * std::tan(0.5 * camera->GetViewAngle() * std::acos(-1.0) / 180);
  const Eigen::Vector3d by = -height * (right_part * right + up_part * up);
  const Eigen::Vector3d new_eye = eye + by, new_at = at + by;
  camera->SetPosition(new_eye.data());
  camera->SetFocalPoint(new_at.data());
  state_->keep_in_sight();
}

void FaceScene::come_closer(double factor) {
  state_->renderer->GetActiveCamera()->Dolly(factor);
  state_->keep_in_sight();
}

void FaceScene::look_as(const Look& look) {
  vtkCamera* camera = state_->renderer->GetActiveCamera();
  camera->SetViewAngle(kAngle_deg);
  camera->SetPosition(look.eye.x(), look.eye.y(), look.eye.z());
  camera->SetFocalPoint(look.at.x(), look.at.y(), look.at.z());
  camera->SetViewUp(look.up.x(), look.up.y(), look.up.z());
  state_->eye_set.reset();
  state_->is_looked_at = true;
  state_->keep_in_sight();
}

Look FaceScene::look() const {
  vtkCamera* camera = state_->renderer->GetActiveCamera();
  return {Eigen::Vector3d(camera->GetPosition()),
          Eigen::Vector3d(camera->GetFocalPoint()),
          Eigen::Vector3d(camera->GetViewUp())};
}

std::optional<cv::Point2d> FaceScene::pixel_at(double x, double y) const {
  const int* size = state_->window->GetSize();
  if (state_->surface.untouched_mm.empty() || size[0] <= 0 || size[1] <= 0) return std::nullopt;
  const auto world = [&](double depth) {
    double at[4] = {2 * x / size[0] - 1, 1 - 2 * y / size[1], depth, 1};
    vtkRenderer* renderer = state_->renderer;
    renderer->ViewToWorld(at[0], at[1], at[2]);
    return Eigen::Vector3d(at[0], at[1], at[2]);
  };
  const Eigen::Vector3d near = world(-1), far = world(1);
  const auto place = first_hit(state_->mesh.drawn_mm(), near, far - near);
  if (!place) return std::nullopt;
  const cv::Vec2f pixel = pixel_between(state_->surface.pixel, *place);
  return cv::Point2d(pixel[0], pixel[1]);
}

std::optional<cv::Point2d> FaceScene::place_of(cv::Point2d pixel) const {
  const auto place = grid_place_of(state_->surface, pixel);
  if (!place) return std::nullopt;
  const cv::Vec3f at = point_between(state_->mesh.drawn_mm(), *place);
  double x = at[0], y = at[1], z = at[2];
  state_->renderer->WorldToView(x, y, z);
  const int* size = state_->window->GetSize();
  return cv::Point2d(0.5 * (x + 1) * size[0], 0.5 * (1 - y) * size[1]);
}

int FaceScene::topologies() const {
  return state_->mesh.topologies();
}

}  // namespace alltact
