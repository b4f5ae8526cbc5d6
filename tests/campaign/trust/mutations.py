"""Files that break off, repeat, lie about counts or hold odd numbers: seeded changes of bytes and of structure."""

import random
import re
from collections.abc import Callable

ODD = (
    b"1e200", b"-1e308", b"1e999", b"nan", b"inf", b"-inf", b"0", b"-1", b"-0.0", b"99999999999999999999",
    b"9" * 400,
    b"", b"x", b"1e-320", b"0x1F", "\u0661".encode(), b"1_0", b"1e", b".", b"--1",
    b"1,5", b"1000000", b"1e9", b"1e-9",
    b"2147483648", b"\xff\xfe", b"\x00", b"=1+1", b"<", b"&", b"]]>", b"\"", b"{", b"%s", b"..", b"../../x", b"#a",
)  # fmt: skip
_NUMBER = re.compile(rb"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
_BOMB = (
    b'<?xml version="1.0"?><!DOCTYPE svg [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;">'
    b'<!ENTITY c "&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;"><!ENTITY d "&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;">]>'
)


def mutated(rng: random.Random, kind: str, first: bytes, other: bytes) -> bytes:
    """One to four changes of a sound file of a format; `other` is another one of it."""
    data = first
    for _ in range(rng.choice((1, 1, 1, 2, 2, 3, 4))):
        change = rng.choice(_CHANGES + _OF_KIND.get(kind, ()))
        data = change(rng, data, other)
    return data


def _odd_number(rng: random.Random, data: bytes, _: bytes) -> bytes:
    found = list(_NUMBER.finditer(data))
    if not found:
        return data
    at = rng.choice(found)
    return data[: at.start()] + rng.choice(ODD) + data[at.end() :]


def _scaled_number(rng: random.Random, data: bytes, _: bytes) -> bytes:
    found = list(_NUMBER.finditer(data))
    if not found:
        return data
    at, power = rng.choice(found), rng.choice((-12, -6, -3, 3, 6, 9, 12))
    return data[: at.start()] + at[0] + b"e%d" % power + data[at.end() :]


def _other_number(rng: random.Random, data: bytes, _: bytes) -> bytes:
    found = list(_NUMBER.finditer(data))
    if not found:
        return data
    at, other = rng.choice(found), rng.choice(found)
    new = (
        b"%.4g" % (rng.uniform(-2, 2) * float(at[0])) if rng.random() < 0.5 and len(at[0]) < 20 else other[0]
    )
    return data[: at.start()] + new + data[at.end() :]


def _bytes(rng: random.Random, data: bytes, _: bytes) -> bytes:
    changed = bytearray(data)
    for _n in range(rng.choice((1, 2, 8))):
        if changed:
            changed[rng.randrange(len(changed))] = rng.randrange(256)
    return bytes(changed)


def _cut(rng: random.Random, data: bytes, _: bytes) -> bytes:
    return (
        data[: rng.randrange(len(data) + 1)] if rng.random() < 0.7 else data[rng.randrange(len(data) + 1) :]
    )


def _lines(rng: random.Random, data: bytes, _: bytes) -> bytes:
    sign = b"\n" if data.count(b"\n") > 5 else b" "
    rows = data.split(sign)
    at, to = rng.randrange(len(rows)), rng.randrange(len(rows))
    what = rng.randrange(4)
    if what == 0:
        del rows[at : at + rng.randint(1, 3)]
    elif what == 1:
        rows.insert(at, rows[to])
    elif what == 2:
        rows[at], rows[to] = rows[to], rows[at]
    else:
        rows[at:at] = rows[min(at, to) : min(at, to) + 40] * rng.choice((2, 50, 400))
    return sign.join(rows)[: 2**21]


def _spliced(rng: random.Random, data: bytes, other: bytes) -> bytes:
    return data[: rng.randrange(len(data) + 1)] + other[rng.randrange(len(other) + 1) :]


def _encoded(rng: random.Random, data: bytes, _: bytes) -> bytes:
    text = data.decode("latin-1")
    return rng.choice((
        lambda: text.encode("utf-16"), lambda: b"\xef\xbb\xbf" + data, lambda: data.replace(b"\n", b"\r\n"),
        lambda: data.replace(b"\n", b"\r"), lambda: data.replace(b" ", b"\t"), data.upper,
    ))()  # fmt: skip


def _word(rng: random.Random, data: bytes, _: bytes) -> bytes:
    found = list(re.finditer(rb"[A-Za-z_:]{2,}", data))
    if not found:
        return data
    at = rng.choice(found)
    new = rng.choice((*ODD, rng.choice(found)[0], at[0] * 200))
    return data[: at.start()] + new + data[at.end() :]


def _clones(rng: random.Random, data: bytes, _: bytes) -> bytes:
    levels, each = rng.randint(2, 40), rng.choice((2, 9, 30))
    body = rng.choice(
        (b'<path d="M0 0C1 2 3 2 4 0"/>', b"", b"<text>A</text>", b"<g/>", b'<use href="#g3"/>')
    )
    groups = [b'<g id="g0">' + body + b"</g>"]
    for k in range(1, levels):
        groups.append(b'<g id="g%d">' % k + b'<use href="#g%d"/>' % (k - 1) * each + b"</g>")
    put = b"<defs>" + b"".join(groups) + b'</defs><use href="#g%d"/></svg>' % (levels - 1)
    return data.replace(b"</svg>", put)


def _entities(_: random.Random, data: bytes, __: bytes) -> bytes:
    return _BOMB + data.replace(b"</svg>", b"<text>&d;</text></svg>")


def _deep(rng: random.Random, data: bytes, _: bytes) -> bytes:
    n = rng.choice((150, 500, 20_000))
    return data.replace(b"</svg>", b"<g>" * n + b"</g>" * n + b"</svg>")


def _deep_json(rng: random.Random, data: bytes, _: bytes) -> bytes:
    n = rng.choice((50, 2000, 200_000))
    return rng.choice((b"[" * n + data + b"]" * n, data.replace(b"[", b"[" * n, 1)))


def _inserts(rng: random.Random, data: bytes, _: bytes) -> bytes:
    rows = rng.choice((2, 200, 32767, 10**9))
    put = b"  0\nINSERT\n  8\n0\n  2\n%s\n 10\n0.0\n 20\n0.0\n 30\n0.0\n 70\n%d\n 71\n%d\n 44\n1.0\n 45\n1.0\n" % (
        rng.choice((b"B", b"C", b"none", b"*Model_Space")), rows, rng.choice((1, rows)),
    )  # fmt: skip
    at = data.rfind(b"  0\nENDSEC\n", 0, max(0, data.find(b"OBJECTS")) or len(data))
    return data if at < 0 else data[:at] + put + data[at:]


Change = Callable[[random.Random, bytes, bytes], bytes]
_CHANGES: tuple[Change, ...] = (
    _other_number, _other_number, _other_number, _other_number, _odd_number, _odd_number, _scaled_number,
    _bytes, _cut, _lines, _lines, _spliced, _encoded, _word,
)  # fmt: skip
_OF_KIND: dict[str, tuple[Change, ...]] = {
    "svg": (_clones, _entities, _deep), "dxf": (_inserts,), "json": (_deep_json,),
}  # fmt: skip
