#pragma once

#include <heed/model/mealy.h>
#include <heed/spec/gr1.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace heed::spec {

template <typename Value>
using Word = std::pair<std::string_view, Value>;

inline constexpr std::array<Word<Origin>, 6> origin_words{{{"task", Origin::Task},
                                                           {"plant", Origin::Plant},
                                                           {"knowledge", Origin::Knowledge},
                                                           {"perception", Origin::Perception},
                                                           {"binding", Origin::Binding},
                                                           {"lowering", Origin::Lowering}}};

inline constexpr std::array<Word<model::OutputRole>, 6> role_words{
    {{"action", model::OutputRole::Action},
     {"output", model::OutputRole::Output},
     {"plant", model::OutputRole::Plant},
     {"memory", model::OutputRole::Memory},
     {"recognised", model::OutputRole::Recognised},
     {"prescribed", model::OutputRole::Prescribed}}};

inline constexpr std::array<Word<Timing>, 2> timing_words{
    {{"mealy", Timing::Mealy}, {"moore", Timing::Moore}}};

inline constexpr std::array<Word<InitialQuantifiers>, 4> initial_words{
    {{"forall-exists", InitialQuantifiers::ForallExists},
     {"exists-forall", InitialQuantifiers::ExistsForall},
     {"forall-forall", InitialQuantifiers::ForallForall},
     {"exists-exists", InitialQuantifiers::ExistsExists}}};

/// The six parts of a specification with the names of their sections, in the order of the file.
struct Part {
  std::string_view section;
  std::vector<Clause> Gr1::*clauses;
};
inline constexpr std::array<Part, 6> parts{{{"env init", &Gr1::env_init},
                                            {"env safety", &Gr1::env_safety},
                                            {"env justice", &Gr1::env_justice},
                                            {"sys init", &Gr1::sys_init},
                                            {"sys safety", &Gr1::sys_safety},
                                            {"sys justice", &Gr1::sys_justice}}};

template <typename Value, std::size_t n>
[[nodiscard]] std::string word_of(const std::array<Word<Value>, n>& words, Value value) {
  for (const auto& [word, meaning] : words)
    if (meaning == value) return std::string(word);
  return {};
}

/// A name as it stands in files: quoted where it has to be.
[[nodiscard]] std::string quoted_name(const std::string& name);
/// A string in quotation marks, with \" \\ \n escaped.
[[nodiscard]] std::string quoted_string(const std::string& text);
/// A value as it stands in files: an enumeration's are names.
[[nodiscard]] std::string value_text(const model::Domain& domain, std::int32_t code);

}  // namespace heed::spec
