// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/exercise_template.h"

#include <utility>

#include "app/gui/editor/messages.h"
#include "app/gui/text/translation.h"
#include "assessment/exercise_keys.h"
#include "assessment/outline/outline_templates.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

/// Measures of cavities in molars and in premolars, mm: those of the built-in exercises.
struct Measures {
    double width, ridge, boxWidth, axialDepth, axialHeight;
};
constexpr Measures kMolar = {.width = 1.2, .ridge = 2, .boxWidth = 3.2, .axialDepth = 1.4, .axialHeight = 1.3};
constexpr Measures kPremolar = {.width = 1, .ridge = 1.5, .boxWidth = 2.6, .axialDepth = 1.3, .axialHeight = 1.2};
constexpr double kOcclusalDepth = 1.5, kNeckDepth = 1.25;  // mm

void setPlan(Exercise& exercise, PreparationPlan plan, const char* bur, ExerciseGroup group, const char* rubric) {
    exercise.ideal = std::move(plan);
    takeBur(exercise, *findBur(bur));
    exercise.group = group;
    exercise.rubric = rubric;
}

PreparationPlan emptyPlan(const Vec3& outward, double depth, bool isFlat) {
    return {
        .outward = outward, .depth = depth, .isFlat = isFlat, .strokes = {}, .fissure = {}, .boxes = {}, .body = {}};
}

/// Draws what the fissure of a plan gives.
void drawFissure(PreparationPlan& plan, const std::shared_ptr<const SurfacePart>& outer, double burLength) {
    plan.outline = DrawnOutline{.corners = fissureOutlineOn(plan, outer),
                                .taperDegrees = 0,
                                .burRadius = plan.fissure->burRadius,
                                .burLength = burLength};
    plan.fissure.reset();
}

PreparationPlan occlusalPlan(ExerciseTemplate kind, const ToothRequest& tooth,
                             const std::shared_ptr<const SurfacePart>& outer) {
    const Measures& of = tooth.fdi % 10 >= 6 ? kMolar : kPremolar;
    const BurSpec bur = *findBur("245");
    PreparationPlan plan = emptyPlan(Vec3::UnitZ(), kOcclusalDepth, true);
    plan.fissure = FissureOutline{
        .width = of.width, .burRadius = bur.headDiameter / 2, .leftPlusX = of.ridge, .leftMinusX = of.ridge};
    if (kind != ExerciseTemplate::ClassOne) {
        const double toward = (kind == ExerciseTemplate::ClassTwoMesial ? 1 : -1) * mesialX(tooth.fdi);
        plan.boxes = {
            {.towardX = toward, .width = of.boxWidth, .axialDepth = of.axialDepth, .axialHeight = of.axialHeight}};
        (toward > 0 ? plan.fissure->leftPlusX : plan.fissure->leftMinusX).reset();
    }
    drawFissure(plan, outer, bur.headLength);
    return plan;
}

/// The name that a template gives; empty where the tooth has no number.
std::string usualName(const Exercise& exercise) {
    const auto* request = std::get_if<ToothRequest>(&exercise.tooth);
    if (request == nullptr) return {};
    return Message(msg::kDraftTitle, titleOf(exercise.group), request->fdi).in(windowLanguage());
}

/// The task that a template gives; empty where no bur makes the ideal shape.
std::string usualTask(const Exercise& exercise) {
    const auto* plan = std::get_if<PreparationPlan>(&exercise.ideal);
    return plan != nullptr ? Message(msg::kDraftTaskOf, numberText(plan->depth)).in(windowLanguage()) : std::string();
}

}  // namespace

bool fits(ExerciseTemplate kind, const Exercise& exercise) {
    const auto* request = std::get_if<ToothRequest>(&exercise.tooth);
    return request != nullptr && (kind == ExerciseTemplate::ClassFive || !isAnteriorTooth(request->fdi));
}

void applyTemplate(ExerciseTemplate kind, Exercise& exercise, const std::shared_ptr<const SurfacePart>& outer) {
    const ToothRequest& request = std::get<ToothRequest>(exercise.tooth);
    if (kind == ExerciseTemplate::ClassFive) {
        PreparationPlan plan = emptyPlan(Vec3::UnitY(), kNeckDepth, false);
        plan.outline =
            DrawnOutline{.corners = neckOutlineOn(outer, 1), .taperDegrees = 0, .burRadius = 0.4, .burLength = 1.6};
        setPlan(exercise, std::move(plan), "330", ExerciseGroup::ClassFive, "class-5");
    } else if (kind == ExerciseTemplate::ClassOne) {
        setPlan(exercise, occlusalPlan(kind, request, outer), "245", ExerciseGroup::ClassOne, "class-1");
    } else {
        setPlan(exercise, occlusalPlan(kind, request, outer), "245", ExerciseGroup::ClassTwo, "");
    }
    if (exercise.name.empty()) exercise.name = usualName(exercise);
    if (exercise.task.empty()) exercise.task = usualTask(exercise);
}

void changeWithWords(Exercise& exercise, const ExerciseChange& change) {
    const std::string name = usualName(exercise), task = usualTask(exercise);
    change(exercise);
    if (!name.empty() && exercise.name == name) exercise.name = usualName(exercise);
    if (!task.empty() && exercise.task == task) exercise.task = usualTask(exercise);
}

Exercise newExercise(int fdi, bool inMouth) {
    Exercise exercise;
    exercise.tooth = ToothRequest{.fdi = fdi};
    exercise.inMouth = inMouth;
    PreparationPlan plan = emptyPlan(Vec3::UnitZ(), kOcclusalDepth, true);
    plan.outline = DrawnOutline{.corners = {}, .taperDegrees = 0, .burRadius = 0.4, .burLength = 1.6};
    setPlan(exercise, std::move(plan), "330", ExerciseGroup::Own, "");
    return exercise;
}

Exercise editableCopy(const Exercise& exercise, const std::shared_ptr<const SurfacePart>& outer) {
    Exercise copy = exercise;
    const ExerciseWords words = exercise.words(windowLanguage());
    copy.name = words.name;
    copy.task = words.task;
    copy.brief = words.brief;
    copy.japanese = {};
    copy.id.clear();
    auto* plan = std::get_if<PreparationPlan>(&copy.ideal);
    const auto* number = std::get_if<std::string>(&copy.bur);
    if (plan != nullptr && plan->fissure && number != nullptr) drawFissure(*plan, outer, findBur(*number)->headLength);
    return copy;
}

}  // namespace tactooth
