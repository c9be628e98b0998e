#include "calibration/presses/press.h"

#include "core/geometry/ball.h"
#include "core/geometry/circle_fit.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

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

std::optional<BallOnFace> ball_on_face(const FaceShape& shape, const Face& face,
                                       const Eigen::Vector3d& centre_mm, double radius_mm) {
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
                         centre_mm - height * local->normal, local->normal};
    seen = contact->middle_mm - face.layer_mm * local->normal;
  }
  return contact;
}

std::vector<Eigen::Vector2d> contact_rim_px(const Camera& camera, const BallOnFace& contact,
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

Result<BallGuess> guess_of_manual_ball(const Press& press, const Face& face,
                                       const Eigen::Vector3d& centre_mm) {
  const double radius_mm = press.ball_radius_mm;
  const Camera& camera = press.shape.camera();
  const auto contact = ball_on_face(press.shape, face, centre_mm, radius_mm);
  const auto outline = fit_circle(ball_outline_px(camera, centre_mm, radius_mm, kRimPoints));
  if (!contact || !(contact->depth_mm > 0) || !(contact->depth_mm < radius_mm) || !outline)
    return Error{en::say("the ball that was set by hand does not touch the face"), press.name,
                 en::say("moving its outline to the dark disc, or automatic detection")};
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

namespace {

/// Noise of block means: white noise has second differences of variance 6 sd^2, a smooth relief
/// nearly none.
double noise_of(const cv::Mat& means) {
  std::vector<double> differences;
  for (int row = 0; row < means.rows; ++row) {
    const float* x = means.ptr<float>(row);
    for (int u = 1; u + 1 < means.cols; ++u) {
      const double second = x[u - 1] - 2.0 * x[u] + x[u + 1];
      if (std::isfinite(second)) differences.push_back(std::abs(second));
    }
  }
  if (differences.size() < 20) return 0.0;
  return 1.4826 * upper_median(differences) / std::sqrt(6.0);
}

/// Means of complete blocks; NaN where any pixel is (a NaN in a sum stays one).
cv::Mat block_means(const cv::Mat& x, int block) {
  cv::Mat means(x.rows / block, x.cols / block, CV_32FC1);
  for (int row = 0; row < means.rows; ++row) {
    for (int column = 0; column < means.cols; ++column) {
      double sum = 0;
      for (int v = row * block; v < (row + 1) * block; ++v) {
        const float* line = x.ptr<float>(v) + std::ptrdiff_t{column} * block;
        for (int u = 0; u < block; ++u) sum += static_cast<double>(line[u]);
      }
      means.at<float>(row, column) = static_cast<float>(sum / (block * block));
    }
  }
  return means;
}

/// Derivative of the untouched point by the pixel; zero where the face ends.
Eigen::Vector3d by_pixel(const FaceShape& shape, const Face& face, const Eigen::Vector2d& pixel,
                         const Eigen::Vector2d& step) {
  const Eigen::Vector2d from = pixel - step, to = pixel + step;
  const auto before = shape.at(from.x(), from.y()), after = shape.at(to.x(), to.y());
  if (!before || !after) return Eigen::Vector3d::Zero();
  return 0.5 * (untouched_point_mm(*after, face.layer_mm, MappingAlong::kNormal) -
                untouched_point_mm(*before, face.layer_mm, MappingAlong::kNormal));
}

void set_derivatives(const Press& press, const Face& face, PressSamples* samples) {
  for (Sample& sample : samples->samples) {
    sample.by_u = by_pixel(press.shape, face, sample.pixel, {1, 0});
    sample.by_v = by_pixel(press.shape, face, sample.pixel, {0, 1});
  }
}

PressSamples sample_in(const Press& press, const Face& face, const cv::Rect& box, int block_px) {
  PressSamples result;
  result.ball_radius_mm = press.ball_radius_mm;
  result.given_depth = press.given_depth;
  result.block_px = block_px;
  result.blur_px2 = press.difference.blur_px2 + block_px * block_px / 12.0;
  const cv::Mat means = block_means(press.difference.x(box), block_px);
  result.x_sd = noise_of(means);
  for (int row = 0; row < means.rows; ++row) {
    for (int column = 0; column < means.cols; ++column) {
      const double x = static_cast<double>(means.at<float>(row, column));
      if (!std::isfinite(x)) continue;
      const Eigen::Vector2d pixel(box.x + (column + 0.5) * block_px - 0.5,
                                  box.y + (row + 0.5) * block_px - 0.5);
      const auto local = press.shape.at(pixel.x(), pixel.y());
      if (!local) continue;
      Sample sample;
      sample.pixel = pixel;
      sample.untouched_z = untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ);
      sample.untouched_n = untouched_point_mm(*local, face.layer_mm, MappingAlong::kNormal);
      sample.normal = local->normal;
      sample.cos_incline = local->cos_incline;
      sample.x = x;
      sample.position_mm = press.shape.position_mm(pixel.x(), pixel.y());
      result.samples.push_back(sample);
    }
  }
  return result;
}

void retain_near(const Eigen::Vector3d& middle, double radius_mm, PressSamples* press) {
  std::erase_if(press->samples, [&](const Sample& s) {
    return !((s.untouched_n - middle).squaredNorm() <= radius_mm * radius_mm);
  });
}

}  // namespace

PressedArea pressed_area(const std::vector<const PressSamples*>& presses) {
  constexpr double kMinMm = 1.0;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const PressSamples* press : presses)
    for (const Sample& sample : press->samples) {
      low = low.cwiseMin(sample.position_mm);
      high = high.cwiseMax(sample.position_mm);
    }
  if (!low.allFinite()) return {};
  return {0.5 * (low + high), (0.5 * (high - low)).cwiseMax(kMinMm)};
}

void set_unit_positions(const PressedArea& part, PressSamples* press) {
  for (Sample& sample : press->samples)
    sample.unit_position = (sample.position_mm - part.middle_mm).cwiseQuotient(part.half_mm);
}

PressSamples sample_press(const Press& press, const Face& face, int block_px) {
  PressSamples samples = sample_in(press, face, {{0, 0}, press.difference.x.size()}, block_px);
  set_derivatives(press, face, &samples);
  return samples;
}

const Sample* nearest_sample(const PressSamples& press, const Eigen::Vector3d& point_mm) {
  const auto nearest = std::min_element(
      press.samples.begin(), press.samples.end(), [&](const Sample& a, const Sample& b) {
        return (a.untouched_n - point_mm).squaredNorm() < (b.untouched_n - point_mm).squaredNorm();
      });
  return nearest == press.samples.end() ? nullptr : &*nearest;
}

PressSamples sample_around(const Press& press, const Face& face, const Eigen::Vector3d& middle,
                           double radius_mm, int limit) {
  // The approximate extent from a coarse sample, then blocks as fine as the limit allows.
  constexpr int kRough = 8;
  constexpr int kFinest = 2;
  PressSamples rough = sample_in(press, face, {{0, 0}, press.difference.x.size()}, kRough);
  retain_near(middle, radius_mm + 0.01 * middle.norm(), &rough);
  if (rough.samples.empty()) return rough;
  Eigen::Vector2d low = rough.samples.front().pixel;
  Eigen::Vector2d high = low;
  for (const Sample& sample : rough.samples) {
    low = low.cwiseMin(sample.pixel);
    high = high.cwiseMax(sample.pixel);
  }
  const cv::Point first(static_cast<int>(low.x()) - 2 * kRough,
                        static_cast<int>(low.y()) - 2 * kRough);
  const cv::Point last(static_cast<int>(high.x()) + 2 * kRough,
                       static_cast<int>(high.y()) + 2 * kRough);
  const cv::Rect box = cv::Rect(first, last) & cv::Rect({0, 0}, press.difference.x.size());
  const double pixels = static_cast<double>(rough.samples.size()) * kRough * kRough;
  const int block = std::max(kFinest, static_cast<int>(std::ceil(std::sqrt(pixels / limit))));
  PressSamples near = sample_in(press, face, box, block);
  retain_near(middle, radius_mm, &near);
  set_derivatives(press, face, &near);
  return near;
}

void update_brightness(const cv::Mat& x, PressSamples* samples) {
  const int block = samples->block_px;
  for (Sample& sample : samples->samples) {
    const cv::Rect part(static_cast<int>(std::lround(sample.pixel.x() + 0.5 - 0.5 * block)),
                        static_cast<int>(std::lround(sample.pixel.y() + 0.5 - 0.5 * block)), block,
                        block);
    const double mean = static_cast<double>(block_means(x(part), block).at<float>(0, 0));
    if (std::isfinite(mean)) sample.x = mean;
  }
}

namespace {

constexpr double kSmoothingPx = 2.0;
constexpr double kMinimumRimDeg = 60.0;
constexpr double kRoughRim = 0.16;  // rms distance from the circle / radius
constexpr double kRagged = 0.72;    // minimum dark fraction of the circle's inside
constexpr int kMinimumPixels = 60;
constexpr double kMinContrast = 0.012;  // of the brightness: about a tenth of a millimetre
constexpr double kContrastSd = 5.0;     // times the scatter of the untouched face
/// Two contacts are refused where the second has more than this fraction of the first's weight.
constexpr double kSecondContact = 0.3;

Error refuse(const Press& press, Message what, Message advice) {
  return {std::move(what), press.name, std::move(advice)};
}

/// The difference smoothed over measured pixels, NaN off the face.
cv::Mat smoothed(const cv::Mat& x) {
  const cv::Mat known = measured_pixels(x);
  cv::Mat filled = x.clone();
  filled.setTo(0.0F, ~known);
  cv::Mat weight;
  known.convertTo(weight, CV_32FC1, 1.0 / 255.0);
  cv::GaussianBlur(filled, filled, {}, kSmoothingPx, kSmoothingPx, cv::BORDER_CONSTANT);
  cv::GaussianBlur(weight, weight, {}, kSmoothingPx, kSmoothingPx, cv::BORDER_CONSTANT);
  cv::Mat result = filled / cv::max(weight, 1e-3F);
  result.setTo(std::numeric_limits<float>::quiet_NaN(), ~known);
  return result;
}

struct Levels {
  double untouched = 0;  ///< median over the face
  double spread = 0;     ///< robust standard deviation of the quieter side
  double darkest = 0;    ///< mean of the darkest 0.3 %
};

std::optional<Levels> levels_of(const cv::Mat& x) {
  std::vector<float> values;
  for (int v = 0; v < x.rows; ++v)
    for (int u = 0; u < x.cols; ++u)
      if (const float value = x.at<float>(v, u); std::isfinite(value)) values.push_back(value);
  if (values.size() < std::size_t{20} * kMinimumPixels) return std::nullopt;
  const std::size_t top = std::max<std::size_t>(kMinimumPixels / 3, values.size() / 333);
  const auto at = [&](std::size_t rank) {
    const auto here = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), here, values.end());
    return static_cast<double>(*here);
  };
  const auto part = [&](double of) {
    return static_cast<std::size_t>(of * static_cast<double>(values.size() - 1));
  };
  Levels levels;
  levels.untouched = at(part(0.5));
  levels.spread = std::max(1e-4, levels.untouched - at(part(0.16)));
  at(values.size() - top);  // partially sorts, so that the darkest are at the end
  double sum = 0;
  for (std::size_t i = values.size() - top; i < values.size(); ++i) sum += values[i];
  levels.darkest = sum / static_cast<double>(top);
  return levels;
}

/// A connected dark region of the image.
struct Patch {
  int label = 0;
  int pixels = 0;
  double weight = 0;  ///< sum of x
  cv::Rect box;
};

std::vector<Patch> patches_of(const cv::Mat& labels, const cv::Mat& x, int count) {
  std::vector<Patch> patches(static_cast<std::size_t>(count));
  for (int v = 0; v < labels.rows; ++v) {
    for (int u = 0; u < labels.cols; ++u) {
      const int label = labels.at<int>(v, u);
      if (label == 0) continue;
      Patch& patch = patches[static_cast<std::size_t>(label)];
      patch.label = label;
      ++patch.pixels;
      patch.box |= cv::Rect(u, v, 1, 1);
      patch.weight += static_cast<double>(x.at<float>(v, u));
    }
  }
  std::erase_if(patches, [](const Patch& p) { return p.pixels < kMinimumPixels; });
  std::stable_sort(patches.begin(), patches.end(),
                   [](const Patch& a, const Patch& b) { return a.weight > b.weight; });
  return patches;
}

/// The dark regions of a face, largest weight first.
struct DarkRegions {
  Levels levels;
  double contrast = 0, level = 0;  ///< everything darker than the level is dark
  cv::Mat labels;
  std::vector<Patch> patches;
};

std::optional<DarkRegions> dark_regions(const cv::Mat& x) {
  const auto levels = levels_of(x);
  if (!levels) return std::nullopt;
  DarkRegions dark{*levels, 0, 0, {}, {}};
  const double untouched = std::max(0.0, levels->untouched);
  dark.contrast = levels->darkest - untouched;
  dark.level = untouched + kDiscLevel * dark.contrast;
  const cv::Mat is_dark = x > dark.level;
  const int count = cv::connectedComponents(is_dark, dark.labels, 4, CV_32S);
  dark.patches = patches_of(dark.labels, x, count);
  return dark;
}

/// Columns of the face away from its two ends, whose dark borders change with the smallest motion.
cv::Range away_from_ends(const cv::Mat& x) {
  constexpr double kEnd = 0.03;  // of the columns
  int first = x.cols, last = -1;
  for (int v = 0; v < x.rows; ++v)
    for (int u = 0; u < x.cols; ++u)
      if (std::isfinite(x.at<float>(v, u))) first = std::min(first, u), last = std::max(last, u);
  const int margin = static_cast<int>(std::lround(kEnd * (last - first)));
  return last < first ? cv::Range(0, 0) : cv::Range(first + margin, last - margin + 1);
}

/// The border of an end of the face, and no contact. Its width is a mean: noise frays its sides.
bool is_end_of_face(const Patch& patch, const cv::Range& away_from_ends) {
  constexpr int kNarrow = 3;  // times higher than wide; half a disc is 2.5 times
  const bool is_at_end =
      patch.box.x < away_from_ends.start || patch.box.x + patch.box.width > away_from_ends.end;
  return is_at_end && patch.box.height * patch.box.height > kNarrow * patch.pixels;
}

/// Makes the dark borders of the face's ends unmeasured; false: there are none.
bool leave_out_ends(const DarkRegions& dark, cv::Mat* x) {
  const cv::Range away = away_from_ends(*x);
  bool found = false;
  for (const Patch& patch : dark.patches) {
    if (!is_end_of_face(patch, away)) continue;
    x->setTo(std::numeric_limits<float>::quiet_NaN(), dark.labels == patch.label);
    found = true;
  }
  return found;
}

/// Points where the level is crossed between neighbouring pixels on the patch's border, on the
/// rolled-out face (length along it, y). Borders at the face's own end are counted, not used.
struct Rim {
  std::vector<Eigen::Vector2d> points_mm, points_px;
  int off_face = 0;
};

Rim rim_of(const Press& press, const cv::Mat& x, const cv::Mat& labels, double level, int label) {
  Rim rim;
  constexpr std::array<std::array<int, 2>, 4> kSteps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const auto step = [&](int u, int v, int du, int dv) {
    const int u2 = u + du;
    const int v2 = v + dv;
    const bool inside = u2 >= 0 && v2 >= 0 && u2 < x.cols && v2 < x.rows;
    const float beyond = inside ? x.at<float>(v2, u2) : std::numeric_limits<float>::quiet_NaN();
    if (!std::isfinite(beyond)) {
      ++rim.off_face;
      return;
    }
    if (labels.at<int>(v2, u2) == label) return;
    const double here = static_cast<double>(x.at<float>(v, u));
    const double drop = here - static_cast<double>(beyond);
    const double part = drop > 0.0 ? std::clamp((here - level) / drop, 0.0, 1.0) : 0.5;
    const Eigen::Vector2d pixel(u + part * du, v + part * dv);
    const auto local = press.shape.at(pixel.x(), pixel.y());
    if (!local) return;
    rim.points_px.push_back(pixel);
    rim.points_mm.emplace_back(press.shape.length_at(pixel.x()), local->view_point_mm.y());
  };
  for (int v = 0; v < x.rows; ++v)
    for (int u = 0; u < x.cols; ++u)
      if (labels.at<int>(v, u) == label)
        for (const auto& [du, dv] : kSteps) step(u, v, du, dv);
  return rim;
}

double arc_deg(const std::vector<Eigen::Vector2d>& points, const Circle& circle) {
  constexpr std::size_t kBins = 60;  // wide enough that the rim of the smallest disc fills them
  std::array<bool, kBins> seen{};
  for (const auto& p : points) {
    const Eigen::Vector2d d = p - circle.centre;
    const double turn = (std::atan2(d.y(), d.x()) + M_PI) / (2.0 * M_PI);
    seen[std::min(kBins - 1, static_cast<std::size_t>(turn * kBins))] = true;
  }
  return 360.0 / kBins * static_cast<double>(std::count(seen.begin(), seen.end(), true));
}

/// A circle through most of the points: refitted without those more than 2.5 sd off.
std::optional<Circle> robust_circle(std::vector<Eigen::Vector2d> points) {
  auto circle = fit_circle_taubin(points);
  for (int round = 0; circle && round < 3; ++round) {
    const double gate = std::max(2.5 * circle->rms, 1e-6 * circle->radius);
    const std::size_t before = points.size();
    std::erase_if(points, [&](const Eigen::Vector2d& p) {
      return std::abs((p - circle->centre).norm() - circle->radius) > gate;
    });
    if (points.size() < 3) return std::nullopt;
    circle = fit_circle(points);
    if (points.size() == before) break;
  }
  return circle;
}

/// The image inside the circle.
struct Inside {
  double dark_share = 0;                                   ///< of the circle's region on the face
  std::optional<FaceShape::Local> nearest;                 ///< to the circle's middle
  Eigen::Vector2d to_middle_mm = Eigen::Vector2d::Zero();  ///< from there, on the rolled-out face
};

Inside analyse_inside(const Press& press, const cv::Mat& x, const Circle& circle, double level) {
  Inside inside;
  int dark = 0;
  int all = 0;
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (int u = 0; u < x.cols; ++u) {
    const double length = press.shape.length_at(u);
    if (std::abs(length - circle.centre.x()) > circle.radius) continue;
    for (int v = 0; v < x.rows; ++v) {
      const float value = x.at<float>(v, u);
      if (!std::isfinite(value)) continue;
      const auto local = press.shape.at(u, v);
      if (!local) continue;
      const Eigen::Vector2d to_middle =
          circle.centre - Eigen::Vector2d(length, local->view_point_mm.y());
      const double distance = to_middle.norm();
      if (distance < nearest_mm) {
        nearest_mm = distance;
        inside.nearest = local;
        inside.to_middle_mm = to_middle;
      }
      if (distance > 0.95 * circle.radius) continue;
      ++all;
      dark += static_cast<double>(value) > level ? 1 : 0;
    }
  }
  inside.dark_share = all > 0 ? static_cast<double>(dark) / all : 0.0;
  return inside;
}

Result<BallGuess> find(const Press& press, const Face& face) {
  constexpr int kMostBorders = 4;
  const double ball_radius_mm = press.ball_radius_mm;
  cv::Mat x = smoothed(press.difference.x);
  auto dark = dark_regions(x);
  // Behind the darkest border there may be one that only this level shows.
  for (int i = 0; dark && i < kMostBorders && leave_out_ends(*dark, &x); ++i)
    dark = dark_regions(x);
  if (!dark)
    return refuse(press,
                  en::say("hardly any pixel of the face could be compared with the reference"),
                  en::say("a press and a reference of the same size in which the face is lit"));
  if (dark->contrast < std::max(kMinContrast, kContrastSd * dark->levels.spread))
    return refuse(
        press,
        en::say("nothing on the face is clearly darker than in the reference (the "
                "darkest part differs by {:.1f} %, the rest scatters by {:.1f} %)",
                100.0 * dark->contrast, 100.0 * dark->levels.spread),
        en::say("pressing the ball in deeper, and checking that the reference shows the same "
                "finger in the same pose"));
  const double level = dark->level;
  const cv::Mat& labels = dark->labels;
  const std::vector<Patch>& patches = dark->patches;
  if (patches.empty())
    return refuse(press,
                  en::say("only specks are dark, none larger than {} pixels", kMinimumPixels),
                  en::say("pressing the ball in deeper"));
  if (patches.size() > 1 && patches[1].weight > kSecondContact * patches[0].weight)
    return refuse(press,
                  en::say("two contacts were found, the second with {:.0f} % of the first",
                          100.0 * patches[1].weight / patches[0].weight),
                  en::say("a press in which only the ball touches the face"));

  const Rim rim = rim_of(press, x, labels, level, patches[0].label);
  const auto circle = robust_circle(rim.points_mm);
  const auto circle_px = robust_circle(rim.points_px);
  if (!circle || !circle_px)
    return refuse(press, en::say("the border of the dark part is not a circular arc"),
                  en::say("a press in which the ball is entirely on the face"));
  BallGuess guess;
  guess.rim_arc_deg = arc_deg(rim.points_mm, *circle);
  guess.cut_by_edge = rim.off_face > 2;
  guess.disc_px = circle_px->centre;
  guess.disc_radius_px = circle_px->radius;
  guess.disc_radius_mm = circle->radius;
  if (guess.rim_arc_deg < kMinimumRimDeg)
    return refuse(
        press,
        en::say("only {:.0f} degrees of the dark disc's rim are on the face", guess.rim_arc_deg),
        en::say("a press closer to the middle of the face"));
  if (circle->radius > ball_radius_mm)
    return refuse(press,
                  en::say("the dark part has a radius of {:.2f} mm, more than the ball's {:g} mm",
                          circle->radius, ball_radius_mm),
                  en::say("checking the ball's radius, or an image with only the ball in contact"));
  double spread = 0;
  for (const auto& p : rim.points_mm)
    spread += std::pow((p - circle->centre).norm() - circle->radius, 2);
  spread = std::sqrt(spread / static_cast<double>(rim.points_mm.size())) / circle->radius;
  const Inside inside = analyse_inside(press, x, *circle, level);
  if (spread > kRoughRim || inside.dark_share < kRagged || !inside.nearest)
    return refuse(press,
                  en::say("the dark part is not a disc: its rim is off a circle by {:.0f} % of the "
                          "radius, and {:.0f} % of the circle is dark",
                          100.0 * spread, 100.0 * inside.dark_share),
                  en::say("an image in which a ball, and only the ball, touches the face"));
  if (inside.to_middle_mm.norm() > circle->radius)
    return refuse(press, en::say("the middle of the dark disc is outside the face"),
                  en::say("a press closer to the middle of the face"));

  const double depth = disc_depth_mm(circle->radius, ball_radius_mm);
  guess.contact_radius_mm = std::sqrt(std::max(0.0, depth * (2.0 * ball_radius_mm - depth)));
  const Eigen::Vector3d& normal = inside.nearest->normal;
  const Eigen::Vector3d tipward =
      Eigen::Vector3d(normal.z(), 0.0, -normal.x()) * (press.shape.base_at_low_u() ? 1.0 : -1.0);
  const Eigen::Vector3d top =
      untouched_point_mm(*inside.nearest, face.layer_mm, MappingAlong::kNormal) +
      inside.to_middle_mm.x() * tipward + inside.to_middle_mm.y() * Eigen::Vector3d::UnitY();
  guess.centre_mm = top + (ball_radius_mm - depth) * normal;
  return guess;
}

}  // namespace

Result<BallGuess> find_ball(const Press& press, const Face& face) {
  if (!(press.ball_radius_mm > 0.0) || !std::isfinite(press.ball_radius_mm))
    return Error{en::say("a ball radius of {} mm is impossible", press.ball_radius_mm), press.name,
                 en::say("the radius in millimetres, as measured with callipers")};
  if (press.difference.x.type() != CV_32FC1 || press.difference.x.empty() ||
      press.difference.x.cols != press.shape.width_px())
    return refuse(press, en::say("the press has no difference image"),
                  en::say("taking the image again"));
  try {
    return find(press, face);
  } catch (const cv::Exception& problem) {
    return refuse(press, en::say("OpenCV failed: {}", std::string(problem.what())),
                  en::say("a smaller image"));
  }
}

}  // namespace alltact
