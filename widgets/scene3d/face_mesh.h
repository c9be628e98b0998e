// The face as VTK triangles: the topology is built once, positions and colours are overwritten
// frame by frame. Inside this folder and its measurements only.
#pragma once

#include "core/image/colour_map.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vtkNew.h>
#include <vtkPolyData.h>

class vtkFloatArray;
class vtkPoints;
class vtkUnsignedCharArray;

namespace alltact {

/// The direction that the key light comes from: fixed to the finger, on the camera's side, 51
/// degrees off the face's normal, from the left of the image and a little from above. Unit, in the
/// camera's frame.
///   untouched_mm: as FaceSurface::untouched_mm
[[nodiscard]] Eigen::Vector3d key_light(const cv::Mat& untouched_mm);

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
  /// `toward_camera_mm` is NaN. Light and shadow are part of the vertex colours, so the renderer
  /// needs no lamps for it: ambient light, a fill light square to the face and key_light(), whose
  /// sum leaves the colours of a flat face as they are. The shading uses slopes multiplied by
  /// kSlopeGain, so that hundredths of a millimetre are visible, limited to kMaxSlope. Skin lower
  /// than its surroundings, such as round a press, lies in a soft shadow.
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
  void update_light(const cv::Mat& untouched_mm, const cv::Mat& toward_camera_mm,
                    float exaggeration);
  void update_shadow(const cv::Mat& untouched_mm, const cv::Mat& toward_camera_mm);
  void colour(const cv::Mat& value, const ColourScale& scale);

  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> positions_;
  vtkNew<vtkUnsignedCharArray> colours_;
  cv::Mat drawn_;
  cv::Mat light_, height_mm_, around_mm_;  // CV_32FC1
  int topologies_ = 0, stride_ = 1;
};

}  // namespace alltact
