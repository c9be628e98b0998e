// Replaces the reference of a finger on disk.
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

/// Makes a recording a Fin Ray finger's reference (install_reference). Concurrent changes of other
/// parts of the finger are preserved. Errors: those of open_source, install_reference and
/// FingerStore::update; another process works on the finger (FingerStore::lock_for_work).
[[nodiscard]] Result<ReferenceReport> set_reference(
    const std::filesystem::path& folder,
    const std::vector<std::filesystem::path>& inputs,
    const Job& job,
    const ReferenceChoices& choices = {});

/// Copies the result of set_reference() on a copy of the finger into the finger: the same bytes,
/// without the computation. Errors: the copy has no reference, or its files cannot be read; those
/// of FingerStore::update; another process works on the finger.
///   copy: a folder with finger.yaml and its reference; it is not changed
[[nodiscard]] Status copy_reference(const std::filesystem::path& copy,
                                    const std::filesystem::path& folder);

/// The same for a flat sensor's untouched image (install_flat_reference).
[[nodiscard]] Result<std::vector<Message>> set_untouched_image(const std::filesystem::path& folder,
                                                               const UntouchedImage& image);

/// Images of both are compared with the same reference, through the same camera.
[[nodiscard]] bool has_same_reference(const Finger& a, const Finger& b);

/// Replaces finger.yaml together with the files of a change. For FingerStore::update(), which
/// writes the same finger once more.
[[nodiscard]] Status commit_with(const Finger& finger, FolderChange& files);

/// Copies the fields that a reference defines: the reference, its markers, their rest, and the
/// recording settings.
void take_reference(const Finger& from, Finger& finger);

}  // namespace alltact
