// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/material_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/files/file_bytes.h"
#include "geometry/util/assert.h"
#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"
#include "session/io/limited_toml.h"
#include "session/io/messages.h"

namespace tactooth {
namespace {

constexpr double kMaxRemoval = 10;      // mm^3/(N*m): butter; pulp has 0.3
constexpr double kHighestCentre = 2e4;  // Hz: what an ear hears

struct NumberKey {
    std::string_view name;
    double highest;
    void (*set)(Material&, double);
};
constexpr std::array<NumberKey, 7> kNumberKeys = {{
    {"stiffness", kMaxMaterialStiffness, [](Material& m, double value) { m.stiffness = value; }},
    {"damping", kMaxMaterialDamping, [](Material& m, double value) { m.damping = value; }},
    {"friction", kMaxMaterialFriction, [](Material& m, double value) { m.friction = value; }},
    {"removal", kMaxRemoval, [](Material& m, double value) { m.removal = value; }},
    {"roughness", 1, [](Material& m, double value) { m.roughness = static_cast<float>(value); }},
    {"sound_centre", kHighestCentre, [](Material& m, double value) { m.soundCentre = value; }},
    {"sound_level", 1, [](Material& m, double value) { m.soundBrightness = value; }},
}};
constexpr std::string_view kColourKey = "colour";

std::string materialNames() {
    std::string names;
    for (std::size_t i = 0; i < kMaterialCount; ++i) {
        names.append(i == 0 ? "" : ", ").append(materialName(static_cast<MaterialId>(i)));
    }
    return names;
}

std::string keyNames() {
    std::string names(kColourKey);
    for (const NumberKey& key : kNumberKeys) names.append(", ").append(key.name);
    return names;
}

/// What a message says that it found.
Message described(const toml::node& node) {
    if (const auto* integer = node.as_integer()) return Message::verbatim(std::to_string(integer->get()));
    if (const auto* number = node.as_floating_point()) {
        if (!std::isfinite(number->get())) return msg::kNotFiniteNumber;
        return Message::verbatim(numberText(number->get()));
    }
    if (node.is_string()) return msg::kTextInQuotes;
    if (node.is_boolean()) return msg::kTrueOrFalse;
    if (node.is_array()) return msg::kAList;
    if (node.is_table()) return msg::kATable;
    return msg::kDateOrTime;
}

/// Takes over what a file says into a table of materials, until something is wrong.
class MaterialReader {
public:
    MaterialReader(std::string_view name, const MaterialTable& start) : name_(name), table_(start) {}

    Expected<MaterialTable> read(const toml::table& root) {
        for (auto&& [key, node] : root) {
            if (!readMaterial(key, node)) return Unexpected{error_};
        }
        return table_;
    }

private:
    bool readMaterial(const toml::key& name, const toml::node& node) {
        const std::optional<MaterialId> id = materialFromName(name.str());
        if (!id) {
            return fail(name.source(), {msg::kMaterialUnknown, quotedWord(name.str()), materialNames()});
        }
        const toml::table* entries = node.as_table();
        if (!entries) {
            return fail(node.source(), {msg::kMaterialNotTable, name.str(), name.str(), described(node)});
        }
        for (auto&& [key, value] : *entries) {
            if (!readKey(table_[*id], key, value)) return false;
        }
        return true;
    }

    bool readKey(Material& material, const toml::key& key, const toml::node& node) {
        if (key.str() == kColourKey) return readColour(material, node);
        const auto known = std::ranges::find(kNumberKeys, key.str(), &NumberKey::name);
        if (known == kNumberKeys.end()) {
            return fail(key.source(), {msg::kUnknownKey, msg::kAMaterial, quotedWord(key.str()), keyNames()});
        }
        double value = 0;
        if (!readNumber(node, known->name, known->highest, value)) return false;
        known->set(material, value);
        return true;
    }

    bool readColour(Material& material, const toml::node& node) {
        const toml::array* parts = node.as_array();
        if (!parts || parts->size() != material.colour.size()) {
            return fail(node.source(),
                        {msg::kColourNotThree, parts ? Message(msg::kListOf, parts->size()) : described(node)});
        }
        for (std::size_t i = 0; i < material.colour.size(); ++i) {
            double value = 0;
            if (!readNumber(*parts->get(i), kColourKey, 1, value)) return false;
            material.colour[i] = static_cast<float>(value);
        }
        return true;
    }

    bool readNumber(const toml::node& node, std::string_view key, double highest, double& value) {
        const std::optional<double> number = node.is_number() ? node.value<double>() : std::nullopt;
        if (!number || !std::isfinite(*number) || *number < 0 || *number > highest) {
            return fail(node.source(), {msg::kMaterialNumber, quotedWord(key), numberText(highest), described(node)});
        }
        value = *number;
        return true;
    }

    bool fail(const toml::source_region& where, const Message& what) {
        error_ = {msg::kAtLine, name_, where.begin.line, what};
        return false;
    }

    std::string name_;
    MaterialTable table_;
    Error error_;
};

}  // namespace

Expected<MaterialTable> parseMaterials(std::string_view text, std::string_view name, const MaterialTable& start) {
    const Expected<toml::table> root = parseToml(text, name);
    if (!root) return Unexpected{root.error()};
    return MaterialReader(name, start).read(*root);
}

MaterialTable defaultMaterials() {
    const Expected<MaterialTable> table = parseMaterials(defaultMaterialsText(), "data/materials.toml", {});
    TACTOOTH_ASSERT(table.has_value());  // a test parses the same text
    return table ? *table : MaterialTable();
}

Expected<MaterialTable> readMaterials(const std::filesystem::path& path) {
    const Expected<FileBytes> file = readFile(path, kTomlLimits.bytes);
    if (!file) return Unexpected{file.error()};
    return parseMaterials(file->text(), displayName(path), defaultMaterials());
}

Expected<MaterialTable> materialsFrom(const std::filesystem::path& fileOrNothing) {
    return fileOrNothing.empty() ? Expected<MaterialTable>(defaultMaterials()) : readMaterials(fileOrNothing);
}

}  // namespace tactooth
