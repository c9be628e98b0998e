#include "core/sensing/reference/flat_reference.h"

#include "core/io/picture.h"

namespace alltact {

Result<cv::Mat> flat_reference(const std::filesystem::path& finger_folder, const Finger& finger) {
  if (!finger.reference || finger.reference->image.empty())
    return Error{en::say("the sensor has no untouched picture"),
                 (finger_folder / Finger::kFileName).string(),
                 en::say("give one with the calibration")};
  const auto file = finger_folder / finger.reference->image;
  const auto raw = read_grey_picture(file);
  if (!raw) return raw.error();
  return oriented_for(finger.camera,
                      *raw,
                      en::say("the untouched picture"),
                      file.string(),
                      en::say("give the untouched picture anew"));
}

}  // namespace alltact
