// The face as VTK's triangles: which belong together is said once, places and colours are written
// over, frame by frame. Inside this folder and its measurements only.
#pragma once

#include "core/io/colour_map.h"

#include <opencv2/core.hpp>
#include <vtkNew.h>
#include <vtkPolyData.h>

class vtkFloatArray;
class vtkPoints;
class vtkUnsignedCharArray;

namespace alltact {

/// Grey: where a value is not measured.
inline constexpr MapColour kNotMeasured{128, 128, 128};

class FaceMesh {
 public:
  static constexpr float kRelief = 5.0F, kSteepest = 1.7F;

  FaceMesh();
  ~FaceMesh();
  FaceMesh(const FaceMesh&) = delete;
  FaceMesh& operator=(const FaceMesh&) = delete;

  /// Topology is made anew only when the grid's size changed. Where `toward_camera_mm` is NaN the
  /// face stays untouched. Light falls on slopes that are kRelief times as steep as they are, so
  /// that hundredths of a millimetre are seen, and never steeper than kSteepest.
  ///   untouched_mm: CV_32FC3; toward_camera_mm, value: CV_32FC1 of the same size
  void update(const cv::Mat& untouched_mm,
              const cv::Mat& toward_camera_mm,
              float times,  ///< that toward_camera_mm is drawn larger
              const cv::Mat& value,
              const ColourScale& scale);

  /// Draws every so manieth vertex of the grid alone, and those at its rims.
  /// True: that is another stride than before.
  bool set_stride(int stride);
  [[nodiscard]] vtkPolyData* data() const { return data_; }
  /// As drawn, CV_32FC3, of the grid's size: shares VTK's memory until the size changes.
  [[nodiscard]] const cv::Mat& drawn_mm() const { return drawn_; }
  /// How often the topology of a grid was made.
  [[nodiscard]] int topologies() const { return topologies_; }

 private:
  void make_topology(cv::Size size);
  void make_triangles();
  void place(const cv::Mat& untouched_mm, const cv::Mat& toward_camera_mm, float times);
  void turn_normals(const cv::Mat& untouched_mm, const cv::Mat& toward_camera_mm, float times);
  void colour(const cv::Mat& value, const ColourScale& scale);

  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> places_, normals_;
  vtkNew<vtkUnsignedCharArray> colours_;
  cv::Mat drawn_;
  int topologies_ = 0, stride_ = 1;
};

}  // namespace alltact
