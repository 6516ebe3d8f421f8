#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gradmesh {

/// A list of whole numbers, to which numbers are appended or from which numbers are taken. Both are
/// done by the same function, so that what writes numbers also reads them. A number takes a byte
/// for each seven bits, the sign being the lowest, so that numbers near zero take one byte.
class Numbers {
 public:
  /// Makes an empty list, to which code() appends.
  Numbers() = default;
  /// Takes a list from the front of `bytes`, which must outlive it. code() takes from the list.
  static Numbers take_from(std::string_view& bytes);
  /// Appends the list to `bytes`, its length first.
  void append_to(std::string& bytes) const;

  bool is_read() const { return is_read_; }
  /// Returns true if all numbers were taken, and no more than these.
  bool is_exhausted() const { return rest_.empty() && has_sufficed_; }

  /// Appends the number and returns it, or returns the next number whatever `number` is; 0 after
  /// the last.
  std::int64_t code(std::int64_t number);

 private:
  std::string written_;
  std::string_view rest_;
  bool is_read_ = false, has_sufficed_ = true;
};

}  // namespace gradmesh
