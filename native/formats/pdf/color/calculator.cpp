#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "formats/pdf/color/calculator_operators.h"
#include "formats/pdf/color/function_rule.h"
#include "formats/text/excerpt.h"

namespace gradmesh {
namespace {

/// More than any producer writes. Programs are run in one pass, so this bounds their time.
constexpr std::size_t max_instructions = 20'000;
/// How deep procedures may lie within each other.
constexpr int max_procedure_depth = 32;

/// A step of a program: an operator, a number, or a jump forward. Procedures lie where they are
/// written, behind a jump over them.
struct Instruction {
  enum class Kind { run, push, jump, jump_if_false };
  Kind kind = Kind::push;
  CalculatorOperator run = nullptr;
  double number = 0;
  /// The next instruction after a jump.
  std::size_t target = 0;
};

/// Parses a program (ISO 32000-1, 7.10.5.1) into instructions.
class ProgramParser {
 public:
  explicit ProgramParser(std::string_view text) : rest_(text) {}

  std::vector<Instruction> parse() {
    if (next_word() != "{") throw_unreadable("");
    parse_procedure(1);
    if (const std::string_view word = next_word(); !word.empty()) throw_unreadable(word);
    return std::move(instructions_);
  }

 private:
  [[noreturn]] static void throw_unreadable(std::string_view word) {
    throw InputError("the program of a function of its shading cannot be read at {0}",
                     excerpt(word));
  }

  void parse_procedure(int depth);
  void parse_branch(int depth);
  void add(const Instruction& instruction);
  std::string_view next_word();
  void skip_blanks_and_comments();

  std::string_view rest_;
  std::vector<Instruction> instructions_;
};

constexpr std::string_view postscript_blanks("\0\t\n\f\r ", 6);

void ProgramParser::skip_blanks_and_comments() {
  while (true) {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(postscript_blanks), rest_.size()));
    if (!rest_.starts_with('%')) return;
    rest_.remove_prefix(std::min(rest_.find_first_of("\r\n"), rest_.size()));
  }
}

/// Takes a brace, or what stands up to the next blank, brace or comment; empty at the end.
std::string_view ProgramParser::next_word() {
  constexpr std::string_view ends("\0\t\n\f\r {}%", 9);
  skip_blanks_and_comments();
  if (rest_.empty()) return {};
  const bool is_brace = rest_.front() == '{' || rest_.front() == '}';
  const std::size_t length = is_brace ? 1 : std::min(rest_.find_first_of(ends), rest_.size());
  const std::string_view word = rest_.substr(0, length);
  rest_.remove_prefix(length);
  return word;
}

void ProgramParser::add(const Instruction& instruction) {
  if (instructions_.size() == max_instructions)
    throw InputError("the program of a function of its shading is too long");
  instructions_.push_back(instruction);
}

/// Returns the number that is all of this word. `nan` and `inf` are none.
std::optional<double> program_number(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  if (word.find_first_not_of("+-.0123456789eE") != std::string_view::npos) return std::nullopt;
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return pdf_number(number);
}

/// Parses what follows an opening brace, up to the brace that closes it.
void ProgramParser::parse_procedure(int depth) {
  if (depth > max_procedure_depth)
    throw InputError("the program of a function of its shading is nested too deeply");
  for (std::string_view word = next_word(); word != "}"; word = next_word()) {
    if (word == "{")
      parse_branch(depth);
    else if (const auto number = program_number(word))
      add({Instruction::Kind::push, nullptr, *number, 0});
    else if (const CalculatorOperator run = calculator_operator(word))
      add({Instruction::Kind::run, run, 0, 0});
    else
      throw_unreadable(word);
  }
}

/// Parses `...} if` or `...} {...} ifelse`, of which the first brace has been taken.
void ProgramParser::parse_branch(int depth) {
  const std::size_t over_first = instructions_.size();
  add({Instruction::Kind::jump_if_false, nullptr, 0, 0});
  parse_procedure(depth + 1);
  std::string_view word = next_word();
  if (word == "{") {
    const std::size_t over_second = instructions_.size();
    add({Instruction::Kind::jump, nullptr, 0, 0});
    instructions_[over_first].target = instructions_.size();
    parse_procedure(depth + 1);
    instructions_[over_second].target = instructions_.size();
    word = next_word();
    if (word != "ifelse") throw_unreadable(word);
  } else {
    instructions_[over_first].target = instructions_.size();
    if (word != "if") throw_unreadable(word);
  }
}

class CalculatorRule : public FunctionRule {
 public:
  explicit CalculatorRule(std::vector<Instruction> program) : program_(std::move(program)) {}

  void evaluate(std::span<const double> in, std::span<double> out) const override {
    CalculatorStack stack;
    for (const double x : in) stack.push(x);
    for (std::size_t i = 0; i < program_.size();) {
      const Instruction& step = program_[i++];
      if (step.kind == Instruction::Kind::run)
        step.run(stack);
      else if (step.kind == Instruction::Kind::push)
        stack.push(step.number);
      else if (step.kind == Instruction::Kind::jump || stack.pop().value == 0)
        i = step.target;
    }
    for (std::size_t i = out.size(); i-- > 0;) out[i] = stack.pop().value;
  }

 private:
  std::vector<Instruction> program_;
};

}  // namespace

std::shared_ptr<const FunctionRule> calculator_rule(std::string_view program) {
  return std::make_shared<CalculatorRule>(ProgramParser(program).parse());
}

}  // namespace gradmesh
