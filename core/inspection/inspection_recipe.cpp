#include "core/inspection/inspection_recipe.h"

#include "core/base/atomic_file.h"
#include "core/base/fields.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr Limits kPosition_mm{-10000, 10000};
constexpr Limits kLambda_mm{0.001, 1000};
constexpr std::size_t kMostReadings = 1000;

EnumWords measurand_words() {
  EnumWords words;
  for (const Measurand measurand : all_measurands()) words.push_back(to_string(measurand));
  return words;
}

}  // namespace

static void describe(Fields& fields, RecipeReading& reading) {
  fields.text("name", reading.name);
  fields.demand(!reading.name.empty(), "name", en::say("is empty"), en::say("a name"));
  fields.choice("what", reading.what, measurand_words());
  fields.numbers("a_mm", {&reading.a.along_mm, &reading.a.across_mm}, kPosition_mm);
  fields.numbers("b_mm", {&reading.b.along_mm, &reading.b.across_mm}, kPosition_mm);
  if (reading.what == Measurand::kRoughness) {
    RoughnessFilter& filter = reading.filter;
    fields.integer(may("form_degree", filter.form_degree != RoughnessFilter().form_degree),
                   filter.form_degree, 1, kMaxFormDegree);
    if (fields.has(may("lambda_c_mm"), filter.lambda_c_mm))
      fields.number("lambda_c_mm", *filter.lambda_c_mm, kLambda_mm);
  }
  if (fields.has(may("lower"), reading.lower)) fields.number("lower", *reading.lower, kAnyNumber);
  if (fields.has(may("upper"), reading.upper)) fields.number("upper", *reading.upper, kAnyNumber);
  fields.demand(!reading.lower || !reading.upper || *reading.lower < *reading.upper, "upper",
                en::say("is not above the lower limit"), en::say("a larger number"));
}

static void describe(Fields& fields, InspectionRecipe& recipe) {
  fields.format(InspectionRecipe::kFormat, "");
  fields.text(may("name", !recipe.name.empty()), recipe.name);
  fields.sections("readings", recipe.readings);
  std::set<std::string> names;
  for (const RecipeReading& reading : recipe.readings)
    fields.demand(names.insert(reading.name).second, "readings",
                  en::say("has two of the name '{}'", reading.name), en::say("different names"));
  fields.demand(!recipe.readings.empty() && recipe.readings.size() <= kMostReadings, "readings",
                en::say("has {} entries", recipe.readings.size()),
                en::say("one to {} readings", kMostReadings));
}

Result<InspectionRecipe> InspectionRecipe::load(const std::filesystem::path& file) {
  const auto content = read_file(file, YamlFile::kMaxBytes);
  if (!content) return content.error();
  return parse(*content, file);
}

Result<InspectionRecipe> InspectionRecipe::parse(const std::string& yaml,
                                                 const std::filesystem::path& origin) {
  YamlFile file(origin);
  return read_fields<InspectionRecipe>(file, yaml);
}

std::string InspectionRecipe::to_yaml() const { return fields_text(*this); }

Status InspectionRecipe::save(const std::filesystem::path& file) const {
  return write_file_atomically(file, to_yaml());
}

std::string InspectionRecipe::free_name(const std::string& base) const {
  const auto is_taken = [this](const std::string& tried) {
    return std::any_of(readings.begin(), readings.end(),
                       [&](const RecipeReading& reading) { return reading.name == tried; });
  };
  std::string free = base;
  for (int i = 2; is_taken(free); ++i) free = fmt::format("{} {}", base, i);
  return free;
}

std::string_view to_string(Conformity conformity) {
  switch (conformity) {
    case Conformity::kNoTolerance:
      return "no tolerance";
    case Conformity::kPass:
      return "pass";
    case Conformity::kFail:
      return "fail";
    case Conformity::kUndecided:
      return "undecided";
    case Conformity::kNotMeasured:
      break;
  }
  return "not measured";
}

Conformity conformity(const FaceReading& reading, const RecipeReading& recipe) {
  if (!reading.measured) return Conformity::kNotMeasured;
  if (!recipe.lower && !recipe.upper) return Conformity::kNoTolerance;
  const auto [value, sd] = *reading.measured;
  if (!(sd > 0) || !std::isfinite(sd)) return Conformity::kUndecided;
  const double guard = kGuardSds * sd;
  if (recipe.upper && value > *recipe.upper + guard) return Conformity::kFail;
  if (reading.is_lower_bound) return Conformity::kUndecided;  // it may be any larger value
  if (recipe.lower && value < *recipe.lower - guard) return Conformity::kFail;
  const bool is_inside = (!recipe.lower || value >= *recipe.lower + guard) &&
                         (!recipe.upper || value <= *recipe.upper - guard);
  return is_inside ? Conformity::kPass : Conformity::kUndecided;
}

}  // namespace alltact
