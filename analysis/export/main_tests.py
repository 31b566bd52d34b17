#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Obscura authors
# SPDX-License-Identifier: MIT
"""Repeats the main tests from the exported tables: votes and exact binomial test of each condition
with Holm's correction, then the tests of the hypotheses over participants with Holm's correction
over the primary ones. Standard library only. Prints two tables with tabs; any row can be computed
by hand from trials and tests. Looks before the last one, where a study spends its level over
several, are not taken into account."""
import csv
import json
import math
import sys
from collections import Counter, defaultdict
from pathlib import Path

HERE = Path(__file__).resolve().parent
MOST_FLIPPED, MOST_SUMS = 1000, 2e7  # beyond: normal approximation, as in the program


def read(path):
    with open(path, encoding="utf-8", newline="") as file:
        if path.suffix == ".jsonl":
            rows = [json.loads(line) for line in file]
        else:
            rows = list(csv.DictReader(file, delimiter="\t" if path.suffix == ".tsv" else ","))
    missing = ("", "n/a", None)
    return [{k: "" if v in missing else str(v) for k, v in row.items()} for row in rows]


def table(name):
    """Of an export as CSV, TSV or JSON Lines, Psych-DS or BIDS, whichever lies here."""
    places = [HERE / (name + ending) for ending in (".csv", ".tsv", ".jsonl")]
    for path in places + [HERE.parent / "data" / f"description-{name}_data.csv"]:
        if path.exists():
            return read(path)
    answers = sorted(HERE.parent.glob("sub-*/beh/*_beh.tsv"))
    if not answers:
        sys.exit(f"{HERE}: there is no table {name}")
    return [dict(row, participant_id=path.parts[-3]) for path in answers for row in read(path)]


def binomial_p(b, n):
    """Two-sided, against one half."""
    if n == 0:
        return math.nan
    tail = math.fsum(math.exp(math.lgamma(n + 1) - math.lgamma(k + 1) - math.lgamma(n - k + 1)
                              - n * math.log(2)) for k in range(min(b, n - b) + 1))
    return min(1.0, 2 * tail)


def holm(p_values):
    """A test that could not be computed counts as 1."""
    order = sorted(range(len(p_values)), key=lambda i: 1 if math.isnan(p_values[i]) else p_values[i])
    adjusted, largest = [math.nan] * len(p_values), 0.0
    for rank, i in enumerate(order):
        if not math.isnan(p_values[i]):
            largest = max(largest, min(1.0, (len(p_values) - rank) * p_values[i]))
            adjusted[i] = largest
    return adjusted


def sign_flip_p(differences):
    """Share of all flips of signs with a sum at least this far from 0."""
    sizes = [abs(d) for d in differences if d != 0]
    total, reached = sum(sizes), abs(sum(differences))
    if not sizes or reached == 0:
        return 1.0
    if set(sizes) == {1}:
        return binomial_p((total + reached) // 2, total)
    if len(sizes) > MOST_FLIPPED or len(sizes) * total > MOST_SUMS:
        return math.erfc(math.sqrt(reached ** 2 / sum(s * s for s in sizes) / 2))
    chance = {0: 1.0}
    for size in sizes:
        after = defaultdict(float)
        for value, p in chance.items():
            after[value - size] += p / 2
            after[value + size] += p / 2
        chance = after
    return min(1.0, 2 * math.fsum(p for value, p in chance.items() if value >= reached))


def cochran_p(rows):
    """Chi-square of Q with one degree of freedom less than conditions, by its finite sums."""
    k = len(rows[0])
    columns, each = [sum(c) for c in zip(*rows)], [sum(r) for r in rows]
    below = k * sum(each) - sum(r * r for r in each)
    if below == 0:
        return 1.0
    x, df = (k - 1) * (k * sum(c * c for c in columns) - sum(each) ** 2) / below, k - 1
    term, p = (math.exp(-x / 2), 0.0) if df % 2 == 0 else (
        math.sqrt(2 * x / math.pi) * math.exp(-x / 2), math.erfc(math.sqrt(x / 2)))
    for i in range(2 if df % 2 == 0 else 3, df + 1, 2):
        p += term
        term *= x / i
    return p


def hypothesis(tests, votes):
    """Participants counted, statistic and p of one test; tests are its rows."""
    if tests[0]["question"] == "none":
        return 0, "", math.nan
    conditions = {row["condition"]: int(row["weight"] or 1) for row in tests}
    answers = defaultdict(list)
    for row in votes:
        if row["condition"] in conditions:
            answers[row["participant_id"]].append((row["condition"], row["chose_B"] == "1"))
    if tests[0]["question"] == "preference":
        d = [sum(conditions[c] * (1 if b else -1) for c, b in own) for own in answers.values()]
        return len(d), sum(d), sign_flip_p(d) if d else math.nan
    if any(max(Counter(c for c, _ in own).values()) > 1 for own in answers.values()):
        return 0, "", math.nan  # somebody answered a condition twice
    complete = [dict(own) for own in answers.values() if len(own) == len(conditions)]
    if not complete:
        return 0, "", math.nan
    if tests[0]["question"] == "levels":
        return len(complete), "", cochran_p([[own[c] for c in conditions] for own in complete])
    d = [sum(w * (1 if own[c] else -1) for c, w in conditions.items()) for own in complete]
    d = [value // math.gcd(*d, 2) if any(d) else 0 for value in d]
    return len(d), sum(d), sign_flip_p(d)


def shown(value):
    return "" if isinstance(value, float) and math.isnan(value) else (
        f"{value:.12g}" if isinstance(value, float) else str(value))


def main():
    groups = defaultdict(list)
    for row in table("trials"):
        if row["is_vote"] == "1" and row["excluded"] == "0":
            groups[row["study"], row["kind"]].append(row)
    conditions, hypotheses = [], []
    tests = table("tests") if groups else []
    for (study, kind), votes in groups.items():
        names = list(dict.fromkeys(row["condition"] for row in votes))
        count = Counter((row["condition"], row["chose_B"]) for row in votes)
        results = [(name, count[name, "0"], count[name, "1"]) for name in sorted(names)]
        p_values = [binomial_p(b, a + b) for _, a, b in results]
        for (name, a, b), p, corrected in zip(results, p_values, holm(p_values)):
            conditions.append((study, kind, name, a, b, p, corrected))
        of_study = [row for row in tests if (row["study"], row["kind"]) == (study, kind)]
        found = []
        for name in dict.fromkeys(row["test"] for row in of_study):
            own = [row for row in of_study if row["test"] == name]
            found.append((name, own[0]["role"], own[0]["question"], *hypothesis(own, votes)))
        primary = [result for result in found if result[1] == "primary"]
        corrected = dict(zip(primary, holm([result[-1] for result in primary])))
        hypotheses += [(study, kind, *r, corrected.get(r, math.nan)) for r in found]
    for header, rows in ((("study", "kind", "condition", "A", "B", "p_exact", "p_holm"), conditions),
                         (("study", "kind", "test", "role", "question", "participants", "sum",
                           "p", "p_holm"), hypotheses)):
        print(*header, sep="\t")
        for row in rows:
            print(*map(shown, row), sep="\t")
        print()


if __name__ == "__main__":
    main()
