#include "service/documents.h"

#include <stdexcept>

namespace gradmesh {

std::uint64_t Documents::add(std::unique_ptr<Document> document) {
  const auto entry = std::make_shared<Entry>();
  entry->document = std::move(document);
  const std::lock_guard lock(mutex_);
  entries_.emplace(++last_, entry);
  return last_;
}

void Documents::remove(std::uint64_t number) {
  const std::lock_guard lock(mutex_);
  entries_.erase(number);
}

std::shared_ptr<Documents::Entry> Documents::find(std::uint64_t number) {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(number);
  if (found == entries_.end())
    throw std::invalid_argument("there is no document " + std::to_string(number) + ".");
  return found->second;
}

Documents::InUse::InUse(Documents& documents, std::vector<std::uint64_t> numbers) {
  for (const std::uint64_t number : numbers) entries_.emplace(number, documents.find(number));
  // In the order of the numbers, so that two calls never wait for each other.
  for (const auto& [number, entry] : entries_) entry->used.lock();
}

Documents::InUse::~InUse() {
  for (const auto& [number, entry] : entries_) entry->used.unlock();
}

}  // namespace gradmesh
