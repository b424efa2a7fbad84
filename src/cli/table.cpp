#include "table.h"
#include "commands.h"

namespace heed::cli {
namespace {

const std::vector<Option> knowledge_options{
    {"--entities", "NAMES", "guessed", "comma-separated",
     "Roots of the entities, when the input is an ontology"},
    {"--features", "NAMES", "guessed", "comma-separated", "Roots of the features"},
    {"--behaviours", "NAMES", "guessed", "comma-separated", "Roots of the behaviours"},
    {"--feature-roles", "NAMES", "all", "comma-separated", "Roles that bind features; sub-roles count"},
    {"--action-roles", "NAMES", "all", "comma-separated",
     "Roles that bind behaviours; sub-roles count; given alone, the rest is guessed"},
    {"--subclass-role", "NAME", "", "", "Role between individuals that means \"is a kind of\""}};

std::vector<Option> with_knowledge(std::vector<Option> options) {
  options.insert(options.end(), knowledge_options.begin(), knowledge_options.end());
  return options;
}

const Option controller_option{"--controller", "NAME", "all", "", "Only this controller of the scenario"};
const Option seed_option{"--seed", "N", "the scenario's", "0 ... 2^63-1", "Seed of the samples"};
const Option traces_option{"--traces", "N", "the scenario's", "0 ... 10^12",
                           "Sampled traces per chart; 0 for exact figures only"};
const Option threads_option{"--threads", "N", "1", "1 ... 256",
                            "Threads that sample; never changes a figure"};

const std::vector<Option> synth_options{
    {"--output", "FILE", "standard output", "", "Where the controller goes"},
    {"--controller", "NAME", "the only one", "", "Of a scenario: which controller"},
    {"--realizability", "", "", "", "Only ask: print REALIZABLE or UNREALIZABLE"},
    {"--strategy", "FORM", "auto", "explicit|symbolic|auto",
     "A machine listed state by state, or functions (docs/formats/symbolic.md)"},
    {"--max-states", "N", "100000", "1 ... 10^9",
     "With auto: states listed at most, before minimisation; 20 times as many rows, 100 times as many steps "
     "of diagrams"},
    {"--certify", "", "", "", "Also prove the verdict, either one, by ranks that are checked symbolically"},
    {"--solver-option", "NAME=VALUE", "", "",
     "Switch a technique of the solver, once for each; the verdict stays (docs/command-line.md)"},
    {"--on-violation", "WORD", "undefined", "undefined|latch", "What answers an illegal observation"},
    {"--exit-code", "STYLE", "heed", "heed|syntcomp", "0 and 1, or 10 and 20"}};

Command tune_entry() {
  return {"tune",
          "Compare policies exactly: misses, needless reactions, distance of the reaction",
          {{"SCENARIO", "Scenario file"}},
          {{"--false-braking", "P", "the scenario's", "0 ... 1",
            "Name the policy with the fewest misses that reacts needlessly at most so often"},
           {"--noise", "LEVELS", "the scenario's, else 0", "comma-separated",
            "Probabilities with which every feature is missed, and falsely reported, besides"},
           {"--all", "", "", "", "Also print policies that another one beats in everything"},
           {"--output", "FILE", "", "", "Draw misses over needless reactions as SVG, too"}},
          "heed tune examples/stop-sign/stop-sign.toml --false-braking 1/10",
          tune_command};
}

Command profile_entry() {
  return {"profile",
          "Show what perception profiles report: each feature, cell by cell",
          {{"SCENARIO", "Scenario file"}},
          {{"--output", "FILE", "", "", "Draw it as SVG, too"}},
          "heed profile examples/stop-sign/stop-sign.toml --output profiles.svg",
          profile_command};
}

Command drive_entry() {
  return {"drive",
          "Drive the controllers in a simulator of traffic (SUMO), with cars behind them",
          {{"SCENARIO", "Scenario file; its table [drive] says how (docs/formats/drive.md)"}},
          {{"--output", "DIR", "out/<scenario>", "", "Folder for tables and pictures"},
           controller_option,
           {"--profile", "NAME", "all", "", "Only this profile of the scenario"},
           {"--thing", "NAME", "the scenario's", "", "Entity at the line, or \"none\""},
           {"--roads", "N", "the scenario's, else 1000", "1 ... 100000", "Roads per controller and profile"},
           {"--seed", "N", "the scenario's", "0 ... 2^63-1", "Seed of what is seen, and of the cars behind"}},
          "heed drive examples/stop-sign/stop-sign.toml --profile P2",
          drive_command};
}

std::vector<Command> scenario_commands() {
  return {
      {"run",
       "Do a whole job: synthesize, verify, evaluate, report",
       {{"SCENARIO", "Scenario file (docs/formats/scenario.md)"}},
       {{"--output", "DIR", "out/<scenario>", "", "Folder for controllers, specifications and the report"},
        seed_option,
        traces_option,
        threads_option,
        {"--drive", "", "", "", "Also in SUMO, into the report (heed drive)"},
        {"--details", "", "", "", "Also print the formulas of the knowledge base with their axioms"}},
       "heed run examples/stop-sign/stop-sign.toml -o out/stop-sign",
       run_command},
      tune_entry(),
      profile_entry(),
      {"play",
       "Write a page on which people reveal features and watch the controllers drive",
       {{"SCENARIO", "Scenario file"}},
       {{"--output", "FILE", "out/<scenario>/play.html", "", "Where the page goes"},
        {"--seed", "N", "the scenario's", "0 ... 2^32-1", "Seed of the first run that the page draws"}},
       "heed play examples/stop-sign/stop-sign.toml -o play.html",
       play_command},
      drive_entry(),
      {"kb",
       "Show what is known: hierarchy, catalogue, warnings",
       {{"ONTOLOGY", "OWL file, or a scenario"}},
       with_knowledge(
           {{"--quiet", "", "", "", "Only the warnings"},
            {"--evidence", "", "", "",
             "Also what each entity is recognised by, what it is confused with until when, what is certain "
             "meanwhile, and with a scenario what each controller does"},
            {"--reasoner", "WORD", "own", "own|konclude",
             "Also ask Konclude, where it is installed, and say what it adds"}}),
       "heed kb examples/stop-sign/traffic-signs.owl",
       kb_command},
      {"explain",
       "Trace an entity, a behaviour, a feature, a formula or a reaction back to axioms",
       {{"SOURCE", "Scenario or OWL file"},
        {"WHAT", "Entity, behaviour, feature or formula (k3); default: every warning", false}},
       with_knowledge({controller_option,
                       {"--seen", "SYMBOLS", "", "comma-separated",
                        "What is perceived: why is WHAT recognised or prescribed then"},
                       {"--all", "[=N]", "16", "1 ... 1000",
                        "Every justification of each step instead of one, at most N; causes come first"}}),
       "heed explain examples/stop-sign/stop-sign.toml Halt --controller awareness --seen sign,red",
       explain_command},
      {"spec",
       "Print the knowledge base in LTL and the game that is played",
       {{"SCENARIO", "Scenario file"}},
       {controller_option,
        {"--sigma", "", "", "", "Only the knowledge base in LTL"},
        {"--gr1", "", "", "", "Only the specification, as a file that heed synth reads"},
        {"--unicode", "", "", "", "Formulas with mathematical symbols"}},
       "heed spec examples/stop-sign/stop-sign.toml --controller awareness",
       spec_command}};
}

std::vector<Option> simulate_options() {
  return {
      {"--profile", "NAME", "all", "", "Only this profile of the scenario"},
      {"--thing", "NAME", "the scenario's", "", "Entity on the road, or \"none\""},
      {"--chain", "FORMAT", "", "prism|jani", "Write controller and profile as Markov chains, too"},
      {"--output", "FOLDER", ".", "", "Where the chains go"},
      {"--width", "W", "", "0 ... 1", "Sample until every interval is that narrow, or --traces are drawn"},
      {"--rare", "OUTCOME", "", "", "Estimate an outcome too rare for samples, by splitting"},
      {"--particles", "N", "20000", "1 ... 10^8", "Runs kept alive for --rare, in each of 16 repetitions"},
      seed_option,
      traces_option,
      threads_option};
}

std::vector<Command> controller_commands() {
  return {
      {"synth",
       "Synthesize a controller from a specification",
       {{"SPEC", "Specification: .gr1, .slugsin, .structuredslugs or gr1c's .spc; or a scenario"}},
       synth_options,
       "heed synth out/stop-sign/awareness.gr1 -o awareness.controller.json",
       synth_command},
      {"convert",
       "Translate a specification, keeping its verdict",
       {{"SPEC", "Specification file: .gr1, .slugsin, .structuredslugs or gr1c's .spc"}},
       {{"--to", "FORMAT", "by the extension", "slugsin|structuredslugs|gr1c|gr1", "What to write"},
        {"--output", "FILE", "standard output", "", "Where it goes"}},
       "heed convert out/stop-sign/awareness.gr1 --to slugsin -o awareness.slugsin",
       convert_command},
      {"verify",
       "Check a controller against a specification, sharing no code with the solver",
       {{"CONTROLLER", "Controller file, explicit or symbolic"}, {"SPEC", "Specification file"}},
       {{"--most", "N", "1", "1 ... 1000", "How many faults to look for, in an explicit one"}},
       "heed verify out/stop-sign/awareness.controller.json out/stop-sign/awareness.gr1",
       verify_command},
      {"simulate",
       "Evaluate controllers from disk, exactly and by samples",
       {{"SCENARIO", "Scenario file"}, {"CONTROLLER", "Controller files, explicit or symbolic", true, true}},
       simulate_options(),
       "heed simulate examples/stop-sign/stop-sign.toml out/stop-sign/awareness.controller.json --profile P2",
       simulate_command,
       true},
      {"export",
       "Write a controller as code or as a graph",
       {{"CONTROLLER", "Controller file"}},
       {{"--to", "FORMAT", "cpp", "cpp|json|dot", "C++17 header, JSON or Graphviz"},
        {"--output", "FILE", "standard output", "", "Where it goes"}},
       "heed export out/stop-sign/awareness.controller.json --to cpp -o awareness.hpp",
       export_command},
      {"exec",
       "Run a controller: one JSON observation a line in, one JSON reaction a line out",
       {{"CONTROLLER", "Controller file, explicit or symbolic"}},
       {},
       "echo '{\"sign\": true, \"red\": true}' | heed exec out/stop-sign/awareness.controller.json",
       exec_command},
      {"version", "Print the version", {}, {}, "heed version", version_command}};
}

}  // namespace

const std::vector<Option>& common_options() {
  static const std::vector<Option> options{
      {"--json", "", "", "", "One JSON document on standard output and nothing else"},
      {"--timeout", "SECONDS", "none", "> 0", "Wall clock; then exit 3"},
      {"--memory", "SIZE", "4G", "bytes, or with K, M, G", "Resident memory; then exit 3"},
      {"--max-input", "SIZE", "64M", "bytes, or with K, M, G", "Largest input file"}};
  return options;
}

const std::vector<Command>& commands() {
  static const std::vector<Command> table = [] {
    std::vector<Command> all = scenario_commands();
    for (const Command& command : controller_commands()) all.push_back(command);
    return all;
  }();
  return table;
}

}  // namespace heed::cli
