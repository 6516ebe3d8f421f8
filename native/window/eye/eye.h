#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editing/editing.h"
#include "session/picture.h"
#include "window/eye/viewport.h"

namespace gradmesh {

/// What a person has chosen to see.
struct Looks {
  SessionView::Ground ground = SessionView::Ground::result;
  /// Where the line between original and result is, a share of the width.
  double split = 0.5;
  bool lines = true, handles = false;
  std::optional<AnalysisKind> known = std::nullopt;
  /// Which region of the patch is shown, the largest being 0.
  int region = 0;
  /// The original is shown as long as a key is held.
  bool flickers = false;
  /// The curve is drawn by patches, not by handles.
  bool by_patches = false;
};

/// An element of the structure that a person looks at; one of them is valid, or none.
struct Element {
  Face face = {};
  Halfedge halfedge = {};
  Point point = {};

  bool operator==(const Element&) const = default;
};

/// The meshes of a document that a person simplifies by eye, one of which is looked at, and how. It
/// knows no toolkit: what a window shows is a function of an Eye.
class Eye {
 public:
  using Open = std::function<std::unique_ptr<Editing>(const std::string& id)>;

  /// `open` begins a session over a mesh; each is begun when it is looked at first. Throws what
  /// `open` throws of the first.
  Eye(std::vector<std::string> ids, Open open);

  const std::vector<std::string>& ids() const { return ids_; }
  const std::string& id() const { return ids_[chosen_]; }
  /// Looks at another mesh; what was made of the others stays. Where that one cannot be opened, all
  /// is as it was, and refusal() says why.
  void choose(std::size_t which);

  Editing& editing() { return *open_ones_[chosen_]; }
  const Editing& editing() const { return *open_ones_[chosen_]; }
  Session& session() { return editing().session; }
  const Session& session() const { return editing().session; }
  /// Returns the sessions in which something was made of the mesh.
  std::vector<const Editing*> changed() const;
  /// Returns true if what closing without applying loses cannot be had again by moving a slider.
  bool has_hand_work() const;

  Looks looks;
  /// Deeds are followed by fits.
  bool fits = true;

  // --- from where ---
  Viewport& viewport() { return viewport_; }
  /// Returns the map from mesh units to the pixels of the picture.
  Affine to_pixels() const { return viewport_.to_pixels() * editing().view; }
  /// Returns what is to be painted.
  SessionView view() const;
  /// Returns a number that is another one whenever the session shows something else.
  int revision() const { return revision_; }
  void look_at(const WorstPlace& place);

  // --- deeds ---
  /// Does something to the session, and forgets what was of another mesh. What cannot be done is
  /// told by refusal().
  void attempt(const std::function<void(Session&)>& deed);
  /// Works out an edit that is shown before it is made. Where there is none, `work_out` throws
  /// InputError, whose reason is why_not().
  void propose(const std::function<void(Session&)>& work_out);
  void forget_proposal();
  /// Makes what is proposed. Returns false if nothing is.
  bool make();
  /// Returns why the last deed was not done.
  const std::optional<Message>& refusal() const { return refusal_; }
  /// Returns why nothing is proposed where the pointer is.
  const std::optional<Message>& why_not() const { return why_not_; }
  /// Returns the protected patch that is the reason; invalid where there is another, or none.
  Face forbids() const { return forbids_; }

  /// Returns what lies at a pixel within reach of the pointer; nothing beside the mesh.
  std::optional<Pointed> pointed_at(glm::dvec2 pixel) const;
  /// How many pixels the screen has for each of an ordinary one.
  double density = 1;

  // --- the curve ---
  /// Returns what is found of the curve of the form that is shown.
  std::optional<CurveSearch::Found> curve() const;
  /// Shows a state, or the closest that there is.
  void slide(int state, bool moves_on = false);
  /// Goes on along the curve; from a mesh edited by hand, to the state with about as many handles.
  void step(int by);

  // --- marked patches ---
  const std::vector<Face>& marked() const { return marked_; }
  void mark(const std::vector<Face>& faces, bool adds);
  /// Marks a patch, or no longer.
  void toggle_mark(Face face);
  void unmark();
  /// What merging all that is marked would do.
  struct MarksPrice {
    double error;
    /// Why it cannot be done.
    std::optional<Message> why_not;
  };
  /// Works out what merging the marks would do; nothing is proposed afterwards.
  void price_marks();
  /// Returns what was worked out of these marks; nothing for less than two.
  const std::optional<MarksPrice>& marks_price() const { return marks_price_; }
  /// Returns true if all that is marked is protected.
  bool marks_are_protected() const;
  /// Returns the patches that are marked; where no more than one is, those of the region that is
  /// shown.
  std::vector<Face> to_merge() const;

  /// Makes one patch of to_merge().
  void merge_marked();
  /// Lets what is marked stay as it is whatever is done, or no longer if all of it is protected.
  void protect_marked();
  /// Lets only what is marked change, even what was protected before.
  void protect_others();

  // --- what else is known of the mesh ---
  static constexpr int worst_count = 5;
  /// Returns at most worst_count places where details of the mesh differ most.
  const std::vector<WorstPlace>& worst_places();
  /// The worst places are circled, until another mesh is shown.
  bool circles_worst = false;
  /// The patch that was pointed at last; invalid before that.
  Face patch_at_pointer = {};
  /// Returns the patch whose regions are looked at.
  Face patch() const { return marked_.empty() ? patch_at_pointer : marked_.front(); }
  /// Returns what is known of what is to be shown; null until it is found out.
  std::shared_ptr<const Analysis> known() const;
  /// Returns the regions that hold patch().
  std::vector<RegionPrice> regions() const;
  /// Goes to a smaller region, or with -1 to a larger one, round and round.
  void step_region(int by);
  /// What of the structure is looked at.
  Element element;
  /// The colour that is being chosen for the point that is looked at.
  std::optional<glm::dvec3> chosen_color = std::nullopt;
  /// The next click on the picture gives that point the colour of the place.
  bool picks_color = false;
  /// Shows a colour of the point that is looked at before it is made, then makes it.
  void propose_color(const glm::dvec3& color);
  void make_color();
  /// Gives that point the colour that is seen at a pixel.
  void pick_color(glm::dvec2 pixel);

  /// Begins to find out what is to be shown, unless `is_moving`. Call this before each frame.
  void look_for_news(bool is_moving);
  /// Returns true if something was still searched for in the background when look_for_news() looked
  /// last: what has been found since is not drawn yet.
  bool is_busy() const { return is_busy_; }

 private:
  void look_at_mesh(std::size_t which);
  void forget();
  void forget_reasons();

  std::vector<std::string> ids_;
  Open open_;
  /// Null where nobody has looked.
  std::vector<std::unique_ptr<Editing>> open_ones_;
  std::size_t chosen_ = 0;
  Viewport viewport_;
  std::optional<Message> refusal_, why_not_;
  Face forbids_;
  std::vector<Face> marked_;
  std::optional<MarksPrice> marks_price_;
  /// Of the mesh that is shown; nothing if nobody has asked.
  std::optional<std::vector<WorstPlace>> worst_;
  bool was_known_ = false, is_busy_ = false;
  int revision_ = 0;
};

}  // namespace gradmesh
