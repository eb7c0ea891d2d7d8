// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "assessment/metric_table.h"
#include "tooth/volume/cut_volume.h"

class QAction;
class QGridLayout;
class QToolButton;

namespace tactooth {

struct Exercise;

/// The list of exercises, the progress of the student, and what was removed outside the target cavity.
class ExercisePanel final : public QWidget {
    Q_OBJECT

public:
    explicit ExercisePanel(QWidget* parent = nullptr);

    /// Shows the active exercise; null: free practice. Adds an unknown exercise to the list, in place of one from the
    /// same file. Emits nothing.
    void show(const std::shared_ptr<const Exercise>& exercise);
    /// Adds an exercise from a file to the list, in place of one from the same file. Emits nothing.
    void add(const std::shared_ptr<const Exercise>& exercise);
    /// Takes an exercise out of the list; the active one stays.
    void remove(const std::shared_ptr<const Exercise>& exercise);
    /// `seconds`: since the first contact; `materials`: of the tooth; `cavity`: none without a target.
    void show(double seconds, const MaterialVolumes& removed, const MaterialRegistry& materials,
              const std::optional<CavityProgress>& cavity);
    /// Those of the list, and of files; the first is null: free practice.
    [[nodiscard]] const std::vector<std::shared_ptr<const Exercise>>& known() const { return known_; }
    /// Whether there are numbers besides the time, and their report.
    void setShowsNumbers(bool shows);
    /// Whether the whole tooth can be had again.
    void setAllowsRestart(bool allows);
    /// Finishes the exercise, or goes on with one that is finished; its button is in the panel.
    [[nodiscard]] QAction* finishAction() const { return finish_; }
    /// `obstacle`: why nothing can be finished; empty: it can. `isStopped`: the exercise is finished, and can go on.
    void showFinish(const QString& obstacle, bool isStopped);

signals:
    /// Null: free practice.
    void chosen(const std::shared_ptr<const Exercise>& exercise);
    /// The user wants to choose the file of an exercise.
    void openRequested();
    void restartRequested();
    void exportRequested();

private:
    [[nodiscard]] QWidget* makeChoice();
    [[nodiscard]] QToolButton* makeFinishButton();
    [[nodiscard]] QWidget* makeNumbers();
    QLabel* addFact(QGridLayout& grid, int row, const QString& title, const QString& tip);
    [[nodiscard]] QString number(double value, int digits) const;

    /// Adds one to the list, below the heading of its group.
    void addToList(const std::shared_ptr<const Exercise>& exercise);
    [[nodiscard]] int rowOf(std::size_t known) const;
    [[nodiscard]] static QString markedBy(const Exercise& exercise);
    /// Its place in known_; it is added if it is not there.
    std::size_t placeOf(const std::shared_ptr<const Exercise>& exercise);

    // The data of a row is the place of its exercise here. The first: free practice.
    std::vector<std::shared_ptr<const Exercise>> known_;
    std::shared_ptr<const Exercise> active_;
    QComboBox* exercises_;
    QLabel* task_;
    QProgressBar* cleared_;
    QAction* finish_;
    QToolButton* again_ = nullptr;
    QToolButton* report_ = nullptr;
    QLabel* time_ = nullptr;
    std::vector<std::pair<const Metric*, QLabel*>> metrics_;  // those that have a row
    struct RemovedRow {
        QLabel* title = nullptr;
        QLabel* value = nullptr;
    };
    [[nodiscard]] RemovedRow& rowOf(MaterialId id);
    void setTitle(RemovedRow& row, MaterialId id);
    void showNumbers();
    void setMaterials(const MaterialRegistry& materials);

    const MaterialRegistry* materials_;  // that the rows show
    QGridLayout* numbers_ = nullptr;
    std::array<RemovedRow, kMaxMaterials> removed_{};  // by MaterialId; those that were needed
    int removedRows_ = 0;
    bool showsNumbers_ = true;
};

}  // namespace tactooth
