#include "second_opinion.h"

#include <heed/dl/konclude.h>
#include <heed/owl/vocabulary.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>

namespace heed::cli {
namespace {

std::string sentence(const owl::Ontology& ontology, const dl::Subsumption& it) {
  if (it.super == owl::vocabulary::owl_nothing)
    return fmt::format("- nothing can be a '{}'\n", ontology.name(it.sub));
  return fmt::format("- every '{}' is a '{}'\n", ontology.name(it.sub), ontology.name(it.super));
}

Json pairs(const owl::Ontology& ontology, const std::vector<dl::Subsumption>& list) {
  Json out = Json::array();
  for (const dl::Subsumption& it : list)
    out.push_back(
        {{"sub", std::string(ontology.text(it.sub))}, {"super", std::string(ontology.text(it.super))}});
  return out;
}

std::string words(const owl::Ontology& ontology, const dl::KoncludeAnswer& answer, bool consistent) {
  if (!answer.consistent)
    return consistent ? "\nKonclude: the ontology contradicts itself, which heed does not see.\n"
                      : "\nKonclude: the ontology contradicts itself.\n";
  if (answer.added.empty() && answer.missing.empty()) return "\nKonclude: says the same of every class.\n";
  std::string out = fmt::format("\nKonclude: {} things that heed does not see\n", answer.added.size());
  for (const dl::Subsumption& it : answer.added) out += sentence(ontology, it);
  if (answer.missing.empty()) return out;
  out += "What heed says and Konclude denies (one of them is wrong; please report it):\n";
  for (const dl::Subsumption& it : answer.missing) out += sentence(ontology, it);
  return out;
}

}  // namespace

std::optional<SecondOpinion> second_opinion(const std::string& reasoner, const job::Knowledge& knowledge,
                                            util::Budget& budget) {
  if (reasoner == "own") return std::nullopt;
  if (reasoner != "konclude")
    throw UsageError(fmt::format("--reasoner: unknown reasoner '{}'", reasoner),
                     util::suggestion(reasoner, {"own", "konclude"}));
  const util::Limits& limits = budget.limits();
  dl::KoncludeOptions options;
  if (limits.seconds > 0) options.seconds = limits.seconds;
  if (limits.memory_bytes > 0) options.memory_bytes = limits.memory_bytes;
  const dl::KoncludeAnswer answer = dl::ask_konclude(*knowledge.reasoner, options, budget);
  SecondOpinion out;
  out.text = words(knowledge.ontology, answer, knowledge.reasoner->consistent());
  for (const std::string& remark : answer.remarks)
    out.text += fmt::format("- Konclude remarks: {}\n", remark);
  out.json["reasoner"] = "konclude";
  out.json["consistent"] = answer.consistent;
  out.json["added"] = pairs(knowledge.ontology, answer.added);
  out.json["denied"] = pairs(knowledge.ontology, answer.missing);
  out.json["remarks"] = answer.remarks;
  return out;
}

}  // namespace heed::cli
