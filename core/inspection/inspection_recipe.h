// An inspection recipe: named readings of the face with their tolerances, in a YAML file.
//   format: alltact-inspection-recipe/1
//   name: "groove of the seal"
//   readings:
//     - {name: depth, what: step, a_mm: [30, -2], b_mm: [36, -2], lower: 0.45, upper: 0.55}
//     - {name: grain, what: roughness, a_mm: [30, -2], b_mm: [36, 2], form_degree: 4,
//        lambda_c_mm: 0.8}
// Positions are mm on the face, along it and across it; limits have the unit of what is read.
#pragma once

#include "core/base/result.h"
#include "core/inspection/face_reading.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct RecipeReading {
  std::string name;  ///< unique in the recipe
  Measurand what = Measurand::kDistance;
  FacePosition a, b;
  std::optional<double> lower, upper;  ///< limits of the tolerance; either may be absent
  RoughnessFilter filter;              ///< of Measurand::kRoughness
  bool operator==(const RecipeReading&) const = default;
};

struct InspectionRecipe {
  static constexpr const char* kFormat = "alltact-inspection-recipe/1";

  std::string name;  ///< may be empty
  std::vector<RecipeReading> readings;
  bool operator==(const InspectionRecipe&) const = default;

  /// Errors: the file cannot be read; impossible values; no reading; two of the same name; a lower
  /// limit that is not below the upper one.
  static Result<InspectionRecipe> load(const std::filesystem::path& file);
  static Result<InspectionRecipe> parse(const std::string& yaml,
                                        const std::filesystem::path& origin);
  [[nodiscard]] std::string to_yaml() const;
  [[nodiscard]] Status save(const std::filesystem::path& file) const;
  /// `base`, or the first of "base 2", "base 3", ... that no reading has.
  [[nodiscard]] std::string free_name(const std::string& base) const;
};

/// Decision on one reading by ISO 14253-1: conforming or not with 95 % certainty, which needs a
/// guard band of kGuardSds standard deviations inside or outside of each limit.
enum class Conformity {
  kNoTolerance = 1,
  kPass,       ///< within the limits by the guard band or more
  kFail,       ///< beyond a limit by the guard band or more
  kUndecided,  ///< closer to a limit than the guard band, or without a standard deviation
  kNotMeasured,
};
inline constexpr double kGuardSds = 1.6449;  ///< 95 % of a normal distribution, one side
/// In files: "no tolerance", "pass", "fail", "undecided", "not measured".
[[nodiscard]] std::string_view to_string(Conformity conformity);
[[nodiscard]] Conformity conformity(const FaceReading& reading, const RecipeReading& recipe);

}  // namespace alltact
