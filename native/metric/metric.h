#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/image.h"

namespace gradmesh {

enum class MetricKind { flip, ssim };

/// How often the errors of a pixel may count. Below a quarter a part is as good as left out, which
/// what is hidden does better; above 4 the errors elsewhere hardly count any more, and the sums of
/// metric/local_mean.h would not be exact.
inline constexpr double least_weight = 0.25, most_weight = 4;

/// Measures the distance of test images to one fixed reference image, per pixel. Where pixels have
/// weights, what all members give as the distance is the distance times the weight of the pixel.
/// The distance of a pixel depends only on the pixels within `reach` of it, and is 0 where none of
/// these differs from the reference: only pixels near a difference are scored, in tiles.
///
/// SSIM is Wang et al. 2004 as `1 - SSIM` (mean of the three channels), up to 2 where the images
/// are anti-correlated; FLIP is the LDR metric of Andersson et al. 2020, up to 1. Both treat a
/// pixel beyond the frame as the nearest one inside. Whatever depends on the reference alone is
/// computed once, by the constructor; the other members may be called concurrently.
class Metric {
 public:
  /// The weight of every pixel of the frame, least_weight to most_weight; null if all are 1.
  using Weights = std::shared_ptr<const Plane>;

  virtual ~Metric() = default;

  /// Writes the distance of every pixel in `window` into `map`, which has the size of the
  /// frame; other pixels of `map` stay as they are. The values are the same for every window
  /// that holds the pixel. Throws std::invalid_argument where the sizes differ.
  void fill_map(const Image& test, Window window, Plane& map) const;

  /// Brings `map`, the distances of `before`, up to date for `test`, which differs from `before` at
  /// most inside `changed`. Returns the change of the map's sum, added in double and in an order
  /// that depends on the images only. Gives up as soon as it is certain that the sum rises by more
  /// than `limit`; then returns some number above `limit`, and `map` is of no further use.
  ///
  /// The images may be parts of the frame. As far as they lie inside the frame, `before` must hold
  /// the pixels of `changed`, `map` those within the reach of `changed`, and `test` those within
  /// twice the reach. Throws std::invalid_argument where they do not. Runs on one thread and takes
  /// no memory once it has been called on windows as large.
  double update_map(const Image& before, const Image& test, Window changed, Plane& map,
                    double limit = std::numeric_limits<double>::infinity()) const {
    return updated(before, test, changed, map, limit, 1);
  }
  /// Does and returns the same on all threads.
  double update_map_in_parallel(const Image& before, const Image& test, Window changed, Plane& map,
                                double limit = std::numeric_limits<double>::infinity()) const;

  const Image& reference() const { return reference_; }

  /// Returns how many pixels away, along each axis, a changed pixel still changes the map.
  int reach() const { return reach_; }

  Plane map(const Image& test) const {
    Plane result(test.width, test.height);
    fill_map(test, test.window(), result);
    return result;
  }

 protected:
  /// Throws std::invalid_argument if the weights are not of the size of the reference.
  Metric(Image reference, int reach, Weights weights);

  /// Calls `body(strip)` in parallel for windows that share the rows of `window` between them, few
  /// enough in each for the filtered rows to stay in the cache.
  static void for_each_strip(Window window, const std::function<void(Window)>& body);

 private:
  /// Writes the distances, without weights, of the pixels of `tile`, which is not empty and lies
  /// inside the frame. `test` covers all pixels of the frame within the reach of the tile.
  virtual void score(const Image& test, Window tile, Plane& map) const = 0;

  Window around(Window window, int by) const {
    return window.grown(by).clipped(reference_.window());
  }
  void score_near_differences(const Image& test, Window window, Plane& map) const;
  /// Returns what update_map does, with so many tiles scored at a time.
  double updated(const Image& before, const Image& test, Window changed, Plane& map, double limit,
                 std::size_t at_once) const;

  Image reference_;
  int reach_;
  Weights weights_;
};

/// A metric as the rest of the program knows it.
struct MetricEntry {
  MetricKind kind;
  /// Name in options and reports: "flip".
  const char* name;
  /// Name in labels of its values: "FLIP".
  const char* label;
  /// The metric's Metric::reach().
  int reach;
  std::unique_ptr<Metric> (*make)(Image reference, Metric::Weights weights);
};

/// Returns all metrics, in the order in which lists show them.
const std::vector<MetricEntry>& all_metrics();

/// Returns the entry of a metric.
const MetricEntry& metric_entry(MetricKind kind);

inline const char* name(MetricKind kind) { return metric_entry(kind).name; }
inline const char* label(MetricKind kind) { return metric_entry(kind).label; }
inline int metric_reach(MetricKind kind) { return metric_entry(kind).reach; }

/// Returns the metric of that name. Throws std::invalid_argument with the names of all metrics.
MetricKind metric_named(const std::string& name);

/// Makes the metric that measures against `reference`, which may have any size, also one smaller
/// than the filters. Throws std::invalid_argument if the weights are of another size.
std::unique_ptr<Metric> make_metric(MetricKind kind, Image reference,
                                    Metric::Weights weights = nullptr);

/// Returns the sum of the map over a window, in double and in a fixed order.
double sum(const Plane& map, Window window);

/// Returns the mean over all pixels, from sum(); 0 for a map without pixels.
double mean(const Plane& map);

}  // namespace gradmesh
