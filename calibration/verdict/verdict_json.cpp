#include "calibration/verdict/verdict_json.h"

#include <cmath>

namespace alltact {

nlohmann::ordered_json verdict_json(const Verdict& verdict) {
  nlohmann::ordered_json json;
  json["grade"] = to_string(verdict.grade);
  json["expected_error_mm"] = nullptr;
  if (std::isfinite(verdict.error_mm)) json["expected_error_mm"] = verdict.error_mm;
  json["causes_mm"] = nlohmann::ordered_json::object();
  for (const ErrorPart& part : verdict.parts)
    json["causes_mm"][std::string(to_string(part.cause))] = part.error_mm;
  json["missing"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < verdict.missing.size(); ++i)
    json["missing"].push_back(
        {{"evidence", verdict.missing_names[i]}, {"sentence", verdict.missing[i].english()}});
  json["rests_on"] = verdict.rests_on.english();
  json["sentence"] = verdict.sentence.english();
  return json;
}

}  // namespace alltact
