// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/file_writer.h"

#include <algorithm>
#include <utility>

#include "geometry/files/atomic_file.h"

namespace tactooth {

FileWriter::~FileWriter() {
    while (isBusy()) {
        task_.wait();
        (void)task_.poll();
        jobs_.pop_front();
        startFirst();
    }
}

void FileWriter::write(Write write, Done done) {
    jobs_.push_back({std::move(write), std::move(done), std::make_shared<Control>()});
    if (jobs_.size() == 1) startFirst();
}

void FileWriter::startFirst() {
    if (jobs_.empty()) return;
    task_.start([write = jobs_.front().write, control = jobs_.front().control] {
        return write([&](double share) {
            control->share = share;
            return !control->stops;
        });
    });
}

double FileWriter::share() const { return isBusy() ? jobs_.front().control->share.load() : 0; }

void FileWriter::cancel() {
    for (Job& job : jobs_) job.control->stops = true;
}

void FileWriter::poll() {
    const auto written = task_.poll();
    if (!written) return;
    const Done done = std::move(jobs_.front().done);
    jobs_.pop_front();
    startFirst();
    if (!*written || !**written) ++unwritten_;
    if (done) done(*written);
}

void FileWriter::finish() {
    while (isBusy()) {
        task_.wait();
        poll();
    }
}

Expected<bool> writeInPieces(const std::filesystem::path& path, std::span<const std::byte> bytes,
                             const GoesOn& goesOn) {
    constexpr std::size_t kPiece = std::size_t{1} << 20;
    Expected<AtomicFile> file = AtomicFile::create(path);
    if (!file) return Unexpected{file.error()};
    for (std::size_t at = 0; at < bytes.size(); at += kPiece) {
        if (!goesOn(static_cast<double>(at) / static_cast<double>(bytes.size()))) return false;
        file->write(bytes.subspan(at, std::min(kPiece, bytes.size() - at)));
    }
    if (!goesOn(1)) return false;
    if (auto named = file->commit(); !named) return Unexpected{named.error()};
    return true;
}

}  // namespace tactooth
