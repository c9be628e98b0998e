// The face as VTK triangles: the topology is built once, positions and colours are overwritten
// frame by frame. Inside this folder and its measurements only.
#pragma once

#include "core/image/colour_map.h"

#include <opencv2/core.hpp>
#include <vtkNew.h>
#include <vtkPolyData.h>

class vtkFloatArray;
class vtkPoints;
class vtkUnsignedCharArray;

namespace alltact {

/// Light grey, far from the dark grey of untouched skin: where a value is not measured.
inline constexpr MapColour kNotMeasured{200, 200, 200};

class FaceMesh {
 public:
  static constexpr float kSlopeGain = 5.0F, kMaxSlope = 1.7F;

  FaceMesh();
  ~FaceMesh();
  FaceMesh(const FaceMesh&) = delete;
  FaceMesh& operator=(const FaceMesh&) = delete;

  /// Rebuilds the topology only when the grid's size changed. The face stays undeformed where
  /// `toward_camera_mm` is NaN. The shading uses slopes multiplied by kSlopeGain, so that
  /// hundredths of a millimetre are visible, limited to kMaxSlope.
  ///   untouched_mm: CV_32FC3; toward_camera_mm, value: CV_32FC1 of the same size
  void update(const cv::Mat& untouched_mm, const cv::Mat& toward_camera_mm,
              float exaggeration,  ///< factor on toward_camera_mm
              const cv::Mat& value, const ColourScale& scale);

  /// Draws every `stride`-th vertex of the grid, and those at its rims.
  /// True: the stride changed.
  bool set_stride(int stride);
  [[nodiscard]] vtkPolyData* data() const { return data_; }
  /// As drawn, CV_32FC3, of the grid's size: shares VTK's memory until the size changes.
  [[nodiscard]] const cv::Mat& drawn_mm() const { return drawn_; }
  /// Number of topologies built so far.
  [[nodiscard]] int topologies() const { return topologies_; }

 private:
  void make_topology(cv::Size size);
  void make_triangles();
  void set_positions(const cv::Mat& untouched_mm, const cv::Mat& toward_camera_mm,
                     float exaggeration);
  void update_normals(const cv::Mat& untouched_mm, const cv::Mat& toward_camera_mm,
                      float exaggeration);
  void colour(const cv::Mat& value, const ColourScale& scale);

  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> positions_, normals_;
  vtkNew<vtkUnsignedCharArray> colours_;
  cv::Mat drawn_;
  int topologies_ = 0, stride_ = 1;
};

}  // namespace alltact
