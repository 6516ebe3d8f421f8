#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/document/frames.h"
#include "app/runs/runs.h"

namespace gradmesh::bench {

/// A mesh to run on: one of the paper's, whose files may be absent, or one of our samples.
struct MeshFile {
  std::string name;  ///< As in lines of results.
  std::filesystem::path path;
  std::string id;  ///< Of the mesh in its document.

  bool exists() const { return std::filesystem::exists(path); }
};

/// The authors' meshes of the paper, in ../shared/meshes beside the project.
std::vector<MeshFile> paper_meshes();
/// Every mesh in samples/.
std::vector<MeshFile> sample_meshes();
/// Of either, by its name.
MeshFile mesh_file(const std::string& name);

/// A mesh that was read, and how its document frames it.
struct Input {
  explicit Input(const MeshFile& file);

  Frame frame(int resolution) const { return frame_of(*document, entry, mesh, resolution); }

  std::unique_ptr<Document> document;
  MeshEntry entry;
  Mesh mesh;
};

/// An image and another that differs from it a little at every pixel, so that no metric can leave
/// any out: smooth colours, edges, and noise, the same on every machine.
std::pair<Image, Image> image_pair(int width, int height);

}  // namespace gradmesh::bench
