#include <array>
#include <functional>
#include <stdexcept>

#include "base/error.h"
#include "formats/svg/values/color.h"
#include "service/functions.h"
#include "service/results.h"
#include "service/sessions.h"

namespace gradmesh {
namespace {

/// Where a person points, and what for.
struct Pointing {
  glm::dvec2 place;
  double reach;
  Affine to_pixels;
};

/// Works out an edit at a place in the patch that lies there.
using Propose = void (*)(const Call& call, Session& session, const Pointed& pointed);

template <HandEdit edit>
void propose_hand_edit(const Call&, Session& session, const Pointed& pointed) {
  session.hands().propose(pointed, edit);
}

void propose_color(const Call& call, Session& session, const Pointed& pointed) {
  const std::string text = call.get<std::string>("color");
  const auto color = parse_color(text);
  if (!color) throw std::invalid_argument("'" + text + "' is no colour, as SVG knows them.");
  session.hands().propose_color(pointed, *color, call.get("sharp", false));
}

struct EditEntry {
  const char* name;
  Propose propose;
  /// What has to be there for anything to be done; null: the patch alone.
  Halfedge Pointed::*needs;
};

const std::array<EditEntry, 8> edits_in_patches = {{
    {"merge", propose_hand_edit<HandEdit::merge>, &Pointed::edge},
    {"rows", propose_hand_edit<HandEdit::split_rows>, nullptr},
    {"columns", propose_hand_edit<HandEdit::split_columns>, nullptr},
    {"both", propose_hand_edit<HandEdit::split_both>, nullptr},
    {"straight", [](const Call&, Session& s, const Pointed& p) { s.hands().propose_straight(p); },
     &Pointed::side},
    {"curve", [](const Call&, Session& s, const Pointed& p) { s.hands().propose_curve(p); },
     &Pointed::side},
    {"color", propose_color, &Pointed::corner},
    {"join", [](const Call&, Session& s, const Pointed& p) { s.hands().propose_joined(p); },
     &Pointed::corner},
}};

const EditEntry& edit_named(const std::string& wanted) {
  std::string known;
  for (const EditEntry& entry : edits_in_patches) {
    if (wanted == entry.name) return entry;
    known += entry.name + std::string(", ");
  }
  throw std::invalid_argument("edits are " + known + "and move, not '" + wanted + "'.");
}

/// Does what works out an edit. Returns its counts, or why it cannot be made.
Json proposed(Session& session, const std::function<void()>& propose) {
  try {
    propose();
    const Candidate& written = session.hands().proposal()->written;
    return counts_json(written, written.form.object_count());
  } catch (const InputError& why_not) {
    return {{"why_not", message_json(why_not.message())}};
  }
}

Json point_to_move(const Call& call, Session& session, const Pointing& pointing) {
  const auto grip = grip_at(session.mesh(), pointing.to_pixels, pointing.place, pointing.reach);
  if (!grip) return nullptr;
  const glm::dvec2 to(call.get<double>("to_x"), call.get<double>("to_y"));
  return proposed(session, [&] {
    session.hands().propose_move(*grip, pointing.to_pixels.inverse().point(to));
  });
}

}  // namespace

Json point_at(const Call& call) {
  Session& s = session(call);
  s.hands().set_fits(call.get("fits", true));
  s.hands().forget_proposal();
  const Pointing pointing{{call.get<double>("pixel_x"), call.get<double>("pixel_y")},
                          call.get("reach", 8.0),
                          to_pixels(call)};
  const std::string name = call.get<std::string>("edit");
  if (name == "move") return point_to_move(call, s, pointing);
  const EditEntry& edit = edit_named(name);
  const auto pointed = pointed_at(s.mesh(), pointing.to_pixels, pointing.place, pointing.reach);
  if (!pointed) return nullptr;
  Json json{{"face", pointed->face.value}};
  if (edit.needs && !((*pointed).*edit.needs).valid()) return json;
  json.update(proposed(s, [&] { edit.propose(call, s, *pointed); }));
  return json;
}

Json propose_merge(const Call& call) {
  Session& s = session(call);
  s.hands().set_fits(call.get("fits", true));
  s.hands().forget_proposal();
  const std::vector<Face> patches = faces(call, "patches");
  return proposed(s, [&] { s.hands().propose_merge(patches); });
}

Json make_edit(const Call& call) {
  session(call).hands().make();
  return status_json(editing(call));
}

Json merge_marked(const Call& call) {
  Session& s = session(call);
  s.hands().set_fits(call.get("fits", true));
  s.hands().propose_merge(faces(call, "patches"));
  return make_edit(call);
}

}  // namespace gradmesh
