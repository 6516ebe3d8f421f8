#include "formats/pdf/color/calculator_operators.h"

#include <numbers>

namespace gradmesh {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Replaces a number by what `f` makes of it.
template <class F>
void change_number(CalculatorStack& stack, F f) {
  stack.push(f(stack.pop().value));
}

/// Replaces two numbers by what `f` makes of them.
template <class F>
void combine_numbers(CalculatorStack& stack, F f) {
  const double second = stack.pop().value;
  const double first = stack.pop().value;
  stack.push(f(first, second));
}

/// Replaces two operands by whether `f` holds of them.
template <class F>
void compare_operands(CalculatorStack& stack, F f) {
  const CalculatorOperand second = stack.pop();
  const CalculatorOperand first = stack.pop();
  stack.push_truth(f(first, second));
}

/// Replaces two truth values by a truth value, and two integers by an integer, bit by bit.
template <class F>
void combine_bits(CalculatorStack& stack, F f) {
  const CalculatorOperand second = stack.pop();
  const CalculatorOperand first = stack.pop();
  const std::int32_t bits = f(first.integer(), second.integer());
  if (first.is_truth && second.is_truth)
    stack.push_truth(bits != 0);
  else
    stack.push(bits);
}

void negate_bits(CalculatorStack& stack) {
  const CalculatorOperand operand = stack.pop();
  if (operand.is_truth)
    stack.push_truth(operand.value == 0);
  else
    stack.push(~operand.integer());
}

/// Returns the angle of a point in degrees, from 0 to below 360.
double angle_of(double y, double x) {
  const double angle = std::atan2(y, x) / degree;
  return angle < 0 ? angle + 360 : angle;
}

/// Shifts to the left, or to the right if `shift` is negative; bits that leave are lost.
double shifted_bits(double number, double shift) {
  const auto bits = static_cast<std::uint32_t>(CalculatorOperand{number}.integer());
  const int places = clamped_int(shift, -32, 32);
  if (places == 32 || places == -32) return 0;
  return static_cast<std::int32_t>(places < 0 ? bits >> -places : bits << places);
}

double integer_of(double number) { return CalculatorOperand{number}.integer(); }

double whole_quotient(double x, double y) {
  return integer_of(y) == 0 ? 0 : std::trunc(integer_of(x) / integer_of(y));
}

/// Returns what a division leaves, with the sign of what is divided.
double remainder_of(double x, double y) { return std::fmod(integer_of(x), integer_of(y)); }

void exchange(CalculatorStack& stack) {
  const CalculatorOperand second = stack.pop();
  const CalculatorOperand first = stack.pop();
  stack.push(second);
  stack.push(first);
}

void roll_operands(CalculatorStack& stack) {
  const CalculatorOperand shift = stack.pop();
  const CalculatorOperand count = stack.pop();
  stack.roll(count.value, shift);
}

struct NamedOperator {
  std::string_view name;
  CalculatorOperator run;
};

// Division by zero and logarithms of what is not positive are made numbers by the stack.
constexpr NamedOperator calculator_operators[] = {
    {"abs", [](auto& s) { change_number(s, [](double x) { return std::abs(x); }); }},
    {"add", [](auto& s) { combine_numbers(s, [](double x, double y) { return x + y; }); }},
    {"and", [](auto& s) { combine_bits(s, [](auto x, auto y) { return x & y; }); }},
    {"atan", [](auto& s) { combine_numbers(s, angle_of); }},
    {"bitshift", [](auto& s) { combine_numbers(s, shifted_bits); }},
    {"ceiling", [](auto& s) { change_number(s, [](double x) { return std::ceil(x); }); }},
    {"copy", [](auto& s) { s.copy(s.pop().value); }},
    {"cos", [](auto& s) { change_number(s, [](double x) { return std::cos(x * degree); }); }},
    {"cvi", [](auto& s) { s.push(s.pop().integer()); }},
    {"cvr", [](auto& s) { s.push(s.pop().value); }},
    {"div", [](auto& s) { combine_numbers(s, [](double x, double y) { return x / y; }); }},
    {"dup", [](auto& s) { s.copy(1); }},
    {"eq", [](auto& s) { compare_operands(s, [](auto x, auto y) { return x == y; }); }},
    {"exch", exchange},
    {"exp", [](auto& s) { combine_numbers(s, [](double x, double y) { return std::pow(x, y); }); }},
    {"false", [](auto& s) { s.push_truth(false); }},
    {"floor", [](auto& s) { change_number(s, [](double x) { return std::floor(x); }); }},
    {"ge", [](auto& s) { compare_operands(s, [](auto x, auto y) { return x.value >= y.value; }); }},
    {"gt", [](auto& s) { compare_operands(s, [](auto x, auto y) { return x.value > y.value; }); }},
    {"idiv", [](auto& s) { combine_numbers(s, whole_quotient); }},
    {"index", [](auto& s) { s.index(s.pop().value); }},
    {"le", [](auto& s) { compare_operands(s, [](auto x, auto y) { return x.value <= y.value; }); }},
    {"ln", [](auto& s) { change_number(s, [](double x) { return std::log(x); }); }},
    {"log", [](auto& s) { change_number(s, [](double x) { return std::log10(x); }); }},
    {"lt", [](auto& s) { compare_operands(s, [](auto x, auto y) { return x.value < y.value; }); }},
    {"mod", [](auto& s) { combine_numbers(s, remainder_of); }},
    {"mul", [](auto& s) { combine_numbers(s, [](double x, double y) { return x * y; }); }},
    {"ne", [](auto& s) { compare_operands(s, [](auto x, auto y) { return !(x == y); }); }},
    {"neg", [](auto& s) { change_number(s, [](double x) { return -x; }); }},
    {"not", negate_bits},
    {"or", [](auto& s) { combine_bits(s, [](auto x, auto y) { return x | y; }); }},
    {"pop", [](auto& s) { s.pop(); }},
    {"roll", roll_operands},
    {"round", [](auto& s) { change_number(s, [](double x) { return std::floor(x + 0.5); }); }},
    {"sin", [](auto& s) { change_number(s, [](double x) { return std::sin(x * degree); }); }},
    {"sqrt", [](auto& s) { change_number(s, [](double x) { return std::sqrt(x); }); }},
    {"sub", [](auto& s) { combine_numbers(s, [](double x, double y) { return x - y; }); }},
    {"true", [](auto& s) { s.push_truth(true); }},
    {"truncate", [](auto& s) { change_number(s, [](double x) { return std::trunc(x); }); }},
    {"xor", [](auto& s) { combine_bits(s, [](auto x, auto y) { return x ^ y; }); }},
};

static_assert(std::ranges::is_sorted(calculator_operators, {}, &NamedOperator::name));

}  // namespace

CalculatorOperator calculator_operator(std::string_view name) {
  const auto found = std::ranges::lower_bound(calculator_operators, name, {}, &NamedOperator::name);
  return found != std::end(calculator_operators) && found->name == name ? found->run : nullptr;
}

}  // namespace gradmesh
