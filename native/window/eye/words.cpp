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

/// Returns a number, with a point, as a language writes it.
Message number(const std::string& text) {
  const std::size_t point = text.find('.');
  if (point == std::string::npos) return Message("{0}", text);
  return Message("{0}.{1}", text.substr(0, point), text.substr(point + 1));
}

bool is_seen(double number, int decimals) {
  return formatted("%.*f", decimals, std::abs(number)) != formatted("%.*f", decimals, 0);
}

}  // namespace

Message fixed(double value, int decimals) {
  return number(formatted("%.*f", decimals, is_seen(value, decimals) ? value : 0));
}

Message signed_fixed(double value, int decimals) {
  return is_seen(value, decimals) ? number(formatted("%+.*f", decimals, value))
                                  : fixed(0, decimals);
}

Message short_error(double error) {
  if (!(error > 0)) return number("0");
  const int decimals = std::clamp(1 - int(std::floor(std::log10(error))), 0, 12);
  std::string text = formatted("%.*f", decimals, error);
  if (decimals == 0) return number(text);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return number(text);
}

Message error_of(double error, int decimals) {
  return error > 1 ? Message("1 or more") : fixed(error, decimals);
}

Message error_after(double error, double before) {
  constexpr int decimals = 4;
  const Message now = error_of(error, decimals);
  if (error > 1 || !is_seen(error - before, decimals)) return now;
  return Message("{0} ({1})", now, signed_fixed(error - before, decimals));
}

std::vector<Message> words_of_mesh(const Eye& eye) {
  const Session& session = eye.session();
  const Candidate& now = session.shown().now();
  const MeshCounts counts = now.counts(), before = session.shown().start().counts();
  const int objects = eye.editing().objects();
  const int fixed_patches = now.mesh.fixed_face_count();
  // Blocks may have more of both than the mesh as it was.
  const Message handles = counts.handles > before.handles
                              ? Message("{0} handles, {1} before", counts.handles, before.handles)
                              : Message("{0} of {1} handles", counts.handles, before.handles);
  const Message patches = counts.patches > before.patches
                              ? Message("{0} patches, {1} before", counts.patches, before.patches)
                              : Message("{0} of {1} patches", counts.patches, before.patches);
  return {objects > 1 ? Message("{0}, {1} objects", handles, objects) : handles,
          fixed_patches ? Message("{0}, {1} protected", patches, fixed_patches) : patches,
          Message("error {0}, in small parts up to {1}", error_of(now.error, 4),
                  error_of(now.local_error, 3))};
}

Message words_of_proposal(const Eye& eye) {
  const Candidate& written = eye.session().hands().proposal()->written;
  const MeshCounts counts = written.counts();
  return Message("A click: {0} handles, {1} patches, error {2}", counts.handles, counts.patches,
                 error_after(written.error, eye.session().shown().now().error));
}

Message words_of_undo(const Session& session) {
  if (!session.history().undo_name()) return Message("Nothing to take back");
  return Message("Take back: {0} (Ctrl+Z)", *session.history().undo_name());
}

Message words_of_redo(const Session& session) {
  if (!session.history().redo_name()) return Message("Nothing to make again");
  return Message("Make again: {0} (Ctrl+Shift+Z)", *session.history().redo_name());
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
