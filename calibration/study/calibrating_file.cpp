#include "calibration/study/calibrating_study.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

std::string family_name(FamilyChoice family) {
  CalibrationSettings settings;
  settings.family = family;
  for (const auto& setting : calibration_settings())
    if (setting.name == "family") return setting.get(settings);
  return {};
}

double painted_median_mm(const CalibratingRow& row) {
  return row.painted && row.failed == 0 ? row.painted->median_mm
                                        : std::numeric_limits<double>::infinity();
}

const CalibratingRow* row_of_choice(const CalibratingStudy& study,
                                    const CalibratingChoice& choice) {
  const auto found = std::find_if(
      study.rows.begin(), study.rows.end(), [&](const auto& row) { return row.choice == choice; });
  return found == study.rows.end() || !found->painted ? nullptr : &*found;
}

Message benefit_of(const Message& what, const CalibratingRow& now, const CalibratingRow& then) {
  return en::say(
      "{}: depth {:.1f} instead of {:.1f} micrometres off in the median, 95 % within {:.1f} "
      "instead of {:.1f}, for {:.1f} minutes more",
      what,
      1000 * then.painted->median_mm,
      1000 * now.painted->median_mm,
      1000 * then.painted->p95_mm,
      1000 * now.painted->p95_mm,
      total_minutes(then) - total_minutes(now));
}

std::string um(const std::optional<ErrorSpread>& spread, double ErrorSpread::*member) {
  return spread ? fmt::format("{:.1f}", 1000 * (*spread).*member) : "-";
}

std::optional<ErrorSpread> real_depth(const CalibratingRow& row) {
  return row.real ? std::optional(row.real->depth) : std::nullopt;
}

std::string line_of_row(const CalibratingRow& row) {
  std::string line = fmt::format("{:>8.1f} {:>8.2f} {:>8.2f} {:>9} {:>8} {:>9} {:>8}  {}",
                                 row.technician_min,
                                 row.computing_s,
                                 row.time_ratio,
                                 um(row.painted, &ErrorSpread::median_mm),
                                 um(row.painted, &ErrorSpread::p95_mm),
                                 um(real_depth(row), &ErrorSpread::median_mm),
                                 um(real_depth(row), &ErrorSpread::p95_mm),
                                 words_of(row.choice));
  if (row.failed > 0) line += fmt::format("   ({} of {} gave no mapping)", row.failed, row.draws);
  return line + '\n';
}

}  // namespace

Message words_of(const CalibratingChoice& choice) {
  std::vector<Message> words{en::count("{} presses", "{} press", choice.presses)};
  if (choice.images > 1) words.push_back(en::say("{} pictures each", choice.images));
  if (choice.method != CalibrationMethod::kJoint)
    words.push_back(en::say("method {}", method_name(choice.method)));
  if (choice.family != FamilyChoice::kAuto)
    words.push_back(en::say("family {}", family_name(choice.family)));
  if (choice.iterations != CalibratingChoice{}.iterations)
    words.push_back(en::count("{} iterations", "{} iteration", choice.iterations));
  return en::list(words);
}

double total_minutes(const CalibratingRow& row) {
  return row.technician_min + row.computing_s / 60;
}

std::vector<std::size_t> calibrating_front(const CalibratingStudy& study) {
  const auto beats = [](const CalibratingRow& a, const CalibratingRow& b) {
    const double min_a = total_minutes(a), min_b = total_minutes(b);
    const double mm_a = painted_median_mm(a), mm_b = painted_median_mm(b);
    return min_a <= min_b && mm_a <= mm_b && (min_a < min_b || mm_a < mm_b);
  };
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const CalibratingRow& row = study.rows[i];
    if (painted_median_mm(row) == std::numeric_limits<double>::infinity()) continue;
    if (std::none_of(study.rows.begin(), study.rows.end(), [&](const CalibratingRow& other) {
          return beats(other, row);
        }))
      front.push_back(i);
  }
  std::sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
    return total_minutes(study.rows[a]) < total_minutes(study.rows[b]);
  });
  return front;
}

std::vector<Message> benefit_of_more_data(const CalibratingStudy& study,
                                          const CalibratingChoice& from) {
  std::vector<Message> sentences;
  const CalibratingRow* now = row_of_choice(study, from);
  if (now == nullptr) return sentences;
  const CalibratingRow* more_presses = nullptr;  // fewest beyond
  const CalibratingRow* more_images = nullptr;   // fewest beyond
  for (const CalibratingRow& row : study.rows) {
    if (!row.painted) continue;
    CalibratingChoice same = row.choice;
    same.presses = from.presses;
    if (same == from && row.choice.presses > from.presses &&
        (more_presses == nullptr || row.choice.presses < more_presses->choice.presses))
      more_presses = &row;
    same = row.choice;
    same.images = from.images;
    if (same == from && row.choice.images > from.images &&
        (more_images == nullptr || row.choice.images < more_images->choice.images))
      more_images = &row;
  }
  if (more_presses != nullptr)
    sentences.push_back(benefit_of(
        en::count("{} presses more", "{} press more", more_presses->choice.presses - from.presses),
        *now,
        *more_presses));
  if (more_images != nullptr)
    sentences.push_back(benefit_of(
        en::say("{} pictures of each press", more_images->choice.images), *now, *more_images));
  const CalibratingRow* minute = nullptr;  // the best within a minute more
  for (const CalibratingRow& row : study.rows)
    if (row.painted && total_minutes(row) <= total_minutes(*now) + 1 &&
        painted_median_mm(row) < painted_median_mm(minute != nullptr ? *minute : *now))
      minute = &row;
  if (minute != nullptr)
    sentences.push_back(benefit_of(
        en::say("The best within a minute more ({})", words_of(minute->choice)), *now, *minute));
  return sentences;
}

std::string text_of(const CalibratingStudy& study) {
  std::string text = fmt::format(
      "{:>8} {:>8} {:>8} {:>9} {:>8} {:>9} {:>8}\n{:>8} {:>8} {:>8} {:>9} {:>8} {:>9} {:>8}\n",
      "minutes",
      "seconds",
      "ratio",
      "painted",
      "95 %",
      "real",
      "95 %",
      "of hand",
      "computed",
      "",
      "(um)",
      "(um)",
      "(um)",
      "(um)");
  text += "Nothing studied takes less time and reads depth closer (painted) than these:\n";
  for (const std::size_t row : calibrating_front(study)) text += line_of_row(study.rows[row]);
  text += "All that was studied:\n";
  for (const CalibratingRow& row : study.rows) text += line_of_row(row);
  if (!study.no_real_reason.empty())
    text += fmt::format("Nothing is told of real presses: {}.\n", study.no_real_reason);
  text += fmt::format(
      "Minutes of hand are an estimate: {:.0f} s once, {:.0f} s a press, {:.2f} s a further "
      "picture.\n",
      study.technician.once_s,
      study.technician.press_s,
      study.technician.image_s);
  for (const Message& sentence : benefit_of_more_data(study, study.rows.front().choice))
    text += fmt::format("{}.\n", sentence);
  return text;
}

std::string csv_of(const CalibratingStudy& study) {
  std::string csv =
      "presses,pictures,method,family,iterations,technician_min,computing_s,time_ratio,draws,"
      "failed,"
      "painted_median_mm,painted_p95_mm,splits,splits_failed,real_median_mm,real_p95_mm,on_front\n";
  const auto number = [](const std::optional<ErrorSpread>& spread, double ErrorSpread::*member) {
    return spread ? fmt::format("{}", (*spread).*member) : "";
  };
  const auto front = calibrating_front(study);
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const CalibratingRow& row = study.rows[i];
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                       row.choice.presses,
                       row.choice.images,
                       method_name(row.choice.method),
                       family_name(row.choice.family),
                       row.choice.iterations,
                       row.technician_min,
                       row.computing_s,
                       row.time_ratio,
                       row.draws,
                       row.failed,
                       number(row.painted, &ErrorSpread::median_mm),
                       number(row.painted, &ErrorSpread::p95_mm),
                       row.splits,
                       row.splits_failed,
                       number(real_depth(row), &ErrorSpread::median_mm),
                       number(real_depth(row), &ErrorSpread::p95_mm),
                       std::find(front.begin(), front.end(), i) != front.end() ? 1 : 0);
  }
  return csv;
}

nlohmann::json json_of(const CalibratingStudy& study) {
  nlohmann::json json{{"about", study.about.english()},
                      {"truth", "painted, and real presses apart"},
                      {"world", fmt::format("{:016x}", study.world_checksum)},
                      {"technician",
                       {{"once_s", study.technician.once_s},
                        {"press_s", study.technician.press_s},
                        {"picture_s", study.technician.image_s},
                        {"is_estimate", true}}}};
  if (!study.no_real_reason.empty()) json["no_real"] = study.no_real_reason.english();
  const auto front = calibrating_front(study);
  const auto spread = [](const ErrorSpread& of) {
    return nlohmann::json{{"median_mm", of.median_mm}, {"p95_mm", of.p95_mm}};
  };
  nlohmann::json& rows = json["rows"] = nlohmann::json::array();
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const CalibratingRow& row = study.rows[i];
    nlohmann::json errors{{"draws", row.draws},
                          {"failed", row.failed},
                          {"splits", row.splits},
                          {"splits_failed", row.splits_failed}};
    if (row.painted) errors["painted"] = spread(*row.painted);
    if (row.real) errors["real"] = spread(row.real->depth);
    rows.push_back({{"words", words_of(row.choice).english()},
                    {"presses", row.choice.presses},
                    {"pictures", row.choice.images},
                    {"method", method_name(row.choice.method)},
                    {"family", family_name(row.choice.family)},
                    {"iterations", row.choice.iterations},
                    {"errors", std::move(errors)},
                    {"times",
                     {{"computing_s", row.computing_s},
                      {"ratio", row.time_ratio},
                      {"technician_min", row.technician_min}}},
                    {"on_front", std::find(front.begin(), front.end(), i) != front.end()}});
  }
  nlohmann::json& more = json["one_more"] = nlohmann::json::array();
  for (const Message& sentence : benefit_of_more_data(study, study.rows.front().choice))
    more.push_back(sentence.english());
  return json;
}

}  // namespace alltact
