// SPDX-License-Identifier: GPL-3.0-or-later
// Q-functions on disk. The tensors of an estimate are NAME.weights [features …, actions], NAME.visits [features …] and,
// for hashed tiles, NAME.tiles; NAME is q, or positive and negative. The description (TensorFile::about) says what the
// numbers mean: the state variables, the actions, the layout of the features, the whole configuration, and where it was
// learned.
#pragma once

#include "core/experiment/configuration.h"
#include "core/files/tensor_file.h"

namespace surefoot {

/// The Q-function that `life` has learned. `configuration` is its current one.
TensorFile qFileOf(const Life& life, const Configuration& configuration);

/// The same for any agent; `origin` replaces the facts about a life.
TensorFile qFileOf(Agent& agent, const Task& task, const Configuration& configuration, const Json& origin);

/// Reads a Q-function, or a checkpoint as one. Its configuration is checked, its tables are read when an agent is made.
Result<std::shared_ptr<const TensorFile>> readQFile(const std::string& path);
/// The same for a file in memory.
Result<std::shared_ptr<const TensorFile>> checkedQFile(TensorFile file);
/// Adds a checksum of the tensors to the description; to change tensors by hand, remove it.
void seal(TensorFile& file);
/// The reader's checks, for a file that was parsed already.
Status checkKind(const TensorFile& file, const std::vector<std::string>& kinds);

/// A hash of its values, 64 bits in hexadecimal. It does not depend on the file's name, place or history.
std::string contentOf(const TensorFile& file);

/// Where a Q-function comes from, in a sentence: "From walk.safetensors, content 3f2a…, after 7,000 steps …".
std::string originOf(const TensorFile& file, const std::string& path);

/// A hash of the whole file, as old journals have it.
std::string wholeHashOf(const TensorFile& file);

/// Makes every life begin with the Q-function in the file. The configuration notes the file's name, without folders,
/// and content.
void beginWith(Configuration& configuration, std::shared_ptr<const TensorFile> file);

/// What a person should know if lives learn the risk of a fall and begin with a file that knows nothing of it; else
/// nothing.
std::string riskNote(const TensorFile& file, const Configuration& configuration);

/// A file's entry about the file it began with, without the folders that older files have there.
Json withoutFolders(Json began);

/// The configuration under which a file was learned.
Result<Configuration> configurationOf(const Registry& registry, const TensorFile& file);

}  // namespace surefoot
