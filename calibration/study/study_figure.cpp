#include "calibration/study/study_figure.h"

#include "calibration/study/study_front.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kWidth = 900, kHeight = 620;
constexpr double kLeft = 80, kRight = 870, kTop = 60, kBottom = 400;  // of the axes
constexpr double kBudgetMs = 1000.0 / 30;
constexpr std::size_t kMostNames = 7;
constexpr double kAroundFront = 1.6;  // times the slowest that is worth taking
constexpr double kApartPx = 14;  // dots that are named; nearer ones are told by their neighbour

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

/// A round number of which about `count` make up `range`.
double step_for(double range, int count) {
  const double rough = range / count;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * decade >= rough) return step * decade;
  return 10 * decade;
}

class Figure {
 public:
  explicit Figure(const AccuracyStudy& study) : study_(study), front_(pareto_front(study)) {
    // What is far slower or worse than what is worth taking would squeeze that into a corner.
    double slowest_ms = 0, worst_um = 0;
    for (const std::size_t row : front_) {
      slowest_ms = std::max(slowest_ms, ms_of(row));
      worst_um = std::max(worst_um, 1000 * study.rows[row].depth->p95_mm);
    }
    if (study.rows.front().depth) {
      slowest_ms = std::max(slowest_ms, ms_of(0));
      worst_um = std::max(worst_um, 1000 * study.rows.front().depth->p95_mm);
    }
    most_ms_ = std::max(kAroundFront * slowest_ms, 1e-3);
    most_um_ = std::max(1.1 * worst_um, 1e-3);
    named_ = named_rows();
  }

  [[nodiscard]] std::string svg() {
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"{0}\" height=\"{1}\" "
        "fill=\"white\"/>\n",
        kWidth,
        kHeight);
    write(kLeft, 26, "start", 17, "What accuracy costs in time");
    write(kLeft,
          46,
          "start",
          13,
          study_.about.english() + (study_.simulated ? " (simulated truth)" : " (painted truth)"));
    axes();
    dots();
    staircase();
    names();
    return text_ + "</svg>\n";
  }

 private:
  [[nodiscard]] double x(double ms) const { return kLeft + (kRight - kLeft) * ms / most_ms_; }
  [[nodiscard]] double y(double um) const { return kBottom - (kBottom - kTop) * um / most_um_; }

  void write(double at_x, double at_y, const char* anchor, int size, const std::string& words) {
    text_ += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\">{}</text>\n",
        at_x,
        at_y,
        anchor,
        size,
        escaped(words));
  }
  void line(double x1, double y1, double x2, double y2, const char* how) {
    text_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n",
                         x1,
                         y1,
                         x2,
                         y2,
                         how);
  }

  void axes() {
    const double step_ms = step_for(most_ms_, 8), step_um = step_for(most_um_, 6);
    for (double ms = 0; ms <= most_ms_; ms += step_ms) {
      line(x(ms), kTop, x(ms), kBottom, "stroke=\"#e4e4e4\"");
      write(x(ms), kBottom + 18, "middle", 13, fmt::format("{:g}", ms));
    }
    for (double um = 0; um <= most_um_; um += step_um) {
      line(kLeft, y(um), kRight, y(um), "stroke=\"#e4e4e4\"");
      write(kLeft - 8, y(um) + 4, "end", 13, fmt::format("{:g}", um));
    }
    line(kLeft, kBottom, kRight, kBottom, "stroke=\"black\"");
    line(kLeft, kTop, kLeft, kBottom, "stroke=\"black\"");
    write((kLeft + kRight) / 2, kBottom + 40, "middle", 14, "time of a frame on this computer, ms");
    const double middle = (kTop + kBottom) / 2;
    text_ += fmt::format(
        "<text transform=\"translate(24 {:.1f}) rotate(-90)\" text-anchor=\"middle\" "
        "font-size=\"14\">error of depth, micrometres</text>\n",
        middle);
    if (kBudgetMs > most_ms_) {
      write(kRight - 4, kTop + 14, "end", 13, "30 pictures per second: 33.3 ms \u2192");
      return;
    }
    line(x(kBudgetMs), kTop, x(kBudgetMs), kBottom, "stroke=\"#b03030\" stroke-dasharray=\"6 4\"");
    write(x(kBudgetMs) - 6, kTop + 14, "end", 13, "30 pictures per second");
  }

  void dots() {
    int beyond = 0;
    for (std::size_t i = 0; i < study_.rows.size(); ++i) {
      const StudyRow& row = study_.rows[i];
      if (!row.depth || is_named(i)) continue;
      const double um = 1000 * row.depth->median_mm;
      if (ms_of(i) > most_ms_ || um > most_um_) {
        ++beyond;
        continue;
      }
      text_ += fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"#b8b8b8\"/>\n", x(ms_of(i)), y(um));
    }
    if (beyond > 0)
      write(kRight - 4,
            kTop + 32,
            "end",
            13,
            fmt::format("{} slower or worse, beyond this figure", beyond));
  }

  void staircase() {
    std::string way;
    double last = 0;
    for (const std::size_t i : front_) {
      const StudyRow& row = study_.rows[i];
      const double at_x = x(frame_ms(study_, row)), at_y = y(1000 * row.depth->median_mm);
      if (!way.empty()) way += fmt::format("{:.1f},{:.1f} ", at_x, last);
      way += fmt::format("{:.1f},{:.1f} ", at_x, at_y);
      last = at_y;
    }
    if (!front_.empty()) way += fmt::format("{:.1f},{:.1f}", kRight, last);
    text_ += fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"#1f6fb2\" stroke-width=\"1.5\"/>\n", way);
  }

  void names() {
    double at_y = kBottom + 68;
    for (std::size_t number = 0; number < named_.size(); ++number) {
      const StudyRow& row = study_.rows[named_[number]];
      const double ms = ms_of(named_[number]), um = um_of(named_[number]);
      line(x(ms), y(um), x(ms), y(1000 * row.depth->p95_mm), "stroke=\"#1f6fb2\"");
      text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"#1f6fb2\"{}/>\n",
                           x(ms),
                           y(um),
                           5,
                           named_[number] == 0 ? " stroke=\"black\" stroke-width=\"2\"" : "");
      write(x(ms) + 8, y(um) - 6, "start", 12, fmt::format("{}", number + 1));
      write(kLeft,
            at_y,
            "start",
            13,
            fmt::format("{}  {:.2f} ms, {:.1f} \u00b5m (95 % within {:.1f}): {}",
                        number + 1,
                        ms,
                        um,
                        1000 * row.depth->p95_mm,
                        words_of(row.settings, study_.rows.front().settings).english()));
      at_y += 20;
    }
  }

  [[nodiscard]] bool is_named(std::size_t row) const {
    return std::find(named_.begin(), named_.end(), row) != named_.end();
  }

  // The base, and of the front from its accurate end on what stands apart.
  [[nodiscard]] std::vector<std::size_t> named_rows() const {
    std::vector<std::size_t> rows;
    if (study_.rows.front().depth) rows.push_back(0);
    for (auto at = front_.rbegin(); at != front_.rend() && rows.size() < kMostNames; ++at) {
      const bool is_apart = std::all_of(rows.begin(), rows.end(), [&](std::size_t other) {
        return std::hypot(x(ms_of(*at)) - x(ms_of(other)), y(um_of(*at)) - y(um_of(other))) >
               kApartPx;
      });
      if (is_apart) rows.push_back(*at);
    }
    std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
      return ms_of(a) < ms_of(b);
    });
    return rows;
  }
  [[nodiscard]] double ms_of(std::size_t row) const { return frame_ms(study_, study_.rows[row]); }
  [[nodiscard]] double um_of(std::size_t row) const {
    return 1000 * study_.rows[row].depth->median_mm;
  }

  const AccuracyStudy& study_;
  std::vector<std::size_t> front_, named_;
  double most_ms_ = 1, most_um_ = 1;
  std::string text_;
};

}  // namespace

std::string svg_of(const AccuracyStudy& study) {
  return Figure(study).svg();
}

}  // namespace alltact
