#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "base/message.h"

namespace gradmesh {

/// The sentences of a language, as gettext's msgfmt writes them (a .mo file).
class Catalogue {
 public:
  /// Bytes that are no catalogue have no sentences.
  explicit Catalogue(std::string_view bytes);

  /// Returns the sentence in the language, or `text` itself where there is none.
  std::string translated(const std::string& text) const;

 private:
  std::unordered_map<std::string, std::string> sentences_;
};

/// Returns the translation into the first of these languages that there is, such as "de"; into
/// English if there is none, or if that comes first.
Translation translation_into(const std::vector<std::string>& languages);

}  // namespace gradmesh
