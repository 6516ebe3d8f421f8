#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gradmesh {

class FunctionRule;

/// The numbers from `low` to `high`, both included: a pair of Domain, Range, Encode or Decode.
struct ValueRange {
  double low = 0;
  double high = 1;
  bool operator==(const ValueRange&) const = default;
};

/// The largest number that a PDF holds (ISO 32000-1, Annex C); larger ones are clamped to it.
inline constexpr double max_pdf_number = 3.403e38;
/// The most inputs and outputs of a function, which is the most components of a DeviceN space.
inline constexpr int max_function_values = 32;
/// The most functions within each other, the outermost included: more than any producer writes, few
/// enough for the stack.
inline constexpr int max_function_depth = 16;
/// The most inputs of a sampled function: 2^inputs samples are blended.
inline constexpr int max_sampled_inputs = 8;

/// Samples on a regular grid (ISO 32000-1, 7.10.2), between which is interpolated linearly,
/// whatever Order says.
struct SampledFunction {
  std::vector<ValueRange> domain;
  std::vector<ValueRange> range;
  /// The number of samples along each input.
  std::vector<int> size;
  /// 1, 2, 4, 8, 12, 16, 24 or 32.
  int bits_per_sample = 8;
  /// One for each input; none stands for 0 to size - 1.
  std::vector<ValueRange> encode;
  /// One for each output; none stands for `range`.
  std::vector<ValueRange> decode;
  /// The decoded bytes of the stream: outputs of one sample side by side, the first input fastest.
  std::string samples;
};

/// c0 + x^exponent (c1 - c0) (ISO 32000-1, 7.10.3).
struct ExponentialFunction {
  std::vector<ValueRange> domain;
  /// One for each output, or none.
  std::vector<ValueRange> range;
  std::vector<double> c0{0.0};
  std::vector<double> c1{1.0};
  double exponent = 1;
};

class Function;

/// Functions of one input, each for a part of the domain (ISO 32000-1, 7.10.4).
struct StitchingFunction {
  std::vector<ValueRange> domain;
  /// One for each output, or none.
  std::vector<ValueRange> range;
  std::vector<Function> functions;
  /// Where the parts meet, ascending, one fewer than functions.
  std::vector<double> bounds;
  /// To what the ends of each part are mapped: `low` may be above `high`.
  std::vector<ValueRange> encode;
};

/// A program in a subset of PostScript (ISO 32000-1, 7.10.5).
struct CalculatorFunction {
  std::vector<ValueRange> domain;
  std::vector<ValueRange> range;
  std::string program;
};

/// A Function of a PDF (ISO 32000-1, 7.10), which maps numbers to numbers. It is immutable, cheap
/// to copy, and may be called from several threads.
///
/// The constructors throw an InputError if parameters do not fit together. A call never fails:
/// inputs are clipped to Domain and outputs to Range, and without Range to `max_pdf_number`.
class Function {
 public:
  explicit Function(SampledFunction parameters);
  explicit Function(ExponentialFunction parameters);
  explicit Function(StitchingFunction parameters);
  explicit Function(const CalculatorFunction& parameters);

  int inputs() const { return static_cast<int>(domain_.size()); }
  int outputs() const { return outputs_; }

  /// Returns the outputs, all of them finite. Inputs that are missing or no numbers count as the
  /// least of their Domain; inputs in excess are ignored.
  std::vector<double> operator()(std::span<const double> in) const;

 private:
  friend Function joined(std::vector<Function> functions);
  Function(std::vector<ValueRange> domain, std::vector<ValueRange> range,
           std::shared_ptr<const FunctionRule> rule, int outputs, int depth);
  static int depth_of(const std::vector<Function>& functions);

  std::vector<ValueRange> domain_;
  std::vector<ValueRange> range_;
  std::shared_ptr<const FunctionRule> rule_;
  int outputs_;
  /// How many functions lie in each other, this one included.
  int depth_;
};

/// Returns a function with the outputs of all these, which have one output each and the same number
/// of inputs: the array of functions of a shading (ISO 32000-1, 8.7.4.5). Each keeps its own
/// Domain. Throws an InputError if they do not fit together.
Function joined(std::vector<Function> functions);

}  // namespace gradmesh
