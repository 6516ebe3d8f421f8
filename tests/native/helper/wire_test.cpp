#include "helper/wire.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <new>
#include <random>
#include <sstream>

namespace {

/// The most bytes that were asked for at once.
std::atomic<std::size_t> largest = 0;

void* allocate(std::size_t size) {
  std::size_t before = largest;
  while (before < size && !largest.compare_exchange_weak(before, size)) {
  }
  void* const memory = std::malloc(size ? size : 1);
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace gradmesh {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const double no_number = std::numeric_limits<double>::quiet_NaN();

/// Returns what a message is for whoever reads what was written.
Json sent(const Json& message) {
  std::stringstream stream;
  write_message(stream, message);
  const std::optional<Json> read = read_message(stream);
  EXPECT_TRUE(read);
  EXPECT_EQ(read_message(stream), std::nullopt);
  return read.value_or(Json());
}

/// Returns true if both are of the same type and, with the sign of 0, of the same value; NaNs are.
bool same(const Json& a, const Json& b) {
  if (a.type() != b.type() || a.size() != b.size()) return false;
  if (a.is_number_float()) {
    const auto x = a.get<double>(), y = b.get<double>();
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) ||
           (std::isnan(x) && std::isnan(y));
  }
  if (a.is_array()) return std::ranges::equal(a, b, same);
  if (!a.is_object()) return a == b;
  return std::ranges::all_of(a.items(), [&](const auto& member) {
    return b.contains(member.key()) && same(member.value(), b[member.key()]);
  });
}

std::string frame(const std::string& text) { return std::to_string(text.size()) + "\n" + text; }

/// Returns why this cannot be read, whatever can be read before it; empty if all can be.
std::string refused(const std::string& bytes) {
  std::istringstream stream(bytes);
  try {
    while (read_message(stream)) {
    }
  } catch (const Garbled& error) {
    return error.what();
  }
  return "";
}

TEST(Wire, a_message_is_its_length_and_json) {
  std::ostringstream stream;
  write_message(stream, {{"call", "hello"}});
  EXPECT_EQ(stream.str(), "16\n{\"call\":\"hello\"}");
  // The length is that of bytes, not of letters.
  std::ostringstream umlaut;
  write_message(umlaut, "ä");
  EXPECT_EQ(umlaut.str(), "4\n\"ä\"");
}

TEST(Wire, values_arrive_as_they_are) {
  using Int = std::numeric_limits<std::int64_t>;
  using Unsigned = std::numeric_limits<std::uint64_t>;
  using Double = std::numeric_limits<double>;
  const std::string texts = std::string("\0\x01\n\r\t\"\\/\x7f", 9) + "ä€𝄞\u2028";
  for (const Json& value : {Json(),
                            Json(true),
                            Json(false),
                            Json(std::uint64_t(0)),
                            Json(std::int64_t(-1)),
                            Json(Int::min()),
                            Json(std::uint64_t(Int::max())),
                            Json(Unsigned::max()),
                            Json(0.0),
                            Json(-0.0),
                            Json(0.1),
                            Json(1e22),
                            Json(Double::max()),
                            Json(Double::lowest()),
                            Json(Double::min()),
                            Json(Double::denorm_min()),
                            Json(""),
                            Json(texts),
                            Json::array(),
                            Json::object(),
                            Json::array({1.5, "a", nullptr, Json::array()}),
                            Json::object({{"", ""}, {texts, 1.5}, {"a", Json::object()}})}) {
    EXPECT_TRUE(same(sent(value), value)) << value;
    EXPECT_TRUE(same(sent({{"in", {value, "a list"}}}), {{"in", {value, "a list"}}})) << value;
  }
}

TEST(Wire, bytes_arrive_as_they_are) {
  std::vector<std::uint8_t> all(256);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::uint8_t(i);
  EXPECT_EQ(sent(Json::binary(all)), Json::binary(all));
  // Every number of bytes modulo 3, as base64 takes three at a time.
  for (const std::size_t size : {0, 1, 2, 3, 4}) {
    const Json bytes = Json::binary({all.end() - std::ptrdiff_t(size), all.end()});
    EXPECT_EQ(sent(bytes), bytes);
    EXPECT_EQ(sent({{"document", bytes}})["document"], bytes);
  }
  EXPECT_EQ(message_text(Json::binary({'M', 'a'})), "{\"base64\":\"TWE=\"}");
}

TEST(Wire, numbers_that_are_not_finite_arrive_as_they_are) {
  for (const double number : {infinity, -infinity, no_number, -no_number}) {
    EXPECT_TRUE(same(sent(number), number)) << number;
    EXPECT_TRUE(same(sent({{"epsilon", {number}}}), {{"epsilon", {number}}})) << number;
  }
  EXPECT_EQ(message_text(infinity), "{\"number\":\"inf\"}");
  EXPECT_EQ(message_text(-infinity), "{\"number\":\"-inf\"}");
  EXPECT_EQ(message_text(no_number), "{\"number\":\"nan\"}");
}

TEST(Wire, objects_that_only_resemble_bytes_and_numbers_stay_as_they_are) {
  for (const char* const text :
       {R"({"base64":5})", R"({"base64":null})", R"({"base64":["TWE="]})", R"({"number":3})",
        R"({"number":{}})", R"({"base64":"TWE=","number":"inf"})", R"({"Base64":"TWE="})",
        R"({"base64":{"other":"TWE="}})", R"(["base64","TWE="])"}) {
    EXPECT_TRUE(same(text_message(text), Json::parse(text))) << text;
    EXPECT_TRUE(same(sent(text_message(text)), Json::parse(text))) << text;
  }
  // What is inside is looked at first, and is then no text any more.
  EXPECT_EQ(text_message(R"({"base64":{"base64":"TWE="}})"),
            Json::object({{"base64", Json::binary({'M', 'a'})}}));
}

TEST(Wire, what_is_no_utf8_is_replaced) {
  EXPECT_EQ(sent("a\xff"
                 "b"),
            "a\uFFFD"
            "b");
  EXPECT_EQ(sent("\xed\xa0\x80").get<std::string>().find('\xed'), std::string::npos);
  EXPECT_EQ(sent({{"\xc3", 1.5}}), Json::object({{"\uFFFD", 1.5}}));
}

TEST(Wire, messages_follow_each_other) {
  std::istringstream stream("2\n{}0000000004\ntrue 3\n 1 5\n\"end\"");
  EXPECT_EQ(read_message(stream), Json::object());
  EXPECT_EQ(read_message(stream), true);
  // A blank is no digit.
  EXPECT_THROW(read_message(stream), Garbled);
  std::istringstream others("3\n 1 5\n\"end\"");
  EXPECT_EQ(read_message(others), 1);
  EXPECT_EQ(read_message(others), "end");
  EXPECT_EQ(read_message(others), std::nullopt);
  EXPECT_EQ(read_message(others), std::nullopt);
}

/// Returns what is refused for one reason.
struct Refused {
  std::string reason;
  std::vector<std::string> bytes;
};

/// Returns JSON inside of as many brackets.
std::string nested(std::size_t depth, const std::string& open, const std::string& close) {
  std::string text = "1";
  for (std::size_t i = 0; i < depth; ++i) text += close;
  std::string opened;
  for (std::size_t i = 0; i < depth; ++i) opened += open;
  return frame(opened + text);
}

/// Returns the messages with these texts, in quotes after a name where there is one.
std::vector<std::string> frames(const std::vector<std::string>& texts, const char* name = nullptr) {
  std::vector<std::string> all;
  for (const std::string& text : texts)
    all.push_back(frame(name ? "[{\"" + std::string(name) + "\":\"" + text + "\"}]" : text));
  return all;
}

TEST(Wire, what_is_no_message_is_garbled) {
  const auto nul = [](const char* before) { return before + std::string("\0", 1); };
  std::vector<Refused> all = {
      {"a message has no length.",
       {"\n", "\n{}", "{}", " 2\n{}", "2 \n{}", "2\r\n{}", "-2\n{}", "+2\n{}", "2.0\n{}", "0x2\n{}",
        "2{}", "a\n{}", "\xff",
        "\xef\xbb\xbf"
        "2\n{}",
        nul(""),
        // Too many digits, of a small number too, and of one that would not fit.
        "00000000002\n{}", "99999999999\n", "18446744073709551618\n{}",
        // Of the second message as well as of the first.
        "2\n{}x", "2\n{}\n2\n{}",
        // Above the limit.
        std::to_string(most_message_bytes + 1) + "\n{}", "9999999999\n{}"}},
      {"a message ends within its length.", {"1", "0000000002"}},
      {"a message is shorter than its length.", {std::to_string(most_message_bytes) + "\n{}"}},
      {"a message is no JSON.", frames({"",
                                        " ",
                                        "{",
                                        "{}}",
                                        "{}{}",
                                        "{} x",
                                        "{} 1",
                                        "[1,]",
                                        "[1 2]",
                                        "{1:2}",
                                        "{\"a\"}",
                                        "'a'",
                                        "nan",
                                        "NaN",
                                        "Infinity",
                                        "tru",
                                        "01",
                                        "1.",
                                        ".5",
                                        "+1",
                                        "1e999",
                                        "-1e999",
                                        "\"a",
                                        "\"\n\"",
                                        "\"\\x\"",
                                        "\"\\ud800\"",
                                        "\"\xff\"",
                                        "\"\xc0\x80\"",
                                        "\"\xed\xa0\x80\"",
                                        "/**/1",
                                        "\xff",
                                        nul("1")})},
      {"bytes are no base64.",
       frames({"=", "A", "AA", "AAA", "A===", "====", "AA=A", "=AAA", "AA==AA==", "AA A", "AAA\\n",
               "AA-_", "AAAAA", "ä==", "A\\u0000=="},
              "base64")},
      // The last are so deep that whoever read them to the end would run out of stack.
      {"a message is nested too deep.",
       {nested(33, "[", "]"), nested(33, "{\"a\":", "}"), nested(1000000, "[", "]"),
        nested(1000000, "{\"a\":[", "]}")}},
      {"", {nested(32, "[", "]"), nested(32, "{\"a\":", "}")}}};
  for (const char* const name : {"", "1", "1.5", "NaN", "Inf", "+inf", "infinity", "-nan", "inf "})
    all.push_back({"'" + std::string(name) + "' is no number.", frames({name}, "number")});
  const std::string whole = frame(R"({"call":"hello","arguments":{}})");
  for (std::size_t size = whole.find('\n') + 1; size < whole.size(); ++size)
    all[2].bytes.push_back(whole.substr(0, size));
  EXPECT_EQ(refused(whole), "");
  for (const auto& [reason, messages] : all)
    for (const std::string& bytes : messages)
      EXPECT_EQ(refused(bytes), reason) << bytes.substr(0, 99);
}

TEST(Wire, a_message_takes_no_more_memory_than_there_are_bytes) {
  const std::string claim = std::to_string(most_message_bytes) + "\n";
  constexpr std::size_t million = 1000000;
  std::istringstream few(claim + "{}"), many(claim + std::string(5 * million, ' '));
  largest = 0;
  EXPECT_THROW(read_message(few), Garbled);
  EXPECT_LE(largest, 2 * million);
  EXPECT_THROW(read_message(many), Garbled);
  EXPECT_LE(largest, 15 * million);
  // So much for the measure.
  largest = 0;
  const std::string text(5 * million, ' ');
  EXPECT_GT(largest, text.size());
}

TEST(Wire, long_messages_arrive_whole) {
  // Around the size of the parts in which they are read, 1 MiB, with the two quotation marks.
  for (const std::size_t size : {(1u << 20) - 3, (1u << 20) - 2, (1u << 20) - 1, 3u << 20}) {
    const Json text = std::string(size, 'x');
    EXPECT_TRUE(sent(text) == text) << size;
  }
}

/// Values at random, of all kinds and of any bits.
class RandomValues {
 public:
  explicit RandomValues(unsigned seed) : random_(seed) {}

  Json value(int depth = 0) {
    switch (below(depth < 6 ? 8 : 6)) {
      case 0:
        return Json::array({nullptr, true, false})[below(3)];
      case 1:
        return bits();
      case 2:
        return -std::int64_t(bits() >> (1 + below(63))) - 1;
      case 3:
        return Json::array({double(bits()), -infinity, std::bit_cast<double>(random_())})[below(3)];
      case 4:
        return text();
      case 5: {
        const std::string bytes = text();
        return Json::binary({bytes.begin(), bytes.end()});
      }
      case 6:
        return list(depth);
      default:
        return object(depth);
    }
  }

 private:
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }
  std::uint64_t bits() { return random_() >> below(64); }

  /// Any characters but the surrogates, which are none, in UTF-8.
  std::string text() {
    std::u32string text;
    for (std::size_t i = below(10); i > 0; --i) {
      const std::size_t c = below(std::size_t(1) << (5 * below(4) + 6)) % 0x110000;
      text += char32_t(c >= 0xd800 && c < 0xe000 ? c - 0x800 : c);
    }
    const std::u8string utf8 = std::filesystem::path(text).u8string();
    return {utf8.begin(), utf8.end()};
  }

  Json list(int depth) {
    Json list = Json::array();
    for (std::size_t i = below(6); i > 0; --i) list.push_back(value(depth + 1));
    return list;
  }

  /// The names of bytes and numbers are there too, but no text stands alone under them: that is
  /// what bytes and numbers are.
  Json object(int depth) {
    Json object = Json::object();
    for (std::size_t i = below(5); i > 0; --i) {
      const std::string names[] = {"base64", "number", "answer", text()};
      object[names[below(4)]] = value(depth + 1);
    }
    for (const char* const name : {"base64", "number"})
      if (object.size() == 1 && object.contains(name) && object[name].is_string())
        object["other"] = nullptr;
    return object;
  }

  std::mt19937_64 random_;
};

TEST(Wire, any_value_arrives_as_it_is) {
  RandomValues values(1);
  std::size_t large = 0;
  for (int i = 0; i < 2000; ++i) {
    Json value = Json::array();
    for (int k = 0; k < 20; ++k) value.push_back(values.value());
    const std::string text = message_text(value);
    ASSERT_TRUE(same(text_message(text), value)) << text;
    ASSERT_TRUE(same(sent(value), value)) << text;
    large += text.size() > 500;
  }
  EXPECT_GT(large, 500u);
}

}  // namespace
}  // namespace gradmesh
