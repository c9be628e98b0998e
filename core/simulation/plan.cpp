#include "core/simulation/plan.h"

#include "core/numerics/philox.h"
#include "core/simulation/scene_content.h"

#include <limits>
#include <thread>

namespace alltact {

namespace {

using RadianceRows = std::vector<std::unique_ptr<const RadianceEffect::Rows>>;

// What reaches the sensor: every surface's light by the part of the pixel that it covers.
void add_up_light(const RowView& row) {
  std::fill(row.value, row.value + row.width, 0.0F);
  for (const Surface& surface : row.surfaces) {
    float* __restrict value = row.value;
    const float* __restrict light = surface.light;
    const float* __restrict coverage = surface.coverage;
    for (int u = surface.first; u < surface.last; ++u) value[u] += coverage[u] * light[u];
  }
}

// Calls work(first, last) for all of `rows`, cut into as many parts as there are threads.
template <class Work>
void over_rows(int rows, int threads, const Work& work) {
  const int parts = std::clamp(threads, 1, rows);
  const auto row_at = [&](int part) { return static_cast<int>(std::int64_t{rows} * part / parts); };
  std::vector<std::jthread> helpers;
  for (int part = 1; part < parts; ++part)
    helpers.emplace_back([&, part] { work(row_at(part), row_at(part + 1)); });
  work(0, row_at(1));
}

}  // namespace

struct Plan::State {
  State(const Scene& s, std::uint64_t seed_, const Camera& camera)
      : scene(s), content(scene.content()), seed(seed_), rays(camera) {}

  Scene scene;
  const Scene::Content& content;
  std::uint64_t seed;
  PixelRays rays;
  std::vector<const GeometryEffect*> geometry;
  std::vector<const RadianceEffect*> radiance;
  std::vector<const SensorEffect*> sensor;
  std::vector<const TransportEffect*> transport;
  std::vector<DegreeOfFreedom> dofs;
  bool gives_bytes = false;
  bool in_passes = false;  // an effect needs more than a row at a time
  Exposure exposure;

  void add(const Scene::Content::Named& named);
  [[nodiscard]] FrameContext context(int frame) const {
    return {seed, frame, content.motion, content.finger, content.frames_per_s};
  }
  [[nodiscard]] FrameGeometry geometry_of(const FrameContext& frame) const;
  void render_rows(const FrameContext& frame,
                   const FrameGeometry& geometry,
                   const RadianceRows& light,
                   int first,
                   int last,
                   cv::Mat& picture) const;
  void render_light(FrameContext frame, int first, int last, cv::Mat_<float>& grey) const;
  [[nodiscard]] cv::Mat render_in_passes(const FrameContext& frame,
                                         const FrameGeometry& geometry,
                                         int threads) const;
  [[nodiscard]] RadianceRows light_of(const FrameContext& frame,
                                      const FrameGeometry& geometry_now) const {
    RadianceRows light;
    for (const RadianceEffect* effect : radiance)
      light.push_back(effect->begin(frame, geometry_now));
    return light;
  }
};

void Plan::State::add(const Scene::Content::Named& named) {
  const Effect* effect = named.effect.get();
  switch (named.kind->stage) {
    case Stage::kGeometry:
      geometry.push_back(static_cast<const GeometryEffect*>(effect));
      break;
    case Stage::kRadiance:
      radiance.push_back(static_cast<const RadianceEffect*>(effect));
      break;
    case Stage::kSensor:
      sensor.push_back(static_cast<const SensorEffect*>(effect));
      gives_bytes = gives_bytes || sensor.back()->gives_bytes();
      in_passes = in_passes || sensor.back()->needs_picture();
      break;
    case Stage::kTransport:
      transport.push_back(static_cast<const TransportEffect*>(effect));
      break;
  }
  for (const DegreeOfFreedom& dof : effect->degrees_of_freedom()) dofs.push_back(dof);
}

FrameGeometry Plan::State::geometry_of(const FrameContext& frame) const {
  std::optional<FaceCurve> curve;
  if (content.finger.face.kind == FaceKind::kFinRay) {
    curve.emplace(content.base_mm, content.incline_rad, content.length_mm);
    for (const GeometryEffect* effect : geometry) effect->shape(frame, *curve);
    curve->integrate();
  }
  FrameGeometry result(rays, content.finger.face, std::move(curve));
  for (const GeometryEffect* effect : geometry) effect->place(frame, result);
  return result;
}

void Plan::State::render_rows(const FrameContext& frame,
                              const FrameGeometry& geometry_now,
                              const RadianceRows& light,
                              int first,
                              int last,
                              cv::Mat& picture) const {
  RowScratch scratch(picture.cols);
  RowView row(picture.cols, scratch);
  for (int v = first; v < last; ++v) {
    scratch.rewind();
    row.v = v;
    row.value = gives_bytes ? scratch.floats() : picture.ptr<float>(v);
    row.bytes = gives_bytes ? picture.ptr<std::uint8_t>(v) : nullptr;
    geometry_now.fill(row);
    for (const auto& effect : light) effect->row(row);
    add_up_light(row);
    for (const SensorEffect* effect : sensor) effect->row(frame, row);
  }
}

// Adds up the light of every moment of the rows' exposure.
void Plan::State::render_light(FrameContext frame,
                               int first,
                               int last,
                               cv::Mat_<float>& grey) const {
  RowScratch scratch(grey.cols);
  RowView row(grey.cols, scratch);
  const int together = exposure.readout == 0 ? grey.rows : exposure.rows_at_once;
  const auto share = 1 / static_cast<float>(exposure.moments);
  for (int top = first; top < last;) {
    const int band = top / together * together;  // the same with any number of threads
    const int end = std::min(band + together, grey.rows), bottom = std::min(end, last);
    for (int i = 0; i < exposure.moments; ++i) {
      frame.later = exposure.moment_of((band + end - 1) / 2.0, grey.rows) + exposure.offset_of(i);
      const FrameGeometry geometry_now = geometry_of(frame);
      const RadianceRows light = light_of(frame, geometry_now);
      for (int v = top; v < bottom; ++v) {
        scratch.rewind();
        row.v = v;
        row.value = scratch.floats();
        geometry_now.fill(row);
        for (const auto& effect : light) effect->row(row);
        add_up_light(row);
        float* sum = grey[v];
        for (int u = 0; u < grey.cols; ++u) sum[u] += share * row.value[u];
      }
    }
    top = bottom;
  }
}

cv::Mat Plan::State::render_in_passes(const FrameContext& frame,
                                      const FrameGeometry& geometry_now,
                                      int threads) const {
  const cv::Size size = rays.camera().size();
  cv::Mat_<float> grey = cv::Mat_<float>::zeros(size);
  over_rows(
      size.height, threads, [&](int first, int last) { render_light(frame, first, last, grey); });
  cv::Mat bytes;
  if (gives_bytes) bytes.create(size, CV_8UC1);
  for (auto from = sensor.begin();;) {
    const auto whole = std::find_if(
        from, sensor.end(), [](const auto* effect) { return effect->needs_picture(); });
    over_rows(size.height, threads, [&](int first, int last) {
      RowScratch scratch(size.width);
      RowView row(size.width, scratch);
      for (int v = first; v < last; ++v) {
        scratch.rewind();
        row.v = v;
        row.value = grey[v];
        row.bytes = gives_bytes ? bytes.ptr<std::uint8_t>(v) : nullptr;
        std::for_each(from, whole, [&](const auto* effect) { effect->row(frame, row); });
      }
    });
    if (whole == sensor.end()) break;
    (*whole)->picture(frame, geometry_now, grey);
    from = whole + 1;
  }
  return gives_bytes ? bytes : grey;
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
  std::vector<std::string> names;
  int lamps = 0;
  for (const auto& named : content.effects) {
    names.push_back(named.kind->name);
    lamps += named.effect->lamp_count();
  }
  const SceneFacts facts{content.finger, content.length_mm, names, content.frames_per_s, lamps};
  for (const auto& named : content.effects) {
    if (const Status status = named.effect->fits(facts); !status)
      return Error{status.error().what, named.where, status.error().advice};
    state->add(named);
  }
  for (const SensorEffect* effect : state->sensor) effect->expose(facts, state->exposure);
  state->in_passes = state->in_passes || !state->exposure.is_at_once();
  if (const Status status = content.motion.fits(state->dofs); !status) return status.error();
  Plan plan;
  plan.state_ = std::move(state);
  return plan;
}

int Plan::frame_count() const {
  return state_->content.frame_count;
}
double Plan::frames_per_s() const {
  return state_->content.frames_per_s;
}
const Finger& Plan::finger() const {
  return state_->content.finger;
}

std::vector<std::string> Plan::effects() const {
  std::vector<std::string> names;
  for (const auto& named : state_->content.effects) names.push_back(named.kind->name);
  return names;
}

Status Plan::check_grey_levels(const std::string& scene_file) const {
  if (state_->gives_bytes) return {};
  return Error{en::say("its camera does not give whole grey levels"),
               scene_file,
               en::say("name the effect quantisation too")};
}

cv::Mat Plan::render(int frame, int threads) const {
  return send(frame, threads).grey;
}

Arrival Plan::arrival(int frame) const {
  const FrameContext context = state_->context(frame);
  Arrival arrival;
  for (const TransportEffect* effect : state_->transport) effect->arrival(context, arrival);
  return arrival;
}

SentPicture Plan::send(int frame, int threads) const {
  const State& s = *state_;
  const FrameContext context = s.context(frame);
  const FrameGeometry geometry = s.geometry_of(context);
  cv::Mat picture;
  if (s.in_passes) {
    picture = s.render_in_passes(context, geometry, threads);
  } else {
    const RadianceRows light = s.light_of(context, geometry);
    picture.create(s.rays.camera().size(), s.gives_bytes ? CV_8UC1 : CV_32FC1);
    over_rows(picture.rows, threads, [&](int first, int last) {
      s.render_rows(context, geometry, light, first, last, picture);
    });
  }
  SentPicture sent{std::move(picture), nullptr};
  for (const TransportEffect* effect : s.transport) effect->picture(context, sent);
  return sent;
}

Truth Plan::truth(int frame) const {
  const State& s = *state_;
  const FrameContext context = s.context(frame);
  const FrameGeometry geometry = s.geometry_of(context);
  const cv::Size size = s.rays.camera().size();
  constexpr float kOff = std::numeric_limits<float>::quiet_NaN();
  Truth truth;
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
      if (row.face.coverage[u] < 0.5F) continue;  // the pixel's middle is off the face
      const bool pressed = u >= row.press_first && u < row.press_last;
      truth.depth_mm.at<float>(v, u) = pressed ? row.press_depth_mm[u] : 0.0F;
      truth.view_z_mm.at<float>(v, u) = row.face.z_mm[u];
      truth.untouched_z_mm.at<float>(v, u) = row.face.z_mm[u] + row.face.luf_mm[u];
    }
  }
  for (const MarkerDisc& disc : geometry.discs)
    truth.markers.push_back({disc.centre_px.x(), disc.centre_px.y(), disc.visible});
  for (const auto& press : geometry.presses)
    if (const auto* ball = std::get_if<BallPress>(&press))
      truth.ball = Truth::Ball{ball->centre_mm, ball->radius_mm, ball->place.depth_mm};
  for (const DegreeOfFreedom& dof : s.dofs) truth.pose[dof.name] = context(dof);
  return truth;
}

}  // namespace alltact
