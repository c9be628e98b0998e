#include "calibration/twin/twin_figures.h"

#include <algorithm>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kMaxRelativeSd = 0.5;  // sd over value

std::string with_sd(const TwinFigure& figure) {
  return figure.sd ? fmt::format("{:.4g} +- {:.2g}", figure.value, *figure.sd)
                   : fmt::format("{:.4g}", figure.value);
}

class FigureWriter {
 public:
  explicit FigureWriter(Twin& twin) : twin_(twin) {}

  /// `positive`: half its own size is a large uncertainty of the number.
  void add(const std::string& key,
           const Message& what,
           double value,
           const std::optional<double>& sd,
           bool positive = true) {
    TwinFigure figure{key, what, value, sd, ""};
    if (!sd)
      figure.remark =
          en::say("not observable: at the end of its range, or another number does the same");
    else if (positive && *sd > kMaxRelativeSd * value)
      figure.remark = en::say("hardly observable in these pictures");
    twin_.figures.push_back(std::move(figure));
  }
  void comment(const std::string& effect, const std::string& what, std::size_t figures) {
    std::string text = what;
    for (std::size_t i = twin_.figures.size() - figures; i < twin_.figures.size(); ++i)
      text += fmt::format("{} {} {}",
                          i + figures == twin_.figures.size() ? ":" : ",",
                          twin_.figures[i].key,
                          with_sd(twin_.figures[i]));
    twin_.scene.comments[effect] = text;
  }

 private:
  Twin& twin_;
};

void write_layer(const TwinContact& contact, FigureWriter& writer, Twin& twin) {
  const TwinScene& scene = twin.scene;
  const ContactSpread& sd = contact.spread;
  writer.add("scatter_per_mm",
             en::say("scattering of the layer, per mm"),
             scene.layer.scatter_per_mm,
             sd.scatter_per_mm);
  std::size_t count = 1;
  if (scene.layer.coat > 0) {
    writer.add(
        "coat", en::say("what the coat below the layer reflects"), scene.layer.coat, sd.coat);
    ++count;
  } else {
    twin.remarks.push_back(
        en::say("the coat below the layer is taken to be black: the presses do not say otherwise"));
  }
  writer.comment("layer", "told by how the presses darken", count);
  twin.remarks.push_back(en::say(
      "absorption in the layer is not observable: scattering and coat bend the same curve"));
  writer.add("rolloff length_mm", en::say("roll-off length, mm"), scene.rolloff_mm, sd.rolloff_mm);
  writer.comment(
      "rolloff",
      fmt::format("told by the rims of the contacts, where kind {} leaves {:.2f} times as much",
                  contact.other_rolloff == TwinRolloff::kHertz ? "hertz" : "smooth",
                  contact.other_factor),
      1);
}

void write_halo(const TwinContact& contact, FigureWriter& writer, Twin& twin) {
  const TwinScene& scene = twin.scene;
  const ContactSpread& sd = contact.spread;
  if (scene.halo == TwinHalo::kNone) {
    twin.remarks.push_back(en::say("no swelling around the contacts is to be seen"));
  } else {
    std::size_t count = 2;
    writer.add("bulge share",
               en::say("height of the swelling, share of the layer"),
               scene.halo_share,
               sd.halo_share);
    writer.add("bulge width_mm",
               en::say("its distance from the rim, mm"),
               scene.halo_width_mm,
               sd.halo_width_mm);
    if (scene.halo == TwinHalo::kExponential) {
      writer.add("bulge steepness",
                 en::say("how steeply it falls off"),
                 scene.halo_steepness,
                 sd.halo_steepness);
      ++count;
    }
    writer.comment("bulge", "told by the bright halos", count);
  }
  if (scene.blur_px > 0) {
    writer.add("blur_px", en::say("blur, standard deviation in pixels"), scene.blur_px, sd.blur_px);
    writer.comment("defocus", "told by the steepest edges of the presses", 1);
  } else {
    twin.remarks.push_back(en::say("no blur is to be seen beside the roll-off"));
  }
}

void write_balls(const TwinContact& contact, FigureWriter& writer, const Twin& twin) {
  for (std::size_t i = 0; i < twin.scene.balls.size(); ++i) {
    const TwinBall& ball = twin.scene.balls[i];
    const ContactSpread::Ball& sd = contact.spread.balls[i];
    writer.add(
        ball.press + " depth_mm", en::say("{}: depth, mm", ball.press), ball.depth_mm, sd.depth_mm);
    writer.add(ball.press + " s_mm",
               en::say("{}: place along the face, mm", ball.press),
               ball.s_mm,
               sd.s_mm,
               false);
    writer.add(ball.press + " y_mm",
               en::say("{}: place across the face, mm", ball.press),
               ball.y_mm,
               sd.y_mm,
               false);
    std::size_t count = 3;
    if (ball.light != 1) {
      writer.add(ball.press + " light",
                 en::say("{}: light, share of that in its untouched picture", ball.press),
                 ball.light,
                 sd.light);
      ++count;
    }
    writer.comment("ball " + ball.press, ball.press, count);
  }
}

void write_lamps(const TwinLamps& lamps, FigureWriter& writer, Twin& twin) {
  int hardly = 0;
  double least = 0, most = 0;
  for (std::size_t i = 0; i < lamps.lamps.size(); ++i) {
    // The powers follow the layer, which the presses determine.
    const double power = twin.scene.lamps[i].power;
    std::optional<double> sd = lamps.spread[i].power;
    if (sd) *sd *= power / lamps.lamps[i].power;
    writer.add(fmt::format("lamp {} power", i + 1), en::say("lamp {}: power", i + 1), power, sd);
    const std::optional<Eigen::Vector3d>& at_sd = lamps.spread[i].at_mm;
    const double distance = twin.scene.face.kind == FaceKind::kFlat
                                ? twin.scene.face.plane_z_mm - lamps.lamps[i].at_mm.z()
                                : lamps.lamps[i].at_mm.norm();
    std::optional<double> distance_sd;
    if (at_sd) distance_sd = twin.scene.face.kind == FaceKind::kFlat ? at_sd->z() : at_sd->norm();
    writer.add(fmt::format("lamp {} distance_mm", i + 1),
               twin.scene.face.kind == FaceKind::kFlat
                   ? en::say("lamp {}: distance from the face, mm", i + 1)
                   : en::say("lamp {}: distance from the camera, mm", i + 1),
               distance,
               distance_sd);
    if (!distance_sd || *distance_sd > kMaxRelativeSd * distance) ++hardly;
    least = i == 0 ? distance : std::min(least, distance);
    most = std::max(most, distance);
  }
  twin.scene.comments["leds"] = fmt::format(
      "{} that light the untouched face as it is lit, to {:.2f} grey levels; they need not be the "
      "real ones",
      lamps.lamps.size() == 1 ? "one lamp" : fmt::format("{} lamps", lamps.lamps.size()),
      lamps.rms);
  if (lamps.room_level > 0) twin.scene.comments["ambient"] = "even light that no lamp gives";
  twin.remarks.push_back(
      en::say("the lamps make the light on the face, and need not be where the real ones are: {} "
              "of {} places "
              "are not observable",
              hardly,
              lamps.lamps.size()));
}

void write_noise(const TwinNoise& noise, FigureWriter& writer, Twin& twin) {
  if (noise.read_sd > 0) {
    writer.add("read sd", en::say("read noise, grey levels"), noise.read_sd, noise.read_sd_sd);
    writer.comment("read", noise.from.english(), 1);
  }
  if (noise.shot_gain > 0) {
    writer.add(
        "shot gain", en::say("shot noise, grey levels"), noise.shot_gain, noise.shot_gain_sd);
    writer.comment("shot", noise.from.english(), 1);
  } else {
    twin.remarks.push_back(en::say(
        "shot noise cannot be told from read noise: the face is too evenly lit, or there is none"));
  }
  if (noise.prnu > 0) {
    writer.add("fixed-pattern prnu", en::say("fixed pattern, share"), noise.prnu, noise.prnu_sd);
    writer.comment("fixed-pattern", noise.from.english(), 1);
  }
  twin.remarks.push_back(noise.from);
}

}  // namespace

void write_figures(const TwinLamps& lamps,
                   const TwinContact& contact,
                   const TwinNoise& noise,
                   Twin& twin) {
  FigureWriter writer(twin);
  write_layer(contact, writer, twin);
  write_halo(contact, writer, twin);
  write_balls(contact, writer, twin);
  write_lamps(lamps, writer, twin);
  write_noise(noise, writer, twin);
  if (twin.scene.face.kind == FaceKind::kFinRay)
    twin.remarks.push_back(
        en::say("the scene holds the face alone: no side faces, no dots, no twist"));
}

}  // namespace alltact
