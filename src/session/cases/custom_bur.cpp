// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/custom_bur.h"

#include "geometry/files/file_bytes.h"
#include "geometry/io/import_note.h"
#include "geometry/io/mesh_bytes.h"
#include "geometry/io/mesh_file.h"
#include "geometry/util/messages.h"
#include "session/cases/case_description.h"
#include "session/cases/case_store.h"
#include "session/cases/messages.h"
#include "session/io/limited_toml.h"
#include "session/io/toml_reader.h"
#include "session/io/toml_text.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxFlutes = 60;         // finishing burs have 30
constexpr double kCoarsestGrit = 500;  // um: super-coarse diamonds have 180
constexpr double kMaxSharpness = 10;   // times a new bur

}  // namespace

Expected<CustomBur> parseCustomBur(std::string_view text, const std::string& name, const ReadSibling& readSibling,
                                   const std::string& surface) {
    TomlReader toml(name);
    const toml::table root = toml.parse(text);
    toml.allow(root, msg::kABur, {"name", "surface", "material", "flutes", "grit_um", "sharpness"});
    CustomBur bur;
    bur.name = toml.text(root, "name", false);
    std::string file = toml.text(root, "surface", surface.empty());
    if (file.empty()) file = surface;
    const std::string material = toml.text(root, "material", false);
    if (material == "diamond") {
        bur.material = BurMaterial::Diamond;
        bur.flutes = 0;
    } else if (!material.empty() && material != "carbide") {
        toml.fail(*root.get("material"), msg::kBurMaterialUnknown);
    }
    bur.flutes = toml.integer(root, "flutes", bur.flutes, 0, kMaxFlutes);
    bur.gritMicrometres = toml.number(root, "grit_um", 0, 0, kCoarsestGrit);
    bur.sharpness = toml.number(root, "sharpness", 1, 0, kMaxSharpness);
    if (!file.empty() && !isSafeEntry(file)) {
        toml.fail(root, msg::kBurSurfaceElsewhere);
    }
    if (toml.error()) return Unexpected{*toml.error()};
    if (bur.name.empty()) bur.name = displayName(fs::path(file).stem());
    const auto bytes = readSibling(file);
    if (!bytes) return Unexpected{bytes.error()};
    auto mesh = parseMesh(*bytes, file);
    if (!mesh) return unexpected(msg::kNamedSentence, name, mesh.error());
    bur.surface = std::move(*mesh);
    return bur;
}

std::string customBurText(const CustomBur& bur, const std::string& surface) {
    const bool isDiamond = bur.material == BurMaterial::Diamond;
    return "name = " + tomlText(bur.name) + "\nsurface = " + tomlText(surface) + "\nmaterial = \"" +
           (isDiamond ? "diamond" : "carbide") + "\"\nflutes = " + std::to_string(bur.flutes) +
           "\ngrit_um = " + rounded(bur.gritMicrometres, 1) + "\nsharpness = " + rounded(bur.sharpness, 3) + "\n";
}

Expected<CustomBur> readCustomBur(const fs::path& path, std::vector<ImportNote>* importNotes) {
    const ReadSibling readSibling = [&](const std::string& entry) -> Expected<std::vector<std::byte>> {
        const auto bytes = readFile(path.parent_path() / entry);
        if (!bytes) return Unexpected{bytes.error()};
        return std::vector<std::byte>(bytes->bytes().begin(), bytes->bytes().end());
    };
    const bool isDescription = path.extension() == ".toml";
    fs::path description = path;
    description.replace_extension(".toml");
    std::error_code unreadable;  // readFile reports a bad path
    if (!isDescription && !fs::exists(description, unreadable)) {
        auto mesh = loadMesh(path, importNotes);
        if (!mesh) return Unexpected{mesh.error()};
        CustomBur bur;
        bur.name = displayFileName(path);
        bur.surface = std::move(*mesh);
        return bur;
    }
    const auto text = readFile(description, kTomlLimits.bytes);
    if (!text) return Unexpected{text.error()};
    return parseCustomBur(text->text(), displayName(description), readSibling,
                          isDescription ? std::string() : path.filename().string());
}

}  // namespace tactooth
