// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/file_place.h"

#include <sys/stat.h>

#include <algorithm>
#include <system_error>

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the system itself follows

}  // namespace

fs::path linksFollowed(const fs::path& path) {
    fs::path place = path;
    std::error_code error;
    for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(place, error)); ++i) {
        const fs::path link = fs::read_symlink(place, error);
        if (error) break;
        place = place.parent_path() / link;  // an absolute link takes the whole place
    }
    return place;
}

FilePlace FilePlace::of(const fs::path& path) {
    FilePlace place;
    std::error_code error;
    const fs::path whole = fs::absolute(linksFollowed(path), error);  // what is not there stays relative otherwise
    place.way = fs::weakly_canonical(whole, error);
    if (error) place.way = whole.lexically_normal();
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return place;
    place.device = status.st_dev;
    place.number = status.st_ino;
    return place;
}

bool FilePlace::isInside(const FilePlace& folder) const {
    const auto [end, rest] = std::mismatch(folder.way.begin(), folder.way.end(), way.begin(), way.end());
    return end == folder.way.end() && rest != way.end();
}

}  // namespace tactooth
