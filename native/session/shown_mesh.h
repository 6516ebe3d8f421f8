#pragma once

#include <memory>
#include <vector>

#include "metric/worst_places.h"
#include "problem/problem.h"
#include "session/analysis.h"
#include "session/curve_search.h"
#include "session/history.h"
#include "session/latest_search.h"
#include "session/setting.h"

namespace gradmesh {

/// The mesh that a session shows, measured as it will be written, with what is searched for of it
/// in the background and how it came about.
class ShownMesh {
 public:
  /// Throws InputError if the mesh covers no pixel.
  explicit ShownMesh(const Problem& problem);
  ShownMesh(const ShownMesh&) = delete;
  ShownMesh& operator=(const ShownMesh&) = delete;
  /// Waits until all searches have ended.
  ~ShownMesh();

  /// Returns the mesh, measured.
  const Candidate& now() const { return now_; }
  const Mesh& mesh() const { return now_.mesh; }
  /// Returns the mesh as its document has it now.
  const Candidate& start() const { return start_; }
  const Setting& setting() const { return setting_; }
  MeshKind form() const { return setting_.form; }
  int state() const { return setting_.state; }
  bool is_gradient() const { return form() == MeshKind::one_gradient; }
  bool is_unchanged() const { return is_as_in_document(mesh(), form()); }
  /// Returns true if it has come of edits by hand, of whatever states since.
  bool is_made_by_hand() const { return !setting_.next->by_hand.empty(); }
  /// Returns a number that is another one whenever another mesh is shown.
  int revision() const { return revision_; }

  /// Returns the problem by which the mesh is measured.
  const Problem& problem() const { return problem_; }
  /// Returns the problem of the mesh as its document has it.
  const Problem& problem_in_document() const { return document_; }
  /// Returns the problem as whose outcome the mesh is written: of the mesh as its document has it,
  /// whose picture counts later, too, unless a person has drawn something else.
  Problem problem_as_written() const;
  /// Returns a mesh as it would be shown, measured. Throws InputError if it cannot be written.
  Candidate measured(const Mesh& mesh, MeshKind form) const;

  /// Returns at most that many places where details differ most, in mesh units (worst_places).
  std::vector<WorstPlace> worst_places(int most) const;
  /// Returns the patches with these numbers. Throws InputError if one has none.
  std::vector<Face> faces_numbered(const std::vector<int>& numbers) const;
  /// Returns the patches that are protected.
  std::vector<Face> protected_faces() const;
  /// Returns true if errors count more or less anywhere.
  bool is_weighted() const { return problem_.frame().weights != nullptr; }
  /// Returns how many times errors count in the middle of a patch.
  double weight_at(Face face) const;

  /// Returns the kinds of curves that the mesh has.
  const std::vector<MeshKind>& kinds() const { return kinds_; }
  CurveSearch& curves() const { return *curves_.get(); }
  /// Returns the search for what can be found out about the mesh, with the fits that edits have.
  /// All that it has found is forgotten as soon as another mesh is shown.
  AnalysisSearch& analyses(bool fits);
  /// Returns what was found out; null if that is not known.
  std::shared_ptr<const Analysis> analysis(AnalysisKind kind) const;

  /// Returns the setting of another form and state.
  Setting setting_as(MeshKind form, int state) const;
  /// Returns the setting of the mesh in a form if it was not edited by hand since its curve began:
  /// the first state; else that of no state.
  Setting setting_as(MeshKind form) const;
  /// Measures and looks for curves as a setting says from now on.
  void measure_in(const Setting& setting);
  /// Shows a mesh that was measured in a setting.
  void show(Candidate written, const Setting& setting);
  /// Shows it, and records that.
  void change(Candidate written, const Setting& setting, const Message& name);
  /// Records what is shown.
  void record(const Message& name) { history_.record(mesh(), setting_, name); }
  void undo();
  void redo();
  const History& history() const { return history_; }

 private:
  bool is_as_in_document(const Mesh& mesh, MeshKind form) const;
  Problem problem_as(MeshKind form) const;
  /// Returns the problem of a basis, with the weights of `document_`.
  Problem problem_on(const Basis& basis) const;
  void show_recorded();

  Problem document_, problem_;
  std::vector<MeshKind> kinds_;
  /// What the mesh is in its document.
  MeshKind form_in_document_;
  Candidate start_, now_;
  Setting setting_;
  History history_;
  int revision_ = 0;
  LatestSearch<CurveSearch> curves_;
  /// Of what is shown now; none if nothing was asked about it.
  LatestSearch<AnalysisSearch> analyses_;
};

}  // namespace gradmesh
