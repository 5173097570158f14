<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nl" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>agrees</source>
        <translation>klopt</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>wijkt af</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>onbeslist</translation>
    </message>
    <message>
        <source>nothing lived yet</source>
        <translation>nog niets geleefd</translation>
    </message>
    <message>
        <source>%1, followed</source>
        <translation>%1, gevolgd</translation>
    </message>
    <message>
        <source>%1, saved after every life</source>
        <translation>%1, na elk leven opgeslagen</translation>
    </message>
    <message>
        <source>pre-learned on scenario %1</source>
        <translation>vooraf geleerd op scenario %1</translation>
    </message>
    <message>
        <source> to %1</source>
        <translation> tot %1</translation>
    </message>
    <message>
        <source>, thesis %1</source>
        <translation>, scriptie %1</translation>
    </message>
    <message numerus="yes">
        <source>, %1 of %2 lives so far</source>
        <translation>
            <numerusform>, tot nu toe %1 van %2 leven</numerusform>
            <numerusform>, tot nu toe %1 van %2 levens</numerusform>
        </translation>
    </message>
    <message>
        <source>✕ differs from the reference, p &lt; .01</source>
        <translation>✕ verschilt van de referentie, p &lt; 0,01</translation>
    </message>
    <message>
        <source>◇ the thesis</source>
        <translation>◇ de scriptie</translation>
    </message>
    <message>
        <source>open bars: so far, lives are missing</source>
        <translation>open staven: tot nu toe, er ontbreken levens</translation>
    </message>
    <message>
        <source>highest at the end first</source>
        <translation>hoogste aan het eind eerst</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… en nog %1</translation>
    </message>
    <message>
        <source> (95 %: %1 … %2)</source>
        <translation> (95 %: %1 … %2)</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>een geheel getal van %1 tot %2</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>een getal van %1 tot %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <comment>values</comment>
        <translation>%1 of %2</translation>
    </message>
    <message>
        <source>The class&apos;s folder is gone: %1.</source>
        <translation>De map van de klas is er niet meer: %1.</translation>
    </message>
    <message>
        <source>The file %1 cannot be removed.</source>
        <translation>Het bestand %1 kan niet worden verwijderd.</translation>
    </message>
    <message>
        <source>gone on with</source>
        <translation>vervolgd</translation>
    </message>
    <message>
        <source>pushed</source>
        <translation>geduwd</translation>
    </message>
    <message>
        <source>placed</source>
        <translation>geplaatst</translation>
    </message>
    <message>
        <source>Fall</source>
        <translation>Val</translation>
    </message>
    <message>
        <source>Episode</source>
        <translation>Episode</translation>
    </message>
    <message>
        <source>Time min</source>
        <translation>Tijd min</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stappen</translation>
    </message>
    <message>
        <source>Policy</source>
        <translation>Policy</translation>
    </message>
    <message>
        <source>Click to see the last seconds of this fall again</source>
        <translation>Klik om de laatste seconden van deze val terug te zien</translation>
    </message>
    <message>
        <source>%1, %2 by hand</source>
        <translation>%1, %2 met de hand</translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risico</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Leren</translation>
    </message>
    <message>
        <source>Rewards</source>
        <translation>Beloningen</translation>
    </message>
    <message>
        <source>Representation</source>
        <translation>Representatie</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>best action</source>
        <translation>beste actie</translation>
    </message>
    <message>
        <source>greedy action</source>
        <translation>greedy actie</translation>
    </message>
    <message>
        <source>greedy %1</source>
        <translation>greedy %1</translation>
    </message>
    <message>
        <source>risk of a fall</source>
        <translation>risico op een val</translation>
    </message>
    <message>
        <source>visits</source>
        <translation>bezoeken</translation>
    </message>
    <message>
        <source>eligibility</source>
        <translation>eligibility</translation>
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
        <translation>%1 vast %2</translation>
    </message>
    <message>
        <source>mean over %1</source>
        <translation>gem. over %1</translation>
    </message>
    <message>
        <source>least over %1</source>
        <translation>laagste over %1</translation>
    </message>
    <message>
        <source>most over %1</source>
        <translation>hoogste over %1</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> steps</source>
        <translation> stappen</translation>
    </message>
    <message>
        <source>not known here</source>
        <translation>hier niet bekend</translation>
    </message>
    <message>
        <source>on</source>
        <translation>aan</translation>
    </message>
    <message>
        <source>off</source>
        <translation>uit</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>stap %1</translation>
    </message>
    <message>
        <source>Reward</source>
        <translation>Beloning</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Voeten</translation>
    </message>
    <message>
        <source>On and off</source>
        <translation>Aan en uit</translation>
    </message>
    <message>
        <source>There is not enough memory to try this Q-function.</source>
        <translation>Er is niet genoeg geheugen om deze Q-functie te proberen.</translation>
    </message>
    <message>
        <source>carried over</source>
        <translation>overgenomen</translation>
    </message>
    <message>
        <source>with %1</source>
        <translation>met %1</translation>
    </message>
    <message>
        <source>pre-learned</source>
        <translation>vooraf geleerd</translation>
    </message>
    <message>
        <source>pre-learned (scenario %1)</source>
        <translation>vooraf geleerd (scenario %1)</translation>
    </message>
    <message>
        <source>A program moves this robot; surefoot rollout lives what its Q-function has learned.</source>
        <translation>Een programma beweegt deze robot; surefoot rollout beleeft wat zijn Q-functie geleerd heeft.</translation>
    </message>
    <message>
        <source>Nothing has been learned yet that could be lived.</source>
        <translation>Er is nog niets geleerd dat beleefd kan worden.</translation>
    </message>
    <message>
        <source>This environment cannot be lived in here.</source>
        <translation>In deze omgeving kan hier niet geleefd worden.</translation>
    </message>
    <message>
        <source>fall %1, episode %2, at half speed</source>
        <translation>val %1, episode %2, op halve snelheid</translation>
    </message>
    <message>
        <source>roll-out, greedy, seed %1</source>
        <translation>rollout, greedy, seed %1</translation>
    </message>
    <message>
        <source>the last minutes</source>
        <translation>de laatste minuten</translation>
    </message>
    <message>
        <source>There is not enough memory for this; take fewer tiles or tilings.</source>
        <translation>Hiervoor is niet genoeg geheugen; neem minder tegels of betegelingen.</translation>
    </message>
    <message>
        <source>Remove earlier runs</source>
        <translation>Eerdere runs verwijderen</translation>
    </message>
    <message>
        <source>More was changed than a journal holds; save the session instead.</source>
        <translation>Er is meer veranderd dan een logboek bevat; sla in plaats daarvan de sessie op.</translation>
    </message>
    <message>
        <source>The action values diverged; there is nothing worth keeping.</source>
        <translation>De actiewaarden zijn gedivergeerd; er is niets dat bewaren waard is.</translation>
    </message>
    <message>
        <source>The action values diverged; there is nothing to try.</source>
        <translation>De actiewaarden zijn gedivergeerd; er is niets te proberen.</translation>
    </message>
    <message>
        <source>There is not enough memory for a copy of the action values; nothing is lost.</source>
        <translation>Er is niet genoeg geheugen voor een kopie van de actiewaarden; er gaat niets verloren.</translation>
    </message>
    <message>
        <source>The life is not kept any more.</source>
        <translation>Het leven wordt niet meer bewaard.</translation>
    </message>
    <message>
        <source>there is not enough memory for what it holds.</source>
        <translation>er is niet genoeg geheugen voor wat erin staat.</translation>
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
            <numerusform>%1 leven</numerusform>
            <numerusform>%1 levens</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 falls</source>
        <translation>
            <numerusform>%1 val</numerusform>
            <numerusform>%1 valpartijen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 steps</source>
        <translation>
            <numerusform>%1 stap</numerusform>
            <numerusform>%1 stappen</numerusform>
        </translation>
    </message>
    <message>
        <source>It takes %1. Default: %2 (%3).</source>
        <translation>Toegestaan: %1. Standaard: %2 (%3).</translation>
    </message>
    <message>
        <source>Source: %1.</source>
        <translation>Bron: %1.</translation>
    </message>
    <message>
        <source>The handbook is not there.</source>
        <translation>Het handboek is er niet.</translation>
    </message>
    <message>
        <source>Another %1 is in this class now; take another name, such as %1 2.</source>
        <translation>Er is nu nog een %1 in deze klas; neem een andere naam, zoals %1 2.</translation>
    </message>
    <message>
        <source>It is kept on this computer, and goes there when it can.</source>
        <translation>Het wordt op deze computer bewaard en gaat erheen zodra het kan.</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Falls during learning</source>
        <translation>Valpartijen tijdens het leren</translation>
    </message>
    <message>
        <source>Average reward</source>
        <translation>Gemiddelde beloning</translation>
    </message>
    <message>
        <source>Average reward against falls</source>
        <translation>Gemiddelde beloning tegen valpartijen</translation>
    </message>
    <message>
        <source>Cumulative falls</source>
        <translation>Cumulatieve valpartijen</translation>
    </message>
    <message>
        <source>Learning time</source>
        <translation>Leertijd</translation>
    </message>
    <message>
        <source>Falls per episode at the end</source>
        <translation>Valpartijen per episode aan het eind</translation>
    </message>
    <message>
        <source>Animated WebP</source>
        <translation>Geanimeerde WebP</translation>
    </message>
    <message>
        <source>Animated GIF</source>
        <translation>Geanimeerde GIF</translation>
    </message>
    <message>
        <source>Animated PNG</source>
        <translation>Geanimeerde PNG</translation>
    </message>
    <message>
        <source>MP4 video</source>
        <translation>MP4-video</translation>
    </message>
    <message>
        <source>WebM video</source>
        <translation>WebM-video</translation>
    </message>
    <message>
        <source>reward: </source>
        <translation>beloning: </translation>
    </message>
    <message>
        <source>fall </source>
        <translation>val </translation>
    </message>
    <message>
        <source>, from</source>
        <translation>, van</translation>
    </message>
    <message>
        <source>, to</source>
        <translation>, tot</translation>
    </message>
    <message>
        <source>, width</source>
        <translation>, breedte</translation>
    </message>
    <message>
        <source>Walking robot LEO</source>
        <translation>Looprobot LEO</translation>
    </message>
    <message>
        <source>Beyond the thesis</source>
        <translation>Voorbij de scriptie</translation>
    </message>
    <message>
        <source>Caution: falling less</source>
        <translation>Voorzichtigheid: minder vallen</translation>
    </message>
    <message>
        <source>Chapter 2: reinforcement learning</source>
        <translation>Hoofdstuk 2: reinforcement learning</translation>
    </message>
    <message>
        <source>Chapter 4: thresholds (TRL)</source>
        <translation>Hoofdstuk 4: drempels (TRL)</translation>
    </message>
    <message>
        <source>Chapter 5: Softmax</source>
        <translation>Hoofdstuk 5: Softmax</translation>
    </message>
    <message>
        <source>Chapter 6: resolution, and two Q-functions</source>
        <translation>Hoofdstuk 6: resolutie, en twee Q-functies</translation>
    </message>
    <message>
        <source>Tiles per %1 of the %2: few generalise far, many tell states apart.</source>
        <translation>Tegels per %1 van “%2”: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per %1 of the %2: few let near actions share more.</source>
        <translation>Tegels per %1 van “%2”: bij weinig delen nabije acties meer.</translation>
    </message>
    <message>
        <source>The tiles cover the %1 from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan “%1” van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the %1: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs “%1”: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Centres per %1 of the %2.</source>
        <translation>Middelpunten per %1 van “%2”.</translation>
    </message>
    <message>
        <source>Split of %1</source>
        <translation>Splitsing van %1</translation>
    </message>
    <message>
        <source>thesis</source>
        <translation>scriptie</translation>
    </message>
    <message>
        <source>chapter</source>
        <translation>hoofdstuk</translation>
    </message>
    <message>
        <source>section</source>
        <translation>paragraaf</translation>
    </message>
    <message>
        <source>sections</source>
        <translation>paragrafen</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>figuur</translation>
    </message>
    <message>
        <source>table</source>
        <translation>tabel</translation>
    </message>
    <message>
        <source>example</source>
        <translation>voorbeeld</translation>
    </message>
    <message>
        <source>eq.</source>
        <translation>vgl.</translation>
    </message>
    <message>
        <source>algorithm</source>
        <translation>algoritme</translation>
    </message>
    <message>
        <source>1 Realistic</source>
        <translation>1 Realistisch</translation>
    </message>
    <message>
        <source>10 % more damping, a little friction.</source>
        <translation>10 % meer demping, een beetje wrijving.</translation>
    </message>
    <message>
        <source>2 Half damping, low friction</source>
        <translation>2 Halve demping, lage wrijving</translation>
    </message>
    <message>
        <source>3 Low damping, high friction</source>
        <translation>3 Lage demping, hoge wrijving</translation>
    </message>
    <message>
        <source>4 More power</source>
        <translation>4 Meer vermogen</translation>
    </message>
    <message>
        <source>5 Less power</source>
        <translation>5 Minder vermogen</translation>
    </message>
    <message>
        <source>6 Power + friction</source>
        <translation>6 Vermogen + wrijving</translation>
    </message>
    <message>
        <source>A Softmax whose temperature 1/β fits each state: where actions differ much it is nearly greedy, where they hardly differ nearly even. One ω holds for all states.</source>
        <translation>Een Softmax waarvan de temperatuur 1/β bij elke toestand past: waar acties veel verschillen bijna greedy, waar ze nauwelijks verschillen bijna gelijk verdeeld. Eén ω geldt voor alle toestanden.</translation>
    </message>
    <message>
        <source>A beam that a servo tilts; the ball rolls and must come to rest in the middle. Off the beam is a fall.</source>
        <translation>Een balk die een servo kantelt; de bal rolt en moet in het midden tot rust komen. Van de balk af is een val.</translation>
    </message>
    <message>
        <source>A body on one leg with a spring in it; a servo holds the angle of the leg, a piston presses the spring.</source>
        <translation>Een lichaam op één been met een veer erin; een servo houdt de hoek van het been vast, een zuiger spant de veer.</translation>
    </message>
    <message>
        <source>A car that is too weak for the slope has to swing. It cannot fall.</source>
        <translation>Een auto, te zwak voor de helling, moet heen en weer rijden om vaart te maken. Vallen kan hij niet.</translation>
    </message>
    <message>
        <source>A certain fall costs an action so much of its value.</source>
        <translation>Een zekere val kost een actie zoveel van haar waarde.</translation>
    </message>
    <message>
        <source>A fall costs more and more while the robot falls more often than the budget allows.</source>
        <translation>Een val kost steeds meer zolang de robot vaker valt dan het budget toelaat.</translation>
    </message>
    <message>
        <source>A floor that rises by 2 %: harder.</source>
        <translation>Een vloer die 2 % stijgt: moeilijker.</translation>
    </message>
    <message>
        <source>A grid of 10 × 10 with a bad region in the middle, which is a fall.</source>
        <translation>Een rooster van 10 × 10 met in het midden een slecht gebied, dat als val telt.</translation>
    </message>
    <message>
        <source>A grid of 10 × 10 with a bad region in the middle.</source>
        <translation>Een rooster van 10 × 10 met een slecht gebied in het midden.</translation>
    </message>
    <message>
        <source>A grid of 4 × 12 with a cliff along one side: Q-learning walks the edge, Sarsa the safe path.</source>
        <translation>Een rooster van 4 × 12 met een afgrond langs één zijde: Q-learning loopt langs de rand, Sarsa neemt het veilige pad.</translation>
    </message>
    <message>
        <source>A hull on two legs of two links, after Gymnasium&apos;s BipedalWalker; four motors of three levels.</source>
        <translation>Een romp op twee benen van twee delen, naar BipedalWalker van Gymnasium; vier motoren met drie niveaus.</translation>
    </message>
    <message>
        <source>A life is one learner with one seed; an episode goes from its start to its end, a step from action to action.</source>
        <translation>Een leven is één leerder met één seed; een episode loopt van haar begin tot haar eind, een stap van actie tot actie.</translation>
    </message>
    <message>
        <source>A pair visited again: its trace is set to 1, or 1 is added.</source>
        <translation>Een paar dat opnieuw wordt bezocht: zijn trace wordt op 1 gezet, of er komt 1 bij.</translation>
    </message>
    <message>
        <source>A pole on a cart with a driven wheel. The state is its angle α, its rate α̇ and the wheel&apos;s rate β̇; an action is one of five torques, every 5 ms.</source>
        <translation>Een stok op een karretje met een aangedreven wiel. De toestand bestaat uit zijn hoek α, de hoeksnelheid α̇ en die van het wiel, β̇; een actie is een van vijf koppels, elke 5 ms.</translation>
    </message>
    <message>
        <source>A pole on a driven wheel, DC motor with gears; it should drive on at 0.5 m/s and not fall.</source>
        <translation>Een stok op een aangedreven wiel, gelijkstroommotor met tandwielen; hij moet met 0,5 m/s blijven rijden en niet vallen.</translation>
    </message>
    <message>
        <source>A threshold from the length of an episode: what a pair is worth from which the goal is n* steps away.</source>
        <translation>Een drempel uit de lengte van een episode: wat een paar waard is van waaruit het doel n* stappen ver is.</translation>
    </message>
    <message>
        <source>A trace below this is forgotten.</source>
        <translation>Een trace hieronder wordt vergeten.</translation>
    </message>
    <message>
        <source>About its centre of mass.</source>
        <translation>Om het zwaartepunt.</translation>
    </message>
    <message>
        <source>Acrobot</source>
        <translation>Acrobot</translation>
    </message>
    <message>
        <source>Actions that fall with a higher probability are left out.</source>
        <translation>Acties met een grotere kans op een val doen niet mee.</translation>
    </message>
    <message>
        <source>Actions with decreased power.</source>
        <translation>Acties met minder vermogen.</translation>
    </message>
    <message>
        <source>Actions with increased power.</source>
        <translation>Acties met meer vermogen.</translation>
    </message>
    <message>
        <source>Adds the change of a coarse value function to the reward; it learns from these rewards.</source>
        <translation>Telt de verandering van een grove waardefunctie bij de beloning op; die leert van deze beloningen.</translation>
    </message>
    <message>
        <source>After a fall the world goes back so many steps, and the episode goes on from there; it counts as a rewind and not as a fall. For simulations; 0: a fall ends the episode.</source>
        <translation>Na een val gaat de wereld zoveel stappen terug, en de episode gaat vandaar verder; dat telt als terugdraaien en niet als val. Voor simulaties; 0: een val beëindigt de episode.</translation>
    </message>
    <message>
        <source>Always takes an action that is worth most, so it never explores.</source>
        <translation>Neemt altijd een actie die het meest waard is, en exploreert dus nooit.</translation>
    </message>
    <message>
        <source>Always the best action.</source>
        <translation>Altijd de beste actie.</translation>
    </message>
    <message>
        <source>An episode is cut off after so many steps; no fall.</source>
        <translation>Een episode wordt na zoveel stappen afgebroken; geen val.</translation>
    </message>
    <message>
        <source>An episode is cut off after so many; no fall.</source>
        <translation>Een episode wordt na zoveel afgebroken; geen val.</translation>
    </message>
    <message>
        <source>An episode is cut off after this many steps.</source>
        <translation>Na zoveel stappen wordt een episode afgebroken.</translation>
    </message>
    <message>
        <source>An episode is cut off after this many steps; that is not a fall.</source>
        <translation>Een episode wordt na dit aantal stappen afgebroken; dat is geen val.</translation>
    </message>
    <message>
        <source>An episode starts at rest, anywhere within ± this angle.</source>
        <translation>Een episode begint in rust, ergens binnen ± deze hoek.</translation>
    </message>
    <message>
        <source>An exploring step picks among the actions worth more than this.</source>
        <translation>Een exploratiestap kiest uit de acties die meer waard zijn dan dit.</translation>
    </message>
    <message>
        <source>Angle of the body when an episode begins, at rest.</source>
        <translation>Hoek van het lichaam als een episode begint, in rust.</translation>
    </message>
    <message>
        <source>Angle of the stance leg at the start.</source>
        <translation>Hoek van het standbeen bij de start.</translation>
    </message>
    <message>
        <source>Angle of the swing leg at the start.</source>
        <translation>Hoek van het zwaaibeen bij de start.</translation>
    </message>
    <message>
        <source>Ankle above x</source>
        <translation>Enkel boven x</translation>
    </message>
    <message>
        <source>Ankle above y</source>
        <translation>Enkel boven y</translation>
    </message>
    <message>
        <source>Ankle below x</source>
        <translation>Enkel onder x</translation>
    </message>
    <message>
        <source>Ankle below y</source>
        <translation>Enkel onder y</translation>
    </message>
    <message>
        <source>Ankle damper</source>
        <translation>Enkeldemper</translation>
    </message>
    <message>
        <source>Ankle high</source>
        <translation>Enkel hoog</translation>
    </message>
    <message>
        <source>Ankle low</source>
        <translation>Enkel laag</translation>
    </message>
    <message>
        <source>Ankle stop</source>
        <translation>Enkelaanslag</translation>
    </message>
    <message>
        <source>Ankle stop damping</source>
        <translation>Demping enkelaanslag</translation>
    </message>
    <message>
        <source>Ankle target</source>
        <translation>Enkeldoel</translation>
    </message>
    <message>
        <source>Ankles</source>
        <translation>Enkels</translation>
    </message>
    <message>
        <source>Another motor: 9.5 Ω, and more dry friction.</source>
        <translation>Een andere motor: 9,5 Ω, en meer droge wrijving.</translation>
    </message>
    <message>
        <source>Armature</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>As Softmax, with a temperature that fits each state by itself.</source>
        <translation>Als Softmax, met een temperatuur die vanzelf bij elke toestand past.</translation>
    </message>
    <message>
        <source>Asymmetry</source>
        <translation>Asymmetrie</translation>
    </message>
    <message>
        <source>Asymmetry of errors</source>
        <translation>Asymmetrie van fouten</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Hoogstens</translation>
    </message>
    <message>
        <source>Back after a fall</source>
        <translation>Terug na een val</translation>
    </message>
    <message>
        <source>Balanced angle</source>
        <translation>Evenwichtshoek</translation>
    </message>
    <message>
        <source>Balanced rate</source>
        <translation>Evenwichtssnelheid</translation>
    </message>
    <message>
        <source>Balanced: the angle is at most this, and the rate as well.</source>
        <translation>In evenwicht: de hoek is hoogstens dit, en de snelheid ook klein genoeg.</translation>
    </message>
    <message>
        <source>Balanced: the rate is at most this, and the angle as well.</source>
        <translation>In evenwicht: de snelheid is hoogstens dit, en de hoek ook klein genoeg.</translation>
    </message>
    <message>
        <source>Ball on a beam</source>
        <translation>Bal op een balk</translation>
    </message>
    <message>
        <source>Base mass</source>
        <translation>Karmassa</translation>
    </message>
    <message>
        <source>Biped</source>
        <translation>Tweevoeter</translation>
    </message>
    <message>
        <source>Boom force</source>
        <translation>Giekkracht</translation>
    </message>
    <message>
        <source>Boom point x</source>
        <translation>Giekpunt x</translation>
    </message>
    <message>
        <source>Boom point y</source>
        <translation>Giekpunt y</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Budget</translation>
    </message>
    <message>
        <source>Cart-pole</source>
        <translation>Cart-pole</translation>
    </message>
    <message>
        <source>Caution</source>
        <translation>Voorzichtigheid</translation>
    </message>
    <message>
        <source>Centre of a circle that meets the floor, in its body&apos;s frame.</source>
        <translation>Middelpunt van een cirkel die de vloer raakt, in het assenstelsel van zijn lichaam.</translation>
    </message>
    <message>
        <source>Centre of mass, in the body&apos;s own frame.</source>
        <translation>Zwaartepunt, in het assenstelsel van het lichaam zelf.</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Keten</translation>
    </message>
    <message>
        <source>Cliff</source>
        <translation>Cliff</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Kolom</translation>
    </message>
    <message>
        <source>Compass walker</source>
        <translation>Compass walker</translation>
    </message>
    <message>
        <source>Compass walker (from a file)</source>
        <translation>Compass walker (uit een bestand)</translation>
    </message>
    <message>
        <source>Constants calibrated to the episode lengths that the thesis reports.</source>
        <translation>Constanten afgestemd op de episodelengten die de scriptie meldt.</translation>
    </message>
    <message>
        <source>Constants of the same laboratory&apos;s published simulation.</source>
        <translation>Constanten uit de gepubliceerde simulatie van hetzelfde lab.</translation>
    </message>
    <message>
        <source>Counted in</source>
        <translation>Geteld in</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Demping</translation>
    </message>
    <message>
        <source>Damping of the joint&apos;s stops.</source>
        <translation>Demping van de aanslagen van het gewricht.</translation>
    </message>
    <message>
        <source>Delft lab file</source>
        <translation>Delfts labbestand</translation>
    </message>
    <message>
        <source>Discount</source>
        <translation>Discount</translation>
    </message>
    <message>
        <source>Discount of risk</source>
        <translation>Risicodiscount</translation>
    </message>
    <message>
        <source>Displaced grids of tiles, in a dense or hashed table.</source>
        <translation>Verschoven roosters van tegels, in een dichte tabel of een hashtabel.</translation>
    </message>
    <message>
        <source>Displaced grids that lie over each other; a power of two is best.</source>
        <translation>Verschoven roosters die over elkaar liggen; een macht van twee is het beste.</translation>
    </message>
    <message>
        <source>Distance of a greedy test, last 10</source>
        <translation>Afstand van een greedy test, laatste 10</translation>
    </message>
    <message>
        <source>Distance of a life</source>
        <translation>Afstand van een leven</translation>
    </message>
    <message>
        <source>Doomed beyond this lean of the stance thigh: 0.36π.</source>
        <translation>Verloren voorbij deze helling van het bovenbeen (stand): 0,36π.</translation>
    </message>
    <message>
        <source>Doomed beyond this lean of the torso.</source>
        <translation>Verloren voorbij deze helling van de romp.</translation>
    </message>
    <message>
        <source>Dry friction</source>
        <translation>Droge wrijving</translation>
    </message>
    <message>
        <source>Dry friction on the hinge of the pole.</source>
        <translation>Droge wrijving in het scharnier van de stok.</translation>
    </message>
    <message>
        <source>Each term of the reward goes its own way, or their sum goes by its sign.</source>
        <translation>Elke term van de beloning gaat een eigen weg, of de som ervan gaat op teken.</translation>
    </message>
    <message>
        <source>Efficiency</source>
        <translation>Rendement</translation>
    </message>
    <message>
        <source>End of learning</source>
        <translation>Einde van het leren</translation>
    </message>
    <message>
        <source>End value</source>
        <translation>Eindwaarde</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Energy of a greedy test, last 10</source>
        <translation>Energie van een greedy test, laatste 10</translation>
    </message>
    <message>
        <source>Energy of a life</source>
        <translation>Energie van een leven</translation>
    </message>
    <message>
        <source>Episodes between two tests of the greedy policy, which are not counted; 0: none.</source>
        <translation>Episodes tussen twee tests van de greedy policy, die niet meetellen; 0: geen.</translation>
    </message>
    <message>
        <source>Errors below 0 count 1 + κ times, those above 1 − κ times: with κ &gt; 0 it is risk-averse.</source>
        <translation>Fouten onder 0 tellen 1 + κ keer, die erboven 1 − κ keer: met κ &gt; 0 is hij risicomijdend.</translation>
    </message>
    <message>
        <source>Expected Sarsa</source>
        <translation>Expected Sarsa</translation>
    </message>
    <message>
        <source>Expected Sarsa(λ): the mean over the policy in place of one draw.</source>
        <translation>Expected Sarsa(λ): het gemiddelde over de policy in plaats van één trekking.</translation>
    </message>
    <message>
        <source>Expected losses count so many times.</source>
        <translation>Verwacht verlies telt zoveel keer.</translation>
    </message>
    <message>
        <source>Exploration</source>
        <translation>Exploratie</translation>
    </message>
    <message>
        <source>Exploration, clock</source>
        <translation>Exploratie, klok</translation>
    </message>
    <message>
        <source>Exploration, end</source>
        <translation>Exploratie, eind</translation>
    </message>
    <message>
        <source>Exploration, schedule</source>
        <translation>Exploratie, verloop</translation>
    </message>
    <message>
        <source>Exploration, time</source>
        <translation>Exploratie, duur</translation>
    </message>
    <message>
        <source>Factor of losses</source>
        <translation>Verliesfactor</translation>
    </message>
    <message>
        <source>Factor of losses, clock</source>
        <translation>Verliesfactor, klok</translation>
    </message>
    <message>
        <source>Factor of losses, end</source>
        <translation>Verliesfactor, eind</translation>
    </message>
    <message>
        <source>Factor of losses, schedule</source>
        <translation>Verliesfactor, verloop</translation>
    </message>
    <message>
        <source>Factor of losses, time</source>
        <translation>Verliesfactor, duur</translation>
    </message>
    <message>
        <source>Fall</source>
        <translation>Val</translation>
    </message>
    <message>
        <source>Fall angle</source>
        <translation>Valhoek</translation>
    </message>
    <message>
        <source>Fall, stance leg</source>
        <translation>Val, standbeen</translation>
    </message>
    <message>
        <source>Fall, stance thigh</source>
        <translation>Val, bovenbeen (stand)</translation>
    </message>
    <message>
        <source>Fall, swing leg</source>
        <translation>Val, zwaaibeen</translation>
    </message>
    <message>
        <source>Fall, thigh</source>
        <translation>Val, bovenbeen</translation>
    </message>
    <message>
        <source>Fall, torso</source>
        <translation>Val, romp</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Valpartijen</translation>
    </message>
    <message>
        <source>Falls an episode</source>
        <translation>Vallen per episode</translation>
    </message>
    <message>
        <source>Falls an hour</source>
        <translation>Valpartijen per uur</translation>
    </message>
    <message>
        <source>Falls budget</source>
        <translation>Valbudget</translation>
    </message>
    <message>
        <source>Falls of a greedy test, last 10</source>
        <translation>Valpartijen van een greedy test, laatste 10</translation>
    </message>
    <message>
        <source>Falls taken back in an episode, at most</source>
        <translation>Teruggedraaid per episode, hoogstens</translation>
    </message>
    <message>
        <source>Foot centre x</source>
        <translation>Zwaartepunt voet x</translation>
    </message>
    <message>
        <source>Foot centre y</source>
        <translation>Zwaartepunt voet y</translation>
    </message>
    <message>
        <source>Foot inertia</source>
        <translation>Voettraagheid</translation>
    </message>
    <message>
        <source>Foot mass</source>
        <translation>Voetmassa</translation>
    </message>
    <message>
        <source>Foot radius</source>
        <translation>Voetstraal</translation>
    </message>
    <message>
        <source>Footstep</source>
        <translation>Voetstap</translation>
    </message>
    <message>
        <source>For worlds of few states: nothing is shared, nothing is generalised.</source>
        <translation>Voor werelden met weinig toestanden: niets wordt gedeeld, niets gegeneraliseerd.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Wrijving</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Van</translation>
    </message>
    <message>
        <source>From column</source>
        <translation>Vanaf kolom</translation>
    </message>
    <message>
        <source>From row</source>
        <translation>Vanaf rij</translation>
    </message>
    <message>
        <source>From state</source>
        <translation>Vanaf toestand</translation>
    </message>
    <message>
        <source>From the hip to the sole.</source>
        <translation>Van de heup tot de zool.</translation>
    </message>
    <message>
        <source>Gaussians on a grid, width and spacing set apart.</source>
        <translation>Gaussfuncties op een rooster, breedte en afstand apart in te stellen.</translation>
    </message>
    <message>
        <source>Gaussians on a grid. Their width can be set apart from their spacing, which tiles cannot do.</source>
        <translation>Gaussfuncties op een rooster. Hun breedte is los van hun afstand in te stellen, wat met tegels niet kan.</translation>
    </message>
    <message>
        <source>Gear ratio</source>
        <translation>Overbrenging</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Doel</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Zwaartekracht</translation>
    </message>
    <message>
        <source>Greedy</source>
        <translation>Greedy</translation>
    </message>
    <message>
        <source>Greedy test</source>
        <translation>Greedy test</translation>
    </message>
    <message>
        <source>Greedy test every</source>
        <translation>Greedy test elke</translation>
    </message>
    <message>
        <source>Grid world</source>
        <translation>Gridworld</translation>
    </message>
    <message>
        <source>Grip</source>
        <translation>Grip</translation>
    </message>
    <message>
        <source>Guardian</source>
        <translation>Bewaker</translation>
    </message>
    <message>
        <source>Guardian from</source>
        <translation>Bewaker vanaf</translation>
    </message>
    <message>
        <source>Gymnasium&apos;s CartPole-v1: a pole on a cart that is pushed left or right.</source>
        <translation>CartPole-v1 van Gymnasium: een stok op een karretje dat naar links of rechts wordt geduwd.</translation>
    </message>
    <message>
        <source>Half of it sits on each leg, at the hip.</source>
        <translation>De helft ervan zit op elk been, bij de heup.</translation>
    </message>
    <message>
        <source>Half the damping, low friction.</source>
        <translation>De helft van de demping, lage wrijving.</translation>
    </message>
    <message>
        <source>Hand-made</source>
        <translation>Vaste regelaar</translation>
    </message>
    <message>
        <source>Hashed tiles</source>
        <translation>Gehashte tegels</translation>
    </message>
    <message>
        <source>Heel radius</source>
        <translation>Hielstraal</translation>
    </message>
    <message>
        <source>Heel x</source>
        <translation>Hiel x</translation>
    </message>
    <message>
        <source>Heel y</source>
        <translation>Hiel y</translation>
    </message>
    <message>
        <source>High: nearly equal chances. Low: nearly greedy.</source>
        <translation>Hoog: bijna gelijke kansen. Laag: bijna greedy.</translation>
    </message>
    <message>
        <source>Highest value of a pair before anything is learned.</source>
        <translation>Hoogste waarde van een paar voordat er iets is geleerd.</translation>
    </message>
    <message>
        <source>Hip above x</source>
        <translation>Heup boven x</translation>
    </message>
    <message>
        <source>Hip above y</source>
        <translation>Heup boven y</translation>
    </message>
    <message>
        <source>Hip below x</source>
        <translation>Heup onder x</translation>
    </message>
    <message>
        <source>Hip below y</source>
        <translation>Heup onder y</translation>
    </message>
    <message>
        <source>Hip damper</source>
        <translation>Heupdemper</translation>
    </message>
    <message>
        <source>Hip high</source>
        <translation>Heup hoog</translation>
    </message>
    <message>
        <source>Hip low</source>
        <translation>Heup laag</translation>
    </message>
    <message>
        <source>Hip mass</source>
        <translation>Heupmassa</translation>
    </message>
    <message>
        <source>Hip stop</source>
        <translation>Heupaanslag</translation>
    </message>
    <message>
        <source>Hip stop damping</source>
        <translation>Demping heupaanslag</translation>
    </message>
    <message>
        <source>Hip target</source>
        <translation>Heupdoel</translation>
    </message>
    <message>
        <source>Hopper</source>
        <translation>Hopper</translation>
    </message>
    <message>
        <source>How a walker walks with what it has learned so far.</source>
        <translation>Hoe een loper loopt met wat hij tot nu toe geleerd heeft.</translation>
    </message>
    <message>
        <source>How far back along the way a surprise is felt; 0: one step.</source>
        <translation>Hoe ver terug langs de weg een verrassing voelbaar is; 0: één stap.</translation>
    </message>
    <message>
        <source>How far the simulation is from the actual system: the rows of the thesis&apos;s table.</source>
        <translation>Hoe ver de simulatie van het echte systeem af ligt: de rijen van de tabel in de scriptie.</translation>
    </message>
    <message>
        <source>How it changes while the life goes on: not at all, in a straight line, by halves, or as the rule of thumb says.</source>
        <translation>Hoe het verandert terwijl het leven doorgaat: helemaal niet, in een rechte lijn, door te halveren, of zoals de vuistregel zegt.</translation>
    </message>
    <message>
        <source>How it changes while the life goes on: not at all, in a straight line, or by halves.</source>
        <translation>Hoe het verandert terwijl het leven doorgaat: helemaal niet, in een rechte lijn, of door te halveren.</translation>
    </message>
    <message>
        <source>How long a linear schedule takes to its end; the half-life of an exponential one.</source>
        <translation>Hoelang een lineair verloop tot zijn eind duurt; de halfwaardetijd van een exponentieel verloop.</translation>
    </message>
    <message>
        <source>How many steps the learner takes to the goal. The rule of thumb is made from it.</source>
        <translation>Hoeveel stappen de leerder tot het doel nodig heeft. De vuistregel volgt daaruit.</translation>
    </message>
    <message>
        <source>How much more a fall costs after an episode with one fall too many.</source>
        <translation>Hoeveel meer een val kost na een episode met één val te veel.</translation>
    </message>
    <message>
        <source>How well it does by now. 198 of 200 counts as converged.</source>
        <translation>Hoe goed het inmiddels gaat. 198 van 200 geldt als geconvergeerd.</translation>
    </message>
    <message>
        <source>Increased power with the realistic errors of 1.</source>
        <translation>Meer vermogen, met de realistische fouten van 1.</translation>
    </message>
    <message>
        <source>Inertia of a rotor as the joint feels it.</source>
        <translation>Traagheid van een rotor zoals het gewricht die voelt.</translation>
    </message>
    <message>
        <source>Initial Q</source>
        <translation>Begin-Q</translation>
    </message>
    <message>
        <source>Initial Q, low</source>
        <translation>Begin-Q, laag</translation>
    </message>
    <message>
        <source>Initial risk</source>
        <translation>Beginrisico</translation>
    </message>
    <message>
        <source>It has fallen beyond this angle of the stance leg.</source>
        <translation>Voorbij deze hoek van het standbeen is hij gevallen.</translation>
    </message>
    <message>
        <source>It has fallen beyond this angle of the swing leg.</source>
        <translation>Voorbij deze hoek van het zwaaibeen is hij gevallen.</translation>
    </message>
    <message>
        <source>Knee above x</source>
        <translation>Knie boven x</translation>
    </message>
    <message>
        <source>Knee above y</source>
        <translation>Knie boven y</translation>
    </message>
    <message>
        <source>Knee below x</source>
        <translation>Knie onder x</translation>
    </message>
    <message>
        <source>Knee below y</source>
        <translation>Knie onder y</translation>
    </message>
    <message>
        <source>Knee cap radius</source>
        <translation>Straal knieschijf</translation>
    </message>
    <message>
        <source>Knee cap x</source>
        <translation>Knieschijf x</translation>
    </message>
    <message>
        <source>Knee cap y</source>
        <translation>Knieschijf y</translation>
    </message>
    <message>
        <source>Knee damper</source>
        <translation>Kniedemper</translation>
    </message>
    <message>
        <source>Knee high</source>
        <translation>Knie hoog</translation>
    </message>
    <message>
        <source>Knee low</source>
        <translation>Knie laag</translation>
    </message>
    <message>
        <source>Knee stop</source>
        <translation>Knieaanslag</translation>
    </message>
    <message>
        <source>Knee stop damping</source>
        <translation>Demping knieaanslag</translation>
    </message>
    <message>
        <source>LEO</source>
        <translation>LEO</translation>
    </message>
    <message>
        <source>LEO (from a file)</source>
        <translation>LEO (uit een bestand)</translation>
    </message>
    <message>
        <source>LEO walker</source>
        <translation>Looprobot LEO</translation>
    </message>
    <message>
        <source>Learns flat out; the world shows another one at its usual pace, with the newest values.</source>
        <translation>Leert op volle snelheid; de wereld toont een andere in het gewone tempo, met de nieuwste waarden.</translation>
    </message>
    <message>
        <source>Learns how likely an action ends in a fall, beside its value.</source>
        <translation>Leert naast de waarde ook hoe waarschijnlijk een actie in een val eindigt.</translation>
    </message>
    <message>
        <source>Learns the value of the greedy policy, whatever is done meanwhile (Watkins). So at a cliff it learns the edge, and falls while it explores.</source>
        <translation>Leert de waarde van de greedy policy, wat er intussen ook wordt gedaan (Watkins). Bij een afgrond leert hij dus de rand, en valt hij zolang hij exploreert.</translation>
    </message>
    <message>
        <source>Learns the value of what it does, exploring included: a′ is the action that is taken next.</source>
        <translation>Leert de waarde van wat hij doet, exploreren inbegrepen: a′ is de actie die daarna wordt genomen.</translation>
    </message>
    <message>
        <source>Learns to walk within a few simulated minutes.</source>
        <translation>Leert binnen enkele gesimuleerde minuten lopen.</translation>
    </message>
    <message>
        <source>Leg inertia</source>
        <translation>Beentraagheid</translation>
    </message>
    <message>
        <source>Leg length</source>
        <translation>Beenlengte</translation>
    </message>
    <message>
        <source>Leg mass</source>
        <translation>Beenmassa</translation>
    </message>
    <message>
        <source>Length of the pole.</source>
        <translation>Lengte van de stok.</translation>
    </message>
    <message>
        <source>Level floor</source>
        <translation>Vlakke vloer</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Niveaus</translation>
    </message>
    <message>
        <source>Limit of risk</source>
        <translation>Risicogrens</translation>
    </message>
    <message>
        <source>Limit of risk, clock</source>
        <translation>Risicogrens, klok</translation>
    </message>
    <message>
        <source>Limit of risk, end</source>
        <translation>Risicogrens, eind</translation>
    </message>
    <message>
        <source>Limit of risk, schedule</source>
        <translation>Risicogrens, verloop</translation>
    </message>
    <message>
        <source>Limit of risk, time</source>
        <translation>Risicogrens, duur</translation>
    </message>
    <message>
        <source>Limit of the guardian</source>
        <translation>Grens van de bewaker</translation>
    </message>
    <message>
        <source>Linear damping of the wheel motors, per rad.</source>
        <translation>Lineaire demping van de wielmotoren, per rad.</translation>
    </message>
    <message>
        <source>Low damping, high friction.</source>
        <translation>Lage demping, hoge wrijving.</translation>
    </message>
    <message>
        <source>Low: nearly equal chances. High: nearly greedy.</source>
        <translation>Laag: bijna gelijke kansen. Hoog: bijna greedy.</translation>
    </message>
    <message>
        <source>Lowest value of a pair before anything is learned.</source>
        <translation>Laagste waarde van een paar voordat er iets is geleerd.</translation>
    </message>
    <message>
        <source>Mass of the cart without its wheel.</source>
        <translation>Massa van het karretje zonder het wiel.</translation>
    </message>
    <message>
        <source>Mass of the driven wheel, a solid cylinder.</source>
        <translation>Massa van het aangedreven wiel, een massieve cilinder.</translation>
    </message>
    <message>
        <source>Mass of the pole, a uniform rod.</source>
        <translation>Massa van de stok, een homogene staaf.</translation>
    </message>
    <message>
        <source>Mellowmax</source>
        <translation>Mellowmax</translation>
    </message>
    <message>
        <source>Mellowness</source>
        <translation>Mildheid</translation>
    </message>
    <message>
        <source>Mellowness, clock</source>
        <translation>Mildheid, klok</translation>
    </message>
    <message>
        <source>Mellowness, end</source>
        <translation>Mildheid, eind</translation>
    </message>
    <message>
        <source>Mellowness, schedule</source>
        <translation>Mildheid, verloop</translation>
    </message>
    <message>
        <source>Mellowness, time</source>
        <translation>Mildheid, duur</translation>
    </message>
    <message>
        <source>Mismatched LEO</source>
        <translation>Afwijkende LEO</translation>
    </message>
    <message>
        <source>Mostly greedy; in a share ε of the steps it takes any of the n actions with equal chance. So it also takes those that make the robot fall.</source>
        <translation>Meestal greedy; in een aandeel ε van de stappen neemt hij een van de n acties, elk met gelijke kans. Dus ook die waardoor de robot valt.</translation>
    </message>
    <message>
        <source>Mountain car</source>
        <translation>Mountain car</translation>
    </message>
    <message>
        <source>Multiplies every resolution: the fraction of Q_opt in chapter 6.</source>
        <translation>Vermenigvuldigt elke resolutie: de fractie van Q_opt in hoofdstuk 6.</translation>
    </message>
    <message>
        <source>Multiplies every width and leaves the centres where they are.</source>
        <translation>Vermenigvuldigt elke breedte en laat de middelpunten op hun plaats.</translation>
    </message>
    <message>
        <source>Multiplies the torque of every action.</source>
        <translation>Vermenigvuldigt het koppel van elke actie.</translation>
    </message>
    <message>
        <source>Net footsteps of a greedy test, last 10</source>
        <translation>Netto voetstappen van een greedy test, laatste 10</translation>
    </message>
    <message>
        <source>Net footsteps of a life</source>
        <translation>Netto voetstappen van een leven</translation>
    </message>
    <message>
        <source>Nineteen states in a row and one action: only values are learned, and they are known.</source>
        <translation>Negentien toestanden op een rij en één actie: alleen waarden worden geleerd, en die zijn bekend.</translation>
    </message>
    <message>
        <source>Of a circle that meets the floor.</source>
        <translation>Van een cirkel die de vloer raakt.</translation>
    </message>
    <message>
        <source>Of a motor&apos;s windings.</source>
        <translation>Van de wikkelingen van een motor.</translation>
    </message>
    <message>
        <source>Of a motor.</source>
        <translation>Van een motor.</translation>
    </message>
    <message>
        <source>Of each voltage; actions are their combinations.</source>
        <translation>Van elke spanning; acties zijn combinaties ervan.</translation>
    </message>
    <message>
        <source>Of every joint.</source>
        <translation>Van elk gewricht.</translation>
    </message>
    <message>
        <source>Of feet and floor.</source>
        <translation>Van voeten en vloer.</translation>
    </message>
    <message>
        <source>Of one leg about its centre.</source>
        <translation>Van één been, om zijn zwaartepunt.</translation>
    </message>
    <message>
        <source>Of one leg, its centre in the middle.</source>
        <translation>Van één been, met het zwaartepunt in het midden.</translation>
    </message>
    <message>
        <source>Of one such body; the torso&apos;s with boom and arm.</source>
        <translation>Van één zo’n lichaam; die van de romp met giek en arm.</translation>
    </message>
    <message>
        <source>Of the floor: below 0 it goes uphill.</source>
        <translation>Van de vloer: onder 0 gaat het bergop.</translation>
    </message>
    <message>
        <source>Of the gears.</source>
        <translation>Van de tandwielen.</translation>
    </message>
    <message>
        <source>Of the hip; the actions are −, 0 and + this.</source>
        <translation>Van de heup; de acties zijn −, 0 en + dit.</translation>
    </message>
    <message>
        <source>On the Earth 9.81.</source>
        <translation>Op aarde 9,81.</translation>
    </message>
    <message>
        <source>One value a state, for states of whole numbers.</source>
        <translation>Eén waarde per toestand, voor toestanden van gehele getallen.</translation>
    </message>
    <message>
        <source>Other actions</source>
        <translation>Andere acties</translation>
    </message>
    <message>
        <source>Over</source>
        <translation>Over</translation>
    </message>
    <message>
        <source>Pendulum</source>
        <translation>Slinger</translation>
    </message>
    <message>
        <source>Pendulum (from a file)</source>
        <translation>Slinger (uit een bestand)</translation>
    </message>
    <message>
        <source>Pendulum, actual system</source>
        <translation>Slinger, echte systeem</translation>
    </message>
    <message>
        <source>Pole angle</source>
        <translation>Stokhoek</translation>
    </message>
    <message>
        <source>Pole length</source>
        <translation>Stoklengte</translation>
    </message>
    <message>
        <source>Pole mass</source>
        <translation>Stokmassa</translation>
    </message>
    <message>
        <source>Pole rate</source>
        <translation>Stoksnelheid</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Positie</translation>
    </message>
    <message>
        <source>Pre-learning</source>
        <translation>Vooraf leren</translation>
    </message>
    <message>
        <source>Q(s, a), action value</source>
        <translation>Q(s, a), actiewaarde</translation>
    </message>
    <message>
        <source>Q-learning</source>
        <translation>Q-learning</translation>
    </message>
    <message>
        <source>Q-learning, Q(λ)</source>
        <translation>Q-learning, Q(λ)</translation>
    </message>
    <message>
        <source>Radial basis</source>
        <translation>Radiale basis</translation>
    </message>
    <message>
        <source>Radial basis functions</source>
        <translation>Radiale basisfuncties</translation>
    </message>
    <message>
        <source>Radius of the driven wheel.</source>
        <translation>Straal van het aangedreven wiel.</translation>
    </message>
    <message>
        <source>Random walk</source>
        <translation>Random walk</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Snelheid</translation>
    </message>
    <message>
        <source>Rate of the budget</source>
        <translation>Snelheid van het budget</translation>
    </message>
    <message>
        <source>Rate of the stance leg at the start.</source>
        <translation>Hoeksnelheid van het standbeen bij de start.</translation>
    </message>
    <message>
        <source>Resistance</source>
        <translation>Weerstand</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolutie</translation>
    </message>
    <message>
        <source>Reward for balancing the pole.</source>
        <translation>Beloning voor het balanceren van de stok.</translation>
    </message>
    <message>
        <source>Reward for being doomed to fall.</source>
        <translation>Beloning als een val niet meer te voorkomen is.</translation>
    </message>
    <message>
        <source>Reward for falling.</source>
        <translation>Beloning voor vallen.</translation>
    </message>
    <message>
        <source>Reward for letting the pole fall.</source>
        <translation>Beloning als de stok valt.</translation>
    </message>
    <message>
        <source>Reward of a footstep, a metre of its length.</source>
        <translation>Beloning voor een voetstap, per meter lengte.</translation>
    </message>
    <message>
        <source>Reward of a greedy test, last 10</source>
        <translation>Beloning van een greedy test, laatste 10</translation>
    </message>
    <message>
        <source>Reward of a joule that hips and knees take.</source>
        <translation>Beloning per joule die heupen en knieën verbruiken.</translation>
    </message>
    <message>
        <source>Reward of a metre by which the ankles part.</source>
        <translation>Beloning per meter waarmee de enkels uiteengaan.</translation>
    </message>
    <message>
        <source>Reward of every step.</source>
        <translation>Beloning van elke stap.</translation>
    </message>
    <message>
        <source>Reward of every step; 0 or below.</source>
        <translation>Beloning van elke stap; 0 of lager.</translation>
    </message>
    <message>
        <source>Reward shaping</source>
        <translation>Reward shaping</translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risico</translation>
    </message>
    <message>
        <source>Risk of a fall</source>
        <translation>Valrisico</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>Rij</translation>
    </message>
    <message>
        <source>Rule of thumb</source>
        <translation>Vuistregel</translation>
    </message>
    <message>
        <source>Sarsa</source>
        <translation>Sarsa</translation>
    </message>
    <message>
        <source>Sarsa with the mean over the policy in place of the one action that is drawn: the same values with less chance in them.</source>
        <translation>Sarsa met het gemiddelde over de policy in plaats van de ene actie die wordt getrokken: dezelfde waarden, met minder toeval erin.</translation>
    </message>
    <message>
        <source>Sarsa(λ) that equals its forward view, but for the cut-off of its traces.</source>
        <translation>Sarsa(λ) die gelijk is aan zijn forward view, op het afkappen van de traces na.</translation>
    </message>
    <message>
        <source>Sarsa(λ) with dutch traces and a correction, so that after every step the weights are those of the forward view, which looks ahead at the returns.</source>
        <translation>Sarsa(λ) met dutch traces en een correctie, zodat de gewichten na elke stap die van de forward view zijn, die vooruitkijkt naar de returns.</translation>
    </message>
    <message>
        <source>Sarsa(λ) with expected gains and losses in two Q-functions.</source>
        <translation>Sarsa(λ) met verwachte winst en verwacht verlies in twee Q-functies.</translation>
    </message>
    <message>
        <source>Sarsa(λ), the on-policy rule of the thesis.</source>
        <translation>Sarsa(λ), de on-policy regel van de scriptie.</translation>
    </message>
    <message>
        <source>Sarsa_2Q</source>
        <translation>Sarsa_2Q</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Schaal</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Scenario</translation>
    </message>
    <message>
        <source>Schedule</source>
        <translation>Verloop</translation>
    </message>
    <message>
        <source>Seat radius</source>
        <translation>Straal zitvlak</translation>
    </message>
    <message>
        <source>Seat x</source>
        <translation>Zitvlak x</translation>
    </message>
    <message>
        <source>Seat y</source>
        <translation>Zitvlak y</translation>
    </message>
    <message>
        <source>Segway on bumpy ground</source>
        <translation>Segway op hobbelige grond</translation>
    </message>
    <message>
        <source>Shank centre x</source>
        <translation>Zwaartepunt onderbeen x</translation>
    </message>
    <message>
        <source>Shank centre y</source>
        <translation>Zwaartepunt onderbeen y</translation>
    </message>
    <message>
        <source>Shank inertia</source>
        <translation>Onderbeentraagheid</translation>
    </message>
    <message>
        <source>Shank mass</source>
        <translation>Onderbeenmassa</translation>
    </message>
    <message>
        <source>Shaping</source>
        <translation>Shaping</translation>
    </message>
    <message>
        <source>Shaping discount</source>
        <translation>Discount shaping</translation>
    </message>
    <message>
        <source>Shaping step size</source>
        <translation>Stapgrootte shaping</translation>
    </message>
    <message>
        <source>Share below</source>
        <translation>Aandeel eronder</translation>
    </message>
    <message>
        <source>Share by which start angles and rates vary; in rad/s that of the swing leg.</source>
        <translation>Aandeel waarmee starthoeken en -snelheden variëren; in rad/s die van het zwaaibeen.</translation>
    </message>
    <message>
        <source>Share of the error that one update closes, over all tilings together.</source>
        <translation>Aandeel van de fout dat één update wegwerkt, over alle betegelingen samen.</translation>
    </message>
    <message>
        <source>Share of the exploring steps that pick an action below the threshold all the same.</source>
        <translation>Aandeel van de exploratiestappen dat toch een actie onder de drempel kiest.</translation>
    </message>
    <message>
        <source>Share of the steps that explore instead of taking the best action.</source>
        <translation>Aandeel van de stappen dat exploreert in plaats van de beste actie te nemen.</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Helling</translation>
    </message>
    <message>
        <source>So many falls an episode are allowed; with more a fall costs more.</source>
        <translation>Zoveel valpartijen per episode zijn toegestaan; bij meer kost een val meer.</translation>
    </message>
    <message>
        <source>So many times an episode goes on after a fall; the fall after that ends it.</source>
        <translation>Zo vaak gaat een episode na een val verder; de val daarna beëindigt haar.</translation>
    </message>
    <message>
        <source>Softmax</source>
        <translation>Softmax</translation>
    </message>
    <message>
        <source>Solid from</source>
        <translation>Contact vanaf</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Splitsing</translation>
    </message>
    <message>
        <source>Split of energy</source>
        <translation>Splitsing van energie</translation>
    </message>
    <message>
        <source>Split of fall</source>
        <translation>Splitsing van val</translation>
    </message>
    <message>
        <source>Split of footstep</source>
        <translation>Splitsing van voetstap</translation>
    </message>
    <message>
        <source>Split of goal</source>
        <translation>Splitsing van doel</translation>
    </message>
    <message>
        <source>Split of left</source>
        <translation>Splitsing van links</translation>
    </message>
    <message>
        <source>Split of price_of_fall</source>
        <translation>Splitsing van price_of_fall</translation>
    </message>
    <message>
        <source>Split of right</source>
        <translation>Splitsing van rechts</translation>
    </message>
    <message>
        <source>Split of shaping</source>
        <translation>Splitsing van shaping</translation>
    </message>
    <message>
        <source>Split of time</source>
        <translation>Splitsing van tijd</translation>
    </message>
    <message>
        <source>Stance angle</source>
        <translation>Hoek standbeen</translation>
    </message>
    <message>
        <source>Stance hip</source>
        <translation>Heup (stand)</translation>
    </message>
    <message>
        <source>Stance hip rate</source>
        <translation>Heupsnelheid (stand)</translation>
    </message>
    <message>
        <source>Stance hip voltage</source>
        <translation>Heupspanning (stand)</translation>
    </message>
    <message>
        <source>Stance knee</source>
        <translation>Knie (stand)</translation>
    </message>
    <message>
        <source>Stance knee rate</source>
        <translation>Kniesnelheid (stand)</translation>
    </message>
    <message>
        <source>Stance rate</source>
        <translation>Snelheid standbeen</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Starthoek</translation>
    </message>
    <message>
        <source>Start noise</source>
        <translation>Startruis</translation>
    </message>
    <message>
        <source>Start rate</source>
        <translation>Startsnelheid</translation>
    </message>
    <message>
        <source>Start stance</source>
        <translation>Start standbeen</translation>
    </message>
    <message>
        <source>Start swing</source>
        <translation>Start zwaaibeen</translation>
    </message>
    <message>
        <source>Start, stance foot</source>
        <translation>Start, voet (stand)</translation>
    </message>
    <message>
        <source>Start, stance shank</source>
        <translation>Start, onderbeen (stand)</translation>
    </message>
    <message>
        <source>Start, stance thigh</source>
        <translation>Start, bovenbeen (stand)</translation>
    </message>
    <message>
        <source>Start, swing foot</source>
        <translation>Start, voet (zwaai)</translation>
    </message>
    <message>
        <source>Start, swing shank</source>
        <translation>Start, onderbeen (zwaai)</translation>
    </message>
    <message>
        <source>Start, swing thigh</source>
        <translation>Start, bovenbeen (zwaai)</translation>
    </message>
    <message>
        <source>Start, torso</source>
        <translation>Start, romp</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Toestand</translation>
    </message>
    <message>
        <source>Step limit</source>
        <translation>Stappenlimiet</translation>
    </message>
    <message>
        <source>Step size</source>
        <translation>Stapgrootte</translation>
    </message>
    <message>
        <source>Step size, clock</source>
        <translation>Stapgrootte, klok</translation>
    </message>
    <message>
        <source>Step size, end</source>
        <translation>Stapgrootte, eind</translation>
    </message>
    <message>
        <source>Step size, schedule</source>
        <translation>Stapgrootte, verloop</translation>
    </message>
    <message>
        <source>Step size, time</source>
        <translation>Stapgrootte, duur</translation>
    </message>
    <message>
        <source>Step, episode, life, experiment</source>
        <translation>Stap, episode, leven, experiment</translation>
    </message>
    <message>
        <source>Steps back after a fall</source>
        <translation>Stappen terug na een val</translation>
    </message>
    <message>
        <source>Steps of the simulation in one transition.</source>
        <translation>Stappen van de simulatie in één overgang.</translation>
    </message>
    <message>
        <source>Stiffness of the joint&apos;s stops.</source>
        <translation>Stijfheid van de aanslagen van het gewricht.</translation>
    </message>
    <message>
        <source>Substeps</source>
        <translation>Deelstappen</translation>
    </message>
    <message>
        <source>Sutton &amp; Barto&apos;s 19 states with one action: values only.</source>
        <translation>De 19 toestanden van Sutton &amp; Barto met één actie: alleen waarden.</translation>
    </message>
    <message>
        <source>Sutton &amp; Barto&apos;s car that is too weak for the slope.</source>
        <translation>De auto van Sutton &amp; Barto die te zwak is voor de helling.</translation>
    </message>
    <message>
        <source>Sutton &amp; Barto&apos;s cliff walking, a grid of 4 × 12.</source>
        <translation>Cliff walking van Sutton &amp; Barto, een rooster van 4 × 12.</translation>
    </message>
    <message>
        <source>Swing angle</source>
        <translation>Hoek zwaaibeen</translation>
    </message>
    <message>
        <source>Swing hip</source>
        <translation>Heup (zwaai)</translation>
    </message>
    <message>
        <source>Swing hip rate</source>
        <translation>Heupsnelheid (zwaai)</translation>
    </message>
    <message>
        <source>Swing hip voltage</source>
        <translation>Heupspanning (zwaai)</translation>
    </message>
    <message>
        <source>Swing knee</source>
        <translation>Knie (zwaai)</translation>
    </message>
    <message>
        <source>Swing knee rate</source>
        <translation>Kniesnelheid (zwaai)</translation>
    </message>
    <message>
        <source>Swing knee voltage</source>
        <translation>Kniespanning (zwaai)</translation>
    </message>
    <message>
        <source>Swing rate</source>
        <translation>Snelheid zwaaibeen</translation>
    </message>
    <message>
        <source>TD error</source>
        <translation>TD-fout</translation>
    </message>
    <message>
        <source>TRL</source>
        <translation>TRL</translation>
    </message>
    <message>
        <source>TRL&apos;s limit: what is worth no more than this is hardly ever tried.</source>
        <translation>De grens van TRL: wat niet meer waard is dan dit, wordt bijna nooit geprobeerd.</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabel</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatuur</translation>
    </message>
    <message>
        <source>Temperature, clock</source>
        <translation>Temperatuur, klok</translation>
    </message>
    <message>
        <source>Temperature, end</source>
        <translation>Temperatuur, eind</translation>
    </message>
    <message>
        <source>Temperature, schedule</source>
        <translation>Temperatuur, verloop</translation>
    </message>
    <message>
        <source>Temperature, time</source>
        <translation>Temperatuur, duur</translation>
    </message>
    <message>
        <source>Ten states in a row between a fall and the goal.</source>
        <translation>Tien toestanden op een rij tussen een val en het doel.</translation>
    </message>
    <message>
        <source>Ten states in a row, a fall at one end and the goal at the other.</source>
        <translation>Tien toestanden op een rij, met aan het ene eind een val en aan het andere het doel.</translation>
    </message>
    <message>
        <source>The Delft robot on two legs, in Box2D.</source>
        <translation>De Delftse robot op twee benen, in Box2D.</translation>
    </message>
    <message>
        <source>The Delft robot on two legs, on the task of wcaarls/grl (addons/leosim), as a robot file.</source>
        <translation>De Delftse robot op twee benen, met de taak van wcaarls/grl (addons/leosim), als robotbestand.</translation>
    </message>
    <message>
        <source>The Delft robot on two legs: ten state variables, motors with gears, feet with heel and toe. It is paid for metres, and pays for energy, time and falls.</source>
        <translation>De Delftse robot op twee benen: tien toestandsvariabelen, motoren met tandwielen, voeten met hiel en teen. Hij wordt betaald voor meters en betaalt voor energie, tijd en valpartijen.</translation>
    </message>
    <message>
        <source>The angle between the hips that the hand-made controller aims at.</source>
        <translation>De hoek tussen de heupen waar de vaste regelaar op mikt.</translation>
    </message>
    <message>
        <source>The angle that the ankles hold.</source>
        <translation>De hoek die de enkels vasthouden.</translation>
    </message>
    <message>
        <source>The best action, but any with probability ε.</source>
        <translation>De beste actie, maar met kans ε een willekeurige.</translation>
    </message>
    <message>
        <source>The better an action, the likelier, by a temperature.</source>
        <translation>Hoe beter een actie, hoe waarschijnlijker, volgens een temperatuur.</translation>
    </message>
    <message>
        <source>The chance of every action in a state.</source>
        <translation>De kans op elke actie in een toestand.</translation>
    </message>
    <message>
        <source>The difference to the reference is hardly chance.</source>
        <translation>Het verschil met de referentie is nauwelijks toeval.</translation>
    </message>
    <message>
        <source>The discount of the coarse value function V.</source>
        <translation>De discount van de grove waardefunctie V.</translation>
    </message>
    <message>
        <source>The environment&apos;s own controller, which does not learn.</source>
        <translation>De eigen regelaar van de omgeving, die niet leert.</translation>
    </message>
    <message>
        <source>The environment&apos;s own controller. It does not learn.</source>
        <translation>De eigen regelaar van de omgeving. Hij leert niet.</translation>
    </message>
    <message>
        <source>The episode from which on the average reward of all lives stands still. Falls are counted until then.</source>
        <translation>De episode vanaf welke de gemiddelde beloning van alle levens stilstaat. Tot dan worden valpartijen geteld.</translation>
    </message>
    <message>
        <source>The feet are round.</source>
        <translation>De voeten zijn rond.</translation>
    </message>
    <message>
        <source>The guardian acts from this risk on, until the risk is below half of it.</source>
        <translation>De bewaker handelt vanaf dit risico, tot het risico onder de helft ervan is.</translation>
    </message>
    <message>
        <source>The largest; actions are levels between ± this.</source>
        <translation>De grootste; acties zijn niveaus tussen ± dit.</translation>
    </message>
    <message>
        <source>The pole has fallen at this angle.</source>
        <translation>Bij deze hoek is de stok gevallen.</translation>
    </message>
    <message>
        <source>The risk of an action of which nothing is known.</source>
        <translation>Het risico van een actie waarover niets bekend is.</translation>
    </message>
    <message>
        <source>The robot with motors of 8.6 Ω.</source>
        <translation>De robot met motoren van 8,6 Ω.</translation>
    </message>
    <message>
        <source>The rule of thumb appears with the first footstep.</source>
        <translation>De vuistregel verschijnt bij de eerste voetstap.</translation>
    </message>
    <message>
        <source>The rule of thumb appears with the first success.</source>
        <translation>De vuistregel verschijnt bij het eerste succes.</translation>
    </message>
    <message>
        <source>The rule of thumb is not defined for this task: nothing is earned at a goal.</source>
        <translation>De vuistregel is voor deze taak niet gedefinieerd: bij een doel valt niets te verdienen.</translation>
    </message>
    <message>
        <source>The rule of thumb needs a learning rule that discounts.</source>
        <translation>De vuistregel vereist een leerregel met discount.</translation>
    </message>
    <message>
        <source>The span of the wheel rate that its tiles are counted in: 20 rad/s is 1 m/s of the cart.</source>
        <translation>Het stuk wielsnelheid waarin de tegels ervan worden geteld: 20 rad/s is 1 m/s van het karretje.</translation>
    </message>
    <message>
        <source>The step size of the coarse value function V.</source>
        <translation>De stapgrootte van de grove waardefunctie V.</translation>
    </message>
    <message>
        <source>The surprise of a step: what came, and what is now expected, against what was expected.</source>
        <translation>De verrassing van een stap: wat er kwam en wat nu verwacht wordt, tegenover wat verwacht werd.</translation>
    </message>
    <message>
        <source>The swing foot meets the floor from this angle in front of the stance leg on.</source>
        <translation>Vanaf deze hoek vóór het standbeen raakt de zwaaivoet de vloer.</translation>
    </message>
    <message>
        <source>The thesis&apos;s inverted pendulum on a cart, as a robot file.</source>
        <translation>De omgekeerde slinger op een karretje uit de scriptie, als robotbestand.</translation>
    </message>
    <message>
        <source>The thesis&apos;s inverted pendulum on a cart, in Box2D.</source>
        <translation>De omgekeerde slinger op een karretje uit de scriptie, in Box2D.</translation>
    </message>
    <message>
        <source>The tiles cover the column from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de kolom van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the pole angle from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de stokhoek van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the pole rate from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de stoksnelheid van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the position from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de positie van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the row from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de rij van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the stance angle from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de hoek van het standbeen van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the stance hip from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de heup van het standbeen van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the stance hip rate from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de heupsnelheid van het standbeen van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the stance knee from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de knie van het standbeen van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the stance knee rate from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de kniesnelheid van het standbeen van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the stance rate from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de snelheid van het standbeen van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the state from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de toestand van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the swing angle from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de hoek van het zwaaibeen van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the swing hip from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de heup van het zwaaibeen van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the swing hip rate from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de heupsnelheid van het zwaaibeen van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the swing knee from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de knie van het zwaaibeen van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the swing knee rate from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de kniesnelheid van het zwaaibeen van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the swing rate from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de snelheid van het zwaaibeen van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the torso from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de romp van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the torso rate from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de rompsnelheid van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the velocity from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de snelheid van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The tiles cover the wheel rate from here to there; outside they are worth 0.</source>
        <translation>De tegels beslaan de wielsnelheid van hier tot daar; daarbuiten zijn ze 0 waard.</translation>
    </message>
    <message>
        <source>The value that the schedule goes to.</source>
        <translation>De waarde waar het verloop naartoe gaat.</translation>
    </message>
    <message>
        <source>The worse an action, the rarer it is taken. The temperature τ says how much worse counts: high, and all actions are nearly alike; low, and it is nearly greedy.</source>
        <translation>Hoe slechter een actie, hoe zeldzamer ze wordt genomen. De temperatuur τ zegt hoe zwaar slechter telt: hoog, en alle acties zijn bijna gelijk; laag, en hij is bijna greedy.</translation>
    </message>
    <message>
        <source>Thesis</source>
        <translation>Scriptie</translation>
    </message>
    <message>
        <source>Thigh centre x</source>
        <translation>Zwaartepunt bovenbeen x</translation>
    </message>
    <message>
        <source>Thigh centre y</source>
        <translation>Zwaartepunt bovenbeen y</translation>
    </message>
    <message>
        <source>Thigh inertia</source>
        <translation>Bovenbeentraagheid</translation>
    </message>
    <message>
        <source>Thigh mass</source>
        <translation>Bovenbeenmassa</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Drempel</translation>
    </message>
    <message>
        <source>Threshold, clock</source>
        <translation>Drempel, klok</translation>
    </message>
    <message>
        <source>Threshold, end</source>
        <translation>Drempel, eind</translation>
    </message>
    <message>
        <source>Threshold, schedule</source>
        <translation>Drempel, verloop</translation>
    </message>
    <message>
        <source>Threshold, time</source>
        <translation>Drempel, duur</translation>
    </message>
    <message>
        <source>Threshold-restricted learning: ε-greedy whose exploring steps pick among the actions that are worth more than a threshold, and only in a small share p (“share below”) among the others. If no action or every action is above, it is ε-greedy.</source>
        <translation>Threshold Restricted Learning: ε-greedy, maar de exploratiestappen kiezen uit de acties die meer waard zijn dan een drempel, en slechts in een klein aandeel p (“aandeel eronder”) uit de andere. Ligt geen enkele of elke actie erboven, dan is het ε-greedy.</translation>
    </message>
    <message>
        <source>Tile coder</source>
        <translation>Tile coder</translation>
    </message>
    <message>
        <source>Tile coding</source>
        <translation>Tile coding</translation>
    </message>
    <message>
        <source>Tiles per 2π rad of the pole angle: few generalise far, many tell states apart.</source>
        <translation>Tegels per 2π rad van de stokhoek: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per 2π rad/s of the pole rate: few generalise far, many tell states apart.</source>
        <translation>Tegels per 2π rad/s van de stoksnelheid: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per V of the stance hip voltage: few let near actions share more.</source>
        <translation>Tegels per V van de heupspanning van het standbeen: bij weinig delen nabije acties meer.</translation>
    </message>
    <message>
        <source>Tiles per V of the swing hip voltage: few let near actions share more.</source>
        <translation>Tegels per V van de heupspanning van het zwaaibeen: bij weinig delen nabije acties meer.</translation>
    </message>
    <message>
        <source>Tiles per V of the swing knee voltage: few let near actions share more.</source>
        <translation>Tegels per V van de kniespanning van het zwaaibeen: bij weinig delen nabije acties meer.</translation>
    </message>
    <message>
        <source>Tiles per cell of the column: few generalise far, many tell states apart.</source>
        <translation>Tegels per cel van de kolom: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per cell of the row: few generalise far, many tell states apart.</source>
        <translation>Tegels per cel van de rij: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per cell of the state: few generalise far, many tell states apart.</source>
        <translation>Tegels per cel van de toestand: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per m/s of the wheel rate: few generalise far, many tell states apart.</source>
        <translation>Tegels per m/s van de wielsnelheid: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad of the stance angle: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad van de hoek van het standbeen: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad of the stance hip: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad van de heup van het standbeen: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad of the stance knee: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad van de knie van het standbeen: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad of the swing angle: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad van de hoek van het zwaaibeen: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad of the swing hip: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad van de heup van het zwaaibeen: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad of the swing knee: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad van de knie van het zwaaibeen: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad of the torso: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad van de romp: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the stance hip rate: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad/s van de heupsnelheid van het standbeen: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the stance knee rate: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad/s van de kniesnelheid van het standbeen: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the stance rate: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad/s van de snelheid van het standbeen: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the swing hip rate: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad/s van de heupsnelheid van het zwaaibeen: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the swing knee rate: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad/s van de kniesnelheid van het zwaaibeen: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the swing rate: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad/s van de snelheid van het zwaaibeen: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per rad/s of the torso rate: few generalise far, many tell states apart.</source>
        <translation>Tegels per rad/s van de rompsnelheid: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per span of a variable. Few generalise far, many tell states apart.</source>
        <translation>Tegels per bereik van een variabele. Weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per the whole range of the position: few generalise far, many tell states apart.</source>
        <translation>Tegels op het hele bereik van de positie: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles per the whole range of the velocity: few generalise far, many tell states apart.</source>
        <translation>Tegels op het hele bereik van de snelheid: weinig generaliseren ver, veel houden toestanden uiteen.</translation>
    </message>
    <message>
        <source>Tiles that a hashed table of fixed size holds; 0: a dense table with room for all.</source>
        <translation>Aantal tegels in een hashtabel van vaste grootte; 0: een dichte tabel met plaats voor alle.</translation>
    </message>
    <message>
        <source>Tilings</source>
        <translation>Betegelingen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Time to the first greedy walk</source>
        <translation>Tijd tot de eerste greedy wandeling</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Tot</translation>
    </message>
    <message>
        <source>To column</source>
        <translation>Tot kolom</translation>
    </message>
    <message>
        <source>To row</source>
        <translation>Tot rij</translation>
    </message>
    <message>
        <source>To state</source>
        <translation>Tot toestand</translation>
    </message>
    <message>
        <source>Toe radius</source>
        <translation>Teenstraal</translation>
    </message>
    <message>
        <source>Toe x</source>
        <translation>Teen x</translation>
    </message>
    <message>
        <source>Toe y</source>
        <translation>Teen y</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Koppel</translation>
    </message>
    <message>
        <source>Torque constant</source>
        <translation>Koppelconstante</translation>
    </message>
    <message>
        <source>Torso</source>
        <translation>Romp</translation>
    </message>
    <message>
        <source>Torso centre x</source>
        <translation>Zwaartepunt romp x</translation>
    </message>
    <message>
        <source>Torso centre y</source>
        <translation>Zwaartepunt romp y</translation>
    </message>
    <message>
        <source>Torso inertia</source>
        <translation>Romptraagheid</translation>
    </message>
    <message>
        <source>Torso mass</source>
        <translation>Rompmassa</translation>
    </message>
    <message>
        <source>Torso rate</source>
        <translation>Rompsnelheid</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Trace cut-off</source>
        <translation>Afkapgrens trace</translation>
    </message>
    <message>
        <source>Trace decay</source>
        <translation>Trace-uitdoving</translation>
    </message>
    <message>
        <source>Traces of the actions not taken in a state visited again: kept, or cleared.</source>
        <translation>Traces van de acties die niet zijn genomen in een opnieuw bezochte toestand: bewaard, of gewist.</translation>
    </message>
    <message>
        <source>True online Sarsa</source>
        <translation>True online Sarsa</translation>
    </message>
    <message>
        <source>True online Sarsa(λ)</source>
        <translation>True online Sarsa(λ)</translation>
    </message>
    <message>
        <source>Turbo</source>
        <translation>Turbo</translation>
    </message>
    <message>
        <source>Two Sarsa learners: Q⁺ expects the gains, Q⁻ the losses, each with its own resolution, α and λ. Actions are chosen on the sum. A coarse Q⁻ generalises falls to states where none has happened yet.</source>
        <translation>Twee Sarsa-leerders: Q⁺ verwacht de winst, Q⁻ het verlies, elk met een eigen resolutie, α en λ. Acties worden op de som gekozen. Een grove Q⁻ generaliseert valpartijen naar toestanden waar er nog geen was.</translation>
    </message>
    <message>
        <source>Two links that hang, a motor between them; the tip must rise one link above the pivot (Sutton &amp; Barto).</source>
        <translation>Twee hangende stangen met een motor ertussen; de punt moet één stang boven het draaipunt uitkomen (Sutton &amp; Barto).</translation>
    </message>
    <message>
        <source>Two straight legs and a hip motor: the simplest thing that walks.</source>
        <translation>Twee rechte benen en een heupmotor: het eenvoudigste wat loopt.</translation>
    </message>
    <message>
        <source>Two straight legs and a hip. The swing foot passes through the floor until it is in front.</source>
        <translation>Twee rechte benen en een heup. De zwaaivoet gaat door de vloer tot hij vóór het standbeen is.</translation>
    </message>
    <message>
        <source>Two straight legs and a hip: the simplest thing that walks.</source>
        <translation>Twee rechte benen en een heup: het eenvoudigste wat loopt.</translation>
    </message>
    <message>
        <source>Uphill</source>
        <translation>Bergop</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Snelheid</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>Spanning</translation>
    </message>
    <message>
        <source>Voltage by which ankles hold their angle.</source>
        <translation>Spanning waarmee de enkels hun hoek vasthouden.</translation>
    </message>
    <message>
        <source>Voltage by which the stance knee stretches itself.</source>
        <translation>Spanning waarmee de knie van het standbeen zich strekt.</translation>
    </message>
    <message>
        <source>Watkins&apos;s Q(λ), off-policy.</source>
        <translation>Q(λ) van Watkins, off-policy.</translation>
    </message>
    <message>
        <source>Weight of risk</source>
        <translation>Risicogewicht</translation>
    </message>
    <message>
        <source>Weight of risk, clock</source>
        <translation>Risicogewicht, klok</translation>
    </message>
    <message>
        <source>Weight of risk, end</source>
        <translation>Risicogewicht, eind</translation>
    </message>
    <message>
        <source>Weight of risk, schedule</source>
        <translation>Risicogewicht, verloop</translation>
    </message>
    <message>
        <source>Weight of risk, time</source>
        <translation>Risicogewicht, duur</translation>
    </message>
    <message>
        <source>What a fall one step later still counts; 1: all falls of the episode count.</source>
        <translation>Hoe zwaar een val één stap later nog telt; 1: alle valpartijen van de episode tellen.</translation>
    </message>
    <message>
        <source>What a reward one step later is still worth.</source>
        <translation>Wat een beloning één stap later nog waard is.</translation>
    </message>
    <message>
        <source>What is expected from action a in state s on: the sum of rewards, later ones worth less.</source>
        <translation>Wat vanaf actie a in toestand s te verwachten is: de som van de beloningen, latere minder waard.</translation>
    </message>
    <message>
        <source>What is learned in a simulation that is a little wrong is carried over to the robot.</source>
        <translation>Wat in een simulatie geleerd is die een beetje afwijkt, wordt op de robot overgedragen.</translation>
    </message>
    <message>
        <source>What is to be avoided, while it learns as well: a fall can break the robot.</source>
        <translation>Wat te vermijden is, ook tijdens het leren: een val kan de robot stukmaken.</translation>
    </message>
    <message>
        <source>What the boom adds, upwards positive.</source>
        <translation>Wat de giek toevoegt, naar boven positief.</translation>
    </message>
    <message>
        <source>What the policy does with the risk of a fall, or with the losses of Sarsa_2Q.</source>
        <translation>Wat de policy doet met het risico op een val, of met het verlies van Sarsa_2Q.</translation>
    </message>
    <message>
        <source>What the robot is meant to be.</source>
        <translation>Wat de robot hoort te zijn.</translation>
    </message>
    <message>
        <source>What the time of the schedule is counted in.</source>
        <translation>Waarin de tijd van het verloop wordt geteld.</translation>
    </message>
    <message>
        <source>Wheel mass</source>
        <translation>Wielmassa</translation>
    </message>
    <message>
        <source>Wheel radius</source>
        <translation>Wielstraal</translation>
    </message>
    <message>
        <source>Wheel rate</source>
        <translation>Wielsnelheid</translation>
    </message>
    <message>
        <source>Wheel span</source>
        <translation>Wielbereik</translation>
    </message>
    <message>
        <source>Where the boom&apos;s force acts on the torso.</source>
        <translation>Waar de kracht van de giek op de romp werkt.</translation>
    </message>
    <message>
        <source>Where the joint is in the body above it.</source>
        <translation>Waar het gewricht zit in het lichaam erboven.</translation>
    </message>
    <message>
        <source>Where the joint is in the body below it.</source>
        <translation>Waar het gewricht zit in het lichaam eronder.</translation>
    </message>
    <message>
        <source>Where the joint&apos;s stop is, bent backwards.</source>
        <translation>Waar de aanslag van het gewricht zit, naar achteren gebogen.</translation>
    </message>
    <message>
        <source>Where the joint&apos;s stop is, bent forwards.</source>
        <translation>Waar de aanslag van het gewricht zit, naar voren gebogen.</translation>
    </message>
    <message>
        <source>Which estimate learns from this reward: by its sign, Q⁺, Q⁻ or both.</source>
        <translation>Welke schatting van deze beloning leert: op teken, Q⁺, Q⁻ of beide.</translation>
    </message>
    <message>
        <source>Which weights a surprise still reaches: those of the last steps, the older the less.</source>
        <translation>Welke gewichten een verrassing nog bereikt: die van de laatste stappen, hoe ouder hoe minder.</translation>
    </message>
    <message>
        <source>Who acts while the policy&apos;s action is too risky: the robot&apos;s own controller, or a Q-function of a file. The learner learns from it.</source>
        <translation>Wie handelt zolang de actie van de policy te riskant is: de eigen regelaar van de robot, of een Q-functie uit een bestand. De leerder leert ervan.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Width column</source>
        <translation>Breedte kolom</translation>
    </message>
    <message>
        <source>Width row</source>
        <translation>Breedte rij</translation>
    </message>
    <message>
        <source>Width state</source>
        <translation>Breedte toestand</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the column: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de kolom: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the pole angle: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de stokhoek: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the pole rate: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de stoksnelheid: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the position: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de positie: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the row: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de rij: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance angle: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de hoek van het standbeen: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance hip rate: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de heupsnelheid van het standbeen: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance hip: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de heup van het standbeen: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance knee rate: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de kniesnelheid van het standbeen: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance knee: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de knie van het standbeen: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the stance rate: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de snelheid van het standbeen: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the state: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de toestand: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing angle: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de hoek van het zwaaibeen: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing hip rate: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de heupsnelheid van het zwaaibeen: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing hip: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de heup van het zwaaibeen: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing knee rate: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de kniesnelheid van het zwaaibeen: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing knee: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de knie van het zwaaibeen: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the swing rate: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de snelheid van het zwaaibeen: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the torso rate: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de rompsnelheid: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the torso: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de romp: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the velocity: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de snelheid: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>Width σ of the Gaussians along the wheel rate: a wide one generalises far.</source>
        <translation>Breedte σ van de gaussfuncties langs de wielsnelheid: een brede generaliseert ver.</translation>
    </message>
    <message>
        <source>X, significant</source>
        <translation>X, significant</translation>
    </message>
    <message>
        <source>a fall</source>
        <translation>een val</translation>
    </message>
    <message>
        <source>accumulating</source>
        <translation>accumulerend</translation>
    </message>
    <message>
        <source>action</source>
        <translation>actie</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>asymmetry</source>
        <translation>asymmetrie</translation>
    </message>
    <message>
        <source>asymmetry of errors</source>
        <translation>asymmetrie van fouten</translation>
    </message>
    <message>
        <source>average reward</source>
        <translation>gemiddelde beloning</translation>
    </message>
    <message>
        <source>average reward at the end</source>
        <translation>gemiddelde beloning aan het eind</translation>
    </message>
    <message>
        <source>balanced</source>
        <translation>in balans</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>gekalibreerd</translation>
    </message>
    <message>
        <source>cart position</source>
        <translation>positie van de wagen</translation>
    </message>
    <message>
        <source>change in 250 episodes</source>
        <translation>verandering in 250 episodes</translation>
    </message>
    <message>
        <source>choose</source>
        <translation>kiezen</translation>
    </message>
    <message>
        <source>choose, because</source>
        <translation>kiezen, want</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>wissen</translation>
    </message>
    <message>
        <source>cliff</source>
        <translation>cliff</translation>
    </message>
    <message>
        <source>column</source>
        <translation>kolom</translation>
    </message>
    <message>
        <source>compare</source>
        <translation>vergelijken</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>constant</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>contacten</translation>
    </message>
    <message>
        <source>counted in</source>
        <translation>geteld in</translation>
    </message>
    <message>
        <source>discount</source>
        <translation>discount</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>afstand</translation>
    </message>
    <message>
        <source>distance of a greedy test, last 10</source>
        <translation>afstand van een greedy test, laatste 10</translation>
    </message>
    <message>
        <source>distance of a greedy test, last 10 [m]</source>
        <translation>afstand van een greedy test, laatste 10 [m]</translation>
    </message>
    <message>
        <source>distance of a life</source>
        <translation>afstand van een leven</translation>
    </message>
    <message>
        <source>distance of a life [m]</source>
        <translation>afstand van een leven [m]</translation>
    </message>
    <message>
        <source>down</source>
        <translation>omlaag</translation>
    </message>
    <message>
        <source>end value</source>
        <translation>eindwaarde</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energie</translation>
    </message>
    <message>
        <source>energy of a greedy test, last 10</source>
        <translation>energie van een greedy test, laatste 10</translation>
    </message>
    <message>
        <source>energy of a greedy test, last 10 [J]</source>
        <translation>energie van een greedy test, laatste 10 [J]</translation>
    </message>
    <message>
        <source>energy of a life</source>
        <translation>energie van een leven</translation>
    </message>
    <message>
        <source>energy of a life [J]</source>
        <translation>energie van een leven [J]</translation>
    </message>
    <message>
        <source>energy, 0 upright at rest</source>
        <translation>energie, 0 rechtop in rust</translation>
    </message>
    <message>
        <source>episode</source>
        <translation>episode</translation>
    </message>
    <message>
        <source>episodes</source>
        <translation>episodes</translation>
    </message>
    <message>
        <source>error of the risk</source>
        <translation>fout van het risico</translation>
    </message>
    <message>
        <source>events</source>
        <translation>gebeurtenissen</translation>
    </message>
    <message>
        <source>explore</source>
        <translation>exploreren</translation>
    </message>
    <message>
        <source>exponential</source>
        <translation>exponentieel</translation>
    </message>
    <message>
        <source>fall</source>
        <translation>val</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>valpartijen</translation>
    </message>
    <message>
        <source>falls an hour</source>
        <translation>valpartijen per uur</translation>
    </message>
    <message>
        <source>falls by episode 330</source>
        <translation>valpartijen tot episode 330</translation>
    </message>
    <message>
        <source>falls by minute 1</source>
        <translation>valpartijen tot minuut 1</translation>
    </message>
    <message>
        <source>falls by minute 3</source>
        <translation>valpartijen tot minuut 3</translation>
    </message>
    <message>
        <source>falls by minute 6</source>
        <translation>valpartijen tot minuut 6</translation>
    </message>
    <message>
        <source>falls during learning</source>
        <translation>valpartijen tijdens het leren</translation>
    </message>
    <message>
        <source>falls of a greedy episode at the end</source>
        <translation>valpartijen van een greedy episode aan het eind</translation>
    </message>
    <message>
        <source>falls of a greedy test, last 10</source>
        <translation>valpartijen van een greedy test, laatste 10</translation>
    </message>
    <message>
        <source>falls of a life</source>
        <translation>valpartijen van een leven</translation>
    </message>
    <message>
        <source>falls per episode, last 500</source>
        <translation>valpartijen per episode, laatste 500</translation>
    </message>
    <message>
        <source>falls so far</source>
        <translation>valpartijen tot nu toe</translation>
    </message>
    <message>
        <source>falls taken back</source>
        <translation>valpartijen teruggedraaid</translation>
    </message>
    <message>
        <source>falls where this was said</source>
        <translation>valpartijen waar dit voorspeld werd</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>filter</translation>
    </message>
    <message>
        <source>find the mistake</source>
        <translation>vind de fout</translation>
    </message>
    <message>
        <source>footstep</source>
        <translation>voetstap</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>vooruit</translation>
    </message>
    <message>
        <source>from</source>
        <translation>van</translation>
    </message>
    <message>
        <source>from column</source>
        <translation>vanaf kolom</translation>
    </message>
    <message>
        <source>from row</source>
        <translation>vanaf rij</translation>
    </message>
    <message>
        <source>from state</source>
        <translation>vanaf toestand</translation>
    </message>
    <message>
        <source>gains</source>
        <translation>winst</translation>
    </message>
    <message>
        <source>gait</source>
        <translation>gang</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>doel</translation>
    </message>
    <message>
        <source>hand-made</source>
        <translation>vaste regelaar</translation>
    </message>
    <message>
        <source>hashed tiles</source>
        <translation>gehashte tegels</translation>
    </message>
    <message>
        <source>highest value</source>
        <translation>hoogste waarde</translation>
    </message>
    <message>
        <source>hip height</source>
        <translation>heuphoogte</translation>
    </message>
    <message>
        <source>hip position</source>
        <translation>heuppositie</translation>
    </message>
    <message>
        <source>hip speed</source>
        <translation>heupsnelheid</translation>
    </message>
    <message>
        <source>hip torque</source>
        <translation>heupkoppel</translation>
    </message>
    <message>
        <source>initial</source>
        <translation>begin</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>behouden</translation>
    </message>
    <message>
        <source>lab file</source>
        <translation>bestand van het lab</translation>
    </message>
    <message>
        <source>learner</source>
        <translation>leerder</translation>
    </message>
    <message>
        <source>learning time [min]</source>
        <translation>leertijd [min]</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>left ankle angle</source>
        <translation>enkelhoek (links)</translation>
    </message>
    <message>
        <source>left ankle current</source>
        <translation>enkelstroom (links)</translation>
    </message>
    <message>
        <source>left ankle power</source>
        <translation>enkelvermogen (links)</translation>
    </message>
    <message>
        <source>left ankle rate</source>
        <translation>enkelsnelheid (links)</translation>
    </message>
    <message>
        <source>left ankle voltage</source>
        <translation>enkelspanning (links)</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>linkervoet</translation>
    </message>
    <message>
        <source>left foot on the floor</source>
        <translation>linkervoet op de vloer</translation>
    </message>
    <message>
        <source>left heel</source>
        <translation>linkerhiel</translation>
    </message>
    <message>
        <source>left hip angle</source>
        <translation>heuphoek (links)</translation>
    </message>
    <message>
        <source>left hip current</source>
        <translation>heupstroom (links)</translation>
    </message>
    <message>
        <source>left hip power</source>
        <translation>heupvermogen (links)</translation>
    </message>
    <message>
        <source>left hip rate</source>
        <translation>heupsnelheid (links)</translation>
    </message>
    <message>
        <source>left hip voltage</source>
        <translation>heupspanning (links)</translation>
    </message>
    <message>
        <source>left knee angle</source>
        <translation>kniehoek (links)</translation>
    </message>
    <message>
        <source>left knee current</source>
        <translation>kniestroom (links)</translation>
    </message>
    <message>
        <source>left knee power</source>
        <translation>knievermogen (links)</translation>
    </message>
    <message>
        <source>left knee rate</source>
        <translation>kniesnelheid (links)</translation>
    </message>
    <message>
        <source>left knee voltage</source>
        <translation>kniespanning (links)</translation>
    </message>
    <message>
        <source>left toe</source>
        <translation>linkerteen</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>lineair</translation>
    </message>
    <message>
        <source>lives that walk</source>
        <translation>levens die lopen</translation>
    </message>
    <message>
        <source>losses</source>
        <translation>verlies</translation>
    </message>
    <message>
        <source>measures</source>
        <translation>maten</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>beweging</translation>
    </message>
    <message>
        <source>motors</source>
        <translation>motoren</translation>
    </message>
    <message>
        <source>move</source>
        <translation>beweging</translation>
    </message>
    <message>
        <source>n grids lie over each other, displaced. A state is in one tile of each; states that share tiles share what is learned.</source>
        <translation>n roosters liggen verschoven over elkaar. Een toestand ligt in één tegel van elk rooster; toestanden die tegels delen, delen wat is geleerd.</translation>
    </message>
    <message>
        <source>n*, transitions of a success</source>
        <translation>n*, overgangen van een succes</translation>
    </message>
    <message>
        <source>negative</source>
        <translation>negatief</translation>
    </message>
    <message>
        <source>net footsteps</source>
        <translation>netto voetstappen</translation>
    </message>
    <message>
        <source>net footsteps of a greedy test, last 10</source>
        <translation>netto voetstappen van een greedy test, laatste 10</translation>
    </message>
    <message>
        <source>net footsteps of a life</source>
        <translation>netto voetstappen van een leven</translation>
    </message>
    <message>
        <source>nobody</source>
        <translation>niemand</translation>
    </message>
    <message>
        <source>none</source>
        <translation>geen</translation>
    </message>
    <message>
        <source>number of the action</source>
        <translation>nummer van de actie</translation>
    </message>
    <message>
        <source>off</source>
        <translation>uit</translation>
    </message>
    <message>
        <source>on</source>
        <translation>aan</translation>
    </message>
    <message>
        <source>order</source>
        <translation>ordenen</translation>
    </message>
    <message>
        <source>ours</source>
        <translation>van ons</translation>
    </message>
    <message>
        <source>ours (Singh &amp; Sutton 1996)</source>
        <translation>van ons (Singh &amp; Sutton 1996)</translation>
    </message>
    <message>
        <source>ours (thesis, section 6.5)</source>
        <translation>van ons (scriptie, paragraaf 6.5)</translation>
    </message>
    <message>
        <source>ours: 0, as in the thesis</source>
        <translation>van ons: 0, zoals in de scriptie</translation>
    </message>
    <message>
        <source>ours: 0, as in the thesis (Mihatsch &amp; Neuneier 2002)</source>
        <translation>van ons: 0, zoals in de scriptie (Mihatsch &amp; Neuneier 2002)</translation>
    </message>
    <message>
        <source>ours: 1 is Sarsa_2Q of the thesis</source>
        <translation>van ons: 1 is Sarsa_2Q van de scriptie</translation>
    </message>
    <message>
        <source>ours: as the learner&apos;s</source>
        <translation>van ons: als die van de leerder</translation>
    </message>
    <message>
        <source>ours: half a tile</source>
        <translation>van ons: een halve tegel</translation>
    </message>
    <message>
        <source>ours: nobody, as in the thesis</source>
        <translation>van ons: niemand, zoals in de scriptie</translation>
    </message>
    <message>
        <source>ours: off, as in the thesis</source>
        <translation>van ons: uit, zoals in de scriptie</translation>
    </message>
    <message>
        <source>ours: on top of the reward of a fall</source>
        <translation>van ons: boven op de beloning van een val</translation>
    </message>
    <message>
        <source>ours: the probability of a fall in the episode</source>
        <translation>van ons: de kans op een val in de episode</translation>
    </message>
    <message>
        <source>over</source>
        <translation>over</translation>
    </message>
    <message>
        <source>own words</source>
        <translation>eigen woorden</translation>
    </message>
    <message>
        <source>point</source>
        <translation>aanwijzen</translation>
    </message>
    <message>
        <source>pole angle</source>
        <translation>stokhoek</translation>
    </message>
    <message>
        <source>pole rate</source>
        <translation>stoksnelheid</translation>
    </message>
    <message>
        <source>position</source>
        <translation>positie</translation>
    </message>
    <message>
        <source>positive</source>
        <translation>positief</translation>
    </message>
    <message>
        <source>power of all motors</source>
        <translation>vermogen van alle motoren</translation>
    </message>
    <message>
        <source>power of the hip</source>
        <translation>vermogen van de heup</translation>
    </message>
    <message>
        <source>power of the wheel</source>
        <translation>vermogen van het wiel</translation>
    </message>
    <message>
        <source>predict</source>
        <translation>voorspellen</translation>
    </message>
    <message>
        <source>price of a fall at the end</source>
        <translation>prijs van een val aan het eind</translation>
    </message>
    <message>
        <source>probability</source>
        <translation>kans</translation>
    </message>
    <message>
        <source>probability of the action</source>
        <translation>kans op de actie</translation>
    </message>
    <message>
        <source>puzzle</source>
        <translation>puzzel</translation>
    </message>
    <message>
        <source>q-function</source>
        <translation>Q-functie</translation>
    </message>
    <message>
        <source>replacing</source>
        <translation>vervangend</translation>
    </message>
    <message>
        <source>reverse</source>
        <translation>achteruit</translation>
    </message>
    <message>
        <source>reward</source>
        <translation>beloning</translation>
    </message>
    <message>
        <source>reward of a greedy episode at the end</source>
        <translation>beloning van een greedy episode aan het eind</translation>
    </message>
    <message>
        <source>reward of a greedy test, last 10</source>
        <translation>beloning van een greedy test, laatste 10</translation>
    </message>
    <message>
        <source>reward of an episode, whole life</source>
        <translation>beloning van een episode, hele leven</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>right ankle angle</source>
        <translation>enkelhoek (rechts)</translation>
    </message>
    <message>
        <source>right ankle current</source>
        <translation>enkelstroom (rechts)</translation>
    </message>
    <message>
        <source>right ankle power</source>
        <translation>enkelvermogen (rechts)</translation>
    </message>
    <message>
        <source>right ankle rate</source>
        <translation>enkelsnelheid (rechts)</translation>
    </message>
    <message>
        <source>right ankle voltage</source>
        <translation>enkelspanning (rechts)</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>rechtervoet</translation>
    </message>
    <message>
        <source>right foot on the floor</source>
        <translation>rechtervoet op de vloer</translation>
    </message>
    <message>
        <source>right heel</source>
        <translation>rechterhiel</translation>
    </message>
    <message>
        <source>right hip angle</source>
        <translation>heuphoek (rechts)</translation>
    </message>
    <message>
        <source>right hip current</source>
        <translation>heupstroom (rechts)</translation>
    </message>
    <message>
        <source>right hip power</source>
        <translation>heupvermogen (rechts)</translation>
    </message>
    <message>
        <source>right hip rate</source>
        <translation>heupsnelheid (rechts)</translation>
    </message>
    <message>
        <source>right hip voltage</source>
        <translation>heupspanning (rechts)</translation>
    </message>
    <message>
        <source>right knee angle</source>
        <translation>kniehoek (rechts)</translation>
    </message>
    <message>
        <source>right knee current</source>
        <translation>kniestroom (rechts)</translation>
    </message>
    <message>
        <source>right knee power</source>
        <translation>knievermogen (rechts)</translation>
    </message>
    <message>
        <source>right knee rate</source>
        <translation>kniesnelheid (rechts)</translation>
    </message>
    <message>
        <source>right knee voltage</source>
        <translation>kniespanning (rechts)</translation>
    </message>
    <message>
        <source>right leg stands</source>
        <translation>rechterbeen staat</translation>
    </message>
    <message>
        <source>right toe</source>
        <translation>rechterteen</translation>
    </message>
    <message>
        <source>risk of a fall, said at the end</source>
        <translation>valrisico, voorspeld aan het eind</translation>
    </message>
    <message>
        <source>risk of the action</source>
        <translation>risico van de actie</translation>
    </message>
    <message>
        <source>row</source>
        <translation>rij</translation>
    </message>
    <message>
        <source>rule</source>
        <translation>regel</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>schaal</translation>
    </message>
    <message>
        <source>schedule</source>
        <translation>verloop</translation>
    </message>
    <message>
        <source>share of actions that are not the best</source>
        <translation>aandeel acties die niet de beste zijn</translation>
    </message>
    <message>
        <source>share of lives</source>
        <translation>aandeel levens</translation>
    </message>
    <message>
        <source>share of the guardian&apos;s actions</source>
        <translation>aandeel acties van de bewaker</translation>
    </message>
    <message>
        <source>sign</source>
        <translation>teken</translation>
    </message>
    <message>
        <source>simulated time [min]</source>
        <translation>gesimuleerde tijd [min]</translation>
    </message>
    <message>
        <source>stance angle</source>
        <translation>hoek standbeen</translation>
    </message>
    <message>
        <source>stance foot</source>
        <translation>voet (stand)</translation>
    </message>
    <message>
        <source>stance hip</source>
        <translation>heup (stand)</translation>
    </message>
    <message>
        <source>stance hip rate</source>
        <translation>heupsnelheid (stand)</translation>
    </message>
    <message>
        <source>stance hip voltage</source>
        <translation>heupspanning (stand)</translation>
    </message>
    <message>
        <source>stance knee</source>
        <translation>knie (stand)</translation>
    </message>
    <message>
        <source>stance knee rate</source>
        <translation>kniesnelheid (stand)</translation>
    </message>
    <message>
        <source>stance rate</source>
        <translation>snelheid standbeen</translation>
    </message>
    <message>
        <source>stance shank</source>
        <translation>onderbeen (stand)</translation>
    </message>
    <message>
        <source>stance thigh</source>
        <translation>bovenbeen (stand)</translation>
    </message>
    <message>
        <source>stance, far leg</source>
        <translation>stand, verre been</translation>
    </message>
    <message>
        <source>stance, near leg</source>
        <translation>stand, nabije been</translation>
    </message>
    <message>
        <source>start</source>
        <translation>start</translation>
    </message>
    <message>
        <source>state</source>
        <translation>toestand</translation>
    </message>
    <message>
        <source>step size</source>
        <translation>stapgrootte</translation>
    </message>
    <message>
        <source>step size, clock</source>
        <translation>stapgrootte, klok</translation>
    </message>
    <message>
        <source>step size, end</source>
        <translation>stapgrootte, eind</translation>
    </message>
    <message>
        <source>step size, schedule</source>
        <translation>stapgrootte, verloop</translation>
    </message>
    <message>
        <source>step size, time</source>
        <translation>stapgrootte, duur</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>stappen</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>som</translation>
    </message>
    <message>
        <source>swing angle</source>
        <translation>hoek zwaaibeen</translation>
    </message>
    <message>
        <source>swing foot</source>
        <translation>voet (zwaai)</translation>
    </message>
    <message>
        <source>swing hip</source>
        <translation>heup (zwaai)</translation>
    </message>
    <message>
        <source>swing hip rate</source>
        <translation>heupsnelheid (zwaai)</translation>
    </message>
    <message>
        <source>swing hip voltage</source>
        <translation>heupspanning (zwaai)</translation>
    </message>
    <message>
        <source>swing knee</source>
        <translation>knie (zwaai)</translation>
    </message>
    <message>
        <source>swing knee rate</source>
        <translation>kniesnelheid (zwaai)</translation>
    </message>
    <message>
        <source>swing knee voltage</source>
        <translation>kniespanning (zwaai)</translation>
    </message>
    <message>
        <source>swing rate</source>
        <translation>snelheid zwaaibeen</translation>
    </message>
    <message>
        <source>swing shank</source>
        <translation>onderbeen (zwaai)</translation>
    </message>
    <message>
        <source>swing thigh</source>
        <translation>bovenbeen (zwaai)</translation>
    </message>
    <message>
        <source>task</source>
        <translation>taak</translation>
    </message>
    <message>
        <source>terms</source>
        <translation>termen</translation>
    </message>
    <message>
        <source>the action explores</source>
        <translation>de actie exploreert</translation>
    </message>
    <message>
        <source>the episode ends</source>
        <translation>de episode eindigt</translation>
    </message>
    <message>
        <source>throttle</source>
        <translation>gas</translation>
    </message>
    <message>
        <source>tilings</source>
        <translation>betegelingen</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tijd</translation>
    </message>
    <message>
        <source>time to the first greedy walk</source>
        <translation>tijd tot de eerste greedy wandeling</translation>
    </message>
    <message>
        <source>time to the first greedy walk [min]</source>
        <translation>tijd tot de eerste greedy wandeling [min]</translation>
    </message>
    <message>
        <source>to</source>
        <translation>tot</translation>
    </message>
    <message>
        <source>to column</source>
        <translation>tot kolom</translation>
    </message>
    <message>
        <source>to row</source>
        <translation>tot rij</translation>
    </message>
    <message>
        <source>to state</source>
        <translation>tot toestand</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>koppel</translation>
    </message>
    <message>
        <source>torque of the wheel</source>
        <translation>koppel van het wiel</translation>
    </message>
    <message>
        <source>torque on the swing leg</source>
        <translation>koppel op het zwaaibeen</translation>
    </message>
    <message>
        <source>torso</source>
        <translation>romp</translation>
    </message>
    <message>
        <source>torso rate</source>
        <translation>rompsnelheid</translation>
    </message>
    <message>
        <source>trace decay</source>
        <translation>trace-uitdoving</translation>
    </message>
    <message>
        <source>transitions of a failure, after learning</source>
        <translation>overgangen van een mislukking, na het leren</translation>
    </message>
    <message>
        <source>transitions of a failure, during learning</source>
        <translation>overgangen van een mislukking, tijdens het leren</translation>
    </message>
    <message>
        <source>transitions of a success, after learning</source>
        <translation>overgangen van een succes, na het leren</translation>
    </message>
    <message>
        <source>transitions of a success, during learning</source>
        <translation>overgangen van een succes, tijdens het leren</translation>
    </message>
    <message>
        <source>transitions of an episode, first 80</source>
        <translation>overgangen van een episode, eerste 80</translation>
    </message>
    <message>
        <source>try</source>
        <translation>proberen</translation>
    </message>
    <message>
        <source>up</source>
        <translation>omhoog</translation>
    </message>
    <message>
        <source>value</source>
        <translation>waarde</translation>
    </message>
    <message>
        <source>value of the action</source>
        <translation>waarde van de actie</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>snelheid</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>spanning</translation>
    </message>
    <message>
        <source>voltages</source>
        <translation>spanningen</translation>
    </message>
    <message>
        <source>walk</source>
        <translation>lopen</translation>
    </message>
    <message>
        <source>watch</source>
        <translation>kijken</translation>
    </message>
    <message>
        <source>wcaarls/grl, addons/leosim</source>
        <translation>wcaarls/grl, addons/leosim</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>gewicht</translation>
    </message>
    <message>
        <source>wheel rate</source>
        <translation>wielsnelheid</translation>
    </message>
    <message>
        <source>width</source>
        <translation>breedte</translation>
    </message>
    <message>
        <source>width column</source>
        <translation>breedte kolom</translation>
    </message>
    <message>
        <source>width row</source>
        <translation>breedte rij</translation>
    </message>
    <message>
        <source>width state</source>
        <translation>breedte toestand</translation>
    </message>
    <message>
        <source>work out</source>
        <translation>uitrekenen</translation>
    </message>
    <message>
        <source>z, trace (eligibility)</source>
        <translation>z, trace (eligibility)</translation>
    </message>
    <message>
        <source>δ, error</source>
        <translation>δ, fout</translation>
    </message>
    <message>
        <source>ε-greedy</source>
        <translation>ε-greedy</translation>
    </message>
    <message>
        <source>ε-greedy that explores among the actions above a threshold.</source>
        <translation>ε-greedy die exploreert onder de acties boven een drempel.</translation>
    </message>
    <message>
        <source>π, policy</source>
        <translation>π, policy</translation>
    </message>
    <message>
        <source>the whole range</source>
        <translation>het hele bereik</translation>
    </message>
    <message>
        <source>343 actions = 7³: three voltages of seven levels</source>
        <translation>343 acties = 7³: drie spanningen met zeven niveaus</translation>
    </message>
    <message>
        <source>A⁺ = {a: Q(s, a) &gt; threshold}</source>
        <translation>A⁺ = {a: Q(s, a) &gt; drempel}</translation>
    </message>
    <message>
        <source>A⁺ = {a: Q(s, a) &gt; threshold}; exploring steps pick from A⁺</source>
        <translation>A⁺ = {a: Q(s, a) &gt; drempel}; explorerende stappen kiezen uit A⁺</translation>
    </message>
    <message>
        <source>F = m·a of the cart, its wheel besides</source>
        <translation>F = m·a van de wagen, daarnaast zijn wiel</translation>
    </message>
    <message>
        <source>F = γ·V(s′) − V(s) is added to the reward</source>
        <translation>F = γ·V(s′) − V(s) komt bij de beloning</translation>
    </message>
    <message>
        <source>F_y = boom force at the boom point</source>
        <translation>F_y = boomkracht in het boompunt</translation>
    </message>
    <message>
        <source>I = m·l²/12 about its centre of mass</source>
        <translation>I = m·l²/12 om zijn massamiddelpunt</translation>
    </message>
    <message>
        <source>I = m·l²/12, centre of mass at l/2</source>
        <translation>I = m·l²/12, massamiddelpunt op l/2</translation>
    </message>
    <message>
        <source>Q(s, a) = 0 where s &lt; from or s &gt; to</source>
        <translation>Q(s, a) = 0 waar s &lt; van of s &gt; tot</translation>
    </message>
    <message>
        <source>Q(s, a) = Σ of n weights, one a tiling;  tile i = ⌊(x/width·n + i·(2d + 1))/n⌋</source>
        <translation>Q(s, a) = Σ van n gewichten, één per betegeling;  tegel i = ⌊(x/breedte·n + i·(2d + 1))/n⌋</translation>
    </message>
    <message>
        <source>Q(s, a) = Σ of n weights, one of each tiling; tiling i is displaced by i/n of a tile and more</source>
        <translation>Q(s, a) = Σ van n gewichten, van elke betegeling één; betegeling i is i/n tegel en meer verschoven</translation>
    </message>
    <message>
        <source>Q(s, a) has a weight of its own for every pair</source>
        <translation>Q(s, a) heeft voor elk paar een eigen gewicht</translation>
    </message>
    <message>
        <source>T = scale·T(a)</source>
        <translation>T = schaal·T(a)</translation>
    </message>
    <message>
        <source>T in v = start + (end − start)·min(t/T, 1) and v = end + (start − end)·2^(−t/T)</source>
        <translation>T in v = begin + (eind − begin)·min(t/T, 1) en v = eind + (begin − eind)·2^(−t/T)</translation>
    </message>
    <message>
        <source>T_hinge = −μ·sign(α̇)</source>
        <translation>T_scharnier = −μ·sign(α̇)</translation>
    </message>
    <message>
        <source>T_wheel = T(a) − c·β̇</source>
        <translation>T_wiel = T(a) − c·β̇</translation>
    </message>
    <message>
        <source>U = gain·(0 − knee angle)</source>
        <translation>U = versterking·(0 − kniehoek)</translation>
    </message>
    <message>
        <source>U = gain·(target − ankle angle)</source>
        <translation>U = versterking·(doel − enkelhoek)</translation>
    </message>
    <message>
        <source>U = −U_max … U_max, in equal steps</source>
        <translation>U = −U_max … U_max, in gelijke stappen</translation>
    </message>
    <message>
        <source>a circle |p − centre| = r meets the floor</source>
        <translation>een cirkel |p − middelpunt| = r raakt de vloer</translation>
    </message>
    <message>
        <source>a test after the episodes k, 2k, 3k, …</source>
        <translation>een test na de episodes k, 2k, 3k, …</translation>
    </message>
    <message>
        <source>actions = levels³, each of three voltages U_i = U_max·(2i/(levels − 1) − 1)</source>
        <translation>acties = niveaus³, elk met drie spanningen U_i = U_max·(2i/(niveaus − 1) − 1)</translation>
    </message>
    <message>
        <source>after a fall s ← s of N steps before, and a new action there</source>
        <translation>na een val s ← s van N stappen eerder, en daar een nieuwe actie</translation>
    </message>
    <message>
        <source>an episode ends with the fall after so many that were taken back</source>
        <translation>een episode eindigt met de val na zoveel teruggedraaide</translation>
    </message>
    <message>
        <source>an episode that ends in a failure state</source>
        <translation>een episode die in een faaltoestand eindigt</translation>
    </message>
    <message>
        <source>an episode under the greedy policy, which is not counted</source>
        <translation>een episode met de greedy policy, die niet meetelt</translation>
    </message>
    <message>
        <source>angle(0) = this, ω(0) = 0</source>
        <translation>hoek(0) = dit, ω(0) = 0</translation>
    </message>
    <message>
        <source>balanced: |α| ≤ 0.005π, |α̇| ≤ 0.005π rad/s; fallen: |α| ≥ 0.45π</source>
        <translation>in balans: |α| ≤ 0,005π, |α̇| ≤ 0,005π rad/s; gevallen: |α| ≥ 0,45π</translation>
    </message>
    <message>
        <source>clear: z(s, b) ← 0 for all b ≠ a</source>
        <translation>wissen: z(s, b) ← 0 voor alle b ≠ a</translation>
    </message>
    <message>
        <source>damping c, friction μ, torque scaling</source>
        <translation>demping c, wrijving μ, schaling van het koppel</translation>
    </message>
    <message>
        <source>first k ≥ 330 with |A(k) − A(k − 250)| &lt; 0.015·R_goal and A(k) &gt; 0.75·R_goal</source>
        <translation>eerste k ≥ 330 met |A(k) − A(k − 250)| &lt; 0,015·R_doel en A(k) &gt; 0,75·R_doel</translation>
    </message>
    <message>
        <source>g = (g·sin slope, −g·cos slope)</source>
        <translation>g = (g·sin helling, −g·cos helling)</translation>
    </message>
    <message>
        <source>half of it on each leg: F = m·a</source>
        <translation>de helft op elk been: F = m·a</translation>
    </message>
    <message>
        <source>hand-made: hip angle → target in every step</source>
        <translation>vaste regelaar: heuphoek → doel in elke stap</translation>
    </message>
    <message>
        <source>height of the hip = l·cos(stance angle)</source>
        <translation>hoogte van de heup = l·cos(hoek standbeen)</translation>
    </message>
    <message>
        <source>it acts from ρ(s, a) &gt; limit until ρ(s, a) ≤ limit/2, a drawn by the policy</source>
        <translation>hij grijpt in vanaf ρ(s, a) &gt; grens tot ρ(s, a) ≤ grens/2, a getrokken door de policy</translation>
    </message>
    <message>
        <source>learn on a model until the average reward is R, then go on in reality</source>
        <translation>leer op een model tot de gemiddelde beloning R is, ga dan verder in werkelijkheid</translation>
    </message>
    <message>
        <source>linear: v = start + (end − start)·min(t/T, 1); exponential: v = end + (start − end)·2^(−t/T)</source>
        <translation>lineair: v = begin + (eind − begin)·min(t/T, 1); exponentieel: v = eind + (begin − eind)·2^(−t/T)</translation>
    </message>
    <message>
        <source>low ≤ joint angle ≤ high</source>
        <translation>laag ≤ gewrichtshoek ≤ hoog</translation>
    </message>
    <message>
        <source>mean total reward of the last 80 episodes</source>
        <translation>gemiddelde totale beloning van de laatste 80 episodes</translation>
    </message>
    <message>
        <source>n* = mean length of the successful episodes [steps]</source>
        <translation>n* = gemiddelde lengte van de geslaagde episodes [stappen]</translation>
    </message>
    <message>
        <source>p &lt; .01: of pairs, of Q-functions, or the analysis of variance of lives</source>
        <translation>p &lt; 0,01: van paren, van Q-functies, of de variantieanalyse van levens</translation>
    </message>
    <message>
        <source>p = (x, y) in the body&apos;s frame</source>
        <translation>p = (x, y) in het stelsel van het lichaam</translation>
    </message>
    <message>
        <source>r = fall when it falls, which ends the episode</source>
        <translation>r = val als hij valt; dat beëindigt de episode</translation>
    </message>
    <message>
        <source>r = footstep·length of the step [m]; fall, and the episode ends</source>
        <translation>r = voetstap·lengte van de stap [m]; val, en de episode eindigt</translation>
    </message>
    <message>
        <source>r = goal when it is reached, which ends the episode</source>
        <translation>r = doel als het bereikt is; dat beëindigt de episode</translation>
    </message>
    <message>
        <source>r = −1 a step until it is over the hill</source>
        <translation>r = −1 per stap tot hij over de heuvel is</translation>
    </message>
    <message>
        <source>r = −1 a step, −100 and a fall over the edge</source>
        <translation>r = −1 per stap, −100 en een val over de rand</translation>
    </message>
    <message>
        <source>r ← r + energy·E, E = Σ max(0, U·I)·Δt of hips and knees</source>
        <translation>r ← r + energie·E, E = Σ max(0, U·I)·Δt van heupen en knieën</translation>
    </message>
    <message>
        <source>r ← r + footstep·Δx, Δx the metres gained [m]</source>
        <translation>r ← r + voetstap·Δx, Δx de gewonnen meters [m]</translation>
    </message>
    <message>
        <source>r ← r + time at every step</source>
        <translation>r ← r + tijd bij elke stap</translation>
    </message>
    <message>
        <source>r ← r − Λ·[fall]; Λ ← max(0, Λ + η·(falls − d)) after every episode</source>
        <translation>r ← r − Λ·[val]; Λ ← max(0, Λ + η·(valpartijen − d)) na elke episode</translation>
    </message>
    <message>
        <source>replacing: z(s, a) ← 1; accumulating: z(s, a) ← γ·λ·z(s, a) + 1</source>
        <translation>vervangend: z(s, a) ← 1; accumulerend: z(s, a) ← γ·λ·z(s, a) + 1</translation>
    </message>
    <message>
        <source>sign: r⁺ = max(r, 0), r⁻ = min(r, 0); both: r⁺ = r⁻ = r</source>
        <translation>teken: r⁺ = max(r, 0), r⁻ = min(r, 0); beide: r⁺ = r⁻ = r</translation>
    </message>
    <message>
        <source>slot = hash(tile) mod memory</source>
        <translation>plaats = hash(tegel) mod geheugen</translation>
    </message>
    <message>
        <source>stance angle(0) = this·(1 ± noise)</source>
        <translation>hoek standbeen(0) = dit·(1 ± ruis)</translation>
    </message>
    <message>
        <source>stance rate(0) = this·(1 ± noise)</source>
        <translation>snelheid standbeen(0) = dit·(1 ± ruis)</translation>
    </message>
    <message>
        <source>start = usual start·(1 + noise·U[−1, 1])</source>
        <translation>start = gewone start·(1 + ruis·U[−1, 1])</translation>
    </message>
    <message>
        <source>step &lt; episode &lt; life &lt; experiment</source>
        <translation>stap &lt; episode &lt; leven &lt; experiment</translation>
    </message>
    <message>
        <source>steps a second as many as the processor can</source>
        <translation>zoveel stappen per seconde als de processor kan</translation>
    </message>
    <message>
        <source>swing angle(0) = this·(1 ± noise)</source>
        <translation>hoek zwaaibeen(0) = dit·(1 ± ruis)</translation>
    </message>
    <message>
        <source>swing − stance ≥ angle: the foot meets the floor</source>
        <translation>zwaai − stand ≥ hoek: de voet raakt de vloer</translation>
    </message>
    <message>
        <source>t = episodes or steps of the life so far</source>
        <translation>t = episodes of stappen van het leven tot nu toe</translation>
    </message>
    <message>
        <source>t = limit: the episode is cut off, and Q(s′, ·) still counts</source>
        <translation>t = grens: de episode wordt afgebroken, en Q(s′, ·) telt nog mee</translation>
    </message>
    <message>
        <source>tangential force ≤ grip·normal force</source>
        <translation>tangentiële kracht ≤ grip·normaalkracht</translation>
    </message>
    <message>
        <source>terms: r⁺ = Σ of terms above 0; sum: r⁺ = max(r, 0), r⁻ = min(r, 0)</source>
        <translation>termen: r⁺ = Σ van termen boven 0; som: r⁺ = max(r, 0), r⁻ = min(r, 0)</translation>
    </message>
    <message>
        <source>threshold = γ^n*·R_goal + Σ γ^k·R_time, k = 1 … n*</source>
        <translation>drempel = γ^n*·R_doel + Σ γ^k·R_tijd, k = 1 … n*</translation>
    </message>
    <message>
        <source>tile width = 1/(resolution·scale)</source>
        <translation>tegelbreedte = 1/(resolutie·schaal)</translation>
    </message>
    <message>
        <source>tile width = span/(resolution·scale)</source>
        <translation>tegelbreedte = bereik/(resolutie·schaal)</translation>
    </message>
    <message>
        <source>tile width of the wheel rate = wheel span/(resolution·scale)</source>
        <translation>tegelbreedte van de wielsnelheid = wielbereik/(resolutie·schaal)</translation>
    </message>
    <message>
        <source>tile width, or spacing of centres = span/(resolution·scale)</source>
        <translation>tegelbreedte, of afstand van middelpunten = bereik/(resolutie·schaal)</translation>
    </message>
    <message>
        <source>torque = I·dω/dt</source>
        <translation>koppel = I·dω/dt</translation>
    </message>
    <message>
        <source>torque = J·dω/dt is taken by the rotor</source>
        <translation>koppel = J·dω/dt gaat naar de rotor</translation>
    </message>
    <message>
        <source>torque = η·k·G·I, I = (U − k·G·ω)/R</source>
        <translation>koppel = η·k·G·I, I = (U − k·G·ω)/R</translation>
    </message>
    <message>
        <source>torque = −F·sign(ω)</source>
        <translation>koppel = −F·sign(ω)</translation>
    </message>
    <message>
        <source>torque = −damping·ω beyond the stop</source>
        <translation>koppel = −demping·ω voorbij de aanslag</translation>
    </message>
    <message>
        <source>torque = −stiffness·(angle beyond the stop)</source>
        <translation>koppel = −stijfheid·(hoek voorbij de aanslag)</translation>
    </message>
    <message>
        <source>v → end as t grows: v = end for t ≥ T (linear), half as far at every T (exponential)</source>
        <translation>v → eind als t groeit: v = eind voor t ≥ T (lineair), na elke T half zo ver (exponentieel)</translation>
    </message>
    <message>
        <source>v(s) = (s − 10)/10 for the states s = 1 … 19</source>
        <translation>v(s) = (s − 10)/10 voor de toestanden s = 1 … 19</translation>
    </message>
    <message>
        <source>w = U[low, high]/n at the start, so that Q lies between low and high</source>
        <translation>w = U[laag, hoog]/n aan het begin, zodat Q tussen laag en hoog ligt</translation>
    </message>
    <message>
        <source>w ← w + α/n·δ·z for every weight w with trace z, n tilings</source>
        <translation>w ← w + α/n·δ·z voor elk gewicht w met trace z, n betegelingen</translation>
    </message>
    <message>
        <source>weight: π on Q − w·ρ; filter: among {a: ρ(s, a) ≤ limit}; losses: π on Q⁺ + k·Q⁻</source>
        <translation>gewicht: π op Q − w·ρ; filter: uit {a: ρ(s, a) ≤ grens}; verlies: π op Q⁺ + k·Q⁻</translation>
    </message>
    <message>
        <source>x_i = exp(−(s − c_i)²/(2σ²)), divided by Σ_i x_i</source>
        <translation>x_i = exp(−(s − c_i)²/(2σ²)), gedeeld door Σ_i x_i</translation>
    </message>
    <message>
        <source>z &lt; cut-off: z ← 0</source>
        <translation>z &lt; ondergrens: z ← 0</translation>
    </message>
    <message>
        <source>z ← γ·λ·z after every step</source>
        <translation>z ← γ·λ·z na elke stap</translation>
    </message>
    <message>
        <source>z ← γ·λ·z; z ← 1 for what was just visited</source>
        <translation>z ← γ·λ·z; z ← 1 voor wat net bezocht is</translation>
    </message>
    <message>
        <source>z ← γλz + (1 − αγλ·zᵀx)x;  w ← w + α(δ + Q − Q_old)z − α(Q − Q_old)x</source>
        <translation>z ← γλz + (1 − αγλ·zᵀx)x;  w ← w + α(δ + Q − Q_oud)z − α(Q − Q_oud)x</translation>
    </message>
    <message>
        <source>|stance angle| &gt; this: fallen</source>
        <translation>|hoek standbeen| &gt; dit: gevallen</translation>
    </message>
    <message>
        <source>|stance thigh| &gt; this: doomed to fall</source>
        <translation>|bovenbeen (stand)| &gt; dit: val onvermijdelijk</translation>
    </message>
    <message>
        <source>|swing angle| &gt; this: fallen</source>
        <translation>|hoek zwaaibeen| &gt; dit: gevallen</translation>
    </message>
    <message>
        <source>|torso| &gt; this: doomed to fall</source>
        <translation>|romp| &gt; dit: val onvermijdelijk</translation>
    </message>
    <message>
        <source>|α| ≤ angle and |α̇| ≤ rate: balanced</source>
        <translation>|α| ≤ hoek en |α̇| ≤ snelheid: in balans</translation>
    </message>
    <message>
        <source>|α| ≥ fall angle: fallen</source>
        <translation>|α| ≥ valhoek: gevallen</translation>
    </message>
    <message>
        <source>Δt = time of a step/substeps</source>
        <translation>Δt = tijd van een stap/deelstappen</translation>
    </message>
    <message>
        <source>Λ ← max(0, Λ + η·(falls − d)) after every episode</source>
        <translation>Λ ← max(0, Λ + η·(valpartijen − d)) na elke episode</translation>
    </message>
    <message>
        <source>δ = r + γ·max Q(s′, ·) − Q(s, a); after an action that is not greedy, z ← 0</source>
        <translation>δ = r + γ·max Q(s′, ·) − Q(s, a); na een actie die niet greedy is, z ← 0</translation>
    </message>
    <message>
        <source>δ ← (1 + κ)·δ if δ &lt; 0, else (1 − κ)·δ</source>
        <translation>δ ← (1 + κ)·δ als δ &lt; 0, anders (1 − κ)·δ</translation>
    </message>
    <message>
        <source>π among {a: ρ(s, a) ≤ limit}; where there is none, among the least risky</source>
        <translation>π uit {a: ρ(s, a) ≤ grens}; is er geen, uit de minst riskante</translation>
    </message>
    <message>
        <source>π(a outside A⁺) = ε·p/(n − |A⁺|), p the share below</source>
        <translation>π(a buiten A⁺) = ε·p/(n − |A⁺|), p het aandeel eronder</translation>
    </message>
    <message>
        <source>π(a) = (1 − ε)·[a is greedy] + ε/n</source>
        <translation>π(a) = (1 − ε)·[a is greedy] + ε/n</translation>
    </message>
    <message>
        <source>π(a) = (1 − ε)·greedy(a) + ε/n</source>
        <translation>π(a) = (1 − ε)·greedy(a) + ε/n</translation>
    </message>
    <message>
        <source>π(a) = (1 − ε)·greedy(a) + ε·(1 − p)/|A⁺| in A⁺ = {a: Q(s, a) &gt; threshold}, + ε·p/(n − |A⁺|) outside</source>
        <translation>π(a) = (1 − ε)·greedy(a) + ε·(1 − p)/|A⁺| in A⁺ = {a: Q(s, a) &gt; drempel}, + ε·p/(n − |A⁺|) daarbuiten</translation>
    </message>
    <message>
        <source>π(a) = 1/m for each of the m actions with Q(s, a) = max Q(s, ·), else 0</source>
        <translation>π(a) = 1/m voor elk van de m acties met Q(s, a) = max Q(s, ·), anders 0</translation>
    </message>
    <message>
        <source>π(a) = exp(β·Q(s, a))/Σ_b exp(β·Q(s, b)), β so that Σ π·Q = ln(Σ_b exp(ω·Q(s, b))/n)/ω</source>
        <translation>π(a) = exp(β·Q(s, a))/Σ_b exp(β·Q(s, b)), β zodat Σ π·Q = ln(Σ_b exp(ω·Q(s, b))/n)/ω</translation>
    </message>
    <message>
        <source>ρ = Pr(fall), a fall k steps later counting γᵏ</source>
        <translation>ρ = Pr(val), een val k stappen later telt γᵏ</translation>
    </message>
    <message>
        <source>ρ ← ρ + α·(target − ρ); target: 1 after a fall, 0 after another end, else γ·ρ(s′, a′)</source>
        <translation>ρ ← ρ + α·(doel − ρ); doel: 1 na een val, 0 na een ander eind, anders γ·ρ(s′, a′)</translation>
    </message>
    <message>
        <source>ρ(s, a) = initial where nothing is known</source>
        <translation>ρ(s, a) = beginwaarde waar niets bekend is</translation>
    </message>
    <message>
        <source>ρ(s, a) &gt; limit</source>
        <translation>ρ(s, a) &gt; grens</translation>
    </message>
    <message>
        <source>σ of a Gaussian = width·its own σ</source>
        <translation>σ van een gaussfunctie = breedte·eigen σ</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>snelheid</translation>
    </message>
    <message>
        <source>%1: %2 levels</source>
        <translation>%1: %2 niveaus</translation>
    </message>
    <message>
        <source>falls at once: hardly anything to learn from</source>
        <translation>valt meteen: er valt bijna niets te leren</translation>
    </message>
    <message>
        <source>falls soon, but not at once: it can learn</source>
        <translation>valt snel, maar niet meteen: kan leren</translation>
    </message>
    <message>
        <source>its program does not answer</source>
        <translation>het programma antwoordt niet</translation>
    </message>
    <message>
        <source>never falls: nothing to avoid</source>
        <translation>valt nooit: niets te vermijden</translation>
    </message>
    <message>
        <source>no ending is a fall</source>
        <translation>geen enkel einde is een val</translation>
    </message>
    <message>
        <source>step limit</source>
        <translation>stappenlimiet</translation>
    </message>
    <message>
        <source>A coarse value function that is learned first and shapes the rewards.</source>
        <translation>Een grove waardefunctie die eerst wordt geleerd en daarna de beloningen vormt.</translation>
    </message>
    <message>
        <source>A life</source>
        <translation>Een leven</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Acties</translation>
    </message>
    <message>
        <source>Begins another life: the table is made anew.</source>
        <translation>Begint een nieuw leven: de tabel wordt opnieuw gemaakt.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Opdrachten</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>Experimenten</translation>
    </message>
    <message>
        <source>Falls that are taken back.</source>
        <translation>Vallen die worden teruggedraaid.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Eerste stappen</translation>
    </message>
    <message>
        <source>Has an effect only with {0}.</source>
        <translation>Werkt alleen met {0}.</translation>
    </message>
    <message>
        <source>Holds at once.</source>
        <translation>Geldt meteen.</translation>
    </message>
    <message>
        <source>Holds from the next episode on.</source>
        <translation>Geldt vanaf de volgende episode.</translation>
    </message>
    <message>
        <source>How rewards are split for Sarsa_2Q</source>
        <translation>Hoe beloningen voor Sarsa_2Q worden gesplitst</translation>
    </message>
    <message>
        <source>How values are kept: tiles, radial basis functions, tables. Every state variable has a resolution of its own.</source>
        <translation>Hoe waarden worden bewaard: tegels, radiale basisfuncties, tabellen. Elke toestandsvariabele heeft een eigen resolutie.</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Leren</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lessen</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Methoden</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panelen</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameters</translation>
    </message>
    <message>
        <source>Policies</source>
        <translation>Policies</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Presets</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Vragen</translation>
    </message>
    <message>
        <source>Representation</source>
        <translation>Representatie</translation>
    </message>
    <message>
        <source>Rewards: {0}.</source>
        <translation>Beloningen: {0}.</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Scenario’s</translation>
    </message>
    <message>
        <source>Set one with {0}, in the form, or in a plan. A default can be another one in a world that says so; {1} and the form tell.</source>
        <translation>Stel er een in met {0}, in het formulier of in een plan. Een wereld kan een andere standaardwaarde opgeven; {1} en het formulier laten dat zien.</translation>
    </message>
    <message>
        <source>Shaping of rewards</source>
        <translation>Reward shaping</translation>
    </message>
    <message>
        <source>Source: {0}.</source>
        <translation>Bron: {0}.</translation>
    </message>
    <message>
        <source>The default is from: {0}.</source>
        <translation>De standaardwaarde komt uit: {0}.</translation>
    </message>
    <message>
        <source>The learning and the representation of the expected gains.</source>
        <translation>Het leren en de representatie van de verwachte winsten.</translation>
    </message>
    <message>
        <source>The learning and the representation of the expected losses.</source>
        <translation>Het leren en de representatie van de verwachte verliezen.</translation>
    </message>
    <message>
        <source>The probability that an action ends in a fall, learned beside the values.</source>
        <translation>De kans dat een actie in een val eindigt, geleerd naast de waarden.</translation>
    </message>
    <message>
        <source>The risk of a fall</source>
        <translation>Het valrisico</translation>
    </message>
    <message>
        <source>The window</source>
        <translation>Het venster</translation>
    </message>
    <message>
        <source>What the learning rules have in common.</source>
        <translation>Wat de leerregels gemeen hebben.</translation>
    </message>
    <message>
        <source>What the policies have, with their schedules and what they do with the risk of a fall.</source>
        <translation>Wat de policies hebben, met hun verloop en wat ze met het valrisico doen.</translation>
    </message>
    <message>
        <source>Which part of a reward is a gain and which a loss.</source>
        <translation>Welk deel van een beloning winst is en welk deel verlies.</translation>
    </message>
    <message>
        <source>Without a window</source>
        <translation>Zonder venster</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Begrippen</translation>
    </message>
    <message>
        <source>Worlds</source>
        <translation>Werelden</translation>
    </message>
    <message>
        <source>Your own robot</source>
        <translation>Je eigen robot</translation>
    </message>
    <message>
        <source>and</source>
        <translation>en</translation>
    </message>
    <message>
        <source>of Sarsa_2Q</source>
        <translation>van Sarsa_2Q</translation>
    </message>
    <message>
        <source>one of {0}; default {1}.</source>
        <translation>{0}; standaard {1}.</translation>
    </message>
    <message>
        <source>or</source>
        <translation>of</translation>
    </message>
    <message>
        <source>{0} actions</source>
        <translation>{0} acties</translation>
    </message>
    <message>
        <source>{0} … {1}; default {2}.</source>
        <translation>{0} … {1}; standaard {2}.</translation>
    </message>
    <message>
        <source>Handbook</source>
        <translation>Handboek</translation>
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
        <translation>**Q(S, A)** is wat hij verwacht van actie A in toestand S; in het begin 0. Een stap corrigeert één waarde met **α δ**, met α = 0,5. De verrassing, of TD-fout, is **δ = R + γ Q(S′, A′) − Q(S, A)**: R is de beloning, S′ en A′ zijn de volgende toestand en actie. Kijk tot het eerste doel.</translation>
    </message>
    <message>
        <source>**Sarsa** learns from what it does: it values a step by the step that it really takes next, also a random one. It learns for 500 episodes with ε = 0.1. Then exploring and learning stop, and the steps of its way are counted. The short way has 13, the long one 17.</source>
        <translation>**Sarsa** leert van wat hij doet: hij waardeert een stap naar de stap die hij daarna echt doet, ook een willekeurige. Hij leert 500 episodes met ε = 0,1. Dan stoppen exploreren en leren, en worden de stappen van zijn weg geteld. De korte heeft er 13, de lange 17.</translation>
    </message>
    <message>
        <source>**TRL**, threshold-restricted learning, explores as often as ε-greedy with the same ε: here in one step of five. But then it draws almost only among the actions that are worth more than a threshold. Drag the line across the bars, and watch how likely each action is.</source>
        <translation>**TRL**, threshold-restricted learning, exploreert even vaak als ε-greedy met dezelfde ε: hier in één op de vijf stappen. Maar dan loot het bijna alleen tussen de acties die meer waard zijn dan een drempel. Sleep de lijn over de balken, en kijk hoe waarschijnlijk elke actie is.</translation>
    </message>
    <message>
        <source>**Tile coding** lays 16 grids over each other, each displaced a little; a value is the sum over 16 tiles. Here each of the 16 has resolution 1. Compare it with one grid of resolution 2. Ten lives of each, six minutes from nothing.</source>
        <translation>**Tile coding** legt 16 roosters over elkaar, elk een beetje verschoven; een waarde is de som over 16 tegels. Hier heeft elk van de 16 resolutie 1. Vergelijk het met één rooster van resolutie 2. Van elk tien levens, zes minuten vanaf nul.</translation>
    </message>
    <message>
        <source>**{observed(5)} falls** in ten minutes with ε = 0.05. Now the same again, from the same knowledge, but **greedy**: it always takes the action that it thinks best, and still learns.</source>
        <translation>**{observed(5)} valpartijen** in tien minuten met ε = 0,05. Nu hetzelfde nog eens, met dezelfde kennis, maar **greedy**: hij neemt altijd de actie die hij het beste vindt, en leert nog steeds.</translation>
    </message>
    <message>
        <source>0.98 to the power of 35 is about one half; 70 is twice 35.</source>
        <translation>0,98 tot de macht 35 is ongeveer de helft; 70 is twee keer 35.</translation>
    </message>
    <message>
        <source>16 grids of 1</source>
        <translation>16 roosters van 1</translation>
    </message>
    <message>
        <source>2.5 times the torque is a larger error than half the torque. The fair comparison for half is **twice**. Ten lives of each, after simulations with × 0.5 and with × 2.</source>
        <translation>2,5 keer het koppel is een grotere fout dan half het koppel. De eerlijke vergelijking voor de helft is **het dubbele**. Van elk tien levens, na simulaties met × 0,5 en met × 2.</translation>
    </message>
    <message>
        <source>5 of 100 are 1 of 20.</source>
        <translation>5 van 100 is 1 op 20.</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>A **trace** marks each step, and a step learns in proportion to its mark. With every later step all marks are multiplied by γ λ, here 0.9 · 0.9 = 0.81. The same walk, with the trace: the last step loses 50. The step before it was *left* from state 3.</source>
        <translation>Een **trace** geeft elke stap een merkteken, en een stap leert in verhouding tot de sterkte daarvan. Bij elke volgende stap worden alle merktekens vermenigvuldigd met γ λ, hier 0,9 · 0,9 = 0,81. Dezelfde wandeling, nu met de trace: de laatste stap verliest 50. De stap ervoor was *links* vanuit toestand 3.</translation>
    </message>
    <message>
        <source>A Sarsa without random steps takes the short way, too. There is another remedy: Q-learning again, with ε = 0.1, which fell {observed(4)} times. Beside its values it now learns **ρ**, how likely an action ends in a fall, and a random step may only take actions whose risk is at most 20 %.</source>
        <translation>Ook een Sarsa zonder willekeurige stappen neemt de korte weg. Er is nog een middel: weer Q-learning, met ε = 0,1, die {observed(4)} keer viel. Naast zijn waarden leert hij nu **ρ**, de kans dat een actie in een val eindigt, en een willekeurige stap mag alleen acties nemen met een risico van hoogstens 20 %.</translation>
    </message>
    <message>
        <source>A detour costs nothing: left is worth 100 · γ = 100, as much as right.</source>
        <translation>Een omweg kost niets: links is 100 · γ = 100 waard, net zoveel als rechts.</translation>
    </message>
    <message>
        <source>A fair comparison: with greedy, and with a smaller ε.</source>
        <translation>Een eerlijke vergelijking: met greedy, en met een kleinere ε.</translation>
    </message>
    <message>
        <source>A fall teaches only the few states in its own tiles.</source>
        <translation>Een val leert alleen de weinige toestanden in zijn eigen tegels iets.</translation>
    </message>
    <message>
        <source>A full turn has 360°. Into how many tiles is it cut?</source>
        <translation>Een hele omwenteling heeft 360°. In hoeveel tegels is ze verdeeld?</translation>
    </message>
    <message>
        <source>A full turn has 360°. There are 0.4 times as many tiles.</source>
        <translation>Een hele omwenteling heeft 360°. Er zijn 0,4 keer zoveel tegels.</translation>
    </message>
    <message>
        <source>A goal is shared out like a fall. First without a trace, **λ = 0**, from the beginning. The robot lives until two things hold: it stands on state 5, five steps from the goal, and *right* is worth more than 0 there.</source>
        <translation>Een doel wordt net zo verdeeld als een val. Eerst zonder trace, **λ = 0**, vanaf het begin. De robot leeft tot twee dingen gelden: hij staat op toestand 5, vijf stappen van het doel, en *rechts* is daar meer dan 0 waard.</translation>
    </message>
    <message>
        <source>A life with more chance</source>
        <translation>Een leven met meer toeval</translation>
    </message>
    <message>
        <source>A limit on the risk of a fall</source>
        <translation>Een grens aan het valrisico</translation>
    </message>
    <message>
        <source>A line you drag</source>
        <translation>Een lijn die je sleept</translation>
    </message>
    <message>
        <source>A loss is expected sooner. Can it also be expected where there is no danger?</source>
        <translation>Een verlies wordt eerder verwacht. Kan het ook verwacht worden waar geen gevaar is?</translation>
    </message>
    <message>
        <source>A loss should be expected also near the place of a fall: wide tiles spread it. The goal is small, and what leads to it has to be told apart finely, or it is reached less often. Tiles that are too wide spread the loss even to the upright pole.</source>
        <translation>Een verlies moet ook in de buurt van een val worden verwacht: brede tegels verspreiden het. Het doel is klein, en wat ernaartoe leidt moet fijn onderscheiden worden, anders wordt het minder vaak bereikt. Te brede tegels verspreiden het verlies zelfs tot de stok die rechtop staat.</translation>
    </message>
    <message>
        <source>A mark on the curve is a fall; a click plays it back.</source>
        <translation>Een streepje op de curve is een val; een klik speelt hem terug.</translation>
    </message>
    <message>
        <source>A narrower interval, of 99 %.</source>
        <translation>Een smaller interval, van 99 %.</translation>
    </message>
    <message>
        <source>A paper reports the best of five runs. What is wrong with that?</source>
        <translation>Een artikel meldt de beste van vijf runs. Wat is daar mis mee?</translation>
    </message>
    <message>
        <source>A place it knows nothing about</source>
        <translation>Een plek waar hij niets van weet</translation>
    </message>
    <message>
        <source>A pole is hinged to a cart. 200 times a second the robot chooses one of five torques (turning forces) for the cart&apos;s wheel; the arrow shows it. An **episode** ends when the pole stands upright and still, or when it has fallen. This robot has learned nothing yet. Slow it down with the pace.</source>
        <translation>Op een karretje zit een stok met een scharnier. 200 keer per seconde kiest de robot een van vijf koppels (draaikrachten) voor het wiel van het karretje; de pijl laat het zien. Een **episode** eindigt als de stok rechtop stilstaat, of als hij gevallen is. Deze robot heeft nog niets geleerd. Vertraag hem met het tempo.</translation>
    </message>
    <message>
        <source>A pole on a cart, and a program that has never seen one. You watch it, take the pole in your hand, say how often it will fall, and look at its falls again.</source>
        <translation>Een stok op een karretje, en een programma dat er nog nooit een gezien heeft. Je kijkt toe, pakt de stok zelf vast, zegt hoe vaak hij zal vallen en bekijkt zijn valpartijen nog eens.</translation>
    </message>
    <message>
        <source>A pole that is upright but moves fast leans a moment later. Where it is and how fast it moves both count.</source>
        <translation>Een stok die rechtop staat maar snel beweegt, staat even later scheef. Waar hij is en hoe snel hij beweegt, tellen allebei.</translation>
    </message>
    <message>
        <source>A pole that leans by 1° shares its tile with one that leans by 50° to the same side: wide tiles tell little apart. It fell {observed(1)} times. Now the resolution is **8**, a tile 3.75° wide. Again two minutes from nothing.</source>
        <translation>Een stok die 1° helt deelt zijn tegel met een die 50° naar dezelfde kant helt: brede tegels onderscheiden weinig. Hij viel {observed(1)} keer. Nu is de resolutie **8**, een tegel 3,75° breed. Weer twee minuten vanaf nul.</translation>
    </message>
    <message>
        <source>A reward that lies further away counts less: with each step that it is further away it is multiplied by **γ** (gamma), here 0.9. From state 9 one step gives 100, so state 9 is worth 100. State 8 lies one step further away: 0.9 · 100 = 90. The robot stands on state 6.</source>
        <translation>Een beloning die verder weg ligt telt minder: met elke stap verder wordt ze vermenigvuldigd met **γ** (gamma), hier 0,9. Vanuit toestand 9 geeft één stap 100, dus toestand 9 is 100 waard. Toestand 8 ligt een stap verder: 0,9 · 100 = 90. De robot staat op toestand 6.</translation>
    </message>
    <message>
        <source>A robot can try any action now and then, or take the better ones more often. The second way has one knob, the temperature. You turn it, let both ways explore equally often, and count their falls.</source>
        <translation>Een robot kan af en toe wat dan ook proberen, of de betere acties vaker nemen. De tweede manier heeft één knop, de temperatuur. Je draait eraan, laat beide manieren even vaak exploreren en telt hun valpartijen.</translation>
    </message>
    <message>
        <source>A robot cannot try every state. It cuts them into tiles and learns values for each. How wide should a tile be? You try both ends, look for the middle, and then see a way out.</source>
        <translation>Een robot kan niet elke toestand proberen. Hij verdeelt ze in tegels en leert waarden voor elke tegel. Hoe breed moet een tegel zijn? Je probeert beide uitersten, zoekt het midden en ziet dan een uitweg.</translation>
    </message>
    <message>
        <source>A robot falls. Which of its steps was to blame: the last one, or those that led there? λ shares the blame out. You work out one share, find a step that is blamed wrongly, and see what the sharing is good for.</source>
        <translation>Een robot valt. Welke stap was schuldig: de laatste, of die ernaartoe leidden? λ verdeelt de schuld. Je rekent één deel uit, vindt een stap die ten onrechte de schuld krijgt, en ziet waar het verdelen goed voor is.</translation>
    </message>
    <message>
        <source>A robot has fallen many times and still expects no loss just before the next fall. Give its losses a Q-function of their own, and choose how far from a fall it is felt.</source>
        <translation>Een robot is al vaak gevallen en verwacht vlak voor de volgende val nog steeds geen verlies. Geef zijn verlies een eigen Q-functie, en kies hoe ver van een val die te voelen is.</translation>
    </message>
    <message>
        <source>A robot that cannot walk</source>
        <translation>Een robot die niet kan lopen</translation>
    </message>
    <message>
        <source>A robot that has learned in a simulation meets reality. It still tries something else now and then. How often is that good for it?</source>
        <translation>Een robot die in een simulatie geleerd heeft, komt in de werkelijkheid. Af en toe probeert hij nog iets anders. Hoe vaak is dat goed voor hem?</translation>
    </message>
    <message>
        <source>A robot that knows nothing learns in reality for 200 episodes. Look how often it falls; each fall may break something. In a simulation nothing breaks. So let it fall there first.</source>
        <translation>Een robot die niets weet, leert 200 episodes in de werkelijkheid. Kijk hoe vaak hij valt; bij elke val kan iets stukgaan. In een simulatie gaat niets stuk. Laat hem dus eerst daar vallen.</translation>
    </message>
    <message>
        <source>A rule of thumb</source>
        <translation>Een vuistregel</translation>
    </message>
    <message>
        <source>A second thing to learn</source>
        <translation>Nog iets om te leren</translation>
    </message>
    <message>
        <source>A share of the blame</source>
        <translation>Een deel van de schuld</translation>
    </message>
    <message>
        <source>A simulation with strong motors</source>
        <translation>Een simulatie met sterke motoren</translation>
    </message>
    <message>
        <source>A simulation with weak motors</source>
        <translation>Een simulatie met zwakke motoren</translation>
    </message>
    <message>
        <source>A step costs 1 for both of them.</source>
        <translation>Een stap kost voor beide 1.</translation>
    </message>
    <message>
        <source>A step that is blamed</source>
        <translation>Een stap die de schuld krijgt</translation>
    </message>
    <message>
        <source>A threshold of 50</source>
        <translation>Een drempel van 50</translation>
    </message>
    <message>
        <source>A tile of Q⁻ is 124° wide now. What else is in the tile in which it fell?</source>
        <translation>Een tegel van Q⁻ is nu 124° breed. Wat ligt er nog meer in de tegel waarin hij viel?</translation>
    </message>
    <message>
        <source>A torque to the right pushes the cart to the right, under a pole that leans to the right.</source>
        <translation>Een koppel naar rechts duwt het karretje naar rechts, onder een stok die naar rechts helt.</translation>
    </message>
    <message>
        <source>A trace knows how long ago a step was taken, not whether it was to blame.</source>
        <translation>Een trace weet hoe lang geleden een stap was, niet of hij schuld had.</translation>
    </message>
    <message>
        <source>A value with a small α is a mean over many steps; with a large one the last few steps decide.</source>
        <translation>Een waarde met een kleine α is een gemiddelde over veel stappen; met een grote beslissen de laatste paar.</translation>
    </message>
    <message>
        <source>A, thirty</source>
        <translation>A, dertig</translation>
    </message>
    <message>
        <source>About the same.</source>
        <translation>Ongeveer hetzelfde.</translation>
    </message>
    <message>
        <source>Above the line</source>
        <translation>Boven de lijn</translation>
    </message>
    <message>
        <source>After 100 episodes it is {observed(5)}: what comes is what it expects, and the value stays. α decides how quickly it gets there. Turn α, and start again after each try. With the same **seed** chance is the same, so the robot walks to its first goal in the same way.</source>
        <translation>Na 100 episodes is het {observed(5)}: er komt wat hij verwacht, en de waarde blijft. α bepaalt hoe snel het zover is. Draai aan α, en begin na elke poging opnieuw. Met dezelfde **seed** is het toeval hetzelfde, dus loopt de robot op dezelfde manier naar zijn eerste doel.</translation>
    </message>
    <message>
        <source>After 200 episodes</source>
        <translation>Na 200 episodes</translation>
    </message>
    <message>
        <source>After half the torque it fell less often than after twice the torque. Is weaker always better? Three more simulations: 0.3, 0.8 and 1.5 times the real torque.</source>
        <translation>Na half het koppel viel hij minder dan na het dubbele. Is zwakker altijd beter? Nog drie simulaties: 0,3, 0,8 en 1,5 keer het echte koppel.</translation>
    </message>
    <message>
        <source>All actions of a state share what happens there.</source>
        <translation>Alle acties van een toestand delen wat daar gebeurt.</translation>
    </message>
    <message>
        <source>All learning here is one small correction, made after every step. You work it out by hand twice, with easy numbers, and then let the robot do it. Then you turn α, the size of the correction.</source>
        <translation>Al het leren is hier één kleine correctie, na elke stap. Die reken je twee keer met de hand uit, met makkelijke getallen, en daarna laat je het aan de robot over. Dan draai je aan α, de grootte van de correctie.</translation>
    </message>
    <message>
        <source>All ten lives of Q-learning walk along the edge, all ten of Sarsa keep off it. For a robot that makes no mistakes the short way is better. But while they learn, both take one step in ten at random. This Sarsa fell {falls} times in its 500 episodes.</source>
        <translation>Alle tien levens van Q-learning lopen langs de rand, alle tien van Sarsa blijven eraf. Voor een robot die geen fouten maakt is de korte weg beter. Maar terwijl ze leren, doen beide één op de tien stappen willekeurig. Deze Sarsa viel {falls} keer in zijn 500 episodes.</translation>
    </message>
    <message>
        <source>All values were 0. What is Q(3, left) after the fall?</source>
        <translation>Alle waarden waren 0. Hoe groot is Q(3, links) na de val?</translation>
    </message>
    <message>
        <source>Among how many actions does it choose each time?</source>
        <translation>Uit hoeveel acties kiest hij elke keer?</translation>
    </message>
    <message>
        <source>An action that is worth τ less than the best is taken 2.7 times less often; one worth 2τ less, 7.4 times. Before, the second best was worth {observed(1)} less. Now the pole leans by 14° and is at rest: the best is worth {q(&quot;1.5&quot;)}, the second best {max(q(&quot;0.75&quot;), q(&quot;0&quot;))}.</source>
        <translation>Een actie die τ minder waard is dan de beste, wordt 2,7 keer minder vaak gekozen; een die 2τ minder waard is, 7,4 keer minder vaak. Daarnet was de op een na beste {observed(1)} minder waard. Nu helt de stok 14° en is in rust: de beste is {q(&quot;1.5&quot;)} waard, de op een na beste {max(q(&quot;0.75&quot;), q(&quot;0&quot;))}.</translation>
    </message>
    <message>
        <source>An action with a risk of 1 in 100 now counts 30 less.</source>
        <translation>Een actie met een risico van 1 op 100 telt nu 30 minder.</translation>
    </message>
    <message>
        <source>An interval of 99 % is wider, and the difference is not what is in doubt.</source>
        <translation>Een interval van 99 % is breder, en aan het verschil wordt niet getwijfeld.</translation>
    </message>
    <message>
        <source>Another robot</source>
        <translation>Een andere robot</translation>
    </message>
    <message>
        <source>As far-sighted as can be</source>
        <translation>Zo verziend als het kan</translation>
    </message>
    <message>
        <source>As long as it explores near something that can break it: Sarsa, because it counts its own random steps and keeps away. If it can learn where falls cost nothing, and afterwards stops exploring: Q-learning, whose way is shorter.</source>
        <translation>Zolang hij exploreert bij iets dat hem kapot kan maken: Sarsa, omdat die zijn eigen willekeurige stappen meetelt en wegblijft. Als hij kan leren waar vallen niets kost, en daarna stopt met exploreren: Q-learning, want die weg is korter.</translation>
    </message>
    <message>
        <source>As short-sighted as can be</source>
        <translation>Zo kortzichtig als het kan</translation>
    </message>
    <message>
        <source>Ask for a show of hands before every answer. In step 1 expect votes for A. Say openly how the numbers were come by: the seed of B was looked for among 28 (3 of them differ from A by more than 3.5 falls in five lives; no interval left out 0). Seed 1 was taken for all else because it shows how five lives go wrong both ways. In the seeds 1 to 60 five lives gave an interval without 0 for Softmax against greedy twice, thirty lives four times (always for greedy); ε 0.05 against Softmax left out 0 with thirty lives in all 60, with five in 23. Step 7: in 8 seeds ten pairs told ε 0.05 from 0.1 in 6, ten against ten others in 2; with twenty it was 8 and 3. The interval is that of the mean difference of life k and life k, by Student&apos;s t.</source>
        <translation>Laat vóór elk antwoord handen opsteken. Verwacht in stap 1 stemmen voor A. Zeg eerlijk hoe de getallen tot stand kwamen: de seed van B is uit 28 gezocht (3 daarvan verschillen in vijf levens meer dan 3,5 valpartijen van A; geen interval sloot de 0 uit). Seed 1 is voor al het andere genomen omdat hij laat zien hoe vijf levens naar beide kanten misgaan. In de seeds 1 tot en met 60 gaven vijf levens voor Softmax tegen greedy twee keer een interval zonder 0, dertig levens vier keer (altijd voor greedy); ε 0,05 tegen Softmax sloot met dertig levens in alle 60 de 0 uit, met vijf in 23. Stap 7: in 8 seeds onderscheidden tien paren ε 0,05 van 0,1 in 6, tien tegen tien andere in 2; met twintig waren het er 8 en 3. Het interval is dat van het gemiddelde verschil van leven k en leven k, volgens Students t.</translation>
    </message>
    <message>
        <source>At least four steps in five take the best action, wherever the line lies.</source>
        <translation>Minstens vier op de vijf stappen nemen de beste actie, waar de lijn ook ligt.</translation>
    </message>
    <message>
        <source>At which value of Q(9, right) is δ = 100 − Q(9, right) zero?</source>
        <translation>Bij welke waarde van Q(9, rechts) is δ = 100 − Q(9, rechts) nul?</translation>
    </message>
    <message>
        <source>At which τ would the second best be taken 2.7 times less often than the best, here?</source>
        <translation>Bij welke τ zou de op een na beste hier 2,7 keer minder vaak worden gekozen dan de beste?</translation>
    </message>
    <message>
        <source>Average falls in six minutes: all fine {mean(&quot;Q⁻ 1&quot;)}; only Q⁻ coarse {mean(&quot;only Q⁻ coarse&quot;)}; both coarse {mean(&quot;both coarse&quot;)}; Q⁻ far too coarse {mean(&quot;Q⁻ 0.1&quot;)}. Goals reached in three minutes: only Q⁻ coarse {mean(&quot;goals, only Q⁻ coarse&quot;)}, both coarse {mean(&quot;goals, both coarse&quot;)}.</source>
        <translation>Gemiddeld aantal valpartijen in zes minuten: alles fijn {mean(&quot;Q⁻ 1&quot;)}; alleen Q⁻ grof {mean(&quot;only Q⁻ coarse&quot;)}; beide grof {mean(&quot;both coarse&quot;)}; Q⁻ veel te grof {mean(&quot;Q⁻ 0.1&quot;)}. Bereikte doelen in drie minuten: alleen Q⁻ grof {mean(&quot;goals, only Q⁻ coarse&quot;)}, beide grof {mean(&quot;goals, both coarse&quot;)}.</translation>
    </message>
    <message>
        <source>Average falls in six minutes: one grid of resolution 2, {mean(&quot;one grid of 2&quot;)}; 16 displaced grids of resolution 1, {mean(&quot;16 grids of 1&quot;)}.</source>
        <translation>Gemiddeld aantal valpartijen in zes minuten: één rooster van resolutie 2, {mean(&quot;one grid of 2&quot;)}; 16 verschoven roosters van resolutie 1, {mean(&quot;16 grids of 1&quot;)}.</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B, thirty</source>
        <translation>B, dertig</translation>
    </message>
    <message>
        <source>Because only falls teach where falls are. A robot that is careful in the simulation sees few of them, and its risk is wrong in the places where it never was. In simulation falls are information that costs nothing; in reality they cost.</source>
        <translation>Omdat een robot alleen door te vallen leert waar hij valt. Is hij in de simulatie voorzichtig, dan ziet hij weinig valpartijen, en zijn risico klopt niet op de plekken waar hij nooit was. In de simulatie zijn valpartijen informatie die niets kost; in de werkelijkheid kosten ze.</translation>
    </message>
    <message>
        <source>Before the next fall</source>
        <translation>Voor de volgende val</translation>
    </message>
    <message>
        <source>Below all values it forbids nothing; above all values it has nothing to allow.</source>
        <translation>Onder alle waarden verbiedt hij niets; boven alle waarden heeft hij niets toe te staan.</translation>
    </message>
    <message>
        <source>Between which two temperatures does the share pass 8?</source>
        <translation>Tussen welke twee temperaturen gaat het aandeel door 8?</translation>
    </message>
    <message>
        <source>Bold in both worlds</source>
        <translation>Dapper in beide werelden</translation>
    </message>
    <message>
        <source>Bold in simulation, careful in reality</source>
        <translation>Dapper in de simulatie, voorzichtig in de werkelijkheid</translation>
    </message>
    <message>
        <source>Both are worth 0: with γ = 0 nothing of the goal reaches these states, and so it tosses a coin.</source>
        <translation>Beide zijn 0 waard: met γ = 0 bereikt niets van het doel deze toestanden, en dus gooit hij kop of munt.</translation>
    </message>
    <message>
        <source>Both are wrong about this state, but only one of the two errors is a warning.</source>
        <translation>Beide hebben het over deze toestand mis, maar slechts één van de twee fouten is een waarschuwing.</translation>
    </message>
    <message>
        <source>Both begin with what the same simulation has taught them.</source>
        <translation>Beide beginnen met wat dezelfde simulatie ze geleerd heeft.</translation>
    </message>
    <message>
        <source>Both explore equally often. Which falls less?</source>
        <translation>Beide exploreren even vaak. Welke valt minder?</translation>
    </message>
    <message>
        <source>Both learned for ten minutes.</source>
        <translation>Beide leerden tien minuten.</translation>
    </message>
    <message>
        <source>Both leave the best action about equally often; τ was chosen so.</source>
        <translation>Beide wijken ongeveer even vaak van de beste actie af; τ is zo gekozen.</translation>
    </message>
    <message>
        <source>Both leave the best action equally often. The left robot then does just anything, even what makes it fall. The right one seldom does what it knows to be bad.</source>
        <translation>Beide wijken even vaak van de beste actie af. De linker robot doet dan wat dan ook, zelfs wat hem laat vallen. De rechter doet zelden iets waarvan hij weet dat het slecht is.</translation>
    </message>
    <message>
        <source>Both take an action other than the best in about 8 of 100 steps. Why does Softmax fall less?</source>
        <translation>Beide nemen in ongeveer 8 van 100 stappen een andere actie dan de beste. Waarom valt Softmax minder?</translation>
    </message>
    <message>
        <source>By how much is the second best worth less than the best?</source>
        <translation>Hoeveel minder waard is de op een na beste dan de beste?</translation>
    </message>
    <message>
        <source>Can the widest tiles tell a pole at 1° from one at 50°?</source>
        <translation>Kunnen de breedste tegels een stok op 1° onderscheiden van een op 50°?</translation>
    </message>
    <message>
        <source>Careful by the risk.</source>
        <translation>Voorzichtig door het risico.</translation>
    </message>
    <message>
        <source>Choose α so that Q(9, right) is 100 after a single goal, and let the robot come to state 9 again.</source>
        <translation>Kies α zo dat Q(9, rechts) na één doel 100 is, en laat de robot nog eens op toestand 9 komen.</translation>
    </message>
    <message>
        <source>Click a fall among the last twenty episodes, and watch the arrow.</source>
        <translation>Klik op een val in de laatste twintig episodes, en let op de pijl.</translation>
    </message>
    <message>
        <source>Click a state about which it has learned nothing.</source>
        <translation>Klik op een toestand waarover hij niets geleerd heeft.</translation>
    </message>
    <message>
        <source>Click a state that is still worth more than 0 with γ = 0.</source>
        <translation>Klik op een toestand die ook met γ = 0 nog meer dan 0 waard is.</translation>
    </message>
    <message>
        <source>Coarser is not always better. Try values between 0.2 and 0.35.</source>
        <translation>Grover is niet altijd beter. Probeer waarden tussen 0,2 en 0,35.</translation>
    </message>
    <message>
        <source>Coarser still</source>
        <translation>Nog grover</translation>
    </message>
    <message>
        <source>Compare each life with the one of the same seed: how many go the other way?</source>
        <translation>Vergelijk elk leven met dat van dezelfde seed: hoeveel gaan de andere kant op?</translation>
    </message>
    <message>
        <source>Compare the line at −100, at 80 and at 200.</source>
        <translation>Vergelijk de lijn op −100, op 80 en op 200.</translation>
    </message>
    <message>
        <source>Could the robot use a large α at first and a small one later?</source>
        <translation>Kan de robot eerst een grote en later een kleine α gebruiken?</translation>
    </message>
    <message>
        <source>Could weak motors bring the pole up from 29° as well as strong ones?</source>
        <translation>Zouden zwakke motoren de stok vanaf 29° even goed rechtop krijgen als sterke?</translation>
    </message>
    <message>
        <source>Do step 2 and 3 on the board, with everybody&apos;s numbers. Errors to expect: to add the whole surprise (100 instead of 75), and in step 3 to forget γ (37.5) or to forget α (60).

The first walk is the same for all: from state 2 to the goal in eight steps. Only its last step teaches anything; the next lesson asks whether that must be so.

Step 4 shows who thinks that values hang together. They are separate numbers, and each is corrected only when its own step is taken.

Step 7: the 20 lives have the same seeds for both α. The rule is Sarsa: A′ is the action that is really taken next, so half of the time it is drawn at random. The measure is Q(8, right) when learning has stopped: for this each life is put on state 7 and goes one step.</source>
        <translation>Doe stap 2 en 3 op het bord, met ieders getallen. Te verwachten fouten: de hele verrassing optellen (100 in plaats van 75), en in stap 3 γ vergeten (37,5) of α vergeten (60).

De eerste wandeling is voor iedereen dezelfde: van toestand 2 in acht stappen naar het doel. Alleen van de laatste stap leert hij iets; de volgende les vraagt of dat zo moet zijn.

Stap 4 laat zien wie denkt dat waarden aan elkaar vastzitten. Het zijn losse getallen, en elk wordt alleen gecorrigeerd als zijn eigen stap wordt gedaan.

Stap 7: de 20 levens hebben voor beide α dezelfde seeds. De regel is Sarsa: A′ is de actie die hierna echt wordt gedaan, dus de helft van de keren is ze geloot. De maat is Q(8, rechts) wanneer het leren gestopt is: daarvoor wordt elk leven op toestand 7 gezet en doet het één stap.</translation>
    </message>
    <message>
        <source>Does that help? First six minutes of learning from nothing, with the same resolution 1 for both. Two such Q-functions act like a single one.</source>
        <translation>Helpt dat? Eerst zes minuten leren vanaf nul, met voor beide dezelfde resolutie 1. Twee zulke Q-functies doen hetzelfde als één.</translation>
    </message>
    <message>
        <source>Each episode ends in one of two ways. Which of the two is easier to reach by chance?</source>
        <translation>Elke episode eindigt op een van twee manieren. Welke van de twee is door toeval makkelijker te bereiken?</translation>
    </message>
    <message>
        <source>Each motor has seven voltages, whatever the others do.</source>
        <translation>Elke motor heeft zeven spanningen, wat de andere ook doen.</translation>
    </message>
    <message>
        <source>Each step corrects one value, that of the step just taken. Look at the last step.</source>
        <translation>Elke stap corrigeert één waarde, die van de stap die net is gedaan. Kijk naar de laatste stap.</translation>
    </message>
    <message>
        <source>Each step now costs 1. Is γ = 1 still a bad choice?</source>
        <translation>Elke stap kost nu 1. Is γ = 1 dan nog een slechte keuze?</translation>
    </message>
    <message>
        <source>Each tile has to be learned by itself, and a fall is what teaches a bad one.</source>
        <translation>Elke tegel moet apart worden geleerd, en een slechte leert men door een val.</translation>
    </message>
    <message>
        <source>Every step costs 1. A step into the cliff costs 100 and leads back to the start. The short way, along the edge, has 13 steps; the long way, along the top, has 17. The robot has lived 20 episodes. A click on the map puts it on a square.</source>
        <translation>Elke stap kost 1. Een stap de afgrond in kost 100 en leidt terug naar het begin. De korte weg, langs de rand, heeft 13 stappen; de lange, bovenlangs, 17. De robot heeft 20 episodes geleefd. Met een klik op de kaart zet je hem op een vakje.</translation>
    </message>
    <message>
        <source>Every student has a seed of his own, so the numbers differ a little. Expect to hear that narrow tiles are better because they are more exact; let them vote before step 2. In step 4 1, 2 and 4 all do: in 90 lives they fell 202 to 386 times in six minutes, 0.25 463 to 659 times. Ask for the winner by falls in two minutes (1) and after three more (4): there is no best width without saying when. Measured with the seeds 1 to 10, ten lives each: first two minutes 0.25 186 to 200 falls, 1 118 to 137, 4 173 to 196, 8 329 to 345; after three minutes of learning (seeds 1 to 7) 178 to 193, 75 to 90, 44 to 58, 140 to 154. Six minutes: one grid of 2 248 to 287, 16 grids of 1 190 to 218; the interval said so in 10 of 10. In six minutes one grid of 1 or 4 falls about as often as one of 2.</source>
        <translation>Elke student heeft een eigen seed, dus de getallen verschillen een beetje. Verwacht te horen dat smalle tegels beter zijn omdat ze nauwkeuriger zijn; laat ze vóór stap 2 stemmen. In stap 4 voldoen 1, 2 en 4: in 90 levens vielen ze in zes minuten 202 tot 386 keer, 0,25 463 tot 659 keer. Vraag naar de winnaar naar valpartijen in twee minuten (1) en na nog drie (4): er is geen beste breedte zonder te zeggen wanneer. Gemeten met de seeds 1 tot en met 10, elk tien levens: eerste twee minuten 0,25 186 tot 200 valpartijen, 1 118 tot 137, 4 173 tot 196, 8 329 tot 345; na drie minuten leren (seeds 1 tot en met 7) 178 tot 193, 75 tot 90, 44 tot 58, 140 tot 154. Zes minuten: één rooster van 2 248 tot 287, 16 roosters van 1 190 tot 218; het interval zei dat in 10 van de 10. In zes minuten valt één rooster van 1 of 4 ongeveer even vaak als een van 2.</translation>
    </message>
    <message>
        <source>Every way to the goal is worth 100, a long one as well.</source>
        <translation>Elke weg naar het doel is 100 waard, ook een lange.</translation>
    </message>
    <message>
        <source>Everything coarse</source>
        <translation>Alles grof</translation>
    </message>
    <message>
        <source>Expect to hear &quot;Softmax falls less because it explores less&quot;. Let them vote before step 5 and write the votes down. Step 4 takes that answer away: both leave the best action in 8 of 100 steps. Measured with the seeds 1 to 16, ten lives each: ε 0.1 falls 13 to 24 times, Softmax τ 1.5 2 to 5, greedy 2 to 5. The interval of the difference between ε-greedy and Softmax never held 0, that between greedy and Softmax did in 15 of 16. With τ 10 Softmax falls 76 times, with τ 100 193 times (seeds 1, 2). Do not let them say that Softmax explores where the pole is upright: it leaves the best action wherever another is nearly as good, and that is so at all angles.</source>
        <translation>Verwacht te horen: “Softmax valt minder omdat het minder exploreert”. Laat ze vóór stap 5 stemmen en schrijf de stemmen op. Stap 4 neemt dat antwoord weg: beide wijken in 8 van 100 stappen van de beste actie af. Gemeten met de seeds 1 tot en met 16, elk tien levens: ε 0,1 valt 13 tot 24 keer, Softmax τ 1,5 2 tot 5, greedy 2 tot 5. Het interval van het verschil tussen ε-greedy en Softmax bevatte nooit de 0, dat tussen greedy en Softmax in 15 van de 16 wel. Met τ 10 valt Softmax 76 keer, met τ 100 193 keer (seeds 1, 2). Laat ze niet zeggen dat Softmax exploreert waar de stok rechtop staat: het wijkt van de beste actie af waar een andere bijna even goed is, en dat is bij alle hoeken zo.</translation>
    </message>
    <message>
        <source>Expect to hear &quot;more exploring is better, it learns faster&quot;. Let them vote before step 2.

One life is a matter of chance. This one (seed 12) falls 17 times at ε = 0.05 and 64 times at 0.25. In eleven others (seeds 1 to 11) it was 0 to 25 against 61 to 90, always more at 0.25. In step 4 a smaller ε is not always better in one life: 8 falls at 0.02, 14 at 0.025, 7 at 0.01. That is a good moment to ask how many lives one needs; lesson 13 answers it.

Step 3 is the experiment that decides: the same knowledge, with and without random actions. In eleven other seeds the two groups did not overlap either.

Do not say that exploring is needed here: a robot with ε = 0 learns this task, too. At first all actions are worth about 0, so that an action that has led to a fall looks worse than one that has not been tried, and it tries the other by itself. New robots with ε = 0 fell 84 to 185 times in their first 500 episodes, against 160 to 212 at 0.05. Where the goal is hard to find by chance it is otherwise.

Step 5: in eleven other seeds the means were in the same order, and −1600 never overlapped with −100; single lives at 0 and at −100 sometimes did. For a robot that has learned before, as in steps 1 to 4, the reward of a fall makes hardly a difference in 200 episodes. With a punishment that is very hard, about −25,000, learning no longer came to an end in our tests.</source>
        <translation>Verwacht te horen: “meer exploreren is beter, hij leert dan sneller”. Laat ze vóór stap 2 stemmen.

Eén leven is toeval. Dit (seed 12) valt 17 keer met ε = 0,05 en 64 keer met 0,25. In elf andere (seeds 1 tot en met 11) was het 0 tot 25 tegen 61 tot 90, altijd meer met 0,25. In stap 4 is een kleinere ε in één leven niet altijd beter: 8 valpartijen met 0,02, 14 met 0,025, 7 met 0,01. Een goed moment om te vragen hoeveel levens men nodig heeft; les 13 geeft het antwoord.

Stap 3 is het experiment dat beslist: dezelfde kennis, met en zonder willekeurige acties. Ook met elf andere seeds overlapten de twee groepen niet.

Zeg niet dat exploreren hier nodig is: een robot met ε = 0 leert deze taak ook. In het begin zijn alle acties ongeveer 0 waard, zodat een actie die tot een val leidde er slechter uitziet dan een die nog niet geprobeerd is, en hij de andere vanzelf probeert. Nieuwe robots met ε = 0 vielen 84 tot 185 keer in hun eerste 500 episodes, tegen 160 tot 212 met 0,05. Waar het doel door toeval moeilijk te vinden is, ligt het anders.

Stap 5: met elf andere seeds stonden de gemiddelden in dezelfde volgorde, en −1600 overlapte nooit met −100; losse levens met 0 en met −100 soms wel. Voor een robot die al geleerd heeft, zoals in de stappen 1 tot en met 4, maakt de beloning van een val in 200 episodes nauwelijks verschil. Met een zeer zware straf, ongeveer −25 000, kwam het leren in onze proeven niet meer tot een eind.</translation>
    </message>
    <message>
        <source>Expect to hear &quot;strong motors teach it more&quot;, because there it falls less. Let them vote before step 3. Measured with the seeds 1 to 10, ten lives each, ten minutes of simulation, falls in 200 real episodes: from nothing 127 to 137; × 2.5 45 to 64; × 2 24 to 37; × 1.5 9 to 16; right 1 to 4; × 0.8 2 to 4; × 0.5 8 to 16; × 0.3 73 to 103. Every interval between neighbours in steps 5, 6 and 8 leaves out 0. The right one is best; × 0.8 cannot be told from it. In the simulation itself weak motors cost more falls (seed 1, four lives in ten minutes: × 0.5 934, × 1 236, × 2.5 105; with × 0.3 it still falls in four of five episodes): that is the price, and there it is paid. × 1.5 and × 0.5 fall about equally often, so the comparison has to be made by factors, as in step 6. Step 9: 20 falls on average with the risk obeyed, 48 without.</source>
        <translation>Verwacht te horen: “sterke motoren leren hem meer”, omdat hij daar minder valt. Laat ze vóór stap 3 stemmen. Gemeten met de seeds 1 tot en met 10, elk tien levens, tien minuten simulatie, valpartijen in 200 echte episodes: vanaf nul 127 tot 137; × 2,5 45 tot 64; × 2 24 tot 37; × 1,5 9 tot 16; juist 1 tot 4; × 0,8 2 tot 4; × 0,5 8 tot 16; × 0,3 73 tot 103. Elk interval tussen buren in de stappen 5, 6 en 8 sluit de 0 uit. Het juiste koppel is het beste; × 0,8 is er niet van te onderscheiden. In de simulatie zelf kosten zwakke motoren meer valpartijen (seed 1, vier levens in tien minuten: × 0,5 934, × 1 236, × 2,5 105; met × 0,3 valt hij nog in vier van de vijf episodes): dat is de prijs, en daar wordt hij betaald. × 1,5 en × 0,5 vallen ongeveer even vaak, dus moet men naar factoren vergelijken, zoals in stap 6. Stap 9: gemiddeld 20 valpartijen als het risico wordt gehoorzaamd, 48 zonder.</translation>
    </message>
    <message>
        <source>Expect to hear in step 2 that the highest line is the safest. Let them drag it to the end before they answer. After step 5 TRL looks like the better policy; step 7 asks what it was compared with. Let them vote there. Measured with the seeds 1 to 10, ten lives each, ε = 0.2: no restriction 48 to 55 falls, threshold 50 23 to 29, threshold 100 35 to 45; ε-greedy with ε 0.05 6 to 12. The intervals say so every time for 50 against none and for 50 against ε 0.05, and in 8 of 10 for 50 against 100. Half the ε, 0.1, falls 22 to 25 times: about as often as TRL 50, so do not use it to decide anything with ten lives.</source>
        <translation>Verwacht in stap 2 te horen dat de hoogste lijn de veiligste is. Laat ze haar eerst naar het eind slepen en dan antwoorden. Na stap 5 lijkt TRL de betere policy; stap 7 vraagt waarmee het vergeleken is. Laat daar stemmen. Gemeten met de seeds 1 tot en met 10, elk tien levens, ε = 0,2: zonder beperking 48 tot 55 valpartijen, drempel 50 23 tot 29, drempel 100 35 tot 45; ε-greedy met ε 0,05 6 tot 12. De intervallen zeggen dat elke keer voor 50 tegen geen en voor 50 tegen ε 0,05, en in 8 van de 10 voor 50 tegen 100. De helft van ε, 0,1, valt 22 tot 25 keer: ongeveer even vaak als TRL 50, dus gebruik dat niet om met tien levens iets te beslissen.</translation>
    </message>
    <message>
        <source>Expected Sarsa takes the mean over its next steps. Which way would you expect of it?</source>
        <translation>Expected Sarsa neemt het gemiddelde over zijn volgende stappen. Welke weg verwacht je van hem?</translation>
    </message>
    <message>
        <source>Explore equally often</source>
        <translation>Even vaak exploreren</translation>
    </message>
    <message>
        <source>Explore no more than learning needs: every random action may lead to a fall, also when the robot knows better. And let a fall cost enough that each one teaches something.</source>
        <translation>Exploreer niet meer dan het leren nodig heeft: elke willekeurige actie kan tot een val leiden, ook als de robot beter weet. En laat een val zoveel kosten dat elke iets leert.</translation>
    </message>
    <message>
        <source>Explore only among actions worth more than a threshold (TRL).</source>
        <translation>Exploreer alleen tussen acties die meer waard zijn dan een drempel (TRL).</translation>
    </message>
    <message>
        <source>Exploring costs falls</source>
        <translation>Exploreren kost valpartijen</translation>
    </message>
    <message>
        <source>Exploring is cheap where another action is worth nearly as much as the best. Softmax tries those, and so falls less than ε-greedy that explores as often. It should also be compared with greedy, which does not explore: these lives cannot tell the two apart.</source>
        <translation>Exploreren is goedkoop waar een andere actie bijna evenveel waard is als de beste. Softmax probeert die, en valt daardoor minder dan ε-greedy die even vaak exploreert. Vergelijk het ook met greedy, die niet exploreert: deze levens kunnen die twee niet uit elkaar houden.</translation>
    </message>
    <message>
        <source>Exploring need not try everything. A line across the actions&apos; values says what may be tried. Where should it lie, and is it better than simply exploring less?</source>
        <translation>Exploreren hoeft niet alles te proberen. Een lijn door de waarden van de acties zegt wat geprobeerd mag worden. Waar moet ze liggen, en is dat beter dan gewoon minder exploreren?</translation>
    </message>
    <message>
        <source>Fall in simulation, not in reality</source>
        <translation>Val in de simulatie, niet in de werkelijkheid</translation>
    </message>
    <message>
        <source>Falling less</source>
        <translation>Minder vallen</translation>
    </message>
    <message>
        <source>Falls in 100 episodes: **{observed(3)}** as a beginner, **{observed(5)}** after 20 minutes of practice. Both began each episode at rest, at most 15° from upright. Watch how it balances now.</source>
        <translation>Valpartijen in 100 episodes: **{observed(3)}** als beginner, **{observed(5)}** na 20 minuten oefenen. Allebei begonnen ze elke episode in rust, hoogstens 15° uit het lood. Kijk hoe hij nu balanceert.</translation>
    </message>
    <message>
        <source>Falls in 200 episodes</source>
        <translation>Valpartijen in 200 episodes</translation>
    </message>
    <message>
        <source>Falls in 200 episodes, at equal shares of exploring</source>
        <translation>Valpartijen in 200 episodes, bij een gelijk aandeel exploreren</translation>
    </message>
    <message>
        <source>Falls in 200 episodes, different simulations</source>
        <translation>Valpartijen in 200 episodes, verschillende simulaties</translation>
    </message>
    <message>
        <source>Falls in 200 episodes, on average. With ε = 0.2: ε-greedy {mean(&quot;no line&quot;)}; TRL with the line at 50, {mean(&quot;TRL 50&quot;)}. With ε = 0.05: ε-greedy {mean(&quot;ε-greedy, ε 0.05&quot;)}.</source>
        <translation>Valpartijen in 200 episodes, gemiddeld. Met ε = 0,2: ε-greedy {mean(&quot;no line&quot;)}; TRL met de lijn op 50, {mean(&quot;TRL 50&quot;)}. Met ε = 0,05: ε-greedy {mean(&quot;ε-greedy, ε 0.05&quot;)}.</translation>
    </message>
    <message>
        <source>Falls in 200 episodes, the same simulations</source>
        <translation>Valpartijen in 200 episodes, dezelfde simulaties</translation>
    </message>
    <message>
        <source>Falls in 200 episodes, ε = 0.2</source>
        <translation>Valpartijen in 200 episodes, ε = 0,2</translation>
    </message>
    <message>
        <source>Falls in 200 real episodes, ten lives each, on average: {mean(&quot;× 0.3&quot;)} after × 0.3; {mean(&quot;× 0.8&quot;)} after × 0.8; {mean(&quot;× 1.5&quot;)} after × 1.5. After the right motors it was {mean(&quot;right, × 1&quot;)}.</source>
        <translation>Valpartijen in 200 echte episodes, elk tien levens, gemiddeld: {mean(&quot;× 0.3&quot;)} na × 0,3; {mean(&quot;× 0.8&quot;)} na × 0,8; {mean(&quot;× 1.5&quot;)} na × 1,5. Na de juiste motoren waren het er {mean(&quot;right, × 1&quot;)}.</translation>
    </message>
    <message>
        <source>Falls in 500 episodes</source>
        <translation>Valpartijen in 500 episodes</translation>
    </message>
    <message>
        <source>Falls in the first 200 real episodes</source>
        <translation>Valpartijen in de eerste 200 echte episodes</translation>
    </message>
    <message>
        <source>Falls in the first 500 episodes</source>
        <translation>Valpartijen in de eerste 500 episodes</translation>
    </message>
    <message>
        <source>Falls in the first six minutes</source>
        <translation>Valpartijen in de eerste zes minuten</translation>
    </message>
    <message>
        <source>Falls in the first two minutes</source>
        <translation>Valpartijen in de eerste twee minuten</translation>
    </message>
    <message>
        <source>Falls in the next 100 episodes</source>
        <translation>Valpartijen in de volgende 100 episodes</translation>
    </message>
    <message>
        <source>Falls in three minutes on the other robot</source>
        <translation>Valpartijen in drie minuten op de andere robot</translation>
    </message>
    <message>
        <source>Falls in two minutes, after three minutes of learning</source>
        <translation>Valpartijen in twee minuten, na drie minuten leren</translation>
    </message>
    <message>
        <source>Far from upright, where the map is still hatched.</source>
        <translation>Ver van rechtop, waar de kaart nog gearceerd is.</translation>
    </message>
    <message>
        <source>Far up nothing is left of the differences between the five.</source>
        <translation>Helemaal boven is er niets over van de verschillen tussen de vijf.</translation>
    </message>
    <message>
        <source>Few lives can also hide a difference. In five lives ε-greedy with ε = 0.05 fell {mean(&quot;A&quot;)} times on average, Softmax {mean(&quot;Softmax, five&quot;)} times: one cannot tell. Now thirty lives of each.</source>
        <translation>Weinig levens kunnen een verschil ook verbergen. In vijf levens viel ε-greedy met ε = 0,05 gemiddeld {mean(&quot;A&quot;)} keer, Softmax {mean(&quot;Softmax, five&quot;)} keer: niets te zeggen. Nu van elk dertig levens.</translation>
    </message>
    <message>
        <source>Find a resolution with which it falls fewer than 420 times in six minutes.</source>
        <translation>Vind een resolutie waarmee hij in zes minuten minder dan 420 keer valt.</translation>
    </message>
    <message>
        <source>Find the width that learns soonest and still balances.</source>
        <translation>Vind de breedte die het snelst leert en toch balanceert.</translation>
    </message>
    <message>
        <source>Fine or coarse, and for what?</source>
        <translation>Fijn of grof, en waarvoor?</translation>
    </message>
    <message>
        <source>Finish the sentence: a robot that learns by itself falls because …</source>
        <translation>Maak de zin af: een robot die zelf leert valt, omdat …</translation>
    </message>
    <message>
        <source>First **ε-greedy** with ε = 0.1, for 200 episodes in reality. In one step of ten it draws among all five actions. But one in five of those draws happens to be the best action. To take another one than the best is called *leaving the best action* here.</source>
        <translation>Eerst **ε-greedy** met ε = 0,1, 200 episodes in de werkelijkheid. In één op de tien stappen loot hij tussen alle vijf acties. Maar één op de vijf lotingen levert toevallig de beste actie op. Een andere dan de beste nemen heet hier *van de beste actie afwijken*.</translation>
    </message>
    <message>
        <source>First plain ε-greedy in reality, for 200 episodes. In one step of five it draws among all five actions, whatever they are worth.</source>
        <translation>Eerst gewone ε-greedy in de werkelijkheid, 200 episodes. In één op de vijf stappen loot die tussen alle vijf acties, wat ze ook waard zijn.</translation>
    </message>
    <message>
        <source>First δ: what comes is 100, what it expects is 50. Half of that is added.</source>
        <translation>Eerst δ: er komt 100, hij verwacht 50. De helft daarvan komt erbij.</translation>
    </message>
    <message>
        <source>Five lives gave {mean(&quot;Softmax, five&quot;)} and {mean(&quot;greedy, five&quot;)} falls. Thirty give {mean(&quot;Softmax&quot;)} and {mean(&quot;greedy&quot;)}, and now the interval of the difference holds 0. A 95 % interval may miss: without any difference it leaves out 0 in 5 of 100 comparisons.</source>
        <translation>Vijf levens gaven {mean(&quot;Softmax, five&quot;)} en {mean(&quot;greedy, five&quot;)} valpartijen. Dertig geven {mean(&quot;Softmax&quot;)} en {mean(&quot;greedy&quot;)}, en nu bevat het interval van het verschil de 0. Een 95%-interval kan ernaast zitten: zonder enig verschil sluit het in 5 van 100 vergelijkingen de 0 uit.</translation>
    </message>
    <message>
        <source>Five lives of A, five of B</source>
        <translation>Vijf levens van A, vijf van B</translation>
    </message>
    <message>
        <source>Five times as many actions are drawn at random. Not each of them is a bad one.</source>
        <translation>Vijf keer zoveel acties worden geloot. Niet elke daarvan is een slechte.</translation>
    </message>
    <message>
        <source>Follow the lines of the seeds: do they all lean to one side?</source>
        <translation>Volg de lijnen van de seeds: hellen ze allemaal naar één kant?</translation>
    </message>
    <message>
        <source>For how many states does one fall change the values?</source>
        <translation>Voor hoeveel toestanden verandert één val de waarden?</translation>
    </message>
    <message>
        <source>For the end: two simulated hours in turbo, with something to read meanwhile.</source>
        <translation>Tot slot: twee gesimuleerde uren in turbo, met iets te lezen tussendoor.</translation>
    </message>
    <message>
        <source>From coin toss to certainty: how Softmax chooses (τ).</source>
        <translation>Van kop of munt tot zekerheid: hoe Softmax kiest (τ).</translation>
    </message>
    <message>
        <source>From nothing, in reality</source>
        <translation>Vanaf nul, in de werkelijkheid</translation>
    </message>
    <message>
        <source>From simulation to robot</source>
        <translation>Van simulatie naar robot</translation>
    </message>
    <message>
        <source>From state 4 it went left, right, left, left, right, left, left.</source>
        <translation>Vanuit toestand 4 ging hij links, rechts, links, links, rechts, links, links.</translation>
    </message>
    <message>
        <source>From the falls in reality.</source>
        <translation>Van de valpartijen in de werkelijkheid.</translation>
    </message>
    <message>
        <source>From the falls in the simulation.</source>
        <translation>Van de valpartijen in de simulatie.</translation>
    </message>
    <message>
        <source>From the reward of a fall, −100.</source>
        <translation>Van de beloning van een val, −100.</translation>
    </message>
    <message>
        <source>From what did the robot learn the risk of its actions?</source>
        <translation>Waarvan leerde de robot het risico van zijn acties?</translation>
    </message>
    <message>
        <source>From which angle could each of them still bring the pole up in its own simulation?</source>
        <translation>Vanaf welke hoek kan elk van beide de stok in zijn eigen simulatie nog rechtop krijgen?</translation>
    </message>
    <message>
        <source>From which state does the very next step give a reward above 0?</source>
        <translation>Vanuit welke toestand geeft de eerstvolgende stap een beloning boven 0?</translation>
    </message>
    <message>
        <source>Gains and losses apart</source>
        <translation>Winst en verlies apart</translation>
    </message>
    <message>
        <source>Go on: state 7 is worth 0.9 times what state 8 is worth.</source>
        <translation>Ga zo door: toestand 7 is 0,9 keer zoveel waard als toestand 8.</translation>
    </message>
    <message>
        <source>Goals reached in the first three minutes</source>
        <translation>Bereikte doelen in de eerste drie minuten</translation>
    </message>
    <message>
        <source>Grab the pole and pull it.</source>
        <translation>Pak de stok vast en trek eraan.</translation>
    </message>
    <message>
        <source>Gravity pulls a leaning pole further over. The more it leans, the harder the pull. The robot goes on trying its torques. Grab the pole with the mouse and try to hold it up. What must you watch? Only where the pole is?</source>
        <translation>De zwaartekracht trekt een stok die scheef staat verder omver. Hoe schever, hoe harder. De robot blijft zijn koppels proberen. Pak de stok met de muis en probeer hem rechtop te houden. Waar moet je op letten? Alleen op waar de stok is?</translation>
    </message>
    <message>
        <source>Greedy falls as seldom. When is exploring worth its falls all the same?</source>
        <translation>Greedy valt even zelden. Wanneer is exploreren zijn valpartijen toch waard?</translation>
    </message>
    <message>
        <source>Greedy, which never explores.</source>
        <translation>Greedy, die nooit exploreert.</translation>
    </message>
    <message>
        <source>Half as many falls</source>
        <translation>Half zo vaak vallen</translation>
    </message>
    <message>
        <source>Half as wide, and then half as wide again.</source>
        <translation>Half zo breed, en dan nog eens half zo breed.</translation>
    </message>
    <message>
        <source>Half of the steps are random in all of them. Look at what α is multiplied by.</source>
        <translation>In alle levens is de helft van de stappen willekeurig. Kijk waarmee α vermenigvuldigd wordt.</translation>
    </message>
    <message>
        <source>Hands off now. A new **life** begins: the robot knows nothing again, and nobody shows it how to balance. It gets a **reward** of 200 when the pole stands upright and still, and −100 when it falls. Everything else it must find out. You will see its first 100 episodes.</source>
        <translation>Nu handen af. Een nieuw **leven** begint: de robot weet weer niets, en niemand doet hem het balanceren voor. Hij krijgt een **beloning** van 200 als de stok rechtop stilstaat, en −100 als hij valt. De rest moet hij zelf ontdekken. Je ziet zijn eerste 100 episodes.</translation>
    </message>
    <message>
        <source>Here is the step. There was no reward, and still the robot learned: δ = 0 + 0.8 · 75 − 0 = 60, and Q(8, right) rose by half of that, to 30. A value learns from the next value.</source>
        <translation>Hier is de stap. Er was geen beloning, en toch leerde de robot: δ = 0 + 0,8 · 75 − 0 = 60, en Q(8, rechts) steeg met de helft daarvan, naar 30. Een waarde leert van de volgende waarde.</translation>
    </message>
    <message>
        <source>How careful?</source>
        <translation>Hoe voorzichtig?</translation>
    </message>
    <message>
        <source>How coarse may it be?</source>
        <translation>Hoe grof mag het?</translation>
    </message>
    <message>
        <source>How does it find out that a step over the edge falls?</source>
        <translation>Hoe komt hij erachter dat een stap over de rand een val is?</translation>
    </message>
    <message>
        <source>How does the wrongly blamed step get its value back?</source>
        <translation>Hoe krijgt de stap die ten onrechte schuld kreeg zijn waarde terug?</translation>
    </message>
    <message>
        <source>How far do the dots of one ε lie apart?</source>
        <translation>Hoe ver liggen de punten van één ε uit elkaar?</translation>
    </message>
    <message>
        <source>How far does one lucky or unlucky step move the value with each α?</source>
        <translation>Hoe ver verschuift één gelukkige of ongelukkige stap de waarde met elke α?</translation>
    </message>
    <message>
        <source>How many actions lie above the line, and among how many does TRL draw then?</source>
        <translation>Hoeveel acties liggen boven de lijn, en tussen hoeveel loot TRL dan?</translation>
    </message>
    <message>
        <source>How many lives it takes to say so, and with which interval.</source>
        <translation>Hoeveel levens je nodig hebt om dat te zeggen, en met welk interval.</translation>
    </message>
    <message>
        <source>How many more tiles are there, in three variables?</source>
        <translation>Hoeveel meer tegels zijn er, in drie variabelen?</translation>
    </message>
    <message>
        <source>How many of its first 100 episodes will end in a fall?</source>
        <translation>Hoeveel van zijn eerste 100 episodes eindigen in een val?</translation>
    </message>
    <message>
        <source>How many of the falls may have come from random actions?</source>
        <translation>Hoeveel van de valpartijen kunnen van willekeurige acties gekomen zijn?</translation>
    </message>
    <message>
        <source>How many steps next to the edge does each way have?</source>
        <translation>Hoeveel stappen naast de rand heeft elke weg?</translation>
    </message>
    <message>
        <source>How many steps per episode will it take?</source>
        <translation>Hoeveel stappen per episode zal hij nodig hebben?</translation>
    </message>
    <message>
        <source>How many steps will its way have?</source>
        <translation>Hoeveel stappen zal zijn weg hebben?</translation>
    </message>
    <message>
        <source>How many times will it have reached the goal by then?</source>
        <translation>Hoe vaak zal hij het doel dan bereikt hebben?</translation>
    </message>
    <message>
        <source>How often will Q-learning fall in 500 episodes?</source>
        <translation>Hoe vaak zal Q-learning in 500 episodes vallen?</translation>
    </message>
    <message>
        <source>How often will it fall in 200 episodes?</source>
        <translation>Hoe vaak zal hij in 200 episodes vallen?</translation>
    </message>
    <message>
        <source>How often will it fall in its first ten minutes?</source>
        <translation>Hoe vaak zal hij in zijn eerste tien minuten vallen?</translation>
    </message>
    <message>
        <source>How often will it fall in its first two minutes?</source>
        <translation>Hoe vaak zal hij in zijn eerste twee minuten vallen?</translation>
    </message>
    <message>
        <source>How often will it fall in six minutes?</source>
        <translation>Hoe vaak zal hij in zes minuten vallen?</translation>
    </message>
    <message>
        <source>How often will it fall in the next ten minutes?</source>
        <translation>Hoe vaak zal hij in de volgende tien minuten vallen?</translation>
    </message>
    <message>
        <source>How often will it fall in these 200 real episodes?</source>
        <translation>Hoe vaak zal hij in deze 200 echte episodes vallen?</translation>
    </message>
    <message>
        <source>How often will it fall in these ten minutes?</source>
        <translation>Hoe vaak zal hij in deze tien minuten vallen?</translation>
    </message>
    <message>
        <source>How often will it fall with ε = 0.25?</source>
        <translation>Hoe vaak zal hij vallen met ε = 0,25?</translation>
    </message>
    <message>
        <source>How often will it fall?</source>
        <translation>Hoe vaak zal hij vallen?</translation>
    </message>
    <message>
        <source>How should a simulation be wrong?</source>
        <translation>Hoe moet een simulatie verkeerd zijn?</translation>
    </message>
    <message>
        <source>How steep is the curve of falls in its last ten minutes?</source>
        <translation>Hoe steil is de curve van valpartijen in de laatste tien minuten?</translation>
    </message>
    <message>
        <source>How weak may it be?</source>
        <translation>Hoe zwak mag het?</translation>
    </message>
    <message>
        <source>How wide are the bars of the means now?</source>
        <translation>Hoe breed zijn de balken van de gemiddelden nu?</translation>
    </message>
    <message>
        <source>How wide is a tile along the pole&apos;s angle?</source>
        <translation>Hoe breed is een tegel langs de hoek van de stok?</translation>
    </message>
    <message>
        <source>How would you let a robot learn?</source>
        <translation>Hoe zou jij een robot laten leren?</translation>
    </message>
    <message>
        <source>If the robot has to explore that often, a threshold lets it do so with fewer falls. If it need not, a smaller ε saves more. So TRL has to be compared with ε-greedy of a smaller ε, too, not only of the same ε.</source>
        <translation>Als de robot zo vaak moet exploreren, laat een drempel hem dat met minder valpartijen doen. Hoeft het niet, dan bespaart een kleinere ε meer. Vergelijk TRL dus ook met ε-greedy van een kleinere ε, niet alleen van dezelfde ε.</translation>
    </message>
    <message>
        <source>If wide tiles help, why two Q-functions at all? For a fair comparison give **both** the resolution 0.4, which is one coarse Q-function. Ten lives of each.</source>
        <translation>Als brede tegels helpen, waarom dan twee Q-functies? Geef voor een eerlijke vergelijking **beide** de resolutie 0,4, en dat is één grove Q-functie. Van elk tien levens.</translation>
    </message>
    <message>
        <source>In 100 steps it draws 10 times. How many of these draws are not the best action?</source>
        <translation>In 100 stappen loot hij 10 keer. Hoeveel van die lotingen zijn niet de beste actie?</translation>
    </message>
    <message>
        <source>In a simulation falls cost nothing, but no simulation is right. Its motors may be too strong or too weak. Say beforehand which of the two helps more, and then ask whether the comparison was fair.</source>
        <translation>In een simulatie kost vallen niets, maar geen simulatie klopt. Haar motoren kunnen te sterk of te zwak zijn. Zeg van tevoren wat van beide meer helpt, en vraag dan of de vergelijking eerlijk was.</translation>
    </message>
    <message>
        <source>In how many of 100 steps does it take an action other than the best?</source>
        <translation>In hoeveel van 100 stappen neemt hij een andere actie dan de beste?</translation>
    </message>
    <message>
        <source>In its own simulation the motors are weak: to bring the pole up from 29° is harder there.</source>
        <translation>In zijn eigen simulatie zijn de motoren zwak: de stok vanaf 29° rechtop krijgen is daar moeilijker.</translation>
    </message>
    <message>
        <source>In reality it obeys the risk: it chooses by **Q − 3000·ρ**. Nothing was learned anew; only the choice is another. 200 real episodes: without this it fell {observed(1)} times, with a penalty of −6400 {observed(2)} times.</source>
        <translation>In de werkelijkheid gehoorzaamt hij het risico: hij kiest naar **Q − 3000·ρ**. Er is niets opnieuw geleerd; alleen de keuze is anders. 200 echte episodes: zonder dit viel hij {observed(1)} keer, met een straf van −6400 {observed(2)} keer.</translation>
    </message>
    <message>
        <source>In simulation LEO fell {observed(3)} times and broke nothing. On the other robot it fell {observed(5)} times with ε = 0.05 and {observed(6)} times greedy, in ten minutes each.</source>
        <translation>In de simulatie viel LEO {observed(3)} keer en ging er niets stuk. Op de andere robot viel hij {observed(5)} keer met ε = 0,05 en {observed(6)} keer greedy, elk in tien minuten.</translation>
    </message>
    <message>
        <source>In simulation a robot may fall as often as it likes, and should: only falls teach where falls are. In reality it should not. One number that it learns beside its values lets it be bold in one world and careful in the other.</source>
        <translation>In de simulatie mag een robot vallen zo vaak hij wil, en dat moet ook: alleen door te vallen leert hij waar hij valt. In de werkelijkheid niet. Eén getal dat hij naast zijn waarden leert, laat hem in de ene wereld dapper en in de andere voorzichtig zijn.</translation>
    </message>
    <message>
        <source>In these 500 episodes it has been on every square at the edge. Think of its falls.</source>
        <translation>In deze 500 episodes is hij op elk vakje aan de rand geweest. Denk aan zijn valpartijen.</translation>
    </message>
    <message>
        <source>In this life a coarser Q⁻ came to {observed(4)} falls instead of {observed(3)}. How coarse may it be? Turn the resolution of Q⁻; each time a new life begins. Run six minutes in turbo.</source>
        <translation>In dit leven kwam een grovere Q⁻ op {observed(4)} valpartijen in plaats van {observed(3)}. Hoe grof mag hij zijn? Draai aan de resolutie van Q⁻; elke keer begint een nieuw leven. Laat zes minuten in turbo lopen.</translation>
    </message>
    <message>
        <source>In which of the two states does Softmax with τ = 1.5 sometimes take the second best?</source>
        <translation>In welke van de twee toestanden neemt Softmax met τ = 1,5 soms de op een na beste?</translation>
    </message>
    <message>
        <source>In your own words</source>
        <translation>In je eigen woorden</translation>
    </message>
    <message>
        <source>Is anything else as good, that the claim does not mention?</source>
        <translation>Is er iets anders even goed, dat de bewering niet noemt?</translation>
    </message>
    <message>
        <source>Is it really better?</source>
        <translation>Is het echt beter?</translation>
    </message>
    <message>
        <source>Is that fair?</source>
        <translation>Is dat eerlijk?</translation>
    </message>
    <message>
        <source>Is the robot that falls least also the one that learns soonest? How would you measure it?</source>
        <translation>Is de robot die het minst valt ook degene die het snelst leert? Hoe zou je dat meten?</translation>
    </message>
    <message>
        <source>It counts the falls that its own random steps will bring at the edge.</source>
        <translation>Hij telt de valpartijen mee die zijn eigen willekeurige stappen aan de rand zullen brengen.</translation>
    </message>
    <message>
        <source>It did not know yet which torque helps where.</source>
        <translation>Hij wist nog niet welk koppel waar helpt.</translation>
    </message>
    <message>
        <source>It does not mind the cost of a step.</source>
        <translation>Wat een stap kost, kan hem niet schelen.</translation>
    </message>
    <message>
        <source>It expects heavy losses even upright: Q⁻ can hardly tell good from bad.</source>
        <translation>Hij verwacht ook rechtop zwaar verlies: Q⁻ kan goed en slecht nauwelijks onderscheiden.</translation>
    </message>
    <message>
        <source>It expects that it can still save itself.</source>
        <translation>Hij verwacht dat hij zich nog kan redden.</translation>
    </message>
    <message>
        <source>It expects too little loss.</source>
        <translation>Hij verwacht te weinig verlies.</translation>
    </message>
    <message>
        <source>It expects {max(q(&quot;1.5&quot;), q(&quot;0.75&quot;), q(&quot;0&quot;), q(&quot;-0.75&quot;), q(&quot;-1.5&quot;))}, not {observed(4)}. Ten lives each fall, on average, {mean(&quot;nothing&quot;)} times from nothing, {mean(&quot;strong, × 2.5&quot;)} after the strong motors, {mean(&quot;weak, × 0.5&quot;)} after the weak ones and {mean(&quot;right, × 1&quot;)} after the right ones.</source>
        <translation>Hij verwacht {max(q(&quot;1.5&quot;), q(&quot;0.75&quot;), q(&quot;0&quot;), q(&quot;-0.75&quot;), q(&quot;-1.5&quot;))}, niet {observed(4)}. Van elk tien levens: gemiddeld vallen ze {mean(&quot;nothing&quot;)} keer vanaf nul, {mean(&quot;strong, × 2.5&quot;)} na de sterke motoren, {mean(&quot;weak, × 0.5&quot;)} na de zwakke en {mean(&quot;right, × 1&quot;)} na de juiste.</translation>
    </message>
    <message>
        <source>It explores less.</source>
        <translation>Het exploreert minder.</translation>
    </message>
    <message>
        <source>It explores more often.</source>
        <translation>Het exploreert vaker.</translation>
    </message>
    <message>
        <source>It explores more.</source>
        <translation>Hij exploreert meer.</translation>
    </message>
    <message>
        <source>It fell **{observed(1)} times** in 200 episodes. Now it first learns for ten minutes in a simulation. But the simulation is wrong: its motors are **2.5 times too strong**. After that come 200 episodes in reality.</source>
        <translation>Hij viel **{observed(1)} keer** in 200 episodes. Nu leert hij eerst tien minuten in een simulatie. Maar die klopt niet: haar motoren zijn **2,5 keer te sterk**. Daarna komen 200 episodes in de werkelijkheid.</translation>
    </message>
    <message>
        <source>It fell **{observed(1)} times**. The first idea: a fall costs −6400 instead of −100, in the simulation **and** in reality. Everything else stays.</source>
        <translation>Hij viel **{observed(1)} keer**. Het eerste idee: een val kost −6400 in plaats van −100, in de simulatie **en** in de werkelijkheid. Al het andere blijft.</translation>
    </message>
    <message>
        <source>It fell **{observed(3)} times** in 200 episodes. Now TRL with a threshold of **50**. The same robot, and it explores in one step of five, as before.</source>
        <translation>Hij viel **{observed(3)} keer** in 200 episodes. Nu TRL met een drempel van **50**. Dezelfde robot, en hij exploreert in één op de vijf stappen, zoals eerst.</translation>
    </message>
    <message>
        <source>It fell {observed(2)} times; with the wide tiles {observed(1)} times. What it learns in a narrow tile helps in no other, and there are 32,768 times as many of them. The map shows where it has learned anything.</source>
        <translation>Hij viel {observed(2)} keer; met de brede tegels {observed(1)} keer. Wat hij in een smalle tegel leert helpt in geen andere, en daarvan zijn er 32 768 keer zoveel. De kaart laat zien waar hij iets geleerd heeft.</translation>
    </message>
    <message>
        <source>It fell {observed(3)} times. Each fall has a mark below the curve, and a click plays it back slowly. To save a leaning pole, the wheel must drive the cart **under** it, to the side where it leans. Does the arrow point to that side all the time?</source>
        <translation>Hij viel {observed(3)} keer. Elke val heeft een streepje onder de curve, en een klik speelt hem langzaam terug. Om een scheve stok te redden moet het wiel het karretje **onder** de stok rijden, naar de kant waarheen hij helt. Wijst de pijl de hele tijd naar die kant?</translation>
    </message>
    <message>
        <source>It fell {observed(4)} times. In ten lives of each, Sarsa falls {least(&quot;Sarsa falls&quot;)} to {most(&quot;Sarsa falls&quot;)} times and Q-learning {least(&quot;Q-learning falls&quot;)} to {most(&quot;Q-learning falls&quot;)} times. To Q-learning the short way is worth more, to Sarsa the longer one.</source>
        <translation>Hij viel {observed(4)} keer. In tien levens van elk valt Sarsa {least(&quot;Sarsa falls&quot;)} tot {most(&quot;Sarsa falls&quot;)} keer en Q-learning {least(&quot;Q-learning falls&quot;)} tot {most(&quot;Q-learning falls&quot;)} keer. Voor Q-learning is de korte weg meer waard, voor Sarsa de langere.</translation>
    </message>
    <message>
        <source>It fell {observed(7)} times instead of {observed(4)}, and walks along the edge: it fell about once for every square beside the cliff, and then knew. Without that, with ε = 0.1, Sarsa kept off the edge and Q-learning did not.</source>
        <translation>Hij viel {observed(7)} keer in plaats van {observed(4)}, en loopt langs de rand: hij viel ongeveer één keer voor elk vakje naast de afgrond, en wist het toen. Zonder dat bleef, met ε = 0,1, Sarsa van de rand af en Q-learning niet.</translation>
    </message>
    <message>
        <source>It follows what it learned in the simulation, also where that is wrong.</source>
        <translation>Die volgt wat hij in de simulatie leerde, ook waar dat verkeerd is.</translation>
    </message>
    <message>
        <source>It forbids the best action.</source>
        <translation>Ze verbiedt de beste actie.</translation>
    </message>
    <message>
        <source>It forgets what it has learned.</source>
        <translation>Hij vergeet wat hij geleerd heeft.</translation>
    </message>
    <message>
        <source>It has been at the goal many times. Look at state 9.</source>
        <translation>Hij is vaak bij het doel geweest. Kijk naar toestand 9.</translation>
    </message>
    <message>
        <source>It has fallen so often. Why does it expect no loss here?</source>
        <translation>Hij is zo vaak gevallen. Waarom verwacht hij hier geen verlies?</translation>
    </message>
    <message>
        <source>It has learned for longer.</source>
        <translation>Het heeft langer geleerd.</translation>
    </message>
    <message>
        <source>It has never been in these tiles.</source>
        <translation>Hij is nog nooit in deze tegels geweest.</translation>
    </message>
    <message>
        <source>It has never been on the short way.</source>
        <translation>Hij is nooit op de korte weg geweest.</translation>
    </message>
    <message>
        <source>It has not found the goal yet.</source>
        <translation>Hij heeft het doel nog niet gevonden.</translation>
    </message>
    <message>
        <source>It has not learned for long enough.</source>
        <translation>Hij heeft niet lang genoeg geleerd.</translation>
    </message>
    <message>
        <source>It has not lived in reality yet.</source>
        <translation>Hij heeft nog niet in de werkelijkheid geleefd.</translation>
    </message>
    <message>
        <source>It is 75: δ was 50, half as much as before. Next the robot is put on state 8 and goes right. Q(8, right) is 0, and the reward is R = 0. But on state 9 it will go right, and Q(9, right) = 75. Here γ = 0.8.</source>
        <translation>Het is 75: δ was 50, half zo groot als daarnet. Nu wordt de robot op toestand 8 gezet en gaat naar rechts. Q(8, rechts) is 0, en de beloning is R = 0. Maar op toestand 9 gaat hij naar rechts, en Q(9, rechts) = 75. Hier is γ = 0,8.</translation>
    </message>
    <message>
        <source>It is afraid of the fall.</source>
        <translation>Hij is bang voor de val.</translation>
    </message>
    <message>
        <source>It is the same motor now. Look at the pole: does it come upright?</source>
        <translation>Het is nu dezelfde motor. Kijk naar de stok: komt hij rechtop?</translation>
    </message>
    <message>
        <source>It keeps away from the fall.</source>
        <translation>Hij blijft uit de buurt van de val.</translation>
    </message>
    <message>
        <source>It knows enough to fall seldom. But it still takes one action in four at random, also where that is dangerous.</source>
        <translation>Hij weet genoeg om zelden te vallen. Maar hij kiest nog steeds één op de vier acties willekeurig, ook waar dat gevaarlijk is.</translation>
    </message>
    <message>
        <source>It leads to state 3, away from the fall. Look at the world.</source>
        <translation>Die leidt naar toestand 3, weg van de val. Kijk naar de wereld.</translation>
    </message>
    <message>
        <source>It leads to the fall, too.</source>
        <translation>Die leidt ook naar de val.</translation>
    </message>
    <message>
        <source>It learned caution in the simulation, and with it less of where falls are.</source>
        <translation>Die leerde voorzichtigheid in de simulatie, en daardoor minder over waar gevallen wordt.</translation>
    </message>
    <message>
        <source>It learned for longer.</source>
        <translation>Hij leerde langer.</translation>
    </message>
    <message>
        <source>It learns more slowly, so it knows too little.</source>
        <translation>Hij leert langzamer, dus weet hij te weinig.</translation>
    </message>
    <message>
        <source>It no longer gets the reward of the goal.</source>
        <translation>Hij krijgt de beloning van het doel niet meer.</translation>
    </message>
    <message>
        <source>It takes such a lean for lost, and so errs on the safe side.</source>
        <translation>Hij geeft zo&apos;n helling verloren, en zit dus aan de veilige kant.</translation>
    </message>
    <message>
        <source>It wants to fall then, because that ends the episode.</source>
        <translation>Hij wil dan vallen, want dat beëindigt de episode.</translation>
    </message>
    <message>
        <source>It was taken shortly before the fall.</source>
        <translation>Die is kort voor de val gedaan.</translation>
    </message>
    <message>
        <source>It will keep away from falls in both worlds. But what does it know of the real one?</source>
        <translation>Hij zal in beide werelden van valpartijen wegblijven. Maar wat weet hij van de echte?</translation>
    </message>
    <message>
        <source>Its episodes began with the pole too far over.</source>
        <translation>Bij het begin van zijn episodes stond de stok te scheef.</translation>
    </message>
    <message>
        <source>Its mark has faded once, to 0.81. It loses 0.81 times what the last step loses.</source>
        <translation>Zijn merkteken is één keer vervaagd, tot 0,81. Hij verliest 0,81 keer wat de laatste stap verliest.</translation>
    </message>
    <message>
        <source>Its motor is too weak for the pole.</source>
        <translation>Zijn motor is te zwak voor de stok.</translation>
    </message>
    <message>
        <source>Its random actions make it fall, whatever it knows.</source>
        <translation>Zijn willekeurige acties laten hem vallen, wat hij ook weet.</translation>
    </message>
    <message>
        <source>Its random steps are what makes the edge costly. And what it learned with them it must learn anew.</source>
        <translation>Zijn willekeurige stappen maken de rand duur. En wat hij daarmee leerde, moet hij opnieuw leren.</translation>
    </message>
    <message>
        <source>Its tiles are only 12° wide, and all its falls went through other ones.</source>
        <translation>Zijn tegels zijn maar 12° breed, en al zijn valpartijen gingen door andere.</translation>
    </message>
    <message>
        <source>LEO has two legs and seven parts, and knows nothing when it begins. Give it two simulated hours. Then put what it has learned on a robot with other motors, and compare two ways to go on.</source>
        <translation>LEO heeft twee benen en zeven delen, en weet niets als hij begint. Geef hem twee gesimuleerde uren. Zet dan wat hij geleerd heeft op een robot met andere motoren, en vergelijk twee manieren om verder te gaan.</translation>
    </message>
    <message>
        <source>LEO is held by a boom, so that it cannot fall sideways. Thirty times a second it sets three motors, each to one of seven voltages. It gets a reward for every metre, and pays for energy, for time and for falls. It knows nothing yet. Watch it for a while.</source>
        <translation>LEO hangt aan een giek, zodat hij niet opzij kan vallen. Dertig keer per seconde zet hij drie motoren elk op een van zeven spanningen. Hij krijgt een beloning voor elke meter, en betaalt voor energie, tijd en valpartijen. Hij weet nog niets. Kijk er even naar.</translation>
    </message>
    <message>
        <source>LEO walks</source>
        <translation>LEO loopt</translation>
    </message>
    <message>
        <source>Learn first on a wrong model, and choose how it should be wrong.</source>
        <translation>Leer eerst op een verkeerd model, en kies hoe het verkeerd is.</translation>
    </message>
    <message>
        <source>Learn how likely a fall is, and obey it only where falls cost something.</source>
        <translation>Leer hoe waarschijnlijk een val is, en gehoorzaam dat alleen waar vallen iets kost.</translation>
    </message>
    <message>
        <source>Left and right are worth the same there.</source>
        <translation>Links en rechts zijn daar evenveel waard.</translation>
    </message>
    <message>
        <source>Less.</source>
        <translation>Minder.</translation>
    </message>
    <message>
        <source>Let it fall in simulation first, as often as it needs. Then explore as little as possible on the robot: in this run greedy fell less. And check it with more than one learned robot before you say so of all.</source>
        <translation>Laat hem eerst in simulatie vallen, zo vaak als nodig is. Exploreer daarna op de robot zo weinig mogelijk: in deze run viel greedy minder. En controleer het met meer dan één robot die geleerd heeft voordat je het van allemaal zegt.</translation>
    </message>
    <message>
        <source>Let it run, and look at the arrows on the map: which way do they lead from the start?</source>
        <translation>Laat hem lopen, en kijk naar de pijlen op de kaart: waar leiden ze vanaf het begin heen?</translation>
    </message>
    <message>
        <source>Let them vote before step 5: expect to hear &quot;the coarser, the better&quot;. The fair comparison of step 7 is easily forgotten: one coarse Q-function. Measured with the seeds 1 to 10, ten lives of six minutes each: fine 65 to 77 falls, Q⁻ 0.4 44 to 50, Q⁻ 0.1 198 to 282, both 0.4 69 to 76; every interval between them says so, but that between fine and both coarse, which differ little in falls. With both coarse the goal is reached about 770 times in six minutes in place of about 1,300. One life showed the opposite in 2 of 10 seeds, hence ten. On the walking robot LEO a coarse Q⁻ for all that is negative falls 15 times as often; if it holds the falls alone, as here, it falls as often as one Q-function.</source>
        <translation>Laat ze vóór stap 5 stemmen: verwacht “hoe grover, hoe beter”. De eerlijke vergelijking van stap 7 wordt makkelijk vergeten: één grove Q-functie. Gemeten met de seeds 1 tot en met 10, elk tien levens van zes minuten: fijn 65 tot 77 valpartijen, Q⁻ 0,4 44 tot 50, Q⁻ 0,1 198 tot 282, beide 0,4 69 tot 76; elk interval ertussen zegt dat, behalve dat tussen fijn en beide grof, die in valpartijen weinig verschillen. Met beide grof wordt het doel in zes minuten ongeveer 770 keer bereikt in plaats van ongeveer 1 300. Eén leven liet in 2 van de 10 seeds het tegendeel zien, vandaar tien. Op de looprobot LEO valt een grove Q⁻ voor alles wat negatief is 15 keer zo vaak; bevat hij alleen de valpartijen, zoals hier, dan valt hij even vaak als één Q-functie.</translation>
    </message>
    <message>
        <source>Look at how far the dots of both overlap, not only at the means.</source>
        <translation>Kijk hoe ver de punten van beide overlappen, niet alleen naar de gemiddelden.</translation>
    </message>
    <message>
        <source>Look at the dots of both, and at the bars of their means.</source>
        <translation>Kijk naar de punten van beide, en naar de balken van hun gemiddelden.</translation>
    </message>
    <message>
        <source>Look at the dots, not at the means alone.</source>
        <translation>Kijk naar de punten, niet alleen naar de gemiddelden.</translation>
    </message>
    <message>
        <source>Look at the dots: none of them is near 0.</source>
        <translation>Kijk naar de punten: geen ervan ligt bij 0.</translation>
    </message>
    <message>
        <source>Look at the first seven steps: no reward came, none was expected, δ = 0.</source>
        <translation>Kijk naar de eerste zeven stappen: er kwam geen beloning, er werd geen verwacht, δ = 0.</translation>
    </message>
    <message>
        <source>Look at the map: has it ever learned a value here?</source>
        <translation>Kijk naar de kaart: heeft hij hier ooit een waarde geleerd?</translation>
    </message>
    <message>
        <source>Look at the rewards: 0 for a fall, 200 for the goal.</source>
        <translation>Kijk naar de beloningen: 0 voor een val, 200 voor het doel.</translation>
    </message>
    <message>
        <source>Look at what it expects at 3°.</source>
        <translation>Kijk wat hij verwacht bij 3°.</translation>
    </message>
    <message>
        <source>Make Sarsa take the short way: bring its average reward to −13.5 or better.</source>
        <translation>Laat Sarsa de korte weg nemen: breng zijn gemiddelde beloning op −13,5 of beter.</translation>
    </message>
    <message>
        <source>Make it fall less often in six minutes than with the fine Q⁻, with a resolution of at most 0.35.</source>
        <translation>Laat hem in zes minuten minder vallen dan met de fijne Q⁻, met een resolutie van hoogstens 0,35.</translation>
    </message>
    <message>
        <source>Make it fall less than half as often as with ε = 0.05.</source>
        <translation>Laat hem minder dan half zo vaak vallen als met ε = 0,05.</translation>
    </message>
    <message>
        <source>Marks fade to γ λ with every step, and γ is 0.9. For which λ is that one half?</source>
        <translation>Bij elke stap vervagen merktekens tot γ λ keer hun sterkte, en γ is 0,9. Voor welke λ is dat de helft?</translation>
    </message>
    <message>
        <source>More lives.</source>
        <translation>Meer levens.</translation>
    </message>
    <message>
        <source>More.</source>
        <translation>Meer.</translation>
    </message>
    <message>
        <source>Neither simulation is exact. Look at what each of them made the robot expect.</source>
        <translation>Geen van beide simulaties is nauwkeurig. Kijk wat elk de robot liet verwachten.</translation>
    </message>
    <message>
        <source>No amount of learning gives two states in one tile different values.</source>
        <translation>Hoeveel je ook leert, twee toestanden in één tegel krijgen nooit verschillende waarden.</translation>
    </message>
    <message>
        <source>No formula is needed. Let everybody write a number down before step 3; expect low guesses from whoever thinks of balancing a broom on the hand. Forty lives (seeds 1 to 40) fell 68 to 93 times in their first 100 episodes, and 0 to 7 times in 100 after 20 minutes.

Step 2: the pole falls in a fraction of a second, so set the pace to its slowest before anybody grabs it. What one should notice is that the angle alone is not enough: the rate counts as well. Together with the wheel&apos;s rate they are the state.

Step 6: the wrong answers are reasonable guesses about machines. The point is that body and task are the same in both curves. A pole that leans too far cannot be saved with this motor; but no episode begins there.

Each student has numbers of his own, from his name.</source>
        <translation>Er is geen formule nodig. Laat iedereen vóór stap 3 een getal opschrijven; wie denkt aan het balanceren van een bezem op de hand, zal laag gokken. Veertig levens (seeds 1 tot en met 40) vielen 68 tot 93 keer in hun eerste 100 episodes, en 0 tot 7 keer in 100 na 20 minuten.

Stap 2: de stok valt in een fractie van een seconde, dus zet het tempo op het langzaamst voordat iemand hem vastpakt. Wat men hoort te merken: de hoek alleen is niet genoeg, de snelheid telt ook. Samen met de snelheid van het wiel vormen ze de toestand.

Stap 6: de foute antwoorden zijn redelijke vermoedens over machines. Het gaat erom dat lichaam en taak in beide curves dezelfde zijn. Een stok die te scheef staat is met deze motor niet te redden, maar geen enkele episode begint daar.

Elke student heeft eigen getallen, die uit zijn naam volgen.</translation>
    </message>
    <message>
        <source>Nobody shows LEO how to walk. Thirty times a second it does [one step of learning](lesson:one-step-of-learning), and [traces](lesson:whom-to-blame) carry each fall back to the steps before it. Metres are rewarded; the rest it must find. The thesis behind this program asked how LEO could learn without breaking. Watch where the curve of falls becomes flatter.</source>
        <translation>Niemand doet LEO het lopen voor. Dertig keer per seconde doet hij [één stap leren](lesson:one-step-of-learning), en [traces](lesson:whom-to-blame) dragen elke val terug naar de stappen ervoor. Meters worden beloond; de rest moet hij ontdekken. De scriptie achter dit programma vroeg hoe LEO kan leren zonder stuk te gaan. Kijk waar de curve van valpartijen vlakker wordt.</translation>
    </message>
    <message>
        <source>Nobody told this robot which torque is right. It found out by trying, and most of its first 100 episodes ended in a fall. In a simulation a fall costs nothing. A real robot can break.</source>
        <translation>Niemand heeft deze robot verteld welk koppel goed is. Hij ontdekte het door te proberen, en de meeste van zijn eerste 100 episodes eindigden in een val. In een simulatie kost een val niets. Een echte robot kan stukgaan.</translation>
    </message>
    <message>
        <source>Nothing in them is drawn: every episode begins alike, and greedy does not explore.</source>
        <translation>Er wordt niets geloot: elke episode begint gelijk, en greedy exploreert niet.</translation>
    </message>
    <message>
        <source>Nothing: it changes together with Q(8, right).</source>
        <translation>Niets: het verandert samen met Q(8, rechts).</translation>
    </message>
    <message>
        <source>Now drag the line to both ends: first below all five bars, then above all of them. Each time look how likely the worst action is.</source>
        <translation>Sleep de lijn nu naar beide uiteinden: eerst onder alle vijf balken, dan boven allemaal. Kijk elke keer hoe waarschijnlijk de slechtste actie is.</translation>
    </message>
    <message>
        <source>Now half of its steps are random. After a step to state 9 it sometimes goes *right*, sometimes *left*: what a step teaches depends on chance. In 20 lives of 500 episodes Q(8, right) ends between {least(&quot;α 0.02&quot;)} and {most(&quot;α 0.02&quot;)} with α = 0.02, and between {least(&quot;α 0.5&quot;)} and {most(&quot;α 0.5&quot;)} with α = 0.5.</source>
        <translation>Nu is de helft van zijn stappen willekeurig. Na een stap naar toestand 9 gaat hij soms naar *rechts*, soms naar *links*: wat een stap leert, hangt af van het toeval. In 20 levens van 500 episodes eindigt Q(8, rechts) tussen {least(&quot;α 0.02&quot;)} en {most(&quot;α 0.02&quot;)} met α = 0,02, en tussen {least(&quot;α 0.5&quot;)} en {most(&quot;α 0.5&quot;)} met α = 0,5.</translation>
    </message>
    <message>
        <source>Now it has practised for 20 minutes, by its own clock. The pole, the cart and the motor are the same as before. Here are 100 more episodes. As a beginner it fell {observed(3)} times.</source>
        <translation>Nu heeft hij 20 minuten geoefend, op zijn eigen klok. De stok, het karretje en de motor zijn dezelfde. Hier zijn nog eens 100 episodes. Als beginner viel hij {observed(3)} keer.</translation>
    </message>
    <message>
        <source>Now it leans and is at rest</source>
        <translation>Nu helt hij en is in rust</translation>
    </message>
    <message>
        <source>Now the two minutes after three minutes of learning. Falls on average: {mean(&quot;resolution 0.25, later&quot;)} with 0.25; {mean(&quot;resolution 1, later&quot;)} with 1; {mean(&quot;resolution 4, later&quot;)} with 4; {mean(&quot;resolution 8, later&quot;)} with 8. The order has changed: look who falls least now.</source>
        <translation>Nu de twee minuten na drie minuten leren. Gemiddeld aantal valpartijen: {mean(&quot;resolution 0.25, later&quot;)} met 0,25; {mean(&quot;resolution 1, later&quot;)} met 1; {mean(&quot;resolution 4, later&quot;)} met 4; {mean(&quot;resolution 8, later&quot;)} met 8. De volgorde is veranderd: kijk wie nu het minst valt.</translation>
    </message>
    <message>
        <source>Now two robots that do differ. One chooses by **Softmax** with τ = 1; the other is **greedy**: it always takes the best action it knows. Five lives of each. Does the interval of the difference hold 0?</source>
        <translation>Nu twee robots die wel verschillen. De ene kiest met **Softmax**, τ = 1; de andere is **greedy**: hij neemt altijd de beste actie die hij kent. Van elk vijf levens. Bevat het interval van het verschil de 0?</translation>
    </message>
    <message>
        <source>Now you choose. Turn the resolution; each time a new life begins from nothing. Run six minutes in turbo and count the falls. Try wide tiles, narrow tiles, and what lies between.</source>
        <translation>Nu kies jij. Draai aan de resolutie; elke keer begint een nieuw leven vanaf nul. Laat zes minuten in turbo lopen en tel de valpartijen. Probeer brede tegels, smalle tegels, en wat ertussenin ligt.</translation>
    </message>
    <message>
        <source>Obey it now</source>
        <translation>Gehoorzaam het nu</translation>
    </message>
    <message>
        <source>On a walking robot standing still is to fall. What would a large weight do there?</source>
        <translation>Voor een looprobot is stilstaan vallen. Wat zou een groot gewicht daar doen?</translation>
    </message>
    <message>
        <source>On average the ten lives needed {mean(&quot;λ 0&quot;)} steps with λ = 0 and {mean(&quot;λ 0.9&quot;)} with λ = 0.9. After the first fall *right* from state 2 was worth −32.8, wrongly. After 100 episodes, still with λ = 0.9, it is worth {q(&quot;right&quot;)}.</source>
        <translation>De tien levens hadden gemiddeld {mean(&quot;λ 0&quot;)} stappen nodig met λ = 0 en {mean(&quot;λ 0.9&quot;)} met λ = 0,9. Na de eerste val was *rechts* vanuit toestand 2 ten onrechte −32,8 waard. Na 100 episodes, nog steeds met λ = 0,9, is het {q(&quot;right&quot;)} waard.</translation>
    </message>
    <message>
        <source>On state 5: what is a step to the right worth, and what a step to the left?</source>
        <translation>Op toestand 5: wat is een stap naar rechts waard, en wat een stap naar links?</translation>
    </message>
    <message>
        <source>One fall</source>
        <translation>Eén val</translation>
    </message>
    <message>
        <source>One fall, many guilty steps: traces share out the blame (λ).</source>
        <translation>Eén val, veel schuldige stappen: traces verdelen de schuld (λ).</translation>
    </message>
    <message>
        <source>One forgets a fall in a few episodes.</source>
        <translation>Een val is na een paar episodes vergeten.</translation>
    </message>
    <message>
        <source>One goal must be enough</source>
        <translation>Eén doel moet genoeg zijn</translation>
    </message>
    <message>
        <source>One knob</source>
        <translation>Eén knop</translation>
    </message>
    <message>
        <source>One knob, another way</source>
        <translation>Eén knop, een andere weg</translation>
    </message>
    <message>
        <source>One life may be luck. So here are ten lives of each, each with a simulation of its own before. On average they fall {mean(&quot;ε 0.1&quot;)} and {mean(&quot;τ 1.5&quot;)} times. Think of the two states: in one the second best came close, {observed(1)} below the best; in the other it lay far below.</source>
        <translation>Eén leven kan geluk zijn. Daarom hier tien levens van elk, ieder met een eigen simulatie vooraf. Gemiddeld vallen ze {mean(&quot;ε 0.1&quot;)} en {mean(&quot;τ 1.5&quot;)} keer. Denk aan de twee toestanden: in de ene kwam de op een na beste in de buurt, {observed(1)} onder de beste; in de andere lag ze er ver onder.</translation>
    </message>
    <message>
        <source>One robot falls less often than another. Is it the better one, or had it luck? You judge from five lives, from thirty, and in pairs, and then read a claim as a referee would.</source>
        <translation>De ene robot valt minder vaak dan de andere. Is hij beter, of had hij geluk? Je oordeelt naar vijf levens, naar dertig, en in paren, en leest dan een bewering zoals een beoordelaar dat zou doen.</translation>
    </message>
    <message>
        <source>One step before</source>
        <translation>Eén stap eerder</translation>
    </message>
    <message>
        <source>One step in five explores. Among how many actions does it then draw?</source>
        <translation>Eén op de vijf stappen exploreert. Tussen hoeveel acties loot het dan?</translation>
    </message>
    <message>
        <source>One step in ten is random, and one random step in four goes down.</source>
        <translation>Eén op de tien stappen is willekeurig, en één op de vier willekeurige gaat naar beneden.</translation>
    </message>
    <message>
        <source>One step of learning</source>
        <translation>Eén stap leren</translation>
    </message>
    <message>
        <source>Only exploring brings chance into these lives. Ten greedy lives would need ten learned robots, not ten seeds.</source>
        <translation>Alleen exploreren brengt toeval in deze levens. Voor tien greedy levens zijn tien robots nodig die elk zelf geleerd hebben, niet tien seeds.</translation>
    </message>
    <message>
        <source>Only one step is worth less than 0: left from state 2. Look at the map of states 3 to 8.</source>
        <translation>Maar één stap is minder dan 0 waard: links vanuit toestand 2. Kijk op de kaart naar de toestanden 3 tot en met 8.</translation>
    </message>
    <message>
        <source>Only the step from 7 compares Q(7, right) with what comes after it, Q(8, A′).</source>
        <translation>Alleen de stap vanuit 7 vergelijkt Q(7, rechts) met wat erna komt, Q(8, A′).</translation>
    </message>
    <message>
        <source>Only the step left from state 2 leads to the fall. Look at the values of all the others.</source>
        <translation>Alleen de stap naar links vanuit toestand 2 leidt naar de val. Kijk naar de waarden van alle andere.</translation>
    </message>
    <message>
        <source>Only the step to the right from state 9 gives +100. Which state can learn from state 9?</source>
        <translation>Alleen de stap naar rechts vanuit toestand 9 geeft +100. Welke toestand kan van toestand 9 leren?</translation>
    </message>
    <message>
        <source>Only what it has learned is different: which torque helps at which angle and rate.</source>
        <translation>Alleen wat hij geleerd heeft is anders: welk koppel helpt bij welke hoek en snelheid.</translation>
    </message>
    <message>
        <source>Order them by falls in reality, the fewest first.</source>
        <translation>Zet ze op volgorde van valpartijen in de werkelijkheid, de minste eerst.</translation>
    </message>
    <message>
        <source>Pause first. The map has the same squares as the field; the cliff is its lowest row.</source>
        <translation>Pauzeer eerst. De kaart heeft dezelfde vakjes als het veld; de onderste rij is de afgrond.</translation>
    </message>
    <message>
        <source>Play a fall back</source>
        <translation>Speel een val terug</translation>
    </message>
    <message>
        <source>Punish falls harder?</source>
        <translation>Vallen zwaarder straffen?</translation>
    </message>
    <message>
        <source>Punished with −6400.</source>
        <translation>Gestraft met −6400.</translation>
    </message>
    <message>
        <source>Put it next to the edge</source>
        <translation>Zet hem naast de rand</translation>
    </message>
    <message>
        <source>Put the robot on a square at the edge, and let it go on.</source>
        <translation>Zet de robot op een vakje aan de rand, en laat hem doorgaan.</translation>
    </message>
    <message>
        <source>Q(3, left) is {observed(2)}. Now look at state 2. The robot had been here two steps earlier, too, and went *right*, away from the fall. That step is blamed as well: *right* is worth {q(&quot;right&quot;)} now, *left* {round(q(&quot;left&quot;))}.</source>
        <translation>Q(3, links) is {observed(2)}. Kijk nu naar toestand 2. De robot was hier twee stappen eerder ook al, en ging toen naar *rechts*, weg van de val. Ook die stap krijgt schuld: *rechts* is nu {q(&quot;right&quot;)} waard, *links* {round(q(&quot;left&quot;))}.</translation>
    </message>
    <message>
        <source>Q(7, right) is still 0. What must happen for it to change?</source>
        <translation>Q(7, rechts) is nog 0. Wat moet er gebeuren voordat het verandert?</translation>
    </message>
    <message>
        <source>Q(8, right) after 500 episodes</source>
        <translation>Q(8, rechts) na 500 episodes</translation>
    </message>
    <message>
        <source>Q-learning</source>
        <translation>Q-learning</translation>
    </message>
    <message>
        <source>Q-learning falls</source>
        <translation>Q-learning valt</translation>
    </message>
    <message>
        <source>Q-learning knows the better way and earns less. How can both be true?</source>
        <translation>Q-learning kent de betere weg en verdient minder. Hoe kan dat allebei waar zijn?</translation>
    </message>
    <message>
        <source>Q⁺ is as fine as before, and the goal as near.</source>
        <translation>Q⁺ is zo fijn als eerst, en het doel zo dichtbij.</translation>
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
        <translation>Q⁻ had 29 tegels in een hele omwenteling van de stok. Hoe breed is er nu een?</translation>
    </message>
    <message>
        <source>Rather a little too weak than too strong: the robot then takes more states for lost, and has something in reserve in reality. But not so weak that it cannot learn the task in the simulation.</source>
        <translation>Liever iets te zwak dan te sterk: de robot geeft dan meer toestanden verloren, en heeft in de werkelijkheid iets over. Maar niet zo zwak dat hij de taak in de simulatie niet kan leren.</translation>
    </message>
    <message>
        <source>Resolution 4 has learned just as long.</source>
        <translation>Resolutie 4 heeft even lang geleerd.</translation>
    </message>
    <message>
        <source>Row after five steps of its way</source>
        <translation>Rij na vijf stappen van zijn weg</translation>
    </message>
    <message>
        <source>Sarsa</source>
        <translation>Sarsa</translation>
    </message>
    <message>
        <source>Sarsa falls</source>
        <translation>Sarsa valt</translation>
    </message>
    <message>
        <source>Sarsa values what it really does, random steps included; Q-learning values what it would do without them.</source>
        <translation>Sarsa waardeert wat hij echt doet, willekeurige stappen inbegrepen; Q-learning waardeert wat hij zonder die stappen zou doen.</translation>
    </message>
    <message>
        <source>Set the weight so that it falls at most 15 times in 200 real episodes.</source>
        <translation>Stel het gewicht zo in dat hij in 200 echte episodes hoogstens 15 keer valt.</translation>
    </message>
    <message>
        <source>Set γ so that state 2 comes to be worth between 1 and 5, and put the robot on state 2.</source>
        <translation>Stel γ zo in dat toestand 2 tussen 1 en 5 waard wordt, en zet de robot op toestand 2.</translation>
    </message>
    <message>
        <source>Set λ so that after the first fall Q(3, left) is between −23 and −27.</source>
        <translation>Stel λ zo in dat Q(3, links) na de eerste val tussen −23 en −27 ligt.</translation>
    </message>
    <message>
        <source>Share it out by hand</source>
        <translation>Verdeel het met de hand</translation>
    </message>
    <message>
        <source>Six minutes with a coarse Q⁻</source>
        <translation>Zes minuten met een grove Q⁻</translation>
    </message>
    <message>
        <source>Six minutes, both fine</source>
        <translation>Zes minuten, beide fijn</translation>
    </message>
    <message>
        <source>Sixteen grids</source>
        <translation>Zestien roosters</translation>
    </message>
    <message>
        <source>Sixteen grids of resolution 1: how many different values can a full turn have?</source>
        <translation>Zestien roosters van resolutie 1: hoeveel verschillende waarden kan een hele omwenteling hebben?</translation>
    </message>
    <message>
        <source>So far a fall cost 100 points: its **reward** was −100. What if it cost nothing, or 1600? Robots that know nothing live 500 episodes, ten lives for each reward. On average they fall {mean(&quot;reward 0&quot;)} times with 0, {mean(&quot;reward −100&quot;)} times with −100 and {mean(&quot;reward −1600&quot;)} times with −1600. ε is 0.05 for all.</source>
        <translation>Tot nu toe kostte een val 100 punten: zijn **beloning** was −100. En als hij niets kostte, of 1600? Robots die niets weten leven 500 episodes, tien levens per beloning. Gemiddeld vallen ze {mean(&quot;reward 0&quot;)} keer met 0, {mean(&quot;reward −100&quot;)} keer met −100 en {mean(&quot;reward −1600&quot;)} keer met −1600. ε is bij allemaal 0,05.</translation>
    </message>
    <message>
        <source>So far all lives began with what one robot had learned. Now each life has a simulation of its own, with strong motors: ten simulations for ε = 0.05, and ten **others** for ε = 0.1. Some simulations teach more than others.</source>
        <translation>Tot nu toe begonnen alle levens met wat één robot had geleerd. Nu heeft elk leven een eigen simulatie, met sterke motoren: tien simulaties voor ε = 0,05, en tien **andere** voor ε = 0,1. Van sommige simulaties leert een robot meer dan van andere.</translation>
    </message>
    <message>
        <source>Softmax</source>
        <translation>Softmax</translation>
    </message>
    <message>
        <source>Softmax and greedy, five lives</source>
        <translation>Softmax en greedy, vijf levens</translation>
    </message>
    <message>
        <source>Softmax and greedy, thirty lives</source>
        <translation>Softmax en greedy, dertig levens</translation>
    </message>
    <message>
        <source>Softmax and ε-greedy</source>
        <translation>Softmax en ε-greedy</translation>
    </message>
    <message>
        <source>Softmax, again thirty</source>
        <translation>Softmax, weer dertig</translation>
    </message>
    <message>
        <source>Softmax, five</source>
        <translation>Softmax, vijf</translation>
    </message>
    <message>
        <source>Somebody claims: &quot;In thirty lives Softmax fell {mean(&quot;Softmax, again thirty&quot;)} times and ε-greedy {mean(&quot;ε-greedy, again thirty&quot;)} times; the interval leaves out 0. So Softmax is the way not to fall.&quot; You remember: greedy fell {mean(&quot;greedy&quot;)} times.</source>
        <translation>Iemand beweert: “In dertig levens viel Softmax {mean(&quot;Softmax, again thirty&quot;)} keer en ε-greedy {mean(&quot;ε-greedy, again thirty&quot;)} keer; het interval sluit de 0 uit. Dus is Softmax de manier om niet te vallen.” Je weet nog: greedy viel {mean(&quot;greedy&quot;)} keer.</translation>
    </message>
    <message>
        <source>Something between</source>
        <translation>Iets ertussenin</translation>
    </message>
    <message>
        <source>State 6 is worth {observed(2)}, which is 0.9³ · 100. State 2 lies seven steps from state 9: 0.9⁷ · 100 is about 48. Turn γ and let the robot go on: the map follows. Click state 2 to put the robot there; it reads the value.</source>
        <translation>Toestand 6 is {observed(2)} waard, en dat is 0,9³ · 100. Toestand 2 ligt zeven stappen van toestand 9: 0,9⁷ · 100 is ongeveer 48. Draai aan γ en laat de robot doorgaan: de kaart volgt. Klik op toestand 2 om de robot daar te zetten; de kaart geeft de waarde.</translation>
    </message>
    <message>
        <source>States that need different actions share a tile.</source>
        <translation>Toestanden die verschillende acties vragen delen een tegel.</translation>
    </message>
    <message>
        <source>Step 1: the values grow from the goal backwards, one state at a time. Let somebody say it aloud: &quot;the worth of a state is γ times the worth of the next one&quot;.

Step 6 is the one for a vote. Expect to hear that far-sighted is best, and 4 to 6 steps. With γ = 1 all values tie at 100, so the robot tosses a coin except at the edge of the fall. It takes about as long as with γ = 0, for the opposite reason: there all are worth 0. In step 8 any γ between, even 0.5, makes it go straight; only the size of the values changes.

For those who know the field: Q-learning with α = 1 and ε = 0.2, so that in this world without chance the values are exact and really tie. It takes one step in five at random; that is why 4.5 steps, the shortest possible, are not quite reached. γ = 1 is not wrong as such: at the cliff each step costs 1, and γ = 1 is the usual choice there.</source>
        <translation>Stap 1: de waarden groeien vanaf het doel terug, één toestand tegelijk. Laat iemand het hardop zeggen: “een toestand is γ keer zoveel waard als de volgende”.

Stap 6 leent zich voor een stemming. Verwacht te horen dat verziend het beste is, en 4 tot 6 stappen. Met γ = 1 zijn alle waarden gelijk aan 100, zodat de robot kop of munt gooit, behalve aan de rand van de val. Hij doet er ongeveer zo lang over als met γ = 0, om de omgekeerde reden: daar zijn ze allemaal 0 waard. In stap 8 laat elke γ ertussenin, zelfs 0,5, hem rechtdoor gaan; alleen de grootte van de waarden verandert.

Voor wie het vak kent: Q-learning met α = 1 en ε = 0,2, zodat de waarden in deze wereld zonder toeval exact zijn en echt gelijk worden. Eén op de vijf stappen is willekeurig; daarom worden 4,5 stappen, het kortst mogelijke, niet helemaal gehaald. γ = 1 is op zich niet fout: bij de cliff kost elke stap 1, en daar is γ = 1 de gebruikelijke keuze.</translation>
    </message>
    <message>
        <source>Step 3 computes for about ten seconds, on a slow machine for half a minute: talk meanwhile. Seeds 1 to 4, one life each: first ten minutes 300 to 383 falls, two hours 768 to 1,897, the ten minutes after 13 to 46; on the other robot in ten minutes ε 0.05 6 to 45, greedy 0 to 11, and greedy less every time. The recipe walker-mismatch has 25 learned robots and a whole hour: ε 0.05 163 ± 36 falls, ε 0.01 65 ± 19, greedy 34 ± 14. With which of them a life begins matters more than the policy: greedy falls 1 to 137 times in that hour. What they should not take home: that greedy is best for learning from nothing. There it falls less, too, but only 13 of 30 lives walk at the end, with ε 0.05 25 of 30 (recipe walker-scratch).</source>
        <translation>Stap 3 rekent ongeveer tien seconden, op een trage machine een halve minuut: praat ondertussen. Seeds 1 tot en met 4, elk één leven: eerste tien minuten 300 tot 383 valpartijen, twee uur 768 tot 1 897, de tien minuten daarna 13 tot 46; op de andere robot in tien minuten ε 0,05 6 tot 45, greedy 0 tot 11, en greedy elke keer minder. Het recept walker-mismatch heeft 25 robots die geleerd hebben en een heel uur: ε 0,05 163 ± 36 valpartijen, ε 0,01 65 ± 19, greedy 34 ± 14. Met welke daarvan een leven begint doet er meer toe dan de policy: greedy valt in dat uur 1 tot 137 keer. Wat ze niet mee naar huis moeten nemen: dat greedy het beste is om vanaf nul te leren. Ook daar valt het minder, maar aan het eind lopen er maar 13 van de 30 levens, met ε 0,05 25 van de 30 (recept walker-scratch).</translation>
    </message>
    <message>
        <source>Steps in the first ten episodes</source>
        <translation>Stappen in de eerste tien episodes</translation>
    </message>
    <message>
        <source>Steps per episode, over 300 episodes</source>
        <translation>Stappen per episode, over 300 episodes</translation>
    </message>
    <message>
        <source>Steps per episode: {observed(4)} with γ = 0.9, {observed(5)} with γ = 0. Now **γ = 1**: a reward counts in full, however far away it is. The robot begins again and lives 300 episodes.</source>
        <translation>Stappen per episode: {observed(4)} met γ = 0,9, {observed(5)} met γ = 0. Nu **γ = 1**: een beloning telt volledig, hoe ver weg ook. De robot begint opnieuw en leeft 300 episodes.</translation>
    </message>
    <message>
        <source>Steps with an action other than the best, of 100</source>
        <translation>Stappen met een andere actie dan de beste, van 100</translation>
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
        <translation>TRL met een drempel van 50 viel minder dan ε-greedy met dezelfde ε. Maar wie zegt dat ε 0,2 moet zijn? Van elk tien levens: TRL 50 met ε = 0,2, en gewone ε-greedy met ε = 0,05.</translation>
    </message>
    <message>
        <source>Take the pole in your hand</source>
        <translation>Neem de stok in de hand</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatuur</translation>
    </message>
    <message>
        <source>Ten lives each: on average {mean(&quot;Q⁻ 1&quot;)} falls with resolution 1 of Q⁻, {mean(&quot;Q⁻ 0.4&quot;)} with 0.4 and {mean(&quot;Q⁻ 0.1&quot;)} with **0.1**. Here is one with 0.1 after 20 episodes, held nearly upright, at 3°. Two of its five actions promise a heavy loss there: {q(&quot;0&quot;)} and {q(&quot;1.5&quot;)}.</source>
        <translation>Elk tien levens: gemiddeld {mean(&quot;Q⁻ 1&quot;)} valpartijen met resolutie 1 van Q⁻, {mean(&quot;Q⁻ 0.4&quot;)} met 0,4 en {mean(&quot;Q⁻ 0.1&quot;)} met **0,1**. Hier is er een met 0,1 na 20 episodes, bijna rechtop vastgehouden, op 3°. Twee van zijn vijf acties beloven daar een zwaar verlies: {q(&quot;0&quot;)} en {q(&quot;1.5&quot;)}.</translation>
    </message>
    <message>
        <source>Ten lives give an interval of ± 4 falls. About how many give ± 1?</source>
        <translation>Tien levens geven een interval van ± 4 valpartijen. Hoeveel geven er ongeveer ± 1?</translation>
    </message>
    <message>
        <source>Ten lives of each</source>
        <translation>Tien levens van elk</translation>
    </message>
    <message>
        <source>Ten lives with each resolution, the first two minutes. Falls on average: {mean(&quot;resolution 0.25&quot;)} with 0.25; {mean(&quot;resolution 1&quot;)} with 1; {mean(&quot;resolution 4&quot;)} with 4; {mean(&quot;resolution 8&quot;)} with 8.</source>
        <translation>Tien levens met elke resolutie, de eerste twee minuten. Gemiddeld aantal valpartijen: {mean(&quot;resolution 0.25&quot;)} met 0,25; {mean(&quot;resolution 1&quot;)} met 1; {mean(&quot;resolution 4&quot;)} met 4; {mean(&quot;resolution 8&quot;)} met 8.</translation>
    </message>
    <message>
        <source>Ten lives with each γ: at most {most(&quot;γ 0.9&quot;)} steps per episode with γ = 0.9, at least {least(&quot;γ 0&quot;)} with γ = 0, at least {least(&quot;γ 1&quot;)} with γ = 1. On the map states 2 to 9 are all worth 100 now. The goal is known, and still it takes its time.</source>
        <translation>Tien levens met elke γ: hoogstens {most(&quot;γ 0.9&quot;)} stappen per episode met γ = 0,9, minstens {least(&quot;γ 0&quot;)} met γ = 0, minstens {least(&quot;γ 1&quot;)} met γ = 1. Op de kaart zijn de toestanden 2 tot en met 9 nu allemaal 100 waard. Het doel is bekend, en toch neemt hij de tijd.</translation>
    </message>
    <message>
        <source>Ten minutes are 600 seconds. For how long does it stay up?</source>
        <translation>Tien minuten zijn 600 seconden. Hoe lang blijft hij overeind?</translation>
    </message>
    <message>
        <source>Ten pairs</source>
        <translation>Tien paren</translation>
    </message>
    <message>
        <source>Ten states in a row</source>
        <translation>Tien toestanden op een rij</translation>
    </message>
    <message>
        <source>Ten states in a row, a fall at one end and the goal at the other. You work out what a state is worth, turn the knob that decides how far a reward reaches, and watch what the robot makes of it.</source>
        <translation>Tien toestanden op een rij, aan het ene eind een val en aan het andere het doel. Je rekent uit wat een toestand waard is, draait aan de knop die bepaalt hoe ver een beloning reikt, en kijkt wat de robot ervan maakt.</translation>
    </message>
    <message>
        <source>Ten states in a row. State 1 is a fall: reward −100. State 10 is the goal: +100. All other steps give 0. The robot starts in between and steps left or right. The map shows what each state is worth so far: what the better step promises. Which state learns first?</source>
        <translation>Tien toestanden op een rij. Toestand 1 is een val: beloning −100. Toestand 10 is het doel: +100. Alle andere stappen geven 0. De robot begint ertussenin en stapt naar links of rechts. De kaart laat zien wat elke toestand tot nu toe waard is: wat de beste stap belooft. Welke toestand leert het eerst?</translation>
    </message>
    <message>
        <source>Ten states in a row: how far a reward reaches, from γ = 0 to γ = 1.</source>
        <translation>Tien toestanden op een rij: hoe ver een beloning reikt, van γ = 0 tot γ = 1.</translation>
    </message>
    <message>
        <source>The cliff: Sarsa or Q-learning?</source>
        <translation>De cliff: Sarsa of Q-learning?</translation>
    </message>
    <message>
        <source>The difference is there, but Softmax cannot be told from greedy. A method has to beat the best simple one.</source>
        <translation>Het verschil is er, maar Softmax is niet van greedy te onderscheiden. Een methode moet de beste eenvoudige verslaan.</translation>
    </message>
    <message>
        <source>The episodes are numbered along the bottom of the chart. The last twenty are at its right end.</source>
        <translation>De episodes zijn onderaan de grafiek genummerd. De laatste twintig staan rechts.</translation>
    </message>
    <message>
        <source>The falls of the other one</source>
        <translation>De valpartijen van de ander</translation>
    </message>
    <message>
        <source>The first surprise</source>
        <translation>De eerste verrassing</translation>
    </message>
    <message>
        <source>The first ten minutes</source>
        <translation>De eerste tien minuten</translation>
    </message>
    <message>
        <source>The first two minutes</source>
        <translation>De eerste twee minuten</translation>
    </message>
    <message>
        <source>The goal gives the same 100 as with γ = 0.9, where the robot hurried.</source>
        <translation>Het doel geeft dezelfde 100 als met γ = 0,9, waar de robot zich haastte.</translation>
    </message>
    <message>
        <source>The goal gives too little.</source>
        <translation>Het doel levert te weinig op.</translation>
    </message>
    <message>
        <source>The greedy robot still learns. From what?</source>
        <translation>De greedy robot leert nog steeds. Waarvan?</translation>
    </message>
    <message>
        <source>The idea in one sentence: what is learned (values and risk) and what is done with it (the policy) are two things, and only the second has to be careful in reality. The risk is a probability of its own (Geibel and Wysotzki 2005), learned as a value is, with a reward of 1 for a fall.

Why is a penalty not the same? While it learns in one world only, it is, exactly: choosing by Q − wρ with ρ on the tiles of Q is a fall reward lower by w, life for life. The difference is the change from one world to the other: a penalty must be there from the beginning, and makes the lesson timid.

Greedy is the fair opponent, because who does not explore does not fall from exploring. Ask for it before you show it: here it falls even more often, because it does what was right in the simulation and corrects it late. Ten lives each fell 75 times on average as bold as before, 93 greedy, 22 punished with −6400, 11 careful.</source>
        <translation>Het idee in één zin: wat geleerd wordt (waarden en risico) en wat ermee gedaan wordt (de policy) zijn twee dingen, en alleen het tweede moet in de werkelijkheid voorzichtig zijn. Het risico is een kans op zichzelf (Geibel en Wysotzki 2005), geleerd zoals een waarde, met een beloning van 1 voor een val.

Waarom is een straf niet hetzelfde? Zolang hij maar in één wereld leert, is ze dat precies: kiezen naar Q − wρ met ρ op de tegels van Q is een valbeloning die w lager is, leven voor leven. Het verschil zit in de overgang van de ene wereld naar de andere: een straf moet er vanaf het begin zijn, en maakt de robot in de les schuchter.

Greedy is de eerlijke tegenstander, want wie niet exploreert valt niet door exploreren. Vraag ernaar voordat je hem laat zien: hier valt hij zelfs vaker, omdat hij doet wat in de simulatie goed was en dat laat corrigeert. Tien levens vielen gemiddeld 75 keer als ze even dapper waren, 93 keer greedy, 22 keer gestraft met −6400, 11 keer voorzichtig.</translation>
    </message>
    <message>
        <source>The last step brought the first surprise: δ = 100, and Q(9, right) rose by 0.5 · 100 to 50. Now the robot is put on state 9 again and goes right again. The reward is R = 100. After the goal there is no next step, so γ Q(S′, A′) is 0.</source>
        <translation>De laatste stap bracht de eerste verrassing: δ = 100, en Q(9, rechts) steeg met 0,5 · 100 naar 50. Nu wordt de robot weer op toestand 9 gezet en gaat weer naar rechts. De beloning is R = 100. Na het doel is er geen volgende stap, dus γ Q(S′, A′) is 0.</translation>
    </message>
    <message>
        <source>The left robot explores with any action, also one that is worth far less than the best. The right one seldom takes such an action: how seldom, its temperature decides.</source>
        <translation>De linker robot exploreert met elke actie, ook een die veel minder waard is dan de beste. De rechter neemt zo&apos;n actie zelden: hoe zelden bepaalt zijn temperatuur.</translation>
    </message>
    <message>
        <source>The lesson was as bold as before, so it met many falls; what it learned of them is obeyed where it counts.</source>
        <translation>De les was even dapper als eerst, dus kwam hij veel valpartijen tegen; wat hij ervan leerde, gehoorzaamt hij waar het telt.</translation>
    </message>
    <message>
        <source>The map shows Q⁻ below. How much of it has a value at all?</source>
        <translation>De kaart toont onderaan Q⁻. Hoeveel ervan heeft eigenlijk een waarde?</translation>
    </message>
    <message>
        <source>The other robot, greedy</source>
        <translation>De andere robot, greedy</translation>
    </message>
    <message>
        <source>The pole falls to both sides alike. What would a tile of 360° say?</source>
        <translation>De stok valt naar beide kanten even gemakkelijk. Wat zou een tegel van 360° zeggen?</translation>
    </message>
    <message>
        <source>The practised robot begins as far over. Look at where its episodes begin.</source>
        <translation>De geoefende robot begint net zo scheef. Kijk waar zijn episodes beginnen.</translation>
    </message>
    <message>
        <source>The risk is a probability: it counts falls, whatever they cost.</source>
        <translation>Het risico is een kans: het telt valpartijen, wat ze ook kosten.</translation>
    </message>
    <message>
        <source>The robot begins again and lives 100 episodes. Each time it steps right from state 9 the reward is 100, and the surprise is half as large as the time before: 100, 50, 25 …</source>
        <translation>De robot begint opnieuw en leeft 100 episodes. Elke keer dat hij vanuit toestand 9 naar rechts stapt is de beloning 100, en de verrassing half zo groot als de keer ervoor: 100, 50, 25 …</translation>
    </message>
    <message>
        <source>The robot is told 200 and −100. What would it learn if a fall cost nothing?</source>
        <translation>De robot krijgt 200 en −100 te horen. Wat zou hij leren als een val niets kostte?</translation>
    </message>
    <message>
        <source>The robot knows nothing yet and walks at random until it falls: −100. α is 0.5. Only the last step learns from the fall: *left* from state 2 loses 50. Follow the walk. Did the steps before it have no part in the fall?</source>
        <translation>De robot weet nog niets en loopt willekeurig tot hij valt: −100. α is 0,5. Alleen de laatste stap leert van de val: *links* vanuit toestand 2 verliest 50. Volg de wandeling. Hadden de stappen ervoor er niets mee te maken?</translation>
    </message>
    <message>
        <source>The robot must reach the goal once more.</source>
        <translation>De robot moet het doel nog eens bereiken.</translation>
    </message>
    <message>
        <source>The robot must step from 7 to 8.</source>
        <translation>De robot moet van 7 naar 8 stappen.</translation>
    </message>
    <message>
        <source>The same beginning, but now the **resolution** of Q⁻, the knob *scale*, is 0.4 in place of 1: its tiles are wider. Q⁺ stays as it was. Again 20 episodes, {falls} falls. In the same state it now expects {q(&quot;0&quot;)}. With wider tiles a fall is felt further away.</source>
        <translation>Hetzelfde begin, maar nu is de **resolutie** van Q⁻, de knop *schaal*, 0,4 in plaats van 1: de tegels zijn breder. Q⁺ bleef gelijk. Weer 20 episodes, {falls} valpartijen. In dezelfde toestand verwacht hij nu {q(&quot;0&quot;)}. Met bredere tegels is een val verder weg te voelen.</translation>
    </message>
    <message>
        <source>The same once more, but in **pairs**: both ε begin with what was learned in the same ten simulations, and the difference within each pair is judged. What makes both lives of a pair good or bad drops out.</source>
        <translation>Hetzelfde nog eens, maar in **paren**: beide ε beginnen met wat in dezelfde tien simulaties is geleerd, en het verschil binnen elk paar wordt beoordeeld. Wat beide levens van een paar goed of slecht maakt, valt weg.</translation>
    </message>
    <message>
        <source>The same robot after 20 minutes</source>
        <translation>Dezelfde robot na 20 minuten</translation>
    </message>
    <message>
        <source>The same robot could obey its risk in the simulation already. Then it would fall less there, too.</source>
        <translation>Dezelfde robot zou zijn risico al in de simulatie kunnen gehoorzamen. Dan zou hij ook daar minder vallen.</translation>
    </message>
    <message>
        <source>The same step again</source>
        <translation>Dezelfde stap nog eens</translation>
    </message>
    <message>
        <source>The states are cut into **tiles**, and states in one tile share their values. A full turn of the pole is cut into 12 tiles times the **resolution** (the knob *Scale*), here 0.25. The robot has learned from nothing for two minutes. The map has two of them, one for each side, and ends before they do.</source>
        <translation>De toestanden worden verdeeld in **tegels**, en toestanden in één tegel delen hun waarden. Een hele omwenteling van de stok wordt verdeeld in 12 tegels maal de **resolutie** (de knop *Schaal*), hier 0,25. De robot heeft twee minuten vanaf nul geleerd. De kaart laat er twee zien, een voor elke kant, en houdt eerder op dan zij.</translation>
    </message>
    <message>
        <source>The step into the goal changes Q(9, right) only. Look at what the last step changed.</source>
        <translation>De stap naar het doel verandert alleen Q(9, rechts). Kijk wat de laatste stap veranderde.</translation>
    </message>
    <message>
        <source>The steps it takes</source>
        <translation>De stappen die hij doet</translation>
    </message>
    <message>
        <source>The ten minutes after</source>
        <translation>De tien minuten daarna</translation>
    </message>
    <message>
        <source>The walk to the first fall is 4, 3, 4, 3, 2, 3, 2, fall, for everybody: nothing is learned before it, so λ does not change it. Draw it on the board and let the class say who is guilty before step 2.

Step 2: whoever says 45 has forgotten γ or λ. The marks fade by the product.

Strictly, every step but the last could still be undone here. On a robot it is otherwise: when a pole falls, the last steps cannot save it any more, and those that could were taken earlier.

Step 3 is the heart: *right* from state 2 was the step that saved the robot, and it loses 32.8. Those who say that all actions of a state are blamed have a point in other programs, not here: *left* lost 50.

Step 5 and 6: with λ = 0 this life needs 7 goals until it stands on state 5 and knows, with λ = 0.9 it needs 2. Over 24 other seeds it was 5 to 14 with λ = 0, 1 to 6 with λ = 0.9, and never more with λ = 0.9 than with λ = 0. That it is not always 1 has two reasons: the first way to the goal need not lead past state 5, and the robot has to be on state 5 to show that it knows.</source>
        <translation>De wandeling tot de eerste val is voor iedereen 4, 3, 4, 3, 2, 3, 2, val: ervóór wordt niets geleerd, dus λ verandert haar niet. Teken haar op het bord en laat de klas vóór stap 2 zeggen wie schuldig is.

Stap 2: wie 45 zegt is γ of λ vergeten. De merktekens vervagen met het product.

Strikt genomen had elke stap behalve de laatste hier nog goedgemaakt kunnen worden. Bij een robot is dat anders: als een stok valt, kunnen de laatste stappen hem niet meer redden, en die het konden zijn eerder gedaan.

Stap 3 is de kern: *rechts* vanuit toestand 2 was de stap die de robot redde, en hij verliest 32,8. Wie zegt dat alle acties van een toestand schuld krijgen, heeft in andere programma&apos;s een punt, maar hier niet: *links* verloor 50.

Stap 5 en 6: met λ = 0 heeft dit leven 7 doelen nodig tot het op toestand 5 staat en het weet, met λ = 0,9 zijn het er 2. Over 24 andere seeds waren het er 5 tot 14 met λ = 0, 1 tot 6 met λ = 0,9, en nooit meer met λ = 0,9 dan met λ = 0. Dat het niet altijd 1 is, heeft twee redenen: de eerste weg naar het doel hoeft niet langs toestand 5 te leiden, en de robot moet op toestand 5 staan om te tonen dat hij het weet.</translation>
    </message>
    <message>
        <source>The way of good news, λ = 0</source>
        <translation>De weg van goed nieuws, λ = 0</translation>
    </message>
    <message>
        <source>The way of good news, λ = 0.9</source>
        <translation>De weg van goed nieuws, λ = 0,9</translation>
    </message>
    <message>
        <source>The weight is a knob for reality alone: turn it while the robot lives, and nothing must be learned anew. It begins at 0. A penalty is not such a knob: it is part of what was learned.</source>
        <translation>Het gewicht is een knop voor de werkelijkheid alleen: draai eraan terwijl de robot leeft, er hoeft niets opnieuw geleerd te worden. Het begint op 0. Een straf is niet zo&apos;n knop: die hoort bij wat geleerd is.</translation>
    </message>
    <message>
        <source>The wheel&apos;s rate is cut into tiles, too. Would you give it the same width as the pole&apos;s angle?</source>
        <translation>Ook de snelheid van het wiel wordt in tegels verdeeld. Zou je die dezelfde breedte geven als de hoek van de stok?</translation>
    </message>
    <message>
        <source>The ε-greedy lives differ within the same three minutes.</source>
        <translation>De ε-greedy levens verschillen in dezelfde drie minuten.</translation>
    </message>
    <message>
        <source>Then both would be worth the same. Look at the two bars.</source>
        <translation>Dan waren beide evenveel waard. Kijk naar de twee balken.</translation>
    </message>
    <message>
        <source>Then it would expect a gain. It expects nearly nothing.</source>
        <translation>Dan zou hij winst verwachten. Hij verwacht bijna niets.</translation>
    </message>
    <message>
        <source>Then those that stop exploring would fall as often. Look at the dots.</source>
        <translation>Dan zouden robots die stoppen met exploreren even vaak vallen. Kijk naar de punten.</translation>
    </message>
    <message>
        <source>There are 343 actions, and a state is ten numbers. No table can hold each state by itself; 16 displaced grids of tiles share them out. It begins again, with ε = 0.05. Ten simulated minutes take the computer a second or two.</source>
        <translation>Er zijn 343 acties, en een toestand bestaat uit tien getallen. Geen tabel kan elke toestand apart bevatten; 16 verschoven roosters van tegels verdelen ze. Hij begint opnieuw, met ε = 0,05. Tien gesimuleerde minuten kosten de computer een of twee seconden.</translation>
    </message>
    <message>
        <source>There is another opponent. The **greedy** policy always takes the best action it knows: it takes another in 0 of 100 steps. Ten lives each, greedy and Softmax with τ = 1.5. The program judges the difference life by life: if its 95 % interval holds 0, one cannot tell.</source>
        <translation>Er is nog een tegenstander. De **greedy** policy neemt altijd de beste actie die ze kent: in 0 van 100 stappen een andere. Elk tien levens, greedy en Softmax met τ = 1,5. Het programma beoordeelt het verschil leven voor leven: bevat het 95%-interval de 0, dan is er niets te zeggen.</translation>
    </message>
    <message>
        <source>They forget sooner.</source>
        <translation>Ze vergeten eerder.</translation>
    </message>
    <message>
        <source>They have nothing left to learn.</source>
        <translation>Ze hebben niets meer te leren.</translation>
    </message>
    <message>
        <source>They keep what they learned, as wide ones do.</source>
        <translation>Ze bewaren wat ze leerden, net als brede.</translation>
    </message>
    <message>
        <source>They learn from every step, as the others do.</source>
        <translation>Ze leren van elke stap, net als de andere.</translation>
    </message>
    <message>
        <source>They tell more apart than wider ones.</source>
        <translation>Ze onderscheiden er meer dan bredere.</translation>
    </message>
    <message>
        <source>They tell too few states apart.</source>
        <translation>Ze onderscheiden te weinig toestanden.</translation>
    </message>
    <message>
        <source>Think of the two states: which actions did Softmax hardly ever take?</source>
        <translation>Denk aan de twee toestanden: welke acties nam Softmax bijna nooit?</translation>
    </message>
    <message>
        <source>Thirty lives of each</source>
        <translation>Dertig levens van elk</translation>
    </message>
    <message>
        <source>Thirty were enough: the interval leaves out 0.</source>
        <translation>Dertig waren genoeg: het interval sluit de 0 uit.</translation>
    </message>
    <message>
        <source>This Sarsa walks {observed(2)} steps. **Q-learning** values a step by the best step that it could take next. Ten lives of each learned for 500 episodes; then they walk without exploring. The dots show their row after five steps: row 1 is the edge, row 3 the top.</source>
        <translation>Deze Sarsa loopt {observed(2)} stappen. **Q-learning** waardeert een stap naar de beste stap die hij daarna zou kunnen doen. Van elk leerden tien levens 500 episodes; dan lopen ze zonder te exploreren. De punten tonen hun rij na vijf stappen: rij 1 is de rand, rij 3 ligt bovenaan.</translation>
    </message>
    <message>
        <source>This is Example 6.6 of Sutton and Barto, with their ε = 0.1 and γ = 1, and α = 0.3. Say &quot;the short way&quot; and &quot;the long way&quot; until step 3, not the names: that is the prediction.

Step 2: whoever knows shortest-path problems may say 13. Of 200 Sarsa lives that we tried 184 had a way of 17 steps, 5 of 15, 3 of 19, and 8 went in a circle, because their values were still noisy when learning stopped. After five steps 198 of them were on row 2 or 3. Q-learning&apos;s way had 13 steps in all lives that we tried.

Step 6 has a trap: to set ε to 0 without starting again does not change the way. What the squares at the edge are worth was learned with falls, and without exploring the robot never goes there to correct it. That is worth a discussion of its own. A very small ε is not enough either: at 0.005 most lives still keep off the edge.

Which is better? While they explore Sarsa earns more (about −23 against −48 in the last 80 episodes), afterwards Q-learning does (−13 against −17). &quot;Better&quot; needs a &quot;when&quot;.

Step 7: of ten lives each falls about twelve times, once for each way over the edge, and its way has 13 steps. With ε = 0 it falls as rarely; but this one goes on exploring, in one step of fifteen. To forbid the greedy action as well (the rule *filter*) does not work here: standing still in a corner is the safest of all.</source>
        <translation>Dit is voorbeeld 6.6 van Sutton en Barto, met hun ε = 0,1 en γ = 1, en α = 0,3. Zeg tot stap 3 “de korte weg” en “de lange weg”, niet de namen: dat is de voorspelling.

Stap 2: wie kortste-padproblemen kent, zegt misschien 13. Van 200 levens van Sarsa die we probeerden, hadden er 184 een weg van 17 stappen, 5 van 15, 3 van 19, en 8 liepen in een kring, omdat hun waarden nog ruis bevatten toen het leren stopte. Na vijf stappen waren er 198 op rij 2 of 3. De weg van Q-learning had in alle levens die we probeerden 13 stappen.

Stap 6 heeft een valstrik: ε op 0 zetten zonder opnieuw te beginnen verandert de weg niet. Wat de vakjes aan de rand waard zijn, is met valpartijen geleerd, en zonder exploreren komt de robot daar nooit om het te corrigeren. Dat is een eigen gesprek waard. Een heel kleine ε is ook niet genoeg: met 0,005 blijven de meeste levens nog van de rand af.

Welke is beter? Zolang ze exploreren verdient Sarsa meer (ongeveer −23 tegen −48 in de laatste 80 episodes), daarna Q-learning (−13 tegen −17). Bij “beter” hoort een “wanneer”.

Stap 7: van tien levens valt elk ongeveer twaalf keer, één keer voor elke manier om over de rand te gaan, en zijn weg heeft 13 stappen. Met ε = 0 valt hij even zelden; maar deze blijft exploreren, in één op de vijftien stappen. Ook de greedy actie verbieden (de regel *filter*) werkt hier niet: stilstaan in een hoek is het veiligst van alles.</translation>
    </message>
    <message>
        <source>This is Sarsa again, after 500 episodes with ε = 0.1. Turn one knob, then press Restart, the round arrow: it must learn anew. A way of 13 steps without a fall gives a reward of −13 an episode. Look at the average reward of the last 80 episodes.</source>
        <translation>Dit is weer Sarsa, na 500 episodes met ε = 0,1. Draai aan één knop en druk dan op Opnieuw, de ronde pijl: hij moet opnieuw leren. Een weg van 13 stappen zonder val geeft een beloning van −13 per episode. Kijk naar de gemiddelde beloning van de laatste 80 episodes.</translation>
    </message>
    <message>
        <source>This robot has learned in a simulation. Its pole leans a little and swings back up. The bars show what each action is worth, **Q**, and how likely **Softmax** takes it: the better, the likelier. One knob sets how much likelier, the temperature **τ**. Drag it down and up; type 1000 into its number.</source>
        <translation>Deze robot heeft in een simulatie geleerd. Zijn stok helt een beetje en zwaait terug omhoog. De balken tonen wat elke actie waard is, **Q**, en hoe vaak **Softmax** haar kiest: hoe beter, hoe vaker. Eén knop bepaalt hoeveel vaker, de temperatuur **τ**. Sleep hem omlaag en omhoog; typ 1000 in het getalvak.</translation>
    </message>
    <message>
        <source>This robot learned for ten minutes in a simulation whose motors are **2.5 times too strong**. It chooses by Softmax, with τ = 1. Now it lives 200 episodes in reality, as boldly as in the simulation. Count its falls.</source>
        <translation>Deze robot leerde tien minuten in een simulatie met motoren die **2,5 keer te sterk** zijn. Hij kiest met Softmax, τ = 1. Nu leeft hij 200 episodes in de werkelijkheid, net zo dapper als in de simulatie. Tel zijn valpartijen.</translation>
    </message>
    <message>
        <source>This robot learned in a simulation that was not quite right. Now it stands in reality. With **ε = 0.05** it takes one action in 20 at random: it **explores**, to see whether there is something better. Here are its first 200 episodes.</source>
        <translation>Deze robot heeft geleerd in een simulatie die niet helemaal klopte. Nu staat hij in de werkelijkheid. Met **ε = 0,05** kiest hij één op de 20 acties willekeurig: hij **exploreert**, om te zien of er iets beters is. Hier zijn zijn eerste 200 episodes.</translation>
    </message>
    <message>
        <source>Those that stopped exploring still know it. Look at the dots.</source>
        <translation>Robots die stopten met exploreren weten het nog. Kijk naar de punten.</translation>
    </message>
    <message>
        <source>Three lives of each</source>
        <translation>Drie levens van elk</translation>
    </message>
    <message>
        <source>Three minutes are too short to differ.</source>
        <translation>Drie minuten is te kort om te verschillen.</translation>
    </message>
    <message>
        <source>Three thresholds, ten lives each</source>
        <translation>Drie drempels, elk tien levens</translation>
    </message>
    <message>
        <source>Tiles: too coarse, too fine</source>
        <translation>Tegels: te grof, te fijn</translation>
    </message>
    <message>
        <source>True, but look at the other end, too.</source>
        <translation>Klopt, maar kijk ook naar het andere uiteinde.</translation>
    </message>
    <message>
        <source>Try resolutions between 1 and 4.</source>
        <translation>Probeer resoluties tussen 1 en 4.</translation>
    </message>
    <message>
        <source>Turn it far to the right, then let it run.</source>
        <translation>Draai het ver naar rechts, en laat het dan lopen.</translation>
    </message>
    <message>
        <source>Turn γ</source>
        <translation>Draai aan γ</translation>
    </message>
    <message>
        <source>Twenty different simulations</source>
        <translation>Twintig verschillende simulaties</translation>
    </message>
    <message>
        <source>Two Q-functions, one for gains and one for losses (Sarsa_2Q).</source>
        <translation>Twee Q-functies, een voor winst en een voor verlies (Sarsa_2Q).</translation>
    </message>
    <message>
        <source>Two Q-functions: **Q⁺** expects gains (200 at the goal), **Q⁻** losses (−400 a fall). The robot acts on the sum. Both cut the states into **tiles**; what is learned in a tile holds for all of it. After 20 episodes from nothing and {falls} falls it is held at 34°, falling. It expects {q(&quot;0&quot;)}.</source>
        <translation>Twee Q-functies: **Q⁺** verwacht winst (200 bij het doel), **Q⁻** verlies (−400 per val). De robot handelt naar de som. Beide verdelen de toestanden in **tegels**; wat in een tegel geleerd is, geldt er overal. Na 20 episodes vanaf nul en {falls} valpartijen wordt hij vastgehouden op 34°, vallend. Hij verwacht {q(&quot;0&quot;)}.</translation>
    </message>
    <message>
        <source>Two ends of the line</source>
        <translation>Twee uiteinden van de lijn</translation>
    </message>
    <message>
        <source>Two hours, and something to read</source>
        <translation>Twee uur, en iets te lezen</translation>
    </message>
    <message>
        <source>Two minutes later on</source>
        <translation>Twee minuten, later</translation>
    </message>
    <message>
        <source>Two robots cross the same field, along a cliff. One learns from what it does, the other from what it could do best. Which way will each of them take, and what does it cost?</source>
        <translation>Twee robots steken hetzelfde veld over, langs een afgrond. De een leert van wat hij doet, de ander van wat hij het best zou kunnen doen. Welke weg kiest elk, en wat kost dat?</translation>
    </message>
    <message>
        <source>Two robots differ by 0.1 falls in 200 episodes, and the interval leaves out 0. Does it matter?</source>
        <translation>Twee robots verschillen 0,1 val in 200 episodes, en het interval sluit de 0 uit. Doet dat ertoe?</translation>
    </message>
    <message>
        <source>Two robots, A and B, five lives each of 200 episodes. A dot is one life; a bar is the 95 % interval of the mean. Say what you think. Then the program judges by the interval of the **difference**: if it holds 0, one cannot tell.</source>
        <translation>Twee robots, A en B, elk vijf levens van 200 episodes. Een punt is één leven; een balk is het 95%-interval van het gemiddelde. Zeg wat je denkt. Daarna oordeelt het programma naar het interval van het **verschil**: bevat het de 0, dan is er niets te zeggen.</translation>
    </message>
    <message>
        <source>Two rules and one edge: the short way or the safe way.</source>
        <translation>Twee regels en één rand: de korte of de veilige weg.</translation>
    </message>
    <message>
        <source>Two simulated hours are over: **{observed(3)} falls**, {observed(2)} of them in the first ten minutes. Now the next ten minutes, still with ε = 0.05, on the same robot.</source>
        <translation>Twee gesimuleerde uren zijn voorbij: **{observed(3)} valpartijen**, waarvan {observed(2)} in de eerste tien minuten. Nu de volgende tien minuten, nog steeds met ε = 0,05, op dezelfde robot.</translation>
    </message>
    <message>
        <source>Two ways</source>
        <translation>Twee wegen</translation>
    </message>
    <message>
        <source>Until it has its first successes, a fall teaches it nothing.</source>
        <translation>Tot zijn eerste successen leert een val hem niets.</translation>
    </message>
    <message>
        <source>Very high ones.</source>
        <translation>Heel hoge.</translation>
    </message>
    <message>
        <source>Very low and very high ones.</source>
        <translation>Heel lage en heel hoge.</translation>
    </message>
    <message>
        <source>Very low ones.</source>
        <translation>Heel lage.</translation>
    </message>
    <message>
        <source>Very narrow tiles</source>
        <translation>Heel smalle tegels</translation>
    </message>
    <message>
        <source>Very wide tiles</source>
        <translation>Heel brede tegels</translation>
    </message>
    <message>
        <source>Was that fair?</source>
        <translation>Was dat eerlijk?</translation>
    </message>
    <message>
        <source>Watch a beginner</source>
        <translation>Kijk naar een beginner</translation>
    </message>
    <message>
        <source>Watch it with ε = 0.05</source>
        <translation>Kijk naar ε = 0,05</translation>
    </message>
    <message>
        <source>Watch it, push it, play a fall back. No formula yet.</source>
        <translation>Kijk toe, geef een duw, speel een val terug. Nog geen formules.</translation>
    </message>
    <message>
        <source>Weak motors are more exact.</source>
        <translation>Zwakke motoren zijn nauwkeuriger.</translation>
    </message>
    <message>
        <source>What a robot learns</source>
        <translation>Wat een robot leert</translation>
    </message>
    <message>
        <source>What can a robot learn from that has not balanced the pole yet?</source>
        <translation>Waarvan kan een robot leren die de stok nog niet in balans heeft gekregen?</translation>
    </message>
    <message>
        <source>What do wide tiles do well, what do narrow ones, and why 16 grids?</source>
        <translation>Wat doen brede tegels goed, wat smalle, en waarom 16 roosters?</translation>
    </message>
    <message>
        <source>What do you ask for first?</source>
        <translation>Waar vraag je het eerst om?</translation>
    </message>
    <message>
        <source>What does a fall cost?</source>
        <translation>Wat kost een val?</translation>
    </message>
    <message>
        <source>What does a mark know about a step: where it led, or how long ago it was?</source>
        <translation>Wat weet een merkteken van een stap: waar hij heen leidde, of hoe lang geleden hij was?</translation>
    </message>
    <message>
        <source>What does a seed decide? What is left of that in a greedy life?</source>
        <translation>Wat bepaalt een seed? Wat blijft daarvan over in een greedy leven?</translation>
    </message>
    <message>
        <source>What does a threshold of 50 mean if all rewards are doubled?</source>
        <translation>Wat betekent een drempel van 50 als alle beloningen worden verdubbeld?</translation>
    </message>
    <message>
        <source>What does each of the two count as the next step, after a step along the edge?</source>
        <translation>Wat telt voor elk van beide als de volgende stap, na een stap langs de rand?</translation>
    </message>
    <message>
        <source>What does the map say about states 3 to 8?</source>
        <translation>Wat zegt de kaart over de toestanden 3 tot en met 8?</translation>
    </message>
    <message>
        <source>What does the rule of thumb assume about the rewards? Where would it not hold?</source>
        <translation>Wat neemt de vuistregel over de beloningen aan? Waar zou hij niet gelden?</translation>
    </message>
    <message>
        <source>What does γ decide, and which γ would you give this robot?</source>
        <translation>Wat bepaalt γ, en welke γ zou jij deze robot geven?</translation>
    </message>
    <message>
        <source>What does λ = 1 do, and would you want it?</source>
        <translation>Wat doet λ = 1, en zou je dat willen?</translation>
    </message>
    <message>
        <source>What does λ do, and what is the price of a large one?</source>
        <translation>Wat doet λ, en wat kost een grote?</translation>
    </message>
    <message>
        <source>What else can it bring along?</source>
        <translation>Wat kan hij nog meer meenemen?</translation>
    </message>
    <message>
        <source>What else of a simulation can be wrong to the safe side: friction, weight, delay?</source>
        <translation>Wat kan er in een simulatie nog meer naar de veilige kant verkeerd zijn: wrijving, gewicht, vertraging?</translation>
    </message>
    <message>
        <source>What happens to Sarsa&apos;s way if ε shrinks slowly while it learns?</source>
        <translation>Wat gebeurt er met de weg van Sarsa als ε tijdens het leren langzaam krimpt?</translation>
    </message>
    <message>
        <source>What have the two groups in common, and in what do they differ?</source>
        <translation>Wat hebben de twee groepen gemeen, en waarin verschillen ze?</translation>
    </message>
    <message>
        <source>What is Q(8, right) afterwards?</source>
        <translation>Hoe groot is Q(8, rechts) daarna?</translation>
    </message>
    <message>
        <source>What is Q(9, right) afterwards?</source>
        <translation>Hoe groot is Q(9, rechts) daarna?</translation>
    </message>
    <message>
        <source>What is a state worth?</source>
        <translation>Wat is een toestand waard?</translation>
    </message>
    <message>
        <source>What is a way worth?</source>
        <translation>Wat is een weg waard?</translation>
    </message>
    <message>
        <source>What is different between the two, and what is the same?</source>
        <translation>Wat is er anders aan de twee, en wat is hetzelfde?</translation>
    </message>
    <message>
        <source>What is exploring for, if less of it always falls less?</source>
        <translation>Waar is exploreren goed voor, als minder ervan altijd minder valt?</translation>
    </message>
    <message>
        <source>What is good about a large α, and what about a small one?</source>
        <translation>Wat is er goed aan een grote α, en wat aan een kleine?</translation>
    </message>
    <message>
        <source>What is state 6 worth?</source>
        <translation>Wat is toestand 6 waard?</translation>
    </message>
    <message>
        <source>What is worth 5τ less is taken about 150 times less often than the best; ε-greedy draws it as often as any.</source>
        <translation>Wat 5τ minder waard is, wordt ongeveer 150 keer minder vaak gekozen dan de beste; ε-greedy loot het even vaak als elke andere.</translation>
    </message>
    <message>
        <source>What it does with γ = 0</source>
        <translation>Wat hij doet met γ = 0</translation>
    </message>
    <message>
        <source>What it tries instead is worth nearly as much.</source>
        <translation>Wat het in plaats daarvan probeert, is bijna evenveel waard.</translation>
    </message>
    <message>
        <source>What must be true of a simulation for its risk to hold in reality?</source>
        <translation>Wat moet er van een simulatie waar zijn, zodat haar risico in de werkelijkheid geldt?</translation>
    </message>
    <message>
        <source>What the first robot expects</source>
        <translation>Wat de eerste robot verwacht</translation>
    </message>
    <message>
        <source>What the second robot expects</source>
        <translation>Wat de tweede robot verwacht</translation>
    </message>
    <message>
        <source>What the step changed</source>
        <translation>Wat de stap veranderde</translation>
    </message>
    <message>
        <source>What threshold does the rule give if a successful episode takes n* = 70 steps?</source>
        <translation>Welke drempel geeft de regel als een geslaagde episode n* = 70 stappen duurt?</translation>
    </message>
    <message>
        <source>What will it have learned that is still true in reality?</source>
        <translation>Wat heeft hij dan geleerd dat in de werkelijkheid nog klopt?</translation>
    </message>
    <message>
        <source>What will state 2 be worth? And what will a step to the left be worth?</source>
        <translation>Wat zal toestand 2 waard zijn? En wat een stap naar links?</translation>
    </message>
    <message>
        <source>What will the robot from the weak simulation expect in this state?</source>
        <translation>Wat zal de robot uit de zwakke simulatie in deze toestand verwachten?</translation>
    </message>
    <message>
        <source>What would have to be true of a task so that Softmax explores where it is dangerous?</source>
        <translation>Wat zou er van een taak waar moeten zijn, zodat Softmax juist exploreert waar het gevaarlijk is?</translation>
    </message>
    <message>
        <source>What would you measure before you put what it has learned on a real robot?</source>
        <translation>Wat zou je meten voordat je het geleerde op een echte robot zet?</translation>
    </message>
    <message>
        <source>What would you take for γ if the robot is paid once at the end of a chess game?</source>
        <translation>Wat zou je voor γ nemen als de robot aan het eind van een schaakpartij één keer wordt beloond?</translation>
    </message>
    <message>
        <source>What ε does to falls, and what the reward of a fall does.</source>
        <translation>Wat ε met valpartijen doet, en wat de beloning van een val doet.</translation>
    </message>
    <message>
        <source>When a pole falls: which steps were to blame, the last ten or those before?</source>
        <translation>Als een stok valt: welke stappen waren schuldig, de laatste tien of die ervoor?</translation>
    </message>
    <message>
        <source>When both take an action other than the best equally often, ε-greedy falls {mean(&quot;ε 0.1&quot;)} times, Softmax {mean(&quot;τ 1.5&quot;)} times on average. Greedy, which always takes the best, falls {mean(&quot;greedy&quot;)} times.</source>
        <translation>Als beide even vaak een andere actie dan de beste nemen, valt ε-greedy gemiddeld {mean(&quot;ε 0.1&quot;)} keer en Softmax {mean(&quot;τ 1.5&quot;)} keer. Greedy, die altijd de beste neemt, valt {mean(&quot;greedy&quot;)} keer.</translation>
    </message>
    <message>
        <source>When is a line worth its trouble?</source>
        <translation>Wanneer is een lijn de moeite waard?</translation>
    </message>
    <message>
        <source>When is exploring cheap, and what should Softmax be compared with?</source>
        <translation>Wanneer is exploreren goedkoop, en waarmee moet je Softmax vergelijken?</translation>
    </message>
    <message>
        <source>When it first reaches the goal, which of the steps on its way have a mark?</source>
        <translation>Als hij het doel voor het eerst bereikt, welke stappen onderweg hebben dan een merkteken?</translation>
    </message>
    <message>
        <source>When would a simulation be too pessimistic to be of use?</source>
        <translation>Wanneer zou een simulatie te somber zijn om bruikbaar te zijn?</translation>
    </message>
    <message>
        <source>When would a surprise be negative? Find one on the chain.</source>
        <translation>Wanneer zou een verrassing negatief zijn? Zoek er een in de keten.</translation>
    </message>
    <message>
        <source>When would you use TRL, and when a smaller ε?</source>
        <translation>Wanneer zou je TRL gebruiken, en wanneer een kleinere ε?</translation>
    </message>
    <message>
        <source>Where all values lie below the line, TRL is ε-greedy; that is where the pole leans far.</source>
        <translation>Waar alle waarden onder de lijn liggen is TRL gelijk aan ε-greedy; dat is waar de stok ver helt.</translation>
    </message>
    <message>
        <source>Where does it end?</source>
        <translation>Waar houdt het op?</translation>
    </message>
    <message>
        <source>Where good and bad states lie in the tile of a fall, Q⁻ says the same of all of them.</source>
        <translation>Waar goede en slechte toestanden in de tegel van een val liggen, zegt Q⁻ van allemaal hetzelfde.</translation>
    </message>
    <message>
        <source>Where must falls not happen, so that this way of learning is ruled out?</source>
        <translation>Waar mag er niet gevallen worden, zodat deze manier van leren daar is uitgesloten?</translation>
    </message>
    <message>
        <source>Where the pole leans far, no action is worth 100, and it draws among all.</source>
        <translation>Waar de stok ver helt is geen actie 100 waard, en loot het tussen alle.</translation>
    </message>
    <message>
        <source>Where to put the line before one has tried? A **rule of thumb**: take the worth of a state from which the goal is n* steps away, the length of a successful episode: R times γ to the power of n*. The panel takes the n* of this life. R is 200, γ is 0.98.</source>
        <translation>Waar leg je de lijn voordat je iets geprobeerd hebt? Een **vuistregel**: neem de waarde van een toestand waarvandaan het doel n* stappen ver is, de lengte van een geslaagde episode: R maal γ tot de macht n*. Het paneel neemt de n* van dit leven. R is 200, γ is 0,98.</translation>
    </message>
    <message>
        <source>Which needs fewer steps, or can one not tell?</source>
        <translation>Welke heeft minder stappen nodig, of is dat niet te zeggen?</translation>
    </message>
    <message>
        <source>Which of the two falls less in reality?</source>
        <translation>Welke van de twee valt in de werkelijkheid minder?</translation>
    </message>
    <message>
        <source>Which of the two falls less?</source>
        <translation>Welke van de twee valt minder?</translation>
    </message>
    <message>
        <source>Which of the two will avoid leaning that far?</source>
        <translation>Welke van de twee zal vermijden zo ver te hellen?</translation>
    </message>
    <message>
        <source>Which of them falls least in reality?</source>
        <translation>Welke valt in de werkelijkheid het minst?</translation>
    </message>
    <message>
        <source>Which of them falls less?</source>
        <translation>Welke van beide valt minder?</translation>
    </message>
    <message>
        <source>Which of your own comparisons, in lessons 5 to 11, were fair?</source>
        <translation>Welke van je eigen vergelijkingen, in de lessen 5 tot en met 11, waren eerlijk?</translation>
    </message>
    <message>
        <source>Which rewards belong in Q⁻ if every step costs a little energy?</source>
        <translation>Welke beloningen horen in Q⁻ als elke stap een beetje energie kost?</translation>
    </message>
    <message>
        <source>Which rule would you give a robot near an edge, and when the other one?</source>
        <translation>Welke regel zou je een robot bij een rand geven, en wanneer de andere?</translation>
    </message>
    <message>
        <source>Which two or three numbers does the robot have to know about the pole, to choose a torque?</source>
        <translation>Welke twee of drie getallen moet de robot over de stok weten om een koppel te kiezen?</translation>
    </message>
    <message>
        <source>Which value does Q(9, right) approach?</source>
        <translation>Welke waarde benadert Q(9, rechts)?</translation>
    </message>
    <message>
        <source>Which way will Sarsa take?</source>
        <translation>Welke weg kiest Sarsa?</translation>
    </message>
    <message>
        <source>While it expects nothing, a fall with reward 0 is no surprise. With −1600 each fall warns of what led to it.</source>
        <translation>Zolang hij niets verwacht, is een val met beloning 0 geen verrassing. Met −1600 waarschuwt elke val voor wat ernaartoe leidde.</translation>
    </message>
    <message>
        <source>Who should be allowed to explore: the simulation, the robot, or both?</source>
        <translation>Wie mag er exploreren: de simulatie, de robot, of allebei?</translation>
    </message>
    <message>
        <source>Who should set the weight: who builds the robot, or who pays for it?</source>
        <translation>Wie hoort het gewicht in te stellen: wie de robot bouwt, of wie hem betaalt?</translation>
    </message>
    <message>
        <source>Whom to blame</source>
        <translation>Wie krijgt de schuld?</translation>
    </message>
    <message>
        <source>Whose value stands in the formula as Q(S′, A′) when the robot steps right from state 7?</source>
        <translation>Wiens waarde staat in de formule als Q(S′, A′) als de robot vanuit toestand 7 naar rechts stapt?</translation>
    </message>
    <message>
        <source>Why are the greedy lives all alike?</source>
        <translation>Waarom zijn de greedy levens allemaal gelijk?</translation>
    </message>
    <message>
        <source>Why did it fall so often?</source>
        <translation>Waarom viel hij zo vaak?</translation>
    </message>
    <message>
        <source>Why did the beginner fall so often?</source>
        <translation>Waarom viel de beginner zo vaak?</translation>
    </message>
    <message>
        <source>Why do the 20 values lie closer together with α = 0.02?</source>
        <translation>Waarom liggen de 20 waarden met α = 0,02 dichter bij elkaar?</translation>
    </message>
    <message>
        <source>Why does a fall that costs nothing not make the robot careless for ever?</source>
        <translation>Waarom maakt een val die niets kost de robot niet voor altijd onvoorzichtig?</translation>
    </message>
    <message>
        <source>Why does a line at 100 help less than one at 50?</source>
        <translation>Waarom helpt een lijn op 100 minder dan een op 50?</translation>
    </message>
    <message>
        <source>Why does a value never reach state 5 when γ = 0, however long the robot lives?</source>
        <translation>Waarom bereikt een waarde toestand 5 nooit als γ = 0, hoe lang de robot ook leeft?</translation>
    </message>
    <message>
        <source>Why does it fall more at first with resolution 4 or 8 than with 1?</source>
        <translation>Waarom valt hij in het begin meer met resolutie 4 of 8 dan met 1?</translation>
    </message>
    <message>
        <source>Why does it fall most if a fall costs nothing?</source>
        <translation>Waarom valt hij het meest als een val niets kost?</translation>
    </message>
    <message>
        <source>Why does it fall so much more with 0.1?</source>
        <translation>Waarom valt hij zoveel meer met 0,1?</translation>
    </message>
    <message>
        <source>Why does it fall?</source>
        <translation>Waarom valt hij?</translation>
    </message>
    <message>
        <source>Why does it matter that actions are chosen on the sum of both?</source>
        <translation>Waarom is het belangrijk dat acties naar de som van beide worden gekozen?</translation>
    </message>
    <message>
        <source>Why does it not hurry with γ = 1?</source>
        <translation>Waarom haast hij zich niet met γ = 1?</translation>
    </message>
    <message>
        <source>Why does it wander on states 3 to 8?</source>
        <translation>Waarom dwaalt hij op de toestanden 3 tot en met 8?</translation>
    </message>
    <message>
        <source>Why does learning with weak motors help more?</source>
        <translation>Waarom helpt leren met zwakke motoren meer?</translation>
    </message>
    <message>
        <source>Why does the widest still fall nearly as often as at first?</source>
        <translation>Waarom valt hij met de breedste nog bijna even vaak als in het begin?</translation>
    </message>
    <message>
        <source>Why is it better not to obey the risk while it learns in the simulation?</source>
        <translation>Waarom is het beter het risico niet te gehoorzamen terwijl hij in de simulatie leert?</translation>
    </message>
    <message>
        <source>Why is the longer way worth more to Sarsa?</source>
        <translation>Waarom is de langere weg voor Sarsa meer waard?</translation>
    </message>
    <message>
        <source>Why is “right” from state 2 blamed?</source>
        <translation>Waarom krijgt “rechts” vanuit toestand 2 schuld?</translation>
    </message>
    <message>
        <source>Why may losses be coarser than gains?</source>
        <translation>Waarom mag verlies grover zijn dan winst?</translation>
    </message>
    <message>
        <source>Why not always?</source>
        <translation>Waarom niet altijd?</translation>
    </message>
    <message>
        <source>Wide tiles spread what is learned to many states, so it is learned soon, but they cannot tell apart what needs different actions. Narrow ones can, but they need more falls first. Displaced wide grids do both: they spread, and together they tell apart.</source>
        <translation>Brede tegels verspreiden wat geleerd is over veel toestanden, zodat het snel geleerd is, maar ze onderscheiden niet wat verschillende acties vraagt. Smalle wel, maar die hebben eerst meer valpartijen nodig. Verschoven brede roosters doen beide: ze verspreiden, en samen onderscheiden ze.</translation>
    </message>
    <message>
        <source>Wider tiles for the losses</source>
        <translation>Bredere tegels voor het verlies</translation>
    </message>
    <message>
        <source>Will it find its real motors too strong or too weak?</source>
        <translation>Zal hij zijn echte motoren te sterk of te zwak vinden?</translation>
    </message>
    <message>
        <source>With 0.3 times the torque, can it learn to balance in the simulation at all?</source>
        <translation>Kan hij met 0,3 keer het koppel in de simulatie eigenlijk wel leren balanceren?</translation>
    </message>
    <message>
        <source>With a fine Q⁻ it fell **{observed(3)} times** while it learned. Now the resolution of Q⁻ is **0.4**: the same seed, the same six minutes.</source>
        <translation>Met een fijne Q⁻ viel hij **{observed(3)} keer** terwijl hij leerde. Nu is de resolutie van Q⁻ **0,4**: dezelfde seed, dezelfde zes minuten.</translation>
    </message>
    <message>
        <source>With a large α the value is right after few steps, if each step tells the same. Where chance plays a part, a small α averages over many steps and is not led astray by a single one, but learns more slowly.</source>
        <translation>Met een grote α klopt de waarde al na weinig stappen, als elke stap hetzelfde zegt. Waar toeval meespeelt, middelt een kleine α over veel stappen en laat zich niet door één stap op een dwaalspoor brengen, maar leert trager.</translation>
    </message>
    <message>
        <source>With the line at 80 two actions lie above it. In how many of 100 steps does it take the worse of these two?</source>
        <translation>Met de lijn op 80 liggen er twee acties boven. In hoeveel van 100 stappen neemt het de slechtste van die twee?</translation>
    </message>
    <message>
        <source>With which thresholds is TRL nothing but ε-greedy?</source>
        <translation>Met welke drempels is TRL niets anders dan ε-greedy?</translation>
    </message>
    <message>
        <source>With which τ does Softmax take an action other than the best in about 8 of 100 steps?</source>
        <translation>Met welke τ neemt Softmax in ongeveer 8 van 100 stappen een andere actie dan de beste?</translation>
    </message>
    <message>
        <source>With α = 0.02 fewer steps are taken at random.</source>
        <translation>Met α = 0,02 worden minder stappen willekeurig gedaan.</translation>
    </message>
    <message>
        <source>With α = 0.02 one step counts little, and chance evens out over many.</source>
        <translation>Met α = 0,02 telt één stap weinig, en over vele stappen middelt het toeval uit.</translation>
    </message>
    <message>
        <source>With α = 0.02 the values stay near 0.</source>
        <translation>Met α = 0,02 blijven de waarden bij 0.</translation>
    </message>
    <message>
        <source>With γ = 0 the goal reached one state. With γ = 1 it reached all of them equally, and nothing said which way is shorter. With γ = 0.9 each step towards the goal is worth more than the one before.</source>
        <translation>Met γ = 0 bereikte het doel één toestand. Met γ = 1 bereikte het ze allemaal even sterk, en niets zei welke weg korter is. Met γ = 0,9 is elke stap naar het doel meer waard dan de vorige.</translation>
    </message>
    <message>
        <source>With γ = 0.9 the robot took {observed(4)} steps per episode. With γ = 0 it takes {steps / episodes}. Let it run. Once it is on state 9 it knows what to do. Before that it wanders.</source>
        <translation>Met γ = 0,9 deed de robot {observed(4)} stappen per episode. Met γ = 0 doet hij er {steps / episodes}. Laat hem lopen. Staat hij eenmaal op toestand 9, dan weet hij wat hij moet doen. Daarvoor dwaalt hij.</translation>
    </message>
    <message>
        <source>With ε = 0.05 it fell **{observed(1)} times** in 200 episodes. Now it will take one action in four at random, **ε = 0.25**. The same robot, the same beginning, and the same **seed**: the number that all chance comes from.</source>
        <translation>Met ε = 0,05 viel hij **{observed(1)} keer** in 200 episodes. Nu kiest hij één op de vier acties willekeurig, **ε = 0,25**. Dezelfde robot, hetzelfde begin, en dezelfde **seed**: het getal waar al het toeval uit volgt.</translation>
    </message>
    <message>
        <source>With ε = 0.05 it fell {observed(1)} times in 200 episodes. Now the knob is yours. Choose an ε, start again with the same seed, and let it live 200 episodes. Can you do it with ε at 0.01 or more, so that it still explores?</source>
        <translation>Met ε = 0,05 viel hij {observed(1)} keer in 200 episodes. Nu is de knop van jou. Kies een ε, begin opnieuw met dezelfde seed, en laat hem 200 episodes leven. Lukt het met een ε van 0,01 of meer, zodat hij nog exploreert?</translation>
    </message>
    <message>
        <source>With ε = 0.1 the robot fell **{observed(3)} times** in 200 episodes. Now Softmax, with **τ = 1.5**: it leaves the best action about as often. The same robot, the same beginning.</source>
        <translation>Met ε = 0,1 viel de robot **{observed(3)} keer** in 200 episodes. Nu Softmax, met **τ = 1,5**: die wijkt ongeveer even vaak van de beste actie af. Dezelfde robot, hetzelfde begin.</translation>
    </message>
    <message>
        <source>With ε = 0.25 it has learned for 200 episodes. Why does it still fall?</source>
        <translation>Met ε = 0,25 heeft hij 200 episodes geleerd. Waarom valt hij nog?</translation>
    </message>
    <message>
        <source>With λ = 0 a value learns from the next value only.</source>
        <translation>Met λ = 0 leert een waarde alleen van de volgende waarde.</translation>
    </message>
    <message>
        <source>With λ = 0 it had to reach the goal **{observed(5)} times** before state 5 knew of it: the news moves back one state at a time. Now **λ = 0.9**, the same seed, from the beginning, until the same two things hold.</source>
        <translation>Met λ = 0 moest hij het doel **{observed(5)} keer** bereiken voordat toestand 5 ervan wist: het nieuws schuift één toestand tegelijk terug. Nu **λ = 0,9**, dezelfde seed, vanaf het begin, tot dezelfde twee dingen gelden.</translation>
    </message>
    <message>
        <source>With λ = 0.9 state 5 knew after {observed(6)} goals, with λ = 0 after {observed(5)}. But that was one life. Here are ten of each, of the same seeds: the steps of ten episodes. A line joins the lives of one seed. The bar is the 95 % interval of a mean: there the true mean probably lies.</source>
        <translation>Met λ = 0,9 wist toestand 5 het na {observed(6)} doelen, met λ = 0 na {observed(5)}. Maar dat was één leven. Hier zijn er tien van elk, met dezelfde seeds: de stappen van tien episodes. Een lijn verbindt de levens van één seed. De balk is het 95%-interval van een gemiddelde: daarin ligt waarschijnlijk het echte gemiddelde.</translation>
    </message>
    <message>
        <source>With τ = 1000, about how likely is each of the five actions?</source>
        <translation>Hoe groot is met τ = 1000 ongeveer de kans op elk van de vijf acties?</translation>
    </message>
    <message>
        <source>Within a pair, which ε falls less, and in how many of the ten?</source>
        <translation>Welke ε valt binnen een paar minder, en in hoeveel van de tien?</translation>
    </message>
    <message>
        <source>Without a punishment it explores more.</source>
        <translation>Zonder straf exploreert hij meer.</translation>
    </message>
    <message>
        <source>Without exploring</source>
        <translation>Zonder exploreren</translation>
    </message>
    <message>
        <source>Work out a worth</source>
        <translation>Reken een waarde uit</translation>
    </message>
    <message>
        <source>Work out the new value before the robot does.</source>
        <translation>Reken de nieuwe waarde uit voordat de robot het doet.</translation>
    </message>
    <message>
        <source>Would you let ε shrink while it learns? By what rule?</source>
        <translation>Zou je ε laten krimpen terwijl hij leert? Volgens welke regel?</translation>
    </message>
    <message>
        <source>Would you rather learn in many simulations, each wrong in another way?</source>
        <translation>Zou je liever in veel simulaties leren, elk op een andere manier verkeerd?</translation>
    </message>
    <message>
        <source>Would you rather start with wide tiles and cut them later? What would that need?</source>
        <translation>Zou je liever met brede tegels beginnen en ze later opdelen? Wat zou daarvoor nodig zijn?</translation>
    </message>
    <message>
        <source>You are the referee</source>
        <translation>Jij bent de beoordelaar</translation>
    </message>
    <message>
        <source>You build a simulation and do not know the torque exactly. What do you choose, and why?</source>
        <translation>Je bouwt een simulatie en kent het koppel niet precies. Wat kies je, en waarom?</translation>
    </message>
    <message>
        <source>You do not always choose how a simulation is wrong. After the **strong** motors, × 2.5, a robot can bring along more than its values: how likely each action ended in a fall there. Ten lives that obey this risk in reality, and ten that do not. (The next lesson is about this.)</source>
        <translation>Hoe een simulatie verkeerd is, kies je niet altijd zelf. Na de **sterke** motoren, × 2,5, kan een robot meer meenemen dan zijn waarden: hoe waarschijnlijk elke actie daar in een val eindigde. Tien levens die dit risico in de werkelijkheid gehoorzamen, en tien die dat niet doen. (Daarover gaat de volgende les.)</translation>
    </message>
    <message>
        <source>You have done by hand what the robot does after every step, on the pendulum 200 times a second: see what came, compare it with what was expected, and move the value by a share of the difference.</source>
        <translation>Je hebt met de hand gedaan wat de robot na elke stap doet, bij de slinger 200 keer per seconde: kijken wat er komt, het vergelijken met wat verwacht werd, en de waarde een deel van het verschil opschuiven.</translation>
    </message>
    <message>
        <source>You have met two settings. Because of ε the robot sometimes does what it does not think best, also when there is little left to learn. The reward of a fall changes how often it falls while it learns. In the next lesson, [The cliff](lesson:the-cliff), two robots treat their own ε differently.</source>
        <translation>Je hebt twee instellingen leren kennen. Door ε doet de robot soms wat hij niet het beste vindt, ook als er weinig meer te leren is. De beloning van een val verandert hoe vaak hij valt terwijl hij leert. In de volgende les, [De cliff](lesson:the-cliff), gaan twee robots verschillend met hun eigen ε om.</translation>
    </message>
    <message>
        <source>You have one robot that breaks easily. How do you let it learn?</source>
        <translation>Je hebt één robot die makkelijk stukgaat. Hoe laat je hem leren?</translation>
    </message>
    <message>
        <source>You have seen which direction helps. One life is a matter of chance: try a few values.</source>
        <translation>Je hebt gezien welke kant helpt. Eén leven is toeval: probeer een paar waarden.</translation>
    </message>
    <message>
        <source>You look for a γ with γ⁷ · 100 between 1 and 5. With γ = 0.7 it is about 8.</source>
        <translation>Je zoekt een γ waarvoor γ⁷ · 100 tussen 1 en 5 ligt. Met γ = 0,7 is het ongeveer 8.</translation>
    </message>
    <message>
        <source>You try 40 settings that change nothing. About how many look better or worse all the same?</source>
        <translation>Je probeert 40 instellingen die niets veranderen. Hoeveel lijken er ongeveer toch beter of slechter?</translation>
    </message>
    <message>
        <source>Your rule</source>
        <translation>Jouw regel</translation>
    </message>
    <message>
        <source>Your rule for a robot near an edge</source>
        <translation>Jouw regel voor een robot bij een rand</translation>
    </message>
    <message>
        <source>Your rule for ε and for the reward of a fall, for a robot that can break:</source>
        <translation>Jouw regel voor ε en voor de beloning van een val, voor een robot die stuk kan gaan:</translation>
    </message>
    <message>
        <source>actions</source>
        <translation>acties</translation>
    </message>
    <message>
        <source>bold</source>
        <translation>dapper</translation>
    </message>
    <message>
        <source>both coarse</source>
        <translation>beide grof</translation>
    </message>
    <message>
        <source>careful</source>
        <translation>voorzichtig</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>valpartijen</translation>
    </message>
    <message>
        <source>goals, both coarse</source>
        <translation>doelen, beide grof</translation>
    </message>
    <message>
        <source>goals, only Q⁻ coarse</source>
        <translation>doelen, alleen Q⁻ grof</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>greedy</translation>
    </message>
    <message>
        <source>greedy, five</source>
        <translation>greedy, vijf</translation>
    </message>
    <message>
        <source>how Softmax chooses, why it falls less than ε-greedy that explores as often, and what else to compare it with.</source>
        <translation>hoe Softmax kiest, waarom het minder valt dan ε-greedy die even vaak exploreert, en waarmee je het nog moet vergelijken.</translation>
    </message>
    <message>
        <source>how a risk that is learned in simulation avoids falls in reality, and why a larger penalty does less.</source>
        <translation>hoe een risico dat in de simulatie geleerd is in de werkelijkheid vallen voorkomt, en waarom een zwaardere straf minder doet.</translation>
    </message>
    <message>
        <source>how a robot on two legs learns to walk, what that costs in falls, and which way it fell less on another robot.</source>
        <translation>hoe een robot op twee benen leert lopen, wat dat aan valpartijen kost, en op welke manier hij op een andere robot minder viel.</translation>
    </message>
    <message>
        <source>how few lives deceive, what an interval promises, what pairs are good for, and whom a new method has to beat.</source>
        <translation>hoe weinig levens bedriegen, wat een interval belooft, waar paren goed voor zijn, en wie een nieuwe methode moet verslaan.</translation>
    </message>
    <message>
        <source>lives</source>
        <translation>levens</translation>
    </message>
    <message>
        <source>no line</source>
        <translation>geen lijn</translation>
    </message>
    <message>
        <source>not obeyed</source>
        <translation>niet gehoorzaamd</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>niets</translation>
    </message>
    <message>
        <source>one grid of 2</source>
        <translation>één rooster van 2</translation>
    </message>
    <message>
        <source>only Q⁻ coarse</source>
        <translation>alleen Q⁻ grof</translation>
    </message>
    <message>
        <source>punished</source>
        <translation>gestraft</translation>
    </message>
    <message>
        <source>resolution 0.25</source>
        <translation>resolutie 0,25</translation>
    </message>
    <message>
        <source>resolution 0.25, later</source>
        <translation>resolutie 0,25, later</translation>
    </message>
    <message>
        <source>resolution 1</source>
        <translation>resolutie 1</translation>
    </message>
    <message>
        <source>resolution 1, later</source>
        <translation>resolutie 1, later</translation>
    </message>
    <message>
        <source>resolution 4</source>
        <translation>resolutie 4</translation>
    </message>
    <message>
        <source>resolution 4, later</source>
        <translation>resolutie 4, later</translation>
    </message>
    <message>
        <source>resolution 8</source>
        <translation>resolutie 8</translation>
    </message>
    <message>
        <source>resolution 8, later</source>
        <translation>resolutie 8, later</translation>
    </message>
    <message>
        <source>reward 0</source>
        <translation>beloning 0</translation>
    </message>
    <message>
        <source>reward −100</source>
        <translation>beloning −100</translation>
    </message>
    <message>
        <source>reward −1600</source>
        <translation>beloning −1600</translation>
    </message>
    <message>
        <source>right, × 1</source>
        <translation>juist, × 1</translation>
    </message>
    <message>
        <source>risk obeyed</source>
        <translation>risico gehoorzaamd</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>instellingen</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>stappen</translation>
    </message>
    <message>
        <source>strong, × 2.5</source>
        <translation>sterk, × 2,5</translation>
    </message>
    <message>
        <source>the same robot twice, the same seed; only the way to explore differs</source>
        <translation>dezelfde robot twee keer, dezelfde seed; alleen de manier van exploreren verschilt</translation>
    </message>
    <message>
        <source>times</source>
        <translation>keer</translation>
    </message>
    <message>
        <source>weak, × 0.5</source>
        <translation>zwak, × 0,5</translation>
    </message>
    <message>
        <source>what a threshold does to exploring, what makes it too low or too high, and what TRL has to be compared with.</source>
        <translation>wat een drempel met exploreren doet, wat hem te laag of te hoog maakt, en waarmee je TRL moet vergelijken.</translation>
    </message>
    <message>
        <source>what a trace does: how far back a fall or a goal is felt, and why that is quick but not always just.</source>
        <translation>wat een trace doet: tot hoe ver terug een val of een doel wordt gevoeld, en waarom dat snel gaat maar niet altijd eerlijk is.</translation>
    </message>
    <message>
        <source>what learning in a wrong simulation saves, and which error of its motors costs less in reality.</source>
        <translation>wat leren in een verkeerde simulatie bespaart, en welke fout in haar motoren in de werkelijkheid minder kost.</translation>
    </message>
    <message>
        <source>what the robot does with one step: how large its surprise δ is, and that the value moves by the share α of it.</source>
        <translation>wat de robot met één stap doet: hoe groot zijn verrassing δ is, en dat de waarde met het deel α daarvan opschuift.</translation>
    </message>
    <message>
        <source>what too wide and too narrow tiles do to learning, and why one lays several displaced grids over each other.</source>
        <translation>wat te brede en te smalle tegels met leren doen, en waarom men meerdere verschoven roosters over elkaar legt.</translation>
    </message>
    <message>
        <source>what γ does: how far ahead a reward counts, and what goes wrong when it counts too little or too long.</source>
        <translation>wat γ doet: hoe ver vooruit een beloning telt, en wat er misgaat als ze te weinig of te lang telt.</translation>
    </message>
    <message>
        <source>what ε does to falls, why they go on when the robot has learned, and what a harder punishment changes.</source>
        <translation>wat ε met valpartijen doet, waarom ze doorgaan als de robot het geleerd heeft, en wat een strengere straf verandert.</translation>
    </message>
    <message>
        <source>which of two rules counts its own mistakes, and which one to trust near an edge while it learns.</source>
        <translation>welke van twee regels zijn eigen fouten meetelt, en welke je vertrouwt bij een rand zolang hij leert.</translation>
    </message>
    <message>
        <source>why a coarse Q-function for the losses saves falls, why one that is too coarse costs them, and why the gains stay fine.</source>
        <translation>waarom een grove Q-functie voor het verlies valpartijen bespaart, waarom een te grove ze kost, en waarom de winst fijn blijft.</translation>
    </message>
    <message>
        <source>why a robot that learns by itself falls often at first, and what it has to find out in order to fall less.</source>
        <translation>waarom een robot die zelf leert in het begin vaak valt, en wat hij moet ontdekken om minder te vallen.</translation>
    </message>
    <message>
        <source>{mean(&quot;A&quot;)} and {mean(&quot;B&quot;)} falls in five lives. But A and B are the **same robot**; only chance differed (we looked for such luck in 28 seeds). Thirty lives: {mean(&quot;A, thirty&quot;)} and {mean(&quot;B, thirty&quot;)}. With more lives the interval of the mean shrinks: four times the lives, about half as wide.</source>
        <translation>{mean(&quot;A&quot;)} en {mean(&quot;B&quot;)} valpartijen in vijf levens. Maar A en B zijn **dezelfde robot**; alleen het toeval verschilde (we zochten zulk geluk in 28 seeds). Dertig levens: {mean(&quot;A, thirty&quot;)} en {mean(&quot;B, thirty&quot;)}. Met meer levens krimpt het interval van het gemiddelde: vier keer zoveel levens, ongeveer half zo breed.</translation>
    </message>
    <message>
        <source>{observed(2)} falls in reality instead of {observed(1)}, and {before.falls} in the simulation. Now the simulation is wrong the other way: its motors have **half** the torque of the real ones. Again ten minutes there, then 200 real episodes.</source>
        <translation>{observed(2)} valpartijen in de werkelijkheid in plaats van {observed(1)}, en {before.falls} in de simulatie. Nu is de simulatie de andere kant op verkeerd: haar motoren hebben **half** zoveel koppel als de echte. Weer tien minuten daar, dan 200 echte episodes.</translation>
    </message>
    <message>
        <source>{observed(2)} falls instead of {observed(1)}. Ten lives with ε = 0.25 now go on for 100 more episodes: they fall {least(&quot;ε stays 0.25&quot;)} to {most(&quot;ε stays 0.25&quot;)} times. Ten others have learned the same, and then stop exploring: they fall {least(&quot;ε becomes 0&quot;)} to {most(&quot;ε becomes 0&quot;)} times.</source>
        <translation>{observed(2)} valpartijen in plaats van {observed(1)}. Tien levens met ε = 0,25 gaan nu nog 100 episodes door: ze vallen {least(&quot;ε stays 0.25&quot;)} tot {most(&quot;ε stays 0.25&quot;)} keer. Tien andere hebben hetzelfde geleerd en stoppen dan met exploreren: ze vallen {least(&quot;ε becomes 0&quot;)} tot {most(&quot;ε becomes 0&quot;)} keer.</translation>
    </message>
    <message>
        <source>{observed(2)} falls with the large penalty. Now something else: beside Q the robot learns **ρ**, how likely an action ends in a fall. It learned it in the simulation, and did not use it. The pole leans, and falls on: look at the column *Risk*.</source>
        <translation>{observed(2)} valpartijen met de zware straf. Nu iets anders: naast Q leert de robot **ρ**, hoe waarschijnlijk een actie in een val eindigt. Hij leerde het in de simulatie, en gebruikte het niet. De stok helt en valt verder: kijk naar de kolom *Risico*.</translation>
    </message>
    <message>
        <source>{observed(3)} falls after the weak motors, {observed(2)} after the strong ones. Why? Here is the first robot again, straight from the **strong** simulation. The pole leans by 29°, at rest. The robot expects {max(q(&quot;1.5&quot;), q(&quot;0.75&quot;), q(&quot;0&quot;), q(&quot;-0.75&quot;), q(&quot;-1.5&quot;))} of its best action; a fall is −100.</source>
        <translation>{observed(3)} valpartijen na de zwakke motoren, {observed(2)} na de sterke. Waarom? Hier is de eerste robot weer, regelrecht uit de **sterke** simulatie. De stok helt 29°, in rust. De robot verwacht {max(q(&quot;1.5&quot;), q(&quot;0.75&quot;), q(&quot;0&quot;), q(&quot;-0.75&quot;), q(&quot;-1.5&quot;))} van zijn beste actie; een val is −100.</translation>
    </message>
    <message>
        <source>{observed(4)} falls in ten minutes instead of {observed(2)}. Was that learned for this one robot only? What it knows goes to another one: motors of 9.5 Ω in place of 8.6, and a third more dry friction. It goes on learning, with ε = 0.05, for ten minutes.</source>
        <translation>{observed(4)} valpartijen in tien minuten in plaats van {observed(2)}. Is dat alleen voor deze ene robot geleerd? Wat hij weet gaat naar een andere: motoren van 9,5 Ω in plaats van 8,6, en een derde meer droge wrijving. Hij leert door, met ε = 0,05, tien minuten lang.</translation>
    </message>
    <message>
        <source>{observed(4)} falls instead of {observed(3)}. Ten lives for each threshold, ε = 0.2, fall on average {mean(&quot;no line&quot;)} times with −1000, which forbids nothing, {mean(&quot;TRL 50&quot;)} with 50 and {mean(&quot;TRL 100&quot;)} with 100. The pole leans by 20° now, and the line lies at 100.</source>
        <translation>{observed(4)} valpartijen in plaats van {observed(3)}. Tien levens per drempel, ε = 0,2, vallen gemiddeld {mean(&quot;no line&quot;)} keer met −1000, die niets verbiedt, {mean(&quot;TRL 50&quot;)} met 50 en {mean(&quot;TRL 100&quot;)} met 100. De stok helt nu 20°, en de lijn ligt op 100.</translation>
    </message>
    <message>
        <source>{observed(4)} falls. One life proves little, and who hardly explores hardly falls. So here are ten lives of each: as bold as in the simulation, greedy, punished with −6400, and careful by the risk.</source>
        <translation>{observed(4)} valpartijen. Eén leven bewijst weinig, en wie nauwelijks exploreert valt nauwelijks. Daarom van elk tien levens: even dapper als in de simulatie, greedy, gestraft met −6400, en voorzichtig door het risico.</translation>
    </message>
    <message>
        <source>{observed(6)} falls instead of {observed(5)}. Three lives of each, three minutes long: ε-greedy falls {least(&quot;ε-greedy 0.05&quot;)} to {most(&quot;ε-greedy 0.05&quot;)} times. The three greedy lives, with three seeds, all fall {mean(&quot;greedy&quot;)} times.</source>
        <translation>{observed(6)} valpartijen in plaats van {observed(5)}. Van elk drie levens van drie minuten: ε-greedy valt {least(&quot;ε-greedy 0.05&quot;)} tot {most(&quot;ε-greedy 0.05&quot;)} keer. De drie greedy levens, met drie seeds, vallen allemaal {mean(&quot;greedy&quot;)} keer.</translation>
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
        <translation>Met α = 1 was één stap genoeg. Wat zou α = 2 doen?</translation>
    </message>
    <message>
        <source>α is the share of the surprise that is added. Which share is needed to get from 0 to 100 at once?</source>
        <translation>α is het deel van de verrassing dat erbij komt. Welk deel is nodig om in één keer van 0 naar 100 te gaan?</translation>
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
        <translation>γ bepaalt hoeveel een beloning telt die later komt. Te klein, en toestanden ver van het doel weten er nauwelijks van. Bij 1 is een late beloning net zoveel waard als een vroege, zodat de robot zich niet haast, tenzij stappen iets kosten. Hier: iets ertussenin, zoals 0,9.</translation>
    </message>
    <message>
        <source>γ is 0.9 again; the map shows it. Now imagine **γ = 0**: what comes after the next step counts nothing. Only the reward of the very next step counts.</source>
        <translation>γ is weer 0,9; de kaart laat het zien. Stel je nu **γ = 0** voor: wat na de volgende stap komt, telt niet. Alleen de beloning van de eerstvolgende stap telt.</translation>
    </message>
    <message>
        <source>δ = 0 + 0.8 · 75 − 0. Then take half of it.</source>
        <translation>δ = 0 + 0,8 · 75 − 0. Neem daar de helft van.</translation>
    </message>
    <message>
        <source>ε 0.05</source>
        <translation>ε 0,05</translation>
    </message>
    <message>
        <source>ε 0.05, in pairs</source>
        <translation>ε 0,05, in paren</translation>
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
        <translation>ε 0,1, dezelfde</translation>
    </message>
    <message>
        <source>ε = 0.1</source>
        <translation>ε = 0,1</translation>
    </message>
    <message>
        <source>ε becomes 0</source>
        <translation>ε wordt 0</translation>
    </message>
    <message>
        <source>ε is 0.05 for all.</source>
        <translation>ε is voor allemaal 0,05.</translation>
    </message>
    <message>
        <source>ε is 0.05 in all 30 lives.</source>
        <translation>ε is 0,05 in alle 30 levens.</translation>
    </message>
    <message>
        <source>ε is 0.2 in all of them.</source>
        <translation>ε is in alle 0,2.</translation>
    </message>
    <message>
        <source>ε stays 0.25</source>
        <translation>ε blijft 0,25</translation>
    </message>
    <message>
        <source>ε-greedy 0.05</source>
        <translation>ε-greedy 0,05</translation>
    </message>
    <message>
        <source>ε-greedy also drew the worst of the five. When may TRL do so?</source>
        <translation>ε-greedy lootte ook de slechtste van de vijf. Wanneer mag TRL dat?</translation>
    </message>
    <message>
        <source>ε-greedy once more</source>
        <translation>Nog eens ε-greedy</translation>
    </message>
    <message>
        <source>ε-greedy took an action other than the best in 8 of 100 steps. For a fair comparison Softmax must do so as often. The chart shows how often ε-greedy does so, and Softmax with four temperatures, ten lives each. The τ that you look for lies between two of them.</source>
        <translation>ε-greedy nam in 8 van 100 stappen een andere actie dan de beste. Voor een eerlijke vergelijking moet Softmax dat even vaak doen. De grafiek toont hoe vaak ε-greedy het doet, en Softmax met vier temperaturen, elk tien levens. De τ die je zoekt ligt tussen twee daarvan.</translation>
    </message>
    <message>
        <source>ε-greedy with ε = 0.2</source>
        <translation>ε-greedy met ε = 0,2</translation>
    </message>
    <message>
        <source>ε-greedy, again thirty</source>
        <translation>ε-greedy, weer dertig</translation>
    </message>
    <message>
        <source>ε-greedy, ε 0.05</source>
        <translation>ε-greedy, ε 0,05</translation>
    </message>
    <message>
        <source>ε-greedy: one action in ten</source>
        <translation>ε-greedy: één actie op de tien</translation>
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
        <translation>λ bepaalt hoeveel van de schuld naar de stap ervoor gaat. Vanuit toestand 3 verloor *links* 40,5 met λ = 0,9. Draai aan λ, begin opnieuw met dezelfde seed, en laat lopen tot de eerste val. Pauzeer dan, en klik op de kaart op toestand 3.</translation>
    </message>
    <message>
        <source>λ says how far back along the way a surprise is felt. With a large λ one fall or goal teaches many steps at once, so that news travels quickly; but steps are judged by when they were taken, and some are blamed or praised wrongly until later walks correct it.</source>
        <translation>λ zegt tot hoe ver terug langs de weg een verrassing wordt gevoeld. Met een grote λ leert één val of doel veel stappen tegelijk, zodat nieuws snel reist; maar stappen worden beoordeeld naar wanneer ze zijn gedaan, en sommige krijgen ten onrechte schuld of lof, tot latere wandelingen dat rechtzetten.</translation>
    </message>
    <message>
        <source>ρ is 1 for an action that falls, and is passed on to the actions before it, as values are.</source>
        <translation>ρ is 1 voor een actie die valt, en wordt doorgegeven aan de acties ervoor, net als waarden.</translation>
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
        <translation>τ wordt gemeten in eenheden van Q. Wat gebeurt er met Softmax als alle beloningen met tien worden vermenigvuldigd?</translation>
    </message>
    <message>
        <source>… it has to find out by trying which torque is good when, and at first most of its episodes go wrong. With practice it knows more and falls less.</source>
        <translation>… hij door te proberen moet ontdekken welk koppel wanneer goed is, en de meeste van zijn episodes in het begin mislukken. Met oefening weet hij meer en valt hij minder.</translation>
    </message>
</context>
<context>
    <name>surefoot::AboutDialog</name>
    <message>
        <source>About Surefoot</source>
        <translation>Over Surefoot</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pagina’s</translation>
    </message>
    <message>
        <source>The page</source>
        <translation>De pagina</translation>
    </message>
    <message>
        <source>Copy the versions</source>
        <translation>Versies kopiëren</translation>
    </message>
    <message>
        <source>To the clipboard, for a report of a fault</source>
        <translation>Naar het klembord, om een fout te melden</translation>
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

Reinforcement learning die valpartijen vermijdt.

De methoden komen uit de scriptie van M. van Diepen, *Avoiding failure states during Reinforcement Learning*, Delft.

Vrije software onder de GNU General Public License, versie 3 of later: je mag haar gebruiken, bestuderen, delen en veranderen. Er is geen enkele garantie.</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versies</translation>
    </message>
    <message>
        <source>Citing</source>
        <translation>Citeren</translation>
    </message>
    <message>
        <source>Contributing</source>
        <translation>Bijdragen</translation>
    </message>
    <message>
        <source>Security</source>
        <translation>Veiligheid</translation>
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
        <translation>van kracht</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>drempel %1</translation>
    </message>
    <message>
        <source>risk of the next action %1 %</source>
        <translation>risico van de volgende actie %1 %</translation>
    </message>
    <message>
        <source>%1 of %2 actions are below the limit of %3 %</source>
        <translation>%1 van %2 acties liggen onder de grens van %3 %</translation>
    </message>
    <message>
        <source>%1 and %2 are left out: %3 to %4 in 100 such actions end in a fall.</source>
        <translation>%1 en %2 doen niet mee: van 100 zulke acties eindigen er %3 tot %4 in een val.</translation>
    </message>
    <message>
        <source>%1 is worth most, but its risk of %2 % counts as −%3.</source>
        <translation>%1 is het meest waard, maar het risico van %2 % telt als −%3.</translation>
    </message>
    <message>
        <source>All are above the limit: the least risky is taken.</source>
        <translation>Alle liggen boven de grens: die met het minste risico wordt genomen.</translation>
    </message>
    <message>
        <source>All are above the limit: only the best is taken.</source>
        <translation>Alle liggen boven de grens: alleen de beste wordt genomen.</translation>
    </message>
    <message>
        <source>%1 is worth most, but %2 in 100 such actions end in a fall.</source>
        <translation>%1 is het meest waard, maar van 100 zulke acties eindigen er %2 in een val.</translation>
    </message>
    <message>
        <source>%1 is worth nearly as much as the best, but %2 in 100 such actions end in a fall.</source>
        <translation>%1 is bijna evenveel waard als de beste, maar van 100 zulke acties eindigen er %2 in een val.</translation>
    </message>
    <message>
        <source>%1 is left out: %2 in 100 such actions end in a fall.</source>
        <translation>%1 doet niet mee: van 100 zulke acties eindigen er %2 in een val.</translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risico</translation>
    </message>
    <message>
        <source>limit %1 %</source>
        <translation>grens %1 %</translation>
    </message>
</context>
<context>
    <name>surefoot::Autosave</name>
    <message>
        <source>%1 cannot be made.</source>
        <translation>%1 kan niet worden gemaakt.</translation>
    </message>
</context>
<context>
    <name>surefoot::ChoiceBox</name>
    <message>
        <source>Find the mistake</source>
        <translation>Zoek de fout</translation>
    </message>
    <message>
        <source>Your answer</source>
        <translation>Je antwoord</translation>
    </message>
    <message>
        <source>because … one sentence, your own words</source>
        <translation>omdat … één zin, in eigen woorden</translation>
    </message>
    <message>
        <source>Because</source>
        <translation>Omdat</translation>
    </message>
    <message>
        <source>Choose one first.</source>
        <translation>Kies er eerst een.</translation>
    </message>
</context>
<context>
    <name>surefoot::ClaimsTable</name>
    <message>
        <source>Claims of the thesis</source>
        <translation>Claims van de scriptie</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Claim of the thesis</source>
        <translation>Claim van de scriptie</translation>
    </message>
    <message>
        <source>Thesis</source>
        <translation>Scriptie</translation>
    </message>
    <message>
        <source>Ours (95 % interval)</source>
        <translation>Hier (95%-interval)</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Oordeel</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Waarom</translation>
    </message>
    <message>
        <source>The claim&apos;s number in the recipe and in RESULTS.md: a letter for the topic, counted within it</source>
        <translation>Het nummer van de claim in het recept en in RESULTS.md: een letter voor het onderwerp, daarbinnen geteld</translation>
    </message>
    <message>
        <source>, p %1</source>
        <translation>, p %1</translation>
    </message>
    <message>
        <source>not significant (p ≥ .01)</source>
        <translation>niet significant (p ≥ 0,01)</translation>
    </message>
</context>
<context>
    <name>surefoot::CompareBox</name>
    <message>
        <source>Compare</source>
        <translation>Vergelijk</translation>
    </message>
    <message>
        <source>One cannot tell from these lives</source>
        <translation>Dat valt uit deze levens niet op te maken</translation>
    </message>
    <message>
        <source>The lives are still being lived.</source>
        <translation>De levens worden nog geleefd.</translation>
    </message>
    <message>
        <source>Choose one first.</source>
        <translation>Kies er eerst een.</translation>
    </message>
</context>
<context>
    <name>surefoot::CompareStrip</name>
    <message>
        <source>began with an empty table</source>
        <translation>begon met een lege tabel</translation>
    </message>
    <message>
        <source>began %1</source>
        <translation>begin: %1</translation>
    </message>
    <message>
        <source>Learning rule of the second</source>
        <translation>Leerregel van de tweede</translation>
    </message>
    <message>
        <source>Policy of the second</source>
        <translation>Policy van de tweede</translation>
    </message>
    <message>
        <source>Start of the second</source>
        <translation>Begin van de tweede</translation>
    </message>
    <message>
        <source>Parameters …</source>
        <translation>Parameters …</translation>
    </message>
    <message>
        <source>Falls of both</source>
        <translation>Valpartijen van beide</translation>
    </message>
    <message>
        <source>Parameters of the second</source>
        <translation>Parameters van de tweede</translation>
    </message>
    <message>
        <source>What is changed there holds for the second only</source>
        <translation>Wat je daar wijzigt, geldt alleen voor de tweede</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Eerste</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Tweede</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Vallen</translation>
    </message>
    <message>
        <source>same start</source>
        <translation>zelfde begin</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leeg</translation>
    </message>
    <message>
        <source>a file …</source>
        <translation>een bestand …</translation>
    </message>
    <message>
        <source>What the second begins with</source>
        <translation>Waarmee de tweede begint</translation>
    </message>
    <message>
        <source>Q-functions (*.safetensors *.surefoot);;All files (*)</source>
        <translation>Q-functies (*.safetensors *.surefoot);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>The second has not finished an episode yet.</source>
        <translation>De tweede heeft nog geen episode af.</translation>
    </message>
    <message>
        <source>No episode has ended in both yet.</source>
        <translation>Nog niet bij beide is een episode afgelopen.</translation>
    </message>
    <message>
        <source>after %1 %2 : %3</source>
        <translation>na %1 %2 : %3</translation>
    </message>
    <message>
        <source>; after %1 min %2 : %3</source>
        <translation>; na %1 min %2 : %3</translation>
    </message>
    <message>
        <source>%1; its own: %2</source>
        <translation>%1; eigen: %2</translation>
    </message>
</context>
<context>
    <name>surefoot::ConditionForm</name>
    <message>
        <source>Name of the condition</source>
        <translation>Naam van de conditie</translation>
    </message>
    <message>
        <source>Length of a life</source>
        <translation>Lengte van een leven</translation>
    </message>
    <message>
        <source>Average reward that ends the pre-learning</source>
        <translation>Gemiddelde beloning waarbij het vooraf leren stopt</translation>
    </message>
    <message>
        <source>Q-functions in the pool</source>
        <translation>Q-functies in de pool</translation>
    </message>
    <message>
        <source>Environment of the condition</source>
        <translation>Omgeving van de conditie</translation>
    </message>
    <message>
        <source>Scenario of the condition</source>
        <translation>Scenario van de conditie</translation>
    </message>
    <message>
        <source>Learning rule of the condition</source>
        <translation>Leerregel van de conditie</translation>
    </message>
    <message>
        <source>Representation of the condition</source>
        <translation>Representatie van de conditie</translation>
    </message>
    <message>
        <source>Policy of the condition</source>
        <translation>Policy van de conditie</translation>
    </message>
    <message>
        <source>Pre-learning of the condition</source>
        <translation>Vooraf leren van de conditie</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Omgeving</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Scenario</translation>
    </message>
    <message>
        <source>Learning rule</source>
        <translation>Leerregel</translation>
    </message>
    <message>
        <source>Representation</source>
        <translation>Representatie</translation>
    </message>
    <message>
        <source>Policy</source>
        <translation>Policy</translation>
    </message>
    <message>
        <source>Parameter %1 to set</source>
        <translation>Parameter %1 om in te stellen</translation>
    </message>
    <message>
        <source>Values of parameter %1</source>
        <translation>Waarden van parameter %1</translation>
    </message>
    <message>
        <source>one, or several: 0; 50; 100</source>
        <translation>één, of meer: 0; 50; 100</translation>
    </message>
    <message>
        <source>Set or vary</source>
        <translation>Stel in of varieer</translation>
    </message>
    <message>
        <source>and</source>
        <translation>en</translation>
    </message>
    <message>
        <source>made from policy and values</source>
        <translation>gemaakt uit policy en waarden</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>A life [episodes]</source>
        <translation>Een leven [episodes]</translation>
    </message>
    <message>
        <source>A life [min]</source>
        <translation>Een leven [min]</translation>
    </message>
    <message>
        <source>Pre-learned on</source>
        <translation>Vooraf geleerd op</translation>
    </message>
    <message>
        <source>until reward</source>
        <translation>tot beloning</translation>
    </message>
    <message>
        <source>Q-functions</source>
        <translation>Q-functies</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>niets</translation>
    </message>
</context>
<context>
    <name>surefoot::ConditionList</name>
    <message>
        <source>Conditions</source>
        <translation>Condities</translation>
    </message>
    <message>
        <source>pairs of Q-functions, p &lt; .01</source>
        <translation>paren Q-functies, p &lt; 0,01</translation>
    </message>
    <message>
        <source>%1 Q-functions, p &lt; .01</source>
        <translation>%1 Q-functies, p &lt; 0,01</translation>
    </message>
    <message>
        <source>pairs of lives, p &lt; .01</source>
        <translation>paren levens, p &lt; 0,01</translation>
    </message>
    <message>
        <source>one-way ANOVA, p &lt; .01</source>
        <translation>enkelvoudige ANOVA, p &lt; 0,01</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Omgeving</translation>
    </message>
    <message>
        <source>Pre-learning</source>
        <translation>Vooraf leren</translation>
    </message>
    <message>
        <source>scenario %1, to %2</source>
        <translation>scenario %1, tot %2</translation>
    </message>
    <message>
        <source>scenario %1, %2 min</source>
        <translation>scenario %1, %2 min</translation>
    </message>
    <message>
        <source>Q-functions</source>
        <translation>Q-functies</translation>
    </message>
    <message>
        <source>one a life</source>
        <translation>één per leven</translation>
    </message>
    <message>
        <source>A life</source>
        <translation>Een leven</translation>
    </message>
    <message>
        <source>%1 simulated min</source>
        <translation>%1 gesimuleerde min</translation>
    </message>
    <message>
        <source>Lives</source>
        <translation>Levens</translation>
    </message>
    <message>
        <source>%1 a condition</source>
        <translation>%1 per conditie</translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation>Seeds</translation>
    </message>
    <message>
        <source>paired, from %1</source>
        <translation>gepaard, vanaf %1</translation>
    </message>
    <message>
        <source>independent, from %1</source>
        <translation>onafhankelijk, vanaf %1</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Toets</translation>
    </message>
    <message>
        <source>Lives grow</source>
        <translation>Aantal groeit</translation>
    </message>
    <message>
        <source>until it is decided</source>
        <translation>tot de uitslag vaststaat</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Duur</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>ongeveer %1</translation>
    </message>
    <message>
        <source>Conditions appear here. Choose a plan above, or open one.</source>
        <translation>Hier verschijnen condities. Kies hierboven een plan, of open er een.</translation>
    </message>
    <message>
        <source>DESIGN</source>
        <translation>OPZET</translation>
    </message>
</context>
<context>
    <name>surefoot::CrashDialog</name>
    <message>
        <source>Report of the last crash</source>
        <translation>Verslag van de laatste crash</translation>
    </message>
    <message>
        <source>Versions, the life&apos;s parameters and the last commands; no names of files. Nothing is sent. You can send it to the maintainers yourself, with what you did last: it helps.</source>
        <translation>Versies, de parameters van het leven en de laatste opdrachten; geen bestandsnamen. Er wordt niets verzonden. Je kunt het zelf naar de beheerders sturen, met wat je het laatst deed: dat helpt.</translation>
    </message>
    <message>
        <source>The report</source>
        <translation>Het verslag</translation>
    </message>
    <message>
        <source>It lies in %1.</source>
        <translation>Het staat in %1.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiëren</translation>
    </message>
    <message>
        <source>To the clipboard</source>
        <translation>Naar het klembord</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Verwijderen</translation>
    </message>
</context>
<context>
    <name>surefoot::CurveNames</name>
    <message>
        <source>from nothing</source>
        <translation>vanaf nul</translation>
    </message>
    <message>
        <source>learned before</source>
        <translation>vooraf geleerd</translation>
    </message>
</context>
<context>
    <name>surefoot::Experiment</name>
    <message>
        <source>Appears with the first lives.</source>
        <translation>Verschijnt met de eerste levens.</translation>
    </message>
    <message>
        <source>Choose a plan, and run it.</source>
        <translation>Kies een plan en start het.</translation>
    </message>
    <message>
        <source>Appears when the plan runs.</source>
        <translation>Verschijnt als het plan loopt.</translation>
    </message>
    <message>
        <source>it is being read …</source>
        <translation>wordt gelezen …</translation>
    </message>
    <message>
        <source>all lives are there</source>
        <translation>alle levens zijn er</translation>
    </message>
    <message>
        <source>it is being written</source>
        <translation>wordt geschreven</translation>
    </message>
    <message>
        <source>no process writes it now</source>
        <translation>geen proces schrijft er nu in</translation>
    </message>
    <message>
        <source>no life is over yet</source>
        <translation>er is nog geen leven voorbij</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
    <message>
        <source>last change %1</source>
        <translation>laatste wijziging %1</translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation>nog ongeveer %1</translation>
    </message>
    <message>
        <source>%1 is followed, read only; stop following first.</source>
        <translation>%1 wordt gevolgd, alleen-lezen; stop eerst met volgen.</translation>
    </message>
    <message>
        <source>What these results had in hand is still being kept; run them again in a moment.</source>
        <translation>Wat voor deze resultaten nog liep, wordt bewaard; start ze zo dadelijk opnieuw.</translation>
    </message>
    <message>
        <source>The results have no place: %1 cannot be made.</source>
        <translation>Er is geen plaats voor de resultaten: %1 kan niet worden gemaakt.</translation>
    </message>
</context>
<context>
    <name>surefoot::ExperimentPage</name>
    <message>
        <source>Stop following</source>
        <translation>Stop met volgen</translation>
    </message>
    <message>
        <source>The results stay, as if the store had been opened</source>
        <translation>De resultaten blijven staan, alsof het bestand was geopend</translation>
    </message>
    <message>
        <source>The results are kept. They stand in the list of experiments, and here: %1</source>
        <translation>De resultaten zijn bewaard. Ze staan in de lijst met experimenten, en hier: %1</translation>
    </message>
    <message>
        <source>What was lived so far is kept and can be gone on with. It stands in the list of experiments, and here: %1</source>
        <translation>Wat tot nu toe is geleefd, is bewaard en kan verdergaan. Het staat in de lijst met experimenten, en hier: %1</translation>
    </message>
    <message>
        <source>%1 (%2 of %3 lives)</source>
        <translation>%1 (%2 van %3 levens)</translation>
    </message>
    <message>
        <source>Run the experiment</source>
        <translation>Start het experiment</translation>
    </message>
    <message>
        <source>Start again: forget what was lived</source>
        <translation>Begin opnieuw: vergeet wat is geleefd</translation>
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
        <translation>Tabel kopiëren als CSV</translation>
    </message>
    <message>
        <source>Copy the table as LaTeX</source>
        <translation>Tabel kopiëren als LaTeX</translation>
    </message>
    <message>
        <source>Copy as</source>
        <translation>Kopieer als</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Condities</translation>
    </message>
    <message>
        <source>lives done</source>
        <translation>levens klaar</translation>
    </message>
    <message>
        <source>Edit the plan</source>
        <translation>Plan bewerken</translation>
    </message>
    <message>
        <source>Following %1, read only</source>
        <translation>%1 wordt gevolgd, alleen-lezen</translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation>Toon de resultaten</translation>
    </message>
    <message>
        <source>Go on all the same</source>
        <translation>Toch doorgaan</translation>
    </message>
    <message>
        <source>Allow it, and go on</source>
        <translation>Toestaan en doorgaan</translation>
    </message>
    <message>
        <source>Pause: lives stand still where they are</source>
        <translation>Pauze: de levens staan stil waar ze zijn</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>, and %1 in lives that are not over</source>
        <translation>, en %1 in levens die nog niet voorbij zijn</translation>
    </message>
    <message>
        <source>Open a plan or results</source>
        <translation>Plan of resultaten openen</translation>
    </message>
    <message>
        <source>Plans and results (*.toml *.sqlite);;All files (*)</source>
        <translation>Plannen en resultaten (*.toml *.sqlite);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Save the plan</source>
        <translation>Plan opslaan</translation>
    </message>
    <message>
        <source>Plans (*.toml)</source>
        <translation>Plannen (*.toml)</translation>
    </message>
    <message>
        <source>The plan is in %1.</source>
        <translation>Het plan staat in %1.</translation>
    </message>
    <message>
        <source>There is nothing to copy yet; run the experiment first.</source>
        <translation>Er is nog niets te kopiëren; voer eerst het experiment uit.</translation>
    </message>
    <message>
        <source>The table is on the clipboard, as CSV.</source>
        <translation>De tabel staat op het klembord, als CSV.</translation>
    </message>
    <message>
        <source>The table is on the clipboard, as LaTeX.</source>
        <translation>De tabel staat op het klembord, als LaTeX.</translation>
    </message>
    <message>
        <source>Results can be exported when the experiment is complete or paused.</source>
        <translation>Resultaten kun je exporteren als het experiment klaar is of gepauzeerd.</translation>
    </message>
    <message>
        <source>Folder for the tables</source>
        <translation>Map voor de tabellen</translation>
    </message>
    <message>
        <source>Writing the tables</source>
        <translation>Tabellen worden geschreven</translation>
    </message>
    <message>
        <source>conditions.csv, lives.csv and episodes.csv are in %1.</source>
        <translation>conditions.csv, lives.csv en episodes.csv staan in %1.</translation>
    </message>
    <message>
        <source>There is no chart yet; run the experiment first.</source>
        <translation>Er is nog geen grafiek; voer eerst het experiment uit.</translation>
    </message>
    <message>
        <source>Folder for the charts</source>
        <translation>Map voor de grafieken</translation>
    </message>
    <message>
        <source>Drawing the charts</source>
        <translation>Grafieken worden getekend</translation>
    </message>
    <message>
        <source>Every chart is in %1, as PNG, SVG, PDF and CSV.</source>
        <translation>Alle grafieken staan in %1, als PNG, SVG, PDF en CSV.</translation>
    </message>
    <message>
        <source>Something is being written; wait for its end.</source>
        <translation>Er wordt iets geschreven; wacht tot dat klaar is.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>It was cancelled; what was written before is there.</source>
        <translation>Geannuleerd; wat al was geschreven, staat er.</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabel</translation>
    </message>
    <message>
        <source>The thesis&apos;s claims</source>
        <translation>Claims van de scriptie</translation>
    </message>
    <message>
        <source>falls during learning, against the reference of each condition</source>
        <translation>valpartijen tijdens het leren, ten opzichte van de referentie van elke conditie</translation>
    </message>
    <message>
        <source>what the thesis claims, and what came out here</source>
        <translation>wat de scriptie beweert, en wat hier uitkwam</translation>
    </message>
    <message>
        <source>so far · %1</source>
        <translation>tot nu toe · %1</translation>
    </message>
    <message>
        <source>The conditions</source>
        <translation>De condities</translation>
    </message>
    <message>
        <source> (95 % interval %1 to %2 %)</source>
        <translation> (95%-interval %1 tot %2 %)</translation>
    </message>
    <message>
        <source>It is being opened …</source>
        <translation>Wordt geopend …</translation>
    </message>
    <message>
        <source>The finding in one sentence appears here.</source>
        <translation>Hier verschijnt de uitkomst in één zin.</translation>
    </message>
    <message>
        <source>No condition falls significantly less than its reference (p &amp;lt; .01).</source>
        <translation>Geen conditie valt significant minder dan haar referentie (p &amp;lt; 0,01).</translation>
    </message>
    <message>
        <source>So far no condition falls significantly less than its reference (p &amp;lt; .01).</source>
        <translation>Tot nu toe valt geen conditie significant minder dan haar referentie (p &amp;lt; 0,01).</translation>
    </message>
    <message numerus="yes">
        <source>So far (%1 of %2 lives) </source>
        <translation>
            <numerusform>Tot nu toe (%1 van %2 leven): </numerusform>
            <numerusform>Tot nu toe (%1 van %2 levens): </numerusform>
        </translation>
    </message>
    <message>
        <source>%1&lt;b&gt;%2 falls %3 % less than %4&lt;/b&gt;%5.</source>
        <translation>%1&lt;b&gt;%2 valt %3 % minder dan %4&lt;/b&gt;%5.</translation>
    </message>
    <message>
        <source> The thesis reports %1.</source>
        <translation> De scriptie meldt %1.</translation>
    </message>
    <message>
        <source> Q-functions carry %1 % of the variance.</source>
        <translation> Q-functies dragen %1 % van de variantie.</translation>
    </message>
    <message>
        <source>Lives a condition</source>
        <translation>Levens per conditie</translation>
    </message>
    <message>
        <source>How many lives each condition lives; more make intervals narrower. Another number begins again, what was lived is kept.</source>
        <translation>Hoeveel levens elke conditie leeft; met meer worden intervallen smaller. Een ander aantal begint opnieuw; wat is geleefd, blijft bewaard.</translation>
    </message>
    <message>
        <source> lives</source>
        <translation> levens</translation>
    </message>
    <message>
        <source>a search</source>
        <translation>zoekt</translation>
    </message>
    <message>
        <source>until decided</source>
        <translation>tot uitslag</translation>
    </message>
    <message>
        <source>The plan has edits that are not used yet, so the number of lives is written there; Use this plan takes all of it.</source>
        <translation>Het plan heeft wijzigingen die nog niet gelden; daar staat ook het aantal levens. “Dit plan gebruiken” neemt alles over.</translation>
    </message>
</context>
<context>
    <name>surefoot::ExperimentProgress</name>
    <message>
        <source>Progress</source>
        <translation>Voortgang</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 lives</source>
        <translation>
            <numerusform>%1 van %2 leven</numerusform>
            <numerusform>%1 van %2 levens</numerusform>
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
        <translation>verstreken %1</translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation>nog ongeveer %1</translation>
    </message>
    <message>
        <source>it is being opened …</source>
        <translation>wordt geopend …</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>gepauzeerd</translation>
    </message>
    <message>
        <source>takes about %1</source>
        <translation>duurt ongeveer %1</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>klaar</translation>
    </message>
    <message>
        <source>followed, read only</source>
        <translation>gevolgd, alleen-lezen</translation>
    </message>
</context>
<context>
    <name>surefoot::FallsList</name>
    <message>
        <source>The next falls appear here.
Those before were not recorded in this window.</source>
        <translation>Hier verschijnen de volgende valpartijen.
Die van eerder zijn niet in dit venster opgenomen.</translation>
    </message>
    <message>
        <source>Falls appear here. None so far.</source>
        <translation>Hier verschijnen valpartijen. Nog geen.</translation>
    </message>
</context>
<context>
    <name>surefoot::FigurePanel</name>
    <message>
        <source>Figure</source>
        <translation>Figuur</translation>
    </message>
    <message>
        <source>Another figure</source>
        <translation>Andere figuur</translation>
    </message>
    <message>
        <source>mean and 95 % interval</source>
        <translation>gemiddelde en 95%-interval</translation>
    </message>
    <message>
        <source>mean and 95 % band</source>
        <translation>gemiddelde en 95%-band</translation>
    </message>
    <message>
        <source>so far · %1</source>
        <translation>tot nu toe · %1</translation>
    </message>
    <message>
        <source>It is being drawn.</source>
        <translation>Wordt getekend.</translation>
    </message>
</context>
<context>
    <name>surefoot::FigureView</name>
    <message>
        <source>Bars that have no room</source>
        <translation>Staven die niet passen</translation>
    </message>
    <message>
        <source>All of the time axis	Home</source>
        <translation>Hele tijdas	Home</translation>
    </message>
</context>
<context>
    <name>surefoot::FilmDialog</name>
    <message numerus="yes">
        <source>%1 pictures</source>
        <translation>
            <numerusform>%1 beeld</numerusform>
            <numerusform>%1 beelden</numerusform>
        </translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>the last minutes</source>
        <translation>de laatste minuten</translation>
    </message>
    <message>
        <source>What is filmed</source>
        <translation>Wat er wordt gefilmd</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Van</translation>
    </message>
    <message>
        <source>Film from</source>
        <translation>Film vanaf</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Film up to</source>
        <translation>Film tot</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Van</translation>
    </message>
    <message>
        <source>to</source>
        <translation>tot</translation>
    </message>
    <message>
        <source>Speed of the film</source>
        <translation>Snelheid van de film</translation>
    </message>
    <message>
        <source>as it was</source>
        <translation>zoals het was</translation>
    </message>
    <message>
        <source>half</source>
        <translation>half</translation>
    </message>
    <message>
        <source>a quarter</source>
        <translation>een kwart</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Snelheid</translation>
    </message>
    <message>
        <source>Width of the film</source>
        <translation>Breedte van de film</translation>
    </message>
    <message>
        <source>Height of the film</source>
        <translation>Hoogte van de film</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixels</translation>
    </message>
    <message>
        <source>Colours of the film</source>
        <translation>Kleuren van de film</translation>
    </message>
    <message>
        <source>light</source>
        <translation>licht</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>donker</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Kleuren</translation>
    </message>
    <message>
        <source>below the picture</source>
        <translation>onder het beeld</translation>
    </message>
    <message>
        <source>Signals below the picture</source>
        <translation>Signalen onder het beeld</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signalen</translation>
    </message>
    <message>
        <source>Progress of the film</source>
        <translation>Voortgang van de film</translation>
    </message>
    <message>
        <source>Make the film …</source>
        <translation>Film maken …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>The strips of the Signals layout, with a cursor that goes along</source>
        <translation>De stroken van de indeling Signalen, met een cursor die meeloopt</translation>
    </message>
    <message>
        <source>None were written down: they are while the Signals layout is shown</source>
        <translation>Er zijn er geen vastgelegd: dat gebeurt als de indeling Signalen wordt getoond</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>%1 of %2 pictures. The life goes on meanwhile.</source>
        <translation>%1 van %2 beelden. Het leven gaat intussen door.</translation>
    </message>
    <message>
        <source>There is nothing to film yet: nothing has moved in the window.</source>
        <translation>Er valt nog niets te filmen: er heeft nog niets bewogen in het venster.</translation>
    </message>
    <message>
        <source>A film ends after it begins.</source>
        <translation>Een film eindigt na zijn begin.</translation>
    </message>
    <message>
        <source>A film of %1 s, in %2.%3</source>
        <translation>Een film van %1 s, in %2.%3</translation>
    </message>
    <message>
        <source> WebP only: all others are made by the program ffmpeg, which is not installed.</source>
        <translation> Alleen WebP: de andere maakt het programma ffmpeg, en dat is niet geïnstalleerd.</translation>
    </message>
    <message>
        <source>Make the film</source>
        <translation>Film maken</translation>
    </message>
    <message>
        <source>The film is in %1 (%2).</source>
        <translation>De film staat in %1 (%2).</translation>
    </message>
</context>
<context>
    <name>surefoot::FindingsTable</name>
    <message>
        <source>%1 falls</source>
        <translation>%1 valpartijen</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Resultaten</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Conditie</translation>
    </message>
    <message>
        <source>Lives</source>
        <translation>Levens</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Vallen</translation>
    </message>
    <message>
        <source>± (95 %)</source>
        <translation>± (95 %)</translation>
    </message>
    <message>
        <source>Change %</source>
        <translation>Verschil %</translation>
    </message>
    <message>
        <source>% (95 % interval)</source>
        <translation>% (95%-interval)</translation>
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
        <translation>Tijd min</translation>
    </message>
    <message>
        <source>Expl. %</source>
        <translation>Expl. %</translation>
    </message>
    <message>
        <source>End %</source>
        <translation>Eind %</translation>
    </message>
    <message>
        <source>Thesis</source>
        <translation>Scriptie</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Oordeel</translation>
    </message>
    <message>
        <source>pre(3): its lives began with what was learned on scenario 3</source>
        <translation>pre(3): de levens begonnen met wat op scenario 3 was geleerd</translation>
    </message>
    <message>
        <source>Half of the 95 % interval of the mean, in falls</source>
        <translation>De helft van het 95%-interval van het gemiddelde, in valpartijen</translation>
    </message>
    <message>
        <source>Of the falls, against the reference</source>
        <translation>Van de valpartijen, ten opzichte van de referentie</translation>
    </message>
    <message>
        <source>The 95 % interval of the change, in per cent</source>
        <translation>Het 95%-interval van het verschil, in procenten</translation>
    </message>
    <message>
        <source>This condition against its reference: by pairs of lives or Q-functions where both have the same, by the Q-functions where lives share them, else the one-way analysis of variance of the lives</source>
        <translation>Deze conditie tegen haar referentie: per paar levens of Q-functies als beide dezelfde hebben, per Q-functie als levens die delen, anders de enkelvoudige variantieanalyse van de levens</translation>
    </message>
    <message>
        <source>The same, corrected for all comparisons with this reference (Holm 1979)</source>
        <translation>Hetzelfde, gecorrigeerd voor alle vergelijkingen met deze referentie (Holm 1979)</translation>
    </message>
    <message>
        <source>X: differs from the reference with p &lt; .01</source>
        <translation>X: verschilt van de referentie met p &lt; 0,01</translation>
    </message>
    <message>
        <source>Simulated minutes until the end of learning; – for a task without a clock</source>
        <translation>Gesimuleerde minuten tot het einde van het leren; – bij een taak zonder klok</translation>
    </message>
    <message>
        <source>Share of actions that were not the best by the values at that moment: who explores less falls less</source>
        <translation>Aandeel acties dat volgens de waarden van dat moment niet het beste was: wie minder exploreert, valt minder</translation>
    </message>
    <message>
        <source>Of 100 episodes of the greedy policy at the end of a life, when nothing is learned any more, how many fall</source>
        <translation>Hoeveel van 100 episodes van de greedy policy in een val eindigen, aan het einde van een leven, als er niets meer wordt geleerd</translation>
    </message>
    <message>
        <source>The condition of the chosen row stands out in the figures; Escape lets go</source>
        <translation>De conditie van de gekozen rij springt eruit in de figuren; Escape laat los</translation>
    </message>
    <message>
        <source>%1 (reference)</source>
        <translation>%1 (referentie)</translation>
    </message>
    <message>
        <source>So far: not all lives of this condition, or of what it is compared with</source>
        <translation>Tot nu toe: nog niet alle levens van deze conditie, of van die waarmee ze wordt vergeleken</translation>
    </message>
    <message>
        <source>✕ so far</source>
        <translation>✕ tot nu toe</translation>
    </message>
    <message>
        <source>%1 so far</source>
        <translation>%1 tot nu toe</translation>
    </message>
    <message>
        <source>Claims %1 of the thesis; all of them stand under &quot;The thesis&apos;s claims&quot;</source>
        <translation>Claims %1 van de scriptie; alle staan onder “Claims van de scriptie”</translation>
    </message>
</context>
<context>
    <name>surefoot::Following</name>
    <message>
        <source> What it held before is shown.</source>
        <translation> Getoond wordt wat er eerder in stond.</translation>
    </message>
    <message>
        <source>It is gone.</source>
        <translation>Het is weg.</translation>
    </message>
    <message>
        <source>It is not there yet; this page waits for it.</source>
        <translation>Het is er nog niet; deze pagina wacht erop.</translation>
    </message>
</context>
<context>
    <name>surefoot::HandbookBrowser</name>
    <message>
        <source>Page of the handbook</source>
        <translation>Pagina van het handboek</translation>
    </message>
</context>
<context>
    <name>surefoot::HandbookContents</name>
    <message>
        <source>No page has all of these words.</source>
        <translation>Geen pagina bevat al deze woorden.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Zoeken</translation>
    </message>
    <message>
        <source>Search the handbook</source>
        <translation>Zoek in het handboek</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhoud</translation>
    </message>
</context>
<context>
    <name>surefoot::HandbookWindow</name>
    <message>
        <source>Handbook</source>
        <translation>Handboek</translation>
    </message>
    <message>
        <source>‹ Back</source>
        <translation>‹ Terug</translation>
    </message>
    <message>
        <source>The page before (Alt+←)</source>
        <translation>De vorige pagina (Alt+←)</translation>
    </message>
    <message>
        <source>Forward ›</source>
        <translation>Verder ›</translation>
    </message>
    <message>
        <source>The page after (Alt+→)</source>
        <translation>De volgende pagina (Alt+→)</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Zoeken</translation>
    </message>
    <message>
        <source>A word on this page (Ctrl+F)</source>
        <translation>Een woord op deze pagina (Ctrl+F)</translation>
    </message>
    <message>
        <source>Find; Return: the next one, Escape: done</source>
        <translation>Zoeken; Enter: het volgende, Escape: klaar</translation>
    </message>
    <message>
        <source>Find on this page</source>
        <translation>Zoek op deze pagina</translation>
    </message>
    <message>
        <source>It does not stand on this page.</source>
        <translation>Het staat niet op deze pagina.</translation>
    </message>
</context>
<context>
    <name>surefoot::Handout</name>
    <message>
        <source>%1 minutes, level %2 of 3</source>
        <translation>%1 minuten, niveau %2 van 3</translation>
    </message>
    <message>
        <source>Name _______________________________   Date ______________</source>
        <translation>Naam _______________________________   Datum ______________</translation>
    </message>
    <message>
        <source>For the teacher: %1</source>
        <translation>Voor de docent: %1</translation>
    </message>
    <message>
        <source>You know now: %1</source>
        <translation>Je weet nu: %1</translation>
    </message>
    <message>
        <source>To discuss: %1</source>
        <translation>Om te bespreken: %1</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>I set: ____________________   It came to: ____________</source>
        <translation>Ik stel in: ____________________   Het werd: ____________</translation>
    </message>
    <message>
        <source>Hint: %1</source>
        <translation>Hint: %1</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>ongeveer %1 min</translation>
    </message>
    <message>
        <source>I say: ____________ %1 (%2 to %3). It came to: ____________</source>
        <translation>Ik zeg: ____________ %1 (%2 tot %3). Het werd: ____________</translation>
    </message>
    <message>
        <source>It comes to %1.</source>
        <translation>Het wordt %1.</translation>
    </message>
    <message>
        <source>because</source>
        <translation>omdat</translation>
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
        <translation>%1, in het handboek</translation>
    </message>
</context>
<context>
    <name>surefoot::History</name>
    <message>
        <source>the new life</source>
        <translation>nieuw leven</translation>
    </message>
</context>
<context>
    <name>surefoot::KioskFoot</name>
    <message>
        <source>How much they explore</source>
        <translation>Hoeveel ze exploreren</translation>
    </message>
    <message>
        <source>in 100 steps both try something else than the best</source>
        <translation>in 100 stappen proberen beide iets anders dan het beste</translation>
    </message>
    <message>
        <source>of 100</source>
        <translation>van 100</translation>
    </message>
    <message>
        <source>the lesson&apos;s word</source>
        <translation>het woord van de les</translation>
    </message>
    <message>
        <source>The lesson&apos;s word</source>
        <translation>Het woord van de les</translation>
    </message>
    <message>
        <source>What you see</source>
        <translation>Wat je ziet</translation>
    </message>
</context>
<context>
    <name>surefoot::KioskRobot</name>
    <message>
        <source>Touch the pole</source>
        <translation>Raak de stok aan</translation>
    </message>
    <message>
        <source>both get the same push</source>
        <translation>beide krijgen dezelfde duw</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>valpartijen</translation>
    </message>
    <message>
        <source>World of %1</source>
        <translation>Wereld van %1</translation>
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
        <translation>probeert wat dan ook</translation>
    </message>
    <message>
        <source>Softmax</source>
        <translation>Softmax</translation>
    </message>
    <message>
        <source>tries what is nearly as good</source>
        <translation>probeert wat bijna zo goed is</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Opnieuw beginnen</translation>
    </message>
    <message>
        <source>by itself in %1 s</source>
        <translation>vanzelf over %1 s</translation>
    </message>
    <message>
        <source>ε-greedy %1 falls, Softmax %2 falls</source>
        <translation>ε-greedy %1 valpartijen, Softmax %2 valpartijen</translation>
    </message>
    <message>
        <source>It is being made ready …</source>
        <translation>Wordt klaargezet …</translation>
    </message>
    <message>
        <source>ε = %1 against τ = %2, %3 episodes each</source>
        <translation>ε = %1 tegen τ = %2, elk %3 episodes</translation>
    </message>
    <message>
        <source>After %1 episodes: %2 falls against %3.</source>
        <translation>Na %1 episodes: %2 valpartijen tegen %3.</translation>
    </message>
    <message>
        <source>Now neither tries anything: both always take what they think is best.</source>
        <translation>Nu probeert geen van beide iets: ze nemen steeds wat ze het beste vinden.</translation>
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
        <translation>Leerregel</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Scenario</translation>
    </message>
</context>
<context>
    <name>surefoot::LearningChart</name>
    <message>
        <source>episode %1</source>
        <translation>episode %1</translation>
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
            <numerusform>%1 val</numerusform>
            <numerusform>%1 valpartijen</numerusform>
        </translation>
    </message>
    <message>
        <source>Whole life	Home</source>
        <translation>Hele leven	Home</translation>
    </message>
    <message>
        <source>While it learned</source>
        <translation>Tijdens het leren</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 verwijderen</translation>
    </message>
    <message>
        <source>Remove all earlier runs</source>
        <translation>Alle eerdere runs verwijderen</translation>
    </message>
    <message>
        <source>pushed by hand</source>
        <translation>met de hand geduwd</translation>
    </message>
    <message>
        <source>placed by hand</source>
        <translation>met de hand geplaatst</translation>
    </message>
    <message>
        <source>gone on from an earlier moment</source>
        <translation>verdergegaan vanaf een eerder moment</translation>
    </message>
    <message>
        <source>end of learning</source>
        <translation>einde van het leren</translation>
    </message>
    <message>
        <source>A fall after a person placed or pushed the body. A click replays it.</source>
        <translation>Een val nadat iemand het lichaam had geplaatst of geduwd. Een klik speelt hem opnieuw af.</translation>
    </message>
    <message>
        <source>A click replays this fall.</source>
        <translation>Een klik speelt deze val opnieuw af.</translation>
    </message>
    <message>
        <source>This fall is no longer kept; it cannot be replayed.</source>
        <translation>Deze val wordt niet meer bewaard en is niet opnieuw af te spelen.</translation>
    </message>
    <message>
        <source>Falls appear here. None so far.</source>
        <translation>Hier verschijnen valpartijen. Nog geen.</translation>
    </message>
    <message>
        <source>The average appears with the first episodes.</source>
        <translation>Het gemiddelde verschijnt met de eerste episodes.</translation>
    </message>
    <message>
        <source>simulated time [min]</source>
        <translation>gesimuleerde tijd [min]</translation>
    </message>
    <message>
        <source>episodes</source>
        <translation>episodes</translation>
    </message>
    <message>
        <source>2nd: %1</source>
        <translation>2e: %1</translation>
    </message>
    <message>
        <source>live: %1</source>
        <translation>live: %1</translation>
    </message>
    <message>
        <source>run %1: %2</source>
        <translation>run %1: %2</translation>
    </message>
    <message>
        <source>00,000 you said</source>
        <translation>00,000 zei je</translation>
    </message>
    <message>
        <source>greedy tests</source>
        <translation>greedy tests</translation>
    </message>
    <message>
        <source>you said</source>
        <translation>zei je</translation>
    </message>
    <message>
        <source>you say</source>
        <translation>zeg je</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bij %2</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 meer</translation>
    </message>
    <message>
        <source>%1 fewer</source>
        <translation>%1 minder</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonBar</name>
    <message>
        <source>‹  All lessons</source>
        <translation>‹  Alle lessen</translation>
    </message>
    <message>
        <source>The list of lessons; this one waits at its step</source>
        <translation>De lijst met lessen; deze wacht bij haar stap</translation>
    </message>
    <message>
        <source>Teacher</source>
        <translation>Docent</translation>
    </message>
    <message>
        <source>Notes, answers and the class, in a window for the teacher&apos;s own screen</source>
        <translation>Notities, antwoorden en de klas, in een venster voor het eigen scherm van de docent</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Run or pause</source>
        <translation>Start of pauze</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Opnieuw</translation>
    </message>
    <message>
        <source>Start the life again with the same seed</source>
        <translation>Begin het leven opnieuw met dezelfde seed</translation>
    </message>
    <message>
        <source>Turbo</source>
        <translation>Turbo</translation>
    </message>
    <message>
        <source>Learn flat out</source>
        <translation>Leer op volle snelheid</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>How fast the world runs; real time is in the middle</source>
        <translation>Hoe snel de wereld loopt; in het midden is het de echte tijd</translation>
    </message>
    <message>
        <source>How long the robot has lived, by its own clock</source>
        <translation>Hoelang de robot al leeft, volgens zijn eigen klok</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>minuten</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>valpartijen</translation>
    </message>
    <message>
        <source>episodes</source>
        <translation>episodes</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pauze</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonColumn</name>
    <message>
        <source>%1 % lived</source>
        <translation>%1 % geleefd</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Hint</translation>
    </message>
    <message>
        <source>Reset step</source>
        <translation>Stap opnieuw</translation>
    </message>
    <message>
        <source>Explore freely</source>
        <translation>Vrij verkennen</translation>
    </message>
    <message>
        <source>A hint, if the step has one (F1)</source>
        <translation>Een hint, als de stap er een heeft (F1)</translation>
    </message>
    <message>
        <source>The step begins again, as it was</source>
        <translation>De stap begint opnieuw, zoals hij was</translation>
    </message>
    <message>
        <source>The Live page with this robot as it is now; the lesson waits here</source>
        <translation>De pagina Live met deze robot zoals hij nu is; de les wacht hier</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Terug</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Verder</translation>
    </message>
    <message>
        <source>The step before (Alt+←)</source>
        <translation>De vorige stap (Alt+←)</translation>
    </message>
    <message>
        <source>Go on (Alt+→)</source>
        <translation>Ga verder (Alt+→)</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>stap %1 van %2</translation>
    </message>
    <message>
        <source>Knob</source>
        <translation>Knop</translation>
    </message>
    <message>
        <source>Knobs</source>
        <translation>Knoppen</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Stap %1 van %2: %3</translation>
    </message>
    <message>
        <source>%1 becomes %2</source>
        <translation>%1 wordt %2</translation>
    </message>
    <message>
        <source>%1 when you commit</source>
        <translation>%1 als je vastlegt</translation>
    </message>
    <message>
        <source>done</source>
        <translation>klaar</translation>
    </message>
    <message>
        <source>The lesson is done. You know now: %1</source>
        <translation>De les is klaar. Je weet nu: %1</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Overslaan</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Afronden</translation>
    </message>
    <message>
        <source>It is being made ready …</source>
        <translation>Wordt klaargezet …</translation>
    </message>
    <message>
        <source>It is being lived …</source>
        <translation>Wordt geleefd …</translation>
    </message>
    <message>
        <source>The lives are being lived …</source>
        <translation>De levens worden geleefd …</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonDetails</name>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n stap</numerusform>
            <numerusform>%n stappen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 min, level %2</source>
        <translation>%1 min, niveau %2</translation>
    </message>
    <message>
        <source>Q on a map</source>
        <translation>Q op een kaart</translation>
    </message>
    <message>
        <source>actions</source>
        <translation>acties</translation>
    </message>
    <message>
        <source>one step</source>
        <translation>één stap</translation>
    </message>
    <message>
        <source>rule of thumb</source>
        <translation>vuistregel</translation>
    </message>
    <message>
        <source>average reward</source>
        <translation>gemiddelde beloning</translation>
    </message>
    <message>
        <source>list of falls</source>
        <translation>lijst van valpartijen</translation>
    </message>
    <message>
        <source>the learning rule</source>
        <translation>de leerregel</translation>
    </message>
    <message>
        <source>Better after</source>
        <translation>Liefst na</translation>
    </message>
    <message>
        <source>On screen</source>
        <translation>Op het scherm</translation>
    </message>
    <message>
        <source>Knobs</source>
        <translation>Knoppen</translation>
    </message>
    <message>
        <source>See again</source>
        <translation>Nog eens zien</translation>
    </message>
    <message>
        <source>Continue at step %1</source>
        <translation>Verder bij stap %1</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>Opnieuw beginnen</translation>
    </message>
    <message>
        <source>Explore freely</source>
        <translation>Vrij verkennen</translation>
    </message>
    <message>
        <source>The Live page, as the lesson begins</source>
        <translation>De pagina Live, zoals de les begint</translation>
    </message>
    <message>
        <source>world</source>
        <translation>wereld</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>parameters</translation>
    </message>
    <message>
        <source>signals</source>
        <translation>signalen</translation>
    </message>
    <message>
        <source>phase portrait</source>
        <translation>faseportret</translation>
    </message>
    <message>
        <source>strides</source>
        <translation>schreden</translation>
    </message>
    <message>
        <source>policy</source>
        <translation>policy</translation>
    </message>
    <message>
        <source>scenario</source>
        <translation>scenario</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonDriver</name>
    <message>
        <source>Not there. Try another place.</source>
        <translation>Daar niet. Probeer een andere plek.</translation>
    </message>
    <message>
        <source>That life is over; restart it and try another way.</source>
        <translation>Dat leven is voorbij; begin het opnieuw en probeer het anders.</translation>
    </message>
    <message>
        <source>The lesson begins anew: %1</source>
        <translation>De les begint opnieuw: %1</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonEditor</name>
    <message>
        <source>Lesson</source>
        <translation>Les</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Uitproberen</translation>
    </message>
    <message>
        <source>Live through it</source>
        <translation>Doorlopen</translation>
    </message>
    <message>
        <source>All solutions are lived; what does not come out as the text says is told</source>
        <translation>Alle oplossingen worden geleefd; wat anders uitkomt dan de tekst zegt, wordt gemeld</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation>Opslaan als …</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle lessen</translation>
    </message>
    <message>
        <source>It is being lived through …</source>
        <translation>De les wordt doorlopen …</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Regel %1: %2</translation>
    </message>
    <message>
        <source>No errors. “Live through it” tries its solutions.</source>
        <translation>Geen fouten. “Doorlopen” probeert de oplossingen uit.</translation>
    </message>
    <message>
        <source>Well: all %1 steps were lived through.</source>
        <translation>Goed: alle %1 stappen zijn doorlopen.</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>nog niet opgeslagen</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, gewijzigd</translation>
    </message>
    <message>
        <source>The step under the caret is shown here.</source>
        <translation>Hier staat de stap bij de tekstcursor.</translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation>Stap %1: %2</translation>
    </message>
    <message>
        <source>%1; as of the last text without an error</source>
        <translation>%1; volgens de laatste tekst zonder fout</translation>
    </message>
    <message>
        <source>Save the lesson</source>
        <translation>Les opslaan</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonEnd</name>
    <message>
        <source>You know now</source>
        <translation>Je weet nu</translation>
    </message>
    <message>
        <source>In your words</source>
        <translation>In je eigen woorden</translation>
    </message>
    <message>
        <source>One answer</source>
        <translation>Eén antwoord</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Volgende: %1</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle lessen</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonList</name>
    <message>
        <source>%1, it has an error</source>
        <translation>%1, met een fout</translation>
    </message>
    <message>
        <source>done</source>
        <translation>klaar</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>stap %1 van %2</translation>
    </message>
    <message>
        <source>not begun</source>
        <translation>niet begonnen</translation>
    </message>
    <message>
        <source>Lesson %1 of %2, </source>
        <translation>Les %1 van %2, </translation>
    </message>
    <message>
        <source>%1%2, %3 minutes, level %4 of 3, %5</source>
        <translation>%1%2, %3 minuten, niveau %4 van 3, %5</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lessen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonPanels</name>
    <message>
        <source>World</source>
        <translation>Wereld</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Valpartijen</translation>
    </message>
    <message>
        <source>Average reward</source>
        <translation>Gemiddelde beloning</translation>
    </message>
    <message>
        <source>cumulative; each mark is one, click it to replay</source>
        <translation>cumulatief; elk streepje is er een, klik erop om die terug te zien</translation>
    </message>
    <message>
        <source>last 80 episodes</source>
        <translation>laatste 80 episodes</translation>
    </message>
    <message>
        <source>What the robot would do now</source>
        <translation>Wat de robot nu zou doen</translation>
    </message>
    <message>
        <source>% on a square-root scale</source>
        <translation>% op een wortelschaal</translation>
    </message>
    <message>
        <source>Value maps</source>
        <translation>Waardekaarten</translation>
    </message>
    <message>
        <source>This step</source>
        <translation>Deze stap</translation>
    </message>
    <message>
        <source>what the last one taught</source>
        <translation>wat van de laatste is geleerd</translation>
    </message>
    <message>
        <source>Rule of thumb</source>
        <translation>Vuistregel</translation>
    </message>
    <message>
        <source>TRL&apos;s threshold</source>
        <translation>drempel van TRL</translation>
    </message>
    <message>
        <source>List of falls</source>
        <translation>Lijst van valpartijen</translation>
    </message>
    <message>
        <source>a click shows one again</source>
        <translation>een klik toont er een opnieuw</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameters</translation>
    </message>
    <message>
        <source>%1 lives of each</source>
        <translation>%1 levens van elk</translation>
    </message>
    <message>
        <source>real time; the learner runs faster</source>
        <translation>echte tijd; de leerder loopt sneller</translation>
    </message>
    <message>
        <source>it learns; take hold of it</source>
        <translation>hij leert; pak hem maar vast</translation>
    </message>
    <message>
        <source>what it can do so far; it learns nothing now</source>
        <translation>wat hij tot nu toe kan; hij leert nu niets</translation>
    </message>
    <message>
        <source>held still</source>
        <translation>staat stil</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonRow</name>
    <message>
        <source>minutes</source>
        <translation>minuten</translation>
    </message>
    <message>
        <source>level</source>
        <translation>niveau</translation>
    </message>
    <message>
        <source>it has an error</source>
        <translation>met een fout</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonView</name>
    <message>
        <source>Next</source>
        <translation>Verder</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Terug</translation>
    </message>
    <message>
        <source>your prediction</source>
        <translation>je voorspelling</translation>
    </message>
</context>
<context>
    <name>surefoot::LessonsPage</name>
    <message>
        <source>What you do cannot be kept: %1</source>
        <translation>Wat je doet, kan niet worden bewaard: %1</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>seed %1</translation>
    </message>
    <message>
        <source>answers are kept on this computer only</source>
        <translation>antwoorden blijven alleen op deze computer bewaard</translation>
    </message>
    <message>
        <source>answers of %1 are kept in %2</source>
        <translation>antwoorden van %1 worden bewaard in %2</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Verder</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lessen</translation>
    </message>
    <message>
        <source>thirteen, a good two hours in all; a double lesson of 90 minutes is 1, 2, 3, 5, 6, 7, 11, 13</source>
        <translation>dertien, samen ruim twee uur; een dubbele les van 90 minuten is 1, 2, 3, 5, 6, 7, 11, 13</translation>
    </message>
    <message>
        <source>What was said and done in “%1” is forgotten when it begins again.</source>
        <translation>Wat in “%1” is gezegd en gedaan, wordt vergeten als de les opnieuw begint.</translation>
    </message>
    <message>
        <source>No lessons</source>
        <translation>Geen lessen</translation>
    </message>
    <message>
        <source>All are done</source>
        <translation>Alles is klaar</translation>
    </message>
    <message>
        <source>Lessons come with the program; none were found in %1.</source>
        <translation>Lessen horen bij het programma; in %1 zijn er geen gevonden.</translation>
    </message>
    <message>
        <source>Start with the first</source>
        <translation>Begin met de eerste</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation>nog ongeveer %1 min</translation>
    </message>
    <message>
        <source>%1   step %2 of %3, %4</source>
        <translation>%1   stap %2 van %3, %4</translation>
    </message>
    <message>
        <source>%1   %2 min</source>
        <translation>%1   %2 min</translation>
    </message>
    <message>
        <source>You were asked: %1</source>
        <translation>De vraag was: %1</translation>
    </message>
    <message>
        <source>about %1 hours left</source>
        <translation>nog ongeveer %1 uur</translation>
    </message>
    <message>
        <source>%1 of %2 lessons</source>
        <translation>%1 van %2 lessen</translation>
    </message>
    <message>
        <source>For teachers:</source>
        <translation>Voor docenten:</translation>
    </message>
    <message>
        <source>a lesson file can also be dropped here</source>
        <translation>je kunt hier ook een lesbestand neerzetten</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notities</translation>
    </message>
    <message>
        <source>What the chosen lesson&apos;s teacher should know: answers, questions, times</source>
        <translation>Wat de docent van de gekozen les moet weten: antwoorden, vragen, tijden</translation>
    </message>
    <message>
        <source>Open a lesson file …</source>
        <translation>Lesbestand openen …</translation>
    </message>
    <message>
        <source>Write …</source>
        <translation>Schrijven …</translation>
    </message>
    <message>
        <source>Class …</source>
        <translation>Klas …</translation>
    </message>
    <message>
        <source>Kiosk</source>
        <translation>Kiosk</translation>
    </message>
    <message>
        <source>Hand-out …</source>
        <translation>Hand-out …</translation>
    </message>
    <message>
        <source>A lesson of one&apos;s own: one text file</source>
        <translation>Een eigen les: één tekstbestand</translation>
    </message>
    <message>
        <source>Answers are kept in a shared folder, in a file for each student</source>
        <translation>Antwoorden komen in een gedeelde map, in een bestand per student</translation>
    </message>
    <message>
        <source>Two robots on the whole screen, for a booth; a window of its own</source>
        <translation>Twee robots op het hele scherm, voor een stand; een eigen venster</translation>
    </message>
    <message>
        <source>The lesson on paper, with room to write, or with the answers</source>
        <translation>De les op papier, met ruimte om te schrijven, of met de antwoorden</translation>
    </message>
    <message>
        <source>A lesson of one&apos;s own as text, checked while it is typed</source>
        <translation>Een eigen les als tekst, die tijdens het typen wordt gecontroleerd</translation>
    </message>
    <message>
        <source>A new lesson</source>
        <translation>Een nieuwe les</translation>
    </message>
    <message>
        <source>The chosen one</source>
        <translation>De gekozen les</translation>
    </message>
    <message>
        <source>For students …</source>
        <translation>Voor studenten …</translation>
    </message>
    <message>
        <source>With the answers …</source>
        <translation>Met de antwoorden …</translation>
    </message>
    <message>
        <source>Open a lesson</source>
        <translation>Les openen</translation>
    </message>
    <message>
        <source>Lessons (*.toml);;All files (*)</source>
        <translation>Lessen (*.toml);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 is geschreven.</translation>
    </message>
    <message>
        <source>The text in hand is not saved; save it, and then take another.</source>
        <translation>De huidige tekst is niet opgeslagen; sla hem op en neem dan een andere.</translation>
    </message>
    <message>
        <source>This text was not saved; it is back as it was.</source>
        <translation>Deze tekst was niet opgeslagen; hij is terug zoals hij was.</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klas</translation>
    </message>
    <message>
        <source>Every student has a file of their own in the folder. A name of your choosing will do.</source>
        <translation>Elke student heeft een eigen bestand in de map. Een naam naar keuze volstaat.</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Meedoen</translation>
    </message>
    <message>
        <source>Shared folder</source>
        <translation>Gedeelde map</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>A name has up to 40 letters, digits, blanks, - and _.</source>
        <translation>Een naam heeft hoogstens 40 letters, cijfers, spaties, - en _.</translation>
    </message>
    <message>
        <source>There is no such folder.</source>
        <translation>Die map bestaat niet.</translation>
    </message>
    <message>
        <source>This lesson has no kiosk; these have one: %1.</source>
        <translation>Deze les heeft geen kiosk; deze wel: %1.</translation>
    </message>
    <message>
        <source>The kiosk could not be started.</source>
        <translation>De kiosk kon niet worden gestart.</translation>
    </message>
    <message>
        <source>The kiosk opens. Ctrl+Shift+K and the word “%1” leave it.</source>
        <translation>De kiosk opent. Met Ctrl+Shift+K en het woord “%1” verlaat je hem.</translation>
    </message>
    <message>
        <source>Hand-out</source>
        <translation>Hand-out</translation>
    </message>
</context>
<context>
    <name>surefoot::LifeFollower</name>
    <message>
        <source>it is being read …</source>
        <translation>wordt gelezen …</translation>
    </message>
    <message>
        <source>the life is complete</source>
        <translation>het leven is voltooid</translation>
    </message>
    <message>
        <source>as of %1, %2</source>
        <translation>stand van %1, %2</translation>
    </message>
    <message>
        <source>the body acts with its values, and learns nothing</source>
        <translation>het lichaam handelt naar die waarden en leert niets</translation>
    </message>
    <message>
        <source>it stands still</source>
        <translation>het staat stil</translation>
    </message>
</context>
<context>
    <name>surefoot::LivePage</name>
    <message>
        <source>Parameters</source>
        <translation>Parameters</translation>
    </message>
    <message>
        <source>preset %1</source>
        <translation>preset %1</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Meer</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Herstel alles</translation>
    </message>
    <message>
        <source>Fewer</source>
        <translation>Minder</translation>
    </message>
    <message>
        <source>What the robot would do now</source>
        <translation>Wat de robot nu zou doen</translation>
    </message>
    <message>
        <source>This step</source>
        <translation>Deze stap</translation>
    </message>
    <message>
        <source>what the last one taught</source>
        <translation>wat van de laatste is geleerd</translation>
    </message>
    <message>
        <source>Rule of thumb</source>
        <translation>Vuistregel</translation>
    </message>
    <message>
        <source>TRL&apos;s threshold</source>
        <translation>drempel van TRL</translation>
    </message>
    <message>
        <source>List of falls</source>
        <translation>Lijst van valpartijen</translation>
    </message>
    <message>
        <source>a click shows one again</source>
        <translation>een klik toont er een opnieuw</translation>
    </message>
    <message>
        <source>Average reward</source>
        <translation>Gemiddelde beloning</translation>
    </message>
    <message>
        <source>last %1 episodes</source>
        <translation>laatste %1 episodes</translation>
    </message>
    <message>
        <source>all %1 so far</source>
        <translation>alle %1 tot nu toe</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Valpartijen</translation>
    </message>
    <message>
        <source>Whole life</source>
        <translation>Hele leven</translation>
    </message>
    <message>
        <source>Show the whole life, or only as far as it learned. In the chart the wheel or a drag magnifies a part; a double click or Home shows the whole life.</source>
        <translation>Toon het hele leven, of alleen zolang het leerde. Met het wiel of door slepen vergroot je een deel van de grafiek; dubbelklikken of Home toont het hele leven.</translation>
    </message>
    <message>
        <source>A part</source>
        <translation>Een deel</translation>
    </message>
    <message>
        <source>While it learned</source>
        <translation>Tijdens het leren</translation>
    </message>
    <message>
        <source>Time shown: %1</source>
        <translation>Getoonde tijd: %1</translation>
    </message>
    <message>
        <source>cumulative</source>
        <translation>cumulatief</translation>
    </message>
    <message>
        <source>up to minute %1</source>
        <translation>tot minuut %1</translation>
    </message>
    <message>
        <source>up to episode %1</source>
        <translation>tot episode %1</translation>
    </message>
    <message>
        <source>%1; %2 after a push or placing by hand</source>
        <translation>%1; %2 na duwen of plaatsen met de hand</translation>
    </message>
    <message>
        <source>%1; click a mark to replay it</source>
        <translation>%1; klik op een streepje om het terug te zien</translation>
    </message>
    <message>
        <source>Value maps</source>
        <translation>Waardekaarten</translation>
    </message>
    <message>
        <source>in the state fixed on the map; Escape on the map lets go</source>
        <translation>in de toestand die op de kaart vastligt; Escape op de kaart laat los</translation>
    </message>
    <message>
        <source>in the state under the cursor on the map</source>
        <translation>in de toestand onder de cursor op de kaart</translation>
    </message>
    <message>
        <source>the next action is shaded; %1 actions, by joint</source>
        <translation>de volgende actie is gemarkeerd; %1 acties, per gewricht</translation>
    </message>
    <message>
        <source>in the replay</source>
        <translation>in de herhaling</translation>
    </message>
    <message>
        <source>in the real-time world</source>
        <translation>in de wereld in echte tijd</translation>
    </message>
    <message>
        <source>the next action is shaded</source>
        <translation>de volgende actie is gemarkeerd</translation>
    </message>
    <message>
        <source>%1; Escape: back to live</source>
        <translation>%1; Escape: terug naar live</translation>
    </message>
    <message>
        <source>%1; ← → move, Escape: back to live</source>
        <translation>%1; ← → verplaatsen, Escape: terug naar live</translation>
    </message>
    <message>
        <source>real time, newest Q-function; nothing is learned</source>
        <translation>echte tijd, nieuwste Q-functie; er wordt niets geleerd</translation>
    </message>
    <message>
        <source>the life is complete</source>
        <translation>het leven is voltooid</translation>
    </message>
    <message>
        <source>the learner&apos;s world, paused; turbo is on</source>
        <translation>de wereld van de leerder, gepauzeerd; turbo staat aan</translation>
    </message>
    <message>
        <source>the learner&apos;s world, paused</source>
        <translation>de wereld van de leerder, gepauzeerd</translation>
    </message>
    <message>
        <source>the learner&apos;s world; its life began %1</source>
        <translation>de wereld van de leerder; begin van het leven: %1</translation>
    </message>
    <message>
        <source>the learner&apos;s world</source>
        <translation>de wereld van de leerder</translation>
    </message>
    <message>
        <source>the learner&apos;s world, %1</source>
        <translation>de wereld van de leerder, %1</translation>
    </message>
    <message>
        <source>real time; only this world is held, the learner&apos;s is not</source>
        <translation>echte tijd; alleen deze wereld staat stil, die van de leerder niet</translation>
    </message>
    <message>
        <source>real time, newest Q-function</source>
        <translation>echte tijd, nieuwste Q-functie</translation>
    </message>
    <message>
        <source>real time, newest Q-function; the learner runs %1</source>
        <translation>echte tijd, nieuwste Q-functie; de leerder loopt %1</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Wereld</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Eerste</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Tweede</translation>
    </message>
    <message>
        <source>Panels that share this place</source>
        <translation>Panelen die deze plaats delen</translation>
    </message>
    <message>
        <source>The learner goes on %1 steps into that episode, with what it knows now; the journal says so.</source>
        <translation>De leerder gaat na %1 stappen van die episode verder, met wat hij nu weet; het staat in het logboek.</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signalen</translation>
    </message>
    <message>
        <source>Phase portrait</source>
        <translation>Faseportret</translation>
    </message>
    <message>
        <source>Signals of the axes</source>
        <translation>Signalen van de assen</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Horizontaal</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Verticaal</translation>
    </message>
    <message>
        <source>Strides</source>
        <translation>Schreden</translation>
    </message>
    <message>
        <source>two steps each; a click marks one in the signals</source>
        <translation>elk twee stappen; een klik markeert er een in de signalen</translation>
    </message>
</context>
<context>
    <name>surefoot::LivesView</name>
    <message>
        <source>%1: mean %2, 95 percent interval %3 to %4</source>
        <translation>%1: gemiddelde %2, 95%-interval %3 tot %4</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>verschil</translation>
    </message>
    <message>
        <source>a line: one seed; </source>
        <translation>een lijn: één seed; </translation>
    </message>
    <message>
        <source>a dot: one life; %1bar: 95 % interval of the mean</source>
        <translation>een stip: één leven; %1balk: 95%-interval van het gemiddelde</translation>
    </message>
    <message>
        <source>%1bar: 95 % interval</source>
        <translation>%1balk: 95%-interval</translation>
    </message>
    <message>
        <source>bar: 95 % interval</source>
        <translation>balk: 95%-interval</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>gem.</translation>
    </message>
    <message>
        <source>They are being lived …</source>
        <translation>Ze worden geleefd …</translation>
    </message>
</context>
<context>
    <name>surefoot::Looking</name>
    <message>
        <source>fall %1, at a quarter of the speed</source>
        <translation>val %1, op een kwart van de snelheid</translation>
    </message>
    <message>
        <source>Only the learner&apos;s own world can be gone on with, in the Signals layout and without turbo; or a fall, or a roll-out.</source>
        <translation>Alleen de eigen wereld van de leerder kan verdergaan, in de indeling Signalen en zonder turbo; of een val, of een rollout.</translation>
    </message>
    <message>
        <source>That episode is over, and it did not end in a fall: its inputs were not kept.</source>
        <translation>Die episode is voorbij en eindigde niet in een val: de invoer is niet bewaard.</translation>
    </message>
    <message>
        <source>Nothing is shown again: open a fall, look back, or roll out first.</source>
        <translation>Er is geen herhaling te zien: open eerst een val, kijk terug, of doe een rollout.</translation>
    </message>
    <message>
        <source>%1 was %2 then and is %3 now: the same inputs would lead elsewhere.</source>
        <translation>%1 was toen %2 en is nu %3: dezelfde invoer zou ergens anders uitkomen.</translation>
    </message>
    <message>
        <source>The episode was over then; choose a moment before its end.</source>
        <translation>De episode was toen voorbij; kies een moment voor het einde.</translation>
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
        <translation>&amp;Pauze</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>The life is complete; restart it to run again</source>
        <translation>Het leven is voltooid; begin opnieuw om het weer te starten</translation>
    </message>
    <message>
        <source>Run or pause</source>
        <translation>Start of pauze</translation>
    </message>
    <message>
        <source>Start the life again with the same seed</source>
        <translation>Begin het leven opnieuw met dezelfde seed</translation>
    </message>
    <message>
        <source>Start the life again with the same seed and the same start: %1</source>
        <translation>Begin het leven opnieuw met dezelfde seed en hetzelfde begin: %1</translation>
    </message>
    <message>
        <source>The life begins again with the same start: %1. Run › Restart with an empty table begins from nothing.</source>
        <translation>Het leven begint opnieuw met hetzelfde begin: %1. Start › Opnieuw met lege tabel begint vanaf nul.</translation>
    </message>
    <message>
        <source>Another seed</source>
        <translation>Andere seed</translation>
    </message>
    <message>
        <source>The life begins again with this seed, a whole number from 0 on:</source>
        <translation>Het leven begint opnieuw met deze seed, een geheel getal vanaf 0:</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Sneltoetsen</translation>
    </message>
    <message>
        <source> or </source>
        <translation> of </translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Openen</translation>
    </message>
    <message>
        <source>Everything that can be opened (*.surefoot *.safetensors *.jsonl *.toml *.sqlite);;All files (*)</source>
        <translation>Alles wat te openen is (*.surefoot *.safetensors *.jsonl *.toml *.sqlite);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>%1 is loaded and goes on learning.</source>
        <translation>%1 is geladen en leert verder.</translation>
    </message>
    <message>
        <source>%1 is loaded, not running: Run goes on learning.</source>
        <translation>%1 is geladen en staat stil: Start leert verder.</translation>
    </message>
    <message>
        <source>%1 Run › Roll out 25 s shows what it does now, without learning.</source>
        <translation>%1 Start › Rollout 25 s toont wat hij nu doet, zonder te leren.</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Nog niets</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Sessie opslaan</translation>
    </message>
    <message>
        <source>%1 is written. It checks itself: %2</source>
        <translation>%1 is geschreven. Zo controleert het zichzelf: %2</translation>
    </message>
    <message>
        <source>%1 is written. Without a window: %2</source>
        <translation>%1 is geschreven. Zonder venster: %2</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 exporteren</translation>
    </message>
    <message>
        <source>Picture (*.png);;Vector graphics (*.svg);;Document (*.pdf);;Table (*.csv)</source>
        <translation>Afbeelding (*.png);;Vectorafbeelding (*.svg);;Document (*.pdf);;Tabel (*.csv)</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 is geschreven.</translation>
    </message>
    <message>
        <source>Only files of this machine can be opened.</source>
        <translation>Alleen bestanden op deze machine zijn te openen.</translation>
    </message>
    <message>
        <source>Fo&amp;llow …</source>
        <translation>&amp;Volgen …</translation>
    </message>
    <message>
        <source>Look at results or a checkpoint while another process writes them</source>
        <translation>Bekijk resultaten of een checkpoint terwijl een ander proces ze schrijft</translation>
    </message>
    <message>
        <source>S&amp;top following</source>
        <translation>Volgen s&amp;toppen</translation>
    </message>
    <message>
        <source>What was followed stays, as if it had been opened</source>
        <translation>Wat is gevolgd, blijft staan alsof het was geopend</translation>
    </message>
    <message>
        <source>Go on from here</source>
        <translation>Hier verder</translation>
    </message>
    <message>
        <source>Learn on, as a life of your own; the file is not followed any more</source>
        <translation>Leer verder, als een eigen leven; het bestand wordt niet meer gevolgd</translation>
    </message>
    <message>
        <source>Stop following</source>
        <translation>Stop met volgen</translation>
    </message>
    <message>
        <source>The life stays as it is, as one of your own</source>
        <translation>Het leven blijft zoals het is, als een eigen leven</translation>
    </message>
    <message>
        <source>%1 is not followed any more. This is a life of your own now, not saved yet.</source>
        <translation>%1 wordt niet meer gevolgd. Dit is nu een eigen leven, nog niet opgeslagen.</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Volgen</translation>
    </message>
    <message>
        <source>Results and checkpoints (*.sqlite* *.safetensors *.surefoot *.ckpt);;All files (*)</source>
        <translation>Resultaten en checkpoints (*.sqlite* *.safetensors *.surefoot *.ckpt);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Following %1, read only</source>
        <translation>%1 wordt gevolgd, alleen-lezen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Help</translation>
    </message>
    <message>
        <source>&amp;Handbook</source>
        <translation>&amp;Handboek</translation>
    </message>
    <message>
        <source>The handbook, at the page of what has the focus</source>
        <translation>Het handboek, bij de pagina over wat nu actief is</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>&amp;Sneltoetsen</translation>
    </message>
    <message>
        <source>All shortcuts</source>
        <translation>Alle sneltoetsen</translation>
    </message>
    <message>
        <source>&amp;Words</source>
        <translation>&amp;Begrippen</translation>
    </message>
    <message>
        <source>What the words mean, with their formulas</source>
        <translation>Wat de begrippen betekenen, met hun formules</translation>
    </message>
    <message>
        <source>Write a &amp;lesson</source>
        <translation>&amp;Les schrijven</translation>
    </message>
    <message>
        <source>A lesson of one&apos;s own as text, from a template</source>
        <translation>Een eigen les als tekst, vanuit een sjabloon</translation>
    </message>
    <message>
        <source>&amp;About Surefoot</source>
        <translation>&amp;Over Surefoot</translation>
    </message>
    <message>
        <source>What this is</source>
        <translation>Wat dit is</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>Opnieuw beginnen</translation>
    </message>
    <message>
        <source>This is the lesson&apos;s robot as it is now. The lesson waits on its page, where you were.</source>
        <translation>Dit is de robot van de les zoals hij nu is. De les wacht op haar pagina, waar je was.</translation>
    </message>
    <message>
        <source>It is being made ready; the world goes on meanwhile.</source>
        <translation>Het wordt klaargezet; de wereld gaat intussen door.</translation>
    </message>
    <message>
        <source>The life before is kept: Ctrl+Z brings it back.</source>
        <translation>Het vorige leven is bewaard: Ctrl+Z haalt het terug.</translation>
    </message>
    <message>
        <source>This life is back as it was; the other one is kept for undo and redo.</source>
        <translation>Dit leven is terug zoals het was; het andere is bewaard voor ongedaan maken en opnieuw uitvoeren.</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Opnieuw beginnen</translation>
    </message>
    <message>
        <source>Allow it, and go on</source>
        <translation>Toestaan en doorgaan</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Opnieuw proberen</translation>
    </message>
    <message>
        <source>%1 needs a new table, so learning starts again from the beginning, with the same seed.</source>
        <translation>%1 heeft een nieuwe tabel nodig; het leren begint dus opnieuw vanaf het begin, met dezelfde seed.</translation>
    </message>
    <message>
        <source>%1 = %2 needs a new table. Start again from the beginning, with the same seed, or carry what is learned over into it?</source>
        <translation>%1 = %2 heeft een nieuwe tabel nodig. Opnieuw beginnen met dezelfde seed, of overnemen wat is geleerd?</translation>
    </message>
    <message>
        <source>Carry over</source>
        <translation>Overnemen</translation>
    </message>
    <message>
        <source>There is not enough memory to keep one more life for undo: a life before this one, of %1, is not saved and would end.</source>
        <translation>Er is te weinig geheugen om nog een leven te bewaren voor ongedaan maken: een vorig leven, van %1, is niet opgeslagen en zou eindigen.</translation>
    </message>
    <message>
        <source>Save it first</source>
        <translation>Eerst opslaan</translation>
    </message>
    <message>
        <source>End it</source>
        <translation>Beëindigen</translation>
    </message>
    <message>
        <source>This life has %1, is not saved, and there is not enough memory to keep it for undo.</source>
        <translation>Dit leven heeft %1, is niet opgeslagen, en er is te weinig geheugen om het te bewaren voor ongedaan maken.</translation>
    </message>
    <message>
        <source>untitled session</source>
        <translation>naamloze sessie</translation>
    </message>
    <message>
        <source>Surefoot: the life is complete</source>
        <translation>Surefoot: het leven is voltooid</translation>
    </message>
    <message>
        <source>Surefoot: %1</source>
        <translation>Surefoot: %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 episodes are not saved</source>
        <translation>
            <numerusform>%1 episode is niet opgeslagen</numerusform>
            <numerusform>%1 episodes zijn niet opgeslagen</numerusform>
        </translation>
    </message>
    <message>
        <source>everything is saved</source>
        <translation>alles is opgeslagen</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>A life before this one, of %1,</source>
        <translation>Een vorig leven, van %1,</translation>
    </message>
    <message>
        <source>%1 lives before this one, of %2 episodes,</source>
        <translation>%1 vorige levens, van %2 episodes,</translation>
    </message>
    <message>
        <source>What the second learned in %1 is not saved.</source>
        <translation>Wat de tweede in %1 heeft geleerd, is niet opgeslagen.</translation>
    </message>
    <message>
        <source>%1 kept for Ctrl+Z only, not saved.</source>
        <translation>%1 alleen bewaard voor Ctrl+Z, niet opgeslagen.</translation>
    </message>
    <message>
        <source>What this life learned in %1 is not saved.</source>
        <translation>Wat dit leven in %1 heeft geleerd, is niet opgeslagen.</translation>
    </message>
    <message>
        <source>What the robot of the Live page learned in %1 is not saved.</source>
        <translation>Wat de robot van de pagina Live in %1 heeft geleerd, is niet opgeslagen.</translation>
    </message>
    <message>
        <source>What %1 learned in %2 is not saved.</source>
        <translation>Wat %1 in %2 heeft geleerd, is niet opgeslagen.</translation>
    </message>
    <message>
        <source>%1 kept for Ctrl+Z only.</source>
        <translation>%1 alleen bewaard voor Ctrl+Z.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Don&apos;t save</source>
        <translation>Niet opslaan</translation>
    </message>
    <message>
        <source>Save the second learner&apos;s session</source>
        <translation>Sessie van de tweede leerder opslaan</translation>
    </message>
    <message>
        <source>The session could not be kept for the next start: %1 Closing the window again gives it up.</source>
        <translation>De sessie kon niet worden bewaard voor de volgende start: %1 Sluit je het venster nog eens, dan gaat ze verloren.</translation>
    </message>
    <message>
        <source>The last session can go on where it was closed.</source>
        <translation>De laatste sessie kan verder waar ze werd gesloten.</translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation>Ga ermee verder</translation>
    </message>
    <message>
        <source>Begin anew</source>
        <translation>Begin opnieuw</translation>
    </message>
    <message>
        <source>The last session was not closed. Its last minutes may be missing.</source>
        <translation>De laatste sessie is niet afgesloten. De laatste minuten kunnen ontbreken.</translation>
    </message>
    <message>
        <source>Restore it</source>
        <translation>Herstellen</translation>
    </message>
    <message>
        <source>Forget it</source>
        <translation>Vergeten</translation>
    </message>
    <message>
        <source>It stays where it is: %1.</source>
        <translation>Ze blijft waar ze is: %1.</translation>
    </message>
    <message>
        <source>It is set aside as %1.</source>
        <translation>Ze is apart gezet als %1.</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>S&amp;tap</translation>
    </message>
    <message>
        <source>One step of the paused world</source>
        <translation>Eén stap van de gepauzeerde wereld</translation>
    </message>
    <message>
        <source>Re&amp;start</source>
        <translation>&amp;Opnieuw</translation>
    </message>
    <message>
        <source>&amp;Turbo</source>
        <translation>T&amp;urbo</translation>
    </message>
    <message>
        <source>Learn flat out</source>
        <translation>Leer op volle snelheid</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>S&amp;neller</translation>
    </message>
    <message>
        <source>A notch faster</source>
        <translation>Een tandje sneller</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>&amp;Langzamer</translation>
    </message>
    <message>
        <source>A notch slower</source>
        <translation>Een tandje langzamer</translation>
    </message>
    <message>
        <source>Look &amp;back</source>
        <translation>Teru&amp;gkijken</translation>
    </message>
    <message>
        <source>A frame back in what was shown; with Shift a second</source>
        <translation>Een beeld terug in wat te zien was; met Shift een seconde</translation>
    </message>
    <message>
        <source>Back to &amp;live</source>
        <translation>Terug naar l&amp;ive</translation>
    </message>
    <message>
        <source>Leave the replay and show what happens now</source>
        <translation>Verlaat de herhaling en toon wat er nu gebeurt</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Bestand</translation>
    </message>
    <message>
        <source>&amp;New session in</source>
        <translation>&amp;Nieuwe sessie in</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>&amp;Openen …</translation>
    </message>
    <message>
        <source>Open a session, a Q-function, a journal, a plan or results</source>
        <translation>Open een sessie, een Q-functie, een logboek, een plan of resultaten</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Recent geopend</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Op&amp;slaan</translation>
    </message>
    <message>
        <source>Save the session: it goes on where it was; on the page Robot, the robot</source>
        <translation>Sla de sessie op: ze gaat verder waar ze was; op de pagina Robot: de robot</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Opslaan &amp;als …</translation>
    </message>
    <message>
        <source>Save the session under another name; on the page Robot, the robot</source>
        <translation>Sla de sessie op onder een andere naam; op de pagina Robot: de robot</translation>
    </message>
    <message>
        <source>Save the Q-&amp;function …</source>
        <translation>Q-&amp;functie opslaan …</translation>
    </message>
    <message>
        <source>What was learned, to load it elsewhere</source>
        <translation>Wat is geleerd, om elders te laden</translation>
    </message>
    <message>
        <source>Save the Q-function</source>
        <translation>Q-functie opslaan</translation>
    </message>
    <message>
        <source>Export the policy as &amp;C …</source>
        <translation>Policy exporteren als &amp;C …</translation>
    </message>
    <message>
        <source>The greedy policy as a C99 program that needs nothing else</source>
        <translation>De greedy policy als een C99-programma dat verder niets nodig heeft</translation>
    </message>
    <message>
        <source>Export the policy as C</source>
        <translation>Policy exporteren als C</translation>
    </message>
    <message>
        <source>Save the &amp;journal …</source>
        <translation>&amp;Logboek opslaan …</translation>
    </message>
    <message>
        <source>A small text by which the life can be lived again</source>
        <translation>Een kleine tekst waarmee het leven opnieuw te leven is</translation>
    </message>
    <message>
        <source>Save the journal</source>
        <translation>Logboek opslaan</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exporteren</translation>
    </message>
    <message>
        <source>As PNG, SVG, PDF or CSV</source>
        <translation>Als PNG, SVG, PDF of CSV</translation>
    </message>
    <message>
        <source>World …</source>
        <translation>Wereld …</translation>
    </message>
    <message>
        <source>As PNG, SVG or PDF</source>
        <translation>Als PNG, SVG of PDF</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Wereld</translation>
    </message>
    <message>
        <source>The whole window …</source>
        <translation>Het hele venster …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Afsl&amp;uiten</translation>
    </message>
    <message>
        <source>Leave the program</source>
        <translation>Verlaat het programma</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Be&amp;werken</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ongedaan maken</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Op&amp;nieuw uitvoeren</translation>
    </message>
    <message>
        <source>Take the last change back; bring the life before back</source>
        <translation>Neem de laatste wijziging terug; haal het vorige leven terug</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>Voer de wijziging opnieuw door</translation>
    </message>
    <message>
        <source>Reset all &amp;parameters</source>
        <translation>Alle &amp;parameters herstellen</translation>
    </message>
    <message>
        <source>To what preset and scenario say</source>
        <translation>Naar wat preset en scenario zeggen</translation>
    </message>
    <message>
        <source>Another &amp;seed …</source>
        <translation>Andere &amp;seed …</translation>
    </message>
    <message>
        <source>Begin again with other random numbers</source>
        <translation>Begin opnieuw met andere toevalsgetallen</translation>
    </message>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>&amp;Voorkeuren …</translation>
    </message>
    <message>
        <source>Colours, motion, the start</source>
        <translation>Kleuren, beweging, de start</translation>
    </message>
    <message>
        <source>Restart with an &amp;empty table</source>
        <translation>Opnieuw met l&amp;ege tabel</translation>
    </message>
    <message>
        <source>Start the life again with the same seed, from nothing</source>
        <translation>Begin het leven opnieuw met dezelfde seed, vanaf nul</translation>
    </message>
    <message>
        <source>&amp;Go on from here</source>
        <translation>Hier &amp;verder</translation>
    </message>
    <message>
        <source>The learner&apos;s world is put into the moment that a replay shows; it goes on learning</source>
        <translation>De wereld van de leerder komt in het moment dat een herhaling toont; hij leert daar verder</translation>
    </message>
    <message>
        <source>&amp;What if</source>
        <translation>&amp;Wat als</translation>
    </message>
    <message>
        <source>&amp;Compare with a second learner</source>
        <translation>Vergelijken met tweede leer&amp;der</translation>
    </message>
    <message>
        <source>Another method with the same seed, side by side</source>
        <translation>Een andere methode met dezelfde seed, naast elkaar</translation>
    </message>
    <message>
        <source>The second learner begins now. For a fair race, begin the first again, too?</source>
        <translation>De tweede leerder begint nu. Ook de eerste opnieuw beginnen, voor een eerlijke vergelijking?</translation>
    </message>
    <message>
        <source>Begin both again</source>
        <translation>Beide opnieuw beginnen</translation>
    </message>
    <message>
        <source>&amp;Pre-learn, then transfer …</source>
        <translation>Vooraf leren, dan overdr&amp;agen …</translation>
    </message>
    <message>
        <source>Learn in a simulation, then live in reality with what was learned</source>
        <translation>Leer in een simulatie en leef dan in werkelijkheid met wat is geleerd</translation>
    </message>
    <message>
        <source>R&amp;oll out 25 s</source>
        <translation>&amp;Rollout 25 s</translation>
    </message>
    <message>
        <source>What the greedy policy does from a new start, learning nothing</source>
        <translation>Wat de greedy policy doet vanaf een nieuw begin, zonder te leren</translation>
    </message>
    <message>
        <source>Rob&amp;ustness …</source>
        <translation>Ro&amp;buustheid …</translation>
    </message>
    <message>
        <source>How often what was learned falls, over pushes and models</source>
        <translation>Hoe vaak hij valt met wat is geleerd, bij verschillende duwen en modellen</translation>
    </message>
    <message>
        <source>E&amp;xperiment</source>
        <translation>E&amp;xperiment</translation>
    </message>
    <message>
        <source>&amp;Open a plan or results …</source>
        <translation>Plan of resultaten &amp;openen …</translation>
    </message>
    <message>
        <source>A plan, a recipe or a store of results</source>
        <translation>Een plan, een recept of een bestand met resultaten</translation>
    </message>
    <message>
        <source>Save the &amp;plan as …</source>
        <translation>&amp;Plan opslaan als …</translation>
    </message>
    <message>
        <source>The plan as a file</source>
        <translation>Het plan als bestand</translation>
    </message>
    <message>
        <source>&amp;Run or pause</source>
        <translation>&amp;Starten of pauzeren</translation>
    </message>
    <message>
        <source>Run the experiment, or pause it</source>
        <translation>Start of pauzeer het experiment</translation>
    </message>
    <message>
        <source>Start &amp;again</source>
        <translation>Opnie&amp;uw beginnen</translation>
    </message>
    <message>
        <source>Forget what was lived</source>
        <translation>Vergeet wat is geleefd</translation>
    </message>
    <message>
        <source>&amp;Copy the table as CSV</source>
        <translation>Tabel kopiëren als &amp;CSV</translation>
    </message>
    <message>
        <source>To the clipboard</source>
        <translation>Naar het klembord</translation>
    </message>
    <message>
        <source>Copy the table as &amp;LaTeX</source>
        <translation>Tabel kopiëren als &amp;LaTeX</translation>
    </message>
    <message>
        <source>E&amp;xport all lives as CSV …</source>
        <translation>Alle levens e&amp;xporteren als CSV …</translation>
    </message>
    <message>
        <source>Conditions, lives and episodes</source>
        <translation>Condities, levens en episodes</translation>
    </message>
    <message>
        <source>Export all lives for a &amp;spreadsheet …</source>
        <translation>Alle levens exporteren als &amp;rekenblad …</translation>
    </message>
    <message>
        <source>The same, as Excel reads it</source>
        <translation>Hetzelfde, zoals Excel het leest</translation>
    </message>
    <message>
        <source>Export all c&amp;harts …</source>
        <translation>Alle &amp;grafieken exporteren …</translation>
    </message>
    <message>
        <source>PNG, PDF and CSV</source>
        <translation>PNG, PDF en CSV</translation>
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
        <translation>Lessen</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>&amp;Nothing else: the same again</source>
        <translation>&amp;Niets anders: nog eens hetzelfde</translation>
    </message>
    <message>
        <source>Another policy</source>
        <translation>Andere policy</translation>
    </message>
    <message>
        <source>Another learning rule</source>
        <translation>Andere leerregel</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Bee&amp;ld</translation>
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
        <translation>Le&amp;ssen</translation>
    </message>
    <message>
        <source>&amp;Robot</source>
        <translation>&amp;Robot</translation>
    </message>
    <message>
        <source>The page %1</source>
        <translation>De pagina %1</translation>
    </message>
    <message>
        <source>La&amp;youts</source>
        <translation>&amp;Indelingen</translation>
    </message>
    <message>
        <source>&amp;Usual</source>
        <translation>St&amp;andaard</translation>
    </message>
    <message>
        <source>Every panel back in its place</source>
        <translation>Elk paneel terug op zijn plaats</translation>
    </message>
    <message>
        <source>&amp;Teaching</source>
        <translation>&amp;Lesgeven</translation>
    </message>
    <message>
        <source>What a step teaches, and the rule of thumb</source>
        <translation>Wat van een stap wordt geleerd, en de vuistregel</translation>
    </message>
    <message>
        <source>&amp;Falls</source>
        <translation>&amp;Valpartijen</translation>
    </message>
    <message>
        <source>The list of falls beside the charts</source>
        <translation>De lijst van valpartijen naast de grafieken</translation>
    </message>
    <message>
        <source>&amp;Maps</source>
        <translation>&amp;Kaarten</translation>
    </message>
    <message>
        <source>The value maps large</source>
        <translation>De waardekaarten groot</translation>
    </message>
    <message>
        <source>&amp;Signals</source>
        <translation>&amp;Signalen</translation>
    </message>
    <message>
        <source>How the robot moves: strip charts, phase portrait, strides</source>
        <translation>Hoe de robot beweegt: stroken, faseportret, schreden</translation>
    </message>
    <message>
        <source>&amp;Keep this one as …</source>
        <translation>&amp;Bewaren als …</translation>
    </message>
    <message>
        <source>The panels as they are now, under a name</source>
        <translation>De panelen zoals ze nu staan, onder een naam</translation>
    </message>
    <message>
        <source>&amp;My own</source>
        <translation>&amp;Eigen</translation>
    </message>
    <message>
        <source>&amp;Fit the world</source>
        <translation>Wereld &amp;passend</translation>
    </message>
    <message>
        <source>The zoom that shows the whole world</source>
        <translation>De zoom die de hele wereld toont</translation>
    </message>
    <message>
        <source>Fil&amp;m …</source>
        <translation>Fil&amp;m …</translation>
    </message>
    <message>
        <source>The last minutes, or a replay, as a film</source>
        <translation>De laatste minuten, of een herhaling, als film</translation>
    </message>
    <message>
        <source>Colours of the &amp;system</source>
        <translation>&amp;Kleuren van het systeem</translation>
    </message>
    <message>
        <source>L&amp;ight</source>
        <translation>Li&amp;cht</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Donker</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Volledig scherm</translation>
    </message>
    <message>
        <source>The whole screen</source>
        <translation>Het hele scherm</translation>
    </message>
    <message>
        <source>&amp;Projector</source>
        <translation>Pro&amp;jector</translation>
    </message>
    <message>
        <source>Everything as large as the last row of a lecture room needs it</source>
        <translation>Alles zo groot als de achterste rij van een collegezaal nodig heeft</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>&amp;Tekstgrootte</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>G&amp;roter</translation>
    </message>
    <message>
        <source>Larger text, controls and drawings</source>
        <translation>Grotere tekst, knoppen en tekeningen</translation>
    </message>
    <message>
        <source>&amp;Smaller</source>
        <translation>&amp;Kleiner</translation>
    </message>
    <message>
        <source>Smaller text, controls and drawings</source>
        <translation>Kleinere tekst, knoppen en tekeningen</translation>
    </message>
    <message>
        <source>Text, controls and drawings in their usual size</source>
        <translation>Tekst, knoppen en tekeningen op standaardgrootte</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Everything at %1 %</source>
        <translation>Alles op %1 %</translation>
    </message>
    <message>
        <source>Keep this layout</source>
        <translation>Indeling bewaren</translation>
    </message>
    <message>
        <source>Its name:</source>
        <translation>Naam:</translation>
    </message>
    <message>
        <source>The name of a layout has 1 to %1 characters.</source>
        <translation>De naam van een indeling heeft 1 tot %1 tekens.</translation>
    </message>
    <message>
        <source>%1 layouts are kept already; forget one first.</source>
        <translation>Er zijn al %1 indelingen bewaard; vergeet er eerst een.</translation>
    </message>
    <message>
        <source>Kept as &quot;%1&quot;, in the menu View, Layouts, My own.</source>
        <translation>Bewaard als “%1”, in het menu Beeld, Indelingen, Eigen.</translation>
    </message>
    <message>
        <source>The layout &quot;%1&quot; is one of another version; keep it anew.</source>
        <translation>De indeling “%1” hoort bij een andere versie; bewaar haar opnieuw.</translation>
    </message>
    <message>
        <source>None kept yet</source>
        <translation>Nog geen bewaard</translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation>&amp;Vergeten</translation>
    </message>
    <message>
        <source>Surefoot crashed. A report of it is on this computer; nothing was sent.</source>
        <translation>Surefoot is gecrasht. Er staat een verslag van op deze computer; er is niets verzonden.</translation>
    </message>
    <message>
        <source>Show the report</source>
        <translation>Verslag tonen</translation>
    </message>
    <message>
        <source>Leave it there</source>
        <translation>Laten staan</translation>
    </message>
    <message>
        <source>There is no report of a crash.</source>
        <translation>Er is geen verslag van een crash.</translation>
    </message>
    <message>
        <source>&amp;Report of the last crash</source>
        <translation>Verslag van de laatste &amp;crash</translation>
    </message>
    <message>
        <source>What Surefoot noted when it crashed, to be sent by hand</source>
        <translation>Wat Surefoot bij de crash noteerde, om zelf te versturen</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Nu niet</translation>
    </message>
</context>
<context>
    <name>surefoot::MapBar</name>
    <message>
        <source>Quantity</source>
        <translation>Grootheid</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Assen</translation>
    </message>
    <message>
        <source>Other variables</source>
        <translation>Andere variabelen</translation>
    </message>
    <message>
        <source>Range of the colours</source>
        <translation>Bereik van de kleuren</translation>
    </message>
    <message>
        <source>What the map shows</source>
        <translation>Wat de kaart toont</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Kaart</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>vast</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Horizontaal</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Verticaal</translation>
    </message>
    <message>
        <source>Follow the live state</source>
        <translation>Volg de live toestand</translation>
    </message>
    <message>
        <source>Fix where it is now</source>
        <translation>Zet vast waar hij nu is</translation>
    </message>
    <message>
        <source>Fixed %1</source>
        <translation>%1 vast</translation>
    </message>
    <message>
        <source>Mean over it</source>
        <translation>Gemiddelde erover</translation>
    </message>
    <message>
        <source>Least over it</source>
        <translation>Laagste erover</translation>
    </message>
    <message>
        <source>Most over it</source>
        <translation>Hoogste erover</translation>
    </message>
    <message>
        <source>Locked to what rewards allow</source>
        <translation>Vast op wat beloningen toelaten</translation>
    </message>
    <message>
        <source>What the map shows now</source>
        <translation>Wat de kaart nu toont</translation>
    </message>
</context>
<context>
    <name>surefoot::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
</context>
<context>
    <name>surefoot::ModelRows</name>
    <message>
        <source>Simulation and reality are alike. Add what is to differ.</source>
        <translation>Simulatie en werkelijkheid zijn gelijk. Voeg toe wat moet verschillen.</translation>
    </message>
    <message>
        <source>Add a parameter that differs</source>
        <translation>Voeg een parameter toe die verschilt</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulatie</translation>
    </message>
    <message>
        <source>Reality</source>
        <translation>Werkelijkheid</translation>
    </message>
    <message>
        <source>Add a parameter that differs …</source>
        <translation>Parameter toevoegen die verschilt …</translation>
    </message>
    <message>
        <source>Allowed: %1</source>
        <translation>Toegestaan: %1</translation>
    </message>
    <message>
        <source>in simulation</source>
        <translation>in simulatie</translation>
    </message>
    <message>
        <source>in reality</source>
        <translation>in werkelijkheid</translation>
    </message>
</context>
<context>
    <name>surefoot::NumberBox</name>
    <message>
        <source>Work it out</source>
        <translation>Reken het uit</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Controleer</translation>
    </message>
    <message>
        <source>Type a number, such as −4.5.</source>
        <translation>Typ een getal, zoals −4.5.</translation>
    </message>
</context>
<context>
    <name>surefoot::OptionsBox</name>
    <message>
        <source>Check</source>
        <translation>Controleer</translation>
    </message>
</context>
<context>
    <name>surefoot::OrderBox</name>
    <message>
        <source>Put them in order</source>
        <translation>Zet in de juiste volgorde</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Controleer</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Omhoog</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Omlaag</translation>
    </message>
    <message>
        <source>the first on top; drag one, or Alt+↑ and Alt+↓</source>
        <translation>de eerste bovenaan; slepen, of Alt+↑ en Alt+↓</translation>
    </message>
</context>
<context>
    <name>surefoot::PanelHeader</name>
    <message>
        <source>Close %1; the View menu brings it back</source>
        <translation>Sluit %1; het menu Beeld haalt het terug</translation>
    </message>
    <message>
        <source>Back to all panels</source>
        <translation>Terug naar alle panelen</translation>
    </message>
    <message>
        <source>Give %1 the whole window</source>
        <translation>Geef %1 het hele venster</translation>
    </message>
</context>
<context>
    <name>surefoot::PanelRow</name>
    <message>
        <source>Full size</source>
        <translation>Volle grootte</translation>
    </message>
    <message>
        <source>Panels that share this place</source>
        <translation>Panelen die deze plaats delen</translation>
    </message>
</context>
<context>
    <name>surefoot::ParameterForm</name>
    <message>
        <source>new table</source>
        <translation>nieuwe tabel</translation>
    </message>
    <message>
        <source>next episode</source>
        <translation>volgende episode</translation>
    </message>
    <message>
        <source>not with the others</source>
        <translation>past niet bij de rest</translation>
    </message>
    <message>
        <source>The guardian&apos;s Q-function</source>
        <translation>De Q-functie van de bewaker</translation>
    </message>
    <message>
        <source>Q-functions (*.safetensors *.surefoot);;All files (*)</source>
        <translation>Q-functies (*.safetensors *.surefoot);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>all parameters</source>
        <translation>alle parameters</translation>
    </message>
</context>
<context>
    <name>surefoot::ParameterRow</name>
    <message>
        <source>%1, number</source>
        <translation>%1, getal</translation>
    </message>
    <message>
        <source>Set at step %1; Reset goes back to %2.</source>
        <translation>Gewijzigd bij stap %1; Herstel gaat terug naar %2.</translation>
    </message>
    <message>
        <source>Changed; Reset goes back to %1.</source>
        <translation>Gewijzigd; Herstel gaat terug naar %1.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 tot %2</translation>
    </message>
    <message>
        <source> or </source>
        <translation> of </translation>
    </message>
    <message>
        <source>no number</source>
        <translation>geen getal</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>een geheel getal</translation>
    </message>
    <message>
        <source>Reset %1 to its default</source>
        <translation>%1 terug naar standaard</translation>
    </message>
</context>
<context>
    <name>surefoot::PhasePortrait</name>
    <message>
        <source>Phase portrait</source>
        <translation>Faseportret</translation>
    </message>
    <message>
        <source>Two signals against each other</source>
        <translation>Twee signalen tegen elkaar</translation>
    </message>
    <message>
        <source>the marked stride</source>
        <translation>de gemarkeerde schrede</translation>
    </message>
    <message>
        <source>last cycle</source>
        <translation>laatste cyclus</translation>
    </message>
    <message>
        <source>last stride</source>
        <translation>laatste schrede</translation>
    </message>
    <message>
        <source>all that is shown</source>
        <translation>alles wat te zien is</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signalen</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Horizontaal</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Verticaal</translation>
    </message>
</context>
<context>
    <name>surefoot::PlanChooser</name>
    <message>
        <source>What to run: plans, the thesis&apos;s figures, your own files</source>
        <translation>Wat te doen: plannen, figuren van de scriptie, eigen bestanden</translation>
    </message>
    <message>
        <source>Choose a plan</source>
        <translation>Kies een plan</translation>
    </message>
    <message>
        <source>Your own files</source>
        <translation>Eigen bestanden</translation>
    </message>
    <message>
        <source>Search the experiments</source>
        <translation>Zoek in de experimenten</translation>
    </message>
    <message>
        <source>Search: a figure&apos;s number, a word</source>
        <translation>Zoek: nummer van een figuur, een woord</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>Experimenten</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Figuur</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Duur</translation>
    </message>
    <message>
        <source>Open a plan or results …</source>
        <translation>Plan of resultaten openen …</translation>
    </message>
    <message>
        <source>Plans</source>
        <translation>Plannen</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>ongeveer %1</translation>
    </message>
    <message>
        <source>Nothing is called that.</source>
        <translation>Niets heet zo.</translation>
    </message>
</context>
<context>
    <name>surefoot::PlanEditor</name>
    <message>
        <source>Use this plan</source>
        <translation>Dit plan gebruiken</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Add what the Live page runs</source>
        <translation>Voeg toe wat op Live loopt</translation>
    </message>
    <message>
        <source>A new condition; it begins as the first one</source>
        <translation>Een nieuwe conditie; ze begint als de eerste</translation>
    </message>
    <message>
        <source>Add the condition</source>
        <translation>Conditie toevoegen</translation>
    </message>
    <message>
        <source>It is not added: %1</source>
        <translation>Niet toegevoegd: %1</translation>
    </message>
    <message>
        <source>The plan was changed meanwhile; add it again.</source>
        <translation>Het plan is intussen gewijzigd; voeg nog eens toe.</translation>
    </message>
    <message numerus="yes">
        <source>%n conditions</source>
        <translation>
            <numerusform>%n conditie</numerusform>
            <numerusform>%n condities</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 each</source>
        <translation>, elk %1</translation>
    </message>
    <message>
        <source>It is being checked …</source>
        <translation>Wordt gecontroleerd …</translation>
    </message>
</context>
<context>
    <name>surefoot::PointBox</name>
    <message>
        <source>Point at it</source>
        <translation>Wijs aan</translation>
    </message>
    <message>
        <source>a click on the map answers; on the map, arrows move the cursor and Enter answers</source>
        <translation>een klik op de kaart is je antwoord; op de kaart verplaatsen pijltjes de cursor en antwoordt Enter</translation>
    </message>
    <message>
        <source>a click on its mark answers</source>
        <translation>een klik op het streepje is je antwoord</translation>
    </message>
</context>
<context>
    <name>surefoot::PreLearningDialog</name>
    <message>
        <source>Pre-learn, then transfer</source>
        <translation>Vooraf leren, dan overdragen</translation>
    </message>
    <message>
        <source>Scenario of the simulation</source>
        <translation>Scenario van de simulatie</translation>
    </message>
    <message>
        <source>a model of your own</source>
        <translation>een eigen model</translation>
    </message>
    <message>
        <source>The simulation is scenario</source>
        <translation>De simulatie is scenario</translation>
    </message>
    <message>
        <source>Average reward that ends the pre-learning</source>
        <translation>Gemiddelde beloning waarbij het vooraf leren stopt</translation>
    </message>
    <message>
        <source>Q-functions to learn</source>
        <translation>Te leren Q-functies</translation>
    </message>
    <message>
        <source>ε-greedy, until the average reward is</source>
        <translation>ε-greedy, tot de gemiddelde beloning is</translation>
    </message>
    <message>
        <source>%1 has converged, %2 has not</source>
        <translation>%1 is geconvergeerd, %2 niet</translation>
    </message>
    <message>
        <source>or, left empty, for %1 simulated min</source>
        <translation>of, als dit leeg is, %1 gesimuleerde min</translation>
    </message>
    <message>
        <source>or, left empty, for %1</source>
        <translation>of, als dit leeg is, %1</translation>
    </message>
    <message>
        <source>Q-functions in the pool</source>
        <translation>Q-functies in de pool</translation>
    </message>
    <message>
        <source>The pool</source>
        <translation>De pool</translation>
    </message>
    <message>
        <source>Q-function</source>
        <translation>Q-functie</translation>
    </message>
    <message>
        <source>episodes</source>
        <translation>episodes</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>vallen</translation>
    </message>
    <message>
        <source>average reward</source>
        <translation>gemiddelde beloning</translation>
    </message>
    <message>
        <source>Begin a life in reality with it</source>
        <translation>Begin er een leven in werkelijkheid mee</translation>
    </message>
    <message>
        <source>Average reward</source>
        <translation>Gemiddelde beloning</translation>
    </message>
    <message>
        <source>A life has begun with Q-function %1: %2 episodes and %3 falls of simulation are behind it.</source>
        <translation>Een leven is begonnen met Q-functie %1, na %2 episodes en %3 valpartijen in simulatie.</translation>
    </message>
    <message>
        <source> (not reached)</source>
        <translation> (niet gehaald)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>Pre-learn</source>
        <translation>Vooraf leren</translation>
    </message>
    <message>
        <source>This environment&apos;s model has nothing to be wrong about; what is learned is carried over as it is.</source>
        <translation>In het model van deze omgeving kan niets fout zijn; wat is geleerd, wordt overgenomen zoals het is.</translation>
    </message>
    <message>
        <source>%1 of %2 are learned. The world goes on meanwhile.</source>
        <translation>%1 van %2 zijn geleerd. De wereld gaat intussen door.</translation>
    </message>
    <message>
        <source>The pool appears here: learn on the simulation, then choose one and begin a life in reality with it.</source>
        <translation>Hier verschijnt de pool: leer in de simulatie, kies er dan een en begin daarmee een leven in werkelijkheid.</translation>
    </message>
    <message>
        <source>Choose one, and begin a life in reality with it.</source>
        <translation>Kies er een en begin daarmee een leven in werkelijkheid.</translation>
    </message>
</context>
<context>
    <name>surefoot::PredictionBox</name>
    <message>
        <source>Your prediction</source>
        <translation>Je voorspelling</translation>
    </message>
    <message>
        <source>The same as a slider</source>
        <translation>Hetzelfde als schuif</translation>
    </message>
    <message>
        <source>%1 to %2; type it, or drag the mark. Once given it stays. Wrong is fine.</source>
        <translation>%1 tot %2; typ het, of sleep het merkteken. Eenmaal gegeven staat het vast. Fout is niet erg.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>You said %1</source>
        <translation>Je zei %1</translation>
    </message>
    <message>
        <source>Commit to %1</source>
        <translation>Leg %1 vast</translation>
    </message>
</context>
<context>
    <name>surefoot::PredictionResult</name>
    <message>
        <source>You said</source>
        <translation>Je zei</translation>
    </message>
    <message>
        <source>and it came to</source>
        <translation>en het werd</translation>
    </message>
    <message>
        <source>Very close.</source>
        <translation>Heel dichtbij.</translation>
    </message>
    <message>
        <source>%1 more than you said.</source>
        <translation>%1 meer dan je zei.</translation>
    </message>
    <message>
        <source>%1 fewer than you said.</source>
        <translation>%1 minder dan je zei.</translation>
    </message>
    <message>
        <source>You said %1. It came to %2 %3. %4</source>
        <translation>Je zei %1. Het werd %2 %3. %4</translation>
    </message>
</context>
<context>
    <name>surefoot::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Voorkeuren</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Kleuren</translation>
    </message>
    <message>
        <source>those of the system</source>
        <translation>die van het systeem</translation>
    </message>
    <message>
        <source>light</source>
        <translation>licht</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>donker</translation>
    </message>
    <message>
        <source>Colours: %1</source>
        <translation>Kleuren: %1</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Taal</translation>
    </message>
    <message>
        <source>that of the system</source>
        <translation>die van het systeem</translation>
    </message>
    <message>
        <source>From the next start on. Most sentences about errors are English.</source>
        <translation>Vanaf de volgende start. De meeste zinnen over fouten zijn Engels.</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Tekstgrootte</translation>
    </message>
    <message>
        <source>160 %: projector</source>
        <translation>160 %: projector</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Beweging</translation>
    </message>
    <message>
        <source>less of it: no trail, no flash, a camera that stands,
falls shown frame by frame</source>
        <translation>minder: geen spoor, geen flits, een stilstaande camera,
valpartijen beeld voor beeld</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Bij de start</translation>
    </message>
    <message>
        <source>learn as soon as the window is open</source>
        <translation>leren zodra het venster open is</translation>
    </message>
    <message>
        <source>Safety copy</source>
        <translation>Reservekopie</translation>
    </message>
    <message>
        <source>every </source>
        <translation>elke </translation>
    </message>
    <message>
        <source> min; a crash loses no more</source>
        <translation> min; een crash kost niet meer</translation>
    </message>
    <message>
        <source>Minutes between two copies of the session on the disk</source>
        <translation>Minuten tussen twee kopieën van de sessie op de schijf</translation>
    </message>
</context>
<context>
    <name>surefoot::QuestionBox</name>
    <message>
        <source>✓ Right.</source>
        <translation>✓ Goed.</translation>
    </message>
    <message>
        <source>✓ Right. %1</source>
        <translation>✓ Goed. %1</translation>
    </message>
    <message>
        <source>Not yet. %1</source>
        <translation>Nog niet. %1</translation>
    </message>
</context>
<context>
    <name>surefoot::RandomLife</name>
    <message>
        <source>What a random life looks like</source>
        <translation>Zo ziet een willekeurig leven eruit</translation>
    </message>
    <message numerus="yes">
        <source>%n falls; %1</source>
        <translation>
            <numerusform>%n val; %1</numerusform>
            <numerusform>%n valpartijen; %1</numerusform>
        </translation>
    </message>
    <message>
        <source>steps; %1 s in all</source>
        <translation>stappen; %1 s in totaal</translation>
    </message>
    <message>
        <source>Falls in %1 steps</source>
        <translation>Valpartijen in %1 stappen</translation>
    </message>
    <message>
        <source>To a fall, median</source>
        <translation>Tot een val, mediaan</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>Langste</translation>
    </message>
    <message>
        <source>At a limit of %1</source>
        <translation>Grens %1</translation>
    </message>
    <message>
        <source> % of steps</source>
        <translation> % van stappen</translation>
    </message>
</context>
<context>
    <name>surefoot::Rival</name>
    <message>
        <source>World of the second</source>
        <translation>Wereld van de tweede</translation>
    </message>
    <message>
        <source>The second cannot have the same start (%1): its tables differ. It begins empty.</source>
        <translation>De tweede kan niet hetzelfde beginnen (%1): zijn tabellen verschillen. Hij begint leeg.</translation>
    </message>
    <message>
        <source>%1: the second starts again from the beginning, and what it learned in %2 is given up.</source>
        <translation>%1: de tweede begint helemaal opnieuw, en wat hij in %2 heeft geleerd, gaat verloren.</translation>
    </message>
    <message>
        <source>Another learning rule needs a new table</source>
        <translation>Een andere leerregel heeft een nieuwe tabel nodig</translation>
    </message>
    <message>
        <source>Another start</source>
        <translation>Een ander begin</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Wat als</translation>
    </message>
    <message>
        <source>Parameters of the second</source>
        <translation>Parameters van de tweede</translation>
    </message>
    <message>
        <source>%1 = %2 needs a new table: the second starts again from the beginning.</source>
        <translation>%1 = %2 heeft een nieuwe tabel nodig: de tweede begint helemaal opnieuw.</translation>
    </message>
</context>
<context>
    <name>surefoot::RobotPage</name>
    <message>
        <source>%1 was saved by another program, and is shown as it is now; undo brings back what was here.</source>
        <translation>%1 is door een ander programma opgeslagen en staat hier zoals het nu is; ongedaan maken haalt terug wat hier stond.</translation>
    </message>
    <message>
        <source>What was not saved of %1 is here again.</source>
        <translation>Wat van %1 niet was opgeslagen, staat er weer.</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>Robot: %1</translation>
    </message>
    <message>
        <source>changed, not saved</source>
        <translation>gewijzigd, niet opgeslagen</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>nog niet opgeslagen</translation>
    </message>
    <message>
        <source>picture and table: as of the last text without an error</source>
        <translation>beeld en tabel: volgens de laatste tekst zonder fout</translation>
    </message>
    <message>
        <source>picture and table come when the text has no error</source>
        <translation>beeld en tabel komen als de tekst geen fout heeft</translation>
    </message>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n fout</numerusform>
            <numerusform>%n fouten</numerusform>
        </translation>
    </message>
    <message>
        <source>F8 the next error, Alt+Enter mends it</source>
        <translation>F8: volgende fout, Alt+Enter herstelt die</translation>
    </message>
    <message>
        <source>F8 the next error</source>
        <translation>F8: volgende fout</translation>
    </message>
    <message numerus="yes">
        <source>%n lines; F1 says what the word at the caret means</source>
        <translation>
            <numerusform>%n regel; F1 zegt wat het woord bij de cursor betekent</numerusform>
            <numerusform>%n regels; F1 zegt wat het woord bij de cursor betekent</numerusform>
        </translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>regel %1: %2</translation>
    </message>
    <message>
        <source> (and %1 more)</source>
        <translation> (en nog %1)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Probeer</translation>
    </message>
    <message>
        <source>names and limits under the pointer; a click goes to the line</source>
        <translation>namen en grenzen onder de muis; een klik gaat naar de regel</translation>
    </message>
    <message>
        <source>a robot that is not saved yet</source>
        <translation>een robot die nog niet is opgeslagen</translation>
    </message>
    <message>
        <source>%1 tiles a tiling</source>
        <translation>%1 tegels per betegeling</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Openen…</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Opslaan als…</translation>
    </message>
    <message>
        <source>A new robot, like</source>
        <translation>Nieuwe robot, zoals</translation>
    </message>
    <message>
        <source>Open a robot</source>
        <translation>Robot openen</translation>
    </message>
    <message>
        <source>Robots (*.toml)</source>
        <translation>Robots (*.toml)</translation>
    </message>
    <message>
        <source>starts %1</source>
        <translation>start %1</translation>
    </message>
    <message>
        <source>TOML, checked while you type; runs nothing</source>
        <translation>TOML, tijdens het typen gecontroleerd; voert niets uit</translation>
    </message>
    <message>
        <source>A program moves it: let it learn, and it moves on the Live page.</source>
        <translation>Een programma beweegt hem: laat hem leren, dan beweegt hij op de pagina Live.</translation>
    </message>
    <message>
        <source>Nothing is known of this word.</source>
        <translation>Over dit woord is niets bekend.</translation>
    </message>
    <message>
        <source>line %1 comes to %2 at the start of an episode</source>
        <translation>regel %1 geeft %2 aan het begin van een episode</translation>
    </message>
    <message>
        <source>What was not saved of %1 is in %2; undo brings it back, too.</source>
        <translation>Wat van %1 niet was opgeslagen, staat in %2; ook ongedaan maken haalt het terug.</translation>
    </message>
    <message>
        <source>a new robot</source>
        <translation>een nieuwe robot</translation>
    </message>
    <message>
        <source>Save the robot</source>
        <translation>Robot opslaan</translation>
    </message>
    <message>
        <source>Allow it to start</source>
        <translation>Starten toestaan</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Let it learn</source>
        <translation>Laten leren</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschrijving</translation>
    </message>
    <message>
        <source>Find; Return: the next one, Escape: done</source>
        <translation>Zoeken; Enter: het volgende, Escape: klaar</translation>
    </message>
    <message>
        <source>Find in the description</source>
        <translation>Zoek in de beschrijving</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Wereld</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Willekeurig</translation>
    </message>
    <message>
        <source>Motors off</source>
        <translation>Motoren uit</translation>
    </message>
    <message>
        <source>Passive</source>
        <translation>Passief</translation>
    </message>
    <message>
        <source>Left to itself: no motors, dampers, friction and contacts. What moves less and less then loses its energy to the size of the substeps.</source>
        <translation>Aan zichzelf overgelaten: geen motoren, dempers, wrijving en contacten. Wat dan steeds minder beweegt, verliest zijn energie aan de grootte van de deelstappen.</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Laat vallen</translation>
    </message>
    <message>
        <source>As it is drawn, from 20 cm above the ground, motors off</source>
        <translation>Zoals getekend, van 20 cm boven de grond, motoren uit</translation>
    </message>
    <message>
        <source>Hand-made</source>
        <translation>Vaste regelaar</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Toestand</translation>
    </message>
    <message>
        <source>What a random life looks like</source>
        <translation>Zo ziet een willekeurig leven eruit</translation>
    </message>
    <message>
        <source>a click on a mark shows the fall</source>
        <translation>een klik op een streepje toont de val</translation>
    </message>
    <message>
        <source>seen in %1 random steps</source>
        <translation>gezien in %1 willekeurige stappen</translation>
    </message>
</context>
<context>
    <name>surefoot::RobotPicture</name>
    <message>
        <source>The robot</source>
        <translation>De robot</translation>
    </message>
    <message>
        <source>%1°, limit, line %2</source>
        <translation>%1°, grens, regel %2</translation>
    </message>
</context>
<context>
    <name>surefoot::RobotText</name>
    <message>
        <source>Description of the robot</source>
        <translation>Beschrijving van de robot</translation>
    </message>
    <message>
        <source>Write “%1”</source>
        <translation>Schrijf “%1”</translation>
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
        <translation>een val uit het willekeurige leven</translation>
    </message>
    <message>
        <source>keys 1 … %1: %2; ← → push</source>
        <translation>toetsen 1 … %1: %2; ← → duwen</translation>
    </message>
    <message>
        <source>keys 1 … %1: the next level of each motor; ← → push</source>
        <translation>toetsen 1 … %1: het volgende niveau van elke motor; ← → duwen</translation>
    </message>
</context>
<context>
    <name>surefoot::RobustnessDialog</name>
    <message>
        <source>Robustness</source>
        <translation>Robuustheid</translation>
    </message>
    <message>
        <source>The map is there: %1 models, %2 pushes. The arrow keys choose a cell.</source>
        <translation>De kaart is er: %1 modellen, %2 duwen. Kies een cel met de pijltjestoetsen.</translation>
    </message>
    <message>
        <source>The command that gives the same numbers</source>
        <translation>De opdracht die dezelfde getallen geeft</translation>
    </message>
    <message>
        <source>Copy the command</source>
        <translation>Opdracht kopiëren</translation>
    </message>
    <message>
        <source>The command is copied.</source>
        <translation>De opdracht is gekopieerd.</translation>
    </message>
    <message>
        <source>Save what was tried …</source>
        <translation>Opslaan wat is getest …</translation>
    </message>
    <message>
        <source>Export the map …</source>
        <translation>Kaart exporteren …</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Stopped; nothing came out.</source>
        <translation>Gestopt; er is niets uitgekomen.</translation>
    </message>
    <message>
        <source>Another environment is learned in now; close this window and open it again.</source>
        <translation>Er wordt nu in een andere omgeving geleerd; sluit dit venster en open het opnieuw.</translation>
    </message>
    <message>
        <source>Save the Q-function that was tried</source>
        <translation>Geteste Q-functie opslaan</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 is geschreven.</translation>
    </message>
    <message>
        <source>Export the map</source>
        <translation>Kaart exporteren</translation>
    </message>
    <message>
        <source>Picture (*.png);;Vector graphics (*.svg);;Document (*.pdf);;Table (*.csv)</source>
        <translation>Afbeelding (*.png);;Vectorafbeelding (*.svg);;Document (*.pdf);;Tabel (*.csv)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>%1 % is done. The life goes on meanwhile.</source>
        <translation>%1 % is klaar. Het leven gaat intussen door.</translation>
    </message>
    <message>
        <source>The mouse or the arrow keys choose a cell.</source>
        <translation>Kies een cel met de muis of de pijltjestoetsen.</translation>
    </message>
    <message>
        <source>Every cell is tried from the same starts: it lives, is pushed once, and is followed.</source>
        <translation>Elke cel wordt vanuit dezelfde starts getest: leven, één duw, en kijken wat volgt.</translation>
    </message>
    <message>
        <source>Without a window, once what was tried is saved as %1:
</source>
        <translation>Zonder venster, als het geteste is opgeslagen als %1:
</translation>
    </message>
    <message>
        <source>Without a window:
</source>
        <translation>Zonder venster:
</translation>
    </message>
</context>
<context>
    <name>surefoot::RobustnessForm</name>
    <message>
        <source>Pushes, N s</source>
        <translation>Duwen, N s</translation>
    </message>
    <message>
        <source>Pushes in newton seconds</source>
        <translation>Duwen in newtonseconde</translation>
    </message>
    <message>
        <source>Impulses: a list, 0;0.05;0.1, or a range, 0..0.2:9, nine from 0 to 0.2. Negative ones push to the left.</source>
        <translation>Stoten: een lijst, 0;0.05;0.1, of een bereik, 0..0.2:9, negen van 0 tot 0.2. Negatieve duwen naar links.</translation>
    </message>
    <message>
        <source>pushed at, s</source>
        <translation>duw op, s</translation>
    </message>
    <message>
        <source>Time of the push in seconds</source>
        <translation>Tijdstip van de duw in seconden</translation>
    </message>
    <message>
        <source>A time, or two with .. between them: every start draws its own between these.</source>
        <translation>Een tijdstip, of twee met .. ertussen: elke start loot het zijne daartussen.</translation>
    </message>
    <message>
        <source>followed for, s</source>
        <translation>gevolgd, s</translation>
    </message>
    <message>
        <source>Seconds after the push</source>
        <translation>Seconden na de duw</translation>
    </message>
    <message>
        <source>From the push on: falls in this time are counted.</source>
        <translation>Vanaf de duw: valpartijen in deze tijd tellen mee.</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modellen</translation>
    </message>
    <message>
        <source>as it is now</source>
        <translation>zoals het nu is</translation>
    </message>
    <message>
        <source>all scenarios</source>
        <translation>alle scenario’s</translation>
    </message>
    <message>
        <source>with</source>
        <translation>met</translation>
    </message>
    <message>
        <source>Parameters of the models</source>
        <translation>Parameters van de modellen</translation>
    </message>
    <message>
        <source>Parameters of the environment and their values, with blanks between them: environment.friction=0..0.1:5 environment.damping=0.04;0.08. Every value is combined with every other and with every scenario.</source>
        <translation>Parameters van de omgeving en hun waarden, met spaties ertussen: environment.friction=0..0.1:5 environment.damping=0.04;0.08. Elke waarde wordt gecombineerd met elke andere en met elk scenario.</translation>
    </message>
    <message>
        <source>environment.KEY=VALUES …</source>
        <translation>environment.KEY=VALUES …</translation>
    </message>
    <message>
        <source>Policy</source>
        <translation>Policy</translation>
    </message>
    <message>
        <source>starts a cell</source>
        <translation>starts per cel</translation>
    </message>
    <message>
        <source>Starts of every cell</source>
        <translation>Starts van elke cel</translation>
    </message>
    <message>
        <source>Trials of every push on every model. Trial 1 starts alike in every cell, and so on.</source>
        <translation>Proeven van elke duw op elk model. Proef 1 begint in elke cel gelijk, enzovoort.</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>seed</translation>
    </message>
    <message>
        <source>Seed of the starts</source>
        <translation>Seed van de starts</translation>
    </message>
    <message>
        <source>Starts, times of pushes and the policy&apos;s draws come from it.</source>
        <translation>Starts, tijdstippen van de duwen en de trekkingen van de policy komen eruit voort.</translation>
    </message>
    <message>
        <source>A second Q-function …</source>
        <translation>Tweede Q-functie …</translation>
    </message>
    <message>
        <source>Of the same environment; it is tried from the same starts on the same models.</source>
        <translation>Van dezelfde omgeving; ze wordt vanuit dezelfde starts op dezelfde modellen getest.</translation>
    </message>
    <message>
        <source>Without it</source>
        <translation>Zonder</translation>
    </message>
    <message>
        <source>Beside it</source>
        <translation>Ernaast</translation>
    </message>
    <message>
        <source>A second Q-function</source>
        <translation>Tweede Q-functie</translation>
    </message>
    <message>
        <source>Q-functions (*.safetensors *.surefoot);;All files (*)</source>
        <translation>Q-functies (*.safetensors *.surefoot);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>nothing: what this life has learned so far is tried alone</source>
        <translation>niets: alleen wat dit leven tot nu toe heeft geleerd, wordt getest</translation>
    </message>
</context>
<context>
    <name>surefoot::RobustnessMap</name>
    <message>
        <source>Falls over pushes and models</source>
        <translation>Valpartijen per duw en model</translation>
    </message>
    <message>
        <source>push, N s</source>
        <translation>duw, N s</translation>
    </message>
    <message>
        <source>%1, push %2 N s: </source>
        <translation>%1, duw %2 N s: </translation>
    </message>
    <message>
        <source>beside it: </source>
        <translation>ernaast: </translation>
    </message>
    <message>
        <source>; %1 succeeded</source>
        <translation>; %1 geslaagd</translation>
    </message>
    <message>
        <source>; %1 flew apart</source>
        <translation>; %1 uiteengevlogen</translation>
    </message>
    <message>
        <source>; the intervals have nothing in common</source>
        <translation>; de intervallen overlappen niet</translation>
    </message>
    <message>
        <source>How often it falls appears here: a column a push, a row a model.</source>
        <translation>Hier verschijnt hoe vaak hij valt: een kolom per duw, een rij per model.</translation>
    </message>
    <message>
        <source>0 %</source>
        <translation>0 %</translation>
    </message>
    <message>
        <source>100 % fell</source>
        <translation>100 % viel</translation>
    </message>
    <message>
        <source>100 % succeeded</source>
        <translation>100 % geslaagd</translation>
    </message>
    <message>
        <source>the 95 % intervals of the two have nothing in common</source>
        <translation>de 95%-intervallen van de twee overlappen niet</translation>
    </message>
    <message>
        <source>%1 of %2 fell, %3 % (95 %: %4 … %5 %)</source>
        <translation>%1 van %2 vielen, %3 % (95 %: %4 … %5 %)</translation>
    </message>
    <message>
        <source>%1 of %2 succeeded, %3 % (95 %: %4 … %5 %)</source>
        <translation>%1 van %2 slaagden, %3 % (95 %: %4 … %5 %)</translation>
    </message>
    <message>
        <source>%1 starts a cell</source>
        <translation>%1 starts per cel</translation>
    </message>
    <message>
        <source>, pushed at %1 s</source>
        <translation>, geduwd op %1 s</translation>
    </message>
    <message>
        <source>, pushed between %1 and %2 s</source>
        <translation>, geduwd tussen %1 en %2 s</translation>
    </message>
    <message>
        <source>, followed for %1 s</source>
        <translation>, %1 s gevolgd</translation>
    </message>
    <message>
        <source>, policy %1, seed %2</source>
        <translation>, policy %1, seed %2</translation>
    </message>
</context>
<context>
    <name>surefoot::RuleView</name>
    <message>
        <source>Sets TRL&apos;s threshold to the rule&apos;s number, rounded; Edit › Undo takes it back</source>
        <translation>Zet de drempel van TRL op het getal van de vuistregel, afgerond; Bewerken › Ongedaan maken neemt het terug</translation>
    </message>
    <message>
        <source>Set the threshold to %1</source>
        <translation>Zet de drempel op %1</translation>
    </message>
    <message>
        <source>TRL&apos;s threshold in force: %1.</source>
        <translation>Drempel van TRL nu: %1.</translation>
    </message>
    <message>
        <source>TRL&apos;s threshold is %1; it is not in force while the policy is %2.</source>
        <translation>De drempel van TRL is %1; hij geldt niet zolang de policy %2 is.</translation>
    </message>
    <message>
        <source>%1 = %2 = %3</source>
        <translation>%1 = %2 = %3</translation>
    </message>
    <message>
        <source>R: reward of the goal; n*: mean transitions of the successful episodes while it learned%1 (thesis, eq. %2).</source>
        <translation>R: beloning van het doel; n*: gemiddeld aantal overgangen van de geslaagde episodes tijdens het leren%1 (scriptie, verg. %2).</translation>
    </message>
    <message>
        <source>; R_t: reward of every step</source>
        <translation>; R_t: beloning van elke stap</translation>
    </message>
    <message>
        <source>There is no goal. R: the highest reward of a step so far; n*: transitions of a footstep%1. The thesis expects this to serve and did not test it (section 4.5).</source>
        <translation>Er is geen doel. R: de hoogste beloning van een stap tot nu toe; n*: overgangen van een voetstap%1. De scriptie verwacht dat dit werkt, maar heeft het niet getest (paragraaf 4.5).</translation>
    </message>
    <message>
        <source>This life began with something learned; the limits are told of lives that begin from nothing.</source>
        <translation>Dit leven begon met iets geleerds; de grenzen gelden voor levens die vanaf nul beginnen.</translation>
    </message>
    <message>
        <source>Lower limit %1, upper limit %2.</source>
        <translation>Ondergrens %1, bovengrens %2.</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>nog niet</translation>
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
        <translation>Hoe snel de wereld loopt zonder turbo: %1 tot %2 keer de echte tijd</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Taak</translation>
    </message>
    <message>
        <source>Changed model</source>
        <translation>Gewijzigd model</translation>
    </message>
    <message>
        <source>Learning rule</source>
        <translation>Leerregel</translation>
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
        <translation>Wat betekenen deze woorden?</translation>
    </message>
    <message>
        <source>What task, learning rule and policy mean</source>
        <translation>Wat taak, leerregel en policy betekenen</translation>
    </message>
    <message>
        <source>All words</source>
        <translation>Alle begrippen</translation>
    </message>
    <message>
        <source>Scenario of the model</source>
        <translation>Scenario van het model</translation>
    </message>
    <message>
        <source>episodes</source>
        <translation>episodes</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>vallen</translation>
    </message>
</context>
<context>
    <name>surefoot::RunningLife</name>
    <message>
        <source>Pause first; then a click on the map puts the body into that state.</source>
        <translation>Pauzeer eerst; daarna zet een klik op de kaart het lichaam in die toestand.</translation>
    </message>
    <message>
        <source>The life is complete; nothing goes on in it.</source>
        <translation>Het leven is voltooid; er gebeurt niets meer in.</translation>
    </message>
    <message>
        <source>A program moves this robot; it cannot be put back into a moment.</source>
        <translation>Een programma beweegt deze robot; hij kan niet terug naar een moment.</translation>
    </message>
</context>
<context>
    <name>surefoot::Scrubber</name>
    <message>
        <source>Play</source>
        <translation>Afspelen</translation>
    </message>
    <message>
        <source>Go on from here</source>
        <translation>Hier verder</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Terug naar live</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>The learner&apos;s world is put into this moment, and it goes on learning there</source>
        <translation>De wereld van de leerder komt in dit moment en leert daar verder</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
</context>
<context>
    <name>surefoot::SessionName</name>
    <message>
        <source>Session %1, not saved</source>
        <translation>Sessie %1, niet opgeslagen</translation>
    </message>
    <message>
        <source>Session %1</source>
        <translation>Sessie %1</translation>
    </message>
</context>
<context>
    <name>surefoot::ShareSlider</name>
    <message>
        <source>How much they explore, in 100 steps</source>
        <translation>Hoeveel ze exploreren, in 100 stappen</translation>
    </message>
    <message>
        <source>%1 of 100</source>
        <translation>%1 van 100</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nooit</translation>
    </message>
    <message>
        <source>every second step</source>
        <translation>elke tweede stap</translation>
    </message>
</context>
<context>
    <name>surefoot::SignalChooser</name>
    <message>
        <source>Search signals</source>
        <translation>Zoek signalen</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signalen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Omhoog</translation>
    </message>
    <message>
        <source>One place up (Ctrl+Up)</source>
        <translation>Een plaats omhoog (Ctrl+↑)</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Omlaag</translation>
    </message>
    <message>
        <source>One place down (Ctrl+Down)</source>
        <translation>Een plaats omlaag (Ctrl+↓)</translation>
    </message>
    <message>
        <source>With the one above</source>
        <translation>Met die erboven</translation>
    </message>
    <message>
        <source>In one strip with the signal above, or in a strip of its own (Ctrl+J)</source>
        <translation>In één strook met het signaal erboven, of in een eigen strook (Ctrl+J)</translation>
    </message>
    <message>
        <source>Usual ones</source>
        <translation>Standaard</translation>
    </message>
    <message>
        <source>What is shown at first</source>
        <translation>Wat eerst te zien is</translation>
    </message>
    <message>
        <source>%1, of the group %2</source>
        <translation>%1, van de groep %2</translation>
    </message>
</context>
<context>
    <name>surefoot::SignalsBar</name>
    <message>
        <source>Choose …</source>
        <translation>Kiezen …</translation>
    </message>
    <message>
        <source>Which signals are shown, and in which order</source>
        <translation>Welke signalen te zien zijn, en in welke volgorde</translation>
    </message>
    <message>
        <source>Roll out 25 s</source>
        <translation>Rollout 25 s</translation>
    </message>
    <message>
        <source>What the greedy policy does in 25 s from a new start, learning nothing</source>
        <translation>Wat de greedy policy in 25 s doet vanaf een nieuw begin, zonder te leren</translation>
    </message>
    <message>
        <source>Second Q</source>
        <translation>Tweede Q</translation>
    </message>
    <message>
        <source>Another Q-function beside this one, from the same start with the same pushes</source>
        <translation>Een andere Q-functie naast deze, vanaf hetzelfde begin met dezelfde duwen</translation>
    </message>
    <message>
        <source>Film …</source>
        <translation>Film …</translation>
    </message>
    <message>
        <source>A film of the replay, or of the last minutes</source>
        <translation>Een film van de herhaling, of van de laatste minuten</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>The signals that are shown, as a picture or as numbers</source>
        <translation>De getoonde signalen, als afbeelding of als getallen</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signalen</translation>
    </message>
    <message>
        <source>What can be done with the signals</source>
        <translation>Wat met de signalen kan</translation>
    </message>
    <message>
        <source>Second: %1</source>
        <translation>Tweede: %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
    <message>
        <source>%1, the last %2 s</source>
        <translation>%1, de laatste %2 s</translation>
    </message>
    <message>
        <source>%1 s, </source>
        <translation>%1 s, </translation>
    </message>
    <message>
        <source>no fall</source>
        <translation>geen val</translation>
    </message>
    <message>
        <source>, %1 m</source>
        <translation>, %1 m</translation>
    </message>
    <message>
        <source>From a &amp;file …</source>
        <translation>Uit een &amp;bestand …</translation>
    </message>
    <message>
        <source>What it knows &amp;now</source>
        <translation>Wat hij &amp;nu weet</translation>
    </message>
    <message>
        <source>A copy of the Q-function of this moment</source>
        <translation>Een kopie van de Q-functie van dit moment</translation>
    </message>
    <message>
        <source>What it &amp;began with</source>
        <translation>Waar hij &amp;mee begon</translation>
    </message>
    <message>
        <source>The Q-function of the file that this life began with</source>
        <translation>De Q-functie uit het bestand waarmee dit leven begon</translation>
    </message>
    <message>
        <source>what it began with</source>
        <translation>waar hij mee begon</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Geen</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>na %1</translation>
    </message>
    <message>
        <source>A Q-function beside this one</source>
        <translation>Een Q-functie naast deze</translation>
    </message>
    <message>
        <source>Q-functions (*.safetensors)</source>
        <translation>Q-functies (*.safetensors)</translation>
    </message>
    <message>
        <source>%1 was learned in %2; it cannot stand beside a Q-function of %3.</source>
        <translation>%1 is in %2 geleerd; dat kan niet naast een Q-functie van %3 staan.</translation>
    </message>
    <message>
        <source>As %1 …</source>
        <translation>Als %1 …</translation>
    </message>
    <message>
        <source>&amp;Choose signals …</source>
        <translation>Signalen &amp;kiezen …</translation>
    </message>
    <message>
        <source>&amp;Roll out 25 s</source>
        <translation>&amp;Rollout 25 s</translation>
    </message>
    <message>
        <source>&amp;Second Q-function</source>
        <translation>&amp;Tweede Q-functie</translation>
    </message>
    <message>
        <source>&amp;Film …</source>
        <translation>&amp;Film …</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exporteren</translation>
    </message>
</context>
<context>
    <name>surefoot::SignalsShown</name>
    <message>
        <source>First: %1</source>
        <translation>Eerste: %1</translation>
    </message>
    <message>
        <source>Second: %1</source>
        <translation>Tweede: %1</translation>
    </message>
    <message>
        <source>What is learned here</source>
        <translation>Wat hier wordt geleerd</translation>
    </message>
</context>
<context>
    <name>surefoot::StateTable</name>
    <message>
        <source>State</source>
        <translation>Toestand</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variabele</translation>
    </message>
    <message>
        <source>observed</source>
        <translation>gezien</translation>
    </message>
    <message>
        <source>how often</source>
        <translation>hoe vaak</translation>
    </message>
    <message>
        <source>tile</source>
        <translation>tegel</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>ACTIONS</source>
        <translation>ACTIES</translation>
    </message>
    <message>
        <source>ENDINGS</source>
        <translation>EINDES</translation>
    </message>
    <message>
        <source>%1 steps, %2 s at most</source>
        <translation>hoogstens %1 stappen, %2 s</translation>
    </message>
    <message>
        <source>  ×%1</source>
        <translation>  ×%1</translation>
    </message>
    <message>
        <source>%1: range %2 … %3 in the file, %4 tiles</source>
        <translation>%1: bereik %2 … %3 in het bestand, %4 tegels</translation>
    </message>
    <message>
        <source>; a click on the numbers writes %1 … %2</source>
        <translation>; een klik op de getallen schrijft %1 … %2</translation>
    </message>
</context>
<context>
    <name>surefoot::StatusLine</name>
    <message>
        <source>State of the life</source>
        <translation>Status van het leven</translation>
    </message>
    <message>
        <source>%1 min simulated</source>
        <translation>%1 min gesimuleerd</translation>
    </message>
    <message>
        <source>%1 M steps/s</source>
        <translation>%1 M stappen/s</translation>
    </message>
    <message>
        <source>%1 steps/s</source>
        <translation>%1 stappen/s</translation>
    </message>
    <message>
        <source>n* %1 → rule-of-thumb threshold %2</source>
        <translation>n* %1 → drempel volgens vuistregel %2</translation>
    </message>
    <message>
        <source>rule-of-thumb threshold: not defined here</source>
        <translation>drempel volgens vuistregel: hier niet gedefinieerd</translation>
    </message>
    <message>
        <source>table %1 % full</source>
        <translation>tabel %1 % vol</translation>
    </message>
    <message>
        <source>the guardian acted in %1 % of the steps</source>
        <translation>de bewaker handelde in %1 % van de stappen</translation>
    </message>
    <message>
        <source>a fall costs %1 more</source>
        <translation>een val kost %1 extra</translation>
    </message>
    <message numerus="yes">
        <source>%1 falls taken back</source>
        <translation>
            <numerusform>%1 val teruggedraaid</numerusform>
            <numerusform>%1 valpartijen teruggedraaid</numerusform>
        </translation>
    </message>
    <message>
        <source>risk holds: %1 % said, %2 % fell</source>
        <translation>risico klopt: %1 % voorspeld, %2 % viel</translation>
    </message>
    <message>
        <source>risk errs: %1 % said, %2 % fell</source>
        <translation>risico klopt niet: %1 % voorspeld, %2 % viel</translation>
    </message>
    <message>
        <source>risk unclear: %1 % said, %2 % fell</source>
        <translation>risico onduidelijk: %1 % voorspeld, %2 % viel</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>seed %1</translation>
    </message>
    <message>
        <source>began %1</source>
        <translation>begin: %1</translation>
    </message>
    <message>
        <source>learning ended at episode %1</source>
        <translation>leren eindigde bij episode %1</translation>
    </message>
    <message>
        <source>walks since minute %1</source>
        <translation>loopt sinds minuut %1</translation>
    </message>
    <message numerus="yes">
        <source>the robot flew apart %1 times</source>
        <translation>
            <numerusform>de robot is één keer uiteengevlogen</numerusform>
            <numerusform>de robot is %1 keer uiteengevlogen</numerusform>
        </translation>
    </message>
    <message>
        <source>the life is complete</source>
        <translation>het leven is voltooid</translation>
    </message>
    <message>
        <source>followed</source>
        <translation>gevolgd</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>gepauzeerd</translation>
    </message>
</context>
<context>
    <name>surefoot::StepView</name>
    <message>
        <source>In turbo thousands of steps pass between two pictures. Turn it off to follow a single one.</source>
        <translation>Met turbo gaan er duizenden stappen voorbij tussen twee beelden. Zet turbo uit om er één te volgen.</translation>
    </message>
    <message>
        <source>What the last step taught appears here. Press “.” for a single step.</source>
        <translation>Hier verschijnt wat van de laatste stap is geleerd. Druk op “.” voor één stap.</translation>
    </message>
    <message>
        <source>In S = (%1) it chose A = %2.</source>
        <translation>In S = (%1) koos hij A = %2.</translation>
    </message>
    <message>
        <source>δ = R + γ %1(S′, A′) − %1(S, A) = %2 + %3 − %4 = %5</source>
        <translation>δ = R + γ %1(S′, A′) − %1(S, A) = %2 + %3 − %4 = %5</translation>
    </message>
    <message>
        <source>Just as expected: %1 stays as it is.</source>
        <translation>Precies zoals verwacht: %1 blijft gelijk.</translation>
    </message>
    <message>
        <source>Better than expected: %1(S, A) goes up by α δ = %2, to %3.</source>
        <translation>Beter dan verwacht: %1(S, A) stijgt met α δ = %2, naar %3.</translation>
    </message>
    <message>
        <source>Worse than expected: %1(S, A) goes down by %2, to %3.</source>
        <translation>Slechter dan verwacht: %1(S, A) daalt met %2, naar %3.</translation>
    </message>
    <message>
        <source>The trace carries the surprise back along the way: each step before gets %1 of it (γ λ = %2 · %3).</source>
        <translation>De trace voert de verrassing terug langs de weg: elke stap daarvoor krijgt er %1 van (γ λ = %2 · %3).</translation>
    </message>
    <message>
        <source>λ is 0: no step before learns from it.</source>
        <translation>λ is 0: geen eerdere stap leert ervan.</translation>
    </message>
</context>
<context>
    <name>surefoot::StrideTable</name>
    <message>
        <source>Begins s</source>
        <translation>Begint s</translation>
    </message>
    <message>
        <source>Length m</source>
        <translation>Lengte m</translation>
    </message>
    <message>
        <source>Duration s</source>
        <translation>Duur s</translation>
    </message>
    <message>
        <source>Speed m/s</source>
        <translation>Snelh. m/s</translation>
    </message>
    <message>
        <source>Energy J</source>
        <translation>Energie J</translation>
    </message>
    <message>
        <source>Energy a metre J/m</source>
        <translation>Energie per m J/m</translation>
    </message>
    <message>
        <source>Both feet down %</source>
        <translation>Beide voeten %</translation>
    </message>
    <message>
        <source>Stride</source>
        <translation>Schrede</translation>
    </message>
    <message>
        <source>Strides</source>
        <translation>Schreden</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>second %1</source>
        <translation>tweede %1</translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation>gem. van %1</translation>
    </message>
    <message>
        <source>first, mean of %1</source>
        <translation>eerste, gem. van %1</translation>
    </message>
    <message>
        <source>second, mean of %1</source>
        <translation>tweede, gem. van %1</translation>
    </message>
    <message>
        <source>Strides appear here: from one touch-down of the left foot to the next.</source>
        <translation>Hier verschijnen schreden: van het ene neerkomen van de linkervoet tot het volgende.</translation>
    </message>
    <message>
        <source>This robot has no left and right foot whose strides could be told.</source>
        <translation>Deze robot heeft geen linker- en rechtervoet om schreden van te bepalen.</translation>
    </message>
</context>
<context>
    <name>surefoot::StripCharts</name>
    <message>
        <source>Signals</source>
        <translation>Signalen</translation>
    </message>
    <message>
        <source>No signal is chosen.</source>
        <translation>Er is geen signaal gekozen.</translation>
    </message>
    <message>
        <source>Signals appear here while the world goes on, in a replay of a fall, and in a roll-out.</source>
        <translation>Signalen verschijnen hier terwijl de wereld loopt, in de herhaling van een val, en in een rollout.</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 %2 %3</translation>
    </message>
    <message>
        <source>At %1 seconds: %2.</source>
        <translation>Na %1 seconden: %2.</translation>
    </message>
    <message>
        <source>The whole time</source>
        <translation>Hele tijdsduur</translation>
    </message>
    <message>
        <source>The usual signals</source>
        <translation>De standaardsignalen</translation>
    </message>
</context>
<context>
    <name>surefoot::TaskBox</name>
    <message>
        <source>Task</source>
        <translation>Opdracht</translation>
    </message>
    <message>
        <source>✓ Done.</source>
        <translation>✓ Gedaan.</translation>
    </message>
    <message>
        <source>○ Not done yet; it ticks itself.</source>
        <translation>○ Nog niet gedaan; wordt vanzelf afgevinkt.</translation>
    </message>
    <message>
        <source>✓ And with %1.</source>
        <translation>✓ En met %1.</translation>
    </message>
    <message>
        <source>Extra: can you do it with %1?</source>
        <translation>Extra: lukt het je met %1?</translation>
    </message>
</context>
<context>
    <name>surefoot::TeacherWindow</name>
    <message>
        <source>as the interval says</source>
        <translation>wat het interval zegt</translation>
    </message>
    <message>
        <source>start again</source>
        <translation>opnieuw beginnen</translation>
    </message>
    <message>
        <source>a new life with what it has learned</source>
        <translation>een nieuw leven met wat hij heeft geleerd</translation>
    </message>
    <message>
        <source>let it run</source>
        <translation>laat lopen</translation>
    </message>
    <message>
        <source>push it</source>
        <translation>duw hem</translation>
    </message>
    <message>
        <source>put it somewhere</source>
        <translation>zet hem ergens neer</translation>
    </message>
    <message>
        <source>Teacher: %1</source>
        <translation>Docent: %1</translation>
    </message>
    <message>
        <source>Answers of the class</source>
        <translation>Antwoorden van de klas</translation>
    </message>
    <message>
        <source>No class: answers of a class come in here (Lessons › Class …).</source>
        <translation>Geen klas: hier komen de antwoorden van een klas binnen (Lessen › Klas …).</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Stap %1 van %2: %3</translation>
    </message>
    <message>
        <source>Answer: %1</source>
        <translation>Antwoord: %1</translation>
    </message>
    <message>
        <source>Hint: %1</source>
        <translation>Hint: %1</translation>
    </message>
    <message>
        <source>Next: %1 (%2)</source>
        <translation>Volgende: %1 (%2)</translation>
    </message>
    <message>
        <source>This is the last step.</source>
        <translation>Dit is de laatste stap.</translation>
    </message>
    <message>
        <source>Ask: %1</source>
        <translation>Vraag: %1</translation>
    </message>
    <message>
        <source> of about %1</source>
        <translation> van ongeveer %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>ongeveer %1</translation>
    </message>
    <message>
        <source>%1%2</source>
        <translation>%1%2</translation>
    </message>
    <message>
        <source>The class&apos;s folder is gone: %1</source>
        <translation>De map van de klas is weg: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n students, %1</source>
        <translation>
            <numerusform>%n student, %1</numerusform>
            <numerusform>%n studenten, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 have answered. %2</source>
        <translation>%1 hebben geantwoord. %2</translation>
    </message>
</context>
<context>
    <name>surefoot::ValueMaps</name>
    <message>
        <source>, never visited</source>
        <translation>, nooit bezocht</translation>
    </message>
    <message>
        <source>,  risk %1 %</source>
        <translation>,  risico %1 %</translation>
    </message>
    <message>
        <source>%1:  Q %2 for %3%5,  %4 visits</source>
        <translation>%1:  Q %2 voor %3%5,  %4 bezoeken</translation>
    </message>
    <message>
        <source>%1, under caution</source>
        <translation>%1, uit voorzichtigheid</translation>
    </message>
    <message>
        <source>outlined: the %1 tiles of this state</source>
        <translation>omlijnd: de %1 tegels van deze toestand</translation>
    </message>
    <message>
        <source>no step yet</source>
        <translation>nog geen stap</translation>
    </message>
    <message>
        <source>Greedy action</source>
        <translation>Greedy actie</translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risico</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Bezoeken</translation>
    </message>
    <message>
        <source>Eligibility</source>
        <translation>Eligibility</translation>
    </message>
    <message>
        <source>The map appears with the first steps.</source>
        <translation>De kaart verschijnt met de eerste stappen.</translation>
    </message>
    <message>
        <source>contour: threshold %1</source>
        <translation>contour: drempel %1</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>drempel %1</translation>
    </message>
    <message>
        <source>all values below threshold %1</source>
        <translation>alle waarden onder drempel %1</translation>
    </message>
    <message>
        <source>all below %1</source>
        <translation>alle onder %1</translation>
    </message>
    <message>
        <source>all values above threshold %1</source>
        <translation>alle waarden boven drempel %1</translation>
    </message>
    <message>
        <source>all above %1</source>
        <translation>alle boven %1</translation>
    </message>
    <message>
        <source>contour: risk %1</source>
        <translation>contour: risico %1</translation>
    </message>
    <message>
        <source>risk %1</source>
        <translation>risico %1</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>doel</translation>
    </message>
    <message>
        <source>gains</source>
        <translation>winst</translation>
    </message>
    <message>
        <source>fall</source>
        <translation>val</translation>
    </message>
    <message>
        <source>losses</source>
        <translation>verlies</translation>
    </message>
</context>
<context>
    <name>surefoot::ViewMenu</name>
    <message>
        <source>Copy the picture</source>
        <translation>Afbeelding kopiëren</translation>
    </message>
    <message>
        <source>Copy the numbers</source>
        <translation>Getallen kopiëren</translation>
    </message>
    <message>
        <source>Export as %1 …</source>
        <translation>Exporteren als %1 …</translation>
    </message>
    <message>
        <source>The picture is in the clipboard.</source>
        <translation>De afbeelding staat op het klembord.</translation>
    </message>
    <message>
        <source>The numbers are in the clipboard, as CSV.</source>
        <translation>De getallen staan op het klembord, als CSV.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Weergave</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 exporteren</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 is geschreven.</translation>
    </message>
</context>
<context>
    <name>surefoot::WordsBox</name>
    <message>
        <source>Your own words</source>
        <translation>Je eigen woorden</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Bewaren</translation>
    </message>
    <message>
        <source>One answer</source>
        <translation>Eén antwoord</translation>
    </message>
    <message>
        <source>Mine says the same</source>
        <translation>Het mijne zegt hetzelfde</translation>
    </message>
    <message>
        <source>kept as it is; the program does not mark it</source>
        <translation>blijft zoals het is; het programma kijkt het niet na</translation>
    </message>
</context>
<context>
    <name>surefoot::WordsDialog</name>
    <message>
        <source>Words</source>
        <translation>Begrippen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Zoeken</translation>
    </message>
    <message>
        <source>Search the words</source>
        <translation>Zoek in de begrippen</translation>
    </message>
    <message>
        <source>No word has this in it.</source>
        <translation>In geen begrip komt dit voor.</translation>
    </message>
    <message>
        <source>Source: %1.</source>
        <translation>Bron: %1.</translation>
    </message>
</context>
<context>
    <name>surefoot::WorldView</name>
    <message>
        <source>World</source>
        <translation>Wereld</translation>
    </message>
    <message>
        <source>taken at random</source>
        <translation>willekeurig gekozen</translation>
    </message>
    <message>
        <source>taken as the best</source>
        <translation>als beste gekozen</translation>
    </message>
</context>
</TS>
