// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "assessment/forbidden_zone.h"
#include "collision/bvh/surface.h"
#include "geometry/util/message.h"
#include "instruments/builtin_tooth.h"
#include "instruments/hand_instruments.h"
#include "instruments/handpiece_kind.h"
#include "session/simulation/tooth_in_mouth.h"
#include "session/simulation/tooth_source.h"

namespace tactooth {

/// An outline along the central fissure of a posterior tooth, wherever that runs on its surface.
struct FissureOutline {
    double width;      ///< mm, at least that of the bur
    double burRadius;  ///< mm
    /// Tooth that is left between the cavity and the outside of the crown, toward +x and -x, mm. Nothing: a box ends
    /// the cavity there.
    std::optional<double> leftPlusX, leftMinusX;

    bool operator==(const FissureOutline&) const = default;
};

/// The box of a Class II cavity: it opens the proximal side and is deeper than the occlusal part.
struct ProximalBox {
    double towardX;      ///< 1 or -1: its side
    double width;        ///< buccolingual, mm
    double axialDepth;   ///< from the outside of the tooth at the height of the box's floor to the axial wall, mm
    double axialHeight;  ///< of the axial wall, from the box's floor to the pulpal floor, mm

    bool operator==(const ProximalBox&) const = default;
};

/// A cavity that removes a body inside the tooth, with what lies over it: decay, a filling, or the roof of the pulp
/// chamber.
struct BodyOutline {
    MaterialRole role;  ///< of the body's material: Decay or Pulp; None: it is a filling
    double burRadius;   ///< mm
    double burLength;   ///< of its head, mm
    /// Only what lies above this depth below the top of the body, mm, with a flat floor there; nothing: all of it.
    std::optional<double> below;
    /// The side to which the cavity is open, unit, not along PreparationPlan::outward: what lies between the body and
    /// that side of the tooth goes, too, and the floor does not rise toward it. Nothing: walls all around.
    std::optional<Vec3> openTo = {};

    bool operator==(const BodyOutline&) const = default;
};

/// A cavity below a closed outline that somebody has drawn on the tooth, seen along PreparationPlan::outward.
struct DrawnOutline {
    std::vector<Vec3> corners;  ///< on the surface, the first not repeated, mm
    /// How much the walls lean from the shaft, so that the cavity is widest at the outline; 0: as the bur makes them.
    double taperDegrees = 0;
    double burRadius;  ///< mm
    double burLength;  ///< of its head, mm

    bool operator==(const DrawnOutline&) const = default;
};

/// A crown preparation on the tooth's own surface: a finish line round the neck, axial walls that lean inwards from it,
/// and a surface that follows the uncut one. Heights along the axis, which is the direction of insertion.
struct CrownOutline {
    double width;           ///< of the finish line, mm
    double height;          ///< of the finish line above the cervical line, buccal and lingual, mm
    double plusXHeight;     ///< the same on the side toward +x
    double minusXHeight;    ///< the same on the side toward -x
    double taper;           ///< of each axial wall to the axis, degrees
    double buccalTaper;     ///< the same of the buccal wall
    double buccal;          ///< least depth below the buccal (labial) face, mm
    double lingual;         ///< the same of the lingual face
    double occlusal;        ///< depth below the occlusal faces, or the end of the stump below the incisal edge, mm
    double functional;      ///< depth below the functional cusps, mm
    double functionalSide;  ///< 1: these are buccal, -1: lingual
    bool isIncisal;         ///< the tooth has an edge instead of an occlusal surface
    double rounding;        ///< radius of the edges of the stump, mm; 0: sharp
    double tipRadius;       ///< of the bur's end, mm; 0: flat
    /// Height of the cervical line along the axis, mm. Nothing: where the enamel ends.
    std::optional<double> cervical;

    bool operator==(const CrownOutline&) const = default;
};

/// The path of the bur through an ideal cavity: strokes of its tip, with the shaft in one direction.
struct PreparationPlan {
    Vec3 outward;  ///< direction of the shaft, out of the tooth, unit
    double depth;  ///< below the surface, mm
    /// True: flat floor, `depth` below the mean of the first stroke; false: the floor follows the surface.
    bool isFlat;
    bool stopsDevice = false;  ///< a haptic device stops at the floor, too
    struct Stroke {
        Vec3 from, to;                     ///< tooth frame, mm; the height along `outward` is computed
        std::optional<double> depth = {};  ///< nothing: that of the plan

        bool operator==(const Stroke&) const = default;
    };
    std::vector<Stroke> strokes;             ///< empty: the paths follow from what comes next
    std::optional<FissureOutline> fissure;   ///< in place of strokes; from the occlusal side with a flat floor
    std::vector<ProximalBox> boxes;          ///< only with a fissure or an outline
    std::optional<BodyOutline> body;         ///< in place of strokes
    std::optional<CrownOutline> crown = {};  ///< in place of strokes; it has no paths
    /// In place of strokes; with boxes only from the occlusal side with a flat floor.
    std::optional<DrawnOutline> outline = {};

    bool operator==(const PreparationPlan&) const = default;
};

/// What an exercise trains. Lists show the exercises in this order.
enum class ExerciseGroup {
    HandEye,
    Caries,
    Filling,
    ClassOne,
    ClassTwo,
    ClassThree,
    ClassFive,
    Crown,
    Endodontic,
    Own
};
[[nodiscard]] const MessageText& titleOf(ExerciseGroup group);

/// From where the window shows the work first.
enum class StartView {
    Cavity,   ///< as near to the dentist's own direction as shows the whole cavity (viewOnto)
    Dentist,  ///< the dentist's own direction
    Mirror,   ///< the same, with the mirror behind the tooth, in which the cavity is seen
    Occlusal,
    Buccal,
    Lingual,
    Mesial,
    Distal,
};

enum class ExerciseLevel { Easy, Usual, Hard };
[[nodiscard]] const MessageText& titleOf(ExerciseLevel level);

/// What a student takes from the tray: a handpiece, or an instrument without one.
using TrayInstrument = std::variant<HandpieceKind, HandInstrument>;

/// The words of an exercise in one language; empty: the file does not have them.
struct ExerciseWords {
    std::string name;   ///< its title
    std::string task;   ///< a sentence
    std::string brief;  ///< how to go about it

    bool operator==(const ExerciseWords&) const = default;
};

/// A task for a student: a cavity in a tooth. Tooth frame.
struct Exercise {
    std::string name;                                            ///< for people
    std::string task;                                            ///< a sentence
    std::string brief;                                           ///< how to go about it; may be empty
    ExerciseWords japanese;                                      ///< each may be empty
    std::variant<ToothRequest, ToothSource> tooth;               ///< a built-in one, or files
    std::variant<std::string, std::filesystem::path> bur;        ///< number in the catalogue, or a file (readCustomBur)
    std::variant<PreparationPlan, std::filesystem::path> ideal;  ///< or a file (loadIdealShape)
    std::filesystem::path file = {};                             ///< its description; empty: built in
    std::string id = {};                                         ///< of a built-in one: "class-1-46"
    ExerciseGroup group = ExerciseGroup::Own;
    ExerciseLevel level = ExerciseLevel::Usual;
    bool inMouth = false;                     ///< a built-in tooth stands in the whole mouth, with its neighbours
    std::vector<std::string> otherBurs = {};  ///< numbers of burs of the catalogue that serve as well
    bool onlyTheseBurs = false;               ///< a student may take no bur but these
    /// What a student may take from the tray, in the order of the tray; at least one handpiece. Empty: all.
    std::vector<TrayInstrument> instruments = {};
    std::optional<int> minutes = {};            ///< time for the task
    double tolerance = 0.3;                     ///< mm from the ideal surface that count as right in pictures
    std::string rubric = {};                    ///< a built-in one, or a file; empty: the usual one
    StartView view = StartView::Cavity;         ///< from where the window shows it first
    std::vector<ForbiddenZone> forbidden = {};  ///< a cut there is a critical error
    /// Those that the exercise may speak of: the built-in ones, and perhaps others that it brings.
    const MaterialRegistry* materials = &builtinMaterials();

    bool operator==(const Exercise&) const = default;

    /// Whether the ideal cavity reaches the pulp.
    [[nodiscard]] bool opensPulp() const;
    /// The words in this language; in English where the file has no others.
    [[nodiscard]] ExerciseWords words(Language language) const;
};

/// Those that are built in (data/exercises/): by group, then by level, then by the number of the file.
[[nodiscard]] std::span<const std::shared_ptr<const Exercise>> exercises();
/// A built-in one by its id; null if there is none.
[[nodiscard]] std::shared_ptr<const Exercise> builtinExercise(std::string_view id);

/// One path of the bur's tip.
struct BurPath {
    std::vector<Vec3> places;     ///< tooth frame, mm
    std::optional<double> depth;  ///< below the surface, mm, as PreparationPlan::depth; nothing: the places have it
    bool lifts = false;           ///< the bur leaves the tooth before it, however near the path before ends
};
/// All paths of a plan on an uncut tooth; none where it has no fissure to follow, no such body, or no room inside its
/// outline. `outer`: LayeredTooth::ownOuter, which takes some time in a mouth.
[[nodiscard]] std::vector<BurPath> burPaths(const PreparationPlan& plan, const LayeredTooth& tooth,
                                            const std::shared_ptr<const SurfacePart>& outer);

/// The same with the places of the bur's tip at their final depth. Fails with one sentence.
[[nodiscard]] Expected<std::vector<BurPath>> tipPaths(const PreparationPlan& plan, const LayeredTooth& tooth);

/// The place from whose height, along PreparationPlan::outward, the depth of a flat floor counts. Nothing where the
/// first stroke misses the uncut tooth, and where the paths have their own heights.
[[nodiscard]] std::optional<Vec3> floorReference(const PreparationPlan& plan, const LayeredTooth& tooth);

/// The uncut tooth of the exercise. Takes a second; fails with one sentence.
[[nodiscard]] Expected<std::shared_ptr<const LayeredTooth>> exerciseTooth(const Exercise& exercise);

/// The mouth around the tooth of the exercise, in its frame; nothing: it stands alone. Takes some seconds the first
/// time.
[[nodiscard]] std::optional<ToothInMouth> exerciseMouth(const Exercise& exercise);

/// The gums around the tooth of the exercise, in its frame; empty: it stands alone. Takes some seconds the first time.
[[nodiscard]] std::vector<std::shared_ptr<const SurfacePart>> exerciseGums(const Exercise& exercise);

/// Hears which share of an ideal shape is made, 0..1; false ends the work. The thread that makes the shape calls it.
using IdealProgress = std::function<bool(double share)>;

/// `tooth` (that of the exercise) with the ideal cavity, closed. A cavity from a plan keeps the untouched triangles of
/// the tooth, bit for bit. Fails with one sentence. An empty mesh where `progress` has ended the work.
[[nodiscard]] Expected<TriangleMesh> idealShape(const Exercise& exercise, std::shared_ptr<const LayeredTooth> tooth,
                                                const IdealProgress& progress = {});

}  // namespace tactooth
