#include "core/simulation/plan.h"

#include "core/numerics/dispatch.h"
#include "core/numerics/parts.h"
#include "core/numerics/philox.h"
#include "core/simulation/frame_plan.h"
#include "core/simulation/plan_truth.h"

#include <limits>
#include <optional>
#include <set>

namespace alltact {

namespace {

using RadianceRows = std::vector<std::unique_ptr<const RadianceEffect::Rows>>;

ALLTACT_WIDE void set_light(int first,
                            int last,
                            const float* __restrict coverage,
                            const float* __restrict light,
                            float* __restrict value) {
  for (int u = first; u < last; ++u) value[u] = coverage[u] * light[u];
}
ALLTACT_WIDE void cover_light(int first,
                              int last,
                              const float* __restrict coverage,
                              float* __restrict light) {
  for (int u = first; u < last; ++u) light[u] *= coverage[u];
}
ALLTACT_WIDE void add_light(int first,
                            int last,
                            const float* __restrict coverage,
                            const float* __restrict light,
                            float* __restrict value) {
  for (int u = first; u < last; ++u) value[u] += coverage[u] * light[u];
}

// Where no light was added up.
void darken_rest(const RowView& row) {
  std::fill(row.value, row.value + row.lit_first, 0.0F);
  std::fill(row.value + row.lit_last, row.value + row.width, 0.0F);
}

// What reaches the sensor, in the columns that row.lit_first and row.lit_last tell: every surface's
// light by the part of the pixel that it covers. Where row.value is not given it becomes a row of
// scratch: that of the light, if there is one surface only.
void add_up_light(RowView& row) {
  const Surface& face = row.surfaces.front();
  row.lit_first = face.first;
  row.lit_last = face.last;
  if (!row.value && row.surfaces.size() == 1) {
    row.value = face.light;
    return cover_light(face.first, face.last, face.coverage, face.light);
  }
  if (!row.value) row.value = row.scratch.floats();
  set_light(face.first, face.last, face.coverage, face.light, row.value);
  if (row.surfaces.size() > 1) darken_rest(row);
  for (std::size_t i = 1; i < row.surfaces.size(); ++i) {
    const Surface& more = row.surfaces[i];
    add_light(more.first, more.last, more.coverage, more.light, row.value);
    row.lit_first = std::min(row.lit_first, more.first);
    row.lit_last = std::max(row.lit_last, more.last);
  }
}

RadianceRows light_of(const FramePlan& plan, const FrameGeometry& geometry) {
  RadianceRows light;
  for (const auto& step : plan.radiance)
    light.push_back(step.effect->begin(step.context, geometry));
  return light;
}

}  // namespace

struct Plan::State {
  State(const Scene& s, std::uint64_t seed_, const Camera& camera)
      : scene(s), content(scene.content()), seed(seed_), rays(camera) {}

  Scene scene;
  const Scene::Content& content;
  std::uint64_t seed;
  PixelRays rays;
  std::vector<const Scene::Content::Named*> built;  // for some frame, in the order they run
  struct Frames {
    int first, last;
  };
  std::optional<Frames> without_bytes;  // the first ones that are not of whole grey levels

  [[nodiscard]] FramePlan compiled(int frame) const { return {content, seed, frame}; }
  [[nodiscard]] Status check();
  [[nodiscard]] Status check(const FramePlan& plan, Frames frames) const;
  [[nodiscard]] FrameGeometry geometry_of(const FramePlan& plan) const;
  void render_rows(const FramePlan& plan,
                   const FrameGeometry& geometry,
                   const RadianceRows& light,
                   int first,
                   int last,
                   cv::Mat& picture) const;
  [[nodiscard]] cv::Mat light_before_sensor(const FramePlan& plan,
                                            const FrameGeometry& geometry,
                                            TruthMaps& maps) const;
  void render_light(FramePlan plan, int first, int last, cv::Mat_<float>& grey) const;
  [[nodiscard]] cv::Mat render_in_passes(const FramePlan& plan,
                                         const FrameGeometry& geometry,
                                         int threads) const;
};

// Stretch by stretch of frames that hold the same effects.
Status Plan::State::check() {
  std::set<int> starts{0, content.time.frames};
  for (const auto& named : content.effects) {
    starts.insert(named.presence.first);
    starts.insert(named.presence.end);
  }
  std::set<const Scene::Content::Named*> seen;
  for (auto start = starts.begin(); *start < content.time.frames; ++start) {
    const FramePlan plan = compiled(*start);
    const Frames frames{*start, *std::next(start) - 1};
    if (const Status status = check(plan, frames); !status) return status;
    if (!plan.gives_bytes() && !without_bytes) without_bytes = frames;
    for (const auto* named : plan.effects()) seen.insert(named);
  }
  std::vector<DegreeOfFreedom> dofs;
  for (const auto& named : content.effects) {
    if (!seen.contains(&named)) continue;
    built.push_back(&named);
    for (const DegreeOfFreedom& dof : named.effect->degrees_of_freedom()) dofs.push_back(dof);
  }
  return content.motion.fits(dofs);
}

Status Plan::State::check(const FramePlan& plan, Frames frames) const {
  const FramePlan::Facts facts = plan.facts(content);
  for (const auto* named : plan.effects()) {
    const Status status = named->effect->fits(facts.scene());
    if (status) continue;
    const Message& what = status.error().what;
    const bool in_all = frames.first == 0 && frames.last == content.time.frames - 1;
    return Error{in_all ? what : en::say("{}, in frames {} to {}", what, frames.first, frames.last),
                 named->where,
                 status.error().advice};
  }
  return {};
}

FrameGeometry Plan::State::geometry_of(const FramePlan& plan) const {
  std::optional<FaceCurve> curve;
  if (content.finger.face.kind == FaceKind::kFinRay) {
    curve.emplace(content.base_mm, content.incline_rad, content.length_mm);
    for (const auto& step : plan.geometry) step.effect->shape(step.context, *curve);
    curve->integrate();
  }
  FrameGeometry result(rays, content.finger.face, std::move(curve));
  for (const auto& step : plan.geometry) {
    const std::size_t known = result.contacts.size(), pressed = result.presses.size();
    step.effect->place(step.context, result);
    for (std::size_t i = pressed; i < result.presses.size(); ++i)
      std::visit([&](auto& press) { press.place.contact = known; }, result.presses[i]);
    for (std::size_t i = known; i < result.contacts.size(); ++i)
      result.contacts[i].name = step.named->name;
  }
  return result;
}

void Plan::State::render_rows(const FramePlan& plan,
                              const FrameGeometry& geometry_now,
                              const RadianceRows& light,
                              int first,
                              int last,
                              cv::Mat& picture) const {
  const bool gives_bytes = plan.gives_bytes();
  RowScratch scratch(picture.cols);
  RowView row(picture.cols, scratch);
  for (int v = first; v < last; ++v) {
    scratch.rewind();
    row.v = v;
    row.value = gives_bytes ? nullptr : picture.ptr<float>(v);
    row.bytes = gives_bytes ? picture.ptr<std::uint8_t>(v) : nullptr;
    geometry_now.fill(row);
    for (const auto& effect : light) effect->row(row);
    add_up_light(row);
    // Only counting in grey levels leaves the dark dark.
    if (plan.sensor.empty() || !plan.sensor.front().effect->gives_bytes()) {
      darken_rest(row);
      row.lit_first = 0;
      row.lit_last = row.width;
    }
    for (const auto& step : plan.sensor) step.effect->row(step.context, row);
  }
}

// At the frame's own moment; marks in `maps` what is seen of surfaces beside the face.
cv::Mat Plan::State::light_before_sensor(const FramePlan& plan,
                                         const FrameGeometry& geometry_now,
                                         TruthMaps& maps) const {
  const RadianceRows light = light_of(plan, geometry_now);
  cv::Mat_<float> grey(rays.camera().size());
  RowScratch scratch(grey.cols);
  RowView row(grey.cols, scratch);
  for (int v = 0; v < grey.rows; ++v) {
    scratch.rewind();
    row.v = v;
    row.value = grey[v];
    geometry_now.fill(row);
    for (const auto& effect : light) effect->row(row);
    add_up_light(row);
    for (std::size_t i = 1; i < row.surfaces.size(); ++i)
      for (int u = row.surfaces[i].first; u < row.surfaces[i].last; ++u)
        if (row.surfaces[i].coverage[u] >= 0.5F)
          maps.seen.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(Seen::kSide);
  }
  mark_dots(geometry_now, maps.seen);
  return grey;
}

// Adds up the light of every moment of the rows' exposure.
void Plan::State::render_light(FramePlan plan, int first, int last, cv::Mat_<float>& grey) const {
  RowScratch scratch(grey.cols);
  RowView row(grey.cols, scratch);
  const Exposure& exposure = plan.exposure();
  const int together = exposure.readout == 0 ? grey.rows : exposure.rows_at_once;
  const auto share = 1 / static_cast<float>(exposure.moments);
  for (int top = first; top < last;) {
    const int band = top / together * together;  // the same with any number of threads
    const int end = std::min(band + together, grey.rows), bottom = std::min(end, last);
    for (int i = 0; i < exposure.moments; ++i) {
      plan.move_to(exposure.moment_of((band + end - 1) / 2.0, grey.rows) + exposure.offset_of(i));
      const FrameGeometry geometry_now = geometry_of(plan);
      const RadianceRows light = light_of(plan, geometry_now);
      for (int v = top; v < bottom; ++v) {
        scratch.rewind();
        row.v = v;
        row.value = nullptr;
        geometry_now.fill(row);
        for (const auto& effect : light) effect->row(row);
        add_up_light(row);
        darken_rest(row);
        float* sum = grey[v];
        for (int u = 0; u < grey.cols; ++u) sum[u] += share * row.value[u];
      }
    }
    top = bottom;
  }
}

cv::Mat Plan::State::render_in_passes(const FramePlan& plan,
                                      const FrameGeometry& geometry_now,
                                      int threads) const {
  const cv::Size size = rays.camera().size();
  cv::Mat_<float> grey = cv::Mat_<float>::zeros(size);
  over_parts(
      size.height, threads, [&](int first, int last) { render_light(plan, first, last, grey); });
  cv::Mat bytes;
  if (plan.gives_bytes()) bytes.create(size, CV_8UC1);
  for (auto from = plan.sensor.begin();;) {
    const auto whole = std::find_if(
        from, plan.sensor.end(), [](const auto& step) { return step.effect->needs_picture(); });
    over_parts(size.height, threads, [&](int first, int last) {
      RowScratch scratch(size.width);
      RowView row(size.width, scratch);
      row.lit_last = size.width;
      for (int v = first; v < last; ++v) {
        scratch.rewind();
        row.v = v;
        row.value = grey[v];
        row.bytes = plan.gives_bytes() ? bytes.ptr<std::uint8_t>(v) : nullptr;
        std::for_each(from, whole, [&](const auto& step) { step.effect->row(step.context, row); });
      }
    });
    if (whole == plan.sensor.end()) break;
    whole->effect->picture(whole->context, geometry_now, grey);
    from = whole + 1;
  }
  return plan.gives_bytes() ? bytes : grey;
}

Result<Plan> Plan::compile(const Scene& scene, std::uint64_t seed) {
  const Scene::Content& content = scene.content();
  auto camera = Camera::create(content.finger.camera);
  if (!camera)
    return Error{camera.error().what,
                 en::say("scene '{}': finger.camera", content.name),
                 camera.error().advice};
  // The noise of a recording must not be that of the press that is compared with it.
  seed ^= std::uint64_t{fnv1a(content.name)} << 32;
  auto state = std::make_shared<State>(scene, seed, *camera);
  if (const Status status = state->check(); !status) return status.error();
  Plan plan;
  plan.state_ = std::move(state);
  return plan;
}

int Plan::frame_count() const {
  return state_->content.time.frames;
}
double Plan::frames_per_s() const {
  return state_->content.time.frames_per_s;
}
const Finger& Plan::finger() const {
  return state_->content.finger;
}

std::vector<std::string> Plan::effects() const {
  std::vector<std::string> names;
  for (const auto* named : state_->built) names.push_back(named->name);
  return names;
}

std::vector<std::string> Plan::effects(int frame) const {
  std::vector<std::string> names;
  for (const auto* named : state_->compiled(frame).effects()) names.push_back(named->name);
  return names;
}

std::vector<Plan::Entry> Plan::entries() const {
  std::vector<Entry> entries;
  for (const auto* named : state_->built)
    entries.push_back(
        {named->name, named->effect->sentence(), named->presence.first, named->presence.end - 1});
  return entries;
}

Status Plan::check_grey_levels(const std::string& scene_file) const {
  if (!state_->without_bytes) return {};
  const auto [first, last] = *state_->without_bytes;
  if (first == 0 && last == frame_count() - 1)
    return Error{en::say("its camera does not give whole grey levels"),
                 scene_file,
                 en::say("name the effect quantisation too")};
  return Error{
      en::say("its camera does not give whole grey levels in frames {} to {}", first, last),
      scene_file,
      en::say("name the effect quantisation for all frames")};
}

cv::Mat Plan::render(int frame, int threads) const {
  return send(frame, threads).grey;
}

Arrival Plan::arrival(int frame) const {
  Arrival arrival;
  for (const auto& step : state_->compiled(frame).transport)
    step.effect->arrival(step.context, arrival);
  return arrival;
}

SentPicture Plan::send(int frame, int threads) const {
  const State& s = *state_;
  const FramePlan plan = s.compiled(frame);
  const FrameGeometry geometry = s.geometry_of(plan);
  cv::Mat picture;
  if (plan.in_passes()) {
    picture = s.render_in_passes(plan, geometry, threads);
  } else {
    const RadianceRows light = light_of(plan, geometry);
    picture.create(s.rays.camera().size(), plan.gives_bytes() ? CV_8UC1 : CV_32FC1);
    over_parts(picture.rows, threads, [&](int first, int last) {
      s.render_rows(plan, geometry, light, first, last, picture);
    });
  }
  SentPicture sent{std::move(picture), nullptr};
  for (const auto& step : plan.transport) step.effect->picture(step.context, sent);
  return sent;
}

Truth Plan::truth(int frame, TruthDetail detail) const {
  const FramePlan plan = state_->compiled(frame);
  return truth_of(plan, state_->geometry_of(plan), detail);
}

TruthMaps Plan::truth_maps(int frame) const {
  const FramePlan plan = state_->compiled(frame);
  FrameGeometry geometry = state_->geometry_of(plan);
  TruthMaps maps = truth_maps_of(geometry);
  // What stands on the face stays; only the presses go.
  geometry.presses.clear();
  maps.untouched_grey = state_->light_before_sensor(plan, geometry, maps);
  return maps;
}

}  // namespace alltact
