// Every include between rooms must be in the table of docs/architecture.md; the table is read from there, so
// that the document cannot fall behind. Usage: layers SOURCE_DIR

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace fs = std::filesystem;
using Table = std::map<std::string, std::set<std::string>>;

// Rows such as: | `game` | what lives there | util, logic, bdd |
static Table read_table(const fs::path& page) {
  Table table;
  std::ifstream file(page);
  const std::regex row(R"(^\|\s*`([a-z]+)`\s*\|.*\|\s*([a-z, –-]*)\s*\|\s*$)");
  for (std::string line; std::getline(file, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    std::set<std::string>& allowed = table[match[1]];
    const std::regex word("[a-z]+");
    const std::string list = match[2];
    for (std::sregex_iterator it(list.begin(), list.end(), word), end; it != end; ++it)
      allowed.insert(it->str());
  }
  return table;
}

static int check_file(const fs::path& path, const std::string& room, const Table& table) {
  static const std::regex include(R"(^\s*#include\s*[<"]heed/([a-z]+)/)");
  std::ifstream file(path);
  int faults = 0, number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    std::smatch match;
    if (!std::regex_search(line, match, include) || match[1] == room) continue;
    if (table.at(room).contains("all") || table.at(room).contains(match[1])) continue;
    std::cerr << path.string() << ':' << number << ": room '" << room << "' must not include '" << match[1]
              << "'\n";
    ++faults;
  }
  return faults;
}

int main(int argc, char** argv) {
  const fs::path root = argc > 1 ? argv[1] : ".";
  const Table table = read_table(root / "docs/architecture.md");
  if (table.size() < 16) {
    std::cerr << "docs/architecture.md: only " << table.size() << " rooms found in its table\n";
    return 1;
  }
  int faults = 0, files = 0;
  for (const auto& [room, allowed] : table)
    for (const fs::path& folder : {root / "src" / room, root / "include/heed" / room}) {
      if (!fs::exists(folder)) continue;
      for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
        ++files;
        faults += check_file(entry.path(), room, table);
      }
    }
  for (const auto& entry : fs::directory_iterator(root / "src"))
    if (entry.is_directory() && !table.contains(entry.path().filename().string())) {
      std::cerr << entry.path().string() << ": not in the table of docs/architecture.md\n";
      ++faults;
    }
  std::cout << files << " files, " << faults << " forbidden includes\n";
  return faults == 0 ? 0 : 1;
}
