// The products of a reference recording: usable frames, their markers, their report.
#pragma once

#include "calibration/reference/marker_numbering.h"
#include "calibration/reference/reference_recording.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/image/frame.h"
#include "core/sensing/reference/marker_table.h"
#include "core/sources/source.h"

#include <filesystem>

#include <opencv2/core.hpp>

namespace alltact {

/// Names in the finger's folder.
inline constexpr const char* kReferenceVideo = "reference.mkv";
inline constexpr const char* kReferenceTable = "reference.csv";

/// Partly filled where the recording is refused.
struct MadeReference {
  MarkerTable table;  ///< of the frames that are retained
  NumberedRecording numbered;
  SettingsMonitor settings;
  ReferenceReport report;
  std::size_t rest = 0;  ///< frame of the recording
  cv::Mat problem;       ///< an image of the problem; empty: there is none
};

/// The finger as its recording describes it: files, polarity of the markers, and missing markers.
[[nodiscard]] Finger with_markers(const Finger& finger, const NumberedRecording& numbered);

/// Fills `video` with the retained frames and `made` with their data. folder: the finger's, with
/// its earlier reference. Errors: those of install_reference() except the folder's.
[[nodiscard]] Status make_reference(Source& source, const Camera& camera, const Finger& finger,
                                    const Job& job, const ChoicesWhenRead& choices,
                                    const std::filesystem::path& folder,
                                    const std::filesystem::path& video, MadeReference& made);

}  // namespace alltact
