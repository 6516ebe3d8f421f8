#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/export/info.h"
#include "cli/commands.h"
#include "cli/common_options.h"

namespace gradmesh {
namespace {

struct InfoArguments {
  std::filesystem::path in;
  PageChoice pages;
  bool as_json = false;
};

/// Returns what was found of a mesh of a page.
std::string in_words(const nlohmann::ordered_json& found) {
  char difference[32];
  std::snprintf(difference, sizeof difference, "%.4f", found["difference"].get<double>());
  std::string words = "; " + std::to_string(found["patches"].get<int>()) + " patches with " +
                      std::to_string(found["handles"].get<int>()) + " handles on the page";
  if (const int shadings = found["shadings"]; shadings > 1)
    words += ", the tiles of one surface in " + std::to_string(shadings) + " shadings";
  if (const int rows = found["rows"]; rows > 0)
    words += ", one grid of " + std::to_string(rows) + " x " +
             std::to_string(found["columns"].get<int>()) +
             (found["smooth"] ? " with smooth colours" : "") +
             (found["record"] ? " from Illustrator's own data" : "");
  return words + ", FLIP " + difference;
}

void run_info(const InfoArguments& a) {
  const std::unique_ptr<Document> document = read_and_warn(a.in, a.pages);
  if (a.as_json) {
    std::cout << info_text(*document);
    return;
  }
  const nlohmann::ordered_json info = info_json(*document);
  for (const auto& mesh : info["meshes"]) {
    const std::string role =
        mesh["role"].is_null() ? "" : " (" + mesh["role"].get<std::string>() + ")";
    if (mesh.contains("refused")) {
      std::printf("%s%s: cannot be read: %s\n", mesh["id"].get<std::string>().c_str(), role.c_str(),
                  mesh["refused"].get<std::string>().c_str());
      continue;
    }
    const int objects = mesh["objects"];
    std::printf("%s%s: %d handles, %d patches, %d object%s, %d points, %d T-junctions%s%s%s\n",
                mesh["id"].get<std::string>().c_str(), role.c_str(), mesh["handles"].get<int>(),
                mesh["patches"].get<int>(), objects, objects == 1 ? "" : "s",
                mesh["points"].get<int>(), mesh["t_junctions"].get<int>(),
                mesh["simplified"] ? ", simplified" : "",
                mesh["remembers"] ? ", remembers its original" : "",
                mesh.contains("found") ? in_words(mesh["found"]).c_str() : "");
  }
  for (const auto& mesh : info["unused"])
    std::printf("%s: %d patches, unused: no object is painted by it\n",
                mesh["id"].get<std::string>().c_str(), mesh["patches"].get<int>());
}

}  // namespace

void add_info(CLI::App& program) {
  const auto a = std::make_shared<InfoArguments>();
  CLI::App& command = *program.add_subcommand("info", "List the meshes of a document");
  add_path(command, "IN", a->in, any_document())->required();
  add_page_options(command, a->pages);
  command.add_flag("--json", a->as_json,
                   "Print JSON, with all points, handles, faces and half-edges");
  command.callback([a] { run_info(*a); });
}

}  // namespace gradmesh
