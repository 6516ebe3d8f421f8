#include "service/service.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <limits>
#include <optional>
#include <thread>

#include "app/runs.h"
#include "app/info.h"
#include "base/error.h"
#include "raster/rasterizer.h"
#include "requests.h"

namespace gradmesh {
namespace {

using test::bytes_of;
using test::parse_request;
using test::request;
using test::sample;
using test::simplify_request;

constexpr auto whole = "x must be a whole number.", below = "x must be below 2^31.",
               not_negative = "x must be a whole number that is not negative.";

/// Returns the argument x, or why it is refused as a T.
template <class T>
T taken(const Json& value) {
  const Json arguments = {{"x", value}};
  return Arguments(arguments).get<T>("x");
}
template <class T>
std::string refused(const Json& value) {
  try {
    taken<T>(value);
  } catch (const WrongType& error) {
    return error.what();
  }
  return "";
}

/// Values of all types.
const Json one_of_each = {nullptr,       true,          1, -1, 1.5, "text", Json::binary({1}),
                          Json::array(), Json::object()};

/// Expects that of `one_of_each` those are refused that are not of the types that `takes` says.
template <class T, class Takes>
void expect_refusals(const std::string& text, const Takes& takes) {
  for (const Json& value : one_of_each)
    EXPECT_EQ(refused<T>(value), takes(value) ? "" : text) << value;
}

TEST(Arguments, have_names) {
  for (const Json& value : one_of_each)
    if (!value.is_object()) {
      EXPECT_THROW(Arguments{value}, WrongType) << value;
    }
}

TEST(Arguments, are_true_or_false) {
  EXPECT_TRUE(taken<bool>(true));
  EXPECT_FALSE(taken<bool>(false));
  expect_refusals<bool>("x must be true or false.", [](auto& v) { return v.is_boolean(); });
}

TEST(Arguments, are_whole_numbers) {
  using Limits = std::numeric_limits<int>;
  for (const int number : {0, 1, -1, Limits::max(), Limits::min()}) {
    EXPECT_EQ(taken<int>(number), number);
    EXPECT_EQ(taken<int>(Json::parse(std::to_string(number))), number);
  }
  for (const char* const number :
       {"2147483648", "-2147483649", "4294967296", "4294967295", "9223372036854775808",
        "18446744073709551615", "-9223372036854775808"})
    EXPECT_EQ(refused<int>(Json::parse(number)), below) << number;
  // Positive, but of the type of negative numbers.
  EXPECT_EQ(refused<int>(std::int64_t(1) << 31), below);
  EXPECT_EQ(refused<int>(std::int64_t(1) << 32), below);
  EXPECT_EQ(refused<int>(Json::parse("1e3")), whole);
  EXPECT_EQ(refused<int>(Json::parse("18446744073709551616")), whole);
  expect_refusals<int>(whole, [](auto& v) { return v.is_number_integer(); });
}

TEST(Arguments, are_whole_numbers_that_are_not_negative) {
  using Limits = std::numeric_limits<std::uint64_t>;
  EXPECT_EQ(taken<std::uint64_t>(Limits::max()), Limits::max());
  EXPECT_EQ(taken<std::uint64_t>(0u), 0u);
  EXPECT_EQ(taken<std::uint64_t>(std::int64_t(7)), 7u);
  EXPECT_EQ(refused<std::uint64_t>(std::numeric_limits<std::int64_t>::min()), not_negative);
  EXPECT_EQ(refused<std::uint64_t>(Json::parse("18446744073709551616")), not_negative);
  expect_refusals<std::uint64_t>(not_negative,
                                 [](auto& v) { return v.is_number_integer() && v == 1; });
}

TEST(Arguments, are_numbers) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double number : {0.0, -1.5, 1e300, infinity, -infinity})
    EXPECT_EQ(taken<double>(number), number);
  EXPECT_EQ(taken<double>(3), 3.0);
  EXPECT_EQ(taken<double>(std::uint64_t(1) << 63), 0x1p63);
  expect_refusals<double>("x must be a number.", [](auto& v) { return v.is_number(); });
}

TEST(Arguments, are_texts) {
  EXPECT_EQ(taken<std::string>("ä"), "ä");
  EXPECT_EQ(taken<std::string>(""), "");
  EXPECT_EQ(taken<std::string>(std::string("a\0b", 3)), std::string("a\0b", 3));
  expect_refusals<std::string>("x must be a text.", [](auto& v) { return v.is_string(); });
}

TEST(Arguments, are_bytes) {
  const std::string bytes("\0\xff<svg", 6);
  EXPECT_EQ(taken<Bytes>(test::bytes_json(bytes)).bytes, bytes);
  EXPECT_EQ(taken<Bytes>(Json::binary({})).bytes, "");
  expect_refusals<Bytes>("x must be bytes.", [](auto& v) { return v.is_binary(); });
}

TEST(Arguments, may_be_left_out) {
  const Json none = Json::object();
  const Arguments arguments(none);
  EXPECT_EQ(arguments.get<std::optional<int>>("x"), std::nullopt);
  EXPECT_THROW(arguments.get<int>("x"), WrongType);
  EXPECT_THROW(arguments.get<std::vector<int>>("x"), WrongType);
  EXPECT_EQ(taken<std::optional<double>>(nullptr), std::nullopt);
  EXPECT_EQ(taken<std::optional<double>>(1.5), 1.5);
  EXPECT_EQ(taken<std::optional<std::string>>(""), "");
  EXPECT_EQ(taken<std::optional<bool>>(false), false);
  EXPECT_EQ(refused<std::optional<int>>("1"), whole);
}

TEST(Arguments, are_lists) {
  EXPECT_EQ(taken<std::vector<int>>(Json::array()), std::vector<int>{});
  EXPECT_EQ(taken<std::vector<int>>({3, -1}), (std::vector{3, -1}));
  EXPECT_EQ(taken<std::vector<std::string>>({"a", "b"}), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(taken<std::vector<std::optional<int>>>({1, nullptr}),
            (std::vector<std::optional<int>>{1, std::nullopt}));
  EXPECT_EQ(refused<std::vector<int>>({1, "2"}), "a member of x must be a whole number.");
  EXPECT_EQ(refused<std::vector<int>>({1, nullptr}), "a member of x must be a whole number.");
  EXPECT_EQ(refused<std::vector<std::vector<int>>>({{1}, {1.5}}),
            "a member of a member of x must be a whole number.");
  expect_refusals<std::vector<int>>("x must be a list.", [](auto& v) { return v.is_array(); });
}

Json no_answer(const Json& /*question*/) { return nullptr; }

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

void expect_same(const Json& json, const MeshReport& report) {
  const SimplifyResult& r = report.result;
  EXPECT_EQ(json["id"], report.id);
  EXPECT_EQ(json["method"], r.method);
  EXPECT_EQ(json["handles_before"], r.handles_before);
  EXPECT_EQ(json["handles_after"], r.handles_after);
  EXPECT_EQ(json["patches_before"], r.patches_before);
  EXPECT_EQ(json["patches_after"], r.patches_after);
  EXPECT_EQ(json["objects"], r.objects);
  EXPECT_EQ(json["changed"], r.changed);
  EXPECT_EQ(json["error"], r.error);
  EXPECT_EQ(json["local_error"], r.local_error);
  EXPECT_EQ(json["evaluations"], r.evaluations);
  EXPECT_EQ(json["renderer"], r.renderer);
  EXPECT_EQ(json["stopped"], name(r.stopped));
  EXPECT_GT(json["seconds"], 0);
  EXPECT_EQ(json["refused"], nullptr);
  EXPECT_EQ(json.size(), 15u) << json;
}

/// The same options in both forms.
struct Options {
  Json arguments = Json::object();
  std::function<void(RunOptions&, WriteOptions&)> set = [](RunOptions&, WriteOptions&) {};
};

/// What simplify() makes of a document without the service.
struct Direct {
  std::string bytes;
  std::vector<MeshReport> reports;
};

Direct direct(const std::string& bytes, const Options& options) {
  RunOptions run;
  WriteOptions writing;
  run.resolution = 32;
  run.method = "best";
  options.set(run, writing);
  const auto document = Document::parse(bytes, "drawing.svg");
  Direct result;
  result.reports = simplify(*document, {}, run, {}, writing);
  result.bytes = document->bytes();
  return result;
}

const std::vector<Options> all_options = {
    {{{"epsilon", 0.03}}, [](auto& run, auto&) { run.epsilon = 0.03; }},
    {{{"metric", "ssim"}}, [](auto& run, auto&) { run.metric = MetricKind::ssim; }},
    {{{"resolution", 64}}, [](auto& run, auto&) { run.resolution = 64; }},
    {{{"max_local_error", 0.008}}, [](auto& run, auto&) { run.max_local_error = 0.008; }},
    // This method has found what is asked for at once.
    {{{"method", "lines"}, {"handles", 100}},
     [](auto& run, auto&) { run.method = "lines", run.handles = 100; }},
    {{{"method", "lines"}, {"patches", 20}},
     [](auto& run, auto&) { run.method = "lines", run.patches = 20; }},
    {{{"method", "lines"}, {"ratio", 0.5}},
     [](auto& run, auto&) { run.method = "lines", run.ratio = 0.5; }},
    {{{"method", "lines"}, {"ratio", 0.4}, {"count", "handles"}},
     [](auto& run, auto&) { run.method = "lines", run.ratio = 0.4, run.count = Count::handles; }},
    {{{"method", "manual"}, {"edges", {2}}},
     [](auto& run, auto&) { run.method = "manual", run.edges = {2}; }},
    {{{"method", "simplest"}}, [](auto& run, auto&) { run.method = "simplest"; }},
    {{{"method", "random"}}, [](auto& run, auto&) { run.method = "random"; }},
    {{{"method", "random"}, {"seed", 7}},
     [](auto& run, auto&) { run.method = "random", run.seed = 7; }},
    {{{"method", "gqe"}}, [](auto& run, auto&) { run.method = "gqe"; }},
    {{{"method", "gqe"}, {"omega", 0.1}},
     [](auto& run, auto&) { run.method = "gqe", run.omega = 0.1; }},
    {{{"method", "motorcycle"}, {"kappa", 0.9}},
     [](auto& run, auto&) { run.method = "motorcycle", run.kappa = 0.9; }},
    {{{"remember_original", false}},
     [](auto&, auto& writing) { writing.remember_original = false; }},
    {{{"keep_original", true}}, [](auto&, auto& writing) { writing.keep_original = true; }},
};

TEST(Service, simplifies_as_the_core_does) {
  const std::string bytes = sample("tensor.svg");
  std::vector<std::string> made = {bytes, direct(bytes, {}).bytes};
  for (const Options& options : all_options) {
    SCOPED_TRACE(options.arguments);
    const Direct expected = direct(bytes, options);
    Service service;
    const Json document = parsed(service, bytes);
    const Json result = result_of(service, simplify_request(document, options.arguments));
    EXPECT_EQ(result["document"], nullptr);
    ASSERT_EQ(result["meshes"].size(), expected.reports.size());
    expect_same(result["meshes"][0], expected.reports[0]);
    EXPECT_EQ(bytes_of_document(service, document), expected.bytes);
    // Each of the options counts.
    EXPECT_EQ(std::ranges::count(made, expected.bytes), 0);
    made.push_back(expected.bytes);
  }
}

TEST(Service, previews_as_the_core_does) {
  const std::string bytes = sample("tensor.svg");
  RunOptions run;
  run.resolution = 32;
  run.method = "best";
  const auto expected = preview(*Document::parse(bytes, "drawing.svg"), {}, run);
  Service service;
  const Json document = parsed(service, bytes);
  const Json result = result_of(service, simplify_request(document, {{"preview", true}}));
  ASSERT_EQ(result["meshes"].size(), 1u);
  expect_same(result["meshes"][0], expected[0]);
  EXPECT_TRUE(expected[0].result.changed);
  EXPECT_EQ(bytes_of_document(service, document), bytes);
}

TEST(Service, refuses_what_the_core_refuses) {
  const std::string bytes = sample("tensor.svg");
  Service service;
  const Json document = parsed(service, bytes);
  const auto run = [](const auto& change) {
    RunOptions options;
    options.resolution = 32;
    change(options);
    return options;
  };
  const auto refusal = [&](const RunOptions& options) -> std::string {
    try {
      simplify(*Document::parse(bytes, "drawing.svg"), {}, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const auto expect_refused = [&](const Json& arguments, const RunOptions& options) {
    const Json outcome = service.call(simplify_request(document, arguments), no_answer);
    EXPECT_EQ(outcome, Json({{"error", "value"}, {"text", refusal(options)}}));
    EXPECT_NE(outcome["text"], "");
  };
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  expect_refused({{"resolution", 15}}, run([](auto& o) { o.resolution = 15; }));
  expect_refused({{"epsilon", -1}}, run([](auto& o) { o.epsilon = -1; }));
  expect_refused({{"epsilon", no_number}}, run([&](auto& o) { o.epsilon = no_number; }));
  expect_refused({{"handles", 9}, {"ratio", 0.5}},
                 run([](auto& o) { o.handles = 9, o.ratio = 0.5; }));
  expect_refused({{"threads", -1}}, run([](auto& o) { o.threads = -1; }));
  expect_refused({{"method", "magic"}}, run([](auto& o) { o.method = "magic"; }));
  expect_refused({{"edges", {3}}}, run([](auto& o) { o.edges = {3}; }));
  for (const char* const name : {"metric", "method", "renderer", "count", "color_model", "kind"}) {
    const Json outcome = service.call(simplify_request(document, {{name, "magic"}}), no_answer);
    EXPECT_EQ(outcome["error"], "value") << outcome;
    EXPECT_NE(outcome["text"].get<std::string>().find("magic"), std::string::npos) << outcome;
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
    const Json result = result_of(service, simplify_request(document, {{"epsilon", 0.05},
                                                                       {"original", against},
                                                                       {"preview", true},
                                                                       {"method", "lines"}}));
    return result["meshes"][0]["error"].get<double>();
  };
  RunOptions run;
  run.resolution = 32;
  run.epsilon = 0.05;
  run.method = "lines";
  const auto expected = [&](const Document* against) {
    const auto direct_document = Document::parse(simpler, "drawing.svg");
    direct_document->measure_against(against);
    return preview(*direct_document, {}, run)[0].result.error;
  };
  const auto direct_original = Document::parse(bytes, "drawing.svg");
  EXPECT_EQ(error(original), expected(direct_original.get()));
  // What was measured against once is not from then on.
  EXPECT_EQ(error(nullptr), expected(nullptr));
  EXPECT_NE(error(nullptr), error(original));
}

TEST(Service, paints_and_tells_as_the_core_does) {
  const std::string bytes = sample("tensor.svg");
  const auto direct_document = Document::parse(bytes, "drawing.svg");
  const MeshEntry entry = direct_document->meshes().front();
  Service service;
  const Json document = parsed(service, bytes);
  const Json named = {{"document", document}};
  EXPECT_EQ(result_of(service, request("info", named)), info_text(*direct_document));

  const Image image = direct_document->render(entry, 40, *make_software_rasterizer());
  const Json picture = result_of(service, request("render", {{"document", document},
                                                             {"id", nullptr},
                                                             {"resolution", 40},
                                                             {"like_inkscape", false},
                                                             {"framed_as", nullptr}}));
  EXPECT_EQ(picture["width"], image.width);
  EXPECT_EQ(picture["height"], image.height);
  EXPECT_EQ(std::max(image.width, image.height), 40);
  EXPECT_EQ(picture["bytes"], Json::binary(interleaved(image)));

  const auto compared = [&](const Json& test, int width) {
    return service.call(request("compare", {{"reference", picture["bytes"]},
                                            {"test", test},
                                            {"width", width},
                                            {"height", picture["height"]},
                                            {"metric", "flip"}}),
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
  const Json made = result_of(service, request("convert", {{"document", document},
                                                           {"kind", "hemesh"},
                                                           {"id", nullptr},
                                                           {"subdivide", nullptr},
                                                           {"epsilon", nullptr},
                                                           {"metric", "flip"},
                                                           {"resolution", 32}}));
  EXPECT_NE(made["document"], document);
  EXPECT_EQ(made["patches"], 36);
  EXPECT_EQ(result_of(service, request("kind", {{"document", made["document"]}})), "hemesh");
  EXPECT_EQ(result_of(service, request("kind", {{"document", document}})), "svg");
  // A run with another kind leaves its own document as it is.
  const Json run = result_of(service, simplify_request(document, {{"kind", "hemesh"}}));
  EXPECT_EQ(result_of(service, request("kind", {{"document", run["document"]}})), "hemesh");
  EXPECT_TRUE(run["meshes"][0]["changed"]);
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
  const Options quick = {{{"method", "random"}, {"resolution", 16}},
                         [](auto& run, auto&) { run.method = "random", run.resolution = 16; }};
  const std::string simplified = direct(bytes, quick).bytes;
  EXPECT_NE(simplified, bytes);
  const auto work = [&] {
    for (int i = 0; i < 4; ++i) {
      const Json own = parsed(service, bytes);
      result_of(service, simplify_request(own, quick.arguments));
      EXPECT_EQ(bytes_of_document(service, own), simplified);
      // All take the same document in both roles.
      Json changes = {{"original", shared}, {"preview", true}};
      changes.update(quick.arguments);
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
