// A scene compiled into the list of things to do for a frame, holding only what is present in it.
#pragma once

#include "core/finger/finger.h"
#include "core/result.h"
#include "core/simulation/scene.h"
#include "core/simulation/sent_picture.h"
#include "core/simulation/truth.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

class Plan {
 public:
  /// Everything drawn at random is a function of the seed and the scene's name (two scenes with one
  /// seed share no noise), the effect, the frame and the pixel.
  /// Errors: an effect with impossible parameters for this finger; one that is present in frames
  /// where it cannot be alone or not with others.
  static Result<Plan> compile(const Scene& scene, std::uint64_t seed);

  [[nodiscard]] int frame_count() const;
  /// Names of the effects that are built for some frame of the scene, in the order they run. The
  /// second of one kind is "ball#2".
  [[nodiscard]] std::vector<std::string> effects() const;
  /// Names of the effects that one frame builds.
  [[nodiscard]] std::vector<std::string> effects(int frame) const;

  /// What effects() names, and when it is there.
  struct Entry {
    std::string name;
    Message sentence;  ///< what it does; may be empty
    int first, last;   ///< frames
  };
  [[nodiscard]] std::vector<Entry> entries() const;

  /// How often the camera takes a picture.
  [[nodiscard]] double frames_per_s() const;

  /// Error: the scene does not name `quantisation` for all its frames, so that its pictures are not
  /// those of a camera.
  [[nodiscard]] Status check_grey_levels(const std::string& scene_file) const;

  /// Frame number `frame` as the camera would give it, CV_8UC1 when `quantisation` is present.
  /// Frames beyond the scene's last one show its effects from the first frame on again, moving and
  /// drawing on.
  /// The same bytes for any number of threads and any order of frames.
  [[nodiscard]] cv::Mat render(int frame, int threads = 1) const;
  /// The same together with the packet that it came in, where the camera sends such.
  [[nodiscard]] SentPicture send(int frame, int threads = 1) const;
  /// Whether and when it comes; costs no rendering.
  [[nodiscard]] Arrival arrival(int frame) const;
  [[nodiscard]] Truth truth(int frame, TruthDetail detail = TruthDetail::kAll) const;
  /// The same for every pixel; costs as much as a few frames.
  [[nodiscard]] TruthMaps truth_maps(int frame) const;

  /// The finger as a newcomer would describe it: camera, face, markers; nothing calibrated.
  [[nodiscard]] const Finger& finger() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace alltact
