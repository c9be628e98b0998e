// The library that draws.
#include "app/figures/figures.h"
#include "widgets/inspect/inspection_results.h"
#include "widgets/report/calibration_pages.h"
#include "widgets/report/experiment_pages.h"
#include "widgets/report/offscreen.h"
#include "widgets/scene3d/face_surface.h"
#include "widgets/scene3d/vtk_view.h"

#include <new>

namespace alltact {
namespace {

class ScenesOfFaces : public FaceRenderer {
 public:
  explicit ScenesOfFaces(OffscreenScene renderer) : renderer_(std::move(renderer)) {}

  Result<cv::Mat> image(const FrameResult& result, const Pipeline& pipeline) override {
    constexpr int kVertices = 100000;
    const cv::Size grid = grid_for(result, kVertices);
    const auto surface = face_surface(result, pipeline.finger().face, grid.width, grid.height);
    if (!surface) return Error{en::say("there is no face to draw"), "", ""};
    renderer_.scene().show(*surface, pipeline.camera());
    return renderer_.image();
  }

 private:
  OffscreenScene renderer_;
};

/// Runs `draw` without a screen. Error: its own, or there is not enough memory.
template <class Draw>
auto offscreen(const Draw& draw) -> decltype(draw()) {
  try {
    const OffscreenDrawing drawing;
    if (const Status ready = drawing.ready(); !ready) return ready.error();
    return draw();
  } catch (const std::bad_alloc&) {
    return Error{en::say("there is not enough memory to draw"), "",
                 en::say("close other programs")};
  }
}

class DrawnFigures : public Figures {
 public:
  Result<std::vector<ReportFile>> calibration_pages(const FingerCalibration& done,
                                                    const std::filesystem::path& folder,
                                                    const Job& job) const override {
    return offscreen([&] { return make_calibration_pages(done, folder, job); });
  }

  Result<std::vector<ReportFile>> experiment_pages(const ExperimentReport& report,
                                                   const std::string& name) const override {
    return offscreen([&] { return make_experiment_pages(report, name); });
  }

  Result<std::string> inspection_report(const InspectionLog& log, const InspectionOrder& order,
                                        const std::string& date) const override {
    return offscreen([&] { return inspection_report_pdf(log, order, date); });
  }

  Result<std::vector<ReportFile>> figure_files(const std::string& svg, const std::string& name,
                                               const std::string& date) const override {
    auto files = offscreen([&] { return svg_figure_files(svg, name, date); });
    if (!files) return files.error();
    return std::vector<ReportFile>{{name + ".png", std::move(files->png)},
                                   {name + ".pdf", std::move(files->pdf)}};
  }

  Result<std::unique_ptr<FaceRenderer>> faces(cv::Size size_px, const SceneOptions& options,
                                              Viewpoint viewpoint) const override {
    auto renderer = OffscreenScene::create(size_px);
    if (!renderer) return renderer.error();
    renderer->scene().set_options(options);
    renderer->scene().set_viewpoint(viewpoint);
    return std::unique_ptr<FaceRenderer>(std::make_unique<ScenesOfFaces>(std::move(*renderer)));
  }
};

}  // namespace
}  // namespace alltact

extern "C" __attribute__((visibility("default"))) const alltact::Figures* alltact_figures() {
  static const alltact::DrawnFigures figures;
  return &figures;
}
