#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "app/document/document.h"
#include "app/editing/editing.h"

namespace gradmesh {

/// The documents that a caller has read, each under a number. Several threads may use it.
class Documents {
 public:
  using Sessions = std::map<std::string, std::unique_ptr<Editing>>;

  /// Returns the number of the document from now on.
  std::uint64_t add(std::unique_ptr<Document> document);
  /// Forgets a document, if there is one of that number.
  void remove(std::uint64_t number);

 private:
  struct Entry {
    std::unique_ptr<Document> document;
    /// Those over meshes of the document, by the ids of the meshes.
    Sessions sessions;
    /// Held while a call uses the document. A call inside of a call comes from the same thread.
    std::recursive_mutex used;
  };
  /// Throws std::invalid_argument if there is no document of that number.
  std::shared_ptr<Entry> find(std::uint64_t number);

  std::mutex mutex_;
  std::uint64_t last_ = 0;
  std::map<std::uint64_t, std::shared_ptr<Entry>> entries_;

 public:
  /// Documents that are in use by one call alone as long as this lives.
  class InUse {
   public:
    /// Waits until no other thread uses one of them. Throws std::invalid_argument if there is no
    /// document of one of these numbers.
    InUse(Documents& documents, std::vector<std::uint64_t> numbers);
    InUse(const InUse&) = delete;
    InUse& operator=(const InUse&) = delete;
    ~InUse();

    /// Returns one of these documents.
    Document& operator[](std::uint64_t number) const { return *entries_.at(number)->document; }
    /// Returns the sessions over meshes of one of these documents.
    Sessions& sessions(std::uint64_t number) const { return entries_.at(number)->sessions; }

   private:
    std::map<std::uint64_t, std::shared_ptr<Entry>> entries_;
  };
};

}  // namespace gradmesh
