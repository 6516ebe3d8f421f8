#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/progress.h"
#include "service/arguments.h"
#include "service/documents.h"

namespace gradmesh {

/// Asks the caller something during a call and returns the answer (docs/reference/helper.md).
/// Called on the thread of the call.
using Ask = std::function<Json(const Json& question)>;

/// Thrown by an Ask whose caller gives the call up. No std::exception, so that nothing on the way
/// takes it for a fault.
struct GivenUp {};

/// A call of one function.
class Call {
 public:
  /// Takes the documents that the arguments name into use. Throws WrongType and
  /// std::invalid_argument if they name none.
  Call(Documents& documents, const Json& arguments, const Ask& ask)
      : all_(documents), arguments_(arguments), ask_(ask), used_(documents, named()) {}

  template <class T>
  T get(const std::string& name) const {
    return arguments_.get<T>(name);
  }
  /// Returns an argument, or `otherwise` if it is null.
  template <class T>
  T get(const std::string& name, T otherwise) const {
    return get<std::optional<T>>(name).value_or(std::move(otherwise));
  }
  /// Returns true if the argument is not null.
  bool has(const std::string& name) const { return arguments_.has(name); }

  /// Returns the document that an argument names, by its number.
  Document& document(const std::string& name = "document") const {
    return used_[get<std::uint64_t>(name)];
  }
  /// Returns the sessions over meshes of that document.
  Documents::Sessions& sessions() const { return used_.sessions(get<std::uint64_t>("document")); }
  /// Returns null if the argument is null.
  const Document* optional_document(const std::string& name) const {
    const auto number = get<std::optional<std::uint64_t>>(name);
    return number ? &used_[*number] : nullptr;
  }
  /// Returns the number of a new document.
  std::uint64_t add(std::unique_ptr<Document> document) const {
    return all_.add(std::move(document));
  }

  /// Returns what tells the caller of a run's progress, and asks whether it goes on.
  ProgressCallback progress() const;
  /// Returns what shows the caller pictures on the way, if it has asked for them.
  std::function<void(const Image&)> show() const;
  /// Returns what tells the caller that a device failed, and why.
  std::function<void(const std::string&)> device_lost() const;

 private:
  /// Returns the numbers of the documents that the arguments name.
  std::vector<std::uint64_t> named() const;

  Documents& all_;
  Arguments arguments_;
  const Ask& ask_;
  Documents::InUse used_;
};

}  // namespace gradmesh
