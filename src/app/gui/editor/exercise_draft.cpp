// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/exercise_draft.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/gui/editor/messages.h"
#include "assessment/exercise_keys.h"
#include "assessment/outline/crown_view.h"
#include "assessment/outline/flat_outline.h"
#include "assessment/outline/outline_paths.h"
#include "geometry/util/assert.h"
#include "geometry/util/number_text.h"
#include "instruments/bur_outline.h"

namespace tactooth {
namespace {

constexpr std::size_t kMostSteps = 500;  // that can be undone

/// The points of a line; null where there is no such line. `AnyExercise`: Exercise, const or not.
template <class AnyExercise>
auto* pointsIn(AnyExercise& exercise, DraftLine line) {
    auto* plan = std::get_if<PreparationPlan>(&exercise.ideal);
    auto* points = plan != nullptr && plan->outline ? &plan->outline->corners : nullptr;
    if (line.isCavity()) return points;
    const auto zone = static_cast<std::size_t>(line.zone);
    return zone < exercise.forbidden.size() ? &exercise.forbidden[zone].corners : nullptr;
}

/// Its cavity as an outline without points.
void makeOutline(Exercise& exercise) {
    PreparationPlan plan{
        .outward = Vec3::UnitZ(), .depth = 1.5, .isFlat = true, .strokes = {}, .fissure = {}, .boxes = {}, .body = {}};
    if (const auto* before = std::get_if<PreparationPlan>(&exercise.ideal)) plan = *before;
    plan.strokes.clear();
    plan.fissure.reset();
    plan.body.reset();
    plan.crown.reset();
    const double taper = plan.outline ? plan.outline->taperDegrees : 0;
    plan.outline = DrawnOutline{.corners = {}, .taperDegrees = taper, .burRadius = 0.4, .burLength = 1.6};
    exercise.ideal = plan;
    const auto* number = std::get_if<std::string>(&exercise.bur);
    const auto bur = number != nullptr ? findBur(*number) : std::nullopt;
    takeBur(exercise, bur ? *bur : *findBur("330"));
}

/// From where a line is seen. Boxes end a cavity from the occlusal side alone.
void setSide(Exercise& exercise, DraftLine line, const Vec3& outward) {
    if (!line.isCavity()) {
        exercise.forbidden.at(static_cast<std::size_t>(line.zone)).outward = outward;
        return;
    }
    auto& plan = std::get<PreparationPlan>(exercise.ideal);
    plan.outward = outward;
    plan.isFlat = outward == Vec3::UnitZ();
    if (!plan.isFlat) plan.boxes.clear();
}

}  // namespace

Vec3 sideOf(const Exercise& exercise, const Vec3& normal) {
    Vec3 best = Vec3::UnitZ();
    for (const auto& [name, outward] : sideKeys(toothMesialX(exercise.tooth))) {
        if (outward.dot(normal) > best.dot(normal)) best = outward;
    }
    return best;
}

void takeBur(Exercise& exercise, const BurSpec& bur) {
    exercise.bur = bur.number;
    std::erase(exercise.otherBurs, bur.number);
    auto* plan = std::get_if<PreparationPlan>(&exercise.ideal);
    if (plan == nullptr) return;
    const double radius = bur.headDiameter / 2;
    if (plan->outline) {
        plan->outline->burRadius = radius;
        plan->outline->burLength = bur.headLength;
    }
    if (plan->fissure) {
        plan->fissure->burRadius = radius;
        plan->fissure->width = std::max(plan->fissure->width, bur.headDiameter);
    }
    if (plan->body) {
        plan->body->burRadius = radius;
        plan->body->burLength = bur.headLength;
    }
    if (plan->crown) plan->crown->tipRadius = endRadius(bur);
}

ExerciseDraft::ExerciseDraft(Exercise exercise) : saved_(exercise) { states_.push_back({std::move(exercise), {}}); }

const std::vector<Vec3>& ExerciseDraft::points(DraftLine line) const {
    static const std::vector<Vec3> kNone;
    const std::vector<Vec3>* found = pointsIn(exercise(), line);
    return found != nullptr ? *found : kNone;
}

Vec3 ExerciseDraft::outwardOf(DraftLine line) const {
    if (!line.isCavity()) return exercise().forbidden.at(static_cast<std::size_t>(line.zone)).outward;
    return plan() != nullptr ? plan()->outward : Vec3(Vec3::UnitZ());
}

std::vector<DraftLine> ExerciseDraft::lines() const {
    std::vector<DraftLine> lines;
    if (plan() != nullptr && plan()->outline) lines.push_back({});
    for (std::size_t i = 0; i < exercise().forbidden.size(); ++i) lines.push_back({static_cast<int>(i)});
    return lines;
}

void ExerciseDraft::push(const std::string& step, State state) {
    const bool isSame = state.exercise == now().exercise && state.open == now().open;
    if (isSame) return;
    const bool goesOn = !step.empty() && step == step_ && place_ > 0;
    states_.resize(place_ + 1);
    if (goesOn) {
        states_.back() = std::move(state);
    } else {
        states_.push_back(std::move(state));
        if (states_.size() > kMostSteps) states_.erase(states_.begin());
    }
    place_ = states_.size() - 1;
    step_ = step;
}

void ExerciseDraft::change(const std::string& step, const ExerciseChange& change) {
    State state = now();
    change(state.exercise);
    if (state.open && pointsIn(state.exercise, *state.open) == nullptr) state.open.reset();
    push(step, std::move(state));
}

void ExerciseDraft::undo() {
    if (canUndo()) --place_;
    endStep();
}

void ExerciseDraft::redo() {
    if (canRedo()) ++place_;
    endStep();
}

void ExerciseDraft::clearOutline() {
    State state = now();
    makeOutline(state.exercise);
    state.open = DraftLine{};
    push({}, std::move(state));
}

DraftLine ExerciseDraft::beginZone() {
    State state = now();
    const DraftLine line{static_cast<int>(state.exercise.forbidden.size())};
    state.exercise.forbidden.push_back({.corners = {}, .outward = Vec3::UnitZ()});
    state.open = line;
    push({}, std::move(state));
    return line;
}

void ExerciseDraft::removeZone(int zone) {
    State state = now();
    if (zone < 0 || zone >= static_cast<int>(state.exercise.forbidden.size())) return;
    state.exercise.forbidden.erase(state.exercise.forbidden.begin() + zone);
    if (state.open && !state.open->isCavity()) state.open.reset();
    push({}, std::move(state));
}

std::size_t ExerciseDraft::addPoint(DraftLine line, const Vec3& place, const Vec3& outward) {
    State state = now();
    std::vector<Vec3>* points = pointsIn(state.exercise, line);
    if (points == nullptr) {
        if (!line.isCavity()) return 0;
        makeOutline(state.exercise);
        points = pointsIn(state.exercise, line);
    }
    if (points->size() >= kMostCorners) return points->size() - 1;
    if (points->empty()) {
        state.open = line;
        setSide(state.exercise, line, outward);
    }
    std::size_t at = points->size();
    if (state.open != line && points->size() > 2) {
        const FlatOutline outline(*points, outwardOf(line));
        at = outline.edgeFor(outline.flat(place)) + 1;
    }
    points->insert(points->begin() + static_cast<std::ptrdiff_t>(at), place);
    push({}, std::move(state));
    return at;
}

void ExerciseDraft::movePoint(DraftLine line, std::size_t point, const Vec3& place, const std::string& step) {
    State state = now();
    std::vector<Vec3>* points = pointsIn(state.exercise, line);
    if (points == nullptr || point >= points->size()) return;
    (*points)[point] = place;
    push(step, std::move(state));
}

void ExerciseDraft::removePoint(DraftLine line, std::size_t point) {
    State state = now();
    std::vector<Vec3>* points = pointsIn(state.exercise, line);
    if (points == nullptr || point >= points->size()) return;
    points->erase(points->begin() + static_cast<std::ptrdiff_t>(point));
    if (points->size() < 3) state.open = line;
    push({}, std::move(state));
}

void ExerciseDraft::closeLine() {
    State state = now();
    if (!state.open || points(*state.open).size() < 3) return;
    state.open.reset();
    push({}, std::move(state));
}

std::vector<Vec3> ExerciseDraft::decay() const {
    const auto* request = std::get_if<ToothRequest>(&exercise().tooth);
    if (request == nullptr || !request->lesion || !request->lesion->place) return {};
    std::vector<Vec3> places = {*request->lesion->place};
    places.insert(places.end(), request->lesion->spread.begin(), request->lesion->spread.end());
    return places;
}

void ExerciseDraft::addDecay(const Vec3& place, const std::string& step) {
    const auto* request = std::get_if<ToothRequest>(&exercise().tooth);
    if (request == nullptr) return;
    Lesion lesion = request->lesion.value_or(Lesion{});
    constexpr double kNear = 0.35;  // of the width: places that near together make one even stroke
    const auto isThere = [&](const Vec3& other) { return (other - place).norm() < kNear * lesion.width; };
    if (std::ranges::any_of(decay(), isThere) || lesion.spread.size() >= kMostDecayPlaces) return;
    if (lesion.place) {
        lesion.spread.push_back(place);
    } else {
        lesion.place = place;
        lesion.site = LesionSite::Usual;
    }
    change(step, [&](Exercise& exercise) { std::get<ToothRequest>(exercise.tooth).lesion = lesion; });
}

void ExerciseDraft::removeDecay(std::size_t place) {
    std::vector<Vec3> places = decay();
    if (place >= places.size()) return;
    places.erase(places.begin() + static_cast<std::ptrdiff_t>(place));
    change({}, [&](Exercise& exercise) {
        std::optional<Lesion>& lesion = std::get<ToothRequest>(exercise.tooth).lesion;
        if (places.empty()) return lesion.reset();
        lesion->place = places.front();
        lesion->spread.assign(places.begin() + 1, places.end());
    });
}

std::optional<Message> ExerciseDraft::problem(const std::shared_ptr<const SurfacePart>& outer) const {
    if (openLine() && points(*openLine()).size() > 2) return msg::kDraftOpenOutline;
    if (const auto found = problemOfOutline(outer)) return found;
    for (const ForbiddenZone& zone : exercise().forbidden) {
        if (zone.corners.size() < 3) return msg::kDraftZoneSmall;
        if (FlatOutline(zone.corners, zone.outward).crossesItself()) return msg::kDraftZoneCrosses;
    }
    if (exercise().name.empty()) return msg::kDraftName;
    if (exercise().task.empty()) return msg::kDraftTask;
    return std::nullopt;
}

std::optional<Message> ExerciseDraft::problemOfIdeal(const std::shared_ptr<const SurfacePart>& outer) const {
    const DraftLine cavity;
    if (openLine() == cavity && points(cavity).size() > 2) return msg::kDraftOpenOutline;
    return problemOfOutline(outer);
}

std::optional<Message> ExerciseDraft::problemOfOutline(const std::shared_ptr<const SurfacePart>& outer) const {
    if (plan() == nullptr || !plan()->outline) return std::nullopt;
    const DrawnOutline& drawn = *plan()->outline;
    if (drawn.corners.size() < 3) return msg::kDraftNoOutline;
    const FlatOutline outline(drawn.corners, plan()->outward);
    if (outline.crossesItself()) return msg::kDraftOutlineCrosses;
    const std::string diameter = numberText(2 * drawn.burRadius);
    if (!outline.hasRoomFor(drawn.burRadius)) return Message(msg::kDraftOutlineNarrow, diameter);
    const double lean = plan()->depth * std::tan(drawn.taperDegrees * std::numbers::pi / 180);
    if (!outline.hasRoomFor(drawn.burRadius + lean)) return Message(msg::kDraftFloorNarrow, diameter);
    return problemOfBoxes(outer);
}

std::optional<Message> ExerciseDraft::problemOfBoxes(const std::shared_ptr<const SurfacePart>& outer) const {
    const double diameter = 2 * plan()->outline->burRadius;
    for (const ProximalBox& box : plan()->boxes) {
        if (std::min(box.width, box.axialDepth) < diameter) return Message(msg::kDraftBoxNarrow, numberText(diameter));
        if (outer == nullptr || boxMiddle(*plan(), box, CrownView(outer).outside(box.towardX))) continue;
        return box.towardX == toothMesialX(exercise().tooth) ? msg::kDraftMesialBox : msg::kDraftDistalBox;
    }
    return std::nullopt;
}

void ExerciseDraft::markSaved(const std::filesystem::path& file) {
    for (State& state : states_) state.exercise.file = file;
    saved_ = exercise();
    endStep();
}

namespace {

/// What may be the rim of decay: it lies in the dentin.
std::optional<MaterialId> rimMaterial(const MaterialRegistry& materials) {
    const auto [least, above] = rimNesting(materials);
    for (const MaterialId id : materials.inMenuOrder()) {
        const int nesting = materials[id].nesting;
        if (nesting >= least && nesting < above && materials.hasRole(id, MaterialRole::None)) return id;
    }
    return std::nullopt;
}

/// The materials with which the exercise may have a rim; null: there are none.
const MaterialRegistry* rimMaterials(const Exercise& exercise) {
    if (rimMaterial(*exercise.materials)) return exercise.materials;
    // One of the built-in exercises describes affected dentin.
    const auto selective = exercise.materials == &builtinMaterials() ? builtinExercise("caries-37") : nullptr;
    return selective != nullptr ? selective->materials : nullptr;
}

}  // namespace

bool mayHaveRim(const Exercise& exercise) {
    const auto* request = std::get_if<ToothRequest>(&exercise.tooth);
    return request != nullptr && request->lesion && rimMaterials(exercise) != nullptr;
}

void setRim(Exercise& exercise, double width) {
    if (!mayHaveRim(exercise)) return;
    ToothRequest& request = std::get<ToothRequest>(exercise.tooth);
    if (!(width > 0)) return request.lesion->rim.reset();
    if (request.lesion->rim) return static_cast<void>(request.lesion->rim->width = width);
    exercise.materials = rimMaterials(exercise);
    request.lesion->rim = {width, *rimMaterial(*exercise.materials), exercise.materials};
    if (request.filling) request.filling->materials = exercise.materials;  // those of the program have the same numbers
}

}  // namespace tactooth
