// Completion scripts for shells, and manual pages, made from the tables that the command line
// itself is read with.
#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace alltact {

/// The script that `shell` (bash, zsh or fish) loads for `program`. Error: another shell.
[[nodiscard]] Result<std::string> completions(const CLI::App& program, std::string_view shell);

/// The page of a full program, or of one command: NAME, or NAME-COMMAND. Section 1, in man(7)'s
/// macros.
[[nodiscard]] std::string man_page(const CLI::App& program, const std::string& version,
                                   const CLI::App* command = nullptr);

}  // namespace alltact
