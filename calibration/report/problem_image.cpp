#include "calibration/report/problem_image.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kReadableWidth = 900;  // smaller images are drawn at twice their size
constexpr int kLineHeight = 24, kMargin = 12;
constexpr double kTextScale = 0.5;
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;

// The marks differ by shape as well.
const cv::Scalar kEdgeColour(230, 200, 60), kUsedColour(90, 220, 90), kRefusedColour(80, 80, 255),
    kExpectedColour(60, 190, 255), kDarkerColour(200, 120, 255), kTextColour(235, 235, 235),
    kGround(40, 40, 40);

class Drawing {
 public:
  explicit Drawing(const cv::Mat& grey) : scale_(grey.cols < kReadableWidth ? 2 : 1) {
    cv::Mat large;
    cv::resize(grey, large, {}, scale_, scale_, cv::INTER_NEAREST);
    cv::cvtColor(large, image_, cv::COLOR_GRAY2BGR);
  }

  void darker(const cv::Mat& mask) {
    if (mask.empty()) return;
    cv::Mat large;
    cv::resize(mask, large, image_.size(), 0, 0, cv::INTER_NEAREST);
    std::vector<std::vector<cv::Point>> outlines;
    cv::findContours(large, outlines, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
    cv::drawContours(image_, outlines, -1, kDarkerColour, 1);
  }

  void edges(const EdgeCurves& curves) {
    for (const auto* v : {&curves.upper, &curves.lower}) {
      std::vector<cv::Point> line;
      for (std::size_t i = 0; i < curves.u.size(); ++i)
        line.push_back(at(static_cast<double>(curves.u[i]), static_cast<double>((*v)[i])));
      if (line.size() > 1) cv::polylines(image_, line, false, kEdgeColour, 1, cv::LINE_AA);
    }
  }

  void mark(const ProblemMark& mark) {
    if (!std::isfinite(mark.u) || !std::isfinite(mark.v) || !std::isfinite(mark.radius_px)) return;
    if (std::abs(mark.u) > 1e5 || std::abs(mark.v) > 1e5) return;
    const cv::Point centre = at(mark.u, mark.v);
    const int radius =
        std::clamp(static_cast<int>(std::lround(scale_ * mark.radius_px)) + 4, 6, 80);
    switch (mark.kind) {
      case ProblemMark::Kind::kUsed:
        cv::circle(image_, centre, radius, kUsedColour, 1, cv::LINE_AA);
        break;
      case ProblemMark::Kind::kRefused:
        cross(centre, radius);
        break;
      case ProblemMark::Kind::kExpected:
        for (int from = 0; from < 360; from += 45)
          cv::ellipse(image_, centre, {radius, radius}, 0, from, from + 25, kExpectedColour, 1,
                      cv::LINE_AA);
        break;
      case ProblemMark::Kind::kDarker:
        cv::rectangle(image_, centre - cv::Point(radius, radius),
                      centre + cv::Point(radius, radius), kDarkerColour, 1, cv::LINE_AA);
    }
    if (mark.number >= 0)
      cv::putText(image_, fmt::format("{}", mark.number), centre + cv::Point(radius + 2, 5), kFont,
                  kTextScale, colour_of(mark.kind), 1, cv::LINE_AA);
  }

  static const cv::Scalar& colour_of(ProblemMark::Kind kind) {
    return kind == ProblemMark::Kind::kUsed      ? kUsedColour
           : kind == ProblemMark::Kind::kRefused ? kRefusedColour
           : kind == ProblemMark::Kind::kDarker  ? kDarkerColour
                                                 : kExpectedColour;
  }
  [[nodiscard]] const cv::Mat& image() const { return image_; }

 private:
  [[nodiscard]] cv::Point at(double u, double v) const {
    return {static_cast<int>(std::lround(scale_ * (u + 0.5))),
            static_cast<int>(std::lround(scale_ * (v + 0.5)))};
  }
  void cross(const cv::Point& centre, int radius) {
    for (const int turn : {-1, 1})
      cv::line(image_, centre + cv::Point(-radius, -turn * radius),
               centre + cv::Point(radius, turn * radius), kRefusedColour, 1, cv::LINE_AA);
  }

  int scale_;
  cv::Mat image_;
};

struct Line {
  std::string text;
  cv::Scalar colour;
};

// Breaks a sentence at its blanks so that every line fits.
void add_lines(const std::string& sentence, int width, std::vector<Line>& lines) {
  std::istringstream words(sentence);
  std::string word, line;
  int baseline = 0;
  while (words >> word) {
    const std::string longer = line.empty() ? word : line + ' ' + word;
    if (!line.empty() && cv::getTextSize(longer, kFont, kTextScale, 1, &baseline).width > width) {
      lines.push_back({line, kTextColour});
      line = word;
    } else {
      line = longer;
    }
  }
  if (!line.empty()) lines.push_back({line, kTextColour});
}

std::vector<Line> key_to(const ProblemScene& scene) {
  std::vector<Line> lines;
  if (!scene.edges.u.empty()) lines.push_back({"lines: edges of the face", kEdgeColour});
  if (!scene.darker.empty())
    lines.push_back({"outlined: darker than the untouched face", kDarkerColour});
  const std::pair<ProblemMark::Kind, const char*> meanings[] = {
      {ProblemMark::Kind::kUsed, "circle: a marker, with its number"},
      {ProblemMark::Kind::kRefused, "cross: looks like a dot, but is none of the rows"},
      {ProblemMark::Kind::kExpected, "broken circle: a marker should be here"},
      {ProblemMark::Kind::kDarker, "square: darker than the untouched face"}};
  for (const auto& [kind, meaning] : meanings)
    if (std::any_of(scene.marks.begin(), scene.marks.end(),
                    [kind = kind](const ProblemMark& mark) { return mark.kind == kind; }))
      lines.push_back({meaning, Drawing::colour_of(kind)});
  return lines;
}

}  // namespace

cv::Mat problem_image(const ProblemScene& scene) {
  Drawing drawing(scene.grey);
  drawing.darker(scene.darker);
  drawing.edges(scene.edges);
  for (const ProblemMark& mark : scene.marks) drawing.mark(mark);
  const cv::Mat& image = drawing.image();
  std::vector<Line> lines = key_to(scene);
  for (const std::string& sentence : scene.words)
    add_lines(sentence, image.cols - 2 * kMargin, lines);
  const int height = static_cast<int>(lines.size()) * kLineHeight + 2 * kMargin;
  cv::Mat figure(image.rows + height, image.cols, CV_8UC3, kGround);
  image.copyTo(figure.rowRange(0, image.rows));
  int y = image.rows + kMargin + kLineHeight - 8;
  for (const Line& line : lines) {
    cv::putText(figure, line.text, {kMargin, y}, kFont, kTextScale, line.colour, 1, cv::LINE_AA);
    y += kLineHeight;
  }
  return figure;
}

}  // namespace alltact
