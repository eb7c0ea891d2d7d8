// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/file_bytes.h"

#include <cstdint>

#include "geometry/files/readable_file.h"
#include "geometry/util/display_text.h"
#include "geometry/util/messages.h"

namespace tactooth {

Expected<FileBytes> readFile(const std::filesystem::path& path, std::size_t most) {
    const std::string name = displayName(path);
    const Expected<ReadableFile> file = ReadableFile::open(path);
    if (!file) return Unexpected{file.error()};
    const std::uint64_t size = file->size();
    if (size == 0) return unexpected(msg::kFileEmpty, name);
    if (size > most) return unexpected(msg::kFileTooLong, name, size, most);

    auto* const data = static_cast<std::byte*>(allocateOnLargePages(size));
    if (data == nullptr) return unexpected(msg::kFileTooLargeForMemory, name, size);
    FileBytes whole(data, size);
    const Expected<std::size_t> filled = file->readAt(0, {data, size});
    if (!filled) return Unexpected{filled.error()};
    whole.shorten(*filled);  // the file may have become shorter meanwhile; its parser reports what is missing
    return whole;
}

std::string displayName(const std::filesystem::path& path) { return displayText(path.native()); }

std::string displayFileName(const std::filesystem::path& path) {
    const std::filesystem::path plain = path.lexically_normal();
    return displayName(plain.has_filename() ? plain.filename() : plain.parent_path().filename());
}

}  // namespace tactooth
