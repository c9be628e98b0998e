// Scenes that many tests look at, rendered once.
#include "core/base/atomic_file.h"
#include "core/simulation/plan.h"
#include "core/sources/source.h"
#include "tests/studio/studio_rig.h"

#include <map>
#include <mutex>

namespace alltact::test {
namespace {

/// The frames of one scene, each rendered when it is first asked for.
class RememberedScene {
 public:
  explicit RememberedScene(Plan plan)
      : plan_(std::move(plan)), frames_(static_cast<std::size_t>(plan_.frame_count())) {}
  [[nodiscard]] const Plan& plan() const { return plan_; }
  [[nodiscard]] cv::Mat frame(int number, int threads) {
    const std::lock_guard lock(mutex_);
    cv::Mat& frame = frames_[static_cast<std::size_t>(number) % frames_.size()];
    if (frame.empty()) frame = plan_.render(number % plan_.frame_count(), threads);
    return frame;
  }

 private:
  Plan plan_;
  std::mutex mutex_;
  std::vector<cv::Mat> frames_;
};

/// Like SimulatedSource at the camera's pace.
class RememberedSource : public Source {
 public:
  RememberedSource(std::shared_ptr<RememberedScene> scene, std::string origin,
                   const SourceOptions& options)
      : scene_(std::move(scene)), origin_(std::move(origin)), options_(options), pacer_(options) {}
  [[nodiscard]] Result<FramePtr> next() override {
    const int number = number_++;
    auto frame = std::make_shared<Frame>();
    frame->grey = scene_->frame(number, options_.threads);
    frame->name = fmt::format("frame_{:05}", number);
    frame->origin = origin_;
    frame->sequence = static_cast<std::uint64_t>(number);
    frame->time_ns = std::llround(1e9 * (number + 1) / scene_->plan().frames_per_s());
    return pacer_.wait_for(*frame->time_ns) ? FramePtr(std::move(frame)) : FramePtr();
  }
  void skip(std::size_t count) override { number_ += static_cast<int>(count); }
  [[nodiscard]] std::optional<std::size_t> count() const override { return std::nullopt; }
  [[nodiscard]] bool is_continuous() const override { return true; }
  [[nodiscard]] bool is_live() const override { return true; }
  [[nodiscard]] double frames_per_s() const override { return scene_->plan().frames_per_s(); }

 private:
  std::shared_ptr<RememberedScene> scene_;
  std::string origin_;
  SourceOptions options_;
  Pacer pacer_;
  int number_ = 0;
};

/// small_scene and what is made of it: no frame is lost or late or comes as a packet.
bool can_be_remembered(const std::string& scene) {
  return scene.starts_with("name: small finger\n") && scene.find("file:") == std::string::npos;
}

/// Null where this scene is not to be remembered, or wrong.
std::shared_ptr<RememberedScene> remembered(const std::filesystem::path& file, std::uint64_t seed) {
  static std::mutex mutex;
  static std::map<std::pair<std::string, std::uint64_t>, std::shared_ptr<RememberedScene>> all;
  const auto text = read_file(file);
  if (!text || !can_be_remembered(*text)) return nullptr;
  const std::lock_guard lock(mutex);
  auto& scene = all[{*text, seed}];
  if (scene) return scene;
  const auto loaded = Scene::load(file);
  auto plan = loaded ? Plan::compile(*loaded, seed) : Result<Plan>(loaded.error());
  if (plan && plan->check_grey_levels(file.string()))
    scene = std::make_shared<RememberedScene>(std::move(*plan));
  return scene;
}

}  // namespace

Result<std::unique_ptr<Source>> open_remembered(const std::vector<std::filesystem::path>& inputs,
                                                const SourceOptions& options) {
  if (options.pace == Pace::kRecorded && inputs.size() == 1 && inputs[0].extension() == ".yaml")
    if (auto scene = remembered(inputs[0], options.seed))
      return std::unique_ptr<Source>(
          std::make_unique<RememberedSource>(std::move(scene), inputs[0].string(), options));
  return open_source(inputs, options);
}

cv::Mat remembered_frame(const std::filesystem::path& scene, int number) {
  return remembered(scene, 1)->frame(number, 1);
}

}  // namespace alltact::test
