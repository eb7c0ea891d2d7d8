// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_comment_menu.h"

#include <QInputDialog>
#include <QMenu>
#include <cmath>

#include "app/gui/controllers/window_messages.h"

namespace tactooth {
namespace {

constexpr double kHere = 0.05;  // s: the cursor stands on a comment

}  // namespace

ReplayCommentMenu::ReplayCommentMenu(QMenu& menu, WindowMessages& messages, QWidget& window)
    : menu_(menu), messages_(messages), window_(window) {
    menu_.setObjectName("replayComments");
    connect(&menu_, &QMenu::aboutToShow, this, &ReplayCommentMenu::fill);
}

void ReplayCommentMenu::open(const std::filesystem::path& recording) {
    comments_.reset();
    Expected<ReplayComments> opened = ReplayComments::open(recording);
    if (opened) {
        comments_.emplace(std::move(*opened));
    } else {
        messages_.showError(opened.error());
    }
    emit changed();
}

std::vector<ReplayComment> ReplayCommentMenu::all() const {
    return comments_ ? comments_->all() : std::vector<ReplayComment>();
}

void ReplayCommentMenu::askFor(double time) {
    if (!comments_)
        return messages_.setHint(tr("The comments on this recording cannot be read, so none can be added."));
    auto* dialog = new QInputDialog(&window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName("replayCommentText");
    dialog->setOption(QInputDialog::UsePlainTextEditForTextInput);
    dialog->setWindowTitle(tr("Comment"));
    dialog->setLabelText(tr("Comment at %1 s:").arg(dialog->locale().toString(time, 'f', 2)));
    connect(dialog, &QInputDialog::textValueSelected, this, [this, time](const QString& text) { add(time, text); });
    dialog->open();
}

void ReplayCommentMenu::add(double time, const QString& text) {
    if (!comments_ || text.trimmed().isEmpty()) return;
    const Expected<void> added = comments_->add({time, text.trimmed().toStdString()});
    if (!added) return messages_.showError(added.error());
    emit changed();
}

std::optional<std::size_t> ReplayCommentMenu::here() const {
    const std::vector<ReplayComment> comments = all();
    for (std::size_t i = 0; i < comments.size(); ++i) {
        if (std::abs(comments[i].time - time_) < kHere) return i;
    }
    return std::nullopt;
}

void ReplayCommentMenu::fill() {
    menu_.clear();
    constexpr qsizetype kLongest = 60;  // characters of a line
    for (const ReplayComment& comment : all()) {
        QString text = QString::fromStdString(comment.text).simplified();
        if (text.size() > kLongest) text = text.left(kLongest) + "…";
        QAction* entry = menu_.addAction(
            QString("%1 s: %2").arg(window_.locale().toString(comment.time, 'f', 1), text.replace('&', "&&")));
        connect(entry, &QAction::triggered, this, [this, time = comment.time] { emit timeChosen(time); });
    }
    if (menu_.isEmpty()) menu_.addAction(tr("No comments yet"))->setEnabled(false);
    menu_.addSeparator();
    const std::optional<std::size_t> index = here();
    QAction* remove = menu_.addAction(tr("Remove the comment here"));
    remove->setEnabled(index.has_value());
    if (!index) return;
    connect(remove, &QAction::triggered, this, [this, index = *index] {
        const Expected<void> removed = comments_->remove(index);
        if (!removed) return messages_.showError(removed.error());
        emit changed();
    });
}

}  // namespace tactooth
