#include "widgets/shell/studio_style.h"

#include "widgets/shell/primary_button.h"
#include "widgets/theme.h"

#include <QAbstractSpinBox>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>
#include <algorithm>

namespace alltact {
namespace {

constexpr int kUnderTitle = 3;  // as Fusion has it
constexpr int kFocusWidth = 2, kChosenWidth = 3;
constexpr double kCorner = 3;

bool is_black(const QStyleOption& option) {
  return option.palette.color(QPalette::Window) == Qt::black;
}

bool has_focus(const QStyleOption& option) {
  return option.state.testFlag(QStyle::State_HasFocus) &&
         option.state.testFlag(QStyle::State_Enabled);
}

void draw_outline(QPainter& painter, const QRect& rect, const QColor& colour, int width) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  QPen pen(colour, width);
  pen.setJoinStyle(Qt::MiterJoin);
  painter.setPen(pen);
  painter.drawRect(rect.adjusted(width / 2, width / 2, -(width + 1) / 2, -(width + 1) / 2));
  painter.restore();
}

void outline(QPainter& painter, const QStyleOption& option, int top = 0) {
  const bool is_on = option.state.testFlag(QStyle::State_On) || has_focus(option);
  const bool is_enabled = option.state.testFlag(QStyle::State_Enabled);
  const QColor colour =
      is_on && is_black(option)
          ? option.palette.color(QPalette::Highlight)
          : option.palette.color(
                is_enabled && is_black(option) ? QPalette::Active : QPalette::Disabled,
                QPalette::WindowText);
  draw_outline(painter,
               option.rect.adjusted(0, top, 0, 0),
               colour,
               is_on && is_black(option) ? kFocusWidth : 1);
}

QColor mixed(const QColor& a, const QColor& b, double part_of_b) {
  const auto mix = [&](int x, int y) { return static_cast<int>(x + part_of_b * (y - x) + 0.5); };
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

void draw_primary(QPainter& painter, const QStyleOption& option) {
  const QColor colour = option.palette.color(QPalette::Highlight);
  const bool is_down = option.state.testFlag(QStyle::State_Sunken);
  const bool is_hovered = option.state.testFlag(QStyle::State_MouseOver);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(is_down ? colour.darker(120) : is_hovered ? colour.lighter(108) : colour);
  painter.drawRoundedRect(QRectF(option.rect), kCorner, kCorner);
  painter.restore();
  if (has_focus(option))
    draw_outline(painter,
                 option.rect.adjusted(2, 2, -2, -2),
                 option.palette.color(QPalette::HighlightedText),
                 kFocusWidth);
}

/// The selected one of several: tinted, and a bar along its lower edge.
void draw_chosen(QPainter& painter, const QStyleOption& option) {
  const QColor colour = option.palette.color(QPalette::Highlight);
  const QRect inside = option.rect.adjusted(1, 1, -1, -1);
  if (!is_black(option))
    painter.fillRect(inside, mixed(option.palette.color(QPalette::Button), colour, 0.18));
  painter.fillRect(
      QRect(inside.left(), inside.bottom() - kChosenWidth + 1, inside.width(), kChosenWidth),
      colour);
}

int title_height(const QProxyStyle& style, const QStyleOption& option, const QWidget* widget) {
  return std::max(style.pixelMetric(QStyle::PM_IndicatorHeight, &option, widget),
                  option.fontMetrics.height()) +
         kUnderTitle;
}

}  // namespace

StudioStyle::StudioStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void StudioStyle::drawPrimitive(PrimitiveElement element,
                                const QStyleOption* option,
                                QPainter* painter,
                                const QWidget* widget) const {
  const bool is_enabled = option->state.testFlag(State_Enabled);
  if (element == PE_PanelButtonCommand && widget && is_primary(*widget) && is_enabled)
    return draw_primary(*painter, *option);
  if (element == PE_FrameGroupBox && !is_black(*option)) {
    const int y = option->rect.top() + title_height(*this, *option, widget);
    painter->fillRect(QRect(option->rect.left(), y, option->rect.width(), 1),
                      mixed(option->palette.color(QPalette::Window),
                            option->palette.color(QPalette::WindowText),
                            0.22));
    return;
  }
  if (element == PE_FrameFocusRect)
    return draw_outline(
        *painter, option->rect, option->palette.color(QPalette::Highlight), kFocusWidth);
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  // Fusion draws no PE_FrameFocusRect for buttons; its own sign is a shade of their edge.
  if (element == PE_PanelButtonCommand && has_focus(*option) && !is_black(*option))
    draw_outline(*painter, option->rect, option->palette.color(QPalette::Highlight), kFocusWidth);
  if (element == PE_PanelButtonTool && option->state.testFlag(State_On))
    draw_chosen(*painter, *option);
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
      return outline(*painter, *option, title_height(*this, *option, widget));
    default:
      return;
  }
}

void StudioStyle::drawControl(ControlElement element,
                              const QStyleOption* option,
                              QPainter* painter,
                              const QWidget* widget) const {
  const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
  const bool is_filled = widget && is_primary(*widget) && option->state.testFlag(State_Enabled);
  if (element != CE_PushButtonLabel || button == nullptr || !is_filled)
    return QProxyStyle::drawControl(element, option, painter, widget);
  QStyleOptionButton filled = *button;
  filled.palette.setColor(QPalette::ButtonText, option->palette.color(QPalette::HighlightedText));
  QProxyStyle::drawControl(element, &filled, painter, widget);
}

void StudioStyle::drawComplexControl(ComplexControl control,
                                     const QStyleOptionComplex* option,
                                     QPainter* painter,
                                     const QWidget* widget) const {
  if (control == CC_GroupBox) {
    painter->save();
    QFont title = painter->font();
    title.setBold(true);
    painter->setFont(title);
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    return painter->restore();
  }
  QProxyStyle::drawComplexControl(control, option, painter, widget);
  if (is_dark(option->palette) && (control == CC_SpinBox || control == CC_ComboBox))
    outline(*painter, *option);
}

QRect StudioStyle::subControlRect(ComplexControl control,
                                  const QStyleOptionComplex* option,
                                  SubControl part,
                                  const QWidget* widget) const {
  QRect rect = QProxyStyle::subControlRect(control, option, part, widget);
  const auto* group = qstyleoption_cast<const QStyleOptionGroupBox*>(option);
  if (control == CC_GroupBox && part == SC_GroupBoxLabel && group != nullptr) {
    // Wider in bold.
    QFont title = widget == nullptr ? QFont() : widget->font();
    title.setBold(true);
    const int wide =
        QFontMetrics(title).boundingRect(QRect(), Qt::TextShowMnemonic, group->text).width();
    rect.setWidth(std::min(std::max(rect.width(), wide + 4), option->rect.right() - rect.left()));
  }
  return rect;
}

int StudioStyle::pixelMetric(PixelMetric metric,
                             const QStyleOption* option,
                             const QWidget* widget) const {
  switch (metric) {
    case PM_LayoutHorizontalSpacing:
    case PM_LayoutVerticalSpacing:
    case PM_LayoutLeftMargin:
    case PM_LayoutTopMargin:
    case PM_LayoutRightMargin:
    case PM_LayoutBottomMargin:
      return kSpacing;
    default:
      return QProxyStyle::pixelMetric(metric, option, widget);
  }
}

}  // namespace alltact
