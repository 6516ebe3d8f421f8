#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "metric/worst_places.h"
#include "ops/mesh_difference.h"
#include "problem/problem.h"
#include "session/analysis.h"
#include "session/background.h"
#include "session/edits.h"
#include "session/pointing.h"

namespace gradmesh {

/// One mesh, and what a person makes of it by eye: goes along curves, merges and splits by hand,
/// takes back. All that it shows is measured as it will be written. Not thread-safe; curves are
/// searched for in the background.
class Session {
 public:
  /// `problem` has the mesh as it is and the picture that counts; its bounds do not count. Throws
  /// InputError if the mesh covers no pixel.
  explicit Session(const Problem& problem);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  /// Waits until all searches have ended.
  ~Session();

  /// Returns the problem by which the mesh that is shown is measured.
  const Problem& problem() const { return problem_; }
  /// Returns the problem as whose outcome the mesh is written: of the mesh as its document has it,
  /// whose picture counts later, too, unless a person has drawn something else.
  Problem problem_as_written() const {
    return document_.with_original(place_.next->is_redrawn ? place_.next->original
                                                           : document_.original());
  }
  /// Returns the kinds of curves that the mesh has.
  const std::vector<CurveKind>& kinds() const { return kinds_; }
  CurveSearch& curves() { return *curves_; }
  const CurveSearch& curves() const { return *curves_; }

  // --- what is shown ---
  /// Returns the mesh as it is shown, measured.
  const Candidate& now() const { return now_; }
  /// Returns what the mesh is, and will be written as.
  CurveKind form() const { return place_.form; }
  /// Returns the state of the curve of form() that is shown; -1 if it was edited by hand.
  int state() const { return place_.state; }
  /// Returns the mesh as its document has it now.
  const Candidate& start() const { return start_; }
  bool is_unchanged() const;
  /// Returns true if what is shown has come of edits by hand, of whatever states since.
  bool is_made_by_hand() const { return !place_.next->by_hand.empty(); }
  /// Returns at most that many places where details differ most, in mesh units (worst_places).
  std::vector<WorstPlace> worst_places(int most) const;
  /// Returns the patches of the mesh that is shown with these numbers. Throws InputError if one has
  /// none.
  std::vector<Face> faces_numbered(const std::vector<int>& numbers) const;

  /// Returns the search for what can be found out about the mesh that is shown. All that it has
  /// found is forgotten as soon as another mesh is shown.
  AnalysisSearch& analyses();
  /// Returns what was found out; null if that is not known.
  std::shared_ptr<const Analysis> analysis(AnalysisKind kind) const {
    return analyses_ ? analyses_->found(kind) : nullptr;
  }

  // --- the curve ---
  /// Shows a state of a curve, which is that of the mesh as it was edited by hand last: what was
  /// made there is from then on what counts. As long as `moves_on` is true, nothing of it is taken
  /// down to be taken back. Throws std::invalid_argument if there is no such state.
  void show(CurveKind kind, int state, bool moves_on);

  // --- by hand ---
  /// Sets whether edits are followed by fits.
  void set_fits(bool fits) { fits_ = fits; }
  /// Makes what edits are about lines of one gradient, or patches. Throws InputError if the mesh is
  /// to be one gradient and is none, or is smooth and is to be blocks.
  void set_form(CurveKind form);

  /// An edit that is shown before it is made.
  struct Proposal {
    MadeEdit made;
    /// The mesh after it, measured. Where a patch was merged, making it may fit the patch as well.
    Candidate written;
    /// What the mesh then is.
    CurveKind form;
  };
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
  const Proposal* proposal() const { return proposal_ ? &*proposal_ : nullptr; }
  void forget_proposal() { proposal_.reset(); }
  /// Makes what was proposed. Returns false if nothing is.
  bool make();
  /// Fits the mesh to the picture.
  void fit();

  // --- what stays as it is ---
  /// Sets whether patches of the mesh that is shown are protected: neither edits nor states change
  /// anything of them. States then are those of a curve that leaves what lies there as it was at
  /// first.
  void protect(const std::vector<Face>& faces, bool is_protected);
  /// Protects all patches but these, which are released.
  void protect_others(const std::vector<Face>& faces);
  /// Returns the patches of the mesh that is shown that are protected.
  std::vector<Face> protected_faces() const;
  /// Lets errors in what these patches cover count so many times, whatever patches lie there later.
  /// Curves are then looked for anew. Throws InputError if the factor is not least_weight to
  /// most_weight, or there are no patches.
  void weigh(const std::vector<Face>& faces, double factor);
  /// Lets errors count alike everywhere again.
  void weigh_alike();
  /// Returns true if errors count more or less anywhere.
  bool is_weighted() const { return problem_.frame().weights != nullptr; }
  /// Returns how many times errors count in the middle of a patch of the mesh that is shown.
  double weight_at(Face face) const;

  // --- history ---
  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ < history_.size(); }
  /// Return what a menu calls that which undo() takes back, and that which redo() does again; null
  /// if there is nothing.
  const Message* undo_name() const { return can_undo() ? &history_[done_ - 1].name : nullptr; }
  const Message* redo_name() const { return can_redo() ? &history_[done_].name : nullptr; }
  void undo();
  void redo();
  /// Returns about how many bytes the history takes.
  std::size_t history_bytes() const;

 private:
  /// What states are made of, and measured against.
  struct Basis {
    /// The mesh as it was at first or as it was edited by hand last, with what is protected of it.
    std::shared_ptr<const Mesh> start;
    /// The picture at first, but as it was edited in the areas that were.
    std::shared_ptr<const Original> original;
    std::vector<FilledOutline> by_hand = {};
    /// True if an edit was there to change the picture.
    bool is_redrawn = false;
  };
  /// What is shown beside the mesh itself.
  struct Place {
    CurveKind form;
    int state;
    /// By what the mesh is measured, and of what the curve is. What is edited by hand is measured
    /// against the picture as it was, until a state of its curve is shown.
    std::shared_ptr<const Basis> basis, next;
    /// Where errors count more or less.
    std::shared_ptr<const std::vector<WeightedArea>> weighted;
  };
  struct Change {
    Message name;
    MeshDifference mesh;
    Place before, after;
  };

  Problem problem_as(CurveKind form) const {
    return form == CurveKind::blocks ? problem_ : problem_.as_gradient();
  }
  Place place_as(CurveKind form, int state) const {
    return {form, state, place_.basis, place_.next, place_.weighted};
  }
  bool is_start_of_curve(const Mesh& mesh) const { return mesh == *place_.next->start; }
  /// Returns the place after an edit by hand, which has made a mesh of the one that is shown.
  Place place_after(const Mesh& edited, CurveKind form, bool is_redrawn) const;
  Candidate measured(const Mesh& mesh, CurveKind form) const;
  bool is_as_it_is(const Mesh& mesh, CurveKind form) const;
  void set_now(Candidate written);
  bool is_gradient() const { return place_.form == CurveKind::one_gradient; }
  const Proposal& propose(MadeEdit made, CurveKind form);
  const Proposal& propose(MadeEdit made) { return propose(std::move(made), place_.form); }
  /// Shows a mesh, and takes it down.
  void become(Candidate written, Place place, const Message& name);
  /// Takes down how what is shown differs from what was taken down last.
  void take_down(const Message& name);
  void show_kept();
  void set_protected(const std::vector<Face>& fixed, const std::vector<Face>& released,
                     const Message& name);
  void set_weights(std::vector<WeightedArea> areas, const Message& name);
  /// Measures and looks for curves as that place says from now on.
  void start_from(const Place& place);
  /// Returns the problem of a basis, with the weights of `document_`.
  Problem problem_on(const Basis& basis) const;

  /// Of the mesh as its document has it.
  Problem document_;
  Problem problem_;
  /// What the mesh is in its document.
  CurveKind form_in_document_;
  std::vector<CurveKind> kinds_;
  std::unique_ptr<CurveSearch> curves_;
  Candidate start_, now_;
  Place place_;
  /// What was shown when something was last taken down.
  Mesh kept_;
  Place kept_place_;
  bool fits_ = true;
  std::optional<Proposal> proposal_;
  /// Of what is shown now; null if nothing was asked about it.
  std::unique_ptr<AnalysisSearch> analyses_;
  /// Searches whose mesh is no longer shown. Nobody waits until they have ended.
  std::vector<std::unique_ptr<AnalysisSearch>> old_analyses_;
  std::vector<std::unique_ptr<CurveSearch>> old_curves_;
  std::vector<Change> history_;
  std::size_t done_ = 0;
};

}  // namespace gradmesh
