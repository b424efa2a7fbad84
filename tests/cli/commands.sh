#!/usr/bin/env bash
# Every command once, as text and as JSON.
. "$(dirname "$0")/lib.sh"
scenario=examples/stop-sign/stop-sign.toml
ontology=examples/stop-sign/traffic-signs.owl

check 'run' exits 0 "$heed" run "$scenario" -o "$work/run"
check 'run prints the table' says '129691/144000'
for file in report.html report.json awareness.controller.json tree.gr1; do check "run writes $file" test -s "$work/run/$file"; done
check 'run --json' exits 0 "$heed" run "$scenario" -o "$work/json" --json
check 'run --json is JSON' is_json
check 'run --json equals report.json but for timings' node -e '
  const fs = require("fs"), [a, b] = process.argv.slice(1).map(f => JSON.parse(fs.readFileSync(f)));
  delete a.timings; delete b.timings; process.exit(JSON.stringify(a) === JSON.stringify(b) ? 0 : 1)' "$work/out" "$work/run/report.json"
check 'kb' exits 0 "$heed" kb "$ontology"
check 'kb shows the stop sign' says 'stop (stop_sign): white, has ground colour red'
check 'kb --json' exits 0 "$heed" kb "$ontology" --json
check 'kb --json is JSON' is_json
check 'kb --reasoner refuses what it does not know' exits 2 "$heed" kb "$ontology" --reasoner=fact
if command -v Konclude >/dev/null; then
  check 'kb --reasoner=konclude' exits 0 "$heed" kb "$ontology" --reasoner=konclude
  check 'Konclude agrees on the stop sign' says 'Konclude: says the same of every class'
else
  echo 'skipped: no Konclude (Debian: konclude)'
fi
check 'explain a reaction' exits 0 "$heed" explain "$scenario" Halt --controller awareness --seen sign,red
check 'explain says why' says 'prescribes some halt'
check 'explain an entity of an ontology' exits 0 "$heed" explain "$ontology" StopSign
check 'explain --json' exits 0 "$heed" explain "$scenario" k1 --json
check 'explain --json is JSON' is_json
check 'explain --all' exits 0 "$heed" explain "$ontology" NoEntrySign --all
check 'lists each justification' says 'justification 4 of 4'
check 'explain --all=N' exits 0 "$heed" explain "$ontology" --all=2 NoEntrySign
check 'stops there' test -z "$(grep 'justification [34]' "$work/out")"
check 'and says so' says '... there are more'
check 'explain --all has a range' exits 2 "$heed" explain "$ontology" NoEntrySign --all=0
check 'explain --all --json' exits 0 "$heed" explain "$ontology" NoEntrySign --all --json
check 'lists them, short ones first' node -e '
  const steps = JSON.parse(require("fs").readFileSync(process.argv[1])).explanations[0].steps;
  const sizes = steps.map(s => s.justifications.map(j => j.axioms.length));
  const sorted = sizes.every(list => list.every((n, i) => i === 0 || list[i - 1] <= n));
  process.exit(sorted && steps.every(s => s.complete) && sizes.some(list => list.length === 4) ? 0 : 1)' "$work/out"
check 'explain --all of a reaction' exits 0 "$heed" explain "$scenario" Halt --controller awareness --seen sign,red --all
check 'justifies what it prescribes' says 'justification 1 of 1'
cat >"$work/union.ofn" <<'ONTOLOGY'
Prefix(:=<http://example.org/u#>)
Ontology(<http://example.org/u>
SubClassOf(:Bike :Vehicle) SubClassOf(:EBike :Bike) SubClassOf(:Car :Vehicle)
SubClassOf(:Bike ObjectSomeValuesFrom(:has :Small)) SubClassOf(:Small :Look)
SubClassOf(:Bike ObjectMaxCardinality(3 :has :Look)) SubClassOf(:Car ObjectSomeValuesFrom(:does :Go)) SubClassOf(:Go :Act)
)
ONTOLOGY
roots=(--entities Vehicle --features Look --behaviours Act --feature-roles has --action-roles does)
check 'kb tells what was left out' exits 0 "$heed" kb "$work/union.ofn" "${roots[@]}" --quiet
check 'and which classes it touches' says 'a number restriction other than `max 0`, `max 1` and `min 1`; it touches Bike, Look'
check 'and of which entities more may be true' test "$(grep -A 9 'more may be true' "$work/out" | tail -n +2)" = "$(printf '  Bike: a6\n  EBike: a6')"
check 'kb tells so in JSON' exits 0 "$heed" kb "$work/union.ofn" "${roots[@]}" --json
check 'per axiom and per entity' node -e '
  const kb = JSON.parse(require("fs").readFileSync(process.argv[1]));
  const touched = kb.entities.filter(e => e.left_out.includes(kb.left_out[0].axiom)).map(e => e.label).sort();
  process.exit(kb.left_out[0].touches.join() === "Bike,Look" && touched.join() === "Bike,EBike" ? 0 : 1)' "$work/out"
sed '5i DLSafeRule(Body(ClassAtom(:Bike Variable(<urn:x>))) Head(ClassAtom(:Car Variable(<urn:x>))))' "$work/union.ofn" >"$work/rule.ofn"
check 'kb of an ontology with a rule' exits 0 "$heed" kb "$work/rule.ofn" "${roots[@]}" --quiet
check 'says that it is left out, and where' warns 'rule.ofn:5:1: warning: DLSafeRule is no axiom of OWL 2 and is left out'
check 'so does explain' exits 0 "$heed" explain "$work/rule.ofn" Bike "${roots[@]}"
check 'on standard error' warns 'rule.ofn:5:1: warning: DLSafeRule'
check 'the warnings of the catalogue are told once' exits 0 "$heed" kb "$work/union.ofn" "${roots[@]}" --quiet
check 'on standard output' test ! -s "$work/err"
check 'kb of a scenario' exits 0 "$heed" kb "$scenario" --quiet
check 'names the symbol that excludes less than it could' says "'hasShape Octagon' would rule out 52 entities more"
check 'and says how' says 'hint: report what = "hasShape Octagon"'
check 'and what is bound to nothing' says "bound to nothing of the plant: 'follow the direction', 'be alert'"
check 'with what prescribes it' says 'bus stop SubClassOf prescribes some be alert'
check 'which is done here' exits 0 "$heed" kb examples/stop-sign/policies.toml --evidence
check 'so nothing is said' test -z "$(grep excludes-less "$work/out")"
check 'kb --evidence says what controllers do' says "'at-least-2': never recognised; slow down on sign; nothing on red; halt (X stopping), give way on all of it"
check 'kb --evidence --json' exits 0 "$heed" kb examples/stop-sign/policies.toml --evidence --json
check 'with each controller' node -e '
  const stop = JSON.parse(require("fs").readFileSync(process.argv[1])).evidence.find(e => e.atom === "stop_sign");
  const two = stop.controllers.find(c => c.name === "at-least-2");
  process.exit(two.evidence.length === 3 && two.reactions.some(r => r.bound.includes("halt")) ? 0 : 1)' "$work/out"
check 'spec' exits 0 "$heed" spec "$scenario" --controller awareness
check 'spec shows sigma' says 'G (sign & red -> stop_sign)'
check 'spec --gr1' exits 0 "$heed" spec "$scenario" --controller tree --gr1
cp "$work/out" "$work/tree.gr1"
check 'synth' exits 0 "$heed" synth "$work/tree.gr1" -o "$work/tree.json"
check 'synth says so' says REALIZABLE
check 'synth --realizability' exits 0 "$heed" synth "$work/tree.gr1" --realizability
check 'its first line is the verdict' test "$(head -n 1 "$work/out")" = REALIZABLE
check 'synth --exit-code syntcomp' exits 10 "$heed" synth "$work/tree.gr1" --realizability --exit-code=syntcomp
check 'synth --solver-option' exits 0 "$heed" synth "$work/tree.gr1" --realizability --solver-option frontier-sets=off --solver-option cluster-nodes=0
check 'synth --solver-option knows its names' exits 2 "$heed" synth "$work/tree.gr1" --realizability --solver-option frontier-set=off
check 'and names the nearest' warns "did you mean 'frontier-sets'"
check 'synth --solver-option knows its values' exits 2 "$heed" synth "$work/tree.gr1" --realizability --solver-option frontier-sets=no
check 'synth --certify' exits 0 "$heed" synth "$work/tree.gr1" --realizability --certify
check 'synth --certify says so' says 'certified: '
check 'synth --strategy symbolic' exits 0 "$heed" synth "$work/tree.gr1" --strategy symbolic --certify -o "$work/tree.symbolic.json"
check 'synth says which' says 'symbolic strategy: '
check 'verify a symbolic one' exits 0 "$heed" verify "$work/tree.symbolic.json" "$work/tree.gr1"
check 'verify says so' says VERIFIED
check 'verify another specification' exits 2 "$heed" verify "$work/tree.symbolic.json" "$work/run/base.gr1"
check 'verify a symbolic one --json' exits 0 "$heed" verify "$work/tree.symbolic.json" "$work/tree.gr1" --json
check 'is JSON' is_json
printf '%s\n' '{}' '{"sign": true}' nonsense '{"reset": true}' >"$work/in"
check 'exec of a symbolic one' exits 0 "$heed" exec "$work/tree.symbolic.json" <"$work/in"
check 'answers each line' test "$(wc -l <"$work/out")" -eq 4
cp "$work/out" "$work/symbolic.out"
check 'exec of the explicit one' exits 0 "$heed" exec "$work/tree.json" <"$work/in"
check 'recognises the same' test "$(sed 's/"action".*//' "$work/out")" = "$(sed 's/"action".*//' "$work/symbolic.out")"
printf '[input]\nr : boolean\n[output]\ng : boolean\n[sys justice]\ng & r\n' >"$work/lost.gr1"
check 'synth of a scenario' exits 0 "$heed" synth "$scenario" --controller awareness --strategy symbolic --certify -o "$work/awareness.symbolic.json"
check 'is what spec --gr1 prints' exits 0 "$heed" verify "$work/awareness.symbolic.json" "$work/run/awareness.gr1"
check 'synth of a scenario asks which' exits 2 "$heed" synth "$scenario"
check 'and names them' warns '--controller base|tree|awareness|tree-or-full'
check 'synth of a file has no controllers' exits 2 "$heed" synth "$work/tree.gr1" --controller tree
check 'an unrealizable one is certified' exits 1 "$heed" synth "$work/lost.gr1" --certify --json
check 'certificate in JSON' node -e 'process.exit(JSON.parse(require("fs").readFileSync(process.argv[1])).certificate.verdict === "VERIFIED" ? 0 : 1)' "$work/out"
check 'verify' exits 0 "$heed" verify "$work/tree.json" "$work/tree.gr1"
check 'verify says so' says VERIFIED
check 'verify --json' exits 0 "$heed" verify "$work/tree.json" "$work/tree.gr1" --json
check 'verify --json is JSON' is_json
check 'simulate' exits 0 "$heed" simulate "$scenario" "$work/run/awareness.controller.json" --profile P2
check 'simulate is exact' says '1/3'
check 'simulate --chain' exits 0 "$heed" simulate "$scenario" "$work/run/awareness.controller.json" --chain prism --output "$work/chains"
check 'a chain for each profile' exits 0 grep -q 'label "outcome_stop_in_2"' "$work/chains/awareness-p1.prism" "$work/chains/awareness-p3.prism"
check 'simulate --chain knows its formats' exits 2 "$heed" simulate "$scenario" "$work/run/awareness.controller.json" --chain prsm
check 'simulate --rare' exits 0 "$heed" simulate "$scenario" "$work/run/base.controller.json" --profile P3 --rare 'stop in 4' --particles 2000
check 'simulate --rare estimates' says 'stop in 4 by splitting: 0.00'
check 'simulate --rare knows the outcomes' exits 2 "$heed" simulate "$scenario" "$work/run/base.controller.json" --rare 'stop in 9'
check 'simulate --width' exits 0 "$heed" simulate "$scenario" "$work/run/base.controller.json" --profile P2 --width 0.01
check 'simulate --width is a number' exits 2 "$heed" simulate "$scenario" "$work/run/base.controller.json" --width wide
check 'profile' exits 0 "$heed" profile "$scenario" --output "$work/profile.svg"
check 'profile prints each feature per cell' says 'red                0.0000   0.2500   0.4375   0.5938   1.0000'
check 'profile draws the picture of the documentation' cmp "$work/profile.svg" docs/formats/profile.svg
check 'profile --json' exits 0 "$heed" profile "$scenario" --json
check 'profile --json is JSON' is_json
check 'profile --json has fractions' says '"7/16"'
check 'tune' exits 0 "$heed" tune "$scenario" --false-braking 1/10
check 'tune names a policy' says 'tree-or-full sign -> octagon'
check 'tune says how hard the car brakes' says 'hardest'
check 'tune --output draws' exits 0 "$heed" tune "$scenario" --output "$work/front.svg"
check 'and draws the picture of the documentation' cmp "$work/front.svg" docs/policies.svg
for figure in '0.296875   0.511628' '0.475000   0.256205' '0.367188   0.000000' '0.549074   0.000000' 'misses 47/128, needless 0'; do
  check "tune prints what the documentation says: $figure" says "$figure"
done
check 'tune finds none under an impossible bound' exits 1 "$heed" tune "$scenario" --false-braking 0 --noise 1/2
check 'tune takes a probability' exits 2 "$heed" tune "$scenario" --false-braking 3/2
check 'tune takes levels' exits 2 "$heed" tune "$scenario" --noise 0,much
check 'tune --json' exits 0 "$heed" tune "$scenario" --json
check 'tune --json is JSON' is_json
check 'simulate --json' exits 0 "$heed" simulate "$scenario" "$work/run/base.controller.json" --json --traces 0
check 'simulate --json is JSON' is_json
for format in cpp json dot; do check "export --to $format" exits 0 "$heed" export "$work/run/awareness.controller.json" --to $format; done
check 'version' exits 0 "$heed" version
check 'version --json' exits 0 "$heed" version --json
check 'version --json is JSON' is_json
check 'the second example gives the sigma of the paper' exits 0 "$heed" spec examples/yield-roles/yield.toml --sigma
check 'recognition' says 'G (sign & red & triangle -> yield)'
check 'prescription' says "G (yield -> X giveWay)"
check 'an ontology of individuals needs no roots' exits 0 "$heed" kb examples/yield-roles/yield.owl
check 'explain --all of an individual' exits 0 "$heed" explain examples/yield-roles/yield.owl yield --all
check 'has what is asserted of it' says 'justification 1 of 1'
check 'an ontology of individuals is shown' exits 0 "$heed" kb examples/yield-roles/yield.owl
check 'it shows what the sign looks like' says 'yield sign (yield): red, triangle -> give way'
check 'another domain' exits 0 "$heed" run examples/warehouse/warehouse.toml -o "$work/warehouse"
check 'speaks of no sign' test -z "$(grep -i 'sign\|brak' "$work/out")"
check 'says who comes first' says "'Wait' comes first"
check 'an unknown command with --json' exits 2 "$heed" rn --json
check 'is told in JSON' is_json
sed 's/^M1 -hard_stop-> S0//' examples/stop-sign/car.fts >"$work/car.fts"
sed "s|\"traffic-signs.owl\"|\"$PWD/examples/stop-sign/traffic-signs.owl\"|" examples/stop-sign/stop-sign.toml >"$work/no-hard-stop.toml"
check 'a car that cannot stop hard' exits 1 "$heed" run "$work/no-hard-stop.toml" -o "$work/none"
check 'is told by its state' says 'In M1 there is no way out'
check 'with the way there' says 'How it comes to that: M0 sees nothing: go'
finish
