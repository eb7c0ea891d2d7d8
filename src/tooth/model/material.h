// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tactooth {

/// What a point of a tooth is made of. The order is the order of victory: where two layers overlap, the later one of
/// this list is there (a filling sits in dentin, decay eats everything).
enum class MaterialId : std::uint8_t { Enamel, Dentin, Pulp, Other, Restoration, Caries };

inline constexpr std::size_t kMaterialCount = 6;

/// The name in files and on the command line: "enamel", "dentin", "pulp", "other", "restoration", "caries".
[[nodiscard]] std::string_view materialName(MaterialId id);
/// The material of that name, if there is one.
[[nodiscard]] std::optional<MaterialId> materialFromName(std::string_view name);

/// How a material feels, cuts, looks and sounds.
struct Material {
    double stiffness;  ///< of the felt surface, N/mm
    double damping;    ///< of the felt surface, N*s/mm
    double friction;   ///< Coulomb coefficient against steel
    double removal;    ///< volume cut per force and rim travel, mm^3/(N*m): dV = removal * force * rim speed * dt
    std::array<float, 3> colour;  ///< sRGB, 0..1
    float roughness;              ///< of the picture, 0 mirror .. 1 matt
    double soundCentre;           ///< centre frequency of the cutting noise, Hz
    double soundBrightness;       ///< level of the cutting noise for the same removal power; sound enamel = 1
};

/// One entry a material. Starts with the defaults below; a file may overwrite any of them.
class MaterialTable {
public:
    MaterialTable();

    [[nodiscard]] const Material& operator[](MaterialId id) const { return materials_[static_cast<std::size_t>(id)]; }
    [[nodiscard]] Material& operator[](MaterialId id) { return materials_[static_cast<std::size_t>(id)]; }

private:
    std::array<Material, kMaterialCount> materials_;
};

}  // namespace tactooth
