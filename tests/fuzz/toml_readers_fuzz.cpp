// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: materials, a bur's description, a sound preset, an exercise and a rubric are refused with a
// sentence that names the line, or every number in them is one that can be meant, and what can be written is read
// again.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "assessment/exercise_file.h"
#include "assessment/rubric/rubric_file.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/small_surface.h"
#include "session/audio/sound_preset.h"
#include "session/cases/custom_bur.h"
#include "session/io/material_file.h"

namespace tactooth::test {
namespace {

bool isMaterials(std::string_view text) {
    const auto registry = parseMaterials(text, "fuzz");
    if (!registry) return requireSentence(registry.error(), 1000), false;
    require((*registry)->size() <= kMaxMaterials, "sums by material have room for each");
    for (const MaterialId id : (*registry)->ids()) {
        const Material& material = (**registry)[id].numbers;
        for (const double value : {material.stiffness, material.damping, material.friction, material.removal,
                                   material.soundCentre, material.soundBrightness}) {
            require(std::isfinite(value) && value >= 0, "a material's numbers are finite and not negative");
        }
        require(material.stiffness <= kMaxMaterialStiffness && material.damping <= kMaxMaterialDamping &&
                    material.friction <= kMaxMaterialFriction,
                "a material is one that a device may render");
    }
    return true;
}

bool isBur(std::string_view text) {
    const auto readSibling = [](const std::string&) -> Expected<std::vector<std::byte>> { return smallSurface(); };
    const auto bur = parseCustomBur(text, "fuzz", readSibling);
    if (!bur) return requireSentence(bur.error(), 1000), false;
    requireValid(bur->surface);
    require(bur->sharpness >= 0 && bur->sharpness <= 10, "a bur cuts ten times as fast as a new one at most");
    require(bur->flutes >= 0 && std::isfinite(bur->gritMicrometres), "an edge can be made");
    const auto again = parseCustomBur(customBurText(*bur, "a.stl"), "fuzz", readSibling);
    require(again && again->name == bur->name && again->flutes == bur->flutes,
            "what was read can be written and read again");
    return true;
}

bool isSoundPreset(std::string_view text) {
    static const std::vector<float> wave = [] {
        std::vector<float> samples(2000);
        for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = std::sin(0.1F * static_cast<float>(i));
        return samples;
    }();
    const auto readNamed = [](const std::string&) { return Recording::make(wave, 8000, "tone"); };
    const auto kit = parseSoundPreset(text, "fuzz", &dentalMaterials(), readNamed);
    const bool isOfAnyMaterial = parseSoundPreset(text, "fuzz", nullptr, readNamed).has_value();
    require(isOfAnyMaterial || !kit, "a preset of known materials is one of any");
    if (!kit) return requireSentence(kit.error(), 1000), false;
    require(kit->cutting.size() <= kMaxRecordedMaterials, "there is room for each recording");
    for (const auto& part : {kit->motor, kit->water, kit->suction}) {
        require(!part || (std::isfinite(part->gain) && part->gain > 0), "a recording's gain is a factor");
    }
    return true;
}

bool isExercise(std::string_view text) {
    const auto exercise = parseExercise(text, "fuzz", "folder");
    if (!exercise) return requireSentence(exercise.error(), 1000), false;
    if (const auto* plan = std::get_if<PreparationPlan>(&exercise->ideal)) {
        require(std::isfinite(plan->depth) && plan->outward.allFinite(), "a cavity can be planned");
        for (const auto& stroke : plan->strokes)
            require(stroke.from.allFinite() && stroke.to.allFinite(), "a stroke has places");
    }
    return true;
}

bool isRubric(std::string_view text) {
    const auto rubric = parseRubric(text, "fuzz");
    if (!rubric) return requireSentence(rubric.error(), 1000), false;
    require(rubric->criticalMark < rubric->passMark, "a critical error fails");
    for (const Criterion& criterion : rubric->criteria) {
        for (const double value : {-1e9, -1.0, 0.0, 0.3, 1.0, 1e9}) {
            const double score = criterion.levels.scoreOf(value);
            require(score >= 0 && score <= 100, "a score is a share of 100");
        }
    }
    return true;
}

bool accepts(std::span<const std::byte> bytes) {
    const std::string_view text = asText(bytes);
    const bool isAny[] = {isMaterials(text), isBur(text), isSoundPreset(text), isExercise(text), isRubric(text)};
    return std::ranges::find(isAny, true) != std::end(isAny);
}

const AddFuzzTarget added({"toml", accepts});

}  // namespace
}  // namespace tactooth::test
