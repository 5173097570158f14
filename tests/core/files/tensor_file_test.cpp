// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/tensor_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/files/archive.h"

namespace surefoot {

namespace {

TensorFile smallFile() {
  TensorFile file;
  file.about = {{"kind", "test"}};
  Archive out = Archive::writer(file);
  std::vector<double> weights = {1.5, -2.25, 1e-300, 0.0, 3.0, 4.0};
  std::vector<std::uint32_t> visits = {7, 8};
  std::vector<double> nothing;
  out.table("weights", weights, {2, 3});
  out.table("visits", visits, {2});
  out.list("nothing", nothing, 10);
  return file;
}

/// A file with any header, lying or not.
std::string fileWith(const std::string& header, const std::string& data, std::uint64_t length) {
  std::string bytes(8, '\0');
  std::memcpy(bytes.data(), &length, 8);
  return bytes + header + data;
}
std::string fileWith(const std::string& header, const std::string& data) {
  return fileWith(header, data, header.size());
}

constexpr const char* kMeta = R"("__metadata__":{"surefoot":"{}"})";

}  // namespace

TEST(TensorFile, WhatIsWrittenIsReadBitForBit) {
  const TensorFile file = smallFile();
  const std::string bytes = file.write();
  const auto read = TensorFile::parse(bytes, "f");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->about, file.about);
  ASSERT_EQ(read->tensors.size(), 3u);
  for (const Tensor& t : file.tensors) {
    const Tensor* same = read->find(t.name);
    ASSERT_TRUE(same) << t.name;
    EXPECT_EQ(same->bytes, t.bytes);
    EXPECT_EQ(same->shape, t.shape);
    EXPECT_EQ(same->type, t.type);
  }
  EXPECT_EQ(read->write().size(), bytes.size());
}

// The format by hand: https://github.com/huggingface/safetensors, "Format".
TEST(TensorFile, ReadsAFileWrittenByHand) {
  const double x = 2.5;
  std::string data(8, '\0');
  std::memcpy(data.data(), &x, 8);
  const auto file = TensorFile::parse(
      fileWith(std::string("{") + kMeta + R"(,"w":{"dtype":"F64","shape":[1,1],"data_offsets":[0,8]}})", data), "f");
  ASSERT_TRUE(file) << file.error().message;
  Archive in = Archive::reader(*file);
  std::vector<double> w(1);
  in.table("w", w, {1, 1});
  EXPECT_TRUE(in.good());
  EXPECT_EQ(w[0], 2.5);
}

TEST(TensorFile, AFileCutOffAnywhereIsRefused) {
  const std::string bytes = smallFile().write();
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_FALSE(TensorFile::parse(std::string_view(bytes).substr(0, length), "f")) << length;
  EXPECT_FALSE(TensorFile::parse(bytes + "x", "f")) << "and so is one with more behind it";
}

TEST(TensorFile, RefusesEveryLyingHeader) {
  const std::string data(16, '\0');
  const auto refused = [&](const std::string& entry, const std::string& word) {
    const auto file = TensorFile::parse(fileWith(std::string("{") + kMeta + "," + entry + "}", data), "f.st");
    ASSERT_FALSE(file) << entry;
    EXPECT_EQ(file.error().kind, ErrorKind::File);
    EXPECT_TRUE(file.error().message.starts_with("f.st: ")) << file.error().message;
    EXPECT_NE(file.error().message.find(word), std::string::npos) << file.error().message;
  };
  refused(R"("w":{"dtype":"F64","shape":[2],"data_offsets":[0,8]})", "\"w\" has 8 bytes");
  refused(R"("w":{"dtype":"F64","shape":[1],"data_offsets":[0,8]})", "8 bytes behind the last");
  refused(R"("w":{"dtype":"F64","shape":[2],"data_offsets":[8,24]})", "does not lie");
  refused(R"("w":{"dtype":"F64","shape":[2],"data_offsets":[16,0]})", "does not lie");
  refused(R"("w":{"dtype":"F64","shape":[2],"data_offsets":[-8,8]})", "is no tensor");
  refused(R"("w":{"dtype":"F64","shape":[2],"data_offsets":[0.5,8]})", "is no tensor");
  refused(R"("w":{"dtype":"F64","shape":[2],"data_offsets":[0,18446744073709551615]})", "\"w\"");
  refused(R"("w":{"dtype":"F64","shape":[4294967296,4294967296],"data_offsets":[0,16]})", "shape");
  refused(R"("w":{"dtype":"F64","shape":[-2],"data_offsets":[0,16]})", "shape");
  refused(R"("w":{"dtype":"F64","shape":["2"],"data_offsets":[0,16]})", "shape");
  refused(R"("w":{"dtype":"BF16","shape":[8],"data_offsets":[0,16]})", "BF16");
  refused(R"("w":{"dtype":64,"shape":[2],"data_offsets":[0,16]})", "is no tensor");
  refused(R"("w":{"shape":[2],"data_offsets":[0,16]})", "is no tensor");
  refused(R"("w":[1,2])", "is no tensor");
  refused(
      R"("a":{"dtype":"F64","shape":[1],"data_offsets":[0,8]},"b":{"dtype":"F64","shape":[2],"data_offsets":[0,16]})",
      "\"b\" does not lie");
}

TEST(TensorFile, RefusesHeadersThatAreNone) {
  for (const std::string& bytes :
       {fileWith("{}", ""), fileWith("[]", ""), fileWith("{\"__metadata__\":{}}", ""),
        fileWith("{\"__metadata__\":{\"surefoot\":1}}", ""), fileWith("{\"__metadata__\":{\"surefoot\":\"x\"}}", ""),
        fileWith("{\"__metadata__\":{\"surefoot\":\"[]\"}}", ""), fileWith("", ""), fileWith("{\"a\":", ""),
        fileWith(std::string("\xff\xfe{}"), ""), fileWith("{}", "", ~std::uint64_t{0}), fileWith("{}", "", 1u << 30),
        fileWith(std::string(100'000, '['), ""), std::string(100, '\0')})
    EXPECT_FALSE(TensorFile::parse(bytes, "f")) << bytes.substr(0, 60);
}

TEST(Archive, NamesTheTensorThatDoesNotFit) {
  const TensorFile file = smallFile();
  const auto message = [&](const std::function<void(Archive&)>& read) {
    Archive in = Archive::reader(file);
    read(in);
    return in.good() ? std::string() : in.status().error().message;
  };
  std::vector<double> w(6);
  std::vector<std::uint32_t> v(2);
  EXPECT_EQ(message([&](Archive& in) { in.table("weights", w, {2, 3}); }), "");
  EXPECT_NE(message([&](Archive& in) {
              in.table("weights", w, {3, 2});
            }).find("\"weights\" has another shape"),
            std::string::npos);
  EXPECT_NE(message([&](Archive& in) { in.table("bias", w, {2, 3}); }).find("\"bias\" is missing"), std::string::npos);
  EXPECT_NE(message([&](Archive& in) { in.table("weights", v, {2}); }).find("is of type F64, not U32"),
            std::string::npos);
  EXPECT_NE(message([&](Archive& in) { in.list("weights", w, 3); }).find("too long"), std::string::npos);
}

TEST(Archive, RefusesWeightsThatAreNoNumbers) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    TensorFile file;
    Archive out = Archive::writer(file);
    std::vector<double> w = {1.0, bad};
    out.table("w", w, {2});
    Archive in = Archive::reader(file);
    in.table("w", w, {2});
    EXPECT_FALSE(in.good());
  }
}

}  // namespace surefoot
