<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>alltact::AccuracyPage</name>
    <message numerus="yes">
        <source>about %n second(s) left</source>
        <translation>
            <numerusform>about %n second left</numerusform>
            <numerusform>about %n seconds left</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::AccuracyPlot</name>
    <message numerus="yes">
        <source>%n slower or worse, outside this figure</source>
        <translation>
            <numerusform>%n slower or worse, outside this figure</numerusform>
            <numerusform>%n slower or worse, outside this figure</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::CheckPage</name>
    <message numerus="yes">
        <source>%n press(es) taken: enough.</source>
        <translation>
            <numerusform>%n press taken: enough.</numerusform>
            <numerusform>%n presses taken: enough.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Last checked on %1 with %n press(es): error %2 mm (limit %3 mm).</source>
        <translation>
            <numerusform>Last checked on %1 with %n press: error %2 mm (limit %3 mm).</numerusform>
            <numerusform>Last checked on %1 with %n presses: error %2 mm (limit %3 mm).</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::ContactWords</name>
    <message numerus="yes">
        <source>%n contact(s) on the face.</source>
        <translation>
            <numerusform>%n contact on the face.</numerusform>
            <numerusform>%n contacts on the face.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::ConvergencePlot</name>
    <message numerus="yes">
        <source>Residual after %n round(s): %1 mm.</source>
        <translation>
            <numerusform>Residual after %n round: %1 mm.</numerusform>
            <numerusform>Residual after %n rounds: %1 mm.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::EventStrip</name>
    <message numerus="yes">
        <source>%n contact(s)</source>
        <translation>
            <numerusform>%n contact</numerusform>
            <numerusform>%n contacts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) with problems</source>
        <translation>
            <numerusform>%n frame with problems</numerusform>
            <numerusform>%n frames with problems</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::ExportDialog</name>
    <message numerus="yes">
        <source>%n recording(s) that this finger does not use are left out of the zip.</source>
        <translation>
            <numerusform>%n recording that this finger does not use is left out of the zip.</numerusform>
            <numerusform>%n recordings that this finger does not use are left out of the zip.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::FingerCards</name>
    <message numerus="yes">
        <source>%n days ago</source>
        <translation>
            <numerusform>%n day ago</numerusform>
            <numerusform>%n days ago</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::FingerListDialog</name>
    <message numerus="yes">
        <source>%n finger(s), </source>
        <translation>
            <numerusform>%n finger, </numerusform>
            <numerusform>%n fingers, </numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n with something due</source>
        <translation>
            <numerusform>%n with something due</numerusform>
            <numerusform>%n with something due</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::GageDialog</name>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n part</numerusform>
            <numerusform>%n parts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n operator(s)</source>
        <translation>
            <numerusform>%n operator</numerusform>
            <numerusform>%n operators</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n repeat(s)</source>
        <translation>
            <numerusform>%n repeat</numerusform>
            <numerusform>%n repeats</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n distinct categorie(s)</source>
        <translation>
            <numerusform>%n distinct category</numerusform>
            <numerusform>%n distinct categories</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::InspectionResults</name>
    <message numerus="yes">
        <source>Pass: all readings of %n frame(s) are within their tolerances with 95 % certainty each.</source>
        <translation>
            <numerusform>Pass: all readings of %n frame are within their tolerances with 95 % certainty each.</numerusform>
            <numerusform>Pass: all readings of %n frames are within their tolerances with 95 % certainty each.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s), no tolerances.</source>
        <translation>
            <numerusform>%n frame, no tolerances.</numerusform>
            <numerusform>%n frames, no tolerances.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::MappingPage</name>
    <message numerus="yes">
        <source>(about %n second(s) left)</source>
        <translation>
            <numerusform>(about %n second left)</numerusform>
            <numerusform>(about %n seconds left)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::PressCollection</name>
    <message numerus="yes">
        <source>remove %n press(es)</source>
        <translation>
            <numerusform>remove %n press</numerusform>
            <numerusform>remove %n presses</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>put %n press(es) back</source>
        <translation>
            <numerusform>put %n press back</numerusform>
            <numerusform>put %n presses back</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>leave %n press(es) out</source>
        <translation>
            <numerusform>leave %n press out</numerusform>
            <numerusform>leave %n presses out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>add %n image(s)</source>
        <translation>
            <numerusform>add %n image</numerusform>
            <numerusform>add %n images</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::PressErrorPlot</name>
    <message numerus="yes">
        <source>The worst of %n press(es) is %1 with %2 mm.</source>
        <translation>
            <numerusform>The worst of %n press is %1 with %2 mm.</numerusform>
            <numerusform>The worst of %n presses is %1 with %2 mm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Mapping minus ball in the contact, mean (mm); %n better press(es) not shown</source>
        <translation>
            <numerusform>Mapping minus ball in the contact, mean (mm); %n better press not shown</numerusform>
            <numerusform>Mapping minus ball in the contact, mean (mm); %n better presses not shown</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::PressesPage</name>
    <message numerus="yes">
        <source>%n press(es), </source>
        <translation>
            <numerusform>%n press, </numerusform>
            <numerusform>%n presses, </numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n usable</source>
        <translation>
            <numerusform>%n usable</numerusform>
            <numerusform>%n usable</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::PressesPlot</name>
    <message numerus="yes">
        <source>%n press(es): %1 mm</source>
        <translation>
            <numerusform>%n press: %1 mm</numerusform>
            <numerusform>%n presses: %1 mm</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::ProblemList</name>
    <message numerus="yes">
        <source>%n min ago</source>
        <translation>
            <numerusform>%n min ago</numerusform>
            <numerusform>%n min ago</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n h ago</source>
        <translation>
            <numerusform>%n h ago</numerusform>
            <numerusform>%n h ago</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::RecordPage</name>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n frame</numerusform>
            <numerusform>%n frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lost</source>
        <translation>
            <numerusform>%n lost</numerusform>
            <numerusform>%n lost</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) were lost because this computer or its disk was too slow.</source>
        <translation>
            <numerusform>%n frame was lost because this computer or its disk was too slow.</numerusform>
            <numerusform>%n frames were lost because this computer or its disk was too slow.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) did not arrive from the source.</source>
        <translation>
            <numerusform>%n frame did not arrive from the source.</numerusform>
            <numerusform>%n frames did not arrive from the source.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n second(s) left.</source>
        <translation>
            <numerusform>About %n second left.</numerusform>
            <numerusform>About %n seconds left.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Installed: %1 of %n frame(s) are in the reference.</source>
        <translation>
            <numerusform>Installed: %1 of %n frame is in the reference.</numerusform>
            <numerusform>Installed: %1 of %n frames are in the reference.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) of this recording are lost.</source>
        <translation>
            <numerusform>%n frame of this recording is lost.</numerusform>
            <numerusform>%n frames of this recording are lost.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) repeated a pose of other frames.</source>
        <translation>
            <numerusform>%n frame repeated a pose of other frames.</numerusform>
            <numerusform>%n frames repeated a pose of other frames.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) with contact are left out.</source>
        <translation>
            <numerusform>%n frame with contact is left out.</numerusform>
            <numerusform>%n frames with contact are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The expected error is being computed, about %n second(s).</source>
        <translation>
            <numerusform>The expected error is being computed, about %n second.</numerusform>
            <numerusform>The expected error is being computed, about %n seconds.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Expected error: half of the references off by less than %1 mm, 95 % by less than %2 mm, from %n frame(s).</source>
        <translation>
            <numerusform>Expected error: half of the references off by less than %1 mm, 95 % by less than %2 mm, from %n frame.</numerusform>
            <numerusform>Expected error: half of the references off by less than %1 mm, 95 % by less than %2 mm, from %n frames.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>room for about %n minute(s)</source>
        <translation>
            <numerusform>room for about %n minute</numerusform>
            <numerusform>room for about %n minutes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::RigCheckBox</name>
    <message numerus="yes">
        <source>Before the first recording: %n to fix</source>
        <translation>
            <numerusform>Before the first recording: %n to fix</numerusform>
            <numerusform>Before the first recording: %n to fix</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::StatusLine</name>
    <message numerus="yes">
        <source>%n frame(s) lost</source>
        <translation>
            <numerusform>%n frame lost</numerusform>
            <numerusform>%n frames lost</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::VerdictPage</name>
    <message numerus="yes">
        <source>• %n more at the top of the remarks.</source>
        <translation>
            <numerusform>• %n more at the top of the remarks.</numerusform>
            <numerusform>• %n more at the top of the remarks.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, ball of radius %2 mm, %n press(es), AllTact %3</source>
        <translation>
            <numerusform>%1, ball of radius %2 mm, %n press, AllTact %3</numerusform>
            <numerusform>%1, ball of radius %2 mm, %n presses, AllTact %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more press(es) in the report.</source>
        <translation>
            <numerusform>%n more press in the report.</numerusform>
            <numerusform>%n more presses in the report.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::en</name>
    <message numerus="yes">
        <source>{} frames</source>
        <comment>{} frame</comment>
        <translation>
            <numerusform>{} frame</numerusform>
            <numerusform>{} frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the recording holds {} frames; at least 2 are needed</source>
        <comment>the recording holds {} frame; at least 2 are needed</comment>
        <translation>
            <numerusform>the recording holds {} frame; at least 2 are needed</numerusform>
            <numerusform>the recording holds {} frames; at least 2 are needed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{1} {2:.3f} mm ({0} presses)</source>
        <comment>{1} {2:.3f} mm ({0} press)</comment>
        <translation>
            <numerusform>{1} {2:.3f} mm ({0} press)</numerusform>
            <numerusform>{1} {2:.3f} mm ({0} presses)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{} presses</source>
        <comment>{} press</comment>
        <translation>
            <numerusform>{} press</numerusform>
            <numerusform>{} presses</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{} more presses</source>
        <comment>{} more press</comment>
        <translation>
            <numerusform>{} more press</numerusform>
            <numerusform>{} more presses</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>no depth in {} images</source>
        <comment>no depth in {} image</comment>
        <translation>
            <numerusform>no depth in {} image</numerusform>
            <numerusform>no depth in {} images</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{} iterations</source>
        <comment>{} iteration</comment>
        <translation>
            <numerusform>{} iteration</numerusform>
            <numerusform>{} iterations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{} markers</source>
        <comment>{} marker</comment>
        <translation>
            <numerusform>{} marker</numerusform>
            <numerusform>{} markers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>calibrating with {} presses</source>
        <comment>calibrating with {} press</comment>
        <translation>
            <numerusform>calibrating with {} press</numerusform>
            <numerusform>calibrating with {} presses</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{} presses are distinct, the others are their copies</source>
        <comment>{} press is distinct, the others are its copies</comment>
        <translation>
            <numerusform>{} press is distinct, the others are its copies</numerusform>
            <numerusform>{} presses are distinct, the others are their copies</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>at {0} positions</source>
        <comment>at {0} position</comment>
        <translation>
            <numerusform>at {0} position</numerusform>
            <numerusform>at {0} positions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{1:.3f} mm depth error on {0} presses {4} (passes up to {2:.3f} mm), light {3:+.1f} %</source>
        <comment>{1:.3f} mm depth error on {0} press {4} (passes up to {2:.3f} mm), light {3:+.1f} %</comment>
        <translation>
            <numerusform>{1:.3f} mm depth error on {0} press {4} (passes up to {2:.3f} mm), light {3:+.1f} %</numerusform>
            <numerusform>{1:.3f} mm depth error on {0} presses {4} (passes up to {2:.3f} mm), light {3:+.1f} %</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{0} of {1} presses have a dark part wider than the ball of {2:.2f} mm diameter ({3} radius): check the ball&apos;s radius</source>
        <comment>{0} of {1} presses has a dark part wider than the ball of {2:.2f} mm diameter ({3} radius): check the ball&apos;s radius</comment>
        <translation>
            <numerusform>{0} of {1} presses has a dark part wider than the ball of {2:.2f} mm diameter ({3} radius): check the ball&apos;s radius</numerusform>
            <numerusform>{0} of {1} presses have a dark part wider than the ball of {2:.2f} mm diameter ({3} radius): check the ball&apos;s radius</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{0} of {1} presses are deeper than the layer of {2:.2f} mm ({3}): check the layer&apos;s thickness and the ball&apos;s radius</source>
        <comment>{0} of {1} presses is deeper than the layer of {2:.2f} mm ({3}): check the layer&apos;s thickness and the ball&apos;s radius</comment>
        <translation>
            <numerusform>{0} of {1} presses is deeper than the layer of {2:.2f} mm ({3}): check the layer&apos;s thickness and the ball&apos;s radius</numerusform>
            <numerusform>{0} of {1} presses are deeper than the layer of {2:.2f} mm ({3}): check the layer&apos;s thickness and the ball&apos;s radius</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{0} of {1} presses are darker than the mapping reaches ({3} deep, the mapping ends at {2:.2f} mm): calibrate again with them</source>
        <comment>{0} of {1} presses is darker than the mapping reaches ({3} deep, the mapping ends at {2:.2f} mm): calibrate again with it</comment>
        <translation>
            <numerusform>{0} of {1} presses is darker than the mapping reaches ({3} deep, the mapping ends at {2:.2f} mm): calibrate again with it</numerusform>
            <numerusform>{0} of {1} presses are darker than the mapping reaches ({3} deep, the mapping ends at {2:.2f} mm): calibrate again with them</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>all presses are at {0} positions, {1} are needed; press at others</source>
        <comment>all presses are at {0} position, {1} are needed; press at others</comment>
        <translation>
            <numerusform>all presses are at {0} position, {1} are needed; press at others</numerusform>
            <numerusform>all presses are at {0} positions, {1} are needed; press at others</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{} images averaged</source>
        <comment>{} image averaged</comment>
        <translation>
            <numerusform>{} image averaged</numerusform>
            <numerusform>{} images averaged</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>edges from {} columns</source>
        <comment>edges from {} column</comment>
        <translation>
            <numerusform>edges from {} column</numerusform>
            <numerusform>edges from {} columns</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reference from {} images</source>
        <comment>reference from {} image</comment>
        <translation>
            <numerusform>reference from {} image</numerusform>
            <numerusform>reference from {} images</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{} images each</source>
        <comment>{} image each</comment>
        <translation>
            <numerusform>{} image each</numerusform>
            <numerusform>{} images each</numerusform>
        </translation>
    </message>
</context>
</TS>
