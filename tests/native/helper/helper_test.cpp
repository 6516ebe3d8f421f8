#include "helper/helper.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <chrono>
#include <istream>
#include <ostream>
#include <thread>

#include "helper/wire.h"
#include "pipe.h"
#include "requests.h"

namespace gradmesh {
namespace {

using test::bytes_of;
using test::no_answer;
using test::parse_request;
using test::request;
using test::sample;
using test::simplify_request;

/// Keeps TBB's threads until the program ends. Otherwise they end with the thread of a helper, and
/// with MinGW that one and they have been seen to wait for each other, in what threads do at their
/// end. The program has its helper on the main thread.
const tbb::task_scheduler_handle tbb_threads{tbb::attach{}};

/// A helper on a thread of its own, as its caller sees it. Who ends it during a call ends the
/// program, as the helper's caller has gone.
class Helper {
 public:
  ~Helper() {
    if (thread_.joinable()) end();
  }

  void send(const Json& message) { write_message(to_, message); }
  void send_bytes(const std::string& bytes) { to_ << bytes; }

  /// Returns what the helper says next; null if it says no more.
  Json hear() { return read_message(from_).value_or(Json()); }
  /// Returns the same without signs of life.
  Json hear_more() {
    Json message = hear();
    while (message.is_object() && message.contains("alive")) message = hear();
    return message;
  }

  /// Returns the outcome of a call that asks nothing.
  Json call(const std::string& function, const Json& arguments = Json::object()) {
    send(request(function, arguments));
    return hear_more();
  }
  /// Returns the number of a document, which it reads.
  Json parse(const std::string& bytes, bool translated = false) {
    send(parse_request(bytes, translated));
    return hear_more().value("result", Json());
  }
  std::string bytes(const Json& document) {
    return bytes_of(call("bytes", {{"document", document}}).value("result", Json()));
  }
  /// Returns the outcome of a call, each of whose questions gets the answer of its kind, a function
  /// of the question.
  template <class Answer>
  Json call_and_answer(const Json& call_request, const Answer& answer) {
    send(call_request);
    Json message = hear_more();
    for (; message.contains("ask"); message = hear_more()) send({{"answer", answer(message)}});
    return message;
  }

  /// Ends what the helper hears, and returns its exit status.
  int end() {
    in_.close();
    thread_.join();
    return status_;
  }

 private:
  test::Pipe in_, out_;
  std::ostream to_{&in_};
  std::istream from_{&out_};
  int status_ = -1;
  std::thread thread_{[this] {
    std::istream in(&in_);
    std::ostream out(&out_);
    status_ = run_helper(in, out);
    out_.close();
  }};
};

Json error(const char* kind, const std::string& text) { return {{"error", kind}, {"text", text}}; }

const Json garbled = error("garbled", "a message has no length.");
const Json hello = {{"result", {{"protocol", Service::version}, {"version", GRADMESH_VERSION}}}};

TEST(Helper, refuses_in_words_what_makes_no_sense_and_goes_on) {
  Helper helper;
  const Json document = helper.parse(sample("tensor.svg"));
  EXPECT_EQ(document, 1);
  const auto simplify = [&](const Json& arguments) {
    return simplify_request(document, arguments);
  };
  const auto ids = [&](const Json& number) { return request("ids", {{"document", number}}); };
  constexpr auto no_names = "the arguments of a call must have names.",
                 no_call = "call must be a text.",
                 no_number = "document must be a whole number that is not negative.";
  const Json empty = Json::object();
  const std::vector<std::pair<Json, std::string>> refusals = {
      {nullptr, no_names},
      {Json::array(), no_names},
      {3, no_names},
      {"hello", no_names},
      {Json::array({{{"call", "hello"}}}), no_names},
      {empty, no_call},
      {{{"call", 7}, {"arguments", empty}}, no_call},
      // An answer that nobody waits for.
      {{{"answer", true}}, no_call},
      {{{"call", "hello"}}, "a call has arguments."},
      {request("hello", Json::array()), no_names},
      {{{"call", "hello"}, {"arguments", empty}, {"release", 3}}, "release must be a list."},
      {{{"call", "hello"}, {"arguments", empty}, {"release", {-3}}},
       "a member of release must be a whole number that is not negative."},
      {request("parse", {{"bytes", "<svg/>"}, {"name", "drawing.svg"}}), "bytes must be bytes."},
      {request("ids", empty), no_number},
      {ids("1"), no_number},
      {ids(-1), no_number},
      {ids(1.0), no_number},
      {ids(true), no_number},
      {ids(Json::array({1})), no_number},
      {simplify({{"epsilon", "0.01"}}), "epsilon must be a number."},
      {simplify({{"ids", "silk"}}), "ids must be a list."},
      {simplify({{"ids", {"silk", 1}}}), "a member of ids must be a text."},
      {simplify({{"handles", 1.5}}), "handles must be a whole number."},
      {simplify({{"handles", 1ull << 31}}), "handles must be below 2^31."},
      {simplify({{"visible_only", 1}}), "visible_only must be true or false."},
      {simplify({{"original", "silk"}}), "original must be a whole number that is not negative."},
  };
  for (const auto& [message, text] : refusals) {
    helper.send(message);
    EXPECT_EQ(helper.hear_more(), error("type", text)) << message;
  }
  EXPECT_EQ(helper.call("help"), error("value", "there is no function 'help'."));
  EXPECT_EQ(helper.bytes(document), sample("tensor.svg"));
  EXPECT_EQ(helper.call("hello"), hello);
  EXPECT_EQ(helper.end(), 0);
}

TEST(Helper, reads_simplifies_and_returns_a_document) {
  Helper helper;
  const std::string bytes = sample("tensor.svg");
  const Json document = helper.parse(bytes);
  const Json named = {{"document", document}};
  EXPECT_EQ(helper.call("kind", named), Json({{"result", "svg"}}));
  EXPECT_EQ(helper.call("ids", named), Json({{"result", {"silk"}}}));
  EXPECT_EQ(helper.call("meshes", named), Json::parse(R"({"result": [{"id": "silk", "role": "fill",
      "simplified": false, "remembers": false, "color_model": "bilinear", "smooth": false,
      "handles": 313, "patches": 36, "objects": 1, "points": 49, "t_junctions": 0,
      "refused": null}]})"));
  EXPECT_EQ(helper.bytes(document), bytes);

  const Json results = helper.call_and_answer(simplify_request(document), no_answer)["result"];
  ASSERT_EQ(results.size(), 1u);
  const Json& report = results[0];
  EXPECT_EQ(report["id"], "silk");
  EXPECT_EQ(report["stopped"], "done");
  EXPECT_EQ(report["handles_before"], 313);
  EXPECT_LT(report["handles_after"], 313);
  EXPECT_LE(report["error"], 0.01);
  EXPECT_EQ(helper.call("meshes", named)["result"][0]["handles"], report["handles_after"]);
  // What is returned is a document that can be read.
  const std::string simplified = helper.bytes(document);
  EXPECT_NE(simplified, bytes);
  const Json again = helper.parse(simplified);
  EXPECT_EQ(again, 2);
  EXPECT_EQ(helper.bytes(again), simplified);
  EXPECT_EQ(helper.end(), 0);
}

TEST(Helper, refuses_released_documents_in_words) {
  Helper helper;
  const Json first = helper.parse(sample("tensor.svg")),
             second = helper.parse(sample("tensor.svg"));
  const Json no_first = error("value", "there is no document 1.");
  EXPECT_EQ(helper.call("ids", {{"document", 101}}), error("value", "there is no document 101."));
  Json releasing = request("ids", {{"document", first}});
  releasing["release"] = Json::array({first});
  // To release what is gone is no mistake.
  std::vector<Json> calls = {releasing, releasing, simplify_request(second, {{"original", first}})};
  for (const char* const function : {"ids", "bytes", "meshes", "info", "kind"})
    calls.push_back(request(function, {{"document", first}}));
  for (const Json& call : calls) {
    helper.send(call);
    EXPECT_EQ(helper.hear_more(), no_first) << call;
  }
  EXPECT_EQ(helper.call("ids", {{"document", second}}), Json({{"result", {"silk"}}}));
  // No number is ever used again.
  EXPECT_EQ(helper.parse(sample("tensor.svg")), 3);
  EXPECT_EQ(helper.end(), 0);
}

TEST(Helper, tells_of_bad_input_by_template_and_arguments) {
  Helper helper;
  helper.send(parse_request("<svg"));
  const Json bad = helper.hear_more();
  EXPECT_EQ(bad["error"], "input");
  EXPECT_EQ(bad.size(), 2u) << bad;
  ASSERT_EQ(bad["message"].size(), 2u) << bad;
  EXPECT_NE(bad["message"][0].get<std::string>().find("{0}"), std::string::npos);
  EXPECT_EQ(bad["message"][1][0], "drawing.svg");

  helper.send(simplify_request(helper.parse(sample("tensor.svg")), {{"ids", {"satin"}}}));
  const Json unknown = helper.hear_more();
  EXPECT_EQ(unknown["error"], "input");
  EXPECT_NE(unknown["message"].dump().find("satin"), std::string::npos) << unknown;
  EXPECT_EQ(helper.end(), 0);
}

TEST(Helper, asks_how_to_go_on_and_stops_where_the_answer_is_not_true) {
  Helper helper;
  const std::string bytes = sample("tensor.svg");
  const std::vector<std::pair<Json, std::string>> answers = {
      {true, "done"}, {nullptr, "done"}, {false, "cancelled"}, {"yes", "cancelled"}};
  for (const auto& [answer, stopped] : answers) {
    int asked = 0;
    const auto reply = [&, answer = answer](const Json& question) {
      ++asked;
      EXPECT_EQ(question["ask"], "progress");
      EXPECT_EQ(question.size(), 8u) << question;
      EXPECT_EQ(question["mesh"], 0);
      EXPECT_EQ(question["meshes"], 1);
      EXPECT_LE(question["done"], question["total"]);
      EXPECT_LE(question["patches"], 36);
      EXPECT_LE(question["handles"], 313);
      EXPECT_LE(question["error"], 1);
      return answer;
    };
    const Json outcome = helper.call_and_answer(simplify_request(helper.parse(bytes)), reply);
    EXPECT_EQ(outcome["result"][0]["stopped"], stopped) << answer;
    EXPECT_GE(asked, stopped == "done" ? 4 : 1) << answer;
  }
  EXPECT_EQ(helper.end(), 0);
}

TEST(Helper, gives_a_call_up_and_goes_on) {
  Helper helper;
  const std::string bytes = sample("tensor.svg");
  const Json document = helper.parse(bytes);
  // Anything but an answer gives the call up.
  for (const Json& message : {Json{{"give_up", true}}, Json::object(), Json(true), Json(),
                              request("hello", Json::object())}) {
    helper.send(simplify_request(document));
    EXPECT_EQ(helper.hear_more()["ask"], "progress");
    helper.send({{"answer", true}});
    EXPECT_EQ(helper.hear_more()["ask"], "progress");
    helper.send(message);
    EXPECT_EQ(helper.hear_more(),
              Json({{"error", "given up"}, {"text", "the caller has given up."}}));
    EXPECT_EQ(helper.bytes(document), bytes);
  }
  const Json outcome = helper.call_and_answer(simplify_request(document), no_answer);
  EXPECT_EQ(outcome["result"][0]["stopped"], "done");
  EXPECT_NE(helper.bytes(document), bytes);
  EXPECT_EQ(helper.end(), 0);
}

TEST(Helper, asks_for_translations) {
  Helper helper;
  const std::string bytes = sample("tensor.svg");
  const auto simplified = [&](bool translated, const Json& translation, int& asked) {
    const Json document = helper.parse(bytes, translated);
    helper.call_and_answer(simplify_request(document), [&](const Json& question) -> Json {
      if (question["ask"] != "translate") return true;
      EXPECT_EQ(question.size(), 2u) << question;
      ++asked;
      if (!translation.is_string()) return translation;
      return translation.get<std::string>() + question["text"].get<std::string>();
    });
    return helper.bytes(document);
  };
  int asked = 0;
  const std::string english = simplified(false, "", asked);
  EXPECT_EQ(asked, 0);
  EXPECT_NE(english.find("Gradient mesh: "), std::string::npos);
  EXPECT_EQ(english.find("auf Deutsch: "), std::string::npos);
  EXPECT_NE(simplified(true, "auf Deutsch: ", asked).find("auf Deutsch: Gradient mesh: "),
            std::string::npos);
  EXPECT_GE(asked, 1);
  // Without an answer that is a text, the texts stay as they are.
  EXPECT_EQ(simplified(true, nullptr, asked), english);
  EXPECT_EQ(simplified(true, 3, asked), english);
  EXPECT_EQ(helper.end(), 0);
}

TEST(Helper, shows_each_second_of_a_call_that_it_is_alive) {
  using Clock = std::chrono::steady_clock;
  Helper helper;
  const Json document = helper.parse(sample("tensor.svg"));
  const auto start = Clock::now();
  helper.send(simplify_request(document));
  EXPECT_EQ(helper.hear_more()["ask"], "progress");
  // Nobody answers for now.
  for (const int seconds : {1, 2}) {
    EXPECT_EQ(helper.hear(), Json({{"alive", true}}));
    EXPECT_GE(Clock::now() - start, std::chrono::seconds(seconds));
  }
  helper.send({{"answer", false}});
  EXPECT_EQ(helper.hear_more()["result"][0]["stopped"], "cancelled");
  // Between calls there are none: the next that is heard is the end.
  std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  EXPECT_EQ(helper.end(), 0);
  EXPECT_EQ(helper.hear(), nullptr);
}

TEST(Helper, ends_well_where_the_input_ends_between_calls) {
  for (const bool is_used : {false, true}) {
    Helper helper;
    if (is_used) {
      EXPECT_EQ(helper.call("hello"), hello);
    }
    EXPECT_EQ(helper.end(), 0);
    EXPECT_EQ(helper.hear(), nullptr);
  }
}

TEST(Helper, ends_with_a_last_message_after_what_is_none) {
  for (const char* const bytes : {"x", "\n", "GET / HTTP/1.1\r\n", "99999999999\n{}"}) {
    Helper helper;
    helper.send_bytes(bytes);
    EXPECT_EQ(helper.hear(), garbled) << bytes;
    EXPECT_EQ(helper.hear(), nullptr) << bytes;
    EXPECT_EQ(helper.end(), 1) << bytes;
  }
  Helper cut_off;
  cut_off.send_bytes("20\n{}");
  EXPECT_EQ(cut_off.end(), 1);
  EXPECT_EQ(cut_off.hear(), error("garbled", "a message is shorter than its length."));
  EXPECT_EQ(cut_off.hear(), nullptr);
}

TEST(Helper, does_what_was_asked_for_before_what_is_no_message) {
  // What follows is there before the call begins, while it is at work, or after it, as it comes.
  for (int i = 0; i < 100; ++i) {
    Helper helper;
    std::ostringstream first;
    write_message(first, request("hello", Json::object()));
    helper.send_bytes(first.str() + "x");
    EXPECT_EQ(helper.hear_more()["result"]["protocol"], Service::version);
    EXPECT_EQ(helper.hear(), garbled);
    EXPECT_EQ(helper.hear(), nullptr);
    EXPECT_EQ(helper.end(), 1);
  }
}

TEST(Helper, ends_where_an_answer_is_no_message) {
  Helper helper;
  const Json document = helper.parse(sample("tensor.svg"));
  helper.send(simplify_request(document));
  EXPECT_EQ(helper.hear_more()["ask"], "progress");
  helper.send_bytes("x");
  EXPECT_TRUE(helper.hear_more().contains("error"));
  EXPECT_EQ(helper.hear_more(), garbled);
  EXPECT_EQ(helper.hear(), nullptr);
  EXPECT_EQ(helper.end(), 1);
}

/// Tests that start programs of their own, since a process with threads cannot be copied.
class HelperDeathTest : public testing::Test {
 protected:
  HelperDeathTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }

  /// Ends the input after a call that asks something and `last`. Returns where the process has not
  /// ended.
  static void end_during_a_call(bool hears_question, const Json& last = {}) {
    Helper helper;
    helper.send(simplify_request(helper.parse(sample("tensor.svg"))));
    if (hears_question && helper.hear_more()["ask"] != "progress") return;
    if (!last.is_null()) helper.send(last);
    helper.end();
  }
};

TEST_F(HelperDeathTest, where_the_input_ends_while_a_call_waits_for_an_answer) {
  EXPECT_EXIT(end_during_a_call(true), testing::ExitedWithCode(EXIT_FAILURE), "^$");
}

TEST_F(HelperDeathTest, where_the_input_ends_while_a_call_is_at_work) {
  EXPECT_EXIT(end_during_a_call(false), testing::ExitedWithCode(EXIT_FAILURE), "^$");
  // The last answer lets it go on, but nobody waits for what comes of it.
  EXPECT_EXIT(end_during_a_call(true, {{"answer", true}}), testing::ExitedWithCode(EXIT_FAILURE),
              "^$");
  EXPECT_EXIT(end_during_a_call(false, {{"answer", true}}), testing::ExitedWithCode(EXIT_FAILURE),
              "^$");
}

}  // namespace
}  // namespace gradmesh
