// The sentences and phrases that core, calibration and the command line are made to say.
#pragma once

#include <span>
#include <vector>

namespace alltact {

/// Of the translations.
inline constexpr const char* kLibraryContext = "Library";

/// %1, %2, ... in this order stand for what a sentence is filled in with. A sentence that a source
/// puts together from parts stands here in its parts, and joint_words.cpp tells how parts are
/// joined. A hole between quotes holds a name, which no language changes.
using Patterns = std::span<const char* const>;

extern const Patterns kJointWords;
extern const Patterns kPressWords;
extern const Patterns kCalibrationWords;
extern const Patterns kAdviceWords;
extern const Patterns kLensWords;
extern const Patterns kReferenceWords;
extern const Patterns kFingerWords;
extern const Patterns kFileWords;
extern const Patterns kSceneWords;
extern const Patterns kDeviceWords;
extern const Patterns kProgramWords;

/// All of them.
[[nodiscard]] std::vector<const char*> library_patterns();

}  // namespace alltact
