#include "widgets/theme.h"

#include <QAbstractSpinBox>
#include <QFile>
#include <QGuiApplication>
#include <QPainter>
#include <QPixmapCache>
#include <QStyleFactory>
#include <QStyleOption>
#include <QSvgRenderer>
#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {
namespace {

struct Colours {
  QColor window, base, alternate, text, disabled, button, highlight, highlighted_text, link;
};

QPalette made_of(const Colours& colours) {
  QPalette palette;
  palette.setColor(QPalette::Window, colours.window);
  palette.setColor(QPalette::WindowText, colours.text);
  palette.setColor(QPalette::Base, colours.base);
  palette.setColor(QPalette::AlternateBase, colours.alternate);
  palette.setColor(QPalette::ToolTipBase, colours.base);
  palette.setColor(QPalette::ToolTipText, colours.text);
  palette.setColor(QPalette::PlaceholderText, colours.disabled);
  palette.setColor(QPalette::Text, colours.text);
  palette.setColor(QPalette::Button, colours.button);
  palette.setColor(QPalette::ButtonText, colours.text);
  palette.setColor(QPalette::BrightText, colours.highlighted_text);
  palette.setColor(QPalette::Light, colours.button.lighter(130));
  palette.setColor(QPalette::Midlight, colours.button.lighter(115));
  palette.setColor(QPalette::Mid, colours.button.darker(130));
  palette.setColor(QPalette::Dark, colours.button.darker(160));
  palette.setColor(QPalette::Shadow, colours.button.darker(300));
  palette.setColor(QPalette::Highlight, colours.highlight);
  palette.setColor(QPalette::HighlightedText, colours.highlighted_text);
  palette.setColor(QPalette::Link, colours.link);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, colours.disabled);
  return palette;
}

const Colours kLight{"#f4f5f6", "#ffffff", "#eef0f2", "#16191d", "#72787f",
                     "#e6e8eb", "#0b5fa5", "#ffffff", "#0b5fa5"};
const Colours kDark{"#202327", "#17191c", "#1d2024", "#e8eaed", "#8b929a",
                    "#2c3036", "#4294de", "#0b0d0f", "#7fbdf2"};
const Colours kContrast{"#000000", "#000000", "#000000", "#ffffff", "#b0b0b0",
                        "#000000", "#ffe600", "#000000", "#7fd4ff"};

}  // namespace

QFont text_font(const QFont& body, TextSize size) {
  QFont font = body;
  const double larger = size == TextSize::kSmall     ? 0.9
                        : size == TextSize::kBody    ? 1.0
                        : size == TextSize::kHeading ? 1.25
                                                     : 1.6;
  font.setPointSizeF(larger * body.pointSizeF());
  font.setBold(size == TextSize::kHeading || size == TextSize::kTitle);
  return font;
}

QPalette theme_palette(Theme theme) {
  switch (theme) {
    case Theme::kLight:
      return made_of(kLight);
    case Theme::kDark:
      return made_of(kDark);
    case Theme::kHighContrast:
      return made_of(kContrast);
    case Theme::kSystem:
      break;
  }
  static const QPalette as_started = QGuiApplication::palette();
  return as_started;
}

bool is_dark(const QPalette& palette) {
  return palette.color(QPalette::WindowText).lightness() >
         palette.color(QPalette::Window).lightness();
}

QColor series_colour(int index, const QPalette& palette) {
  static const std::array<QColor, 6> on_light{"#0072b2", "#d55e00", "#007a5a",
                                              "#a8528a", "#8a6500", "#4c5158"};
  static const std::array<QColor, 6> on_dark{"#56b4e9", "#f0915a", "#2fc79b",
                                             "#e09ac6", "#e6b93c", "#b4bac2"};
  const auto& colours = is_dark(palette) ? on_dark : on_light;
  return colours[static_cast<std::size_t>(index) % colours.size()];
}

QColor role_colour(ColourRole role, const QPalette& palette) {
  switch (role) {
    case ColourRole::kMeasured:
      return series_colour(0, palette);
    case ColourRole::kExpected:
      return series_colour(1, palette);
    case ColourRole::kContact:
      return series_colour(3, palette);
    case ColourRole::kLeftOut:
      return series_colour(5, palette);
    case ColourRole::kChosen:
      break;
  }
  return palette.color(QPalette::Highlight);
}

QColor meaning_colour(Meaning meaning, const QPalette& palette) {
  const bool dark = is_dark(palette);
  switch (meaning) {
    case Meaning::kGood:
      return dark ? "#2fc79b" : "#007a5a";
    case Meaning::kDoubtful:
      return dark ? "#e6b93c" : "#8a6500";
    case Meaning::kBad:
      break;
  }
  return dark ? "#ff8a7a" : "#b3261e";
}

QPixmap symbol(const QString& name, const QColor& colour, int size, double ratio) {
  // Cached: every image panel has the same buttons, and a new theme draws all of them again.
  const QString key =
      QStringLiteral("alltact %1 %2 %3 %4").arg(name, colour.name()).arg(size).arg(ratio);
  QPixmap pixmap;
  if (QPixmapCache::find(key, &pixmap)) return pixmap;
  QFile file(QStringLiteral(":/alltact/icons/%1.svg").arg(name));
  pixmap = QPixmap(QSize(size, size) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  if (!file.open(QIODevice::ReadOnly)) return pixmap;
  QSvgRenderer renderer(file.readAll().replace("currentColor", colour.name().toLatin1()));
  QPainter painter(&pixmap);
  renderer.render(&painter, QRectF(0, 0, size, size));
  painter.end();
  QPixmapCache::insert(key, pixmap);
  return pixmap;
}

QIcon icon(const QString& name, const QPalette& palette) {
  QIcon icon;
  for (const int size : {16, 24, 32})
    for (const double ratio : {1.0, 2.0}) {
      const auto add = [&](QPalette::ColorGroup group, QIcon::Mode mode) {
        icon.addPixmap(symbol(name, palette.color(group, QPalette::ButtonText), size, ratio), mode);
      };
      add(QPalette::Active, QIcon::Normal);
      add(QPalette::Disabled, QIcon::Disabled);
    }
  return icon;
}

QString meaning_symbol(Meaning meaning) {
  switch (meaning) {
    case Meaning::kGood:
      return QStringLiteral("good");
    case Meaning::kDoubtful:
      return QStringLiteral("doubtful");
    case Meaning::kBad:
      break;
  }
  return QStringLiteral("bad");
}

namespace {

constexpr int kUnderTitle = 3;  // as Fusion has it
constexpr int kFocusWidth = 2, kChosenWidth = 3;
constexpr double kCorner = 3;

bool is_black(const QStyleOption& option) {
  return option.palette.color(QPalette::Window) == Qt::black;
}

constexpr const char* kPrimary = "alltact_primary";

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
  draw_outline(painter, option.rect.adjusted(0, top, 0, 0), colour,
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
    draw_outline(painter, option.rect.adjusted(2, 2, -2, -2),
                 option.palette.color(QPalette::HighlightedText), kFocusWidth);
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

void StudioStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const {
  const bool is_enabled = option->state.testFlag(State_Enabled);
  if (element == PE_PanelButtonCommand && widget && is_primary(*widget) && is_enabled)
    return draw_primary(*painter, *option);
  if (element == PE_FrameGroupBox && !is_black(*option)) {
    const int y = option->rect.top() + title_height(*this, *option, widget);
    painter->fillRect(QRect(option->rect.left(), y, option->rect.width(), 1),
                      mixed(option->palette.color(QPalette::Window),
                            option->palette.color(QPalette::WindowText), 0.22));
    return;
  }
  if (element == PE_FrameFocusRect)
    return draw_outline(*painter, option->rect, option->palette.color(QPalette::Highlight),
                        kFocusWidth);
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

void StudioStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const {
  const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
  const bool is_filled = widget && is_primary(*widget) && option->state.testFlag(State_Enabled);
  if (element != CE_PushButtonLabel || button == nullptr || !is_filled)
    return QProxyStyle::drawControl(element, option, painter, widget);
  QStyleOptionButton filled = *button;
  filled.palette.setColor(QPalette::ButtonText, option->palette.color(QPalette::HighlightedText));
  QProxyStyle::drawControl(element, &filled, painter, widget);
}

void StudioStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                     QPainter* painter, const QWidget* widget) const {
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

QRect StudioStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                                  SubControl part, const QWidget* widget) const {
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

QSize StudioStyle::sizeFromContents(ContentsType type, const QStyleOption* option,
                                    const QSize& contents, const QWidget* widget) const {
  const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
  if (type != CT_PushButton || button == nullptr || widget == nullptr ||
      !widget->property(kPrimary).isValid())
    return QProxyStyle::sizeFromContents(type, option, contents, widget);
  QFont bold = widget->font();
  bold.setBold(true);
  const auto width = [button](const QFontMetrics& metrics) {
    return metrics.size(Qt::TextShowMnemonic, button->text).width();
  };
  const int wider = width(QFontMetrics(bold)) - width(button->fontMetrics);
  return QProxyStyle::sizeFromContents(type, option, contents + QSize(wider, 0), widget);
}

/// Qt's own symbols of the buttons of dialogs are black in every theme.
int StudioStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* more) const {
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
  return QProxyStyle::styleHint(hint, option, widget, more);
}

int StudioStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
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

void set_primary(QPushButton& button, bool is_primary) {
  if (button.property(kPrimary) == QVariant(is_primary)) return;
  button.setProperty(kPrimary, is_primary);
  QEvent resized(QEvent::StyleChange);  // its hint of a size from before is stored
  QCoreApplication::sendEvent(&button, &resized);
  button.updateGeometry();
  QFont font = button.font();
  font.setBold(is_primary);
  button.setFont(font);
  button.update();
}

bool is_primary(const QWidget& widget) { return widget.property(kPrimary).toBool(); }

}  // namespace alltact
