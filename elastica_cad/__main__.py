"""`python -m elastica_cad`: the same command line as `elastica`."""

from elastica_cad.cli import main

if __name__ == "__main__":
    main()
