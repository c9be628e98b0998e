#include "core/simulation/noise.h"
#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(FixedPattern, IsEveryPixelsOwnGainAndOffset) {
  Parameters random(15);
  const cv::Mat_<float> plain = rendered(scene_text(kFaceAndLamps));
  const RowNoise gains("fixed-pattern.prnu"), offsets("fixed-pattern.dsnu");
  std::vector<float> n(320), m(320);
  for (int i = 0; i < 3; ++i) {
    const double prnu = random.between(0.001, 0.1), dsnu = random.between(0.1, 3);
    const Plan plan = plan_of(
        scene_text(kFaceAndLamps +
                   fmt::format("  - {{use: fixed-pattern, prnu: {}, dsnu: {}}}\n", prnu, dsnu)));
    const cv::Mat_<float> got = plan.render(0);
    for (int v = 0; v < got.rows; v += 7) {
      gains.normals(effect_seed(), 0, v, 320, n.data());
      offsets.normals(effect_seed(), 0, v, 320, m.data());
      for (int u = 0; u < got.cols; ++u) {
        const auto k = static_cast<std::size_t>(u);
        EXPECT_NEAR(got(v, u), plain(v, u) * (1 + prnu * n[k]) + dsnu * m[k], 1e-4);
      }
    }
    EXPECT_EQ(cv::norm(got, plan.render(2, 3), cv::NORM_INF), 0);  // the same in all frames
  }
}

TEST(FixedPattern, HasTheVariancesItSays) {
  for (const auto& [what, sd] : {std::pair("prnu: 0.05", 0.05), std::pair("dsnu: 2", 2.0)}) {
    Moments draws;
    for (const float value :
         rendered(million_text(fmt::format("  - {{use: fixed-pattern, {}}}\n", what))))
      draws.add(value);
    expect_normal(draws, 1, sd);
  }
  EXPECT_THAT(refusal(million_text("  - {use: fixed-pattern}\n")),
              HasSubstr("neither prnu nor dsnu"));
}

}  // namespace
}  // namespace alltact
