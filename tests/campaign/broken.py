"""Mutations of the bytes and the words of a file."""

import re

TOKEN = re.compile(rb"[A-Za-z_][\w.]*|-?\d[\d.eE+-]*|\s+|.", re.S)
NUMBER = re.compile(rb"-?\d+(\.\d+)?([eE][-+]?\d+)?")

ODD_NUMBERS = [
    b"1e400", b"-1e400", b"nan", b".nan", b"inf", b".inf", b"-0", b"0", b"1e-320", b"-1", b"+5",
    b"1.7976931348623157e308", b"0x10", b"1_000", b"1,5", b"1e", b"9" * 400, b"1" + b"0" * 30,
    b"2147483648", b"4294967296", b"18446744073709551616",
]
ODD_TEXT = [
    b"", b"~", b"null", b"[]", b"{}", b"''", b'"', b"*a", b"&a ", b"!!binary x", b"|", b"? ", b"- ",
    "\u202e".encode(), "\u2028".encode(), "\u00a0".encode(), "\ufeff".encode(), b"\x00", b"\x07",
    b"\x1b[31m", "\U0001f529".encode(), b"\xff\xfe", b"\xc3\x28", b"\xed\xa0\x80", b"${HOME}",
    b"../../x", b"/dev/zero", b"a" * 5000, b"<script>", b"=1+1", b"\t", b"yes", b"2026-01-31",
]


def delete(r, data):
    at = r.randrange(len(data))
    return data[:at] + data[at + r.choice([1, 1, 2, 8, 64]) :]


def insert(r, data):
    at = r.randrange(len(data) + 1)
    return data[:at] + r.choice(ODD_TEXT + ODD_NUMBERS) + data[at:]


def flip(r, data):
    out = bytearray(data)
    for _ in range(r.choice([1, 1, 4])):
        out[r.randrange(len(out))] = r.randrange(256)
    return bytes(out)


def truncate(r, data):
    return data[: r.randrange(len(data))]


def tokens(data):
    return TOKEN.findall(data[:200_000]), data[200_000:]


def token_change(r, data):
    words, rest = tokens(data)
    if not words:
        return data
    at = r.randrange(len(words))
    choice = r.randrange(4)
    if choice == 0:
        del words[at]
    elif choice == 1:
        words.insert(at, words[at])
    elif choice == 2:
        other = r.randrange(len(words))
        words[at], words[other] = words[other], words[at]
    else:
        words[at] = r.choice(words)
    return b"".join(words) + rest


def number_change(r, data):
    found = list(NUMBER.finditer(data))
    if not found:
        return insert(r, data)
    m = r.choice(found)
    return data[: m.start()] + r.choice(ODD_NUMBERS) + data[m.end() :]


def word_change(r, data):
    words, rest = tokens(data)
    found = [i for i, w in enumerate(words) if w[:1].isalpha()]
    if not found:
        return insert(r, data)
    words[r.choice(found)] = r.choice(ODD_TEXT)
    return b"".join(words) + rest


def line_change(r, data):
    lines = data.split(b"\n")
    at, other = r.randrange(len(lines)), r.randrange(len(lines))
    choice = r.randrange(4)
    if choice == 0:
        del lines[at]
    elif choice == 1:
        lines.insert(other, lines[at])
    elif choice == 2:
        lines[at], lines[other] = lines[other], lines[at]
    else:
        lines[at] = r.choice([b"  ", b" ", b"\t"]) + lines[at]
    return b"\n".join(lines)


def deep(r, data):
    """Brackets within brackets in the place of a value."""
    depth = r.choice([50, 1000, 20_000, 100_000])
    pairs = [(b"[", b"]"), (b"{a: ", b"}"), (b"- ", b""), (b"(", b")"), (b"-", b"")]
    opening, closing = r.choice(pairs)
    nest = opening * depth + b"1" + closing * depth
    found = list(NUMBER.finditer(data))
    if not found or r.random() < 0.2:
        return nest
    m = r.choice(found)
    return data[: m.start()] + nest + data[m.end() :]


def long_list(r, data):
    found = list(NUMBER.finditer(data))
    if not found:
        return data * 50
    m = r.choice(found)
    many = b", ".join([m.group()] * r.choice([100, 10_000, 200_000]))
    return data[: m.start()] + r.choice([many, b"[" + many + b"]"]) + data[m.end() :]


def encoding(r, data):
    choice = r.randrange(6)
    if choice == 0:
        return data.replace(b"\n", b"\r\n")
    if choice == 1:
        return data.replace(b"\n", b"\r")
    if choice == 2:
        return b"\xef\xbb\xbf" + data
    if choice == 3:
        return b"\xff\xfe" + data
    text = data.decode("utf-8", "replace")
    return ("\ufeff" + text).encode("utf-16-le" if choice == 4 else "utf-16-be")


def empty(r, data):
    return r.choice([b"", b"\n", b" ", b"\0" * 100, b"---\n", b"#", b"[]", b"{}"])


CHANGES = [
    (delete, 3), (insert, 4), (flip, 3), (truncate, 2), (token_change, 6), (number_change, 6),
    (word_change, 4), (line_change, 3), (deep, 1), (long_list, 1), (encoding, 1), (empty, 0.3),
]


def changed(r, data):
    """One to three changes, mostly one. Returns their names and the new bytes."""
    names = []
    for _ in range(r.choice([1, 1, 1, 2, 3])):
        change = r.choices([c for c, _ in CHANGES], [w for _, w in CHANGES])[0]
        if not data:
            break
        data = change(r, data)
        names.append(change.__name__)
    return names, data
