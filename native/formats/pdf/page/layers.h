#pragma once

#include <map>

#include "formats/pdf/objects/qpdf.h"

namespace gradmesh {

/// The layers of a document, which it calls optional content, as a viewer shows them when it opens
/// it (ISO 32000-1, 8.11).
class Layers {
 public:
  /// All content is shown.
  Layers() = default;
  /// Reads the document's own configuration; what its usage says of viewing comes before that.
  explicit Layers(QPDFObjectHandle catalog);

  /// Returns whether what belongs to a layer, or to a membership of several, is shown. What is
  /// neither is.
  bool shows(QPDFObjectHandle content) const { return shows(content, 0); }

 private:
  bool shows(QPDFObjectHandle content, int depth) const;
  bool shows_membership(QPDFObjectHandle membership, int depth) const;
  bool holds(QPDFObjectHandle expression, int depth) const;
  void set(QPDFObjectHandle layers, bool is_on);
  void set_by_usage(QPDFObjectHandle usages);

  /// Those of which it is not said otherwise are on.
  bool is_on_ = true;
  std::map<QPDFObjGen, bool> known_;
};

}  // namespace gradmesh
