// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/case_store.h"

#include <algorithm>
#include <optional>

#include "geometry/files/file_bytes.h"
#include "geometry/util/messages.h"
#include "geometry/util/system_reason.h"
#include "session/cases/messages.h"
#include "session/cases/zip_archive.h"
#include "session/io/messages.h"
#include "session/io/unicode_text.h"

namespace tactooth {

namespace fs = std::filesystem;

namespace {

Unexpected tooMuch(const std::string& what, std::uint64_t size, std::uint64_t most) {
    return unexpected(msg::kCaseClaimsTooMuch, what, size, most);
}

/// A file of a case.
struct StoredFile {
    std::string name;   ///< by entryName()
    std::string place;  ///< in the folder or archive
    bool isSystem;
};

bool isBefore(const StoredFile& a, const StoredFile& b) {
    return a.name < b.name || (a.name == b.name && a.place < b.place);
}

/// Files of a folder and its subfolders, without hidden folders (a version control may keep thousands of files there).
/// Follows only links that stay inside.
Expected<std::vector<StoredFile>> filesBelow(const fs::path& folder) {
    std::vector<StoredFile> files;
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        if (isSystemFile(at->path().filename().string())) at.disable_recursion_pending();
        if (!at->is_regular_file(error)) continue;
        const std::string place = at->path().lexically_relative(folder).generic_string();
        const EntryName entry = entryName(place);
        files.push_back({entry.fault == EntryFault::None ? entry.name : place, place, isSystemEntry(place)});
        if (files.size() > kCaseLimits.entries) {
            return unexpected(msg::kCaseFolderTooFull, displayName(folder), kCaseLimits.entries);
        }
    }
    if (error) return unexpected(msg::kFolderNotRead, displayName(folder), systemReason(error));
    std::ranges::sort(files, isBefore);
    return files;
}

/// A name in an archive for a message: one line of bounded length.
std::string shownEntry(std::string_view name) {
    constexpr std::size_t kMax = 100;  // bytes
    if (name.size() <= kMax) return displayName(fs::path(validUtf8(name)));
    return displayName(fs::path(validUtf8(name.substr(0, kMax)))) + "...";
}

Expected<std::vector<StoredFile>> filesOf(const ZipArchive& archive, const std::string& shown) {
    std::vector<StoredFile> files;
    for (const ZipEntry& entry : archive.entries()) {
        const std::string file = shownEntry(entry.name);
        const EntryName read = entryName(entry.name);
        if (entry.isLink || read.fault == EntryFault::PathTraversal)
            return unexpected(msg::kArchivePointsOut, shown, file);
        std::string slashes = entry.name;
        std::ranges::replace(slashes, '\\', '/');
        const bool isSystem = isSystemEntry(slashes);
        if (isSystem && read.fault != EntryFault::None) continue;
        if (read.fault == EntryFault::ControlCharacter) return unexpected(msg::kArchiveControlCharacters, shown, file);
        if (read.fault == EntryFault::TooLong) return unexpected(msg::kArchiveNameTooLong, shown, file);
        if (read.fault != EntryFault::None) continue;  // a folder, or nothing
        files.push_back({read.name, entry.name, isSystem});
    }
    std::ranges::sort(files, isBefore);
    const auto twice = std::ranges::adjacent_find(files, {}, &StoredFile::name);
    if (twice != files.end() && !twice->isSystem) return unexpected(msg::kArchiveNameTwice, shown);
    return files;
}

/// The folder of the case within an archive, with '/'; empty if case.toml lies at the top.
Expected<std::string> topFolder(const std::vector<StoredFile>& files, const std::string& shown) {
    std::vector<std::string> tops;
    for (const StoredFile& file : files) {
        const std::size_t slash = file.name.rfind('/') + 1;  // npos + 1 = 0
        if (file.isSystem || file.name.substr(slash) != kCaseText) continue;
        const auto depth = [](const std::string& folder) { return std::ranges::count(folder, '/'); };
        const std::string top = file.name.substr(0, slash);
        if (!tops.empty() && depth(top) < depth(tops.front())) tops.clear();
        if (tops.empty() || depth(top) == depth(tops.front())) tops.push_back(top);
    }
    if (tops.size() > 1) return unexpected(msg::kArchiveOfSeveral, shown, shownEntry(tops[0]), shownEntry(tops[1]));
    return tops.empty() ? std::string() : tops.front();
}

}  // namespace

bool isWithinFolder(const fs::path& folder, const std::string& entry) {
    std::error_code error;
    const fs::path home = fs::canonical(folder.empty() ? "." : folder, error);
    const fs::path place = fs::weakly_canonical(folder / entry, error);
    if (error) return false;
    const fs::path whole = fs::absolute(place, error);
    return std::mismatch(home.begin(), home.end(), whole.begin(), whole.end()).first == home.end();
}

struct CaseStore::Content {
    std::string name;
    fs::path folder;                    // of a case that is no archive
    std::optional<FileBytes> bytes;     // of an archive from the disk
    std::optional<ZipArchive> archive;  // after the bytes that it reads
    std::vector<StoredFile> files;      // sorted
    std::vector<std::string> entries;   // without system files

    void take(std::vector<StoredFile> found) {
        files = std::move(found);
        for (const StoredFile& file : files) {
            if (!file.isSystem) entries.push_back(file.name);
        }
    }
};

CaseStore::CaseStore(std::unique_ptr<Content> content) : content_(std::move(content)) {}
CaseStore::CaseStore(CaseStore&&) noexcept = default;
CaseStore& CaseStore::operator=(CaseStore&&) noexcept = default;
CaseStore::~CaseStore() = default;

const std::vector<std::string>& CaseStore::entries() const { return content_->entries; }

std::string CaseStore::shown(const std::string& entry) const { return content_->name + ": " + displayName(entry); }

Expected<CaseStore> CaseStore::open(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error) || path.filename() == kCaseText) {
        auto content = std::make_unique<Content>();
        content->folder = fs::is_directory(path, error) ? path : path.parent_path();
        if (content->folder.empty()) content->folder = ".";
        content->name = displayName(content->folder);
        auto files = filesBelow(content->folder);
        if (!files) return Unexpected{files.error()};
        content->take(std::move(*files));
        return CaseStore(std::move(content));
    }
    const std::uintmax_t size = fs::file_size(path, error);
    if (!error && size > kCaseLimits.allBytes) return tooMuch(displayName(path), size, kCaseLimits.allBytes);
    auto bytes = readFile(path);
    if (!bytes) return Unexpected{bytes.error()};
    auto store = openArchive(bytes->bytes(), displayName(path));
    if (store) store->content_->bytes.emplace(std::move(*bytes));
    return store;
}

Expected<CaseStore> CaseStore::openArchive(std::span<const std::byte> bytes, std::string name) {
    auto archive = ZipArchive::open(bytes, name);
    if (!archive) return Unexpected{archive.error()};
    auto content = std::make_unique<Content>();
    content->name = std::move(name);
    auto files = filesOf(*archive, content->name);
    if (!files) return Unexpected{files.error()};
    const auto top = topFolder(*files, content->name);
    if (!top) return Unexpected{top.error()};
    std::erase_if(*files, [&](const StoredFile& file) { return !file.name.starts_with(*top); });
    for (StoredFile& file : *files) file.name.erase(0, top->size());
    content->take(std::move(*files));
    content->archive.emplace(std::move(*archive));
    return CaseStore(std::move(content));
}

Expected<std::vector<std::byte>> CaseStore::read(const std::string& entry) const {
    const EntryName wanted = entryName(entry);
    if (wanted.fault != EntryFault::None)
        return unexpected(msg::kSentence, inWords(wanted.fault, content_->name + ": '" + shownEntry(entry) + "'"));
    // Two file names may differ only in composition (NFC); the exact name comes first.
    const auto first = std::ranges::lower_bound(content_->files, wanted.name, {}, &StoredFile::name);
    const auto last = std::ranges::upper_bound(content_->files, wanted.name, {}, &StoredFile::name);
    if (first == last) return unexpected(msg::kCaseFileMissing, shown(entry));
    const auto exact = std::find_if(first, last, [&](const StoredFile& each) { return each.place == entry; });
    const std::string& place = (exact == last ? first : exact)->place;
    if (content_->archive) return content_->archive->read(place);
    const fs::path file = content_->folder / fs::path(place);
    if (!isWithinFolder(content_->folder, place)) {
        return unexpected(msg::kCaseLinkLeadsOut, shown(entry));
    }
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error && size > kCaseLimits.entryBytes) {
        return tooMuch(shown(entry), size, kCaseLimits.entryBytes);
    }
    const auto bytes = readFile(file);
    if (!bytes) return Unexpected{bytes.error()};
    return std::vector<std::byte>(bytes->bytes().begin(), bytes->bytes().end());
}

bool isCase(const fs::path& path) {
    std::error_code error;
    return path.extension() == kCaseEnding || path.filename() == kCaseText ||
           (fs::is_directory(path, error) && fs::exists(path / kCaseText, error));
}

}  // namespace tactooth
