# Tumble: one command for each purpose. It installs what is missing (Debian and its relatives), runs
# CMake and adds nothing else: see CMakePresets.json for the same without make.
#
#   SETUP=no    only say which packages are missing, and stop if there are any
#   SETUP=skip  look for no packages: this machine has all that is needed, from wherever

BUILD_PACKAGES   := g++ cmake ninja-build libeigen3-dev libtomlplusplus-dev libgsl-dev
COMMAND_PACKAGES := $(BUILD_PACKAGES) libcli11-dev libstb-dev
TEST_PACKAGES    := $(COMMAND_PACKAGES) catch2
FIGURE_PACKAGES  := $(BUILD_PACKAGES) gnuplot-nox fonts-dejavu-core
READY_PACKAGES   := xz-utils
SITE_PACKAGES    := $(FIGURE_PACKAGES) doxygen doxygen-awesome-css libjs-mathjax python3 $(READY_PACKAGES)
# npm comes with node where node is not Debian's, so the command is looked for first.
LIVE_PACKAGES    := $(BUILD_PACKAGES) emscripten $(if $(shell command -v npm 2>/dev/null),,npm)
BOOK_PACKAGES    := $(SITE_PACKAGES) chromium
FUZZ_PACKAGES    := $(BUILD_PACKAGES) catch2 clang libclang-rt-dev
BENCH_PACKAGES   := g++ cmake ninja-build libeigen3-dev libtomlplusplus-dev pkgconf libode-dev libbullet-dev
CHECK_PACKAGES   := $(TEST_PACKAGES) $(SITE_PACKAGES) $(LIVE_PACKAGES) chromium clang libclang-rt-dev clang-format

SETUP ?= yes
JOBS  ?= $(shell nproc 2>/dev/null || echo 2)
export SETUP JOBS

# Only what is set is handed on; CMake remembers the rest.
OPTIONS := $(if $(WERROR),-DTUMBLE_WERROR=$(WERROR)) \
           $(if $(TUMBLE_SHARED_DATA),-DTUMBLE_SHARED_DATA="$(abspath $(TUMBLE_SHARED_DATA))")
CONFIGURE := cmake --preset release $(OPTIONS)
MAKE_IT   := cmake --build --preset release -j $(JOBS)
RUN_TESTS := ctest --progress --no-label-summary -j $(JOBS)

FUZZ_PRESET := $(if $(filter off,$(SANITIZERS)),fuzz-fast,fuzz)

.PHONY: help view command test test-long figures figure check fuzz worlds bench live ready site book clean

help:  ## this list
	@echo "usage: make TARGET"
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  \1 \2/p' Makefile | \
	  while read -r name what; do printf '  %-10s %s\n' "$$name" "$$what"; done
	@echo "variables: SETUP=no (only name missing packages), SETUP=skip (do not look), JOBS=N"

view:  ## throw boxes at any scene, in the browser, at once; SCENE=pyramid: simulate that one and play it there
ifdef SCENE
	@cmake/setup $(COMMAND_PACKAGES)
	$(CONFIGURE)
	$(MAKE_IT) --target tumble_command
	build/release/bin/tumble view $(SCENE)
else
	@cmake/setup $(READY_PACKAGES)
	@cmake/ready --open
endif

test:  ## build and run the tests; ONLY=tag runs those with a tag, such as ONLY=separation
	@cmake/setup $(TEST_PACKAGES)
	$(CONFIGURE) -DTUMBLE_TESTS=ON
	$(MAKE_IT) --target tests
	$(RUN_TESTS) --preset release $(if $(ONLY),-L '^$(ONLY)$$')

test-long:  ## the tests that take minutes: millions of cases, long runs
	@cmake/setup $(TEST_PACKAGES)
	$(CONFIGURE) -DTUMBLE_TESTS=ON
	$(MAKE_IT) --target tests
	$(RUN_TESTS) --preset long $(if $(ONLY),-L '^$(ONLY)$$')

command:  ## build the command that runs scenes: build/release/bin/tumble
	@cmake/setup $(COMMAND_PACKAGES)
	$(CONFIGURE)
	$(MAKE_IT) --target tumble_command

figures:  ## compute and draw every figure into build/figures; open index.html there
	@cmake/setup $(FIGURE_PACKAGES)
	$(CONFIGURE) -DTUMBLE_FIGURES=ON
	$(MAKE_IT) --target figures

figure:  ## one figure with other parameters: NAME=zeno (or its beginning) SET='restitution=0.9'
	@figures/draw --program '$(NAME)' >/dev/null
	@cmake/setup $(FIGURE_PACKAGES)
	@$(CONFIGURE) -DTUMBLE_FIGURES=ON >/dev/null
	@program=$$(figures/draw --program '$(NAME)') && $(MAKE_IT) --target "$$program" && \
	  NAME='$(NAME)' SET='$(SET)' figures/draw build/release/bin build/figures/tried

check:  ## all that continuous integration does: both compilers, sanitizers, fuzzing, equal bits, format, site, live
	@cmake/setup $(CHECK_PACKAGES)
	cmake/check

fuzz:  ## search for inputs that break a promise, MINUTES=10; SANITIZERS=off: faster, with assertions alone
	@cmake/setup $(FUZZ_PACKAGES)
	cmake --preset $(FUZZ_PRESET) $(OPTIONS)
	cmake --build --preset $(FUZZ_PRESET) -j $(JOBS)
	MINUTES=$(or $(MINUTES),10) BUILD=build/$(FUZZ_PRESET) cmake/fuzz

worlds:  ## random worlds with every technique, WORLDS=10000: rows of verification/promises.md, and promises that break
	@cmake/setup $(TEST_PACKAGES)
	$(CONFIGURE) -DTUMBLE_TESTS=ON
	$(MAKE_IT) --target fuzz_worlds
	build/release/bin/fuzz_worlds techniques | \
	  xargs -P $(JOBS) -I{} build/release/bin/fuzz_worlds {} 1 $(or $(WORLDS),10000)

bench:  ## measure against the engines that are installed
	@cmake/setup $(BENCH_PACKAGES)
	cmake --preset bench $(OPTIONS)
	cmake --build --preset bench -j $(JOBS)

live:  ## the page that make view opens, built from the sources: build/live/index.html
	@cmake/setup $(LIVE_PACKAGES)
	$(CONFIGURE)
	cmake/live $(OPTIONS)

ready:  ## renew the page that make view opens, live/ready, when a test asks for it
	@cmake/setup $(LIVE_PACKAGES) $(READY_PACKAGES)
	$(CONFIGURE)
	$(MAKE_IT) --target live_hashes
	cmake/live $(OPTIONS)
	cmake/ready --renew

site:  ## chapters, figures, ledger, reference and live page as a web site: build/site/index.html
	@cmake/setup $(SITE_PACKAGES)
	$(CONFIGURE) -DTUMBLE_FIGURES=ON
	$(MAKE_IT) --target figures
	$(MAKE_IT) --target pages
	cmake/site

book: site  ## ideas and algorithms of all chapters to print: build/book.pdf
	@cmake/setup $(BOOK_PACKAGES)
	site/book.py build/site build/book.pdf

clean:  ## remove build/
	rm -rf build
