// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/export/mcap_writer.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/util/assert.h"

// A record is an opcode, the length of its content and the content. All numbers are little-endian; a text, a list or a
// map begins with its length in bytes.

namespace tactooth {
namespace {

enum Opcode : std::uint8_t {
    kHeader = 0x01,
    kFooter = 0x02,
    kSchema = 0x03,
    kChannel = 0x04,
    kMessage = 0x05,
    kChunk = 0x06,
    kMessageIndex = 0x07,
    kChunkIndex = 0x08,
    kStatistics = 0x0B,
    kSummaryOffset = 0x0E,
    kDataEnd = 0x0F
};

constexpr std::size_t kChunkBytes = 1 << 20;  // a viewer reads a chunk at a time

/// The remainders of all bytes, by the reflected polynomial.
constexpr std::array<std::uint32_t, 256> kCrcTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
        std::uint32_t rest = byte;
        for (int bit = 0; bit < 8; ++bit) rest = (rest & 1) != 0 ? 0xEDB88320U ^ (rest >> 1) : rest >> 1;
        table[byte] = rest;
    }
    return table;
}();

std::vector<std::byte> recordBytes(std::uint8_t opcode, std::span<const std::byte> content) {
    ByteWriter out;
    out.put(opcode);
    out.put(static_cast<std::uint64_t>(content.size()));
    out.putAll(content);
    return out.take();
}

}  // namespace

std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before) {
    std::uint32_t rest = ~before;
    for (const std::byte byte : bytes) {
        rest = kCrcTable[(rest ^ static_cast<std::uint32_t>(byte)) & 0xFFU] ^ (rest >> 8);
    }
    return ~rest;
}

Expected<McapWriter> McapWriter::create(const std::filesystem::path& path, const std::string& library) {
    Expected<AtomicFile> file = AtomicFile::create(path);
    if (!file) return Unexpected{file.error()};
    McapWriter writer(std::move(*file));
    writer.put(std::as_bytes(std::span(kMagic)));
    ByteWriter header;
    header.putText("");  // no profile
    header.putText(library);
    writer.putRecord(kHeader, header.bytes());
    return writer;
}

void McapWriter::put(std::span<const std::byte> bytes) {
    file_.write(bytes);
    crc_ = crc32(bytes, crc_);
    offset_ += bytes.size();
}

void McapWriter::putRecord(std::uint8_t opcode, std::span<const std::byte> content) {
    put(recordBytes(opcode, content));
}

McapWriter::ChannelId McapWriter::addChannel(const std::string& topic, const std::string& schemaName,
                                             const std::string& schema) {
    TACTOOTH_ASSERT(chunks_.empty() && chunk_.bytes().empty());
    channels_.push_back({topic, schemaName, schema});
    return static_cast<ChannelId>(channels_.size());
}

/// The number of a schema is that of its channel.
void McapWriter::putSchemas(ByteWriter& out) const {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        const auto id = static_cast<ChannelId>(i + 1);
        ByteWriter schema;
        schema.put(id);
        schema.putText(channels_[i].schemaName);
        schema.putText("jsonschema");
        schema.putText(channels_[i].schema);
        out.putAll(std::span<const std::byte>(recordBytes(kSchema, schema.bytes())));
    }
}

void McapWriter::putChannels(ByteWriter& out) const {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        const auto id = static_cast<ChannelId>(i + 1);
        ByteWriter channel;
        channel.put(id);
        channel.put(id);  // its schema
        channel.putText(channels_[i].topic);
        channel.putText("json");
        channel.put(std::uint32_t{0});  // no metadata
        out.putAll(std::span<const std::byte>(recordBytes(kChannel, channel.bytes())));
    }
}

void McapWriter::write(ChannelId id, std::uint64_t time, const std::string& json) {
    TACTOOTH_ASSERT(id >= 1 && id <= channels_.size());
    if (chunk_.bytes().empty()) {
        if (chunks_.empty()) putSchemas(chunk_), putChannels(chunk_);
        chunkStart_ = chunkEnd_ = time;
    }
    chunkStart_ = std::min(chunkStart_, time);
    chunkEnd_ = std::max(chunkEnd_, time);
    places_[id].emplace_back(time, chunk_.bytes().size());
    ByteWriter message;
    message.put(id);
    message.put(channels_[id - 1U].messages++);
    message.put(time);  // when it was logged
    message.put(time);  // when it was published
    message.putAll(std::span(json.data(), json.size()));
    chunk_.putAll(std::span<const std::byte>(recordBytes(kMessage, message.bytes())));
    if (chunk_.bytes().size() >= kChunkBytes) endChunk();
}

void McapWriter::endChunk() {
    const std::vector<std::byte> records = chunk_.take();
    chunk_ = {};
    if (records.empty()) return;
    Chunk chunk{chunkStart_, chunkEnd_, offset_, 0, 0, records.size(), {}};
    ByteWriter out;
    out.put(chunk.start);
    out.put(chunk.end);
    out.put(static_cast<std::uint64_t>(records.size()));
    out.put(crc32(records));
    out.putText("");  // not compressed
    out.put(static_cast<std::uint64_t>(records.size()));
    out.putAll(std::span<const std::byte>(records));
    putRecord(kChunk, out.bytes());
    chunk.length = offset_ - chunk.offset;
    for (const auto& [id, places] : places_) {
        chunk.indexOffsets[id] = offset_;
        ByteWriter index;
        index.put(id);
        index.put(static_cast<std::uint32_t>(places.size() * 2 * sizeof(std::uint64_t)));
        for (const auto& [time, place] : places) {
            index.put(time);
            index.put(place);
        }
        putRecord(kMessageIndex, index.bytes());
    }
    chunk.indexLength = offset_ - chunk.offset - chunk.length;
    chunks_.push_back(std::move(chunk));
    places_.clear();
}

void McapWriter::putSummary() {
    struct Group {
        std::uint8_t opcode;
        std::uint64_t start, length;
    };
    const std::uint64_t start = offset_;
    crc_ = 0;
    std::vector<Group> groups;
    const auto endGroup = [&] { groups.back().length = offset_ - groups.back().start; };
    ByteWriter schemas, channels;
    putSchemas(schemas);
    putChannels(channels);
    groups.push_back({kSchema, offset_, 0});
    put(schemas.bytes());
    endGroup();
    groups.push_back({kChannel, offset_, 0});
    put(channels.bytes());
    endGroup();

    ByteWriter statistics;
    std::uint64_t messages = 0;
    for (const Channel& channel : channels_) messages += channel.messages;
    statistics.put(messages);
    statistics.put(static_cast<std::uint16_t>(channels_.size()));  // schemas
    statistics.put(static_cast<std::uint32_t>(channels_.size()));
    statistics.put(std::uint32_t{0});  // attachments
    statistics.put(std::uint32_t{0});  // metadata
    statistics.put(static_cast<std::uint32_t>(chunks_.size()));
    std::uint64_t first = chunks_.empty() ? 0 : chunks_.front().start, last = 0;
    for (const Chunk& chunk : chunks_) {
        first = std::min(first, chunk.start);
        last = std::max(last, chunk.end);
    }
    statistics.put(first);
    statistics.put(last);
    statistics.put(static_cast<std::uint32_t>(channels_.size() * (sizeof(ChannelId) + sizeof(std::uint64_t))));
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        statistics.put(static_cast<ChannelId>(i + 1));
        statistics.put(std::uint64_t{channels_[i].messages});
    }
    groups.push_back({kStatistics, offset_, 0});
    putRecord(kStatistics, statistics.bytes());
    endGroup();

    groups.push_back({kChunkIndex, offset_, 0});
    for (const Chunk& chunk : chunks_) {
        ByteWriter index;
        for (const std::uint64_t number : {chunk.start, chunk.end, chunk.offset, chunk.length}) index.put(number);
        index.put(static_cast<std::uint32_t>(chunk.indexOffsets.size() * (sizeof(ChannelId) + sizeof(std::uint64_t))));
        for (const auto& [id, place] : chunk.indexOffsets) {
            index.put(id);
            index.put(place);
        }
        index.put(chunk.indexLength);
        index.putText("");
        index.put(chunk.bytes);  // compressed
        index.put(chunk.bytes);
        putRecord(kChunkIndex, index.bytes());
    }
    endGroup();

    const std::uint64_t offsets = offset_;
    for (const Group& group : groups) {
        if (group.length == 0) continue;
        ByteWriter out;
        out.put(group.opcode);
        out.put(group.start);
        out.put(group.length);
        putRecord(kSummaryOffset, out.bytes());
    }
    ByteWriter footer;  // the checksum covers all of the summary, and the footer up to here
    footer.put(std::uint8_t{kFooter});
    footer.put(static_cast<std::uint64_t>(2 * sizeof(std::uint64_t) + sizeof(std::uint32_t)));
    footer.put(start);
    footer.put(offsets);
    put(footer.bytes());
    ByteWriter checksum;
    checksum.put(crc_);
    put(checksum.bytes());
}

Expected<void> McapWriter::commit() {
    endChunk();
    ByteWriter end;
    end.put(crc_);
    putRecord(kDataEnd, end.bytes());
    putSummary();
    put(std::as_bytes(std::span(kMagic)));
    return file_.commit();
}

}  // namespace tactooth
