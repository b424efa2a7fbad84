# One command per chore; what it needs is installed by scripts/setup.
JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
.PHONY: demo test bench corpus nightly fuzz format lint sanitize install clean

demo:                ## install, build, run the case study, write the report
	@scripts/setup core
	@cmake --preset release >/dev/null
	@cmake --build --preset release -j $(JOBS) -- --quiet
	@build/release/bin/heed run examples/stop-sign/stop-sign.toml --output out/stop-sign

test:                ## install, build, run every test
	@scripts/setup test
	@cmake --preset dev >/dev/null
	@cmake --build --preset dev -j $(JOBS) -- --quiet
	@ctest --preset dev -j $(JOBS) -LE 'slow|corpus'
	@$(MAKE) --no-print-directory corpus

corpus:              ## the tests over inputs that nobody here wrote (HEED_CORPUS)
	@scripts/setup test
	@cmake --preset dev >/dev/null
	@cmake --build --preset dev -j $(JOBS) -- --quiet
	@ctest --preset dev -j $(JOBS) -L corpus --no-tests=ignore

# A test of processor time, which sanitizers multiply.
NOT_SANITIZED = RdfXml.RefusesHostileEntities
ROOMS ?= util logic owl dl bdd model awareness spec game strategy check certify sim export report
sanitize:            ## unit tests of ROOMS under address and undefined-behaviour sanitizers
	@scripts/setup test
	@cmake --preset asan-ubsan >/dev/null
	@cmake --build --preset asan-ubsan -j $(JOBS) --target $(ROOMS:%=%_test) -- --quiet
	@ctest --preset asan-ubsan -j $(JOBS) -R "^($$(echo $(ROOMS) | tr ' ' '|'))[.]" \
	  -LE 'slow|corpus' -E '$(NOT_SANITIZED)'

bench:               ## build and run the benchmarks
	@scripts/setup test extras
	@cmake --preset bench >/dev/null
	@cmake --build --preset bench -j $(JOBS) -- --quiet
	@bench/run

nightly: test sanitize lint   ## what takes longer: everything, with the slow sets
	@HEED_SLOW=1 ctest --preset dev -j $(JOBS)
	@scripts/fuzz $(FUZZ_SECONDS)

FUZZ_SECONDS ?= 600
fuzz:                ## the fuzz targets, FUZZ_SECONDS each
	@scripts/setup core test extras
	@scripts/fuzz $(FUZZ_SECONDS)

format:              ## rewrite the sources in the house style
	@scripts/setup extras
	@git ls-files '*.cpp' '*.h' | xargs clang-format-16 -i

lint:                ## formatting and naming, nothing is changed
	@scripts/setup core extras
	@scripts/lint

install:             ## build and install below PREFIX
	@scripts/setup core
	@cmake --preset release >/dev/null
	@cmake --build --preset release -j $(JOBS) -- --quiet
	@cmake --install build/release --prefix $(PREFIX)

clean:
	@rm -rf build out
