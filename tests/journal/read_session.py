#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Reads recordings (.ttsession) by nothing but docs/session-file.md, and prints what is in them.

Usage: read_session.py [--brief] FILE...

It proves the document: the tests compare what it prints with what the program wrote. It needs the program zstd. Exit code
77: zstd is missing.
"""
import hashlib
import json
import shutil
import struct
import subprocess
import sys
from pathlib import Path

MAGIC = b"\x89TTS\r\n\x1a\n"
VERSION = 1
BLOCK = struct.Struct("<4sHHQIIIII")
MAX_HEADER, MAX_STORED, MAX_RAW, MAX_TICK = 1 << 20, 1 << 24, 1 << 26, 1 << 63
EVENTS, ATTACHMENT, INDEX, RECOVERED, CLOSED, LOST, TRIMMED, SIGNATURE, MIRROR = 1, 4, 5, 6, 7, 9, 10, 11, 12
SKIPPED = 77


class Refused(Exception):
    pass


def make_table():
    table = []
    for byte in range(256):
        for _ in range(8):
            byte = byte >> 1 ^ (0x82F63B78 if byte & 1 else 0)
        table.append(byte)
    return table


TABLE = make_table()


def crc32c(data, crc=0):
    crc ^= 0xFFFFFFFF
    for byte in data:
        crc = crc >> 8 ^ TABLE[(crc ^ byte) & 0xFF]
    return crc ^ 0xFFFFFFFF


class Block:
    def __init__(self, offset, fields, stored):
        self.offset, self.stored = offset, stored
        _, self.type, self.flags, self.tick, self.ticks, _, self.raw_bytes, self.previous, self.crc = fields

    @property
    def end(self):
        return self.offset + BLOCK.size + len(self.stored)

    def payload(self):
        if not self.flags & 1:
            return self.stored
        done = subprocess.run(["zstd", "--decompress", "--stdout", "--quiet"], input=self.stored, capture_output=True)
        if done.returncode != 0 or len(done.stdout) != self.raw_bytes:
            raise Refused(f"the block at byte {self.offset} does not unpack")
        return done.stdout


def read_header(data):
    """The JSON text, and the byte behind the header."""
    if data[:8] != MAGIC:
        raise Refused("no recording" if not data or not MAGIC.startswith(data[:8]) else "the head is cut short")
    if len(data) >= 12 and struct.unpack_from("<I", data, 8)[0] != VERSION:
        raise Refused("another version")
    if len(data) < 20:
        raise Refused("the head is cut short")
    size = struct.unpack_from("<I", data, 12)[0]
    end = 16 + size + 4
    if size > MAX_HEADER or len(data) < end:
        raise Refused("the head is cut short")
    if crc32c(data[: end - 4]) != struct.unpack_from("<I", data, end - 4)[0]:
        raise Refused("the head is damaged")
    return data[16 : end - 4].decode("utf-8"), end


def block_at(data, offset, before):
    """The whole block that is chained to the CRC before it, or nothing."""
    if len(data) - offset < BLOCK.size:
        return None
    fields = BLOCK.unpack_from(data, offset)
    magic, _, flags, tick, ticks, stored_bytes, raw_bytes, previous, crc = fields
    if magic != b"TBLK" or flags & ~1 or previous != before or stored_bytes > MAX_STORED or raw_bytes > MAX_RAW:
        return None
    if tick + ticks > MAX_TICK or (stored_bytes >= raw_bytes if flags & 1 else stored_bytes != raw_bytes):
        return None
    stored = data[offset + BLOCK.size : offset + BLOCK.size + stored_bytes]
    if len(stored) < stored_bytes or crc32c(stored, crc32c(data[offset : offset + BLOCK.size - 4])) != crc:
        return None
    return Block(offset, fields, stored)


def read_blocks(data, offset):
    before = struct.unpack_from("<I", data, offset - 4)[0]
    blocks = []
    while not blocks or blocks[-1].type != CLOSED:
        block = block_at(data, offset, before)
        if block is None:
            break
        blocks.append(block)
        offset, before = block.end, block.crc
    return blocks


P = 2**255 - 19  # Ed25519, as RFC 8032 defines it, in the plainest way
D = -121665 * pow(121666, P - 2, P) % P
ORDER = 2**252 + 27742317777372353535851937790883648493
I = pow(2, (P - 1) // 4, P)


def x_of(y, odd):
    square = (y * y - 1) * pow(D * y * y + 1, P - 2, P) % P
    x = pow(square, (P + 3) // 8, P)
    if (x * x - square) % P:
        x = x * I % P
    if (x * x - square) % P or (x == 0 and odd):
        return None
    return P - x if x & 1 != odd else x


def point_of(data):
    number = int.from_bytes(data, "little")
    y = number & ((1 << 255) - 1)
    x = x_of(y, number >> 255) if y < P else None
    return None if x is None else (x, y, 1, x * y % P)


def add(a, b):
    e, f = (a[1] - a[0]) * (b[1] - b[0]) % P, (a[1] + a[0]) * (b[1] + b[0]) % P
    g, h = 2 * a[3] * b[3] * D % P, 2 * a[2] * b[2] % P
    e, f, g, h = f - e, h - g, h + g, f + e
    return e * f % P, g * h % P, f * g % P, e * h % P


def times(factor, point):
    result = (0, 1, 1, 0)
    while factor:
        if factor & 1:
            result = add(result, point)
        point, factor = add(point, point), factor >> 1
    return result


BASE_Y = 4 * pow(5, P - 2, P) % P
BASE = (x_of(BASE_Y, 0), BASE_Y, 1, x_of(BASE_Y, 0) * BASE_Y % P)


def is_signed_by(key, message, signature):
    a, r, s = point_of(key), point_of(signature[:32]), int.from_bytes(signature[32:], "little")
    if a is None or r is None or s >= ORDER:
        return False
    h = int.from_bytes(hashlib.sha512(signature[:32] + key + message).digest(), "little") % ORDER
    left, right = times(s, BASE), add(r, times(h, a))
    return (left[0] * right[2] - right[0] * left[2]) % P == 0 and (left[1] * right[2] - right[1] * left[2]) % P == 0


def sealed_by(header):
    """The public key that the header names, or nothing."""
    try:
        return bytes.fromhex(json.loads(header)["sealed"]["public_key"])
    except (KeyError, TypeError, ValueError):
        return None


def check_seal(data, blocks, key):
    """Whether the seal is 'intact', 'cut off' or 'changed', and the byte up to which the signatures are right."""
    digest, digested, signed, last = hashlib.blake2b(digest_size=32), 0, 0, None
    for number, block in enumerate(blocks):
        if block.type != SIGNATURE:
            continue
        digest.update(data[digested : block.offset])
        digested = block.offset
        point = struct.unpack_from("<I", block.stored)[0] if len(block.stored) == 68 else 2
        message = b"Tactooth sealed recording 1" + struct.pack("<QQI", block.offset, block.tick, point) + digest.digest()
        has_form = block.flags == 0 and block.ticks == 0 and point < 2 and last != 1
        if not has_form or not is_signed_by(key, message, block.stored[4:]):
            return "changed", signed
        signed, last, at = block.end, point, number
    if last == 1:
        lost = sum(words(block.payload())[0] for block in blocks if block.type == LOST)
        facts = struct.pack("<QQQ", blocks[at - 1].offset, at + 1, lost)
        head = BLOCK.pack(b"TBLK", CLOSED, 0, blocks[at].tick, 0, 24, 24, blocks[at].crc, 0)[:-4]
        wanted = head + struct.pack("<I", crc32c(facts, crc32c(head))) + facts
        rest = data[signed:]
        return ("intact" if rest == wanted else "cut off" if wanted.startswith(rest) else "changed"), signed
    return ("changed" if blocks and blocks[-1].type == CLOSED else "cut off"), signed


def varint(data, at):
    value = shift = 0
    while True:
        byte = data[at]
        value |= (byte & 0x7F) << shift
        at, shift = at + 1, shift + 7
        if not byte & 0x80:
            return value, at


def signed(value):
    value &= (1 << 64) - 1
    return value - (1 << 64) if value >> 63 else value


def columns_of(payload):
    count, at = varint(payload, 0)
    rows, at = varint(payload, at)
    for _ in range(count):
        differences, at = payload[at], at + 1
        values = []
        for row in range(rows):
            residual, at = varint(payload, at)
            residual = residual >> 1 ^ -(residual & 1)
            last = values[-1] if differences > 0 and row > 0 else 0
            step = last - values[-2] if differences > 1 and row > 1 else 0
            values.append(signed(last + step + residual))
        yield differences, values
    if at != len(payload):
        raise Refused("something follows the columns")


def words(payload):
    return struct.unpack(f"<{len(payload) // 8}Q", payload)


def describe(block):
    """A line on the payload of a block."""
    payload = block.payload()
    if block.type in (EVENTS, MIRROR):
        return " ".join(f"[{d}:{','.join(map(str, v))}]" for d, v in columns_of(payload))
    if block.type == ATTACHMENT:
        size = struct.unpack_from("<I", payload)[0]
        total, offset = struct.unpack_from("<QQ", payload, 4 + size)
        return f"{payload[4 : 4 + size].decode('utf-8')} {total} {offset} {payload[20 + size :].hex()}"
    if block.type in (INDEX, RECOVERED, CLOSED, LOST, TRIMMED):
        return " ".join(map(str, words(payload)))
    return payload.hex()


def show(name, brief):
    data = Path(name).read_bytes()
    header, offset = read_header(data)
    blocks = read_blocks(data, offset)
    end = blocks[-1].end if blocks else offset
    if not brief:
        print(f"header {header}")
        for block in blocks:
            print(f"block {block.offset} {block.type} {block.tick} {block.ticks} {block.raw_bytes} {describe(block)}".rstrip())
    if not brief and sealed_by(header) is not None:
        print("seal %s, signed to byte %d" % check_seal(data, blocks, sealed_by(header)))
    is_complete = bool(blocks) and blocks[-1].type == CLOSED
    print(f"{len(blocks)} blocks to byte {end}, {'complete' if is_complete else 'not closed'}")


def main():
    names = [name for name in sys.argv[1:] if name != "--brief"]
    if not names:
        sys.exit("usage: read_session.py [--brief] FILE...")
    if shutil.which("zstd") is None:
        print("skipped: zstd is not installed (apt-get install zstd)")
        sys.exit(SKIPPED)
    for name in names:
        try:
            show(name, "--brief" in sys.argv)
        except Refused as reason:
            print(f"refused: {reason}")


if __name__ == "__main__":
    main()
