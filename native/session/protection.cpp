#include "session/protection.h"

#include <algorithm>

#include "base/error.h"
#include "mesh/face_outline.h"
#include "mesh/faces_under.h"
#include "ops/fix.h"

namespace gradmesh {
namespace {

/// Returns the patches of another mesh that lie under these.
std::vector<Face> faces_there(const Mesh& mesh, const std::vector<Face>& faces, const Mesh& there) {
  std::vector<Face> all;
  for (const Face face : faces) {
    const std::vector<Face> under = faces_under(there, face_outline(mesh, face));
    all.insert(all.end(), under.begin(), under.end());
  }
  return all;
}

}  // namespace

void Protection::protect(const std::vector<Face>& faces, bool is_protected) {
  if (is_protected)
    set_protected(faces, {}, Message("Protect patches: {0}", faces.size()));
  else
    set_protected({}, faces, Message("Protect patches no longer: {0}", faces.size()));
}

void Protection::protect_others(const std::vector<Face>& faces) {
  std::vector<Face> others;
  for (const Face face : shown_.mesh().faces())
    if (std::ranges::find(faces, face) == faces.end()) others.push_back(face);
  set_protected(others, faces, Message("Protect all other patches"));
}

void Protection::set_protected(const std::vector<Face>& fixed, const std::vector<Face>& released,
                               const Message& name) {
  Setting setting = shown_.setting_as(shown_.form());
  Mesh mesh = shown_.mesh(), start = *setting.next->start;
  const std::vector<Face> fixed_there = faces_there(mesh, fixed, start);
  const std::vector<Face> released_there = faces_there(mesh, released, start);
  Journal journal(mesh), journal_there(start);
  set_fixed(journal, released, false);
  set_fixed(journal, fixed, true);
  // What lies under both stays as it is.
  set_fixed(journal_there, released_there, false);
  set_fixed(journal_there, fixed_there, true);
  Basis next = *setting.next;
  next.start = std::make_shared<const Mesh>(std::move(start));
  const bool is_one = setting.basis == setting.next;
  setting.next = std::make_shared<const Basis>(std::move(next));
  if (is_one) setting.basis = setting.next;
  shown_.measure_in(setting);
  shown_.change(shown_.measured(mesh, setting.form), setting, name);
}

void Protection::weigh(const std::vector<Face>& faces, double factor) {
  if (!(factor >= least_weight && factor <= most_weight))
    throw InputError("errors may count a quarter to four times.");
  if (faces.empty())
    throw InputError("there are no patches in which errors could count otherwise.");
  std::vector<WeightedArea> areas = *shown_.setting().weighted;
  areas.push_back({{}, factor});
  for (const Face face : faces) areas.back().shapes.push_back(face_outline(shown_.mesh(), face));
  set_weights(std::move(areas), Message("Let errors count otherwise"));
}

void Protection::weigh_alike() { set_weights({}, Message("Let errors count alike")); }

void Protection::set_weights(std::vector<WeightedArea> areas, const Message& name) {
  // States of the curve by these weights have other meshes.
  Setting setting = shown_.setting_as(shown_.form());
  setting.weighted = std::make_shared<const std::vector<WeightedArea>>(std::move(areas));
  shown_.measure_in(setting);
  shown_.change(shown_.measured(shown_.mesh(), setting.form), setting, name);
}

}  // namespace gradmesh
