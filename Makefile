# Two commands do all the set-up: `make demo` and `make test`. Both can be run again, and work offline once installed.
SHELL := /bin/bash
PYTHON ?= $(shell command -v python3.11 || command -v python3)
VENV := .venv
BIN := $(VENV)/bin
OUT ?= out

# Install with the pip of environment $(1) what $(2) names; where that was done before and the network is gone, go on.
COMMA := ,
define install
@$(1)/bin/python -m pip install --quiet --disable-pip-version-check --no-input $(2) 2> $(1)/pip.log && touch $@ || \
	if test -f $@; then echo "nothing new can be installed (see $(1)/pip.log): going on with what is here"; \
	else cat $(1)/pip.log; exit 1; fi
endef

# What the compiled kernels are made of: an environment is brought up to date where one of these is newer.
KERNELS := $(wildcard elastica_cad/_native/*.[ch])

.PHONY: demo docs test lint test-core test-kernels test-freecad test-programs freecad benchmark campaign campaign-trust clean

demo: $(VENV)/demo-installed
	$(BIN)/elastica strip examples/arch/arch.dxf --sheet birch-plywood-0.8 --max-width 40 \
		--label ARCH --output $(OUT)/arch --force

# The manual as a site in out/manual, in three languages; a warning is an error.
docs: $(VENV)/docs-installed
	$(BIN)/python docs/build.py $(OUT)/manual

# Programs and environments are installed first, by one apt and one pip at a time, which build the kernels anew; then two processes of one thread each keep two cores busy.
test: export OPENBLAS_NUM_THREADS = 1
test: lint
	tests/freecad/setup.sh
	tests/programs/setup.sh
	$(MAKE) .venv-core/installed .venv-build123d/installed .venv-cadquery/installed
	$(MAKE) --keep-going --jobs=2 test-freecad test-core test-kernels test-programs
	$(BIN)/python -m pytest -n 2 --ignore=tests/freecad --ignore=tests/benchmarks --ignore=tests/programs

lint: $(VENV)/test-installed
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy elastica_cad
	$(BIN)/lint-imports

# The core on the oldest libraries that a Debian FreeCAD brings: numpy 1.24, scipy 1.10, no highspy, no ezdxf. The test
# modules that say `pytestmark = pytest.mark.core` run there, without compiled kernels; the others are not even imported.
test-core: .venv-core/installed
	ELASTICA_PURE=1 PYTHONPATH=. .venv-core/bin/python -m pytest -o addopts="-q --import-mode=importlib --strict-markers" -m core \
		tests/house tests/unit tests/properties tests/validation

# Kernels: .venv has build123d and CadQuery together (OCP 7.9); here the newest of each, alone.
test-kernels: .venv-build123d/installed .venv-cadquery/installed
	ELASTICA_KERNELS=build123d PYTHONPATH=. .venv-build123d/bin/python -m pytest -o addopts="-q --import-mode=importlib" tests/cad
	ELASTICA_KERNELS=cadquery PYTHONPATH=. .venv-cadquery/bin/python -m pytest -o addopts="-q --import-mode=importlib" tests/cad

# FreeCAD 0.20 as Debian 12 has it; with RELEASE=trixie or RELEASE=sid (needs root) 1.0 or 1.1 in a folder of its own.
test-freecad: $(VENV)/test-installed
	tests/freecad/setup.sh
	$(if $(RELEASE),tests/freecad/release.sh $(RELEASE),$(BIN)/python -m pytest tests/freecad)

# FreeCAD with the workbench as it lies here and an example open (0.20 takes options after the file only).
freecad:
	tests/freecad/setup.sh
	freecad freecad_workbench/example.py -M "$(CURDIR)"

# Our files in Inkscape, LibreCAD, OpenSCAD, Poppler and CalculiX, as Debian has them.
test-programs: $(VENV)/test-installed
	tests/programs/setup.sh
	$(BIN)/python -m pytest tests/programs

# Ratios of times in one run, on a machine that does nothing else; docs/explanation/speed.md is written anew.
benchmark: $(VENV)/benchmark-installed
	@mkdir -p $(OUT)
	$(BIN)/python -m pytest tests/benchmarks --benchmark-enable --benchmark-only -o addopts="-q --import-mode=importlib" \
		--benchmark-json=$(OUT)/benchmark.json
	$(BIN)/python docs/speed_tables.py $(OUT)/benchmark.json

# Strips bent by finite elements, then what three kernels do to the bodies of thirty curves in five styles: hours;
# CAMPAIGN="--styles plain" asks less of the kernels. Then files and commands that are broken on purpose, verdicts checked
# otherwise, kills and full disks, mutants and a soak, each within MINUTES; docs/trust.md is written anew at the end.
CAMPAIGN ?=
MINUTES ?= 60
TRUST = PYTHONPATH=. $(BIN)/python -m tests.campaign.trust
campaign: .venv-campaign/installed
	tests/programs/setup.sh
	PYTHONPATH=. .venv-campaign/bin/python -m tests.campaign.finite_elements --out $(OUT)/campaign
	PYTHONPATH=. .venv-campaign/bin/python tests/campaign/typing_mistakes.py
	PYTHONPATH=. .venv-campaign/bin/python tests/campaign/solids.py --out $(OUT)/campaign $(CAMPAIGN)
	$(MAKE) campaign-trust

campaign-trust: $(VENV)/test-installed
	-$(TRUST).files --cases 100000 --minutes $(MINUTES) --out $(OUT)/campaign
	-$(TRUST).commands --runs 3000 --minutes $(MINUTES) --out $(OUT)/campaign
	-$(TRUST).kernels --cases 20000
	-$(TRUST).met_checks --solves 10000 --minutes $(MINUTES) --out $(OUT)/campaign
	-$(TRUST).written --strips 1000 --minutes $(MINUTES) --out $(OUT)/campaign
	-$(TRUST).designs --designs 2000 --minutes $(MINUTES) --out $(OUT)/campaign
	-$(TRUST).faults --out $(OUT)/campaign
	-$(TRUST).soak --minutes $(MINUTES) --out $(OUT)/campaign
	-$(TRUST).mutants --count 400 --minutes $(MINUTES) --out $(OUT)/campaign
	$(TRUST).ledger --claims --out $(OUT)/campaign

$(VENV)/created:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
		{ echo "elastica_cad needs Python 3.11 or newer; say which with make PYTHON=/path/to/python3.11"; exit 1; }
	@$(PYTHON) -m venv $(VENV) || \
		{ echo "Python cannot make virtual environments here: install its venv module (Debian: apt install python3-venv)"; exit 1; }
	@touch $@

$(VENV)/demo-installed: $(VENV)/created pyproject.toml $(KERNELS)
	$(call install,$(VENV),--editable ".[plot$(COMMA)mesh]")

$(VENV)/docs-installed: $(VENV)/created pyproject.toml $(KERNELS)
	$(call install,$(VENV),--editable ".[plot$(COMMA)docs]")

$(VENV)/test-installed: $(VENV)/created pyproject.toml $(KERNELS)
	$(call install,$(VENV),--editable ".[plot$(COMMA)dev]" "build123d==0.12.0" "cadquery==2.8.0")
	@touch $(VENV)/demo-installed

$(VENV)/benchmark-installed: $(VENV)/test-installed
	$(call install,$(VENV),--editable ".[benchmark]")

ALONE := $(PYTHON) -m venv
.venv-core/installed: $(VENV)/created
	@$(ALONE) .venv-core
	$(call install,.venv-core,"numpy==1.24.*" "scipy==1.10.*" "pytest>=8" "hypothesis>=6.100")

.venv-campaign/installed: $(VENV)/created
	@$(ALONE) .venv-campaign
	$(call install,.venv-campaign,--editable . "build123d==0.12.0" "cadquery==2.8.0" gmsh pyright)

.venv-build123d/installed .venv-cadquery/installed: .venv-%/installed: $(VENV)/created pyproject.toml
	@$(ALONE) .venv-$*
	$(call install,.venv-$*,--editable ".[plot$(COMMA)$*]" "pytest>=8" "hypothesis>=6.100")

clean:
	rm -rf $(VENV) .venv-core .venv-build123d .venv-cadquery .venv-campaign $(OUT)
