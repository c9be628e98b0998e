#include "core/io/atomic_file.h"
#include "core/sensing/face_picture.h"
#include "core/sensing/reference_library.h"
#include "core/sensing/reference_weights.h"
#include "tests/support/marked_finger.h"

#include <filesystem>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

fs::path scratch_folder(const std::string& name) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("alltact_" + name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

Eigen::MatrixXd random_points(int n, int dimensions, std::mt19937& random) {
  std::normal_distribution<double> normal(0.0, 10.0);
  Eigen::MatrixXd points(n, dimensions);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = normal(random);
  return points;
}

TEST(LocalLinearWeights, SumToOneAndReproduceAPoseInsideTheNeighbours) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::MatrixXd points = random_points(16, 1 + trial % 4, random);
    const Eigen::VectorXd query = 0.3 * random_points(1, 1 + trial % 4, random).transpose();
    const Eigen::VectorXd w = local_linear_weights(points, query, 0.05, 3.0);
    EXPECT_NEAR(w.sum(), 1.0, 1e-9);
    EXPECT_LE(w.lpNorm<1>(), 3.0 + 1e-9);
    EXPECT_LT((points.transpose() * w - query).norm(), 0.1);
  }
}

TEST(LocalLinearWeights, StaySmallFarOutsideAndForNeighboursOnALine) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 200; ++trial) {
    Eigen::MatrixXd points = random_points(16, 3, random);
    if (trial % 2) points = points.col(0) * Eigen::RowVector3d(1, 2, -1);
    if (trial % 5 == 0) points.rowwise() = points.row(0).eval();  // all the same
    const Eigen::VectorXd query = 20 * random_points(1, 3, random).transpose();
    const Eigen::VectorXd w = local_linear_weights(points, query, 0.05, 3.0);
    ASSERT_TRUE(w.allFinite());
    EXPECT_NEAR(w.sum(), 1.0, 1e-9);
    EXPECT_LE(w.lpNorm<1>(), 3.0 + 1e-9);
  }
}

TEST(MixFaces, IsTheWeightedSumWhereEveryFrameShowsTheFace) {
  std::mt19937 random(7);
  const testing::MarkedFinger finger;
  std::vector<cv::Mat> pictures;
  std::vector<FacePicture> faces;
  std::vector<FaceShape> shapes;
  std::vector<float> weights{0.5F, -0.25F, 0.4F, 0.2F, 0.15F};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const auto bend = testing::random_bend(random);
    cv::Mat grey(finger.height, finger.width, CV_8UC1);
    cv::randu(grey, 0, 256);
    pictures.push_back(grey);
    shapes.push_back(finger.shape(bend));
    faces.push_back(keep_face(grey, shapes.back(), 1.0));
    EXPECT_LT(faces.back().bytes(), grey.total());
  }
  std::vector<const FacePicture*> pointers;
  for (const auto& face : faces) pointers.push_back(&face);
  const cv::Mat grey =
      ReferencePicture(nullptr, pointers, weights, {finger.width, finger.height}).grey();
  int shown = 0;
  for (int u = 0; u < finger.width; ++u)
    for (int v = 0; v < finger.height; ++v) {
      bool everywhere = true;
      double sum = 0;
      for (std::size_t i = 0; i < weights.size(); ++i) {
        const auto rows = shapes[i].rows(u, 1.0);
        everywhere = everywhere && v >= rows.first && v <= rows.last;
        sum += static_cast<double>(weights[i]) * pictures[i].at<std::uint8_t>(v, u);
      }
      ASSERT_EQ(std::isfinite(grey.at<float>(v, u)), everywhere) << u << ' ' << v;
      if (everywhere) {
        // five products rounded to 1/64, weights to 2^-15
        ASSERT_NEAR(grey.at<float>(v, u), sum, 2.5 / 64 + 5 * 255 * std::ldexp(1.0, -15));
      }
      shown += everywhere;
    }
  EXPECT_GT(shown, 20000);
  // A picture somebody holds is not written over.
  const cv::Mat held = grey, copy = grey.clone();
  const cv::Mat other =
      ReferencePicture(nullptr, {pointers[0]}, {1.0F}, {finger.width, finger.height}).grey();
  EXPECT_NE(held.data, other.data);
  EXPECT_EQ(std::memcmp(held.data, copy.data, held.total() * held.elemSize()), 0);
}

MarkerTable random_table(int frames, int per_row, std::mt19937& random) {
  testing::MarkedFinger finger;
  finger.per_row = per_row;
  MarkerTable table;
  table.layouts.resize(frames, 4 * per_row);
  for (int i = 0; i < frames; ++i) {
    table.frames.push_back(2 * i);
    table.layouts.row(i) = finger.layout(testing::random_bend(random)).transpose();
    table.seen.emplace_back(static_cast<std::size_t>(2 * per_row), 1);
    table.seen.back()[static_cast<std::size_t>(i) % 4] = 0;
  }
  table.typical = finger.typical(testing::Bend{});
  return table;
}

TEST(MarkerTable, ComesBackAsItWasSaved) {
  std::mt19937 random(8);
  const MarkerTable table = random_table(7, 3, random);
  const fs::path file = scratch_folder("table") / "reference.csv";
  ASSERT_TRUE(table.save(file).ok());
  const auto again = MarkerTable::load(file, 6);
  ASSERT_TRUE(again.ok()) << again.error().sentence();
  EXPECT_EQ(again->frames, table.frames);
  EXPECT_EQ(again->seen, table.seen);
  EXPECT_EQ((again->layouts - table.layouts).cwiseAbs().maxCoeff(), 0.0);
  for (std::size_t m = 0; m < 6; ++m) {
    EXPECT_EQ(again->typical[m].radius_px, table.typical[m].radius_px);
    EXPECT_EQ(again->typical[m].contrast, table.typical[m].contrast);
  }
}

TEST(MarkerTable, EveryTruncationAndForeignValueIsAnErrorThatNamesTheFile) {
  std::mt19937 random(9);
  const fs::path folder = scratch_folder("truncated_table");
  const fs::path file = folder / "reference.csv";
  ASSERT_TRUE(random_table(2, 2, random).save(file).ok());
  const std::string whole = read_file(file).value();
  const auto load = [&](const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
    return MarkerTable::load(file, 4);
  };
  ASSERT_TRUE(load(whole).ok());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto result = load(whole.substr(0, size));
    ASSERT_FALSE(result.ok()) << "after " << size << " bytes";
    EXPECT_NE(result.error().sentence().find("reference.csv"), std::string::npos);
  }
  for (const auto& [good, bad] :
       std::vector<std::pair<std::string, std::string>>{{"\n0,0,", "\n0,1,"},
                                                        {"\n0,0,", "\n-1,0,"},
                                                        {"\n0,0,", "\n0,0,nan"},
                                                        {"\n0,1,", "\n0,1,1e9,"},
                                                        {"\n2,0,", "\n0,0,"},
                                                        {"end,2", "end,3"},
                                                        {"\n0,0,", "\n0,0,,"},
                                                        {"\n0,0,", "\n 0,0,"}}) {
    std::string text = whole;
    text.replace(text.find(good), good.size(), bad);
    EXPECT_FALSE(load(text).ok()) << bad;
  }
  EXPECT_FALSE(MarkerTable::load(folder / "none.csv", 4).ok());
  EXPECT_FALSE(MarkerTable::load(file, 0).ok());
}

TEST(ReferenceLibrary, ASinglePictureIsItsOwnReference) {
  cv::Mat grey(40, 60, CV_8UC1);
  cv::randu(grey, 0, 256);
  const auto library = ReferenceLibrary::single(grey);
  ASSERT_TRUE(library.ok());
  EXPECT_EQ(library->frame_count(), 1U);
  EXPECT_EQ(library->marker_model(), nullptr);
  const Reference reference = library->reference_for({}, ReferenceMethod::kLocal);
  cv::Mat as_float;
  grey.convertTo(as_float, CV_32F);
  EXPECT_EQ(cv::norm(reference.picture.grey(), as_float, cv::NORM_INF), 0.0);
  EXPECT_TRUE(cv::checkRange(reference.picture.grey()));
  EXPECT_TRUE(reference.known_pose);
  EXPECT_FALSE(ReferenceLibrary::single(cv::Mat()).ok());
}

}  // namespace
}  // namespace alltact
