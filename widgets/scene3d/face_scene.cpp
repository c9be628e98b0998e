#include "widgets/scene3d/face_scene.h"

#include "widgets/scene3d/face_mesh.h"
#include "widgets/scene3d/finger_actors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkCoordinate.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkScalarBarActorInternal.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

namespace alltact {
namespace {

constexpr double kAngle_deg = 25;  // of the view, from top to bottom
constexpr double kDegree = std::numbers::pi / 180;

struct View {
  Eigen::Vector3d from, up;  // from: direction from the target to the eye
};

/// In the camera's frame.
View view_of(Viewpoint viewpoint, const Eigen::Vector3d& inward) {
  const Eigen::Vector3d tilt(0, -0.6, 0);
  switch (viewpoint) {
    case Viewpoint::kCamera:
      return {{0, 0, -1}, {0, -1, 0}};
    case Viewpoint::kOutside:
      return {tilt - inward, {0, -1, 0}};
    case Viewpoint::kSide:
      return {{0, 1, 0}, {0, 0, -1}};
    case Viewpoint::kTilted:
      break;
  }
  return {tilt + inward, {0, -1, 0}};
}

/// The camera of a renderer.
class SceneView {
 public:
  /// The renderer outlives it.
  explicit SceneView(vtkRenderer* renderer) : renderer_(renderer) {}

  /// The content that a viewpoint shows.
  struct Subject {
    std::vector<Eigen::Vector3d> points;  ///< that must be visible
    Eigen::Vector3d inward{0, 0, -1};     ///< across the face, towards its camera, camera frame
    RigidTransform scene_from_camera;
  };
  /// Fits everything into a window of this size, less the fraction at the right that `used_width`
  /// leaves over.
  void look_at(const Subject& subject, Viewpoint viewpoint, const int* window_px,
               double used_width) {
    const View view = view_of(viewpoint, subject.inward);
    const Eigen::Vector3d back = subject.scene_from_camera.direction(view.from.normalized());
    const Eigen::Vector3d right =
        subject.scene_from_camera.direction(view.up).cross(back).normalized();
    const Eigen::Vector3d up = back.cross(right);
    const double aspect = window_px[0] > 0 && window_px[1] > 0
                              ? static_cast<double>(window_px[0]) / window_px[1]
                              : 1.6;
    constexpr double kFilled = 0.95;
    const double up_slope = kFilled * std::tan(0.5 * kAngle_deg * kDegree);
    const double left_slope = aspect * up_slope, right_slope = left_slope * (2 * used_width - 1);
    // In the view's own axes an eye sees a point where x - x_eye <= slope (z_eye - z), and likewise
    // to the other sides. The eye is as near as possible: on two opposite sides one point lies on
    // the rim.
    constexpr double kFar = std::numeric_limits<double>::lowest();
    double rightmost = kFar, leftmost = kFar, top = kFar, bottom = kFar, nearest = kFar;
    double furthest = -kFar;
    for (const Eigen::Vector3d& p : subject.points) {
      const double x = p.dot(right), y = p.dot(up), z = p.dot(back);
      rightmost = std::max(rightmost, x + right_slope * z);
      leftmost = std::max(leftmost, left_slope * z - x);
      top = std::max(top, y + up_slope * z);
      bottom = std::max(bottom, up_slope * z - y);
      nearest = std::max(nearest, z);
      furthest = std::min(furthest, z);
    }
    if (subject.points.empty()) return;
    const double z_eye = std::max({(rightmost + leftmost) / (right_slope + left_slope),
                                   (top + bottom) / (2 * up_slope), nearest + 1});
    const double x_eye = 0.5 * (rightmost - leftmost + (left_slope - right_slope) * z_eye);
    const double y_eye = 0.5 * (top - bottom);
    const Eigen::Vector3d eye = x_eye * right + y_eye * up + z_eye * back;
    set_view_pose({eye, eye - (z_eye - 0.5 * (nearest + furthest)) * back, up});
    eye_set_ = eye;
  }
  /// As look_at() left it: nobody turned or moved it since.
  [[nodiscard]] bool is_unchanged() const {
    return eye_set_ && (pose().eye - *eye_set_).norm() < 1e-6;
  }

  void turn(double right_deg, double up_deg) {
    vtkCamera* camera = renderer_->GetActiveCamera();
    camera->Azimuth(right_deg);
    camera->Elevation(up_deg);
    camera->OrthogonalizeViewUp();
    reset_clipping();
  }
  void shift(double right_part, double up_part) {
    vtkCamera* camera = renderer_->GetActiveCamera();
    const ViewPose now = pose();
    const Eigen::Vector3d up = now.up.normalized();
    const Eigen::Vector3d right = (now.at - now.eye).cross(up).normalized();
    const double height =
        2 * camera->GetDistance() * std::tan(0.5 * camera->GetViewAngle() * kDegree);
    const Eigen::Vector3d by = -height * (right_part * right + up_part * up);
    const Eigen::Vector3d new_eye = now.eye + by, new_at = now.at + by;
    camera->SetPosition(new_eye.data());
    camera->SetFocalPoint(new_at.data());
    reset_clipping();
  }
  void dolly(double factor) {
    renderer_->GetActiveCamera()->Dolly(factor);
    reset_clipping();
  }
  void set_view_pose(const ViewPose& pose) {
    vtkCamera* camera = renderer_->GetActiveCamera();
    camera->SetViewAngle(kAngle_deg);
    camera->SetPosition(pose.eye.data());
    camera->SetFocalPoint(pose.at.data());
    camera->SetViewUp(pose.up.data());
    eye_set_.reset();
    reset_clipping();
  }
  [[nodiscard]] ViewPose pose() const {
    vtkCamera* camera = renderer_->GetActiveCamera();
    return {Eigen::Vector3d(camera->GetPosition()), Eigen::Vector3d(camera->GetFocalPoint()),
            Eigen::Vector3d(camera->GetViewUp())};
  }
  /// Call it after anything was drawn at another position than before.
  void reset_clipping() { renderer_->ResetCameraClippingRange(); }

 private:
  vtkRenderer* renderer_;
  std::optional<Eigen::Vector3d> eye_set_;  // the eye that look_at() set
};

/// Writes numbers with another decimal mark than the C locale's. Points at the bar's ends have the
/// colours of values beyond the scale.
class BarActor : public vtkScalarBarActor {
 public:
  static BarActor* New() {
    auto* actor = new BarActor;
    actor->InitializeObjectBase();
    return actor;
  }

  void set_decimal_mark(char mark) {
    if (mark == mark_) return;
    mark_ = mark;
    Modified();
  }

 protected:
  void RebuildLayout(vtkViewport* viewport) override {
    vtkScalarBarActor::RebuildLayout(viewport);
    for (const auto& label : P->TextActors) {
      std::string text = label->GetInput() != nullptr ? label->GetInput() : "";
      std::replace(text.begin(), text.end(), '.', mark_);
      label->SetInput(text.c_str());
    }
  }

  void ConfigureScalarBar() override {
    vtkScalarBarActor::ConfigureScalarBar();
    const double left = P->ScalarBarBox.Posn[0], low = P->ScalarBarBox.Posn[1];
    const double width = P->ScalarBarBox.Size[0], top = low + P->ScalarBarBox.Size[1];
    for (const auto& [y, length, colour] :
         {std::tuple{low, -kEndLength, kBelowScale}, {top, kEndLength, kAboveScale}}) {
      const vtkIdType corners[] = {
          P->SwatchPts->InsertNextPoint(left, y, 0),
          P->SwatchPts->InsertNextPoint(left + width, y, 0),
          P->SwatchPts->InsertNextPoint(left + 0.5 * width, y + length * width, 0)};
      P->Polys->InsertNextCell(3, corners);
      const double rgba[] = {double(colour.red), double(colour.green), double(colour.blue), 255};
      P->SwatchColors->InsertNextTuple(rgba);
    }
  }

 private:
  static constexpr double kEndLength = 0.5;  // in widths of the bar
  char mark_ = '.';
};

constexpr double kWidth = 78, kHeight = 340;  // in pixels at scale 1

class ColourBar {
 public:
  /// The renderer outlives it.
  explicit ColourBar(vtkRenderer* renderer) {
    bar_->SetLookupTable(colours_);
    bar_->SetTitle("mm");
    bar_->UnconstrainedFontSizeOn();
    bar_->SetBarRatio(0.28);
    bar_->SetTextPad(4);
    bar_->SetMaximumNumberOfColors(kSteps);
    bar_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    for (vtkTextProperty* text : {bar_->GetLabelTextProperty(), bar_->GetTitleTextProperty()}) {
      text->ItalicOff();
      text->BoldOff();
      text->ShadowOff();
    }
    plate_mapper_->SetInputData(plate_data_);
    const vtkNew<vtkCoordinate> window;
    window->SetCoordinateSystemToNormalizedViewport();
    plate_mapper_->SetTransformCoordinate(window);
    plate_->SetMapper(plate_mapper_);
    plate_->GetProperty()->SetOpacity(0.8);
    show(false);
    renderer->AddActor2D(plate_);  // before the bar, so behind it
    renderer->AddActor2D(bar_);
  }

  void show(bool is_shown) {
    bar_->SetVisibility(is_shown);
    plate_->SetVisibility(is_shown);
  }
  void set_scale(const ColourScale& scale) {
    colours_->SetNumberOfTableValues(kSteps);
    colours_->SetTableRange(scale.low_mm, scale.top_mm);
    // As many as make zero one of them.
    const int labels = scale.steps < 4 ? 2 * scale.steps + 1 : scale.steps + 1;
    bar_->SetNumberOfLabels(labels);
    bar_->SetLabelFormat(fmt::format("%.{}f", scale.label_decimals(labels)).c_str());
    for (int i = 0; i < kSteps; ++i) {
      const MapColour c = scale.colour(static_cast<double>(i) / (kSteps - 1));
      colours_->SetTableValue(i, c.red / 255.0, c.green / 255.0, c.blue / 255.0, 1);
    }
    colours_->Build();
  }
  void apply_style(const SceneColours& colours) {
    const cv::Vec3b& text = colours.text;
    bar_->set_decimal_mark(colours.decimal_mark);
    const cv::Vec3b& ground = colours.ground;
    plate_->GetProperty()->SetColor(ground[0] / 255.0, ground[1] / 255.0, ground[2] / 255.0);
    for (vtkTextProperty* property : {bar_->GetLabelTextProperty(), bar_->GetTitleTextProperty()}) {
      property->SetColor(text[0] / 255.0, text[1] / 255.0, text[2] / 255.0);
      property->SetFontSize(kLetterPoints);
    }
  }
  /// At the right, as wide as its letters need.
  void set_position(const int* window_px, double pixels_per_unit) {
    if (window_px[0] <= 0 || window_px[1] <= 0) return;
    const double left = free_fraction(window_px, pixels_per_unit);
    const double height = std::min(0.7, kHeight * pixels_per_unit / window_px[1]);
    bar_->SetPosition(left, 0.5 * (1 - height));
    bar_->SetWidth(1 - left);
    bar_->SetHeight(height);
    constexpr double kEnd = 18, kLeftMargin = 7;
    bar_->SetVerticalTitleSeparation(static_cast<int>(std::lround(kEnd * pixels_per_unit)));
    const double margin = kEnd * pixels_per_unit / window_px[1];
    const double low = 0.5 * (1 - height) - margin, top = 0.5 * (1 + height) + margin;
    const double edge = left - kLeftMargin * pixels_per_unit / window_px[0];
    const vtkNew<vtkPoints> corners;
    for (const auto& [x, y] : {std::pair{edge, low}, {1.0, low}, {1.0, top}, {edge, top}})
      corners->InsertNextPoint(x, y, 0);
    const vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({0, 1, 2, 3});
    plate_data_->SetPoints(corners);
    plate_data_->SetPolys(cells);
  }
  /// Fraction of the window's width that stays free of it.
  [[nodiscard]] static double free_fraction(const int* window_px, double pixels_per_unit) {
    if (window_px[0] <= 0) return 0.8;
    return 1 - std::min(0.4, kWidth * pixels_per_unit / window_px[0]);
  }

 private:
  static constexpr int kSteps = 256;  // colours
  vtkNew<BarActor> bar_;
  vtkNew<vtkPolyData> plate_data_;
  vtkNew<vtkPolyDataMapper2D> plate_mapper_;
  vtkNew<vtkActor2D> plate_;
  vtkNew<vtkLookupTable> colours_;
};

constexpr double kMark[3] = {1.0, 0.72, 0.0};

class MarkActors {
 public:
  /// The renderer outlives them.
  explicit MarkActors(vtkRenderer* renderer)
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

  struct Point {
    std::size_t letter;  ///< 0: A, 1: B
    Eigen::Vector3d at;
  };
  void draw(const std::vector<Point>& points,
            const std::vector<std::vector<Eigen::Vector3d>>& lines) {
    std::vector<Eigen::Vector3d> positions;
    for (const auto& name : names_) name->VisibilityOff();
    for (const Point& point : points) {
      positions.push_back(point.at);
      if (point.letter >= names_.size()) continue;
      names_[point.letter]->VisibilityOn();
      names_[point.letter]->GetPositionCoordinate()->SetValue(point.at.x(), point.at.y(),
                                                              point.at.z());
    }
    set_points(point_data_, positions);
    set_lines(line_data_, lines);
  }
  void apply_style(double pixels_per_unit) {
    lines_->GetProperty()->SetLineWidth(static_cast<float>(3 * pixels_per_unit));
    points_->GetProperty()->SetPointSize(static_cast<float>(12 * pixels_per_unit));
    for (const auto& name : names_) name->GetTextProperty()->SetFontSize(kLetterPoints + 3);
  }

 private:
  vtkNew<vtkPolyData> line_data_, point_data_;
  vtkSmartPointer<vtkActor> lines_, points_;
  std::array<vtkNew<vtkTextActor>, 2> names_;
};

constexpr double kGripperAxis_mm = 20;

/// Light for the bodies.
class Lamps {
 public:
  explicit Lamps(vtkRenderer* renderer) {
    renderer->AutomaticLightCreationOff();
    head_->SetLightTypeToHeadlight();
    head_->SetIntensity(0.5);
    key_->SetLightTypeToSceneLight();
    key_->SetIntensity(0.7);
    for (vtkLight* lamp : {head_.Get(), key_.Get()}) renderer->AddLight(lamp);
  }
  /// The direction that the key light comes from, in the scene.
  void set_key(const Eigen::Vector3d& from) {
    key_->SetPosition(from.x(), from.y(), from.z());
    key_->SetFocalPoint(0, 0, 0);
  }

 private:
  vtkNew<vtkLight> head_, key_;
};

}  // namespace

struct FaceScene::State {
  vtkRenderWindow* window;
  vtkNew<vtkRenderer> renderer;
  Lamps lamps{renderer};
  FingerActors first{renderer}, second{renderer};
  Axes gripper{renderer, kGripperAxis_mm};
  MarkActors mark_actors{renderer};
  ColourBar bar{renderer};
  SceneView view{renderer};
  vtkNew<vtkPolyData> gap_line;
  vtkSmartPointer<vtkActor> gap = line_actor(gap_line, 0);

  SceneOptions options;
  SceneColours colours;
  SceneMarks marks;
  double scale = 1;
  Viewpoint viewpoint = Viewpoint::kTilted;
  bool is_in_gripper = false;
  bool has_view_pose = false;  // a viewpoint was set

  explicit State(vtkRenderWindow* of) : window(of) {
    const vtkNew<vtkCallbackCommand> start;
    start->SetClientData(this);
    start->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
      static_cast<State*>(self)->begin_to_render();
    });
    renderer->AddObserver(vtkCommand::StartEvent, start);
    gripper.set_names({"X", "Y", "Z"});
    renderer->AddActor(gap);
    set_options();
    apply_style();
  }
  void set_options() {
    first.set_options(options);
    second.set_options(options);
    show_frames();
    bar.set_scale(first.colours());
  }
  /// Coordinate axes rather than faces.
  void show_frames() {
    gripper.show(options.camera && is_in_gripper);
    second.show_camera(options.camera && is_in_gripper);
    gap->SetVisibility(is_in_gripper);
    const bool is_one = !is_in_gripper;
    first.axes().set_names(is_one ? std::array<std::string, 3>{"x", "y", "z"}
                                  : std::array<std::string, 3>{"x1", "y1", "z1"});
    second.axes().set_names({"x2", "y2", "z2"});
  }
  /// The interactor may have turned the camera itself.
  void begin_to_render() {
    const Eigen::Vector3d eye(renderer->GetActiveCamera()->GetPosition());
    for (FingerActors* face : {&first, &second}) face->set_eye(eye);
  }
  void draw_marks();
  void apply_style();
  void aim_camera();
  void shown(bool is_first);
};

void FaceScene::State::draw_marks() {
  std::vector<MarkActors::Point> points;
  for (std::size_t i = 0; i < marks.points.size(); ++i)
    if (const auto& pixel = marks.points[i])
      if (const auto at = first.point_of(*pixel)) points.push_back({i, *at});
  std::vector<Polyline> lines;
  for (const auto& line : marks.lines) {
    Polyline drawn;
    for (const cv::Point2d& pixel : line)
      if (const auto at = first.point_of(pixel)) drawn.push_back(*at);
    if (drawn.size() > 1) lines.push_back(std::move(drawn));
  }
  mark_actors.draw(points, lines);
}

void FaceScene::State::apply_style() {
  const cv::Vec3b &ground = colours.ground, &text = colours.text;
  renderer->SetBackground(ground[0] / 255.0, ground[1] / 255.0, ground[2] / 255.0);
  first.apply_style(colours, scale);
  second.apply_style(colours, scale);
  gripper.apply_style(scale);
  mark_actors.apply_style(scale);
  bar.apply_style(colours);
  bar.set_position(window->GetSize(), scale);
  gap->GetProperty()->SetColor(text[0] / 255.0, text[1] / 255.0, text[2] / 255.0);
  gap->GetProperty()->SetLineWidth(static_cast<float>(2 * scale));
}

void FaceScene::State::aim_camera() {
  if (!first.is_shown()) return;
  const bool with_body = is_in_gripper || viewpoint != Viewpoint::kCamera;
  SceneView::Subject subject{first.outline(with_body), first.inward(), first.scene_from_camera()};
  if (is_in_gripper)
    for (const auto& more : {second.outline(true), gripper.corners()})
      subject.points.insert(subject.points.end(), more.begin(), more.end());
  view.look_at(subject, viewpoint, window->GetSize(),
               ColourBar::free_fraction(window->GetSize(), scale));
}

void FaceScene::State::shown(bool is_first) {
  lamps.set_key(first.light());
  bar.show(first.has_depth());
  draw_marks();
  if (is_first && !has_view_pose) aim_camera();
  view.reset_clipping();
}

FaceScene::FaceScene(vtkRenderWindow* window) : state_(std::make_unique<State>(window)) {
  window->AddRenderer(state_->renderer);
}

FaceScene::~FaceScene() { state_->window->RemoveRenderer(state_->renderer); }

void FaceScene::show(const FaceSurface& surface, const Camera& camera) {
  show_difference(surface, {}, camera);
}

void FaceScene::show_difference(const FaceSurface& surface, const cv::Mat& other_mm,
                                const Camera& camera) {
  const bool is_first = !state_->first.is_shown() || state_->is_in_gripper;
  const bool is_other_kind = state_->first.is_difference() == other_mm.empty();
  state_->is_in_gripper = false;
  state_->second.hide();
  state_->first.set_pose({});
  state_->first.show(surface, other_mm);
  if (is_first) state_->first.draw_camera(camera);
  if (is_first || is_other_kind) state_->set_options();
  state_->shown(is_first);
}

void FaceScene::show_in_gripper(const SceneFinger& first, const SceneFinger& second) {
  const bool is_first = !state_->first.is_shown() || !state_->is_in_gripper;
  const bool is_elsewhere = !(state_->first.scene_from_camera() == first.gripper_from_camera &&
                              state_->second.scene_from_camera() == second.gripper_from_camera);
  state_->is_in_gripper = true;
  for (const auto& [face, finger] :
       {std::pair{&state_->first, &first}, {&state_->second, &second}}) {
    face->set_pose(finger->gripper_from_camera);
    face->show(finger->surface, {});
    if (is_first) face->draw_camera(finger->camera);
  }
  if (is_first) state_->set_options();
  state_->shown(is_first || is_elsewhere);
}

void FaceScene::set_gap(const std::optional<NearestPoints>& gap) {
  std::vector<Polyline> lines;
  if (gap) lines.push_back({gap->first, gap->second});
  set_lines(state_->gap_line, lines);
}

void FaceScene::forget() {
  state_->first.hide();
  state_->second.hide();
  set_gap(std::nullopt);
  state_->bar.show(false);
  state_->draw_marks();
}

void FaceScene::set_options(const SceneOptions& options) {
  state_->options = options;
  state_->set_options();
  state_->draw_marks();
  fit();
  state_->view.reset_clipping();
}

void FaceScene::set_colours(const SceneColours& colours) {
  state_->colours = colours;
  state_->apply_style();
}

void FaceScene::set_marks(SceneMarks marks) {
  state_->marks = std::move(marks);
  state_->draw_marks();
}

void FaceScene::set_scale(double pixels_per_unit) {
  state_->scale = pixels_per_unit;
  state_->apply_style();
}

void FaceScene::set_viewpoint(Viewpoint viewpoint) {
  state_->has_view_pose = false;
  state_->viewpoint = viewpoint;
  state_->aim_camera();
}

bool FaceScene::set_moving(bool is_moving) {
  constexpr int kMaxVertices = 30000;  // 30 frames a second, drawn in software
  bool is_changed = false;
  for (FingerActors* face : {&state_->first, &state_->second})
    is_changed = face->set_moving(is_moving, kMaxVertices) || is_changed;
  return is_changed;
}

void FaceScene::fit() {
  state_->bar.set_position(state_->window->GetSize(), state_->scale);
  if (state_->view.is_unchanged()) state_->aim_camera();
}

Viewpoint FaceScene::viewpoint() const { return state_->viewpoint; }

void FaceScene::turn(double right_deg, double up_deg) { state_->view.turn(right_deg, up_deg); }

void FaceScene::shift(double right_part, double up_part) {
  state_->view.shift(right_part, up_part);
}

void FaceScene::dolly(double factor) { state_->view.dolly(factor); }

void FaceScene::set_view_pose(const ViewPose& pose) {
  state_->view.set_view_pose(pose);
  state_->has_view_pose = true;
}

ViewPose FaceScene::view_pose() const { return state_->view.pose(); }

std::optional<cv::Point2d> FaceScene::pixel_at(double x, double y) const {
  const int* size = state_->window->GetSize();
  if (size[0] <= 0 || size[1] <= 0) return std::nullopt;
  const auto world = [&](double depth) {
    double at[3] = {2 * x / size[0] - 1, 1 - 2 * y / size[1], depth};
    state_->renderer->ViewToWorld(at[0], at[1], at[2]);
    return Eigen::Vector3d(at[0], at[1], at[2]);
  };
  const Eigen::Vector3d near = world(-1), far = world(1);
  const auto first = state_->first.hit(near, far - near);
  const auto second = state_->second.hit(near, far - near);
  if (!first || (second && second->along < first->along)) return std::nullopt;
  return first->pixel;
}

std::optional<cv::Point2d> FaceScene::window_pixel_of(cv::Point2d pixel) const {
  const auto at = state_->first.point_of(pixel);
  if (!at) return std::nullopt;
  double x = at->x(), y = at->y(), z = at->z();
  state_->renderer->WorldToView(x, y, z);
  const int* size = state_->window->GetSize();
  return cv::Point2d(0.5 * (x + 1) * size[0], 0.5 * (1 - y) * size[1]);
}

int FaceScene::topologies() const { return state_->first.topologies(); }

}  // namespace alltact
