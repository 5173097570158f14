<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>agrees</source>
        <translation>bestätigt</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>nothing lived yet</source>
        <translation>noch kein Leben</translation>
    </message>
    <message>
        <source>%1, followed</source>
        <translation>%1, mitgelesen</translation>
    </message>
    <message>
        <source>%1, saved after every life</source>
        <translation>%1, nach jedem Leben gespeichert</translation>
    </message>
    <message>
        <source>pre-learned on scenario %1</source>
        <translation>vorgelernt auf Szenario %1</translation>
    </message>
    <message>
        <source> to %1</source>
        <translation> bis %1</translation>
    </message>
    <message>
        <source>, thesis %1</source>
        <translation>, Masterarbeit %1</translation>
    </message>
    <message numerus="yes">
        <source>, %1 of %2 lives so far</source>
        <translation>
            <numerusform>, bisher %1 von %2 Leben</numerusform>
            <numerusform>, bisher %1 von %2 Leben</numerusform>
        </translation>
    </message>
    <message>
        <source>✕ differs from the reference, p &lt; .01</source>
        <translation>✕ weicht von der Referenz ab, p &lt; 0,01</translation>
    </message>
    <message>
        <source>◇ the thesis</source>
        <translation>◇ die Masterarbeit</translation>
    </message>
    <message>
        <source>open bars: so far, lives are missing</source>
        <translation>offene Balken: bisher, es fehlen Leben</translation>
    </message>
    <message>
        <source>highest at the end first</source>
        <translation>höchster Endwert zuerst</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
    <message>
        <source> (95 %: %1 … %2)</source>
        <translation> (95 %: %1 … %2)</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <comment>values</comment>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>The class&apos;s folder is gone: %1.</source>
        <translation>Der Ordner der Klasse ist nicht mehr da: %1.</translation>
    </message>
    <message>
        <source>The file %1 cannot be removed.</source>
        <translation>Die Datei %1 lässt sich nicht entfernen.</translation>
    </message>
    <message>
        <source>gone on with</source>
        <translation>fortgesetzt</translation>
    </message>
    <message>
        <source>pushed</source>
        <translation>gestoßen</translation>
    </message>
    <message>
        <source>placed</source>
        <translation>platziert</translation>
    </message>
    <message>
        <source>Fall</source>
        <translation>Sturz</translation>
    </message>
    <message>
        <source>Episode</source>
        <translation>Episode</translation>
    </message>
    <message>
        <source>Time min</source>
        <translation>Zeit min</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Policy</source>
        <translation>Policy</translation>
    </message>
    <message>
        <source>Click to see the last seconds of this fall again</source>
        <translation>Ein Klick zeigt die letzten Sekunden dieses Sturzes noch einmal</translation>
    </message>
    <message>
        <source>%1, %2 by hand</source>
        <translation>%1, von Hand %2</translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risiko</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>Rewards</source>
        <translation>Belohnungen</translation>
    </message>
    <message>
        <source>Representation</source>
        <translation>Repräsentation</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>best action</source>
        <translation>beste Aktion</translation>
    </message>
    <message>
        <source>greedy action</source>
        <translation>Greedy-Aktion</translation>
    </message>
    <message>
        <source>greedy %1</source>
        <translation>%1, greedy</translation>
    </message>
    <message>
        <source>risk of a fall</source>
        <translation>Sturzrisiko</translation>
    </message>
    <message>
        <source>visits</source>
        <translation>Besuche</translation>
    </message>
    <message>
        <source>eligibility</source>
        <translation>Eligibility</translation>
    </message>
    <message>
        <source>%1 others</source>
        <translation>%1 andere</translation>
    </message>
    <message>
        <source>%1 live %2</source>
        <translation>%1 live %2</translation>
    </message>
    <message>
        <source>%1 live</source>
        <translation>%1 live</translation>
    </message>
    <message>
        <source>%1 fixed %2</source>
        <translation>%1 fest %2</translation>
    </message>
    <message>
        <source>mean over %1</source>
        <translation>Mittel über %1</translation>
    </message>
    <message>
        <source>least over %1</source>
        <translation>Min. über %1</translation>
    </message>
    <message>
        <source>most over %1</source>
        <translation>Max. über %1</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> steps</source>
        <translation> Schritte</translation>
    </message>
    <message>
        <source>not known here</source>
        <translation>hier nicht bekannt</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>Reward</source>
        <translation>Belohnung</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Füße</translation>
    </message>
    <message>
        <source>On and off</source>
        <translation>An und aus</translation>
    </message>
    <message>
        <source>There is not enough memory to try this Q-function.</source>
        <translation>Der Speicher reicht nicht, um diese Q-Funktion zu erproben.</translation>
    </message>
    <message>
        <source>carried over</source>
        <translation>übernommen</translation>
    </message>
    <message>
        <source>with %1</source>
        <translation>mit %1</translation>
    </message>
    <message>
        <source>pre-learned</source>
        <translation>vorgelernt</translation>
    </message>
    <message>
        <source>pre-learned (scenario %1)</source>
        <translation>vorgelernt (Szenario %1)</translation>
    </message>
    <message>
        <source>A program moves this robot; surefoot rollout lives what its Q-function has learned.</source>
        <translation>Ein Programm bewegt diesen Roboter; surefoot rollout durchlebt, was seine Q-Funktion gelernt hat.</translation>
    </message>
    <message>
        <source>Nothing has been learned yet that could be lived.</source>
        <translation>Es ist noch nichts gelernt, was durchlebt werden könnte.</translation>
    </message>
    <message>
        <source>This environment cannot be lived in here.</source>
        <translation>In dieser Umgebung kann hier nicht gelebt werden.</translation>
    </message>
    <message>
        <source>fall %1, episode %2, at half speed</source>
        <translation>Sturz %1, Episode %2, halbes Tempo</translation>
    </message>
    <message>
        <source>roll-out, greedy, seed %1</source>
        <translation>Rollout, greedy, Seed %1</translation>
    </message>
    <message>
        <source>the last minutes</source>
        <translation>die letzten Minuten</translation>
    </message>
    <message>
        <source>There is not enough memory for this; take fewer tiles or tilings.</source>
        <translation>Dafür reicht der Speicher nicht; nehmen Sie weniger Kacheln oder Kachelungen.</translation>
    </message>
    <message>
        <source>Remove earlier runs</source>
        <translation>Frühere Läufe entfernen</translation>
    </message>
    <message>
        <source>More was changed than a journal holds; save the session instead.</source>
        <translation>Es wurde mehr geändert, als ein Journal fasst; speichern Sie stattdessen die Sitzung.</translation>
    </message>
    <message>
        <source>The action values diverged; there is nothing worth keeping.</source>
        <translation>Die Aktionswerte sind divergiert; es gibt nichts, was aufzuheben wäre.</translation>
    </message>
    <message>
        <source>The action values diverged; there is nothing to try.</source>
        <translation>Die Aktionswerte sind divergiert; es gibt nichts zu erproben.</translation>
    </message>
    <message>
        <source>There is not enough memory for a copy of the action values; nothing is lost.</source>
        <translation>Der Speicher reicht nicht für eine Kopie der Aktionswerte; nichts geht verloren.</translation>
    </message>
    <message>
        <source>The life is not kept any more.</source>
        <translation>Das Leben wird nicht mehr aufgehoben.</translation>
    </message>
    <message>
        <source>there is not enough memory for what it holds.</source>
        <translation>der Speicher reicht nicht für den Inhalt.</translation>
    </message>
    <message numerus="yes">
        <source>%1 episodes</source>
        <translation>
            <numerusform>%1 Episode</numerusform>
            <numerusform>%1 Episoden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 lives</source>
        <translation>
            <numerusform>%1 Leben</numerusform>
            <numerusform>%1 Leben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 falls</source>
        <translation>
            <numerusform>%1 Sturz</numerusform>
            <numerusform>%1 Stürze</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 steps</source>
        <translation>
            <numerusform>%1 Schritt</numerusform>
            <numerusform>%1 Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>It takes %1. Default: %2 (%3).</source>
        <translation>Zulässig: %1. Standard: %2 (%3).</translation>
    </message>
    <message>
        <source>Source: %1.</source>
        <translation>Quelle: %1.</translation>
    </message>
    <message>
        <source>The handbook is not there.</source>
        <translation>Das Handbuch ist nicht da.</translation>
    </message>
    <message>
        <source>Another %1 is in this class now; take another name, such as %1 2.</source>
        <translation>Ein anderer Name „%1“ ist jetzt in dieser Klasse; nehmen Sie einen anderen, etwa %1 2.</translation>
    </message>
    <message>
        <source>It is kept on this computer, and goes there when it can.</source>
        <translation>Es wird auf diesem Computer aufgehoben und geht dorthin, sobald es möglich ist.</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Falls during learning</source>
        <translation>Stürze während des Lernens</translation>
    </message>
    <message>
        <source>Average reward</source>
        <translation>Mittlere Belohnung</translation>
    </message>
    <message>
        <source>Average reward against falls</source>
        <translation>Mittlere Belohnung gegen Stürze</translation>
    </message>
    <message>
        <source>Cumulative falls</source>
        <translation>Kumulierte Stürze</translation>
    </message>
    <message>
        <source>Learning time</source>
        <translation>Lernzeit</translation>
    </message>
    <message>
        <source>Falls per episode at the end</source>
        <translation>Stürze pro Episode am Ende</translation>
    </message>
    <message>
        <source>Animated WebP</source>
        <translation>Animiertes WebP</translation>
    </message>
    <message>
        <source>Animated GIF</source>
        <translation>Animiertes GIF</translation>
    </message>
    <message>
        <source>Animated PNG</source>
        <translation>Animiertes PNG</translation>
    </message>
    <message>
        <source>MP4 video</source>
        <translation>MP4-Video</translation>
    </message>
    <message>
        <source>WebM video</source>
        <translation>WebM-Video</translation>
    </message>
    <message>
        <source>reward: </source>
        <translation>Belohnung: </translation>
    </message>
    <message>
        <source>fall </source>
        <translation>Sturz </translation>
    </message>
    <message>
        <source>, from</source>
        <translation>, von</translation>
    </message>
    <message>
        <source>, to</source>
        <translation>, bis</translation>
    </message>
    <message>
        <source>, width</source>
        <translation>, Breite</translation>
    </message>
    <message>
        <source>Walking robot LEO</source>
        <translation>Laufroboter LEO</translation>
    </message>
    <message>
        <source>Beyond the thesis</source>
        <translation>Über die Masterarbeit hinaus</translation>
    </message>
    <message>
        <source>Caution: falling less</source>
        <translation>Vorsicht: weniger stürzen</translation>
    </message>
    <message>
        <source>Chapter 2: reinforcement learning</source>
        <translation>Kapitel 2: Reinforcement Learning</translation>
    </message>
    <message>
        <source>Chapter 4: thresholds (TRL)</source>
        <translation>Kapitel 4: Schwellen (TRL)</translation>
    </message>
    <message>
        <source>Chapter 5: Softmax</source>
        <translation>Kapitel 5: Softmax</translation>
    </message>
    <message>
        <source>Chapter 6: resolution, and two Q-functions</source>
        <translation>Kapitel 6: Auflösung und zwei Q-Funktionen</translation>
    </message>
    <message>
        <source>Tiles per %1 of the %2: few generalise far, many tell states apart.</source>
        <translation>Kacheln je %1 von „%2“: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per %1 of the %2: few let near actions share more.</source>
        <translation>Kacheln je %1 von „%2“: Bei wenigen teilen nahe Aktionen mehr.</translation>
    </message>
    <message>
        <source>The tiles cover the %1 from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken „%1“ von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the %1: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang „%1“: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Centres per %1 of the %2.</source>
        <translation>Mittelpunkte je %1 von „%2“.</translation>
    </message>
    <message>
        <source>Split of %1</source>
        <translation>Aufteilung von %1</translation>
    </message>
    <message>
        <source>thesis</source>
        <translation>Masterarbeit</translation>
    </message>
    <message>
        <source>chapter</source>
        <translation>Kapitel</translation>
    </message>
    <message>
        <source>section</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>sections</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>example</source>
        <translation>Beispiel</translation>
    </message>
    <message>
        <source>eq.</source>
        <translation>Gl.</translation>
    </message>
    <message>
        <source>algorithm</source>
        <translation>Algorithmus</translation>
    </message>
    <message>
        <source>1 Realistic</source>
        <translation>1 Realistisch</translation>
    </message>
    <message>
        <source>10 % more damping, a little friction.</source>
        <translation>10 % mehr Dämpfung, etwas Reibung.</translation>
    </message>
    <message>
        <source>2 Half damping, low friction</source>
        <translation>2 Halbe Dämpfung, wenig Reibung</translation>
    </message>
    <message>
        <source>3 Low damping, high friction</source>
        <translation>3 Wenig Dämpfung, viel Reibung</translation>
    </message>
    <message>
        <source>4 More power</source>
        <translation>4 Mehr Leistung</translation>
    </message>
    <message>
        <source>5 Less power</source>
        <translation>5 Weniger Leistung</translation>
    </message>
    <message>
        <source>6 Power + friction</source>
        <translation>6 Leistung + Reibung</translation>
    </message>
    <message>
        <source>A Softmax whose temperature 1/β fits each state: where actions differ much it is nearly greedy, where they hardly differ nearly even. One ω holds for all states.</source>
        <translation>Ein Softmax, dessen Temperatur 1/β sich jedem Zustand anpasst: fast greedy, wo sich Aktionen stark unterscheiden, fast gleichverteilt, wo kaum. Ein ω gilt für alle Zustände.</translation>
    </message>
    <message>
        <source>A beam that a servo tilts; the ball rolls and must come to rest in the middle. Off the beam is a fall.</source>
        <translation>Ein Servo kippt den Balken; die Kugel rollt und soll in der Mitte zur Ruhe kommen. Fällt sie herunter, ist das ein Sturz.</translation>
    </message>
    <message>
        <source>A body on one leg with a spring in it; a servo holds the angle of the leg, a piston presses the spring.</source>
        <translation>Ein Körper auf einem Bein mit Feder; ein Servo hält den Winkel des Beins, ein Kolben spannt die Feder.</translation>
    </message>
    <message>
        <source>A car that is too weak for the slope has to swing. It cannot fall.</source>
        <translation>Ein Auto, das für den Hang zu schwach ist, muss Schwung holen. Es kann nicht stürzen.</translation>
    </message>
    <message>
        <source>A certain fall costs an action so much of its value.</source>
        <translation>So viel ihres Werts verliert eine Aktion durch einen sicheren Sturz.</translation>
    </message>
    <message>
        <source>A fall costs more and more while the robot falls more often than the budget allows.</source>
        <translation>Ein Sturz kostet immer mehr, solange der Roboter öfter stürzt, als das Budget erlaubt.</translation>
    </message>
    <message>
        <source>A floor that rises by 2 %: harder.</source>
        <translation>Ein Boden, der um 2 % steigt: schwieriger.</translation>
    </message>
    <message>
        <source>A grid of 10 × 10 with a bad region in the middle, which is a fall.</source>
        <translation>Ein Gitter von 10 × 10 mit einem schlechten Gebiet in der Mitte, das als Sturz gilt.</translation>
    </message>
    <message>
        <source>A grid of 10 × 10 with a bad region in the middle.</source>
        <translation>Ein Gitter von 10 × 10 mit einem schlechten Gebiet in der Mitte.</translation>
    </message>
    <message>
        <source>A grid of 4 × 12 with a cliff along one side: Q-learning walks the edge, Sarsa the safe path.</source>
        <translation>Ein Gitter von 4 × 12 mit einer Klippe an einer Seite: Q-Learning geht an der Kante, Sarsa den sicheren Weg.</translation>
    </message>
    <message>
        <source>A hull on two legs of two links, after Gymnasium&apos;s BipedalWalker; four motors of three levels.</source>
        <translation>Ein Rumpf auf zwei Beinen aus zwei Gliedern, nach BipedalWalker aus Gymnasium; vier Motoren mit drei Stufen.</translation>
    </message>
    <message>
        <source>A life is one learner with one seed; an episode goes from its start to its end, a step from action to action.</source>
        <translation>Ein Leben ist ein Lerner mit einem Seed; eine Episode reicht von ihrem Anfang bis zu ihrem Ende, ein Schritt von Aktion zu Aktion.</translation>
    </message>
    <message>
        <source>A pair visited again: its trace is set to 1, or 1 is added.</source>
        <translation>Bei wieder besuchtem Paar: Der Trace-Wert wird auf 1 gesetzt, oder 1 kommt hinzu.</translation>
    </message>
    <message>
        <source>A pole on a cart with a driven wheel. The state is its angle α, its rate α̇ and the wheel&apos;s rate β̇; an action is one of five torques, every 5 ms.</source>
        <translation>Ein Stab auf einem Wagen mit angetriebenem Rad. Der Zustand: Winkel α, Drehrate α̇ und Raddrehrate β̇; eine Aktion ist eines von fünf Drehmomenten, alle 5 ms.</translation>
    </message>
    <message>
        <source>A pole on a driven wheel, DC motor with gears; it should drive on at 0.5 m/s and not fall.</source>
        <translation>Ein Stab auf einem angetriebenen Rad, Gleichstrommotor mit Getriebe; er soll mit 0,5 m/s fahren und nicht stürzen.</translation>
    </message>
    <message>
        <source>A threshold from the length of an episode: what a pair is worth from which the goal is n* steps away.</source>
        <translation>Eine Schwelle aus der Länge einer Episode: was ein Paar wert ist, von dem aus das Ziel n* Schritte entfernt ist.</translation>
    </message>
    <message>
        <source>A trace below this is forgotten.</source>
        <translation>Ein Trace-Wert darunter wird vergessen.</translation>
    </message>
    <message>
        <source>About its centre of mass.</source>
        <translation>Um seinen Schwerpunkt.</translation>
    </message>
    <message>
        <source>Acrobot</source>
        <translation>Acrobot</translation>
    </message>
    <message>
        <source>Actions that fall with a higher probability are left out.</source>
        <translation>Aktionen, die mit höherer Wahrscheinlichkeit stürzen, sind ausgeschlossen.</translation>
    </message>
    <message>
        <source>Actions with decreased power.</source>
        <translation>Aktionen mit weniger Leistung.</translation>
    </message>
    <message>
        <source>Actions with increased power.</source>
        <translation>Aktionen mit mehr Leistung.</translation>
    </message>
    <message>
        <source>Adds the change of a coarse value function to the reward; it learns from these rewards.</source>
        <translation>Addiert die Änderung einer groben Wertefunktion zur Belohnung; sie lernt aus diesen Belohnungen.</translation>
    </message>
    <message>
        <source>After a fall the world goes back so many steps, and the episode goes on from there; it counts as a rewind and not as a fall. For simulations; 0: a fall ends the episode.</source>
        <translation>Nach einem Sturz geht die Welt so viele Schritte zurück, und die Episode geht von dort weiter; das zählt als Zurücknahme und nicht als Sturz. Für Simulationen; 0: Ein Sturz beendet die Episode.</translation>
    </message>
    <message>
        <source>Always takes an action that is worth most, so it never explores.</source>
        <translation>Wählt immer eine Aktion mit dem höchsten Wert, exploriert also nie.</translation>
    </message>
    <message>
        <source>Always the best action.</source>
        <translation>Immer die beste Aktion.</translation>
    </message>
    <message>
        <source>An episode is cut off after so many steps; no fall.</source>
        <translation>Eine Episode wird nach so vielen Schritten abgebrochen; kein Sturz.</translation>
    </message>
    <message>
        <source>An episode is cut off after so many; no fall.</source>
        <translation>Eine Episode wird nach so vielen abgebrochen; kein Sturz.</translation>
    </message>
    <message>
        <source>An episode is cut off after this many steps.</source>
        <translation>Nach so vielen Schritten wird eine Episode abgebrochen.</translation>
    </message>
    <message>
        <source>An episode is cut off after this many steps; that is not a fall.</source>
        <translation>Eine Episode wird nach so vielen Schritten abgebrochen; das ist kein Sturz.</translation>
    </message>
    <message>
        <source>An episode starts at rest, anywhere within ± this angle.</source>
        <translation>Eine Episode beginnt in Ruhe, irgendwo innerhalb ± dieses Winkels.</translation>
    </message>
    <message>
        <source>An exploring step picks among the actions worth more than this.</source>
        <translation>Ein Explorationsschritt wählt unter den Aktionen, die mehr wert sind.</translation>
    </message>
    <message>
        <source>Angle of the body when an episode begins, at rest.</source>
        <translation>Winkel des Körpers, wenn eine Episode beginnt, in Ruhe.</translation>
    </message>
    <message>
        <source>Angle of the stance leg at the start.</source>
        <translation>Winkel des Standbeins beim Start.</translation>
    </message>
    <message>
        <source>Angle of the swing leg at the start.</source>
        <translation>Winkel des Schwungbeins beim Start.</translation>
    </message>
    <message>
        <source>Ankle above x</source>
        <translation>Knöchel oben x</translation>
    </message>
    <message>
        <source>Ankle above y</source>
        <translation>Knöchel oben y</translation>
    </message>
    <message>
        <source>Ankle below x</source>
        <translation>Knöchel unten x</translation>
    </message>
    <message>
        <source>Ankle below y</source>
        <translation>Knöchel unten y</translation>
    </message>
    <message>
        <source>Ankle damper</source>
        <translation>Knöcheldämpfer</translation>
    </message>
    <message>
        <source>Ankle high</source>
        <translation>Knöchel max</translation>
    </message>
    <message>
        <source>Ankle low</source>
        <translation>Knöchel min</translation>
    </message>
    <message>
        <source>Ankle stop</source>
        <translation>Knöchelanschlag</translation>
    </message>
    <message>
        <source>Ankle stop damping</source>
        <translation>Knöchelanschlag, Dämpfung</translation>
    </message>
    <message>
        <source>Ankle target</source>
        <translation>Knöchel, Soll</translation>
    </message>
    <message>
        <source>Ankles</source>
        <translation>Knöchel</translation>
    </message>
    <message>
        <source>Another motor: 9.5 Ω, and more dry friction.</source>
        <translation>Ein anderer Motor: 9,5 Ω, und mehr trockene Reibung.</translation>
    </message>
    <message>
        <source>Armature</source>
        <translation>Ankerträgheit</translation>
    </message>
    <message>
        <source>As Softmax, with a temperature that fits each state by itself.</source>
        <translation>Wie Softmax, mit einer Temperatur, die sich jedem Zustand selbst anpasst.</translation>
    </message>
    <message>
        <source>Asymmetry</source>
        <translation>Asymmetrie</translation>
    </message>
    <message>
        <source>Asymmetry of errors</source>
        <translation>Fehlerasymmetrie</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Back after a fall</source>
        <translation>Zurück nach Sturz</translation>
    </message>
    <message>
        <source>Balanced angle</source>
        <translation>Balancewinkel</translation>
    </message>
    <message>
        <source>Balanced rate</source>
        <translation>Balancedrehrate</translation>
    </message>
    <message>
        <source>Balanced: the angle is at most this, and the rate as well.</source>
        <translation>Balanciert: Der Winkel ist höchstens so groß, die Drehrate innerhalb ihrer Grenze.</translation>
    </message>
    <message>
        <source>Balanced: the rate is at most this, and the angle as well.</source>
        <translation>Balanciert: Die Drehrate ist höchstens so groß, der Winkel innerhalb seiner Grenze.</translation>
    </message>
    <message>
        <source>Ball on a beam</source>
        <translation>Kugel auf Balken</translation>
    </message>
    <message>
        <source>Base mass</source>
        <translation>Wagenmasse</translation>
    </message>
    <message>
        <source>Biped</source>
        <translation>Zweibeiner</translation>
    </message>
    <message>
        <source>Boom force</source>
        <translation>Auslegerkraft</translation>
    </message>
    <message>
        <source>Boom point x</source>
        <translation>Auslegerpunkt x</translation>
    </message>
    <message>
        <source>Boom point y</source>
        <translation>Auslegerpunkt y</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Budget</translation>
    </message>
    <message>
        <source>Cart-pole</source>
        <translation>Cart-Pole</translation>
    </message>
    <message>
        <source>Caution</source>
        <translation>Vorsicht</translation>
    </message>
    <message>
        <source>Centre of a circle that meets the floor, in its body&apos;s frame.</source>
        <translation>Mittelpunkt eines Kreises, der den Boden berührt, im Koordinatensystem seines Körpers.</translation>
    </message>
    <message>
        <source>Centre of mass, in the body&apos;s own frame.</source>
        <translation>Schwerpunkt, im eigenen Koordinatensystem des Körpers.</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>Cliff</source>
        <translation>Klippe</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Compass walker</source>
        <translation>Compass Walker</translation>
    </message>
    <message>
        <source>Compass walker (from a file)</source>
        <translation>Compass Walker (aus Datei)</translation>
    </message>
    <message>
        <source>Constants calibrated to the episode lengths that the thesis reports.</source>
        <translation>Konstanten, kalibriert auf die Episodenlängen, die die Masterarbeit berichtet.</translation>
    </message>
    <message>
        <source>Constants of the same laboratory&apos;s published simulation.</source>
        <translation>Konstanten der veröffentlichten Simulation desselben Labors.</translation>
    </message>
    <message>
        <source>Counted in</source>
        <translation>Gezählt in</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Damping of the joint&apos;s stops.</source>
        <translation>Dämpfung der Anschläge des Gelenks.</translation>
    </message>
    <message>
        <source>Delft lab file</source>
        <translation>Delfter Labordatei</translation>
    </message>
    <message>
        <source>Discount</source>
        <translation>Diskontfaktor</translation>
    </message>
    <message>
        <source>Discount of risk</source>
        <translation>Risiko-Diskontfaktor</translation>
    </message>
    <message>
        <source>Displaced grids of tiles, in a dense or hashed table.</source>
        <translation>Versetzte Gitter aus Kacheln, in dichter oder Hashtabelle.</translation>
    </message>
    <message>
        <source>Displaced grids that lie over each other; a power of two is best.</source>
        <translation>Versetzte Gitter, die übereinanderliegen; am besten eine Zweierpotenz.</translation>
    </message>
    <message>
        <source>Distance of a greedy test, last 10</source>
        <translation>Strecke eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>Distance of a life</source>
        <translation>Strecke eines Lebens</translation>
    </message>
    <message>
        <source>Doomed beyond this lean of the stance thigh: 0.36π.</source>
        <translation>Jenseits dieser Neigung des Oberschenkels (Stand) ist er verloren: 0,36π.</translation>
    </message>
    <message>
        <source>Doomed beyond this lean of the torso.</source>
        <translation>Jenseits dieser Neigung des Rumpfs ist er verloren.</translation>
    </message>
    <message>
        <source>Dry friction</source>
        <translation>Trockene Reibung</translation>
    </message>
    <message>
        <source>Dry friction on the hinge of the pole.</source>
        <translation>Trockene Reibung am Gelenk des Stabs.</translation>
    </message>
    <message>
        <source>Each term of the reward goes its own way, or their sum goes by its sign.</source>
        <translation>Jeder Term der Belohnung geht seinen eigenen Weg, oder ihre Summe geht nach Vorzeichen.</translation>
    </message>
    <message>
        <source>Efficiency</source>
        <translation>Wirkungsgrad</translation>
    </message>
    <message>
        <source>End of learning</source>
        <translation>Ende des Lernens</translation>
    </message>
    <message>
        <source>End value</source>
        <translation>Endwert</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Energy of a greedy test, last 10</source>
        <translation>Energie eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>Energy of a life</source>
        <translation>Energie eines Lebens</translation>
    </message>
    <message>
        <source>Episodes between two tests of the greedy policy, which are not counted; 0: none.</source>
        <translation>Episoden zwischen zwei Tests der Greedy-Policy, die nicht mitzählen; 0: keine.</translation>
    </message>
    <message>
        <source>Errors below 0 count 1 + κ times, those above 1 − κ times: with κ &gt; 0 it is risk-averse.</source>
        <translation>Fehler unter 0 zählen (1 + κ)-fach, solche über 0 (1 − κ)-fach: Mit κ &gt; 0 ist das risikoscheu.</translation>
    </message>
    <message>
        <source>Expected Sarsa</source>
        <translation>Expected Sarsa</translation>
    </message>
    <message>
        <source>Expected Sarsa(λ): the mean over the policy in place of one draw.</source>
        <translation>Expected Sarsa(λ): der Mittelwert über die Policy statt einer Ziehung.</translation>
    </message>
    <message>
        <source>Expected losses count so many times.</source>
        <translation>Mit diesem Faktor zählen erwartete Verluste.</translation>
    </message>
    <message>
        <source>Exploration</source>
        <translation>Exploration</translation>
    </message>
    <message>
        <source>Exploration, clock</source>
        <translation>Exploration, Zeitmaß</translation>
    </message>
    <message>
        <source>Exploration, end</source>
        <translation>Exploration, Ende</translation>
    </message>
    <message>
        <source>Exploration, schedule</source>
        <translation>Exploration, Verlauf</translation>
    </message>
    <message>
        <source>Exploration, time</source>
        <translation>Exploration, Dauer</translation>
    </message>
    <message>
        <source>Factor of losses</source>
        <translation>Verlustfaktor</translation>
    </message>
    <message>
        <source>Factor of losses, clock</source>
        <translation>Verlustfaktor, Zeitmaß</translation>
    </message>
    <message>
        <source>Factor of losses, end</source>
        <translation>Verlustfaktor, Ende</translation>
    </message>
    <message>
        <source>Factor of losses, schedule</source>
        <translation>Verlustfaktor, Verlauf</translation>
    </message>
    <message>
        <source>Factor of losses, time</source>
        <translation>Verlustfaktor, Dauer</translation>
    </message>
    <message>
        <source>Fall</source>
        <translation>Sturz</translation>
    </message>
    <message>
        <source>Fall angle</source>
        <translation>Sturzwinkel</translation>
    </message>
    <message>
        <source>Fall, stance leg</source>
        <translation>Sturz, Standbein</translation>
    </message>
    <message>
        <source>Fall, stance thigh</source>
        <translation>Sturz, Oberschenkel (Stand)</translation>
    </message>
    <message>
        <source>Fall, swing leg</source>
        <translation>Sturz, Schwungbein</translation>
    </message>
    <message>
        <source>Fall, thigh</source>
        <translation>Sturz, Oberschenkel</translation>
    </message>
    <message>
        <source>Fall, torso</source>
        <translation>Sturz, Rumpf</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>Falls an episode</source>
        <translation>Stürze je Episode</translation>
    </message>
    <message>
        <source>Falls an hour</source>
        <translation>Stürze pro Stunde</translation>
    </message>
    <message>
        <source>Falls budget</source>
        <translation>Sturzbudget</translation>
    </message>
    <message>
        <source>Falls of a greedy test, last 10</source>
        <translation>Stürze eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>Falls taken back in an episode, at most</source>
        <translation>Zurückgenommene Stürze je Episode, höchstens</translation>
    </message>
    <message>
        <source>Foot centre x</source>
        <translation>Fuß-SP x</translation>
    </message>
    <message>
        <source>Foot centre y</source>
        <translation>Fuß-SP y</translation>
    </message>
    <message>
        <source>Foot inertia</source>
        <translation>Fußträgheit</translation>
    </message>
    <message>
        <source>Foot mass</source>
        <translation>Fußmasse</translation>
    </message>
    <message>
        <source>Foot radius</source>
        <translation>Fußradius</translation>
    </message>
    <message>
        <source>Footstep</source>
        <translation>Gehschritt</translation>
    </message>
    <message>
        <source>For worlds of few states: nothing is shared, nothing is generalised.</source>
        <translation>Für Welten mit wenigen Zuständen: Nichts wird geteilt, nichts generalisiert.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>From column</source>
        <translation>Ab Spalte</translation>
    </message>
    <message>
        <source>From row</source>
        <translation>Ab Zeile</translation>
    </message>
    <message>
        <source>From state</source>
        <translation>Ab Zustand</translation>
    </message>
    <message>
        <source>From the hip to the sole.</source>
        <translation>Von der Hüfte bis zur Sohle.</translation>
    </message>
    <message>
        <source>Gaussians on a grid, width and spacing set apart.</source>
        <translation>Gauß-Funktionen auf einem Gitter, Breite und Abstand getrennt gewählt.</translation>
    </message>
    <message>
        <source>Gaussians on a grid. Their width can be set apart from their spacing, which tiles cannot do.</source>
        <translation>Gauß-Funktionen auf einem Gitter. Ihre Breite lässt sich unabhängig vom Abstand wählen; das können Kacheln nicht.</translation>
    </message>
    <message>
        <source>Gear ratio</source>
        <translation>Übersetzung</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>Greedy</source>
        <translation>Greedy</translation>
    </message>
    <message>
        <source>Greedy test</source>
        <translation>Greedy-Test</translation>
    </message>
    <message>
        <source>Greedy test every</source>
        <translation>Greedy-Test alle</translation>
    </message>
    <message>
        <source>Grid world</source>
        <translation>Gitterwelt</translation>
    </message>
    <message>
        <source>Grip</source>
        <translation>Haftung</translation>
    </message>
    <message>
        <source>Guardian</source>
        <translation>Wächter</translation>
    </message>
    <message>
        <source>Guardian from</source>
        <translation>Wächter ab</translation>
    </message>
    <message>
        <source>Gymnasium&apos;s CartPole-v1: a pole on a cart that is pushed left or right.</source>
        <translation>CartPole-v1 aus Gymnasium: ein Stab auf einem Wagen, der nach links oder rechts gestoßen wird.</translation>
    </message>
    <message>
        <source>Half of it sits on each leg, at the hip.</source>
        <translation>Je die Hälfte sitzt an einem Bein, an der Hüfte.</translation>
    </message>
    <message>
        <source>Half the damping, low friction.</source>
        <translation>Halbe Dämpfung, wenig Reibung.</translation>
    </message>
    <message>
        <source>Hand-made</source>
        <translation>Fester Regler</translation>
    </message>
    <message>
        <source>Hashed tiles</source>
        <translation>Hash-Kacheln</translation>
    </message>
    <message>
        <source>Heel radius</source>
        <translation>Fersenradius</translation>
    </message>
    <message>
        <source>Heel x</source>
        <translation>Ferse x</translation>
    </message>
    <message>
        <source>Heel y</source>
        <translation>Ferse y</translation>
    </message>
    <message>
        <source>High: nearly equal chances. Low: nearly greedy.</source>
        <translation>Hoch: fast gleiche Wahrscheinlichkeiten. Niedrig: fast greedy.</translation>
    </message>
    <message>
        <source>Highest value of a pair before anything is learned.</source>
        <translation>Höchster Wert eines Paars, bevor etwas gelernt ist.</translation>
    </message>
    <message>
        <source>Hip above x</source>
        <translation>Hüfte oben x</translation>
    </message>
    <message>
        <source>Hip above y</source>
        <translation>Hüfte oben y</translation>
    </message>
    <message>
        <source>Hip below x</source>
        <translation>Hüfte unten x</translation>
    </message>
    <message>
        <source>Hip below y</source>
        <translation>Hüfte unten y</translation>
    </message>
    <message>
        <source>Hip damper</source>
        <translation>Hüftdämpfer</translation>
    </message>
    <message>
        <source>Hip high</source>
        <translation>Hüfte max</translation>
    </message>
    <message>
        <source>Hip low</source>
        <translation>Hüfte min</translation>
    </message>
    <message>
        <source>Hip mass</source>
        <translation>Hüftmasse</translation>
    </message>
    <message>
        <source>Hip stop</source>
        <translation>Hüftanschlag</translation>
    </message>
    <message>
        <source>Hip stop damping</source>
        <translation>Hüftanschlag, Dämpfung</translation>
    </message>
    <message>
        <source>Hip target</source>
        <translation>Hüfte, Soll</translation>
    </message>
    <message>
        <source>Hopper</source>
        <translation>Hopper</translation>
    </message>
    <message>
        <source>How a walker walks with what it has learned so far.</source>
        <translation>Wie ein Läufer mit dem geht, was er bisher gelernt hat.</translation>
    </message>
    <message>
        <source>How far back along the way a surprise is felt; 0: one step.</source>
        <translation>Wie weit zurück auf dem Weg eine Überraschung wirkt; 0: ein Schritt.</translation>
    </message>
    <message>
        <source>How far the simulation is from the actual system: the rows of the thesis&apos;s table.</source>
        <translation>Wie weit die Simulation vom wirklichen System entfernt ist: die Zeilen der Tabelle der Masterarbeit.</translation>
    </message>
    <message>
        <source>How it changes while the life goes on: not at all, in a straight line, by halves, or as the rule of thumb says.</source>
        <translation>Wie sie sich im Lauf des Lebens ändert: gar nicht, geradlinig, durch Halbieren oder nach der Faustregel.</translation>
    </message>
    <message>
        <source>How it changes while the life goes on: not at all, in a straight line, or by halves.</source>
        <translation>Wie sie sich im Lauf des Lebens ändert: gar nicht, geradlinig oder durch Halbieren.</translation>
    </message>
    <message>
        <source>How long a linear schedule takes to its end; the half-life of an exponential one.</source>
        <translation>Wie lange ein linearer Verlauf bis zum Ende braucht; bei einem exponentiellen die Halbwertszeit.</translation>
    </message>
    <message>
        <source>How many steps the learner takes to the goal. The rule of thumb is made from it.</source>
        <translation>Wie viele Schritte der Lerner bis zum Ziel braucht. Daraus folgt die Faustregel.</translation>
    </message>
    <message>
        <source>How much more a fall costs after an episode with one fall too many.</source>
        <translation>Um wie viel mehr ein Sturz nach einer Episode mit einem Sturz zu viel kostet.</translation>
    </message>
    <message>
        <source>How well it does by now. 198 of 200 counts as converged.</source>
        <translation>Wie gut es inzwischen gelingt. 198 von 200 gilt als konvergiert.</translation>
    </message>
    <message>
        <source>Increased power with the realistic errors of 1.</source>
        <translation>Mehr Leistung mit den realistischen Fehlern von 1.</translation>
    </message>
    <message>
        <source>Inertia of a rotor as the joint feels it.</source>
        <translation>Trägheit eines Rotors, wie das Gelenk sie spürt.</translation>
    </message>
    <message>
        <source>Initial Q</source>
        <translation>Anfangs-Q</translation>
    </message>
    <message>
        <source>Initial Q, low</source>
        <translation>Anfangs-Q, min</translation>
    </message>
    <message>
        <source>Initial risk</source>
        <translation>Anfangsrisiko</translation>
    </message>
    <message>
        <source>It has fallen beyond this angle of the stance leg.</source>
        <translation>Jenseits dieses Winkels des Standbeins ist er gestürzt.</translation>
    </message>
    <message>
        <source>It has fallen beyond this angle of the swing leg.</source>
        <translation>Jenseits dieses Winkels des Schwungbeins ist er gestürzt.</translation>
    </message>
    <message>
        <source>Knee above x</source>
        <translation>Knie oben x</translation>
    </message>
    <message>
        <source>Knee above y</source>
        <translation>Knie oben y</translation>
    </message>
    <message>
        <source>Knee below x</source>
        <translation>Knie unten x</translation>
    </message>
    <message>
        <source>Knee below y</source>
        <translation>Knie unten y</translation>
    </message>
    <message>
        <source>Knee cap radius</source>
        <translation>Kniescheibenradius</translation>
    </message>
    <message>
        <source>Knee cap x</source>
        <translation>Kniescheibe x</translation>
    </message>
    <message>
        <source>Knee cap y</source>
        <translation>Kniescheibe y</translation>
    </message>
    <message>
        <source>Knee damper</source>
        <translation>Kniedämpfer</translation>
    </message>
    <message>
        <source>Knee high</source>
        <translation>Knie max</translation>
    </message>
    <message>
        <source>Knee low</source>
        <translation>Knie min</translation>
    </message>
    <message>
        <source>Knee stop</source>
        <translation>Knieanschlag</translation>
    </message>
    <message>
        <source>Knee stop damping</source>
        <translation>Knieanschlag, Dämpfung</translation>
    </message>
    <message>
        <source>LEO</source>
        <translation>LEO</translation>
    </message>
    <message>
        <source>LEO (from a file)</source>
        <translation>LEO (aus Datei)</translation>
    </message>
    <message>
        <source>LEO walker</source>
        <translation>Laufroboter LEO</translation>
    </message>
    <message>
        <source>Learns flat out; the world shows another one at its usual pace, with the newest values.</source>
        <translation>Lernt so schnell es geht; die Welt zeigt eine andere im üblichen Tempo, mit den neuesten Werten.</translation>
    </message>
    <message>
        <source>Learns how likely an action ends in a fall, beside its value.</source>
        <translation>Lernt neben dem Wert einer Aktion, wie wahrscheinlich sie in einem Sturz endet.</translation>
    </message>
    <message>
        <source>Learns the value of the greedy policy, whatever is done meanwhile (Watkins). So at a cliff it learns the edge, and falls while it explores.</source>
        <translation>Lernt den Wert der Greedy-Policy, was immer derweil getan wird (Watkins). Darum lernt es an einer Klippe die Kante und stürzt, während es exploriert.</translation>
    </message>
    <message>
        <source>Learns the value of what it does, exploring included: a′ is the action that is taken next.</source>
        <translation>Lernt den Wert dessen, was tatsächlich getan wird, samt Exploration: a′ ist die Aktion, die als Nächstes ausgeführt wird.</translation>
    </message>
    <message>
        <source>Learns to walk within a few simulated minutes.</source>
        <translation>Lernt in wenigen simulierten Minuten zu gehen.</translation>
    </message>
    <message>
        <source>Leg inertia</source>
        <translation>Beinträgheit</translation>
    </message>
    <message>
        <source>Leg length</source>
        <translation>Beinlänge</translation>
    </message>
    <message>
        <source>Leg mass</source>
        <translation>Beinmasse</translation>
    </message>
    <message>
        <source>Length of the pole.</source>
        <translation>Länge des Stabs.</translation>
    </message>
    <message>
        <source>Level floor</source>
        <translation>Ebener Boden</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Limit of risk</source>
        <translation>Risikogrenze</translation>
    </message>
    <message>
        <source>Limit of risk, clock</source>
        <translation>Risikogrenze, Zeitmaß</translation>
    </message>
    <message>
        <source>Limit of risk, end</source>
        <translation>Risikogrenze, Ende</translation>
    </message>
    <message>
        <source>Limit of risk, schedule</source>
        <translation>Risikogrenze, Verlauf</translation>
    </message>
    <message>
        <source>Limit of risk, time</source>
        <translation>Risikogrenze, Dauer</translation>
    </message>
    <message>
        <source>Limit of the guardian</source>
        <translation>Grenze des Wächters</translation>
    </message>
    <message>
        <source>Linear damping of the wheel motors, per rad.</source>
        <translation>Lineare Dämpfung der Radmotoren, je rad.</translation>
    </message>
    <message>
        <source>Low damping, high friction.</source>
        <translation>Wenig Dämpfung, viel Reibung.</translation>
    </message>
    <message>
        <source>Low: nearly equal chances. High: nearly greedy.</source>
        <translation>Niedrig: fast gleiche Wahrscheinlichkeiten. Hoch: fast greedy.</translation>
    </message>
    <message>
        <source>Lowest value of a pair before anything is learned.</source>
        <translation>Niedrigster Wert eines Paars, bevor etwas gelernt ist.</translation>
    </message>
    <message>
        <source>Mass of the cart without its wheel.</source>
        <translation>Masse des Wagens ohne sein Rad.</translation>
    </message>
    <message>
        <source>Mass of the driven wheel, a solid cylinder.</source>
        <translation>Masse des angetriebenen Rads, ein Vollzylinder.</translation>
    </message>
    <message>
        <source>Mass of the pole, a uniform rod.</source>
        <translation>Masse des Stabs, homogen.</translation>
    </message>
    <message>
        <source>Mellowmax</source>
        <translation>Mellowmax</translation>
    </message>
    <message>
        <source>Mellowness</source>
        <translation>Mellowness</translation>
    </message>
    <message>
        <source>Mellowness, clock</source>
        <translation>Mellowness, Zeitmaß</translation>
    </message>
    <message>
        <source>Mellowness, end</source>
        <translation>Mellowness, Ende</translation>
    </message>
    <message>
        <source>Mellowness, schedule</source>
        <translation>Mellowness, Verlauf</translation>
    </message>
    <message>
        <source>Mellowness, time</source>
        <translation>Mellowness, Dauer</translation>
    </message>
    <message>
        <source>Mismatched LEO</source>
        <translation>Abweichender LEO</translation>
    </message>
    <message>
        <source>Mostly greedy; in a share ε of the steps it takes any of the n actions with equal chance. So it also takes those that make the robot fall.</source>
        <translation>Meist greedy; in einem Anteil ε der Schritte irgendeine der n Aktionen mit gleicher Wahrscheinlichkeit. Also auch solche, die den Roboter stürzen lassen.</translation>
    </message>
    <message>
        <source>Mountain car</source>
        <translation>Mountain Car</translation>
    </message>
    <message>
        <source>Multiplies every resolution: the fraction of Q_opt in chapter 6.</source>
        <translation>Faktor für jede Auflösung: der Anteil von Q_opt in Kapitel 6.</translation>
    </message>
    <message>
        <source>Multiplies every width and leaves the centres where they are.</source>
        <translation>Faktor für jede Breite; die Zentren bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>Multiplies the torque of every action.</source>
        <translation>Faktor für das Drehmoment jeder Aktion.</translation>
    </message>
    <message>
        <source>Net footsteps of a greedy test, last 10</source>
        <translation>Netto-Gehschritte eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>Net footsteps of a life</source>
        <translation>Netto-Gehschritte eines Lebens</translation>
    </message>
    <message>
        <source>Nineteen states in a row and one action: only values are learned, and they are known.</source>
        <translation>Neunzehn Zustände in einer Reihe und eine Aktion: Gelernt werden nur Werte, und sie sind bekannt.</translation>
    </message>
    <message>
        <source>Of a circle that meets the floor.</source>
        <translation>Eines Kreises, der den Boden berührt.</translation>
    </message>
    <message>
        <source>Of a motor&apos;s windings.</source>
        <translation>Der Wicklungen eines Motors.</translation>
    </message>
    <message>
        <source>Of a motor.</source>
        <translation>Eines Motors.</translation>
    </message>
    <message>
        <source>Of each voltage; actions are their combinations.</source>
        <translation>Jeder Spannung; Aktionen sind ihre Kombinationen.</translation>
    </message>
    <message>
        <source>Of every joint.</source>
        <translation>In jedem Gelenk.</translation>
    </message>
    <message>
        <source>Of feet and floor.</source>
        <translation>Von Füßen und Boden.</translation>
    </message>
    <message>
        <source>Of one leg about its centre.</source>
        <translation>Eines Beins um seinen Schwerpunkt.</translation>
    </message>
    <message>
        <source>Of one leg, its centre in the middle.</source>
        <translation>Eines Beins, mit dem Schwerpunkt in der Mitte.</translation>
    </message>
    <message>
        <source>Of one such body; the torso&apos;s with boom and arm.</source>
        <translation>Eines solchen Körpers; beim Rumpf mit Ausleger und Arm.</translation>
    </message>
    <message>
        <source>Of the floor: below 0 it goes uphill.</source>
        <translation>Des Bodens: Unter 0 geht es bergauf.</translation>
    </message>
    <message>
        <source>Of the gears.</source>
        <translation>Der Getriebe.</translation>
    </message>
    <message>
        <source>Of the hip; the actions are −, 0 and + this.</source>
        <translation>Der Hüfte; die Aktionen sind −, 0 und + dieses Werts.</translation>
    </message>
    <message>
        <source>On the Earth 9.81.</source>
        <translation>Auf der Erde 9,81.</translation>
    </message>
    <message>
        <source>One value a state, for states of whole numbers.</source>
        <translation>Ein Wert je Zustand, für Zustände aus ganzen Zahlen.</translation>
    </message>
    <message>
        <source>Other actions</source>
        <translation>Andere Aktionen</translation>
    </message>
    <message>
        <source>Over</source>
        <translation>Über</translation>
    </message>
    <message>
        <source>Pendulum</source>
        <translation>Pendel</translation>
    </message>
    <message>
        <source>Pendulum (from a file)</source>
        <translation>Pendel (aus Datei)</translation>
    </message>
    <message>
        <source>Pendulum, actual system</source>
        <translation>Pendel, tatsächliches System</translation>
    </message>
    <message>
        <source>Pole angle</source>
        <translation>Stabwinkel</translation>
    </message>
    <message>
        <source>Pole length</source>
        <translation>Stablänge</translation>
    </message>
    <message>
        <source>Pole mass</source>
        <translation>Stabmasse</translation>
    </message>
    <message>
        <source>Pole rate</source>
        <translation>Stabdrehrate</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Pre-learning</source>
        <translation>Vorlernen</translation>
    </message>
    <message>
        <source>Q(s, a), action value</source>
        <translation>Q(s, a), Aktionswert</translation>
    </message>
    <message>
        <source>Q-learning</source>
        <translation>Q-Learning</translation>
    </message>
    <message>
        <source>Q-learning, Q(λ)</source>
        <translation>Q-Learning, Q(λ)</translation>
    </message>
    <message>
        <source>Radial basis</source>
        <translation>Radiale Basis</translation>
    </message>
    <message>
        <source>Radial basis functions</source>
        <translation>Radiale Basisfunktionen</translation>
    </message>
    <message>
        <source>Radius of the driven wheel.</source>
        <translation>Radius des angetriebenen Rads.</translation>
    </message>
    <message>
        <source>Random walk</source>
        <translation>Random Walk</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Rate of the budget</source>
        <translation>Budgetrate</translation>
    </message>
    <message>
        <source>Rate of the stance leg at the start.</source>
        <translation>Drehrate des Standbeins beim Start.</translation>
    </message>
    <message>
        <source>Resistance</source>
        <translation>Widerstand</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Reward for balancing the pole.</source>
        <translation>Belohnung für das Balancieren des Stabs.</translation>
    </message>
    <message>
        <source>Reward for being doomed to fall.</source>
        <translation>Belohnung, wenn ein Sturz nicht mehr zu verhindern ist.</translation>
    </message>
    <message>
        <source>Reward for falling.</source>
        <translation>Belohnung für einen Sturz.</translation>
    </message>
    <message>
        <source>Reward for letting the pole fall.</source>
        <translation>Belohnung, wenn der Stab umfällt.</translation>
    </message>
    <message>
        <source>Reward of a footstep, a metre of its length.</source>
        <translation>Belohnung eines Gehschritts, je Meter seiner Länge.</translation>
    </message>
    <message>
        <source>Reward of a greedy test, last 10</source>
        <translation>Belohnung eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>Reward of a joule that hips and knees take.</source>
        <translation>Belohnung für ein Joule, das Hüften und Knie aufnehmen.</translation>
    </message>
    <message>
        <source>Reward of a metre by which the ankles part.</source>
        <translation>Belohnung je Meter, um den die Knöchel sich trennen.</translation>
    </message>
    <message>
        <source>Reward of every step.</source>
        <translation>Belohnung jedes Schritts.</translation>
    </message>
    <message>
        <source>Reward of every step; 0 or below.</source>
        <translation>Belohnung jedes Schritts; 0 oder darunter.</translation>
    </message>
    <message>
        <source>Reward shaping</source>
        <translation>Reward Shaping</translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risiko</translation>
    </message>
    <message>
        <source>Risk of a fall</source>
        <translation>Sturzrisiko</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Rule of thumb</source>
        <translation>Faustregel</translation>
    </message>
    <message>
        <source>Sarsa</source>
        <translation>Sarsa</translation>
    </message>
    <message>
        <source>Sarsa with the mean over the policy in place of the one action that is drawn: the same values with less chance in them.</source>
        <translation>Sarsa mit dem Mittelwert über die Policy statt der einen gezogenen Aktion: dieselben Werte mit weniger Zufall darin.</translation>
    </message>
    <message>
        <source>Sarsa(λ) that equals its forward view, but for the cut-off of its traces.</source>
        <translation>Sarsa(λ), gleich seiner Vorwärtssicht, bis auf das Abschneiden der Traces.</translation>
    </message>
    <message>
        <source>Sarsa(λ) with dutch traces and a correction, so that after every step the weights are those of the forward view, which looks ahead at the returns.</source>
        <translation>Sarsa(λ) mit Dutch Traces und einer Korrektur, sodass die Gewichte nach jedem Schritt die der Vorwärtssicht sind, die auf die Returns vorausblickt.</translation>
    </message>
    <message>
        <source>Sarsa(λ) with expected gains and losses in two Q-functions.</source>
        <translation>Sarsa(λ) mit erwarteten Gewinnen und Verlusten in zwei Q-Funktionen.</translation>
    </message>
    <message>
        <source>Sarsa(λ), the on-policy rule of the thesis.</source>
        <translation>Sarsa(λ), die On-Policy-Regel der Masterarbeit.</translation>
    </message>
    <message>
        <source>Sarsa_2Q</source>
        <translation>Sarsa_2Q</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Schedule</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Seat radius</source>
        <translation>Gesäßradius</translation>
    </message>
    <message>
        <source>Seat x</source>
        <translation>Gesäß x</translation>
    </message>
    <message>
        <source>Seat y</source>
        <translation>Gesäß y</translation>
    </message>
    <message>
        <source>Segway on bumpy ground</source>
        <translation>Segway auf holprigem Boden</translation>
    </message>
    <message>
        <source>Shank centre x</source>
        <translation>Unterschenkel-SP x</translation>
    </message>
    <message>
        <source>Shank centre y</source>
        <translation>Unterschenkel-SP y</translation>
    </message>
    <message>
        <source>Shank inertia</source>
        <translation>Unterschenkelträgheit</translation>
    </message>
    <message>
        <source>Shank mass</source>
        <translation>Unterschenkelmasse</translation>
    </message>
    <message>
        <source>Shaping</source>
        <translation>Shaping</translation>
    </message>
    <message>
        <source>Shaping discount</source>
        <translation>Shaping, Diskontfaktor</translation>
    </message>
    <message>
        <source>Shaping step size</source>
        <translation>Shaping, Schrittweite</translation>
    </message>
    <message>
        <source>Share below</source>
        <translation>Anteil darunter</translation>
    </message>
    <message>
        <source>Share by which start angles and rates vary; in rad/s that of the swing leg.</source>
        <translation>Anteil, um den Startwinkel und Drehraten streuen; in rad/s der des Schwungbeins.</translation>
    </message>
    <message>
        <source>Share of the error that one update closes, over all tilings together.</source>
        <translation>Anteil des Fehlers, den ein Update ausgleicht, über alle Kachelungen zusammen.</translation>
    </message>
    <message>
        <source>Share of the exploring steps that pick an action below the threshold all the same.</source>
        <translation>Anteil der Explorationsschritte, die trotzdem eine Aktion unter der Schwelle wählen.</translation>
    </message>
    <message>
        <source>Share of the steps that explore instead of taking the best action.</source>
        <translation>Anteil der Schritte, die explorieren, statt die beste Aktion zu wählen.</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>So many falls an episode are allowed; with more a fall costs more.</source>
        <translation>So viele Stürze je Episode sind erlaubt; bei mehr kostet ein Sturz mehr.</translation>
    </message>
    <message>
        <source>So many times an episode goes on after a fall; the fall after that ends it.</source>
        <translation>So oft geht eine Episode nach einem Sturz weiter; der Sturz danach beendet sie.</translation>
    </message>
    <message>
        <source>Softmax</source>
        <translation>Softmax</translation>
    </message>
    <message>
        <source>Solid from</source>
        <translation>Kontakt ab</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Aufteilung</translation>
    </message>
    <message>
        <source>Split of energy</source>
        <translation>Aufteilung Energie</translation>
    </message>
    <message>
        <source>Split of fall</source>
        <translation>Aufteilung Sturz</translation>
    </message>
    <message>
        <source>Split of footstep</source>
        <translation>Aufteilung Gehschritt</translation>
    </message>
    <message>
        <source>Split of goal</source>
        <translation>Aufteilung Ziel</translation>
    </message>
    <message>
        <source>Split of left</source>
        <translation>Aufteilung links</translation>
    </message>
    <message>
        <source>Split of price_of_fall</source>
        <translation>Aufteilung price_of_fall</translation>
    </message>
    <message>
        <source>Split of right</source>
        <translation>Aufteilung rechts</translation>
    </message>
    <message>
        <source>Split of shaping</source>
        <translation>Aufteilung Shaping</translation>
    </message>
    <message>
        <source>Split of time</source>
        <translation>Aufteilung Zeit</translation>
    </message>
    <message>
        <source>Stance angle</source>
        <translation>Winkel (Stand)</translation>
    </message>
    <message>
        <source>Stance hip</source>
        <translation>Hüfte (Stand)</translation>
    </message>
    <message>
        <source>Stance hip rate</source>
        <translation>Hüftdrehrate (Stand)</translation>
    </message>
    <message>
        <source>Stance hip voltage</source>
        <translation>Hüftspannung (Stand)</translation>
    </message>
    <message>
        <source>Stance knee</source>
        <translation>Knie (Stand)</translation>
    </message>
    <message>
        <source>Stance knee rate</source>
        <translation>Kniedrehrate (Stand)</translation>
    </message>
    <message>
        <source>Stance rate</source>
        <translation>Drehrate (Stand)</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Startwinkel</translation>
    </message>
    <message>
        <source>Start noise</source>
        <translation>Startrauschen</translation>
    </message>
    <message>
        <source>Start rate</source>
        <translation>Start, Drehrate</translation>
    </message>
    <message>
        <source>Start stance</source>
        <translation>Start, Standbein</translation>
    </message>
    <message>
        <source>Start swing</source>
        <translation>Start, Schwungbein</translation>
    </message>
    <message>
        <source>Start, stance foot</source>
        <translation>Start, Fuß (Stand)</translation>
    </message>
    <message>
        <source>Start, stance shank</source>
        <translation>Start, Unterschenkel (Stand)</translation>
    </message>
    <message>
        <source>Start, stance thigh</source>
        <translation>Start, Oberschenkel (Stand)</translation>
    </message>
    <message>
        <source>Start, swing foot</source>
        <translation>Start, Fuß (Schwung)</translation>
    </message>
    <message>
        <source>Start, swing shank</source>
        <translation>Start, Unterschenkel (Schwung)</translation>
    </message>
    <message>
        <source>Start, swing thigh</source>
        <translation>Start, Oberschenkel (Schwung)</translation>
    </message>
    <message>
        <source>Start, torso</source>
        <translation>Start, Rumpf</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Step limit</source>
        <translation>Schrittgrenze</translation>
    </message>
    <message>
        <source>Step size</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>Step size, clock</source>
        <translation>Schrittweite, Zeitmaß</translation>
    </message>
    <message>
        <source>Step size, end</source>
        <translation>Schrittweite, Ende</translation>
    </message>
    <message>
        <source>Step size, schedule</source>
        <translation>Schrittweite, Verlauf</translation>
    </message>
    <message>
        <source>Step size, time</source>
        <translation>Schrittweite, Dauer</translation>
    </message>
    <message>
        <source>Step, episode, life, experiment</source>
        <translation>Schritt, Episode, Leben, Experiment</translation>
    </message>
    <message>
        <source>Steps back after a fall</source>
        <translation>Schritte zurück nach Sturz</translation>
    </message>
    <message>
        <source>Steps of the simulation in one transition.</source>
        <translation>Schritte der Simulation in einem Übergang.</translation>
    </message>
    <message>
        <source>Stiffness of the joint&apos;s stops.</source>
        <translation>Steifigkeit der Anschläge des Gelenks.</translation>
    </message>
    <message>
        <source>Substeps</source>
        <translation>Teilschritte</translation>
    </message>
    <message>
        <source>Sutton &amp; Barto&apos;s 19 states with one action: values only.</source>
        <translation>Die 19 Zustände von Sutton &amp; Barto mit einer Aktion: nur Werte.</translation>
    </message>
    <message>
        <source>Sutton &amp; Barto&apos;s car that is too weak for the slope.</source>
        <translation>Das Auto von Sutton &amp; Barto, das für den Hang zu schwach ist.</translation>
    </message>
    <message>
        <source>Sutton &amp; Barto&apos;s cliff walking, a grid of 4 × 12.</source>
        <translation>Cliff Walking nach Sutton &amp; Barto, ein Gitter von 4 × 12.</translation>
    </message>
    <message>
        <source>Swing angle</source>
        <translation>Winkel (Schwung)</translation>
    </message>
    <message>
        <source>Swing hip</source>
        <translation>Hüfte (Schwung)</translation>
    </message>
    <message>
        <source>Swing hip rate</source>
        <translation>Hüftdrehrate (Schwung)</translation>
    </message>
    <message>
        <source>Swing hip voltage</source>
        <translation>Hüftspannung (Schwung)</translation>
    </message>
    <message>
        <source>Swing knee</source>
        <translation>Knie (Schwung)</translation>
    </message>
    <message>
        <source>Swing knee rate</source>
        <translation>Kniedrehrate (Schwung)</translation>
    </message>
    <message>
        <source>Swing knee voltage</source>
        <translation>Kniespannung (Schwung)</translation>
    </message>
    <message>
        <source>Swing rate</source>
        <translation>Drehrate (Schwung)</translation>
    </message>
    <message>
        <source>TD error</source>
        <translation>TD-Fehler</translation>
    </message>
    <message>
        <source>TRL</source>
        <translation>TRL</translation>
    </message>
    <message>
        <source>TRL&apos;s limit: what is worth no more than this is hardly ever tried.</source>
        <translation>Die Grenze von TRL: Was nicht mehr wert ist als dies, wird kaum je versucht.</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Temperature, clock</source>
        <translation>Temperatur, Zeitmaß</translation>
    </message>
    <message>
        <source>Temperature, end</source>
        <translation>Temperatur, Ende</translation>
    </message>
    <message>
        <source>Temperature, schedule</source>
        <translation>Temperatur, Verlauf</translation>
    </message>
    <message>
        <source>Temperature, time</source>
        <translation>Temperatur, Dauer</translation>
    </message>
    <message>
        <source>Ten states in a row between a fall and the goal.</source>
        <translation>Zehn Zustände in einer Reihe zwischen Sturz und Ziel.</translation>
    </message>
    <message>
        <source>Ten states in a row, a fall at one end and the goal at the other.</source>
        <translation>Zehn Zustände in einer Reihe, ein Sturz am einen Ende und das Ziel am anderen.</translation>
    </message>
    <message>
        <source>The Delft robot on two legs, in Box2D.</source>
        <translation>Der Delfter Roboter auf zwei Beinen, in Box2D.</translation>
    </message>
    <message>
        <source>The Delft robot on two legs, on the task of wcaarls/grl (addons/leosim), as a robot file.</source>
        <translation>Der Delfter Roboter auf zwei Beinen, mit der Aufgabe von wcaarls/grl (addons/leosim), als Roboterdatei.</translation>
    </message>
    <message>
        <source>The Delft robot on two legs: ten state variables, motors with gears, feet with heel and toe. It is paid for metres, and pays for energy, time and falls.</source>
        <translation>Der Delfter Roboter auf zwei Beinen: zehn Zustandsgrößen, Motoren mit Getriebe, Füße mit Ferse und Zehe. Meter werden belohnt; Energie, Zeit und Stürze kosten.</translation>
    </message>
    <message>
        <source>The angle between the hips that the hand-made controller aims at.</source>
        <translation>Der Winkel zwischen den Hüften, den der feste Regler anstrebt.</translation>
    </message>
    <message>
        <source>The angle that the ankles hold.</source>
        <translation>Der Winkel, den die Knöchel halten.</translation>
    </message>
    <message>
        <source>The best action, but any with probability ε.</source>
        <translation>Die beste Aktion, aber mit Wahrscheinlichkeit ε irgendeine.</translation>
    </message>
    <message>
        <source>The better an action, the likelier, by a temperature.</source>
        <translation>Je besser eine Aktion, desto wahrscheinlicher, je nach Temperatur.</translation>
    </message>
    <message>
        <source>The chance of every action in a state.</source>
        <translation>Die Wahrscheinlichkeit jeder Aktion in einem Zustand.</translation>
    </message>
    <message>
        <source>The difference to the reference is hardly chance.</source>
        <translation>Der Unterschied zur Referenz ist kaum Zufall.</translation>
    </message>
    <message>
        <source>The discount of the coarse value function V.</source>
        <translation>Der Diskontfaktor der groben Wertefunktion V.</translation>
    </message>
    <message>
        <source>The environment&apos;s own controller, which does not learn.</source>
        <translation>Der eigene Regler der Umgebung, der nicht lernt.</translation>
    </message>
    <message>
        <source>The environment&apos;s own controller. It does not learn.</source>
        <translation>Der eigene Regler der Umgebung. Er lernt nicht.</translation>
    </message>
    <message>
        <source>The episode from which on the average reward of all lives stands still. Falls are counted until then.</source>
        <translation>Die Episode, von der an die mittlere Belohnung aller Leben stillsteht. Bis dahin werden Stürze gezählt.</translation>
    </message>
    <message>
        <source>The feet are round.</source>
        <translation>Die Füße sind rund.</translation>
    </message>
    <message>
        <source>The guardian acts from this risk on, until the risk is below half of it.</source>
        <translation>Ab diesem Risiko handelt der Wächter, bis das Risiko unter der Hälfte davon liegt.</translation>
    </message>
    <message>
        <source>The largest; actions are levels between ± this.</source>
        <translation>Die größte; Aktionen sind Stufen zwischen ± diesem Wert.</translation>
    </message>
    <message>
        <source>The pole has fallen at this angle.</source>
        <translation>Bei diesem Winkel ist der Stab gestürzt.</translation>
    </message>
    <message>
        <source>The risk of an action of which nothing is known.</source>
        <translation>Das Risiko einer Aktion, über die nichts bekannt ist.</translation>
    </message>
    <message>
        <source>The robot with motors of 8.6 Ω.</source>
        <translation>Der Roboter mit Motoren von 8,6 Ω.</translation>
    </message>
    <message>
        <source>The rule of thumb appears with the first footstep.</source>
        <translation>Die Faustregel erscheint mit dem ersten Gehschritt.</translation>
    </message>
    <message>
        <source>The rule of thumb appears with the first success.</source>
        <translation>Die Faustregel erscheint mit dem ersten Erfolg.</translation>
    </message>
    <message>
        <source>The rule of thumb is not defined for this task: nothing is earned at a goal.</source>
        <translation>Die Faustregel ist für diese Aufgabe nicht definiert: An einem Ziel ist nichts zu verdienen.</translation>
    </message>
    <message>
        <source>The rule of thumb needs a learning rule that discounts.</source>
        <translation>Die Faustregel verlangt eine Lernregel mit Diskontfaktor.</translation>
    </message>
    <message>
        <source>The span of the wheel rate that its tiles are counted in: 20 rad/s is 1 m/s of the cart.</source>
        <translation>Spanne der Raddrehrate, in der ihre Kacheln gezählt werden: 20 rad/s sind 1 m/s des Wagens.</translation>
    </message>
    <message>
        <source>The step size of the coarse value function V.</source>
        <translation>Die Schrittweite der groben Wertefunktion V.</translation>
    </message>
    <message>
        <source>The surprise of a step: what came, and what is now expected, against what was expected.</source>
        <translation>Die Überraschung eines Schritts: was kam und was nun erwartet wird, gegen das, was erwartet wurde.</translation>
    </message>
    <message>
        <source>The swing foot meets the floor from this angle in front of the stance leg on.</source>
        <translation>Ab diesem Winkel vor dem Standbein trifft der Schwungfuß den Boden.</translation>
    </message>
    <message>
        <source>The thesis&apos;s inverted pendulum on a cart, as a robot file.</source>
        <translation>Das inverse Pendel der Masterarbeit auf einem Wagen, als Roboterdatei.</translation>
    </message>
    <message>
        <source>The thesis&apos;s inverted pendulum on a cart, in Box2D.</source>
        <translation>Das inverse Pendel der Masterarbeit auf einem Wagen, in Box2D.</translation>
    </message>
    <message>
        <source>The tiles cover the column from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Spalte von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the pole angle from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken den Stabwinkel von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the pole rate from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Stabdrehrate von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the position from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Position von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the row from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Zeile von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the stance angle from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken den Standbeinwinkel von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the stance hip from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Standbeinhüfte von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the stance hip rate from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Hüftdrehrate des Standbeins von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the stance knee from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken das Standbeinknie von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the stance knee rate from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Kniedrehrate des Standbeins von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the stance rate from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Drehrate des Standbeins von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the state from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken den Zustand von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the swing angle from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken den Schwungbeinwinkel von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the swing hip from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Schwungbeinhüfte von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the swing hip rate from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Hüftdrehrate des Schwungbeins von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the swing knee from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken das Schwungbeinknie von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the swing knee rate from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Kniedrehrate des Schwungbeins von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the swing rate from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Drehrate des Schwungbeins von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the torso from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken den Rumpfwinkel von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the torso rate from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Rumpfdrehrate von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the velocity from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Geschwindigkeit von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The tiles cover the wheel rate from here to there; outside they are worth 0.</source>
        <translation>Die Kacheln decken die Raddrehrate von hier bis dort ab; außerhalb sind sie 0 wert.</translation>
    </message>
    <message>
        <source>The value that the schedule goes to.</source>
        <translation>Der Wert, auf den der Verlauf zugeht.</translation>
    </message>
    <message>
        <source>The worse an action, the rarer it is taken. The temperature τ says how much worse counts: high, and all actions are nearly alike; low, and it is nearly greedy.</source>
        <translation>Je schlechter eine Aktion, desto seltener wird sie gewählt. Wie viel schlechter zählt, sagt die Temperatur τ: hoch, und alle Aktionen sind fast gleich; niedrig, und es ist fast greedy.</translation>
    </message>
    <message>
        <source>Thesis</source>
        <translation>Masterarbeit</translation>
    </message>
    <message>
        <source>Thigh centre x</source>
        <translation>Oberschenkel-SP x</translation>
    </message>
    <message>
        <source>Thigh centre y</source>
        <translation>Oberschenkel-SP y</translation>
    </message>
    <message>
        <source>Thigh inertia</source>
        <translation>Oberschenkelträgheit</translation>
    </message>
    <message>
        <source>Thigh mass</source>
        <translation>Oberschenkelmasse</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Threshold, clock</source>
        <translation>Schwelle, Zeitmaß</translation>
    </message>
    <message>
        <source>Threshold, end</source>
        <translation>Schwelle, Ende</translation>
    </message>
    <message>
        <source>Threshold, schedule</source>
        <translation>Schwelle, Verlauf</translation>
    </message>
    <message>
        <source>Threshold, time</source>
        <translation>Schwelle, Dauer</translation>
    </message>
    <message>
        <source>Threshold-restricted learning: ε-greedy whose exploring steps pick among the actions that are worth more than a threshold, and only in a small share p (“share below”) among the others. If no action or every action is above, it is ε-greedy.</source>
        <translation>Threshold Restricted Learning: ε-greedy, dessen Explorationsschritte unter den Aktionen wählen, die mehr wert sind als eine Schwelle, und nur zu einem kleinen Anteil p („Anteil darunter“) unter den anderen. Liegt keine oder jede Aktion darüber, ist es ε-greedy.</translation>
    </message>
    <message>
        <source>Tile coder</source>
        <translation>Tile Coder</translation>
    </message>
    <message>
        <source>Tile coding</source>
        <translation>Tile Coding</translation>
    </message>
    <message>
        <source>Tiles per 2π rad of the pole angle: few generalise far, many tell states apart.</source>
        <translation>Kacheln je 2π rad des Stabwinkels: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per 2π rad/s of the pole rate: few generalise far, many tell states apart.</source>
        <translation>Kacheln je 2π rad/s der Stabdrehrate: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per V of the stance hip voltage: few let near actions share more.</source>
        <translation>Kacheln je V der Hüftspannung des Standbeins: Bei wenigen teilen nahe Aktionen mehr.</translation>
    </message>
    <message>
        <source>Tiles per V of the swing hip voltage: few let near actions share more.</source>
        <translation>Kacheln je V der Hüftspannung des Schwungbeins: Bei wenigen teilen nahe Aktionen mehr.</translation>
    </message>
    <message>
        <source>Tiles per V of the swing knee voltage: few let near actions share more.</source>
        <translation>Kacheln je V der Kniespannung des Schwungbeins: Bei wenigen teilen nahe Aktionen mehr.</translation>
    </message>
    <message>
        <source>Tiles per cell of the column: few generalise far, many tell states apart.</source>
        <translation>Kacheln je Zelle der Spalte: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per cell of the row: few generalise far, many tell states apart.</source>
        <translation>Kacheln je Zelle der Zeile: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per cell of the state: few generalise far, many tell states apart.</source>
        <translation>Kacheln je Zelle des Zustands: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per m/s of the wheel rate: few generalise far, many tell states apart.</source>
        <translation>Kacheln je m/s der Raddrehrate: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad of the stance angle: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad des Standbeinwinkels: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad of the stance hip: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad der Standbeinhüfte: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad of the stance knee: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad des Standbeinknies: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad of the swing angle: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad des Schwungbeinwinkels: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad of the swing hip: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad der Schwungbeinhüfte: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad of the swing knee: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad des Schwungbeinknies: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad of the torso: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad des Rumpfwinkels: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the stance hip rate: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad/s der Hüftdrehrate des Standbeins: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the stance knee rate: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad/s der Kniedrehrate des Standbeins: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the stance rate: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad/s der Drehrate des Standbeins: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the swing hip rate: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad/s der Hüftdrehrate des Schwungbeins: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the swing knee rate: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad/s der Kniedrehrate des Schwungbeins: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the swing rate: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad/s der Drehrate des Schwungbeins: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the torso rate: few generalise far, many tell states apart.</source>
        <translation>Kacheln je rad/s der Rumpfdrehrate: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per span of a variable. Few generalise far, many tell states apart.</source>
        <translation>Kacheln je Spanne einer Variablen. Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per the whole range of the position: few generalise far, many tell states apart.</source>
        <translation>Kacheln auf den ganzen Bereich der Position: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles per the whole range of the velocity: few generalise far, many tell states apart.</source>
        <translation>Kacheln auf den ganzen Bereich der Geschwindigkeit: Wenige generalisieren weit, viele trennen Zustände.</translation>
    </message>
    <message>
        <source>Tiles that a hashed table of fixed size holds; 0: a dense table with room for all.</source>
        <translation>Kacheln, die in eine Hashtabelle fester Größe passen; 0: eine dichte Tabelle mit Platz für alle.</translation>
    </message>
    <message>
        <source>Tilings</source>
        <translation>Kachelungen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Time to the first greedy walk</source>
        <translation>Zeit bis zum ersten Greedy-Gang</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>To column</source>
        <translation>Bis Spalte</translation>
    </message>
    <message>
        <source>To row</source>
        <translation>Bis Zeile</translation>
    </message>
    <message>
        <source>To state</source>
        <translation>Bis Zustand</translation>
    </message>
    <message>
        <source>Toe radius</source>
        <translation>Zehenradius</translation>
    </message>
    <message>
        <source>Toe x</source>
        <translation>Zehe x</translation>
    </message>
    <message>
        <source>Toe y</source>
        <translation>Zehe y</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>Torque constant</source>
        <translation>Momentkonstante</translation>
    </message>
    <message>
        <source>Torso</source>
        <translation>Rumpf</translation>
    </message>
    <message>
        <source>Torso centre x</source>
        <translation>Rumpf-SP x</translation>
    </message>
    <message>
        <source>Torso centre y</source>
        <translation>Rumpf-SP y</translation>
    </message>
    <message>
        <source>Torso inertia</source>
        <translation>Rumpfträgheit</translation>
    </message>
    <message>
        <source>Torso mass</source>
        <translation>Rumpfmasse</translation>
    </message>
    <message>
        <source>Torso rate</source>
        <translation>Rumpfdrehrate</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Trace cut-off</source>
        <translation>Trace-Grenze</translation>
    </message>
    <message>
        <source>Trace decay</source>
        <translation>Trace-Abfall</translation>
    </message>
    <message>
        <source>Traces of the actions not taken in a state visited again: kept, or cleared.</source>
        <translation>Traces der nicht gewählten Aktionen in einem wieder besuchten Zustand: behalten oder löschen.</translation>
    </message>
    <message>
        <source>True online Sarsa</source>
        <translation>True Online Sarsa</translation>
    </message>
    <message>
        <source>True online Sarsa(λ)</source>
        <translation>True Online Sarsa(λ)</translation>
    </message>
    <message>
        <source>Turbo</source>
        <translation>Turbo</translation>
    </message>
    <message>
        <source>Two Sarsa learners: Q⁺ expects the gains, Q⁻ the losses, each with its own resolution, α and λ. Actions are chosen on the sum. A coarse Q⁻ generalises falls to states where none has happened yet.</source>
        <translation>Zwei Sarsa-Lerner: Q⁺ erwartet die Gewinne, Q⁻ die Verluste, jeder mit eigener Auflösung, eigenem α und λ. Aktionen werden nach der Summe gewählt. Ein grobes Q⁻ generalisiert Stürze auf Zustände, in denen noch keiner geschah.</translation>
    </message>
    <message>
        <source>Two links that hang, a motor between them; the tip must rise one link above the pivot (Sutton &amp; Barto).</source>
        <translation>Zwei hängende Glieder, dazwischen ein Motor; die Spitze muss ein Glied hoch über den Drehpunkt (Sutton &amp; Barto).</translation>
    </message>
    <message>
        <source>Two straight legs and a hip motor: the simplest thing that walks.</source>
        <translation>Zwei gerade Beine und ein Hüftmotor: das Einfachste, was gehen kann.</translation>
    </message>
    <message>
        <source>Two straight legs and a hip. The swing foot passes through the floor until it is in front.</source>
        <translation>Zwei gerade Beine und eine Hüfte. Der Schwungfuß geht durch den Boden, bis er vorn ist.</translation>
    </message>
    <message>
        <source>Two straight legs and a hip: the simplest thing that walks.</source>
        <translation>Zwei gerade Beine und eine Hüfte: das Einfachste, was gehen kann.</translation>
    </message>
    <message>
        <source>Uphill</source>
        <translation>Bergauf</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Voltage by which ankles hold their angle.</source>
        <translation>Spannung, mit der die Knöchel ihren Winkel halten.</translation>
    </message>
    <message>
        <source>Voltage by which the stance knee stretches itself.</source>
        <translation>Spannung, mit der sich das Knie des Standbeins streckt.</translation>
    </message>
    <message>
        <source>Watkins&apos;s Q(λ), off-policy.</source>
        <translation>Q(λ) nach Watkins, off-policy.</translation>
    </message>
    <message>
        <source>Weight of risk</source>
        <translation>Risikogewicht</translation>
    </message>
    <message>
        <source>Weight of risk, clock</source>
        <translation>Risikogewicht, Zeitmaß</translation>
    </message>
    <message>
        <source>Weight of risk, end</source>
        <translation>Risikogewicht, Ende</translation>
    </message>
    <message>
        <source>Weight of risk, schedule</source>
        <translation>Risikogewicht, Verlauf</translation>
    </message>
    <message>
        <source>Weight of risk, time</source>
        <translation>Risikogewicht, Dauer</translation>
    </message>
    <message>
        <source>What a fall one step later still counts; 1: all falls of the episode count.</source>
        <translation>Was ein Sturz einen Schritt später noch zählt; 1: Alle Stürze der Episode zählen.</translation>
    </message>
    <message>
        <source>What a reward one step later is still worth.</source>
        <translation>Was eine Belohnung einen Schritt später noch wert ist.</translation>
    </message>
    <message>
        <source>What is expected from action a in state s on: the sum of rewards, later ones worth less.</source>
        <translation>Was ab Aktion a in Zustand s zu erwarten ist: die Summe der Belohnungen, spätere weniger wert.</translation>
    </message>
    <message>
        <source>What is learned in a simulation that is a little wrong is carried over to the robot.</source>
        <translation>Was in einer Simulation gelernt wurde, die ein wenig abweicht, wird auf den Roboter übertragen.</translation>
    </message>
    <message>
        <source>What is to be avoided, while it learns as well: a fall can break the robot.</source>
        <translation>Was zu vermeiden ist, auch während des Lernens: Ein Sturz kann den Roboter beschädigen.</translation>
    </message>
    <message>
        <source>What the boom adds, upwards positive.</source>
        <translation>Was der Ausleger hinzufügt, nach oben positiv.</translation>
    </message>
    <message>
        <source>What the policy does with the risk of a fall, or with the losses of Sarsa_2Q.</source>
        <translation>Was die Policy mit dem Sturzrisiko macht oder mit den Verlusten von Sarsa_2Q.</translation>
    </message>
    <message>
        <source>What the robot is meant to be.</source>
        <translation>Was der Roboter sein soll.</translation>
    </message>
    <message>
        <source>What the time of the schedule is counted in.</source>
        <translation>Worin die Dauer des Verlaufs gezählt wird.</translation>
    </message>
    <message>
        <source>Wheel mass</source>
        <translation>Radmasse</translation>
    </message>
    <message>
        <source>Wheel radius</source>
        <translation>Radradius</translation>
    </message>
    <message>
        <source>Wheel rate</source>
        <translation>Raddrehrate</translation>
    </message>
    <message>
        <source>Wheel span</source>
        <translation>Radspanne</translation>
    </message>
    <message>
        <source>Where the boom&apos;s force acts on the torso.</source>
        <translation>Wo die Kraft des Auslegers am Rumpf angreift.</translation>
    </message>
    <message>
        <source>Where the joint is in the body above it.</source>
        <translation>Wo das Gelenk im Körper darüber sitzt.</translation>
    </message>
    <message>
        <source>Where the joint is in the body below it.</source>
        <translation>Wo das Gelenk im Körper darunter sitzt.</translation>
    </message>
    <message>
        <source>Where the joint&apos;s stop is, bent backwards.</source>
        <translation>Wo der Anschlag des Gelenks ist, nach hinten gebeugt.</translation>
    </message>
    <message>
        <source>Where the joint&apos;s stop is, bent forwards.</source>
        <translation>Wo der Anschlag des Gelenks ist, nach vorn gebeugt.</translation>
    </message>
    <message>
        <source>Which estimate learns from this reward: by its sign, Q⁺, Q⁻ or both.</source>
        <translation>Welcher Schätzwert aus dieser Belohnung lernt: nach Vorzeichen, Q⁺, Q⁻ oder beide.</translation>
    </message>
    <message>
        <source>Which weights a surprise still reaches: those of the last steps, the older the less.</source>
        <translation>Welche Gewichte eine Überraschung noch erreicht: die der letzten Schritte, je älter, desto weniger.</translation>
    </message>
    <message>
        <source>Who acts while the policy&apos;s action is too risky: the robot&apos;s own controller, or a Q-function of a file. The learner learns from it.</source>
        <translation>Wer handelt, solange die Aktion der Policy zu riskant ist: der eigene Regler des Roboters oder eine Q-Funktion aus einer Datei. Der Lerner lernt daraus.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width column</source>
        <translation>Breite Spalte</translation>
    </message>
    <message>
        <source>Width row</source>
        <translation>Breite Zeile</translation>
    </message>
    <message>
        <source>Width state</source>
        <translation>Breite Zustand</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the column: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Spalte: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the pole angle: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang des Stabwinkels: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the pole rate: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Stabdrehrate: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the position: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Position: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the row: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Zeile: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance angle: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang des Standbeinwinkels: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance hip rate: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Hüftdrehrate des Standbeins: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance hip: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Standbeinhüfte: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance knee rate: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Kniedrehrate des Standbeins: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance knee: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang des Standbeinknies: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance rate: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Drehrate des Standbeins: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the state: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang des Zustands: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing angle: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang des Schwungbeinwinkels: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing hip rate: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Hüftdrehrate des Schwungbeins: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing hip: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Schwungbeinhüfte: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing knee rate: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Kniedrehrate des Schwungbeins: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing knee: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang des Schwungbeinknies: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing rate: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Drehrate des Schwungbeins: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the torso rate: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Rumpfdrehrate: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the torso: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang des Rumpfwinkels: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the velocity: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Geschwindigkeit: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the wheel rate: a wide one generalises far.</source>
        <translation>Breite σ der Gauß-Funktionen entlang der Raddrehrate: Eine große generalisiert weit.</translation>
    </message>
    <message>
        <source>X, significant</source>
        <translation>X, signifikant</translation>
    </message>
    <message>
        <source>a fall</source>
        <translation>ein Sturz</translation>
    </message>
    <message>
        <source>accumulating</source>
        <translation>akkumulierend</translation>
    </message>
    <message>
        <source>action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>asymmetry</source>
        <translation>Asymmetrie</translation>
    </message>
    <message>
        <source>asymmetry of errors</source>
        <translation>Fehlerasymmetrie</translation>
    </message>
    <message>
        <source>average reward</source>
        <translation>mittlere Belohnung</translation>
    </message>
    <message>
        <source>average reward at the end</source>
        <translation>mittlere Belohnung am Ende</translation>
    </message>
    <message>
        <source>balanced</source>
        <translation>balanciert</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>kalibriert</translation>
    </message>
    <message>
        <source>cart position</source>
        <translation>Position des Wagens</translation>
    </message>
    <message>
        <source>change in 250 episodes</source>
        <translation>Änderung in 250 Episoden</translation>
    </message>
    <message>
        <source>choose</source>
        <translation>wählen</translation>
    </message>
    <message>
        <source>choose, because</source>
        <translation>wählen, weil</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>löschen</translation>
    </message>
    <message>
        <source>cliff</source>
        <translation>Klippe</translation>
    </message>
    <message>
        <source>column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>compare</source>
        <translation>vergleichen</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>konstant</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>counted in</source>
        <translation>gezählt in</translation>
    </message>
    <message>
        <source>discount</source>
        <translation>Diskontfaktor</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>distance of a greedy test, last 10</source>
        <translation>Strecke eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>distance of a greedy test, last 10 [m]</source>
        <translation>Strecke eines Greedy-Tests, letzte 10 [m]</translation>
    </message>
    <message>
        <source>distance of a life</source>
        <translation>Strecke eines Lebens</translation>
    </message>
    <message>
        <source>distance of a life [m]</source>
        <translation>Strecke eines Lebens [m]</translation>
    </message>
    <message>
        <source>down</source>
        <translation>abwärts</translation>
    </message>
    <message>
        <source>end value</source>
        <translation>Endwert</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>energy of a greedy test, last 10</source>
        <translation>Energie eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>energy of a greedy test, last 10 [J]</source>
        <translation>Energie eines Greedy-Tests, letzte 10 [J]</translation>
    </message>
    <message>
        <source>energy of a life</source>
        <translation>Energie eines Lebens</translation>
    </message>
    <message>
        <source>energy of a life [J]</source>
        <translation>Energie eines Lebens [J]</translation>
    </message>
    <message>
        <source>energy, 0 upright at rest</source>
        <translation>Energie, 0 aufrecht in Ruhe</translation>
    </message>
    <message>
        <source>episode</source>
        <translation>Episode</translation>
    </message>
    <message>
        <source>episodes</source>
        <translation>Episoden</translation>
    </message>
    <message>
        <source>error of the risk</source>
        <translation>Fehler des Risikos</translation>
    </message>
    <message>
        <source>events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>explore</source>
        <translation>explorieren</translation>
    </message>
    <message>
        <source>exponential</source>
        <translation>exponentiell</translation>
    </message>
    <message>
        <source>fall</source>
        <translation>Sturz</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>falls an hour</source>
        <translation>Stürze pro Stunde</translation>
    </message>
    <message>
        <source>falls by episode 330</source>
        <translation>Stürze bis Episode 330</translation>
    </message>
    <message>
        <source>falls by minute 1</source>
        <translation>Stürze bis Minute 1</translation>
    </message>
    <message>
        <source>falls by minute 3</source>
        <translation>Stürze bis Minute 3</translation>
    </message>
    <message>
        <source>falls by minute 6</source>
        <translation>Stürze bis Minute 6</translation>
    </message>
    <message>
        <source>falls during learning</source>
        <translation>Stürze während des Lernens</translation>
    </message>
    <message>
        <source>falls of a greedy episode at the end</source>
        <translation>Stürze einer Greedy-Episode am Ende</translation>
    </message>
    <message>
        <source>falls of a greedy test, last 10</source>
        <translation>Stürze eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>falls of a life</source>
        <translation>Stürze eines Lebens</translation>
    </message>
    <message>
        <source>falls per episode, last 500</source>
        <translation>Stürze pro Episode, letzte 500</translation>
    </message>
    <message>
        <source>falls so far</source>
        <translation>bisherige Stürze</translation>
    </message>
    <message>
        <source>falls taken back</source>
        <translation>zurückgenommene Stürze</translation>
    </message>
    <message>
        <source>falls where this was said</source>
        <translation>Stürze, wo dies gesagt wurde</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>find the mistake</source>
        <translation>Fehler finden</translation>
    </message>
    <message>
        <source>footstep</source>
        <translation>Gehschritt</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>from column</source>
        <translation>ab Spalte</translation>
    </message>
    <message>
        <source>from row</source>
        <translation>ab Zeile</translation>
    </message>
    <message>
        <source>from state</source>
        <translation>ab Zustand</translation>
    </message>
    <message>
        <source>gains</source>
        <translation>Gewinne</translation>
    </message>
    <message>
        <source>gait</source>
        <translation>Gang</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>hand-made</source>
        <translation>fester Regler</translation>
    </message>
    <message>
        <source>hashed tiles</source>
        <translation>Hash-Kacheln</translation>
    </message>
    <message>
        <source>highest value</source>
        <translation>höchster Wert</translation>
    </message>
    <message>
        <source>hip height</source>
        <translation>Hüfthöhe</translation>
    </message>
    <message>
        <source>hip position</source>
        <translation>Hüftposition</translation>
    </message>
    <message>
        <source>hip speed</source>
        <translation>Hüftgeschwindigkeit</translation>
    </message>
    <message>
        <source>hip torque</source>
        <translation>Hüftmoment</translation>
    </message>
    <message>
        <source>initial</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>lab file</source>
        <translation>Datei des Labors</translation>
    </message>
    <message>
        <source>learner</source>
        <translation>Lerner</translation>
    </message>
    <message>
        <source>learning time [min]</source>
        <translation>Lernzeit [min]</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>left ankle angle</source>
        <translation>Knöchelwinkel (links)</translation>
    </message>
    <message>
        <source>left ankle current</source>
        <translation>Knöchelstrom (links)</translation>
    </message>
    <message>
        <source>left ankle power</source>
        <translation>Knöchelleistung (links)</translation>
    </message>
    <message>
        <source>left ankle rate</source>
        <translation>Knöcheldrehrate (links)</translation>
    </message>
    <message>
        <source>left ankle voltage</source>
        <translation>Knöchelspannung (links)</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>linker Fuß</translation>
    </message>
    <message>
        <source>left foot on the floor</source>
        <translation>linker Fuß am Boden</translation>
    </message>
    <message>
        <source>left heel</source>
        <translation>linke Ferse</translation>
    </message>
    <message>
        <source>left hip angle</source>
        <translation>Hüftwinkel (links)</translation>
    </message>
    <message>
        <source>left hip current</source>
        <translation>Hüftstrom (links)</translation>
    </message>
    <message>
        <source>left hip power</source>
        <translation>Hüftleistung (links)</translation>
    </message>
    <message>
        <source>left hip rate</source>
        <translation>Hüftdrehrate (links)</translation>
    </message>
    <message>
        <source>left hip voltage</source>
        <translation>Hüftspannung (links)</translation>
    </message>
    <message>
        <source>left knee angle</source>
        <translation>Kniewinkel (links)</translation>
    </message>
    <message>
        <source>left knee current</source>
        <translation>Kniestrom (links)</translation>
    </message>
    <message>
        <source>left knee power</source>
        <translation>Knieleistung (links)</translation>
    </message>
    <message>
        <source>left knee rate</source>
        <translation>Kniedrehrate (links)</translation>
    </message>
    <message>
        <source>left knee voltage</source>
        <translation>Kniespannung (links)</translation>
    </message>
    <message>
        <source>left toe</source>
        <translation>linke Zehe</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>lives that walk</source>
        <translation>Leben, die gehen</translation>
    </message>
    <message>
        <source>losses</source>
        <translation>Verluste</translation>
    </message>
    <message>
        <source>measures</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>move</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>n grids lie over each other, displaced. A state is in one tile of each; states that share tiles share what is learned.</source>
        <translation>n Gitter liegen versetzt übereinander. In jedem liegt ein Zustand in einer Kachel; Zustände, die Kacheln teilen, teilen auch das Gelernte.</translation>
    </message>
    <message>
        <source>n*, transitions of a success</source>
        <translation>n*, Übergänge eines Erfolgs</translation>
    </message>
    <message>
        <source>negative</source>
        <translation>negativ</translation>
    </message>
    <message>
        <source>net footsteps</source>
        <translation>Netto-Gehschritte</translation>
    </message>
    <message>
        <source>net footsteps of a greedy test, last 10</source>
        <translation>Netto-Gehschritte eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>net footsteps of a life</source>
        <translation>Netto-Gehschritte eines Lebens</translation>
    </message>
    <message>
        <source>nobody</source>
        <translation>niemand</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>number of the action</source>
        <translation>Nummer der Aktion</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>order</source>
        <translation>ordnen</translation>
    </message>
    <message>
        <source>ours</source>
        <translation>von uns</translation>
    </message>
    <message>
        <source>ours (Singh &amp; Sutton 1996)</source>
        <translation>von uns (Singh &amp; Sutton 1996)</translation>
    </message>
    <message>
        <source>ours (thesis, section 6.5)</source>
        <translation>von uns (Masterarbeit, Abschnitt 6.5)</translation>
    </message>
    <message>
        <source>ours: 0, as in the thesis</source>
        <translation>von uns: 0, wie in der Masterarbeit</translation>
    </message>
    <message>
        <source>ours: 0, as in the thesis (Mihatsch &amp; Neuneier 2002)</source>
        <translation>von uns: 0, wie in der Masterarbeit (Mihatsch &amp; Neuneier 2002)</translation>
    </message>
    <message>
        <source>ours: 1 is Sarsa_2Q of the thesis</source>
        <translation>von uns: 1 ist Sarsa_2Q der Masterarbeit</translation>
    </message>
    <message>
        <source>ours: as the learner&apos;s</source>
        <translation>von uns: wie beim Lerner</translation>
    </message>
    <message>
        <source>ours: half a tile</source>
        <translation>von uns: eine halbe Kachel</translation>
    </message>
    <message>
        <source>ours: nobody, as in the thesis</source>
        <translation>von uns: niemand, wie in der Masterarbeit</translation>
    </message>
    <message>
        <source>ours: off, as in the thesis</source>
        <translation>von uns: aus, wie in der Masterarbeit</translation>
    </message>
    <message>
        <source>ours: on top of the reward of a fall</source>
        <translation>von uns: zusätzlich zur Belohnung eines Sturzes</translation>
    </message>
    <message>
        <source>ours: the probability of a fall in the episode</source>
        <translation>von uns: die Wahrscheinlichkeit eines Sturzes in der Episode</translation>
    </message>
    <message>
        <source>over</source>
        <translation>über</translation>
    </message>
    <message>
        <source>own words</source>
        <translation>eigene Worte</translation>
    </message>
    <message>
        <source>point</source>
        <translation>zeigen</translation>
    </message>
    <message>
        <source>pole angle</source>
        <translation>Stabwinkel</translation>
    </message>
    <message>
        <source>pole rate</source>
        <translation>Stabdrehrate</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>positive</source>
        <translation>positiv</translation>
    </message>
    <message>
        <source>power of all motors</source>
        <translation>Leistung aller Motoren</translation>
    </message>
    <message>
        <source>power of the hip</source>
        <translation>Leistung der Hüfte</translation>
    </message>
    <message>
        <source>power of the wheel</source>
        <translation>Leistung des Rads</translation>
    </message>
    <message>
        <source>predict</source>
        <translation>vorhersagen</translation>
    </message>
    <message>
        <source>price of a fall at the end</source>
        <translation>Preis eines Sturzes am Ende</translation>
    </message>
    <message>
        <source>probability</source>
        <translation>Wahrscheinlichkeit</translation>
    </message>
    <message>
        <source>probability of the action</source>
        <translation>Wahrscheinlichkeit der Aktion</translation>
    </message>
    <message>
        <source>puzzle</source>
        <translation>Rätsel</translation>
    </message>
    <message>
        <source>q-function</source>
        <translation>Q-Funktion</translation>
    </message>
    <message>
        <source>replacing</source>
        <translation>ersetzend</translation>
    </message>
    <message>
        <source>reverse</source>
        <translation>rückwärts</translation>
    </message>
    <message>
        <source>reward</source>
        <translation>Belohnung</translation>
    </message>
    <message>
        <source>reward of a greedy episode at the end</source>
        <translation>Belohnung einer Greedy-Episode am Ende</translation>
    </message>
    <message>
        <source>reward of a greedy test, last 10</source>
        <translation>Belohnung eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>reward of an episode, whole life</source>
        <translation>Belohnung einer Episode, ganzes Leben</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>right ankle angle</source>
        <translation>Knöchelwinkel (rechts)</translation>
    </message>
    <message>
        <source>right ankle current</source>
        <translation>Knöchelstrom (rechts)</translation>
    </message>
    <message>
        <source>right ankle power</source>
        <translation>Knöchelleistung (rechts)</translation>
    </message>
    <message>
        <source>right ankle rate</source>
        <translation>Knöcheldrehrate (rechts)</translation>
    </message>
    <message>
        <source>right ankle voltage</source>
        <translation>Knöchelspannung (rechts)</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>rechter Fuß</translation>
    </message>
    <message>
        <source>right foot on the floor</source>
        <translation>rechter Fuß am Boden</translation>
    </message>
    <message>
        <source>right heel</source>
        <translation>rechte Ferse</translation>
    </message>
    <message>
        <source>right hip angle</source>
        <translation>Hüftwinkel (rechts)</translation>
    </message>
    <message>
        <source>right hip current</source>
        <translation>Hüftstrom (rechts)</translation>
    </message>
    <message>
        <source>right hip power</source>
        <translation>Hüftleistung (rechts)</translation>
    </message>
    <message>
        <source>right hip rate</source>
        <translation>Hüftdrehrate (rechts)</translation>
    </message>
    <message>
        <source>right hip voltage</source>
        <translation>Hüftspannung (rechts)</translation>
    </message>
    <message>
        <source>right knee angle</source>
        <translation>Kniewinkel (rechts)</translation>
    </message>
    <message>
        <source>right knee current</source>
        <translation>Kniestrom (rechts)</translation>
    </message>
    <message>
        <source>right knee power</source>
        <translation>Knieleistung (rechts)</translation>
    </message>
    <message>
        <source>right knee rate</source>
        <translation>Kniedrehrate (rechts)</translation>
    </message>
    <message>
        <source>right knee voltage</source>
        <translation>Kniespannung (rechts)</translation>
    </message>
    <message>
        <source>right leg stands</source>
        <translation>rechtes Bein steht</translation>
    </message>
    <message>
        <source>right toe</source>
        <translation>rechte Zehe</translation>
    </message>
    <message>
        <source>risk of a fall, said at the end</source>
        <translation>Sturzrisiko, am Ende gesagt</translation>
    </message>
    <message>
        <source>risk of the action</source>
        <translation>Risiko der Aktion</translation>
    </message>
    <message>
        <source>row</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>schedule</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>share of actions that are not the best</source>
        <translation>Anteil der Aktionen, die nicht die besten sind</translation>
    </message>
    <message>
        <source>share of lives</source>
        <translation>Anteil der Leben</translation>
    </message>
    <message>
        <source>share of the guardian&apos;s actions</source>
        <translation>Anteil der Aktionen des Wächters</translation>
    </message>
    <message>
        <source>sign</source>
        <translation>Vorzeichen</translation>
    </message>
    <message>
        <source>simulated time [min]</source>
        <translation>simulierte Zeit [min]</translation>
    </message>
    <message>
        <source>stance angle</source>
        <translation>Winkel (Stand)</translation>
    </message>
    <message>
        <source>stance foot</source>
        <translation>Fuß (Stand)</translation>
    </message>
    <message>
        <source>stance hip</source>
        <translation>Hüfte (Stand)</translation>
    </message>
    <message>
        <source>stance hip rate</source>
        <translation>Hüftdrehrate (Stand)</translation>
    </message>
    <message>
        <source>stance hip voltage</source>
        <translation>Hüftspannung (Stand)</translation>
    </message>
    <message>
        <source>stance knee</source>
        <translation>Knie (Stand)</translation>
    </message>
    <message>
        <source>stance knee rate</source>
        <translation>Kniedrehrate (Stand)</translation>
    </message>
    <message>
        <source>stance rate</source>
        <translation>Drehrate (Stand)</translation>
    </message>
    <message>
        <source>stance shank</source>
        <translation>Unterschenkel (Stand)</translation>
    </message>
    <message>
        <source>stance thigh</source>
        <translation>Oberschenkel (Stand)</translation>
    </message>
    <message>
        <source>stance, far leg</source>
        <translation>Stand, fernes Bein</translation>
    </message>
    <message>
        <source>stance, near leg</source>
        <translation>Stand, nahes Bein</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>step size</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>step size, clock</source>
        <translation>Schrittweite, Zeitmaß</translation>
    </message>
    <message>
        <source>step size, end</source>
        <translation>Schrittweite, Ende</translation>
    </message>
    <message>
        <source>step size, schedule</source>
        <translation>Schrittweite, Verlauf</translation>
    </message>
    <message>
        <source>step size, time</source>
        <translation>Schrittweite, Dauer</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>swing angle</source>
        <translation>Winkel (Schwung)</translation>
    </message>
    <message>
        <source>swing foot</source>
        <translation>Fuß (Schwung)</translation>
    </message>
    <message>
        <source>swing hip</source>
        <translation>Hüfte (Schwung)</translation>
    </message>
    <message>
        <source>swing hip rate</source>
        <translation>Hüftdrehrate (Schwung)</translation>
    </message>
    <message>
        <source>swing hip voltage</source>
        <translation>Hüftspannung (Schwung)</translation>
    </message>
    <message>
        <source>swing knee</source>
        <translation>Knie (Schwung)</translation>
    </message>
    <message>
        <source>swing knee rate</source>
        <translation>Kniedrehrate (Schwung)</translation>
    </message>
    <message>
        <source>swing knee voltage</source>
        <translation>Kniespannung (Schwung)</translation>
    </message>
    <message>
        <source>swing rate</source>
        <translation>Drehrate (Schwung)</translation>
    </message>
    <message>
        <source>swing shank</source>
        <translation>Unterschenkel (Schwung)</translation>
    </message>
    <message>
        <source>swing thigh</source>
        <translation>Oberschenkel (Schwung)</translation>
    </message>
    <message>
        <source>task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>terms</source>
        <translation>Terme</translation>
    </message>
    <message>
        <source>the action explores</source>
        <translation>die Aktion exploriert</translation>
    </message>
    <message>
        <source>the episode ends</source>
        <translation>die Episode endet</translation>
    </message>
    <message>
        <source>throttle</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>tilings</source>
        <translation>Kachelungen</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>time to the first greedy walk</source>
        <translation>Zeit bis zum ersten Greedy-Gang</translation>
    </message>
    <message>
        <source>time to the first greedy walk [min]</source>
        <translation>Zeit bis zum ersten Greedy-Gang [min]</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>to column</source>
        <translation>bis Spalte</translation>
    </message>
    <message>
        <source>to row</source>
        <translation>bis Zeile</translation>
    </message>
    <message>
        <source>to state</source>
        <translation>bis Zustand</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>torque of the wheel</source>
        <translation>Drehmoment des Rads</translation>
    </message>
    <message>
        <source>torque on the swing leg</source>
        <translation>Drehmoment am Schwungbein</translation>
    </message>
    <message>
        <source>torso</source>
        <translation>Rumpf</translation>
    </message>
    <message>
        <source>torso rate</source>
        <translation>Rumpfdrehrate</translation>
    </message>
    <message>
        <source>trace decay</source>
        <translation>Trace-Abfall</translation>
    </message>
    <message>
        <source>transitions of a failure, after learning</source>
        <translation>Übergänge eines Misserfolgs, nach dem Lernen</translation>
    </message>
    <message>
        <source>transitions of a failure, during learning</source>
        <translation>Übergänge eines Misserfolgs, während des Lernens</translation>
    </message>
    <message>
        <source>transitions of a success, after learning</source>
        <translation>Übergänge eines Erfolgs, nach dem Lernen</translation>
    </message>
    <message>
        <source>transitions of a success, during learning</source>
        <translation>Übergänge eines Erfolgs, während des Lernens</translation>
    </message>
    <message>
        <source>transitions of an episode, first 80</source>
        <translation>Übergänge einer Episode, erste 80</translation>
    </message>
    <message>
        <source>try</source>
        <translation>probieren</translation>
    </message>
    <message>
        <source>up</source>
        <translation>aufwärts</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>value of the action</source>
        <translation>Wert der Aktion</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>voltages</source>
        <translation>Spannungen</translation>
    </message>
    <message>
        <source>walk</source>
        <translation>gehen</translation>
    </message>
    <message>
        <source>watch</source>
        <translation>zusehen</translation>
    </message>
    <message>
        <source>wcaarls/grl, addons/leosim</source>
        <translation>wcaarls/grl, addons/leosim</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>wheel rate</source>
        <translation>Raddrehrate</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>width column</source>
        <translation>Breite Spalte</translation>
    </message>
    <message>
        <source>width row</source>
        <translation>Breite Zeile</translation>
    </message>
    <message>
        <source>width state</source>
        <translation>Breite Zustand</translation>
    </message>
    <message>
        <source>work out</source>
        <translation>ausrechnen</translation>
    </message>
    <message>
        <source>z, trace (eligibility)</source>
        <translation>z, Trace (Eligibility)</translation>
    </message>
    <message>
        <source>δ, error</source>
        <translation>δ, Fehler</translation>
    </message>
    <message>
        <source>ε-greedy</source>
        <translation>ε-greedy</translation>
    </message>
    <message>
        <source>ε-greedy that explores among the actions above a threshold.</source>
        <translation>ε-greedy, das unter den Aktionen über einer Schwelle exploriert.</translation>
    </message>
    <message>
        <source>π, policy</source>
        <translation>π, Policy</translation>
    </message>
    <message>
        <source>the whole range</source>
        <translation>den ganzen Bereich</translation>
    </message>
    <message>
        <source>343 actions = 7³: three voltages of seven levels</source>
        <translation>343 Aktionen = 7³: drei Spannungen mit sieben Stufen</translation>
    </message>
    <message>
        <source>A⁺ = {a: Q(s, a) &gt; threshold}</source>
        <translation>A⁺ = {a: Q(s, a) &gt; Schwelle}</translation>
    </message>
    <message>
        <source>A⁺ = {a: Q(s, a) &gt; threshold}; exploring steps pick from A⁺</source>
        <translation>A⁺ = {a: Q(s, a) &gt; Schwelle}; explorierende Schritte wählen aus A⁺</translation>
    </message>
    <message>
        <source>F = m·a of the cart, its wheel besides</source>
        <translation>F = m·a des Wagens, dazu sein Rad</translation>
    </message>
    <message>
        <source>F = γ·V(s′) − V(s) is added to the reward</source>
        <translation>F = γ·V(s′) − V(s) kommt zur Belohnung hinzu</translation>
    </message>
    <message>
        <source>F_y = boom force at the boom point</source>
        <translation>F_y = Auslegerkraft am Auslegerpunkt</translation>
    </message>
    <message>
        <source>I = m·l²/12 about its centre of mass</source>
        <translation>I = m·l²/12 um ihren Schwerpunkt</translation>
    </message>
    <message>
        <source>I = m·l²/12, centre of mass at l/2</source>
        <translation>I = m·l²/12, Schwerpunkt bei l/2</translation>
    </message>
    <message>
        <source>Q(s, a) = 0 where s &lt; from or s &gt; to</source>
        <translation>Q(s, a) = 0, wo s &lt; von oder s &gt; bis</translation>
    </message>
    <message>
        <source>Q(s, a) = Σ of n weights, one a tiling;  tile i = ⌊(x/width·n + i·(2d + 1))/n⌋</source>
        <translation>Q(s, a) = Σ von n Gewichten, eines je Kachelung;  Kachel i = ⌊(x/Breite·n + i·(2d + 1))/n⌋</translation>
    </message>
    <message>
        <source>Q(s, a) = Σ of n weights, one of each tiling; tiling i is displaced by i/n of a tile and more</source>
        <translation>Q(s, a) = Σ von n Gewichten, eines je Kachelung; Kachelung i ist um i/n einer Kachel und mehr verschoben</translation>
    </message>
    <message>
        <source>Q(s, a) has a weight of its own for every pair</source>
        <translation>Q(s, a) hat für jedes Paar ein eigenes Gewicht</translation>
    </message>
    <message>
        <source>T = scale·T(a)</source>
        <translation>T = Skalierung·T(a)</translation>
    </message>
    <message>
        <source>T in v = start + (end − start)·min(t/T, 1) and v = end + (start − end)·2^(−t/T)</source>
        <translation>T in v = Anfang + (Ende − Anfang)·min(t/T, 1) und v = Ende + (Anfang − Ende)·2^(−t/T)</translation>
    </message>
    <message>
        <source>T_hinge = −μ·sign(α̇)</source>
        <translation>T_Gelenk = −μ·sign(α̇)</translation>
    </message>
    <message>
        <source>T_wheel = T(a) − c·β̇</source>
        <translation>T_Rad = T(a) − c·β̇</translation>
    </message>
    <message>
        <source>U = gain·(0 − knee angle)</source>
        <translation>U = Verstärkung·(0 − Kniewinkel)</translation>
    </message>
    <message>
        <source>U = gain·(target − ankle angle)</source>
        <translation>U = Verstärkung·(Ziel − Knöchelwinkel)</translation>
    </message>
    <message>
        <source>U = −U_max … U_max, in equal steps</source>
        <translation>U = −U_max … U_max, in gleichen Schritten</translation>
    </message>
    <message>
        <source>a circle |p − centre| = r meets the floor</source>
        <translation>ein Kreis |p − Mittelpunkt| = r berührt den Boden</translation>
    </message>
    <message>
        <source>a test after the episodes k, 2k, 3k, …</source>
        <translation>ein Test nach den Episoden k, 2k, 3k, …</translation>
    </message>
    <message>
        <source>actions = levels³, each of three voltages U_i = U_max·(2i/(levels − 1) − 1)</source>
        <translation>Aktionen = Stufen³, jede aus drei Spannungen U_i = U_max·(2i/(Stufen − 1) − 1)</translation>
    </message>
    <message>
        <source>after a fall s ← s of N steps before, and a new action there</source>
        <translation>nach einem Sturz s ← s von N Schritten zuvor, und dort eine neue Aktion</translation>
    </message>
    <message>
        <source>an episode ends with the fall after so many that were taken back</source>
        <translation>eine Episode endet mit dem Sturz nach so vielen zurückgenommenen</translation>
    </message>
    <message>
        <source>an episode that ends in a failure state</source>
        <translation>eine Episode, die in einem Fehlerzustand endet</translation>
    </message>
    <message>
        <source>an episode under the greedy policy, which is not counted</source>
        <translation>eine Episode unter der Greedy-Policy, die nicht mitzählt</translation>
    </message>
    <message>
        <source>angle(0) = this, ω(0) = 0</source>
        <translation>Winkel(0) = dies, ω(0) = 0</translation>
    </message>
    <message>
        <source>balanced: |α| ≤ 0.005π, |α̇| ≤ 0.005π rad/s; fallen: |α| ≥ 0.45π</source>
        <translation>balanciert: |α| ≤ 0,005π, |α̇| ≤ 0,005π rad/s; gestürzt: |α| ≥ 0,45π</translation>
    </message>
    <message>
        <source>clear: z(s, b) ← 0 for all b ≠ a</source>
        <translation>löschen: z(s, b) ← 0 für alle b ≠ a</translation>
    </message>
    <message>
        <source>damping c, friction μ, torque scaling</source>
        <translation>Dämpfung c, Reibung μ, Skalierung des Drehmoments</translation>
    </message>
    <message>
        <source>first k ≥ 330 with |A(k) − A(k − 250)| &lt; 0.015·R_goal and A(k) &gt; 0.75·R_goal</source>
        <translation>erstes k ≥ 330 mit |A(k) − A(k − 250)| &lt; 0,015·R_Ziel und A(k) &gt; 0,75·R_Ziel</translation>
    </message>
    <message>
        <source>g = (g·sin slope, −g·cos slope)</source>
        <translation>g = (g·sin Neigung, −g·cos Neigung)</translation>
    </message>
    <message>
        <source>half of it on each leg: F = m·a</source>
        <translation>die Hälfte auf jedem Bein: F = m·a</translation>
    </message>
    <message>
        <source>hand-made: hip angle → target in every step</source>
        <translation>fester Regler: Hüftwinkel → Ziel in jedem Schritt</translation>
    </message>
    <message>
        <source>height of the hip = l·cos(stance angle)</source>
        <translation>Höhe der Hüfte = l·cos(Winkel Standbein)</translation>
    </message>
    <message>
        <source>it acts from ρ(s, a) &gt; limit until ρ(s, a) ≤ limit/2, a drawn by the policy</source>
        <translation>er greift ein ab ρ(s, a) &gt; Grenze bis ρ(s, a) ≤ Grenze/2, a von der Policy gezogen</translation>
    </message>
    <message>
        <source>learn on a model until the average reward is R, then go on in reality</source>
        <translation>an einem Modell lernen, bis die mittlere Belohnung R ist, dann in der Wirklichkeit weiter</translation>
    </message>
    <message>
        <source>linear: v = start + (end − start)·min(t/T, 1); exponential: v = end + (start − end)·2^(−t/T)</source>
        <translation>linear: v = Anfang + (Ende − Anfang)·min(t/T, 1); exponentiell: v = Ende + (Anfang − Ende)·2^(−t/T)</translation>
    </message>
    <message>
        <source>low ≤ joint angle ≤ high</source>
        <translation>min ≤ Gelenkwinkel ≤ max</translation>
    </message>
    <message>
        <source>mean total reward of the last 80 episodes</source>
        <translation>mittlere Gesamtbelohnung der letzten 80 Episoden</translation>
    </message>
    <message>
        <source>n* = mean length of the successful episodes [steps]</source>
        <translation>n* = mittlere Länge der erfolgreichen Episoden [Schritte]</translation>
    </message>
    <message>
        <source>p &lt; .01: of pairs, of Q-functions, or the analysis of variance of lives</source>
        <translation>p &lt; 0,01: von Paaren, von Q-Funktionen oder die Varianzanalyse der Leben</translation>
    </message>
    <message>
        <source>p = (x, y) in the body&apos;s frame</source>
        <translation>p = (x, y) im System des Körpers</translation>
    </message>
    <message>
        <source>r = fall when it falls, which ends the episode</source>
        <translation>r = Sturz, wenn er stürzt; das beendet die Episode</translation>
    </message>
    <message>
        <source>r = footstep·length of the step [m]; fall, and the episode ends</source>
        <translation>r = Gehschritt·Länge des Schritts [m]; Sturz, und die Episode endet</translation>
    </message>
    <message>
        <source>r = goal when it is reached, which ends the episode</source>
        <translation>r = Ziel, wenn es erreicht ist; das beendet die Episode</translation>
    </message>
    <message>
        <source>r = −1 a step until it is over the hill</source>
        <translation>r = −1 je Schritt, bis es über dem Hügel ist</translation>
    </message>
    <message>
        <source>r = −1 a step, −100 and a fall over the edge</source>
        <translation>r = −1 je Schritt, −100 und ein Sturz über die Kante</translation>
    </message>
    <message>
        <source>r ← r + energy·E, E = Σ max(0, U·I)·Δt of hips and knees</source>
        <translation>r ← r + Energie·E, E = Σ max(0, U·I)·Δt von Hüften und Knien</translation>
    </message>
    <message>
        <source>r ← r + footstep·Δx, Δx the metres gained [m]</source>
        <translation>r ← r + Gehschritt·Δx, Δx die gewonnenen Meter [m]</translation>
    </message>
    <message>
        <source>r ← r + time at every step</source>
        <translation>r ← r + Zeit bei jedem Schritt</translation>
    </message>
    <message>
        <source>r ← r − Λ·[fall]; Λ ← max(0, Λ + η·(falls − d)) after every episode</source>
        <translation>r ← r − Λ·[Sturz]; Λ ← max(0, Λ + η·(Stürze − d)) nach jeder Episode</translation>
    </message>
    <message>
        <source>replacing: z(s, a) ← 1; accumulating: z(s, a) ← γ·λ·z(s, a) + 1</source>
        <translation>ersetzend: z(s, a) ← 1; akkumulierend: z(s, a) ← γ·λ·z(s, a) + 1</translation>
    </message>
    <message>
        <source>sign: r⁺ = max(r, 0), r⁻ = min(r, 0); both: r⁺ = r⁻ = r</source>
        <translation>Vorzeichen: r⁺ = max(r, 0), r⁻ = min(r, 0); beide: r⁺ = r⁻ = r</translation>
    </message>
    <message>
        <source>slot = hash(tile) mod memory</source>
        <translation>Platz = hash(Kachel) mod Speicher</translation>
    </message>
    <message>
        <source>stance angle(0) = this·(1 ± noise)</source>
        <translation>Winkel Standbein(0) = dies·(1 ± Rauschen)</translation>
    </message>
    <message>
        <source>stance rate(0) = this·(1 ± noise)</source>
        <translation>Drehrate Standbein(0) = dies·(1 ± Rauschen)</translation>
    </message>
    <message>
        <source>start = usual start·(1 + noise·U[−1, 1])</source>
        <translation>Start = üblicher Start·(1 + Rauschen·U[−1, 1])</translation>
    </message>
    <message>
        <source>step &lt; episode &lt; life &lt; experiment</source>
        <translation>Schritt &lt; Episode &lt; Leben &lt; Experiment</translation>
    </message>
    <message>
        <source>steps a second as many as the processor can</source>
        <translation>so viele Schritte je Sekunde, wie der Prozessor kann</translation>
    </message>
    <message>
        <source>swing angle(0) = this·(1 ± noise)</source>
        <translation>Winkel Schwungbein(0) = dies·(1 ± Rauschen)</translation>
    </message>
    <message>
        <source>swing − stance ≥ angle: the foot meets the floor</source>
        <translation>Schwung − Stand ≥ Winkel: der Fuß berührt den Boden</translation>
    </message>
    <message>
        <source>t = episodes or steps of the life so far</source>
        <translation>t = Episoden oder Schritte des Lebens bisher</translation>
    </message>
    <message>
        <source>t = limit: the episode is cut off, and Q(s′, ·) still counts</source>
        <translation>t = Grenze: Die Episode wird abgebrochen, und Q(s′, ·) zählt noch</translation>
    </message>
    <message>
        <source>tangential force ≤ grip·normal force</source>
        <translation>Tangentialkraft ≤ Haftung·Normalkraft</translation>
    </message>
    <message>
        <source>terms: r⁺ = Σ of terms above 0; sum: r⁺ = max(r, 0), r⁻ = min(r, 0)</source>
        <translation>Terme: r⁺ = Σ der Terme über 0; Summe: r⁺ = max(r, 0), r⁻ = min(r, 0)</translation>
    </message>
    <message>
        <source>threshold = γ^n*·R_goal + Σ γ^k·R_time, k = 1 … n*</source>
        <translation>Schwelle = γ^n*·R_Ziel + Σ γ^k·R_Zeit, k = 1 … n*</translation>
    </message>
    <message>
        <source>tile width = 1/(resolution·scale)</source>
        <translation>Kachelbreite = 1/(Auflösung·Skalierung)</translation>
    </message>
    <message>
        <source>tile width = span/(resolution·scale)</source>
        <translation>Kachelbreite = Spanne/(Auflösung·Skalierung)</translation>
    </message>
    <message>
        <source>tile width of the wheel rate = wheel span/(resolution·scale)</source>
        <translation>Kachelbreite der Raddrehrate = Radspanne/(Auflösung·Skalierung)</translation>
    </message>
    <message>
        <source>tile width, or spacing of centres = span/(resolution·scale)</source>
        <translation>Kachelbreite oder Abstand der Mittelpunkte = Spanne/(Auflösung·Skalierung)</translation>
    </message>
    <message>
        <source>torque = I·dω/dt</source>
        <translation>Drehmoment = I·dω/dt</translation>
    </message>
    <message>
        <source>torque = J·dω/dt is taken by the rotor</source>
        <translation>Drehmoment = J·dω/dt nimmt der Rotor auf</translation>
    </message>
    <message>
        <source>torque = η·k·G·I, I = (U − k·G·ω)/R</source>
        <translation>Drehmoment = η·k·G·I, I = (U − k·G·ω)/R</translation>
    </message>
    <message>
        <source>torque = −F·sign(ω)</source>
        <translation>Drehmoment = −F·sign(ω)</translation>
    </message>
    <message>
        <source>torque = −damping·ω beyond the stop</source>
        <translation>Drehmoment = −Dämpfung·ω jenseits des Anschlags</translation>
    </message>
    <message>
        <source>torque = −stiffness·(angle beyond the stop)</source>
        <translation>Drehmoment = −Steifigkeit·(Winkel jenseits des Anschlags)</translation>
    </message>
    <message>
        <source>v → end as t grows: v = end for t ≥ T (linear), half as far at every T (exponential)</source>
        <translation>v → Ende, wenn t wächst: v = Ende für t ≥ T (linear), nach jedem T halb so fern (exponentiell)</translation>
    </message>
    <message>
        <source>v(s) = (s − 10)/10 for the states s = 1 … 19</source>
        <translation>v(s) = (s − 10)/10 für die Zustände s = 1 … 19</translation>
    </message>
    <message>
        <source>w = U[low, high]/n at the start, so that Q lies between low and high</source>
        <translation>w = U[min, max]/n am Anfang, sodass Q zwischen min und max liegt</translation>
    </message>
    <message>
        <source>w ← w + α/n·δ·z for every weight w with trace z, n tilings</source>
        <translation>w ← w + α/n·δ·z für jedes Gewicht w mit Trace z, n Kachelungen</translation>
    </message>
    <message>
        <source>weight: π on Q − w·ρ; filter: among {a: ρ(s, a) ≤ limit}; losses: π on Q⁺ + k·Q⁻</source>
        <translation>Gewicht: π auf Q − w·ρ; Filter: unter {a: ρ(s, a) ≤ Grenze}; Verluste: π auf Q⁺ + k·Q⁻</translation>
    </message>
    <message>
        <source>x_i = exp(−(s − c_i)²/(2σ²)), divided by Σ_i x_i</source>
        <translation>x_i = exp(−(s − c_i)²/(2σ²)), geteilt durch Σ_i x_i</translation>
    </message>
    <message>
        <source>z &lt; cut-off: z ← 0</source>
        <translation>z &lt; Trace-Grenze: z ← 0</translation>
    </message>
    <message>
        <source>z ← γ·λ·z after every step</source>
        <translation>z ← γ·λ·z nach jedem Schritt</translation>
    </message>
    <message>
        <source>z ← γ·λ·z; z ← 1 for what was just visited</source>
        <translation>z ← γ·λ·z; z ← 1 für das eben Besuchte</translation>
    </message>
    <message>
        <source>z ← γλz + (1 − αγλ·zᵀx)x;  w ← w + α(δ + Q − Q_old)z − α(Q − Q_old)x</source>
        <translation>z ← γλz + (1 − αγλ·zᵀx)x;  w ← w + α(δ + Q − Q_alt)z − α(Q − Q_alt)x</translation>
    </message>
    <message>
        <source>|stance angle| &gt; this: fallen</source>
        <translation>|Winkel Standbein| &gt; dies: gestürzt</translation>
    </message>
    <message>
        <source>|stance thigh| &gt; this: doomed to fall</source>
        <translation>|Oberschenkel (Stand)| &gt; dies: Sturz unvermeidlich</translation>
    </message>
    <message>
        <source>|swing angle| &gt; this: fallen</source>
        <translation>|Winkel Schwungbein| &gt; dies: gestürzt</translation>
    </message>
    <message>
        <source>|torso| &gt; this: doomed to fall</source>
        <translation>|Rumpf| &gt; dies: Sturz unvermeidlich</translation>
    </message>
    <message>
        <source>|α| ≤ angle and |α̇| ≤ rate: balanced</source>
        <translation>|α| ≤ Winkel und |α̇| ≤ Drehrate: balanciert</translation>
    </message>
    <message>
        <source>|α| ≥ fall angle: fallen</source>
        <translation>|α| ≥ Sturzwinkel: gestürzt</translation>
    </message>
    <message>
        <source>Δt = time of a step/substeps</source>
        <translation>Δt = Zeit eines Schritts/Teilschritte</translation>
    </message>
    <message>
        <source>Λ ← max(0, Λ + η·(falls − d)) after every episode</source>
        <translation>Λ ← max(0, Λ + η·(Stürze − d)) nach jeder Episode</translation>
    </message>
    <message>
        <source>δ = r + γ·max Q(s′, ·) − Q(s, a); after an action that is not greedy, z ← 0</source>
        <translation>δ = r + γ·max Q(s′, ·) − Q(s, a); nach einer Aktion, die nicht greedy ist, z ← 0</translation>
    </message>
    <message>
        <source>δ ← (1 + κ)·δ if δ &lt; 0, else (1 − κ)·δ</source>
        <translation>δ ← (1 + κ)·δ, wenn δ &lt; 0, sonst (1 − κ)·δ</translation>
    </message>
    <message>
        <source>π among {a: ρ(s, a) ≤ limit}; where there is none, among the least risky</source>
        <translation>π unter {a: ρ(s, a) ≤ Grenze}; gibt es keine, unter den am wenigsten riskanten</translation>
    </message>
    <message>
        <source>π(a outside A⁺) = ε·p/(n − |A⁺|), p the share below</source>
        <translation>π(a außerhalb A⁺) = ε·p/(n − |A⁺|), p der Anteil darunter</translation>
    </message>
    <message>
        <source>π(a) = (1 − ε)·[a is greedy] + ε/n</source>
        <translation>π(a) = (1 − ε)·[a ist greedy] + ε/n</translation>
    </message>
    <message>
        <source>π(a) = (1 − ε)·greedy(a) + ε/n</source>
        <translation>π(a) = (1 − ε)·greedy(a) + ε/n</translation>
    </message>
    <message>
        <source>π(a) = (1 − ε)·greedy(a) + ε·(1 − p)/|A⁺| in A⁺ = {a: Q(s, a) &gt; threshold}, + ε·p/(n − |A⁺|) outside</source>
        <translation>π(a) = (1 − ε)·greedy(a) + ε·(1 − p)/|A⁺| in A⁺ = {a: Q(s, a) &gt; Schwelle}, + ε·p/(n − |A⁺|) außerhalb</translation>
    </message>
    <message>
        <source>π(a) = 1/m for each of the m actions with Q(s, a) = max Q(s, ·), else 0</source>
        <translation>π(a) = 1/m für jede der m Aktionen mit Q(s, a) = max Q(s, ·), sonst 0</translation>
    </message>
    <message>
        <source>π(a) = exp(β·Q(s, a))/Σ_b exp(β·Q(s, b)), β so that Σ π·Q = ln(Σ_b exp(ω·Q(s, b))/n)/ω</source>
        <translation>π(a) = exp(β·Q(s, a))/Σ_b exp(β·Q(s, b)), β so, dass Σ π·Q = ln(Σ_b exp(ω·Q(s, b))/n)/ω</translation>
    </message>
    <message>
        <source>ρ = Pr(fall), a fall k steps later counting γᵏ</source>
        <translation>ρ = Pr(Sturz), ein Sturz k Schritte später zählt γᵏ</translation>
    </message>
    <message>
        <source>ρ ← ρ + α·(target − ρ); target: 1 after a fall, 0 after another end, else γ·ρ(s′, a′)</source>
        <translation>ρ ← ρ + α·(Ziel − ρ); Ziel: 1 nach einem Sturz, 0 nach einem anderen Ende, sonst γ·ρ(s′, a′)</translation>
    </message>
    <message>
        <source>ρ(s, a) = initial where nothing is known</source>
        <translation>ρ(s, a) = Anfangswert, wo nichts bekannt ist</translation>
    </message>
    <message>
        <source>ρ(s, a) &gt; limit</source>
        <translation>ρ(s, a) &gt; Grenze</translation>
    </message>
    <message>
        <source>σ of a Gaussian = width·its own σ</source>
        <translation>σ einer Gauß-Funktion = Breite·eigenes σ</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1: %2 levels</source>
        <translation>%1: %2 Stufen</translation>
    </message>
    <message>
        <source>falls at once: hardly anything to learn from</source>
        <translation>stürzt sofort: kaum etwas zu lernen</translation>
    </message>
    <message>
        <source>falls soon, but not at once: it can learn</source>
        <translation>stürzt bald, aber nicht sofort: kann lernen</translation>
    </message>
    <message>
        <source>its program does not answer</source>
        <translation>das Programm antwortet nicht</translation>
    </message>
    <message>
        <source>never falls: nothing to avoid</source>
        <translation>stürzt nie: nichts zu vermeiden</translation>
    </message>
    <message>
        <source>no ending is a fall</source>
        <translation>kein Ende ist ein Sturz</translation>
    </message>
    <message>
        <source>step limit</source>
        <translation>Schrittgrenze</translation>
    </message>
</context>
<context>
    <name>surefoot::AboutDialog</name>
    <message>
        <source>About Surefoot</source>
        <translation>Über Surefoot</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>The page</source>
        <translation>Die Seite</translation>
    </message>
    <message>
        <source>Copy the versions</source>
        <translation>Versionen kopieren</translation>
    </message>
    <message>
        <source>To the clipboard, for a report of a fault</source>
        <translation>In die Zwischenablage, für eine Fehlermeldung</translation>
    </message>
    <message>
        <source>Surefoot</source>
        <translation>Surefoot</translation>
    </message>
    <message>
        <source># Surefoot %1

Reinforcement learning that avoids falling.

The methods are those of M. van Diepen&apos;s thesis *Avoiding failure states during Reinforcement Learning*, Delft.

Free software under the GNU General Public License, version 3 or later: you may use, study, share and change it. It comes without any warranty.</source>
        <translation># Surefoot %1

Reinforcement Learning, das Stürze vermeidet.

Die Methoden stammen aus der Masterarbeit von M. van Diepen, *Avoiding failure states during Reinforcement Learning*, Delft.

Freie Software unter der GNU General Public License, Version 3 oder später: Sie dürfen sie benutzen, untersuchen, weitergeben und ändern. Sie kommt ohne jede Gewährleistung.</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>Citing</source>
        <translation>Zitieren</translation>
    </message>
    <message>
        <source>Contributing</source>
        <translation>Mitwirken</translation>
    </message>
    <message>
        <source>Security</source>
        <translation>Sicherheit</translation>
    </message>
</context>
<context>
    <name>surefoot::ActionRows</name>
    <message>
        <source>max Q</source>
        <translation>max Q</translation>
    </message>
    <message>
        <source>in force</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>Schwelle %1</translation>
    </message>
    <message>
        <source>risk of the next action %1 %</source>
        <translation>Risiko der nächsten Aktion %1 %</translation>
    </message>
    <message>
        <source>%1 of %2 actions are below the limit of %3 %</source>
        <translation>%1 von %2 Aktionen liegen unter der Grenze von %3 %</translation>
    </message>
    <message>
        <source>%1 and %2 are left out: %3 to %4 in 100 such actions end in a fall.</source>
        <translation>%1 und %2 sind ausgeschlossen: Von 100 solchen Aktionen enden %3 bis %4 im Sturz.</translation>
    </message>
    <message>
        <source>%1 is worth most, but its risk of %2 % counts as −%3.</source>
        <translation>%1 hat den höchsten Wert, aber das Risiko von %2 % zählt als −%3.</translation>
    </message>
    <message>
        <source>All are above the limit: the least risky is taken.</source>
        <translation>Alle liegen über der Grenze: Gewählt wird die mit dem kleinsten Risiko.</translation>
    </message>
    <message>
        <source>All are above the limit: only the best is taken.</source>
        <translation>Alle liegen über der Grenze: Gewählt wird nur die beste.</translation>
    </message>
    <message>
        <source>%1 is worth most, but %2 in 100 such actions end in a fall.</source>
        <translation>%1 hat den höchsten Wert, aber von 100 solchen Aktionen enden %2 im Sturz.</translation>
    </message>
    <message>
        <source>%1 is worth nearly as much as the best, but %2 in 100 such actions end in a fall.</source>
        <translation>%1 ist fast so viel wert wie die beste, aber von 100 solchen Aktionen enden %2 im Sturz.</translation>
    </message>
    <message>
        <source>%1 is left out: %2 in 100 such actions end in a fall.</source>
        <translation>%1 ist ausgeschlossen: Von 100 solchen Aktionen enden %2 im Sturz.</translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risiko</translation>
    </message>
    <message>
        <source>limit %1 %</source>
        <translation>Grenze %1 %</translation>
    </message>
</context>
<context>
    <name>surefoot::Autosave</name>
    <message>
        <source>%1 cannot be made.</source>
        <translation>%1 lässt sich nicht anlegen.</translation>
    </message>
</context>
<context>
    <name>surefoot::ChoiceBox</name>
    <message>
        <source>Find the mistake</source>
        <translation>Fehler finden</translation>
    </message>
    <message>
        <source>Your answer</source>
        <translation>Ihre Antwort</translation>
    </message>
    <message>
        <source>because … one sentence, your own words</source>
        <translation>weil … ein Satz, in Ihren Worten</translation>
    </message>
    <message>
        <source>Because</source>
        <translation>Weil</translation>
    </message>
    <message>
        <source>Choose one first.</source>
        <translation>Erst etwas wählen.</translation>
    </message>
</context>
<context>
    <name>surefoot::ClaimsTable</name>
    <message>
        <source>Claims of the thesis</source>
        <translation>Aussagen der Masterarbeit</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Claim of the thesis</source>
        <translation>Aussage der Masterarbeit</translation>
    </message>
    <message>
        <source>Thesis</source>
        <translation>Masterarb.</translation>
    </message>
    <message>
        <source>Ours (95 % interval)</source>
        <translation>Hier (95-%-Intervall)</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>The claim&apos;s number in the recipe and in RESULTS.md: a letter for the topic, counted within it</source>
        <translation>Nummer der Aussage im Rezept und in RESULTS.md: ein Buchstabe für das Thema und eine laufende Zahl</translation>
    </message>
    <message>
        <source>, p %1</source>
        <translation>, p %1</translation>
    </message>
    <message>
        <source>not significant (p ≥ .01)</source>
        <translation>nicht signifikant (p ≥ 0,01)</translation>
    </message>
</context>
<context>
    <name>surefoot::CompareBox</name>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>One cannot tell from these lives</source>
        <translation>Aus diesen Leben nicht zu entscheiden</translation>
    </message>
    <message>
        <source>The lives are still being lived.</source>
        <translation>Die Leben laufen noch.</translation>
    </message>
    <message>
        <source>Choose one first.</source>
        <translation>Erst etwas wählen.</translation>
    </message>
</context>
<context>
    <name>surefoot::CompareStrip</name>
    <message>
        <source>began with an empty table</source>
        <translation>Beginn: leere Tabelle</translation>
    </message>
    <message>
        <source>began %1</source>
        <translation>Beginn: %1</translation>
    </message>
    <message>
        <source>Learning rule of the second</source>
        <translation>Lernregel des zweiten Lerners</translation>
    </message>
    <message>
        <source>Policy of the second</source>
        <translation>Policy des zweiten Lerners</translation>
    </message>
    <message>
        <source>Start of the second</source>
        <translation>Start des zweiten Lerners</translation>
    </message>
    <message>
        <source>Parameters …</source>
        <translation>Parameter …</translation>
    </message>
    <message>
        <source>Falls of both</source>
        <translation>Stürze beider Lerner</translation>
    </message>
    <message>
        <source>Parameters of the second</source>
        <translation>Parameter des zweiten Lerners</translation>
    </message>
    <message>
        <source>What is changed there holds for the second only</source>
        <translation>Änderungen dort gelten nur für den zweiten Lerner</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erster</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Zweiter</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>same start</source>
        <translation>gleicher Start</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>a file …</source>
        <translation>eine Datei …</translation>
    </message>
    <message>
        <source>What the second begins with</source>
        <translation>Womit der zweite Lerner beginnt</translation>
    </message>
    <message>
        <source>Q-functions (*.safetensors *.surefoot);;All files (*)</source>
        <translation>Q-Funktionen (*.safetensors *.surefoot);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The second has not finished an episode yet.</source>
        <translation>Der zweite Lerner hat noch keine Episode beendet.</translation>
    </message>
    <message>
        <source>No episode has ended in both yet.</source>
        <translation>Noch haben nicht beide eine Episode beendet.</translation>
    </message>
    <message>
        <source>after %1 %2 : %3</source>
        <translation>nach %1 %2 : %3</translation>
    </message>
    <message>
        <source>; after %1 min %2 : %3</source>
        <translation>; nach %1 min %2 : %3</translation>
    </message>
    <message>
        <source>%1; its own: %2</source>
        <translation>%1; eigene: %2</translation>
    </message>
</context>
<context>
    <name>surefoot::ConditionForm</name>
    <message>
        <source>Name of the condition</source>
        <translation>Name der Bedingung</translation>
    </message>
    <message>
        <source>Length of a life</source>
        <translation>Länge eines Lebens</translation>
    </message>
    <message>
        <source>Average reward that ends the pre-learning</source>
        <translation>Mittlere Belohnung, die das Vorlernen beendet</translation>
    </message>
    <message>
        <source>Q-functions in the pool</source>
        <translation>Q-Funktionen im Pool</translation>
    </message>
    <message>
        <source>Environment of the condition</source>
        <translation>Umgebung der Bedingung</translation>
    </message>
    <message>
        <source>Scenario of the condition</source>
        <translation>Szenario der Bedingung</translation>
    </message>
    <message>
        <source>Learning rule of the condition</source>
        <translation>Lernregel der Bedingung</translation>
    </message>
    <message>
        <source>Representation of the condition</source>
        <translation>Repräsentation der Bedingung</translation>
    </message>
    <message>
        <source>Policy of the condition</source>
        <translation>Policy der Bedingung</translation>
    </message>
    <message>
        <source>Pre-learning of the condition</source>
        <translation>Vorlernen der Bedingung</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Learning rule</source>
        <translation>Lernregel</translation>
    </message>
    <message>
        <source>Representation</source>
        <translation>Repräsentation</translation>
    </message>
    <message>
        <source>Policy</source>
        <translation>Policy</translation>
    </message>
    <message>
        <source>Parameter %1 to set</source>
        <translation>Zu setzender Parameter %1</translation>
    </message>
    <message>
        <source>Values of parameter %1</source>
        <translation>Werte von Parameter %1</translation>
    </message>
    <message>
        <source>one, or several: 0; 50; 100</source>
        <translation>einer oder mehrere: 0; 50; 100</translation>
    </message>
    <message>
        <source>Set or vary</source>
        <translation>Setzen/variieren</translation>
    </message>
    <message>
        <source>and</source>
        <translation>und</translation>
    </message>
    <message>
        <source>made from policy and values</source>
        <translation>aus Policy und Werten gebildet</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>A life [episodes]</source>
        <translation>Ein Leben [Episoden]</translation>
    </message>
    <message>
        <source>A life [min]</source>
        <translation>Ein Leben [min]</translation>
    </message>
    <message>
        <source>Pre-learned on</source>
        <translation>Vorgelernt auf</translation>
    </message>
    <message>
        <source>until reward</source>
        <translation>bis Belohnung</translation>
    </message>
    <message>
        <source>Q-functions</source>
        <translation>Q-Funktionen</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
</context>
<context>
    <name>surefoot::ConditionList</name>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>pairs of Q-functions, p &lt; .01</source>
        <translation>Paare von Q-Funktionen, p &lt; 0,01</translation>
    </message>
    <message>
        <source>%1 Q-functions, p &lt; .01</source>
        <translation>%1 Q-Funktionen, p &lt; 0,01</translation>
    </message>
    <message>
        <source>pairs of lives, p &lt; .01</source>
        <translation>Paare von Leben, p &lt; 0,01</translation>
    </message>
    <message>
        <source>one-way ANOVA, p &lt; .01</source>
        <translation>einfaktorielle ANOVA, p &lt; 0,01</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Pre-learning</source>
        <translation>Vorlernen</translation>
    </message>
    <message>
        <source>scenario %1, to %2</source>
        <translation>Szenario %1, bis %2</translation>
    </message>
    <message>
        <source>scenario %1, %2 min</source>
        <translation>Szenario %1, %2 min</translation>
    </message>
    <message>
        <source>Q-functions</source>
        <translation>Q-Funktionen</translation>
    </message>
    <message>
        <source>one a life</source>
        <translation>eine je Leben</translation>
    </message>
    <message>
        <source>A life</source>
        <translation>Ein Leben</translation>
    </message>
    <message>
        <source>%1 simulated min</source>
        <translation>%1 min simuliert</translation>
    </message>
    <message>
        <source>Lives</source>
        <translation>Leben</translation>
    </message>
    <message>
        <source>%1 a condition</source>
        <translation>%1 je Bedingung</translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation>Seeds</translation>
    </message>
    <message>
        <source>paired, from %1</source>
        <translation>gepaart, ab %1</translation>
    </message>
    <message>
        <source>independent, from %1</source>
        <translation>unabhängig, ab %1</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Lives grow</source>
        <translation>Anzahl wächst</translation>
    </message>
    <message>
        <source>until it is decided</source>
        <translation>bis es entschieden ist</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>Conditions appear here. Choose a plan above, or open one.</source>
        <translation>Hier erscheinen Bedingungen. Wählen Sie oben einen Plan oder öffnen Sie einen.</translation>
    </message>
    <message>
        <source>DESIGN</source>
        <translation>DESIGN</translation>
    </message>
</context>
<context>
    <name>surefoot::CrashDialog</name>
    <message>
        <source>Report of the last crash</source>
        <translation>Bericht über den letzten Absturz</translation>
    </message>
    <message>
        <source>Versions, the life&apos;s parameters and the last commands; no names of files. Nothing is sent. You can send it to the maintainers yourself, with what you did last: it helps.</source>
        <translation>Versionen, die Parameter des Lebens und die letzten Befehle; keine Dateinamen. Nichts wird gesendet. Sie können den Bericht selbst an die Betreuer des Programms schicken, mit dem, was Sie zuletzt getan haben: Das hilft.</translation>
    </message>
    <message>
        <source>The report</source>
        <translation>Der Bericht</translation>
    </message>
    <message>
        <source>It lies in %1.</source>
        <translation>Er liegt in %1.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>To the clipboard</source>
        <translation>In die Zwischenablage</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Löschen</translation>
    </message>
</context>
<context>
    <name>surefoot::CurveNames</name>
    <message>
        <source>from nothing</source>
        <translation>von null an</translation>
    </message>
    <message>
        <source>learned before</source>
        <translation>vorgelernt</translation>
    </message>
</context>
<context>
    <name>surefoot::Experiment</name>
    <message>
        <source>Appears with the first lives.</source>
        <translation>Erscheint mit den ersten Leben.</translation>
    </message>
    <message>
        <source>Choose a plan, and run it.</source>
        <translation>Einen Plan wählen und starten.</translation>
    </message>
    <message>
        <source>Appears when the plan runs.</source>
        <translation>Erscheint, wenn der Plan läuft.</translation>
    </message>
    <message>
        <source>it is being read …</source>
        <translation>wird gelesen …</translation>
    </message>
    <message>
        <source>all lives are there</source>
        <translation>alle Leben sind da</translation>
    </message>
    <message>
        <source>it is being written</source>
        <translation>wird gerade geschrieben</translation>
    </message>
    <message>
        <source>no process writes it now</source>
        <translation>zurzeit schreibt kein Prozess daran</translation>
    </message>
    <message>
        <source>no life is over yet</source>
        <translation>noch kein Leben beendet</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>last change %1</source>
        <translation>letzte Änderung %1</translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation>noch etwa %1</translation>
    </message>
    <message>
        <source>%1 is followed, read only; stop following first.</source>
        <translation>Bei %1 wird nur mitgelesen; beenden Sie erst das Mitlesen.</translation>
    </message>
    <message>
        <source>What these results had in hand is still being kept; run them again in a moment.</source>
        <translation>Die letzten Ergebnisse werden noch gesichert; starten Sie gleich noch einmal.</translation>
    </message>
    <message>
        <source>The results have no place: %1 cannot be made.</source>
        <translation>Die Ergebnisse lassen sich nicht ablegen: %1 kann nicht angelegt werden.</translation>
    </message>
</context>
<context>
    <name>surefoot::ExperimentPage</name>
    <message>
        <source>Stop following</source>
        <translation>Mitlesen beenden</translation>
    </message>
    <message>
        <source>The results stay, as if the store had been opened</source>
        <translation>Die Ergebnisse bleiben, als wäre die Datei geöffnet worden</translation>
    </message>
    <message>
        <source>The results are kept. They stand in the list of experiments, and here: %1</source>
        <translation>Die Ergebnisse bleiben erhalten. Sie stehen in der Liste der Experimente und hier: %1</translation>
    </message>
    <message>
        <source>What was lived so far is kept and can be gone on with. It stands in the list of experiments, and here: %1</source>
        <translation>Das Bisherige bleibt erhalten und lässt sich fortsetzen. Es steht in der Liste der Experimente und hier: %1</translation>
    </message>
    <message>
        <source>%1 (%2 of %3 lives)</source>
        <translation>%1 (%2 von %3 Leben)</translation>
    </message>
    <message>
        <source>Run the experiment</source>
        <translation>Experiment starten</translation>
    </message>
    <message>
        <source>Start again: forget what was lived</source>
        <translation>Neu beginnen: alle bisherigen Leben verwerfen</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Experiment</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>LaTeX</source>
        <translation>LaTeX</translation>
    </message>
    <message>
        <source>Copy the table as CSV</source>
        <translation>Tabelle als CSV kopieren</translation>
    </message>
    <message>
        <source>Copy the table as LaTeX</source>
        <translation>Tabelle als LaTeX kopieren</translation>
    </message>
    <message>
        <source>Copy as</source>
        <translation>Kopieren als</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>lives done</source>
        <translation>fertige Leben</translation>
    </message>
    <message>
        <source>Edit the plan</source>
        <translation>Plan bearbeiten</translation>
    </message>
    <message>
        <source>Following %1, read only</source>
        <translation>Nur mitgelesen: %1</translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation>Ergebnisse zeigen</translation>
    </message>
    <message>
        <source>Go on all the same</source>
        <translation>Trotzdem fortfahren</translation>
    </message>
    <message>
        <source>Allow it, and go on</source>
        <translation>Erlauben und fortfahren</translation>
    </message>
    <message>
        <source>Pause: lives stand still where they are</source>
        <translation>Pause: Die Leben bleiben stehen, wo sie sind</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>, and %1 in lives that are not over</source>
        <translation>, dazu %1 in Leben, die noch laufen</translation>
    </message>
    <message>
        <source>Open a plan or results</source>
        <translation>Plan oder Ergebnisse öffnen</translation>
    </message>
    <message>
        <source>Plans and results (*.toml *.sqlite);;All files (*)</source>
        <translation>Pläne und Ergebnisse (*.toml *.sqlite);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the plan</source>
        <translation>Plan speichern</translation>
    </message>
    <message>
        <source>Plans (*.toml)</source>
        <translation>Pläne (*.toml)</translation>
    </message>
    <message>
        <source>The plan is in %1.</source>
        <translation>Der Plan ist in %1.</translation>
    </message>
    <message>
        <source>There is nothing to copy yet; run the experiment first.</source>
        <translation>Es gibt noch nichts zu kopieren; starten Sie erst das Experiment.</translation>
    </message>
    <message>
        <source>The table is on the clipboard, as CSV.</source>
        <translation>Die Tabelle ist in der Zwischenablage, als CSV.</translation>
    </message>
    <message>
        <source>The table is on the clipboard, as LaTeX.</source>
        <translation>Die Tabelle ist in der Zwischenablage, als LaTeX.</translation>
    </message>
    <message>
        <source>Results can be exported when the experiment is complete or paused.</source>
        <translation>Ergebnisse lassen sich exportieren, wenn das Experiment fertig oder angehalten ist.</translation>
    </message>
    <message>
        <source>Folder for the tables</source>
        <translation>Ordner für die Tabellen</translation>
    </message>
    <message>
        <source>Writing the tables</source>
        <translation>Tabellen werden geschrieben</translation>
    </message>
    <message>
        <source>conditions.csv, lives.csv and episodes.csv are in %1.</source>
        <translation>conditions.csv, lives.csv und episodes.csv sind in %1.</translation>
    </message>
    <message>
        <source>There is no chart yet; run the experiment first.</source>
        <translation>Es gibt noch kein Diagramm; starten Sie erst das Experiment.</translation>
    </message>
    <message>
        <source>Folder for the charts</source>
        <translation>Ordner für die Diagramme</translation>
    </message>
    <message>
        <source>Drawing the charts</source>
        <translation>Diagramme werden gezeichnet</translation>
    </message>
    <message>
        <source>Every chart is in %1, as PNG, SVG, PDF and CSV.</source>
        <translation>Alle Diagramme sind in %1, als PNG, SVG, PDF und CSV.</translation>
    </message>
    <message>
        <source>Something is being written; wait for its end.</source>
        <translation>Es wird gerade geschrieben; warten Sie das Ende ab.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>It was cancelled; what was written before is there.</source>
        <translation>Abgebrochen; was vorher geschrieben wurde, ist da.</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>The thesis&apos;s claims</source>
        <translation>Aussagen der Masterarbeit</translation>
    </message>
    <message>
        <source>falls during learning, against the reference of each condition</source>
        <translation>Stürze beim Lernen, gegenüber der Referenz jeder Bedingung</translation>
    </message>
    <message>
        <source>what the thesis claims, and what came out here</source>
        <translation>was die Masterarbeit aussagt und was hier herauskam</translation>
    </message>
    <message>
        <source>so far · %1</source>
        <translation>bisher · %1</translation>
    </message>
    <message>
        <source>The conditions</source>
        <translation>Die Bedingungen</translation>
    </message>
    <message>
        <source> (95 % interval %1 to %2 %)</source>
        <translation> (95-%-Intervall %1 bis %2 %)</translation>
    </message>
    <message>
        <source>It is being opened …</source>
        <translation>Wird geöffnet …</translation>
    </message>
    <message>
        <source>The finding in one sentence appears here.</source>
        <translation>Hier erscheint das Ergebnis in einem Satz.</translation>
    </message>
    <message>
        <source>No condition falls significantly less than its reference (p &amp;lt; .01).</source>
        <translation>Keine Bedingung stürzt signifikant seltener als ihre Referenz (p &amp;lt; 0,01).</translation>
    </message>
    <message>
        <source>So far no condition falls significantly less than its reference (p &amp;lt; .01).</source>
        <translation>Bisher stürzt keine Bedingung signifikant seltener als ihre Referenz (p &amp;lt; 0,01).</translation>
    </message>
    <message numerus="yes">
        <source>So far (%1 of %2 lives) </source>
        <translation>
            <numerusform>Bisher (%1 von %2 Leben): </numerusform>
            <numerusform>Bisher (%1 von %2 Leben): </numerusform>
        </translation>
    </message>
    <message>
        <source>%1&lt;b&gt;%2 falls %3 % less than %4&lt;/b&gt;%5.</source>
        <translation>%1&lt;b&gt;%2 stürzt um %3 % seltener als %4&lt;/b&gt;%5.</translation>
    </message>
    <message>
        <source> The thesis reports %1.</source>
        <translation> Die Masterarbeit berichtet %1.</translation>
    </message>
    <message>
        <source> Q-functions carry %1 % of the variance.</source>
        <translation> Auf die Q-Funktionen entfallen %1 % der Varianz.</translation>
    </message>
    <message>
        <source>Lives a condition</source>
        <translation>Leben je Bedingung</translation>
    </message>
    <message>
        <source>How many lives each condition lives; more make intervals narrower. Another number begins again, what was lived is kept.</source>
        <translation>Zahl der Leben je Bedingung; mehr machen die Intervalle schmaler. Eine andere Zahl beginnt neu, die bisherigen Leben bleiben erhalten.</translation>
    </message>
    <message>
        <source> lives</source>
        <translation> Leben</translation>
    </message>
    <message>
        <source>a search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>until decided</source>
        <translation>bis entschieden</translation>
    </message>
    <message>
        <source>The plan has edits that are not used yet, so the number of lives is written there; Use this plan takes all of it.</source>
        <translation>Der Plan hat Änderungen, die noch nicht verwendet werden; die Zahl der Leben steht darum dort. „Plan verwenden“ übernimmt alles.</translation>
    </message>
</context>
<context>
    <name>surefoot::ExperimentProgress</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 lives</source>
        <translation>
            <numerusform>%1 von %2 Leben</numerusform>
            <numerusform>%1 von %2 Leben</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>elapsed %1</source>
        <translation>vergangen: %1</translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation>noch etwa %1</translation>
    </message>
    <message>
        <source>it is being opened …</source>
        <translation>wird geöffnet …</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>takes about %1</source>
        <translation>dauert etwa %1</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>followed, read only</source>
        <translation>nur mitgelesen</translation>
    </message>
</context>
<context>
    <name>surefoot::FallsList</name>
    <message>
        <source>The next falls appear here.
Those before were not recorded in this window.</source>
        <translation>Hier erscheinen die nächsten Stürze.
Frühere wurden in diesem Fenster nicht aufgezeichnet.</translation>
    </message>
    <message>
        <source>Falls appear here. None so far.</source>
        <translation>Hier erscheinen Stürze. Bisher keine.</translation>
    </message>
</context>
<context>
    <name>surefoot::FigurePanel</name>
    <message>
        <source>Figure</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>Another figure</source>
        <translation>Anderes Diagramm</translation>
    </message>
    <message>
        <source>mean and 95 % interval</source>
        <translation>Mittel und 95-%-Intervall</translation>
    </message>
    <message>
        <source>mean and 95 % band</source>
        <translation>Mittel und 95-%-Band</translation>
    </message>
    <message>
        <source>so far · %1</source>
        <translation>bisher · %1</translation>
    </message>
    <message>
        <source>It is being drawn.</source>
        <translation>Wird gezeichnet.</translation>
    </message>
</context>
<context>
    <name>surefoot::FigureView</name>
    <message>
        <source>Bars that have no room</source>
        <translation>Balken ohne Platz</translation>
    </message>
    <message>
        <source>All of the time axis	Home</source>
        <translation>Ganze Zeitachse	Pos1</translation>
    </message>
</context>
<context>
    <name>surefoot::FilmDialog</name>
    <message numerus="yes">
        <source>%1 pictures</source>
        <translation>
            <numerusform>%1 Bild</numerusform>
            <numerusform>%1 Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>the last minutes</source>
        <translation>die letzten Minuten</translation>
    </message>
    <message>
        <source>What is filmed</source>
        <translation>Was gefilmt wird</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Film from</source>
        <translation>Film ab</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Film up to</source>
        <translation>Film bis</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Speed of the film</source>
        <translation>Tempo des Films</translation>
    </message>
    <message>
        <source>as it was</source>
        <translation>wie es war</translation>
    </message>
    <message>
        <source>half</source>
        <translation>halb</translation>
    </message>
    <message>
        <source>a quarter</source>
        <translation>ein Viertel</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Width of the film</source>
        <translation>Breite des Films</translation>
    </message>
    <message>
        <source>Height of the film</source>
        <translation>Höhe des Films</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Colours of the film</source>
        <translation>Farben des Films</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>below the picture</source>
        <translation>unter dem Bild</translation>
    </message>
    <message>
        <source>Signals below the picture</source>
        <translation>Signale unter dem Bild</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Progress of the film</source>
        <translation>Fortschritt des Films</translation>
    </message>
    <message>
        <source>Make the film …</source>
        <translation>Film erstellen …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The strips of the Signals layout, with a cursor that goes along</source>
        <translation>Die Streifen des Layouts Signale, mit einem Zeiger, der mitläuft</translation>
    </message>
    <message>
        <source>None were written down: they are while the Signals layout is shown</source>
        <translation>Keine aufgezeichnet: Das geschieht nur, solange das Layout Signale gezeigt wird</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>%1 of %2 pictures. The life goes on meanwhile.</source>
        <translation>%1 von %2 Bildern. Das Leben geht inzwischen weiter.</translation>
    </message>
    <message>
        <source>There is nothing to film yet: nothing has moved in the window.</source>
        <translation>Es gibt noch nichts zu filmen: Im Fenster hat sich nichts bewegt.</translation>
    </message>
    <message>
        <source>A film ends after it begins.</source>
        <translation>Ein Film endet nach seinem Beginn.</translation>
    </message>
    <message>
        <source>A film of %1 s, in %2.%3</source>
        <translation>Film von %1 s: %2.%3</translation>
    </message>
    <message>
        <source> WebP only: all others are made by the program ffmpeg, which is not installed.</source>
        <translation> Nur WebP: Alle anderen erstellt das Programm ffmpeg, und das ist nicht installiert.</translation>
    </message>
    <message>
        <source>Make the film</source>
        <translation>Film erstellen</translation>
    </message>
    <message>
        <source>The film is in %1 (%2).</source>
        <translation>Der Film ist in %1 (%2).</translation>
    </message>
</context>
<context>
    <name>surefoot::FindingsTable</name>
    <message>
        <source>%1 falls</source>
        <translation>%1 Stürze</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Lives</source>
        <translation>Leben</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>± (95 %)</source>
        <translation>± (95 %)</translation>
    </message>
    <message>
        <source>Change %</source>
        <translation>Änd. %</translation>
    </message>
    <message>
        <source>% (95 % interval)</source>
        <translation>% (95-%-Intervall)</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message>
        <source>p Holm</source>
        <translation>p Holm</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Time min</source>
        <translation>Zeit min</translation>
    </message>
    <message>
        <source>Expl. %</source>
        <translation>Expl. %</translation>
    </message>
    <message>
        <source>End %</source>
        <translation>Ende %</translation>
    </message>
    <message>
        <source>Thesis</source>
        <translation>Masterarb.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>pre(3): its lives began with what was learned on scenario 3</source>
        <translation>pre(3): Die Leben begannen mit dem auf Szenario 3 Gelernten</translation>
    </message>
    <message>
        <source>Half of the 95 % interval of the mean, in falls</source>
        <translation>Halbes 95-%-Intervall des Mittels, in Stürzen</translation>
    </message>
    <message>
        <source>Of the falls, against the reference</source>
        <translation>Änderung der Stürze gegenüber der Referenz</translation>
    </message>
    <message>
        <source>The 95 % interval of the change, in per cent</source>
        <translation>95-%-Intervall der Änderung, in Prozent</translation>
    </message>
    <message>
        <source>This condition against its reference: by pairs of lives or Q-functions where both have the same, by the Q-functions where lives share them, else the one-way analysis of variance of the lives</source>
        <translation>Diese Bedingung gegen ihre Referenz: über Paare von Leben oder Q-Funktionen, wo beide dieselben haben, über die Q-Funktionen, wo sich Leben diese teilen, sonst die einfaktorielle Varianzanalyse der Leben</translation>
    </message>
    <message>
        <source>The same, corrected for all comparisons with this reference (Holm 1979)</source>
        <translation>Dasselbe, korrigiert für alle Vergleiche mit dieser Referenz (Holm 1979)</translation>
    </message>
    <message>
        <source>X: differs from the reference with p &lt; .01</source>
        <translation>X: weicht von der Referenz ab, p &lt; 0,01</translation>
    </message>
    <message>
        <source>Simulated minutes until the end of learning; – for a task without a clock</source>
        <translation>Simulierte Minuten bis zum Ende des Lernens; – bei einer Aufgabe ohne Uhr</translation>
    </message>
    <message>
        <source>Share of actions that were not the best by the values at that moment: who explores less falls less</source>
        <translation>Anteil der Aktionen, die nach den Werten dieses Augenblicks nicht die besten waren: Wer weniger exploriert, stürzt seltener</translation>
    </message>
    <message>
        <source>Of 100 episodes of the greedy policy at the end of a life, when nothing is learned any more, how many fall</source>
        <translation>Wie viele von 100 Episoden der Greedy-Policy am Ende eines Lebens, wenn nichts mehr gelernt wird, im Sturz enden</translation>
    </message>
    <message>
        <source>The condition of the chosen row stands out in the figures; Escape lets go</source>
        <translation>Die Bedingung der gewählten Zeile ist in den Diagrammen hervorgehoben; Esc hebt das auf</translation>
    </message>
    <message>
        <source>%1 (reference)</source>
        <translation>%1 (Referenz)</translation>
    </message>
    <message>
        <source>So far: not all lives of this condition, or of what it is compared with</source>
        <translation>Bisher: noch nicht alle Leben dieser Bedingung oder derjenigen, mit der sie verglichen wird</translation>
    </message>
    <message>
        <source>✕ so far</source>
        <translation>✕ bisher</translation>
    </message>
    <message>
        <source>%1 so far</source>
        <translation>%1, bisher</translation>
    </message>
    <message>
        <source>Claims %1 of the thesis; all of them stand under &quot;The thesis&apos;s claims&quot;</source>
        <translation>Aussagen %1 der Masterarbeit; alle stehen unter „Aussagen der Masterarbeit“</translation>
    </message>
</context>
<context>
    <name>surefoot::Following</name>
    <message>
        <source> What it held before is shown.</source>
        <translation> Gezeigt wird der vorige Inhalt.</translation>
    </message>
    <message>
        <source>It is gone.</source>
        <translation>Die Datei ist weg.</translation>
    </message>
    <message>
        <source>It is not there yet; this page waits for it.</source>
        <translation>Die Datei ist noch nicht da; diese Seite wartet darauf.</translation>
    </message>
</context>
<context>
    <name>surefoot::HandbookBrowser</name>
    <message>
        <source>Page of the handbook</source>
        <translation>Seite des Handbuchs</translation>
    </message>
</context>
<context>
    <name>surefoot::HandbookContents</name>
    <message>
        <source>No page has all of these words.</source>
        <translation>Keine Seite enthält alle diese Wörter.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the handbook</source>
        <translation>Handbuch durchsuchen</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
</context>
<context>
    <name>surefoot::HandbookWindow</name>
    <message>
        <source>Handbook</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>‹ Back</source>
        <translation>‹ Zurück</translation>
    </message>
    <message>
        <source>The page before (Alt+←)</source>
        <translation>Vorige Seite (Alt+←)</translation>
    </message>
    <message>
        <source>Forward ›</source>
        <translation>Vor ›</translation>
    </message>
    <message>
        <source>The page after (Alt+→)</source>
        <translation>Nächste Seite (Alt+→)</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Finden</translation>
    </message>
    <message>
        <source>A word on this page (Ctrl+F)</source>
        <translation>Ein Wort auf dieser Seite (Strg+F)</translation>
    </message>
    <message>
        <source>Find; Return: the next one, Escape: done</source>
        <translation>Suchen; Enter: nächste Stelle, Esc: fertig</translation>
    </message>
    <message>
        <source>Find on this page</source>
        <translation>Auf dieser Seite suchen</translation>
    </message>
    <message>
        <source>It does not stand on this page.</source>
        <translation>Das steht nicht auf dieser Seite.</translation>
    </message>
</context>
<context>
    <name>surefoot::Handout</name>
    <message>
        <source>%1 minutes, level %2 of 3</source>
        <translation>%1 Minuten, Stufe %2 von 3</translation>
    </message>
    <message>
        <source>Name _______________________________   Date ______________</source>
        <translation>Name _______________________________   Datum ______________</translation>
    </message>
    <message>
        <source>For the teacher: %1</source>
        <translation>Für die Lehrkraft: %1</translation>
    </message>
    <message>
        <source>You know now: %1</source>
        <translation>Sie wissen jetzt: %1</translation>
    </message>
    <message>
        <source>To discuss: %1</source>
        <translation>Zur Diskussion: %1</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>I set: ____________________   It came to: ____________</source>
        <translation>Ich stelle ein: ____________________   Ergebnis: ____________</translation>
    </message>
    <message>
        <source>Hint: %1</source>
        <translation>Tipp: %1</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>etwa %1 min</translation>
    </message>
    <message>
        <source>I say: ____________ %1 (%2 to %3). It came to: ____________</source>
        <translation>Ich sage: ____________ %1 (%2 bis %3). Ergebnis: ____________</translation>
    </message>
    <message>
        <source>It comes to %1.</source>
        <translation>Das Ergebnis: %1.</translation>
    </message>
    <message>
        <source>because</source>
        <translation>weil</translation>
    </message>
    <message>
        <source>____________ %1</source>
        <translation>____________ %1</translation>
    </message>
</context>
<context>
    <name>surefoot::HelpButton</name>
    <message>
        <source>%1, in the handbook</source>
        <translation>%1, im Handbuch</translation>
    </message>
</context>
<context>
    <name>surefoot::History</name>
    <message>
        <source>the new life</source>
        <translation>neues Leben</translation>
    </message>
</context>
<context>
    <name>surefoot::KioskFoot</name>
    <message>
        <source>How much they explore</source>
        <translation>Wie viel sie ausprobieren</translation>
    </message>
    <message>
        <source>in 100 steps both try something else than the best</source>
        <translation>in 100 Schritten probieren beide etwas anderes als das Beste</translation>
    </message>
    <message>
        <source>of 100</source>
        <translation>von 100</translation>
    </message>
    <message>
        <source>the lesson&apos;s word</source>
        <translation>das Wort der Lektion</translation>
    </message>
    <message>
        <source>The lesson&apos;s word</source>
        <translation>Das Wort der Lektion</translation>
    </message>
    <message>
        <source>What you see</source>
        <translation>Was Sie sehen</translation>
    </message>
</context>
<context>
    <name>surefoot::KioskRobot</name>
    <message>
        <source>Touch the pole</source>
        <translation>Stab antippen</translation>
    </message>
    <message>
        <source>both get the same push</source>
        <translation>beide bekommen denselben Stoß</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>World of %1</source>
        <translation>Welt von %1</translation>
    </message>
</context>
<context>
    <name>surefoot::KioskWindow</name>
    <message>
        <source>ε-greedy</source>
        <translation>ε-greedy</translation>
    </message>
    <message>
        <source>tries anything</source>
        <translation>probiert alles</translation>
    </message>
    <message>
        <source>Softmax</source>
        <translation>Softmax</translation>
    </message>
    <message>
        <source>tries what is nearly as good</source>
        <translation>probiert, was fast so gut ist</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>by itself in %1 s</source>
        <translation>von selbst in %1 s</translation>
    </message>
    <message>
        <source>ε-greedy %1 falls, Softmax %2 falls</source>
        <translation>ε-greedy: %1 Stürze, Softmax: %2 Stürze</translation>
    </message>
    <message>
        <source>It is being made ready …</source>
        <translation>Wird vorbereitet …</translation>
    </message>
    <message>
        <source>ε = %1 against τ = %2, %3 episodes each</source>
        <translation>ε = %1 gegen τ = %2, je %3 Episoden</translation>
    </message>
    <message>
        <source>After %1 episodes: %2 falls against %3.</source>
        <translation>Nach %1 Episoden: %2 Stürze gegen %3.</translation>
    </message>
    <message>
        <source>Now neither tries anything: both always take what they think is best.</source>
        <translation>Jetzt probiert keiner etwas: Beide tun stets, was sie für das Beste halten.</translation>
    </message>
</context>
<context>
    <name>surefoot::KnobRows</name>
    <message>
        <source>Policy</source>
        <translation>Policy</translation>
    </message>
    <message>
        <source>Learning rule</source>
        <translation>Lernregel</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
</context>
<context>
    <name>surefoot::LearningChart</name>
    <message>
        <source>episode %1</source>
        <translation>Episode %1</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
    <message numerus="yes">
        <source>%1 falls</source>
        <translation>
            <numerusform>%1 Sturz</numerusform>
            <numerusform>%1 Stürze</numerusform>
        </translation>
    </message>
    <message>
        <source>Whole life	Home</source>
        <translation>Ganzes Leben	Pos1</translation>
    </message>
    <message>
        <source>While it learned</source>
        <translation>Solange es lernte</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Remove all earlier runs</source>
        <translation>Alle früheren Läufe entfernen</translation>
    </message>
    <message>
        <source>pushed by hand</source>
        <translation>von Hand gestoßen</translation>
    </message>
    <message>
        <source>placed by hand</source>
        <translation>von Hand platziert</translation>
    </message>
    <message>
        <source>gone on from an earlier moment</source>
        <translation>ab einem früheren Augenblick fortgesetzt</translation>
    </message>
    <message>
        <source>end of learning</source>
        <translation>Ende des Lernens</translation>
    </message>
    <message>
        <source>A fall after a person placed or pushed the body. A click replays it.</source>
        <translation>Ein Sturz, nachdem jemand den Körper platziert oder gestoßen hat. Ein Klick spielt ihn ab.</translation>
    </message>
    <message>
        <source>A click replays this fall.</source>
        <translation>Ein Klick spielt diesen Sturz ab.</translation>
    </message>
    <message>
        <source>This fall is no longer kept; it cannot be replayed.</source>
        <translation>Dieser Sturz ist nicht mehr gespeichert und lässt sich nicht abspielen.</translation>
    </message>
    <message>
        <source>Falls appear here. None so far.</source>
        <translation>Hier erscheinen Stürze. Bisher keine.</translation>
    </message>
    <message>
        <source>The average appears with the first episodes.</source>
        <translation>Das Mittel erscheint mit den ersten Episoden.</translation>
    </message>
    <message>
        <source>simulated time [min]</source>
        <translation>simulierte Zeit [min]</translation>
    </message>
    <message>
        <source>episodes</source>
        <translation>Episoden</translation>
    </message>
    <message>
        <source>2nd: %1</source>
        <translation>2.: %1</translation>
    </message>
    <message>
        <source>live: %1</source>
        <translation>live: %1</translation>
    </message>
    <message>
        <source>run %1: %2</source>
        <translation>Lauf %1: %2</translation>
    </message>
    <message>
        <source>00,000 you said</source>
        <translation>00,000 Sie sagten</translation>
    </message>
    <message>
        <source>greedy tests</source>
        <translation>Greedy-Tests</translation>
    </message>
    <message>
        <source>you said</source>
        <translation>Sie sagten</translation>
    </message>
    <message>
        <source>you say</source>
        <translation>Sie sagen</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 mehr</translation>
    </message>
    <message>
        <source>%1 fewer</source>
        <translation>%1 weniger</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonBar</name>
    <message>
        <source>‹  All lessons</source>
        <translation>‹  Alle Lektionen</translation>
    </message>
    <message>
        <source>The list of lessons; this one waits at its step</source>
        <translation>Die Liste der Lektionen; diese wartet bei ihrem Schritt</translation>
    </message>
    <message>
        <source>Teacher</source>
        <translation>Lehrkraft</translation>
    </message>
    <message>
        <source>Notes, answers and the class, in a window for the teacher&apos;s own screen</source>
        <translation>Notizen, Antworten und der Kurs, in einem Fenster für den Bildschirm der Lehrkraft</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Run or pause</source>
        <translation>Start oder Pause</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neustart</translation>
    </message>
    <message>
        <source>Start the life again with the same seed</source>
        <translation>Das Leben mit demselben Seed neu beginnen</translation>
    </message>
    <message>
        <source>Turbo</source>
        <translation>Turbo</translation>
    </message>
    <message>
        <source>Learn flat out</source>
        <translation>Lernen mit Höchsttempo</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>How fast the world runs; real time is in the middle</source>
        <translation>Wie schnell die Welt läuft; in der Mitte ist Echtzeit</translation>
    </message>
    <message>
        <source>How long the robot has lived, by its own clock</source>
        <translation>Wie lange der Roboter gelebt hat, nach seiner eigenen Uhr</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>episodes</source>
        <translation>Episoden</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonColumn</name>
    <message>
        <source>%1 % lived</source>
        <translation>%1 % gelebt</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Tipp</translation>
    </message>
    <message>
        <source>Reset step</source>
        <translation>Schritt von vorn</translation>
    </message>
    <message>
        <source>Explore freely</source>
        <translation>Frei erkunden</translation>
    </message>
    <message>
        <source>A hint, if the step has one (F1)</source>
        <translation>Ein Tipp, wenn der Schritt einen hat (F1)</translation>
    </message>
    <message>
        <source>The step begins again, as it was</source>
        <translation>Der Schritt beginnt noch einmal, wie er war</translation>
    </message>
    <message>
        <source>The Live page with this robot as it is now; the lesson waits here</source>
        <translation>Die Seite Live mit diesem Roboter, wie er jetzt ist; die Lektion wartet hier</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>The step before (Alt+←)</source>
        <translation>Voriger Schritt (Alt+←)</translation>
    </message>
    <message>
        <source>Go on (Alt+→)</source>
        <translation>Weiter (Alt+→)</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Knob</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>Knobs</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
    <message>
        <source>%1 becomes %2</source>
        <translation>%1 wird %2</translation>
    </message>
    <message>
        <source>%1 when you commit</source>
        <translation>%1, sobald Sie sich festlegen</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>The lesson is done. You know now: %1</source>
        <translation>Die Lektion ist fertig. Sie wissen jetzt: %1</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>It is being made ready …</source>
        <translation>Wird vorbereitet …</translation>
    </message>
    <message>
        <source>It is being lived …</source>
        <translation>Das Leben läuft …</translation>
    </message>
    <message>
        <source>The lives are being lived …</source>
        <translation>Die Leben laufen …</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonDetails</name>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 min, level %2</source>
        <translation>%1 min, Stufe %2</translation>
    </message>
    <message>
        <source>Q on a map</source>
        <translation>Q als Karte</translation>
    </message>
    <message>
        <source>actions</source>
        <translation>Aktionen</translation>
    </message>
    <message>
        <source>one step</source>
        <translation>ein Schritt</translation>
    </message>
    <message>
        <source>rule of thumb</source>
        <translation>Faustregel</translation>
    </message>
    <message>
        <source>average reward</source>
        <translation>mittlere Belohnung</translation>
    </message>
    <message>
        <source>list of falls</source>
        <translation>Liste der Stürze</translation>
    </message>
    <message>
        <source>the learning rule</source>
        <translation>die Lernregel</translation>
    </message>
    <message>
        <source>Better after</source>
        <translation>Besser nach</translation>
    </message>
    <message>
        <source>On screen</source>
        <translation>Zu sehen</translation>
    </message>
    <message>
        <source>Knobs</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>See again</source>
        <translation>Wieder ansehen</translation>
    </message>
    <message>
        <source>Continue at step %1</source>
        <translation>Weiter bei Schritt %1</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Explore freely</source>
        <translation>Frei erkunden</translation>
    </message>
    <message>
        <source>The Live page, as the lesson begins</source>
        <translation>Die Seite Live im Anfangszustand der Lektion</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonDriver</name>
    <message>
        <source>Not there. Try another place.</source>
        <translation>Dort nicht. Versuchen Sie eine andere Stelle.</translation>
    </message>
    <message>
        <source>That life is over; restart it and try another way.</source>
        <translation>Dieses Leben ist vorbei; starten Sie es neu und versuchen Sie es anders.</translation>
    </message>
    <message>
        <source>The lesson begins anew: %1</source>
        <translation>Die Lektion beginnt von vorn: %1</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonEditor</name>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Testen</translation>
    </message>
    <message>
        <source>Live through it</source>
        <translation>Durchspielen</translation>
    </message>
    <message>
        <source>All solutions are lived; what does not come out as the text says is told</source>
        <translation>Alle Lösungen werden durchgespielt; gemeldet wird, was anders ausgeht, als der Text sagt</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
    <message>
        <source>It is being lived through …</source>
        <translation>Wird durchgespielt …</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>No errors. “Live through it” tries its solutions.</source>
        <translation>Keine Fehler. „Durchspielen“ testet die Lösungen.</translation>
    </message>
    <message>
        <source>Well: all %1 steps were lived through.</source>
        <translation>Gut: alle %1 Schritte wurden durchgespielt.</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>noch nicht gespeichert</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, geändert</translation>
    </message>
    <message>
        <source>The step under the caret is shown here.</source>
        <translation>Hier steht der Schritt, in dem der Cursor ist.</translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation>Schritt %1: %2</translation>
    </message>
    <message>
        <source>%1; as of the last text without an error</source>
        <translation>%1; Stand des letzten Textes ohne Fehler</translation>
    </message>
    <message>
        <source>Save the lesson</source>
        <translation>Lektion speichern</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonEnd</name>
    <message>
        <source>You know now</source>
        <translation>Sie wissen jetzt</translation>
    </message>
    <message>
        <source>In your words</source>
        <translation>In Ihren Worten</translation>
    </message>
    <message>
        <source>One answer</source>
        <translation>Musterantwort</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Weiter: %1</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonList</name>
    <message>
        <source>%1, it has an error</source>
        <translation>%1, enthält einen Fehler</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>not begun</source>
        <translation>nicht begonnen</translation>
    </message>
    <message>
        <source>Lesson %1 of %2, </source>
        <translation>Lektion %1 von %2, </translation>
    </message>
    <message>
        <source>%1%2, %3 minutes, level %4 of 3, %5</source>
        <translation>%1%2, %3 Minuten, Stufe %4 von 3, %5</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonPanels</name>
    <message>
        <source>World</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>Average reward</source>
        <translation>Mittlere Belohnung</translation>
    </message>
    <message>
        <source>cumulative; each mark is one, click it to replay</source>
        <translation>kumuliert; jede Marke ist ein Sturz, ein Klick spielt ihn ab</translation>
    </message>
    <message>
        <source>last 80 episodes</source>
        <translation>letzte 80 Episoden</translation>
    </message>
    <message>
        <source>What the robot would do now</source>
        <translation>Was der Roboter jetzt täte</translation>
    </message>
    <message>
        <source>% on a square-root scale</source>
        <translation>% auf einer Wurzelskala</translation>
    </message>
    <message>
        <source>Value maps</source>
        <translation>Wertekarten</translation>
    </message>
    <message>
        <source>This step</source>
        <translation>Dieser Schritt</translation>
    </message>
    <message>
        <source>what the last one taught</source>
        <translation>was der letzte lehrte</translation>
    </message>
    <message>
        <source>Rule of thumb</source>
        <translation>Faustregel</translation>
    </message>
    <message>
        <source>TRL&apos;s threshold</source>
        <translation>TRL-Schwelle</translation>
    </message>
    <message>
        <source>List of falls</source>
        <translation>Liste der Stürze</translation>
    </message>
    <message>
        <source>a click shows one again</source>
        <translation>ein Klick zeigt einen noch einmal</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>%1 lives of each</source>
        <translation>je %1 Leben</translation>
    </message>
    <message>
        <source>real time; the learner runs faster</source>
        <translation>Echtzeit; der Lerner läuft schneller</translation>
    </message>
    <message>
        <source>it learns; take hold of it</source>
        <translation>er lernt; greifen Sie zu</translation>
    </message>
    <message>
        <source>what it can do so far; it learns nothing now</source>
        <translation>was er bisher kann; jetzt lernt er nichts</translation>
    </message>
    <message>
        <source>held still</source>
        <translation>steht still</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonRow</name>
    <message>
        <source>minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>it has an error</source>
        <translation>enthält einen Fehler</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonView</name>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>your prediction</source>
        <translation>Ihre Vorhersage</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonsPage</name>
    <message>
        <source>What you do cannot be kept: %1</source>
        <translation>Was Sie tun, lässt sich nicht speichern: %1</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>Seed %1</translation>
    </message>
    <message>
        <source>answers are kept on this computer only</source>
        <translation>Antworten bleiben nur auf diesem Computer</translation>
    </message>
    <message>
        <source>answers of %1 are kept in %2</source>
        <translation>Antworten von %1 werden in %2 gespeichert</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>thirteen, a good two hours in all; a double lesson of 90 minutes is 1, 2, 3, 5, 6, 7, 11, 13</source>
        <translation>dreizehn, insgesamt gut zwei Stunden; eine Doppelstunde von 90 Minuten: 1, 2, 3, 5, 6, 7, 11, 13</translation>
    </message>
    <message>
        <source>What was said and done in “%1” is forgotten when it begins again.</source>
        <translation>Was in „%1“ gesagt und getan wurde, wird vergessen, wenn die Lektion von vorn beginnt.</translation>
    </message>
    <message>
        <source>No lessons</source>
        <translation>Keine Lektionen</translation>
    </message>
    <message>
        <source>All are done</source>
        <translation>Alle sind fertig</translation>
    </message>
    <message>
        <source>Lessons come with the program; none were found in %1.</source>
        <translation>Lektionen gehören zum Programm; in %1 wurden keine gefunden.</translation>
    </message>
    <message>
        <source>Start with the first</source>
        <translation>Mit der ersten beginnen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation>noch etwa %1 min</translation>
    </message>
    <message>
        <source>%1   step %2 of %3, %4</source>
        <translation>%1   Schritt %2 von %3, %4</translation>
    </message>
    <message>
        <source>%1   %2 min</source>
        <translation>%1   %2 min</translation>
    </message>
    <message>
        <source>You were asked: %1</source>
        <translation>Sie wurden gefragt: %1</translation>
    </message>
    <message>
        <source>about %1 hours left</source>
        <translation>noch etwa %1 Stunden</translation>
    </message>
    <message>
        <source>%1 of %2 lessons</source>
        <translation>%1 von %2 Lektionen</translation>
    </message>
    <message>
        <source>For teachers:</source>
        <translation>Für Lehrende:</translation>
    </message>
    <message>
        <source>a lesson file can also be dropped here</source>
        <translation>eine Lektionsdatei lässt sich auch hierher ziehen</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>What the chosen lesson&apos;s teacher should know: answers, questions, times</source>
        <translation>Was die Lehrkraft zur gewählten Lektion wissen sollte: Antworten, Fragen, Zeiten</translation>
    </message>
    <message>
        <source>Open a lesson file …</source>
        <translation>Lektionsdatei öffnen …</translation>
    </message>
    <message>
        <source>Write …</source>
        <translation>Schreiben …</translation>
    </message>
    <message>
        <source>Class …</source>
        <translation>Kurs …</translation>
    </message>
    <message>
        <source>Kiosk</source>
        <translation>Kiosk</translation>
    </message>
    <message>
        <source>Hand-out …</source>
        <translation>Arbeitsblatt …</translation>
    </message>
    <message>
        <source>A lesson of one&apos;s own: one text file</source>
        <translation>Eine eigene Lektion: eine einzige Textdatei</translation>
    </message>
    <message>
        <source>Answers are kept in a shared folder, in a file for each student</source>
        <translation>Antworten kommen in einen gemeinsamen Ordner, eine Datei für jede Person</translation>
    </message>
    <message>
        <source>Two robots on the whole screen, for a booth; a window of its own</source>
        <translation>Zwei Roboter auf dem ganzen Bildschirm, für einen Stand; ein eigenes Fenster</translation>
    </message>
    <message>
        <source>The lesson on paper, with room to write, or with the answers</source>
        <translation>Die Lektion auf Papier, mit Platz zum Schreiben oder mit den Antworten</translation>
    </message>
    <message>
        <source>A lesson of one&apos;s own as text, checked while it is typed</source>
        <translation>Eine eigene Lektion als Text, beim Tippen geprüft</translation>
    </message>
    <message>
        <source>A new lesson</source>
        <translation>Eine neue Lektion</translation>
    </message>
    <message>
        <source>The chosen one</source>
        <translation>Die gewählte</translation>
    </message>
    <message>
        <source>For students …</source>
        <translation>Für Lernende …</translation>
    </message>
    <message>
        <source>With the answers …</source>
        <translation>Mit Antworten …</translation>
    </message>
    <message>
        <source>Open a lesson</source>
        <translation>Lektion öffnen</translation>
    </message>
    <message>
        <source>Lessons (*.toml);;All files (*)</source>
        <translation>Lektionen (*.toml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>The text in hand is not saved; save it, and then take another.</source>
        <translation>Der aktuelle Text ist nicht gespeichert; speichern Sie ihn, bevor Sie einen anderen nehmen.</translation>
    </message>
    <message>
        <source>This text was not saved; it is back as it was.</source>
        <translation>Dieser Text war nicht gespeichert; er ist wieder da, wie er war.</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Every student has a file of their own in the folder. A name of your choosing will do.</source>
        <translation>Jede Person hat in dem Ordner eine eigene Datei. Ein selbst gewählter Name genügt.</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Beitreten</translation>
    </message>
    <message>
        <source>Shared folder</source>
        <translation>Gemeinsamer Ordner</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>A name has up to 40 letters, digits, blanks, - and _.</source>
        <translation>Ein Name hat bis zu 40 Buchstaben, Ziffern, Leerzeichen, - und _.</translation>
    </message>
    <message>
        <source>There is no such folder.</source>
        <translation>Diesen Ordner gibt es nicht.</translation>
    </message>
    <message>
        <source>This lesson has no kiosk; these have one: %1.</source>
        <translation>Diese Lektion hat keinen Kiosk; diese haben einen: %1.</translation>
    </message>
    <message>
        <source>The kiosk could not be started.</source>
        <translation>Der Kiosk ließ sich nicht starten.</translation>
    </message>
    <message>
        <source>The kiosk opens. Ctrl+Shift+K and the word “%1” leave it.</source>
        <translation>Der Kiosk öffnet sich. Strg+Umschalt+K und das Wort „%1“ beenden ihn.</translation>
    </message>
    <message>
        <source>Hand-out</source>
        <translation>Arbeitsblatt</translation>
    </message>
</context>
<context>
    <name>surefoot::LifeFollower</name>
    <message>
        <source>it is being read …</source>
        <translation>wird gelesen …</translation>
    </message>
    <message>
        <source>the life is complete</source>
        <translation>das Leben ist zu Ende</translation>
    </message>
    <message>
        <source>as of %1, %2</source>
        <translation>Stand %1, %2</translation>
    </message>
    <message>
        <source>the body acts with its values, and learns nothing</source>
        <translation>der Körper handelt nach den Werten und lernt nichts</translation>
    </message>
    <message>
        <source>it stands still</source>
        <translation>es steht still</translation>
    </message>
</context>
<context>
    <name>surefoot::LivePage</name>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>preset %1</source>
        <translation>Preset %1</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Fewer</source>
        <translation>Weniger</translation>
    </message>
    <message>
        <source>What the robot would do now</source>
        <translation>Was der Roboter jetzt täte</translation>
    </message>
    <message>
        <source>This step</source>
        <translation>Dieser Schritt</translation>
    </message>
    <message>
        <source>what the last one taught</source>
        <translation>was der letzte lehrte</translation>
    </message>
    <message>
        <source>Rule of thumb</source>
        <translation>Faustregel</translation>
    </message>
    <message>
        <source>TRL&apos;s threshold</source>
        <translation>TRL-Schwelle</translation>
    </message>
    <message>
        <source>List of falls</source>
        <translation>Liste der Stürze</translation>
    </message>
    <message>
        <source>a click shows one again</source>
        <translation>ein Klick zeigt einen noch einmal</translation>
    </message>
    <message>
        <source>Average reward</source>
        <translation>Mittlere Belohnung</translation>
    </message>
    <message>
        <source>last %1 episodes</source>
        <translation>letzte %1 Episoden</translation>
    </message>
    <message>
        <source>all %1 so far</source>
        <translation>bisher %1</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>Whole life</source>
        <translation>Ganzes Leben</translation>
    </message>
    <message>
        <source>Show the whole life, or only as far as it learned. In the chart the wheel or a drag magnifies a part; a double click or Home shows the whole life.</source>
        <translation>Das ganze Leben zeigen oder nur die Zeit, in der es lernte. Im Diagramm vergrößern das Mausrad oder Ziehen einen Teil; ein Doppelklick oder Pos1 zeigt das ganze Leben.</translation>
    </message>
    <message>
        <source>A part</source>
        <translation>Ein Teil</translation>
    </message>
    <message>
        <source>While it learned</source>
        <translation>Solange es lernte</translation>
    </message>
    <message>
        <source>Time shown: %1</source>
        <translation>Gezeigte Zeit: %1</translation>
    </message>
    <message>
        <source>cumulative</source>
        <translation>kumuliert</translation>
    </message>
    <message>
        <source>up to minute %1</source>
        <translation>bis Minute %1</translation>
    </message>
    <message>
        <source>up to episode %1</source>
        <translation>bis Episode %1</translation>
    </message>
    <message>
        <source>%1; %2 after a push or placing by hand</source>
        <translation>%1; davon %2 nach Stoßen oder Platzieren von Hand</translation>
    </message>
    <message>
        <source>%1; click a mark to replay it</source>
        <translation>%1; Klick auf eine Marke: Wiedergabe</translation>
    </message>
    <message>
        <source>Value maps</source>
        <translation>Wertekarten</translation>
    </message>
    <message>
        <source>in the state fixed on the map; Escape on the map lets go</source>
        <translation>im Zustand, der auf der Karte fixiert ist; Esc auf der Karte löst ihn</translation>
    </message>
    <message>
        <source>in the state under the cursor on the map</source>
        <translation>im Zustand unter dem Mauszeiger auf der Karte</translation>
    </message>
    <message>
        <source>the next action is shaded; %1 actions, by joint</source>
        <translation>die nächste Aktion ist schattiert; %1 Aktionen, je Gelenk</translation>
    </message>
    <message>
        <source>in the replay</source>
        <translation>in der Wiedergabe</translation>
    </message>
    <message>
        <source>in the real-time world</source>
        <translation>in der Echtzeitwelt</translation>
    </message>
    <message>
        <source>the next action is shaded</source>
        <translation>die nächste Aktion ist schattiert</translation>
    </message>
    <message>
        <source>%1; Escape: back to live</source>
        <translation>%1; Esc: zurück zu Live</translation>
    </message>
    <message>
        <source>%1; ← → move, Escape: back to live</source>
        <translation>%1; ← → bewegen, Esc: zurück zu Live</translation>
    </message>
    <message>
        <source>real time, newest Q-function; nothing is learned</source>
        <translation>Echtzeit, neueste Q-Funktion; nichts wird gelernt</translation>
    </message>
    <message>
        <source>the life is complete</source>
        <translation>das Leben ist zu Ende</translation>
    </message>
    <message>
        <source>the learner&apos;s world, paused; turbo is on</source>
        <translation>die Welt des Lerners, angehalten; Turbo ist an</translation>
    </message>
    <message>
        <source>the learner&apos;s world, paused</source>
        <translation>die Welt des Lerners, angehalten</translation>
    </message>
    <message>
        <source>the learner&apos;s world; its life began %1</source>
        <translation>die Welt des Lerners; Beginn des Lebens: %1</translation>
    </message>
    <message>
        <source>the learner&apos;s world</source>
        <translation>die Welt des Lerners</translation>
    </message>
    <message>
        <source>the learner&apos;s world, %1</source>
        <translation>die Welt des Lerners, %1</translation>
    </message>
    <message>
        <source>real time; only this world is held, the learner&apos;s is not</source>
        <translation>Echtzeit; nur diese Welt wird festgehalten, die des Lerners nicht</translation>
    </message>
    <message>
        <source>real time, newest Q-function</source>
        <translation>Echtzeit, neueste Q-Funktion</translation>
    </message>
    <message>
        <source>real time, newest Q-function; the learner runs %1</source>
        <translation>Echtzeit, neueste Q-Funktion; der Lerner läuft %1</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erster</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Zweiter</translation>
    </message>
    <message>
        <source>Panels that share this place</source>
        <translation>Panels an diesem Platz</translation>
    </message>
    <message>
        <source>The learner goes on %1 steps into that episode, with what it knows now; the journal says so.</source>
        <translation>Der Lerner macht nach %1 Schritten jener Episode weiter, mit dem, was er jetzt weiß; das Journal vermerkt es.</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Phase portrait</source>
        <translation>Phasenporträt</translation>
    </message>
    <message>
        <source>Signals of the axes</source>
        <translation>Signale der Achsen</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Waagerecht</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Senkrecht</translation>
    </message>
    <message>
        <source>Strides</source>
        <translation>Doppelschritte</translation>
    </message>
    <message>
        <source>two steps each; a click marks one in the signals</source>
        <translation>je zwei Schritte; ein Klick markiert sie in den Signalen</translation>
    </message>
</context>
<context>
    <name>surefoot::LivesView</name>
    <message>
        <source>%1: mean %2, 95 percent interval %3 to %4</source>
        <translation>%1: Mittel %2, 95-Prozent-Intervall %3 bis %4</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>a line: one seed; </source>
        <translation>Linie: ein Seed; </translation>
    </message>
    <message>
        <source>a dot: one life; %1bar: 95 % interval of the mean</source>
        <translation>Punkt: ein Leben; %1Balken: 95-%-Intervall des Mittels</translation>
    </message>
    <message>
        <source>%1bar: 95 % interval</source>
        <translation>%1Balken: 95-%-Intervall</translation>
    </message>
    <message>
        <source>bar: 95 % interval</source>
        <translation>Balken: 95-%-Intervall</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>They are being lived …</source>
        <translation>Die Leben laufen …</translation>
    </message>
</context>
<context>
    <name>surefoot::Looking</name>
    <message>
        <source>fall %1, at a quarter of the speed</source>
        <translation>Sturz %1, ein Viertel des Tempos</translation>
    </message>
    <message>
        <source>Only the learner&apos;s own world can be gone on with, in the Signals layout and without turbo; or a fall, or a roll-out.</source>
        <translation>Nur die eigene Welt des Lerners lässt sich fortsetzen, im Layout Signale und ohne Turbo; oder ein Sturz, oder ein Rollout.</translation>
    </message>
    <message>
        <source>That episode is over, and it did not end in a fall: its inputs were not kept.</source>
        <translation>Diese Episode ist vorbei und endete nicht mit einem Sturz: Ihre Eingaben wurden nicht aufbewahrt.</translation>
    </message>
    <message>
        <source>Nothing is shown again: open a fall, look back, or roll out first.</source>
        <translation>Es läuft keine Wiedergabe: erst einen Sturz öffnen, zurückblicken oder einen Rollout starten.</translation>
    </message>
    <message>
        <source>%1 was %2 then and is %3 now: the same inputs would lead elsewhere.</source>
        <translation>%1 war damals %2 und ist jetzt %3: Dieselben Eingaben würden anderswohin führen.</translation>
    </message>
    <message>
        <source>The episode was over then; choose a moment before its end.</source>
        <translation>Da war die Episode schon vorbei; wählen Sie einen Augenblick vor ihrem Ende.</translation>
    </message>
</context>
<context>
    <name>surefoot::MainWindow</name>
    <message>
        <source>Surefoot</source>
        <translation>Surefoot</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>The life is complete; restart it to run again</source>
        <translation>Das Leben ist zu Ende; Neustart beginnt es neu</translation>
    </message>
    <message>
        <source>Run or pause</source>
        <translation>Start oder Pause</translation>
    </message>
    <message>
        <source>Start the life again with the same seed</source>
        <translation>Das Leben mit demselben Seed neu beginnen</translation>
    </message>
    <message>
        <source>Start the life again with the same seed and the same start: %1</source>
        <translation>Das Leben mit demselben Seed und demselben Start neu beginnen: %1</translation>
    </message>
    <message>
        <source>The life begins again with the same start: %1. Run › Restart with an empty table begins from nothing.</source>
        <translation>Das Leben beginnt neu mit demselben Start: %1. Start › Neustart mit leerer Tabelle beginnt von null an.</translation>
    </message>
    <message>
        <source>Another seed</source>
        <translation>Anderer Seed</translation>
    </message>
    <message>
        <source>The life begins again with this seed, a whole number from 0 on:</source>
        <translation>Das Leben beginnt neu mit diesem Seed, einer ganzen Zahl ab 0:</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Everything that can be opened (*.surefoot *.safetensors *.jsonl *.toml *.sqlite);;All files (*)</source>
        <translation>Alles, was sich öffnen lässt (*.surefoot *.safetensors *.jsonl *.toml *.sqlite);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 is loaded and goes on learning.</source>
        <translation>%1 ist geladen und lernt weiter.</translation>
    </message>
    <message>
        <source>%1 is loaded, not running: Run goes on learning.</source>
        <translation>%1 ist geladen, angehalten: Mit Start lernt es weiter.</translation>
    </message>
    <message>
        <source>%1 Run › Roll out 25 s shows what it does now, without learning.</source>
        <translation>%1 Start › Rollout 25 s zeigt, was es jetzt kann, ohne zu lernen.</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>%1 is written. It checks itself: %2</source>
        <translation>%1 ist gespeichert. Es prüft sich selbst: %2</translation>
    </message>
    <message>
        <source>%1 is written. Without a window: %2</source>
        <translation>%1 ist gespeichert. Ohne Fenster: %2</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 exportieren</translation>
    </message>
    <message>
        <source>Picture (*.png);;Vector graphics (*.svg);;Document (*.pdf);;Table (*.csv)</source>
        <translation>Bild (*.png);;Vektorgrafik (*.svg);;Dokument (*.pdf);;Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Only files of this machine can be opened.</source>
        <translation>Nur Dateien dieses Rechners lassen sich öffnen.</translation>
    </message>
    <message>
        <source>Fo&amp;llow …</source>
        <translation>&amp;Mitlesen …</translation>
    </message>
    <message>
        <source>Look at results or a checkpoint while another process writes them</source>
        <translation>Ergebnisse oder einen Checkpoint ansehen, während ein anderer Prozess sie schreibt</translation>
    </message>
    <message>
        <source>S&amp;top following</source>
        <translation>M&amp;itlesen beenden</translation>
    </message>
    <message>
        <source>What was followed stays, as if it had been opened</source>
        <translation>Das Mitgelesene bleibt, als wäre es geöffnet worden</translation>
    </message>
    <message>
        <source>Go on from here</source>
        <translation>Von hier weiter</translation>
    </message>
    <message>
        <source>Learn on, as a life of your own; the file is not followed any more</source>
        <translation>Weiterlernen, als eigenes Leben; die Datei wird nicht mehr mitgelesen</translation>
    </message>
    <message>
        <source>Stop following</source>
        <translation>Mitlesen beenden</translation>
    </message>
    <message>
        <source>The life stays as it is, as one of your own</source>
        <translation>Das Leben bleibt, wie es ist, als eigenes</translation>
    </message>
    <message>
        <source>%1 is not followed any more. This is a life of your own now, not saved yet.</source>
        <translation>%1 wird nicht mehr mitgelesen. Dies ist nun ein eigenes Leben, noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Mitlesen</translation>
    </message>
    <message>
        <source>Results and checkpoints (*.sqlite* *.safetensors *.surefoot *.ckpt);;All files (*)</source>
        <translation>Ergebnisse und Checkpoints (*.sqlite* *.safetensors *.surefoot *.ckpt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Following %1, read only</source>
        <translation>Nur mitgelesen: %1</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Handbook</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>The handbook, at the page of what has the focus</source>
        <translation>Das Handbuch, auf der Seite zu dem, was den Fokus hat</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>All shortcuts</source>
        <translation>Alle Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;Words</source>
        <translation>&amp;Begriffe</translation>
    </message>
    <message>
        <source>What the words mean, with their formulas</source>
        <translation>Was die Begriffe bedeuten, mit ihren Formeln</translation>
    </message>
    <message>
        <source>Write a &amp;lesson</source>
        <translation>&amp;Lektion schreiben</translation>
    </message>
    <message>
        <source>A lesson of one&apos;s own as text, from a template</source>
        <translation>Eine eigene Lektion als Text, nach einer Vorlage</translation>
    </message>
    <message>
        <source>&amp;About Surefoot</source>
        <translation>&amp;Über Surefoot</translation>
    </message>
    <message>
        <source>What this is</source>
        <translation>Was Surefoot ist</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>This is the lesson&apos;s robot as it is now. The lesson waits on its page, where you were.</source>
        <translation>Dies ist der Roboter der Lektion, wie er jetzt ist. Die Lektion wartet auf ihrer Seite, wo Sie waren.</translation>
    </message>
    <message>
        <source>It is being made ready; the world goes on meanwhile.</source>
        <translation>Wird vorbereitet; die Welt läuft inzwischen weiter.</translation>
    </message>
    <message>
        <source>The life before is kept: Ctrl+Z brings it back.</source>
        <translation>Das vorige Leben ist aufbewahrt: Strg+Z holt es zurück.</translation>
    </message>
    <message>
        <source>This life is back as it was; the other one is kept for undo and redo.</source>
        <translation>Dieses Leben ist wieder da, wie es war; das andere bleibt zum Rückgängigmachen und Wiederherstellen.</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Allow it, and go on</source>
        <translation>Erlauben und fortfahren</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>%1 needs a new table, so learning starts again from the beginning, with the same seed.</source>
        <translation>%1 braucht eine neue Tabelle; das Lernen beginnt darum von vorn, mit demselben Seed.</translation>
    </message>
    <message>
        <source>%1 = %2 needs a new table. Start again from the beginning, with the same seed, or carry what is learned over into it?</source>
        <translation>%1 = %2 braucht eine neue Tabelle. Von vorn beginnen, mit demselben Seed, oder das Gelernte übernehmen?</translation>
    </message>
    <message>
        <source>Carry over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>There is not enough memory to keep one more life for undo: a life before this one, of %1, is not saved and would end.</source>
        <translation>Der Speicher reicht nicht, um noch ein Leben zum Rückgängigmachen aufzubewahren: Ein früheres Leben mit %1 ist nicht gespeichert und würde enden.</translation>
    </message>
    <message>
        <source>Save it first</source>
        <translation>Erst speichern</translation>
    </message>
    <message>
        <source>End it</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>This life has %1, is not saved, and there is not enough memory to keep it for undo.</source>
        <translation>Dieses Leben hat %1 und ist nicht gespeichert, und der Speicher reicht nicht, um es zum Rückgängigmachen aufzubewahren.</translation>
    </message>
    <message>
        <source>untitled session</source>
        <translation>unbenannte Sitzung</translation>
    </message>
    <message>
        <source>Surefoot: the life is complete</source>
        <translation>Surefoot: Das Leben ist zu Ende</translation>
    </message>
    <message>
        <source>Surefoot: %1</source>
        <translation>Surefoot: %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 episodes are not saved</source>
        <translation>
            <numerusform>%1 Episode ist nicht gespeichert</numerusform>
            <numerusform>%1 Episoden sind nicht gespeichert</numerusform>
        </translation>
    </message>
    <message>
        <source>everything is saved</source>
        <translation>alles ist gespeichert</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>A life before this one, of %1,</source>
        <translation>Ein früheres Leben mit %1:</translation>
    </message>
    <message>
        <source>%1 lives before this one, of %2 episodes,</source>
        <translation>%1 frühere Leben mit %2 Episoden:</translation>
    </message>
    <message>
        <source>What the second learned in %1 is not saved.</source>
        <translation>Was der zweite Lerner in %1 gelernt hat, ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>%1 kept for Ctrl+Z only, not saved.</source>
        <translation>%1 nur für Strg+Z aufbewahrt, nicht gespeichert.</translation>
    </message>
    <message>
        <source>What this life learned in %1 is not saved.</source>
        <translation>Was dieses Leben in %1 gelernt hat, ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>What the robot of the Live page learned in %1 is not saved.</source>
        <translation>Was der Roboter der Seite Live in %1 gelernt hat, ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>What %1 learned in %2 is not saved.</source>
        <translation>Was %1 in %2 gelernt hat, ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>%1 kept for Ctrl+Z only.</source>
        <translation>%1 nur für Strg+Z aufbewahrt.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Don&apos;t save</source>
        <translation>Nicht speichern</translation>
    </message>
    <message>
        <source>Save the second learner&apos;s session</source>
        <translation>Sitzung des zweiten Lerners speichern</translation>
    </message>
    <message>
        <source>The session could not be kept for the next start: %1 Closing the window again gives it up.</source>
        <translation>Die Sitzung ließ sich nicht für den nächsten Start aufbewahren: %1 Wenn Sie das Fenster noch einmal schließen, geht sie verloren.</translation>
    </message>
    <message>
        <source>The last session can go on where it was closed.</source>
        <translation>Die letzte Sitzung lässt sich fortsetzen, wo sie geschlossen wurde.</translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Begin anew</source>
        <translation>Neu anfangen</translation>
    </message>
    <message>
        <source>The last session was not closed. Its last minutes may be missing.</source>
        <translation>Die letzte Sitzung wurde nicht geschlossen. Ihre letzten Minuten fehlen vielleicht.</translation>
    </message>
    <message>
        <source>Restore it</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Forget it</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>It stays where it is: %1.</source>
        <translation>Sie bleibt, wo sie ist: %1.</translation>
    </message>
    <message>
        <source>It is set aside as %1.</source>
        <translation>Sie ist beiseitegelegt als %1.</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>S&amp;chritt</translation>
    </message>
    <message>
        <source>One step of the paused world</source>
        <translation>Ein Schritt der angehaltenen Welt</translation>
    </message>
    <message>
        <source>Re&amp;start</source>
        <translation>&amp;Neustart</translation>
    </message>
    <message>
        <source>&amp;Turbo</source>
        <translation>&amp;Turbo</translation>
    </message>
    <message>
        <source>Learn flat out</source>
        <translation>Lernen mit Höchsttempo</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>Schn&amp;eller</translation>
    </message>
    <message>
        <source>A notch faster</source>
        <translation>Eine Stufe schneller</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>Langsa&amp;mer</translation>
    </message>
    <message>
        <source>A notch slower</source>
        <translation>Eine Stufe langsamer</translation>
    </message>
    <message>
        <source>Look &amp;back</source>
        <translation>Zurück&amp;blicken</translation>
    </message>
    <message>
        <source>A frame back in what was shown; with Shift a second</source>
        <translation>Ein Bild zurück in dem, was gezeigt wurde; mit Umschalt eine Sekunde</translation>
    </message>
    <message>
        <source>Back to &amp;live</source>
        <translation>&amp;Zurück zu Live</translation>
    </message>
    <message>
        <source>Leave the replay and show what happens now</source>
        <translation>Die Wiedergabe verlassen und zeigen, was jetzt geschieht</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New session in</source>
        <translation>&amp;Neue Sitzung in</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open a session, a Q-function, a journal, a plan or results</source>
        <translation>Sitzung, Q-Funktion, Journal, Plan oder Ergebnisse öffnen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the session: it goes on where it was; on the page Robot, the robot</source>
        <translation>Die Sitzung speichern: Sie geht weiter, wo sie war; auf der Seite Roboter den Roboter</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the session under another name; on the page Robot, the robot</source>
        <translation>Die Sitzung unter anderem Namen speichern; auf der Seite Roboter den Roboter</translation>
    </message>
    <message>
        <source>Save the Q-&amp;function …</source>
        <translation>&amp;Q-Funktion speichern …</translation>
    </message>
    <message>
        <source>What was learned, to load it elsewhere</source>
        <translation>Das Gelernte, um es anderswo zu laden</translation>
    </message>
    <message>
        <source>Save the Q-function</source>
        <translation>Q-Funktion speichern</translation>
    </message>
    <message>
        <source>Export the policy as &amp;C …</source>
        <translation>Policy als &amp;C exportieren …</translation>
    </message>
    <message>
        <source>The greedy policy as a C99 program that needs nothing else</source>
        <translation>Die Greedy-Policy als C99-Programm, das nichts weiter braucht</translation>
    </message>
    <message>
        <source>Export the policy as C</source>
        <translation>Policy als C exportieren</translation>
    </message>
    <message>
        <source>Save the &amp;journal …</source>
        <translation>&amp;Journal speichern …</translation>
    </message>
    <message>
        <source>A small text by which the life can be lived again</source>
        <translation>Ein kleiner Text, mit dem sich das Leben wiederholen lässt</translation>
    </message>
    <message>
        <source>Save the journal</source>
        <translation>Journal speichern</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>As PNG, SVG, PDF or CSV</source>
        <translation>Als PNG, SVG, PDF oder CSV</translation>
    </message>
    <message>
        <source>World …</source>
        <translation>Welt …</translation>
    </message>
    <message>
        <source>As PNG, SVG or PDF</source>
        <translation>Als PNG, SVG oder PDF</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>The whole window …</source>
        <translation>Das ganze Fenster …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Leave the program</source>
        <translation>Das Programm verlassen</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Take the last change back; bring the life before back</source>
        <translation>Die letzte Änderung zurücknehmen; das vorige Leben zurückholen</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>Die Änderung wieder vornehmen</translation>
    </message>
    <message>
        <source>Reset all &amp;parameters</source>
        <translation>Alle &amp;Parameter zurücksetzen</translation>
    </message>
    <message>
        <source>To what preset and scenario say</source>
        <translation>Auf das, was Preset und Szenario sagen</translation>
    </message>
    <message>
        <source>Another &amp;seed …</source>
        <translation>Anderer &amp;Seed …</translation>
    </message>
    <message>
        <source>Begin again with other random numbers</source>
        <translation>Mit anderen Zufallszahlen neu beginnen</translation>
    </message>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>Colours, motion, the start</source>
        <translation>Farben, Bewegung, Start</translation>
    </message>
    <message>
        <source>Restart with an &amp;empty table</source>
        <translation>Neustart mit &amp;leerer Tabelle</translation>
    </message>
    <message>
        <source>Start the life again with the same seed, from nothing</source>
        <translation>Das Leben mit demselben Seed neu beginnen, von null an</translation>
    </message>
    <message>
        <source>&amp;Go on from here</source>
        <translation>Von hier &amp;weiter</translation>
    </message>
    <message>
        <source>The learner&apos;s world is put into the moment that a replay shows; it goes on learning</source>
        <translation>Die Welt des Lerners wird in den Augenblick der Wiedergabe versetzt; er lernt dort weiter</translation>
    </message>
    <message>
        <source>&amp;What if</source>
        <translation>W&amp;as wäre, wenn</translation>
    </message>
    <message>
        <source>&amp;Compare with a second learner</source>
        <translation>Mit zweitem Lerner &amp;vergleichen</translation>
    </message>
    <message>
        <source>Another method with the same seed, side by side</source>
        <translation>Eine andere Methode mit demselben Seed, nebeneinander</translation>
    </message>
    <message>
        <source>The second learner begins now. For a fair race, begin the first again, too?</source>
        <translation>Der zweite Lerner beginnt jetzt. Den ersten für einen fairen Vergleich auch neu beginnen?</translation>
    </message>
    <message>
        <source>Begin both again</source>
        <translation>Beide neu beginnen</translation>
    </message>
    <message>
        <source>&amp;Pre-learn, then transfer …</source>
        <translation>V&amp;orlernen, dann übertragen …</translation>
    </message>
    <message>
        <source>Learn in a simulation, then live in reality with what was learned</source>
        <translation>In einer Simulation lernen, dann mit dem Gelernten in der Realität leben</translation>
    </message>
    <message>
        <source>R&amp;oll out 25 s</source>
        <translation>&amp;Rollout 25 s</translation>
    </message>
    <message>
        <source>What the greedy policy does from a new start, learning nothing</source>
        <translation>Was die Greedy-Policy von einem neuen Start an tut, ohne zu lernen</translation>
    </message>
    <message>
        <source>Rob&amp;ustness …</source>
        <translation>Rob&amp;ustheit …</translation>
    </message>
    <message>
        <source>How often what was learned falls, over pushes and models</source>
        <translation>Wie oft er mit dem Gelernten stürzt, je Stoß und Modell</translation>
    </message>
    <message>
        <source>E&amp;xperiment</source>
        <translation>E&amp;xperiment</translation>
    </message>
    <message>
        <source>&amp;Open a plan or results …</source>
        <translation>Plan oder Ergebnisse ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>A plan, a recipe or a store of results</source>
        <translation>Ein Plan, ein Rezept oder eine Ergebnisdatei</translation>
    </message>
    <message>
        <source>Save the &amp;plan as …</source>
        <translation>&amp;Plan speichern unter …</translation>
    </message>
    <message>
        <source>The plan as a file</source>
        <translation>Der Plan als Datei</translation>
    </message>
    <message>
        <source>&amp;Run or pause</source>
        <translation>&amp;Start oder Pause</translation>
    </message>
    <message>
        <source>Run the experiment, or pause it</source>
        <translation>Das Experiment starten oder anhalten</translation>
    </message>
    <message>
        <source>Start &amp;again</source>
        <translation>&amp;Neu beginnen</translation>
    </message>
    <message>
        <source>Forget what was lived</source>
        <translation>Bisherige Leben verwerfen</translation>
    </message>
    <message>
        <source>&amp;Copy the table as CSV</source>
        <translation>Tabelle als &amp;CSV kopieren</translation>
    </message>
    <message>
        <source>To the clipboard</source>
        <translation>In die Zwischenablage</translation>
    </message>
    <message>
        <source>Copy the table as &amp;LaTeX</source>
        <translation>Tabelle als &amp;LaTeX kopieren</translation>
    </message>
    <message>
        <source>E&amp;xport all lives as CSV …</source>
        <translation>Alle Leben als CS&amp;V exportieren …</translation>
    </message>
    <message>
        <source>Conditions, lives and episodes</source>
        <translation>Bedingungen, Leben und Episoden</translation>
    </message>
    <message>
        <source>Export all lives for a &amp;spreadsheet …</source>
        <translation>Alle Leben für &amp;Tabellenkalkulation …</translation>
    </message>
    <message>
        <source>The same, as Excel reads it</source>
        <translation>Dasselbe, wie Excel es liest</translation>
    </message>
    <message>
        <source>Export all c&amp;harts …</source>
        <translation>Alle &amp;Diagramme exportieren …</translation>
    </message>
    <message>
        <source>PNG, PDF and CSV</source>
        <translation>PNG, PDF und CSV</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Experiment</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>&amp;Nothing else: the same again</source>
        <translation>&amp;Nichts weiter: noch einmal dasselbe</translation>
    </message>
    <message>
        <source>Another policy</source>
        <translation>Andere Policy</translation>
    </message>
    <message>
        <source>Another learning rule</source>
        <translation>Andere Lernregel</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation>&amp;Live</translation>
    </message>
    <message>
        <source>&amp;Experiment</source>
        <translation>&amp;Experiment</translation>
    </message>
    <message>
        <source>Le&amp;ssons</source>
        <translation>Le&amp;ktionen</translation>
    </message>
    <message>
        <source>&amp;Robot</source>
        <translation>&amp;Roboter</translation>
    </message>
    <message>
        <source>The page %1</source>
        <translation>Die Seite %1</translation>
    </message>
    <message>
        <source>La&amp;youts</source>
        <translation>La&amp;youts</translation>
    </message>
    <message>
        <source>&amp;Usual</source>
        <translation>&amp;Standard</translation>
    </message>
    <message>
        <source>Every panel back in its place</source>
        <translation>Alle Panels wieder an ihrem Platz</translation>
    </message>
    <message>
        <source>&amp;Teaching</source>
        <translation>&amp;Lehre</translation>
    </message>
    <message>
        <source>What a step teaches, and the rule of thumb</source>
        <translation>Was ein Schritt lehrt, und die Faustregel</translation>
    </message>
    <message>
        <source>&amp;Falls</source>
        <translation>S&amp;türze</translation>
    </message>
    <message>
        <source>The list of falls beside the charts</source>
        <translation>Die Liste der Stürze neben den Diagrammen</translation>
    </message>
    <message>
        <source>&amp;Maps</source>
        <translation>&amp;Karten</translation>
    </message>
    <message>
        <source>The value maps large</source>
        <translation>Die Wertekarten groß</translation>
    </message>
    <message>
        <source>&amp;Signals</source>
        <translation>Si&amp;gnale</translation>
    </message>
    <message>
        <source>How the robot moves: strip charts, phase portrait, strides</source>
        <translation>Wie der Roboter sich bewegt: Signalstreifen, Phasenporträt, Doppelschritte</translation>
    </message>
    <message>
        <source>&amp;Keep this one as …</source>
        <translation>Dieses &amp;behalten als …</translation>
    </message>
    <message>
        <source>The panels as they are now, under a name</source>
        <translation>Die Panels, wie sie jetzt sind, unter einem Namen</translation>
    </message>
    <message>
        <source>&amp;My own</source>
        <translation>&amp;Eigene</translation>
    </message>
    <message>
        <source>&amp;Fit the world</source>
        <translation>&amp;Welt einpassen</translation>
    </message>
    <message>
        <source>The zoom that shows the whole world</source>
        <translation>Der Zoom, der die ganze Welt zeigt</translation>
    </message>
    <message>
        <source>Fil&amp;m …</source>
        <translation>Fil&amp;m …</translation>
    </message>
    <message>
        <source>The last minutes, or a replay, as a film</source>
        <translation>Die letzten Minuten oder eine Wiedergabe als Film</translation>
    </message>
    <message>
        <source>Colours of the &amp;system</source>
        <translation>Farben des &amp;Systems</translation>
    </message>
    <message>
        <source>L&amp;ight</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>The whole screen</source>
        <translation>Der ganze Bildschirm</translation>
    </message>
    <message>
        <source>&amp;Projector</source>
        <translation>&amp;Beamer</translation>
    </message>
    <message>
        <source>Everything as large as the last row of a lecture room needs it</source>
        <translation>Alles so groß, wie es die letzte Reihe eines Hörsaals braucht</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>Te&amp;xtgröße</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>&amp;Größer</translation>
    </message>
    <message>
        <source>Larger text, controls and drawings</source>
        <translation>Text, Bedienelemente und Zeichnungen größer</translation>
    </message>
    <message>
        <source>&amp;Smaller</source>
        <translation>&amp;Kleiner</translation>
    </message>
    <message>
        <source>Smaller text, controls and drawings</source>
        <translation>Text, Bedienelemente und Zeichnungen kleiner</translation>
    </message>
    <message>
        <source>Text, controls and drawings in their usual size</source>
        <translation>Text, Bedienelemente und Zeichnungen in Standardgröße</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Everything at %1 %</source>
        <translation>Alles auf %1 %</translation>
    </message>
    <message>
        <source>Keep this layout</source>
        <translation>Dieses Layout behalten</translation>
    </message>
    <message>
        <source>Its name:</source>
        <translation>Sein Name:</translation>
    </message>
    <message>
        <source>The name of a layout has 1 to %1 characters.</source>
        <translation>Der Name eines Layouts hat 1 bis %1 Zeichen.</translation>
    </message>
    <message>
        <source>%1 layouts are kept already; forget one first.</source>
        <translation>Es sind schon %1 Layouts gespeichert; löschen Sie erst eines.</translation>
    </message>
    <message>
        <source>Kept as &quot;%1&quot;, in the menu View, Layouts, My own.</source>
        <translation>Gespeichert als „%1“, im Menü Ansicht, Layouts, Eigene.</translation>
    </message>
    <message>
        <source>The layout &quot;%1&quot; is one of another version; keep it anew.</source>
        <translation>Das Layout „%1“ stammt aus einer anderen Version; speichern Sie es neu.</translation>
    </message>
    <message>
        <source>None kept yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Surefoot crashed. A report of it is on this computer; nothing was sent.</source>
        <translation>Surefoot ist abgestürzt. Ein Bericht darüber liegt auf diesem Computer; nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>Show the report</source>
        <translation>Bericht zeigen</translation>
    </message>
    <message>
        <source>Leave it there</source>
        <translation>Liegen lassen</translation>
    </message>
    <message>
        <source>There is no report of a crash.</source>
        <translation>Es gibt keinen Bericht über einen Absturz.</translation>
    </message>
    <message>
        <source>&amp;Report of the last crash</source>
        <translation>Bericht über den letzten &amp;Absturz</translation>
    </message>
    <message>
        <source>What Surefoot noted when it crashed, to be sent by hand</source>
        <translation>Was Surefoot beim Absturz notiert hat, zum Versenden von Hand</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Nicht jetzt</translation>
    </message>
</context>
<context>
    <name>surefoot::MapBar</name>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Other variables</source>
        <translation>Andere Variablen</translation>
    </message>
    <message>
        <source>Range of the colours</source>
        <translation>Bereich der Farben</translation>
    </message>
    <message>
        <source>What the map shows</source>
        <translation>Was die Karte zeigt</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Waagerecht</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Senkrecht</translation>
    </message>
    <message>
        <source>Follow the live state</source>
        <translation>Dem Live-Zustand folgen</translation>
    </message>
    <message>
        <source>Fix where it is now</source>
        <translation>Beim jetzigen Wert fixieren</translation>
    </message>
    <message>
        <source>Fixed %1</source>
        <translation>%1 fixiert</translation>
    </message>
    <message>
        <source>Mean over it</source>
        <translation>Mittel darüber</translation>
    </message>
    <message>
        <source>Least over it</source>
        <translation>Minimum darüber</translation>
    </message>
    <message>
        <source>Most over it</source>
        <translation>Maximum darüber</translation>
    </message>
    <message>
        <source>Locked to what rewards allow</source>
        <translation>Fest: was Belohnungen erlauben</translation>
    </message>
    <message>
        <source>What the map shows now</source>
        <translation>Was die Karte jetzt zeigt</translation>
    </message>
</context>
<context>
    <name>surefoot::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>surefoot::ModelRows</name>
    <message>
        <source>Simulation and reality are alike. Add what is to differ.</source>
        <translation>Simulation und Realität sind gleich. Fügen Sie hinzu, was abweichen soll.</translation>
    </message>
    <message>
        <source>Add a parameter that differs</source>
        <translation>Abweichenden Parameter hinzufügen</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Reality</source>
        <translation>Realität</translation>
    </message>
    <message>
        <source>Add a parameter that differs …</source>
        <translation>Abweichenden Parameter hinzufügen …</translation>
    </message>
    <message>
        <source>Allowed: %1</source>
        <translation>Erlaubt: %1</translation>
    </message>
    <message>
        <source>in simulation</source>
        <translation>in der Simulation</translation>
    </message>
    <message>
        <source>in reality</source>
        <translation>in der Realität</translation>
    </message>
</context>
<context>
    <name>surefoot::NumberBox</name>
    <message>
        <source>Work it out</source>
        <translation>Ausrechnen</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Type a number, such as −4.5.</source>
        <translation>Geben Sie eine Zahl ein, etwa −4.5.</translation>
    </message>
</context>
<context>
    <name>surefoot::OptionsBox</name>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
</context>
<context>
    <name>surefoot::OrderBox</name>
    <message>
        <source>Put them in order</source>
        <translation>In Reihenfolge bringen</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>the first on top; drag one, or Alt+↑ and Alt+↓</source>
        <translation>das Erste nach oben; mit der Maus ziehen, oder Alt+↑ und Alt+↓</translation>
    </message>
</context>
<context>
    <name>surefoot::PanelHeader</name>
    <message>
        <source>Close %1; the View menu brings it back</source>
        <translation>%1 schließen (wieder öffnen: Menü Ansicht)</translation>
    </message>
    <message>
        <source>Back to all panels</source>
        <translation>Zurück zu allen Panels</translation>
    </message>
    <message>
        <source>Give %1 the whole window</source>
        <translation>%1 im ganzen Fenster zeigen</translation>
    </message>
</context>
<context>
    <name>surefoot::PanelRow</name>
    <message>
        <source>Full size</source>
        <translation>Ganze Größe</translation>
    </message>
    <message>
        <source>Panels that share this place</source>
        <translation>Panels an diesem Platz</translation>
    </message>
</context>
<context>
    <name>surefoot::ParameterForm</name>
    <message>
        <source>new table</source>
        <translation>neue Tabelle</translation>
    </message>
    <message>
        <source>next episode</source>
        <translation>nächste Episode</translation>
    </message>
    <message>
        <source>not with the others</source>
        <translation>passt nicht zum Rest</translation>
    </message>
    <message>
        <source>The guardian&apos;s Q-function</source>
        <translation>Die Q-Funktion des Wächters</translation>
    </message>
    <message>
        <source>Q-functions (*.safetensors *.surefoot);;All files (*)</source>
        <translation>Q-Funktionen (*.safetensors *.surefoot);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>all parameters</source>
        <translation>alle Parameter</translation>
    </message>
</context>
<context>
    <name>surefoot::ParameterRow</name>
    <message>
        <source>%1, number</source>
        <translation>%1, Zahl</translation>
    </message>
    <message>
        <source>Set at step %1; Reset goes back to %2.</source>
        <translation>Gesetzt bei Schritt %1; Zurücksetzen ergibt %2.</translation>
    </message>
    <message>
        <source>Changed; Reset goes back to %1.</source>
        <translation>Geändert; Zurücksetzen ergibt %1.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>no number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>Reset %1 to its default</source>
        <translation>%1 auf den Standard zurücksetzen</translation>
    </message>
</context>
<context>
    <name>surefoot::PhasePortrait</name>
    <message>
        <source>Phase portrait</source>
        <translation>Phasenporträt</translation>
    </message>
    <message>
        <source>Two signals against each other</source>
        <translation>Zwei Signale gegeneinander</translation>
    </message>
    <message>
        <source>the marked stride</source>
        <translation>der markierte Doppelschritt</translation>
    </message>
    <message>
        <source>last cycle</source>
        <translation>letzter Zyklus</translation>
    </message>
    <message>
        <source>last stride</source>
        <translation>letzter Doppelschritt</translation>
    </message>
    <message>
        <source>all that is shown</source>
        <translation>alles Gezeigte</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Waagerecht</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Senkrecht</translation>
    </message>
</context>
<context>
    <name>surefoot::PlanChooser</name>
    <message>
        <source>What to run: plans, the thesis&apos;s figures, your own files</source>
        <translation>Was gestartet wird: Pläne, die Abbildungen der Masterarbeit, eigene Dateien</translation>
    </message>
    <message>
        <source>Choose a plan</source>
        <translation>Plan wählen</translation>
    </message>
    <message>
        <source>Your own files</source>
        <translation>Eigene Dateien</translation>
    </message>
    <message>
        <source>Search the experiments</source>
        <translation>Experimente durchsuchen</translation>
    </message>
    <message>
        <source>Search: a figure&apos;s number, a word</source>
        <translation>Suche: Nummer einer Abbildung, ein Wort</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>Experimente</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Abb.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Open a plan or results …</source>
        <translation>Plan oder Ergebnisse öffnen …</translation>
    </message>
    <message>
        <source>Plans</source>
        <translation>Pläne</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>Nothing is called that.</source>
        <translation>Nichts heißt so.</translation>
    </message>
</context>
<context>
    <name>surefoot::PlanEditor</name>
    <message>
        <source>Use this plan</source>
        <translation>Plan verwenden</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Add what the Live page runs</source>
        <translation>Von der Seite Live übernehmen</translation>
    </message>
    <message>
        <source>A new condition; it begins as the first one</source>
        <translation>Eine neue Bedingung; sie beginnt wie die erste</translation>
    </message>
    <message>
        <source>Add the condition</source>
        <translation>Bedingung hinzufügen</translation>
    </message>
    <message>
        <source>It is not added: %1</source>
        <translation>Nicht hinzugefügt: %1</translation>
    </message>
    <message>
        <source>The plan was changed meanwhile; add it again.</source>
        <translation>Der Plan wurde inzwischen geändert; noch einmal hinzufügen.</translation>
    </message>
    <message numerus="yes">
        <source>%n conditions</source>
        <translation>
            <numerusform>%n Bedingung</numerusform>
            <numerusform>%n Bedingungen</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 each</source>
        <translation>, je %1</translation>
    </message>
    <message>
        <source>It is being checked …</source>
        <translation>Wird geprüft …</translation>
    </message>
</context>
<context>
    <name>surefoot::PointBox</name>
    <message>
        <source>Point at it</source>
        <translation>Darauf zeigen</translation>
    </message>
    <message>
        <source>a click on the map answers; on the map, arrows move the cursor and Enter answers</source>
        <translation>ein Klick auf die Karte antwortet; auf der Karte bewegen Pfeiltasten den Cursor, und Enter antwortet</translation>
    </message>
    <message>
        <source>a click on its mark answers</source>
        <translation>ein Klick auf die Marke antwortet</translation>
    </message>
</context>
<context>
    <name>surefoot::PreLearningDialog</name>
    <message>
        <source>Pre-learn, then transfer</source>
        <translation>Vorlernen, dann übertragen</translation>
    </message>
    <message>
        <source>Scenario of the simulation</source>
        <translation>Szenario der Simulation</translation>
    </message>
    <message>
        <source>a model of your own</source>
        <translation>ein eigenes Modell</translation>
    </message>
    <message>
        <source>The simulation is scenario</source>
        <translation>Die Simulation ist Szenario</translation>
    </message>
    <message>
        <source>Average reward that ends the pre-learning</source>
        <translation>Mittlere Belohnung, die das Vorlernen beendet</translation>
    </message>
    <message>
        <source>Q-functions to learn</source>
        <translation>Zu lernende Q-Funktionen</translation>
    </message>
    <message>
        <source>ε-greedy, until the average reward is</source>
        <translation>ε-greedy, bis zur mittleren Belohnung von</translation>
    </message>
    <message>
        <source>%1 has converged, %2 has not</source>
        <translation>%1 ist konvergiert, %2 nicht</translation>
    </message>
    <message>
        <source>or, left empty, for %1 simulated min</source>
        <translation>oder, wenn leer, %1 min simuliert</translation>
    </message>
    <message>
        <source>or, left empty, for %1</source>
        <translation>oder, wenn leer, %1</translation>
    </message>
    <message>
        <source>Q-functions in the pool</source>
        <translation>Q-Funktionen im Pool</translation>
    </message>
    <message>
        <source>The pool</source>
        <translation>Der Pool</translation>
    </message>
    <message>
        <source>Q-function</source>
        <translation>Q-Funktion</translation>
    </message>
    <message>
        <source>episodes</source>
        <translation>Episoden</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>average reward</source>
        <translation>mittlere Belohnung</translation>
    </message>
    <message>
        <source>Begin a life in reality with it</source>
        <translation>Damit ein Leben in der Realität beginnen</translation>
    </message>
    <message>
        <source>Average reward</source>
        <translation>Mittlere Belohnung</translation>
    </message>
    <message>
        <source>A life has begun with Q-function %1: %2 episodes and %3 falls of simulation are behind it.</source>
        <translation>Ein Leben hat mit Q-Funktion %1 begonnen, gelernt in %2 Episoden mit %3 Stürzen der Simulation.</translation>
    </message>
    <message>
        <source> (not reached)</source>
        <translation> (nicht erreicht)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Pre-learn</source>
        <translation>Vorlernen</translation>
    </message>
    <message>
        <source>This environment&apos;s model has nothing to be wrong about; what is learned is carried over as it is.</source>
        <translation>Am Modell dieser Umgebung kann nichts falsch sein; das Gelernte wird unverändert übernommen.</translation>
    </message>
    <message>
        <source>%1 of %2 are learned. The world goes on meanwhile.</source>
        <translation>%1 von %2 sind gelernt. Die Welt läuft inzwischen weiter.</translation>
    </message>
    <message>
        <source>The pool appears here: learn on the simulation, then choose one and begin a life in reality with it.</source>
        <translation>Hier erscheint der Pool: Lernen Sie in der Simulation, wählen Sie dann eine Q-Funktion und beginnen Sie damit ein Leben in der Realität.</translation>
    </message>
    <message>
        <source>Choose one, and begin a life in reality with it.</source>
        <translation>Wählen Sie eine und beginnen Sie damit ein Leben in der Realität.</translation>
    </message>
</context>
<context>
    <name>surefoot::PredictionBox</name>
    <message>
        <source>Your prediction</source>
        <translation>Ihre Vorhersage</translation>
    </message>
    <message>
        <source>The same as a slider</source>
        <translation>Dasselbe als Schieber</translation>
    </message>
    <message>
        <source>%1 to %2; type it, or drag the mark. Once given it stays. Wrong is fine.</source>
        <translation>%1 bis %2; eintippen oder die Marke ziehen. Einmal abgegeben, bleibt sie. Falsch ist in Ordnung.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>You said %1</source>
        <translation>Sie sagten %1</translation>
    </message>
    <message>
        <source>Commit to %1</source>
        <translation>Auf %1 festlegen</translation>
    </message>
</context>
<context>
    <name>surefoot::PredictionResult</name>
    <message>
        <source>You said</source>
        <translation>Sie sagten</translation>
    </message>
    <message>
        <source>and it came to</source>
        <translation>und es wurden</translation>
    </message>
    <message>
        <source>Very close.</source>
        <translation>Sehr nah dran.</translation>
    </message>
    <message>
        <source>%1 more than you said.</source>
        <translation>%1 mehr, als Sie sagten.</translation>
    </message>
    <message>
        <source>%1 fewer than you said.</source>
        <translation>%1 weniger, als Sie sagten.</translation>
    </message>
    <message>
        <source>You said %1. It came to %2 %3. %4</source>
        <translation>Sie sagten %1. Es wurden %2 %3. %4</translation>
    </message>
</context>
<context>
    <name>surefoot::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>those of the system</source>
        <translation>die des Systems</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>Colours: %1</source>
        <translation>Farben: %1</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>that of the system</source>
        <translation>die des Systems</translation>
    </message>
    <message>
        <source>From the next start on. The handbook, the lessons and sentences about errors are English.</source>
        <translation>Ab dem nächsten Start. Handbuch, Lektionen und Sätze über Fehler sind englisch.</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Textgröße</translation>
    </message>
    <message>
        <source>160 %: projector</source>
        <translation>160 %: Beamer</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>less of it: no trail, no flash, a camera that stands,
falls shown frame by frame</source>
        <translation>weniger davon: keine Spur, kein Blitz, eine stehende Kamera,
Stürze Bild für Bild</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Beim Start</translation>
    </message>
    <message>
        <source>learn as soon as the window is open</source>
        <translation>lernen, sobald das Fenster offen ist</translation>
    </message>
    <message>
        <source>Safety copy</source>
        <translation>Sicherungskopie</translation>
    </message>
    <message>
        <source>every </source>
        <translation>alle </translation>
    </message>
    <message>
        <source> min; a crash loses no more</source>
        <translation> min; ein Absturz kostet nie mehr</translation>
    </message>
    <message>
        <source>Minutes between two copies of the session on the disk</source>
        <translation>Minuten zwischen zwei Kopien der Sitzung auf der Festplatte</translation>
    </message>
</context>
<context>
    <name>surefoot::QuestionBox</name>
    <message>
        <source>✓ Right.</source>
        <translation>✓ Richtig.</translation>
    </message>
    <message>
        <source>✓ Right. %1</source>
        <translation>✓ Richtig. %1</translation>
    </message>
    <message>
        <source>Not yet. %1</source>
        <translation>Noch nicht. %1</translation>
    </message>
</context>
<context>
    <name>surefoot::RandomLife</name>
    <message>
        <source>What a random life looks like</source>
        <translation>So verläuft ein Zufallsleben</translation>
    </message>
    <message numerus="yes">
        <source>%n falls; %1</source>
        <translation>
            <numerusform>%n Sturz; %1</numerusform>
            <numerusform>%n Stürze; %1</numerusform>
        </translation>
    </message>
    <message>
        <source>steps; %1 s in all</source>
        <translation>Schritte; insgesamt %1 s</translation>
    </message>
    <message>
        <source>Falls in %1 steps</source>
        <translation>Stürze in %1 Schritten</translation>
    </message>
    <message>
        <source>To a fall, median</source>
        <translation>Bis zum Sturz, Median</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>Längste Dauer</translation>
    </message>
    <message>
        <source>At a limit of %1</source>
        <translation>Anschlag %1</translation>
    </message>
    <message>
        <source> % of steps</source>
        <translation> % der Schritte</translation>
    </message>
</context>
<context>
    <name>surefoot::Rival</name>
    <message>
        <source>World of the second</source>
        <translation>Welt des zweiten Lerners</translation>
    </message>
    <message>
        <source>The second cannot have the same start (%1): its tables differ. It begins empty.</source>
        <translation>Der zweite Lerner kann nicht denselben Start haben (%1): Seine Tabellen sind andere. Er beginnt leer.</translation>
    </message>
    <message>
        <source>%1: the second starts again from the beginning, and what it learned in %2 is given up.</source>
        <translation>%1: Der zweite Lerner beginnt von vorn, und was er in %2 gelernt hat, geht verloren.</translation>
    </message>
    <message>
        <source>Another learning rule needs a new table</source>
        <translation>Eine andere Lernregel braucht eine neue Tabelle</translation>
    </message>
    <message>
        <source>Another start</source>
        <translation>Anderer Start</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Was wäre, wenn</translation>
    </message>
    <message>
        <source>Parameters of the second</source>
        <translation>Parameter des zweiten Lerners</translation>
    </message>
    <message>
        <source>%1 = %2 needs a new table: the second starts again from the beginning.</source>
        <translation>%1 = %2 braucht eine neue Tabelle: Der zweite Lerner beginnt von vorn.</translation>
    </message>
</context>
<context>
    <name>surefoot::RobotPage</name>
    <message>
        <source>%1 was saved by another program, and is shown as it is now; undo brings back what was here.</source>
        <translation>%1 wurde von einem anderen Programm gespeichert und steht nun hier, wie es jetzt ist; Rückgängig holt zurück, was hier stand.</translation>
    </message>
    <message>
        <source>What was not saved of %1 is here again.</source>
        <translation>Was von %1 nicht gespeichert war, ist wieder da.</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>Roboter: %1</translation>
    </message>
    <message>
        <source>changed, not saved</source>
        <translation>geändert, nicht gespeichert</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>noch nicht gespeichert</translation>
    </message>
    <message>
        <source>picture and table: as of the last text without an error</source>
        <translation>Bild und Tabelle: Stand des letzten Textes ohne Fehler</translation>
    </message>
    <message>
        <source>picture and table come when the text has no error</source>
        <translation>Bild und Tabelle kommen, wenn der Text keinen Fehler hat</translation>
    </message>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n Fehler</numerusform>
            <numerusform>%n Fehler</numerusform>
        </translation>
    </message>
    <message>
        <source>F8 the next error, Alt+Enter mends it</source>
        <translation>F8: nächster Fehler, Alt+Enter behebt ihn</translation>
    </message>
    <message>
        <source>F8 the next error</source>
        <translation>F8: nächster Fehler</translation>
    </message>
    <message numerus="yes">
        <source>%n lines; F1 says what the word at the caret means</source>
        <translation>
            <numerusform>%n Zeile; F1 erklärt das Wort am Cursor</numerusform>
            <numerusform>%n Zeilen; F1 erklärt das Wort am Cursor</numerusform>
        </translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source> (and %1 more)</source>
        <translation> (und %1 weitere)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Testen</translation>
    </message>
    <message>
        <source>names and limits under the pointer; a click goes to the line</source>
        <translation>Namen und Grenzen unter dem Mauszeiger; ein Klick führt zur Zeile</translation>
    </message>
    <message>
        <source>a robot that is not saved yet</source>
        <translation>ein Roboter, der noch nicht gespeichert ist</translation>
    </message>
    <message>
        <source>%1 tiles a tiling</source>
        <translation>%1 Kacheln je Kachelung</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>A new robot, like</source>
        <translation>Neuer Roboter, wie</translation>
    </message>
    <message>
        <source>Open a robot</source>
        <translation>Roboter öffnen</translation>
    </message>
    <message>
        <source>Robots (*.toml)</source>
        <translation>Roboter (*.toml)</translation>
    </message>
    <message>
        <source>starts %1</source>
        <translation>startet %1</translation>
    </message>
    <message>
        <source>TOML, checked while you type; runs nothing</source>
        <translation>TOML, beim Tippen geprüft; startet nichts</translation>
    </message>
    <message>
        <source>A program moves it: let it learn, and it moves on the Live page.</source>
        <translation>Ein Programm bewegt ihn: Lassen Sie ihn lernen, dann bewegt er sich auf der Seite Live.</translation>
    </message>
    <message>
        <source>Nothing is known of this word.</source>
        <translation>Zu diesem Wort ist nichts bekannt.</translation>
    </message>
    <message>
        <source>line %1 comes to %2 at the start of an episode</source>
        <translation>Zeile %1 ergibt zu Beginn einer Episode %2</translation>
    </message>
    <message>
        <source>What was not saved of %1 is in %2; undo brings it back, too.</source>
        <translation>Was von %1 nicht gespeichert war, ist in %2; auch Rückgängig holt es zurück.</translation>
    </message>
    <message>
        <source>a new robot</source>
        <translation>ein neuer Roboter</translation>
    </message>
    <message>
        <source>Save the robot</source>
        <translation>Roboter speichern</translation>
    </message>
    <message>
        <source>Allow it to start</source>
        <translation>Starten erlauben</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Let it learn</source>
        <translation>Lernen lassen</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Find; Return: the next one, Escape: done</source>
        <translation>Suchen; Enter: nächste Stelle, Esc: fertig</translation>
    </message>
    <message>
        <source>Find in the description</source>
        <translation>In der Beschreibung suchen</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufall</translation>
    </message>
    <message>
        <source>Motors off</source>
        <translation>Motoren aus</translation>
    </message>
    <message>
        <source>Passive</source>
        <translation>Passiv</translation>
    </message>
    <message>
        <source>Left to itself: no motors, dampers, friction and contacts. What moves less and less then loses its energy to the size of the substeps.</source>
        <translation>Sich selbst überlassen: ohne Motoren, Dämpfer, Reibung und Kontakte. Was sich dann immer weniger bewegt, verliert seine Energie durch die Größe der Teilschritte.</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Falltest</translation>
    </message>
    <message>
        <source>As it is drawn, from 20 cm above the ground, motors off</source>
        <translation>Wie gezeichnet, aus 20 cm über dem Boden, Motoren aus</translation>
    </message>
    <message>
        <source>Hand-made</source>
        <translation>Fester Regler</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>What a random life looks like</source>
        <translation>So verläuft ein Zufallsleben</translation>
    </message>
    <message>
        <source>a click on a mark shows the fall</source>
        <translation>ein Klick auf eine Marke zeigt den Sturz</translation>
    </message>
    <message>
        <source>seen in %1 random steps</source>
        <translation>gesehen in %1 Zufallsschritten</translation>
    </message>
</context>
<context>
    <name>surefoot::RobotPicture</name>
    <message>
        <source>The robot</source>
        <translation>Der Roboter</translation>
    </message>
    <message>
        <source>%1°, limit, line %2</source>
        <translation>%1°, Grenze, Zeile %2</translation>
    </message>
</context>
<context>
    <name>surefoot::RobotText</name>
    <message>
        <source>Description of the robot</source>
        <translation>Beschreibung des Roboters</translation>
    </message>
    <message>
        <source>Write “%1”</source>
        <translation>„%1“ schreiben</translation>
    </message>
    <message>
        <source>Alt+Enter</source>
        <translation>Alt+Enter</translation>
    </message>
</context>
<context>
    <name>surefoot::RobotTrial</name>
    <message>
        <source>a fall of the random life</source>
        <translation>ein Sturz des Zufallslebens</translation>
    </message>
    <message>
        <source>keys 1 … %1: %2; ← → push</source>
        <translation>Tasten 1 … %1: %2; ← → stoßen</translation>
    </message>
    <message>
        <source>keys 1 … %1: the next level of each motor; ← → push</source>
        <translation>Tasten 1 … %1: nächste Stufe jedes Motors; ← → stoßen</translation>
    </message>
</context>
<context>
    <name>surefoot::RobustnessDialog</name>
    <message>
        <source>Robustness</source>
        <translation>Robustheit</translation>
    </message>
    <message>
        <source>The map is there: %1 models, %2 pushes. The arrow keys choose a cell.</source>
        <translation>Die Karte ist da: %1 Modelle, %2 Stöße. Die Pfeiltasten wählen eine Zelle.</translation>
    </message>
    <message>
        <source>The command that gives the same numbers</source>
        <translation>Der Befehl, der dieselben Zahlen ergibt</translation>
    </message>
    <message>
        <source>Copy the command</source>
        <translation>Befehl kopieren</translation>
    </message>
    <message>
        <source>The command is copied.</source>
        <translation>Der Befehl ist kopiert.</translation>
    </message>
    <message>
        <source>Save what was tried …</source>
        <translation>Getestetes speichern …</translation>
    </message>
    <message>
        <source>Export the map …</source>
        <translation>Karte exportieren …</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Testen</translation>
    </message>
    <message>
        <source>Stopped; nothing came out.</source>
        <translation>Gestoppt; es kam nichts heraus.</translation>
    </message>
    <message>
        <source>Another environment is learned in now; close this window and open it again.</source>
        <translation>Jetzt wird in einer anderen Umgebung gelernt; schließen Sie dieses Fenster und öffnen Sie es neu.</translation>
    </message>
    <message>
        <source>Save the Q-function that was tried</source>
        <translation>Getestete Q-Funktion speichern</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Export the map</source>
        <translation>Karte exportieren</translation>
    </message>
    <message>
        <source>Picture (*.png);;Vector graphics (*.svg);;Document (*.pdf);;Table (*.csv)</source>
        <translation>Bild (*.png);;Vektorgrafik (*.svg);;Dokument (*.pdf);;Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>%1 % is done. The life goes on meanwhile.</source>
        <translation>%1 % sind fertig. Das Leben geht inzwischen weiter.</translation>
    </message>
    <message>
        <source>The mouse or the arrow keys choose a cell.</source>
        <translation>Die Maus oder die Pfeiltasten wählen eine Zelle.</translation>
    </message>
    <message>
        <source>Every cell is tried from the same starts: it lives, is pushed once, and is followed.</source>
        <translation>Jede Zelle wird von denselben Starts aus getestet: Der Roboter lebt, wird einmal gestoßen und beobachtet.</translation>
    </message>
    <message>
        <source>Without a window, once what was tried is saved as %1:
</source>
        <translation>Ohne Fenster, sobald das Getestete als %1 gespeichert ist:
</translation>
    </message>
    <message>
        <source>Without a window:
</source>
        <translation>Ohne Fenster:
</translation>
    </message>
</context>
<context>
    <name>surefoot::RobustnessForm</name>
    <message>
        <source>Pushes, N s</source>
        <translation>Stöße, N s</translation>
    </message>
    <message>
        <source>Pushes in newton seconds</source>
        <translation>Stöße in Newtonsekunden</translation>
    </message>
    <message>
        <source>Impulses: a list, 0;0.05;0.1, or a range, 0..0.2:9, nine from 0 to 0.2. Negative ones push to the left.</source>
        <translation>Impulse: eine Liste, 0;0.05;0.1, oder ein Bereich, 0..0.2:9, neun von 0 bis 0.2. Negative stoßen nach links.</translation>
    </message>
    <message>
        <source>pushed at, s</source>
        <translation>Stoß bei, s</translation>
    </message>
    <message>
        <source>Time of the push in seconds</source>
        <translation>Zeitpunkt des Stoßes in Sekunden</translation>
    </message>
    <message>
        <source>A time, or two with .. between them: every start draws its own between these.</source>
        <translation>Ein Zeitpunkt, oder zwei mit .. dazwischen: Jeder Start zieht seinen eigenen dazwischen.</translation>
    </message>
    <message>
        <source>followed for, s</source>
        <translation>beobachtet, s</translation>
    </message>
    <message>
        <source>Seconds after the push</source>
        <translation>Sekunden nach dem Stoß</translation>
    </message>
    <message>
        <source>From the push on: falls in this time are counted.</source>
        <translation>Vom Stoß an: Stürze in dieser Zeit werden gezählt.</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <source>as it is now</source>
        <translation>wie es jetzt ist</translation>
    </message>
    <message>
        <source>all scenarios</source>
        <translation>alle Szenarien</translation>
    </message>
    <message>
        <source>with</source>
        <translation>mit</translation>
    </message>
    <message>
        <source>Parameters of the models</source>
        <translation>Parameter der Modelle</translation>
    </message>
    <message>
        <source>Parameters of the environment and their values, with blanks between them: environment.friction=0..0.1:5 environment.damping=0.04;0.08. Every value is combined with every other and with every scenario.</source>
        <translation>Parameter der Umgebung und ihre Werte, durch Leerzeichen getrennt: environment.friction=0..0.1:5 environment.damping=0.04;0.08. Jeder Wert wird mit jedem anderen und jedem Szenario kombiniert.</translation>
    </message>
    <message>
        <source>environment.KEY=VALUES …</source>
        <translation>environment.NAME=WERTE …</translation>
    </message>
    <message>
        <source>Policy</source>
        <translation>Policy</translation>
    </message>
    <message>
        <source>starts a cell</source>
        <translation>Starts je Zelle</translation>
    </message>
    <message>
        <source>Starts of every cell</source>
        <translation>Starts in jeder Zelle</translation>
    </message>
    <message>
        <source>Trials of every push on every model. Trial 1 starts alike in every cell, and so on.</source>
        <translation>Versuche für jeden Stoß an jedem Modell. Versuch 1 startet in allen Zellen gleich, und so weiter.</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>Seed</translation>
    </message>
    <message>
        <source>Seed of the starts</source>
        <translation>Seed der Starts</translation>
    </message>
    <message>
        <source>Starts, times of pushes and the policy&apos;s draws come from it.</source>
        <translation>Daraus folgen die Starts, die Zeitpunkte der Stöße und der Zufall der Policy.</translation>
    </message>
    <message>
        <source>A second Q-function …</source>
        <translation>Zweite Q-Funktion …</translation>
    </message>
    <message>
        <source>Of the same environment; it is tried from the same starts on the same models.</source>
        <translation>Aus derselben Umgebung; sie wird von denselben Starts an denselben Modellen getestet.</translation>
    </message>
    <message>
        <source>Without it</source>
        <translation>Ohne sie</translation>
    </message>
    <message>
        <source>Beside it</source>
        <translation>Daneben</translation>
    </message>
    <message>
        <source>A second Q-function</source>
        <translation>Zweite Q-Funktion</translation>
    </message>
    <message>
        <source>Q-functions (*.safetensors *.surefoot);;All files (*)</source>
        <translation>Q-Funktionen (*.safetensors *.surefoot);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>nothing: what this life has learned so far is tried alone</source>
        <translation>nichts: Nur was dieses Leben bisher gelernt hat, wird getestet</translation>
    </message>
</context>
<context>
    <name>surefoot::RobustnessMap</name>
    <message>
        <source>Falls over pushes and models</source>
        <translation>Stürze über Stößen und Modellen</translation>
    </message>
    <message>
        <source>push, N s</source>
        <translation>Stoß, N s</translation>
    </message>
    <message>
        <source>%1, push %2 N s: </source>
        <translation>%1, Stoß %2 N s: </translation>
    </message>
    <message>
        <source>beside it: </source>
        <translation>daneben: </translation>
    </message>
    <message>
        <source>; %1 succeeded</source>
        <translation>; %1 erfolgreich</translation>
    </message>
    <message>
        <source>; %1 flew apart</source>
        <translation>; %1 auseinandergeflogen</translation>
    </message>
    <message>
        <source>; the intervals have nothing in common</source>
        <translation>; die Intervalle überlappen nicht</translation>
    </message>
    <message>
        <source>How often it falls appears here: a column a push, a row a model.</source>
        <translation>Hier erscheint, wie oft er stürzt: eine Spalte je Stoß, eine Zeile je Modell.</translation>
    </message>
    <message>
        <source>0 %</source>
        <translation>0 %</translation>
    </message>
    <message>
        <source>100 % fell</source>
        <translation>100 % gestürzt</translation>
    </message>
    <message>
        <source>100 % succeeded</source>
        <translation>100 % erfolgreich</translation>
    </message>
    <message>
        <source>the 95 % intervals of the two have nothing in common</source>
        <translation>die beiden 95-%-Intervalle überlappen nicht</translation>
    </message>
    <message>
        <source>%1 of %2 fell, %3 % (95 %: %4 … %5 %)</source>
        <translation>%1 von %2 stürzten, %3 % (95 %: %4 … %5 %)</translation>
    </message>
    <message>
        <source>%1 of %2 succeeded, %3 % (95 %: %4 … %5 %)</source>
        <translation>%1 von %2 gelangen, %3 % (95 %: %4 … %5 %)</translation>
    </message>
    <message>
        <source>%1 starts a cell</source>
        <translation>%1 Starts je Zelle</translation>
    </message>
    <message>
        <source>, pushed at %1 s</source>
        <translation>, gestoßen bei %1 s</translation>
    </message>
    <message>
        <source>, pushed between %1 and %2 s</source>
        <translation>, gestoßen zwischen %1 und %2 s</translation>
    </message>
    <message>
        <source>, followed for %1 s</source>
        <translation>, %1 s verfolgt</translation>
    </message>
    <message>
        <source>, policy %1, seed %2</source>
        <translation>, Policy %1, Seed %2</translation>
    </message>
</context>
<context>
    <name>surefoot::RuleView</name>
    <message>
        <source>Sets TRL&apos;s threshold to the rule&apos;s number, rounded; Edit › Undo takes it back</source>
        <translation>Setzt die TRL-Schwelle auf die Zahl der Regel, gerundet; Bearbeiten › Rückgängig nimmt es zurück</translation>
    </message>
    <message>
        <source>Set the threshold to %1</source>
        <translation>Schwelle auf %1 setzen</translation>
    </message>
    <message>
        <source>TRL&apos;s threshold in force: %1.</source>
        <translation>TRL-Schwelle, aktiv: %1.</translation>
    </message>
    <message>
        <source>TRL&apos;s threshold is %1; it is not in force while the policy is %2.</source>
        <translation>Die TRL-Schwelle ist %1; sie ist nicht aktiv, solange die Policy %2 ist.</translation>
    </message>
    <message>
        <source>%1 = %2 = %3</source>
        <translation>%1 = %2 = %3</translation>
    </message>
    <message>
        <source>R: reward of the goal; n*: mean transitions of the successful episodes while it learned%1 (thesis, eq. %2).</source>
        <translation>R: Belohnung des Ziels; n*: mittlere Zahl der Übergänge in den erfolgreichen Episoden, solange gelernt wurde%1 (Masterarbeit, Gl. %2).</translation>
    </message>
    <message>
        <source>; R_t: reward of every step</source>
        <translation>; R_t: Belohnung jedes Schritts</translation>
    </message>
    <message>
        <source>There is no goal. R: the highest reward of a step so far; n*: transitions of a footstep%1. The thesis expects this to serve and did not test it (section 4.5).</source>
        <translation>Es gibt kein Ziel. R: höchste Belohnung eines Schritts bisher; n*: Übergänge je Gehschritt%1. Die Masterarbeit erwartet, dass das taugt, hat es aber nicht geprüft (Abschnitt 4.5).</translation>
    </message>
    <message>
        <source>This life began with something learned; the limits are told of lives that begin from nothing.</source>
        <translation>Dieses Leben begann mit Gelerntem; die Grenzen gelten für Leben, die von null an beginnen.</translation>
    </message>
    <message>
        <source>Lower limit %1, upper limit %2.</source>
        <translation>Untere Grenze %1, obere Grenze %2.</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch offen</translation>
    </message>
</context>
<context>
    <name>surefoot::RunBar</name>
    <message>
        <source>Pace</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>How fast the world runs while turbo is off: %1 to %2 times real time</source>
        <translation>Wie schnell die Welt ohne Turbo läuft: das %1- bis %2-Fache der Echtzeit</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Changed model</source>
        <translation>Geändertes Modell</translation>
    </message>
    <message>
        <source>Learning rule</source>
        <translation>Lernregel</translation>
    </message>
    <message>
        <source>Policy</source>
        <translation>Policy</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>What do these words mean?</source>
        <translation>Was bedeuten diese Begriffe?</translation>
    </message>
    <message>
        <source>What task, learning rule and policy mean</source>
        <translation>Was Aufgabe, Lernregel und Policy bedeuten</translation>
    </message>
    <message>
        <source>All words</source>
        <translation>Alle Begriffe</translation>
    </message>
    <message>
        <source>Scenario of the model</source>
        <translation>Szenario des Modells</translation>
    </message>
    <message>
        <source>episodes</source>
        <translation>Episoden</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>Stürze</translation>
    </message>
</context>
<context>
    <name>surefoot::RunningLife</name>
    <message>
        <source>Pause first; then a click on the map puts the body into that state.</source>
        <translation>Erst anhalten; dann setzt ein Klick auf die Karte den Körper in diesen Zustand.</translation>
    </message>
    <message>
        <source>The life is complete; nothing goes on in it.</source>
        <translation>Das Leben ist zu Ende; darin geht nichts weiter.</translation>
    </message>
    <message>
        <source>A program moves this robot; it cannot be put back into a moment.</source>
        <translation>Ein Programm bewegt diesen Roboter; er lässt sich nicht in einen Augenblick zurückversetzen.</translation>
    </message>
</context>
<context>
    <name>surefoot::Scrubber</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Go on from here</source>
        <translation>Von hier weiter</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Zurück zu Live</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Augenblick</translation>
    </message>
    <message>
        <source>The learner&apos;s world is put into this moment, and it goes on learning there</source>
        <translation>Die Welt des Lerners wird in diesen Augenblick versetzt, und er lernt dort weiter</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
</context>
<context>
    <name>surefoot::SessionName</name>
    <message>
        <source>Session %1, not saved</source>
        <translation>Sitzung %1, nicht gespeichert</translation>
    </message>
    <message>
        <source>Session %1</source>
        <translation>Sitzung %1</translation>
    </message>
</context>
<context>
    <name>surefoot::ShareSlider</name>
    <message>
        <source>How much they explore, in 100 steps</source>
        <translation>Wie viel sie ausprobieren, in 100 Schritten</translation>
    </message>
    <message>
        <source>%1 of 100</source>
        <translation>%1 von 100</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>every second step</source>
        <translation>jeder 2. Schritt</translation>
    </message>
</context>
<context>
    <name>surefoot::SignalChooser</name>
    <message>
        <source>Search signals</source>
        <translation>Signale suchen</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>One place up (Ctrl+Up)</source>
        <translation>Einen Platz nach oben (Strg+↑)</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>One place down (Ctrl+Down)</source>
        <translation>Einen Platz nach unten (Strg+↓)</translation>
    </message>
    <message>
        <source>With the one above</source>
        <translation>Mit dem darüber</translation>
    </message>
    <message>
        <source>In one strip with the signal above, or in a strip of its own (Ctrl+J)</source>
        <translation>In einem Streifen mit dem Signal darüber, oder in einem eigenen (Strg+J)</translation>
    </message>
    <message>
        <source>Usual ones</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>What is shown at first</source>
        <translation>Was am Anfang gezeigt wird</translation>
    </message>
    <message>
        <source>%1, of the group %2</source>
        <translation>%1, aus der Gruppe %2</translation>
    </message>
</context>
<context>
    <name>surefoot::SignalsBar</name>
    <message>
        <source>Choose …</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Which signals are shown, and in which order</source>
        <translation>Welche Signale gezeigt werden, und in welcher Reihenfolge</translation>
    </message>
    <message>
        <source>Roll out 25 s</source>
        <translation>Rollout 25 s</translation>
    </message>
    <message>
        <source>What the greedy policy does in 25 s from a new start, learning nothing</source>
        <translation>Was die Greedy-Policy in 25 s von einem neuen Start an tut, ohne zu lernen</translation>
    </message>
    <message>
        <source>Second Q</source>
        <translation>Zweites Q</translation>
    </message>
    <message>
        <source>Another Q-function beside this one, from the same start with the same pushes</source>
        <translation>Eine andere Q-Funktion neben dieser, vom selben Start mit denselben Stößen</translation>
    </message>
    <message>
        <source>Film …</source>
        <translation>Film …</translation>
    </message>
    <message>
        <source>A film of the replay, or of the last minutes</source>
        <translation>Ein Film der Wiedergabe oder der letzten Minuten</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>The signals that are shown, as a picture or as numbers</source>
        <translation>Die gezeigten Signale, als Bild oder als Zahlen</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>What can be done with the signals</source>
        <translation>Was sich mit den Signalen tun lässt</translation>
    </message>
    <message>
        <source>Second: %1</source>
        <translation>Zweites: %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1, the last %2 s</source>
        <translation>%1, die letzten %2 s</translation>
    </message>
    <message>
        <source>%1 s, </source>
        <translation>%1 s, </translation>
    </message>
    <message>
        <source>no fall</source>
        <translation>kein Sturz</translation>
    </message>
    <message>
        <source>, %1 m</source>
        <translation>, %1 m</translation>
    </message>
    <message>
        <source>From a &amp;file …</source>
        <translation>Aus einer &amp;Datei …</translation>
    </message>
    <message>
        <source>What it knows &amp;now</source>
        <translation>Jetziger &amp;Stand</translation>
    </message>
    <message>
        <source>A copy of the Q-function of this moment</source>
        <translation>Eine Kopie der Q-Funktion dieses Augenblicks</translation>
    </message>
    <message>
        <source>What it &amp;began with</source>
        <translation>&amp;Anfangsstand</translation>
    </message>
    <message>
        <source>The Q-function of the file that this life began with</source>
        <translation>Die Q-Funktion der Datei, mit der dieses Leben begann</translation>
    </message>
    <message>
        <source>what it began with</source>
        <translation>Anfangsstand</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keine</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>nach %1</translation>
    </message>
    <message>
        <source>A Q-function beside this one</source>
        <translation>Eine Q-Funktion neben dieser</translation>
    </message>
    <message>
        <source>Q-functions (*.safetensors)</source>
        <translation>Q-Funktionen (*.safetensors)</translation>
    </message>
    <message>
        <source>%1 was learned in %2; it cannot stand beside a Q-function of %3.</source>
        <translation>%1 wurde in %2 gelernt; es kann nicht neben einer Q-Funktion von %3 stehen.</translation>
    </message>
    <message>
        <source>As %1 …</source>
        <translation>Als %1 …</translation>
    </message>
    <message>
        <source>&amp;Choose signals …</source>
        <translation>Signale &amp;wählen …</translation>
    </message>
    <message>
        <source>&amp;Roll out 25 s</source>
        <translation>&amp;Rollout 25 s</translation>
    </message>
    <message>
        <source>&amp;Second Q-function</source>
        <translation>&amp;Zweite Q-Funktion</translation>
    </message>
    <message>
        <source>&amp;Film …</source>
        <translation>&amp;Film …</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
</context>
<context>
    <name>surefoot::SignalsShown</name>
    <message>
        <source>First: %1</source>
        <translation>Erster: %1</translation>
    </message>
    <message>
        <source>Second: %1</source>
        <translation>Zweiter: %1</translation>
    </message>
    <message>
        <source>What is learned here</source>
        <translation>Was hier gelernt wird</translation>
    </message>
</context>
<context>
    <name>surefoot::StateTable</name>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>observed</source>
        <translation>beobachtet</translation>
    </message>
    <message>
        <source>how often</source>
        <translation>wie oft</translation>
    </message>
    <message>
        <source>tile</source>
        <translation>Kachel</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>ACTIONS</source>
        <translation>AKTIONEN</translation>
    </message>
    <message>
        <source>ENDINGS</source>
        <translation>ENDE</translation>
    </message>
    <message>
        <source>%1 steps, %2 s at most</source>
        <translation>%1 Schritte, höchstens %2 s</translation>
    </message>
    <message>
        <source>  ×%1</source>
        <translation>  ×%1</translation>
    </message>
    <message>
        <source>%1: range %2 … %3 in the file, %4 tiles</source>
        <translation>%1: Bereich %2 … %3 in der Datei, %4 Kacheln</translation>
    </message>
    <message>
        <source>; a click on the numbers writes %1 … %2</source>
        <translation>; ein Klick auf die Zahlen schreibt %1 … %2</translation>
    </message>
</context>
<context>
    <name>surefoot::StatusLine</name>
    <message>
        <source>State of the life</source>
        <translation>Stand des Lebens</translation>
    </message>
    <message>
        <source>%1 min simulated</source>
        <translation>%1 min simuliert</translation>
    </message>
    <message>
        <source>%1 M steps/s</source>
        <translation>%1 Mio. Schritte/s</translation>
    </message>
    <message>
        <source>%1 steps/s</source>
        <translation>%1 Schritte/s</translation>
    </message>
    <message>
        <source>n* %1 → rule-of-thumb threshold %2</source>
        <translation>n* %1 → Faustregel-Schwelle %2</translation>
    </message>
    <message>
        <source>rule-of-thumb threshold: not defined here</source>
        <translation>Faustregel-Schwelle: hier nicht definiert</translation>
    </message>
    <message>
        <source>table %1 % full</source>
        <translation>Tabelle zu %1 % voll</translation>
    </message>
    <message>
        <source>the guardian acted in %1 % of the steps</source>
        <translation>der Wächter handelte in %1 % der Schritte</translation>
    </message>
    <message>
        <source>a fall costs %1 more</source>
        <translation>ein Sturz kostet %1 mehr</translation>
    </message>
    <message numerus="yes">
        <source>%1 falls taken back</source>
        <translation>
            <numerusform>zurückgenommene Stürze: %1</numerusform>
            <numerusform>zurückgenommene Stürze: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>risk holds: %1 % said, %2 % fell</source>
        <translation>Risiko stimmt: %1 % vorhergesagt, %2 % gestürzt</translation>
    </message>
    <message>
        <source>risk errs: %1 % said, %2 % fell</source>
        <translation>Risiko irrt: %1 % vorhergesagt, %2 % gestürzt</translation>
    </message>
    <message>
        <source>risk unclear: %1 % said, %2 % fell</source>
        <translation>Risiko unklar: %1 % vorhergesagt, %2 % gestürzt</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>Seed %1</translation>
    </message>
    <message>
        <source>began %1</source>
        <translation>Beginn: %1</translation>
    </message>
    <message>
        <source>learning ended at episode %1</source>
        <translation>Lernen endete bei Episode %1</translation>
    </message>
    <message>
        <source>walks since minute %1</source>
        <translation>geht seit Minute %1</translation>
    </message>
    <message numerus="yes">
        <source>the robot flew apart %1 times</source>
        <translation>
            <numerusform>Roboter einmal auseinandergeflogen</numerusform>
            <numerusform>Roboter %1-mal auseinandergeflogen</numerusform>
        </translation>
    </message>
    <message>
        <source>the life is complete</source>
        <translation>das Leben ist zu Ende</translation>
    </message>
    <message>
        <source>followed</source>
        <translation>mitgelesen</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
</context>
<context>
    <name>surefoot::StepView</name>
    <message>
        <source>In turbo thousands of steps pass between two pictures. Turn it off to follow a single one.</source>
        <translation>Im Turbo vergehen zwischen zwei Bildern Tausende Schritte. Schalten Sie ihn aus, um einen einzelnen zu verfolgen.</translation>
    </message>
    <message>
        <source>What the last step taught appears here. Press “.” for a single step.</source>
        <translation>Hier erscheint, was der letzte Schritt lehrte. Die Taste „.“ macht einen einzelnen Schritt.</translation>
    </message>
    <message>
        <source>In S = (%1) it chose A = %2.</source>
        <translation>In S = (%1) wurde A = %2 gewählt.</translation>
    </message>
    <message>
        <source>δ = R + γ %1(S′, A′) − %1(S, A) = %2 + %3 − %4 = %5</source>
        <translation>δ = R + γ %1(S′, A′) − %1(S, A) = %2 + %3 − %4 = %5</translation>
    </message>
    <message>
        <source>Just as expected: %1 stays as it is.</source>
        <translation>Genau wie erwartet: %1 bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Better than expected: %1(S, A) goes up by α δ = %2, to %3.</source>
        <translation>Besser als erwartet: %1(S, A) steigt um α δ = %2, auf %3.</translation>
    </message>
    <message>
        <source>Worse than expected: %1(S, A) goes down by %2, to %3.</source>
        <translation>Schlechter als erwartet: %1(S, A) sinkt um %2, auf %3.</translation>
    </message>
    <message>
        <source>The trace carries the surprise back along the way: each step before gets %1 of it (γ λ = %2 · %3).</source>
        <translation>Die Traces tragen die Überraschung den Weg zurück: Jeder frühere Schritt bekommt das %1-Fache davon (γ λ = %2 · %3).</translation>
    </message>
    <message>
        <source>λ is 0: no step before learns from it.</source>
        <translation>λ ist 0: Kein früherer Schritt lernt daraus.</translation>
    </message>
</context>
<context>
    <name>surefoot::StrideTable</name>
    <message>
        <source>Begins s</source>
        <translation>Beginn s</translation>
    </message>
    <message>
        <source>Length m</source>
        <translation>Länge m</translation>
    </message>
    <message>
        <source>Duration s</source>
        <translation>Dauer s</translation>
    </message>
    <message>
        <source>Speed m/s</source>
        <translation>Geschw. m/s</translation>
    </message>
    <message>
        <source>Energy J</source>
        <translation>Energie J</translation>
    </message>
    <message>
        <source>Energy a metre J/m</source>
        <translation>Energie je Meter J/m</translation>
    </message>
    <message>
        <source>Both feet down %</source>
        <translation>Beide Füße unten %</translation>
    </message>
    <message>
        <source>Stride</source>
        <translation>Doppelschritt</translation>
    </message>
    <message>
        <source>Strides</source>
        <translation>Doppelschritte</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>second %1</source>
        <translation>zweiter %1</translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation>Mittel von %1</translation>
    </message>
    <message>
        <source>first, mean of %1</source>
        <translation>erster, Mittel von %1</translation>
    </message>
    <message>
        <source>second, mean of %1</source>
        <translation>zweiter, Mittel von %1</translation>
    </message>
    <message>
        <source>Strides appear here: from one touch-down of the left foot to the next.</source>
        <translation>Hier erscheinen Doppelschritte: von einem Aufsetzen des linken Fußes zum nächsten.</translation>
    </message>
    <message>
        <source>This robot has no left and right foot whose strides could be told.</source>
        <translation>Dieser Roboter hat keinen linken und rechten Fuß, an denen sich Doppelschritte erkennen ließen.</translation>
    </message>
</context>
<context>
    <name>surefoot::StripCharts</name>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>No signal is chosen.</source>
        <translation>Kein Signal gewählt.</translation>
    </message>
    <message>
        <source>Signals appear here while the world goes on, in a replay of a fall, and in a roll-out.</source>
        <translation>Signale erscheinen hier, während die Welt läuft, in der Wiedergabe eines Sturzes und in einem Rollout.</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 %2 %3</translation>
    </message>
    <message>
        <source>At %1 seconds: %2.</source>
        <translation>Bei %1 Sekunden: %2.</translation>
    </message>
    <message>
        <source>The whole time</source>
        <translation>Die ganze Zeit</translation>
    </message>
    <message>
        <source>The usual signals</source>
        <translation>Die Standardsignale</translation>
    </message>
</context>
<context>
    <name>surefoot::TaskBox</name>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>✓ Done.</source>
        <translation>✓ Geschafft.</translation>
    </message>
    <message>
        <source>○ Not done yet; it ticks itself.</source>
        <translation>○ Noch nicht geschafft; wird von selbst abgehakt.</translation>
    </message>
    <message>
        <source>✓ And with %1.</source>
        <translation>✓ Und mit %1.</translation>
    </message>
    <message>
        <source>Extra: can you do it with %1?</source>
        <translation>Extra: Schaffen Sie es mit %1?</translation>
    </message>
</context>
<context>
    <name>surefoot::TeacherWindow</name>
    <message>
        <source>as the interval says</source>
        <translation>wie das Intervall sagt</translation>
    </message>
    <message>
        <source>start again</source>
        <translation>neu beginnen</translation>
    </message>
    <message>
        <source>a new life with what it has learned</source>
        <translation>ein neues Leben mit dem Gelernten</translation>
    </message>
    <message>
        <source>let it run</source>
        <translation>laufen lassen</translation>
    </message>
    <message>
        <source>push it</source>
        <translation>stoßen</translation>
    </message>
    <message>
        <source>put it somewhere</source>
        <translation>irgendwo platzieren</translation>
    </message>
    <message>
        <source>Teacher: %1</source>
        <translation>Lehrkraft: %1</translation>
    </message>
    <message>
        <source>Answers of the class</source>
        <translation>Antworten des Kurses</translation>
    </message>
    <message>
        <source>No class: answers of a class come in here (Lessons › Class …).</source>
        <translation>Kein Kurs: Hier laufen Antworten eines Kurses ein (Lektionen › Kurs …).</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
    <message>
        <source>Answer: %1</source>
        <translation>Antwort: %1</translation>
    </message>
    <message>
        <source>Hint: %1</source>
        <translation>Tipp: %1</translation>
    </message>
    <message>
        <source>Next: %1 (%2)</source>
        <translation>Danach: %1 (%2)</translation>
    </message>
    <message>
        <source>This is the last step.</source>
        <translation>Dies ist der letzte Schritt.</translation>
    </message>
    <message>
        <source>Ask: %1</source>
        <translation>Frage: %1</translation>
    </message>
    <message>
        <source> of about %1</source>
        <translation> von etwa %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>%1%2</source>
        <translation>%1%2</translation>
    </message>
    <message>
        <source>The class&apos;s folder is gone: %1</source>
        <translation>Der Ordner des Kurses ist verschwunden: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n students, %1</source>
        <translation>
            <numerusform>Lernende: %n, %1</numerusform>
            <numerusform>Lernende: %n, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 have answered. %2</source>
        <translation>Geantwortet haben %1. %2</translation>
    </message>
</context>
<context>
    <name>surefoot::ValueMaps</name>
    <message>
        <source>, never visited</source>
        <translation>, nie besucht</translation>
    </message>
    <message>
        <source>,  risk %1 %</source>
        <translation>,  Risiko %1 %</translation>
    </message>
    <message>
        <source>%1:  Q %2 for %3%5,  %4 visits</source>
        <translation>%1:  Q %2 für %3%5,  %4 Besuche</translation>
    </message>
    <message>
        <source>%1, under caution</source>
        <translation>%1, mit Vorsicht</translation>
    </message>
    <message>
        <source>outlined: the %1 tiles of this state</source>
        <translation>umrandet: die %1 Kacheln dieses Zustands</translation>
    </message>
    <message>
        <source>no step yet</source>
        <translation>kein Schritt</translation>
    </message>
    <message>
        <source>Greedy action</source>
        <translation>Greedy-Aktion</translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risiko</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besuche</translation>
    </message>
    <message>
        <source>Eligibility</source>
        <translation>Eligibility</translation>
    </message>
    <message>
        <source>The map appears with the first steps.</source>
        <translation>Die Karte erscheint mit den ersten Schritten.</translation>
    </message>
    <message>
        <source>contour: threshold %1</source>
        <translation>Höhenlinie: Schwelle %1</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>Schwelle %1</translation>
    </message>
    <message>
        <source>all values below threshold %1</source>
        <translation>alle Werte unter Schwelle %1</translation>
    </message>
    <message>
        <source>all below %1</source>
        <translation>alle unter %1</translation>
    </message>
    <message>
        <source>all values above threshold %1</source>
        <translation>alle Werte über Schwelle %1</translation>
    </message>
    <message>
        <source>all above %1</source>
        <translation>alle über %1</translation>
    </message>
    <message>
        <source>contour: risk %1</source>
        <translation>Höhenlinie: Risiko %1</translation>
    </message>
    <message>
        <source>risk %1</source>
        <translation>Risiko %1</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>gains</source>
        <translation>Gewinne</translation>
    </message>
    <message>
        <source>fall</source>
        <translation>Sturz</translation>
    </message>
    <message>
        <source>losses</source>
        <translation>Verluste</translation>
    </message>
</context>
<context>
    <name>surefoot::ViewMenu</name>
    <message>
        <source>Copy the picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Copy the numbers</source>
        <translation>Zahlen kopieren</translation>
    </message>
    <message>
        <source>Export as %1 …</source>
        <translation>Als %1 exportieren …</translation>
    </message>
    <message>
        <source>The picture is in the clipboard.</source>
        <translation>Das Bild ist in der Zwischenablage.</translation>
    </message>
    <message>
        <source>The numbers are in the clipboard, as CSV.</source>
        <translation>Die Zahlen sind in der Zwischenablage, als CSV.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 exportieren</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
</context>
<context>
    <name>surefoot::WordsBox</name>
    <message>
        <source>Your own words</source>
        <translation>Ihre Worte</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>One answer</source>
        <translation>Musterantwort</translation>
    </message>
    <message>
        <source>Mine says the same</source>
        <translation>Meine sagt dasselbe</translation>
    </message>
    <message>
        <source>kept as it is; the program does not mark it</source>
        <translation>bleibt, wie sie ist; das Programm bewertet sie nicht</translation>
    </message>
</context>
<context>
    <name>surefoot::WordsDialog</name>
    <message>
        <source>Words</source>
        <translation>Begriffe</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the words</source>
        <translation>Begriffe durchsuchen</translation>
    </message>
    <message>
        <source>No word has this in it.</source>
        <translation>Kein Begriff enthält das.</translation>
    </message>
    <message>
        <source>Source: %1.</source>
        <translation>Quelle: %1.</translation>
    </message>
</context>
<context>
    <name>surefoot::WorldView</name>
    <message>
        <source>World</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>taken at random</source>
        <translation>zufällig gewählt</translation>
    </message>
    <message>
        <source>taken as the best</source>
        <translation>als beste gewählt</translation>
    </message>
</context>
</TS>
