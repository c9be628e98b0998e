// The interface of effects. One effect is one file in core/simulation/effects/. Its name is the
// file's, with '_' written as '-'. The build generates the registration; nothing else is edited.
//
// An effect file ends with
//   EffectKind effect_NAME() { return effect_kind<Class>("name", rank, ...); }
#pragma once

#include "core/base/result.h"
#include "core/base/yaml.h"
#include "core/simulation/fin_ray_body.h"
#include "core/simulation/frame_geometry.h"
#include "core/simulation/row_view.h"
#include "core/simulation/scene_time.h"
#include "core/simulation/simulated_frame.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

// When within its frame an image is exposed.

/// Times in frames; 0 is the frame's own time, which is that of the image's middle row and of the
/// truth. By default every row is exposed at that time.
struct Exposure {
  double open = 0;       ///< exposure of a row, half before its time and half after
  int moments = 1;       ///< number of samples averaged over the exposure
  double readout = 0;    ///< from the first row's time to the last's
  int rows_at_once = 1;  ///< neighbouring rows that share one time

  [[nodiscard]] bool is_instantaneous() const { return open == 0 && readout == 0; }
  /// Time of the rows around row `v` (may be fractional) of `rows`.
  [[nodiscard]] double moment_of(double v, int rows) const {
    return rows > 1 ? readout * (v / (rows - 1) - 0.5) : 0.0;
  }
  /// Middle of sample `i` of the exposure.
  [[nodiscard]] double offset_of(int i) const { return open * ((i + 0.5) / moments - 0.5); }
};

/// Stages in running order. Within a stage EffectKind::rank gives the physical order, independent
/// of the order in the scene.
enum class Stage { kGeometry = 1, kRadiance, kSensor, kTransport };

/// Identifies the frame being rendered. A random draw depends only on this, the drawing effect and
/// the pixel.
struct FrameContext {
  std::uint64_t seed;  ///< of the effect's own draws; effects of one name have different seeds
  int frame;
  const Motion& motion;
  const Finger& finger;
  double frames_per_s;
  std::uint64_t motion_seed;  ///< of the motion's draws, shared by all effects
  double frame_offset = 0;    ///< frames after (negative: before) the frame's own time

  /// Seconds since frame 0.
  [[nodiscard]] double time_s() const { return (frame + frame_offset) / frames_per_s; }

  /// Value of a parameter or of a degree of freedom at this time.
  [[nodiscard]] double operator()(const Varying& varying) const {
    return at_moment([&](int i) { return varying.at(seed, i); });
  }
  [[nodiscard]] double operator()(const DegreeOfFreedom& dof) const {
    return at_moment([&](int i) { return motion.value(dof, motion_seed, i); });
  }

  /// Interpolates linearly between frames. Nothing moves before frame 0.
  template <class Value>
  [[nodiscard]] double at_moment(const Value& value) const {
    if (frame_offset == 0) return value(frame);
    const double moment = std::max(0.0, frame + frame_offset);
    const int first = static_cast<int>(moment);
    const double from = value(first), part = moment - first;
    return part > 0 ? from + part * (value(first + 1) - from) : from;
  }
};

/// What an effect may ask about the rest of its scene before rendering. Computed for each run of
/// frames with the same effects, including the asking effect.
struct SceneFacts {
  const Finger& finger;
  double length_mm;                ///< 0 for a flat sensor
  std::vector<std::string> named;  ///< effects that are present
  double frames_per_s;
  int lamp_count;
  bool ball_presses, body_presses;  ///< into the face; false: none does
  const ElasticFinger* elastic;     ///< nullptr: the finger is rigid
  [[nodiscard]] bool has_effect(std::string_view effect) const {
    return std::find(named.begin(), named.end(), effect) != named.end();
  }
};

/// Counts constructed objects, for tests of what is built. Counted at construction, never in a loop
/// over rows.
struct BuildCount {
  std::atomic<long> effects = 0;  ///< read from scenes
  std::atomic<long> steps = 0;    ///< effects present in a compiled frame
  std::atomic<long> rows = 0;     ///< RadianceEffect::Rows, one for each frame and effect
};
[[nodiscard]] BuildCount& build_count();

class Effect {
 public:
  Effect() { ++build_count().effects; }
  Effect(const Effect&) = delete;
  Effect& operator=(const Effect&) = delete;
  virtual ~Effect() = default;
  /// True: a frame may hold several of this effect, each with its own parameters and draws.
  [[nodiscard]] virtual bool is_repeatable() const { return false; }
  /// Error: the effect is impossible for this finger, or in this combination of effects.
  [[nodiscard]] virtual Status validate(const SceneFacts&) const { return {}; }
  /// Degrees of freedom that the scene's motion may drive.
  [[nodiscard]] virtual std::vector<DegreeOfFreedom> degrees_of_freedom() const { return {}; }
  /// It presses a ball, or a body of another shape, into the face.
  [[nodiscard]] virtual bool presses_ball() const { return false; }
  [[nodiscard]] virtual bool presses_body() const { return false; }
  /// Changes the camera's lens, for all frames of the scene.
  virtual void change_lens(CameraParameters&) const {}
  [[nodiscard]] virtual bool changes_lens() const { return false; }
  /// Number of lamps that the effect adds.
  [[nodiscard]] virtual int lamp_count() const { return 0; }
  /// The elastic body that the effect gives the finger.
  [[nodiscard]] virtual const ElasticFinger* elastic() const { return nullptr; }
};

/// Runs once a frame, in two passes over all geometry effects. shape() deforms the face. apply()
/// then adds objects to the finished face.
class GeometryEffect : public Effect {
 public:
  static constexpr Stage kStage = Stage::kGeometry;
  virtual void shape(const FrameContext&, FaceCurve&) const {}
  virtual void apply(const FrameContext&, FrameGeometry&) const {}
};

/// Computes light row by row. begin() does the work common to a frame's rows; several threads call
/// its result at once, while the effect and the geometry exist.
class RadianceEffect : public Effect {
 public:
  static constexpr Stage kStage = Stage::kRadiance;
  using Rows = std::function<void(RowView&)>;
  [[nodiscard]] virtual Rows begin(const FrameContext&, const FrameGeometry&) const = 0;
};

/// What the lens and the sensor do to the light (grey levels, float): row by row, or on the full
/// image. Full-image effects cost time only in scenes that use them.
class SensorEffect : public Effect {
 public:
  static constexpr Stage kStage = Stage::kSensor;
  /// Only v, width, scratch, value, lit_first, lit_last and bytes of the row are set.
  virtual void row(const FrameContext&, RowView&) const {}
  /// True: process_image() is called instead of row().
  [[nodiscard]] virtual bool needs_full_image() const { return false; }
  virtual void process_image(const FrameContext&, const FrameGeometry&, cv::Mat_<float>&) const {}
  /// Sets when the rows are exposed.
  virtual void expose(const SceneFacts&, Exposure&) const {}
  /// True for the effect that turns grey levels into RowView::bytes.
  [[nodiscard]] virtual bool outputs_bytes() const { return false; }
};

/// What happens to the finished image during transport, and whether and when it arrives.
class TransportEffect : public Effect {
 public:
  static constexpr Stage kStage = Stage::kTransport;
  virtual void arrival(const FrameContext&, Arrival&) const {}
  virtual void process_image(const FrameContext&, SentFrame&) const {}
};

/// Checks a position on the face, s along it from its base and y across. Error: outside the face. A
/// flat sensor's face fills the image.
[[nodiscard]] Status check_position(const SceneFacts& scene, const Varying& s_mm,
                                    const Varying& y_mm);

/// Checks that a press of given depth lies on the face and does not go through the layer.
[[nodiscard]] Status check_press(const SceneFacts& scene, const Varying& depth_mm,
                                 const Varying& s_mm, const Varying& y_mm);

struct EffectKind {
  std::string name;
  Stage stage;
  int rank;                             ///< order within the stage
  Message sentence;                     ///< what the effect does, without a full stop
  std::string_view example;             ///< typical parameters, YAML: "sd: 1"
  std::vector<std::string_view> needs;  ///< other kinds that a scene of the example needs
  /// Reads the parameters; the section collects errors. The object is of the stage's class.
  std::shared_ptr<const Effect> (*make)(YamlSection&);
  std::string_view instead_of = {};  ///< the kind that a scene names otherwise; empty: none
};

/// The kind of the effects of class E, which reads its parameters in its constructor.
template <class E>
[[nodiscard]] EffectKind effect_kind(std::string name, int rank, Message sentence,
                                     std::string_view example,
                                     std::vector<std::string_view> needs = {},
                                     std::string_view instead_of = {}) {
  return {std::move(name),
          E::kStage,
          rank,
          std::move(sentence),
          example,
          std::move(needs),
          [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<E>(p); },
          instead_of};
}

/// All kinds. The build generates this from the files in effects/.
[[nodiscard]] std::vector<const EffectKind*> effect_kinds();

/// value += level, for every pixel of a row.
void add_to_row(const RowView& row, float level);

// A small mark on the view face that changes its light.

/// All within `radius_mm` of the line between two points (s, y) of the face: along it from its
/// base, and across from its middle line. A disc where the points coincide.
struct FaceMark {
  Eigen::Vector2d from_mm, to_mm;
  double radius_mm;
};

/// light = light * (1 + (factor - 1) * part) + level * part, part the share of the pixel within the
/// mark. It is first order: from the distance to the mark's edge in pixels, from 1/2 outside to 1/2
/// inside.
void mark_row(const Camera& camera, const FaceMark& mark, double factor, double level,
              RowView& row);

// The dots that an effect acts on.

/// For YamlFile::read(): the key `markers`, distinct integers from 0.
[[nodiscard]] std::vector<std::size_t> read_marker_numbers(YamlSection& section);

}  // namespace alltact
