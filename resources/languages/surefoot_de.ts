<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>agrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undecided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing lived yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, followed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, saved after every life</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pre-learned on scenario %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, thesis %1</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>◇ the thesis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open bars: so far, lives are missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>highest at the end first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (95 %: %1 … %2)</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pushed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>placed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Episode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Policy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to see the last seconds of this fall again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risiko</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rewards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Representation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>best action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>greedy action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>greedy %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>risk of a fall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>visits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>eligibility</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 live %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fixed %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean over %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>least over %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>most over %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known here</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On and off</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>roll-out, greedy, seed %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for this; take fewer tiles or tilings.</source>
        <translation>Dafür reicht der Speicher nicht; nehmen Sie weniger Kacheln oder Kachelungen.</translation>
    </message>
    <message>
        <source>Remove earlier runs</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The handbook is not there.</source>
        <translation>Das Handbuch ist nicht da.</translation>
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
        <translation>Über die Arbeit hinaus</translation>
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
        <translation>Kacheln je %1 von „%2“: Wenige verallgemeinern weit, viele unterscheiden Zustände.</translation>
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
        <translation>Breite σ der Gaußfunktionen längs „%1“: Eine breite verallgemeinert weit.</translation>
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
        <translation>Arbeit</translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 % more damping, a little friction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2 Half damping, low friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3 Low damping, high friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4 More power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>5 Less power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>6 Power + friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A Softmax whose temperature 1/β fits each state: where actions differ much it is nearly greedy, where they hardly differ nearly even. One ω holds for all states.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A beam that a servo tilts; the ball rolls and must come to rest in the middle. Off the beam is a fall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A body on one leg with a spring in it; a servo holds the angle of the leg, a piston presses the spring.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A car that is too weak for the slope has to swing. It cannot fall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A certain fall costs an action so much of its value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A fall costs more and more while the robot falls more often than the budget allows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A floor that rises by 2 %: harder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A grid of 10 × 10 with a bad region in the middle, which is a fall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A grid of 10 × 10 with a bad region in the middle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A grid of 4 × 12 with a cliff along one side: Q-learning walks the edge, Sarsa the safe path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A hull on two legs of two links, after Gymnasium&apos;s BipedalWalker; four motors of three levels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A life is one learner with one seed; an episode goes from its start to its end, a step from action to action.</source>
        <translation>Ein Leben ist ein Lerner mit einem Seed; eine Episode reicht von ihrem Anfang bis zu ihrem Ende, ein Schritt von Aktion zu Aktion.</translation>
    </message>
    <message>
        <source>A pair visited again: its trace is set to 1, or 1 is added.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A pole on a cart with a driven wheel. The state is its angle α, its rate α̇ and the wheel&apos;s rate β̇; an action is one of five torques, every 5 ms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A pole on a driven wheel, DC motor with gears; it should drive on at 0.5 m/s and not fall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A threshold from the length of an episode: what a pair is worth from which the goal is n* steps away.</source>
        <translation>Eine Schwelle aus der Länge einer Episode: was ein Paar wert ist, von dem aus das Ziel n* Schritte entfernt ist.</translation>
    </message>
    <message>
        <source>A trace below this is forgotten.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About its centre of mass.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acrobot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions that fall with a higher probability are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions with decreased power.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions with increased power.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds the change of a coarse value function to the reward; it learns from these rewards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After a fall the world goes back so many steps, and the episode goes on from there; it counts as a rewind and not as a fall. For simulations; 0: a fall ends the episode.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Always takes an action that is worth most, so it never explores.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Always the best action.</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An episode is cut off after this many steps; that is not a fall.</source>
        <translation>Eine Episode wird nach so vielen Schritten abgebrochen; das ist kein Sturz.</translation>
    </message>
    <message>
        <source>An episode starts at rest, anywhere within ± this angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An exploring step picks among the actions worth more than this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of the body when an episode begins, at rest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of the stance leg at the start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of the swing leg at the start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ankle above x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ankle above y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ankle below x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ankle below y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ankle damper</source>
        <translation>Knöcheldämpfer</translation>
    </message>
    <message>
        <source>Ankle high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ankle low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ankle stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ankle stop damping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ankle target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ankles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another motor: 9.5 Ω, and more dry friction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As Softmax, with a temperature that fits each state by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asymmetry</source>
        <translation>Asymmetrie</translation>
    </message>
    <message>
        <source>Asymmetry of errors</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balanced rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balanced: the angle is at most this, and the rate as well.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balanced: the rate is at most this, and the angle as well.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ball on a beam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Biped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boom force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boom point x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boom point y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Budget</translation>
    </message>
    <message>
        <source>Cart-pole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Caution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of a circle that meets the floor, in its body&apos;s frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of mass, in the body&apos;s own frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cliff</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compass walker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compass walker (from a file)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Constants calibrated to the episode lengths that the thesis reports.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Constants of the same laboratory&apos;s published simulation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counted in</source>
        <translation>Gezählt in</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Damping of the joint&apos;s stops.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delft lab file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discount of risk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displaced grids of tiles, in a dense or hashed table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displaced grids that lie over each other; a power of two is best.</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Doomed beyond this lean of the torso.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dry friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dry friction on the hinge of the pole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each term of the reward goes its own way, or their sum goes by its sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Efficiency</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors below 0 count 1 + κ times, those above 1 − κ times: with κ &gt; 0 it is risk-averse.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected Sarsa</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected Sarsa(λ): the mean over the policy in place of one draw.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected losses count so many times.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exploration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exploration, clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exploration, end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exploration, schedule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exploration, time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor of losses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor of losses, clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor of losses, end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor of losses, schedule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor of losses, time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fall angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fall, stance leg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fall, stance thigh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fall, swing leg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fall, thigh</source>
        <translation>Sturz, Oberschenkel</translation>
    </message>
    <message>
        <source>Fall, torso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>Falls an episode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Falls an hour</source>
        <translation>Stürze pro Stunde</translation>
    </message>
    <message>
        <source>Falls budget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Falls of a greedy test, last 10</source>
        <translation>Stürze eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>Falls taken back in an episode, at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot centre x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot centre y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot inertia</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Footstep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For worlds of few states: nothing is shared, nothing is generalised.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Friction</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussians on a grid, width and spacing set apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussians on a grid. Their width can be set apart from their spacing, which tiles cannot do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gear ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greedy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greedy test</source>
        <translation>Greedy-Test</translation>
    </message>
    <message>
        <source>Greedy test every</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid world</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guardian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guardian from</source>
        <translation>Wächter ab</translation>
    </message>
    <message>
        <source>Gymnasium&apos;s CartPole-v1: a pole on a cart that is pushed left or right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half of it sits on each leg, at the hip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half the damping, low friction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand-made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hashed tiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heel radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heel x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heel y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High: nearly equal chances. Low: nearly greedy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest value of a pair before anything is learned.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hip above x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hip above y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hip below x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hip below y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hip damper</source>
        <translation>Hüftdämpfer</translation>
    </message>
    <message>
        <source>Hip high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hip low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hip mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hip stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hip stop damping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hip target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hopper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How a walker walks with what it has learned so far.</source>
        <translation>Wie ein Läufer mit dem geht, was er bisher gelernt hat.</translation>
    </message>
    <message>
        <source>How far back along the way a surprise is felt; 0: one step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the simulation is from the actual system: the rows of the thesis&apos;s table.</source>
        <translation>Wie weit die Simulation vom wirklichen System entfernt ist: die Zeilen der Tabelle der Arbeit.</translation>
    </message>
    <message>
        <source>How it changes while the life goes on: not at all, in a straight line, by halves, or as the rule of thumb says.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it changes while the life goes on: not at all, in a straight line, or by halves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long a linear schedule takes to its end; the half-life of an exponential one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many steps the learner takes to the goal. The rule of thumb is made from it.</source>
        <translation>Wie viele Schritte der Lerner bis zum Ziel braucht. Daraus folgt die Faustregel.</translation>
    </message>
    <message>
        <source>How much more a fall costs after an episode with one fall too many.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How well it does by now. 198 of 200 counts as converged.</source>
        <translation>Wie gut es inzwischen gelingt. 198 von 200 gilt als konvergiert.</translation>
    </message>
    <message>
        <source>Increased power with the realistic errors of 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inertia of a rotor as the joint feels it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Initial Q</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Initial Q, low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Initial risk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has fallen beyond this angle of the stance leg.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has fallen beyond this angle of the swing leg.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knee above x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knee above y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knee below x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knee below y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knee cap radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knee cap x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knee cap y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knee damper</source>
        <translation>Kniedämpfer</translation>
    </message>
    <message>
        <source>Knee high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knee low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knee stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knee stop damping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LEO</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LEO (from a file)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LEO walker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learns flat out; the world shows another one at its usual pace, with the newest values.</source>
        <translation>Lernt so schnell es geht; die Welt zeigt eine andere im üblichen Tempo, mit den neuesten Werten.</translation>
    </message>
    <message>
        <source>Learns how likely an action ends in a fall, beside its value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learns the value of the greedy policy, whatever is done meanwhile (Watkins). So at a cliff it learns the edge, and falls while it explores.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learns the value of what it does, exploring included: a′ is the action that is taken next.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learns to walk within a few simulated minutes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leg inertia</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leg length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leg mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the pole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit of risk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit of risk, clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit of risk, end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit of risk, schedule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit of risk, time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit of the guardian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear damping of the wheel motors, per rad.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low damping, high friction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low: nearly equal chances. High: nearly greedy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lowest value of a pair before anything is learned.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass of the cart without its wheel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass of the driven wheel, a solid cylinder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass of the pole, a uniform rod.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mellowmax</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mellowness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mellowness, clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mellowness, end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mellowness, schedule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mellowness, time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mismatched LEO</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mostly greedy; in a share ε of the steps it takes any of the n actions with equal chance. So it also takes those that make the robot fall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mountain car</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies every resolution: the fraction of Q_opt in chapter 6.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies every width and leaves the centres where they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies the torque of every action.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Net footsteps of a greedy test, last 10</source>
        <translation>Netto-Fußschritte eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>Net footsteps of a life</source>
        <translation>Netto-Fußschritte eines Lebens</translation>
    </message>
    <message>
        <source>Nineteen states in a row and one action: only values are learned, and they are known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of a circle that meets the floor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of a motor&apos;s windings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of a motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of each voltage; actions are their combinations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of every joint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of feet and floor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of one leg about its centre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of one leg, its centre in the middle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of one such body; the torso&apos;s with boom and arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the floor: below 0 it goes uphill.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the gears.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the hip; the actions are −, 0 and + this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the Earth 9.81.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One value a state, for states of whole numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other actions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over</source>
        <translation>Über</translation>
    </message>
    <message>
        <source>Pendulum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pendulum (from a file)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pendulum, actual system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pole angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pole length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pole mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pole rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-learning, Q(λ)</source>
        <translation>Q-Learning, Q(λ)</translation>
    </message>
    <message>
        <source>Radial basis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radial basis functions</source>
        <translation>Radiale Basisfunktionen</translation>
    </message>
    <message>
        <source>Radius of the driven wheel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Rate of the budget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate of the stance leg at the start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resistance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Reward for balancing the pole.</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reward of a footstep, a metre of its length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reward of a greedy test, last 10</source>
        <translation>Belohnung eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>Reward of a joule that hips and knees take.</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reward shaping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risiko</translation>
    </message>
    <message>
        <source>Risk of a fall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule of thumb</source>
        <translation>Faustregel</translation>
    </message>
    <message>
        <source>Sarsa</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sarsa with the mean over the policy in place of the one action that is drawn: the same values with less chance in them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sarsa(λ) that equals its forward view, but for the cut-off of its traces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sarsa(λ) with dutch traces and a correction, so that after every step the weights are those of the forward view, which looks ahead at the returns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sarsa(λ) with expected gains and losses in two Q-functions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sarsa(λ), the on-policy rule of the thesis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sarsa_2Q</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seat x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seat y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Segway on bumpy ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shank centre x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shank centre y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shank inertia</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shank mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaping</source>
        <translation>Shaping</translation>
    </message>
    <message>
        <source>Shaping discount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaping step size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share by which start angles and rates vary; in rad/s that of the swing leg.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the error that one update closes, over all tilings together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the exploring steps that pick an action below the threshold all the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the steps that explore instead of taking the best action.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So many falls an episode are allowed; with more a fall costs more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So many times an episode goes on after a fall; the fall after that ends it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Softmax</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split of energy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split of fall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split of footstep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split of goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split of left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split of price_of_fall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split of right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split of shaping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split of time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stance angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stance hip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stance hip rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stance hip voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stance knee</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stance knee rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stance rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start stance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start swing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start, stance foot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start, stance shank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start, stance thigh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start, swing foot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start, swing shank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start, swing thigh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start, torso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step size, clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step size, end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step size, schedule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step size, time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step, episode, life, experiment</source>
        <translation>Schritt, Episode, Leben, Experiment</translation>
    </message>
    <message>
        <source>Steps back after a fall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps of the simulation in one transition.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness of the joint&apos;s stops.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Substeps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sutton &amp; Barto&apos;s 19 states with one action: values only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sutton &amp; Barto&apos;s car that is too weak for the slope.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sutton &amp; Barto&apos;s cliff walking, a grid of 4 × 12.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swing angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swing hip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swing hip rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swing hip voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swing knee</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swing knee rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swing knee voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swing rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TD error</source>
        <translation>TD-Fehler</translation>
    </message>
    <message>
        <source>TRL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TRL&apos;s limit: what is worth no more than this is hardly ever tried.</source>
        <translation>Die Grenze von TRL: Was nicht mehr wert ist als dies, wird kaum je versucht.</translation>
    </message>
    <message>
        <source>Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature, clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature, end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature, schedule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature, time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten states in a row between a fall and the goal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten states in a row, a fall at one end and the goal at the other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Delft robot on two legs, in Box2D.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Delft robot on two legs, on the task of wcaarls/grl (addons/leosim), as a robot file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Delft robot on two legs: ten state variables, motors with gears, feet with heel and toe. It is paid for metres, and pays for energy, time and falls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The angle between the hips that the hand-made controller aims at.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The angle that the ankles hold.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The best action, but any with probability ε.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The better an action, the likelier, by a temperature.</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The environment&apos;s own controller, which does not learn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The environment&apos;s own controller. It does not learn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The episode from which on the average reward of all lives stands still. Falls are counted until then.</source>
        <translation>Die Episode, von der an die mittlere Belohnung aller Leben stillsteht. Bis dahin werden Stürze gezählt.</translation>
    </message>
    <message>
        <source>The feet are round.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The guardian acts from this risk on, until the risk is below half of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest; actions are levels between ± this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pole has fallen at this angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The risk of an action of which nothing is known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot with motors of 8.6 Ω.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rule of thumb appears with the first footstep.</source>
        <translation>Die Faustregel erscheint mit dem ersten Fußschritt.</translation>
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
        <translation>Die Faustregel verlangt eine Lernregel mit Diskontierung.</translation>
    </message>
    <message>
        <source>The span of the wheel rate that its tiles are counted in: 20 rad/s is 1 m/s of the cart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The step size of the coarse value function V.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surprise of a step: what came, and what is now expected, against what was expected.</source>
        <translation>Die Überraschung eines Schritts: was kam und was nun erwartet wird, gegen das, was erwartet wurde.</translation>
    </message>
    <message>
        <source>The swing foot meets the floor from this angle in front of the stance leg on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thesis&apos;s inverted pendulum on a cart, as a robot file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thesis&apos;s inverted pendulum on a cart, in Box2D.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the column from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the pole angle from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the pole rate from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the position from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the row from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the stance angle from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the stance hip from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the stance hip rate from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the stance knee from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the stance knee rate from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the stance rate from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the state from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the swing angle from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the swing hip from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the swing hip rate from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the swing knee from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the swing knee rate from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the swing rate from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the torso from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the torso rate from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the velocity from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiles cover the wheel rate from here to there; outside they are worth 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value that the schedule goes to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The worse an action, the rarer it is taken. The temperature τ says how much worse counts: high, and all actions are nearly alike; low, and it is nearly greedy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thesis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thigh centre x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thigh centre y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thigh inertia</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thigh mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threshold, clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threshold, end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threshold, schedule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threshold, time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threshold-restricted learning: ε-greedy whose exploring steps pick among the actions that are worth more than a threshold, and only in a small share p (“share below”) among the others. If no action or every action is above, it is ε-greedy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tile coder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tile coding</source>
        <translation>Tile Coding</translation>
    </message>
    <message>
        <source>Tiles per 2π rad of the pole angle: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per 2π rad/s of the pole rate: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per V of the stance hip voltage: few let near actions share more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per V of the swing hip voltage: few let near actions share more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per V of the swing knee voltage: few let near actions share more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per cell of the column: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per cell of the row: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per cell of the state: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per m/s of the wheel rate: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad of the stance angle: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad of the stance hip: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad of the stance knee: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad of the swing angle: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad of the swing hip: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad of the swing knee: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad of the torso: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad/s of the stance hip rate: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad/s of the stance knee rate: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad/s of the stance rate: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad/s of the swing hip rate: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad/s of the swing knee rate: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad/s of the swing rate: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per rad/s of the torso rate: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per span of a variable. Few generalise far, many tell states apart.</source>
        <translation>Kacheln je Spanne einer Variablen. Wenige verallgemeinern weit, viele unterscheiden Zustände.</translation>
    </message>
    <message>
        <source>Tiles per the whole range of the position: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles per the whole range of the velocity: few generalise far, many tell states apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles that a hashed table of fixed size holds; 0: a dense table with room for all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Toe x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Toe y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque constant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torso centre x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torso centre y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torso inertia</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torso mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torso rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace cut-off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace decay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Traces of the actions not taken in a state visited again: kept, or cleared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>True online Sarsa</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two links that hang, a motor between them; the tip must rise one link above the pivot (Sutton &amp; Barto).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two straight legs and a hip motor: the simplest thing that walks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two straight legs and a hip. The swing foot passes through the floor until it is in front.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two straight legs and a hip: the simplest thing that walks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uphill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voltage by which ankles hold their angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voltage by which the stance knee stretches itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watkins&apos;s Q(λ), off-policy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of risk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of risk, clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of risk, end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of risk, schedule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of risk, time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a fall one step later still counts; 1: all falls of the episode count.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a reward one step later is still worth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is expected from action a in state s on: the sum of rewards, later ones worth less.</source>
        <translation>Was ab Aktion a in Zustand s zu erwarten ist: die Summe der Belohnungen, spätere weniger wert.</translation>
    </message>
    <message>
        <source>What is learned in a simulation that is a little wrong is carried over to the robot.</source>
        <translation>Was in einer etwas falschen Simulation gelernt wurde, wird auf den Roboter übertragen.</translation>
    </message>
    <message>
        <source>What is to be avoided, while it learns as well: a fall can break the robot.</source>
        <translation>Was zu vermeiden ist, auch während des Lernens: Ein Sturz kann den Roboter beschädigen.</translation>
    </message>
    <message>
        <source>What the boom adds, upwards positive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the policy does with the risk of a fall, or with the losses of Sarsa_2Q.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the robot is meant to be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the time of the schedule is counted in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel span</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the boom&apos;s force acts on the torso.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the joint is in the body above it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the joint is in the body below it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the joint&apos;s stop is, bent backwards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the joint&apos;s stop is, bent forwards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which estimate learns from this reward: by its sign, Q⁺, Q⁻ or both.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which weights a surprise still reaches: those of the last steps, the older the less.</source>
        <translation>Welche Gewichte eine Überraschung noch erreicht: die der letzten Schritte, je älter, desto weniger.</translation>
    </message>
    <message>
        <source>Who acts while the policy&apos;s action is too risky: the robot&apos;s own controller, or a Q-function of a file. The learner learns from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the pole angle: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the pole rate: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the position: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the row: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance angle: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance hip rate: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance hip: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance knee rate: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance knee: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance rate: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the state: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing angle: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing hip rate: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing hip: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing knee rate: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing knee: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing rate: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the torso rate: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the torso: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the velocity: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the wheel rate: a wide one generalises far.</source>
        <translation type="unfinished"></translation>
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
        <translation>anhäufend</translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>column</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation>Stürze bisher</translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hand-made</source>
        <translation>fester Regler</translation>
    </message>
    <message>
        <source>hashed tiles</source>
        <translation type="unfinished"></translation>
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
        <translation>Knöchelgeschwindigkeit (links)</translation>
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
        <translation>Hüftgeschwindigkeit (links)</translation>
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
        <translation>Kniegeschwindigkeit (links)</translation>
    </message>
    <message>
        <source>left knee voltage</source>
        <translation>Kniespannung (links)</translation>
    </message>
    <message>
        <source>left toe</source>
        <translation>linker Zeh</translation>
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
        <translation type="unfinished"></translation>
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
        <translation>Netto-Fußschritte</translation>
    </message>
    <message>
        <source>net footsteps of a greedy test, last 10</source>
        <translation>Netto-Fußschritte eines Greedy-Tests, letzte 10</translation>
    </message>
    <message>
        <source>net footsteps of a life</source>
        <translation>Netto-Fußschritte eines Lebens</translation>
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
        <translation>von uns (Arbeit, Abschnitt 6.5)</translation>
    </message>
    <message>
        <source>ours: 0, as in the thesis</source>
        <translation>von uns: 0, wie in der Arbeit</translation>
    </message>
    <message>
        <source>ours: 0, as in the thesis (Mihatsch &amp; Neuneier 2002)</source>
        <translation>von uns: 0, wie in der Arbeit (Mihatsch &amp; Neuneier 2002)</translation>
    </message>
    <message>
        <source>ours: 1 is Sarsa_2Q of the thesis</source>
        <translation>von uns: 1 ist Sarsa_2Q der Arbeit</translation>
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
        <translation>von uns: niemand, wie in der Arbeit</translation>
    </message>
    <message>
        <source>ours: off, as in the thesis</source>
        <translation>von uns: aus, wie in der Arbeit</translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pole rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position</source>
        <translation type="unfinished"></translation>
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
        <translation>Knöchelgeschwindigkeit (rechts)</translation>
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
        <translation>Hüftgeschwindigkeit (rechts)</translation>
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
        <translation>Kniegeschwindigkeit (rechts)</translation>
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
        <translation>rechter Zeh</translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>scale</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stance foot</source>
        <translation>Fuß (Stand)</translation>
    </message>
    <message>
        <source>stance hip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stance hip rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stance hip voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stance knee</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stance knee rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stance rate</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step size, clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step size, end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step size, schedule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step size, time</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swing foot</source>
        <translation>Fuß (Schwung)</translation>
    </message>
    <message>
        <source>swing hip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swing hip rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swing hip voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swing knee</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swing knee rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swing knee voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swing rate</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>torso rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trace decay</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>voltage</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation>T = Faktor·T(a)</translation>
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
        <translation>tief ≤ Gelenkwinkel ≤ hoch</translation>
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
        <translation>r = Fußschritt·Länge des Schritts [m]; Sturz, und die Episode endet</translation>
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
        <translation>r ← r + Fußschritt·Δx, Δx die gewonnenen Meter [m]</translation>
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
        <translation>ersetzend: z(s, a) ← 1; anhäufend: z(s, a) ← γ·λ·z(s, a) + 1</translation>
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
        <translation>Rate Standbein(0) = dies·(1 ± Rauschen)</translation>
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
        <translation>Kachelbreite = 1/(Auflösung·Faktor)</translation>
    </message>
    <message>
        <source>tile width = span/(resolution·scale)</source>
        <translation>Kachelbreite = Spanne/(Auflösung·Faktor)</translation>
    </message>
    <message>
        <source>tile width of the wheel rate = wheel span/(resolution·scale)</source>
        <translation>Kachelbreite der Radgeschwindigkeit = Radspanne/(Auflösung·Faktor)</translation>
    </message>
    <message>
        <source>tile width, or spacing of centres = span/(resolution·scale)</source>
        <translation>Kachelbreite oder Abstand der Mittelpunkte = Spanne/(Auflösung·Faktor)</translation>
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
        <translation>w = U[tief, hoch]/n am Anfang, sodass Q zwischen tief und hoch liegt</translation>
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
        <translation>z &lt; Abschneidegrenze: z ← 0</translation>
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
        <translation>|α| ≤ Winkel und |α̇| ≤ Rate: balanciert</translation>
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
        <translation>σ einer Gaußfunktion = Breite·eigenes σ</translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the versions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the clipboard, for a report of a fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surefoot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source># Surefoot %1

Reinforcement learning that avoids falling.

The methods are those of M. van Diepen&apos;s thesis *Avoiding failure states during Reinforcement Learning*, Delft.

Free software under the GNU General Public License, version 3 or later: you may use, study, share and change it. It comes without any warranty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Versions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Citing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contributing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Security</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::ActionRows</name>
    <message>
        <source>max Q</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>risk of the next action %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 actions are below the limit of %3 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 are left out: %3 to %4 in 100 such actions end in a fall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is worth most, but its risk of %2 % counts as −%3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All are above the limit: the least risky is taken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All are above the limit: only the best is taken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is worth most, but %2 in 100 such actions end in a fall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is worth nearly as much as the best, but %2 in 100 such actions end in a fall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is left out: %2 in 100 such actions end in a fall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risiko</translation>
    </message>
    <message>
        <source>limit %1 %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::Autosave</name>
    <message>
        <source>%1 cannot be made.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::ChoiceBox</name>
    <message>
        <source>Find the mistake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>because … one sentence, your own words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Because</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::ClaimsTable</name>
    <message>
        <source>Claims of the thesis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Claim of the thesis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thesis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ours (95 % interval)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The claim&apos;s number in the recipe and in RESULTS.md: a letter for the topic, counted within it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, p %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not significant (p ≥ .01)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::CompareBox</name>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One cannot tell from these lives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lives are still being lived.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::CompareStrip</name>
    <message>
        <source>began with an empty table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>began %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learning rule of the second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Policy of the second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start of the second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Falls of both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters of the second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is changed there holds for the second only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>same start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a file …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the second begins with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-functions (*.safetensors *.surefoot);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second has not finished an episode yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No episode has ended in both yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after %1 %2 : %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; after %1 min %2 : %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; its own: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::ConditionForm</name>
    <message>
        <source>Name of the condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of a life</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Average reward that ends the pre-learning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-functions in the pool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment of the condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenario of the condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learning rule of the condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Representation of the condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Policy of the condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-learning of the condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Learning rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Representation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Policy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter %1 to set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values of parameter %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one, or several: 0; 50; 100</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set or vary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>made from policy and values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A life [episodes]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A life [min]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-learned on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>until reward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-functions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::ConditionList</name>
    <message>
        <source>Conditions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pairs of Q-functions, p &lt; .01</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Q-functions, p &lt; .01</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pairs of lives, p &lt; .01</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one-way ANOVA, p &lt; .01</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-learning</source>
        <translation>Vorlernen</translation>
    </message>
    <message>
        <source>scenario %1, to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scenario %1, %2 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-functions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one a life</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A life</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 simulated min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 a condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paired, from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>independent, from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lives grow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>until it is decided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conditions appear here. Choose a plan above, or open one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DESIGN</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::CurveNames</name>
    <message>
        <source>from nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>learned before</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::Experiment</name>
    <message>
        <source>Appears with the first lives.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a plan, and run it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Appears when the plan runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is being read …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all lives are there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is being written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no process writes it now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no life is over yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is followed, read only; stop following first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What these results had in hand is still being kept; run them again in a moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The results have no place: %1 cannot be made.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::ExperimentPage</name>
    <message>
        <source>Stop following</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The results stay, as if the store had been opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The results are kept. They stand in the list of experiments, and here: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was lived so far is kept and can be gone on with. It stands in the list of experiments, and here: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 of %3 lives)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start again: forget what was lived</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LaTeX</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the table as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the table as LaTeX</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lives done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Following %1, read only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on all the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow it, and go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause: lives stand still where they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, and %1 in lives that are not over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a plan or results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plans and results (*.toml *.sqlite);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plans (*.toml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plan is in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to copy yet; run the experiment first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The table is on the clipboard, as CSV.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The table is on the clipboard, as LaTeX.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results can be exported when the experiment is complete or paused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the tables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the tables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>conditions.csv, lives.csv and episodes.csv are in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no chart yet; run the experiment first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing the charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every chart is in %1, as PNG, SVG, PDF and CSV.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something is being written; wait for its end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was cancelled; what was written before is there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thesis&apos;s claims</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>falls during learning, against the reference of each condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the thesis claims, and what came out here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>so far · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The conditions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (95 % interval %1 to %2 %)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is being opened …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The finding in one sentence appears here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No condition falls significantly less than its reference (p &amp;lt; .01).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So far no condition falls significantly less than its reference (p &amp;lt; .01).</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>So far (%1 of %2 lives) </source>
        <translation>
            <numerusform>Bisher (%1 von %2 Leben) </numerusform>
            <numerusform>Bisher (%1 von %2 Leben) </numerusform>
        </translation>
    </message>
    <message>
        <source>%1&lt;b&gt;%2 falls %3 % less than %4&lt;/b&gt;%5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The thesis reports %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Q-functions carry %1 % of the variance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lives a condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many lives each condition lives; more make intervals narrower. Another number begins again, what was lived is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> lives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>until decided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plan has edits that are not used yet, so the number of lives is written there; Use this plan takes all of it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::ExperimentProgress</name>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>elapsed %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is being opened …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>takes about %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>complete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>followed, read only</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::FallsList</name>
    <message>
        <source>The next falls appear here.
Those before were not recorded in this window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Falls appear here. None so far.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::FigurePanel</name>
    <message>
        <source>Figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean and 95 % interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean and 95 % band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>so far · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is being drawn.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::FigureView</name>
    <message>
        <source>Bars that have no room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of the time axis	Home</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is filmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film up to</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a quarter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours of the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>below the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals below the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the film …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The strips of the Signals layout, with a cursor that goes along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None were written down: they are while the Signals layout is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 pictures. The life goes on meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to film yet: nothing has moved in the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A film ends after it begins.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A film of %1 s, in %2.%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> WebP only: all others are made by the program ffmpeg, which is not installed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The film is in %1 (%2).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::FindingsTable</name>
    <message>
        <source>%1 falls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>± (95 %)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>% (95 % interval)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p Holm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expl. %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thesis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pre(3): its lives began with what was learned on scenario 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half of the 95 % interval of the mean, in falls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the falls, against the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The 95 % interval of the change, in per cent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This condition against its reference: by pairs of lives or Q-functions where both have the same, by the Q-functions where lives share them, else the one-way analysis of variance of the lives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same, corrected for all comparisons with this reference (Holm 1979)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X: differs from the reference with p &lt; .01</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated minutes until the end of learning; – for a task without a clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of actions that were not the best by the values at that moment: who explores less falls less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of 100 episodes of the greedy policy at the end of a life, when nothing is learned any more, how many fall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The condition of the chosen row stands out in the figures; Escape lets go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (reference)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So far: not all lives of this condition, or of what it is compared with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Claims %1 of the thesis; all of them stand under &quot;The thesis&apos;s claims&quot;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::Following</name>
    <message>
        <source> What it held before is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is gone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is not there yet; this page waits for it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::HandbookBrowser</name>
    <message>
        <source>Page of the handbook</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::HandbookContents</name>
    <message>
        <source>No page has all of these words.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the handbook</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contents</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::HandbookWindow</name>
    <message>
        <source>Handbook</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>‹ Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page before (Alt+←)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward ›</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page after (Alt+→)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A word on this page (Ctrl+F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find; Return: the next one, Escape: done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find on this page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does not stand on this page.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::Handout</name>
    <message>
        <source>%1 minutes, level %2 of 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name _______________________________   Date ______________</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For the teacher: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You know now: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To discuss: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I set: ____________________   It came to: ____________</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hint: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I say: ____________ %1 (%2 to %3). It came to: ____________</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It comes to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>because</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>____________ %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::HelpButton</name>
    <message>
        <source>%1, in the handbook</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::History</name>
    <message>
        <source>the new life</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::KioskFoot</name>
    <message>
        <source>How much they explore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in 100 steps both try something else than the best</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of 100</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the lesson&apos;s word</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lesson&apos;s word</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you see</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::KioskRobot</name>
    <message>
        <source>Touch the pole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both get the same push</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>World of %1</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Softmax</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tries what is nearly as good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by itself in %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ε-greedy %1 falls, Softmax %2 falls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is being made ready …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ε = %1 against τ = %2, %3 episodes each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After %1 episodes: %2 falls against %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now neither tries anything: both always take what they think is best.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::KnobRows</name>
    <message>
        <source>Policy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learning rule</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While it learned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove all earlier runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pushed by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>placed by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gone on from an earlier moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end of learning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A fall after a person placed or pushed the body. A click replays it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click replays this fall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This fall is no longer kept; it cannot be replayed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Falls appear here. None so far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The average appears with the first episodes.</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>live: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>00,000 you said</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>greedy tests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>you said</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>you say</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fewer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::LessonBar</name>
    <message>
        <source>‹  All lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The list of lessons; this one waits at its step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teacher</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes, answers and the class, in a window for the teacher&apos;s own screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run or pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the life again with the same seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turbo</source>
        <translation>Turbo</translation>
    </message>
    <message>
        <source>Learn flat out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast the world runs; real time is in the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long the robot has lived, by its own clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>minutes</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::LessonColumn</name>
    <message>
        <source>%1 % lived</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Explore freely</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A hint, if the step has one (F1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The step begins again, as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Live page with this robot as it is now; the lesson waits here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The step before (Alt+←)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on (Alt+→)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knob</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knobs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 becomes %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 when you commit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lesson is done. You know now: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is being made ready …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is being lived …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lives are being lived …</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q on a map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>actions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rule of thumb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>average reward</source>
        <translation>mittlere Belohnung</translation>
    </message>
    <message>
        <source>list of falls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the learning rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Better after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knobs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue at step %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Explore freely</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Live page, as the lesson begins</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lesson begins anew: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::LessonEditor</name>
    <message>
        <source>Lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live through it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All solutions are lived; what does not come out as the text says is told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is being lived through …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No errors. “Live through it” tries its solutions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Well: all %1 steps were lived through.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The step under the caret is shown here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; as of the last text without an error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the lesson</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::LessonEnd</name>
    <message>
        <source>You know now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In your words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::LessonList</name>
    <message>
        <source>%1, it has an error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not begun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lesson %1 of %2, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1%2, %3 minutes, level %4 of 3, %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::LessonPanels</name>
    <message>
        <source>World</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last 80 episodes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the robot would do now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>% on a square-root scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the last one taught</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule of thumb</source>
        <translation>Faustregel</translation>
    </message>
    <message>
        <source>TRL&apos;s threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List of falls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a click shows one again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lives of each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>real time; the learner runs faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it learns; take hold of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what it can do so far; it learns nothing now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>held still</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::LessonRow</name>
    <message>
        <source>minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has an error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::LessonView</name>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>your prediction</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::LessonsPage</name>
    <message>
        <source>What you do cannot be kept: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>answers are kept on this computer only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>answers of %1 are kept in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thirteen, a good two hours in all; a double lesson of 90 minutes is 1, 2, 3, 5, 6, 7, 11, 13</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was said and done in “%1” is forgotten when it begins again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All are done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lessons come with the program; none were found in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1   step %2 of %3, %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1   %2 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You were asked: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 hours left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For teachers:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a lesson file can also be dropped here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the chosen lesson&apos;s teacher should know: answers, questions, times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a lesson file …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kiosk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand-out …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A lesson of one&apos;s own: one text file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answers are kept in a shared folder, in a file for each student</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two robots on the whole screen, for a booth; a window of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lesson on paper, with room to write, or with the answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A lesson of one&apos;s own as text, checked while it is typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A new lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For students …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the answers …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lessons (*.toml);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The text in hand is not saved; save it, and then take another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This text was not saved; it is back as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every student has a file of their own in the folder. A name of your choosing will do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Join</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shared folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A name has up to 40 letters, digits, blanks, - and _.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no such folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This lesson has no kiosk; these have one: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The kiosk could not be started.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The kiosk opens. Ctrl+Shift+K and the word “%1” leave it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand-out</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::LifeFollower</name>
    <message>
        <source>it is being read …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the life is complete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as of %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the body acts with its values, and learns nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it stands still</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::LivePage</name>
    <message>
        <source>Parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preset %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fewer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the robot would do now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the last one taught</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule of thumb</source>
        <translation>Faustregel</translation>
    </message>
    <message>
        <source>TRL&apos;s threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List of falls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a click shows one again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Average reward</source>
        <translation>Mittlere Belohnung</translation>
    </message>
    <message>
        <source>last %1 episodes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all %1 so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Stürze</translation>
    </message>
    <message>
        <source>Whole life</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole life, or only as far as it learned. In the chart the wheel or a drag magnifies a part; a double click or Home shows the whole life.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While it learned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time shown: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cumulative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to minute %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to episode %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; %2 after a push or placing by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; click a mark to replay it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the state fixed on the map; Escape on the map lets go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the state under the cursor on the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the next action is shaded; %1 actions, by joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the real-time world</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the next action is shaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; Escape: back to live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; ← → move, Escape: back to live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>real time, newest Q-function; nothing is learned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the life is complete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the learner&apos;s world, paused; turbo is on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the learner&apos;s world, paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the learner&apos;s world; its life began %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the learner&apos;s world</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the learner&apos;s world, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>real time; only this world is held, the learner&apos;s is not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>real time, newest Q-function</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>real time, newest Q-function; the learner runs %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>World</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels that share this place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The learner goes on %1 steps into that episode, with what it knows now; the journal says so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phase portrait</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals of the axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two steps each; a click marks one in the signals</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::LivesView</name>
    <message>
        <source>%1: mean %2, 95 percent interval %3 to %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line: one seed; </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a dot: one life; %1bar: 95 % interval of the mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1bar: 95 % interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bar: 95 % interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are being lived …</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::Looking</name>
    <message>
        <source>fall %1, at a quarter of the speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the learner&apos;s own world can be gone on with, in the Signals layout and without turbo; or a fall, or a roll-out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That episode is over, and it did not end in a fall: its inputs were not kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is shown again: open a fall, look back, or roll out first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was %2 then and is %3 now: the same inputs would lead elsewhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The episode was over then; choose a moment before its end.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::MainWindow</name>
    <message>
        <source>Surefoot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The life is complete; restart it to run again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run or pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the life again with the same seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the life again with the same seed and the same start: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The life begins again with the same start: %1. Run › Restart with an empty table begins from nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The life begins again with this seed, a whole number from 0 on:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> or </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything that can be opened (*.surefoot *.safetensors *.jsonl *.toml *.sqlite);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is loaded and goes on learning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is loaded, not running: Run goes on learning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Run › Roll out 25 s shows what it does now, without learning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is written. It checks itself: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is written. Without a window: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture (*.png);;Vector graphics (*.svg);;Document (*.pdf);;Table (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only files of this machine can be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fo&amp;llow …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at results or a checkpoint while another process writes them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;top following</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was followed stays, as if it had been opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learn on, as a life of your own; the file is not followed any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop following</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The life stays as it is, as one of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not followed any more. This is a life of your own now, not saved yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results and checkpoints (*.sqlite* *.safetensors *.surefoot *.ckpt);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Following %1, read only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Handbook</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The handbook, at the page of what has the focus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the words mean, with their formulas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a &amp;lesson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A lesson of one&apos;s own as text, from a template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Surefoot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What this is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is the lesson&apos;s robot as it is now. The lesson waits on its page, where you were.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is being made ready; the world goes on meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The life before is kept: Ctrl+Z brings it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This life is back as it was; the other one is kept for undo and redo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow it, and go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 needs a new table, so learning starts again from the beginning, with the same seed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 = %2 needs a new table. Start again from the beginning, with the same seed, or carry what is learned over into it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Carry over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to keep one more life for undo: a life before this one, of %1, is not saved and would end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This life has %1, is not saved, and there is not enough memory to keep it for undo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>untitled session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surefoot: the life is complete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surefoot: %1</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A life before this one, of %1,</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lives before this one, of %2 episodes,</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the second learned in %1 is not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kept for Ctrl+Z only, not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What this life learned in %1 is not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the robot of the Live page learned in %1 is not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What %1 learned in %2 is not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kept for Ctrl+Z only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Don&apos;t save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the second learner&apos;s session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session could not be kept for the next start: %1 Closing the window again gives it up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last session can go on where it was closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last session was not closed. Its last minutes may be missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It stays where it is: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is set aside as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One step of the paused world</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Turbo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learn flat out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A notch faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A notch slower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look &amp;back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A frame back in what was shown; with Shift a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to &amp;live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the replay and show what happens now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New session in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a session, a Q-function, a journal, a plan or results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the session: it goes on where it was; on the page Robot, the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the session under another name; on the page Robot, the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the Q-&amp;function …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was learned, to load it elsewhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the Q-function</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the policy as &amp;C …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The greedy policy as a C99 program that needs nothing else</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the policy as C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the &amp;journal …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A small text by which the life can be lived again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the journal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As PNG, SVG, PDF or CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>World …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As PNG, SVG or PDF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>World</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole window …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the last change back; bring the life before back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset all &amp;parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To what preset and scenario say</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another &amp;seed …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin again with other random numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours, motion, the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart with an &amp;empty table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the life again with the same seed, from nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Go on from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The learner&apos;s world is put into the moment that a replay shows; it goes on learning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;What if</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compare with a second learner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another method with the same seed, side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second learner begins now. For a fair race, begin the first again, too?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin both again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pre-learn, then transfer …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learn in a simulation, then live in reality with what was learned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;oll out 25 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the greedy policy does from a new start, learning nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rob&amp;ustness …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often what was learned falls, over pushes and models</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xperiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open a plan or results …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A plan, a recipe or a store of results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the &amp;plan as …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plan as a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run or pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the experiment, or pause it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start &amp;again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget what was lived</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy the table as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the table as &amp;LaTeX</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xport all lives as CSV …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conditions, lives and episodes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export all lives for a &amp;spreadsheet …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same, as Excel reads it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export all c&amp;harts …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG, PDF and CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Nothing else: the same again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another policy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another learning rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Le&amp;ssons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>La&amp;youts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Usual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every panel back in its place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Teaching</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a step teaches, and the rule of thumb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Falls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The list of falls beside the charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value maps large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the robot moves: strip charts, phase portrait, strides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep this one as …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The panels as they are now, under a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;My own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit the world</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The zoom that shows the whole world</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fil&amp;m …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last minutes, or a replay, as a film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours of the &amp;system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L&amp;ight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Projector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything as large as the last row of a lecture room needs it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Larger text, controls and drawings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smaller text, controls and drawings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text, controls and drawings in their usual size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything at %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep this layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its name:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name of a layout has 1 to %1 characters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 layouts are kept already; forget one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept as &quot;%1&quot;, in the menu View, Layouts, My own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The layout &quot;%1&quot; is one of another version; keep it anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None kept yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::MapBar</name>
    <message>
        <source>Quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range of the colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the map shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the live state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fix where it is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixed %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean over it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least over it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Most over it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked to what rewards allow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the map shows now</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::ModelRows</name>
    <message>
        <source>Simulation and reality are alike. Add what is to differ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a parameter that differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a parameter that differs …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allowed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in reality</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::NumberBox</name>
    <message>
        <source>Work it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a number, such as −4.5.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::OptionsBox</name>
    <message>
        <source>Check</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::OrderBox</name>
    <message>
        <source>Put them in order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first on top; drag one, or Alt+↑ and Alt+↓</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::PanelHeader</name>
    <message>
        <source>Close %1; the View menu brings it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to all panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give %1 the whole window</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::PanelRow</name>
    <message>
        <source>Full size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels that share this place</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::ParameterForm</name>
    <message>
        <source>new table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>next episode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not with the others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The guardian&apos;s Q-function</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-functions (*.safetensors *.surefoot);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all parameters</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::ParameterRow</name>
    <message>
        <source>%1, number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set at step %1; Reset goes back to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed; Reset goes back to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> or </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset %1 to its default</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::PhasePortrait</name>
    <message>
        <source>Phase portrait</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two signals against each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the marked stride</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last stride</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all that is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::PlanChooser</name>
    <message>
        <source>What to run: plans, the thesis&apos;s figures, your own files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your own files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the experiments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search: a figure&apos;s number, a word</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Title</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a plan or results …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is called that.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::PlanEditor</name>
    <message>
        <source>Use this plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add what the Live page runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A new condition; it begins as the first one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is not added: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plan was changed meanwhile; add it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n conditions</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is being checked …</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::PointBox</name>
    <message>
        <source>Point at it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a click on the map answers; on the map, arrows move the cursor and Enter answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a click on its mark answers</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::PreLearningDialog</name>
    <message>
        <source>Pre-learn, then transfer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenario of the simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a model of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation is scenario</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Average reward that ends the pre-learning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-functions to learn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ε-greedy, until the average reward is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has converged, %2 has not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>or, left empty, for %1 simulated min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>or, left empty, for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-functions in the pool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-function</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Average reward</source>
        <translation>Mittlere Belohnung</translation>
    </message>
    <message>
        <source>A life has begun with Q-function %1: %2 episodes and %3 falls of simulation are behind it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (not reached)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-learn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This environment&apos;s model has nothing to be wrong about; what is learned is carried over as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 are learned. The world goes on meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pool appears here: learn on the simulation, then choose one and begin a life in reality with it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one, and begin a life in reality with it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::PredictionBox</name>
    <message>
        <source>Your prediction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same as a slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2; type it, or drag the mark. Once given it stays. Wrong is fine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You said %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commit to %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::PredictionResult</name>
    <message>
        <source>You said</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and it came to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Very close.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 more than you said.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fewer than you said.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You said %1. It came to %2 %3. %4</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>those of the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours: %1</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>160 %: projector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less of it: no trail, no flash, a camera that stands,
falls shown frame by frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>learn as soon as the window is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> min; a crash loses no more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minutes between two copies of the session on the disk</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::QuestionBox</name>
    <message>
        <source>✓ Right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ Right. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not yet. %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::RandomLife</name>
    <message>
        <source>What a random life looks like</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n falls; %1</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>steps; %1 s in all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Falls in %1 steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To a fall, median</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At a limit of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> % of steps</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::Rival</name>
    <message>
        <source>World of the second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second cannot have the same start (%1): its tables differ. It begins empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the second starts again from the beginning, and what it learned in %2 is given up.</source>
        <translation>%1: Der zweite beginnt wieder von vorn, und was er in %2 gelernt hat, wird aufgegeben.</translation>
    </message>
    <message>
        <source>Another learning rule needs a new table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What if</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters of the second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 = %2 needs a new table: the second starts again from the beginning.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::RobotPage</name>
    <message>
        <source>%1 was saved by another program, and is shown as it is now; undo brings back what was here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was not saved of %1 is here again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed, not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>picture and table: as of the last text without an error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>picture and table come when the text has no error</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F8 the next error</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n lines; F1 says what the word at the caret means</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (and %1 more)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>names and limits under the pointer; a click goes to the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a robot that is not saved yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 tiles a tiling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A new robot, like</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots (*.toml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>starts %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOML, checked while you type; runs nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program moves it: let it learn, and it moves on the Live page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is known of this word.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1 comes to %2 at the start of an episode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was not saved of %1 is in %2; undo brings it back, too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a new robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow it to start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let it learn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Description</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find; Return: the next one, Escape: done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find in the description</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>World</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left to itself: no motors, dampers, friction and contacts. What moves less and less then loses its energy to the size of the substeps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it is drawn, from 20 cm above the ground, motors off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand-made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a random life looks like</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a click on a mark shows the fall</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1°, limit, line %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::RobotText</name>
    <message>
        <source>Description of the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+Enter</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::RobotTrial</name>
    <message>
        <source>a fall of the random life</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keys 1 … %1: %2; ← → push</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keys 1 … %1: the next level of each motor; ← → push</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::RobustnessDialog</name>
    <message>
        <source>Robustness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map is there: %1 models, %2 pushes. The arrow keys choose a cell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The command that gives the same numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The command is copied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save what was tried …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the map …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped; nothing came out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another environment is learned in now; close this window and open it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the Q-function that was tried</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture (*.png);;Vector graphics (*.svg);;Document (*.pdf);;Table (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % is done. The life goes on meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mouse or the arrow keys choose a cell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every cell is tried from the same starts: it lives, is pushed once, and is followed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without a window, once what was tried is saved as %1:
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without a window:
</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::RobustnessForm</name>
    <message>
        <source>Pushes, N s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pushes in newton seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Impulses: a list, 0;0.05;0.1, or a range, 0..0.2:9, nine from 0 to 0.2. Negative ones push to the left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pushed at, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of the push in seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A time, or two with .. between them: every start draws its own between these.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>followed for, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seconds after the push</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the push on: falls in this time are counted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Models</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all scenarios</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters of the models</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters of the environment and their values, with blanks between them: environment.friction=0..0.1:5 environment.damping=0.04;0.08. Every value is combined with every other and with every scenario.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>environment.KEY=VALUES …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Policy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>starts a cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts of every cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials of every push on every model. Trial 1 starts alike in every cell, and so on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed of the starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts, times of pushes and the policy&apos;s draws come from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A second Q-function …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the same environment; it is tried from the same starts on the same models.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A second Q-function</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-functions (*.safetensors *.surefoot);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing: what this life has learned so far is tried alone</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::RobustnessMap</name>
    <message>
        <source>Falls over pushes and models</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>push, N s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, push %2 N s: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beside it: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; %1 succeeded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; %1 flew apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; the intervals have nothing in common</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often it falls appears here: a column a push, a row a model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>100 % fell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>100 % succeeded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the 95 % intervals of the two have nothing in common</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the threshold to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TRL&apos;s threshold in force: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TRL&apos;s threshold is %1; it is not in force while the policy is %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 = %2 = %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R: reward of the goal; n*: mean transitions of the successful episodes while it learned%1 (thesis, eq. %2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; R_t: reward of every step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no goal. R: the highest reward of a step so far; n*: transitions of a footstep%1. The thesis expects this to serve and did not test it (section 4.5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This life began with something learned; the limits are told of lives that begin from nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower limit %1, upper limit %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::RunBar</name>
    <message>
        <source>Pace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast the world runs while turbo is off: %1 to %2 times real time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learning rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Policy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What do these words mean?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What task, learning rule and policy mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenario of the model</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The life is complete; nothing goes on in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program moves this robot; it cannot be put back into a moment.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::Scrubber</name>
    <message>
        <source>Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The learner&apos;s world is put into this moment, and it goes on learning there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::SessionName</name>
    <message>
        <source>Session %1, not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Session %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::ShareSlider</name>
    <message>
        <source>How much they explore, in 100 steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of 100</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>never</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every second step</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::SignalChooser</name>
    <message>
        <source>Search signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One place up (Ctrl+Up)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One place down (Ctrl+Down)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the one above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In one strip with the signal above, or in a strip of its own (Ctrl+J)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usual ones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is shown at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, of the group %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::SignalsBar</name>
    <message>
        <source>Choose …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which signals are shown, and in which order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll out 25 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the greedy policy does in 25 s from a new start, learning nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second Q</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another Q-function beside this one, from the same start with the same pushes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A film of the replay, or of the last minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The signals that are shown, as a picture or as numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What can be done with the signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, the last %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no fall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a &amp;file …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it knows &amp;now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A copy of the Q-function of this moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it &amp;began with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Q-function of the file that this life began with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what it began with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>nach %1</translation>
    </message>
    <message>
        <source>A Q-function beside this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-functions (*.safetensors)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was learned in %2; it cannot stand beside a Q-function of %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As %1 …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Choose signals …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Roll out 25 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Second Q-function</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Film …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::SignalsShown</name>
    <message>
        <source>First: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is learned here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::StateTable</name>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>observed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how often</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ACTIONS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ENDINGS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 steps, %2 s at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  ×%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: range %2 … %3 in the file, %4 tiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; a click on the numbers writes %1 … %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::StatusLine</name>
    <message>
        <source>State of the life</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 M steps/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 steps/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>n* %1 → rule-of-thumb threshold %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rule-of-thumb threshold: not defined here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>table %1 % full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the guardian acted in %1 % of the steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a fall costs %1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 falls taken back</source>
        <translation>
            <numerusform>%1 Sturz zurückgenommen</numerusform>
            <numerusform>%1 Stürze zurückgenommen</numerusform>
        </translation>
    </message>
    <message>
        <source>risk holds: %1 % said, %2 % fell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>risk errs: %1 % said, %2 % fell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>risk unclear: %1 % said, %2 % fell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>began %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>learning ended at episode %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walks since minute %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>the robot flew apart %1 times</source>
        <translation>
            <numerusform>der Roboter flog einmal auseinander</numerusform>
            <numerusform>der Roboter flog %1 Mal auseinander</numerusform>
        </translation>
    </message>
    <message>
        <source>the life is complete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>followed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paused</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::StepView</name>
    <message>
        <source>In turbo thousands of steps pass between two pictures. Turn it off to follow a single one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the last step taught appears here. Press “.” for a single step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In S = (%1) it chose A = %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>δ = R + γ %1(S′, A′) − %1(S, A) = %2 + %3 − %4 = %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Just as expected: %1 stays as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Better than expected: %1(S, A) goes up by α δ = %2, to %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worse than expected: %1(S, A) goes down by %2, to %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trace carries the surprise back along the way: each step before gets %1 of it (γ λ = %2 · %3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>λ is 0: no step before learns from it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::StrideTable</name>
    <message>
        <source>Begins s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy J</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy a metre J/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both feet down %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stride</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>second %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first, mean of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>second, mean of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strides appear here: from one touch-down of the left foot to the next.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This robot has no left and right foot whose strides could be told.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::StripCharts</name>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No signal is chosen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals appear here while the world goes on, in a replay of a fall, and in a roll-out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 seconds: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The usual signals</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::TaskBox</name>
    <message>
        <source>Task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ Done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>○ Not done yet; it ticks itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ And with %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extra: can you do it with %1?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::TeacherWindow</name>
    <message>
        <source>as the interval says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a new life with what it has learned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>let it run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>push it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>put it somewhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teacher: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answers of the class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No class: answers of a class come in here (Lessons › Class …).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answer: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hint: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next: %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is the last step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> of about %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The class&apos;s folder is gone: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n students, %1</source>
        <translation>
            <numerusform>%n Studierende/r, %1</numerusform>
            <numerusform>%n Studierende, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 have answered. %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::ValueMaps</name>
    <message>
        <source>, never visited</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>,  risk %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1:  Q %2 for %3%5,  %4 visits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, under caution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outlined: the %1 tiles of this state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no step yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greedy action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risiko</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eligibility</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map appears with the first steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contour: threshold %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all values below threshold %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all below %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all values above threshold %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all above %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contour: risk %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>risk %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gains</source>
        <translation>Gewinne</translation>
    </message>
    <message>
        <source>fall</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export as %1 …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is in the clipboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The numbers are in the clipboard, as CSV.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::WordsBox</name>
    <message>
        <source>Your own words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mine says the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept as it is; the program does not mark it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::WordsDialog</name>
    <message>
        <source>Words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No word has this in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>surefoot::WorldView</name>
    <message>
        <source>World</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taken at random</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taken as the best</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
