#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Reads recordings (.ttsession) by nothing but docs/session-file.md, and prints what is in them.

Usage: read_session.py [--brief] FILE...

It proves the document: the tests compare what it prints with what the program wrote. It needs the program zstd. Exit code
77: zstd is missing.
"""
import shutil
import struct
import subprocess
import sys
from pathlib import Path

MAGIC = b"\x89TTS\r\n\x1a\n"
VERSION = 1
BLOCK = struct.Struct("<4sHHQIIIII")
MAX_HEADER, MAX_STORED, MAX_RAW, MAX_TICK = 1 << 20, 1 << 24, 1 << 26, 1 << 63
EVENTS, ATTACHMENT, INDEX, RECOVERED, CLOSED, LOST, TRIMMED = 1, 4, 5, 6, 7, 9, 10
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
    if block.type == EVENTS:
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
