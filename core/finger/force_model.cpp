#include "core/finger/force_model.h"

#include "core/base/atomic_file.h"
#include "core/base/json_fields.h"
#include "core/base/message.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>

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
  if (input.seen.size() != marker_count ||
      input.displacement_px.size() != Eigen::Index{2} * marker_count || input.seen.sum() < 0.5 ||
      !is_usable(input.displacement_px) || !is_usable(input.crept_px))
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

constexpr double kLargestNumber = 1e12;
constexpr std::size_t kLargestModel = std::size_t{256} << 20;
constexpr Eigen::Index kMaxMembers = 200, kMaxFeatures = 20000;

[[noreturn]] void refuse_model(const std::string& key, Message what) {
  throw RefusedJson(key, std::move(what));
}

Error retrained(const RefusedJson& refused) {
  return {refused.what_is_wrong, refused.path, en::say("train the force model again")};
}

void describe_vector(JsonFields& fields, const char* key, Eigen::VectorXd& vector) {
  std::vector<double> numbers;
  if (!fields.is_reading()) numbers.assign(vector.begin(), vector.end());
  fields.field(key, numbers);
  vector = Eigen::Map<const Eigen::VectorXd>(numbers.data(), std::ssize(numbers));
}

/// A text; read as empty where it is another value.
void describe_word(JsonFields& fields, const char* key, std::string& word) {
  if (!fields.is_reading()) return fields.field(key, word);
  fields.section(key, [&](JsonFields& text) {
    word = text.json().is_string() ? text.json().get<std::string>() : "";
  });
}

}  // namespace

/// Row by row.
static void describe(JsonFields& fields, Eigen::MatrixXd& matrix) {
  using RowMajor = Eigen::Matrix<double, -1, -1, Eigen::RowMajor>;
  int rows = static_cast<int>(matrix.rows()), columns = static_cast<int>(matrix.cols());
  const RowMajor by_rows = matrix;
  Eigen::VectorXd numbers = Eigen::Map<const Eigen::VectorXd>(by_rows.data(), by_rows.size());
  fields.field("rows", rows);
  fields.field("columns", columns);
  describe_vector(fields, "numbers", numbers);
  if (rows < 0 || columns < 0 || rows > kMaxFeatures || columns > kMaxFeatures ||
      Eigen::Index{rows} * columns != numbers.size())
    fields.refuse(en::say("holds {} numbers, not {} x {}", numbers.size(), rows, columns));
  matrix = Eigen::Map<const RowMajor>(numbers.data(), rows, columns);
}

static void describe(JsonFields& fields, ForceRange& range) {
  describe_vector(fields, "mean_px", range.mean_px);
  fields.field("components", range.components);
  describe_vector(fields, "component_sd_px", range.component_sd_px);
  fields.field("noise_px", range.noise_px);
  fields.field("most_t2", range.max_t2);
  fields.field("most_beside_px", range.max_residual_px);
  fields.field("least_seen", range.min_seen);
  fields.field("always_placed", range.has_all_positions);
  std::optional<std::vector<std::vector<double>>> corners;
  if (range.position_mm)
    for (corners.emplace(); const Eigen::Vector2d& position : *range.position_mm)
      corners->push_back({position.x(), position.y()});
  fields.field("place_mm", corners);
  if (!corners) return;
  if (corners->size() != 2) refuse_model("range.place_mm", en::say("must be two positions"));
  range.position_mm.emplace();
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<double>& corner = (*corners)[i];
    if (corner.size() != 2) refuse_model("range.place_mm", en::say("must be two positions"));
    (*range.position_mm)[i] = {corner[0], corner[1]};
  }
}

static void describe(JsonFields& fields, ForceLayer& layer) {
  fields.field("weights", layer.weights);
  describe_vector(fields, "bias", layer.bias);
}

static void describe(JsonFields& fields, ForceMember& member) {
  ForceBasis& basis = member.basis;
  describe_vector(fields, "mean_px", basis.mean_px);
  describe_vector(fields, "scale", basis.scale);
  fields.field("components", basis.components);
  describe_vector(fields, "gain", basis.gain);
  fields.field("flags", basis.flags);
  fields.field("has_place", basis.has_position);
  fields.field("crept", basis.crept);
  describe_vector(fields, "extra_mean", basis.extra_mean);
  describe_vector(fields, "extra_scale", basis.extra_scale);
  fields.field("squared", basis.squared);
  fields.field("regressors", member.regressors);
}

static void describe(JsonFields& fields, ForceScores& scores) {
  describe_vector(fields, "floor_N", scores.floor_N);
  describe_vector(fields, "rms", scores.rms);
  describe_vector(fields, "quantile_90", scores.quantile_90);
  describe_vector(fields, "quantile_95", scores.quantile_95);
}

static void describe(JsonFields& fields, std::map<std::string, std::string>& record) {
  if (!fields.is_reading()) {
    for (auto& [key, text] : record) fields.field(key, text);
    return;
  }
  if (!fields.json().is_object()) fields.refuse(en::say("is not an object"));
  for (const auto& [key, text] : fields.json().items()) {
    if (!text.is_string()) fields.refuse(en::say("contains non-text values"));
    record[key] = text.get<std::string>();
  }
}

static void describe(JsonFields& fields, ForceModel& model) {
  std::string format = ForceModel::kFormat, kind = to_string(model.kind);
  describe_word(fields, "format", format);
  if (format != ForceModel::kFormat)
    refuse_model("format", en::say("'{}' cannot be read by this version", printable(format)));
  describe_word(fields, "kind", kind);
  const auto word = std::find(kForceKinds.begin(), kForceKinds.end(), kind);
  if (word == kForceKinds.end())
    refuse_model("kind", en::say("must be mean, ridge, quadratic or network"));
  model.kind = static_cast<ForceKind>(word - kForceKinds.begin() + 1);
  fields.field("axes", model.axes);
  fields.field("marker_count", model.marker_count);
  fields.field("missing", model.missing);
  std::vector<double> rest_px;
  for (const Eigen::Vector2d& rest : model.rest_px)
    rest_px.insert(rest_px.end(), {rest.x(), rest.y()});
  fields.field("rest_px", rest_px);
  model.rest_px.clear();
  for (std::size_t i = 0; i + 1 < rest_px.size(); i += 2)
    model.rest_px.emplace_back(rest_px[i], rest_px[i + 1]);
  fields.field("creep_s", model.creep_s);
  fields.field("record", model.record);
  fields.field("scores", model.scores);
  fields.field("range", model.range);
  fields.field("members", model.members);
}

namespace {

void check_shape(bool holds, const std::string& key) {
  if (!holds) refuse_model(key, en::say("does not have the shape that the model needs"));
}

void check_range(const ForceModel& model) {
  const ForceRange& range = model.range;
  const Eigen::Index columns = Eigen::Index{2} * model.marker_count,
                     k = range.component_sd_px.size();
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
  const Eigen::Index columns = Eigen::Index{2} * model.marker_count, p = basis.gain.size();
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
  return written_json(*this).dump(-1, ' ', false, JsonFields::Json::error_handler_t::replace);
}

Status ForceModel::validate() const {
  try {
    check_model(*this);
  } catch (const RefusedJson& refused) {
    return retrained(refused);
  }
  return {};
}

Result<ForceModel> ForceModel::parse(std::string_view text, const std::filesystem::path& origin) {
  const auto json = JsonFields::Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded())
    return Error{en::say("is not a force model: damaged or truncated"), origin,
                 en::say("train the force model again")};
  try {
    ForceModel model;
    JsonFields fields(json, {.root = "force", .largest = kLargestNumber});
    describe(fields, model);
    check_model(model);
    return model;
  } catch (const RefusedJson& refused) {
    Error error = retrained(refused);
    error.where = origin.string() + ": " + refused.path;
    return error;
  }
}

Result<ForceModel> ForceModel::load(const std::filesystem::path& file) {
  const auto content = read_file(file, kLargestModel);
  if (!content) return content.error();
  return parse(*content, file);
}

}  // namespace alltact
