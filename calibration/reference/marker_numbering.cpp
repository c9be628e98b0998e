#include "calibration/reference/marker_numbering.h"

#include "core/numerics/median.h"
#include "core/sensing/markers/marker_model.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace alltact {
namespace {

/// Position of a marker's counterpart on the other side face, mirrored at the face's middle line.
using MirroredPosition = std::function<std::optional<Eigen::Vector2d>(int marker)>;

constexpr std::size_t kNodes = 3;

/// Existing markers of the same row, nearest by number first.
std::vector<int> nodes_of(int marker, const std::vector<int>& missing, int per_row) {
  const int first = marker / per_row * per_row;
  std::vector<int> nodes;
  for (int m = first; m < first + per_row; ++m)
    if (!std::binary_search(missing.begin(), missing.end(), m)) nodes.push_back(m);
  std::stable_sort(nodes.begin(), nodes.end(),
                   [marker](int a, int b) { return std::abs(a - marker) < std::abs(b - marker); });
  if (nodes.size() > kNodes) nodes.resize(kNodes);
  return nodes;
}

/// Fills the missing markers of one row of layouts (u0, v0, u1, ..., px). Each comes from a
/// parabola through up to three existing markers of its row, nearest by number. A row of fewer than
/// two uses those of the other side. The same markers are used in every layout; an invisible one
/// (NaN) leaves the missing marker NaN.
void interpolate_missing(const std::vector<int>& missing, const MirroredPosition& mirrored,
                         Eigen::MatrixXd& layouts, Eigen::Index row) {
  const int per_row = static_cast<int>(layouts.cols() / 4);
  for (const int marker : missing) {
    std::vector<int> nodes = nodes_of(marker, missing, per_row);
    const bool by_other_side = nodes.size() < 2;
    if (by_other_side) {
      nodes = nodes_of((marker + per_row) % (2 * per_row), missing, per_row);
      for (int& node : nodes) node = (node + per_row) % (2 * per_row);
    }
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    bool is_known = !nodes.empty();
    for (const int node : nodes) {
      double weight = 1.0;  // Lagrange's
      for (const int other : nodes)
        if (other != node) weight *= static_cast<double>(marker - other) / (node - other);
      std::optional<Eigen::Vector2d> at =
          layouts.row(row).segment<2>(Eigen::Index{2} * node).transpose();
      if (by_other_side) at = mirrored(node);
      is_known = is_known && at;
      if (at) position += weight * *at;
    }
    if (is_known) layouts.row(row).segment<2>(Eigen::Index{2} * marker) = position.transpose();
  }
}

constexpr double kMaxResidualPx = 3.0;

const std::vector<Dot>& dots_of(const FrameDots& frame, Polarity polarity) {
  return polarity == Polarity::kBright ? frame.bright : frame.dark;
}

constexpr std::size_t kMaxTracked = 300;  // frames that the rows are learnt from
constexpr int kMinMarkers = 4;            // fewer give no pose once one of them is hidden
constexpr double kMinSupport = 0.2;       // fraction of the frames a marker must be found in

// The rows, and the positions of their dots in the frames that were followed.
struct Rows {
  std::vector<std::vector<Dot>> seen;     // by frame followed, by number; contrast 0: not seen
  std::vector<const EdgeCurves*> curves;  // by frame followed
  std::vector<int> missing;
  double worth = -1;
};

std::vector<std::size_t> followed_frames(const std::vector<FrameDots>& frames) {
  std::vector<std::size_t> usable, followed;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (frames[i].problem.empty() && frames[i].curves.u.size() >= 2) usable.push_back(i);
  const std::size_t count = std::min(usable.size(), kMaxTracked);
  for (std::size_t k = 0; k < count; ++k) followed.push_back(usable[k * usable.size() / count]);
  return followed;
}

Rows find_rows(const std::vector<FrameDots>& frames, const std::vector<std::size_t>& followed,
               Polarity polarity, int per_row) {
  std::vector<FrameOfDots> dots_in;
  for (const std::size_t i : followed)
    dots_in.push_back({&dots_of(frames[i], polarity), &frames[i].curves});
  const auto tracks = track_dots(dots_in, kMinSupport);
  const NumberedRows numbered = choose_rows(tracks, per_row);
  Rows rows;
  rows.worth = numbered.worth;
  for (std::size_t m = 0; m < numbered.track_of.size(); ++m)
    if (numbered.track_of[m] < 0) rows.missing.push_back(static_cast<int>(m));
  for (std::size_t i = 0; i < followed.size(); ++i) {
    std::vector<Dot> seen(numbered.track_of.size());
    for (std::size_t m = 0; m < seen.size(); ++m) {
      if (numbered.track_of[m] < 0) continue;
      const int d = tracks[static_cast<std::size_t>(numbered.track_of[m])].dot_of[i];
      if (d >= 0) seen[m] = (*dots_in[i].dots)[static_cast<std::size_t>(d)];
    }
    rows.seen.push_back(std::move(seen));
    rows.curves.push_back(dots_in[i].curves);
  }
  return rows;
}

bool is_seen(const Dot& dot) { return dot.contrast != 0; }

// Typical appearance of each number; a missing one takes that of its row.
std::vector<Dot> typical_of(const Rows& rows) {
  std::vector<Dot> typical(rows.seen.front().size());
  const auto middle_of = [&](auto member, std::size_t first, std::size_t last) {
    std::vector<double> values;
    for (const auto& frame : rows.seen)
      for (std::size_t m = first; m < last; ++m)
        if (is_seen(frame[m])) values.push_back(frame[m].*member);
    return values.empty() ? 0.0 : upper_median(values);
  };
  const std::size_t per_row = typical.size() / 2;
  for (std::size_t m = 0; m < typical.size(); ++m) {
    std::size_t first = m, last = m + 1;
    const bool is_missing =
        std::binary_search(rows.missing.begin(), rows.missing.end(), static_cast<int>(m));
    if (is_missing) first = m / per_row * per_row, last = first + per_row;
    if (is_missing && middle_of(&Dot::contrast, first, last) == 0) first = 0, last = typical.size();
    typical[m] = {middle_of(&Dot::u, first, last),         middle_of(&Dot::v, first, last),
                  middle_of(&Dot::radius_px, first, last), middle_of(&Dot::contrast, first, last),
                  middle_of(&Dot::sd_px, first, last),     2 * m < typical.size()};
  }
  return typical;
}

// Drops dots whose size or contrast differ from the others of their number: another dot, or half
// covered.
void drop_inconsistent(const std::vector<Dot>& typical, Rows& rows) {
  for (auto& frame : rows.seen)
    for (std::size_t m = 0; m < frame.size(); ++m) {
      if (!is_seen(frame[m])) continue;
      const double size = frame[m].radius_px / typical[m].radius_px;
      const double contrast = frame[m].contrast / typical[m].contrast;
      if (size < 0.6 || size > 1.7 || contrast < 0.4 || contrast > 2.5) frame[m] = Dot{};
    }
}

// The layouts of the frames followed; NaN where a marker was not seen, or a missing one cannot be
// interpolated.
Eigen::MatrixXd layouts_of(const Rows& rows) {
  const std::size_t count = rows.seen.front().size();
  Eigen::MatrixXd layouts = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(rows.seen.size()),
                                                      static_cast<Eigen::Index>(2 * count),
                                                      std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < rows.seen.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t m = 0; m < count; ++m)
      if (const Dot& dot = rows.seen[i][m]; is_seen(dot))
        layouts.row(row).segment<2>(static_cast<Eigen::Index>(2 * m)) << dot.u, dot.v;
    const auto opposite = [&](int m) -> std::optional<Eigen::Vector2d> {
      const Dot& dot = rows.seen[i][(static_cast<std::size_t>(m) + count / 2) % count];
      if (!is_seen(dot)) return std::nullopt;
      return Eigen::Vector2d(dot.u, 2.0 * middle_at(*rows.curves[i], dot.u) - dot.v);
    };
    interpolate_missing(rows.missing, opposite, layouts, row);
  }
  return layouts;
}

// Why the rows were not found: the dots of the median frame.
Message too_few_dots(const std::vector<FrameDots>& frames, Polarity polarity, int per_row) {
  std::vector<double> upper, lower;
  for (const FrameDots& frame : frames) {
    if (!frame.problem.empty()) continue;
    const auto& dots = dots_of(frame, polarity);
    const auto above =
        std::count_if(dots.begin(), dots.end(), [](const Dot& d) { return d.upper; });
    upper.push_back(static_cast<double>(above));
    lower.push_back(static_cast<double>(dots.size()) - static_cast<double>(above));
  }
  const double above = upper_median(upper), below = upper_median(lower);
  return en::say(
      "a frame shows {} dots on the upper and {} on the lower side face (median of {} frames), but "
      "no two rows of up to {} with fixed positions on the finger",
      above, below, upper.size(), per_row);
}

void number_all(const std::vector<FrameDots>& frames, const MarkerModel& model,
                NumberedRecording& out) {
  out.markers.assign(frames.size(), std::nullopt);
  out.problems.assign(frames.size(), {});
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!frames[i].problem.empty()) {
      out.problems[i] = frames[i].problem;
      continue;
    }
    const auto& dots = dots_of(frames[i], out.polarity);
    auto markers = model.number(dots);
    if (!markers) {
      out.problems[i] = en::say("{} dots were found but they fit no pose of the {} markers",
                                dots.size(), model.present_count());
    } else if (2 * seen_count(*markers) < model.present_count()) {
      out.problems[i] =
          en::say("only {} of {} markers found", seen_count(*markers), model.present_count());
    } else if (const double residual = model.residual_px(*markers); residual > kMaxResidualPx) {
      out.problems[i] = en::say("the markers are {:.1f} px off any possible position", residual);
    } else {
      out.markers[i] = std::move(markers);
    }
  }
}

// The numbered frames, as layouts of a second training with more poses.
Result<MarkerModel> learn_again(const NumberedRecording& numbered) {
  const auto count = static_cast<Eigen::Index>(numbered.typical.size());
  Eigen::MatrixXd layouts(static_cast<Eigen::Index>(numbered.markers.size()), 2 * count);
  Eigen::Index n = 0;
  for (const auto& markers : numbered.markers) {
    if (!markers) continue;
    for (Eigen::Index m = 0; m < count; ++m) {
      const Marker& marker = (*markers)[static_cast<std::size_t>(m)];
      const bool is_missing =
          std::binary_search(numbered.missing.begin(), numbered.missing.end(), static_cast<int>(m));
      layouts.row(n).segment<2>(2 * m) << marker.u, marker.v;
      if (!marker.seen && !is_missing)
        layouts.row(n).segment<2>(2 * m).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    ++n;
  }
  layouts.conservativeResize(n, Eigen::NoChange);
  return MarkerModel::learn(layouts, numbered.typical, numbered.missing);
}

// False with the reason in out.no_markers: there are no usable markers.
bool number_by_dots(const std::vector<FrameDots>& frames, const MarkerRows& requested,
                    NumberedRecording& out) {
  const auto followed = followed_frames(frames);
  Rows rows;
  for (const Polarity polarity : {Polarity::kBright, Polarity::kDark}) {
    if (requested.polarity != Polarity::kAuto && requested.polarity != polarity) continue;
    Rows candidate = find_rows(frames, followed, polarity, requested.per_row);
    if (candidate.worth <= rows.worth) continue;
    out.polarity = polarity;
    rows = std::move(candidate);
  }
  const int present = 2 * requested.per_row - static_cast<int>(rows.missing.size());
  if (present < std::max(2, (2 * requested.per_row + 2) / 3)) {
    out.no_markers = too_few_dots(frames, out.polarity, requested.per_row);
    return false;
  }
  if (present < kMinMarkers) {
    out.no_markers = en::say("with {} markers, none may be hidden", present);
    return false;
  }
  out.missing = rows.missing;
  out.typical = typical_of(rows);
  drop_inconsistent(out.typical, rows);
  auto model = MarkerModel::learn(layouts_of(rows), out.typical, out.missing);
  if (!model) {
    out.no_markers = model.error().what;
    return false;
  }
  number_all(frames, *model, out);
  if (auto wider = learn_again(out)) {
    model = std::move(wider);
    number_all(frames, *model, out);
  }
  out.marker_noise_px = model->noise_px();
  const auto numbered = std::count_if(out.markers.begin(), out.markers.end(),
                                      [](const auto& m) { return m.has_value(); });
  if (numbered >= 2) return true;
  out.no_markers = too_few_dots(frames, out.polarity, requested.per_row);
  return false;
}

Error no_face(const std::vector<FrameDots>& frames) {
  const Message what = en::say("no frame shows the face");
  return {frames.empty() || frames.front().problem.empty() ? what
                                                           : en::at(what, frames.front().problem),
          en::say("recording"),
          en::say("a recording in which both long edges of the bright face are visible")};
}

// By positions on the face, in every frame that shows it.
Result<void> number_by_shape(const std::vector<FrameDots>& frames, NumberedRecording& out) {
  std::vector<EdgeCurves> faces;
  for (const FrameDots& frame : frames)
    if (frame.problem.empty() && frame.curves.u.size() >= 2) faces.push_back(frame.curves);
  out.positions = choose_edge_positions(faces);
  if (!out.positions || faces.size() < 2) return no_face(frames);
  out.polarity = Polarity::kAuto;
  out.missing.clear();
  constexpr int kCount = 2 * EdgePositions::kPerEdge;
  // These positions have no appearance; the table still needs radius and contrast.
  out.typical.assign(kCount, Dot{0, 0, 1.0, 1.0, 0, false});
  for (std::size_t m = 0; m < kCount; ++m) out.typical[m].upper = 2 * m < kCount;
  out.markers.assign(frames.size(), std::nullopt);
  out.problems.assign(frames.size(), {});
  for (std::size_t i = 0; i < frames.size(); ++i) {
    out.problems[i] = frames[i].problem;
    if (frames[i].problem.empty()) out.markers[i] = markers_at(*out.positions, frames[i].curves);
  }
  const auto model = learn_again(out);
  if (!model) return model.error();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!out.markers[i]) continue;
    out.markers[i] = model->complete(std::move(*out.markers[i]));
    if (!out.markers[i])
      out.problems[i] = en::say("too little face is visible to estimate the pose from its shape");
  }
  out.marker_noise_px = model->noise_px();
  return {};
}

}  // namespace

Result<NumberedRecording> number_recording(const std::vector<FrameDots>& frames,
                                           const MarkerRows& rows) {
  NumberedRecording out;
  const auto shows_face = [](const FrameDots& frame) { return frame.problem.empty(); };
  if (std::count_if(frames.begin(), frames.end(), shows_face) < 2) return no_face(frames);
  if (rows.per_row > 0 && number_by_dots(frames, rows, out)) return out;
  if (const auto numbered = number_by_shape(frames, out); !numbered) return numbered.error();
  return out;
}

namespace {

constexpr double kFirstGate = 0.05;  // of the face's length
constexpr double kGate = 0.02;       // once the common motion is known
constexpr double kOffWeight =
    0.3;  // of the distance from the face, which side faces that bulge change
constexpr int kTrialFrames = 12;  // after which a track with few detections is dropped
constexpr double kMinHitRate = 0.12;

/// A position next to the face, in coordinates that bend with it.
struct FacePosition {
  double along_mm = 0, off_face = 0;
};

/// Position along the face, from its crossing with a column that is the same in all frames.
class FaceOfFrame {
 public:
  FaceOfFrame(const EdgeCurves& curves, double from_u_px)
      : length_mm_(static_cast<double>(std::abs(curves.along_mm.back() - curves.along_mm.front()))),
        from_mm_(along_mm_at(curves, from_u_px)) {}
  [[nodiscard]] double length_mm() const { return length_mm_; }
  [[nodiscard]] FacePosition position(const Dot& dot) const {
    return {dot.along_mm - from_mm_, dot.off_face};
  }

 private:
  double length_mm_, from_mm_;
};

/// By frame, the earlier one it is linked to; in processing order.
struct Link {
  std::size_t frame, parent;
};
std::vector<Link> tree_of(const std::vector<FrameOfDots>& frames) {
  const std::size_t n = frames.size();
  std::vector<Link> links;
  std::vector<double> distance(n, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> parent(n, 0);
  std::vector<char> done(n, 0);
  // The frame with the most dots has the most information and is the root.
  std::size_t next = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (frames[i].dots->size() > frames[next].dots->size()) next = i;
  parent[next] = next;
  for (std::size_t count = 0; count < n; ++count) {
    if (count > 0) {
      next = n;
      for (std::size_t i = 0; i < n; ++i)
        if (!done[i] && (next == n || distance[i] < distance[next])) next = i;
    }
    done[next] = 1;
    links.push_back({next, parent[next]});
    for (std::size_t i = 0; i < n; ++i) {
      if (done[i]) continue;
      const double d = edge_distance_px(*frames[next].curves, *frames[i].curves);
      if (d < distance[i] || count == 0) distance[i] = d, parent[i] = next;
    }
  }
  return links;
}

double log_size(const Dot& dot) { return std::log(dot.radius_px / std::max(1.0, dot.face_px)); }

/// A track during tracking.
struct Followed {
  bool upper = false;
  std::vector<FacePosition> position;     // by frame, also where it was not found
  std::vector<int> dot_of;                // by frame
  double log_size = 0, log_contrast = 0;  // when last found
  int found = 0, tried = 0;
};

/// Motion along the finger that is common to the dots of one side, linear along it.
struct SideMotion {
  double at_zero_mm = 0, slope = 0, off = 0;

  [[nodiscard]] FacePosition operator()(const FacePosition& position) const {
    return {position.along_mm + at_zero_mm + slope * position.along_mm, position.off_face + off};
  }
};

class Follower {
 public:
  explicit Follower(const std::vector<FrameOfDots>& frames) : frames_(frames) {
    std::vector<EdgeCurves> curves;
    for (const FrameOfDots& frame : frames) curves.push_back(*frame.curves);
    if (const auto positions = choose_edge_positions(curves)) from_u_px_ = positions->from_u_px;
  }

  void follow(const Link& link) {
    const FrameOfDots& frame = frames_[link.frame];
    const FaceOfFrame face(*frame.curves, from_u_px_);
    for (const bool upper : {true, false}) follow_side(link, face, upper);
    std::erase_if(tracks_, [](const Followed& track) {
      return track.tried >= kTrialFrames && track.found < kMinHitRate * track.tried;
    });
  }

  [[nodiscard]] std::vector<Followed> take() { return std::move(tracks_); }

 private:
  struct Pair {
    double cost;
    std::size_t track;
    int dot;
  };

  [[nodiscard]] std::vector<Pair> pairs(const std::vector<std::size_t>& side,
                                        const std::vector<FacePosition>& expected,
                                        const std::vector<Dot>& dots, const FaceOfFrame& face,
                                        bool upper, double gate_mm) const {
    std::vector<Pair> all;
    for (std::size_t k = 0; k < side.size(); ++k) {
      const Followed& track = tracks_[side[k]];
      for (std::size_t d = 0; d < dots.size(); ++d) {
        if (dots[d].upper != upper) continue;
        const FacePosition at = face.position(dots[d]);
        const double away =
            std::hypot(at.along_mm - expected[k].along_mm,
                       kOffWeight * face.length_mm() * (at.off_face - expected[k].off_face));
        if (away > gate_mm) continue;
        const double unlike =
            std::abs(log_size(dots[d]) - track.log_size) +
            0.3 * std::abs(std::log(std::abs(dots[d].contrast)) - track.log_contrast);
        // Tracks with a high detection rate come first.
        const double miss_rate = 1.0 - static_cast<double>(track.found) / std::max(1, track.tried);
        all.push_back({(away + 0.05) * (1.0 + unlike + miss_rate), k, static_cast<int>(d)});
      }
    }
    std::sort(all.begin(), all.end(), [](const Pair& a, const Pair& b) {
      return std::tie(a.cost, a.track, a.dot) < std::tie(b.cost, b.track, b.dot);
    });
    std::vector<char> track_taken(side.size(), 0), dot_taken(dots.size(), 0);
    std::erase_if(all, [&](const Pair& pair) {
      auto &track = track_taken[pair.track], &dot = dot_taken[static_cast<std::size_t>(pair.dot)];
      if (track || dot) return true;
      track = dot = 1;
      return false;
    });
    return all;
  }

  /// Least squares over the pairs without outlying displacements.
  static SideMotion motion_of(const std::vector<Pair>& pairs,
                              const std::vector<FacePosition>& expected,
                              const std::vector<Dot>& dots, const FaceOfFrame& face) {
    SideMotion motion;
    if (pairs.empty()) return motion;
    std::vector<double> along, off;
    for (const Pair& pair : pairs) {
      const FacePosition at = face.position(dots[static_cast<std::size_t>(pair.dot)]);
      along.push_back(at.along_mm - expected[pair.track].along_mm);
      off.push_back(at.off_face - expected[pair.track].off_face);
    }
    std::vector<double> ordered = along;
    motion.at_zero_mm = upper_median(ordered);
    motion.off = upper_median(off);
    for (std::size_t i = 0; i < ordered.size(); ++i)
      ordered[i] = std::abs(along[i] - motion.at_zero_mm);
    const double most = 3.0 * upper_median(ordered) + 0.1;
    double n = 0, s = 0, ss = 0, d = 0, sd = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (std::abs(along[i] - motion.at_zero_mm) > most) continue;
      const double at = expected[pairs[i].track].along_mm;
      n += 1, s += at, ss += at * at, d += along[i], sd += at * along[i];
    }
    const double spread = ss - s * s / std::max(1.0, n);
    if (n < 3 || !(spread > 0.01 * n * face.length_mm() * face.length_mm())) return motion;
    motion.slope = (sd - d * s / n) / spread;
    motion.at_zero_mm = (d - motion.slope * s) / n;
    return motion;
  }

  void follow_side(const Link& link, const FaceOfFrame& face, bool upper) {
    const std::vector<Dot>& dots = *frames_[link.frame].dots;
    std::vector<std::size_t> side;
    std::vector<FacePosition> expected;
    for (std::size_t t = 0; t < tracks_.size(); ++t) {
      if (tracks_[t].upper != upper) continue;
      side.push_back(t);
      expected.push_back(tracks_[t].position[link.parent]);
    }
    const double length = face.length_mm();
    const SideMotion motion = motion_of(
        pairs(side, expected, dots, face, upper, kFirstGate * length), expected, dots, face);
    for (FacePosition& position : expected) position = motion(position);
    std::vector<char> is_known(dots.size(), 0);
    std::vector<int> dot_of(side.size(), -1);
    for (const Pair& pair : pairs(side, expected, dots, face, upper, kGate * length)) {
      dot_of[pair.track] = pair.dot;
      is_known[static_cast<std::size_t>(pair.dot)] = 1;
    }
    for (std::size_t k = 0; k < side.size(); ++k) {
      Followed& track = tracks_[side[k]];
      ++track.tried;
      track.position[link.frame] = expected[k];
      if (dot_of[k] < 0) continue;
      const Dot& dot = dots[static_cast<std::size_t>(dot_of[k])];
      ++track.found;
      track.dot_of[link.frame] = dot_of[k];
      track.position[link.frame] = face.position(dot);
      track.log_size = log_size(dot);
      track.log_contrast = std::log(std::abs(dot.contrast));
    }
    for (std::size_t d = 0; d < dots.size(); ++d)
      if (dots[d].upper == upper && !is_known[d]) begin(link.frame, static_cast<int>(d), face);
  }

  void begin(std::size_t frame, int d, const FaceOfFrame& face) {
    const Dot& dot = (*frames_[frame].dots)[static_cast<std::size_t>(d)];
    Followed track;
    track.upper = dot.upper;
    // Other branches start from frames processed before: there the dot is assumed at the same
    // position.
    track.position.assign(frames_.size(), face.position(dot));
    track.dot_of.assign(frames_.size(), -1);
    track.dot_of[frame] = d;
    track.log_size = log_size(dot);
    track.log_contrast = std::log(std::abs(dot.contrast));
    track.found = track.tried = 1;
    tracks_.push_back(std::move(track));
  }

  const std::vector<FrameOfDots>& frames_;
  double from_u_px_ = 0;
  std::vector<Followed> tracks_;
};

DotTrack summary_of(Followed&& followed, const std::vector<FrameOfDots>& frames) {
  std::vector<double> along, off, size, contrast;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (followed.dot_of[i] < 0) continue;
    const Dot& dot = (*frames[i].dots)[static_cast<std::size_t>(followed.dot_of[i])];
    along.push_back(followed.position[i].along_mm);
    off.push_back(followed.position[i].off_face);
    size.push_back(log_size(dot));
    contrast.push_back(std::log(std::abs(dot.contrast)));
  }
  DotTrack track;
  track.upper = followed.upper;
  track.support = static_cast<double>(along.size()) / static_cast<double>(frames.size());
  track.along_mm = upper_median(along);
  track.off_face = upper_median(off);
  track.log_size = upper_median(size);
  track.log_contrast = upper_median(contrast);
  track.dot_of = std::move(followed.dot_of);
  return track;
}

}  // namespace

std::vector<DotTrack> track_dots(const std::vector<FrameOfDots>& frames, double min_support) {
  std::vector<DotTrack> tracks;
  if (frames.empty()) return tracks;
  Follower follower(frames);
  for (const Link& link : tree_of(frames)) follower.follow(link);
  for (Followed& followed : follower.take()) {
    if (followed.found < min_support * static_cast<double>(frames.size())) continue;
    tracks.push_back(summary_of(std::move(followed), frames));
  }
  std::stable_sort(tracks.begin(), tracks.end(),
                   [](const DotTrack& a, const DotTrack& b) { return a.along_mm < b.along_mm; });
  return tracks;
}

namespace {

constexpr int kMaxMissing = 2;  // in a row
constexpr int kSlots = kMaxMissing + 1;
constexpr int kReach = 8;         // dots further apart in the order are no neighbours
constexpr double kGain = 4.0;     // of a dot that is in every frame
constexpr double kMissing = 2.5;  // cost of a missing dot
constexpr double kStepSd = 0.12;  // of a step's logarithm against the law
constexpr double kSizeSd = 0.3, kContrastSd = 0.6, kOffSd = 0.06;  // from one dot to the next
constexpr double kGrowthSd = 0.4;  // of a step against the one before
constexpr double kUnlikeSd = 0.2;  // of one side's growth against the other's
constexpr double kMinStepMm = 0.2;
constexpr double kNone = -std::numeric_limits<double>::infinity();

double square(double x) { return x * x; }

/// One row: its tracks by slot, counted from its first dot.
struct Row {
  std::vector<int> track_of;
  double worth = 0;
};

/// Rows of one side for one law.
class RowSearch {
 public:
  RowSearch(const std::vector<DotTrack>& tracks, const std::vector<int>& side, int per_row)
      : tracks_(tracks), side_(side), per_row_(per_row) {
    best_.resize(side.size() * kReach * kSlots * static_cast<std::size_t>(per_row));
  }

  /// growth: of the logarithm of the step, from one to the next.
  Row operator()(double growth) {
    std::fill(best_.begin(), best_.end(), State{});
    Row row = best_single();
    std::size_t end = best_.size();
    for (int j = 0; j < count(); ++j)
      for (int back = 1; back <= std::min(kReach, j); ++back)
        for (int slots = 1; slots <= kSlots; ++slots) {
          const double pair = pair_worth(j - back, j, slots);
          if (pair == kNone) continue;
          start(j, back, slots, pair);
          extend(j, back, slots, pair, growth);
          for (int slot = slots; slot < per_row_; ++slot) {
            const std::size_t at = index(j, back, slots, slot);
            if (best_[at].worth > row.worth) row.worth = best_[at].worth, end = at;
          }
        }
    if (end < best_.size()) row.track_of = trace(end);
    return row;
  }

 private:
  struct State {
    double worth = kNone;
    std::size_t before = SIZE_MAX;
  };

  [[nodiscard]] int count() const { return static_cast<int>(side_.size()); }
  [[nodiscard]] const DotTrack& track(int i) const {
    return tracks_[static_cast<std::size_t>(side_[static_cast<std::size_t>(i)])];
  }
  [[nodiscard]] std::size_t index(int j, int back, int slots, int slot) const {
    const auto pair = static_cast<std::size_t>((j * kReach + back - 1) * kSlots + slots - 1);
    return pair * static_cast<std::size_t>(per_row_) + static_cast<std::size_t>(slot);
  }

  [[nodiscard]] Row best_single() const {
    Row row;
    for (int i = 0; i < count(); ++i)
      if (kGain * track(i).support > row.worth)
        row = {{side_[static_cast<std::size_t>(i)]}, kGain * track(i).support};
    return row;
  }

  /// Score of the second dot of a pair, `slots` after the first.
  [[nodiscard]] double pair_worth(int i, int j, int slots) const {
    const DotTrack &a = track(i), &b = track(j);
    if (b.along_mm - a.along_mm < kMinStepMm) return kNone;
    const double unlike = square((b.log_size - a.log_size) / kSizeSd) +
                          square((b.log_contrast - a.log_contrast) / kContrastSd) +
                          square((b.off_face - a.off_face) / kOffSd);
    return kGain * b.support - kMissing * (slots - 1) - 0.5 * unlike / slots;
  }

  void start(int j, int back, int slots, double pair) {
    if (slots < per_row_)
      best_[index(j, back, slots, slots)].worth = kGain * track(j - back).support + pair;
  }

  void extend(int j, int back, int slots, double pair, double growth) {
    const int i = j - back;
    const double step = (track(j).along_mm - track(i).along_mm) / slots;
    for (int earlier = 1; earlier <= std::min(kReach, i); ++earlier)
      for (int skipped = 1; skipped <= kSlots; ++skipped) {
        const double before = (track(i).along_mm - track(i - earlier).along_mm) / skipped;
        if (before < kMinStepMm / kSlots) continue;
        const double off = std::log(step / before) - 0.5 * growth * (slots + skipped);
        const double added = pair - 0.5 * square(off / kStepSd);
        for (int slot = skipped; slot + slots < per_row_; ++slot) {
          const std::size_t from = index(i, earlier, skipped, slot);
          State& state = best_[index(j, back, slots, slot + slots)];
          if (best_[from].worth + added > state.worth) state = {best_[from].worth + added, from};
        }
      }
  }

  [[nodiscard]] std::vector<int> trace(std::size_t at) const {
    const auto rows = static_cast<std::size_t>(per_row_);
    std::vector<int> track_of(at % rows + 1, -1);
    for (;;) {
      const std::size_t slot = at % rows, pair = at / rows;
      const auto slots = pair % kSlots + 1, back = pair / kSlots % kReach + 1;
      const std::size_t j = pair / kSlots / kReach;
      track_of[slot] = side_[j];
      if (best_[at].before == SIZE_MAX) {
        track_of[slot - slots] = side_[j - back];
        return track_of;
      }
      at = best_[at].before;
    }
  }

  const std::vector<DotTrack>& tracks_;
  const std::vector<int>& side_;
  int per_row_;
  std::vector<State> best_;
};

constexpr double kLawStep = 0.04;
constexpr int kLaws = 12;  // to each side of the even one

double growth_of(int law) { return kLawStep * (law - kLaws); }

/// The best row of one side for each law.
std::vector<Row> rows_by_law(const std::vector<DotTrack>& tracks, bool upper, int per_row) {
  std::vector<int> side;
  for (std::size_t t = 0; t < tracks.size(); ++t)
    if (tracks[t].upper == upper) side.push_back(static_cast<int>(t));
  std::vector<Row> rows(2 * kLaws + 1);
  if (side.empty()) return rows;
  RowSearch search(tracks, side, per_row);
  for (int law = 0; law <= 2 * kLaws; ++law) {
    Row& row = rows[static_cast<std::size_t>(law)];
    row = search(growth_of(law));
    row.worth -= 0.5 * square(growth_of(law) / kGrowthSd);
  }
  return rows;
}

/// The best rows of both sides under nearly the same law. Where one side has so many missing dots
/// that several laws fit, the other side decides. Of equals the law nearest to the even one wins.
std::pair<Row, Row> best_rows(const std::vector<DotTrack>& tracks, int per_row) {
  auto upper = rows_by_law(tracks, true, per_row), lower = rows_by_law(tracks, false, per_row);
  std::pair<std::size_t, std::size_t> best(kLaws, kLaws);
  double most = kNone;
  const auto by_law = [](int n) {  // from the even law outwards
    return kLaws + (n % 2 == 0 ? -n / 2 : (n + 1) / 2);
  };
  for (int n = 0; n <= 2 * kLaws; ++n)
    for (int m = 0; m <= 2 * kLaws; ++m) {
      const auto a = static_cast<std::size_t>(by_law(n)), b = static_cast<std::size_t>(by_law(m));
      const double unlike = (growth_of(by_law(n)) - growth_of(by_law(m))) / kUnlikeSd;
      const double worth = upper[a].worth + lower[b].worth - 0.5 * square(unlike);
      if (worth > most) most = worth, best = {a, b};
    }
  return {std::move(upper[best.first]), std::move(lower[best.second])};
}

/// Score of the alignment of both rows when they begin at these numbers.
double symmetry(const std::vector<DotTrack>& tracks, const Row& upper, int first_upper,
                const Row& lower, int first_lower) {
  const auto& a = upper.track_of;
  const auto& b = lower.track_of;
  const auto along = [&](int track) { return tracks[static_cast<std::size_t>(track)].along_mm; };
  const double length = std::abs(along(a.back()) - along(a.front()));
  const double spacing = a.size() > 1 ? length / (static_cast<double>(a.size()) - 1.0) : 1.0;
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int other = static_cast<int>(i) + first_upper - first_lower;
    if (other < 0 || other >= static_cast<int>(b.size()) || a[i] < 0) continue;
    const int track = b[static_cast<std::size_t>(other)];
    // Rows of different steps never align: the number of bad pairs is meaningless there.
    if (track >= 0)
      sum += std::max(0.0, 0.3 - std::abs(along(a[i]) - along(track)) / std::max(spacing, 1e-3));
  }
  return sum;
}

}  // namespace

NumberedRows choose_rows(const std::vector<DotTrack>& tracks, int per_row) {
  NumberedRows rows;
  rows.track_of.assign(2 * static_cast<std::size_t>(per_row), -1);
  const auto [upper, lower] = best_rows(tracks, per_row);
  int first_upper = 0, first_lower = 0;
  if (!upper.track_of.empty() && !lower.track_of.empty()) {
    double best = kNone;
    for (int a = 0; a + static_cast<int>(upper.track_of.size()) <= per_row; ++a)
      for (int b = 0; b + static_cast<int>(lower.track_of.size()) <= per_row; ++b) {
        const double worth = symmetry(tracks, upper, a, lower, b) - 1e-6 * (a + b);
        if (worth > best) best = worth, first_upper = a, first_lower = b;
      }
  }
  const auto number = [&](const Row& row, int first) {
    for (std::size_t slot = 0; slot < row.track_of.size(); ++slot)
      rows.track_of[slot + static_cast<std::size_t>(first)] = row.track_of[slot];
  };
  number(upper, first_upper);
  number(lower, per_row + first_lower);
  rows.worth = upper.worth + lower.worth;
  return rows;
}

}  // namespace alltact
