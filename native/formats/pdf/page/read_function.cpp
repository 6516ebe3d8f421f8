#include "formats/pdf/page/read_function.h"

#include <map>

#include "base/clamped_int.h"
#include "base/error.h"
#include "formats/pdf/objects/dictionary.h"
#include "formats/pdf/objects/stream_bytes.h"

namespace gradmesh {
namespace {

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

/// Reads a function and those within it.
class FunctionReader {
 public:
  /// `depth` is the number of functions around it.
  Function read(QPDFObjectHandle object, int depth);

 private:
  Function read_now(QPDFObjectHandle object, int depth);
  std::vector<Function> all_of(QPDFObjectHandle array, int depth);
  Function stitching(QPDFObjectHandle object, int depth);

  /// Those that are objects of their own: each function of a stranger's file may hold the next one
  /// again and again.
  std::map<QPDFObjGen, Function> read_;
};

Function FunctionReader::read(QPDFObjectHandle object, int depth) {
  if (depth >= max_function_depth) throw_no_function();
  if (!object.isIndirect()) return read_now(object, depth);
  const QPDFObjGen number = object.getObjGen();
  auto found = read_.find(number);
  if (found == read_.end()) found = read_.emplace(number, read_now(object, depth)).first;
  return found->second;
}

Function FunctionReader::read_now(QPDFObjectHandle object, int depth) {
  if (object.isArray()) return joined(all_of(object, depth));
  const double type = number_of(value_of(object, "/FunctionType")).value_or(-1);
  if (type == 0) return sampled(object);
  if (type == 2) return exponential(object);
  if (type == 3) return stitching(object, depth);
  if (type == 4) return calculator(object);
  throw_no_function();
}

std::vector<Function> FunctionReader::all_of(QPDFObjectHandle array, int depth) {
  // More than a gradient has stops.
  constexpr int most_functions = 4096;
  if (!array.isArray() || array.getArrayNItems() > most_functions) throw_no_function();
  std::vector<Function> functions;
  for (QPDFObjectHandle each : array.getArrayAsVector()) functions.push_back(read(each, depth + 1));
  return functions;
}

Function FunctionReader::stitching(QPDFObjectHandle object, int depth) {
  StitchingFunction function;
  function.domain = ranges_of(value_of(object, "/Domain"));
  function.range = ranges_of(value_of(object, "/Range"));
  function.functions = all_of(value_of(object, "/Functions"), depth);
  function.bounds = numbers_of(value_of(object, "/Bounds"));
  function.encode = ranges_of(value_of(object, "/Encode"));
  return Function(std::move(function));
}

}  // namespace

Function read_function(QPDFObjectHandle object) { return FunctionReader().read(object, 0); }

}  // namespace gradmesh
