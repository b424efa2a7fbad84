#include <heed/report/play.h>

#include <cassert>
#include <string_view>

#include "play_template.h"

namespace heed::report {

namespace {

/// As web/index.html has it.
constexpr std::string_view place = R"({"heed":"no data"})";

/// Inside a script element only `<` could end it or begin a comment; in JSON it stands in strings alone.
std::string embedded(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  return out;
}

}  // namespace

bool has_play_page() {
  return !play_template().empty();
}

std::string to_html(const Play& play) {
  std::string page = play_template();
  const std::size_t at = page.find(place);
  assert(at != std::string::npos);
  return page.replace(at, place.size(), embedded(to_json(play)));
}

}  // namespace heed::report
