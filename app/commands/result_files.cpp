#include "app/commands/result_files.h"

#include "core/io/atomic_file.h"
#include "core/io/depth_file.h"
#include "core/io/image_file.h"
#include "core/io/surface_file.h"
#include "core/sensing/depth/depth_limits.h"
#include "core/sensing/result_json.h"

#include <fmt/format.h>

namespace alltact {

ReferenceMethod reference_method(const ReconstructOptions& options) {
  return options.as_paper ? ReferenceMethod::kNearest : options.pipeline.reference;
}

namespace {

FrameLine failed(const std::string& name, std::size_t index, const Error& problem) {
  FrameLine line;
  line.frame = name;
  line.line = failure_line(name, index, {as_sentence(problem)});
  line.warnings = {problem.sentence()};
  return line;
}

}  // namespace

void add_depth_steps(std::string& line, const std::string& name, const std::string& where) {
  const std::size_t at = line.rfind(",\"times_ms\":");
  assert(at != std::string::npos);
  line.insert(at,
              fmt::format(",\"{}\":{{{},\"mm_per_step\":{},\"zero_at\":{},\"none\":0}}",
                          name,
                          where,
                          kDepthStep_mm,
                          kDepthZero));
}

Result<ResultFiles> ResultFiles::create(const ReconstructOptions& options) {
  ResultFiles files(options);
  if (!options.image) return files;
  const auto drawing = load_figures();
  if (!drawing) return drawing.error();
  auto faces = (*drawing)->faces({1280, 720}, options.scene, options.viewpoint);
  if (!faces) return faces.error();
  files.faces_ = std::move(*faces);
  return files;
}

Path ResultFiles::file(const FrameResult& result, const std::string& ending) const {
  return options_->folder / (result.frame->name + ending);
}

Result<FrameLine> ResultFiles::write(BatchFrame& frame, const Pipeline& pipeline) const {
  if (!frame.result) {
    const Error problem = frame.problem.value_or(Error());
    return failed(
        frame.frame ? frame.frame->name : frame_name(problem, frame.index), frame.index, problem);
  }
  const FrameResult& result = *frame.result;
  FrameLine line;
  line.frame = result.frame->name;
  line.line = result_line(result, frame.index, reference_method(*options_));
  line.is_measured = result.depth.has_value();
  line.total_ms = result.times_ms.total;
  if (frame.contacts) line.contacts = contacts_of(*frame.contacts);
  if (!result.depth) {
    for (const Message& problem : result.problems)
      line.warnings.push_back(fmt::format("{}: {}", result.frame->name, problem));
    return line;
  }
  if (options_->depth16) add_depth_steps(line.line, "depth16", "\"in\":\"png\"");
  if (const Status status = write_maps(result, pipeline); !status) return status.error();
  if (const Status status = write_sd(result, pipeline.finger()); !status) return status.error();
  if (const Status status = write_surfaces(result, pipeline.finger()); !status)
    return status.error();
  return line;
}

Status ResultFiles::write_maps(const FrameResult& result, const Pipeline& pipeline) const {
  const cv::Mat& depth = result.depth->depth_mm;
  if (options_->depth)
    if (Status status = write_file_unsynced(file(result, ".depth.tiff"), depth_tiff(depth));
        !status)
      return status;
  if (options_->depth16)
    if (Status status = write_file_unsynced(file(result, ".depth16.png"), depth_png(depth));
        !status)
      return status;
  if (options_->flags)
    if (Status status =
            write_file_unsynced(file(result, ".flags.png"), grey_png(result.depth->flags));
        !status)
      return status;
  if (!faces_) return {};
  const auto image = faces_->image(result, pipeline);
  if (!image) return Error{image.error().what, file(result, ".3d.png"), image.error().advice};
  return write_image(file(result, ".3d.png"), *image);
}

Status ResultFiles::write_sd(const FrameResult& result, const Finger& finger) const {
  if (!options_->depth_sd && !options_->sd_causes && !options_->limits) return {};
  const auto mapping = Mapping::create(*finger.mapping);
  if (!mapping) return mapping.error();
  const auto write = [&](const std::string& ending, const cv::Mat& sd_mm) {
    return write_file_unsynced(file(result, ending), depth_tiff(sd_mm));
  };
  if (options_->depth_sd || options_->limits) {
    const DepthSdAndLimits made =
        depth_sd_and_limits(*result.depth, *result.reference, *result.shape, *mapping);
    if (options_->depth_sd)
      if (Status status = write(".depth_sd.tiff", made.sd_mm); !status) return status;
    if (options_->limits)
      if (Status status = write_file_unsynced(file(result, ".limits.png"), grey_png(made.limits));
          !status)
        return status;
  }
  if (!options_->sd_causes) return {};
  for (const auto& [cause, sd_mm] :
       depth_sd_by_cause(*result.depth, *result.reference, *result.shape, *mapping))
    if (Status status = write(std::string(".sd_") + cause + ".tiff", sd_mm); !status) return status;
  return {};
}

Status ResultFiles::write_surfaces(const FrameResult& result, const Finger& finger) const {
  if (options_->points)
    if (Status status =
            write_image(file(result, ".points.tiff"), contact_face_points_mm(result, finger.face));
        !status)
      return status;
  if (options_->surfaces.empty()) return {};
  const FaceVertices vertices = contact_face_vertices(result, finger.face);
  for (const std::string& kind : options_->surfaces)
    if (Status status =
            write_surface(file(result, "." + kind), vertices.points_mm, vertices.depth_mm);
        !status)
      return status;
  return {};
}

}  // namespace alltact
