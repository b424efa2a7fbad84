#include <heed/model/mealy.h>
#include <heed/util/diagnostic.h>
#include <heed/util/random.h>

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace heed::model {
namespace {

Mealy random_machine(std::uint64_t seed, std::uint32_t states, bool partial) {
  util::CounterRandom random(seed, 0);
  MealyBuilder builder("random", {{"a", Domain::boolean(), "", {}}, {"b", Domain::integer(-1, 1), "", {}}},
                       {{{"y", Domain::enumeration({"go", "halt"}), "", {}}, OutputRole::Action}});
  for (std::uint32_t s = 0; s < states; ++s) builder.add_state();
  for (std::uint32_t s = 0; s < states; ++s)
    for (std::int32_t a = 0; a < 2; ++a)
      for (std::int32_t b = -1; b < 2; ++b) {
        if (partial && random.below(8) == 0) continue;
        builder.add(s, {a, b}, {static_cast<std::int32_t>(random.below(8) == 0)}, random.below(states),
                    random.below(12) == 0);
      }
  return builder.finish();
}

TEST(MealyBuilder, TakesRowsInAnyOrder) {
  const auto built = [](const std::vector<std::uint32_t>& states) {
    MealyBuilder builder("any order", {{"a", Domain::integer(0, 99), "", {}}},
                         {{{"y", Domain::integer(0, 99), "", {}}, OutputRole::Action}});
    for (int s = 0; s < 3; ++s) builder.add_state();
    for (std::int32_t a = 0; a < 100; ++a)
      for (const std::uint32_t s : states)
        if (s != 1 || a % 2 == 0)
          builder.add(s, {(a * 37) % 100}, {(a * 7 + 3) % 100}, (s + 1) % 3, a % 5 == 0);
    return builder.finish();
  };
  const Mealy machine = built({0, 1, 2});
  EXPECT_EQ(machine, built({2, 0, 1}));
  EXPECT_EQ(machine.first, (std::vector<std::uint32_t>{0, 100, 150, 250}));
  for (std::uint32_t s = 0; s < 3; ++s) {
    for (std::int32_t a = 0; a < 100; ++a) {
      const auto* row = machine.find(s, *machine.input_letter({(a * 37) % 100}));
      ASSERT_EQ(row != nullptr, s != 1 || a % 2 == 0);
      if (row == nullptr) continue;
      EXPECT_EQ(machine.output_letters[row->output].front(), (a * 7 + 3) % 100);
      EXPECT_EQ(row->next, (s + 1) % 3);
      EXPECT_EQ(row->fallback, a % 5 == 0);
    }
  }
}

/// Bisimilarity by pairs, from the definition: the largest relation in which rows agree.
std::set<std::pair<std::uint32_t, std::uint32_t>> bisimilar(const Mealy& m) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> relation;
  for (std::uint32_t a = 0; a < m.state_count(); ++a)
    for (std::uint32_t b = 0; b < m.state_count(); ++b) relation.emplace(a, b);
  const auto agree = [&](std::uint32_t a, std::uint32_t b) {
    for (std::uint32_t letter = 0; letter < m.input_letters.size(); ++letter) {
      const auto* x = m.find(a, letter);
      const auto* y = m.find(b, letter);
      if ((x == nullptr) != (y == nullptr)) return false;
      if (x != nullptr &&
          (x->output != y->output || x->fallback != y->fallback || !relation.contains({x->next, y->next})))
        return false;
    }
    return true;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (auto it = relation.begin(); it != relation.end();)
      if (!agree(it->first, it->second)) {
        it = relation.erase(it);
        changed = true;
      } else {
        ++it;
      }
  }
  return relation;
}

std::set<std::uint32_t> reachable(const Mealy& m) {
  std::set<std::uint32_t> seen{0};
  std::vector<std::uint32_t> todo{0};
  while (!todo.empty()) {
    const std::uint32_t s = todo.back();
    todo.pop_back();
    for (std::uint32_t t = m.first[s]; t < m.first[s + 1]; ++t)
      if (seen.insert(m.transitions[t].next).second) todo.push_back(m.transitions[t].next);
  }
  return seen;
}

TEST(Minimise, CountsTheBisimulationClassesOfRandomMachines) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Mealy machine = random_machine(seed, 1 + static_cast<std::uint32_t>(seed % 9), seed % 2 == 0);
    const auto relation = bisimilar(machine);
    std::set<std::uint32_t> classes;
    for (const std::uint32_t s : reachable(machine)) {
      std::uint32_t least = s;
      for (std::uint32_t r = 0; r < s; ++r)
        if (relation.contains({r, s})) {
          least = r;
          break;
        }
      classes.insert(least);
    }
    EXPECT_EQ(minimise(machine).state_count(), classes.size()) << "seed " << seed;
  }
}

TEST(Minimise, KeepsEveryAnswer) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Mealy before = random_machine(seed, 7, true);
    const Mealy after = minimise(before);
    util::CounterRandom random(seed, 1);
    std::uint32_t s = 0, r = 0;
    for (int step = 0; step < 100; ++step) {
      const Valuation input{static_cast<std::int32_t>(random.below(2)),
                            static_cast<std::int32_t>(random.below(3)) - 1};
      const auto letter = before.input_letter(input);
      const auto small = after.input_letter(input);
      const auto* x = letter ? before.find(s, *letter) : nullptr;
      const auto* y = small ? after.find(r, *small) : nullptr;
      ASSERT_EQ(x == nullptr, y == nullptr);
      if (x == nullptr) break;
      ASSERT_EQ(before.output_letters[x->output], after.output_letters[y->output]);
      ASSERT_EQ(x->fallback, y->fallback);
      s = x->next;
      r = y->next;
    }
  }
}

// Two interleaved copies of it, with all states but the initial one in another order.
Mealy doubled(const Mealy& machine, std::uint64_t seed) {
  MealyBuilder twice(machine.name, machine.inputs, machine.outputs);
  const std::uint32_t n = machine.state_count();
  util::CounterRandom random(seed, 2);
  std::vector<std::uint32_t> place(2 * std::size_t{n});
  for (std::uint32_t i = 0; i < place.size(); ++i) {
    place[i] = i;
    twice.add_state();
    if (i > 1) std::swap(place[i], place[1 + random.below(i)]);
  }
  for (std::uint32_t s = 0; s < 2 * n; ++s)
    for (std::uint32_t t = machine.first[s % n]; t < machine.first[s % n + 1]; ++t) {
      const auto& row = machine.transitions[t];
      const std::uint32_t next = s < n ? row.next + n : row.next;
      twice.add(place[s], machine.input_letters[row.input], machine.output_letters[row.output], place[next],
                row.fallback);
    }
  return twice.finish();
}

TEST(Minimise, IsCanonical) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Mealy machine = random_machine(seed, 1 + static_cast<std::uint32_t>(seed % 9), seed % 2 == 0);
    EXPECT_EQ(write_mealy(minimise(doubled(machine, seed))), write_mealy(minimise(machine))) << seed;
  }
}

TEST(MealyFile, RoundTrips) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Mealy machine = random_machine(seed, 5, true);
    const std::string text = write_mealy(machine);
    EXPECT_EQ(write_mealy(read_mealy(util::SourceText("m.json", text))), text);
  }
}

TEST(MealyFile, ReadsItsOwnExample) {
  const std::string path = std::string(HEED_SOURCE_DIR) + "/docs/formats/controller.md";
  const util::SourceText page = util::SourceText(path, [&] {
    std::string text;
    if (FILE* f = std::fopen(path.c_str(), "r")) {
      for (int c; (c = std::fgetc(f)) != EOF;) text += static_cast<char>(c);
      std::fclose(f);
    }
    return text;
  }());
  const auto begin = page.text().find("```json\n") + 8;
  const std::string example = page.text().substr(begin, page.text().find("```", begin) - begin);
  EXPECT_EQ(write_mealy(read_mealy(util::SourceText("example", example))), example);
}

struct Flaw {
  const char* from;
  const char* to;
  const char* message;
};

class FlawedController : public testing::TestWithParam<Flaw> {};

TEST_P(FlawedController, IsRefused) {
  std::string text = R"({"heed": "controller", "version": 1, "name": "echo",
"inputs": [{"name": "red", "type": "boolean"}],
"outputs": [{"name": "action", "type": ["go", "halt"], "role": "action"}],
"assumptions": [], "notes": [], "input_letters": [[0], [1]], "output_letters": [[0], [1]],
"states": [[[0, 0, 0], [1, 1, 0]]]})";
  const auto at = text.find(GetParam().from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(GetParam().from).size(), GetParam().to);
  try {
    (void)read_mealy(util::SourceText("m.json", text));
    FAIL() << "accepted";
  } catch (const util::InputError& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().message), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, FlawedController,
    testing::Values(Flaw{"{\"heed\"", "[\"heed\"", "not JSON"},
                    Flaw{"\"notes\"", "\"note\"", "lacks the key 'notes'"},
                    Flaw{"\"notes\": []", "\"notes\": [], \"inputz\": 1", "did you mean 'inputs'"},
                    Flaw{"[[0], [1]], \"output", "[[0], [2]], \"output", "outside 0 ... 1"},
                    Flaw{"[[0], [1]], \"output", "[[1], [0]], \"output", "ascending"},
                    Flaw{"[1, 1, 0]", "[1, 1, 7]", "next state"}, Flaw{"[1, 1, 0]", "[0, 1, 0]", "ascending"},
                    Flaw{"[1, 1, 0]", "[1, 1]", "a row is"},
                    Flaw{"\"action\"}", "\"acton\"}", "did you mean 'action'"},
                    Flaw{"\"version\": 1", "\"version\": 2", "version"},
                    Flaw{"\"name\": \"echo\"", "\"name\": [[[[[[[[[[[]]]]]]]]]]]", "deeper"},
                    Flaw{"[[[0, 0, 0], [1, 1, 0]]]", "[]", "empty"}));

}  // namespace
}  // namespace heed::model
