#include "core/sensing/face/face_edges.h"

#include "tests/support/synthetic_face.h"

#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::SyntheticFace;

/// A face that narrows from base to tip, of random size, sway and side.
SyntheticFace random_face(std::mt19937& engine) {
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  SyntheticFace face;
  if (engine() % 3 == 0) face.width = 1280, face.height = 720;
  const double scale = face.width / 960.0;
  const double wide = draw(380, 460) * scale, narrow = draw(90, 160) * scale;
  const double sway = draw(-40, 40) * scale, bow = draw(-0.3, 0.3);
  const bool mirrored = engine() % 2 == 0;
  const double w = face.width, middle = 0.5 * face.height;
  const auto part = [=](double u) { return mirrored ? 1.0 - u / w : u / w; };
  const auto half = [=](double u) {
    const double t = part(u);
    return 0.5 / ((1.0 - t) / wide + t / narrow + bow * t * (1.0 - t) / wide);
  };
  face.upper = [=](double u) { return middle + sway * part(u) * part(u) - half(u); };
  face.lower = [=](double u) { return middle + sway * part(u) * part(u) + half(u); };
  const double near = draw(120, 220), far = draw(35, 70);
  face.bright = [=](double u) { return near + (far - near) * part(u); };
  face.beside = draw(4, 20);
  face.blur_px = draw(0.0, 1.5);
  return face;
}

struct Errors {
  double bias = 0, rms = 0;
  int count = 0, valid = 0;
};

Errors errors(const FaceEdges& edges, const Edge& edge,
              const std::function<double(double)>& truth) {
  Errors e;
  for (std::size_t i = 0; i < edges.u.size(); ++i) {
    ++e.count;
    if (!edge.valid[i]) continue;
    ++e.valid;
    const double error = edge.v[i] - truth(edges.u[i]);
    e.bias += error;
    e.rms += error * error;
  }
  e.bias /= std::max(e.valid, 1);
  e.rms = std::sqrt(e.rms / std::max(e.valid, 1));
  return e;
}

TEST(FaceEdges, AreFoundToAFewHundredthsOfAPixel) {
  std::mt19937 engine(5);
  for (unsigned run = 0; run < 12; ++run) {
    const SyntheticFace face = random_face(engine);
    const auto edges = FaceEdgeFinder()(face.draw(run));
    ASSERT_TRUE(edges.ok()) << edges.error().sentence();
    EXPECT_TRUE(edges->bright_inside);
    for (const auto& [edge, truth] :
         {std::pair{&edges->upper, &face.upper}, {&edges->lower, &face.lower}}) {
      const Errors e = errors(*edges, *edge, *truth);
      EXPECT_GT(e.valid, 0.95 * e.count) << "run " << run;
      EXPECT_LT(e.rms, 0.08) << "run " << run;
      EXPECT_LT(std::abs(e.bias), 0.03) << "run " << run;  // 0.02 mm of z at the tip
    }
  }
}

// A hundredth of a pixel of bias is as much in z as a tenth of a pixel of noise along 100 samples.
TEST(FaceEdges, NeitherBlurNorLightThatFallsAcrossTheFaceMovesThem) {
  const double upper = 120.3, lean = 0.21, lower = 415.6;
  for (const double blur : {0.6, 0.8, 1.2, 1.6, 2.2}) {
    for (const double fall : {0.0, 0.25}) {  // of the brightness, over 100 rows
      cv::Mat image(540, 960, CV_8UC1);
      std::mt19937 engine(51);
      std::normal_distribution<double> noise(0.0, 1.0);
      for (int v = 0; v < image.rows; ++v)
        for (int u = 0; u < image.cols; ++u) {
          const double top = v - upper - lean * (u - 480) * 0.3, bottom = lower - v;
          const double within =
              0.5 * (std::erf(top / (M_SQRT2 * blur)) + std::erf(bottom / (M_SQRT2 * blur)));
          const double level = 150.0 * (1.0 - fall * (v - 270) / 100.0);
          image.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(
              std::lround(25.0 + (level - 25.0) * within + noise(engine)));
        }
      const auto edges = FaceEdgeFinder()(image);
      ASSERT_TRUE(edges.ok()) << edges.error().sentence();
      const Errors above =
          errors(*edges, edges->upper, [&](double u) { return upper + lean * (u - 480) * 0.3; });
      const Errors below = errors(*edges, edges->lower, [&](double) { return lower; });
      for (const Errors& e : {above, below}) {
        EXPECT_GT(e.valid, 0.95 * e.count) << "blur " << blur << " fall " << fall;
        EXPECT_LT(std::abs(e.bias), 0.025) << "blur " << blur << " fall " << fall;
      }
    }
  }
}

// At the very end of an edge a dot would have the most leverage.
TEST(FaceEdges, DotsThatTouchThemAreLeftOut) {
  std::mt19937 engine(52);
  for (unsigned run = 0; run < 4; ++run) {
    const SyntheticFace face = random_face(engine);
    cv::Mat image = face.draw(run);
    for (int dot = 0; dot < 7; ++dot) {
      const int u = (2 * dot + 1) * face.width / 14;
      for (const double v : {face.upper(u) - 6.0, face.lower(u) + 6.0})
        cv::circle(image, {u, static_cast<int>(std::lround(v))}, 5, cv::Scalar(110), -1);
    }
    const auto edges = FaceEdgeFinder()(image);
    ASSERT_TRUE(edges.ok());
    for (const auto& [edge, truth] :
         {std::pair{&edges->upper, &face.upper}, {&edges->lower, &face.lower}}) {
      const Errors e = errors(*edges, *edge, *truth);
      EXPECT_GT(e.valid, 0.7 * e.count) << "run " << run;
      EXPECT_LT(e.rms, 0.1) << "run " << run;
    }
  }
}

TEST(FaceEdges, DotsThatStandCloseLeaveRoomForThemInBetween) {
  std::mt19937 engine(53);
  for (unsigned run = 0; run < 4; ++run) {
    SyntheticFace face = random_face(engine);
    face.beside = 15.0;
    cv::Mat image = face.draw(run);
    for (int u = 10; u < face.width; u += 19)
      for (const double v : {face.upper(u) - 8.0, face.lower(u) + 8.0})
        cv::circle(image, {u, static_cast<int>(std::lround(v))}, 4, cv::Scalar(70), -1);
    const auto edges = FaceEdgeFinder()(image);
    ASSERT_TRUE(edges.ok()) << "run " << run;
    for (const auto& [edge, truth] :
         {std::pair{&edges->upper, &face.upper}, {&edges->lower, &face.lower}}) {
      const Errors e = errors(*edges, *edge, *truth);
      EXPECT_GT(e.valid, 0.3 * e.count) << "run " << run;
      EXPECT_LT(e.rms, 0.45) << "run " << run;  // dots this near reach into every sample
    }
  }
}

// A table that reflects a little light shows two edges as well, of a few grey levels.
TEST(FaceEdges, WhatGlimmersBeyondTheTipIsNoPartOfTheFace) {
  std::mt19937 engine(54);
  for (unsigned run = 0; run < 12; ++run) {
    SyntheticFace face = random_face(engine);
    face.beside = 6.0, face.noise_sd = 0.7;
    const bool base_at_low_u =
        face.lower(0) - face.upper(0) > face.lower(face.width) - face.upper(face.width);
    const int tip = face.width * (base_at_low_u ? 4 : 1) / 5;
    (base_at_low_u ? face.last_u : face.first_u) = tip;
    cv::Mat image = face.draw(run);
    const int middle = static_cast<int>(0.5 * (face.upper(tip) + face.lower(tip)));
    const cv::Range beyond =
        base_at_low_u ? cv::Range(tip + 12, face.width) : cv::Range(0, tip - 12);
    image(cv::Range(middle - 30, middle + 30), beyond) += cv::Scalar(4);
    const auto edges = FaceEdgeFinder()(image);
    ASSERT_TRUE(edges.ok()) << "run " << run;
    for (const auto& [edge, truth] :
         {std::pair{&edges->upper, &face.upper}, {&edges->lower, &face.lower}}) {
      const Errors e = errors(*edges, *edge, *truth);
      EXPECT_GT(e.valid, 0.75 * e.count) << "run " << run;
      EXPECT_LT(e.rms, 0.1) << "run " << run;
    }
  }
}

// Little light arrives at a tip: the face is hardly brighter than the sides there, and both darken.
TEST(FaceEdges, AreFollowedToADarkTip) {
  Errors at_tip;
  for (unsigned run = 0; run < 12; ++run) {
    SyntheticFace face;
    face.upper = [](double u) { return 120 + 0.12 * u; };
    face.lower = [](double u) { return 420 - 0.12 * u; };
    face.last_u = 900, face.beside = 12, face.noise_sd = 1.5, face.blur_px = 0.1 * run;
    face.bright = [&](double u) {
      return face.beside + 3.5 + 0.01 * (900 - u) + 0.1 * std::max(0.0, 700 - u);
    };
    cv::Mat image = face.draw(run);
    for (int u = 0; u < 900; ++u) image.col(u) += cv::Scalar(std::floor(0.11 * (900 - u) + 0.5));
    const auto edges = FaceEdgeFinder()(image);
    ASSERT_TRUE(edges.ok()) << "run " << run;
    for (std::size_t i = 0; i < edges->u.size(); ++i) {
      const double u = edges->u[i];
      if (u < 800 || u > 890) continue;
      at_tip.count += 2;
      for (const auto& [edge, truth] :
           {std::pair{&edges->upper, &face.upper}, {&edges->lower, &face.lower}}) {
        if (!edge->valid[i]) continue;
        ++at_tip.valid;
        at_tip.rms += std::pow(edge->v[i] - (*truth)(u), 2);
      }
    }
  }
  at_tip.rms = std::sqrt(at_tip.rms / std::max(1, at_tip.valid));
  EXPECT_GT(at_tip.valid, 0.7 * at_tip.count) << at_tip.count;
  EXPECT_LT(at_tip.rms, 0.8);
}

TEST(FaceEdges, IntegerStepIsThePapersFloor) {
  std::mt19937 engine(6);
  const SyntheticFace face = random_face(engine);
  const auto edges = FaceEdgeFinder({EdgeMethod::kInteger, 1})(face.draw(1));
  ASSERT_TRUE(edges.ok());
  const Errors e = errors(*edges, edges->upper, face.upper);
  EXPECT_GT(e.rms, 0.2);
  EXPECT_LT(e.rms, 0.8);
}

TEST(FaceEdges, NothingIsInventedBeyondTheTip) {
  std::mt19937 engine(7);
  SyntheticFace face = random_face(engine);
  face.first_u = 80, face.last_u = 700;
  const auto edges = FaceEdgeFinder()(face.draw(3));
  ASSERT_TRUE(edges.ok());
  for (std::size_t i = 0; i < edges->u.size(); ++i) {
    if (edges->u[i] < 74 || edges->u[i] > 706) {
      EXPECT_FALSE(edges->upper.valid[i]) << edges->u[i];
      EXPECT_FALSE(edges->lower.valid[i]) << edges->u[i];
    }
  }
}

TEST(FaceEdges, TheOuterBorderOfABrightSideFaceIsNotTheEdge) {
  // towards the tip the side face is half as bright as the face, and black lies close beyond it
  std::mt19937 engine(21);
  for (unsigned run = 0; run < 6; ++run) {
    SyntheticFace face = random_face(engine);
    face.bright = [](double) { return 48.0; };
    face.beside = 24.0;
    cv::Mat image = face.draw(run);
    for (int v = 0; v < image.rows; ++v) {
      for (int u = 0; u < image.cols; ++u) {
        const double side = 14.0 * image.cols / 960.0;
        if (v < face.upper(u) - side || v > face.lower(u) + side)
          image.at<std::uint8_t>(v, u) /= 16;
      }
    }
    const auto edges = FaceEdgeFinder()(image);
    ASSERT_TRUE(edges.ok()) << edges.error().sentence();
    EXPECT_LT(errors(*edges, edges->upper, face.upper).rms, 0.2) << "run " << run;
    EXPECT_LT(errors(*edges, edges->lower, face.lower).rms, 0.2) << "run " << run;
  }
}

/// Grows wide side faces, lit evenly, with bright or dark dots on them, and black beyond.
void light_side_faces(const SyntheticFace& face, double part, bool bright_dots, cv::Mat& image) {
  for (int u = 0; u < image.cols; ++u) {
    const double side = part * (face.lower(u) - face.upper(u));
    for (int v = 0; v < image.rows; ++v)
      if (v < face.upper(u) - side || v > face.lower(u) + side) image.at<std::uint8_t>(v, u) /= 6;
  }
  for (double at = 0.3; at < 0.75; at += 0.1) {
    const double u = at * image.cols, half = 0.5 * part * (face.lower(u) - face.upper(u));
    const double radius = 0.5 * half;
    for (const double v : {face.upper(u) - half, face.lower(u) + half})
      cv::circle(image, {static_cast<int>(u), static_cast<int>(v)}, static_cast<int>(radius),
                 bright_dots ? cv::Scalar(190) : cv::Scalar(15), cv::FILLED);
  }
}

TEST(FaceEdges, WideSideFacesThatAreLitAreNoPartOfTheFace) {
  // Their outer borders have more contrast than the face's edges along the whole finger, or from
  // the middle to the tip.
  std::mt19937 engine(22);
  for (unsigned run = 0; run < 24; ++run) {
    SyntheticFace face = random_face(engine);
    const double part = std::uniform_real_distribution<double>(0.12, 0.22)(engine);
    const bool base_at_low_u =
        face.lower(0) - face.upper(0) > face.lower(face.width) - face.upper(face.width);
    const double near = run % 2 == 0 ? 190.0 : 130.0, far = run % 2 == 0 ? 105.0 : 90.0;
    face.bright = [=, w = face.width](double u) {
      const double t = base_at_low_u ? u / w : 1.0 - u / w;
      return near + (far - near) * t;
    };
    face.beside = 60.0;
    cv::Mat image = face.draw(run);
    light_side_faces(face, part, run % 4 < 2, image);
    // Something presses on the face.
    const double u = 0.6 * face.width, v = 0.5 * (face.upper(u) + face.lower(u));
    cv::circle(image, {static_cast<int>(u), static_cast<int>(v)}, 25, cv::Scalar(50), cv::FILLED);
    const auto edges = FaceEdgeFinder()(image);
    ASSERT_TRUE(edges.ok()) << "run " << run;
    for (const auto& [edge, truth] :
         {std::pair{&edges->upper, &face.upper}, {&edges->lower, &face.lower}}) {
      const Errors e = errors(*edges, *edge, *truth);
      EXPECT_GT(e.valid, 0.9 * e.count) << "run " << run;
      EXPECT_LT(e.rms, 0.3) << "run " << run;
    }
  }
}

TEST(FaceEdges, AFaceDarkerThanItsSurroundingsIsAFaceToo) {
  std::mt19937 engine(8);
  SyntheticFace face = random_face(engine);
  face.bright = [](double) { return 60.0; };
  face.beside = 160.0;
  const auto edges = FaceEdgeFinder()(face.draw(4));
  ASSERT_TRUE(edges.ok());
  EXPECT_FALSE(edges->bright_inside);
  EXPECT_LT(errors(*edges, edges->lower, face.lower).rms, 0.08);
}

TEST(FaceEdges, APictureWithoutAFaceIsRefused) {
  cv::Mat noise(540, 960, CV_8UC1);
  cv::RNG random(3);
  random.fill(noise, cv::RNG::NORMAL, 90, 2);
  EXPECT_FALSE(FaceEdgeFinder()(noise).ok());
  EXPECT_FALSE(FaceEdgeFinder()(cv::Mat(540, 960, CV_8UC1, cv::Scalar(0))).ok());
  EXPECT_FALSE(FaceEdgeFinder()(cv::Mat(16, 16, CV_8UC1, cv::Scalar(200))).ok());
}

}  // namespace
}  // namespace alltact
