// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/zip_archive.h"

#include <zip.h>

#include <algorithm>

#include "geometry/files/file_bytes.h"
#include "session/cases/case_store.h"
#include "session/cases/messages.h"

namespace tactooth {
namespace {

struct CloseFile {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

/// libzip's message for an error code, on one line.
std::string wordsFor(int code) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    std::string words = zip_error_strerror(&error);
    zip_error_fini(&error);
    return words;
}

/// Checks the header of an entry.
Expected<void> checkClaims(const zip_stat_t& stat, const std::string& shown) {
    constexpr zip_uint64_t kNeeded =
        ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD;
    if ((stat.valid & kNeeded) != kNeeded) return unexpected(msg::kArchiveListDamaged, shown);
    if (stat.encryption_method != ZIP_EM_NONE) {
        return unexpected(msg::kArchiveLocked, shown);
    }
    if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE) {
        return unexpected(msg::kArchiveMethod, shown);
    }
    constexpr double kSmall = 65536;  // bytes: a small file may have a higher packing ratio
    if (stat.size > kCaseLimits.entryBytes ||
        static_cast<double>(stat.size) > kSmall + kCaseLimits.packed * static_cast<double>(stat.comp_size)) {
        return unexpected(msg::kArchiveBomb, shown, stat.comp_size, stat.size);
    }
    return {};
}

bool isLink(zip_t* archive, zip_uint64_t index) {
    constexpr zip_uint32_t kKindOfFile = 0170000, kLink = 0120000;  // Unix mode, in the upper half
    zip_uint8_t system = 0;
    zip_uint32_t attributes = 0;
    if (zip_file_get_external_attributes(archive, index, 0, &system, &attributes) != 0) return false;
    const bool isUnix = system == ZIP_OPSYS_UNIX || system == ZIP_OPSYS_OS_X;
    return isUnix && (attributes >> 16 & kKindOfFile) == kLink;
}

}  // namespace

void ZipArchive::Close::operator()(zip* archive) const { zip_discard(archive); }

Expected<ZipArchive> ZipArchive::open(std::span<const std::byte> bytes, std::string name) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    zip_t* archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
    const int code = zip_error_code_zip(&error);
    zip_error_fini(&error);
    if (archive == nullptr) {
        if (source != nullptr) zip_source_free(source);
        return unexpected(msg::kNoArchive, name, wordsFor(code));
    }
    ZipArchive result(std::unique_ptr<zip, Close>(archive), std::move(name));
    if (auto listed = result.list(); !listed) return Unexpected{listed.error()};
    return result;
}

Expected<void> ZipArchive::list() {
    const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
    if (count < 0 || static_cast<std::size_t>(count) > kCaseLimits.entries) {
        return unexpected(msg::kArchiveTooManyFiles, name_, count, kCaseLimits.entries);
    }
    std::uint64_t all = 0;
    for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
        zip_stat_t stat;
        if (zip_stat_index(archive_.get(), i, ZIP_FL_ENC_GUESS, &stat) != 0 || stat.name == nullptr) {
            return unexpected(msg::kArchiveListDamaged, name_);
        }
        const std::string entry = stat.name;
        if (!entry.empty() && (entry.back() == '/' || entry.back() == '\\')) continue;  // a folder
        if (auto claims = checkClaims(stat, name_ + ": " + displayName(entry)); !claims) return claims;
        all += stat.size;
        entries_.push_back({entry, i, stat.size, stat.comp_size, isLink(archive_.get(), i)});
    }
    if (all > kCaseLimits.allBytes) {
        return unexpected(msg::kArchiveTooLarge, name_, all, kCaseLimits.allBytes);
    }
    return {};
}

Expected<std::vector<std::byte>> ZipArchive::read(const std::string& entry) const {
    const auto found = std::ranges::find(entries_, entry, &ZipEntry::name);
    const std::string shown = name_ + ": " + displayName(entry);
    if (found == entries_.end()) return unexpected(msg::kArchiveFileMissing, shown);
    const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen_index(archive_.get(), found->index, 0));
    if (file == nullptr) return unexpected(msg::kArchiveFileDamaged, shown);
    // Grows with the bytes that really come, and never beyond the claimed size.
    constexpr std::size_t kPiece = std::size_t{1} << 20;
    std::vector<std::byte> bytes;
    while (bytes.size() < found->size) {
        const std::size_t before = bytes.size();
        bytes.resize(std::min<std::uint64_t>(found->size, before + kPiece));
        const zip_int64_t count = zip_fread(file.get(), bytes.data() + before, bytes.size() - before);
        if (count <= 0) return unexpected(msg::kArchiveFileDamaged, shown);
        bytes.resize(before + static_cast<std::size_t>(count));
    }
    std::byte more{};
    if (zip_fread(file.get(), &more, 1) != 0) {  // also checks the checksum
        return unexpected(msg::kArchiveFileDiffers, shown);
    }
    return bytes;
}

Expected<std::vector<std::byte>> packCase(std::vector<CaseFile> files) {
    const auto failed = [] { return unexpected(msg::kArchiveNoMemory); };
    std::ranges::sort(files, {}, &CaseFile::entry);
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_t* archive = target == nullptr ? nullptr : zip_open_from_source(target, ZIP_TRUNCATE, &error);
    zip_error_fini(&error);
    if (archive == nullptr) {
        zip_source_free(target);
        return failed();
    }
    zip_source_keep(target);
    bool isDone = true;
    for (const CaseFile& file : files) {
        zip_source_t* content = zip_source_buffer(archive, file.bytes.data(), file.bytes.size(), 0);
        const zip_int64_t index =
            content == nullptr ? -1 : zip_file_add(archive, file.entry.c_str(), content, ZIP_FL_ENC_UTF_8);
        if (index < 0) {
            isDone = false;
            break;
        }
        // One date for all, 1980-01-01, the first of the format, so that equal files give equal bytes.
        isDone = isDone && zip_file_set_dostime(archive, static_cast<zip_uint64_t>(index), 0, 0x21, 0) == 0;
    }
    if (!isDone || zip_close(archive) != 0) {
        zip_discard(archive);
        zip_source_free(target);
        return failed();
    }
    zip_stat_t stat;
    std::vector<std::byte> bytes;
    if (zip_source_stat(target, &stat) == 0 && zip_source_open(target) == 0) {
        bytes.resize(stat.size);
        const zip_int64_t count = zip_source_read(target, bytes.data(), bytes.size());
        if (count < 0 || static_cast<std::size_t>(count) != bytes.size()) bytes.clear();
        zip_source_close(target);
    }
    zip_source_free(target);
    if (bytes.empty()) return failed();
    return bytes;
}

}  // namespace tactooth
