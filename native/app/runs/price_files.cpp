#include "app/runs/price_files.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/error.h"
#include "base/hash.h"
#include "files/atomic_file.h"
#include "ops/merge/region_finder.h"
#include "simplify/options.h"

namespace gradmesh {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format = "gradmesh analysis";
constexpr int version = 2;

std::string hex(std::uint64_t number) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(number));
  return digits;
}

std::uint64_t number_of(const std::string& hex_digits) {
  std::size_t used = 0;
  const std::uint64_t number = std::stoull(hex_digits, &used, 16);
  if (used != hex_digits.size()) throw std::invalid_argument("not a hexadecimal number");
  return number;
}

/// Returns the number as an int. Json::get would convert a number that is no int in an undefined
/// way.
int whole_number(const Json& json) {
  if (!json.is_number_integer()) throw std::invalid_argument("not a whole number");
  const auto number = json.get<std::int64_t>();
  if (number != int(number)) throw std::out_of_range("not an int");
  return int(number);
}

/// Returns the checksum of the values, however they are laid out in the file.
std::string checksum(const Json& analyses) {
  Hash hash;
  hash.add(analyses.dump());
  return hex(hash.value());
}

Json to_json(const PriceTable& analysis) {
  Json prices = Json::array();
  for (const auto& [region, price] : analysis.prices)
    prices.push_back(
        {region.face.value, region.top, region.rows, region.columns, price.error, price.exact});
  const PriceTableKey& key = analysis.key;
  return {{"original", hex(key.original)},
          {"content", hex(key.content)},
          {"metric", name(key.metric)},
          {"width", key.width},
          {"height", key.height},
          {"color_model", name(key.color_model)},
          {"prices", prices}};
}

/// Reads an analysis. Throws one of the standard exceptions if something is missing or of another
/// type.
PriceTable from_json(const Json& json) {
  PriceTable analysis;
  analysis.key = {number_of(json.at("original").get<std::string>()),
                  number_of(json.at("content").get<std::string>()),
                  metric_named(json.at("metric").get<std::string>()),
                  whole_number(json.at("width")),
                  whole_number(json.at("height")),
                  color_model_named(json.at("color_model").get<std::string>())};
  for (const Json& price : json.at("prices")) {
    const Region region{Face{whole_number(price.at(0))}, whole_number(price.at(1)),
                        whole_number(price.at(2)), whole_number(price.at(3))};
    // JSON knows no infinity: null stands for it.
    const double error =
        price.at(4).is_null() ? std::numeric_limits<double>::infinity() : price.at(4).get<double>();
    analysis.prices[region] = {error, price.at(5).get<bool>()};
  }
  return analysis;
}

/// Returns the error that says how the key of an analysis differs from the one that is wanted.
InputError other_key(const std::string& file, const PriceTableKey& found,
                     const PriceTableKey& wanted) {
  if (found.original != wanted.original)
    return InputError("{0}: this analysis is of another mesh, or the mesh was changed since.",
                      file);
  if (found.metric != wanted.metric)
    return InputError("{0}: this analysis was made with the metric {1}, not {2}.", file,
                      name(found.metric), name(wanted.metric));
  if (found.color_model != wanted.color_model)
    return InputError("{0}: this analysis was made in the color model {1}, not {2}.", file,
                      name(found.color_model), name(wanted.color_model));
  if (found.width != wanted.width || found.height != wanted.height)
    return InputError("{0}: this analysis was made at {1} x {2} pixels, not {3} x {4} pixels.",
                      file, found.width, found.height, wanted.width, wanted.height);
  return InputError(
      "{0}: this analysis was made before the mesh was moved, transformed or clipped.", file);
}

/// Returns which parts of two keys are equal, the more important parts first.
auto likeness(const PriceTableKey& a, const PriceTableKey& b) {
  return std::array{a.original == b.original, a.metric == b.metric, a.color_model == b.color_model,
                    a.width == b.width && a.height == b.height, a.content == b.content};
}

bool fits(const Mesh& mesh, RegionFinder& finder, const Region& r) {
  if (r.face.value < 0 || r.face.value >= int(mesh.face_slots()) || !mesh[r.face].alive)
    return false;
  if (r.top < 0 || r.top > 3 || r.rows < 1 || r.columns < 1) return false;
  if (r.rows > mesh.face_count() / r.columns) return false;
  const std::vector<Halfedge> tops = region_tops(mesh, r);
  if (!tops.empty()) return region_name(mesh, r, tops) == r;
  const std::optional<FoundRegion> found = finder.find(r);
  return found && found->name == r;
}

void write(const std::filesystem::path& path, Json analyses) {
  const std::string sum = checksum(analyses);
  const Json file{{"format", format},
                  {"version", version},
                  {"checksum", sum},
                  {"analyses", std::move(analyses)}};
  write_bytes(path, file.dump() + "\n");
}

std::list<PriceTable> read(const std::filesystem::path& path) {
  return parse_analyses(read_bytes(path), path.string());
}

}  // namespace

std::list<PriceTable> parse_analyses(std::string_view text, const std::string& name) {
  // What is read is written and taken apart by recursion: a file of brackets alone must not be.
  constexpr int deepest = 8;
  const auto damaged = InputError("{0}: this analysis is damaged or cut off.", name);
  if (text.find(format) == std::string::npos)
    throw InputError("{0}: this is no file with an analysis.", name);
  try {
    const auto check_depth = [&](int depth, Json::parse_event_t, const Json&) {
      if (depth > deepest) throw damaged;
      return true;
    };
    const Json json = Json::parse(text, check_depth);
    if (json.at("version") != version)
      throw InputError(
          "{0}: this analysis has the format version {1}, but only version {2} is known here.",
          name, json.at("version").dump(), version);
    if (json.at("checksum") != checksum(json.at("analyses"))) throw damaged;
    std::list<PriceTable> analyses;
    for (const Json& analysis : json.at("analyses")) analyses.push_back(from_json(analysis));
    return analyses;
  } catch (const Json::exception&) {
    throw damaged;
  } catch (const std::logic_error&) {
    throw damaged;
  }
}

const Region* misfit(const PriceTable& analysis, const Mesh& mesh) {
  RegionFinder finder(mesh);
  for (const auto& [region, price] : analysis.prices)
    if (!fits(mesh, finder, region)) return &region;
  return nullptr;
}

PriceFiles::PriceFiles(PricePaths paths) : paths_(std::move(paths)) {
  if (!paths_.load.empty()) analyses_ = read(paths_.load);
}

PriceTable& PriceFiles::start(const PriceTableKey& key, const Mesh& mesh) {
  if (paths_.load.empty()) return analyses_.emplace_back(from_cache(key, mesh));
  const std::string file = paths_.load.string();
  const auto closest = std::ranges::max_element(
      analyses_, {}, [&](const PriceTable& analysis) { return likeness(analysis.key, key); });
  if (closest == analyses_.end()) throw InputError("{0}: this analysis holds no mesh.", file);
  if (closest->key != key) throw other_key(file, closest->key, key);
  if (const Region* region = misfit(*closest, mesh))
    throw InputError("{0}: this analysis has a region that is not in the mesh, at patch {1}.", file,
                     region->face.value);
  return *closest;
}

std::filesystem::path PriceFiles::cached(const PriceTableKey& key) const {
  Json named = to_json({key, {}});
  named.erase("prices");
  return paths_.cache / ("analysis-" + checksum(named) + ".json");
}

PriceTable PriceFiles::from_cache(const PriceTableKey& key, const Mesh& mesh) const {
  if (paths_.cache.empty()) return {key, {}};
  const std::filesystem::path file = cached(key);
  if (!std::filesystem::exists(file)) return {key, {}};
  try {
    for (PriceTable& analysis : read(file))
      if (analysis.key == key && !misfit(analysis, mesh)) return analysis;
  } catch (const InputError&) {
    // Damaged, or of another version: it is written anew.
  }
  return {key, {}};
}

void PriceFiles::save_to_cache() const {
  for (const PriceTable& analysis : analyses_) {
    if (analysis.prices.empty()) continue;
    try {
      write(cached(analysis.key), Json::array({to_json(analysis)}));
    } catch (const InputError&) {
      // A full or read-only disk costs the next run its time and nothing else.
    }
  }
}

void PriceFiles::save() const {
  if (!paths_.cache.empty()) save_to_cache();
  if (paths_.save.empty()) return;
  Json list = Json::array();
  for (const PriceTable& analysis : analyses_) list.push_back(to_json(analysis));
  write(paths_.save, std::move(list));
}

}  // namespace gradmesh
