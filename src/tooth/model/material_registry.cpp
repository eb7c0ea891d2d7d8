// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/model/material_registry.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <numeric>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr std::array kRoles = {MaterialRole::Enamel, MaterialRole::Dentin, MaterialRole::Pulp, MaterialRole::Decay,
                               MaterialRole::Surroundings};
static_assert(kRoles.size() + 1 == kMaterialRoleCount, "all roles but None");

/// Codes below are for the materials of data/materials.toml.
constexpr int kFirstFreeCode = 64;

[[maybe_unused]] bool isRegistry(std::span<const MaterialDefinition> definitions) {
    for (std::size_t i = 0; i < definitions.size(); ++i) {
        for (const MaterialDefinition& before : definitions.first(i)) {
            if (before.name == definitions[i].name || before.code == definitions[i].code) return false;
        }
    }
    return definitions.size() <= kMaxMaterials && std::ranges::all_of(kRoles, [&](MaterialRole role) {
               return std::ranges::find(definitions, role, &MaterialDefinition::role) != definitions.end();
           });
}

}  // namespace

const MaterialRegistry& MaterialRegistry::make(std::vector<MaterialDefinition> definitions) {
    TACTOOTH_ASSERT(isRegistry(definitions));
    std::vector<std::size_t> order(definitions.size());  // places in the menu, by code
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t place) { return definitions[place].code; });
    std::unique_ptr<MaterialRegistry> made(new MaterialRegistry);
    made->menuOrder_.resize(order.size());
    for (std::size_t i = 0; i < kMaxMaterials; ++i) made->ids_[i] = static_cast<MaterialId>(i);
    for (std::size_t i = 0; i < order.size(); ++i) {
        made->menuOrder_[order[i]] = made->ids_[i];
        made->materials_.push_back(std::move(definitions[order[i]]));
    }
    for (const MaterialRole role : kRoles) {
        const auto first = std::ranges::find(made->materials_, role, &MaterialDefinition::role);
        const MaterialId id = made->ids_[static_cast<std::size_t>(first - made->materials_.begin())];
        made->withRole_[static_cast<std::size_t>(role)] = id;
        made->byRole_.push_back(id);
    }
    for (const MaterialId id : made->ids()) {
        if (std::ranges::find(made->byRole_, id) == made->byRole_.end()) made->byRole_.push_back(id);
    }
    static std::mutex mutex;
    static std::vector<std::unique_ptr<const MaterialRegistry>> all;
    const std::lock_guard lock(mutex);
    const auto known = std::ranges::find_if(all, [&](const auto& one) {
        return one->materials_ == made->materials_ && one->menuOrder_ == made->menuOrder_;
    });
    return known != all.end() ? **known : *all.emplace_back(std::move(made));
}

std::optional<MaterialId> MaterialRegistry::find(std::string_view name) const {
    const auto found = std::ranges::find(materials_, name, &MaterialDefinition::name);
    if (found == materials_.end()) return std::nullopt;
    return ids_[static_cast<std::size_t>(found - materials_.begin())];
}

std::optional<MaterialId> MaterialRegistry::findCode(std::uint8_t code) const {
    const auto found = std::ranges::find(materials_, code, &MaterialDefinition::code);
    if (found == materials_.end()) return std::nullopt;
    return ids_[static_cast<std::size_t>(found - materials_.begin())];
}

std::string MaterialRegistry::names() const {
    std::string text;
    for (const MaterialId id : inMenuOrder()) text.append(text.empty() ? "" : ", ").append(nameOf(id));
    return text;
}

std::vector<MaterialDefinition> MaterialRegistry::definitions() const {
    std::vector<MaterialDefinition> all;
    for (const MaterialId id : inMenuOrder()) all.push_back((*this)[id]);
    return all;
}

std::optional<std::uint8_t> MaterialRegistry::freeCode(std::span<const MaterialDefinition> taken) {
    for (int code = kFirstFreeCode; code <= kMaxMaterialCode; ++code) {
        if (std::ranges::find(taken, code, &MaterialDefinition::code) == taken.end())
            return static_cast<std::uint8_t>(code);
    }
    return std::nullopt;
}

MaterialTable::MaterialTable(const MaterialRegistry& registry) : registry_(&registry) {
    for (const MaterialId id : registry.ids()) numbers_[static_cast<std::size_t>(id)] = registry[id].numbers;
}

}  // namespace tactooth
