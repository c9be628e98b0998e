// A simulated recording as a source.
#pragma once

#include "core/simulation/plan.h"
#include "core/sources/source.h"

#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace alltact {

/// The first `count` frames of a plan.
class PlanSource : public Source {
 public:
  PlanSource(Plan plan, int count) : plan_(std::move(plan)), count_(count) {}
  Result<FramePtr> next() override {
    if (next_ == count_) return FramePtr();
    auto frame = std::make_shared<Frame>();
    frame->grey = plan_.render(next_++);
    frame->name = fmt::format("frame_{:05d}", next_ - 1);
    frame->origin = frame->name;
    return FramePtr(frame);
  }
  [[nodiscard]] std::optional<std::size_t> count() const override {
    return static_cast<std::size_t>(count_);
  }
  [[nodiscard]] bool is_continuous() const override { return true; }

 private:
  Plan plan_;
  int count_;
  int next_ = 0;
};

}  // namespace alltact
