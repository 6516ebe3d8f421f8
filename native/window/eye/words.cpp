#include "window/eye/words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gradmesh {
namespace {

std::string formatted(const char* format, int decimals, double number) {
  char text[64];
  std::snprintf(text, sizeof text, format, decimals, number);
  return text;
}

}  // namespace

std::string fixed(double number, int decimals) { return formatted("%.*f", decimals, number); }

std::string signed_fixed(double number, int decimals) {
  return formatted("%+.*f", decimals, number);
}

std::string short_error(double error) {
  if (!(error > 0)) return "0";
  const int decimals = std::clamp(1 - int(std::floor(std::log10(error))), 0, 12);
  std::string text = fixed(error, decimals);
  if (decimals == 0) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::vector<Message> words_of_mesh(const Eye& eye) {
  const Session& session = eye.session();
  const Candidate& now = session.now();
  const MeshCounts counts = now.counts(), before = session.start().counts();
  const int objects = eye.editing().objects();
  const int fixed_patches = now.mesh.fixed_face_count();
  const Message handles = Message("{0} of {1} handles", counts.handles, before.handles);
  const Message patches = Message("{0} of {1} patches", counts.patches, before.patches);
  return {objects > 1 ? Message("{0}, {1} objects", handles, objects) : handles,
          fixed_patches ? Message("{0}, {1} protected", patches, fixed_patches) : patches,
          Message("error {0}, in small parts up to {1}", fixed(now.error, 4),
                  fixed(now.local_error, 3))};
}

Message words_of_proposal(const Eye& eye) {
  const Candidate& written = eye.session().proposal()->written;
  const MeshCounts counts = written.counts();
  return Message("A click: {0} handles, {1} patches, error {2} ({3})", counts.handles,
                 counts.patches, fixed(written.error, 4),
                 signed_fixed(written.error - eye.session().now().error, 4));
}

Message words_of_undo(const Session& session) {
  if (!session.undo_name()) return Message("Nothing to take back");
  return Message("Take back: {0} (Ctrl+Z)", *session.undo_name());
}

Message words_of_redo(const Session& session) {
  if (!session.redo_name()) return Message("Nothing to make again");
  return Message("Make again: {0} (Ctrl+Shift+Z)", *session.redo_name());
}

Message words_of_regions(const Eye& eye) {
  if (!eye.patch().valid()) return Message("Point at a patch, or mark one, to see its regions.");
  const std::vector<RegionPrice> all = eye.regions();
  if (std::size_t(eye.looks.region) >= all.size())
    return Message("No region around this patch keeps to the error of Balanced.");
  const RegionPrice& region = all[std::size_t(eye.looks.region)];
  // Rows and columns have a meaning only where no T-junction is inside.
  const bool is_grid = region.size() == region.region.size();
  const Message size = is_grid ? Message("{0} × {1}", region.region.rows, region.region.columns)
                               : Message("{0} patches", region.size());
  return Message("Region {0} of {1}: {2}, error {3}", eye.looks.region + 1, all.size(), size,
                 signed_fixed(region.error, 4));
}

Message words_of_parts(const Analysis& analysis) {
  return Message("Parts: {0}, along edges that cost more than {1}", analysis.parts.parts.size(),
                 short_error(analysis.limit));
}

}  // namespace gradmesh
