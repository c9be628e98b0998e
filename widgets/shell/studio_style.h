// Qt's Fusion style with visible outlines on dark backgrounds, a visible focus, a primary button,
// and uniform spacing. A group is a title and a line instead of nested boxes.
#pragma once

#include <QProxyStyle>

namespace alltact {

class StudioStyle : public QProxyStyle {
 public:
  StudioStyle();

  void drawPrimitive(PrimitiveElement element,
                     const QStyleOption* option,
                     QPainter* painter,
                     const QWidget* widget = nullptr) const override;
  void drawControl(ControlElement element,
                   const QStyleOption* option,
                   QPainter* painter,
                   const QWidget* widget = nullptr) const override;
  void drawComplexControl(ComplexControl control,
                          const QStyleOptionComplex* option,
                          QPainter* painter,
                          const QWidget* widget = nullptr) const override;
  [[nodiscard]] QRect subControlRect(ComplexControl control,
                                     const QStyleOptionComplex* option,
                                     SubControl part,
                                     const QWidget* widget = nullptr) const override;
  [[nodiscard]] int pixelMetric(PixelMetric metric,
                                const QStyleOption* option = nullptr,
                                const QWidget* widget = nullptr) const override;
};

}  // namespace alltact
