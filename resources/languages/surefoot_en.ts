<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message numerus="yes">
        <source>, %1 of %2 lives so far</source>
        <translation>
            <numerusform>, %1 of %2 life so far</numerusform>
            <numerusform>, %1 of %2 lives so far</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 episodes</source>
        <translation>
            <numerusform>%1 episode</numerusform>
            <numerusform>%1 episodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 lives</source>
        <translation>
            <numerusform>%1 life</numerusform>
            <numerusform>%1 lives</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 falls</source>
        <translation>
            <numerusform>%1 fall</numerusform>
            <numerusform>%1 falls</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 steps</source>
        <translation>
            <numerusform>%1 step</numerusform>
            <numerusform>%1 steps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>surefoot::ExperimentPage</name>
    <message numerus="yes">
        <source>So far (%1 of %2 lives) </source>
        <translation>
            <numerusform>So far (%1 of %2 life) </numerusform>
            <numerusform>So far (%1 of %2 lives) </numerusform>
        </translation>
    </message>
</context>
<context>
    <name>surefoot::ExperimentProgress</name>
    <message numerus="yes">
        <source>%1 of %2 lives</source>
        <translation>
            <numerusform>%1 of %2 life</numerusform>
            <numerusform>%1 of %2 lives</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>surefoot::FilmDialog</name>
    <message numerus="yes">
        <source>%1 pictures</source>
        <translation>
            <numerusform>%1 picture</numerusform>
            <numerusform>%1 pictures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>surefoot::LearningChart</name>
    <message numerus="yes">
        <source>%1 falls</source>
        <translation>
            <numerusform>%1 fall</numerusform>
            <numerusform>%1 falls</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>surefoot::LessonDetails</name>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n step</numerusform>
            <numerusform>%n steps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>surefoot::MainWindow</name>
    <message numerus="yes">
        <source>%1 episodes are not saved</source>
        <translation>
            <numerusform>%1 episode is not saved</numerusform>
            <numerusform>%1 episodes are not saved</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>surefoot::PlanEditor</name>
    <message numerus="yes">
        <source>%n conditions</source>
        <translation>
            <numerusform>%n condition</numerusform>
            <numerusform>%n conditions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>surefoot::RandomLife</name>
    <message numerus="yes">
        <source>%n falls; %1</source>
        <translation>
            <numerusform>%n fall; %1</numerusform>
            <numerusform>%n falls; %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>surefoot::RobotPage</name>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines; F1 says what the word at the caret means</source>
        <translation>
            <numerusform>%n line; F1 says what the word at the caret means</numerusform>
            <numerusform>%n lines; F1 says what the word at the caret means</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>surefoot::StatusLine</name>
    <message numerus="yes">
        <source>%1 falls taken back</source>
        <translation>
            <numerusform>%1 fall taken back</numerusform>
            <numerusform>%1 falls taken back</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the robot flew apart %1 times</source>
        <translation>
            <numerusform>the robot flew apart once</numerusform>
            <numerusform>the robot flew apart %1 times</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>surefoot::TeacherWindow</name>
    <message numerus="yes">
        <source>%n students, %1</source>
        <translation>
            <numerusform>%n student, %1</numerusform>
            <numerusform>%n students, %1</numerusform>
        </translation>
    </message>
</context>
</TS>
