// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"
#include "core/base/text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>

namespace burin {

/// The one place that words what core only records. Thread: the one of the user interface, or any before translations
/// are installed.
class Messages {
    Q_DECLARE_TR_FUNCTIONS(Messages)

public:
    /// One sentence with a full stop: what happened, to which file or thing, where, and what helps.
    static QString sentence(const Error& error);

    /// A text that core marked with BURIN_TEXT, in the language of the user interface.
    static QString text(TextId id);

    /// The name of a tool, machine or material: in the language of the user interface where Burin is shipped with it.
    /// Of one that bears the name of a body or layer behind it ("Machinable wax (Block)"), what is before that.
    static QString resourceName(const std::string& name);

    /// Words everything in the first of the locale's languages that there is a translation of; English is the source.
    /// Needs a QCoreApplication. False: there is none, and all stays English.
    static bool install(const QLocale& locale);

private:
    static QString withRecord(const QString& sentence, const Error& error);
};

} // namespace burin
