<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Figures</name>
    <message>
        <source>Residual (mm)</source>
        <translation>Restfehler (mm)</translation>
    </message>
    <message>
        <source>Error, left out (mm)</source>
        <translation>Fehler, ausgelassen (mm)</translation>
    </message>
    <message>
        <source>Depth&apos;s sd (mm)</source>
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
</context>
<context>
    <name>alltact::CalibratePlace</name>
    <message>
        <source>&amp;Next: %1</source>
        <translation>&amp;Weiter: %1</translation>
    </message>
</context>
<context>
    <name>alltact::CalibrationRun</name>
    <message>
        <source>calibrate</source>
        <translation>kalibrieren</translation>
    </message>
    <message>
        <source>The command line, alltact, is not installed beside this program.</source>
        <translation>Die Befehlszeile, alltact, ist nicht neben diesem Programm installiert.</translation>
    </message>
</context>
<context>
    <name>alltact::CheckPage</name>
    <message>
        <source>Pass</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Drifting</source>
        <translation>Driftet</translation>
    </message>
    <message>
        <source>Recalibrate</source>
        <translation>Neu kalibrieren</translation>
    </message>
    <message>
        <source>Three presses</source>
        <translation>Drei Eindrücke</translation>
    </message>
    <message>
        <source>Is it still what it was?</source>
        <translation>Ist er noch, was er war?</translation>
    </message>
    <message>
        <source>Press the ball of the calibration in at three places, base, middle and tip, and take a picture of each. The calibration stays as it is.</source>
        <translation>Drücken Sie die Kugel der Kalibrierung an drei Stellen ein, Fuß, Mitte und Spitze, und nehmen Sie jede auf. Die Kalibrierung bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>&amp;Take a press (Space)</source>
        <translation>Eindruck auf&amp;nehmen (Leertaste)</translation>
    </message>
    <message>
        <source>&amp;Begin again</source>
        <translation>Von vorn &amp;beginnen</translation>
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
        <source>There is no live picture: choose a source.</source>
        <translation>Es gibt kein Livebild: Wählen Sie eine Quelle.</translation>
    </message>
    <message>
        <source>The finger is not calibrated.</source>
        <translation>Der Finger ist nicht kalibriert.</translation>
    </message>
    <message>
        <source>The check is being made.</source>
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
        <source>Checked last on %1.</source>
        <translation>Zuletzt geprüft am %1.</translation>
    </message>
    <message>
        <source>%1 of %2 taken.</source>
        <translation>%1 von %2 aufgenommen.</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
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
        <source>An automatic mode has it in hand.</source>
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
        <source>Automatic modes stay off, and what changes by itself is put back.</source>
        <translation>Automatiken bleiben aus, und was sich von selbst ändert, wird zurückgestellt.</translation>
    </message>
    <message>
        <source>Brightness is the measurement: locked, nothing changes it. Unlock it before calibrating only.</source>
        <translation>Helligkeit ist die Messung: Gesperrt ändert sie nichts. Nur vor dem Kalibrieren entsperren.</translation>
    </message>
    <message>
        <source>A camera&apos;s exposure, gain, white balance and focus stand here. This source is no camera.</source>
        <translation>Hier stehen Belichtung, Verstärkung, Weißabgleich und Fokus einer Kamera. Diese Quelle ist keine Kamera.</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
</context>
<context>
    <name>alltact::ConvergencePlot</name>
    <message>
        <source>How the solution settles</source>
        <translation>Wie sich die Lösung einstellt</translation>
    </message>
    <message numerus="yes">
        <source>After %n round(s) %1 mm are left.</source>
        <translation>
            <numerusform>Nach %n Durchgang bleiben %1 mm.</numerusform>
            <numerusform>Nach %n Durchgängen bleiben %1 mm.</numerusform>
        </translation>
    </message>
    <message>
        <source>The solution has not begun to settle yet</source>
        <translation>Die Lösung hat noch nicht begonnen, sich einzustellen</translation>
    </message>
    <message>
        <source>Left over</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Left over (mm)</source>
        <translation>Rest (mm)</translation>
    </message>
    <message>
        <source>Still moves</source>
        <translation>Bewegt sich noch</translation>
    </message>
    <message>
        <source>Unknowns still move by (mm)</source>
        <translation>Unbekannte bewegen sich noch um (mm)</translation>
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
        <source>No pose has been seen yet.</source>
        <translation>Noch keine Haltung gesehen.</translation>
    </message>
    <message>
        <source>All directions are reached.</source>
        <translation>Alle Richtungen sind erreicht.</translation>
    </message>
    <message>
        <source>Missing: %1.</source>
        <translation>Es fehlen: %1.</translation>
    </message>
</context>
<context>
    <name>alltact::ExportDialog</name>
    <message>
        <source>Export finger</source>
        <translation>Finger exportieren</translation>
    </message>
    <message>
        <source>What finger %1 has learnt, for other programs.</source>
        <translation>Was der Finger %1 gelernt hat, für andere Programme.</translation>
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
        <source>The camera as drivers and image_pipeline read it; face, markers and mapping as parameters of a ROS 2 node.</source>
        <translation>Die Kamera, wie Treiber und image_pipeline sie lesen; Fläche, Marken und Abbildung als Parameter eines ROS-2-Knotens.</translation>
    </message>
    <message>
        <source>&amp;JSON: calibration.json</source>
        <translation>&amp;JSON: calibration.json</translation>
    </message>
    <message>
        <source>All figures in one file, for programs of your own.</source>
        <translation>Alle Zahlen in einer Datei, für eigene Programme.</translation>
    </message>
    <message>
        <source>&amp;Whole finger: finger.zip</source>
        <translation>&amp;Ganzer Finger: finger.zip</translation>
    </message>
    <message>
        <source>Every file of the finger, its untouched pictures too: to keep, to send, and to measure with in Python.</source>
        <translation>Jede Datei des Fingers, auch seine unberührten Bilder: zum Aufbewahren, zum Verschicken und zum Messen in Python.</translation>
    </message>
    <message>
        <source>Nothing is chosen.</source>
        <translation>Nichts ist gewählt.</translation>
    </message>
    <message>
        <source>No folder is named.</source>
        <translation>Kein Ordner ist genannt.</translation>
    </message>
    <message>
        <source>Written: %1.</source>
        <translation>Geschrieben: %1.</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Ordner öffnen</translation>
    </message>
</context>
<context>
    <name>alltact::FaceMapPlot</name>
    <message>
        <source>%1 over the face</source>
        <translation>%1 über der Fläche</translation>
    </message>
    <message>
        <source>Nothing is known of the face yet</source>
        <translation>Von der Fläche ist noch nichts bekannt</translation>
    </message>
    <message>
        <source>Along the finger, from the base (mm)</source>
        <translation>Längs des Fingers, vom Fuß (mm)</translation>
    </message>
    <message>
        <source>Along the picture, from the left (mm)</source>
        <translation>Längs des Bildes, von links (mm)</translation>
    </message>
    <message>
        <source>Across (mm)</source>
        <translation>Quer (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::FaceView</name>
    <message>
        <source>Face in 3D</source>
        <translation>Fläche in 3D</translation>
    </message>
</context>
<context>
    <name>alltact::FingerPage</name>
    <message>
        <source>A flat, rigid sensor with a layer of %1 mm, %2 mm before the camera.</source>
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
        <source>What it looks like untouched</source>
        <translation>Wie er unberührt aussieht</translation>
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
        <source>Take the &amp;untouched picture now</source>
        <translation>&amp;Unberührtes Bild jetzt aufnehmen</translation>
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
        <source>Its untouched picture is missing.</source>
        <translation>Sein unberührtes Bild fehlt.</translation>
    </message>
    <message>
        <source>Its reference recording is missing: record it bending, untouched.</source>
        <translation>Seine Referenzaufnahme fehlt: Nehmen Sie ihn beim Biegen auf, unberührt.</translation>
    </message>
    <message>
        <source>Width and layer are measured with a caliper, dots are counted. All that is known of one finger is kept in one folder.</source>
        <translation>Breite und Schicht werden mit dem Messschieber gemessen, Punkte gezählt. Alles, was von einem Finger bekannt ist, liegt in einem Ordner.</translation>
    </message>
    <message>
        <source>Its untouched picture is there.</source>
        <translation>Sein unberührtes Bild ist da.</translation>
    </message>
    <message>
        <source>Its reference recording is installed.</source>
        <translation>Seine Referenzaufnahme ist eingerichtet.</translation>
    </message>
    <message>
        <source>Every press is compared with one picture of the untouched face.</source>
        <translation>Jeder Eindruck wird mit einem Bild der unberührten Fläche verglichen.</translation>
    </message>
    <message>
        <source>Every press is compared with a picture of the finger bent alike and not touched. Record it bending in all directions, then install the recording.</source>
        <translation>Jeder Eindruck wird mit einem Bild des gleich gebogenen, unberührten Fingers verglichen. Nehmen Sie ihn beim Biegen in alle Richtungen auf und richten Sie die Aufnahme ein.</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>Finger</translation>
    </message>
</context>
<context>
    <name>alltact::FrameWords</name>
    <message>
        <source>The finger is pushed from its contact face.</source>
        <translation>Der Finger wird von der Kontaktfläche her gedrückt.</translation>
    </message>
    <message>
        <source>The finger is pushed from its back.</source>
        <translation>Der Finger wird vom Rücken her gedrückt.</translation>
    </message>
    <message>
        <source>The finger is pushed from its upper side.</source>
        <translation>Der Finger wird von der oberen Seite her gedrückt.</translation>
    </message>
    <message>
        <source>The finger is pushed from its lower side.</source>
        <translation>Der Finger wird von der unteren Seite her gedrückt.</translation>
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
        <source>Nothing presses on the contact face.</source>
        <translation>Nichts drückt auf die Kontaktfläche.</translation>
    </message>
    <message numerus="yes">
        <source>%n contact(s) on the face.</source>
        <translation>
            <numerusform>%n Kontakt auf der Fläche.</numerusform>
            <numerusform>%n Kontakte auf der Fläche.</numerusform>
        </translation>
    </message>
    <message>
        <source>Deepest %1 mm, area %2 mm², volume %3 mm³.</source>
        <translation>Am tiefsten %1 mm, Fläche %2 mm², Volumen %3 mm³.</translation>
    </message>
    <message>
        <source>Not known without a reference recording.</source>
        <translation>Ohne Referenzaufnahme nicht bekannt.</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>Tiefe, mm</translation>
    </message>
</context>
<context>
    <name>alltact::GripperDialog</name>
    <message>
        <source>%1 in the gripper</source>
        <translation>%1 im Greifer</translation>
    </message>
    <message>
        <source>Where the camera of %1 sits in the gripper&apos;s frame: its place, and how it is turned about the gripper&apos;s axes, first x, then y, then z. A camera that is not turned looks along the gripper&apos;s z, with x along its picture and y across it.</source>
        <translation>Wo die Kamera von %1 im Koordinatensystem des Greifers sitzt: ihr Ort, und wie sie um die Achsen des Greifers gedreht ist, erst x, dann y, dann z. Eine Kamera, die nicht gedreht ist, blickt entlang z des Greifers, mit x längs und y quer zu ihrem Bild.</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>&amp;Ort</translation>
    </message>
    <message>
        <source>&amp;Turned about</source>
        <translation>&amp;Gedreht um</translation>
    </message>
    <message>
        <source>Place, x</source>
        <translation>Ort, x</translation>
    </message>
    <message>
        <source>Place, y</source>
        <translation>Ort, y</translation>
    </message>
    <message>
        <source>Place, z</source>
        <translation>Ort, z</translation>
    </message>
    <message>
        <source>Turned about x</source>
        <translation>Gedreht um x</translation>
    </message>
    <message>
        <source>Turned about y</source>
        <translation>Gedreht um y</translation>
    </message>
    <message>
        <source>Turned about z</source>
        <translation>Gedreht um z</translation>
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
        <source>Takes the place out of the finger&apos;s file.</source>
        <translation>Nimmt den Ort aus der Datei des Fingers heraus.</translation>
    </message>
</context>
<context>
    <name>alltact::HistogramPlot</name>
    <message>
        <source>Spread of the errors</source>
        <translation>Streuung der Fehler</translation>
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
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The camera&apos;s picture. The wheel or + and - zoom, 0 shows all of it, 1 its own size. Drag or use the arrow keys to move it; Shift and the arrow keys move the probe.</source>
        <translation>Das Bild der Kamera. Rad oder + und - vergrößern, 0 zeigt alles, 1 die eigene Größe. Ziehen oder Pfeiltasten verschieben es; Umschalt und Pfeiltasten bewegen die Sonde.</translation>
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
</context>
<context>
    <name>alltact::InspectPlace</name>
    <message>
        <source>&amp;Live finger</source>
        <translation>&amp;Live-Finger</translation>
    </message>
    <message>
        <source>&amp;Video…</source>
        <translation>&amp;Video …</translation>
    </message>
    <message>
        <source>F&amp;older of pictures…</source>
        <translation>&amp;Ordner mit Bildern …</translation>
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
        <source>Ours</source>
        <translation>Unser Verfahren</translation>
    </message>
    <message>
        <source>Ours less the paper&apos;s method</source>
        <translation>Unser Verfahren minus das der Veröffentlichung</translation>
    </message>
    <message>
        <source>The paper&apos;s method</source>
        <translation>Verfahren der Veröffentlichung</translation>
    </message>
    <message>
        <source>put point B</source>
        <translation>Punkt B setzen</translation>
    </message>
    <message>
        <source>put point A</source>
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
        <source>The finger is not calibrated yet, so brightness cannot be told as depth.</source>
        <translation>Der Finger ist noch nicht kalibriert; Helligkeit lässt sich nicht als Tiefe angeben.</translation>
    </message>
    <message>
        <source>The face was not found in this picture.</source>
        <translation>In diesem Bild wurde die Fläche nicht gefunden.</translation>
    </message>
    <message>
        <source>The finger is being loaded.</source>
        <translation>Der Finger wird geladen.</translation>
    </message>
    <message>
        <source>Nothing can be shown; above stands why.</source>
        <translation>Es kann nichts gezeigt werden; oben steht, warum.</translation>
    </message>
    <message>
        <source>The recording is being opened.</source>
        <translation>Die Aufnahme wird geöffnet.</translation>
    </message>
    <message>
        <source>No source is open. Choose one above, or open a recording.</source>
        <translation>Keine Quelle ist offen. Wählen Sie oben eine, oder öffnen Sie eine Aufnahme.</translation>
    </message>
    <message>
        <source>No finger is open. Open the one that is seen, above.</source>
        <translation>Kein Finger ist offen. Öffnen Sie oben den, der zu sehen ist.</translation>
    </message>
    <message>
        <source>Waiting for the first picture.</source>
        <translation>Warten auf das erste Bild.</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>Video öffnen</translation>
    </message>
    <message>
        <source>Videos (*.mkv *.avi *.mp4)</source>
        <translation>Videos (*.mkv *.avi *.mp4)</translation>
    </message>
    <message>
        <source>Open a folder of pictures</source>
        <translation>Ordner mit Bildern öffnen</translation>
    </message>
    <message>
        <source>Save what is shown</source>
        <translation>Gezeigtes speichern</translation>
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
        <translation>%1 prüfen</translation>
    </message>
    <message>
        <source>go on with what was inspected</source>
        <translation>mit dem Geprüften weitermachen</translation>
    </message>
    <message>
        <source>inspect the live finger</source>
        <translation>den Finger live prüfen</translation>
    </message>
    <message>
        <source>1: %1, 2: %2, in the gripper&apos;s frame X, Y, Z</source>
        <translation>1: %1, 2: %2, im Koordinatensystem X, Y, Z des Greifers</translation>
    </message>
    <message>
        <source>place %1 in the gripper</source>
        <translation>Ort von %1 im Greifer</translation>
    </message>
    <message>
        <source>Where the camera of %1 sits in the gripper is not known, so the two fingers are shown each in its own camera&apos;s frame.</source>
        <translation>Wo die Kamera von %1 im Greifer sitzt, ist nicht bekannt; deshalb wird jeder der beiden Finger im Koordinatensystem seiner eigenen Kamera gezeigt.</translation>
    </message>
    <message>
        <source>Tell its place and how it is turned.</source>
        <translation>Ihren Ort und ihre Drehung angeben.</translation>
    </message>
    <message>
        <source>Place of &amp;2…</source>
        <translation>Ort von &amp;2…</translation>
    </message>
    <message>
        <source>Place of &amp;1…</source>
        <translation>Ort von &amp;1…</translation>
    </message>
    <message>
        <source>show a second finger</source>
        <translation>einen zweiten Finger zeigen</translation>
    </message>
    <message>
        <source>close the second finger</source>
        <translation>den zweiten Finger schließen</translation>
    </message>
</context>
<context>
    <name>alltact::InspectSide</name>
    <message>
        <source>show as %1</source>
        <translation>zeigen: %1</translation>
    </message>
    <message>
        <source>look from: %1</source>
        <translation>Blick: %1</translation>
    </message>
    <message>
        <source>compare: %1</source>
        <translation>vergleichen: %1</translation>
    </message>
    <message>
        <source>change the depth colours</source>
        <translation>Tiefenfarben ändern</translation>
    </message>
    <message>
        <source>draw depth larger</source>
        <translation>Tiefe größer zeichnen</translation>
    </message>
    <message>
        <source>show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>take the points away</source>
        <translation>Punkte wegnehmen</translation>
    </message>
    <message>
        <source>move point A</source>
        <translation>Punkt A verschieben</translation>
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
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>&amp;Zeigen</translation>
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
        <source>3D needs OpenGL 3.2, which this screen does not offer.</source>
        <translation>3D braucht OpenGL 3.2, das dieser Bildschirm nicht bietet.</translation>
    </message>
    <message>
        <source>Look &amp;from</source>
        <translation>&amp;Blick von</translation>
    </message>
    <message>
        <source>inside, tilted</source>
        <translation>innen, geneigt</translation>
    </message>
    <message>
        <source>the camera</source>
        <translation>der Kamera</translation>
    </message>
    <message>
        <source>outside, tilted</source>
        <translation>außen, geneigt</translation>
    </message>
    <message>
        <source>the side</source>
        <translation>der Seite</translation>
    </message>
    <message>
        <source>Com&amp;pare</source>
        <translation>&amp;Vergleich</translation>
    </message>
    <message>
        <source>with nothing</source>
        <translation>keiner</translation>
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
        <source>With the source paper&apos;s own formulas, on the same frame and the same finger.</source>
        <translation>Mit den Formeln der Veröffentlichung, am selben Bild und Finger.</translation>
    </message>
    <message>
        <source>Colours &amp;end at</source>
        <translation>&amp;Farben enden bei</translation>
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
        <source>&amp;Draw depth</source>
        <translation>&amp;Tiefe zeichnen</translation>
    </message>
    <message>
        <source> times</source>
        <translation>-fach</translation>
    </message>
    <message>
        <source>Times that depth is drawn larger than it is</source>
        <translation>Wievielfach die Tiefe größer gezeichnet wird, als sie ist</translation>
    </message>
    <message>
        <source>&amp;Untouched face as lines</source>
        <translation>&amp;Unberührte Fläche als Linien</translation>
    </message>
    <message>
        <source>C&amp;amera and its axes</source>
        <translation>&amp;Kamera und ihre Achsen</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>Querschnitt</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Point &amp;A</source>
        <translation>Punkt &amp;A</translation>
    </message>
    <message>
        <source>Point &amp;B</source>
        <translation>Punkt &amp;B</translation>
    </message>
    <message>
        <source>Point A, u</source>
        <translation>Punkt A, u</translation>
    </message>
    <message>
        <source>Point A, v</source>
        <translation>Punkt A, v</translation>
    </message>
    <message>
        <source>Point B, u</source>
        <translation>Punkt B, u</translation>
    </message>
    <message>
        <source>Point B, v</source>
        <translation>Punkt B, v</translation>
    </message>
    <message>
        <source>u </source>
        <translation>u </translation>
    </message>
    <message>
        <source>v </source>
        <translation>v </translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
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
        <source>Takes both points away.</source>
        <translation>Nimmt beide Punkte weg.</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer</translation>
    </message>
    <message>
        <source>From edge to edge of the finger, through A or the deepest point.</source>
        <translation>Von Rand zu Rand des Fingers, durch A oder den tiefsten Punkt.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Längs</translation>
    </message>
    <message>
        <source>From base to tip, through A or the deepest point.</source>
        <translation>Vom Ansatz zur Spitze, durch A oder den tiefsten Punkt.</translation>
    </message>
    <message>
        <source>Measured at the points</source>
        <translation>An den Punkten gemessen</translation>
    </message>
    <message>
        <source>Nothing to measure yet.</source>
        <translation>Noch nichts zu messen.</translation>
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
        <source>, %1 mm a pixel</source>
        <translation>, %1 mm je Pixel</translation>
    </message>
    <message>
        <source>, focal length %1 px</source>
        <translation>, Brennweite %1 px</translation>
    </message>
    <message>
        <source>, behind a window</source>
        <translation>, hinter einem Fenster</translation>
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
        <source>Or measured with pictures of a board</source>
        <translation>Oder mit Bildern einer Tafel gemessen</translation>
    </message>
    <message>
        <source>Camera file</source>
        <translation>Kameradatei</translation>
    </message>
    <message>
        <source>camera.yaml, as the lens calibration writes it</source>
        <translation>camera.yaml, wie die Objektivkalibrierung sie schreibt</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Wählen…</translation>
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
        <source>&amp;Pictures</source>
        <translation>&amp;Bilder</translation>
    </message>
    <message>
        <source>Folder of board pictures, or a recording</source>
        <translation>Ordner mit Tafelbildern oder eine Aufnahme</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder of board pictures</source>
        <translation>Ordner der Tafelbilder wählen</translation>
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
        <source>&amp;Inner corners, or dots</source>
        <translation>&amp;Innere Ecken oder Punkte</translation>
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
        <translation>&amp;Seite eines Quadrats</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Seite eines Quadrats</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
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
        <source>The lens has to be known first: choose a camera file, or measure one.</source>
        <translation>Zuerst muss das Objektiv bekannt sein: Wählen Sie eine Kameradatei oder messen Sie es.</translation>
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
        <source>A finger measures through its camera&apos;s lens, so the lens comes first. It is measured once for each camera, with ten to twenty pictures of a flat board from all sides.</source>
        <translation>Ein Finger misst durch das Objektiv seiner Kamera, darum kommt es zuerst. Es wird für jede Kamera einmal gemessen, mit zehn bis zwanzig Bildern einer ebenen Tafel von allen Seiten.</translation>
    </message>
    <message>
        <source>Camera (*.yaml *.yml)</source>
        <translation>Kamera (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>Folder of board pictures</source>
        <translation>Ordner mit Tafelbildern</translation>
    </message>
    <message>
        <source>No folder of pictures is named.</source>
        <translation>Es ist kein Ordner mit Bildern genannt.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Geschrieben nach %1.</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objektiv</translation>
    </message>
</context>
<context>
    <name>alltact::LivePlace</name>
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
        <source>Over the picture</source>
        <translation>Über dem Bild</translation>
    </message>
    <message>
        <source>&amp;Edges of the face</source>
        <translation>&amp;Kanten der Fläche</translation>
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
        <source>A ring: the marker is seen. A dashed diamond: its place is an estimate.</source>
        <translation>Ring: Die Marke ist zu sehen. Gestrichelte Raute: Ihr Ort ist geschätzt.</translation>
    </message>
    <message>
        <source>Stripes falling to the right: too bright to measure. Stripes falling to the left: too dark.</source>
        <translation>Nach rechts fallende Streifen: zu hell zum Messen. Nach links fallende: zu dunkel.</translation>
    </message>
    <message>
        <source>Colours &amp;end at</source>
        <translation>Farben &amp;enden bei</translation>
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
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Time of a frame</source>
        <translation>Zeit für ein Bild</translation>
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
        <source>No picture yet.</source>
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
        <source>All together</source>
        <translation>Alles zusammen</translation>
    </message>
</context>
<context>
    <name>alltact::MainWindow</name>
    <message>
        <source>&amp;Open finger…</source>
        <translation>Finger ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;New finger…</source>
        <translation>&amp;Neuer Finger…</translation>
    </message>
    <message>
        <source>&amp;Close finger</source>
        <translation>Finger s&amp;chließen</translation>
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
        <source>&amp;Live</source>
        <translation>&amp;Live</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Aufnehmen</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;Help on this place</source>
        <translation>&amp;Hilfe zu diesem Ort</translation>
    </message>
    <message>
        <source>&amp;About AllTact Studio</source>
        <translation>&amp;Über AllTact Studio</translation>
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
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Recent fingers</source>
        <translation>&amp;Zuletzt geöffnete Finger</translation>
    </message>
    <message>
        <source>&amp;Source</source>
        <translation>&amp;Quelle</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Live (Ctrl+1)</source>
        <translation>Live (Strg+1)</translation>
    </message>
    <message>
        <source>Finger:</source>
        <translation>Finger:</translation>
    </message>
    <message>
        <source>Source:</source>
        <translation>Quelle:</translation>
    </message>
    <message>
        <source>Frames delivered</source>
        <translation>Gelieferte Bilder</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>Verlorene Bilder</translation>
    </message>
    <message>
        <source>Age of the picture</source>
        <translation>Alter des Bildes</translation>
    </message>
    <message>
        <source>Time of a frame</source>
        <translation>Zeit für ein Bild</translation>
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
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
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
        <source>Folder of &amp;pictures…</source>
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
        <source>Open a finger&apos;s folder</source>
        <translation>Ordner eines Fingers öffnen</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>Video öffnen</translation>
    </message>
    <message>
        <source>Videos (*.mkv *.avi *.mp4)</source>
        <translation>Videos (*.mkv *.avi *.mp4)</translation>
    </message>
    <message>
        <source>Open a folder of pictures</source>
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
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>About AllTact Studio</source>
        <translation>Über AllTact Studio</translation>
    </message>
    <message>
        <source>## AllTact Studio %1

Turns a clear silicone finger with a camera inside into a measuring instrument.

Its own source is under the BSD-3-Clause licence; with the libraries it uses, the program as a whole is under the GPL, version 3.</source>
        <translation>## AllTact Studio %1

Macht aus einem klaren Silikonfinger mit einer Kamera darin ein Messgerät.

Der eigene Quelltext steht unter der BSD-3-Clause-Lizenz; mit den verwendeten Bibliotheken steht das Programm als Ganzes unter der GPL, Version 3.</translation>
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
        <source>Finger: %1</source>
        <translation>Finger: %1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Quelle: %1</translation>
    </message>
    <message>
        <source>%1 frames/s, %2 delivered, %3 shown a second</source>
        <translation>%1 Bilder/s, %2 geliefert, %3 je Sekunde gezeigt</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) lost</source>
        <translation>
            <numerusform>%n Bild verloren</numerusform>
            <numerusform>%n Bilder verloren</numerusform>
        </translation>
    </message>
    <message>
        <source>picture %1 ms old</source>
        <translation>Bild %1 ms alt</translation>
    </message>
    <message>
        <source>pictures without times</source>
        <translation>Bilder ohne Zeitangabe</translation>
    </message>
    <message>
        <source>%1 ms a frame</source>
        <translation>%1 ms je Bild</translation>
    </message>
    <message>
        <source>The program ended unexpectedly last time.</source>
        <translation>Das Programm endete das letzte Mal unerwartet.</translation>
    </message>
    <message>
        <source>What was worked on is kept.</source>
        <translation>Woran gearbeitet wurde, ist erhalten.</translation>
    </message>
    <message>
        <source>&amp;Go on with it</source>
        <translation>Damit &amp;weitermachen</translation>
    </message>
    <message>
        <source>The source has ended; its last picture is shown.</source>
        <translation>Die Quelle ist zu Ende; ihr letztes Bild wird gezeigt.</translation>
    </message>
    <message>
        <source>&amp;Play it again</source>
        <translation>Noch einmal a&amp;bspielen</translation>
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
        <source>This finger is not calibrated yet, so that no depth is shown.</source>
        <translation>Dieser Finger ist noch nicht kalibriert, darum wird keine Tiefe gezeigt.</translation>
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
    <message>
        <source>none</source>
        <comment>source</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>close the finger</source>
        <translation>Finger schließen</translation>
    </message>
    <message>
        <source>open finger %1</source>
        <translation>Finger %1 öffnen</translation>
    </message>
    <message>
        <source>close the source</source>
        <translation>Quelle schließen</translation>
    </message>
    <message>
        <source>open source %1</source>
        <translation>Quelle %1 öffnen</translation>
    </message>
    <message>
        <source>go on with the last session</source>
        <translation>mit der letzten Sitzung weitermachen</translation>
    </message>
    <message>
        <source>none</source>
        <comment>finger</comment>
        <translation>keiner</translation>
    </message>
    <message>
        <source>&amp;Calibrate</source>
        <translation>&amp;Kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate (Ctrl+2)</source>
        <translation>Kalibrieren (Strg+2)</translation>
    </message>
    <message>
        <source>Record (Ctrl+3)</source>
        <translation>Aufnehmen (Strg+3)</translation>
    </message>
    <message>
        <source>Calibrate it with ball presses.</source>
        <translation>Kalibrieren Sie ihn mit Kugeleindrücken.</translation>
    </message>
    <message>
        <source>&amp;Go to Calibrate</source>
        <translation>&amp;Zu Kalibrieren</translation>
    </message>
    <message>
        <source>&amp;Inspect</source>
        <translation>&amp;Prüfen</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Inspect (Ctrl+4)</source>
        <translation>Prüfen (Strg+4)</translation>
    </message>
    <message>
        <source>E&amp;xport finger…</source>
        <translation>Finger e&amp;xportieren …</translation>
    </message>
    <message>
        <source>recording %1</source>
        <translation>Aufnahme %1</translation>
    </message>
    <message>
        <source>The foot pedal is not heard now.</source>
        <translation>Das Fußpedal ist gerade nicht zu hören.</translation>
    </message>
</context>
<context>
    <name>alltact::MappingPage</name>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Keeps the best solution so far</source>
        <translation>Behält die bisher beste Lösung</translation>
    </message>
    <message>
        <source>What has been done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Progress of the calibration</source>
        <translation>Fortschritt der Kalibrierung</translation>
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
        <source>The calibration is being made.</source>
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
        <source>The presses have changed since this calibration.</source>
        <translation>Die Eindrücke haben sich seit dieser Kalibrierung geändert.</translation>
    </message>
    <message>
        <source>This finger is calibrated. Calibrating again shows the figures.</source>
        <translation>Dieser Finger ist kalibriert. Neu kalibrieren zeigt die Abbildungen.</translation>
    </message>
    <message>
        <source>With one press or more, what every pixel&apos;s darkening means in mm is learnt from the shape of the ball.</source>
        <translation>Mit einem Eindruck oder mehreren wird aus der Form der Kugel gelernt, was die Verdunkelung jedes Pixels in mm bedeutet.</translation>
    </message>
    <message>
        <source>What every pixel&apos;s darkening means in mm is learnt from the shape of the ball, with all presses together. Each press is left out once to see how well the others foretell it.</source>
        <translation>Was die Verdunkelung jedes Pixels in mm bedeutet, wird aus der Form der Kugel gelernt, mit allen Eindrücken zusammen. Jeder Eindruck wird einmal ausgelassen, um zu sehen, wie gut die anderen ihn vorhersagen.</translation>
    </message>
    <message>
        <source>Mapping: %1.</source>
        <translation>Abbildung: %1.</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Abbildung</translation>
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
        <source>Brightness difference x (share of the untouched brightness)</source>
        <translation>Helligkeitsunterschied x (Anteil der unberührten Helligkeit)</translation>
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
    <name>alltact::NewFingerDialog</name>
    <message>
        <source>New finger</source>
        <translation>Neuer Finger</translation>
    </message>
    <message>
        <source>&amp;Folder to make</source>
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
        <source>found out by the reference recording</source>
        <translation>wird aus der Referenzaufnahme erkannt</translation>
    </message>
    <message>
        <source>brighter than around them</source>
        <translation>heller als ihre Umgebung</translation>
    </message>
    <message>
        <source>darker than around them</source>
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
        <source>Folder to make</source>
        <translation>Neuer Ordner</translation>
    </message>
    <message>
        <source>Camera file</source>
        <translation>Kameradatei</translation>
    </message>
    <message>
        <source>Camera (*.yaml *.yml)</source>
        <translation>Kamera (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>No folder is named.</source>
        <translation>Es ist kein Ordner angegeben.</translation>
    </message>
    <message>
        <source>No camera file is named.</source>
        <translation>Es ist keine Kameradatei angegeben.</translation>
    </message>
    <message>
        <source>Measure width and layer with a caliper, and count the dots. The camera file comes from the lens calibration, the first step of Calibrate.</source>
        <translation>Breite und Schicht mit dem Messschieber messen, die Punkte zählen. Die Kameradatei kommt aus der Objektivkalibrierung, dem ersten Schritt von Kalibrieren.</translation>
    </message>
    <message>
        <source>The first step of Calibrate makes one.</source>
        <translation>Der erste Schritt von Kalibrieren erzeugt sie.</translation>
    </message>
</context>
<context>
    <name>alltact::OutlineEditor</name>
    <message>
        <source>Picture with the ball&apos;s outline</source>
        <translation>Bild mit dem Umriss der Kugel</translation>
    </message>
    <message>
        <source>Drag the outline&apos;s centre or rim onto the ball. Arrow keys move it by a tenth of a pixel, Page Up and Page Down change its size, with Shift by a whole pixel. Ctrl and the arrow keys move the picture; the wheel zooms, over the rim it changes the size.</source>
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
        <source>Close it</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Place of 1…</source>
        <translation>Ort von 1…</translation>
    </message>
    <message>
        <source>Place of 2…</source>
        <translation>Ort von 2…</translation>
    </message>
    <message>
        <source>Place of the first finger in the gripper</source>
        <translation>Ort des ersten Fingers im Greifer</translation>
    </message>
    <message>
        <source>Place of the second finger in the gripper</source>
        <translation>Ort des zweiten Fingers im Greifer</translation>
    </message>
    <message>
        <source>Where this finger&apos;s camera sits in the gripper.</source>
        <translation>Wo die Kamera dieses Fingers im Greifer sitzt.</translation>
    </message>
    <message>
        <source>Distance between the faces</source>
        <translation>Abstand der Flächen</translation>
    </message>
    <message>
        <source>How the two recordings are joined</source>
        <translation>Wie die beiden Aufnahmen verbunden sind</translation>
    </message>
    <message>
        <source>Open a recording first; a second one can be joined to it.</source>
        <translation>Zuerst eine Aufnahme öffnen; mit ihr kann eine zweite verbunden werden.</translation>
    </message>
    <message>
        <source>Joined by time stamps; 2 was taken %1 ms after 1.</source>
        <translation>Nach Zeitstempeln verbunden; 2 entstand %1 ms nach 1.</translation>
    </message>
    <message>
        <source>Recorded at different times: their beginnings count as one moment; 2 was taken %1 ms after 1.</source>
        <translation>Zu verschiedenen Zeiten aufgenommen: Ihre Anfänge gelten als ein Augenblick; 2 entstand %1 ms nach 1.</translation>
    </message>
    <message>
        <source>Without time stamps: joined by the number of the frame.</source>
        <translation>Ohne Zeitstempel: nach der Nummer des Bildes verbunden.</translation>
    </message>
    <message>
        <source>Measuring the distance…</source>
        <translation>Der Abstand wird gemessen…</translation>
    </message>
    <message>
        <source>&lt;b&gt;The faces touch or cross.&lt;/b&gt;</source>
        <translation>&lt;b&gt;Die Flächen berühren oder durchdringen sich.&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 mm&lt;/b&gt; between the faces where they are nearest, around X %2, Y %3, Z %4 mm</source>
        <translation>&lt;b&gt;%1 mm&lt;/b&gt; zwischen den Flächen, wo sie sich am nächsten sind, um X %2, Y %3, Z %4 mm</translation>
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
    <name>alltact::PicturePanel</name>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Show the whole picture</source>
        <translation>Das ganze Bild zeigen</translation>
    </message>
    <message>
        <source>Show the picture in its own size</source>
        <translation>Das Bild in eigener Größe zeigen</translation>
    </message>
    <message>
        <source>1:1</source>
        <translation>1:1</translation>
    </message>
    <message>
        <source>Under the probe</source>
        <translation>Unter der Sonde</translation>
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
        <source>The source could not be opened; above stands why.</source>
        <translation>Die Quelle konnte nicht geöffnet werden; oben steht, warum.</translation>
    </message>
    <message>
        <source>No source is open. Choose a camera, a recording or the simulated finger.</source>
        <translation>Keine Quelle ist offen. Wählen Sie eine Kamera, eine Aufnahme oder den simulierten Finger.</translation>
    </message>
    <message>
        <source>Waiting for the first picture.</source>
        <translation>Warten auf das erste Bild.</translation>
    </message>
    <message>
        <source>Point at a pixel, or press Shift and an arrow key.</source>
        <translation>Auf ein Pixel zeigen oder Umschalt und eine Pfeiltaste drücken.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>alltact::PressDesk</name>
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
        <source>take out %1</source>
        <translation>%1 herausnehmen</translation>
    </message>
    <message>
        <source>put back %1</source>
        <translation>%1 zurücknehmen</translation>
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
        <source>add %n picture(s)</source>
        <translation>
            <numerusform>%n Bild hinzufügen</numerusform>
            <numerusform>%n Bilder hinzufügen</numerusform>
        </translation>
    </message>
    <message>
        <source>There are presses of these names already: %1.</source>
        <translation>Eindrücke mit diesen Namen gibt es schon: %1.</translation>
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
        <source>residual: the mapping knows this press</source>
        <translation>Restfehler: Die Abbildung kennt diesen Eindruck</translation>
    </message>
    <message>
        <source>left out: the mapping was made without it</source>
        <translation>ausgelassen: Die Abbildung entstand ohne ihn</translation>
    </message>
    <message numerus="yes">
        <source>Mean depth error inside the contact (mm); %n better press(es) not shown</source>
        <translation>
            <numerusform>Mittlerer Tiefenfehler im Kontakt (mm); %n besserer Eindruck nicht gezeigt</numerusform>
            <numerusform>Mittlerer Tiefenfehler im Kontakt (mm); %n bessere Eindrücke nicht gezeigt</numerusform>
        </translation>
    </message>
    <message>
        <source>Mean depth error inside the contact (mm)</source>
        <translation>Mittlerer Tiefenfehler im Kontakt (mm)</translation>
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
        <source>taken out</source>
        <translation>herausgenommen</translation>
    </message>
    <message>
        <source>taken out: %1</source>
        <translation>herausgenommen: %1</translation>
    </message>
    <message>
        <source>%1 mm deep, error %2 mm</source>
        <translation>%1 mm tief, Fehler %2 mm</translation>
    </message>
    <message>
        <source>ball put by hand</source>
        <translation>Kugel von Hand gelegt</translation>
    </message>
    <message>
        <source>being looked at</source>
        <translation>wird angesehen</translation>
    </message>
    <message>
        <source>ball found</source>
        <translation>Kugel gefunden</translation>
    </message>
    <message>
        <source>the ball&apos;s radius is missing</source>
        <translation>der Radius der Kugel fehlt</translation>
    </message>
</context>
<context>
    <name>alltact::PressesPage</name>
    <message>
        <source>Presses</source>
        <translation>Eindrücke</translation>
    </message>
    <message>
        <source>&amp;Add pictures…</source>
        <translation>Bilder &amp;hinzufügen…</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Takes the press and its picture away (undo brings them back)</source>
        <translation>Entfernt den Eindruck und sein Bild (Rückgängig bringt sie zurück)</translation>
    </message>
    <message>
        <source>&amp;Live picture</source>
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
        <source>&amp;Its ball</source>
        <translation>&amp;Ihre Kugel</translation>
    </message>
    <message>
        <source>Radius of this press&apos; ball</source>
        <translation>Radius der Kugel dieses Eindrucks</translation>
    </message>
    <message>
        <source>Where this press was made with a ball of another radius</source>
        <translation>Falls dieser Eindruck mit einer Kugel von anderem Radius gemacht wurde</translation>
    </message>
    <message>
        <source>&amp;Operator</source>
        <translation>&amp;Wer misst</translation>
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
        <source>By &amp;itself when it holds still</source>
        <translation>Von &amp;selbst, sobald er stillhält</translation>
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
        <source>Forgets where the outline was put by hand</source>
        <translation>Vergisst, wohin der Umriss von Hand gelegt wurde</translation>
    </message>
    <message>
        <source>Yellow: the ball&apos;s outline, dashed as the program found it, whole where a hand put it. Blue: where the ball meets the untouched face, about the dark disc.</source>
        <translation>Gelb: der Umriss der Kugel, gestrichelt, wie das Programm ihn fand, durchgezogen, wo eine Hand ihn hinlegte. Blau: wo die Kugel die unberührte Fläche trifft, etwa die dunkle Scheibe.</translation>
    </message>
    <message>
        <source>Place of the ball</source>
        <translation>Ort der Kugel</translation>
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
        <source>Take a press first; six at different places are good.</source>
        <translation>Nehmen Sie zuerst einen Eindruck auf; sechs an verschiedenen Stellen sind gut.</translation>
    </message>
    <message>
        <source>In no press a ball was found yet.</source>
        <translation>In keinem Eindruck wurde bisher eine Kugel gefunden.</translation>
    </message>
    <message>
        <source>There is no live picture: choose a source.</source>
        <translation>Es gibt kein Livebild: Wählen Sie eine Quelle.</translation>
    </message>
    <message>
        <source>The finger cannot be compared with its reference.</source>
        <translation>Der Finger kann nicht mit seiner Referenz verglichen werden.</translation>
    </message>
    <message>
        <source>The live picture does not fit this finger.</source>
        <translation>Das Livebild passt nicht zu diesem Finger.</translation>
    </message>
    <message>
        <source>%1 is taken.</source>
        <translation>%1 ist aufgenommen.</translation>
    </message>
    <message>
        <source>Pictures of presses</source>
        <translation>Bilder von Eindrücken</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.pgm)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.pgm)</translation>
    </message>
    <message>
        <source>Try: %1.</source>
        <translation>Versuchen Sie: %1.</translation>
    </message>
    <message>
        <source>Or drag the outline onto the ball.</source>
        <translation>Oder ziehen Sie den Umriss auf die Kugel.</translation>
    </message>
    <message>
        <source>As it lies now it is pressed in by %1 mm.</source>
        <translation>So, wie sie jetzt liegt, ist sie %1 mm eingedrückt.</translation>
    </message>
    <message>
        <source>As it lies now it does not touch the face.</source>
        <translation>So, wie sie jetzt liegt, berührt sie die Fläche nicht.</translation>
    </message>
    <message>
        <source>Chosen &amp;press</source>
        <translation>&amp;Gewählter Eindruck</translation>
    </message>
    <message>
        <source>&amp;Put back</source>
        <translation>Zurück&amp;nehmen</translation>
    </message>
    <message>
        <source>Take &amp;out</source>
        <translation>&amp;Herausnehmen</translation>
    </message>
    <message>
        <source>A press that is taken out stays with the finger and is not used</source>
        <translation>Ein herausgenommener Eindruck bleibt beim Finger und wird nicht verwendet</translation>
    </message>
    <message>
        <source>The picture is being read.</source>
        <translation>Das Bild wird gelesen.</translation>
    </message>
    <message>
        <source>Centre u %1 px, v %2 px, radius %3 px, %4 mm before the camera</source>
        <translation>Mitte u %1 px, v %2 px, Radius %3 px, %4 mm vor der Kamera</translation>
    </message>
    <message>
        <source>No ball is drawn here.</source>
        <translation>Hier ist keine Kugel gezeichnet.</translation>
    </message>
    <message>
        <source>No press yet. Press the ball in at different places and depths, base, middle and tip.</source>
        <translation>Noch kein Eindruck. Drücken Sie die Kugel an verschiedenen Stellen und verschieden tief ein: Fuß, Mitte und Spitze.</translation>
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
</context>
<context>
    <name>alltact::ProblemList</name>
    <message>
        <source>Try: %1</source>
        <translation>Versuch: %1</translation>
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
</context>
<context>
    <name>alltact::ReadingWords</name>
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
        <source>depth %1 ± %2 mm</source>
        <translation>Tiefe %1 ± %2 mm</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>Tiefe %1 mm</translation>
    </message>
    <message>
        <source> (beyond what was calibrated)</source>
        <translation> (jenseits des Kalibrierten)</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: off the face</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: neben der Fläche</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: x %2, y %3, z %4 mm</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: x %2, y %3, z %4 mm</translation>
    </message>
    <message>
        <source>&lt;b&gt;A to B&lt;/b&gt;: %1 mm straight, %2 mm over the face</source>
        <translation>&lt;b&gt;A nach B&lt;/b&gt;: %1 mm gerade, %2 mm über die Fläche</translation>
    </message>
    <message>
        <source>by x %1, y %2, z %3 mm</source>
        <translation>um x %1, y %2, z %3 mm</translation>
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
</context>
<context>
    <name>alltact::RecordPlace</name>
    <message>
        <source>Bend it in all directions</source>
        <translation>In alle Richtungen biegen</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>What was recorded</source>
        <translation>Was aufgenommen wurde</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>File to record to</source>
        <translation>Datei für die Aufnahme</translation>
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
        <translation>Hält die Einrichtung an; nichts wird geändert.</translation>
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
        <source>The markers have to be seen to tell how it bends.</source>
        <translation>Um die Biegung zu erkennen, müssen die Marken zu sehen sein.</translation>
    </message>
    <message>
        <source>All directions are reached.</source>
        <translation>Alle Richtungen sind erreicht.</translation>
    </message>
    <message>
        <source>Still missing: %1.</source>
        <translation>Es fehlen noch: %1.</translation>
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
    <message numerus="yes">
        <source>, room for about %n minute(s)</source>
        <translation>
            <numerusform>, reicht für etwa %n Minute</numerusform>
            <numerusform>, reicht für etwa %n Minuten</numerusform>
        </translation>
    </message>
    <message>
        <source>Open the finger that was recorded first.</source>
        <translation>Öffnen Sie zuerst den Finger, der aufgenommen wurde.</translation>
    </message>
    <message>
        <source>A flat sensor has one untouched picture instead of a recording.</source>
        <translation>Ein flacher Sensor hat statt einer Aufnahme ein einziges unberührtes Bild.</translation>
    </message>
    <message>
        <source>A recording is under way.</source>
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
        <source>%n frame(s) never came from the source.</source>
        <translation>
            <numerusform>%n Bild kam nie von der Quelle.</numerusform>
            <numerusform>%n Bilder kamen nie von der Quelle.</numerusform>
        </translation>
    </message>
    <message>
        <source>No frame was lost.</source>
        <translation>Kein Bild ging verloren.</translation>
    </message>
    <message numerus="yes">
        <source>The contact face was touched in %n frame(s).</source>
        <translation>
            <numerusform>Die Kontaktfläche wurde in %n Bild berührt.</numerusform>
            <numerusform>Die Kontaktfläche wurde in %n Bildern berührt.</numerusform>
        </translation>
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
        <source>Installed: %1 of %n frame(s) are in the reference.</source>
        <translation>
            <numerusform>Eingerichtet: %1 von %n Bild ist in der Referenz.</numerusform>
            <numerusform>Eingerichtet: %1 von %n Bildern sind in der Referenz.</numerusform>
        </translation>
    </message>
    <message>
        <source>Left out, with the reason:</source>
        <translation>Weggelassen, mit Grund:</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) of this recording are lost.</source>
        <translation>
            <numerusform>%n Bild dieser Aufnahme ist verloren.</numerusform>
            <numerusform>%n Bilder dieser Aufnahme sind verloren.</numerusform>
        </translation>
    </message>
    <message>
        <source>Try another disk, or a smaller picture.</source>
        <translation>Versuchen Sie einen anderen Datenträger oder ein kleineres Bild.</translation>
    </message>
    <message>
        <source>The contact face is touched.</source>
        <translation>Die Kontaktfläche wird berührt.</translation>
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
        <translation>Eine Datei auf einem anderen Datenträger wählen oder Platz schaffen.</translation>
    </message>
    <message>
        <source>Start &amp;recording</source>
        <translation>Aufnahme &amp;starten</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Strg+R</translation>
    </message>
    <message>
        <source>What it leaves open: half of the references made from it are off by less than %1 mm, 95 % by less than %2 mm.</source>
        <translation>Was offen bleibt: Die Hälfte der daraus gebildeten Referenzen weicht um weniger als %1 mm ab, 95 % um weniger als %2 mm.</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) showed a pose that others show as well.</source>
        <translation>
            <numerusform>%n Bild zeigte eine Haltung, die auch andere zeigen.</numerusform>
            <numerusform>%n Bilder zeigten eine Haltung, die auch andere zeigen.</numerusform>
        </translation>
    </message>
    <message>
        <source>It cannot be seen whether the contact face is touched.</source>
        <translation>Es ist nicht zu sehen, ob die Kontaktfläche berührt wird.</translation>
    </message>
    <message>
        <source>Open the finger that belongs to this source, and keep both edges of its face in the picture.</source>
        <translation>Öffnen Sie den Finger, der zu dieser Quelle gehört, und halten Sie beide Kanten seiner Fläche im Bild.</translation>
    </message>
    <message>
        <source>Before there is a reference, touching is told from the frames before.</source>
        <translation>Solange es keine Referenz gibt, werden Berührungen an den Bildern davor erkannt.</translation>
    </message>
    <message>
        <source>Begin with nothing on the contact face.</source>
        <translation>Beginnen Sie mit freier Kontaktfläche.</translation>
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
        <source>Picture, PNG</source>
        <translation>Bild, PNG</translation>
    </message>
    <message>
        <source>Video in 3D, MKV</source>
        <translation>Video in 3D, MKV</translation>
    </message>
    <message>
        <source>What is saved</source>
        <translation>Was gespeichert wird</translation>
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
        <source>The second finger&apos;s folder of pictures</source>
        <translation>Ordner mit Bildern des zweiten Fingers</translation>
    </message>
    <message>
        <source>Second finger</source>
        <translation>Zweiter Finger</translation>
    </message>
    <message>
        <source>Another finger of the same gripper, with what it recorded at the same time. Both are shown in the gripper&apos;s frame; their frames are joined by the times of capture.</source>
        <translation>Ein anderer Finger desselben Greifers, mit dem, was er zur selben Zeit aufgenommen hat. Beide werden im Koordinatensystem des Greifers gezeigt; ihre Bilder werden nach den Zeiten der Aufnahme verbunden.</translation>
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
        <source>Pictures…</source>
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
        <source>Videos (*.mkv *.avi *.mp4)</source>
        <translation>Videos (*.mkv *.avi *.mp4)</translation>
    </message>
    <message>
        <source>Choose the finger&apos;s folder.</source>
        <translation>Wählen Sie den Ordner des Fingers.</translation>
    </message>
    <message>
        <source>Choose what it recorded.</source>
        <translation>Wählen Sie, was er aufgenommen hat.</translation>
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
        <source>ours</source>
        <translation>unseres</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>Veröffentlichung</translation>
    </message>
    <message>
        <source>From A over the face (mm)</source>
        <translation>Von A über die Fläche (mm)</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Tiefe (mm)</translation>
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
        <source>As the system</source>
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
        <source>Listens to no pedal any more.</source>
        <translation>Hört auf kein Pedal mehr.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Learn by pressing it…</source>
        <translation>Durch Drücken &amp;lernen…</translation>
    </message>
    <message>
        <source>Stop learning the foot pedal</source>
        <translation>Das Lernen des Fußpedals anhalten</translation>
    </message>
    <message>
        <source>Learn the foot pedal by pressing it</source>
        <translation>Das Fußpedal durch Drücken lernen</translation>
    </message>
    <message>
        <source>None. A pedal takes presses in Calibrate, and starts and stops in Record.</source>
        <translation>Keines. Ein Pedal nimmt unter „Kalibrieren“ Eindrücke auf; unter „Aufnahme“ beginnt und beendet es die Aufnahme.</translation>
    </message>
    <message>
        <source>%1: not heard now</source>
        <translation>%1: gerade nicht zu hören</translation>
    </message>
</context>
<context>
    <name>alltact::StartPanel</name>
    <message>
        <source>What shall be shown?</source>
        <translation>Was soll gezeigt werden?</translation>
    </message>
    <message>
        <source>Choose where pictures come from. A finger can be opened before or after.</source>
        <translation>Wählen Sie, woher die Bilder kommen. Ein Finger kann davor oder danach geöffnet werden.</translation>
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
        <source>Folder of &amp;pictures…</source>
        <translation>Ordner mit &amp;Bildern…</translation>
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
</context>
<context>
    <name>alltact::StepList</name>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>look again</source>
        <translation>nachsehen</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>zu tun</translation>
    </message>
    <message>
        <source>%1 %2: %3</source>
        <translation>%1 %2: %3</translation>
    </message>
</context>
<context>
    <name>alltact::TimeLine</name>
    <message>
        <source>Frame of the recording</source>
        <translation>Bild der Aufnahme</translation>
    </message>
    <message>
        <source>Number of the frame</source>
        <translation>Nummer des Bildes</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>Name of the frame</source>
        <translation>Name des Bildes</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
</context>
<context>
    <name>alltact::VerdictPage</name>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Usable for contact and its place</source>
        <translation>Für Kontakt und seinen Ort brauchbar</translation>
    </message>
    <message>
        <source>Unproven</source>
        <translation>Unbewiesen</translation>
    </message>
    <message>
        <source>Not fit to measure with</source>
        <translation>Zum Messen nicht geeignet</translation>
    </message>
    <message>
        <source>What to press next</source>
        <translation>Was als Nächstes zu drücken ist</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Anmerkungen</translation>
    </message>
    <message>
        <source>&amp;Open the report</source>
        <translation>&amp;Bericht öffnen</translation>
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
        <source>The presses have changed since: calibrate again.</source>
        <translation>Die Eindrücke haben sich seither geändert: Kalibrieren Sie neu.</translation>
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
        <source>Nothing can be said about it with these presses.</source>
        <translation>Mit diesen Eindrücken lässt sich dazu nichts sagen.</translation>
    </message>
    <message>
        <source>press here next</source>
        <translation>hier als Nächstes</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Keine.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
</context>
</TS>
