#include "core/sensing/reference/flat_reference.h"

#include "core/finger/reduced_finger.h"
#include "core/io/image_file.h"

namespace alltact {

Result<cv::Mat> flat_reference(const FingerSnapshot& snapshot) {
  const Finger& finger = snapshot.finger;
  if (!finger.reference || finger.reference->image.empty())
    return Error{en::say("the sensor has no untouched picture"),
                 (snapshot.folder / Finger::kFileName).string(),
                 en::say("give one with the calibration")};
  const auto file = snapshot.folder / finger.reference->image;
  const auto raw = read_grey_image(file);
  if (!raw) return raw.error();
  return image_for(snapshot,
                   *raw,
                   en::say("the untouched picture"),
                   file.string(),
                   en::say("give the untouched picture anew"));
}

}  // namespace alltact
