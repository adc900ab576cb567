// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/device_fault.h"
#include "tests/places.h"
#include "tests/test_program.h"
#include "ui/messages/messages.h"
#include "ui/messages/undo_detail.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTranslator>
#include <QXmlStreamReader>
#include <QtTest>

namespace burin::tst_messages {

namespace {

constexpr int codeCount = static_cast<int>(ErrorCode::traceEnded) + 1; // the last of the list

Error errorOf(int code) {
    return {static_cast<ErrorCode>(code), "SUBJECT", "PLACE", "DETAIL"};
}

/// Does what `install` does and undoes it in the destructor.
class InLanguage {
public:
    explicit InLanguage(const char* language)
        : loaded_(translator_.load(QStringLiteral("burin_") + QLatin1String(language),
                                   QStringLiteral(BURIN_TRANSLATIONS))) {
        QCoreApplication::installTranslator(&translator_);
    }
    ~InLanguage() { QCoreApplication::removeTranslator(&translator_); }
    InLanguage(const InLanguage&) = delete;
    InLanguage& operator=(const InLanguage&) = delete;
    bool loaded() const { return loaded_; }

private:
    QTranslator translator_;
    bool loaded_;
};

QStringList translationFiles() {
    const QDir folder(QStringLiteral(BURIN_SOURCE_DIRECTORY "/translations"));
    QStringList files;
    for (const QString& name : folder.entryList({QStringLiteral("*.ts")})) files.append(folder.filePath(name));
    return files;
}

struct Translations {
    QSet<QString> texts; ///< "context: source"
    QStringList unfinished;
    QStringList differentPlaces; ///< texts whose translation does not have the same %1, %2, …
};

QSet<QString> placesIn(const QString& text) {
    QSet<QString> places;
    auto match = QRegularExpression(QStringLiteral("%[1-9n]")).globalMatch(text);
    while (match.hasNext()) places.insert(match.next().captured());
    return places;
}

Translations read(const QString& file) {
    Translations result;
    QFile content(file);
    if (!content.open(QIODevice::ReadOnly)) return result;
    QXmlStreamReader xml(&content);
    QString context, source;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("name")) context = xml.readElementText();
        if (xml.name() == QLatin1String("source")) source = xml.readElementText();
        if (xml.name() != QLatin1String("translation")) continue;
        const bool unfinished = xml.attributes().hasAttribute(QStringLiteral("type"));
        const QString translation = xml.readElementText(QXmlStreamReader::IncludeChildElements);
        const QString text = context + QStringLiteral(": ") + source;
        result.texts.insert(text);
        const bool guessed = translation.contains(QLatin1String(" ?}")); // a number that lupdate asks to check
        if (unfinished || guessed || translation.trimmed().isEmpty()) result.unfinished.append(text);
        if (placesIn(source) != placesIn(translation)) result.differentPlaces.append(text);
    }
    return result;
}

} // namespace

class TestMessages : public QObject {
    Q_OBJECT
private slots:
    void everyErrorIsASentence_data() {
        QTest::addColumn<bool>("german");
        QTest::addColumn<bool>("bare");
        QTest::newRow("English") << false << false;
        QTest::newRow("English, without place and detail") << false << true;
        QTest::newRow("German") << true << false;
        QTest::newRow("German, without place and detail") << true << true;
    }
    void everyErrorIsASentence() {
        QFETCH(bool, german);
        QFETCH(bool, bare);
        std::optional<InLanguage> language;
        if (german) QVERIFY(language.emplace("de").loaded());
        QSet<QString> sentences;
        for (int code = 0; code < codeCount; ++code) {
            Error error = errorOf(code);
            if (bare) error.place = error.detail = {};
            const QString sentence = Messages::sentence(error);
            QVERIFY2(sentence.contains(QStringLiteral("SUBJECT")), qPrintable(sentence));
            QVERIFY2(sentence.endsWith(QLatin1Char('.')), qPrintable(sentence));
            QVERIFY2(!sentence.contains(QLatin1Char('%')) && !sentence.contains(QStringLiteral("()")) &&
                         !sentence.contains(QStringLiteral("\"\"")),
                     qPrintable(sentence));
            QVERIFY2(sentence.count(QRegularExpression(QStringLiteral("\\.( |$)"))) == 1, qPrintable(sentence));
            QVERIFY2(sentence.front().isUpper() || sentence.front().isPunct(), qPrintable(sentence));
            QVERIFY2(!sentence.contains(QStringLiteral("please"), Qt::CaseInsensitive), qPrintable(sentence));
            sentences.insert(sentence);
        }
        QCOMPARE(sentences.size(), qsizetype{codeCount}); // no two errors have the same sentence
    }

    void aChangeDuringAnUndoIsRefused() {
        QCOMPARE(
            Messages::sentence({ErrorCode::cancelled, "tool axis", {}, std::string(undoUnderWayDetail)}),
            QStringLiteral("\"tool axis\" was not done, because an undo or redo is still under way; do it again in "
                           "a moment."));
    }

    /// Unknown memory figures are not mentioned.
    void memoryFiguresAreToldWhereTheyAreKnown() {
        const QString known = Messages::sentence({ErrorCode::outOfMemory, "volume", "900 MB, 300 MB", {}});
        QCOMPARE(known, QStringLiteral("There is not enough memory for \"volume\" (needed and free: 900 MB, 300 MB); "
                                       "close other programs or choose larger voxels."));
        const QString unknown = Messages::sentence({ErrorCode::outOfMemory, "volume", {}, {}});
        QCOMPARE(unknown, QStringLiteral("There is not enough memory for \"volume\"; close other programs or choose "
                                         "larger voxels."));
    }

    void germanIsNotEnglish() {
        QStringList english;
        for (int code = 0; code < codeCount; ++code) english.append(Messages::sentence(errorOf(code)));
        const InLanguage german("de");
        QVERIFY(german.loaded());
        for (int code = 0; code < codeCount; ++code) QVERIFY(Messages::sentence(errorOf(code)) != english[code]);
    }

    /// With the punctuation of Chinese: one full stop, brackets only around something.
    void everyErrorIsASentenceInChinese() {
        QStringList english;
        for (int code = 0; code < codeCount; ++code) english.append(Messages::sentence(errorOf(code)));
        const InLanguage chinese("zh_CN");
        QVERIFY(chinese.loaded());
        const QChar stop(0x3002);
        QSet<QString> sentences;
        for (int code = 0; code < codeCount; ++code) {
            for (const bool bare : {false, true}) {
                Error error = errorOf(code);
                if (bare) error.place = error.detail = {};
                const QString sentence = Messages::sentence(error);
                QVERIFY2(sentence.contains(QStringLiteral("SUBJECT")), qPrintable(sentence));
                QVERIFY2(sentence.endsWith(stop) && sentence.count(stop) == 1, qPrintable(sentence));
                QVERIFY2(!sentence.contains(QLatin1Char('%')) && !sentence.contains(QString::fromUtf8("（）")) &&
                             !sentence.contains(QString::fromUtf8("“”")),
                         qPrintable(sentence));
                if (!bare) sentences.insert(sentence);
            }
            QVERIFY(Messages::sentence(errorOf(code)) != english[code]);
        }
        QCOMPARE(sentences.size(), qsizetype{codeCount});
    }

    void aPercentSignInANameStaysOne() {
        const Error error{ErrorCode::projectInUse, "/parts/%2 %1.burin", {}, "process 4711"};
        QVERIFY(Messages::sentence(error).contains(QStringLiteral("/parts/%2 %1.burin")));
        QVERIFY(Messages::sentence(error).contains(QStringLiteral("process 4711")));
    }

    void coresWordsAreTranslated() {
        const TextId smooth = BURIN_TEXT("Edit", "Smooth");
        const Error error{ErrorCode::projectIncomplete, "recording", "burin mill", {}};
        QCOMPARE(Messages::text(smooth), QStringLiteral("Smooth"));
        QVERIFY(Messages::sentence(error).contains(QStringLiteral("recording")));
        const InLanguage german("de");
        QCOMPARE(Messages::text(smooth), QStringLiteral("Glätten"));
        QVERIFY(Messages::sentence(error).contains(QStringLiteral("Aufzeichnung")));
    }

    void whatADeviceReportsIsTranslated() {
        for (std::size_t i = 0; i < deviceFaultCount; ++i) {
            const Error error = errorOf(static_cast<DeviceFault>(i), "Mine");
            const QString english = Messages::sentence(error);
            QVERIFY2(english.contains(QString::fromStdString(error.detail)), qPrintable(english));
            const InLanguage german("de");
            QVERIFY(german.loaded());
            const QString translated = Messages::sentence(error);
            QVERIFY2(error.detail.empty() || !translated.contains(QString::fromStdString(error.detail)),
                     qPrintable(translated));
        }
    }

    /// Core records positions and details in English; what a user typed stays as typed.
    void whatCoreRecordsIsTranslated() {
        const Error program{ErrorCode::programSyntax, "a.ngc", "line 3, column 7",
                            "word is repeated: X1; its start is set by line 2"};
        const Error file{ErrorCode::resourceInvalid, "mill.json", "home_mm[2]", "has to be a number from -1 to 1e+06"};
        const Error typed{ErrorCode::argumentInvalid, "--place", "true or false", "0 to 8"};
        const Error unknown{ErrorCode::resourceInvalid, "mill.json", "id", "what only a driver would say"};
        const auto says = [](const Error& error, const char* words) {
            const QString sentence = Messages::sentence(error);
            if (!sentence.contains(QString::fromUtf8(words))) qWarning("%s", qPrintable(sentence));
            return sentence.contains(QString::fromUtf8(words));
        };
        QVERIFY(says(program, "line 3, column 7 (word is repeated: X1; its start is set by line 2)"));
        QVERIFY(says(file, "(has to be a number from -1 to 1e+06)"));
        const InLanguage german("de");
        QVERIFY(says(program, "Zeile 3, Spalte 7"));
        QVERIFY(says(program, "das Wort kommt zweimal vor: X1; seinen Anfang setzt Zeile 2"));
        QVERIFY(says(file, "„home_mm[2]“") && says(file, "muss eine Zahl von -1 bis 1e+06 sein"));
        QVERIFY(says(typed, "„true or false“") && says(typed, "0 bis 8"));
        QVERIFY(says(unknown, "(what only a driver would say)"));
    }

    /// The names of materials, tools and machines are in their files, which the update of the translations does not
    /// read.
    void whatBurinIsShippedWithIsTranslated() {
        int names = 0;
        for (const QString& translation : translationFiles()) {
            const QSet<QString> texts = read(translation).texts;
            for (const char* kind : {"materials", "tools", "holders", "machines"}) {
                const QDir folder(QStringLiteral(BURIN_SOURCE_DIRECTORY "/resources/") + QLatin1String(kind));
                for (const QFileInfo& info : folder.entryInfoList({QStringLiteral("*.json")})) {
                    QFile file(info.filePath());
                    QVERIFY(file.open(QIODevice::ReadOnly));
                    const QString name = QJsonDocument::fromJson(file.readAll()).object()["name"].toString();
                    QVERIFY2(texts.contains(QStringLiteral("Resource: ") + name),
                             qPrintable(info.fileName() + QStringLiteral(": ") + name));
                    ++names;
                }
            }
        }
        QVERIFY(names > 20);
    }

    void theLanguageOfTheUserIsInstalled() {
        QVERIFY(!Messages::install(QLocale(QLocale::Icelandic)));
        QVERIFY(Messages::install(QLocale(QStringLiteral("de_AT"))));
        QCOMPARE(Messages::text(BURIN_TEXT("Edit", "Smooth")), QStringLiteral("Glätten"));
        for (QTranslator* installed : QCoreApplication::instance()->findChildren<QTranslator*>()) delete installed;
        QCOMPARE(Messages::text(BURIN_TEXT("Edit", "Smooth")), QStringLiteral("Smooth"));
    }

    void everyTextIsTranslated() {
        QVERIFY(!translationFiles().isEmpty());
        for (const QString& file : translationFiles()) {
            const Translations translations = read(file);
            QVERIFY(!translations.texts.isEmpty());
            QCOMPARE(translations.unfinished, QStringList());
            QCOMPARE(translations.differentPlaces, QStringList());
        }
    }

    /// If this fails, run translations/update and translate the new texts.
    void translationsHoldWhatTheSourcesSay() {
        const QTemporaryDir folder;
        for (const QString& file : translationFiles()) {
            const QString copy = folder.filePath(QFileInfo(file).fileName());
            QVERIFY(QFile::copy(file, copy));
            QProcess update;
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert(QStringLiteral("LUPDATE"), QStringLiteral(BURIN_LUPDATE));
            update.setProcessEnvironment(environment);
            update.start(QStringLiteral(BURIN_SOURCE_DIRECTORY "/translations/update"), {copy});
            QVERIFY(update.waitForFinished() && update.exitCode() == 0);
            const QSet<QString> now = read(copy).texts, kept = read(file).texts;
            QCOMPARE((now - kept).values(), QStringList());
            QCOMPARE((kept - now).values(), QStringList());
        }
    }
};

BURIN_TEST(TestMessages, QCoreApplication)

} // namespace burin::tst_messages

#include "tst_messages.moc"
