#include "drive_svg.h"

#include <fmt/format.h>

#include <array>

#include "format.h"
#include "html_parts.h"

namespace heed::report {
namespace {

constexpr std::string_view own_style = R"css(
svg { font: 13px var(--sans); }
.ground { fill: var(--paper); }
.heading { font-weight: 600; font-size: 15px; }
.fill-gentle { fill: var(--gentle); } .fill-firm { fill: var(--firm); } .fill-emergency { fill: var(--emergency); }
.fill-none { fill: var(--k1); }
.outline { fill: var(--panel); stroke: var(--soft); stroke-width: 1.2; }
.free { fill: none; stroke: var(--soft); stroke-width: 1.6; }
.line { stroke: var(--ink); stroke-width: 1.4; }
)css";

}  // namespace

Markup::Scope open_picture(Markup& page, const PictureFrame& frame) {
  auto svg = page.scope(
      "svg", {{"xmlns", "http://www.w3.org/2000/svg"},
              {"class", "drive"},
              {"role", "img"},
              {"width", coordinate(frame.width)},
              {"height", coordinate(frame.height)},
              {"viewBox", fmt::format("0 0 {} {}", coordinate(frame.width), coordinate(frame.height))}});
  page.element("title", frame.title);
  page.element("desc", frame.description);
  page.raw("<style>" + picture_style() + std::string(own_style) + "</style>");
  draw_box(page, "ground", {0, 0, frame.width, frame.height});
  write_label(page, frame.title, {20, 28, "heading"});
  return svg;
}

void write_label(Markup& page, std::string_view words, const Label& label) {
  page.element("text", words,
               {{"class", std::string(label.style)},
                {"x", coordinate(label.x)},
                {"y", coordinate(label.y)},
                {"text-anchor", std::string(label.anchor)}});
}

void draw_line(Markup& page, std::string_view style, const Stroke& stroke) {
  page.leaf("line", {{"class", std::string(style)},
                     {"x1", coordinate(stroke.x1)},
                     {"y1", coordinate(stroke.y1)},
                     {"x2", coordinate(stroke.x2)},
                     {"y2", coordinate(stroke.y2)}});
}

void draw_box(Markup& page, std::string_view style, const Box& box) {
  page.leaf("rect", {{"class", std::string(style)},
                     {"x", coordinate(box.x)},
                     {"y", coordinate(box.y)},
                     {"width", coordinate(box.width)},
                     {"height", coordinate(box.height)}});
}

void write_braking_key(Markup& page, double x, double y) {
  struct Entry {
    std::string_view style, words;
    double width;
  };
  constexpr std::array<Entry, 4> entries{
      Entry{"fill-gentle", "up to 3 m/s²", 110}, Entry{"fill-firm", "up to 6 m/s²", 110},
      Entry{"fill-emergency", "harder", 78}, Entry{"fill-none", "does not halt", 110}};
  for (const Entry& entry : entries) {
    draw_box(page, entry.style, {x, y - 10, 12, 12});
    write_label(page, entry.words, {x + 18, y});
    x += entry.width;
  }
}

std::string fill_of(double deceleration) {
  return "fill-" + std::string(braking_class(deceleration));
}

std::string title_of(const DriveResult& result, const std::string& controller) {
  for (const DriveController& known : result.controllers)
    if (known.name == controller) return known.title;
  return controller;
}

}  // namespace heed::report
