#pragma once

#include <heed/report/drive.h>

#include <string>
#include <string_view>

#include "markup.h"

/// What the pictures of `heed drive` share.
namespace heed::report {

struct PictureFrame {
  double width, height;
  std::string_view title;
  std::string description;  ///< For who cannot see it.
};

/// An SVG document with the house's colours, a ground and a heading; the drawing goes inside the scope.
[[nodiscard]] Markup::Scope open_picture(Markup& page, const PictureFrame& frame);

/// A line of text. \p style  Classes of the style sheet; \p anchor  "start", "middle" or "end".
struct Label {
  double x, y;
  std::string_view style = "tick", anchor = "start";
};
void write_label(Markup& page, std::string_view words, const Label& label);

struct Stroke {
  double x1, y1, x2, y2;
};
void draw_line(Markup& page, std::string_view style, const Stroke& stroke);

struct Box {
  double x, y, width, height;
};
void draw_box(Markup& page, std::string_view style, const Box& box);

/// Hardness of braking, and its key; from \p x on at height \p y.
void write_braking_key(Markup& page, double x, double y);
/// Class that fills what braking at \p deceleration is drawn as: "fill-gentle", "fill-firm",
/// "fill-emergency".
[[nodiscard]] std::string fill_of(double deceleration);

[[nodiscard]] std::string title_of(const DriveResult& result, const std::string& controller);

}  // namespace heed::report
