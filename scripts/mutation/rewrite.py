"""Writes the mutants into the text of a file."""


def with_mutants(text, sites):
    """The bytes of a file with the edits of all (first number, site). Lines keep their numbers."""
    before, after, removed = [], [], {}
    for order, (number, site) in enumerate(sites):
        for edit in site.edits:
            prefix = edit.prefix.replace("NUMBER", str(number)).encode()
            before.append((edit.start, -edit.end, edit.depth, order, prefix))
            after.append((edit.end, -edit.start, -edit.depth, -order, edit.suffix.encode()))
            if edit.operator:
                offset, length = edit.operator
                removed[offset] = length
    # At one place, the texts after the inner expressions come first, and those before the outer expressions.
    changes = [(place, 0, i, 0, new) for i, (place, *_, new) in enumerate(sorted(after))]
    changes += [(place, 1, i, 0, new) for i, (place, *_, new) in enumerate(sorted(before))]
    changes += [(offset, 2, 0, length, b",") for offset, length in removed.items()]
    pieces, last = [], 0
    for place, _, _, length, new in sorted(changes):
        pieces += [text[last:place], new]
        last = place + length
    return b"".join([*pieces, text[last:]])
