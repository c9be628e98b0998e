<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>alltact::AccuracyPlace</name>
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
        <source>%n slower or worse, beyond this figure</source>
        <translation>
            <numerusform>%n slower or worse, beyond this figure</numerusform>
            <numerusform>%n slower or worse, beyond this figure</numerusform>
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
        <source>After %n round(s) %1 mm are left.</source>
        <translation>
            <numerusform>After %n round %1 mm are left.</numerusform>
            <numerusform>After %n rounds %1 mm are left.</numerusform>
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
    <name>alltact::PressDesk</name>
    <message numerus="yes">
        <source>add %n picture(s)</source>
        <translation>
            <numerusform>add %n picture</numerusform>
            <numerusform>add %n pictures</numerusform>
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
        <source>Mean depth error inside the contact (mm); %n better press(es) not shown</source>
        <translation>
            <numerusform>Mean depth error inside the contact (mm); %n better press not shown</numerusform>
            <numerusform>Mean depth error inside the contact (mm); %n better presses not shown</numerusform>
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
    <name>alltact::RecordPlace</name>
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
        <source>, room for about %n minute(s)</source>
        <translation>
            <numerusform>, room for about %n minute</numerusform>
            <numerusform>, room for about %n minutes</numerusform>
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
        <source>%n frame(s) never came from the source.</source>
        <translation>
            <numerusform>%n frame never came from the source.</numerusform>
            <numerusform>%n frames never came from the source.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The contact face was touched in %n frame(s).</source>
        <translation>
            <numerusform>The contact face was touched in %n frame.</numerusform>
            <numerusform>The contact face was touched in %n frames.</numerusform>
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
        <source>%n frame(s) showed a pose that others show as well.</source>
        <translation>
            <numerusform>%n frame showed a pose that others show as well.</numerusform>
            <numerusform>%n frames showed a pose that others show as well.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::SettingsWords</name>
    <message numerus="yes">
        <source>%n picture(s) averaged</source>
        <translation>
            <numerusform>%n picture averaged</numerusform>
            <numerusform>%n pictures averaged</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reference from %n picture(s)</source>
        <translation>
            <numerusform>reference from %n picture</numerusform>
            <numerusform>reference from %n pictures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>edges from %n column(s)</source>
        <translation>
            <numerusform>edges from %n column</numerusform>
            <numerusform>edges from %n columns</numerusform>
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
        <source>{1:.3f} mm of depth error on {0} presses (passes up to {2:.3f} mm), light {3:+.1f} %</source>
        <comment>{1:.3f} mm of depth error on {0} press (passes up to {2:.3f} mm), light {3:+.1f} %</comment>
        <translation>
            <numerusform>{1:.3f} mm of depth error on {0} press (passes up to {2:.3f} mm), light {3:+.1f} %</numerusform>
            <numerusform>{1:.3f} mm of depth error on {0} presses (passes up to {2:.3f} mm), light {3:+.1f} %</numerusform>
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
        <source>{} rounds at the end</source>
        <comment>{} round at the end</comment>
        <translation>
            <numerusform>{} round at the end</numerusform>
            <numerusform>{} rounds at the end</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{} presses more</source>
        <comment>{} press more</comment>
        <translation>
            <numerusform>{} press more</numerusform>
            <numerusform>{} presses more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>no depth in {} pictures</source>
        <comment>no depth in {} picture</comment>
        <translation>
            <numerusform>no depth in {} picture</numerusform>
            <numerusform>no depth in {} pictures</numerusform>
        </translation>
    </message>
</context>
</TS>
