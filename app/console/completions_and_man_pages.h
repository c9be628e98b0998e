// Completion scripts for shells, made from the tables that the command line itself is read with.
#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace alltact {

/// The script that `shell` (bash, zsh or fish) loads for `program`. Error: another shell.
[[nodiscard]] Result<std::string> completions(const CLI::App& program, std::string_view shell);

/// For one shell each; completions() chooses.
[[nodiscard]] std::string bash_completions(const CLI::App& program);
[[nodiscard]] std::string zsh_completions(const CLI::App& program);
[[nodiscard]] std::string fish_completions(const CLI::App& program);

/// A text for a shell, as one word between single quotes.
[[nodiscard]] std::string single_quoted(std::string_view text);

/// "_alltact_studio" for alltact-studio, as functions are named.
[[nodiscard]] std::string function_name(const CLI::App& program);

// Manual pages, made from the tables that the command line itself is read with.

/// The page of a full program, or of one command: NAME, or NAME-COMMAND. Section 1, in man(7)'s
/// macros.
[[nodiscard]] std::string man_page(const CLI::App& program, const std::string& version,
                                   const CLI::App* command = nullptr);

}  // namespace alltact
