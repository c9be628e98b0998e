// The newest frame wins: for work that must not fall behind a live source.
#pragma once

#include "core/sources/source.h"

#include <memory>

namespace alltact {

/// Another source, read on a thread of its own so that next() always gives the newest frame that
/// came, and never the same twice. Frames that came in between are missing from the sequence.
/// Pictures, which have no times, come as often as a camera's would.
/// Errors come in their turn. Ended by its destructor, which waits for the source's next frame.
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
