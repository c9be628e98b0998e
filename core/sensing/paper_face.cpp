#include "core/sensing/paper_face.h"

#include "core/numerics/chebyshev.h"
#include "core/numerics/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kStripPx = 32;
constexpr double kMinContrast = 16;  // of a strip's bright part over its dark part, grey levels
constexpr int kProfileDegree = 5;
constexpr double kUnseen = std::numeric_limits<double>::quiet_NaN();

/// Otsu's threshold of a strip; nullopt where all of it is dark or all of it is bright.
std::optional<double> threshold_of_strip(const cv::Mat& strip) {
  cv::Mat ignored;
  const double level = cv::threshold(strip, ignored, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
  const cv::Mat bright = strip > level;
  const cv::Scalar inside = cv::mean(strip, bright), outside = cv::mean(strip, ~bright);
  if (!(inside[0] - outside[0] >= kMinContrast)) return std::nullopt;
  return level;
}

cv::Mat binarised(const cv::Mat& grey) {
  cv::Mat binary(grey.size(), CV_8UC1, cv::Scalar(0));
  for (int first = 0; first < grey.cols; first += kStripPx) {
    const cv::Rect columns(first, 0, std::min(kStripPx, grey.cols - first), grey.rows);
    const auto level = threshold_of_strip(grey(columns));
    if (level) cv::compare(grey(columns), *level, binary(columns), cv::CMP_GT);
  }
  return binary;
}

/// Chebyshev polynomial over x, fitted by linear regression.
class PaperCurve {
 public:
  PaperCurve(const std::vector<double>& x, const std::vector<double>& y, int degree) {
    const auto [lowest, highest] = std::minmax_element(x.begin(), x.end());
    middle_ = 0.5 * (*lowest + *highest);
    half_ = std::max(1e-9, 0.5 * (*highest - *lowest));
    const auto n = static_cast<Eigen::Index>(x.size());
    Eigen::MatrixXd design(n, degree + 1);
    for (Eigen::Index i = 0; i < n; ++i)
      design.row(i) = chebyshev_row(at(x[static_cast<std::size_t>(i)]), degree + 1);
    values_ = least_squares(design, Eigen::Map<const Eigen::VectorXd>(y.data(), n));
    slopes_ = chebyshev_derivative(values_);
  }
  [[nodiscard]] double value(double x) const { return chebyshev_value(values_, at(x)); }
  [[nodiscard]] double slope(double x) const { return chebyshev_value(slopes_, at(x)) / half_; }

 private:
  [[nodiscard]] double at(double x) const { return (x - middle_) / half_; }
  double middle_ = 0, half_ = 1;
  Eigen::VectorXd values_, slopes_;
};

/// z where the line of sight x = across z meets the profile z = P(x). NaN where Newton's method
/// does not converge from the column's own z.
double intersect_profile(const PaperCurve& profile, double across, double z_mm) {
  for (int step = 0; step < 20; ++step) {
    const double off = profile.value(across * z_mm) - z_mm;
    const double slope = across * profile.slope(across * z_mm) - 1.0;
    const double move = off / slope;
    if (!std::isfinite(move)) return kUnseen;
    z_mm -= move;
    if (std::abs(move) < 1e-9) return z_mm > 0.0 ? z_mm : kUnseen;
  }
  return kUnseen;
}

Error paper_face_error(Message what) {
  return {std::move(what),
          en::say("the source paper's method"),
          en::say("a picture in which the whole face is bright against its side faces, or our own "
                  "method")};
}

}  // namespace

PaperEdges paper_edges(const cv::Mat& grey) {
  PaperEdges edges;
  edges.upper_v.assign(static_cast<std::size_t>(grey.cols), kUnseen);
  edges.lower_v = edges.upper_v;
  cv::Mat labels, parts, middles;
  const int count =
      cv::connectedComponentsWithStats(binarised(grey), labels, parts, middles, 4, CV_32S);
  int face = 0;
  for (int part = 1; part < count; ++part)
    if (face == 0 || parts.at<int>(part, cv::CC_STAT_AREA) > parts.at<int>(face, cv::CC_STAT_AREA))
      face = part;
  if (face == 0) return edges;
  std::vector<int> first(static_cast<std::size_t>(grey.cols), -1), last = first;
  for (int v = 0; v < grey.rows; ++v) {
    const int* row = labels.ptr<int>(v);
    for (int u = 0; u < grey.cols; ++u) {
      if (row[u] != face) continue;
      const auto column = static_cast<std::size_t>(u);
      if (first[column] < 0) first[column] = v;
      last[column] = v;
    }
  }
  for (std::size_t u = 0; u < first.size(); ++u) {
    if (first[u] <= 0 || last[u] >= grey.rows - 1 || last[u] == first[u]) continue;
    edges.upper_v[u] = first[u] - 0.5;
    edges.lower_v[u] = last[u] + 0.5;
    ++edges.seen;
  }
  return edges;
}

Result<PaperFace> PaperFace::fit(const PaperEdges& edges, const Camera& camera, const Face& face) {
  if (!camera.is_perspective())
    return paper_face_error(
        en::say("the shape of a Fin Ray needs a perspective camera, not an orthographic one"));
  const std::size_t width = edges.upper_v.size();
  if (5 * edges.seen < static_cast<int>(width))
    return paper_face_error(en::say(
        "the binarised picture shows both edges of the face in {} of {} columns, and a fifth of "
        "them is needed",
        edges.seen,
        width));
  std::vector<double> x_mm, z_mm, middle;
  std::vector<std::size_t> columns;
  for (std::size_t u = 0; u < width; ++u) {
    if (!std::isfinite(edges.upper_v[u])) continue;
    const auto upper = camera.unproject({static_cast<double>(u), edges.upper_v[u]});
    const auto lower = camera.unproject({static_cast<double>(u), edges.lower_v[u]});
    if (!upper || !lower) continue;
    const Eigen::Vector2d a = upper->direction.head<2>() / upper->direction.z(),
                          b = lower->direction.head<2>() / lower->direction.z();
    const double z = face.width_mm / (b.y() - a.y());  // fy W / (v2 - v1)
    if (!(z > 0.0) || !std::isfinite(z)) continue;
    columns.push_back(u);
    z_mm.push_back(z);
    x_mm.push_back(0.5 * (a.x() + b.x()) * z);
    middle.push_back(0.5 * (a.y() + b.y()));
  }
  if (columns.size() < 4 * (kProfileDegree + 1))
    return paper_face_error(en::say("no distance of the face follows from its edges"));
  const PaperCurve profile(x_mm, z_mm, kProfileDegree);
  const std::vector<double> column_u(columns.begin(), columns.end());
  const PaperCurve line(column_u, middle, kProfileDegree);
  PaperFace fitted;
  fitted.z_mm_.assign(width, kUnseen);
  fitted.middle_y_.assign(width, kUnseen);
  bool any = false;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double z = intersect_profile(profile, x_mm[i] / z_mm[i], z_mm[i]);
    fitted.z_mm_[columns[i]] = z;
    fitted.middle_y_[columns[i]] = line.value(column_u[i]);
    any = any || std::isfinite(z);
  }
  if (!any) return paper_face_error(en::say("no distance of the face follows from its edges"));
  return fitted;
}

Result<FaceShape> PaperFace::shape(const Camera& camera, const Face& face) const {
  constexpr int kStep = 4, kDegree = 12;
  constexpr double kSdPx = 0.29;  // of an edge quantised to integer pixels: 1 / sqrt(12)
  FaceEdges edges;
  const auto add = [&](Edge& edge, const Eigen::Vector2d* pixel) {
    edge.v.push_back(pixel ? pixel->y() : 0.0);
    edge.sd.push_back(kSdPx);
    edge.valid.push_back(pixel != nullptr);
  };
  for (std::size_t u = 0; u < z_mm_.size(); u += kStep) {
    const double z = z_mm_[u];
    edges.u.push_back(static_cast<double>(u));
    std::optional<Eigen::Vector2d> upper, lower;
    if (const auto pixel = camera.unproject({static_cast<double>(u), camera.parameters().cy_px});
        pixel && std::isfinite(z)) {
      const double x = z * pixel->direction.x() / pixel->direction.z();
      const double y = z * middle_y_[u];
      upper = camera.project({x, y - 0.5 * face.width_mm, z});
      lower = camera.project({x, y + 0.5 * face.width_mm, z});
    }
    add(edges.upper, upper && lower ? &*upper : nullptr);
    add(edges.lower, upper && lower ? &*lower : nullptr);
  }
  return FaceShape::fit(edges, camera, face, kDegree, std::numeric_limits<double>::infinity());
}

}  // namespace alltact
