#include <heed/sim/product.h>
#include <heed/sim/rational.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cctype>
#include <iterator>
#include <set>

namespace heed::sim {
namespace {

/// A word that no state carries twice: letters, digits and underscores.
class Labels {
 public:
  std::string claim(const std::string& text) {
    std::string word;
    for (const char c : text) word += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    if (word.empty() || std::isdigit(static_cast<unsigned char>(word.front())) != 0) word.insert(0, "_");
    std::string unique = word;
    for (int i = 2; !used_.insert(unique).second; ++i) unique = fmt::format("{}_{}", word, i);
    return unique;
  }

 private:
  std::set<std::string> used_;
};

/// A label and what it says of an end.
struct Label {
  std::string name, meaning;
  std::vector<bool> holds;  ///< Per state.
};

std::vector<Label> labels_of(const Product& product) {
  Labels names;
  std::vector<Label> labels;
  const auto add = [&](const std::string& name, const std::string& meaning, auto holds) {
    Label label{names.claim(name), meaning, {}};
    for (const Product::State& state : product.states) label.holds.push_back(state.end && holds(*state.end));
    labels.push_back(std::move(label));
  };
  for (std::uint32_t c = 0; c < product.categories.size(); ++c)
    add("outcome_" + product.categories[c], product.categories[c],
        [c](const Product::End& end) { return end.category == c; });
  add("undefined", "no row before the run had an outcome",
      [](const Product::End& end) { return !end.category; });
  add("missing", "a row was missing", [](const Product::End& end) { return end.missing; });
  add("fallback", "an assumption was broken and answered by a fallback",
      [](const Product::End& end) { return end.fallback; });
  return labels;
}

/// PRISM's integers have 32 bits; what is larger is written as a double.
std::string number(const mpz_class& value) {
  return value.fits_sint_p() ? value.get_str() : value.get_str() + ".0";
}

std::string prism_probability(const Rational& p) {
  return p.get_den() == 1 ? number(p.get_num()) : number(p.get_num()) + "/" + number(p.get_den());
}

std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

/// JANI's integers are JSON numbers; what 53 bits do not hold is written as a real.
nlohmann::ordered_json jani_number(const mpz_class& value) {
  if (mpz_sizeinbase(value.get_mpz_t(), 2) <= 53) return value.get_si();
  return value.get_d();
}

nlohmann::ordered_json jani_probability(const Rational& p) {
  if (p.get_den() == 1) return jani_number(p.get_num());
  return {{"op", "/"}, {"left", jani_number(p.get_num())}, {"right", jani_number(p.get_den())}};
}

std::string location(std::uint32_t state) {
  return fmt::format("s{}", state);
}

nlohmann::ordered_json jani_automaton(const Product& product, const std::vector<Label>& labels) {
  using Json = nlohmann::ordered_json;
  Json locations = Json::array(), edges = Json::array();
  for (std::uint32_t s = 0; s < product.states.size(); ++s) {
    Json place{{"name", location(s)}};
    for (const Label& label : labels)
      if (label.holds[s]) place["transient-values"].push_back({{"ref", label.name}, {"value", true}});
    locations.push_back(std::move(place));
    Json destinations = Json::array();
    for (std::uint32_t i = product.first[s]; i < product.first[s + 1]; ++i)
      destinations.push_back({{"location", location(product.steps[i].next)},
                              {"probability", {{"exp", jani_probability(product.steps[i].probability)}}}});
    if (destinations.empty()) destinations.push_back({{"location", location(s)}});
    edges.push_back({{"location", location(s)}, {"destinations", std::move(destinations)}});
  }
  return {{"name", "approach"},
          {"locations", std::move(locations)},
          {"initial-locations", Json::array({location(0)})},
          {"edges", std::move(edges)}};
}

nlohmann::ordered_json jani_property(const Label& label) {
  return {{"name", label.name},
          {"comment", label.meaning},
          {"expression",
           {{"op", "filter"},
            {"fun", "values"},
            {"values", {{"op", "Pmin"}, {"exp", {{"op", "F"}, {"exp", label.name}}}}},
            {"states", {{"op", "initial"}}}}}};
}

}  // namespace

std::string write_prism(const Product& product) {
  std::string out;
  fmt::format_to(std::back_inserter(out), "// controller: {}\n// profile: {}\n\ndtmc\n\nmodule approach\n",
                 one_line(product.controller), one_line(product.profile));
  fmt::format_to(std::back_inserter(out), "  s : [0..{}] init 0;\n", product.states.size() - 1);
  for (std::uint32_t s = 0; s < product.states.size(); ++s) {
    if (product.states[s].end) {
      fmt::format_to(std::back_inserter(out), "  [] s={} -> true;\n", s);
      continue;
    }
    fmt::format_to(std::back_inserter(out), "  [] s={} ->", s);
    for (std::uint32_t i = product.first[s]; i < product.first[s + 1]; ++i)
      fmt::format_to(std::back_inserter(out), "{} {}:(s'={})", i == product.first[s] ? "" : " +",
                     prism_probability(product.steps[i].probability), product.steps[i].next);
    fmt::format_to(std::back_inserter(out), ";  // {} cells passed, controller in state {}\n",
                   product.states[s].cells, product.states[s].machine);
  }
  out += "endmodule\n\n";
  for (const Label& label : labels_of(product)) {
    std::string states;
    for (std::uint32_t s = 0; s < label.holds.size(); ++s)
      if (label.holds[s]) states += fmt::format("{}s={}", states.empty() ? "" : "|", s);
    fmt::format_to(std::back_inserter(out), "label \"{}\" = {};  // {}\n", label.name,
                   states.empty() ? "false" : states, one_line(label.meaning));
  }
  return out;
}

std::string write_jani(const Product& product) {
  using Json = nlohmann::ordered_json;
  const std::vector<Label> labels = labels_of(product);
  Json variables = Json::array(), properties = Json::array();
  for (const Label& label : labels) {
    variables.push_back(
        {{"name", label.name}, {"type", "bool"}, {"transient", true}, {"initial-value", false}});
    properties.push_back(jani_property(label));
  }
  Json model{{"jani-version", 1},
             {"name", product.controller},
             {"metadata", {{"description", "the controller on the profile " + product.profile}}},
             {"type", "dtmc"},
             {"variables", std::move(variables)},
             {"automata", Json::array({jani_automaton(product, labels)})},
             {"system", {{"elements", Json::array({{{"automaton", "approach"}}})}}},
             {"properties", std::move(properties)}};
  return model.dump(1) + "\n";
}

}  // namespace heed::sim
