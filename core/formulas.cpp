// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formulas.h"

#include <array>
#include <utility>

namespace surefoot {

namespace {

/// How a key ends, and its formula; the first that fits.
using Line = std::pair<std::string_view, std::string_view>;

constexpr std::array kLearning = {
    Line{"policy.epsilon", "π(a) = (1 − ε)·[a is greedy] + ε/n"},
    Line{"policy.temperature", "π(a) = exp(Q(s, a)/τ) / Σ_b exp(Q(s, b)/τ)"},
    Line{"policy.omega", "π(a) = exp(β·Q(s, a))/Σ_b exp(β·Q(s, b)), β so that Σ π·Q = ln(Σ_b exp(ω·Q(s, b))/n)/ω"},
    Line{"policy.threshold", "A⁺ = {a: Q(s, a) > threshold}; exploring steps pick from A⁺"},
    Line{"policy.below", "π(a outside A⁺) = ε·p/(n − |A⁺|), p the share below"},
    Line{"policy.risk", "weight: π on Q − w·ρ; filter: among {a: ρ(s, a) ≤ limit}; losses: π on Q⁺ + k·Q⁻"},
    Line{"policy.risk_weight", "π on Q(s, a) − w·ρ(s, a)"},
    Line{"policy.risk_limit", "π among {a: ρ(s, a) ≤ limit}; where there is none, among the least risky"},
    Line{"policy.losses_factor", "π on Q⁺(s, a) + k·Q⁻(s, a)"},
    Line{"policy.guardian", "it acts from ρ(s, a) > limit until ρ(s, a) ≤ limit/2, a drawn by the policy"},
    Line{"policy.guardian_limit", "ρ(s, a) > limit"},
    Line{"agent.budget", "r ← r − Λ·[fall]; Λ ← max(0, Λ + η·(falls − d)) after every episode"},
    Line{"agent.falls_budget", "Λ ← max(0, Λ + η·(falls − d)) after every episode"},
    Line{"agent.budget_rate", "Λ ← max(0, Λ + η·(falls − d)) after every episode"},
    Line{"risk.learn", "ρ ← ρ + α·(target − ρ); target: 1 after a fall, 0 after another end, else γ·ρ(s′, a′)"},
    Line{"risk.discount", "ρ = Pr(fall), a fall k steps later counting γᵏ"},
    Line{"life.rewind", "after a fall s ← s of N steps before, and a new action there"},
    Line{"life.rewinds", "an episode ends with the fall after so many that were taken back"},
    Line{"_schedule", "linear: v = start + (end − start)·min(t/T, 1); exponential: v = end + (start − end)·2^(−t/T)"},
    Line{"_end", "v → end as t grows: v = end for t ≥ T (linear), half as far at every T (exponential)"},
    Line{"_over", "T in v = start + (end − start)·min(t/T, 1) and v = end + (start − end)·2^(−t/T)"},
    Line{"_per", "t = episodes or steps of the life so far"},
    Line{"shaping.discount", "F = γ·V(s′) − V(s) is added to the reward"},
    Line{"shaping.step_size", "V(s) ← V(s) + α·(r + γ·V(s′) − V(s))"},
    Line{"shaping.rewards", "r ← r + γ·V(s′) − V(s)"},
    Line{".step_size", "w ← w + α/n·δ·z for every weight w with trace z, n tilings"},
    Line{".asymmetry", "δ ← (1 + κ)·δ if δ < 0, else (1 − κ)·δ"},
    Line{".trace_decay", "z ← γ·λ·z after every step"},
    Line{".trace_cutoff", "z < cut-off: z ← 0"},
    Line{".trace_other_actions", "clear: z(s, b) ← 0 for all b ≠ a"},
    Line{".trace", "replacing: z(s, a) ← 1; accumulating: z(s, a) ← γ·λ·z(s, a) + 1"},
    Line{".discount", "G = r₁ + γ·r₂ + γ²·r₃ + …"},
    Line{"split.by", "terms: r⁺ = Σ of terms above 0; sum: r⁺ = max(r, 0), r⁻ = min(r, 0)"}};

constexpr std::array kRepresentation = {
    Line{"risk.initial", "ρ(s, a) = initial where nothing is known"},
    Line{".tilings", "Q(s, a) = Σ of n weights, one of each tiling; tiling i is displaced by i/n of a tile and more"},
    Line{".scale", "tile width = span/(resolution·scale)"},
    Line{".width", "σ of a Gaussian = width·its own σ"},
    Line{".memory", "slot = hash(tile) mod memory"},
    Line{".initial_low", "w = U[low, high]/n at the start, so that Q lies between low and high"},
    Line{".initial_high", "w = U[low, high]/n at the start, so that Q lies between low and high"},
    Line{"_width", "x_i = exp(−(s − c_i)²/(2σ²)), divided by Σ_i x_i"},
    Line{"_from", "Q(s, a) = 0 where s < from or s > to"},
    Line{"_to", "Q(s, a) = 0 where s < from or s > to"},
    Line{"_voltage", "tile width = 1/(resolution·scale)"},
    Line{".wheel_span", "tile width of the wheel rate = wheel span/(resolution·scale)"},
    Line{".voltage", "U = −U_max … U_max, in equal steps"},
    Line{".levels", "actions = levels³, each of three voltages U_i = U_max·(2i/(levels − 1) − 1)"},
    Line{"", "tile width, or spacing of centres = span/(resolution·scale)"}};

constexpr std::array kRewards = {Line{".goal_reward", "r = goal when it is reached, which ends the episode"},
                                 Line{".fall_reward", "r = fall when it falls, which ends the episode"},
                                 Line{".time_reward", "r ← r + time at every step"},
                                 Line{".footstep_reward", "r ← r + footstep·Δx, Δx the metres gained [m]"},
                                 Line{".energy_reward", "r ← r + energy·E, E = Σ max(0, U·I)·Δt of hips and knees"}};

constexpr std::array kModel = {Line{".torque_scale", "T = scale·T(a)"},
                               Line{".torque_constant", "torque = η·k·G·I, I = (U − k·G·ω)/R"},
                               Line{".torque", "T(a) = −T, 0, +T"},
                               Line{".damping", "T_wheel = T(a) − c·β̇"},
                               Line{".dry_friction", "torque = −F·sign(ω)"},
                               Line{".contact_friction", "tangential force ≤ grip·normal force"},
                               Line{".friction", "T_hinge = −μ·sign(α̇)"},
                               Line{".pole_length", "I = m·l²/12, centre of mass at l/2"},
                               Line{".pole_mass", "I = m·l²/12 about its centre of mass"},
                               Line{".base_mass", "F = m·a of the cart, its wheel besides"},
                               Line{".start_angle", "α₀ = U[−A, A], α̇₀ = 0"},
                               Line{".substeps", "Δt = time of a step/substeps"},
                               Line{".wheel_radius", "ẋ = r·β̇"},
                               Line{".wheel_mass", "I = m·r²/2"},
                               Line{".fall_angle", "|α| ≥ fall angle: fallen"},
                               Line{".balanced_angle", "|α| ≤ angle and |α̇| ≤ rate: balanced"},
                               Line{".balanced_rate", "|α| ≤ angle and |α̇| ≤ rate: balanced"},
                               Line{".max_steps", "t = limit: the episode is cut off, and Q(s′, ·) still counts"},
                               Line{".test_every", "a test after the episodes k, 2k, 3k, …"},
                               Line{".slope", "g = (g·sin slope, −g·cos slope)"},
                               Line{".gravity", "F = m·g"},
                               Line{".solid_from", "swing − stance ≥ angle: the foot meets the floor"},
                               Line{".start_noise", "start = usual start·(1 + noise·U[−1, 1])"},
                               Line{".start_stance", "stance angle(0) = this·(1 ± noise)"},
                               Line{".start_swing", "swing angle(0) = this·(1 ± noise)"},
                               Line{".start_rate", "stance rate(0) = this·(1 ± noise)"},
                               Line{".resistance", "I = (U − k·G·ω)/R"},
                               Line{".gear_ratio", "torque = η·k·G·I, I = (U − k·G·ω)/R"},
                               Line{".efficiency", "torque = η·k·G·I, I = (U − k·G·ω)/R"},
                               Line{".armature", "torque = J·dω/dt is taken by the rotor"},
                               Line{".stance_knee_gain", "U = gain·(0 − knee angle)"},
                               Line{".ankle_gain", "U = gain·(target − ankle angle)"},
                               Line{".ankle_target", "U = gain·(target − ankle angle)"},
                               Line{".hip_target", "hand-made: hip angle → target in every step"},
                               Line{".boom_force", "F_y = boom force at the boom point"},
                               Line{"_stop_stiffness", "torque = −stiffness·(angle beyond the stop)"},
                               Line{"_stop_damping", "torque = −damping·ω beyond the stop"},
                               Line{"_low", "low ≤ joint angle ≤ high"},
                               Line{"_high", "low ≤ joint angle ≤ high"},
                               Line{".fall_torso", "|torso| > this: doomed to fall"},
                               Line{".fall_stance_thigh", "|stance thigh| > this: doomed to fall"},
                               Line{".fall_stance", "|stance angle| > this: fallen"},
                               Line{".fall_swing", "|swing angle| > this: fallen"},
                               Line{".hip_mass", "half of it on each leg: F = m·a"},
                               Line{"_mass", "F = m·a"},
                               Line{"_inertia", "torque = I·dω/dt"},
                               Line{".leg_length", "height of the hip = l·cos(stance angle)"},
                               Line{"_radius", "a circle |p − centre| = r meets the floor"},
                               Line{"_x", "p = (x, y) in the body's frame"},
                               Line{"_y", "p = (x, y) in the body's frame"}};

template <std::size_t n>
std::string lookUp(const std::array<Line, n>& lines, std::string_view key) {
  for (const auto& [ending, formula] : lines)
    if (key.ends_with(ending)) return std::string(formula);
  return "";
}

}  // namespace

std::string formulaOf(const Parameter& p) {
  const std::string_view key = p.key;
  if (key.starts_with("split.") && key != "split.by") return "sign: r⁺ = max(r, 0), r⁻ = min(r, 0); both: r⁺ = r⁻ = r";
  if (key.starts_with("environment.start_") && p.title.starts_with("Start, ")) return "angle(0) = this, ω(0) = 0";
  if (p.group == Group::Rewards) return lookUp(kRewards, key);
  if (p.group == Group::Model) return lookUp(kModel, key);
  const std::string learning = p.group == Group::Representation ? "" : lookUp(kLearning, key);
  const bool representation = p.group == Group::Representation || p.group == Group::Risk;
  return learning.empty() && representation ? lookUp(kRepresentation, key) : learning;
}

}  // namespace surefoot
