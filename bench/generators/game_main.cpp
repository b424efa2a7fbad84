// Prints a game of a family at a chosen size, as a specification in slugs' structured format; `heed convert`
// makes other tools' formats of it. Usage: game_family FAMILY NUMBER...
#include "game_families.h"

#include <fmt/format.h>

#include <exception>

int main(int argc, char** argv) {
  try {
    fmt::print("{}", heed::bench::game_text({argv + 1, argv + argc}));
  } catch (const std::exception& error) {
    fmt::print(stderr, "usage: game_family FAMILY NUMBER...\n       {}\n", error.what());
    return 2;
  }
}
