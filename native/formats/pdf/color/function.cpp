#include "formats/pdf/color/function.h"

#include <utility>

#include "base/error.h"
#include "formats/pdf/color/function_rule.h"

namespace gradmesh {
namespace {

/// Makes PDF numbers of the ends of all ranges. Throws an InputError if one is empty.
void check_order(std::vector<ValueRange>& ranges) {
  limit_ranges(ranges);
  for (const ValueRange& range : ranges)
    if (range.low > range.high) throw_unfit_function();
}

/// Throws an InputError if a function cannot have this number of inputs or outputs.
void check_count(std::size_t count) {
  if (count == 0) throw InputError("a function of its shading has no values");
  if (count > max_function_values)
    throw InputError("a function of its shading has too many inputs or values");
}

/// Checks what all types have in common, and returns `outputs` as an int.
int checked_outputs(std::vector<ValueRange>& domain, std::vector<ValueRange>& range,
                    std::size_t outputs) {
  check_count(domain.size());
  check_count(outputs);
  if (!range.empty() && range.size() != outputs) throw_unfit_function();
  check_order(domain);
  check_order(range);
  return static_cast<int>(outputs);
}

class ExponentialRule : public FunctionRule {
 public:
  explicit ExponentialRule(const ExponentialFunction& parameters)
      : c0_(parameters.c0), c1_(parameters.c1), exponent_(pdf_number(parameters.exponent)) {
    for (double& c : c0_) c = pdf_number(c);
    for (double& c : c1_) c = pdf_number(c);
  }

  void evaluate(std::span<const double> in, std::span<double> out) const override {
    // What has no power, such as a negative number with a fraction as exponent, counts as 0.
    const double power = pdf_number(std::pow(in[0], exponent_));
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = c0_[i] + power * (c1_[i] - c0_[i]);
  }

 private:
  std::vector<double> c0_;
  std::vector<double> c1_;
  double exponent_;
};

class StitchingRule : public FunctionRule {
 public:
  /// `parameters` have been checked; Domain has one range.
  explicit StitchingRule(StitchingFunction parameters) : parts_(std::move(parameters)) {}

  void evaluate(std::span<const double> in, std::span<double> out) const override {
    const std::vector<double>& bounds = parts_.bounds;
    // Each part holds its lower bound; the last holds the end of the domain as well.
    const auto above = std::upper_bound(bounds.begin(), bounds.end(), in[0]);
    const auto part = static_cast<std::size_t>(above - bounds.begin());
    const ValueRange within{above == bounds.begin() ? parts_.domain[0].low : *(above - 1),
                            above == bounds.end() ? parts_.domain[0].high : *above};
    const double encoded = interpolated(in[0], within, parts_.encode[part]);
    std::ranges::copy(parts_.functions[part](std::span(&encoded, 1)), out.begin());
  }

 private:
  StitchingFunction parts_;
};

class JoinedRule : public FunctionRule {
 public:
  explicit JoinedRule(std::vector<Function> functions) : functions_(std::move(functions)) {}

  void evaluate(std::span<const double> in, std::span<double> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = functions_[i](in)[0];
  }

 private:
  std::vector<Function> functions_;
};

void check_stitching(StitchingFunction& parameters) {
  const std::size_t count = parameters.functions.size();
  if (parameters.domain.size() != 1 || parameters.bounds.size() + 1 != count ||
      parameters.encode.size() != count)
    throw_unfit_function();
  for (const Function& function : parameters.functions)
    if (function.inputs() != 1 || function.outputs() != parameters.functions[0].outputs())
      throw_unfit_function();
  limit_ranges(parameters.encode);
  double last = parameters.domain[0].low;
  for (double& bound : parameters.bounds) {
    bound = pdf_number(bound);
    if (bound < last || bound > parameters.domain[0].high) throw_unfit_function();
    last = bound;
  }
}

}  // namespace

void throw_unfit_function() {
  throw InputError("a function of its shading has parts that do not fit together");
}

Function::Function(std::vector<ValueRange> domain, std::vector<ValueRange> range,
                   std::shared_ptr<const FunctionRule> rule, int outputs, int depth)
    : domain_(std::move(domain)),
      range_(std::move(range)),
      rule_(std::move(rule)),
      outputs_(outputs),
      depth_(depth) {
  if (depth > max_function_depth)
    throw InputError("a function of its shading has too many functions within each other");
}

Function::Function(SampledFunction parameters)
    : outputs_(checked_outputs(parameters.domain, parameters.range, parameters.range.size())),
      depth_(1) {
  domain_ = parameters.domain;
  range_ = parameters.range;
  rule_ = sampled_rule(std::move(parameters));
}

Function::Function(ExponentialFunction parameters)
    : outputs_(checked_outputs(parameters.domain, parameters.range, parameters.c0.size())),
      depth_(1) {
  if (parameters.domain.size() != 1 || parameters.c1.size() != parameters.c0.size())
    throw_unfit_function();
  domain_ = parameters.domain;
  range_ = parameters.range;
  rule_ = std::make_shared<ExponentialRule>(parameters);
}

Function::Function(StitchingFunction parameters)
    : Function(parameters.domain, parameters.range, nullptr,
               parameters.functions.empty() ? 0 : parameters.functions[0].outputs(),
               1 + depth_of(parameters.functions)) {
  checked_outputs(domain_, range_, static_cast<std::size_t>(outputs_));
  parameters.domain = domain_;
  check_stitching(parameters);
  rule_ = std::make_shared<StitchingRule>(std::move(parameters));
}

Function::Function(const CalculatorFunction& parameters)
    : domain_(parameters.domain),
      range_(parameters.range),
      rule_(calculator_rule(parameters.program)),
      outputs_(checked_outputs(domain_, range_, range_.size())),
      depth_(1) {}

int Function::depth_of(const std::vector<Function>& functions) {
  int depth = 0;
  for (const Function& function : functions) depth = std::max(depth, function.depth_);
  return depth;
}

std::vector<double> Function::operator()(std::span<const double> in) const {
  std::vector<double> within(domain_.size());
  for (std::size_t i = 0; i < within.size(); ++i)
    within[i] = i < in.size() ? clipped(in[i], domain_[i]) : domain_[i].low;
  std::vector<double> out(static_cast<std::size_t>(outputs_));
  rule_->evaluate(within, out);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = range_.empty() ? pdf_number(out[i]) : clipped(out[i], range_[i]);
  return out;
}

Function joined(std::vector<Function> functions) {
  check_count(functions.size());
  for (const Function& function : functions)
    if (function.outputs() != 1 || function.inputs() != functions[0].inputs())
      throw_unfit_function();
  // Each function clips to its own Domain.
  const std::vector<ValueRange> domain(functions[0].domain_.size(),
                                       {-max_pdf_number, max_pdf_number});
  const auto outputs = static_cast<int>(functions.size());
  const int depth = 1 + Function::depth_of(functions);
  return Function(domain, {}, std::make_shared<JoinedRule>(std::move(functions)), outputs, depth);
}

}  // namespace gradmesh
