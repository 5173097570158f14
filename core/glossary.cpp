// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/glossary.h"

#include <algorithm>

namespace surefoot {

namespace {

std::vector<Word> policies() {
  return {{"greedy", "Greedy", "π(a) = 1/m for each of the m actions with Q(s, a) = max Q(s, ·), else 0",
           "Always takes an action that is worth most, so it never explores.", "Sutton & Barto 2018, section 2.2"},
          {"epsilon-greedy", "ε-greedy", "π(a) = (1 − ε)·greedy(a) + ε/n",
           "Mostly greedy; in a share ε of the steps it takes any of the n actions with equal chance. So it also takes "
           "those that make the robot fall.",
           "thesis, eq. 2.2; Sutton & Barto 2018, section 2.2"},
          {"softmax", "Softmax", "π(a) = exp(Q(s, a)/τ) / Σ_b exp(Q(s, b)/τ)",
           "The worse an action, the rarer it is taken. The temperature τ says how much worse counts: high, and all "
           "actions are nearly alike; low, and it is nearly greedy.",
           "thesis, eq. 2.3 and chapter 5; Sutton & Barto 2018, section 13.1"},
          {"mellowmax", "Mellowmax", "π(a) = exp(β·Q(s, a))/Σ_b exp(β·Q(s, b)); Σ_a π·Q = ln(Σ_a exp(ω·Q(s, a))/n)/ω",
           "A Softmax whose temperature 1/β fits each state: where actions differ much it is nearly greedy, where they "
           "hardly differ nearly even. One ω holds for all states.",
           "Asadi & Littman 2017, arXiv 1612.05628"},
          {"trl", "TRL",
           "π(a) = (1 − ε)·greedy(a) + ε·(1 − p)/|A⁺| in A⁺ = {a: Q(s, a) > threshold}, + ε·p/(n − |A⁺|) outside",
           "Threshold-restricted learning: ε-greedy whose exploring steps pick among the actions that are worth more "
           "than a threshold, and only in a small share p (“share below”) among the others. If no action or every "
           "action is above, it is ε-greedy.",
           "thesis, section 4.1, algorithm 1"}};
}

std::vector<Word> learningRules() {
  return {
      {"sarsa", "Sarsa", "δ = r + γ·Q(s′, a′) − Q(s, a);  w ← w + α/n·δ·z",
       "Learns the value of what it does, exploring included: a′ is the action that is taken next.",
       "thesis, eq. 2.4, 2.5 and 2.8; Sutton & Barto 2018, sections 6.4 and 12.7"},
      {"sarsa-2q", "Sarsa_2Q", "Q = Q⁺ + Q⁻;  δ⁺ = r⁺ + γ·Q⁺(s′, a′) − Q⁺(s, a);  δ⁻ = r⁻ + γ·Q⁻(s′, a′) − Q⁻(s, a)",
       "Two Sarsa learners: Q⁺ expects the gains, Q⁻ the losses, each with its own resolution, α and λ. Actions are "
       "chosen on the sum. A coarse Q⁻ generalises falls to states where none has happened yet.",
       "thesis, section 6.1.2, eq. 6.1 to 6.4"},
      {"q-learning", "Q-learning, Q(λ)", "δ = r + γ·max Q(s′, ·) − Q(s, a); after an action that is not greedy, z ← 0",
       "Learns the value of the greedy policy, whatever is done meanwhile (Watkins). So at a cliff it learns the "
       "edge, and falls while it explores.",
       "thesis, eq. 2.7; Sutton & Barto 2018, sections 6.5 and 12.10"},
      {"expected-sarsa", "Expected Sarsa", "δ = r + γ·Σ_b π(b|s′)·Q(s′, b) − Q(s, a)",
       "Sarsa with the mean over the policy in place of the one action that is drawn: the same values with less "
       "chance in them.",
       "Sutton & Barto 2018, section 6.6"},
      {"true-online-sarsa", "True online Sarsa(λ)",
       "z ← γλz + (1 − αγλ·zᵀx)x;  w ← w + α(δ + Q − Q_old)z − α(Q − Q_old)x",
       "Sarsa(λ) with dutch traces and a correction, so that after every step the weights are those of the forward "
       "view, which looks ahead at the returns.",
       "van Seijen et al. 2016, JMLR 17:145; Sutton & Barto 2018, section 12.8"},
      {"scripted", "Hand-made", "", "The environment's own controller. It does not learn.",
       "wcaarls/grl, addons/leosim"}};
}

std::vector<Word> representations() {
  return {
      {"tile-coder", "Tile coding", "Q(s, a) = Σ of n weights, one a tiling;  tile i = ⌊(x/width·n + i·(2d + 1))/n⌋",
       "n grids lie over each other, displaced. A state is in one tile of each; states that share tiles share what "
       "is learned.",
       "thesis, section 2.3; Sutton & Barto 2018, section 9.5.4"},
      {"radial-basis", "Radial basis functions", "x_i(s) = exp(−|s − c_i|²/(2σ²)) / Σ_j exp(−|s − c_j|²/(2σ²))",
       "Gaussians on a grid. Their width can be set apart from their spacing, which tiles cannot do.",
       "thesis, section 6.5; Sutton & Barto 2018, section 9.5.5"},
      {"table", "Table", "Q(s, a) has a weight of its own for every pair",
       "For worlds of few states: nothing is shared, nothing is generalised.", "Sutton & Barto 2018, chapter 6"}};
}

std::vector<Word> environments() {
  return {
      {"pendulum", "Pendulum", "balanced: |α| ≤ 0.005π, |α̇| ≤ 0.005π rad/s; fallen: |α| ≥ 0.45π",
       "A pole on a cart with a driven wheel. The state is its angle α, its rate α̇ and the wheel's rate β̇; an action "
       "is one of five torques, every 5 ms.",
       "thesis, section 3.1"},
      {"compass", "Compass walker", "r = footstep·length of the step [m]; fall, and the episode ends",
       "Two straight legs and a hip motor: the simplest thing that walks.", "ours"},
      {"leo", "LEO walker", "343 actions = 7³: three voltages of seven levels",
       "The Delft robot on two legs: ten state variables, motors with gears, feet with heel and toe. It is paid for "
       "metres, and pays for energy, time and falls.",
       "wcaarls/grl, addons/leosim"},
      {"cliff", "Cliff", "r = −1 a step, −100 and a fall over the edge",
       "A grid of 4 × 12 with a cliff along one side: Q-learning walks the edge, Sarsa the safe path.",
       "Sutton & Barto 2018, example 6.6; thesis, figure 2.1"},
      {"grid-world", "Grid world", "", "A grid of 10 × 10 with a bad region in the middle, which is a fall.",
       "thesis, figure 6.1"},
      {"chain", "Chain", "", "Ten states in a row, a fall at one end and the goal at the other.", "thesis, figure 4.2"},
      {"random-walk", "Random walk", "v(s) = (s − 10)/10 for the states s = 1 … 19",
       "Nineteen states in a row and one action: only values are learned, and they are known.",
       "Sutton & Barto 2018, example 7.1"},
      {"mountain-car", "Mountain car", "r = −1 a step until it is over the hill",
       "A car that is too weak for the slope has to swing. It cannot fall.", "Sutton & Barto 2018, example 10.1"}};
}

std::vector<Word> termsOfLearning() {
  return {{"", "Q(s, a), action value", "Q(s, a) = E[r₁ + γ·r₂ + γ²·r₃ + … | s, a]",
           "What is expected from action a in state s on: the sum of rewards, later ones worth less.",
           "thesis, section 2.1; Sutton & Barto 2018, section 3.5"},
          {"", "π, policy", "π(a|s), Σ_a π(a|s) = 1", "The chance of every action in a state.",
           "Sutton & Barto 2018, section 3.5"},
          {"", "δ, error", "δ = r + γ·Q(s′, a′) − Q(s, a)",
           "The surprise of a step: what came, and what is now expected, against what was expected.",
           "Sutton & Barto 2018, section 6.1"},
          {"", "z, trace (eligibility)", "z ← γ·λ·z; z ← 1 for what was just visited",
           "Which weights a surprise still reaches: those of the last steps, the older the less.",
           "thesis, section 2.2.2; Sutton & Barto 2018, section 12.1"},
          {"", "Threshold", "A⁺ = {a: Q(s, a) > threshold}",
           "TRL's limit: what is worth no more than this is hardly ever tried.", "thesis, section 4.1"},
          {"", "n*, transitions of a success", "n* = mean length of the successful episodes [steps]",
           "How many steps the learner takes to the goal. The rule of thumb is made from it.", "thesis, section 4.3"},
          {"", "Rule of thumb", "threshold = γ^n*·R_goal + Σ γ^k·R_time, k = 1 … n*",
           "A threshold from the length of an episode: what a pair is worth from which the goal is n* steps away.",
           "thesis, eq. 4.1 and 4.3"},
          {"", "Resolution", "tile width = span/(resolution·scale)",
           "Tiles per span of a variable. Few generalise far, many tell states apart.", "thesis, section 2.3"},
          {"", "Fall", "an episode that ends in a failure state",
           "What is to be avoided, while it learns as well: a fall can break the robot.", "thesis, chapter 1"}};
}

std::vector<Word> termsOfExperiments() {
  return {
      {"", "Step, episode, life, experiment", "step < episode < life < experiment",
       "A life is one learner with one seed; an episode goes from its start to its end, a step from action to action.",
       "Sutton & Barto 2018, section 3.3 (a life is their run)"},
      {"", "Average reward", "mean total reward of the last 80 episodes",
       "How well it does by now. 198 of 200 counts as converged.", "thesis, section 4.2.1"},
      {"", "End of learning", "first k ≥ 330 with |A(k) − A(k − 250)| < 0.015·R_goal and A(k) > 0.75·R_goal",
       "The episode from which on the average reward of all lives stands still. Falls are counted until then.",
       "thesis, section 4.2.1"},
      {"", "Pre-learning", "learn on a model until the average reward is R, then go on in reality",
       "What is learned in a simulation that is a little wrong is carried over to the robot.", "thesis, section 4.2"},
      {"", "Scenario", "damping c, friction μ, torque scaling",
       "How far the simulation is from the actual system: the rows of the thesis's table.", "thesis, table 4.1"},
      {"", "X, significant", "p < .01: of pairs, of Q-functions, or the analysis of variance of lives",
       "The difference to the reference is hardly chance.", "thesis, section 4.2.1; pairs and Q-functions: ours"},
      {"", "Turbo", "steps a second as many as the processor can",
       "Learns flat out; the world shows another one at its usual pace, with the newest values.", ""},
      {"", "Greedy test", "an episode under the greedy policy, which is not counted",
       "How a walker walks with what it has learned so far.", ""}};
}

}  // namespace

const std::vector<Word>& glossary() {
  static const std::vector<Word> words = [] {
    std::vector<Word> all;
    for (auto& part :
         {policies(), learningRules(), representations(), environments(), termsOfLearning(), termsOfExperiments()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return words;
}

const Word* wordOf(std::string_view name) {
  const auto& words = glossary();
  const auto found = std::find_if(words.begin(), words.end(), [&](const Word& w) { return w.name == name; });
  return name.empty() || found == words.end() ? nullptr : &*found;
}

bool mentions(const Word& word, std::string_view text) {
  const auto lower = [](std::string_view of) {
    std::string small(of);
    for (char& c : small)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return small;
  };
  const std::string wanted = lower(text);
  for (const std::string* part : {&word.name, &word.title, &word.formula, &word.text, &word.source})
    if (lower(*part).find(wanted) != std::string::npos) return true;
  return false;
}

}  // namespace surefoot
