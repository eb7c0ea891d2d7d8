// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/tooth_cache.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/byte_stream.h"
#include "instruments/tooth_making.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kToothMagic = 0x3448544F4F544354;  // "TCTOOTH4"
constexpr std::uint64_t kMouthMagic = 0x314854554F4D4354;  // "TCMOUTH1"
constexpr std::array kExtensions = {".tooth", ".mouth"};

void put(const TriangleMesh& mesh, ByteWriter& content) {
    content.put(static_cast<std::uint64_t>(mesh.vertices.size()));
    content.put(static_cast<std::uint64_t>(mesh.triangles.size()));
    content.putAll(std::span<const Vec3f>(mesh.vertices));
    content.putAll(std::span<const Triangle>(mesh.triangles));
}

/// Nothing if the bytes hold no valid mesh.
std::optional<TriangleMesh> meshFrom(ByteReader& file) {
    TriangleMesh mesh;
    const auto vertices = file.get<std::uint64_t>(), triangles = file.get<std::uint64_t>();
    for (const auto& [x, y, z] : file.getAll<std::array<float, 3>>(vertices)) mesh.vertices.emplace_back(x, y, z);
    mesh.triangles = file.getAll<Triangle>(triangles);
    const bool isSound = std::ranges::all_of(mesh.triangles, [&](const Triangle& triangle) {
        return std::ranges::all_of(triangle, [&](std::uint32_t vertex) { return vertex < mesh.vertices.size(); });
    });
    if (!file.ok() || !isSound) return std::nullopt;
    return mesh;
}

/// Writes magic number, checksum of the content, content.
std::vector<std::byte> sealed(std::uint64_t magic, const ByteWriter& content) {
    ByteWriter file;
    file.put(magic);
    file.put(checksum(content.bytes()));
    file.putAll(content.bytes());
    return file.take();
}

/// Checks bytes that `sealed` wrote; if they are unchanged, `file` stands at the content.
bool isUnbroken(std::uint64_t magic, std::span<const std::byte> bytes, ByteReader& file) {
    if (file.get<std::uint64_t>() != magic) return false;
    const auto sum = file.get<std::uint64_t>();
    return file.ok() && sum == checksum(bytes.subspan(file.at()));
}

/// FDI number, layers. What a filling and a rim are made of is no part of it.
std::vector<std::byte> bytesOf(const BuiltinTooth& tooth) {
    ByteWriter content;
    content.put(tooth.fdi);
    for (const TriangleMesh* mesh : meshesOf(tooth)) put(*mesh, content);
    return sealed(kToothMagic, content);
}

/// Reads the bytes of `bytesOf`; nothing if they are damaged.
std::optional<BuiltinTooth> toothFrom(std::span<const std::byte> bytes) {
    ByteReader file(bytes);
    if (!isUnbroken(kToothMagic, bytes, file)) return std::nullopt;
    BuiltinTooth tooth;
    tooth.fdi = file.get<int>();
    for (TriangleMesh* layer : meshesOf(tooth)) {
        auto mesh = meshFrom(file);
        if (!mesh) return std::nullopt;
        *layer = std::move(*mesh);
    }
    if (!file.ok() || file.left() != 0 || !isPermanentTooth(tooth.fdi)) return std::nullopt;
    tooth.name = toothName(tooth.fdi);
    return tooth;
}

/// Poses of the teeth, upper gum, lower gum, both as they are drawn.
std::vector<std::byte> bytesOf(const MouthLayout& setting) {
    ByteWriter content;
    for (const Pose& pose : setting.toothInMouth) {
        const auto& [position, rotation] = pose;
        content.putAll(std::span<const double>(position.data(), 3));
        content.putAll(std::span<const double>(rotation.coeffs().data(), 4));
    }
    put(setting.upperGingiva, content);
    put(setting.lowerGingiva, content);
    for (const ZonedMesh* shown : {&setting.upperShown, &setting.lowerShown}) {
        put(shown->mesh, content);
        content.putAll(std::span<const std::uint8_t>(shown->zones));
    }
    return sealed(kMouthMagic, content);
}

std::optional<MouthLayout> layoutFrom(std::span<const std::byte> bytes) {
    ByteReader file(bytes);
    if (!isUnbroken(kMouthMagic, bytes, file)) return std::nullopt;
    MouthLayout setting;
    for (Pose& pose : setting.toothInMouth) {
        for (double& number : pose.position) number = file.get<double>();
        for (double& number : pose.rotation.coeffs()) number = file.get<double>();
    }
    auto upper = meshFrom(file), lower = meshFrom(file);
    if (!upper || !lower) return std::nullopt;
    for (ZonedMesh* shown : {&setting.upperShown, &setting.lowerShown}) {
        auto mesh = meshFrom(file);
        if (!mesh) return std::nullopt;
        shown->mesh = std::move(*mesh);
        shown->zones = file.getAll<std::uint8_t>(shown->mesh.vertices.size());
    }
    if (!file.ok() || file.left() != 0) return std::nullopt;
    setting.upperGingiva = std::move(*upper);
    setting.lowerGingiva = std::move(*lower);
    return setting;
}

/// The content of `file`, decoded by `from`.
template <class From>
auto kept(const fs::path& file, const From& from) -> decltype(from({})) {
    std::error_code none;
    if (!fs::exists(file, none)) return std::nullopt;
    const auto bytes = readFile(file);
    if (!bytes) return std::nullopt;
    auto found = from(bytes->bytes());
    if (found) fs::last_write_time(file, fs::file_time_type::clock::now(), none);  // it was used just now
    return found;
}

}  // namespace

ToothCache::ToothCache(fs::path folder, std::uintmax_t limit) : folder_(std::move(folder)), limit_(limit) {}

fs::path ToothCache::fileOf(const ToothRequest& request) const {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "%02d-%016llx", request.fdi,
                  static_cast<unsigned long long>(toothFingerprint(request)));
    return folder_ / (std::string(name.data()) + kExtensions[0]);
}

fs::path ToothCache::fileOf(const MouthRequest& request) const {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "%016llx",
                  static_cast<unsigned long long>(mouthLayoutFingerprint(request)));
    return folder_ / (std::string(name.data()) + kExtensions[1]);
}

BuiltinTooth ToothCache::make(const ToothRequest& request, const std::function<void(double)>& progress) const {
    if (folder_.empty()) return makeToothReporting(request, progress);
    const fs::path file = fileOf(request);
    if (auto tooth = kept(file, toothFrom); tooth && tooth->fdi == request.fdi) {
        takeMaterials(*tooth, request);
        return std::move(*tooth);
    }
    BuiltinTooth tooth = makeToothReporting(request, progress);
    store(bytesOf(tooth), file);
    return tooth;
}

Expected<BuiltinMouth> ToothCache::makeMouth(const MouthRequest& request,
                                             const std::function<void(double)>& partDone) const {
    constexpr int kLayoutParts = 8;  // the gums take as long as some teeth
    constexpr int kParts = static_cast<int>(MouthLayout::kPlaces) + kLayoutParts;
    std::atomic<int> parts = 0;
    const auto count = [&](int more) {
        const int done = parts += more;
        if (partDone) partDone(static_cast<double>(done) / kParts);
    };
    const auto tooth = [&](const ToothRequest& one) {
        BuiltinTooth made = make(one);
        count(1);
        return made;
    };
    const auto layout = [&](const MouthRequest& mouth) {
        Expected<MouthLayout> made = makeLayout(mouth);
        count(kLayoutParts);
        return made;
    };
    return tactooth::makeMouth(request, tooth, layout);
}

Expected<MouthLayout> ToothCache::makeLayout(const MouthRequest& request) const {
    if (folder_.empty()) return makeMouthLayout(request);
    const fs::path file = fileOf(request);
    if (auto setting = kept(file, layoutFrom)) return std::move(*setting);
    Expected<MouthLayout> setting = makeMouthLayout(request);
    if (setting) store(bytesOf(*setting), file);
    return setting;
}

/// Writes a file; a cache that cannot be written is no error.
void ToothCache::store(std::span<const std::byte> bytes, const fs::path& file) const {
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
        const fs::path extension = entry.path().extension();
        if (std::ranges::none_of(kExtensions, [&](const char* own) { return extension == own; })) continue;
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

fs::path defaultCacheFolder() {
    const auto folder = [](const char* name) {
        const char* value = std::getenv(name);
        return fs::path(value != nullptr ? value : "");
    };
    // The XDG specification says to ignore a relative path.
    if (const fs::path own = folder("XDG_CACHE_HOME"); own.is_absolute()) return own / "tactooth";
    if (const fs::path home = folder("HOME"); home.is_absolute()) return home / ".cache" / "tactooth";
    return {};
}

}  // namespace tactooth
