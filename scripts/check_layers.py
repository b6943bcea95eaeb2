#!/usr/bin/env python3
"""Fails when a source file includes a folder that scripts/layers.txt does not allow."""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent
tops = ("sim", "autoref", "teams", "experiments")

allowed = {}
for line in (root / "scripts/layers.txt").read_text().splitlines():
    if line.strip() and not line.startswith("#"):
        folder, _, uses = line.partition(":")
        allowed[folder.strip()] = set(uses.split())


def component(folder):
    """The folder of layers.txt a source folder belongs to: itself, its parent's wildcard, or its parent's component."""
    while folder:
        if folder in allowed:
            return folder
        parent = folder.rpartition("/")[0]
        if parent + "/*" in allowed:
            return parent + "/*"
        folder = parent
    return None


problems = []
seen = 0
for path in sorted(p for top in tops for p in (root / top).rglob("*")):
    if path.suffix not in {".h", ".cpp"}:
        continue
    seen += 1
    folder = path.parent.relative_to(root).as_posix()
    home = component(folder)
    if home is None:
        problems.append(f"{path.relative_to(root)}: folder {folder} is not in layers.txt")
        continue
    for number, text in enumerate(path.read_text().splitlines(), 1):
        match = re.match(r'\s*#\s*include\s+"([^"]+)/[^"/]+"', text)
        if not match or match[1] == folder:
            continue
        used = component(match[1])
        if used is None:
            problems.append(f"{path.relative_to(root)}:{number}: {match[1]} is not a folder of layers.txt")
        elif used not in allowed[home] and (used != home or home.endswith("/*")):
            problems.append(f"{path.relative_to(root)}:{number}: {folder} may not include {match[1]}")

if seen == 0:
    problems.append("no source file found")
print("\n".join(problems) or f"layers: ok, {seen} files")
sys.exit(bool(problems))
