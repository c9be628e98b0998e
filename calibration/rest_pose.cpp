#include "calibration/rest_pose.h"

#include "core/numerics/median.h"

#include <cmath>

#include <fmt/format.h>

namespace alltact {

Eigen::Index middle_pose(const Eigen::MatrixXd& layouts) {
  Eigen::RowVectorXd middle(layouts.cols());
  for (Eigen::Index k = 0; k < layouts.cols(); ++k) {
    const Eigen::VectorXd column = layouts.col(k);
    std::vector<double> values(column.begin(), column.end());
    middle[k] = upper_median(values);
  }
  Eigen::Index nearest = 0;
  (layouts.rowwise() - middle).rowwise().squaredNorm().minCoeff(&nearest);
  return nearest;
}

Status set_rest_pose(const Markers& markers, Finger& finger) {
  if (!finger.contact)
    return Error{"the finger has no reference recording, so no rest can be set",
                 "",
                 "record the bending, untouched finger first"};
  if (static_cast<int>(markers.size()) != finger.marker_count())
    return Error{
        fmt::format(
            "{} markers were found, but the finger has {}", markers.size(), finger.marker_count()),
        "",
        "a picture in which the markers are found"};
  std::vector<Eigen::Vector2d> rest;
  for (const Marker& marker : markers) {
    if (!std::isfinite(marker.u) || !std::isfinite(marker.v))
      return Error{
          "a marker has no place in the picture", "", "a picture in which the markers are found"};
    rest.emplace_back(marker.u, marker.v);
  }
  finger.contact->rest_markers = std::move(rest);
  return {};
}

}  // namespace alltact
