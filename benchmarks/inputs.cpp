#include "inputs.h"
#include "app/pages/read_document.h"

#include <algorithm>
#include <random>
#include <stdexcept>

namespace gradmesh::bench {
namespace {

const MeshEntry& entry_of(const Document& document, const std::string& id) {
  const auto& entries = document.meshes();
  const auto found = std::ranges::find(entries, id, &MeshEntry::id);
  if (found == entries.end()) throw std::invalid_argument(document.name() + " has no " + id);
  return *found;
}

std::uint8_t sample(int value) { return std::uint8_t(std::clamp(value, 0, 255)); }

}  // namespace

std::vector<MeshFile> paper_meshes() {
  const std::filesystem::path folder = GRADMESH_SHARED_DIR "/meshes";
  const std::pair<const char*, const char*> files[] = {
      {"raindrop", "teardrop"},     {"perfect6", "global-refinement"},
      {"perturbed6", "modifiedgr"}, {"apple", "apple"},
      {"banana", "banana"},         {"tulips", "global-tulips"},
      {"duck", "global_duck"}};
  std::vector<MeshFile> meshes;
  for (const auto& [name, file] : files)
    meshes.push_back({name, folder / (std::string(file) + ".hemesh"), "mesh"});
  return meshes;
}

std::vector<MeshFile> sample_meshes() {
  std::vector<MeshFile> meshes;
  for (const auto& file : std::filesystem::directory_iterator(GRADMESH_SOURCE_DIR "/samples")) {
    if (file.path().extension() != ".svg") continue;
    const auto document = read_document(file.path());
    for (const MeshEntry& entry : document->meshes())
      meshes.push_back({entry.id, file.path(), entry.id});
  }
  std::ranges::sort(meshes, {}, &MeshFile::name);
  return meshes;
}

MeshFile mesh_file(const std::string& name) {
  for (const auto& meshes : {paper_meshes(), sample_meshes()})
    for (const MeshFile& mesh : meshes)
      if (mesh.name == name) return mesh;
  throw std::invalid_argument("there is no mesh " + name);
}

Input::Input(const MeshFile& file)
    : document(read_document(file.path)),
      entry(entry_of(*document, file.id)),
      mesh(document->mesh(entry)) {}

std::pair<Image, Image> image_pair(int width, int height) {
  Image a(width, height), b(width, height);
  std::mt19937 random(1);  // its numbers, unlike those of distributions, are the same everywhere
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) {
        const int smooth = (200 * x / width * (c + 1) + 180 * y / height * (3 - c)) / 3;
        const int edge = (x / 97 + y / 61) % 2 ? 40 : 0;
        const std::uint8_t value = sample(20 + smooth / 2 + edge + int(random() % 5));
        *a.at(x, y, c) = value;
        *b.at(x, y, c) = sample(value + 1 + int(random() % 6));
      }
  return {std::move(a), std::move(b)};
}

}  // namespace gradmesh::bench
