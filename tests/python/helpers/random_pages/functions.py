"""Functions of one number, by which a shading finds its colours."""

from .matrices import numbers


def exponential_function(draft, ranges):
    """Of type 2."""
    exponent = draft.any({1: 2, 2: 1, 0.5: 1})
    low, high = any_color(draft, ranges), any_color(draft, ranges)
    return (
        f"<< /FunctionType 2 /Domain [0 1] /N {exponent} /C0 [{numbers(*low)}] /C1 [{numbers(*high)}] >>"
    )


def stitched_function(draft, ranges):
    """Of type 3: others one after the other."""
    middle, colors = draft.between(0.3, 0.7), [any_color(draft, ranges) for _ in range(3)]
    parts = [
        f"<< /FunctionType 2 /Domain [0 1] /N 1 /C0 [{numbers(*low)}] /C1 [{numbers(*high)}] >>"
        for low, high in zip(colors, colors[1:])
    ]
    encode = "0 1 1 0" if draft.chance.random() < 0.2 else "0 1 0 1"
    return (
        f"<< /FunctionType 3 /Domain [0 1] /Bounds [{middle:.4f}] /Encode [{encode}]"
        f" /Functions [{' '.join(parts)}] >>"
    )


def sampled_function(draft, ranges):
    """Of type 0."""
    size, bits = draft.any({2: 1, 4: 1, 9: 1}), draft.any({8: 3, 16: 1})
    values = [draft.chance.randrange(1 << bits) for _ in range(size * len(ranges))]
    data = b"".join(value.to_bytes(bits // 8, "big") for value in values)
    of = " ".join(numbers(*each) for each in ranges)
    values = f"/FunctionType 0 /Domain [0 1] /Range [{of}] /Size [{size}] /BitsPerSample {bits}"
    return draft.objects.stream(draft, values, data)


FUNCTIONS = {exponential_function: 2, stitched_function: 2, sampled_function: 1}


def any_color(draft, ranges):
    return [draft.between(*each) for each in ranges]
