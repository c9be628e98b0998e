#include "calibration/presses/manual_ball.h"

#include "core/geometry/ball.h"
#include "core/geometry/circle_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace alltact {
namespace {

constexpr int kRimPoints = 72;

/// A rim with more than two points off the face is cut by its edge.
bool is_cut(const Press& press, const std::vector<Eigen::Vector2d>& rim) {
  const cv::Mat& x = press.difference.x;
  const auto off = std::count_if(rim.begin(), rim.end(), [&](const Eigen::Vector2d& p) {
    const cv::Point at(static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y())));
    return !cv::Rect(0, 0, x.cols, x.rows).contains(at) || !std::isfinite(x.at<float>(at));
  });
  return off > 2;
}

}  // namespace

std::optional<BallOnFace> ball_on_face(const FaceShape& shape,
                                       const Face& face,
                                       const Eigen::Vector3d& centre_mm,
                                       double radius_mm) {
  std::optional<BallOnFace> contact;
  Eigen::Vector3d seen = centre_mm;
  for (int i = 0; i < 5; ++i) {  // from the line of sight to the foot of the normal
    const auto pixel = shape.camera().project(seen);
    const auto local = pixel ? shape.at(pixel->x(), pixel->y()) : std::nullopt;
    if (!local) return contact;
    const Eigen::Vector3d face_point =
        untouched_point_mm(*local, face.layer_mm, MappingAlong::kNormal);
    const double height = (centre_mm - face_point).dot(local->normal);
    contact = BallOnFace{radius_mm - height,
                         std::sqrt(std::max(0.0, (radius_mm - height) * (radius_mm + height))),
                         centre_mm - height * local->normal,
                         local->normal};
    seen = contact->middle_mm - face.layer_mm * local->normal;
  }
  return contact;
}

std::vector<Eigen::Vector2d> contact_rim_px(const Camera& camera,
                                            const BallOnFace& contact,
                                            int count) {
  std::vector<Eigen::Vector2d> rim;
  if (!(contact.radius_mm > 0)) return rim;
  const Eigen::Vector3d first = contact.normal.unitOrthogonal();
  const Eigen::Vector3d second = contact.normal.cross(first);
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * M_PI * i / count;
    const Eigen::Vector3d point =
        contact.middle_mm + contact.radius_mm * (std::cos(turn) * first + std::sin(turn) * second);
    if (const auto pixel = camera.project(point)) rim.push_back(*pixel);
  }
  return rim;
}

Result<BallGuess> guess_of_manual_ball(const Press& press,
                                       const Face& face,
                                       const Eigen::Vector3d& centre_mm) {
  const double radius_mm = press.ball_radius_mm;
  const Camera& camera = press.shape.camera();
  const auto contact = ball_on_face(press.shape, face, centre_mm, radius_mm);
  const auto outline = fit_circle(ball_outline_px(camera, centre_mm, radius_mm, kRimPoints));
  if (!contact || !(contact->depth_mm > 0) || !(contact->depth_mm < radius_mm) || !outline)
    return Error{en::say("the ball that was put there by hand does not touch the face"),
                 press.name,
                 en::say("moving its outline onto the dark disc, or having the ball found")};
  BallGuess guess;
  guess.centre_mm = centre_mm;
  guess.contact_radius_mm = contact->radius_mm;
  guess.rim_arc_deg = 360;
  guess.cut_by_edge = is_cut(press, contact_rim_px(camera, *contact, kRimPoints));
  // The source paper's method uses the drawn circle as the disc.
  guess.disc_px = outline->centre;
  guess.disc_radius_px = outline->radius;
  return guess;
}

}  // namespace alltact
