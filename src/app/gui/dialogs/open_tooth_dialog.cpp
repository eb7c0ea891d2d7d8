// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/open_tooth_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "app/gui/text/translation.h"

namespace tactooth {

OpenToothDialog::OpenToothDialog(QString folder, QWidget* parent) : QDialog(parent), folder_(std::move(folder)) {
    setWindowTitle(tr("Open tooth"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* grid = new QGridLayout(this);
    auto* intro =
        new QLabel(tr("The tooth's outer surface is touched and drawn. Closed surfaces inside it say where each "
                      "tissue is; without them the whole tooth is enamel. STL files in millimetres, or a case or "
                      "a saved tooth, which have all of these."));
    intro->setWordWrap(true);
    grid->addWidget(intro, 0, 0, 1, 3);
    outer_ = addRow(*grid, tr("Outer surface"), tr("The whole tooth, a case or a saved one, needed"));
    outer_->setObjectName("outerSurface");
    for (const MaterialId id : builtinMaterials().inMenuOrder()) {
        const MaterialDefinition& material = builtinMaterials()[id];
        layers_[material.name] = addRow(*grid, materialLabel(material), tr("Optional"));
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    grid->addWidget(buttons, grid->rowCount(), 0, 1, 3);
    QPushButton* open = buttons->button(QDialogButtonBox::Open);
    open->setEnabled(false);
    connect(outer_, &QLineEdit::textChanged, open, [open](const QString& text) { open->setEnabled(!text.isEmpty()); });
    connect(buttons, &QDialogButtonBox::accepted, this, &OpenToothDialog::emitChosen);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    resize(560, sizeHint().height());
}

QLineEdit* OpenToothDialog::addRow(QGridLayout& grid, const QString& label, const QString& tip) {
    auto* edit = new QLineEdit;
    edit->setPlaceholderText(tip);
    auto* name = new QLabel(label);
    name->setBuddy(edit);
    auto* browse = new QPushButton(tr("Browse…"));
    browse->setAutoDefault(false);
    const int row = grid.rowCount();
    grid.addWidget(name, row, 0);
    grid.addWidget(edit, row, 1);
    grid.addWidget(browse, row, 2);
    connect(browse, &QPushButton::clicked, this, [this, edit, label] {
        auto* files = new QFileDialog(
            this, label, folder_,
            tr("Surfaces, cases and saved teeth (*.stl *.STL *.obj *.OBJ *.ply *.PLY *.ttcase case.toml *.tactooth);;"
               "All files (*)"));
        files->setAttribute(Qt::WA_DeleteOnClose);
        files->setFileMode(QFileDialog::ExistingFile);
        connect(files, &QFileDialog::fileSelected, this, [this, edit](const QString& file) {
            edit->setText(file);
            folder_ = QFileInfo(file).absolutePath();
        });
        files->open();
    });
    return edit;
}

void OpenToothDialog::emitChosen() {
    ToothSource source;
    source.outer = outer_->text().toStdString();
    for (const auto& [name, edit] : layers_) {
        if (!edit->text().isEmpty()) source.layers.push_back({name, edit->text().toStdString()});
    }
    emit chosen(source);
    accept();
}

}  // namespace tactooth
