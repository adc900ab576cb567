// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/job/damaged/trial.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTest>

#include <map>

namespace burin::tst_damaged_programs {

using namespace burin::test;

/// Some of each kind of the programs that burin_judge_damaged makes by the hundred.
class DamagedProgramsTest : public QObject {
    Q_OBJECT
private slots:
    void soundProgramsPass_data() {
        QTest::addColumn<QString>("dialect");
        for (const char* dialect : {"linuxcnc", "fanuc", "haas", "mach", "grblhal", "grbl"})
            QTest::newRow(dialect) << dialect;
    }
    void soundProgramsPass() {
        QFETCH(const QString, dialect);
        const Verdict verdict = judge(job_, sound(dialect.toStdString()), dialect.toStdString());
        QVERIFY2(verdict.passed(), verdict.text.c_str());
    }

    void damageIsFoundAtItsLine_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("number");
        for (std::size_t kind = 0; kind < damageKinds().size(); ++kind)
            for (int number = 0; number < 4; ++number)
                QTest::addRow("%s %d", std::string(damageKinds()[kind].name).c_str(), number)
                    << static_cast<int>(kind) << number;
    }
    void damageIsFoundAtItsLine() {
        QFETCH(const int, kind);
        QFETCH(const int, number);
        const DamageKind& what = damageKinds()[static_cast<std::size_t>(kind)];
        const std::string dialect(what.dialects[static_cast<std::size_t>(number) % what.dialects.size()]);
        const Damaged damaged = what.make(sound(dialect), dialect, static_cast<std::uint32_t>(number));
        QVERIFY(damaged.last > 0);
        const Verdict verdict = judge(job_, damaged.text, dialect);
        QVERIFY2(verdict.names(damaged.first, damaged.last),
                 (damaged.what + ", lines " + std::to_string(damaged.first) + " to " + std::to_string(damaged.last) +
                  ": " + verdict.text)
                     .c_str());
    }

private:
    const std::string& sound(const std::string& dialect) {
        const auto [text, isNew] = sound_.try_emplace(dialect);
        if (isNew) text->second = job_.post(dialect);
        return text->second;
    }

    TrayJob job_;
    std::map<std::string, std::string> sound_;
};

BURIN_TEST(DamagedProgramsTest, QCoreApplication)

} // namespace burin::tst_damaged_programs

#include "tst_damaged_programs.moc"
