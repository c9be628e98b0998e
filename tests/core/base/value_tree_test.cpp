// Foreign files as trees of values, and those that are none.
#include "core/base/value_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

std::string problem(std::string text) {
  const auto tree = parse_values(std::move(text), "file");
  return tree ? "" : tree.error().sentence();
}

/// On one line: {a: 1, b: [2, 3]}.
std::string shown(const ValueTree& tree) {
  std::string text = tree.key.empty() ? "" : tree.key + ": ";
  if (tree.kind == ValueTree::Kind::kText) return text + tree.text;
  text += tree.is_map() ? '{' : '[';
  for (const ValueTree& child : tree.children)
    text += (&child == &tree.children.front() ? "" : ", ") + shown(child);
  return text + (tree.is_map() ? '}' : ']');
}

TEST(ValueTree, IsTheSameForEverySyntax) {
  const std::string expected = "{a: 1.50, b: {c: [2, 3], d: x y}}";
  for (const char* text : {"a: 1.50\nb:\n  c:\n  - 2\n  - 3\n  d: x y\n",
                           "%YAML:1.0\n---\na: 1.50\nb: {c: [2, 3], d: x y}\n",
                           "\xEF\xBB\xBF{\"a\": 1.50, \"b\": {\"c\": [2, 3], \"d\": \"x y\"}}",
                           "# a comment\n{ 'a': 1.50, 'b': { 'c': [2, 3,], 'd': 'x y', }, }\n",
                           "<?xml version=\"1.0\"?>\n<opencv_storage>\n<a>1.50</a><!-- no -->\n<b "
                           "type_id=\"m\"><c><_>2"
                           "</_><_>3</_></c><d>x y</d></b>\n</opencv_storage>\n",
                           "a: &one 1.50\nb: {c: [2, 3], d: x y}\r\n---\n"}) {
    const auto tree = parse_values(text, "file");
    ASSERT_TRUE(tree) << tree.error().sentence() << text;
    EXPECT_EQ(shown(*tree), expected) << text;
  }
}

TEST(ValueTree, HoldsTagsLinesAndAliases) {
  const auto tree = parse_values("a: !!opencv-matrix\n  b: &x [1, 2]\nc: *x\n", "file");
  ASSERT_TRUE(tree) << tree.error().sentence();
  EXPECT_EQ(shown(*tree), "{a: {b: [1, 2]}, c: [1, 2]}");
  EXPECT_THAT(tree->find("a")->tag, HasSubstr("opencv-matrix"));
  EXPECT_EQ(tree->find("c")->line, 3);
  EXPECT_TRUE(parse_values("a:\n- 1\n- 25", "file")->find("a")->is_cut);
  EXPECT_FALSE(parse_values("a:\n- 1\n- 25\n", "file")->find("a")->is_cut);
  EXPECT_FALSE(parse_values("a: [1, 25]", "file")->find("a")->is_cut);
}

TEST(ValueTree, ReadsWhatMatlabPrints) {
  const auto tree = parse_values(
      "p = \n  cameraIntrinsics with properties:\n\n      FocalLength: [523.5 524.5]\n"
      "  ImageSize: [540 960]\n\nIntrinsicMatrix =\n\n   1.0e+03 *\n\n    0.5 0 0\n    0 0.5 0\n"
      "    0.25 0.125 0.001\n\nx.Radial = [1, 2; ...\n 3];\n",
      "file");
  ASSERT_TRUE(tree) << tree.error().sentence();
  EXPECT_EQ(tree->find("FocalLength")->text, "523.5 524.5");
  EXPECT_EQ(tree->find("ImageSize")->text, "540 960");
  EXPECT_THAT(tree->find("IntrinsicMatrix")->text, HasSubstr("500 0 0"));
  EXPECT_THAT(tree->find("IntrinsicMatrix")->text, HasSubstr("250 125 1"));
}

TEST(ValueTree, RefusesWithASentence) {
  EXPECT_THAT(problem("a: 1\nb: 2\na: 3\n"), HasSubstr("file:3: 'a' is given twice"));
  EXPECT_THAT(problem(R"({"a": 1, "a": 2})"), HasSubstr("'a' is given twice"));
  EXPECT_THAT(problem("a: [1, 2\n"), HasSubstr("this is not YAML"));
  EXPECT_THAT(problem("a: 1\n---\nb: 2\n"), HasSubstr("more than one document"));
  EXPECT_THAT(problem("<a><b></a>"), HasSubstr("this is not XML"));
  EXPECT_THAT(problem(std::string("a\0b", 3)), HasSubstr("is no text file"));
  const std::string deep(400, '[');
  EXPECT_NE(problem(deep + std::string(400, ']')), "");
  EXPECT_NE(problem("{\"a\": " + deep + std::string(400, ']') + "}"), "");
  std::string xml;
  for (int i = 0; i < 100'000; ++i) xml += "<a>";
  EXPECT_THAT(problem(xml), HasSubstr("too large"));
  std::string bomb = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 9; ++i) {
    bomb += fmt::format("a{0}: &a{0} [", i);
    for (int k = 0; k < 10; ++k) bomb += fmt::format("*a{}, ", i - 1);
    bomb += "]\n";
  }
  EXPECT_THAT(problem(bomb), HasSubstr("too large"));
}

}  // namespace
}  // namespace alltact
