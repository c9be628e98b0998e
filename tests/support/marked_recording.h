// Recordings of the drawn finger, from memory.
#pragma once

#include "core/sources/source.h"
#include "tests/support/marked_finger.h"

#include <memory>
#include <string>
#include <vector>

namespace alltact::test {

class MemorySource : public Source {
 public:
  std::vector<cv::Mat> images;
  std::shared_ptr<const std::string> settings;
  Result<FramePtr> next() override {
    if (at_ >= images.size()) return FramePtr{};
    auto frame = std::make_shared<Frame>();
    frame->grey = images[at_];
    frame->name = "frame";
    frame->controls = settings;
    frame->sequence = at_++;
    return FramePtr(frame);
  }
  std::optional<std::size_t> count() const override { return images.size(); }
  bool is_continuous() const override { return true; }

 private:
  std::size_t at_ = 0;
};

// Small, so that a recording of many frames is quick.
inline MarkedFinger small_finger() {
  MarkedFinger f;
  f.width = 480, f.height = 270, f.focal = 262;
  f.dot_mm = 0.9;
  f.noise = 0.4;  // little, so that what the mixture itself gets wrong is seen
  return f;
}

inline Finger described(const MarkedFinger& f) {
  Finger finger;
  finger.name = "drawn";
  finger.camera = f.camera();
  finger.face = f.face();
  finger.markers = {f.per_row, Polarity::kAuto};
  return finger;
}

inline Bend pose(int i, int frames) {
  const double t = 2 * M_PI * i / frames;
  return {0.35 * std::sin(t), 0.2 * std::sin(2 * t + 1), 6 * std::cos(3 * t),
          0.03 * std::sin(5 * t)};
}

}  // namespace alltact::test
