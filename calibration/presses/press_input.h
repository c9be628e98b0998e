// Sources of the presses of a calibration or a check.
#pragma once

#include "core/frame.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sources/source.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace alltact {

struct PressInput {
  std::vector<std::filesystem::path> files;  ///< images, folders or a video; see open_source
  bool bursts = false;                       ///< each file is one press held still; see BurstSource
  /// Images in memory, instead of files.
  std::vector<FramePtr> frames = {};
  std::size_t frames_per_press = 64;  ///< of a burst, averaged at most
};

/// Errors: those of open_source.
[[nodiscard]] Result<std::unique_ptr<Source>> open_presses(const PressInput& input);

/// Whether markers can be tracked from one press to the next, as in one video. Images are separate
/// presses, however they are numbered.
[[nodiscard]] bool is_one_video(const Source& presses);

/// How the frames of the bursts that were read were made, a sentence each.
[[nodiscard]] std::vector<Message> made_of(const Source& presses);

}  // namespace alltact
