#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <vector>

#include "app/editing/edits.h"

namespace gradmesh {

/// What commands that edit a document by hand have in common: the document, what it is measured
/// against and how, and what is written and told.
struct EditArguments {
  std::filesystem::path in, out, preview, original;
  SimplifyOptions measure;
  bool as_json = false, quiet = false;

  MeasureOptions measuring() const { return {measure.metric, measure.resolution}; }
};

/// Adds IN, -o, --preview and the other options of `arguments`, which must outlive parsing.
void add_edit_arguments(CLI::App& command, EditArguments& arguments);
/// Adds --patches.
void add_patches(CLI::App& command, std::vector<int>& patches, const std::string& help);

/// Reads the document, edits it, writes it or the picture of what became of its one edited mesh,
/// and tells what became of the meshes.
void run_edit(const EditArguments& arguments,
              const std::function<std::vector<EditReport>(Document&)>& edit);

}  // namespace gradmesh
