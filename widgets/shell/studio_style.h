// Qt's Fusion, with outlines that can be seen on dark ground: Fusion draws them darker than the
// window.
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
  void drawComplexControl(ComplexControl control,
                          const QStyleOptionComplex* option,
                          QPainter* painter,
                          const QWidget* widget = nullptr) const override;
};

}  // namespace alltact
