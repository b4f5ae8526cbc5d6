# Two commands do all the set-up: `make demo` and `make test`. Both can be run again, and work offline once installed.
SHELL := /bin/bash
PYTHON ?= $(shell command -v python3.11 || command -v python3)
VENV := .venv
BIN := $(VENV)/bin
OUT ?= out
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check --no-input

.PHONY: demo test lint test-core test-freecad freecad benchmark clean

demo: $(VENV)/demo-installed
	$(BIN)/elastica strip examples/arch/arch.dxf --sheet birch-plywood-0.8 --max-width 40 \
		--label ARCH --output $(OUT)/arch --force

test: $(VENV)/test-installed lint test-core
	$(BIN)/python -m pytest -n 2

lint: $(VENV)/test-installed
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy elastica_cad
	$(BIN)/lint-imports

# The core on the oldest libraries that a Debian FreeCAD brings: numpy 1.24, scipy 1.10, no highspy, no ezdxf.
test-core: .venv-core/installed
	PYTHONPATH=. .venv-core/bin/python -m pytest $(shell grep -rl "mark.core" tests --include="test_*.py") -o addopts="-q --import-mode=importlib"

benchmark: $(VENV)/test-installed
	$(BIN)/python -m pytest tests/benchmarks --benchmark-enable --benchmark-only -o addopts="-q --import-mode=importlib"

$(VENV)/created:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
		{ echo "elastica_cad needs Python 3.11 or newer; say which with make PYTHON=/path/to/python3.11"; exit 1; }
	@$(PYTHON) -m venv $(VENV) || \
		{ echo "Python cannot make virtual environments here: install its venv module (Debian: apt install python3-venv)"; exit 1; }
	@touch $@

$(VENV)/demo-installed: $(VENV)/created pyproject.toml
	$(PIP) --editable ".[plot]"
	@touch $@

$(VENV)/test-installed: $(VENV)/created pyproject.toml
	$(PIP) --editable ".[plot,dev]" "build123d==0.12.0" "cadquery==2.8.0"
	@touch $@ $(VENV)/demo-installed

.venv-core/installed: $(VENV)/created
	@$(PYTHON) -m venv .venv-core
	.venv-core/bin/python -m pip install --quiet --disable-pip-version-check --no-input \
		"numpy==1.24.*" "scipy==1.10.*" "pytest>=8" "hypothesis>=6.100"
	@touch $@

clean:
	rm -rf $(VENV) .venv-core $(OUT)
