// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geometry/util/expected.h"

struct zip;

namespace tactooth {

struct ZipEntry {
    std::string name;
    std::uint64_t index;
    std::uint64_t size;    ///< bytes, as the archive claims
    std::uint64_t packed;  ///< bytes in the archive
    bool isLink = false;   ///< symbolic: its content is the name of another file
};

/// An untrusted zip archive in memory (libzip). It reads only stored and deflated entries without a password, and
/// checks the claims of an entry against the limits of a case before it unpacks.
class ZipArchive {
public:
    /// `bytes` must outlive the archive.
    [[nodiscard]] static Expected<ZipArchive> open(std::span<const std::byte> bytes, std::string name);

    /// All entries but folders, in the order of the archive.
    [[nodiscard]] const std::vector<ZipEntry>& entries() const { return entries_; }
    [[nodiscard]] Expected<std::vector<std::byte>> read(const std::string& entry) const;

private:
    struct Close {
        void operator()(zip* archive) const;
    };
    ZipArchive(std::unique_ptr<zip, Close> archive, std::string name)
        : archive_(std::move(archive)), name_(std::move(name)) {}
    [[nodiscard]] Expected<void> list();

    std::unique_ptr<zip, Close> archive_;
    std::string name_;
    std::vector<ZipEntry> entries_;
};

}  // namespace tactooth
