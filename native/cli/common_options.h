#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "app/runs.h"

namespace gradmesh {

/// Returns what help calls a document of any format: "SVG document or .hemesh file".
std::string any_document();

/// Options that several subcommands share; the variable holds the default and must outlive
/// parsing.
void add_metric_option(CLI::App& command, std::string& metric);
void add_resolution_option(CLI::App& command, int& resolution);
void add_epsilon_option(CLI::App& command, double& epsilon);
void add_kappa_option(CLI::App& command, double& kappa);
void add_color_model_option(CLI::App& command, std::optional<ColorModel>& model);
/// `--whole-mesh` makes `visible_only` false.
void add_whole_mesh_option(CLI::App& command, bool& visible_only);
void add_threads_option(CLI::App& command, int& threads);
/// Adds --renderer.
void add_renderer_option(CLI::App& command, std::string& renderer);
/// Sets the device of the renderer in the options, and says on stderr if there is none or if it
/// fails.
void take_renderer(const std::string& renderer, RunOptions& options);
/// Says in one line on stderr that the run goes on without a device.
void say_without_device(const std::string& reason);
/// Adds an option that names a file.
CLI::Option* add_path(CLI::App& command, const std::string& names, std::filesystem::path& path,
                      const std::string& description);
/// Adds --original.
void add_original_option(CLI::App& command, std::filesystem::path& original);
/// Lets `document` be measured against the file `original`, unless that is empty. Returns the
/// document of the file, which must outlive the runs.
std::unique_ptr<Document> take_original(const std::filesystem::path& original, Document& document);
/// Adds --load-analysis and --save-analysis.
void add_analysis_options(CLI::App& command, AnalysisPaths& analyses);

}  // namespace gradmesh
