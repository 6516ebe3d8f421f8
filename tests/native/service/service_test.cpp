#include "service/service.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <limits>
#include <optional>
#include <thread>

#include "app/export/info.h"
#include "app/export/mesh_picture.h"
#include "app/export/results_json.h"
#include "app/pages/read_document.h"
#include "app/runs/runs.h"
#include "base/error.h"
#include "raster/rasterizer.h"
#include "requests.h"

namespace gradmesh {
namespace {

using test::bytes_of;
using test::no_answer;
using test::parse_request;
using test::request;
using test::sample;
using test::simplify_request;

constexpr auto whole = "x must be a whole number.", below = "x must be below 2^31.",
               not_negative = "x must be a whole number that is not negative.",
               no_list = "x must be a list.";

/// Returns the argument x as a T or, as a text, why it is refused.
template <class T>
Json taken(const Json& value) {
  const Json arguments = {{"x", value}};
  try {
    if constexpr (std::is_same_v<T, Bytes>)
      return test::bytes_json(Arguments(arguments).get<T>("x").bytes);
    else
      return Arguments(arguments).get<T>("x");
  } catch (const WrongType& error) {
    return error.what();
  }
}

/// Values of all types.
const Json one_of_each = {nullptr,       true,          1, -1, 1.5, "text", Json::binary({1}),
                          Json::array(), Json::object()};

/// What is taken as a T, and of `one_of_each` the places of those that are; the text refuses the
/// others, and what is `refused`.
template <class T>
void expect_taken(const char* text, const std::vector<std::size_t>& places,
                  const std::vector<Json>& values,
                  const std::vector<std::pair<Json, std::string>>& refused = {}) {
  for (std::size_t i = 0; i < one_of_each.size(); ++i)
    if (std::ranges::find(places, i) == places.end())
      EXPECT_EQ(taken<T>(one_of_each[i]), text) << one_of_each[i];
    else
      EXPECT_EQ(taken<T>(one_of_each[i]), one_of_each[i]);
  for (const Json& value : values) EXPECT_EQ(taken<T>(value), value);
  for (const auto& [value, why] : refused) EXPECT_EQ(taken<T>(value), why) << value;
}

TEST(Arguments, have_names) {
  for (const Json& value : one_of_each)
    if (!value.is_object()) {
      EXPECT_THROW(Arguments{value}, WrongType) << value;
    }
}

TEST(Arguments, are_of_the_type_that_is_asked_for) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto parsed = [](const char* text) { return Json::parse(text); };
  expect_taken<bool>("x must be true or false.", {1}, {false});
  expect_taken<int>(whole, {2, 3}, {0, 2147483647, parsed("2147483647"), parsed("-2147483648")},
                    {{parsed("2147483648"), below},
                     {parsed("-2147483649"), below},
                     {parsed("4294967296"), below},
                     {parsed("4294967295"), below},
                     {parsed("9223372036854775808"), below},
                     {parsed("18446744073709551615"), below},
                     {parsed("-9223372036854775808"), below},
                     // Positive, but of the type of negative numbers.
                     {std::int64_t(1) << 31, below},
                     {std::int64_t(1) << 32, below},
                     {parsed("1e3"), whole},
                     {parsed("18446744073709551616"), whole}});
  expect_taken<std::uint64_t>(not_negative, {2}, {~std::uint64_t(0), 0u, std::int64_t(7)},
                              {{std::numeric_limits<std::int64_t>::min(), not_negative},
                               {parsed("18446744073709551616"), not_negative}});
  expect_taken<double>("x must be a number.", {2, 3, 4},
                       {0.0, -1.5, 1e300, infinity, -infinity, std::uint64_t(1) << 63});
  expect_taken<std::string>("x must be a text.", {5}, {"ä", "", std::string("a\0b", 3)});
  expect_taken<Bytes>("x must be bytes.", {6},
                      {test::bytes_json(std::string("\0\xff<svg", 6)), Json::binary({})});
  expect_taken<std::vector<int>>(no_list, {7}, {{3, -1}},
                                 {{{1, "2"}, "a member of x must be a whole number."},
                                  {{1, nullptr}, "a member of x must be a whole number."}});
  expect_taken<std::vector<std::string>>(no_list, {7}, {{"a", "b"}});
  expect_taken<std::vector<std::vector<int>>>(
      no_list, {7}, {}, {{{{1}, {1.5}}, "a member of a member of x must be a whole number."}});
}

TEST(Arguments, may_be_left_out) {
  const Json none = Json::object(), given = {{"x", 1.5}, {"text", ""}, {"flag", false}};
  const Arguments arguments(none), others(given);
  EXPECT_EQ(arguments.get<std::optional<int>>("x"), std::nullopt);
  EXPECT_FALSE(arguments.has("x"));
  EXPECT_THROW(arguments.get<int>("x"), WrongType);
  EXPECT_THROW(arguments.get<std::vector<int>>("x"), WrongType);
  EXPECT_TRUE(others.has("x"));
  EXPECT_EQ(others.get<std::optional<double>>("x"), 1.5);
  EXPECT_EQ(others.get<std::optional<std::string>>("text"), "");
  EXPECT_EQ(others.get<std::optional<bool>>("flag"), false);
  EXPECT_THROW(others.get<std::optional<int>>("text"), WrongType);
  const Json mixed = {{"x", {1, nullptr}}, {"y", nullptr}};
  EXPECT_EQ(Arguments(mixed).get<std::vector<std::optional<int>>>("x"),
            (std::vector<std::optional<int>>{1, std::nullopt}));
  EXPECT_EQ(Arguments(mixed).get<std::optional<double>>("y"), std::nullopt);
}

Json result_of(Service& service, const Json& call, const Ask& ask = no_answer) {
  const Json outcome = service.call(call, ask);
  if (!outcome.contains("result")) ADD_FAILURE() << outcome;
  return outcome.value("result", Json());
}

Json parsed(Service& service, const std::string& bytes) {
  return result_of(service, parse_request(bytes));
}

std::string bytes_of_document(Service& service, const Json& document) {
  return bytes_of(result_of(service, request("bytes", {{"document", document}})));
}

/// Returns a result without what differs from run to run.
Json timeless(Json result) {
  EXPECT_GT(result["seconds"]["total"], 0);
  result.erase("seconds");
  return result;
}

/// What simplify() and preview() make of a document without the service.
struct Direct {
  explicit Direct(const std::string& bytes) : document(parse_document(bytes, "drawing.svg")) {
    run.resolution = 32;
    run.method = "best";
  }

  Json simplified() { return told(simplify(*document, {}, run, {}, writing)); }
  Json previewed() { return told(preview(*document, {}, run)); }

  std::unique_ptr<Document> document;
  RunOptions run;
  WriteOptions writing;

 private:
  Json told(const std::vector<MeshReport>& reports) {
    Json results = Json::array();
    for (const MeshReport& report : reports) {
      Json& result = results.emplace_back(timeless(result_json(*document, report, run, "")));
      result["changed"] = report.result.changed;
      result["refused"] = nullptr;
    }
    return results;
  }
};

Json simplified(Service& service, const Json& document, const Json& arguments) {
  Json results = result_of(service, simplify_request(document, arguments));
  for (Json& result : results) result = timeless(result);
  return results;
}

/// Options as arguments and as what they set.
struct Options {
  Json arguments;
  std::function<void(Direct&)> set;
};

const std::vector<Options> option_cases = {
    {Json::object(), [](Direct&) {}},
    {{{"epsilon", 0.03}}, [](Direct& d) { d.run.epsilon = 0.03; }},
    {{{"amount", "strong"}},
     [](Direct& d) {
       d.run.epsilon = 0.02, d.run.max_local_error = 0.1, d.run.max_detail_error = 0.3;
     }},
    {{{"metric", "ssim"}}, [](Direct& d) { d.run.metric = MetricKind::ssim; }},
    {{{"metric", "ssim"}, {"amount", "gentle"}},
     [](Direct& d) {
       d.run.metric = MetricKind::ssim, d.run.epsilon = 0.0025, d.run.max_local_error = 0.025;
       d.run.max_detail_error = 0.03;
     }},
    {{{"resolution", 64}}, [](Direct& d) { d.run.resolution = 64; }},
    {{{"max_local_error", 0.008}}, [](Direct& d) { d.run.max_local_error = 0.008; }},
    {{{"max_detail_error", 0.02}}, [](Direct& d) { d.run.max_detail_error = 0.02; }},
    // This method has found what is asked for at once.
    {{{"method", "lines"}, {"handles", 100}},
     [](Direct& d) { d.run.method = "lines", d.run.handles = 100; }},
    {{{"method", "lines"}, {"patches", 20}},
     [](Direct& d) { d.run.method = "lines", d.run.patches = 20; }},
    {{{"method", "lines"}, {"ratio", 0.5}},
     [](Direct& d) { d.run.method = "lines", d.run.ratio = 0.5; }},
    {{{"method", "lines"}, {"ratio", 0.4}, {"count", "handles"}},
     [](Direct& d) { d.run.method = "lines", d.run.ratio = 0.4, d.run.count = Count::handles; }},
    {{{"method", "manual"}, {"edges", {2}}},
     [](Direct& d) { d.run.method = "manual", d.run.edges = {2}; }},
    {{{"method", "simplest"}}, [](Direct& d) { d.run.method = "simplest"; }},
    {{{"method", "random"}}, [](Direct& d) { d.run.method = "random"; }},
    {{{"method", "random"}, {"seed", 7}},
     [](Direct& d) { d.run.method = "random", d.run.seed = 7; }},
    {{{"method", "gqe"}}, [](Direct& d) { d.run.method = "gqe"; }},
    {{{"method", "gqe"}, {"omega", 0.1}},
     [](Direct& d) { d.run.method = "gqe", d.run.omega = 0.1; }},
    {{{"method", "motorcycle"}, {"kappa", 0.9}},
     [](Direct& d) { d.run.method = "motorcycle", d.run.kappa = 0.9; }},
    {{{"remember_original", false}}, [](Direct& d) { d.writing.remember_original = false; }},
    {{{"keep_original", true}}, [](Direct& d) { d.writing.keep_original = true; }},
};

TEST(Service, simplifies_as_the_core_does) {
  const std::string bytes = sample("tensor.svg");
  std::vector<std::string> made = {bytes};
  for (const Options& options : option_cases) {
    SCOPED_TRACE(options.arguments);
    Direct expected(bytes);
    options.set(expected);
    Service service;
    const Json document = parsed(service, bytes);
    EXPECT_EQ(simplified(service, document, options.arguments), expected.simplified());
    EXPECT_EQ(bytes_of_document(service, document), expected.document->bytes());
    // Each of the options counts.
    EXPECT_EQ(std::ranges::count(made, expected.document->bytes()), 0);
    made.push_back(expected.document->bytes());
  }
}

TEST(Service, previews_as_the_core_does) {
  const std::string bytes = sample("tensor.svg");
  Service service;
  const Json document = parsed(service, bytes);
  const Json told = simplified(service, document, {{"preview", true}});
  EXPECT_EQ(told, Direct(bytes).previewed());
  EXPECT_TRUE(told[0]["changed"]);
  EXPECT_EQ(bytes_of_document(service, document), bytes);
}

TEST(Service, lists_the_options_with_the_cores_defaults) {
  Service service;
  const Json options = result_of(service, request("options", Json::object()));
  EXPECT_EQ(options.size(), all_options().size());
  const Json resolution = {{"default", 700}, {"least", 16}, {"most", 8192}};
  for (const auto& [name, value] : resolution.items())
    EXPECT_EQ(options["resolution"][name], value) << name;
  EXPECT_EQ(options["method"]["default"], "simplest");
  EXPECT_EQ(options["metric"]["names"], Json({"flip", "ssim"}));
  EXPECT_EQ(options["kappa"]["methods"], Json({"motorcycle"}));
  for (const char* const name : {"handles", "count", "color_model", "amount", "max_local_error"})
    EXPECT_EQ(options[name]["default"], nullptr) << name;
}

TEST(Service, refuses_what_the_core_refuses) {
  const std::string bytes = sample("tensor.svg");
  Service service;
  const Json document = parsed(service, bytes);
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Options> refusals = {
      {{{"resolution", 15}}, [](Direct& d) { d.run.resolution = 15; }},
      {{{"epsilon", -1}}, [](Direct& d) { d.run.epsilon = -1; }},
      {{{"epsilon", no_number}}, [&](Direct& d) { d.run.epsilon = no_number; }},
      {{{"handles", 9}, {"ratio", 0.5}}, [](Direct& d) { d.run.handles = 9, d.run.ratio = 0.5; }},
      {{{"threads", -1}}, [](Direct& d) { d.run.threads = -1; }},
      {{{"method", "magic"}}, [](Direct& d) { d.run.method = "magic"; }},
      {{{"edges", {3}}}, [](Direct& d) { d.run.edges = {3}; }},
  };
  for (const auto& [arguments, set] : refusals) {
    Direct direct(bytes);
    set(direct);
    const Json outcome = service.call(simplify_request(document, arguments), no_answer);
    EXPECT_EQ(outcome["error"], "value") << outcome;
    try {
      direct.simplified();
      ADD_FAILURE() << arguments;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(outcome["text"], error.what());
    }
  }
  std::vector<std::pair<Json, std::string>> words;
  for (const char* const name : {"metric", "method", "renderer", "count", "color_model", "amount"})
    words.push_back({{{name, "magic"}}, "magic"});
  for (const std::string& name : replaced_by_amount)
    words.push_back({{{"amount", "strong"}, {name, 1}}, "there is no " + name + "."});
  for (const auto& [arguments, word] : words) {
    const Json outcome = service.call(simplify_request(document, arguments), no_answer);
    EXPECT_EQ(outcome["error"], "value") << outcome;
    EXPECT_NE(outcome["text"].get<std::string>().find(word), std::string::npos) << outcome;
  }
  EXPECT_EQ(bytes_of_document(service, document), bytes);
}

TEST(Service, measures_against_another_document) {
  const std::string bytes = sample("tensor.svg");
  Service service;
  const Json original = parsed(service, bytes), document = parsed(service, bytes);
  result_of(service, simplify_request(document, {{"epsilon", 0.03}, {"remember_original", false}}));
  const std::string simpler = bytes_of_document(service, document);
  const auto error = [&](const Json& against) {
    const Json arguments = {
        {"epsilon", 0.05}, {"original", against}, {"preview", true}, {"method", "lines"}};
    return simplified(service, document, arguments)[0]["error"];
  };
  const auto expected = [&](const Document* against) {
    Direct direct(simpler);
    direct.run.epsilon = 0.05;
    direct.run.method = "lines";
    direct.document->measure_against(against);
    return direct.previewed()[0]["error"];
  };
  const auto direct_original = parse_document(bytes, "drawing.svg");
  EXPECT_EQ(error(original), expected(direct_original.get()));
  // What was measured against once is not from then on.
  EXPECT_EQ(error(nullptr), expected(nullptr));
  EXPECT_NE(error(nullptr), error(original));
}

TEST(Service, paints_and_tells_as_the_core_does) {
  const std::string bytes = sample("tensor.svg");
  const auto direct_document = parse_document(bytes, "drawing.svg");
  const MeshEntry entry = direct_document->meshes().front();
  Service service;
  const Json document = parsed(service, bytes);
  const Json named = {{"document", document}};
  EXPECT_EQ(result_of(service, request("info", named)), info_text(*direct_document));

  const Image image = render(*direct_document, entry, 40, *make_software_rasterizer());
  const Json picture =
      result_of(service, request("render", {{"document", document}, {"resolution", 40}}));
  EXPECT_EQ(picture["width"], image.width);
  EXPECT_EQ(picture["height"], image.height);
  EXPECT_EQ(std::max(image.width, image.height), 40);
  EXPECT_EQ(picture["bytes"], Json::binary(interleaved(image)));

  const auto compared = [&](const Json& test, int width) {
    return service.call(request("compare", {{"reference", picture["bytes"]},
                                            {"test", test},
                                            {"width", width},
                                            {"height", picture["height"]}}),
                        no_answer);
  };
  EXPECT_EQ(compared(picture["bytes"], image.width), Json({{"result", 0.0}}));
  const Json wrong = {{"error", "value"},
                      {"text", "a picture is an array of height x width x 3 bytes."}};
  EXPECT_EQ(compared(picture["bytes"], image.width + 1), wrong);
  EXPECT_EQ(compared(picture["bytes"], 0), wrong);
  EXPECT_EQ(compared(picture["bytes"], -image.width), wrong);
  EXPECT_EQ(compared(Json::binary({}), image.width), wrong);
}

TEST(Service, converts_to_documents_of_their_own) {
  Service service;
  const Json document = parsed(service, sample("tensor.svg"));
  const Json made =
      result_of(service, request("convert", {{"document", document}, {"kind", "hemesh"}}));
  EXPECT_NE(made["document"], document);
  EXPECT_EQ(made["patches"], 36);
  EXPECT_EQ(result_of(service, request("kind", {{"document", made["document"]}})), "hemesh");
  EXPECT_EQ(result_of(service, request("kind", {{"document", document}})), "svg");
  EXPECT_EQ(bytes_of_document(service, document), sample("tensor.svg"));
}

TEST(Service, is_not_ended_by_what_an_answer_gives_up) {
  Service service;
  const std::string bytes = sample("tensor.svg");
  const Json document = parsed(service, bytes);
  int asked = 0;
  const Json outcome = service.call(simplify_request(document), [&](const Json&) -> Json {
    if (++asked == 3) throw GivenUp();
    return true;
  });
  EXPECT_EQ(outcome["error"], "given up");
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(bytes_of_document(service, document), bytes);
}

TEST(Service, may_be_called_while_it_asks) {
  Service service;
  const std::string bytes = sample("tensor.svg");
  const Json document = parsed(service, bytes);
  int asked = 0;
  const Json outcome = service.call(simplify_request(document), [&](const Json&) -> Json {
    ++asked;
    // The document is in use by this very thread.
    EXPECT_EQ(bytes_of_document(service, document), bytes);
    return nullptr;
  });
  EXPECT_TRUE(outcome.contains("result"));
  EXPECT_GE(asked, 1);
  EXPECT_NE(bytes_of_document(service, document), bytes);
}

TEST(Service, calls_on_one_document_wait_for_each_other) {
  Service service;
  const std::string bytes = sample("tensor.svg");
  const Json document = parsed(service, bytes), other = parsed(service, bytes);
  std::future<std::string> same_one, other_one;
  const Json outcome = service.call(simplify_request(document), [&](const Json&) -> Json {
    if (!same_one.valid()) {
      const auto bytes_on_a_thread = [&](const Json& number) {
        return std::async(std::launch::async, bytes_of_document, std::ref(service), number);
      };
      same_one = bytes_on_a_thread(document);
      other_one = bytes_on_a_thread(other);
      // Another document is not in use.
      EXPECT_EQ(other_one.get(), bytes);
      EXPECT_EQ(same_one.wait_for(std::chrono::milliseconds(200)), std::future_status::timeout);
    }
    return nullptr;
  });
  EXPECT_TRUE(outcome.contains("result"));
  ASSERT_TRUE(same_one.valid());
  const std::string simplified = same_one.get();
  EXPECT_NE(simplified, bytes);
  EXPECT_EQ(simplified, bytes_of_document(service, document));
}

TEST(Service, a_document_that_is_released_in_use_lives_until_then) {
  Service service;
  const Json document = parsed(service, sample("tensor.svg"));
  Json releasing = request("hello", Json::object());
  releasing["release"] = Json::array({document});
  const Json outcome = service.call(simplify_request(document), [&](const Json&) -> Json {
    std::async(std::launch::async, result_of, std::ref(service), releasing, no_answer).get();
    return nullptr;
  });
  EXPECT_TRUE(outcome.contains("result")) << outcome;
  EXPECT_EQ(service.call(request("bytes", {{"document", document}}), no_answer)["error"], "value");
}

TEST(Service, serves_several_threads) {
  Service service;
  const std::string bytes = sample("tensor.svg");
  const Json shared = parsed(service, bytes);
  const Json quick = {{"method", "random"}, {"resolution", 16}};
  Direct direct(bytes);
  direct.run.method = "random";
  direct.run.resolution = 16;
  direct.simplified();
  const std::string simplified = direct.document->bytes();
  EXPECT_NE(simplified, bytes);
  const auto work = [&] {
    for (int i = 0; i < 4; ++i) {
      const Json own = parsed(service, bytes);
      result_of(service, simplify_request(own, quick));
      EXPECT_EQ(bytes_of_document(service, own), simplified);
      // All take the same document in both roles.
      Json changes = {{"original", shared}, {"preview", true}};
      changes.update(quick);
      result_of(service, simplify_request(i % 2 ? own : shared, changes));
      EXPECT_EQ(bytes_of_document(service, shared), bytes);
      Json releasing = request("ids", {{"document", shared}});
      releasing["release"] = Json::array({own});
      EXPECT_EQ(result_of(service, releasing), Json::array({"silk"}));
    }
  };
  { std::jthread one(work), another(work); }
  // Two documents in either order.
  const Json second = parsed(service, bytes);
  const auto cross = [&](const Json& document, const Json& original) {
    for (int i = 0; i < 50; ++i)
      EXPECT_EQ(
          service.call(simplify_request(document, {{"original", original}, {"resolution", 15}}),
                       no_answer)["error"],
          "value");
  };
  std::jthread one(cross, shared, second), another(cross, second, shared);
}

}  // namespace
}  // namespace gradmesh
