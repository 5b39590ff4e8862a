#!/usr/bin/env python3
"""A second checker of certificates, independent of the program that writes them: Python's standard library, exact fractions.

usage: check_certificate.py FILE...
It runs the atoms U, D, C and P by its own definitions, derives the mask again and repeats every exact check.
Exit status: 0 all accepted, 1 one was rejected, 2 none was rejected but some are of a kind (or with numbers) unknown here.
"""
import json
import sys

sys.dont_write_bytecode = True  # leave no trace in the folder of the examples
import certificate_curves  # noqa: E402
import certificate_regularity  # noqa: E402
import certificate_surfaces  # noqa: E402
from certificate_algebra import CannotCheck, Rejected, entries, require  # noqa: E402


def all_of(data):
    entries(data, ["parts"], "the data")
    require(isinstance(data["parts"], list) and 2 <= len(data["parts"]) <= 1000, "parts must be a list of 2 to 1000")
    for part in data["parts"]:
        entries(part, ["kind", "data"], "a part")
        require(part["kind"] != "all-of", "parts are not all-of themselves")
    return "; ".join(statement_of(part["kind"], part["data"]) for part in data["parts"])


CHECKERS = {"all-of": all_of, **certificate_curves.CHECKERS, **certificate_surfaces.CHECKERS, **certificate_regularity.CHECKERS}


def statement_of(kind, data):
    require(isinstance(kind, str), "the kind must be a text")
    if kind not in CHECKERS:
        raise CannotCheck(f"certificates of the kind {kind!r} are not known here")
    return CHECKERS[kind](data)


def digest(certificate):
    opened = {name: value for name, value in certificate.items() if name != "digest"}
    value = 0xCBF29CE484222325
    for byte in json.dumps(opened, separators=(",", ":"), ensure_ascii=True).encode():
        value = (value ^ byte) * 0x100000001B3 % 2 ** 64
    return f"{value:016x}"


def unique(pairs):
    require(len({name for name, _ in pairs}) == len(pairs), "an entry is there twice")
    return dict(pairs)


def check(text):
    """The statement that the certificate proves."""
    try:
        certificate = json.loads(text, object_pairs_hook=unique)
    except (ValueError, RecursionError) as error:
        raise Rejected(f"not JSON: {error}") from error
    require(isinstance(certificate, dict) and list(certificate) == ["format", "version", "kind", "statement", "data", "digest"],
            "a certificate has the entries format, version, kind, statement, data, digest, in this order")
    require(certificate["format"] == "udcp-certificate" and type(certificate["version"]) is int and certificate["version"] == 1,
            "another format or version")
    require(certificate["digest"] == digest(certificate), "the digest does not fit: something in the certificate was changed")
    statement = statement_of(certificate["kind"], certificate["data"])
    require(certificate["statement"] == statement, f"the data prove another statement: {statement}")
    return statement


def main(files):
    worst = 0
    for name in files:
        try:
            with open(name, encoding="utf-8") as file:
                print(f"{name}: accepted: {check(file.read())}")
        except CannotCheck as problem:
            print(f"{name}: cannot check: {problem}")
            worst = worst or 2
        except (Rejected, OSError, UnicodeDecodeError) as problem:
            print(f"{name}: rejected: {problem}")
            worst = 1
    if not files:
        print(__doc__.strip(), file=sys.stderr)
    return worst if files else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
