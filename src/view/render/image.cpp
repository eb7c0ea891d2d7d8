// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/render/image.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/files/atomic_file.h"
#include "geometry/util/assert.h"
#include "view/gl/messages.h"

namespace tactooth {

namespace {

constexpr int kVisibleDifference = 16;  ///< of 255: the smallest difference that is visible side by side

/// The simplified interface of libpng, freed in every case.
struct PngImage {
    png_image header{};
    PngImage() { header.version = PNG_IMAGE_VERSION; }
    ~PngImage() { png_image_free(&header); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;
};

}  // namespace

Expected<void> writePng(const Image& image, const std::filesystem::path& file) {
    TACTOOTH_ASSERT(image.pixels.size() ==
                    static_cast<std::size_t>(image.size.width) * static_cast<std::size_t>(image.size.height));
    PngImage png;
    png.header.width = static_cast<png_uint_32>(image.size.width);
    png.header.height = static_cast<png_uint_32>(image.size.height);
    png.header.format = PNG_FORMAT_RGBA;
    png_alloc_size_t bytes = 0;
    std::vector<std::byte> encoded;
    if (png_image_write_to_memory(&png.header, nullptr, &bytes, 0, image.pixels.data(), 0, nullptr) != 0) {
        encoded.resize(bytes);
        png_image_write_to_memory(&png.header, encoded.data(), &bytes, 0, image.pixels.data(), 0, nullptr);
    }
    if (PNG_IMAGE_FAILED(png.header)) {
        return unexpected(msg::kPictureNotEncoded, file.string(), png.header.message);
    }
    return writeFile(file, {encoded.data(), bytes});
}

Expected<Image> readPng(const std::filesystem::path& file) {
    PngImage png;
    if (png_image_begin_read_from_file(&png.header, file.c_str()) == 0) {
        return unexpected(msg::kPictureNotRead, file.string(), png.header.message);
    }
    png.header.format = PNG_FORMAT_RGBA;
    Image image{{static_cast<int>(png.header.width), static_cast<int>(png.header.height)}, {}};
    image.pixels.resize(std::size_t{png.header.width} * png.header.height);
    if (png_image_finish_read(&png.header, nullptr, image.pixels.data(), 0, nullptr) == 0) {
        return unexpected(msg::kPictureDamaged, file.string(), png.header.message);
    }
    return image;
}

ImageDifference compare(const Image& a, const Image& b) {
    TACTOOTH_ASSERT(a.size == b.size && !a.pixels.empty());
    double sum = 0;
    double visible = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        int worst = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int difference = std::abs(int{a.pixels[i][channel]} - int{b.pixels[i][channel]});
            worst = std::max(worst, difference);
            sum += difference;
        }
        visible += worst > kVisibleDifference ? 1 : 0;
    }
    const auto count = static_cast<double>(a.pixels.size());
    return {sum / (3 * count), visible / count};
}

}  // namespace tactooth
