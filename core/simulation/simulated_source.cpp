#include "core/simulation/simulated_source.h"

#include "core/open/open_source.h"

#include <limits>

namespace alltact {

Result<std::unique_ptr<Source>> SimulatedSource::open(const std::filesystem::path& file,
                                                      const SourceOptions& options) {
  const auto scene = Scene::load(file);
  if (!scene) return scene.error();
  auto plan = Plan::compile(*scene, options.seed);
  if (!plan) return plan.error();
  if (const Status status = plan->check_grey_levels(file.string()); !status) return status.error();
  return std::unique_ptr<Source>(new SimulatedSource(std::move(*plan), file.string(), options));
}

std::optional<std::size_t> SimulatedSource::count() const {
  if (is_live()) return std::nullopt;
  std::size_t count = 0;
  for (int frame = 0; frame < plan_.frame_count(); ++frame)
    count += plan_.arrival(frame).is_dropped ? 0 : 1;
  return count;
}

void SimulatedSource::skip(std::size_t count) {
  const int end = is_live() ? std::numeric_limits<int>::max() : plan_.frame_count();
  while (count > 0 && position_ < end)
    if (!plan_.arrival(position_++).is_dropped) --count;
}

Result<FramePtr> SimulatedSource::next() {
  const int end = is_live() ? std::numeric_limits<int>::max() : plan_.frame_count();
  Arrival arrival{true, 0};
  while (position_ < end && arrival.is_dropped) arrival = plan_.arrival(position_++);
  if (arrival.is_dropped) return FramePtr();
  const int number = position_ - 1;
  SentFrame sent = plan_.send(number, options_.threads);
  auto frame = std::make_shared<Frame>();
  frame->grey = std::move(sent.grey);
  frame->jpeg = std::move(sent.jpeg);
  frame->name = fmt::format("frame_{:05}", number);
  frame->origin = origin_;
  frame->sequence = static_cast<std::uint64_t>(number);
  const std::int64_t time_ns = std::llround(1e9 * (number + 1) / plan_.frames_per_s());
  frame->time_ns = time_ns;
  if (!pacer_.wait_for(time_ns + std::llround(1e6 * arrival.late_ms))) return FramePtr();
  return FramePtr(std::move(frame));
}

namespace {
[[maybe_unused]] const bool kIsSceneKnown =
    add_input_kind(InputKind::kScene, SimulatedSource::open);
}  // namespace

}  // namespace alltact
