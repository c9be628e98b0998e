// A source without backlog, for work that must not fall behind a live source.
#pragma once

#include "core/sources/source.h"

#include <memory>

namespace alltact {

/// Reads another source on a thread of its own. next() returns the newest frame, and never the same
/// one twice. Replaced frames are missing from the sequence. Images, which have no times, come at a
/// camera's rate. Errors come in their order. The destructor waits for the source's next frame.
class NewestSource : public Source {
 public:
  explicit NewestSource(std::unique_ptr<Source> source);
  ~NewestSource() override;

  [[nodiscard]] Result<FramePtr> next() override;
  [[nodiscard]] std::optional<std::size_t> count() const override;
  [[nodiscard]] bool is_continuous() const override;
  [[nodiscard]] bool is_live() const override { return true; }
  [[nodiscard]] double frames_per_s() const override;
  /// Frames that a newer one replaced.
  [[nodiscard]] std::uint64_t skipped() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace alltact
