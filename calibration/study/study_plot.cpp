#include "calibration/study/study_plot.h"

#include "calibration/study/recommended_settings.h"
#include "core/numerics/readable_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kWidth = 900;
constexpr double kLeft = 80, kRight = 870, kTop = 64, kBottom = 404;  // of the axes
constexpr double kLine = 20;
constexpr std::size_t kMaxNames = 7;
constexpr double kAroundFront = 1.6;  // times the slowest row on the front
// distance between named dots; nearer ones get no name of their own
constexpr double kMinGapPx = 20;
constexpr std::size_t kNameLineLength = 118;  // characters that fit below the plot
constexpr const char* kFrontColour = "#1f6fb2";
constexpr const char* kRealColour = "#c2571a";
constexpr const char* kBeatenColour = "#b8b8b8";

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else
      safe += c;
  }
  return safe;
}

/// Words on lines of at most kNameLineLength characters.
std::vector<std::string> wrapped(const std::string& words) {
  std::vector<std::string> lines;
  std::string rest = words;
  while (rest.size() > kNameLineLength) {
    std::size_t cut = rest.rfind(' ', kNameLineLength);
    if (cut == std::string::npos || cut == 0) cut = kNameLineLength;
    lines.push_back(rest.substr(0, cut));
    rest = rest.substr(rest[cut] == ' ' ? cut + 1 : cut);
  }
  lines.push_back(rest);
  return lines;
}

class DrawnPlot {
 public:
  explicit DrawnPlot(const StudyPlot& plot) : plot_(plot) {
    // Dots far outside the front and the base would compress the rest into a corner.
    double farthest = 0, highest = 0;
    const bool any = std::any_of(plot.dots.begin(), plot.dots.end(),
                                 [](const PlotDot& dot) { return dot.is_on_front || dot.is_base; });
    for (const PlotDot& dot : plot.dots) {
      if (any && !dot.is_on_front && !dot.is_base) continue;
      farthest = std::max(farthest, dot.x);
      highest = std::max({highest, dot.y, dot.y95.value_or(0), dot.real95.value_or(0)});
    }
    most_x_ = std::max((any ? kAroundFront : 1.1) * farthest, 1e-6);
    most_y_ = std::max(1.1 * highest, 1e-6);
    choose_names();
  }

  [[nodiscard]] std::string svg() {
    write(kLeft, 26, "start", 17, plot_.title);
    write(kLeft, 46, "start", 13, plot_.subtitle);
    axes();
    budget();
    beaten();
    if (plot_.has_staircase) staircase();
    named();
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" "
               "viewBox=\"0 0 {0} {1:.0f}\" font-family=\"DejaVu Sans, sans-serif\" "
               "font-size=\"13\">\n<rect width=\"{0}\" height=\"{1:.0f}\" fill=\"white\"/>\n",
               kWidth, next_y_ + 4) +
           text_ + "</svg>\n";
  }

 private:
  [[nodiscard]] double x(double value) const { return kLeft + (kRight - kLeft) * value / most_x_; }
  [[nodiscard]] double y(double value) const {
    return kBottom - (kBottom - kTop) * value / most_y_;
  }
  [[nodiscard]] bool is_inside(const PlotDot& dot) const {
    return dot.x <= most_x_ && dot.y <= most_y_;
  }

  void write(double at_x, double at_y, const char* anchor, int size, const std::string& words) {
    text_ += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\">{}</text>\n", at_x,
        at_y, anchor, size, escaped(words));
  }
  void line(double x1, double y1, double x2, double y2, const std::string& how) {
    text_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1,
                         y1, x2, y2, how);
  }
  /// A whisker ends within the axes; a cap marks a true end.
  void whisker(double at_x, double from, double to, const char* colour) {
    const double end = std::min(to, most_y_);
    const std::string how = fmt::format("stroke=\"{}\"", colour);
    line(at_x, y(from), at_x, y(end), how);
    if (to <= most_y_) line(at_x - 4, y(end), at_x + 4, y(end), how);
  }

  void axes() {
    const double step_x = round_step(most_x_ / 8), step_y = round_step(most_y_ / 6);
    for (double at = 0; at <= most_x_; at += step_x) {
      line(x(at), kTop, x(at), kBottom, "stroke=\"#e4e4e4\"");
      write(x(at), kBottom + 18, "middle", 13, fmt::format("{:g}", at));
    }
    for (double at = 0; at <= most_y_; at += step_y) {
      line(kLeft, y(at), kRight, y(at), "stroke=\"#e4e4e4\"");
      write(kLeft - 8, y(at) + 4, "end", 13, fmt::format("{:g}", at));
    }
    line(kLeft, kBottom, kRight, kBottom, "stroke=\"black\"");
    line(kLeft, kTop, kLeft, kBottom, "stroke=\"black\"");
    write((kLeft + kRight) / 2, kBottom + 40, "middle", 14, plot_.x_label);
    text_ += fmt::format(
        "<text transform=\"translate(24 {:.1f}) rotate(-90)\" text-anchor=\"middle\" "
        "font-size=\"14\">{}</text>\n",
        (kTop + kBottom) / 2, escaped(plot_.y_label));
  }

  void budget() {
    if (!plot_.budget) return;
    if (*plot_.budget > most_x_) {
      write(kRight, kTop - 18, "end", 13, plot_.budget_words + " \u2192");
      return;
    }
    line(x(*plot_.budget), kTop, x(*plot_.budget), kBottom,
         "stroke=\"#b03030\" stroke-dasharray=\"6 4\"");
    write(std::min(x(*plot_.budget), kRight), kTop - 6, "end", 13, plot_.budget_words);
  }

  void beaten() {
    int beyond = 0;
    for (std::size_t i = 0; i < plot_.dots.size(); ++i) {
      const PlotDot& dot = plot_.dots[i];
      if (is_named(i)) continue;
      if (!is_inside(dot)) {
        ++beyond;
        continue;
      }
      text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", x(dot.x),
                           y(dot.y), dot.is_on_front ? kFrontColour : kBeatenColour);
    }
    if (beyond > 0)
      write(kRight, kBottom + 40, "end", 13,
            fmt::format("{} slower or worse, beyond this figure", beyond));
  }

  void staircase() {
    std::vector<const PlotDot*> front;
    for (const PlotDot& dot : plot_.dots)
      if (dot.is_on_front && is_inside(dot)) front.push_back(&dot);
    std::sort(front.begin(), front.end(), [](const auto* a, const auto* b) {
      return a->x != b->x ? a->x < b->x : a->y < b->y;
    });
    std::string path;
    double least = most_y_;
    for (const PlotDot* dot : front) {
      if (dot->y >= least) continue;  // on the front for another figure
      if (!path.empty()) path += fmt::format("{:.1f},{:.1f} ", x(dot->x), y(least));
      path += fmt::format("{:.1f},{:.1f} ", x(dot->x), y(dot->y));
      least = dot->y;
    }
    if (path.empty()) return;
    path += fmt::format("{:.1f},{:.1f}", kRight, y(least));
    text_ +=
        fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n",
                    path, kFrontColour);
  }

  void named() {
    next_y_ = kBottom + 70;
    for (std::size_t number = 0; number < named_.size(); ++number) {
      const PlotDot& dot = plot_.dots[named_[number]];
      const double at_x = x(dot.x);
      const char* colour = dot.is_on_front ? kFrontColour : kBeatenColour;
      if (dot.y95) whisker(at_x, dot.y, *dot.y95, colour);
      if (dot.real && *dot.real <= most_y_) {
        if (dot.real95) whisker(at_x + 6, *dot.real, *dot.real95, kRealColour);
        text_ += fmt::format(
            "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" height=\"8\" fill=\"white\" "
            "stroke=\"{}\" stroke-width=\"2\"/>\n",
            at_x + 2, y(*dot.real) - 4, kRealColour);
      }
      text_ +=
          fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"{}\"{}/>\n", at_x,
                      y(dot.y), colour, dot.is_base ? " stroke=\"black\" stroke-width=\"2\"" : "");
      write(at_x - 9, y(dot.y) - 8, "end", 13, fmt::format("{}", number + 1));
      bool is_first = true;
      for (const std::string& words : wrapped(dot.words)) {
        if (is_first) write(kLeft, next_y_, "end", 13, fmt::format("{}", number + 1));
        write(kLeft + 10, next_y_, "start", 13, words);
        is_first = false;
        next_y_ += kLine;
      }
    }
    legend();
  }

  void legend() {
    const double at_y = next_y_ + 4;
    text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"{}\"/>\n", kLeft + 10,
                         at_y - 4, kFrontColour);
    write(kLeft + 22, at_y, "start", 12, "median, whisker to 95 %");
    text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", kLeft + 210,
                         at_y - 4, kBeatenColour);
    write(kLeft + 220, at_y, "start", 12, "something else is better");
    text_ += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"white\" stroke=\"black\" "
        "stroke-width=\"2\"/>\n",
        kLeft + 400, at_y - 4);
    write(kLeft + 412, at_y, "start", 12, "in use now");
    if (!plot_.real_label.empty()) {
      text_ += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" height=\"8\" fill=\"white\" stroke=\"{}\" "
          "stroke-width=\"2\"/>\n",
          kLeft + 500, at_y - 9, kRealColour);
      write(kLeft + 514, at_y, "start", 12, plot_.real_label);
    }
    next_y_ = at_y + 8;
  }

  [[nodiscard]] bool is_named(std::size_t dot) const {
    return std::find(named_.begin(), named_.end(), dot) != named_.end();
  }

  // First the base, then dots that stand apart, so that numbers do not overlap.
  void choose_names() {
    const auto add = [&](std::size_t i) {
      const PlotDot& dot = plot_.dots[i];
      if (named_.size() >= kMaxNames || is_named(i) || !is_inside(dot)) return;
      const bool is_apart = std::all_of(named_.begin(), named_.end(), [&](std::size_t other) {
        const PlotDot& there = plot_.dots[other];
        return std::hypot(x(dot.x) - x(there.x), y(dot.y) - y(there.y)) > kMinGapPx;
      });
      if (is_apart) named_.push_back(i);
    };
    for (std::size_t i = 0; i < plot_.dots.size(); ++i)
      if (plot_.dots[i].is_base) add(i);
    for (const std::size_t i : plot_.named) add(i);
    std::sort(named_.begin(), named_.end(),
              [&](std::size_t a, std::size_t b) { return plot_.dots[a].x < plot_.dots[b].x; });
  }

  const StudyPlot& plot_;
  std::vector<std::size_t> named_;
  double most_x_ = 1, most_y_ = 1, next_y_ = kBottom + 70;
  std::string text_;
};

}  // namespace

std::string svg_of(const StudyPlot& plot) { return DrawnPlot(plot).svg(); }

namespace {

constexpr double kBudgetMs = 1000.0 / 30;

PlotDot dot_of(const AccuracyStudy& study, const StudyRow& row) {
  PlotDot dot;
  dot.x = frame_ms(study, row);
  dot.y = 1000 * row.depth->median_mm;
  dot.y95 = 1000 * row.depth->p95_mm;
  dot.words = fmt::format("{:.2f} ms, {:.1f} \u00b5m (95 % within {:.1f})", dot.x, dot.y, *dot.y95);
  if (row.position_mm) dot.words += fmt::format(", place {:.0f} \u00b5m", 1000 * *row.position_mm);
  if (row.real) {
    dot.real = 1000 * row.real->depth.median_mm;
    dot.real95 = 1000 * row.real->depth.p95_mm;
    dot.words += fmt::format(", real {:.1f} \u00b5m", *dot.real);
  }
  dot.words += ": " + words_of(row.settings, study.rows.front().settings).english();
  return dot;
}

}  // namespace

std::string svg_of(const AccuracyStudy& study) {
  StudyPlot plot;
  plot.title = "Error versus time per image";
  plot.subtitle =
      study.about.english() + (study.simulated ? " (simulated truth)" : " (painted truth)");
  plot.x_label = "time of a frame on this computer, ms";
  plot.y_label = "error of depth, micrometres";
  plot.budget = kBudgetMs;
  plot.budget_words = "30 pictures per second: 33.3 ms";
  if (study.rows.front().real) plot.real_label = "real: presses left out";
  const auto front = pareto_front(study);
  std::vector<std::size_t> dot_of_row(study.rows.size(), study.rows.size());
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    if (!study.rows[i].depth) continue;
    PlotDot dot = dot_of(study, study.rows[i]);
    dot.is_base = i == 0;
    dot.is_on_front = std::find(front.begin(), front.end(), i) != front.end();
    dot_of_row[i] = plot.dots.size();
    plot.dots.push_back(std::move(dot));
  }
  // First the choices with a preset name, then the rest of the front from its accurate end.
  const StudyPresets presets = presets_of(study);
  for (const auto& preset : {presets.fast, presets.finest})
    if (preset) plot.named.push_back(dot_of_row[*preset]);
  for (auto at = front.rbegin(); at != front.rend(); ++at) plot.named.push_back(dot_of_row[*at]);
  return svg_of(plot);
}

std::string svg_of(const CalibratingStudy& study) {
  StudyPlot plot;
  plot.title = "What a calibration costs and brings";
  plot.subtitle = study.about.english() + " (painted truth; minutes of hand are an estimate)";
  plot.x_label = "minutes of the technician and of this computer";
  plot.y_label = "error of depth, micrometres";
  if (study.no_real_reason.empty()) plot.real_label = "real: presses left out";
  const auto front = calibrating_front(study);
  std::vector<std::size_t> dot_of_row(study.rows.size(), study.rows.size());
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const CalibratingRow& row = study.rows[i];
    if (!row.painted) continue;
    PlotDot dot;
    dot.x = total_minutes(row);
    dot.y = 1000 * row.painted->median_mm;
    dot.y95 = 1000 * row.painted->p95_mm;
    dot.words = fmt::format("{:.1f} min, {:.1f} s computing, {:.1f} \u00b5m (95 % within {:.1f})",
                            dot.x, row.computing_s, dot.y, *dot.y95);
    if (row.real) {
      dot.real = 1000 * row.real->depth.median_mm;
      dot.real95 = 1000 * row.real->depth.p95_mm;
      dot.words += fmt::format(", real {:.1f} \u00b5m", *dot.real);
    }
    dot.words += ": " + words_of(row.choice).english();
    dot.is_base = i == 0;
    dot.is_on_front = std::find(front.begin(), front.end(), i) != front.end();
    dot_of_row[i] = plot.dots.size();
    plot.dots.push_back(std::move(dot));
  }
  for (auto at = front.rbegin(); at != front.rend(); ++at) plot.named.push_back(dot_of_row[*at]);
  return svg_of(plot);
}

}  // namespace alltact
