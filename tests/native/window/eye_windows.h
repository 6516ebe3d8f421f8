#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/pages/read_document.h"
#include "screen.h"

namespace gradmesh::test {

inline std::string same(const std::string& text) { return text; }

inline constexpr glm::ivec2 ordinary_size(1100, 900);

/// A person who looks at a document in samples/.
class EyeWindows : public testing::Test {
 protected:
  void open(const std::string& name, bool is_dark = false, float density = 1,
            Translation translation = same, glm::ivec2 size = ordinary_size) {
    open_file(std::string(GRADMESH_SOURCE_DIR) + "/samples/" + name + ".svg", is_dark, density,
              translation, size);
  }
  void open_file(const std::filesystem::path& file, bool is_dark = false, float density = 1,
                 Translation translation = same, glm::ivec2 size = ordinary_size) {
    // What is looked at refers to the document before.
    screen_.reset();
    eye_.reset();
    document_ = read_document(file);
    std::vector<std::string> ids;
    for (const MeshEntry& entry : document_->selected({})) ids.push_back(entry.id);
    eye_.emplace(ids, [this](const std::string& id) {
      // What is measured does not matter here.
      RunOptions options;
      options.resolution = 100;
      return edit_by_eye(*document_, document_->selected({id}).front(), options);
    });
    screen_.emplace(*eye_, size.x, size.y, translation, is_dark, density);
  }
  void wait_for_curve() {
    session().curves().wait();
    screen_->settle();
  }

  Session& session() { return eye_->session(); }
  int handles() { return session().shown().now().counts().handles; }
  /// Returns where a place in mesh units is in the window.
  glm::dvec2 seen_at(glm::dvec2 place) const { return eye_->to_pixels().point(place); }
  /// Returns the middle of the curve of a line inside the mesh that costs little to take out.
  glm::dvec2 on_a_line() {
    const Mesh& mesh = session().mesh();
    for (const Halfedge curve : mesh.curves())
      if (mesh[curve].twin.valid()) return seen_at(mesh.curve_of(curve).at(0.5).position);
    return {};
  }
  glm::dvec2 middle_of(Face face) {
    return seen_at(session().mesh().patch(face).at(0.5, 0.5).position);
  }
  std::vector<std::uint32_t> pixels() const {
    const Surface& s = screen_->surface();
    return {s.pixels, s.pixels + s.stride * s.height};
  }

  std::unique_ptr<Document> document_;
  std::optional<Eye> eye_;
  std::optional<Screen> screen_;
};

}  // namespace gradmesh::test
