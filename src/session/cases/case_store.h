// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/util/expected.h"
#include "session/cases/entry_name.h"

namespace tactooth {

/// Name of the file that describes a case, in its folder or archive.
inline constexpr std::string_view kCaseText = "case.toml";
/// Ending of an archive that holds a case.
inline constexpr std::string_view kCaseEnding = ".ttcase";

/// Limits of a case; more is refused before it is read. A mouth of 32 teeth with 325,000 triangles and three layers
/// each takes 1.6 GB.
struct CaseLimits {
    std::size_t entries = 1000;
    std::size_t entryBytes = std::size_t{1} << 30;
    std::size_t allBytes = std::size_t{2} << 30;
    double packed = 200;                           ///< bytes that may come out of one packed byte (surfaces: 2 to 10)
    std::size_t textBytes = std::size_t{1} << 20;  ///< of a TOML file
};
inline constexpr CaseLimits kCaseLimits = {};

/// Whether a file in `folder` is still below it when all links are followed. True for a missing file; reading it fails.
[[nodiscard]] bool isWithinFolder(const std::filesystem::path& folder, const std::string& entry);

/// The files of a case: a folder, or a zip archive, which is read in memory and never unpacked to the disk. It
/// never takes more memory than `kCaseLimits` allows, whatever the bytes claim. It skips system files (isSystemFile)
/// and the folder that some programs put above all files of an archive. Use it from one thread.
class CaseStore {
public:
    /// A folder or file on the disk. Fails with one sentence.
    [[nodiscard]] static Expected<CaseStore> open(const std::filesystem::path& path);
    /// An archive in memory, which must outlive the store; `name` stands for it in messages.
    [[nodiscard]] static Expected<CaseStore> openArchive(std::span<const std::byte> bytes, std::string name);

    CaseStore(CaseStore&&) noexcept;
    CaseStore& operator=(CaseStore&&) noexcept;
    ~CaseStore();

    /// The bytes of one file; see `entryName` for names. Fails with one sentence if the file is missing, unsafe, too
    /// large or damaged.
    [[nodiscard]] Expected<std::vector<std::byte>> read(const std::string& entry) const;
    /// The files, sorted by name, without system files.
    [[nodiscard]] const std::vector<std::string>& entries() const;
    /// An entry as a message shows it: "mouth.ttcase: teeth/36.stl".
    [[nodiscard]] std::string shown(const std::string& entry) const;

private:
    struct Content;
    explicit CaseStore(std::unique_ptr<Content> content);
    std::unique_ptr<Content> content_;
};

/// Packs files into a zip archive in memory. Equal files give equal bytes. Names must be safe entries.
struct CaseFile {
    std::string entry;
    std::vector<std::byte> bytes;
};
[[nodiscard]] Expected<std::vector<std::byte>> packCase(std::vector<CaseFile> files);

/// Whether a path names a case: an archive by its ending, a folder with case.toml, or case.toml itself.
[[nodiscard]] bool isCase(const std::filesystem::path& path);

}  // namespace tactooth
