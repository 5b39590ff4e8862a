#!/usr/bin/env python3
"""Builds and runs ours and the other libraries on the same meshes in the same run, and prints how they compare.

    python3 bench/compare.py --build /tmp/udcp-bench

Each measurement is a process of its own (bench/peers/), the programs of a group take turns, and the table holds medians. What
the columns mean is said in bench/README.md."""
import argparse
import dataclasses
import datetime
import json
import os
import platform
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.dont_write_bytecode = True  # nothing is written beside the sources
import comparisons
import meshes

ROOT = Path(__file__).resolve().parent.parent
PACKAGES = {"opensubdiv": "libosd-dev", "cgal": "libcgal-dev", "openmesh": "libopenmesh-dev"}
NAMES = {"ours": "ours", "opensubdiv": "OpenSubdiv", "cgal": "CGAL", "openmesh": "OpenMesh", "floors": "floor"}


def build(folder):
    """Configures and builds the programs in `folder`; returns where they are."""
    if folder == ROOT or folder in ROOT.parents:
        sys.exit(f"compare.py: --build {folder} holds the sources; name a folder of its own")
    configure = ["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DUDCP_BENCH=ON", "-DUDCP_TESTS=OFF"]
    make = ["cmake", "--build", folder, "--target", "bench_peers", "--parallel", str(os.cpu_count() or 1)]
    for command in (configure, make):
        try:
            done = subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        except FileNotFoundError:
            sys.exit("compare.py: cmake is not installed")
        if done.returncode:
            sys.exit(done.stdout[-4000:] + f"\ncompare.py: '{' '.join(map(str, command))}' fails; its last lines are above")
    return folder / "bench"


class Runner:
    """Runs single measurements and keeps their results: spec -> list of what the processes printed."""

    def __init__(self, programs, files):
        self.programs, self.files, self.results, self.missing, self.asked = programs, files, {}, set(), {}
        for program in PACKAGES:
            if not (programs / f"refine_{program}").exists():
                self.missing.add(program)

    def command(self, spec, **changes):
        spec = dataclasses.replace(spec, **changes)
        line = [self.programs / f"refine_{spec.program}"]
        if spec.program == "floors":
            line += ["--way", spec.way, "--bytes", comparisons.output_bytes(spec, self.files[spec.mesh][1])]
        else:
            line += [self.files[spec.mesh][0], "--scheme", spec.scheme, "--way", spec.way, "--real", spec.real]
            line += ["--rounds", spec.rounds, "--threads", spec.threads]
        return [str(word) for word in line]

    def call(self, line):
        try:
            done = subprocess.run(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=600)
            return json.loads(done.stdout)
        except subprocess.TimeoutExpired:
            return {"error": "more than ten minutes"}
        except (OSError, ValueError):
            return {"error": f"{Path(line[0]).name} does not run: {(done.stderr if 'done' in locals() else '')[-200:].strip()}"}

    def measure(self, spec):
        self.asked[spec] = True
        if spec.program in self.missing:
            return
        bytes_out = comparisons.output_bytes(spec, self.files[spec.mesh][1])
        if bytes_out > 50e6:  # the memory that the measurement will get: see "The memory of a virtual machine" in README.md
            self.call([str(self.programs / "refine_floors"), "--way", "fresh_huge", "--bytes", "2000000000", "--seconds", "0"])
        result = self.call(self.command(spec))
        if spec.way == "triad" and "error" not in result:  # measured on at least 192 MiB, and scaled
            scale = bytes_out / result["output_bytes"]
            result.update({key: result[key] * scale for key in ("seconds", "wall")})
        self.results.setdefault(spec, []).append(result)

    def problem(self, spec):
        """Why there is no number for this measurement, or None."""
        if spec.program in self.missing:
            return f"not installed ({PACKAGES[spec.program]})"
        results = self.results.get(spec, [])
        return next((r["error"] for r in results if "error" in r), None if results else "not run")

    def values(self, spec, key):
        return [r[key] for r in self.results[spec]]

    def agreement(self, one, other, folder):
        """The distance between two results over the size of the mesh: a text. At fewer rounds where they are large."""
        problem = self.problem(one) or self.problem(other)
        if problem or "floors" in (one.program, other.program):
            return ""
        faces = self.files[one.mesh][1][2]
        rounds = max(r for r in range(one.rounds + 1) if r <= 1 or faces * 4**r < 700_000)
        files = []
        for number, spec in enumerate((one, other)):
            files.append(str(Path(folder) / f"{number}.bin"))
            said = self.call(self.command(spec, rounds=rounds) + ["--save", files[-1], "--seconds", "0"])
            if "error" in said:
                return said["error"]
        said = self.call([str(self.programs / "same_surface"), *files])
        return said.get("error") or f"{max(said['points'], said['faces']):.0e}"


def spread(values, show=lambda x: f"{x:.3g}"):
    return f"{show(min(values))} .. {show(max(values))}"


def compared_rows(runner):
    """The table of what is demanded."""
    lines = ["| what | ours | other | ratio | spread | wanted | aim | results differ by |", "|---|---|---|---|---|---|---|---|"]
    with tempfile.TemporaryDirectory() as folder:
        for row in comparisons.ROWS:
            if row.ours not in runner.asked or row.other not in runner.asked:
                continue  # left out by --only
            problem = runner.problem(row.ours) or runner.problem(row.other)
            agreement = runner.agreement(row.ours, row.other, folder) if row.compare else ""
            if problem:
                lines.append(f"| {row.text} | | | {problem} | | {row.wanted_text()} | {row.aim_text()} | |")
                continue
            lines.append(ratio_line(runner, row, agreement))
    return lines


def ratio_line(runner, row, agreement):
    a, b = runner.values(row.ours, row.key), runner.values(row.other, row.other_key)
    median_a, median_b = statistics.median(a), statistics.median(b)
    ratios = [y / x if row.faster else x / y for x, y in zip(a, b)]
    ratio = median_b / median_a if row.faster else median_a / median_b
    mark = "" if row.meets(ratio) else " (missed)"
    return (f"| {row.text} | {amount(median_a, row.key)} | {amount(median_b, row.other_key)} | **{ratio:.3g}**{mark} | "
            f"{spread(ratios)} | {row.wanted_text()} | {row.aim_text()} | {agreement} |")


def amount(value, key):
    if key.endswith("bytes"):
        return f"{value / 1e6:.0f} MB"
    return seconds_text(value)


def seconds_text(value):
    return f"{value:.3g} s" if value >= 0.1 else f"{value * 1e3:.3g} ms"


def measurement_rows(runner):
    """Every measurement, for whoever wants other ratios."""
    lines = ["| program | mesh, rounds | scheme | way | CPU | spread | wall | peak | peak / output | vertices | faces |",
             "|---|---|---|---|---|---|---|---|---|---|---|"]
    for spec in runner.asked:
        threads = f", {spec.threads} threads" if spec.threads > 1 else ""
        way = spec.way if spec.program == "floors" else f"{spec.way} {spec.real}{threads}"
        start = f"| {NAMES[spec.program]} | {spec.mesh}, {spec.rounds} | {spec.scheme} | {way} |"
        if runner.problem(spec):
            lines.append(f"{start} {runner.problem(spec)} | | | | | | |")
            continue
        seconds, peak = runner.values(spec, "seconds"), statistics.median(runner.values(spec, "peak_bytes"))
        said = runner.results[spec][0]
        factor = f"{peak / said['output_bytes']:.2f}" if spec.way in ("cold", "general") else ""
        lines.append(f"{start} {amount(statistics.median(seconds), 'seconds')} | {spread(seconds, seconds_text)} | "
                     f"{amount(statistics.median(runner.values(spec, 'wall')), 'wall')} | {amount(peak, 'bytes')} | {factor} | "
                     f"{said['vertices'] or ''} | {said['faces'] or ''} |")
    return lines


def command_lines(udcp, runner, rounds):
    """The whole command: spot refined six times to a file, from the start of the process to its end."""
    seconds, walls, size = [], [], 0
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "spot.glb"
        line = [udcp, "apply", "catmull_clark", runner.files["spot"][0], "-n", "6", "-o", target]
        for _ in range(rounds):
            start = time.perf_counter()
            process = subprocess.Popen(list(map(str, line)), stdout=subprocess.DEVNULL)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            if process.returncode or not target.exists():
                return [f"`udcp apply` wrote no file, and ended with status {process.returncode}."]
            walls.append(time.perf_counter() - start)
            seconds.append(usage.ru_utime + usage.ru_stime)
        size = target.stat().st_size
    inside = ""
    if not runner.problem(comparisons.SPOT):
        inside = f", of which refining is {seconds_text(statistics.median(runner.values(comparisons.SPOT, 'seconds')))}"
    return [f"`udcp apply catmull_clark spot.obj -n 6 -o spot.glb`: {seconds_text(statistics.median(seconds))} CPU "
            f"({spread(seconds, seconds_text)}), {seconds_text(statistics.median(walls))} wall, {size / 1e6:.0f} MB{inside}."]


def machine(rounds, load):
    """Where and with what: a list of lines."""
    models = re.findall(r"model name\s*:\s*(.*)", Path("/proc/cpuinfo").read_text()) or ["unknown processor"]
    memory = re.search(r"MemTotal:\s+(\d+)", Path("/proc/meminfo").read_text())
    compiler = first_line(["c++", "--version"])
    query = ["dpkg-query", "-W", "-f", "${Version}"]
    versions = [f"{package} {version}" for package in PACKAGES.values() if (version := first_line([*query, package]))]
    commit = first_line(["git", "-C", str(ROOT), "describe", "--always", "--dirty"])
    lines = [f"{datetime.date.today()}, {models[0]}, {os.cpu_count()} cores, {int(memory[1]) / 2**20:.0f} GiB, "
             f"{platform.system()} {platform.release()}, {compiler}, {', '.join(versions) or 'no other library'}, commit {commit or '?'}.",
             f"{rounds} interleaved rounds, medians; load average at the start {load:.2f}."]
    if load > 0.5:
        lines.append("The machine had other work when this began: CPU times suffer a little, wall times are worth nothing.")
    return lines


def first_line(command):
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    except OSError:
        return ""
    return done.stdout.splitlines()[0].strip() if done.returncode == 0 and done.stdout else ""


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, help="folder to build in, outside the sources; made if it is not there")
    parser.add_argument("--programs", type=Path, help="folder with the programs, already built; instead of --build")
    parser.add_argument("--rounds", type=int, default=5, help="interleaved rounds (5)")
    parser.add_argument("--only", nargs="+", choices=[name for name, _ in comparisons.GROUPS], help="only these groups")
    parser.add_argument("--udcp", type=Path, help="the udcp command, if its time is wanted too")
    parser.add_argument("--output", type=Path, help="write the tables to this file as well")
    given = parser.parse_args()
    if (given.build is None) == (given.programs is None):
        parser.error("give either --build FOLDER or --programs FOLDER")
    if given.rounds < 1:
        parser.error("--rounds is at least 1")
    return given


def main():
    given = arguments()
    load = os.getloadavg()[0]
    programs = build(given.build.resolve()) if given.build else given.programs.resolve()
    if not (programs / "refine_ours").exists():
        sys.exit(f"compare.py: there is no refine_ours in {programs}")
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(programs, meshes.make_all(ROOT, folder))
        for program in sorted(runner.missing):
            print(f"compare.py: {NAMES[program]} is not installed; apt-get install {PACKAGES[program]}", file=sys.stderr)
        for name, group in comparisons.GROUPS:
            if given.only and name not in given.only:
                continue
            print(f"compare.py: {name}", file=sys.stderr, flush=True)
            for _ in range(given.rounds):
                for spec in group:
                    runner.measure(spec)
        command = command_lines(given.udcp.resolve(), runner, given.rounds) if given.udcp else []
        text = "\n".join([*machine(given.rounds, load), "", *compared_rows(runner), "", *command, "", *measurement_rows(runner)])
    print(text)
    if given.output:
        given.output.write_text(text + "\n")


if __name__ == "__main__":
    main()
