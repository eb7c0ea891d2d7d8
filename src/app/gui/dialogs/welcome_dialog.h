// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <memory>
#include <vector>

#include "app/gui/model/recent_work.h"

class QBoxLayout;
class QCheckBox;

namespace tactooth {

class CardList;
struct Exercise;

/// The page at the start: ways to begin, the manual and the language, what the user worked on last, and the exercises.
/// Closing it means practise.
class WelcomeDialog final : public QDialog {
    Q_OBJECT

public:
    struct Contents {
        std::vector<RecentWork> recent;                          ///< newest first
        std::vector<std::shared_ptr<const Exercise>> exercises;  ///< in groups; null ones are left out
        QString language;                                        ///< as in the settings
        bool comesAtStart = true;
    };
    WelcomeDialog(Contents contents, QWidget* parent);

signals:
    void toothRequested();
    void demonstrationRequested();
    void manualRequested();
    void exerciseChosen(const std::shared_ptr<const Exercise>& exercise);
    /// The user goes on with a file.
    void fileChosen(const QString& file);
    void languageChosen(const QString& code);
    void comesAtStartChanged(bool comes);

private:
    [[nodiscard]] QWidget* makeWays();
    void addChoice(QBoxLayout& column, const QString& title, const QString& what, const char* name,
                   void (WelcomeDialog::*requested)());
    [[nodiscard]] QWidget* makeLanguage();
    [[nodiscard]] QWidget* makeWork();
    [[nodiscard]] CardList* makeRecent();
    [[nodiscard]] CardList* makeExercises();

    Contents contents_;
};

}  // namespace tactooth
