"""Checks that the builds with and without `pdf` compile the crates they share with the same features.

usage: shared_features.py

scripts/paper_joint.sh makes one build after the other: a crate whose features differ is compiled twice, and so is every crate
that depends on it. Exit 1 with the list of such crates; the mend is a line in the dependencies of Cargo.toml.
"""

import subprocess
import sys

# these two have the feature themselves
OWN = {"bracket", "bracket-report"}


def features(*options: str) -> dict[str, set[str]]:
    """The sets of features with which each crate is compiled, by name and version."""
    command = ["cargo", "tree", "--locked", "--edges", "normal,build", "--prefix", "none", "--package", "bracket"]
    tree = subprocess.run([*command, "--format", "{p}|{f}", *options], check=True, capture_output=True, text=True)
    found: dict[str, set[str]] = {}
    for line in tree.stdout.splitlines():
        package, _, names = line.removesuffix(" (*)").partition("|")
        name, version = package.split()[:2]
        if name not in OWN:
            found.setdefault(f"{name} {version}", set()).add(names)
    return found


def main() -> int:
    small, whole = features("--no-default-features", "--features", "faer-sparse"), features()
    different = [name for name in small if small[name] != whole.get(name)]
    for name in different:
        print(f"shared_features: {name}: {sorted(small[name])} without pdf, {sorted(whole[name])} with it", file=sys.stderr)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
