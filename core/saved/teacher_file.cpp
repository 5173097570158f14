// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/saved/teacher_file.h"

#include <filesystem>

#include "core/saved/q_file.h"

namespace surefoot {

namespace {
constexpr const char* kKey = "policy.guardian";
constexpr const char* kTensor = "teacher";
}  // namespace

Result<std::shared_ptr<const TensorFile>> takeTeacher(std::vector<Assignment>& assignments, const std::string& folder) {
  std::shared_ptr<const TensorFile> teacher;
  for (Assignment& a : assignments) {
    if (a.key != kKey || !a.value.ends_with(".safetensors")) continue;
    const std::filesystem::path path(a.value);
    auto file = readQFile(path.is_absolute() ? a.value : (std::filesystem::path(folder) / path).string());
    if (!file) return file.error();
    teacher = std::move(*file);
    a.value = "q-function";
  }
  return teacher;
}

void packTeacher(TensorFile& life, const TensorFile& teacher) {
  TensorFile values{.name = teacher.name, .about = teacher.about, .tensors = {}};
  values.about["kind"] = "q-function";
  const Json estimates = teacher.about.value("estimates", Json::object());
  for (const Tensor& t : teacher.tensors)  // of a life's file the values alone
    if (estimates.contains(t.name.substr(0, t.name.find('.')))) values.tensors.push_back(t);
  seal(values);
  std::string bytes = values.write();
  const std::size_t size = bytes.size();
  life.tensors.push_back({.name = kTensor, .type = ElementType::U8, .shape = {size}, .bytes = std::move(bytes)});
}

Result<std::shared_ptr<const TensorFile>> teacherIn(const TensorFile& life) {
  const Tensor* packed = life.find(kTensor);
  if (!packed) return std::shared_ptr<const TensorFile>();
  auto file = TensorFile::parse(packed->bytes, life.name + ", its guardian's Q-function");
  if (!file) return file.error();
  return checkedQFile(std::move(*file));
}

}  // namespace surefoot
