#include <array>
#include <cstdint>
#include <utility>

#include "base/clamped_int.h"
#include "base/error.h"
#include "formats/pdf/bits/bit_reader.h"
#include "formats/pdf/color/function_rule.h"

namespace gradmesh {
namespace {

class SampledRule : public FunctionRule {
 public:
  /// `grid` has been checked, and has Encode and Decode.
  explicit SampledRule(SampledFunction grid)
      : grid_(std::move(grid)),
        largest_(static_cast<double>((std::uint64_t{1} << grid_.bits_per_sample) - 1)) {}

  void evaluate(std::span<const double> in, std::span<double> out) const override;

 private:
  /// Returns the sample with this number, 0 to the largest of its bits. Samples follow each other
  /// without gaps.
  double sample(std::size_t number) const;

  SampledFunction grid_;
  double largest_;
};

double SampledRule::sample(std::size_t number) const {
  const int bits = grid_.bits_per_sample;
  return BitReader(grid_.samples, number * static_cast<std::size_t>(bits)).read(bits).value_or(0);
}

void SampledRule::evaluate(std::span<const double> in, std::span<double> out) const {
  const std::size_t inputs = in.size();
  // Of the cell, for its low and its high side along each input: how many samples that is from the
  // first one, and its weight.
  std::array<std::array<std::size_t, 2>, max_sampled_inputs> steps{};
  std::array<std::array<double, 2>, max_sampled_inputs> weights{};
  std::size_t stride = 1;
  for (std::size_t i = 0; i < inputs; ++i) {
    const int size = grid_.size[i];
    const double place = clipped(interpolated(in[i], grid_.domain[i], grid_.encode[i]),
                                 {0, static_cast<double>(size - 1)});
    const int low = clamped_int(place, 0, std::max(size - 2, 0));
    const int high = std::min(low + 1, size - 1);
    steps[i] = {static_cast<std::size_t>(low) * stride, static_cast<std::size_t>(high) * stride};
    weights[i] = {1 - (place - low), place - low};
    stride *= static_cast<std::size_t>(size);
  }
  std::ranges::fill(out, 0.0);
  for (std::size_t corner = 0; corner < std::size_t{1} << inputs; ++corner) {
    std::size_t number = 0;
    double weight = 1;
    for (std::size_t i = 0; i < inputs; ++i) {
      number += steps[i][corner >> i & 1];
      weight *= weights[i][corner >> i & 1];
    }
    if (weight == 0) continue;
    for (std::size_t k = 0; k < out.size(); ++k) out[k] += weight * sample(number * out.size() + k);
  }
  for (std::size_t k = 0; k < out.size(); ++k)
    out[k] = interpolated(out[k], {0, largest_}, grid_.decode[k]);
}

bool is_sample_size(int bits) {
  constexpr std::array sizes{1, 2, 4, 8, 12, 16, 24, 32};
  return std::ranges::find(sizes, bits) != sizes.end();
}

/// Returns true if there are as many samples as Size says. Their number never overflows: it stays
/// below that of the bits that there are.
bool has_all_samples(const SampledFunction& grid) {
  const std::size_t available =
      grid.samples.size() * 8 / static_cast<std::size_t>(grid.bits_per_sample);
  std::size_t needed = grid.range.size();
  for (const int size : grid.size) {
    if (size < 1 || needed > available / static_cast<std::size_t>(size)) return false;
    needed *= static_cast<std::size_t>(size);
  }
  return needed <= available;
}

}  // namespace

std::shared_ptr<const FunctionRule> sampled_rule(SampledFunction parameters) {
  const std::size_t inputs = parameters.domain.size();
  if (inputs > max_sampled_inputs)
    throw InputError("a function of its shading has too many inputs or values");
  if (!is_sample_size(parameters.bits_per_sample))
    throw InputError("a function of its shading has samples of {0} bits",
                     parameters.bits_per_sample);
  if (parameters.encode.empty())
    for (const int size : parameters.size)
      parameters.encode.push_back({0, static_cast<double>(size) - 1});
  if (parameters.decode.empty()) parameters.decode = parameters.range;
  if (parameters.size.size() != inputs || parameters.encode.size() != inputs ||
      parameters.decode.size() != parameters.range.size())
    throw_unfit_function();
  limit_ranges(parameters.encode);
  limit_ranges(parameters.decode);
  if (!has_all_samples(parameters))
    throw InputError("a function of its shading has fewer samples than it says");
  return std::make_shared<SampledRule>(std::move(parameters));
}

}  // namespace gradmesh
