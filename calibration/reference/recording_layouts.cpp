#include "calibration/reference/recording_layouts.h"

#include "calibration/reference/dot_tracks.h"
#include "calibration/reference/missing_markers.h"
#include "calibration/reference/row_law.h"
#include "core/numerics/median.h"

#include <limits>

namespace alltact {
namespace {

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

Rows find_rows(const std::vector<FrameDots>& frames,
               const std::vector<std::size_t>& followed,
               Polarity polarity,
               int per_row) {
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

bool is_seen(const Dot& dot) {
  return dot.contrast != 0;
}

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
    typical[m] = {middle_of(&Dot::u, first, last),
                  middle_of(&Dot::v, first, last),
                  middle_of(&Dot::radius_px, first, last),
                  middle_of(&Dot::contrast, first, last),
                  middle_of(&Dot::sd_px, first, last),
                  2 * m < typical.size()};
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
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Eigen::MatrixXd layouts = Eigen::MatrixXd::Constant(
      static_cast<Eigen::Index>(rows.seen.size()), static_cast<Eigen::Index>(2 * count), kNaN);
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
      "no two rows of up to {} that keep their places on the finger",
      above,
      below,
      upper.size(),
      per_row);
}

int seen_count(const Markers& markers) {
  return static_cast<int>(
      std::count_if(markers.begin(), markers.end(), [](const Marker& m) { return m.seen; }));
}

void number_all(const std::vector<FrameDots>& frames,
                const MarkerModel& model,
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
                                dots.size(),
                                model.present_count());
    } else if (2 * seen_count(*markers) < model.present_count()) {
      out.problems[i] =
          en::say("only {} of {} markers found", seen_count(*markers), model.present_count());
    } else if (const double residual = model.residual_px(*markers); residual > kMaxResidualPx) {
      out.problems[i] = en::say("the markers lie {:.1f} px from where they can be", residual);
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
bool number_by_dots(const std::vector<FrameDots>& frames,
                    const MarkerRows& requested,
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
    out.no_markers = en::say("of {} markers none may be hidden", present);
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
  const auto numbered = std::count_if(
      out.markers.begin(), out.markers.end(), [](const auto& m) { return m.has_value(); });
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
      out.problems[i] = en::say("too little of the face is seen to tell the pose by its shape");
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

}  // namespace alltact
