// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

enum class BuiltinToothKind { LowerFirstMolar, UpperCentralIncisor, UpperCanine };

/// A tooth made by the program itself. Tooth frame: origin in the tooth's axis at the height of the cervical line's
/// lowest (buccal and lingual) points, +z toward the crown, +y buccal, and mesial along x as `mesialX` says; mm.
///
/// Layers nest and the inner one wins: enamel < dentin < pulp < caries. `enamel` is the whole crown as a closed body;
/// what lies within `dentin` is dentin, and so on. Enamel and dentin together fill `outer`; where they reach the
/// tooth's surface they share its vertices.
struct BuiltinTooth {
    std::string name;     ///< for people
    int fdi = 0;          ///< two-digit tooth number (FDI)
    TriangleMesh outer;   ///< the whole tooth, closed
    TriangleMesh enamel;  ///< the crown down to the cervical line, closed
    TriangleMesh dentin;  ///< crown core and root with its cementum, closed
    TriangleMesh pulp;    ///< chamber, horns and canals, closed, inside the dentin
    TriangleMesh caries;  ///< the lesion, closed; empty if there is none
};

/// Where mesial lies on the x axis of a tooth's frame, for a two-digit tooth number (FDI): +1 in the patient's upper
/// right and lower left quarter, -1 in the other two. Their teeth are mirror images, and a frame is always
/// right-handed: with the crown up and seen from the cheek, mesial is to the left on a lower left tooth and to the
/// right on a lower right one.
[[nodiscard]] constexpr double mesialX(int fdi) { return fdi / 10 % 2 == 1 ? 1 : -1; }

/// Width of the built-in lesion where it spreads in the dentin, mm: a moderate cavity, short of the pulp.
inline constexpr double kDefaultLesionWidth = 2.4;

/// Makes a tooth whose `outer` has about `triangles` triangles; the other layers are as fine. `lesionWidth` (mm, 0 for
/// a sound tooth, at most 4): molar in the central fissure, incisor on the mesial contact, canine at the buccal neck.
/// The same arguments give the same bits, on any number of threads.
[[nodiscard]] BuiltinTooth makeBuiltinTooth(BuiltinToothKind kind, int triangles = 20000,
                                            double lesionWidth = kDefaultLesionWidth);

/// Where decay begins. `usual`: in the central fissure of a back tooth, on an incisor's mesial contact, at a canine's
/// buccal neck.
enum class LesionSite { Usual, Occlusal, Mesial, Distal, Buccal, Lingual };

struct Lesion {
    LesionSite site = LesionSite::Usual;
    double width = kDefaultLesionWidth;  ///< mm across where it spreads in the dentin, at most 4
    std::optional<double> depth;         ///< mm below the surface; none: as far as its width suggests
};

/// One tooth of the built-in mouth.
struct ToothRequest {
    int fdi = 46;            ///< permanent tooth: isPermanentTooth(fdi)
    int triangles = 20000;   ///< of `outer`, about; the other layers are as fine
    std::uint32_t seed = 0;  ///< 0: the average tooth; any other number: the same tooth of another patient
    std::optional<Lesion> lesion;
};

/// 11-18, 21-28, 31-38, 41-48.
[[nodiscard]] constexpr bool isPermanentTooth(int fdi) {
    return fdi / 10 >= 1 && fdi / 10 <= 4 && fdi % 10 >= 1 && fdi % 10 <= 8;
}

/// Incisors and canines have an edge instead of a chewing surface: they have no occlusal lesion.
[[nodiscard]] constexpr bool isAnteriorTooth(int fdi) { return fdi % 10 <= 3; }

/// "Upper right first molar".
[[nodiscard]] std::string toothName(int fdi);

/// What makeBuiltinTooth with the same arguments makes: makeTooth of this is the same, bit for bit.
[[nodiscard]] ToothRequest builtinToothRequest(BuiltinToothKind kind, int triangles = 20000,
                                               double lesionWidth = kDefaultLesionWidth);

/// Makes a tooth of the built-in mouth. The same request gives the same bits, on any number of threads; teeth of the
/// two sides of the mouth are mirror images.
[[nodiscard]] BuiltinTooth makeTooth(const ToothRequest& request);

/// A number for what makeTooth would make: another one where the request, the anatomy of the tooth or the way of
/// meshing is another. Quick.
[[nodiscard]] std::uint64_t toothFingerprint(const ToothRequest& request);

/// The same tooth of the other side of the mouth, with its number and name; `tooth` is mirrored in x.
[[nodiscard]] BuiltinTooth contralateral(BuiltinTooth tooth);

/// The layers as LayeredTooth::make takes them beside `outer`.
[[nodiscard]] std::vector<LayerMesh> layersOf(const BuiltinTooth& tooth);

/// The tooth as it is cut; it knows where mesial is. With the teeth beside it (in its frame), which are felt and cut
/// like it: their layers have the tooth's number before their names.
[[nodiscard]] Expected<LayeredTooth> layeredTooth(const BuiltinTooth& tooth, std::span<const BuiltinTooth> beside = {});

}  // namespace tactooth
