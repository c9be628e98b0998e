// Shows each widget alone, with made-up content: alltact_gallery NAME, or without a name which
// there are.
#include "tests/gallery/gallery.h"
#include "widgets/theme.h"

#include <QApplication>
#include <iostream>

int main(int argc, char** argv) {
  using namespace alltact;
  const auto wanted = argc == 2 ? gallery().find(argv[1]) : gallery().end();
  if (wanted == gallery().end()) {
    std::cerr << "usage: alltact_gallery NAME [with NAME one of";
    for (const auto& [name, make] : gallery()) std::cerr << ' ' << name;
    std::cerr << "]\n";
    return 2;
  }
  int only_name = 1;
  QApplication application(only_name, argv);
  QApplication::setStyle(new StudioStyle);
  const auto widget = wanted->second();
  widget->show();
  return QApplication::exec();
}
