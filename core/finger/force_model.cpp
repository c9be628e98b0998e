#include "core/finger/force_model.h"

#include "core/base/atomic_file.h"
#include "core/base/message.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>
#include <nlohmann/json.hpp>

namespace alltact {

// Estimation of forces with a force model.

namespace {

constexpr double kRangeMargin = 1.1;       // in range up to this multiple of the table's maximum
constexpr double kPositionMarginMm = 2.0;  // margin around the positions of the table
constexpr double kRestTolerancePx = 2.0;   // tolerance for a marker at rest
constexpr double kLargestInput = 1e6;      // px, mm: larger values are invalid

bool is_usable(const Eigen::VectorXd& values) {
  return values.allFinite() && (values.size() == 0 || values.cwiseAbs().maxCoeff() < kLargestInput);
}

}  // namespace

Eigen::VectorXd ForceRange::scores(const ForceInput& input) const {
  const Eigen::Index k = components.cols();
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(k, k);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(k);
  for (Eigen::Index m = 0; m < input.seen.size(); ++m) {
    if (input.seen[m] < 0.5) continue;
    for (Eigen::Index c = 2 * m; c < 2 * m + 2; ++c) {
      const auto row = components.row(c).transpose();
      information.noalias() += row * row.transpose();
      right.noalias() += row * (input.displacement_px[c] - mean_px[c]);
    }
  }
  information.diagonal().array() += noise_px * noise_px / component_sd_px.array().square();
  return information.ldlt().solve(right);
}

void ForceRange::fill(ForceInput& input) const {
  if (input.seen.size() == 0 || input.seen.minCoeff() > 0.5) return;
  const Eigen::VectorXd likeliest = mean_px + components * scores(input);
  for (Eigen::Index m = 0; m < input.seen.size(); ++m)
    if (input.seen[m] < 0.5) input.displacement_px.segment<2>(2 * m) = likeliest.segment<2>(2 * m);
}

ForceRange::RangeDeviation ForceRange::deviation(const ForceInput& filled) const {
  const Eigen::VectorXd from_mean = filled.displacement_px - mean_px;
  const Eigen::VectorXd score = components.transpose() * from_mean;
  const Eigen::VectorXd residual = from_mean - components * score;
  const double seen = std::max(1.0, filled.seen.sum());
  return {score.cwiseQuotient(component_sd_px).squaredNorm(),
          std::sqrt(residual.squaredNorm() / (2 * seen))};
}

bool ForceRange::holds(const ForceInput& filled) const {
  const RangeDeviation found = deviation(filled);
  if (found.t2 > kRangeMargin * kRangeMargin * max_t2 ||
      found.residual_px > kRangeMargin * max_residual_px)
    return false;
  if (filled.seen.sum() < min_seen - 0.5) return false;
  if (!filled.position_mm || !position_mm)
    return filled.position_mm.has_value() || !has_all_positions;
  return ((*filled.position_mm - (*position_mm)[0]).array() >= -kPositionMarginMm).all() &&
         ((*filled.position_mm - (*position_mm)[1]).array() <= kPositionMarginMm).all();
}

int ForceBasis::size() const {
  const int multiplied = squared + (squared > 0 && has_position ? 3 : 0);
  return plain_size() + multiplied * (multiplied + 1) / 2;
}

Eigen::VectorXd ForceBasis::raw_extras(const ForceInput& filled) const {
  Eigen::VectorXd extra(extras());
  Eigen::Index at = 0;
  for (const int flag : flags) extra[at++] = filled.seen[flag];
  if (has_position) {
    // An unknown position is replaced by the mean.
    const bool known = filled.position_mm.has_value();
    const bool is_learnt = extra_mean.size() == extra.size();
    for (int i = 0; i < 2; ++i, ++at)
      extra[at] = known ? (*filled.position_mm)[i] : is_learnt ? extra_mean[at] : 0.0;
    extra[at++] = known ? 1.0 : 0.0;
  }
  if (crept > 0) {
    if (filled.crept_px.size() == components.rows())
      extra.tail(crept) =
          components.leftCols(crept).transpose() * filled.crept_px.cwiseProduct(scale);
    else
      extra.tail(crept).setZero();
  }
  return extra;
}

Eigen::VectorXd ForceBasis::operator()(const ForceInput& filled) const {
  Eigen::VectorXd z(size());
  const Eigen::Index p = gain.size();
  if (p > 0)
    z.head(p) = (components.transpose() * (filled.displacement_px - mean_px).cwiseProduct(scale))
                    .cwiseProduct(gain);
  if (extras() > 0)
    z.segment(p, extras()) = (raw_extras(filled) - extra_mean).cwiseProduct(extra_scale);
  if (squared == 0) return z;
  // Components of equal scale, so that each product has an influence.
  std::vector<Eigen::Index> factors(static_cast<std::size_t>(squared));
  std::iota(factors.begin(), factors.end(), 0);
  if (has_position)
    for (Eigen::Index i = 0; i < 3; ++i)
      factors.push_back(p + static_cast<Eigen::Index>(flags.size()) + i);
  Eigen::Index at = plain_size();
  for (std::size_t i = 0; i < factors.size(); ++i)
    for (std::size_t j = i; j < factors.size(); ++j) z[at++] = z[factors[i]] * z[factors[j]];
  return z;
}

Eigen::VectorXd force_of(const ForceRegressor& regressor, const Eigen::VectorXd& z) {
  Eigen::VectorXd layer = z;
  for (std::size_t i = 0; i < regressor.size(); ++i) {
    Eigen::VectorXd next = regressor[i].weights * layer + regressor[i].bias;
    if (i + 1 < regressor.size()) next = next.cwiseMax(0.0);
    layer = std::move(next);
  }
  return layer;
}

Eigen::VectorXd ForceMember::operator()(const ForceInput& filled) const {
  const Eigen::VectorXd z = basis(filled);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(regressors.front().back().bias.size());
  for (const ForceRegressor& regressor : regressors) sum += force_of(regressor, z);
  return sum / static_cast<double>(regressors.size());
}

std::optional<Force> ForceModel::operator()(ForceInput input) const {
  if (input.seen.size() != marker_count || input.displacement_px.size() != 2 * marker_count ||
      input.seen.sum() < 0.5 || !is_usable(input.displacement_px) || !is_usable(input.crept_px))
    return std::nullopt;
  if (input.position_mm && !is_usable(*input.position_mm)) input.position_mm.reset();
  range.fill(input);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(axes), squares = sum;
  Eigen::VectorXd first;
  for (const ForceMember& member : members) {
    const Eigen::VectorXd force = member(input);
    if (first.size() == 0) first = force;
    sum += force - first;
    squares += (force - first).cwiseAbs2();
  }
  const double count = static_cast<double>(members.size());
  const Eigen::VectorXd mean = sum / count;
  const Eigen::VectorXd variance = (squares / count - mean.cwiseAbs2()).cwiseMax(0.0);
  const Eigen::VectorXd s = (scores.floor_N.cwiseAbs2() + variance).cwiseSqrt();
  Force force;
  force.axes = axes;
  force.force_N.head(axes) = first + mean;
  force.sd_N.head(axes) = s.cwiseProduct(scores.rms);
  force.half_90_N.head(axes) = s.cwiseProduct(scores.quantile_90);
  force.half_95_N.head(axes) = s.cwiseProduct(scores.quantile_95);
  force.in_range = range.holds(input);
  if (!force.force_N.allFinite() || !force.sd_N.allFinite() || !force.half_95_N.allFinite() ||
      !force.half_90_N.allFinite())
    return std::nullopt;
  return force;
}

Status ForceModel::belongs_to(const Finger& finger) const {
  const Message advice = en::say("alltact force with a table of this finger's markers");
  if (finger.marker_count() != marker_count || finger.markers.missing != missing)
    return Error{en::say("the force model was trained with {} markers, the finger has {} others",
                         marker_count, finger.marker_count()),
                 std::string("force.model"), advice};
  if (!finger.contact) return {};
  double far_px = 0;
  for (std::size_t m = 0; m < rest_px.size(); ++m)
    far_px = std::max(far_px, (rest_px[m] - finger.contact->rest_markers[m]).norm());
  if (far_px <= kRestTolerancePx) return {};
  return Error{en::say("the force model belongs to another reference: its markers rested up to "
                       "{:.1f} px off the present positions",
                       far_px),
               std::string("force.model"), advice};
}

// The file format of force models.

namespace {

using ForceJson = nlohmann::ordered_json;

constexpr double kLargestNumber = 1e12;
constexpr std::size_t kLargestModel = std::size_t{256} << 20;
constexpr Eigen::Index kMaxMembers = 200, kMaxFeatures = 20000;

/// Ends the reading; ForceModel::parse catches it.
struct RefusedForceModel {
  Error error;
};

[[noreturn]] void refuse_model(const std::string& key, Message what) {
  throw RefusedForceModel{{std::move(what), key, en::say("train the force model again")}};
}

ForceJson json_of(const Eigen::MatrixXd& matrix) {
  ForceJson numbers = ForceJson::array();
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
      numbers.push_back(matrix(row, column));
  return {{"rows", matrix.rows()}, {"columns", matrix.cols()}, {"numbers", std::move(numbers)}};
}

ForceJson json_of_vector(const Eigen::VectorXd& vector) {
  return ForceJson(std::vector<double>(vector.begin(), vector.end()));
}

ForceJson json_of(const ForceRange& range) {
  ForceJson json{{"mean_px", json_of_vector(range.mean_px)},
                 {"components", json_of(range.components)},
                 {"component_sd_px", json_of_vector(range.component_sd_px)},
                 {"noise_px", range.noise_px},
                 {"most_t2", range.max_t2},
                 {"most_beside_px", range.max_residual_px},
                 {"least_seen", range.min_seen},
                 {"always_placed", range.has_all_positions}};
  if (range.position_mm)
    for (const Eigen::Vector2d& position : *range.position_mm)
      json["place_mm"].push_back({position.x(), position.y()});
  return json;
}

ForceJson json_of(const ForceMember& member) {
  const ForceBasis& basis = member.basis;
  ForceJson json{{"mean_px", json_of_vector(basis.mean_px)},
                 {"scale", json_of_vector(basis.scale)},
                 {"components", json_of(basis.components)},
                 {"gain", json_of_vector(basis.gain)},
                 {"flags", basis.flags},
                 {"has_place", basis.has_position},
                 {"crept", basis.crept},
                 {"extra_mean", json_of_vector(basis.extra_mean)},
                 {"extra_scale", json_of_vector(basis.extra_scale)},
                 {"squared", basis.squared}};
  json["regressors"] = ForceJson::array();
  for (const ForceRegressor& regressor : member.regressors) {
    ForceJson layers = ForceJson::array();
    for (const ForceLayer& layer : regressor)
      layers.push_back({{"weights", json_of(layer.weights)}, {"bias", json_of_vector(layer.bias)}});
    json["regressors"].push_back(std::move(layers));
  }
  return json;
}

const ForceJson& at(const ForceJson& json, const std::string& key, const std::string& path) {
  if (!json.is_object()) refuse_model(path, en::say("is not an object"));
  const auto found = json.find(key);
  if (found == json.end()) refuse_model(path + "." + key, en::say("is missing"));
  return *found;
}

double number_of(const ForceJson& json, const std::string& path) {
  if (!json.is_number()) refuse_model(path, en::say("is not a number"));
  const double number = json.get<double>();
  if (!(std::abs(number) < kLargestNumber)) refuse_model(path, en::say("is not a valid number"));
  return number;
}

int integer_of(const ForceJson& json, const std::string& path) {
  const double number = number_of(json, path);
  if (number != std::floor(number) || std::abs(number) > 1e9)
    refuse_model(path, en::say("is not an integer"));
  return static_cast<int>(number);
}

const ForceJson& array_of(const ForceJson& json, const std::string& path) {
  if (!json.is_array()) refuse_model(path, en::say("is not a list"));
  return json;
}

Eigen::VectorXd vector_at(const ForceJson& json, const std::string& key, const std::string& path) {
  const std::string full_key = path + "." + key;
  const ForceJson& list = array_of(at(json, key, path), full_key);
  Eigen::VectorXd vector(static_cast<Eigen::Index>(list.size()));
  for (Eigen::Index i = 0; i < vector.size(); ++i)
    vector[i] = number_of(list[static_cast<std::size_t>(i)], full_key);
  return vector;
}

Eigen::MatrixXd matrix_at(const ForceJson& json, const std::string& key, const std::string& path) {
  const std::string full_key = path + "." + key;
  const ForceJson& matrix = at(json, key, path);
  const int rows = integer_of(at(matrix, "rows", full_key), full_key + ".rows");
  const int columns = integer_of(at(matrix, "columns", full_key), full_key + ".columns");
  const Eigen::VectorXd numbers = vector_at(matrix, "numbers", full_key);
  if (rows < 0 || columns < 0 || rows > kMaxFeatures || columns > kMaxFeatures ||
      Eigen::Index{rows} * columns != numbers.size())
    refuse_model(full_key, en::say("holds {} numbers, not {} x {}", numbers.size(), rows, columns));
  return Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(numbers.data(), rows,
                                                                          columns);
}

bool bool_at(const ForceJson& json, const std::string& key, const std::string& path) {
  const ForceJson& value = at(json, key, path);
  if (!value.is_boolean()) refuse_model(path + "." + key, en::say("is not true or false"));
  return value.get<bool>();
}

ForceRange range_from(const ForceJson& json) {
  const std::string path = "range";
  ForceRange range;
  range.mean_px = vector_at(json, "mean_px", path);
  range.components = matrix_at(json, "components", path);
  range.component_sd_px = vector_at(json, "component_sd_px", path);
  range.noise_px = number_of(at(json, "noise_px", path), "range.noise_px");
  range.max_t2 = number_of(at(json, "most_t2", path), "range.most_t2");
  range.max_residual_px = number_of(at(json, "most_beside_px", path), "range.most_beside_px");
  range.min_seen = integer_of(at(json, "least_seen", path), "range.least_seen");
  range.has_all_positions = bool_at(json, "always_placed", path);
  if (!json.contains("place_mm")) return range;
  const ForceJson& positions = array_of(json.at("place_mm"), "range.place_mm");
  if (positions.size() != 2) refuse_model("range.place_mm", en::say("must be two positions"));
  range.position_mm.emplace();
  for (std::size_t i = 0; i < 2; ++i) {
    if (array_of(positions[i], "range.place_mm").size() != 2)
      refuse_model("range.place_mm", en::say("must be two positions"));
    for (std::size_t k = 0; k < 2; ++k)
      (*range.position_mm)[i][static_cast<Eigen::Index>(k)] =
          number_of(positions[i][k], "range.place_mm");
  }
  return range;
}

ForceMember member_from(const ForceJson& json, const std::string& path) {
  ForceMember member;
  ForceBasis& basis = member.basis;
  basis.mean_px = vector_at(json, "mean_px", path);
  basis.scale = vector_at(json, "scale", path);
  basis.components = matrix_at(json, "components", path);
  basis.gain = vector_at(json, "gain", path);
  for (const ForceJson& flag : array_of(at(json, "flags", path), path + ".flags"))
    basis.flags.push_back(integer_of(flag, path + ".flags"));
  basis.has_position = bool_at(json, "has_place", path);
  basis.crept = integer_of(at(json, "crept", path), path + ".crept");
  basis.extra_mean = vector_at(json, "extra_mean", path);
  basis.extra_scale = vector_at(json, "extra_scale", path);
  basis.squared = integer_of(at(json, "squared", path), path + ".squared");
  for (const ForceJson& layers : array_of(at(json, "regressors", path), path + ".regressors")) {
    ForceRegressor regressor;
    for (const ForceJson& layer : array_of(layers, path + ".regressors"))
      regressor.push_back({matrix_at(layer, "weights", path + ".regressors"),
                           vector_at(layer, "bias", path + ".regressors")});
    member.regressors.push_back(std::move(regressor));
  }
  return member;
}

ForceModel model_from(const ForceJson& json) {
  const ForceJson& format = at(json, "format", "force");
  if (!format.is_string() || format.get<std::string>() != ForceModel::kFormat)
    refuse_model("format", en::say("'{}' cannot be read by this version",
                                   printable(format.is_string() ? format.get<std::string>() : "")));
  ForceModel model;
  const ForceJson& kind = at(json, "kind", "force");
  const auto word = std::find(kForceKinds.begin(), kForceKinds.end(),
                              kind.is_string() ? kind.get<std::string>() : "");
  if (word == kForceKinds.end())
    refuse_model("kind", en::say("must be mean, ridge, quadratic or network"));
  model.kind = static_cast<ForceKind>(word - kForceKinds.begin() + 1);
  model.axes = integer_of(at(json, "axes", "force"), "axes");
  model.marker_count = integer_of(at(json, "marker_count", "force"), "marker_count");
  for (const ForceJson& number : array_of(at(json, "missing", "force"), "missing"))
    model.missing.push_back(integer_of(number, "missing"));
  const Eigen::VectorXd rest = vector_at(json, "rest_px", "force");
  for (Eigen::Index i = 0; i + 1 < rest.size(); i += 2)
    model.rest_px.emplace_back(rest[i], rest[i + 1]);
  model.creep_s = number_of(at(json, "creep_s", "force"), "creep_s");
  model.range = range_from(at(json, "range", "force"));
  const ForceJson& scores = at(json, "scores", "force");
  model.scores = {vector_at(scores, "floor_N", "scores"), vector_at(scores, "rms", "scores"),
                  vector_at(scores, "quantile_90", "scores"),
                  vector_at(scores, "quantile_95", "scores")};
  for (const ForceJson& member : array_of(at(json, "members", "force"), "members"))
    model.members.push_back(
        member_from(member, "members[" + std::to_string(model.members.size()) + "]"));
  const ForceJson& record = at(json, "record", "force");
  if (!record.is_object()) refuse_model("record", en::say("is not an object"));
  for (const auto& [key, text] : record.items()) {
    if (!text.is_string()) refuse_model("record", en::say("contains non-text values"));
    model.record[key] = text.get<std::string>();
  }
  return model;
}

void check_shape(bool holds, const std::string& key) {
  if (!holds) refuse_model(key, en::say("does not have the shape that the model needs"));
}

void check_range(const ForceModel& model) {
  const ForceRange& range = model.range;
  const Eigen::Index columns = 2 * model.marker_count, k = range.component_sd_px.size();
  check_shape(range.mean_px.size() == columns, "range.mean_px");
  check_shape(range.components.rows() == columns && range.components.cols() == k,
              "range.components");
  if (!(range.noise_px > 0) || (k > 0 && !(range.component_sd_px.minCoeff() > 0)))
    refuse_model("range.noise_px", en::say("must be above 0"));
  if (!(range.max_t2 >= 0) || !(range.max_residual_px >= 0) || range.min_seen < 0 ||
      range.min_seen > model.marker_count)
    refuse_model("range", en::say("is not a valid range"));
}

void check_basis(const ForceBasis& basis, const ForceModel& model, const std::string& path) {
  const Eigen::Index columns = 2 * model.marker_count, p = basis.gain.size();
  check_shape(basis.mean_px.size() == columns, path + ".mean_px");
  check_shape(basis.scale.size() == columns, path + ".scale");
  check_shape(basis.components.rows() == columns && basis.components.cols() == p,
              path + ".components");
  for (const int flag : basis.flags)
    check_shape(flag >= 0 && flag < model.marker_count, path + ".flags");
  check_shape(basis.flags.size() <= static_cast<std::size_t>(model.marker_count), path + ".flags");
  check_shape(basis.crept >= 0 && basis.crept <= p, path + ".crept");
  check_shape(basis.squared >= 0 && basis.squared <= p && basis.squared <= 64, path + ".squared");
  check_shape(basis.extra_mean.size() == basis.extras(), path + ".extra_mean");
  check_shape(basis.extra_scale.size() == basis.extras(), path + ".extra_scale");
}

void check_regressor(const ForceRegressor& regressor, const ForceBasis& basis,
                     const ForceModel& model, const std::string& path) {
  check_shape(regressor.size() == (model.kind == ForceKind::kNetwork ? 3U : 1U), path);
  Eigen::Index inputs = basis.size();
  for (const ForceLayer& layer : regressor) {
    check_shape(layer.weights.cols() == inputs && layer.weights.rows() == layer.bias.size(), path);
    inputs = layer.bias.size();
    if (!layer.weights.allFinite() || !layer.bias.allFinite())
      refuse_model(path, en::say("contains non-numeric values"));
  }
  check_shape(inputs == model.axes, path);
}

void check_model(const ForceModel& model) {
  if (model.axes != 2 && model.axes != 3) refuse_model("axes", en::say("must be 2 or 3"));
  if (model.marker_count < 1 || model.marker_count > 1024)
    refuse_model("marker_count", en::say("must be an integer from 1 to 1024"));
  check_shape(model.rest_px.size() == static_cast<std::size_t>(model.marker_count), "rest_px");
  for (const int number : model.missing)
    check_shape(number >= 0 && number < model.marker_count, "missing");
  if (!(model.creep_s >= 0 && model.creep_s <= 1e6))
    refuse_model("creep_s", en::say("must be a number from 0 to 1000000"));
  check_range(model);
  const ForceScores& scores = model.scores;
  for (const Eigen::VectorXd* values :
       {&scores.floor_N, &scores.rms, &scores.quantile_90, &scores.quantile_95}) {
    check_shape(values->size() == model.axes, "scores");
    if (!(values->minCoeff() > 0) || !values->allFinite())
      refuse_model("scores", en::say("must be above 0"));
  }
  if (model.members.empty() || static_cast<Eigen::Index>(model.members.size()) > kMaxMembers)
    refuse_model("members", en::say("must be 1 to {}", kMaxMembers));
  for (std::size_t i = 0; i < model.members.size(); ++i) {
    const ForceMember& member = model.members[i];
    const std::string path = "members[" + std::to_string(i) + "]";
    check_basis(member.basis, model, path);
    if (member.regressors.empty()) refuse_model(path + ".regressors", en::say("are missing"));
    for (const ForceRegressor& regressor : member.regressors)
      check_regressor(regressor, member.basis, model, path + ".regressors");
  }
}

}  // namespace

std::string ForceModel::to_json() const {
  ForceJson json{{"format", kFormat},
                 {"kind", to_string(kind)},
                 {"axes", axes},
                 {"marker_count", marker_count},
                 {"missing", missing}};
  json["rest_px"] = ForceJson::array();
  for (const Eigen::Vector2d& rest : rest_px)
    for (const double coordinate : rest) json["rest_px"].push_back(coordinate);
  json["creep_s"] = creep_s;
  json["record"] = ForceJson::object();
  for (const auto& [key, text] : record) json["record"][key] = text;
  json["scores"] = {{"floor_N", json_of_vector(scores.floor_N)},
                    {"rms", json_of_vector(scores.rms)},
                    {"quantile_90", json_of_vector(scores.quantile_90)},
                    {"quantile_95", json_of_vector(scores.quantile_95)}};
  json["range"] = json_of(range);
  json["members"] = ForceJson::array();
  for (const ForceMember& member : members) json["members"].push_back(json_of(member));
  return json.dump(-1, ' ', false, ForceJson::error_handler_t::replace);
}

Status ForceModel::validate() const {
  try {
    check_model(*this);
  } catch (const RefusedForceModel& refused) {
    return refused.error;
  }
  return {};
}

Result<ForceModel> ForceModel::parse(std::string_view text, const std::filesystem::path& origin) {
  const auto at_origin = [&](const Error& error) {
    return Error{error.what, origin.string() + ": " + error.where.english(), error.advice};
  };
  const ForceJson json = ForceJson::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded())
    return Error{en::say("is not a force model: damaged or truncated"), origin,
                 en::say("train the force model again")};
  try {
    ForceModel model = model_from(json);
    check_model(model);
    return model;
  } catch (const RefusedForceModel& refused) {
    return at_origin(refused.error);
  }
}

Result<ForceModel> ForceModel::load(const std::filesystem::path& file) {
  const auto content = read_file(file, kLargestModel);
  if (!content) return content.error();
  return parse(*content, file);
}

}  // namespace alltact
