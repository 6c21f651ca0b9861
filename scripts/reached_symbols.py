#!/usr/bin/env python3
"""Functions that some functions of a program reach by calls and jumps, from its disassembly.

reached_symbols.py PROGRAM ROOT...   Prints one line each: "inside NAME", "outside NAME" (by the
linkage table) or "indirect NAME" for a function with a call through a pointer.
"""
import re
import subprocess
import sys

HEAD = re.compile(r"^[0-9a-f]+ <(.+)>:$")
TARGET = re.compile(r"\b(?:call|jmp|j[a-z]+)\s+[0-9a-f]+ <([^>+]+)(?:\+0x[0-9a-f]+)?>")
INDIRECT = re.compile(r"\bcall\s+\*")


def main(program, roots):
    calls, indirect, name = {}, set(), None
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", program], check=True,
                             capture_output=True, text=True).stdout
    for line in listing.splitlines():
        if head := HEAD.match(line):
            name = head.group(1)
            calls.setdefault(name, set())
        elif name is not None:
            # Entries of the linkage table jump to its head, which has no name of its own.
            if (target := TARGET.search(line)) and target.group(1) != "_init":
                calls[name].add(target.group(1))
            if INDIRECT.search(line):
                indirect.add(name)
    missing = [root for root in roots if root not in calls]
    if missing:
        sys.exit("not in the program: " + " ".join(missing))
    reached, waiting = set(roots), list(roots)
    while waiting:
        for target in calls.get(waiting.pop(), ()):
            if target not in reached:
                reached.add(target)
                waiting.append(target)
    for symbol in sorted(reached):
        if symbol.endswith("@plt"):
            print("outside", symbol[:-4])
        else:
            print("inside", symbol)
            if symbol in indirect:
                print("indirect", symbol)


main(sys.argv[1], sys.argv[2:])
