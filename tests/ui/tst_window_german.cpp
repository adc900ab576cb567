// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/places.h"
#include "tests/ui/visible_texts.h"
#include "tests/ui/window_steps.h"
#include "ui/messages/messages.h"

#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <QtTest>

using namespace burin;
using namespace burin::testing;

namespace {

const QRegularExpression& word() {
    static const QRegularExpression one(QStringLiteral("\\p{L}+(?:['’]\\p{L}+)?"));
    return one;
}

QSet<QString> wordsOf(QString text) {
    static const QRegularExpression mnemonic(QStringLiteral("&(?=\\p{L})")), place(QStringLiteral("%(L?[0-9]+|n)"));
    text.remove(mnemonic).remove(place);
    QSet<QString> words;
    for (auto found = word().globalMatch(text); found.hasNext();) words.insert(found.next().captured().toLower());
    return words;
}

/// Words of the English sources that no German translation has.
QSet<QString> onlyEnglish() {
    QSet<QString> english, german;
    QFile file(QStringLiteral(BURIN_SOURCE_DIRECTORY "/translations/burin_de.ts"));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QXmlStreamReader reader(&file);
    while (!reader.atEnd()) {
        if (reader.readNext() != QXmlStreamReader::StartElement) continue;
        if (reader.name() == QLatin1String("source"))
            english += wordsOf(reader.readElementText());
        else if (reader.name() == QLatin1String("translation") || reader.name() == QLatin1String("numerusform"))
            german += wordsOf(reader.readElementText(QXmlStreamReader::IncludeChildElements));
    }
    english -= german;
    // In texts that were never marked for translation as well.
    for (const char* common : {"the", "of", "and", "with", "is", "are", "not", "from", "were", "states", "taken"})
        english.insert(QLatin1String(common));
    return english;
}

/// Where figures come from is told in the words of the file that has them, which may be a user's own.
void collectSources(const QJsonValue& value, QStringList& sources) {
    for (const QJsonValue& each : value.toArray()) collectSources(each, sources);
    const QJsonObject object = value.toObject();
    for (auto member = object.begin(); member != object.end(); ++member) {
        if (member.key() == QLatin1String("source") && member->isString()) sources << member->toString();
        collectSources(*member, sources);
    }
}

QStringList sourcesOfFigures() {
    QStringList sources;
    QDirIterator files(QStringLiteral(BURIN_SOURCE_DIRECTORY "/resources"), {QStringLiteral("*.json")}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (!file.open(QIODevice::ReadOnly)) return {};
        const QJsonDocument document = QJsonDocument::fromJson(file.readAll());
        collectSources(document.isArray() ? QJsonValue(document.array()) : QJsonValue(document.object()), sources);
    }
    return sources;
}

} // namespace

/// The window of somebody whose language is German.
class TestWindowGerman : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void noTextOfAJobIsEnglish();
    void noTextOfAJobIsCut_data();
    void noTextOfAJobIsCut();

private:
    /// Texts that are seen now and hold an English word, each with the widget that shows it.
    QStringList englishTexts(WindowDriver& driver) const;

    QSet<QString> english_;
    QStringList sources_;
};

void TestWindowGerman::initTestCase() {
    english_ = onlyEnglish();
    QVERIFY(english_.size() > 500);
    english_.remove(QStringLiteral("block")); // the test's part is called so
    sources_ = sourcesOfFigures();
    QVERIFY(sources_.size() > 30);
    QVERIFY(Messages::install(QLocale(QStringLiteral("de"))));
}

QStringList TestWindowGerman::englishTexts(WindowDriver& driver) const {
    QStringList found;
    for (const VisibleText& shown : visibleTexts(driver.window())) {
        QString own = shown.text;
        own.remove(driver.folder().path());
        for (const QString& source : sources_) own.remove(source);
        const QSet<QString> words = wordsOf(own) & english_;
        if (!words.isEmpty()) found << shown.where + QStringLiteral(": ") + shown.text;
    }
    return found;
}

void TestWindowGerman::noTextOfAJobIsEnglish() {
    WindowDriver driver;
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    Workbench& bench = driver.window().workbench();
    QStringList english = englishTexts(driver);
    const auto look = [&](JobStep step, const char* name) {
        if (!driver.step(step)) return;
        driver.shoot(QStringLiteral("german-%1").arg(QLatin1String(name)));
        english += englishTexts(driver);
    };
    drop(driver.window(), writeBlock(driver, false)); // open: its notes and findings are told as well
    QVERIFY(driver.waitFor([&] { return bench.model.model() != nullptr; }));
    QVERIFY(driver.settle());
    look(JobStep::part, "part");
    QVERIFY(makeReady(driver));
    QVERIFY(recordLine(driver, {-10, 0}, {10, 0}));
    QVERIFY(driver.settle());
    QVERIFY(driver.step(JobStep::path) && driver.clickOn("newPathButton"));
    QVERIFY(driver.waitFor([&] { return bench.path.evaluated() != nullptr; }));
    QVERIFY(postProgram(driver));
    const std::pair<JobStep, const char*> steps[] = {{JobStep::part, "part-closed"},    {JobStep::stock, "stock"},
                                                     {JobStep::material, "material"},   {JobStep::tool, "tool"},
                                                     {JobStep::allowance, "allowance"}, {JobStep::mill, "mill"},
                                                     {JobStep::path, "path"},           {JobStep::program, "program"}};
    for (const auto& [step, name] : steps) look(step, name);
    english.removeDuplicates();
    QVERIFY2(english.isEmpty(), qPrintable(QLatin1Char('\n') + english.join(QLatin1Char('\n'))));
}

void TestWindowGerman::noTextOfAJobIsCut_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("smallest") << QSize(1024, 680);
    QTest::newRow("usual") << QSize(1280, 800);
    QTest::newRow("large") << QSize(1580, 960);
}

/// German words are the longer ones.
void TestWindowGerman::noTextOfAJobIsCut() {
    QFETCH(QSize, size);
    WindowDriver driver(size);
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    Workbench& bench = driver.window().workbench();
    QStringList cut;
    const auto look = [&] {
        QTest::qWait(200); // until panels have followed
        for (const VisibleText& text : clippedTexts(driver.window()))
            cut << text.where + QStringLiteral(": ") + text.text;
    };
    look();
    QVERIFY(makeReady(driver));
    QVERIFY(recordLine(driver, {-10, 0}, {10, 0}));
    QVERIFY(driver.settle());
    QVERIFY(driver.step(JobStep::path) && driver.clickOn("newPathButton"));
    QVERIFY(driver.waitFor([&] { return bench.path.evaluated() != nullptr; }));
    QVERIFY(postProgram(driver));
    for (int step = 0; step < JobLine::steps; ++step) {
        QVERIFY(driver.step(static_cast<JobStep>(step)));
        look();
        driver.shoot(QStringLiteral("german-%1-%2").arg(size.width()).arg(step));
    }
    cut.removeDuplicates();
    QVERIFY2(cut.isEmpty(), qPrintable(QLatin1Char('\n') + cut.join(QLatin1Char('\n'))));
}

QTEST_MAIN(TestWindowGerman)
#include "tst_window_german.moc"
