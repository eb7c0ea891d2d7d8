// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

enum class BuiltinToothKind { LowerFirstMolar, UpperCentralIncisor, UpperCanine };

/// A tooth that the program generates. Tooth frame: origin on the tooth's axis at the height of the lowest (buccal and
/// lingual) points of the cervical line, +z toward the crown, +y buccal, and mesial along x as `mesialX` says; mm.
///
/// Layers are nested and the inner one wins: enamel < dentin < pulp < filling < rim < caries. `enamel` is the whole
/// crown as a closed body; what is inside `dentin` is dentin, and so on. Enamel and dentin together fill `outer`; where
/// they reach the surface of the tooth they share its vertices.
struct BuiltinTooth {
    std::string name;                 ///< for people
    int fdi = 0;                      ///< two-digit tooth number (FDI)
    TriangleMesh outer;               ///< the whole tooth, closed
    TriangleMesh enamel;              ///< the crown down to the cervical line, closed
    TriangleMesh dentin;              ///< crown core and root with its cementum, closed
    TriangleMesh pulp;                ///< chamber, horns and canals, closed, inside the dentin
    TriangleMesh caries;              ///< the lesion, closed; empty if there is none
    TriangleMesh filling = {};        ///< closed; empty if there is none
    MaterialId fillingMaterial = {};  ///< of `materials`
    TriangleMesh rim = {};            ///< of the lesion in the dentin, closed, with the lesion in it; empty: none
    MaterialId rimMaterial = {};      ///< of `materials`
    /// Those of the tooth: the built-in ones, and perhaps others after them.
    const MaterialRegistry* materials = &builtinMaterials();
};

/// Pointers to all meshes of a tooth.
template <class Tooth>
[[nodiscard]] auto meshesOf(Tooth& tooth) {
    return std::array{&tooth.outer,  &tooth.enamel,  &tooth.dentin, &tooth.pulp,
                      &tooth.caries, &tooth.filling, &tooth.rim};
}

/// The mesial direction on the x axis of a tooth's frame, for a two-digit tooth number (FDI): +1 in the patient's upper
/// right and lower left quadrant, -1 in the other two. Their teeth are mirror images, and a frame is always
/// right-handed: seen from the cheek with the crown up, mesial is to the left on a lower left tooth and to the right on
/// a lower right one.
[[nodiscard]] constexpr double mesialX(int fdi) { return fdi / 10 % 2 == 1 ? 1 : -1; }

/// Width of the built-in lesion in the dentin, mm: a moderate cavity that does not reach the pulp.
inline constexpr double kDefaultLesionWidth = 2.4;
/// Bounds of the width and of the depth of a lesion, mm.
inline constexpr double kMinLesionWidth = 0.4, kMaxLesionWidth = 4, kMinLesionDepth = 0.3;

/// Makes a tooth whose `outer` has about `triangles` triangles; the other layers have the same resolution.
/// `lesionWidth` (mm, 0 for a sound tooth, at most 4) is the width of the lesion: in the central fissure of a molar, on
/// the mesial contact of an incisor, at the buccal neck of a canine. The same arguments give the same bits, on any
/// number of threads.
[[nodiscard]] BuiltinTooth makeBuiltinTooth(BuiltinToothKind kind, int triangles = 20000,
                                            double lesionWidth = kDefaultLesionWidth);

/// Where caries begins. `Usual`: in the central fissure of a posterior tooth, on the mesial contact of an incisor, at
/// the buccal neck of a canine.
enum class LesionSite { Usual, Occlusal, Mesial, Distal, Buccal, Lingual };

/// The dentin around a lesion that has changed but is not infected: leathery below active decay, harder than sound
/// dentin where decay has come to rest.
struct LesionRim {
    double width = 0.5;                                       ///< mm, at most kMaxRimWidth
    MaterialId material = {};                                 ///< of `materials`
    const MaterialRegistry* materials = &builtinMaterials();  ///< these, and perhaps others after them

    bool operator==(const LesionRim&) const = default;
};
inline constexpr double kMinRimWidth = 0.1, kMaxRimWidth = 2;  // mm

struct Lesion {
    LesionSite site = LesionSite::Usual;
    double width = kDefaultLesionWidth;  ///< mm, width in the dentin, at most 4
    std::optional<double> depth;         ///< mm below the surface; none: the depth that fits the width
    /// In place of `site`: where it begins, in the frame of the tooth, mm. It begins at the nearest place of the
    /// surface and grows inwards, square to it.
    std::optional<Vec3> place = {};
    /// Further places where it begins likewise; all of them together are one lesion, or several. With `place` only.
    std::vector<Vec3> spread = {};
    std::optional<LesionRim> rim = {};  ///< none: sound dentin lies beside the lesion

    bool operator==(const Lesion&) const = default;
};

/// A filling in a tooth: twice as long as wide along the fissure or the gum, with a flat floor.
struct Filling {
    LesionSite site = LesionSite::Usual;
    double width = 1.6;                                       ///< mm
    double depth = 1.8;                                       ///< mm below the surface
    MaterialId material = {};                                 ///< of `materials`
    const MaterialRegistry* materials = &builtinMaterials();  ///< these, and perhaps others after them

    bool operator==(const Filling&) const = default;
};

/// One tooth of the built-in mouth.
struct ToothRequest {
    int fdi = 46;            ///< permanent tooth: isPermanentTooth(fdi)
    int triangles = 20000;   ///< of `outer`, about; the other layers have the same resolution
    std::uint32_t seed = 0;  ///< 0: the average tooth; any other number: the same tooth of another patient
    std::optional<Lesion> lesion{};
    std::optional<Filling> filling{};

    bool operator==(const ToothRequest&) const = default;
};

/// Whether a number is one of 11-18, 21-28, 31-38, 41-48.
[[nodiscard]] constexpr bool isPermanentTooth(int fdi) {
    return fdi / 10 >= 1 && fdi / 10 <= 4 && fdi % 10 >= 1 && fdi % 10 <= 8;
}

/// Whether a tooth is an incisor or canine: it has an edge instead of an occlusal surface, and no occlusal lesion.
[[nodiscard]] constexpr bool isAnteriorTooth(int fdi) { return fdi % 10 <= 3; }

/// The name, such as "Upper right first molar".
[[nodiscard]] std::string toothName(int fdi);

/// The request for the tooth of makeBuiltinTooth with the same arguments: makeTooth gives the same bits.
[[nodiscard]] ToothRequest builtinToothRequest(BuiltinToothKind kind, int triangles = 20000,
                                               double lesionWidth = kDefaultLesionWidth);

/// Makes a tooth of the built-in mouth. The same request gives the same bits, on any number of threads; teeth of the
/// two sides of the mouth are mirror images.
[[nodiscard]] BuiltinTooth makeTooth(const ToothRequest& request);

/// Gives a tooth the materials of the request for it: those of the filling and of the rim of the decay. Both have the
/// same registry.
void takeMaterials(BuiltinTooth& tooth, const ToothRequest& request);

/// A hash of the result of makeTooth: it changes with the request, the anatomy of the tooth and the method of meshing.
/// Quick.
[[nodiscard]] std::uint64_t toothFingerprint(const ToothRequest& request);

/// The contralateral tooth, with its number and name; `tooth` is mirrored in x.
[[nodiscard]] BuiltinTooth contralateral(BuiltinTooth tooth);

/// The layers in the form that LayeredTooth::make takes beside `outer`.
[[nodiscard]] std::vector<LayerMesh> layersOf(const BuiltinTooth& tooth);

/// The tooth for cutting, with its mesial direction, and the teeth beside it (in its frame), which are touched and cut
/// like it: the names of their layers begin with the tooth number.
[[nodiscard]] Expected<LayeredTooth> layeredTooth(const BuiltinTooth& tooth, std::span<const BuiltinTooth> beside = {});

}  // namespace tactooth
