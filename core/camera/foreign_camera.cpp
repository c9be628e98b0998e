// Cameras of other programs; camera_file.h describes the formats and their sources.
#include "core/base/letters.h"
#include "core/base/value_tree.h"
#include "core/camera/camera_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// Ends the reading of a file; parse_foreign_camera() catches it.
struct RefusedCamera {
  Error error;
};

enum class Format { kOwn = 1, kMatrix, kKalibr, kMrcal, kPhotonVision, kMatlab, kJson };

/// A camera in a file.
struct Candidate {
  std::string name;  ///< empty: the entire file
  const ValueTree* tree;
  Format format;
  std::string suffix;  ///< of its keys, where several cameras share a map: "1" of cameraMatrix1
};

using Names = std::vector<std::string_view>;

const Names kMatrixNames{
    "cameramatrix", "k",         "mtx",       "intrinsicmatrix", "kmatrix", "cameraintrinsics",
    "intrinsics",   "intrinsic", "cammatrix", "cameramat",       "matrix",  "intrinsicparameters"};
const Names kDistortionNames{"distortioncoefficients",
                             "distortioncoeffs",
                             "distortioncoeff",
                             "distortioncoefs",
                             "distcoefficients",
                             "distcoeffs",
                             "distcoeff",
                             "distcoefs",
                             "distcoef",
                             "distortionparameters",
                             "distortionvector",
                             "distortions",
                             "distortion",
                             "dist",
                             "d",
                             "kc"};
const Names kWidthNames{"imagewidth", "width", "imgwidth"};
const Names kHeightNames{"imageheight", "height", "imgheight"};
const Names kSizeNames{"imagesize",       "size",     "resolution", "imgsize",
                       "imageresolution", "framesize"};
const Names kShapeNames{"imageshape", "imgshape", "shape"};  // numpy's: rows, columns
/// Names of a lens model, and those that may hold anything else as well.
const Names kModelNames{"distortionmodel", "distortiontype", "lensmodel", "lenstype"};
const Names kVagueModelNames{"model", "cameramodel", "cameratype", "projectionmodel"};
const Names kFisheyeFlags{"fisheyemodel", "isfisheye", "fisheye", "usefisheye"};
/// Of stereo cameras in one map.
constexpr std::array kSuffixes{"0", "1", "2", "left", "right", "l", "r"};

enum class Family { kUnnamed = 1, kNone, kPinhole, kFisheye, kUnknown };

Family family_of(std::string_view model) {
  const std::string word = plain_word(model);
  const auto is_one_of = [&](std::initializer_list<const char*> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  if (word.empty() || word == "none") return Family::kNone;
  if (is_one_of({"plumbbob", "brown", "brownconrady", "radtan", "radialtangential", "opencv",
                 "pinhole", "perspective", "standard", "rational", "rationalpolynomial",
                 "thinprism", "thinprismrational", "polynomial", "lensmodelopencv",
                 "lensmodelopencv4", "lensmodelopencv5", "lensmodelopencv8", "lensmodelopencv12"}))
    return Family::kPinhole;
  if (is_one_of({"fisheye", "equidistant", "equi", "kannalabrandt", "kannalabrandt4", "kb4",
                 "opencvfisheye"}))
    return Family::kFisheye;
  return Family::kUnknown;
}

/// Other lens models, where a vague key may hold a camera's name as well.
bool is_other_model(std::string_view model) {
  const std::string word = plain_word(model);
  for (const char* other :
       {"omni", "mei", "ucm", "eucm", "ds", "fov", "scaramuzza", "ocam", "orthographic",
        "spherical", "equirectangular", "division", "stereographic"})
    if (word == other) return true;
  return word.starts_with("omnidir") || word.starts_with("doublesphere") ||
         word.starts_with("lensmodel");
}

bool is_truth(std::string_view text) {
  const std::string word = plain_word(text);
  return word == "1" || word == "true" || word == "yes";
}

const ValueTree* find_plain(const ValueTree& map, const Names& names,
                            const std::string& suffix = "") {
  for (const std::string_view name : names)
    for (const ValueTree& child : map.children)
      if (plain_word(child.key) == std::string(name) + suffix) return &child;
  return nullptr;
}

bool has_exact(const ValueTree& map, std::initializer_list<const char*> keys) {
  return std::any_of(keys.begin(), keys.end(),
                     [&](const char* key) { return map.find(key) != nullptr; });
}

/// The lens of a file before it becomes a camera, with the values that hold it.
struct Lens {
  CameraParameters parameters;
  Message format;
  std::string model;      ///< as the file names it
  std::size_t count = 0;  ///< of coefficients in the file
  const ValueTree *size = nullptr, *matrix = nullptr, *distortion = nullptr;
  std::vector<Message> warnings;
};

class ForeignFile {
 public:
  explicit ForeignFile(fs::path origin) : origin_(std::move(origin)) {}

  [[nodiscard]] CameraFile camera(const Candidate& candidate) const {
    Lens lens;
    switch (candidate.format) {
      case Format::kMatrix:
        read_matrix(candidate, lens);
        break;
      case Format::kKalibr:
        read_kalibr(*candidate.tree, lens);
        break;
      case Format::kMrcal:
        read_mrcal(*candidate.tree, lens);
        break;
      case Format::kPhotonVision:
        read_photonvision(*candidate.tree, lens);
        break;
      case Format::kMatlab:
        read_matlab(*candidate.tree, lens);
        break;
      case Format::kJson:
        read_json(*candidate.tree, lens);
        break;
      case Format::kOwn:
        break;
    }
    read_own_additions(*candidate.tree, lens.parameters);
    check(candidate, lens);
    CameraFile file;
    file.understood = understood_camera(lens.parameters, lens.format, lens.model, lens.count);
    file.parameters = std::move(lens.parameters);
    file.warnings = std::move(lens.warnings);
    return file;
  }

  [[noreturn]] void refuse(const ValueTree& at, Message what, Message advice,
                           const std::string& detail = "",
                           ErrorKind kind = ErrorKind::kOther) const {
    std::string where = origin_.string();
    if (at.line > 0) where += fmt::format(":{}", at.line);
    if (!at.key.empty()) where += ": " + printable(at.key);
    if (!detail.empty()) where += " (" + detail + ")";
    throw RefusedCamera{{std::move(what), where, std::move(advice), kind}};
  }

 private:
  // Numbers

  /// `at`: the value that a refusal names.
  void append(const ValueTree& at, const ValueTree& value, std::vector<double>& all) const {
    if (value.is_cut)
      refuse(at, en::say("ends in the middle of a list, as a file that was cut off"),
             en::say("copy the file again, or end its last line with a line break"));
    if (value.is_map()) {
      const ValueTree* data = value.find("data");
      if (data == nullptr || data->is_map())
        refuse(at, en::say("is a block without 'data'"), en::say("[..., ...]"));
      return append(at, *data, all);
    }
    for (const ValueTree& item : value.children) append(at, item, all);
    if (value.kind == ValueTree::Kind::kText) append_words(at, value.text, all);
    if (all.size() > kMaxNumbers) refuse(at, en::say("holds more numbers than a camera has"), "");
  }

  void append_words(const ValueTree& at, std::string_view text, std::vector<double>& all) const {
    constexpr std::string_view kBetween = " \t\r\n,;[]()";
    bool is_empty = true;
    while (all.size() <= kMaxNumbers) {
      const std::size_t begin = text.find_first_not_of(kBetween);
      if (begin == std::string_view::npos) break;
      const std::size_t end = std::min(text.find_first_of(kBetween, begin), text.size());
      all.push_back(number(at, text.substr(begin, end - begin)));
      text.remove_prefix(end);
      is_empty = false;
    }
    if (is_empty) refuse(at, en::say("holds no number"), en::say("copy the file again"));
  }

  [[nodiscard]] double number(const ValueTree& at, std::string_view word) const {
    double number = 0;
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (parsed.ec != std::errc() || parsed.ptr != digits.data() + digits.size() ||
        !std::isfinite(number))
      refuse(at, en::say("holds '{}', which is not a finite number", printable(word)),
             en::say("a number such as 24.0, with a point and without a unit"));
    return number;
  }

  [[nodiscard]] std::vector<double> numbers(const ValueTree& value) const {
    std::vector<double> all;
    append(value, value, all);
    if (!value.is_map()) return all;
    const ValueTree *rows = value.find("rows"), *columns = value.find("cols");
    if (rows == nullptr || columns == nullptr) return all;
    const double r = single(*rows), c = single(*columns);
    if (r * c != static_cast<double>(all.size()))
      refuse(value, en::say("holds {} numbers, not {} x {}", all.size(), r, c),
             en::say("copy the file again"));
    return all;
  }

  [[nodiscard]] std::vector<double> numbers(const ValueTree& value, std::size_t count) const {
    std::vector<double> all = numbers(value);
    if (all.size() != count)
      refuse(value, en::say("holds {} numbers instead of {}", all.size(), count), "");
    return all;
  }

  [[nodiscard]] double single(const ValueTree& value) const {
    if (value.kind != ValueTree::Kind::kText) refuse(value, en::say("must be a single number"), "");
    std::vector<double> all;
    append(value, value, all);
    if (all.size() != 1) refuse(value, en::say("must be a single number"), "");
    return all.front();
  }

  [[nodiscard]] const ValueTree& required(const ValueTree& map, const char* key) const {
    if (const ValueTree* found = map.find(key)) return *found;
    refuse(map, en::say("'{}' is missing", std::string(key)), en::say("copy the file again"));
  }

  /// The value of one of the names; another one with other numbers is a contradiction.
  [[nodiscard]] const ValueTree* agreed(const ValueTree& map, const Names& names,
                                        const std::string& suffix) const {
    const ValueTree* first = find_plain(map, names, suffix);
    if (first == nullptr) return nullptr;
    for (const ValueTree& child : map.children)
      if (&child != first)
        for (const std::string_view name : names)
          if (plain_word(child.key) == std::string(name) + suffix &&
              numbers(child) != numbers(*first))
            contradict(child, first->key);
    return first;
  }

  [[noreturn]] void contradict(const ValueTree& at, const std::string& other) const {
    refuse(at, en::say("contradicts '{}'", printable(other)),
           en::say("delete the one that is wrong"));
  }

  // Size, matrix, distortion

  void set_size(Lens& lens, const ValueTree& at, double width, double height) const {
    CameraParameters& p = lens.parameters;
    for (const double side : {width, height})
      if (!(side >= 1 && side <= 1e6 && side == std::floor(side)))
        refuse(at, en::say("{:g} x {:g} is no image size", width, height),
               en::say("[width, height] in pixels"));
    if (lens.size != nullptr && (p.width_px != width || p.height_px != height))
      contradict(at, lens.size->key);
    lens.size = &at;
    p.width_px = static_cast<int>(width), p.height_px = static_cast<int>(height);
  }

  void set_size(Lens& lens, const ValueTree& at) const {
    if (at.is_map() && at.find("data") == nullptr) {
      const ValueTree *width = find_plain(at, kWidthNames), *height = find_plain(at, kHeightNames);
      if (width == nullptr || height == nullptr)
        refuse(at, en::say("holds no width and height"), en::say("[width, height] in pixels"));
      return set_size(lens, at, single(*width), single(*height));
    }
    ValueTree spaced = at;
    std::replace(spaced.text.begin(), spaced.text.end(), 'x', ' ');  // 960x540
    const std::vector<double> sides = numbers(spaced, 2);
    set_size(lens, at, sides[0], sides[1]);
  }

  /// Any of the names, all that there are.
  void find_size(Lens& lens, const ValueTree& map, const std::string& suffix = "") const {
    const ValueTree *width = agreed(map, kWidthNames, suffix),
                    *height = agreed(map, kHeightNames, suffix);
    if (width != nullptr && height != nullptr)
      set_size(lens, *width, single(*width), single(*height));
    for (const ValueTree& child : map.children) {
      const std::string word = plain_word(child.key);
      const auto is_named = [&](const Names& names) {
        return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
          return word == std::string(name) + suffix;
        });
      };
      if (is_named(kSizeNames)) set_size(lens, child);
      if (is_named(kShapeNames)) {
        const std::vector<double> shape = numbers(child);
        if (shape.size() != 2 && shape.size() != 3)
          refuse(child, en::say("holds {} numbers instead of {}", shape.size(), 2), "");
        set_size(lens, child, shape[1], shape[0]);
      }
    }
    if (lens.size == nullptr && !suffix.empty()) find_size(lens, map);
  }

  /// Row by row, with the last row 0 0 1. `is_transposed`: by columns, as in Matlab.
  void set_matrix(Lens& lens, const ValueTree& at, bool is_transposed = false) const {
    std::vector<double> k = numbers(at, 9);
    // Matlab's K is not transposed, its IntrinsicMatrix is.
    if (is_transposed && !(k[6] == 0 && k[7] == 0)) {
      std::swap(k[1], k[3]);
      std::swap(k[2], k[6]);
      std::swap(k[5], k[7]);
    }
    if (std::all_of(k.begin(), k.end(), [](double value) { return value == 0; }))
      refuse(at, en::say("is 0: this camera is not calibrated"),
             en::say("a calibration, as of 'alltact lens'"));
    if (!(k[3] == 0 && k[6] == 0 && k[7] == 0 && std::abs(k[8] - 1) < 1e-9))
      refuse(at, en::say("is no camera matrix, with the last row 0 0 1"),
             en::say("the matrix [fx, 0, cx, 0, fy, cy, 0, 0, 1]"));
    if (std::abs(k[1]) > 1e-9 * std::abs(k[0])) refuse_skew(at, k[1]);
    set_intrinsics(lens, at, {k[0], k[4], k[2], k[5]});
  }

  [[noreturn]] void refuse_skew(const ValueTree& at, double skew) const {
    refuse(at, en::say("has a skew of {:g}, which the camera here cannot have", skew),
           en::say("calibrate again without skew"));
  }

  void set_intrinsics(Lens& lens, const ValueTree& at,
                      const std::array<double, 4>& fx_fy_cx_cy) const {
    lens.matrix = &at;
    CameraParameters& p = lens.parameters;
    p.fx_px = fx_fy_cx_cy[0], p.fy_px = fx_fy_cx_cy[1];
    p.cx_px = fx_fy_cx_cy[2], p.cy_px = fx_fy_cx_cy[3];
  }

  [[noreturn]] void refuse_model(const ValueTree& at, const std::string& model,
                                 const Message& advice) const {
    refuse(at, en::say("the lens model '{}' cannot be expressed here", printable(model)), advice);
  }

  /// Coefficients in OpenCV's order, or a fisheye's.
  void set_distortion(Lens& lens, const ValueTree& at, std::vector<double> terms,
                      Family family) const {
    CameraParameters& p = lens.parameters;
    lens.distortion = &at;
    lens.count = terms.size();
    const auto is_zero = [](double term) { return term == 0; };
    if (family == Family::kFisheye) {
      constexpr std::size_t kTerms = 4;
      if (terms.size() < kTerms || !std::all_of(terms.begin() + kTerms, terms.end(), is_zero))
        refuse(at, en::say("has {} coefficients; a fisheye has 4", terms.size()), "");
      terms.resize(kTerms);
      p.model = CameraModel::kFisheye;
      p.distortion = std::move(terms);
      return;
    }
    constexpr std::array<std::size_t, 6> kCounts{0, 4, 5, 8, 12, 14};
    if (std::find(kCounts.begin(), kCounts.end(), terms.size()) == kCounts.end())
      refuse(at, en::say("has {} coefficients; OpenCV knows 4, 5, 8, 12 and 14", terms.size()), "");
    constexpr std::size_t kOfTilt = 12;
    if (terms.size() > kOfTilt && !std::all_of(terms.begin() + kOfTilt, terms.end(), is_zero))
      refuse(at, en::say("describes a tilted sensor, which cannot be expressed here"),
             en::say("calibrate again without CALIB_TILTED_MODEL, or run 'alltact lens'"));
    if (std::all_of(terms.begin(), terms.end(), is_zero)) return;  // a pinhole
    if (family == Family::kNone)
      refuse(at, en::say("has coefficients, while the file names no lens model"),
             en::say("add the model's name, such as plumb_bob"));
    while (terms.size() > 8 && std::all_of(terms.begin() + 8, terms.end(), is_zero))
      terms.resize(8);
    if (terms.size() > 5 && std::all_of(terms.begin() + 5, terms.end(), is_zero)) terms.resize(5);
    terms.resize(std::min(terms.size(), kOfTilt));
    p.model = CameraModel::kBrown;
    p.distortion = std::move(terms);
  }

  // ROS and OpenCV: a matrix and coefficients

  [[nodiscard]] Family find_family(const ValueTree& map, Lens& lens) const {
    Family family = Family::kUnnamed;
    const ValueTree* named = nullptr;
    const auto agree = [&](const ValueTree& at, Family other) {
      if (named != nullptr && other != family && family != Family::kNone && other != Family::kNone)
        contradict(at, named->key);
      if (family == Family::kUnnamed || family == Family::kNone) family = other, named = &at;
    };
    const Message advice = en::say("run 'alltact lens' with images of a board");
    for (const ValueTree& child : map.children) {
      if (child.kind != ValueTree::Kind::kText) continue;
      const std::string word = plain_word(child.key);
      const auto is_in = [&](const Names& names) {
        return std::find(names.begin(), names.end(), word) != names.end();
      };
      const Family other = family_of(child.text);
      if (is_in(kModelNames)) {
        if (other == Family::kUnknown) refuse_model(child, child.text, advice);
        agree(child, other);
        if (other != Family::kNone) lens.model = child.text;
      } else if (is_in(kVagueModelNames)) {
        if (is_other_model(child.text)) refuse_model(child, child.text, advice);
        if (other == Family::kPinhole || other == Family::kFisheye) agree(child, other);
      } else if (is_in(kFisheyeFlags) && is_truth(child.text)) {
        agree(child, Family::kFisheye);
      }
    }
    return family;
  }

  void refuse_cut_images(const ValueTree& map) const {
    for (const char* key : {"binning_x", "binning_y"})
      if (const ValueTree* binning = map.find(key); binning != nullptr && single(*binning) > 1)
        refuse(*binning,
               en::say("the camera bins its images by {:g}, while its matrix holds for full images",
                       single(*binning)),
               en::say("the camera without binning, and 'binning_x: 1', 'binning_y: 1'"));
    const ValueTree* roi = map.find("roi");
    if (roi == nullptr || !roi->is_map()) return;
    const auto value = [&](const char* key) {
      const ValueTree* found = roi->find(key);
      return found == nullptr ? 0.0 : single(*found);
    };
    const double width = value("width"), height = value("height");
    const ValueTree *full_width = find_plain(map, kWidthNames),
                    *full_height = find_plain(map, kHeightNames);
    const bool is_cut = value("x_offset") != 0 || value("y_offset") != 0 ||
                        (width != 0 && full_width != nullptr && width != single(*full_width)) ||
                        (height != 0 && full_height != nullptr && height != single(*full_height));
    if (is_cut)
      refuse(*roi, en::say("the camera sends a part of its image, while its matrix holds for all"),
             en::say("the camera without a region of interest, and a file without 'roi'"));
  }

  void refuse_other_numbers(const ValueTree& map, const Lens& lens) const {
    const CameraParameters& p = lens.parameters;
    for (const auto& [key, value] :
         {std::pair{"fx", p.fx_px}, {"fy", p.fy_px}, {"cx", p.cx_px}, {"cy", p.cy_px}})
      if (const ValueTree* other = map.find(key); other != nullptr)
        if (!(std::abs(single(*other) - value) <= 1e-6 * std::abs(value)))
          contradict(*other, lens.matrix->key);
  }

  void read_matrix(const Candidate& candidate, Lens& lens) const {
    const ValueTree& map = *candidate.tree;
    const std::string& suffix = candidate.suffix;
    Names matrix_names = kMatrixNames;
    if (!suffix.empty()) matrix_names.push_back("m");  // of OpenCV's stereo sample
    const ValueTree* matrix = agreed(map, matrix_names, suffix);
    const ValueTree* distortion = agreed(map, kDistortionNames, suffix);
    if (matrix == nullptr)
      refuse(map, en::say("the camera matrix is missing"),
             en::say("add 'camera_matrix: [fx, 0, cx, 0, fy, cy, 0, 0, 1]'"));
    const bool is_opencv = matrix->tag.find("opencv-matrix") != std::string::npos ||
                           matrix->find("type_id") != nullptr;
    const bool is_ros =
        !is_opencv && (has_exact(map, {"distortion_model", "rectification_matrix",
                                       "projection_matrix", "binning_x", "P", "p"}));
    lens.format = is_ros ? en::say("a ROS camera_info file") : en::say("an OpenCV calibration");
    refuse_cut_images(map);
    set_matrix(lens, *matrix);
    refuse_other_numbers(map, lens);
    find_size(lens, map, suffix);
    const Family family = find_family(map, lens);
    if (distortion == nullptr)
      refuse(
          map, en::say("the distortion coefficients are missing"),
          en::say("add 'distortion_coefficients: [0, 0, 0, 0, 0]' where there is no distortion"));
    set_distortion(lens, *distortion, numbers(*distortion), family);
    if (lens.model.empty())
      lens.model = family == Family::kFisheye ? "fisheye"
                   : lens.count <= 5          ? "plumb_bob"
                   : lens.count <= 8          ? "rational_polynomial"
                                              : "thin_prism";
    constexpr std::size_t kOfFisheye = 4;
    if (family != Family::kUnnamed || lens.count != kOfFisheye) return;
    const Message guess = en::say(
        "no lens model is named, so that the 4 coefficients are read as k1 k2 p1 p2; for a fisheye "
        "add 'distortion_model: fisheye'");
    lens.warnings.push_back(en::say("{}.", en::at(Where(origin_), guess)));
  }

  // Other programs

  void read_kalibr(const ValueTree& map, Lens& lens) const {
    lens.format = en::say("a Kalibr camera chain");
    const Message advice = en::say("calibrate again with pinhole-radtan or pinhole-equi");
    const ValueTree &model = required(map, "camera_model"),
                    &distortion_model = required(map, "distortion_model");
    if (model.text != "pinhole") refuse_model(model, model.text, advice);
    const Family family = family_of(distortion_model.text);
    if (family == Family::kUnknown) refuse_model(distortion_model, distortion_model.text, advice);
    const ValueTree &intrinsics = required(map, "intrinsics"),
                    &distortion = required(map, "distortion_coeffs");
    const std::vector<double> k = numbers(intrinsics, 4);
    set_intrinsics(lens, intrinsics, {k[0], k[1], k[2], k[3]});
    set_size(lens, required(map, "resolution"));
    std::vector<double> terms = numbers(distortion);
    if (family != Family::kNone) terms = numbers(distortion, 4);
    lens.model = distortion_model.text;
    set_distortion(lens, distortion, std::move(terms), family);
  }

  void read_mrcal(const ValueTree& map, Lens& lens) const {
    lens.format = en::say("an mrcal camera model");
    const ValueTree &model = required(map, "lensmodel"), &intrinsics = required(map, "intrinsics");
    std::size_t count = 0;
    const std::string& name = model.text;
    if (name == "LENSMODEL_OPENCV4" || name == "LENSMODEL_OPENCV5" || name == "LENSMODEL_OPENCV8" ||
        name == "LENSMODEL_OPENCV12")
      count = name.ends_with("12") ? 12 : static_cast<std::size_t>(name.back() - '0');
    else if (name != "LENSMODEL_PINHOLE")
      refuse_model(model, name,
                   en::say("convert it with mrcal-convert-lensmodel to LENSMODEL_OPENCV8"));
    std::vector<double> k = numbers(intrinsics, 4 + count);
    set_intrinsics(lens, intrinsics, {k[0], k[1], k[2], k[3]});
    set_size(lens, required(map, "imagersize"));
    k.erase(k.begin(), k.begin() + 4);
    lens.model = name;
    set_distortion(lens, intrinsics, std::move(k), Family::kPinhole);
  }

  void read_photonvision(const ValueTree& map, Lens& lens) const {
    lens.format = en::say("a PhotonVision calibration");
    if (const ValueTree* model = map.find("lensmodel")) {
      if (family_of(model->text) != Family::kPinhole)
        refuse_model(*model, model->text, en::say("calibrate again with LENSMODEL_OPENCV"));
      lens.model = model->text;
    }
    set_matrix(lens, required(map, "cameraIntrinsics"));
    set_size(lens, required(map, "resolution"));
    // Older versions wrote the coefficients under another name.
    const ValueTree* older = map.find("cameraExtrinsics");
    const ValueTree& distortion = older != nullptr && map.find("distCoeffs") == nullptr
                                      ? *older
                                      : required(map, "distCoeffs");
    if (lens.model.empty()) lens.model = "LENSMODEL_OPENCV";
    set_distortion(lens, distortion, numbers(distortion), Family::kPinhole);
  }

  void read_matlab(const ValueTree& map, Lens& lens) const {
    lens.format = en::say("Matlab's camera parameters");
    lens.model = "radial and tangential";
    if (const ValueTree* fisheye = map.find("MappingCoefficients"))
      refuse_model(*fisheye, "fisheyeIntrinsics",
                   en::say("run 'alltact lens' with images of a board"));
    const ValueTree* nested = map.find("Intrinsics");
    const ValueTree& intrinsics = nested != nullptr && nested->is_map() ? *nested : map;
    const ValueTree* matrix = intrinsics.find("IntrinsicMatrix");
    const ValueTree *focal = intrinsics.find("FocalLength"),
                    *centre = intrinsics.find("PrincipalPoint");
    if (matrix == nullptr) matrix = intrinsics.find("K");
    if (focal != nullptr && centre != nullptr) {
      std::vector<double> f = numbers(*focal);
      if (f.size() == 1) f.push_back(f[0]);
      if (f.size() != 2) refuse(*focal, en::say("holds {} numbers instead of {}", f.size(), 2), "");
      const std::vector<double> c = numbers(*centre, 2);
      set_intrinsics(lens, *focal, {f[0], f[1], c[0], c[1]});
    } else if (matrix != nullptr) {
      set_matrix(lens, *matrix, true);
    } else {
      refuse(map, en::say("the focal lengths are missing"),
             en::say("in Matlab: writelines(jsonencode(toStruct(cameraParams)), 'camera.json')"));
    }
    if (const ValueTree* skew = intrinsics.find("Skew"); skew != nullptr && single(*skew) != 0)
      refuse_skew(*skew, single(*skew));
    // The centre of Matlab's top-left pixel is (1, 1).
    lens.parameters.cx_px -= 1;
    lens.parameters.cy_px -= 1;
    const ValueTree* size = intrinsics.find("ImageSize");
    if (size == nullptr) size = map.find("ImageSize");
    if (size == nullptr || (size->kind != ValueTree::Kind::kMap && numbers(*size).empty()))
      refuse_missing_size(map);
    const std::vector<double> rows_columns = numbers(*size, 2);
    set_size(lens, *size, rows_columns[1], rows_columns[0]);
    const ValueTree &radial = required(map, "RadialDistortion"),
                    &tangential = required(map, "TangentialDistortion");
    std::vector<double> k = numbers(radial);
    const std::vector<double> p = numbers(tangential, 2);
    if (k.size() != 2 && k.size() != 3)
      refuse(radial, en::say("holds {} numbers instead of {}", k.size(), 3), "");
    k.resize(3);
    set_distortion(lens, radial, {k[0], k[1], p[0], p[1], k[2]}, Family::kPinhole);
  }

  /// calibration.json of `alltact export`.
  void read_json(const ValueTree& map, Lens& lens) const {
    lens.format = en::say("a calibration.json of this program");
    CameraParameters& p = lens.parameters;
    const ValueTree &model = required(map, "model"), &distortion = required(map, "distortion");
    const auto known = camera_model_from(model.text);
    if (!known) refuse_model(model, model.text, en::say("a newer version of this program"));
    p.model = *known;
    set_size(lens, required(map, "size_px"));
    const ValueTree& scale =
        required(map, p.model == CameraModel::kOrthographic ? "mm_per_px" : "fx_px");
    set_intrinsics(lens, scale,
                   {0, 0, single(required(map, "cx_px")), single(required(map, "cy_px"))});
    if (p.model == CameraModel::kOrthographic) {
      p.mm_per_px = single(scale);
    } else {
      p.fx_px = single(scale);
      p.fy_px = single(required(map, "fy_px"));
      lens.model = p.model == CameraModel::kPinhole ? "" : std::string(to_string(p.model));
    }
    lens.distortion = &distortion;
    p.distortion = numbers(distortion);
    lens.count = p.distortion.size();
  }

  /// Keys of this program's own format that no other format knows.
  void read_own_additions(const ValueTree& map, CameraParameters& p) const {
    if (const ValueTree* turn = map.find("orientation");
        turn != nullptr && turn->kind == ValueTree::Kind::kText) {
      const auto orientation = orientation_from(turn->text);
      if (!orientation)
        refuse(*turn, en::say("'{}' is not known here", printable(turn->text)),
               en::say("none, flip_u, flip_v, rotate_180, rotate_90 or rotate_270"));
      p.orientation = *orientation;
    }
    const ValueTree* port = map.find("port");
    if (port == nullptr || !port->is_map()) return;
    p.port =
        FlatPort{single(required(*port, "gap_mm")), single(required(*port, "plate_mm")),
                 single(required(*port, "plate_index")), single(required(*port, "medium_index"))};
  }

  [[noreturn]] void refuse_missing_size(const ValueTree& map) const {
    refuse(map, en::say("the image size is missing"),
           en::say("add image_width and image_height of the calibrated images, in pixels"));
  }

  /// The last checks, which are those of any camera.
  void check(const Candidate& candidate, Lens& lens) const {
    const ValueTree& map = *candidate.tree;
    const CameraParameters& p = lens.parameters;
    if (lens.size == nullptr) refuse_missing_size(map);
    const Status status = check_camera_range(p);
    if (!status) {
      const Error& error = status.error();
      std::string key = error.where.english();
      key = key.substr(key.find('.') + 1);
      const ValueTree* at = key == "size"             ? lens.size
                            : key == "distortion"     ? lens.distortion
                            : key.starts_with("port") ? &map
                                                      : lens.matrix;
      const bool is_named = key == "size" || key == "distortion";
      refuse(at == nullptr ? map : *at, error.what, error.advice, is_named ? "" : key, error.kind);
    }
    if (candidate.format == Format::kJson) return;
    const auto is_outside = [](double centre, int side) {
      return centre < -0.5 || centre > side - 0.5;
    };
    if (is_outside(p.cx_px, p.width_px) || is_outside(p.cy_px, p.height_px))
      refuse(*lens.matrix,
             en::say("the principal point {:.1f}, {:.1f} lies outside the image of {} x {} px",
                     p.cx_px, p.cy_px, p.width_px, p.height_px),
             en::say("the size [width, height] of the images that were calibrated"));
    CameraParameters turned = p;
    std::swap(turned.width_px, turned.height_px);
    const std::vector<Error> unlikely = implausible_camera(p);
    if (!unlikely.empty() && implausible_camera(turned).empty())
      refuse(
          *lens.size,
          en::say("the principal point {:.1f}, {:.1f} is the middle of {} x {} px, not of {} x {}",
                  p.cx_px, p.cy_px, p.height_px, p.width_px, p.width_px, p.height_px),
          en::say("the size [width, height] of the images that were calibrated"));
    for (const Error& one : unlikely) {
      const Message remark = en::at(one.where, one.what);
      lens.warnings.push_back(en::say("{}.", en::at(Where(origin_), remark)));
    }
  }

  static constexpr std::size_t kMaxNumbers = 64;
  fs::path origin_;
};

bool is_own(const ValueTree& map) {
  return has_exact(map, {"model", "size", "fx", "fy", "cx", "cy", "mm_per_px", "distortion",
                         "orientation", "port"});
}

std::optional<Format> format_of(const ValueTree& map) {
  if (has_exact(map, {"lensmodel"}) && has_exact(map, {"intrinsics", "imagersize"}))
    return Format::kMrcal;
  if (has_exact(map, {"cameraIntrinsics"}) && has_exact(map, {"resolution"}))
    return Format::kPhotonVision;
  if (has_exact(map, {"camera_model"}) && has_exact(map, {"intrinsics"}) &&
      has_exact(map, {"resolution", "distortion_coeffs", "distortion_model"}))
    return Format::kKalibr;
  if (has_exact(map, {"size_px"}) && has_exact(map, {"model"})) return Format::kJson;
  if (has_exact(map, {"IntrinsicMatrix", "FocalLength", "RadialDistortion", "MappingCoefficients"}))
    return Format::kMatlab;
  if (find_plain(map, kMatrixNames) != nullptr) return Format::kMatrix;
  // Also without its matrix, so that its absence is reported.
  const ValueTree* distortion = find_plain(map, kDistortionNames);
  if (distortion != nullptr && distortion->key != "distortion" && !is_own(map))
    return Format::kMatrix;
  return std::nullopt;
}

/// Cameras of a stereo rig in one map: camera_matrix_left, D2, ...
std::vector<Candidate> paired(const ValueTree& map, const std::string& name) {
  std::vector<Candidate> found;
  Names names = kMatrixNames;
  names.push_back("m");
  for (const char* suffix : kSuffixes)
    if (find_plain(map, names, suffix) != nullptr &&
        find_plain(map, kDistortionNames, suffix) != nullptr)
      found.push_back({name.empty() ? suffix : name + "." + suffix, &map, Format::kMatrix, suffix});
  return found;
}

constexpr std::size_t kMaxCandidates = 100;

void collect(const ValueTree& tree, const std::string& name, int depth,
             std::vector<Candidate>& found) {
  constexpr int kMaxDepth = 5;
  if (depth > kMaxDepth || found.size() >= kMaxCandidates) return;
  if (tree.is_map()) {
    if (const auto format = format_of(tree)) {
      found.push_back({name, &tree, *format, ""});
      return;
    }
    std::vector<Candidate> pair = paired(tree, name);
    if (!pair.empty()) {
      found.insert(found.end(), pair.begin(), pair.end());
      return;
    }
    if (depth <= 1 && (name.empty() || name == "camera") && is_own(tree)) {
      found.push_back({name, &tree, Format::kOwn, ""});
      if (!name.empty()) return;
    }
  }
  std::size_t index = 0;
  for (const ValueTree& child : tree.children) {
    const std::string key = child.key.empty() ? fmt::format("{}", index) : child.key;
    collect(child, name.empty() ? key : name + "." + key, depth + 1, found);
    ++index;
  }
}

/// The camera that `name` names, or the only one.
const Candidate& chosen(const std::vector<Candidate>& found, const std::string& name,
                        const fs::path& origin) {
  std::vector<std::string> names;
  for (const Candidate& one : found) names.push_back(printable(one.name));
  if (!name.empty()) {
    for (const Candidate& one : found)
      if (one.name == name) return one;
    throw RefusedCamera{
        {en::say("holds no camera '{}'", printable(name)), origin, one_of(names, name)}};
  }
  if (found.size() == 1) return found.front();
  std::vector<Message> list;
  for (const std::string& one : names) list.push_back(Message::typed(one.empty() ? "-" : one));
  throw RefusedCamera{{en::say("holds {} cameras: {}", found.size(), en::list(list)), origin,
                       en::say("one of them by its name: '{}#{}'", origin,
                               names.front().empty() ? names.back() : names.front())}};
}

}  // namespace

Result<std::optional<CameraFile>> parse_foreign_camera(const std::string& content,
                                                       const fs::path& origin,
                                                       const std::string& name) {
  const auto tree = parse_values(content, origin);
  if (!tree) return tree.error();
  try {
    if (const ValueTree* node = tree->find("/**"); node != nullptr)
      return Error{en::say("holds parameters of a ROS node, without focal lengths"), origin,
                   en::say("camera_info.yaml of the same export")};
    std::vector<Candidate> found;
    collect(*tree, "", 0, found);
    if (found.empty()) {
      const bool is_empty = tree->children.empty() && tree->text.empty();
      if (is_empty || tree->find("camera") != nullptr) return std::optional<CameraFile>();
      return Error{en::say("holds no camera that is known here"), origin,
                   en::say("a file of 'alltact lens', ROS, OpenCV, Kalibr, mrcal, PhotonVision or "
                           "Matlab")};
    }
    const Candidate& candidate = chosen(found, name, origin);
    if (candidate.format == Format::kOwn) return std::optional<CameraFile>();
    return std::optional(ForeignFile(origin).camera(candidate));
  } catch (const RefusedCamera& refused) {
    return refused.error;
  }
}

}  // namespace alltact
