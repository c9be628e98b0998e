<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Figures</name>
    <message>
        <source>Depth SD (mm)</source>
        <translation>Standardabweichung der Tiefe (mm)</translation>
    </message>
    <message>
        <source>Pressed depth (mm)</source>
        <translation>Eingedrückte Tiefe (mm)</translation>
    </message>
    <message>
        <source>Press depth, %1 (mm)</source>
        <translation>Eindrucktiefe, %1 (mm)</translation>
    </message>
    <message>
        <source>along the normal</source>
        <translation>entlang der Normalen</translation>
    </message>
    <message>
        <source>projected</source>
        <translation>projiziert</translation>
    </message>
    <message>
        <source>Mapping minus ball (mm)</source>
        <translation>Abbildung minus Kugel (mm)</translation>
    </message>
    <message>
        <source>Press error (mm)</source>
        <translation>Fehler des Eindrucks (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::AccuracyModel</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Time per image (ms)</source>
        <translation>Zeit pro Bild (ms)</translation>
    </message>
    <message>
        <source>Median depth error (mm)</source>
        <translation>Tiefenfehler, Median (mm)</translation>
    </message>
    <message>
        <source>Depth error, 95 % within (mm)</source>
        <translation>Tiefenfehler, 95 % innerhalb (mm)</translation>
    </message>
    <message>
        <source>Median position error (mm)</source>
        <translation>Positionsfehler, Median (mm)</translation>
    </message>
    <message>
        <source>Rating</source>
        <translation>Wertung</translation>
    </message>
    <message>
        <source>best for its time</source>
        <translation>beste in dieser Zeit</translation>
    </message>
    <message>
        <source>worse than: %1</source>
        <translation>schlechter als: %1</translation>
    </message>
    <message>
        <source>misses some images</source>
        <translation>misst nicht jedes Bild</translation>
    </message>
    <message>
        <source>in use now; %1</source>
        <translation>jetzt verwendet; %1</translation>
    </message>
    <message>
        <source>loss not visible in these images</source>
        <translation>Verlust in diesen Bildern nicht sichtbar</translation>
    </message>
</context>
<context>
    <name>alltact::AccuracyPage</name>
    <message>
        <source>Set the required speed and error. The program measures once, on images of this finger, what each setting costs in time and gains in accuracy. Then it shows one answer here.</source>
        <translation>Geben Sie Geschwindigkeit und zulässigen Fehler vor. Das Programm misst einmal an Bildern dieses Fingers, was jede Einstellung an Zeit kostet und an Genauigkeit bringt. Dann zeigt es hier eine Antwort.</translation>
    </message>
    <message>
        <source>&amp;Measure settings on this finger (about 12 s)</source>
        <translation>Einstellungen an diesem Finger &amp;messen (etwa 12 s)</translation>
    </message>
    <message>
        <source>Images per &amp;second</source>
        <translation>Bilder pro &amp;Sekunde</translation>
    </message>
    <message>
        <source>Images per second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>Maximum er&amp;ror</source>
        <translation>Maximaler Fehle&amp;r</translation>
    </message>
    <message>
        <source>Maximum error</source>
        <translation>Maximaler Fehler</translation>
    </message>
    <message>
        <source>95 % of all points have a smaller depth error.</source>
        <translation>95 % aller Punkte haben einen kleineren Tiefenfehler.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>smallest possible</source>
        <translation>so klein wie möglich</translation>
    </message>
    <message>
        <source>Restore as cali&amp;brated</source>
        <translation>Wieder wie kali&amp;briert</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Copy &amp;command</source>
        <translation>Befehl &amp;kopieren</translation>
    </message>
    <message>
        <source>The same as a command line</source>
        <translation>Dasselbe als Befehlszeile</translation>
    </message>
    <message>
        <source>Progress of measuring</source>
        <translation>Fortschritt der Messung</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>Anhal&amp;ten</translation>
    </message>
    <message>
        <source>Results so far are saved; measuring continues from there next time.</source>
        <translation>Bisherige Ergebnisse bleiben gespeichert; die nächste Messung setzt dort fort.</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>&amp;Accuracy</source>
        <translation>&amp;Genauigkeit</translation>
    </message>
    <message>
        <source>as calibrated</source>
        <translation>wie kalibriert</translation>
    </message>
    <message>
        <source>%1 ms per image; depth: half of all points within %2 mm, 95 % within %3 mm</source>
        <translation>%1 ms pro Bild; Tiefe: Hälfte der Punkte innerhalb %2 mm, 95 % innerhalb %3 mm</translation>
    </message>
    <message>
        <source>In use now.</source>
        <translation>Jetzt verwendet.</translation>
    </message>
    <message>
        <source>Change from now: %1</source>
        <translation>Anders als jetzt: %1</translation>
    </message>
    <message>
        <source>%1 ms faster than now</source>
        <translation>%1 ms schneller als jetzt</translation>
    </message>
    <message>
        <source>%1 ms slower than now</source>
        <translation>%1 ms langsamer als jetzt</translation>
    </message>
    <message>
        <source>%1 mm more accurate than now</source>
        <translation>%1 mm genauer als jetzt</translation>
    </message>
    <message>
        <source>%1 mm less accurate than now</source>
        <translation>%1 mm ungenauer als jetzt</translation>
    </message>
    <message>
        <source>Open a finger first.</source>
        <translation>Öffnen Sie zuerst einen Finger.</translation>
    </message>
    <message>
        <source>The finger is being loaded.</source>
        <translation>Der Finger wird geladen.</translation>
    </message>
    <message>
        <source>Calibrate this finger first.</source>
        <translation>Kalibrieren Sie zuerst diesen Finger.</translation>
    </message>
    <message>
        <source>Record this finger&apos;s reference first.</source>
        <translation>Nehmen Sie zuerst die Referenz dieses Fingers auf.</translation>
    </message>
    <message numerus="yes">
        <source>about %n second(s) left</source>
        <translation>
            <numerusform>noch etwa %n Sekunde</numerusform>
            <numerusform>noch etwa %n Sekunden</numerusform>
        </translation>
    </message>
    <message>
        <source>measuring the settings…</source>
        <translation>die Einstellungen werden gemessen …</translation>
    </message>
    <message>
        <source>The finger has changed since this was measured: measure again.</source>
        <translation>Der Finger hat sich seit dieser Messung geändert: Messen Sie noch einmal.</translation>
    </message>
    <message>
        <source>Measured on another computer (%1): its errors hold, its times do not.</source>
        <translation>Auf einem anderen Rechner gemessen (%1): die Fehler gelten, die Zeiten nicht.</translation>
    </message>
    <message>
        <source>Measuring was stopped: some settings are missing.</source>
        <translation>Die Messung wurde angehalten: einige Einstellungen fehlen.</translation>
    </message>
    <message>
        <source>Chosen by hand. Esc in the figure returns to the answer.</source>
        <translation>Von Hand gewählt. Esc im Diagramm kehrt zur Antwort zurück.</translation>
    </message>
    <message>
        <source>The most accurate setting within %1 ms.</source>
        <translation>Die genaueste Einstellung mit höchstens %1 ms.</translation>
    </message>
    <message>
        <source>The fastest setting with 95 % of all points within %1 mm.</source>
        <translation>Die schnellste Einstellung, bei der 95 % aller Punkte innerhalb von %1 mm liegen.</translation>
    </message>
    <message>
        <source>No setting reaches %1 mm. This is the most accurate within %2 ms.</source>
        <translation>Keine Einstellung erreicht %1 mm. Diese ist die genaueste mit höchstens %2 ms.</translation>
    </message>
    <message>
        <source>An error of %1 mm allows %2 images per second. This is the most accurate setting that is fast enough.</source>
        <translation>Ein Fehler von %1 mm erlaubt %2 Bilder pro Sekunde. Diese Einstellung ist die genaueste, die schnell genug ist.</translation>
    </message>
    <message>
        <source>No setting is that fast on this computer. This is the fastest: %1 images per second.</source>
        <translation>Keine Einstellung ist auf diesem Rechner so schnell. Diese ist die schnellste: %1 Bilder pro Sekunde.</translation>
    </message>
    <message>
        <source>No setting can measure this finger&apos;s images.</source>
        <translation>Keine Einstellung kann die Bilder dieses Fingers messen.</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>Verwendet</translation>
    </message>
    <message>
        <source>&amp;Use it</source>
        <translation>&amp;Verwenden</translation>
    </message>
    <message>
        <source>&amp;Measure again (about 12 s)</source>
        <translation>Noch einmal &amp;messen (etwa 12 s)</translation>
    </message>
    <message>
        <source>&amp;Measure missing settings</source>
        <translation>&amp;Messen, was fehlt</translation>
    </message>
    <message>
        <source>&amp;Measure setting pairs, too</source>
        <translation>Auch Paare von Einstellungen &amp;messen</translation>
    </message>
    <message>
        <source>Live, side by side</source>
        <translation>Live, nebeneinander</translation>
    </message>
    <message>
        <source>Figure, table or the live image with two settings</source>
        <translation>Diagramm, Tabelle oder Livebild mit zwei Einstellungen</translation>
    </message>
    <message>
        <source>These images cannot show its loss: their light is that of the recording.</source>
        <translation>Diese Bilder zeigen den Verlust nicht: Ihr Licht ist das der Aufnahme.</translation>
    </message>
    <message>
        <source>position: half within %1 mm</source>
        <translation>Position: Hälfte innerhalb %1 mm</translation>
    </message>
    <message>
        <source>Measures with the setting of the calibration again</source>
        <translation>Misst wieder mit der Einstellung der Kalibrierung</translation>
    </message>
    <message>
        <source>Copies the command that does the same in a terminal</source>
        <translation>Kopiert den Befehl, der dasselbe im Terminal tut</translation>
    </message>
    <message>
        <source>Ends measuring; the settings so far are shown</source>
        <translation>Beendet das Messen; die bisherigen Einstellungen werden gezeigt</translation>
    </message>
    <message>
        <source>Computes error and time of many settings from the presses</source>
        <translation>Berechnet Fehler und Zeit vieler Einstellungen aus den Eindrücken</translation>
    </message>
    <message>
        <source>This finger is measured with the chosen setting from now on; undo takes it back</source>
        <translation>Dieser Finger misst von nun an mit der gewählten Einstellung; Rückgängig nimmt es zurück</translation>
    </message>
    <message>
        <source>Computes error and time of further settings from the presses</source>
        <translation>Berechnet Fehler und Zeit weiterer Einstellungen aus den Eindrücken</translation>
    </message>
    <message>
        <source>Only settings that keep up with it are offered</source>
        <translation>Nur Einstellungen, die damit Schritt halten, werden angeboten</translation>
    </message>
</context>
<context>
    <name>alltact::AccuracyPlot</name>
    <message>
        <source>Error versus time per image</source>
        <translation>Fehler gegen Zeit pro Bild</translation>
    </message>
    <message>
        <source>Nothing has been measured yet</source>
        <translation>Noch nichts gemessen</translation>
    </message>
    <message>
        <source>No setting is chosen</source>
        <translation>Keine Einstellung gewählt</translation>
    </message>
    <message>
        <source>Time per image on this computer (ms)</source>
        <translation>Zeit pro Bild auf diesem Rechner (ms)</translation>
    </message>
    <message>
        <source>Depth error (mm)</source>
        <translation>Tiefenfehler (mm)</translation>
    </message>
    <message>
        <source>slower or worse than another</source>
        <translation>langsamer oder schlechter als eine andere</translation>
    </message>
    <message numerus="yes">
        <source>%n slower or worse, outside this figure</source>
        <translation>
            <numerusform>%n langsamer oder schlechter, außerhalb des Diagramms</numerusform>
            <numerusform>%n langsamer oder schlechter, außerhalb des Diagramms</numerusform>
        </translation>
    </message>
    <message>
        <source>best for its time; whisker up to 95 %</source>
        <translation>beste in dieser Zeit; Strich bis 95 %</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <source>in use now</source>
        <translation>jetzt verwendet</translation>
    </message>
    <message>
        <source>%1 images per second</source>
        <translation>%1 Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>%1: at %2 ms, further right →</source>
        <translation>%1: bei %2 ms, weiter rechts →</translation>
    </message>
</context>
<context>
    <name>alltact::AccuracyTable</name>
    <message>
        <source>S&amp;ort by</source>
        <translation>S&amp;ortieren nach</translation>
    </message>
    <message>
        <source>Sort by</source>
        <translation>Sortieren nach</translation>
    </message>
    <message>
        <source>Error versus time per image, as a table</source>
        <translation>Fehler gegen Zeit pro Bild, als Tabelle</translation>
    </message>
    <message>
        <source>Order of the rows below</source>
        <translation>Reihenfolge der Zeilen darunter</translation>
    </message>
</context>
<context>
    <name>alltact::AgeLabel</name>
    <message>
        <source>Image age</source>
        <translation>Alter des Bildes</translation>
    </message>
    <message>
        <source>images without timestamps</source>
        <translation>Bilder ohne Zeitstempel</translation>
    </message>
    <message>
        <source>image %1 s old</source>
        <translation>Bild %1 s alt</translation>
    </message>
    <message>
        <source>image %1 ms old</source>
        <translation>Bild %1 ms alt</translation>
    </message>
    <message>
        <source>Motion appears late. Close other programs, or choose a faster setting on the Accuracy page.</source>
        <translation>Bewegungen erscheinen verspätet. Schließen Sie andere Programme, oder wählen Sie auf der Seite Genauigkeit eine schnellere Einstellung.</translation>
    </message>
</context>
<context>
    <name>alltact::BrightnessBox</name>
    <message>
        <source>Width of the edges of the face in the image: the smaller, the sharper. A sharp image has about 2 to 4 px. Turn the lens until both ends are sharp. Best: the least of the last 30 seconds.</source>
        <translation>Breite der Kanten der Kontaktfläche im Bild: je kleiner, desto schärfer. Ein scharfes Bild hat etwa 2 bis 4 px. Am Objektiv drehen, bis beide Enden scharf sind. Bestens: der kleinste Wert der letzten 30 Sekunden.</translation>
    </message>
    <message>
        <source>Focus at the base: %1</source>
        <translation>Schärfe am Fuß: %1</translation>
    </message>
    <message>
        <source>Focus at the tip: %1</source>
        <translation>Schärfe an der Spitze: %1</translation>
    </message>
    <message>
        <source>%1 px (best: %2 px)</source>
        <translation>%1 px (bestens: %2 px)</translation>
    </message>
    <message>
        <source>no edges in view</source>
        <translation>keine Kanten im Bild</translation>
    </message>
    <message>
        <source>Pixels by grey level</source>
        <translation>Pixel nach Grauwert</translation>
    </message>
    <message>
        <source>Pixels by grey level, dark at the left. Bars in another colour at the ends are too dark or too bright to measure.</source>
        <translation>Pixel nach Grauwert, dunkle links. Andersfarbige Balken an den Enden sind zum Messen zu dunkel oder zu hell.</translation>
    </message>
    <message>
        <source>No image yet.</source>
        <translation>Noch kein Bild.</translation>
    </message>
    <message>
        <source>&lt; %1 %</source>
        <translation>&lt; %1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Face: %1 too bright, %2 too dark</source>
        <translation>Fläche: %1 zu hell, %2 zu dunkel</translation>
    </message>
    <message>
        <source>Image: %1 too bright, %2 too dark</source>
        <translation>Bild: %1 zu hell, %2 zu dunkel</translation>
    </message>
</context>
<context>
    <name>alltact::CalibratePage</name>
    <message>
        <source>&amp;Next: %1</source>
        <translation>&amp;Weiter: %1</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>&amp;Calibrate</source>
        <translation>&amp;Kalibrieren</translation>
    </message>
    <message>
        <source>Opens the next step</source>
        <translation>Öffnet den nächsten Schritt</translation>
    </message>
</context>
<context>
    <name>alltact::CalibrationRun</name>
    <message>
        <source>calibrate</source>
        <translation>kalibrieren</translation>
    </message>
</context>
<context>
    <name>alltact::CheckPage</name>
    <message>
        <source>Operator</source>
        <translation>Wer misst</translation>
    </message>
    <message>
        <source>O&amp;perator</source>
        <translation>&amp;Wer misst</translation>
    </message>
    <message>
        <source>Stored with the check: it separates operators from repetitions in a gage study.</source>
        <translation>Wird mit der Prüfung gespeichert: trennt in einer Messsystemanalyse Prüfer und Wiederholung.</translation>
    </message>
    <message>
        <source>Three presses</source>
        <translation>Drei Eindrücke</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Press the calibration ball at three positions, base, middle and tip, and take an image of each. The calibration does not change.</source>
        <translation>Drücken Sie die Kugel der Kalibrierung an drei Positionen ein, Fuß, Mitte und Spitze, und nehmen Sie jeden Eindruck auf. Die Kalibrierung bleibt unverändert.</translation>
    </message>
    <message>
        <source>&amp;Take a press (Space)</source>
        <translation>Eindruck auf&amp;nehmen (Leertaste)</translation>
    </message>
    <message>
        <source>&amp;Begin again</source>
        <translation>&amp;Von vorn beginnen</translation>
    </message>
    <message>
        <source>&amp;Check now</source>
        <translation>Jetzt &amp;prüfen</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Fortschritt der Prüfung</translation>
    </message>
    <message>
        <source>There is no live image: choose a source.</source>
        <translation>Es gibt kein Livebild: Wählen Sie eine Quelle.</translation>
    </message>
    <message>
        <source>The finger is not calibrated.</source>
        <translation>Der Finger ist nicht kalibriert.</translation>
    </message>
    <message>
        <source>The check is running.</source>
        <translation>Die Prüfung läuft.</translation>
    </message>
    <message>
        <source>take a press for the check</source>
        <translation>Eindruck für die Prüfung aufnehmen</translation>
    </message>
    <message>
        <source>check</source>
        <translation>prüfen</translation>
    </message>
    <message>
        <source>Not checked yet</source>
        <translation>Noch nicht geprüft</translation>
    </message>
    <message>
        <source>%1 of %2 taken.</source>
        <translation>%1 von %2 aufgenommen.</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Press %1</source>
        <translation>Eindruck %1</translation>
    </message>
    <message>
        <source>begin the check again</source>
        <translation>die Prüfung von vorn beginnen</translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>Ausgelassen: %1</translation>
    </message>
    <message>
        <source>The last check, on %1, tested an earlier calibration.</source>
        <translation>Die letzte Prüfung, am %1, galt einer früheren Kalibrierung.</translation>
    </message>
    <message numerus="yes">
        <source>%n press(es) taken: enough.</source>
        <translation>
            <numerusform>%n Eindruck aufgenommen: genug.</numerusform>
            <numerusform>%n Eindrücke aufgenommen: genug.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Last checked on %1 with %n press(es): error %2 mm (limit %3 mm).</source>
        <translation>
            <numerusform>Zuletzt geprüft am %1 mit %n Eindruck: Fehler %2 mm (Grenze %3 mm).</numerusform>
            <numerusform>Zuletzt geprüft am %1 mit %n Eindrücken: Fehler %2 mm (Grenze %3 mm).</numerusform>
        </translation>
    </message>
    <message>
        <source>A check needs %1 presses at different positions: press again.</source>
        <translation>Eine Prüfung braucht %1 Eindrücke an verschiedenen Positionen: Drücken Sie noch einmal.</translation>
    </message>
    <message>
        <source>Stores the present image as a press of the ball</source>
        <translation>Speichert das jetzige Bild als Eindruck der Kugel</translation>
    </message>
    <message>
        <source>Discards the presses of this check</source>
        <translation>Verwirft die Eindrücke dieser Prüfung</translation>
    </message>
    <message>
        <source>Compares the measured depth with the ball, and adds the result to the history</source>
        <translation>Vergleicht die gemessene Tiefe mit der Kugel; das Ergebnis kommt in den Verlauf</translation>
    </message>
    <message>
        <source>Your name or initials, stored with the check</source>
        <translation>Ihr Name oder Kürzel; wird mit der Prüfung gespeichert</translation>
    </message>
</context>
<context>
    <name>alltact::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Words of the command</source>
        <translation>Wörter des Befehls</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Menu or page</source>
        <translation>Menü oder Seite</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>this page</source>
        <translation>diese Seite</translation>
    </message>
    <message>
        <source>Any words of the command, in any order; Enter runs the marked one</source>
        <translation>Wörter des Befehls in beliebiger Folge; Enter führt den markierten aus</translation>
    </message>
</context>
<context>
    <name>alltact::ContactWords</name>
    <message>
        <source>Contact on the contact face</source>
        <translation>Kontakt auf der Kontaktfläche</translation>
    </message>
    <message>
        <source>Pushed from the back</source>
        <translation>Von hinten gedrückt</translation>
    </message>
    <message>
        <source>Pushed from the upper side</source>
        <translation>Von der oberen Seite gedrückt</translation>
    </message>
    <message>
        <source>Pushed from the lower side</source>
        <translation>Von der unteren Seite gedrückt</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>seit %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Längs</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>± %1°</source>
        <translation>± %1°</translation>
    </message>
    <message>
        <source>(normal to the face)</source>
        <translation>(Flächennormale)</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3</source>
        <translation>x %1, y %2, z %3</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Area %1 mm², volume %2 mm³.</source>
        <translation>Fläche %1 mm², Volumen %2 mm³.</translation>
    </message>
    <message numerus="yes">
        <source>%n contact(s) on the face.</source>
        <translation>
            <numerusform>%n Kontakt auf der Fläche.</numerusform>
            <numerusform>%n Kontakte auf der Fläche.</numerusform>
        </translation>
    </message>
    <message>
        <source>It slips or rolls over the skin.</source>
        <translation>Es rutscht oder rollt über die Haut.</translation>
    </message>
    <message>
        <source>Unknown without a reference recording.</source>
        <translation>Ohne Referenzaufnahme nicht bekannt.</translation>
    </message>
    <message>
        <source>Nothing touches the finger.</source>
        <translation>Nichts berührt den Finger.</translation>
    </message>
    <message>
        <source>The last contact lasted %1 and ended %2 ago.</source>
        <translation>Der letzte Kontakt dauerte %1 und endete vor %2.</translation>
    </message>
    <message>
        <source>It slipped.</source>
        <translation>Er ist gerutscht.</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Along: over the face from its base. Across: from its centre line towards +y. Direction: displacement of the finger in the camera&apos;s frame; its standard deviation applies within the finger&apos;s cross-section.</source>
        <translation>Längs: über die Fläche von ihrem Fuß an. Quer: von ihrer Mittellinie in Richtung +y. Richtung: Verschiebung des Fingers im Koordinatensystem der Kamera; ihre Standardabweichung gilt im Querschnitt des Fingers.</translation>
    </message>
    <message>
        <source>The finger is being loaded.</source>
        <translation>Der Finger wird geladen.</translation>
    </message>
    <message>
        <source>Open a finger to see its forces.</source>
        <translation>Öffnen Sie einen Finger, um seine Kräfte zu sehen.</translation>
    </message>
    <message>
        <source>Forces need a finger with markers.</source>
        <translation>Kräfte erfordern einen Finger mit Marken.</translation>
    </message>
    <message>
        <source>Forces need a reference recording: record one.</source>
        <translation>Kräfte erfordern eine Referenzaufnahme: Nehmen Sie eine auf.</translation>
    </message>
    <message>
        <source>No force is estimated for this image.</source>
        <translation>Für dieses Bild wird keine Kraft geschätzt.</translation>
    </message>
    <message>
        <source>This finger has no force model yet. Train one with a table of its markers and a gauge&apos;s forces:</source>
        <translation>Dieser Finger hat noch kein Kraftmodell. Trainieren Sie eines mit einer Tabelle seiner Marken und der Kräfte eines Kraftmessers:</translation>
    </message>
    <message>
        <source>Pushed from the contact face</source>
        <translation>Von der Kontaktfläche her gedrückt</translation>
    </message>
</context>
<context>
    <name>alltact::ContrastPlot</name>
    <message>
        <source>Contrast of fine relief</source>
        <translation>Kontrast feiner Strukturen</translation>
    </message>
    <message>
        <source>The resolution is not known</source>
        <translation>Die Auflösung ist nicht bekannt</translation>
    </message>
    <message>
        <source>Waves per mm of the face</source>
        <translation>Wellen pro mm der Fläche</translation>
    </message>
    <message>
        <source>Contrast of depth</source>
        <translation>Kontrast der Tiefe</translation>
    </message>
    <message>
        <source>half as deep as the skin</source>
        <translation>halb so tief wie die Haut</translation>
    </message>
</context>
<context>
    <name>alltact::ControlPanel</name>
    <message>
        <source>Automatic exposure</source>
        <translation>Belichtungsautomatik</translation>
    </message>
    <message>
        <source>Exposure time</source>
        <translation>Belichtungszeit</translation>
    </message>
    <message>
        <source>Automatic gain</source>
        <translation>Verstärkungsautomatik</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Automatic white balance</source>
        <translation>Automatischer Weißabgleich</translation>
    </message>
    <message>
        <source>White balance</source>
        <translation>Weißabgleich</translation>
    </message>
    <message>
        <source>Automatic focus</source>
        <translation>Autofokus</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source> K</source>
        <translation> K</translation>
    </message>
    <message>
        <source>Locked: unlock above to change it.</source>
        <translation>Gesperrt: Zum Ändern oben entsperren.</translation>
    </message>
    <message>
        <source>An automatic mode controls it.</source>
        <translation>Eine Automatik stellt es ein.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>&amp;Lock brightness</source>
        <translation>&amp;Helligkeit sperren</translation>
    </message>
    <message>
        <source>Automatic modes stay off; unrequested changes are undone.</source>
        <translation>Automatiken bleiben aus; ungewollte Änderungen werden zurückgesetzt.</translation>
    </message>
    <message>
        <source>Brightness is what is measured: when locked, it does not change. Unlock it only before calibrating.</source>
        <translation>Gemessen wird die Helligkeit: Gesperrt bleibt sie unverändert. Entsperren Sie sie nur vor dem Kalibrieren.</translation>
    </message>
    <message>
        <source>A camera&apos;s exposure, gain, white balance and focus appear here. This source is not a camera.</source>
        <translation>Hier erscheinen Belichtung, Verstärkung, Weißabgleich und Fokus einer Kamera. Diese Quelle ist keine Kamera.</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (USB port %2)</source>
        <translation>%1 (USB-Anschluss %2)</translation>
    </message>
    <message>
        <source>Exposure, gain, white balance and focus stay as they are; depth rests on them</source>
        <translation>Belichtung, Verstärkung, Weißabgleich und Fokus bleiben; die Tiefe beruht darauf</translation>
    </message>
</context>
<context>
    <name>alltact::ConvergencePlot</name>
    <message>
        <source>Convergence of the solution</source>
        <translation>Konvergenz der Lösung</translation>
    </message>
    <message numerus="yes">
        <source>Residual after %n round(s): %1 mm.</source>
        <translation>
            <numerusform>Rest nach %n Durchgang: %1 mm.</numerusform>
            <numerusform>Rest nach %n Durchgängen: %1 mm.</numerusform>
        </translation>
    </message>
    <message>
        <source>Convergence has not started yet</source>
        <translation>Die Konvergenz hat noch nicht begonnen</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Residual (mm)</source>
        <translation>Rest (mm)</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Change of the unknowns (mm)</source>
        <translation>Änderung der Unbekannten (mm)</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Durchgang</translation>
    </message>
</context>
<context>
    <name>alltact::CoverageView</name>
    <message>
        <source>bend away</source>
        <translation>wegbiegen</translation>
    </message>
    <message>
        <source>bend back</source>
        <translation>zurückbiegen</translation>
    </message>
    <message>
        <source>sway up</source>
        <translation>nach oben schwenken</translation>
    </message>
    <message>
        <source>sway down</source>
        <translation>nach unten schwenken</translation>
    </message>
    <message>
        <source>twist right</source>
        <translation>rechts verdrehen</translation>
    </message>
    <message>
        <source>twist left</source>
        <translation>links verdrehen</translation>
    </message>
    <message>
        <source>Coverage of bending</source>
        <translation>Abdeckung der Biegung</translation>
    </message>
    <message>
        <source>No pose seen yet.</source>
        <translation>Noch keine Haltung gesehen.</translation>
    </message>
    <message>
        <source>Enough: all directions reached.</source>
        <translation>Genug: Alle Richtungen sind erreicht.</translation>
    </message>
    <message>
        <source>Missing: %1.</source>
        <translation>Es fehlen: %1.</translation>
    </message>
</context>
<context>
    <name>alltact::EditMenu</name>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
</context>
<context>
    <name>alltact::EventStrip</name>
    <message>
        <source>Contacts, problems and depth over time</source>
        <translation>Kontakte, Probleme und Tiefe über der Zeit</translation>
    </message>
    <message numerus="yes">
        <source>%n contact(s)</source>
        <translation>
            <numerusform>%n Kontakt</numerusform>
            <numerusform>%n Kontakte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) with problems</source>
        <translation>
            <numerusform>%n Bild mit Problemen</numerusform>
            <numerusform>%n Bilder mit Problemen</numerusform>
        </translation>
    </message>
    <message>
        <source>deepest %1 mm in frame %2</source>
        <translation>größte Tiefe %1 mm in Bild %2</translation>
    </message>
    <message>
        <source>%1 of %2 frames measured</source>
        <translation>%1 von %2 Bildern gemessen</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>Tiefe, mm</translation>
    </message>
    <message>
        <source>Area, mm²</source>
        <translation>Fläche, mm²</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Kraft, N</translation>
    </message>
    <message>
        <source>Depth over time needs a calibration.</source>
        <translation>Der Tiefenverlauf braucht eine Kalibrierung.</translation>
    </message>
    <message>
        <source>The recording is being analysed.</source>
        <translation>Die Aufnahme wird ausgewertet.</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Bild %1</translation>
    </message>
</context>
<context>
    <name>alltact::ExperimentFigurePlot</name>
    <message>
        <source>Figure of an experiment</source>
        <translation>Diagramm eines Experiments</translation>
    </message>
    <message>
        <source>Nothing was measured</source>
        <translation>Es wurde nichts gemessen</translation>
    </message>
</context>
<context>
    <name>alltact::ExportDialog</name>
    <message>
        <source>Export finger</source>
        <translation>Finger exportieren</translation>
    </message>
    <message>
        <source>Data of finger %1, for other programs.</source>
        <translation>Daten des Fingers %1 für andere Programme.</translation>
    </message>
    <message>
        <source>&amp;Folder for the files</source>
        <translation>&amp;Ordner für die Dateien</translation>
    </message>
    <message>
        <source>Folder for the files</source>
        <translation>Ordner für die Dateien</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>The same as a command line</source>
        <translation>Dasselbe als Befehlszeile</translation>
    </message>
    <message>
        <source>Copy as command &amp;line</source>
        <translation>A&amp;ls Befehlszeile kopieren</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>&amp;OpenCV: camera.opencv.yaml</source>
        <translation>Open&amp;CV: camera.opencv.yaml</translation>
    </message>
    <message>
        <source>Camera matrix and distortion, for cv::FileStorage.</source>
        <translation>Kameramatrix und Verzeichnung, für cv::FileStorage.</translation>
    </message>
    <message>
        <source>&amp;ROS: camera_info.yaml and parameters.yaml</source>
        <translation>&amp;ROS: camera_info.yaml und parameters.yaml</translation>
    </message>
    <message>
        <source>The camera in the format of drivers and image_pipeline; face, markers and mapping as parameters of a ROS 2 node.</source>
        <translation>Die Kamera im Format von Treibern und image_pipeline; Fläche, Marken und Abbildung als Parameter eines ROS-2-Knotens.</translation>
    </message>
    <message>
        <source>&amp;JSON: calibration.json</source>
        <translation>&amp;JSON: calibration.json</translation>
    </message>
    <message>
        <source>All values in one file, for your own programs.</source>
        <translation>Alle Werte in einer Datei, für eigene Programme.</translation>
    </message>
    <message>
        <source>E&amp;ntire finger: finger.zip</source>
        <translation>&amp;Ganzer Finger: finger.zip</translation>
    </message>
    <message>
        <source>All files of the finger, with its untouched images: to archive, to send, and to measure with in Python.</source>
        <translation>Alle Dateien des Fingers, auch die Bilder ohne Berührung: zum Aufbewahren, zum Verschicken und zum Messen in Python.</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>Nichts ist ausgewählt.</translation>
    </message>
    <message>
        <source>No folder is chosen.</source>
        <translation>Kein Ordner ist gewählt.</translation>
    </message>
    <message>
        <source>Written: %1.</source>
        <translation>Geschrieben: %1.</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) that this finger does not use are left out of the zip.</source>
        <translation>
            <numerusform>%n Aufnahme, die dieser Finger nicht verwendet, bleibt aus der Zip-Datei weg.</numerusform>
            <numerusform>%n Aufnahmen, die dieser Finger nicht verwendet, bleiben aus der Zip-Datei weg.</numerusform>
        </translation>
    </message>
    <message>
        <source>Chooses the folder to write to</source>
        <translation>Wählt den Zielordner</translation>
    </message>
    <message>
        <source>Copies the command that does the same in a terminal</source>
        <translation>Kopiert den Befehl, der dasselbe im Terminal tut</translation>
    </message>
    <message>
        <source>Writes the ticked files</source>
        <translation>Schreibt die angehakten Dateien</translation>
    </message>
    <message>
        <source>Ends the export; no unfinished file is left</source>
        <translation>Beendet den Export; keine unfertige Datei bleibt</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>Schließt dieses Fenster (Esc)</translation>
    </message>
</context>
<context>
    <name>alltact::FaceMapPlot</name>
    <message>
        <source>%1 over the face</source>
        <translation>%1 über der Fläche</translation>
    </message>
    <message>
        <source>No data for the face yet</source>
        <translation>Noch keine Daten zur Fläche</translation>
    </message>
    <message>
        <source>Along the finger, from the base (mm)</source>
        <translation>Längs des Fingers, vom Fuß (mm)</translation>
    </message>
    <message>
        <source>Along the image, from the left (mm)</source>
        <translation>Längs des Bildes, von links (mm)</translation>
    </message>
    <message>
        <source>Across (mm)</source>
        <translation>Quer (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::FacePane</name>
    <message>
        <source>Face in 3D</source>
        <translation>Fläche in 3D</translation>
    </message>
</context>
<context>
    <name>alltact::FileFilter</name>
    <message>
        <source>Videos (%1)</source>
        <translation>Videos (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.pgm)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.pgm)</translation>
    </message>
</context>
<context>
    <name>alltact::FingerCards</name>
    <message>
        <source>Not calibrated yet</source>
        <translation>Noch nicht kalibriert</translation>
    </message>
    <message>
        <source>Calibrated; quality not stored</source>
        <translation>Kalibriert; Güte nicht gespeichert</translation>
    </message>
    <message>
        <source>Calibrated %1</source>
        <translation>Kalibriert %1</translation>
    </message>
    <message>
        <source>Calibrated %1, checked %2</source>
        <translation>Kalibriert %1, geprüft %2</translation>
    </message>
    <message>
        <source>Due: record it bending</source>
        <translation>Fällig: beim Biegen aufnehmen</translation>
    </message>
    <message>
        <source>Due: calibrate it</source>
        <translation>Fällig: kalibrieren</translation>
    </message>
    <message>
        <source>Due: a check</source>
        <translation>Fällig: eine Prüfung</translation>
    </message>
    <message>
        <source>Drifting: see the last check</source>
        <translation>Driftet: die letzte Prüfung ansehen</translation>
    </message>
    <message>
        <source>Due: calibrate it again</source>
        <translation>Fällig: neu kalibrieren</translation>
    </message>
    <message>
        <source>Nothing is due</source>
        <translation>Nichts ist fällig</translation>
    </message>
    <message>
        <source>Open the finger %1</source>
        <translation>Den Finger %1 öffnen</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>today</source>
        <translation>heute</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>gestern</translation>
    </message>
    <message numerus="yes">
        <source>%n days ago</source>
        <translation>
            <numerusform>vor %n Tag</numerusform>
            <numerusform>vor %n Tagen</numerusform>
        </translation>
    </message>
    <message>
        <source>calibrated %1</source>
        <translation>kalibriert %1</translation>
    </message>
    <message>
        <source>checked %1, error %2</source>
        <translation>geprüft %1, Fehler %2</translation>
    </message>
    <message>
        <source>Due: more presses</source>
        <translation>Fällig: weitere Eindrücke</translation>
    </message>
    <message>
        <source>Due: read its verdict</source>
        <translation>Fällig: sein Urteil lesen</translation>
    </message>
    <message>
        <source>Due: restore its reference</source>
        <translation>Fällig: Referenz wiederherstellen</translation>
    </message>
    <message>
        <source>Due: record its reference again</source>
        <translation>Fällig: Referenz neu aufnehmen</translation>
    </message>
    <message>
        <source>Due: its untouched image</source>
        <translation>Fällig: sein Bild ohne Berührung</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Show in folder</source>
        <translation>Im Ordner &amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Remove from this list</source>
        <translation>Aus dieser Liste &amp;entfernen</translation>
    </message>
</context>
<context>
    <name>alltact::FingerListDialog</name>
    <message>
        <source>&amp;Gage R&amp;&amp;R…</source>
        <translation>&amp;Gage R&amp;&amp;R…</translation>
    </message>
    <message>
        <source>Compares the checks of the selected fingers by their operators</source>
        <translation>Vergleicht die Prüfungen der gewählten Finger nach ihren Prüfern</translation>
    </message>
    <message>
        <source>All fingers</source>
        <translation>Alle Finger</translation>
    </message>
    <message>
        <source>Fingers</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Fehler, mm</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>Kalibriert</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Geprüft</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>Fällig</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Look in another folder…</source>
        <translation>In einem anderen &amp;Ordner suchen…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Reading the fingers&apos; folders…</source>
        <translation>Ordner der Finger werden gelesen…</translation>
    </message>
    <message numerus="yes">
        <source>%n finger(s), </source>
        <translation>
            <numerusform>%n Finger, </numerusform>
            <numerusform>%n Finger, </numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n with something due</source>
        <translation>
            <numerusform>bei %n ist etwas fällig</numerusform>
            <numerusform>bei %n ist etwas fällig</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder with fingers</source>
        <translation>Ordner mit Fingern</translation>
    </message>
    <message>
        <source>Opens the selected finger (Enter)</source>
        <translation>Öffnet den gewählten Finger (Enter)</translation>
    </message>
    <message>
        <source>Adds the fingers of another folder to the list</source>
        <translation>Fügt die Finger eines anderen Ordners hinzu</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>Schließt dieses Fenster (Esc)</translation>
    </message>
</context>
<context>
    <name>alltact::FingerMenu</name>
    <message>
        <source>&amp;Recent fingers</source>
        <translation>&amp;Zuletzt geöffnete Finger</translation>
    </message>
    <message>
        <source>&amp;Open finger…</source>
        <translation>Finger ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;New finger…</source>
        <translation>&amp;Neuer Finger…</translation>
    </message>
    <message>
        <source>E&amp;xport finger…</source>
        <translation>Finger e&amp;xportieren …</translation>
    </message>
    <message>
        <source>&amp;Close finger</source>
        <translation>Finger s&amp;chließen</translation>
    </message>
    <message>
        <source>Open a finger&apos;s folder</source>
        <translation>Ordner eines Fingers öffnen</translation>
    </message>
    <message>
        <source>&amp;All fingers…</source>
        <translation>&amp;Alle Finger…</translation>
    </message>
</context>
<context>
    <name>alltact::FingerPage</name>
    <message>
        <source>A flat, rigid sensor with a layer of %1 mm, %2 mm from the camera.</source>
        <translation>Ein ebener, starrer Sensor mit einer Schicht von %1 mm, %2 mm vor der Kamera.</translation>
    </message>
    <message>
        <source>A Fin Ray finger whose face is %1 mm wide, with a layer of %2 mm and %3 dots on each side.</source>
        <translation>Ein Fin-Ray-Finger mit einer %1 mm breiten Fläche, einer Schicht von %2 mm und %3 Punkten auf jeder Seite.</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Untouched finger</source>
        <translation>Unberührter Finger</translation>
    </message>
    <message>
        <source>&amp;Make the finger&apos;s folder…</source>
        <translation>Ordner des Fingers &amp;anlegen…</translation>
    </message>
    <message>
        <source>&amp;Open a finger…</source>
        <translation>Einen Finger ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Go to Record</source>
        <translation>&amp;Zu Aufnehmen</translation>
    </message>
    <message>
        <source>Take the &amp;untouched image now</source>
        <translation>Jetzt &amp;unberührt aufnehmen</translation>
    </message>
    <message>
        <source>The finger is being loaded.</source>
        <translation>Der Finger wird geladen.</translation>
    </message>
    <message>
        <source>The finger needs a folder of its own: make one, or open one.</source>
        <translation>Der Finger braucht einen eigenen Ordner: Legen Sie einen an oder öffnen Sie einen.</translation>
    </message>
    <message>
        <source>The untouched image is missing: take it.</source>
        <translation>Das Bild ohne Berührung fehlt: Nehmen Sie es auf.</translation>
    </message>
    <message>
        <source>The reference recording is missing: record the finger bending, untouched.</source>
        <translation>Die Referenzaufnahme fehlt: Nehmen Sie den unberührten Finger beim Biegen auf.</translation>
    </message>
    <message>
        <source>Measure width and layer with a caliper, and count the dots. One folder holds all data of one finger.</source>
        <translation>Messen Sie Breite und Schicht mit dem Messschieber und zählen Sie die Punkte. Ein Ordner enthält alle Daten eines Fingers.</translation>
    </message>
    <message>
        <source>The untouched image is available.</source>
        <translation>Das Bild ohne Berührung ist vorhanden.</translation>
    </message>
    <message>
        <source>The reference recording is installed.</source>
        <translation>Die Referenzaufnahme ist eingerichtet.</translation>
    </message>
    <message>
        <source>Every press is compared with one image of the untouched face.</source>
        <translation>Jeder Eindruck wird mit einem Bild der unberührten Fläche verglichen.</translation>
    </message>
    <message>
        <source>Every press is compared with an image of the finger in the same bend, untouched. Record the finger bending in all directions, then install the recording.</source>
        <translation>Jeder Eindruck wird mit einem Bild des gleich gebogenen, unberührten Fingers verglichen. Nehmen Sie ihn beim Biegen in alle Richtungen auf und richten Sie die Aufnahme ein.</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>&amp;Width of the face</source>
        <translation>B&amp;reite der Fläche</translation>
    </message>
    <message>
        <source>Width of the face</source>
        <translation>Breite der Fläche</translation>
    </message>
    <message>
        <source>&amp;Layer thickness</source>
        <translation>Di&amp;cke der Schicht</translation>
    </message>
    <message>
        <source>Layer thickness</source>
        <translation>Dicke der Schicht</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Change</source>
        <translation>Ä&amp;ndern</translation>
    </message>
    <message>
        <source>A calibrated finger then needs a new calibration.</source>
        <translation>Ein kalibrierter Finger muss danach neu kalibriert werden.</translation>
    </message>
    <message>
        <source>change the finger&apos;s sizes</source>
        <translation>die Maße des Fingers ändern</translation>
    </message>
    <message>
        <source>Untouched image from a &amp;file…</source>
        <translation>Bild ohne Berührung aus &amp;Datei…</translation>
    </message>
    <message>
        <source>Untouched image</source>
        <translation>Bild ohne Berührung</translation>
    </message>
    <message>
        <source>Stores this finger on disk, so that it can be calibrated</source>
        <translation>Speichert diesen Finger, damit er kalibriert werden kann</translation>
    </message>
    <message>
        <source>Chooses the folder of a finger that exists</source>
        <translation>Wählt den Ordner eines vorhandenen Fingers</translation>
    </message>
    <message>
        <source>There the reference of the untouched finger is recorded</source>
        <translation>Dort wird die Referenz des unberührten Fingers aufgenommen</translation>
    </message>
    <message>
        <source>The present image becomes the reference; nothing may touch the face</source>
        <translation>Das jetzige Bild wird die Referenz; nichts darf die Fläche berühren</translation>
    </message>
    <message>
        <source>A stored image of the untouched face becomes the reference</source>
        <translation>Ein gespeichertes Bild der unberührten Fläche wird die Referenz</translation>
    </message>
    <message>
        <source>From edge to edge, by caliper</source>
        <translation>Von Kante zu Kante, mit dem Messschieber</translation>
    </message>
    <message>
        <source>Of the translucent layer; no depth is larger</source>
        <translation>Der durchscheinenden Schicht; keine Tiefe ist größer</translation>
    </message>
</context>
<context>
    <name>alltact::FingerStudyRun</name>
    <message>
        <source>use other settings</source>
        <translation>andere Einstellungen verwenden</translation>
    </message>
</context>
<context>
    <name>alltact::FingerSummary</name>
    <message>
        <source>Summary of this finger</source>
        <translation>Übersicht über diesen Finger</translation>
    </message>
    <message>
        <source>Go to Record</source>
        <translation>Zu Aufnehmen gehen</translation>
    </message>
    <message>
        <source>Go to the check</source>
        <translation>Zur Prüfung gehen</translation>
    </message>
    <message>
        <source>Go to Calibrate</source>
        <translation>Zu Kalibrieren gehen</translation>
    </message>
    <message>
        <source>Opens the page of what is due for this finger</source>
        <translation>Öffnet die Seite dessen, was bei diesem Finger ansteht</translation>
    </message>
</context>
<context>
    <name>alltact::ForceBox</name>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Re-&amp;zero</source>
        <translation>Neu &amp;nullen</translation>
    </message>
    <message>
        <source>&amp;As measured</source>
        <translation>Wie &amp;gemessen</translation>
    </message>
    <message>
        <source>Forces use the model&apos;s own zero again.</source>
        <translation>Kräfte beziehen sich wieder auf den Nullpunkt des Modells.</translation>
    </message>
    <message>
        <source>Force now</source>
        <translation>Kraft jetzt</translation>
    </message>
    <message>
        <source>Zero of the forces</source>
        <translation>Nullpunkt der Kräfte</translation>
    </message>
    <message>
        <source>Force over the last half minute</source>
        <translation>Kraft in der letzten halben Minute</translation>
    </message>
    <message>
        <source>The force model was not trained on images like this one.</source>
        <translation>Das Kraftmodell wurde nicht mit ähnlichen Bildern trainiert.</translation>
    </message>
    <message>
        <source>A recording is shown as it was measured.</source>
        <translation>Eine Aufnahme wird gezeigt, wie sie gemessen wurde.</translation>
    </message>
    <message>
        <source>From now on, the mean of the last half second is the zero.</source>
        <translation>Von jetzt an ist der Mittelwert der letzten halben Sekunde der Nullpunkt.</translation>
    </message>
    <message>
        <source>No reading in range can serve as zero.</source>
        <translation>Kein Messwert im Bereich eignet sich als Nullpunkt.</translation>
    </message>
    <message>
        <source>No force is estimated for this image.</source>
        <translation>Für dieses Bild wird keine Kraft geschätzt.</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>95 % lie within ±.</source>
        <translation>95 % liegen innerhalb von ±.</translation>
    </message>
    <message>
        <source>Out of range: do not rely on it.</source>
        <translation>Außerhalb des Bereichs: Verlassen Sie sich nicht darauf.</translation>
    </message>
    <message>
        <source>Zero: the model&apos;s own.</source>
        <translation>Nullpunkt: der eigene des Modells.</translation>
    </message>
    <message>
        <source>Zero: the reading of %1, with the finger in contact.</source>
        <translation>Nullpunkt: der Messwert von %1, bei Kontakt am Finger.</translation>
    </message>
    <message>
        <source>Zero: the reading of %1.</source>
        <translation>Nullpunkt: der Messwert von %1.</translation>
    </message>
    <message>
        <source>re-zero the force</source>
        <translation>Kraft neu nullen</translation>
    </message>
    <message>
        <source>show the force as measured</source>
        <translation>Kraft wie gemessen zeigen</translation>
    </message>
    <message>
        <source>Train the forces…</source>
        <translation>Kräfte trainieren…</translation>
    </message>
    <message>
        <source>Makes a force model from a table of markers and a gauge&apos;s forces</source>
        <translation>Erstellt ein Kraftmodell aus einer Tabelle der Marken und der Kräfte eines Kraftmessers</translation>
    </message>
</context>
<context>
    <name>alltact::ForcePlot</name>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
</context>
<context>
    <name>alltact::FrameStrip</name>
    <message>
        <source>Frames of the recording</source>
        <translation>Bilder der Aufnahme</translation>
    </message>
    <message>
        <source>used</source>
        <translation>verwendet</translation>
    </message>
    <message>
        <source>same pose as others</source>
        <translation>gleiche Haltung wie andere</translation>
    </message>
    <message>
        <source>contact, certain or possible</source>
        <translation>Kontakt, sicher oder möglich</translation>
    </message>
    <message>
        <source>left out by you</source>
        <translation>von Ihnen weggelassen</translation>
    </message>
    <message>
        <source>no face or markers</source>
        <translation>ohne Fläche oder Marker</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Frame %1: %2</source>
        <translation>Bild %1: %2</translation>
    </message>
    <message>
        <source>Frame %1, the rest pose: %2</source>
        <translation>Bild %1, die Ruhelage: %2</translation>
    </message>
    <message>
        <source>represented by neighbouring frames</source>
        <translation>durch benachbarte Bilder vertreten</translation>
    </message>
</context>
<context>
    <name>alltact::GageDialog</name>
    <message>
        <source>Table of readings</source>
        <translation>Tabelle der Messwerte</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.tsv)</source>
        <translation>Tabellen (*.csv *.txt *.tsv)</translation>
    </message>
    <message>
        <source>Gage R&amp;R</source>
        <translation>Gage R&amp;R</translation>
    </message>
    <message>
        <source>How much of the variation of measured depths comes from measuring: from operators, and from repetitions. A reading is the mean depth error of one check; each operator checks each finger two times or more.</source>
        <translation>Wie viel der Streuung gemessener Tiefen vom Messen kommt: von den Prüfern und vom Wiederholen. Ein Messwert ist die mittlere Tiefenabweichung einer Prüfung; jeder Prüfer prüft jeden Finger zweimal oder öfter.</translation>
    </message>
    <message>
        <source>&amp;Tolerance</source>
        <translation>&amp;Toleranz</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Width of the tolerance that is measured with the fingers</source>
        <translation>Breite der Toleranz, die mit den Fingern gemessen wird</translation>
    </message>
    <message>
        <source>Variation by source</source>
        <translation>Streuung nach Ursache</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>Varianzanalyse</translation>
    </message>
    <message>
        <source>&amp;From a table…</source>
        <translation>&amp;Aus einer Tabelle…</translation>
    </message>
    <message>
        <source>With the columns part, operator and value_mm</source>
        <translation>Mit den Spalten part, operator und value_mm</translation>
    </message>
    <message>
        <source>C&amp;opy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>Reading the checks…</source>
        <translation>Prüfungen werden gelesen…</translation>
    </message>
    <message>
        <source>No result.</source>
        <translation>Kein Ergebnis.</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>SD, mm</source>
        <translation>Std.-Abw., mm</translation>
    </message>
    <message>
        <source>95 %, mm</source>
        <translation>95 %, mm</translation>
    </message>
    <message>
        <source>% of total</source>
        <translation>% der Streuung</translation>
    </message>
    <message>
        <source>% of tolerance</source>
        <translation>% der Toleranz</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Repeatability</source>
        <translation>Wiederholbarkeit</translation>
    </message>
    <message>
        <source>Reproducibility</source>
        <translation>Vergleichbarkeit</translation>
    </message>
    <message>
        <source>Operators</source>
        <translation>Prüfer</translation>
    </message>
    <message>
        <source>Parts × operators</source>
        <translation>Teile × Prüfer</translation>
    </message>
    <message>
        <source>Parts × operators (pooled)</source>
        <translation>Teile × Prüfer (zusammengefasst)</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Gesamt</translation>
    </message>
    <message>
        <source>Repetitions</source>
        <translation>Wiederholungen</translation>
    </message>
    <message>
        <source>df</source>
        <translation>FG</translation>
    </message>
    <message>
        <source>SS</source>
        <translation>QS</translation>
    </message>
    <message>
        <source>MS</source>
        <translation>MQ</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n Teil</numerusform>
            <numerusform>%n Teile</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n operator(s)</source>
        <translation>
            <numerusform>%n Prüfer</numerusform>
            <numerusform>%n Prüfer</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n repeat(s)</source>
        <translation>
            <numerusform>%n Wiederholung</numerusform>
            <numerusform>%n Wiederholungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n distinct categorie(s)</source>
        <translation>
            <numerusform>%n unterscheidbare Klasse</numerusform>
            <numerusform>%n unterscheidbare Klassen</numerusform>
        </translation>
    </message>
    <message>
        <source>Copies both tables for a spreadsheet</source>
        <translation>Kopiert beide Tabellen für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>Schließt dieses Fenster (Esc)</translation>
    </message>
</context>
<context>
    <name>alltact::GripperDialog</name>
    <message>
        <source>%1 in the gripper</source>
        <translation>%1 im Greifer</translation>
    </message>
    <message>
        <source>Pose of the camera of %1 in the gripper&apos;s frame: its position and its rotation about the gripper&apos;s axes, first x, then y, then z. A camera without rotation looks along the gripper&apos;s z; x runs along its image, y across it.</source>
        <translation>Lage der Kamera von %1 im Koordinatensystem des Greifers: ihre Position und ihre Drehung um die Achsen des Greifers, erst x, dann y, dann z. Ohne Drehung blickt die Kamera entlang z des Greifers; x verläuft längs, y quer zu ihrem Bild.</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>&amp;Position</translation>
    </message>
    <message>
        <source>Ro&amp;tation about</source>
        <translation>&amp;Drehung um</translation>
    </message>
    <message>
        <source>Position, x</source>
        <translation>Position, x</translation>
    </message>
    <message>
        <source>Position, y</source>
        <translation>Position, y</translation>
    </message>
    <message>
        <source>Position, z</source>
        <translation>Position, z</translation>
    </message>
    <message>
        <source>Rotation about x</source>
        <translation>Drehung um x</translation>
    </message>
    <message>
        <source>Rotation about y</source>
        <translation>Drehung um y</translation>
    </message>
    <message>
        <source>Rotation about z</source>
        <translation>Drehung um z</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>&amp;Setzen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Not known</source>
        <translation>&amp;Nicht bekannt</translation>
    </message>
    <message>
        <source>Removes the pose from the finger&apos;s file.</source>
        <translation>Entfernt die Lage aus der Datei des Fingers.</translation>
    </message>
    <message>
        <source>Both fingers are shown in the gripper&apos;s frame</source>
        <translation>Beide Finger werden im Koordinatensystem des Greifers gezeigt</translation>
    </message>
    <message>
        <source>Closes this window without a change (Esc)</source>
        <translation>Schließt dieses Fenster ohne Änderung (Esc)</translation>
    </message>
    <message>
        <source>Of the camera, in the gripper&apos;s frame</source>
        <translation>Der Kamera, im Koordinatensystem des Greifers</translation>
    </message>
    <message>
        <source>Of the camera, about the gripper&apos;s axis; x first, then y, then z</source>
        <translation>Der Kamera, um die Achse des Greifers; erst x, dann y, dann z</translation>
    </message>
</context>
<context>
    <name>alltact::GuideWords</name>
    <message>
        <source>Press here, %1 mm deep</source>
        <translation>Hier eindrücken, %1 mm tief</translation>
    </message>
    <message>
        <source>Enough presses: another would hardly help.</source>
        <translation>Genug Eindrücke: Ein weiterer bringt kaum etwas.</translation>
    </message>
    <message>
        <source>now %1 mm: deeper</source>
        <translation>jetzt %1 mm: tiefer</translation>
    </message>
    <message>
        <source>now %1 mm: enough, hold still</source>
        <translation>jetzt %1 mm: genug, stillhalten</translation>
    </message>
    <message>
        <source>now %1 mm: too deep</source>
        <translation>jetzt %1 mm: zu tief</translation>
    </message>
    <message>
        <source>now %1 mm, %2 mm from the target</source>
        <translation>jetzt %1 mm, %2 mm vom Ziel entfernt</translation>
    </message>
    <message>
        <source>The press is taken once ball and finger are held still.</source>
        <translation>Der Eindruck wird aufgenommen, sobald Kugel und Finger stillgehalten werden.</translation>
    </message>
    <message>
        <source>Not taken: hold ball and finger still for half a second.</source>
        <translation>Nicht aufgenommen: Halten Sie Kugel und Finger eine halbe Sekunde still.</translation>
    </message>
</context>
<context>
    <name>alltact::HeaderBar</name>
    <message>
        <source>Finger:</source>
        <translation>Finger:</translation>
    </message>
    <message>
        <source>Source:</source>
        <translation>Quelle:</translation>
    </message>
    <message>
        <source>Finger: %1</source>
        <translation>Finger: %1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Quelle: %1</translation>
    </message>
    <message>
        <source>none</source>
        <comment>finger</comment>
        <translation>keiner</translation>
    </message>
    <message>
        <source>%1 (loading)</source>
        <translation>%1 (wird geladen)</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1 (simuliert)</translation>
    </message>
    <message>
        <source>Opens a camera, a recording or the simulated finger</source>
        <translation>Öffnet eine Kamera, eine Aufnahme oder den simulierten Finger</translation>
    </message>
</context>
<context>
    <name>alltact::HelpMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Help on this page</source>
        <translation>&amp;Hilfe zu dieser Seite</translation>
    </message>
    <message>
        <source>&amp;About AllTact Studio</source>
        <translation>&amp;Über AllTact Studio</translation>
    </message>
    <message>
        <source>About AllTact Studio</source>
        <translation>Über AllTact Studio</translation>
    </message>
    <message>
        <source>## AllTact Studio %1

Turns a clear silicone finger with a camera inside into a measuring instrument.

Its own source is under the BSD-3-Clause licence; with the libraries it uses, the entire program is under the GPL, version 3.</source>
        <translation>## AllTact Studio %1

Macht aus einem klaren Silikonfinger mit einer Kamera darin ein Messgerät.

Der eigene Quelltext steht unter der BSD-3-Clause-Lizenz; mit den verwendeten Bibliotheken steht das gesamte Programm unter der GPL, Version 3.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>&amp;Wörterverzeichnis</translation>
    </message>
    <message>
        <source>&amp;Quick guide to print…</source>
        <translation>Kurzanleitung zum &amp;Drucken…</translation>
    </message>
    <message>
        <source>Save the quick guide</source>
        <translation>Kurzanleitung speichern</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>PDF-Dateien (*.pdf)</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>Schließt dieses Fenster (Esc)</translation>
    </message>
</context>
<context>
    <name>alltact::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Glossary</source>
        <translation>Wörterverzeichnis</translation>
    </message>
    <message>
        <source>Effects of scenes</source>
        <translation>Effekte von Szenen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>Schließt dieses Fenster (Esc)</translation>
    </message>
</context>
<context>
    <name>alltact::HistogramPlot</name>
    <message>
        <source>Distribution of errors</source>
        <translation>Verteilung der Fehler</translation>
    </message>
    <message>
        <source>95 % of the errors are below %1 mm.</source>
        <translation>95 % der Fehler liegen unter %1 mm.</translation>
    </message>
    <message>
        <source>No errors to show yet</source>
        <translation>Noch keine Fehler zu zeigen</translation>
    </message>
    <message>
        <source>Share of all blocks (%)</source>
        <translation>Anteil aller Blöcke (%)</translation>
    </message>
    <message>
        <source>95 % within
± %1 mm</source>
        <translation>95 % innerhalb
± %1 mm</translation>
    </message>
</context>
<context>
    <name>alltact::HistoryPlot</name>
    <message>
        <source>Checks over time</source>
        <translation>Prüfungen im Lauf der Zeit</translation>
    </message>
    <message>
        <source>Not checked yet since the calibration</source>
        <translation>Seit der Kalibrierung noch nicht geprüft</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>drifting</source>
        <translation>driftet</translation>
    </message>
    <message>
        <source>recalibrate</source>
        <translation>neu kalibrieren</translation>
    </message>
    <message>
        <source>Time (UTC)</source>
        <translation>Zeit (UTC)</translation>
    </message>
    <message>
        <source>Depth error (mm)</source>
        <translation>Tiefenfehler (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::ImageView</name>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The camera&apos;s image. The wheel or + and - zoom, 0 shows all of it, 1 its original size. Drag or use the arrow keys to move it; Shift and the arrow keys move the probe.</source>
        <translation>Das Bild der Kamera. Rad oder + und - zoomen, 0 zeigt alles, 1 die Originalgröße. Ziehen oder Pfeiltasten verschieben es; Umschalt und Pfeiltasten bewegen die Sonde.</translation>
    </message>
</context>
<context>
    <name>alltact::InspectPane</name>
    <message>
        <source>Difference, mm</source>
        <translation>Unterschied, mm</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>Tiefe, mm</translation>
    </message>
    <message>
        <source>There is nothing to compare with in this frame.</source>
        <translation>In diesem Bild gibt es nichts zum Vergleichen.</translation>
    </message>
    <message>
        <source>The frame is being measured again for the comparison.</source>
        <translation>Das Bild wird zum Vergleich noch einmal gemessen.</translation>
    </message>
    <message>
        <source>at the layer&apos;s limit</source>
        <translation>an der Grenze der Schicht</translation>
    </message>
    <message>
        <source>beyond the calibrated range</source>
        <translation>jenseits des Kalibrierten</translation>
    </message>
    <message>
        <source>doubtful light</source>
        <translation>zweifelhaftes Licht</translation>
    </message>
    <message>
        <source>steep: position matters</source>
        <translation>steil: Position entscheidend</translation>
    </message>
    <message>
        <source>Distance, mm</source>
        <translation>Abstand, mm</translation>
    </message>
</context>
<context>
    <name>alltact::InspectPage</name>
    <message>
        <source>&amp;Live finger</source>
        <translation>&amp;Live-Finger</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Was gezeigt wird</translation>
    </message>
    <message>
        <source>Deepest contact</source>
        <translation>Tiefster Kontakt</translation>
    </message>
    <message>
        <source>What was saved</source>
        <translation>Was gespeichert wurde</translation>
    </message>
    <message>
        <source>set point B</source>
        <translation>Punkt B setzen</translation>
    </message>
    <message>
        <source>set point A</source>
        <translation>Punkt A setzen</translation>
    </message>
    <message>
        <source>Shown: the live finger</source>
        <translation>Gezeigt: der Live-Finger</translation>
    </message>
    <message>
        <source>Shown: %1</source>
        <translation>Gezeigt: %1</translation>
    </message>
    <message>
        <source>The finger is not calibrated yet, so brightness gives no depth.</source>
        <translation>Der Finger ist noch nicht kalibriert; aus der Helligkeit lässt sich keine Tiefe bestimmen.</translation>
    </message>
    <message>
        <source>The face was not found in this image.</source>
        <translation>In diesem Bild wurde die Fläche nicht gefunden.</translation>
    </message>
    <message>
        <source>The finger is being loaded.</source>
        <translation>Der Finger wird geladen.</translation>
    </message>
    <message>
        <source>Nothing can be shown; the reason is above.</source>
        <translation>Es kann nichts angezeigt werden; der Grund steht oben.</translation>
    </message>
    <message>
        <source>The recording is being opened.</source>
        <translation>Die Aufnahme wird geöffnet.</translation>
    </message>
    <message>
        <source>No source is open. Choose one above, or open a recording.</source>
        <translation>Keine Quelle ist geöffnet. Wählen Sie oben eine, oder öffnen Sie eine Aufnahme.</translation>
    </message>
    <message>
        <source>No finger is open. Open the visible finger above.</source>
        <translation>Kein Finger ist geöffnet. Öffnen Sie oben den sichtbaren Finger.</translation>
    </message>
    <message>
        <source>Waiting for the first image.</source>
        <translation>Warten auf das erste Bild.</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>Video öffnen</translation>
    </message>
    <message>
        <source>Open a folder of images</source>
        <translation>Ordner mit Bildern öffnen</translation>
    </message>
    <message>
        <source>Save what is shown</source>
        <translation>Anzeige speichern</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>show all again</source>
        <translation>alles wieder zeigen</translation>
    </message>
    <message>
        <source>turn the 3D view</source>
        <translation>3D-Ansicht drehen</translation>
    </message>
    <message>
        <source>inspect %1</source>
        <translation>%1 auswerten</translation>
    </message>
    <message>
        <source>continue the last inspection</source>
        <translation>die letzte Auswertung fortsetzen</translation>
    </message>
    <message>
        <source>inspect the live finger</source>
        <translation>den Finger live auswerten</translation>
    </message>
    <message>
        <source>1: %1, 2: %2, in the gripper&apos;s frame X, Y, Z</source>
        <translation>1: %1, 2: %2, im Koordinatensystem X, Y, Z des Greifers</translation>
    </message>
    <message>
        <source>pose of %1 in the gripper</source>
        <translation>Lage von %1 im Greifer</translation>
    </message>
    <message>
        <source>The camera pose of %1 in the gripper is not known, so each finger is shown in its own camera&apos;s frame.</source>
        <translation>Die Lage der Kamera von %1 im Greifer ist nicht bekannt; deshalb wird jeder Finger im Koordinatensystem seiner eigenen Kamera gezeigt.</translation>
    </message>
    <message>
        <source>Enter its position and rotation.</source>
        <translation>Geben Sie ihre Position und Drehung an.</translation>
    </message>
    <message>
        <source>Pose of &amp;2…</source>
        <translation>Lage von &amp;2…</translation>
    </message>
    <message>
        <source>Pose of &amp;1…</source>
        <translation>Lage von &amp;1…</translation>
    </message>
    <message>
        <source>show a second finger</source>
        <translation>einen zweiten Finger zeigen</translation>
    </message>
    <message>
        <source>close the second finger</source>
        <translation>den zweiten Finger schließen</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Auswerten</translation>
    </message>
    <message>
        <source>&amp;Inspect</source>
        <translation>A&amp;uswerten</translation>
    </message>
    <message>
        <source>Vide&amp;o…</source>
        <translation>Vid&amp;eo…</translation>
    </message>
    <message>
        <source>Under the pointer</source>
        <translation>Unter dem Zeiger</translation>
    </message>
    <message>
        <source>Compared with: %1</source>
        <translation>Verglichen mit: %1</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Shown minus: %1</source>
        <translation>Gezeigt minus: %1</translation>
    </message>
    <message>
        <source>Not calibrated yet: the shape of the entire finger, without depth</source>
        <translation>Noch nicht kalibriert: die Form des ganzen Fingers, ohne Tiefe</translation>
    </message>
    <message>
        <source>Point at the face to see its values here.</source>
        <translation>Zeigen Sie auf die Fläche, um ihre Werte hier zu sehen.</translation>
    </message>
    <message>
        <source>The recording was opened with the finger in %1. It is measured with the finger in %2 now.</source>
        <translation>Die Aufnahme wurde mit dem Finger in %1 geöffnet. Sie wird jetzt mit dem Finger in %2 gemessen.</translation>
    </message>
    <message>
        <source>&amp;Close the recording</source>
        <translation>Aufnahme s&amp;chließen</translation>
    </message>
    <message>
        <source>%1, %2 mm rms off</source>
        <translation>%1, Abstand %2 mm rms</translation>
    </message>
    <message>
        <source>Shows the open source instead of a recording</source>
        <translation>Zeigt die offene Quelle statt einer Aufnahme</translation>
    </message>
    <message>
        <source>Inspects a recorded video of this finger</source>
        <translation>Wertet ein aufgenommenes Video dieses Fingers aus</translation>
    </message>
    <message>
        <source>Inspects a folder of images of this finger</source>
        <translation>Wertet einen Ordner von Bildern dieses Fingers aus</translation>
    </message>
    <message>
        <source>Distance of the skin from: %1</source>
        <translation>Abstand der Haut von: %1</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Ordner mit Aufnahmen</translation>
    </message>
    <message>
        <source>Lists the recordings in this finger&apos;s folder</source>
        <translation>Zeigt die Aufnahmen im Ordner dieses Fingers</translation>
    </message>
    <message>
        <source>compare with the body %1</source>
        <translation>Vergleichen mit dem Körper %1</translation>
    </message>
    <message>
        <source>&amp;Images…</source>
        <translation>B&amp;ilder…</translation>
    </message>
    <message>
        <source>Recordings…</source>
        <translation>Aufnahmen…</translation>
    </message>
</context>
<context>
    <name>alltact::InspectSide</name>
    <message>
        <source>Cross-section</source>
        <translation>Querschnitt</translation>
    </message>
</context>
<context>
    <name>alltact::InspectionResults</name>
    <message>
        <source>Fail: readings are outside of their tolerance.</source>
        <translation>Nicht bestanden: Messwerte liegen außerhalb ihrer Toleranz.</translation>
    </message>
    <message>
        <source>Undecided: readings are closer to a limit than their uncertainty allows to decide.</source>
        <translation>Unentschieden: Messwerte liegen näher an einer Grenze, als ihre Unsicherheit zu entscheiden erlaubt.</translation>
    </message>
    <message>
        <source>Undecided: some frames could not be read.</source>
        <translation>Unentschieden: Einige Bilder konnten nicht gemessen werden.</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>%1/frame</source>
        <translation>%1/Bild</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Readings of all frames</source>
        <translation>Messungen aller Bilder</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Kleinster</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Trend</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Undecided</source>
        <translation>Unentschieden</translation>
    </message>
    <message>
        <source>Progress of the inspection</source>
        <translation>Fortschritt der Auswertung</translation>
    </message>
    <message>
        <source>The selected reading over the frames</source>
        <translation>Die gewählte Messung über den Bildern</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Stopp</translation>
    </message>
    <message>
        <source>Save &amp;table (CSV)…</source>
        <translation>&amp;Tabelle speichern (CSV)…</translation>
    </message>
    <message>
        <source>Save &amp;report (PDF)…</source>
        <translation>&amp;Bericht speichern (PDF)…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>The frames are being measured…</source>
        <translation>Die Bilder werden gemessen…</translation>
    </message>
    <message>
        <source>Nothing was inspected.</source>
        <translation>Es wurde nichts ausgewertet.</translation>
    </message>
    <message>
        <source>Save the inspection</source>
        <translation>Auswertung speichern</translation>
    </message>
    <message>
        <source>Written: %1.</source>
        <translation>Geschrieben: %1.</translation>
    </message>
    <message numerus="yes">
        <source>Pass: all readings of %n frame(s) are within their tolerances with 95 % certainty each.</source>
        <translation>
            <numerusform>Bestanden: Alle Messwerte von %n Bild liegen mit je 95 % Sicherheit in ihren Toleranzen.</numerusform>
            <numerusform>Bestanden: Alle Messwerte von %n Bildern liegen mit je 95 % Sicherheit in ihren Toleranzen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s), no tolerances.</source>
        <translation>
            <numerusform>%n Bild, keine Toleranzen.</numerusform>
            <numerusform>%n Bilder, keine Toleranzen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Ends the inspection without a result</source>
        <translation>Beendet die Auswertung ohne Ergebnis</translation>
    </message>
    <message>
        <source>The table that alltact inspect writes, to the byte</source>
        <translation>Die Tabelle, die alltact inspect schreibt, Byte für Byte</translation>
    </message>
    <message>
        <source>A PDF to sign, in English</source>
        <translation>Ein PDF zum Unterschreiben, auf Englisch</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>Schließt dieses Fenster (Esc)</translation>
    </message>
    <message>
        <source>Readin&amp;gs</source>
        <translation>&amp;Messungen</translation>
    </message>
    <message>
        <source>&amp;Frames</source>
        <translation>&amp;Bilder</translation>
    </message>
    <message>
        <source>Results of the inspection</source>
        <translation>Ergebnisse der Auswertung</translation>
    </message>
    <message>
        <source>Readings of each frame</source>
        <translation>Messungen jedes Bilds</translation>
    </message>
    <message>
        <source>A frame that is selected here is shown on the page Inspect.</source>
        <translation>Ein hier gewähltes Bild wird auf der Seite Auswerten gezeigt.</translation>
    </message>
    <message>
        <source>C&amp;opy frames</source>
        <translation>Bilder k&amp;opieren</translation>
    </message>
    <message>
        <source>Copies the selected frames, or all, for a spreadsheet.</source>
        <translation>Kopiert die gewählten Bilder, oder alle, für eine Tabellenkalkulation.</translation>
    </message>
</context>
<context>
    <name>alltact::LocalText</name>
    <message>
        <source>, </source>
        <comment>between things of one kind</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>, </source>
        <comment>between parts of a sentence</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>; </source>
        <comment>between clauses</comment>
        <translation>; </translation>
    </message>
    <message>
        <source>: </source>
        <comment>after what names the next</comment>
        <translation>: </translation>
    </message>
    <message>
        <source>under %1</source>
        <comment>of a standard deviation</comment>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <comment>of a standard deviation</comment>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
</context>
<context>
    <name>alltact::LampPanel</name>
    <message>
        <source>Dimmer</source>
        <translation>Dimmer</translation>
    </message>
    <message>
        <source>The lamp&apos;s dimmer</source>
        <translation>Dimmer der Lampe</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search for dimmers</source>
        <translation>Nach Dimmern suchen</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>The dimmer&apos;s output</source>
        <translation>Ausgang des Dimmers</translation>
    </message>
    <message>
        <source>MCP2221A, pin GP2</source>
        <translation>MCP2221A, Pin GP2</translation>
    </message>
    <message>
        <source>MCP2221A, pin GP3</source>
        <translation>MCP2221A, Pin GP3</translation>
    </message>
    <message>
        <source>Custom report</source>
        <translation>Eigener Report</translation>
    </message>
    <message>
        <source>Report that sets the brightness</source>
        <translation>Report, der die Helligkeit setzt</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>The lamp&apos;s brightness</source>
        <translation>Helligkeit der Lampe</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Set to %1 %. Every image records it.</source>
        <translation>Auf %1 % gesetzt. Jedes Bild enthält den Wert.</translation>
    </message>
    <message>
        <source>The dimmer is being set.</source>
        <translation>Der Dimmer wird gesetzt.</translation>
    </message>
    <message>
        <source>Choose the device that dims the finger&apos;s lamp, if there is one.</source>
        <translation>Wählen Sie das Gerät, das die Lampe des Fingers dimmt, falls es eines gibt.</translation>
    </message>
    <message>
        <source>USB device that dims the lamp; none leaves the lamp alone</source>
        <translation>USB-Gerät, das die Lampe dimmt; ohne bleibt die Lampe, wie sie ist</translation>
    </message>
    <message>
        <source>Lists the dimmers that are plugged in now</source>
        <translation>Listet die jetzt angeschlossenen Dimmer auf</translation>
    </message>
    <message>
        <source>The pin or report that the lamp is connected to</source>
        <translation>Der Anschluss oder Report, an dem die Lampe hängt</translation>
    </message>
    <message>
        <source>Number, bytes and range of the HID report that sets the brightness</source>
        <translation>Nummer, Bytes und Bereich des HID-Reports für die Helligkeit</translation>
    </message>
    <message>
        <source>In per cent; every recorded image stores it</source>
        <translation>In Prozent; jedes aufgenommene Bild speichert sie</translation>
    </message>
</context>
<context>
    <name>alltact::LensForm</name>
    <message>
        <source>Ga&amp;p / side of tags</source>
        <translation>Lü&amp;cke / Seite der Tags</translation>
    </message>
    <message>
        <source>Gap of two tags as a fraction of their side</source>
        <translation>Lücke zweier Tags als Bruchteil ihrer Seite</translation>
    </message>
    <message>
        <source>The spacing printed on the board, such as 0.3</source>
        <translation>Der auf der Tafel gedruckte Abstand (spacing), etwa 0,3</translation>
    </message>
    <message>
        <source>&amp;Board</source>
        <translation>&amp;Tafel</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>ChArUco-Tafel</translation>
    </message>
    <message>
        <source>Grid of dots</source>
        <translation>Punktraster</translation>
    </message>
    <message>
        <source>Inner corners in a row</source>
        <translation>Innere Ecken in einer Zeile</translation>
    </message>
    <message>
        <source>Inner corners in a column</source>
        <translation>Innere Ecken in einer Spalte</translation>
    </message>
    <message>
        <source>by</source>
        <translation>mal</translation>
    </message>
    <message>
        <source>&amp;Side of a square</source>
        <translation>&amp;Seite eines Felds</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Seite eines Felds</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>standard (Brown)</source>
        <translation>Standard (Brown)</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>Fischauge</translation>
    </message>
    <message>
        <source>Finger distance</source>
        <translation>Abstand des Fingers</translation>
    </message>
    <message>
        <source>Distance from the lens to the finger&apos;s middle</source>
        <translation>Abstand vom Objektiv zur Mitte des Fingers</translation>
    </message>
    <message>
        <source>The finger lies behind a window</source>
        <translation>Der Finger liegt hinter einem Fenster</translation>
    </message>
    <message>
        <source>Tick this if the finger is seen through a plate into silicone, but the board was in air</source>
        <translation>Ankreuzen, wenn der Finger durch eine Platte in Silikon zu sehen ist, die Tafel aber in Luft war</translation>
    </message>
    <message>
        <source>Air gap</source>
        <translation>Luftspalt</translation>
    </message>
    <message>
        <source>Air between lens and window</source>
        <translation>Luft zwischen Objektiv und Fenster</translation>
    </message>
    <message>
        <source>Window thickness</source>
        <translation>Fensterdicke</translation>
    </message>
    <message>
        <source>Thickness of the window</source>
        <translation>Dicke des Fensters</translation>
    </message>
    <message>
        <source>Window index</source>
        <translation>Index des Fensters</translation>
    </message>
    <message>
        <source>Refractive index of the window</source>
        <translation>Brechungsindex des Fensters</translation>
    </message>
    <message>
        <source>Index behind it</source>
        <translation>Index dahinter</translation>
    </message>
    <message>
        <source>Refractive index behind the window</source>
        <translation>Brechungsindex hinter dem Fenster</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Inner corners, dots or tags</source>
        <translation>&amp;Innere Ecken, Punkte oder Tags</translation>
    </message>
    <message>
        <source>Asymmetric grid of dots</source>
        <translation>Versetztes Punktraster</translation>
    </message>
    <message>
        <source>AprilGrid</source>
        <translation>AprilGrid</translation>
    </message>
    <message>
        <source>What is printed on the board</source>
        <translation>Was auf der Tafel gedruckt ist</translation>
    </message>
    <message>
        <source>Counted on the board, along its long side</source>
        <translation>Auf der Tafel gezählt, längs ihrer langen Seite</translation>
    </message>
    <message>
        <source>Counted on the board, along its short side</source>
        <translation>Auf der Tafel gezählt, längs ihrer kurzen Seite</translation>
    </message>
    <message>
        <source>How the lens bends rays; fisheye for very wide angles</source>
        <translation>Wie das Objektiv Strahlen bricht; Fischauge für sehr weite Winkel</translation>
    </message>
    <message>
        <source>Measured on the printed board, by caliper over several squares</source>
        <translation>Auf der gedruckten Tafel mit dem Messschieber über mehrere Quadrate gemessen</translation>
    </message>
    <message>
        <source>The forecast of the depth&apos;s error is for this distance</source>
        <translation>Die Vorhersage des Tiefenfehlers gilt für diesen Abstand</translation>
    </message>
</context>
<context>
    <name>alltact::LensPage</name>
    <message>
        <source>a lens without distortion</source>
        <translation>ein Objektiv ohne Verzeichnung</translation>
    </message>
    <message>
        <source>a lens with distortion (Brown)</source>
        <translation>ein Objektiv mit Verzeichnung (Brown)</translation>
    </message>
    <message>
        <source>a fisheye lens</source>
        <translation>ein Fischaugenobjektiv</translation>
    </message>
    <message>
        <source>a lens with parallel rays</source>
        <translation>ein Objektiv mit parallelen Strahlen</translation>
    </message>
    <message>
        <source>%1, %2 × %3 px</source>
        <translation>%1, %2 × %3 px</translation>
    </message>
    <message>
        <source>Its calibration: %1.</source>
        <translation>Seine Kalibrierung: %1.</translation>
    </message>
    <message>
        <source>From a camera file</source>
        <translation>Aus einer Kameradatei</translation>
    </message>
    <message>
        <source>Measured with images of a board</source>
        <translation>Mit Bildern einer Tafel gemessen</translation>
    </message>
    <message>
        <source>Camera file</source>
        <translation>Kameradatei</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>Wähl&amp;en…</translation>
    </message>
    <message>
        <source>Choose a camera file</source>
        <translation>Eine Kameradatei wählen</translation>
    </message>
    <message>
        <source>&amp;Use the simulated camera&apos;s lens</source>
        <translation>Objektiv der simulierten Kamera &amp;verwenden</translation>
    </message>
    <message>
        <source>Ima&amp;ges</source>
        <translation>Bi&amp;lder</translation>
    </message>
    <message>
        <source>Folder of board images, or a recording</source>
        <translation>Ordner mit Tafelbildern oder eine Aufnahme</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder of board images</source>
        <translation>Ordner der Tafelbilder wählen</translation>
    </message>
    <message>
        <source>&amp;Measure the lens</source>
        <translation>Objektiv &amp;messen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop measuring the lens</source>
        <translation>Messen des Objektivs anhalten</translation>
    </message>
    <message>
        <source>Progress of the lens calibration</source>
        <translation>Fortschritt der Objektivkalibrierung</translation>
    </message>
    <message>
        <source>Outcome of the lens calibration</source>
        <translation>Ergebnis der Objektivkalibrierung</translation>
    </message>
    <message>
        <source>The lens is not known yet: choose a camera file, or measure the lens.</source>
        <translation>Das Objektiv ist noch nicht bekannt: Wählen Sie eine Kameradatei oder messen Sie es.</translation>
    </message>
    <message>
        <source>This finger&apos;s camera has %1</source>
        <translation>Die Kamera dieses Fingers hat %1</translation>
    </message>
    <message>
        <source>The camera has %1</source>
        <translation>Die Kamera hat %1</translation>
    </message>
    <message>
        <source>A finger measures through its camera&apos;s lens, so the lens comes first. Measure it once for each camera, with ten to twenty images of a flat board from all sides.</source>
        <translation>Ein Finger misst durch das Objektiv seiner Kamera, darum kommt es zuerst. Messen Sie es für jede Kamera einmal, mit zehn bis zwanzig Bildern einer ebenen Tafel von allen Seiten.</translation>
    </message>
    <message>
        <source>Folder of board images</source>
        <translation>Ordner mit Tafelbildern</translation>
    </message>
    <message>
        <source>No folder of images is specified.</source>
        <translation>Es ist kein Ordner mit Bildern angegeben.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Geschrieben nach %1.</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>Live, with a board</source>
        <translation>Live mit einer Tafel</translation>
    </message>
    <message>
        <source>&amp;Take this board (Space)</source>
        <translation>Diese Tafel auf&amp;nehmen (Leertaste)</translation>
    </message>
    <message>
        <source>Takes the board when it is held still at a new position or tilt</source>
        <translation>Nimmt die Tafel auf, sobald sie in einer neuen Position oder Neigung stillgehalten wird</translation>
    </message>
    <message>
        <source>How to hold the board</source>
        <translation>Wie die Tafel zu halten ist</translation>
    </message>
    <message>
        <source>Views of the board, with their errors</source>
        <translation>Ansichten der Tafel mit ihren Fehlern</translation>
    </message>
    <message>
        <source>Leave the chosen view out</source>
        <translation>Gewählte Ansicht auslassen</translation>
    </message>
    <message>
        <source>Blue: straight lines, as this lens shows them.</source>
        <translation>Blau: gerade Linien, wie dieses Objektiv sie zeigt.</translation>
    </message>
    <message>
        <source>Still better with: %1.</source>
        <translation>Noch besser mit: %1.</translation>
    </message>
    <message>
        <source>%1: error %2 px, tilted by %3°</source>
        <translation>%1: Fehler %2 px, um %3° geneigt</translation>
    </message>
    <message>
        <source>%1: not used, %2</source>
        <translation>%1: nicht verwendet, %2</translation>
    </message>
    <message>
        <source>Board %1</source>
        <translation>Tafel %1</translation>
    </message>
    <message>
        <source>Open the camera as source to take boards live.</source>
        <translation>Öffnen Sie die Kamera als Quelle, um Tafeln live aufzunehmen.</translation>
    </message>
    <message>
        <source>Looking for the board.</source>
        <translation>Die Tafel wird gesucht.</translation>
    </message>
    <message>
        <source>The board is blurred: hold it still or further away.</source>
        <translation>Die Tafel ist unscharf: Halten Sie sie still oder weiter weg.</translation>
    </message>
    <message>
        <source>Position already captured: move or tilt the board.</source>
        <translation>Diese Position ist schon erfasst: Tafel verschieben oder neigen.</translation>
    </message>
    <message>
        <source>Hold it still.</source>
        <translation>Stillhalten.</translation>
    </message>
    <message>
        <source>Good: take it.</source>
        <translation>Gut: jetzt aufnehmen.</translation>
    </message>
    <message>
        <source>Still missing: %1.</source>
        <translation>Es fehlt noch: %1.</translation>
    </message>
    <message>
        <source>%1 mm per pixel</source>
        <translation>%1 mm pro Pixel</translation>
    </message>
    <message>
        <source>focal length %1 px</source>
        <translation>Brennweite %1 px</translation>
    </message>
    <message>
        <source>behind a window</source>
        <translation>hinter einem Fenster</translation>
    </message>
    <message>
        <source>camera.yaml, or a file of ROS, OpenCV, Kalibr, mrcal, PhotonVision or Matlab</source>
        <translation>camera.yaml oder eine Datei von ROS, OpenCV, Kalibr, mrcal, PhotonVision oder Matlab</translation>
    </message>
    <message>
        <source>Camera (*.yaml *.yml *.json *.xml *.cameramodel *.txt)</source>
        <translation>Kamera (*.yaml *.yml *.json *.xml *.cameramodel *.txt)</translation>
    </message>
    <message>
        <source>Camera file: %1</source>
        <translation>Kameradatei: %1</translation>
    </message>
    <message>
        <source>Automatically when ne&amp;w and still</source>
        <translation>Automatisch, wenn neu &amp;und ruhig</translation>
    </message>
    <message>
        <source>Uses a lens that was measured before</source>
        <translation>Verwendet ein früher vermessenes Objektiv</translation>
    </message>
    <message>
        <source>Images or a video of the board, seen from many sides</source>
        <translation>Bilder oder ein Video der Tafel, von vielen Seiten</translation>
    </message>
    <message>
        <source>Chooses stored images of the board</source>
        <translation>Wählt gespeicherte Bilder der Tafel</translation>
    </message>
    <message>
        <source>Computes the camera file from the views of the board</source>
        <translation>Berechnet die Kameradatei aus den Ansichten der Tafel</translation>
    </message>
    <message>
        <source>Ends the measurement without a result</source>
        <translation>Beendet die Messung ohne Ergebnis</translation>
    </message>
    <message>
        <source>The lens of a simulated camera is known exactly</source>
        <translation>Das Objektiv einer simulierten Kamera ist genau bekannt</translation>
    </message>
    <message>
        <source>Stores the present image as a view of the board</source>
        <translation>Speichert das jetzige Bild als Ansicht der Tafel</translation>
    </message>
    <message>
        <source>The lens is measured without it</source>
        <translation>Das Objektiv wird ohne sie vermessen</translation>
    </message>
</context>
<context>
    <name>alltact::LivePairBox</name>
    <message>
        <source>Second finger</source>
        <translation>Zweiter Finger</translation>
    </message>
    <message>
        <source>&amp;Second finger…</source>
        <translation>Z&amp;weiter Finger…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Mo&amp;tor at</source>
        <translation>Moto&amp;r bei</translation>
    </message>
    <message>
        <source> turns</source>
        <translation> Umdrehungen</translation>
    </message>
    <message>
        <source>Motor position in turns</source>
        <translation>Motorstellung in Umdrehungen</translation>
    </message>
    <message>
        <source>Position of the gripper&apos;s motor; the figures apply to this position.</source>
        <translation>Stellung des Greifermotors; die Zahlen gelten für diese Stellung.</translation>
    </message>
    <message>
        <source>Gap and width</source>
        <translation>Spalt und Breite</translation>
    </message>
    <message>
        <source>Synchronization of both images</source>
        <translation>Gleichzeitigkeit beider Bilder</translation>
    </message>
    <message>
        <source>Waiting for the second image.</source>
        <translation>Auf das zweite Bild wird gewartet.</translation>
    </message>
    <message>
        <source>No capture times: the newest image of each camera.</source>
        <translation>Ohne Aufnahmezeiten: das jeweils neueste Bild beider Kameras.</translation>
    </message>
    <message>
        <source>In sync: 2 was captured %1 ms after 1.</source>
        <translation>Gleichzeitig: 2 entstand %1 ms nach 1.</translation>
    </message>
    <message>
        <source>Not in sync: 2 was captured %1 ms after 1, more than half a frame.</source>
        <translation>Nicht gleichzeitig: 2 entstand %1 ms nach 1, mehr als eine halbe Bilddauer.</translation>
    </message>
    <message>
        <source>With a gripper.yaml, the gap between the faces and the width of the held object appear here.</source>
        <translation>Mit einer gripper.yaml erscheinen hier der Spalt zwischen den Flächen und die Breite des gegriffenen Objekts.</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Wird gemessen…</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Spalt</translation>
    </message>
    <message>
        <source>Object width</source>
        <translation>Objektbreite</translation>
    </message>
    <message>
        <source>Gap unknown: both faces need depth.</source>
        <translation>Spalt unbekannt: Beide Flächen brauchen Tiefe.</translation>
    </message>
    <message>
        <source>No jointly held object.</source>
        <translation>Kein gemeinsam gehaltenes Objekt.</translation>
    </message>
    <message>
        <source>Shows another finger with its own camera at the same moment</source>
        <translation>Zeigt einen anderen Finger mit eigener Kamera im selben Moment</translation>
    </message>
    <message>
        <source>Shows the first finger alone again</source>
        <translation>Zeigt wieder nur den ersten Finger</translation>
    </message>
</context>
<context>
    <name>alltact::ContactBox</name>
    <message>
        <source>No image yet.</source>
        <translation>Noch kein Bild.</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Contacts on the finger</source>
        <translation>Kontakte am Finger</translation>
    </message>
</context>
<context>
    <name>alltact::LivePage</name>
    <message>
        <source>Shar&amp;p edges</source>
        <translation>Scharfe K&amp;onturen</translation>
    </message>
    <message>
        <source>Yellow where the image is sharp: turn the lens until most of the face's edges and of the markers are yellow.</source>
        <translation>Gelb, wo das Bild scharf ist: am Objektiv drehen, bis die meisten Kanten der Fläche und Marker gelb sind.</translation>
    </message>
    <message>
        <source>show %1</source>
        <translation>%1 einblenden</translation>
    </message>
    <message>
        <source>hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>change the depth colours</source>
        <translation>Tiefenfarben ändern</translation>
    </message>
    <message>
        <source>Image overlays</source>
        <translation>Überlagerungen</translation>
    </message>
    <message>
        <source>&amp;Markers with numbers</source>
        <translation>&amp;Marken mit Nummern</translation>
    </message>
    <message>
        <source>Direction of &amp;contact</source>
        <translation>R&amp;ichtung des Kontakts</translation>
    </message>
    <message>
        <source>&amp;Depth in colours</source>
        <translation>&amp;Tiefe in Farben</translation>
    </message>
    <message>
        <source>&amp;Too dark or too bright</source>
        <translation>&amp;Zu dunkel oder zu hell</translation>
    </message>
    <message>
        <source>Ring: visible marker. Dashed diamond: estimated position.</source>
        <translation>Ring: sichtbare Marke. Gestrichelte Raute: geschätzte Position.</translation>
    </message>
    <message>
        <source>Stripes falling to the right: too bright to measure. Stripes falling to the left: too dark.</source>
        <translation>Nach rechts fallende Streifen: zu hell zum Messen. Nach links fallende: zu dunkel.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Depth at which the colours end</source>
        <translation>Tiefe, bei der die Farben enden</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Time per frame</source>
        <translation>Zeit pro Bild</translation>
    </message>
    <message>
        <source>change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>lock brightness</source>
        <translation>Helligkeit sperren</translation>
    </message>
    <message>
        <source>unlock brightness</source>
        <translation>Helligkeit entsperren</translation>
    </message>
    <message>
        <source>No image yet.</source>
        <translation>Noch kein Bild.</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Preparation</source>
        <translation>Vorbereitung</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Gesamt</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation>&amp;Live</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>change the motor&apos;s position</source>
        <translation>Motorstellung ändern</translation>
    </message>
    <message>
        <source>watch a second finger</source>
        <translation>einen zweiten Finger beobachten</translation>
    </message>
    <message>
        <source>close the second finger</source>
        <translation>den zweiten Finger schließen</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>dim the lamp</source>
        <translation>die Lampe dimmen</translation>
    </message>
    <message>
        <source>choose the lamp&apos;s dimmer</source>
        <translation>den Dimmer der Lampe wählen</translation>
    </message>
    <message>
        <source>Edges &amp;of the face</source>
        <translation>&amp;Kanten der Fläche</translation>
    </message>
    <message>
        <source>Colours e&amp;nd at</source>
        <translation>Farben &amp;enden bei</translation>
    </message>
    <message>
        <source>Deeper contacts have the colour of the end of the scale</source>
        <translation>Tiefere Kontakte haben die Farbe am Ende der Skala</translation>
    </message>
    <message>
        <source>Both edges of the face, as they are found in this image</source>
        <translation>Beide Kanten der Fläche, wie sie in diesem Bild gefunden werden</translation>
    </message>
    <message>
        <source>Arrow: displacement of the finger; it grows with the force</source>
        <translation>Pfeil: Verschiebung des Fingers; sie wächst mit der Kraft</translation>
    </message>
    <message>
        <source>How deep the face is pressed in; the scale is in mm</source>
        <translation>Wie tief die Fläche eingedrückt ist; die Skala ist in mm</translation>
    </message>
</context>
<context>
    <name>alltact::MainWindow</name>
    <message>
        <source>Fi&amp;nd a command…</source>
        <translation>&amp;Befehl suchen…</translation>
    </message>
    <message>
        <source>AllTact Studio</source>
        <translation>AllTact Studio</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>S&amp;ettings…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>continue the last session</source>
        <translation>die letzte Sitzung fortsetzen</translation>
    </message>
    <message>
        <source>finger %1</source>
        <translation>Finger %1</translation>
    </message>
    <message>
        <source>source %1</source>
        <translation>Quelle %1</translation>
    </message>
    <message>
        <source>recording %1</source>
        <translation>Aufnahme %1</translation>
    </message>
    <message>
        <source>A recording is running</source>
        <translation>Eine Aufnahme läuft</translation>
    </message>
    <message>
        <source>A recording is running. Quitting ends it; the recording up to then is saved.</source>
        <translation>Eine Aufnahme läuft. Beim Beenden endet sie; das bis dahin Aufgenommene bleibt gespeichert.</translation>
    </message>
    <message>
        <source>&amp;End it and quit</source>
        <translation>Auf&amp;hören und beenden</translation>
    </message>
    <message>
        <source>&amp;Go on recording</source>
        <translation>&amp;Weiter aufnehmen</translation>
    </message>
</context>
<context>
    <name>alltact::MappingPage</name>
    <message>
        <source>Compare with other &amp;methods</source>
        <translation>Mit anderen &amp;Verfahren vergleichen</translation>
    </message>
    <message>
        <source>Calibrates with the same presses by the source paper's method and two others, for the report</source>
        <translation>Kalibriert mit denselben Eindrücken nach dem Verfahren der Quellarbeit und zwei weiteren, für den Bericht</translation>
    </message>
    <message>
        <source>Mean residual of the presses: %1 mm, by the source paper's method %2 mm. The report has all methods.</source>
        <translation>Mittlere Abweichung der Eindrücke: %1 mm, nach dem Verfahren der Quellarbeit %2 mm. Der Bericht enthält alle Verfahren.</translation>
    </message>
    <message>
        <source>The source paper's method finds no calibration with these presses. The report has all methods.</source>
        <translation>Das Verfahren der Quellarbeit findet mit diesen Eindrücken keine Kalibrierung. Der Bericht enthält alle Verfahren.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Retains the best solution so far</source>
        <translation>Behält die bisher beste Lösung bei</translation>
    </message>
    <message>
        <source>Progress of the calibration</source>
        <translation>Fortschritt der Kalibrierung</translation>
    </message>
    <message>
        <source>Depth over brightness difference</source>
        <translation>Tiefe über Helligkeitsunterschied</translation>
    </message>
    <message>
        <source>Error of every press, worst first</source>
        <translation>Fehler jedes Eindrucks, der größte zuerst</translation>
    </message>
    <message>
        <source>The calibration is running.</source>
        <translation>Die Kalibrierung läuft.</translation>
    </message>
    <message>
        <source>Calibrate first.</source>
        <translation>Zuerst kalibrieren.</translation>
    </message>
    <message>
        <source>&amp;Calibrate now</source>
        <translation>Jetzt &amp;kalibrieren</translation>
    </message>
    <message>
        <source>&amp;Calibrate again</source>
        <translation>Neu &amp;kalibrieren</translation>
    </message>
    <message numerus="yes">
        <source>(about %n second(s) left)</source>
        <translation>
            <numerusform>(noch etwa %n Sekunde)</numerusform>
            <numerusform>(noch etwa %n Sekunden)</numerusform>
        </translation>
    </message>
    <message>
        <source>This finger is calibrated. Calibrate again to show the figures.</source>
        <translation>Dieser Finger ist kalibriert. Kalibrieren Sie neu, um die Diagramme zu zeigen.</translation>
    </message>
    <message>
        <source>From one press on, the program learns from the ball&apos;s shape what each pixel&apos;s darkening means in mm.</source>
        <translation>Ab einem Eindruck lernt das Programm aus der Form der Kugel, wie viele mm die Verdunkelung jedes Pixels bedeutet.</translation>
    </message>
    <message>
        <source>From the ball&apos;s shape in all presses, the program learns what each pixel&apos;s darkening means in mm. It leaves out each press once to test how well the others predict it.</source>
        <translation>Aus der Form der Kugel in allen Eindrücken lernt das Programm, wie viele mm die Verdunkelung jedes Pixels bedeutet. Jeder Eindruck wird einmal ausgelassen, um zu prüfen, wie gut die anderen ihn vorhersagen.</translation>
    </message>
    <message>
        <source>Mapping: %1.</source>
        <translation>Abbildung: %1.</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>Result with these presses; not in use yet.</source>
        <translation>Ergebnis mit diesen Eindrücken; noch nicht in Gebrauch.</translation>
    </message>
    <message>
        <source>S&amp;how this press</source>
        <translation>Diesen Eindruck &amp;zeigen</translation>
    </message>
    <message>
        <source>Click a bar or circle to show this press&apos;s points and position.</source>
        <translation>Balken oder Kreis anklicken, um Punkte und Position des Eindrucks zu zeigen.</translation>
    </message>
    <message>
        <source>%1 is left out: the next calibration does not use it.</source>
        <translation>%1 ist ausgelassen: Die nächste Kalibrierung verwendet ihn nicht.</translation>
    </message>
    <message>
        <source>%1: its points are marked +, its circle is bold.</source>
        <translation>%1: Seine Punkte sind mit + markiert, sein Kreis ist fett.</translation>
    </message>
    <message>
        <source>A ball in the layer, seen from its side</source>
        <translation>Eine Kugel in der Schicht, von der Seite gesehen</translation>
    </message>
    <message>
        <source>Clear silicone</source>
        <translation>Klares Silikon</translation>
    </message>
    <message>
        <source>Untouched face</source>
        <translation>Unberührte Fläche</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Layer thickness</source>
        <translation>Schichtdicke</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Opens the chosen press on the step Presses</source>
        <translation>Öffnet den gewählten Eindruck im Schritt Eindrücke</translation>
    </message>
    <message>
        <source>A press that is left out stays stored; the next calibration does not use it</source>
        <translation>Ein ausgelassener Eindruck bleibt gespeichert; die nächste Kalibrierung nutzt ihn nicht</translation>
    </message>
    <message>
        <source>Computes the mapping from all presses; undo restores the one before</source>
        <translation>Berechnet die Abbildung aus allen Eindrücken; Rückgängig stellt die vorige her</translation>
    </message>
</context>
<context>
    <name>alltact::MappingPlot</name>
    <message>
        <source>Mapping from brightness to depth</source>
        <translation>Abbildung von Helligkeit auf Tiefe</translation>
    </message>
    <message>
        <source>No mapping yet: calibrate with ball presses</source>
        <translation>Noch keine Abbildung: mit Kugeleindrücken kalibrieren</translation>
    </message>
    <message>
        <source>± 2 standard deviations</source>
        <translation>± 2 Standardabweichungen</translation>
    </message>
    <message>
        <source>nearer the rim</source>
        <translation>näher am Rand</translation>
    </message>
    <message>
        <source>inner part of a contact</source>
        <translation>innerer Teil eines Kontakts</translation>
    </message>
    <message>
        <source>mapping</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>Brightness difference x (no unit)</source>
        <translation>Helligkeitsunterschied x (ohne Einheit)</translation>
    </message>
    <message>
        <source>Brightness difference x (relative to untouched)</source>
        <translation>Helligkeitsunterschied x (relativ zu unberührt)</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Tiefe (mm)</translation>
    </message>
    <message>
        <source>Press depth (mm)</source>
        <translation>Eindrucktiefe (mm)</translation>
    </message>
    <message>
        <source>end of the calibrated range</source>
        <translation>Ende des kalibrierten Bereichs</translation>
    </message>
</context>
<context>
    <name>alltact::MoreDataBox</name>
    <message>
        <source>Benefit of more data</source>
        <translation>Nutzen weiterer Daten</translation>
    </message>
    <message>
        <source>Progress of the computation</source>
        <translation>Fortschritt der Berechnung</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>Sto&amp;pp</translation>
    </message>
    <message>
        <source>Compute no&amp;w</source>
        <translation>&amp;Ausrechnen</translation>
    </message>
    <message>
        <source>Benefit of one more press, more images of each, one more minute. The program paints balls into this finger&apos;s images and calibrates it with them.</source>
        <translation>Nutzen eines weiteren Eindrucks, weiterer Bilder pro Eindruck oder einer weiteren Minute. Das Programm zeichnet Kugeln in Bilder dieses Fingers und kalibriert ihn damit neu.</translation>
    </message>
    <message>
        <source>No tested option improves the result.</source>
        <translation>Keine geprüfte Möglichkeit verbessert das Ergebnis.</translation>
    </message>
    <message>
        <source>Calibrates with fewer and with painted presses; takes a minute</source>
        <translation>Kalibriert mit weniger und mit gemalten Eindrücken; dauert eine Minute</translation>
    </message>
</context>
<context>
    <name>alltact::NewFingerDialog</name>
    <message>
        <source>New finger</source>
        <translation>Neuer Finger</translation>
    </message>
    <message>
        <source>New &amp;folder</source>
        <translation>Neuer &amp;Ordner</translation>
    </message>
    <message>
        <source>&amp;Camera file</source>
        <translation>&amp;Kameradatei</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Art</translation>
    </message>
    <message>
        <source>&amp;Width of the face</source>
        <translation>&amp;Breite der Fläche</translation>
    </message>
    <message>
        <source>Thickness of the &amp;layer</source>
        <translation>Dicke der S&amp;chicht</translation>
    </message>
    <message>
        <source>Distance of the &amp;plane</source>
        <translation>Abstand der &amp;Ebene</translation>
    </message>
    <message>
        <source>&amp;Dots on each side</source>
        <translation>&amp;Punkte je Seite</translation>
    </message>
    <message>
        <source>Dots &amp;are</source>
        <translation>Punkte si&amp;nd</translation>
    </message>
    <message>
        <source>Fin Ray finger: its shape is read from the face&apos;s edges</source>
        <translation>Fin-Ray-Finger: Form aus den Kanten der Fläche</translation>
    </message>
    <message>
        <source>Flat, rigid sensor</source>
        <translation>Flacher, starrer Sensor</translation>
    </message>
    <message>
        <source>detected in the reference recording</source>
        <translation>wird aus der Referenzaufnahme erkannt</translation>
    </message>
    <message>
        <source>brighter than surroundings</source>
        <translation>heller als ihre Umgebung</translation>
    </message>
    <message>
        <source>darker than surroundings</source>
        <translation>dunkler als ihre Umgebung</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Choose the camera file</source>
        <translation>Kameradatei wählen</translation>
    </message>
    <message>
        <source>&amp;Make the finger</source>
        <translation>Finger &amp;anlegen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>New folder</source>
        <translation>Neuer Ordner</translation>
    </message>
    <message>
        <source>Camera file</source>
        <translation>Kameradatei</translation>
    </message>
    <message>
        <source>No folder is chosen.</source>
        <translation>Es ist kein Ordner angegeben.</translation>
    </message>
    <message>
        <source>No camera file is specified.</source>
        <translation>Es ist keine Kameradatei angegeben.</translation>
    </message>
    <message>
        <source>Measure width and layer with a caliper, and count the dots. The camera file comes from the lens calibration, the first step of the Calibrate page.</source>
        <translation>Messen Sie Breite und Schicht mit dem Messschieber, und zählen Sie die Punkte. Die Kameradatei kommt aus der Objektivkalibrierung, dem ersten Schritt der Seite Kalibrieren.</translation>
    </message>
    <message>
        <source>The first step of the Calibrate page creates it.</source>
        <translation>Der erste Schritt der Seite Kalibrieren erzeugt sie.</translation>
    </message>
    <message>
        <source>Camera (*.yaml *.yml *.json *.xml *.cameramodel *.txt)</source>
        <translation>Kamera (*.yaml *.yml *.json *.xml *.cameramodel *.txt)</translation>
    </message>
    <message>
        <source>Untouched image</source>
        <translation>Bild ohne Berührung</translation>
    </message>
    <message>
        <source>&amp;Untouched image</source>
        <translation>Bild ohne &amp;Berührung</translation>
    </message>
    <message>
        <source>&amp;Size of a pixel</source>
        <translation>&amp;Größe eines Pixels</translation>
    </message>
    <message>
        <source>from the camera file</source>
        <translation>aus der Kameradatei</translation>
    </message>
    <message>
        <source>On the face, for a camera that looks straight at it</source>
        <translation>Auf der Fläche, für eine Kamera, die senkrecht auf sie blickt</translation>
    </message>
    <message>
        <source>Choose the untouched image</source>
        <translation>Das Bild ohne Berührung wählen</translation>
    </message>
    <message>
        <source>The finger is not made yet. Discard what was entered?</source>
        <translation>Der Finger ist noch nicht angelegt. Eingaben verwerfen?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Weiter eingeben</translation>
    </message>
    <message>
        <source>The camera is not described.</source>
        <translation>Die Kamera ist nicht beschrieben.</translation>
    </message>
    <message>
        <source>Choose its file, or enter the size of a pixel and choose the untouched image.</source>
        <translation>Wählen Sie ihre Datei, oder geben Sie die Größe eines Pixels ein und wählen Sie das Bild ohne Berührung.</translation>
    </message>
    <message>
        <source>An image of the face without contact</source>
        <translation>Ein Bild der Fläche ohne Kontakt</translation>
    </message>
    <message>
        <source>Chooses where the finger&apos;s folder is made</source>
        <translation>Wählt, wo der Ordner des Fingers angelegt wird</translation>
    </message>
    <message>
        <source>The file that the lens calibration wrote</source>
        <translation>Die Datei, die die Kalibrierung des Objektivs geschrieben hat</translation>
    </message>
    <message>
        <source>Whether the face bends</source>
        <translation>Ob sich die Fläche biegt</translation>
    </message>
    <message>
        <source>How the dots differ from the skin around them</source>
        <translation>Worin sich die Punkte von der Haut unterscheiden</translation>
    </message>
    <message>
        <source>From edge to edge, by caliper</source>
        <translation>Von Kante zu Kante, mit dem Messschieber</translation>
    </message>
    <message>
        <source>Of the translucent layer; no depth is larger</source>
        <translation>Der durchscheinenden Schicht; keine Tiefe ist größer</translation>
    </message>
    <message>
        <source>From the lens to the face</source>
        <translation>Vom Objektiv zur Fläche</translation>
    </message>
    <message>
        <source>Counted on one side of the face; 0 for none</source>
        <translation>Auf einer Seite der Fläche gezählt; 0 für keine</translation>
    </message>
    <message>
        <source>Writes the folder and opens the finger</source>
        <translation>Legt den Ordner an und öffnet den Finger</translation>
    </message>
    <message>
        <source>Closes this window without a change (Esc)</source>
        <translation>Schließt dieses Fenster ohne Änderung (Esc)</translation>
    </message>
</context>
<context>
    <name>alltact::OutlineEditor</name>
    <message>
        <source>Image with the ball&apos;s outline</source>
        <translation>Bild mit dem Umriss der Kugel</translation>
    </message>
    <message>
        <source>Drag the outline&apos;s centre or rim onto the ball. Arrow keys move it by a tenth of a pixel, Page Up and Page Down change its size, with Shift by one pixel. Ctrl and the arrow keys move the image; the wheel zooms, over the rim it changes the size.</source>
        <translation>Mitte oder Rand des Umrisses auf die Kugel ziehen. Pfeiltasten verschieben ihn um ein Zehntelpixel, Bild auf und Bild ab ändern die Größe, mit Umschalt um ein ganzes Pixel. Strg und Pfeiltasten verschieben das Bild; das Rad zoomt, über dem Rand ändert es die Größe.</translation>
    </message>
    <message>
        <source>Centre u %1 px, v %2 px, radius %3 px; ball at x %4, y %5, z %6 mm</source>
        <translation>Mitte u %1 px, v %2 px, Radius %3 px; Kugel bei x %4, y %5, z %6 mm</translation>
    </message>
</context>
<context>
    <name>alltact::PairBox</name>
    <message>
        <source>Second finger</source>
        <translation>Zweiter Finger</translation>
    </message>
    <message>
        <source>Second fin&amp;ger…</source>
        <translation>Zweiter Fin&amp;ger…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Pose of 1…</source>
        <translation>Lage von 1…</translation>
    </message>
    <message>
        <source>Pose of 2…</source>
        <translation>Lage von 2…</translation>
    </message>
    <message>
        <source>Pose of the first finger in the gripper</source>
        <translation>Lage des ersten Fingers im Greifer</translation>
    </message>
    <message>
        <source>Pose of the second finger in the gripper</source>
        <translation>Lage des zweiten Fingers im Greifer</translation>
    </message>
    <message>
        <source>Pose of this finger&apos;s camera in the gripper.</source>
        <translation>Lage der Kamera dieses Fingers im Greifer.</translation>
    </message>
    <message>
        <source>Distance between the faces</source>
        <translation>Abstand der Flächen</translation>
    </message>
    <message>
        <source>Matching of the two recordings</source>
        <translation>Zuordnung der beiden Aufnahmen</translation>
    </message>
    <message>
        <source>Open a recording first; then you can add a second one.</source>
        <translation>Öffnen Sie zuerst eine Aufnahme; danach können Sie eine zweite hinzufügen.</translation>
    </message>
    <message>
        <source>Matched by time stamps; 2 was captured %1 ms after 1.</source>
        <translation>Nach Zeitstempeln zugeordnet; 2 entstand %1 ms nach 1.</translation>
    </message>
    <message>
        <source>Recorded at different times, aligned at their starts; 2 was captured %1 ms after 1.</source>
        <translation>Zu verschiedenen Zeiten aufgenommen, an den Anfängen ausgerichtet; 2 entstand %1 ms nach 1.</translation>
    </message>
    <message>
        <source>No time stamps: matched by frame number.</source>
        <translation>Ohne Zeitstempel: nach Bildnummer zugeordnet.</translation>
    </message>
    <message>
        <source>Measuring the distance…</source>
        <translation>Der Abstand wird gemessen…</translation>
    </message>
    <message>
        <source>&lt;b&gt;The faces touch or intersect.&lt;/b&gt;</source>
        <translation>&lt;b&gt;Die Flächen berühren oder durchdringen sich.&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 mm&lt;/b&gt; shortest distance between the faces, near X %2, Y %3, Z %4 mm</source>
        <translation>&lt;b&gt;%1 mm&lt;/b&gt; kleinster Abstand der Flächen, nahe X %2, Y %3, Z %4 mm</translation>
    </message>
    <message>
        <source>Shows the first finger alone again</source>
        <translation>Zeigt wieder nur den ersten Finger</translation>
    </message>
    <message>
        <source>Shows another finger of the same moment next to this one</source>
        <translation>Zeigt einen anderen Finger im selben Moment daneben</translation>
    </message>
</context>
<context>
    <name>alltact::Pedal</name>
    <message>
        <source>Press it once more.</source>
        <translation>Noch einmal drücken.</translation>
    </message>
    <message>
        <source>Press the pedal twice now.</source>
        <translation>Jetzt das Pedal zweimal drücken.</translation>
    </message>
    <message>
        <source>Leave the pedal alone for a moment.</source>
        <translation>Das Pedal einen Augenblick nicht berühren.</translation>
    </message>
    <message>
        <source>Learnt: %1</source>
        <translation>Gelernt: %1</translation>
    </message>
</context>
<context>
    <name>alltact::ImagePanel</name>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Show the entire image</source>
        <translation>Gesamtes Bild zeigen</translation>
    </message>
    <message>
        <source>Show the image at original size</source>
        <translation>Bild in Originalgröße zeigen</translation>
    </message>
    <message>
        <source>1:1</source>
        <translation>1:1</translation>
    </message>
    <message>
        <source>Values at the probe</source>
        <translation>Werte an der Sonde</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Vergrößerung</translation>
    </message>
    <message>
        <source>The source is being opened.</source>
        <translation>Die Quelle wird geöffnet.</translation>
    </message>
    <message>
        <source>The source could not be opened; the reason is above.</source>
        <translation>Die Quelle konnte nicht geöffnet werden; der Grund steht oben.</translation>
    </message>
    <message>
        <source>No source is open. Choose a camera, a recording or the simulated finger.</source>
        <translation>Keine Quelle ist geöffnet. Wählen Sie eine Kamera, eine Aufnahme oder den simulierten Finger.</translation>
    </message>
    <message>
        <source>Waiting for the first image.</source>
        <translation>Auf das erste Bild wird gewartet.</translation>
    </message>
    <message>
        <source>Point at a pixel, or press Shift and an arrow key.</source>
        <translation>Auf ein Pixel zeigen oder Umschalt und eine Pfeiltaste drücken.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Freeze the image</source>
        <translation>Bild anhalten</translation>
    </message>
    <message>
        <source>Freeze this image; measuring continues</source>
        <translation>Dieses Bild anhalten; die Messung läuft weiter</translation>
    </message>
    <message>
        <source>Save the image</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Save the image, with or without its overlays</source>
        <translation>Bild speichern, mit oder ohne Überlagerungen</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>As shown (*.png)</source>
        <translation>Wie angezeigt (*.png)</translation>
    </message>
    <message>
        <source>Only the camera&apos;s image (*.png)</source>
        <translation>Nur das Bild der Kamera (*.png)</translation>
    </message>
    <message>
        <source>%1 could not be written. Choose another folder, or free some disk space.</source>
        <translation>%1 konnte nicht geschrieben werden. Einen anderen Ordner wählen oder Speicherplatz freigeben.</translation>
    </message>
    <message>
        <source>no depth: too dark</source>
        <translation>keine Tiefe: zu dunkel</translation>
    </message>
    <message>
        <source>no depth: too bright</source>
        <translation>keine Tiefe: zu hell</translation>
    </message>
    <message>
        <source>no depth: off the face</source>
        <translation>keine Tiefe: außerhalb der Fläche</translation>
    </message>
    <message>
        <source>u %1 px, v %2 px, grey %3</source>
        <translation>u %1 px, v %2 px, Grauwert %3</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>Tiefe %1 mm</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>Tiefe, mm</translation>
    </message>
</context>
<context>
    <name>alltact::PageHint</name>
    <message>
        <source>Purpose of this page</source>
        <translation>Zweck dieser Seite</translation>
    </message>
    <message>
        <source>How it is &amp;done (F1)</source>
        <translation>Wie es &amp;geht (F1)</translation>
    </message>
    <message>
        <source>&amp;Understood</source>
        <translation>&amp;Verstanden</translation>
    </message>
    <message>
        <source>Hides this hint; the help (F1) has it</source>
        <translation>Blendet den Hinweis aus; er steht in der Hilfe (F1)</translation>
    </message>
    <message>
        <source>Opens the help of this page</source>
        <translation>Öffnet die Hilfe dieser Seite</translation>
    </message>
</context>
<context>
    <name>alltact::PointsBox</name>
    <message>
        <source>move point A</source>
        <translation>Punkt A verschieben</translation>
    </message>
    <message>
        <source>remove the points</source>
        <translation>die Punkte entfernen</translation>
    </message>
    <message>
        <source>move point B</source>
        <translation>Punkt B verschieben</translation>
    </message>
    <message>
        <source>cut across</source>
        <translation>quer schneiden</translation>
    </message>
    <message>
        <source>cut along</source>
        <translation>längs schneiden</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Point &amp;A</source>
        <translation>&amp;Punkt A</translation>
    </message>
    <message>
        <source>Point &amp;B</source>
        <translation>Pu&amp;nkt B</translation>
    </message>
    <message>
        <source>Point A, along the finger</source>
        <translation>Punkt A, längs des Fingers</translation>
    </message>
    <message>
        <source>Point A, across it</source>
        <translation>Punkt A, quer zum Finger</translation>
    </message>
    <message>
        <source>Point B, along the finger</source>
        <translation>Punkt B, längs des Fingers</translation>
    </message>
    <message>
        <source>Point B, across it</source>
        <translation>Punkt B, quer zum Finger</translation>
    </message>
    <message>
        <source>Along the face from its base. The point stays there on the finger when the finger moves.</source>
        <translation>Längs der Fläche, von ihrem Fuß an. Der Punkt bleibt dort auf dem Finger, auch wenn dieser sich bewegt.</translation>
    </message>
    <message>
        <source>Across the face from its centre line.</source>
        <translation>Quer zur Fläche, von ihrer Mittellinie an.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Deepest</source>
        <translation>Tiefster</translation>
    </message>
    <message>
        <source>Puts A on the deepest point.</source>
        <translation>Setzt A auf den tiefsten Punkt.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Removes both points.</source>
        <translation>Entfernt beide Punkte.</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer</translation>
    </message>
    <message>
        <source>From edge to edge of the finger, through A or the deepest point.</source>
        <translation>Von Kante zu Kante des Fingers, durch A oder den tiefsten Punkt.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Längs</translation>
    </message>
    <message>
        <source>From base to tip, through A or the deepest point.</source>
        <translation>Vom Fuß zur Spitze, durch A oder den tiefsten Punkt.</translation>
    </message>
    <message>
        <source>Measured at the points</source>
        <translation>An den Punkten gemessen</translation>
    </message>
    <message>
        <source>Nothing to measure yet.</source>
        <translation>Noch nichts zu messen.</translation>
    </message>
    <message>
        <source>no depth: too dark</source>
        <translation>keine Tiefe: zu dunkel</translation>
    </message>
    <message>
        <source>no depth: too bright</source>
        <translation>keine Tiefe: zu hell</translation>
    </message>
    <message>
        <source>no depth: near the face&apos;s edge</source>
        <translation>keine Tiefe: nahe am Rand der Fläche</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>Tiefe %1 mm</translation>
    </message>
    <message>
        <source>at the layer&apos;s limit</source>
        <translation>an der Grenze der Schicht</translation>
    </message>
    <message>
        <source>a bulge at the layer&apos;s limit</source>
        <translation>Wölbung an der Grenze der Schicht</translation>
    </message>
    <message>
        <source>beyond the calibrated range</source>
        <translation>außerhalb des Kalibrierbereichs</translation>
    </message>
    <message>
        <source>steep: one pixel further changes it by more</source>
        <translation>steil: ein Pixel weiter ändert sie stärker</translation>
    </message>
    <message>
        <source>doubtful light</source>
        <translation>zweifelhaftes Licht</translation>
    </message>
    <message>
        <source> (%1)</source>
        <translation> (%1)</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: off the face</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: außerhalb der Fläche</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: x %2, y %3, z %4 mm</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: x %2, y %3, z %4 mm</translation>
    </message>
    <message>
        <source>&lt;b&gt;A to B&lt;/b&gt;: %1 mm straight, %2 mm along the face</source>
        <translation>&lt;b&gt;A nach B&lt;/b&gt;: %1 mm gerade, %2 mm entlang der Fläche</translation>
    </message>
    <message>
        <source>offset x %1, y %2, z %3 mm</source>
        <translation>Versatz x %1, y %2, z %3 mm</translation>
    </message>
    <message>
        <source>Deepest %1 mm; contact at x %2, y %3, z %4 mm.</source>
        <translation>Tiefster Punkt %1 mm; Kontakt bei x %2, y %3, z %4 mm.</translation>
    </message>
    <message>
        <source>Nothing presses on the face.</source>
        <translation>Nichts drückt auf die Fläche.</translation>
    </message>
    <message>
        <source>Click on the face for point A, with the right button for point B.</source>
        <translation>Klicken Sie auf die Fläche für Punkt A, mit der rechten Taste für Punkt B.</translation>
    </message>
    <message>
        <source>not calibrated: no depth</source>
        <translation>nicht kalibriert: keine Tiefe</translation>
    </message>
    <message>
        <source>%1 mm along, %2 mm across; x %3, y %4, z %5 mm</source>
        <translation>%1 mm längs, %2 mm quer; x %3, y %4, z %5 mm</translation>
    </message>
</context>
<context>
    <name>alltact::PressCollection</name>
    <message numerus="yes">
        <source>remove %n press(es)</source>
        <translation>
            <numerusform>%n Eindruck entfernen</numerusform>
            <numerusform>%n Eindrücke entfernen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>put %n press(es) back</source>
        <translation>
            <numerusform>%n Eindruck wieder nutzen</numerusform>
            <numerusform>%n Eindrücke wieder nutzen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>leave %n press(es) out</source>
        <translation>
            <numerusform>%n Eindruck auslassen</numerusform>
            <numerusform>%n Eindrücke auslassen</numerusform>
        </translation>
    </message>
    <message>
        <source>change the body of %1</source>
        <translation>Körper von %1 ändern</translation>
    </message>
    <message>
        <source>change the ball&apos;s radius</source>
        <translation>Kugelradius ändern</translation>
    </message>
    <message>
        <source>change the ball&apos;s radius of %1</source>
        <translation>Kugelradius von %1 ändern</translation>
    </message>
    <message>
        <source>change the operator</source>
        <translation>Namen ändern</translation>
    </message>
    <message>
        <source>move the outline of %1</source>
        <translation>Umriss von %1 verschieben</translation>
    </message>
    <message>
        <source>find the ball of %1</source>
        <translation>Kugel von %1 suchen</translation>
    </message>
    <message>
        <source>leave out %1</source>
        <translation>%1 auslassen</translation>
    </message>
    <message>
        <source>put back %1</source>
        <translation>%1 wieder nutzen</translation>
    </message>
    <message>
        <source>take %1</source>
        <translation>%1 aufnehmen</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message numerus="yes">
        <source>add %n image(s)</source>
        <translation>
            <numerusform>%n Bild hinzufügen</numerusform>
            <numerusform>%n Bilder hinzufügen</numerusform>
        </translation>
    </message>
    <message>
        <source>Presses with these names exist already: %1.</source>
        <translation>Eindrücke mit diesen Namen gibt es schon: %1.</translation>
    </message>
    <message>
        <source>change the measured depth of %1</source>
        <translation>gemessene Tiefe von %1 ändern</translation>
    </message>
    <message>
        <source>change the step of %1</source>
        <translation>Stufe von %1 ändern</translation>
    </message>
    <message>
        <source>&amp;Put back</source>
        <translation>Wieder &amp;nutzen</translation>
    </message>
    <message>
        <source>Leave o&amp;ut</source>
        <translation>A&amp;uslassen</translation>
    </message>
</context>
<context>
    <name>alltact::PressErrorPlot</name>
    <message>
        <source>Error of every press, worst first</source>
        <translation>Fehler jedes Eindrucks, der größte zuerst</translation>
    </message>
    <message numerus="yes">
        <source>The worst of %n press(es) is %1 with %2 mm.</source>
        <translation>
            <numerusform>Von %n Eindruck ist %1 der schlechteste mit %2 mm.</numerusform>
            <numerusform>Von %n Eindrücken ist %1 der schlechteste mit %2 mm.</numerusform>
        </translation>
    </message>
    <message>
        <source>No presses yet</source>
        <translation>Noch keine Eindrücke</translation>
    </message>
    <message>
        <source>%1: %2 mm</source>
        <translation>%1: %2 mm</translation>
    </message>
    <message>
        <source>No press is chosen</source>
        <translation>Kein Eindruck ist gewählt</translation>
    </message>
    <message>
        <source>with this press in the mapping</source>
        <translation>mit diesem Eindruck in der Abbildung</translation>
    </message>
    <message>
        <source>without this press: its error</source>
        <translation>ohne diesen Eindruck: sein Fehler</translation>
    </message>
    <message numerus="yes">
        <source>Mapping minus ball in the contact, mean (mm); %n better press(es) not shown</source>
        <translation>
            <numerusform>Abbildung minus Kugel im Kontakt, im Mittel (mm); %n besserer Eindruck nicht gezeigt</numerusform>
            <numerusform>Abbildung minus Kugel im Kontakt, im Mittel (mm); %n bessere Eindrücke nicht gezeigt</numerusform>
        </translation>
    </message>
    <message>
        <source>Mapping minus ball in the contact, mean (mm)</source>
        <translation>Abbildung minus Kugel im Kontakt, im Mittel (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::PressFitPane</name>
    <message>
        <source>Mapping − ball, mm</source>
        <translation>Abbildung − Kugel, mm</translation>
    </message>
    <message>
        <source>at the calibrated position: %1</source>
        <translation>an der kalibrierten Position: %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Mapping minus ball in this press</source>
        <translation>Abbildung minus Kugel in diesem Eindruck</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mapping − ball here:&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;Abbildung − Kugel hier:&lt;/b&gt; %1</translation>
    </message>
</context>
<context>
    <name>alltact::PressForm</name>
    <message>
        <source>Another &amp;body</source>
        <translation>Anderer &amp;Körper</translation>
    </message>
    <message>
        <source>Mesh of another body</source>
        <translation>Netz eines anderen Körpers</translation>
    </message>
    <message>
        <source>A body of known shape pressed in instead of a ball, such as a rod or a printed part: its closed mesh, STL or OBJ in mm. The program finds its pose.</source>
        <translation>Ein Körper bekannter Form, der statt einer Kugel eingedrückt wird, etwa ein Stab oder ein gedrucktes Teil: sein geschlossenes Netz, STL oder OBJ in mm. Das Programm findet seine Lage.</translation>
    </message>
    <message>
        <source>&amp;Choose a mesh…</source>
        <translation>&amp;Netz auswählen …</translation>
    </message>
    <message>
        <source>A &amp;ball</source>
        <translation>Eine Ku&amp;gel</translation>
    </message>
    <message>
        <source>Mesh of the body</source>
        <translation>Netz des Körpers</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.obj *.STL *.OBJ)</source>
        <translation>Netze (*.stl *.obj *.STL *.OBJ)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Its ball</source>
        <translation>Se&amp;ine Kugel</translation>
    </message>
    <message>
        <source>Radius of this press&apos;s ball</source>
        <translation>Radius der Kugel dieses Eindrucks</translation>
    </message>
    <message>
        <source>If this press was made with a ball of another radius</source>
        <translation>Falls dieser Eindruck mit einer Kugel von anderem Radius gemacht wurde</translation>
    </message>
    <message>
        <source>Measured &amp;depth</source>
        <translation>Gemessene &amp;Tiefe</translation>
    </message>
    <message>
        <source>Measured depth of this press</source>
        <translation>Gemessene Tiefe dieses Eindrucks</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>Indentation depth of the ball from first contact, normal to the face, measured with a stage or a feeler gauge</source>
        <translation>Eindrucktiefe der Kugel ab der ersten Berührung, senkrecht zur Fläche, mit Verschiebetisch oder Fühlerlehre gemessen</translation>
    </message>
    <message>
        <source>&amp;Give or take</source>
        <translation>&amp;Plus oder minus</translation>
    </message>
    <message>
        <source>Standard deviation of the measured depth</source>
        <translation>Standardabweichung der gemessenen Tiefe</translation>
    </message>
    <message>
        <source>Uncertainty of the depth: the standard deviation of its measurement</source>
        <translation>Unsicherheit der Tiefe: die Standardabweichung ihrer Messung</translation>
    </message>
    <message>
        <source>&amp;Step of a punch</source>
        <translation>Stu&amp;fe des Stempels</translation>
    </message>
    <message>
        <source>Step of a punch</source>
        <translation>Stufe des Stempels</translation>
    </message>
    <message>
        <source>a ball</source>
        <translation>eine Kugel</translation>
    </message>
    <message>
        <source>Step height of a flat punch pressed in instead of a ball; the program then searches for no ball</source>
        <translation>Stufenhöhe eines flachen Stempels, der statt einer Kugel eingedrückt wurde; dann wird keine Kugel gesucht</translation>
    </message>
</context>
<context>
    <name>alltact::PressLightPlot</name>
    <message>
        <source>Light of every press</source>
        <translation>Licht jedes Eindrucks</translation>
    </message>
    <message>
        <source>No presses yet</source>
        <translation>Noch keine Eindrücke</translation>
    </message>
    <message>
        <source>Press, by number</source>
        <translation>Eindruck, nach Nummer</translation>
    </message>
    <message>
        <source>Light (%)</source>
        <translation>Licht (%)</translation>
    </message>
</context>
<context>
    <name>alltact::PressModel</name>
    <message>
        <source>depths on %1 read %2 % of the true ones</source>
        <translation>Tiefen auf %1 werden mit %2 % der wahren gelesen</translation>
    </message>
    <message>
        <source>the body %1</source>
        <translation>der Körper %1</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>ausgelassen: %1</translation>
    </message>
    <message>
        <source>ball set by hand</source>
        <translation>Kugel von Hand gesetzt</translation>
    </message>
    <message>
        <source>being analysed</source>
        <translation>wird ausgewertet</translation>
    </message>
    <message>
        <source>ball found</source>
        <translation>Kugel gefunden</translation>
    </message>
    <message>
        <source>the ball&apos;s radius is missing</source>
        <translation>der Radius der Kugel fehlt</translation>
    </message>
    <message>
        <source>%1 mm step measured as %2 mm</source>
        <translation>Stufe von %1 mm, gemessen %2 mm</translation>
    </message>
    <message>
        <source>a punch with a step of %1 mm</source>
        <translation>ein Stempel mit einer Stufe von %1 mm</translation>
    </message>
    <message>
        <source>depth measured %1 mm, fitted %2 mm</source>
        <translation>Tiefe gemessen %1 mm, berechnet %2 mm</translation>
    </message>
    <message>
        <source>no face found</source>
        <translation>keine Fläche gefunden</translation>
    </message>
    <message>
        <source>not comparable</source>
        <translation>nicht vergleichbar</translation>
    </message>
    <message>
        <source>nothing pressed in</source>
        <translation>nichts eingedrückt</translation>
    </message>
    <message>
        <source>only specks</source>
        <translation>nur Flecken</translation>
    </message>
    <message>
        <source>two contacts</source>
        <translation>zwei Kontakte</translation>
    </message>
    <message>
        <source>larger than the ball</source>
        <translation>größer als die Kugel</translation>
    </message>
    <message>
        <source>over the edge</source>
        <translation>über den Rand hinaus</translation>
    </message>
    <message>
        <source>no disc of a ball</source>
        <translation>keine Kugelscheibe</translation>
    </message>
    <message>
        <source>not usable</source>
        <translation>nicht brauchbar</translation>
    </message>
    <message>
        <source>%1 mm deep, error %2 mm: %3</source>
        <translation>%1 mm tief, Fehler %2 mm: %3</translation>
    </message>
    <message>
        <source>not saved to disk</source>
        <translation>nicht auf Platte gespeichert</translation>
    </message>
    <message>
        <source>%1 mm deep, error unknown</source>
        <translation>%1 mm tief, Fehler unbekannt</translation>
    </message>
</context>
<context>
    <name>alltact::PressesPage</name>
    <message>
        <source>Paused while a press is shown.</source>
        <translation>Pausiert, solange ein Eindruck gezeigt wird.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Presses</source>
        <translation>Eindrücke</translation>
    </message>
    <message>
        <source>&amp;Add images…</source>
        <translation>Bilder hin&amp;zufügen…</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Removes the press and its image (undo restores them)</source>
        <translation>Entfernt den Eindruck und sein Bild (Rückgängig stellt sie wieder her)</translation>
    </message>
    <message>
        <source>&amp;Live image</source>
        <translation>&amp;Livebild</translation>
    </message>
    <message>
        <source>Taking presses</source>
        <translation>Eindrücke aufnehmen</translation>
    </message>
    <message>
        <source>This press</source>
        <translation>Dieser Eindruck</translation>
    </message>
    <message>
        <source>Ball&apos;s &amp;radius</source>
        <translation>&amp;Radius der Kugel</translation>
    </message>
    <message>
        <source>Ball&apos;s radius</source>
        <translation>Radius der Kugel</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>&amp;Operator</source>
        <translation>Wer m&amp;isst</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Wer misst</translation>
    </message>
    <message>
        <source>for the record</source>
        <translation>fürs Protokoll</translation>
    </message>
    <message>
        <source>&amp;Take a press (Space)</source>
        <translation>Eindruck auf&amp;nehmen (Leertaste)</translation>
    </message>
    <message>
        <source>Automat&amp;ically when still</source>
        <translation>Automati&amp;sch im Stillstand</translation>
    </message>
    <message>
        <source>Takes a press as soon as a contact holds still for half a second; both hands stay free</source>
        <translation>Nimmt auf, sobald ein Kontakt eine halbe Sekunde stillhält; beide Hände bleiben frei</translation>
    </message>
    <message>
        <source>&amp;Find the ball again</source>
        <translation>Kugel neu &amp;suchen</translation>
    </message>
    <message>
        <source>Discards the outline position set by hand</source>
        <translation>Verwirft die von Hand gesetzte Position des Umrisses</translation>
    </message>
    <message>
        <source>Yellow: the ball&apos;s outline, dashed if found by the program, solid if set by hand. Blue: where the ball meets the untouched face, roughly the dark disc.</source>
        <translation>Gelb: der Umriss der Kugel, gestrichelt, wenn das Programm ihn fand, durchgezogen, wenn er von Hand gesetzt ist. Blau: wo die Kugel die unberührte Fläche schneidet, etwa die dunkle Scheibe.</translation>
    </message>
    <message>
        <source>Position of the ball</source>
        <translation>Position der Kugel</translation>
    </message>
    <message>
        <source>The presses are being read.</source>
        <translation>Die Eindrücke werden gelesen.</translation>
    </message>
    <message>
        <source>The ball&apos;s radius is missing.</source>
        <translation>Der Radius der Kugel fehlt.</translation>
    </message>
    <message>
        <source>Take a press first, best six at different positions.</source>
        <translation>Nehmen Sie zuerst einen Eindruck auf, am besten sechs an verschiedenen Positionen.</translation>
    </message>
    <message>
        <source>No ball was found in any press yet.</source>
        <translation>Bisher wurde in keinem Eindruck eine Kugel gefunden.</translation>
    </message>
    <message>
        <source>There is no live image: choose a source.</source>
        <translation>Es gibt kein Livebild: Wählen Sie eine Quelle.</translation>
    </message>
    <message>
        <source>The finger cannot be compared with its reference.</source>
        <translation>Der Finger kann nicht mit seiner Referenz verglichen werden.</translation>
    </message>
    <message>
        <source>The live image does not match this finger.</source>
        <translation>Das Livebild passt nicht zu diesem Finger.</translation>
    </message>
    <message>
        <source>Images of presses</source>
        <translation>Bilder von Eindrücken</translation>
    </message>
    <message>
        <source>Try: %1.</source>
        <translation>Abhilfe: %1.</translation>
    </message>
    <message>
        <source>Or drag the outline onto the ball.</source>
        <translation>Oder ziehen Sie den Umriss auf die Kugel.</translation>
    </message>
    <message>
        <source>At this position, it is pressed in by %1 mm.</source>
        <translation>In dieser Position ist sie %1 mm eingedrückt.</translation>
    </message>
    <message>
        <source>At this position, it does not touch the face.</source>
        <translation>In dieser Position berührt sie die Fläche nicht.</translation>
    </message>
    <message>
        <source>Chosen &amp;press</source>
        <translation>&amp;Gewählter Eindruck</translation>
    </message>
    <message>
        <source>A press that is left out stays with the finger and is not used</source>
        <translation>Ein ausgelassener Eindruck bleibt beim Finger und wird nicht verwendet</translation>
    </message>
    <message>
        <source>The image is being read.</source>
        <translation>Das Bild wird gelesen.</translation>
    </message>
    <message>
        <source>Centre u %1 px, v %2 px, radius %3 px, %4 mm from the camera</source>
        <translation>Mitte u %1 px, v %2 px, Radius %3 px, %4 mm vor der Kamera</translation>
    </message>
    <message>
        <source>No ball is drawn here.</source>
        <translation>Hier ist keine Kugel gezeichnet.</translation>
    </message>
    <message>
        <source>No press yet. Press the ball in at different positions and depths: base, middle and tip.</source>
        <translation>Noch kein Eindruck. Drücken Sie die Kugel an verschiedenen Positionen und verschieden tief ein: Fuß, Mitte und Spitze.</translation>
    </message>
    <message numerus="yes">
        <source>%n press(es), </source>
        <translation>
            <numerusform>%n Eindruck, </numerusform>
            <numerusform>%n Eindrücke, </numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n usable</source>
        <translation>
            <numerusform>%n brauchbar</numerusform>
            <numerusform>%n brauchbar</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is taken: the mean of %2 still images.</source>
        <translation>%1 ist aufgenommen: das Mittel von %2 ruhigen Bildern.</translation>
    </message>
    <message>
        <source>%1 is a single image: half a second held still would quarter its noise.</source>
        <translation>%1 ist ein einzelnes Bild: Eine halbe Sekunde stillgehalten, viertelt sich das Rauschen.</translation>
    </message>
    <message>
        <source>&amp;Error under the ball</source>
        <translation>&amp;Fehler unter der Kugel</translation>
    </message>
    <message>
        <source>Shows in colour where the mapping is deeper (red) or shallower (blue) than the ball</source>
        <translation>Zeigt in Farbe, wo die Abbildung tiefer (rot) oder flacher (blau) misst als die Kugel</translation>
    </message>
    <message>
        <source>Next press position</source>
        <translation>Nächste Position</translation>
    </message>
    <message>
        <source>Depth, ball or punch</source>
        <translation>Tiefe, Kugel, Stempel</translation>
    </message>
    <message>
        <source>Press %1</source>
        <translation>Eindruck %1</translation>
    </message>
    <message>
        <source>Waiting: it is unknown whether something touches the face.</source>
        <translation>Warten: Es ist unklar, ob etwas die Fläche berührt.</translation>
    </message>
    <message>
        <source>Waiting: no contact yet.</source>
        <translation>Warten: noch kein Kontakt.</translation>
    </message>
    <message>
        <source>Waiting: the contact still moves or gets deeper.</source>
        <translation>Warten: Der Kontakt bewegt sich noch oder wird tiefer.</translation>
    </message>
    <message>
        <source>Taken. For the next one, lift the ball or move it by 2 mm.</source>
        <translation>Aufgenommen. Heben Sie die Kugel für den nächsten ab oder versetzen Sie sie um 2 mm.</translation>
    </message>
    <message>
        <source>Holds still.</source>
        <translation>Hält still.</translation>
    </message>
    <message>
        <source>Six presses are taken. Tick it again to take six more.</source>
        <translation>Sechs Eindrücke sind aufgenommen. Haken Sie es wieder an, um sechs weitere aufzunehmen.</translation>
    </message>
    <message>
        <source>Waiting for the ball&apos;s radius.</source>
        <translation>Wartet auf den Radius der Kugel.</translation>
    </message>
    <message>
        <source>Adds stored images of presses; they can be dropped here, too</source>
        <translation>Fügt gespeicherte Bilder von Eindrücken hinzu, auch durch Ziehen hierher</translation>
    </message>
    <message>
        <source>Shows the camera, for the next press</source>
        <translation>Zeigt die Kamera, für den nächsten Eindruck</translation>
    </message>
    <message>
        <source>Your name or initials, stored with the presses</source>
        <translation>Ihr Name oder Kürzel; wird mit den Eindrücken gespeichert</translation>
    </message>
    <message>
        <source>Stores the present image as a press of the ball</source>
        <translation>Speichert das jetzige Bild als Eindruck der Kugel</translation>
    </message>
    <message>
        <source>For a press with another ball, a known depth, or a punch</source>
        <translation>Für einen Eindruck mit anderer Kugel, bekannter Tiefe oder einem Stempel</translation>
    </message>
    <message>
        <source>Shows the press that is chosen in the list</source>
        <translation>Zeigt den in der Liste gewählten Eindruck</translation>
    </message>
    <message>
        <source>Half of the diameter that a caliper or the data sheet gives</source>
        <translation>Die Hälfte des Durchmessers, den Messschieber oder Datenblatt angeben</translation>
    </message>
</context>
<context>
    <name>alltact::PressesPlot</name>
    <message>
        <source>Depth error by number of presses</source>
        <translation>Tiefenfehler nach Zahl der Eindrücke</translation>
    </message>
    <message>
        <source>Nothing is computed yet</source>
        <translation>Noch nichts berechnet</translation>
    </message>
    <message>
        <source>painted balls, whisker to 95 %</source>
        <translation>gezeichnete Kugeln, Strich bis 95 %</translation>
    </message>
    <message>
        <source>current presses</source>
        <translation>vorhandene Eindrücke</translation>
    </message>
    <message>
        <source>real presses left out</source>
        <translation>echte Eindrücke, ausgelassen</translation>
    </message>
    <message>
        <source>Presses</source>
        <translation>Eindrücke</translation>
    </message>
    <message numerus="yes">
        <source>%n press(es): %1 mm</source>
        <translation>
            <numerusform>%n Eindruck: %1 mm</numerusform>
            <numerusform>%n Eindrücke: %1 mm</numerusform>
        </translation>
    </message>
    <message>
        <source>Depth error (mm)</source>
        <translation>Tiefenfehler (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::NotificationBar</name>
    <message>
        <source>The program ended unexpectedly last time.</source>
        <translation>Das Programm endete das letzte Mal unerwartet.</translation>
    </message>
    <message>
        <source>Your work is saved.</source>
        <translation>Ihre Arbeit ist gespeichert.</translation>
    </message>
    <message>
        <source>&amp;Go on with it</source>
        <translation>Damit &amp;weitermachen</translation>
    </message>
    <message>
        <source>The foot pedal sends no signal now.</source>
        <translation>Das Fußpedal sendet gerade kein Signal.</translation>
    </message>
    <message>
        <source>The source has ended; its last image is shown.</source>
        <translation>Die Quelle ist zu Ende; ihr letztes Bild wird gezeigt.</translation>
    </message>
    <message>
        <source>&amp;Play it again</source>
        <translation>Noch einmal a&amp;bspielen</translation>
    </message>
</context>
<context>
    <name>alltact::ProblemList</name>
    <message>
        <source>Try: %1</source>
        <translation>Abhilfe: %1</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Dismiss until it happens again</source>
        <translation>Ausblenden, bis es wieder auftritt</translation>
    </message>
    <message>
        <source>Dismiss: %1</source>
        <translation>Ausblenden: %1</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message numerus="yes">
        <source>%n min ago</source>
        <translation>
            <numerusform>vor %n min</numerusform>
            <numerusform>vor %n min</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n h ago</source>
        <translation>
            <numerusform>vor %n h</numerusform>
            <numerusform>vor %n h</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n weitere</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Show only the newest</source>
        <translation>Nur die neueste zeigen</translation>
    </message>
    <message>
        <source>Show all in full</source>
        <translation>Alle vollständig zeigen</translation>
    </message>
    <message>
        <source>Does what the message advises</source>
        <translation>Tut, was die Meldung empfiehlt</translation>
    </message>
</context>
<context>
    <name>alltact::QuickGuide</name>
    <message>
        <source>AllTact Studio: quick guide</source>
        <translation>AllTact Studio: Kurzanleitung</translation>
    </message>
</context>
<context>
    <name>alltact::NavigationBar</name>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Strg+%2)</translation>
    </message>
</context>
<context>
    <name>alltact::ReadingDialog</name>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;Lower limit</source>
        <translation>&amp;Untere Grenze</translation>
    </message>
    <message>
        <source>&amp;Upper limit</source>
        <translation>&amp;Obere Grenze</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>Geben Sie einen Namen ein.</translation>
    </message>
    <message>
        <source>Another reading has this name.</source>
        <translation>Eine andere Messung hat diesen Namen.</translation>
    </message>
    <message>
        <source>The lower limit must be below the upper one.</source>
        <translation>Die untere Grenze muss unter der oberen liegen.</translation>
    </message>
    <message>
        <source>Takes this name and these limits</source>
        <translation>Übernimmt Namen und Grenzen</translation>
    </message>
    <message>
        <source>Closes this window without a change (Esc)</source>
        <translation>Schließt dieses Fenster ohne Änderung (Esc)</translation>
    </message>
    <message>
        <source>Name of the value in tables and reports</source>
        <translation>Name des Werts in Tabellen und Berichten</translation>
    </message>
    <message>
        <source>A value beyond it fails; near it, the standard deviation decides</source>
        <translation>Ein Wert jenseits davon fällt durch; nahe daran entscheidet die Standardabweichung</translation>
    </message>
</context>
<context>
    <name>alltact::ReadingPlot</name>
    <message>
        <source>No value was measured</source>
        <translation>Es wurde kein Wert gemessen</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
</context>
<context>
    <name>alltact::RecipeBox</name>
    <message>
        <source>pass</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>fail</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>unentschieden</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>no tolerance</source>
        <translation>ohne Toleranz</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 bis %2 %3</translation>
    </message>
    <message>
        <source>at least %1 %2</source>
        <translation>mindestens %1 %2</translation>
    </message>
    <message>
        <source>at most %1 %2</source>
        <translation>höchstens %1 %2</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Prüfplan</translation>
    </message>
    <message>
        <source>Readings to repeat on every frame, with their tolerances. Select a reading between A and B, then Add to recipe; or open a recipe.</source>
        <translation>Messungen, die in jedem Bild wiederholt werden, mit ihren Toleranzen. Wählen Sie eine Messung zwischen A und B, dann „In den Prüfplan“; oder öffnen Sie einen Prüfplan.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>Entscheid</translation>
    </message>
    <message>
        <source>Readings of the recipe</source>
        <translation>Messungen des Prüfplans</translation>
    </message>
    <message>
        <source>Name, tolerance…</source>
        <translation>Name, Toleranz…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Open recipe…</source>
        <translation>Prüfplan öffnen…</translation>
    </message>
    <message>
        <source>Save recipe…</source>
        <translation>Prüfplan speichern…</translation>
    </message>
    <message>
        <source>Inspect all frames…</source>
        <translation>Alle Bilder auswerten…</translation>
    </message>
    <message>
        <source>Measures the recipe in every frame of the recording</source>
        <translation>Misst den Prüfplan in jedem Bild der Aufnahme</translation>
    </message>
    <message>
        <source>add a reading to the recipe</source>
        <translation>Messung in den Prüfplan aufnehmen</translation>
    </message>
    <message>
        <source>change a reading of the recipe</source>
        <translation>Messung des Prüfplans ändern</translation>
    </message>
    <message>
        <source>remove a reading from the recipe</source>
        <translation>Messung aus dem Prüfplan entfernen</translation>
    </message>
    <message>
        <source>open a recipe</source>
        <translation>Prüfplan öffnen</translation>
    </message>
    <message>
        <source>Open a recipe</source>
        <translation>Prüfplan öffnen</translation>
    </message>
    <message>
        <source>Recipes (*.yaml *.yml)</source>
        <translation>Prüfpläne (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>Save the recipe</source>
        <translation>Prüfplan speichern</translation>
    </message>
    <message>
        <source>Name and limits of the selected reading</source>
        <translation>Name und Grenzen des gewählten Messwerts</translation>
    </message>
    <message>
        <source>Takes the selected reading out of the recipe</source>
        <translation>Nimmt den gewählten Messwert aus dem Rezept</translation>
    </message>
    <message>
        <source>Replaces the readings by those of a file</source>
        <translation>Ersetzt die Messwerte durch die einer Datei</translation>
    </message>
    <message>
        <source>Writes the readings to a file, for other recordings and fingers</source>
        <translation>Schreibt die Messwerte in eine Datei, für andere Aufnahmen und Finger</translation>
    </message>
    <message>
        <source>Inspect a folder…</source>
        <translation>Ordner auswerten…</translation>
    </message>
    <message>
        <source>Measures the recipe in every recording of a folder: one table</source>
        <translation>Misst das Rezept in jeder Aufnahme eines Ordners: eine Tabelle</translation>
    </message>
</context>
<context>
    <name>alltact::RecordPage</name>
    <message>
        <source>Tick frames that are untouched, and install.</source>
        <translation>Unberührte Bilder ankreuzen und einrichten.</translation>
    </message>
    <message>
        <source>Inspect t&amp;his recording</source>
        <translation>Diese Aufnahme aus&amp;werten</translation>
    </message>
    <message>
        <source>Bend it in all directions</source>
        <translation>In alle Richtungen biegen</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Recorded video</source>
        <translation>Aufgenommenes Video</translation>
    </message>
    <message>
        <source>Recording file</source>
        <translation>Aufnahmedatei</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Wählen…</translation>
    </message>
    <message>
        <source>&amp;Install as this finger&apos;s reference</source>
        <translation>Als Referenz dieses Fingers &amp;einrichten</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Stops the installation; nothing is changed.</source>
        <translation>Bricht die Einrichtung ab; nichts wird geändert.</translation>
    </message>
    <message>
        <source>Progress of the installation</source>
        <translation>Fortschritt der Einrichtung</translation>
    </message>
    <message>
        <source>Frames that were left out, with the reason</source>
        <translation>Weggelassene Bilder mit Grund</translation>
    </message>
    <message>
        <source>If it was cleaned, painted or replaced, the last reference cannot show what pressed on it.</source>
        <translation>Wurde sie gereinigt, gestrichen oder ersetzt, zeigt die letzte Referenz nicht, was auf sie drückte.</translation>
    </message>
    <message>
        <source>The &amp;skin was changed since the last reference</source>
        <translation>Die &amp;Haut wurde seit der letzten Referenz verändert</translation>
    </message>
    <message>
        <source>The markers must be visible to measure its bending.</source>
        <translation>Um die Biegung zu messen, müssen die Marken sichtbar sein.</translation>
    </message>
    <message>
        <source>Enough: all directions reached.</source>
        <translation>Genug: Alle Richtungen sind erreicht.</translation>
    </message>
    <message>
        <source>Still missing: %1.</source>
        <translation>Es fehlen noch: %1.</translation>
    </message>
    <message>
        <source>What was found in the recording</source>
        <translation>Was in der Aufnahme gefunden wurde</translation>
    </message>
    <message>
        <source>An image shows what was found in the recording, and what was not.</source>
        <translation>Ein Bild zeigt, was in der Aufnahme gefunden wurde und was nicht.</translation>
    </message>
    <message>
        <source>Show the image</source>
        <translation>Bild zeigen</translation>
    </message>
    <message>
        <source>Set res&amp;t pose</source>
        <translation>Ruhelage se&amp;tzen</translation>
    </message>
    <message>
        <source>Click when the finger hangs free; bending is measured from here.</source>
        <translation>Klicken, wenn der Finger frei hängt; die Biegung wird ab hier gemessen.</translation>
    </message>
    <message>
        <source>Bending is measured from the rest pose that was set.</source>
        <translation>Die Biegung wird ab der gesetzten Ruhelage gemessen.</translation>
    </message>
    <message>
        <source>Bending is measured from the middle of all poses.</source>
        <translation>Die Biegung wird ab der Mitte aller Lagen gemessen.</translation>
    </message>
    <message>
        <source>Record to</source>
        <translation>Aufnehmen nach</translation>
    </message>
    <message>
        <source>Video (*.mkv)</source>
        <translation>Video (*.mkv)</translation>
    </message>
    <message>
        <source>The recording is being installed.</source>
        <translation>Die Aufnahme wird eingerichtet.</translation>
    </message>
    <message>
        <source>The last frames are being written.</source>
        <translation>Die letzten Bilder werden geschrieben.</translation>
    </message>
    <message>
        <source>Open a source first: a camera, or the simulated finger.</source>
        <translation>Öffnen Sie zuerst eine Quelle: eine Kamera oder den simulierten Finger.</translation>
    </message>
    <message>
        <source>Stop &amp;recording</source>
        <translation>Aufnahme a&amp;nhalten</translation>
    </message>
    <message>
        <source>&lt;b&gt;Recording&lt;/b&gt; %1 min&lt;br&gt;%2, %3, %4 GB</source>
        <translation>&lt;b&gt;Aufnahme läuft&lt;/b&gt; %1 min&lt;br&gt;%2, %3, %4 GB</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lost</source>
        <translation>
            <numerusform>%n verloren</numerusform>
            <numerusform>%n verloren</numerusform>
        </translation>
    </message>
    <message>
        <source>Space left: %1 GB</source>
        <translation>Freier Platz: %1 GB</translation>
    </message>
    <message>
        <source>Open the finger that was recorded first.</source>
        <translation>Öffnen Sie zuerst den Finger, der aufgenommen wurde.</translation>
    </message>
    <message>
        <source>A flat sensor has one untouched image instead of a recording.</source>
        <translation>Ein flacher Sensor hat statt einer Aufnahme ein einziges unberührtes Bild.</translation>
    </message>
    <message>
        <source>A recording is running.</source>
        <translation>Eine Aufnahme läuft.</translation>
    </message>
    <message>
        <source>%1: %2, %3 min</source>
        <translation>%1: %2, %3 min</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) were lost because this computer or its disk was too slow.</source>
        <translation>
            <numerusform>%n Bild ging verloren, weil dieser Rechner oder sein Datenträger zu langsam war.</numerusform>
            <numerusform>%n Bilder gingen verloren, weil dieser Rechner oder sein Datenträger zu langsam war.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) did not arrive from the source.</source>
        <translation>
            <numerusform>%n Bild kam nicht von der Quelle an.</numerusform>
            <numerusform>%n Bilder kamen nicht von der Quelle an.</numerusform>
        </translation>
    </message>
    <message>
        <source>No frame was lost.</source>
        <translation>Kein Bild ging verloren.</translation>
    </message>
    <message>
        <source>Reading the recording…</source>
        <translation>Die Aufnahme wird gelesen…</translation>
    </message>
    <message numerus="yes">
        <source>About %n second(s) left.</source>
        <translation>
            <numerusform>Noch etwa %n Sekunde.</numerusform>
            <numerusform>Noch etwa %n Sekunden.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) of this recording are lost.</source>
        <translation>
            <numerusform>%n Bild dieser Aufnahme ist verloren.</numerusform>
            <numerusform>%n Bilder dieser Aufnahme sind verloren.</numerusform>
        </translation>
    </message>
    <message>
        <source>Try another disk, or a smaller image.</source>
        <translation>Versuchen Sie einen anderen Datenträger oder ein kleineres Bild.</translation>
    </message>
    <message>
        <source>Keep it free: bend the finger at its tip, its sides or its back.</source>
        <translation>Halten Sie sie frei: Biegen Sie den Finger an Spitze, Seiten oder Rücken.</translation>
    </message>
    <message>
        <source>Little space is left on the disk.</source>
        <translation>Auf dem Datenträger ist wenig Platz.</translation>
    </message>
    <message>
        <source>Choose a file on another disk, or make room.</source>
        <translation>Wählen Sie eine Datei auf einem anderen Datenträger, oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>Start &amp;recording</source>
        <translation>Aufnahme &amp;starten</translation>
    </message>
    <message>
        <source>It is unknown whether something touches the contact face.</source>
        <translation>Es ist unklar, ob etwas die Kontaktfläche berührt.</translation>
    </message>
    <message>
        <source>Open the finger that belongs to this source, and keep both edges of its face in the image.</source>
        <translation>Öffnen Sie den Finger, der zu dieser Quelle gehört, und halten Sie beide Kanten seiner Fläche im Bild.</translation>
    </message>
    <message>
        <source>Without a reference, contact is detected from the preceding frames.</source>
        <translation>Ohne Referenz werden Berührungen an den vorherigen Bildern erkannt.</translation>
    </message>
    <message>
        <source>Begin with nothing on the contact face.</source>
        <translation>Beginnen Sie mit freier Kontaktfläche.</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Aufnehmen</translation>
    </message>
    <message>
        <source>This finger has no reference recording yet.</source>
        <translation>Dieser Finger hat noch keine Referenzaufnahme.</translation>
    </message>
    <message>
        <source>Record it bending, with nothing on its contact face.</source>
        <translation>Nehmen Sie ihn beim Biegen auf, ohne etwas auf der Kontaktfläche.</translation>
    </message>
    <message>
        <source>It was not twisted; twist it, too, if it twists in use.</source>
        <translation>Er wurde nicht verdreht; verdrehen Sie ihn auch, wenn das im Einsatz vorkommt.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>&amp;Keep for later</source>
        <translation>&amp;Für später aufheben</translation>
    </message>
    <message>
        <source>The video stays where it is, and the finger stays as it is.</source>
        <translation>Das Video bleibt, wo es ist, und der Finger bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>Record a&amp;gain</source>
        <translation>Noch e&amp;inmal aufnehmen</translation>
    </message>
    <message>
        <source>Moves this video to the trash and records a new one.</source>
        <translation>Verschiebt dieses Video in den Papierkorb und nimmt ein neues auf.</translation>
    </message>
    <message>
        <source>Follow the outline: %1</source>
        <translation>Dem Umriss folgen: %1</translation>
    </message>
    <message>
        <source>Video of the bending finger</source>
        <translation>Video des sich biegenden Fingers</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) with contact are left out.</source>
        <translation>
            <numerusform>%n Bild mit Berührung wird ausgelassen.</numerusform>
            <numerusform>%n Bilder mit Berührung werden ausgelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The expected error is being computed, about %n second(s).</source>
        <translation>
            <numerusform>Der erwartete Fehler wird berechnet, noch etwa %n Sekunde.</numerusform>
            <numerusform>Der erwartete Fehler wird berechnet, noch etwa %n Sekunden.</numerusform>
        </translation>
    </message>
    <message>
        <source>The expected error is being computed.</source>
        <translation>Der erwartete Fehler wird berechnet.</translation>
    </message>
    <message>
        <source>It cannot be installed: %1</source>
        <translation>Sie kann nicht eingerichtet werden: %1</translation>
    </message>
    <message numerus="yes">
        <source>Expected error: half of the references off by less than %1 mm, 95 % by less than %2 mm, from %n frame(s).</source>
        <translation>
            <numerusform>Erwarteter Fehler: die Hälfte der Referenzen unter %1 mm, 95 % unter %2 mm, aus %n Bild.</numerusform>
            <numerusform>Erwarteter Fehler: die Hälfte der Referenzen unter %1 mm, 95 % unter %2 mm, aus %n Bildern.</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Ctrl+R, or Space</source>
        <translation>Strg+R oder Leertaste</translation>
    </message>
    <message>
        <source>Something touches the contact face; such frames are left out.</source>
        <translation>Etwas berührt die Kontaktfläche; solche Bilder werden ausgelassen.</translation>
    </message>
    <message>
        <source>&amp;Go to Calibrate</source>
        <translation>&amp;Weiter zu Kalibrieren</translation>
    </message>
    <message numerus="yes">
        <source>room for about %n minute(s)</source>
        <translation>
            <numerusform>reicht für etwa %n Minute</numerusform>
            <numerusform>reicht für etwa %n Minuten</numerusform>
        </translation>
    </message>
    <message>
        <source>Fi&amp;le</source>
        <translation>Dat&amp;ei</translation>
    </message>
    <message>
        <source>Install an e&amp;xisting video…</source>
        <translation>Vorhandenes &amp;Video einrichten…</translation>
    </message>
    <message>
        <source>Installed.</source>
        <translation>Installiert.</translation>
    </message>
    <message>
        <source>Installed; the finger is being loaded with it.</source>
        <translation>Installiert; der Finger wird damit geladen.</translation>
    </message>
    <message>
        <source>Chooses the file to record to</source>
        <translation>Wählt die Datei der Aufnahme</translation>
    </message>
    <message>
        <source>Depth is measured against it from now on; undo restores the one before</source>
        <translation>Tiefe wird von nun an dagegen gemessen; Rückgängig stellt die vorige her</translation>
    </message>
    <message>
        <source>Opens it on the page Inspect</source>
        <translation>Öffnet sie auf der Seite Auswerten</translation>
    </message>
    <message>
        <source>There presses of a ball give the depth</source>
        <translation>Dort ergeben Eindrücke einer Kugel die Tiefe</translation>
    </message>
    <message>
        <source>Examines a stored recording as if it had just been made</source>
        <translation>Untersucht eine gespeicherte Aufnahme wie eine neue</translation>
    </message>
    <message>
        <source>The finger keeps its present reference</source>
        <translation>Der Finger behält seine jetzige Referenz</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>What the recording is for</source>
        <translation>Zweck der Aufnahme</translation>
    </message>
    <message>
        <source>A reference shows the bending finger with nothing on its face; a measurement shows what is to be measured.</source>
        <translation>Eine Referenz zeigt den sich biegenden Finger mit freier Kontaktfläche, eine Messung das, was gemessen werden soll.</translation>
    </message>
    <message>
        <source>Length of the recording</source>
        <translation>Dauer der Aufnahme</translation>
    </message>
    <message>
        <source>until stopped</source>
        <translation>bis zum Anhalten</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>The recording stops by itself after so many seconds; 0: only when it is stopped.</source>
        <translation>Nach so vielen Sekunden hält die Aufnahme von selbst an; 0: erst, wenn sie angehalten wird.</translation>
    </message>
    <message>
        <source>The video goes into the finger&apos;s folder. It is neither judged nor installed, so the finger may touch anything.</source>
        <translation>Das Video kommt in den Ordner des Fingers. Es wird weder beurteilt noch eingerichtet; der Finger darf also alles berühren.</translation>
    </message>
    <message>
        <source>Saved. A measurement is neither judged nor installed.</source>
        <translation>Gespeichert. Eine Messung wird weder beurteilt noch eingerichtet.</translation>
    </message>
    <message>
        <source>It records</source>
        <translation>Es wird aufgenommen</translation>
    </message>
    <message>
        <source>It does not record</source>
        <translation>Es wird nicht aufgenommen</translation>
    </message>
    <message>
        <source>for </source>
        <comment>before a number of seconds</comment>
        <translation>für </translation>
    </message>
</context>
<context>
    <name>alltact::RigCheckBox</name>
    <message>
        <source>Focus at the base</source>
        <translation>Schärfe am Fuß</translation>
    </message>
    <message>
        <source>Focus at the tip</source>
        <translation>Schärfe an der Spitze</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>Dots</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Before the first recording</source>
        <translation>Vor der ersten Aufnahme</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Camera: all modes are manual.</source>
        <translation>Kamera: Keine Automatik ist an.</translation>
    </message>
    <message>
        <source>Camera: %1 is on and changes the measured brightness. Lock brightness on the Live page, or switch it off there.</source>
        <translation>Kamera: %1 ist an und ändert die gemessene Helligkeit. Sperren Sie auf der Seite Live die Helligkeit, oder schalten Sie dort diese Automatik ab.</translation>
    </message>
    <message numerus="yes">
        <source>Before the first recording: %n to fix</source>
        <translation>
            <numerusform>Vor der ersten Aufnahme: %n zu beheben</numerusform>
            <numerusform>Vor der ersten Aufnahme: %n zu beheben</numerusform>
        </translation>
    </message>
    <message>
        <source>What is checked before the first recording; a click shows or hides it</source>
        <translation>Was vor der ersten Aufnahme geprüft wird; ein Klick zeigt oder verbirgt es</translation>
    </message>
</context>
<context>
    <name>alltact::SaveBar</name>
    <message>
        <source>Mesh, PLY</source>
        <translation>Netz, PLY</translation>
    </message>
    <message>
        <source>Mesh, VTP (VTK)</source>
        <translation>Netz, VTP (VTK)</translation>
    </message>
    <message>
        <source>Mesh, STL</source>
        <translation>Netz, STL</translation>
    </message>
    <message>
        <source>Mesh, glTF</source>
        <translation>Netz, glTF</translation>
    </message>
    <message>
        <source>Video in 3D, MKV</source>
        <translation>Video in 3D, MKV</translation>
    </message>
    <message>
        <source>Content to save</source>
        <translation>Zu speichernder Inhalt</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern …</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Progress of saving</source>
        <translation>Fortschritt des Speicherns</translation>
    </message>
    <message>
        <source>Image, PNG (300 dpi)</source>
        <translation>Bild, PNG (300 dpi)</translation>
    </message>
    <message>
        <source>Cross-section, PDF</source>
        <translation>Querschnitt, PDF</translation>
    </message>
    <message>
        <source>Cross-section, SVG</source>
        <translation>Querschnitt, SVG</translation>
    </message>
    <message>
        <source>Cross-section, CSV</source>
        <translation>Querschnitt, CSV</translation>
    </message>
    <message>
        <source>Depth map in mm, TIFF</source>
        <translation>Tiefenkarte in mm, TIFF</translation>
    </message>
    <message>
        <source>What is saved, and in which format</source>
        <translation>Was gespeichert wird, und in welchem Format</translation>
    </message>
    <message>
        <source>Asks for the file to write</source>
        <translation>Fragt nach der Datei</translation>
    </message>
    <message>
        <source>Ends saving; a video has what was saved so far</source>
        <translation>Beendet das Speichern; ein Video behält das Gespeicherte</translation>
    </message>
</context>
<context>
    <name>alltact::SecondCameraDialog</name>
    <message>
        <source>The second finger&apos;s folder</source>
        <translation>Ordner des zweiten Fingers</translation>
    </message>
    <message>
        <source>Source of the second finger</source>
        <translation>Quelle für den zweiten Finger</translation>
    </message>
    <message>
        <source>The gripper&apos;s file</source>
        <translation>Datei des Greifers</translation>
    </message>
    <message>
        <source>Grippers (*.yaml)</source>
        <translation>Greifer (*.yaml)</translation>
    </message>
    <message>
        <source>Second finger</source>
        <translation>Zweiter Finger</translation>
    </message>
    <message>
        <source>Another finger of the same gripper with its own camera. Both images are shown for the same moment. With a gripper.yaml, the gap between the faces and the width of the held object are shown, too.</source>
        <translation>Ein anderer Finger desselben Greifers mit eigener Kamera. Beide Bilder werden zum selben Zeitpunkt gezeigt. Mit einer gripper.yaml werden auch der Spalt zwischen den Flächen und die Breite des gegriffenen Objekts angezeigt.</translation>
    </message>
    <message>
        <source>&amp;Finger&apos;s folder</source>
        <translation>&amp;Ordner des Fingers</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>&amp;Gripper</source>
        <translation>&amp;Greifer</translation>
    </message>
    <message>
        <source>Finger&apos;s folder</source>
        <translation>Ordner des Fingers</translation>
    </message>
    <message>
        <source>Camera, video or scene</source>
        <translation>Kamera, Video oder Szene</translation>
    </message>
    <message>
        <source>Gripper&apos;s file</source>
        <translation>Datei des Greifers</translation>
    </message>
    <message>
        <source>gripper.yaml; may be left empty</source>
        <translation>gripper.yaml; kann leer bleiben</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Datei…</translation>
    </message>
    <message>
        <source>Choose the finger&apos;s folder</source>
        <translation>Ordner des Fingers wählen</translation>
    </message>
    <message>
        <source>Choose a video or a scene</source>
        <translation>Video oder Szene wählen</translation>
    </message>
    <message>
        <source>Choose the gripper&apos;s file</source>
        <translation>Datei des Greifers wählen</translation>
    </message>
    <message>
        <source>&amp;Show it</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Choose the finger&apos;s folder.</source>
        <translation>Wählen Sie den Ordner des Fingers.</translation>
    </message>
    <message>
        <source>Choose its camera.</source>
        <translation>Wählen Sie seine Kamera.</translation>
    </message>
    <message>
        <source>Chooses the folder of the second finger</source>
        <translation>Wählt den Ordner des zweiten Fingers</translation>
    </message>
    <message>
        <source>Chooses a video or a scene instead of a camera</source>
        <translation>Wählt ein Video oder eine Szene statt einer Kamera</translation>
    </message>
    <message>
        <source>Chooses the file that describes the gripper</source>
        <translation>Wählt die Datei, die den Greifer beschreibt</translation>
    </message>
    <message>
        <source>Source of the second finger&apos;s images</source>
        <translation>Quelle der Bilder des zweiten Fingers</translation>
    </message>
    <message>
        <source>Opens the second finger next to the first</source>
        <translation>Öffnet den zweiten Finger neben dem ersten</translation>
    </message>
    <message>
        <source>Closes this window without a change (Esc)</source>
        <translation>Schließt dieses Fenster ohne Änderung (Esc)</translation>
    </message>
</context>
<context>
    <name>alltact::SecondFingerDialog</name>
    <message>
        <source>The second finger&apos;s folder</source>
        <translation>Ordner des zweiten Fingers</translation>
    </message>
    <message>
        <source>The second finger&apos;s video</source>
        <translation>Video des zweiten Fingers</translation>
    </message>
    <message>
        <source>Image folder of the second finger</source>
        <translation>Bilderordner des zweiten Fingers</translation>
    </message>
    <message>
        <source>Second finger</source>
        <translation>Zweiter Finger</translation>
    </message>
    <message>
        <source>Another finger of the same gripper, with its recording from the same time. Both are shown in the gripper&apos;s coordinate frame; their frames are matched by capture time.</source>
        <translation>Ein anderer Finger desselben Greifers, mit seiner zur selben Zeit entstandenen Aufnahme. Beide werden im Koordinatensystem des Greifers gezeigt; ihre Bilder werden nach Aufnahmezeit zugeordnet.</translation>
    </message>
    <message>
        <source>&amp;Finger&apos;s folder</source>
        <translation>&amp;Ordner des Fingers</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>&amp;Aufnahme</translation>
    </message>
    <message>
        <source>Finger&apos;s folder</source>
        <translation>Ordner des Fingers</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the finger&apos;s folder</source>
        <translation>Ordner des Fingers wählen</translation>
    </message>
    <message>
        <source>Video…</source>
        <translation>Video…</translation>
    </message>
    <message>
        <source>Images…</source>
        <translation>Bilder…</translation>
    </message>
    <message>
        <source>&amp;Show it</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Choose the finger&apos;s folder.</source>
        <translation>Wählen Sie den Ordner des Fingers.</translation>
    </message>
    <message>
        <source>Choose its recording.</source>
        <translation>Wählen Sie seine Aufnahme.</translation>
    </message>
    <message>
        <source>Chooses the folder of the second finger</source>
        <translation>Wählt den Ordner des zweiten Fingers</translation>
    </message>
    <message>
        <source>A video that was recorded at the same time</source>
        <translation>Ein gleichzeitig aufgenommenes Video</translation>
    </message>
    <message>
        <source>A folder of images that were recorded at the same time</source>
        <translation>Ein Ordner gleichzeitig aufgenommener Bilder</translation>
    </message>
    <message>
        <source>Opens the second finger next to the first</source>
        <translation>Öffnet den zweiten Finger neben dem ersten</translation>
    </message>
    <message>
        <source>Closes this window without a change (Esc)</source>
        <translation>Schließt dieses Fenster ohne Änderung (Esc)</translation>
    </message>
    <message>
        <source>Finger to compare with</source>
        <translation>Finger zum Vergleich</translation>
    </message>
    <message>
        <source>Another finger of the same shape, with its recording. Each is measured by its own calibration; the same positions on both faces are compared.</source>
        <translation>Ein anderer Finger derselben Form mit seiner Aufnahme. Jeder wird mit seiner eigenen Kalibrierung gemessen; verglichen werden dieselben Stellen beider Flächen.</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>Shows the difference in depth from this finger</source>
        <translation>Zeigt den Tiefenunterschied zu diesem Finger</translation>
    </message>
</context>
<context>
    <name>alltact::SectionPlot</name>
    <message>
        <source>Depth from A to B</source>
        <translation>Tiefe von A nach B</translation>
    </message>
    <message>
        <source>Choose two points, A and B</source>
        <translation>Zwei Punkte wählen, A und B</translation>
    </message>
    <message>
        <source>From A along the face (mm)</source>
        <translation>Von A entlang der Fläche (mm)</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Tiefe (mm)</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>angezeigt</translation>
    </message>
</context>
<context>
    <name>alltact::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Aussehen</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Foot pedal</source>
        <translation>&amp;Fußpedal</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keines</translation>
    </message>
    <message>
        <source>Stops using the pedal.</source>
        <translation>Verwendet kein Pedal mehr.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Learn by pressing it…</source>
        <translation>Durch Drücken an&amp;lernen…</translation>
    </message>
    <message>
        <source>Stop learning the foot pedal</source>
        <translation>Das Anlernen des Fußpedals abbrechen</translation>
    </message>
    <message>
        <source>Learn the foot pedal by pressing it</source>
        <translation>Das Fußpedal durch Drücken anlernen</translation>
    </message>
    <message>
        <source>None. A pedal takes presses on Calibrate; on Record it starts and stops.</source>
        <translation>Keines. Ein Pedal nimmt auf der Seite „Kalibrieren“ Eindrücke auf; auf „Aufnahme“ startet und beendet es die Aufnahme.</translation>
    </message>
    <message>
        <source>%1: no signal</source>
        <translation>%1: kein Signal</translation>
    </message>
    <message>
        <source>Colours of all windows</source>
        <translation>Farben aller Fenster</translation>
    </message>
    <message>
        <source>Language of all texts, and the form of numbers and dates</source>
        <translation>Sprache aller Texte und Form der Zahlen und Daten</translation>
    </message>
    <message>
        <source>Press the pedal or button after this click</source>
        <translation>Danach das Pedal oder den Knopf drücken</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>Schließt dieses Fenster (Esc)</translation>
    </message>
</context>
<context>
    <name>alltact::SettingsComparison</name>
    <message>
        <source>Depth with the setting in use now</source>
        <translation>Tiefe mit der jetzt verwendeten Einstellung</translation>
    </message>
    <message>
        <source>Depth with the chosen setting</source>
        <translation>Tiefe mit der gewählten Einstellung</translation>
    </message>
    <message>
        <source>Difference of the two depths</source>
        <translation>Unterschied der beiden Tiefen</translation>
    </message>
    <message>
        <source>Both settings in figures</source>
        <translation>Beide Einstellungen in Zahlen</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Tiefe (mm)</translation>
    </message>
    <message>
        <source>In use now: %1</source>
        <translation>Jetzt verwendet: %1</translation>
    </message>
    <message>
        <source>Chosen: %1</source>
        <translation>Gewählt: %1</translation>
    </message>
    <message>
        <source>Chosen minus in use</source>
        <translation>Gewählt minus verwendet</translation>
    </message>
    <message>
        <source>Choose a setting other than the one in use.</source>
        <translation>Eine andere Einstellung als die verwendete wählen.</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Messung läuft…</translation>
    </message>
    <message>
        <source>Open a camera or a recording first.</source>
        <translation>Zuerst eine Kamera oder eine Aufnahme öffnen.</translation>
    </message>
    <message>
        <source>One setting gives no depth in this image.</source>
        <translation>Eine Einstellung ergibt in diesem Bild keine Tiefe.</translation>
    </message>
    <message>
        <source>Difference (mm)</source>
        <translation>Unterschied (mm)</translation>
    </message>
    <message>
        <source>This image: %1 ms with the setting in use, %2 ms with the chosen one.</source>
        <translation>Dieses Bild: %1 ms mit der verwendeten Einstellung, %2 ms mit der gewählten.</translation>
    </message>
    <message>
        <source>No contact: touch the finger to compare depths.</source>
        <translation>Kein Kontakt: den Finger berühren, um die Tiefen zu vergleichen.</translation>
    </message>
    <message>
        <source>Where something presses, half of all points differ by less than %1 mm, 95 % by less than %2 mm.</source>
        <translation>Wo etwas drückt, weicht die Hälfte aller Punkte um weniger als %1 mm ab, 95 % um weniger als %2 mm.</translation>
    </message>
</context>
<context>
    <name>alltact::SourceMenu</name>
    <message>
        <source>&amp;Recent sources</source>
        <translation>Zu&amp;letzt verwendete Quellen</translation>
    </message>
    <message>
        <source>&amp;Source</source>
        <translation>&amp;Quelle</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>No camera is plugged in</source>
        <translation>Keine Kamera angeschlossen</translation>
    </message>
    <message>
        <source>&amp;Simulated finger</source>
        <translation>&amp;Simulierter Finger</translation>
    </message>
    <message>
        <source>&amp;Video file…</source>
        <translation>&amp;Videodatei…</translation>
    </message>
    <message>
        <source>Folder of &amp;images…</source>
        <translation>Ordner mit &amp;Bildern…</translation>
    </message>
    <message>
        <source>Scene &amp;file…</source>
        <translation>S&amp;zenendatei…</translation>
    </message>
    <message>
        <source>&amp;Close the source</source>
        <translation>Quelle s&amp;chließen</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>Video öffnen</translation>
    </message>
    <message>
        <source>Open a folder of images</source>
        <translation>Ordner mit Bildern öffnen</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>Szene öffnen</translation>
    </message>
    <message>
        <source>Scenes (*.yaml *.yml)</source>
        <translation>Szenen (*.yaml *.yml)</translation>
    </message>
</context>
<context>
    <name>alltact::StartPanel</name>
    <message>
        <source>Choose a source</source>
        <translation>Quelle wählen</translation>
    </message>
    <message>
        <source>The source supplies the images. Open a finger before or after.</source>
        <translation>Die Quelle liefert die Bilder. Ein Finger lässt sich davor oder danach öffnen.</translation>
    </message>
    <message>
        <source>&amp;Simulated finger</source>
        <translation>&amp;Simulierter Finger</translation>
    </message>
    <message>
        <source>Folder of &amp;images…</source>
        <translation>Ordner mit Bi&amp;ldern…</translation>
    </message>
    <message>
        <source>&amp;Open a finger…</source>
        <translation>Finger ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;New finger…</source>
        <translation>&amp;Neuer Finger…</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>&amp;Go on with %1</source>
        <translation>&amp;Weiter mit %1</translation>
    </message>
    <message>
        <source>No camera is plugged in.</source>
        <translation>Keine Kamera angeschlossen.</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>&amp;Try with a simulated finger</source>
        <translation>Mit simuliertem Finger aus&amp;probieren</translation>
    </message>
    <message>
        <source>A full day in five minutes: record, press, calibrate and check a simulated finger</source>
        <translation>Ein ganzer Tag in fünf Minuten: einen simulierten Finger aufnehmen, eindrücken, kalibrieren und prüfen</translation>
    </message>
    <message>
        <source>&amp;All fingers…</source>
        <translation>Alle Finge&amp;r…</translation>
    </message>
    <message>
        <source>Verdict and due steps of each, in one list</source>
        <translation>Urteil und fällige Schritte für jeden, in einer Liste</translation>
    </message>
    <message>
        <source>A finger from its side: camera and lamps at its base, and a ball that presses</source>
        <translation>Ein Finger von der Seite: Kamera und Lampen an der Basis, und eine Kugel, die drückt</translation>
    </message>
    <message>
        <source>Vi&amp;deo file…</source>
        <translation>&amp;Videodatei…</translation>
    </message>
    <message>
        <source>A computed finger that bends, to try everything without a camera</source>
        <translation>Ein berechneter Finger, der sich biegt: zum Ausprobieren ohne Kamera</translation>
    </message>
    <message>
        <source>Plays a recording as if it came from a camera</source>
        <translation>Spielt eine Aufnahme ab, als käme sie von einer Kamera</translation>
    </message>
    <message>
        <source>Plays the images of a folder by their names</source>
        <translation>Spielt die Bilder eines Ordners nach Namen ab</translation>
    </message>
    <message>
        <source>Chooses the folder of a finger that exists (Ctrl+O)</source>
        <translation>Wählt den Ordner eines vorhandenen Fingers (Strg+O)</translation>
    </message>
    <message>
        <source>Describes a finger that is not calibrated yet (Ctrl+N)</source>
        <translation>Beschreibt einen Finger, der noch nicht kalibriert ist (Strg+N)</translation>
    </message>
    <message>
        <source>Opens the source and the finger of the last time</source>
        <translation>Öffnet Quelle und Finger vom letzten Mal</translation>
    </message>
</context>
<context>
    <name>alltact::StatusLine</name>
    <message>
        <source>Frames delivered</source>
        <translation>Gelieferte Bilder</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>Verlorene Bilder</translation>
    </message>
    <message>
        <source>Time per frame</source>
        <translation>Zeit für ein Bild</translation>
    </message>
    <message>
        <source>%1 ms per frame</source>
        <translation>%1 ms je Bild</translation>
    </message>
    <message>
        <source>%1 frames/s, %2 delivered, %3 shown per second</source>
        <translation>%1 Bilder/s, %2 geliefert, %3 je Sekunde angezeigt</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) lost</source>
        <translation>
            <numerusform>%n Bild verloren</numerusform>
            <numerusform>%n Bilder verloren</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (catching up)</source>
        <translation>%1 (holt auf)</translation>
    </message>
</context>
<context>
    <name>alltact::StepList</name>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>check again</source>
        <translation>neu prüfen</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>zu tun</translation>
    </message>
    <message>
        <source>is being read</source>
        <translation>wird gelesen</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>a step&apos;s number and title</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Opens this step</source>
        <translation>Öffnet diesen Schritt</translation>
    </message>
</context>
<context>
    <name>alltact::SurfaceBox</name>
    <message>
        <source>Roughness without</source>
        <translation>Rauheit ohne</translation>
    </message>
    <message>
        <source>a plane</source>
        <translation>eine Ebene</translation>
    </message>
    <message>
        <source>a form of degree 2</source>
        <translation>eine Form 2. Grades</translation>
    </message>
    <message>
        <source>a form of degree 3</source>
        <translation>eine Form 3. Grades</translation>
    </message>
    <message>
        <source>a form of degree 4</source>
        <translation>eine Form 4. Grades</translation>
    </message>
    <message>
        <source>Form that is no roughness</source>
        <translation>Form, die keine Rauheit ist</translation>
    </message>
    <message>
        <source>Bends of the finger and of the pressing object do not count as roughness.</source>
        <translation>Biegungen des Fingers und des drückenden Gegenstands zählen nicht als Rauheit.</translation>
    </message>
    <message>
        <source>Wavelengths up to</source>
        <translation>Wellenlängen bis</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Longest wavelength of roughness</source>
        <translation>Größte Wellenlänge der Rauheit</translation>
    </message>
    <message>
        <source>Lambda c: longer waves do not count as roughness (Gaussian filter, ISO 16610-61). Usual: 0.25, 0.8, 2.5 mm.</source>
        <translation>Lambda c: Längere Wellen zählen nicht als Rauheit (Gauß-Filter, ISO 16610-61). Üblich: 0,25, 0,8, 2,5 mm.</translation>
    </message>
    <message>
        <source>change the form that is no roughness</source>
        <translation>Form ohne Rauheit ändern</translation>
    </message>
    <message>
        <source>change the roughness' longest wavelength</source>
        <translation>größte Wellenlänge der Rauheit ändern</translation>
    </message>
    <message>
        <source>without a form of degree %1</source>
        <translation>ohne eine Form %1. Grades</translation>
    </message>
    <message>
        <source>wavelengths up to %1 mm</source>
        <translation>Wellenlängen bis %1 mm</translation>
    </message>
    <message>
        <source>Add to recipe</source>
        <translation>In den Prüfplan</translation>
    </message>
    <message>
        <source>The selected reading, at these positions, becomes part of the recipe</source>
        <translation>Die gewählte Messung an diesen Positionen kommt in den Prüfplan</translation>
    </message>
    <message>
        <source>Between A and B</source>
        <translation>Zwischen A und B</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Als CSV kopieren</translation>
    </message>
    <message>
        <source>Measured between the points</source>
        <translation>Zwischen den Punkten gemessen</translation>
    </message>
    <message>
        <source>Two points span a box: a ball&apos;s radius, area, volume and roughness inside; distance, step and angle from A to B.</source>
        <translation>Zwei Punkte bilden einen Kasten: Kugelradius, Fläche, Volumen und Rauheit darin; Abstand, Stufe und Winkel von A nach B.</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Als Text kopieren</translation>
    </message>
    <message>
        <source>Ball&apos;s radius</source>
        <translation>Kugelradius</translation>
    </message>
    <message>
        <source>Pressed area</source>
        <translation>Eingedrückte Fläche</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Mean depth</source>
        <translation>Mittlere Tiefe</translation>
    </message>
    <message>
        <source>Roughness Sq</source>
        <translation>Rauheit Sq</translation>
    </message>
    <message>
        <source>Step from A to B</source>
        <translation>Stufe von A nach B</translation>
    </message>
    <message>
        <source>Angle from A to B</source>
        <translation>Winkel von A nach B</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Distance A to B</source>
        <translation>Abstand A nach B</translation>
    </message>
    <message>
        <source>Puts the readings with their units on the clipboard</source>
        <translation>Legt die Messwerte mit Einheiten in die Zwischenablage</translation>
    </message>
    <message>
        <source>Puts the readings on the clipboard for a spreadsheet</source>
        <translation>Legt die Messwerte für eine Tabelle in die Zwischenablage</translation>
    </message>
    <message>
        <source>Section&apos;s depth</source>
        <translation>Tiefe des Schnitts</translation>
    </message>
    <message>
        <source>Section&apos;s area</source>
        <translation>Fläche des Schnitts</translation>
    </message>
    <message>
        <source>Section&apos;s width</source>
        <translation>Breite des Schnitts</translation>
    </message>
    <message>
        <source>At half of its depth</source>
        <translation>Bei halber Tiefe</translation>
    </message>
</context>
<context>
    <name>alltact::TimeLine</name>
    <message>
        <source>Frame of the recording</source>
        <translation>Bild der Aufnahme</translation>
    </message>
    <message>
        <source>Current frame</source>
        <translation>Aktuelles Bild</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>Frame name</source>
        <translation>Bildname</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Previous contact or problem</source>
        <translation>Voriger Kontakt oder voriges Problem</translation>
    </message>
    <message>
        <source>Next contact or problem</source>
        <translation>Nächster Kontakt oder nächstes Problem</translation>
    </message>
    <message>
        <source>Drag to a frame; arrow keys go frame by frame</source>
        <translation>Zu einem Bild ziehen; Pfeiltasten gehen Bild für Bild</translation>
    </message>
    <message>
        <source>Number of the shown frame, from 1</source>
        <translation>Nummer des gezeigten Bildes, ab 1</translation>
    </message>
</context>
<context>
    <name>alltact::Tutorial</name>
    <message>
        <source>A day with a simulated finger</source>
        <translation>Ein Tag mit einem simulierten Finger</translation>
    </message>
    <message>
        <source>End the &amp;guide</source>
        <translation>An&amp;leitung beenden</translation>
    </message>
    <message>
        <source>Done:</source>
        <translation>Fertig:</translation>
    </message>
    <message>
        <source>%1 of %2:</source>
        <translation>%1 von %2:</translation>
    </message>
    <message>
        <source>Go to &amp;Record</source>
        <translation>Zur &amp;Aufnahme</translation>
    </message>
    <message>
        <source>Go to &amp;Inspect</source>
        <translation>Zu A&amp;uswerten</translation>
    </message>
    <message>
        <source>Go to &amp;Calibrate</source>
        <translation>Zu &amp;Kalibrieren</translation>
    </message>
    <message>
        <source>The simulated finger gets a folder of its own.</source>
        <translation>Der simulierte Finger bekommt einen eigenen Ordner.</translation>
    </message>
    <message>
        <source>Record it for half a minute while it bends, then install the recording.</source>
        <translation>Nehmen Sie ihn eine halbe Minute beim Biegen auf und richten Sie die Aufnahme dann als Referenz ein.</translation>
    </message>
    <message>
        <source>Calibrate with these presses and read the verdict.</source>
        <translation>Kalibrieren Sie mit diesen Eindrücken und lesen Sie das Urteil.</translation>
    </message>
    <message>
        <source>Check it with three presses, as every week.</source>
        <translation>Prüfen Sie ihn mit drei Eindrücken, wie jede Woche.</translation>
    </message>
    <message>
        <source>That was a finger&apos;s full day. View its contacts in 3D.</source>
        <translation>Das war der ganze Tag eines Fingers. Sehen Sie sich seine Kontakte in 3D an.</translation>
    </message>
    <message>
        <source>Wait:</source>
        <translation>Bitte warten:</translation>
    </message>
    <message>
        <source>Enter the ball&apos;s radius, 4 mm. Each press that is held still is taken, until there are six.</source>
        <translation>Geben Sie den Radius der Kugel ein, 4 mm. Jeder Eindruck, der still gehalten wird, wird aufgenommen, bis es sechs sind.</translation>
    </message>
    <message>
        <source>Hides the guide for this finger</source>
        <translation>Blendet die Anleitung für diesen Finger aus</translation>
    </message>
    <message>
        <source>Opens the page of the next step</source>
        <translation>Öffnet die Seite des nächsten Schritts</translation>
    </message>
</context>
<context>
    <name>alltact::UndoBar</name>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederherstellen: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Z)</source>
        <translation>%1 (Strg+Z)</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Shift+Z)</source>
        <translation>%1 (Strg+Umschalt+Z)</translation>
    </message>
</context>
<context>
    <name>alltact::VerdictPage</name>
    <message>
        <source>Remarks</source>
        <translation>Anmerkungen</translation>
    </message>
    <message>
        <source>&amp;Open the report</source>
        <translation>Bericht ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Copy as command &amp;line</source>
        <translation>Als Befehls&amp;zeile kopieren</translation>
    </message>
    <message>
        <source>The same as a command line</source>
        <translation>Dasselbe als Befehlszeile</translation>
    </message>
    <message>
        <source>Calibrate first.</source>
        <translation>Zuerst kalibrieren.</translation>
    </message>
    <message>
        <source>Not calibrated yet</source>
        <translation>Noch nicht kalibriert</translation>
    </message>
    <message>
        <source>The report is being written.</source>
        <translation>Der Bericht wird geschrieben.</translation>
    </message>
    <message>
        <source>By zone of the face: %1.</source>
        <translation>Nach Zonen der Fläche: %1.</translation>
    </message>
    <message>
        <source>These presses give no information on this.</source>
        <translation>Diese Eindrücke geben darüber keinen Aufschluss.</translation>
    </message>
    <message>
        <source>press here next</source>
        <translation>hier als Nächstes</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Dru&amp;cken…</translation>
    </message>
    <message>
        <source>One sheet to store with the finger, on paper or as PDF</source>
        <translation>Ein Blatt, das beim Finger bleibt, auf Papier oder als PDF</translation>
    </message>
    <message>
        <source>Remarks (%1)</source>
        <translation>Anmerkungen (%1)</translation>
    </message>
    <message>
        <source>The current presses give no calibration: %1</source>
        <translation>Die jetzigen Eindrücke ergeben keine Kalibrierung: %1</translation>
    </message>
    <message>
        <source>The result of the current presses is being computed.</source>
        <translation>Das Ergebnis der jetzigen Eindrücke wird berechnet.</translation>
    </message>
    <message>
        <source>With the current presses: %1 mm, %2</source>
        <translation>Mit den jetzigen Eindrücken: %1 mm, %2</translation>
    </message>
    <message>
        <source>%1 (in use: %2 mm).</source>
        <translation>%1 (verwendet: %2 mm).</translation>
    </message>
    <message>
        <source>Depth over brightness difference</source>
        <translation>Tiefe über dem Helligkeitsunterschied</translation>
    </message>
    <message>
        <source>Error of every press, worst first</source>
        <translation>Fehler jedes Eindrucks, der größte zuerst</translation>
    </message>
    <message>
        <source>Progress of the calibration</source>
        <translation>Fortschritt der Kalibrierung</translation>
    </message>
    <message>
        <source>Go to the presses</source>
        <translation>Zu den Eindrücken</translation>
    </message>
    <message>
        <source>Go to the check</source>
        <translation>Zur Prüfung</translation>
    </message>
    <message>
        <source>&amp;Calibrate again</source>
        <translation>Neu &amp;kalibrieren</translation>
    </message>
    <message>
        <source>Calibrated; accuracy not stored</source>
        <translation>Kalibriert; Genauigkeit nicht gespeichert</translation>
    </message>
    <message>
        <source>• %1</source>
        <comment>an item of a list</comment>
        <translation>• %1</translation>
    </message>
    <message numerus="yes">
        <source>• %n more at the top of the remarks.</source>
        <translation>
            <numerusform>• %n weiterer Punkt am Anfang der Anmerkungen.</numerusform>
            <numerusform>• %n weitere Punkte am Anfang der Anmerkungen.</numerusform>
        </translation>
    </message>
    <message>
        <source>• The presses have changed since: calibrate again.</source>
        <translation>• Die Eindrücke haben sich seither geändert: Kalibrieren Sie neu.</translation>
    </message>
    <message>
        <source>Expected error so far: ±%1 mm.</source>
        <translation>Bisher erwarteter Fehler: ±%1 mm.</translation>
    </message>
    <message>
        <source>Based on: %1.</source>
        <translation>Grundlage: %1.</translation>
    </message>
    <message>
        <source>The presses have changed since this calibration.</source>
        <translation>Die Eindrücke haben sich seit dieser Kalibrierung geändert.</translation>
    </message>
    <message>
        <source>Finger %1: verdict on its calibration</source>
        <translation>Finger %1: Urteil über die Kalibrierung</translation>
    </message>
    <message numerus="yes">
        <source>%1, ball of radius %2 mm, %n press(es), AllTact %3</source>
        <translation>
            <numerusform>%1, Kugel mit Radius %2 mm, %n Eindruck, AllTact %3</numerusform>
            <numerusform>%1, Kugel mit Radius %2 mm, %n Eindrücke, AllTact %3</numerusform>
        </translation>
    </message>
    <message>
        <source>The presses show a fault</source>
        <translation>Die Eindrücke zeigen einen Fehler</translation>
    </message>
    <message>
        <source>From brightness to depth: each point is a block of pixels under a ball.</source>
        <translation>Von der Helligkeit zur Tiefe: jeder Punkt ist ein Block von Pixeln unter einer Kugel.</translation>
    </message>
    <message>
        <source>Position on the face, and the mapping&apos;s error there.</source>
        <translation>Position auf der Fläche und Fehler der Abbildung dort.</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Eindruck</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Tiefe (mm)</translation>
    </message>
    <message>
        <source>Error (mm)</source>
        <translation>Fehler (mm)</translation>
    </message>
    <message numerus="yes">
        <source>%n more press(es) in the report.</source>
        <translation>
            <numerusform>%n weiterer Eindruck im Bericht.</numerusform>
            <numerusform>%n weitere Eindrücke im Bericht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Print the verdict</source>
        <translation>Das Urteil drucken</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Resolution: %1.</source>
        <translation>Auflösung: %1.</translation>
    </message>
    <message>
        <source>Opens the report of the calibration for the lab book (PDF)</source>
        <translation>Öffnet den Bericht der Kalibrierung fürs Laborbuch (PDF)</translation>
    </message>
    <message>
        <source>Copies the command that repeats this calibration in a terminal</source>
        <translation>Kopiert den Befehl, der diese Kalibrierung im Terminal wiederholt</translation>
    </message>
    <message>
        <source>What improves this finger&apos;s depth most now</source>
        <translation>Was die Tiefe dieses Fingers jetzt am meisten verbessert</translation>
    </message>
    <message>
        <source>Shows the remarks instead of the figures</source>
        <translation>Zeigt die Bemerkungen statt der Diagramme</translation>
    </message>
    <message>
        <source>Shows what more presses would bring instead of the figures</source>
        <translation>Zeigt statt der Diagramme, was mehr Eindrücke brächten</translation>
    </message>
</context>
<context>
    <name>alltact::ViewBox</name>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>the source paper</source>
        <translation>die Quellarbeit</translation>
    </message>
    <message>
        <source>the source paper&apos;s method</source>
        <translation>das Verfahren der Quellarbeit</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>View f&amp;rom</source>
        <translation>Blick v&amp;on</translation>
    </message>
    <message>
        <source>Com&amp;pare</source>
        <translation>&amp;Vergleich</translation>
    </message>
    <message>
        <source>&amp;With</source>
        <translation>&amp;Mit</translation>
    </message>
    <message>
        <source>Set&amp;ting</source>
        <translation>Einste&amp;llung</translation>
    </message>
    <message>
        <source>Frame &amp;number</source>
        <translation>Bild&amp;nummer</translation>
    </message>
    <message>
        <source>&amp;Colours up to</source>
        <translation>&amp;Farben bis</translation>
    </message>
    <message>
        <source>Differe&amp;nce up to</source>
        <translation>&amp;Unterschied bis</translation>
    </message>
    <message>
        <source>Scale &amp;depth</source>
        <translation>&amp;Tiefe überhöhen</translation>
    </message>
    <message>
        <source>R&amp;uler</source>
        <translation>&amp;Maßstab</translation>
    </message>
    <message>
        <source>Ca&amp;mera</source>
        <translation>Kame&amp;ra</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>in 3D</source>
        <translation>in 3D</translation>
    </message>
    <message>
        <source>as a height map</source>
        <translation>als Höhenkarte</translation>
    </message>
    <message>
        <source>3D needs OpenGL 3.2, which this screen does not support.</source>
        <translation>3D braucht OpenGL 3.2, das dieser Bildschirm nicht bietet.</translation>
    </message>
    <message>
        <source>inside, tilted</source>
        <translation>innen, schräg</translation>
    </message>
    <message>
        <source>the camera</source>
        <translation>der Kamera</translation>
    </message>
    <message>
        <source>outside, tilted</source>
        <translation>außen, schräg</translation>
    </message>
    <message>
        <source>the side</source>
        <translation>der Seite</translation>
    </message>
    <message>
        <source>no comparison</source>
        <translation>kein Vergleich</translation>
    </message>
    <message>
        <source>side by side</source>
        <translation>nebeneinander</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>another setting</source>
        <translation>einer anderen Einstellung</translation>
    </message>
    <message>
        <source>another frame</source>
        <translation>einem anderen Bild</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Depth at which the colours end</source>
        <translation>Tiefe am Ende der Farbskala</translation>
    </message>
    <message>
        <source>Difference at both ends of the colour scale</source>
        <translation>Unterschied an beiden Enden der Farbskala</translation>
    </message>
    <message>
        <source> times</source>
        <translation>-mal</translation>
    </message>
    <message>
        <source>Factor by which depth is drawn larger</source>
        <translation>Faktor, um den die Tiefe überhöht wird</translation>
    </message>
    <message>
        <source>show as %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>view from: %1</source>
        <translation>Blick von: %1</translation>
    </message>
    <message>
        <source>change the depth colours</source>
        <translation>die Farben der Tiefe ändern</translation>
    </message>
    <message>
        <source>change the difference&apos;s colours</source>
        <translation>die Farben des Unterschieds ändern</translation>
    </message>
    <message>
        <source>scale the depth</source>
        <translation>die Tiefe überhöhen</translation>
    </message>
    <message>
        <source>show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>hide %1</source>
        <translation>%1 verbergen</translation>
    </message>
    <message>
        <source>compare: %1</source>
        <translation>vergleichen: %1</translation>
    </message>
    <message>
        <source>compare with %1</source>
        <translation>vergleichen mit %1</translation>
    </message>
    <message>
        <source>Finger&apos;s bod&amp;y</source>
        <translation>&amp;Körper des Fingers</translation>
    </message>
    <message>
        <source>Untouched face</source>
        <translation>Unberührte Fläche</translation>
    </message>
    <message>
        <source>another recording</source>
        <translation>einer anderen Aufnahme</translation>
    </message>
    <message>
        <source>a body (STL, OBJ)</source>
        <translation>einem Körper (STL, OBJ)</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>Date&amp;i</translation>
    </message>
    <message>
        <source>Choose another file. An image stands for all the images in its folder.</source>
        <translation>Eine andere Datei wählen. Ein Bild steht für alle Bilder in seinem Ordner.</translation>
    </message>
    <message>
        <source>Body to compare with, in mm</source>
        <translation>Körper zum Vergleich, in mm</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.obj *.STL *.OBJ)</source>
        <translation>Netze (*.stl *.obj *.STL *.OBJ)</translation>
    </message>
    <message>
        <source>Recording to compare with</source>
        <translation>Aufnahme zum Vergleich</translation>
    </message>
    <message>
        <source>Shows another measurement next to this one, or the difference of both</source>
        <translation>Zeigt eine andere Messung daneben, oder die Differenz beider</translation>
    </message>
    <message>
        <source>Where the eye is; drag in the view to turn it</source>
        <translation>Wo das Auge ist; in der Ansicht ziehen dreht sie</translation>
    </message>
    <message>
        <source>Deeper contacts have the colour of the end of the scale</source>
        <translation>Tiefere Kontakte haben die Farbe am Ende der Skala</translation>
    </message>
    <message>
        <source>Larger differences have the colours of the ends of the scale</source>
        <translation>Größere Differenzen haben die Farben an den Enden der Skala</translation>
    </message>
    <message>
        <source>Draws depth larger in 3D; measured values do not change</source>
        <translation>Zeichnet die Tiefe in 3D größer; Messwerte ändern sich nicht</translation>
    </message>
    <message>
        <source>The same frame, measured with this setting</source>
        <translation>Dasselbe Bild, mit dieser Einstellung gemessen</translation>
    </message>
    <message>
        <source>Number of the frame to compare with, from 1</source>
        <translation>Nummer des Vergleichsbildes, ab 1</translation>
    </message>
    <message>
        <source>Side faces, back and base of the finger, in 3D</source>
        <translation>Seitenflächen, Rückseite und Fuß des Fingers, in 3D</translation>
    </message>
    <message>
        <source>Millimetres along the face, and a stick of a known height, in 3D</source>
        <translation>Millimeter entlang der Fläche und ein Stab bekannter Höhe, in 3D</translation>
    </message>
    <message>
        <source>The camera with its axes, from which coordinates count, in 3D</source>
        <translation>Die Kamera mit ihren Achsen, von denen die Koordinaten zählen, in 3D</translation>
    </message>
    <message>
        <source>Thin lines where the face lies without contact, in 3D</source>
        <translation>Dünne Linien, wo die Fläche ohne Kontakt liegt, in 3D</translation>
    </message>
    <message>
        <source>The face in 3D, or its depth over the image</source>
        <translation>Die Fläche in 3D, oder ihre Tiefe über dem Bild</translation>
    </message>
    <message>
        <source>another finger</source>
        <translation>einem anderen Finger</translation>
    </message>
    <message>
        <source>frame %1 of %2, finger %3</source>
        <translation>Bild %1 von %2, Finger %3</translation>
    </message>
    <message>
        <source>The paper&apos;s formulas or another setting measure the same frame again. With another frame, recording or finger, the same positions on the face are compared. A body is turned and shifted until it fits the deeper part of the largest contact; the difference is then the skin&apos;s distance from the body.</source>
        <translation>Die Formeln der Veröffentlichung oder eine andere Einstellung messen dasselbe Bild noch einmal. Mit einem anderen Bild, einer anderen Aufnahme oder einem anderen Finger werden dieselben Stellen der Fläche verglichen. Ein Körper wird gedreht und verschoben, bis er zum tieferen Teil des größten Kontakts passt; der Unterschied ist dann der Abstand der Haut vom Körper.</translation>
    </message>
</context>
<context>
    <name>alltact::Workspace</name>
    <message>
        <source>close the source</source>
        <translation>Quelle schließen</translation>
    </message>
    <message>
        <source>open source %1</source>
        <translation>Quelle %1 öffnen</translation>
    </message>
    <message>
        <source>none</source>
        <comment>source</comment>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>alltact::VerdictText</name>
    <message>
        <source>Changed since it was calibrated</source>
        <translation>Seit der Kalibrierung geändert</translation>
    </message>
    <message>
        <source>Broken</source>
        <translation>Defekt</translation>
    </message>
    <message>
        <source>%1, ±%2 mm</source>
        <comment>a grade and the expected error</comment>
        <translation>%1, ±%2 mm</translation>
    </message>
    <message>
        <source>good</source>
        <comment>an error</comment>
        <translation>gut</translation>
    </message>
    <message>
        <source>fair</source>
        <comment>an error</comment>
        <translation>mäßig</translation>
    </message>
    <message>
        <source>poor</source>
        <comment>an error</comment>
        <translation>schlecht</translation>
    </message>
</context>
<context>
    <name>alltact::en</name>
    <message>
        <source>lambda_c of {} mm is less than five pixels here</source>
        <translation>Lambda c von {} mm ist hier weniger als fünf Pixel</translation>
    </message>
    <message>
        <source>{:.2f} mm or more</source>
        <translation>{:.2f} mm oder mehr</translation>
    </message>
    <message>
        <source>the piece is smaller than lambda_c of {} mm</source>
        <translation>das Stück ist kleiner als Lambda c von {} mm</translation>
    </message>
    <message>
        <source>a larger piece, or a smaller lambda_c</source>
        <translation>ein größeres Stück oder ein kleineres Lambda c</translation>
    </message>
    <message>
        <source>{} of {:.0f}: {}</source>
        <translation>{} von {:.0f}: {}</translation>
    </message>
    <message>
        <source>stopped before all frames were done</source>
        <translation>angehalten, bevor alle Bilder gemessen waren</translation>
    </message>
    <message>
        <source>another recording</source>
        <translation>eine andere Aufnahme</translation>
    </message>
    <message>
        <source>the number is too large</source>
        <translation>die Zahl ist zu groß</translation>
    </message>
    <message>
        <source>the readings differ too much to be squared</source>
        <translation>die Messwerte sind zu verschieden, um quadriert zu werden</translation>
    </message>
    <message>
        <source>readings of one unit</source>
        <translation>Messwerte einer Einheit</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>einen Namen</translation>
    </message>
    <message>
        <source>is not above the lower limit</source>
        <translation>liegt nicht über der unteren Grenze</translation>
    </message>
    <message>
        <source>a larger number</source>
        <translation>eine größere Zahl</translation>
    </message>
    <message>
        <source>has two of the name '{}'</source>
        <translation>hat zwei namens „{}“</translation>
    </message>
    <message>
        <source>different names</source>
        <translation>verschiedene Namen</translation>
    </message>
    <message>
        <source>has {} entries</source>
        <translation>hat {} Einträge</translation>
    </message>
    <message>
        <source>one to {} readings</source>
        <translation>ein bis {} Messungen</translation>
    </message>
    <message>
        <source>the frame does not show both positions</source>
        <translation>das Bild zeigt nicht beide Positionen</translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation>die Aufnahme hat keine Bilder</translation>
    </message>
    <message numerus="yes">
        <source>{0} earlier checks are left out, so that each finger has as many by each operator.</source>
        <comment>{0} earlier check is left out, so that each finger has as many by each operator.</comment>
        <translation>
            <numerusform>{0} frühere Prüfung ist ausgelassen, damit jeder Finger von jedem Prüfer gleich viele hat.</numerusform>
            <numerusform>{0} frühere Prüfungen sind ausgelassen, damit jeder Finger von jedem Prüfer gleich viele hat.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{1}: {0} checks of another calibration or without an operator are left out.</source>
        <comment>{1}: {0} check of another calibration or without an operator is left out.</comment>
        <translation>
            <numerusform>{1}: {0} Prüfung einer anderen Kalibrierung oder ohne Prüfer ist ausgelassen.</numerusform>
            <numerusform>{1}: {0} Prüfungen einer anderen Kalibrierung oder ohne Prüfer sind ausgelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>each operator measures each part two times or more</source>
        <translation>jeder Prüfer misst jedes Teil zweimal oder öfter</translation>
    </message>
    <message>
        <source>a gage study needs two parts or two operators</source>
        <translation>eine Messsystemanalyse braucht zwei Teile oder zwei Prüfer</translation>
    </message>
    <message>
        <source>{} by {}</source>
        <translation>{} von {}</translation>
    </message>
    <message>
        <source>there is no reading of {}</source>
        <translation>es gibt keinen Messwert von {}</translation>
    </message>
    <message>
        <source>there is only one reading of {}</source>
        <translation>es gibt nur einen Messwert von {}</translation>
    </message>
    <message>
        <source>there are {} readings of {}, but {} of {}</source>
        <translation>es gibt {} Messwerte von {}, aber {} von {}</translation>
    </message>
    <message>
        <source>the same number of readings of each part by each operator</source>
        <translation>gleich viele Messwerte jedes Teils von jedem Prüfer</translation>
    </message>
    <message>
        <source>a reading of {} is no number</source>
        <translation>ein Messwert von {} ist keine Zahl</translation>
    </message>
    <message>
        <source>leaving it out</source>
        <translation>ihn weglassen</translation>
    </message>
    <message>
        <source>Gage R&amp;R: standard deviation {:.4f} mm (95 %: {:.4f} to {:.4f}), {:.1f} % of the variation</source>
        <translation>Gage R&amp;R: Standardabweichung {:.4f} mm (95 %: {:.4f} bis {:.4f}), {:.1f} % der Streuung</translation>
    </message>
    <message>
        <source>{}, {:.1f} % of the tolerance.</source>
        <translation>{}, {:.1f} % der Toleranz.</translation>
    </message>
    <message>
        <source>a table whose head names part, operator and value_mm</source>
        <translation>eine Tabelle mit den Spalten part, operator und value_mm</translation>
    </message>
    <message>
        <source>the cell is empty</source>
        <translation>die Zelle ist leer</translation>
    </message>
    <message>
        <source>the table has no rows</source>
        <translation>die Tabelle hat keine Zeilen</translation>
    </message>
    <message>
        <source>one row for each reading</source>
        <translation>eine Zeile für jeden Messwert</translation>
    </message>
    <message>
        <source>the same finger is named twice</source>
        <translation>derselbe Finger ist zweimal genannt</translation>
    </message>
    <message>
        <source>naming each finger once</source>
        <translation>jeden Finger einmal nennen</translation>
    </message>
    <message>
        <source>no check of these fingers names its operator</source>
        <translation>keine Prüfung dieser Finger nennt ihren Prüfer</translation>
    </message>
    <message>
        <source>alltact check FINGER --presses ... --operator NAME, two times or more by each operator</source>
        <translation>alltact check FINGER --presses ... --operator NAME, zweimal oder öfter durch jeden Prüfer</translation>
    </message>
    <message>
        <source>only the joint method is compared with others</source>
        <translation>nur das gemeinsame Verfahren wird mit anderen verglichen</translation>
    </message>
    <message>
        <source>leaving --compare out, or --method joint</source>
        <translation>--compare weglassen, oder --method joint</translation>
    </message>
    <message>
        <source>stopped; the finger is unchanged</source>
        <translation>angehalten; der Finger ist unverändert</translation>
    </message>
    <message>
        <source>Most frames have no reading: {}. Try: checking the unit and the beginning of the gauge's times.</source>
        <translation>Die meisten Bilder haben keinen Messwert: {}. Abhilfe: Einheit und Beginn der Zeiten des Kraftmessers prüfen.</translation>
    </message>
    <message>
        <source>in millimetres, this body would be {:.3g} mm long</source>
        <translation>in Millimetern wäre dieser Körper {:.3g} mm lang</translation>
    </message>
    <message>
        <source>exporting its mesh in millimetres</source>
        <translation>sein Netz in Millimetern zu exportieren</translation>
    </message>
    <message>
        <source>only the joint method uses measured depths and bodies other than balls</source>
        <translation>nur die gemeinsame Methode verwendet gemessene Tiefen und andere Körper als Kugeln</translation>
    </message>
    <message>
        <source>looking for the body in {}</source>
        <translation>Körper in {} wird gesucht</translation>
    </message>
    <message>
        <source>its body was left out, because the balls show {:.1f} +- {:.1f} % of the depth that its shape has; check the balls' radius and the body's mesh</source>
        <translation>sein Körper wurde ausgelassen, weil die Kugeln {:.1f} +- {:.1f} % der Tiefe seiner Form zeigen; prüfen Sie den Radius der Kugeln und das Netz des Körpers</translation>
    </message>
    <message>
        <source>there are only presses of bodies other than balls</source>
        <translation>es gibt nur Eindrücke anderer Körper als Kugeln</translation>
    </message>
    <message>
        <source>pressing a ball at least once as well: other bodies show the scale of depth, not its curve</source>
        <translation>mindestens einmal auch eine Kugel einzudrücken: Andere Körper zeigen den Maßstab der Tiefe, nicht ihre Kurve</translation>
    </message>
    <message>
        <source>it was not made with a ball</source>
        <translation>er wurde nicht mit einer Kugel gemacht</translation>
    </message>
    <message>
        <source>stopped before the body was found</source>
        <translation>angehalten, bevor der Körper gefunden war</translation>
    </message>
    <message>
        <source>a body with slopes or curves, pressed in until 3 mm of skin rest on it</source>
        <translation>einen Körper mit Schrägen oder Rundungen, eingedrückt, bis 3 mm der Haut auf ihm aufliegen</translation>
    </message>
    <message>
        <source>the body touches too little of the face</source>
        <translation>der Körper berührt zu wenig von der Fläche</translation>
    </message>
    <message>
        <source>the skin is {:.2f} mm off the body in its best pose</source>
        <translation>die Haut ist vom Körper in seiner besten Lage {:.2f} mm entfernt</translation>
    </message>
    <message>
        <source>too little skin rests on the body away from its edges</source>
        <translation>abseits seiner Kanten liegt zu wenig Haut auf dem Körper auf</translation>
    </message>
    <message>
        <source>the shape of this body leaves the scale of depth open</source>
        <translation>die Form dieses Körpers lässt den Maßstab der Tiefe offen</translation>
    </message>
    <message>
        <source>the mesh encloses no volume</source>
        <translation>das Netz umschließt kein Volumen</translation>
    </message>
    <message>
        <source>a mesh of a solid body</source>
        <translation>ein Netz eines festen Körpers</translation>
    </message>
    <message>
        <source>the image is damaged, truncated, or of a rare kind of TIFF</source>
        <translation>das Bild ist beschädigt, abgeschnitten oder ein TIFF seltener Art</translation>
    </message>
    <message>
        <source>copy it again, or save it as PNG</source>
        <translation>es noch einmal kopieren oder als PNG speichern</translation>
    </message>
    <message>
        <source>it holds no times of its frames: {:.4g} frames per second were assumed</source>
        <translation>für seine Bilder sind keine Zeiten angegeben: {:.4g} Bilder pro Sekunde wurden angenommen</translation>
    </message>
    <message>
        <source>it states that its brightness is stored as 16 to 235, but {:.0f} % of its pixels are below 9: 0 to 255 was assumed</source>
        <translation>der Bereich seiner Helligkeit ist als 16 bis 235 angegeben, aber {:.0f} % seiner Pixel liegen unter 9: 0 bis 255 wurde angenommen</translation>
    </message>
    <message>
        <source>the image is black and white; 8 to 16 bits per pixel are needed</source>
        <translation>das Bild ist schwarzweiß; 8 bis 16 Bit pro Pixel sind nötig</translation>
    </message>
    <message>
        <source>whether the layer may give light back beside where it went in; auto: if the brightness around the presses shows it, given three presses or more</source>
        <translation>ob die Schicht Licht neben der Stelle zurückgeben darf, an der es eintrat; auto: wenn die Helligkeit um die Eindrücke es zeigt, ab drei Eindrücken</translation>
    </message>
    <message>
        <source>light that may spread</source>
        <translation>Licht, das sich ausbreiten darf</translation>
    </message>
    <message>
        <source>local light</source>
        <translation>örtliches Licht</translation>
    </message>
    <message>
        <source>on a layer that scatters, &apos;auto&apos; is more accurate, most of all with flat and small bodies</source>
        <translation>auf einer streuenden Schicht ist &apos;auto&apos; genauer, vor allem bei flachen und kleinen Körpern</translation>
    </message>
    <message>
        <source>&apos;auto&apos; takes a few seconds more, and each image of a layer that spreads light some hundredths of a second more</source>
        <translation>&apos;auto&apos; dauert einige Sekunden länger, und jedes Bild einer Schicht, die Licht ausbreitet, einige Hundertstelsekunden</translation>
    </message>
    <message>
        <source>must hold an optical_thickness of 0 to {:g} and a width_factor of {:g} to {:g}</source>
        <translation>muss eine optical_thickness von 0 bis {} und einen width_factor von {} bis {} enthalten</translation>
    </message>
    <message>
        <source>belongs to a moebius along the normal</source>
        <translation>gehört zu einem moebius längs der Normalen</translation>
    </message>
    <message>
        <source>looking for light that spreads</source>
        <translation>suche nach Licht, das sich ausbreitet</translation>
    </message>
    <message>
        <source>more presses of different depth, or --light-spread local</source>
        <translation>mehr Eindrücke verschiedener Tiefe, oder --light-spread local</translation>
    </message>
    <message>
        <source>the curve of a layer that spreads light</source>
        <translation>die Kurve einer Schicht, die Licht ausbreitet</translation>
    </message>
    <message>
        <source>the layer spreads light: {:.0f} % comes back where it went in, the rest from about {:.1f} mm around; depth is read with that undone</source>
        <translation>die Schicht breitet Licht aus: {} % kommen dort zurück, wo sie eintraten, der Rest aus etwa {} mm Umkreis; bei der Tiefe ist das rückgängig gemacht</translation>
    </message>
    <message>
        <source>{} x {} px is no image size; each side must be 16 to 16384</source>
        <translation>{} x {} px ist keine Bildgröße; jede Seite muss 16 bis 16384 haben</translation>
    </message>
    <message>
        <source>the size of the camera&apos;s images, [width, height]</source>
        <translation>die Größe der Kamerabilder, [Breite, Höhe]</translation>
    </message>
    <message>
        <source>must be a number from 0.000001 to 100</source>
        <translation>muss eine Zahl von 0.000001 bis 100 sein</translation>
    </message>
    <message>
        <source>millimetres on the object per pixel</source>
        <translation>Millimeter am Gegenstand je Pixel</translation>
    </message>
    <message>
        <source>must be a number from 1 to 1000000</source>
        <translation>muss eine Zahl von 1 bis 1000000 sein</translation>
    </message>
    <message>
        <source>the focal length in pixels, as &apos;alltact lens&apos; finds it</source>
        <translation>die Brennweite in Pixeln, wie &apos;alltact lens&apos; sie findet</translation>
    </message>
    <message>
        <source>must be a number from {} to {}</source>
        <translation>muss eine Zahl von {} bis {} sein</translation>
    </message>
    <message>
        <source>the image&apos;s centre, or run &apos;alltact lens&apos;</source>
        <translation>die Bildmitte, oder &apos;alltact lens&apos; ausführen</translation>
    </message>
    <message>
        <source>no</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>at most {}</source>
        <translation>höchstens {}</translation>
    </message>
    <message>
        <source>a {} camera has {} coefficients, here are {}</source>
        <translation>eine Kamera dieser Art ({}) hat {} Koeffizienten, hier sind {}</translation>
    </message>
    <message>
        <source>holds a number that no lens has</source>
        <translation>enthält eine Zahl, die kein Objektiv hat</translation>
    </message>
    <message>
        <source>run &apos;alltact lens&apos;</source>
        <translation>&apos;alltact lens&apos; ausführen</translation>
    </message>
    <message>
        <source>belongs to a perspective camera; an orthographic one does not need it</source>
        <translation>gehört zu einer perspektivischen Kamera; eine orthografische braucht es nicht</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>weglassen</translation>
    </message>
    <message>
        <source>the distortion folds over inside the image: near its border, one pixel would see two directions</source>
        <translation>die Verzeichnung faltet sich im Bild: Nahe am Rand sähe ein Pixel zwei Richtungen</translation>
    </message>
    <message>
        <source>run &apos;alltact lens&apos; with boards that reach into the corners, or with fewer coefficients</source>
        <translation>&apos;alltact lens&apos; mit Tafeln ausführen, die in die Ecken reichen, oder mit weniger Koeffizienten</translation>
    </message>
    <message>
        <source>{} is {} x {} px, the camera of this finger gives {} x {}</source>
        <translation>{} hat {} x {} px, die Kamera dieses Fingers liefert {} x {}</translation>
    </message>
    <message>
        <source>must be a number from {:g} to {:g}</source>
        <translation>muss eine Zahl von {} bis {} sein</translation>
    </message>
    <message>
        <source>must be a length from 0 to 1000 mm</source>
        <translation>muss eine Länge von 0 bis 1000 mm sein</translation>
    </message>
    <message>
        <source>a caliper&apos;s reading</source>
        <translation>mit dem Messschieber messen</translation>
    </message>
    <message>
        <source>must be an index of refraction from 1 to 3</source>
        <translation>muss ein Brechungsindex von 1 bis 3 sein</translation>
    </message>
    <message>
        <source>1 for air, 1.33 water, 1.41 silicone, 1.49 acrylic, 1.52 glass</source>
        <translation>1 für Luft, 1.33 Wasser, 1.41 Silikon, 1.49 Acryl, 1.52 Glas</translation>
    </message>
    <message>
        <source>{} or {}</source>
        <translation>{} oder {}</translation>
    </message>
    <message>
        <source>one of {}</source>
        <translation>eines von {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos;, or else {}</source>
        <translation>&apos;{}&apos;, sonst {}</translation>
    </message>
    <message>
        <source>must be two integers</source>
        <translation>muss aus zwei ganzen Zahlen bestehen</translation>
    </message>
    <message>
        <source>[width, height] in pixels</source>
        <translation>[Breite, Höhe] in Pixeln</translation>
    </message>
    <message>
        <source>the lens-to-window air gap in mm</source>
        <translation>der Luftspalt zwischen Objektiv und Fenster in mm</translation>
    </message>
    <message>
        <source>the window&apos;s thickness in mm</source>
        <translation>die Dicke des Fensters in mm</translation>
    </message>
    <message>
        <source>the window&apos;s index of refraction</source>
        <translation>der Brechungsindex des Fensters</translation>
    </message>
    <message>
        <source>the index of refraction behind it</source>
        <translation>der Brechungsindex dahinter</translation>
    </message>
    <message>
        <source>the size of a pixel in mm</source>
        <translation>die Größe eines Pixels in mm</translation>
    </message>
    <message>
        <source>the focal length in pixels</source>
        <translation>die Brennweite in Pixeln</translation>
    </message>
    <message>
        <source>the principal point in pixels</source>
        <translation>der Hauptpunkt in Pixeln</translation>
    </message>
    <message>
        <source>a number is missing</source>
        <translation>eine Zahl fehlt</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number</source>
        <translation>&apos;{}&apos; ist keine Zahl</translation>
    </message>
    <message>
        <source>&apos;{}&apos; contains a thousands separator: write {}</source>
        <translation>&apos;{}&apos; enthält ein Tausendertrennzeichen: {} schreiben</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has &apos;{}&apos; after the number: remove it</source>
        <translation>&apos;{}&apos; enthält &apos;{}&apos; nach der Zahl: weglassen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is in &apos;{}&apos;: give the number in {}</source>
        <translation>&apos;{}&apos; ist in &apos;{}&apos; angegeben: die Zahl in {} angeben</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is too large or too small a number</source>
        <translation>die Zahl &apos;{}&apos; ist zu groß oder zu klein</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; can mean {1} or {2}: write {1} or {2}</source>
        <translation>&apos;{0}&apos; kann {1} oder {2} bedeuten: {1} oder {2} schreiben</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has too many digits after the decimal mark (at most {})</source>
        <translation>&apos;{}&apos; hat zu viele Nachkommastellen (höchstens {})</translation>
    </message>
    <message>
        <source>a comma separates entries here, and &apos;{}&apos; is none</source>
        <translation>ein Komma trennt hier die Einträge, und &apos;{}&apos; ist keiner</translation>
    </message>
    <message>
        <source>must be a number from {:g} to {:g} {}</source>
        <translation>muss eine Zahl von {} bis {} {} sein</translation>
    </message>
    <message>
        <source>must be a number from {:g} to {:g}{}</source>
        <translation>muss eine Zahl von {} bis {}{} sein</translation>
    </message>
    <message>
        <source>must be an integer from {} to {}</source>
        <translation>muss eine ganze Zahl von {} bis {} sein</translation>
    </message>
    <message>
        <source>{:g} {} is more than typical for {} ({:g} to {:g} {}): check the decimal mark</source>
        <translation>{} {} ist mehr als üblich für {} ({} bis {} {}): das Dezimalzeichen prüfen</translation>
    </message>
    <message>
        <source>{:g} {} is less than typical for {} ({:g} to {:g} {}): check the decimal mark</source>
        <translation>{} {} ist weniger als üblich für {} ({} bis {} {}): das Dezimalzeichen prüfen</translation>
    </message>
    <message>
        <source>{:g} px is unusual ({:g} to {:g} px): check the decimal mark</source>
        <translation>{} px ist ungewöhnlich ({} bis {} px): das Dezimalzeichen prüfen</translation>
    </message>
    <message>
        <source>the radius of a ball</source>
        <translation>den Radius einer Kugel</translation>
    </message>
    <message>
        <source>the width of a face</source>
        <translation>die Breite einer Fläche</translation>
    </message>
    <message>
        <source>the thickness of a layer</source>
        <translation>die Dicke einer Schicht</translation>
    </message>
    <message>
        <source>the distance of a flat face</source>
        <translation>den Abstand einer ebenen Fläche</translation>
    </message>
    <message>
        <source>the depth of a press</source>
        <translation>die Tiefe eines Eindrucks</translation>
    </message>
    <message>
        <source>the uncertainty of a depth</source>
        <translation>die Unsicherheit einer Tiefe</translation>
    </message>
    <message>
        <source>the step of a punch</source>
        <translation>die Stufe eines Stempels</translation>
    </message>
    <message>
        <source>the side of a square</source>
        <translation>die Seite eines Quadrats</translation>
    </message>
    <message>
        <source>a length on a finger</source>
        <translation>eine Länge am Finger</translation>
    </message>
    <message>
        <source>the thickness of the translucent layer in mm, for example 1.5</source>
        <translation>die Dicke der durchscheinenden Schicht in mm, zum Beispiel 1.5</translation>
    </message>
    <message>
        <source>the distance between the two edges of the view face in mm</source>
        <translation>der Abstand der beiden Kanten der Fläche in mm</translation>
    </message>
    <message>
        <source>a fin_ray needs a perspective camera: its shape is computed from it</source>
        <translation>ein fin_ray braucht eine perspektivische Kamera: Seine Form wird daraus berechnet</translation>
    </message>
    <message>
        <source>pinhole, brown or fisheye</source>
        <translation>pinhole, brown oder fisheye</translation>
    </message>
    <message>
        <source>must be above 0 and at most 10000: the face is in front of the camera</source>
        <translation>muss über 0 und höchstens 10000 sein: Die Fläche liegt vor der Kamera</translation>
    </message>
    <message>
        <source>must be a number from -10000 to 10000</source>
        <translation>muss eine Zahl von -10000 bis 10000 sein</translation>
    </message>
    <message>
        <source>the distance of the face from the camera in mm</source>
        <translation>der Abstand der Fläche von der Kamera in mm</translation>
    </message>
    <message>
        <source>a flat sensor has no markers</source>
        <translation>ein flacher Sensor hat keine Marken</translation>
    </message>
    <message>
        <source>remove the block &apos;markers&apos;</source>
        <translation>den Block &apos;markers&apos; entfernen</translation>
    </message>
    <message>
        <source>must be an integer from 0 to 64</source>
        <translation>muss eine ganze Zahl von 0 bis 64 sein</translation>
    </message>
    <message>
        <source>the number of dots on one side face, 0 for a finger without</source>
        <translation>die Zahl der Punkte auf einer Seitenfläche, 0 bei einem Finger ohne Punkte</translation>
    </message>
    <message>
        <source>must be numbers from 0 to {}, ascending</source>
        <translation>müssen aufsteigende Nummern von 0 bis {} sein</translation>
    </message>
    <message>
        <source>record the reference again</source>
        <translation>die Referenz neu aufnehmen</translation>
    </message>
    <message>
        <source>calibrate again</source>
        <translation>neu kalibrieren</translation>
    </message>
    <message>
        <source>gives depths up to {:.3g} mm in a layer of {:g} mm</source>
        <translation>ergibt Tiefen bis {} mm in einer Schicht von {} mm</translation>
    </message>
    <message>
        <source>must be a number from 0 to 1000</source>
        <translation>muss eine Zahl von 0 bis 1000 sein</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a file in the finger&apos;s folder</source>
        <translation>&apos;{}&apos; ist keine Datei im Ordner des Fingers</translation>
    </message>
    <message>
        <source>copy the file into the folder and give its name only</source>
        <translation>die Datei in den Ordner kopieren und nur ihren Namen angeben</translation>
    </message>
    <message>
        <source>must be a column of the image and a step of 0.001 to 500 mm</source>
        <translation>muss eine Spalte des Bildes und ein Schritt von 0.001 bis 500 mm sein</translation>
    </message>
    <message>
        <source>there is either a video with its markers or one image, not both</source>
        <translation>es gibt entweder ein Video mit seinen Marken oder ein Bild, nicht beides</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>eines davon entfernen</translation>
    </message>
    <message>
        <source>must be above 0 and at most 1000000</source>
        <translation>muss über 0 und höchstens 1000000 sein</translation>
    </message>
    <message>
        <source>holds {} positions, but there are {} markers</source>
        <translation>enthält {} Positionen, aber es gibt {} Marken</translation>
    </message>
    <message>
        <source>holds a position far outside the image</source>
        <translation>enthält eine Position weit außerhalb des Bildes</translation>
    </message>
    <message>
        <source>must be three numbers from -10000 to 10000</source>
        <translation>muss drei Zahlen von -10000 bis 10000 enthalten</translation>
    </message>
    <message>
        <source>where the camera sits in the gripper, in mm</source>
        <translation>wo die Kamera im Greifer sitzt, in mm</translation>
    </message>
    <message>
        <source>is no rotation: a quaternion w, x, y, z has the length 1</source>
        <translation>ist keine Drehung: ein Quaternion w, x, y, z hat die Länge 1</translation>
    </message>
    <message>
        <source>[1.0, 0.0, 0.0, 0.0] for a camera that is not turned</source>
        <translation>[1.0, 0.0, 0.0, 0.0] für eine nicht gedrehte Kamera</translation>
    </message>
    <message>
        <source>must be a text of 1 to 200 characters</source>
        <translation>muss ein Text von 1 bis 200 Zeichen sein</translation>
    </message>
    <message>
        <source>what is written on the finger</source>
        <translation>was auf dem Finger steht</translation>
    </message>
    <message>
        <source>states how a mapping was made, but there is none</source>
        <translation>nennt die Herkunft einer Abbildung, aber es gibt keine</translation>
    </message>
    <message>
        <source>calibrate</source>
        <translation>kalibrieren</translation>
    </message>
    <message>
        <source>a length in mm</source>
        <translation>eine Länge in mm</translation>
    </message>
    <message>
        <source>a distance in mm</source>
        <translation>ein Abstand in mm</translation>
    </message>
    <message>
        <source>must be a list of integers</source>
        <translation>muss eine Liste ganzer Zahlen sein</translation>
    </message>
    <message>
        <source>[3, 9]</source>
        <translation>[3, 9]</translation>
    </message>
    <message>
        <source>must have as many numbers in each row as there are rows</source>
        <translation>muss in jeder Zeile so viele Zahlen haben, wie es Zeilen gibt</translation>
    </message>
    <message>
        <source>is not the curve that &apos;chebyshev&apos; gives</source>
        <translation>ist nicht die Kurve, die &apos;chebyshev&apos; ergibt</translation>
    </message>
    <message>
        <source>remove this line: it is only for people to read</source>
        <translation>diese Zeile entfernen: Sie ist nur zum Lesen da</translation>
    </message>
    <message>
        <source>a fraction of the depth</source>
        <translation>ein Bruchteil der Tiefe</translation>
    </message>
    <message>
        <source>must be two numbers: mm along and across the face</source>
        <translation>müssen zwei Zahlen sein: mm längs und quer auf der Fläche</translation>
    </message>
    <message>
        <source>must be two numbers, the first of them 0</source>
        <translation>müssen zwei Zahlen sein, die erste davon 0</translation>
    </message>
    <message>
        <source>for example [0.0, 0.62]</source>
        <translation>zum Beispiel [0.0, 0.62]</translation>
    </message>
    <message>
        <source>a depth in mm</source>
        <translation>eine Tiefe in mm</translation>
    </message>
    <message>
        <source>without unit</source>
        <translation>ohne Einheit</translation>
    </message>
    <message>
        <source>in mm</source>
        <translation>in mm</translation>
    </message>
    <message>
        <source>must be two numbers: a column in px, a step in mm</source>
        <translation>müssen zwei Zahlen sein: eine Spalte in px, ein Schritt in mm</translation>
    </message>
    <message>
        <source>a sum of offsets in pixels</source>
        <translation>eine Summe von Verschiebungen in Pixeln</translation>
    </message>
    <message>
        <source>must hold two numbers for each marker</source>
        <translation>muss für jede Marke zwei Zahlen enthalten</translation>
    </message>
    <message>
        <source>[[u, v], ...]</source>
        <translation>[[u, v], ...]</translation>
    </message>
    <message>
        <source>must be three numbers: x, y, z in mm</source>
        <translation>muss drei Zahlen enthalten: x, y, z in mm</translation>
    </message>
    <message>
        <source>must be four numbers: w, x, y, z of a unit quaternion</source>
        <translation>muss vier Zahlen enthalten: w, x, y, z eines Einheitsquaternions</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be read by this version</source>
        <translation>&apos;{}&apos; kann diese Version nicht lesen</translation>
    </message>
    <message>
        <source>a newer version of this program, or &apos;{}&apos;</source>
        <translation>eine neuere Version dieses Programms, oder &apos;{}&apos;</translation>
    </message>
    <message>
        <source>must name a file</source>
        <translation>muss eine Datei nennen</translation>
    </message>
    <message>
        <source>force.yaml</source>
        <translation>force.yaml</translation>
    </message>
    <message>
        <source>leave it out, or calibrate again</source>
        <translation>weglassen, oder neu kalibrieren</translation>
    </message>
    <message>
        <source>must be {0} rows of {0} numbers</source>
        <translation>muss aus {0} Zeilen mit {0} Zahlen bestehen</translation>
    </message>
    <message>
        <source>holds values that no covariance has</source>
        <translation>enthält Werte, die keine Kovarianz hat</translation>
    </message>
    <message>
        <source>has a negative variance</source>
        <translation>hat eine negative Varianz</translation>
    </message>
    <message>
        <source>is not symmetric</source>
        <translation>ist nicht symmetrisch</translation>
    </message>
    <message>
        <source>must hold finite numbers, half_mm above 0, along and across together at most 0.5</source>
        <translation>muss endliche Zahlen enthalten, half_mm über 0, along und across zusammen höchstens 0.5</translation>
    </message>
    <message>
        <source>must be a positive number</source>
        <translation>muss eine positive Zahl sein</translation>
    </message>
    <message>
        <source>must be greater than {:.6g}, where the curve has its pole, and at most 1000000</source>
        <translation>muss größer als {} sein, wo die Kurve ihren Pol hat, und höchstens 1000000</translation>
    </message>
    <message>
        <source>must hold 1 to {} numbers</source>
        <translation>muss 1 bis {} Zahlen enthalten</translation>
    </message>
    <message>
        <source>holds a number that is no coefficient in mm</source>
        <translation>enthält eine Zahl, die kein Koeffizient in mm ist</translation>
    </message>
    <message>
        <source>must end above 0 and at 1 or below: it is a relative difference of brightness</source>
        <translation>muss über 0 und bei 1 oder darunter enden: Es ist ein relativer Helligkeitsunterschied</translation>
    </message>
    <message>
        <source>the curve does not rise at x = {:.4g} (slope {:.4g} mm)</source>
        <translation>die Kurve steigt bei x = {} nicht (Steigung {} mm)</translation>
    </message>
    <message>
        <source>calibrate with fewer coefficients or as moebius, or with deeper presses</source>
        <translation>mit weniger Koeffizienten oder als moebius kalibrieren, oder mit tieferen Eindrücken</translation>
    </message>
    <message>
        <source>gives a depth of {:.4g} mm at the end of its domain; it must lie above 0 and below {:g} mm</source>
        <translation>ergibt am Ende ihres Bereichs eine Tiefe von {} mm; sie muss über 0 und unter {} mm liegen</translation>
    </message>
    <message>
        <source>there is a finger already, and it is never overwritten</source>
        <translation>es gibt schon einen Finger, und er wird nie überschrieben</translation>
    </message>
    <message>
        <source>another folder, or moving that one away</source>
        <translation>ein anderer Ordner, oder diesen verschieben</translation>
    </message>
    <message>
        <source>could not write the file</source>
        <translation>die Datei ließ sich nicht schreiben</translation>
    </message>
    <message>
        <source>could not confirm that the folder is on the disk</source>
        <translation>es ließ sich nicht sicherstellen, dass der Ordner auf dem Datenträger ist</translation>
    </message>
    <message>
        <source>its folder does not exist</source>
        <translation>ihr Ordner existiert nicht</translation>
    </message>
    <message>
        <source>create the folder first, or check the path for typing errors</source>
        <translation>zuerst den Ordner anlegen, oder den Pfad auf Tippfehler prüfen</translation>
    </message>
    <message>
        <source>could not read the file</source>
        <translation>die Datei ließ sich nicht lesen</translation>
    </message>
    <message>
        <source>it is larger than {} bytes</source>
        <translation>sie ist größer als {} Bytes</translation>
    </message>
    <message>
        <source>check that it is the right file</source>
        <translation>prüfen, ob es die richtige Datei ist</translation>
    </message>
    <message>
        <source>could not create the folder</source>
        <translation>der Ordner ließ sich nicht anlegen</translation>
    </message>
    <message>
        <source>a shorter USB cable or another port; if it persists, another format or a lower rate</source>
        <translation>ein kürzeres USB-Kabel oder ein anderer Anschluss; wenn das nicht hilft, ein anderes Format oder eine kleinere Bildrate</translation>
    </message>
    <message>
        <source>a frame arrived with {} of {} bytes</source>
        <translation>ein Bild kam mit {} von {} Bytes an</translation>
    </message>
    <message>
        <source>a {}x{} frame arrived instead of {}x{}</source>
        <translation>ein Bild mit {}x{} kam an statt {}x{}</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>ein anderes Programm</translation>
    </message>
    <message>
        <source>already in use by {0}</source>
        <translation>schon in Gebrauch durch {0}</translation>
    </message>
    <message>
        <source>waiting until that is done</source>
        <translation>warten, bis das fertig ist</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>ließ sich nicht schreiben</translation>
    </message>
    <message>
        <source>could not be locked</source>
        <translation>ließ sich nicht sperren</translation>
    </message>
    <message>
        <source>the image header gives {} x {} px; a side must have 1 to {}</source>
        <translation>das Bild gibt {} x {} px an; eine Seite muss 1 bis {} haben</translation>
    </message>
    <message>
        <source>a smaller image, or copy it again if that size is wrong</source>
        <translation>ein kleineres Bild, oder noch einmal kopieren, wenn diese Größe falsch ist</translation>
    </message>
    <message>
        <source>the image is damaged or truncated</source>
        <translation>das Bild ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>copy or record it again</source>
        <translation>noch einmal kopieren oder aufnehmen</translation>
    </message>
    <message>
        <source>the image has transparent parts; a camera image has none</source>
        <translation>das Bild hat durchsichtige Teile; ein Kamerabild hat keine</translation>
    </message>
    <message>
        <source>the image as the camera took it, without an alpha channel</source>
        <translation>das Bild, wie die Kamera es aufnahm, ohne Alphakanal</translation>
    </message>
    <message>
        <source>the image has {} channels; 1 or 3 are needed</source>
        <translation>das Bild hat {} Kanäle; 1 oder 3 sind nötig</translation>
    </message>
    <message>
        <source>the image as the camera took it</source>
        <translation>das Bild, wie die Kamera es aufnahm</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>cannot write this kind of image ({}) under that name</source>
        <translation>diese Art von Bild ({}) lässt sich unter diesem Namen nicht schreiben</translation>
    </message>
    <message>
        <source>&apos;.png&apos; for 8-bit images, &apos;.tiff&apos; for floating point</source>
        <translation>&apos;.png&apos; für 8-Bit-Bilder, &apos;.tiff&apos; für Gleitkomma</translation>
    </message>
    <message>
        <source>could not encode the image</source>
        <translation>das Bild ließ sich nicht kodieren</translation>
    </message>
    <message>
        <source>a smaller image</source>
        <translation>ein kleineres Bild</translation>
    </message>
    <message>
        <source>this kind of image cannot be used ({})</source>
        <translation>diese Art von Bild lässt sich nicht verwenden ({})</translation>
    </message>
    <message>
        <source>8-bit grey images</source>
        <translation>8-Bit-Graubilder</translation>
    </message>
    <message>
        <source>the image is in colour: its channels differ from grey by {:.0f} %</source>
        <translation>das Bild ist farbig: Seine Kanäle weichen um {} % von Grau ab</translation>
    </message>
    <message>
        <source>an image of the finger under white light</source>
        <translation>ein Bild des Fingers unter weißem Licht</translation>
    </message>
    <message>
        <source>the image is all black</source>
        <translation>das Bild ist ganz schwarz</translation>
    </message>
    <message>
        <source>switch on the light, or take off the lens cap</source>
        <translation>das Licht einschalten, oder den Objektivdeckel abnehmen</translation>
    </message>
    <message>
        <source>the image is no 32-bit floating-point TIFF with 1 or 3 channels</source>
        <translation>das Bild ist kein TIFF mit 32-Bit-Gleitkomma und 1 oder 3 Kanälen</translation>
    </message>
    <message>
        <source>a depth or points image written by this program</source>
        <translation>ein Tiefen- oder Punktebild, das dieses Programm schrieb</translation>
    </message>
    <message>
        <source>the image is truncated</source>
        <translation>das Bild ist abgeschnitten</translation>
    </message>
    <message>
        <source>the image is damaged</source>
        <translation>das Bild ist beschädigt</translation>
    </message>
    <message>
        <source>it does not begin with its header</source>
        <translation>es beginnt nicht mit seinem Dateikopf</translation>
    </message>
    <message>
        <source>a check sum is wrong</source>
        <translation>eine Prüfsumme stimmt nicht</translation>
    </message>
    <message>
        <source>its parts do not match</source>
        <translation>seine Teile passen nicht zusammen</translation>
    </message>
    <message>
        <source>it has no header</source>
        <translation>es hat keinen Dateikopf</translation>
    </message>
    <message>
        <source>its header is of an obsolete kind</source>
        <translation>sein Dateikopf ist von einer veralteten Art</translation>
    </message>
    <message>
        <source>its width is negative</source>
        <translation>seine Breite ist negativ</translation>
    </message>
    <message>
        <source>its header contains something that is no number</source>
        <translation>sein Dateikopf enthält etwas, das keine Zahl ist</translation>
    </message>
    <message>
        <source>its white is not 255</source>
        <translation>sein Weiß ist nicht 255</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the file is not an image of a known kind</source>
        <translation>die Datei ist kein Bild einer bekannten Art</translation>
    </message>
    <message>
        <source>PNG, JPEG, BMP, binary PGM or TIFF</source>
        <translation>PNG, JPEG, BMP, binäres PGM oder TIFF</translation>
    </message>
    <message>
        <source>no surface can be written under such a name</source>
        <translation>unter einem solchen Namen lässt sich keine Oberfläche schreiben</translation>
    </message>
    <message>
        <source>a name that ends in .ply, .vtp, .stl or .glb</source>
        <translation>ein Name, der auf .ply, .vtp, .stl oder .glb endet</translation>
    </message>
    <message>
        <source>there is no point of the face to write</source>
        <translation>es gibt keinen Punkt der Fläche zu schreiben</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>free some space, or choose a folder on another disk</source>
        <translation>Platz schaffen, oder einen Ordner auf einem anderen Datenträger wählen</translation>
    </message>
    <message>
        <source>your disk quota is used up</source>
        <translation>Ihr Speicherkontingent ist aufgebraucht</translation>
    </message>
    <message>
        <source>free some space, or choose another disk</source>
        <translation>Platz schaffen, oder einen anderen Datenträger wählen</translation>
    </message>
    <message>
        <source>the file would be larger than this system allows</source>
        <translation>die Datei würde größer, als dieses System erlaubt</translation>
    </message>
    <message>
        <source>another disk</source>
        <translation>ein anderer Datenträger</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>der Datenträger ist schreibgeschützt</translation>
    </message>
    <message>
        <source>a folder on a disk that can be written to</source>
        <translation>ein Ordner auf einem beschreibbaren Datenträger</translation>
    </message>
    <message>
        <source>access is not allowed</source>
        <translation>der Zugriff ist nicht erlaubt</translation>
    </message>
    <message>
        <source>another folder, or ask its owner for access</source>
        <translation>ein anderer Ordner, oder seinen Besitzer um Zugriff bitten</translation>
    </message>
    <message>
        <source>it does not exist</source>
        <translation>existiert nicht</translation>
    </message>
    <message>
        <source>check the path for typing errors</source>
        <translation>den Pfad auf Tippfehler prüfen</translation>
    </message>
    <message>
        <source>a part of the path is no folder</source>
        <translation>ein Teil des Pfads ist kein Ordner</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>name a file inside it</source>
        <translation>eine Datei darin nennen</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>der Name ist zu lang</translation>
    </message>
    <message>
        <source>a shorter name</source>
        <translation>ein kürzerer Name</translation>
    </message>
    <message>
        <source>the disk reports a fault</source>
        <translation>der Datenträger meldet einen Fehler</translation>
    </message>
    <message>
        <source>another disk, and check this one</source>
        <translation>ein anderer Datenträger, und diesen prüfen</translation>
    </message>
    <message>
        <source>too many files are open</source>
        <translation>zu viele Dateien sind offen</translation>
    </message>
    <message>
        <source>close other programs</source>
        <translation>andere Programme schließen</translation>
    </message>
    <message>
        <source>once more, or another folder</source>
        <translation>noch einmal, oder ein anderer Ordner</translation>
    </message>
    <message>
        <source>could not write the archive</source>
        <translation>das Archiv ließ sich nicht schreiben</translation>
    </message>
    <message>
        <source>another name for this file</source>
        <translation>ein anderer Name für diese Datei</translation>
    </message>
    <message>
        <source>packing {}</source>
        <translation>{} wird gepackt</translation>
    </message>
    <message>
        <source>stopped before it was packed</source>
        <translation>angehalten, bevor es gepackt war</translation>
    </message>
    <message>
        <source>{}, {}</source>
        <translation>{}, {}</translation>
    </message>
    <message>
        <source>{}; {}</source>
        <translation>{}; {}</translation>
    </message>
    <message>
        <source>{}. {}</source>
        <translation>{}. {}</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>this file of the program is missing</source>
        <translation>diese Datei des Programms fehlt</translation>
    </message>
    <message>
        <source>installing the program again</source>
        <translation>das Programm neu installieren</translation>
    </message>
    <message>
        <source>could not write the recording&apos;s journal</source>
        <translation>das Journal der Aufnahme ließ sich nicht schreiben</translation>
    </message>
    <message>
        <source>frame {} is older than frame {}</source>
        <translation>Bild {} ist älter als Bild {}</translation>
    </message>
    <message>
        <source>move this file away to use the video&apos;s own times</source>
        <translation>diese Datei verschieben, um die Zeiten des Videos selbst zu verwenden</translation>
    </message>
    <message>
        <source>play it in a video player; if that fails too, record it again</source>
        <translation>in einem Videoprogramm abspielen; geht auch das nicht, neu aufnehmen</translation>
    </message>
    <message>
        <source>once more</source>
        <translation>noch einmal</translation>
    </message>
    <message>
        <source>the video cannot be opened</source>
        <translation>das Video lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>its pixel format has no brightness</source>
        <translation>sein Pixelformat hat keine Helligkeit</translation>
    </message>
    <message>
        <source>a grey or colour video</source>
        <translation>ein graues oder farbiges Video</translation>
    </message>
    <message>
        <source>could not write the video</source>
        <translation>das Video ließ sich nicht schreiben</translation>
    </message>
    <message>
        <source>it is being recorded or repaired right now</source>
        <translation>sie wird gerade aufgenommen oder repariert</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>ein anderer Name</translation>
    </message>
    <message>
        <source>this is no Matroska file</source>
        <translation>dies ist keine Matroska-Datei</translation>
    </message>
    <message>
        <source>stopped before it was repaired</source>
        <translation>angehalten, bevor sie repariert war</translation>
    </message>
    <message>
        <source>repairing an interrupted recording</source>
        <translation>eine unterbrochene Aufnahme wird repariert</translation>
    </message>
    <message>
        <source>only {} of its {} frames could be read</source>
        <translation>nur {} ihrer {} Bilder ließen sich lesen</translation>
    </message>
    <message>
        <source>another copy of the recording</source>
        <translation>eine andere Kopie der Aufnahme</translation>
    </message>
    <message>
        <source>the interrupted recording cannot be repaired</source>
        <translation>die unterbrochene Aufnahme lässt sich nicht reparieren</translation>
    </message>
    <message>
        <source>wait for its end</source>
        <translation>ihr Ende abwarten</translation>
    </message>
    <message>
        <source>could not restore the recording</source>
        <translation>die Aufnahme ließ sich nicht wiederherstellen</translation>
    </message>
    <message>
        <source>stopped when {} of {} MB of the recording were restored</source>
        <translation>angehalten, als {} von {} MB der Aufnahme wiederhergestellt waren</translation>
    </message>
    <message>
        <source>restoring the removed recording: {} of {} MB</source>
        <translation>die entfernte Aufnahme wird wiederhergestellt: {} von {} MB</translation>
    </message>
    <message>
        <source>the disk is nearly full: {} MB are left, {} MB must stay free</source>
        <translation>der Datenträger ist fast voll: {} MB sind übrig, {} MB müssen frei bleiben</translation>
    </message>
    <message>
        <source>free some space, or record to another disk</source>
        <translation>Platz schaffen, oder auf einen anderen Datenträger aufnehmen</translation>
    </message>
    <message>
        <source>the file exists already</source>
        <translation>die Datei existiert schon</translation>
    </message>
    <message>
        <source>another name, or remove the old one</source>
        <translation>ein anderer Name, oder die alte entfernen</translation>
    </message>
    <message>
        <source>could not start the recording: its folder does not exist</source>
        <translation>die Aufnahme ließ sich nicht starten: Ihr Ordner existiert nicht</translation>
    </message>
    <message>
        <source>could not start the recording</source>
        <translation>die Aufnahme ließ sich nicht starten</translation>
    </message>
    <message>
        <source>how images are stored, always without loss: auto stores the camera&apos;s own packets (mjpeg) where available, else magicyuv; ffv1 is about a tenth smaller and four times slower to read</source>
        <translation>wie Bilder gespeichert werden, immer ohne Verlust: auto speichert die Pakete der Kamera (mjpeg), wo vorhanden, sonst magicyuv; ffv1 ist etwa ein Zehntel kleiner und viermal langsamer zu lesen</translation>
    </message>
    <message>
        <source>memory for frames that wait for the disk, in megabytes</source>
        <translation>Speicher für Bilder, die auf den Datenträger warten, in Megabyte</translation>
    </message>
    <message>
        <source>space that is left free on the disk, in megabytes; the recording ends before</source>
        <translation>Platz, der auf dem Datenträger frei bleibt, in Megabyte; die Aufnahme endet vorher</translation>
    </message>
    <message>
        <source>the recording was removed while it was being made</source>
        <translation>die Aufnahme wurde entfernt, während sie lief</translation>
    </message>
    <message>
        <source>no frame arrived, so nothing was recorded</source>
        <translation>kein Bild kam an, also wurde nichts aufgenommen</translation>
    </message>
    <message>
        <source>check the source</source>
        <translation>die Quelle prüfen</translation>
    </message>
    <message>
        <source>the recording was removed at its end</source>
        <translation>die Aufnahme wurde an ihrem Ende entfernt</translation>
    </message>
    <message>
        <source>{}, and it could not be restored ({})</source>
        <translation>{}, und sie ließ sich nicht wiederherstellen ({})</translation>
    </message>
    <message>
        <source>record again, and leave the folder alone meanwhile</source>
        <translation>neu aufnehmen und den Ordner dabei nicht verändern</translation>
    </message>
    <message>
        <source>what was recorded until then was restored</source>
        <translation>was bis dahin aufgenommen war, wurde wiederhergestellt</translation>
    </message>
    <message>
        <source>leave the folder alone while it records</source>
        <translation>den Ordner während der Aufnahme nicht verändern</translation>
    </message>
    <message>
        <source>recordings are Matroska files</source>
        <translation>Aufnahmen sind Matroska-Dateien</translation>
    </message>
    <message>
        <source>a name that ends in .mkv</source>
        <translation>ein Name, der auf .mkv endet</translation>
    </message>
    <message>
        <source>the video cannot be opened: no decoder for {}</source>
        <translation>das Video lässt sich nicht öffnen: kein Dekoder für {}</translation>
    </message>
    <message>
        <source>frame {} of the video cannot be read</source>
        <translation>Bild {} des Videos lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>the video holds no frame</source>
        <translation>das Video enthält kein Bild</translation>
    </message>
    <message>
        <source>this system&apos;s libavcodec cannot write {}</source>
        <translation>die libavcodec dieses Systems kann {} nicht schreiben</translation>
    </message>
    <message>
        <source>another codec, or Debian&apos;s libavcodec</source>
        <translation>ein anderer Codec, oder die libavcodec von Debian</translation>
    </message>
    <message>
        <source>only 8-bit grey images can be recorded</source>
        <translation>nur 8-Bit-Graubilder lassen sich aufnehmen</translation>
    </message>
    <message>
        <source>a grey source</source>
        <translation>eine graue Quelle</translation>
    </message>
    <message>
        <source>the image is {} x {}, those before were {} x {}</source>
        <translation>das Bild hat {} x {}, die davor hatten {} x {}</translation>
    </message>
    <message>
        <source>one recording for each size</source>
        <translation>eine Aufnahme je Größe</translation>
    </message>
    <message>
        <source>the source delivers no JPEG packets to store unchanged</source>
        <translation>die Quelle liefert keine JPEG-Pakete, die sich unverändert speichern ließen</translation>
    </message>
    <message>
        <source>the codec magicyuv or ffv1</source>
        <translation>der Codec magicyuv oder ffv1</translation>
    </message>
    <message>
        <source>{}. Try: {}</source>
        <translation>{}. Abhilfe: {}</translation>
    </message>
    <message>
        <source>the two long edges of the face were not found</source>
        <translation>die beiden langen Kanten der Fläche wurden nicht gefunden</translation>
    </message>
    <message>
        <source>the image</source>
        <translation>das Bild</translation>
    </message>
    <message>
        <source>light the finger as in its recording; check that the image shows the face from base to tip, with the finger along the image&apos;s width</source>
        <translation>den Finger wie bei seiner Aufnahme beleuchten; prüfen, ob das Bild die Fläche vom Fuß bis zur Spitze zeigt, mit dem Finger längs der Bildbreite</translation>
    </message>
    <message>
        <source>the face&apos;s edges</source>
        <translation>die Kanten der Fläche</translation>
    </message>
    <message>
        <source>an image in which both long edges of the bright face are visible and lit evenly; check that the lamps are on and that the lens is clean</source>
        <translation>ein Bild, auf dem beide langen Kanten der hellen Fläche zu sehen und gleichmäßig beleuchtet sind; prüfen, ob die Lampen an sind und das Objektiv sauber ist</translation>
    </message>
    <message>
        <source>the shape of a Fin Ray needs a perspective camera, not an orthographic one</source>
        <translation>die Form eines Fin Ray braucht eine perspektivische Kamera, keine orthografische</translation>
    </message>
    <message>
        <source>no smooth shape fits the outline of the face: it jumps at column {:.0f}</source>
        <translation>keine glatte Form passt zum Umriss der Fläche: Er springt bei Spalte {}</translation>
    </message>
    <message>
        <source>bending the finger less, until no part of it hides another</source>
        <translation>den Finger weniger biegen, bis kein Teil von ihm einen anderen verdeckt</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>the {} edge of the face was seen in too few columns</source>
        <translation>die Kante der Fläche {} war in zu wenigen Spalten zu sehen</translation>
    </message>
    <message>
        <source>the two edges were never seen together</source>
        <translation>die beiden Kanten wurden nie zusammen gesehen</translation>
    </message>
    <message>
        <source>no smooth shape fits them</source>
        <translation>keine glatte Form passt zu ihnen</translation>
    </message>
    <message>
        <source>the distance of the face is too uncertain in every column</source>
        <translation>der Abstand der Fläche ist in jeder Spalte zu unsicher</translation>
    </message>
    <message>
        <source>the image is black: its brightest parts reach {} of 255 grey levels; take the cap off the lens, switch the lamps on, or expose longer</source>
        <translation>das Bild ist schwarz: Seine hellsten Stellen erreichen {} von 255 Graustufen; die Kappe vom Objektiv nehmen, die Lampen einschalten oder länger belichten</translation>
    </message>
    <message>
        <source>the image is too bright: {:.0f} % of it is saturated; expose shorter, or dim the lamps</source>
        <translation>das Bild ist zu hell: {} % davon sind gesättigt; kürzer belichten oder die Lampen dimmen</translation>
    </message>
    <message>
        <source>the image is blank: every pixel has {} of 255 grey levels, without even camera noise; plug the camera in again</source>
        <translation>das Bild ist leer: Jedes Pixel hat {} von 255 Graustufen, ohne jedes Kamerarauschen; die Kamera neu einstecken</translation>
    </message>
    <message>
        <source>{:.0f} % of the face is too bright to be measured; expose shorter, or dim the lamps</source>
        <translation>{} % der Fläche sind zu hell, um gemessen zu werden; kürzer belichten oder die Lampen dimmen</translation>
    </message>
    <message>
        <source>{:.0f} % of the face was never recorded in a pose like this; record the finger bending further in this direction</source>
        <translation>{} % der Fläche wurden in einer solchen Haltung nie aufgenommen; den Finger weiter in diese Richtung gebogen aufnehmen</translation>
    </message>
    <message>
        <source>{:.1f} % of the face, at its end, is hidden in this frame; whether it is in contact there is unknown</source>
        <translation>{} % der Fläche, an ihrem Ende, sind in diesem Bild verdeckt; ob dort Kontakt besteht, ist unbekannt</translation>
    </message>
    <message>
        <source>the face is {:.0f} % darker than when its reference was recorded; set exposure, gain and lamps as they were then</source>
        <translation>die Fläche ist {} % dunkler als bei der Aufnahme ihrer Referenz; Belichtung, Verstärkung und Lampen wie damals einstellen</translation>
    </message>
    <message>
        <source>the face is {:.0f} % brighter than when its reference was recorded; set exposure, gain and lamps as they were then</source>
        <translation>die Fläche ist {} % heller als bei der Aufnahme ihrer Referenz; Belichtung, Verstärkung und Lampen wie damals einstellen</translation>
    </message>
    <message>
        <source>{:.0f} % of the face is brighter than its reference: this is another finger, or its skin has changed; choose the right finger, or record the reference again</source>
        <translation>{} % der Fläche sind heller als ihre Referenz: Das ist ein anderer Finger, oder seine Haut hat sich verändert; den richtigen Finger wählen oder die Referenz neu aufnehmen</translation>
    </message>
    <message>
        <source>only {} recorded images show every marker; at least 2 are needed</source>
        <translation>nur {} aufgenommene Bilder zeigen alle Marken; mindestens 2 sind nötig</translation>
    </message>
    <message>
        <source>marker model</source>
        <translation>Markenmodell</translation>
    </message>
    <message>
        <source>record the finger bending with both side faces in view and evenly lit</source>
        <translation>den Finger beim Biegen aufnehmen, mit beiden Seitenflächen im Bild und gleichmäßig beleuchtet</translation>
    </message>
    <message>
        <source>{} markers have a position but {} have a size</source>
        <translation>{} Marken haben eine Position, aber {} haben eine Größe</translation>
    </message>
    <message>
        <source>the markers&apos; positions are not finite numbers</source>
        <translation>die Positionen der Marken sind keine endlichen Zahlen</translation>
    </message>
    <message>
        <source>{} dots were found next to the face, but less than a third of the {} markers fit any pose of the reference recording</source>
        <translation>{} Punkte wurden neben der Fläche gefunden, aber weniger als ein Drittel der {} Marken passt zu einer Haltung der Referenzaufnahme</translation>
    </message>
    <message>
        <source>this pose was never recorded: the nearest reference frame is {:.1f} px away; record the finger bending further in this direction</source>
        <translation>diese Haltung wurde nie aufgenommen: Das ähnlichste Referenzbild ist {} px entfernt; den Finger weiter in diese Richtung gebogen aufnehmen</translation>
    </message>
    <message>
        <source>an image of the size that the finger was calibrated with</source>
        <translation>ein Bild in der Größe, mit der der Finger kalibriert wurde</translation>
    </message>
    <message>
        <source>the image equals the previous one to the last grey level: the camera is frozen; plug it in again</source>
        <translation>das Bild gleicht dem vorigen in jeder Graustufe: Die Kamera ist eingefroren; sie neu einstecken</translation>
    </message>
    <message>
        <source>{}.</source>
        <translation>{}.</translation>
    </message>
    <message>
        <source>too little face is visible to estimate the pose from its shape</source>
        <translation>von der Fläche ist zu wenig zu sehen, um die Haltung aus ihrer Form zu schätzen</translation>
    </message>
    <message>
        <source>the markers were not found: this pose is estimated from the face&apos;s shape alone, so depth is less certain, and neither twist nor contact is estimated; uncover and light the dots on the side faces</source>
        <translation>die Marken wurden nicht gefunden: Diese Haltung ist nur aus der Form der Fläche geschätzt; die Tiefe ist weniger sicher, Verdrehung und Kontakt werden nicht geschätzt; die Punkte auf den Seitenflächen freilegen und beleuchten</translation>
    </message>
    <message>
        <source>few recorded frames are near this pose: its reference is {:.0f} times less certain than typical; record the finger bending slowly through it</source>
        <translation>nahe dieser Haltung gibt es wenige aufgenommene Bilder: Ihre Referenz ist {}-mal unsicherer als sonst; den Finger aufnehmen, wie er sich langsam durch diese Haltung biegt</translation>
    </message>
    <message>
        <source>the finger is not calibrated: calibrate it with ball presses</source>
        <translation>der Finger ist nicht kalibriert: mit Kugeleindrücken kalibrieren</translation>
    </message>
    <message>
        <source>how the face&apos;s edges are located: half-height crossing to a fiftieth of a pixel, or the steepest pixel</source>
        <translation>wie die Kanten der Fläche gefunden werden: am halben Anstieg auf ein fünfzigstel Pixel, oder am steilsten ganzen Pixel</translation>
    </message>
    <message>
        <source>pixel columns averaged into one position on each edge</source>
        <translation>Pixelspalten, die zu einer Position auf jeder Kante gemittelt werden</translation>
    </message>
    <message>
        <source>degree of the smooth curve through each edge of the face</source>
        <translation>Grad der glatten Kurve durch jede Kante der Fläche</translation>
    </message>
    <message>
        <source>whether a change of light since the reference is measured on the untouched skin and removed</source>
        <translation>ob eine Lichtänderung seit der Referenz an der unberührten Haut gemessen und herausgerechnet wird</translation>
    </message>
    <message>
        <source>standard deviation of the smoothing before depth is computed, in pixels; 0: none</source>
        <translation>Standardabweichung der Glättung vor der Berechnung der Tiefe, in Pixeln; 0: keine</translation>
    </message>
    <message>
        <source>depth that counts as contact, in millimetres</source>
        <translation>Tiefe, die als Kontakt zählt, in Millimetern</translation>
    </message>
    <message>
        <source>create the reference again from the recording</source>
        <translation>die Referenz aus der Aufnahme neu erstellen</translation>
    </message>
    <message>
        <source>the finger has no markers, so it has no marker table</source>
        <translation>der Finger hat keine Marken, also auch keine Markentabelle</translation>
    </message>
    <message>
        <source>set markers.per_row</source>
        <translation>markers.per_row setzen</translation>
    </message>
    <message>
        <source>{}, line {}</source>
        <translation>{}, Zeile {}</translation>
    </message>
    <message>
        <source>not a marker table; its first line must be &apos;{}&apos;</source>
        <translation>keine Markentabelle; die erste Zeile muss &apos;{}&apos; sein</translation>
    </message>
    <message>
        <source>the table ends too early</source>
        <translation>die Tabelle endet zu früh</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not the last line of a table with {} frames</source>
        <translation>&apos;{}&apos; ist nicht die letzte Zeile einer Tabelle mit {} Bildern</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not hold valid values of &apos;{}&apos;</source>
        <translation>&apos;{}&apos; enthält keine gültigen Werte für &apos;{}&apos;</translation>
    </message>
    <message>
        <source>marker {} stands where marker {} of {} is expected</source>
        <translation>Marke {} steht, wo Marke {} von {} erwartet wird</translation>
    </message>
    <message>
        <source>frame {} comes after frame {}</source>
        <translation>Bild {} kommt nach Bild {}</translation>
    </message>
    <message>
        <source>frame {} has {} markers instead of {}</source>
        <translation>Bild {} hat {} Marken statt {}</translation>
    </message>
    <message>
        <source>marker {} has a different radius or contrast than before</source>
        <translation>Marke {} hat einen anderen Radius oder Kontrast als zuvor</translation>
    </message>
    <message>
        <source>the table contains no frames</source>
        <translation>die Tabelle enthält keine Bilder</translation>
    </message>
    <message>
        <source>stopped before the reference was read</source>
        <translation>vor dem Lesen der Referenz angehalten</translation>
    </message>
    <message>
        <source>reading reference frame {} of {}</source>
        <translation>Referenzbild {} von {} wird gelesen</translation>
    </message>
    <message>
        <source>the face was found in {} of {} recorded images; 2 are needed</source>
        <translation>die Fläche wurde in {} von {} aufgenommenen Bildern gefunden; 2 sind nötig</translation>
    </message>
    <message>
        <source>the marker table lists frame {} but the recording ends after {} frames</source>
        <translation>die Markentabelle nennt Bild {}, aber die Aufnahme endet nach {} Bildern</translation>
    </message>
    <message>
        <source>the recording cannot be read ({})</source>
        <translation>die Aufnahme lässt sich nicht lesen ({})</translation>
    </message>
    <message>
        <source>the sensor has no untouched image</source>
        <translation>der Sensor hat kein unberührtes Bild</translation>
    </message>
    <message>
        <source>specify one for the calibration</source>
        <translation>eines bei der Kalibrierung angeben</translation>
    </message>
    <message>
        <source>the untouched image</source>
        <translation>das unberührte Bild</translation>
    </message>
    <message>
        <source>specify the untouched image again</source>
        <translation>das unberührte Bild erneut angeben</translation>
    </message>
    <message>
        <source>the finger has no reference recording</source>
        <translation>der Finger hat keine Referenzaufnahme</translation>
    </message>
    <message>
        <source>record the untouched finger bending and create its reference</source>
        <translation>den unberührten Finger beim Biegen aufnehmen und seine Referenz erstellen</translation>
    </message>
    <message>
        <source>the reference recording is missing or not a video</source>
        <translation>die Referenzaufnahme fehlt oder ist kein Video</translation>
    </message>
    <message>
        <source>the recording&apos;s image</source>
        <translation>das Bild der Aufnahme</translation>
    </message>
    <message>
        <source>the reference image is not an 8-bit grey image</source>
        <translation>das Referenzbild ist kein 8-Bit-Graustufenbild</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>save it in this format</source>
        <translation>in diesem Format speichern</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number from {} to {}</source>
        <translation>&apos;{}&apos; ist keine Zahl von {} bis {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not {}</source>
        <translation>&apos;{}&apos; ist nicht {}</translation>
    </message>
    <message>
        <source>depth_mm = {:g} reaches through the layer of {:g} mm</source>
        <translation>depth_mm = {} reicht durch die Schicht von {} mm</translation>
    </message>
    <message>
        <source>less than finger.face.layer_mm</source>
        <translation>weniger als finger.face.layer_mm</translation>
    </message>
    <message>
        <source>s_mm is beyond the ends of the face</source>
        <translation>s_mm liegt jenseits der Enden der Fläche</translation>
    </message>
    <message>
        <source>0 to {:g}</source>
        <translation>0 bis {}</translation>
    </message>
    <message>
        <source>y_mm is outside the face</source>
        <translation>y_mm liegt außerhalb der Fläche</translation>
    </message>
    <message>
        <source>{:g} to {:g}</source>
        <translation>{} bis {}</translation>
    </message>
    <message>
        <source>the ball would sink in past its centre</source>
        <translation>die Kugel würde über ihren Mittelpunkt hinaus einsinken</translation>
    </message>
    <message>
        <source>depth_mm below radius_mm</source>
        <translation>depth_mm unter radius_mm</translation>
    </message>
    <message>
        <source>a flat sensor does not bend</source>
        <translation>ein flacher Sensor biegt sich nicht</translation>
    </message>
    <message>
        <source>leave bend out</source>
        <translation>bend weglassen</translation>
    </message>
    <message>
        <source>nothing is pressed in, so nothing bulges</source>
        <translation>nichts wird eingedrückt, also wölbt sich nichts</translation>
    </message>
    <message>
        <source>add ball or relief</source>
        <translation>ball oder relief hinzufügen</translation>
    </message>
    <message>
        <source>there is no lamp</source>
        <translation>es gibt keine Lampe</translation>
    </message>
    <message>
        <source>- {{at_mm: [x, y, z], power: p}}</source>
        <translation>- {{at_mm: [x, y, z], power: p}}</translation>
    </message>
    <message>
        <source>the lamp aims at itself</source>
        <translation>die Lampe zielt auf sich selbst</translation>
    </message>
    <message>
        <source>another point</source>
        <translation>ein anderer Punkt</translation>
    </message>
    <message>
        <source>unknown lobe</source>
        <translation>unbekannte Keule</translation>
    </message>
    <message>
        <source>1, 2, 4 or 8</source>
        <translation>1, 2, 4 oder 8</translation>
    </message>
    <message>
        <source>&apos;first&apos; is not below &apos;last&apos;</source>
        <translation>&apos;first&apos; ist nicht kleiner als &apos;last&apos;</translation>
    </message>
    <message>
        <source>e.g. 0.1 and 0.9</source>
        <translation>z. B. 0.1 und 0.9</translation>
    </message>
    <message>
        <source>the dots would cut the face&apos;s edge</source>
        <translation>die Punkte würden die Kante der Fläche schneiden</translation>
    </message>
    <message>
        <source>less than setback_mm</source>
        <translation>weniger als setback_mm</translation>
    </message>
    <message>
        <source>the finger has no markers</source>
        <translation>der Finger hat keine Marken</translation>
    </message>
    <message>
        <source>finger.markers with per_row and polarity</source>
        <translation>finger.markers mit per_row und polarity</translation>
    </message>
    <message>
        <source>markers are engraved in the side faces</source>
        <translation>Marken sind in die Seitenflächen graviert</translation>
    </message>
    <message>
        <source>add the effect sides</source>
        <translation>den Effekt sides hinzufügen</translation>
    </message>
    <message>
        <source>JPEG needs integer grey levels</source>
        <translation>JPEG braucht ganzzahlige Graustufen</translation>
    </message>
    <message>
        <source>add the effect quantisation</source>
        <translation>den Effekt quantisation hinzufügen</translation>
    </message>
    <message>
        <source>no dot would ever be hidden</source>
        <translation>kein Punkt wäre je verdeckt</translation>
    </message>
    <message>
        <source>leave occlusion out, or use 1 or more</source>
        <translation>occlusion weglassen oder mindestens 1 angeben</translation>
    </message>
    <message>
        <source>{:g} is not a marker number</source>
        <translation>{} ist keine Markennummer</translation>
    </message>
    <message>
        <source>0, 1, 2, ...</source>
        <translation>0, 1, 2, ...</translation>
    </message>
    <message>
        <source>there are no dots to hide</source>
        <translation>es gibt keine Punkte, die verdeckt werden könnten</translation>
    </message>
    <message>
        <source>add the effect markers</source>
        <translation>den Effekt markers hinzufügen</translation>
    </message>
    <message>
        <source>there is no marker {}</source>
        <translation>es gibt keine Marke {}</translation>
    </message>
    <message>
        <source>0 to {}</source>
        <translation>0 bis {}</translation>
    </message>
    <message>
        <source>more dots would be hidden than there are</source>
        <translation>mehr Punkte wären verdeckt, als es gibt</translation>
    </message>
    <message>
        <source>up to {}</source>
        <translation>bis {}</translation>
    </message>
    <message>
        <source>the bars are wider than the T</source>
        <translation>die Balken sind breiter als das T</translation>
    </message>
    <message>
        <source>less than size_mm</source>
        <translation>weniger als size_mm</translation>
    </message>
    <message>
        <source>nothing is pressed in, so nothing rolls off</source>
        <translation>nichts wird eingedrückt, also gibt es keinen Auslauf</translation>
    </message>
    <message>
        <source>kind hertz is for balls only</source>
        <translation>kind hertz gilt nur für Kugeln</translation>
    </message>
    <message>
        <source>kind: smooth with a length_mm</source>
        <translation>kind: smooth mit einem length_mm</translation>
    </message>
    <message>
        <source>a flat sensor has no side faces</source>
        <translation>ein flacher Sensor hat keine Seitenflächen</translation>
    </message>
    <message>
        <source>leave sides out</source>
        <translation>sides weglassen</translation>
    </message>
    <message>
        <source>an orthographic camera sees no side faces</source>
        <translation>eine orthografische Kamera sieht keine Seitenflächen</translation>
    </message>
    <message>
        <source>a flat sensor does not sway</source>
        <translation>ein flacher Sensor neigt sich nicht zur Seite</translation>
    </message>
    <message>
        <source>leave sway out</source>
        <translation>sway weglassen</translation>
    </message>
    <message>
        <source>a flat sensor does not yield</source>
        <translation>ein flacher Sensor gibt nicht nach</translation>
    </message>
    <message>
        <source>leave give_mm out</source>
        <translation>give_mm weglassen</translation>
    </message>
    <message>
        <source>the list is empty</source>
        <translation>die Liste ist leer</translation>
    </message>
    <message>
        <source>one pose per frame</source>
        <translation>eine Haltung je Bild</translation>
    </message>
    <message>
        <source>the motion moves &apos;{}&apos;, but the scene has no such effect</source>
        <translation>die Bewegung bewegt &apos;{}&apos;, aber die Szene hat keinen solchen Effekt</translation>
    </message>
    <message>
        <source>add `bend` or `sway` to the effects</source>
        <translation>`bend` oder `sway` zu den Effekten hinzufügen</translation>
    </message>
    <message>
        <source>{} = {:g} is outside the effect&apos;s range</source>
        <translation>{} = {} liegt außerhalb des Bereichs des Effekts</translation>
    </message>
    <message>
        <source>the motion has nothing to move</source>
        <translation>die Bewegung hat nichts zu bewegen</translation>
    </message>
    <message>
        <source>add `bend` or `sway` to the effects, or leave the motion out</source>
        <translation>`bend` oder `sway` zu den Effekten hinzufügen oder die Bewegung weglassen</translation>
    </message>
    <message>
        <source>scene &apos;{}&apos;: finger.camera</source>
        <translation>Szene &apos;{}&apos;: finger.camera</translation>
    </message>
    <message>
        <source>its camera does not deliver integer grey levels</source>
        <translation>ihre Kamera liefert keine ganzzahligen Graustufen</translation>
    </message>
    <message>
        <source>this is not [width, height]</source>
        <translation>dies ist nicht [Breite, Höhe]</translation>
    </message>
    <message>
        <source>integers from 16 to 16384</source>
        <translation>ganze Zahlen von 16 bis 16384</translation>
    </message>
    <message>
        <source>there is no effect &apos;{}&apos;</source>
        <translation>es gibt keinen Effekt &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the effect &apos;{}&apos; is listed twice</source>
        <translation>der Effekt &apos;{}&apos; ist zweimal aufgeführt</translation>
    </message>
    <message>
        <source>A ball is pressed into the face</source>
        <translation>Eine Kugel wird in die Fläche gedrückt</translation>
    </message>
    <message>
        <source>The finger bends in the plane of its length</source>
        <translation>Der Finger biegt sich in der Ebene seiner Länge</translation>
    </message>
    <message>
        <source>The layer bulges around the object</source>
        <translation>Die Schicht wölbt sich um den Gegenstand</translation>
    </message>
    <message>
        <source>Frames are lost in transmission</source>
        <translation>Bilder gehen bei der Übertragung verloren</translation>
    </message>
    <message>
        <source>Frames arrive late</source>
        <translation>Bilder treffen verspätet ein</translation>
    </message>
    <message>
        <source>The layer over the black coat is darker where it is thinner</source>
        <translation>Die Schicht über der schwarzen Beschichtung ist dunkler, wo sie dünner ist</translation>
    </message>
    <message>
        <source>Lamps light the finger</source>
        <translation>Lampen beleuchten den Finger</translation>
    </message>
    <message>
        <source>Dots are engraved in the side faces</source>
        <translation>In die Seitenflächen sind Punkte graviert</translation>
    </message>
    <message>
        <source>The camera sends JPEG images</source>
        <translation>Die Kamera sendet JPEG-Bilder</translation>
    </message>
    <message>
        <source>Folds of the side faces hide dots</source>
        <translation>Falten der Seitenflächen verdecken Punkte</translation>
    </message>
    <message>
        <source>The sensor outputs integer grey levels from 0 to 255</source>
        <translation>Der Sensor liefert ganzzahlige Graustufen von 0 bis 255</translation>
    </message>
    <message>
        <source>Reading the sensor adds noise</source>
        <translation>Das Auslesen des Sensors fügt Rauschen hinzu</translation>
    </message>
    <message>
        <source>An object with a relief is pressed into the face</source>
        <translation>Ein Gegenstand mit einem Relief wird in die Fläche gedrückt</translation>
    </message>
    <message>
        <source>The face separates gradually from the object</source>
        <translation>Die Fläche löst sich allmählich vom Gegenstand</translation>
    </message>
    <message>
        <source>Light arrives as photons; their noise grows with brightness</source>
        <translation>Licht trifft als Photonen ein; ihr Rauschen wächst mit der Helligkeit</translation>
    </message>
    <message>
        <source>The side faces of the body are visible</source>
        <translation>Die Seitenflächen des Körpers sind sichtbar</translation>
    </message>
    <message>
        <source>The finger leans sideways</source>
        <translation>Der Finger neigt sich zur Seite</translation>
    </message>
    <message>
        <source>{}, in frames {} to {}</source>
        <translation>{}, in den Bildern {} bis {}</translation>
    </message>
    <message>
        <source>its camera does not deliver integer grey levels in frames {} to {}</source>
        <translation>ihre Kamera liefert in den Bildern {} bis {} keine ganzzahligen Graustufen</translation>
    </message>
    <message>
        <source>add the effect quantisation for all frames</source>
        <translation>den Effekt quantisation für alle Bilder hinzufügen</translation>
    </message>
    <message>
        <source>the effect &apos;{}&apos; is listed twice for frames {} to {}</source>
        <translation>der Effekt &apos;{}&apos; ist für die Bilder {} bis {} zweimal aufgeführt</translation>
    </message>
    <message>
        <source>end one with &apos;until&apos; before the other begins with &apos;from&apos;</source>
        <translation>den einen mit &apos;until&apos; beenden, bevor der andere mit &apos;from&apos; beginnt</translation>
    </message>
    <message>
        <source>must be a point in time, not &apos;{}&apos;</source>
        <translation>muss ein Zeitpunkt sein, nicht &apos;{}&apos;</translation>
    </message>
    <message>
        <source>a frame such as 60, or seconds such as 2 s</source>
        <translation>ein Bild wie 60, oder Sekunden wie 2 s</translation>
    </message>
    <message>
        <source>the scene ends before that</source>
        <translation>die Szene endet vorher</translation>
    </message>
    <message>
        <source>one of its frames, 0 to {}</source>
        <translation>eines ihrer Bilder, 0 bis {}</translation>
    </message>
    <message>
        <source>it would never be active, for it begins with frame {}</source>
        <translation>er wäre nie aktiv, denn er beginnt mit Bild {}</translation>
    </message>
    <message>
        <source>a later frame, or leave the effect out</source>
        <translation>ein späteres Bild, oder den Effekt weglassen</translation>
    </message>
    <message>
        <source>the key frame before it has the same time</source>
        <translation>das Schlüsselbild davor hat dieselbe Zeit</translation>
    </message>
    <message>
        <source>a later time, or leave one of the two out</source>
        <translation>eine spätere Zeit, oder eines der beiden weglassen</translation>
    </message>
    <message>
        <source>the key frame before it has a later time</source>
        <translation>das Schlüsselbild davor hat eine spätere Zeit</translation>
    </message>
    <message>
        <source>key frames in order of time</source>
        <translation>Schlüsselbilder in zeitlicher Reihenfolge</translation>
    </message>
    <message>
        <source>this is not text</source>
        <translation>dies ist kein Text</translation>
    </message>
    <message>
        <source>a word or a sentence</source>
        <translation>ein Wort oder ein Satz</translation>
    </message>
    <message>
        <source>one number per frame</source>
        <translation>eine Zahl je Bild</translation>
    </message>
    <message>
        <source>&apos;from&apos; is not below &apos;to&apos;</source>
        <translation>&apos;from&apos; ist nicht kleiner als &apos;to&apos;</translation>
    </message>
    <message>
        <source>an increasing range</source>
        <translation>ein aufsteigender Bereich</translation>
    </message>
    <message>
        <source>the folder cannot be read: {}</source>
        <translation>der Ordner lässt sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>ask its owner for access</source>
        <translation>seinen Besitzer um Zugriff bitten</translation>
    </message>
    <message>
        <source>the folder contains no images</source>
        <translation>der Ordner enthält keine Bilder</translation>
    </message>
    <message>
        <source>a folder with png, jpg, bmp, tif or pgm files</source>
        <translation>ein Ordner mit png-, jpg-, bmp-, tif- oder pgm-Dateien</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>{} changed from {} to {}</source>
        <translation>{} von {} auf {} geändert</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not describe a button</source>
        <translation>&apos;{}&apos; beschreibt keinen Taster</translation>
    </message>
    <message>
        <source>learn the button again</source>
        <translation>den Taster neu anlernen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not name a device and its button</source>
        <translation>&apos;{}&apos; nennt kein Gerät und dessen Taster</translation>
    </message>
    <message>
        <source>&apos;alltact devices --learn-button&apos;, which shows what to write here</source>
        <translation>&apos;alltact devices --learn-button&apos;, das zeigt, was hier stehen muss</translation>
    </message>
    <message>
        <source>learning the button was stopped</source>
        <translation>das Anlernen des Tasters wurde abgebrochen</translation>
    </message>
    <message>
        <source>press it now, twice</source>
        <translation>jetzt drücken, zweimal</translation>
    </message>
    <message>
        <source>press it once more</source>
        <translation>noch einmal drücken</translation>
    </message>
    <message>
        <source>no button was pressed and released twice</source>
        <translation>kein Taster wurde zweimal gedrückt und losgelassen</translation>
    </message>
    <message>
        <source>another device; a pedal that only clicks must be set to send a key</source>
        <translation>ein anderes Gerät; ein Pedal, das nur klickt, muss auf eine Taste eingestellt werden</translation>
    </message>
    <message>
        <source>the device cannot be opened</source>
        <translation>das Gerät lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>unplug it and plug it in again</source>
        <translation>abziehen und wieder einstecken</translation>
    </message>
    <message>
        <source>access to the device is not allowed</source>
        <translation>der Zugriff auf das Gerät ist nicht erlaubt</translation>
    </message>
    <message>
        <source>install packaging/70-alltact.rules in /etc/udev/rules.d and plug it in again; a device it does not name needs this line in it: KERNEL==&quot;hidraw*&quot;, ATTRS{{idVendor}}==&quot;{:04x}&quot;, ATTRS{{idProduct}}==&quot;{:04x}&quot;, TAG+=&quot;uaccess&quot;</source>
        <translation>packaging/70-alltact.rules in /etc/udev/rules.d einrichten und wieder einstecken; ein Gerät, das darin nicht genannt ist, braucht diese Zeile: KERNEL==&quot;hidraw*&quot;, ATTRS{{idVendor}}==&quot;{}&quot;, ATTRS{{idProduct}}==&quot;{}&quot;, TAG+=&quot;uaccess&quot;</translation>
    </message>
    <message>
        <source>the device was unplugged</source>
        <translation>das Gerät wurde abgezogen</translation>
    </message>
    <message>
        <source>plug it in again</source>
        <translation>wieder einstecken</translation>
    </message>
    <message>
        <source>the device refused the report</source>
        <translation>das Gerät nahm den Report nicht an</translation>
    </message>
    <message>
        <source>plug it in again, and check its description</source>
        <translation>wieder einstecken und die Beschreibung prüfen</translation>
    </message>
    <message>
        <source>no HID device was found</source>
        <translation>kein HID-Gerät wurde gefunden</translation>
    </message>
    <message>
        <source>there is no such HID device; available: {}</source>
        <translation>es gibt kein solches HID-Gerät; vorhanden: {}</translation>
    </message>
    <message>
        <source>plug it in; &apos;alltact devices&apos; lists what is found</source>
        <translation>einstecken; &apos;alltact devices&apos; zeigt, was gefunden wird</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not describe a dimmer</source>
        <translation>&apos;{}&apos; beschreibt keinen Dimmer</translation>
    </message>
    <message>
        <source>mcp2221a gp2, mcp2221a gp3, or a report such as &apos;output id=0 bytes=8 at=1 range=0..255&apos;</source>
        <translation>mcp2221a gp2, mcp2221a gp3, oder ein Report wie &apos;output id=0 bytes=8 at=1 range=0..255&apos;</translation>
    </message>
    <message>
        <source>the brightness {} is not from 0 to 1</source>
        <translation>die Helligkeit {} liegt nicht zwischen 0 und 1</translation>
    </message>
    <message>
        <source>the MCP2221A did not answer as expected</source>
        <translation>der MCP2221A antwortete nicht wie erwartet</translation>
    </message>
    <message>
        <source>plug it in again; close other programs that use it</source>
        <translation>wieder einstecken; andere Programme schließen, die ihn benutzen</translation>
    </message>
    <message>
        <source>this is neither an image, nor a folder of images, nor a video, nor a scene</source>
        <translation>dies ist weder ein Bild, noch ein Ordner mit Bildern, noch ein Video, noch eine Szene</translation>
    </message>
    <message>
        <source>video</source>
        <translation>Video</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>a {} cannot be mixed with other inputs</source>
        <translation>lässt sich nicht mit anderen Eingaben mischen: {}</translation>
    </message>
    <message>
        <source>it alone, or images only</source>
        <translation>dies allein oder nur Bilder</translation>
    </message>
    <message>
        <source>no input was given</source>
        <translation>es wurde keine Eingabe angegeben</translation>
    </message>
    <message>
        <source>specify an image, a folder of images, a video, a scene or a camera</source>
        <translation>ein Bild, einen Ordner mit Bildern, ein Video, eine Szene oder eine Kamera angeben</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>es gibt keine solche Datei und keinen solchen Ordner</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be read</source>
        <translation>&apos;{}&apos; lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be set to {}</source>
        <translation>&apos;{}&apos; lässt sich nicht auf {} stellen</translation>
    </message>
    <message>
        <source>the camera refuses this value</source>
        <translation>die Kamera lehnt diesen Wert ab</translation>
    </message>
    <message>
        <source>a value within its range; &apos;alltact devices --details&apos; lists the ranges</source>
        <translation>ein Wert in seinem Bereich; &apos;alltact devices --details&apos; zeigt die Bereiche</translation>
    </message>
    <message>
        <source>an automatic mode controls it</source>
        <translation>eine Automatik regelt es</translation>
    </message>
    <message>
        <source>switch that mode off first</source>
        <translation>diese Automatik zuerst ausschalten</translation>
    </message>
    <message>
        <source>the camera uses {} instead</source>
        <translation>die Kamera verwendet stattdessen {}</translation>
    </message>
    <message>
        <source>a value within its range and steps; &apos;alltact devices --details&apos; lists them</source>
        <translation>ein Wert in seinem Bereich und seinen Schritten; &apos;alltact devices --details&apos; zeigt sie</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be switched off: brightness may drift</source>
        <translation>&apos;{}&apos; lässt sich nicht ausschalten: Die Helligkeit kann driften</translation>
    </message>
    <message>
        <source>it sends its images in several planes, which is not supported</source>
        <translation>sie sendet ihre Bilder in mehreren Ebenen, was nicht unterstützt wird</translation>
    </message>
    <message>
        <source>a USB camera</source>
        <translation>eine USB-Kamera</translation>
    </message>
    <message>
        <source>it cannot stream</source>
        <translation>sie kann nicht streamen</translation>
    </message>
    <message>
        <source>it has no supported format</source>
        <translation>sie hat kein unterstütztes Format</translation>
    </message>
    <message>
        <source>a camera with MJPG or YUYV</source>
        <translation>eine Kamera mit MJPG oder YUYV</translation>
    </message>
    <message>
        <source>it cannot be used now</source>
        <translation>sie kann gerade nicht benutzt werden</translation>
    </message>
    <message>
        <source>the camera is not connected</source>
        <translation>die Kamera ist nicht angeschlossen</translation>
    </message>
    <message>
        <source>plug it in</source>
        <translation>einstecken</translation>
    </message>
    <message>
        <source>several cameras have this name: {}</source>
        <translation>mehrere Kameras haben diesen Namen: {}</translation>
    </message>
    <message>
        <source>the name before the brackets</source>
        <translation>der Name vor den Klammern</translation>
    </message>
    <message>
        <source>no camera was found</source>
        <translation>es wurde keine Kamera gefunden</translation>
    </message>
    <message>
        <source>there is no such camera; available: {}</source>
        <translation>es gibt keine solche Kamera; vorhanden: {}</translation>
    </message>
    <message>
        <source>plug one in; &apos;alltact devices&apos; lists what is found</source>
        <translation>eine einstecken; &apos;alltact devices&apos; zeigt, was gefunden wird</translation>
    </message>
    <message>
        <source>one of these names</source>
        <translation>einer dieser Namen</translation>
    </message>
    <message>
        <source>the camera has sent no image for a second</source>
        <translation>die Kamera hat seit einer Sekunde kein Bild gesendet</translation>
    </message>
    <message>
        <source>check the cable and the USB port</source>
        <translation>Kabel und USB-Anschluss prüfen</translation>
    </message>
    <message>
        <source>this device node delivers no readable images</source>
        <translation>dieser Geräteknoten liefert keine lesbaren Bilder</translation>
    </message>
    <message>
        <source>a camera that &apos;alltact devices&apos; lists as usable</source>
        <translation>eine Kamera, die &apos;alltact devices&apos; als brauchbar zeigt</translation>
    </message>
    <message>
        <source>the camera stopped sending images</source>
        <translation>die Kamera sendet keine Bilder mehr</translation>
    </message>
    <message>
        <source>no image arrived for {:.1f} seconds</source>
        <translation>seit {} Sekunden kam kein Bild an</translation>
    </message>
    <message>
        <source>check the cable and the USB port; the stream is being restarted</source>
        <translation>Kabel und USB-Anschluss prüfen; der Datenstrom wird neu gestartet</translation>
    </message>
    <message>
        <source>an image cannot be captured</source>
        <translation>ein Bild lässt sich nicht aufnehmen</translation>
    </message>
    <message>
        <source>Images arrive again</source>
        <translation>Es kommen wieder Bilder an</translation>
    </message>
    <message>
        <source>the camera is back and has not sent an image yet</source>
        <translation>die Kamera ist wieder da und hat noch kein Bild gesendet</translation>
    </message>
    <message>
        <source>The camera was plugged in again at {}</source>
        <translation>Die Kamera wurde wieder eingesteckt, an {}</translation>
    </message>
    <message>
        <source>the camera&apos;s signal changed: it sent {}, and sends {} now</source>
        <translation>das Signal der Kamera hat sich geändert: Sie sendete {} und sendet jetzt {}</translation>
    </message>
    <message>
        <source>check what is plugged into it, if this was not intended</source>
        <translation>prüfen, was an ihr angeschlossen ist, falls das nicht beabsichtigt war</translation>
    </message>
    <message>
        <source>the camera was unplugged</source>
        <translation>die Kamera wurde abgezogen</translation>
    </message>
    <message>
        <source>plug it in again; it continues by itself with the same settings</source>
        <translation>wieder einstecken; es geht mit denselben Einstellungen von selbst weiter</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was changed from {} to {} by something else</source>
        <translation>&apos;{}&apos; wurde von etwas anderem von {} auf {} geändert</translation>
    </message>
    <message>
        <source>it was restored</source>
        <translation>der Wert wurde wiederhergestellt</translation>
    </message>
    <message>
        <source>sudo usermod -aG video $USER, then log in again; or install packaging/70-alltact.rules in /etc/udev/rules.d and plug the camera in again</source>
        <translation>sudo usermod -aG video $USER, dann neu anmelden; oder packaging/70-alltact.rules in /etc/udev/rules.d einrichten und die Kamera wieder einstecken</translation>
    </message>
    <message>
        <source>another program is using it</source>
        <translation>ein anderes Programm benutzt sie</translation>
    </message>
    <message>
        <source>close that program (fuser -v /dev/video* names it)</source>
        <translation>dieses Programm schließen (fuser -v /dev/video* nennt es)</translation>
    </message>
    <message>
        <source>it is not connected</source>
        <translation>sie ist nicht angeschlossen</translation>
    </message>
    <message>
        <source>plug the camera in; &apos;alltact devices&apos; lists what is found</source>
        <translation>die Kamera einstecken; &apos;alltact devices&apos; zeigt, was gefunden wird</translation>
    </message>
    <message>
        <source>the USB port has no bandwidth left</source>
        <translation>der USB-Anschluss hat keine Bandbreite mehr</translation>
    </message>
    <message>
        <source>another USB port, MJPG instead of YUYV, or smaller images</source>
        <translation>ein anderer USB-Anschluss, MJPG statt YUYV oder kleinere Bilder</translation>
    </message>
    <message>
        <source>the USB connection is disturbed</source>
        <translation>die USB-Verbindung ist gestört</translation>
    </message>
    <message>
        <source>a shorter cable or another port</source>
        <translation>ein kürzeres Kabel oder ein anderer Anschluss</translation>
    </message>
    <message>
        <source>the camera refuses</source>
        <translation>die Kamera lehnt ab</translation>
    </message>
    <message>
        <source>another format or value; &apos;alltact devices --details&apos; lists them</source>
        <translation>ein anderes Format oder ein anderer Wert; &apos;alltact devices --details&apos; zeigt sie</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der Speicher reicht nicht</translation>
    </message>
    <message>
        <source>unplug the camera and plug it in again</source>
        <translation>die Kamera abziehen und wieder einstecken</translation>
    </message>
    <message>
        <source>{} and more</source>
        <translation>{} und weitere</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>{} at {:g} frames per second</source>
        <translation>{} mit {} Bildern je Sekunde</translation>
    </message>
    <message>
        <source>the camera has no such readable format; it offers {}</source>
        <translation>die Kamera hat kein solches lesbares Format; sie bietet {}</translation>
    </message>
    <message>
        <source>one of these in GREY, Y16, YUYV or MJPG</source>
        <translation>eines davon in GREY, Y16, YUYV oder MJPG</translation>
    </message>
    <message>
        <source>the camera cannot be opened</source>
        <translation>die Kamera lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>this does not answer like a camera</source>
        <translation>dies antwortet nicht wie eine Kamera</translation>
    </message>
    <message>
        <source>the camera&apos;s format cannot be set to {}</source>
        <translation>das Format der Kamera lässt sich nicht auf {} stellen</translation>
    </message>
    <message>
        <source>{} was requested, but the camera chose {}</source>
        <translation>{} war angefordert, aber die Kamera wählte {}</translation>
    </message>
    <message>
        <source>a format that &apos;alltact devices --details&apos; lists for it</source>
        <translation>ein Format, das &apos;alltact devices --details&apos; für sie zeigt</translation>
    </message>
    <message>
        <source>the camera&apos;s rate cannot be set</source>
        <translation>die Bildrate der Kamera lässt sich nicht einstellen</translation>
    </message>
    <message>
        <source>the camera accepts no buffer</source>
        <translation>die Kamera nimmt keinen Puffer an</translation>
    </message>
    <message>
        <source>the camera does not start</source>
        <translation>die Kamera startet nicht</translation>
    </message>
    <message>
        <source>the camera provides no buffers</source>
        <translation>die Kamera stellt keine Puffer bereit</translation>
    </message>
    <message>
        <source>the camera&apos;s buffer cannot be found</source>
        <translation>der Puffer der Kamera lässt sich nicht finden</translation>
    </message>
    <message>
        <source>the camera&apos;s buffer cannot be mapped</source>
        <translation>der Puffer der Kamera lässt sich nicht in den Speicher abbilden</translation>
    </message>
    <message>
        <source>holds more than one document</source>
        <translation>enthält mehr als ein Dokument</translation>
    </message>
    <message>
        <source>leave out the lines &apos;---&apos;</source>
        <translation>die Zeilen &apos;---&apos; weglassen</translation>
    </message>
    <message>
        <source>this is not YAML: {}</source>
        <translation>dies ist kein YAML: {}</translation>
    </message>
    <message>
        <source>check the brackets, quotes and the space before each key</source>
        <translation>Klammern, Anführungszeichen und den Leerraum vor jedem Schlüssel prüfen</translation>
    </message>
    <message>
        <source>is too large to be read</source>
        <translation>ist zu groß, um gelesen zu werden</translation>
    </message>
    <message>
        <source>a file with fewer entries</source>
        <translation>eine Datei mit weniger Einträgen</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;</source>
        <translation>unbekannter Schlüssel &apos;{}&apos;</translation>
    </message>
    <message>
        <source>is unknown, and too large or too unusual to be stored</source>
        <translation>ist unbekannt und zu groß oder zu ungewöhnlich, um gespeichert zu werden</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>entfernen</translation>
    </message>
    <message>
        <source>is not known here; it stays unchanged</source>
        <translation>ist hier nicht bekannt; es bleibt unverändert</translation>
    </message>
    <message>
        <source>&apos;{}&apos;</source>
        <translation>&apos;{}&apos;</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a block of keys</source>
        <translation>ein Block von Schlüsseln</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>above</source>
        <translation>über</translation>
    </message>
    <message>
        <source>from</source>
        <translation>ab</translation>
    </message>
    <message>
        <source>below</source>
        <translation>unter</translation>
    </message>
    <message>
        <source>up to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>a number {} {:g} and {} {:g}</source>
        <translation>eine Zahl {} {} und {} {}</translation>
    </message>
    <message>
        <source>a number such as 24.0, with a point and without a unit</source>
        <translation>eine Zahl wie 24.0, mit Punkt und ohne Einheit</translation>
    </message>
    <message>
        <source>must be a block of &apos;key: value&apos; lines, not {}</source>
        <translation>muss ein Block von Zeilen &apos;key: value&apos; sein, nicht {}</translation>
    </message>
    <message>
        <source>compare with another file of this kind</source>
        <translation>mit einer anderen Datei dieser Art vergleichen</translation>
    </message>
    <message>
        <source>holds a key that is not a word</source>
        <translation>enthält einen Schlüssel, der kein Wort ist</translation>
    </message>
    <message>
        <source>one word before each colon</source>
        <translation>ein Wort vor jedem Doppelpunkt</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>steht zweimal da</translation>
    </message>
    <message>
        <source>delete one of the two</source>
        <translation>eines der beiden löschen</translation>
    </message>
    <message>
        <source>add &apos;{}: ...&apos;</source>
        <translation>&apos;{}: ...&apos; hinzufügen</translation>
    </message>
    <message>
        <source>add &apos;{}: ...&apos; under &apos;{}:&apos;</source>
        <translation>&apos;{}: ...&apos; unter &apos;{}:&apos; hinzufügen</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>write &apos;{}&apos; instead of &apos;{}&apos;</source>
        <translation>&apos;{}&apos; statt &apos;{}&apos; schreiben</translation>
    </message>
    <message>
        <source>must be text, not {}</source>
        <translation>muss ein Text sein, nicht {}</translation>
    </message>
    <message>
        <source>{} is not known here</source>
        <translation>{} ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>must be a number, {}, not {}</source>
        <translation>muss eine Zahl sein, {}, nicht {}</translation>
    </message>
    <message>
        <source>0 means that it is absent; leave out what is absent</source>
        <translation>0 bedeutet, dass es fehlt; Fehlendes weglassen</translation>
    </message>
    <message>
        <source>leave it out, or enter {}</source>
        <translation>weglassen oder angeben: {}</translation>
    </message>
    <message>
        <source>holds {}, which is not {}</source>
        <translation>enthält {}; erlaubt ist: {}</translation>
    </message>
    <message>
        <source>must be {}, not {}</source>
        <translation>muss {} sein, nicht {}</translation>
    </message>
    <message>
        <source>must be an integer from {} to {}, not {}</source>
        <translation>muss eine ganze Zahl von {} bis {} sein, nicht {}</translation>
    </message>
    <message>
        <source>must be a list, not {}</source>
        <translation>muss eine Liste sein, nicht {}</translation>
    </message>
    <message>
        <source>[..., ...]</source>
        <translation>[..., ...]</translation>
    </message>
    <message>
        <source>this is not a list of the right length</source>
        <translation>dies ist keine Liste mit der richtigen Länge</translation>
    </message>
    <message>
        <source>[{} numbers]</source>
        <translation>[{} Zahlen]</translation>
    </message>
    <message>
        <source>[{} to {} numbers]</source>
        <translation>[{} bis {} Zahlen]</translation>
    </message>
    <message>
        <source>holds {}, which is not text</source>
        <translation>enthält {}, was kein Text ist</translation>
    </message>
    <message>
        <source>holds {}, which is not a list</source>
        <translation>enthält {}, was keine Liste ist</translation>
    </message>
    <message>
        <source>[[..., ...], ...]</source>
        <translation>[[..., ...], ...]</translation>
    </message>
    <message>
        <source>{}:{}: this line is not a check and is ignored.</source>
        <translation>{}:{}: Diese Zeile ist keine Prüfung und wird übergangen.</translation>
    </message>
    <message>
        <source>no untouched image; specify it with --reference to calibrate</source>
        <translation>kein unberührtes Bild; beim Kalibrieren eines mit --reference angeben</translation>
    </message>
    <message>
        <source>no recording of the untouched finger bending; run alltact reference</source>
        <translation>keine Aufnahme des unberührten Fingers beim Biegen; alltact reference ausführen</translation>
    </message>
    <message>
        <source>one untouched image</source>
        <translation>ein unberührtes Bild</translation>
    </message>
    <message>
        <source>only {} frames; poses between them are estimates, record more bending</source>
        <translation>nur {} Bilder; Haltungen dazwischen sind geschätzt, mehr Biegung aufnehmen</translation>
    </message>
    <message numerus="yes">
        <source>{} frames</source>
        <comment>{} frame</comment>
        <translation>
            <numerusform>{} Bild</numerusform>
            <numerusform>{} Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>no layout at rest, so contact cannot be detected; run alltact reference again</source>
        <translation>keine Anordnung in Ruhe, daher ist Kontakt nicht erkennbar; alltact reference noch einmal ausführen</translation>
    </message>
    <message>
        <source>none; the pose comes from the shape of the face, which hides twist</source>
        <translation>keine; die Haltung folgt aus der Form der Fläche, die keine Verdrehung zeigt</translation>
    </message>
    <message>
        <source>{} markers; contact is detected from {:.1f} px of summed offset</source>
        <translation>{} Marken; Kontakt wird ab {} px summierter Verschiebung erkannt</translation>
    </message>
    <message>
        <source>not calibrated; run alltact calibrate with ball presses</source>
        <translation>nicht kalibriert; alltact calibrate mit Kugeleindrücken ausführen</translation>
    </message>
    <message>
        <source>its origin and quality are not recorded; run alltact calibrate again</source>
        <translation>Herkunft und Güte sind nicht verzeichnet; alltact calibrate noch einmal ausführen</translation>
    </message>
    <message>
        <source>made on an unknown date</source>
        <translation>an einem unbekannten Tag erstellt</translation>
    </message>
    <message>
        <source>made {}</source>
        <translation>erstellt {}</translation>
    </message>
    <message>
        <source>the calibration cannot be repeated: {}.</source>
        <translation>die Kalibrierung lässt sich nicht wiederholen: {}.</translation>
    </message>
    <message>
        <source>{} of {} press images are missing, so the calibration cannot be repeated</source>
        <translation>{} von {} Eindruckbildern fehlen, daher lässt sich die Kalibrierung nicht wiederholen</translation>
    </message>
    <message>
        <source>the stored data is of an interrupted calibration; complete it with {}</source>
        <translation>die gespeicherten Daten stammen von einer abgebrochenen Kalibrierung; zu Ende führen mit {}</translation>
    </message>
    <message>
        <source>{} images stored</source>
        <translation>{} Bilder gespeichert</translation>
    </message>
    <message>
        <source>{}, {} x {} px</source>
        <translation>{}, {} x {} px</translation>
    </message>
    <message>
        <source>stopped before the check was done</source>
        <translation>vor dem Ende der Prüfung angehalten</translation>
    </message>
    <message>
        <source>{}: the contact covers too few pixels</source>
        <translation>{}: der Kontakt bedeckt zu wenige Pixel</translation>
    </message>
    <message>
        <source>pressing deeper, or a larger image</source>
        <translation>tiefer drücken oder ein größeres Bild</translation>
    </message>
    <message>
        <source>{}: no ball fits the contact</source>
        <translation>{}: keine Kugel passt zum Kontakt</translation>
    </message>
    <message>
        <source>a clean ball</source>
        <translation>eine saubere Kugel</translation>
    </message>
    <message>
        <source>{} {}</source>
        <translation>{} {}</translation>
    </message>
    <message>
        <source>no face was found</source>
        <translation>es wurde keine Fläche gefunden</translation>
    </message>
    <message>
        <source>the contacts are not ball-shaped: is the ball or face dirty?</source>
        <translation>die Kontakte sind nicht kugelförmig: Ist Kugel oder Fläche schmutzig?</translation>
    </message>
    <message>
        <source>shallow</source>
        <translation>flach</translation>
    </message>
    <message>
        <source>deep</source>
        <translation>tief</translation>
    </message>
    <message>
        <source>the mapping reads {:.0f} % too {}: layer, ball or camera have changed</source>
        <translation>die Abbildung misst {} % zu {}: Schicht, Kugel oder Kamera haben sich geändert</translation>
    </message>
    <message>
        <source>brighter</source>
        <translation>heller</translation>
    </message>
    <message>
        <source>darker</source>
        <translation>dunkler</translation>
    </message>
    <message>
        <source>the face is {:.1f} % {} than before: check lamps, exposure and layer</source>
        <translation>die Fläche ist {} % {} als zuvor: Lampen, Belichtung und Schicht prüfen</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>drifting</source>
        <translation>driftet</translation>
    </message>
    <message>
        <source>recalibrate</source>
        <translation>neu kalibrieren</translation>
    </message>
    <message>
        <source>calibrate again soon</source>
        <translation>bald neu kalibrieren</translation>
    </message>
    <message>
        <source>calibrate again before measuring with it</source>
        <translation>vor dem Messen neu kalibrieren</translation>
    </message>
    <message>
        <source>the finger is not calibrated, so there is nothing to check</source>
        <translation>der Finger ist nicht kalibriert, also gibt es nichts zu prüfen</translation>
    </message>
    <message>
        <source>alltact calibrate</source>
        <translation>alltact calibrate</translation>
    </message>
    <message>
        <source>the finger&apos;s data does not name its calibration ball</source>
        <translation>die Daten des Fingers nennen seine Kalibrierkugel nicht</translation>
    </message>
    <message>
        <source>--ball-radius-mm with the radius of the pressed ball</source>
        <translation>--ball-radius-mm mit dem Radius der eingedrückten Kugel</translation>
    </message>
    <message>
        <source>measuring the presses</source>
        <translation>Eindrücke werden gemessen</translation>
    </message>
    <message>
        <source>no press is named &apos;{}&apos;</source>
        <translation>kein Eindruck heißt &apos;{}&apos;</translation>
    </message>
    <message>
        <source>no press can be used: {}</source>
        <translation>kein Eindruck ist brauchbar: {}</translation>
    </message>
    <message>
        <source>images of this finger with the ball pressed 0.3 mm or more into its face</source>
        <translation>Bilder dieses Fingers, in dessen Fläche die Kugel 0,3 mm oder mehr gedrückt ist</translation>
    </message>
    <message>
        <source>measuring the presses of the calibration</source>
        <translation>Eindrücke der Kalibrierung werden gemessen</translation>
    </message>
    <message>
        <source>the face is {:.1f} % {} than in its reference; false depth {:.3f} mm in its worst 5 % ({:.3f} mm without light correction; up to {:.3f} mm is noise)</source>
        <translation>die Fläche ist {} % {} als in ihrer Referenz; falsche Tiefe {} mm in den schlechtesten 5 % ({} mm ohne Lichtkorrektur; bis {} mm ist Rauschen)</translation>
    </message>
    <message>
        <source>let the lamps warm up, check exposure and gain, and record the reference again if it persists</source>
        <translation>die Lampen warm werden lassen, Belichtung und Verstärkung prüfen und die Referenz neu aufnehmen, wenn es anhält</translation>
    </message>
    <message>
        <source>the finger is not calibrated yet</source>
        <translation>der Finger ist noch nicht kalibriert</translation>
    </message>
    <message>
        <source>calibrate with ball presses</source>
        <translation>mit Kugeleindrücken kalibrieren</translation>
    </message>
    <message>
        <source>nothing could be measured</source>
        <translation>es ließ sich nichts messen</translation>
    </message>
    <message>
        <source>none of the images can be compared with the reference</source>
        <translation>keines der Bilder lässt sich mit der Referenz vergleichen</translation>
    </message>
    <message>
        <source>{} ({})</source>
        <translation>{} ({})</translation>
    </message>
    <message>
        <source>images of the untouched finger in recorded poses</source>
        <translation>Bilder des unberührten Fingers in aufgenommenen Haltungen</translation>
    </message>
    <message>
        <source>an orthographic camera</source>
        <translation>eine orthografische Kamera</translation>
    </message>
    <message>
        <source>a camera behind a window</source>
        <translation>eine Kamera hinter einem Fenster</translation>
    </message>
    <message>
        <source>{} has no camera matrix, so {} cannot describe it</source>
        <translation>{} hat keine Kameramatrix, daher kann {} sie nicht beschreiben</translation>
    </message>
    <message>
        <source>json, or zip for the entire finger</source>
        <translation>json, oder zip für den ganzen Finger</translation>
    </message>
    <message>
        <source>is a link to another folder, which a zip cannot hold</source>
        <translation>ist ein Verweis auf einen anderen Ordner, den ein Zip nicht enthalten kann</translation>
    </message>
    <message>
        <source>is neither a file nor a folder, so a zip cannot hold it</source>
        <translation>ist weder Datei noch Ordner, darum kann ein Zip es nicht enthalten</translation>
    </message>
    <message>
        <source>moving it out of the finger&apos;s folder</source>
        <translation>es aus dem Ordner des Fingers nehmen</translation>
    </message>
    <message>
        <source>the finger&apos;s folder could not be read: {}</source>
        <translation>der Ordner des Fingers ließ sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>check its permissions, and that its disk is connected</source>
        <translation>seine Rechte prüfen und ob sein Datenträger angeschlossen ist</translation>
    </message>
    <message>
        <source>a zip of the finger cannot be in the finger&apos;s own folder</source>
        <translation>ein Zip des Fingers kann nicht im Ordner des Fingers selbst liegen</translation>
    </message>
    <message>
        <source>another folder</source>
        <translation>ein anderer Ordner</translation>
    </message>
    <message>
        <source>stopped before it was written</source>
        <translation>vor dem Ende des Schreibens angehalten</translation>
    </message>
    <message>
        <source>The finger&apos;s reference has changed since its calibration: this is a new calibration.</source>
        <translation>Die Referenz des Fingers hat sich seit seiner Kalibrierung geändert: Dies ist eine neue Kalibrierung.</translation>
    </message>
    <message>
        <source>The finger&apos;s camera, face or markers have changed since its calibration: this is a new calibration.</source>
        <translation>Kamera, Fläche oder Marken des Fingers haben sich seit seiner Kalibrierung geändert: Dies ist eine neue Kalibrierung.</translation>
    </message>
    <message>
        <source>The finger was calibrated by version {}: this is a new calibration, by version {}.</source>
        <translation>Der Finger wurde mit Version {} kalibriert: Dies ist eine neue Kalibrierung, mit Version {}.</translation>
    </message>
    <message>
        <source>writing the report</source>
        <translation>Bericht wird geschrieben</translation>
    </message>
    <message>
        <source>its camera, face or markers were changed while it was calibrated</source>
        <translation>Kamera, Fläche oder Marken wurden während der Kalibrierung geändert</translation>
    </message>
    <message>
        <source>calibrating again</source>
        <translation>neu kalibrieren</translation>
    </message>
    <message>
        <source>only a flat sensor has a single untouched image</source>
        <translation>nur ein flacher Sensor hat ein einziges unberührtes Bild</translation>
    </message>
    <message>
        <source>leaving --reference out; this finger is compared with its reference recording</source>
        <translation>--reference weglassen; dieser Finger wird mit seiner Referenzaufnahme verglichen</translation>
    </message>
    <message>
        <source>{} shows what was found</source>
        <translation>{} zeigt, was gefunden wurde</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>is not a checksum of 16 digits</source>
        <translation>ist keine Prüfsumme aus 16 Ziffern</translation>
    </message>
    <message>
        <source>lists no press</source>
        <translation>führt keinen Eindruck auf</translation>
    </message>
    <message>
        <source>has {} entries for {} presses</source>
        <translation>hat {} Einträge für {} Eindrücke</translation>
    </message>
    <message>
        <source>one for each press</source>
        <translation>einer für jeden Eindruck</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not an image name</source>
        <translation>&apos;{}&apos; ist kein Bildname</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a checksum of 16 digits</source>
        <translation>&apos;{}&apos; ist keine Prüfsumme aus 16 Ziffern</translation>
    </message>
    <message>
        <source>lists &apos;{}&apos; twice</source>
        <translation>führt &apos;{}&apos; zweimal auf</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is annotated, but is not among the presses</source>
        <translation>&apos;{}&apos; hat eine Anmerkung, ist aber nicht unter den Eindrücken</translation>
    </message>
    <message>
        <source>remove the annotation</source>
        <translation>die Anmerkung entfernen</translation>
    </message>
    <message>
        <source>the version of this program that wrote it, or calibrating again with the images in presses/ (this version writes &apos;{}&apos;)</source>
        <translation>die Programmversion, die es schrieb, oder mit den Bildern in presses/ neu kalibrieren (diese Version schreibt &apos;{}&apos;)</translation>
    </message>
    <message>
        <source>there is nothing to repeat: this finger is not calibrated, or by a version that did not store its data</source>
        <translation>es gibt nichts zu wiederholen: Dieser Finger ist nicht kalibriert, oder von einer Version, die ihre Daten nicht speicherte</translation>
    </message>
    <message>
        <source>calibrating it with the images in presses/ and --ball-radius-mm</source>
        <translation>ihn mit den Bildern in presses/ und --ball-radius-mm kalibrieren</translation>
    </message>
    <message>
        <source>{:.3f} mm, more than three times the others; check the image, or leave it out</source>
        <translation>{} mm, mehr als das Dreifache der anderen; das Bild prüfen oder den Eindruck weglassen</translation>
    </message>
    <message>
        <source>leaving them out, or --method joint</source>
        <translation>sie weglassen oder --method joint</translation>
    </message>
    <message>
        <source>no press can be used</source>
        <translation>kein Eindruck ist brauchbar</translation>
    </message>
    <message>
        <source>images of this finger with a ball pressed into its face</source>
        <translation>Bilder dieses Fingers, in dessen Fläche eine Kugel gedrückt ist</translation>
    </message>
    <message>
        <source>solving</source>
        <translation>wird gelöst</translation>
    </message>
    <message>
        <source>stopped early: this is the best solution so far, without a report; calibrate again from the stored data to finish it</source>
        <translation>vorzeitig angehalten: Dies ist die beste Lösung bis dahin, ohne Bericht; zum Abschließen aus den gespeicherten Daten neu kalibrieren</translation>
    </message>
    <message>
        <source>comparing with other methods</source>
        <translation>Vergleich mit anderen Verfahren</translation>
    </message>
    <message>
        <source>stopped before the calibration was done</source>
        <translation>vor dem Ende der Kalibrierung angehalten</translation>
    </message>
    <message>
        <source>the reference image</source>
        <translation>das Referenzbild</translation>
    </message>
    <message>
        <source>the untouched image of this sensor, at the size of its presses</source>
        <translation>das unberührte Bild dieses Sensors, in der Größe seiner Eindrücke</translation>
    </message>
    <message>
        <source>this is not the image that the finger was calibrated with</source>
        <translation>dies ist nicht das Bild, mit dem der Finger kalibriert wurde</translation>
    </message>
    <message>
        <source>calibrating again with the existing images</source>
        <translation>mit den vorhandenen Bildern neu kalibrieren</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>or --bursts where each video shows one press held still</source>
        <translation>oder --bursts, wo jedes Video einen stillgehaltenen Eindruck zeigt</translation>
    </message>
    <message>
        <source>two presses are called &apos;{}&apos;</source>
        <translation>zwei Eindrücke heißen &apos;{}&apos;</translation>
    </message>
    <message>
        <source>giving the images different names; they are stored by name with the finger</source>
        <translation>den Bildern verschiedene Namen geben; sie werden beim Finger unter ihrem Namen gespeichert</translation>
    </message>
    <message>
        <source>reading {}</source>
        <translation>{} wird gelesen</translation>
    </message>
    <message>
        <source>no press was given</source>
        <translation>es wurde kein Eindruck angegeben</translation>
    </message>
    <message>
        <source>at least one image of a pressed ball</source>
        <translation>mindestens ein Bild einer eingedrückten Kugel</translation>
    </message>
    <message>
        <source>none of {} presses could be used: {}</source>
        <translation>keiner von {} Eindrücken war brauchbar: {}</translation>
    </message>
    <message>
        <source>images in which the ball, and nothing else, is pressed 0.3 mm or more into the face</source>
        <translation>Bilder, auf denen nur die Kugel 0,3 mm oder mehr in die Fläche gedrückt ist</translation>
    </message>
    <message>
        <source>stopped before there was a solution</source>
        <translation>angehalten, bevor es eine Lösung gab</translation>
    </message>
    <message>
        <source>the ball is {:.1f} mm deep in a layer of {:g} mm</source>
        <translation>die Kugel ist {} mm tief in einer Schicht von {} mm</translation>
    </message>
    <message>
        <source>pressing less deep, and checking the ball&apos;s radius and the camera&apos;s scale in mm per px</source>
        <translation>weniger tief drücken und den Radius der Kugel und den Maßstab der Kamera in mm je px prüfen</translation>
    </message>
    <message>
        <source>no increasing mapping fits the presses</source>
        <translation>keine steigende Abbildung passt zu den Eindrücken</translation>
    </message>
    <message>
        <source>leaving out presses with the largest residual, a lower degree, or checking the ball&apos;s radius</source>
        <translation>Eindrücke mit dem größten Restfehler weglassen, ein kleinerer Grad, oder den Radius der Kugel prüfen</translation>
    </message>
    <message>
        <source>solving: round {}</source>
        <translation>Lösen: Runde {}</translation>
    </message>
    <message>
        <source>solving all presses together</source>
        <translation>alle Eindrücke werden gemeinsam gelöst</translation>
    </message>
    <message>
        <source>{}, because the {} does not increase on all samples</source>
        <translation>{}, weil dies nicht auf allen Messpunkten steigt: {}</translation>
    </message>
    <message>
        <source>the solution is not a valid mapping: {}</source>
        <translation>die Lösung ist keine gültige Abbildung: {}</translation>
    </message>
    <message>
        <source>more presses of different depth, or a lower degree</source>
        <translation>mehr Eindrücke verschiedener Tiefe, oder ein kleinerer Grad</translation>
    </message>
    <message>
        <source>the balls would be {:.2f} mm deep in a layer of {:.2f} mm</source>
        <translation>die Kugeln lägen {:.2f} mm tief in einer {:.2f} mm dicken Schicht</translation>
    </message>
    <message>
        <source>checking the layer&apos;s thickness and the ball&apos;s radius, or more presses</source>
        <translation>die Dicke der Schicht und den Radius der Kugel prüfen, oder mehr Eindrücke</translation>
    </message>
    <message>
        <source>one press cannot separate the ball&apos;s depth from the mapping: add presses of different depth at other positions</source>
        <translation>ein Eindruck kann die Tiefe der Kugel nicht von der Abbildung trennen: Eindrücke verschiedener Tiefe an anderen Stellen hinzufügen</translation>
    </message>
    <message>
        <source>the presses do not determine every unknown: add presses</source>
        <translation>die Eindrücke bestimmen nicht jede Unbekannte: Eindrücke hinzufügen</translation>
    </message>
    <message>
        <source>a ball radius of {} mm is impossible</source>
        <translation>ein Kugelradius von {} mm ist unmöglich</translation>
    </message>
    <message>
        <source>the radius in millimetres, as measured with callipers</source>
        <translation>der Radius in Millimetern, mit dem Messschieber gemessen</translation>
    </message>
    <message>
        <source>the calibration failed: {}</source>
        <translation>die Kalibrierung scheiterte: {}</translation>
    </message>
    <message>
        <source>fewer presses</source>
        <translation>weniger Eindrücke</translation>
    </message>
    <message>
        <source>how presses become a mapping: all balls and the mapping in one fit; or, for comparison, every ball from its dark border alone: by the source paper, as a circle on the face, or as the cone of the ball&apos;s outline</source>
        <translation>wie Eindrücke zu einer Abbildung werden: alle Kugeln und die Abbildung in einer Anpassung; oder zum Vergleich jede Kugel nur aus ihrem dunklen Rand: nach der Veröffentlichung, als Kreis auf der Fläche oder als Kegel des Kugelumrisses</translation>
    </message>
    <message>
        <source>the mapping&apos;s curve; auto: whichever best predicts presses left out</source>
        <translation>die Kurve der Abbildung; auto: diejenige, die ausgelassene Eindrücke am besten vorhersagt</translation>
    </message>
    <message>
        <source>degree of the polynomial; 0: chosen by leaving presses out</source>
        <translation>Grad des Polynoms; 0: durch Auslassen von Eindrücken gewählt</translation>
    </message>
    <message>
        <source>the thickness of the layer that brightness follows: along z, along its normal, or that along z projected onto the normal; auto: along the normal unless presses left out show otherwise</source>
        <translation>die Dicke der Schicht, der die Helligkeit folgt: längs z, längs ihrer Normalen oder die längs z, auf die Normale projiziert; auto: längs der Normalen, wenn ausgelassene Eindrücke nichts anderes zeigen</translation>
    </message>
    <message>
        <source>whether the mapping may vary slowly over the face, for uneven light or an uneven layer; auto: if presses left out then agree clearly better</source>
        <translation>ob die Abbildung sich langsam über die Fläche ändern darf, bei ungleichmäßigem Licht oder ungleichmäßiger Schicht; auto: wenn ausgelassene Eindrücke dann deutlich besser passen</translation>
    </message>
    <message>
        <source>the inner {:.0f} % of each contact&apos;s radius was used, where the skin touches the ball</source>
        <translation>verwendet wurden die inneren {} % des Radius jedes Kontakts, wo die Haut die Kugel berührt</translation>
    </message>
    <message>
        <source>the inner {:.0f} % of each contact&apos;s radius was used; the skin leaves the ball over {:.2f} mm</source>
        <translation>verwendet wurden die inneren {} % des Radius jedes Kontakts; die Haut löst sich über {} mm von der Kugel</translation>
    </message>
    <message>
        <source>polynomial of degree {}</source>
        <translation>Polynom vom Grad {}</translation>
    </message>
    <message>
        <source>Kubelka-Munk curve</source>
        <translation>Kubelka-Munk-Kurve</translation>
    </message>
    <message>
        <source>Moebius curve</source>
        <translation>Möbius-Kurve</translation>
    </message>
    <message>
        <source>{} that varies over the face</source>
        <translation>{}, über die Fläche veränderlich</translation>
    </message>
    <message>
        <source>its measured depth of {:.3f} +- {:.3f} mm was left out, because the images show {:.3f} +- {:.3f} mm; depth counts from the ball&apos;s first contact, normal to the face</source>
        <translation>seine gemessene Tiefe von {} +- {} mm wurde weggelassen, denn die Bilder ergeben {} +- {} mm; die Tiefe zählt vom ersten Kontakt der Kugel an, senkrecht zur Fläche</translation>
    </message>
    <message>
        <source>its step of {:.3f} mm was left out, because the balls show {:.3f} +- {:.3f} mm; check the balls&apos; radius</source>
        <translation>seine Stufe von {} mm wurde weggelassen, denn die Kugeln ergeben {} +- {} mm; den Radius der Kugeln prüfen</translation>
    </message>
    <message>
        <source>trying a {}</source>
        <translation>wird versucht: {}</translation>
    </message>
    <message>
        <source>smallest error on presses left out, {:.4f} mm</source>
        <translation>kleinster Fehler bei ausgelassenen Eindrücken, {} mm</translation>
    </message>
    <message>
        <source>{:.4f} mm on presses left out, not distinguishable from the best ({}, {:.4f} mm) and simpler</source>
        <translation>{} mm bei ausgelassenen Eindrücken, vom besten nicht zu unterscheiden ({}, {} mm) und einfacher</translation>
    </message>
    <message>
        <source>a single press cannot be left out</source>
        <translation>ein einzelner Eindruck lässt sich nicht auslassen</translation>
    </message>
    <message>
        <source>as requested</source>
        <translation>wie angefordert</translation>
    </message>
    <message>
        <source>the mapping varies over the face, as with uneven light or layer: by {:+.0f} % from the presses nearest the base to those nearest the tip, by {:+.0f} % from side to side; error on presses left out {:.4f} mm, against {:.4f} mm with one mapping for all</source>
        <translation>die Abbildung ändert sich über die Fläche, wie bei ungleichmäßigem Licht oder ungleichmäßiger Schicht: um {} % von den Eindrücken nahe dem Fuß zu denen nahe der Spitze, um {} % von Seite zu Seite; Fehler bei ausgelassenen Eindrücken {} mm, gegen {} mm mit einer Abbildung für alle</translation>
    </message>
    <message>
        <source>no circle goes through the dark border</source>
        <translation>kein Kreis geht durch den dunklen Rand</translation>
    </message>
    <message>
        <source>the circle&apos;s centre is off the face</source>
        <translation>der Mittelpunkt des Kreises liegt außerhalb der Fläche</translation>
    </message>
    <message>
        <source>the circle is off the face</source>
        <translation>der Kreis liegt außerhalb der Fläche</translation>
    </message>
    <message>
        <source>the circle is larger than the ball</source>
        <translation>der Kreis ist größer als die Kugel</translation>
    </message>
    <message>
        <source>{:.0f} degrees of the ball&apos;s outline are visible, a cone needs {:.0f}; the rest of the dark border is where the skin leaves the ball</source>
        <translation>vom Umriss der Kugel sind {} Grad zu sehen, ein Kegel braucht {}; der übrige dunkle Rand ist dort, wo die Haut die Kugel verlässt</translation>
    </message>
    <message>
        <source>no cone touches the outline</source>
        <translation>kein Kegel berührt den Umriss</translation>
    </message>
    <message>
        <source>the ball that follows from the dark border hardly touches the face</source>
        <translation>die Kugel, die aus dem dunklen Rand folgt, berührt die Fläche kaum</translation>
    </message>
    <message>
        <source>no ball follows from the dark border of any of {} presses ({})</source>
        <translation>aus dem dunklen Rand folgt bei keinem von {} Eindrücken eine Kugel ({})</translation>
    </message>
    <message>
        <source>the joint method, which fits the ball itself</source>
        <translation>das gemeinsame Verfahren, das die Kugel selbst anpasst</translation>
    </message>
    <message>
        <source>the polynomial through the balls&apos; depths does not increase</source>
        <translation>das Polynom durch die Tiefen der Kugeln steigt nicht</translation>
    </message>
    <message>
        <source>the joint method, or more presses of different depth</source>
        <translation>das gemeinsame Verfahren oder mehr Eindrücke verschiedener Tiefe</translation>
    </message>
    <message>
        <source>the cubic does not increase; degree {} was used instead</source>
        <translation>die kubische Kurve steigt nicht; stattdessen wurde Grad {} verwendet</translation>
    </message>
    <message>
        <source>the source paper&apos;s</source>
        <translation>das der Veröffentlichung</translation>
    </message>
    <message>
        <source>{}, instead of the paper&apos;s cubic</source>
        <translation>{}, anstelle der kubischen Kurve der Veröffentlichung</translation>
    </message>
    <message>
        <source>in the middle of the face</source>
        <translation>in der Mitte der Fläche</translation>
    </message>
    <message>
        <source>{:.0f} mm from the middle on the {} side</source>
        <translation>{} mm von der Mitte, Seite {}</translation>
    </message>
    <message>
        <source>{:.0f} mm from the base, {}</source>
        <translation>{} mm vom Fuß, {}</translation>
    </message>
    <message>
        <source>the scale is least certain: all depths may be too large or too small together, by {:.3f} mm at {:.2f} mm (one standard deviation)</source>
        <translation>am unsichersten ist der Maßstab: Alle Tiefen können gemeinsam zu groß oder zu klein sein, um {} mm bei {} mm (eine Standardabweichung)</translation>
    </message>
    <message>
        <source>the relation of shallow to deep is least certain: by {:.3f} mm at {:.2f} mm (one standard deviation), with opposite sign at the other end</source>
        <translation>am unsichersten ist das Verhältnis von flach zu tief: um {} mm bei {} mm (eine Standardabweichung), mit umgekehrtem Vorzeichen am anderen Ende</translation>
    </message>
    <message>
        <source>smaller</source>
        <translation>kleiner</translation>
    </message>
    <message>
        <source>larger</source>
        <translation>größer</translation>
    </message>
    <message>
        <source>a ball 1 % larger than given makes depths {:.1f} % {}; the residual is {:.4f} mm with a radius 1 % smaller, {:.4f} mm as given, {:.4f} mm with one 1 % larger</source>
        <translation>eine um 1 % größere Kugel als angegeben macht Tiefen {} % {}; der Restfehler ist {} mm mit einem 1 % kleineren Radius, {} mm wie angegeben, {} mm mit einem 1 % größeren</translation>
    </message>
    <message>
        <source>a wrong radius would be noticed</source>
        <translation>ein falscher Radius würde auffallen</translation>
    </message>
    <message>
        <source>the presses cannot show a wrong radius, so measure the ball to a hundredth of a millimetre</source>
        <translation>die Eindrücke können einen falschen Radius nicht zeigen, darum die Kugel auf ein hundertstel Millimeter messen</translation>
    </message>
    <message>
        <source>press next: at another position, 0.5 to 1 mm deep</source>
        <translation>als Nächstes drücken: an einer anderen Stelle, 0,5 bis 1 mm tief</translation>
    </message>
    <message>
        <source>press next: {}, {:.1f} mm deep; no press shows whether the mapping holds in that third</source>
        <translation>als Nächstes drücken: {}, {} mm tief; kein Eindruck zeigt, ob die Abbildung in diesem Drittel gilt</translation>
    </message>
    <message>
        <source>enough: another press would reduce the standard deviation of depth from {:.4f} mm to {:.4f} mm at best</source>
        <translation>genug: Ein weiterer Eindruck würde die Standardabweichung der Tiefe bestenfalls von {} mm auf {} mm senken</translation>
    </message>
    <message>
        <source>press next: {}, {:.1f} mm deep; that would reduce the standard deviation of depth from {:.4f} mm to {:.4f} mm</source>
        <translation>als Nächstes drücken: {}, {} mm tief; Standardabweichung der Tiefe {} → {} mm</translation>
    </message>
    <message>
        <source>looking for the ball in {}</source>
        <translation>Kugel in {} wird gesucht</translation>
    </message>
    <message>
        <source>the same image as {}, counted once</source>
        <translation>dasselbe Bild wie {}, einmal gezählt</translation>
    </message>
    <message>
        <source>the contact covers too few pixels</source>
        <translation>der Kontakt bedeckt zu wenige Pixel</translation>
    </message>
    <message>
        <source>pressing the punch in until the skin rests on both of its levels, each 4 mm wide or more</source>
        <translation>den Stempel eindrücken, bis die Haut auf seinen beiden Ebenen aufliegt, jede mindestens 4 mm breit</translation>
    </message>
    <message>
        <source>the punch touches too little of the face</source>
        <translation>der Stempel berührt zu wenig von der Fläche</translation>
    </message>
    <message>
        <source>no step is visible</source>
        <translation>es ist keine Stufe zu sehen</translation>
    </message>
    <message>
        <source>one of the punch&apos;s levels touches too little of the face</source>
        <translation>eine der Ebenen des Stempels berührt zu wenig von der Fläche</translation>
    </message>
    <message>
        <source>along z</source>
        <translation>längs z</translation>
    </message>
    <message>
        <source>along z projected onto its normal</source>
        <translation>längs z, auf ihre Normale projiziert</translation>
    </message>
    <message>
        <source>brightness follows the layer&apos;s thickness {}: error on presses left out {:.4f} mm, against {:.4f} mm along its normal</source>
        <translation>die Helligkeit folgt der Dicke der Schicht {}: Fehler bei ausgelassenen Eindrücken {} mm, gegen {} mm längs ihrer Normalen</translation>
    </message>
    <message>
        <source>unfit for measuring</source>
        <translation>zum Messen nicht geeignet</translation>
    </message>
    <message>
        <source>press again with a clean ball of the given radius, entirely on the face</source>
        <translation>neu drücken, mit einer sauberen Kugel des angegebenen Radius, ganz auf der Fläche</translation>
    </message>
    <message>
        <source>unproven</source>
        <translation>unbewiesen</translation>
    </message>
    <message>
        <source>usable for contact and its position</source>
        <translation>für Kontakt und seine Position brauchbar</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>dots</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>inner corners</source>
        <translation>innere Ecken</translation>
    </message>
    <message>
        <source>{} x {} {}</source>
        <translation>{} x {} {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a board; it needs two counts from 3 to 100</source>
        <translation>&apos;{}&apos; ist keine Tafel; nötig sind zwei Anzahlen von 3 bis 100</translation>
    </message>
    <message>
        <source>9x6 for nine inner corners in a row and six rows</source>
        <translation>9x6 für neun innere Ecken in einer Zeile und sechs Zeilen</translation>
    </message>
    <message>
        <source>the search for the board failed: {}</source>
        <translation>die Suche nach der Tafel ist gescheitert: {}</translation>
    </message>
    <message>
        <source>another image</source>
        <translation>ein anderes Bild</translation>
    </message>
    <message>
        <source>only {} different views of the board are left; at least {} are needed</source>
        <translation>nur {} verschiedene Ansichten der Tafel sind übrig; mindestens {} sind nötig</translation>
    </message>
    <message>
        <source>{} images or more, with the board tilted and in all parts of the image</source>
        <translation>{} Bilder oder mehr, mit geneigter Tafel und in allen Teilen des Bildes</translation>
    </message>
    <message>
        <source>shows the board exactly where {} shows it</source>
        <translation>zeigt die Tafel genau dort, wo {} sie zeigt</translation>
    </message>
    <message>
        <source>no flat board can look like this</source>
        <translation>so kann keine flache Tafel aussehen</translation>
    </message>
    <message>
        <source>stopped before the lens was estimated</source>
        <translation>angehalten, bevor das Objektiv bestimmt war</translation>
    </message>
    <message>
        <source>views that reach into the image&apos;s corners, or another --model</source>
        <translation>Ansichten, die in die Ecken des Bildes reichen, oder ein anderes --model</translation>
    </message>
    <message>
        <source>leaving views out</source>
        <translation>Ansichten werden ausgelassen</translation>
    </message>
    <message>
        <source>comparing halves</source>
        <translation>Hälften werden verglichen</translation>
    </message>
    <message>
        <source>with {} distortion coefficients the lens folds over inside the image or stays undetermined; {} are used</source>
        <translation>mit {} Verzeichnungskoeffizienten faltet sich das Objektiv im Bild oder bleibt unbestimmt; {} werden verwendet</translation>
    </message>
    <message>
        <source>corners scatter by {:.2f} px; good boards give 0.2 or less: check focus, motion, and whether the board is flat</source>
        <translation>die Ecken streuen um {} px; gute Tafeln ergeben 0,2 oder weniger: Schärfe, Bewegung und Ebenheit der Tafel prüfen</translation>
    </message>
    <message>
        <source>stopped before everything was evaluated</source>
        <translation>angehalten, bevor alles ausgewertet war</translation>
    </message>
    <message>
        <source>Pattern printed on the board</source>
        <translation>Auf die Tafel gedrucktes Muster</translation>
    </message>
    <message>
        <source>brown up to about 120 degrees of view, fisheye beyond</source>
        <translation>brown bis etwa 120 Grad Bildwinkel, darüber fisheye</translation>
    </message>
    <message>
        <source>Distance of the finger, for errors in mm</source>
        <translation>Abstand des Fingers, für Fehlerangaben in mm</translation>
    </message>
    <message>
        <source>ChArUco: a marker&apos;s side as a fraction of a square&apos;s</source>
        <translation>ChArUco: Seite eines Markers als Bruchteil der Seite eines Quadrats</translation>
    </message>
    <message>
        <source>all {} views show the board in the same position</source>
        <translation>alle {} Ansichten zeigen die Tafel an derselben Position</translation>
    </message>
    <message>
        <source>move and tilt the board, or the camera, between images</source>
        <translation>Tafel oder Kamera zwischen den Bildern bewegen und neigen</translation>
    </message>
    <message>
        <source>estimating a first lens</source>
        <translation>ein erstes Objektiv wird geschätzt</translation>
    </message>
    <message>
        <source>fitting the lens</source>
        <translation>das Objektiv wird angepasst</translation>
    </message>
    <message>
        <source>no {} with {} is visible</source>
        <translation>nicht zu sehen: {} mit {}</translation>
    </message>
    <message>
        <source>the image has hardly any contrast</source>
        <translation>das Bild hat kaum Kontrast</translation>
    </message>
    <message>
        <source>more light, and the board in focus</source>
        <translation>mehr Licht, und die Tafel scharf</translation>
    </message>
    <message>
        <source>a large part of the image is white without detail</source>
        <translation>ein großer Teil des Bildes ist weiß, ohne Details</translation>
    </message>
    <message>
        <source>a shorter exposure</source>
        <translation>eine kürzere Belichtung</translation>
    </message>
    <message>
        <source>the entire board in the image, with its white border, sharp and evenly lit</source>
        <translation>die ganze Tafel im Bild, mit ihrem weißen Rand, scharf und gleichmäßig beleuchtet</translation>
    </message>
    <message>
        <source>chessboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>ChArUco-Tafel</translation>
    </message>
    <message>
        <source>not one of its markers</source>
        <translation>keine einzige ihrer Marken</translation>
    </message>
    <message>
        <source>more of the board in the image, sharp and evenly lit</source>
        <translation>mehr von der Tafel im Bild, scharf und gleichmäßig beleuchtet</translation>
    </message>
    <message>
        <source>more of the board in the image</source>
        <translation>mehr von der Tafel im Bild</translation>
    </message>
    <message>
        <source>dot grid</source>
        <translation>Punktraster</translation>
    </message>
    <message>
        <source>a dot of the grid is at the image border or has no contrast</source>
        <translation>ein Punkt des Rasters liegt am Bildrand oder hat keinen Kontrast</translation>
    </message>
    <message>
        <source>the entire board in the image, evenly lit</source>
        <translation>die ganze Tafel im Bild, gleichmäßig beleuchtet</translation>
    </message>
    <message>
        <source>top left corner</source>
        <translation>Ecke oben links</translation>
    </message>
    <message>
        <source>top edge</source>
        <translation>oberer Rand</translation>
    </message>
    <message>
        <source>top right corner</source>
        <translation>Ecke oben rechts</translation>
    </message>
    <message>
        <source>left edge</source>
        <translation>linker Rand</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>right edge</source>
        <translation>rechter Rand</translation>
    </message>
    <message>
        <source>bottom left corner</source>
        <translation>Ecke unten links</translation>
    </message>
    <message>
        <source>bottom edge</source>
        <translation>unterer Rand</translation>
    </message>
    <message>
        <source>bottom right corner</source>
        <translation>Ecke unten rechts</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} und {}</translation>
    </message>
    <message>
        <source>one</source>
        <translation>eine</translation>
    </message>
    <message>
        <source>two</source>
        <translation>zwei</translation>
    </message>
    <message>
        <source>three</source>
        <translation>drei</translation>
    </message>
    <message>
        <source>four</source>
        <translation>vier</translation>
    </message>
    <message>
        <source>five</source>
        <translation>fünf</translation>
    </message>
    <message>
        <source>six</source>
        <translation>sechs</translation>
    </message>
    <message>
        <source>seven</source>
        <translation>sieben</translation>
    </message>
    <message>
        <source>eight</source>
        <translation>acht</translation>
    </message>
    <message>
        <source>nine</source>
        <translation>neun</translation>
    </message>
    <message>
        <source>ten</source>
        <translation>zehn</translation>
    </message>
    <message>
        <source>{} more, tilted {}</source>
        <translation>noch {}, geneigt {}</translation>
    </message>
    <message>
        <source>{} more, tilted</source>
        <translation>noch {}, geneigt</translation>
    </message>
    <message>
        <source>large enough to fill the image</source>
        <translation>groß genug, das Bild zu füllen</translation>
    </message>
    <message>
        <source>near the {}</source>
        <translation>nahe: {}</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>down</source>
        <translation>nach unten</translation>
    </message>
    <message>
        <source>these views leave the lens undetermined</source>
        <translation>diese Ansichten bestimmen das Objektiv nicht</translation>
    </message>
    <message>
        <source>more views, with the board tilted by 20 to 40 degrees in different directions</source>
        <translation>mehr Ansichten, mit der Tafel um 20 bis 40 Grad in verschiedene Richtungen geneigt</translation>
    </message>
    <message>
        <source>no lens model could be fitted to the found corners</source>
        <translation>an die gefundenen Ecken ließ sich kein Objektivmodell anpassen</translation>
    </message>
    <message>
        <source>a flat board of the size given with --board, and views that show it tilted</source>
        <translation>eine flache Tafel der mit --board angegebenen Größe, und Ansichten, die sie geneigt zeigen</translation>
    </message>
    <message>
        <source>no lens model explains the found corners</source>
        <translation>kein Objektivmodell erklärt die gefundenen Ecken</translation>
    </message>
    <message>
        <source>a flat board of the size given with --board; --model fisheye for a lens wider than 120 degrees</source>
        <translation>eine flache Tafel der mit --board angegebenen Größe; --model fisheye für ein Objektiv mit mehr als 120 Grad</translation>
    </message>
    <message>
        <source>usable</source>
        <translation>brauchbar</translation>
    </message>
    <message>
        <source>the focal length is known to {:.2g} %, {:.2g} mm at {:g} mm</source>
        <translation>die Brennweite ist auf {} % bekannt, {} mm bei {} mm</translation>
    </message>
    <message>
        <source>but two halves of the views disagree by {:.2f} px ({:.2g} mm)</source>
        <translation>aber zwei Hälften der Ansichten weichen um {} px ({} mm) voneinander ab</translation>
    </message>
    <message>
        <source>but views left out fit worse ({:.2f} px) than those fitted ({:.2f} px)</source>
        <translation>aber ausgelassene Ansichten passen schlechter ({} px) als die angepassten ({} px)</translation>
    </message>
    <message>
        <source>but the views cover too little of the image or too few tilts</source>
        <translation>aber die Ansichten decken zu wenig vom Bild oder zu wenige Neigungen ab</translation>
    </message>
    <message>
        <source>with so few views, none could be left out to test the lens</source>
        <translation>bei so wenigen Ansichten ließ sich keine zur Prüfung auslassen</translation>
    </message>
    <message>
        <source>take {}</source>
        <translation>aufnehmen: {}</translation>
    </message>
    <message>
        <source>add views, sharp and tilted, that fill the image</source>
        <translation>Ansichten hinzufügen, scharf und geneigt, die das Bild füllen</translation>
    </message>
    <message>
        <source>no board was found in any of {} images</source>
        <translation>in keinem von {} Bildern wurde eine Tafel gefunden</translation>
    </message>
    <message>
        <source>{} (the first: {})</source>
        <translation>{} (das erste: {})</translation>
    </message>
    <message>
        <source>--board and --pattern that match the board, and all of it in the image</source>
        <translation>--board und --pattern passend zur Tafel, und die ganze Tafel im Bild</translation>
    </message>
    <message>
        <source>stopped while looking for boards; nothing was written</source>
        <translation>bei der Suche nach Tafeln angehalten; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>looking for the board in {}</source>
        <translation>Tafel in {} wird gesucht</translation>
    </message>
    <message>
        <source>is {} x {} px, the images before it {} x {}</source>
        <translation>hat {} x {} px, die Bilder davor {} x {}</translation>
    </message>
    <message>
        <source>images from one camera in one mode; the lens changes with the image size</source>
        <translation>Bilder einer Kamera in einer Betriebsart; das Objektiv ändert sich mit der Bildgröße</translation>
    </message>
    <message>
        <source>another image is called &apos;{}&apos; as well</source>
        <translation>ein anderes Bild heißt auch &apos;{}&apos;</translation>
    </message>
    <message>
        <source>giving the images different names</source>
        <translation>den Bildern verschiedene Namen geben</translation>
    </message>
    <message>
        <source>its corners are {:.2f} px off the lens model, those of the others {:.2f} px</source>
        <translation>seine Ecken weichen {} px vom Objektivmodell ab, die der anderen {} px</translation>
    </message>
    <message>
        <source>blurred, by motion or focus: its edges are {:.1f} px wide, those of the others {:.1f} px</source>
        <translation>unscharf, durch Bewegung oder Fokus: Seine Kanten sind {} px breit, die der anderen {} px</translation>
    </message>
    <message>
        <source>the board is bent; glue it to something stiff</source>
        <translation>die Tafel ist gebogen; auf etwas Steifes kleben</translation>
    </message>
    <message>
        <source>{} of its {} corners are misplaced: covered, reflected or blurred</source>
        <translation>{} seiner {} Ecken liegen falsch: verdeckt, gespiegelt oder unscharf</translation>
    </message>
    <message>
        <source>moved during the exposure, or not this board</source>
        <translation>während der Belichtung bewegt, oder nicht diese Tafel</translation>
    </message>
    <message>
        <source>its squares are {:.2f} % {} than they are high</source>
        <translation>ihre Quadrate sind {} % {} als hoch</translation>
    </message>
    <message>
        <source>wider</source>
        <translation>breiter</translation>
    </message>
    <message>
        <source>narrower</source>
        <translation>schmaler</translation>
    </message>
    <message>
        <source>it is bent by about {:.2g} mm from its middle to its corners</source>
        <translation>sie ist von der Mitte zu den Ecken um etwa {} mm gebogen</translation>
    </message>
    <message>
        <source>{}, and {}</source>
        <translation>{}, und {}</translation>
    </message>
    <message>
        <source>the board is not flat and even as assumed: {}; corrected for this, fx would be {:.2f} instead of {:.2f} px; use a board on glass or metal</source>
        <translation>die Tafel ist nicht so flach und gleichmäßig wie angenommen: {}; entsprechend korrigiert wäre fx {} statt {} px; eine Tafel auf Glas oder Metall verwenden</translation>
    </message>
    <message>
        <source>hardly any pixel of the face could be compared with the reference</source>
        <translation>kaum ein Pixel der Fläche ließ sich mit der Referenz vergleichen</translation>
    </message>
    <message>
        <source>a press and a reference of the same size in which the face is lit</source>
        <translation>ein Eindruck und eine Referenz gleicher Größe, auf denen die Fläche beleuchtet ist</translation>
    </message>
    <message>
        <source>nothing on the face is clearly darker than in the reference (the darkest part differs by {:.1f} %, the rest scatters by {:.1f} %)</source>
        <translation>nichts auf der Fläche ist deutlich dunkler als in der Referenz (der dunkelste Teil weicht um {} % ab, der Rest streut um {} %)</translation>
    </message>
    <message>
        <source>pressing the ball in deeper, and checking that the reference shows the same finger in the same pose</source>
        <translation>die Kugel tiefer eindrücken und prüfen, ob die Referenz denselben Finger in derselben Haltung zeigt</translation>
    </message>
    <message>
        <source>only specks are dark, none larger than {} pixels</source>
        <translation>nur Flecken sind dunkel, keiner größer als {} Pixel</translation>
    </message>
    <message>
        <source>pressing the ball in deeper</source>
        <translation>die Kugel tiefer eindrücken</translation>
    </message>
    <message>
        <source>two contacts were found, the second with {:.0f} % of the first</source>
        <translation>zwei Kontakte wurden gefunden, der zweite mit {} % des ersten</translation>
    </message>
    <message>
        <source>a press in which only the ball touches the face</source>
        <translation>ein Eindruck, bei dem nur die Kugel die Fläche berührt</translation>
    </message>
    <message>
        <source>the border of the dark part is not a circular arc</source>
        <translation>der Rand des dunklen Teils ist kein Kreisbogen</translation>
    </message>
    <message>
        <source>a press in which the ball is entirely on the face</source>
        <translation>ein Eindruck, bei dem die Kugel ganz auf der Fläche liegt</translation>
    </message>
    <message>
        <source>only {:.0f} degrees of the dark disc&apos;s rim are on the face</source>
        <translation>nur {} Grad vom Rand der dunklen Scheibe liegen auf der Fläche</translation>
    </message>
    <message>
        <source>a press closer to the middle of the face</source>
        <translation>ein Eindruck näher an der Mitte der Fläche</translation>
    </message>
    <message>
        <source>the dark part has a radius of {:.2f} mm, more than the ball&apos;s {:g} mm</source>
        <translation>der dunkle Teil hat einen Radius von {} mm, mehr als die Kugel mit {} mm</translation>
    </message>
    <message>
        <source>checking the ball&apos;s radius, or an image with only the ball in contact</source>
        <translation>den Radius der Kugel prüfen, oder ein Bild, auf dem nur die Kugel aufliegt</translation>
    </message>
    <message>
        <source>the dark part is not a disc: its rim is off a circle by {:.0f} % of the radius, and {:.0f} % of the circle is dark</source>
        <translation>der dunkle Teil ist keine Scheibe: Sein Rand weicht um {} % des Radius von einem Kreis ab, und {} % des Kreises sind dunkel</translation>
    </message>
    <message>
        <source>an image in which a ball, and only the ball, touches the face</source>
        <translation>ein Bild, auf dem eine Kugel und nur die Kugel die Fläche berührt</translation>
    </message>
    <message>
        <source>the middle of the dark disc is outside the face</source>
        <translation>die Mitte der dunklen Scheibe liegt außerhalb der Fläche</translation>
    </message>
    <message>
        <source>the press has no difference image</source>
        <translation>der Eindruck hat kein Differenzbild</translation>
    </message>
    <message>
        <source>taking the image again</source>
        <translation>das Bild noch einmal aufnehmen</translation>
    </message>
    <message>
        <source>OpenCV failed: {}</source>
        <translation>OpenCV scheiterte: {}</translation>
    </message>
    <message>
        <source>the finger moves: at most {} of {} frames in a row are the same</source>
        <translation>der Finger bewegt sich: höchstens {} von {} Bildern hintereinander sind gleich</translation>
    </message>
    <message>
        <source>holding ball and finger still for half a second, in steady light</source>
        <translation>Kugel und Finger bei gleichmäßigem Licht eine halbe Sekunde stillhalten</translation>
    </message>
    <message>
        <source>the mean of {} still frames, of {} read</source>
        <translation>das Mittel aus {} ruhigen Bildern, von {} gelesenen</translation>
    </message>
    <message>
        <source>the ball that was set by hand does not touch the face</source>
        <translation>die von Hand gesetzte Kugel berührt die Fläche nicht</translation>
    </message>
    <message>
        <source>moving its outline to the dark disc, or automatic detection</source>
        <translation>ihren Umriss auf die dunkle Scheibe ziehen oder die Kugel suchen lassen</translation>
    </message>
    <message>
        <source>one for each press, &quot;&quot; for none</source>
        <translation>ein Eintrag für jeden Eindruck, &quot;&quot; für keinen</translation>
    </message>
    <message>
        <source>is not a ball centre in front of the camera</source>
        <translation>ist kein Kugelmittelpunkt vor der Kamera</translation>
    </message>
    <message>
        <source>x, y, z in mm</source>
        <translation>x, y, z in mm</translation>
    </message>
    <message>
        <source>must hold two numbers for each press</source>
        <translation>muss zwei Zahlen für jeden Eindruck enthalten</translation>
    </message>
    <message>
        <source>a depth and its standard deviation in mm</source>
        <translation>eine Tiefe und ihre Standardabweichung in mm</translation>
    </message>
    <message>
        <source>frame {}</source>
        <translation>Bild {}</translation>
    </message>
    <message>
        <source>only {} of {} frames can be used ({})</source>
        <translation>nur {} von {} Bildern sind brauchbar ({})</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>record again with every marker in view and nothing on the contact face</source>
        <translation>noch einmal aufnehmen, mit allen Marken im Bild und nichts auf der Kontaktfläche</translation>
    </message>
    <message>
        <source>the recording has no such frame</source>
        <translation>die Aufnahme hat kein solches Bild</translation>
    </message>
    <message>
        <source>frame {} cannot be the rest pose: {}</source>
        <translation>Bild {} kann nicht die Ruhelage des Fingers sein: {}</translation>
    </message>
    <message>
        <source>another frame in which the finger rests</source>
        <translation>ein anderes Bild, in dem der Finger ruht</translation>
    </message>
    <message>
        <source>frame {}: something may have pressed on the contact face, {:.0f} mm from its base ({:.1f} % darker than untouched)</source>
        <translation>Bild {}: Etwas drückte vielleicht auf die Kontaktfläche, {} mm von ihrem Fuß ({} % dunkler als unberührt)</translation>
    </message>
    <message>
        <source>frame {}: something pressed on the contact face, {:.0f} mm from its base ({:.0f} % darker than untouched)</source>
        <translation>Bild {}: Etwas drückte auf die Kontaktfläche, {} mm von ihrem Fuß ({} % dunkler als unberührt)</translation>
    </message>
    <message>
        <source>frames {} to {}: something may have pressed on the contact face, {:.0f} mm from its base (up to {:.1f} % darker than untouched)</source>
        <translation>Bilder {} bis {}: Etwas drückte vielleicht auf die Kontaktfläche, {} mm von ihrem Fuß (bis zu {} % dunkler als unberührt)</translation>
    </message>
    <message>
        <source>frames {} to {}: something pressed on the contact face, {:.0f} mm from its base (up to {:.0f} % darker than untouched)</source>
        <translation>Bilder {} bis {}: Etwas drückte auf die Kontaktfläche, {} mm von ihrem Fuß (bis zu {} % dunkler als unberührt)</translation>
    </message>
    <message>
        <source>In {} of {} frames the face is darker than in the others. Something pressed on it most of the time, or most poses occur once. All frames stay in use. If there was contact, record again, and show each pose several times</source>
        <translation>In {} von {} Bildern ist die Fläche dunkler als in den übrigen. Meistens drückte etwas darauf, oder die meisten Haltungen kommen nur einmal vor. Alle Bilder werden weiter verwendet. Falls etwas die Fläche berührte, neu aufnehmen und jede Haltung mehrmals zeigen</translation>
    </message>
    <message>
        <source>In {} of {} frames the face is darker than in the brightest, and so are frames of near poses. Something pressed on it for long, or these poses occur once. They stay in use. If there was contact, record again, and show each pose several times</source>
        <translation>In {} von {} Bildern ist die Fläche dunkler als in den hellsten, ebenso in Bildern ähnlicher Haltung. Etwas drückte lange darauf, oder diese Haltungen kommen nur einmal vor. Sie werden weiter verwendet. Falls etwas die Fläche berührte, neu aufnehmen und jede Haltung mehrmals zeigen</translation>
    </message>
    <message>
        <source>only {} frames are left to use</source>
        <translation>nur {} Bilder bleiben zur Verwendung übrig</translation>
    </message>
    <message>
        <source>leave out fewer frames</source>
        <translation>weniger Bilder weglassen</translation>
    </message>
    <message>
        <source>the face is {:.0f} % brighter than its reference {:.0f} mm from the base: something pressed there when the reference was recorded, near its frame {}; record the reference again</source>
        <translation>die Fläche ist um {} % heller als ihre Referenz, {} mm von ihrem Fuß: Bei der Aufnahme der Referenz drückte dort etwas, nahe ihrem Bild {}; die Referenz neu aufnehmen</translation>
    </message>
    <message>
        <source>record again with nothing on the contact face, or specify that its skin has changed</source>
        <translation>noch einmal aufnehmen, ohne dass etwas die Kontaktfläche berührt, oder angeben, dass ihre Haut seitdem verändert wurde</translation>
    </message>
    <message>
        <source>something pressed on the contact face {:.0f} mm from its base in {} of {} frames: it is {:.0f} % darker there than in the reference from before</source>
        <translation>auf die Kontaktfläche drückte {} mm von ihrem Fuß etwas in {} von {} Bildern: Sie ist dort {} % dunkler als in der Referenz von vorher</translation>
    </message>
    <message>
        <source>in {} of {} presses the face is brighter than its reference {:.0f} mm along it: something pressed there when the reference was recorded; record it again, then calibrate again</source>
        <translation>in {} von {} Eindrücken ist die Fläche {} mm von ihrem Anfang heller als ihre Referenz: Dort drückte etwas, als die Referenz aufgenommen wurde; neu aufnehmen, dann neu kalibrieren</translation>
    </message>
    <message>
        <source>{} frames show poses that occur at no other time; it is unknown whether something pressed on the contact face in them</source>
        <translation>{} Bilder zeigen Haltungen, die zu keiner anderen Zeit vorkommen; ob darin etwas auf die Kontaktfläche drückte, ist unbekannt</translation>
    </message>
    <message>
        <source>No markers can be used: {}. Poses are estimated from the shape of the face alone, without twist. If the finger has dots, light both side faces so that they stand out, and focus</source>
        <translation>Keine Marken sind brauchbar: {}. Haltungen werden allein aus der Form der Fläche geschätzt, ohne Verdrehung. Hat der Finger Punkte, beide Seitenflächen so beleuchten, dass sie sich abheben, und scharf stellen</translation>
    </message>
    <message>
        <source>Markers {} were not found anywhere; the finger works with the other {}</source>
        <translation>Die Marken {} wurden nirgends gefunden; der Finger arbeitet mit den anderen {}</translation>
    </message>
    <message numerus="yes">
        <source>the recording holds {} frames; at least 2 are needed</source>
        <comment>the recording holds {} frame; at least 2 are needed</comment>
        <translation>
            <numerusform>die Aufnahme enthält {} Bild; mindestens 2 sind nötig</numerusform>
            <numerusform>die Aufnahme enthält {} Bilder; mindestens 2 sind nötig</numerusform>
        </translation>
    </message>
    <message>
        <source>record the finger while it bends slowly in every direction, untouched</source>
        <translation>den Finger aufnehmen, während er sich unberührt langsam in alle Richtungen biegt</translation>
    </message>
    <message>
        <source>numbering the markers</source>
        <translation>Marken werden nummeriert</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>{:.1f} of {:.1f} {} reached</source>
        <translation>{} von {} {} erreicht</translation>
    </message>
    <message>
        <source>bend it further away from the camera</source>
        <translation>weiter von der Kamera weg biegen</translation>
    </message>
    <message>
        <source>bend it further towards the camera</source>
        <translation>weiter zur Kamera hin biegen</translation>
    </message>
    <message>
        <source>push its tip further to one side</source>
        <translation>die Spitze weiter zur einen Seite drücken</translation>
    </message>
    <message>
        <source>push its tip further to the other side</source>
        <translation>die Spitze weiter zur anderen Seite drücken</translation>
    </message>
    <message>
        <source>twist it further to one side</source>
        <translation>weiter in die eine Richtung verdrehen</translation>
    </message>
    <message>
        <source>twist it further to the other side</source>
        <translation>weiter in die andere Richtung verdrehen</translation>
    </message>
    <message>
        <source>bend it while its tip is pushed aside: {:.0f} % of the combinations were seen</source>
        <translation>biegen, während die Spitze zur Seite gedrückt ist: {} % der Kombinationen wurden gesehen</translation>
    </message>
    <message>
        <source>a frame shows {} dots on the upper and {} on the lower side face (median of {} frames), but no two rows of up to {} with fixed positions on the finger</source>
        <translation>ein Bild zeigt {} Punkte auf der oberen und {} auf der unteren Seitenfläche (Median von {} Bildern), aber keine zwei Reihen von bis zu {} mit fester Position auf dem Finger</translation>
    </message>
    <message>
        <source>{} dots were found but they fit no pose of the {} markers</source>
        <translation>{} Punkte wurden gefunden, aber sie passen zu keiner Haltung der {} Marken</translation>
    </message>
    <message>
        <source>only {} of {} markers found</source>
        <translation>nur {} von {} Marken gefunden</translation>
    </message>
    <message>
        <source>the markers are {:.1f} px off any possible position</source>
        <translation>die Marken liegen {} px neben jeder möglichen Position</translation>
    </message>
    <message>
        <source>with {} markers, none may be hidden</source>
        <translation>bei {} Marken darf keine verdeckt sein</translation>
    </message>
    <message>
        <source>no frame shows the face</source>
        <translation>kein Bild zeigt die Fläche</translation>
    </message>
    <message>
        <source>a recording in which both long edges of the bright face are visible</source>
        <translation>eine Aufnahme, auf der beide langen Kanten der hellen Fläche zu sehen sind</translation>
    </message>
    <message>
        <source>stopped before the recording was read</source>
        <translation>angehalten, bevor die Aufnahme gelesen war</translation>
    </message>
    <message>
        <source>reading frame {} of {}</source>
        <translation>Bild {} von {} wird gelesen</translation>
    </message>
    <message>
        <source>a recording from this finger&apos;s camera, or the right camera.size and orientation</source>
        <translation>eine Aufnahme mit der Kamera dieses Fingers, oder die richtige camera.size und orientation</translation>
    </message>
    <message>
        <source>the recording cannot be renamed: {}</source>
        <translation>die Aufnahme lässt sich nicht umbenennen: {}</translation>
    </message>
    <message>
        <source>stopped before the recording was written</source>
        <translation>angehalten, bevor die Aufnahme geschrieben war</translation>
    </message>
    <message>
        <source>writing the accepted frames</source>
        <translation>übernommene Bilder werden geschrieben</translation>
    </message>
    <message>
        <source>stopped before the recording was compared</source>
        <translation>angehalten, bevor die Aufnahme verglichen war</translation>
    </message>
    <message>
        <source>comparing frame {} of {}</source>
        <translation>Bild {} von {} wird verglichen</translation>
    </message>
    <message>
        <source>{} marker positions in {} frames are estimates, because the markers were covered or not found</source>
        <translation>{} Markenpositionen in {} Bildern sind Schätzungen, weil die Marken verdeckt oder nicht gefunden waren</translation>
    </message>
    <message>
        <source>{} frames are few: one minute (about 1500 frames) over all bending directions gives closer references</source>
        <translation>{} Bilder sind wenige: Eine Minute (etwa 1500 Bilder) über alle Biegerichtungen gibt genauere Referenzen</translation>
    </message>
    <message>
        <source>Not yet seen: {}</source>
        <translation>Noch nicht gesehen: {}</translation>
    </message>
    <message>
        <source>this finger has no markers to record a reference with</source>
        <translation>dieser Finger hat keine Marken, um eine Referenz aufzunehmen</translation>
    </message>
    <message>
        <source>a flat sensor needs one untouched image</source>
        <translation>ein flacher Sensor braucht ein unberührtes Bild</translation>
    </message>
    <message>
        <source>the recording could not be processed ({})</source>
        <translation>die Aufnahme ließ sich nicht verarbeiten ({})</translation>
    </message>
    <message>
        <source>reference installed</source>
        <translation>Referenz eingerichtet</translation>
    </message>
    <message>
        <source>only a flat sensor uses one untouched image as its reference</source>
        <translation>nur ein flacher Sensor nutzt ein einziges unberührtes Bild als Referenz</translation>
    </message>
    <message>
        <source>a recording of the bending, untouched finger</source>
        <translation>eine Aufnahme des sich biegenden, unberührten Fingers</translation>
    </message>
    <message>
        <source>an untouched image taken with this sensor&apos;s camera</source>
        <translation>ein unberührtes Bild von der Kamera dieses Sensors</translation>
    </message>
    <message>
        <source>presses</source>
        <translation>Eindrücke</translation>
    </message>
    <message>
        <source>set of presses</source>
        <translation>Eindrücke</translation>
    </message>
    <message>
        <source>The {} was taken with changing settings of camera or light: {}. Lock them, and record it again.</source>
        <translation>Die Einstellungen von Kamera oder Licht änderten sich bei der Aufnahme ({}): {}. Sperren Sie sie, und nehmen Sie noch einmal auf.</translation>
    </message>
    <message>
        <source>The {} and the {} were taken with different settings: {}. Depth comes from comparing their brightness: record one of them again.</source>
        <translation>Mit verschiedenen Einstellungen aufgenommen ({}, {}): {}. Tiefe entsteht aus dem Vergleich ihrer Helligkeit: Nehmen Sie eines davon neu auf.</translation>
    </message>
    <message>
        <source>The finger was calibrated with other settings: {}. Restore them, or calibrate again.</source>
        <translation>Der Finger wurde mit anderen Einstellungen kalibriert: {}. Stellen Sie sie wie damals ein, oder kalibrieren Sie neu.</translation>
    </message>
    <message>
        <source>the brightness of the untouched face changes from press to press (standard deviation {:.1f} %): exposure or gain is automatic, or the room&apos;s light gets in; lock them, shade the finger and press again</source>
        <translation>die Helligkeit der unberührten Fläche ändert sich von Eindruck zu Eindruck (Standardabweichung {} %): Belichtung oder Verstärkung ist automatisch, oder Raumlicht dringt ein; beide sperren, den Finger abschirmen und neu drücken</translation>
    </message>
    <message>
        <source>the untouched face is {:.1f} % {} in all presses than in the reference: light, exposure or gain has changed in between; the depth is corrected for smooth changes, but let the lamps warm up and record the reference again</source>
        <translation>die unberührte Fläche ist in allen Eindrücken {} % {} als in der Referenz: Licht, Belichtung oder Verstärkung hat sich dazwischen geändert; gleichmäßige Änderungen werden in der Tiefe korrigiert, aber lassen Sie die Lampen warm werden und nehmen Sie die Referenz neu auf</translation>
    </message>
    <message>
        <source>in {} of {} presses the finger has a bend that the reference recording does not contain, or it has moved in its mount since: record a reference that bends as far, or press with less bending</source>
        <translation>in {} von {} Eindrücken hat der Finger eine Biegung, die die Referenzaufnahme nicht enthält, oder er hat sich seither in der Halterung bewegt: eine Referenz aufnehmen, die so weit biegt, oder mit weniger Biegung drücken</translation>
    </message>
    <message>
        <source>no mapping resulted</source>
        <translation>es ergab sich keine Abbildung</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>base</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>upper half</source>
        <translation>obere Hälfte</translation>
    </message>
    <message>
        <source>lower half</source>
        <translation>untere Hälfte</translation>
    </message>
    <message numerus="yes">
        <source>{1} {2:.3f} mm ({0} presses)</source>
        <comment>{1} {2:.3f} mm ({0} press)</comment>
        <translation>
            <numerusform>{1} {2} mm ({0} Eindruck)</numerusform>
            <numerusform>{1} {2} mm ({0} Eindrücke)</numerusform>
        </translation>
    </message>
    <message>
        <source>{} unknown: no press there</source>
        <translation>{} unbekannt: dort kein Eindruck</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>results and ground truth differ in size</source>
        <translation>Ergebnisse und wahre Werte sind verschieden groß</translation>
    </message>
    <message>
        <source>not as `alltact simulate` and `alltact reconstruct` write it ({})</source>
        <translation>nicht wie `alltact simulate` und `alltact reconstruct` es schreiben ({})</translation>
    </message>
    <message>
        <source>{} with {}</source>
        <translation>{} mit {}</translation>
    </message>
    <message>
        <source>running both again</source>
        <translation>beide noch einmal ausführen</translation>
    </message>
    <message>
        <source>the camera</source>
        <translation>die Kamera</translation>
    </message>
    <message>
        <source>the press could not be removed: {}</source>
        <translation>der Eindruck ließ sich nicht entfernen: {}</translation>
    </message>
    <message>
        <source>no finger is open, so the recording cannot be measured</source>
        <translation>kein Finger ist offen, also lässt sich die Aufnahme nicht vermessen</translation>
    </message>
    <message>
        <source>opening a finger</source>
        <translation>einen Finger öffnen</translation>
    </message>
    <message>
        <source>this recording no longer exists</source>
        <translation>diese Aufnahme ist nicht mehr vorhanden</translation>
    </message>
    <message>
        <source>plugging in its disk, or opening another one</source>
        <translation>ihren Datenträger anstecken oder eine andere öffnen</translation>
    </message>
    <message>
        <source>there is no face to save</source>
        <translation>es gibt keine Fläche zu speichern</translation>
    </message>
    <message>
        <source>another frame</source>
        <translation>ein anderes Bild</translation>
    </message>
    <message>
        <source>frame {} of {}</source>
        <translation>Bild {} von {}</translation>
    </message>
    <message>
        <source>the finger that belongs to this camera, or this finger&apos;s camera</source>
        <translation>der Finger, der zu dieser Kamera gehört, oder die Kamera dieses Fingers</translation>
    </message>
    <message>
        <source>there is no HID device that can be read</source>
        <translation>es gibt kein lesbares HID-Gerät</translation>
    </message>
    <message>
        <source>plugging in a pedal</source>
        <translation>ein Pedal anstecken</translation>
    </message>
    <message>
        <source>stopped before the report was written</source>
        <translation>angehalten, bevor der Bericht geschrieben war</translation>
    </message>
    <message>
        <source>the report could not be printed</source>
        <translation>der Bericht ließ sich nicht drucken</translation>
    </message>
    <message>
        <source>this computer cannot draw in 3D: there is no EGL with OpenGL 3.2</source>
        <translation>dieser Rechner kann kein 3D darstellen: Es gibt kein EGL mit OpenGL 3.2</translation>
    </message>
    <message>
        <source>installing libegl1 and libgl1-mesa-dri, which render in software</source>
        <translation>libegl1 und libgl1-mesa-dri installieren, die per Software rendern</translation>
    </message>
    <message>
        <source>this is not a session of this program</source>
        <translation>dies ist keine Sitzung dieses Programms</translation>
    </message>
    <message>
        <source>starting a new one</source>
        <translation>eine neue beginnen</translation>
    </message>
    <message>
        <source>there is no lamp whose light could be absorbed</source>
        <translation>es gibt keine Lampe, deren Licht absorbiert werden könnte</translation>
    </message>
    <message>
        <source>name the effect leds too</source>
        <translation>auch den Effekt leds nennen</translation>
    </message>
    <message>
        <source>room light adds to the light of the lamps</source>
        <translation>Raumlicht kommt zum Licht der Lampen hinzu</translation>
    </message>
    <message>
        <source>there is no lamp that could fail</source>
        <translation>es gibt keine Lampe, die ausfallen könnte</translation>
    </message>
    <message>
        <source>there is no lamp {}</source>
        <translation>es gibt keine Lampe {}</translation>
    </message>
    <message>
        <source>there is no lamp that could flicker</source>
        <translation>es gibt keine Lampe, die flackern könnte</translation>
    </message>
    <message>
        <source>there is no lamp that could warm up</source>
        <translation>es gibt keine Lampe, die warm werden könnte</translation>
    </message>
    <message>
        <source>parts of the image would have no light</source>
        <translation>Teile des Bildes hätten kein Licht</translation>
    </message>
    <message>
        <source>1 + a r^2 + b r^4 + c r^6 above 0 up to r = 1</source>
        <translation>1 + a r^2 + b r^4 + c r^6 bis r = 1 über 0</translation>
    </message>
    <message>
        <source>the rays of an orthographic camera do not spread</source>
        <translation>die Strahlen einer orthografischen Kamera gehen nicht auseinander</translation>
    </message>
    <message>
        <source>kind: polynomial, or leave vignetting out</source>
        <translation>kind: polynomial, oder vignetting weglassen</translation>
    </message>
    <message>
        <source>gamma 1 changes nothing</source>
        <translation>gamma 1 ändert nichts</translation>
    </message>
    <message>
        <source>leave gamma out</source>
        <translation>gamma weglassen</translation>
    </message>
    <message>
        <source>there is neither dead nor hot</source>
        <translation>es gibt weder dead noch hot</translation>
    </message>
    <message>
        <source>name one of them</source>
        <translation>eines davon nennen</translation>
    </message>
    <message>
        <source>there is neither prnu nor dsnu</source>
        <translation>es gibt weder prnu noch dsnu</translation>
    </message>
    <message>
        <source>the exposure could not change</source>
        <translation>die Belichtung könnte sich nicht ändern</translation>
    </message>
    <message>
        <source>more than 1</source>
        <translation>mehr als 1</translation>
    </message>
    <message>
        <source>an orthographic camera has no focal length for blur</source>
        <translation>eine orthografische Kamera hat keine Brennweite für die Unschärfe</translation>
    </message>
    <message>
        <source>the shutter would be open for longer than a frame lasts</source>
        <translation>der Verschluss wäre länger offen, als ein Bild dauert</translation>
    </message>
    <message>
        <source>exposure_ms up to {:g}</source>
        <translation>exposure_ms bis {:g}</translation>
    </message>
    <message>
        <source>reading the rows would take longer than a frame lasts</source>
        <translation>das Auslesen der Zeilen würde länger dauern als ein Bild</translation>
    </message>
    <message>
        <source>readout_ms up to {:g}</source>
        <translation>readout_ms bis {:g}</translation>
    </message>
    <message>
        <source>there are no dots to wear off</source>
        <translation>es gibt keine Punkte, die sich abnutzen könnten</translation>
    </message>
    <message>
        <source>stopped before all effects were measured</source>
        <translation>beendet, bevor alle Effekte gemessen waren</translation>
    </message>
    <message>
        <source>measuring {}</source>
        <translation>{} wird gemessen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not of the form {}</source>
        <translation>&apos;{}&apos; hat nicht die Form {}</translation>
    </message>
    <message>
        <source>the bubble needs a layer</source>
        <translation>die Blase braucht eine Schicht</translation>
    </message>
    <message>
        <source>name the effect layer too</source>
        <translation>auch den Effekt layer nennen</translation>
    </message>
    <message>
        <source>the bubble is wider than the layer is thick</source>
        <translation>die Blase ist breiter, als die Schicht dick ist</translation>
    </message>
    <message>
        <source>radius_mm up to {:g}</source>
        <translation>radius_mm bis {:g}</translation>
    </message>
    <message>
        <source>The finger&apos;s faces light each other</source>
        <translation>Die Flächen des Fingers beleuchten einander</translation>
    </message>
    <message>
        <source>only the lit view face and side faces light each other</source>
        <translation>nur die beleuchtete Sichtfläche und die Seitenflächen beleuchten einander</translation>
    </message>
    <message>
        <source>name the effects sides and leds too</source>
        <translation>auch die Effekte sides und leds nennen</translation>
    </message>
    <message>
        <source>The silicone absorbs part of the light</source>
        <translation>Das Silikon absorbiert einen Teil des Lichts</translation>
    </message>
    <message>
        <source>Room light falls on the faces</source>
        <translation>Raumlicht fällt auf die Flächen</translation>
    </message>
    <message>
        <source>The camera adapts its exposure to the image brightness</source>
        <translation>Die Kamera passt die Belichtung an die Bildhelligkeit an</translation>
    </message>
    <message>
        <source>The sensor adds a constant to every pixel</source>
        <translation>Der Sensor addiert zu jedem Pixel einen festen Wert</translation>
    </message>
    <message>
        <source>A bubble of air makes the layer thinner</source>
        <translation>Eine Luftblase macht die Schicht dünner</translation>
    </message>
    <message>
        <source>A lamp is off</source>
        <translation>Eine Lampe ist aus</translation>
    </message>
    <message>
        <source>Single pixels are always dark or always bright</source>
        <translation>Einzelne Pixel sind immer dunkel oder immer hell</translation>
    </message>
    <message>
        <source>Objects outside the focus distance are blurred</source>
        <translation>Was nicht in der Schärfeebene liegt, ist unscharf</translation>
    </message>
    <message>
        <source>Every pixel is always a little brighter or darker than its neighbours</source>
        <translation>Jeder Pixel ist stets etwas heller oder dunkler als seine Nachbarn</translation>
    </message>
    <message>
        <source>The lamps flicker</source>
        <translation>Die Lampen flackern</translation>
    </message>
    <message>
        <source>The camera&apos;s gain drifts from frame to frame</source>
        <translation>Die Verstärkung der Kamera driftet von Bild zu Bild</translation>
    </message>
    <message>
        <source>The camera&apos;s grey levels follow a power law</source>
        <translation>Die Grauwerte der Kamera folgen einem Potenzgesetz</translation>
    </message>
    <message>
        <source>The face reflects a lamp</source>
        <translation>Eine Lampe spiegelt sich in der Fläche</translation>
    </message>
    <message>
        <source>Light comes through a hole in the coat</source>
        <translation>Licht kommt durch ein Loch in der Beschichtung</translation>
    </message>
    <message>
        <source>Stray light falls on the sensor</source>
        <translation>Streulicht fällt auf den Sensor</translation>
    </message>
    <message>
        <source>The finger moves during the exposure</source>
        <translation>Der Finger bewegt sich während der Belichtung</translation>
    </message>
    <message>
        <source>The rows of an image are exposed one after the other</source>
        <translation>Die Zeilen eines Bildes werden nacheinander belichtet</translation>
    </message>
    <message>
        <source>Every row is a little brighter or darker, differently in each frame</source>
        <translation>Jede Zeile ist etwas heller oder dunkler, in jedem Bild anders</translation>
    </message>
    <message>
        <source>A scratch crosses the face</source>
        <translation>Ein Kratzer läuft über die Fläche</translation>
    </message>
    <message>
        <source>A speck of dirt is on the face</source>
        <translation>Ein Schmutzfleck liegt auf der Fläche</translation>
    </message>
    <message>
        <source>The layer is not equally thick everywhere</source>
        <translation>Die Dicke der Schicht ist ungleichmäßig</translation>
    </message>
    <message>
        <source>Part of the light spreads over the entire image</source>
        <translation>Ein Teil des Lichts verteilt sich über das ganze Bild</translation>
    </message>
    <message>
        <source>The image is darker towards its corners</source>
        <translation>Das Bild wird zu den Ecken hin dunkler</translation>
    </message>
    <message>
        <source>The lamps lose light while they warm up</source>
        <translation>Die Lampen verlieren Licht, während sie warm werden</translation>
    </message>
    <message>
        <source>Dots are worn and fainter</source>
        <translation>Punkte sind abgenutzt und blasser</translation>
    </message>
    <message>
        <source>a point of the mesh is not a number</source>
        <translation>ein Punkt des Netzes ist keine gültige Zahl</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>neu exportieren</translation>
    </message>
    <message>
        <source>the mesh does not exist</source>
        <translation>das Netz gibt es nicht</translation>
    </message>
    <message>
        <source>an STL or OBJ file</source>
        <translation>eine STL- oder OBJ-Datei</translation>
    </message>
    <message>
        <source>this mesh format is unknown</source>
        <translation>dieses Netzformat ist unbekannt</translation>
    </message>
    <message>
        <source>a file that ends in .stl or .obj</source>
        <translation>eine Datei, die auf .stl oder .obj endet</translation>
    </message>
    <message>
        <source>the mesh&apos;s file is larger than 512 MB</source>
        <translation>die Datei des Netzes ist größer als 512 MB</translation>
    </message>
    <message>
        <source>export a coarser mesh</source>
        <translation>ein gröberes Netz exportieren</translation>
    </message>
    <message>
        <source>the mesh cannot be read</source>
        <translation>das Netz lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>export it again, e.g. as binary STL</source>
        <translation>neu exportieren, z. B. als binäres STL</translation>
    </message>
    <message>
        <source>the mesh has more than {} triangles</source>
        <translation>das Netz hat mehr als {} Dreiecke</translation>
    </message>
    <message>
        <source>the mesh has no triangles</source>
        <translation>das Netz hat keine Dreiecke</translation>
    </message>
    <message>
        <source>export it again as STL or OBJ</source>
        <translation>neu als STL oder OBJ exportieren</translation>
    </message>
    <message>
        <source>the mesh has holes: {} edges do not border two triangles</source>
        <translation>das Netz hat Löcher: {} Kanten grenzen nicht an zwei Dreiecke</translation>
    </message>
    <message>
        <source>close it in the program that made it</source>
        <translation>es in dem Programm schließen, das es erzeugt hat</translation>
    </message>
    <message>
        <source>marker network {}</source>
        <translation>Netz für Marken: {}</translation>
    </message>
    <message>
        <source>which untouched image a frame is compared with: the one of the finger at rest, the nearest recorded one, or one computed from several near ones</source>
        <translation>mit welchem unberührten Bild ein Bild verglichen wird: dem des Fingers in Ruhe, dem nächsten aufgenommenen oder einem aus mehreren nahen berechneten</translation>
    </message>
    <message>
        <source>The finger&apos;s body deforms under load</source>
        <translation>Der Körper des Fingers verformt sich unter Last</translation>
    </message>
    <message>
        <source>a flat sensor has no body that deforms</source>
        <translation>ein flacher Sensor hat keinen Körper, der sich verformt</translation>
    </message>
    <message>
        <source>leave body out</source>
        <translation>body weglassen</translation>
    </message>
    <message>
        <source>nothing pushes, so no body deforms</source>
        <translation>nichts drückt, also verformt sich kein Körper</translation>
    </message>
    <message>
        <source>name push too</source>
        <translation>auch push nennen</translation>
    </message>
    <message>
        <source>A cylinder is pressed in sideways</source>
        <translation>Ein liegender Zylinder wird eingedrückt</translation>
    </message>
    <message>
        <source>sd_px instead of focus_mm and aperture_mm</source>
        <translation>sd_px statt focus_mm und aperture_mm</translation>
    </message>
    <message>
        <source>The lens bends straight lines</source>
        <translation>Das Objektiv krümmt gerade Linien</translation>
    </message>
    <message>
        <source>an orthographic camera has no lens</source>
        <translation>eine orthografische Kamera hat kein Objektiv</translation>
    </message>
    <message>
        <source>leave distortion out</source>
        <translation>distortion weglassen</translation>
    </message>
    <message>
        <source>An edge is pressed into the face</source>
        <translation>Eine Kante wird in die Fläche gedrückt</translation>
    </message>
    <message>
        <source>the body would be {:g} mm in size</source>
        <translation>der Körper wäre {:g} mm groß</translation>
    </message>
    <message>
        <source>&apos;scale&apos; specifies the mm per unit of the file</source>
        <translation>&apos;scale&apos; gibt an, wie viele mm eine Einheit der Datei ist</translation>
    </message>
    <message>
        <source>A body is pressed into the face</source>
        <translation>Ein Körper wird in die Fläche gedrückt</translation>
    </message>
    <message>
        <source>The camera looks through a flat window into the silicone</source>
        <translation>Die Kamera blickt durch ein ebenes Fenster in das Silikon</translation>
    </message>
    <message>
        <source>a window does not bend parallel rays</source>
        <translation>ein Fenster bricht parallele Strahlen nicht</translation>
    </message>
    <message>
        <source>leave port out</source>
        <translation>port weglassen</translation>
    </message>
    <message>
        <source>A flat punch is pressed into the face</source>
        <translation>Ein flacher Stempel wird in die Fläche gedrückt</translation>
    </message>
    <message>
        <source>the force is 0</source>
        <translation>die Kraft ist 0</translation>
    </message>
    <message>
        <source>a force above 0, or no push</source>
        <translation>eine Kraft über 0, oder push weglassen</translation>
    </message>
    <message>
        <source>A ball pushes against the finger</source>
        <translation>Eine Kugel drückt gegen den Finger</translation>
    </message>
    <message>
        <source>a flat sensor has a contact face only</source>
        <translation>ein flacher Sensor hat nur eine Kontaktfläche</translation>
    </message>
    <message>
        <source>face: contact</source>
        <translation>face: contact</translation>
    </message>
    <message>
        <source>a body with creep or damping still moves after a push ends</source>
        <translation>in einem Körper mit Kriechen oder Dämpfung wirkt ein beendetes Drücken nach</translation>
    </message>
    <message>
        <source>instead of &apos;until&apos;, a force_N that goes to 0</source>
        <translation>statt &apos;until&apos; ein force_N, das auf 0 geht</translation>
    </message>
    <message>
        <source>the drag is 0</source>
        <translation>die Zugkraft ist 0</translation>
    </message>
    <message>
        <source>another force, or leave it out</source>
        <translation>eine andere Kraft, oder weglassen</translation>
    </message>
    <message>
        <source>without its body the finger deforms on its contact face only</source>
        <translation>ohne seinen Körper verformt sich der Finger nur an seiner Kontaktfläche</translation>
    </message>
    <message>
        <source>name the effect body too</source>
        <translation>auch den Effekt body nennen</translation>
    </message>
    <message>
        <source>the push bends the finger beyond the model&apos;s range</source>
        <translation>das Drücken biegt den Finger über den Bereich des Modells hinaus</translation>
    </message>
    <message>
        <source>up to {:.2g} times these forces, or a stiffer body</source>
        <translation>bis zum {:.2g}-Fachen dieser Kräfte, oder ein steiferer Körper</translation>
    </message>
    <message>
        <source>the height map is too small</source>
        <translation>die Höhenkarte ist zu klein</translation>
    </message>
    <message>
        <source>2 x 2 pixels or more</source>
        <translation>2 x 2 Pixel oder mehr</translation>
    </message>
    <message>
        <source>The finger twists about its length</source>
        <translation>Der Finger verdreht sich um seine Längsachse</translation>
    </message>
    <message>
        <source>a flat sensor does not twist</source>
        <translation>ein flacher Sensor verdreht sich nicht</translation>
    </message>
    <message>
        <source>leave twist out</source>
        <translation>twist weglassen</translation>
    </message>
    <message>
        <source>marker {} is listed twice</source>
        <translation>Marke {} ist zweimal aufgeführt</translation>
    </message>
    <message>
        <source>each number once</source>
        <translation>jede Nummer einmal</translation>
    </message>
    <message>
        <source>a layer cannot have a modulus or a length of {:g}</source>
        <translation>einen Elastizitätsmodul oder eine Länge von {:g} kann eine Schicht nicht haben</translation>
    </message>
    <message>
        <source>numbers above 0</source>
        <translation>Zahlen über 0</translation>
    </message>
    <message>
        <source>{:g} N press the ball into the layer beyond the known range</source>
        <translation>{:g} N drücken die Kugel über den bekannten Bereich hinaus in die Schicht</translation>
    </message>
    <message>
        <source>up to {:.3g} N, a larger ball or a harder layer</source>
        <translation>bis {:.3g} N, eine größere Kugel oder eine härtere Schicht</translation>
    </message>
    <message>
        <source>a body cannot have a modulus or a length of {:g}</source>
        <translation>einen Elastizitätsmodul oder eine Länge von {:g} kann ein Körper nicht haben</translation>
    </message>
    <message>
        <source>two walls of {:g} mm do not fit into a depth of {:g} mm</source>
        <translation>zwei Wände von {:g} mm passen nicht in eine Tiefe von {:g} mm</translation>
    </message>
    <message>
        <source>walls of up to {:g} mm</source>
        <translation>Wände bis {:g} mm</translation>
    </message>
    <message>
        <source>a coupling of {:g} is not a fraction</source>
        <translation>eine Kopplung von {:g} ist kein Anteil</translation>
    </message>
    <message>
        <source>0 to 1</source>
        <translation>0 bis 1</translation>
    </message>
    <message>
        <source>{:g} cannot be a contact&apos;s modulus, radius, force or friction</source>
        <translation>{:g} kann weder Elastizitätsmodul noch Radius, Kraft oder Reibung eines Kontakts sein</translation>
    </message>
    <message>
        <source>the tangential force is not a number</source>
        <translation>die tangentiale Kraft ist keine Zahl</translation>
    </message>
    <message>
        <source>newtons</source>
        <translation>Newton</translation>
    </message>
    <message>
        <source>{:g} N press the ball into the body beyond the known range</source>
        <translation>{:g} N drücken die Kugel über den bekannten Bereich hinaus in den Körper</translation>
    </message>
    <message>
        <source>up to {:.3g} N, a larger ball or a harder body</source>
        <translation>bis {:.3g} N, eine größere Kugel oder ein härterer Körper</translation>
    </message>
    <message>
        <source>a hardness of {:g} Shore A has no known modulus</source>
        <translation>zu einer Härte von {:g} Shore A ist kein Elastizitätsmodul bekannt</translation>
    </message>
    <message>
        <source>a lens does not change over time</source>
        <translation>ein Objektiv ändert sich nicht mit der Zeit</translation>
    </message>
    <message>
        <source>leave &apos;from&apos; and &apos;until&apos; out</source>
        <translation>&apos;from&apos; und &apos;until&apos; weglassen</translation>
    </message>
    <message>
        <source>stopped before the twin was found</source>
        <translation>angehalten, bevor der Zwilling gefunden war</translation>
    </message>
    <message>
        <source>there is no image of a press</source>
        <translation>es gibt kein Bild eines Eindrucks</translation>
    </message>
    <message>
        <source>images of a ball of known radius pressed into the face</source>
        <translation>Bilder einer Kugel von bekanntem Radius, in die Fläche gedrückt</translation>
    </message>
    <message>
        <source>noise is estimated from {} untouched images</source>
        <translation>das Rauschen ist aus {} unberührten Bildern geschätzt</translation>
    </message>
    <message>
        <source>temporal noise is estimated from one untouched image and {} outside its contact</source>
        <translation>das zeitliche Rauschen ist aus einem unberührten Bild und aus {} außerhalb des Kontakts geschätzt</translation>
    </message>
    <message>
        <source>{}: too little around the contact can be compared</source>
        <translation>{}: um den Kontakt herum lässt sich zu wenig vergleichen</translation>
    </message>
    <message>
        <source>a press further from the face&apos;s edges</source>
        <translation>ein Eindruck weiter weg von den Kanten der Fläche</translation>
    </message>
    <message>
        <source>fitting the presses</source>
        <translation>Eindrücke werden angepasst</translation>
    </message>
    <message>
        <source>not observable: at its limit, or another number has the same effect</source>
        <translation>nicht bestimmbar: am Ende des Bereichs, oder eine andere Größe wirkt gleich</translation>
    </message>
    <message>
        <source>hardly observable in these images</source>
        <translation>aus diesen Bildern kaum bestimmbar</translation>
    </message>
    <message>
        <source>scattering of the layer, per mm</source>
        <translation>Streuung der Schicht, je mm</translation>
    </message>
    <message>
        <source>reflection of the coat below the layer</source>
        <translation>Reflexion der Beschichtung unter der Schicht</translation>
    </message>
    <message>
        <source>the coat below the layer is assumed to be black: the presses show nothing else</source>
        <translation>die Beschichtung unter der Schicht wird als schwarz angenommen: Die Eindrücke zeigen nichts anderes</translation>
    </message>
    <message>
        <source>absorption in the layer is not observable: scattering and coat change the same curve</source>
        <translation>die Absorption in der Schicht ist nicht bestimmbar: Streuung und Beschichtung verändern dieselbe Kurve</translation>
    </message>
    <message>
        <source>roll-off length, mm</source>
        <translation>Länge des Auslaufs, mm</translation>
    </message>
    <message>
        <source>no swelling is visible around the contacts</source>
        <translation>um die Kontakte ist keine Wölbung sichtbar</translation>
    </message>
    <message>
        <source>height of the swelling, fraction of the layer</source>
        <translation>Höhe der Wölbung, Anteil der Schicht</translation>
    </message>
    <message>
        <source>its distance from the rim, mm</source>
        <translation>ihr Abstand vom Rand, mm</translation>
    </message>
    <message>
        <source>steepness of its slope</source>
        <translation>Steilheit ihres Abfalls</translation>
    </message>
    <message>
        <source>blur, standard deviation in pixels</source>
        <translation>Unschärfe, Standardabweichung in Pixeln</translation>
    </message>
    <message>
        <source>no blur is visible apart from the roll-off</source>
        <translation>außer dem Auslauf ist keine Unschärfe sichtbar</translation>
    </message>
    <message>
        <source>{}: depth, mm</source>
        <translation>{}: Tiefe, mm</translation>
    </message>
    <message>
        <source>{}: position along the face, mm</source>
        <translation>{}: Position längs der Fläche, mm</translation>
    </message>
    <message>
        <source>{}: position across the face, mm</source>
        <translation>{}: Position quer zur Fläche, mm</translation>
    </message>
    <message>
        <source>{}: light, relative to its untouched image</source>
        <translation>{}: Licht, relativ zu seinem unberührten Bild</translation>
    </message>
    <message>
        <source>lamp {}: power</source>
        <translation>Lampe {}: Leistung</translation>
    </message>
    <message>
        <source>lamp {}: distance from the face, mm</source>
        <translation>Lampe {}: Abstand von der Fläche, mm</translation>
    </message>
    <message>
        <source>lamp {}: distance from the camera, mm</source>
        <translation>Lampe {}: Abstand von der Kamera, mm</translation>
    </message>
    <message>
        <source>the lamps reproduce the light on the face, not the positions of the real ones: {} of {} positions are not observable</source>
        <translation>die Lampen bilden das Licht auf der Fläche nach, nicht die Positionen der wirklichen: {} von {} Positionen sind nicht bestimmbar</translation>
    </message>
    <message>
        <source>read noise, grey levels</source>
        <translation>Ausleserauschen, Graustufen</translation>
    </message>
    <message>
        <source>shot noise, grey levels</source>
        <translation>Schrotrauschen, Graustufen</translation>
    </message>
    <message>
        <source>shot noise and read noise cannot be separated: the face is too evenly lit, or shot noise is absent</source>
        <translation>Schrotrauschen und Ausleserauschen lassen sich nicht trennen: Die Fläche ist zu gleichmäßig beleuchtet, oder es gibt kein Schrotrauschen</translation>
    </message>
    <message>
        <source>fixed pattern, fraction</source>
        <translation>festes Muster, Anteil</translation>
    </message>
    <message>
        <source>the scene contains the face only: no side faces, no dots, no twist</source>
        <translation>die Szene enthält nur die Fläche: keine Seitenflächen, keine Punkte, keine Verdrehung</translation>
    </message>
    <message>
        <source>there is no untouched image of this finger to compare with</source>
        <translation>es gibt kein unberührtes Bild dieses Fingers zum Vergleichen</translation>
    </message>
    <message>
        <source>--reference with an image in which nothing touches it</source>
        <translation>--reference mit einem Bild, auf dem ihn nichts berührt</translation>
    </message>
    <message>
        <source>an image of this finger, at the size of its camera</source>
        <translation>ein Bild dieses Fingers, in der Bildgröße seiner Kamera</translation>
    </message>
    <message>
        <source>the radius of the ball that was pressed is not known</source>
        <translation>der Radius der eingedrückten Kugel ist nicht bekannt</translation>
    </message>
    <message>
        <source>--ball-radius-mm with the radius of the ball</source>
        <translation>--ball-radius-mm mit dem Radius der Kugel</translation>
    </message>
    <message>
        <source>no press was specified, and the finger has none</source>
        <translation>es wurde kein Eindruck angegeben, und der Finger enthält keinen</translation>
    </message>
    <message>
        <source>images of a ball of known radius pressed into its face</source>
        <translation>Bilder einer Kugel von bekanntem Radius, in seine Fläche gedrückt</translation>
    </message>
    <message>
        <source>too little of the untouched face is visible</source>
        <translation>von der unberührten Fläche ist zu wenig sichtbar</translation>
    </message>
    <message>
        <source>images in which the entire face is visible</source>
        <translation>Bilder, auf denen die ganze Fläche zu sehen ist</translation>
    </message>
    <message>
        <source>no lamp would light the face</source>
        <translation>keine Lampe würde die Fläche beleuchten</translation>
    </message>
    <message>
        <source>checking the finger&apos;s face</source>
        <translation>die Fläche des Fingers prüfen</translation>
    </message>
    <message>
        <source>finding the lamps</source>
        <translation>Lampen werden gesucht</translation>
    </message>
    <message>
        <source>no lamp reproduces the untouched image</source>
        <translation>keine Lampe bildet das unberührte Bild annähernd nach</translation>
    </message>
    <message>
        <source>noise is estimated from single images: fixed pattern and temporal noise of the camera cannot be separated</source>
        <translation>das Rauschen ist aus einzelnen Bildern geschätzt: Festes Muster und zeitliches Rauschen der Kamera lassen sich nicht trennen</translation>
    </message>
    <message>
        <source>too little of the finger&apos;s length is visible</source>
        <translation>von der Länge des Fingers ist zu wenig sichtbar</translation>
    </message>
    <message>
        <source>the finger&apos;s base is on the right of the image, which no scene supports</source>
        <translation>der Fuß des Fingers liegt im Bild rechts, was keine Szene unterstützt</translation>
    </message>
    <message>
        <source>camera.orientation: flip_u in finger.yaml</source>
        <translation>camera.orientation: flip_u in finger.yaml</translation>
    </message>
    <message>
        <source>no scene was found with images close to these</source>
        <translation>es wurde keine Szene gefunden, deren Bilder diesen ähneln</translation>
    </message>
    <message>
        <source>images of one ball, pressed in where the entire contact is visible</source>
        <translation>Bilder einer einzigen Kugel, eingedrückt, wo der ganze Kontakt sichtbar ist</translation>
    </message>
    <message>
        <source>alltact force with a table of this finger&apos;s markers</source>
        <translation>alltact force mit einer Tabelle der Marken dieses Fingers</translation>
    </message>
    <message>
        <source>the force model was trained with {} markers, the finger has {} others</source>
        <translation>das Kraftmodell wurde mit {} Marken trainiert, der Finger hat {} andere</translation>
    </message>
    <message>
        <source>the force model belongs to another reference: its markers rested up to {:.1f} px off the present positions</source>
        <translation>das Kraftmodell gehört zu einer anderen Referenz: Die Ruhepositionen seiner Marken weichen bis zu {:.1f} px von den jetzigen ab</translation>
    </message>
    <message>
        <source>train the force model again</source>
        <translation>das Kraftmodell neu trainieren</translation>
    </message>
    <message>
        <source>is not an object</source>
        <translation>ist kein Objekt</translation>
    </message>
    <message>
        <source>is not a number</source>
        <translation>ist keine Zahl</translation>
    </message>
    <message>
        <source>is not a valid number</source>
        <translation>ist keine gültige Zahl</translation>
    </message>
    <message>
        <source>is not an integer</source>
        <translation>ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>is not a list</source>
        <translation>ist keine Liste</translation>
    </message>
    <message>
        <source>holds {} numbers, not {} x {}</source>
        <translation>enthält {} Zahlen, nicht {} x {}</translation>
    </message>
    <message>
        <source>is not true or false</source>
        <translation>ist weder true noch false</translation>
    </message>
    <message>
        <source>must be two positions</source>
        <translation>müssen zwei Positionen sein</translation>
    </message>
    <message>
        <source>must be mean, ridge, quadratic or network</source>
        <translation>muss mean, ridge, quadratic oder network sein</translation>
    </message>
    <message>
        <source>contains non-text values</source>
        <translation>enthält etwas, das kein Text ist</translation>
    </message>
    <message>
        <source>does not have the shape that the model needs</source>
        <translation>hat nicht die Form, die das Modell braucht</translation>
    </message>
    <message>
        <source>must be above 0</source>
        <translation>muss über 0 sein</translation>
    </message>
    <message>
        <source>is not a valid range</source>
        <translation>ist kein gültiger Bereich</translation>
    </message>
    <message>
        <source>contains non-numeric values</source>
        <translation>enthält nichtnumerische Werte</translation>
    </message>
    <message>
        <source>must be 2 or 3</source>
        <translation>muss 2 oder 3 sein</translation>
    </message>
    <message>
        <source>must be an integer from 1 to 1024</source>
        <translation>muss eine ganze Zahl von 1 bis 1024 sein</translation>
    </message>
    <message>
        <source>must be a number from 0 to 1000000</source>
        <translation>muss eine Zahl von 0 bis 1000000 sein</translation>
    </message>
    <message>
        <source>must be 1 to {}</source>
        <translation>müssen 1 bis {} sein</translation>
    </message>
    <message>
        <source>are missing</source>
        <translation>fehlen</translation>
    </message>
    <message>
        <source>is not a force model: damaged or truncated</source>
        <translation>ist kein Kraftmodell: beschädigt oder unvollständig</translation>
    </message>
    <message>
        <source>must be two motor positions, the lower one first</source>
        <translation>müssen zwei Motorstellungen sein, die kleinere zuerst</translation>
    </message>
    <message>
        <source>for example [0.0, 12.5]</source>
        <translation>zum Beispiel [0.0, 12.5]</translation>
    </message>
    <message>
        <source>must be from 0 to 1000</source>
        <translation>muss zwischen 0 und 1000 liegen</translation>
    </message>
    <message>
        <source>the error of a motor position, with the screw&apos;s play</source>
        <translation>der Fehler einer Motorstellung, das Spiel der Spindel eingeschlossen</translation>
    </message>
    <message>
        <source>must name the finger&apos;s folder</source>
        <translation>muss den Ordner des Fingers nennen</translation>
    </message>
    <message>
        <source>its path from the folder of this file, for example ../left-07</source>
        <translation>sein Pfad vom Ordner dieser Datei aus, zum Beispiel ../left-07</translation>
    </message>
    <message>
        <source>goes beyond what the finger {} can reach: at {:.6g} turns {}</source>
        <translation>geht über das hinaus, was der Finger {} erreichen kann: Bei {:.6g} Umdrehungen gilt: {}</translation>
    </message>
    <message>
        <source>a range within {:.6g} to {:.6g}</source>
        <translation>ein Bereich innerhalb von {:.6g} bis {:.6g}</translation>
    </message>
    <message>
        <source>must specify the camera&apos;s pose exactly once</source>
        <translation>muss die Lage der Kamera auf genau eine Art angeben</translation>
    </message>
    <message>
        <source>this, or known_at_turns: the motor position at which gripper_from_camera in the finger&apos;s own file holds</source>
        <translation>dies, oder known_at_turns: die Motorstellung, bei der gripper_from_camera in der Datei des Fingers selbst gilt</translation>
    </message>
    <message>
        <source>must lie in the motor&apos;s range</source>
        <translation>muss im Bereich des Motors liegen</translation>
    </message>
    <message>
        <source>a motor position from {:g} to {:g}</source>
        <translation>eine Motorstellung von {:g} bis {:g}</translation>
    </message>
    <message>
        <source>the name on the gripper</source>
        <translation>der Name auf dem Greifer</translation>
    </message>
    <message>
        <source>is also the name of the other finger</source>
        <translation>ist auch der Name des anderen Fingers</translation>
    </message>
    <message>
        <source>two names, for example left and right</source>
        <translation>zwei Namen, zum Beispiel links und rechts</translation>
    </message>
    <message>
        <source>does not specify the camera&apos;s pose in the gripper</source>
        <translation>gibt die Lage der Kamera im Greifer nicht an</translation>
    </message>
    <message>
        <source>add gripper_from_camera there, as it is at {:g} turns of the motor</source>
        <translation>dort gripper_from_camera hinzufügen, wie es bei {:g} Umdrehungen des Motors ist</translation>
    </message>
    <message>
        <source>the motor cannot stand at {:.6g} turns: its range is from {:.6g} to {:.6g}</source>
        <translation>der Motor kann nicht bei {:.6g} Umdrehungen stehen: Sein Bereich reicht von {:.6g} bis {:.6g}</translation>
    </message>
    <message>
        <source>a motor position in that range, or correct range_turns</source>
        <translation>eine Motorstellung in diesem Bereich, oder range_turns berichtigen</translation>
    </message>
    <message>
        <source>the standard deviation of a motor position must be 0 or above</source>
        <translation>die Standardabweichung einer Motorstellung muss mindestens 0 sein</translation>
    </message>
    <message>
        <source>a number of turns</source>
        <translation>eine Zahl von Umdrehungen</translation>
    </message>
    <message>
        <source>the camera pose of finger {} is unknown</source>
        <translation>die Lage der Kamera des Fingers {} ist unbekannt</translation>
    </message>
    <message>
        <source>must be two numbers: x and z in mm</source>
        <translation>müssen zwei Zahlen sein: x und z in mm</translation>
    </message>
    <message>
        <source>a travel in mm for each turn</source>
        <translation>ein Weg in mm je Umdrehung</translation>
    </message>
    <message>
        <source>a motor position</source>
        <translation>eine Motorstellung</translation>
    </message>
    <message>
        <source>must be two fingers, not {}</source>
        <translation>müssen zwei Finger sein, nicht {}</translation>
    </message>
    <message>
        <source>one block &apos;- name: ...&apos; for each</source>
        <translation>je ein Block &apos;- name: ...&apos;</translation>
    </message>
    <message>
        <source>must be above 0 and at most {:g}</source>
        <translation>muss über 0 und höchstens {:g} sein</translation>
    </message>
    <message>
        <source>rod and crank are stretched into one line</source>
        <translation>Stange und Kurbel liegen gestreckt in einer Linie</translation>
    </message>
    <message>
        <source>rod and crank are folded into one line</source>
        <translation>Stange und Kurbel liegen gefaltet in einer Linie</translation>
    </message>
    <message>
        <source>the rod lies across the screw</source>
        <translation>die Stange liegt quer zur Spindel</translation>
    </message>
    <message>
        <source>must be a travel in mm, above or below 0</source>
        <translation>muss ein Weg in mm sein, größer oder kleiner als 0</translation>
    </message>
    <message>
        <source>how far the nut goes away from the palm in one turn, for example 2.0</source>
        <translation>wie weit sich die Mutter in einer Umdrehung von der Handfläche entfernt, zum Beispiel 2.0</translation>
    </message>
    <message>
        <source>must be numbers from -{0:g} to {0:g}</source>
        <translation>müssen Zahlen von -{0:g} bis {0:g} sein</translation>
    </message>
    <message>
        <source>x and z of the axis that the finger turns about, in mm</source>
        <translation>x und z der Achse, um die sich der Finger dreht, in mm</translation>
    </message>
    <message>
        <source>x and z of the rod&apos;s joint on the nut at motor position 0, in mm</source>
        <translation>x und z des Gelenks der Stange an der Mutter bei Motorstellung 0, in mm</translation>
    </message>
    <message>
        <source>the distance from the finger&apos;s axis to the rod, in mm</source>
        <translation>der Abstand von der Drehachse des Fingers zur Stange, in mm</translation>
    </message>
    <message>
        <source>the distance between the rod&apos;s joints, in mm</source>
        <translation>der Abstand zwischen den Gelenken der Stange, in mm</translation>
    </message>
    <message>
        <source>rod and crank never meet: together they reach {:g} mm, and the nut passes the finger&apos;s axis at {:g} mm</source>
        <translation>Stange und Kurbel treffen sich nie: Zusammen reichen sie {:g} mm weit, und die Mutter läuft in {:g} mm Abstand an der Drehachse des Fingers vorbei</translation>
    </message>
    <message>
        <source>measure pivot_mm, nut_mm, crank_mm and rod_mm again</source>
        <translation>pivot_mm, nut_mm, crank_mm und rod_mm neu messen</translation>
    </message>
    <message>
        <source>the motor position is not a number</source>
        <translation>die Motorstellung ist keine Zahl</translation>
    </message>
    <message>
        <source>at {:.6g} turns the rod&apos;s joint lies on the finger&apos;s axis, so that the finger may stand anywhere</source>
        <translation>bei {:.6g} Umdrehungen liegt das Gelenk der Stange auf der Drehachse des Fingers, sodass der Finger beliebig stehen kann</translation>
    </message>
    <message>
        <source>another motor position</source>
        <translation>eine andere Motorstellung</translation>
    </message>
    <message>
        <source>rod and crank do not meet at {:.6g} turns: they do from {:.6g} ({}) to {:.6g} ({})</source>
        <translation>Stange und Kurbel treffen sich bei {:.6g} Umdrehungen nicht: Sie tun es von {:.6g} ({}) bis {:.6g} ({})</translation>
    </message>
    <message>
        <source>a motor position between these</source>
        <translation>eine Motorstellung dazwischen</translation>
    </message>
    <message>
        <source>for example 123456789,4.25</source>
        <translation>zum Beispiel 123456789,4.25</translation>
    </message>
    <message>
        <source>the time is not after that of the line before</source>
        <translation>die Zeit liegt nicht nach der in der Zeile davor</translation>
    </message>
    <message>
        <source>holds fewer than two motor positions</source>
        <translation>enthält weniger als zwei Motorstellungen</translation>
    </message>
    <message>
        <source>a line for each time at which the motor was read</source>
        <translation>eine Zeile für jeden Zeitpunkt, zu dem der Motor ausgelesen wurde</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a number</source>
        <translation>&apos;{}&apos; muss eine Zahl sein</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be {} numbers</source>
        <translation>&apos;{}&apos; muss aus {} Zahlen bestehen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be numbers</source>
        <translation>&apos;{}&apos; muss aus Zahlen bestehen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be of length 1</source>
        <translation>&apos;{}&apos; muss die Länge 1 haben</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a covariance</source>
        <translation>&apos;{}&apos; ist keine Kovarianz</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be 0 or above</source>
        <translation>&apos;{}&apos; muss mindestens 0 sein</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be text</source>
        <translation>&apos;{}&apos; muss ein Text sein</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be an integer</source>
        <translation>&apos;{}&apos; muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a list</source>
        <translation>&apos;{}&apos; muss eine Liste sein</translation>
    </message>
    <message>
        <source>a region is not a JSON object</source>
        <translation>ein Bereich ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must ascend</source>
        <translation>&apos;{}&apos; muss aufsteigend sein</translation>
    </message>
    <message>
        <source>is not JSON: {}</source>
        <translation>ist kein JSON: {}</translation>
    </message>
    <message>
        <source>results.jsonl as alltact reconstruct wrote it</source>
        <translation>results.jsonl, wie alltact reconstruct es geschrieben hat</translation>
    </message>
    <message>
        <source>no marker is visible to estimate the force</source>
        <translation>es ist keine Marke sichtbar, aus der sich die Kraft schätzen lässt</translation>
    </message>
    <message>
        <source>the force model was not trained with frames like this one: its force is unreliable; add rows with such forces to the table and train it again</source>
        <translation>das Kraftmodell wurde nicht mit ähnlichen Bildern trainiert: Seine Kraft ist unzuverlässig; Zeilen mit solchen Kräften zur Tabelle hinzufügen und neu trainieren</translation>
    </message>
    <message>
        <source>{}, trained at an unknown date</source>
        <translation>{}, an einem unbekannten Tag trainiert</translation>
    </message>
    <message>
        <source>{}, trained {}</source>
        <translation>{}, trainiert {}</translation>
    </message>
    <message>
        <source>holds no frame with markers</source>
        <translation>enthält kein Bild mit Marken</translation>
    </message>
    <message>
        <source>results.jsonl of alltact reconstruct, or the recording itself</source>
        <translation>results.jsonl von alltact reconstruct, oder die Aufnahme selbst</translation>
    </message>
    <message>
        <source>stopped before all frames were measured</source>
        <translation>angehalten, bevor alle Bilder gemessen waren</translation>
    </message>
    <message>
        <source>measuring frame {}</source>
        <translation>Bild {} wird gemessen</translation>
    </message>
    <message>
        <source>the markers were found in no frame</source>
        <translation>die Marken wurden in keinem Bild gefunden</translation>
    </message>
    <message>
        <source>alltact reconstruct, which reports why</source>
        <translation>alltact reconstruct, das den Grund nennt</translation>
    </message>
    <message>
        <source>The gauge and the camera used different clocks: their starts are assumed to coincide.</source>
        <translation>Kraftmesser und Kamera verwendeten verschiedene Uhren: Ihre Anfänge gelten als gleichzeitig.</translation>
    </message>
    <message>
        <source>the recording&apos;s frames have no times, the gauge has only times</source>
        <translation>die Bilder der Aufnahme haben keine Zeiten, der Kraftmesser hat nur Zeiten</translation>
    </message>
    <message>
        <source>a recording of alltact record, or a gauge file with a column &apos;frame&apos;</source>
        <translation>eine Aufnahme von alltact record, oder eine Datei des Kraftmessers mit einer Spalte &apos;frame&apos;</translation>
    </message>
    <message>
        <source>{} of {} frames have a reading</source>
        <translation>{} von {} Bildern haben einen Messwert</translation>
    </message>
    <message>
        <source>there are numbers where the names of the columns are expected</source>
        <translation>statt der Namen der Spalten stehen hier Zahlen</translation>
    </message>
    <message>
        <source>the columns &apos;{}&apos; and &apos;{}&apos; both fit {}: rename one of them</source>
        <translation>die Spalten &apos;{}&apos; und &apos;{}&apos; passen beide zu {}: eine davon umbenennen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a unit of the column &apos;{}&apos;: use one of {}</source>
        <translation>&apos;{}&apos; ist keine Einheit der Spalte &apos;{}&apos;: eine von {} verwenden</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; is in {} here, in {} by its name</source>
        <translation>die Spalte &apos;{}&apos; ist hier in {}, nach ihrem Namen in {}</translation>
    </message>
    <message>
        <source>a quotation mark is not closed</source>
        <translation>ein Anführungszeichen wird nicht geschlossen</translation>
    </message>
    <message>
        <source>there is text behind a closing quotation mark</source>
        <translation>hinter einem schließenden Anführungszeichen steht Text</translation>
    </message>
    <message>
        <source>the file ends in the middle of this line</source>
        <translation>die Datei endet mitten in dieser Zeile</translation>
    </message>
    <message>
        <source>copying the file again, or a line end if this line is complete</source>
        <translation>die Datei neu kopieren, oder ein Zeilenende, falls diese Zeile vollständig ist</translation>
    </message>
    <message>
        <source>decimal points, or semicolons between the cells</source>
        <translation>Dezimalpunkte, oder Semikolons zwischen den Zellen</translation>
    </message>
    <message>
        <source>The last line of {} (line {}) has no line end: check that the file is complete.</source>
        <translation>Die letzte Zeile von {} (Zeile {}) hat kein Zeilenende: Bitte prüfen, ob die Datei vollständig ist.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has another decimal mark than the other numbers</source>
        <translation>&apos;{}&apos; hat ein anderes Dezimalzeichen als die übrigen Zahlen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not an integer in ns: name the column by its unit, as t_ms</source>
        <translation>&apos;{}&apos; ist keine ganze Zahl in ns: die Einheit im Namen der Spalte angeben, etwa t_ms</translation>
    </message>
    <message>
        <source>&apos;{}&apos; can have the day or the month first: write the year first, as in 2026-12-31</source>
        <translation>in &apos;{}&apos; kann der Tag oder der Monat vorn stehen: das Jahr zuerst schreiben, etwa 2026-12-31</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is a time of another form than those before it</source>
        <translation>&apos;{}&apos; ist eine Zeit in anderer Form als die vorigen</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; is missing; found: {}</source>
        <translation>die Spalte &apos;{}&apos; fehlt; gefunden: {}</translation>
    </message>
    <message>
        <source>semicolon-separated</source>
        <translation>mit Semikolons getrennt</translation>
    </message>
    <message>
        <source>tab-separated</source>
        <translation>mit Tabulatoren getrennt</translation>
    </message>
    <message>
        <source>comma-separated</source>
        <translation>mit Kommas getrennt</translation>
    </message>
    <message>
        <source>blank-separated</source>
        <translation>mit Leerzeichen getrennt</translation>
    </message>
    <message>
        <source>separated by &apos;{}&apos;</source>
        <translation>mit &apos;{}&apos; getrennt</translation>
    </message>
    <message>
        <source>{} with decimal commas</source>
        <translation>{}, mit Dezimalkommas</translation>
    </message>
    <message>
        <source>{} from the time stamps of &apos;{}&apos;</source>
        <translation>{} aus den Zeitstempeln von &apos;{}&apos;</translation>
    </message>
    <message>
        <source>{} from &apos;{}&apos; in {} since 1970</source>
        <translation>{} aus &apos;{}&apos; in {} seit 1970</translation>
    </message>
    <message>
        <source>{} from &apos;{}&apos; in {}</source>
        <translation>{} aus &apos;{}&apos; in {}</translation>
    </message>
    <message>
        <source>{} from &apos;{}&apos;</source>
        <translation>{} aus &apos;{}&apos;</translation>
    </message>
    <message>
        <source>Read {} as {}: {}.</source>
        <translation>{} gelesen als Tabelle, {}: {}.</translation>
    </message>
    <message>
        <source>this is a workbook of a spreadsheet program, not a text</source>
        <translation>dies ist eine Arbeitsmappe einer Tabellenkalkulation, kein Text</translation>
    </message>
    <message>
        <source>this is a PDF, not a text</source>
        <translation>dies ist ein PDF, kein Text</translation>
    </message>
    <message>
        <source>saving the table as CSV</source>
        <translation>die Tabelle als CSV speichern</translation>
    </message>
    <message>
        <source>the file ends in the middle of a character: it is not complete</source>
        <translation>die Datei endet mitten in einem Zeichen: sie ist unvollständig</translation>
    </message>
    <message>
        <source>holds a zero byte: this is no text, or was not written to its end</source>
        <translation>enthält ein Nullbyte: dies ist kein Text oder wurde nicht zu Ende geschrieben</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a date or time that exists</source>
        <translation>&apos;{}&apos; ist kein Datum und keine Uhrzeit, die es gibt</translation>
    </message>
    <message>
        <source>&apos;{}&apos; can be hours and minutes, or minutes and seconds</source>
        <translation>&apos;{}&apos; können Stunden und Minuten sein, oder Minuten und Sekunden</translation>
    </message>
    <message>
        <source>a table of motor positions by time, with time_ns and turns</source>
        <translation>eine Tabelle von Motorstellungen nach der Zeit, mit time_ns und turns</translation>
    </message>
    <message>
        <source>the gauge&apos;s times run from {:g} to {:g} s, those of the images from {:g} to {:g} s</source>
        <translation>die Zeiten des Kraftmessers reichen von {} bis {} s, die der Bilder von {} bis {} s</translation>
    </message>
    <message>
        <source>{}: the unit is wrong by a factor of {:g}</source>
        <translation>{}: die Einheit ist um den Faktor {} falsch</translation>
    </message>
    <message>
        <source>naming the column &apos;{}&apos; &apos;t_{}&apos; if its times are in {}</source>
        <translation>die Spalte &apos;{}&apos; in &apos;t_{}&apos; umbenennen, falls ihre Zeiten in {} sind</translation>
    </message>
    <message>
        <source>no frame has a reading: the gauge&apos;s file names &apos;{}&apos;, the recording &apos;{}&apos;</source>
        <translation>kein Bild hat einen Messwert: die Datei des Kraftmessers nennt &apos;{}&apos;, die Aufnahme &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the names of the images in the column &apos;frame&apos;</source>
        <translation>die Namen der Bilder in der Spalte &apos;frame&apos;</translation>
    </message>
    <message>
        <source>no frame has a reading: the readings are {:.3g} s apart, at most {} s can be interpolated</source>
        <translation>kein Bild hat einen Messwert: die Messwerte sind {} s auseinander, höchstens {} s lassen sich interpolieren</translation>
    </message>
    <message>
        <source>a higher rate of the gauge</source>
        <translation>eine höhere Messrate des Kraftmessers</translation>
    </message>
    <message>
        <source>no frame has a reading: the gauge&apos;s times run from {:g} to {:g} s, those of the images on its clock from {:g} to {:g} s</source>
        <translation>kein Bild hat einen Messwert: die Zeiten des Kraftmessers reichen von {} bis {} s, die der Bilder auf seiner Uhr von {} bis {} s</translation>
    </message>
    <message>
        <source>a gauge that records with the camera, or --gauge-shift-s</source>
        <translation>einen Kraftmesser, der gleichzeitig mit der Kamera aufzeichnet, oder --gauge-shift-s</translation>
    </message>
    <message>
        <source>a table whose head names t_s (or frame), and fx_n and fy_n or force_n</source>
        <translation>eine Tabelle, deren Kopfzeile t_s (oder frame) und fx_n und fy_n oder force_n nennt</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is neither 1 nor 0</source>
        <translation>&apos;{}&apos; ist weder 1 noch 0</translation>
    </message>
    <message>
        <source>the time &apos;{}&apos; is that of line {}, too</source>
        <translation>die Zeit &apos;{}&apos; steht auch in Zeile {}</translation>
    </message>
    <message>
        <source>the time &apos;{}&apos; comes after &apos;{}&apos; of line {}, which is later</source>
        <translation>die Zeit &apos;{}&apos; folgt auf die spätere Zeit &apos;{}&apos; in Zeile {}</translation>
    </message>
    <message>
        <source>the name of the frame is missing</source>
        <translation>der Name des Bilds fehlt</translation>
    </message>
    <message>
        <source>the frame &apos;{}&apos; is that of line {}, too</source>
        <translation>das Bild &apos;{}&apos; steht auch in Zeile {}</translation>
    </message>
    <message>
        <source>a table whose head names u0, v0, ..., fx_n, fy_n; alltact force --collect makes one</source>
        <translation>eine Tabelle, deren Kopfzeile u0, v0, ..., fx_n, fy_n nennt; alltact force --collect erzeugt eine</translation>
    </message>
    <message>
        <source>the gauge&apos;s file holds no reading</source>
        <translation>die Datei des Kraftmessers enthält keinen Messwert</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; appears twice</source>
        <translation>die Spalte &apos;{}&apos; kommt zweimal vor</translation>
    </message>
    <message>
        <source>the contact position has only one of along_mm and across_mm</source>
        <translation>die Kontaktposition hat nur eine der Spalten along_mm und across_mm</translation>
    </message>
    <message>
        <source>has {} cells, not {}</source>
        <translation>hat {} Zellen, nicht {}</translation>
    </message>
    <message>
        <source>truth.json of a scene whose pushes have forces</source>
        <translation>truth.json einer Szene, in der mit Kräften gedrückt wird</translation>
    </message>
    <message>
        <source>holds no frames of a simulation</source>
        <translation>enthält keine Bilder einer Simulation</translation>
    </message>
    <message>
        <source>holds a frame without a name</source>
        <translation>enthält ein Bild ohne Namen</translation>
    </message>
    <message>
        <source>contains no contact force</source>
        <translation>enthält keine Kontaktkraft</translation>
    </message>
    <message>
        <source>the table has no column &apos;{}&apos;</source>
        <translation>die Tabelle hat keine Spalte &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; is the same in all rows</source>
        <translation>die Spalte &apos;{}&apos; ist in allen Zeilen gleich</translation>
    </message>
    <message>
        <source>--split block, or several values</source>
        <translation>--split block, oder mehrere Werte</translation>
    </message>
    <message>
        <source>there are no columns u0, v0, ... of markers</source>
        <translation>es gibt keine Spalten u0, v0, ... von Marken</translation>
    </message>
    <message>
        <source>there are markers up to number {}; the highest may be {}</source>
        <translation>es gibt Marken bis zur Nummer {}; die höchste darf {} sein</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; is missing, though there is a marker {}</source>
        <translation>die Spalte &apos;{}&apos; fehlt, obwohl es eine Marke {} gibt</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; is missing, though other markers have one</source>
        <translation>die Spalte &apos;{}&apos; fehlt, obwohl andere Marken eine solche haben</translation>
    </message>
    <message>
        <source>the table is empty</source>
        <translation>die Tabelle ist leer</translation>
    </message>
    <message>
        <source>{}, column {}</source>
        <translation>{}, Spalte {}</translation>
    </message>
    <message>
        <source>removing the line, or entering what was measured</source>
        <translation>die Zeile entfernen, oder eintragen, was gemessen wurde</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is beyond the measurable range</source>
        <translation>&apos;{}&apos; liegt außerhalb des messbaren Bereichs</translation>
    </message>
    <message>
        <source>no marker was seen</source>
        <translation>keine Marke war zu sehen</translation>
    </message>
    <message>
        <source>{} rows are too few to train with</source>
        <translation>{} Zeilen sind zu wenige für das Training</translation>
    </message>
    <message>
        <source>at least {}, better several hundred</source>
        <translation>mindestens {}, besser einige Hundert</translation>
    </message>
    <message>
        <source>the force &apos;{}&apos; is the same in all rows</source>
        <translation>die Kraft &apos;{}&apos; ist in allen Zeilen gleich</translation>
    </message>
    <message>
        <source>pressing with different forces, or leaving the column fz_n out</source>
        <translation>mit verschiedenen Kräften drücken, oder die Spalte fz_n weglassen</translation>
    </message>
    <message>
        <source>no marker ever moves</source>
        <translation>keine Marke bewegt sich je</translation>
    </message>
    <message>
        <source>a table of this recording&apos;s markers</source>
        <translation>eine Tabelle der Marken dieser Aufnahme</translation>
    </message>
    <message>
        <source>a table of this finger&apos;s markers</source>
        <translation>eine Tabelle der Marken dieses Fingers</translation>
    </message>
    <message>
        <source>the finger has no markers to estimate a force from</source>
        <translation>der Finger hat keine Marken, aus denen sich eine Kraft schätzen ließe</translation>
    </message>
    <message>
        <source>a finger with markers</source>
        <translation>ein Finger mit Marken</translation>
    </message>
    <message>
        <source>the finger has no reference, so the rest positions of its markers are unknown</source>
        <translation>der Finger hat keine Referenz, also sind die Ruhepositionen seiner Marken unbekannt</translation>
    </message>
    <message>
        <source>alltact reference</source>
        <translation>alltact reference</translation>
    </message>
    <message>
        <source>the table has {} markers, the finger has {}</source>
        <translation>die Tabelle hat {} Marken, der Finger hat {}</translation>
    </message>
    <message>
        <source>the table&apos;s markers belong to another finger: in every row they are {:.0f} px or more from this finger&apos;s rest positions</source>
        <translation>die Marken der Tabelle gehören zu einem anderen Finger: In jeder Zeile liegen sie {:.0f} px oder mehr von den Ruhepositionen dieses Fingers entfernt</translation>
    </message>
    <message>
        <source>there is no force model to revert</source>
        <translation>es gibt kein Kraftmodell, das sich zurücknehmen ließe</translation>
    </message>
    <message>
        <source>the finger has no force model yet</source>
        <translation>der Finger hat noch kein Kraftmodell</translation>
    </message>
    <message>
        <source>giving the table to train with</source>
        <translation>die Tabelle angeben, mit der trainiert werden soll</translation>
    </message>
    <message>
        <source>the force model does not name its table</source>
        <translation>das Kraftmodell nennt seine Tabelle nicht</translation>
    </message>
    <message>
        <source>stopped before there was a force model</source>
        <translation>angehalten, bevor es ein Kraftmodell gab</translation>
    </message>
    <message>
        <source>the mean</source>
        <translation>der Mittelwert</translation>
    </message>
    <message>
        <source>ridge</source>
        <translation>die Ridge-Regression</translation>
    </message>
    <message>
        <source>the quadratic one</source>
        <translation>das quadratische Modell</translation>
    </message>
    <message>
        <source>the network</source>
        <translation>das neuronale Netz</translation>
    </message>
    <message>
        <source>creep is an input only where the table has times</source>
        <translation>Kriechen ist nur dann eine Eingangsgröße, wenn die Tabelle Zeiten hat</translation>
    </message>
    <message>
        <source>a table with a column t_s, or leaving creep out</source>
        <translation>eine Tabelle mit einer Spalte t_s, oder das Kriechen weglassen</translation>
    </message>
    <message>
        <source>training {}, leaving out one block at a time</source>
        <translation>Training, jeweils ohne einen der Blöcke: {}</translation>
    </message>
    <message>
        <source>testing {} by frames and with shuffled forces</source>
        <translation>Prüfung nach Bildern und mit vertauschten Kräften: {}</translation>
    </message>
    <message>
        <source>The network does not beat ridge: their errors are {:.1f} % and {:.1f} % of the forces&apos; standard deviation.</source>
        <translation>Das neuronale Netz ist nicht besser als die Ridge-Regression: Ihre Fehler betragen {:.1f} % und {:.1f} % der Standardabweichung der Kräfte.</translation>
    </message>
    <message>
        <source>The chosen model does not beat the table&apos;s mean: these markers do not show the force.</source>
        <translation>Das gewählte Modell ist nicht besser als der Mittelwert der Tabelle: Aus diesen Marken lässt sich die Kraft nicht ermitteln.</translation>
    </message>
    <message>
        <source>Nothing beats the mean of the table: these markers do not show the force.</source>
        <translation>Nichts ist besser als der Mittelwert der Tabelle: Aus diesen Marken lässt sich die Kraft nicht ermitteln.</translation>
    </message>
    <message>
        <source>The table has no column &apos;block&apos;: {} sections of consecutive rows were held out.</source>
        <translation>Die Tabelle hat keine Spalte &apos;block&apos;: {} Abschnitte aufeinanderfolgender Zeilen wurden ausgelassen.</translation>
    </message>
    <message>
        <source>Only {} groups could be held out: errors and intervals are rough.</source>
        <translation>Nur {} Gruppen ließen sich auslassen: Fehler und Intervalle sind grob.</translation>
    </message>
    <message>
        <source>without a depth there is no position on the contact face</source>
        <translation>ohne Tiefe gibt es keine Position auf der Kontaktfläche</translation>
    </message>
    <message>
        <source>stopped before the experiments ended</source>
        <translation>angehalten, bevor die Experimente zu Ende waren</translation>
    </message>
    <message>
        <source>{}: frame {} of {}</source>
        <translation>{}: Bild {} von {}</translation>
    </message>
    <message>
        <source>no frame gives a value for the experiment</source>
        <translation>kein Bild liefert einen Wert für das Experiment</translation>
    </message>
    <message>
        <source>contact position, at 9 x 3 points of the face</source>
        <translation>Kontaktposition, an 9 x 3 Punkten der Fläche</translation>
    </message>
    <message>
        <source>rotation of a held bar</source>
        <translation>Drehung eines gehaltenen Stabs</translation>
    </message>
    <message>
        <source>smallest detectable depth of a ball</source>
        <translation>kleinste erkennbare Tiefe einer Kugel</translation>
    </message>
    <message>
        <source>smallest detectable force on every face</source>
        <translation>kleinste erkennbare Kraft auf jeder Fläche</translation>
    </message>
    <message>
        <source>push direction, one of 8 sides</source>
        <translation>Druckrichtung, eine von 8 Seiten</translation>
    </message>
    <message>
        <source>one untouched image against a recording of all poses</source>
        <translation>ein unberührtes Bild gegenüber einer Aufnahme aller Haltungen</translation>
    </message>
    <message>
        <source>relief of an M8 thread, against a single reference</source>
        <translation>Relief eines M8-Gewindes, gegenüber einer einzigen Referenz</translation>
    </message>
    <message>
        <source>relief of a USB plug, against a single reference</source>
        <translation>Relief eines USB-Steckers, gegenüber einer einzigen Referenz</translation>
    </message>
    <message>
        <source>time for each step of a frame, full HD with 24 dots</source>
        <translation>Zeit für jeden Schritt eines Bildes, in Full HD mit 24 Punkten</translation>
    </message>
    <message>
        <source>there is no experiment &apos;{}&apos;</source>
        <translation>es gibt kein Experiment &apos;{}&apos;</translation>
    </message>
    <message>
        <source>smallest force detected on the contact face, all heights</source>
        <translation>kleinste erkannte Kraft auf der Kontaktfläche, alle Höhen</translation>
    </message>
    <message>
        <source>smallest force detected on the back, all heights</source>
        <translation>kleinste erkannte Kraft auf dem Rücken, alle Höhen</translation>
    </message>
    <message>
        <source>smallest force detected on the upper side, all heights</source>
        <translation>kleinste erkannte Kraft auf der oberen Seite, alle Höhen</translation>
    </message>
    <message>
        <source>smallest force detected on the lower side, all heights</source>
        <translation>kleinste erkannte Kraft auf der unteren Seite, alle Höhen</translation>
    </message>
    <message>
        <source>smallest depth detected, {:.0f} mm from the base</source>
        <translation>kleinste erkannte Tiefe, {:.0f} mm vom Fuß</translation>
    </message>
    <message>
        <source>Depths double from 0.01 mm on, so that the smallest is between a value and its half</source>
        <translation>Die Tiefen verdoppeln sich ab 0,01 mm, sodass die kleinste zwischen einem Wert und seiner Hälfte liegt</translation>
    </message>
    <message>
        <source>All heights are beyond {:.0f} mm, where the paper reports less than 2 N; the body in the scene is rubber of Shore 40 A, the paper&apos;s silicone differs</source>
        <translation>Alle Höhen liegen jenseits von {:.0f} mm, wo die Veröffentlichung weniger als 2 N nennt; der Körper in der Szene ist Gummi von Shore 40 A, das Silikon der Veröffentlichung ist ein anderes</translation>
    </message>
    <message>
        <source>pushes with the correct side of 8</source>
        <translation>Druckversuche mit richtig erkannter Seite von 8</translation>
    </message>
    <message>
        <source>direction of a push in the image, mean error</source>
        <translation>Druckrichtung im Bild, mittlerer Fehler</translation>
    </message>
    <message>
        <source>direction of a push in the image, maximum error</source>
        <translation>Druckrichtung im Bild, größter Fehler</translation>
    </message>
    <message>
        <source>{} pushes, by the true motion of the dots in the image; those near a border of two sides count like all others</source>
        <translation>{} Druckversuche, nach der wahren Bewegung der Punkte im Bild; die nahe der Grenze zweier Seiten zählen wie alle anderen</translation>
    </message>
    <message>
        <source>frames under 40 px, nearest recorded image</source>
        <translation>Bilder unter 40 px, nächstes aufgenommenes Bild</translation>
    </message>
    <message>
        <source>frames under 40 px, one reference</source>
        <translation>Bilder unter 40 px, eine Referenz</translation>
    </message>
    <message>
        <source>depth without contact, one reference</source>
        <translation>Tiefe ohne Kontakt, eine Referenz</translation>
    </message>
    <message>
        <source>depth without contact, nearest recorded image</source>
        <translation>Tiefe ohne Kontakt, nächstes aufgenommenes Bild</translation>
    </message>
    <message>
        <source>depth without contact, local regression</source>
        <translation>Tiefe ohne Kontakt, lokale Regression</translation>
    </message>
    <message>
        <source>The number of frames near a single reference depends on how far the finger moves; here the scene sets this, in the paper its own recording</source>
        <translation>Die Zahl der Bilder nahe einer einzelnen Referenz hängt davon ab, wie weit sich der Finger bewegt; hier bestimmt das die Szene, in der Veröffentlichung deren eigene Aufnahme</translation>
    </message>
    <message>
        <source>relief, mean depth error, straight</source>
        <translation>Relief, mittlerer Tiefenfehler, gerade</translation>
    </message>
    <message>
        <source>relief, mean depth error, bent</source>
        <translation>Relief, mittlerer Tiefenfehler, gebogen</translation>
    </message>
    <message>
        <source>the same straight, single reference</source>
        <translation>dasselbe, gerade, eine Referenz</translation>
    </message>
    <message>
        <source>the same bent, single reference</source>
        <translation>dasselbe, gebogen, eine Referenz</translation>
    </message>
    <message>
        <source>edges and global shape, median</source>
        <translation>Kanten und Gesamtform, Median</translation>
    </message>
    <message>
        <source>markers and reference, median</source>
        <translation>Marken und Referenz, Median</translation>
    </message>
    <message>
        <source>local depth and contacts, median</source>
        <translation>lokale Tiefe und Kontakte, Median</translation>
    </message>
    <message>
        <source>entire frame, median</source>
        <translation>gesamtes Bild, Median</translation>
    </message>
    <message>
        <source>Times were measured on this computer, those of the paper on its own; the finger uses the demonstration&apos;s mapping and 24 recorded poses</source>
        <translation>Zeiten von diesem Rechner, die der Veröffentlichung von deren eigenem; der Finger misst mit der Abbildung der Vorführung und 24 aufgenommenen Haltungen</translation>
    </message>
    <message>
        <source>position, mean error within +-20 mm of the middle</source>
        <translation>Position, mittlerer Fehler innerhalb von +-20 mm um die Mitte</translation>
    </message>
    <message>
        <source>position, mean error at the tip</source>
        <translation>Position, mittlerer Fehler an der Spitze</translation>
    </message>
    <message>
        <source>position, greatest error</source>
        <translation>Position, größter Fehler</translation>
    </message>
    <message>
        <source>contacts found</source>
        <translation>gefundene Kontakte</translation>
    </message>
    <message>
        <source>angle, mean error</source>
        <translation>Winkel, mittlerer Fehler</translation>
    </message>
    <message>
        <source>angle, greatest error</source>
        <translation>Winkel, größter Fehler</translation>
    </message>
    <message>
        <source>bars whose angle is measured</source>
        <translation>Stäbe mit gemessenem Winkel</translation>
    </message>
    <message>
        <source>The lesser of the paper&apos;s two figures is next to the mean error, the greater one next to the greatest error</source>
        <translation>Die kleinere der beiden Zahlen der Veröffentlichung steht neben dem mittleren Fehler, die größere neben dem größten</translation>
    </message>
    <message>
        <source>depth inside contacts, mean error at {} lux</source>
        <translation>Tiefe in Kontakten, mittlerer Fehler bei {} Lux</translation>
    </message>
    <message>
        <source>the source paper&apos;s method</source>
        <translation>das Verfahren der Veröffentlichung</translation>
    </message>
    <message>
        <source>an image in which the entire face is brighter than its side faces, or our own method</source>
        <translation>ein Bild, in dem die gesamte Fläche heller ist als ihre Seitenflächen, oder unser eigenes Verfahren</translation>
    </message>
    <message>
        <source>the binarised image shows both edges of the face in {} of {} columns; at least a fifth is needed</source>
        <translation>das binarisierte Bild zeigt beide Kanten der Fläche in {} von {} Spalten; mindestens ein Fünftel ist nötig</translation>
    </message>
    <message>
        <source>the edges of the face give no distance</source>
        <translation>aus den Kanten der Fläche ergibt sich kein Abstand</translation>
    </message>
    <message>
        <source>our own method, which needs no dots, or a recording of a finger that has them</source>
        <translation>unser eigenes Verfahren, das keine Punkte braucht, oder eine Aufnahme eines Fingers, der welche hat</translation>
    </message>
    <message>
        <source>alltact reference with a video of the untouched finger bending</source>
        <translation>alltact reference mit einem Video des unberührten Fingers beim Biegen</translation>
    </message>
    <message>
        <source>the source paper&apos;s method chooses its reference by the markers, and this finger has none</source>
        <translation>das Verfahren der Veröffentlichung wählt seine Referenz nach den Marken, und dieser Finger hat keine</translation>
    </message>
    <message>
        <source>the source paper&apos;s method sorts two full rows, and {} of this finger&apos;s dots are missing</source>
        <translation>das Verfahren der Veröffentlichung sortiert zwei vollständige Reihen, und {} der Punkte dieses Fingers fehlen</translation>
    </message>
    <message>
        <source>fewer than two dots of a row are visible; the source paper&apos;s method cannot infer the others: uncover and light the dots on the side faces</source>
        <translation>von einer Reihe sind weniger als zwei Punkte sichtbar; das Verfahren der Veröffentlichung kann die übrigen nicht erschließen: die Punkte auf den Seitenflächen freilegen und beleuchten</translation>
    </message>
    <message>
        <source>stopped while the recording was read</source>
        <translation>angehalten, während die Aufnahme gelesen wurde</translation>
    </message>
    <message>
        <source>reading the recording as the source paper does</source>
        <translation>die Aufnahme wird wie in der Veröffentlichung gelesen</translation>
    </message>
    <message>
        <source>the reference recording</source>
        <translation>die Referenzaufnahme</translation>
    </message>
    <message>
        <source>recording it anew with this camera</source>
        <translation>sie mit dieser Kamera neu aufnehmen</translation>
    </message>
    <message>
        <source>the source paper&apos;s method finds face and markers in none of {} frames</source>
        <translation>das Verfahren der Veröffentlichung findet Fläche und Marken in keinem von {} Bildern</translation>
    </message>
    <message>
        <source>our own method, or a recording with brighter dots</source>
        <translation>unser eigenes Verfahren, oder eine Aufnahme mit helleren Punkten</translation>
    </message>
    <message>
        <source>{} dots were found next to the face: too few to sort into two rows</source>
        <translation>{} Punkte wurden neben der Fläche gefunden: zu wenige, um sie in zwei Reihen zu sortieren</translation>
    </message>
    <message>
        <source>a network exported with fixed sizes, one image at a time and opset 11 or 12, or --marker-network own</source>
        <translation>ein neuronales Netz, exportiert mit festen Größen, einem Bild je Durchgang und opset 11 oder 12, oder --marker-network own</translation>
    </message>
    <message>
        <source>OpenCV cannot run this network</source>
        <translation>OpenCV kann dieses neuronale Netz nicht ausführen</translation>
    </message>
    <message>
        <source>this network outputs {} for {}, which are neither dots nor boxes</source>
        <translation>dieses neuronale Netz gibt {} für {} aus, was weder Punkte noch Kästen sind</translation>
    </message>
    <message>
        <source>this network outputs numbers that are not finite</source>
        <translation>dieses neuronale Netz gibt Zahlen aus, die nicht endlich sind</translation>
    </message>
    <message>
        <source>the file with this network&apos;s expected output is missing</source>
        <translation>die Datei mit der erwarteten Ausgabe dieses neuronalen Netzes fehlt</translation>
    </message>
    <message>
        <source>training it again, which writes both files</source>
        <translation>es neu trainieren; dabei werden beide Dateien geschrieben</translation>
    </message>
    <message>
        <source>the image must have the size of the network&apos;s input, {} x {}</source>
        <translation>das Bild muss die Größe der Eingabe des neuronalen Netzes haben, {} x {}</translation>
    </message>
    <message>
        <source>this network takes {}, not one image of 1 or 3 channels and a fixed size of {} to {} px a side</source>
        <translation>dieses neuronale Netz verlangt {}, nicht ein einzelnes Bild mit 1 oder 3 Kanälen und einer festen Größe von {} bis {} px je Seite</translation>
    </message>
    <message>
        <source>OpenCV cannot read this network (opset {}; it supports those up to 12 well)</source>
        <translation>OpenCV kann dieses neuronale Netz nicht lesen (opset {}; gut unterstützt bis 12)</translation>
    </message>
    <message>
        <source>the network and its .yaml of the same training, or exporting it with opset 11 or 12</source>
        <translation>das neuronale Netz und seine .yaml aus demselben Training, oder es mit opset 11 oder 12 exportieren</translation>
    </message>
    <message>
        <source>the network outputs {} numbers where its .yaml has {}</source>
        <translation>das neuronale Netz gibt {} Zahlen aus, wo seine .yaml {} hat</translation>
    </message>
    <message>
        <source>for a known image the network&apos;s numbers deviate by up to {:.3g} from its .yaml, and {:.3g} is allowed</source>
        <translation>bei einem bekannten Bild weichen die Zahlen des neuronalen Netzes um bis zu {:.3g} von seiner .yaml ab, erlaubt ist {:.3g}</translation>
    </message>
    <message>
        <source>this is not a network in the ONNX format, or it is incomplete or damaged</source>
        <translation>dies ist kein neuronales Netz im ONNX-Format, oder es ist unvollständig oder beschädigt</translation>
    </message>
    <message>
        <source>copying or exporting the file again</source>
        <translation>die Datei neu kopieren oder exportieren</translation>
    </message>
    <message>
        <source>subpixel edges</source>
        <translation>Kanten subpixelgenau</translation>
    </message>
    <message>
        <source>integer-pixel edges</source>
        <translation>Kanten auf ganze Pixel</translation>
    </message>
    <message>
        <source>&apos;crossing&apos; measures the finger&apos;s bend, and so press positions, several times more accurately</source>
        <translation>&apos;crossing&apos; misst die Biegung des Fingers, und damit die Position eines Eindrucks, um ein Mehrfaches genauer</translation>
    </message>
    <message>
        <source>&apos;crossing&apos; takes a little longer</source>
        <translation>&apos;crossing&apos; dauert etwas länger</translation>
    </message>
    <message numerus="yes">
        <source>edges from {} columns</source>
        <comment>edges from {} column</comment>
        <translation>
            <numerusform>Kanten aus {} Spalte</numerusform>
            <numerusform>Kanten aus {} Spalten</numerusform>
        </translation>
    </message>
    <message>
        <source>more reduce the noise of dark images; beyond 16 a bent finger&apos;s edge is no longer straight within them</source>
        <translation>mehr unterdrücken das Rauschen dunkler Bilder; über 16 ist die Kante eines gebogenen Fingers in ihnen nicht mehr gerade</translation>
    </message>
    <message>
        <source>fewer make more positions, to each of which the curve must be fitted</source>
        <translation>weniger ergeben mehr Positionen, an die jeweils die Kurve angepasst werden muss</translation>
    </message>
    <message>
        <source>edge curve of degree {}</source>
        <translation>Kantenkurve vom Grad {}</translation>
    </message>
    <message>
        <source>higher follows sharper bends; too high follows noise where the edge is hidden</source>
        <translation>höhere Werte folgen schärferen Biegungen; zu hohe folgen dem Rauschen, wo die Kante verdeckt ist</translation>
    </message>
    <message>
        <source>higher makes the fit slower</source>
        <translation>höhere Werte verlängern die Anpassung</translation>
    </message>
    <message>
        <source>how the engraved dots are found and numbered: spots tracked by the finger&apos;s motion, the source paper&apos;s two sorted rows, or a convolutional network in every frame</source>
        <translation>wie die gravierten Punkte gefunden und nummeriert werden: Flecken, verfolgt nach der Bewegung des Fingers, die zwei sortierten Reihen der Veröffentlichung oder ein neuronales Faltungsnetz in jedem Bild</translation>
    </message>
    <message>
        <source>markers tracked as spots</source>
        <translation>Marken als Flecken verfolgt</translation>
    </message>
    <message>
        <source>markers as two sorted rows</source>
        <translation>Marken als zwei sortierte Reihen</translation>
    </message>
    <message>
        <source>markers found by a network</source>
        <translation>Marken von einem Netz gefunden</translation>
    </message>
    <message>
        <source>&apos;network&apos; finds more dots that are worn, dark or badly lit; &apos;paper&apos; loses its numbers where dots are hidden</source>
        <translation>&apos;network&apos; findet mehr Punkte, die abgenutzt, dunkel oder schlecht beleuchtet sind; &apos;paper&apos; verliert seine Nummern, wo Punkte verdeckt sind</translation>
    </message>
    <message>
        <source>&apos;network&apos; takes many times as long</source>
        <translation>&apos;network&apos; dauert um ein Vielfaches länger</translation>
    </message>
    <message>
        <source>the network for marker-method network, and for paper where one is named: an ONNX file, also a detector such as YOLO11</source>
        <translation>das neuronale Netz für marker-method network, und für paper, wo eines genannt ist: eine ONNX-Datei, auch ein Detektor wie YOLO11</translation>
    </message>
    <message>
        <source>compared with the image at rest</source>
        <translation>verglichen mit dem Bild in Ruhe</translation>
    </message>
    <message>
        <source>compared with the nearest image</source>
        <translation>verglichen mit dem ähnlichsten Bild</translation>
    </message>
    <message>
        <source>compared with several images</source>
        <translation>verglichen mit mehreren Bildern</translation>
    </message>
    <message>
        <source>&apos;local&apos; measures depth of a bent finger correctly between the recorded poses; &apos;single&apos; only at rest</source>
        <translation>&apos;local&apos; misst die Tiefe eines gebogenen Fingers zwischen den aufgenommenen Haltungen richtig; &apos;single&apos; nur in Ruhe</translation>
    </message>
    <message>
        <source>&apos;local&apos; adds up several images instead of one</source>
        <translation>&apos;local&apos; summiert mehrere Bilder statt eines</translation>
    </message>
    <message>
        <source>light corrected</source>
        <translation>Licht korrigiert</translation>
    </message>
    <message>
        <source>light as recorded</source>
        <translation>Licht wie in der Aufnahme</translation>
    </message>
    <message>
        <source>&apos;corrected&apos; corrects depth when the room or the lamp changes</source>
        <translation>&apos;corrected&apos; korrigiert die Tiefe, wenn sich der Raum oder die Lampe ändert</translation>
    </message>
    <message>
        <source>&apos;corrected&apos; analyses the untouched skin once</source>
        <translation>&apos;corrected&apos; wertet die unberührte Haut einmal aus</translation>
    </message>
    <message>
        <source>no smoothing</source>
        <translation>ohne Glättung</translation>
    </message>
    <message>
        <source>smoothing of {:g} px</source>
        <translation>Glättung von {} px</translation>
    </message>
    <message>
        <source>more reduces the noise of a smooth contact and rounds off edges and threads</source>
        <translation>mehr verringert das Rauschen eines glatten Kontakts und rundet Kanten und Gewinde ab</translation>
    </message>
    <message>
        <source>more takes longer, none is fastest</source>
        <translation>mehr dauert länger, ohne ist am schnellsten</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>der Wert ist leer</translation>
    </message>
    <message>
        <source>could not write the gauge&apos;s readings</source>
        <translation>die Messwerte des Kraftmessers ließen sich nicht schreiben</translation>
    </message>
    <message>
        <source>The gauge is back.</source>
        <translation>Der Kraftmesser ist wieder da.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a direction</source>
        <translation>&apos;{}&apos; ist keine Richtung</translation>
    </message>
    <message>
        <source>x, -y, 0.6,0.8,0 or, for several values, x/y/z</source>
        <translation>x, -y, 0.6,0.8,0 oder, bei mehreren Werten, x/y/z</translation>
    </message>
    <message>
        <source>such as &apos;id=3 at=1 type=s16 scale=0.01 unit=N&apos;, or a table with at, type, scale, zero, unit</source>
        <translation>etwa &apos;id=3 at=1 type=s16 scale=0.01 unit=N&apos;, oder eine Tabelle mit at, type, scale, zero, unit</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not describe a gauge&apos;s report</source>
        <translation>&apos;{}&apos; beschreibt keinen Report eines Kraftmessers</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a valid {}</source>
        <translation>&apos;{}&apos; ist kein gültiger Wert für {}</translation>
    </message>
    <message>
        <source>the table does not describe a gauge&apos;s report</source>
        <translation>die Tabelle beschreibt keinen Report eines Kraftmessers</translation>
    </message>
    <message>
        <source>The device sends other reports than described. Try: check the id and length.</source>
        <translation>Das Gerät sendet andere Reports als beschrieben. Abhilfe: Kennung (id) und Länge prüfen.</translation>
    </message>
    <message>
        <source>there is no gauge &apos;{}&apos;</source>
        <translation>es gibt keinen Kraftmesser &apos;{}&apos;</translation>
    </message>
    <message>
        <source>mark10, imada or sauter, or the question and the speed</source>
        <translation>mark10, imada oder sauter, oder die Anfrage und die Geschwindigkeit</translation>
    </message>
    <message>
        <source>there are {} directions for {} values</source>
        <translation>es gibt {} Richtungen für {} Werte</translation>
    </message>
    <message>
        <source>one for each, as x/y/z</source>
        <translation>eine für jeden, wie x/y/z</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a text with \r, \n, \xHH</source>
        <translation>&apos;{}&apos; ist kein Text mit \r, \n, \xHH</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a unit of force</source>
        <translation>&apos;{}&apos; ist keine Krafteinheit</translation>
    </message>
    <message>
        <source>N, mN, kN, g, kgf, lbf or ozf</source>
        <translation>N, mN, kN, g, kgf, lbf oder ozf</translation>
    </message>
    <message>
        <source>the unit of a HID gauge belongs in its report&apos;s description</source>
        <translation>bei einem HID-Kraftmesser gehört die Einheit in die Beschreibung seines Reports</translation>
    </message>
    <message>
        <source>unit= in the report&apos;s description</source>
        <translation>unit= in der Beschreibung des Reports</translation>
    </message>
    <message>
        <source>model, speed and question apply only to a serial gauge</source>
        <translation>Modell, Geschwindigkeit und Anfrage gelten nur für einen seriellen Kraftmesser</translation>
    </message>
    <message>
        <source>serial:/dev/ttyUSB0</source>
        <translation>serial:/dev/ttyUSB0</translation>
    </message>
    <message>
        <source>the position of the force in the gauge&apos;s reports is not specified</source>
        <translation>es ist nicht angegeben, wo in den Reports des Kraftmessers die Kraft steht</translation>
    </message>
    <message>
        <source>a report is specified for a gauge that is not a HID device</source>
        <translation>für einen Kraftmesser, der kein HID-Gerät ist, ist ein Report angegeben</translation>
    </message>
    <message>
        <source>hid:DEVICE and &apos;id=3 at=1 type=s16 scale=0.01 unit=N&apos;</source>
        <translation>hid:DEVICE und &apos;id=3 at=1 type=s16 scale=0.01 unit=N&apos;</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a gauge</source>
        <translation>&apos;{}&apos; ist kein Kraftmesser</translation>
    </message>
    <message>
        <source>typed, serial:/dev/ttyUSB0 or hid:DEVICE</source>
        <translation>typed, serial:/dev/ttyUSB0 oder hid:DEVICE</translation>
    </message>
    <message>
        <source>{} lines from the gauge were not readings</source>
        <translation>{} Zeilen des Kraftmessers waren keine Messwerte</translation>
    </message>
    <message>
        <source>The gauge does not answer to &apos;{}&apos;. Try: another speed, another question, its settings for the serial line.</source>
        <translation>Der Kraftmesser antwortet nicht auf &apos;{}&apos;. Abhilfe: eine andere Geschwindigkeit, eine andere Anfrage, seine Einstellungen für die serielle Schnittstelle.</translation>
    </message>
    <message>
        <source>make this user a member of the group dialout (sudo usermod -aG dialout $USER) and log in again</source>
        <translation>diesen Benutzer zum Mitglied der Gruppe dialout machen (sudo usermod -aG dialout $USER) und neu anmelden</translation>
    </message>
    <message>
        <source>another program uses it</source>
        <translation>ein anderes Programm benutzt sie</translation>
    </message>
    <message>
        <source>close that program</source>
        <translation>dieses Programm schließen</translation>
    </message>
    <message>
        <source>there is no such serial line</source>
        <translation>es gibt keine solche serielle Schnittstelle</translation>
    </message>
    <message>
        <source>plug the gauge in; none was found</source>
        <translation>den Kraftmesser einstecken; es wurde keiner gefunden</translation>
    </message>
    <message>
        <source>plug it in, or one of {}</source>
        <translation>einstecken, oder eine von {}</translation>
    </message>
    <message>
        <source>the serial line is gone</source>
        <translation>die serielle Schnittstelle ist nicht mehr da</translation>
    </message>
    <message>
        <source>plug the gauge in again</source>
        <translation>den Kraftmesser wieder einstecken</translation>
    </message>
    <message>
        <source>the serial line cannot be set up</source>
        <translation>die serielle Schnittstelle lässt sich nicht einrichten</translation>
    </message>
    <message>
        <source>this is not a serial line</source>
        <translation>dies ist keine serielle Schnittstelle</translation>
    </message>
    <message>
        <source>the gauge&apos;s /dev/tty...</source>
        <translation>/dev/tty... des Kraftmessers</translation>
    </message>
    <message>
        <source>the serial line does not support {} baud</source>
        <translation>die serielle Schnittstelle unterstützt {} Baud nicht</translation>
    </message>
    <message>
        <source>the speed given in the gauge&apos;s manual</source>
        <translation>die im Handbuch des Kraftmessers angegebene Geschwindigkeit</translation>
    </message>
    <message>
        <source>{} baud is not a speed of a serial line</source>
        <translation>{} Baud ist keine Geschwindigkeit einer seriellen Schnittstelle</translation>
    </message>
    <message>
        <source>9600, 19200, 115200 or the speed in the gauge&apos;s manual</source>
        <translation>9600, 19200, 115200 oder was das Handbuch des Kraftmessers nennt</translation>
    </message>
    <message>
        <source>the serial line cannot be opened</source>
        <translation>die serielle Schnittstelle lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>the serial line accepts no data</source>
        <translation>die serielle Schnittstelle nimmt keine Daten an</translation>
    </message>
    <message>
        <source>check its cable</source>
        <translation>ihr Kabel prüfen</translation>
    </message>
    <message>
        <source>{} from now on</source>
        <translation>ab jetzt {}</translation>
    </message>
    <message>
        <source>the typed value no longer applies</source>
        <translation>der eingegebene Wert gilt nicht mehr</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a reading; type a number, &apos;y 1.2 N&apos;, &apos;block NAME&apos;, or nothing</source>
        <translation>&apos;{}&apos; ist kein Messwert; eine Zahl, &apos;y 1.2 N&apos;, &apos;block NAME&apos; oder nichts eingeben</translation>
    </message>
    <message>
        <source>{:.3f} {:.3f} {:.3f} N</source>
        <translation>{:.3f} {:.3f} {:.3f} N</translation>
    </message>
    <message>
        <source>ours, simulated</source>
        <translation>unseres, simuliert</translation>
    </message>
    <message>
        <source>paper, measured</source>
        <translation>Veröffentlichung, gemessen</translation>
    </message>
    <message>
        <source>Fx and Fy of pushes, on fingers drawn at random</source>
        <translation>Fx und Fy von Stößen, an zufällig gezogenen Fingern</translation>
    </message>
    <message>
        <source>position and force in rooms of 300, 1100 and 2500 lux</source>
        <translation>Position und Kraft in Räumen mit 300, 1100 und 2500 Lux</translation>
    </message>
    <message>
        <source>Our values are simulated, with known truth; the paper&apos;s were measured on a real finger.</source>
        <translation>Unsere Werte sind simuliert, die wahren Werte sind bekannt; die der Veröffentlichung wurden an einem wirklichen Finger gemessen.</translation>
    </message>
    <message>
        <source>least detected depth of a ball, ours only</source>
        <translation>geringste erkannte Tiefe einer Kugel, nur unsere</translation>
    </message>
    <message>
        <source>position along the finger (mm)</source>
        <translation>Position längs des Fingers (mm)</translation>
    </message>
    <message>
        <source>least detected depth (mm)</source>
        <translation>geringste erkannte Tiefe (mm)</translation>
    </message>
    <message>
        <source>least detected force on every face, by height</source>
        <translation>geringste erkannte Kraft auf jeder Fläche, über der Höhe</translation>
    </message>
    <message>
        <source>least detected force (N)</source>
        <translation>geringste erkannte Kraft (N)</translation>
    </message>
    <message>
        <source>paper, at most, measured</source>
        <translation>Veröffentlichung, höchstens, gemessen</translation>
    </message>
    <message>
        <source>{} lux</source>
        <translation>{} Lux</translation>
    </message>
    <message>
        <source>position error in rooms of different light; the paper gives no figure by room</source>
        <translation>Positionsfehler in verschieden hellen Räumen; die Veröffentlichung nennt keine Zahl je Raum</translation>
    </message>
    <message>
        <source>mean position error (mm)</source>
        <translation>mittlerer Positionsfehler (mm)</translation>
    </message>
    <message>
        <source>force error in rooms of different light, with a model trained in the dark</source>
        <translation>Kraftfehler in verschieden hellen Räumen, mit einem im Dunkeln trainierten Modell</translation>
    </message>
    <message>
        <source>mean error of Fx and Fy (N)</source>
        <translation>mittlerer Fehler von Fx und Fy (N)</translation>
    </message>
    <message>
        <source>position, mean error at {} lux</source>
        <translation>Position, mittlerer Fehler bei {} Lux</translation>
    </message>
    <message>
        <source>force, mean error at {} lux</source>
        <translation>Kraft, mittlerer Fehler bei {} Lux</translation>
    </message>
    <message>
        <source>position, greatest change between rooms</source>
        <translation>Position, größte Änderung zwischen Räumen</translation>
    </message>
    <message>
        <source>force, greatest change between rooms</source>
        <translation>Kraft, größte Änderung zwischen Räumen</translation>
    </message>
    <message>
        <source>the same without correction of the light</source>
        <translation>dasselbe ohne Korrektur des Lichts</translation>
    </message>
    <message>
        <source>The scene assumes how much of a room&apos;s light enters a finger: 4 grey levels of a white surface per 1000 lux; every room shows the same frames</source>
        <translation>Die Szene nimmt an, wie viel vom Licht eines Raums in einen Finger gelangt: 4 Graustufen einer weißen Oberfläche je 1000 Lux; jeder Raum zeigt dieselben Bilder</translation>
    </message>
    <message>
        <source>correct (%)</source>
        <translation>richtig erkannt (%)</translation>
    </message>
    <message>
        <source>one of 8 sides</source>
        <translation>eine von 8 Seiten</translation>
    </message>
    <message>
        <source>share of frames with a reference closer than the given px, summed over the dots</source>
        <translation>Anteil der Bilder mit einer Referenz näher als die angegebenen px, summiert über die Punkte</translation>
    </message>
    <message>
        <source>distance to the reference (px)</source>
        <translation>Abstand zur Referenz (px)</translation>
    </message>
    <message>
        <source>frames (%)</source>
        <translation>Bilder (%)</translation>
    </message>
    <message>
        <source>nearest of a recording, ours</source>
        <translation>nächstes einer Aufnahme, unseres</translation>
    </message>
    <message>
        <source>one reference, ours</source>
        <translation>eine Referenz, unsere</translation>
    </message>
    <message>
        <source>nearest, paper, measured</source>
        <translation>nächstes, Veröffentlichung, gemessen</translation>
    </message>
    <message>
        <source>one, paper, measured</source>
        <translation>eine, Veröffentlichung, gemessen</translation>
    </message>
    <message>
        <source>no error</source>
        <translation>kein Fehler</translation>
    </message>
    <message>
        <source>held out, ours, simulated</source>
        <translation>ausgelassen, unseres, simuliert</translation>
    </message>
    <message>
        <source>true force (N)</source>
        <translation>wahre Kraft (N)</translation>
    </message>
    <message>
        <source>estimated force (N)</source>
        <translation>ermittelte Kraft (N)</translation>
    </message>
    <message>
        <source>mean error of the force, ours simulated and the paper&apos;s measured</source>
        <translation>mittlerer Kraftfehler, unserer simuliert und der der Veröffentlichung gemessen</translation>
    </message>
    <message>
        <source>mean error (N)</source>
        <translation>mittlerer Fehler (N)</translation>
    </message>
    <message>
        <source>Fx</source>
        <translation>Fx</translation>
    </message>
    <message>
        <source>Fy</source>
        <translation>Fy</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>error along the finger: pushes near the base move the markers least</source>
        <translation>Fehler längs des Fingers: Stöße nahe dem Fuß bewegen die Marken am wenigsten</translation>
    </message>
    <message>
        <source>Fx, ours</source>
        <translation>Fx, unseres</translation>
    </message>
    <message>
        <source>Fy, ours</source>
        <translation>Fy, unseres</translation>
    </message>
    <message>
        <source>Fx, paper, over all positions</source>
        <translation>Fx, Veröffentlichung, über alle Positionen</translation>
    </message>
    <message>
        <source>Fy, paper, over all positions</source>
        <translation>Fy, Veröffentlichung, über alle Positionen</translation>
    </message>
    <message>
        <source>Fx estimated at positions held out</source>
        <translation>Fx, ermittelt an ausgelassenen Positionen</translation>
    </message>
    <message>
        <source>Fy estimated at positions held out</source>
        <translation>Fy, ermittelt an ausgelassenen Positionen</translation>
    </message>
    <message>
        <source>Fx, mean error at positions held out</source>
        <translation>Fx, mittlerer Fehler an ausgelassenen Positionen</translation>
    </message>
    <message>
        <source>Fy, mean error at positions held out</source>
        <translation>Fy, mittlerer Fehler an ausgelassenen Positionen</translation>
    </message>
    <message>
        <source>Fx, the same for the worst finger</source>
        <translation>Fx, dasselbe beim schlechtesten Finger</translation>
    </message>
    <message>
        <source>Fy, the same for the worst finger</source>
        <translation>Fy, dasselbe beim schlechtesten Finger</translation>
    </message>
    <message>
        <source>forces within their 95 % intervals</source>
        <translation>Kräfte innerhalb ihrer Intervalle von 95 %</translation>
    </message>
    <message>
        <source>the same, deviation from 95 %</source>
        <translation>dasselbe, Abweichung von 95 %</translation>
    </message>
    <message>
        <source>{} fingers drawn at random, 484 pushes each at {} positions, some of which are held out entirely; {} pushes are measured, the others show too few markers. Forces act on the finger, in the camera&apos;s axes, without a gauge&apos;s error</source>
        <translation>{} zufällig gezogene Finger, je 484 Stöße an {} Positionen, von denen einige ganz ausgelassen werden; {} Stöße werden gemessen, bei den anderen sind zu wenige Marken zu finden. Die Kräfte wirken auf den Finger, in den Achsen der Kamera, ohne Fehler eines Kraftmessers</translation>
    </message>
    <message>
        <source>No drag acts along the finger: it hardly moves a marker, so no marker shows it</source>
        <translation>Längs des Fingers wirkt kein Zug: Er bewegt kaum eine Marke, und keine zeigt ihn an</translation>
    </message>
    <message>
        <source>relief error, ours only: the paper shows only images</source>
        <translation>Fehler des Reliefs, nur unserer: Die Veröffentlichung zeigt nur Bilder</translation>
    </message>
    <message>
        <source>mean depth error (mm)</source>
        <translation>mittlerer Tiefenfehler (mm)</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>gerade</translation>
    </message>
    <message>
        <source>bent</source>
        <translation>gebogen</translation>
    </message>
    <message>
        <source>time of a frame&apos;s steps, ours on this computer and the paper&apos;s on its own</source>
        <translation>Zeit für die Schritte eines Bildes, unsere auf diesem Rechner und die der Veröffentlichung auf deren eigenem</translation>
    </message>
    <message>
        <source>time (ms)</source>
        <translation>Zeit (ms)</translation>
    </message>
    <message>
        <source>edges, shape</source>
        <translation>Kanten, Form</translation>
    </message>
    <message>
        <source>markers, reference</source>
        <translation>Marken, Referenz</translation>
    </message>
    <message>
        <source>depth, contacts</source>
        <translation>Tiefe, Kontakte</translation>
    </message>
    <message>
        <source>entire frame</source>
        <translation>gesamtes Bild</translation>
    </message>
    <message>
        <source>position error along the finger, one point per contact</source>
        <translation>Positionsfehler längs des Fingers, ein Punkt je Kontakt</translation>
    </message>
    <message>
        <source>position error (mm)</source>
        <translation>Positionsfehler (mm)</translation>
    </message>
    <message>
        <source>paper, mean within 20 mm of the middle, measured</source>
        <translation>Veröffentlichung, Mittel innerhalb von 20 mm um die Mitte, gemessen</translation>
    </message>
    <message>
        <source>paper, mean at the tip, measured</source>
        <translation>Veröffentlichung, Mittel an der Spitze, gemessen</translation>
    </message>
    <message>
        <source>angle error of a bar, by its orientation</source>
        <translation>Winkelfehler eines Stabs, nach seiner Drehung</translation>
    </message>
    <message>
        <source>true angle (degrees)</source>
        <translation>wahrer Winkel (Grad)</translation>
    </message>
    <message>
        <source>angle error (degrees)</source>
        <translation>Winkelfehler (Grad)</translation>
    </message>
    <message>
        <source>paper, the lesser, measured</source>
        <translation>Veröffentlichung, die kleinere, gemessen</translation>
    </message>
    <message>
        <source>paper, the greater, measured</source>
        <translation>Veröffentlichung, die größere, gemessen</translation>
    </message>
    <message>
        <source>the finger is not calibrated</source>
        <translation>der Finger ist nicht kalibriert</translation>
    </message>
    <message>
        <source>calibrating it with ball presses</source>
        <translation>ihn mit Kugeleindrücken kalibrieren</translation>
    </message>
    <message>
        <source>this is not the file of the finger&apos;s calibration</source>
        <translation>dies ist nicht die Datei der Kalibrierung dieses Fingers</translation>
    </message>
    <message>
        <source>pressing in different directions; several tables may be given</source>
        <translation>in verschiedene Richtungen drücken; es können mehrere Tabellen angegeben werden</translation>
    </message>
    <message>
        <source>The gauge reports {:.0f} ms (sd {:.0f} ms) later than the images; this is corrected.</source>
        <translation>Der Kraftmesser meldet {:.0f} ms (Standardabweichung {:.0f} ms) später als die Bilder; das wird korrigiert.</translation>
    </message>
    <message>
        <source>The gauge reports {:.0f} ms (sd {:.0f} ms) earlier than the images; this is corrected.</source>
        <translation>Der Kraftmesser meldet {:.0f} ms (Standardabweichung {:.0f} ms) früher als die Bilder; das wird korrigiert.</translation>
    </message>
    <message>
        <source>The gauge&apos;s delay could not be estimated from these frames: nothing is corrected. Try: some quick taps while recording.</source>
        <translation>Die Verzögerung des Kraftmessers ließ sich aus diesen Bildern nicht ermitteln: Es wird nichts korrigiert. Abhilfe: beim Aufnehmen einige Male schnell antippen.</translation>
    </message>
    <message>
        <source>The gauge and the camera were on different clocks: {:.3f} s (sd {:.3f} s) apart by the markers&apos; motion, drifting by {:.0f} ppm.</source>
        <translation>Kraftmesser und Kamera liefen nach verschiedenen Uhren: nach der Bewegung der Marken {:.3f} s (Standardabweichung {:.3f} s) auseinander, mit einer Drift von {:.0f} ppm.</translation>
    </message>
    <message>
        <source>has {} markers and {} axes, the tables before it {} and {}</source>
        <translation>hat {} Marken und {} Achsen, die Tabellen davor {} und {}</translation>
    </message>
    <message>
        <source>tables of one finger and one kind of gauge</source>
        <translation>Tabellen eines einzigen Fingers und einer einzigen Art von Kraftmesser</translation>
    </message>
    <message>
        <source>pressing the ball in deeper, entirely on the face</source>
        <translation>die Kugel tiefer und ganz auf der Fläche eindrücken</translation>
    </message>
    <message>
        <source>nothing is dark enough for a pressed ball</source>
        <translation>nichts ist dunkel genug für eine eingedrückte Kugel</translation>
    </message>
    <message>
        <source>no circle gives a cubic whose constant is zero</source>
        <translation>kein Kreis ergibt eine kubische Kurve, deren Konstante null ist</translation>
    </message>
    <message>
        <source>the cubic without a constant leaves {:.0f} % of the depths&apos; spread: its contact is too faint, small or steep</source>
        <translation>die kubische Kurve ohne Konstante lässt {:.0f} % der Streuung der Tiefen übrig: Der Kontakt ist zu schwach, zu klein oder zu steil</translation>
    </message>
    <message>
        <source>stopped before the first solution</source>
        <translation>angehalten vor der ersten Lösung</translation>
    </message>
    <message>
        <source>the source paper&apos;s method finds a ball in none of {} presses ({})</source>
        <translation>das Verfahren der Veröffentlichung findet bei keinem von {} Eindrücken eine Kugel ({})</translation>
    </message>
    <message>
        <source>all are excluded</source>
        <translation>alle sind ausgeschlossen</translation>
    </message>
    <message>
        <source>the source paper&apos;s method can measure none of {} presses ({})</source>
        <translation>das Verfahren der Veröffentlichung kann keinen von {} Eindrücken messen ({})</translation>
    </message>
    <message>
        <source>our own method</source>
        <translation>unser eigenes Verfahren</translation>
    </message>
    <message>
        <source>the source paper&apos;s method calibrates differently, and this finger has no stored presses for it</source>
        <translation>das Verfahren der Veröffentlichung kalibriert anders, und dieser Finger hat keine gespeicherten Eindrücke dafür</translation>
    </message>
    <message>
        <source>alltact calibrate with ball presses</source>
        <translation>alltact calibrate mit Kugeleindrücken</translation>
    </message>
    <message>
        <source>stopped before the study was over</source>
        <translation>angehalten, bevor die Studie zu Ende war</translation>
    </message>
    <message>
        <source>measuring what settings cost</source>
        <translation>es wird gemessen, was Einstellungen kosten</translation>
    </message>
    <message>
        <source>too few images of the reference recording show the face</source>
        <translation>zu wenige Bilder der Referenzaufnahme zeigen die Fläche</translation>
    </message>
    <message>
        <source>record the finger bending through all its poses</source>
        <translation>den Finger aufnehmen, während er sich durch alle seine Haltungen biegt</translation>
    </message>
    <message>
        <source>balls painted into untouched images of {}</source>
        <translation>Kugeln, in unberührte Bilder von {} gemalt</translation>
    </message>
    <message>
        <source>the demonstration&apos;s finger, simulated, pressed at random positions</source>
        <translation>der Finger der Vorführung, simuliert, an zufälligen Positionen gedrückt</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>unverändert</translation>
    </message>
    <message>
        <source>is not a study file of this program</source>
        <translation>ist keine Studiendatei dieses Programms</translation>
    </message>
    <message>
        <source>remove it, and the study begins anew</source>
        <translation>sie löschen; die Studie beginnt dann von vorn</translation>
    </message>
    <message>
        <source>the gripper&apos;s fingers are {} and {}, and others are open</source>
        <translation>die Finger des Greifers sind {} und {}, und andere sind offen</translation>
    </message>
    <message>
        <source>opening these two fingers</source>
        <translation>diese beiden Finger öffnen</translation>
    </message>
    <message>
        <source>unexpected: {}</source>
        <translation>unerwartet: {}</translation>
    </message>
    <message>
        <source>reporting this as a defect</source>
        <translation>dies als Fehler melden</translation>
    </message>
    <message>
        <source>one of its lines is damaged</source>
        <translation>eine Zeile darin ist beschädigt</translation>
    </message>
    <message>
        <source>reconstruct this part again</source>
        <translation>diesen Teil noch einmal rekonstruieren</translation>
    </message>
    <message>
        <source>the part is damaged or cut short</source>
        <translation>der Teil ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>these are parts of two different runs: {} and {}</source>
        <translation>dies sind Teile zweier verschiedener Läufe: {} und {}</translation>
    </message>
    <message>
        <source>the folders of one run, or reconstruct all its parts again</source>
        <translation>die Ordner eines einzigen Laufs, oder alle seine Teile noch einmal rekonstruieren</translation>
    </message>
    <message>
        <source>part {} exists twice: {} and {}</source>
        <translation>Teil {} ist doppelt vorhanden: {} und {}</translation>
    </message>
    <message>
        <source>there are no parts of a reconstruction</source>
        <translation>es gibt keine Teile einer Rekonstruktion</translation>
    </message>
    <message>
        <source>alltact reconstruct with --shard 1/N to N/N first</source>
        <translation>zuerst alltact reconstruct mit --shard 1/N bis N/N</translation>
    </message>
    <message>
        <source>of {} parts these are missing: {}</source>
        <translation>von {} Teilen fehlen diese: {}</translation>
    </message>
    <message>
        <source>reconstruct these parts, too</source>
        <translation>auch diese Teile rekonstruieren</translation>
    </message>
    <message>
        <source>the part was stopped after {} of {} frames</source>
        <translation>der Teil wurde nach {} von {} Bildern angehalten</translation>
    </message>
    <message>
        <source>the file cannot be moved: {}</source>
        <translation>die Datei lässt sich nicht verschieben: {}</translation>
    </message>
    <message>
        <source>free some space, or ask the folder&apos;s owner for access</source>
        <translation>Platz schaffen, oder den Besitzer des Ordners um Zugriff bitten</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a valid part</source>
        <translation>&apos;{}&apos; ist kein gültiger Teil</translation>
    </message>
    <message>
        <source>1/8 to 8/8 for eight parts, for example</source>
        <translation>zum Beispiel 1/8 bis 8/8 für acht Teile</translation>
    </message>
    <message>
        <source>could not confirm that the files are on the disk</source>
        <translation>es ließ sich nicht sicherstellen, dass die Dateien auf dem Datenträger sind</translation>
    </message>
    <message>
        <source>the image is not marked as depth in 16 bits</source>
        <translation>das Bild ist nicht als Tiefe in 16 Bit gekennzeichnet</translation>
    </message>
    <message>
        <source>an image from alltact reconstruct --format depth16</source>
        <translation>ein Bild aus alltact reconstruct --format depth16</translation>
    </message>
    <message>
        <source>the part of the face to measure depth on, in millimetres along it from its base; all else counts as off the face</source>
        <translation>der Teil der Fläche, auf dem Tiefe gemessen wird, in Millimetern längs der Fläche von ihrem Fuß an; alles andere gilt als außerhalb der Fläche</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not &apos;all&apos; or a part of the face in mm such as 20-60</source>
        <translation>&apos;{}&apos; ist weder &apos;all&apos; noch ein Teil der Fläche in mm wie 20-60</translation>
    </message>
    <message>
        <source>pixels used to measure an image: all of them, or means of 2 by 2 or 4 by 4 of them; results in pixels then refer to that image</source>
        <translation>Pixel, mit denen ein Bild gemessen wird: alle, oder Mittelwerte aus je 2 mal 2 oder 4 mal 4; Ergebnisse in Pixeln beziehen sich dann auf dieses Bild</translation>
    </message>
    <message>
        <source>every pixel</source>
        <translation>jedes Pixel</translation>
    </message>
    <message>
        <source>half the pixels per side</source>
        <translation>halb so viele Pixel je Seite</translation>
    </message>
    <message>
        <source>a quarter of the pixels per side</source>
        <translation>ein Viertel der Pixel je Seite</translation>
    </message>
    <message>
        <source>&apos;whole&apos; detects small contacts and steep edges, and numbers small dots</source>
        <translation>&apos;whole&apos; erkennt kleine Kontakte und steile Kanten und nummeriert kleine Punkte</translation>
    </message>
    <message>
        <source>&apos;half&apos; uses a quarter of the pixels and of the recording&apos;s memory, &apos;quarter&apos; a sixteenth</source>
        <translation>&apos;half&apos; nutzt ein Viertel der Pixel und des Speichers der Aufnahme, &apos;quarter&apos; ein Sechzehntel</translation>
    </message>
    <message>
        <source>images of one source whose running mean is measured; 1: each by itself. A moving finger then appears at its average position, and blurred</source>
        <translation>Bilder einer Quelle, deren gleitendes Mittel gemessen wird; 1: jedes für sich. Ein bewegter Finger erscheint dann an seiner mittleren Position, und unscharf</translation>
    </message>
    <message numerus="yes">
        <source>{} images averaged</source>
        <comment>{} image averaged</comment>
        <translation>
            <numerusform>{} Bild gemittelt</numerusform>
            <numerusform>{} Bilder gemittelt</numerusform>
        </translation>
    </message>
    <message>
        <source>more reduce the noise of a finger that holds still, by their square root</source>
        <translation>mehr verringern das Rauschen eines stillgehaltenen Fingers, um die Wurzel ihrer Zahl</translation>
    </message>
    <message>
        <source>more delay the results, by half their number; adding them up takes a little time</source>
        <translation>mehr verzögern die Ergebnisse, um die Hälfte ihrer Zahl; das Summieren kostet ein wenig Zeit</translation>
    </message>
    <message>
        <source>depth on the full face</source>
        <translation>Tiefe auf der ganzen Fläche</translation>
    </message>
    <message>
        <source>depth from {:g} to {:g} mm along the face</source>
        <translation>Tiefe von {} bis {} mm längs der Fläche</translation>
    </message>
    <message>
        <source>&apos;all&apos; misses no contact</source>
        <translation>&apos;all&apos; übersieht keinen Kontakt</translation>
    </message>
    <message>
        <source>depth takes less time, in proportion to the part&apos;s length</source>
        <translation>die Tiefe braucht weniger Zeit, im Verhältnis zur Länge des Teils</translation>
    </message>
    <message>
        <source>recorded images from which reference-method local computes the reference</source>
        <translation>aufgenommene Bilder, aus denen reference-method local die Referenz berechnet</translation>
    </message>
    <message numerus="yes">
        <source>reference from {} images</source>
        <comment>reference from {} image</comment>
        <translation>
            <numerusform>Referenz aus {} Bild</numerusform>
            <numerusform>Referenz aus {} Bildern</numerusform>
        </translation>
    </message>
    <message>
        <source>more leave less noise in the reference; too many reach too far from the pose</source>
        <translation>mehr lassen weniger Rauschen in der Referenz; zu viele reichen zu weit von der Haltung weg</translation>
    </message>
    <message>
        <source>each is added up in every frame</source>
        <translation>jedes wird in jedem Bild aufsummiert</translation>
    </message>
    <message>
        <source>so few measured pixels, or pixels on one line, define no plane</source>
        <translation>so wenige gemessene Pixel, oder Pixel auf einer einzigen Linie, legen keine Ebene fest</translation>
    </message>
    <message>
        <source>a larger piece, or one that is measured</source>
        <translation>ein größeres Stück, oder eines, das gemessen ist</translation>
    </message>
    <message>
        <source>{} measured pixels where {} are needed</source>
        <translation>{} gemessene Pixel, nötig sind {}</translation>
    </message>
    <message>
        <source>no ball lies in this piece</source>
        <translation>in diesem Stück liegt keine Kugel</translation>
    </message>
    <message>
        <source>a round piece, visible down to half its depth</source>
        <translation>ein rundes Stück, sichtbar bis zur halben Tiefe</translation>
    </message>
    <message>
        <source>nothing here is deeper than {} mm</source>
        <translation>nichts ist hier tiefer als {} mm</translation>
    </message>
    <message>
        <source>a piece where something presses</source>
        <translation>ein Stück, in dem etwas drückt</translation>
    </message>
    <message>
        <source>the piece is too narrow to remove its form</source>
        <translation>das Stück ist zu schmal, um seine Form herauszurechnen</translation>
    </message>
    <message>
        <source>a wider one</source>
        <translation>ein breiteres</translation>
    </message>
    <message>
        <source>no step along this line exceeds the noise</source>
        <translation>keine Stufe längs dieser Linie hebt sich vom Rauschen ab</translation>
    </message>
    <message>
        <source>a line that crosses the step at a right angle</source>
        <translation>eine Linie, die die Stufe im rechten Winkel kreuzt</translation>
    </message>
    <message>
        <source>part of this piece is at a limit of the measuring range</source>
        <translation>ein Teil dieses Stücks liegt an der Grenze des Messbereichs</translation>
    </message>
    <message>
        <source>a piece that is pressed in less deeply</source>
        <translation>ein weniger tief eingedrücktes Stück</translation>
    </message>
    <message>
        <source>one side of the step is too short to be a plane</source>
        <translation>eine Seite der Stufe ist zu kurz für eine Ebene</translation>
    </message>
    <message>
        <source>a line that reaches further over both sides</source>
        <translation>eine Linie, die auf beiden Seiten weiter reicht</translation>
    </message>
    <message>
        <source>one side of the step is not flat</source>
        <translation>eine Seite der Stufe ist nicht eben</translation>
    </message>
    <message>
        <source>a line over two planes, with the step between them</source>
        <translation>eine Linie über zwei Ebenen, mit der Stufe dazwischen</translation>
    </message>
    <message>
        <source>the two sides of the step are not parallel</source>
        <translation>die beiden Seiten der Stufe sind nicht parallel</translation>
    </message>
    <message>
        <source>a line over two parallel planes, with the step between them</source>
        <translation>eine Linie über zwei parallele Ebenen, mit der Stufe dazwischen</translation>
    </message>
    <message>
        <source>could not save the simulated finger for the next time</source>
        <translation>der simulierte Finger ließ sich nicht für das nächste Mal speichern</translation>
    </message>
    <message>
        <source>error of a push&apos;s direction in the image; sides begin at 22.5 degrees and every 45 from there; the paper gives no figure for it</source>
        <translation>Richtungsfehler eines Stoßes im Bild; Seiten beginnen bei 22,5 Grad und von dort an alle 45; die Veröffentlichung nennt dafür keine Zahl</translation>
    </message>
    <message>
        <source>true direction (degrees)</source>
        <translation>wahre Richtung (Grad)</translation>
    </message>
    <message>
        <source>error of the direction (degrees)</source>
        <translation>Fehler der Richtung (Grad)</translation>
    </message>
    <message>
        <source>frames under 10 px per dot, or reported as a pose never recorded</source>
        <translation>Bilder unter 10 px je Punkt, oder als nie aufgenommene Haltung gemeldet</translation>
    </message>
    <message>
        <source>frames under 10 px summed over the dots, nearest of a recording</source>
        <translation>Bilder unter 10 px, über die Punkte summiert, nächstes einer Aufnahme</translation>
    </message>
    <message>
        <source>the same, for the recorded frames as the reference combines them</source>
        <translation>dasselbe, mit den aufgenommenen Bildern, wie die Referenz sie kombiniert</translation>
    </message>
    <message>
        <source>the same, or the pose or its surroundings are reported as not recorded</source>
        <translation>dasselbe, oder gemeldet, dass die Haltung oder ihre Umgebung nicht aufgenommen wurde</translation>
    </message>
    <message>
        <source>as the reference combines them, ours</source>
        <translation>wie die Referenz sie kombiniert, unseres</translation>
    </message>
    <message>
        <source>The paper sums the distance over its dots, and so does the figure under 40 px here; the figure under 10 px covers this finger and {} drawn at random, per dot and summed</source>
        <translation>Die Veröffentlichung summiert den Abstand über ihre Punkte, und so auch die Angabe unter 40 px hier; die Angabe unter 10 px gilt für diesen Finger und {} zufällig gezogene, je Punkt und summiert</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>Wahrheit</translation>
    </message>
    <message>
        <source>relief of the straight finger, along the pressed face from base (left) to tip</source>
        <translation>Relief des geraden Fingers, längs der gedrückten Fläche vom Fuß (links) bis zur Spitze</translation>
    </message>
    <message>
        <source>relief of the bent finger, along the pressed face from base (left) to tip</source>
        <translation>Relief des gebogenen Fingers, längs der gedrückten Fläche vom Fuß (links) bis zur Spitze</translation>
    </message>
    <message>
        <source>recording of all poses</source>
        <translation>Aufnahme aller Haltungen</translation>
    </message>
    <message>
        <source>recording of all poses, error</source>
        <translation>Aufnahme aller Haltungen, Fehler</translation>
    </message>
    <message>
        <source>single reference</source>
        <translation>einzelne Referenz</translation>
    </message>
    <message>
        <source>single reference, error</source>
        <translation>einzelne Referenz, Fehler</translation>
    </message>
    <message>
        <source>The paper shows images of reliefs but no figure; both of ours use the same calibration, so only the reference differs</source>
        <translation>Die Veröffentlichung zeigt Bilder von Reliefs, aber keine Zahl; unsere beiden verwenden dieselbe Kalibrierung, sodass sich nur die Referenz unterscheidet</translation>
    </message>
    <message>
        <source>no finger was specified to measure these images</source>
        <translation>es wurde kein Finger angegeben, der diese Bilder misst</translation>
    </message>
    <message>
        <source>the scene shows another finger than {}</source>
        <translation>die Szene zeigt einen anderen Finger als {}</translation>
    </message>
    <message>
        <source>{} is not calibrated</source>
        <translation>{} ist nicht kalibriert</translation>
    </message>
    <message>
        <source>leaving out {}</source>
        <translation>{} wird weggelassen</translation>
    </message>
    <message>
        <source>ours, on this computer</source>
        <translation>unsere, auf diesem Rechner</translation>
    </message>
    <message>
        <source>the worst of {} fingers drawn at random, within +-20 mm</source>
        <translation>der schlechteste von {} zufällig gezogenen Fingern, innerhalb von +-20 mm</translation>
    </message>
    <message>
        <source>the worst of {} fingers drawn at random, at the tip</source>
        <translation>der schlechteste von {} zufällig gezogenen Fingern, an der Spitze</translation>
    </message>
    <message>
        <source>is not a setting of this version</source>
        <translation>ist keine Einstellung dieser Version</translation>
    </message>
    <message>
        <source>a new study</source>
        <translation>eine neue Studie</translation>
    </message>
    <message>
        <source>studying the finger again</source>
        <translation>den Finger noch einmal untersuchen</translation>
    </message>
    <message>
        <source>this finger has no presets: it was not studied yet</source>
        <translation>dieser Finger hat keine Voreinstellungen: Er wurde noch nicht untersucht</translation>
    </message>
    <message>
        <source>alltact study {} --save</source>
        <translation>alltact study {} --save</translation>
    </message>
    <message>
        <source>no setting is faster on this finger without an error half as large again</source>
        <translation>keine Einstellung ist bei diesem Finger schneller, ohne dass der Fehler um die Hälfte wächst</translation>
    </message>
    <message>
        <source>no setting is more accurate on this finger than those of its calibration</source>
        <translation>keine Einstellung ist bei diesem Finger genauer als die seiner Kalibrierung</translation>
    </message>
    <message>
        <source>measuring with {}</source>
        <translation>mit {} messen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a preset of this finger</source>
        <translation>&apos;{}&apos; ist keine Voreinstellung dieses Fingers</translation>
    </message>
    <message>
        <source>{}</source>
        <translation>{}</translation>
    </message>
    <message>
        <source>beyond the {} to be used</source>
        <translation>mehr als die {}, die verwendet werden sollen</translation>
    </message>
    <message>
        <source>maximum number of presses to use, spread evenly over those given; 0: all of them</source>
        <translation>höchste Zahl verwendeter Eindrücke, gleichmäßig über die gegebenen verteilt; 0: alle</translation>
    </message>
    <message>
        <source>all presses</source>
        <translation>alle Eindrücke</translation>
    </message>
    <message>
        <source>more support the curve at more depths and positions; ten well spread are typical</source>
        <translation>mehr stützen die Kurve bei mehr Tiefen und an mehr Positionen; zehn gut verteilte sind typisch</translation>
    </message>
    <message>
        <source>each must be made, and is left out once to test the prediction</source>
        <translation>jeder muss gemacht werden und wird einmal ausgelassen, um die Vorhersage zu prüfen</translation>
    </message>
    <message>
        <source>maximum number of averaged images of a press held still (--bursts)</source>
        <translation>höchste Zahl gemittelter Bilder eines stillgehaltenen Eindrucks (--bursts)</translation>
    </message>
    <message>
        <source>more leave less noise in a press, by their square root</source>
        <translation>mehr lassen weniger Rauschen in einem Eindruck, nach ihrer Quadratwurzel</translation>
    </message>
    <message>
        <source>the ball must be held still that long, and reading them takes a little time</source>
        <translation>die Kugel muss so lange stillgehalten werden, und das Einlesen kostet ein wenig Zeit</translation>
    </message>
    <message>
        <source>maximum number of rounds of the joint fit; it ends earlier when nothing changes</source>
        <translation>höchste Zahl der Runden der gemeinsamen Anpassung; sie endet früher, wenn sich nichts mehr ändert</translation>
    </message>
    <message>
        <source>more resolve contradictions between presses; too few leave the curve where it began</source>
        <translation>mehr gleichen Widersprüche zwischen Eindrücken aus; zu wenige lassen die Kurve, wo sie begann</translation>
    </message>
    <message>
        <source>each solves all presses together once, in every trial</source>
        <translation>jede löst alle Eindrücke einmal gemeinsam, in jedem Versuch</translation>
    </message>
    <message>
        <source>the presses do not show whether brightness follows the layer&apos;s thickness along its normal ({:.4f} mm on presses left out) or along z ({:.4f} mm): the normal is assumed; if wrong, positions on the face are {:.1f} mm off along it; use larger images, and presses where the face is steep and where it is flat</source>
        <translation>die Eindrücke zeigen nicht, ob die Helligkeit der Dicke der Schicht längs ihrer Normalen ({:.4f} mm bei ausgelassenen Eindrücken) oder längs z ({:.4f} mm) folgt: Angenommen wird die Normale; ist das falsch, weichen Positionen längs der Fläche um {:.1f} mm ab; größere Bilder verwenden, und Eindrücke, wo die Fläche steil und wo sie flach ist</translation>
    </message>
    <message>
        <source>the source paper&apos;s method is not studied with a turned camera</source>
        <translation>das Verfahren der Veröffentlichung wird nicht mit einer gedrehten Kamera untersucht</translation>
    </message>
    <message>
        <source>{}: median depth error {:.1f} instead of {:.1f} micrometres, 95 % within {:.1f} instead of {:.1f}, for {:.1f} more minutes</source>
        <translation>{}: Tiefenfehler im Median {:.1f} statt {:.1f} Mikrometer, 95 % innerhalb von {:.1f} statt {:.1f}, für {:.1f} Minuten mehr</translation>
    </message>
    <message numerus="yes">
        <source>{} presses</source>
        <comment>{} press</comment>
        <translation>
            <numerusform>{} Eindruck</numerusform>
            <numerusform>{} Eindrücke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{} images each</source>
        <comment>{} image each</comment>
        <translation>
            <numerusform>je {} Bild</numerusform>
            <numerusform>je {} Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>method {}</source>
        <translation>Verfahren {}</translation>
    </message>
    <message>
        <source>family {}</source>
        <translation>Familie {}</translation>
    </message>
    <message numerus="yes">
        <source>{} more presses</source>
        <comment>{} more press</comment>
        <translation>
            <numerusform>{} Eindruck mehr</numerusform>
            <numerusform>{} Eindrücke mehr</numerusform>
        </translation>
    </message>
    <message>
        <source>{} images of each press</source>
        <translation>{} Bilder von jedem Eindruck</translation>
    </message>
    <message>
        <source>The best within one more minute ({})</source>
        <translation>Das Beste in höchstens einer Minute mehr ({})</translation>
    </message>
    <message>
        <source>the finger has too few stored presses to leave one out: {}</source>
        <translation>der Finger hat zu wenige gespeicherte Eindrücke, um einen auszulassen: {}</translation>
    </message>
    <message>
        <source>calibrating it with three presses or more</source>
        <translation>ihn mit drei oder mehr Eindrücken kalibrieren</translation>
    </message>
    <message>
        <source>calibrating {} anew</source>
        <translation>{} neu kalibrieren</translation>
    </message>
    <message>
        <source>calibrating with {}</source>
        <translation>Kalibrieren mit: {}</translation>
    </message>
    <message>
        <source>none of {} presses could be compared with a mapping made without it</source>
        <translation>keiner von {} Eindrücken ließ sich mit einer Abbildung vergleichen, die ohne ihn entstand</translation>
    </message>
    <message>
        <source>more presses of different depth</source>
        <translation>mehr Eindrücke verschiedener Tiefe</translation>
    </message>
    <message>
        <source>leaving out presses, {} of {}</source>
        <translation>Eindrücke werden ausgelassen, {} von {}</translation>
    </message>
    <message>
        <source>{}, {:.0f} s left</source>
        <translation>{}, noch {:.0f} s</translation>
    </message>
    <message>
        <source>{}, {:.0f} min left</source>
        <translation>{}, noch {:.0f} min</translation>
    </message>
    <message>
        <source>takes {:.2f} times as long</source>
        <translation>dauert {:.2f}-mal so lange</translation>
    </message>
    <message>
        <source>depth error {:.1f} instead of {:.1f} micrometres</source>
        <translation>Tiefenfehler {:.1f} statt {:.1f} Mikrometer</translation>
    </message>
    <message>
        <source>95 % of depth within {:.1f} instead of {:.1f} micrometres</source>
        <translation>95 % der Tiefen innerhalb von {:.1f} statt {:.1f} Mikrometern</translation>
    </message>
    <message>
        <source>position error {:.3f} instead of {:.3f} mm</source>
        <translation>Positionsfehler {:.3f} statt {:.3f} mm</translation>
    </message>
    <message>
        <source>angle error {:.1f} instead of {:.1f} degrees</source>
        <translation>Winkelfehler {:.1f} statt {:.1f} Grad</translation>
    </message>
    <message>
        <source>{:.1f} instead of {:.1f} micrometres of false depth</source>
        <translation>{:.1f} statt {:.1f} Mikrometer falsche Tiefe</translation>
    </message>
    <message numerus="yes">
        <source>no depth in {} images</source>
        <comment>no depth in {} image</comment>
        <translation>
            <numerusform>keine Tiefe in {} Bild</numerusform>
            <numerusform>keine Tiefe in {} Bildern</numerusform>
        </translation>
    </message>
    <message>
        <source>the figure cannot be drawn</source>
        <translation>die Grafik lässt sich nicht zeichnen</translation>
    </message>
    <message>
        <source>the part&apos;s video of depth is missing</source>
        <translation>das Tiefenvideo des Teils fehlt</translation>
    </message>
    <message>
        <source>could not compress the depth</source>
        <translation>die Tiefe ließ sich nicht komprimieren</translation>
    </message>
    <message>
        <source>the video is not marked as depth</source>
        <translation>das Video ist nicht als Tiefe gekennzeichnet</translation>
    </message>
    <message>
        <source>a video from alltact reconstruct --format depth-video</source>
        <translation>ein Video aus alltact reconstruct --format depth-video</translation>
    </message>
    <message>
        <source>the video of depth is damaged or cut short</source>
        <translation>das Tiefenvideo ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>reconstruct the recording again</source>
        <translation>die Aufnahme neu rekonstruieren</translation>
    </message>
    <message>
        <source>this system&apos;s libavcodec cannot write FFV1</source>
        <translation>libavcodec dieses Systems kann FFV1 nicht schreiben</translation>
    </message>
    <message>
        <source>Debian&apos;s libavcodec, or depth as single images</source>
        <translation>libavcodec von Debian, oder die Tiefe als einzelne Bilder</translation>
    </message>
    <message>
        <source>whether the lens distortion is removed from every point, or the lens is assumed to have none</source>
        <translation>ob die Verzeichnung des Objektivs aus jedem Punkt herausgerechnet oder das Objektiv als verzeichnungsfrei angenommen wird</translation>
    </message>
    <message>
        <source>lens corrected at every point</source>
        <translation>Objektiv an jedem Punkt korrigiert</translation>
    </message>
    <message>
        <source>lens assumed distortion-free</source>
        <translation>Objektiv als verzeichnungsfrei angenommen</translation>
    </message>
    <message>
        <source>&apos;exact&apos; measures shape and positions correctly up to the image&apos;s corners</source>
        <translation>&apos;exact&apos; misst Form und Positionen bis in die Ecken des Bildes richtig</translation>
    </message>
    <message>
        <source>&apos;exact&apos; looks up each ray separately</source>
        <translation>&apos;exact&apos; schlägt jeden Strahl einzeln nach</translation>
    </message>
    <message>
        <source>how a layer pressed in along its normal is converted to z: looked up where the normal leads, or at the same pixel as if all rays were parallel</source>
        <translation>wie eine entlang ihrer Normalen eingedrückte Schicht in z umgerechnet wird: dort nachgeschlagen, wohin die Normale führt, oder am selben Pixel, als wären alle Strahlen parallel</translation>
    </message>
    <message>
        <source>exact rays through the layer</source>
        <translation>genaue Strahlen durch die Schicht</translation>
    </message>
    <message>
        <source>parallel rays through the layer</source>
        <translation>parallele Strahlen durch die Schicht</translation>
    </message>
    <message>
        <source>&apos;exact&apos; measures a contact on a sloping face at its true position and depth; &apos;parallel&apos; up to a layer&apos;s thickness off</source>
        <translation>&apos;exact&apos; misst einen Kontakt auf einer schrägen Fläche an seiner wahren Position und Tiefe; &apos;parallel&apos; bis zu einer Schichtdicke daneben</translation>
    </message>
    <message>
        <source>&apos;exact&apos; looks up every pixel of a contact once more</source>
        <translation>&apos;exact&apos; schlägt jedes Pixel eines Kontakts noch einmal nach</translation>
    </message>
    <message>
        <source>contact from {:g} mm of depth</source>
        <translation>Kontakt ab {} mm Tiefe</translation>
    </message>
    <message>
        <source>pixels from one vertex to the next in surfaces that are saved or shown in 3D; 1: every pixel</source>
        <translation>Pixel von einem Eckpunkt zum nächsten in Flächen, die gespeichert oder in 3D gezeigt werden; 1: jedes Pixel</translation>
    </message>
    <message>
        <source>a vertex every {} px</source>
        <translation>ein Eckpunkt alle {} px</translation>
    </message>
    <message>
        <source>1 preserves every measured edge</source>
        <translation>1 erhält jede gemessene Kante</translation>
    </message>
    <message>
        <source>time and size fall with its square</source>
        <translation>Zeit und Größe fallen mit ihrem Quadrat</translation>
    </message>
    <message>
        <source>a point lies off the face</source>
        <translation>ein Punkt liegt außerhalb der Fläche</translation>
    </message>
    <message>
        <source>points on the face</source>
        <translation>Punkte auf der Fläche</translation>
    </message>
    <message>
        <source>both points are the same</source>
        <translation>beide Punkte sind gleich</translation>
    </message>
    <message>
        <source>two different points</source>
        <translation>zwei verschiedene Punkte</translation>
    </message>
    <message>
        <source>the connection&apos;s line was incomplete</source>
        <translation>die Zeile der Verbindung war nicht vollständig</translation>
    </message>
    <message>
        <source>ending it with a line break</source>
        <translation>sie mit einem Zeilenumbruch beenden</translation>
    </message>
    <message>
        <source>more data followed the line</source>
        <translation>nach der Zeile folgten weitere Daten</translation>
    </message>
    <message>
        <source>connecting again</source>
        <translation>neu verbinden</translation>
    </message>
    <message>
        <source>the line is longer than {} bytes</source>
        <translation>die Zeile ist länger als {} Bytes</translation>
    </message>
    <message>
        <source>one line such as alltact-stream/1 picture depth16</source>
        <translation>eine Zeile wie alltact-stream/1 picture depth16</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not request {}</source>
        <translation>&apos;{}&apos; fordert {} nicht an</translation>
    </message>
    <message>
        <source>there is no part &apos;{}&apos;, only {}</source>
        <translation>es gibt keinen Teil &apos;{}&apos;, nur {}</translation>
    </message>
    <message>
        <source>programs of other users are not accepted</source>
        <translation>Programme anderer Benutzer werden nicht zugelassen</translation>
    </message>
    <message>
        <source>{} programs are already served</source>
        <translation>{} Programme werden bereits bedient</translation>
    </message>
    <message>
        <source>ending one of them</source>
        <translation>eines davon beenden</translation>
    </message>
    <message>
        <source>no line came within {} seconds</source>
        <translation>binnen {} Sekunden kam keine Zeile</translation>
    </message>
    <message>
        <source>programs could not connect here</source>
        <translation>hier konnten sich keine Programme verbinden</translation>
    </message>
    <message>
        <source>the path is longer than the {} bytes a socket&apos;s path may have</source>
        <translation>der Pfad ist länger als die {} Bytes, die ein Socket-Pfad haben darf</translation>
    </message>
    <message>
        <source>a shorter one with --socket</source>
        <translation>ein kürzerer mit --socket</translation>
    </message>
    <message>
        <source>this folder belongs to another user, who could read the data</source>
        <translation>dieser Ordner gehört einem anderen Benutzer, der mitlesen könnte</translation>
    </message>
    <message>
        <source>a folder of your own with --socket</source>
        <translation>ein eigener Ordner mit --socket</translation>
    </message>
    <message>
        <source>others may write in this folder, and could put their own socket there</source>
        <translation>andere dürfen in diesen Ordner schreiben und könnten ihren eigenen Socket hineinlegen</translation>
    </message>
    <message>
        <source>chmod 700, or another folder with --socket</source>
        <translation>chmod 700, oder ein anderer Ordner mit --socket</translation>
    </message>
    <message>
        <source>something here is not a socket, and it remains unchanged</source>
        <translation>hier liegt etwas, das kein Socket ist, und es bleibt unverändert</translation>
    </message>
    <message>
        <source>another path with --socket</source>
        <translation>ein anderer Pfad mit --socket</translation>
    </message>
    <message>
        <source>another program already serves here ({})</source>
        <translation>ein anderes Programm nutzt diesen Pfad schon ({})</translation>
    </message>
    <message>
        <source>connecting to that one, ending it, or another path with --socket</source>
        <translation>sich mit diesem verbinden, es beenden oder einen anderen Pfad mit --socket wählen</translation>
    </message>
    <message>
        <source>a file that a 3D program shows</source>
        <translation>eine Datei, die ein 3D-Programm zeigt</translation>
    </message>
    <message>
        <source>a file that ends in .ply, .vtp, .glb, .stl or .obj</source>
        <translation>eine Datei, die auf .ply, .vtp, .glb, .stl oder .obj endet</translation>
    </message>
    <message>
        <source>these are points, no depth</source>
        <translation>das sind Punkte, keine Tiefe</translation>
    </message>
    <message>
        <source>NAME.depth.tiff</source>
        <translation>NAME.depth.tiff</translation>
    </message>
    <message>
        <source>the edges at the {} are not visible</source>
        <translation>die Kanten an der {} sind nicht zu sehen</translation>
    </message>
    <message>
        <source>bring the entire face into the image, lit, with dark next to it</source>
        <translation>die gesamte Fläche beleuchtet ins Bild bringen, mit Dunkel daneben</translation>
    </message>
    <message>
        <source>edges at the {} are {:.1f} px wide</source>
        <translation>Kanten an der {} sind {:.1f} px breit</translation>
    </message>
    <message>
        <source>turn the lens until the {} is sharp, and let the other end stay so</source>
        <translation>das Objektiv drehen, bis es an der {} scharf ist, und das andere Ende scharf lassen</translation>
    </message>
    <message>
        <source>no face is visible</source>
        <translation>keine Fläche ist zu sehen</translation>
    </message>
    <message>
        <source>{:.1f} % of the face is too bright to measure</source>
        <translation>{:.1f} % der Fläche sind zu hell zum Messen</translation>
    </message>
    <message>
        <source>dim the lamp, or shorten the exposure</source>
        <translation>die Lampe dimmen oder kürzer belichten</translation>
    </message>
    <message>
        <source>the face has brightness {:.0f} of 255, nothing is too bright</source>
        <translation>die Fläche hat Helligkeit {:.0f} von 255, nichts ist zu hell</translation>
    </message>
    <message>
        <source>turn the lamp up, or lengthen the exposure</source>
        <translation>die Lampe heller stellen oder länger belichten</translation>
    </message>
    <message>
        <source>hold the finger still: {:.0f} of {:.0f} s</source>
        <translation>den Finger stillhalten: {:.0f} von {:.0f} s</translation>
    </message>
    <message>
        <source>brightness changes by {:.1f} % in {:.0f} s</source>
        <translation>die Helligkeit ändert sich um {:.1f} % in {:.0f} s</translation>
    </message>
    <message>
        <source>let the lamp warm up for ten minutes, shade the finger from the room&apos;s light, and lock the brightness</source>
        <translation>die Lampe zehn Minuten warm werden lassen, den Finger vor dem Raumlicht schützen und die Helligkeit sperren</translation>
    </message>
    <message>
        <source>no image yet</source>
        <translation>noch kein Bild</translation>
    </message>
    <message>
        <source>{} dots are found</source>
        <translation>{} Punkte gefunden</translation>
    </message>
    <message>
        <source>{} of {} dots are found</source>
        <translation>{} von {} Punkten gefunden</translation>
    </message>
    <message>
        <source>light the dots evenly, keep both rows in the image, and check how many the finger has</source>
        <translation>die Punkte gleichmäßig beleuchten, beide Reihen im Bild halten und prüfen, wie viele der Finger hat</translation>
    </message>
    <message>
        <source>&apos;joint&apos; is several times more accurate, and reports its certainty</source>
        <translation>&apos;joint&apos; ist um ein Mehrfaches genauer und gibt seine Sicherheit an</translation>
    </message>
    <message>
        <source>&apos;joint&apos; solves all presses together, which takes seconds</source>
        <translation>&apos;joint&apos; löst alle Eindrücke zusammen, was Sekunden dauert</translation>
    </message>
    <message>
        <source>&apos;moebius&apos; and &apos;kubelka-munk&apos; need few presses where the layer is even; &apos;polynomial&apos; follows any layer, given more of them</source>
        <translation>&apos;moebius&apos; und &apos;kubelka-munk&apos; brauchen wenige Eindrücke, wo die Schicht gleichmäßig ist; &apos;polynomial&apos; folgt jeder Schicht, braucht aber mehr davon</translation>
    </message>
    <message>
        <source>&apos;auto&apos; fits all of them and leaves presses out for each</source>
        <translation>&apos;auto&apos; passt alle an und lässt bei jeder Eindrücke aus</translation>
    </message>
    <message numerus="yes">
        <source>{} iterations</source>
        <comment>{} iteration</comment>
        <translation>
            <numerusform>{} Iteration</numerusform>
            <numerusform>{} Iterationen</numerusform>
        </translation>
    </message>
    <message>
        <source>the finger has no reference recording, or is not calibrated yet</source>
        <translation>der Finger hat keine Referenzaufnahme oder ist noch nicht kalibriert</translation>
    </message>
    <message>
        <source>alltact reference, then alltact calibrate</source>
        <translation>alltact reference, dann alltact calibrate</translation>
    </message>
    <message>
        <source>no image of the reference recording shows the face</source>
        <translation>kein Bild der Referenzaufnahme zeigt die Fläche</translation>
    </message>
    <message>
        <source>how time and memory grow for {}</source>
        <translation>wie Zeit und Speicher wachsen, bei {}</translation>
    </message>
    <message>
        <source>one frame</source>
        <translation>ein Bild</translation>
    </message>
    <message>
        <source>pixels of the image</source>
        <translation>Pixel des Bildes</translation>
    </message>
    <message>
        <source>images of {} x {}</source>
        <translation>Bilder von {} x {}</translation>
    </message>
    <message>
        <source>memory: of a reference of {} frames</source>
        <translation>Speicher: einer Referenz von {} Bildern</translation>
    </message>
    <message>
        <source>finding the nearest pose</source>
        <translation>die nächste Haltung finden</translation>
    </message>
    <message>
        <source>recorded frames</source>
        <translation>aufgenommene Bilder</translation>
    </message>
    <message>
        <source>a recording of {} frames</source>
        <translation>eine Aufnahme von {} Bildern</translation>
    </message>
    <message>
        <source>{} of {} searches gave the same result as a search of all frames</source>
        <translation>{} von {} Suchen ergaben dasselbe wie die Suche in allen Bildern</translation>
    </message>
    <message>
        <source>numbering dots seen anew</source>
        <translation>neu gesehene Punkte nummerieren</translation>
    </message>
    <message>
        <source>markers</source>
        <translation>Marken</translation>
    </message>
    <message numerus="yes">
        <source>{} markers</source>
        <comment>{} marker</comment>
        <translation>
            <numerusform>{} Marke</numerusform>
            <numerusform>{} Marken</numerusform>
        </translation>
    </message>
    <message>
        <source>{} of {} layouts were numbered</source>
        <translation>{} von {} Anordnungen wurden nummeriert</translation>
    </message>
    <message>
        <source>calibrating</source>
        <translation>kalibrieren</translation>
    </message>
    <message numerus="yes">
        <source>calibrating with {} presses</source>
        <comment>calibrating with {} press</comment>
        <translation>
            <numerusform>mit {} Eindruck kalibrieren</numerusform>
            <numerusform>mit {} Eindrücken kalibrieren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{} presses are distinct, the others are their copies</source>
        <comment>{} press is distinct, the others are its copies</comment>
        <translation>
            <numerusform>{} Eindruck ist eigenständig, die anderen sind Kopien davon</numerusform>
            <numerusform>{} Eindrücke sind eigenständig, die anderen sind Kopien davon</numerusform>
        </translation>
    </message>
    <message>
        <source>measuring a recording at a quarter of the pixels a side</source>
        <translation>eine Aufnahme mit einem Viertel der Pixel je Seite messen</translation>
    </message>
    <message>
        <source>seconds of the recording, at 30 frames each</source>
        <translation>Sekunden der Aufnahme, mit je 30 Bildern</translation>
    </message>
    <message>
        <source>a recording of {:.0f} s</source>
        <translation>eine Aufnahme von {:.0f} s</translation>
    </message>
    <message>
        <source>{} frames of the longest were measured; memory: the maximum in addition to the reference</source>
        <translation>{} Bilder der längsten wurden gemessen; Speicher: das Maximum zusätzlich zur Referenz</translation>
    </message>
    <message>
        <source>its error is estimated from the third view on</source>
        <translation>sein Fehler wird ab der dritten Ansicht geschätzt</translation>
    </message>
    <message>
        <source>no frame shows a face</source>
        <translation>kein Bild zeigt eine Fläche</translation>
    </message>
    <message>
        <source>the image cannot be written</source>
        <translation>das Bild kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>another folder, or freeing some space</source>
        <translation>einen anderen Ordner wählen oder Platz schaffen</translation>
    </message>
    <message>
        <source>there is no cross-section</source>
        <translation>es gibt keinen Querschnitt</translation>
    </message>
    <message>
        <source>two points, A and B</source>
        <translation>zwei Punkte, A und B</translation>
    </message>
    <message>
        <source>the figure cannot be written</source>
        <translation>die Grafik kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>there is no space to try the recording</source>
        <translation>der Platz reicht nicht, um die Aufnahme auszuprobieren</translation>
    </message>
    <message>
        <source>freeing some space on the disk</source>
        <translation>Platz auf dem Datenträger schaffen</translation>
    </message>
    <message>
        <source>the finger could not be copied: {}</source>
        <translation>der Finger konnte nicht kopiert werden: {}</translation>
    </message>
    <message>
        <source>the quick guide&apos;s texts do not fit on {} pages</source>
        <translation>die Texte der Kurzanleitung passen nicht auf {} Seiten</translation>
    </message>
    <message>
        <source>shorten the numbered lists of the help pages</source>
        <translation>die nummerierten Listen der Hilfeseiten kürzen</translation>
    </message>
    <message>
        <source>the markers show from which side the finger is pushed, but not how far from its base: a push on a side moves them alike wherever it is</source>
        <translation>die Marken zeigen, von welcher Seite der Finger gedrückt wird, aber nicht, wie weit von seinem Fuß: ein Druck auf eine Seite bewegt sie gleich, wo immer er ist</translation>
    </message>
    <message>
        <source>a change of the finger that was interrupted cannot be completed: {}</source>
        <translation>eine unterbrochene Änderung des Fingers kann nicht abgeschlossen werden: {}</translation>
    </message>
    <message>
        <source>{} lies in a folder that is a link to elsewhere</source>
        <translation>{} liegt in einem Ordner, der nur ein Verweis auf einen anderen Ort ist</translation>
    </message>
    <message>
        <source>putting that folder itself there instead of the link</source>
        <translation>den Ordner selbst statt des Verweises dorthin legen</translation>
    </message>
    <message>
        <source>this is not a list of files to be changed</source>
        <translation>dies ist keine Liste zu ändernder Dateien</translation>
    </message>
    <message>
        <source>removing it; the finger&apos;s files are then some old, some new</source>
        <translation>sie entfernen; die Dateien des Fingers sind dann teils alt, teils neu</translation>
    </message>
    <message>
        <source>could not be changed</source>
        <translation>konnte nicht geändert werden</translation>
    </message>
    <message>
        <source>could not read the folder</source>
        <translation>der Ordner konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>what the methods of finding markers cost and gain</source>
        <translation>was die Verfahren zur Markensuche kosten und bringen</translation>
    </message>
    <message>
        <source>blobs, the default</source>
        <translation>Flecken (Vorgabe)</translation>
    </message>
    <message>
        <source>the paper&apos;s rows</source>
        <translation>Reihen wie in der Veröffentlichung</translation>
    </message>
    <message>
        <source>network</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>klar</translation>
    </message>
    <message>
        <source>half hidden</source>
        <translation>halb verdeckt</translation>
    </message>
    <message>
        <source>worn</source>
        <translation>abgenutzt</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>unscharf</translation>
    </message>
    <message>
        <source>partly lit</source>
        <translation>teils beleuchtet</translation>
    </message>
    <message>
        <source>dirty</source>
        <translation>verschmutzt</translation>
    </message>
    <message>
        <source>{}: visible markers that are found</source>
        <translation>{}: sichtbare Marken, die gefunden werden</translation>
    </message>
    <message>
        <source>{}: reported as seen, but elsewhere</source>
        <translation>{}: als gesehen gemeldet, doch anderswo</translation>
    </message>
    <message>
        <source>{}: those found, root mean square</source>
        <translation>{}: gefundene, quadratisches Mittel</translation>
    </message>
    <message>
        <source>{}: hidden ones, root mean square</source>
        <translation>{}: verdeckte, quadratisches Mittel</translation>
    </message>
    <message>
        <source>{}: time of a frame, median</source>
        <translation>{}: Zeit für ein Bild, Median</translation>
    </message>
    <message>
        <source>what is difficult</source>
        <translation>was es schwer macht</translation>
    </message>
    <message>
        <source>visible markers that are found, each frame by itself</source>
        <translation>sichtbare Marken, die gefunden werden, jedes Bild für sich</translation>
    </message>
    <message>
        <source>found (%)</source>
        <translation>gefunden (%)</translation>
    </message>
    <message>
        <source>how far hidden markers are from their reported positions</source>
        <translation>wie weit verdeckte Marken von ihren gemeldeten Positionen entfernt sind</translation>
    </message>
    <message>
        <source>root mean square (px)</source>
        <translation>quadratisches Mittel (px)</translation>
    </message>
    <message>
        <source>The demonstration&apos;s finger and {} drawn at random, on which the network was not trained. The recording numbers blobs and network dots; the paper&apos;s rows are numbered from left to right, hidden dots between their neighbours. Each frame is analysed anew, as if none had come before. The paper gives no figure for its markers</source>
        <translation>Der Finger der Vorführung und {} zufällig gezogene, mit denen das Netz nicht trainiert wurde. Flecken und Punkte des Netzes werden nach der Aufnahme nummeriert, die Reihen der Veröffentlichung von links nach rechts, verdeckte Punkte zwischen ihren Nachbarn. Jedes Bild wird neu ausgewertet, als wäre keines vorausgegangen. Die Veröffentlichung nennt für ihre Marken keine Zahl</translation>
    </message>
    <message>
        <source>{} was last changed at {}, and this computer&apos;s clock shows {}: set the clock</source>
        <translation>{} wurde zuletzt um {} geändert, und die Uhr dieses Rechners zeigt {}: Stellen Sie die Uhr</translation>
    </message>
    <message>
        <source>its disk responds slowly; waiting for it</source>
        <translation>sein Datenträger antwortet langsam; es wird auf ihn gewartet</translation>
    </message>
    <message>
        <source>wait; if it lasts, check whether another program keeps that disk busy, then its network or cable</source>
        <translation>warten; wenn es andauert, prüfen, ob ein anderes Programm diesen Datenträger auslastet, dann sein Netzwerk oder Kabel</translation>
    </message>
    <message>
        <source>the push on the back moves the markers too little, or bends the finger too far, to estimate its distance from the base</source>
        <translation>der Druck auf den Rücken bewegt die Marken zu wenig oder biegt den Finger zu weit, um seinen Abstand vom Fuß zu ermitteln</translation>
    </message>
    <message>
        <source>The camera&apos;s clock was changed by {:+.1f} s: until it is correct again, the time of arrival of images is used</source>
        <translation>Die Uhr der Kamera wurde um {:+.1f} s verstellt: Bis sie wieder stimmt, gilt für Bilder die Zeit ihrer Ankunft</translation>
    </message>
    <message>
        <source>The camera sent an image twice ({}): a mean over several images is less certain than reported</source>
        <translation>Die Kamera hat ein Bild zweimal geschickt ({}): Ein Mittel über mehrere Bilder ist weniger sicher als angegeben</translation>
    </message>
    <message>
        <source>The report has no pages: {}.</source>
        <translation>Der Bericht hat keine Seiten: {}.</translation>
    </message>
    <message>
        <source>there is not enough memory to draw</source>
        <translation>zum Zeichnen reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>holds a number that no calibration has</source>
        <translation>enthält eine Zahl, die keine Kalibrierung hat</translation>
    </message>
    <message>
        <source>must have a row for each contradiction</source>
        <translation>muss eine Zeile je Widerspruch haben</translation>
    </message>
    <message>
        <source>must hold five numbers in each row</source>
        <translation>muss in jeder Zeile fünf Zahlen enthalten</translation>
    </message>
    <message>
        <source>unchanged since the calibration</source>
        <translation>seit der Kalibrierung unverändert</translation>
    </message>
    <message>
        <source>the reference ({}) is newer than the calibration ({}): {}</source>
        <translation>die Referenz ({}) ist neuer als die Kalibrierung ({}): {}</translation>
    </message>
    <message>
        <source>a check needs {} presses at different positions; these are at {}: press again</source>
        <translation>eine Prüfung braucht {} Eindrücke an verschiedenen Positionen; diese liegen an {}: weitere drücken</translation>
    </message>
    <message>
        <source>a check needs {} presses at different positions; these are at {}: press also in these thirds: {}</source>
        <translation>eine Prüfung braucht {} Eindrücke an verschiedenen Positionen, diese liegen an {}: auch in diesen Dritteln drücken: {}</translation>
    </message>
    <message numerus="yes">
        <source>at {0} positions</source>
        <comment>at {0} position</comment>
        <translation>
            <numerusform>an {0} Position</numerusform>
            <numerusform>an {0} Positionen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{1:.3f} mm depth error on {0} presses {4} (passes up to {2:.3f} mm), light {3:+.1f} %</source>
        <comment>{1:.3f} mm depth error on {0} press {4} (passes up to {2:.3f} mm), light {3:+.1f} %</comment>
        <translation>
            <numerusform>{1} mm Tiefenfehler bei {0} Eindruck {4} (bestanden bis {2} mm), Licht {3} %</numerusform>
            <numerusform>{1} mm Tiefenfehler bei {0} Eindrücken {4} (bestanden bis {2} mm), Licht {3} %</numerusform>
        </translation>
    </message>
    <message>
        <source>left out: {}</source>
        <translation>ausgelassen: {}</translation>
    </message>
    <message>
        <source>too few to judge</source>
        <translation>zu wenige für ein Urteil</translation>
    </message>
    <message>
        <source>a check needs {} images, {} could be measured</source>
        <translation>eine Prüfung braucht {} Bilder, {} waren messbar</translation>
    </message>
    <message>
        <source>camera, face or markers</source>
        <translation>Kamera, Fläche oder Marken</translation>
    </message>
    <message>
        <source>{:.2f} to {:.2f} mm</source>
        <translation>{} bis {} mm</translation>
    </message>
    <message>
        <source>{:.2f} mm</source>
        <translation>{} mm</translation>
    </message>
    <message numerus="yes">
        <source>{0} of {1} presses have a dark part wider than the ball of {2:.2f} mm diameter ({3} radius): check the ball&apos;s radius</source>
        <comment>{0} of {1} presses has a dark part wider than the ball of {2:.2f} mm diameter ({3} radius): check the ball&apos;s radius</comment>
        <translation>
            <numerusform>{0} von {1} Eindrücken hat eine dunkle Stelle, die breiter ist als die Kugel von {2} mm Durchmesser (Radius {3}): Kugelradius prüfen</numerusform>
            <numerusform>{0} von {1} Eindrücken haben eine dunkle Stelle, die breiter ist als die Kugel von {2} mm Durchmesser (Radius {3}): Kugelradius prüfen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{0} of {1} presses are deeper than the layer of {2:.2f} mm ({3}): check the layer&apos;s thickness and the ball&apos;s radius</source>
        <comment>{0} of {1} presses is deeper than the layer of {2:.2f} mm ({3}): check the layer&apos;s thickness and the ball&apos;s radius</comment>
        <translation>
            <numerusform>{0} von {1} Eindrücken ist tiefer als die Schicht von {2} mm ({3}): Schichtdicke und Kugelradius prüfen</numerusform>
            <numerusform>{0} von {1} Eindrücken sind tiefer als die Schicht von {2} mm ({3}): Schichtdicke und Kugelradius prüfen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{0} of {1} presses are darker than the mapping reaches ({3} deep, the mapping ends at {2:.2f} mm): calibrate again with them</source>
        <comment>{0} of {1} presses is darker than the mapping reaches ({3} deep, the mapping ends at {2:.2f} mm): calibrate again with it</comment>
        <translation>
            <numerusform>{0} von {1} Eindrücken ist dunkler, als die Abbildung reicht ({3} tief, die Abbildung endet bei {2} mm): mit ihm neu kalibrieren</numerusform>
            <numerusform>{0} von {1} Eindrücken sind dunkler, als die Abbildung reicht ({3} tief, die Abbildung endet bei {2} mm): mit ihnen neu kalibrieren</numerusform>
        </translation>
    </message>
    <message>
        <source>the specified face width is {:.2f} mm, but camera and presses show {}: check the width and the lens</source>
        <translation>die Fläche ist mit {} mm Breite angegeben, Kamera und Eindrücke zeigen aber {}: Breite und Objektiv prüfen</translation>
    </message>
    <message>
        <source>mostly the curve&apos;s shape: add presses of different depth and position</source>
        <translation>vor allem durch die Form der Kurve: Eindrücke anderer Tiefe und Position hinzufügen</translation>
    </message>
    <message>
        <source>mostly scale: measure one press&apos;s depth</source>
        <translation>vor allem durch den Maßstab: die Tiefe eines Eindrucks messen</translation>
    </message>
    <message>
        <source>mostly noise and reference of single pixels: record the reference again, with more light</source>
        <translation>vor allem durch Rauschen und Referenz einzelner Pixel: die Referenz mit mehr Licht neu aufnehmen</translation>
    </message>
    <message>
        <source>mostly parts of the face far from any press: press there</source>
        <translation>vor allem durch Teile der Fläche fern von allen Eindrücken: dort drücken</translation>
    </message>
    <message>
        <source>mostly depth measured next to contacts, as caused by light that scatters sideways</source>
        <translation>vor allem durch Tiefe neben Kontakten, wie sie seitlich gestreutes Licht verursacht</translation>
    </message>
    <message>
        <source>mostly the ball&apos;s radius: measure it to a hundredth of a millimetre</source>
        <translation>vor allem durch den Kugelradius: ihn auf einen Hundertstelmillimeter messen</translation>
    </message>
    <message>
        <source>no press in the {} third; press there once</source>
        <translation>kein Eindruck im Drittel „{}“; dort einmal drücken</translation>
    </message>
    <message>
        <source>no press in these thirds: {}; press once in each</source>
        <translation>kein Eindruck in diesen Dritteln: {}; in jedem einmal drücken</translation>
    </message>
    <message>
        <source>{} was changed since the calibration: {}</source>
        <translation>seit der Kalibrierung geändert: {}; {}</translation>
    </message>
    <message>
        <source>{} were changed since the calibration: {}</source>
        <translation>seit der Kalibrierung geändert: {}; {}</translation>
    </message>
    <message>
        <source>the reference is newer than the calibration: {}</source>
        <translation>die Referenz ist neuer als die Kalibrierung: {}</translation>
    </message>
    <message>
        <source>there is no reference: record one</source>
        <translation>es gibt keine Referenz: eine aufnehmen</translation>
    </message>
    <message>
        <source>a file of the reference is missing: restore it, or record the reference again</source>
        <translation>eine Datei der Referenz fehlt: sie wiederherstellen oder die Referenz neu aufnehmen</translation>
    </message>
    <message>
        <source>the reference is cut off or unreadable: record it again</source>
        <translation>die Referenz ist abgeschnitten oder unlesbar: neu aufnehmen</translation>
    </message>
    <message>
        <source>the reference has another image size than the camera: record it again</source>
        <translation>die Referenz hat eine andere Bildgröße als die Kamera: neu aufnehmen</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>distance of the face</source>
        <translation>Abstand der Fläche</translation>
    </message>
    <message>
        <source>camera or lens</source>
        <translation>Kamera oder Objektiv</translation>
    </message>
    <message>
        <source>an earlier version calibrated it and stored too little: {}</source>
        <translation>eine frühere Version hat kalibriert und zu wenig gespeichert: {}</translation>
    </message>
    <message>
        <source>the calibration was stopped before its end: {}</source>
        <translation>die Kalibrierung wurde vor dem Ende abgebrochen: {}</translation>
    </message>
    <message>
        <source>no press was left out to show the error on others</source>
        <translation>kein Eindruck wurde ausgelassen, um den Fehler bei anderen zu zeigen</translation>
    </message>
    <message>
        <source>one press cannot show the error on others; add presses of different depth</source>
        <translation>ein Eindruck kann den Fehler bei anderen nicht zeigen; Eindrücke anderer Tiefe hinzufügen</translation>
    </message>
    <message>
        <source>{} of {} presses needed; add more</source>
        <translation>{} von {} nötigen Eindrücken; weitere hinzufügen</translation>
    </message>
    <message numerus="yes">
        <source>all presses are at {0} positions, {1} are needed; press at others</source>
        <comment>all presses are at {0} position, {1} are needed; press at others</comment>
        <translation>
            <numerusform>alle Eindrücke liegen an {0} Position, {1} sind nötig; an anderen drücken</numerusform>
            <numerusform>alle Eindrücke liegen an {0} Positionen, {1} sind nötig; an anderen drücken</numerusform>
        </translation>
    </message>
    <message>
        <source>all presses are about {:.2f} mm deep; press shallower and deeper as well</source>
        <translation>alle Eindrücke sind etwa {} mm tief; auch flacher und tiefer drücken</translation>
    </message>
    <message>
        <source>the presses do not show how certain the scale is; add presses</source>
        <translation>die Eindrücke zeigen nicht, wie sicher der Maßstab ist; Eindrücke hinzufügen</translation>
    </message>
    <message>
        <source>{} of {} presses had to be left out; find out why</source>
        <translation>{} von {} Eindrücken mussten ausgelassen werden; Ursache klären</translation>
    </message>
    <message>
        <source>neither calibrated nor checked for {:.0f} days; check it with {} presses</source>
        <translation>seit {} Tagen weder kalibriert noch geprüft; mit {} Eindrücken prüfen</translation>
    </message>
    <message>
        <source>next to contacts, {:.3f} mm of depth is measured: light scatters sideways there, or the skin is pressed in</source>
        <translation>neben Kontakten werden {} mm Tiefe gemessen: dort streut Licht seitlich, oder die Haut ist eingedrückt</translation>
    </message>
    <message>
        <source>fine relief needs an error of at most {:.2f} mm</source>
        <translation>feines Relief braucht einen Fehler von höchstens {} mm</translation>
    </message>
    <message>
        <source>ball of {:.2f} mm diameter</source>
        <translation>Kugel von {} mm Durchmesser</translation>
    </message>
    <message>
        <source>balls of {:.2f} to {:.2f} mm diameter</source>
        <translation>Kugeln von {} bis {} mm Durchmesser</translation>
    </message>
    <message>
        <source>layer {:.2f} mm</source>
        <translation>Schicht {} mm</translation>
    </message>
    <message>
        <source>image {:.2f} mm wide</source>
        <translation>Bild {} mm breit</translation>
    </message>
    <message>
        <source>face {:.2f} mm wide</source>
        <translation>Fläche {} mm breit</translation>
    </message>
    <message>
        <source>expected error {:.3f} mm</source>
        <translation>erwarteter Fehler {} mm</translation>
    </message>
    <message>
        <source>expected error {:.3f} mm, {}</source>
        <translation>erwarteter Fehler {} mm, {}</translation>
    </message>
    <message>
        <source>no expected error can be given</source>
        <translation>ein Fehler lässt sich nicht angeben</translation>
    </message>
    <message>
        <source>calibrate again from the stored presses</source>
        <translation>aus den gespeicherten Eindrücken neu kalibrieren</translation>
    </message>
    <message>
        <source>mostly bodies of other shape than the ball: measure one press&apos;s depth</source>
        <translation>vor allem bei Körpern anderer Form als der Kugel: die Tiefe eines Eindrucks messen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a whole number</source>
        <translation>„{}“ ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>two points are resolved from {:.2f} mm on; depth is right within a tenth on walls of {:.2f} mm, on pins of {:.2f} mm and {:.2f} mm from a step</source>
        <translation>zwei Punkte werden ab {} mm getrennt; auf Stegen von {} mm, auf Stiften von {} mm und {} mm neben einer Stufe stimmt die Tiefe auf ein Zehntel</translation>
    </message>
    <message>
        <source>{}, if light does not scatter sideways</source>
        <translation>{}, sofern kein Licht seitlich streut</translation>
    </message>
    <message>
        <source>has another number of waves</source>
        <translation>hat eine andere Zahl von Wellen</translation>
    </message>
    <message>
        <source>Light in the layer scatters aside before it comes back</source>
        <translation>Licht streut in der Schicht zur Seite, bevor es zurückkommt</translation>
    </message>
    <message>
        <source>two effects for one layer: its light is local or scatters</source>
        <translation>zwei Effekte für eine Schicht: ihr Licht ist örtlich oder streut</translation>
    </message>
    <message>
        <source>naming the effect layer or the effect scatter</source>
        <translation>entweder den Effekt layer oder den Effekt scatter anzugeben</translation>
    </message>
    <message>
        <source>of its {} bits per pixel only the lower {} are in use: these were taken as the entire range</source>
        <translation>von seinen {} Bit je Pixel sind nur die unteren {} in Gebrauch: diese wurden als voller Bereich genommen</translation>
    </message>
    <message>
        <source>it does not state the range of its brightness: 16 to 235 was assumed</source>
        <translation>der Bereich seiner Helligkeit ist nicht angegeben: 16 bis 235 wurde angenommen</translation>
    </message>
    <message>
        <source>it does not state the range of its brightness: it has levels below 9, so 0 to 255 was assumed</source>
        <translation>der Bereich seiner Helligkeit ist nicht angegeben: Werte unter 9 kommen vor, also wurde 0 bis 255 angenommen</translation>
    </message>
    <message>
        <source>it is nearly black: no pixel reaches grey level {:.0f} of 255; check light and exposure</source>
        <translation>es ist fast schwarz: kein Pixel erreicht die Graustufe {:.0f} von 255; Licht und Belichtung prüfen</translation>
    </message>
    <message>
        <source>{:.0f} % of it is saturated; reduce exposure or light</source>
        <translation>{:.0f} % davon sind übersteuert; Belichtung oder Licht verringern</translation>
    </message>
    <message>
        <source>it is in colour: its channels differ from grey by {:.0f} %; only its brightness is used</source>
        <translation>es ist farbig: seine Kanäle weichen um {:.0f} % von Grau ab; nur die Helligkeit wird verwendet</translation>
    </message>
    <message>
        <source>another copy, or recording it again</source>
        <translation>eine andere Kopie, oder neu aufnehmen</translation>
    </message>
    <message>
        <source>this is no JPEG</source>
        <translation>das ist kein JPEG</translation>
    </message>
    <message>
        <source>its header gives {} x {} px</source>
        <translation>sein Kopf nennt {} x {} px</translation>
    </message>
    <message>
        <source>the JPEG is truncated or damaged</source>
        <translation>das JPEG ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>of the 16 bits per pixel only the lower {} are in use: these are taken as the entire range</source>
        <translation>von den 16 Bit je Pixel sind nur die unteren {} in Gebrauch: diese gelten als voller Bereich</translation>
    </message>
    <message>
        <source>its JPEGs contain stray bytes, which cost no pixel</source>
        <translation>ihre JPEGs enthalten überzählige Bytes, die kein Pixel kosten</translation>
    </message>
    <message>
        <source>this system&apos;s libavcodec cannot read H.264</source>
        <translation>die libavcodec dieses Systems kann H.264 nicht lesen</translation>
    </message>
    <message>
        <source>another format of the camera</source>
        <translation>ein anderes Format der Kamera</translation>
    </message>
    <message>
        <source>H.264 cannot be decoded</source>
        <translation>H.264 lässt sich nicht dekodieren</translation>
    </message>
    <message>
        <source>a frame of H.264 is damaged</source>
        <translation>ein Bild in H.264 ist beschädigt</translation>
    </message>
    <message>
        <source>the image has {} bits per channel (floating point); 8 to 16 as integers are needed</source>
        <translation>das Bild hat {} Bit je Kanal (Gleitkomma); nötig sind 8 bis 16 als ganze Zahlen</translation>
    </message>
    <message>
        <source>the camera&apos;s own images</source>
        <translation>die eigenen Bilder der Kamera</translation>
    </message>
    <message>
        <source>16 bits per pixel were reduced to 8</source>
        <translation>16 Bit je Pixel wurden auf 8 verringert</translation>
    </message>
    <message>
        <source>of 16 bits per pixel only the lower {} are in use: these were taken as the entire range</source>
        <translation>von 16 Bit je Pixel sind nur die unteren {} in Gebrauch: diese wurden als voller Bereich genommen</translation>
    </message>
    <message>
        <source>viewers are asked to turn them (Exif orientation {}), which is not done here: the camera&apos;s orientation is a setting of the finger</source>
        <translation>Betrachter sollen sie drehen (Exif-Ausrichtung {}), was hier nicht geschieht: die Ausrichtung der Kamera ist eine Einstellung des Fingers</translation>
    </message>
    <message>
        <source>png, jpg, bmp, tif or pgm images, a video that players open, or a yaml scene</source>
        <translation>png-, jpg-, bmp-, tif- oder pgm-Bilder, ein Video, das Abspielprogramme öffnen, oder eine yaml-Szene</translation>
    </message>
    <message>
        <source>stopped before the video was open</source>
        <translation>abgebrochen, bevor das Video offen war</translation>
    </message>
    <message>
        <source>looking for the order of the video&apos;s frames</source>
        <translation>suche die Reihenfolge der Bilder des Videos</translation>
    </message>
    <message>
        <source>{} of its {} frames cannot be decoded and are missing</source>
        <translation>{} seiner {} Bilder lassen sich nicht dekodieren und fehlen</translation>
    </message>
    <message>
        <source>it asks viewers to turn it by {} degrees, which is not done here: the camera&apos;s orientation is a setting of the finger</source>
        <translation>Betrachter sollen es um {} Grad drehen, was hier nicht geschieht: die Ausrichtung der Kamera ist eine Einstellung des Fingers</translation>
    </message>
    <message>
        <source>The images</source>
        <translation>Die Bilder</translation>
    </message>
    <message>
        <source>Images of the camera</source>
        <translation>Bilder der Kamera</translation>
    </message>
    <message>
        <source>AprilGrid</source>
        <translation>AprilGrid</translation>
    </message>
    <message>
        <source>no markers in the order of this board are visible</source>
        <translation>keine Marker in der Anordnung dieser Tafel sind sichtbar</translation>
    </message>
    <message>
        <source>the markers of this board are of the dictionary {}, not {}</source>
        <translation>die Marker dieser Tafel stammen aus dem Wörterbuch {}, nicht {}</translation>
    </message>
    <message>
        <source>--dictionary {}</source>
        <translation>--dictionary {}</translation>
    </message>
    <message>
        <source>this image is mirrored, unlike others</source>
        <translation>dieses Bild ist gespiegelt, andere nicht</translation>
    </message>
    <message>
        <source>images from one camera in one mode</source>
        <translation>Bilder einer Kamera in einer Betriebsart</translation>
    </message>
    <message>
        <source>only {} of the board&apos;s corners are visible, {} are needed</source>
        <translation>nur {} Ecken der Tafel sind sichtbar, {} sind nötig</translation>
    </message>
    <message>
        <source>only corners in one line of the board are visible</source>
        <translation>nur Ecken der Tafel auf einer Geraden sind sichtbar</translation>
    </message>
    <message>
        <source>the markers of this board are of the dictionary {}</source>
        <translation>die Marker dieser Tafel stammen aus dem Wörterbuch {}</translation>
    </message>
    <message>
        <source>this board has the layout of OpenCV before 4.6 and of calib.io: its first square is white</source>
        <translation>diese Tafel hat die Anordnung von OpenCV vor 4.6 und von calib.io: ihr erstes Feld ist weiß</translation>
    </message>
    <message>
        <source>the first square of this board is white, with a marker</source>
        <translation>das erste Feld dieser Tafel ist weiß und trägt einen Marker</translation>
    </message>
    <message>
        <source>this board has the layout of OpenCV from 4.6 on: its first square is black</source>
        <translation>diese Tafel hat die Anordnung von OpenCV ab 4.6: ihr erstes Feld ist schwarz</translation>
    </message>
    <message>
        <source>the markers of this board are counted from {}</source>
        <translation>die Marker dieser Tafel sind ab {} nummeriert</translation>
    </message>
    <message>
        <source>the board is mirrored in these images; the lens is valid for images that are mirrored in the same direction</source>
        <translation>die Tafel ist in diesen Bildern gespiegelt; das Objektiv gilt für Bilder, die ebenso gespiegelt sind</translation>
    </message>
    <message>
        <source>black and white of this board are exchanged</source>
        <translation>Schwarz und Weiß dieser Tafel sind vertauscht</translation>
    </message>
    <message>
        <source>fx and fy differ by {:.1f} %: a board with squares that are {:.1f} % {} than high explains it, and pixels are then square; measure the board&apos;s width and height with a caliper, and print it without scaling</source>
        <translation>fx und fy unterscheiden sich um {} %: eine Tafel, deren Felder um {} % {} als hoch sind, erklärt es, und die Pixel sind dann quadratisch; Breite und Höhe der Tafel mit dem Messschieber messen und sie ohne Skalierung drucken</translation>
    </message>
    <message>
        <source>fx and fy differ by {:.1f} %, although the board is square within {:.1f} %: the camera stretches its images, or its pixels are not square</source>
        <translation>fx und fy unterscheiden sich um {} %, obwohl die Tafel auf {} % quadratisch ist: die Kamera streckt ihre Bilder, oder ihre Pixel sind nicht quadratisch</translation>
    </message>
    <message>
        <source>fx and fy differ by {:.1f} %: a board printed {:.1f} % {} than high and pixels that are not square look alike in these views. The board is likelier: measure its width and height with a caliper, and turn it by 90 degrees in half of the views</source>
        <translation>fx und fy unterscheiden sich um {} %: eine um {} % {} als hoch gedruckte Tafel und nicht quadratische Pixel sehen in diesen Ansichten gleich aus. Wahrscheinlicher ist die Tafel: ihre Breite und Höhe mit dem Messschieber messen und sie in der Hälfte der Ansichten um 90 Grad drehen</translation>
    </message>
    <message>
        <source>with squares of this size the boards are {:.2g} mm from the lens, and the finger {:g} mm: give --square-mm in millimetres, not in {}</source>
        <translation>mit Feldern dieser Größe sind die Tafeln {} mm vom Objektiv entfernt, der Finger {} mm: --square-mm in Millimetern angeben, nicht in {}</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Metern</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>Mikrometern</translation>
    </message>
    <message>
        <source>ChArUco, AprilGrid: family of the markers; any tries all</source>
        <translation>ChArUco, AprilGrid: Familie der Marker; any versucht alle</translation>
    </message>
    <message>
        <source>AprilGrid: gap of two tags as a fraction of a tag&apos;s side</source>
        <translation>AprilGrid: Abstand zweier Tags als Anteil der Tagseite</translation>
    </message>
    <message>
        <source>asymmetric dots</source>
        <translation>versetzte Punkte</translation>
    </message>
    <message>
        <source>tags</source>
        <translation>Tags</translation>
    </message>
    <message>
        <source>inner corners are counted, not squares</source>
        <translation>gezählt werden innere Ecken, nicht Felder</translation>
    </message>
    <message>
        <source>tags of a row and of a column are counted</source>
        <translation>gezählt werden die Tags einer Zeile und einer Spalte</translation>
    </message>
    <message>
        <source>dots of a row and of a column are counted</source>
        <translation>gezählt werden die Punkte einer Zeile und einer Spalte</translation>
    </message>
    <message>
        <source>this board has {}, not {} x {}</source>
        <translation>diese Tafel hat {}, nicht {} x {}</translation>
    </message>
    <message>
        <source>--board {}x{}: {}</source>
        <translation>--board {}x{}: {}</translation>
    </message>
    <message>
        <source>this board is {}</source>
        <translation>diese Tafel ist {}</translation>
    </message>
    <message>
        <source>a ChArUco board</source>
        <translation>eine ChArUco-Tafel</translation>
    </message>
    <message>
        <source>an AprilGrid</source>
        <translation>ein AprilGrid</translation>
    </message>
    <message>
        <source>a chessboard with {}</source>
        <translation>ein Schachbrett mit {}</translation>
    </message>
    <message>
        <source>a symmetric grid with {}</source>
        <translation>ein symmetrisches Raster mit {}</translation>
    </message>
    <message>
        <source>a grid with {}</source>
        <translation>ein Raster mit {}</translation>
    </message>
    <message>
        <source>two halves of the views give {} = {:.1f} and {:.1f} px</source>
        <translation>zwei Hälften der Ansichten ergeben {} = {} und {} px</translation>
    </message>
    <message>
        <source>fx and fy differ by {:.1f} %: the board is likely out of square</source>
        <translation>fx und fy unterscheiden sich um {} %: die Tafel ist wahrscheinlich nicht maßhaltig</translation>
    </message>
    <message>
        <source>the squares of the board are stretched by {:.1f} %</source>
        <translation>die Felder der Tafel sind um {} % gestreckt</translation>
    </message>
    <message>
        <source>the board is bent by about {:.2g} mm</source>
        <translation>die Tafel ist um etwa {} mm gebogen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is given twice</source>
        <translation>„{}“ ist zweimal angegeben</translation>
    </message>
    <message>
        <source>an alias stands for nothing</source>
        <translation>ein Alias steht für nichts</translation>
    </message>
    <message>
        <source>this is not XML: {}</source>
        <translation>dies ist kein XML: {}</translation>
    </message>
    <message>
        <source>copy the file again</source>
        <translation>die Datei noch einmal kopieren</translation>
    </message>
    <message>
        <source>a bracket is not closed</source>
        <translation>eine Klammer ist nicht geschlossen</translation>
    </message>
    <message>
        <source>is a MAT-file, which is not text</source>
        <translation>ist eine MAT-Datei und kein Text</translation>
    </message>
    <message>
        <source>in Matlab: writelines(jsonencode(toStruct(cameraParams)), &apos;camera.json&apos;)</source>
        <translation>in Matlab: writelines(jsonencode(toStruct(cameraParams)), &apos;camera.json&apos;)</translation>
    </message>
    <message>
        <source>is a packed archive</source>
        <translation>ist ein gepacktes Archiv</translation>
    </message>
    <message>
        <source>unpack it, and use a file of it</source>
        <translation>es entpacken und eine Datei daraus verwenden</translation>
    </message>
    <message>
        <source>is no text file</source>
        <translation>ist keine Textdatei</translation>
    </message>
    <message>
        <source>a calibration as YAML, JSON or XML</source>
        <translation>eine Kalibrierung als YAML, JSON oder XML</translation>
    </message>
    <message>
        <source>brown: k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4, fisheye: k1 k2 k3 k4, others: []</source>
        <translation>brown: k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4, fisheye: k1 k2 k3 k4, andere: []</translation>
    </message>
    <message>
        <source>keys that are not known here were not read: {}</source>
        <translation>hier unbekannte Schlüssel wurden nicht gelesen: {}</translation>
    </message>
    <message>
        <source>a camera file of this program</source>
        <translation>Kameradatei dieses Programms</translation>
    </message>
    <message>
        <source>is a key of other programs, whose numbers would be lost here</source>
        <translation>ist ein Schlüssel anderer Programme, dessen Zahlen hier verloren gingen</translation>
    </message>
    <message>
        <source>the other program&apos;s file unchanged, or &apos;distortion: [...]&apos; instead of it</source>
        <translation>die unveränderte Datei des anderen Programms, oder stattdessen &apos;distortion: [...]&apos;</translation>
    </message>
    <message>
        <source>no distortion</source>
        <translation>ohne Verzeichnung</translation>
    </message>
    <message>
        <source>read as {}: {} x {} px, {:g} mm per px</source>
        <translation>gelesen als {}: {} x {} px, {} mm je px</translation>
    </message>
    <message>
        <source>read as {}: {} x {} px, fx {:.1f}, {}</source>
        <translation>gelesen als {}: {} x {} px, fx {}, {}</translation>
    </message>
    <message>
        <source>ends in the middle of a list, as a file that was cut off</source>
        <translation>endet mitten in einer Liste, wie eine abgeschnittene Datei</translation>
    </message>
    <message>
        <source>copy the file again, or end its last line with a line break</source>
        <translation>die Datei noch einmal kopieren oder ihre letzte Zeile mit einem Zeilenumbruch beenden</translation>
    </message>
    <message>
        <source>is a block without &apos;data&apos;</source>
        <translation>ist ein Block ohne &apos;data&apos;</translation>
    </message>
    <message>
        <source>holds more numbers than a camera has</source>
        <translation>enthält mehr Zahlen, als eine Kamera hat</translation>
    </message>
    <message>
        <source>holds &apos;{}&apos;, which is not a finite number</source>
        <translation>enthält „{}“, was keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>holds {} numbers instead of {}</source>
        <translation>enthält {} statt {} Zahlen</translation>
    </message>
    <message>
        <source>must be a single number</source>
        <translation>muss eine einzelne Zahl sein</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is missing</source>
        <translation>„{}“ fehlt</translation>
    </message>
    <message>
        <source>contradicts &apos;{}&apos;</source>
        <translation>widerspricht „{}“</translation>
    </message>
    <message>
        <source>delete the one that is wrong</source>
        <translation>den falschen Eintrag löschen</translation>
    </message>
    <message>
        <source>{:g} x {:g} is no image size</source>
        <translation>{} x {} ist keine Bildgröße</translation>
    </message>
    <message>
        <source>holds no width and height</source>
        <translation>enthält keine Breite und Höhe</translation>
    </message>
    <message>
        <source>is 0: this camera is not calibrated</source>
        <translation>ist 0: diese Kamera ist nicht kalibriert</translation>
    </message>
    <message>
        <source>a calibration, as of &apos;alltact lens&apos;</source>
        <translation>eine Kalibrierung, etwa mit &apos;alltact lens&apos;</translation>
    </message>
    <message>
        <source>is no camera matrix, with the last row 0 0 1</source>
        <translation>ist keine Kameramatrix mit der letzten Zeile 0 0 1</translation>
    </message>
    <message>
        <source>the matrix [fx, 0, cx, 0, fy, cy, 0, 0, 1]</source>
        <translation>die Matrix [fx, 0, cx, 0, fy, cy, 0, 0, 1]</translation>
    </message>
    <message>
        <source>has a skew of {:g}, which the camera here cannot have</source>
        <translation>hat eine Scherung von {}, die die Kamera hier nicht haben kann</translation>
    </message>
    <message>
        <source>calibrate again without skew</source>
        <translation>ohne Scherung neu kalibrieren</translation>
    </message>
    <message>
        <source>the lens model &apos;{}&apos; cannot be expressed here</source>
        <translation>das Objektivmodell „{}“ lässt sich hier nicht ausdrücken</translation>
    </message>
    <message>
        <source>has {} coefficients; a fisheye has 4</source>
        <translation>hat {} Koeffizienten; ein Fischauge hat 4</translation>
    </message>
    <message>
        <source>has {} coefficients; OpenCV knows 4, 5, 8, 12 and 14</source>
        <translation>hat {} Koeffizienten; OpenCV kennt 4, 5, 8, 12 und 14</translation>
    </message>
    <message>
        <source>describes a tilted sensor, which cannot be expressed here</source>
        <translation>beschreibt einen geneigten Sensor, der sich hier nicht ausdrücken lässt</translation>
    </message>
    <message>
        <source>calibrate again without CALIB_TILTED_MODEL, or run &apos;alltact lens&apos;</source>
        <translation>ohne CALIB_TILTED_MODEL neu kalibrieren oder &apos;alltact lens&apos; ausführen</translation>
    </message>
    <message>
        <source>has coefficients, while the file names no lens model</source>
        <translation>hat Koeffizienten, während die Datei kein Objektivmodell nennt</translation>
    </message>
    <message>
        <source>add the model&apos;s name, such as plumb_bob</source>
        <translation>den Namen des Modells ergänzen, etwa plumb_bob</translation>
    </message>
    <message>
        <source>run &apos;alltact lens&apos; with images of a board</source>
        <translation>&apos;alltact lens&apos; mit Bildern einer Tafel ausführen</translation>
    </message>
    <message>
        <source>the camera bins its images by {:g}, while its matrix holds for full images</source>
        <translation>die Kamera fasst Pixel {}-fach zusammen, ihre Matrix gilt aber für volle Bilder</translation>
    </message>
    <message>
        <source>the camera without binning, and &apos;binning_x: 1&apos;, &apos;binning_y: 1&apos;</source>
        <translation>die Kamera ohne Binning, und &apos;binning_x: 1&apos;, &apos;binning_y: 1&apos;</translation>
    </message>
    <message>
        <source>the camera sends a part of its image, while its matrix holds for all</source>
        <translation>die Kamera sendet einen Teil ihres Bildes, ihre Matrix gilt aber für das ganze</translation>
    </message>
    <message>
        <source>the camera without a region of interest, and a file without &apos;roi&apos;</source>
        <translation>die Kamera ohne Bildausschnitt, und eine Datei ohne &apos;roi&apos;</translation>
    </message>
    <message>
        <source>the camera matrix is missing</source>
        <translation>die Kameramatrix fehlt</translation>
    </message>
    <message>
        <source>add &apos;camera_matrix: [fx, 0, cx, 0, fy, cy, 0, 0, 1]&apos;</source>
        <translation>&apos;camera_matrix: [fx, 0, cx, 0, fy, cy, 0, 0, 1]&apos; ergänzen</translation>
    </message>
    <message>
        <source>a ROS camera_info file</source>
        <translation>camera_info-Datei von ROS</translation>
    </message>
    <message>
        <source>an OpenCV calibration</source>
        <translation>Kalibrierung von OpenCV</translation>
    </message>
    <message>
        <source>the distortion coefficients are missing</source>
        <translation>die Verzeichnungskoeffizienten fehlen</translation>
    </message>
    <message>
        <source>add &apos;distortion_coefficients: [0, 0, 0, 0, 0]&apos; where there is no distortion</source>
        <translation>&apos;distortion_coefficients: [0, 0, 0, 0, 0]&apos; ergänzen, wenn es keine Verzeichnung gibt</translation>
    </message>
    <message>
        <source>no lens model is named, so that the 4 coefficients are read as k1 k2 p1 p2; for a fisheye add &apos;distortion_model: fisheye&apos;</source>
        <translation>kein Objektivmodell ist genannt, daher werden die 4 Koeffizienten als k1 k2 p1 p2 gelesen; für ein Fischauge &apos;distortion_model: fisheye&apos; ergänzen</translation>
    </message>
    <message>
        <source>a Kalibr camera chain</source>
        <translation>Kamerakette von Kalibr</translation>
    </message>
    <message>
        <source>calibrate again with pinhole-radtan or pinhole-equi</source>
        <translation>mit pinhole-radtan oder pinhole-equi neu kalibrieren</translation>
    </message>
    <message>
        <source>an mrcal camera model</source>
        <translation>Kameramodell von mrcal</translation>
    </message>
    <message>
        <source>convert it with mrcal-convert-lensmodel to LENSMODEL_OPENCV8</source>
        <translation>es mit mrcal-convert-lensmodel in LENSMODEL_OPENCV8 umwandeln</translation>
    </message>
    <message>
        <source>a PhotonVision calibration</source>
        <translation>Kalibrierung von PhotonVision</translation>
    </message>
    <message>
        <source>calibrate again with LENSMODEL_OPENCV</source>
        <translation>mit LENSMODEL_OPENCV neu kalibrieren</translation>
    </message>
    <message>
        <source>Matlab&apos;s camera parameters</source>
        <translation>Kameraparameter von Matlab</translation>
    </message>
    <message>
        <source>the focal lengths are missing</source>
        <translation>die Brennweiten fehlen</translation>
    </message>
    <message>
        <source>a calibration.json of this program</source>
        <translation>calibration.json dieses Programms</translation>
    </message>
    <message>
        <source>a newer version of this program</source>
        <translation>eine neuere Version dieses Programms</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not known here</source>
        <translation>„{}“ ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>none, flip_u, flip_v, rotate_180, rotate_90 or rotate_270</source>
        <translation>none, flip_u, flip_v, rotate_180, rotate_90 oder rotate_270</translation>
    </message>
    <message>
        <source>the image size is missing</source>
        <translation>die Bildgröße fehlt</translation>
    </message>
    <message>
        <source>add image_width and image_height of the calibrated images, in pixels</source>
        <translation>image_width und image_height der kalibrierten Bilder in Pixeln ergänzen</translation>
    </message>
    <message>
        <source>the principal point {:.1f}, {:.1f} lies outside the image of {} x {} px</source>
        <translation>der Hauptpunkt {}, {} liegt außerhalb des Bildes von {} x {} px</translation>
    </message>
    <message>
        <source>the size [width, height] of the images that were calibrated</source>
        <translation>die Größe [Breite, Höhe] der kalibrierten Bilder</translation>
    </message>
    <message>
        <source>holds parameters of a ROS node, without focal lengths</source>
        <translation>enthält Parameter eines ROS-Knotens ohne Brennweiten</translation>
    </message>
    <message>
        <source>camera_info.yaml of the same export</source>
        <translation>camera_info.yaml desselben Exports</translation>
    </message>
    <message>
        <source>holds no camera that is known here</source>
        <translation>enthält keine hier bekannte Kamera</translation>
    </message>
    <message>
        <source>a file of &apos;alltact lens&apos;, ROS, OpenCV, Kalibr, mrcal, PhotonVision or Matlab</source>
        <translation>eine Datei von &apos;alltact lens&apos;, ROS, OpenCV, Kalibr, mrcal, PhotonVision oder Matlab</translation>
    </message>
    <message>
        <source>holds no camera &apos;{}&apos;</source>
        <translation>enthält keine Kamera „{}“</translation>
    </message>
    <message>
        <source>holds {} cameras: {}</source>
        <translation>enthält {} Kameras: {}</translation>
    </message>
    <message>
        <source>one of them by its name: &apos;{}#{}&apos;</source>
        <translation>eine davon beim Namen nennen: &apos;{}#{}&apos;</translation>
    </message>
    <message numerus="yes">
        <source>{1} with {0} coefficients</source>
        <comment>{1} with {0} coefficient</comment>
        <translation>
            <numerusform>{1} mit {0} Koeffizient</numerusform>
            <numerusform>{1} mit {0} Koeffizienten</numerusform>
        </translation>
    </message>
    <message>
        <source>holds no number</source>
        <translation>enthält keine Zahl</translation>
    </message>
    <message>
        <source>the principal point {:.1f}, {:.1f} is the middle of {} x {} px, not of {} x {}</source>
        <translation>der Hauptpunkt {}, {} ist die Mitte von {} x {} px, nicht von {} x {}</translation>
    </message>
    <message>
        <source>no program on this computer opens this file</source>
        <translation>kein Programm auf diesem Rechner öffnet diese Datei</translation>
    </message>
    <message>
        <source>install one, such as a web browser for reports, or open the file on another computer</source>
        <translation>eines installieren, für Berichte etwa einen Webbrowser, oder die Datei auf einem anderen Rechner öffnen</translation>
    </message>
    <message>
        <source>the visible part of the contact face is not indented</source>
        <translation>der sichtbare Teil der Kontaktfläche ist nicht eingedrückt</translation>
    </message>
    <message>
        <source>too little of the face is pressed in to find the body&apos;s pose</source>
        <translation>für die Lage des Körpers ist zu wenig von der Fläche eingedrückt</translation>
    </message>
    <message>
        <source>a frame with a deeper or wider contact</source>
        <translation>ein Bild mit einem tieferen oder breiteren Kontakt</translation>
    </message>
    <message>
        <source>a mesh of the body that presses, in millimetres</source>
        <translation>ein Netz des drückenden Körpers, in Millimetern</translation>
    </message>
    <message>
        <source>stopped before the body was compared</source>
        <translation>angehalten, bevor der Körper verglichen wurde</translation>
    </message>
    <message>
        <source>must be four numbers from 0 to 1000</source>
        <translation>muss aus vier Zahlen von 0 bis 1000 bestehen</translation>
    </message>
    <message>
        <source>the standard deviations of fx, fy, cx and cy in pixels, or none</source>
        <translation>die Standardabweichungen von fx, fy, cx und cy in Pixeln, oder nichts</translation>
    </message>
    <message>
        <source>the recording is not complete</source>
        <translation>die Aufnahme ist nicht vollständig</translation>
    </message>
    <message>
        <source>record again</source>
        <translation>nochmals aufnehmen</translation>
    </message>
    <message>
        <source>neighbouring frames represent it: the recording is long</source>
        <translation>benachbarte Bilder vertreten es: die Aufnahme ist lang</translation>
    </message>
    <message>
        <source>the deepest point is at a limit of the measuring range</source>
        <translation>die tiefste Stelle liegt an einer Grenze des Messbereichs</translation>
    </message>
    <message>
        <source>a shallower contact</source>
        <translation>ein flacherer Kontakt</translation>
    </message>
    <message>
        <source>the line ends before half of its greatest depth</source>
        <translation>die Linie endet vor der Hälfte ihrer größten Tiefe</translation>
    </message>
    <message>
        <source>a line across the entire contact</source>
        <translation>eine Linie über den ganzen Kontakt</translation>
    </message>
    <message>
        <source>the other finger is not calibrated yet</source>
        <translation>der andere Finger ist noch nicht kalibriert</translation>
    </message>
    <message>
        <source>calibrating it, or choosing another one</source>
        <translation>ihn kalibrieren oder einen anderen wählen</translation>
    </message>
    <message>
        <source>there is no recording</source>
        <translation>es gibt keine Aufnahme</translation>
    </message>
    <message>
        <source>stopped before all recordings were inspected</source>
        <translation>angehalten, bevor alle Aufnahmen ausgewertet waren</translation>
    </message>
</context>
<context>
    <name>alltact::CopyFigure</name>
    <message>
        <source>Copied: %1 × %2 px</source>
        <translation>Kopiert: %1 × %2 px</translation>
    </message>
    <message>
        <source>&amp;Copy the figure</source>
        <translation>Abbildung &amp;kopieren</translation>
    </message>
</context>
<context>
    <name>alltact::ForceDialog</name>
    <message>
        <source>train the forces</source>
        <translation>Kräfte trainieren</translation>
    </message>
    <message>
        <source>mean force</source>
        <translation>mittlere Kraft</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>quadratic</source>
        <translation>quadratisch</translation>
    </message>
    <message>
        <source>network</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Train the forces</source>
        <translation>Kräfte trainieren</translation>
    </message>
    <message>
        <source>A table has the markers&apos; positions of each frame and the forces of a gauge, as alltact force --collect writes it. Each stretch is held out once to measure the error.</source>
        <translation>Eine Tabelle enthält für jedes Bild die Positionen der Marken und die Kräfte eines Kraftmessers, wie alltact force --collect sie schreibt. Jeder Abschnitt wird einmal ausgelassen, um den Fehler zu messen.</translation>
    </message>
    <message>
        <source>Choose &amp;tables…</source>
        <translation>&amp;Tabellen wählen…</translation>
    </message>
    <message>
        <source>One or more tables of this finger (CSV); training begins at once</source>
        <translation>Eine oder mehrere Tabellen dieses Fingers (CSV); das Training beginnt sofort</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Ends the training without a result</source>
        <translation>Beendet das Training ohne Ergebnis</translation>
    </message>
    <message>
        <source>&amp;Install</source>
        <translation>&amp;Übernehmen</translation>
    </message>
    <message>
        <source>Forces come from this model from now on; undo restores the one before</source>
        <translation>Kräfte kommen von nun an aus diesem Modell; Rückgängig stellt das vorige wieder her</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Forgets this result; the finger stays as it is</source>
        <translation>Verwirft das Ergebnis; der Finger bleibt, wie er ist</translation>
    </message>
    <message>
        <source>Progress of the training</source>
        <translation>Fortschritt des Trainings</translation>
    </message>
    <message>
        <source>Errors on held-out frames</source>
        <translation>Fehler an ausgelassenen Bildern</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Mean error, N</source>
        <translation>Mittlerer Fehler, N</translation>
    </message>
    <message>
        <source>R²</source>
        <translation>R²</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Gewählt</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabellen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>Schließt dieses Fenster (Esc)</translation>
    </message>
    <message>
        <source>Tables of markers and forces</source>
        <translation>Tabellen von Marken und Kräften</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.tsv)</source>
        <translation>Tabellen (*.csv *.txt *.tsv)</translation>
    </message>
    <message>
        <source>No table yet.</source>
        <translation>Noch keine Tabelle.</translation>
    </message>
    <message>
        <source>The model is installed.</source>
        <translation>Das Modell ist übernommen.</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>Of the held-out frames %1 % lie within the 95 % interval; the gauge&apos;s noise is at most %2 N. Values are by axis: Fx, Fy, Fz.</source>
        <translation>Von den ausgelassenen Bildern liegen %1 % im 95-%-Intervall; das Rauschen des Kraftmessers ist höchstens %2 N. Werte je Achse: Fx, Fy, Fz.</translation>
    </message>
</context>
<context>
    <name>alltact::SidePanel</name>
    <message>
        <source>Drag: width of the panel. Double click: as at first.</source>
        <translation>Ziehen: Breite der Leiste. Doppelklick: wie zu Beginn.</translation>
    </message>
</context>
<context>
    <name>alltact::FrameChooser</name>
    <message>
        <source>Leave &amp;out the selected frames</source>
        <translation>Gewählte Bilder &amp;auslassen</translation>
    </message>
    <message>
        <source>Leave &amp;out %1</source>
        <translation>%1 &amp;auslassen</translation>
    </message>
    <message>
        <source>&amp;Use %1</source>
        <translation>%1 &amp;verwenden</translation>
    </message>
    <message>
        <source>leave out %1</source>
        <translation>%1 auslassen</translation>
    </message>
    <message>
        <source>use %1</source>
        <translation>%1 verwenden</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>frames %1 to %2</source>
        <translation>Bilder %1 bis %2</translation>
    </message>
    <message>
        <source>Select frames in the strip: drag, or press Shift and an arrow key.</source>
        <translation>Wählen Sie Bilder im Streifen: ziehen Sie, oder drücken Sie Umschalt und eine Pfeiltaste.</translation>
    </message>
    <message>
        <source>Show the live i&amp;mage</source>
        <translation>Live-Bild &amp;zeigen</translation>
    </message>
    <message>
        <source>Frame %1 of the recording</source>
        <translation>Bild %1 der Aufnahme</translation>
    </message>
    <message>
        <source>darkest spot: %1 % darker</source>
        <translation>dunkelste Stelle: %1 % dunkler</translation>
    </message>
    <message>
        <source>darkest in frame %1</source>
        <translation>am dunkelsten in Bild %1</translation>
    </message>
</context>
<context>
    <name>alltact::FrameTable</name>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
</context>
<context>
    <name>alltact::RecordingsInspection</name>
    <message>
        <source>Save the table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Inspection of a folder</source>
        <translation>Auswertung eines Ordners</translation>
    </message>
    <message>
        <source>Readings of each recording</source>
        <translation>Werte jeder Aufnahme</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Kleinster</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Undecided</source>
        <translation>Unentschieden</translation>
    </message>
    <message>
        <source>Progress of the inspection</source>
        <translation>Fortschritt der Auswertung</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Ends the inspection without a result</source>
        <translation>Beendet die Auswertung ohne Ergebnis</translation>
    </message>
    <message>
        <source>Save &amp;table (CSV)…</source>
        <translation>&amp;Tabelle speichern (CSV)…</translation>
    </message>
    <message>
        <source>The table that alltact inspect --each writes, to the byte</source>
        <translation>Die Tabelle, die alltact inspect --each schreibt, Byte für Byte</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>Schließt dieses Fenster (Esc)</translation>
    </message>
    <message>
        <source>The recordings are being measured…</source>
        <translation>Die Aufnahmen werden vermessen…</translation>
    </message>
    <message>
        <source>Nothing was inspected.</source>
        <translation>Nichts wurde ausgewertet.</translation>
    </message>
    <message>
        <source>Written: %1.</source>
        <translation>Geschrieben: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) inspected.</source>
        <translation>
            <numerusform>%n Aufnahme ausgewertet.</numerusform>
            <numerusform>%n Aufnahmen ausgewertet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s), of which %1 could not be inspected.</source>
        <translation>
            <numerusform>%n Aufnahme, davon %1 nicht auswertbar.</numerusform>
            <numerusform>%n Aufnahmen, davon %1 nicht auswertbar.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::RecordingsDialog</name>
    <message>
        <source>Recordings of %1</source>
        <translation>Aufnahmen von %1</translation>
    </message>
    <message>
        <source>Recordings, newest first</source>
        <translation>Aufnahmen, die neuesten zuerst</translation>
    </message>
    <message>
        <source>Double click or Return opens a recording; Delete moves it to the trash</source>
        <translation>Doppelklick oder Eingabetaste öffnet eine Aufnahme, Entf verschiebt sie in den Papierkorb</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Show in folder</source>
        <translation>Im Ordner &amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Move to the trash…</source>
        <translation>In den &amp;Papierkorb verschieben…</translation>
    </message>
    <message>
        <source>&amp;Move to the trash</source>
        <translation>In den &amp;Papierkorb verschieben</translation>
    </message>
    <message>
        <source>Move to the trash</source>
        <translation>In den Papierkorb verschieben</translation>
    </message>
    <message>
        <source>Move %1 to the trash?</source>
        <translation>%1 in den Papierkorb verschieben?</translation>
    </message>
    <message>
        <source>Opens the selected recording on this page (Return)</source>
        <translation>Öffnet die gewählte Aufnahme auf dieser Seite (Eingabetaste)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>Schließt dieses Fenster (Esc)</translation>
    </message>
    <message>
        <source>The folder is being read.</source>
        <translation>Der Ordner wird gelesen.</translation>
    </message>
    <message>
        <source>The finger&apos;s folder has no video yet.</source>
        <translation>Im Ordner des Fingers ist noch kein Video.</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>The finger&apos;s reference</source>
        <translation>Referenz des Fingers</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>%1 cannot be moved to the trash. Delete it in its folder.</source>
        <translation>%1 lässt sich nicht in den Papierkorb verschieben. Löschen Sie die Datei in ihrem Ordner.</translation>
    </message>
</context>
</TS>
