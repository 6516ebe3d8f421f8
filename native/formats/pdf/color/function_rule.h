#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "formats/pdf/color/function.h"

namespace gradmesh {

/// How a function finds its outputs, between clipping to Domain and clipping to Range.
class FunctionRule {
 public:
  virtual ~FunctionRule() = default;
  /// Sets all of `out`. `in` are finite numbers within Domain; `out` may become any numbers.
  virtual void evaluate(std::span<const double> in, std::span<double> out) const = 0;
};

/// Returns the rule of a sampled function, whose Domain and Range have been checked.
std::shared_ptr<const FunctionRule> sampled_rule(SampledFunction parameters);
/// Returns the rule of a program. Throws an InputError if it cannot be parsed.
std::shared_ptr<const FunctionRule> calculator_rule(std::string_view program);

/// Returns the number within what a PDF holds; 0 for what is no number. Products and sums of a few
/// of these are finite.
inline double pdf_number(double x) {
  return std::isnan(x) ? 0 : std::clamp(x, -max_pdf_number, max_pdf_number);
}

/// Returns the number within the range, which is not empty; its least for what is no number.
inline double clipped(double x, const ValueRange& range) {
  if (!(x > range.low)) return range.low;
  return std::min(x, range.high);
}

/// Returns where `x` comes to lie when `from` is stretched to `to` (ISO 32000-1, 7.10.2,
/// Interpolate). If `from` is one number, all of it comes to the beginning of `to`.
inline double interpolated(double x, const ValueRange& from, const ValueRange& to) {
  const double width = from.high - from.low;
  return width > 0 ? to.low + (x - from.low) / width * (to.high - to.low) : to.low;
}

/// Throws an InputError that says that parameters of a function do not fit together.
[[noreturn]] void throw_unfit_function();

/// Makes PDF numbers of the ends of all ranges. They may be in any order, as those of Encode.
inline void limit_ranges(std::vector<ValueRange>& ranges) {
  for (ValueRange& range : ranges) range = {pdf_number(range.low), pdf_number(range.high)};
}

}  // namespace gradmesh
