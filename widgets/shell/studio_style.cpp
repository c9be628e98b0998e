#include "widgets/shell/studio_style.h"

#include "widgets/theme.h"

#include <QAbstractSpinBox>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>
#include <algorithm>

namespace alltact {
namespace {

constexpr int kUnderTitle = 3;  // as Fusion has it

bool is_black(const QStyleOption& option) {
  return option.palette.color(QPalette::Window) == Qt::black;
}

void outline(QPainter& painter, const QStyleOption& option, int top = 0) {
  const bool is_on =
      option.state.testFlag(QStyle::State_On) || option.state.testFlag(QStyle::State_HasFocus);
  const bool is_enabled = option.state.testFlag(QStyle::State_Enabled);
  const QColor colour =
      is_on && is_black(option)
          ? option.palette.color(QPalette::Highlight)
          : option.palette.color(
                is_enabled && is_black(option) ? QPalette::Active : QPalette::Disabled,
                QPalette::WindowText);
  const int width = is_on && is_black(option) ? 2 : 1;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  QPen pen(colour, width);
  pen.setJoinStyle(Qt::MiterJoin);
  painter.setPen(pen);
  painter.drawRect(
      option.rect.adjusted(width / 2, top + width / 2, -(width + 1) / 2, -(width + 1) / 2));
  painter.restore();
}

}  // namespace

StudioStyle::StudioStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void StudioStyle::drawPrimitive(PrimitiveElement element,
                                const QStyleOption* option,
                                QPainter* painter,
                                const QWidget* widget) const {
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  if (!is_dark(option->palette)) return;
  // Part of a box that has an outline itself.
  const QWidget* parent = widget == nullptr ? nullptr : widget->parentWidget();
  if (element == PE_PanelLineEdit && qobject_cast<const QAbstractSpinBox*>(parent) != nullptr)
    return;
  switch (element) {
    case PE_IndicatorCheckBox:
    case PE_PanelLineEdit:
      return outline(*painter, *option);
    case PE_PanelButtonCommand:
    case PE_PanelButtonTool:
      if (is_black(*option)) outline(*painter, *option);
      return;
    case PE_FrameGroupBox:
      // The title stands above the frame.
      if (is_black(*option))
        outline(*painter,
                *option,
                std::max(pixelMetric(PM_IndicatorHeight, option, widget),
                         option->fontMetrics.height()) +
                    kUnderTitle);
      return;
    default:
      return;
  }
}

void StudioStyle::drawComplexControl(ComplexControl control,
                                     const QStyleOptionComplex* option,
                                     QPainter* painter,
                                     const QWidget* widget) const {
  QProxyStyle::drawComplexControl(control, option, painter, widget);
  if (is_dark(option->palette) && (control == CC_SpinBox || control == CC_ComboBox))
    outline(*painter, *option);
}

}  // namespace alltact
