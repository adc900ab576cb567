// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "ui/messages/messages.h"

#include <QTranslator>

#include <memory>

namespace burin {

bool Messages::install(const QLocale& locale) {
    auto translator = std::make_unique<QTranslator>();
    if (!translator->load(locale, QStringLiteral("burin"), QStringLiteral("_"),
                          QString::fromStdString(translationDirectory().string())))
        return false;
    translator->setParent(QCoreApplication::instance());
    return QCoreApplication::installTranslator(translator.release());
}

} // namespace burin
