// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "physics/robot/child/child_robot.h"

namespace surefoot {

namespace {

Point pointAt(const RobotSpec& spec, int index, std::span<const double> pose) {
  const FormulaPair& at = spec.points[static_cast<std::size_t>(index)].at;
  return {at[0](pose), at[1](pose)};
}

/// A robot without a picture: each state variable as a bar, with a mark where it is.
void drawBars(const Task& task, std::span<const double> state, Scene& scene) {
  scene.height = 0.25 * static_cast<double>(task.state.size() + 1);
  scene.width = 1.6;
  scene.metres = false;
  for (std::size_t s = 0; s < task.state.size(); ++s) {
    const StateVariable& v = task.state[s];
    const double y = 0.25 * static_cast<double>(task.state.size() - s), from = -0.35;
    const double share = std::clamp((state[s] - v.low) / (v.high - v.low), 0.0, 1.0);
    scene.shapes.push_back(Polyline{{{from, y}, {from + 1.0, y}}, Ink::Outline, 1.0, false});
    scene.shapes.push_back(Disc{{from + share, y}, 0.03, Fill::Solid, Ink::Solid, 1.0});
    scene.shapes.push_back(Label{.at = {from - 0.2, y}, .text = v.symbol, .halo = true});
  }
}

}  // namespace

std::vector<Signal> ChildRobot::signals() const {
  std::vector<Signal> all;
  const auto& sends = values_.spec().child.sends;
  for (std::size_t i = ChildSpec::kOwn; i < sends.size(); ++i) {
    std::string key = sends[i];
    std::replace(key.begin(), key.end(), '.', '_');
    all.push_back({.key = key, .title = sends[i], .group = "sent"});
  }
  return all;
}

void ChildRobot::readSignals(std::span<double> values) const {
  for (std::size_t i = ChildSpec::kOwn; i < numbers_.size(); ++i) values[i - ChildSpec::kOwn] = numbers_[i];
}

void ChildRobot::draw(std::span<const double> pose, Scene& scene) const {
  scene.clear();
  const RobotSpec& spec = values_.spec();
  const PictureSpec& picture = spec.picture;
  if (picture.lines.empty() && picture.labels.empty()) {
    const auto first = static_cast<std::size_t>(spec.names.placeOf(NameKind::State, 0));
    return drawBars(values_.task(), pose.subspan(first, spec.states.size()), scene);
  }
  scene.height = picture.height ? (*picture.height)(pose) : 1.0;
  scene.width = picture.width ? (*picture.width)(pose) : 0.0;
  scene.metres = picture.metres;
  if (picture.follow >= 0) scene.focus = {pointAt(spec, picture.follow, pose).x, 0.0};
  if (picture.tip >= 0) scene.tip = pointAt(spec, picture.tip, pose);
  for (const PictureLineSpec& line : picture.lines)
    scene.shapes.push_back(
        Polyline{{pointAt(spec, line.from, pose), pointAt(spec, line.to, pose)}, line.ink, line.width, line.dashed});
  for (const PictureLabelSpec& label : picture.labels)
    scene.shapes.push_back(Label{.at = pointAt(spec, label.at, pose), .text = label.text, .halo = true});
}

std::vector<ReadOut> ChildRobot::readOuts(std::span<const double> pose) const {
  std::vector<ReadOut> all;
  const auto first = static_cast<std::size_t>(values_.spec().names.placeOf(NameKind::State, 0));
  for (std::size_t s = 0; s < task().state.size(); ++s)
    all.push_back({task().state[s].symbol, task().state[s].unit, pose[first + s]});
  return all;
}

}  // namespace surefoot
