#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Do the tests bite? Breaks the code in small ways, one at a time, and expects the tests to fail for each.

Usage: scripts/check_mutants.py [-n] [NAME...]
NAME: of a mutant, or of a group of them, which is a file of test/mutants/ without .json; without one, all.
-n: only check that every text that a mutant replaces is there.

Works on a copy of the tree in build/mutants. Fails if a mutant survived or did not compile, if the tests do not pass on the
unbroken code, or if the text that a mutant replaces is not found exactly once in its file.
"""
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LISTS = ROOT / "test" / "mutants"
TREE = ROOT / "build" / "mutants" / "tree"
BUILD = ROOT / "build" / "mutants" / "build"
PROGRAMS = {"core": ["core"], "pipeline": ["core", "classes"], "classes": ["classes"], "apps": ["apps"],
            "evaluation": ["evaluation"]}
# Quick to build: the code that is tested is the same.
OPTIONS = ["-D", "CMAKE_BUILD_TYPE=None", "-D", "CMAKE_CXX_FLAGS=-O1", "-D", "BUILD_SHARED_LIBS=OFF",
           "-D", "PCL_ATTENTION_WARNINGS_AS_ERRORS=OFF", "-D", "PCL_ATTENTION_BUILD_PYTHON=OFF",
           "-D", "PCL_ATTENTION_BUILD_BENCHMARKS=OFF", "-D", "PCL_ATTENTION_BUILD_EXAMPLES=OFF"]


def read_mutants(names):
    """The mutants of the given names and groups, each with its group; ends with a message if a list is out of date."""
    mutants, wrong = [], []
    for path in sorted(LISTS.glob("*.json")):
        for mutant in json.loads(path.read_text()):
            file = ROOT / mutant["file"]
            found = file.read_text().count(mutant["old"]) if file.is_file() else 0
            if found != 1:
                wrong.append(f"{path.name}: {mutant['name']}: its text is found {found} times in {mutant['file']}")
            mutants.append({**mutant, "group": path.stem})
    known = {m["name"] for m in mutants} | {m["group"] for m in mutants}
    wrong += [f"no mutant or group '{name}'" for name in names if name not in known]
    if len({m["name"] for m in mutants}) != len(mutants):
        wrong.append("two mutants have the same name")
    if wrong:
        sys.exit("\n".join(f"check_mutants.py: {line}" for line in wrong))
    return [m for m in mutants if not names or m["name"] in names or m["group"] in names]


def copy_tree():
    """Bring the copy up to date; what has not changed keeps its time, and is not built again."""
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout.split("\0")
    names = {name for name in listed if name and (ROOT / name).is_file()}
    for name in names:
        source, target = ROOT / name, TREE / name
        if not target.is_file() or target.read_bytes() != source.read_bytes():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)
    for path in TREE.rglob("*"):
        if path.is_file() and str(path.relative_to(TREE)) not in names:
            path.unlink()


def run(command, **arguments):
    return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", **arguments)


def build(programs):
    """Messages of a build that failed, else nothing."""
    result = run(["cmake", "--build", str(BUILD), "--parallel", "2", "--target",
                  *[f"pcl_attention_test_{program}" for program in programs]])
    return result.stdout if result.returncode else ""


def suspected_tests(program, file):
    """Filter of the tests whose file has a name that begins like that of the code; empty if there is none."""
    word = Path(file).stem.split("_")[0]
    suites = set()
    for path in (ROOT / "test" / program).glob(f"test_{word}*.cpp"):
        suites.update(re.findall(r"^(?:TYPED_)?TEST(?:_F|_P)? \((\w+),", path.read_text(), re.MULTILINE))
    return ":".join(f"{suite}.*:*/{suite}.*:{suite}/*" for suite in sorted(suites))


def first_failure(program, limit, tests="*"):
    """The first test that fails, crashes or takes too long, and how; None if all pass. The limit is of seconds of processor
    time, so that a busy machine is no mutant caught, and ten times as much for one that only waits."""
    command = [str(BUILD / "bin" / f"pcl_attention_test_{program}"), "--gtest_fail_fast", f"--gtest_filter={tests}"]
    process = subprocess.Popen(command, cwd=BUILD, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True,
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5)))
    how = "fails"
    try:
        output = process.communicate(timeout=10 * limit)[0]
        if process.returncode == 0:
            return None
        if process.returncode < 0:
            how = f"ends by {signal.Signals(-process.returncode).name}"
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        output = process.communicate()[0]
        how = "hangs"
    names = re.findall(r"^\[  FAILED  \] ([\w/.]+)", output, re.MULTILINE) if how == "fails" else []
    names = names[:1] or re.findall(r"^\[ RUN      \] ([\w/.]+)", output, re.MULTILINE)[-1:]
    return f"{program}.{names[0] if names else '?'} {how}"


def check(mutant, limits):
    """What became of a mutant: 'caught', 'survived' or 'does not compile', and by what."""
    path = TREE / mutant["file"]
    original = path.read_text()
    try:
        path.write_text(original.replace(mutant["old"], mutant["new"]))
        programs = PROGRAMS[mutant["group"]]
        messages = build(programs)
        if messages:
            return "does not compile", messages
        # All tests, those first that are quick to tell.
        for tests in (suspected_tests(programs[0], mutant["file"]), "*"):
            for program in programs:
                failure = tests and first_failure(program, limits[program], tests)
                if failure:
                    return "caught", failure
        return "survived", f"{mutant['file']}: {mutant['old']} -> {mutant['new']} ({mutant['why']})"
    finally:
        path.write_text(original)


def main():
    names = sys.argv[1:]
    if names and names[0] in ("-h", "--help"):
        print(__doc__)
        return 0
    only_texts = names[:1] == ["-n"]
    mutants = read_mutants(names[only_texts:])
    if only_texts:
        print(f"{len(mutants)} mutants fit the code")
        return 0
    TREE.mkdir(parents=True, exist_ok=True)
    copy_tree()
    if not (BUILD / "build.ninja").exists():
        configured = run(["cmake", "-S", str(TREE), "-B", str(BUILD), "-G", "Ninja", *OPTIONS])
        if configured.returncode:
            sys.exit(configured.stdout)

    programs = sorted({program for mutant in mutants for program in PROGRAMS[mutant["group"]]})
    messages = build(programs)
    if messages:
        sys.exit(f"{messages}\ncheck_mutants.py: the unbroken code does not build")
    limits = {}
    for program in programs:
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        failure = first_failure(program, 1200)
        if failure:
            sys.exit(f"check_mutants.py: on the unbroken code {failure}")
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        limits[program] = int(60 + 4 * seconds)
        print(f"unbroken: {program} passes, {seconds:.0f} s", flush=True)

    counts = {}
    for number, mutant in enumerate(mutants, 1):
        started = time.monotonic()
        outcome, what = check(mutant, limits)
        counts[outcome] = counts.get(outcome, 0) + 1
        seconds = time.monotonic() - started
        print(f"[{number}/{len(mutants)}] {mutant['name']}: {outcome}: {what}, {seconds:.0f} s", flush=True)
    print(f"{counts.get('caught', 0)} of {len(mutants)} mutants caught")
    return 0 if counts.get("caught", 0) == len(mutants) else 1


if __name__ == "__main__":
    sys.exit(main())
