// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMessageBox>
#include <QObject>
#include <QPointer>
#include <functional>
#include <memory>
#include <optional>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/editor/draft_ideal.h"
#include "app/gui/editor/outline_tool.h"

class QDockWidget;
class QMainWindow;

namespace tactooth {

class EditorPanel;
class ExaminationMode;
class ExerciseController;
class FileDialogs;
class ToothController;
class UnsavedWork;
class WindowMessages;
enum class ExerciseTemplate;

/// The editor of exercises: the teacher draws on the tooth of the bench and fills the fields of a panel, tries the
/// exercise as a student, and saves it. Meanwhile the mouse draws and holds no bur.
class EditorController final : public QObject {
    Q_OBJECT

public:
    /// The parts of the window that it works with.
    struct Parts {
        QMainWindow& window;
        SessionModel& model;
        const ExaminationMode& mode;
        WindowPanels panels;
        WindowMessages& messages;
        FileDialogs& files;
        ToothController& teeth;
        ExerciseController& exercise;
        UnsavedWork& unsaved;
    };
    /// All of them outlive the controller.
    explicit EditorController(const Parts& parts);
    ~EditorController() override;

    [[nodiscard]] bool isEditing() const { return draft_.has_value(); }
    /// Null while nothing is edited.
    [[nodiscard]] const ExerciseDraft* draft() const { return draft_ ? &*draft_ : nullptr; }

    /// Edits a new exercise on the tooth that is on the bench, or on the usual one where that is not built in.
    void beginNew();
    /// Lets the user choose an exercise, and edits a copy of it.
    void askForCopy();
    void beginCopy(const std::shared_ptr<const Exercise>& exercise);
    /// Another tooth has come: that of the draft, of its trial, or one with which the editor ends.
    void takeTooth();
    /// Takes over what is ready. Call it after each step of the model.
    void poll();
    /// The ideal cavity of the draft as it is now, for the picture; null: it is not ready, or nobody wants to see it.
    [[nodiscard]] const std::shared_ptr<CavityGhost>& shownIdeal() const { return shownIdeal_; }
    /// Writes the exercise, and adds it to the user's own; shows a message if that fails.
    bool save(const QString& file);

    /// Hands the draft to another window, and takes it over there: on the tooth that comes next.
    [[nodiscard]] std::optional<ExerciseDraft> release();
    void adopt(ExerciseDraft draft);

signals:
    /// The panel has been made: it needs the font and the width of the others.
    void panelMade();
    /// Another shownIdeal().
    void idealChanged();

private:
    using Function = std::function<void()>;
    void begin(const std::shared_ptr<const Exercise>& exercise, bool isCopy);
    void load(const Exercise& exercise);
    void makePanel();
    void connectPanel();
    void showDraft();
    void followDraft();
    void followIdeal();
    void showIdeal();
    void edit(const QString& step, const ExerciseChange& change);
    void applyTemplate(ExerciseTemplate kind);
    void lookAtCavity();
    void tryIt();
    void comeBack();
    void endTrial();
    void askForFile(const Function& saved);
    void askToClose(Function then, const Function& otherwise);
    void end();
    void takeMouse();
    void showPanel(bool shows);
    [[nodiscard]] QString problem() const;
    [[nodiscard]] bool isUnsaved() const;

    Parts parts_;
    QPointer<EditorPanel> panel_;
    QPointer<QDockWidget> dock_;
    QPointer<QMessageBox> question_;
    OutlineTool tool_;
    DraftIdeal ideal_;
    std::shared_ptr<CavityGhost> shownIdeal_;
    std::optional<ExerciseDraft> draft_;
    std::optional<ExerciseDraft> adopted_;       // of another window, until the tooth has come
    std::shared_ptr<const Exercise> pending_;    // to be edited when its tooth has come
    bool isCopy_ = false;                        // pending_ is one
    std::shared_ptr<const Exercise> trial_;      // that the teacher tries; null: the draft is edited
    std::shared_ptr<const SurfacePart> outer_;   // of the tooth on the bench
    std::shared_ptr<const LayeredTooth> tooth_;  // on the bench; null: another one is on its way
    std::optional<Exercise> loaded_;             // whose tooth is on the bench or on its way
    bool loadsOwn_ = false;                      // the tooth that is asked for is that of the draft
};

}  // namespace tactooth
