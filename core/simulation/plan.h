// Rendering of a scene, and its ground truth.
#pragma once

#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/simulation/effect.h"
#include "core/simulation/scene.h"
#include "core/simulation/simulated_frame.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// The effects that are present in one frame. Built anew for every frame, so that rendering does
/// not test for presence.
class FramePlan {
 public:
  FramePlan(const Scene& scene, std::uint64_t seed, int frame);

  template <class E>
  struct Step {
    const SceneEffect* named;
    const E* effect;
    FrameContext context;  ///< with the seed of this effect's draws
  };
  // In running order.
  std::vector<Step<GeometryEffect>> geometry;
  std::vector<Step<RadianceEffect>> radiance;
  std::vector<Step<SensorEffect>> sensor;
  std::vector<Step<TransportEffect>> transport;

  /// True: the image has integer grey levels.
  [[nodiscard]] bool outputs_bytes() const { return outputs_bytes_; }
  [[nodiscard]] std::vector<const SceneEffect*> effects() const;
  /// True: an effect needs more than a row at a time.
  [[nodiscard]] bool is_multi_pass() const { return is_multi_pass_; }
  [[nodiscard]] const Exposure& exposure() const { return exposure_; }
  /// Moves everything to so many frames after the frame's own time.
  void move_to(double frame_offset);
  [[nodiscard]] SceneFacts facts(const Scene& scene) const;

 private:
  bool outputs_bytes_ = false, is_multi_pass_ = false;
  Exposure exposure_;
};

// A scene compiled into the list of steps for a frame, holding only the effects present in it.

class Plan {
 public:
  /// All random draws are a function of the seed, the scene's name, the effect, the frame and the
  /// pixel. Two scenes with one seed share no noise.
  /// Errors: an effect with impossible parameters for this finger; one that is present in frames
  /// where it requires or excludes other effects.
  static Result<Plan> compile(const Scene& scene, std::uint64_t seed);

  [[nodiscard]] int frame_count() const;
  /// Names of the effects that are built for some frame of the scene, in running order. The second
  /// of one kind is "ball#2".
  [[nodiscard]] std::vector<std::string> effects() const;
  /// Names of the effects that one frame builds.
  [[nodiscard]] std::vector<std::string> effects(int frame) const;

  /// An effect of effects(), and the frames with it.
  struct Entry {
    std::string name;
    Message sentence;  ///< what the effect does; may be empty
    int first, last;   ///< frames
  };
  [[nodiscard]] std::vector<Entry> entries() const;

  /// Frame rate of the camera.
  [[nodiscard]] double frames_per_s() const;

  /// Error: the scene lacks `quantisation` in some frames, so its images are not those of a camera.
  [[nodiscard]] Status check_grey_levels(const std::string& scene_file) const;

  /// Renders frame number `frame` as the camera would give it, CV_8UC1 when `quantisation` is
  /// present. Frames beyond the scene's last one repeat its effects from the first frame on; motion
  /// and draws continue. The bytes do not depend on the number of threads or the order of frames.
  [[nodiscard]] cv::Mat render(int frame, int threads = 1) const;
  /// The same, together with its packet if the camera sends packets.
  [[nodiscard]] SentFrame send(int frame, int threads = 1) const;
  /// Whether and when the frame arrives; costs no rendering.
  [[nodiscard]] Arrival arrival(int frame) const;
  [[nodiscard]] Truth truth(int frame, TruthDetail detail = TruthDetail::kAll) const;
  /// The same for every pixel; costs as much as a few frames.
  [[nodiscard]] TruthMaps truth_maps(int frame) const;

  /// The finger as a user would first describe it: camera, face, markers; nothing calibrated.
  [[nodiscard]] const Finger& finger() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace alltact
