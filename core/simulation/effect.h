// What an effect is. One effect is one file in core/simulation/effects/: its name is the file's
// ('_' written as '-'), its registration is written by the build, nothing else is edited.
//
// An effect file ends with
//   const EffectKind& effect_NAME() { static const EffectKind kind{...}; return kind; }
#pragma once

#include "core/result.h"
#include "core/simulation/elastic_finger.h"
#include "core/simulation/exposure.h"
#include "core/simulation/frame_geometry.h"
#include "core/simulation/motion.h"
#include "core/simulation/row_view.h"
#include "core/simulation/sent_picture.h"
#include "core/simulation/varying.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// In the order they run. Within a stage the physical order (EffectKind::rank) rules, not the
/// order in which a scene lists them.
enum class Stage { kGeometry = 1, kRadiance, kSensor, kTransport };

/// Which picture is being made. All that a random draw may depend on besides who draws and where.
struct FrameContext {
  std::uint64_t seed;  ///< of the effect's own draws: another one for each effect of one name
  int frame;
  const Motion& motion;
  const Finger& finger;
  double frames_per_s;
  std::uint64_t motion_seed;  ///< of what the motion draws, alike for all effects
  double later = 0;           ///< frames after (before, when negative) the frame's own moment

  /// Since the moment of frame 0.
  [[nodiscard]] double time_s() const { return (frame + later) / frames_per_s; }

  /// This moment's value of a parameter or of a degree of freedom.
  [[nodiscard]] double operator()(const Varying& varying) const {
    return at_moment([&](int i) { return varying.at(seed, i); });
  }
  [[nodiscard]] double operator()(const DegreeOfFreedom& dof) const {
    return at_moment([&](int i) { return motion.value(dof, motion_seed, i); });
  }

  /// Straight from one frame to the next; nothing moves before frame 0.
  template <class Value>
  [[nodiscard]] double at_moment(const Value& value) const {
    if (later == 0) return value(frame);
    const double moment = std::max(0.0, frame + later);
    const int first = static_cast<int>(moment);
    const double from = value(first), part = moment - first;
    return part > 0 ? from + part * (value(first + 1) - from) : from;
  }
};

/// What can be pressed into the face.
enum class PressKind { kBall = 1, kBody };

/// What an effect may ask of the rest of its scene before anything is rendered. It is asked for
/// each stretch of frames that hold the same effects, itself among them.
struct SceneFacts {
  const Finger& finger;
  double length_mm;                       ///< 0 for a flat sensor
  const std::vector<std::string>& named;  ///< effects that are present
  double frames_per_s;
  int lamp_count;
  const std::vector<PressKind>& pressed;  ///< what presses into the face
  const ElasticFinger* elastic;           ///< nullptr: the finger stands firm
  [[nodiscard]] bool presses(PressKind kind) const {
    return std::find(pressed.begin(), pressed.end(), kind) != pressed.end();
  }
  [[nodiscard]] bool names(std::string_view effect) const {
    return std::find(named.begin(), named.end(), effect) != named.end();
  }
};

/// How many objects effects were ever made of, for tests of what is built. Counted where they are
/// made, never in a loop over rows.
struct BuildCount {
  std::atomic<long> effects = 0;  ///< read from scenes
  std::atomic<long> steps = 0;    ///< effects that were present in a frame that was compiled
  std::atomic<long> rows = 0;     ///< RadianceEffect::Rows, one a frame and effect
};
[[nodiscard]] BuildCount& build_count();

class Effect {
 public:
  Effect() { ++build_count().effects; }
  Effect(const Effect&) = delete;
  Effect& operator=(const Effect&) = delete;
  virtual ~Effect() = default;
  /// What it does, without a full stop; for people who ask what a scene holds.
  [[nodiscard]] virtual Message sentence() const = 0;
  /// True: a frame may hold several of it, each with parameters and draws of its own.
  [[nodiscard]] virtual bool may_be_several() const { return false; }
  /// Error: impossible for this finger, or together with, or without, other effects.
  [[nodiscard]] virtual Status fits(const SceneFacts&) const { return {}; }
  /// What the scene's motion may move.
  [[nodiscard]] virtual std::vector<DegreeOfFreedom> degrees_of_freedom() const { return {}; }
  /// What it presses into the face, if anything.
  [[nodiscard]] virtual std::optional<PressKind> presses() const { return std::nullopt; }
  /// What it makes of the camera's lens, for all frames of the scene.
  virtual void change_lens(CameraParameters&) const {}
  [[nodiscard]] virtual bool changes_lens() const { return false; }
  /// How many lamps it brings.
  [[nodiscard]] virtual int lamp_count() const { return 0; }
  /// The body that it makes of the finger.
  [[nodiscard]] virtual const ElasticFinger* elastic() const { return nullptr; }
};

/// Once a frame, in two passes over all geometry effects: first the face gets its shape, then
/// what stands on it is added. `place` sees the finished face.
class GeometryEffect : public Effect {
 public:
  virtual void shape(const FrameContext&, FaceCurve&) const {}
  virtual void place(const FrameContext&, FrameGeometry&) const {}
};

/// Light, row by row. begin() does what is common to a frame's rows; the result is used by
/// several threads at once.
class RadianceEffect : public Effect {
 public:
  class Rows {
   public:
    Rows() { ++build_count().rows; }
    Rows(const Rows&) = delete;
    Rows& operator=(const Rows&) = delete;
    virtual ~Rows() = default;
    virtual void row(RowView& row) const = 0;
  };
  [[nodiscard]] virtual std::unique_ptr<const Rows> begin(const FrameContext&,
                                                          const FrameGeometry&) const = 0;
};

/// What the lens and the sensor make of the light (grey levels, float): row by row, or of the whole
/// picture at once, for which a scene pays that names such an effect.
class SensorEffect : public Effect {
 public:
  /// Only v, width, scratch, value, lit_first, lit_last and bytes of the row are set.
  virtual void row(const FrameContext&, RowView&) const {}
  /// True: picture() is called and row() is not.
  [[nodiscard]] virtual bool needs_picture() const { return false; }
  virtual void picture(const FrameContext&, const FrameGeometry&, cv::Mat_<float>&) const {}
  /// When the rows are taken.
  virtual void expose(const SceneFacts&, Exposure&) const {}
  /// True for the effect that turns grey levels into RowView::bytes.
  [[nodiscard]] virtual bool gives_bytes() const { return false; }
};

/// What happens to the finished picture on its way, or to when and whether it comes at all.
class TransportEffect : public Effect {
 public:
  virtual void arrival(const FrameContext&, Arrival&) const {}
  virtual void picture(const FrameContext&, SentPicture&) const {}
};

/// A place on the face, s along it from its base and y across. Error: beyond its ends or beside it;
/// a flat sensor's face goes as far as the picture.
[[nodiscard]] Status place_fits(const SceneFacts& scene, const Varying& s_mm, const Varying& y_mm);

/// What all presses of a given depth ask alike: on the face, and not through the layer.
[[nodiscard]] Status press_fits(const SceneFacts& scene,
                                const Varying& depth_mm,
                                const Varying& s_mm,
                                const Varying& y_mm);

struct EffectKind {
  std::string name;
  Stage stage;
  int rank;  ///< place within the stage
  /// Reads the parameters; errors are left in them. The object is of the stage's class.
  std::shared_ptr<const Effect> (*make)(YamlSection&);
  std::string_view example = {};             ///< typical parameters, YAML: "sd: 1"
  std::vector<std::string_view> needs = {};  ///< kinds that a scene of the example names besides
};

/// All kinds there are, written by the build from the files in effects/.
[[nodiscard]] std::vector<const EffectKind*> effect_kinds();

}  // namespace alltact
