// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/attachment_reader.h"

#include <optional>
#include <string>

#include "geometry/util/assert.h"
#include "geometry/util/display_text.h"
#include "journal/file/messages.h"
#include "journal/format/attachment.h"

namespace tactooth {

Expected<std::vector<std::byte>> readAttachment(const JournalReader& journal, std::string_view name, std::size_t most) {
    std::vector<std::byte> content;
    for (const BlockPlace& block : journal.blocks()) {
        if (block.header.type != BlockType::Attachment) continue;
        const Expected<std::vector<std::byte>> payload = journal.payload(block);
        if (!payload) return Unexpected{payload.error()};
        const std::optional<AttachmentPiece> piece = parseAttachment(*payload);
        if (!piece || piece->name != name || piece->offset != content.size()) continue;
        if (piece->totalBytes > most) {
            return unexpected(msg::kJournalAttachmentTooLong, journal.name(), displayText(name), piece->totalBytes,
                              most);
        }
        content.insert(content.end(), piece->content.begin(), piece->content.end());
        TACTOOTH_ASSERT(content.size() <= most);
        if (content.size() == piece->totalBytes) return content;
    }
    return unexpected(msg::kJournalAttachmentMissing, journal.name(), displayText(name));
}

}  // namespace tactooth
