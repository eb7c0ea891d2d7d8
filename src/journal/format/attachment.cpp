// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/format/attachment.h"

#include <algorithm>

#include "geometry/util/assert.h"
#include "geometry/util/byte_stream.h"

namespace tactooth {

std::vector<JournalBlock> attachmentBlocks(std::string_view name, std::span<const std::byte> content) {
    TACTOOTH_ASSERT(!name.empty() && name.size() <= kMaxAttachmentName);
    std::vector<JournalBlock> blocks;
    std::size_t offset = 0;
    do {  // an empty file is one empty piece
        const std::size_t size = std::min(kAttachmentPieceBytes, content.size() - offset);
        ByteWriter out;
        out.putText(name);
        out.put(static_cast<std::uint64_t>(content.size()));
        out.put(static_cast<std::uint64_t>(offset));
        out.putAll(content.subspan(offset, size));
        blocks.push_back({BlockType::Attachment, 0, 0, out.take()});
        offset += size;
    } while (offset < content.size());
    TACTOOTH_ASSERT(offset == content.size());
    return blocks;
}

std::optional<AttachmentPiece> parseAttachment(std::span<const std::byte> payload) {
    ByteReader in(payload);
    AttachmentPiece piece;
    piece.name = in.getText();
    piece.totalBytes = in.get<std::uint64_t>();
    piece.offset = in.get<std::uint64_t>();
    piece.content = in.getBytes(in.left());
    const bool isValid = in.ok() && !piece.name.empty() && piece.name.size() <= kMaxAttachmentName &&
                         piece.offset <= piece.totalBytes && piece.content.size() <= piece.totalBytes - piece.offset;
    if (!isValid) return std::nullopt;
    return piece;
}

}  // namespace tactooth
