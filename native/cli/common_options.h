#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "app/document/weighted_shapes.h"
#include "app/pages/page_documents.h"
#include "app/runs/runs.h"

namespace gradmesh {

/// Returns what help calls a document that can be read: "SVG document, .hemesh file or PDF".
std::string any_document();

/// Adds --page, --password and --all-layers.
void add_page_options(CLI::App& command, PageChoice& choice);
/// Reads a document, and says on stderr what of its pages was left out.
std::unique_ptr<Document> read_and_warn(const std::filesystem::path& path,
                                        const PageChoice& choice = {});

/// Returns the name of an option of a run on the command line, such as "--max-local-error".
std::string flag_of(const std::string& option);
/// Adds the options of a run with these names (simplify/options.h) to a subcommand. The members of
/// `options` hold the defaults and must outlive parsing.
void add_options(CLI::App& command, SimplifyOptions& options,
                 const std::vector<std::string>& names);
/// Adds --id, which may be repeated.
void add_ids(CLI::App& command, std::vector<std::string>& ids);
/// Adds --id of one mesh.
void add_id(CLI::App& command, std::string& id);
/// Adds --weigh ID=FACTOR, which may be repeated.
CLI::Option* add_weigh_option(CLI::App& command, ShapeWeights& weights,
                              const std::string& description);
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
void add_analysis_options(CLI::App& command, PricePaths& analyses);

}  // namespace gradmesh
