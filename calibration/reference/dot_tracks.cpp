#include "calibration/reference/dot_tracks.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
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
class Face {
 public:
  Face(const EdgeCurves& curves, double from_u_px)
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

double log_size(const Dot& dot) {
  return std::log(dot.radius_px / std::max(1.0, dot.face_px));
}

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
    const Face face(*frame.curves, from_u_px_);
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
                                        const std::vector<Dot>& dots,
                                        const Face& face,
                                        bool upper,
                                        double gate_mm) const {
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
                              const std::vector<Dot>& dots,
                              const Face& face) {
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

  void follow_side(const Link& link, const Face& face, bool upper) {
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

  void begin(std::size_t frame, int d, const Face& face) {
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
  std::stable_sort(tracks.begin(), tracks.end(), [](const DotTrack& a, const DotTrack& b) {
    return a.along_mm < b.along_mm;
  });
  return tracks;
}

}  // namespace alltact
