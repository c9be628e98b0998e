#include "core/sensing/marker_methods.h"

#include "core/program.h"
#include "core/sensing/markers/networks/network_dot_finder.h"
#include "core/sensing/markers/paper_rows.h"

#include <utility>

namespace alltact {
namespace {

/// Detects and numbers the dots of each frame independently.
class ModelMarkerFinder : public MarkerFinder {
 public:
  ModelMarkerFinder(std::unique_ptr<const DotFinder> finder, MarkerModel model)
      : finder_(std::move(finder)), model_(std::move(model)) {}

  std::optional<Markers> operator()(const cv::Mat& grey,
                                    const FaceShape& shape,
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

  std::optional<Markers> operator()(const cv::Mat& grey,
                                    const FaceShape& shape,
                                    Message* problem) override {
    const FoundDots found = (*finder_)(grey, shape);
    auto markers =
        paper_rows(found.dots, per_row_, shape.base_at_low_u(), last_.empty() ? nullptr : &last_);
    if (markers)
      last_ = *markers;
    else if (problem)
      *problem = found.problem.empty()
                     ? en::say("{} dots were found beside the face: too few to sort into two rows",
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

}  // namespace alltact
