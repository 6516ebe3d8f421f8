#include "simplify/options.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "base/limits.h"

namespace gradmesh {

namespace {

using Options = SimplifyOptions;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<std::string> metric_names() {
  std::vector<std::string> names;
  for (const MetricEntry& entry : all_metrics()) names.emplace_back(entry.name);
  return names;
}

std::vector<std::string> amount_names() {
  std::vector<std::string> names;
  for (const Amount& amount : all_amounts()) names.emplace_back(amount.name);
  return names;
}

std::vector<std::string> color_model_names() {
  return {name(ColorModel::bilinear), name(ColorModel::bicubic)};
}

std::vector<std::string> count_names() { return {name(Count::handles), name(Count::patches)}; }

Count count_named(const std::string& wanted) {
  for (const Count count : {Count::handles, Count::patches})
    if (wanted == name(count)) return count;
  throw std::invalid_argument("what is counted is handles or patches, not '" + wanted + "'.");
}

void set_amount(Options& options, const std::string& wanted) {
  const Bounds bounds = bounds_of(amount_named(wanted), options.metric);
  options.epsilon = bounds.epsilon;
  options.max_local_error = bounds.local;
  options.max_detail_error = bounds.detail;
}

template <class T>
std::string name_of(const std::optional<T>& value) {
  return value ? name(*value) : "";
}

constexpr NamedValue metrics{
    metric_names, [](const Options& o) -> std::string { return name(o.metric); },
    [](Options& o, const std::string& name) { o.metric = metric_named(name); }};
constexpr NamedValue methods{method_choices, [](const Options& o) { return o.method; },
                             [](Options& o, const std::string& name) {
                               method_named(name);
                               o.method = name;
                             }};
constexpr NamedValue amounts{amount_names, [](const Options&) { return std::string(); },
                             set_amount};
constexpr NamedValue counts{
    count_names, [](const Options& o) { return name_of(o.count); },
    [](Options& o, const std::string& name) { o.count = count_named(name); }};
constexpr NamedValue color_models{
    color_model_names, [](const Options& o) { return name_of(o.color_model); },
    [](Options& o, const std::string& name) { o.color_model = color_model_named(name); }};

void check(const OptionEntry::Range& range, double value) {
  if (std::isfinite(value) && value >= range.least && value <= range.most) return;
  std::ostringstream text;
  text << range.label << " must be ";
  if (range.most < infinity)
    text << "between " << range.least << " and " << range.most << range.unit << ".";
  else
    text << range.least << " or more" << range.unit << ".";
  throw std::invalid_argument(text.str());
}

}  // namespace

const std::vector<OptionEntry>& all_options() {
  static const std::vector<OptionEntry> options = {
      {"method", "How edges are chosen", methods},
      {"color_model",
       "How colours are held between corners; by default bicubic in .hemesh files, where SVG is "
       "involved bilinear",
       color_models},
      {"metric", "How pictures are compared", metrics},
      {"amount", "Instead of --epsilon and --max-local-error: how much a person may see", amounts},
      {"epsilon", "Largest error allowed", &Options::epsilon, {{0, 1, "epsilon"}}},
      {"max_local_error",
       "Largest error allowed in any window of 32 x 32 pixels, so that small details stay",
       &Options::max_local_error,
       {{0, 1, "the largest local error"}}},
      {"max_detail_error",
       "Largest error allowed in any window of 4 x 4 pixels away from the outline, so that edges "
       "stay where they are and curves get no corners",
       &Options::max_detail_error,
       {{0, 1, "the largest error of details"}}},
      {"handles", "Instead of --epsilon: at most so many handles, with the least error",
       &Options::handles},
      {"patches", "Instead of --epsilon: at most so many patches, with the least error",
       &Options::patches},
      {"ratio", "Instead of --epsilon: this share of the handles, or of the patches",
       &Options::ratio},
      {"count",
       "What to take out, and what --ratio is a share of. By default handles of an SVG document, "
       "and patches with a method that merges",
       counts},
      {"resolution",
       "Pixels along the longer side",
       &Options::resolution,
       {{least_resolution, double(limits().resolution), "the resolution", " pixels"}}},
      {"visible_only", "SVG: what outlines, clip paths and masks hide of the mesh does not count",
       &Options::visible_only},
      {"seed", "random choices follow it", &Options::seed},
      {"omega", "weight of size against error", &Options::omega, {{0, 1, "omega"}}},
      {"kappa",
       "share of epsilon above which an edge bounds the parts",
       &Options::kappa,
       {{0, infinity, "kappa"}}},
      {"edges", "the half-edges to merge, in this order", &Options::edges},
      {"time_budget",
       "Seconds a mesh may take, then the best so far is kept; 0: no limit",
       &Options::time_budget,
       {{0, infinity, "the time budget", " seconds"}}},
      {"threads", "0: all cores", &Options::threads, {{0, infinity, "threads"}}},
  };
  return options;
}

const OptionEntry& option_named(const std::string& name) {
  return *std::ranges::find(all_options(), name, &OptionEntry::name);
}

const std::vector<Amount>& all_amounts() {
  static const std::vector<Amount> all = {{"gentle", 0.005, 0.05, 0.06, 0.02},
                                          {"balanced", 0.01, 0.1, 0.11, 0.03},
                                          {"strong", 0.02, 0.1, 0.3, 0.04}};
  return all;
}

const Amount& amount_named(const std::string& wanted) {
  const auto& all = all_amounts();
  const auto found = std::ranges::find(all, wanted, &Amount::name);
  if (found != all.end()) return *found;
  std::string known;
  for (const Amount& amount : all) known.append(known.empty() ? "" : ", ").append(amount.name);
  throw std::invalid_argument("the amount '" + wanted + "' is not known; there are: " + known +
                              ".");
}

Bounds bounds_of(const Amount& amount, MetricKind metric) {
  // Half of what FLIP allows is as visible in SSIM (paper, section 5).
  const double share = metric == MetricKind::ssim ? 0.5 : 1;
  return {share * amount.epsilon, share * amount.max_local_error, share * amount.max_detail_error};
}

void check(const SimplifyOptions& options) {
  for (const OptionEntry& option : all_options()) {
    if (!option.range) continue;
    if (const auto* const member = std::get_if<int Options::*>(&option.value))
      check(*option.range, options.**member);
    else if (const auto* const bound = std::get_if<std::optional<double> Options::*>(&option.value))
      check(*option.range, (options.**bound).value_or(option.range->least));
    else
      check(*option.range, options.*std::get<double Options::*>(option.value));
  }
}

void check_resolution(int resolution) { check(*option_named("resolution").range, resolution); }

const char* name(ColorModel model) {
  return model == ColorModel::bilinear ? "bilinear" : "bicubic";
}

const char* name(Count count) { return count == Count::handles ? "handles" : "patches"; }

ColorModel color_model_named(const std::string& wanted) {
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic})
    if (wanted == name(model)) return model;
  throw std::invalid_argument("the color model '" + wanted +
                              "' is not known; there are: bilinear, bicubic.");
}

}  // namespace gradmesh
