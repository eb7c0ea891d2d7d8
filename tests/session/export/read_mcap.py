#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Reads an MCAP file by nothing but https://mcap.dev/spec, and checks every record, index and checksum.

Usage: read_mcap.py FILE [--expect TOPIC=MESSAGES]... [--mutate]

It prints one JSON object: for each topic the number of messages, the first and the last one. --mutate also changes each
byte in turn, and expects that the change is seen.
"""
import json
import struct
import sys
import zlib

MAGIC = b"\x89MCAP0\r\n"
HEADER, FOOTER, SCHEMA, CHANNEL, MESSAGE, CHUNK, MESSAGE_INDEX, CHUNK_INDEX = range(1, 9)
STATISTICS, SUMMARY_OFFSET, DATA_END = 0x0B, 0x0E, 0x0F


class Wrong(Exception):
    pass


def check(condition, what):
    if not condition:
        raise Wrong(what)


class Reader:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, count):
        check(self.at + count <= len(self.data), "cut off")
        self.at += count
        return self.data[self.at - count : self.at]

    def number(self, form):
        return struct.unpack("<" + form, self.take(struct.calcsize("<" + form)))[0]

    def block(self):
        return self.take(self.number("I"))

    def text(self):
        return self.block().decode()

    def pairs(self, form):
        inner = Reader(self.block())
        found = []
        while inner.at < len(inner.data):
            found.append(tuple(inner.number(part) for part in form))
        return found

    def end(self):
        check(self.at == len(self.data), "a record has more bytes than it should")


def records(data, start, stop):
    """(offset, opcode, content) of each record."""
    at = start
    while at < stop:
        check(at + 9 <= stop, "a record is cut off")
        opcode, length = struct.unpack_from("<BQ", data, at)
        check(at + 9 + length <= stop, "a record is too long")
        yield at, opcode, data[at + 9 : at + 9 + length]
        at += 9 + length


TYPES = {"number": (int, float), "integer": int, "string": str, "boolean": bool, "object": dict}


def check_json(value, schema, where):
    """The part of JSON Schema that the files use."""
    wanted = schema.get("type")
    if wanted:
        is_bool = isinstance(value, bool)
        check(isinstance(value, TYPES[wanted]) and (wanted == "boolean") == is_bool, f"{where} is no {wanted}")
    for name, inner in schema.get("properties", {}).items():
        if name in value:
            check_json(value[name], inner, f"{where}.{name}")
    if "properties" in schema:
        check(set(value) <= set(schema["properties"]), f"{where} has what the schema does not know")


class File:
    def __init__(self, data):
        self.data = data
        self.schemas, self.channels, self.messages = {}, {}, {}
        self.chunks = []
        self.sequences = {}
        check(data[:8] == MAGIC and data[-8:] == MAGIC, "no magic")
        self.read_footer()
        self.read_data()
        self.read_summary()

    def read_footer(self):
        at = len(self.data) - 8 - 29
        check(at >= 8 and self.data[at] == FOOTER, "no footer")
        length, self.summary, self.offsets, crc = struct.unpack_from("<QQQI", self.data, at + 1)
        check(length == 20, "the footer has another length")
        self.footer = at
        check(8 <= self.summary <= self.offsets <= at, "the summary is elsewhere")
        check(crc == zlib.crc32(self.data[self.summary : at + 25]), "the checksum of the summary is wrong")

    def read_data(self):
        ended = False
        for at, opcode, content in records(self.data, 8, self.summary):
            check(not ended, "something follows the end of the data")
            reader = Reader(content)
            if at == 8:
                check(opcode == HEADER, "no header")
                self.profile, self.library = reader.text(), reader.text()
            elif opcode == CHUNK:
                self.read_chunk(at, reader, len(content))
            elif opcode == MESSAGE_INDEX:
                self.read_message_index(at, reader, len(content))
            elif opcode == DATA_END:
                crc = reader.number("I")
                check(crc == zlib.crc32(self.data[:at]), "the checksum of the data is wrong")
                ended = True
            else:
                raise Wrong(f"record {opcode} among the data")
            reader.end()
        check(ended, "the data have no end")

    def read_chunk(self, at, reader, length):
        start, end, size = (reader.number("Q") for _ in range(3))
        crc, compression = reader.number("I"), reader.text()
        stored = reader.take(reader.number("Q"))
        check(compression == "" and len(stored) == size, "the chunk is compressed")
        check(crc == zlib.crc32(stored), "the checksum of a chunk is wrong")
        chunk = {"start": start, "end": end, "offset": at, "length": length + 9, "size": size}
        chunk.update(places={}, indices={}, times=[], index_length=0)
        for place, opcode, content in records(stored, 0, len(stored)):
            inner = Reader(content)
            if opcode == SCHEMA:
                self.read_schema(inner)
            elif opcode == CHANNEL:
                self.read_channel(inner)
            elif opcode == MESSAGE:
                self.read_message(inner, chunk, place)
            else:
                raise Wrong(f"record {opcode} in a chunk")
            inner.end()
        check(min(chunk["times"]) == start and max(chunk["times"]) == end, "the times of a chunk are wrong")
        self.chunks.append(chunk)

    def read_schema(self, reader):
        number, name, encoding, data = reader.number("H"), reader.text(), reader.text(), reader.block()
        check(number > 0 and encoding == "jsonschema", "a schema of another kind")
        schema = (name, json.loads(data))
        check(self.schemas.setdefault(number, schema) == schema, "a schema has changed")

    def read_channel(self, reader):
        number, schema = reader.number("H"), reader.number("H")
        topic, encoding, metadata = reader.text(), reader.text(), reader.block()
        check(schema in self.schemas and encoding == "json" and metadata == b"", "a channel of another kind")
        channel = (topic, schema)
        check(self.channels.setdefault(number, channel) == channel, "a channel has changed")

    def read_message(self, reader, chunk, place):
        channel, sequence = reader.number("H"), reader.number("I")
        logged, published = reader.number("Q"), reader.number("Q")
        value = json.loads(reader.take(len(reader.data) - reader.at))
        check(channel in self.channels, "a message without a channel")
        check(sequence == self.sequences.get(channel, 0) and logged == published, "a message is missing")
        self.sequences[channel] = sequence + 1
        topic, schema = self.channels[channel]
        check_json(value, self.schemas[schema][1], topic)
        if "timestamp" in value:
            stamp = value["timestamp"]
            check(stamp["sec"] * 10**9 + stamp["nsec"] == logged, "two times of a message")
        self.messages.setdefault(topic, []).append((logged, value))
        chunk["times"].append(logged)
        chunk["places"].setdefault(channel, []).append((logged, place))

    def read_message_index(self, at, reader, length):
        check(self.chunks, "a message index before the first chunk")
        chunk = self.chunks[-1]
        channel, places = reader.number("H"), reader.pairs("QQ")
        check(places == chunk["places"].get(channel), "a message index is wrong")
        chunk["indices"][channel] = at
        chunk["index_length"] += length + 9

    def read_summary(self):
        groups, indexed, statistics = {}, [], None
        for at, opcode, content in records(self.data, self.summary, self.offsets):
            first, _ = groups.get(opcode, (at, at))
            groups[opcode] = (first, at + 9 + len(content))
            reader = Reader(content)
            if opcode == SCHEMA:
                self.read_schema(reader)
            elif opcode == CHANNEL:
                self.read_channel(reader)
            elif opcode == STATISTICS:
                statistics = tuple(reader.number(form) for form in "QHIIIIQQ") + (dict(reader.pairs("HQ")),)
            elif opcode == CHUNK_INDEX:
                numbers = tuple(reader.number("Q") for _ in range(4))
                places, length = dict(reader.pairs("HQ")), reader.number("Q")
                indexed.append(numbers + (places, length, reader.text(), reader.number("Q"), reader.number("Q")))
            else:
                raise Wrong(f"record {opcode} in the summary")
            reader.end()
        expected = [
            (c["start"], c["end"], c["offset"], c["length"], c["indices"], c["index_length"], "", c["size"], c["size"])
            for c in self.chunks
        ]
        check(indexed == expected, "the index of the chunks is wrong")
        for chunk in self.chunks:
            check(set(chunk["indices"]) == set(chunk["places"]), "a message index is missing")
        times = [time for chunk in self.chunks for time in chunk["times"]] or [0]
        counts = {number: self.sequences.get(number, 0) for number in self.channels}
        sizes = (sum(counts.values()), len(self.schemas), len(self.channels), 0, 0, len(self.chunks))
        check(statistics == sizes + (min(times), max(times), counts), "the statistics are wrong")
        offsets = {}
        for _, opcode, content in records(self.data, self.offsets, self.footer):
            check(opcode == SUMMARY_OFFSET, "no summary offset")
            group, start, length = struct.unpack("<BQQ", content)
            offsets[group] = (start, start + length)
        check(offsets == groups, "the summary offsets are wrong")


def main(arguments):
    name, expected, mutates = arguments[0], {}, False
    rest = iter(arguments[1:])
    for argument in rest:
        if argument == "--mutate":
            mutates = True
        else:
            topic, count = next(rest).split("=")
            expected[topic] = int(count)
    data = open(name, "rb").read()
    file = File(data)
    counts = {topic: len(file.messages.get(topic, [])) for topic, _ in file.channels.values()}
    for topic, count in expected.items():
        check(counts.get(topic) == count, f"{topic} has {counts.get(topic)} messages")
    if mutates:
        for at in range(len(data)):
            changed = bytearray(data)
            changed[at] ^= 1
            try:
                File(bytes(changed))
            except (Wrong, ValueError, struct.error, KeyError):
                continue
            raise Wrong(f"a change of byte {at} is not seen")
    summary = {
        topic: {"messages": len(found), "schema": file.schemas[schema][0], "first": found[0], "last": found[-1]}
        for topic, schema in file.channels.values()
        for found in [file.messages.get(topic, [])]
        if found
    }
    print(json.dumps(summary))


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Wrong as wrong:
        sys.exit(f"{sys.argv[1]}: {wrong}")
