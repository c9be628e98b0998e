#include "widgets/scene3d/colour_bar.h"

#include "widgets/scene3d/scene_lines.h"

#include <algorithm>

#include <vtkCoordinate.h>
#include <vtkLookupTable.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextProperty.h>

namespace alltact {
namespace {

constexpr double kWidth = 78, kHeight = 340;  // in pixels at scale 1

}  // namespace

ColourBar::ColourBar(vtkRenderer* renderer) {
  bar_->SetLookupTable(colours_);
  bar_->SetTitle("mm");
  bar_->SetLabelFormat("%.2f");
  bar_->UnconstrainedFontSizeOn();
  bar_->SetBarRatio(0.28);
  bar_->SetTextPad(4);
  bar_->SetVerticalTitleSeparation(10);
  bar_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  for (vtkTextProperty* text : {bar_->GetLabelTextProperty(), bar_->GetTitleTextProperty()}) {
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
  }
  bar_->VisibilityOff();
  renderer->AddActor2D(bar_);
}

ColourBar::~ColourBar() = default;

void ColourBar::show(bool is_shown) {
  bar_->SetVisibility(is_shown);
}

void ColourBar::set_scale(const ColourScale& scale) {
  constexpr int kSteps = 256;
  colours_->SetNumberOfTableValues(kSteps);
  colours_->SetTableRange(scale.low_mm, scale.top_mm);
  // As many as make zero one of them.
  bar_->SetNumberOfLabels(scale.steps < 4 ? 2 * scale.steps + 1 : scale.steps + 1);
  for (int i = 0; i < kSteps; ++i) {
    const MapColour c = scale.colour(static_cast<double>(i) / (kSteps - 1));
    colours_->SetTableValue(i, c.red / 255.0, c.green / 255.0, c.blue / 255.0, 1);
  }
  colours_->Build();
}

void ColourBar::apply_style(const cv::Vec3b& text) {
  for (vtkTextProperty* property : {bar_->GetLabelTextProperty(), bar_->GetTitleTextProperty()}) {
    property->SetColor(text[0] / 255.0, text[1] / 255.0, text[2] / 255.0);
    property->SetFontSize(kLetterPoints);
  }
}

void ColourBar::set_position(const int* window_px, double pixels_per_unit) {
  if (window_px[0] <= 0 || window_px[1] <= 0) return;
  const double left = free_fraction(window_px, pixels_per_unit);
  const double height = std::min(0.7, kHeight * pixels_per_unit / window_px[1]);
  bar_->SetPosition(left, 0.5 * (1 - height));
  bar_->SetWidth(1 - left);
  bar_->SetHeight(height);
}

double ColourBar::free_fraction(const int* window_px, double pixels_per_unit) {
  if (window_px[0] <= 0) return 0.8;
  return 1 - std::min(0.4, kWidth * pixels_per_unit / window_px[0]);
}

}  // namespace alltact
