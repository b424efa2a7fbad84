#pragma once

#include <heed/logic/parse.h>
#include <heed/model/fts.h>
#include <heed/spec/compose.h>

#include <string>
#include <vector>

/// The case study by hand: the car, what is perceived, and "any two of sign, red, octagon" (docs/case-study
/// figures).
namespace case_study {

inline constexpr const char* car_text = R"(states: M4 M3 M2 M1 M0 S4 S3 S2 S1 S0
initial: M0 S0
label moving: M4 M3 M2 M1 M0
label stopping: S4 S3 S2 S1 S0
value location: M4=4 M3=3 M2=2 M1=1 M0=0 S4=4 S3=3 S2=2 S1=1 S0=0
M4 -go-> M3
M3 -go-> M2
M2 -go-> M1
M1 -go-> M0
M0 -go-> M4
S4 -slow_down-> S3
S3 -slow_down-> S2
S2 -slow_down-> S1
S1 -slow_down-> S0
S0 -slow_down-> S4
M4 -slow_down-> S3
M3 -slow_down-> S2
M2 -slow_down-> S1
M1 -hard_stop-> S0
M0 -slow_down-> S4
S4 -go-> M3
S3 -go-> M2
S2 -go-> M1
S1 -go-> M0
S0 -go-> M4
)";

inline heed::model::Fts car() {
  return heed::model::read_fts(heed::util::SourceText("car.fts", car_text));
}

inline heed::spec::Composition awareness() {
  heed::spec::Composition out;
  out.name = "awareness";
  out.initial_states = {4};
  for (const char* name : {"sign", "red", "octagon", "stop_sign"}) {
    out.inputs.push_back({name, heed::model::Domain::boolean(), ""});
    out.perception.push_back(
        {heed::logic::parse("G (location != 0 & " + std::string(name) + " -> X " + name + ")")});
  }
  out.first_observation = heed::model::Valuation(4, 0);
  out.perception.push_back({heed::logic::parse("G (red | octagon -> sign)")});
  out.perception.push_back({heed::logic::parse("G (stop_sign -> red | octagon)")});
  using Role = heed::model::OutputRole;
  out.definitions.push_back({"Halt", heed::logic::parse("StopSign"), Role::Prescribed, "", {"a2"}});
  out.definitions.push_back({"StopSign",
                             heed::logic::parse("sign & red | sign & octagon | red & octagon"),
                             Role::Recognised,
                             "",
                             {"a1"}});
  out.bindings.push_back({"Halt", heed::logic::parse("stopping"), "stopping"});
  out.only_when_prescribed = true;
  out.guarantees.push_back({heed::logic::parse("GF location = 0"), "GF location = 0"});
  out.guarantees.push_back({heed::logic::parse("GF location != 0"), "GF location != 0"});
  return out;
}

}  // namespace case_study
