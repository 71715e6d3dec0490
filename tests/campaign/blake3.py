"""BLAKE3 in Python, for lists of digests written anew. It is tested against the program's own."""

import struct

IV = (
    0x6A09E667, 0xBB67AE85, 0x3C6EF372, 0xA54FF53A,
    0x510E527F, 0x9B05688C, 0x1F83D9AB, 0x5BE0CD19,
)
MIX = (2, 6, 3, 10, 7, 0, 4, 13, 1, 11, 12, 5, 9, 14, 15, 8)
CHUNK_START, CHUNK_END, PARENT, ROOT = 1, 2, 4, 8
MASK = 0xFFFFFFFF


def orders():
    """The order of the words of a block in each of the seven rounds."""
    out, order = [], tuple(range(16))
    for _ in range(7):
        out.append(order)
        order = tuple(order[m] for m in MIX)
    return out


ORDERS = orders()
# columns, then diagonals
QUARTERS = (
    (0, 4, 8, 12), (1, 5, 9, 13), (2, 6, 10, 14), (3, 7, 11, 15),
    (0, 5, 10, 15), (1, 6, 11, 12), (2, 7, 8, 13), (3, 4, 9, 14),
)


def compress(chain, words, counter, length, flags):
    v = [*chain, *IV[:4], counter & MASK, counter >> 32, length, flags]
    for order in ORDERS:
        at = 0
        for a, b, c, d in QUARTERS:
            va = (v[a] + v[b] + words[order[at]]) & MASK
            x = v[d] ^ va
            vd = (x >> 16 | x << 16) & MASK
            vc = (v[c] + vd) & MASK
            x = v[b] ^ vc
            vb = (x >> 12 | x << 20) & MASK
            va = (va + vb + words[order[at + 1]]) & MASK
            x = vd ^ va
            vd = (x >> 8 | x << 24) & MASK
            vc = (vc + vd) & MASK
            x = vb ^ vc
            v[a], v[b], v[c], v[d] = va, (x >> 7 | x << 25) & MASK, vc, vd
            at += 2
    return [v[i] ^ v[i + 8] for i in range(8)]


def chunk(data, counter, root):
    chain = IV
    blocks = [data[i : i + 64] for i in range(0, len(data), 64)] or [b""]
    for i, block in enumerate(blocks):
        flags = CHUNK_START if i == 0 else 0
        if i == len(blocks) - 1:
            flags |= CHUNK_END | (ROOT if root else 0)
        words = struct.unpack("<16I", block.ljust(64, b"\0"))
        chain = compress(chain, words, counter, len(block), flags)
    return chain


def parent(left, right, root):
    return compress(IV, [*left, *right], 0, 64, PARENT | (ROOT if root else 0))


def tree(chains):
    """Joins the chunks: the left part is the largest power of two that leaves something."""
    if len(chains) == 1:
        return chains[0]
    half = 1 << (len(chains) - 1).bit_length() - 1
    return parent(tree(chains[:half]), tree(chains[half:]), False)


def digest(data):
    """The hash as 64 hexadecimal digits."""
    chunks = [data[i : i + 1024] for i in range(0, len(data), 1024)] or [b""]
    if len(chunks) == 1:
        words = chunk(chunks[0], 0, True)
    else:
        chains = [chunk(c, i, False) for i, c in enumerate(chunks)]
        half = 1 << (len(chains) - 1).bit_length() - 1
        words = parent(tree(chains[:half]), tree(chains[half:]), True)
    return struct.pack("<8I", *words).hex()
