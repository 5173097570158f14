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
        <source>From the next start on. The handbook, the lessons and sentences about errors are English.</source>
        <translation>Vanaf de volgende start. Handboek, lessen en zinnen over fouten zijn Engels.</translation>
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
