#include "widgets/shell/primary_button.h"

namespace alltact {
namespace {

constexpr const char* kPrimary = "alltact_primary";
constexpr int kPrimaryHeight = 40;

}  // namespace

void set_primary(QPushButton& button, bool is_primary) {
  if (alltact::is_primary(button) == is_primary) return;
  button.setProperty(kPrimary, is_primary);
  button.setMinimumHeight(is_primary ? kPrimaryHeight : 0);
  QFont font = button.font();
  font.setBold(is_primary);
  button.setFont(font);
  button.update();
}

bool is_primary(const QWidget& widget) {
  return widget.property(kPrimary).toBool();
}

}  // namespace alltact
