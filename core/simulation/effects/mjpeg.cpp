// The camera sends JPEG images (Motion JPEG).
#include "core/simulation/effect.h"

#include <opencv2/imgcodecs.hpp>

namespace alltact {

namespace {

class Mjpeg final : public TransportEffect {
 public:
  explicit Mjpeg(YamlSection& p) : quality_(p.integer("quality", 1, 100)) {}

  Status validate(const SceneFacts& scene) const override {
    if (!scene.has_effect("quantisation"))
      return Error{en::say("JPEG needs integer grey levels"), "",
                   en::say("add the effect quantisation")};
    return {};
  }
  void process_image(const FrameContext&, SentFrame& sent) const override {
    std::vector<std::uint8_t> packet;
    cv::imencode(".jpg", sent.grey, packet, {cv::IMWRITE_JPEG_QUALITY, quality_});
    sent.grey = cv::imdecode(packet, cv::IMREAD_GRAYSCALE);
    sent.jpeg = std::make_shared<const std::vector<std::uint8_t>>(std::move(packet));
  }

 private:
  int quality_;
};

}  // namespace

EffectKind effect_mjpeg() {
  return effect_kind<Mjpeg>("mjpeg", 50, en::say("The camera sends JPEG images"), "quality: 85",
                            {"quantisation"});
}

}  // namespace alltact
