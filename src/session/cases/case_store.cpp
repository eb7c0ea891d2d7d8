// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/case_store.h"

#include <algorithm>
#include <optional>

#include "geometry/file_bytes.h"
#include "session/cases/zip_archive.h"

namespace tactooth {

namespace fs = std::filesystem;

namespace {

std::string tooMuch(const std::string& what, std::uint64_t size, std::uint64_t most) {
    return what + " claims to hold " + std::to_string(size) + " bytes, more than the " + std::to_string(most) +
           " that a case may; it is damaged or not meant well.";
}

/// Entries of a folder and of all below it, with '/'; links are followed only where they stay inside.
Expected<std::vector<std::string>> filesBelow(const fs::path& folder) {
    std::vector<std::string> entries;
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        if (!at->is_regular_file(error)) continue;
        entries.push_back(at->path().lexically_relative(folder).generic_string());
        if (entries.size() > kCaseLimits.entries) {
            return unexpected(shownName(folder) + ": the folder holds more than " +
                              std::to_string(kCaseLimits.entries) + " files; give a case a folder of its own.");
        }
    }
    if (error) return unexpected(shownName(folder) + ": the folder cannot be read (" + error.message() + ").");
    std::ranges::sort(entries);
    return entries;
}

}  // namespace

bool isSafeEntry(std::string_view path) {
    constexpr std::size_t kLongest = 200;  // bytes: every system takes a path of that length
    if (path.empty() || path.size() > kLongest || path.front() == '/' || path.back() == '/') return false;
    for (const char letter : path) {
        if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f || letter == '\\' || letter == ':')
            return false;
    }
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        const std::string_view part = path.substr(begin, end - begin);
        if (part.empty() || part == "." || part == "..") return false;
        begin = end + 1;
    }
    return true;
}

bool staysBelow(const fs::path& folder, const std::string& entry) {
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
    std::string top;                    // folder of the archive that all of the case lies in, with '/'
    std::vector<std::string> entries;
};

CaseStore::CaseStore(std::unique_ptr<Content> content) : content_(std::move(content)) {}
CaseStore::CaseStore(CaseStore&&) noexcept = default;
CaseStore& CaseStore::operator=(CaseStore&&) noexcept = default;
CaseStore::~CaseStore() = default;

const std::vector<std::string>& CaseStore::entries() const { return content_->entries; }

std::string CaseStore::shown(const std::string& entry) const { return content_->name + ": " + shownName(entry); }

Expected<CaseStore> CaseStore::open(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error) || path.filename() == kCaseText) {
        auto content = std::make_unique<Content>();
        content->folder = fs::is_directory(path, error) ? path : path.parent_path();
        if (content->folder.empty()) content->folder = ".";
        content->name = shownName(content->folder);
        auto entries = filesBelow(content->folder);
        if (!entries) return Unexpected{entries.error()};
        content->entries = std::move(*entries);
        return CaseStore(std::move(content));
    }
    const std::uintmax_t size = fs::file_size(path, error);
    if (!error && size > kCaseLimits.allBytes) return unexpected(tooMuch(shownName(path), size, kCaseLimits.allBytes));
    auto bytes = readFile(path);
    if (!bytes) return Unexpected{bytes.error()};
    auto store = openArchive(bytes->bytes(), shownName(path));
    if (store) store->content_->bytes.emplace(std::move(*bytes));
    return store;
}

Expected<CaseStore> CaseStore::openArchive(std::span<const std::byte> bytes, std::string name) {
    auto archive = ZipArchive::open(bytes, name);
    if (!archive) return Unexpected{archive.error()};
    auto content = std::make_unique<Content>();
    content->name = std::move(name);
    for (const ZipEntry& entry : archive->entries()) {
        if (!isSafeEntry(entry.name)) {
            return unexpected(content->name + ": the archive holds a file named '" + shownName(entry.name) +
                              "', which points out of it; it is not meant well.");
        }
        content->entries.push_back(entry.name);
    }
    std::ranges::sort(content->entries);
    if (std::ranges::adjacent_find(content->entries) != content->entries.end()) {
        return unexpected(content->name + ": the archive holds two files of the same name; pack it anew.");
    }
    // An archive made of a folder has that folder before all names.
    if (!std::ranges::binary_search(content->entries, kCaseText) && !content->entries.empty()) {
        const std::string& first = content->entries.front();
        content->top = first.substr(0, first.find('/') + 1);
        std::erase_if(content->entries, [&](const std::string& entry) { return !entry.starts_with(content->top); });
        for (std::string& entry : content->entries) entry.erase(0, content->top.size());
    }
    content->archive.emplace(std::move(*archive));
    return CaseStore(std::move(content));
}

Expected<std::vector<std::byte>> CaseStore::read(const std::string& entry) const {
    if (!isSafeEntry(entry)) {
        return unexpected(content_->name + ": '" + shownName(entry) +
                          "' points out of the case; give paths inside its folder, with '/' and without '..'.");
    }
    if (!std::ranges::binary_search(content_->entries, entry)) {
        return unexpected(shown(entry) + ": there is no such file in the case.");
    }
    if (content_->archive) return content_->archive->read(content_->top + entry);
    const fs::path file = content_->folder / fs::path(entry);
    if (!staysBelow(content_->folder, entry)) {
        return unexpected(shown(entry) + ": the link leads out of the case's folder; put a copy there instead.");
    }
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error && size > kCaseLimits.entryBytes) {
        return unexpected(tooMuch(shown(entry), size, kCaseLimits.entryBytes));
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
