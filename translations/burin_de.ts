<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Edit</name>
    <message>
        <source>Drop air cuts</source>
        <translation>Luftschnitte entfernen</translation>
    </message>
    <message>
        <source>Drop dwells</source>
        <translation>Verweilen entfernen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Hold out of the part</source>
        <translation>Aus dem Teil halten</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Vereinfachen</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Set feed and speed</source>
        <translation>Vorschub und Drehzahl setzen</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>no details are known</source>
        <translation>Näheres ist nicht bekannt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was stopped as asked; start it again to finish it.</source>
        <translation>„%1“ wurde wie gewünscht abgebrochen; starten Sie es erneut, um es abzuschließen.</translation>
    </message>
    <message>
        <source>There is not enough memory for &quot;%1&quot;; close other programs or choose larger voxels.</source>
        <translation>Der Arbeitsspeicher reicht nicht für „%1“; schließen Sie andere Programme oder wählen Sie größere Voxel.</translation>
    </message>
    <message>
        <source>Burin broke a rule of its own in &quot;%1&quot; (%2); save your work under another name and report this.</source>
        <translation>Burin hat in „%1“ eine eigene Regel verletzt (%2); speichern Sie Ihre Arbeit unter anderem Namen und melden Sie dies.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not exist; check its name and its folder.</source>
        <translation>„%1“ gibt es nicht; prüfen Sie Namen und Ordner.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can&apos;t be read (%2); check the rights of the file.</source>
        <translation>„%1“ lässt sich nicht lesen (%2); prüfen Sie die Zugriffsrechte der Datei.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can&apos;t be written (%2); check the rights of the file and its folder or choose another place.</source>
        <translation>„%1“ lässt sich nicht schreiben (%2); prüfen Sie die Zugriffsrechte von Datei und Ordner oder wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>The disk is full, so &quot;%1&quot; was not written; make room and try again.</source>
        <translation>Der Datenträger ist voll, „%1“ wurde deshalb nicht geschrieben; schaffen Sie Platz und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty; export or copy it again.</source>
        <translation>„%1“ ist leer; exportieren oder kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no format that Burin reads; export it in another one, a model as STEP.</source>
        <translation>„%1“ hat kein Format, das Burin lesen kann; exportieren Sie die Datei in einem anderen, ein Modell als STEP.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged; use a backup, or export or copy it again.</source>
        <translation>„%1“ ist beschädigt; verwenden Sie eine Sicherungskopie oder exportieren oder kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged (%2); use a backup, or export or copy it again.</source>
        <translation>„%1“ ist beschädigt (%2); verwenden Sie eine Sicherungskopie oder exportieren oder kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The value of &quot;%1&quot; can&apos;t be used; allowed is: %2.</source>
        <translation>Der Wert von „%1“ ist nicht verwendbar; erlaubt ist: %2.</translation>
    </message>
    <message>
        <source>The value &quot;%2&quot; of &quot;%1&quot; can&apos;t be used; allowed is: %3.</source>
        <translation>Der Wert „%2“ von „%1“ ist nicht verwendbar; erlaubt ist: %3.</translation>
    </message>
    <message>
        <source>No %1 is called &quot;%2&quot;; check the name.</source>
        <translation>Den Namen „%2“ gibt es nicht (%1); prüfen Sie die Schreibweise.</translation>
    </message>
    <message>
        <source>No %1 is called &quot;%2&quot;; choose one of these: %3.</source>
        <translation>Den Namen „%2“ gibt es nicht (%1); zur Wahl stehen: %3.</translation>
    </message>
    <message>
        <source>This version does not support &quot;%1&quot;; do without it.</source>
        <translation>Diese Version unterstützt „%1“ nicht; verzichten Sie darauf.</translation>
    </message>
    <message>
        <source>This version does not support &quot;%1&quot;; use &quot;%2&quot; instead.</source>
        <translation>Diese Version unterstützt „%1“ nicht; verwenden Sie stattdessen „%2“.</translation>
    </message>
    <message>
        <source>Reading &quot;%1&quot; took longer than %2 and was stopped; simplify the model or allow more time.</source>
        <translation>Das Lesen von „%1“ dauerte länger als %2 und wurde abgebrochen; vereinfachen Sie das Modell oder lassen Sie mehr Zeit zu.</translation>
    </message>
    <message>
        <source>Reading &quot;%1&quot; took more memory than %2 and was stopped; simplify the model or allow more memory.</source>
        <translation>Das Lesen von „%1“ brauchte mehr Speicher als %2 und wurde abgebrochen; vereinfachen Sie das Modell oder lassen Sie mehr Speicher zu.</translation>
    </message>
    <message>
        <source>The CAD reader failed on &quot;%1&quot; (%2); export the model again, if possible as STEP.</source>
        <translation>Der CAD-Leser ist an „%1“ gescheitert (%2); exportieren Sie das Modell noch einmal, möglichst als STEP.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no solid, but: %2; export a closed solid.</source>
        <translation>„%1“ enthält keinen Volumenkörper, sondern: %2; exportieren Sie einen geschlossenen Körper.</translation>
    </message>
    <message>
        <source>The surface of &quot;%1&quot; is open (%2); close it in your CAD program and export it again.</source>
        <translation>Die Oberfläche von „%1“ ist offen (%2); schließen Sie sie im CAD-Programm und exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Some faces of &quot;%1&quot; can&apos;t be meshed (%2); repair them in your CAD program and export it again.</source>
        <translation>Einige Flächen von „%1“ lassen sich nicht vernetzen (%2); reparieren Sie sie im CAD-Programm und exportieren Sie das Modell noch einmal.</translation>
    </message>
    <message>
        <source>A stock of %1 is too large for the limit of %2; choose larger voxels or a smaller stock.</source>
        <translation>Ein Rohteil von %1 übersteigt die Grenze von %2; wählen Sie größere Voxel oder ein kleineres Rohteil.</translation>
    </message>
    <message>
        <source>The memory reserved for the workpiece (%1 bytes) is used up; save, and go on with larger voxels.</source>
        <translation>Der für das Werkstück reservierte Speicher (%1 Byte) ist aufgebraucht; speichern Sie und arbeiten Sie mit größeren Voxeln weiter.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; reaches out of the stock (%2); enlarge the margin.</source>
        <translation>„%1“ ragt aus dem Rohteil heraus (%2); vergrößern Sie das Aufmaß.</translation>
    </message>
    <message>
        <source>The stock&apos;s &quot;%1&quot; can&apos;t be used; allowed is: %2.</source>
        <translation>„%1“ des Rohteils ist nicht verwendbar; erlaubt ist: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can&apos;t be used because of &quot;%2&quot; (%3); correct the file.</source>
        <translation>„%1“ ist wegen „%2“ nicht verwendbar (%3); berichtigen Sie die Datei.</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; was not found; check its cable and its driver.</source>
        <translation>Das Gerät „%1“ wurde nicht gefunden; prüfen Sie Kabel und Treiber.</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; reports a fault (%2); its forces are off until you connect it again.</source>
        <translation>Das Gerät „%1“ meldet einen Fehler (%2); seine Kräfte bleiben abgeschaltet, bis Sie es neu verbinden.</translation>
    </message>
    <message>
        <source>The trace &quot;%1&quot; can&apos;t be used (%2); correct it or record it again.</source>
        <translation>Die Spur „%1“ ist nicht verwendbar (%2); berichtigen Sie sie oder zeichnen Sie sie neu auf.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a Burin project; choose a file that Burin saved.</source>
        <translation>„%1“ ist kein Burin-Projekt; wählen Sie eine Datei, die Burin gespeichert hat.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was saved by a newer Burin (format %2); update Burin to open it.</source>
        <translation>„%1“ wurde von einem neueren Burin gespeichert (Format %2); aktualisieren Sie Burin, um die Datei zu öffnen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another program (%2); close it there first.</source>
        <translation>„%1“ ist in einem anderen Programm geöffnet (%2); schließen Sie die Datei zuerst dort.</translation>
    </message>
    <message>
        <source>The project lacks &quot;%1&quot;; supply it with &quot;%2&quot;.</source>
        <translation>Im Projekt fehlt „%1“; ergänzen Sie es mit „%2“.</translation>
    </message>
    <message>
        <source>The disk could not keep up, so the recording ended after %1 samples; use a faster disk.</source>
        <translation>Der Datenträger kam nicht nach, die Aufzeichnung endete deshalb nach %1 Messpunkten; verwenden Sie einen schnelleren.</translation>
    </message>
    <message>
        <source>The path &quot;%1&quot; holds no move; add a take that cuts, or switch off the edit that drops everything.</source>
        <translation>Die Bahn „%1“ enthält keine Bewegung; fügen Sie eine Aufnahme hinzu, die schneidet, oder schalten Sie die Bearbeitung ab, die alles entfernt.</translation>
    </message>
    <message>
        <source>The path &quot;%1&quot; cuts into the part (%2); hold it out of the part before it is posted.</source>
        <translation>Die Bahn „%1“ schneidet in das Teil (%2); halten Sie sie aus dem Teil heraus, bevor Sie sie ausgeben.</translation>
    </message>
    <message>
        <source>No dialect is called &quot;%1&quot;; choose one of these: %2.</source>
        <translation>Den Dialekt „%1“ gibt es nicht; zur Wahl stehen: %2.</translation>
    </message>
    <message>
        <source>The plugin &quot;%1&quot; has interface version %2, but this Burin needs %3; install the one made for it.</source>
        <translation>Die Erweiterung „%1“ hat die Schnittstellenversion %2, dieses Burin braucht aber %3; installieren Sie die passende.</translation>
    </message>
    <message>
        <source>The plugin &quot;%1&quot; can&apos;t be loaded (%2); install it again.</source>
        <translation>Die Erweiterung „%1“ lässt sich nicht laden (%2); installieren Sie sie neu.</translation>
    </message>
    <message>
        <source>The program &quot;%1&quot; can&apos;t be understood at %2 (%3); correct it there.</source>
        <translation>Das Programm „%1“ ist bei %2 nicht verständlich (%3); berichtigen Sie es dort.</translation>
    </message>
    <message>
        <source>The machine&apos;s limit of &quot;%1&quot; is broken (%2); change the path or choose another machine.</source>
        <translation>Die Grenze der Maschine für „%1“ wird verletzt (%2); ändern Sie die Bahn oder wählen Sie eine andere Maschine.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; did not pass the check (%2); correct the path and check it again.</source>
        <translation>„%1“ hat die Prüfung nicht bestanden (%2); berichtigen Sie die Bahn und prüfen Sie erneut.</translation>
    </message>
    <message>
        <source>An unknown fault occurred in &quot;%1&quot;; report this.</source>
        <translation>In „%1“ ist ein unbekannter Fehler aufgetreten; melden Sie ihn.</translation>
    </message>
</context>
<context>
    <name>Subject</name>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>embedded stock</source>
        <translation>eingebettetes Rohteil</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>a recording</source>
        <translation>eine Aufzeichnung</translation>
    </message>
    <message>
        <source>a tool</source>
        <translation>ein Werkzeug</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>edit</source>
        <translation>Bearbeitung</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>stylus</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>take</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>boundary field of a tool</source>
        <translation>Abstandsfeld eines Werkzeugs</translation>
    </message>
    <message>
        <source>exact distances</source>
        <translation>Genaue Abstände</translation>
    </message>
    <message>
        <source>milling</source>
        <translation>Fräsen</translation>
    </message>
    <message>
        <source>replaying takes</source>
        <translation>Wiederholen der Aufnahmen</translation>
    </message>
    <message>
        <source>verification</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>voxelisation</source>
        <translation>Voxelisierung</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>tilted tool axis</source>
        <translation>geneigte Werkzeugachse</translation>
    </message>
    <message>
        <source>a program with a tool change</source>
        <translation>ein Programm mit Werkzeugwechsel</translation>
    </message>
    <message>
        <source>another process</source>
        <translation>anderer Prozess</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>Prozess %1</translation>
    </message>
    <message>
        <source>command</source>
        <translation>Befehl</translation>
    </message>
</context>
</TS>
