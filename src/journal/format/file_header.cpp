// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/format/file_header.h"

#include <algorithm>

#include "geometry/util/assert.h"
#include "geometry/util/byte_stream.h"
#include "journal/codec/crc32c.h"
#include "journal/format/journal_block.h"

namespace tactooth {

std::vector<std::byte> fileHeaderBytes(std::string_view json) {
    TACTOOTH_ASSERT(json.size() <= kMaxHeaderBytes);
    ByteWriter out;
    out.putAll(std::span<const std::uint8_t>(kJournalMagic));
    out.put(kJournalVersion);
    out.putText(json);
    out.put(crc32c(out.bytes()));
    TACTOOTH_ASSERT(out.bytes().size() == kHeaderFrameBytes + json.size());
    return out.take();
}

std::uint32_t fileHeaderCrc(std::span<const std::byte> header) {
    TACTOOTH_ASSERT(header.size() >= kHeaderFrameBytes);
    return ByteReader(header.last(sizeof(std::uint32_t))).get<std::uint32_t>();
}

HeaderStart parseHeaderStart(std::span<const std::byte> start) {
    ByteReader in(start);
    const auto magic = in.get<std::array<std::uint8_t, kJournalMagic.size()>>();
    HeaderStart found;
    if (!in.ok()) {  // the file ends inside its magic
        const auto whole = std::as_bytes(std::span(kJournalMagic));
        const bool isBeginning = !start.empty() && std::ranges::equal(start, whole.first(start.size()));
        found.kind = isBeginning ? HeaderStart::Kind::Damaged : HeaderStart::Kind::NoJournal;
        return found;
    }
    if (magic != kJournalMagic) return found;
    found.version = in.get<std::uint32_t>();
    found.jsonBytes = in.get<std::uint32_t>();
    if (in.at() >= kJournalMagic.size() + sizeof found.version && found.version != kJournalVersion) {
        found.kind = HeaderStart::Kind::OtherVersion;
    } else {
        found.kind =
            in.ok() && found.jsonBytes <= kMaxHeaderBytes ? HeaderStart::Kind::Valid : HeaderStart::Kind::Damaged;
    }
    return found;
}

}  // namespace tactooth
