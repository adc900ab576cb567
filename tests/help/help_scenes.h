// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QLocale>
#include <QString>

#include <vector>

namespace burin::testing {

/// A picture of the panel that a page of the help is about.
struct HelpPicture {
    QString topic; ///< "path"
    QImage image;
};

/// Does a short job on the sample part in the real window and takes the picture of each page on the way. The
/// translation of the locale has to be installed. Empty: a step of the job failed.
std::vector<HelpPicture> takeHelpPictures(const QLocale& locale);

} // namespace burin::testing
