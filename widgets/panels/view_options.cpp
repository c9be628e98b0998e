#include "widgets/panels/view_options.h"

#include "widgets/image/overlays.h"
#include "widgets/joined_words.h"
#include "widgets/number_text.h"

#include <QCoreApplication>
#include <cmath>

namespace alltact {
namespace {

struct FrameWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::FrameWords)
 public:
  static QString no_depth(std::uint8_t flag) {
    switch (flag) {
      case kTooDark:
        return tr("no depth: too dark");
      case kSaturated:
        return tr("no depth: too bright");
      default:
        return tr("no depth: off the face");
    }
  }

  static QString readout(const LiveView& view, QPoint pixel) {
    const FrameResult& result = view.result;
    const int grey = result.grey.at<std::uint8_t>(pixel.y(), pixel.x());
    const QString text = tr("u %1 px, v %2 px, grey %3").arg(pixel.x()).arg(pixel.y()).arg(grey);
    if (!result.depth) return text;
    const float depth = result.depth->depth_mm.at<float>(pixel.y(), pixel.x());
    const std::uint8_t flag = result.depth->flags.at<std::uint8_t>(pixel.y(), pixel.x());
    return joined({text,
                   std::isfinite(depth) ? tr("depth %1 mm")
                                              .arg(is_at_limit(flag) ? limit_and_sd(depth, {}, 2)
                                                                     : plain_number(depth, 2))
                                        : no_depth(flag)});
  }

  static QString colour_bar() { return tr("Depth, mm"); }
};

}  // namespace

std::vector<Overlay> overlays_for(const LiveView& view, const ViewOptions& options) {
  const FrameResult& result = view.result;
  std::vector<Overlay> overlays;
  if (options.depth && view.depth_layer)
    overlays.push_back(layer_overlay(view.depth_layer->pixels, view.depth_layer->at));
  if (options.faults && !view.faults_layer.empty())
    overlays.push_back(layer_overlay(view.faults_layer));
  if (options.edges && result.edges) overlays.push_back(edges_overlay(*result.edges));
  if (options.markers && result.markers) overlays.push_back(markers_overlay(*result.markers));
  if (options.markers && !view.result.dots.empty())
    overlays.push_back(dots_overlay(view.result.dots));
  if (options.direction && result.push && result.markers)
    overlays.push_back(force_overlay(*result.push, *result.markers));
  if (options.depth && view.depth_layer)
    overlays.push_back(
        colour_bar_overlay(depth_scale(view.depth_top_mm), FrameWords::colour_bar()));
  return overlays;
}

QString readout_text(const LiveView& view, QPoint pixel) {
  return FrameWords::readout(view, pixel);
}

}  // namespace alltact
