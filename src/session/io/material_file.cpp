// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/material_file.h"

#include <algorithm>
#include <array>

#include "geometry/files/file_bytes.h"
#include "geometry/util/number_text.h"
#include "session/io/limited_toml.h"
#include "session/io/material_table.h"
#include "session/io/messages.h"
#include "session/io/toml_reader.h"

namespace tactooth {
namespace {

constexpr std::array<std::string_view, 5> kDefiningKeys = {"title_en", "title_ja", "role", "nesting", "code"};

std::string keyNames() {
    std::string names(kMaterialColourKey);
    for (const MaterialNumberKey& key : materialNumberKeys()) names.append(", ").append(key.name);
    for (const std::string_view key : kDefiningKeys) names.append(", ").append(key);
    return names;
}

/// Reads a file into the definitions of materials, up to the first mistake.
class MaterialReader {
public:
    MaterialReader(TomlReader& toml, const MaterialRegistry& start)
        : toml_(toml), start_(start), all_(start.definitions()) {}

    const MaterialRegistry& read(const toml::table& root) {
        for (auto&& [key, node] : root) blocks_.push_back({&key, &node});
        // Menus list new materials in the order of the file; toml::table is sorted by name.
        std::ranges::stable_sort(blocks_, {}, [](const Block& block) { return block.key->source().begin.line; });
        for (const Block& block : blocks_) {
            if (!toml_.error()) readBlock(*block.key, *block.node);
        }
        return toml_.error() ? start_ : MaterialRegistry::make(std::move(all_));
    }

private:
    void readBlock(const toml::key& name, const toml::node& node) {
        const toml::table* entries = node.as_table();
        if (entries == nullptr) {
            return toml_.fail(node, {msg::kMaterialNotTable, name.str(), name.str(), describedToml(node)});
        }
        auto material = std::ranges::find(all_, name.str(), &MaterialDefinition::name);
        if (material == all_.end()) {
            if (!add(name, *entries)) return;
            material = std::prev(all_.end());  // the list has grown: positions of before are no longer valid
        }
        for (auto&& [key, value] : *entries) readKey(*material, key, value);
    }

    /// Adds a material with the numbers of the surroundings; its block then changes them.
    bool add(const toml::key& name, const toml::table& entries) {
        if (!isMaterialName(name.str())) {
            toml_.fail(name, {msg::kMaterialNameRefused, quotedWord(name.str())});
            return false;
        }
        if (all_.size() == kMaxMaterials) {
            toml_.fail(name, {msg::kTooManyMaterials, kMaxMaterials});
            return false;
        }
        MaterialDefinition added = start_[start_.withRole(MaterialRole::Surroundings)];
        added.name = added.titleEn = added.titleJa = name.str();
        added.role = MaterialRole::None;
        if (entries.get("code") == nullptr) added.code = freeCode();
        all_.push_back(std::move(added));
        return true;
    }

    /// A code that no block of the file gives.
    std::uint8_t freeCode() {
        std::vector<MaterialDefinition> taken = all_;
        for (const Block& block : blocks_) {
            const toml::table* entries = block.node->as_table();
            if (const auto code = entries != nullptr ? (*entries)["code"].value<int>() : std::nullopt) {
                taken.emplace_back().code = static_cast<std::uint8_t>(std::clamp(*code, 0, kMaxMaterialCode));
            }
        }
        return MaterialRegistry::freeCode(taken).value_or(kMaxMaterialCode);
    }

    void readKey(MaterialDefinition& material, const toml::key& key, const toml::node& node) {
        if (key.str() == kMaterialColourKey) return readColour(material.numbers, node);
        const auto keys = materialNumberKeys();
        const auto number = std::ranges::find(keys, key.str(), &MaterialNumberKey::name);
        if (number != keys.end()) {
            const auto value = toml_.numberOf(node, number->name, 0, number->highest);
            return value ? number->set(material.numbers, *value) : void();
        }
        if (std::ranges::find(kDefiningKeys, key.str()) == kDefiningKeys.end()) {
            return toml_.fail(key, {msg::kUnknownKey, msg::kAMaterial, quotedWord(key.str()), keyNames()});
        }
        const MaterialDefinition before = material;
        readDefiningKey(material, key.str(), node);
        const bool isNew = !start_.find(material.name);
        const bool isSame =
            material.role == before.role && material.nesting == before.nesting && material.code == before.code;
        if (!isNew && !isSame) {
            toml_.fail(key, {msg::kKeyOfNewMaterial, quotedWord(key.str()), material.name});
        }
    }

    void readDefiningKey(MaterialDefinition& material, std::string_view key, const toml::node& node) {
        if (key == "title_en") material.titleEn = toml_.textOf(node, key).value_or("");
        if (key == "title_ja") material.titleJa = toml_.textOf(node, key).value_or("");
        if (key == "nesting") material.nesting = toml_.integerOf(node, key, 0, kMaxMaterialNesting).value_or(0);
        if (key == "code") readCode(material, node);
        if (key != "role") return;
        const auto role = materialRoleNamed(toml_.textOf(node, key).value_or(""));
        if (!role) return toml_.fail(node, {msg::kMaterialRole, materialRoleNames()});
        material.role = *role;
    }

    void readCode(MaterialDefinition& material, const toml::node& node) {
        material.code = static_cast<std::uint8_t>(toml_.integerOf(node, "code", 0, kMaxMaterialCode).value_or(0));
        for (const MaterialDefinition& other : all_) {
            if (&other == &material || other.code != material.code) continue;
            toml_.fail(node, {msg::kMaterialCodeTaken, material.code, other.name});
        }
    }

    void readColour(Material& material, const toml::node& node) {
        const toml::array* parts = node.as_array();
        if (parts == nullptr || parts->size() != material.colour.size()) {
            const Message found =
                parts != nullptr ? Message(msg::kListOf, parts->size()) : Message(describedToml(node));
            return toml_.fail(node, {msg::kColourNotThree, found});
        }
        for (std::size_t i = 0; i < material.colour.size(); ++i) {
            const auto value = toml_.numberOf(*parts->get(i), kMaterialColourKey, 0, 1);
            if (value) material.colour[i] = static_cast<float>(*value);
        }
    }

    struct Block {
        const toml::key* key;
        const toml::node* node;
    };

    TomlReader& toml_;
    const MaterialRegistry& start_;
    std::vector<MaterialDefinition> all_;
    std::vector<Block> blocks_;
};

}  // namespace

const MaterialRegistry& materialsIn(TomlReader& toml, const toml::table& blocks, const MaterialRegistry& start) {
    return MaterialReader(toml, start).read(blocks);
}

Expected<const MaterialRegistry*> parseMaterials(std::string_view text, std::string_view name,
                                                 const MaterialRegistry& start) {
    TomlReader toml(name);
    const toml::table root = toml.parse(text);
    const MaterialRegistry& materials = materialsIn(toml, root, start);
    if (toml.error()) return Unexpected{*toml.error()};
    return &materials;
}

const MaterialRegistry& dentalMaterials() {
    static const MaterialRegistry& all = *parseMaterials(dentalMaterialsText(), "data/dental_materials.toml").value();
    return all;
}

const MaterialRegistry& withDentalMaterials(const MaterialRegistry& materials) {
    std::vector<MaterialDefinition> all = materials.definitions();
    for (MaterialDefinition& added : dentalMaterials().definitions()) {
        if (materials.find(added.name)) continue;
        const std::optional<std::uint8_t> code = MaterialRegistry::freeCode(all);
        if (all.size() == kMaxMaterials || !code) break;
        added.code = *code;
        all.push_back(std::move(added));
    }
    return MaterialRegistry::make(std::move(all));
}

Expected<const MaterialRegistry*> readMaterials(const std::filesystem::path& path) {
    const Expected<FileBytes> file = readFile(path, kTomlLimits.bytes);
    if (!file) return Unexpected{file.error()};
    return parseMaterials(file->text(), displayName(path));
}

Expected<const MaterialRegistry*> materialsFrom(const std::filesystem::path& fileOrNothing) {
    return fileOrNothing.empty() ? Expected<const MaterialRegistry*>(&builtinMaterials())
                                 : readMaterials(fileOrNothing);
}

}  // namespace tactooth
