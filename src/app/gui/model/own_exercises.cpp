// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/own_exercises.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "assessment/exercise_file.h"
#include "session/recording/recording_folder.h"

namespace tactooth {

namespace fs = std::filesystem;

fs::path ownExerciseFolder() {
    const fs::path recordings = defaultRecordingFolder();
    return recordings.empty() ? fs::path() : recordings.parent_path() / "exercises";
}

OwnExercises readOwnExercises(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failure;
    for (fs::directory_iterator file(folder, failure); !failure && file != fs::directory_iterator();
         file.increment(failure)) {
        std::error_code ignored;
        if (file->path().extension() == ".toml" && file->is_regular_file(ignored)) files.push_back(file->path());
    }
    std::ranges::sort(files);
    OwnExercises own;
    for (const fs::path& file : files) {
        Expected<Exercise> read = readExercise(file);
        if (read) {
            own.exercises.push_back(std::make_shared<const Exercise>(std::move(*read)));
        } else {
            own.faults.push_back(read.error());
        }
    }
    return own;
}

}  // namespace tactooth
