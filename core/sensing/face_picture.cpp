#include "core/sensing/face_picture.h"

namespace alltact {

FacePicture keep_face(const cv::Mat& grey, const FaceShape& shape, double margin_px) {
  FacePicture picture{face_runs(shape, margin_px, grey.size()), {}};
  picture.grey.reserve(picture.face.pixels());
  for (const FaceRun& run : picture.face.runs) {
    const std::uint8_t* row = grey.ptr<std::uint8_t>(run.row);
    picture.grey.insert(picture.grey.end(), row + run.first, row + run.end);
  }
  return picture;
}

}  // namespace alltact
