// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/case_maker.h"

#include <QString>
#include <utility>

#include "app/gui/text/translation.h"
#include "session/cases/case_store.h"
#include "session/cases/write_case.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

/// The name of a folder that may be given with a slash at its end.
fs::path nameOf(const fs::path& folder) { return folder.has_filename() ? folder : folder.parent_path(); }

/// A file beside `folder` that does not exist.
fs::path freeCaseFile(const fs::path& folder) {
    std::error_code unreadable;
    for (int i = 1;; ++i) {
        fs::path file = nameOf(folder);
        file += (i == 1 ? std::string() : "-" + std::to_string(i)) + std::string(kCaseEnding);
        if (!fs::exists(file, unreadable)) return file;
    }
}

}  // namespace

CaseMaker::~CaseMaker() { stop(); }

void CaseMaker::stop() {
    if (control_) control_->stops = true;
    making_.cancel();
}

void CaseMaker::begin(const std::vector<fs::path>& from, QWidget* parent) {
    if (dialog_) dialog_->close();
    from_ = from;
    dialog_ = new CaseDialog(QString::fromStdString(nameOf(from_.front()).filename().string()), parent);
    connect(dialog_.data(), &CaseDialog::choicesChanged, this, &CaseMaker::make);
    connect(dialog_.data(), &CaseDialog::caseAccepted, this, [this] {
        if (made_) emit fileWanted(QString::fromStdString(freeCaseFile(from_.front()).string()));
    });
    connect(dialog_.data(), &QDialog::rejected, this, &CaseMaker::stop);
    dialog_->open();
    make();
}

void CaseMaker::make() {
    stop();
    made_ = nullptr;
    control_ = std::make_shared<Control>();
    CaseRequest request = dialog_->request();
    request.from = from_;
    request.title = nameOf(from_.front()).filename().string();
    dialog_->showWork(QString(), 0);
    making_.start([control = control_, request = std::move(request)] {
        return makeCase(request, [&](const std::string& body, double part) {
            const std::scoped_lock lock(control->mutex);
            control->body = body;
            control->part = part;
            return !control->stops;
        });
    });
}

void CaseMaker::write(const QString& file) {
    if (!made_) return;
    writing_.start([made = made_, path = fs::path(file.toStdString())]() -> Expected<fs::path> {
        if (auto done = writeCase(made->files, path); !done) return Unexpected{done.error()};
        return path;
    });
}

void CaseMaker::poll() {
    if (making_.isAwaited() && dialog_) {
        const std::scoped_lock lock(control_->mutex);
        dialog_->showWork(QString::fromStdString(control_->body), control_->part);
    }
    if (auto made = making_.poll(); made && dialog_) {
        dialog_->showCase(*made);
        if (*made) made_ = std::make_shared<const NewCase>(std::move(**made));
    }
    const auto done = writing_.poll();
    if (!done) return;
    if (!*done) return emit failed(translated(done->error()));
    if (dialog_) dialog_->accept();
    emit written(QString::fromStdString((*done)->string()));
}

}  // namespace tactooth
