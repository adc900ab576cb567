// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QImage>

namespace burin::testing {

constexpr qsizetype largestHelpPicture = 40 * 1024; // bytes

/// An image as PNG, with 256 colours where more of them would make it too large. Empty: it is too large even then.
QByteArray smallPng(const QImage& image);

/// How far two pictures differ: the mean over all pixels and colours, 0 … 1; 1 where their sizes differ by more than a
/// tenth.
double differenceOf(const QImage& one, const QImage& other);

} // namespace burin::testing
