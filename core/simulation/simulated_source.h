// A simulated finger as a camera sees it.
#pragma once

#include "core/simulation/plan.h"
#include "core/sources/source.h"

#include <filesystem>

namespace alltact {

/// Frames follow the scene, times the camera's own clock, which begins at the first frame. Frames
/// that the scene drops never come; the sequence skips their numbers.
class SimulatedSource : public Source {
 public:
  /// Errors: those of the scene; images that are not 8-bit, because the scene does not name
  /// `quantisation`.
  [[nodiscard]] static Result<std::unique_ptr<Source>> open(const std::filesystem::path& scene,
                                                            const SourceOptions& options);

  [[nodiscard]] Result<FramePtr> next() override;
  void skip(std::size_t count) override;  ///< renders nothing
  /// Empty at the camera's pace, which never ends.
  [[nodiscard]] std::optional<std::size_t> count() const override;
  [[nodiscard]] bool is_continuous() const override { return true; }
  [[nodiscard]] bool is_live() const override { return options_.pace == Pace::kRecorded; }
  [[nodiscard]] double frames_per_s() const override { return plan_.frames_per_s(); }

 private:
  SimulatedSource(Plan plan, std::string origin, const SourceOptions& options)
      : plan_(std::move(plan)), origin_(std::move(origin)), options_(options), pacer_(options) {}

  Plan plan_;
  std::string origin_;
  SourceOptions options_;
  Pacer pacer_;
  int position_ = 0;
};

}  // namespace alltact
