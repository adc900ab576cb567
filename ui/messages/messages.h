// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"
#include "core/base/text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>

namespace burin {

/// The one place that words the errors recorded by core. Thread: the one of the user interface, or any before
/// translations are installed.
class Messages {
    Q_DECLARE_TR_FUNCTIONS(Messages)

public:
    /// One sentence with a full stop: what happened, to which file or object, where, and the remedy.
    static QString sentence(const Error& error);

    /// A text that core marked with BURIN_TEXT, in the language of the user interface.
    static QString text(TextId id);

    /// The name of a tool, machine or material, in the language of the user interface if it is shipped with Burin. For
    /// a name followed by that of a body or layer ("Machinable wax (Block)"), the part before it is translated.
    static QString resourceName(const std::string& name);

    /// Translates everything to the first of the locale's languages for which there is a translation; English is the
    /// source. Needs a QCoreApplication. False: there is none, and everything stays English.
    static bool install(const QLocale& locale);

private:
    static QString withRecord(const QString& sentence, const Error& error);
};

} // namespace burin
