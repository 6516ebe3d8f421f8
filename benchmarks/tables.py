"""Results as Markdown tables."""

COUNTED = ("patches", "left", "evaluations", "error", "megabytes")


def seconds_text(seconds):
    """Three digits with a unit: "1.23 ms"."""
    for unit, factor in (("s", 1), ("ms", 1e3), ("µs", 1e6)):
        if seconds * factor >= 0.9995 or unit == "µs":
            value = seconds * factor
            digits = max(0, 2 - len(f"{int(value)}") + 1)
            return f"{value:.{digits}f} {unit}"
    raise AssertionError


def table(header, rows):
    """Lines of a table, its columns as wide as they must be; the first is set to the left."""
    texts = [list(map(str, row)) for row in [header, *rows]]
    widths = [max(map(len, column)) for column in zip(*texts)]

    def line(cells):
        first, *others = zip(cells, widths)
        return "| " + " | ".join([first[0].ljust(first[1]), *(c.rjust(w) for c, w in others)]) + " |"

    rule = "|" + "|".join("-" * (w + 1) + (":" if i else "-") for i, w in enumerate(widths)) + "|"
    return [line(texts[0]), rule, *map(line, texts[1:])]


def _count(value):
    if value is None:
        return ""
    return f"{value:.0f}" if value >= 1 else f"{value:.5f}"


def lines_table(lines):
    """What was measured. Work of one thread is timed by the processor alone; of several by the clock
    on the wall, with the processor's time in all threads beside it."""
    rows = []
    for name, line in lines.items():
        if "seconds" in line:
            wall = seconds_text(line["seconds"]) if line["clock"] == "wall" else ""
            cpu = seconds_text(line.get("cpu_seconds", line["seconds"]))
            renderer = line.get("renderer", "")
            rows.append([name, renderer, wall, cpu, *(_count(line.get(key)) for key in COUNTED)])
    return table(["", "renderer", "clock", "processor", "patches", "left", "evaluations", "error", "MB"], rows)


def growth_table(growth):
    rows = []
    for family, found in growth.items():
        first, last = found["points"][0], found["points"][-1]
        ends = f"{first[0]} to {last[0]}"
        times = f"{seconds_text(first[1])} to {seconds_text(last[1])}"
        rows.append([family, ends, times, f"{found['exponent']:.2f}"])
    return table(["", "from", "time", "exponent"], rows)


def goals_table(judged):
    rows = []
    for goal, value in judged:
        work = goal.work + (" (bridged)" if getattr(goal, "bridged", None) else "")
        if value is None:
            rows.append([work, goal.goal_text(), "", "not measured"])
        else:
            verdict = "reached" if goal.reached(value) else "not reached"
            rows.append([work, goal.goal_text(), goal.text(value), verdict])
    return table(["goal", "", "here", ""], rows)


def report(lines, growth, judged):
    """The tables one after the other, and what was left out and why."""
    text = lines_table(lines)
    if growth:
        text += ["", *growth_table(growth)]
    text += ["", *goals_table(judged)]
    if any(getattr(goal, "bridged", None) and value is not None for goal, value in judged):
        text += [
            "",
            "Bridged: that program is not here. Its time elsewhere, relative to scikit-image's SSIM "
            "there, stands for it.",
        ]
    left_out = [f"- {name}: {line['left_out']}" for name, line in lines.items() if "left_out" in line]
    if left_out:
        text += ["", "Left out:", *left_out]
    return "\n".join(text) + "\n"


def comparison(rows, here, there):
    """Two revisions: `rows` are (name, seconds here or None, seconds there or None)."""
    compared, missing = [], []
    for name, ours, theirs in rows:
        if ours is None or theirs is None:
            missing.append(f"- {name}: not in {there if theirs is None else here}")
        else:
            ratio = f"{theirs / ours:.2f}x"
            compared.append([name, seconds_text(theirs), seconds_text(ours), ratio])
    text = table(["", there, here, "as fast"], compared)
    if missing:
        text += ["", "Left out:", *missing]
    return "\n".join(text) + "\n"
