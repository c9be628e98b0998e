// Two fingers and what both recorded.
#pragma once

#include "core/open/open_source.h"
#include "core/recording/video_file.h"
#include "tests/studio/studio_rig.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace alltact::test {

/// The calibrated finger twice, and what both recorded: `left.mkv` every 100 ms, `right.mkv` every
/// 50 ms.
class TwoFingers {
 public:
  static const TwoFingers& get() {
    static const TwoFingers fingers;
    return fingers;
  }
  [[nodiscard]] std::filesystem::path left() const { return folder_ / "left"; }
  [[nodiscard]] std::filesystem::path right() const { return folder_ / "right"; }
  [[nodiscard]] std::filesystem::path left_video() const { return folder_ / "left.mkv"; }
  [[nodiscard]] std::filesystem::path right_video() const { return folder_ / "right.mkv"; }
  /// The faces look at each other.
  static RigidTransform place_of_left() {
    return {rotation_from_rpy_deg({0, 60, 0}), Eigen::Vector3d(-150, 0, 0)};
  }
  static RigidTransform place_of_right() {
    return {rotation_from_rpy_deg({0, 60, 180}), Eigen::Vector3d(150, 0, 0)};
  }

 private:
  TwoFingers() {
    for (const std::filesystem::path& finger : {left(), right()})
      std::filesystem::copy(MadeFingers::get().calibrated(), finger,
                            std::filesystem::copy_options::recursive);
    write(left_video(), 6, 100);
    write(right_video(), 12, 50);
  }
  static void write(const std::filesystem::path& file, int count, int step_ms) {
    const auto source = open_source({MadeFingers::get().touched()}).value();
    std::optional<VideoWriter> writer;
    for (int i = 0; i < count; ++i) {
      Frame frame = *source->next().value();
      frame.time_ns = (1000 + i * step_ms) * std::int64_t{1'000'000};
      if (!writer) writer = VideoWriter::create(file, frame, VideoCodec::kMagicYuv, 20).value();
      EXPECT_TRUE(writer->add(frame));
    }
    EXPECT_TRUE(writer->finish());
  }
  TemporaryFolder folder_;
};

}  // namespace alltact::test
