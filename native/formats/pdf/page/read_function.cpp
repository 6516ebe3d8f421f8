#include "formats/pdf/page/read_function.h"

#include "base/clamped_int.h"
#include "base/error.h"
#include "formats/pdf/page/dictionary.h"
#include "formats/pdf/page/stream_bytes.h"

namespace gradmesh {
namespace {

constexpr int deepest_function = 8;

[[noreturn]] void throw_no_function() {
  throw InputError("a function of its colours cannot be read");
}

std::vector<ValueRange> ranges_of(QPDFObjectHandle object) {
  const std::vector<double> numbers = numbers_of(object);
  std::vector<ValueRange> ranges;
  for (std::size_t n = 0; n + 1 < numbers.size(); n += 2)
    ranges.push_back({numbers[n], numbers[n + 1]});
  return ranges;
}

std::vector<double> numbers_or(QPDFObjectHandle object, std::vector<double> otherwise) {
  const std::vector<double> numbers = numbers_of(object);
  return numbers.empty() ? otherwise : numbers;
}

Function sampled(QPDFObjectHandle object) {
  constexpr int most_samples = 1 << 24;
  SampledFunction function;
  function.domain = ranges_of(value_of(object, "/Domain"));
  function.range = ranges_of(value_of(object, "/Range"));
  for (const double size : numbers_of(value_of(object, "/Size")))
    function.size.push_back(clamped_int(size, 0, most_samples));
  function.bits_per_sample =
      clamped_int(number_of(value_of(object, "/BitsPerSample")).value_or(0), 0, 64);
  function.encode = ranges_of(value_of(object, "/Encode"));
  function.decode = ranges_of(value_of(object, "/Decode"));
  if (!object.isStream()) throw_no_function();
  function.samples = stream_bytes(object).bytes;
  return Function(std::move(function));
}

Function exponential(QPDFObjectHandle object) {
  ExponentialFunction function;
  function.domain = ranges_of(value_of(object, "/Domain"));
  function.range = ranges_of(value_of(object, "/Range"));
  function.c0 = numbers_or(value_of(object, "/C0"), {0});
  function.c1 = numbers_or(value_of(object, "/C1"), {1});
  function.exponent = number_of(value_of(object, "/N")).value_or(1);
  return Function(std::move(function));
}

Function calculator(QPDFObjectHandle object) {
  if (!object.isStream()) throw_no_function();
  CalculatorFunction function;
  function.domain = ranges_of(value_of(object, "/Domain"));
  function.range = ranges_of(value_of(object, "/Range"));
  function.program = stream_bytes(object).bytes;
  return Function(function);
}

Function function_within(QPDFObjectHandle object, int depth);

std::vector<Function> all_of(QPDFObjectHandle array, int depth) {
  if (!array.isArray() || array.getArrayNItems() > max_function_values) throw_no_function();
  std::vector<Function> functions;
  for (QPDFObjectHandle each : array.getArrayAsVector())
    functions.push_back(function_within(each, depth + 1));
  return functions;
}

Function stitching(QPDFObjectHandle object, int depth) {
  StitchingFunction function;
  function.domain = ranges_of(value_of(object, "/Domain"));
  function.range = ranges_of(value_of(object, "/Range"));
  function.functions = all_of(value_of(object, "/Functions"), depth);
  function.bounds = numbers_of(value_of(object, "/Bounds"));
  function.encode = ranges_of(value_of(object, "/Encode"));
  return Function(std::move(function));
}

Function function_within(QPDFObjectHandle object, int depth) {
  if (depth > deepest_function) throw_no_function();
  if (object.isArray()) return joined(all_of(object, depth));
  const double type = number_of(value_of(object, "/FunctionType")).value_or(-1);
  if (type == 0) return sampled(object);
  if (type == 2) return exponential(object);
  if (type == 3) return stitching(object, depth);
  if (type == 4) return calculator(object);
  throw_no_function();
}

}  // namespace

Function read_function(QPDFObjectHandle object) { return function_within(object, 0); }

}  // namespace gradmesh
