#pragma once

#include <optional>
#include <vector>

#include "session/edits.h"
#include "session/pointing.h"
#include "session/shown_mesh.h"

namespace gradmesh {

/// An edit by hand that is shown before it is made.
struct Proposal {
  EditedMesh made;
  /// The mesh after it, measured. Where a patch was merged, making it may fit the patch as well.
  Candidate written;
  /// What the mesh then is.
  MeshKind form;
};

/// Edits of a mesh by hand: proposed, then made.
class Hands {
 public:
  explicit Hands(ShownMesh& shown) : shown_(shown) {}

  /// Sets whether edits are followed by fits.
  void set_fits(bool fits) { fits_ = fits; }
  bool fits() const { return fits_; }
  /// Makes what edits are about lines of one gradient, or patches. Throws InputError if the mesh is
  /// to be one gradient and is none, or is smooth and is to be blocks.
  void set_form(MeshKind form);

  /// Work out an edit at a place. Throw InputError where it cannot be done, with the reason;
  /// nothing is then proposed.
  const Proposal& propose(const Pointed& pointed, HandEdit edit);
  const Proposal& propose_straight(const Pointed& pointed);
  /// Throws InputError as well if the picture is no closer then.
  const Proposal& propose_curve(const Pointed& pointed);
  const Proposal& propose_move(const Grip& grip, glm::dvec2 to);
  /// In a mesh that is one gradient a colour is not sharp, or InputError is thrown.
  const Proposal& propose_color(const Pointed& pointed, const glm::dvec3& color, bool is_sharp);
  const Proposal& propose_joined(const Pointed& pointed);
  /// Works out patches merged to one; the mesh is blocks then.
  const Proposal& propose_merge(const std::vector<Face>& faces);
  /// Returns what is proposed; null if nothing is, and after another mesh was shown.
  const Proposal* proposal() const;
  void forget_proposal() { proposal_.reset(); }
  /// Makes what is proposed. Returns false if nothing is.
  bool make();
  /// Fits the mesh to the picture.
  void fit();

 private:
  const Proposal& propose(EditedMesh made, MeshKind form);
  const Proposal& propose(EditedMesh made) { return propose(std::move(made), shown_.form()); }
  /// Measures the mesh that an edit has made of the one that is shown, and shows it.
  void change(Candidate edited, MeshKind form, bool is_redrawn, const Message& name);

  ShownMesh& shown_;
  bool fits_ = true;
  std::optional<Proposal> proposal_;
  /// ShownMesh::revision() when that was worked out.
  int revision_ = 0;
};

}  // namespace gradmesh
