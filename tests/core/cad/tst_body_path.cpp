// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/body_path.h"
#include "core/cad/file_unit.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_body_path {

namespace {

/// "A(B(0) 1)": names of assemblies, numbers of bodies.
std::string written(const std::vector<BodyNode>& nodes) {
    std::string text;
    for (const BodyNode& node : nodes) {
        if (!text.empty()) text += " ";
        text += node.body ? std::to_string(*node.body) : node.name + "(" + written(node.children) + ")";
    }
    return text;
}

} // namespace

class TestBodyPath : public QObject {
    Q_OBJECT

private slots:
    void equalNamesAreNumbered() {
        std::vector<std::string> names{"Bolt", "Nut", "Bolt", "", "Bolt:1", ""};
        numberInstances(names);
        // "Bolt:1" is taken by a part of that name.
        QCOMPARE(names, (std::vector<std::string>{"Bolt:2", "Nut", "Bolt:3", "", "Bolt:1", ""}));
    }

    void elementsAreTakenApart() {
        QCOMPARE(pathElement("M6/20"), std::string("M6⁄20"));
        QCOMPARE(bodyPath("", "Bolt"), std::string("Bolt"));
        QCOMPARE(bodyPath("Vice/Jaws", "Bolt"), std::string("Vice/Jaws/Bolt"));
        QVERIFY(assemblyOf("Vice/Jaws/Bolt:2") == "Vice/Jaws" && assemblyOf("Bolt").empty());
        QVERIFY(lastElement("Vice/Jaws/Bolt:2") == "Bolt:2" && lastElement("Bolt") == "Bolt");
        QVERIFY(withoutInstance("Bolt:12") == "Bolt" && withoutInstance("Bolt:a") == "Bolt:a");
        QVERIFY(withoutInstance(":1") == ":1" && withoutInstance("Bolt:") == "Bolt:");
    }

    void theTreeGroupsBodies() {
        const std::vector<BodyNode> tree = bodyTree(std::vector<std::string>{"A/B/x", "A/y", "z", "A/B/w", "C/x"});
        QCOMPARE(written(tree), std::string("A(B(0 3) 1) 2 C(4)"));
        QCOMPARE(tree[0].path, std::string("A"));
        QCOMPARE(tree[0].children[0].path, std::string("A/B"));
        QCOMPARE(bodiesOf(tree[0]), (std::vector<std::size_t>{0, 3, 1}));
        QCOMPARE(written(bodyTree(std::vector<std::string>{"a", "b"})), std::string("0 1"));
    }

    /// A file may nest its assemblies as deep as it likes.
    void aDeepTreeIsCutOff() {
        std::string path;
        for (int i = 0; i < 100'000; ++i) path += "A/";
        const std::vector<BodyNode> tree = bodyTree(std::vector<std::string>{path + "x"});
        const BodyNode* node = &tree.front();
        int levels = 1;
        for (; !node->body; node = &node->children.front()) ++levels;
        QCOMPARE(levels, 32);
    }

    void unitsHaveNamesAndNumbers() {
        for (const auto& [text, scale] : {std::pair{"mm", 1.0},
                                          {"inch", 25.4},
                                          {"in", 25.4},
                                          {"m", 1000.0},
                                          {"2.5", 2.5},
                                          {"mil", 0.0254},
                                          {"µm", 0.001},
                                          {"um", 0.001}})
            QVERIFY(unitFromText(text) == scale);
        for (const char* wrong : {"", "inches", "0", "-1", "1e9", "nan", "1 mm"}) QVERIFY2(!unitFromText(wrong), wrong);
    }
};

BURIN_TEST(TestBodyPath, NoApplication)

} // namespace burin::tst_body_path

#include "tst_body_path.moc"
