#include "core/simulation/plan.h"

#include "core/numerics/dispatch.h"
#include "core/numerics/parallel.h"
#include "core/numerics/philox.h"
#include "core/simulation/simulated_frame.h"

#include <array>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

namespace alltact {

FramePlan::FramePlan(const Scene& scene, std::uint64_t seed, int frame) {
  const int frame_of_scene = frame % scene.time.frames;
  for (const auto& named : scene.effects) {
    if (!named.presence.holds(frame_of_scene)) continue;
    const auto add = [&]<class E>(std::vector<Step<E>>& steps) {
      steps.push_back({&named,
                       static_cast<const E*>(named.effect.get()),
                       {seed ^ named.stream, frame, scene.motion, scene.finger,
                        scene.time.frames_per_s, seed}});
      ++build_count().steps;
    };
    switch (named.kind->stage) {
      case Stage::kGeometry:
        add(geometry);
        break;
      case Stage::kRadiance:
        add(radiance);
        break;
      case Stage::kSensor:
        add(sensor);
        outputs_bytes_ = outputs_bytes_ || sensor.back().effect->outputs_bytes();
        is_multi_pass_ = is_multi_pass_ || sensor.back().effect->needs_full_image();
        break;
      case Stage::kTransport:
        add(transport);
        break;
    }
  }
  if (sensor.empty()) return;
  const SceneFacts known = facts(scene);
  for (const auto& step : sensor) step.effect->expose(known, exposure_);
  is_multi_pass_ = is_multi_pass_ || !exposure_.is_instantaneous();
}

void FramePlan::move_to(double frame_offset) {
  for (auto& step : geometry) step.context.frame_offset = frame_offset;
  for (auto& step : radiance) step.context.frame_offset = frame_offset;
}

SceneFacts FramePlan::facts(const Scene& scene) const {
  SceneFacts facts{scene.finger, scene.length_mm, {},     scene.time.frames_per_s, 0,
                   false,        false,           nullptr};
  for (const auto* named : effects()) {
    facts.named.push_back(named->kind->name);
    facts.lamp_count += named->effect->lamp_count();
    facts.ball_presses = facts.ball_presses || named->effect->presses_ball();
    facts.body_presses = facts.body_presses || named->effect->presses_body();
    if (const ElasticFinger* elastic = named->effect->elastic()) facts.elastic = elastic;
  }
  return facts;
}

std::vector<const SceneEffect*> FramePlan::effects() const {
  std::vector<const SceneEffect*> all;
  const auto take = [&](const auto& steps) {
    for (const auto& step : steps) all.push_back(step.named);
  };
  take(geometry), take(radiance), take(sensor), take(transport);
  return all;
}

namespace {

constexpr float kOff = std::numeric_limits<float>::quiet_NaN();
constexpr float kSlopeStep_mm = 0.02F;  // step of the differences for a pressed face's slopes

// Press depth in the columns of a row where something may press, `step_mm` further along an axis.
std::vector<float> shifted_depth(const FrameGeometry& geometry, const RowView& row,
                                 const std::vector<Eigen::Vector2f>& luf_slopes, std::size_t axis,
                                 float step_mm) {
  const FaceRow& here = row.face;
  const auto copied = [&](const float* values) {
    return std::vector<float>(values, values + row.width);
  };
  std::vector<float> x = copied(here.x_mm), y = copied(here.y_mm), luf = copied(here.luf_mm);
  std::vector<float> s = copied(here.s_mm);
  for (int u = row.press_first; u < row.press_last; ++u) {
    const auto i = static_cast<std::size_t>(u);
    (axis == 0 ? x : y)[i] += step_mm;
    luf[i] += step_mm * luf_slopes[i][static_cast<int>(axis)];
    if (axis == 0) s[i] += step_mm / here.cos_incline[u];
  }
  FaceRow shifted = here;
  shifted.x_mm = x.data();
  shifted.y_mm = y.data();
  shifted.luf_mm = luf.data();
  shifted.s_mm = s.data();
  std::vector<float> depth(x.size(), 0.0F);
  for (const auto& press : geometry.presses)
    std::visit(
        [&](const auto& p) {
          press_row(p, shifted, row.press_first, row.press_last, depth.data());
        },
        press);
  return depth;
}

// d(depth)/dx (axis 0) or d(depth)/dy (1) in those columns, by differences.
std::vector<float> depth_slopes(const FrameGeometry& geometry, const RowView& row,
                                const std::vector<Eigen::Vector2f>& luf_slopes, std::size_t axis) {
  const auto ahead = shifted_depth(geometry, row, luf_slopes, axis, kSlopeStep_mm);
  std::vector<float> slope = shifted_depth(geometry, row, luf_slopes, axis, -kSlopeStep_mm);
  for (std::size_t u = 0; u < slope.size(); ++u)
    slope[u] = (ahead[u] - slope[u]) / (2 * kSlopeStep_mm);
  return slope;
}

void set_normals(const FrameGeometry& geometry, const RowView& row, cv::Vec3f* normals) {
  const FaceRow& face = row.face;
  std::vector<Eigen::Vector2f> slopes(static_cast<std::size_t>(row.width), Eigen::Vector2f::Zero());
  for (int u = face.first; u < face.last; ++u) {
    if (face.coverage[u] < 0.5F) continue;
    const Eigen::Vector3d n =
        geometry.press_pose(face.s_mm[u], face.y_mm[u] - face.shift_mm[u], 0).normal;
    slopes[static_cast<std::size_t>(u)] = (-n.head<2>() / n.z()).cast<float>();
  }
  std::array<std::vector<float>, 2> depth;
  if (row.press_first < row.press_last)
    depth = {depth_slopes(geometry, row, slopes, 0), depth_slopes(geometry, row, slopes, 1)};
  for (int u = face.first; u < face.last; ++u) {
    if (face.coverage[u] < 0.5F) continue;
    const auto i = static_cast<std::size_t>(u);
    Eigen::Vector3f normal(-slopes[i].x(), -slopes[i].y(), 1);
    if (u >= row.press_first && u < row.press_last)
      normal += Eigen::Vector3f(depth[0][i], depth[1][i], 0);
    normal.normalize();
    normals[u] = {normal.x(), normal.y(), normal.z()};
  }
}

void set_contacts(const FrameGeometry& geometry, const RowView& row, std::uint8_t* contacts) {
  for (const auto& press : geometry.presses)
    std::visit(
        [&](const auto& p) {
          for (int u = row.press_first; u < row.press_last; ++u)
            if (row.face.coverage[u] >= 0.5F && is_in_contact(p, row.face, u))
              contacts[u] = static_cast<std::uint8_t>(p.pose.contact + 1);
        },
        press);
}

void set_images(const FrameGeometry& geometry, Truth& truth) {
  const cv::Size size = geometry.rays().camera().size();
  truth.depth_mm = cv::Mat(size, CV_32FC1, cv::Scalar::all(kOff));
  truth.view_z_mm = truth.depth_mm.clone();
  truth.untouched_z_mm = truth.depth_mm.clone();
  RowScratch scratch(size.width);
  RowView row(size.width, scratch);
  for (int v = 0; v < size.height; ++v) {
    scratch.rewind();
    row.v = v;
    geometry.fill(row);
    for (int u = row.face.first; u < row.face.last; ++u) {
      if (row.face.coverage[u] < 0.5F) continue;  // the pixel's centre is off the face
      const bool pressed = u >= row.press_first && u < row.press_last;
      truth.depth_mm.at<float>(v, u) = pressed ? row.press_depth_mm[u] : 0.0F;
      truth.view_z_mm.at<float>(v, u) = row.face.z_mm[u];
      truth.untouched_z_mm.at<float>(v, u) = row.face.z_mm[u] + row.face.luf_mm[u];
    }
  }
}

Truth truth_of(const FramePlan& plan, const FrameGeometry& geometry, TruthDetail detail) {
  Truth truth;
  if (detail == TruthDetail::kAll) set_images(geometry, truth);
  for (const MarkerDisc& disc : geometry.discs)
    truth.markers.push_back({disc.centre_px.x(), disc.centre_px.y(), disc.visible});
  for (const auto& press : geometry.presses)
    if (const auto* ball = std::get_if<BallPress>(&press))
      truth.balls.push_back({ball->centre_mm, ball->radius_mm, ball->pose.depth_mm});
  if (!truth.balls.empty()) truth.ball = truth.balls.front();
  truth.contacts = geometry.contacts;
  for (const auto& step : plan.geometry)
    for (const DegreeOfFreedom& dof : step.effect->degrees_of_freedom())
      truth.pose[dof.name] = step.context(dof);
  if (const FaceCurve* curve = geometry.curve(); curve && curve->response) {
    const Eigen::Vector4d& modes = *curve->response;
    truth.pose["q1_mm"] += modes[0];
    truth.pose["q2_mm"] += modes[1];
    truth.pose["sway_mm"] += modes[2];
    truth.pose["twist_deg"] += modes[3] * 180 / std::numbers::pi;
  }
  return truth;
}

/// The part given by the view face alone: all but `untouched_grey`, and `seen` without the sides.
TruthMaps truth_maps_of(const FrameGeometry& geometry) {
  const cv::Size size = geometry.rays().camera().size();
  TruthMaps maps;
  maps.contact = cv::Mat::zeros(size, CV_8UC1);
  maps.labels = cv::Mat::zeros(size, CV_8UC1);
  maps.normal = cv::Mat(size, CV_32FC3, cv::Scalar::all(kOff));
  RowScratch scratch(size.width);
  RowView row(size.width, scratch);
  for (int v = 0; v < size.height; ++v) {
    scratch.rewind();
    row.v = v;
    geometry.fill(row);
    set_normals(geometry, row, maps.normal.ptr<cv::Vec3f>(v));
    set_contacts(geometry, row, maps.contact.ptr<std::uint8_t>(v));
    for (int u = row.face.first; u < row.face.last; ++u)
      if (row.face.coverage[u] >= 0.5F)
        maps.labels.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(PixelLabel::kFace);
  }
  return maps;
}

/// Marks dots, and folds over dots, next to the face in `seen` (TruthMaps::seen).
void mark_dots(const FrameGeometry& geometry, cv::Mat& labels) {
  for (const MarkerDisc& disc : geometry.discs)
    for (int row = 0; row < disc.coverage.rows; ++row)
      for (int column = 0; column < disc.coverage.cols; ++column) {
        auto& here = labels.at<std::uint8_t>(disc.corner.y + row, disc.corner.x + column);
        if (disc.coverage(row, column) < 0.5F ||
            here == static_cast<std::uint8_t>(PixelLabel::kFace))
          continue;
        here =
            static_cast<std::uint8_t>(disc.visible ? PixelLabel::kDot : PixelLabel::kFoldOverDot);
      }
}

using RadianceRows = std::vector<RadianceEffect::Rows>;

ALLTACT_WIDE void set_light(int first, int last, const float* __restrict coverage,
                            const float* __restrict light, float* __restrict value) {
  for (int u = first; u < last; ++u) value[u] = coverage[u] * light[u];
}
ALLTACT_WIDE void cover_light(int first, int last, const float* __restrict coverage,
                              float* __restrict light) {
  for (int u = first; u < last; ++u) light[u] *= coverage[u];
}
ALLTACT_WIDE void add_light(int first, int last, const float* __restrict coverage,
                            const float* __restrict light, float* __restrict value) {
  for (int u = first; u < last; ++u) value[u] += coverage[u] * light[u];
}

// Fills the columns without light.
void darken_rest(const RowView& row) {
  std::fill(row.value, row.value + row.lit_first, 0.0F);
  std::fill(row.value + row.lit_last, row.value + row.width, 0.0F);
}

// Sums every surface's light times its coverage into row.value, and sets row.lit_first and
// row.lit_last. If row.value is null it becomes a scratch row: that of the light, if there is one
// surface only.
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
  for (const auto& step : plan.radiance) {
    light.push_back(step.effect->begin(step.context, geometry));
    ++build_count().rows;
  }
  return light;
}

}  // namespace

struct Plan::State {
  State(const Scene& s, std::uint64_t seed_, const Camera& camera)
      : scene(s), seed(seed_), rays(camera) {}

  Scene scene;
  std::uint64_t seed;
  PixelRays rays;
  std::vector<const SceneEffect*> built;  // for some frame, in running order
  struct Frames {
    int first, last;
  };
  std::optional<Frames> without_bytes;  // the first ones without integer grey levels

  [[nodiscard]] FramePlan compiled(int frame) const { return {scene, seed, frame}; }
  [[nodiscard]] Status check();
  [[nodiscard]] Status check(const FramePlan& plan, Frames frames) const;
  [[nodiscard]] FrameGeometry geometry_of(const FramePlan& plan) const;
  void render_rows(const FramePlan& plan, const FrameGeometry& geometry, const RadianceRows& light,
                   int first, int last, cv::Mat& image) const;
  [[nodiscard]] cv::Mat light_before_sensor(const FramePlan& plan, const FrameGeometry& geometry,
                                            TruthMaps& maps) const;
  void render_light(FramePlan plan, int first, int last, cv::Mat_<float>& grey) const;
  [[nodiscard]] cv::Mat render_multi_pass(const FramePlan& plan, const FrameGeometry& geometry,
                                          int threads) const;
};

// Checks each run of frames with the same effects.
Status Plan::State::check() {
  std::set<int> starts{0, scene.time.frames};
  for (const auto& named : scene.effects) {
    starts.insert(named.presence.first);
    starts.insert(named.presence.end);
  }
  std::set<const SceneEffect*> present;
  for (auto start = starts.begin(); *start < scene.time.frames; ++start) {
    const FramePlan plan = compiled(*start);
    const Frames frames{*start, *std::next(start) - 1};
    if (const Status status = check(plan, frames); !status) return status;
    if (!plan.outputs_bytes() && !without_bytes) without_bytes = frames;
    for (const auto* named : plan.effects()) present.insert(named);
  }
  std::vector<DegreeOfFreedom> dofs;
  for (const auto& named : scene.effects) {
    if (!present.contains(&named)) continue;
    built.push_back(&named);
    for (const DegreeOfFreedom& dof : named.effect->degrees_of_freedom()) dofs.push_back(dof);
  }
  return scene.motion.validate(dofs);
}

Status Plan::State::check(const FramePlan& plan, Frames frames) const {
  const SceneFacts facts = plan.facts(scene);
  for (const auto* named : plan.effects()) {
    const Status status = named->effect->validate(facts);
    if (status) continue;
    const Message& what = status.error().what;
    const bool in_all = frames.first == 0 && frames.last == scene.time.frames - 1;
    return Error{in_all ? what : en::say("{}, in frames {} to {}", what, frames.first, frames.last),
                 named->where, status.error().advice};
  }
  return {};
}

FrameGeometry Plan::State::geometry_of(const FramePlan& plan) const {
  std::optional<FaceCurve> curve;
  if (scene.finger.face.kind == FaceKind::kFinRay) {
    curve.emplace(scene.base_mm, scene.incline_rad, scene.length_mm);
    for (const auto& step : plan.geometry) step.effect->shape(step.context, *curve);
    curve->integrate();
  }
  FrameGeometry result(rays, scene.finger.face, std::move(curve));
  for (const auto& step : plan.geometry) {
    const std::size_t known = result.contacts.size(), pressed = result.presses.size();
    step.effect->apply(step.context, result);
    for (std::size_t i = pressed; i < result.presses.size(); ++i)
      std::visit([&](auto& press) { press.pose.contact = known; }, result.presses[i]);
    for (std::size_t i = known; i < result.contacts.size(); ++i)
      result.contacts[i].name = step.named->name;
  }
  return result;
}

void Plan::State::render_rows(const FramePlan& plan, const FrameGeometry& geometry_now,
                              const RadianceRows& light, int first, int last,
                              cv::Mat& image) const {
  const bool outputs_bytes = plan.outputs_bytes();
  RowScratch scratch(image.cols);
  RowView row(image.cols, scratch);
  for (int v = first; v < last; ++v) {
    scratch.rewind();
    row.v = v;
    row.value = outputs_bytes ? nullptr : image.ptr<float>(v);
    row.bytes = outputs_bytes ? image.ptr<std::uint8_t>(v) : nullptr;
    geometry_now.fill(row);
    for (const auto& set_light_of : light) set_light_of(row);
    add_up_light(row);
    // Only quantisation leaves dark columns dark; other effects need the full row.
    if (plan.sensor.empty() || !plan.sensor.front().effect->outputs_bytes()) {
      darken_rest(row);
      row.lit_first = 0;
      row.lit_last = row.width;
    }
    for (const auto& step : plan.sensor) step.effect->row(step.context, row);
  }
}

// At the frame's own time. Marks the visible surfaces other than the face in `maps`.
cv::Mat Plan::State::light_before_sensor(const FramePlan& plan, const FrameGeometry& geometry_now,
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
    for (const auto& set_light_of : light) set_light_of(row);
    add_up_light(row);
    for (std::size_t i = 1; i < row.surfaces.size(); ++i)
      for (int u = row.surfaces[i].first; u < row.surfaces[i].last; ++u)
        if (row.surfaces[i].coverage[u] >= 0.5F)
          maps.labels.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(PixelLabel::kSide);
  }
  mark_dots(geometry_now, maps.labels);
  return grey;
}

// Sums the light of every sample of the rows' exposure.
void Plan::State::render_light(FramePlan plan, int first, int last, cv::Mat_<float>& grey) const {
  RowScratch scratch(grey.cols);
  RowView row(grey.cols, scratch);
  const Exposure& exposure = plan.exposure();
  const int together = exposure.readout == 0 ? grey.rows : exposure.rows_at_once;
  const auto share = 1 / static_cast<float>(exposure.moments);
  for (int top = first; top < last;) {
    const int band = top / together * together;  // independent of the number of threads
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
        for (const auto& set_light_of : light) set_light_of(row);
        add_up_light(row);
        darken_rest(row);
        float* sum = grey[v];
        for (int u = 0; u < grey.cols; ++u) sum[u] += share * row.value[u];
      }
    }
    top = bottom;
  }
}

cv::Mat Plan::State::render_multi_pass(const FramePlan& plan, const FrameGeometry& geometry_now,
                                       int threads) const {
  const cv::Size size = rays.camera().size();
  cv::Mat_<float> grey(size, 0.0F);
  parallel_for(size.height, threads,
               [&](int first, int last) { render_light(plan, first, last, grey); });
  cv::Mat bytes;
  if (plan.outputs_bytes()) bytes.create(size, CV_8UC1);
  for (auto from = plan.sensor.begin();;) {
    const auto full_image = std::find_if(
        from, plan.sensor.end(), [](const auto& step) { return step.effect->needs_full_image(); });
    parallel_for(size.height, threads, [&](int first, int last) {
      RowScratch scratch(size.width);
      RowView row(size.width, scratch);
      row.lit_last = size.width;
      for (int v = first; v < last; ++v) {
        scratch.rewind();
        row.v = v;
        row.value = grey[v];
        row.bytes = plan.outputs_bytes() ? bytes.ptr<std::uint8_t>(v) : nullptr;
        std::for_each(from, full_image,
                      [&](const auto& step) { step.effect->row(step.context, row); });
      }
    });
    if (full_image == plan.sensor.end()) break;
    full_image->effect->process_image(full_image->context, geometry_now, grey);
    from = full_image + 1;
  }
  return plan.outputs_bytes() ? bytes : grey;
}

Result<Plan> Plan::compile(const Scene& scene, std::uint64_t seed) {
  auto camera = Camera::create(scene.finger.camera);
  if (!camera)
    return Error{camera.error().what, en::say("scene '{}': finger.camera", scene.name),
                 camera.error().advice};
  // A recording and the press compared with it must not share noise.
  seed ^= std::uint64_t{fnv1a(scene.name)} << 32;
  auto state = std::make_shared<State>(scene, seed, *camera);
  if (const Status status = state->check(); !status) return status.error();
  Plan plan;
  plan.state_ = std::move(state);
  return plan;
}

int Plan::frame_count() const { return state_->scene.time.frames; }
double Plan::frames_per_s() const { return state_->scene.time.frames_per_s; }
const Finger& Plan::finger() const { return state_->scene.finger; }

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
        {named->name, named->kind->sentence, named->presence.first, named->presence.end - 1});
  return entries;
}

Status Plan::check_grey_levels(const std::string& scene_file) const {
  if (!state_->without_bytes) return {};
  const auto [first, last] = *state_->without_bytes;
  if (first == 0 && last == frame_count() - 1)
    return Error{en::say("its camera does not deliver integer grey levels"), scene_file,
                 en::say("add the effect quantisation")};
  return Error{
      en::say("its camera does not deliver integer grey levels in frames {} to {}", first, last),
      scene_file, en::say("add the effect quantisation for all frames")};
}

cv::Mat Plan::render(int frame, int threads) const { return send(frame, threads).grey; }

Arrival Plan::arrival(int frame) const {
  Arrival arrival;
  for (const auto& step : state_->compiled(frame).transport)
    step.effect->arrival(step.context, arrival);
  return arrival;
}

SentFrame Plan::send(int frame, int threads) const {
  const State& s = *state_;
  const FramePlan plan = s.compiled(frame);
  const FrameGeometry geometry = s.geometry_of(plan);
  cv::Mat image;
  if (plan.is_multi_pass()) {
    image = s.render_multi_pass(plan, geometry, threads);
  } else {
    const RadianceRows light = light_of(plan, geometry);
    image.create(s.rays.camera().size(), plan.outputs_bytes() ? CV_8UC1 : CV_32FC1);
    parallel_for(image.rows, threads, [&](int first, int last) {
      s.render_rows(plan, geometry, light, first, last, image);
    });
  }
  SentFrame sent{std::move(image), nullptr};
  for (const auto& step : plan.transport) step.effect->process_image(step.context, sent);
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
  // Objects on the face remain; only the presses are removed.
  geometry.presses.clear();
  maps.untouched_grey = state_->light_before_sensor(plan, geometry, maps);
  return maps;
}

}  // namespace alltact
