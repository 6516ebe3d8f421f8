#include "metric/differences.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "base/per_thread.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "metric/differences.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "metric/filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gradmesh::HWY_NAMESPACE {
namespace {

/// Sets the bytes of the columns of a window in which any pixel differs to a value other than 0,
/// and those of the others to 0.
void mark_columns(const Image& a, const Image& b, Window window, std::uint8_t* differing) {
  const std::ptrdiff_t stride_a = a.width, stride_b = b.width;
  const hn::ScalableTag<std::uint8_t> bytes;
  for_each_vector(bytes, window.width(), [&](auto d, int i) {
    auto any = hn::Zero(d);
    for (int c = 0; c < 3; ++c) {
      const std::uint8_t* in_a = a.at(window.x0 + i, window.y0, c);
      const std::uint8_t* in_b = b.at(window.x0 + i, window.y0, c);
      for (int y = window.y0; y < window.y1; ++y, in_a += stride_a, in_b += stride_b)
        any = hn::Or(any, hn::Xor(hn::LoadU(d, in_a), hn::LoadU(d, in_b)));
    }
    hn::StoreU(any, d, differing + i);
  });
}

}  // namespace
}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradmesh {
namespace {

HWY_EXPORT(mark_columns);

constexpr int largest_width = 768;
/// The largest gap between two tiles, in columns, that costs less to score than the margins of two
/// separate tiles.
constexpr int smallest_gap = 16;

int pieces(int length, int largest) { return (length + largest - 1) / largest; }

/// Finds the tiles of one strip of rows.
class StripSearch {
 public:
  StripSearch(const Image& a, const Image& b, Window searched, Window strip, int reach)
      : a_(a), b_(b), strip_(strip), reach_(reach), seen_(strip.grown(reach).clipped(searched)) {}

  void append_to(std::vector<Window>& tiles) const {
    if (seen_.empty()) return;
    auto& differing = per_thread<std::vector<std::uint8_t>, struct Differing>();
    differing.resize(seen_.width());
    HWY_DYNAMIC_DISPATCH(mark_columns)(a_, b_, seen_, differing.data());
    int begin = 0, end = 0;
    for (int x = seen_.x0; x < seen_.x1; ++x) {
      if (differing[x - seen_.x0] == 0) continue;
      if (x - reach_ > end + smallest_gap || begin == end) {
        append_run(begin, end, tiles);
        begin = x - reach_;
      }
      end = x + 1 + reach_;
    }
    append_run(begin, end, tiles);
  }

 private:
  /// Appends tiles for columns [begin, end), which are cut where they are more than
  /// `largest_width`.
  void append_run(int begin, int end, std::vector<Window>& tiles) const {
    begin = std::max(begin, strip_.x0);
    end = std::min(end, strip_.x1);
    const int width = end - begin, count = pieces(width, largest_width);
    for (int i = 0; i < count; ++i)
      append_trimmed(begin + width * i / count, begin + width * (i + 1) / count, tiles);
  }

  /// Appends a tile for columns [begin, end) without the rows at the top and the bottom that no
  /// difference reaches.
  void append_trimmed(int begin, int end, std::vector<Window>& tiles) const {
    const int x0 = std::max(begin - reach_, seen_.x0), x1 = std::min(end + reach_, seen_.x1);
    int first = seen_.y0, last = seen_.y1 - 1;
    while (first <= last && equal(first, x0, x1)) ++first;
    while (first <= last && equal(last, x0, x1)) --last;
    const Window tile = {begin, std::max(first - reach_, strip_.y0), end,
                         std::min(last + 1 + reach_, strip_.y1)};
    if (first <= last) tiles.push_back(tile);
  }

  bool equal(int y, int x0, int x1) const {
    for (int c = 0; c < 3; ++c)
      if (std::memcmp(a_.at(x0, y, c), b_.at(x0, y, c), x1 - x0) != 0) return false;
    return true;
  }

  const Image &a_, &b_;
  Window strip_;
  int reach_;
  Window seen_;  ///< Where differences are looked for.
};

}  // namespace

void append_tiles_near_differences(const Image& a, const Image& b, Window searched, Window window,
                                   int reach, int largest_height, std::vector<Window>& tiles) {
  const int height = window.height(), count = pieces(height, largest_height);
  for (int i = 0; i < count; ++i) {
    const Window strip = {window.x0, window.y0 + height * i / count, window.x1,
                          window.y0 + height * (i + 1) / count};
    StripSearch(a, b, searched, strip, reach).append_to(tiles);
  }
}

}  // namespace gradmesh
#endif  // HWY_ONCE
