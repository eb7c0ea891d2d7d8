// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/unsaved_work.h"

#include <utility>

#include "session/model/file_writer.h"
#include "session/model/session_model.h"

namespace tactooth {

bool UnsavedWork::isUnsaved() const { return model_.isModified() || (other_.isUnsaved && other_.isUnsaved()); }

void UnsavedWork::confirmDiscard(Function then, const Function& otherwise) {
    if (!other_.isUnsaved || !other_.isUnsaved()) return confirmCuts(std::move(then), otherwise);
    other_.confirm([this, then = std::move(then), otherwise] { confirmCuts(then, otherwise); }, otherwise);
}

void UnsavedWork::confirmCuts(Function then, const Function& otherwise) {
    if (!model_.isModified()) return then();
    const auto cancel = [otherwise] {
        if (otherwise) otherwise();
    };
    if (question_ != nullptr || waiting_) {
        if (question_ != nullptr) question_->raise();
        return cancel();
    }
    if (writer_.isBusy()) {
        waiting_ = Waiting{std::move(then), otherwise};
        return;
    }
    question_ = new QMessageBox(QMessageBox::Warning, tr("Unsaved cuts"),
                                tr("The tooth has cuts that are not saved. Save it first?"),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
    question_->setObjectName("unsavedWork");
    question_->setAttribute(Qt::WA_DeleteOnClose);
    question_->setDefaultButton(QMessageBox::Save);
    question_->setEscapeButton(QMessageBox::Cancel);
    connect(question_, &QDialog::finished, this, [this, then = std::move(then), otherwise, cancel](int answer) {
        question_.clear();  // so that the answer may lead to another question
        if (answer == QMessageBox::Save && save_)
            return save_([this, then, otherwise] { confirmCuts(then, otherwise); });
        if (answer == QMessageBox::Discard) return then();
        cancel();
    });
    question_->open();
}

void UnsavedWork::update() {
    window_.setWindowModified(isUnsaved());
    if (!waiting_ || writer_.isBusy()) return;
    const Waiting next = *std::exchange(waiting_, std::nullopt);
    confirmCuts(next.then, next.otherwise);
}

}  // namespace tactooth
