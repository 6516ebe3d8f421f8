#pragma once

#include <CLI/CLI.hpp>

namespace gradmesh {

/// Each adds one subcommand, which runs when it is parsed, to the program. A subcommand throws
/// InputError at bad input and std::invalid_argument at options that do not go together.
void add_info(CLI::App& program);
void add_devices(CLI::App& program);
void add_simplify(CLI::App& program);
void add_render(CLI::App& program);
void add_compare(CLI::App& program);
void add_analyze(CLI::App& program);
void add_draw(CLI::App& program);
void add_report(CLI::App& program);
void add_convert(CLI::App& program);
void add_update(CLI::App& program);
void add_merge(CLI::App& program);
void add_refine(CLI::App& program);
void add_color(CLI::App& program);
void add_one_mesh(CLI::App& program);
void add_publish(CLI::App& program);
void add_eye(CLI::App& program);
void add_trace(CLI::App& program);
void add_helper(CLI::App& program);

}  // namespace gradmesh
