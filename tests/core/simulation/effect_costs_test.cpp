// Every kind of effect by its own example: what it costs, and what must hold of all of them.
#include "core/simulation/effect_catalogue.h"
#include "tests/core/simulation/scene_text.h"

#include <cstring>
#include <set>

#include <gtest/gtest.h>

namespace alltact {
namespace {

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

TEST(EffectCosts, ListEveryKindThereIsInTheOrderTheyRun) {
  const auto costs = measure_effect_costs(1, Job());
  ASSERT_TRUE(costs) << costs.error().sentence();
  std::set<std::string> listed, all;
  for (const EffectKind* kind : effect_kinds()) all.insert(kind->name);
  for (const EffectCost& cost : *costs) {
    listed.insert(cost.kind->name);
    EXPECT_TRUE(std::isfinite(cost.ms_per_megapixel));
  }
  EXPECT_EQ(listed, all);
  EXPECT_EQ(costs->size(), all.size());
  for (std::size_t i = 1; i < costs->size(); ++i) {
    const EffectKind &a = *(*costs)[i - 1].kind, &b = *(*costs)[i].kind;
    EXPECT_LE(std::pair(a.stage, a.rank), std::pair(b.stage, b.rank)) << b.name;
  }
}

TEST(EffectCosts, CanBeStopped) {
  Job job;
  job.request_stop();
  EXPECT_FALSE(measure_effect_costs(1, job));
}

TEST(EffectExample, IsTheEffectAndShowsIt) {
  for (const EffectKind* kind : effect_kinds()) {
    SCOPED_TRACE(kind->name);
    const Plan with = plan_of(example_scene({kind->name}));
    const Plan without = plan_of(example_scene({kind->name}, kind->name));
    const auto named = with.effects();
    EXPECT_EQ(std::count(named.begin(), named.end(), kind->name), 1);
    EXPECT_EQ(without.effects().size() + 1, named.size());
    const bool is_of_time = kind->name == "drop" || kind->name == "late";
    bool differs = false;
    for (const int frame : {1, 13}) differs |= !same(with.render(frame), without.render(frame));
    EXPECT_EQ(differs, !is_of_time);
  }
}

// Frames of all examples: the same bytes with any number of threads and in any order.
TEST(EffectExample, DependsOnNoThreadsAndNoOrder) {
  for (const EffectKind* kind : effect_kinds()) {
    SCOPED_TRACE(kind->name);
    const std::string text = example_scene({kind->name});
    const Plan plan = plan_of(text), again = plan_of(text);
    const cv::Mat first = plan.render(0), second = plan.render(5);
    EXPECT_TRUE(same(again.render(5, 3), second));
    EXPECT_TRUE(same(again.render(0, 2), first));
  }
}

TEST(EffectExample, AllOfThemGoTogether) {
  // The example of rolloff is Hertz', which is for balls only.
  const std::set<std::string_view> bodies{"relief", "cylinder", "edge", "punch", "mesh"};
  std::vector<std::string_view> names;
  for (const EffectKind* kind : effect_kinds())
    if (!bodies.contains(kind->name) && kind->instead_of.empty()) names.push_back(kind->name);
  const Plan plan = plan_of(example_scene(names));
  EXPECT_EQ(plan.effects().size(), names.size());
  const cv::Mat image = plan.render(3, 2);
  EXPECT_TRUE(same(plan.render(3), image));
  cv::Scalar mean, deviation;
  cv::meanStdDev(image, mean, deviation);
  EXPECT_GT(deviation[0], 5);
}

}  // namespace
}  // namespace alltact
