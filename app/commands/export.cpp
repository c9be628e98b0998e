#include "app/commands/commands.h"
#include "core/finger/mapping.h"
#include "core/io/atomic_file.h"

#include <fmt/format.h>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

using Json = Console::Json;

Result<std::string> opencv_camera(const Finger& finger, const Path& finger_folder) {
  const CameraParameters& camera = finger.camera;
  if (camera.model == CameraModel::kOrthographic) {
    return Error{"an orthographic camera has no camera matrix, so OpenCV has no form for it",
                 finger_folder.string(),
                 "--to json"};
  }
  if (camera.port)
    return Error{"a camera behind a window has no camera matrix, so OpenCV has no form for it",
                 finger_folder.string(),
                 "--to json"};
  // OpenCV wants all five coefficients (fisheye: four); those not given are zero.
  const bool fisheye = camera.model == CameraModel::kFisheye;
  cv::Mat distortion = cv::Mat::zeros(1, fisheye ? 4 : 5, CV_64F);
  for (std::size_t i = 0; i < camera.distortion.size(); ++i)
    distortion.at<double>(0, static_cast<int>(i)) = camera.distortion[i];
  const cv::Mat matrix = (cv::Mat_<double>(3, 3) << camera.fx_px,
                          0,
                          camera.cx_px,
                          0,
                          camera.fy_px,
                          camera.cy_px,
                          0,
                          0,
                          1);
  // Pixels are those after orientation, the centre of the top-left one at (0, 0), as in OpenCV.
  cv::FileStorage file(".yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  file << "camera_name" << finger.name;
  file << "image_width" << camera.width_px << "image_height" << camera.height_px;
  file << "camera_matrix" << matrix;
  file << "distortion_model" << std::string(fisheye ? "fisheye" : "plumb_bob");
  file << "distortion_coefficients" << distortion;
  return file.releaseAndGetString();
}

Json camera_json(const CameraParameters& camera) {
  Json json;
  json["model"] = to_string(camera.model);
  json["size_px"] = {camera.width_px, camera.height_px};
  if (camera.model == CameraModel::kOrthographic) {
    json["mm_per_px"] = camera.mm_per_px;
  } else {
    json["fx_px"] = camera.fx_px;
    json["fy_px"] = camera.fy_px;
  }
  json["cx_px"] = camera.cx_px;
  json["cy_px"] = camera.cy_px;
  json["distortion"] = camera.distortion;
  json["orientation"] = to_string(camera.orientation);
  if (camera.port)
    json["port"] = {{"gap_mm", camera.port->gap_mm},
                    {"plate_mm", camera.port->plate_mm},
                    {"plate_index", camera.port->plate_index},
                    {"medium_index", camera.port->medium_index}};
  return json;
}

Json covariance_json(const Eigen::MatrixXd& covariance) {
  Json rows = Json::array();
  for (Eigen::Index r = 0; r < covariance.rows(); ++r) {
    Json row = Json::array();
    for (Eigen::Index c = 0; c < covariance.cols(); ++c) row.push_back(covariance(r, c));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json mapping_json(const Mapping& mapping, const std::optional<MappingRecord>& record) {
  const MappingParameters& parameters = mapping.parameters();
  Json json;
  json["formula"] = "depth_mm = M(x), x = (reference - picture) / reference";
  json["along"] = to_string(parameters.along);
  json["domain"] = {0.0, parameters.x_max};
  if (parameters.kind == MappingKind::kPolynomial) {
    json["kind"] = "polynomial";
    json["chebyshev_mm"] = parameters.chebyshev;
    json["powers_mm"] = mapping.powers();
  } else {
    json["kind"] = "moebius";
    json["a_mm"] = parameters.a_mm;
    json["b"] = parameters.b;
  }
  if (const FaceVariation& varies = parameters.variation; !varies.is_none()) {
    json["varies"] = {
        {"formula",
         "depth_mm = M(x) (1 + along s + across t), (s, t) = (place - middle) / half, "
         "each from -1 to 1, place in mm along the face from its base and across it"},
        {"along", varies.part.x()},
        {"across", varies.part.y()},
        {"middle_mm", {varies.middle_mm.x(), varies.middle_mm.y()}},
        {"half_mm", {varies.half_mm.x(), varies.half_mm.y()}}};
  }
  if (parameters.covariance.size() > 0) json["covariance"] = covariance_json(parameters.covariance);
  if (record) {
    json["method"] = record->method;
    json["presses"] = record->presses;
    json["residual_mm"] = record->residual_mm;
    if (record->held_out_mm > 0) json["held_out_mm"] = record->held_out_mm;
    if (record->spread_mm > 0) json["spread_mm"] = record->spread_mm;
    json["degree_choice"] = record->degree_choice;
  }
  return json;
}

Result<std::string> whole_calibration(const Finger& finger) {
  Json json;
  json["format"] = "alltact-calibration/1";
  json["name"] = finger.name;
  json["camera"] = camera_json(finger.camera);
  const bool flat = finger.face.kind == FaceKind::kFlat;
  Json face;
  face["kind"] = flat ? "flat" : "fin_ray";
  if (flat) {
    face["plane_z_mm"] = finger.face.plane_z_mm;
  } else {
    face["width_mm"] = finger.face.width_mm;
  }
  face["layer_mm"] = finger.face.layer_mm;
  json["face"] = std::move(face);
  if (!flat) json["markers"]["per_row"] = finger.markers.per_row;
  if (finger.mapping) {
    const auto mapping = Mapping::create(*finger.mapping);
    if (!mapping) return mapping.error();
    json["mapping"] = mapping_json(*mapping, finger.mapping_record);
  }
  if (finger.contact) {
    Json& contact = json["contact"];
    contact["threshold_px"] = finger.contact->threshold_px;
    for (const auto& marker : finger.contact->rest_markers)
      contact["rest_markers_px"].push_back({marker.x(), marker.y()});
  }
  json["provenance"] = finger.provenance;
  return json.dump(2) + "\n";
}

Status write_part(const Path& file, const Result<std::string>& content, Console& console) {
  if (!content) return content.error();
  if (const Status status = write_file_atomically(file, *content); !status) return status;
  console.say(file.string());
  console.answer()["files"].push_back(file.string());
  return {};
}

}  // namespace

Status run_export(const ExportOptions& options, Console& console) {
  const auto finger = load_finger(options.finger, console);
  if (!finger) return finger.error();
  if (const Status status = make_folder(options.folder); !status) return status;
  if (options.opencv) {
    const Status status = write_part(
        options.folder / "camera.opencv.yaml", opencv_camera(*finger, options.finger), console);
    if (!status) return status;
  }
  if (options.json)
    return write_part(options.folder / "calibration.json", whole_calibration(*finger), console);
  return {};
}

void add_export(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ExportOptions>();
  auto forms = std::make_shared<std::vector<std::string>>();
  CLI::App* command = program.add_subcommand("export", "Writes the calibration for other programs");
  command->add_option("FINGER", options->finger, "The finger's folder")->required();
  command
      ->add_option("--to",
                   *forms,
                   "With commas: opencv (camera.opencv.yaml, for cv::FileStorage), json "
                   "(calibration.json, everything)")
      ->type_name("LIST")
      ->delimiter(',')
      ->take_all()
      ->expected(1)
      ->check(CLI::IsMember({"opencv", "json"}))
      ->required();
  command->add_option("-o,--output", options->folder, "Folder for the files")
      ->type_name("DIR")
      ->required();
  command->callback([=, &chosen] {
    for (const std::string& form : *forms) {
      options->opencv = options->opencv || form == "opencv";
      options->json = options->json || form == "json";
    }
    chosen = [=](Console& console) { return run_export(*options, console); };
  });
}

}  // namespace alltact
