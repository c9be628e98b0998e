#include "core/sensing/markers/dot_network.h"

#include "core/base/atomic_file.h"
#include "tests/support/onnx_bytes.h"
#include "tests/support/temporary_folder.h"

#include <array>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::OnnxBytes;
using test::Shape;
using ::testing::HasSubstr;

constexpr int kSide = 64, kCell = 8, kCells = kSide / kCell;

/// A detector as YOLO11 is exported, of one class: each cell of 8 x 8 px is a box of its own size
/// whose score is how bright it is on average. turned: [1, N, 5] instead of [1, 5, N].
OnnxBytes bright_cells(bool is_turned, float weight = 1.0F / (3 * kCell * kCell)) {
  std::vector<float> kernel(5 * 3 * kCell * kCell, 0.0F);
  for (std::size_t i = 4 * 3 * kCell * kCell; i < kernel.size(); ++i) kernel[i] = weight;
  std::vector<float> places(5 * kCells * kCells, 0.0F);
  for (int y = 0; y < kCells; ++y)
    for (int x = 0; x < kCells; ++x) {
      const auto at = [&](int channel) -> float& {
        return places[static_cast<std::size_t>((channel * kCells + y) * kCells + x)];
      };
      at(0) = static_cast<float>((x + 0.5) * kCell);
      at(1) = static_cast<float>((y + 0.5) * kCell);
      at(2) = at(3) = kCell;
    }
  OnnxBytes network;
  network.input("images", {1, 3, kSide, kSide})
      .weights("kernel", {5, 3, kCell, kCell}, kernel)
      .weights("places", {1, 5, kCells, kCells}, places)
      .sizes("flat", {1, 5, kCells * kCells})
      .node("Conv", {"images", "kernel"}, "cells",
            {{"kernel_shape", {kCell, kCell}}, {"strides", {kCell, kCell}}})
      .node("Add", {"cells", "places"}, "boxes");
  if (is_turned)
    network.node("Reshape", {"boxes", "flat"}, "rows")
        .node("Transpose", {"rows"}, "output0", {{"perm", {0, 2, 1}}})
        .output("output0", {1, kCells * kCells, 5});
  else
    network.node("Reshape", {"boxes", "flat"}, "output0")
        .output("output0", {1, 5, kCells * kCells});
  return network;
}

class DotNetworks : public ::testing::Test {
 protected:
  std::filesystem::path file(const std::string& bytes, const std::string& name = "network.onnx") {
    const auto path = folder_.path() / name;
    EXPECT_TRUE(write_file_atomically(path, bytes).ok());
    return path;
  }
  /// What load says of a network that it refuses.
  std::string refusal(const std::string& bytes) {
    const auto loaded = DotNetwork::load(file(bytes));
    if (loaded) return "it was taken";
    const Error& error = loaded.error();
    EXPECT_THAT(error.where.english(), HasSubstr("network"));
    EXPECT_FALSE(error.advice.empty()) << error.sentence();
    return error.what.english();
  }
  test::TemporaryFolder folder_;
};

TEST_F(DotNetworks, ReadsSizesFromTheFileItself) {
  const auto header = read_onnx_header(bright_cells(false).bytes(12), std::string("x"));
  ASSERT_TRUE(header.ok());
  ASSERT_EQ(header->inputs.size(), 1U);
  EXPECT_EQ(header->inputs[0].name, "images");
  EXPECT_EQ(header->inputs[0].shape, (Shape{1, 3, kSide, kSide}));
  ASSERT_EQ(header->outputs.size(), 1U);
  EXPECT_EQ(header->outputs[0].shape, (Shape{1, 5, kCells * kCells}));
  EXPECT_EQ(header->opset, 12);
}

// A picture twice as wide as high: the network sees it at half its size with grey above and below.
TEST_F(DotNetworks, DetectorsOfBothLayoutsGiveBoxesInThePicturesPixels) {
  for (const bool is_turned : {false, true}) {
    auto network = DotNetwork::load(file(bright_cells(is_turned).bytes()));
    ASSERT_TRUE(network.ok()) << network.error().sentence();
    cv::Mat grey(64, 128, CV_8UC1, cv::Scalar(0));
    grey(cv::Rect(32, 16, 16, 16)).setTo(255);  // cell (2, 3) of the network's picture
    grey(cv::Rect(96, 48, 16, 16)).setTo(200);  // cell (6, 5)
    const auto dots = (*network)(grey);
    ASSERT_TRUE(dots.ok()) << dots.error().sentence();
    std::vector<NetworkDot> inside;  // the padding is brighter than the least score
    for (const NetworkDot& dot : *dots)
      if (dot.v > 0 && dot.v < 63) inside.push_back(dot);
    ASSERT_EQ(inside.size(), 2U);
    EXPECT_NEAR(inside[0].u, 39.5, 1e-3);  // the middle of pixels 32 to 47
    EXPECT_NEAR(inside[0].v, 23.5, 1e-3);
    EXPECT_NEAR(inside[0].half_u, 8, 1e-3);
    EXPECT_NEAR(inside[0].half_v, 8, 1e-3);
    EXPECT_NEAR(inside[0].score, 1.0, 1e-4);
    EXPECT_NEAR(inside[1].u, 103.5, 1e-3);
    EXPECT_NEAR(inside[1].v, 55.5, 1e-3);
    EXPECT_NEAR(inside[1].score, 200.0 / 255.0, 1e-4);
  }
}

TEST_F(DotNetworks, TheSameNumbersWithAnyNumberOfThreads) {
  auto network = DotNetwork::load(file(bright_cells(false).bytes()));
  ASSERT_TRUE(network.ok());
  const cv::Mat grey = check_image({128, 64});
  const int before = cv::getNumThreads();
  std::vector<std::vector<NetworkDot>> all;
  for (const int threads : {1, 2, 5}) {
    cv::setNumThreads(threads);
    all.push_back((*network)(grey).value());
  }
  cv::setNumThreads(before);
  ASSERT_FALSE(all[0].empty());
  for (const auto& dots : all) {
    ASSERT_EQ(dots.size(), all[0].size());
    for (std::size_t i = 0; i < dots.size(); ++i) EXPECT_EQ(dots[i].score, all[0][i].score);
  }
}

TEST_F(DotNetworks, EveryTruncationIsRefusedWithASentence) {
  const std::string whole = bright_cells(false).bytes();
  for (std::size_t length = 0; length < whole.size(); length += 1 + length / 12)
    EXPECT_NE(refusal(whole.substr(0, length)), "it was taken") << length;
  EXPECT_THAT(refusal(whole.substr(0, whole.size() / 2)), HasSubstr("incomplete or damaged"));
  EXPECT_THAT(refusal("no network at all"), HasSubstr("not a network in the ONNX format"));
}

TEST_F(DotNetworks, BrokenBytesNeverEndTheProgram) {
  std::mt19937 random(41);
  const std::string whole = bright_cells(false).bytes();
  const std::size_t graph = whole.rfind("images");
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    std::string broken = whole;
    // Anywhere, and half of them where names and sizes stand and not weights.
    const std::size_t at =
        i % 2 ? random() % broken.size() : graph + random() % (whole.size() - graph);
    broken[at] = static_cast<char>(random());
    refused += refusal(broken) != "it was taken";
  }
  EXPECT_GT(refused, 20);
}

TEST_F(DotNetworks, WrongShapesAreSaid) {
  OnnxBytes open;
  open.input("images", {1, 3, 0, 0}).node("Relu", {"images"}, "out").output("out", {1, 3, 0, 0});
  EXPECT_THAT(refusal(open.bytes()), HasSubstr("takes 1 x 3 x ? x ?"));
  OnnxBytes batch;
  batch.input("images", {8, 3, 64, 64})
      .node("Relu", {"images"}, "out")
      .output("out", {8, 3, 64, 64});
  EXPECT_THAT(refusal(batch.bytes()), HasSubstr("takes 8 x 3 x 64 x 64"));
  OnnxBytes huge;
  huge.input("images", {1, 3, 64, 1 << 20})
      .node("Relu", {"images"}, "out")
      .output("out", {1, 3, 64, 1 << 20});
  EXPECT_THAT(refusal(huge.bytes()), HasSubstr("32 to 4096 px"));
  // A network that makes pictures of pictures is no detector.
  OnnxBytes image;
  image.input("images", {1, 3, 64, 64})
      .node("Relu", {"images"}, "out")
      .output("out", {1, 3, 64, 64});
  EXPECT_THAT(refusal(image.bytes()), HasSubstr("outputs 1 x 3 x 64 x 64 for 1 x 3 x 64 x 64"));
}

TEST_F(DotNetworks, LayersThatOpenCvDoesNotKnowAreSaid) {
  OnnxBytes strange;
  strange.input("images", {1, 3, 64, 64})
      .node("NoSuchLayer", {"images"}, "out")
      .output("out", {1, 5, 64});
  EXPECT_THAT(refusal(strange.bytes(17)), HasSubstr("opset 17"));
}

TEST_F(DotNetworks, NumbersThatAreNotFiniteAreSaid) {
  EXPECT_THAT(refusal(bright_cells(false, std::nanf("")).bytes()), HasSubstr("not finite"));
  EXPECT_THAT(refusal(bright_cells(false, INFINITY).bytes()), HasSubstr("not finite"));
  // Nor in a frame, where the picture that it was tried on gave none: 1e38 times a bright picture.
  auto network = DotNetwork::load(file(bright_cells(false, 2e36F).bytes()));
  ASSERT_TRUE(network.ok()) << network.error().sentence();
  const auto dots = (*network)(cv::Mat(64, 64, CV_8UC1, cv::Scalar(255)));
  ASSERT_FALSE(dots.ok());
  EXPECT_THAT(dots.error().what.english(), HasSubstr("not finite"));
}

std::string check_text(const std::vector<double>& output, double tolerance) {
  std::string text =
      "picture: [64, 64]\nevery: 32\ntolerance: " + std::to_string(tolerance) + "\noutput: [";
  for (const double value : output) text += std::to_string(value) + ", ";
  return text + "]\n";
}

TEST_F(DotNetworks, WhatItMustGiveIsHeldAgainstWhatItGives) {
  const auto onnx = file(bright_cells(false).bytes());
  // By hand: of the first row of numbers the middles of cells 0 and 32, and so on; scores are means
  // of the known picture.
  const cv::Mat grey = check_image({64, 64});
  std::vector<double> output;
  for (int i = 0; i < 5 * kCells * kCells; i += 32) {
    const int channel = i / 64, x = i % 8, y = i / 8 % 8;
    const cv::Rect cell(kCell * x, kCell * y, kCell, kCell);
    const std::array<double, 5> values{(x + 0.5) * kCell, (y + 0.5) * kCell, kCell, kCell,
                                       cv::mean(grey(cell))[0] / 255.0};
    output.push_back(values[static_cast<std::size_t>(channel)]);
  }
  file(check_text(output, 1e-4), "network.yaml");
  EXPECT_TRUE(DotNetwork::load(onnx).ok()) << DotNetwork::load(onnx).error().sentence();
  output[8] += 0.01;
  file(check_text(output, 1e-4), "network.yaml");
  auto refused = DotNetwork::load(onnx);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().what.english(), HasSubstr("deviate by up to 0.01"));
  output.pop_back();
  file(check_text(output, 1e-4), "network.yaml");
  refused = DotNetwork::load(onnx);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().what.english(), HasSubstr("10 numbers where its .yaml has 9"));
  file("every: 0\n", "network.yaml");
  EXPECT_FALSE(DotNetwork::load(onnx).ok());
}

TEST(SeenDots, PeaksOfTheNetworksOwnOutput) {
  const std::array<int, 4> shape{1, 3, 20, 30};
  cv::Mat output(4, shape.data(), CV_32F, cv::Scalar(-6));
  const auto at = [&](int c, int y, int x) -> float& {
    return output.ptr<float>(0, c)[y * 30 + x];
  };
  // A parabola whose top lies a quarter of a cell to the right of (10, 5).
  for (int dx = -1; dx <= 1; ++dx)
    for (int dy = -1; dy <= 1; ++dy)
      at(0, 5 + dy, 10 + dx) = static_cast<float>(3 - std::pow(dx - 0.25, 2) - dy * dy);
  at(1, 5, 10) = std::log(6.0F), at(2, 5, 10) = std::log(3.0F);
  at(0, 5, 14) = 0.0F;  // 4 cells on: another, less sure
  at(1, 5, 14) = at(2, 5, 14) = std::log(2.0F);
  at(0, 19, 29) = -2.5F;  // too unsure
  InputMap laid;
  ASSERT_EQ(dots_input(cv::Mat(160, 1920, CV_8UC1, cv::Scalar(64)), &laid).size[3], 960);
  const auto dots = dots_of(output, laid);
  ASSERT_EQ(dots.size(), 2U);
  // Cells of 4 px in a picture half as large: pixel 2 k + 0.5 of the large one.
  EXPECT_NEAR(dots[0].u, 2 * 4 * 10.25 + 0.5, 1e-4);
  EXPECT_NEAR(dots[0].v, 2 * 4 * 5 + 0.5, 1e-4);
  EXPECT_NEAR(dots[0].half_u, 12, 1e-4);
  EXPECT_NEAR(dots[0].half_v, 6, 1e-4);
  EXPECT_NEAR(dots[0].score, 1 / (1 + std::exp(-(3 - 0.0625))), 1e-6);
  EXPECT_NEAR(dots[1].u, 2 * 4 * 14 + 0.5, 1e-4);
}

TEST(SeenDots, OfOverlappingBoxesTheSurestIsKept) {
  const std::array<int, 3> shape{1, 6, 7};  // two classes
  cv::Mat output(3, shape.data(), CV_32F, cv::Scalar(0));
  const auto box = [&](int i, float u, float v, float size, float one, float two) {
    const std::array<float, 6> values{u, v, size, size, one, two};
    for (std::size_t n = 0; n < 6; ++n)
      output.ptr<float>()[n * 7 + static_cast<std::size_t>(i)] = values[n];
  };
  box(0, 20, 20, 10, 0.4F, 0.1F);
  box(1, 21, 20, 10, 0.1F, 0.9F);  // shares 9/11 with the first
  box(2, 27, 20, 10, 0.5F, 0.0F);  // 4/16 with that
  box(3, 60, 20, -3, 0.9F, 0.9F);  // no box
  box(4, 80, 20, 10, 0.2F, 0.2F);  // too unsure
  const auto dots = boxes_of(output, InputMap{});
  ASSERT_EQ(dots.size(), 2U);
  EXPECT_EQ(dots[0].u, 21);
  EXPECT_NEAR(dots[0].score, 0.9, 1e-6);
  EXPECT_EQ(dots[1].u, 27);
}

}  // namespace
}  // namespace alltact
