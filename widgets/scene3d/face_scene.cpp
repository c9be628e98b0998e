#include "widgets/scene3d/face_scene.h"

#include "widgets/scene3d/colour_bar.h"
#include "widgets/scene3d/finger_actors.h"
#include "widgets/scene3d/mark_actors.h"
#include "widgets/scene3d/scene_lines.h"
#include "widgets/scene3d/scene_view.h"

#include <cmath>

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace alltact {
namespace {

constexpr double kGripperAxis_mm = 20;

/// Both lights turn with the eye. With the ambient light they add up to 1 on surfaces that face it.
void light(vtkRenderer* renderer) {
  constexpr double kHead = 0.25;
  const Eigen::Vector3d key(-0.9, 0.25, 0.75);  // in the eye's frame: right, up, back
  renderer->AutomaticLightCreationOff();
  renderer->RemoveAllLights();
  for (const auto& [from, strength] : {std::pair{Eigen::Vector3d(0, 0, 1), kHead},
                                       {key, (1 - kFaceAmbient - kHead) / key.normalized().z()}}) {
    const vtkNew<vtkLight> lamp;
    lamp->SetLightTypeToCameraLight();
    lamp->SetPosition(from.data());
    lamp->SetFocalPoint(0, 0, 0);
    lamp->SetIntensity(strength);
    renderer->AddLight(lamp);
  }
}

}  // namespace

/// All of it is opaque: blending costs passes over the full window, which are slow in software.
struct FaceScene::State {
  vtkRenderWindow* window;
  vtkNew<vtkRenderer> renderer;
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
    light(renderer);
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
  bar.apply_style(text);
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
  view.look_at(
      subject, viewpoint, window->GetSize(), ColourBar::free_fraction(window->GetSize(), scale));
}

void FaceScene::State::shown(bool is_first) {
  bar.show(first.has_depth());
  draw_marks();
  if (is_first && !has_view_pose) aim_camera();
  view.reset_clipping();
}

FaceScene::FaceScene(vtkRenderWindow* window) : state_(std::make_unique<State>(window)) {
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

Viewpoint FaceScene::viewpoint() const {
  return state_->viewpoint;
}

void FaceScene::turn(double right_deg, double up_deg) {
  state_->view.turn(right_deg, up_deg);
}

void FaceScene::shift(double right_part, double up_part) {
  state_->view.shift(right_part, up_part);
}

void FaceScene::dolly(double factor) {
  state_->view.dolly(factor);
}

void FaceScene::set_view_pose(const ViewPose& pose) {
  state_->view.set_view_pose(pose);
  state_->has_view_pose = true;
}

ViewPose FaceScene::view_pose() const {
  return state_->view.pose();
}

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

int FaceScene::topologies() const {
  return state_->first.topologies();
}

}  // namespace alltact
