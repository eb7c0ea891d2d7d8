// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/files/atomic_file.h"
#include "geometry/util/byte_stream.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// CRC-32 with the polynomial of zlib and PNG. `before`: of the bytes before these; 0 if there are none.
[[nodiscard]] std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before = 0);

/// Writes a file in the format MCAP (https://mcap.dev/spec), which programs for robot data open: messages in JSON, in
/// chunks that are not compressed, with an index and checksums. The file appears when `commit` succeeds.
class McapWriter {
public:
    using ChannelId = std::uint16_t;
    static constexpr std::string_view kMagic = "\x89MCAP0\r\n";

    /// Fails with one sentence as AtomicFile does. `library`: the program that writes.
    [[nodiscard]] static Expected<McapWriter> create(const std::filesystem::path& path, const std::string& library);

    /// `schemaName`: what a message is; `schema`: JSON Schema of it. Call it before the first message.
    [[nodiscard]] ChannelId addChannel(const std::string& topic, const std::string& schemaName,
                                       const std::string& schema);
    /// `time`: ns since 1970. Messages of a channel come in their order.
    void write(ChannelId channel, std::uint64_t time, const std::string& json);
    /// The next message begins a new chunk; for one that belongs to an earlier time.
    void endChunk();
    [[nodiscard]] Expected<void> commit();

private:
    struct Channel {
        std::string topic, schemaName, schema;
        std::uint32_t messages = 0;
    };
    struct Chunk {
        std::uint64_t start = 0, end = 0;  ///< ns
        std::uint64_t offset = 0, length = 0, indexLength = 0, bytes = 0;
        std::map<ChannelId, std::uint64_t> indexOffsets;
    };

    explicit McapWriter(AtomicFile file) : file_(std::move(file)) {}
    void put(std::span<const std::byte> bytes);
    void putRecord(std::uint8_t opcode, std::span<const std::byte> content);
    void putSchemas(ByteWriter& out) const;
    void putChannels(ByteWriter& out) const;
    void putSummary();

    AtomicFile file_;
    std::uint64_t offset_ = 0;  // bytes written
    std::uint32_t crc_ = 0;     // of these
    std::vector<Channel> channels_;
    ByteWriter chunk_;  // records of the chunk that is being filled
    std::map<ChannelId, std::vector<std::pair<std::uint64_t, std::uint64_t>>> places_;  // in it: time and offset
    std::uint64_t chunkStart_ = 0, chunkEnd_ = 0;
    std::vector<Chunk> chunks_;
};

}  // namespace tactooth
