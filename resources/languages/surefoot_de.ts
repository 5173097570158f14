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
    <message>
        <source>A coarse value function that is learned first and shapes the rewards.</source>
        <translation>Eine grobe Wertfunktion, die zuerst gelernt wird und dann die Belohnungen formt.</translation>
    </message>
    <message>
        <source>A life</source>
        <translation>Ein Leben</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Aktionen</translation>
    </message>
    <message>
        <source>Begins another life: the table is made anew.</source>
        <translation>Beginnt ein neues Leben: Die Tabelle wird neu angelegt.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>Experimente</translation>
    </message>
    <message>
        <source>Falls that are taken back.</source>
        <translation>Stürze, die zurückgenommen werden.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Has an effect only with {0}.</source>
        <translation>Wirkt nur mit {0}.</translation>
    </message>
    <message>
        <source>Holds at once.</source>
        <translation>Gilt sofort.</translation>
    </message>
    <message>
        <source>Holds from the next episode on.</source>
        <translation>Gilt ab der nächsten Episode.</translation>
    </message>
    <message>
        <source>How rewards are split for Sarsa_2Q</source>
        <translation>Wie Belohnungen für Sarsa_2Q aufgeteilt werden</translation>
    </message>
    <message>
        <source>How values are kept: tiles, radial basis functions, tables. Every state variable has a resolution of its own.</source>
        <translation>Wie Werte gespeichert werden: Kacheln, radiale Basisfunktionen, Tabellen. Jede Zustandsvariable hat ihre eigene Auflösung.</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Methoden</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panels</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Policies</source>
        <translation>Policys</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Presets</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Representation</source>
        <translation>Repräsentation</translation>
    </message>
    <message>
        <source>Rewards: {0}.</source>
        <translation>Belohnungen: {0}.</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Szenarien</translation>
    </message>
    <message>
        <source>Set one with {0}, in the form, or in a plan. A default can be another one in a world that says so; {1} and the form tell.</source>
        <translation>Man stellt sie mit {0}, im Formular oder in einem Plan ein. Eine Welt kann einen anderen Vorgabewert haben; {1} und das Formular zeigen es.</translation>
    </message>
    <message>
        <source>Shaping of rewards</source>
        <translation>Reward Shaping</translation>
    </message>
    <message>
        <source>Source: {0}.</source>
        <translation>Quelle: {0}.</translation>
    </message>
    <message>
        <source>The default is from: {0}.</source>
        <translation>Der Vorgabewert stammt aus: {0}.</translation>
    </message>
    <message>
        <source>The learning and the representation of the expected gains.</source>
        <translation>Das Lernen und die Repräsentation der erwarteten Gewinne.</translation>
    </message>
    <message>
        <source>The learning and the representation of the expected losses.</source>
        <translation>Das Lernen und die Repräsentation der erwarteten Verluste.</translation>
    </message>
    <message>
        <source>The probability that an action ends in a fall, learned beside the values.</source>
        <translation>Die Wahrscheinlichkeit, dass eine Aktion in einem Sturz endet, neben den Werten gelernt.</translation>
    </message>
    <message>
        <source>The risk of a fall</source>
        <translation>Das Sturzrisiko</translation>
    </message>
    <message>
        <source>The window</source>
        <translation>Das Fenster</translation>
    </message>
    <message>
        <source>What the learning rules have in common.</source>
        <translation>Was die Lernregeln gemeinsam haben.</translation>
    </message>
    <message>
        <source>What the policies have, with their schedules and what they do with the risk of a fall.</source>
        <translation>Was die Policys haben, mit ihren Verläufen und dem, was sie mit dem Sturzrisiko tun.</translation>
    </message>
    <message>
        <source>Which part of a reward is a gain and which a loss.</source>
        <translation>Welcher Teil einer Belohnung Gewinn ist und welcher Verlust.</translation>
    </message>
    <message>
        <source>Without a window</source>
        <translation>Ohne Fenster</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Begriffe</translation>
    </message>
    <message>
        <source>Worlds</source>
        <translation>Welten</translation>
    </message>
    <message>
        <source>Your own robot</source>
        <translation>Ihr eigener Roboter</translation>
    </message>
    <message>
        <source>and</source>
        <translation>und</translation>
    </message>
    <message>
        <source>of Sarsa_2Q</source>
        <translation>von Sarsa_2Q</translation>
    </message>
    <message>
        <source>one of {0}; default {1}.</source>
        <translation>{0}; Vorgabe {1}.</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
    <message>
        <source>{0} actions</source>
        <translation>{0} Aktionen</translation>
    </message>
    <message>
        <source>{0} … {1}; default {2}.</source>
        <translation>{0} … {1}; Vorgabe {2}.</translation>
    </message>
    <message>
        <source>Handbook</source>
        <translation>Handbuch</translation>
    </message>
</context>
<context>
    <name>lessons</name>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>**Q(S, A)** is what it expects of action A in state S; at first 0. A step corrects one value by **α δ**, with α = 0.5. The surprise, or TD error, is **δ = R + γ Q(S′, A′) − Q(S, A)**: R is the reward, S′ and A′ the next state and action. Watch until the first goal.</source>
        <translation>**Q(S, A)** ist, was er von Aktion A in Zustand S erwartet; anfangs 0. Ein Schritt korrigiert einen Wert um **α δ**, mit α = 0,5. Die Überraschung, der TD-Fehler, ist **δ = R + γ Q(S′, A′) − Q(S, A)**: R ist die Belohnung, S′ und A′ sind der nächste Zustand und die nächste Aktion. Sehen Sie bis zum ersten Ziel zu.</translation>
    </message>
    <message>
        <source>**Sarsa** learns from what it does: it values a step by the step that it really takes next, also a random one. It learns for 500 episodes with ε = 0.1. Then exploring and learning stop, and the steps of its way are counted. The short way has 13, the long one 17.</source>
        <translation>**Sarsa** lernt aus dem, was es tut: Es bewertet einen Schritt nach dem, den es danach wirklich geht, auch einem zufälligen. Es lernt 500 Episoden mit ε = 0,1. Dann enden Explorieren und Lernen, und die Schritte seines Weges werden gezählt. Der kurze hat 13, der lange 17.</translation>
    </message>
    <message>
        <source>**TRL**, threshold-restricted learning, explores as often as ε-greedy with the same ε: here in one step of five. But then it draws almost only among the actions that are worth more than a threshold. Drag the line across the bars, and watch how likely each action is.</source>
        <translation>**TRL**, threshold-restricted learning, exploriert so oft wie ε-greedy mit demselben ε: hier in einem von fünf Schritten. Aber dann lost es fast nur unter den Aktionen, die mehr wert sind als eine Schwelle. Ziehen Sie die Linie über die Balken und sehen Sie, wie wahrscheinlich jede Aktion ist.</translation>
    </message>
    <message>
        <source>**Tile coding** lays 16 grids over each other, each displaced a little; a value is the sum over 16 tiles. Here each of the 16 has resolution 1. Compare it with one grid of resolution 2. Ten lives of each, six minutes from nothing.</source>
        <translation>**Tile Coding** legt 16 Gitter übereinander, jedes etwas versetzt; ein Wert ist die Summe über 16 Kacheln. Hier hat jedes der 16 die Auflösung 1. Vergleichen Sie es mit einem Gitter der Auflösung 2. Je zehn Leben, sechs Minuten von null an.</translation>
    </message>
    <message>
        <source>**{observed(5)} falls** in ten minutes with ε = 0.05. Now the same again, from the same knowledge, but **greedy**: it always takes the action that it thinks best, and still learns.</source>
        <translation>**{observed(5)} Stürze** in zehn Minuten mit ε = 0,05. Jetzt dasselbe noch einmal, mit demselben Wissen, aber **greedy**: Er nimmt immer die Aktion, die er für die beste hält, und lernt weiter.</translation>
    </message>
    <message>
        <source>0.98 to the power of 35 is about one half; 70 is twice 35.</source>
        <translation>0,98 hoch 35 ist etwa die Hälfte; 70 ist zweimal 35.</translation>
    </message>
    <message>
        <source>16 grids of 1</source>
        <translation>16 Gitter von 1</translation>
    </message>
    <message>
        <source>2.5 times the torque is a larger error than half the torque. The fair comparison for half is **twice**. Ten lives of each, after simulations with × 0.5 and with × 2.</source>
        <translation>Das 2,5-fache Drehmoment ist ein größerer Fehler als das halbe. Der faire Vergleich für die Hälfte ist **das Doppelte**. Je zehn Leben, nach Simulationen mit × 0,5 und mit × 2.</translation>
    </message>
    <message>
        <source>5 of 100 are 1 of 20.</source>
        <translation>5 von 100 sind 1 von 20.</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>A **trace** marks each step, and a step learns in proportion to its mark. With every later step all marks are multiplied by γ λ, here 0.9 · 0.9 = 0.81. The same walk, with the trace: the last step loses 50. The step before it was *left* from state 3.</source>
        <translation>Ein **Trace** markiert jeden Schritt, und ein Schritt lernt so viel, wie seine Marke stark ist. Mit jedem weiteren Schritt werden alle Marken mit γ λ multipliziert, hier 0,9 · 0,9 = 0,81. Derselbe Weg mit dem Trace: Der letzte Schritt verliert 50. Der Schritt davor war *links* von Zustand 3.</translation>
    </message>
    <message>
        <source>A Sarsa without random steps takes the short way, too. There is another remedy: Q-learning again, with ε = 0.1, which fell {observed(4)} times. Beside its values it now learns **ρ**, how likely an action ends in a fall, and a random step may only take actions whose risk is at most 20 %.</source>
        <translation>Auch ein Sarsa ohne zufällige Schritte nimmt den kurzen Weg. Es gibt ein anderes Mittel: wieder Q-learning, mit ε = 0,1, das {observed(4)}-mal stürzte. Neben seinen Werten lernt es nun **ρ**, wie wahrscheinlich eine Aktion im Sturz endet, und ein zufälliger Schritt darf nur Aktionen mit höchstens 20 % Risiko nehmen.</translation>
    </message>
    <message>
        <source>A detour costs nothing: left is worth 100 · γ = 100, as much as right.</source>
        <translation>Ein Umweg kostet nichts: Links ist 100 · γ = 100 wert, so viel wie rechts.</translation>
    </message>
    <message>
        <source>A fair comparison: with greedy, and with a smaller ε.</source>
        <translation>Einen fairen Vergleich: mit greedy und mit einem kleineren ε.</translation>
    </message>
    <message>
        <source>A fall teaches only the few states in its own tiles.</source>
        <translation>Ein Sturz lehrt nur die wenigen Zustände in seinen eigenen Kacheln etwas.</translation>
    </message>
    <message>
        <source>A full turn has 360°. Into how many tiles is it cut?</source>
        <translation>Eine volle Drehung hat 360°. In wie viele Kacheln ist sie geteilt?</translation>
    </message>
    <message>
        <source>A full turn has 360°. There are 0.4 times as many tiles.</source>
        <translation>Eine volle Drehung hat 360°. Es gibt 0,4-mal so viele Kacheln.</translation>
    </message>
    <message>
        <source>A goal is shared out like a fall. First without a trace, **λ = 0**, from the beginning. The robot lives until two things hold: it stands on state 5, five steps from the goal, and *right* is worth more than 0 there.</source>
        <translation>Ein Ziel wird verteilt wie ein Sturz. Zuerst ohne Trace, **λ = 0**, von Anfang an. Der Roboter lebt, bis zweierlei gilt: Er steht auf Zustand 5, fünf Schritte vom Ziel, und *rechts* ist dort mehr als 0 wert.</translation>
    </message>
    <message>
        <source>A life with more chance</source>
        <translation>Ein Leben mit mehr Zufall</translation>
    </message>
    <message>
        <source>A limit on the risk of a fall</source>
        <translation>Eine Grenze für das Sturzrisiko</translation>
    </message>
    <message>
        <source>A line you drag</source>
        <translation>Eine Linie zum Ziehen</translation>
    </message>
    <message>
        <source>A loss is expected sooner. Can it also be expected where there is no danger?</source>
        <translation>Ein Verlust wird früher erwartet. Kann er auch erwartet werden, wo keine Gefahr ist?</translation>
    </message>
    <message>
        <source>A loss should be expected also near the place of a fall: wide tiles spread it. The goal is small, and what leads to it has to be told apart finely, or it is reached less often. Tiles that are too wide spread the loss even to the upright pole.</source>
        <translation>Ein Verlust soll auch nahe der Stelle eines Sturzes erwartet werden: Breite Kacheln verbreiten ihn. Das Ziel ist klein, und was zu ihm führt, muss fein unterschieden werden, sonst wird es seltener erreicht. Zu breite Kacheln tragen den Verlust bis zum aufrechten Stab.</translation>
    </message>
    <message>
        <source>A mark on the curve is a fall; a click plays it back.</source>
        <translation>Eine Marke an der Kurve ist ein Sturz; ein Klick spielt ihn ab.</translation>
    </message>
    <message>
        <source>A narrower interval, of 99 %.</source>
        <translation>Ein engeres Intervall, von 99 %.</translation>
    </message>
    <message>
        <source>A paper reports the best of five runs. What is wrong with that?</source>
        <translation>Ein Artikel berichtet den besten von fünf Läufen. Was ist daran falsch?</translation>
    </message>
    <message>
        <source>A place it knows nothing about</source>
        <translation>Ein Ort, von dem er nichts weiß</translation>
    </message>
    <message>
        <source>A pole is hinged to a cart. 200 times a second the robot chooses one of five torques (turning forces) for the cart&apos;s wheel; the arrow shows it. An **episode** ends when the pole stands upright and still, or when it has fallen. This robot has learned nothing yet. Slow it down with the pace.</source>
        <translation>Auf einem Wagen sitzt ein Stab an einem Gelenk. 200-mal in der Sekunde wählt der Roboter eines von fünf Drehmomenten für das Rad des Wagens; der Pfeil zeigt es. Eine **Episode** endet, wenn der Stab aufrecht stillsteht oder wenn er umgefallen ist. Dieser Roboter hat noch nichts gelernt. Verlangsamen Sie ihn mit dem Tempo.</translation>
    </message>
    <message>
        <source>A pole on a cart, and a program that has never seen one. You watch it, take the pole in your hand, say how often it will fall, and look at its falls again.</source>
        <translation>Ein Stab auf einem Wagen, und ein Programm, das so etwas noch nie gesehen hat. Sie sehen zu, nehmen den Stab selbst in die Hand, sagen, wie oft er stürzen wird, und sehen sich seine Stürze noch einmal an.</translation>
    </message>
    <message>
        <source>A pole that is upright but moves fast leans a moment later. Where it is and how fast it moves both count.</source>
        <translation>Ein Stab, der aufrecht steht, sich aber schnell bewegt, ist einen Moment später schief. Wo er ist und wie schnell er sich bewegt, zählt beides.</translation>
    </message>
    <message>
        <source>A pole that leans by 1° shares its tile with one that leans by 50° to the same side: wide tiles tell little apart. It fell {observed(1)} times. Now the resolution is **8**, a tile 3.75° wide. Again two minutes from nothing.</source>
        <translation>Ein Stab, der um 1° geneigt ist, teilt seine Kachel mit einem, der um 50° zur selben Seite geneigt ist: Breite Kacheln unterscheiden wenig. Er stürzte {observed(1)}-mal. Jetzt ist die Auflösung **8**, eine Kachel 3,75° breit. Wieder zwei Minuten von null an.</translation>
    </message>
    <message>
        <source>A reward that lies further away counts less: with each step that it is further away it is multiplied by **γ** (gamma), here 0.9. From state 9 one step gives 100, so state 9 is worth 100. State 8 lies one step further away: 0.9 · 100 = 90. The robot stands on state 6.</source>
        <translation>Eine Belohnung, die weiter entfernt liegt, zählt weniger: Mit jedem Schritt Entfernung wird sie mit **γ** (Gamma) multipliziert, hier 0,9. Von Zustand 9 gibt ein Schritt 100, also ist Zustand 9 100 wert. Zustand 8 liegt einen Schritt weiter weg: 0,9 · 100 = 90. Der Roboter steht auf Zustand 6.</translation>
    </message>
    <message>
        <source>A robot can try any action now and then, or take the better ones more often. The second way has one knob, the temperature. You turn it, let both ways explore equally often, and count their falls.</source>
        <translation>Ein Roboter kann ab und zu irgendeine Aktion probieren oder die besseren öfter nehmen. Die zweite Art hat einen Regler, die Temperatur. Sie drehen daran, lassen beide Arten gleich oft explorieren und zählen ihre Stürze.</translation>
    </message>
    <message>
        <source>A robot cannot try every state. It cuts them into tiles and learns values for each. How wide should a tile be? You try both ends, look for the middle, and then see a way out.</source>
        <translation>Ein Roboter kann nicht jeden Zustand probieren. Er teilt sie in Kacheln und lernt Werte für jede. Wie breit soll eine Kachel sein? Sie probieren beide Enden, suchen die Mitte und sehen dann einen Ausweg.</translation>
    </message>
    <message>
        <source>A robot falls. Which of its steps was to blame: the last one, or those that led there? λ shares the blame out. You work out one share, find a step that is blamed wrongly, and see what the sharing is good for.</source>
        <translation>Ein Roboter stürzt. Welcher seiner Schritte war schuld: der letzte oder die, die dorthin führten? λ verteilt die Schuld. Sie rechnen einen Anteil aus, finden einen Schritt, der zu Unrecht beschuldigt wird, und sehen, wozu das Verteilen gut ist.</translation>
    </message>
    <message>
        <source>A robot has fallen many times and still expects no loss just before the next fall. Give its losses a Q-function of their own, and choose how far from a fall it is felt.</source>
        <translation>Ein Roboter ist schon oft gestürzt und erwartet kurz vor dem nächsten Sturz immer noch keinen Verlust. Geben Sie seinen Verlusten eine eigene Q-Funktion und wählen Sie, wie weit weg ein Sturz zu spüren ist.</translation>
    </message>
    <message>
        <source>A robot that cannot walk</source>
        <translation>Ein Roboter, der nicht gehen kann</translation>
    </message>
    <message>
        <source>A robot that has learned in a simulation meets reality. It still tries something else now and then. How often is that good for it?</source>
        <translation>Ein Roboter, der in einer Simulation gelernt hat, trifft auf die Wirklichkeit. Ab und zu probiert er noch etwas anderes. Wie oft tut ihm das gut?</translation>
    </message>
    <message>
        <source>A robot that knows nothing learns in reality for 200 episodes. Look how often it falls; each fall may break something. In a simulation nothing breaks. So let it fall there first.</source>
        <translation>Ein Roboter, der nichts weiß, lernt 200 Episoden in der Wirklichkeit. Sehen Sie, wie oft er stürzt; jeder Sturz kann etwas kaputt machen. In einer Simulation geht nichts kaputt. Lassen Sie ihn also zuerst dort stürzen.</translation>
    </message>
    <message>
        <source>A rule of thumb</source>
        <translation>Eine Faustregel</translation>
    </message>
    <message>
        <source>A second thing to learn</source>
        <translation>Etwas Zweites zu lernen</translation>
    </message>
    <message>
        <source>A share of the blame</source>
        <translation>Ein Teil der Schuld</translation>
    </message>
    <message>
        <source>A simulation with strong motors</source>
        <translation>Eine Simulation mit starken Motoren</translation>
    </message>
    <message>
        <source>A simulation with weak motors</source>
        <translation>Eine Simulation mit schwachen Motoren</translation>
    </message>
    <message>
        <source>A step costs 1 for both of them.</source>
        <translation>Ein Schritt kostet für beide 1.</translation>
    </message>
    <message>
        <source>A step that is blamed</source>
        <translation>Ein Schritt, der beschuldigt wird</translation>
    </message>
    <message>
        <source>A threshold of 50</source>
        <translation>Eine Schwelle von 50</translation>
    </message>
    <message>
        <source>A tile of Q⁻ is 124° wide now. What else is in the tile in which it fell?</source>
        <translation>Eine Kachel von Q⁻ ist jetzt 124° breit. Was liegt sonst noch in der Kachel, in der er stürzte?</translation>
    </message>
    <message>
        <source>A torque to the right pushes the cart to the right, under a pole that leans to the right.</source>
        <translation>Ein Drehmoment nach rechts schiebt den Wagen nach rechts, unter einen Stab, der sich nach rechts neigt.</translation>
    </message>
    <message>
        <source>A trace knows how long ago a step was taken, not whether it was to blame.</source>
        <translation>Ein Trace weiß, wie lange ein Schritt her ist, nicht, ob er schuld war.</translation>
    </message>
    <message>
        <source>A value with a small α is a mean over many steps; with a large one the last few steps decide.</source>
        <translation>Ein Wert mit kleinem α ist ein Mittel über viele Schritte; mit großem entscheiden die letzten paar.</translation>
    </message>
    <message>
        <source>A, thirty</source>
        <translation>A, dreißig</translation>
    </message>
    <message>
        <source>About the same.</source>
        <translation>Etwa dasselbe.</translation>
    </message>
    <message>
        <source>Above the line</source>
        <translation>Über der Linie</translation>
    </message>
    <message>
        <source>After 100 episodes it is {observed(5)}: what comes is what it expects, and the value stays. α decides how quickly it gets there. Turn α, and start again after each try. With the same **seed** chance is the same, so the robot walks to its first goal in the same way.</source>
        <translation>Nach 100 Episoden ist er {observed(5)}: Es kommt, was er erwartet, und der Wert bleibt. α bestimmt, wie schnell es so weit ist. Drehen Sie an α und starten Sie nach jedem Versuch neu. Mit demselben **Seed** ist der Zufall derselbe; der Roboter geht also auf dieselbe Weise zu seinem ersten Ziel.</translation>
    </message>
    <message>
        <source>After 200 episodes</source>
        <translation>Nach 200 Episoden</translation>
    </message>
    <message>
        <source>After half the torque it fell less often than after twice the torque. Is weaker always better? Three more simulations: 0.3, 0.8 and 1.5 times the real torque.</source>
        <translation>Nach dem halben Drehmoment stürzte er seltener als nach dem doppelten. Ist schwächer immer besser? Drei weitere Simulationen: das 0,3-, 0,8- und 1,5-fache des wirklichen Drehmoments.</translation>
    </message>
    <message>
        <source>All actions of a state share what happens there.</source>
        <translation>Alle Aktionen eines Zustands teilen, was dort geschieht.</translation>
    </message>
    <message>
        <source>All learning here is one small correction, made after every step. You work it out by hand twice, with easy numbers, and then let the robot do it. Then you turn α, the size of the correction.</source>
        <translation>Alles Lernen ist hier eine kleine Korrektur nach jedem Schritt. Sie rechnen sie zweimal von Hand aus, mit einfachen Zahlen, und lassen es dann den Roboter tun. Danach drehen Sie an α, der Größe der Korrektur.</translation>
    </message>
    <message>
        <source>All ten lives of Q-learning walk along the edge, all ten of Sarsa keep off it. For a robot that makes no mistakes the short way is better. But while they learn, both take one step in ten at random. This Sarsa fell {falls} times in its 500 episodes.</source>
        <translation>Alle zehn Leben von Q-learning gehen am Rand entlang, alle zehn von Sarsa halten Abstand. Für einen Roboter, der keine Fehler macht, ist der kurze Weg besser. Aber beim Lernen gehen beide einen von zehn Schritten zufällig. Dieses Sarsa stürzte in seinen 500 Episoden {falls}-mal.</translation>
    </message>
    <message>
        <source>All values were 0. What is Q(3, left) after the fall?</source>
        <translation>Alle Werte waren 0. Wie groß ist Q(3, links) nach dem Sturz?</translation>
    </message>
    <message>
        <source>Among how many actions does it choose each time?</source>
        <translation>Unter wie vielen Aktionen wählt er jedes Mal?</translation>
    </message>
    <message>
        <source>An action that is worth τ less than the best is taken 2.7 times less often; one worth 2τ less, 7.4 times. Before, the second best was worth {observed(1)} less. Now the pole leans by 14° and is at rest: the best is worth {q(&quot;1.5&quot;)}, the second best {max(q(&quot;0.75&quot;), q(&quot;0&quot;))}.</source>
        <translation>Eine Aktion, die τ weniger wert ist als die beste, wird 2,7-mal so selten gewählt; eine, die 2τ weniger wert ist, 7,4-mal. Vorhin war die zweitbeste {observed(1)} weniger wert. Jetzt ist der Stab um 14° geneigt und ruht: Die beste ist {q(&quot;1.5&quot;)} wert, die zweitbeste {max(q(&quot;0.75&quot;), q(&quot;0&quot;))}.</translation>
    </message>
    <message>
        <source>An action with a risk of 1 in 100 now counts 30 less.</source>
        <translation>Eine Aktion mit einem Risiko von 1 zu 100 zählt jetzt 30 weniger.</translation>
    </message>
    <message>
        <source>An interval of 99 % is wider, and the difference is not what is in doubt.</source>
        <translation>Ein Intervall von 99 % ist breiter, und am Unterschied wird nicht gezweifelt.</translation>
    </message>
    <message>
        <source>Another robot</source>
        <translation>Ein anderer Roboter</translation>
    </message>
    <message>
        <source>As far-sighted as can be</source>
        <translation>So weitsichtig wie möglich</translation>
    </message>
    <message>
        <source>As long as it explores near something that can break it: Sarsa, because it counts its own random steps and keeps away. If it can learn where falls cost nothing, and afterwards stops exploring: Q-learning, whose way is shorter.</source>
        <translation>Solange er nahe an etwas exploriert, das ihn kaputt machen kann: Sarsa, weil es seine eigenen zufälligen Schritte mitrechnet und Abstand hält. Wenn er dort lernen kann, wo Stürze nichts kosten, und danach nicht mehr exploriert: Q-learning, dessen Weg kürzer ist.</translation>
    </message>
    <message>
        <source>As short-sighted as can be</source>
        <translation>So kurzsichtig wie möglich</translation>
    </message>
    <message>
        <source>Ask for a show of hands before every answer. In step 1 expect votes for A. Say openly how the numbers were come by: the seed of B was looked for among 28 (3 of them differ from A by more than 3.5 falls in five lives; no interval left out 0). Seed 1 was taken for all else because it shows how five lives go wrong both ways. In the seeds 1 to 60 five lives gave an interval without 0 for Softmax against greedy twice, thirty lives four times (always for greedy); ε 0.05 against Softmax left out 0 with thirty lives in all 60, with five in 23. Step 7: in 8 seeds ten pairs told ε 0.05 from 0.1 in 6, ten against ten others in 2; with twenty it was 8 and 3. The interval is that of the mean difference of life k and life k, by Student&apos;s t.</source>
        <translation>Bitten Sie vor jeder Antwort um Handzeichen. Erwarten Sie in Schritt 1 Stimmen für A. Sagen Sie offen, woher die Zahlen kommen: Der Seed von B wurde unter 28 gesucht (3 davon unterscheiden sich von A in fünf Leben um mehr als 3,5 Stürze; kein Intervall schloss die 0 aus). Seed 1 wurde für alles andere genommen, weil er zeigt, wie fünf Leben in beide Richtungen irren. In den Seeds 1 bis 60 ergaben fünf Leben für Softmax gegen greedy zweimal ein Intervall ohne 0, dreißig Leben viermal (immer für greedy); ε 0,05 gegen Softmax schloss mit dreißig Leben in allen 60 die 0 aus, mit fünf in 23. Schritt 7: In 8 Seeds unterschieden zehn Paare ε 0,05 von 0,1 in 6, zehn gegen zehn andere in 2; mit zwanzig waren es 8 und 3. Das Intervall ist das des mittleren Unterschieds von Leben k und Leben k, nach Students t.</translation>
    </message>
    <message>
        <source>At least four steps in five take the best action, wherever the line lies.</source>
        <translation>Mindestens vier von fünf Schritten nehmen die beste Aktion, wo immer die Linie liegt.</translation>
    </message>
    <message>
        <source>At which value of Q(9, right) is δ = 100 − Q(9, right) zero?</source>
        <translation>Bei welchem Wert von Q(9, rechts) ist δ = 100 − Q(9, rechts) null?</translation>
    </message>
    <message>
        <source>At which τ would the second best be taken 2.7 times less often than the best, here?</source>
        <translation>Bei welchem τ würde hier die zweitbeste 2,7-mal so selten gewählt wie die beste?</translation>
    </message>
    <message>
        <source>Average falls in six minutes: all fine {mean(&quot;Q⁻ 1&quot;)}; only Q⁻ coarse {mean(&quot;only Q⁻ coarse&quot;)}; both coarse {mean(&quot;both coarse&quot;)}; Q⁻ far too coarse {mean(&quot;Q⁻ 0.1&quot;)}. Goals reached in three minutes: only Q⁻ coarse {mean(&quot;goals, only Q⁻ coarse&quot;)}, both coarse {mean(&quot;goals, both coarse&quot;)}.</source>
        <translation>Mittlere Stürze in sechs Minuten: alles fein {mean(&quot;Q⁻ 1&quot;)}; nur Q⁻ grob {mean(&quot;only Q⁻ coarse&quot;)}; beide grob {mean(&quot;both coarse&quot;)}; Q⁻ viel zu grob {mean(&quot;Q⁻ 0.1&quot;)}. Erreichte Ziele in drei Minuten: nur Q⁻ grob {mean(&quot;goals, only Q⁻ coarse&quot;)}, beide grob {mean(&quot;goals, both coarse&quot;)}.</translation>
    </message>
    <message>
        <source>Average falls in six minutes: one grid of resolution 2, {mean(&quot;one grid of 2&quot;)}; 16 displaced grids of resolution 1, {mean(&quot;16 grids of 1&quot;)}.</source>
        <translation>Mittlere Stürze in sechs Minuten: ein Gitter der Auflösung 2, {mean(&quot;one grid of 2&quot;)}; 16 versetzte Gitter der Auflösung 1, {mean(&quot;16 grids of 1&quot;)}.</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B, thirty</source>
        <translation>B, dreißig</translation>
    </message>
    <message>
        <source>Because only falls teach where falls are. A robot that is careful in the simulation sees few of them, and its risk is wrong in the places where it never was. In simulation falls are information that costs nothing; in reality they cost.</source>
        <translation>Weil nur Stürze lehren, wo Stürze sind. Ein Roboter, der in der Simulation vorsichtig ist, sieht wenige davon, und sein Risiko ist dort falsch, wo er nie war. In der Simulation sind Stürze Information, die nichts kostet; in der Wirklichkeit kosten sie.</translation>
    </message>
    <message>
        <source>Before the next fall</source>
        <translation>Vor dem nächsten Sturz</translation>
    </message>
    <message>
        <source>Below all values it forbids nothing; above all values it has nothing to allow.</source>
        <translation>Unter allen Werten verbietet sie nichts; über allen Werten hat sie nichts zu erlauben.</translation>
    </message>
    <message>
        <source>Between which two temperatures does the share pass 8?</source>
        <translation>Zwischen welchen zwei Temperaturen überschreitet der Anteil 8?</translation>
    </message>
    <message>
        <source>Bold in both worlds</source>
        <translation>Kühn in beiden Welten</translation>
    </message>
    <message>
        <source>Bold in simulation, careful in reality</source>
        <translation>Kühn in der Simulation, vorsichtig in der Wirklichkeit</translation>
    </message>
    <message>
        <source>Both are worth 0: with γ = 0 nothing of the goal reaches these states, and so it tosses a coin.</source>
        <translation>Beide sind 0 wert: Mit γ = 0 erreicht nichts vom Ziel diese Zustände, und so wirft er eine Münze.</translation>
    </message>
    <message>
        <source>Both are wrong about this state, but only one of the two errors is a warning.</source>
        <translation>Beide irren sich über diesen Zustand, aber nur einer der zwei Irrtümer ist eine Warnung.</translation>
    </message>
    <message>
        <source>Both begin with what the same simulation has taught them.</source>
        <translation>Beide beginnen mit dem, was dieselbe Simulation sie gelehrt hat.</translation>
    </message>
    <message>
        <source>Both explore equally often. Which falls less?</source>
        <translation>Beide explorieren gleich oft. Welcher stürzt seltener?</translation>
    </message>
    <message>
        <source>Both learned for ten minutes.</source>
        <translation>Beide haben zehn Minuten gelernt.</translation>
    </message>
    <message>
        <source>Both leave the best action about equally often; τ was chosen so.</source>
        <translation>Beide weichen etwa gleich oft von der besten Aktion ab; τ ist so gewählt.</translation>
    </message>
    <message>
        <source>Both leave the best action equally often. The left robot then does just anything, even what makes it fall. The right one seldom does what it knows to be bad.</source>
        <translation>Beide weichen gleich oft von der besten Aktion ab. Der linke Roboter tut dann irgendetwas, auch was ihn stürzen lässt. Der rechte tut selten, was er als schlecht kennt.</translation>
    </message>
    <message>
        <source>Both take an action other than the best in about 8 of 100 steps. Why does Softmax fall less?</source>
        <translation>Beide nehmen in etwa 8 von 100 Schritten eine andere Aktion als die beste. Warum stürzt Softmax seltener?</translation>
    </message>
    <message>
        <source>By how much is the second best worth less than the best?</source>
        <translation>Um wie viel ist die zweitbeste weniger wert als die beste?</translation>
    </message>
    <message>
        <source>Can the widest tiles tell a pole at 1° from one at 50°?</source>
        <translation>Können die breitesten Kacheln einen Stab bei 1° von einem bei 50° unterscheiden?</translation>
    </message>
    <message>
        <source>Careful by the risk.</source>
        <translation>Vorsichtig durch das Risiko.</translation>
    </message>
    <message>
        <source>Choose α so that Q(9, right) is 100 after a single goal, and let the robot come to state 9 again.</source>
        <translation>Wählen Sie α so, dass Q(9, rechts) nach einem einzigen Ziel 100 ist, und lassen Sie den Roboter noch einmal auf Zustand 9 kommen.</translation>
    </message>
    <message>
        <source>Click a fall among the last twenty episodes, and watch the arrow.</source>
        <translation>Klicken Sie auf einen Sturz in den letzten zwanzig Episoden und achten Sie auf den Pfeil.</translation>
    </message>
    <message>
        <source>Click a state about which it has learned nothing.</source>
        <translation>Klicken Sie auf einen Zustand, über den er nichts gelernt hat.</translation>
    </message>
    <message>
        <source>Click a state that is still worth more than 0 with γ = 0.</source>
        <translation>Klicken Sie auf einen Zustand, der auch mit γ = 0 noch mehr als 0 wert ist.</translation>
    </message>
    <message>
        <source>Coarser is not always better. Try values between 0.2 and 0.35.</source>
        <translation>Gröber ist nicht immer besser. Probieren Sie Werte zwischen 0,2 und 0,35.</translation>
    </message>
    <message>
        <source>Coarser still</source>
        <translation>Noch gröber</translation>
    </message>
    <message>
        <source>Compare each life with the one of the same seed: how many go the other way?</source>
        <translation>Vergleichen Sie jedes Leben mit dem desselben Seeds: Bei wie vielen ist es umgekehrt?</translation>
    </message>
    <message>
        <source>Compare the line at −100, at 80 and at 200.</source>
        <translation>Vergleichen Sie die Linie bei −100, bei 80 und bei 200.</translation>
    </message>
    <message>
        <source>Could the robot use a large α at first and a small one later?</source>
        <translation>Könnte der Roboter anfangs ein großes und später ein kleines α verwenden?</translation>
    </message>
    <message>
        <source>Could weak motors bring the pole up from 29° as well as strong ones?</source>
        <translation>Könnten schwache Motoren den Stab von 29° aus so gut aufrichten wie starke?</translation>
    </message>
    <message>
        <source>Do step 2 and 3 on the board, with everybody&apos;s numbers. Errors to expect: to add the whole surprise (100 instead of 75), and in step 3 to forget γ (37.5) or to forget α (60).

The first walk is the same for all: from state 2 to the goal in eight steps. Only its last step teaches anything; the next lesson asks whether that must be so.

Step 4 shows who thinks that values hang together. They are separate numbers, and each is corrected only when its own step is taken.

Step 7: the 20 lives have the same seeds for both α. The rule is Sarsa: A′ is the action that is really taken next, so half of the time it is drawn at random. The measure is Q(8, right) when learning has stopped: for this each life is put on state 7 and goes one step.</source>
        <translation>Machen Sie Schritt 2 und 3 an der Tafel, mit den Zahlen aller. Zu erwartende Fehler: die ganze Überraschung addieren (100 statt 75), in Schritt 3 γ vergessen (37,5) oder α vergessen (60).

Der erste Weg ist für alle derselbe: von Zustand 2 in acht Schritten zum Ziel. Nur sein letzter Schritt lehrt etwas; die nächste Lektion fragt, ob das so sein muss.

Schritt 4 zeigt, wer glaubt, dass Werte zusammenhängen. Es sind getrennte Zahlen, und jede wird nur korrigiert, wenn ihr eigener Schritt getan wird.

Schritt 7: Die 20 Leben haben für beide α dieselben Seeds. Die Regel ist Sarsa: A′ ist die Aktion, die als Nächstes wirklich gewählt wird, also in der Hälfte der Fälle ausgelost. Gemessen wird Q(8, rechts), wenn das Lernen beendet ist: Dafür wird jedes Leben auf Zustand 7 gesetzt und geht einen Schritt.</translation>
    </message>
    <message>
        <source>Does that help? First six minutes of learning from nothing, with the same resolution 1 for both. Two such Q-functions act like a single one.</source>
        <translation>Hilft das? Zuerst sechs Minuten Lernen von null an, mit derselben Auflösung 1 für beide. Zwei solche Q-Funktionen wirken wie eine einzige.</translation>
    </message>
    <message>
        <source>Each episode ends in one of two ways. Which of the two is easier to reach by chance?</source>
        <translation>Jede Episode endet auf eine von zwei Arten. Welche davon erreicht man durch Zufall leichter?</translation>
    </message>
    <message>
        <source>Each motor has seven voltages, whatever the others do.</source>
        <translation>Jeder Motor hat sieben Spannungen, was immer die anderen tun.</translation>
    </message>
    <message>
        <source>Each step corrects one value, that of the step just taken. Look at the last step.</source>
        <translation>Jeder Schritt korrigiert einen Wert, nämlich den des Schritts, der gerade getan wurde. Sehen Sie den letzten Schritt an.</translation>
    </message>
    <message>
        <source>Each step now costs 1. Is γ = 1 still a bad choice?</source>
        <translation>Jeder Schritt kostet jetzt 1. Ist γ = 1 immer noch eine schlechte Wahl?</translation>
    </message>
    <message>
        <source>Each tile has to be learned by itself, and a fall is what teaches a bad one.</source>
        <translation>Jede Kachel muss für sich gelernt werden, und was eine schlechte lehrt, ist ein Sturz.</translation>
    </message>
    <message>
        <source>Every step costs 1. A step into the cliff costs 100 and leads back to the start. The short way, along the edge, has 13 steps; the long way, along the top, has 17. The robot has lived 20 episodes. A click on the map puts it on a square.</source>
        <translation>Jeder Schritt kostet 1. Ein Schritt über die Klippe kostet 100 und führt an den Start zurück. Der kurze Weg am Rand hat 13 Schritte, der lange, oben herum, 17. Der Roboter hat 20 Episoden gelebt. Ein Klick auf die Karte setzt ihn auf ein Feld.</translation>
    </message>
    <message>
        <source>Every student has a seed of his own, so the numbers differ a little. Expect to hear that narrow tiles are better because they are more exact; let them vote before step 2. In step 4 1, 2 and 4 all do: in 90 lives they fell 202 to 386 times in six minutes, 0.25 463 to 659 times. Ask for the winner by falls in two minutes (1) and after three more (4): there is no best width without saying when. Measured with the seeds 1 to 10, ten lives each: first two minutes 0.25 186 to 200 falls, 1 118 to 137, 4 173 to 196, 8 329 to 345; after three minutes of learning (seeds 1 to 7) 178 to 193, 75 to 90, 44 to 58, 140 to 154. Six minutes: one grid of 2 248 to 287, 16 grids of 1 190 to 218; the interval said so in 10 of 10. In six minutes one grid of 1 or 4 falls about as often as one of 2.</source>
        <translation>Alle haben einen eigenen Seed, die Zahlen unterscheiden sich also etwas. Erwarten Sie, dass schmale Kacheln besser seien, weil sie genauer sind; lassen Sie vor Schritt 2 abstimmen. In Schritt 4 genügen 1, 2 und 4: In 90 Leben stürzten sie in sechs Minuten 202- bis 386-mal, 0,25 463- bis 659-mal. Fragen Sie nach dem Sieger bei Stürzen in zwei Minuten (1) und nach drei weiteren (4): Es gibt keine beste Breite, ohne zu sagen, wann. Gemessen mit den Seeds 1 bis 10, je zehn Leben: erste zwei Minuten 0,25 186 bis 200 Stürze, 1 118 bis 137, 4 173 bis 196, 8 329 bis 345; nach drei Minuten Lernen (Seeds 1 bis 7) 178 bis 193, 75 bis 90, 44 bis 58, 140 bis 154. Sechs Minuten: ein Gitter von 2 248 bis 287, 16 Gitter von 1 190 bis 218; das Intervall sagte das in 10 von 10. In sechs Minuten stürzt ein Gitter von 1 oder 4 etwa so oft wie eines von 2.</translation>
    </message>
    <message>
        <source>Every way to the goal is worth 100, a long one as well.</source>
        <translation>Jeder Weg zum Ziel ist 100 wert, auch ein langer.</translation>
    </message>
    <message>
        <source>Everything coarse</source>
        <translation>Alles grob</translation>
    </message>
    <message>
        <source>Expect to hear &quot;Softmax falls less because it explores less&quot;. Let them vote before step 5 and write the votes down. Step 4 takes that answer away: both leave the best action in 8 of 100 steps. Measured with the seeds 1 to 16, ten lives each: ε 0.1 falls 13 to 24 times, Softmax τ 1.5 2 to 5, greedy 2 to 5. The interval of the difference between ε-greedy and Softmax never held 0, that between greedy and Softmax did in 15 of 16. With τ 10 Softmax falls 76 times, with τ 100 193 times (seeds 1, 2). Do not let them say that Softmax explores where the pole is upright: it leaves the best action wherever another is nearly as good, and that is so at all angles.</source>
        <translation>Erwarten Sie: „Softmax stürzt weniger, weil es weniger exploriert.“ Lassen Sie vor Schritt 5 abstimmen und schreiben Sie die Stimmen auf. Schritt 4 nimmt diese Antwort weg: Beide weichen in 8 von 100 Schritten von der besten Aktion ab. Gemessen mit den Seeds 1 bis 16, je zehn Leben: ε 0,1 stürzt 13- bis 24-mal, Softmax τ 1,5 2- bis 5-mal, greedy 2- bis 5-mal. Das Intervall des Unterschieds zwischen ε-greedy und Softmax enthielt nie die 0, das zwischen greedy und Softmax in 15 von 16 Fällen. Mit τ 10 stürzt Softmax 76-mal, mit τ 100 193-mal (Seeds 1, 2). Lassen Sie nicht gelten, dass Softmax dort exploriert, wo der Stab aufrecht steht: Es weicht überall von der besten Aktion ab, wo eine andere fast so gut ist, und das ist bei allen Winkeln so.</translation>
    </message>
    <message>
        <source>Expect to hear &quot;more exploring is better, it learns faster&quot;. Let them vote before step 2.

One life is a matter of chance. This one (seed 12) falls 17 times at ε = 0.05 and 64 times at 0.25. In eleven others (seeds 1 to 11) it was 0 to 25 against 61 to 90, always more at 0.25. In step 4 a smaller ε is not always better in one life: 8 falls at 0.02, 14 at 0.025, 7 at 0.01. That is a good moment to ask how many lives one needs; lesson 13 answers it.

Step 3 is the experiment that decides: the same knowledge, with and without random actions. In eleven other seeds the two groups did not overlap either.

Do not say that exploring is needed here: a robot with ε = 0 learns this task, too. At first all actions are worth about 0, so that an action that has led to a fall looks worse than one that has not been tried, and it tries the other by itself. New robots with ε = 0 fell 84 to 185 times in their first 500 episodes, against 160 to 212 at 0.05. Where the goal is hard to find by chance it is otherwise.

Step 5: in eleven other seeds the means were in the same order, and −1600 never overlapped with −100; single lives at 0 and at −100 sometimes did. For a robot that has learned before, as in steps 1 to 4, the reward of a fall makes hardly a difference in 200 episodes. With a punishment that is very hard, about −25,000, learning no longer came to an end in our tests.</source>
        <translation>Erwarten Sie: „Mehr explorieren ist besser, dann lernt er schneller.“ Lassen Sie vor Schritt 2 abstimmen.

Ein Leben ist Zufall. Dieses (Seed 12) stürzt 17-mal bei ε = 0,05 und 64-mal bei 0,25. Bei elf anderen (Seeds 1 bis 11) waren es 0 bis 25 gegen 61 bis 90, bei 0,25 immer mehr. In Schritt 4 ist ein kleineres ε in einem Leben nicht immer besser: 8 Stürze bei 0,02, 14 bei 0,025, 7 bei 0,01. Ein guter Moment für die Frage, wie viele Leben man braucht; Lektion 13 beantwortet sie.

Schritt 3 ist das entscheidende Experiment: dasselbe Wissen, mit und ohne zufällige Aktionen. Auch bei elf anderen Seeds überschnitten sich die beiden Gruppen nicht.

Sagen Sie nicht, dass Explorieren hier nötig ist: Auch ein Roboter mit ε = 0 lernt diese Aufgabe. Anfangs sind alle Aktionen etwa 0 wert; darum sieht eine Aktion, die zu einem Sturz geführt hat, schlechter aus als eine unversuchte, und er probiert von selbst die andere. Neue Roboter mit ε = 0 stürzten in ihren ersten 500 Episoden 84- bis 185-mal, bei 0,05 waren es 160 bis 212. Wo das Ziel durch Zufall schwer zu finden ist, ist das anders.

Schritt 5: Bei elf anderen Seeds standen die Mittel in derselben Reihenfolge, und −1600 überschnitt sich nie mit −100; einzelne Leben bei 0 und bei −100 manchmal schon. Für einen Roboter, der schon gelernt hat, wie in den Schritten 1 bis 4, macht die Belohnung eines Sturzes in 200 Episoden kaum einen Unterschied. Mit einer sehr harten Strafe, etwa −25 000, kam das Lernen in unseren Versuchen nicht mehr ans Ziel.</translation>
    </message>
    <message>
        <source>Expect to hear &quot;strong motors teach it more&quot;, because there it falls less. Let them vote before step 3. Measured with the seeds 1 to 10, ten lives each, ten minutes of simulation, falls in 200 real episodes: from nothing 127 to 137; × 2.5 45 to 64; × 2 24 to 37; × 1.5 9 to 16; right 1 to 4; × 0.8 2 to 4; × 0.5 8 to 16; × 0.3 73 to 103. Every interval between neighbours in steps 5, 6 and 8 leaves out 0. The right one is best; × 0.8 cannot be told from it. In the simulation itself weak motors cost more falls (seed 1, four lives in ten minutes: × 0.5 934, × 1 236, × 2.5 105; with × 0.3 it still falls in four of five episodes): that is the price, and there it is paid. × 1.5 and × 0.5 fall about equally often, so the comparison has to be made by factors, as in step 6. Step 9: 20 falls on average with the risk obeyed, 48 without.</source>
        <translation>Erwarten Sie: „Starke Motoren lehren ihn mehr“, weil er dort seltener stürzt. Lassen Sie vor Schritt 3 abstimmen. Gemessen mit den Seeds 1 bis 10, je zehn Leben, zehn Minuten Simulation, Stürze in 200 wirklichen Episoden: von null an 127 bis 137; × 2,5 45 bis 64; × 2 24 bis 37; × 1,5 9 bis 16; richtig 1 bis 4; × 0,8 2 bis 4; × 0,5 8 bis 16; × 0,3 73 bis 103. Jedes Intervall zwischen Nachbarn in den Schritten 5, 6 und 8 schließt die 0 aus. Das richtige ist am besten; × 0,8 ist davon nicht zu unterscheiden. In der Simulation selbst kosten schwache Motoren mehr Stürze (Seed 1, vier Leben in zehn Minuten: × 0,5 934, × 1 236, × 2,5 105; mit × 0,3 stürzt er noch in vier von fünf Episoden): Das ist der Preis, und dort wird er bezahlt. × 1,5 und × 0,5 stürzen etwa gleich oft; verglichen werden muss also nach Faktoren, wie in Schritt 6. Schritt 9: im Mittel 20 Stürze, wenn das Risiko befolgt wird, 48 ohne.</translation>
    </message>
    <message>
        <source>Expect to hear in step 2 that the highest line is the safest. Let them drag it to the end before they answer. After step 5 TRL looks like the better policy; step 7 asks what it was compared with. Let them vote there. Measured with the seeds 1 to 10, ten lives each, ε = 0.2: no restriction 48 to 55 falls, threshold 50 23 to 29, threshold 100 35 to 45; ε-greedy with ε 0.05 6 to 12. The intervals say so every time for 50 against none and for 50 against ε 0.05, and in 8 of 10 for 50 against 100. Half the ε, 0.1, falls 22 to 25 times: about as often as TRL 50, so do not use it to decide anything with ten lives.</source>
        <translation>Erwarten Sie in Schritt 2, dass die höchste Linie die sicherste sei. Lassen Sie sie erst ans Ende ziehen und dann antworten. Nach Schritt 5 sieht TRL wie die bessere Policy aus; Schritt 7 fragt, womit verglichen wurde. Lassen Sie dort abstimmen. Gemessen mit den Seeds 1 bis 10, je zehn Leben, ε = 0,2: ohne Einschränkung 48 bis 55 Stürze, Schwelle 50 23 bis 29, Schwelle 100 35 bis 45; ε-greedy mit ε 0,05 6 bis 12. Die Intervalle sagen das jedes Mal für 50 gegen keine und für 50 gegen ε 0,05, und in 8 von 10 Fällen für 50 gegen 100. Das halbe ε, 0,1, stürzt 22- bis 25-mal: etwa so oft wie TRL 50; entscheiden Sie damit also nichts mit zehn Leben.</translation>
    </message>
    <message>
        <source>Expected Sarsa takes the mean over its next steps. Which way would you expect of it?</source>
        <translation>Expected Sarsa nimmt das Mittel über seine nächsten Schritte. Welchen Weg würden Sie von ihm erwarten?</translation>
    </message>
    <message>
        <source>Explore equally often</source>
        <translation>Gleich oft explorieren</translation>
    </message>
    <message>
        <source>Explore no more than learning needs: every random action may lead to a fall, also when the robot knows better. And let a fall cost enough that each one teaches something.</source>
        <translation>Nicht mehr explorieren, als das Lernen braucht: Jede zufällige Aktion kann zu einem Sturz führen, auch wenn der Roboter es besser weiß. Und ein Sturz soll so viel kosten, dass jeder etwas lehrt.</translation>
    </message>
    <message>
        <source>Explore only among actions worth more than a threshold (TRL).</source>
        <translation>Nur unter Aktionen explorieren, die mehr wert sind als eine Schwelle (TRL).</translation>
    </message>
    <message>
        <source>Exploring costs falls</source>
        <translation>Explorieren kostet Stürze</translation>
    </message>
    <message>
        <source>Exploring is cheap where another action is worth nearly as much as the best. Softmax tries those, and so falls less than ε-greedy that explores as often. It should also be compared with greedy, which does not explore: these lives cannot tell the two apart.</source>
        <translation>Explorieren ist billig, wo eine andere Aktion fast so viel wert ist wie die beste. Softmax probiert diese und stürzt daher seltener als ein gleich oft explorierendes ε-greedy. Man sollte es auch mit greedy vergleichen, das nicht exploriert: Diese Leben können die beiden nicht unterscheiden.</translation>
    </message>
    <message>
        <source>Exploring need not try everything. A line across the actions&apos; values says what may be tried. Where should it lie, and is it better than simply exploring less?</source>
        <translation>Explorieren muss nicht alles probieren. Eine Linie durch die Werte der Aktionen sagt, was probiert werden darf. Wo soll sie liegen, und ist das besser, als einfach weniger zu explorieren?</translation>
    </message>
    <message>
        <source>Fall in simulation, not in reality</source>
        <translation>In der Simulation stürzen, nicht in der Wirklichkeit</translation>
    </message>
    <message>
        <source>Falling less</source>
        <translation>Weniger stürzen</translation>
    </message>
    <message>
        <source>Falls in 100 episodes: **{observed(3)}** as a beginner, **{observed(5)}** after 20 minutes of practice. Both began each episode at rest, at most 15° from upright. Watch how it balances now.</source>
        <translation>Stürze in 100 Episoden: **{observed(3)}** als Anfänger, **{observed(5)}** nach 20 Minuten Übung. Beide begannen jede Episode in Ruhe, höchstens 15° neben der Senkrechten. Sehen Sie zu, wie er jetzt balanciert.</translation>
    </message>
    <message>
        <source>Falls in 200 episodes</source>
        <translation>Stürze in 200 Episoden</translation>
    </message>
    <message>
        <source>Falls in 200 episodes, at equal shares of exploring</source>
        <translation>Stürze in 200 Episoden, bei gleichem Anteil des Explorierens</translation>
    </message>
    <message>
        <source>Falls in 200 episodes, different simulations</source>
        <translation>Stürze in 200 Episoden, verschiedene Simulationen</translation>
    </message>
    <message>
        <source>Falls in 200 episodes, on average. With ε = 0.2: ε-greedy {mean(&quot;no line&quot;)}; TRL with the line at 50, {mean(&quot;TRL 50&quot;)}. With ε = 0.05: ε-greedy {mean(&quot;ε-greedy, ε 0.05&quot;)}.</source>
        <translation>Stürze in 200 Episoden, im Mittel. Mit ε = 0,2: ε-greedy {mean(&quot;no line&quot;)}; TRL mit der Linie bei 50, {mean(&quot;TRL 50&quot;)}. Mit ε = 0,05: ε-greedy {mean(&quot;ε-greedy, ε 0.05&quot;)}.</translation>
    </message>
    <message>
        <source>Falls in 200 episodes, the same simulations</source>
        <translation>Stürze in 200 Episoden, dieselben Simulationen</translation>
    </message>
    <message>
        <source>Falls in 200 episodes, ε = 0.2</source>
        <translation>Stürze in 200 Episoden, ε = 0,2</translation>
    </message>
    <message>
        <source>Falls in 200 real episodes, ten lives each, on average: {mean(&quot;× 0.3&quot;)} after × 0.3; {mean(&quot;× 0.8&quot;)} after × 0.8; {mean(&quot;× 1.5&quot;)} after × 1.5. After the right motors it was {mean(&quot;right, × 1&quot;)}.</source>
        <translation>Stürze in 200 wirklichen Episoden, je zehn Leben, im Mittel: {mean(&quot;× 0.3&quot;)} nach × 0,3; {mean(&quot;× 0.8&quot;)} nach × 0,8; {mean(&quot;× 1.5&quot;)} nach × 1,5. Nach den richtigen Motoren waren es {mean(&quot;right, × 1&quot;)}.</translation>
    </message>
    <message>
        <source>Falls in 500 episodes</source>
        <translation>Stürze in 500 Episoden</translation>
    </message>
    <message>
        <source>Falls in the first 200 real episodes</source>
        <translation>Stürze in den ersten 200 wirklichen Episoden</translation>
    </message>
    <message>
        <source>Falls in the first 500 episodes</source>
        <translation>Stürze in den ersten 500 Episoden</translation>
    </message>
    <message>
        <source>Falls in the first six minutes</source>
        <translation>Stürze in den ersten sechs Minuten</translation>
    </message>
    <message>
        <source>Falls in the first two minutes</source>
        <translation>Stürze in den ersten zwei Minuten</translation>
    </message>
    <message>
        <source>Falls in the next 100 episodes</source>
        <translation>Stürze in den nächsten 100 Episoden</translation>
    </message>
    <message>
        <source>Falls in three minutes on the other robot</source>
        <translation>Stürze in drei Minuten auf dem anderen Roboter</translation>
    </message>
    <message>
        <source>Falls in two minutes, after three minutes of learning</source>
        <translation>Stürze in zwei Minuten, nach drei Minuten Lernen</translation>
    </message>
    <message>
        <source>Far from upright, where the map is still hatched.</source>
        <translation>Weit weg von der Senkrechten, wo die Karte noch schraffiert ist.</translation>
    </message>
    <message>
        <source>Far up nothing is left of the differences between the five.</source>
        <translation>Ganz oben bleibt von den Unterschieden zwischen den fünf nichts übrig.</translation>
    </message>
    <message>
        <source>Few lives can also hide a difference. In five lives ε-greedy with ε = 0.05 fell {mean(&quot;A&quot;)} times on average, Softmax {mean(&quot;Softmax, five&quot;)} times: one cannot tell. Now thirty lives of each.</source>
        <translation>Wenige Leben können einen Unterschied auch verbergen. In fünf Leben stürzte ε-greedy mit ε = 0,05 im Mittel {mean(&quot;A&quot;)}-mal, Softmax {mean(&quot;Softmax, five&quot;)}-mal: Es lässt sich nicht sagen. Jetzt je dreißig Leben.</translation>
    </message>
    <message>
        <source>Find a resolution with which it falls fewer than 420 times in six minutes.</source>
        <translation>Finden Sie eine Auflösung, mit der er in sechs Minuten weniger als 420-mal stürzt.</translation>
    </message>
    <message>
        <source>Find the width that learns soonest and still balances.</source>
        <translation>Die Breite finden, die am schnellsten lernt und doch balanciert.</translation>
    </message>
    <message>
        <source>Fine or coarse, and for what?</source>
        <translation>Fein oder grob, und wofür?</translation>
    </message>
    <message>
        <source>Finish the sentence: a robot that learns by itself falls because …</source>
        <translation>Ergänzen Sie den Satz: Ein Roboter, der selbst lernt, stürzt, weil …</translation>
    </message>
    <message>
        <source>First **ε-greedy** with ε = 0.1, for 200 episodes in reality. In one step of ten it draws among all five actions. But one in five of those draws happens to be the best action. To take another one than the best is called *leaving the best action* here.</source>
        <translation>Zuerst **ε-greedy** mit ε = 0,1, 200 Episoden in der Wirklichkeit. In einem von zehn Schritten lost er unter allen fünf Aktionen. Eine von fünf Losungen trifft aber zufällig die beste Aktion. Eine andere als die beste zu nehmen heißt hier *von der besten Aktion abweichen*.</translation>
    </message>
    <message>
        <source>First plain ε-greedy in reality, for 200 episodes. In one step of five it draws among all five actions, whatever they are worth.</source>
        <translation>Zuerst einfaches ε-greedy in der Wirklichkeit, 200 Episoden. In einem von fünf Schritten lost es unter allen fünf Aktionen, was immer sie wert sind.</translation>
    </message>
    <message>
        <source>First δ: what comes is 100, what it expects is 50. Half of that is added.</source>
        <translation>Zuerst δ: Es kommen 100, erwartet sind 50. Die Hälfte davon kommt hinzu.</translation>
    </message>
    <message>
        <source>Five lives gave {mean(&quot;Softmax, five&quot;)} and {mean(&quot;greedy, five&quot;)} falls. Thirty give {mean(&quot;Softmax&quot;)} and {mean(&quot;greedy&quot;)}, and now the interval of the difference holds 0. A 95 % interval may miss: without any difference it leaves out 0 in 5 of 100 comparisons.</source>
        <translation>Fünf Leben ergaben {mean(&quot;Softmax, five&quot;)} und {mean(&quot;greedy, five&quot;)} Stürze. Dreißig ergeben {mean(&quot;Softmax&quot;)} und {mean(&quot;greedy&quot;)}, und jetzt enthält das Intervall des Unterschieds die 0. Ein 95-%-Intervall kann danebenliegen: Ohne jeden Unterschied schließt es in 5 von 100 Vergleichen die 0 aus.</translation>
    </message>
    <message>
        <source>Five lives of A, five of B</source>
        <translation>Fünf Leben von A, fünf von B</translation>
    </message>
    <message>
        <source>Five times as many actions are drawn at random. Not each of them is a bad one.</source>
        <translation>Fünfmal so viele Aktionen werden ausgelost. Nicht jede davon ist schlecht.</translation>
    </message>
    <message>
        <source>Follow the lines of the seeds: do they all lean to one side?</source>
        <translation>Folgen Sie den Linien der Seeds: Neigen sie sich alle zur selben Seite?</translation>
    </message>
    <message>
        <source>For how many states does one fall change the values?</source>
        <translation>Für wie viele Zustände ändert ein Sturz die Werte?</translation>
    </message>
    <message>
        <source>For the end: two simulated hours in turbo, with something to read meanwhile.</source>
        <translation>Zum Schluss: zwei simulierte Stunden im Turbo, mit etwas zu lesen dazwischen.</translation>
    </message>
    <message>
        <source>From coin toss to certainty: how Softmax chooses (τ).</source>
        <translation>Vom Münzwurf zur Gewissheit: wie Softmax wählt (τ).</translation>
    </message>
    <message>
        <source>From nothing, in reality</source>
        <translation>Von null an, in der Wirklichkeit</translation>
    </message>
    <message>
        <source>From simulation to robot</source>
        <translation>Von der Simulation zum Roboter</translation>
    </message>
    <message>
        <source>From state 4 it went left, right, left, left, right, left, left.</source>
        <translation>Von Zustand 4 ging er links, rechts, links, links, rechts, links, links.</translation>
    </message>
    <message>
        <source>From the falls in reality.</source>
        <translation>Aus den Stürzen in der Wirklichkeit.</translation>
    </message>
    <message>
        <source>From the falls in the simulation.</source>
        <translation>Aus den Stürzen in der Simulation.</translation>
    </message>
    <message>
        <source>From the reward of a fall, −100.</source>
        <translation>Aus der Belohnung eines Sturzes, −100.</translation>
    </message>
    <message>
        <source>From what did the robot learn the risk of its actions?</source>
        <translation>Woraus hat der Roboter das Risiko seiner Aktionen gelernt?</translation>
    </message>
    <message>
        <source>From which angle could each of them still bring the pole up in its own simulation?</source>
        <translation>Ab welchem Winkel könnte jeder der beiden den Stab in seiner eigenen Simulation noch aufrichten?</translation>
    </message>
    <message>
        <source>From which state does the very next step give a reward above 0?</source>
        <translation>Von welchem Zustand aus gibt der allernächste Schritt eine Belohnung über 0?</translation>
    </message>
    <message>
        <source>Gains and losses apart</source>
        <translation>Gewinne und Verluste getrennt</translation>
    </message>
    <message>
        <source>Go on: state 7 is worth 0.9 times what state 8 is worth.</source>
        <translation>Weiter so: Zustand 7 ist 0,9-mal so viel wert wie Zustand 8.</translation>
    </message>
    <message>
        <source>Goals reached in the first three minutes</source>
        <translation>Erreichte Ziele in den ersten drei Minuten</translation>
    </message>
    <message>
        <source>Grab the pole and pull it.</source>
        <translation>Greifen Sie den Stab und ziehen Sie daran.</translation>
    </message>
    <message>
        <source>Gravity pulls a leaning pole further over. The more it leans, the harder the pull. The robot goes on trying its torques. Grab the pole with the mouse and try to hold it up. What must you watch? Only where the pole is?</source>
        <translation>Die Schwerkraft zieht einen schiefen Stab weiter nach unten. Je schiefer er steht, desto stärker. Der Roboter probiert weiter seine Drehmomente. Greifen Sie den Stab mit der Maus und versuchen Sie, ihn oben zu halten. Worauf müssen Sie achten? Nur darauf, wo der Stab ist?</translation>
    </message>
    <message>
        <source>Greedy falls as seldom. When is exploring worth its falls all the same?</source>
        <translation>Greedy stürzt ebenso selten. Wann ist Explorieren seine Stürze trotzdem wert?</translation>
    </message>
    <message>
        <source>Greedy, which never explores.</source>
        <translation>Greedy, das nie exploriert.</translation>
    </message>
    <message>
        <source>Half as many falls</source>
        <translation>Halb so viele Stürze</translation>
    </message>
    <message>
        <source>Half as wide, and then half as wide again.</source>
        <translation>Halb so breit, und dann noch einmal halb so breit.</translation>
    </message>
    <message>
        <source>Half of the steps are random in all of them. Look at what α is multiplied by.</source>
        <translation>In allen ist die Hälfte der Schritte zufällig. Sehen Sie nach, womit α multipliziert wird.</translation>
    </message>
    <message>
        <source>Hands off now. A new **life** begins: the robot knows nothing again, and nobody shows it how to balance. It gets a **reward** of 200 when the pole stands upright and still, and −100 when it falls. Everything else it must find out. You will see its first 100 episodes.</source>
        <translation>Jetzt Hände weg. Ein neues **Leben** beginnt: Der Roboter weiß wieder nichts, und niemand macht ihm das Balancieren vor. Er bekommt eine **Belohnung** von 200, wenn der Stab aufrecht stillsteht, und −100, wenn er stürzt. Alles andere muss er herausfinden. Sie sehen seine ersten 100 Episoden.</translation>
    </message>
    <message>
        <source>Here is the step. There was no reward, and still the robot learned: δ = 0 + 0.8 · 75 − 0 = 60, and Q(8, right) rose by half of that, to 30. A value learns from the next value.</source>
        <translation>Hier ist der Schritt. Es gab keine Belohnung, und doch hat der Roboter gelernt: δ = 0 + 0,8 · 75 − 0 = 60, und Q(8, rechts) stieg um die Hälfte davon, auf 30. Ein Wert lernt vom nächsten Wert.</translation>
    </message>
    <message>
        <source>How careful?</source>
        <translation>Wie vorsichtig?</translation>
    </message>
    <message>
        <source>How coarse may it be?</source>
        <translation>Wie grob darf es sein?</translation>
    </message>
    <message>
        <source>How does it find out that a step over the edge falls?</source>
        <translation>Wie findet es heraus, dass ein Schritt über den Rand ein Sturz ist?</translation>
    </message>
    <message>
        <source>How does the wrongly blamed step get its value back?</source>
        <translation>Wie bekommt der zu Unrecht beschuldigte Schritt seinen Wert zurück?</translation>
    </message>
    <message>
        <source>How far do the dots of one ε lie apart?</source>
        <translation>Wie weit liegen die Punkte eines ε auseinander?</translation>
    </message>
    <message>
        <source>How far does one lucky or unlucky step move the value with each α?</source>
        <translation>Wie weit verschiebt ein glücklicher oder unglücklicher Schritt den Wert bei jedem α?</translation>
    </message>
    <message>
        <source>How many actions lie above the line, and among how many does TRL draw then?</source>
        <translation>Wie viele Aktionen liegen über der Linie, und unter wie vielen lost TRL dann?</translation>
    </message>
    <message>
        <source>How many lives it takes to say so, and with which interval.</source>
        <translation>Wie viele Leben man braucht, um das zu sagen, und mit welchem Intervall.</translation>
    </message>
    <message>
        <source>How many more tiles are there, in three variables?</source>
        <translation>Wie viel mehr Kacheln gibt es, in drei Variablen?</translation>
    </message>
    <message>
        <source>How many of its first 100 episodes will end in a fall?</source>
        <translation>Wie viele seiner ersten 100 Episoden enden mit einem Sturz?</translation>
    </message>
    <message>
        <source>How many of the falls may have come from random actions?</source>
        <translation>Wie viele der Stürze können von zufälligen Aktionen gekommen sein?</translation>
    </message>
    <message>
        <source>How many steps next to the edge does each way have?</source>
        <translation>Wie viele Schritte neben dem Rand hat jeder der beiden Wege?</translation>
    </message>
    <message>
        <source>How many steps per episode will it take?</source>
        <translation>Wie viele Schritte je Episode wird er brauchen?</translation>
    </message>
    <message>
        <source>How many steps will its way have?</source>
        <translation>Wie viele Schritte wird sein Weg haben?</translation>
    </message>
    <message>
        <source>How many times will it have reached the goal by then?</source>
        <translation>Wie oft wird er das Ziel bis dahin erreicht haben?</translation>
    </message>
    <message>
        <source>How often will Q-learning fall in 500 episodes?</source>
        <translation>Wie oft wird Q-learning in 500 Episoden stürzen?</translation>
    </message>
    <message>
        <source>How often will it fall in 200 episodes?</source>
        <translation>Wie oft wird er in 200 Episoden stürzen?</translation>
    </message>
    <message>
        <source>How often will it fall in its first ten minutes?</source>
        <translation>Wie oft wird er in seinen ersten zehn Minuten stürzen?</translation>
    </message>
    <message>
        <source>How often will it fall in its first two minutes?</source>
        <translation>Wie oft wird er in seinen ersten zwei Minuten stürzen?</translation>
    </message>
    <message>
        <source>How often will it fall in six minutes?</source>
        <translation>Wie oft wird er in sechs Minuten stürzen?</translation>
    </message>
    <message>
        <source>How often will it fall in the next ten minutes?</source>
        <translation>Wie oft wird er in den nächsten zehn Minuten stürzen?</translation>
    </message>
    <message>
        <source>How often will it fall in these 200 real episodes?</source>
        <translation>Wie oft wird er in diesen 200 wirklichen Episoden stürzen?</translation>
    </message>
    <message>
        <source>How often will it fall in these ten minutes?</source>
        <translation>Wie oft wird er in diesen zehn Minuten stürzen?</translation>
    </message>
    <message>
        <source>How often will it fall with ε = 0.25?</source>
        <translation>Wie oft wird er mit ε = 0,25 stürzen?</translation>
    </message>
    <message>
        <source>How often will it fall?</source>
        <translation>Wie oft wird er stürzen?</translation>
    </message>
    <message>
        <source>How should a simulation be wrong?</source>
        <translation>Wie sollte eine Simulation falsch sein?</translation>
    </message>
    <message>
        <source>How steep is the curve of falls in its last ten minutes?</source>
        <translation>Wie steil ist die Kurve der Stürze in den letzten zehn Minuten?</translation>
    </message>
    <message>
        <source>How weak may it be?</source>
        <translation>Wie schwach dürfen sie sein?</translation>
    </message>
    <message>
        <source>How wide are the bars of the means now?</source>
        <translation>Wie breit sind die Balken der Mittel jetzt?</translation>
    </message>
    <message>
        <source>How wide is a tile along the pole&apos;s angle?</source>
        <translation>Wie breit ist eine Kachel entlang dem Winkel des Stabs?</translation>
    </message>
    <message>
        <source>How would you let a robot learn?</source>
        <translation>Wie würden Sie einen Roboter lernen lassen?</translation>
    </message>
    <message>
        <source>If the robot has to explore that often, a threshold lets it do so with fewer falls. If it need not, a smaller ε saves more. So TRL has to be compared with ε-greedy of a smaller ε, too, not only of the same ε.</source>
        <translation>Muss der Roboter so oft explorieren, dann lässt ihn eine Schwelle das mit weniger Stürzen tun. Muss er es nicht, spart ein kleineres ε mehr. TRL ist also auch mit ε-greedy eines kleineren ε zu vergleichen, nicht nur desselben ε.</translation>
    </message>
    <message>
        <source>If wide tiles help, why two Q-functions at all? For a fair comparison give **both** the resolution 0.4, which is one coarse Q-function. Ten lives of each.</source>
        <translation>Wenn breite Kacheln helfen, warum dann überhaupt zwei Q-Funktionen? Geben Sie für einen fairen Vergleich **beiden** die Auflösung 0,4; das ist eine einzige grobe Q-Funktion. Je zehn Leben.</translation>
    </message>
    <message>
        <source>In 100 steps it draws 10 times. How many of these draws are not the best action?</source>
        <translation>In 100 Schritten lost er 10-mal. Wie viele dieser Lose sind nicht die beste Aktion?</translation>
    </message>
    <message>
        <source>In a simulation falls cost nothing, but no simulation is right. Its motors may be too strong or too weak. Say beforehand which of the two helps more, and then ask whether the comparison was fair.</source>
        <translation>In einer Simulation kosten Stürze nichts, aber keine Simulation stimmt. Ihre Motoren können zu stark oder zu schwach sein. Sagen Sie vorher, was von beidem mehr hilft, und fragen Sie dann, ob der Vergleich fair war.</translation>
    </message>
    <message>
        <source>In how many of 100 steps does it take an action other than the best?</source>
        <translation>In wie vielen von 100 Schritten nimmt er eine andere Aktion als die beste?</translation>
    </message>
    <message>
        <source>In its own simulation the motors are weak: to bring the pole up from 29° is harder there.</source>
        <translation>In seiner eigenen Simulation sind die Motoren schwach: Den Stab von 29° aufzurichten ist dort schwerer.</translation>
    </message>
    <message>
        <source>In reality it obeys the risk: it chooses by **Q − 3000·ρ**. Nothing was learned anew; only the choice is another. 200 real episodes: without this it fell {observed(1)} times, with a penalty of −6400 {observed(2)} times.</source>
        <translation>In der Wirklichkeit hält er sich an das Risiko: Er wählt nach **Q − 3000·ρ**. Nichts wurde neu gelernt; nur die Wahl ist eine andere. 200 wirkliche Episoden: Ohne das stürzte er {observed(1)}-mal, mit einer Strafe von −6400 {observed(2)}-mal.</translation>
    </message>
    <message>
        <source>In simulation LEO fell {observed(3)} times and broke nothing. On the other robot it fell {observed(5)} times with ε = 0.05 and {observed(6)} times greedy, in ten minutes each.</source>
        <translation>In der Simulation stürzte LEO {observed(3)}-mal, und nichts ging kaputt. Auf dem anderen Roboter stürzte er {observed(5)}-mal mit ε = 0,05 und {observed(6)}-mal greedy, jeweils in zehn Minuten.</translation>
    </message>
    <message>
        <source>In simulation a robot may fall as often as it likes, and should: only falls teach where falls are. In reality it should not. One number that it learns beside its values lets it be bold in one world and careful in the other.</source>
        <translation>In der Simulation darf ein Roboter stürzen, so oft er will, und soll es auch: Nur Stürze lehren, wo Stürze sind. In der Wirklichkeit soll er es nicht. Eine Zahl, die er neben seinen Werten lernt, lässt ihn in der einen Welt kühn und in der anderen vorsichtig sein.</translation>
    </message>
    <message>
        <source>In these 500 episodes it has been on every square at the edge. Think of its falls.</source>
        <translation>In diesen 500 Episoden war es auf jedem Feld am Rand. Denken Sie an seine Stürze.</translation>
    </message>
    <message>
        <source>In this life a coarser Q⁻ came to {observed(4)} falls instead of {observed(3)}. How coarse may it be? Turn the resolution of Q⁻; each time a new life begins. Run six minutes in turbo.</source>
        <translation>In diesem Leben kam ein gröberes Q⁻ auf {observed(4)} Stürze statt {observed(3)}. Wie grob darf es sein? Drehen Sie an der Auflösung von Q⁻; jedes Mal beginnt ein neues Leben. Lassen Sie sechs Minuten im Turbo laufen.</translation>
    </message>
    <message>
        <source>In which of the two states does Softmax with τ = 1.5 sometimes take the second best?</source>
        <translation>In welchem der zwei Zustände nimmt Softmax mit τ = 1,5 manchmal die zweitbeste?</translation>
    </message>
    <message>
        <source>In your own words</source>
        <translation>In Ihren eigenen Worten</translation>
    </message>
    <message>
        <source>Is anything else as good, that the claim does not mention?</source>
        <translation>Ist etwas anderes ebenso gut, das die Behauptung nicht erwähnt?</translation>
    </message>
    <message>
        <source>Is it really better?</source>
        <translation>Ist es wirklich besser?</translation>
    </message>
    <message>
        <source>Is that fair?</source>
        <translation>Ist das fair?</translation>
    </message>
    <message>
        <source>Is the robot that falls least also the one that learns soonest? How would you measure it?</source>
        <translation>Ist der Roboter, der am seltensten stürzt, auch der, der am schnellsten lernt? Wie würden Sie das messen?</translation>
    </message>
    <message>
        <source>It counts the falls that its own random steps will bring at the edge.</source>
        <translation>Es rechnet die Stürze mit, die seine eigenen zufälligen Schritte am Rand bringen werden.</translation>
    </message>
    <message>
        <source>It did not know yet which torque helps where.</source>
        <translation>Er wusste noch nicht, welches Drehmoment wo hilft.</translation>
    </message>
    <message>
        <source>It does not mind the cost of a step.</source>
        <translation>Die Kosten eines Schritts sind ihm egal.</translation>
    </message>
    <message>
        <source>It expects heavy losses even upright: Q⁻ can hardly tell good from bad.</source>
        <translation>Er erwartet auch aufrecht schwere Verluste: Q⁻ kann Gut und Schlecht kaum unterscheiden.</translation>
    </message>
    <message>
        <source>It expects that it can still save itself.</source>
        <translation>Er erwartet, dass er sich noch retten kann.</translation>
    </message>
    <message>
        <source>It expects too little loss.</source>
        <translation>Er erwartet zu wenig Verlust.</translation>
    </message>
    <message>
        <source>It expects {max(q(&quot;1.5&quot;), q(&quot;0.75&quot;), q(&quot;0&quot;), q(&quot;-0.75&quot;), q(&quot;-1.5&quot;))}, not {observed(4)}. Ten lives each fall, on average, {mean(&quot;nothing&quot;)} times from nothing, {mean(&quot;strong, × 2.5&quot;)} after the strong motors, {mean(&quot;weak, × 0.5&quot;)} after the weak ones and {mean(&quot;right, × 1&quot;)} after the right ones.</source>
        <translation>Er erwartet {max(q(&quot;1.5&quot;), q(&quot;0.75&quot;), q(&quot;0&quot;), q(&quot;-0.75&quot;), q(&quot;-1.5&quot;))}, nicht {observed(4)}. Je zehn Leben stürzen im Mittel {mean(&quot;nothing&quot;)}-mal von null an, {mean(&quot;strong, × 2.5&quot;)}-mal nach den starken Motoren, {mean(&quot;weak, × 0.5&quot;)}-mal nach den schwachen und {mean(&quot;right, × 1&quot;)}-mal nach den richtigen.</translation>
    </message>
    <message>
        <source>It explores less.</source>
        <translation>Es exploriert weniger.</translation>
    </message>
    <message>
        <source>It explores more often.</source>
        <translation>Es exploriert öfter.</translation>
    </message>
    <message>
        <source>It explores more.</source>
        <translation>Er exploriert mehr.</translation>
    </message>
    <message>
        <source>It fell **{observed(1)} times** in 200 episodes. Now it first learns for ten minutes in a simulation. But the simulation is wrong: its motors are **2.5 times too strong**. After that come 200 episodes in reality.</source>
        <translation>Er stürzte in 200 Episoden **{observed(1)}-mal**. Jetzt lernt er zuerst zehn Minuten in einer Simulation. Aber die ist falsch: Ihre Motoren sind **2,5-mal zu stark**. Danach kommen 200 Episoden in der Wirklichkeit.</translation>
    </message>
    <message>
        <source>It fell **{observed(1)} times**. The first idea: a fall costs −6400 instead of −100, in the simulation **and** in reality. Everything else stays.</source>
        <translation>Er stürzte **{observed(1)}-mal**. Die erste Idee: Ein Sturz kostet −6400 statt −100, in der Simulation **und** in der Wirklichkeit. Alles andere bleibt.</translation>
    </message>
    <message>
        <source>It fell **{observed(3)} times** in 200 episodes. Now TRL with a threshold of **50**. The same robot, and it explores in one step of five, as before.</source>
        <translation>Er stürzte in 200 Episoden **{observed(3)}-mal**. Jetzt TRL mit einer Schwelle von **50**. Derselbe Roboter, und er exploriert in einem von fünf Schritten, wie vorher.</translation>
    </message>
    <message>
        <source>It fell {observed(2)} times; with the wide tiles {observed(1)} times. What it learns in a narrow tile helps in no other, and there are 32,768 times as many of them. The map shows where it has learned anything.</source>
        <translation>Er stürzte {observed(2)}-mal; mit den breiten Kacheln {observed(1)}-mal. Was er in einer schmalen Kachel lernt, hilft in keiner anderen, und es gibt 32 768-mal so viele. Die Karte zeigt, wo er etwas gelernt hat.</translation>
    </message>
    <message>
        <source>It fell {observed(3)} times. Each fall has a mark below the curve, and a click plays it back slowly. To save a leaning pole, the wheel must drive the cart **under** it, to the side where it leans. Does the arrow point to that side all the time?</source>
        <translation>Er ist {observed(3)}-mal gestürzt. Jeder Sturz hat eine Marke unter der Kurve, und ein Klick spielt ihn langsam ab. Um einen schiefen Stab zu retten, muss das Rad den Wagen **unter** ihn fahren, zu der Seite, nach der er sich neigt. Zeigt der Pfeil die ganze Zeit zu dieser Seite?</translation>
    </message>
    <message>
        <source>It fell {observed(4)} times. In ten lives of each, Sarsa falls {least(&quot;Sarsa falls&quot;)} to {most(&quot;Sarsa falls&quot;)} times and Q-learning {least(&quot;Q-learning falls&quot;)} to {most(&quot;Q-learning falls&quot;)} times. To Q-learning the short way is worth more, to Sarsa the longer one.</source>
        <translation>Es stürzte {observed(4)}-mal. In je zehn Leben stürzt Sarsa {least(&quot;Sarsa falls&quot;)}- bis {most(&quot;Sarsa falls&quot;)}-mal und Q-learning {least(&quot;Q-learning falls&quot;)}- bis {most(&quot;Q-learning falls&quot;)}-mal. Für Q-learning ist der kurze Weg mehr wert, für Sarsa der längere.</translation>
    </message>
    <message>
        <source>It fell {observed(7)} times instead of {observed(4)}, and walks along the edge: it fell about once for every square beside the cliff, and then knew. Without that, with ε = 0.1, Sarsa kept off the edge and Q-learning did not.</source>
        <translation>Es stürzte {observed(7)}-mal statt {observed(4)}-mal und geht am Rand entlang: Es stürzte etwa einmal für jedes Feld neben der Klippe und wusste es dann. Ohne das hielt, mit ε = 0,1, Sarsa Abstand vom Rand und Q-learning nicht.</translation>
    </message>
    <message>
        <source>It follows what it learned in the simulation, also where that is wrong.</source>
        <translation>Es folgt dem, was es in der Simulation gelernt hat, auch wo das falsch ist.</translation>
    </message>
    <message>
        <source>It forbids the best action.</source>
        <translation>Sie verbietet die beste Aktion.</translation>
    </message>
    <message>
        <source>It forgets what it has learned.</source>
        <translation>Er vergisst, was er gelernt hat.</translation>
    </message>
    <message>
        <source>It has been at the goal many times. Look at state 9.</source>
        <translation>Er war schon oft am Ziel. Sehen Sie Zustand 9 an.</translation>
    </message>
    <message>
        <source>It has fallen so often. Why does it expect no loss here?</source>
        <translation>Er ist so oft gestürzt. Warum erwartet er hier keinen Verlust?</translation>
    </message>
    <message>
        <source>It has learned for longer.</source>
        <translation>Es hat länger gelernt.</translation>
    </message>
    <message>
        <source>It has never been in these tiles.</source>
        <translation>Er war noch nie in diesen Kacheln.</translation>
    </message>
    <message>
        <source>It has never been on the short way.</source>
        <translation>Es war nie auf dem kurzen Weg.</translation>
    </message>
    <message>
        <source>It has not found the goal yet.</source>
        <translation>Er hat das Ziel noch nicht gefunden.</translation>
    </message>
    <message>
        <source>It has not learned for long enough.</source>
        <translation>Er hat nicht lange genug gelernt.</translation>
    </message>
    <message>
        <source>It has not lived in reality yet.</source>
        <translation>Er hat noch nicht in der Wirklichkeit gelebt.</translation>
    </message>
    <message>
        <source>It is 75: δ was 50, half as much as before. Next the robot is put on state 8 and goes right. Q(8, right) is 0, and the reward is R = 0. But on state 9 it will go right, and Q(9, right) = 75. Here γ = 0.8.</source>
        <translation>Es ist 75: δ war 50, halb so groß wie vorher. Als Nächstes wird der Roboter auf Zustand 8 gesetzt und geht nach rechts. Q(8, rechts) ist 0, und die Belohnung ist R = 0. Aber auf Zustand 9 wird er nach rechts gehen, und Q(9, rechts) = 75. Hier ist γ = 0,8.</translation>
    </message>
    <message>
        <source>It is afraid of the fall.</source>
        <translation>Er hat Angst vor dem Sturz.</translation>
    </message>
    <message>
        <source>It is the same motor now. Look at the pole: does it come upright?</source>
        <translation>Es ist jetzt derselbe Motor. Sehen Sie auf den Stab: Richtet er sich auf?</translation>
    </message>
    <message>
        <source>It keeps away from the fall.</source>
        <translation>Er hält sich vom Sturz fern.</translation>
    </message>
    <message>
        <source>It knows enough to fall seldom. But it still takes one action in four at random, also where that is dangerous.</source>
        <translation>Er weiß genug, um selten zu stürzen. Aber er wählt weiter eine von vier Aktionen zufällig, auch wo das gefährlich ist.</translation>
    </message>
    <message>
        <source>It leads to state 3, away from the fall. Look at the world.</source>
        <translation>Es führt zu Zustand 3, weg vom Sturz. Sehen Sie die Welt an.</translation>
    </message>
    <message>
        <source>It leads to the fall, too.</source>
        <translation>Es führt auch zum Sturz.</translation>
    </message>
    <message>
        <source>It learned caution in the simulation, and with it less of where falls are.</source>
        <translation>Er hat in der Simulation Vorsicht gelernt, und damit weniger darüber, wo Stürze sind.</translation>
    </message>
    <message>
        <source>It learned for longer.</source>
        <translation>Er hat länger gelernt.</translation>
    </message>
    <message>
        <source>It learns more slowly, so it knows too little.</source>
        <translation>Er lernt langsamer und weiß daher zu wenig.</translation>
    </message>
    <message>
        <source>It no longer gets the reward of the goal.</source>
        <translation>Er bekommt die Belohnung des Ziels nicht mehr.</translation>
    </message>
    <message>
        <source>It takes such a lean for lost, and so errs on the safe side.</source>
        <translation>Er hält so eine Neigung für verloren und irrt sich so zur sicheren Seite.</translation>
    </message>
    <message>
        <source>It wants to fall then, because that ends the episode.</source>
        <translation>Er will dann stürzen, weil das die Episode beendet.</translation>
    </message>
    <message>
        <source>It was taken shortly before the fall.</source>
        <translation>Es wurde kurz vor dem Sturz getan.</translation>
    </message>
    <message>
        <source>It will keep away from falls in both worlds. But what does it know of the real one?</source>
        <translation>Er wird sich in beiden Welten von Stürzen fernhalten. Aber was weiß er von der wirklichen?</translation>
    </message>
    <message>
        <source>Its episodes began with the pole too far over.</source>
        <translation>Am Anfang seiner Episoden stand der Stab zu schief.</translation>
    </message>
    <message>
        <source>Its mark has faded once, to 0.81. It loses 0.81 times what the last step loses.</source>
        <translation>Seine Marke ist einmal verblasst, auf 0,81. Er verliert 0,81-mal so viel wie der letzte Schritt.</translation>
    </message>
    <message>
        <source>Its motor is too weak for the pole.</source>
        <translation>Sein Motor ist zu schwach für den Stab.</translation>
    </message>
    <message>
        <source>Its random actions make it fall, whatever it knows.</source>
        <translation>Seine zufälligen Aktionen bringen ihn zu Fall, was immer er weiß.</translation>
    </message>
    <message>
        <source>Its random steps are what makes the edge costly. And what it learned with them it must learn anew.</source>
        <translation>Seine zufälligen Schritte machen den Rand teuer. Und was es mit ihnen gelernt hat, muss es neu lernen.</translation>
    </message>
    <message>
        <source>Its tiles are only 12° wide, and all its falls went through other ones.</source>
        <translation>Seine Kacheln sind nur 12° breit, und alle seine Stürze gingen durch andere.</translation>
    </message>
    <message>
        <source>LEO has two legs and seven parts, and knows nothing when it begins. Give it two simulated hours. Then put what it has learned on a robot with other motors, and compare two ways to go on.</source>
        <translation>LEO hat zwei Beine und sieben Teile und weiß am Anfang nichts. Geben Sie ihm zwei simulierte Stunden. Übertragen Sie dann das Gelernte auf einen Roboter mit anderen Motoren und vergleichen Sie zwei Arten weiterzumachen.</translation>
    </message>
    <message>
        <source>LEO is held by a boom, so that it cannot fall sideways. Thirty times a second it sets three motors, each to one of seven voltages. It gets a reward for every metre, and pays for energy, for time and for falls. It knows nothing yet. Watch it for a while.</source>
        <translation>LEO wird von einem Ausleger gehalten, damit er nicht zur Seite stürzt. Dreißigmal in der Sekunde stellt er drei Motoren auf je eine von sieben Spannungen. Er bekommt eine Belohnung für jeden Meter und zahlt für Energie, Zeit und Stürze. Noch weiß er nichts. Sehen Sie ihm eine Weile zu.</translation>
    </message>
    <message>
        <source>LEO walks</source>
        <translation>LEO geht</translation>
    </message>
    <message>
        <source>Learn first on a wrong model, and choose how it should be wrong.</source>
        <translation>Zuerst an einem falschen Modell lernen und wählen, wie es falsch sein soll.</translation>
    </message>
    <message>
        <source>Learn how likely a fall is, and obey it only where falls cost something.</source>
        <translation>Lernen, wie wahrscheinlich ein Sturz ist, und sich nur daran halten, wo Stürze etwas kosten.</translation>
    </message>
    <message>
        <source>Left and right are worth the same there.</source>
        <translation>Links und rechts sind dort gleich viel wert.</translation>
    </message>
    <message>
        <source>Less.</source>
        <translation>Weniger.</translation>
    </message>
    <message>
        <source>Let it fall in simulation first, as often as it needs. Then explore as little as possible on the robot: in this run greedy fell less. And check it with more than one learned robot before you say so of all.</source>
        <translation>Ihn zuerst in der Simulation stürzen lassen, so oft er es braucht. Danach auf dem Roboter so wenig wie möglich explorieren: In diesem Lauf stürzte greedy seltener. Und es mit mehr als einem gelernten Roboter prüfen, bevor man es von allen sagt.</translation>
    </message>
    <message>
        <source>Let it run, and look at the arrows on the map: which way do they lead from the start?</source>
        <translation>Lassen Sie ihn laufen und sehen Sie die Pfeile auf der Karte an: Wohin führen sie vom Start aus?</translation>
    </message>
    <message>
        <source>Let them vote before step 5: expect to hear &quot;the coarser, the better&quot;. The fair comparison of step 7 is easily forgotten: one coarse Q-function. Measured with the seeds 1 to 10, ten lives of six minutes each: fine 65 to 77 falls, Q⁻ 0.4 44 to 50, Q⁻ 0.1 198 to 282, both 0.4 69 to 76; every interval between them says so, but that between fine and both coarse, which differ little in falls. With both coarse the goal is reached about 770 times in six minutes in place of about 1,300. One life showed the opposite in 2 of 10 seeds, hence ten. On the walking robot LEO a coarse Q⁻ for all that is negative falls 15 times as often; if it holds the falls alone, as here, it falls as often as one Q-function.</source>
        <translation>Lassen Sie vor Schritt 5 abstimmen: Erwarten Sie „je gröber, desto besser“. Den fairen Vergleich von Schritt 7 vergisst man leicht: eine einzige grobe Q-Funktion. Gemessen mit den Seeds 1 bis 10, je zehn Leben von sechs Minuten: fein 65 bis 77 Stürze, Q⁻ 0,4 44 bis 50, Q⁻ 0,1 198 bis 282, beide 0,4 69 bis 76; jedes Intervall dazwischen sagt das, außer dem zwischen fein und beide grob, die sich in den Stürzen wenig unterscheiden. Mit beiden grob wird das Ziel in sechs Minuten etwa 770-mal erreicht statt etwa 1 300-mal. Ein einzelnes Leben zeigte in 2 von 10 Seeds das Gegenteil, daher zehn. Beim Laufroboter LEO stürzt ein grobes Q⁻ für alles Negative 15-mal so oft; enthält es nur die Stürze, wie hier, stürzt er so oft wie mit einer Q-Funktion.</translation>
    </message>
    <message>
        <source>Look at how far the dots of both overlap, not only at the means.</source>
        <translation>Sehen Sie, wie weit sich die Punkte beider überschneiden, nicht nur auf die Mittel.</translation>
    </message>
    <message>
        <source>Look at the dots of both, and at the bars of their means.</source>
        <translation>Sehen Sie die Punkte beider an und die Balken ihrer Mittel.</translation>
    </message>
    <message>
        <source>Look at the dots, not at the means alone.</source>
        <translation>Sehen Sie die Punkte an, nicht nur die Mittel.</translation>
    </message>
    <message>
        <source>Look at the dots: none of them is near 0.</source>
        <translation>Sehen Sie die Punkte an: Keiner liegt nahe 0.</translation>
    </message>
    <message>
        <source>Look at the first seven steps: no reward came, none was expected, δ = 0.</source>
        <translation>Sehen Sie die ersten sieben Schritte an: Keine Belohnung kam, keine war erwartet, δ = 0.</translation>
    </message>
    <message>
        <source>Look at the map: has it ever learned a value here?</source>
        <translation>Sehen Sie die Karte an: Hat er hier je einen Wert gelernt?</translation>
    </message>
    <message>
        <source>Look at the rewards: 0 for a fall, 200 for the goal.</source>
        <translation>Sehen Sie die Belohnungen an: 0 für einen Sturz, 200 für das Ziel.</translation>
    </message>
    <message>
        <source>Look at what it expects at 3°.</source>
        <translation>Sehen Sie nach, was er bei 3° erwartet.</translation>
    </message>
    <message>
        <source>Make Sarsa take the short way: bring its average reward to −13.5 or better.</source>
        <translation>Bringen Sie Sarsa auf den kurzen Weg: Seine mittlere Belohnung soll −13,5 oder besser werden.</translation>
    </message>
    <message>
        <source>Make it fall less often in six minutes than with the fine Q⁻, with a resolution of at most 0.35.</source>
        <translation>Bringen Sie ihn dazu, in sechs Minuten seltener zu stürzen als mit feinem Q⁻, mit einer Auflösung von höchstens 0,35.</translation>
    </message>
    <message>
        <source>Make it fall less than half as often as with ε = 0.05.</source>
        <translation>Bringen Sie ihn dazu, weniger als halb so oft zu stürzen wie mit ε = 0,05.</translation>
    </message>
    <message>
        <source>Marks fade to γ λ with every step, and γ is 0.9. For which λ is that one half?</source>
        <translation>Marken verblassen mit jedem Schritt um γ λ, und γ ist 0,9. Für welches λ ist das die Hälfte?</translation>
    </message>
    <message>
        <source>More lives.</source>
        <translation>Mehr Leben.</translation>
    </message>
    <message>
        <source>More.</source>
        <translation>Mehr.</translation>
    </message>
    <message>
        <source>Neither simulation is exact. Look at what each of them made the robot expect.</source>
        <translation>Keine der beiden Simulationen ist genau. Sehen Sie, was jede den Roboter erwarten ließ.</translation>
    </message>
    <message>
        <source>No amount of learning gives two states in one tile different values.</source>
        <translation>Kein noch so langes Lernen gibt zwei Zuständen in einer Kachel verschiedene Werte.</translation>
    </message>
    <message>
        <source>No formula is needed. Let everybody write a number down before step 3; expect low guesses from whoever thinks of balancing a broom on the hand. Forty lives (seeds 1 to 40) fell 68 to 93 times in their first 100 episodes, and 0 to 7 times in 100 after 20 minutes.

Step 2: the pole falls in a fraction of a second, so set the pace to its slowest before anybody grabs it. What one should notice is that the angle alone is not enough: the rate counts as well. Together with the wheel&apos;s rate they are the state.

Step 6: the wrong answers are reasonable guesses about machines. The point is that body and task are the same in both curves. A pole that leans too far cannot be saved with this motor; but no episode begins there.

Each student has numbers of his own, from his name.</source>
        <translation>Eine Formel ist nicht nötig. Lassen Sie vor Schritt 3 alle eine Zahl aufschreiben; wer an das Balancieren eines Besens auf der Hand denkt, wird niedrig raten. Vierzig Leben (Seeds 1 bis 40) stürzten in ihren ersten 100 Episoden 68- bis 93-mal und nach 20 Minuten 0- bis 7-mal in 100.

Schritt 2: Der Stab fällt im Bruchteil einer Sekunde; stellen Sie das Tempo also auf das langsamste, bevor jemand ihn greift. Bemerken soll man, dass der Winkel allein nicht reicht: Die Drehrate zählt auch. Zusammen mit der Drehrate des Rades bilden sie den Zustand.

Schritt 6: Die falschen Antworten sind vernünftige Vermutungen über Maschinen. Es kommt darauf an, dass Körper und Aufgabe in beiden Kurven dieselben sind. Ein Stab, der zu schief steht, ist mit diesem Motor nicht zu retten; aber keine Episode beginnt dort.

Alle haben eigene Zahlen, die sich aus ihrem Namen ergeben.</translation>
    </message>
    <message>
        <source>Nobody shows LEO how to walk. Thirty times a second it does [one step of learning](lesson:one-step-of-learning), and [traces](lesson:whom-to-blame) carry each fall back to the steps before it. Metres are rewarded; the rest it must find. The thesis behind this program asked how LEO could learn without breaking. Watch where the curve of falls becomes flatter.</source>
        <translation>Niemand macht LEO das Gehen vor. Dreißigmal in der Sekunde tut er [einen Schritt Lernen](lesson:one-step-of-learning), und [Traces](lesson:whom-to-blame) tragen jeden Sturz zu den Schritten davor zurück. Belohnt werden Meter; den Rest muss er finden. Die Masterarbeit hinter diesem Programm fragte, wie LEO lernen kann, ohne kaputtzugehen. Achten Sie darauf, wo die Kurve der Stürze flacher wird.</translation>
    </message>
    <message>
        <source>Nobody told this robot which torque is right. It found out by trying, and most of its first 100 episodes ended in a fall. In a simulation a fall costs nothing. A real robot can break.</source>
        <translation>Niemand hat diesem Roboter gesagt, welches Drehmoment richtig ist. Er hat es durch Ausprobieren herausgefunden, und die meisten seiner ersten 100 Episoden endeten mit einem Sturz. In einer Simulation kostet ein Sturz nichts. Ein echter Roboter kann kaputtgehen.</translation>
    </message>
    <message>
        <source>Nothing in them is drawn: every episode begins alike, and greedy does not explore.</source>
        <translation>In ihnen wird nichts ausgelost: Jede Episode beginnt gleich, und greedy exploriert nicht.</translation>
    </message>
    <message>
        <source>Nothing: it changes together with Q(8, right).</source>
        <translation>Nichts: Er ändert sich zusammen mit Q(8, rechts).</translation>
    </message>
    <message>
        <source>Now drag the line to both ends: first below all five bars, then above all of them. Each time look how likely the worst action is.</source>
        <translation>Ziehen Sie die Linie nun an beide Enden: zuerst unter alle fünf Balken, dann über alle. Sehen Sie jedes Mal nach, wie wahrscheinlich die schlechteste Aktion ist.</translation>
    </message>
    <message>
        <source>Now half of its steps are random. After a step to state 9 it sometimes goes *right*, sometimes *left*: what a step teaches depends on chance. In 20 lives of 500 episodes Q(8, right) ends between {least(&quot;α 0.02&quot;)} and {most(&quot;α 0.02&quot;)} with α = 0.02, and between {least(&quot;α 0.5&quot;)} and {most(&quot;α 0.5&quot;)} with α = 0.5.</source>
        <translation>Jetzt ist die Hälfte seiner Schritte zufällig. Nach einem Schritt auf Zustand 9 geht er manchmal nach *rechts*, manchmal nach *links*: Was ein Schritt lehrt, hängt vom Zufall ab. In 20 Leben von 500 Episoden endet Q(8, rechts) zwischen {least(&quot;α 0.02&quot;)} und {most(&quot;α 0.02&quot;)} mit α = 0,02 und zwischen {least(&quot;α 0.5&quot;)} und {most(&quot;α 0.5&quot;)} mit α = 0,5.</translation>
    </message>
    <message>
        <source>Now it has practised for 20 minutes, by its own clock. The pole, the cart and the motor are the same as before. Here are 100 more episodes. As a beginner it fell {observed(3)} times.</source>
        <translation>Jetzt hat er 20 Minuten geübt, nach seiner eigenen Uhr. Stab, Wagen und Motor sind dieselben wie vorher. Hier sind 100 weitere Episoden. Als Anfänger stürzte er {observed(3)}-mal.</translation>
    </message>
    <message>
        <source>Now it leans and is at rest</source>
        <translation>Jetzt steht er schief und ruht</translation>
    </message>
    <message>
        <source>Now the two minutes after three minutes of learning. Falls on average: {mean(&quot;resolution 0.25, later&quot;)} with 0.25; {mean(&quot;resolution 1, later&quot;)} with 1; {mean(&quot;resolution 4, later&quot;)} with 4; {mean(&quot;resolution 8, later&quot;)} with 8. The order has changed: look who falls least now.</source>
        <translation>Jetzt die zwei Minuten nach drei Minuten Lernen. Stürze im Mittel: {mean(&quot;resolution 0.25, later&quot;)} mit 0,25; {mean(&quot;resolution 1, later&quot;)} mit 1; {mean(&quot;resolution 4, later&quot;)} mit 4; {mean(&quot;resolution 8, later&quot;)} mit 8. Die Reihenfolge hat sich geändert: Sehen Sie, wer jetzt am seltensten stürzt.</translation>
    </message>
    <message>
        <source>Now two robots that do differ. One chooses by **Softmax** with τ = 1; the other is **greedy**: it always takes the best action it knows. Five lives of each. Does the interval of the difference hold 0?</source>
        <translation>Jetzt zwei Roboter, die wirklich verschieden sind. Einer wählt mit **Softmax**, τ = 1; der andere ist **greedy**: Er nimmt immer die beste Aktion, die er kennt. Je fünf Leben. Enthält das Intervall des Unterschieds die 0?</translation>
    </message>
    <message>
        <source>Now you choose. Turn the resolution; each time a new life begins from nothing. Run six minutes in turbo and count the falls. Try wide tiles, narrow tiles, and what lies between.</source>
        <translation>Jetzt wählen Sie. Drehen Sie an der Auflösung; jedes Mal beginnt ein neues Leben von null an. Lassen Sie sechs Minuten im Turbo laufen und zählen Sie die Stürze. Probieren Sie breite Kacheln, schmale Kacheln und was dazwischen liegt.</translation>
    </message>
    <message>
        <source>Obey it now</source>
        <translation>Jetzt daran halten</translation>
    </message>
    <message>
        <source>On a walking robot standing still is to fall. What would a large weight do there?</source>
        <translation>Für einen Laufroboter heißt stillstehen stürzen. Was würde ein großes Gewicht dort bewirken?</translation>
    </message>
    <message>
        <source>On average the ten lives needed {mean(&quot;λ 0&quot;)} steps with λ = 0 and {mean(&quot;λ 0.9&quot;)} with λ = 0.9. After the first fall *right* from state 2 was worth −32.8, wrongly. After 100 episodes, still with λ = 0.9, it is worth {q(&quot;right&quot;)}.</source>
        <translation>Im Mittel brauchten die zehn Leben {mean(&quot;λ 0&quot;)} Schritte mit λ = 0 und {mean(&quot;λ 0.9&quot;)} mit λ = 0,9. Nach dem ersten Sturz war *rechts* von Zustand 2 zu Unrecht −32,8 wert. Nach 100 Episoden, weiter mit λ = 0,9, ist es {q(&quot;right&quot;)} wert.</translation>
    </message>
    <message>
        <source>On state 5: what is a step to the right worth, and what a step to the left?</source>
        <translation>Auf Zustand 5: Was ist ein Schritt nach rechts wert, und was einer nach links?</translation>
    </message>
    <message>
        <source>One fall</source>
        <translation>Ein Sturz</translation>
    </message>
    <message>
        <source>One fall, many guilty steps: traces share out the blame (λ).</source>
        <translation>Ein Sturz, viele schuldige Schritte: Traces verteilen die Schuld (λ).</translation>
    </message>
    <message>
        <source>One forgets a fall in a few episodes.</source>
        <translation>Einen Sturz vergisst man in wenigen Episoden.</translation>
    </message>
    <message>
        <source>One goal must be enough</source>
        <translation>Ein Ziel muss genügen</translation>
    </message>
    <message>
        <source>One knob</source>
        <translation>Ein Regler</translation>
    </message>
    <message>
        <source>One knob, another way</source>
        <translation>Ein Regler, ein anderer Weg</translation>
    </message>
    <message>
        <source>One life may be luck. So here are ten lives of each, each with a simulation of its own before. On average they fall {mean(&quot;ε 0.1&quot;)} and {mean(&quot;τ 1.5&quot;)} times. Think of the two states: in one the second best came close, {observed(1)} below the best; in the other it lay far below.</source>
        <translation>Ein Leben kann Glück sein. Darum hier je zehn Leben, jedes mit einer eigenen Simulation davor. Im Mittel stürzen sie {mean(&quot;ε 0.1&quot;)}- und {mean(&quot;τ 1.5&quot;)}-mal. Denken Sie an die zwei Zustände: In einem kam die zweitbeste nahe heran, {observed(1)} unter der besten; im anderen lag sie weit darunter.</translation>
    </message>
    <message>
        <source>One robot falls less often than another. Is it the better one, or had it luck? You judge from five lives, from thirty, and in pairs, and then read a claim as a referee would.</source>
        <translation>Ein Roboter stürzt seltener als ein anderer. Ist er besser, oder hatte er Glück? Sie urteilen nach fünf Leben, nach dreißig und in Paaren und lesen dann eine Behauptung, wie ein Gutachter es täte.</translation>
    </message>
    <message>
        <source>One step before</source>
        <translation>Einen Schritt früher</translation>
    </message>
    <message>
        <source>One step in five explores. Among how many actions does it then draw?</source>
        <translation>Ein Schritt von fünf exploriert. Unter wie vielen Aktionen lost es dann?</translation>
    </message>
    <message>
        <source>One step in ten is random, and one random step in four goes down.</source>
        <translation>Einer von zehn Schritten ist zufällig, und einer von vier zufälligen geht nach unten.</translation>
    </message>
    <message>
        <source>One step of learning</source>
        <translation>Ein Schritt Lernen</translation>
    </message>
    <message>
        <source>Only exploring brings chance into these lives. Ten greedy lives would need ten learned robots, not ten seeds.</source>
        <translation>Nur das Explorieren bringt Zufall in diese Leben. Zehn Greedy-Leben bräuchten zehn gelernte Roboter, nicht zehn Seeds.</translation>
    </message>
    <message>
        <source>Only one step is worth less than 0: left from state 2. Look at the map of states 3 to 8.</source>
        <translation>Nur ein Schritt ist weniger als 0 wert: links von Zustand 2. Sehen Sie auf der Karte die Zustände 3 bis 8 an.</translation>
    </message>
    <message>
        <source>Only the step from 7 compares Q(7, right) with what comes after it, Q(8, A′).</source>
        <translation>Nur der Schritt von 7 vergleicht Q(7, rechts) mit dem, was danach kommt, Q(8, A′).</translation>
    </message>
    <message>
        <source>Only the step left from state 2 leads to the fall. Look at the values of all the others.</source>
        <translation>Nur der Schritt nach links von Zustand 2 führt zum Sturz. Sehen Sie die Werte aller anderen an.</translation>
    </message>
    <message>
        <source>Only the step to the right from state 9 gives +100. Which state can learn from state 9?</source>
        <translation>Nur der Schritt nach rechts von Zustand 9 gibt +100. Welcher Zustand kann von Zustand 9 lernen?</translation>
    </message>
    <message>
        <source>Only what it has learned is different: which torque helps at which angle and rate.</source>
        <translation>Verschieden ist nur, was er gelernt hat: welches Drehmoment bei welchem Winkel und welcher Drehrate hilft.</translation>
    </message>
    <message>
        <source>Order them by falls in reality, the fewest first.</source>
        <translation>Ordnen Sie sie nach Stürzen in der Wirklichkeit, die wenigsten zuerst.</translation>
    </message>
    <message>
        <source>Pause first. The map has the same squares as the field; the cliff is its lowest row.</source>
        <translation>Halten Sie zuerst an. Die Karte hat dieselben Felder; ihre unterste Zeile ist die Klippe.</translation>
    </message>
    <message>
        <source>Play a fall back</source>
        <translation>Einen Sturz abspielen</translation>
    </message>
    <message>
        <source>Punish falls harder?</source>
        <translation>Stürze härter bestrafen?</translation>
    </message>
    <message>
        <source>Punished with −6400.</source>
        <translation>Bestraft mit −6400.</translation>
    </message>
    <message>
        <source>Put it next to the edge</source>
        <translation>An den Rand setzen</translation>
    </message>
    <message>
        <source>Put the robot on a square at the edge, and let it go on.</source>
        <translation>Setzen Sie den Roboter auf ein Feld am Rand und lassen Sie ihn weitergehen.</translation>
    </message>
    <message>
        <source>Q(3, left) is {observed(2)}. Now look at state 2. The robot had been here two steps earlier, too, and went *right*, away from the fall. That step is blamed as well: *right* is worth {q(&quot;right&quot;)} now, *left* {round(q(&quot;left&quot;))}.</source>
        <translation>Q(3, links) ist {observed(2)}. Sehen Sie jetzt Zustand 2 an. Der Roboter war zwei Schritte vorher schon einmal hier und ging nach *rechts*, weg vom Sturz. Auch dieser Schritt wird beschuldigt: *rechts* ist jetzt {q(&quot;right&quot;)} wert, *links* {round(q(&quot;left&quot;))}.</translation>
    </message>
    <message>
        <source>Q(7, right) is still 0. What must happen for it to change?</source>
        <translation>Q(7, rechts) ist noch 0. Was muss geschehen, damit sich das ändert?</translation>
    </message>
    <message>
        <source>Q(8, right) after 500 episodes</source>
        <translation>Q(8, rechts) nach 500 Episoden</translation>
    </message>
    <message>
        <source>Q-learning</source>
        <translation>Q-learning</translation>
    </message>
    <message>
        <source>Q-learning falls</source>
        <translation>Stürze Q-learning</translation>
    </message>
    <message>
        <source>Q-learning knows the better way and earns less. How can both be true?</source>
        <translation>Q-learning kennt den besseren Weg und verdient weniger. Wie kann beides wahr sein?</translation>
    </message>
    <message>
        <source>Q⁺ is as fine as before, and the goal as near.</source>
        <translation>Q⁺ ist so fein wie vorher, und das Ziel so nah.</translation>
    </message>
    <message>
        <source>Q⁻ 0.1</source>
        <translation>Q⁻ 0,1</translation>
    </message>
    <message>
        <source>Q⁻ 0.4</source>
        <translation>Q⁻ 0,4</translation>
    </message>
    <message>
        <source>Q⁻ 1</source>
        <translation>Q⁻ 1</translation>
    </message>
    <message>
        <source>Q⁻ had 29 tiles in a full turn of the pole. How wide is one now?</source>
        <translation>Q⁻ hatte 29 Kacheln in einer vollen Drehung des Stabs. Wie breit ist jetzt eine?</translation>
    </message>
    <message>
        <source>Rather a little too weak than too strong: the robot then takes more states for lost, and has something in reserve in reality. But not so weak that it cannot learn the task in the simulation.</source>
        <translation>Lieber etwas zu schwach als zu stark: Der Roboter hält dann mehr Zustände für verloren und hat in der Wirklichkeit Reserven. Aber nicht so schwach, dass er die Aufgabe in der Simulation nicht lernen kann.</translation>
    </message>
    <message>
        <source>Resolution 4 has learned just as long.</source>
        <translation>Auflösung 4 hat genauso lange gelernt.</translation>
    </message>
    <message>
        <source>Row after five steps of its way</source>
        <translation>Zeile nach fünf Schritten seines Weges</translation>
    </message>
    <message>
        <source>Sarsa</source>
        <translation>Sarsa</translation>
    </message>
    <message>
        <source>Sarsa falls</source>
        <translation>Stürze Sarsa</translation>
    </message>
    <message>
        <source>Sarsa values what it really does, random steps included; Q-learning values what it would do without them.</source>
        <translation>Sarsa bewertet, was es wirklich tut, zufällige Schritte eingeschlossen; Q-learning bewertet, was es ohne sie täte.</translation>
    </message>
    <message>
        <source>Set the weight so that it falls at most 15 times in 200 real episodes.</source>
        <translation>Stellen Sie das Gewicht so ein, dass er in 200 wirklichen Episoden höchstens 15-mal stürzt.</translation>
    </message>
    <message>
        <source>Set γ so that state 2 comes to be worth between 1 and 5, and put the robot on state 2.</source>
        <translation>Stellen Sie γ so ein, dass Zustand 2 schließlich zwischen 1 und 5 wert ist, und setzen Sie den Roboter auf Zustand 2.</translation>
    </message>
    <message>
        <source>Set λ so that after the first fall Q(3, left) is between −23 and −27.</source>
        <translation>Stellen Sie λ so ein, dass Q(3, links) nach dem ersten Sturz zwischen −23 und −27 liegt.</translation>
    </message>
    <message>
        <source>Share it out by hand</source>
        <translation>Von Hand verteilen</translation>
    </message>
    <message>
        <source>Six minutes with a coarse Q⁻</source>
        <translation>Sechs Minuten mit grobem Q⁻</translation>
    </message>
    <message>
        <source>Six minutes, both fine</source>
        <translation>Sechs Minuten, beide fein</translation>
    </message>
    <message>
        <source>Sixteen grids</source>
        <translation>Sechzehn Gitter</translation>
    </message>
    <message>
        <source>Sixteen grids of resolution 1: how many different values can a full turn have?</source>
        <translation>Sechzehn Gitter der Auflösung 1: Wie viele verschiedene Werte kann eine volle Drehung haben?</translation>
    </message>
    <message>
        <source>So far a fall cost 100 points: its **reward** was −100. What if it cost nothing, or 1600? Robots that know nothing live 500 episodes, ten lives for each reward. On average they fall {mean(&quot;reward 0&quot;)} times with 0, {mean(&quot;reward −100&quot;)} times with −100 and {mean(&quot;reward −1600&quot;)} times with −1600. ε is 0.05 for all.</source>
        <translation>Bisher kostete ein Sturz 100 Punkte: Seine **Belohnung** war −100. Und wenn er nichts kostete, oder 1600? Roboter, die nichts wissen, leben 500 Episoden, zehn Leben für jede Belohnung. Im Mittel stürzen sie {mean(&quot;reward 0&quot;)}-mal mit 0, {mean(&quot;reward −100&quot;)}-mal mit −100 und {mean(&quot;reward −1600&quot;)}-mal mit −1600. ε ist bei allen 0,05.</translation>
    </message>
    <message>
        <source>So far all lives began with what one robot had learned. Now each life has a simulation of its own, with strong motors: ten simulations for ε = 0.05, and ten **others** for ε = 0.1. Some simulations teach more than others.</source>
        <translation>Bisher begannen alle Leben mit dem, was ein Roboter gelernt hatte. Jetzt hat jedes Leben eine eigene Simulation, mit starken Motoren: zehn Simulationen für ε = 0,05 und zehn **andere** für ε = 0,1. Manche Simulationen lehren mehr als andere.</translation>
    </message>
    <message>
        <source>Softmax</source>
        <translation>Softmax</translation>
    </message>
    <message>
        <source>Softmax and greedy, five lives</source>
        <translation>Softmax und greedy, fünf Leben</translation>
    </message>
    <message>
        <source>Softmax and greedy, thirty lives</source>
        <translation>Softmax und greedy, dreißig Leben</translation>
    </message>
    <message>
        <source>Softmax and ε-greedy</source>
        <translation>Softmax und ε-greedy</translation>
    </message>
    <message>
        <source>Softmax, again thirty</source>
        <translation>Softmax, wieder dreißig</translation>
    </message>
    <message>
        <source>Softmax, five</source>
        <translation>Softmax, fünf</translation>
    </message>
    <message>
        <source>Somebody claims: &quot;In thirty lives Softmax fell {mean(&quot;Softmax, again thirty&quot;)} times and ε-greedy {mean(&quot;ε-greedy, again thirty&quot;)} times; the interval leaves out 0. So Softmax is the way not to fall.&quot; You remember: greedy fell {mean(&quot;greedy&quot;)} times.</source>
        <translation>Jemand behauptet: „In dreißig Leben stürzte Softmax {mean(&quot;Softmax, again thirty&quot;)}-mal und ε-greedy {mean(&quot;ε-greedy, again thirty&quot;)}-mal; das Intervall schließt die 0 aus. Also stürzt man mit Softmax am seltensten.“ Sie erinnern sich: Greedy stürzte {mean(&quot;greedy&quot;)}-mal.</translation>
    </message>
    <message>
        <source>Something between</source>
        <translation>Etwas dazwischen</translation>
    </message>
    <message>
        <source>State 6 is worth {observed(2)}, which is 0.9³ · 100. State 2 lies seven steps from state 9: 0.9⁷ · 100 is about 48. Turn γ and let the robot go on: the map follows. Click state 2 to put the robot there; it reads the value.</source>
        <translation>Zustand 6 ist {observed(2)} wert, das ist 0,9³ · 100. Zustand 2 liegt sieben Schritte von Zustand 9: 0,9⁷ · 100 ist etwa 48. Drehen Sie an γ und lassen Sie den Roboter weitermachen: Die Karte folgt. Klicken Sie auf Zustand 2, um den Roboter dorthin zu setzen; dann steht der Wert da.</translation>
    </message>
    <message>
        <source>States that need different actions share a tile.</source>
        <translation>Zustände, die verschiedene Aktionen brauchen, teilen eine Kachel.</translation>
    </message>
    <message>
        <source>Step 1: the values grow from the goal backwards, one state at a time. Let somebody say it aloud: &quot;the worth of a state is γ times the worth of the next one&quot;.

Step 6 is the one for a vote. Expect to hear that far-sighted is best, and 4 to 6 steps. With γ = 1 all values tie at 100, so the robot tosses a coin except at the edge of the fall. It takes about as long as with γ = 0, for the opposite reason: there all are worth 0. In step 8 any γ between, even 0.5, makes it go straight; only the size of the values changes.

For those who know the field: Q-learning with α = 1 and ε = 0.2, so that in this world without chance the values are exact and really tie. It takes one step in five at random; that is why 4.5 steps, the shortest possible, are not quite reached. γ = 1 is not wrong as such: at the cliff each step costs 1, and γ = 1 is the usual choice there.</source>
        <translation>Schritt 1: Die Werte wachsen vom Ziel aus rückwärts, ein Zustand nach dem anderen. Lassen Sie es jemanden laut sagen: „Ein Zustand ist γ-mal so viel wert wie der nächste.“

Schritt 6 eignet sich für eine Abstimmung. Erwarten Sie, dass weitsichtig am besten sei, und 4 bis 6 Schritte. Mit γ = 1 sind alle Werte gleich 100, sodass der Roboter eine Münze wirft, außer am Rand des Sturzes. Er braucht etwa so lange wie mit γ = 0, aus dem umgekehrten Grund: Dort sind alle 0 wert. In Schritt 8 lässt ihn jedes γ dazwischen, selbst 0,5, geradeaus gehen; nur die Größe der Werte ändert sich.

Für Fachleute: Q-learning mit α = 1 und ε = 0,2, sodass die Werte in dieser Welt ohne Zufall exakt sind und wirklich gleich werden. Jeder fünfte Schritt ist zufällig; darum werden 4,5 Schritte, das kürzest Mögliche, nicht ganz erreicht. γ = 1 ist an sich nicht falsch: An der Klippe kostet jeder Schritt 1, und dort ist γ = 1 die übliche Wahl.</translation>
    </message>
    <message>
        <source>Step 3 computes for about ten seconds, on a slow machine for half a minute: talk meanwhile. Seeds 1 to 4, one life each: first ten minutes 300 to 383 falls, two hours 768 to 1,897, the ten minutes after 13 to 46; on the other robot in ten minutes ε 0.05 6 to 45, greedy 0 to 11, and greedy less every time. The recipe walker-mismatch has 25 learned robots and a whole hour: ε 0.05 163 ± 36 falls, ε 0.01 65 ± 19, greedy 34 ± 14. With which of them a life begins matters more than the policy: greedy falls 1 to 137 times in that hour. What they should not take home: that greedy is best for learning from nothing. There it falls less, too, but only 13 of 30 lives walk at the end, with ε 0.05 25 of 30 (recipe walker-scratch).</source>
        <translation>Schritt 3 rechnet etwa zehn Sekunden, auf einer langsamen Maschine eine halbe Minute: Reden Sie inzwischen. Seeds 1 bis 4, je ein Leben: erste zehn Minuten 300 bis 383 Stürze, zwei Stunden 768 bis 1 897, die zehn Minuten danach 13 bis 46; auf dem anderen Roboter in zehn Minuten ε 0,05 6 bis 45, greedy 0 bis 11, und greedy jedes Mal weniger. Das Rezept walker-mismatch hat 25 gelernte Roboter und eine ganze Stunde: ε 0,05 163 ± 36 Stürze, ε 0,01 65 ± 19, greedy 34 ± 14. Mit welchem davon ein Leben beginnt, ist wichtiger als die Policy: greedy stürzt in dieser Stunde 1- bis 137-mal. Was man nicht mitnehmen soll: dass greedy zum Lernen von null an am besten sei. Auch dort stürzt es seltener, aber am Ende gehen nur 13 von 30 Leben, mit ε 0,05 25 von 30 (Rezept walker-scratch).</translation>
    </message>
    <message>
        <source>Steps in the first ten episodes</source>
        <translation>Schritte in den ersten zehn Episoden</translation>
    </message>
    <message>
        <source>Steps per episode, over 300 episodes</source>
        <translation>Schritte je Episode, über 300 Episoden</translation>
    </message>
    <message>
        <source>Steps per episode: {observed(4)} with γ = 0.9, {observed(5)} with γ = 0. Now **γ = 1**: a reward counts in full, however far away it is. The robot begins again and lives 300 episodes.</source>
        <translation>Schritte je Episode: {observed(4)} mit γ = 0,9, {observed(5)} mit γ = 0. Jetzt **γ = 1**: Eine Belohnung zählt voll, wie weit entfernt sie auch ist. Der Roboter beginnt neu und lebt 300 Episoden.</translation>
    </message>
    <message>
        <source>Steps with an action other than the best, of 100</source>
        <translation>Schritte mit einer anderen Aktion als der besten, von 100</translation>
    </message>
    <message>
        <source>TRL 100</source>
        <translation>TRL 100</translation>
    </message>
    <message>
        <source>TRL 50</source>
        <translation>TRL 50</translation>
    </message>
    <message>
        <source>TRL 50, ε 0.2</source>
        <translation>TRL 50, ε 0,2</translation>
    </message>
    <message>
        <source>TRL with a threshold of 50 fell less than ε-greedy with the same ε. But who says that ε must be 0.2? Ten lives of each: TRL 50 with ε = 0.2, and plain ε-greedy with ε = 0.05.</source>
        <translation>TRL mit einer Schwelle von 50 stürzte seltener als ε-greedy mit demselben ε. Aber wer sagt, dass ε 0,2 sein muss? Je zehn Leben: TRL 50 mit ε = 0,2 und einfaches ε-greedy mit ε = 0,05.</translation>
    </message>
    <message>
        <source>Take the pole in your hand</source>
        <translation>Den Stab in die Hand nehmen</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Ten lives each: on average {mean(&quot;Q⁻ 1&quot;)} falls with resolution 1 of Q⁻, {mean(&quot;Q⁻ 0.4&quot;)} with 0.4 and {mean(&quot;Q⁻ 0.1&quot;)} with **0.1**. Here is one with 0.1 after 20 episodes, held nearly upright, at 3°. Two of its five actions promise a heavy loss there: {q(&quot;0&quot;)} and {q(&quot;1.5&quot;)}.</source>
        <translation>Je zehn Leben: im Mittel {mean(&quot;Q⁻ 1&quot;)} Stürze mit Auflösung 1 von Q⁻, {mean(&quot;Q⁻ 0.4&quot;)} mit 0,4 und {mean(&quot;Q⁻ 0.1&quot;)} mit **0,1**. Hier ist eines mit 0,1 nach 20 Episoden, fast aufrecht festgehalten, bei 3°. Zwei seiner fünf Aktionen versprechen dort einen schweren Verlust: {q(&quot;0&quot;)} und {q(&quot;1.5&quot;)}.</translation>
    </message>
    <message>
        <source>Ten lives give an interval of ± 4 falls. About how many give ± 1?</source>
        <translation>Zehn Leben ergeben ein Intervall von ± 4 Stürzen. Wie viele ergeben etwa ± 1?</translation>
    </message>
    <message>
        <source>Ten lives of each</source>
        <translation>Je zehn Leben</translation>
    </message>
    <message>
        <source>Ten lives with each resolution, the first two minutes. Falls on average: {mean(&quot;resolution 0.25&quot;)} with 0.25; {mean(&quot;resolution 1&quot;)} with 1; {mean(&quot;resolution 4&quot;)} with 4; {mean(&quot;resolution 8&quot;)} with 8.</source>
        <translation>Zehn Leben mit jeder Auflösung, die ersten zwei Minuten. Stürze im Mittel: {mean(&quot;resolution 0.25&quot;)} mit 0,25; {mean(&quot;resolution 1&quot;)} mit 1; {mean(&quot;resolution 4&quot;)} mit 4; {mean(&quot;resolution 8&quot;)} mit 8.</translation>
    </message>
    <message>
        <source>Ten lives with each γ: at most {most(&quot;γ 0.9&quot;)} steps per episode with γ = 0.9, at least {least(&quot;γ 0&quot;)} with γ = 0, at least {least(&quot;γ 1&quot;)} with γ = 1. On the map states 2 to 9 are all worth 100 now. The goal is known, and still it takes its time.</source>
        <translation>Zehn Leben mit jedem γ: höchstens {most(&quot;γ 0.9&quot;)} Schritte je Episode mit γ = 0,9, mindestens {least(&quot;γ 0&quot;)} mit γ = 0, mindestens {least(&quot;γ 1&quot;)} mit γ = 1. Auf der Karte sind die Zustände 2 bis 9 jetzt alle 100 wert. Das Ziel ist bekannt, und doch lässt er sich Zeit.</translation>
    </message>
    <message>
        <source>Ten minutes are 600 seconds. For how long does it stay up?</source>
        <translation>Zehn Minuten sind 600 Sekunden. Wie lange bleibt er auf den Beinen?</translation>
    </message>
    <message>
        <source>Ten pairs</source>
        <translation>Zehn Paare</translation>
    </message>
    <message>
        <source>Ten states in a row</source>
        <translation>Zehn Zustände in einer Reihe</translation>
    </message>
    <message>
        <source>Ten states in a row, a fall at one end and the goal at the other. You work out what a state is worth, turn the knob that decides how far a reward reaches, and watch what the robot makes of it.</source>
        <translation>Zehn Zustände in einer Reihe, an einem Ende ein Sturz und am anderen das Ziel. Sie rechnen aus, was ein Zustand wert ist, drehen an dem Regler, der bestimmt, wie weit eine Belohnung reicht, und sehen, was der Roboter daraus macht.</translation>
    </message>
    <message>
        <source>Ten states in a row. State 1 is a fall: reward −100. State 10 is the goal: +100. All other steps give 0. The robot starts in between and steps left or right. The map shows what each state is worth so far: what the better step promises. Which state learns first?</source>
        <translation>Zehn Zustände in einer Reihe. Zustand 1 ist ein Sturz: Belohnung −100. Zustand 10 ist das Ziel: +100. Alle anderen Schritte geben 0. Der Roboter beginnt dazwischen und geht nach links oder rechts. Die Karte zeigt, was jeder Zustand bisher wert ist: was der bessere Schritt verspricht. Welcher Zustand lernt zuerst?</translation>
    </message>
    <message>
        <source>Ten states in a row: how far a reward reaches, from γ = 0 to γ = 1.</source>
        <translation>Zehn Zustände in einer Reihe: wie weit eine Belohnung reicht, von γ = 0 bis γ = 1.</translation>
    </message>
    <message>
        <source>The cliff: Sarsa or Q-learning?</source>
        <translation>Die Klippe: Sarsa oder Q-learning?</translation>
    </message>
    <message>
        <source>The difference is there, but Softmax cannot be told from greedy. A method has to beat the best simple one.</source>
        <translation>Der Unterschied ist da, aber Softmax lässt sich nicht von greedy unterscheiden. Eine Methode muss die beste einfache schlagen.</translation>
    </message>
    <message>
        <source>The episodes are numbered along the bottom of the chart. The last twenty are at its right end.</source>
        <translation>Die Episoden sind am unteren Rand des Diagramms nummeriert. Die letzten zwanzig stehen ganz rechts.</translation>
    </message>
    <message>
        <source>The falls of the other one</source>
        <translation>Die Stürze des anderen</translation>
    </message>
    <message>
        <source>The first surprise</source>
        <translation>Die erste Überraschung</translation>
    </message>
    <message>
        <source>The first ten minutes</source>
        <translation>Die ersten zehn Minuten</translation>
    </message>
    <message>
        <source>The first two minutes</source>
        <translation>Die ersten zwei Minuten</translation>
    </message>
    <message>
        <source>The goal gives the same 100 as with γ = 0.9, where the robot hurried.</source>
        <translation>Das Ziel gibt dieselben 100 wie mit γ = 0,9, wo der Roboter sich beeilte.</translation>
    </message>
    <message>
        <source>The goal gives too little.</source>
        <translation>Das Ziel bringt zu wenig.</translation>
    </message>
    <message>
        <source>The greedy robot still learns. From what?</source>
        <translation>Der Greedy-Roboter lernt immer noch. Woraus?</translation>
    </message>
    <message>
        <source>The idea in one sentence: what is learned (values and risk) and what is done with it (the policy) are two things, and only the second has to be careful in reality. The risk is a probability of its own (Geibel and Wysotzki 2005), learned as a value is, with a reward of 1 for a fall.

Why is a penalty not the same? While it learns in one world only, it is, exactly: choosing by Q − wρ with ρ on the tiles of Q is a fall reward lower by w, life for life. The difference is the change from one world to the other: a penalty must be there from the beginning, and makes the lesson timid.

Greedy is the fair opponent, because who does not explore does not fall from exploring. Ask for it before you show it: here it falls even more often, because it does what was right in the simulation and corrects it late. Ten lives each fell 75 times on average as bold as before, 93 greedy, 22 punished with −6400, 11 careful.</source>
        <translation>Die Idee in einem Satz: Was gelernt wird (Werte und Risiko) und was damit getan wird (die Policy), sind zwei Dinge, und nur das zweite muss in der Wirklichkeit vorsichtig sein. Das Risiko ist eine eigene Wahrscheinlichkeit (Geibel und Wysotzki 2005), gelernt wie ein Wert, mit einer Belohnung von 1 für einen Sturz.

Warum ist eine Strafe nicht dasselbe? Solange er nur in einer Welt lernt, ist sie es genau: Nach Q − wρ zu wählen, mit ρ auf den Kacheln von Q, ist eine um w niedrigere Sturzbelohnung, Leben für Leben. Der Unterschied liegt im Wechsel von einer Welt zur anderen: Eine Strafe muss von Anfang an da sein und macht das Lernen dort ängstlich.

Greedy ist der faire Gegner, denn wer nicht exploriert, stürzt nicht durchs Explorieren. Fragen Sie danach, bevor Sie es zeigen: Hier stürzt es sogar öfter, weil es tut, was in der Simulation richtig war, und es spät berichtigt. Je zehn Leben stürzten im Mittel 75-mal so kühn wie vorher, 93-mal greedy, 22-mal bestraft mit −6400, 11-mal vorsichtig.</translation>
    </message>
    <message>
        <source>The last step brought the first surprise: δ = 100, and Q(9, right) rose by 0.5 · 100 to 50. Now the robot is put on state 9 again and goes right again. The reward is R = 100. After the goal there is no next step, so γ Q(S′, A′) is 0.</source>
        <translation>Der letzte Schritt brachte die erste Überraschung: δ = 100, und Q(9, rechts) stieg um 0,5 · 100 auf 50. Nun wird der Roboter wieder auf Zustand 9 gesetzt und geht wieder nach rechts. Die Belohnung ist R = 100. Nach dem Ziel gibt es keinen nächsten Schritt, also ist γ Q(S′, A′) gleich 0.</translation>
    </message>
    <message>
        <source>The left robot explores with any action, also one that is worth far less than the best. The right one seldom takes such an action: how seldom, its temperature decides.</source>
        <translation>Der linke Roboter exploriert mit jeder Aktion, auch einer, die viel weniger wert ist als die beste. Der rechte nimmt so eine Aktion selten: Wie selten, bestimmt seine Temperatur.</translation>
    </message>
    <message>
        <source>The lesson was as bold as before, so it met many falls; what it learned of them is obeyed where it counts.</source>
        <translation>Die Lektion war so kühn wie vorher, brachte also viele Stürze; an das, was er aus ihnen lernte, hält er sich, wo es zählt.</translation>
    </message>
    <message>
        <source>The map shows Q⁻ below. How much of it has a value at all?</source>
        <translation>Die Karte zeigt unten Q⁻. Wie viel davon hat überhaupt einen Wert?</translation>
    </message>
    <message>
        <source>The other robot, greedy</source>
        <translation>Der andere Roboter, greedy</translation>
    </message>
    <message>
        <source>The pole falls to both sides alike. What would a tile of 360° say?</source>
        <translation>Der Stab fällt nach beiden Seiten gleich. Was würde eine Kachel von 360° sagen?</translation>
    </message>
    <message>
        <source>The practised robot begins as far over. Look at where its episodes begin.</source>
        <translation>Der geübte Roboter beginnt ebenso schief. Sehen Sie, wo seine Episoden beginnen.</translation>
    </message>
    <message>
        <source>The risk is a probability: it counts falls, whatever they cost.</source>
        <translation>Das Risiko ist eine Wahrscheinlichkeit: Es zählt Stürze, was immer sie kosten.</translation>
    </message>
    <message>
        <source>The robot begins again and lives 100 episodes. Each time it steps right from state 9 the reward is 100, and the surprise is half as large as the time before: 100, 50, 25 …</source>
        <translation>Der Roboter beginnt neu und lebt 100 Episoden. Jedes Mal, wenn er von Zustand 9 nach rechts geht, ist die Belohnung 100 und die Überraschung halb so groß wie beim vorigen Mal: 100, 50, 25 …</translation>
    </message>
    <message>
        <source>The robot is told 200 and −100. What would it learn if a fall cost nothing?</source>
        <translation>Dem Roboter werden 200 und −100 mitgeteilt. Was würde er lernen, wenn ein Sturz nichts kostete?</translation>
    </message>
    <message>
        <source>The robot knows nothing yet and walks at random until it falls: −100. α is 0.5. Only the last step learns from the fall: *left* from state 2 loses 50. Follow the walk. Did the steps before it have no part in the fall?</source>
        <translation>Der Roboter weiß noch nichts und geht zufällig umher, bis er stürzt: −100. α ist 0,5. Nur der letzte Schritt lernt aus dem Sturz: *links* von Zustand 2 verliert 50. Verfolgen Sie den Weg. Hatten die Schritte davor keinen Anteil am Sturz?</translation>
    </message>
    <message>
        <source>The robot must reach the goal once more.</source>
        <translation>Der Roboter muss das Ziel noch einmal erreichen.</translation>
    </message>
    <message>
        <source>The robot must step from 7 to 8.</source>
        <translation>Der Roboter muss von 7 nach 8 gehen.</translation>
    </message>
    <message>
        <source>The same beginning, but now the **resolution** of Q⁻, the knob *scale*, is 0.4 in place of 1: its tiles are wider. Q⁺ stays as it was. Again 20 episodes, {falls} falls. In the same state it now expects {q(&quot;0&quot;)}. With wider tiles a fall is felt further away.</source>
        <translation>Derselbe Anfang, aber jetzt ist die **Auflösung** von Q⁻, der Regler *Skalierung*, 0,4 statt 1: Seine Kacheln sind breiter. Q⁺ blieb, wie es war. Wieder 20 Episoden, {falls} Stürze. Im selben Zustand erwartet er jetzt {q(&quot;0&quot;)}. Mit breiteren Kacheln ist ein Sturz weiter weg zu spüren.</translation>
    </message>
    <message>
        <source>The same once more, but in **pairs**: both ε begin with what was learned in the same ten simulations, and the difference within each pair is judged. What makes both lives of a pair good or bad drops out.</source>
        <translation>Dasselbe noch einmal, aber in **Paaren**: Beide ε beginnen mit dem, was in denselben zehn Simulationen gelernt wurde, und beurteilt wird der Unterschied in jedem Paar. Was beide Leben eines Paars gut oder schlecht macht, fällt heraus.</translation>
    </message>
    <message>
        <source>The same robot after 20 minutes</source>
        <translation>Derselbe Roboter nach 20 Minuten</translation>
    </message>
    <message>
        <source>The same robot could obey its risk in the simulation already. Then it would fall less there, too.</source>
        <translation>Derselbe Roboter könnte sich schon in der Simulation an sein Risiko halten. Dann würde er auch dort seltener stürzen.</translation>
    </message>
    <message>
        <source>The same step again</source>
        <translation>Derselbe Schritt noch einmal</translation>
    </message>
    <message>
        <source>The states are cut into **tiles**, and states in one tile share their values. A full turn of the pole is cut into 12 tiles times the **resolution** (the knob *Scale*), here 0.25. The robot has learned from nothing for two minutes. The map has two of them, one for each side, and ends before they do.</source>
        <translation>Die Zustände werden in **Kacheln** geteilt, und Zustände in einer Kachel teilen ihre Werte. Eine volle Drehung des Stabs wird in 12 Kacheln mal der **Auflösung** (der Regler *Skalierung*) geteilt, hier 0,25. Der Roboter hat zwei Minuten von null an gelernt. Die Karte zeigt zwei davon, eine für jede Seite, und endet, bevor sie es tun.</translation>
    </message>
    <message>
        <source>The step into the goal changes Q(9, right) only. Look at what the last step changed.</source>
        <translation>Der Schritt ins Ziel ändert nur Q(9, rechts). Sehen Sie nach, was der letzte Schritt geändert hat.</translation>
    </message>
    <message>
        <source>The steps it takes</source>
        <translation>Die Schritte, die er braucht</translation>
    </message>
    <message>
        <source>The ten minutes after</source>
        <translation>Die zehn Minuten danach</translation>
    </message>
    <message>
        <source>The walk to the first fall is 4, 3, 4, 3, 2, 3, 2, fall, for everybody: nothing is learned before it, so λ does not change it. Draw it on the board and let the class say who is guilty before step 2.

Step 2: whoever says 45 has forgotten γ or λ. The marks fade by the product.

Strictly, every step but the last could still be undone here. On a robot it is otherwise: when a pole falls, the last steps cannot save it any more, and those that could were taken earlier.

Step 3 is the heart: *right* from state 2 was the step that saved the robot, and it loses 32.8. Those who say that all actions of a state are blamed have a point in other programs, not here: *left* lost 50.

Step 5 and 6: with λ = 0 this life needs 7 goals until it stands on state 5 and knows, with λ = 0.9 it needs 2. Over 24 other seeds it was 5 to 14 with λ = 0, 1 to 6 with λ = 0.9, and never more with λ = 0.9 than with λ = 0. That it is not always 1 has two reasons: the first way to the goal need not lead past state 5, and the robot has to be on state 5 to show that it knows.</source>
        <translation>Der Weg bis zum ersten Sturz ist für alle 4, 3, 4, 3, 2, 3, 2, Sturz: Vorher wird nichts gelernt, also ändert λ ihn nicht. Zeichnen Sie ihn an die Tafel und lassen Sie den Kurs vor Schritt 2 sagen, wer schuld ist.

Schritt 2: Wer 45 sagt, hat γ oder λ vergessen. Die Marken verblassen mit dem Produkt.

Streng genommen wäre hier jeder Schritt außer dem letzten noch gutzumachen. Bei einem Roboter ist das anders: Wenn ein Stab fällt, können ihn die letzten Schritte nicht mehr retten, und die, die es konnten, liegen weiter zurück.

Schritt 3 ist der Kern: *rechts* von Zustand 2 war der Schritt, der den Roboter rettete, und er verliert 32,8. Wer sagt, dass alle Aktionen eines Zustands beschuldigt werden, hätte in anderen Programmen nicht unrecht, hier aber schon: *links* verlor 50.

Schritt 5 und 6: Mit λ = 0 braucht dieses Leben 7 Ziele, bis es auf Zustand 5 steht und es weiß, mit λ = 0,9 sind es 2. Bei 24 anderen Seeds waren es 5 bis 14 mit λ = 0, 1 bis 6 mit λ = 0,9, und mit λ = 0,9 nie mehr als mit λ = 0. Dass es nicht immer 1 ist, hat zwei Gründe: Der erste Weg zum Ziel muss nicht an Zustand 5 vorbeiführen, und der Roboter muss auf Zustand 5 stehen, um zu zeigen, dass er es weiß.</translation>
    </message>
    <message>
        <source>The way of good news, λ = 0</source>
        <translation>Der Weg guter Nachrichten, λ = 0</translation>
    </message>
    <message>
        <source>The way of good news, λ = 0.9</source>
        <translation>Der Weg guter Nachrichten, λ = 0,9</translation>
    </message>
    <message>
        <source>The weight is a knob for reality alone: turn it while the robot lives, and nothing must be learned anew. It begins at 0. A penalty is not such a knob: it is part of what was learned.</source>
        <translation>Das Gewicht ist ein Regler nur für die Wirklichkeit: Drehen Sie daran, während der Roboter lebt; nichts muss neu gelernt werden. Es beginnt bei 0. Eine Strafe ist kein solcher Regler: Sie ist Teil dessen, was gelernt wurde.</translation>
    </message>
    <message>
        <source>The wheel&apos;s rate is cut into tiles, too. Would you give it the same width as the pole&apos;s angle?</source>
        <translation>Auch die Drehrate des Rades wird in Kacheln geteilt. Würden Sie ihr dieselbe Breite geben wie dem Winkel des Stabs?</translation>
    </message>
    <message>
        <source>The ε-greedy lives differ within the same three minutes.</source>
        <translation>Die ε-greedy-Leben unterscheiden sich in denselben drei Minuten.</translation>
    </message>
    <message>
        <source>Then both would be worth the same. Look at the two bars.</source>
        <translation>Dann wären beide gleich viel wert. Sehen Sie die zwei Balken an.</translation>
    </message>
    <message>
        <source>Then it would expect a gain. It expects nearly nothing.</source>
        <translation>Dann würde er einen Gewinn erwarten. Er erwartet fast nichts.</translation>
    </message>
    <message>
        <source>Then those that stop exploring would fall as often. Look at the dots.</source>
        <translation>Dann würden die, die nicht mehr explorieren, ebenso oft stürzen. Sehen Sie die Punkte an.</translation>
    </message>
    <message>
        <source>There are 343 actions, and a state is ten numbers. No table can hold each state by itself; 16 displaced grids of tiles share them out. It begins again, with ε = 0.05. Ten simulated minutes take the computer a second or two.</source>
        <translation>Es gibt 343 Aktionen, und ein Zustand sind zehn Zahlen. Keine Tabelle kann jeden Zustand einzeln fassen; 16 versetzte Gitter von Kacheln teilen sie auf. Er beginnt neu, mit ε = 0,05. Zehn simulierte Minuten brauchen auf dem Rechner ein, zwei Sekunden.</translation>
    </message>
    <message>
        <source>There is another opponent. The **greedy** policy always takes the best action it knows: it takes another in 0 of 100 steps. Ten lives each, greedy and Softmax with τ = 1.5. The program judges the difference life by life: if its 95 % interval holds 0, one cannot tell.</source>
        <translation>Es gibt noch einen Gegner. Die **Greedy**-Policy nimmt immer die beste Aktion, die sie kennt: in 0 von 100 Schritten eine andere. Je zehn Leben, greedy und Softmax mit τ = 1,5. Das Programm beurteilt den Unterschied Leben für Leben: Enthält sein 95-%-Intervall die 0, lässt es sich nicht sagen.</translation>
    </message>
    <message>
        <source>They forget sooner.</source>
        <translation>Sie vergessen schneller.</translation>
    </message>
    <message>
        <source>They have nothing left to learn.</source>
        <translation>Sie haben nichts mehr zu lernen.</translation>
    </message>
    <message>
        <source>They keep what they learned, as wide ones do.</source>
        <translation>Sie behalten, was sie gelernt haben, wie breite auch.</translation>
    </message>
    <message>
        <source>They learn from every step, as the others do.</source>
        <translation>Sie lernen aus jedem Schritt, wie die anderen.</translation>
    </message>
    <message>
        <source>They tell more apart than wider ones.</source>
        <translation>Sie unterscheiden mehr als breitere.</translation>
    </message>
    <message>
        <source>They tell too few states apart.</source>
        <translation>Sie unterscheiden zu wenige Zustände.</translation>
    </message>
    <message>
        <source>Think of the two states: which actions did Softmax hardly ever take?</source>
        <translation>Denken Sie an die zwei Zustände: Welche Aktionen nahm Softmax fast nie?</translation>
    </message>
    <message>
        <source>Thirty lives of each</source>
        <translation>Je dreißig Leben</translation>
    </message>
    <message>
        <source>Thirty were enough: the interval leaves out 0.</source>
        <translation>Dreißig genügten: Das Intervall schließt die 0 aus.</translation>
    </message>
    <message>
        <source>This Sarsa walks {observed(2)} steps. **Q-learning** values a step by the best step that it could take next. Ten lives of each learned for 500 episodes; then they walk without exploring. The dots show their row after five steps: row 1 is the edge, row 3 the top.</source>
        <translation>Dieses Sarsa geht {observed(2)} Schritte. **Q-learning** bewertet einen Schritt nach dem besten, den es danach gehen könnte. Je zehn Leben lernten 500 Episoden; nun gehen sie ohne zu explorieren. Die Punkte zeigen ihre Zeile nach fünf Schritten: Zeile 1 ist der Rand, Zeile 3 liegt oben.</translation>
    </message>
    <message>
        <source>This is Example 6.6 of Sutton and Barto, with their ε = 0.1 and γ = 1, and α = 0.3. Say &quot;the short way&quot; and &quot;the long way&quot; until step 3, not the names: that is the prediction.

Step 2: whoever knows shortest-path problems may say 13. Of 200 Sarsa lives that we tried 184 had a way of 17 steps, 5 of 15, 3 of 19, and 8 went in a circle, because their values were still noisy when learning stopped. After five steps 198 of them were on row 2 or 3. Q-learning&apos;s way had 13 steps in all lives that we tried.

Step 6 has a trap: to set ε to 0 without starting again does not change the way. What the squares at the edge are worth was learned with falls, and without exploring the robot never goes there to correct it. That is worth a discussion of its own. A very small ε is not enough either: at 0.005 most lives still keep off the edge.

Which is better? While they explore Sarsa earns more (about −23 against −48 in the last 80 episodes), afterwards Q-learning does (−13 against −17). &quot;Better&quot; needs a &quot;when&quot;.

Step 7: of ten lives each falls about twelve times, once for each way over the edge, and its way has 13 steps. With ε = 0 it falls as rarely; but this one goes on exploring, in one step of fifteen. To forbid the greedy action as well (the rule *filter*) does not work here: standing still in a corner is the safest of all.</source>
        <translation>Das ist Beispiel 6.6 von Sutton und Barto, mit ihrem ε = 0,1 und γ = 1, und α = 0,3. Sagen Sie bis Schritt 3 „der kurze Weg“ und „der lange Weg“, nicht die Namen: Das ist die Vorhersage.

Schritt 2: Wer Kürzeste-Wege-Probleme kennt, sagt vielleicht 13. Von 200 Leben mit Sarsa, die wir probierten, hatten 184 einen Weg von 17 Schritten, 5 von 15, 3 von 19, und 8 gingen im Kreis, weil ihre Werte noch rauschten, als das Lernen endete. Nach fünf Schritten waren 198 von ihnen in Zeile 2 oder 3. Der Weg von Q-learning hatte in allen Leben, die wir probierten, 13 Schritte.

Schritt 6 hat eine Falle: ε auf 0 zu setzen, ohne neu zu starten, ändert den Weg nicht. Was die Felder am Rand wert sind, wurde mit Stürzen gelernt, und ohne Explorieren kommt der Roboter nie dorthin, um es zu berichtigen. Das ist ein eigenes Gespräch wert. Ein sehr kleines ε genügt auch nicht: Bei 0,005 halten die meisten Leben noch Abstand.

Welche ist besser? Solange sie explorieren, verdient Sarsa mehr (etwa −23 gegen −48 in den letzten 80 Episoden), danach Q-learning (−13 gegen −17). Zu „besser“ gehört ein „wann“.

Schritt 7: Von zehn Leben stürzt jedes etwa zwölfmal, einmal für jede Art, über den Rand zu gehen, und sein Weg hat 13 Schritte. Mit ε = 0 stürzt es ebenso selten; dieses hier exploriert aber weiter, in einem von fünfzehn Schritten. Auch die Greedy-Aktion zu verbieten (die Regel *filter*) taugt hier nicht: In einer Ecke stillzustehen ist das Sicherste von allem.</translation>
    </message>
    <message>
        <source>This is Sarsa again, after 500 episodes with ε = 0.1. Turn one knob, then press Restart, the round arrow: it must learn anew. A way of 13 steps without a fall gives a reward of −13 an episode. Look at the average reward of the last 80 episodes.</source>
        <translation>Das ist wieder Sarsa, nach 500 Episoden mit ε = 0,1. Drehen Sie an einem Regler und drücken Sie dann Neustart, den runden Pfeil: Es muss neu lernen. Ein Weg von 13 Schritten ohne Sturz gibt eine Belohnung von −13 je Episode. Sehen Sie auf die mittlere Belohnung der letzten 80 Episoden.</translation>
    </message>
    <message>
        <source>This robot has learned in a simulation. Its pole leans a little and swings back up. The bars show what each action is worth, **Q**, and how likely **Softmax** takes it: the better, the likelier. One knob sets how much likelier, the temperature **τ**. Drag it down and up; type 1000 into its number.</source>
        <translation>Dieser Roboter hat in einer Simulation gelernt. Sein Stab neigt sich etwas und schwingt zurück. Die Balken zeigen, was jede Aktion wert ist, **Q**, und wie wahrscheinlich **Softmax** sie wählt: je besser, desto eher. Ein Regler bestimmt, wie viel eher, die Temperatur **τ**. Ziehen Sie ihn hinab und hinauf; tippen Sie 1000 in seine Zahl.</translation>
    </message>
    <message>
        <source>This robot learned for ten minutes in a simulation whose motors are **2.5 times too strong**. It chooses by Softmax, with τ = 1. Now it lives 200 episodes in reality, as boldly as in the simulation. Count its falls.</source>
        <translation>Dieser Roboter lernte zehn Minuten in einer Simulation, deren Motoren **2,5-mal zu stark** sind. Er wählt mit Softmax, τ = 1. Jetzt lebt er 200 Episoden in der Wirklichkeit, so kühn wie in der Simulation. Zählen Sie seine Stürze.</translation>
    </message>
    <message>
        <source>This robot learned in a simulation that was not quite right. Now it stands in reality. With **ε = 0.05** it takes one action in 20 at random: it **explores**, to see whether there is something better. Here are its first 200 episodes.</source>
        <translation>Dieser Roboter hat in einer Simulation gelernt, die nicht ganz stimmte. Jetzt steht er in der Wirklichkeit. Mit **ε = 0,05** wählt er eine von 20 Aktionen zufällig: Er **exploriert**, um zu sehen, ob es etwas Besseres gibt. Hier sind seine ersten 200 Episoden.</translation>
    </message>
    <message>
        <source>Those that stopped exploring still know it. Look at the dots.</source>
        <translation>Die, die nicht mehr explorieren, wissen es noch. Sehen Sie die Punkte an.</translation>
    </message>
    <message>
        <source>Three lives of each</source>
        <translation>Je drei Leben</translation>
    </message>
    <message>
        <source>Three minutes are too short to differ.</source>
        <translation>Drei Minuten sind zu kurz für Unterschiede.</translation>
    </message>
    <message>
        <source>Three thresholds, ten lives each</source>
        <translation>Drei Schwellen, je zehn Leben</translation>
    </message>
    <message>
        <source>Tiles: too coarse, too fine</source>
        <translation>Kacheln: zu grob, zu fein</translation>
    </message>
    <message>
        <source>True, but look at the other end, too.</source>
        <translation>Richtig, aber sehen Sie auch das andere Ende an.</translation>
    </message>
    <message>
        <source>Try resolutions between 1 and 4.</source>
        <translation>Probieren Sie Auflösungen zwischen 1 und 4.</translation>
    </message>
    <message>
        <source>Turn it far to the right, then let it run.</source>
        <translation>Drehen Sie es weit nach rechts, und lassen Sie es dann laufen.</translation>
    </message>
    <message>
        <source>Turn γ</source>
        <translation>An γ drehen</translation>
    </message>
    <message>
        <source>Twenty different simulations</source>
        <translation>Zwanzig verschiedene Simulationen</translation>
    </message>
    <message>
        <source>Two Q-functions, one for gains and one for losses (Sarsa_2Q).</source>
        <translation>Zwei Q-Funktionen, eine für Gewinne und eine für Verluste (Sarsa_2Q).</translation>
    </message>
    <message>
        <source>Two Q-functions: **Q⁺** expects gains (200 at the goal), **Q⁻** losses (−400 a fall). The robot acts on the sum. Both cut the states into **tiles**; what is learned in a tile holds for all of it. After 20 episodes from nothing and {falls} falls it is held at 34°, falling. It expects {q(&quot;0&quot;)}.</source>
        <translation>Zwei Q-Funktionen: **Q⁺** erwartet Gewinne (200 am Ziel), **Q⁻** Verluste (−400 je Sturz). Der Roboter handelt nach der Summe. Beide teilen die Zustände in **Kacheln**; was in einer gelernt ist, gilt für die ganze. Nach 20 Episoden von null an und {falls} Stürzen wird er bei 34° festgehalten, im Fallen. Er erwartet {q(&quot;0&quot;)}.</translation>
    </message>
    <message>
        <source>Two ends of the line</source>
        <translation>Zwei Enden der Linie</translation>
    </message>
    <message>
        <source>Two hours, and something to read</source>
        <translation>Zwei Stunden, und etwas zu lesen</translation>
    </message>
    <message>
        <source>Two minutes later on</source>
        <translation>Zwei Minuten, später</translation>
    </message>
    <message>
        <source>Two robots cross the same field, along a cliff. One learns from what it does, the other from what it could do best. Which way will each of them take, and what does it cost?</source>
        <translation>Zwei Roboter überqueren dasselbe Feld, an einer Klippe entlang. Einer lernt aus dem, was er tut, der andere aus dem, was er bestenfalls tun könnte. Welchen Weg nimmt jeder, und was kostet das?</translation>
    </message>
    <message>
        <source>Two robots differ by 0.1 falls in 200 episodes, and the interval leaves out 0. Does it matter?</source>
        <translation>Zwei Roboter unterscheiden sich um 0,1 Stürze in 200 Episoden, und das Intervall schließt die 0 aus. Spielt das eine Rolle?</translation>
    </message>
    <message>
        <source>Two robots, A and B, five lives each of 200 episodes. A dot is one life; a bar is the 95 % interval of the mean. Say what you think. Then the program judges by the interval of the **difference**: if it holds 0, one cannot tell.</source>
        <translation>Zwei Roboter, A und B, je fünf Leben von 200 Episoden. Ein Punkt ist ein Leben; ein Balken ist das 95-%-Intervall des Mittels. Sagen Sie, was Sie denken. Dann urteilt das Programm nach dem Intervall des **Unterschieds**: Enthält es die 0, lässt es sich nicht sagen.</translation>
    </message>
    <message>
        <source>Two rules and one edge: the short way or the safe way.</source>
        <translation>Zwei Regeln und ein Rand: der kurze Weg oder der sichere.</translation>
    </message>
    <message>
        <source>Two simulated hours are over: **{observed(3)} falls**, {observed(2)} of them in the first ten minutes. Now the next ten minutes, still with ε = 0.05, on the same robot.</source>
        <translation>Zwei simulierte Stunden sind vorbei: **{observed(3)} Stürze**, davon {observed(2)} in den ersten zehn Minuten. Jetzt die nächsten zehn Minuten, weiter mit ε = 0,05, auf demselben Roboter.</translation>
    </message>
    <message>
        <source>Two ways</source>
        <translation>Zwei Wege</translation>
    </message>
    <message>
        <source>Until it has its first successes, a fall teaches it nothing.</source>
        <translation>Bis zu seinen ersten Erfolgen lehrt ihn ein Sturz nichts.</translation>
    </message>
    <message>
        <source>Very high ones.</source>
        <translation>Sehr hohen.</translation>
    </message>
    <message>
        <source>Very low and very high ones.</source>
        <translation>Sehr niedrigen und sehr hohen.</translation>
    </message>
    <message>
        <source>Very low ones.</source>
        <translation>Sehr niedrigen.</translation>
    </message>
    <message>
        <source>Very narrow tiles</source>
        <translation>Sehr schmale Kacheln</translation>
    </message>
    <message>
        <source>Very wide tiles</source>
        <translation>Sehr breite Kacheln</translation>
    </message>
    <message>
        <source>Was that fair?</source>
        <translation>War das fair?</translation>
    </message>
    <message>
        <source>Watch a beginner</source>
        <translation>Einem Anfänger zusehen</translation>
    </message>
    <message>
        <source>Watch it with ε = 0.05</source>
        <translation>Zusehen bei ε = 0,05</translation>
    </message>
    <message>
        <source>Watch it, push it, play a fall back. No formula yet.</source>
        <translation>Zusehen, anstoßen, einen Sturz abspielen. Noch keine Formel.</translation>
    </message>
    <message>
        <source>Weak motors are more exact.</source>
        <translation>Schwache Motoren sind genauer.</translation>
    </message>
    <message>
        <source>What a robot learns</source>
        <translation>Was ein Roboter lernt</translation>
    </message>
    <message>
        <source>What can a robot learn from that has not balanced the pole yet?</source>
        <translation>Woraus kann ein Roboter lernen, der den Stab noch nie balanciert hat?</translation>
    </message>
    <message>
        <source>What do wide tiles do well, what do narrow ones, and why 16 grids?</source>
        <translation>Was machen breite Kacheln gut, was schmale, und warum 16 Gitter?</translation>
    </message>
    <message>
        <source>What do you ask for first?</source>
        <translation>Worum bitten Sie zuerst?</translation>
    </message>
    <message>
        <source>What does a fall cost?</source>
        <translation>Was kostet ein Sturz?</translation>
    </message>
    <message>
        <source>What does a mark know about a step: where it led, or how long ago it was?</source>
        <translation>Was weiß eine Marke über einen Schritt: wohin er führte oder wie lange er her ist?</translation>
    </message>
    <message>
        <source>What does a seed decide? What is left of that in a greedy life?</source>
        <translation>Was bestimmt ein Seed? Was bleibt davon in einem Greedy-Leben übrig?</translation>
    </message>
    <message>
        <source>What does a threshold of 50 mean if all rewards are doubled?</source>
        <translation>Was bedeutet eine Schwelle von 50, wenn alle Belohnungen verdoppelt werden?</translation>
    </message>
    <message>
        <source>What does each of the two count as the next step, after a step along the edge?</source>
        <translation>Was zählt für jedes der beiden als nächster Schritt, nach einem Schritt am Rand?</translation>
    </message>
    <message>
        <source>What does the map say about states 3 to 8?</source>
        <translation>Was sagt die Karte über die Zustände 3 bis 8?</translation>
    </message>
    <message>
        <source>What does the rule of thumb assume about the rewards? Where would it not hold?</source>
        <translation>Was setzt die Faustregel über die Belohnungen voraus? Wo gälte sie nicht?</translation>
    </message>
    <message>
        <source>What does γ decide, and which γ would you give this robot?</source>
        <translation>Was bestimmt γ, und welches γ würden Sie diesem Roboter geben?</translation>
    </message>
    <message>
        <source>What does λ = 1 do, and would you want it?</source>
        <translation>Was bewirkt λ = 1, und würden Sie es wollen?</translation>
    </message>
    <message>
        <source>What does λ do, and what is the price of a large one?</source>
        <translation>Was bewirkt λ, und was ist der Preis eines großen?</translation>
    </message>
    <message>
        <source>What else can it bring along?</source>
        <translation>Was kann er noch mitbringen?</translation>
    </message>
    <message>
        <source>What else of a simulation can be wrong to the safe side: friction, weight, delay?</source>
        <translation>Was kann an einer Simulation noch zur sicheren Seite falsch sein: Reibung, Gewicht, Verzögerung?</translation>
    </message>
    <message>
        <source>What happens to Sarsa&apos;s way if ε shrinks slowly while it learns?</source>
        <translation>Was wird aus Sarsas Weg, wenn ε beim Lernen langsam kleiner wird?</translation>
    </message>
    <message>
        <source>What have the two groups in common, and in what do they differ?</source>
        <translation>Was haben die beiden Gruppen gemeinsam, und worin unterscheiden sie sich?</translation>
    </message>
    <message>
        <source>What is Q(8, right) afterwards?</source>
        <translation>Wie groß ist Q(8, rechts) danach?</translation>
    </message>
    <message>
        <source>What is Q(9, right) afterwards?</source>
        <translation>Wie groß ist Q(9, rechts) danach?</translation>
    </message>
    <message>
        <source>What is a state worth?</source>
        <translation>Was ist ein Zustand wert?</translation>
    </message>
    <message>
        <source>What is a way worth?</source>
        <translation>Was ist ein Weg wert?</translation>
    </message>
    <message>
        <source>What is different between the two, and what is the same?</source>
        <translation>Was ist bei den beiden verschieden, und was ist gleich?</translation>
    </message>
    <message>
        <source>What is exploring for, if less of it always falls less?</source>
        <translation>Wozu ist Explorieren da, wenn weniger davon immer weniger Stürze bringt?</translation>
    </message>
    <message>
        <source>What is good about a large α, and what about a small one?</source>
        <translation>Was ist gut an einem großen α, und was an einem kleinen?</translation>
    </message>
    <message>
        <source>What is state 6 worth?</source>
        <translation>Was ist Zustand 6 wert?</translation>
    </message>
    <message>
        <source>What is worth 5τ less is taken about 150 times less often than the best; ε-greedy draws it as often as any.</source>
        <translation>Was 5τ weniger wert ist, wird etwa 150-mal so selten gewählt wie die beste; ε-greedy lost es so oft wie jede andere.</translation>
    </message>
    <message>
        <source>What it does with γ = 0</source>
        <translation>Was er mit γ = 0 tut</translation>
    </message>
    <message>
        <source>What it tries instead is worth nearly as much.</source>
        <translation>Was es stattdessen probiert, ist fast gleich viel wert.</translation>
    </message>
    <message>
        <source>What must be true of a simulation for its risk to hold in reality?</source>
        <translation>Was muss für eine Simulation gelten, damit ihr Risiko in der Wirklichkeit stimmt?</translation>
    </message>
    <message>
        <source>What the first robot expects</source>
        <translation>Was der erste Roboter erwartet</translation>
    </message>
    <message>
        <source>What the second robot expects</source>
        <translation>Was der zweite Roboter erwartet</translation>
    </message>
    <message>
        <source>What the step changed</source>
        <translation>Was der Schritt verändert hat</translation>
    </message>
    <message>
        <source>What threshold does the rule give if a successful episode takes n* = 70 steps?</source>
        <translation>Welche Schwelle ergibt die Regel, wenn eine erfolgreiche Episode n* = 70 Schritte dauert?</translation>
    </message>
    <message>
        <source>What will it have learned that is still true in reality?</source>
        <translation>Was wird er gelernt haben, das in der Wirklichkeit noch stimmt?</translation>
    </message>
    <message>
        <source>What will state 2 be worth? And what will a step to the left be worth?</source>
        <translation>Was wird Zustand 2 wert sein? Und was ein Schritt nach links?</translation>
    </message>
    <message>
        <source>What will the robot from the weak simulation expect in this state?</source>
        <translation>Was wird der Roboter aus der schwachen Simulation in diesem Zustand erwarten?</translation>
    </message>
    <message>
        <source>What would have to be true of a task so that Softmax explores where it is dangerous?</source>
        <translation>Was müsste für eine Aufgabe gelten, damit Softmax dort exploriert, wo es gefährlich ist?</translation>
    </message>
    <message>
        <source>What would you measure before you put what it has learned on a real robot?</source>
        <translation>Was würden Sie messen, bevor Sie das Gelernte auf einen echten Roboter übertragen?</translation>
    </message>
    <message>
        <source>What would you take for γ if the robot is paid once at the end of a chess game?</source>
        <translation>Was würden Sie für γ nehmen, wenn der Roboter am Ende einer Schachpartie einmal belohnt wird?</translation>
    </message>
    <message>
        <source>What ε does to falls, and what the reward of a fall does.</source>
        <translation>Was ε mit Stürzen macht, und was die Belohnung eines Sturzes bewirkt.</translation>
    </message>
    <message>
        <source>When a pole falls: which steps were to blame, the last ten or those before?</source>
        <translation>Wenn ein Stab fällt: Welche Schritte waren schuld, die letzten zehn oder die davor?</translation>
    </message>
    <message>
        <source>When both take an action other than the best equally often, ε-greedy falls {mean(&quot;ε 0.1&quot;)} times, Softmax {mean(&quot;τ 1.5&quot;)} times on average. Greedy, which always takes the best, falls {mean(&quot;greedy&quot;)} times.</source>
        <translation>Wenn beide gleich oft eine andere Aktion als die beste nehmen, stürzt ε-greedy im Mittel {mean(&quot;ε 0.1&quot;)}-mal, Softmax {mean(&quot;τ 1.5&quot;)}-mal. Greedy, das immer die beste nimmt, stürzt {mean(&quot;greedy&quot;)}-mal.</translation>
    </message>
    <message>
        <source>When is a line worth its trouble?</source>
        <translation>Wann lohnt sich eine Linie?</translation>
    </message>
    <message>
        <source>When is exploring cheap, and what should Softmax be compared with?</source>
        <translation>Wann ist Explorieren billig, und womit sollte man Softmax vergleichen?</translation>
    </message>
    <message>
        <source>When it first reaches the goal, which of the steps on its way have a mark?</source>
        <translation>Wenn er das Ziel zum ersten Mal erreicht: Welche Schritte auf seinem Weg haben eine Marke?</translation>
    </message>
    <message>
        <source>When would a simulation be too pessimistic to be of use?</source>
        <translation>Wann wäre eine Simulation zu pessimistisch, um nützlich zu sein?</translation>
    </message>
    <message>
        <source>When would a surprise be negative? Find one on the chain.</source>
        <translation>Wann wäre eine Überraschung negativ? Finden Sie eine auf der Kette.</translation>
    </message>
    <message>
        <source>When would you use TRL, and when a smaller ε?</source>
        <translation>Wann würden Sie TRL verwenden, und wann ein kleineres ε?</translation>
    </message>
    <message>
        <source>Where all values lie below the line, TRL is ε-greedy; that is where the pole leans far.</source>
        <translation>Wo alle Werte unter der Linie liegen, ist TRL gleich ε-greedy; das ist dort, wo der Stab stark geneigt ist.</translation>
    </message>
    <message>
        <source>Where does it end?</source>
        <translation>Wo hört es auf?</translation>
    </message>
    <message>
        <source>Where good and bad states lie in the tile of a fall, Q⁻ says the same of all of them.</source>
        <translation>Wo gute und schlechte Zustände in der Kachel eines Sturzes liegen, sagt Q⁻ von allen dasselbe.</translation>
    </message>
    <message>
        <source>Where must falls not happen, so that this way of learning is ruled out?</source>
        <translation>Wo darf es keine Stürze geben, sodass man auf diese Weise nicht lernen kann?</translation>
    </message>
    <message>
        <source>Where the pole leans far, no action is worth 100, and it draws among all.</source>
        <translation>Wo der Stab stark geneigt ist, ist keine Aktion 100 wert, und es lost unter allen.</translation>
    </message>
    <message>
        <source>Where to put the line before one has tried? A **rule of thumb**: take the worth of a state from which the goal is n* steps away, the length of a successful episode: R times γ to the power of n*. The panel takes the n* of this life. R is 200, γ is 0.98.</source>
        <translation>Wohin mit der Linie, bevor man probiert hat? Eine **Faustregel**: Nehmen Sie den Wert eines Zustands, von dem aus das Ziel n* Schritte entfernt ist, die Länge einer erfolgreichen Episode: R mal γ hoch n*. Das Panel nimmt das n* dieses Lebens. R ist 200, γ ist 0,98.</translation>
    </message>
    <message>
        <source>Which needs fewer steps, or can one not tell?</source>
        <translation>Welches braucht weniger Schritte, oder lässt es sich nicht sagen?</translation>
    </message>
    <message>
        <source>Which of the two falls less in reality?</source>
        <translation>Welcher der beiden stürzt in der Wirklichkeit seltener?</translation>
    </message>
    <message>
        <source>Which of the two falls less?</source>
        <translation>Welches der beiden stürzt seltener?</translation>
    </message>
    <message>
        <source>Which of the two will avoid leaning that far?</source>
        <translation>Welcher der beiden wird vermeiden, sich so weit zu neigen?</translation>
    </message>
    <message>
        <source>Which of them falls least in reality?</source>
        <translation>Wer stürzt in der Wirklichkeit am seltensten?</translation>
    </message>
    <message>
        <source>Which of them falls less?</source>
        <translation>Welcher von beiden stürzt seltener?</translation>
    </message>
    <message>
        <source>Which of your own comparisons, in lessons 5 to 11, were fair?</source>
        <translation>Welche Ihrer eigenen Vergleiche, in den Lektionen 5 bis 11, waren fair?</translation>
    </message>
    <message>
        <source>Which rewards belong in Q⁻ if every step costs a little energy?</source>
        <translation>Welche Belohnungen gehören in Q⁻, wenn jeder Schritt etwas Energie kostet?</translation>
    </message>
    <message>
        <source>Which rule would you give a robot near an edge, and when the other one?</source>
        <translation>Welche Regel würden Sie einem Roboter an einem Rand geben, und wann die andere?</translation>
    </message>
    <message>
        <source>Which two or three numbers does the robot have to know about the pole, to choose a torque?</source>
        <translation>Welche zwei oder drei Zahlen muss der Roboter über den Stab kennen, um ein Drehmoment zu wählen?</translation>
    </message>
    <message>
        <source>Which value does Q(9, right) approach?</source>
        <translation>Welchem Wert nähert sich Q(9, rechts)?</translation>
    </message>
    <message>
        <source>Which way will Sarsa take?</source>
        <translation>Welchen Weg nimmt Sarsa?</translation>
    </message>
    <message>
        <source>While it expects nothing, a fall with reward 0 is no surprise. With −1600 each fall warns of what led to it.</source>
        <translation>Solange er nichts erwartet, ist ein Sturz mit Belohnung 0 keine Überraschung. Mit −1600 warnt jeder Sturz vor dem, was zu ihm führte.</translation>
    </message>
    <message>
        <source>Who should be allowed to explore: the simulation, the robot, or both?</source>
        <translation>Wer soll explorieren dürfen: die Simulation, der Roboter oder beide?</translation>
    </message>
    <message>
        <source>Who should set the weight: who builds the robot, or who pays for it?</source>
        <translation>Wer soll das Gewicht einstellen: wer den Roboter baut oder wer ihn bezahlt?</translation>
    </message>
    <message>
        <source>Whom to blame</source>
        <translation>Wer ist schuld?</translation>
    </message>
    <message>
        <source>Whose value stands in the formula as Q(S′, A′) when the robot steps right from state 7?</source>
        <translation>Wessen Wert steht in der Formel als Q(S′, A′), wenn der Roboter von Zustand 7 nach rechts geht?</translation>
    </message>
    <message>
        <source>Why are the greedy lives all alike?</source>
        <translation>Warum sind die Greedy-Leben alle gleich?</translation>
    </message>
    <message>
        <source>Why did it fall so often?</source>
        <translation>Warum ist er so oft gestürzt?</translation>
    </message>
    <message>
        <source>Why did the beginner fall so often?</source>
        <translation>Warum ist der Anfänger so oft gestürzt?</translation>
    </message>
    <message>
        <source>Why do the 20 values lie closer together with α = 0.02?</source>
        <translation>Warum liegen die 20 Werte mit α = 0,02 enger beisammen?</translation>
    </message>
    <message>
        <source>Why does a fall that costs nothing not make the robot careless for ever?</source>
        <translation>Warum macht ein Sturz, der nichts kostet, den Roboter nicht für immer leichtsinnig?</translation>
    </message>
    <message>
        <source>Why does a line at 100 help less than one at 50?</source>
        <translation>Warum hilft eine Linie bei 100 weniger als eine bei 50?</translation>
    </message>
    <message>
        <source>Why does a value never reach state 5 when γ = 0, however long the robot lives?</source>
        <translation>Warum erreicht ein Wert mit γ = 0 nie den Zustand 5, wie lange der Roboter auch lebt?</translation>
    </message>
    <message>
        <source>Why does it fall more at first with resolution 4 or 8 than with 1?</source>
        <translation>Warum stürzt er anfangs mit Auflösung 4 oder 8 öfter als mit 1?</translation>
    </message>
    <message>
        <source>Why does it fall most if a fall costs nothing?</source>
        <translation>Warum stürzt er am häufigsten, wenn ein Sturz nichts kostet?</translation>
    </message>
    <message>
        <source>Why does it fall so much more with 0.1?</source>
        <translation>Warum stürzt er mit 0,1 so viel öfter?</translation>
    </message>
    <message>
        <source>Why does it fall?</source>
        <translation>Warum stürzt er?</translation>
    </message>
    <message>
        <source>Why does it matter that actions are chosen on the sum of both?</source>
        <translation>Warum ist es wichtig, dass Aktionen nach der Summe beider gewählt werden?</translation>
    </message>
    <message>
        <source>Why does it not hurry with γ = 1?</source>
        <translation>Warum beeilt er sich mit γ = 1 nicht?</translation>
    </message>
    <message>
        <source>Why does it wander on states 3 to 8?</source>
        <translation>Warum irrt er auf den Zuständen 3 bis 8 umher?</translation>
    </message>
    <message>
        <source>Why does learning with weak motors help more?</source>
        <translation>Warum hilft Lernen mit schwachen Motoren mehr?</translation>
    </message>
    <message>
        <source>Why does the widest still fall nearly as often as at first?</source>
        <translation>Warum stürzt er mit den breitesten noch fast so oft wie anfangs?</translation>
    </message>
    <message>
        <source>Why is it better not to obey the risk while it learns in the simulation?</source>
        <translation>Warum ist es besser, sich beim Lernen in der Simulation nicht an das Risiko zu halten?</translation>
    </message>
    <message>
        <source>Why is the longer way worth more to Sarsa?</source>
        <translation>Warum ist der längere Weg für Sarsa mehr wert?</translation>
    </message>
    <message>
        <source>Why is “right” from state 2 blamed?</source>
        <translation>Warum wird „rechts“ von Zustand 2 beschuldigt?</translation>
    </message>
    <message>
        <source>Why may losses be coarser than gains?</source>
        <translation>Warum dürfen Verluste gröber sein als Gewinne?</translation>
    </message>
    <message>
        <source>Why not always?</source>
        <translation>Warum nicht immer?</translation>
    </message>
    <message>
        <source>Wide tiles spread what is learned to many states, so it is learned soon, but they cannot tell apart what needs different actions. Narrow ones can, but they need more falls first. Displaced wide grids do both: they spread, and together they tell apart.</source>
        <translation>Breite Kacheln verbreiten das Gelernte auf viele Zustände, sodass es schnell gelernt ist; sie unterscheiden aber nicht, was verschiedene Aktionen braucht. Schmale können das, brauchen aber erst mehr Stürze. Versetzte breite Gitter tun beides: Sie verbreiten, und gemeinsam unterscheiden sie.</translation>
    </message>
    <message>
        <source>Wider tiles for the losses</source>
        <translation>Breitere Kacheln für die Verluste</translation>
    </message>
    <message>
        <source>Will it find its real motors too strong or too weak?</source>
        <translation>Wird er seine wirklichen Motoren zu stark oder zu schwach finden?</translation>
    </message>
    <message>
        <source>With 0.3 times the torque, can it learn to balance in the simulation at all?</source>
        <translation>Kann er mit dem 0,3-fachen Drehmoment in der Simulation überhaupt balancieren lernen?</translation>
    </message>
    <message>
        <source>With a fine Q⁻ it fell **{observed(3)} times** while it learned. Now the resolution of Q⁻ is **0.4**: the same seed, the same six minutes.</source>
        <translation>Mit feinem Q⁻ stürzte er beim Lernen **{observed(3)}-mal**. Jetzt ist die Auflösung von Q⁻ **0,4**: derselbe Seed, dieselben sechs Minuten.</translation>
    </message>
    <message>
        <source>With a large α the value is right after few steps, if each step tells the same. Where chance plays a part, a small α averages over many steps and is not led astray by a single one, but learns more slowly.</source>
        <translation>Mit großem α stimmt der Wert nach wenigen Schritten, wenn jeder Schritt dasselbe sagt. Wo der Zufall mitspielt, mittelt ein kleines α über viele Schritte und lässt sich von einem einzelnen nicht in die Irre führen, lernt aber langsamer.</translation>
    </message>
    <message>
        <source>With the line at 80 two actions lie above it. In how many of 100 steps does it take the worse of these two?</source>
        <translation>Mit der Linie bei 80 liegen zwei Aktionen darüber. In wie vielen von 100 Schritten nimmt es die schlechtere der beiden?</translation>
    </message>
    <message>
        <source>With which thresholds is TRL nothing but ε-greedy?</source>
        <translation>Mit welchen Schwellen ist TRL nichts anderes als ε-greedy?</translation>
    </message>
    <message>
        <source>With which τ does Softmax take an action other than the best in about 8 of 100 steps?</source>
        <translation>Mit welchem τ nimmt Softmax in etwa 8 von 100 Schritten eine andere Aktion als die beste?</translation>
    </message>
    <message>
        <source>With α = 0.02 fewer steps are taken at random.</source>
        <translation>Mit α = 0,02 sind weniger Schritte zufällig.</translation>
    </message>
    <message>
        <source>With α = 0.02 one step counts little, and chance evens out over many.</source>
        <translation>Mit α = 0,02 zählt ein Schritt wenig, und über viele mittelt sich der Zufall heraus.</translation>
    </message>
    <message>
        <source>With α = 0.02 the values stay near 0.</source>
        <translation>Mit α = 0,02 bleiben die Werte nahe 0.</translation>
    </message>
    <message>
        <source>With γ = 0 the goal reached one state. With γ = 1 it reached all of them equally, and nothing said which way is shorter. With γ = 0.9 each step towards the goal is worth more than the one before.</source>
        <translation>Mit γ = 0 erreichte das Ziel einen Zustand. Mit γ = 1 erreichte es alle gleich stark, und nichts sagte, welcher Weg kürzer ist. Mit γ = 0,9 ist jeder Schritt zum Ziel mehr wert als der vorige.</translation>
    </message>
    <message>
        <source>With γ = 0.9 the robot took {observed(4)} steps per episode. With γ = 0 it takes {steps / episodes}. Let it run. Once it is on state 9 it knows what to do. Before that it wanders.</source>
        <translation>Mit γ = 0,9 brauchte der Roboter {observed(4)} Schritte je Episode. Mit γ = 0 braucht er {steps / episodes}. Lassen Sie ihn laufen. Steht er einmal auf Zustand 9, weiß er, was zu tun ist. Vorher irrt er umher.</translation>
    </message>
    <message>
        <source>With ε = 0.05 it fell **{observed(1)} times** in 200 episodes. Now it will take one action in four at random, **ε = 0.25**. The same robot, the same beginning, and the same **seed**: the number that all chance comes from.</source>
        <translation>Mit ε = 0,05 stürzte er in 200 Episoden **{observed(1)}-mal**. Jetzt wählt er eine von vier Aktionen zufällig, **ε = 0,25**. Derselbe Roboter, derselbe Anfang und derselbe **Seed**: die Zahl, aus der aller Zufall kommt.</translation>
    </message>
    <message>
        <source>With ε = 0.05 it fell {observed(1)} times in 200 episodes. Now the knob is yours. Choose an ε, start again with the same seed, and let it live 200 episodes. Can you do it with ε at 0.01 or more, so that it still explores?</source>
        <translation>Mit ε = 0,05 stürzte er in 200 Episoden {observed(1)}-mal. Jetzt gehört der Regler Ihnen. Wählen Sie ein ε, starten Sie mit demselben Seed neu, und lassen Sie ihn 200 Episoden leben. Gelingt es mit einem ε von mindestens 0,01, sodass er noch exploriert?</translation>
    </message>
    <message>
        <source>With ε = 0.1 the robot fell **{observed(3)} times** in 200 episodes. Now Softmax, with **τ = 1.5**: it leaves the best action about as often. The same robot, the same beginning.</source>
        <translation>Mit ε = 0,1 stürzte der Roboter in 200 Episoden **{observed(3)}-mal**. Jetzt Softmax mit **τ = 1,5**: Es weicht etwa gleich oft von der besten Aktion ab. Derselbe Roboter, derselbe Anfang.</translation>
    </message>
    <message>
        <source>With ε = 0.25 it has learned for 200 episodes. Why does it still fall?</source>
        <translation>Mit ε = 0,25 hat er 200 Episoden gelernt. Warum stürzt er immer noch?</translation>
    </message>
    <message>
        <source>With λ = 0 a value learns from the next value only.</source>
        <translation>Mit λ = 0 lernt ein Wert nur vom nächsten Wert.</translation>
    </message>
    <message>
        <source>With λ = 0 it had to reach the goal **{observed(5)} times** before state 5 knew of it: the news moves back one state at a time. Now **λ = 0.9**, the same seed, from the beginning, until the same two things hold.</source>
        <translation>Mit λ = 0 musste er das Ziel **{observed(5)}-mal** erreichen, bis Zustand 5 davon wusste: Die Nachricht rückt Zustand für Zustand zurück. Jetzt **λ = 0,9**, derselbe Seed, von Anfang an, bis dieselben zwei Dinge gelten.</translation>
    </message>
    <message>
        <source>With λ = 0.9 state 5 knew after {observed(6)} goals, with λ = 0 after {observed(5)}. But that was one life. Here are ten of each, of the same seeds: the steps of ten episodes. A line joins the lives of one seed. The bar is the 95 % interval of a mean: there the true mean probably lies.</source>
        <translation>Mit λ = 0,9 wusste es Zustand 5 nach {observed(6)} Zielen, mit λ = 0 nach {observed(5)}. Das war aber ein Leben. Hier sind je zehn, mit denselben Seeds: die Schritte von zehn Episoden. Eine Linie verbindet die Leben eines Seeds. Der Balken ist das 95-%-Intervall eines Mittels: Dort liegt wahrscheinlich das wahre Mittel.</translation>
    </message>
    <message>
        <source>With τ = 1000, about how likely is each of the five actions?</source>
        <translation>Wie wahrscheinlich ist mit τ = 1000 ungefähr jede der fünf Aktionen?</translation>
    </message>
    <message>
        <source>Within a pair, which ε falls less, and in how many of the ten?</source>
        <translation>Welches ε stürzt in einem Paar seltener, und in wie vielen der zehn?</translation>
    </message>
    <message>
        <source>Without a punishment it explores more.</source>
        <translation>Ohne Strafe exploriert er mehr.</translation>
    </message>
    <message>
        <source>Without exploring</source>
        <translation>Ohne zu explorieren</translation>
    </message>
    <message>
        <source>Work out a worth</source>
        <translation>Einen Wert ausrechnen</translation>
    </message>
    <message>
        <source>Work out the new value before the robot does.</source>
        <translation>Den neuen Wert ausrechnen, bevor der Roboter es tut.</translation>
    </message>
    <message>
        <source>Would you let ε shrink while it learns? By what rule?</source>
        <translation>Würden Sie ε beim Lernen kleiner werden lassen? Nach welcher Regel?</translation>
    </message>
    <message>
        <source>Would you rather learn in many simulations, each wrong in another way?</source>
        <translation>Würden Sie lieber in vielen Simulationen lernen, jede auf andere Art falsch?</translation>
    </message>
    <message>
        <source>Would you rather start with wide tiles and cut them later? What would that need?</source>
        <translation>Würden Sie lieber mit breiten Kacheln beginnen und sie später teilen? Was bräuchte man dafür?</translation>
    </message>
    <message>
        <source>You are the referee</source>
        <translation>Sie sind der Gutachter</translation>
    </message>
    <message>
        <source>You build a simulation and do not know the torque exactly. What do you choose, and why?</source>
        <translation>Sie bauen eine Simulation und kennen das Drehmoment nicht genau. Was wählen Sie, und warum?</translation>
    </message>
    <message>
        <source>You do not always choose how a simulation is wrong. After the **strong** motors, × 2.5, a robot can bring along more than its values: how likely each action ended in a fall there. Ten lives that obey this risk in reality, and ten that do not. (The next lesson is about this.)</source>
        <translation>Nicht immer wählt man, wie eine Simulation falsch ist. Nach den **starken** Motoren, × 2,5, kann ein Roboter mehr mitbringen als seine Werte: wie wahrscheinlich jede Aktion dort im Sturz endete. Zehn Leben, die in der Wirklichkeit diesem Risiko gehorchen, und zehn, die es nicht tun. (Davon handelt die nächste Lektion.)</translation>
    </message>
    <message>
        <source>You have done by hand what the robot does after every step, on the pendulum 200 times a second: see what came, compare it with what was expected, and move the value by a share of the difference.</source>
        <translation>Sie haben von Hand getan, was der Roboter nach jedem Schritt tut, beim Pendel 200-mal in der Sekunde: sehen, was kommt, es mit dem Erwarteten vergleichen und den Wert um einen Teil des Unterschieds verschieben.</translation>
    </message>
    <message>
        <source>You have met two settings. Because of ε the robot sometimes does what it does not think best, also when there is little left to learn. The reward of a fall changes how often it falls while it learns. In the next lesson, [The cliff](lesson:the-cliff), two robots treat their own ε differently.</source>
        <translation>Sie kennen nun zwei Einstellungen. Wegen ε tut der Roboter manchmal, was er nicht für das Beste hält, auch wenn es wenig zu lernen gibt. Die Belohnung eines Sturzes ändert, wie oft er beim Lernen stürzt. In der nächsten Lektion, [Die Klippe](lesson:the-cliff), gehen zwei Roboter verschieden mit ihrem eigenen ε um.</translation>
    </message>
    <message>
        <source>You have one robot that breaks easily. How do you let it learn?</source>
        <translation>Sie haben einen Roboter, der leicht kaputtgeht. Wie lassen Sie ihn lernen?</translation>
    </message>
    <message>
        <source>You have seen which direction helps. One life is a matter of chance: try a few values.</source>
        <translation>Sie haben gesehen, welche Richtung hilft. Ein Leben ist Zufall: Probieren Sie ein paar Werte.</translation>
    </message>
    <message>
        <source>You look for a γ with γ⁷ · 100 between 1 and 5. With γ = 0.7 it is about 8.</source>
        <translation>Gesucht ist ein γ, für das γ⁷ · 100 zwischen 1 und 5 liegt. Mit γ = 0,7 ist es etwa 8.</translation>
    </message>
    <message>
        <source>You try 40 settings that change nothing. About how many look better or worse all the same?</source>
        <translation>Sie probieren 40 Einstellungen, die nichts ändern. Wie viele sehen ungefähr trotzdem besser oder schlechter aus?</translation>
    </message>
    <message>
        <source>Your rule</source>
        <translation>Ihre Regel</translation>
    </message>
    <message>
        <source>Your rule for a robot near an edge</source>
        <translation>Ihre Regel für einen Roboter an einem Rand</translation>
    </message>
    <message>
        <source>Your rule for ε and for the reward of a fall, for a robot that can break:</source>
        <translation>Ihre Regel für ε und für die Belohnung eines Sturzes, für einen Roboter, der kaputtgehen kann:</translation>
    </message>
    <message>
        <source>actions</source>
        <translation>Aktionen</translation>
    </message>
    <message>
        <source>bold</source>
        <translation>kühn</translation>
    </message>
    <message>
        <source>both coarse</source>
        <translation>beide grob</translation>
    </message>
    <message>
        <source>careful</source>
        <translation>vorsichtig</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>goals, both coarse</source>
        <translation>Ziele, beide grob</translation>
    </message>
    <message>
        <source>goals, only Q⁻ coarse</source>
        <translation>Ziele, nur Q⁻ grob</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>greedy</translation>
    </message>
    <message>
        <source>greedy, five</source>
        <translation>greedy, fünf</translation>
    </message>
    <message>
        <source>how Softmax chooses, why it falls less than ε-greedy that explores as often, and what else to compare it with.</source>
        <translation>wie Softmax wählt, warum es weniger stürzt als ein gleich oft explorierendes ε-greedy, und womit man es noch vergleichen muss.</translation>
    </message>
    <message>
        <source>how a risk that is learned in simulation avoids falls in reality, and why a larger penalty does less.</source>
        <translation>wie ein in der Simulation gelerntes Risiko in der Wirklichkeit Stürze vermeidet, und warum eine höhere Strafe weniger leistet.</translation>
    </message>
    <message>
        <source>how a robot on two legs learns to walk, what that costs in falls, and which way it fell less on another robot.</source>
        <translation>wie ein Roboter auf zwei Beinen gehen lernt, was das an Stürzen kostet, und wie er auf einem anderen Roboter seltener stürzte.</translation>
    </message>
    <message>
        <source>how few lives deceive, what an interval promises, what pairs are good for, and whom a new method has to beat.</source>
        <translation>wie wenige Leben täuschen, was ein Intervall verspricht, wozu Paare gut sind, und wen eine neue Methode schlagen muss.</translation>
    </message>
    <message>
        <source>lives</source>
        <translation>Leben</translation>
    </message>
    <message>
        <source>no line</source>
        <translation>keine Linie</translation>
    </message>
    <message>
        <source>not obeyed</source>
        <translation>nicht befolgt</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>one grid of 2</source>
        <translation>ein Gitter von 2</translation>
    </message>
    <message>
        <source>only Q⁻ coarse</source>
        <translation>nur Q⁻ grob</translation>
    </message>
    <message>
        <source>punished</source>
        <translation>bestraft</translation>
    </message>
    <message>
        <source>resolution 0.25</source>
        <translation>Auflösung 0,25</translation>
    </message>
    <message>
        <source>resolution 0.25, later</source>
        <translation>Auflösung 0,25, später</translation>
    </message>
    <message>
        <source>resolution 1</source>
        <translation>Auflösung 1</translation>
    </message>
    <message>
        <source>resolution 1, later</source>
        <translation>Auflösung 1, später</translation>
    </message>
    <message>
        <source>resolution 4</source>
        <translation>Auflösung 4</translation>
    </message>
    <message>
        <source>resolution 4, later</source>
        <translation>Auflösung 4, später</translation>
    </message>
    <message>
        <source>resolution 8</source>
        <translation>Auflösung 8</translation>
    </message>
    <message>
        <source>resolution 8, later</source>
        <translation>Auflösung 8, später</translation>
    </message>
    <message>
        <source>reward 0</source>
        <translation>Belohnung 0</translation>
    </message>
    <message>
        <source>reward −100</source>
        <translation>Belohnung −100</translation>
    </message>
    <message>
        <source>reward −1600</source>
        <translation>Belohnung −1600</translation>
    </message>
    <message>
        <source>right, × 1</source>
        <translation>richtig, × 1</translation>
    </message>
    <message>
        <source>risk obeyed</source>
        <translation>Risiko befolgt</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>strong, × 2.5</source>
        <translation>stark, × 2,5</translation>
    </message>
    <message>
        <source>the same robot twice, the same seed; only the way to explore differs</source>
        <translation>zweimal derselbe Roboter, derselbe Seed; nur die Art zu explorieren ist verschieden</translation>
    </message>
    <message>
        <source>times</source>
        <translation>Mal</translation>
    </message>
    <message>
        <source>weak, × 0.5</source>
        <translation>schwach, × 0,5</translation>
    </message>
    <message>
        <source>what a threshold does to exploring, what makes it too low or too high, and what TRL has to be compared with.</source>
        <translation>was eine Schwelle mit dem Explorieren macht, wann sie zu niedrig oder zu hoch ist, und womit man TRL vergleichen muss.</translation>
    </message>
    <message>
        <source>what a trace does: how far back a fall or a goal is felt, and why that is quick but not always just.</source>
        <translation>was ein Trace bewirkt: wie weit zurück ein Sturz oder ein Ziel zu spüren ist, und warum das schnell geht, aber nicht immer gerecht ist.</translation>
    </message>
    <message>
        <source>what learning in a wrong simulation saves, and which error of its motors costs less in reality.</source>
        <translation>was Lernen in einer falschen Simulation spart, und welcher Fehler ihrer Motoren in der Wirklichkeit weniger kostet.</translation>
    </message>
    <message>
        <source>what the robot does with one step: how large its surprise δ is, and that the value moves by the share α of it.</source>
        <translation>was der Roboter mit einem Schritt macht: wie groß seine Überraschung δ ist, und dass der Wert um den Anteil α davon rückt.</translation>
    </message>
    <message>
        <source>what too wide and too narrow tiles do to learning, and why one lays several displaced grids over each other.</source>
        <translation>was zu breite und zu schmale Kacheln mit dem Lernen machen, und warum man mehrere versetzte Gitter übereinanderlegt.</translation>
    </message>
    <message>
        <source>what γ does: how far ahead a reward counts, and what goes wrong when it counts too little or too long.</source>
        <translation>was γ bewirkt: wie weit voraus eine Belohnung zählt, und was schiefgeht, wenn sie zu wenig oder zu lange zählt.</translation>
    </message>
    <message>
        <source>what ε does to falls, why they go on when the robot has learned, and what a harder punishment changes.</source>
        <translation>was ε mit Stürzen macht, warum sie weitergehen, wenn der Roboter gelernt hat, und was eine härtere Strafe ändert.</translation>
    </message>
    <message>
        <source>which of two rules counts its own mistakes, and which one to trust near an edge while it learns.</source>
        <translation>welche von zwei Regeln ihre eigenen Fehler mitzählt, und welcher man nahe an einem Rand traut, solange sie lernt.</translation>
    </message>
    <message>
        <source>why a coarse Q-function for the losses saves falls, why one that is too coarse costs them, and why the gains stay fine.</source>
        <translation>warum eine grobe Q-Funktion für die Verluste Stürze spart, warum eine zu grobe sie kostet, und warum die Gewinne fein bleiben.</translation>
    </message>
    <message>
        <source>why a robot that learns by itself falls often at first, and what it has to find out in order to fall less.</source>
        <translation>warum ein Roboter, der selbst lernt, anfangs oft stürzt, und was er herausfinden muss, um seltener zu stürzen.</translation>
    </message>
    <message>
        <source>{mean(&quot;A&quot;)} and {mean(&quot;B&quot;)} falls in five lives. But A and B are the **same robot**; only chance differed (we looked for such luck in 28 seeds). Thirty lives: {mean(&quot;A, thirty&quot;)} and {mean(&quot;B, thirty&quot;)}. With more lives the interval of the mean shrinks: four times the lives, about half as wide.</source>
        <translation>{mean(&quot;A&quot;)} und {mean(&quot;B&quot;)} Stürze in fünf Leben. Aber A und B sind **derselbe Roboter**; nur der Zufall war verschieden (wir suchten solches Glück in 28 Seeds). Dreißig Leben: {mean(&quot;A, thirty&quot;)} und {mean(&quot;B, thirty&quot;)}. Mit mehr Leben schrumpft das Intervall des Mittels: viermal so viele Leben, etwa halb so breit.</translation>
    </message>
    <message>
        <source>{observed(2)} falls in reality instead of {observed(1)}, and {before.falls} in the simulation. Now the simulation is wrong the other way: its motors have **half** the torque of the real ones. Again ten minutes there, then 200 real episodes.</source>
        <translation>{observed(2)} Stürze in der Wirklichkeit statt {observed(1)}, und {before.falls} in der Simulation. Jetzt ist die Simulation andersherum falsch: Ihre Motoren haben **halb** so viel Drehmoment wie die wirklichen. Wieder zehn Minuten dort, dann 200 wirkliche Episoden.</translation>
    </message>
    <message>
        <source>{observed(2)} falls instead of {observed(1)}. Ten lives with ε = 0.25 now go on for 100 more episodes: they fall {least(&quot;ε stays 0.25&quot;)} to {most(&quot;ε stays 0.25&quot;)} times. Ten others have learned the same, and then stop exploring: they fall {least(&quot;ε becomes 0&quot;)} to {most(&quot;ε becomes 0&quot;)} times.</source>
        <translation>{observed(2)} Stürze statt {observed(1)}. Zehn Leben mit ε = 0,25 gehen nun 100 Episoden weiter: Sie stürzen {least(&quot;ε stays 0.25&quot;)}- bis {most(&quot;ε stays 0.25&quot;)}-mal. Zehn andere haben dasselbe gelernt und hören dann auf zu explorieren: Sie stürzen {least(&quot;ε becomes 0&quot;)}- bis {most(&quot;ε becomes 0&quot;)}-mal.</translation>
    </message>
    <message>
        <source>{observed(2)} falls with the large penalty. Now something else: beside Q the robot learns **ρ**, how likely an action ends in a fall. It learned it in the simulation, and did not use it. The pole leans, and falls on: look at the column *Risk*.</source>
        <translation>{observed(2)} Stürze mit der hohen Strafe. Jetzt etwas anderes: Neben Q lernt der Roboter **ρ**, wie wahrscheinlich eine Aktion im Sturz endet. Er hat es in der Simulation gelernt und nicht benutzt. Der Stab ist geneigt und fällt weiter: Sehen Sie auf die Spalte *Risiko*.</translation>
    </message>
    <message>
        <source>{observed(3)} falls after the weak motors, {observed(2)} after the strong ones. Why? Here is the first robot again, straight from the **strong** simulation. The pole leans by 29°, at rest. The robot expects {max(q(&quot;1.5&quot;), q(&quot;0.75&quot;), q(&quot;0&quot;), q(&quot;-0.75&quot;), q(&quot;-1.5&quot;))} of its best action; a fall is −100.</source>
        <translation>{observed(3)} Stürze nach den schwachen Motoren, {observed(2)} nach den starken. Warum? Hier ist wieder der erste Roboter, direkt aus der **starken** Simulation. Der Stab ist um 29° geneigt und ruht. Der Roboter erwartet {max(q(&quot;1.5&quot;), q(&quot;0.75&quot;), q(&quot;0&quot;), q(&quot;-0.75&quot;), q(&quot;-1.5&quot;))} von seiner besten Aktion; ein Sturz ist −100.</translation>
    </message>
    <message>
        <source>{observed(4)} falls in ten minutes instead of {observed(2)}. Was that learned for this one robot only? What it knows goes to another one: motors of 9.5 Ω in place of 8.6, and a third more dry friction. It goes on learning, with ε = 0.05, for ten minutes.</source>
        <translation>{observed(4)} Stürze in zehn Minuten statt {observed(2)}. Wurde das nur für diesen einen Roboter gelernt? Was er weiß, kommt auf einen anderen: Motoren mit 9,5 Ω statt 8,6 und ein Drittel mehr trockene Reibung. Er lernt weiter, mit ε = 0,05, zehn Minuten lang.</translation>
    </message>
    <message>
        <source>{observed(4)} falls instead of {observed(3)}. Ten lives for each threshold, ε = 0.2, fall on average {mean(&quot;no line&quot;)} times with −1000, which forbids nothing, {mean(&quot;TRL 50&quot;)} with 50 and {mean(&quot;TRL 100&quot;)} with 100. The pole leans by 20° now, and the line lies at 100.</source>
        <translation>{observed(4)} Stürze statt {observed(3)}. Zehn Leben je Schwelle, ε = 0,2, stürzen im Mittel {mean(&quot;no line&quot;)}-mal mit −1000, die nichts verbietet, {mean(&quot;TRL 50&quot;)}-mal mit 50 und {mean(&quot;TRL 100&quot;)}-mal mit 100. Der Stab ist jetzt um 20° geneigt, und die Linie liegt bei 100.</translation>
    </message>
    <message>
        <source>{observed(4)} falls. One life proves little, and who hardly explores hardly falls. So here are ten lives of each: as bold as in the simulation, greedy, punished with −6400, and careful by the risk.</source>
        <translation>{observed(4)} Stürze. Ein Leben beweist wenig, und wer kaum exploriert, stürzt kaum. Darum je zehn Leben: so kühn wie in der Simulation, greedy, bestraft mit −6400, und vorsichtig durch das Risiko.</translation>
    </message>
    <message>
        <source>{observed(6)} falls instead of {observed(5)}. Three lives of each, three minutes long: ε-greedy falls {least(&quot;ε-greedy 0.05&quot;)} to {most(&quot;ε-greedy 0.05&quot;)} times. The three greedy lives, with three seeds, all fall {mean(&quot;greedy&quot;)} times.</source>
        <translation>{observed(6)} Stürze statt {observed(5)}. Je drei Leben von drei Minuten: ε-greedy stürzt {least(&quot;ε-greedy 0.05&quot;)}- bis {most(&quot;ε-greedy 0.05&quot;)}-mal. Die drei Greedy-Leben, mit drei Seeds, stürzen alle {mean(&quot;greedy&quot;)}-mal.</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>× 0.3</source>
        <translation>× 0,3</translation>
    </message>
    <message>
        <source>× 0.5</source>
        <translation>× 0,5</translation>
    </message>
    <message>
        <source>× 0.8</source>
        <translation>× 0,8</translation>
    </message>
    <message>
        <source>× 1.5</source>
        <translation>× 1,5</translation>
    </message>
    <message>
        <source>× 2</source>
        <translation>× 2</translation>
    </message>
    <message>
        <source>α 0.02</source>
        <translation>α 0,02</translation>
    </message>
    <message>
        <source>α 0.5</source>
        <translation>α 0,5</translation>
    </message>
    <message>
        <source>α = 1 made one step enough. What would α = 2 do?</source>
        <translation>Mit α = 1 genügte ein Schritt. Was würde α = 2 bewirken?</translation>
    </message>
    <message>
        <source>α is the share of the surprise that is added. Which share is needed to get from 0 to 100 at once?</source>
        <translation>α ist der Anteil der Überraschung, der hinzukommt. Welcher Anteil ist nötig, um auf einmal von 0 auf 100 zu kommen?</translation>
    </message>
    <message>
        <source>γ 0</source>
        <translation>γ 0</translation>
    </message>
    <message>
        <source>γ 0.9</source>
        <translation>γ 0,9</translation>
    </message>
    <message>
        <source>γ 1</source>
        <translation>γ 1</translation>
    </message>
    <message>
        <source>γ decides how much a reward counts that comes later. Too small, and states far from the goal hardly know of it. At 1 a late reward is worth as much as an early one, so nothing makes the robot hurry unless steps cost something. Here: something in between, such as 0.9.</source>
        <translation>γ bestimmt, wie viel eine Belohnung zählt, die später kommt. Ist es zu klein, wissen Zustände weit weg vom Ziel kaum davon. Bei 1 ist eine späte Belohnung so viel wert wie eine frühe; dann eilt der Roboter nicht, es sei denn, Schritte kosten etwas. Hier: etwas dazwischen, etwa 0,9.</translation>
    </message>
    <message>
        <source>γ is 0.9 again; the map shows it. Now imagine **γ = 0**: what comes after the next step counts nothing. Only the reward of the very next step counts.</source>
        <translation>γ ist wieder 0,9; die Karte zeigt es. Stellen Sie sich nun **γ = 0** vor: Was nach dem nächsten Schritt kommt, zählt nichts. Nur die Belohnung des allernächsten Schritts zählt.</translation>
    </message>
    <message>
        <source>δ = 0 + 0.8 · 75 − 0. Then take half of it.</source>
        <translation>δ = 0 + 0,8 · 75 − 0. Davon dann die Hälfte.</translation>
    </message>
    <message>
        <source>ε 0.05</source>
        <translation>ε 0,05</translation>
    </message>
    <message>
        <source>ε 0.05, in pairs</source>
        <translation>ε 0,05, in Paaren</translation>
    </message>
    <message>
        <source>ε 0.1</source>
        <translation>ε 0,1</translation>
    </message>
    <message>
        <source>ε 0.1, others</source>
        <translation>ε 0,1, andere</translation>
    </message>
    <message>
        <source>ε 0.1, the same</source>
        <translation>ε 0,1, dieselben</translation>
    </message>
    <message>
        <source>ε = 0.1</source>
        <translation>ε = 0,1</translation>
    </message>
    <message>
        <source>ε becomes 0</source>
        <translation>ε wird 0</translation>
    </message>
    <message>
        <source>ε is 0.05 for all.</source>
        <translation>ε ist für alle 0,05.</translation>
    </message>
    <message>
        <source>ε is 0.05 in all 30 lives.</source>
        <translation>ε ist in allen 30 Leben 0,05.</translation>
    </message>
    <message>
        <source>ε is 0.2 in all of them.</source>
        <translation>ε ist in allen 0,2.</translation>
    </message>
    <message>
        <source>ε stays 0.25</source>
        <translation>ε bleibt 0,25</translation>
    </message>
    <message>
        <source>ε-greedy 0.05</source>
        <translation>ε-greedy 0,05</translation>
    </message>
    <message>
        <source>ε-greedy also drew the worst of the five. When may TRL do so?</source>
        <translation>ε-greedy loste auch die schlechteste der fünf. Wann darf TRL das?</translation>
    </message>
    <message>
        <source>ε-greedy once more</source>
        <translation>Noch einmal ε-greedy</translation>
    </message>
    <message>
        <source>ε-greedy took an action other than the best in 8 of 100 steps. For a fair comparison Softmax must do so as often. The chart shows how often ε-greedy does so, and Softmax with four temperatures, ten lives each. The τ that you look for lies between two of them.</source>
        <translation>ε-greedy nahm in 8 von 100 Schritten eine andere Aktion als die beste. Für einen fairen Vergleich muss Softmax das ebenso oft tun. Das Diagramm zeigt, wie oft ε-greedy es tut und Softmax mit vier Temperaturen, je zehn Leben. Das gesuchte τ liegt zwischen zweien davon.</translation>
    </message>
    <message>
        <source>ε-greedy with ε = 0.2</source>
        <translation>ε-greedy mit ε = 0,2</translation>
    </message>
    <message>
        <source>ε-greedy, again thirty</source>
        <translation>ε-greedy, wieder dreißig</translation>
    </message>
    <message>
        <source>ε-greedy, ε 0.05</source>
        <translation>ε-greedy, ε 0,05</translation>
    </message>
    <message>
        <source>ε-greedy: one action in ten</source>
        <translation>ε-greedy: eine Aktion von zehn</translation>
    </message>
    <message>
        <source>λ 0</source>
        <translation>λ 0</translation>
    </message>
    <message>
        <source>λ 0.9</source>
        <translation>λ 0,9</translation>
    </message>
    <message>
        <source>λ decides how much of the blame goes on to the step before. With λ = 0.9 *left* from state 3 lost 40.5. Turn λ, start again with the same seed, and run until the first fall. Then pause, and click state 3 on the map.</source>
        <translation>λ bestimmt, wie viel der Schuld an den Schritt davor weitergeht. Mit λ = 0,9 verlor *links* von Zustand 3 40,5. Drehen Sie an λ, starten Sie mit demselben Seed neu, und lassen Sie bis zum ersten Sturz laufen. Halten Sie dann an und klicken Sie auf der Karte auf Zustand 3.</translation>
    </message>
    <message>
        <source>λ says how far back along the way a surprise is felt. With a large λ one fall or goal teaches many steps at once, so that news travels quickly; but steps are judged by when they were taken, and some are blamed or praised wrongly until later walks correct it.</source>
        <translation>λ sagt, wie weit zurück am Weg eine Überraschung zu spüren ist. Mit großem λ lehrt ein Sturz oder ein Ziel viele Schritte auf einmal, sodass sich Nachrichten schnell verbreiten; aber Schritte werden danach beurteilt, wann sie getan wurden, und manche werden zu Unrecht getadelt oder gelobt, bis spätere Wege das berichtigen.</translation>
    </message>
    <message>
        <source>ρ is 1 for an action that falls, and is passed on to the actions before it, as values are.</source>
        <translation>ρ ist 1 für eine Aktion, die stürzt, und wird an die Aktionen davor weitergegeben, wie Werte auch.</translation>
    </message>
    <message>
        <source>τ 1.5</source>
        <translation>τ 1,5</translation>
    </message>
    <message>
        <source>τ = 0.5</source>
        <translation>τ = 0,5</translation>
    </message>
    <message>
        <source>τ = 1</source>
        <translation>τ = 1</translation>
    </message>
    <message>
        <source>τ = 2</source>
        <translation>τ = 2</translation>
    </message>
    <message>
        <source>τ = 4</source>
        <translation>τ = 4</translation>
    </message>
    <message>
        <source>τ is measured in units of Q. What happens to Softmax if all rewards are multiplied by ten?</source>
        <translation>τ wird in Einheiten von Q gemessen. Was geschieht mit Softmax, wenn alle Belohnungen mit zehn multipliziert werden?</translation>
    </message>
    <message>
        <source>… it has to find out by trying which torque is good when, and at first most of its episodes go wrong. With practice it knows more and falls less.</source>
        <translation>… er durch Ausprobieren herausfinden muss, welches Drehmoment wann gut ist, und anfangs die meisten Episoden misslingen. Mit Übung weiß er mehr und stürzt seltener.</translation>
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
    <message>
        <source>world</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>phase portrait</source>
        <translation>Phasenporträt</translation>
    </message>
    <message>
        <source>strides</source>
        <translation>Doppelschritte</translation>
    </message>
    <message>
        <source>policy</source>
        <translation>Policy</translation>
    </message>
    <message>
        <source>scenario</source>
        <translation>Szenario</translation>
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
        <source>From the next start on. Most sentences about errors are English.</source>
        <translation>Ab dem nächsten Start. Die meisten Sätze über Fehler sind englisch.</translation>
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
