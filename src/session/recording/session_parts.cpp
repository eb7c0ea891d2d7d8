// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/session_parts.h"

#include <fstream>
#include <vector>

#include "journal/format/file_header.h"
#include "session/recording/session_recorder.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

/// Of a file whose other blocks are not looked at.
std::optional<RecordingPart> partIn(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::vector<char> start(kHeaderStartBytes);
    if (!in.read(start.data(), static_cast<std::streamsize>(start.size()))) return std::nullopt;
    const HeaderStart head = parseHeaderStart(std::as_bytes(std::span(start)));
    if (head.kind != HeaderStart::Kind::Valid) return std::nullopt;
    std::string json(head.jsonBytes, '\0');
    if (!in.read(json.data(), static_cast<std::streamsize>(json.size()))) return std::nullopt;
    return partOf(json);
}

}  // namespace

NeighbourParts neighbourParts(const fs::path& file, const RecordingPart& part) {
    NeighbourParts found;
    if (part.session.empty()) return found;
    std::error_code failure;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    fs::directory_iterator entry(folder, failure);
    for (; !failure && entry != fs::directory_iterator(); entry.increment(failure)) {
        std::error_code ignored;
        if (entry->path().extension() != kSessionFileEnding || !entry->is_regular_file(ignored)) continue;
        const std::optional<RecordingPart> other = partIn(entry->path());
        if (!other || other->session != part.session) continue;
        if (other->number + 1 == part.number) found.before = entry->path();
        if (other->number == part.number + 1) found.behind = entry->path();
    }
    return found;
}

}  // namespace tactooth
