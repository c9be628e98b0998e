// What `alltact reconstruct` leaves of each frame beside results.jsonl.
#pragma once

#include "app/commands/commands.h"
#include "app/pictures/pictures.h"
#include "core/batch/batch.h"

#include <memory>
#include <optional>

namespace alltact {

/// Any thread may write, but for pictures in 3D, which belong to the thread that made this.
class ResultFiles {
 public:
  /// `options` outlives it.
  [[nodiscard]] static Result<ResultFiles> create(const ReconstructOptions& options);

  /// The files of one frame, whole but not waited for (write_file_of_many), and its line. Error:
  /// they cannot be written, nor could those of others.
  [[nodiscard]] Result<FrameLine> write(BatchFrame& frame, const Pipeline& pipeline) const;

 private:
  explicit ResultFiles(const ReconstructOptions& options) : options_(&options) {}
  [[nodiscard]] Status write_maps(const FrameResult& result, const Pipeline& pipeline) const;
  [[nodiscard]] Status write_sd(const FrameResult& result, const Finger& finger) const;
  [[nodiscard]] Status write_surfaces(const FrameResult& result, const Finger& finger) const;
  [[nodiscard]] Path file(const FrameResult& result, const std::string& ending) const;

  const ReconstructOptions* options_;
  std::unique_ptr<FacePictures> faces_;  // where pictures are wanted
};

/// As results.jsonl names it.
[[nodiscard]] ReferenceMethod reference_method(const ReconstructOptions& options);

/// Tells in a line, as `name`, where its depth in whole steps (depth_file.h) is, and what they
/// mean.
///   where: members of a JSON object
void tell_depth_steps(std::string& line, const std::string& name, const std::string& where);

}  // namespace alltact
