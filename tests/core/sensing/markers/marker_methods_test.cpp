#include "core/base/atomic_file.h"
#include "core/sensing/markers/dot_network.h"
#include "core/sensing/markers/marker_detector.h"
#include "core/sensing/markers/marker_tracker.h"
#include "core/sensing/pipeline_settings.h"
#include "tests/support/marked_finger.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::Bend;
using test::MarkedFinger;
using test::random_bend;
using ::testing::HasSubstr;

std::string own_network() {
  return (std::filesystem::path(ALLTACT_SOURCE_DIR) / "resources" / kBuiltInMarkerNetwork).string();
}

MarkerModel learnt_from(const MarkedFinger& finger, std::mt19937& random) {
  Eigen::MatrixXd layouts(200, 4 * finger.per_row);
  for (Eigen::Index i = 0; i < layouts.rows(); ++i)
    layouts.row(i) = finger.layout(random_bend(random)).transpose();
  return MarkerModel::learn(layouts, finger.typical(Bend{})).value();
}

Finger finger_of(const MarkedFinger& drawn, Polarity polarity) {
  Finger finger;
  finger.camera = drawn.camera();
  finger.face = drawn.face();
  finger.markers = {drawn.per_row, polarity};
  ContactSettings contact;
  const Eigen::VectorXd rest = drawn.layout(Bend{});
  for (int m = 0; m < 2 * drawn.per_row; ++m)
    contact.rest_markers.emplace_back(rest.segment<2>(2 * m));
  finger.contact = contact;
  return finger;
}

double most_off_px(const Markers& markers, const MarkedFinger& finger, const Bend& bend) {
  const auto discs = finger.discs(bend);
  double most = 0;
  for (std::size_t m = 0; m < discs.size(); ++m)
    if (markers[m].seen)
      most = std::max(most, std::hypot(markers[m].u - discs[m].u, markers[m].v - discs[m].v));
  return most;
}

// With an inner marker hidden each way says the same of the others, and tells what it can of that
// one: the paper's the middle of its neighbours, the others what the recording knows.
TEST(MarkerMethods, EveryWayNumbersTheSameMarkers) {
  std::mt19937 random(61);
  const MarkedFinger drawn;
  const MarkerModel model = learnt_from(drawn, random);
  const Finger finger = finger_of(drawn, Polarity::kBright);
  for (const MarkerMethod method :
       {MarkerMethod::kBlobs, MarkerMethod::kPaper, MarkerMethod::kNetwork}) {
    auto made = make_marker_finder(method, own_network(), finger, model);
    if (method == MarkerMethod::kPaper)
      made = make_marker_finder(method, kBuiltInNetwork, finger, model);
    ASSERT_TRUE(made.ok()) << made.error().sentence();
    const Bend bend{0.1, 0.05, 2, 0};
    const cv::Mat grey = drawn.with_noise(drawn.clean(bend, {3}), random);
    Message problem;
    const auto markers = (**made)(grey, drawn.shape(bend), &problem);
    ASSERT_TRUE(markers.has_value()) << to_string(method) << ": " << problem.english();
    EXPECT_LT(most_off_px(*markers, drawn, bend), 0.4) << to_string(method);
    EXPECT_FALSE((*markers)[3].seen) << to_string(method);
    int seen = 0;
    for (const Marker& marker : *markers) seen += marker.seen;
    EXPECT_GE(seen, 10) << to_string(method);
    const auto hidden = drawn.discs(bend)[3];
    const double off = std::hypot((*markers)[3].u - hidden.u, (*markers)[3].v - hidden.v);
    std::printf("[ figures  ] %s: %d of 11 seen, the hidden one %.2f px off\n", to_string(method),
                seen, off);
    if (method == MarkerMethod::kPaper)
      EXPECT_GT(off, 2.0) << "perspective is not told by neighbours";
    else
      EXPECT_LT(off, 1.0);
  }
}

// Pictures that nothing of the simulation drew, which is all that it was trained on.
TEST(MarkerMethods, TheNetworkFindsDotsInPicturesOfAnotherMaking) {
  std::mt19937 random(62);
  int dots = 0, found = 0, false_dots = 0, by_blobs = 0;
  double square_px2 = 0;
  for (int f = 0; f < 6; ++f) {
    MarkedFinger drawn;
    drawn.mirrored = f % 2 == 1;
    if (f == 3) drawn.width = 1920, drawn.height = 1080, drawn.focal = 1048;
    const bool is_dark = f % 3 == 2;
    if (is_dark) drawn.dot_contrast = -35, drawn.side_level = 50;
    const NetworkDotFinder finder(DotNetwork::load(own_network()).value(),
                                  {drawn.per_row, Polarity::kAuto});
    const Bend bend = random_bend(random);
    const cv::Mat grey = drawn.with_noise(drawn.clean(bend), random);
    const FaceShape shape = drawn.shape(bend);
    const FoundDots given = finder(grey, shape);
    const FoundDots blobs = MarkerDetector({drawn.per_row, given.polarity})(grey, shape);
    const auto is_found = [](const FoundDots& by, const MarkedFinger::Disc& disc) {
      return std::any_of(by.dots.begin(), by.dots.end(), [&](const Dot& dot) {
        return std::hypot(dot.u - disc.u, dot.v - disc.v) < 3;
      });
    };
    for (const auto& disc : drawn.discs(bend)) by_blobs += is_found(blobs, disc);
    EXPECT_TRUE(given.problem.empty());
    EXPECT_EQ(given.polarity, is_dark ? Polarity::kDark : Polarity::kBright) << f;
    std::size_t here = 0;
    for (const auto& disc : drawn.discs(bend)) {
      double best = 3;
      for (const Dot& dot : given.dots) {
        EXPECT_GT(dot.score, 0.1);
        EXPECT_LE(dot.score, 1.0);
        best = std::min(best, std::hypot(dot.u - disc.u, dot.v - disc.v));
      }
      ++dots;
      if (best < 3) ++here, square_px2 += best * best;
    }
    found += static_cast<int>(here);
    false_dots += static_cast<int>(given.dots.size() - here);
  }
  std::printf("[ figures  ] of %d dots %d found (%d by blobs), %d false, %.3f px rms\n", dots,
              found, by_blobs, false_dots, std::sqrt(square_px2 / found));
  EXPECT_GT(found, 0.85 * dots);
  EXPECT_LE(false_dots, 4);
  EXPECT_LT(std::sqrt(square_px2 / found), 0.2);
}

TEST(MarkerMethods, ANetworkThatCannotBeReadIsSaidWhereItIsUsed) {
  std::mt19937 random(63);
  const MarkedFinger drawn;
  const MarkerModel model = learnt_from(drawn, random);
  const Finger finger = finger_of(drawn, Polarity::kBright);
  const test::TemporaryFolder folder;
  const std::string broken = (folder / "broken.onnx").string();
  ASSERT_TRUE(write_file_atomically(broken, "no network").ok());
  for (const std::string& file : {broken, (folder / "none.onnx").string()}) {
    EXPECT_TRUE(make_marker_finder(MarkerMethod::kBlobs, file, finger, model).ok());
    for (const MarkerMethod method : {MarkerMethod::kPaper, MarkerMethod::kNetwork}) {
      const auto made = make_marker_finder(method, file, finger, model);
      ASSERT_FALSE(made.ok());
      EXPECT_THAT(made.error().sentence(), HasSubstr(file));
    }
  }
}

TEST(MarkerMethods, AreChosenByWordsAndDefaultToWhatWas) {
  PipelineSettings settings;
  EXPECT_EQ(settings.marker_method, MarkerMethod::kBlobs);
  int known = 0;
  for (const auto& setting : pipeline_settings()) {
    if (setting.name == "marker-network") {
      EXPECT_EQ(setting.default_value(), "own");
      EXPECT_FALSE(setting.set(settings, "").ok());
      EXPECT_TRUE(setting.set(settings, "my detector.onnx").ok());
      EXPECT_EQ(settings.marker_network, "my detector.onnx");
      ++known;
    }
    if (setting.name != "marker-method") continue;
    ++known;
    EXPECT_FALSE(setting.set(settings, "guess").ok());
    for (const MarkerMethod method :
         {MarkerMethod::kPaper, MarkerMethod::kNetwork, MarkerMethod::kBlobs}) {
      EXPECT_TRUE(setting.set(settings, to_string(method)).ok());
      EXPECT_EQ(settings.marker_method, method);
      EXPECT_EQ(setting.get(settings), to_string(method));
    }
  }
  EXPECT_EQ(known, 2);
}

}  // namespace
}  // namespace alltact
