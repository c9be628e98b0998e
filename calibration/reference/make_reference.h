// What a reference recording is made into: frames that can be used, their markers, their report.
#pragma once

#include "calibration/reference/recording_layouts.h"
#include "calibration/reference/reference_recording.h"
#include "core/finger/finger.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/reference/marker_table.h"
#include "core/sources/frame_settings.h"
#include "core/sources/source.h"

#include <filesystem>

#include <opencv2/core.hpp>

namespace alltact {

/// Names in the finger's folder.
inline constexpr const char* kReferenceVideo = "reference.mkv";
inline constexpr const char* kReferenceTable = "reference.csv";

/// As far as it came, where the recording is refused.
struct MadeReference {
  MarkerTable table;  ///< of the frames that are kept
  NumberedRecording numbered;
  SettingsSeen settings;
  ReferenceReport report;
  std::size_t rest = 0;  ///< frame of the recording
  cv::Mat problem;       ///< a picture of what was found; empty: there is no problem
};

/// The finger as its recording describes it: the files, the markers' polarity, which it lacks.
[[nodiscard]] Finger with_markers(const Finger& finger, const NumberedRecording& numbered);

/// Fills `video` with the frames that are kept, and `made`, whose report brings what is needed of
/// motion, with what goes with it. folder: the finger's, where its earlier reference is. Errors:
/// those of install_reference() but for the folder's.
[[nodiscard]] Status make_reference(Source& source,
                                    const Camera& camera,
                                    const Finger& finger,
                                    const Job& job,
                                    const ReferenceChoices& choices,
                                    const std::filesystem::path& folder,
                                    const std::filesystem::path& video,
                                    MadeReference& made);

}  // namespace alltact
