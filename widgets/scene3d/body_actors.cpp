#include "widgets/scene3d/body_actors.h"

#include "widgets/scene3d/scene_lines.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace alltact {
namespace {

constexpr double kSeen[3] = {0.34, 0.71, 0.91}, kGuessed[3] = {0.60, 0.60, 0.60};

vtkSmartPointer<vtkActor> wall_actor(vtkPolyData* data) {
  const vtkNew<vtkPolyDataMapper> mapper;
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
void add_walls(Quads& quads,
               const std::vector<FingerBody::Section>& sections,
               bool with_face,
               bool with_first_end) {
  if (sections.size() < 2) return;
  std::vector<std::array<vtkIdType, 4>> ids;
  for (const FingerBody::Section& section : sections)
    ids.push_back({quads.add(section[0]),
                   quads.add(section[1]),
                   quads.add(section[2]),
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
    : walls_(wall_actor(walls_data_)),
      base_(wall_actor(base_data_)),
      edges_(line_actor(edges_data_, 15)),
      back_(line_actor(back_data_, 15)),
      seen_(line_actor(seen_data_, 15)),
      guessed_(line_actor(guessed_data_, 15)) {
  for (const auto& dots : {seen_, guessed_}) dots->GetProperty()->SetRenderPointsAsSpheres(true);
  seen_->GetProperty()->SetColor(kSeen[0], kSeen[1], kSeen[2]);
  guessed_->GetProperty()->SetColor(kGuessed[0], kGuessed[1], kGuessed[2]);
  base_->GetProperty()->BackfaceCullingOn();
  for (vtkActor* actor : all()) renderer->AddActor(actor);
  set_viewpoint(false, false);
}

BodyActors::~BodyActors() = default;

std::array<vtkActor*, 6> BodyActors::all() const {
  return {walls_, base_, edges_, back_, seen_, guessed_};
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
  constexpr double kWalls = 0.16, kBase = 0.34, kEdges = 0.55;
  mix(walls_, colours, kWalls);
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
  walls_->GetProperty()->SetFrontfaceCulling(!is_outside);
  walls_->GetProperty()->SetBackfaceCulling(is_outside);
  is_behind_base_ = is_behind_base;
  show_parts();
}

}  // namespace alltact
