// What is kept of a recording: the same comes back, and nothing else does.
#include "core/base/atomic_file.h"
#include "core/sensing/reference/recorded_faces.h"
#include "tests/support/temporary_folder.h"

#include <random>
#include <sstream>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

FaceEdges some_edges(std::mt19937& random) {
  std::normal_distribution<double> normal(100.0, 30.0);
  FaceEdges edges;
  for (int i = 0; i < 5; ++i) {
    edges.u.push_back(8.0 * i + 3.5);
    for (Edge* edge : {&edges.upper, &edges.lower}) {
      edge->v.push_back(normal(random));
      edge->sd.push_back(0.02 * i);
      edge->valid.push_back(i != 2);
    }
  }
  edges.ends.last = FaceEnd{normal(random), 135.0, 0.01, -1e-5, 0.3};
  edges.noise_sd = 1.25;
  edges.bright_inside = false;
  return edges;
}

FaceCache some_faces() {
  std::mt19937 random(7);
  FaceCache faces;
  for (const std::size_t row : {0U, 2U, 3U}) faces.found.push_back({row, some_edges(random)});
  faces.retained = {0, 3};
  faces.faces = {{1, 6, {9, 8, 7, 6, 5}}, {0, 8, {1, 2, 3, 0, 255}}};
  faces.error.relative_sd = (cv::Mat_<float>(2, 3) << 0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F);
  faces.error.typical_reach_px2 = 3.75;
  return faces;
}

void expect_same(const Edge& a, const Edge& b) {
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.sd, b.sd);
  EXPECT_EQ(a.valid, b.valid);
}

void expect_same(const FaceCache& a, const FaceCache& b) {
  ASSERT_EQ(a.found.size(), b.found.size());
  for (std::size_t i = 0; i < a.found.size(); ++i) {
    const FaceEdges &one = a.found[i].edges, &other = b.found[i].edges;
    EXPECT_EQ(a.found[i].row, b.found[i].row);
    EXPECT_EQ(one.u, other.u);
    expect_same(one.upper, other.upper);
    expect_same(one.lower, other.lower);
    EXPECT_EQ(one.ends.first.has_value(), other.ends.first.has_value());
    ASSERT_TRUE(one.ends.last && other.ends.last);
    EXPECT_EQ(one.ends.last->u_px, other.ends.last->u_px);
    EXPECT_EQ(one.ends.last->bow_per_px, other.ends.last->bow_per_px);
    EXPECT_EQ(one.noise_sd, other.noise_sd);
    EXPECT_EQ(one.bright_inside, other.bright_inside);
  }
  EXPECT_EQ(a.retained, b.retained);
  ASSERT_EQ(a.faces.size(), b.faces.size());
  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    EXPECT_EQ(a.faces[i].first, b.faces[i].first);
    EXPECT_EQ(a.faces[i].end, b.faces[i].end);
    EXPECT_EQ(a.faces[i].grey, b.faces[i].grey);
  }
  ASSERT_EQ(a.error.relative_sd.size(), b.error.relative_sd.size());
  EXPECT_EQ(cv::norm(a.error.relative_sd, b.error.relative_sd, cv::NORM_INF), 0.0);
  EXPECT_EQ(a.error.typical_reach_px2, b.error.typical_reach_px2);
}

std::optional<FaceCache> unpacked(const std::string& bytes, const std::string& made_from) {
  std::istringstream file(bytes);
  return unpack_faces(file, bytes.size(), made_from);
}

class KeptFacesTest : public testing::Test {
 protected:
  [[nodiscard]] std::vector<fs::path> files() const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder_.path())) files.push_back(entry.path());
    return files;
  }
  TemporaryFolder folder_;
};

TEST_F(KeptFacesTest, ComeBackAsTheyWere) {
  const FaceCache faces = some_faces();
  ASSERT_TRUE(save_faces(folder_.path(), "a video, a camera", faces));
  const auto back = load_faces(folder_.path(), "a video, a camera");
  ASSERT_TRUE(back);
  expect_same(faces, *back);
}

TEST_F(KeptFacesTest, AreThoseOfNothingElse) {
  ASSERT_TRUE(save_faces(folder_.path(), "a video", some_faces()));
  EXPECT_FALSE(load_faces(folder_.path(), "another video"));
  // Even where the names of two would come to the same.
  const std::string bytes = read_file(files().front()).value();
  EXPECT_TRUE(unpacked(bytes, "a video"));
  EXPECT_FALSE(unpacked(bytes, "another"));
}

TEST_F(KeptFacesTest, AreNotTakenWhereAnyBitHasChanged) {
  ASSERT_TRUE(save_faces(folder_.path(), "a", some_faces()));
  const std::string bytes = read_file(files().front()).value();
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ (1 << (at % 8)));
    EXPECT_FALSE(unpacked(changed, "a")) << at;
    EXPECT_FALSE(unpacked(bytes.substr(0, at), "a")) << at;
  }
  EXPECT_FALSE(unpacked(bytes + '\0', "a"));
}

TEST_F(KeptFacesTest, AskForNoMoreMemoryThanTheirFileHolds) {
  const std::string bytes = pack_faces(some_faces(), "a");
  for (std::size_t at = 0; at + 8 <= bytes.size(); ++at) {
    std::string lies = bytes;
    for (std::size_t k = at; k < at + 8; ++k) lies[k] = static_cast<char>(0x7f);
    EXPECT_FALSE(unpacked(lies, "a")) << at;  // no bad_alloc, no crash
  }
}

TEST_F(KeptFacesTest, LeaveAlwaysTheEightThatWereUsedLast) {
  for (int i = 0; i < 8; ++i)
    ASSERT_TRUE(save_faces(folder_.path(), std::to_string(i), some_faces()));
  for (const fs::path& file : files())
    fs::last_write_time(file, fs::last_write_time(file) - std::chrono::hours(1));
  ASSERT_TRUE(load_faces(folder_.path(), "3"));
  for (int i = 10; i < 17; ++i)
    ASSERT_TRUE(save_faces(folder_.path(), std::to_string(i), some_faces()));
  EXPECT_EQ(files().size(), 8U);
  EXPECT_TRUE(load_faces(folder_.path(), "3"));
  EXPECT_FALSE(load_faces(folder_.path(), "4"));
}

TEST_F(KeptFacesTest, SayWhereTheyCannotBeWritten) {
  const fs::path file = folder_ / "file";
  ASSERT_TRUE(write_file_unsynced(file, "x"));
  const Status refused = save_faces(file, "a", some_faces());
  ASSERT_FALSE(refused);
  EXPECT_FALSE(refused.error().sentence().empty());
  EXPECT_FALSE(load_faces(file, "a"));
}

}  // namespace
}  // namespace alltact::test
