// Where the presses of a calibration or a check come from.
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
  std::vector<std::filesystem::path> files;  ///< pictures, folders or a video; see open_source
  bool bursts = false;  ///< each of them is one press held still; see BurstSource
  /// Pictures that are at hand, instead of files.
  std::vector<FramePtr> frames = {};
  std::size_t pictures_per_press = 64;  ///< of a burst, averaged at most
};

/// Errors: those of open_source.
[[nodiscard]] Result<std::unique_ptr<Source>> open_presses(const PressInput& input);

/// Whether markers can be followed from one press to the next: in a video of them. Pictures are
/// each of a press of its own, however they are numbered.
[[nodiscard]] bool is_one_video(const Source& presses);

/// What the bursts that were read were made of, a sentence each.
[[nodiscard]] std::vector<Message> made_of(const Source& presses);

}  // namespace alltact
