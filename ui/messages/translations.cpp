// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "ui/messages/messages.h"

#include <QTranslator>
#include <array>
#include <filesystem>
#include <memory>

namespace burin {

namespace {

/// Beside the program, one folder up (programs of the build tree's tests), and where an installation has it.
constexpr std::array folders{"translations", "../translations", "../share/burin/translations"};

} // namespace

bool Messages::install(const QLocale& locale) {
    auto translator = std::make_unique<QTranslator>();
    for (const char* folder : folders) {
        const std::filesystem::path place = executableDirectory() / folder;
        if (!translator->load(locale, QStringLiteral("burin"), QStringLiteral("_"),
                              QString::fromStdString(place.string())))
            continue;
        translator->setParent(QCoreApplication::instance());
        return QCoreApplication::installTranslator(translator.release());
    }
    return false;
}

} // namespace burin
