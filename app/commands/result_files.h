// The files that `alltact reconstruct` writes for each frame, besides results.jsonl.
#pragma once

#include "app/commands/commands.h"
#include "app/figures/figures.h"
#include "core/batch/batch.h"

#include <memory>
#include <optional>

namespace alltact {

/// Any thread may write, except 3D images, which belong to the thread that made this.
class ResultFiles {
 public:
  /// `options` outlives it.
  [[nodiscard]] static Result<ResultFiles> create(const ReconstructOptions& options);

  /// Writes the complete files of one frame without waiting for the disk (write_file_unsynced), and
  /// returns its line. Error: they cannot be written, nor could those of others.
  [[nodiscard]] Result<FrameLine> write(BatchFrame& frame, const Pipeline& pipeline) const;

 private:
  explicit ResultFiles(const ReconstructOptions& options) : options_(&options) {}
  [[nodiscard]] Status write_maps(const FrameResult& result, const Pipeline& pipeline) const;
  [[nodiscard]] Status write_sd(const FrameResult& result, const Finger& finger) const;
  [[nodiscard]] Status write_surfaces(const FrameResult& result, const Finger& finger) const;
  [[nodiscard]] Path file(const FrameResult& result, const std::string& ending) const;

  const ReconstructOptions* options_;
  std::unique_ptr<FaceRenderer> faces_;  // where 3D images are requested
};

/// As results.jsonl names it.
[[nodiscard]] ReferenceMethod reference_method(const ReconstructOptions& options);

/// Adds to a line, as `name`, where its depth in integer steps (depth_file.h) is, and the unit of
/// these.
///   where: members of a JSON object
void add_depth_steps(std::string& line, const std::string& name, const std::string& where);

}  // namespace alltact
