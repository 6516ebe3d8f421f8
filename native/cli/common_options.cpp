#include "cli/common_options.h"

#include <iostream>

#include "app/devices.h"
#include "base/limits.h"
#include "base/utf8_path.h"

namespace gradmesh {
namespace {

std::vector<std::string> metric_names() {
  std::vector<std::string> names;
  for (const MetricEntry& entry : all_metrics()) names.emplace_back(entry.name);
  return names;
}

}  // namespace

std::string any_document() { return formats_in_words(&Format::document); }

void add_metric_option(CLI::App& command, std::string& metric) {
  command.add_option("--metric", metric, "How pictures are compared")
      ->check(CLI::IsMember(metric_names()))
      ->capture_default_str();
}

void add_resolution_option(CLI::App& command, int& resolution) {
  command.add_option("--resolution", resolution, "Pixels along the longer side")
      ->check(CLI::Range(16, int(limits().resolution)))
      ->capture_default_str();
}

CLI::Option* add_path(CLI::App& command, const std::string& names, std::filesystem::path& path,
                      const std::string& description) {
  return command.add_option_function<std::string>(
      names, [&path](const std::string& text) { path = utf8_path(text); }, description);
}

void add_original_option(CLI::App& command, std::filesystem::path& original) {
  add_path(command, "--original", original,
           "Measure against the mesh of this file, of the same id or the only one");
}

std::unique_ptr<Document> take_original(const std::filesystem::path& original, Document& document) {
  if (original.empty()) return nullptr;
  std::unique_ptr<Document> other = Document::read_file(original);
  document.measure_against(other.get());
  return other;
}

void add_epsilon_option(CLI::App& command, double& epsilon) {
  command.add_option("--epsilon", epsilon, "Largest error allowed")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
}

void add_kappa_option(CLI::App& command, double& kappa) {
  command
      .add_option("--kappa", kappa,
                  "motorcycle: share of epsilon above which an edge bounds the parts")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void add_color_model_option(CLI::App& command, std::optional<ColorModel>& model) {
  command
      .add_option_function<std::string>(
          "--color-model", [&model](const std::string& name) { model = color_model_named(name); },
          "How colours are held between corners; by default bicubic in .hemesh files, where SVG "
          "is involved bilinear")
      ->check(CLI::IsMember({"bilinear", "bicubic"}));
}

void add_whole_mesh_option(CLI::App& command, bool& visible_only) {
  command.add_flag("!--whole-mesh", visible_only,
                   "SVG: what outlines, clip paths and masks hide of the mesh counts too");
}

void add_threads_option(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "0: all cores")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void add_renderer_option(CLI::App& command, std::string& renderer) {
  command
      .add_option("--renderer", renderer,
                  "Where errors are found: software, egl (what EGL offers), or auto, which takes a "
                  "graphics processor where that is faster")
      ->check(CLI::IsMember({"auto", "software", "egl"}))
      ->capture_default_str();
}

void take_renderer(const std::string& renderer, RunOptions& options) {
  use_renderer(options, renderer_named(renderer), say_without_device);
}

void say_without_device(const std::string& reason) {
  std::cerr << "gradmesh: " << reason << "; it goes on in software.\n";
}

void add_analysis_options(CLI::App& command, AnalysisPaths& analyses) {
  add_path(command, "--load-analysis", analyses.load,
           "Take prices from this file, which an earlier run has saved");
  add_path(command, "--save-analysis", analyses.save, "Save all prices that were used");
}

}  // namespace gradmesh
