// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/scan_importer.h"

#include <QString>
#include <optional>

#include "app/gui/text/messages.h"
#include "app/gui/text/translation.h"
#include "geometry/files/file_bytes.h"
#include "geometry/io/mesh_file.h"
#include "session/cases/case_names.h"
#include "session/cases/case_surfaces.h"
#include "session/cases/entry_name.h"
#include "session/cases/make_case.h"
#include "session/cases/write_case.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

/// A single file is the surface of the tooth, whatever its name. Of several files the names give the layers.
Expected<Scan> readScan(const std::vector<fs::path>& files) {
    Scan scan{files.front().filename().string(), {}, {}};
    std::optional<Vec3> common;  // all surfaces stay in one frame
    for (const fs::path& file : files) {
        auto read = readMesh(file);
        if (!read) return Unexpected{read.error()};
        if (!common) common = read->offset;
        translateMesh(read->mesh, read->offset - *common);
        scan.importNotes.insert(scan.importNotes.end(), read->importNotes.begin(), read->importNotes.end());
        const NamedSurface named = surfaceNamed(file);
        const auto material = files.size() > 1 ? named.material : std::nullopt;
        if (material) scan.name = named.body;
        if (!addSurface(scan, material, std::move(read->mesh))) {
            return unexpected(msg::kScanHasSurface, displayName(file));
        }
    }
    return scan;
}

/// Without the files that operating systems add to folders, and that are dropped with the rest.
std::vector<fs::path> ownFiles(const std::vector<fs::path>& files) {
    std::vector<fs::path> own;
    for (const fs::path& file : files) {
        if (!isSystemFile(file.filename().string())) own.push_back(file);
    }
    return own.empty() ? files : own;
}

fs::path caseFileOf(const std::vector<fs::path>& files) {
    fs::path file = files.front();
    return file.replace_extension(kCaseEnding);
}

RecentFile scanOf(const std::vector<fs::path>& files) {
    RecentFile scan{{}, true};
    for (const fs::path& file : files) scan.files << QString::fromStdString(file.string());
    return scan;
}

/// The surface of a scan as enamel, for the preview.
std::shared_ptr<const Surface> surfaceToShow(const TriangleMesh& outer) {
    const auto enamel = static_cast<SurfaceTag>(builtinMaterials().withRole(MaterialRole::Enamel));
    auto surface = std::make_shared<Surface>();
    surface->base = std::make_shared<const SurfacePart>(outer, std::vector(outer.triangles.size(), enamel));
    return surface;
}

}  // namespace

ScanImporter::~ScanImporter() { stop(); }

void ScanImporter::stop() {
    if (control_) control_->stops = true;
    examining_.cancel();
    building_.cancel();
}

void ScanImporter::begin(const std::vector<fs::path>& files, QWidget* parent) {
    if (dialog_) dialog_->close();
    stop();
    files_ = ownFiles(files);
    scan_ = nullptr;
    examined_ = nullptr;
    dialog_ = new ImportDialog(QString::fromStdString(files_.front().filename().string()),
                               QString::fromStdString(caseFileOf(files_).string()), parent);
    connect(dialog_.data(), &ImportDialog::choicesChanged, this, &ScanImporter::examine);
    connect(dialog_.data(), &ImportDialog::importAccepted, this, &ScanImporter::build);
    connect(dialog_.data(), &QDialog::rejected, this, &ScanImporter::stop);
    dialog_->open();
    examine();
}

void ScanImporter::examine() {
    examined_ = nullptr;
    dialog_->showExamining(scan_ == nullptr);
    examining_.start([files = files_, scan = scan_, choices = dialog_->choices()]() -> Expected<Examined> {
        std::shared_ptr<const Scan> read = scan;
        if (!read) {
            auto fresh = readScan(files);
            if (!fresh) return Unexpected{fresh.error()};
            read = std::make_shared<const Scan>(std::move(*fresh));
        }
        Expected<ExaminedScan> examined = examineScan(*read, choices);
        auto shown = examined ? surfaceToShow(examined->outer) : nullptr;
        return Examined{read, std::move(examined), std::move(shown)};
    });
}

void ScanImporter::build() {
    if (!examined_) return;
    control_ = std::make_shared<Control>();
    dialog_->showBuilding(0);
    const fs::path caseFile = dialog_->savesCase() ? caseFileOf(files_) : fs::path();
    from_ = caseFile.empty() ? scanOf(files_) : RecentFile{{QString::fromStdString(caseFile.string())}};
    building_.start([control = control_, scan = *examined_, choices = dialog_->choices(), caseFile,
                     title = files_.front().stem().string()]() -> Expected<SessionTooth> {
        const auto goesOn = [&](double part) {
            control->part = part;
            return !control->stops;
        };
        auto tooth = finishScan(scan, choices, goesOn);
        if (!tooth) return Unexpected{tooth.error()};
        if (!caseFile.empty()) {
            CaseRequest request;
            request.title = title;
            const auto made = caseOf(*tooth, request);
            if (!made) return Unexpected{made.error()};
            if (auto written = writeCase(made->files, caseFile); !written) return Unexpected{written.error()};
        }
        return makeSessionTooth(*tooth);
    });
}

void ScanImporter::poll() {
    if (auto looked = examining_.poll(); looked && dialog_) {
        if (!*looked) {  // the file itself cannot be read: no choice helps
            dialog_->close();
            emit failed(translated(looked->error()));
        } else {
            scan_ = (*looked)->scan;
            if ((*looked)->examined) examined_ = std::make_shared<const ExaminedScan>(*(*looked)->examined);
            dialog_->showFindings((*looked)->examined, (*looked)->shown);
        }
    }
    if (building_.isBusy() && dialog_) dialog_->showBuilding(control_->part);
    auto built = building_.poll();
    if (!built || !dialog_) return;
    dialog_->accept();
    if (*built) {
        emit imported(std::move(**built), from_);
    } else {
        emit failed(translated(built->error()));
    }
}

}  // namespace tactooth
