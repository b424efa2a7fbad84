// No function longer than 60 lines (from its opening to its closing brace), but for those that
// tests/sanity/long_functions.txt names with a reason; an entry that is no longer needed is a fault too.
// A body is a brace that follows a parameter list outside any other body. Usage: function_length SOURCE_DIR

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

// Comments, strings and preprocessor lines become blanks; line ends stay.
static std::string code_only(const std::string& text) {
  std::string out = text;
  enum class In { Code, Line, Block, String, Char } in = In::Code;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const char c = text[i];
    const char n = i + 1 < text.size() ? text[i + 1] : '\0';
    const bool line_start = i == 0 || text[i - 1] == '\n';
    if (in == In::Code) {
      if (c == 'R' && n == '"') {  // raw string: to its delimiter
        const std::size_t open = text.find('(', i);
        const std::string close = ")" + text.substr(i + 2, open - i - 2) + "\"";
        const std::size_t end = text.find(close, open) + close.size();
        for (; i < end; ++i)
          if (out[i] != '\n') out[i] = ' ';
        --i;
        continue;
      }
      const bool digit_separator =
          c == '\'' && i > 0 && std::isdigit(static_cast<unsigned char>(text[i - 1])) != 0;
      if ((c == '/' && n == '/') || (line_start && c == '#'))
        in = In::Line;
      else if (c == '/' && n == '*')
        in = In::Block;
      else if (c == '"')
        in = In::String;
      else if (c == '\'' && !digit_separator)
        in = In::Char;
      if (in != In::Code) out[i] = ' ';
      continue;
    }
    if (c != '\n') out[i] = ' ';
    if ((in == In::String || in == In::Char) && c == '\\') {
      if (i + 1 < out.size()) out[++i] = ' ';
    } else if ((in == In::Line && c == '\n') || (in == In::String && c == '"') ||
               (in == In::Char && c == '\'')) {
      in = In::Code;
    } else if (in == In::Block && c == '*' && n == '/') {
      out[++i] = ' ';
      in = In::Code;
    }
  }
  return out;
}

struct Function {
  std::string name;
  int line, length;
};

// The name before the first '(' of a head such as "Bdd Manager::apply(Op op) const".
static std::string name_of(const std::string& head) {
  const std::size_t paren = head.find('(');
  std::size_t end = paren;
  while (end > 0 && std::isspace(static_cast<unsigned char>(head[end - 1])) != 0) --end;
  std::size_t begin = end;
  while (begin > 0 && (std::isalnum(static_cast<unsigned char>(head[begin - 1])) != 0 ||
                       head[begin - 1] == '_' || head[begin - 1] == ':' || head[begin - 1] == '~'))
    --begin;
  return head.substr(begin, end - begin);
}

static bool opens_function(const std::string& head) {
  if (head.find('(') == std::string::npos) return false;
  std::istringstream words(head);
  std::string first;
  words >> first;
  for (const char* word : {"namespace", "class", "struct", "enum", "union"})
    if (first == word) return false;
  return true;
}

static std::vector<Function> functions_of(const std::string& text) {
  const std::string code = code_only(text);
  std::vector<Function> found;
  std::string head;
  int line = 1, depth = 0, body_depth = -1, body_line = 0;
  std::string body_name;
  for (const char c : code) {
    if (c == '\n') ++line;
    if (c == '{') {
      if (body_depth < 0 && opens_function(head)) {
        body_depth = depth;
        body_line = line;
        body_name = name_of(head);
      }
      ++depth;
      head.clear();
    } else if (c == '}') {
      --depth;
      if (depth == body_depth) {
        found.push_back({body_name, body_line, line - body_line + 1});
        body_depth = -1;
      }
      head.clear();
    } else if (c == ';') {
      head.clear();
    } else {
      head += c;
    }
  }
  return found;
}

static std::map<std::string, bool> read_exceptions(const fs::path& path) {
  std::map<std::string, bool> exceptions;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
    if (!line.empty() && line[0] != '#') exceptions[line.substr(0, line.find(' '))] = false;
  return exceptions;
}

int main(int argc, char** argv) {
  const fs::path root = argc > 1 ? argv[1] : ".";
  constexpr int limit = 60;
  auto exceptions = read_exceptions(root / "tests/sanity/long_functions.txt");
  int faults = 0, functions = 0;
  for (const char* folder : {"src", "include", "tests", "bench"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      std::ifstream file(entry.path());
      std::stringstream text;
      text << file.rdbuf();
      for (const Function& f : functions_of(text.str())) {
        ++functions;
        if (f.length <= limit) continue;
        const std::string key = fs::relative(entry.path(), root).string() + ":" + f.name;
        if (const auto it = exceptions.find(key); it != exceptions.end()) {
          it->second = true;
          continue;
        }
        std::cerr << entry.path().string() << ':' << f.line << ": " << f.name << " has " << f.length
                  << " lines (limit " << limit << ")\n";
        ++faults;
      }
    }
  for (const auto& [key, used] : exceptions)
    if (!used) {
      std::cerr << "long_functions.txt: '" << key << "' is no longer too long\n";
      ++faults;
    }
  std::cout << functions << " functions, " << faults << " faults\n";
  return faults == 0 && functions > 100 ? 0 : 1;
}
