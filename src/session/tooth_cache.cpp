// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/tooth_cache.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

#include "geometry/atomic_file.h"
#include "geometry/file_bytes.h"
#include "tooth/byte_stream.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMagic = 0x3148544F4F544354;  // "TCTOOTH1"
constexpr const char* kExtension = ".tooth";

template <class Tooth>
auto layersIn(Tooth& tooth) {
    return std::array{&tooth.outer, &tooth.enamel, &tooth.dentin, &tooth.pulp, &tooth.caries};
}

/// Magic, checksum of the rest, number of the tooth, its layers.
std::vector<std::byte> bytesOf(const BuiltinTooth& tooth) {
    ByteWriter content;
    content.put(tooth.fdi);
    for (const TriangleMesh* mesh : layersIn(tooth)) {
        content.put(static_cast<std::uint64_t>(mesh->vertices.size()));
        content.put(static_cast<std::uint64_t>(mesh->triangles.size()));
        content.putAll(std::span<const Vec3f>(mesh->vertices));
        content.putAll(std::span<const Triangle>(mesh->triangles));
    }
    ByteWriter file;
    file.put(kMagic);
    file.put(checksum(content.bytes()));
    file.putAll(content.bytes());
    return file.take();
}

bool isSound(const TriangleMesh& mesh) {
    return std::ranges::all_of(mesh.triangles, [&](const Triangle& triangle) {
        return std::ranges::all_of(triangle, [&](std::uint32_t vertex) { return vertex < mesh.vertices.size(); });
    });
}

/// Nothing if the bytes are not, whole and unchanged, what `bytesOf` wrote.
std::optional<BuiltinTooth> toothFrom(std::span<const std::byte> bytes) {
    ByteReader file(bytes);
    if (file.get<std::uint64_t>() != kMagic) return std::nullopt;
    const auto sum = file.get<std::uint64_t>();
    if (!file.ok() || sum != checksum(bytes.subspan(file.at()))) return std::nullopt;
    BuiltinTooth tooth;
    tooth.fdi = file.get<int>();
    for (TriangleMesh* mesh : layersIn(tooth)) {
        const auto vertices = file.get<std::uint64_t>(), triangles = file.get<std::uint64_t>();
        for (const auto& [x, y, z] : file.getAll<std::array<float, 3>>(vertices)) mesh->vertices.emplace_back(x, y, z);
        mesh->triangles = file.getAll<Triangle>(triangles);
        if (!isSound(*mesh)) return std::nullopt;
    }
    if (!file.ok() || file.left() != 0 || !isPermanentTooth(tooth.fdi)) return std::nullopt;
    tooth.name = toothName(tooth.fdi);
    return tooth;
}

}  // namespace

ToothCache::ToothCache(fs::path folder, std::uintmax_t limit) : folder_(std::move(folder)), limit_(limit) {}

fs::path ToothCache::fileOf(const ToothRequest& request) const {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "%02d-%016llx", request.fdi,
                  static_cast<unsigned long long>(toothFingerprint(request)));
    return folder_ / (std::string(name.data()) + kExtension);
}

BuiltinTooth ToothCache::make(const ToothRequest& request) const {
    if (folder_.empty()) return makeTooth(request);
    const fs::path file = fileOf(request);
    std::error_code none;
    if (fs::exists(file, none)) {
        const auto bytes = readFile(file);
        auto tooth = bytes ? toothFrom(bytes->bytes()) : std::nullopt;
        if (tooth && tooth->fdi == request.fdi) {
            fs::last_write_time(file, fs::file_time_type::clock::now(), none);  // it was asked for just now
            return std::move(*tooth);
        }
    }
    BuiltinTooth tooth = makeTooth(request);
    keep(tooth, file);
    return tooth;
}

/// A cache that cannot be written is none: no reason to fail.
void ToothCache::keep(const BuiltinTooth& tooth, const fs::path& file) const {
    const std::vector<std::byte> bytes = bytesOf(tooth);
    if (bytes.size() > limit_) return;
    std::error_code none;
    fs::create_directories(folder_, none);
    if (writeFile(file, bytes)) removeOldest();
}

void ToothCache::removeOldest() const {
    struct Kept {
        fs::file_time_type used;
        std::uintmax_t size;
        fs::path file;
    };
    std::vector<Kept> all;
    std::uintmax_t sum = 0;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, none)) {
        if (entry.path().extension() != kExtension) continue;
        std::error_code gone;  // another program may clean up at the same time
        const auto used = entry.last_write_time(gone);
        const auto size = entry.file_size(gone);
        if (gone) continue;
        all.push_back({used, size, entry.path()});
        sum += size;
    }
    std::ranges::sort(all, {}, &Kept::used);
    for (const Kept& kept : all) {
        if (sum <= limit_) return;
        if (fs::remove(kept.file, none)) sum -= kept.size;
    }
}

fs::path usualCacheFolder() {
    const auto folder = [](const char* name) {
        const char* value = std::getenv(name);
        return fs::path(value != nullptr ? value : "");
    };
    // A relative path there is no path, says the XDG specification.
    if (const fs::path own = folder("XDG_CACHE_HOME"); own.is_absolute()) return own / "tactooth";
    if (const fs::path home = folder("HOME"); home.is_absolute()) return home / ".cache" / "tactooth";
    return {};
}

}  // namespace tactooth
