#pragma once

#include <heed/report/result.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "markup.h"

/// The page, part by part; each writes nothing where the result has nothing to say.
namespace heed::report {

[[nodiscard]] std::string_view style_sheet();
/// What a picture needs of it that is a document of its own.
[[nodiscard]] std::string picture_style();

void write_answer(Markup& page, const RunResult& result);
void write_ontology(Markup& page, const RunResult& result);
void write_knowledge(Markup& page, const RunResult& result);
void write_specification(Markup& page, const RunResult& result);
void write_warnings(Markup& page, const RunResult& result);
void write_controllers(Markup& page, const RunResult& result);
void write_outcomes(Markup& page, const RunResult& result);
void write_speed(Markup& page, const RunResult& result);
void write_catalogue(Markup& page, const RunResult& result);
void write_roads(Markup& page, const RunResult& result);
void write_policies(Markup& page, const RunResult& result);
void write_driving(Markup& page, const RunResult& result);
void write_method(Markup& page, const RunResult& result);
void write_timings(Markup& page, const RunResult& result);

/// All charts of one profile as one picture: outcomes from top to bottom, one bar per controller.
void draw_profile(Markup& page, const RunResult& result, const Profile& profile);
void draw_speed(Markup& page, const SpeedPicture& picture);
/// Misses over needless reactions: one point per policy, the front as a line. Points on it bear the numbers
/// that front_numbers() gives. \pre \p figures are of one profile and one level of noise
void draw_front(Markup& page, const std::vector<const TunedPolicy*>& figures,
                const std::function<std::string(const std::string&)>& colour);
/// Per figure: its number on the front, from 1; 0 for what is not on it.
[[nodiscard]] std::vector<std::size_t> front_numbers(const std::vector<const TunedPolicy*>& figures);
/// The figures of one panel after the other: same profile, same noise.
[[nodiscard]] std::vector<std::vector<const TunedPolicy*>> panels_of(const Tuning& tuning);

/// Class of a controller's colour: `k0` is the subject, the others follow in their order.
[[nodiscard]] std::string colour_class(const RunResult& result, std::string_view controller);
/// How hard a deceleration is: "gentle" (up to 3 m/s^2), "firm" (up to 6), "emergency".
[[nodiscard]] std::string_view braking_class(double deceleration);
/// Title of the controller of that name; the name itself where it is unknown.
[[nodiscard]] std::string title_of(const RunResult& result, std::string_view controller);
/// "traffic-signs.owl:812"; empty where nothing is known.
[[nodiscard]] std::string short_place(const util::Location& location);

/// Opens `<section id>` with its heading and an introduction (may be empty).
[[nodiscard]] Markup::Scope section(Markup& page, std::string_view id, std::string_view heading,
                                    std::string_view introduction = {});
/// A table's caption, which stays readable while its table scrolls.
void write_caption(Markup& page, std::string_view words);
/// A controller's colour and \p words, kept together.
void write_name(Markup& page, const RunResult& result, std::string_view controller, std::string_view words);
/// A box that scrolls sideways by itself, so that the page never does.
[[nodiscard]] Markup::Scope scroll_box(Markup& page, std::string_view label);

}  // namespace heed::report
