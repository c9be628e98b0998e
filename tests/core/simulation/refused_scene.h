// Scenes with mistakes, and the sentences that they are refused with.
#pragma once

#include "tests/core/simulation/scene_text.h"

#include <initializer_list>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {

/// scene_text() with one block of keys for each effect, on line 10 and on.
inline std::string effects(std::initializer_list<const char*> blocks) {
  std::string text;
  for (const char* block : blocks) text += std::string("  - {") + block + "}\n";
  return scene_text(text);
}

/// A good scene in which one place is another.
inline std::string changed(const std::string& from, const std::string& to) {
  std::string text = scene_text("  - {use: quantisation}\n");
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

struct RefusedScene {
  std::string text;
  std::string sentence;  ///< from the line on; a list of all effects goes on after its first
};

inline void expect_refused(const std::vector<RefusedScene>& scenes) {
  for (const auto& [text, sentence] : scenes) {
    const std::string all = "test.yaml:" + sentence, got = refusal(text);
    if (sentence.ends_with("one of absorption"))
      EXPECT_THAT(got, testing::StartsWith(all)) << text;
    else
      EXPECT_EQ(got, all) << text;
  }
}

}  // namespace alltact
