// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/shapes/gallery_command.h"

#include <fmt/core.h>

#include <array>
#include <utility>

#include "app/cli/shapes/exercise_pictures.h"
#include "app/cli/shapes/gallery_pictures.h"
#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "app/common/images/contact_sheet.h"
#include "app/common/images/image_view.h"
#include "app/common/offscreen_application.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/files/folder.h"
#include "instruments/contra_angle.h"
#include "instruments/hand_instruments.h"
#include "instruments/low_speed_handpiece.h"
#include "instruments/mirror.h"
#include "instruments/turbine.h"
#include "session/simulation/tooth_cache.h"

namespace tactooth {
namespace {

constexpr std::array kViews = {StandardView::Buccal, StandardView::Mesial, StandardView::Occlusal};
constexpr std::array kViewNames = {"buccal", "mesial", "occlusal"};

/// The patient's right is on the left side of the sheet, as on a dental chart.
constexpr std::array kUpper = {18, 17, 16, 15, 14, 13, 12, 11, 21, 22, 23, 24, 25, 26, 27, 28};
constexpr std::array kLower = {48, 47, 46, 45, 44, 43, 42, 41, 31, 32, 33, 34, 35, 36, 37, 38};

Expected<std::shared_ptr<const Surface>> surfaceOf(int fdi, const GalleryOptions& options) {
    const ToothCache cache(options.noCache ? std::filesystem::path() : defaultCacheFolder());
    return shownSurface(cache.make({fdi, options.triangles, options.seed, {}}));
}

/// Places the three views of a tooth below each other, starting at `row`. The chewing surface of an upper tooth comes
/// last, that of a lower tooth first, because the arches face each other.
Expected<void> placeTooth(ContactSheet& sheet, OffscreenRenderer& renderer, const GalleryOptions& options, int fdi,
                          int column, int firstRow, ImageSize tile) {
    constexpr double kHeight = 27.5, kAcross = 15.5;  // mm: length of the longest tooth, width of the widest crown
    const auto surface = surfaceOf(fdi, options);
    if (!surface) return Unexpected{surface.error()};
    for (int i = 0; i < static_cast<int>(kViews.size()); ++i) {
        const double millimetres = kViews[i] == StandardView::Occlusal ? kAcross : kHeight;
        const auto picture = toothPicture(renderer, *surface, fdi, kViews[i], millimetres, tile);
        if (!picture) return Unexpected{picture.error()};
        const int row = fdi < 30 ? firstRow + i : firstRow + 2 - i;
        sheet.place(column, row, *picture, fmt::format("{} {}", fdi, kViewNames[i]));
    }
    return {};
}

Expected<void> drawTeeth(OffscreenRenderer& renderer, const GalleryOptions& options) {
    constexpr ImageSize kTile{150, 190};
    ContactSheet sheet(static_cast<int>(kUpper.size()), 6, kTile);
    for (int column = 0; column < static_cast<int>(kUpper.size()); ++column) {
        if (auto done = placeTooth(sheet, renderer, options, kUpper[column], column, 0, kTile); !done) return done;
        if (auto done = placeTooth(sheet, renderer, options, kLower[column], column, 3, kTile); !done) return done;
    }
    return sheet.save(options.out / "teeth.png");
}

/// Draws only the named teeth, larger.
Expected<void> drawSome(OffscreenRenderer& renderer, const GalleryOptions& options) {
    constexpr ImageSize kTile{420, 480};
    ContactSheet sheet(static_cast<int>(options.teeth.size()), 3, kTile);
    for (int column = 0; column < static_cast<int>(options.teeth.size()); ++column) {
        if (auto done = placeTooth(sheet, renderer, options, options.teeth[column], column, 0, kTile); !done)
            return done;
    }
    return sheet.save(options.out / "teeth.png");
}

Expected<void> drawInstruments(OffscreenRenderer& renderer, const std::filesystem::path& out) {
    constexpr ImageSize kTile{150, 260};
    constexpr double kBurHeight = 12;  // mm
    constexpr int kColumns = 14;
    const std::vector<BurSpec>& burs = burCatalogue();
    const int burRows = (static_cast<int>(burs.size()) + kColumns - 1) / kColumns;
    ContactSheet sheet(kColumns, burRows + 1, kTile);
    for (int i = 0; i < static_cast<int>(burs.size()); ++i) {
        const auto picture = burPicture(renderer, burs[i], kBurHeight, kTile);
        if (!picture) return Unexpected{picture.error()};
        sheet.place(i % kColumns, i / kColumns, *picture, burs[i].number);
    }
    const std::array<std::pair<const char*, TriangleMesh>, 8> others = {{{"turbine", makeTurbine()},
                                                                         {"contra-angle", makeContraAngle()},
                                                                         {"low speed", makeLowSpeedHandpiece()},
                                                                         {"mirror 22 mm", makeMirror(22).surface},
                                                                         {"mirror 24 mm", makeMirror(24).surface},
                                                                         {"explorer 23", makeExplorer()},
                                                                         {"probe", makePeriodontalProbe()},
                                                                         {"excavator", makeSpoonExcavator()}}};
    for (int i = 0; i < static_cast<int>(others.size()); ++i) {
        const auto picture = instrumentPicture(renderer, others[i].second, kTile);
        if (!picture) return Unexpected{picture.error()};
        sheet.place(i, burRows, *picture, others[i].first);
    }
    return sheet.save(out / "instruments.png");
}

Expected<void> drawExercises(OffscreenRenderer& renderer, const std::filesystem::path& out) {
    constexpr ImageSize kDrawn{960, 640}, kSaved{360, 240};  // drawn larger: smooth edges
    for (const auto& exercise : exercises()) {
        const auto picture = exercisePicture(renderer, exercise, kDrawn);
        if (!picture) return Unexpected{picture.error()};
        const QImage saved = viewOf(*picture)
                                 .convertToFormat(QImage::Format_RGB32)
                                 .scaled(kSaved.width, kSaved.height, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        if (auto done = saveJpeg(saved, out / (exercise->id + ".jpg")); !done) return done;
    }
    return {};
}

/// The files that a run leaves.
std::vector<std::string> picturesOf(const GalleryOptions& options) {
    if (!options.exercises) {
        return options.teeth.empty() ? std::vector<std::string>{"teeth.png", "instruments.png"}
                                     : std::vector<std::string>{"teeth.png"};
    }
    std::vector<std::string> names;
    for (const auto& exercise : exercises()) names.push_back(exercise->id + ".jpg");
    return names;
}

Expected<void> drawSheets(OffscreenRenderer& renderer, const GalleryOptions& options) {
    if (!options.teeth.empty()) return drawSome(renderer, options);
    if (auto done = drawTeeth(renderer, options); !done) return done;
    return drawInstruments(renderer, options.out);
}

Expected<void> openFiles(const GalleryOptions& options, FileTransaction& files) {
    if (auto made = files.makeFolder(options.out); !made) return made;
    for (const std::string& name : picturesOf(options)) {
        if (auto opened = files.open(options.out / name); !opened) return opened;
    }
    return {};
}

}  // namespace

int runGallery(const GalleryOptions& options) {
    constexpr std::size_t kMaxTeeth = 32;
    if (options.teeth.size() > kMaxTeeth) {
        return reportError({msg::kTooManyTeeth, options.teeth.size(), kMaxTeeth});
    }
    for (const int fdi : options.teeth) {
        if (!isPermanentTooth(fdi)) {
            return reportError({msg::kNoPermanentToothGiven, fdi});
        }
    }
    FileTransaction files;
    if (const auto opened = openFiles(options, files); !opened) return reportError(opened.error());
    const OffscreenApplication application;
    Expected<OffscreenRenderer> renderer = OffscreenRenderer::create();
    if (!renderer) return reportError(renderer.error());
    const auto drawn = options.exercises ? drawExercises(*renderer, options.out) : drawSheets(*renderer, options);
    if (!drawn) return reportError(drawn.error());
    if (const auto done = files.commit(); !done) return reportError(done.error());
    for (const std::string& name : picturesOf(options)) print("{}\n", displayName(options.out / name));
    return kExitOk;
}

}  // namespace tactooth
