// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tooth/model/material.h"
#include "tooth/model/material_definition.h"

namespace tactooth {

/// The materials that a tooth can be made of. Immutable; every registry lives until the program ends, so that teeth,
/// tables and threads refer to it without owning it. Equal lists give the same registry.
class MaterialRegistry {
public:
    /// Makes a registry, or returns an equal one. `definitions` in the order of menus; the order of their codes is that
    /// of the MaterialIds. At most kMaxMaterials of them, no name and no code twice, and one at least for each role.
    [[nodiscard]] static const MaterialRegistry& make(std::vector<MaterialDefinition> definitions);

    [[nodiscard]] std::size_t size() const { return materials_.size(); }
    /// The ids of all materials, in rising order.
    [[nodiscard]] std::span<const MaterialId> ids() const { return std::span(ids_).first(size()); }
    /// The same in the order of menus.
    [[nodiscard]] std::span<const MaterialId> inMenuOrder() const { return menuOrder_; }
    /// One material for each role, in the order of MaterialRole, then all others.
    [[nodiscard]] std::span<const MaterialId> byRole() const { return byRole_; }

    [[nodiscard]] const MaterialDefinition& operator[](MaterialId id) const {
        return materials_[static_cast<std::size_t>(id)];
    }
    [[nodiscard]] const std::string& nameOf(MaterialId id) const { return (*this)[id].name; }
    [[nodiscard]] std::optional<MaterialId> find(std::string_view name) const;
    [[nodiscard]] std::optional<MaterialId> findCode(std::uint8_t code) const;
    /// "enamel, dentin, ...": all names, for a message.
    [[nodiscard]] std::string names() const;

    /// The first material with this role, which is not None.
    [[nodiscard]] MaterialId withRole(MaterialRole role) const { return withRole_[static_cast<std::size_t>(role)]; }
    [[nodiscard]] bool hasRole(MaterialId id, MaterialRole role) const { return (*this)[id].role == role; }

    /// The definitions in the order of menus, as `make` takes them.
    [[nodiscard]] std::vector<MaterialDefinition> definitions() const;
    /// The lowest code that a material without one of its own can take.
    [[nodiscard]] static std::optional<std::uint8_t> freeCode(std::span<const MaterialDefinition> taken);

private:
    MaterialRegistry() = default;

    std::vector<MaterialDefinition> materials_;  // by MaterialId
    std::vector<MaterialId> menuOrder_, byRole_;
    std::array<MaterialId, kMaxMaterials> ids_{};
    std::array<MaterialId, kMaterialRoleCount> withRole_{};
};

/// The materials of data/materials.toml.
[[nodiscard]] const MaterialRegistry& builtinMaterials();

/// The numbers of each material of a registry, for one simulation: they may differ from those of the registry.
class MaterialTable {
public:
    MaterialTable() : MaterialTable(builtinMaterials()) {}
    explicit MaterialTable(const MaterialRegistry& registry);

    [[nodiscard]] const MaterialRegistry& registry() const { return *registry_; }
    [[nodiscard]] const Material& operator[](MaterialId id) const { return numbers_[static_cast<std::size_t>(id)]; }
    [[nodiscard]] Material& operator[](MaterialId id) { return numbers_[static_cast<std::size_t>(id)]; }

private:
    const MaterialRegistry* registry_;
    std::array<Material, kMaxMaterials> numbers_{};
};

}  // namespace tactooth
