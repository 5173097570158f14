// SPDX-License-Identifier: GPL-3.0-or-later
// Q-functions on disk. The tensors of an estimate are NAME.weights [features …, actions], NAME.visits [features …] and,
// for hashed tiles, NAME.tiles; NAME is q, or positive and negative. The description (TensorFile::about) says what the
// numbers mean: the state variables, the actions, the layout of the features, the whole configuration, and where it was
// learned.
#pragma once

#include "core/experiment/configuration.h"
#include "core/files/tensor_file.h"

namespace surefoot {

/// What `life` has learned. `configuration` is the one that it runs under now.
TensorFile qFileOf(const Life& life, const Configuration& configuration);

/// The same for any agent, with `origin` in place of what a life tells.
TensorFile qFileOf(Agent& agent, const Task& task, const Configuration& configuration, const Json& origin);

/// Reads a Q-function, or a checkpoint as one. Its configuration is checked, its tables are read when an agent is made.
Result<std::shared_ptr<const TensorFile>> readQFile(const std::string& path);
/// Notes a checksum of the tensors in the description; whoever changes them by hand takes it out.
void seal(TensorFile& file);
/// What the reader checks of a file that was parsed already.
Status checkKind(const TensorFile& file, const std::vector<std::string>& kinds);

/// 64 bits over the values in it, in hexadecimal: the same however the file is called, wherever it lies and however it
/// came about.
std::string contentOf(const TensorFile& file);

/// The same over the whole file, as journals of earlier days note it.
std::string wholeHashOf(const TensorFile& file);

/// Every life will begin with what the file holds. What is noted of it are its name without folders, and its content.
void beginWith(Configuration& configuration, std::shared_ptr<const TensorFile> file);

/// What a file says it began with, without the folders that older files name.
Json withoutFolders(Json began);

/// The configuration that a file was learned under.
Result<Configuration> configurationOf(const Registry& registry, const TensorFile& file);

}  // namespace surefoot
