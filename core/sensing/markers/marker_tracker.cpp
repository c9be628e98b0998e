#include "core/sensing/markers/marker_tracker.h"

#include "core/base/program.h"
#include "core/sensing/markers/dot_measure.h"
#include "core/sensing/markers/dot_network.h"
#include "core/sensing/markers/marker_detector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Core>

namespace alltact {
namespace {

constexpr double kMaxResidualPx = 3.0;  // above this the numbers are rejected

}  // namespace

MarkerTracker::MarkerTracker(MarkerRows rows, MarkerModel model)
    : detector_(rows), model_(std::move(model)), last_dots_(model_.typical_dots()) {}

std::optional<Markers> MarkerTracker::follow(const cv::Mat& grey, const FaceShape& shape) {
  const SideEdges edges(shape);
  Markers markers = *last_;
  // Less than half the distance to the next marker, so that neighbours are not confused.
  const double search = 0.35 * model_.spacing_px();
  for (std::size_t m = 0; m < markers.size(); ++m) {
    if (model_.is_missing(static_cast<int>(m))) continue;
    const auto dot = near_dot(grey, edges, {markers[m].u, markers[m].v}, search, last_dots_[m]);
    markers[m].seen = dot.has_value();
    if (!dot) continue;
    markers[m] = {dot->u, dot->v, true, dot->sd_px};
    last_dots_[m].half_u_px = dot->half_u_px;
    last_dots_[m].half_v_px = dot->half_v_px;
  }
  for (std::size_t a = 0; a < markers.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (markers[a].seen && markers[b].seen &&
          std::hypot(markers[a].u - markers[b].u, markers[a].v - markers[b].v) < 1.0)
        return std::nullopt;  // two markers on one dot: at least one of them jumped
  const int found = seen_count(markers);
  if (found + 1 < seen_count(*last_)) return std::nullopt;
  auto completed = model_.complete(std::move(markers));
  if (!completed || model_.residual_px(*completed) > kMaxResidualPx) return std::nullopt;
  if (seen_count(*completed) + 1 < found) return std::nullopt;  // several contradict the others
  return completed;
}

std::optional<Markers> MarkerTracker::operator()(const cv::Mat& grey, const FaceShape& shape,
                                                 Message* problem) {
  if (last_) {
    last_ = follow(grey, shape);
    if (last_) return last_;
  }
  last_ = numbered(detector_(grey, shape), model_, problem);
  return last_;
}

std::optional<Markers> numbered(const FoundDots& found, const MarkerModel& model,
                                Message* problem) {
  auto markers = model.number(found.dots);
  if (markers && model.residual_px(*markers) > kMaxResidualPx) markers.reset();
  if (!markers && problem)
    *problem = en::say(
        "{} dots were found next to the face, but less than a third of the {} markers fit any pose "
        "of the reference recording",
        found.dots.size(), model.present_count());
  return markers;
}

namespace {

/// Detects and numbers the dots of each frame independently.
class ModelMarkerFinder : public MarkerFinder {
 public:
  ModelMarkerFinder(std::unique_ptr<const DotFinder> finder, MarkerModel model)
      : finder_(std::move(finder)), model_(std::move(model)) {}

  std::optional<Markers> operator()(const cv::Mat& grey, const FaceShape& shape,
                                    Message* problem) override {
    const FoundDots found = (*finder_)(grey, shape);
    if (found.problem.empty()) return numbered(found, model_, problem);
    if (problem) *problem = en::say("{}.", found.problem);
    return std::nullopt;
  }
  void forget() override {}

 private:
  std::unique_ptr<const DotFinder> finder_;
  MarkerModel model_;
};

/// The source paper's rows. The markers of the last frame decide which ones are hidden.
class SortedRowFinder : public MarkerFinder {
 public:
  SortedRowFinder(std::unique_ptr<const DotFinder> finder, int per_row, Markers rest)
      : finder_(std::move(finder)), per_row_(per_row), rest_(std::move(rest)), last_(rest_) {}

  std::optional<Markers> operator()(const cv::Mat& grey, const FaceShape& shape,
                                    Message* problem) override {
    const FoundDots found = (*finder_)(grey, shape);
    auto markers =
        paper_rows(found.dots, per_row_, shape.base_at_low_u(), last_.empty() ? nullptr : &last_);
    if (markers)
      last_ = *markers;
    else if (problem)
      *problem = found.problem.empty()
                     ? en::say("{} dots were found next to the face: too few to sort into two rows",
                               found.dots.size())
                     : en::say("{}.", found.problem);
    return markers;
  }
  void forget() override { last_ = rest_; }

 private:
  std::unique_ptr<const DotFinder> finder_;
  int per_row_;
  Markers rest_, last_;  // empty: not known
};

Result<std::unique_ptr<const DotFinder>> network_finder(const std::string& network,
                                                        const MarkerRows& rows) {
  std::filesystem::path file = network;
  if (network == kBuiltInNetwork) {
    const auto own = find_resource(kBuiltInMarkerNetwork);
    if (!own) return own.error();
    file = *own;
  }
  auto loaded = DotNetwork::load(file);
  if (!loaded) return loaded.error();
  return std::unique_ptr<const DotFinder>(
      std::make_unique<NetworkDotFinder>(std::move(loaded).value(), rows));
}

Markers markers_at_rest(const Finger& finger) {
  Markers rest;
  if (!finger.contact) return rest;
  for (const Eigen::Vector2d& position : finger.contact->rest_markers)
    rest.push_back({position.x(), position.y(), true, 0});
  return rest;
}

}  // namespace

const char* to_string(MarkerMethod method) {
  switch (method) {
    case MarkerMethod::kPaper:
      return "paper";
    case MarkerMethod::kNetwork:
      return "network";
    case MarkerMethod::kBlobs:
      break;
  }
  return "blobs";
}

Result<std::unique_ptr<MarkerFinder>> make_marker_finder(MarkerMethod method,
                                                         const std::string& network,
                                                         const Finger& finger,
                                                         const MarkerModel& model) {
  const MarkerRows& rows = finger.markers;
  using FinderPtr = std::unique_ptr<MarkerFinder>;
  if (method == MarkerMethod::kBlobs)
    return FinderPtr(std::make_unique<MarkerTracker>(rows, model));
  std::unique_ptr<const DotFinder> dots = std::make_unique<MarkerDetector>(rows);
  if (method == MarkerMethod::kNetwork || network != kBuiltInNetwork) {
    auto loaded = network_finder(network, rows);
    if (!loaded) return loaded.error();
    dots = std::move(loaded).value();
  }
  if (method == MarkerMethod::kNetwork)
    return FinderPtr(std::make_unique<ModelMarkerFinder>(std::move(dots), model));
  return FinderPtr(
      std::make_unique<SortedRowFinder>(std::move(dots), rows.per_row, markers_at_rest(finger)));
}

namespace {

// Fraction of the distance to the next marker, so that markers are not confused
constexpr double kSearch = 0.35;
constexpr int kRetryPeriod = 8;  // failures until the other polarity is tried again

double distance(const Dot& a, const Dot& b) { return std::hypot(a.u - b.u, a.v - b.v); }

/// Distance to the nearer neighbour in its row.
double spacing(const std::vector<Dot>& markers, std::size_t m) {
  const std::size_t per_row = markers.size() / 2, index = m % per_row;
  double least = 1e9;
  if (index > 0) least = std::min(least, distance(markers[m], markers[m - 1]));
  if (index + 1 < per_row) least = std::min(least, distance(markers[m], markers[m + 1]));
  return least;
}

Markers as_markers(const std::vector<Dot>& dots) {
  Markers markers;
  for (const Dot& dot : dots) markers.push_back({dot.u, dot.v, true, dot.sd_px});
  return markers;
}

}  // namespace

std::optional<std::vector<Dot>> EvenRows::follow(const cv::Mat& grey,
                                                 const FaceShape& shape) const {
  if (last_.empty()) return std::nullopt;
  const SideEdges edges(shape);
  std::vector<Dot> dots;
  for (std::size_t m = 0; m < last_.size(); ++m) {
    const Dot& was = last_[m];
    const auto dot = near_dot(grey, edges, {was.u, was.v}, kSearch * spacing(last_, m), was);
    if (!dot || dot->upper != was.upper) return std::nullopt;
    for (const Dot& other : dots)
      // One of them jumped to the other's dot
      if (distance(*dot, other) < 1.0) return std::nullopt;
    dots.push_back(*dot);
  }
  locate_on_finger(dots, shape, edges);
  return two_rows(dots, rows_.per_row, shape.base_at_low_u());
}

Polarity EvenRows::polarity() {
  if (rows_.polarity != Polarity::kAuto || !known_polarity_) return rows_.polarity;
  // With one marker hidden the rows are not even, and a search in both polarities would find no
  // more.
  return failures_++ % kRetryPeriod == kRetryPeriod - 1 ? Polarity::kAuto : *known_polarity_;
}

std::optional<Markers> EvenRows::operator()(const cv::Mat& grey, const FaceShape& shape,
                                            std::vector<Dot>& dots) {
  dots.clear();
  if (grey.cols != shape.width_px() || rows_.per_row < 1) return std::nullopt;
  auto markers = follow(grey, shape);
  if (!markers) {
    auto found = MarkerDetector({rows_.per_row, polarity()})(grey, shape);
    markers = two_rows(found.dots, rows_.per_row, shape.base_at_low_u());
    if (markers)
      known_polarity_ = found.polarity;
    else
      dots = std::move(found.dots);
  }
  if (!markers) {
    last_.clear();
    return std::nullopt;
  }
  failures_ = 0;
  last_ = std::move(*markers);
  return as_markers(last_);
}

void EvenRows::forget() {
  last_.clear();
  known_polarity_.reset();
}

namespace {

constexpr double kMinSdPx = 1.0;  // of an unseen marker
// Fraction of a step, where the row is too short to estimate it
constexpr double kTypicalBending = 0.3;
// Costs of a dot one step from its last position, and of a number skipped at the base without a
// last position. For comparison: a step of twice its neighbour costs 0.48.
constexpr double kMovedCost = 0.01, kLeftOutCost = 0.01;
constexpr double kNoNumbering = std::numeric_limits<double>::infinity();

std::vector<Dot> sorted_row(const std::vector<Dot>& dots, bool upper, std::size_t per_row,
                            bool base_at_low_u) {
  std::vector<Dot> row;
  std::copy_if(dots.begin(), dots.end(), std::back_inserter(row),
               [upper](const Dot& dot) { return dot.upper == upper; });
  std::stable_sort(row.begin(), row.end(), [](const Dot& a, const Dot& b) {
    return std::abs(a.contrast) > std::abs(b.contrast);
  });
  if (row.size() > per_row) row.resize(per_row);
  std::stable_sort(row.begin(), row.end(), [base_at_low_u](const Dot& a, const Dot& b) {
    return base_at_low_u ? a.u < b.u : a.u > b.u;
  });
  return row;
}

Eigen::Vector2d position(const Dot& dot) { return {dot.u, dot.v}; }

/// Numbers of a row's dots, by dynamic programming over neighbours. The cost sums the squared
/// logarithms of step ratios, to the neighbours' or to the previous steps. The squared
/// displacements since then have a far lower weight.
class RowNumbers {
 public:
  /// before: the row's previous markers; nullptr: unknown.
  RowNumbers(const std::vector<Dot>& row, int per_row, const Marker* before)
      : row_(row), before_(before), max_skips_(per_row - static_cast<int>(row.size())) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      steps_px_.push_back(std::max(1e-3, (position(row[i + 1]) - position(row[i])).norm()));
  }

  [[nodiscard]] std::vector<int> operator()() const {
    const std::size_t n = row_.size();
    const std::size_t skips = static_cast<std::size_t>(max_skips_) + 1;
    if (n == 1) return {lone_number()};
    // cost(i, a, b): the minimum over the dots up to i with a numbers skipped before dot i - 1 and
    // b before dot i.
    const auto at = [skips](std::size_t i, int a, int b) {
      return (i * skips + static_cast<std::size_t>(a)) * skips + static_cast<std::size_t>(b);
    };
    std::vector<double> cost(n * skips * skips, kNoNumbering);
    std::vector<int> before(cost.size(), -1);
    for (int a = 0; a <= max_skips_; ++a)
      for (int b = a; b <= max_skips_; ++b)
        cost[at(1, a, b)] = moved(0, a) + moved(1, b) + (before_ ? stretched(1, a, b) : 0.0);
    for (std::size_t i = 2; i < n; ++i)
      for (int a = 0; a <= max_skips_; ++a)
        for (int b = a; b <= max_skips_; ++b)
          for (int c = b; c <= max_skips_; ++c) {
            const double uneven = before_ ? stretched(i, b, c) : bend_at(i, a, b, c);
            const double total = cost[at(i - 1, a, b)] + uneven + moved(i, c);
            if (total >= cost[at(i, b, c)]) continue;
            cost[at(i, b, c)] = total;
            before[at(i, b, c)] = a;
          }
    int b = 0, c = 0;
    for (int x = 0; x <= max_skips_; ++x)
      for (int y = x; y <= max_skips_; ++y)
        if (cost[at(n - 1, x, y)] < cost[at(n - 1, b, c)]) b = x, c = y;
    std::vector<int> numbers(n);
    for (std::size_t i = n - 1; i >= 1; --i) {
      numbers[i] = static_cast<int>(i) + c;
      const int a = before[at(i, b, c)];
      c = b;
      b = a;
    }
    numbers[0] = c;
    return numbers;
  }

 private:
  [[nodiscard]] double bend_at(std::size_t i, int a, int b, int c) const {
    const double first = steps_px_[i - 2] / (1 + b - a), second = steps_px_[i - 1] / (1 + c - b);
    return std::pow(std::log(second / first), 2);
  }
  /// Cost of the step to dot i relative to its previous length.
  [[nodiscard]] double stretched(std::size_t i, int a, int b) const {
    const Marker& from = before_[i - 1 + static_cast<std::size_t>(a)];
    const Marker& to = before_[i + static_cast<std::size_t>(b)];
    const double was_px = std::max(1e-3, std::hypot(to.u - from.u, to.v - from.v));
    return std::pow(std::log(steps_px_[i - 1] / was_px), 2);
  }
  /// Cost of the displacement of dot i with `skipped` numbers before it.
  [[nodiscard]] double moved(std::size_t i, int skipped) const {
    if (!before_) return kLeftOutCost * skipped;
    const Marker& was = before_[i + static_cast<std::size_t>(skipped)];
    const double step_px = steps_px_.empty() ? 1.0 : steps_px_[std::min(i, steps_px_.size() - 1)];
    return kMovedCost * std::pow(std::hypot(row_[i].u - was.u, row_[i].v - was.v) / step_px, 2);
  }
  [[nodiscard]] int lone_number() const {
    int best = 0;
    for (int number = 1; number <= max_skips_; ++number)
      if (moved(0, number) < moved(0, best)) best = number;
    return best;
  }

  const std::vector<Dot>& row_;
  const Marker* before_;
  int max_skips_;  // maximum of skipped numbers
  std::vector<double> steps_px_;
};

/// Root mean square difference of neighbouring steps of the row in u and v, px. It is the second
/// difference over one number in each direction, of every seen marker between seen ones.
double bending_px(const Markers& row, const std::vector<int>& seen) {
  const auto marker = [&](std::size_t i) -> const Marker& {
    return row[static_cast<std::size_t>(seen[i])];
  };
  double square = 0;
  for (std::size_t i = 1; i + 1 < seen.size(); ++i) {
    const double before = seen[i] - seen[i - 1], after = seen[i + 1] - seen[i];
    const Marker &a = marker(i - 1), &b = marker(i), &c = marker(i + 1);
    const double part = before / (before + after);
    const double off_u = b.u - a.u - part * (c.u - a.u), off_v = b.v - a.v - part * (c.v - a.v);
    square += std::pow(2.0 / (before * after), 2) * (off_u * off_u + off_v * off_v);
  }
  if (seen.size() > 2) return std::sqrt(square / (2.0 * static_cast<double>(seen.size() - 2)));
  const Marker &a = marker(0), &b = marker(1);
  return kTypicalBending * std::hypot(b.u - a.u, b.v - a.v) / (seen[1] - seen[0]);
}

/// Estimates the unseen markers of a row with at least two seen ones.
void fill_from_neighbours(Markers& row) {
  std::vector<int> seen;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (row[i].seen) seen.push_back(static_cast<int>(i));
  const double half_bending_px = 0.5 * bending_px(row, seen);
  for (int i = 0; i < static_cast<int>(row.size()); ++i) {
    Marker& marker = row[static_cast<std::size_t>(i)];
    if (marker.seen) continue;
    // The seen ones on both sides; at an end the last two.
    auto after =
        static_cast<std::size_t>(std::lower_bound(seen.begin(), seen.end(), i) - seen.begin());
    after = std::clamp<std::size_t>(after, 1, seen.size() - 1);
    const int a = seen[after - 1], b = seen[after];
    const Marker &from = row[static_cast<std::size_t>(a)], &to = row[static_cast<std::size_t>(b)];
    const double part = static_cast<double>(i - a) / (b - a);
    const double off_px = half_bending_px * std::abs((i - a) * (i - b));
    marker = {from.u + part * (to.u - from.u), from.v + part * (to.v - from.v), false,
              std::max(kMinSdPx, off_px)};
  }
}

}  // namespace

std::optional<Markers> paper_rows(const std::vector<Dot>& dots, int per_row, bool base_at_low_u,
                                  const Markers* before) {
  if (per_row < 1) return std::nullopt;
  const auto length = static_cast<std::size_t>(per_row);
  if (before && before->size() != 2 * length) before = nullptr;
  Markers markers;
  for (const bool is_upper : {true, false}) {
    const auto found = sorted_row(dots, is_upper, length, base_at_low_u);
    if (found.size() < std::min<std::size_t>(2, length)) return std::nullopt;
    const auto numbers =
        RowNumbers(found, per_row, before ? before->data() + markers.size() : nullptr)();
    Markers row(length);
    for (std::size_t i = 0; i < found.size(); ++i)
      row[static_cast<std::size_t>(numbers[i])] = {found[i].u, found[i].v, true, found[i].sd_px};
    if (found.size() < length) fill_from_neighbours(row);
    markers.insert(markers.end(), row.begin(), row.end());
  }
  return markers;
}

}  // namespace alltact
