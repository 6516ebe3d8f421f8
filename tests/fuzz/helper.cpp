#include "helper/wire.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>
#include <iterator>
#include <sstream>
#include <string>

#include "service/service.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

/// What an input may ask for, so that none takes seconds of a processor, sanitizers included:
/// patches of a mesh and pixels along a side, also of what calls make. Windows has no setenv.
char limits[] = "GRADMESH_LIMITS=patches=8,resolution=64";
[[maybe_unused]] const int limited = putenv(limits);
/// Further the most calls, and how many of them may simplify, and the bytes of a document that is
/// read and of one that calls go on with.
constexpr int most_calls = 5, most_runs = 2;
constexpr std::size_t most_bytes = 4096, most_bytes_made = 32768;

std::deque<Json> read_messages(std::string_view bytes) {
  std::istringstream in{std::string(bytes)};
  std::deque<Json> messages;
  try {
    while (auto message = read_message(in)) messages.push_back(std::move(*message));
  } catch (const Garbled&) {
  }
  return messages;
}

/// Lengths keep random bytes from everything behind them, so these messages are given theirs.
std::string with_lengths(std::string_view lines) {
  std::string frames;
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(line.size() + 1, lines.size()));
    frames += std::to_string(line.size()) + '\n';
    frames += line;
  }
  return frames;
}

/// Reading is the inverse of writing, for any message that can be read.
void require_same_text(const Json& message) {
  const std::string text = message_text(message);
  require(message_text(text_message(text)) == text, "what was written reads as the same");
}

Json bytes_request(const Json& document) {
  return {{"call", "bytes"}, {"arguments", {{"document", document}}}};
}

bool is_one_of(const Json& value, std::initializer_list<const char*> texts) {
  return std::ranges::any_of(texts, [&](const char* text) { return value == text; });
}

/// Returns true for searches for a target by `best`, which run it some 25 times. It is also what
/// leaves few patches where no other method is named.
bool is_long_search(const Json& arguments) {
  const auto value = [&](const char* name) { return arguments.value(name, Json()); };
  const auto has = [&](const char* name) { return !value(name).is_null(); };
  if (!has("handles") && !has("patches") && !has("ratio")) return false;
  if (has("method") && value("method") != "simplest") return value("method") == "best";
  return has("patches") || value("count") == "patches";
}

/// Returns false for calls that would read and write files, whose names would be invented, that
/// would start a device, and that would take long.
bool may_be_called(const Json& request) {
  if (!request.is_object() || !request.contains("call") || !request.contains("arguments") ||
      !request["arguments"].is_object())
    return true;
  if (is_one_of(request["call"], {"read", "write", "report", "analyze"})) return false;
  const Json& arguments = request["arguments"];
  for (const char* const file : {"path", "load_analysis", "save_analysis", "analysis_cache", "run"})
    if (arguments.contains(file)) return false;
  const auto is_above = [&](const char* name, double most) {
    const auto found = arguments.find(name);
    return found != arguments.end() && found->is_number() && found->get<double>() > most;
  };
  if (is_above("threads", 2) || is_long_search(arguments)) return false;
  if (is_one_of(arguments.value("renderer", Json()), {"auto", "egl"})) return false;
  const Json bytes = arguments.value("bytes", Json());
  return !bytes.is_binary() || bytes.get_binary().size() <= most_bytes;
}

/// Returns a message of the form [template, [arguments]] in English.
std::string said(const Json& message) {
  if (message.is_string()) return message.get<std::string>();
  const auto text = message.at(0).get<std::string>();
  std::string words;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_place = text[i] == '{';
    words +=
        is_place ? said(message.at(1).at(std::size_t(text.at(i + 1) - '0'))) : text.substr(i, 1);
    if (is_place) i += 2;
  }
  return words;
}

void require_sound(const Json& outcome) {
  require_same_text(outcome);
  if (outcome.contains("result")) {
    require(outcome.size() == 1, "there is either a result or an error");
  } else if (outcome.at("error") == "input") {
    require_sentence(said(outcome.at("message")));
  } else {
    require(is_one_of(outcome.at("error"), {"value", "type", "given up"}), "there is no fault");
    require(outcome.at("text").is_string(), "the error is told in words");
  }
}

/// The calls of one input, which answers what they ask, too.
class Session {
 public:
  explicit Session(std::deque<Json> messages) : messages_(std::move(messages)) {}

  void run() {
    for (int calls = 0; calls < most_calls && !messages_.empty() && !is_large_; ++calls) {
      Json request = std::move(messages_.front());
      messages_.pop_front();
      require_same_text(request);
      const bool is_run = request.is_object() && request.value("call", Json()) == "simplify";
      if (!may_be_called(request) || (is_run && ++runs_ > most_runs)) continue;
      call(request);
    }
  }

 private:
  Json call_asking(const Json& request) {
    return service_.call(request, [this](const Json& question) { return answer(question); });
  }

  /// Takes the next message that is no call of its own; whatever is asked beyond is answered by
  /// null.
  Json answer(const Json& question) {
    require_same_text(question);
    if (messages_.empty() || (messages_.front().is_object() && messages_.front().contains("call")))
      return nullptr;
    const Json message = std::move(messages_.front());
    messages_.pop_front();
    if (!message.is_object() || !message.contains("answer")) throw GivenUp();
    return message["answer"];
  }

  void call(Json& request) {
    Json document;
    if (request.is_object() && request.value("arguments", Json()).is_object()) {
      Json& arguments = request["arguments"];
      // The defaults would take long, or start a device.
      if (arguments.value("resolution", Json()).is_null()) arguments["resolution"] = 32;
      if (arguments.value("renderer", Json()).is_null()) arguments["renderer"] = "software";
      const Json threads = arguments.value("threads", Json());
      if (threads.is_null() || threads == 0) arguments["threads"] = 1;
      // Sentences quote it, and a person would not have chosen it.
      if (arguments.contains("name")) arguments["name"] = input_name;
      document = arguments.value("document", Json());
      // What is released cannot be looked at afterwards.
      if (request.contains("release")) document = nullptr;
    }
    const Json before = call_asking(bytes_request(document));
    const Json outcome = call_asking(request);
    require_sound(outcome);
    const Json after = call_asking(bytes_request(document));
    if (outcome.contains("error")) require(after == before, "the document is as it was");
    if (after.contains("result")) check(after["result"]);
  }

  /// What a document has become can be read.
  void check(const Json& bytes) {
    is_large_ = bytes.get_binary().size() > most_bytes_made;
    const Json again = call_asking(
        {{"call", "parse"},
         {"arguments", {{"bytes", bytes}, {"name", input_name}, {"translated", false}}}});
    require(again.contains("result"), "what was written can be read");
    const Json same = call_asking(bytes_request(again["result"]));
    require(same["result"] == bytes, "a document as it was read has the same bytes");
  }

  std::deque<Json> messages_;
  Service service_;
  int runs_ = 0;
  bool is_large_ = false;
};

}  // namespace

/// What the helper is sent, or messages without lengths, one a line.
void check(std::string_view text) {
  const bool has_lengths = !text.empty() && text.front() >= '0' && text.front() <= '9';
  Session(read_messages(has_lengths ? text : with_lengths(text))).run();
}

}  // namespace gradmesh::fuzz
