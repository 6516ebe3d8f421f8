#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/error.h"
#include "formats/pdf/color/function.h"
#include "pdf_numbers.h"

namespace gradmesh {
namespace {

ExponentialFunction line(Numbers from, Numbers to) { return {{{0, 1}}, {}, from, to, 1}; }

/// 0 1 2 3 4 5 along two inputs, three by two, in bytes.
SampledFunction six_samples() {
  return {{{0, 1}, {0, 1}}, {{0, 255}}, {3, 2}, 8, {}, {}, std::string("\0\1\2\3\4\5", 6)};
}

TEST(PdfFunction, samples_are_blended) {
  const Function function(six_samples());
  EXPECT_EQ(function.inputs(), 2);
  EXPECT_EQ(function.outputs(), 1);
  // The first input varies fastest: the samples are 2 x + 3 y.
  expect_numbers(function(Numbers{0, 0}), {0});
  expect_numbers(function(Numbers{1, 0}), {2});
  expect_numbers(function(Numbers{0, 1}), {3});
  expect_numbers(function(Numbers{1, 1}), {5});
  expect_numbers(function(Numbers{0.3, 0.25}), {2 * 0.3 + 3 * 0.25});
  expect_numbers(function(Numbers{-7, 9}), {3});
}

TEST(PdfFunction, samples_are_encoded_and_decoded) {
  SampledFunction parameters = six_samples();
  parameters.encode = {{2, 0}, {0, 5}};
  parameters.decode = {{255, 0}};
  const Function function(parameters);
  expect_numbers(function(Numbers{0, 0}), {253});
  expect_numbers(function(Numbers{1, 0}), {255});
  // 0.5 of the second input is encoded as 2.5, which is beyond the last sample, 1.
  expect_numbers(function(Numbers{1, 0.1}), {255 - 1.5});
  expect_numbers(function(Numbers{1, 0.5}), {252});
}

TEST(PdfFunction, samples_of_all_sizes) {
  const std::string bytes("\x12\x34\x56\x78\x9a\xbc\xde\xf0", 8);
  const std::vector<std::pair<int, Numbers>> cases{
      {1, {0, 0, 0, 1}},
      {2, {0, 1, 0, 2}},
      {4, {0x1, 0x2, 0x3, 0x4}},
      {8, {0x12, 0x34, 0x56, 0x78}},
      {12, {0x123, 0x456, 0x789, 0xabc}},
      {16, {0x1234, 0x5678, 0x9abc, 0xdef0}},
      {24, {0x123456, 0x789abc}},
      {32, {0x12345678, 0x9abcdef0}},
  };
  for (const auto& [bits, values] : cases) {
    const double largest = std::exp2(bits) - 1;
    const auto count = static_cast<int>(values.size());
    const Function along(
        SampledFunction{{{0, count - 1.0}}, {{0, largest}}, {count}, bits, {}, {}, bytes});
    for (int i = 0; i < count; ++i)
      EXPECT_EQ(along(Numbers{1.0 * i}), Numbers{values[static_cast<std::size_t>(i)]})
          << bits << " bits, sample " << i;
    // The same bits as outputs of one sample.
    const Function beside(
        SampledFunction{{{0, 1}}, Ranges(values.size(), {0, largest}), {1}, bits, {}, {}, bytes});
    EXPECT_EQ(beside(Numbers{0.5}), values) << bits << " bits";
  }
}

TEST(PdfFunction, samples_along_eight_inputs) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  const Function function(
      SampledFunction{Ranges(8), {{0, 255}}, std::vector<int>(8, 2), 8, {}, {}, bytes});
  // Input i counts 2^i.
  expect_numbers(function(Numbers{1, 0, 0.5, 0, 0, 0.25, 0, 1}), {1 + 2 + 8 + 128});
}

TEST(PdfFunction, powers) {
  const Function function(ExponentialFunction{{{0, 2}}, {{0, 3}, {-1, 1}}, {0, 1}, {1, -1}, 2});
  expect_numbers(function(Numbers{0.5}), {0.25, 0.5});
  expect_numbers(function(Numbers{1.5}), {2.25, -1});
  expect_numbers(function(Numbers{7}), {3, -1});
  const Function usual(ExponentialFunction{.domain = {{0, 1}}, .range = {}});
  expect_numbers(usual(Numbers{0.3}), {0.3});
}

TEST(PdfFunction, stitched) {
  const StitchingFunction parameters{
      {{0, 1}},
      {},
      {Function(line({0, 0}, {1, 10})), Function(line({5, 5}, {6, 7})),
       Function(line({9, 0}, {8, 1}))},
      {0.25, 0.5},
      {{0, 1}, {1, 0}, {0, 0.5}}};
  const Function function(parameters);
  EXPECT_EQ(function.outputs(), 2);
  expect_numbers(function(Numbers{0.125}), {0.5, 5});
  // A bound belongs to the part above it.
  expect_numbers(function(Numbers{0.25}), {6, 7});
  expect_numbers(function(Numbers{0.375}), {5.5, 6});
  expect_numbers(function(Numbers{0.5}), {9, 0});
  expect_numbers(function(Numbers{1}), {8.5, 0.5});
}

TEST(PdfFunction, parts_without_length) {
  const Function function(StitchingFunction{
      {{0, 1}},
      {},
      {Function(line({1}, {2})), Function(line({3}, {4})), Function(line({5}, {6}))},
      {0, 1},
      {{0, 1}, {0, 1}, {0, 1}}});
  expect_numbers(function(Numbers{0}), {3});
  expect_numbers(function(Numbers{0.5}), {3.5});
  expect_numbers(function(Numbers{1}), {5});
}

TEST(PdfFunction, joined_has_the_outputs_of_all) {
  const Function narrow(ExponentialFunction{{{0, 0.5}}, {}, {0}, {1}, 1});
  const Function function = joined({Function(line({0}, {2})), narrow, Function(line({1}, {0}))});
  EXPECT_EQ(function.inputs(), 1);
  EXPECT_EQ(function.outputs(), 3);
  expect_numbers(function(Numbers{0.75}), {1.5, 0.5, 0.25});
}

TEST(PdfFunction, parameters_that_do_not_fit_together) {
  const auto refused = [](const auto& parameters) {
    try {
      Function{parameters};
    } catch (const InputError&) {
      return true;
    }
    return false;
  };
  const auto changed = [](auto parameters, auto change) {
    change(parameters);
    return parameters;
  };
  EXPECT_FALSE(refused(six_samples()));
  const auto samples = [&](auto change) { return refused(changed(six_samples(), change)); };
  EXPECT_TRUE(samples([](auto& p) { p.samples.pop_back(); }));
  EXPECT_TRUE(samples([](auto& p) { p.size = {3}; }));
  EXPECT_TRUE(samples([](auto& p) { p.size = {3, 0}; }));
  EXPECT_TRUE(samples([](auto& p) { p.size = {3, -2}; }));
  EXPECT_TRUE(samples([](auto& p) { p.size = {std::numeric_limits<int>::min(), 2}; }));
  EXPECT_TRUE(samples([](auto& p) { p.size = {1 << 30, 1 << 30}; }));
  EXPECT_TRUE(samples([](auto& p) {
    p.domain = Ranges(8);
    p.size = std::vector<int>(8, std::numeric_limits<int>::max());
  }));
  EXPECT_TRUE(samples([](auto& p) { p.bits_per_sample = 0; }));
  EXPECT_TRUE(samples([](auto& p) { p.bits_per_sample = 64; }));
  EXPECT_TRUE(samples([](auto& p) { p.range.clear(); }));
  EXPECT_TRUE(samples([](auto& p) { p.domain.clear(); }));
  EXPECT_TRUE(samples([](auto& p) { p.domain[0] = {1, 0}; }));
  EXPECT_TRUE(samples([](auto& p) { p.encode = {{0, 1}}; }));
  EXPECT_TRUE(samples([](auto& p) { p.decode = Ranges(2); }));
  EXPECT_TRUE(samples([](auto& p) {
    p.domain = Ranges(9);
    p.size = std::vector<int>(9, 1);
  }));
  EXPECT_TRUE(samples([](auto& p) { p.range = Ranges(33); }));

  const auto powers = [&](auto change) { return refused(changed(line({0}, {1}), change)); };
  EXPECT_FALSE(powers([](auto&) {}));
  EXPECT_TRUE(powers([](auto& p) { p.c0 = {0, 0}; }));
  EXPECT_TRUE(powers([](auto& p) { p.c0 = p.c1 = {}; }));
  EXPECT_TRUE(powers([](auto& p) { p.range = Ranges(2); }));
  EXPECT_TRUE(powers([](auto& p) { p.domain = Ranges(2); }));

  const Function part(line({0}, {1}));
  const StitchingFunction two{{{0, 1}}, {}, {part, part}, {0.5}, Ranges(2)};
  const auto parts = [&](auto change) { return refused(changed(two, change)); };
  EXPECT_FALSE(parts([](auto&) {}));
  EXPECT_TRUE(parts([](auto& p) { p.functions.clear(); }));
  EXPECT_TRUE(parts([](auto& p) { p.functions[1] = Function(line({0, 0}, {1, 1})); }));
  EXPECT_TRUE(parts([](auto& p) { p.functions[1] = Function(six_samples()); }));
  EXPECT_TRUE(parts([](auto& p) { p.bounds = {}; }));
  EXPECT_TRUE(parts([](auto& p) { p.bounds = {1.5}; }));
  EXPECT_TRUE(parts([](auto& p) { p.encode = Ranges(1); }));
  EXPECT_TRUE(parts([](auto& p) { p.domain = Ranges(2); }));
  EXPECT_TRUE(refused(StitchingFunction{{{0, 1}}, {}, {part, part, part}, {0.6, 0.5}, Ranges(3)}));

  EXPECT_TRUE(refused(CalculatorFunction{{{0, 1}}, {}, "{ 1 }"}));
  EXPECT_THROW(joined({}), InputError);
  EXPECT_THROW(joined({part, Function(line({0, 0}, {1, 1}))}), InputError);
  EXPECT_THROW(joined({part, Function(six_samples())}), InputError);
  EXPECT_THROW(joined(std::vector<Function>(33, part)), InputError);
}

TEST(PdfFunction, functions_do_not_lie_too_deep) {
  Function function(line({0}, {1}));
  const auto within_another = [](const Function& inner) {
    return Function(StitchingFunction{{{0, 1}}, {}, {inner}, {}, Ranges(1)});
  };
  for (int i = 0; i < 15; ++i) function = within_another(function);
  expect_numbers(function(Numbers{0.4}), {0.4});
  EXPECT_THROW(within_another(function), InputError);
  EXPECT_THROW(joined({function}), InputError);
}

/// Makes functions of parameters that nobody would write, and evaluates them anywhere.
class Hostile {
 public:
  explicit Hostile(unsigned seed) : random_(seed) {}

  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  double number() {
    constexpr double odd[] = {0,    1,     -1,     0.5,      255,       -1e300,       1e300,
                              1e38, -1e38, 1e-300, infinite, -infinite, not_a_number, 2147483648.0};
    return below(3) ? std::uniform_real_distribution<>(-2, 2)(random_)
                    : odd[below(static_cast<int>(std::size(odd)))];
  }

  Ranges ranges(int count) {
    Ranges ranges;
    for (int i = 0; i < count; ++i) {
      const double a = number(), b = number();
      ranges.push_back({std::fmin(a, b), std::fmax(a, b)});
    }
    return ranges;
  }

  Numbers numbers(int count) {
    Numbers numbers;
    for (int i = 0; i < count; ++i) numbers.push_back(number());
    return numbers;
  }

  Function function(int outputs, const Ranges& range, bool has_one_input);

 private:
  std::string program();

  std::mt19937 random_;
};

std::string Hostile::program() {
  constexpr const char* words[] = {"abs",
                                   "add",
                                   "atan",
                                   "ceiling",
                                   "cos",
                                   "cvi",
                                   "cvr",
                                   "div",
                                   "exp",
                                   "floor",
                                   "idiv",
                                   "ln",
                                   "log",
                                   "mod",
                                   "mul",
                                   "neg",
                                   "round",
                                   "sin",
                                   "sqrt",
                                   "sub",
                                   "and",
                                   "truncate",
                                   "bitshift",
                                   "eq",
                                   "ne",
                                   "gt",
                                   "ge",
                                   "lt",
                                   "le",
                                   "false",
                                   "true",
                                   "not",
                                   "or",
                                   "xor",
                                   "copy",
                                   "dup",
                                   "exch",
                                   "index",
                                   "pop",
                                   "roll",
                                   "1",
                                   "-1",
                                   "0",
                                   "3",
                                   "2147483647",
                                   "-2147483648",
                                   "1e30",
                                   "0.5",
                                   "360",
                                   "{ dup mul } if",
                                   "{ 1 } { exch } ifelse"};
  std::string text = "{";
  for (int i = below(60); i > 0; --i)
    text += std::string(" ") + words[below(static_cast<int>(std::size(words)))];
  return text + " }";
}

Function Hostile::function(int outputs, const Ranges& range, bool has_one_input) {
  const int type = below(4), inputs = has_one_input ? 1 : 1 + below(3);
  if (type == 0) {
    constexpr int bits[] = {1, 2, 4, 8, 12, 16, 24, 32};
    SampledFunction parameters{ranges(inputs), range, {}, bits[below(8)], {}, {}, {}};
    for (int i = 0; i < inputs; ++i) parameters.size.push_back(1 + below(4));
    if (below(2)) parameters.encode = ranges(inputs);
    if (below(2)) parameters.decode = ranges(outputs);
    for (int i = 0; i < 64 * 4 * outputs; ++i)
      parameters.samples += static_cast<char>(static_cast<unsigned char>(random_()));
    return Function(parameters);
  }
  if (type == 1 && has_one_input)
    return Function(
        ExponentialFunction{ranges(1), range, numbers(outputs), numbers(outputs), number()});
  if (type == 2 && has_one_input) {
    StitchingFunction parameters{{{-1, 1}}, range, {}, {}, ranges(3)};
    std::swap(parameters.encode[0].low, parameters.encode[0].high);
    for (int i = 0; i < 3; ++i)
      parameters.functions.push_back(function(outputs, ranges(outputs), true));
    parameters.bounds = {-0.5 * below(2), 0.5 * below(3)};
    return Function(parameters);
  }
  return Function(CalculatorFunction{ranges(inputs), range, program()});
}

TEST(PdfFunction, outputs_are_numbers_within_their_range_whatever_the_parameters) {
  Hostile hostile(5);
  int made = 0;
  for (int i = 0; i < 4000; ++i) {
    const int outputs = 1 + hostile.below(4);
    const Ranges range = hostile.ranges(outputs);
    try {
      const Function function = hostile.function(outputs, range, hostile.below(2));
      ++made;
      for (int k = 0; k < 20; ++k) {
        const Numbers out = function(hostile.numbers(hostile.below(5)));
        ASSERT_EQ(out.size(), range.size());
        for (std::size_t n = 0; n < out.size(); ++n) {
          const auto limit = [](double x) {
            return std::isnan(x) ? 0 : std::clamp(x, -max_pdf_number, max_pdf_number);
          };
          ASSERT_TRUE(out[n] >= limit(range[n].low) && out[n] <= limit(range[n].high)) << out[n];
        }
      }
    } catch (const InputError&) {
      // A range is none.
    }
  }
  EXPECT_GT(made, 2000);
}

}  // namespace
}  // namespace gradmesh
