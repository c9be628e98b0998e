// Manual pages, made from the tables that the command line itself is read with.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace alltact {

/// The page of a full program, or of one command: NAME, or NAME-COMMAND. Section 1, in man(7)'s
/// macros.
[[nodiscard]] std::string man_page(const CLI::App& program,
                                   const std::string& version,
                                   const CLI::App* command = nullptr);

}  // namespace alltact
