<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>alltact::FrameWords</name>
    <message numerus="yes">
        <source>%n contact(s) on the face.</source>
        <translation>
            <numerusform>%n contact on the face.</numerusform>
            <numerusform>%n contacts on the face.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::MainWindow</name>
    <message numerus="yes">
        <source>%n frame(s) lost</source>
        <translation>
            <numerusform>%n frame lost</numerusform>
            <numerusform>%n frames lost</numerusform>
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
</TS>
