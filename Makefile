# `make demo` and `make test` do all the set-up. Both can be run again, and work offline once installed.
SHELL := /bin/bash
PYTHON ?= $(shell command -v python3.11 || command -v python3)
VENV := .venv
OLDEST := .venv-oldest
BIN := $(VENV)/bin
OUT ?= out

# Install with the pip of environment $(1) what $(2) names; where that was done before and the network is gone, go on.
COMMA := ,
define install
@$(1)/bin/python -m pip install --quiet --disable-pip-version-check --no-input $(2) 2> $(1)/pip.log && touch $@ || \
	if test -f $@; then echo "nothing new can be installed (see $(1)/pip.log): going on with what is here"; \
	else cat $(1)/pip.log; exit 1; fi
endef

# What the compiled loops are made of: an environment is brought up to date where one of these is newer. Where there are
# no loops yet, that of the tests is installed again, since a compiler may have come.
SOURCES := $(wildcard elastica_cad/_native/*.[ch])
MISSING := $(if $(wildcard elastica_cad/_native/loops.*.so),,missing-loops)

.PHONY: demo docs addon generate test lint programs test-main test-windows test-oldest freecad benchmark clean missing-loops

demo: $(VENV)/demo-installed
	$(BIN)/elastica strip examples/arch/arch.dxf --sheet birch-plywood-0.8 --max-width 40 \
		--label ARCH --output $(OUT)/arch --force

# The manual as a site in out/manual, in three languages; a warning is an error.
docs: $(VENV)/docs-installed
	$(BIN)/python docs/build.py $(OUT)/manual

# The folder that a user of FreeCAD puts into Mod. To publish it: make addon MAINTAINER="Name <address>" REPOSITORY=https://...
addon:
	@$(PYTHON) freecad_workbench/make_addon.py $(OUT)/addon/Elastica \
		$(if $(MAINTAINER),--maintainer "$(MAINTAINER)") $(if $(REPOSITORY),--repository "$(REPOSITORY)")

# Writes again what is made from the code: the reference pages of the manual, the typed options of the CAD libraries,
# and the drawing of the packages.
generate: $(VENV)/test-installed
	$(BIN)/python docs/generated_pages.py
	$(BIN)/python docs/generated_options.py
	$(BIN)/python docs/plan.py

# The everyday suite. Programs are installed first, among them the compiler that the environments need; then two jobs
# keep two cores busy: FreeCAD and the other programs, which wait much, beside all that is Python alone.
test: export OPENBLAS_NUM_THREADS = 1
test:
	@$(MAKE) --no-print-directory programs
	$(MAKE) --jobs=2 --output-sync=target $(VENV)/test-installed $(OLDEST)/installed
	$(MAKE) --keep-going --jobs=2 --output-sync=target test-windows test-main

programs:
	@PYTHON="$(PYTHON)" tests/setup.sh

# A file of tests stays on one process: what its tests share is made once.
test-main: programs lint test-oldest
	$(BIN)/python -m pytest -n 2 --dist loadfile --no-loadscope-reorder --durations=30 --ignore=tests/freecad --ignore=tests/smoke --ignore=tests/oldest --ignore=tests/benchmarks

# FreeCAD's own Python modules are loaded into this process, so it is one of its own.
test-windows: programs $(VENV)/test-installed
	$(BIN)/python -m pytest --durations=30 tests/freecad tests/smoke

# The lower bounds of every dependency in pyproject.toml, numpy 1.24 and scipy 1.10 among them, as Debian's FreeCAD has
# them, and no compiled loops, as in the addon.
test-oldest: $(OLDEST)/installed
	ELASTICA_PURE=1 PYTHONPATH="$(CURDIR)" $(OLDEST)/bin/python -m pytest -o addopts="-q --import-mode=importlib --strict-markers" tests/oldest

lint: $(VENV)/test-installed
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy elastica_cad
	$(BIN)/lint-imports

# Campaigns: `make campaign-NAME`; CONTRIBUTING.md says what each proves. docs/trust.md keeps the last result.
MINUTES ?= 60
SEED ?= $(shell date +%y%m%d)
RECORD = PYTHONPATH="$(CURDIR)" $(BIN)/python -m tests.campaign.record
SUITE = $(BIN)/python -m pytest -m campaign
TRUST = $(BIN)/python -m tests.campaign.trust

campaign-windows: programs $(VENV)/test-installed
	$(RECORD) windows $(SUITE) tests/freecad

# FreeCAD 1.0 and 1.1 in folders of their own (needs root), and the newest build123d and CadQuery, each alone.
campaign-releases: programs $(VENV)/test-installed .venv-build123d/installed .venv-cadquery/installed
	-$(RECORD) "releases: FreeCAD 1.0" tests/freecad/release.sh trixie
	-$(RECORD) "releases: FreeCAD 1.1" tests/freecad/release.sh sid
	-ELASTICA_KERNELS=build123d $(RECORD) "releases: newest build123d" .venv-build123d/bin/python -m pytest \
		-o addopts="-q --import-mode=importlib" tests/cad
	ELASTICA_KERNELS=cadquery $(RECORD) "releases: newest CadQuery" .venv-cadquery/bin/python -m pytest \
		-o addopts="-q --import-mode=importlib" tests/cad

# README's commands on a Debian that has Python, make, git and the PACKAGES alone (needs root).
campaign-fresh: $(VENV)/created
	$(RECORD) fresh tests/campaign/fresh.sh $(PACKAGES)

campaign-oldest: $(VENV)/test-installed $(OLDEST)/installed
	ELASTICA_PURE=1 $(RECORD) oldest $(OLDEST)/bin/python -m pytest \
		-o addopts="-q --import-mode=importlib --strict-markers" -m core tests/house tests/unit tests/properties tests/validation

campaign-banks: programs $(VENV)/test-installed
	$(RECORD) banks $(SUITE) -n 2 tests/unit tests/properties tests/validation tests/contract tests/house

campaign-bodies: programs $(VENV)/test-installed
	$(RECORD) bodies $(SUITE) -n 2 tests/cad

campaign-galleries: $(VENV)/test-installed
	$(RECORD) galleries $(SUITE) -n 2 tests/examples

# Sentences are random letters: nobody may read one.
campaign-letters: programs $(VENV)/test-installed
	$(RECORD) letters $(BIN)/python -m pytest -n 2 -p tests.campaign.letters tests/unit tests/contract tests/properties

campaign-manual: programs $(VENV)/test-installed
	$(RECORD) manual $(SUITE) -n 2 tests/manual

campaign-programs: programs $(VENV)/test-installed
	$(RECORD) programs $(SUITE) tests/smoke

campaign-studio: programs $(VENV)/test-installed
	$(RECORD) studio $(SUITE) -s tests/studio

campaign-elements: programs .venv-campaign/installed
	$(RECORD) elements .venv-campaign/bin/python -m tests.campaign.finite_elements --out $(OUT)/campaign

# The steps for Linux of the release workflow: source archive, wheels, core and contract tests. PYTHONS: more to test on.
campaign-release: .venv-release/installed
	$(RECORD) release .venv-release/bin/python -m tests.campaign.workflow $(PYTHONS)

campaign-solids: programs .venv-campaign/installed
	$(RECORD) solids .venv-campaign/bin/python tests/campaign/solids.py --again --out $(OUT)/campaign --minutes $(MINUTES)

campaign-typing: .venv-campaign/installed
	$(RECORD) typing .venv-campaign/bin/python -m tests.campaign.type_checkers

campaign-mutants: $(VENV)/test-installed
	$(RECORD) mutants $(TRUST).mutants --count 400 --minutes $(MINUTES) --seed $(SEED) --out $(OUT)/campaign

campaign-fuzz: $(VENV)/test-installed
	-$(RECORD) "fuzz: files" $(TRUST).files --cases 100000 --minutes $(MINUTES) --seed $(SEED) --out $(OUT)/campaign
	-$(RECORD) "fuzz: typed files" $(TRUST).typed --files 2000 --minutes $(MINUTES) --seed $(SEED) --out $(OUT)/campaign
	-$(RECORD) "fuzz: lost curves" $(TRUST).lost_curves --files 500 --minutes $(MINUTES) --seed $(SEED) --out $(OUT)/campaign
	-$(RECORD) "fuzz: commands" $(TRUST).commands --runs 3000 --minutes $(MINUTES) --seed $(SEED) --out $(OUT)/campaign
	-$(RECORD) "fuzz: nonsense in Python" $(TRUST).nonsense --calls 20000 --seed $(SEED)
	-$(RECORD) "fuzz: compiled code" $(TRUST).kernels --cases 20000
	-$(RECORD) "fuzz: limits that are met" $(TRUST).met_checks --solves 10000 --minutes $(MINUTES) --seed $(SEED) --out $(OUT)/campaign
	-$(RECORD) "fuzz: cutting files" $(TRUST).written --strips 1000 --minutes $(MINUTES) --seed $(SEED) --out $(OUT)/campaign
	$(RECORD) "fuzz: designs" $(TRUST).designs --designs 2000 --minutes $(MINUTES) --seed $(SEED) --out $(OUT)/campaign

campaign-held: $(VENV)/test-installed
	$(RECORD) held $(TRUST).held_strips --curves 200 --minutes $(MINUTES) --out $(OUT)/campaign

campaign-kills: $(VENV)/test-installed
	$(RECORD) kills $(TRUST).faults --out $(OUT)/campaign

campaign-soak: $(VENV)/test-installed
	$(RECORD) soak $(TRUST).soak --minutes $(MINUTES) --out $(OUT)/campaign

# FreeCAD with the workbench as it lies here and an example open (0.20 takes options after the file only).
freecad:
	@command -v freecad >/dev/null || { $(MAKE) --no-print-directory programs; }
	freecad freecad_workbench/freecad/elastica_wb/example.py -M "$(CURDIR)"

# Ratios of times in one run, on a machine that does nothing else; docs/explanation/speed.md is written anew.
benchmark: programs $(VENV)/benchmark-installed
	@mkdir -p $(OUT)
	$(BIN)/python -m pytest tests/benchmarks --benchmark-enable --benchmark-only -o addopts="-q --import-mode=importlib" \
		--benchmark-json=$(OUT)/benchmark.json
	$(BIN)/python docs/speed_tables.py $(OUT)/benchmark.json

$(VENV)/created:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
		{ echo "elastica_cad needs Python 3.11 or newer; say which with make PYTHON=/path/to/python3.11"; exit 1; }
	@$(PYTHON) -m venv $(VENV) || \
		{ echo "Python cannot make virtual environments here: install its venv module (Debian: apt install python3-venv)"; exit 1; }
	@touch $@

$(VENV)/demo-installed: $(VENV)/created pyproject.toml $(SOURCES)
	$(call install,$(VENV),--editable ".[plot$(COMMA)mesh$(COMMA)studio]")

$(VENV)/docs-installed: $(VENV)/created pyproject.toml $(SOURCES)
	$(call install,$(VENV),--editable ".[plot$(COMMA)docs]")

$(VENV)/test-installed: $(VENV)/created pyproject.toml $(SOURCES) $(MISSING)
	$(call install,$(VENV),--editable ".[plot$(COMMA)dev]" "build123d==0.12.0" "cadquery==2.8.0")
	@touch $(VENV)/demo-installed

$(VENV)/benchmark-installed: $(VENV)/test-installed
	$(call install,$(VENV),--editable ".[benchmark]")

ALONE := $(PYTHON) -m venv
$(OLDEST)/installed: $(VENV)/created pyproject.toml tests/oldest/requirements.txt
	@$(ALONE) $(OLDEST)
	$(call install,$(OLDEST),--requirement tests/oldest/requirements.txt)

.venv-campaign/installed: $(VENV)/created
	@$(ALONE) .venv-campaign
	$(call install,.venv-campaign,--editable . "build123d==0.12.0" "cadquery==2.8.0" gmsh basedpyright)

.venv-release/installed: $(VENV)/created
	@$(ALONE) .venv-release
	$(call install,.venv-release,check-jsonschema zizmor)

.venv-build123d/installed .venv-cadquery/installed: .venv-%/installed: $(VENV)/created pyproject.toml
	@$(ALONE) .venv-$*
	$(call install,.venv-$*,--editable ".[plot$(COMMA)mesh$(COMMA)$*]" "pytest>=8" "hypothesis>=6.100" "shapely>=2.0")

clean:
	rm -rf $(VENV) .venv-* $(OUT)
