#include "widgets/controls/control_names.h"

#include "widgets/controls/control_panel.h"

#include <linux/videodev2.h>

namespace alltact {

QString control_name(const CameraControl& control) {
  switch (control.id) {
    case V4L2_CID_EXPOSURE_AUTO:
      return ControlPanel::tr("Automatic exposure");
    case V4L2_CID_EXPOSURE_ABSOLUTE:
      return ControlPanel::tr("Exposure time");
    case V4L2_CID_AUTOGAIN:
      return ControlPanel::tr("Automatic gain");
    case V4L2_CID_GAIN:
      return ControlPanel::tr("Gain");
    case V4L2_CID_AUTO_WHITE_BALANCE:
      return ControlPanel::tr("Automatic white balance");
    case V4L2_CID_WHITE_BALANCE_TEMPERATURE:
      return ControlPanel::tr("White balance");
    case V4L2_CID_FOCUS_AUTO:
      return ControlPanel::tr("Automatic focus");
    case V4L2_CID_FOCUS_ABSOLUTE:
      return ControlPanel::tr("Focus");
    case V4L2_CID_BRIGHTNESS:
      return ControlPanel::tr("Brightness");
    default:
      return QString::fromStdString(control.name);
  }
}

}  // namespace alltact
