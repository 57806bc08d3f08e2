"""`python -m uniteam`: the command `uniteam`, also where its script is not on the path."""

from uniteam.cli.main import main

if __name__ == "__main__":
    main()
