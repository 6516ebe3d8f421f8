#include "session/hands.h"

#include <set>
#include <string>
#include <utility>

#include "base/error.h"
#include "form/blocks.h"
#include "form/smooth_colors.h"
#include "mesh/face_outline.h"
#include "mesh/rectangle.h"
#include "session/shape_edits.h"

namespace gradmesh {
namespace {

/// Returns a mesh as it is painted.
Mesh with_own_colors(const Mesh& mesh) { return mesh.is_smooth() ? painted_mesh(mesh) : mesh; }

/// Returns the outlines of the patches of each of two meshes that the other one has not.
std::vector<FilledOutline> where_they_differ(const Mesh& one, const Mesh& other) {
  const auto bytes_of = [](const Patch& patch) {
    return std::string(reinterpret_cast<const char*>(&patch), sizeof patch);
  };
  std::vector<FilledOutline> areas;
  const auto add_those_without = [&](const Mesh& mesh, const Mesh& there) {
    std::set<std::string> known;
    for (const Face face : there.faces()) known.insert(bytes_of(there.patch(face)));
    for (const Face face : mesh.faces())
      if (!known.contains(bytes_of(mesh.patch(face)))) areas.push_back(face_outline(mesh, face));
  };
  add_those_without(one, other);
  add_those_without(other, one);
  return areas;
}

/// Returns the setting after an edit by hand of what is shown.
Setting setting_after(const ShownMesh& shown, const Mesh& edited, MeshKind form, bool is_redrawn) {
  Basis next = *shown.setting().next;
  next.start = std::make_shared<const Mesh>(edited);
  for (FilledOutline& area :
       where_they_differ(with_own_colors(shown.mesh()), with_own_colors(edited)))
    next.by_hand.push_back(std::move(area));
  next.original = with_areas(shown.problem_in_document().original(), next.start, next.by_hand);
  next.is_redrawn = next.is_redrawn || is_redrawn;
  Setting setting = shown.setting_as(form, -1);
  setting.next = std::make_shared<const Basis>(std::move(next));
  return setting;
}

}  // namespace

void Hands::set_form(MeshKind form) {
  if (form == shown_.form()) return;
  const Mesh& mesh = shown_.mesh();
  if (form == MeshKind::blocks) check_has_own_colors(mesh);
  if (form == MeshKind::one_gradient && (!shown_.problem().gradient_rules || !find_grid(mesh)))
    throw InputError(
        "the mesh is no grid of whole rows and columns, so it cannot be one gradient.");
  if (form == MeshKind::one_gradient && !has_one_color_at_each_point(mesh))
    throw InputError("colours are sharp at a point, so the mesh cannot be one gradient.");
  shown_.change(
      shown_.measured(mesh, form), shown_.setting_as(form),
      form == MeshKind::blocks ? Message("Make it blocks") : Message("Make it one gradient"));
}

const Proposal& Hands::propose(EditedMesh made, MeshKind form) {
  Candidate written = shown_.measured(made.mesh, form);
  proposal_ = Proposal{std::move(made), std::move(written), form};
  revision_ = shown_.revision();
  return *proposal_;
}

const Proposal& Hands::propose(const Pointed& pointed, HandEdit edit) {
  forget_proposal();
  return propose(shown_.is_gradient()
                     ? edit_lines(shown_.mesh(), pointed, edit, fits_, shown_.problem())
                     : edit_patches(shown_.mesh(), pointed, edit));
}

const Proposal& Hands::propose_straight(const Pointed& pointed) {
  forget_proposal();
  return propose(straightened(shown_.mesh(), pointed));
}

const Proposal& Hands::propose_curve(const Pointed& pointed) {
  forget_proposal();
  const Proposal& proposal = propose(bent(shown_.mesh(), pointed, *shown_.problem().reference()));
  if (proposal.written.error < shown_.now().error) return proposal;
  forget_proposal();
  throw InputError("as a curve this side would not be closer to the picture.");
}

const Proposal& Hands::propose_move(const Grip& grip, glm::dvec2 to) {
  forget_proposal();
  return propose(moved(shown_.mesh(), grip, to, shown_.problem()));
}

const Proposal& Hands::propose_color(const Pointed& pointed, const glm::dvec3& color,
                                     bool is_sharp) {
  forget_proposal();
  if (is_sharp && shown_.is_gradient())
    throw InputError("one gradient has one colour at each point; make it blocks first.");
  return propose(recolored(shown_.mesh(), pointed, color, is_sharp));
}

const Proposal& Hands::propose_joined(const Pointed& pointed) {
  forget_proposal();
  return propose(joined(shown_.mesh(), pointed));
}

const Proposal& Hands::propose_merge(const std::vector<Face>& faces) {
  forget_proposal();
  return propose(merged_patches(shown_.mesh(), faces), MeshKind::blocks);
}

const Proposal* Hands::proposal() const {
  return proposal_ && revision_ == shown_.revision() ? &*proposal_ : nullptr;
}

bool Hands::make() {
  if (!proposal()) return false;
  auto [made, written, form] = *std::exchange(proposal_, std::nullopt);
  if (fits_ && made.merged.valid()) {
    Candidate better =
        shown_.measured(fitted(written.mesh, false, {made.merged}, shown_.problem()), form);
    if (better.error < written.error) written = std::move(better);
  }
  change(std::move(written), form, made.redraws, made.name);
  return true;
}

void Hands::fit() {
  const Mesh& mesh = shown_.mesh();
  std::vector<Face> faces;
  for (const Face face : mesh.faces()) faces.push_back(face);
  Candidate found =
      shown_.measured(fitted(mesh, shown_.is_gradient(), faces, shown_.problem()), shown_.form());
  if (found.error < shown_.now().error)
    change(std::move(found), shown_.form(), false, Message("Fit to the picture"));
}

void Hands::change(Candidate edited, MeshKind form, bool is_redrawn, const Message& name) {
  const Setting setting = setting_after(shown_, edited.mesh, form, is_redrawn);
  shown_.measure_in(setting);
  shown_.change(std::move(edited), setting, name);
}

}  // namespace gradmesh
