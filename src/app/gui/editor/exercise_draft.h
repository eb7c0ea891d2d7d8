// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assessment/exercise.h"
#include "instruments/bur_catalogue.h"

namespace tactooth {

/// A closed line of an exercise: the outline of its cavity, or one of its forbidden zones.
struct DraftLine {
    static constexpr int kCavity = -1;
    int zone = kCavity;  ///< number of the zone

    [[nodiscard]] bool isCavity() const { return zone == kCavity; }
    bool operator==(const DraftLine&) const = default;
};

/// A change of an exercise.
using ExerciseChange = std::function<void(Exercise&)>;

/// An exercise that is being made. It knows no widgets: each change is a step that can be undone.
class ExerciseDraft {
public:
    /// The state in which nothing is unsaved.
    explicit ExerciseDraft(Exercise exercise);

    [[nodiscard]] const Exercise& exercise() const { return now().exercise; }
    /// Null where the ideal shape is not made by a bur.
    [[nodiscard]] const PreparationPlan* plan() const { return std::get_if<PreparationPlan>(&exercise().ideal); }
    /// The line to which the next points are added one after another; nothing: all lines are closed.
    [[nodiscard]] const std::optional<DraftLine>& openLine() const { return now().open; }
    /// Its points, tooth frame, mm; empty where there is no such line.
    [[nodiscard]] const std::vector<Vec3>& points(DraftLine line) const;
    /// The direction from which it is seen.
    [[nodiscard]] Vec3 outwardOf(DraftLine line) const;
    /// All that there are.
    [[nodiscard]] std::vector<DraftLine> lines() const;

    /// Makes a change. Changes with the same `step` one after another are undone together; an empty one is a step of
    /// its own.
    void change(const std::string& step, const ExerciseChange& change);
    /// The next change is a step of its own in any case.
    void endStep() { step_.clear(); }
    void undo();
    void redo();
    [[nodiscard]] bool canUndo() const { return place_ > 0; }
    [[nodiscard]] bool canRedo() const { return place_ + 1 < states_.size(); }

    /// Begins the outline anew.
    void clearOutline();
    /// Begins a new forbidden zone; returns its line.
    DraftLine beginZone();
    void removeZone(int zone);
    /// Adds a point: at the end of the open line, or into the edge where it fits best. Returns its number. The first
    /// point opens the line, which is seen from `outward` then, and makes the outline of a cavity that had none.
    std::size_t addPoint(DraftLine line, const Vec3& place, const Vec3& outward);
    /// `step`: as for `change`.
    void movePoint(DraftLine line, std::size_t point, const Vec3& place, const std::string& step);
    /// A line without points is open again.
    void removePoint(DraftLine line, std::size_t point);
    /// Closes the open line, if it has three points.
    void closeLine();
    /// The places where decay begins by hand, tooth frame, mm: the first one, then where it spreads to.
    [[nodiscard]] std::vector<Vec3> decay() const;
    /// Paints decay at a place, unless it is there already. `step`: as for `change`.
    void addDecay(const Vec3& place, const std::string& step);
    /// Takes away one of `decay()`; with the last one the tooth is sound.
    void removeDecay(std::size_t place);

    /// What keeps the exercise from being tried or saved, as one sentence; nothing: it is complete. `outer`: the tooth,
    /// LayeredTooth::ownOuter; null: it is not there yet, and boxes are not judged.
    [[nodiscard]] std::optional<Message> problem(const std::shared_ptr<const SurfacePart>& outer = nullptr) const;
    /// The same of what keeps it from having an ideal cavity.
    [[nodiscard]] std::optional<Message> problemOfIdeal(const std::shared_ptr<const SurfacePart>& outer) const;
    [[nodiscard]] bool isModified() const { return !(exercise() == saved_); }
    void markSaved(const std::filesystem::path& file);

private:
    struct State {
        Exercise exercise;
        std::optional<DraftLine> open;
    };
    [[nodiscard]] const State& now() const { return states_[place_]; }
    void push(const std::string& step, State state);
    [[nodiscard]] std::optional<Message> problemOfOutline(const std::shared_ptr<const SurfacePart>& outer) const;
    [[nodiscard]] std::optional<Message> problemOfBoxes(const std::shared_ptr<const SurfacePart>& outer) const;

    std::vector<State> states_;  // never empty
    std::size_t place_ = 0;
    std::string step_;
    Exercise saved_;
};

/// The side of the tooth whose direction is nearest to this normal: occlusal, buccal, lingual, mesial or distal; unit.
[[nodiscard]] Vec3 sideOf(const Exercise& exercise, const Vec3& normal);

/// Puts a bur of the catalogue into an exercise: its cavity takes over the measures.
void takeBur(Exercise& exercise, const BurSpec& bur);

/// Gives the decay of a built-in tooth a rim of affected dentin that wide, mm; 0: none.
void setRim(Exercise& exercise, double width);
/// Whether it can have one: it has decay, and its materials are those of the program or include one for a rim.
[[nodiscard]] bool mayHaveRim(const Exercise& exercise);

}  // namespace tactooth
