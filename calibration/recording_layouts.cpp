#include "calibration/recording_layouts.h"

#include "core/numerics/median.h"
#include "core/sensing/marker_rows.h"

#include <limits>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kMostResidualPx = 3.0;

const std::vector<Dot>& dots_of(const FrameDots& frame, Polarity polarity) {
  return polarity == Polarity::kBright ? frame.bright : frame.dark;
}

// A frame whose two rows are plain, its dots by number.
struct Plain {
  std::size_t frame;
  std::vector<Dot> dots;
  double unevenness;
};

std::vector<Plain> plain_frames(const std::vector<FrameDots>& frames,
                                Polarity polarity,
                                int per_row) {
  std::vector<Plain> plain;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto& dots = dots_of(frames[i], polarity);
    const auto upper = choose_row(dots, true, per_row, frames[i].base_at_low_u);
    const auto lower = choose_row(dots, false, per_row, frames[i].base_at_low_u);
    if (!upper || !lower) continue;
    const double unevenness = std::max(upper->unevenness, lower->unevenness);
    if (unevenness > kMaxUnevenness) continue;
    Plain frame{i, {}, unevenness};
    for (const auto& row : {*upper, *lower})
      for (const int d : row.dots) frame.dots.push_back(dots[static_cast<std::size_t>(d)]);
    plain.push_back(std::move(frame));
  }
  return plain;
}

std::vector<Dot> typical_of(const std::vector<Plain>& plain) {
  std::vector<Dot> typical(plain.front().dots.size());
  for (std::size_t m = 0; m < typical.size(); ++m) {
    const auto middle_of = [&](auto member) {
      std::vector<double> values;
      for (const Plain& frame : plain) values.push_back(frame.dots[m].*member);
      return upper_median(values);
    };
    typical[m] = {middle_of(&Dot::u),
                  middle_of(&Dot::v),
                  middle_of(&Dot::radius_px),
                  middle_of(&Dot::contrast),
                  middle_of(&Dot::sd_px),
                  2 * m < typical.size()};
  }
  return typical;
}

// Frames whose dots have the size and contrast that the others give them; in a wrongly chosen row
// at least one dot is another one, or none.
void keep_consistent(std::vector<Plain>& plain) {
  const auto typical = typical_of(plain);
  std::erase_if(plain, [&](const Plain& frame) {
    for (std::size_t m = 0; m < typical.size(); ++m) {
      const double size = frame.dots[m].radius_px / typical[m].radius_px;
      const double contrast = frame.dots[m].contrast / typical[m].contrast;
      if (size < 0.6 || size > 1.7 || contrast < 0.4 || contrast > 2.5) return true;
    }
    return false;
  });
}

Result<MarkerModel> learn(const std::vector<Plain>& plain) {
  const auto count = static_cast<Eigen::Index>(plain.front().dots.size());
  Eigen::MatrixXd layouts(static_cast<Eigen::Index>(plain.size()), 2 * count);
  for (std::size_t i = 0; i < plain.size(); ++i)
    for (Eigen::Index m = 0; m < count; ++m) {
      const Dot& dot = plain[i].dots[static_cast<std::size_t>(m)];
      layouts.row(static_cast<Eigen::Index>(i)).segment<2>(2 * m) << dot.u, dot.v;
    }
  return MarkerModel::learn(layouts, typical_of(plain));
}

// Why no layout could be had: what a frame shows at the median, and what to do about it.
Error no_layout(const std::vector<FrameDots>& frames, Polarity polarity, int per_row) {
  std::vector<double> upper, lower;
  for (const FrameDots& frame : frames) {
    if (!frame.problem.empty()) continue;
    const auto& dots = dots_of(frame, polarity);
    const auto above =
        std::count_if(dots.begin(), dots.end(), [](const Dot& d) { return d.upper; });
    upper.push_back(static_cast<double>(above));
    lower.push_back(static_cast<double>(dots.size()) - static_cast<double>(above));
  }
  if (upper.empty())
    return {frames.front().problem.empty() ? "no frame shows the face"
                                           : "no frame shows the face: " + frames.front().problem,
            "recording",
            "a recording in which both long edges of the bright face are visible"};
  const double above = upper_median(upper), below = upper_median(lower);
  const char* side = above < per_row && below < per_row ? "on both sides"
                     : above < per_row                  ? "on the upper side"
                     : below < per_row                  ? "on the lower side"
                                                        : "that lie evenly";
  return {fmt::format(
              "the markers were never all seen: a frame shows {} dots on the upper and {} on the "
              "lower side face (median of {} frames), {} are needed in each row, so dots are "
              "missing {}",
              above,
              below,
              upper.size(),
              per_row,
              side),
          "recording",
          "check markers.per_row, light both side faces so that the dots stand out from them, "
          "focus, and keep "
          "every dot inside the picture and uncovered in at least two different poses"};
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
      out.problems[i] = fmt::format("{} dots were found but they fit no pose of the {} markers",
                                    dots.size(),
                                    model.marker_count());
    } else if (2 * seen_count(*markers) < model.marker_count()) {
      out.problems[i] =
          fmt::format("only {} of {} markers found", seen_count(*markers), model.marker_count());
    } else if (const double residual = model.residual_px(*markers); residual > kMostResidualPx) {
      out.problems[i] = fmt::format("the markers lie {:.1f} px from where they can be", residual);
    } else {
      out.markers[i] = std::move(markers);
    }
  }
}

// The frames in which every marker was seen, as layouts of a second, wider lesson.
Result<MarkerModel> learn_again(const NumberedRecording& numbered) {
  const auto count = static_cast<Eigen::Index>(numbered.typical.size());
  Eigen::MatrixXd layouts(static_cast<Eigen::Index>(numbered.markers.size()), 2 * count);
  Eigen::Index n = 0;
  for (const auto& markers : numbered.markers) {
    if (!markers || seen_count(*markers) < count) continue;
    for (Eigen::Index m = 0; m < count; ++m) {
      const Marker& marker = (*markers)[static_cast<std::size_t>(m)];
      layouts.row(n).segment<2>(2 * m) << marker.u, marker.v;
    }
    ++n;
  }
  layouts.conservativeResize(n, Eigen::NoChange);
  return MarkerModel::learn(layouts, numbered.typical);
}

}  // namespace

Result<NumberedRecording> number_recording(const std::vector<FrameDots>& frames,
                                           const MarkerRows& rows) {
  NumberedRecording out;
  std::vector<Plain> plain;
  double best = -1;
  for (const Polarity polarity : {Polarity::kBright, Polarity::kDark}) {
    if (rows.polarity != Polarity::kAuto && rows.polarity != polarity) continue;
    auto candidates = plain_frames(frames, polarity, rows.per_row);
    double evenness = 0;
    for (const Plain& frame : candidates) evenness += 1 - frame.unevenness / kMaxUnevenness;
    if (evenness <= best) continue;
    best = evenness;
    out.polarity = polarity;
    plain = std::move(candidates);
  }
  if (!plain.empty()) keep_consistent(plain);
  if (plain.size() < 2) return no_layout(frames, out.polarity, rows.per_row);
  out.typical = typical_of(plain);
  auto model = learn(plain);
  if (!model) return model.error();
  number_all(frames, *model, out);
  if (auto wider = learn_again(out)) {
    model = std::move(wider);
    number_all(frames, *model, out);
  }
  out.marker_noise_px = model->noise_px();
  return out;
}

}  // namespace alltact
