#include "widgets/shell/studio_style.h"

#include <QAbstractSpinBox>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

namespace alltact {
namespace {

bool needs_outlines(const QStyleOption& option) {
  return option.palette.color(QPalette::Window) == Qt::black;
}

void outline(QPainter& painter, const QStyleOption& option) {
  const bool is_on =
      option.state.testFlag(QStyle::State_On) || option.state.testFlag(QStyle::State_HasFocus);
  const bool is_enabled = option.state.testFlag(QStyle::State_Enabled);
  const QColor colour =
      is_on ? option.palette.color(QPalette::Highlight)
            : option.palette.color(is_enabled ? QPalette::Active : QPalette::Disabled,
                                   QPalette::WindowText);
  const int width = is_on ? 2 : 1;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  QPen pen(colour, width);
  pen.setJoinStyle(Qt::MiterJoin);
  painter.setPen(pen);
  painter.drawRect(option.rect.adjusted(width / 2, width / 2, -(width + 1) / 2, -(width + 1) / 2));
  painter.restore();
}

}  // namespace

StudioStyle::StudioStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void StudioStyle::drawPrimitive(PrimitiveElement element,
                                const QStyleOption* option,
                                QPainter* painter,
                                const QWidget* widget) const {
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  if (!needs_outlines(*option)) return;
  // Part of a box that has an outline itself.
  const QWidget* parent = widget == nullptr ? nullptr : widget->parentWidget();
  if (element == PE_PanelLineEdit && qobject_cast<const QAbstractSpinBox*>(parent) != nullptr)
    return;
  switch (element) {
    case PE_IndicatorCheckBox:
    case PE_PanelButtonCommand:
    case PE_PanelButtonTool:
    case PE_PanelLineEdit:
    case PE_FrameGroupBox:
      return outline(*painter, *option);
    default:
      return;
  }
}

void StudioStyle::drawComplexControl(ComplexControl control,
                                     const QStyleOptionComplex* option,
                                     QPainter* painter,
                                     const QWidget* widget) const {
  QProxyStyle::drawComplexControl(control, option, painter, widget);
  if (needs_outlines(*option) && (control == CC_SpinBox || control == CC_ComboBox))
    outline(*painter, *option);
}

}  // namespace alltact
