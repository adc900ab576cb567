// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/help/picture_file.h"

#include <QBuffer>
#include <QImageWriter>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

namespace burin::testing {

namespace {

QByteArray pngOf(const QImage& image) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QImageWriter writer(&buffer, "png");
    writer.setQuality(0); // the highest compression
    return writer.write(image) ? bytes : QByteArray();
}

/// The most frequent colours of an image, 256 at most; those of a window have few others.
QList<QRgb> coloursOf(const QImage& image) {
    std::map<QRgb, int> counts;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) ++counts[image.pixel(x, y)];
    std::vector<std::pair<int, QRgb>> order;
    for (const auto& [colour, count] : counts) order.emplace_back(-count, colour);
    std::ranges::sort(order);
    QList<QRgb> colours;
    for (std::size_t i = 0; i < std::min<std::size_t>(order.size(), 256); ++i) colours.append(order[i].second);
    return colours;
}

bool sameSize(int one, int other) {
    return 10 * std::abs(one - other) <= std::max(one, other);
}

} // namespace

QByteArray smallPng(const QImage& image) {
    const QByteArray all = pngOf(image);
    if (all.size() <= largestHelpPicture) return all;
    const QByteArray few = pngOf(image.convertToFormat(QImage::Format_Indexed8, coloursOf(image), Qt::ThresholdDither));
    return few.size() <= largestHelpPicture ? few : QByteArray();
}

double differenceOf(const QImage& one, const QImage& other) {
    if (one.isNull() || !sameSize(one.width(), other.width()) || !sameSize(one.height(), other.height())) return 1.0;
    const QImage first = one.convertToFormat(QImage::Format_RGB32),
                 second = other.convertToFormat(QImage::Format_RGB32);
    const int width = std::min(first.width(), second.width()), height = std::min(first.height(), second.height());
    double sum = 0.0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const QRgb a = first.pixel(x, y), b = second.pixel(x, y);
            sum += std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
        }
    return sum / (3.0 * 255.0 * width * height);
}

} // namespace burin::testing
