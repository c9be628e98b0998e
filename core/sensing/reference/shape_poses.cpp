#include "core/sensing/reference/shape_poses.h"

#include "core/sensing/reference/reference_weights.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr std::size_t kMinPoses = 8;
constexpr Eigen::Index kMaxTries = 100;  // frames from which the standard deviation is learnt

bool all_seen(const Markers& markers) {
  return std::all_of(markers.begin(), markers.end(), [](const Marker& m) { return m.seen; });
}

Eigen::VectorXd as_row(const Markers& markers) {
  Eigen::VectorXd row(static_cast<Eigen::Index>(2 * markers.size()));
  for (std::size_t m = 0; m < markers.size(); ++m)
    row.segment<2>(static_cast<Eigen::Index>(2 * m)) << markers[m].u, markers[m].v;
  return row;
}

}  // namespace

std::optional<ShapePoses> ShapePoses::learn(const std::vector<EdgeCurves>& faces,
                                            const Eigen::MatrixXd& layouts) {
  const auto positions = choose_edge_positions(faces);
  if (!positions) return std::nullopt;
  std::vector<Markers> seen;
  std::vector<Eigen::Index> frames;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Markers at = markers_at(*positions, faces[i]);
    if (!all_seen(at)) continue;
    seen.push_back(std::move(at));
    frames.push_back(static_cast<Eigen::Index>(i));
  }
  if (seen.size() < kMinPoses) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(seen.size());
  Eigen::MatrixXd shapes(count, 4 * EdgePositions::kPerEdge), recorded(count, layouts.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    shapes.row(i) = as_row(seen[static_cast<std::size_t>(i)]).transpose();
    recorded.row(i) = layouts.row(frames[static_cast<std::size_t>(i)]);
  }
  auto model = MarkerModel::learn(shapes, std::vector<Dot>(2 * EdgePositions::kPerEdge));
  if (!model) return std::nullopt;
  ShapePoses poses(*positions, std::move(*model), LayoutSearch(shapes));
  poses.layouts_ = std::move(recorded);
  poses.modes_.resize(count, poses.model_.mode_sd_px().size());
  for (Eigen::Index i = 0; i < count; ++i)
    poses.modes_.row(i) = poses.model_.modes(seen[static_cast<std::size_t>(i)])
                              .cwiseProduct(poses.model_.mode_sd_px())
                              .transpose();
  poses.known_px_ = known_distance_px(poses.search_);
  poses.learn_sd();
  return poses;
}

Eigen::VectorXd ShapePoses::layout_at(const Eigen::VectorXd& pose,
                                      const std::vector<char>& without) const {
  const PoseNeighbours near = pose_neighbours(modes_, pose, model_.marker_count(), without);
  Eigen::VectorXd layout = Eigen::VectorXd::Zero(layouts_.cols());
  for (std::size_t i = 0; i < near.rows.size(); ++i)
    layout += near.weights[static_cast<Eigen::Index>(i)] * layouts_.row(near.rows[i]).transpose();
  return layout;
}

void ShapePoses::learn_sd() {
  const Eigen::Index step = std::max<Eigen::Index>(1, layouts_.rows() / kMaxTries);
  Eigen::VectorXd square = Eigen::VectorXd::Zero(layouts_.cols());
  std::vector<char> without(static_cast<std::size_t>(layouts_.rows()), 0);
  int tries = 0;
  for (Eigen::Index i = 0; i < layouts_.rows(); i += step, ++tries) {
    without[static_cast<std::size_t>(i)] = 1;
    const Eigen::VectorXd estimate = layout_at(modes_.row(i).transpose(), without);
    without[static_cast<std::size_t>(i)] = 0;
    square += (estimate - layouts_.row(i).transpose()).cwiseAbs2();
  }
  sd_px_.resize(static_cast<std::size_t>(layouts_.cols() / 2));
  for (std::size_t m = 0; m < sd_px_.size(); ++m)
    sd_px_[m] = std::sqrt(square.segment<2>(static_cast<Eigen::Index>(2 * m)).sum() / (2 * tries));
}

std::optional<ShapePoses::Estimate> ShapePoses::operator()(const FaceShape& shape) const {
  const auto seen = model_.complete(markers_at(positions_, edge_curves(shape)));
  if (!seen) return std::nullopt;
  const Eigen::VectorXd pose = model_.modes(*seen).cwiseProduct(model_.mode_sd_px());
  const Eigen::VectorXd layout = layout_at(pose, {});
  Estimate estimate;
  estimate.distance_px = search_.nearest(*seen).distance_px;
  estimate.known_pose = estimate.distance_px <= known_px_;
  for (std::size_t m = 0; m < sd_px_.size(); ++m) {
    const auto k = static_cast<Eigen::Index>(2 * m);
    estimate.markers.push_back({layout[k], layout[k + 1], false, sd_px_[m]});
  }
  return estimate;
}

}  // namespace alltact
