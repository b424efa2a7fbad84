#include <fmt/format.h>

#include <algorithm>

#include "format.h"
#include "html_parts.h"
#include "lookup.h"

namespace heed::report {

namespace {

struct Column {
  std::string profile, controller;
  bool first;  ///< Of its profile.
};

std::vector<Column> columns_of(const RunResult& result) {
  std::vector<Column> columns;
  for (const Profile& profile : result.profiles) {
    bool first = true;
    for (const Controller& controller : result.controllers) {
      const bool there =
          std::any_of(result.catalogue.begin(), result.catalogue.end(), [&](const CatalogueEntry& entry) {
            return find_encounter(entry, profile.name, controller.name).has_value();
          });
      if (!there) continue;
      columns.push_back({profile.name, controller.name, first});
      first = false;
    }
  }
  return columns;
}

/// Five shades; whatever is above 0 has at least the faintest.
std::string heat(double share) {
  if (share <= 0) return "zero";
  return fmt::format("h{}", 1 + std::min(4, static_cast<int>(share * 5)));
}

void write_cell(Markup& page, const CatalogueEntry& entry, std::size_t row, const Column& column) {
  const std::string first = column.first ? " first" : "";
  const auto index = find_encounter(entry, column.profile, column.controller);
  if (!index) {
    page.element("td", "–", {{"class", "n other" + first}});
    return;
  }
  const Encounter& encounter = entry.encounters[*index];
  const char* kind = encounter.miss ? "miss" : encounter.needless ? "needless" : "stop";
  const Number& number = encounter.miss       ? *encounter.miss
                         : encounter.needless ? *encounter.needless
                                              : encounter.stop;
  const bool error = encounter.miss || encounter.needless;
  const std::string path = fmt::format("/catalogue/{}/encounters/{}/{}/value", row, *index, kind);
  page.element("td", percent_bare(number.value),
               with_data({{"class", "n " + (error ? heat(number.value) : std::string("other")) + first}},
                         path, number.value));
}

std::string what_counts(const CatalogueEntry& entry) {
  if (entry.prescribes_halt) return "missed";
  return entry.prescribes_give_way ? "may react" : "reacts";
}

void write_head(Markup& page, const RunResult& result, const std::vector<Column>& columns) {
  const auto head = page.scope("thead");
  {
    const auto row = page.scope("tr");
    page.element("th", "Thing", {{"scope", "col"}, {"rowspan", "2"}});
    page.element("th", "Counted", {{"scope", "col"}, {"rowspan", "2"}});
    for (std::size_t i = 0; i < columns.size();) {
      std::size_t end = i + 1;
      while (end < columns.size() && !columns[end].first) ++end;
      page.element("th", columns[i].profile,
                   {{"scope", "colgroup"}, {"colspan", std::to_string(end - i)}, {"class", "first"}});
      i = end;
    }
  }
  const auto row = page.scope("tr");
  for (const Column& column : columns) {
    const auto cell = page.scope("th", {{"scope", "col"}, {"class", column.first ? "n first" : "n"}});
    write_name(page, result, column.controller, column.controller);
  }
}

void write_rows(Markup& page, const RunResult& result, const std::vector<Column>& columns) {
  const auto body = page.scope("tbody");
  const std::string* group = nullptr;
  for (std::size_t i = 0; i < result.catalogue.size(); ++i) {
    const CatalogueEntry& entry = result.catalogue[i];
    if (!entry.group.empty() && (group == nullptr || *group != entry.group)) {
      const auto row = page.scope("tr");
      page.element(
          "th", entry.group,
          {{"class", "group"}, {"scope", "rowgroup"}, {"colspan", std::to_string(columns.size() + 2)}});
    }
    group = &entry.group;
    const auto row = page.scope("tr");
    {
      const auto name = page.scope("th", {{"scope", "row"}});
      page.text(label_of(entry));
      std::string what = join(entry.features, ", ");
      if (!entry.behaviours.empty()) what += " → " + join(entry.behaviours, ", ");
      if (!what.empty()) page.element("span", what, {{"class", "what"}});
    }
    page.element("td", what_counts(entry), {{"class", "other"}});
    for (const Column& column : columns) write_cell(page, entry, i, column);
  }
}

void write_summary(Markup& page, const RunResult& result) {
  const auto box = scroll_box(page, "Errors per controller");
  const auto table = page.scope("table");
  {
    const auto head = page.scope("thead");
    const auto row = page.scope("tr");
    page.element("th", "Controller", {{"scope", "col"}});
    for (const std::string& name : {std::string("Reacts needlessly to"), std::string("At worst"),
                                    std::string("Can miss"), "With no " + result.kind})
      page.element("th", name, {{"scope", "col"}});
  }
  const auto body = page.scope("tbody");
  for (const Controller& controller : result.controllers) {
    if (controller.verdict == Verdict::Unrealizable) continue;
    const ErrorCount count = count_errors(result, controller.name);
    const auto row = page.scope("tr");
    {
      const auto name = page.scope("th", {{"scope", "row"}});
      write_name(page, result, controller.name, title_of(controller));
    }
    page.element("td", fmt::format("{} of {}", count.needless, plural(count.signs, result.kind)));
    page.element("td", count.needless == 0 ? "–"
                                           : unbroken(fmt::format("{}, {}", percent(count.worst_needless),
                                                                  count.worst_sign)));
    page.element("td", fmt::format("{} of {}", count.missed, count.halting));
    page.element("td", count.open_road ? "reacts" : "goes on");
  }
}

}  // namespace

void write_catalogue(Markup& page, const RunResult& result) {
  if (!has_errors(result)) return;
  const auto part =
      section(page, "catalogue", fmt::format("Past every {} of the catalogue", result.kind),
              "A controller that always reacts would never miss. So each also passes everything "
              "else in the catalogue, and nothing at all: how often does it react where it need "
              "not?");
  page.element("p", errors_explained(result));
  write_summary(page, result);
  const std::vector<Column> columns = columns_of(result);
  if (columns.empty()) return;
  const auto box = scroll_box(page, "Misses and needless reactions, one by one");
  const auto table = page.scope("table", {{"class", "errors"}});
  write_caption(page,
                "Per cent of approaches in which it is missed, or in which the machine reacts; the stronger "
                "the colour, the more errors");
  write_head(page, result, columns);
  write_rows(page, result, columns);
}

}  // namespace heed::report
