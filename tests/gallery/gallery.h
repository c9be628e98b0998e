// Each widget alone, with made-up content that is always the same.
#pragma once

#include <QWidget>
#include <map>
#include <memory>
#include <string>

namespace alltact {

/// By name, what makes the widget.
[[nodiscard]] const std::map<std::string, std::unique_ptr<QWidget> (*)()>& gallery();

}  // namespace alltact
