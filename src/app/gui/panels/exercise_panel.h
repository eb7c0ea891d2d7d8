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

#include "assessment/cavity_metrics.h"
#include "tooth/volume/cut_volume.h"

class QGridLayout;

namespace tactooth {

struct Exercise;

/// What is practised: the choice of an exercise, how far the student has come, and what was cut beside the cavity.
class ExercisePanel final : public QWidget {
    Q_OBJECT

public:
    explicit ExercisePanel(QWidget* parent = nullptr);

    /// The exercise on the bench, null for free practice. One that is not in the list yet is added, in the place of one
    /// from the same file. Tells nobody.
    void show(const std::shared_ptr<const Exercise>& exercise);
    /// `seconds`: since the first contact; `materials`: of the tooth; `cavity`: none without an ideal one.
    void show(double seconds, const MaterialVolumes& removed, const MaterialRegistry& materials,
              const std::optional<CavityProgress>& cavity);

signals:
    /// Null: free practice.
    void chosen(const std::shared_ptr<const Exercise>& exercise);
    /// The user wants to choose the file of an exercise.
    void openRequested();
    void restartRequested();
    void exportRequested();

private:
    enum Metric { kTime, kOverPreparation, kMaxOverPreparation, kDice, kMetricCount };

    [[nodiscard]] QWidget* makeChoice();
    [[nodiscard]] QWidget* makeNumbers();
    [[nodiscard]] QString number(double value, int digits) const;

    std::vector<std::shared_ptr<const Exercise>> known_;  // as the list shows them; the first: free practice
    QComboBox* exercises_;
    QLabel* task_;
    QProgressBar* cleared_;
    std::array<QLabel*, kMetricCount> values_{};
    struct RemovedRow {
        QLabel* title = nullptr;
        QLabel* value = nullptr;
    };
    [[nodiscard]] RemovedRow& rowOf(MaterialId id, const MaterialRegistry& materials);

    QGridLayout* numbers_ = nullptr;
    std::array<RemovedRow, kMaxMaterials> removed_{};  // by MaterialId; those that were needed
    int removedRows_ = 0;
};

}  // namespace tactooth
