#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gradmesh {

/// Options that several subcommands share; the variable holds the default and must outlive
/// parsing.
void add_metric_option(CLI::App& command, std::string& metric);
void add_resolution_option(CLI::App& command, int& resolution);

}  // namespace gradmesh
