// A finger on disk gets another reference.
#pragma once

#include "calibration/reference/reference_recording.h"
#include "core/finger/finger.h"
#include "core/io/folder_change.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"

#include <filesystem>
#include <vector>

namespace alltact {

/// Makes a recording a Fin Ray finger's reference (install_reference). What others changed of the
/// finger meanwhile stays. Errors: those of open_source, install_reference and FingerStore::update;
/// somebody else is at work on the finger (FingerStore::hold_for_work).
[[nodiscard]] Result<ReferenceReport> give_reference(
    const std::filesystem::path& folder,
    const std::vector<std::filesystem::path>& inputs,
    const Job& job,
    const ReferenceChoices& choices = {});

/// What give_reference() gave a copy of the finger becomes the finger's own: the same bytes,
/// without the work. Errors: the copy has no reference, or its files cannot be read; those of
/// FingerStore::update; somebody else is at work on the finger.
///   copy: a folder with finger.yaml and its reference; it stays as it is
[[nodiscard]] Status give_reference_of(const std::filesystem::path& copy,
                                       const std::filesystem::path& folder);

/// The same for a flat sensor's untouched picture (install_flat_reference).
[[nodiscard]] Result<std::vector<Message>> give_untouched_picture(
    const std::filesystem::path& folder, const UntouchedPicture& picture);

/// Pictures of both are compared with the same reference, through the same camera.
[[nodiscard]] bool has_same_reference(const Finger& a, const Finger& b);

/// finger.yaml takes its place together with the files of a change. For FingerStore::update(),
/// which writes the same finger once more.
[[nodiscard]] Status commit_with(const Finger& finger, FolderChange& files);

/// What a reference changes of a finger: the reference, its markers, their rest, and what it was
/// recorded with.
void take_reference(const Finger& from, Finger& finger);

}  // namespace alltact
